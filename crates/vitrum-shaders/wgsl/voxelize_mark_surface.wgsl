struct type_7 {
member: array<u32>,
}
struct type_8 {
member: vec4<u32>,
member_1: vec4<u32>,
member_2: vec4<u32>,
member_3: vec4<u32>,
}
struct type_9 {
member: type_8,
}
struct type_12 {
member: vec3<i32>,
member_1: vec3<i32>,
member_2: vec3<i32>,
member_3: vec3<i32>,
member_4: vec3<i32>,
member_5: i32,
member_6: u32,
member_7: u32,
}
struct type_13 {
member: i32,
member_1: i32,
member_2: i32,
}
struct type_14 {
member: type_13,
member_1: type_12,
}
struct type_16 {
member: vec4<f32>,
member_1: vec4<f32>,
member_2: vec4<f32>,
member_3: vec4<f32>,
member_4: vec4<f32>,
}
struct type_19 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_9;
@group(0) @binding(3)
var<storage, read_write> global_2: type_19;
@group(0) @binding(1)
var<storage> global_3: type_7;
@group(0) @binding(2)
var<storage> global_4: type_7;
fn function_() {
var local: array<u32, 2>;
var local_1: array<u32, 2>;
var local_2: array<u32, 2>;
var local_3: array<u32, 2>;
var local_4: array<u32, 2>;
var local_5: array<u32, 2>;
var local_6: array<u32, 2>;
var local_7: array<u32, 2>;
var local_8: array<u32, 2>;
var local_9: array<u32, 2>;
var local_10: array<u32, 2>;
var local_11: array<u32, 2>;
var local_12: array<u32, 2>;
var local_13: array<u32, 2>;
var local_14: array<u32, 2>;
var local_15: array<u32, 2>;
var local_16: array<u32, 2>;
var local_17: array<u32, 2>;
var local_18: array<u32, 2>;
var local_19: array<u32, 2>;
var local_20: array<u32, 2>;
var local_21: array<u32, 2>;
var local_22: array<u32, 2>;
var local_23: array<u32, 2>;
var local_24: array<u32, 2>;
var local_25: array<u32, 2>;
var local_26: array<u32, 2>;
var local_27: array<u32, 2>;
var local_28: array<u32, 2>;
var local_29: array<u32, 2>;
var local_30: array<u32, 2>;
var local_31: array<u32, 2>;
var local_32: array<u32, 2>;
var local_33: array<u32, 2>;
var local_34: array<u32, 2>;
var local_35: array<u32, 2>;
var local_36: array<u32, 2>;
var local_37: array<u32, 2>;
var local_38: array<u32, 2>;
var local_39: array<u32, 2>;
var local_40: array<u32, 2>;
var local_41: array<u32, 2>;
var local_42: array<u32, 2>;
var local_43: array<u32, 2>;
var local_44: array<u32, 2>;
var local_45: array<u32, 2>;
var local_46: array<u32, 2>;
var local_47: array<u32, 2>;
var local_48: array<u32, 2>;
var local_49: array<u32, 2>;
var local_50: array<u32, 2>;
var local_51: array<u32, 2>;
var local_52: array<u32, 2>;
var local_53: array<u32, 2>;
var local_54: array<u32, 2>;
var local_55: array<u32, 2>;
var local_56: array<u32, 2>;
var local_57: array<u32, 2>;
var local_58: array<u32, 2>;
var local_59: array<u32, 2>;
var local_60: array<u32, 2>;
var local_61: array<u32, 2>;
var local_62: array<u32, 2>;
var local_63: array<u32, 2>;
var local_64: array<u32, 2>;
var local_65: array<u32, 2>;
var local_66: array<u32, 2>;
var local_67: array<u32, 2>;
var local_68: array<u32, 2>;
var local_69: array<u32, 2>;
var local_70: array<u32, 2>;
var local_71: array<u32, 2>;
var local_72: array<u32, 2>;
var local_73: array<u32, 2>;
var local_74: array<u32, 2>;
var local_75: array<u32, 2>;
var local_76: array<u32, 2>;
var local_77: array<u32, 2>;
var local_78: array<u32, 2>;
var local_79: array<u32, 2>;
var local_80: array<u32, 2>;
var local_81: array<u32, 2>;
var local_82: array<u32, 2>;
var local_83: array<u32, 2>;
var local_84: array<u32, 2>;
var local_85: array<u32, 2>;
var local_86: array<u32, 2>;
var local_87: array<u32, 2>;
var local_88: array<u32, 2>;
var local_89: array<u32, 2>;
var local_90: array<u32, 2>;
var local_91: array<u32, 2>;
var local_92: array<u32, 2>;
var local_93: array<u32, 2>;
var local_94: array<u32, 2>;
var local_95: array<u32, 2>;
var local_96: array<u32, 2>;
var local_97: array<u32, 2>;
var local_98: array<u32, 2>;
var local_99: array<u32, 2>;
var local_100: array<u32, 2>;
var local_101: array<u32, 2>;
var local_102: array<u32, 2>;
var local_103: array<u32, 2>;
var local_104: array<u32, 2>;
var local_105: array<u32, 2>;
var local_106: array<u32, 2>;
var local_107: array<u32, 2>;
var local_108: array<u32, 2>;
var local_109: array<u32, 2>;
var local_110: array<u32, 2>;
var local_111: array<u32, 2>;
var local_112: array<u32, 2>;
var local_113: array<u32, 2>;
var local_114: array<u32, 2>;
var local_115: array<u32, 2>;
var local_116: array<u32, 2>;
var local_117: array<u32, 2>;
var local_118: array<u32, 2>;
var local_119: array<u32, 2>;
var local_120: array<u32, 2>;
var local_121: array<u32, 2>;
var local_122: array<u32, 2>;
var local_123: array<u32, 2>;
var local_124: array<u32, 2>;
var local_125: array<u32, 2>;
var local_126: array<u32, 2>;
var local_127: array<u32, 2>;
var local_128: array<u32, 2>;
var local_129: array<u32, 2>;
var local_130: array<u32, 2>;
var local_131: array<u32, 2>;
var local_132: array<u32, 2>;
var local_133: array<u32, 2>;
var local_134: array<u32, 2>;
var local_135: array<u32, 2>;
var local_136: array<u32, 2>;
var local_137: array<u32, 2>;
var local_138: array<u32, 2>;
var local_139: array<u32, 2>;
var local_140: i32;
var local_141: i32;
var phi_1369_: i32;
var phi_2000_: u32;
var phi_2034_: i32;
var phi_2048_: i32;
var phi_2062_: i32;
var phi_2077_: i32;
var phi_2091_: i32;
var phi_2105_: i32;
var phi_1646_: u32;
var phi_1680_: i32;
var phi_1694_: i32;
var phi_1708_: i32;
var phi_1723_: i32;
var phi_1737_: i32;
var phi_1751_: i32;
var phi_2111_: type_12;
var phi_1151_: u32;
var phi_1185_: i32;
var phi_1199_: i32;
var phi_1213_: i32;
var phi_1228_: i32;
var phi_1242_: i32;
var phi_1256_: i32;
var phi_797_: u32;
var phi_831_: i32;
var phi_845_: i32;
var phi_859_: i32;
var phi_874_: i32;
var phi_888_: i32;
var phi_902_: i32;
var phi_1262_: type_12;
var phi_1302_: bool;
var phi_1318_: i32;
var phi_2113_: type_14;
var phi_2146_: u32;
var phi_2147_: u32;
var phi_2148_: u32;
var phi_19778_: type_16;
var phi_21457_: i32;
var phi_21472_: i32;
var phi_21592_: i32;
var phi_21840_: i32;
var phi_21859_: u32;
var phi_21870_: u32;
var phi_21841_: i32;
var phi_21593_: i32;
var phi_21458_: i32;
var phi_17544_: i32;
var phi_17559_: i32;
var phi_17561_: i32;
var phi_17698_: i32;
var phi_17717_: u32;
var phi_17728_: u32;
var phi_17699_: i32;
var phi_17562_: i32;
var phi_17545_: i32;
var phi_13627_: i32;
var phi_13642_: i32;
var phi_13644_: i32;
var phi_13781_: i32;
var phi_13800_: u32;
var phi_13811_: u32;
var phi_13782_: i32;
var phi_13645_: i32;
var phi_13628_: i32;
var phi_8010_: type_16;
var phi_9689_: i32;
var phi_9704_: i32;
var phi_9824_: i32;
var phi_9864_: i32;
var phi_9883_: u32;
var phi_9894_: u32;
var phi_9865_: i32;
var phi_9825_: i32;
var phi_9690_: i32;
var phi_5869_: i32;
var phi_5884_: i32;
var phi_5886_: i32;
var phi_5926_: i32;
var phi_5945_: u32;
var phi_5956_: u32;
var phi_5927_: i32;
var phi_5887_: i32;
var phi_5870_: i32;
switch bitcast<i32>(0u) {
default: {
let _e191 = global;
let _e194 = arrayLength((&global_3.member));
let _e198 = arrayLength((&global_2.member));
let _e202 = global_1.member.member[0u];
let _e206 = global_1.member.member[1u];
if (_e191.x < _e202) {
if (_e191.y < _e206) {
let _e214 = global_1.member.member[2u];
if (_e214 == 0u) {
let _e577 = ((_e191.y * _e202) + _e191.x);
let _e578 = bitcast<i32>(_e577);
let _e579 = (_e578 * 9i);
let _e581 = (bitcast<i32>(_e194) - 9i);
if (_e579 < _e581) {
local_141 = _e579;
} else {
local_141 = _e581;
}
let _e583 = local_141;
if (_e583 < 0i) {
let _e793 = global_1.member.member_3[0u];
let _e797 = global_1.member.member_3[1u];
let _e798 = bitcast<i32>(_e797);
let _e800 = (_e793 & 31u);
let _e803 = ((2i * _e798) + (2i << bitcast<u32>(_e800)));
if ((_e803 >> bitcast<u32>(22u)) == 0i) {
phi_797_ = 0u;
} else {
let _e808 = (_e803 >> bitcast<u32>(16i));
let _e809 = (_e808 == 0i);
phi_797_ = ((((bitcast<u32>(f32(select(_e808, _e803, _e809))) >> bitcast<u32>(23i)) - 127u) + select(16u, 0u, _e809)) + 4294967275u);
}
let _e820 = phi_797_;
let _e830 = (((_e798 + 1i) + ((1i << bitcast<u32>((_e820 & 31u))) >> bitcast<u32>(1i))) + (_e803 >> bitcast<u32>(19i)));
let _e831 = (_e830 + 1i);
let _e835 = global_1.member.member_1[0u];
let _e836 = bitcast<i32>(_e835);
let _e840 = global_1.member.member_1[1u];
let _e841 = bitcast<i32>(_e840);
let _e845 = global_1.member.member_1[2u];
let _e846 = bitcast<i32>(_e845);
let _e849 = ((-1i - _e830) >> bitcast<u32>(_e800));
let _e851 = select(0i, _e849, (_e849 > 0i));
if (_e851 < _e836) {
phi_831_ = _e851;
} else {
phi_831_ = (_e836 - 1i);
}
let _e855 = phi_831_;
if (_e851 < _e841) {
phi_845_ = _e851;
} else {
phi_845_ = (_e841 - 1i);
}
let _e859 = phi_845_;
if (_e851 < _e846) {
phi_859_ = _e851;
} else {
phi_859_ = (_e846 - 1i);
}
let _e863 = phi_859_;
let _e866 = (_e831 >> bitcast<u32>(_e800));
let _e868 = select(0i, _e866, (_e866 > 0i));
if (_e868 < _e836) {
phi_874_ = _e868;
} else {
phi_874_ = (_e836 - 1i);
}
let _e872 = phi_874_;
if (_e868 < _e841) {
phi_888_ = _e868;
} else {
phi_888_ = (_e841 - 1i);
}
let _e876 = phi_888_;
if (_e868 < _e846) {
phi_902_ = _e868;
} else {
phi_902_ = (_e846 - 1i);
}
let _e880 = phi_902_;
phi_1262_ = type_12(vec3<i32>(0i, 0i, 0i), vec3<i32>(0i, 0i, 0i), vec3<i32>(0i, 0i, 0i), vec3<i32>(_e855, _e859, _e863), vec3<i32>((_e872 - _e855), (_e876 - _e859), (_e880 - _e863)), _e831, _e793, _e820);
} else {
let _e585 = local_141;
let _e588 = global_3.member[bitcast<u32>(_e585)];
let _e589 = bitcast<i32>(_e588);
let _e590 = local_141;
let _e594 = global_3.member[bitcast<u32>((_e590 + 1i))];
let _e595 = bitcast<i32>(_e594);
let _e596 = local_141;
let _e600 = global_3.member[bitcast<u32>((_e596 + 2i))];
let _e601 = bitcast<i32>(_e600);
let _e603 = local_141;
let _e607 = global_3.member[bitcast<u32>((_e603 + 3i))];
let _e608 = bitcast<i32>(_e607);
let _e609 = local_141;
let _e613 = global_3.member[bitcast<u32>((_e609 + 4i))];
let _e614 = bitcast<i32>(_e613);
let _e615 = local_141;
let _e619 = global_3.member[bitcast<u32>((_e615 + 5i))];
let _e620 = bitcast<i32>(_e619);
let _e622 = local_141;
let _e626 = global_3.member[bitcast<u32>((_e622 + 6i))];
let _e627 = bitcast<i32>(_e626);
let _e628 = local_141;
let _e632 = global_3.member[bitcast<u32>((_e628 + 7i))];
let _e633 = bitcast<i32>(_e632);
let _e634 = local_141;
let _e638 = global_3.member[bitcast<u32>((_e634 + 8i))];
let _e639 = bitcast<i32>(_e638);
let _e644 = global_1.member.member_3[0u];
let _e648 = global_1.member.member_3[1u];
let _e649 = bitcast<i32>(_e648);
let _e651 = select(_e608, _e589, (_e589 < _e608));
let _e653 = select(_e614, _e595, (_e595 < _e614));
let _e655 = select(_e620, _e601, (_e601 < _e620));
let _e657 = select(_e627, _e651, (_e651 < _e627));
let _e659 = select(_e633, _e653, (_e653 < _e633));
let _e661 = select(_e639, _e655, (_e655 < _e639));
let _e663 = select(_e608, _e589, (_e589 > _e608));
let _e665 = select(_e614, _e595, (_e595 > _e614));
let _e667 = select(_e620, _e601, (_e601 > _e620));
let _e669 = select(_e627, _e663, (_e663 > _e627));
let _e671 = select(_e633, _e665, (_e665 > _e633));
let _e673 = select(_e639, _e667, (_e667 > _e639));
let _e674 = (_e669 - _e657);
let _e675 = (_e671 - _e659);
let _e676 = (_e673 - _e661);
let _e678 = select(_e675, _e674, (_e674 > _e675));
let _e683 = (_e644 & 31u);
let _e686 = ((select(_e676, _e678, (_e678 > _e676)) + (2i * _e649)) + (2i << bitcast<u32>(_e683)));
if ((_e686 >> bitcast<u32>(22u)) == 0i) {
phi_1151_ = 0u;
} else {
let _e691 = (_e686 >> bitcast<u32>(16i));
let _e692 = (_e691 == 0i);
phi_1151_ = ((((bitcast<u32>(f32(select(_e691, _e686, _e692))) >> bitcast<u32>(23i)) - 127u) + select(16u, 0u, _e692)) + 4294967275u);
}
let _e703 = phi_1151_;
let _e714 = ((((_e649 + 1i) + ((1i << bitcast<u32>((_e703 & 31u))) >> bitcast<u32>(1i))) + (_e686 >> bitcast<u32>(19i))) + 1i);
let _e718 = global_1.member.member_1[0u];
let _e719 = bitcast<i32>(_e718);
let _e723 = global_1.member.member_1[1u];
let _e724 = bitcast<i32>(_e723);
let _e728 = global_1.member.member_1[2u];
let _e729 = bitcast<i32>(_e728);
let _e732 = ((_e657 - _e714) >> bitcast<u32>(_e683));
let _e734 = select(0i, _e732, (_e732 > 0i));
if (_e734 < _e719) {
phi_1185_ = _e734;
} else {
phi_1185_ = (_e719 - 1i);
}
let _e738 = phi_1185_;
let _e741 = ((_e659 - _e714) >> bitcast<u32>(_e683));
let _e743 = select(0i, _e741, (_e741 > 0i));
if (_e743 < _e724) {
phi_1199_ = _e743;
} else {
phi_1199_ = (_e724 - 1i);
}
let _e747 = phi_1199_;
let _e750 = ((_e661 - _e714) >> bitcast<u32>(_e683));
let _e752 = select(0i, _e750, (_e750 > 0i));
if (_e752 < _e729) {
phi_1213_ = _e752;
} else {
phi_1213_ = (_e729 - 1i);
}
let _e756 = phi_1213_;
let _e760 = ((_e669 + _e714) >> bitcast<u32>(_e683));
let _e762 = select(0i, _e760, (_e760 > 0i));
if (_e762 < _e719) {
phi_1228_ = _e762;
} else {
phi_1228_ = (_e719 - 1i);
}
let _e766 = phi_1228_;
let _e769 = ((_e671 + _e714) >> bitcast<u32>(_e683));
let _e771 = select(0i, _e769, (_e769 > 0i));
if (_e771 < _e724) {
phi_1242_ = _e771;
} else {
phi_1242_ = (_e724 - 1i);
}
let _e775 = phi_1242_;
let _e778 = ((_e673 + _e714) >> bitcast<u32>(_e683));
let _e780 = select(0i, _e778, (_e778 > 0i));
if (_e780 < _e729) {
phi_1256_ = _e780;
} else {
phi_1256_ = (_e729 - 1i);
}
let _e784 = phi_1256_;
phi_1262_ = type_12(vec3<i32>(_e589, _e595, _e601), vec3<i32>(_e608, _e614, _e620), vec3<i32>(_e627, _e633, _e639), vec3<i32>(_e738, _e747, _e756), vec3<i32>((_e766 - _e738), (_e775 - _e747), (_e784 - _e756)), _e714, _e644, _e703);
}
let _e887 = phi_1262_;
let _e891 = global_1.member.member[3u];
let _e897 = (_e887.member_4.z >= _e887.member_4.y);
let _e899 = (1i + select(_e887.member_4.y, _e887.member_4.z, _e897));
if (_e899 == 1i) {
phi_1302_ = true;
} else {
phi_1302_ = ((_e899 * (1i + select(_e887.member_4.z, _e887.member_4.y, _e897))) <= 32i);
}
let _e906 = phi_1302_;
if ((_e577 < _e891) && _e906) {
phi_1318_ = _e899;
} else {
phi_1318_ = 0i;
}
let _e909 = phi_1318_;
phi_2113_ = type_14(type_13(_e578, 0i, _e909), _e887);
} else {
let _e217 = ((_e191.y * _e202) + _e191.x);
let _e221 = global_1.member.member[3u];
let _e223 = bitcast<i32>((_e217 * 3u));
let _e224 = (_e223 + 1i);
let _e226 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e228 = select(_e226, _e224, (_e224 < _e226));
let _e234 = global_4.member[bitcast<u32>(select(0i, _e228, (_e228 > 0i)))];
let _e235 = bitcast<i32>(_e234);
if (_e217 < _e221) {
let _e237 = (_e223 + 2i);
let _e239 = select(_e226, _e237, (_e237 < _e226));
let _e245 = global_4.member[bitcast<u32>(select(0i, _e239, (_e239 > 0i)))];
phi_1369_ = bitcast<i32>(_e245);
} else {
phi_1369_ = 0i;
}
let _e248 = phi_1369_;
let _e250 = select(_e226, _e223, (_e223 < _e226));
let _e256 = global_4.member[bitcast<u32>(select(0i, _e250, (_e250 > 0i)))];
let _e262 = global_1.member.member_3[2u];
let _e264 = (bitcast<i32>(_e256) + bitcast<i32>(_e262));
let _e266 = (_e264 * 9i);
let _e268 = (bitcast<i32>(_e194) - 9i);
if (_e266 < _e268) {
local_140 = _e266;
} else {
local_140 = _e268;
}
let _e270 = local_140;
if (_e270 < 0i) {
let _e480 = global_1.member.member_3[0u];
let _e484 = global_1.member.member_3[1u];
let _e485 = bitcast<i32>(_e484);
let _e487 = (_e480 & 31u);
let _e490 = ((2i * _e485) + (2i << bitcast<u32>(_e487)));
if ((_e490 >> bitcast<u32>(22u)) == 0i) {
phi_1646_ = 0u;
} else {
let _e495 = (_e490 >> bitcast<u32>(16i));
let _e496 = (_e495 == 0i);
phi_1646_ = ((((bitcast<u32>(f32(select(_e495, _e490, _e496))) >> bitcast<u32>(23i)) - 127u) + select(16u, 0u, _e496)) + 4294967275u);
}
let _e507 = phi_1646_;
let _e517 = (((_e485 + 1i) + ((1i << bitcast<u32>((_e507 & 31u))) >> bitcast<u32>(1i))) + (_e490 >> bitcast<u32>(19i)));
let _e518 = (_e517 + 1i);
let _e522 = global_1.member.member_1[0u];
let _e523 = bitcast<i32>(_e522);
let _e527 = global_1.member.member_1[1u];
let _e528 = bitcast<i32>(_e527);
let _e532 = global_1.member.member_1[2u];
let _e533 = bitcast<i32>(_e532);
let _e536 = ((-1i - _e517) >> bitcast<u32>(_e487));
let _e538 = select(0i, _e536, (_e536 > 0i));
if (_e538 < _e523) {
phi_1680_ = _e538;
} else {
phi_1680_ = (_e523 - 1i);
}
let _e542 = phi_1680_;
if (_e538 < _e528) {
phi_1694_ = _e538;
} else {
phi_1694_ = (_e528 - 1i);
}
let _e546 = phi_1694_;
if (_e538 < _e533) {
phi_1708_ = _e538;
} else {
phi_1708_ = (_e533 - 1i);
}
let _e550 = phi_1708_;
let _e553 = (_e518 >> bitcast<u32>(_e487));
let _e555 = select(0i, _e553, (_e553 > 0i));
if (_e555 < _e523) {
phi_1723_ = _e555;
} else {
phi_1723_ = (_e523 - 1i);
}
let _e559 = phi_1723_;
if (_e555 < _e528) {
phi_1737_ = _e555;
} else {
phi_1737_ = (_e528 - 1i);
}
let _e563 = phi_1737_;
if (_e555 < _e533) {
phi_1751_ = _e555;
} else {
phi_1751_ = (_e533 - 1i);
}
let _e567 = phi_1751_;
phi_2111_ = type_12(vec3<i32>(0i, 0i, 0i), vec3<i32>(0i, 0i, 0i), vec3<i32>(0i, 0i, 0i), vec3<i32>(_e542, _e546, _e550), vec3<i32>((_e559 - _e542), (_e563 - _e546), (_e567 - _e550)), _e518, _e480, _e507);
} else {
let _e272 = local_140;
let _e275 = global_3.member[bitcast<u32>(_e272)];
let _e276 = bitcast<i32>(_e275);
let _e277 = local_140;
let _e281 = global_3.member[bitcast<u32>((_e277 + 1i))];
let _e282 = bitcast<i32>(_e281);
let _e283 = local_140;
let _e287 = global_3.member[bitcast<u32>((_e283 + 2i))];
let _e288 = bitcast<i32>(_e287);
let _e290 = local_140;
let _e294 = global_3.member[bitcast<u32>((_e290 + 3i))];
let _e295 = bitcast<i32>(_e294);
let _e296 = local_140;
let _e300 = global_3.member[bitcast<u32>((_e296 + 4i))];
let _e301 = bitcast<i32>(_e300);
let _e302 = local_140;
let _e306 = global_3.member[bitcast<u32>((_e302 + 5i))];
let _e307 = bitcast<i32>(_e306);
let _e309 = local_140;
let _e313 = global_3.member[bitcast<u32>((_e309 + 6i))];
let _e314 = bitcast<i32>(_e313);
let _e315 = local_140;
let _e319 = global_3.member[bitcast<u32>((_e315 + 7i))];
let _e320 = bitcast<i32>(_e319);
let _e321 = local_140;
let _e325 = global_3.member[bitcast<u32>((_e321 + 8i))];
let _e326 = bitcast<i32>(_e325);
let _e331 = global_1.member.member_3[0u];
let _e335 = global_1.member.member_3[1u];
let _e336 = bitcast<i32>(_e335);
let _e338 = select(_e295, _e276, (_e276 < _e295));
let _e340 = select(_e301, _e282, (_e282 < _e301));
let _e342 = select(_e307, _e288, (_e288 < _e307));
let _e344 = select(_e314, _e338, (_e338 < _e314));
let _e346 = select(_e320, _e340, (_e340 < _e320));
let _e348 = select(_e326, _e342, (_e342 < _e326));
let _e350 = select(_e295, _e276, (_e276 > _e295));
let _e352 = select(_e301, _e282, (_e282 > _e301));
let _e354 = select(_e307, _e288, (_e288 > _e307));
let _e356 = select(_e314, _e350, (_e350 > _e314));
let _e358 = select(_e320, _e352, (_e352 > _e320));
let _e360 = select(_e326, _e354, (_e354 > _e326));
let _e361 = (_e356 - _e344);
let _e362 = (_e358 - _e346);
let _e363 = (_e360 - _e348);
let _e365 = select(_e362, _e361, (_e361 > _e362));
let _e370 = (_e331 & 31u);
let _e373 = ((select(_e363, _e365, (_e365 > _e363)) + (2i * _e336)) + (2i << bitcast<u32>(_e370)));
if ((_e373 >> bitcast<u32>(22u)) == 0i) {
phi_2000_ = 0u;
} else {
let _e378 = (_e373 >> bitcast<u32>(16i));
let _e379 = (_e378 == 0i);
phi_2000_ = ((((bitcast<u32>(f32(select(_e378, _e373, _e379))) >> bitcast<u32>(23i)) - 127u) + select(16u, 0u, _e379)) + 4294967275u);
}
let _e390 = phi_2000_;
let _e401 = ((((_e336 + 1i) + ((1i << bitcast<u32>((_e390 & 31u))) >> bitcast<u32>(1i))) + (_e373 >> bitcast<u32>(19i))) + 1i);
let _e405 = global_1.member.member_1[0u];
let _e406 = bitcast<i32>(_e405);
let _e410 = global_1.member.member_1[1u];
let _e411 = bitcast<i32>(_e410);
let _e415 = global_1.member.member_1[2u];
let _e416 = bitcast<i32>(_e415);
let _e419 = ((_e344 - _e401) >> bitcast<u32>(_e370));
let _e421 = select(0i, _e419, (_e419 > 0i));
if (_e421 < _e406) {
phi_2034_ = _e421;
} else {
phi_2034_ = (_e406 - 1i);
}
let _e425 = phi_2034_;
let _e428 = ((_e346 - _e401) >> bitcast<u32>(_e370));
let _e430 = select(0i, _e428, (_e428 > 0i));
if (_e430 < _e411) {
phi_2048_ = _e430;
} else {
phi_2048_ = (_e411 - 1i);
}
let _e434 = phi_2048_;
let _e437 = ((_e348 - _e401) >> bitcast<u32>(_e370));
let _e439 = select(0i, _e437, (_e437 > 0i));
if (_e439 < _e416) {
phi_2062_ = _e439;
} else {
phi_2062_ = (_e416 - 1i);
}
let _e443 = phi_2062_;
let _e447 = ((_e356 + _e401) >> bitcast<u32>(_e370));
let _e449 = select(0i, _e447, (_e447 > 0i));
if (_e449 < _e406) {
phi_2077_ = _e449;
} else {
phi_2077_ = (_e406 - 1i);
}
let _e453 = phi_2077_;
let _e456 = ((_e358 + _e401) >> bitcast<u32>(_e370));
let _e458 = select(0i, _e456, (_e456 > 0i));
if (_e458 < _e411) {
phi_2091_ = _e458;
} else {
phi_2091_ = (_e411 - 1i);
}
let _e462 = phi_2091_;
let _e465 = ((_e360 + _e401) >> bitcast<u32>(_e370));
let _e467 = select(0i, _e465, (_e465 > 0i));
if (_e467 < _e416) {
phi_2105_ = _e467;
} else {
phi_2105_ = (_e416 - 1i);
}
let _e471 = phi_2105_;
phi_2111_ = type_12(vec3<i32>(_e276, _e282, _e288), vec3<i32>(_e295, _e301, _e307), vec3<i32>(_e314, _e320, _e326), vec3<i32>(_e425, _e434, _e443), vec3<i32>((_e453 - _e425), (_e462 - _e434), (_e471 - _e443)), _e401, _e331, _e390);
}
let _e574 = phi_2111_;
phi_2113_ = type_14(type_13(_e264, _e235, (_e235 + _e248)), _e574);
}
let _e913 = phi_2113_;
if (_e913.member.member_1 < _e913.member.member_2) {
let _e921 = (_e913.member_1.member_4.x == 0i);
let _e924 = (_e913.member_1.member_4.y == 0i);
let _e927 = (_e913.member_1.member_4.z == 0i);
if (((_e921 && _e924) || (_e924 && _e927)) || (_e927 && _e921)) {
phi_2148_ = 0u;
} else {
if _e921 {
phi_2147_ = 1u;
} else {
if _e924 {
phi_2146_ = 2u;
} else {
phi_2146_ = select(4u, 3u, _e927);
}
let _e935 = phi_2146_;
phi_2147_ = _e935;
}
let _e937 = phi_2147_;
phi_2148_ = _e937;
}
let _e939 = phi_2148_;
if (_e939 == 0u) {
let _e4746 = (_e913.member_1.member_6 & 31u);
let _e4748 = (_e913.member_1.member_3.x << bitcast<u32>(_e4746));
let _e4751 = (_e913.member_1.member_7 & 31u);
let _e4755 = ((1i << bitcast<u32>(_e4751)) >> bitcast<u32>(1i));
let _e4761 = bitcast<i32>(_e913.member_1.member_6);
let _e4767 = bitcast<f32>((bitcast<u32>((127i + (bitcast<i32>(_e913.member_1.member_7) - _e4761))) << bitcast<u32>(23i)));
let _e4768 = (f32((((_e913.member_1.member.x - _e4748) + _e4755) >> bitcast<u32>(_e4751))) * _e4767);
let _e4773 = (_e913.member_1.member_3.y << bitcast<u32>(_e4746));
let _e4779 = (f32((((_e913.member_1.member.y - _e4773) + _e4755) >> bitcast<u32>(_e4751))) * _e4767);
let _e4784 = (_e913.member_1.member_3.z << bitcast<u32>(_e4746));
let _e4790 = (f32((((_e913.member_1.member.z - _e4784) + _e4755) >> bitcast<u32>(_e4751))) * _e4767);
let _e4798 = (f32((((_e913.member_1.member_1.x - _e4748) + _e4755) >> bitcast<u32>(_e4751))) * _e4767);
let _e4805 = (f32((((_e913.member_1.member_1.y - _e4773) + _e4755) >> bitcast<u32>(_e4751))) * _e4767);
let _e4812 = (f32((((_e913.member_1.member_1.z - _e4784) + _e4755) >> bitcast<u32>(_e4751))) * _e4767);
let _e4820 = (f32((((_e913.member_1.member_2.x - _e4748) + _e4755) >> bitcast<u32>(_e4751))) * _e4767);
let _e4827 = (f32((((_e913.member_1.member_2.y - _e4773) + _e4755) >> bitcast<u32>(_e4751))) * _e4767);
let _e4834 = (f32((((_e913.member_1.member_2.z - _e4784) + _e4755) >> bitcast<u32>(_e4751))) * _e4767);
let _e4842 = (f32(_e913.member_1.member_5) * bitcast<f32>((bitcast<u32>((127i - _e4761)) << bitcast<u32>(23i))));
let _e4843 = (_e4798 - _e4768);
let _e4844 = (_e4805 - _e4779);
let _e4845 = (_e4812 - _e4790);
let _e4846 = (_e4820 - _e4798);
let _e4847 = (_e4827 - _e4805);
let _e4848 = (_e4834 - _e4812);
let _e4851 = ((_e4844 * _e4848) - (_e4845 * _e4847));
let _e4858 = (1f + _e4842);
let _e4861 = (_e913.member_1.member_4.z >= _e913.member_1.member_4.y);
if _e4861 {
let _e4955 = select(1f, -1f, (_e4851 < 0f));
let _e4960 = ((_e4790 - _e4812) * _e4955);
let _e4961 = ((_e4812 - _e4834) * _e4955);
let _e4962 = ((_e4834 - _e4790) * _e4955);
let _e4963 = ((0f - 0f) * _e4955);
let _e4965 = (_e4844 * _e4955);
let _e4966 = (_e4847 * _e4955);
let _e4967 = ((_e4779 - _e4827) * _e4955);
if (select(0u, 1u, ((_e4960 * _e4858) > -((_e4960 * _e4842)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4961 * _e4858) > -((_e4961 * _e4842)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4962 * _e4858) > -((_e4962 * _e4842)))) < 2u) {
} else {
break;
}
let _e4991 = (select(0u, 1u, ((_e4963 * _e4858) > -((_e4963 * _e4842)))) < 2u);
if _e4991 {
} else {
break;
}
if (select(0u, 1u, ((_e4965 * _e4858) > -((_e4965 * _e4842)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4966 * _e4858) > -((_e4966 * _e4842)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4967 * _e4858) > -((_e4967 * _e4842)))) < 2u) {
} else {
break;
}
if _e4991 {
} else {
break;
}
if (select(0u, 1u, (_e4960 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4961 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4962 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4963 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4960 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4961 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4962 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4963 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4960 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4961 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4962 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4963 < 0f)) < 2u) {
} else {
break;
}
} else {
let _e4863 = select(1f, -1f, (-(_e4851) < 0f));
let _e4868 = ((_e4779 - _e4805) * _e4863);
let _e4869 = ((_e4805 - _e4827) * _e4863);
let _e4870 = ((_e4827 - _e4779) * _e4863);
let _e4871 = ((0f - 0f) * _e4863);
let _e4873 = (_e4845 * _e4863);
let _e4874 = (_e4848 * _e4863);
let _e4875 = ((_e4790 - _e4834) * _e4863);
if (select(0u, 1u, ((_e4868 * _e4858) > -((_e4868 * _e4842)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4869 * _e4858) > -((_e4869 * _e4842)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4870 * _e4858) > -((_e4870 * _e4842)))) < 2u) {
} else {
break;
}
let _e4899 = (select(0u, 1u, ((_e4871 * _e4858) > -((_e4871 * _e4842)))) < 2u);
if _e4899 {
} else {
break;
}
if (select(0u, 1u, ((_e4873 * _e4858) > -((_e4873 * _e4842)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4874 * _e4858) > -((_e4874 * _e4842)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4875 * _e4858) > -((_e4875 * _e4842)))) < 2u) {
} else {
break;
}
if _e4899 {
} else {
break;
}
if (select(0u, 1u, (_e4868 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4869 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4870 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4871 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4868 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4869 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4870 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4871 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4868 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4869 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4870 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4871 < 0f)) < 2u) {
} else {
break;
}
}
let _e5048 = select(1f, -1f, (((_e4843 * _e4847) - (_e4844 * _e4846)) < 0f));
let _e5052 = (0f - 0f);
let _e5053 = ((_e4779 - _e4805) * _e5048);
let _e5054 = ((_e4805 - _e4827) * _e5048);
let _e5055 = ((_e4827 - _e4779) * _e5048);
let _e5056 = (_e5052 * _e5048);
let _e5057 = (_e4768 - _e4820);
let _e5058 = (_e4843 * _e5048);
let _e5059 = (_e4846 * _e5048);
let _e5060 = (_e5057 * _e5048);
if (select(0u, 1u, ((_e5053 * _e4858) > -((_e5053 * _e4842)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e5054 * _e4858) > -((_e5054 * _e4842)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e5055 * _e4858) > -((_e5055 * _e4842)))) < 2u) {
} else {
break;
}
let _e5084 = (select(0u, 1u, ((_e5056 * _e4858) > -((_e5056 * _e4842)))) < 2u);
if _e5084 {
} else {
break;
}
if (select(0u, 1u, ((_e5058 * _e4858) > -((_e5058 * _e4842)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e5059 * _e4858) > -((_e5059 * _e4842)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e5060 * _e4858) > -((_e5060 * _e4842)))) < 2u) {
} else {
break;
}
if _e5084 {
} else {
break;
}
if (select(0u, 1u, (_e5053 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e5054 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e5055 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e5056 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e5053 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e5054 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e5055 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e5056 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e5053 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e5054 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e5055 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e5056 < 0f)) < 2u) {
} else {
break;
}
let _e5140 = select(1f, -1f, (-(((_e4845 * _e4846) - (_e4843 * _e4848))) < 0f));
let _e5144 = ((_e4790 - _e4812) * _e5140);
let _e5145 = ((_e4812 - _e4834) * _e5140);
let _e5146 = ((_e4834 - _e4790) * _e5140);
let _e5147 = (_e5052 * _e5140);
let _e5148 = (_e4843 * _e5140);
let _e5149 = (_e4846 * _e5140);
let _e5150 = (_e5057 * _e5140);
if (select(0u, 1u, ((_e5144 * _e4858) > -((_e5144 * _e4842)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e5145 * _e4858) > -((_e5145 * _e4842)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e5146 * _e4858) > -((_e5146 * _e4842)))) < 2u) {
} else {
break;
}
let _e5174 = (select(0u, 1u, ((_e5147 * _e4858) > -((_e5147 * _e4842)))) < 2u);
if _e5174 {
} else {
break;
}
if (select(0u, 1u, ((_e5148 * _e4858) > -((_e5148 * _e4842)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e5149 * _e4858) > -((_e5149 * _e4842)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e5150 * _e4858) > -((_e5150 * _e4842)))) < 2u) {
} else {
break;
}
if _e5174 {
} else {
break;
}
if (select(0u, 1u, (_e5144 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e5145 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e5146 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e5147 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e5144 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e5145 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e5146 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e5147 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e5144 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e5145 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e5146 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e5147 < 0f)) < 2u) {
} else {
break;
}
phi_5869_ = _e913.member.member_1;
loop {
let _e5230 = phi_5869_;
let _e5231 = (_e5230 < _e913.member.member_2);
if _e5231 {
if _e4861 {
phi_5884_ = _e913.member_1.member_4.y;
} else {
phi_5884_ = _e913.member_1.member_4.z;
}
let _e5235 = phi_5884_;
phi_5886_ = 0i;
loop {
let _e5237 = phi_5886_;
let _e5238 = (_e5237 <= _e5235);
if _e5238 {
if (0i <= _e913.member_1.member_4.x) {
let _e5247 = global_1.member.member_1[1u];
let _e5255 = global_1.member.member_1[3u];
let _e5258 = (_e913.member_1.member_3.x + _e913.member_1.member_4.x);
let _e5260 = (_e913.member_1.member_3.x >> bitcast<u32>(5i));
phi_5926_ = _e5260;
loop {
let _e5262 = phi_5926_;
let _e5264 = (_e5258 >> bitcast<u32>(5i));
let _e5265 = (_e5262 <= _e5264);
if _e5265 {
if (_e5262 == _e5260) {
phi_5945_ = (4294967295u << bitcast<u32>((bitcast<u32>((_e913.member_1.member_3.x & 31i)) & 31u)));
} else {
phi_5945_ = 4294967295u;
}
let _e5273 = phi_5945_;
if (_e5262 == _e5264) {
phi_5956_ = (4294967295u >> bitcast<u32>((bitcast<u32>((31i - (_e5258 & 31i))) & 31u)));
} else {
phi_5956_ = 4294967295u;
}
let _e5282 = phi_5956_;
let _e5284 = bitcast<u32>(((((((_e913.member_1.member_3.z + select(_e5237, _e5230, _e4861)) * bitcast<i32>(_e5247)) + _e913.member_1.member_3.y) + select(_e5230, _e5237, _e4861)) * bitcast<i32>(_e5255)) + _e5262));
if (_e5284 < _e198) {
let _e5289 = atomicOr((&global_2.member[_e5284]), (_e5273 & _e5282));
}
phi_5927_ = (_e5262 + 1i);
} else {
phi_5927_ = i32();
}
let _e5292 = phi_5927_;
continue;
continuing {
phi_5926_ = _e5292;
break if !(_e5265);
}
}
}
phi_5887_ = (_e5237 + 1i);
} else {
phi_5887_ = i32();
}
let _e5296 = phi_5887_;
continue;
continuing {
phi_5886_ = _e5296;
break if !(_e5238);
}
}
phi_5870_ = (_e5230 + 1i);
} else {
phi_5870_ = i32();
}
let _e5300 = phi_5870_;
continue;
continuing {
phi_5869_ = _e5300;
break if !(_e5231);
}
}
} else {
if (_e939 == 1u) {
let _e3796 = (_e913.member_1.member_6 & 31u);
let _e3798 = (_e913.member_1.member_3.x << bitcast<u32>(_e3796));
let _e3801 = (_e913.member_1.member_7 & 31u);
let _e3805 = ((1i << bitcast<u32>(_e3801)) >> bitcast<u32>(1i));
let _e3811 = bitcast<i32>(_e913.member_1.member_6);
let _e3817 = bitcast<f32>((bitcast<u32>((127i + (bitcast<i32>(_e913.member_1.member_7) - _e3811))) << bitcast<u32>(23i)));
let _e3818 = (f32((((_e913.member_1.member.x - _e3798) + _e3805) >> bitcast<u32>(_e3801))) * _e3817);
let _e3823 = (_e913.member_1.member_3.y << bitcast<u32>(_e3796));
let _e3829 = (f32((((_e913.member_1.member.y - _e3823) + _e3805) >> bitcast<u32>(_e3801))) * _e3817);
let _e3834 = (_e913.member_1.member_3.z << bitcast<u32>(_e3796));
let _e3840 = (f32((((_e913.member_1.member.z - _e3834) + _e3805) >> bitcast<u32>(_e3801))) * _e3817);
let _e3848 = (f32((((_e913.member_1.member_1.x - _e3798) + _e3805) >> bitcast<u32>(_e3801))) * _e3817);
let _e3855 = (f32((((_e913.member_1.member_1.y - _e3823) + _e3805) >> bitcast<u32>(_e3801))) * _e3817);
let _e3862 = (f32((((_e913.member_1.member_1.z - _e3834) + _e3805) >> bitcast<u32>(_e3801))) * _e3817);
let _e3870 = (f32((((_e913.member_1.member_2.x - _e3798) + _e3805) >> bitcast<u32>(_e3801))) * _e3817);
let _e3877 = (f32((((_e913.member_1.member_2.y - _e3823) + _e3805) >> bitcast<u32>(_e3801))) * _e3817);
let _e3884 = (f32((((_e913.member_1.member_2.z - _e3834) + _e3805) >> bitcast<u32>(_e3801))) * _e3817);
let _e3892 = (f32(_e913.member_1.member_5) * bitcast<f32>((bitcast<u32>((127i - _e3811)) << bitcast<u32>(23i))));
let _e3893 = (_e3848 - _e3818);
let _e3894 = (_e3855 - _e3829);
let _e3895 = (_e3862 - _e3840);
let _e3896 = (_e3870 - _e3848);
let _e3897 = (_e3877 - _e3855);
let _e3898 = (_e3884 - _e3862);
let _e3899 = (_e3894 * _e3898);
let _e3900 = (_e3895 * _e3897);
let _e3901 = (_e3899 - _e3900);
let _e3915 = ((bitcast<f32>((bitcast<u32>(_e3899) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e3900) & 2147483647u))) * 2.3841858e-7f);
let _e3916 = f32(_e913.member_1.member_4.y);
let _e3917 = f32(_e913.member_1.member_4.z);
let _e3918 = (1f + _e3892);
let _e3919 = -(_e3901);
let _e3921 = (_e913.member_1.member_4.z >= _e913.member_1.member_4.y);
if _e3921 {
let _e4162 = select(1f, -1f, (_e3901 < 0f));
let _e4168 = select(0f, (2f * _e3915), (bitcast<f32>((bitcast<u32>(_e3901) & 2147483647u)) <= _e3915));
let _e4173 = ((_e3840 - _e3862) * _e4162);
let _e4174 = ((_e3862 - _e3884) * _e4162);
let _e4175 = ((_e3884 - _e3840) * _e4162);
let _e4176 = ((0f - 0f) * _e4162);
let _e4178 = (_e3894 * _e4162);
let _e4179 = (_e3897 * _e4162);
let _e4180 = ((_e3829 - _e3877) * _e4162);
let _e4182 = (_e4173 * _e3918);
let _e4183 = (_e4174 * _e3918);
let _e4184 = (_e4175 * _e3918);
let _e4185 = (_e4176 * _e3918);
let _e4190 = -((_e4173 * _e3892));
let _e4191 = -((_e4174 * _e3892));
let _e4192 = -((_e4175 * _e3892));
let _e4193 = -((_e4176 * _e3892));
local_136 = array<u32, 2>(0u, 4294967295u);
let _e4198 = select(0u, 1u, (_e4182 > _e4190));
if (_e4198 < 2u) {
} else {
break;
}
let _e4201 = local_136[_e4198];
local_137 = array<u32, 2>(0u, 4294967295u);
let _e4202 = select(0u, 1u, (_e4183 > _e4191));
if (_e4202 < 2u) {
} else {
break;
}
let _e4205 = local_137[_e4202];
local_138 = array<u32, 2>(0u, 4294967295u);
let _e4206 = select(0u, 1u, (_e4184 > _e4192));
if (_e4206 < 2u) {
} else {
break;
}
let _e4209 = local_138[_e4206];
local_139 = array<u32, 2>(0u, 4294967295u);
let _e4210 = select(0u, 1u, (_e4185 > _e4193));
let _e4211 = (_e4210 < 2u);
if _e4211 {
} else {
break;
}
let _e4213 = local_139[_e4210];
let _e4229 = (_e4176 * 0f);
let _e4234 = (_e4178 * _e3918);
let _e4235 = (_e4179 * _e3918);
let _e4236 = (_e4180 * _e3918);
let _e4240 = -((_e4178 * _e3892));
let _e4241 = -((_e4179 * _e3892));
let _e4242 = -((_e4180 * _e3892));
local_132 = array<u32, 2>(0u, 4294967295u);
let _e4246 = select(0u, 1u, (_e4234 > _e4240));
if (_e4246 < 2u) {
} else {
break;
}
let _e4249 = local_132[_e4246];
local_133 = array<u32, 2>(0u, 4294967295u);
let _e4250 = select(0u, 1u, (_e4235 > _e4241));
if (_e4250 < 2u) {
} else {
break;
}
let _e4253 = local_133[_e4250];
local_134 = array<u32, 2>(0u, 4294967295u);
let _e4254 = select(0u, 1u, (_e4236 > _e4242));
if (_e4254 < 2u) {
} else {
break;
}
let _e4257 = local_134[_e4254];
local_135 = array<u32, 2>(0u, 4294967295u);
if _e4211 {
} else {
break;
}
let _e4259 = local_135[_e4210];
local_128 = array<u32, 2>(0u, 4294967295u);
let _e4292 = select(0u, 1u, (_e4173 == 0f));
if (_e4292 < 2u) {
} else {
break;
}
let _e4295 = local_128[_e4292];
local_129 = array<u32, 2>(0u, 4294967295u);
let _e4296 = select(0u, 1u, (_e4174 == 0f));
if (_e4296 < 2u) {
} else {
break;
}
let _e4299 = local_129[_e4296];
local_130 = array<u32, 2>(0u, 4294967295u);
let _e4300 = select(0u, 1u, (_e4175 == 0f));
if (_e4300 < 2u) {
} else {
break;
}
let _e4303 = local_130[_e4300];
local_131 = array<u32, 2>(0u, 4294967295u);
let _e4304 = select(0u, 1u, (_e4176 == 0f));
if (_e4304 < 2u) {
} else {
break;
}
let _e4307 = local_131[_e4304];
let _e4309 = ((_e4295 & 1u) != 0u);
let _e4312 = ((_e4299 & 1u) != 0u);
let _e4315 = ((_e4303 & 1u) != 0u);
let _e4318 = ((_e4307 & 1u) != 0u);
let _e4320 = (-1f / select(_e4173, 1f, _e4309));
let _e4321 = (-1f / select(_e4174, 1f, _e4312));
let _e4322 = (-1f / select(_e4175, 1f, _e4315));
let _e4323 = (-1f / select(_e4176, 1f, _e4318));
local_124 = array<u32, 2>(0u, 4294967295u);
let _e4328 = select(0u, 1u, (_e4173 > 0f));
if (_e4328 < 2u) {
} else {
break;
}
let _e4331 = local_124[_e4328];
local_125 = array<u32, 2>(0u, 4294967295u);
let _e4332 = select(0u, 1u, (_e4174 > 0f));
if (_e4332 < 2u) {
} else {
break;
}
let _e4335 = local_125[_e4332];
local_126 = array<u32, 2>(0u, 4294967295u);
let _e4336 = select(0u, 1u, (_e4175 > 0f));
if (_e4336 < 2u) {
} else {
break;
}
let _e4339 = local_126[_e4336];
local_127 = array<u32, 2>(0u, 4294967295u);
let _e4340 = select(0u, 1u, (_e4176 > 0f));
if (_e4340 < 2u) {
} else {
break;
}
let _e4343 = local_127[_e4340];
local_120 = array<u32, 2>(0u, 4294967295u);
let _e4348 = select(0u, 1u, (_e4173 < 0f));
if (_e4348 < 2u) {
} else {
break;
}
let _e4351 = local_120[_e4348];
local_121 = array<u32, 2>(0u, 4294967295u);
let _e4352 = select(0u, 1u, (_e4174 < 0f));
if (_e4352 < 2u) {
} else {
break;
}
let _e4355 = local_121[_e4352];
local_122 = array<u32, 2>(0u, 4294967295u);
let _e4356 = select(0u, 1u, (_e4175 < 0f));
if (_e4356 < 2u) {
} else {
break;
}
let _e4359 = local_122[_e4356];
local_123 = array<u32, 2>(0u, 4294967295u);
let _e4360 = select(0u, 1u, (_e4176 < 0f));
if (_e4360 < 2u) {
} else {
break;
}
let _e4363 = local_123[_e4360];
let _e4382 = ((_e4351 & 1u) != 0u);
let _e4385 = ((_e4355 & 1u) != 0u);
let _e4388 = ((_e4359 & 1u) != 0u);
let _e4391 = ((_e4363 & 1u) != 0u);
phi_8010_ = type_16(vec4<f32>(_e4178, _e4179, _e4180, _e4176), vec4<f32>((((select(_e4190, _e4182, ((_e4201 & 1u) != 0u)) - (_e4173 * _e3829)) + (select(_e4240, _e4234, ((_e4249 & 1u) != 0u)) - (_e4178 * _e3840))) + _e4168), (((select(_e4191, _e4183, ((_e4205 & 1u) != 0u)) - (_e4174 * _e3855)) + (select(_e4241, _e4235, ((_e4253 & 1u) != 0u)) - (_e4179 * _e3862))) + _e4168), (((select(_e4192, _e4184, ((_e4209 & 1u) != 0u)) - (_e4175 * _e3877)) + (select(_e4242, _e4236, ((_e4257 & 1u) != 0u)) - (_e4180 * _e3884))) + _e4168), (((select(_e4193, _e4185, ((_e4213 & 1u) != 0u)) - _e4229) + (select(_e4193, _e4185, ((_e4259 & 1u) != 0u)) - _e4229)) + _e4168)), vec4<f32>(select(0f, _e4320, ((_e4331 & 1u) != 0u)), select(0f, _e4321, ((_e4335 & 1u) != 0u)), select(0f, _e4322, ((_e4339 & 1u) != 0u)), select(0f, _e4323, ((_e4343 & 1u) != 0u))), vec4<f32>(select(select(0f, 1e20f, _e4309), _e4320, _e4382), select(select(0f, 1e20f, _e4312), _e4321, _e4385), select(select(0f, 1e20f, _e4315), _e4322, _e4388), select(select(0f, 1e20f, _e4318), _e4323, _e4391)), vec4<f32>(select(_e3916, 0f, _e4382), select(_e3916, 0f, _e4385), select(_e3916, 0f, _e4388), select(_e3916, 0f, _e4391)));
} else {
let _e3923 = select(1f, -1f, (_e3919 < 0f));
let _e3929 = select(0f, (2f * _e3915), (bitcast<f32>((bitcast<u32>(_e3919) & 2147483647u)) <= _e3915));
let _e3934 = ((_e3829 - _e3855) * _e3923);
let _e3935 = ((_e3855 - _e3877) * _e3923);
let _e3936 = ((_e3877 - _e3829) * _e3923);
let _e3937 = ((0f - 0f) * _e3923);
let _e3939 = (_e3895 * _e3923);
let _e3940 = (_e3898 * _e3923);
let _e3941 = ((_e3840 - _e3884) * _e3923);
let _e3943 = (_e3934 * _e3918);
let _e3944 = (_e3935 * _e3918);
let _e3945 = (_e3936 * _e3918);
let _e3946 = (_e3937 * _e3918);
let _e3951 = -((_e3934 * _e3892));
let _e3952 = -((_e3935 * _e3892));
let _e3953 = -((_e3936 * _e3892));
let _e3954 = -((_e3937 * _e3892));
local_116 = array<u32, 2>(0u, 4294967295u);
let _e3959 = select(0u, 1u, (_e3943 > _e3951));
if (_e3959 < 2u) {
} else {
break;
}
let _e3962 = local_116[_e3959];
local_117 = array<u32, 2>(0u, 4294967295u);
let _e3963 = select(0u, 1u, (_e3944 > _e3952));
if (_e3963 < 2u) {
} else {
break;
}
let _e3966 = local_117[_e3963];
local_118 = array<u32, 2>(0u, 4294967295u);
let _e3967 = select(0u, 1u, (_e3945 > _e3953));
if (_e3967 < 2u) {
} else {
break;
}
let _e3970 = local_118[_e3967];
local_119 = array<u32, 2>(0u, 4294967295u);
let _e3971 = select(0u, 1u, (_e3946 > _e3954));
let _e3972 = (_e3971 < 2u);
if _e3972 {
} else {
break;
}
let _e3974 = local_119[_e3971];
let _e3990 = (_e3937 * 0f);
let _e3995 = (_e3939 * _e3918);
let _e3996 = (_e3940 * _e3918);
let _e3997 = (_e3941 * _e3918);
let _e4001 = -((_e3939 * _e3892));
let _e4002 = -((_e3940 * _e3892));
let _e4003 = -((_e3941 * _e3892));
local_112 = array<u32, 2>(0u, 4294967295u);
let _e4007 = select(0u, 1u, (_e3995 > _e4001));
if (_e4007 < 2u) {
} else {
break;
}
let _e4010 = local_112[_e4007];
local_113 = array<u32, 2>(0u, 4294967295u);
let _e4011 = select(0u, 1u, (_e3996 > _e4002));
if (_e4011 < 2u) {
} else {
break;
}
let _e4014 = local_113[_e4011];
local_114 = array<u32, 2>(0u, 4294967295u);
let _e4015 = select(0u, 1u, (_e3997 > _e4003));
if (_e4015 < 2u) {
} else {
break;
}
let _e4018 = local_114[_e4015];
local_115 = array<u32, 2>(0u, 4294967295u);
if _e3972 {
} else {
break;
}
let _e4020 = local_115[_e3971];
local_108 = array<u32, 2>(0u, 4294967295u);
let _e4053 = select(0u, 1u, (_e3934 == 0f));
if (_e4053 < 2u) {
} else {
break;
}
let _e4056 = local_108[_e4053];
local_109 = array<u32, 2>(0u, 4294967295u);
let _e4057 = select(0u, 1u, (_e3935 == 0f));
if (_e4057 < 2u) {
} else {
break;
}
let _e4060 = local_109[_e4057];
local_110 = array<u32, 2>(0u, 4294967295u);
let _e4061 = select(0u, 1u, (_e3936 == 0f));
if (_e4061 < 2u) {
} else {
break;
}
let _e4064 = local_110[_e4061];
local_111 = array<u32, 2>(0u, 4294967295u);
let _e4065 = select(0u, 1u, (_e3937 == 0f));
if (_e4065 < 2u) {
} else {
break;
}
let _e4068 = local_111[_e4065];
let _e4070 = ((_e4056 & 1u) != 0u);
let _e4073 = ((_e4060 & 1u) != 0u);
let _e4076 = ((_e4064 & 1u) != 0u);
let _e4079 = ((_e4068 & 1u) != 0u);
let _e4081 = (-1f / select(_e3934, 1f, _e4070));
let _e4082 = (-1f / select(_e3935, 1f, _e4073));
let _e4083 = (-1f / select(_e3936, 1f, _e4076));
let _e4084 = (-1f / select(_e3937, 1f, _e4079));
local_104 = array<u32, 2>(0u, 4294967295u);
let _e4089 = select(0u, 1u, (_e3934 > 0f));
if (_e4089 < 2u) {
} else {
break;
}
let _e4092 = local_104[_e4089];
local_105 = array<u32, 2>(0u, 4294967295u);
let _e4093 = select(0u, 1u, (_e3935 > 0f));
if (_e4093 < 2u) {
} else {
break;
}
let _e4096 = local_105[_e4093];
local_106 = array<u32, 2>(0u, 4294967295u);
let _e4097 = select(0u, 1u, (_e3936 > 0f));
if (_e4097 < 2u) {
} else {
break;
}
let _e4100 = local_106[_e4097];
local_107 = array<u32, 2>(0u, 4294967295u);
let _e4101 = select(0u, 1u, (_e3937 > 0f));
if (_e4101 < 2u) {
} else {
break;
}
let _e4104 = local_107[_e4101];
local_100 = array<u32, 2>(0u, 4294967295u);
let _e4109 = select(0u, 1u, (_e3934 < 0f));
if (_e4109 < 2u) {
} else {
break;
}
let _e4112 = local_100[_e4109];
local_101 = array<u32, 2>(0u, 4294967295u);
let _e4113 = select(0u, 1u, (_e3935 < 0f));
if (_e4113 < 2u) {
} else {
break;
}
let _e4116 = local_101[_e4113];
local_102 = array<u32, 2>(0u, 4294967295u);
let _e4117 = select(0u, 1u, (_e3936 < 0f));
if (_e4117 < 2u) {
} else {
break;
}
let _e4120 = local_102[_e4117];
local_103 = array<u32, 2>(0u, 4294967295u);
let _e4121 = select(0u, 1u, (_e3937 < 0f));
if (_e4121 < 2u) {
} else {
break;
}
let _e4124 = local_103[_e4121];
let _e4143 = ((_e4112 & 1u) != 0u);
let _e4146 = ((_e4116 & 1u) != 0u);
let _e4149 = ((_e4120 & 1u) != 0u);
let _e4152 = ((_e4124 & 1u) != 0u);
phi_8010_ = type_16(vec4<f32>(_e3939, _e3940, _e3941, _e3937), vec4<f32>((((select(_e3951, _e3943, ((_e3962 & 1u) != 0u)) - (_e3934 * _e3840)) + (select(_e4001, _e3995, ((_e4010 & 1u) != 0u)) - (_e3939 * _e3829))) + _e3929), (((select(_e3952, _e3944, ((_e3966 & 1u) != 0u)) - (_e3935 * _e3862)) + (select(_e4002, _e3996, ((_e4014 & 1u) != 0u)) - (_e3940 * _e3855))) + _e3929), (((select(_e3953, _e3945, ((_e3970 & 1u) != 0u)) - (_e3936 * _e3884)) + (select(_e4003, _e3997, ((_e4018 & 1u) != 0u)) - (_e3941 * _e3877))) + _e3929), (((select(_e3954, _e3946, ((_e3974 & 1u) != 0u)) - _e3990) + (select(_e3954, _e3946, ((_e4020 & 1u) != 0u)) - _e3990)) + _e3929)), vec4<f32>(select(0f, _e4081, ((_e4092 & 1u) != 0u)), select(0f, _e4082, ((_e4096 & 1u) != 0u)), select(0f, _e4083, ((_e4100 & 1u) != 0u)), select(0f, _e4084, ((_e4104 & 1u) != 0u))), vec4<f32>(select(select(0f, 1e20f, _e4070), _e4081, _e4143), select(select(0f, 1e20f, _e4073), _e4082, _e4146), select(select(0f, 1e20f, _e4076), _e4083, _e4149), select(select(0f, 1e20f, _e4079), _e4084, _e4152)), vec4<f32>(select(_e3917, 0f, _e4143), select(_e3917, 0f, _e4146), select(_e3917, 0f, _e4149), select(_e3917, 0f, _e4152)));
}
let _e4401 = phi_8010_;
let _e4404 = select(1f, -1f, (((_e3893 * _e3897) - (_e3894 * _e3896)) < 0f));
let _e4408 = (0f - 0f);
let _e4409 = ((_e3829 - _e3855) * _e4404);
let _e4410 = ((_e3855 - _e3877) * _e4404);
let _e4411 = ((_e3877 - _e3829) * _e4404);
let _e4412 = (_e4408 * _e4404);
let _e4413 = (_e3818 - _e3870);
let _e4414 = (_e3893 * _e4404);
let _e4415 = (_e3896 * _e4404);
let _e4416 = (_e4413 * _e4404);
if (select(0u, 1u, ((_e4409 * _e3918) > -((_e4409 * _e3892)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4410 * _e3918) > -((_e4410 * _e3892)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4411 * _e3918) > -((_e4411 * _e3892)))) < 2u) {
} else {
break;
}
let _e4440 = (select(0u, 1u, ((_e4412 * _e3918) > -((_e4412 * _e3892)))) < 2u);
if _e4440 {
} else {
break;
}
if (select(0u, 1u, ((_e4414 * _e3918) > -((_e4414 * _e3892)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4415 * _e3918) > -((_e4415 * _e3892)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4416 * _e3918) > -((_e4416 * _e3892)))) < 2u) {
} else {
break;
}
if _e4440 {
} else {
break;
}
if (select(0u, 1u, (_e4409 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4410 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4411 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4412 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4409 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4410 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4411 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4412 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4409 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4410 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4411 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4412 < 0f)) < 2u) {
} else {
break;
}
let _e4496 = select(1f, -1f, (-(((_e3895 * _e3896) - (_e3893 * _e3898))) < 0f));
let _e4500 = ((_e3840 - _e3862) * _e4496);
let _e4501 = ((_e3862 - _e3884) * _e4496);
let _e4502 = ((_e3884 - _e3840) * _e4496);
let _e4503 = (_e4408 * _e4496);
let _e4504 = (_e3893 * _e4496);
let _e4505 = (_e3896 * _e4496);
let _e4506 = (_e4413 * _e4496);
if (select(0u, 1u, ((_e4500 * _e3918) > -((_e4500 * _e3892)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4501 * _e3918) > -((_e4501 * _e3892)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4502 * _e3918) > -((_e4502 * _e3892)))) < 2u) {
} else {
break;
}
let _e4530 = (select(0u, 1u, ((_e4503 * _e3918) > -((_e4503 * _e3892)))) < 2u);
if _e4530 {
} else {
break;
}
if (select(0u, 1u, ((_e4504 * _e3918) > -((_e4504 * _e3892)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4505 * _e3918) > -((_e4505 * _e3892)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4506 * _e3918) > -((_e4506 * _e3892)))) < 2u) {
} else {
break;
}
if _e4530 {
} else {
break;
}
if (select(0u, 1u, (_e4500 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4501 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4502 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4503 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4500 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4501 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4502 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4503 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4500 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4501 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4502 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4503 < 0f)) < 2u) {
} else {
break;
}
phi_9689_ = _e913.member.member_1;
loop {
let _e4586 = phi_9689_;
let _e4587 = (_e4586 < _e913.member.member_2);
if _e4587 {
if _e3921 {
phi_9704_ = _e913.member_1.member_4.y;
} else {
phi_9704_ = _e913.member_1.member_4.z;
}
let _e4591 = phi_9704_;
let _e4592 = f32(_e4591);
let _e4593 = f32(_e4586);
let _e4603 = ((_e4401.member.x * _e4593) + _e4401.member_1.x);
let _e4605 = ((_e4401.member.y * _e4593) + _e4401.member_1.y);
let _e4607 = ((_e4401.member.z * _e4593) + _e4401.member_1.z);
let _e4610 = (_e4603 * _e4401.member_2.x);
let _e4612 = (_e4605 * _e4401.member_2.y);
let _e4614 = (_e4607 * _e4401.member_2.z);
let _e4624 = ((_e4603 * _e4401.member_3.x) + _e4401.member_4.x);
let _e4626 = ((_e4605 * _e4401.member_3.y) + _e4401.member_4.y);
let _e4628 = ((_e4607 * _e4401.member_3.z) + _e4401.member_4.z);
let _e4630 = select(_e4610, 0f, (0f > _e4610));
let _e4632 = select(_e4614, _e4612, (_e4612 > _e4614));
let _e4636 = select(_e4624, _e4592, (_e4592 < _e4624));
let _e4638 = select(_e4628, _e4626, (_e4626 < _e4628));
let _e4640 = select(_e4638, _e4636, (_e4636 < _e4638));
let _e4641 = -(select(_e4632, _e4630, (_e4630 > _e4632)));
let _e4643 = (-(_e4592) - 1f);
let _e4645 = select(_e4643, _e4641, (_e4641 > _e4643));
let _e4647 = select(0f, _e4645, (_e4645 < 0f));
let _e4654 = select(0i, select(select(i32(_e4647), i32(-2147483648), (_e4647 < -2147483600f)), 2147483647i, (_e4647 > 2147483500f)), (_e4647 == _e4647));
let _e4661 = select(-1f, _e4640, (_e4640 > -1f));
let _e4663 = select(_e4592, _e4661, (_e4661 < _e4592));
let _e4670 = select(0i, select(select(i32(_e4663), i32(-2147483648), (_e4663 < -2147483600f)), 2147483647i, (_e4663 > 2147483500f)), (_e4663 == _e4663));
phi_9824_ = -((_e4654 - select(0i, 1i, (_e4647 < f32(_e4654)))));
loop {
let _e4676 = phi_9824_;
let _e4677 = (_e4676 <= (_e4670 - select(0i, 1i, (_e4663 < f32(_e4670)))));
if _e4677 {
if (0i <= _e913.member_1.member_4.x) {
let _e4686 = global_1.member.member_1[1u];
let _e4694 = global_1.member.member_1[3u];
let _e4697 = (_e913.member_1.member_3.x + _e913.member_1.member_4.x);
let _e4699 = (_e913.member_1.member_3.x >> bitcast<u32>(5i));
phi_9864_ = _e4699;
loop {
let _e4701 = phi_9864_;
let _e4703 = (_e4697 >> bitcast<u32>(5i));
let _e4704 = (_e4701 <= _e4703);
if _e4704 {
if (_e4701 == _e4699) {
phi_9883_ = (4294967295u << bitcast<u32>((bitcast<u32>((_e913.member_1.member_3.x & 31i)) & 31u)));
} else {
phi_9883_ = 4294967295u;
}
let _e4712 = phi_9883_;
if (_e4701 == _e4703) {
phi_9894_ = (4294967295u >> bitcast<u32>((bitcast<u32>((31i - (_e4697 & 31i))) & 31u)));
} else {
phi_9894_ = 4294967295u;
}
let _e4721 = phi_9894_;
let _e4723 = bitcast<u32>(((((((_e913.member_1.member_3.z + select(_e4676, _e4586, _e3921)) * bitcast<i32>(_e4686)) + _e913.member_1.member_3.y) + select(_e4586, _e4676, _e3921)) * bitcast<i32>(_e4694)) + _e4701));
if (_e4723 < _e198) {
let _e4728 = atomicOr((&global_2.member[_e4723]), (_e4712 & _e4721));
}
phi_9865_ = (_e4701 + 1i);
} else {
phi_9865_ = i32();
}
let _e4731 = phi_9865_;
continue;
continuing {
phi_9864_ = _e4731;
break if !(_e4704);
}
}
}
phi_9825_ = (_e4676 + 1i);
} else {
phi_9825_ = i32();
}
let _e4735 = phi_9825_;
continue;
continuing {
phi_9824_ = _e4735;
break if !(_e4677);
}
}
phi_9690_ = (_e4586 + 1i);
} else {
phi_9690_ = i32();
}
let _e4739 = phi_9690_;
continue;
continuing {
phi_9689_ = _e4739;
break if !(_e4587);
}
}
} else {
if (_e939 == 2u) {
let _e3054 = (_e913.member_1.member_6 & 31u);
let _e3056 = (_e913.member_1.member_3.x << bitcast<u32>(_e3054));
let _e3059 = (_e913.member_1.member_7 & 31u);
let _e3063 = ((1i << bitcast<u32>(_e3059)) >> bitcast<u32>(1i));
let _e3069 = bitcast<i32>(_e913.member_1.member_6);
let _e3075 = bitcast<f32>((bitcast<u32>((127i + (bitcast<i32>(_e913.member_1.member_7) - _e3069))) << bitcast<u32>(23i)));
let _e3076 = (f32((((_e913.member_1.member.x - _e3056) + _e3063) >> bitcast<u32>(_e3059))) * _e3075);
let _e3081 = (_e913.member_1.member_3.y << bitcast<u32>(_e3054));
let _e3087 = (f32((((_e913.member_1.member.y - _e3081) + _e3063) >> bitcast<u32>(_e3059))) * _e3075);
let _e3092 = (_e913.member_1.member_3.z << bitcast<u32>(_e3054));
let _e3098 = (f32((((_e913.member_1.member.z - _e3092) + _e3063) >> bitcast<u32>(_e3059))) * _e3075);
let _e3106 = (f32((((_e913.member_1.member_1.x - _e3056) + _e3063) >> bitcast<u32>(_e3059))) * _e3075);
let _e3113 = (f32((((_e913.member_1.member_1.y - _e3081) + _e3063) >> bitcast<u32>(_e3059))) * _e3075);
let _e3120 = (f32((((_e913.member_1.member_1.z - _e3092) + _e3063) >> bitcast<u32>(_e3059))) * _e3075);
let _e3128 = (f32((((_e913.member_1.member_2.x - _e3056) + _e3063) >> bitcast<u32>(_e3059))) * _e3075);
let _e3135 = (f32((((_e913.member_1.member_2.y - _e3081) + _e3063) >> bitcast<u32>(_e3059))) * _e3075);
let _e3142 = (f32((((_e913.member_1.member_2.z - _e3092) + _e3063) >> bitcast<u32>(_e3059))) * _e3075);
let _e3150 = (f32(_e913.member_1.member_5) * bitcast<f32>((bitcast<u32>((127i - _e3069)) << bitcast<u32>(23i))));
let _e3151 = (_e3106 - _e3076);
let _e3152 = (_e3113 - _e3087);
let _e3153 = (_e3120 - _e3098);
let _e3154 = (_e3128 - _e3106);
let _e3155 = (_e3135 - _e3113);
let _e3156 = (_e3142 - _e3120);
let _e3159 = ((_e3152 * _e3156) - (_e3153 * _e3155));
let _e3160 = (_e3153 * _e3154);
let _e3161 = (_e3151 * _e3156);
let _e3173 = ((bitcast<f32>((bitcast<u32>(_e3160) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e3161) & 2147483647u))) * 2.3841858e-7f);
let _e3174 = f32(_e913.member_1.member_4.x);
let _e3175 = (1f + _e3150);
let _e3177 = -((_e3160 - _e3161));
let _e3178 = (_e913.member_1.member_4.z >= _e913.member_1.member_4.y);
if _e3178 {
let _e3272 = select(1f, -1f, (_e3159 < 0f));
let _e3277 = ((_e3098 - _e3120) * _e3272);
let _e3278 = ((_e3120 - _e3142) * _e3272);
let _e3279 = ((_e3142 - _e3098) * _e3272);
let _e3280 = ((0f - 0f) * _e3272);
let _e3282 = (_e3152 * _e3272);
let _e3283 = (_e3155 * _e3272);
let _e3284 = ((_e3087 - _e3135) * _e3272);
if (select(0u, 1u, ((_e3277 * _e3175) > -((_e3277 * _e3150)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3278 * _e3175) > -((_e3278 * _e3150)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3279 * _e3175) > -((_e3279 * _e3150)))) < 2u) {
} else {
break;
}
let _e3308 = (select(0u, 1u, ((_e3280 * _e3175) > -((_e3280 * _e3150)))) < 2u);
if _e3308 {
} else {
break;
}
if (select(0u, 1u, ((_e3282 * _e3175) > -((_e3282 * _e3150)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3283 * _e3175) > -((_e3283 * _e3150)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3284 * _e3175) > -((_e3284 * _e3150)))) < 2u) {
} else {
break;
}
if _e3308 {
} else {
break;
}
if (select(0u, 1u, (_e3277 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3278 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3279 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3280 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3277 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3278 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3279 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3280 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3277 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3278 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3279 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3280 < 0f)) < 2u) {
} else {
break;
}
} else {
let _e3180 = select(1f, -1f, (-(_e3159) < 0f));
let _e3185 = ((_e3087 - _e3113) * _e3180);
let _e3186 = ((_e3113 - _e3135) * _e3180);
let _e3187 = ((_e3135 - _e3087) * _e3180);
let _e3188 = ((0f - 0f) * _e3180);
let _e3190 = (_e3153 * _e3180);
let _e3191 = (_e3156 * _e3180);
let _e3192 = ((_e3098 - _e3142) * _e3180);
if (select(0u, 1u, ((_e3185 * _e3175) > -((_e3185 * _e3150)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3186 * _e3175) > -((_e3186 * _e3150)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3187 * _e3175) > -((_e3187 * _e3150)))) < 2u) {
} else {
break;
}
let _e3216 = (select(0u, 1u, ((_e3188 * _e3175) > -((_e3188 * _e3150)))) < 2u);
if _e3216 {
} else {
break;
}
if (select(0u, 1u, ((_e3190 * _e3175) > -((_e3190 * _e3150)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3191 * _e3175) > -((_e3191 * _e3150)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3192 * _e3175) > -((_e3192 * _e3150)))) < 2u) {
} else {
break;
}
if _e3216 {
} else {
break;
}
if (select(0u, 1u, (_e3185 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3186 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3187 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3188 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3185 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3186 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3187 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3188 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3185 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3186 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3187 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3188 < 0f)) < 2u) {
} else {
break;
}
}
let _e3365 = select(1f, -1f, (((_e3151 * _e3155) - (_e3152 * _e3154)) < 0f));
let _e3369 = (0f - 0f);
let _e3370 = ((_e3087 - _e3113) * _e3365);
let _e3371 = ((_e3113 - _e3135) * _e3365);
let _e3372 = ((_e3135 - _e3087) * _e3365);
let _e3373 = (_e3369 * _e3365);
let _e3374 = (_e3076 - _e3128);
let _e3375 = (_e3151 * _e3365);
let _e3376 = (_e3154 * _e3365);
let _e3377 = (_e3374 * _e3365);
if (select(0u, 1u, ((_e3370 * _e3175) > -((_e3370 * _e3150)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3371 * _e3175) > -((_e3371 * _e3150)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3372 * _e3175) > -((_e3372 * _e3150)))) < 2u) {
} else {
break;
}
let _e3401 = (select(0u, 1u, ((_e3373 * _e3175) > -((_e3373 * _e3150)))) < 2u);
if _e3401 {
} else {
break;
}
if (select(0u, 1u, ((_e3375 * _e3175) > -((_e3375 * _e3150)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3376 * _e3175) > -((_e3376 * _e3150)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3377 * _e3175) > -((_e3377 * _e3150)))) < 2u) {
} else {
break;
}
if _e3401 {
} else {
break;
}
if (select(0u, 1u, (_e3370 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3371 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3372 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3373 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3370 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3371 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3372 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3373 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3370 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3371 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3372 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3373 < 0f)) < 2u) {
} else {
break;
}
let _e3457 = select(1f, -1f, (_e3177 < 0f));
let _e3463 = select(0f, (2f * _e3173), (bitcast<f32>((bitcast<u32>(_e3177) & 2147483647u)) <= _e3173));
let _e3467 = ((_e3098 - _e3120) * _e3457);
let _e3468 = ((_e3120 - _e3142) * _e3457);
let _e3469 = ((_e3142 - _e3098) * _e3457);
let _e3470 = (_e3369 * _e3457);
let _e3471 = (_e3151 * _e3457);
let _e3472 = (_e3154 * _e3457);
let _e3473 = (_e3374 * _e3457);
let _e3474 = (_e3467 * _e3175);
let _e3475 = (_e3468 * _e3175);
let _e3476 = (_e3469 * _e3175);
let _e3482 = -((_e3467 * _e3150));
let _e3483 = -((_e3468 * _e3150));
let _e3484 = -((_e3469 * _e3150));
local_97 = array<u32, 2>(0u, 4294967295u);
let _e3490 = select(0u, 1u, (_e3474 > _e3482));
if (_e3490 < 2u) {
} else {
break;
}
let _e3493 = local_97[_e3490];
local_98 = array<u32, 2>(0u, 4294967295u);
let _e3494 = select(0u, 1u, (_e3475 > _e3483));
if (_e3494 < 2u) {
} else {
break;
}
let _e3497 = local_98[_e3494];
local_99 = array<u32, 2>(0u, 4294967295u);
let _e3498 = select(0u, 1u, (_e3476 > _e3484));
if (_e3498 < 2u) {
} else {
break;
}
let _e3501 = local_99[_e3498];
let _e3503 = (select(0u, 1u, ((_e3470 * _e3175) > -((_e3470 * _e3150)))) < 2u);
if _e3503 {
} else {
break;
}
let _e3519 = (_e3471 * _e3175);
let _e3520 = (_e3472 * _e3175);
let _e3521 = (_e3473 * _e3175);
let _e3525 = -((_e3471 * _e3150));
let _e3526 = -((_e3472 * _e3150));
let _e3527 = -((_e3473 * _e3150));
local_94 = array<u32, 2>(0u, 4294967295u);
let _e3531 = select(0u, 1u, (_e3519 > _e3525));
if (_e3531 < 2u) {
} else {
break;
}
let _e3534 = local_94[_e3531];
local_95 = array<u32, 2>(0u, 4294967295u);
let _e3535 = select(0u, 1u, (_e3520 > _e3526));
if (_e3535 < 2u) {
} else {
break;
}
let _e3538 = local_95[_e3535];
local_96 = array<u32, 2>(0u, 4294967295u);
let _e3539 = select(0u, 1u, (_e3521 > _e3527));
if (_e3539 < 2u) {
} else {
break;
}
let _e3542 = local_96[_e3539];
if _e3503 {
} else {
break;
}
local_91 = array<u32, 2>(0u, 4294967295u);
let _e3568 = select(0u, 1u, (_e3467 == 0f));
if (_e3568 < 2u) {
} else {
break;
}
let _e3571 = local_91[_e3568];
local_92 = array<u32, 2>(0u, 4294967295u);
let _e3572 = select(0u, 1u, (_e3468 == 0f));
if (_e3572 < 2u) {
} else {
break;
}
let _e3575 = local_92[_e3572];
local_93 = array<u32, 2>(0u, 4294967295u);
let _e3576 = select(0u, 1u, (_e3469 == 0f));
if (_e3576 < 2u) {
} else {
break;
}
let _e3579 = local_93[_e3576];
if (select(0u, 1u, (_e3470 == 0f)) < 2u) {
} else {
break;
}
let _e3583 = ((_e3571 & 1u) != 0u);
let _e3586 = ((_e3575 & 1u) != 0u);
let _e3589 = ((_e3579 & 1u) != 0u);
let _e3591 = (-1f / select(_e3467, 1f, _e3583));
let _e3592 = (-1f / select(_e3468, 1f, _e3586));
let _e3593 = (-1f / select(_e3469, 1f, _e3589));
local_88 = array<u32, 2>(0u, 4294967295u);
let _e3598 = select(0u, 1u, (_e3467 > 0f));
if (_e3598 < 2u) {
} else {
break;
}
let _e3601 = local_88[_e3598];
local_89 = array<u32, 2>(0u, 4294967295u);
let _e3602 = select(0u, 1u, (_e3468 > 0f));
if (_e3602 < 2u) {
} else {
break;
}
let _e3605 = local_89[_e3602];
local_90 = array<u32, 2>(0u, 4294967295u);
let _e3606 = select(0u, 1u, (_e3469 > 0f));
if (_e3606 < 2u) {
} else {
break;
}
let _e3609 = local_90[_e3606];
if (select(0u, 1u, (_e3470 > 0f)) < 2u) {
} else {
break;
}
local_85 = array<u32, 2>(0u, 4294967295u);
let _e3616 = select(0u, 1u, (_e3467 < 0f));
if (_e3616 < 2u) {
} else {
break;
}
let _e3619 = local_85[_e3616];
local_86 = array<u32, 2>(0u, 4294967295u);
let _e3620 = select(0u, 1u, (_e3468 < 0f));
if (_e3620 < 2u) {
} else {
break;
}
let _e3623 = local_86[_e3620];
local_87 = array<u32, 2>(0u, 4294967295u);
let _e3624 = select(0u, 1u, (_e3469 < 0f));
if (_e3624 < 2u) {
} else {
break;
}
let _e3627 = local_87[_e3624];
if (select(0u, 1u, (_e3470 < 0f)) < 2u) {
} else {
break;
}
let _e3643 = ((_e3619 & 1u) != 0u);
let _e3646 = ((_e3623 & 1u) != 0u);
let _e3649 = ((_e3627 & 1u) != 0u);
phi_13627_ = _e913.member.member_1;
loop {
let _e3655 = phi_13627_;
let _e3656 = (_e3655 < _e913.member.member_2);
if _e3656 {
if _e3178 {
phi_13642_ = _e913.member_1.member_4.y;
} else {
phi_13642_ = _e913.member_1.member_4.z;
}
let _e3660 = phi_13642_;
phi_13644_ = 0i;
loop {
let _e3662 = phi_13644_;
let _e3663 = (_e3662 <= _e3660);
if _e3663 {
let _e3664 = select(_e3662, _e3655, _e3178);
let _e3666 = f32(_e3664);
let _e3668 = f32(_e913.member_1.member_4.x);
let _e3672 = ((_e3471 * _e3666) + (((select(_e3482, _e3474, ((_e3493 & 1u) != 0u)) - (_e3467 * _e3076)) + (select(_e3525, _e3519, ((_e3534 & 1u) != 0u)) - (_e3471 * _e3098))) + _e3463));
let _e3673 = ((_e3472 * _e3666) + (((select(_e3483, _e3475, ((_e3497 & 1u) != 0u)) - (_e3468 * _e3106)) + (select(_e3526, _e3520, ((_e3538 & 1u) != 0u)) - (_e3472 * _e3120))) + _e3463));
let _e3674 = ((_e3473 * _e3666) + (((select(_e3484, _e3476, ((_e3501 & 1u) != 0u)) - (_e3469 * _e3128)) + (select(_e3527, _e3521, ((_e3542 & 1u) != 0u)) - (_e3473 * _e3142))) + _e3463));
let _e3675 = (_e3672 * select(0f, _e3591, ((_e3601 & 1u) != 0u)));
let _e3676 = (_e3673 * select(0f, _e3592, ((_e3605 & 1u) != 0u)));
let _e3677 = (_e3674 * select(0f, _e3593, ((_e3609 & 1u) != 0u)));
let _e3681 = ((_e3672 * select(select(0f, 1e20f, _e3583), _e3591, _e3643)) + select(_e3174, 0f, _e3643));
let _e3682 = ((_e3673 * select(select(0f, 1e20f, _e3586), _e3592, _e3646)) + select(_e3174, 0f, _e3646));
let _e3683 = ((_e3674 * select(select(0f, 1e20f, _e3589), _e3593, _e3649)) + select(_e3174, 0f, _e3649));
let _e3685 = select(_e3675, 0f, (0f > _e3675));
let _e3687 = select(_e3677, _e3676, (_e3676 > _e3677));
let _e3691 = select(_e3681, _e3668, (_e3668 < _e3681));
let _e3693 = select(_e3683, _e3682, (_e3682 < _e3683));
let _e3695 = select(_e3693, _e3691, (_e3691 < _e3693));
let _e3696 = -(select(_e3687, _e3685, (_e3685 > _e3687)));
let _e3698 = (-(_e3668) - 1f);
let _e3700 = select(_e3698, _e3696, (_e3696 > _e3698));
let _e3702 = select(0f, _e3700, (_e3700 < 0f));
let _e3709 = select(0i, select(select(i32(_e3702), i32(-2147483648), (_e3702 < -2147483600f)), 2147483647i, (_e3702 > 2147483500f)), (_e3702 == _e3702));
let _e3714 = -((_e3709 - select(0i, 1i, (_e3702 < f32(_e3709)))));
let _e3716 = select(-1f, _e3695, (_e3695 > -1f));
let _e3718 = select(_e3668, _e3716, (_e3716 < _e3668));
let _e3725 = select(0i, select(select(i32(_e3718), i32(-2147483648), (_e3718 < -2147483600f)), 2147483647i, (_e3718 > 2147483500f)), (_e3718 == _e3718));
let _e3729 = (_e3725 - select(0i, 1i, (_e3718 < f32(_e3725))));
if (_e3714 <= _e3729) {
let _e3735 = global_1.member.member_1[1u];
let _e3743 = global_1.member.member_1[3u];
let _e3746 = (_e913.member_1.member_3.x + _e3714);
let _e3747 = (_e913.member_1.member_3.x + _e3729);
let _e3749 = (_e3746 >> bitcast<u32>(5i));
phi_13781_ = _e3749;
loop {
let _e3751 = phi_13781_;
let _e3753 = (_e3747 >> bitcast<u32>(5i));
let _e3754 = (_e3751 <= _e3753);
if _e3754 {
if (_e3751 == _e3749) {
phi_13800_ = (4294967295u << bitcast<u32>((bitcast<u32>((_e3746 & 31i)) & 31u)));
} else {
phi_13800_ = 4294967295u;
}
let _e3762 = phi_13800_;
if (_e3751 == _e3753) {
phi_13811_ = (4294967295u >> bitcast<u32>((bitcast<u32>((31i - (_e3747 & 31i))) & 31u)));
} else {
phi_13811_ = 4294967295u;
}
let _e3771 = phi_13811_;
let _e3773 = bitcast<u32>(((((((_e913.member_1.member_3.z + _e3664) * bitcast<i32>(_e3735)) + _e913.member_1.member_3.y) + select(_e3655, _e3662, _e3178)) * bitcast<i32>(_e3743)) + _e3751));
if (_e3773 < _e198) {
let _e3778 = atomicOr((&global_2.member[_e3773]), (_e3762 & _e3771));
}
phi_13782_ = (_e3751 + 1i);
} else {
phi_13782_ = i32();
}
let _e3781 = phi_13782_;
continue;
continuing {
phi_13781_ = _e3781;
break if !(_e3754);
}
}
}
phi_13645_ = (_e3662 + 1i);
} else {
phi_13645_ = i32();
}
let _e3785 = phi_13645_;
continue;
continuing {
phi_13644_ = _e3785;
break if !(_e3663);
}
}
phi_13628_ = (_e3655 + 1i);
} else {
phi_13628_ = i32();
}
let _e3789 = phi_13628_;
continue;
continuing {
phi_13627_ = _e3789;
break if !(_e3656);
}
}
} else {
if (_e939 == 3u) {
let _e2312 = (_e913.member_1.member_6 & 31u);
let _e2314 = (_e913.member_1.member_3.x << bitcast<u32>(_e2312));
let _e2317 = (_e913.member_1.member_7 & 31u);
let _e2321 = ((1i << bitcast<u32>(_e2317)) >> bitcast<u32>(1i));
let _e2327 = bitcast<i32>(_e913.member_1.member_6);
let _e2333 = bitcast<f32>((bitcast<u32>((127i + (bitcast<i32>(_e913.member_1.member_7) - _e2327))) << bitcast<u32>(23i)));
let _e2334 = (f32((((_e913.member_1.member.x - _e2314) + _e2321) >> bitcast<u32>(_e2317))) * _e2333);
let _e2339 = (_e913.member_1.member_3.y << bitcast<u32>(_e2312));
let _e2345 = (f32((((_e913.member_1.member.y - _e2339) + _e2321) >> bitcast<u32>(_e2317))) * _e2333);
let _e2350 = (_e913.member_1.member_3.z << bitcast<u32>(_e2312));
let _e2356 = (f32((((_e913.member_1.member.z - _e2350) + _e2321) >> bitcast<u32>(_e2317))) * _e2333);
let _e2364 = (f32((((_e913.member_1.member_1.x - _e2314) + _e2321) >> bitcast<u32>(_e2317))) * _e2333);
let _e2371 = (f32((((_e913.member_1.member_1.y - _e2339) + _e2321) >> bitcast<u32>(_e2317))) * _e2333);
let _e2378 = (f32((((_e913.member_1.member_1.z - _e2350) + _e2321) >> bitcast<u32>(_e2317))) * _e2333);
let _e2386 = (f32((((_e913.member_1.member_2.x - _e2314) + _e2321) >> bitcast<u32>(_e2317))) * _e2333);
let _e2393 = (f32((((_e913.member_1.member_2.y - _e2339) + _e2321) >> bitcast<u32>(_e2317))) * _e2333);
let _e2400 = (f32((((_e913.member_1.member_2.z - _e2350) + _e2321) >> bitcast<u32>(_e2317))) * _e2333);
let _e2408 = (f32(_e913.member_1.member_5) * bitcast<f32>((bitcast<u32>((127i - _e2327)) << bitcast<u32>(23i))));
let _e2409 = (_e2364 - _e2334);
let _e2410 = (_e2371 - _e2345);
let _e2411 = (_e2378 - _e2356);
let _e2412 = (_e2386 - _e2364);
let _e2413 = (_e2393 - _e2371);
let _e2414 = (_e2400 - _e2378);
let _e2417 = ((_e2410 * _e2414) - (_e2411 * _e2413));
let _e2421 = (_e2409 * _e2413);
let _e2422 = (_e2410 * _e2412);
let _e2423 = (_e2421 - _e2422);
let _e2431 = ((bitcast<f32>((bitcast<u32>(_e2421) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2422) & 2147483647u))) * 2.3841858e-7f);
let _e2432 = f32(_e913.member_1.member_4.x);
let _e2433 = (1f + _e2408);
let _e2436 = (_e913.member_1.member_4.z >= _e913.member_1.member_4.y);
if _e2436 {
let _e2530 = select(1f, -1f, (_e2417 < 0f));
let _e2535 = ((_e2356 - _e2378) * _e2530);
let _e2536 = ((_e2378 - _e2400) * _e2530);
let _e2537 = ((_e2400 - _e2356) * _e2530);
let _e2538 = ((0f - 0f) * _e2530);
let _e2540 = (_e2410 * _e2530);
let _e2541 = (_e2413 * _e2530);
let _e2542 = ((_e2345 - _e2393) * _e2530);
if (select(0u, 1u, ((_e2535 * _e2433) > -((_e2535 * _e2408)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e2536 * _e2433) > -((_e2536 * _e2408)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e2537 * _e2433) > -((_e2537 * _e2408)))) < 2u) {
} else {
break;
}
let _e2566 = (select(0u, 1u, ((_e2538 * _e2433) > -((_e2538 * _e2408)))) < 2u);
if _e2566 {
} else {
break;
}
if (select(0u, 1u, ((_e2540 * _e2433) > -((_e2540 * _e2408)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e2541 * _e2433) > -((_e2541 * _e2408)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e2542 * _e2433) > -((_e2542 * _e2408)))) < 2u) {
} else {
break;
}
if _e2566 {
} else {
break;
}
if (select(0u, 1u, (_e2535 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2536 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2537 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2538 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2535 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2536 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2537 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2538 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2535 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2536 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2537 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2538 < 0f)) < 2u) {
} else {
break;
}
} else {
let _e2438 = select(1f, -1f, (-(_e2417) < 0f));
let _e2443 = ((_e2345 - _e2371) * _e2438);
let _e2444 = ((_e2371 - _e2393) * _e2438);
let _e2445 = ((_e2393 - _e2345) * _e2438);
let _e2446 = ((0f - 0f) * _e2438);
let _e2448 = (_e2411 * _e2438);
let _e2449 = (_e2414 * _e2438);
let _e2450 = ((_e2356 - _e2400) * _e2438);
if (select(0u, 1u, ((_e2443 * _e2433) > -((_e2443 * _e2408)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e2444 * _e2433) > -((_e2444 * _e2408)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e2445 * _e2433) > -((_e2445 * _e2408)))) < 2u) {
} else {
break;
}
let _e2474 = (select(0u, 1u, ((_e2446 * _e2433) > -((_e2446 * _e2408)))) < 2u);
if _e2474 {
} else {
break;
}
if (select(0u, 1u, ((_e2448 * _e2433) > -((_e2448 * _e2408)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e2449 * _e2433) > -((_e2449 * _e2408)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e2450 * _e2433) > -((_e2450 * _e2408)))) < 2u) {
} else {
break;
}
if _e2474 {
} else {
break;
}
if (select(0u, 1u, (_e2443 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2444 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2445 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2446 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2443 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2444 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2445 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2446 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2443 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2444 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2445 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2446 < 0f)) < 2u) {
} else {
break;
}
}
let _e2623 = select(1f, -1f, (_e2423 < 0f));
let _e2629 = select(0f, (2f * _e2431), (bitcast<f32>((bitcast<u32>(_e2423) & 2147483647u)) <= _e2431));
let _e2633 = (0f - 0f);
let _e2634 = ((_e2345 - _e2371) * _e2623);
let _e2635 = ((_e2371 - _e2393) * _e2623);
let _e2636 = ((_e2393 - _e2345) * _e2623);
let _e2637 = (_e2633 * _e2623);
let _e2638 = (_e2334 - _e2386);
let _e2639 = (_e2409 * _e2623);
let _e2640 = (_e2412 * _e2623);
let _e2641 = (_e2638 * _e2623);
let _e2642 = (_e2634 * _e2433);
let _e2643 = (_e2635 * _e2433);
let _e2644 = (_e2636 * _e2433);
let _e2650 = -((_e2634 * _e2408));
let _e2651 = -((_e2635 * _e2408));
let _e2652 = -((_e2636 * _e2408));
local_82 = array<u32, 2>(0u, 4294967295u);
let _e2658 = select(0u, 1u, (_e2642 > _e2650));
if (_e2658 < 2u) {
} else {
break;
}
let _e2661 = local_82[_e2658];
local_83 = array<u32, 2>(0u, 4294967295u);
let _e2662 = select(0u, 1u, (_e2643 > _e2651));
if (_e2662 < 2u) {
} else {
break;
}
let _e2665 = local_83[_e2662];
local_84 = array<u32, 2>(0u, 4294967295u);
let _e2666 = select(0u, 1u, (_e2644 > _e2652));
if (_e2666 < 2u) {
} else {
break;
}
let _e2669 = local_84[_e2666];
let _e2671 = (select(0u, 1u, ((_e2637 * _e2433) > -((_e2637 * _e2408)))) < 2u);
if _e2671 {
} else {
break;
}
let _e2687 = (_e2639 * _e2433);
let _e2688 = (_e2640 * _e2433);
let _e2689 = (_e2641 * _e2433);
let _e2693 = -((_e2639 * _e2408));
let _e2694 = -((_e2640 * _e2408));
let _e2695 = -((_e2641 * _e2408));
local_79 = array<u32, 2>(0u, 4294967295u);
let _e2699 = select(0u, 1u, (_e2687 > _e2693));
if (_e2699 < 2u) {
} else {
break;
}
let _e2702 = local_79[_e2699];
local_80 = array<u32, 2>(0u, 4294967295u);
let _e2703 = select(0u, 1u, (_e2688 > _e2694));
if (_e2703 < 2u) {
} else {
break;
}
let _e2706 = local_80[_e2703];
local_81 = array<u32, 2>(0u, 4294967295u);
let _e2707 = select(0u, 1u, (_e2689 > _e2695));
if (_e2707 < 2u) {
} else {
break;
}
let _e2710 = local_81[_e2707];
if _e2671 {
} else {
break;
}
local_76 = array<u32, 2>(0u, 4294967295u);
let _e2736 = select(0u, 1u, (_e2634 == 0f));
if (_e2736 < 2u) {
} else {
break;
}
let _e2739 = local_76[_e2736];
local_77 = array<u32, 2>(0u, 4294967295u);
let _e2740 = select(0u, 1u, (_e2635 == 0f));
if (_e2740 < 2u) {
} else {
break;
}
let _e2743 = local_77[_e2740];
local_78 = array<u32, 2>(0u, 4294967295u);
let _e2744 = select(0u, 1u, (_e2636 == 0f));
if (_e2744 < 2u) {
} else {
break;
}
let _e2747 = local_78[_e2744];
if (select(0u, 1u, (_e2637 == 0f)) < 2u) {
} else {
break;
}
let _e2751 = ((_e2739 & 1u) != 0u);
let _e2754 = ((_e2743 & 1u) != 0u);
let _e2757 = ((_e2747 & 1u) != 0u);
let _e2759 = (-1f / select(_e2634, 1f, _e2751));
let _e2760 = (-1f / select(_e2635, 1f, _e2754));
let _e2761 = (-1f / select(_e2636, 1f, _e2757));
local_73 = array<u32, 2>(0u, 4294967295u);
let _e2766 = select(0u, 1u, (_e2634 > 0f));
if (_e2766 < 2u) {
} else {
break;
}
let _e2769 = local_73[_e2766];
local_74 = array<u32, 2>(0u, 4294967295u);
let _e2770 = select(0u, 1u, (_e2635 > 0f));
if (_e2770 < 2u) {
} else {
break;
}
let _e2773 = local_74[_e2770];
local_75 = array<u32, 2>(0u, 4294967295u);
let _e2774 = select(0u, 1u, (_e2636 > 0f));
if (_e2774 < 2u) {
} else {
break;
}
let _e2777 = local_75[_e2774];
if (select(0u, 1u, (_e2637 > 0f)) < 2u) {
} else {
break;
}
local_70 = array<u32, 2>(0u, 4294967295u);
let _e2784 = select(0u, 1u, (_e2634 < 0f));
if (_e2784 < 2u) {
} else {
break;
}
let _e2787 = local_70[_e2784];
local_71 = array<u32, 2>(0u, 4294967295u);
let _e2788 = select(0u, 1u, (_e2635 < 0f));
if (_e2788 < 2u) {
} else {
break;
}
let _e2791 = local_71[_e2788];
local_72 = array<u32, 2>(0u, 4294967295u);
let _e2792 = select(0u, 1u, (_e2636 < 0f));
if (_e2792 < 2u) {
} else {
break;
}
let _e2795 = local_72[_e2792];
if (select(0u, 1u, (_e2637 < 0f)) < 2u) {
} else {
break;
}
let _e2811 = ((_e2787 & 1u) != 0u);
let _e2814 = ((_e2791 & 1u) != 0u);
let _e2817 = ((_e2795 & 1u) != 0u);
let _e2823 = select(1f, -1f, (-(((_e2411 * _e2412) - (_e2409 * _e2414))) < 0f));
let _e2827 = ((_e2356 - _e2378) * _e2823);
let _e2828 = ((_e2378 - _e2400) * _e2823);
let _e2829 = ((_e2400 - _e2356) * _e2823);
let _e2830 = (_e2633 * _e2823);
let _e2831 = (_e2409 * _e2823);
let _e2832 = (_e2412 * _e2823);
let _e2833 = (_e2638 * _e2823);
if (select(0u, 1u, ((_e2827 * _e2433) > -((_e2827 * _e2408)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e2828 * _e2433) > -((_e2828 * _e2408)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e2829 * _e2433) > -((_e2829 * _e2408)))) < 2u) {
} else {
break;
}
let _e2857 = (select(0u, 1u, ((_e2830 * _e2433) > -((_e2830 * _e2408)))) < 2u);
if _e2857 {
} else {
break;
}
if (select(0u, 1u, ((_e2831 * _e2433) > -((_e2831 * _e2408)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e2832 * _e2433) > -((_e2832 * _e2408)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e2833 * _e2433) > -((_e2833 * _e2408)))) < 2u) {
} else {
break;
}
if _e2857 {
} else {
break;
}
if (select(0u, 1u, (_e2827 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2828 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2829 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2830 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2827 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2828 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2829 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2830 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2827 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2828 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2829 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2830 < 0f)) < 2u) {
} else {
break;
}
phi_17544_ = _e913.member.member_1;
loop {
let _e2913 = phi_17544_;
let _e2914 = (_e2913 < _e913.member.member_2);
if _e2914 {
if _e2436 {
phi_17559_ = _e913.member_1.member_4.y;
} else {
phi_17559_ = _e913.member_1.member_4.z;
}
let _e2918 = phi_17559_;
phi_17561_ = 0i;
loop {
let _e2920 = phi_17561_;
let _e2921 = (_e2920 <= _e2918);
if _e2921 {
let _e2923 = select(_e2913, _e2920, _e2436);
let _e2924 = f32(_e2923);
let _e2926 = f32(_e913.member_1.member_4.x);
let _e2930 = ((_e2639 * _e2924) + (((select(_e2650, _e2642, ((_e2661 & 1u) != 0u)) - (_e2634 * _e2334)) + (select(_e2693, _e2687, ((_e2702 & 1u) != 0u)) - (_e2639 * _e2345))) + _e2629));
let _e2931 = ((_e2640 * _e2924) + (((select(_e2651, _e2643, ((_e2665 & 1u) != 0u)) - (_e2635 * _e2364)) + (select(_e2694, _e2688, ((_e2706 & 1u) != 0u)) - (_e2640 * _e2371))) + _e2629));
let _e2932 = ((_e2641 * _e2924) + (((select(_e2652, _e2644, ((_e2669 & 1u) != 0u)) - (_e2636 * _e2386)) + (select(_e2695, _e2689, ((_e2710 & 1u) != 0u)) - (_e2641 * _e2393))) + _e2629));
let _e2933 = (_e2930 * select(0f, _e2759, ((_e2769 & 1u) != 0u)));
let _e2934 = (_e2931 * select(0f, _e2760, ((_e2773 & 1u) != 0u)));
let _e2935 = (_e2932 * select(0f, _e2761, ((_e2777 & 1u) != 0u)));
let _e2939 = ((_e2930 * select(select(0f, 1e20f, _e2751), _e2759, _e2811)) + select(_e2432, 0f, _e2811));
let _e2940 = ((_e2931 * select(select(0f, 1e20f, _e2754), _e2760, _e2814)) + select(_e2432, 0f, _e2814));
let _e2941 = ((_e2932 * select(select(0f, 1e20f, _e2757), _e2761, _e2817)) + select(_e2432, 0f, _e2817));
let _e2943 = select(_e2933, 0f, (0f > _e2933));
let _e2945 = select(_e2935, _e2934, (_e2934 > _e2935));
let _e2949 = select(_e2939, _e2926, (_e2926 < _e2939));
let _e2951 = select(_e2941, _e2940, (_e2940 < _e2941));
let _e2953 = select(_e2951, _e2949, (_e2949 < _e2951));
let _e2954 = -(select(_e2945, _e2943, (_e2943 > _e2945)));
let _e2956 = (-(_e2926) - 1f);
let _e2958 = select(_e2956, _e2954, (_e2954 > _e2956));
let _e2960 = select(0f, _e2958, (_e2958 < 0f));
let _e2967 = select(0i, select(select(i32(_e2960), i32(-2147483648), (_e2960 < -2147483600f)), 2147483647i, (_e2960 > 2147483500f)), (_e2960 == _e2960));
let _e2972 = -((_e2967 - select(0i, 1i, (_e2960 < f32(_e2967)))));
let _e2974 = select(-1f, _e2953, (_e2953 > -1f));
let _e2976 = select(_e2926, _e2974, (_e2974 < _e2926));
let _e2983 = select(0i, select(select(i32(_e2976), i32(-2147483648), (_e2976 < -2147483600f)), 2147483647i, (_e2976 > 2147483500f)), (_e2976 == _e2976));
let _e2987 = (_e2983 - select(0i, 1i, (_e2976 < f32(_e2983))));
if (_e2972 <= _e2987) {
let _e2993 = global_1.member.member_1[1u];
let _e3001 = global_1.member.member_1[3u];
let _e3004 = (_e913.member_1.member_3.x + _e2972);
let _e3005 = (_e913.member_1.member_3.x + _e2987);
let _e3007 = (_e3004 >> bitcast<u32>(5i));
phi_17698_ = _e3007;
loop {
let _e3009 = phi_17698_;
let _e3011 = (_e3005 >> bitcast<u32>(5i));
let _e3012 = (_e3009 <= _e3011);
if _e3012 {
if (_e3009 == _e3007) {
phi_17717_ = (4294967295u << bitcast<u32>((bitcast<u32>((_e3004 & 31i)) & 31u)));
} else {
phi_17717_ = 4294967295u;
}
let _e3020 = phi_17717_;
if (_e3009 == _e3011) {
phi_17728_ = (4294967295u >> bitcast<u32>((bitcast<u32>((31i - (_e3005 & 31i))) & 31u)));
} else {
phi_17728_ = 4294967295u;
}
let _e3029 = phi_17728_;
let _e3031 = bitcast<u32>(((((((_e913.member_1.member_3.z + select(_e2920, _e2913, _e2436)) * bitcast<i32>(_e2993)) + _e913.member_1.member_3.y) + _e2923) * bitcast<i32>(_e3001)) + _e3009));
if (_e3031 < _e198) {
let _e3036 = atomicOr((&global_2.member[_e3031]), (_e3020 & _e3029));
}
phi_17699_ = (_e3009 + 1i);
} else {
phi_17699_ = i32();
}
let _e3039 = phi_17699_;
continue;
continuing {
phi_17698_ = _e3039;
break if !(_e3012);
}
}
}
phi_17562_ = (_e2920 + 1i);
} else {
phi_17562_ = i32();
}
let _e3043 = phi_17562_;
continue;
continuing {
phi_17561_ = _e3043;
break if !(_e2921);
}
}
phi_17545_ = (_e2913 + 1i);
} else {
phi_17545_ = i32();
}
let _e3047 = phi_17545_;
continue;
continuing {
phi_17544_ = _e3047;
break if !(_e2914);
}
}
} else {
let _e949 = (_e913.member_1.member_6 & 31u);
let _e951 = (_e913.member_1.member_3.x << bitcast<u32>(_e949));
let _e954 = (_e913.member_1.member_7 & 31u);
let _e958 = ((1i << bitcast<u32>(_e954)) >> bitcast<u32>(1i));
let _e964 = bitcast<i32>(_e913.member_1.member_6);
let _e970 = bitcast<f32>((bitcast<u32>((127i + (bitcast<i32>(_e913.member_1.member_7) - _e964))) << bitcast<u32>(23i)));
let _e971 = (f32((((_e913.member_1.member.x - _e951) + _e958) >> bitcast<u32>(_e954))) * _e970);
let _e976 = (_e913.member_1.member_3.y << bitcast<u32>(_e949));
let _e982 = (f32((((_e913.member_1.member.y - _e976) + _e958) >> bitcast<u32>(_e954))) * _e970);
let _e987 = (_e913.member_1.member_3.z << bitcast<u32>(_e949));
let _e993 = (f32((((_e913.member_1.member.z - _e987) + _e958) >> bitcast<u32>(_e954))) * _e970);
let _e1001 = (f32((((_e913.member_1.member_1.x - _e951) + _e958) >> bitcast<u32>(_e954))) * _e970);
let _e1008 = (f32((((_e913.member_1.member_1.y - _e976) + _e958) >> bitcast<u32>(_e954))) * _e970);
let _e1015 = (f32((((_e913.member_1.member_1.z - _e987) + _e958) >> bitcast<u32>(_e954))) * _e970);
let _e1023 = (f32((((_e913.member_1.member_2.x - _e951) + _e958) >> bitcast<u32>(_e954))) * _e970);
let _e1030 = (f32((((_e913.member_1.member_2.y - _e976) + _e958) >> bitcast<u32>(_e954))) * _e970);
let _e1037 = (f32((((_e913.member_1.member_2.z - _e987) + _e958) >> bitcast<u32>(_e954))) * _e970);
let _e1045 = (f32(_e913.member_1.member_5) * bitcast<f32>((bitcast<u32>((127i - _e964)) << bitcast<u32>(23i))));
let _e1046 = (_e1001 - _e971);
let _e1047 = (_e1008 - _e982);
let _e1048 = (_e1015 - _e993);
let _e1049 = (_e1023 - _e1001);
let _e1050 = (_e1030 - _e1008);
let _e1051 = (_e1037 - _e1015);
let _e1052 = (_e1047 * _e1051);
let _e1053 = (_e1048 * _e1050);
let _e1054 = (_e1052 - _e1053);
let _e1055 = (_e1048 * _e1049);
let _e1056 = (_e1046 * _e1051);
let _e1057 = (_e1055 - _e1056);
let _e1058 = (_e1046 * _e1050);
let _e1059 = (_e1047 * _e1049);
let _e1060 = (_e1058 - _e1059);
let _e1068 = ((bitcast<f32>((bitcast<u32>(_e1052) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1053) & 2147483647u))) * 2.3841858e-7f);
let _e1076 = ((bitcast<f32>((bitcast<u32>(_e1055) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1056) & 2147483647u))) * 2.3841858e-7f);
let _e1084 = ((bitcast<f32>((bitcast<u32>(_e1058) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1059) & 2147483647u))) * 2.3841858e-7f);
let _e1085 = f32(_e913.member_1.member_4.x);
let _e1086 = f32(_e913.member_1.member_4.y);
let _e1087 = f32(_e913.member_1.member_4.z);
let _e1089 = select(_e1086, _e1085, (_e1085 > _e1086));
let _e1095 = (((_e1068 + _e1076) + _e1084) * (select(_e1087, _e1089, (_e1089 > _e1087)) + 2f));
let _e1100 = (((_e1054 * _e971) + (_e1057 * _e982)) + (_e1060 * _e993));
let _e1101 = (1f + _e1045);
let _e1102 = (_e1054 * _e1101);
let _e1104 = -((_e1054 * _e1045));
let _e1107 = (_e1057 * _e1101);
let _e1109 = -((_e1057 * _e1045));
let _e1113 = (_e1060 * _e1101);
let _e1115 = -((_e1060 * _e1045));
let _e1119 = -(_e1054);
let _e1120 = (_e1119 * _e1101);
let _e1122 = -((_e1119 * _e1045));
let _e1125 = -(_e1057);
let _e1126 = (_e1125 * _e1101);
let _e1128 = -((_e1125 * _e1045));
let _e1132 = -(_e1060);
let _e1133 = (_e1132 * _e1101);
let _e1135 = -((_e1132 * _e1045));
let _e1139 = (_e913.member_1.member_4.z >= _e913.member_1.member_4.y);
if _e1139 {
let _e1380 = select(1f, -1f, (_e1054 < 0f));
let _e1386 = select(0f, (2f * _e1068), (bitcast<f32>((bitcast<u32>(_e1054) & 2147483647u)) <= _e1068));
let _e1391 = ((_e993 - _e1015) * _e1380);
let _e1392 = ((_e1015 - _e1037) * _e1380);
let _e1393 = ((_e1037 - _e993) * _e1380);
let _e1394 = ((0f - 0f) * _e1380);
let _e1396 = (_e1047 * _e1380);
let _e1397 = (_e1050 * _e1380);
let _e1398 = ((_e982 - _e1030) * _e1380);
let _e1400 = (_e1391 * _e1101);
let _e1401 = (_e1392 * _e1101);
let _e1402 = (_e1393 * _e1101);
let _e1403 = (_e1394 * _e1101);
let _e1408 = -((_e1391 * _e1045));
let _e1409 = -((_e1392 * _e1045));
let _e1410 = -((_e1393 * _e1045));
let _e1411 = -((_e1394 * _e1045));
local_66 = array<u32, 2>(0u, 4294967295u);
let _e1416 = select(0u, 1u, (_e1400 > _e1408));
if (_e1416 < 2u) {
} else {
break;
}
let _e1419 = local_66[_e1416];
local_67 = array<u32, 2>(0u, 4294967295u);
let _e1420 = select(0u, 1u, (_e1401 > _e1409));
if (_e1420 < 2u) {
} else {
break;
}
let _e1423 = local_67[_e1420];
local_68 = array<u32, 2>(0u, 4294967295u);
let _e1424 = select(0u, 1u, (_e1402 > _e1410));
if (_e1424 < 2u) {
} else {
break;
}
let _e1427 = local_68[_e1424];
local_69 = array<u32, 2>(0u, 4294967295u);
let _e1428 = select(0u, 1u, (_e1403 > _e1411));
let _e1429 = (_e1428 < 2u);
if _e1429 {
} else {
break;
}
let _e1431 = local_69[_e1428];
let _e1447 = (_e1394 * 0f);
let _e1452 = (_e1396 * _e1101);
let _e1453 = (_e1397 * _e1101);
let _e1454 = (_e1398 * _e1101);
let _e1458 = -((_e1396 * _e1045));
let _e1459 = -((_e1397 * _e1045));
let _e1460 = -((_e1398 * _e1045));
local_62 = array<u32, 2>(0u, 4294967295u);
let _e1464 = select(0u, 1u, (_e1452 > _e1458));
if (_e1464 < 2u) {
} else {
break;
}
let _e1467 = local_62[_e1464];
local_63 = array<u32, 2>(0u, 4294967295u);
let _e1468 = select(0u, 1u, (_e1453 > _e1459));
if (_e1468 < 2u) {
} else {
break;
}
let _e1471 = local_63[_e1468];
local_64 = array<u32, 2>(0u, 4294967295u);
let _e1472 = select(0u, 1u, (_e1454 > _e1460));
if (_e1472 < 2u) {
} else {
break;
}
let _e1475 = local_64[_e1472];
local_65 = array<u32, 2>(0u, 4294967295u);
if _e1429 {
} else {
break;
}
let _e1477 = local_65[_e1428];
local_58 = array<u32, 2>(0u, 4294967295u);
let _e1510 = select(0u, 1u, (_e1391 == 0f));
if (_e1510 < 2u) {
} else {
break;
}
let _e1513 = local_58[_e1510];
local_59 = array<u32, 2>(0u, 4294967295u);
let _e1514 = select(0u, 1u, (_e1392 == 0f));
if (_e1514 < 2u) {
} else {
break;
}
let _e1517 = local_59[_e1514];
local_60 = array<u32, 2>(0u, 4294967295u);
let _e1518 = select(0u, 1u, (_e1393 == 0f));
if (_e1518 < 2u) {
} else {
break;
}
let _e1521 = local_60[_e1518];
local_61 = array<u32, 2>(0u, 4294967295u);
let _e1522 = select(0u, 1u, (_e1394 == 0f));
if (_e1522 < 2u) {
} else {
break;
}
let _e1525 = local_61[_e1522];
let _e1527 = ((_e1513 & 1u) != 0u);
let _e1530 = ((_e1517 & 1u) != 0u);
let _e1533 = ((_e1521 & 1u) != 0u);
let _e1536 = ((_e1525 & 1u) != 0u);
let _e1538 = (-1f / select(_e1391, 1f, _e1527));
let _e1539 = (-1f / select(_e1392, 1f, _e1530));
let _e1540 = (-1f / select(_e1393, 1f, _e1533));
let _e1541 = (-1f / select(_e1394, 1f, _e1536));
local_54 = array<u32, 2>(0u, 4294967295u);
let _e1546 = select(0u, 1u, (_e1391 > 0f));
if (_e1546 < 2u) {
} else {
break;
}
let _e1549 = local_54[_e1546];
local_55 = array<u32, 2>(0u, 4294967295u);
let _e1550 = select(0u, 1u, (_e1392 > 0f));
if (_e1550 < 2u) {
} else {
break;
}
let _e1553 = local_55[_e1550];
local_56 = array<u32, 2>(0u, 4294967295u);
let _e1554 = select(0u, 1u, (_e1393 > 0f));
if (_e1554 < 2u) {
} else {
break;
}
let _e1557 = local_56[_e1554];
local_57 = array<u32, 2>(0u, 4294967295u);
let _e1558 = select(0u, 1u, (_e1394 > 0f));
if (_e1558 < 2u) {
} else {
break;
}
let _e1561 = local_57[_e1558];
local_50 = array<u32, 2>(0u, 4294967295u);
let _e1566 = select(0u, 1u, (_e1391 < 0f));
if (_e1566 < 2u) {
} else {
break;
}
let _e1569 = local_50[_e1566];
local_51 = array<u32, 2>(0u, 4294967295u);
let _e1570 = select(0u, 1u, (_e1392 < 0f));
if (_e1570 < 2u) {
} else {
break;
}
let _e1573 = local_51[_e1570];
local_52 = array<u32, 2>(0u, 4294967295u);
let _e1574 = select(0u, 1u, (_e1393 < 0f));
if (_e1574 < 2u) {
} else {
break;
}
let _e1577 = local_52[_e1574];
local_53 = array<u32, 2>(0u, 4294967295u);
let _e1578 = select(0u, 1u, (_e1394 < 0f));
if (_e1578 < 2u) {
} else {
break;
}
let _e1581 = local_53[_e1578];
let _e1600 = ((_e1569 & 1u) != 0u);
let _e1603 = ((_e1573 & 1u) != 0u);
let _e1606 = ((_e1577 & 1u) != 0u);
let _e1609 = ((_e1581 & 1u) != 0u);
phi_19778_ = type_16(vec4<f32>(_e1396, _e1397, _e1398, _e1394), vec4<f32>((((select(_e1408, _e1400, ((_e1419 & 1u) != 0u)) - (_e1391 * _e982)) + (select(_e1458, _e1452, ((_e1467 & 1u) != 0u)) - (_e1396 * _e993))) + _e1386), (((select(_e1409, _e1401, ((_e1423 & 1u) != 0u)) - (_e1392 * _e1008)) + (select(_e1459, _e1453, ((_e1471 & 1u) != 0u)) - (_e1397 * _e1015))) + _e1386), (((select(_e1410, _e1402, ((_e1427 & 1u) != 0u)) - (_e1393 * _e1030)) + (select(_e1460, _e1454, ((_e1475 & 1u) != 0u)) - (_e1398 * _e1037))) + _e1386), (((select(_e1411, _e1403, ((_e1431 & 1u) != 0u)) - _e1447) + (select(_e1411, _e1403, ((_e1477 & 1u) != 0u)) - _e1447)) + _e1386)), vec4<f32>(select(0f, _e1538, ((_e1549 & 1u) != 0u)), select(0f, _e1539, ((_e1553 & 1u) != 0u)), select(0f, _e1540, ((_e1557 & 1u) != 0u)), select(0f, _e1541, ((_e1561 & 1u) != 0u))), vec4<f32>(select(select(0f, 1e20f, _e1527), _e1538, _e1600), select(select(0f, 1e20f, _e1530), _e1539, _e1603), select(select(0f, 1e20f, _e1533), _e1540, _e1606), select(select(0f, 1e20f, _e1536), _e1541, _e1609)), vec4<f32>(select(_e1086, 0f, _e1600), select(_e1086, 0f, _e1603), select(_e1086, 0f, _e1606), select(_e1086, 0f, _e1609)));
} else {
let _e1141 = select(1f, -1f, (_e1119 < 0f));
let _e1147 = select(0f, (2f * _e1068), (bitcast<f32>((bitcast<u32>(_e1119) & 2147483647u)) <= _e1068));
let _e1152 = ((_e982 - _e1008) * _e1141);
let _e1153 = ((_e1008 - _e1030) * _e1141);
let _e1154 = ((_e1030 - _e982) * _e1141);
let _e1155 = ((0f - 0f) * _e1141);
let _e1157 = (_e1048 * _e1141);
let _e1158 = (_e1051 * _e1141);
let _e1159 = ((_e993 - _e1037) * _e1141);
let _e1161 = (_e1152 * _e1101);
let _e1162 = (_e1153 * _e1101);
let _e1163 = (_e1154 * _e1101);
let _e1164 = (_e1155 * _e1101);
let _e1169 = -((_e1152 * _e1045));
let _e1170 = -((_e1153 * _e1045));
let _e1171 = -((_e1154 * _e1045));
let _e1172 = -((_e1155 * _e1045));
local_46 = array<u32, 2>(0u, 4294967295u);
let _e1177 = select(0u, 1u, (_e1161 > _e1169));
if (_e1177 < 2u) {
} else {
break;
}
let _e1180 = local_46[_e1177];
local_47 = array<u32, 2>(0u, 4294967295u);
let _e1181 = select(0u, 1u, (_e1162 > _e1170));
if (_e1181 < 2u) {
} else {
break;
}
let _e1184 = local_47[_e1181];
local_48 = array<u32, 2>(0u, 4294967295u);
let _e1185 = select(0u, 1u, (_e1163 > _e1171));
if (_e1185 < 2u) {
} else {
break;
}
let _e1188 = local_48[_e1185];
local_49 = array<u32, 2>(0u, 4294967295u);
let _e1189 = select(0u, 1u, (_e1164 > _e1172));
let _e1190 = (_e1189 < 2u);
if _e1190 {
} else {
break;
}
let _e1192 = local_49[_e1189];
let _e1208 = (_e1155 * 0f);
let _e1213 = (_e1157 * _e1101);
let _e1214 = (_e1158 * _e1101);
let _e1215 = (_e1159 * _e1101);
let _e1219 = -((_e1157 * _e1045));
let _e1220 = -((_e1158 * _e1045));
let _e1221 = -((_e1159 * _e1045));
local_42 = array<u32, 2>(0u, 4294967295u);
let _e1225 = select(0u, 1u, (_e1213 > _e1219));
if (_e1225 < 2u) {
} else {
break;
}
let _e1228 = local_42[_e1225];
local_43 = array<u32, 2>(0u, 4294967295u);
let _e1229 = select(0u, 1u, (_e1214 > _e1220));
if (_e1229 < 2u) {
} else {
break;
}
let _e1232 = local_43[_e1229];
local_44 = array<u32, 2>(0u, 4294967295u);
let _e1233 = select(0u, 1u, (_e1215 > _e1221));
if (_e1233 < 2u) {
} else {
break;
}
let _e1236 = local_44[_e1233];
local_45 = array<u32, 2>(0u, 4294967295u);
if _e1190 {
} else {
break;
}
let _e1238 = local_45[_e1189];
local_38 = array<u32, 2>(0u, 4294967295u);
let _e1271 = select(0u, 1u, (_e1152 == 0f));
if (_e1271 < 2u) {
} else {
break;
}
let _e1274 = local_38[_e1271];
local_39 = array<u32, 2>(0u, 4294967295u);
let _e1275 = select(0u, 1u, (_e1153 == 0f));
if (_e1275 < 2u) {
} else {
break;
}
let _e1278 = local_39[_e1275];
local_40 = array<u32, 2>(0u, 4294967295u);
let _e1279 = select(0u, 1u, (_e1154 == 0f));
if (_e1279 < 2u) {
} else {
break;
}
let _e1282 = local_40[_e1279];
local_41 = array<u32, 2>(0u, 4294967295u);
let _e1283 = select(0u, 1u, (_e1155 == 0f));
if (_e1283 < 2u) {
} else {
break;
}
let _e1286 = local_41[_e1283];
let _e1288 = ((_e1274 & 1u) != 0u);
let _e1291 = ((_e1278 & 1u) != 0u);
let _e1294 = ((_e1282 & 1u) != 0u);
let _e1297 = ((_e1286 & 1u) != 0u);
let _e1299 = (-1f / select(_e1152, 1f, _e1288));
let _e1300 = (-1f / select(_e1153, 1f, _e1291));
let _e1301 = (-1f / select(_e1154, 1f, _e1294));
let _e1302 = (-1f / select(_e1155, 1f, _e1297));
local_34 = array<u32, 2>(0u, 4294967295u);
let _e1307 = select(0u, 1u, (_e1152 > 0f));
if (_e1307 < 2u) {
} else {
break;
}
let _e1310 = local_34[_e1307];
local_35 = array<u32, 2>(0u, 4294967295u);
let _e1311 = select(0u, 1u, (_e1153 > 0f));
if (_e1311 < 2u) {
} else {
break;
}
let _e1314 = local_35[_e1311];
local_36 = array<u32, 2>(0u, 4294967295u);
let _e1315 = select(0u, 1u, (_e1154 > 0f));
if (_e1315 < 2u) {
} else {
break;
}
let _e1318 = local_36[_e1315];
local_37 = array<u32, 2>(0u, 4294967295u);
let _e1319 = select(0u, 1u, (_e1155 > 0f));
if (_e1319 < 2u) {
} else {
break;
}
let _e1322 = local_37[_e1319];
local_30 = array<u32, 2>(0u, 4294967295u);
let _e1327 = select(0u, 1u, (_e1152 < 0f));
if (_e1327 < 2u) {
} else {
break;
}
let _e1330 = local_30[_e1327];
local_31 = array<u32, 2>(0u, 4294967295u);
let _e1331 = select(0u, 1u, (_e1153 < 0f));
if (_e1331 < 2u) {
} else {
break;
}
let _e1334 = local_31[_e1331];
local_32 = array<u32, 2>(0u, 4294967295u);
let _e1335 = select(0u, 1u, (_e1154 < 0f));
if (_e1335 < 2u) {
} else {
break;
}
let _e1338 = local_32[_e1335];
local_33 = array<u32, 2>(0u, 4294967295u);
let _e1339 = select(0u, 1u, (_e1155 < 0f));
if (_e1339 < 2u) {
} else {
break;
}
let _e1342 = local_33[_e1339];
let _e1361 = ((_e1330 & 1u) != 0u);
let _e1364 = ((_e1334 & 1u) != 0u);
let _e1367 = ((_e1338 & 1u) != 0u);
let _e1370 = ((_e1342 & 1u) != 0u);
phi_19778_ = type_16(vec4<f32>(_e1157, _e1158, _e1159, _e1155), vec4<f32>((((select(_e1169, _e1161, ((_e1180 & 1u) != 0u)) - (_e1152 * _e993)) + (select(_e1219, _e1213, ((_e1228 & 1u) != 0u)) - (_e1157 * _e982))) + _e1147), (((select(_e1170, _e1162, ((_e1184 & 1u) != 0u)) - (_e1153 * _e1015)) + (select(_e1220, _e1214, ((_e1232 & 1u) != 0u)) - (_e1158 * _e1008))) + _e1147), (((select(_e1171, _e1163, ((_e1188 & 1u) != 0u)) - (_e1154 * _e1037)) + (select(_e1221, _e1215, ((_e1236 & 1u) != 0u)) - (_e1159 * _e1030))) + _e1147), (((select(_e1172, _e1164, ((_e1192 & 1u) != 0u)) - _e1208) + (select(_e1172, _e1164, ((_e1238 & 1u) != 0u)) - _e1208)) + _e1147)), vec4<f32>(select(0f, _e1299, ((_e1310 & 1u) != 0u)), select(0f, _e1300, ((_e1314 & 1u) != 0u)), select(0f, _e1301, ((_e1318 & 1u) != 0u)), select(0f, _e1302, ((_e1322 & 1u) != 0u))), vec4<f32>(select(select(0f, 1e20f, _e1288), _e1299, _e1361), select(select(0f, 1e20f, _e1291), _e1300, _e1364), select(select(0f, 1e20f, _e1294), _e1301, _e1367), select(select(0f, 1e20f, _e1297), _e1302, _e1370)), vec4<f32>(select(_e1087, 0f, _e1361), select(_e1087, 0f, _e1364), select(_e1087, 0f, _e1367), select(_e1087, 0f, _e1370)));
}
let _e1619 = phi_19778_;
let _e1621 = (_e1054 == 0f);
let _e1623 = (1f / select(_e1054, 1f, _e1621));
let _e1629 = select(1f, -1f, (_e1060 < 0f));
let _e1635 = select(0f, (2f * _e1084), (bitcast<f32>((bitcast<u32>(_e1060) & 2147483647u)) <= _e1084));
let _e1639 = (0f - 0f);
let _e1640 = ((_e982 - _e1008) * _e1629);
let _e1641 = ((_e1008 - _e1030) * _e1629);
let _e1642 = ((_e1030 - _e982) * _e1629);
let _e1643 = (_e1639 * _e1629);
let _e1644 = (_e971 - _e1023);
let _e1645 = (_e1046 * _e1629);
let _e1646 = (_e1049 * _e1629);
let _e1647 = (_e1644 * _e1629);
let _e1648 = (_e1640 * _e1101);
let _e1649 = (_e1641 * _e1101);
let _e1650 = (_e1642 * _e1101);
let _e1656 = -((_e1640 * _e1045));
let _e1657 = -((_e1641 * _e1045));
let _e1658 = -((_e1642 * _e1045));
local_27 = array<u32, 2>(0u, 4294967295u);
let _e1664 = select(0u, 1u, (_e1648 > _e1656));
if (_e1664 < 2u) {
} else {
break;
}
let _e1667 = local_27[_e1664];
local_28 = array<u32, 2>(0u, 4294967295u);
let _e1668 = select(0u, 1u, (_e1649 > _e1657));
if (_e1668 < 2u) {
} else {
break;
}
let _e1671 = local_28[_e1668];
local_29 = array<u32, 2>(0u, 4294967295u);
let _e1672 = select(0u, 1u, (_e1650 > _e1658));
if (_e1672 < 2u) {
} else {
break;
}
let _e1675 = local_29[_e1672];
let _e1677 = (select(0u, 1u, ((_e1643 * _e1101) > -((_e1643 * _e1045)))) < 2u);
if _e1677 {
} else {
break;
}
let _e1693 = (_e1645 * _e1101);
let _e1694 = (_e1646 * _e1101);
let _e1695 = (_e1647 * _e1101);
let _e1699 = -((_e1645 * _e1045));
let _e1700 = -((_e1646 * _e1045));
let _e1701 = -((_e1647 * _e1045));
local_24 = array<u32, 2>(0u, 4294967295u);
let _e1705 = select(0u, 1u, (_e1693 > _e1699));
if (_e1705 < 2u) {
} else {
break;
}
let _e1708 = local_24[_e1705];
local_25 = array<u32, 2>(0u, 4294967295u);
let _e1709 = select(0u, 1u, (_e1694 > _e1700));
if (_e1709 < 2u) {
} else {
break;
}
let _e1712 = local_25[_e1709];
local_26 = array<u32, 2>(0u, 4294967295u);
let _e1713 = select(0u, 1u, (_e1695 > _e1701));
if (_e1713 < 2u) {
} else {
break;
}
let _e1716 = local_26[_e1713];
if _e1677 {
} else {
break;
}
local_21 = array<u32, 2>(0u, 4294967295u);
let _e1742 = select(0u, 1u, (_e1640 == 0f));
if (_e1742 < 2u) {
} else {
break;
}
let _e1745 = local_21[_e1742];
local_22 = array<u32, 2>(0u, 4294967295u);
let _e1746 = select(0u, 1u, (_e1641 == 0f));
if (_e1746 < 2u) {
} else {
break;
}
let _e1749 = local_22[_e1746];
local_23 = array<u32, 2>(0u, 4294967295u);
let _e1750 = select(0u, 1u, (_e1642 == 0f));
if (_e1750 < 2u) {
} else {
break;
}
let _e1753 = local_23[_e1750];
if (select(0u, 1u, (_e1643 == 0f)) < 2u) {
} else {
break;
}
let _e1757 = ((_e1745 & 1u) != 0u);
let _e1760 = ((_e1749 & 1u) != 0u);
let _e1763 = ((_e1753 & 1u) != 0u);
let _e1765 = (-1f / select(_e1640, 1f, _e1757));
let _e1766 = (-1f / select(_e1641, 1f, _e1760));
let _e1767 = (-1f / select(_e1642, 1f, _e1763));
local_18 = array<u32, 2>(0u, 4294967295u);
let _e1772 = select(0u, 1u, (_e1640 > 0f));
if (_e1772 < 2u) {
} else {
break;
}
let _e1775 = local_18[_e1772];
local_19 = array<u32, 2>(0u, 4294967295u);
let _e1776 = select(0u, 1u, (_e1641 > 0f));
if (_e1776 < 2u) {
} else {
break;
}
let _e1779 = local_19[_e1776];
local_20 = array<u32, 2>(0u, 4294967295u);
let _e1780 = select(0u, 1u, (_e1642 > 0f));
if (_e1780 < 2u) {
} else {
break;
}
let _e1783 = local_20[_e1780];
if (select(0u, 1u, (_e1643 > 0f)) < 2u) {
} else {
break;
}
local_15 = array<u32, 2>(0u, 4294967295u);
let _e1790 = select(0u, 1u, (_e1640 < 0f));
if (_e1790 < 2u) {
} else {
break;
}
let _e1793 = local_15[_e1790];
local_16 = array<u32, 2>(0u, 4294967295u);
let _e1794 = select(0u, 1u, (_e1641 < 0f));
if (_e1794 < 2u) {
} else {
break;
}
let _e1797 = local_16[_e1794];
local_17 = array<u32, 2>(0u, 4294967295u);
let _e1798 = select(0u, 1u, (_e1642 < 0f));
if (_e1798 < 2u) {
} else {
break;
}
let _e1801 = local_17[_e1798];
if (select(0u, 1u, (_e1643 < 0f)) < 2u) {
} else {
break;
}
let _e1817 = ((_e1793 & 1u) != 0u);
let _e1820 = ((_e1797 & 1u) != 0u);
let _e1823 = ((_e1801 & 1u) != 0u);
let _e1829 = select(1f, -1f, (_e1125 < 0f));
let _e1835 = select(0f, (2f * _e1076), (bitcast<f32>((bitcast<u32>(_e1125) & 2147483647u)) <= _e1076));
let _e1839 = ((_e993 - _e1015) * _e1829);
let _e1840 = ((_e1015 - _e1037) * _e1829);
let _e1841 = ((_e1037 - _e993) * _e1829);
let _e1842 = (_e1639 * _e1829);
let _e1843 = (_e1046 * _e1829);
let _e1844 = (_e1049 * _e1829);
let _e1845 = (_e1644 * _e1829);
let _e1846 = (_e1839 * _e1101);
let _e1847 = (_e1840 * _e1101);
let _e1848 = (_e1841 * _e1101);
let _e1854 = -((_e1839 * _e1045));
let _e1855 = -((_e1840 * _e1045));
let _e1856 = -((_e1841 * _e1045));
local_12 = array<u32, 2>(0u, 4294967295u);
let _e1862 = select(0u, 1u, (_e1846 > _e1854));
if (_e1862 < 2u) {
} else {
break;
}
let _e1865 = local_12[_e1862];
local_13 = array<u32, 2>(0u, 4294967295u);
let _e1866 = select(0u, 1u, (_e1847 > _e1855));
if (_e1866 < 2u) {
} else {
break;
}
let _e1869 = local_13[_e1866];
local_14 = array<u32, 2>(0u, 4294967295u);
let _e1870 = select(0u, 1u, (_e1848 > _e1856));
if (_e1870 < 2u) {
} else {
break;
}
let _e1873 = local_14[_e1870];
let _e1875 = (select(0u, 1u, ((_e1842 * _e1101) > -((_e1842 * _e1045)))) < 2u);
if _e1875 {
} else {
break;
}
let _e1891 = (_e1843 * _e1101);
let _e1892 = (_e1844 * _e1101);
let _e1893 = (_e1845 * _e1101);
let _e1897 = -((_e1843 * _e1045));
let _e1898 = -((_e1844 * _e1045));
let _e1899 = -((_e1845 * _e1045));
local_9 = array<u32, 2>(0u, 4294967295u);
let _e1903 = select(0u, 1u, (_e1891 > _e1897));
if (_e1903 < 2u) {
} else {
break;
}
let _e1906 = local_9[_e1903];
local_10 = array<u32, 2>(0u, 4294967295u);
let _e1907 = select(0u, 1u, (_e1892 > _e1898));
if (_e1907 < 2u) {
} else {
break;
}
let _e1910 = local_10[_e1907];
local_11 = array<u32, 2>(0u, 4294967295u);
let _e1911 = select(0u, 1u, (_e1893 > _e1899));
if (_e1911 < 2u) {
} else {
break;
}
let _e1914 = local_11[_e1911];
if _e1875 {
} else {
break;
}
local_6 = array<u32, 2>(0u, 4294967295u);
let _e1940 = select(0u, 1u, (_e1839 == 0f));
if (_e1940 < 2u) {
} else {
break;
}
let _e1943 = local_6[_e1940];
local_7 = array<u32, 2>(0u, 4294967295u);
let _e1944 = select(0u, 1u, (_e1840 == 0f));
if (_e1944 < 2u) {
} else {
break;
}
let _e1947 = local_7[_e1944];
local_8 = array<u32, 2>(0u, 4294967295u);
let _e1948 = select(0u, 1u, (_e1841 == 0f));
if (_e1948 < 2u) {
} else {
break;
}
let _e1951 = local_8[_e1948];
if (select(0u, 1u, (_e1842 == 0f)) < 2u) {
} else {
break;
}
let _e1955 = ((_e1943 & 1u) != 0u);
let _e1958 = ((_e1947 & 1u) != 0u);
let _e1961 = ((_e1951 & 1u) != 0u);
let _e1963 = (-1f / select(_e1839, 1f, _e1955));
let _e1964 = (-1f / select(_e1840, 1f, _e1958));
let _e1965 = (-1f / select(_e1841, 1f, _e1961));
local_3 = array<u32, 2>(0u, 4294967295u);
let _e1970 = select(0u, 1u, (_e1839 > 0f));
if (_e1970 < 2u) {
} else {
break;
}
let _e1973 = local_3[_e1970];
local_4 = array<u32, 2>(0u, 4294967295u);
let _e1974 = select(0u, 1u, (_e1840 > 0f));
if (_e1974 < 2u) {
} else {
break;
}
let _e1977 = local_4[_e1974];
local_5 = array<u32, 2>(0u, 4294967295u);
let _e1978 = select(0u, 1u, (_e1841 > 0f));
if (_e1978 < 2u) {
} else {
break;
}
let _e1981 = local_5[_e1978];
if (select(0u, 1u, (_e1842 > 0f)) < 2u) {
} else {
break;
}
local = array<u32, 2>(0u, 4294967295u);
let _e1988 = select(0u, 1u, (_e1839 < 0f));
if (_e1988 < 2u) {
} else {
break;
}
let _e1991 = local[_e1988];
local_1 = array<u32, 2>(0u, 4294967295u);
let _e1992 = select(0u, 1u, (_e1840 < 0f));
if (_e1992 < 2u) {
} else {
break;
}
let _e1995 = local_1[_e1992];
local_2 = array<u32, 2>(0u, 4294967295u);
let _e1996 = select(0u, 1u, (_e1841 < 0f));
if (_e1996 < 2u) {
} else {
break;
}
let _e1999 = local_2[_e1996];
if (select(0u, 1u, (_e1842 < 0f)) < 2u) {
} else {
break;
}
let _e2015 = ((_e1991 & 1u) != 0u);
let _e2018 = ((_e1995 & 1u) != 0u);
let _e2021 = ((_e1999 & 1u) != 0u);
phi_21457_ = _e913.member.member_1;
loop {
let _e2027 = phi_21457_;
let _e2028 = (_e2027 < _e913.member.member_2);
if _e2028 {
if _e1139 {
phi_21472_ = _e913.member_1.member_4.y;
} else {
phi_21472_ = _e913.member_1.member_4.z;
}
let _e2032 = phi_21472_;
let _e2033 = f32(_e2032);
let _e2034 = f32(_e2027);
let _e2044 = ((_e1619.member.x * _e2034) + _e1619.member_1.x);
let _e2046 = ((_e1619.member.y * _e2034) + _e1619.member_1.y);
let _e2048 = ((_e1619.member.z * _e2034) + _e1619.member_1.z);
let _e2051 = (_e2044 * _e1619.member_2.x);
let _e2053 = (_e2046 * _e1619.member_2.y);
let _e2055 = (_e2048 * _e1619.member_2.z);
let _e2065 = ((_e2044 * _e1619.member_3.x) + _e1619.member_4.x);
let _e2067 = ((_e2046 * _e1619.member_3.y) + _e1619.member_4.y);
let _e2069 = ((_e2048 * _e1619.member_3.z) + _e1619.member_4.z);
let _e2071 = select(_e2051, 0f, (0f > _e2051));
let _e2073 = select(_e2055, _e2053, (_e2053 > _e2055));
let _e2077 = select(_e2065, _e2033, (_e2033 < _e2065));
let _e2079 = select(_e2069, _e2067, (_e2067 < _e2069));
let _e2081 = select(_e2079, _e2077, (_e2077 < _e2079));
let _e2082 = -(select(_e2073, _e2071, (_e2071 > _e2073)));
let _e2084 = (-(_e2033) - 1f);
let _e2086 = select(_e2084, _e2082, (_e2082 > _e2084));
let _e2088 = select(0f, _e2086, (_e2086 < 0f));
let _e2095 = select(0i, select(select(i32(_e2088), i32(-2147483648), (_e2088 < -2147483600f)), 2147483647i, (_e2088 > 2147483500f)), (_e2088 == _e2088));
let _e2102 = select(-1f, _e2081, (_e2081 > -1f));
let _e2104 = select(_e2033, _e2102, (_e2102 < _e2033));
let _e2111 = select(0i, select(select(i32(_e2104), i32(-2147483648), (_e2104 < -2147483600f)), 2147483647i, (_e2104 > 2147483500f)), (_e2104 == _e2104));
phi_21592_ = -((_e2095 - select(0i, 1i, (_e2088 < f32(_e2095)))));
loop {
let _e2117 = phi_21592_;
let _e2118 = (_e2117 <= (_e2111 - select(0i, 1i, (_e2104 < f32(_e2111)))));
if _e2118 {
let _e2119 = select(_e2117, _e2027, _e1139);
let _e2120 = select(_e2027, _e2117, _e1139);
let _e2121 = f32(_e2120);
let _e2122 = f32(_e2119);
let _e2124 = f32(_e913.member_1.member_4.x);
let _e2127 = ((_e1057 * _e2121) + (_e1060 * _e2122));
let _e2128 = (_e2127 + ((((select(_e1104, _e1102, (_e1102 > _e1104)) + select(_e1109, _e1107, (_e1107 > _e1109))) + select(_e1115, _e1113, (_e1113 > _e1115))) - _e1100) + _e1095));
let _e2130 = -((_e2128 * _e1623));
let _e2134 = select(0f, select(_e2130, 0f, (0f > _e2130)), (_e1054 > 0f));
let _e2141 = select(select(_e2124, select(_e2130, _e2124, (_e2124 < _e2130)), (_e1054 < 0f)), -1f, (_e1621 && (_e2128 < 0f)));
let _e2143 = (((((select(_e1122, _e1120, (_e1120 > _e1122)) + select(_e1128, _e1126, (_e1126 > _e1128))) + select(_e1135, _e1133, (_e1133 > _e1135))) + _e1100) + _e1095) - _e2127);
let _e2145 = -((_e2143 * -(_e1623)));
let _e2149 = select(_e2134, select(_e2145, _e2134, (_e2134 > _e2145)), (_e1119 > 0f));
let _e2157 = select(select(_e2141, select(_e2145, _e2141, (_e2141 < _e2145)), (_e1119 < 0f)), -1f, ((_e1119 == 0f) && (_e2143 < 0f)));
let _e2161 = ((_e1645 * _e2121) + (((select(_e1656, _e1648, ((_e1667 & 1u) != 0u)) - (_e1640 * _e971)) + (select(_e1699, _e1693, ((_e1708 & 1u) != 0u)) - (_e1645 * _e982))) + _e1635));
let _e2162 = ((_e1646 * _e2121) + (((select(_e1657, _e1649, ((_e1671 & 1u) != 0u)) - (_e1641 * _e1001)) + (select(_e1700, _e1694, ((_e1712 & 1u) != 0u)) - (_e1646 * _e1008))) + _e1635));
let _e2163 = ((_e1647 * _e2121) + (((select(_e1658, _e1650, ((_e1675 & 1u) != 0u)) - (_e1642 * _e1023)) + (select(_e1701, _e1695, ((_e1716 & 1u) != 0u)) - (_e1647 * _e1030))) + _e1635));
let _e2164 = (_e2161 * select(0f, _e1765, ((_e1775 & 1u) != 0u)));
let _e2165 = (_e2162 * select(0f, _e1766, ((_e1779 & 1u) != 0u)));
let _e2166 = (_e2163 * select(0f, _e1767, ((_e1783 & 1u) != 0u)));
let _e2170 = ((_e2161 * select(select(0f, 1e20f, _e1757), _e1765, _e1817)) + select(_e1085, 0f, _e1817));
let _e2171 = ((_e2162 * select(select(0f, 1e20f, _e1760), _e1766, _e1820)) + select(_e1085, 0f, _e1820));
let _e2172 = ((_e2163 * select(select(0f, 1e20f, _e1763), _e1767, _e1823)) + select(_e1085, 0f, _e1823));
let _e2174 = select(_e2164, _e2149, (_e2149 > _e2164));
let _e2176 = select(_e2166, _e2165, (_e2165 > _e2166));
let _e2178 = select(_e2176, _e2174, (_e2174 > _e2176));
let _e2180 = select(_e2170, _e2157, (_e2157 < _e2170));
let _e2182 = select(_e2172, _e2171, (_e2171 < _e2172));
let _e2184 = select(_e2182, _e2180, (_e2180 < _e2182));
let _e2188 = ((_e1843 * _e2122) + (((select(_e1854, _e1846, ((_e1865 & 1u) != 0u)) - (_e1839 * _e971)) + (select(_e1897, _e1891, ((_e1906 & 1u) != 0u)) - (_e1843 * _e993))) + _e1835));
let _e2189 = ((_e1844 * _e2122) + (((select(_e1855, _e1847, ((_e1869 & 1u) != 0u)) - (_e1840 * _e1001)) + (select(_e1898, _e1892, ((_e1910 & 1u) != 0u)) - (_e1844 * _e1015))) + _e1835));
let _e2190 = ((_e1845 * _e2122) + (((select(_e1856, _e1848, ((_e1873 & 1u) != 0u)) - (_e1841 * _e1023)) + (select(_e1899, _e1893, ((_e1914 & 1u) != 0u)) - (_e1845 * _e1037))) + _e1835));
let _e2191 = (_e2188 * select(0f, _e1963, ((_e1973 & 1u) != 0u)));
let _e2192 = (_e2189 * select(0f, _e1964, ((_e1977 & 1u) != 0u)));
let _e2193 = (_e2190 * select(0f, _e1965, ((_e1981 & 1u) != 0u)));
let _e2197 = ((_e2188 * select(select(0f, 1e20f, _e1955), _e1963, _e2015)) + select(_e1085, 0f, _e2015));
let _e2198 = ((_e2189 * select(select(0f, 1e20f, _e1958), _e1964, _e2018)) + select(_e1085, 0f, _e2018));
let _e2199 = ((_e2190 * select(select(0f, 1e20f, _e1961), _e1965, _e2021)) + select(_e1085, 0f, _e2021));
let _e2201 = select(_e2191, _e2178, (_e2178 > _e2191));
let _e2203 = select(_e2193, _e2192, (_e2192 > _e2193));
let _e2207 = select(_e2197, _e2184, (_e2184 < _e2197));
let _e2209 = select(_e2199, _e2198, (_e2198 < _e2199));
let _e2211 = select(_e2209, _e2207, (_e2207 < _e2209));
let _e2212 = -(select(_e2203, _e2201, (_e2201 > _e2203)));
let _e2214 = (-(_e2124) - 1f);
let _e2216 = select(_e2214, _e2212, (_e2212 > _e2214));
let _e2218 = select(0f, _e2216, (_e2216 < 0f));
let _e2225 = select(0i, select(select(i32(_e2218), i32(-2147483648), (_e2218 < -2147483600f)), 2147483647i, (_e2218 > 2147483500f)), (_e2218 == _e2218));
let _e2230 = -((_e2225 - select(0i, 1i, (_e2218 < f32(_e2225)))));
let _e2232 = select(-1f, _e2211, (_e2211 > -1f));
let _e2234 = select(_e2124, _e2232, (_e2232 < _e2124));
let _e2241 = select(0i, select(select(i32(_e2234), i32(-2147483648), (_e2234 < -2147483600f)), 2147483647i, (_e2234 > 2147483500f)), (_e2234 == _e2234));
let _e2245 = (_e2241 - select(0i, 1i, (_e2234 < f32(_e2241))));
if (_e2230 <= _e2245) {
let _e2251 = global_1.member.member_1[1u];
let _e2259 = global_1.member.member_1[3u];
let _e2262 = (_e913.member_1.member_3.x + _e2230);
let _e2263 = (_e913.member_1.member_3.x + _e2245);
let _e2265 = (_e2262 >> bitcast<u32>(5i));
phi_21840_ = _e2265;
loop {
let _e2267 = phi_21840_;
let _e2269 = (_e2263 >> bitcast<u32>(5i));
let _e2270 = (_e2267 <= _e2269);
if _e2270 {
if (_e2267 == _e2265) {
phi_21859_ = (4294967295u << bitcast<u32>((bitcast<u32>((_e2262 & 31i)) & 31u)));
} else {
phi_21859_ = 4294967295u;
}
let _e2278 = phi_21859_;
if (_e2267 == _e2269) {
phi_21870_ = (4294967295u >> bitcast<u32>((bitcast<u32>((31i - (_e2263 & 31i))) & 31u)));
} else {
phi_21870_ = 4294967295u;
}
let _e2287 = phi_21870_;
let _e2289 = bitcast<u32>(((((((_e913.member_1.member_3.z + _e2119) * bitcast<i32>(_e2251)) + _e913.member_1.member_3.y) + _e2120) * bitcast<i32>(_e2259)) + _e2267));
if (_e2289 < _e198) {
let _e2294 = atomicOr((&global_2.member[_e2289]), (_e2278 & _e2287));
}
phi_21841_ = (_e2267 + 1i);
} else {
phi_21841_ = i32();
}
let _e2297 = phi_21841_;
continue;
continuing {
phi_21840_ = _e2297;
break if !(_e2270);
}
}
}
phi_21593_ = (_e2117 + 1i);
} else {
phi_21593_ = i32();
}
let _e2301 = phi_21593_;
continue;
continuing {
phi_21592_ = _e2301;
break if !(_e2118);
}
}
phi_21458_ = (_e2027 + 1i);
} else {
phi_21458_ = i32();
}
let _e2305 = phi_21458_;
continue;
continuing {
phi_21457_ = _e2305;
break if !(_e2028);
}
}
}
}
}
}
}
}
}
break;
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
