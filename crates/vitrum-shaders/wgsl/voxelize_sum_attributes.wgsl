struct type_2 {
member: u32,
member_1: u32,
member_2: u32,
}
struct type_5 {
member: array<f32>,
}
struct type_9 {
member: array<u32>,
}
struct type_10 {
member: type_2,
member_1: u32,
member_2: type_2,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
member_10: u32,
member_11: f32,
}
struct type_11 {
member: type_10,
}
struct type_14 {
member: vec3<i32>,
member_1: vec3<i32>,
member_2: vec3<i32>,
member_3: vec3<i32>,
member_4: vec3<i32>,
member_5: i32,
member_6: u32,
member_7: u32,
}
struct type_15 {
member: i32,
member_1: i32,
member_2: i32,
}
struct type_16 {
member: type_15,
member_1: type_14,
}
struct type_18 {
member: vec4<f32>,
member_1: vec4<f32>,
member_2: vec4<f32>,
member_3: vec4<f32>,
member_4: vec4<f32>,
}
struct type_21 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_11;
@group(0) @binding(1)
var<storage> global_2: type_9;
@group(0) @binding(2)
var<storage> global_3: type_9;
@group(0) @binding(3)
var<storage> global_4: type_5;
@group(0) @binding(4)
var<storage> global_5: type_9;
@group(0) @binding(5)
var<storage> global_6: type_9;
@group(0) @binding(6)
var<storage, read_write> global_7: type_21;
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
var phi_1396_: i32;
var phi_2022_: u32;
var phi_2056_: i32;
var phi_2070_: i32;
var phi_2084_: i32;
var phi_2099_: i32;
var phi_2113_: i32;
var phi_2127_: i32;
var phi_1670_: u32;
var phi_1704_: i32;
var phi_1718_: i32;
var phi_1732_: i32;
var phi_1747_: i32;
var phi_1761_: i32;
var phi_1775_: i32;
var phi_2133_: type_14;
var phi_1178_: u32;
var phi_1212_: i32;
var phi_1226_: i32;
var phi_1240_: i32;
var phi_1255_: i32;
var phi_1269_: i32;
var phi_1283_: i32;
var phi_826_: u32;
var phi_860_: i32;
var phi_874_: i32;
var phi_888_: i32;
var phi_903_: i32;
var phi_917_: i32;
var phi_931_: i32;
var phi_1289_: type_14;
var phi_1329_: bool;
var phi_1345_: i32;
var phi_2135_: type_16;
var phi_2168_: u32;
var phi_2169_: u32;
var phi_2170_: u32;
var phi_24044_: type_18;
var phi_26001_: i32;
var phi_26016_: i32;
var phi_26136_: i32;
var phi_26374_: i32;
var phi_26902_: u32;
var phi_26959_: u32;
var phi_27016_: u32;
var phi_27074_: u32;
var phi_27131_: u32;
var phi_27188_: u32;
var phi_26375_: i32;
var phi_26137_: i32;
var phi_26002_: i32;
var phi_21027_: i32;
var phi_21042_: i32;
var phi_21044_: i32;
var phi_21171_: i32;
var phi_21699_: u32;
var phi_21756_: u32;
var phi_21813_: u32;
var phi_21871_: u32;
var phi_21928_: u32;
var phi_21985_: u32;
var phi_21172_: i32;
var phi_21045_: i32;
var phi_21028_: i32;
var phi_16049_: i32;
var phi_16064_: i32;
var phi_16066_: i32;
var phi_16193_: i32;
var phi_16721_: u32;
var phi_16778_: u32;
var phi_16835_: u32;
var phi_16893_: u32;
var phi_16950_: u32;
var phi_17007_: u32;
var phi_16194_: i32;
var phi_16067_: i32;
var phi_16050_: i32;
var phi_9093_: type_18;
var phi_11050_: i32;
var phi_11065_: i32;
var phi_11185_: i32;
var phi_11215_: i32;
var phi_11743_: u32;
var phi_11800_: u32;
var phi_11857_: u32;
var phi_11915_: u32;
var phi_11972_: u32;
var phi_12029_: u32;
var phi_11216_: i32;
var phi_11186_: i32;
var phi_11051_: i32;
var phi_6169_: i32;
var phi_6184_: i32;
var phi_6186_: i32;
var phi_6216_: i32;
var phi_6744_: u32;
var phi_6801_: u32;
var phi_6858_: u32;
var phi_6916_: u32;
var phi_6973_: u32;
var phi_7030_: u32;
var phi_6217_: i32;
var phi_6187_: i32;
var phi_6170_: i32;
switch bitcast<i32>(0u) {
default: {
let _e207 = global;
let _e210 = arrayLength((&global_2.member));
let _e214 = arrayLength((&global_4.member));
let _e216 = arrayLength((&global_5.member));
let _e218 = arrayLength((&global_6.member));
let _e220 = arrayLength((&global_7.member));
let _e223 = global_1.member.member;
if (_e207.x < _e223.member) {
if (_e207.y < _e223.member_1) {
if (_e223.member_2 == 0u) {
let _e593 = global_1.member.member.member;
let _e595 = ((_e207.y * _e593) + _e207.x);
let _e596 = bitcast<i32>(_e595);
let _e597 = (_e596 * 9i);
let _e599 = (bitcast<i32>(_e210) - 9i);
if (_e597 < _e599) {
local_141 = _e597;
} else {
local_141 = _e599;
}
let _e601 = local_141;
if (_e601 < 0i) {
let _e808 = global_1.member.member_8;
let _e811 = global_1.member.member_9;
let _e812 = bitcast<i32>(_e811);
let _e814 = (_e808 & 31u);
let _e817 = ((2i * _e812) + (2i << bitcast<u32>(_e814)));
if ((_e817 >> bitcast<u32>(22u)) == 0i) {
phi_826_ = 0u;
} else {
let _e822 = (_e817 >> bitcast<u32>(16i));
let _e823 = (_e822 == 0i);
phi_826_ = ((((bitcast<u32>(f32(select(_e822, _e817, _e823))) >> bitcast<u32>(23i)) - 127u) + select(16u, 0u, _e823)) + 4294967275u);
}
let _e834 = phi_826_;
let _e844 = (((_e812 + 1i) + ((1i << bitcast<u32>((_e834 & 31u))) >> bitcast<u32>(1i))) + (_e817 >> bitcast<u32>(19i)));
let _e845 = (_e844 + 1i);
let _e849 = global_1.member.member_2.member;
let _e850 = bitcast<i32>(_e849);
let _e854 = global_1.member.member_2.member_1;
let _e855 = bitcast<i32>(_e854);
let _e859 = global_1.member.member_2.member_2;
let _e860 = bitcast<i32>(_e859);
let _e863 = ((-1i - _e844) >> bitcast<u32>(_e814));
let _e865 = select(0i, _e863, (_e863 > 0i));
if (_e865 < _e850) {
phi_860_ = _e865;
} else {
phi_860_ = (_e850 - 1i);
}
let _e869 = phi_860_;
if (_e865 < _e855) {
phi_874_ = _e865;
} else {
phi_874_ = (_e855 - 1i);
}
let _e873 = phi_874_;
if (_e865 < _e860) {
phi_888_ = _e865;
} else {
phi_888_ = (_e860 - 1i);
}
let _e877 = phi_888_;
let _e880 = (_e845 >> bitcast<u32>(_e814));
let _e882 = select(0i, _e880, (_e880 > 0i));
if (_e882 < _e850) {
phi_903_ = _e882;
} else {
phi_903_ = (_e850 - 1i);
}
let _e886 = phi_903_;
if (_e882 < _e855) {
phi_917_ = _e882;
} else {
phi_917_ = (_e855 - 1i);
}
let _e890 = phi_917_;
if (_e882 < _e860) {
phi_931_ = _e882;
} else {
phi_931_ = (_e860 - 1i);
}
let _e894 = phi_931_;
phi_1289_ = type_14(vec3<i32>(0i, 0i, 0i), vec3<i32>(0i, 0i, 0i), vec3<i32>(0i, 0i, 0i), vec3<i32>(_e869, _e873, _e877), vec3<i32>((_e886 - _e869), (_e890 - _e873), (_e894 - _e877)), _e845, _e808, _e834);
} else {
let _e603 = local_141;
let _e606 = global_2.member[bitcast<u32>(_e603)];
let _e607 = bitcast<i32>(_e606);
let _e608 = local_141;
let _e612 = global_2.member[bitcast<u32>((_e608 + 1i))];
let _e613 = bitcast<i32>(_e612);
let _e614 = local_141;
let _e618 = global_2.member[bitcast<u32>((_e614 + 2i))];
let _e619 = bitcast<i32>(_e618);
let _e621 = local_141;
let _e625 = global_2.member[bitcast<u32>((_e621 + 3i))];
let _e626 = bitcast<i32>(_e625);
let _e627 = local_141;
let _e631 = global_2.member[bitcast<u32>((_e627 + 4i))];
let _e632 = bitcast<i32>(_e631);
let _e633 = local_141;
let _e637 = global_2.member[bitcast<u32>((_e633 + 5i))];
let _e638 = bitcast<i32>(_e637);
let _e640 = local_141;
let _e644 = global_2.member[bitcast<u32>((_e640 + 6i))];
let _e645 = bitcast<i32>(_e644);
let _e646 = local_141;
let _e650 = global_2.member[bitcast<u32>((_e646 + 7i))];
let _e651 = bitcast<i32>(_e650);
let _e652 = local_141;
let _e656 = global_2.member[bitcast<u32>((_e652 + 8i))];
let _e657 = bitcast<i32>(_e656);
let _e661 = global_1.member.member_8;
let _e664 = global_1.member.member_9;
let _e665 = bitcast<i32>(_e664);
let _e667 = select(_e626, _e607, (_e607 < _e626));
let _e669 = select(_e632, _e613, (_e613 < _e632));
let _e671 = select(_e638, _e619, (_e619 < _e638));
let _e673 = select(_e645, _e667, (_e667 < _e645));
let _e675 = select(_e651, _e669, (_e669 < _e651));
let _e677 = select(_e657, _e671, (_e671 < _e657));
let _e679 = select(_e626, _e607, (_e607 > _e626));
let _e681 = select(_e632, _e613, (_e613 > _e632));
let _e683 = select(_e638, _e619, (_e619 > _e638));
let _e685 = select(_e645, _e679, (_e679 > _e645));
let _e687 = select(_e651, _e681, (_e681 > _e651));
let _e689 = select(_e657, _e683, (_e683 > _e657));
let _e690 = (_e685 - _e673);
let _e691 = (_e687 - _e675);
let _e692 = (_e689 - _e677);
let _e694 = select(_e691, _e690, (_e690 > _e691));
let _e699 = (_e661 & 31u);
let _e702 = ((select(_e692, _e694, (_e694 > _e692)) + (2i * _e665)) + (2i << bitcast<u32>(_e699)));
if ((_e702 >> bitcast<u32>(22u)) == 0i) {
phi_1178_ = 0u;
} else {
let _e707 = (_e702 >> bitcast<u32>(16i));
let _e708 = (_e707 == 0i);
phi_1178_ = ((((bitcast<u32>(f32(select(_e707, _e702, _e708))) >> bitcast<u32>(23i)) - 127u) + select(16u, 0u, _e708)) + 4294967275u);
}
let _e719 = phi_1178_;
let _e730 = ((((_e665 + 1i) + ((1i << bitcast<u32>((_e719 & 31u))) >> bitcast<u32>(1i))) + (_e702 >> bitcast<u32>(19i))) + 1i);
let _e734 = global_1.member.member_2.member;
let _e735 = bitcast<i32>(_e734);
let _e739 = global_1.member.member_2.member_1;
let _e740 = bitcast<i32>(_e739);
let _e744 = global_1.member.member_2.member_2;
let _e745 = bitcast<i32>(_e744);
let _e748 = ((_e673 - _e730) >> bitcast<u32>(_e699));
let _e750 = select(0i, _e748, (_e748 > 0i));
if (_e750 < _e735) {
phi_1212_ = _e750;
} else {
phi_1212_ = (_e735 - 1i);
}
let _e754 = phi_1212_;
let _e757 = ((_e675 - _e730) >> bitcast<u32>(_e699));
let _e759 = select(0i, _e757, (_e757 > 0i));
if (_e759 < _e740) {
phi_1226_ = _e759;
} else {
phi_1226_ = (_e740 - 1i);
}
let _e763 = phi_1226_;
let _e766 = ((_e677 - _e730) >> bitcast<u32>(_e699));
let _e768 = select(0i, _e766, (_e766 > 0i));
if (_e768 < _e745) {
phi_1240_ = _e768;
} else {
phi_1240_ = (_e745 - 1i);
}
let _e772 = phi_1240_;
let _e776 = ((_e685 + _e730) >> bitcast<u32>(_e699));
let _e778 = select(0i, _e776, (_e776 > 0i));
if (_e778 < _e735) {
phi_1255_ = _e778;
} else {
phi_1255_ = (_e735 - 1i);
}
let _e782 = phi_1255_;
let _e785 = ((_e687 + _e730) >> bitcast<u32>(_e699));
let _e787 = select(0i, _e785, (_e785 > 0i));
if (_e787 < _e740) {
phi_1269_ = _e787;
} else {
phi_1269_ = (_e740 - 1i);
}
let _e791 = phi_1269_;
let _e794 = ((_e689 + _e730) >> bitcast<u32>(_e699));
let _e796 = select(0i, _e794, (_e794 > 0i));
if (_e796 < _e745) {
phi_1283_ = _e796;
} else {
phi_1283_ = (_e745 - 1i);
}
let _e800 = phi_1283_;
phi_1289_ = type_14(vec3<i32>(_e607, _e613, _e619), vec3<i32>(_e626, _e632, _e638), vec3<i32>(_e645, _e651, _e657), vec3<i32>(_e754, _e763, _e772), vec3<i32>((_e782 - _e754), (_e791 - _e763), (_e800 - _e772)), _e730, _e661, _e719);
}
let _e901 = phi_1289_;
let _e904 = global_1.member.member_1;
let _e910 = (_e901.member_4.z >= _e901.member_4.y);
let _e912 = (1i + select(_e901.member_4.y, _e901.member_4.z, _e910));
if (_e912 == 1i) {
phi_1329_ = true;
} else {
phi_1329_ = ((_e912 * (1i + select(_e901.member_4.z, _e901.member_4.y, _e910))) <= 32i);
}
let _e919 = phi_1329_;
if ((_e595 < _e904) && _e919) {
phi_1345_ = _e912;
} else {
phi_1345_ = 0i;
}
let _e922 = phi_1345_;
phi_2135_ = type_16(type_15(_e596, 0i, _e922), _e901);
} else {
let _e235 = global_1.member.member.member;
let _e237 = ((_e207.y * _e235) + _e207.x);
let _e240 = global_1.member.member_1;
let _e242 = bitcast<i32>((_e237 * 3u));
let _e243 = (_e242 + 1i);
let _e245 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e247 = select(_e245, _e243, (_e243 < _e245));
let _e253 = global_3.member[bitcast<u32>(select(0i, _e247, (_e247 > 0i)))];
let _e254 = bitcast<i32>(_e253);
if (_e237 < _e240) {
let _e256 = (_e242 + 2i);
let _e258 = select(_e245, _e256, (_e256 < _e245));
let _e264 = global_3.member[bitcast<u32>(select(0i, _e258, (_e258 > 0i)))];
phi_1396_ = bitcast<i32>(_e264);
} else {
phi_1396_ = 0i;
}
let _e267 = phi_1396_;
let _e269 = select(_e245, _e242, (_e242 < _e245));
let _e275 = global_3.member[bitcast<u32>(select(0i, _e269, (_e269 > 0i)))];
let _e280 = global_1.member.member_10;
let _e282 = (bitcast<i32>(_e275) + bitcast<i32>(_e280));
let _e284 = (_e282 * 9i);
let _e286 = (bitcast<i32>(_e210) - 9i);
if (_e284 < _e286) {
local_140 = _e284;
} else {
local_140 = _e286;
}
let _e288 = local_140;
if (_e288 < 0i) {
let _e495 = global_1.member.member_8;
let _e498 = global_1.member.member_9;
let _e499 = bitcast<i32>(_e498);
let _e501 = (_e495 & 31u);
let _e504 = ((2i * _e499) + (2i << bitcast<u32>(_e501)));
if ((_e504 >> bitcast<u32>(22u)) == 0i) {
phi_1670_ = 0u;
} else {
let _e509 = (_e504 >> bitcast<u32>(16i));
let _e510 = (_e509 == 0i);
phi_1670_ = ((((bitcast<u32>(f32(select(_e509, _e504, _e510))) >> bitcast<u32>(23i)) - 127u) + select(16u, 0u, _e510)) + 4294967275u);
}
let _e521 = phi_1670_;
let _e531 = (((_e499 + 1i) + ((1i << bitcast<u32>((_e521 & 31u))) >> bitcast<u32>(1i))) + (_e504 >> bitcast<u32>(19i)));
let _e532 = (_e531 + 1i);
let _e536 = global_1.member.member_2.member;
let _e537 = bitcast<i32>(_e536);
let _e541 = global_1.member.member_2.member_1;
let _e542 = bitcast<i32>(_e541);
let _e546 = global_1.member.member_2.member_2;
let _e547 = bitcast<i32>(_e546);
let _e550 = ((-1i - _e531) >> bitcast<u32>(_e501));
let _e552 = select(0i, _e550, (_e550 > 0i));
if (_e552 < _e537) {
phi_1704_ = _e552;
} else {
phi_1704_ = (_e537 - 1i);
}
let _e556 = phi_1704_;
if (_e552 < _e542) {
phi_1718_ = _e552;
} else {
phi_1718_ = (_e542 - 1i);
}
let _e560 = phi_1718_;
if (_e552 < _e547) {
phi_1732_ = _e552;
} else {
phi_1732_ = (_e547 - 1i);
}
let _e564 = phi_1732_;
let _e567 = (_e532 >> bitcast<u32>(_e501));
let _e569 = select(0i, _e567, (_e567 > 0i));
if (_e569 < _e537) {
phi_1747_ = _e569;
} else {
phi_1747_ = (_e537 - 1i);
}
let _e573 = phi_1747_;
if (_e569 < _e542) {
phi_1761_ = _e569;
} else {
phi_1761_ = (_e542 - 1i);
}
let _e577 = phi_1761_;
if (_e569 < _e547) {
phi_1775_ = _e569;
} else {
phi_1775_ = (_e547 - 1i);
}
let _e581 = phi_1775_;
phi_2133_ = type_14(vec3<i32>(0i, 0i, 0i), vec3<i32>(0i, 0i, 0i), vec3<i32>(0i, 0i, 0i), vec3<i32>(_e556, _e560, _e564), vec3<i32>((_e573 - _e556), (_e577 - _e560), (_e581 - _e564)), _e532, _e495, _e521);
} else {
let _e290 = local_140;
let _e293 = global_2.member[bitcast<u32>(_e290)];
let _e294 = bitcast<i32>(_e293);
let _e295 = local_140;
let _e299 = global_2.member[bitcast<u32>((_e295 + 1i))];
let _e300 = bitcast<i32>(_e299);
let _e301 = local_140;
let _e305 = global_2.member[bitcast<u32>((_e301 + 2i))];
let _e306 = bitcast<i32>(_e305);
let _e308 = local_140;
let _e312 = global_2.member[bitcast<u32>((_e308 + 3i))];
let _e313 = bitcast<i32>(_e312);
let _e314 = local_140;
let _e318 = global_2.member[bitcast<u32>((_e314 + 4i))];
let _e319 = bitcast<i32>(_e318);
let _e320 = local_140;
let _e324 = global_2.member[bitcast<u32>((_e320 + 5i))];
let _e325 = bitcast<i32>(_e324);
let _e327 = local_140;
let _e331 = global_2.member[bitcast<u32>((_e327 + 6i))];
let _e332 = bitcast<i32>(_e331);
let _e333 = local_140;
let _e337 = global_2.member[bitcast<u32>((_e333 + 7i))];
let _e338 = bitcast<i32>(_e337);
let _e339 = local_140;
let _e343 = global_2.member[bitcast<u32>((_e339 + 8i))];
let _e344 = bitcast<i32>(_e343);
let _e348 = global_1.member.member_8;
let _e351 = global_1.member.member_9;
let _e352 = bitcast<i32>(_e351);
let _e354 = select(_e313, _e294, (_e294 < _e313));
let _e356 = select(_e319, _e300, (_e300 < _e319));
let _e358 = select(_e325, _e306, (_e306 < _e325));
let _e360 = select(_e332, _e354, (_e354 < _e332));
let _e362 = select(_e338, _e356, (_e356 < _e338));
let _e364 = select(_e344, _e358, (_e358 < _e344));
let _e366 = select(_e313, _e294, (_e294 > _e313));
let _e368 = select(_e319, _e300, (_e300 > _e319));
let _e370 = select(_e325, _e306, (_e306 > _e325));
let _e372 = select(_e332, _e366, (_e366 > _e332));
let _e374 = select(_e338, _e368, (_e368 > _e338));
let _e376 = select(_e344, _e370, (_e370 > _e344));
let _e377 = (_e372 - _e360);
let _e378 = (_e374 - _e362);
let _e379 = (_e376 - _e364);
let _e381 = select(_e378, _e377, (_e377 > _e378));
let _e386 = (_e348 & 31u);
let _e389 = ((select(_e379, _e381, (_e381 > _e379)) + (2i * _e352)) + (2i << bitcast<u32>(_e386)));
if ((_e389 >> bitcast<u32>(22u)) == 0i) {
phi_2022_ = 0u;
} else {
let _e394 = (_e389 >> bitcast<u32>(16i));
let _e395 = (_e394 == 0i);
phi_2022_ = ((((bitcast<u32>(f32(select(_e394, _e389, _e395))) >> bitcast<u32>(23i)) - 127u) + select(16u, 0u, _e395)) + 4294967275u);
}
let _e406 = phi_2022_;
let _e417 = ((((_e352 + 1i) + ((1i << bitcast<u32>((_e406 & 31u))) >> bitcast<u32>(1i))) + (_e389 >> bitcast<u32>(19i))) + 1i);
let _e421 = global_1.member.member_2.member;
let _e422 = bitcast<i32>(_e421);
let _e426 = global_1.member.member_2.member_1;
let _e427 = bitcast<i32>(_e426);
let _e431 = global_1.member.member_2.member_2;
let _e432 = bitcast<i32>(_e431);
let _e435 = ((_e360 - _e417) >> bitcast<u32>(_e386));
let _e437 = select(0i, _e435, (_e435 > 0i));
if (_e437 < _e422) {
phi_2056_ = _e437;
} else {
phi_2056_ = (_e422 - 1i);
}
let _e441 = phi_2056_;
let _e444 = ((_e362 - _e417) >> bitcast<u32>(_e386));
let _e446 = select(0i, _e444, (_e444 > 0i));
if (_e446 < _e427) {
phi_2070_ = _e446;
} else {
phi_2070_ = (_e427 - 1i);
}
let _e450 = phi_2070_;
let _e453 = ((_e364 - _e417) >> bitcast<u32>(_e386));
let _e455 = select(0i, _e453, (_e453 > 0i));
if (_e455 < _e432) {
phi_2084_ = _e455;
} else {
phi_2084_ = (_e432 - 1i);
}
let _e459 = phi_2084_;
let _e463 = ((_e372 + _e417) >> bitcast<u32>(_e386));
let _e465 = select(0i, _e463, (_e463 > 0i));
if (_e465 < _e422) {
phi_2099_ = _e465;
} else {
phi_2099_ = (_e422 - 1i);
}
let _e469 = phi_2099_;
let _e472 = ((_e374 + _e417) >> bitcast<u32>(_e386));
let _e474 = select(0i, _e472, (_e472 > 0i));
if (_e474 < _e427) {
phi_2113_ = _e474;
} else {
phi_2113_ = (_e427 - 1i);
}
let _e478 = phi_2113_;
let _e481 = ((_e376 + _e417) >> bitcast<u32>(_e386));
let _e483 = select(0i, _e481, (_e481 > 0i));
if (_e483 < _e432) {
phi_2127_ = _e483;
} else {
phi_2127_ = (_e432 - 1i);
}
let _e487 = phi_2127_;
phi_2133_ = type_14(vec3<i32>(_e294, _e300, _e306), vec3<i32>(_e313, _e319, _e325), vec3<i32>(_e332, _e338, _e344), vec3<i32>(_e441, _e450, _e459), vec3<i32>((_e469 - _e441), (_e478 - _e450), (_e487 - _e459)), _e417, _e348, _e406);
}
let _e588 = phi_2133_;
phi_2135_ = type_16(type_15(_e282, _e254, (_e254 + _e267)), _e588);
}
let _e926 = phi_2135_;
if (_e926.member.member_1 < _e926.member.member_2) {
let _e934 = (_e926.member_1.member_4.x == 0i);
let _e937 = (_e926.member_1.member_4.y == 0i);
let _e940 = (_e926.member_1.member_4.z == 0i);
if (((_e934 && _e937) || (_e937 && _e940)) || (_e940 && _e934)) {
phi_2170_ = 0u;
} else {
if _e934 {
phi_2169_ = 1u;
} else {
if _e937 {
phi_2168_ = 2u;
} else {
phi_2168_ = select(4u, 3u, _e940);
}
let _e948 = phi_2168_;
phi_2169_ = _e948;
}
let _e950 = phi_2169_;
phi_2170_ = _e950;
}
let _e952 = phi_2170_;
if (_e952 == 0u) {
let _e7000 = (_e926.member_1.member_6 & 31u);
let _e7002 = (_e926.member_1.member_3.x << bitcast<u32>(_e7000));
let _e7005 = (_e926.member_1.member_7 & 31u);
let _e7009 = ((1i << bitcast<u32>(_e7005)) >> bitcast<u32>(1i));
let _e7015 = bitcast<i32>(_e926.member_1.member_6);
let _e7021 = bitcast<f32>((bitcast<u32>((127i + (bitcast<i32>(_e926.member_1.member_7) - _e7015))) << bitcast<u32>(23i)));
let _e7022 = (f32((((_e926.member_1.member.x - _e7002) + _e7009) >> bitcast<u32>(_e7005))) * _e7021);
let _e7027 = (_e926.member_1.member_3.y << bitcast<u32>(_e7000));
let _e7033 = (f32((((_e926.member_1.member.y - _e7027) + _e7009) >> bitcast<u32>(_e7005))) * _e7021);
let _e7038 = (_e926.member_1.member_3.z << bitcast<u32>(_e7000));
let _e7044 = (f32((((_e926.member_1.member.z - _e7038) + _e7009) >> bitcast<u32>(_e7005))) * _e7021);
let _e7052 = (f32((((_e926.member_1.member_1.x - _e7002) + _e7009) >> bitcast<u32>(_e7005))) * _e7021);
let _e7059 = (f32((((_e926.member_1.member_1.y - _e7027) + _e7009) >> bitcast<u32>(_e7005))) * _e7021);
let _e7066 = (f32((((_e926.member_1.member_1.z - _e7038) + _e7009) >> bitcast<u32>(_e7005))) * _e7021);
let _e7074 = (f32((((_e926.member_1.member_2.x - _e7002) + _e7009) >> bitcast<u32>(_e7005))) * _e7021);
let _e7081 = (f32((((_e926.member_1.member_2.y - _e7027) + _e7009) >> bitcast<u32>(_e7005))) * _e7021);
let _e7088 = (f32((((_e926.member_1.member_2.z - _e7038) + _e7009) >> bitcast<u32>(_e7005))) * _e7021);
let _e7096 = (f32(_e926.member_1.member_5) * bitcast<f32>((bitcast<u32>((127i - _e7015)) << bitcast<u32>(23i))));
let _e7097 = (_e7052 - _e7022);
let _e7098 = (_e7059 - _e7033);
let _e7099 = (_e7066 - _e7044);
let _e7100 = (_e7074 - _e7052);
let _e7101 = (_e7081 - _e7059);
let _e7102 = (_e7088 - _e7066);
let _e7105 = ((_e7098 * _e7102) - (_e7099 * _e7101));
let _e7112 = (1f + _e7096);
let _e7115 = (_e926.member_1.member_4.z >= _e926.member_1.member_4.y);
if _e7115 {
let _e7209 = select(1f, -1f, (_e7105 < 0f));
let _e7214 = ((_e7044 - _e7066) * _e7209);
let _e7215 = ((_e7066 - _e7088) * _e7209);
let _e7216 = ((_e7088 - _e7044) * _e7209);
let _e7217 = ((0f - 0f) * _e7209);
let _e7219 = (_e7098 * _e7209);
let _e7220 = (_e7101 * _e7209);
let _e7221 = ((_e7033 - _e7081) * _e7209);
if (select(0u, 1u, ((_e7214 * _e7112) > -((_e7214 * _e7096)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e7215 * _e7112) > -((_e7215 * _e7096)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e7216 * _e7112) > -((_e7216 * _e7096)))) < 2u) {
} else {
break;
}
let _e7245 = (select(0u, 1u, ((_e7217 * _e7112) > -((_e7217 * _e7096)))) < 2u);
if _e7245 {
} else {
break;
}
if (select(0u, 1u, ((_e7219 * _e7112) > -((_e7219 * _e7096)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e7220 * _e7112) > -((_e7220 * _e7096)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e7221 * _e7112) > -((_e7221 * _e7096)))) < 2u) {
} else {
break;
}
if _e7245 {
} else {
break;
}
if (select(0u, 1u, (_e7214 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7215 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7216 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7217 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7214 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7215 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7216 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7217 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7214 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7215 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7216 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7217 < 0f)) < 2u) {
} else {
break;
}
} else {
let _e7117 = select(1f, -1f, (-(_e7105) < 0f));
let _e7122 = ((_e7033 - _e7059) * _e7117);
let _e7123 = ((_e7059 - _e7081) * _e7117);
let _e7124 = ((_e7081 - _e7033) * _e7117);
let _e7125 = ((0f - 0f) * _e7117);
let _e7127 = (_e7099 * _e7117);
let _e7128 = (_e7102 * _e7117);
let _e7129 = ((_e7044 - _e7088) * _e7117);
if (select(0u, 1u, ((_e7122 * _e7112) > -((_e7122 * _e7096)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e7123 * _e7112) > -((_e7123 * _e7096)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e7124 * _e7112) > -((_e7124 * _e7096)))) < 2u) {
} else {
break;
}
let _e7153 = (select(0u, 1u, ((_e7125 * _e7112) > -((_e7125 * _e7096)))) < 2u);
if _e7153 {
} else {
break;
}
if (select(0u, 1u, ((_e7127 * _e7112) > -((_e7127 * _e7096)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e7128 * _e7112) > -((_e7128 * _e7096)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e7129 * _e7112) > -((_e7129 * _e7096)))) < 2u) {
} else {
break;
}
if _e7153 {
} else {
break;
}
if (select(0u, 1u, (_e7122 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7123 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7124 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7125 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7122 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7123 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7124 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7125 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7122 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7123 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7124 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7125 < 0f)) < 2u) {
} else {
break;
}
}
let _e7302 = select(1f, -1f, (((_e7097 * _e7101) - (_e7098 * _e7100)) < 0f));
let _e7305 = (_e7081 - _e7033);
let _e7306 = (0f - 0f);
let _e7307 = ((_e7033 - _e7059) * _e7302);
let _e7308 = ((_e7059 - _e7081) * _e7302);
let _e7309 = (_e7305 * _e7302);
let _e7310 = (_e7306 * _e7302);
let _e7311 = (_e7022 - _e7074);
let _e7312 = (_e7097 * _e7302);
let _e7313 = (_e7100 * _e7302);
let _e7314 = (_e7311 * _e7302);
if (select(0u, 1u, ((_e7307 * _e7112) > -((_e7307 * _e7096)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e7308 * _e7112) > -((_e7308 * _e7096)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e7309 * _e7112) > -((_e7309 * _e7096)))) < 2u) {
} else {
break;
}
let _e7338 = (select(0u, 1u, ((_e7310 * _e7112) > -((_e7310 * _e7096)))) < 2u);
if _e7338 {
} else {
break;
}
if (select(0u, 1u, ((_e7312 * _e7112) > -((_e7312 * _e7096)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e7313 * _e7112) > -((_e7313 * _e7096)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e7314 * _e7112) > -((_e7314 * _e7096)))) < 2u) {
} else {
break;
}
if _e7338 {
} else {
break;
}
if (select(0u, 1u, (_e7307 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7308 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7309 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7310 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7307 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7308 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7309 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7310 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7307 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7308 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7309 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7310 < 0f)) < 2u) {
} else {
break;
}
let _e7394 = select(1f, -1f, (-(((_e7099 * _e7100) - (_e7097 * _e7102))) < 0f));
let _e7397 = (_e7088 - _e7044);
let _e7398 = ((_e7044 - _e7066) * _e7394);
let _e7399 = ((_e7066 - _e7088) * _e7394);
let _e7400 = (_e7397 * _e7394);
let _e7401 = (_e7306 * _e7394);
let _e7402 = (_e7097 * _e7394);
let _e7403 = (_e7100 * _e7394);
let _e7404 = (_e7311 * _e7394);
if (select(0u, 1u, ((_e7398 * _e7112) > -((_e7398 * _e7096)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e7399 * _e7112) > -((_e7399 * _e7096)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e7400 * _e7112) > -((_e7400 * _e7096)))) < 2u) {
} else {
break;
}
let _e7428 = (select(0u, 1u, ((_e7401 * _e7112) > -((_e7401 * _e7096)))) < 2u);
if _e7428 {
} else {
break;
}
if (select(0u, 1u, ((_e7402 * _e7112) > -((_e7402 * _e7096)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e7403 * _e7112) > -((_e7403 * _e7096)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e7404 * _e7112) > -((_e7404 * _e7096)))) < 2u) {
} else {
break;
}
if _e7428 {
} else {
break;
}
if (select(0u, 1u, (_e7398 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7399 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7400 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7401 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7398 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7399 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7400 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7401 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7398 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7399 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7400 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7401 < 0f)) < 2u) {
} else {
break;
}
let _e7483 = (_e7074 - _e7022);
let _e7485 = (_e926.member.member * 19i);
let _e7486 = (_e7485 + 18i);
let _e7488 = (bitcast<i32>(_e214) - 1i);
let _e7490 = select(_e7488, _e7486, (_e7486 < _e7488));
let _e7496 = global_4.member[bitcast<u32>(select(0i, _e7490, (_e7490 > 0i)))];
let _e7498 = select(0f, _e7496, (_e7496 > 0f));
let _e7500 = select(16777216f, _e7498, (_e7498 < 16777216f));
let _e7507 = select(0i, select(select(i32(_e7500), i32(-2147483648), (_e7500 < -2147483600f)), 2147483647i, (_e7500 > 2147483500f)), (_e7500 == _e7500));
phi_6169_ = _e926.member.member_1;
loop {
let _e7514 = phi_6169_;
let _e7515 = (_e7514 < _e926.member.member_2);
if _e7515 {
if _e7115 {
phi_6184_ = _e926.member_1.member_4.y;
} else {
phi_6184_ = _e926.member_1.member_4.z;
}
let _e7519 = phi_6184_;
phi_6186_ = 0i;
loop {
let _e7521 = phi_6186_;
let _e7522 = (_e7521 <= _e7519);
if _e7522 {
let _e7523 = select(_e7521, _e7514, _e7115);
let _e7524 = select(_e7514, _e7521, _e7115);
let _e7530 = global_1.member.member_2.member_1;
let _e7537 = global_1.member.member_3;
phi_6216_ = 0i;
loop {
let _e7541 = phi_6216_;
let _e7542 = (_e7541 <= _e926.member_1.member_4.x);
if _e7542 {
let _e7549 = ((f32(_e7541) + 0.5f) - _e7022);
let _e7550 = ((f32(_e7524) + 0.5f) - _e7033);
let _e7551 = ((f32(_e7523) + 0.5f) - _e7044);
let _e7556 = (((_e7097 * _e7097) + (_e7098 * _e7098)) + (_e7099 * _e7099));
let _e7561 = (((_e7097 * _e7483) + (_e7098 * _e7305)) + (_e7099 * _e7397));
let _e7566 = (((_e7483 * _e7483) + (_e7305 * _e7305)) + (_e7397 * _e7397));
let _e7571 = (((_e7549 * _e7097) + (_e7550 * _e7098)) + (_e7551 * _e7099));
let _e7576 = (((_e7549 * _e7483) + (_e7550 * _e7305)) + (_e7551 * _e7397));
let _e7579 = ((_e7556 * _e7566) - (_e7561 * _e7561));
let _e7580 = (_e7579 > 0f);
let _e7583 = select(0f, (1f / select(1f, _e7579, _e7580)), _e7580);
let _e7587 = (((_e7566 * _e7571) - (_e7561 * _e7576)) * _e7583);
let _e7591 = (((_e7556 * _e7576) - (_e7561 * _e7571)) * _e7583);
let _e7593 = ((1f - _e7587) - _e7591);
let _e7595 = select(0f, _e7593, (_e7593 > 0f));
let _e7597 = select(16777216f, _e7595, (_e7595 < 16777216f));
let _e7599 = select(0f, _e7587, (_e7587 > 0f));
let _e7601 = select(16777216f, _e7599, (_e7599 < 16777216f));
let _e7603 = select(0f, _e7591, (_e7591 > 0f));
let _e7605 = select(16777216f, _e7603, (_e7603 < 16777216f));
let _e7607 = ((_e7597 + _e7601) + _e7605);
let _e7610 = (1f / select(0.5f, _e7607, (_e7607 > 0.5f)));
let _e7611 = (_e7597 * _e7610);
let _e7612 = (_e7601 * _e7610);
let _e7613 = (_e7605 * _e7610);
let _e7615 = select(_e7488, _e7485, (_e7485 < _e7488));
let _e7621 = global_4.member[bitcast<u32>(select(0i, _e7615, (_e7615 > 0i)))];
let _e7622 = (_e7485 + 1i);
let _e7624 = select(_e7488, _e7622, (_e7622 < _e7488));
let _e7630 = global_4.member[bitcast<u32>(select(0i, _e7624, (_e7624 > 0i)))];
let _e7631 = (_e7485 + 2i);
let _e7633 = select(_e7488, _e7631, (_e7631 < _e7488));
let _e7639 = global_4.member[bitcast<u32>(select(0i, _e7633, (_e7633 > 0i)))];
let _e7640 = (_e7485 + 3i);
let _e7642 = select(_e7488, _e7640, (_e7640 < _e7488));
let _e7648 = global_4.member[bitcast<u32>(select(0i, _e7642, (_e7642 > 0i)))];
let _e7649 = (_e7485 + 4i);
let _e7651 = select(_e7488, _e7649, (_e7649 < _e7488));
let _e7657 = global_4.member[bitcast<u32>(select(0i, _e7651, (_e7651 > 0i)))];
let _e7658 = (_e7485 + 5i);
let _e7660 = select(_e7488, _e7658, (_e7658 < _e7488));
let _e7666 = global_4.member[bitcast<u32>(select(0i, _e7660, (_e7660 > 0i)))];
let _e7667 = (_e7485 + 6i);
let _e7669 = select(_e7488, _e7667, (_e7667 < _e7488));
let _e7675 = global_4.member[bitcast<u32>(select(0i, _e7669, (_e7669 > 0i)))];
let _e7676 = (_e7485 + 7i);
let _e7678 = select(_e7488, _e7676, (_e7676 < _e7488));
let _e7684 = global_4.member[bitcast<u32>(select(0i, _e7678, (_e7678 > 0i)))];
let _e7685 = (_e7485 + 8i);
let _e7687 = select(_e7488, _e7685, (_e7685 < _e7488));
let _e7693 = global_4.member[bitcast<u32>(select(0i, _e7687, (_e7687 > 0i)))];
let _e7698 = (((_e7621 * _e7611) + (_e7648 * _e7612)) + (_e7675 * _e7613));
let _e7703 = (((_e7630 * _e7611) + (_e7657 * _e7612)) + (_e7684 * _e7613));
let _e7708 = (((_e7639 * _e7611) + (_e7666 * _e7612)) + (_e7693 * _e7613));
let _e7713 = (((_e7698 * _e7698) + (_e7703 * _e7703)) + (_e7708 * _e7708));
let _e7716 = sqrt(select(0f, _e7713, (_e7713 > 0f)));
let _e7717 = (_e7716 > 1e-6f);
let _e7720 = select(0f, (1f / select(1e-6f, _e7716, _e7717)), _e7717);
let _e7721 = (_e7485 + 9i);
let _e7723 = select(_e7488, _e7721, (_e7721 < _e7488));
let _e7729 = global_4.member[bitcast<u32>(select(0i, _e7723, (_e7723 > 0i)))];
let _e7730 = (_e7485 + 10i);
let _e7732 = select(_e7488, _e7730, (_e7730 < _e7488));
let _e7738 = global_4.member[bitcast<u32>(select(0i, _e7732, (_e7732 > 0i)))];
let _e7739 = (_e7485 + 11i);
let _e7741 = select(_e7488, _e7739, (_e7739 < _e7488));
let _e7747 = global_4.member[bitcast<u32>(select(0i, _e7741, (_e7741 > 0i)))];
let _e7748 = (_e7485 + 12i);
let _e7750 = select(_e7488, _e7748, (_e7748 < _e7488));
let _e7756 = global_4.member[bitcast<u32>(select(0i, _e7750, (_e7750 > 0i)))];
let _e7757 = (_e7485 + 13i);
let _e7759 = select(_e7488, _e7757, (_e7757 < _e7488));
let _e7765 = global_4.member[bitcast<u32>(select(0i, _e7759, (_e7759 > 0i)))];
let _e7766 = (_e7485 + 14i);
let _e7768 = select(_e7488, _e7766, (_e7766 < _e7488));
let _e7774 = global_4.member[bitcast<u32>(select(0i, _e7768, (_e7768 > 0i)))];
let _e7775 = (_e7485 + 15i);
let _e7777 = select(_e7488, _e7775, (_e7775 < _e7488));
let _e7783 = global_4.member[bitcast<u32>(select(0i, _e7777, (_e7777 > 0i)))];
let _e7784 = (_e7485 + 16i);
let _e7786 = select(_e7488, _e7784, (_e7784 < _e7488));
let _e7792 = global_4.member[bitcast<u32>(select(0i, _e7786, (_e7786 > 0i)))];
let _e7793 = (_e7485 + 17i);
let _e7795 = select(_e7488, _e7793, (_e7793 < _e7488));
let _e7801 = global_4.member[bitcast<u32>(select(0i, _e7795, (_e7795 > 0i)))];
let _e7817 = (_e926.member_1.member_3.x + _e7541);
let _e7820 = ((((((_e926.member_1.member_3.z + _e7523) * bitcast<i32>(_e7530)) + _e926.member_1.member_3.y) + _e7524) * bitcast<i32>(_e7537)) + (_e7817 >> bitcast<u32>(5i)));
let _e7824 = (bitcast<i32>(_e218) - 1i);
let _e7826 = select(_e7824, _e7820, (_e7820 < _e7824));
let _e7832 = global_6.member[bitcast<u32>(select(0i, _e7826, (_e7826 > 0i)))];
let _e7834 = (bitcast<i32>(_e216) - 1i);
let _e7836 = select(_e7834, _e7820, (_e7820 < _e7834));
let _e7842 = global_5.member[bitcast<u32>(select(0i, _e7836, (_e7836 > 0i)))];
let _e7851 = (bitcast<i32>((_e7832 + countOneBits((_e7842 & ((1u << bitcast<u32>((bitcast<u32>((_e7817 & 31i)) & 31u))) - 1u))))) * 14i);
let _e7852 = bitcast<u32>(_e7851);
if (_e7852 < _e220) {
let _e7856 = atomicAdd((&global_7.member[_e7852]), 1u);
}
let _e7858 = bitcast<u32>((_e7851 + 1i));
if (_e7858 < _e220) {
let _e7862 = atomicMax((&global_7.member[_e7858]), bitcast<u32>((_e7507 - select(0i, 1i, (_e7500 < f32(_e7507))))));
}
let _e7868 = (((_e7698 * _e7720) * 65536f) + 0.5f);
let _e7870 = select(-1073741800f, _e7868, (_e7868 > -1073741800f));
let _e7872 = select(1073741800f, _e7870, (_e7870 < 1073741800f));
let _e7879 = select(0i, select(select(i32(_e7872), i32(-2147483648), (_e7872 < -2147483600f)), 2147483647i, (_e7872 > 2147483500f)), (_e7872 == _e7872));
let _e7883 = (_e7879 - select(0i, 1i, (_e7872 < f32(_e7879))));
if (_e7883 == 0i) {
} else {
let _e7885 = bitcast<u32>(_e7883);
let _e7886 = bitcast<u32>((_e7851 + 2i));
if (_e7886 < _e220) {
let _e7890 = atomicAdd((&global_7.member[_e7886]), _e7885);
phi_6744_ = _e7890;
} else {
phi_6744_ = 0u;
}
let _e7892 = phi_6744_;
let _e7899 = (bitcast<u32>((_e7883 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e7892 + _e7885) < _e7885)));
if (_e7899 == 0u) {
} else {
let _e7901 = (_e7886 + 1u);
if (_e7901 < _e220) {
let _e7905 = atomicAdd((&global_7.member[_e7901]), _e7899);
}
}
}
let _e7908 = (((_e7703 * _e7720) * 65536f) + 0.5f);
let _e7910 = select(-1073741800f, _e7908, (_e7908 > -1073741800f));
let _e7912 = select(1073741800f, _e7910, (_e7910 < 1073741800f));
let _e7919 = select(0i, select(select(i32(_e7912), i32(-2147483648), (_e7912 < -2147483600f)), 2147483647i, (_e7912 > 2147483500f)), (_e7912 == _e7912));
let _e7923 = (_e7919 - select(0i, 1i, (_e7912 < f32(_e7919))));
if (_e7923 == 0i) {
} else {
let _e7925 = bitcast<u32>(_e7923);
let _e7926 = bitcast<u32>((_e7851 + 4i));
if (_e7926 < _e220) {
let _e7930 = atomicAdd((&global_7.member[_e7926]), _e7925);
phi_6801_ = _e7930;
} else {
phi_6801_ = 0u;
}
let _e7932 = phi_6801_;
let _e7939 = (bitcast<u32>((_e7923 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e7932 + _e7925) < _e7925)));
if (_e7939 == 0u) {
} else {
let _e7941 = (_e7926 + 1u);
if (_e7941 < _e220) {
let _e7945 = atomicAdd((&global_7.member[_e7941]), _e7939);
}
}
}
let _e7948 = (((_e7708 * _e7720) * 65536f) + 0.5f);
let _e7950 = select(-1073741800f, _e7948, (_e7948 > -1073741800f));
let _e7952 = select(1073741800f, _e7950, (_e7950 < 1073741800f));
let _e7959 = select(0i, select(select(i32(_e7952), i32(-2147483648), (_e7952 < -2147483600f)), 2147483647i, (_e7952 > 2147483500f)), (_e7952 == _e7952));
let _e7963 = (_e7959 - select(0i, 1i, (_e7952 < f32(_e7959))));
if (_e7963 == 0i) {
} else {
let _e7965 = bitcast<u32>(_e7963);
let _e7966 = bitcast<u32>((_e7851 + 6i));
if (_e7966 < _e220) {
let _e7970 = atomicAdd((&global_7.member[_e7966]), _e7965);
phi_6858_ = _e7970;
} else {
phi_6858_ = 0u;
}
let _e7972 = phi_6858_;
let _e7979 = (bitcast<u32>((_e7963 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e7972 + _e7965) < _e7965)));
if (_e7979 == 0u) {
} else {
let _e7981 = (_e7966 + 1u);
if (_e7981 < _e220) {
let _e7985 = atomicAdd((&global_7.member[_e7981]), _e7979);
}
}
}
let _e7988 = (((((_e7729 * _e7611) + (_e7756 * _e7612)) + (_e7783 * _e7613)) * 65536f) + 0.5f);
let _e7990 = select(-1073741800f, _e7988, (_e7988 > -1073741800f));
let _e7992 = select(1073741800f, _e7990, (_e7990 < 1073741800f));
let _e7999 = select(0i, select(select(i32(_e7992), i32(-2147483648), (_e7992 < -2147483600f)), 2147483647i, (_e7992 > 2147483500f)), (_e7992 == _e7992));
let _e8003 = (_e7999 - select(0i, 1i, (_e7992 < f32(_e7999))));
if (_e8003 == 0i) {
} else {
let _e8005 = bitcast<u32>(_e8003);
let _e8006 = bitcast<u32>((_e7851 + 8i));
if (_e8006 < _e220) {
let _e8010 = atomicAdd((&global_7.member[_e8006]), _e8005);
phi_6916_ = _e8010;
} else {
phi_6916_ = 0u;
}
let _e8012 = phi_6916_;
let _e8019 = (bitcast<u32>((_e8003 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e8012 + _e8005) < _e8005)));
if (_e8019 == 0u) {
} else {
let _e8021 = (_e8006 + 1u);
if (_e8021 < _e220) {
let _e8025 = atomicAdd((&global_7.member[_e8021]), _e8019);
}
}
}
let _e8028 = (((((_e7738 * _e7611) + (_e7765 * _e7612)) + (_e7792 * _e7613)) * 65536f) + 0.5f);
let _e8030 = select(-1073741800f, _e8028, (_e8028 > -1073741800f));
let _e8032 = select(1073741800f, _e8030, (_e8030 < 1073741800f));
let _e8039 = select(0i, select(select(i32(_e8032), i32(-2147483648), (_e8032 < -2147483600f)), 2147483647i, (_e8032 > 2147483500f)), (_e8032 == _e8032));
let _e8043 = (_e8039 - select(0i, 1i, (_e8032 < f32(_e8039))));
if (_e8043 == 0i) {
} else {
let _e8045 = bitcast<u32>(_e8043);
let _e8046 = bitcast<u32>((_e7851 + 10i));
if (_e8046 < _e220) {
let _e8050 = atomicAdd((&global_7.member[_e8046]), _e8045);
phi_6973_ = _e8050;
} else {
phi_6973_ = 0u;
}
let _e8052 = phi_6973_;
let _e8059 = (bitcast<u32>((_e8043 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e8052 + _e8045) < _e8045)));
if (_e8059 == 0u) {
} else {
let _e8061 = (_e8046 + 1u);
if (_e8061 < _e220) {
let _e8065 = atomicAdd((&global_7.member[_e8061]), _e8059);
}
}
}
let _e8068 = (((((_e7747 * _e7611) + (_e7774 * _e7612)) + (_e7801 * _e7613)) * 65536f) + 0.5f);
let _e8070 = select(-1073741800f, _e8068, (_e8068 > -1073741800f));
let _e8072 = select(1073741800f, _e8070, (_e8070 < 1073741800f));
let _e8079 = select(0i, select(select(i32(_e8072), i32(-2147483648), (_e8072 < -2147483600f)), 2147483647i, (_e8072 > 2147483500f)), (_e8072 == _e8072));
let _e8083 = (_e8079 - select(0i, 1i, (_e8072 < f32(_e8079))));
if (_e8083 == 0i) {
} else {
let _e8085 = bitcast<u32>(_e8083);
let _e8086 = bitcast<u32>((_e7851 + 12i));
if (_e8086 < _e220) {
let _e8090 = atomicAdd((&global_7.member[_e8086]), _e8085);
phi_7030_ = _e8090;
} else {
phi_7030_ = 0u;
}
let _e8092 = phi_7030_;
let _e8099 = (bitcast<u32>((_e8083 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e8092 + _e8085) < _e8085)));
if (_e8099 == 0u) {
} else {
let _e8101 = (_e8086 + 1u);
if (_e8101 < _e220) {
let _e8105 = atomicAdd((&global_7.member[_e8101]), _e8099);
}
}
}
phi_6217_ = (_e7541 + 1i);
} else {
phi_6217_ = i32();
}
let _e8108 = phi_6217_;
continue;
continuing {
phi_6216_ = _e8108;
break if !(_e7542);
}
}
phi_6187_ = (_e7521 + 1i);
} else {
phi_6187_ = i32();
}
let _e8112 = phi_6187_;
continue;
continuing {
phi_6186_ = _e8112;
break if !(_e7522);
}
}
phi_6170_ = (_e7514 + 1i);
} else {
phi_6170_ = i32();
}
let _e8116 = phi_6170_;
continue;
continuing {
phi_6169_ = _e8116;
break if !(_e7515);
}
}
} else {
if (_e952 == 1u) {
let _e5488 = (_e926.member_1.member_6 & 31u);
let _e5490 = (_e926.member_1.member_3.x << bitcast<u32>(_e5488));
let _e5493 = (_e926.member_1.member_7 & 31u);
let _e5497 = ((1i << bitcast<u32>(_e5493)) >> bitcast<u32>(1i));
let _e5503 = bitcast<i32>(_e926.member_1.member_6);
let _e5509 = bitcast<f32>((bitcast<u32>((127i + (bitcast<i32>(_e926.member_1.member_7) - _e5503))) << bitcast<u32>(23i)));
let _e5510 = (f32((((_e926.member_1.member.x - _e5490) + _e5497) >> bitcast<u32>(_e5493))) * _e5509);
let _e5515 = (_e926.member_1.member_3.y << bitcast<u32>(_e5488));
let _e5521 = (f32((((_e926.member_1.member.y - _e5515) + _e5497) >> bitcast<u32>(_e5493))) * _e5509);
let _e5526 = (_e926.member_1.member_3.z << bitcast<u32>(_e5488));
let _e5532 = (f32((((_e926.member_1.member.z - _e5526) + _e5497) >> bitcast<u32>(_e5493))) * _e5509);
let _e5540 = (f32((((_e926.member_1.member_1.x - _e5490) + _e5497) >> bitcast<u32>(_e5493))) * _e5509);
let _e5547 = (f32((((_e926.member_1.member_1.y - _e5515) + _e5497) >> bitcast<u32>(_e5493))) * _e5509);
let _e5554 = (f32((((_e926.member_1.member_1.z - _e5526) + _e5497) >> bitcast<u32>(_e5493))) * _e5509);
let _e5562 = (f32((((_e926.member_1.member_2.x - _e5490) + _e5497) >> bitcast<u32>(_e5493))) * _e5509);
let _e5569 = (f32((((_e926.member_1.member_2.y - _e5515) + _e5497) >> bitcast<u32>(_e5493))) * _e5509);
let _e5576 = (f32((((_e926.member_1.member_2.z - _e5526) + _e5497) >> bitcast<u32>(_e5493))) * _e5509);
let _e5584 = (f32(_e926.member_1.member_5) * bitcast<f32>((bitcast<u32>((127i - _e5503)) << bitcast<u32>(23i))));
let _e5585 = (_e5540 - _e5510);
let _e5586 = (_e5547 - _e5521);
let _e5587 = (_e5554 - _e5532);
let _e5588 = (_e5562 - _e5540);
let _e5589 = (_e5569 - _e5547);
let _e5590 = (_e5576 - _e5554);
let _e5591 = (_e5586 * _e5590);
let _e5592 = (_e5587 * _e5589);
let _e5593 = (_e5591 - _e5592);
let _e5607 = ((bitcast<f32>((bitcast<u32>(_e5591) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e5592) & 2147483647u))) * 2.3841858e-7f);
let _e5608 = f32(_e926.member_1.member_4.y);
let _e5609 = f32(_e926.member_1.member_4.z);
let _e5610 = (1f + _e5584);
let _e5611 = -(_e5593);
let _e5613 = (_e926.member_1.member_4.z >= _e926.member_1.member_4.y);
if _e5613 {
let _e5854 = select(1f, -1f, (_e5593 < 0f));
let _e5860 = select(0f, (2f * _e5607), (bitcast<f32>((bitcast<u32>(_e5593) & 2147483647u)) <= _e5607));
let _e5865 = ((_e5532 - _e5554) * _e5854);
let _e5866 = ((_e5554 - _e5576) * _e5854);
let _e5867 = ((_e5576 - _e5532) * _e5854);
let _e5868 = ((0f - 0f) * _e5854);
let _e5870 = (_e5586 * _e5854);
let _e5871 = (_e5589 * _e5854);
let _e5872 = ((_e5521 - _e5569) * _e5854);
let _e5874 = (_e5865 * _e5610);
let _e5875 = (_e5866 * _e5610);
let _e5876 = (_e5867 * _e5610);
let _e5877 = (_e5868 * _e5610);
let _e5882 = -((_e5865 * _e5584));
let _e5883 = -((_e5866 * _e5584));
let _e5884 = -((_e5867 * _e5584));
let _e5885 = -((_e5868 * _e5584));
local_136 = array<u32, 2>(0u, 4294967295u);
let _e5890 = select(0u, 1u, (_e5874 > _e5882));
if (_e5890 < 2u) {
} else {
break;
}
let _e5893 = local_136[_e5890];
local_137 = array<u32, 2>(0u, 4294967295u);
let _e5894 = select(0u, 1u, (_e5875 > _e5883));
if (_e5894 < 2u) {
} else {
break;
}
let _e5897 = local_137[_e5894];
local_138 = array<u32, 2>(0u, 4294967295u);
let _e5898 = select(0u, 1u, (_e5876 > _e5884));
if (_e5898 < 2u) {
} else {
break;
}
let _e5901 = local_138[_e5898];
local_139 = array<u32, 2>(0u, 4294967295u);
let _e5902 = select(0u, 1u, (_e5877 > _e5885));
let _e5903 = (_e5902 < 2u);
if _e5903 {
} else {
break;
}
let _e5905 = local_139[_e5902];
let _e5921 = (_e5868 * 0f);
let _e5926 = (_e5870 * _e5610);
let _e5927 = (_e5871 * _e5610);
let _e5928 = (_e5872 * _e5610);
let _e5932 = -((_e5870 * _e5584));
let _e5933 = -((_e5871 * _e5584));
let _e5934 = -((_e5872 * _e5584));
local_132 = array<u32, 2>(0u, 4294967295u);
let _e5938 = select(0u, 1u, (_e5926 > _e5932));
if (_e5938 < 2u) {
} else {
break;
}
let _e5941 = local_132[_e5938];
local_133 = array<u32, 2>(0u, 4294967295u);
let _e5942 = select(0u, 1u, (_e5927 > _e5933));
if (_e5942 < 2u) {
} else {
break;
}
let _e5945 = local_133[_e5942];
local_134 = array<u32, 2>(0u, 4294967295u);
let _e5946 = select(0u, 1u, (_e5928 > _e5934));
if (_e5946 < 2u) {
} else {
break;
}
let _e5949 = local_134[_e5946];
local_135 = array<u32, 2>(0u, 4294967295u);
if _e5903 {
} else {
break;
}
let _e5951 = local_135[_e5902];
local_128 = array<u32, 2>(0u, 4294967295u);
let _e5984 = select(0u, 1u, (_e5865 == 0f));
if (_e5984 < 2u) {
} else {
break;
}
let _e5987 = local_128[_e5984];
local_129 = array<u32, 2>(0u, 4294967295u);
let _e5988 = select(0u, 1u, (_e5866 == 0f));
if (_e5988 < 2u) {
} else {
break;
}
let _e5991 = local_129[_e5988];
local_130 = array<u32, 2>(0u, 4294967295u);
let _e5992 = select(0u, 1u, (_e5867 == 0f));
if (_e5992 < 2u) {
} else {
break;
}
let _e5995 = local_130[_e5992];
local_131 = array<u32, 2>(0u, 4294967295u);
let _e5996 = select(0u, 1u, (_e5868 == 0f));
if (_e5996 < 2u) {
} else {
break;
}
let _e5999 = local_131[_e5996];
let _e6001 = ((_e5987 & 1u) != 0u);
let _e6004 = ((_e5991 & 1u) != 0u);
let _e6007 = ((_e5995 & 1u) != 0u);
let _e6010 = ((_e5999 & 1u) != 0u);
let _e6012 = (-1f / select(_e5865, 1f, _e6001));
let _e6013 = (-1f / select(_e5866, 1f, _e6004));
let _e6014 = (-1f / select(_e5867, 1f, _e6007));
let _e6015 = (-1f / select(_e5868, 1f, _e6010));
local_124 = array<u32, 2>(0u, 4294967295u);
let _e6020 = select(0u, 1u, (_e5865 > 0f));
if (_e6020 < 2u) {
} else {
break;
}
let _e6023 = local_124[_e6020];
local_125 = array<u32, 2>(0u, 4294967295u);
let _e6024 = select(0u, 1u, (_e5866 > 0f));
if (_e6024 < 2u) {
} else {
break;
}
let _e6027 = local_125[_e6024];
local_126 = array<u32, 2>(0u, 4294967295u);
let _e6028 = select(0u, 1u, (_e5867 > 0f));
if (_e6028 < 2u) {
} else {
break;
}
let _e6031 = local_126[_e6028];
local_127 = array<u32, 2>(0u, 4294967295u);
let _e6032 = select(0u, 1u, (_e5868 > 0f));
if (_e6032 < 2u) {
} else {
break;
}
let _e6035 = local_127[_e6032];
local_120 = array<u32, 2>(0u, 4294967295u);
let _e6040 = select(0u, 1u, (_e5865 < 0f));
if (_e6040 < 2u) {
} else {
break;
}
let _e6043 = local_120[_e6040];
local_121 = array<u32, 2>(0u, 4294967295u);
let _e6044 = select(0u, 1u, (_e5866 < 0f));
if (_e6044 < 2u) {
} else {
break;
}
let _e6047 = local_121[_e6044];
local_122 = array<u32, 2>(0u, 4294967295u);
let _e6048 = select(0u, 1u, (_e5867 < 0f));
if (_e6048 < 2u) {
} else {
break;
}
let _e6051 = local_122[_e6048];
local_123 = array<u32, 2>(0u, 4294967295u);
let _e6052 = select(0u, 1u, (_e5868 < 0f));
if (_e6052 < 2u) {
} else {
break;
}
let _e6055 = local_123[_e6052];
let _e6074 = ((_e6043 & 1u) != 0u);
let _e6077 = ((_e6047 & 1u) != 0u);
let _e6080 = ((_e6051 & 1u) != 0u);
let _e6083 = ((_e6055 & 1u) != 0u);
phi_9093_ = type_18(vec4<f32>(_e5870, _e5871, _e5872, _e5868), vec4<f32>((((select(_e5882, _e5874, ((_e5893 & 1u) != 0u)) - (_e5865 * _e5521)) + (select(_e5932, _e5926, ((_e5941 & 1u) != 0u)) - (_e5870 * _e5532))) + _e5860), (((select(_e5883, _e5875, ((_e5897 & 1u) != 0u)) - (_e5866 * _e5547)) + (select(_e5933, _e5927, ((_e5945 & 1u) != 0u)) - (_e5871 * _e5554))) + _e5860), (((select(_e5884, _e5876, ((_e5901 & 1u) != 0u)) - (_e5867 * _e5569)) + (select(_e5934, _e5928, ((_e5949 & 1u) != 0u)) - (_e5872 * _e5576))) + _e5860), (((select(_e5885, _e5877, ((_e5905 & 1u) != 0u)) - _e5921) + (select(_e5885, _e5877, ((_e5951 & 1u) != 0u)) - _e5921)) + _e5860)), vec4<f32>(select(0f, _e6012, ((_e6023 & 1u) != 0u)), select(0f, _e6013, ((_e6027 & 1u) != 0u)), select(0f, _e6014, ((_e6031 & 1u) != 0u)), select(0f, _e6015, ((_e6035 & 1u) != 0u))), vec4<f32>(select(select(0f, 1e20f, _e6001), _e6012, _e6074), select(select(0f, 1e20f, _e6004), _e6013, _e6077), select(select(0f, 1e20f, _e6007), _e6014, _e6080), select(select(0f, 1e20f, _e6010), _e6015, _e6083)), vec4<f32>(select(_e5608, 0f, _e6074), select(_e5608, 0f, _e6077), select(_e5608, 0f, _e6080), select(_e5608, 0f, _e6083)));
} else {
let _e5615 = select(1f, -1f, (_e5611 < 0f));
let _e5621 = select(0f, (2f * _e5607), (bitcast<f32>((bitcast<u32>(_e5611) & 2147483647u)) <= _e5607));
let _e5626 = ((_e5521 - _e5547) * _e5615);
let _e5627 = ((_e5547 - _e5569) * _e5615);
let _e5628 = ((_e5569 - _e5521) * _e5615);
let _e5629 = ((0f - 0f) * _e5615);
let _e5631 = (_e5587 * _e5615);
let _e5632 = (_e5590 * _e5615);
let _e5633 = ((_e5532 - _e5576) * _e5615);
let _e5635 = (_e5626 * _e5610);
let _e5636 = (_e5627 * _e5610);
let _e5637 = (_e5628 * _e5610);
let _e5638 = (_e5629 * _e5610);
let _e5643 = -((_e5626 * _e5584));
let _e5644 = -((_e5627 * _e5584));
let _e5645 = -((_e5628 * _e5584));
let _e5646 = -((_e5629 * _e5584));
local_116 = array<u32, 2>(0u, 4294967295u);
let _e5651 = select(0u, 1u, (_e5635 > _e5643));
if (_e5651 < 2u) {
} else {
break;
}
let _e5654 = local_116[_e5651];
local_117 = array<u32, 2>(0u, 4294967295u);
let _e5655 = select(0u, 1u, (_e5636 > _e5644));
if (_e5655 < 2u) {
} else {
break;
}
let _e5658 = local_117[_e5655];
local_118 = array<u32, 2>(0u, 4294967295u);
let _e5659 = select(0u, 1u, (_e5637 > _e5645));
if (_e5659 < 2u) {
} else {
break;
}
let _e5662 = local_118[_e5659];
local_119 = array<u32, 2>(0u, 4294967295u);
let _e5663 = select(0u, 1u, (_e5638 > _e5646));
let _e5664 = (_e5663 < 2u);
if _e5664 {
} else {
break;
}
let _e5666 = local_119[_e5663];
let _e5682 = (_e5629 * 0f);
let _e5687 = (_e5631 * _e5610);
let _e5688 = (_e5632 * _e5610);
let _e5689 = (_e5633 * _e5610);
let _e5693 = -((_e5631 * _e5584));
let _e5694 = -((_e5632 * _e5584));
let _e5695 = -((_e5633 * _e5584));
local_112 = array<u32, 2>(0u, 4294967295u);
let _e5699 = select(0u, 1u, (_e5687 > _e5693));
if (_e5699 < 2u) {
} else {
break;
}
let _e5702 = local_112[_e5699];
local_113 = array<u32, 2>(0u, 4294967295u);
let _e5703 = select(0u, 1u, (_e5688 > _e5694));
if (_e5703 < 2u) {
} else {
break;
}
let _e5706 = local_113[_e5703];
local_114 = array<u32, 2>(0u, 4294967295u);
let _e5707 = select(0u, 1u, (_e5689 > _e5695));
if (_e5707 < 2u) {
} else {
break;
}
let _e5710 = local_114[_e5707];
local_115 = array<u32, 2>(0u, 4294967295u);
if _e5664 {
} else {
break;
}
let _e5712 = local_115[_e5663];
local_108 = array<u32, 2>(0u, 4294967295u);
let _e5745 = select(0u, 1u, (_e5626 == 0f));
if (_e5745 < 2u) {
} else {
break;
}
let _e5748 = local_108[_e5745];
local_109 = array<u32, 2>(0u, 4294967295u);
let _e5749 = select(0u, 1u, (_e5627 == 0f));
if (_e5749 < 2u) {
} else {
break;
}
let _e5752 = local_109[_e5749];
local_110 = array<u32, 2>(0u, 4294967295u);
let _e5753 = select(0u, 1u, (_e5628 == 0f));
if (_e5753 < 2u) {
} else {
break;
}
let _e5756 = local_110[_e5753];
local_111 = array<u32, 2>(0u, 4294967295u);
let _e5757 = select(0u, 1u, (_e5629 == 0f));
if (_e5757 < 2u) {
} else {
break;
}
let _e5760 = local_111[_e5757];
let _e5762 = ((_e5748 & 1u) != 0u);
let _e5765 = ((_e5752 & 1u) != 0u);
let _e5768 = ((_e5756 & 1u) != 0u);
let _e5771 = ((_e5760 & 1u) != 0u);
let _e5773 = (-1f / select(_e5626, 1f, _e5762));
let _e5774 = (-1f / select(_e5627, 1f, _e5765));
let _e5775 = (-1f / select(_e5628, 1f, _e5768));
let _e5776 = (-1f / select(_e5629, 1f, _e5771));
local_104 = array<u32, 2>(0u, 4294967295u);
let _e5781 = select(0u, 1u, (_e5626 > 0f));
if (_e5781 < 2u) {
} else {
break;
}
let _e5784 = local_104[_e5781];
local_105 = array<u32, 2>(0u, 4294967295u);
let _e5785 = select(0u, 1u, (_e5627 > 0f));
if (_e5785 < 2u) {
} else {
break;
}
let _e5788 = local_105[_e5785];
local_106 = array<u32, 2>(0u, 4294967295u);
let _e5789 = select(0u, 1u, (_e5628 > 0f));
if (_e5789 < 2u) {
} else {
break;
}
let _e5792 = local_106[_e5789];
local_107 = array<u32, 2>(0u, 4294967295u);
let _e5793 = select(0u, 1u, (_e5629 > 0f));
if (_e5793 < 2u) {
} else {
break;
}
let _e5796 = local_107[_e5793];
local_100 = array<u32, 2>(0u, 4294967295u);
let _e5801 = select(0u, 1u, (_e5626 < 0f));
if (_e5801 < 2u) {
} else {
break;
}
let _e5804 = local_100[_e5801];
local_101 = array<u32, 2>(0u, 4294967295u);
let _e5805 = select(0u, 1u, (_e5627 < 0f));
if (_e5805 < 2u) {
} else {
break;
}
let _e5808 = local_101[_e5805];
local_102 = array<u32, 2>(0u, 4294967295u);
let _e5809 = select(0u, 1u, (_e5628 < 0f));
if (_e5809 < 2u) {
} else {
break;
}
let _e5812 = local_102[_e5809];
local_103 = array<u32, 2>(0u, 4294967295u);
let _e5813 = select(0u, 1u, (_e5629 < 0f));
if (_e5813 < 2u) {
} else {
break;
}
let _e5816 = local_103[_e5813];
let _e5835 = ((_e5804 & 1u) != 0u);
let _e5838 = ((_e5808 & 1u) != 0u);
let _e5841 = ((_e5812 & 1u) != 0u);
let _e5844 = ((_e5816 & 1u) != 0u);
phi_9093_ = type_18(vec4<f32>(_e5631, _e5632, _e5633, _e5629), vec4<f32>((((select(_e5643, _e5635, ((_e5654 & 1u) != 0u)) - (_e5626 * _e5532)) + (select(_e5693, _e5687, ((_e5702 & 1u) != 0u)) - (_e5631 * _e5521))) + _e5621), (((select(_e5644, _e5636, ((_e5658 & 1u) != 0u)) - (_e5627 * _e5554)) + (select(_e5694, _e5688, ((_e5706 & 1u) != 0u)) - (_e5632 * _e5547))) + _e5621), (((select(_e5645, _e5637, ((_e5662 & 1u) != 0u)) - (_e5628 * _e5576)) + (select(_e5695, _e5689, ((_e5710 & 1u) != 0u)) - (_e5633 * _e5569))) + _e5621), (((select(_e5646, _e5638, ((_e5666 & 1u) != 0u)) - _e5682) + (select(_e5646, _e5638, ((_e5712 & 1u) != 0u)) - _e5682)) + _e5621)), vec4<f32>(select(0f, _e5773, ((_e5784 & 1u) != 0u)), select(0f, _e5774, ((_e5788 & 1u) != 0u)), select(0f, _e5775, ((_e5792 & 1u) != 0u)), select(0f, _e5776, ((_e5796 & 1u) != 0u))), vec4<f32>(select(select(0f, 1e20f, _e5762), _e5773, _e5835), select(select(0f, 1e20f, _e5765), _e5774, _e5838), select(select(0f, 1e20f, _e5768), _e5775, _e5841), select(select(0f, 1e20f, _e5771), _e5776, _e5844)), vec4<f32>(select(_e5609, 0f, _e5835), select(_e5609, 0f, _e5838), select(_e5609, 0f, _e5841), select(_e5609, 0f, _e5844)));
}
let _e6093 = phi_9093_;
let _e6096 = select(1f, -1f, (((_e5585 * _e5589) - (_e5586 * _e5588)) < 0f));
let _e6099 = (_e5569 - _e5521);
let _e6100 = (0f - 0f);
let _e6101 = ((_e5521 - _e5547) * _e6096);
let _e6102 = ((_e5547 - _e5569) * _e6096);
let _e6103 = (_e6099 * _e6096);
let _e6104 = (_e6100 * _e6096);
let _e6105 = (_e5510 - _e5562);
let _e6106 = (_e5585 * _e6096);
let _e6107 = (_e5588 * _e6096);
let _e6108 = (_e6105 * _e6096);
if (select(0u, 1u, ((_e6101 * _e5610) > -((_e6101 * _e5584)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e6102 * _e5610) > -((_e6102 * _e5584)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e6103 * _e5610) > -((_e6103 * _e5584)))) < 2u) {
} else {
break;
}
let _e6132 = (select(0u, 1u, ((_e6104 * _e5610) > -((_e6104 * _e5584)))) < 2u);
if _e6132 {
} else {
break;
}
if (select(0u, 1u, ((_e6106 * _e5610) > -((_e6106 * _e5584)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e6107 * _e5610) > -((_e6107 * _e5584)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e6108 * _e5610) > -((_e6108 * _e5584)))) < 2u) {
} else {
break;
}
if _e6132 {
} else {
break;
}
if (select(0u, 1u, (_e6101 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6102 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6103 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6104 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6101 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6102 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6103 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6104 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6101 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6102 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6103 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6104 < 0f)) < 2u) {
} else {
break;
}
let _e6188 = select(1f, -1f, (-(((_e5587 * _e5588) - (_e5585 * _e5590))) < 0f));
let _e6191 = (_e5576 - _e5532);
let _e6192 = ((_e5532 - _e5554) * _e6188);
let _e6193 = ((_e5554 - _e5576) * _e6188);
let _e6194 = (_e6191 * _e6188);
let _e6195 = (_e6100 * _e6188);
let _e6196 = (_e5585 * _e6188);
let _e6197 = (_e5588 * _e6188);
let _e6198 = (_e6105 * _e6188);
if (select(0u, 1u, ((_e6192 * _e5610) > -((_e6192 * _e5584)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e6193 * _e5610) > -((_e6193 * _e5584)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e6194 * _e5610) > -((_e6194 * _e5584)))) < 2u) {
} else {
break;
}
let _e6222 = (select(0u, 1u, ((_e6195 * _e5610) > -((_e6195 * _e5584)))) < 2u);
if _e6222 {
} else {
break;
}
if (select(0u, 1u, ((_e6196 * _e5610) > -((_e6196 * _e5584)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e6197 * _e5610) > -((_e6197 * _e5584)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e6198 * _e5610) > -((_e6198 * _e5584)))) < 2u) {
} else {
break;
}
if _e6222 {
} else {
break;
}
if (select(0u, 1u, (_e6192 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6193 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6194 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6195 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6192 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6193 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6194 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6195 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6192 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6193 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6194 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6195 < 0f)) < 2u) {
} else {
break;
}
let _e6277 = (_e5562 - _e5510);
let _e6279 = (_e926.member.member * 19i);
let _e6280 = (_e6279 + 18i);
let _e6282 = (bitcast<i32>(_e214) - 1i);
let _e6284 = select(_e6282, _e6280, (_e6280 < _e6282));
let _e6290 = global_4.member[bitcast<u32>(select(0i, _e6284, (_e6284 > 0i)))];
let _e6292 = select(0f, _e6290, (_e6290 > 0f));
let _e6294 = select(16777216f, _e6292, (_e6292 < 16777216f));
let _e6301 = select(0i, select(select(i32(_e6294), i32(-2147483648), (_e6294 < -2147483600f)), 2147483647i, (_e6294 > 2147483500f)), (_e6294 == _e6294));
phi_11050_ = _e926.member.member_1;
loop {
let _e6308 = phi_11050_;
let _e6309 = (_e6308 < _e926.member.member_2);
if _e6309 {
if _e5613 {
phi_11065_ = _e926.member_1.member_4.y;
} else {
phi_11065_ = _e926.member_1.member_4.z;
}
let _e6313 = phi_11065_;
let _e6314 = f32(_e6313);
let _e6315 = f32(_e6308);
let _e6325 = ((_e6093.member.x * _e6315) + _e6093.member_1.x);
let _e6327 = ((_e6093.member.y * _e6315) + _e6093.member_1.y);
let _e6329 = ((_e6093.member.z * _e6315) + _e6093.member_1.z);
let _e6332 = (_e6325 * _e6093.member_2.x);
let _e6334 = (_e6327 * _e6093.member_2.y);
let _e6336 = (_e6329 * _e6093.member_2.z);
let _e6346 = ((_e6325 * _e6093.member_3.x) + _e6093.member_4.x);
let _e6348 = ((_e6327 * _e6093.member_3.y) + _e6093.member_4.y);
let _e6350 = ((_e6329 * _e6093.member_3.z) + _e6093.member_4.z);
let _e6352 = select(_e6332, 0f, (0f > _e6332));
let _e6354 = select(_e6336, _e6334, (_e6334 > _e6336));
let _e6358 = select(_e6346, _e6314, (_e6314 < _e6346));
let _e6360 = select(_e6350, _e6348, (_e6348 < _e6350));
let _e6362 = select(_e6360, _e6358, (_e6358 < _e6360));
let _e6363 = -(select(_e6354, _e6352, (_e6352 > _e6354)));
let _e6365 = (-(_e6314) - 1f);
let _e6367 = select(_e6365, _e6363, (_e6363 > _e6365));
let _e6369 = select(0f, _e6367, (_e6367 < 0f));
let _e6376 = select(0i, select(select(i32(_e6369), i32(-2147483648), (_e6369 < -2147483600f)), 2147483647i, (_e6369 > 2147483500f)), (_e6369 == _e6369));
let _e6383 = select(-1f, _e6362, (_e6362 > -1f));
let _e6385 = select(_e6314, _e6383, (_e6383 < _e6314));
let _e6392 = select(0i, select(select(i32(_e6385), i32(-2147483648), (_e6385 < -2147483600f)), 2147483647i, (_e6385 > 2147483500f)), (_e6385 == _e6385));
phi_11185_ = -((_e6376 - select(0i, 1i, (_e6369 < f32(_e6376)))));
loop {
let _e6398 = phi_11185_;
let _e6399 = (_e6398 <= (_e6392 - select(0i, 1i, (_e6385 < f32(_e6392)))));
if _e6399 {
let _e6400 = select(_e6398, _e6308, _e5613);
let _e6401 = select(_e6308, _e6398, _e5613);
let _e6407 = global_1.member.member_2.member_1;
let _e6414 = global_1.member.member_3;
phi_11215_ = 0i;
loop {
let _e6418 = phi_11215_;
let _e6419 = (_e6418 <= _e926.member_1.member_4.x);
if _e6419 {
let _e6426 = ((f32(_e6418) + 0.5f) - _e5510);
let _e6427 = ((f32(_e6401) + 0.5f) - _e5521);
let _e6428 = ((f32(_e6400) + 0.5f) - _e5532);
let _e6433 = (((_e5585 * _e5585) + (_e5586 * _e5586)) + (_e5587 * _e5587));
let _e6438 = (((_e5585 * _e6277) + (_e5586 * _e6099)) + (_e5587 * _e6191));
let _e6443 = (((_e6277 * _e6277) + (_e6099 * _e6099)) + (_e6191 * _e6191));
let _e6448 = (((_e6426 * _e5585) + (_e6427 * _e5586)) + (_e6428 * _e5587));
let _e6453 = (((_e6426 * _e6277) + (_e6427 * _e6099)) + (_e6428 * _e6191));
let _e6456 = ((_e6433 * _e6443) - (_e6438 * _e6438));
let _e6457 = (_e6456 > 0f);
let _e6460 = select(0f, (1f / select(1f, _e6456, _e6457)), _e6457);
let _e6464 = (((_e6443 * _e6448) - (_e6438 * _e6453)) * _e6460);
let _e6468 = (((_e6433 * _e6453) - (_e6438 * _e6448)) * _e6460);
let _e6470 = ((1f - _e6464) - _e6468);
let _e6472 = select(0f, _e6470, (_e6470 > 0f));
let _e6474 = select(16777216f, _e6472, (_e6472 < 16777216f));
let _e6476 = select(0f, _e6464, (_e6464 > 0f));
let _e6478 = select(16777216f, _e6476, (_e6476 < 16777216f));
let _e6480 = select(0f, _e6468, (_e6468 > 0f));
let _e6482 = select(16777216f, _e6480, (_e6480 < 16777216f));
let _e6484 = ((_e6474 + _e6478) + _e6482);
let _e6487 = (1f / select(0.5f, _e6484, (_e6484 > 0.5f)));
let _e6488 = (_e6474 * _e6487);
let _e6489 = (_e6478 * _e6487);
let _e6490 = (_e6482 * _e6487);
let _e6492 = select(_e6282, _e6279, (_e6279 < _e6282));
let _e6498 = global_4.member[bitcast<u32>(select(0i, _e6492, (_e6492 > 0i)))];
let _e6499 = (_e6279 + 1i);
let _e6501 = select(_e6282, _e6499, (_e6499 < _e6282));
let _e6507 = global_4.member[bitcast<u32>(select(0i, _e6501, (_e6501 > 0i)))];
let _e6508 = (_e6279 + 2i);
let _e6510 = select(_e6282, _e6508, (_e6508 < _e6282));
let _e6516 = global_4.member[bitcast<u32>(select(0i, _e6510, (_e6510 > 0i)))];
let _e6517 = (_e6279 + 3i);
let _e6519 = select(_e6282, _e6517, (_e6517 < _e6282));
let _e6525 = global_4.member[bitcast<u32>(select(0i, _e6519, (_e6519 > 0i)))];
let _e6526 = (_e6279 + 4i);
let _e6528 = select(_e6282, _e6526, (_e6526 < _e6282));
let _e6534 = global_4.member[bitcast<u32>(select(0i, _e6528, (_e6528 > 0i)))];
let _e6535 = (_e6279 + 5i);
let _e6537 = select(_e6282, _e6535, (_e6535 < _e6282));
let _e6543 = global_4.member[bitcast<u32>(select(0i, _e6537, (_e6537 > 0i)))];
let _e6544 = (_e6279 + 6i);
let _e6546 = select(_e6282, _e6544, (_e6544 < _e6282));
let _e6552 = global_4.member[bitcast<u32>(select(0i, _e6546, (_e6546 > 0i)))];
let _e6553 = (_e6279 + 7i);
let _e6555 = select(_e6282, _e6553, (_e6553 < _e6282));
let _e6561 = global_4.member[bitcast<u32>(select(0i, _e6555, (_e6555 > 0i)))];
let _e6562 = (_e6279 + 8i);
let _e6564 = select(_e6282, _e6562, (_e6562 < _e6282));
let _e6570 = global_4.member[bitcast<u32>(select(0i, _e6564, (_e6564 > 0i)))];
let _e6575 = (((_e6498 * _e6488) + (_e6525 * _e6489)) + (_e6552 * _e6490));
let _e6580 = (((_e6507 * _e6488) + (_e6534 * _e6489)) + (_e6561 * _e6490));
let _e6585 = (((_e6516 * _e6488) + (_e6543 * _e6489)) + (_e6570 * _e6490));
let _e6590 = (((_e6575 * _e6575) + (_e6580 * _e6580)) + (_e6585 * _e6585));
let _e6593 = sqrt(select(0f, _e6590, (_e6590 > 0f)));
let _e6594 = (_e6593 > 1e-6f);
let _e6597 = select(0f, (1f / select(1e-6f, _e6593, _e6594)), _e6594);
let _e6598 = (_e6279 + 9i);
let _e6600 = select(_e6282, _e6598, (_e6598 < _e6282));
let _e6606 = global_4.member[bitcast<u32>(select(0i, _e6600, (_e6600 > 0i)))];
let _e6607 = (_e6279 + 10i);
let _e6609 = select(_e6282, _e6607, (_e6607 < _e6282));
let _e6615 = global_4.member[bitcast<u32>(select(0i, _e6609, (_e6609 > 0i)))];
let _e6616 = (_e6279 + 11i);
let _e6618 = select(_e6282, _e6616, (_e6616 < _e6282));
let _e6624 = global_4.member[bitcast<u32>(select(0i, _e6618, (_e6618 > 0i)))];
let _e6625 = (_e6279 + 12i);
let _e6627 = select(_e6282, _e6625, (_e6625 < _e6282));
let _e6633 = global_4.member[bitcast<u32>(select(0i, _e6627, (_e6627 > 0i)))];
let _e6634 = (_e6279 + 13i);
let _e6636 = select(_e6282, _e6634, (_e6634 < _e6282));
let _e6642 = global_4.member[bitcast<u32>(select(0i, _e6636, (_e6636 > 0i)))];
let _e6643 = (_e6279 + 14i);
let _e6645 = select(_e6282, _e6643, (_e6643 < _e6282));
let _e6651 = global_4.member[bitcast<u32>(select(0i, _e6645, (_e6645 > 0i)))];
let _e6652 = (_e6279 + 15i);
let _e6654 = select(_e6282, _e6652, (_e6652 < _e6282));
let _e6660 = global_4.member[bitcast<u32>(select(0i, _e6654, (_e6654 > 0i)))];
let _e6661 = (_e6279 + 16i);
let _e6663 = select(_e6282, _e6661, (_e6661 < _e6282));
let _e6669 = global_4.member[bitcast<u32>(select(0i, _e6663, (_e6663 > 0i)))];
let _e6670 = (_e6279 + 17i);
let _e6672 = select(_e6282, _e6670, (_e6670 < _e6282));
let _e6678 = global_4.member[bitcast<u32>(select(0i, _e6672, (_e6672 > 0i)))];
let _e6694 = (_e926.member_1.member_3.x + _e6418);
let _e6697 = ((((((_e926.member_1.member_3.z + _e6400) * bitcast<i32>(_e6407)) + _e926.member_1.member_3.y) + _e6401) * bitcast<i32>(_e6414)) + (_e6694 >> bitcast<u32>(5i)));
let _e6701 = (bitcast<i32>(_e218) - 1i);
let _e6703 = select(_e6701, _e6697, (_e6697 < _e6701));
let _e6709 = global_6.member[bitcast<u32>(select(0i, _e6703, (_e6703 > 0i)))];
let _e6711 = (bitcast<i32>(_e216) - 1i);
let _e6713 = select(_e6711, _e6697, (_e6697 < _e6711));
let _e6719 = global_5.member[bitcast<u32>(select(0i, _e6713, (_e6713 > 0i)))];
let _e6728 = (bitcast<i32>((_e6709 + countOneBits((_e6719 & ((1u << bitcast<u32>((bitcast<u32>((_e6694 & 31i)) & 31u))) - 1u))))) * 14i);
let _e6729 = bitcast<u32>(_e6728);
if (_e6729 < _e220) {
let _e6733 = atomicAdd((&global_7.member[_e6729]), 1u);
}
let _e6735 = bitcast<u32>((_e6728 + 1i));
if (_e6735 < _e220) {
let _e6739 = atomicMax((&global_7.member[_e6735]), bitcast<u32>((_e6301 - select(0i, 1i, (_e6294 < f32(_e6301))))));
}
let _e6745 = (((_e6575 * _e6597) * 65536f) + 0.5f);
let _e6747 = select(-1073741800f, _e6745, (_e6745 > -1073741800f));
let _e6749 = select(1073741800f, _e6747, (_e6747 < 1073741800f));
let _e6756 = select(0i, select(select(i32(_e6749), i32(-2147483648), (_e6749 < -2147483600f)), 2147483647i, (_e6749 > 2147483500f)), (_e6749 == _e6749));
let _e6760 = (_e6756 - select(0i, 1i, (_e6749 < f32(_e6756))));
if (_e6760 == 0i) {
} else {
let _e6762 = bitcast<u32>(_e6760);
let _e6763 = bitcast<u32>((_e6728 + 2i));
if (_e6763 < _e220) {
let _e6767 = atomicAdd((&global_7.member[_e6763]), _e6762);
phi_11743_ = _e6767;
} else {
phi_11743_ = 0u;
}
let _e6769 = phi_11743_;
let _e6776 = (bitcast<u32>((_e6760 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e6769 + _e6762) < _e6762)));
if (_e6776 == 0u) {
} else {
let _e6778 = (_e6763 + 1u);
if (_e6778 < _e220) {
let _e6782 = atomicAdd((&global_7.member[_e6778]), _e6776);
}
}
}
let _e6785 = (((_e6580 * _e6597) * 65536f) + 0.5f);
let _e6787 = select(-1073741800f, _e6785, (_e6785 > -1073741800f));
let _e6789 = select(1073741800f, _e6787, (_e6787 < 1073741800f));
let _e6796 = select(0i, select(select(i32(_e6789), i32(-2147483648), (_e6789 < -2147483600f)), 2147483647i, (_e6789 > 2147483500f)), (_e6789 == _e6789));
let _e6800 = (_e6796 - select(0i, 1i, (_e6789 < f32(_e6796))));
if (_e6800 == 0i) {
} else {
let _e6802 = bitcast<u32>(_e6800);
let _e6803 = bitcast<u32>((_e6728 + 4i));
if (_e6803 < _e220) {
let _e6807 = atomicAdd((&global_7.member[_e6803]), _e6802);
phi_11800_ = _e6807;
} else {
phi_11800_ = 0u;
}
let _e6809 = phi_11800_;
let _e6816 = (bitcast<u32>((_e6800 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e6809 + _e6802) < _e6802)));
if (_e6816 == 0u) {
} else {
let _e6818 = (_e6803 + 1u);
if (_e6818 < _e220) {
let _e6822 = atomicAdd((&global_7.member[_e6818]), _e6816);
}
}
}
let _e6825 = (((_e6585 * _e6597) * 65536f) + 0.5f);
let _e6827 = select(-1073741800f, _e6825, (_e6825 > -1073741800f));
let _e6829 = select(1073741800f, _e6827, (_e6827 < 1073741800f));
let _e6836 = select(0i, select(select(i32(_e6829), i32(-2147483648), (_e6829 < -2147483600f)), 2147483647i, (_e6829 > 2147483500f)), (_e6829 == _e6829));
let _e6840 = (_e6836 - select(0i, 1i, (_e6829 < f32(_e6836))));
if (_e6840 == 0i) {
} else {
let _e6842 = bitcast<u32>(_e6840);
let _e6843 = bitcast<u32>((_e6728 + 6i));
if (_e6843 < _e220) {
let _e6847 = atomicAdd((&global_7.member[_e6843]), _e6842);
phi_11857_ = _e6847;
} else {
phi_11857_ = 0u;
}
let _e6849 = phi_11857_;
let _e6856 = (bitcast<u32>((_e6840 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e6849 + _e6842) < _e6842)));
if (_e6856 == 0u) {
} else {
let _e6858 = (_e6843 + 1u);
if (_e6858 < _e220) {
let _e6862 = atomicAdd((&global_7.member[_e6858]), _e6856);
}
}
}
let _e6865 = (((((_e6606 * _e6488) + (_e6633 * _e6489)) + (_e6660 * _e6490)) * 65536f) + 0.5f);
let _e6867 = select(-1073741800f, _e6865, (_e6865 > -1073741800f));
let _e6869 = select(1073741800f, _e6867, (_e6867 < 1073741800f));
let _e6876 = select(0i, select(select(i32(_e6869), i32(-2147483648), (_e6869 < -2147483600f)), 2147483647i, (_e6869 > 2147483500f)), (_e6869 == _e6869));
let _e6880 = (_e6876 - select(0i, 1i, (_e6869 < f32(_e6876))));
if (_e6880 == 0i) {
} else {
let _e6882 = bitcast<u32>(_e6880);
let _e6883 = bitcast<u32>((_e6728 + 8i));
if (_e6883 < _e220) {
let _e6887 = atomicAdd((&global_7.member[_e6883]), _e6882);
phi_11915_ = _e6887;
} else {
phi_11915_ = 0u;
}
let _e6889 = phi_11915_;
let _e6896 = (bitcast<u32>((_e6880 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e6889 + _e6882) < _e6882)));
if (_e6896 == 0u) {
} else {
let _e6898 = (_e6883 + 1u);
if (_e6898 < _e220) {
let _e6902 = atomicAdd((&global_7.member[_e6898]), _e6896);
}
}
}
let _e6905 = (((((_e6615 * _e6488) + (_e6642 * _e6489)) + (_e6669 * _e6490)) * 65536f) + 0.5f);
let _e6907 = select(-1073741800f, _e6905, (_e6905 > -1073741800f));
let _e6909 = select(1073741800f, _e6907, (_e6907 < 1073741800f));
let _e6916 = select(0i, select(select(i32(_e6909), i32(-2147483648), (_e6909 < -2147483600f)), 2147483647i, (_e6909 > 2147483500f)), (_e6909 == _e6909));
let _e6920 = (_e6916 - select(0i, 1i, (_e6909 < f32(_e6916))));
if (_e6920 == 0i) {
} else {
let _e6922 = bitcast<u32>(_e6920);
let _e6923 = bitcast<u32>((_e6728 + 10i));
if (_e6923 < _e220) {
let _e6927 = atomicAdd((&global_7.member[_e6923]), _e6922);
phi_11972_ = _e6927;
} else {
phi_11972_ = 0u;
}
let _e6929 = phi_11972_;
let _e6936 = (bitcast<u32>((_e6920 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e6929 + _e6922) < _e6922)));
if (_e6936 == 0u) {
} else {
let _e6938 = (_e6923 + 1u);
if (_e6938 < _e220) {
let _e6942 = atomicAdd((&global_7.member[_e6938]), _e6936);
}
}
}
let _e6945 = (((((_e6624 * _e6488) + (_e6651 * _e6489)) + (_e6678 * _e6490)) * 65536f) + 0.5f);
let _e6947 = select(-1073741800f, _e6945, (_e6945 > -1073741800f));
let _e6949 = select(1073741800f, _e6947, (_e6947 < 1073741800f));
let _e6956 = select(0i, select(select(i32(_e6949), i32(-2147483648), (_e6949 < -2147483600f)), 2147483647i, (_e6949 > 2147483500f)), (_e6949 == _e6949));
let _e6960 = (_e6956 - select(0i, 1i, (_e6949 < f32(_e6956))));
if (_e6960 == 0i) {
} else {
let _e6962 = bitcast<u32>(_e6960);
let _e6963 = bitcast<u32>((_e6728 + 12i));
if (_e6963 < _e220) {
let _e6967 = atomicAdd((&global_7.member[_e6963]), _e6962);
phi_12029_ = _e6967;
} else {
phi_12029_ = 0u;
}
let _e6969 = phi_12029_;
let _e6976 = (bitcast<u32>((_e6960 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e6969 + _e6962) < _e6962)));
if (_e6976 == 0u) {
} else {
let _e6978 = (_e6963 + 1u);
if (_e6978 < _e220) {
let _e6982 = atomicAdd((&global_7.member[_e6978]), _e6976);
}
}
}
phi_11216_ = (_e6418 + 1i);
} else {
phi_11216_ = i32();
}
let _e6985 = phi_11216_;
continue;
continuing {
phi_11215_ = _e6985;
break if !(_e6419);
}
}
phi_11186_ = (_e6398 + 1i);
} else {
phi_11186_ = i32();
}
let _e6989 = phi_11186_;
continue;
continuing {
phi_11185_ = _e6989;
break if !(_e6399);
}
}
phi_11051_ = (_e6308 + 1i);
} else {
phi_11051_ = i32();
}
let _e6993 = phi_11051_;
continue;
continuing {
phi_11050_ = _e6993;
break if !(_e6309);
}
}
} else {
if (_e952 == 2u) {
let _e4186 = (_e926.member_1.member_6 & 31u);
let _e4188 = (_e926.member_1.member_3.x << bitcast<u32>(_e4186));
let _e4191 = (_e926.member_1.member_7 & 31u);
let _e4195 = ((1i << bitcast<u32>(_e4191)) >> bitcast<u32>(1i));
let _e4201 = bitcast<i32>(_e926.member_1.member_6);
let _e4207 = bitcast<f32>((bitcast<u32>((127i + (bitcast<i32>(_e926.member_1.member_7) - _e4201))) << bitcast<u32>(23i)));
let _e4208 = (f32((((_e926.member_1.member.x - _e4188) + _e4195) >> bitcast<u32>(_e4191))) * _e4207);
let _e4213 = (_e926.member_1.member_3.y << bitcast<u32>(_e4186));
let _e4219 = (f32((((_e926.member_1.member.y - _e4213) + _e4195) >> bitcast<u32>(_e4191))) * _e4207);
let _e4224 = (_e926.member_1.member_3.z << bitcast<u32>(_e4186));
let _e4230 = (f32((((_e926.member_1.member.z - _e4224) + _e4195) >> bitcast<u32>(_e4191))) * _e4207);
let _e4238 = (f32((((_e926.member_1.member_1.x - _e4188) + _e4195) >> bitcast<u32>(_e4191))) * _e4207);
let _e4245 = (f32((((_e926.member_1.member_1.y - _e4213) + _e4195) >> bitcast<u32>(_e4191))) * _e4207);
let _e4252 = (f32((((_e926.member_1.member_1.z - _e4224) + _e4195) >> bitcast<u32>(_e4191))) * _e4207);
let _e4260 = (f32((((_e926.member_1.member_2.x - _e4188) + _e4195) >> bitcast<u32>(_e4191))) * _e4207);
let _e4267 = (f32((((_e926.member_1.member_2.y - _e4213) + _e4195) >> bitcast<u32>(_e4191))) * _e4207);
let _e4274 = (f32((((_e926.member_1.member_2.z - _e4224) + _e4195) >> bitcast<u32>(_e4191))) * _e4207);
let _e4282 = (f32(_e926.member_1.member_5) * bitcast<f32>((bitcast<u32>((127i - _e4201)) << bitcast<u32>(23i))));
let _e4283 = (_e4238 - _e4208);
let _e4284 = (_e4245 - _e4219);
let _e4285 = (_e4252 - _e4230);
let _e4286 = (_e4260 - _e4238);
let _e4287 = (_e4267 - _e4245);
let _e4288 = (_e4274 - _e4252);
let _e4291 = ((_e4284 * _e4288) - (_e4285 * _e4287));
let _e4292 = (_e4285 * _e4286);
let _e4293 = (_e4283 * _e4288);
let _e4305 = ((bitcast<f32>((bitcast<u32>(_e4292) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e4293) & 2147483647u))) * 2.3841858e-7f);
let _e4306 = f32(_e926.member_1.member_4.x);
let _e4307 = (1f + _e4282);
let _e4309 = -((_e4292 - _e4293));
let _e4310 = (_e926.member_1.member_4.z >= _e926.member_1.member_4.y);
if _e4310 {
let _e4404 = select(1f, -1f, (_e4291 < 0f));
let _e4409 = ((_e4230 - _e4252) * _e4404);
let _e4410 = ((_e4252 - _e4274) * _e4404);
let _e4411 = ((_e4274 - _e4230) * _e4404);
let _e4412 = ((0f - 0f) * _e4404);
let _e4414 = (_e4284 * _e4404);
let _e4415 = (_e4287 * _e4404);
let _e4416 = ((_e4219 - _e4267) * _e4404);
if (select(0u, 1u, ((_e4409 * _e4307) > -((_e4409 * _e4282)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4410 * _e4307) > -((_e4410 * _e4282)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4411 * _e4307) > -((_e4411 * _e4282)))) < 2u) {
} else {
break;
}
let _e4440 = (select(0u, 1u, ((_e4412 * _e4307) > -((_e4412 * _e4282)))) < 2u);
if _e4440 {
} else {
break;
}
if (select(0u, 1u, ((_e4414 * _e4307) > -((_e4414 * _e4282)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4415 * _e4307) > -((_e4415 * _e4282)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4416 * _e4307) > -((_e4416 * _e4282)))) < 2u) {
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
} else {
let _e4312 = select(1f, -1f, (-(_e4291) < 0f));
let _e4317 = ((_e4219 - _e4245) * _e4312);
let _e4318 = ((_e4245 - _e4267) * _e4312);
let _e4319 = ((_e4267 - _e4219) * _e4312);
let _e4320 = ((0f - 0f) * _e4312);
let _e4322 = (_e4285 * _e4312);
let _e4323 = (_e4288 * _e4312);
let _e4324 = ((_e4230 - _e4274) * _e4312);
if (select(0u, 1u, ((_e4317 * _e4307) > -((_e4317 * _e4282)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4318 * _e4307) > -((_e4318 * _e4282)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4319 * _e4307) > -((_e4319 * _e4282)))) < 2u) {
} else {
break;
}
let _e4348 = (select(0u, 1u, ((_e4320 * _e4307) > -((_e4320 * _e4282)))) < 2u);
if _e4348 {
} else {
break;
}
if (select(0u, 1u, ((_e4322 * _e4307) > -((_e4322 * _e4282)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4323 * _e4307) > -((_e4323 * _e4282)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4324 * _e4307) > -((_e4324 * _e4282)))) < 2u) {
} else {
break;
}
if _e4348 {
} else {
break;
}
if (select(0u, 1u, (_e4317 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4318 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4319 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4320 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4317 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4318 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4319 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4320 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4317 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4318 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4319 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4320 < 0f)) < 2u) {
} else {
break;
}
}
let _e4497 = select(1f, -1f, (((_e4283 * _e4287) - (_e4284 * _e4286)) < 0f));
let _e4500 = (_e4267 - _e4219);
let _e4501 = (0f - 0f);
let _e4502 = ((_e4219 - _e4245) * _e4497);
let _e4503 = ((_e4245 - _e4267) * _e4497);
let _e4504 = (_e4500 * _e4497);
let _e4505 = (_e4501 * _e4497);
let _e4506 = (_e4208 - _e4260);
let _e4507 = (_e4283 * _e4497);
let _e4508 = (_e4286 * _e4497);
let _e4509 = (_e4506 * _e4497);
if (select(0u, 1u, ((_e4502 * _e4307) > -((_e4502 * _e4282)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4503 * _e4307) > -((_e4503 * _e4282)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4504 * _e4307) > -((_e4504 * _e4282)))) < 2u) {
} else {
break;
}
let _e4533 = (select(0u, 1u, ((_e4505 * _e4307) > -((_e4505 * _e4282)))) < 2u);
if _e4533 {
} else {
break;
}
if (select(0u, 1u, ((_e4507 * _e4307) > -((_e4507 * _e4282)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4508 * _e4307) > -((_e4508 * _e4282)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4509 * _e4307) > -((_e4509 * _e4282)))) < 2u) {
} else {
break;
}
if _e4533 {
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
if (select(0u, 1u, (_e4504 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4505 == 0f)) < 2u) {
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
if (select(0u, 1u, (_e4504 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4505 > 0f)) < 2u) {
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
if (select(0u, 1u, (_e4504 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4505 < 0f)) < 2u) {
} else {
break;
}
let _e4589 = select(1f, -1f, (_e4309 < 0f));
let _e4595 = select(0f, (2f * _e4305), (bitcast<f32>((bitcast<u32>(_e4309) & 2147483647u)) <= _e4305));
let _e4598 = (_e4274 - _e4230);
let _e4599 = ((_e4230 - _e4252) * _e4589);
let _e4600 = ((_e4252 - _e4274) * _e4589);
let _e4601 = (_e4598 * _e4589);
let _e4602 = (_e4501 * _e4589);
let _e4603 = (_e4283 * _e4589);
let _e4604 = (_e4286 * _e4589);
let _e4605 = (_e4506 * _e4589);
let _e4606 = (_e4599 * _e4307);
let _e4607 = (_e4600 * _e4307);
let _e4608 = (_e4601 * _e4307);
let _e4614 = -((_e4599 * _e4282));
let _e4615 = -((_e4600 * _e4282));
let _e4616 = -((_e4601 * _e4282));
local_97 = array<u32, 2>(0u, 4294967295u);
let _e4622 = select(0u, 1u, (_e4606 > _e4614));
if (_e4622 < 2u) {
} else {
break;
}
let _e4625 = local_97[_e4622];
local_98 = array<u32, 2>(0u, 4294967295u);
let _e4626 = select(0u, 1u, (_e4607 > _e4615));
if (_e4626 < 2u) {
} else {
break;
}
let _e4629 = local_98[_e4626];
local_99 = array<u32, 2>(0u, 4294967295u);
let _e4630 = select(0u, 1u, (_e4608 > _e4616));
if (_e4630 < 2u) {
} else {
break;
}
let _e4633 = local_99[_e4630];
let _e4635 = (select(0u, 1u, ((_e4602 * _e4307) > -((_e4602 * _e4282)))) < 2u);
if _e4635 {
} else {
break;
}
let _e4651 = (_e4603 * _e4307);
let _e4652 = (_e4604 * _e4307);
let _e4653 = (_e4605 * _e4307);
let _e4657 = -((_e4603 * _e4282));
let _e4658 = -((_e4604 * _e4282));
let _e4659 = -((_e4605 * _e4282));
local_94 = array<u32, 2>(0u, 4294967295u);
let _e4663 = select(0u, 1u, (_e4651 > _e4657));
if (_e4663 < 2u) {
} else {
break;
}
let _e4666 = local_94[_e4663];
local_95 = array<u32, 2>(0u, 4294967295u);
let _e4667 = select(0u, 1u, (_e4652 > _e4658));
if (_e4667 < 2u) {
} else {
break;
}
let _e4670 = local_95[_e4667];
local_96 = array<u32, 2>(0u, 4294967295u);
let _e4671 = select(0u, 1u, (_e4653 > _e4659));
if (_e4671 < 2u) {
} else {
break;
}
let _e4674 = local_96[_e4671];
if _e4635 {
} else {
break;
}
local_91 = array<u32, 2>(0u, 4294967295u);
let _e4700 = select(0u, 1u, (_e4599 == 0f));
if (_e4700 < 2u) {
} else {
break;
}
let _e4703 = local_91[_e4700];
local_92 = array<u32, 2>(0u, 4294967295u);
let _e4704 = select(0u, 1u, (_e4600 == 0f));
if (_e4704 < 2u) {
} else {
break;
}
let _e4707 = local_92[_e4704];
local_93 = array<u32, 2>(0u, 4294967295u);
let _e4708 = select(0u, 1u, (_e4601 == 0f));
if (_e4708 < 2u) {
} else {
break;
}
let _e4711 = local_93[_e4708];
if (select(0u, 1u, (_e4602 == 0f)) < 2u) {
} else {
break;
}
let _e4715 = ((_e4703 & 1u) != 0u);
let _e4718 = ((_e4707 & 1u) != 0u);
let _e4721 = ((_e4711 & 1u) != 0u);
let _e4723 = (-1f / select(_e4599, 1f, _e4715));
let _e4724 = (-1f / select(_e4600, 1f, _e4718));
let _e4725 = (-1f / select(_e4601, 1f, _e4721));
local_88 = array<u32, 2>(0u, 4294967295u);
let _e4730 = select(0u, 1u, (_e4599 > 0f));
if (_e4730 < 2u) {
} else {
break;
}
let _e4733 = local_88[_e4730];
local_89 = array<u32, 2>(0u, 4294967295u);
let _e4734 = select(0u, 1u, (_e4600 > 0f));
if (_e4734 < 2u) {
} else {
break;
}
let _e4737 = local_89[_e4734];
local_90 = array<u32, 2>(0u, 4294967295u);
let _e4738 = select(0u, 1u, (_e4601 > 0f));
if (_e4738 < 2u) {
} else {
break;
}
let _e4741 = local_90[_e4738];
if (select(0u, 1u, (_e4602 > 0f)) < 2u) {
} else {
break;
}
local_85 = array<u32, 2>(0u, 4294967295u);
let _e4748 = select(0u, 1u, (_e4599 < 0f));
if (_e4748 < 2u) {
} else {
break;
}
let _e4751 = local_85[_e4748];
local_86 = array<u32, 2>(0u, 4294967295u);
let _e4752 = select(0u, 1u, (_e4600 < 0f));
if (_e4752 < 2u) {
} else {
break;
}
let _e4755 = local_86[_e4752];
local_87 = array<u32, 2>(0u, 4294967295u);
let _e4756 = select(0u, 1u, (_e4601 < 0f));
if (_e4756 < 2u) {
} else {
break;
}
let _e4759 = local_87[_e4756];
if (select(0u, 1u, (_e4602 < 0f)) < 2u) {
} else {
break;
}
let _e4775 = ((_e4751 & 1u) != 0u);
let _e4778 = ((_e4755 & 1u) != 0u);
let _e4781 = ((_e4759 & 1u) != 0u);
let _e4786 = (_e4260 - _e4208);
let _e4788 = (_e926.member.member * 19i);
let _e4789 = (_e4788 + 18i);
let _e4791 = (bitcast<i32>(_e214) - 1i);
let _e4793 = select(_e4791, _e4789, (_e4789 < _e4791));
let _e4799 = global_4.member[bitcast<u32>(select(0i, _e4793, (_e4793 > 0i)))];
let _e4801 = select(0f, _e4799, (_e4799 > 0f));
let _e4803 = select(16777216f, _e4801, (_e4801 < 16777216f));
let _e4810 = select(0i, select(select(i32(_e4803), i32(-2147483648), (_e4803 < -2147483600f)), 2147483647i, (_e4803 > 2147483500f)), (_e4803 == _e4803));
phi_16049_ = _e926.member.member_1;
loop {
let _e4817 = phi_16049_;
let _e4818 = (_e4817 < _e926.member.member_2);
if _e4818 {
if _e4310 {
phi_16064_ = _e926.member_1.member_4.y;
} else {
phi_16064_ = _e926.member_1.member_4.z;
}
let _e4822 = phi_16064_;
phi_16066_ = 0i;
loop {
let _e4824 = phi_16066_;
let _e4825 = (_e4824 <= _e4822);
if _e4825 {
let _e4826 = select(_e4824, _e4817, _e4310);
let _e4827 = select(_e4817, _e4824, _e4310);
let _e4828 = f32(_e4826);
let _e4830 = f32(_e926.member_1.member_4.x);
let _e4834 = ((_e4603 * _e4828) + (((select(_e4614, _e4606, ((_e4625 & 1u) != 0u)) - (_e4599 * _e4208)) + (select(_e4657, _e4651, ((_e4666 & 1u) != 0u)) - (_e4603 * _e4230))) + _e4595));
let _e4835 = ((_e4604 * _e4828) + (((select(_e4615, _e4607, ((_e4629 & 1u) != 0u)) - (_e4600 * _e4238)) + (select(_e4658, _e4652, ((_e4670 & 1u) != 0u)) - (_e4604 * _e4252))) + _e4595));
let _e4836 = ((_e4605 * _e4828) + (((select(_e4616, _e4608, ((_e4633 & 1u) != 0u)) - (_e4601 * _e4260)) + (select(_e4659, _e4653, ((_e4674 & 1u) != 0u)) - (_e4605 * _e4274))) + _e4595));
let _e4837 = (_e4834 * select(0f, _e4723, ((_e4733 & 1u) != 0u)));
let _e4838 = (_e4835 * select(0f, _e4724, ((_e4737 & 1u) != 0u)));
let _e4839 = (_e4836 * select(0f, _e4725, ((_e4741 & 1u) != 0u)));
let _e4843 = ((_e4834 * select(select(0f, 1e20f, _e4715), _e4723, _e4775)) + select(_e4306, 0f, _e4775));
let _e4844 = ((_e4835 * select(select(0f, 1e20f, _e4718), _e4724, _e4778)) + select(_e4306, 0f, _e4778));
let _e4845 = ((_e4836 * select(select(0f, 1e20f, _e4721), _e4725, _e4781)) + select(_e4306, 0f, _e4781));
let _e4847 = select(_e4837, 0f, (0f > _e4837));
let _e4849 = select(_e4839, _e4838, (_e4838 > _e4839));
let _e4853 = select(_e4843, _e4830, (_e4830 < _e4843));
let _e4855 = select(_e4845, _e4844, (_e4844 < _e4845));
let _e4857 = select(_e4855, _e4853, (_e4853 < _e4855));
let _e4858 = -(select(_e4849, _e4847, (_e4847 > _e4849)));
let _e4860 = (-(_e4830) - 1f);
let _e4862 = select(_e4860, _e4858, (_e4858 > _e4860));
let _e4864 = select(0f, _e4862, (_e4862 < 0f));
let _e4871 = select(0i, select(select(i32(_e4864), i32(-2147483648), (_e4864 < -2147483600f)), 2147483647i, (_e4864 > 2147483500f)), (_e4864 == _e4864));
let _e4878 = select(-1f, _e4857, (_e4857 > -1f));
let _e4880 = select(_e4830, _e4878, (_e4878 < _e4830));
let _e4887 = select(0i, select(select(i32(_e4880), i32(-2147483648), (_e4880 < -2147483600f)), 2147483647i, (_e4880 > 2147483500f)), (_e4880 == _e4880));
let _e4896 = global_1.member.member_2.member_1;
let _e4903 = global_1.member.member_3;
phi_16193_ = -((_e4871 - select(0i, 1i, (_e4864 < f32(_e4871)))));
loop {
let _e4907 = phi_16193_;
let _e4908 = (_e4907 <= (_e4887 - select(0i, 1i, (_e4880 < f32(_e4887)))));
if _e4908 {
let _e4914 = ((f32(_e4907) + 0.5f) - _e4208);
let _e4915 = ((f32(_e4827) + 0.5f) - _e4219);
let _e4916 = ((_e4828 + 0.5f) - _e4230);
let _e4921 = (((_e4283 * _e4283) + (_e4284 * _e4284)) + (_e4285 * _e4285));
let _e4926 = (((_e4283 * _e4786) + (_e4284 * _e4500)) + (_e4285 * _e4598));
let _e4931 = (((_e4786 * _e4786) + (_e4500 * _e4500)) + (_e4598 * _e4598));
let _e4936 = (((_e4914 * _e4283) + (_e4915 * _e4284)) + (_e4916 * _e4285));
let _e4941 = (((_e4914 * _e4786) + (_e4915 * _e4500)) + (_e4916 * _e4598));
let _e4944 = ((_e4921 * _e4931) - (_e4926 * _e4926));
let _e4945 = (_e4944 > 0f);
let _e4948 = select(0f, (1f / select(1f, _e4944, _e4945)), _e4945);
let _e4952 = (((_e4931 * _e4936) - (_e4926 * _e4941)) * _e4948);
let _e4956 = (((_e4921 * _e4941) - (_e4926 * _e4936)) * _e4948);
let _e4958 = ((1f - _e4952) - _e4956);
let _e4960 = select(0f, _e4958, (_e4958 > 0f));
let _e4962 = select(16777216f, _e4960, (_e4960 < 16777216f));
let _e4964 = select(0f, _e4952, (_e4952 > 0f));
let _e4966 = select(16777216f, _e4964, (_e4964 < 16777216f));
let _e4968 = select(0f, _e4956, (_e4956 > 0f));
let _e4970 = select(16777216f, _e4968, (_e4968 < 16777216f));
let _e4972 = ((_e4962 + _e4966) + _e4970);
let _e4975 = (1f / select(0.5f, _e4972, (_e4972 > 0.5f)));
let _e4976 = (_e4962 * _e4975);
let _e4977 = (_e4966 * _e4975);
let _e4978 = (_e4970 * _e4975);
let _e4980 = select(_e4791, _e4788, (_e4788 < _e4791));
let _e4986 = global_4.member[bitcast<u32>(select(0i, _e4980, (_e4980 > 0i)))];
let _e4987 = (_e4788 + 1i);
let _e4989 = select(_e4791, _e4987, (_e4987 < _e4791));
let _e4995 = global_4.member[bitcast<u32>(select(0i, _e4989, (_e4989 > 0i)))];
let _e4996 = (_e4788 + 2i);
let _e4998 = select(_e4791, _e4996, (_e4996 < _e4791));
let _e5004 = global_4.member[bitcast<u32>(select(0i, _e4998, (_e4998 > 0i)))];
let _e5005 = (_e4788 + 3i);
let _e5007 = select(_e4791, _e5005, (_e5005 < _e4791));
let _e5013 = global_4.member[bitcast<u32>(select(0i, _e5007, (_e5007 > 0i)))];
let _e5014 = (_e4788 + 4i);
let _e5016 = select(_e4791, _e5014, (_e5014 < _e4791));
let _e5022 = global_4.member[bitcast<u32>(select(0i, _e5016, (_e5016 > 0i)))];
let _e5023 = (_e4788 + 5i);
let _e5025 = select(_e4791, _e5023, (_e5023 < _e4791));
let _e5031 = global_4.member[bitcast<u32>(select(0i, _e5025, (_e5025 > 0i)))];
let _e5032 = (_e4788 + 6i);
let _e5034 = select(_e4791, _e5032, (_e5032 < _e4791));
let _e5040 = global_4.member[bitcast<u32>(select(0i, _e5034, (_e5034 > 0i)))];
let _e5041 = (_e4788 + 7i);
let _e5043 = select(_e4791, _e5041, (_e5041 < _e4791));
let _e5049 = global_4.member[bitcast<u32>(select(0i, _e5043, (_e5043 > 0i)))];
let _e5050 = (_e4788 + 8i);
let _e5052 = select(_e4791, _e5050, (_e5050 < _e4791));
let _e5058 = global_4.member[bitcast<u32>(select(0i, _e5052, (_e5052 > 0i)))];
let _e5063 = (((_e4986 * _e4976) + (_e5013 * _e4977)) + (_e5040 * _e4978));
let _e5068 = (((_e4995 * _e4976) + (_e5022 * _e4977)) + (_e5049 * _e4978));
let _e5073 = (((_e5004 * _e4976) + (_e5031 * _e4977)) + (_e5058 * _e4978));
let _e5078 = (((_e5063 * _e5063) + (_e5068 * _e5068)) + (_e5073 * _e5073));
let _e5081 = sqrt(select(0f, _e5078, (_e5078 > 0f)));
let _e5082 = (_e5081 > 1e-6f);
let _e5085 = select(0f, (1f / select(1e-6f, _e5081, _e5082)), _e5082);
let _e5086 = (_e4788 + 9i);
let _e5088 = select(_e4791, _e5086, (_e5086 < _e4791));
let _e5094 = global_4.member[bitcast<u32>(select(0i, _e5088, (_e5088 > 0i)))];
let _e5095 = (_e4788 + 10i);
let _e5097 = select(_e4791, _e5095, (_e5095 < _e4791));
let _e5103 = global_4.member[bitcast<u32>(select(0i, _e5097, (_e5097 > 0i)))];
let _e5104 = (_e4788 + 11i);
let _e5106 = select(_e4791, _e5104, (_e5104 < _e4791));
let _e5112 = global_4.member[bitcast<u32>(select(0i, _e5106, (_e5106 > 0i)))];
let _e5113 = (_e4788 + 12i);
let _e5115 = select(_e4791, _e5113, (_e5113 < _e4791));
let _e5121 = global_4.member[bitcast<u32>(select(0i, _e5115, (_e5115 > 0i)))];
let _e5122 = (_e4788 + 13i);
let _e5124 = select(_e4791, _e5122, (_e5122 < _e4791));
let _e5130 = global_4.member[bitcast<u32>(select(0i, _e5124, (_e5124 > 0i)))];
let _e5131 = (_e4788 + 14i);
let _e5133 = select(_e4791, _e5131, (_e5131 < _e4791));
let _e5139 = global_4.member[bitcast<u32>(select(0i, _e5133, (_e5133 > 0i)))];
let _e5140 = (_e4788 + 15i);
let _e5142 = select(_e4791, _e5140, (_e5140 < _e4791));
let _e5148 = global_4.member[bitcast<u32>(select(0i, _e5142, (_e5142 > 0i)))];
let _e5149 = (_e4788 + 16i);
let _e5151 = select(_e4791, _e5149, (_e5149 < _e4791));
let _e5157 = global_4.member[bitcast<u32>(select(0i, _e5151, (_e5151 > 0i)))];
let _e5158 = (_e4788 + 17i);
let _e5160 = select(_e4791, _e5158, (_e5158 < _e4791));
let _e5166 = global_4.member[bitcast<u32>(select(0i, _e5160, (_e5160 > 0i)))];
let _e5182 = (_e926.member_1.member_3.x + _e4907);
let _e5185 = ((((((_e926.member_1.member_3.z + _e4826) * bitcast<i32>(_e4896)) + _e926.member_1.member_3.y) + _e4827) * bitcast<i32>(_e4903)) + (_e5182 >> bitcast<u32>(5i)));
let _e5189 = (bitcast<i32>(_e218) - 1i);
let _e5191 = select(_e5189, _e5185, (_e5185 < _e5189));
let _e5197 = global_6.member[bitcast<u32>(select(0i, _e5191, (_e5191 > 0i)))];
let _e5199 = (bitcast<i32>(_e216) - 1i);
let _e5201 = select(_e5199, _e5185, (_e5185 < _e5199));
let _e5207 = global_5.member[bitcast<u32>(select(0i, _e5201, (_e5201 > 0i)))];
let _e5216 = (bitcast<i32>((_e5197 + countOneBits((_e5207 & ((1u << bitcast<u32>((bitcast<u32>((_e5182 & 31i)) & 31u))) - 1u))))) * 14i);
let _e5217 = bitcast<u32>(_e5216);
if (_e5217 < _e220) {
let _e5221 = atomicAdd((&global_7.member[_e5217]), 1u);
}
let _e5223 = bitcast<u32>((_e5216 + 1i));
if (_e5223 < _e220) {
let _e5227 = atomicMax((&global_7.member[_e5223]), bitcast<u32>((_e4810 - select(0i, 1i, (_e4803 < f32(_e4810))))));
}
let _e5233 = (((_e5063 * _e5085) * 65536f) + 0.5f);
let _e5235 = select(-1073741800f, _e5233, (_e5233 > -1073741800f));
let _e5237 = select(1073741800f, _e5235, (_e5235 < 1073741800f));
let _e5244 = select(0i, select(select(i32(_e5237), i32(-2147483648), (_e5237 < -2147483600f)), 2147483647i, (_e5237 > 2147483500f)), (_e5237 == _e5237));
let _e5248 = (_e5244 - select(0i, 1i, (_e5237 < f32(_e5244))));
if (_e5248 == 0i) {
} else {
let _e5250 = bitcast<u32>(_e5248);
let _e5251 = bitcast<u32>((_e5216 + 2i));
if (_e5251 < _e220) {
let _e5255 = atomicAdd((&global_7.member[_e5251]), _e5250);
phi_16721_ = _e5255;
} else {
phi_16721_ = 0u;
}
let _e5257 = phi_16721_;
let _e5264 = (bitcast<u32>((_e5248 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e5257 + _e5250) < _e5250)));
if (_e5264 == 0u) {
} else {
let _e5266 = (_e5251 + 1u);
if (_e5266 < _e220) {
let _e5270 = atomicAdd((&global_7.member[_e5266]), _e5264);
}
}
}
let _e5273 = (((_e5068 * _e5085) * 65536f) + 0.5f);
let _e5275 = select(-1073741800f, _e5273, (_e5273 > -1073741800f));
let _e5277 = select(1073741800f, _e5275, (_e5275 < 1073741800f));
let _e5284 = select(0i, select(select(i32(_e5277), i32(-2147483648), (_e5277 < -2147483600f)), 2147483647i, (_e5277 > 2147483500f)), (_e5277 == _e5277));
let _e5288 = (_e5284 - select(0i, 1i, (_e5277 < f32(_e5284))));
if (_e5288 == 0i) {
} else {
let _e5290 = bitcast<u32>(_e5288);
let _e5291 = bitcast<u32>((_e5216 + 4i));
if (_e5291 < _e220) {
let _e5295 = atomicAdd((&global_7.member[_e5291]), _e5290);
phi_16778_ = _e5295;
} else {
phi_16778_ = 0u;
}
let _e5297 = phi_16778_;
let _e5304 = (bitcast<u32>((_e5288 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e5297 + _e5290) < _e5290)));
if (_e5304 == 0u) {
} else {
let _e5306 = (_e5291 + 1u);
if (_e5306 < _e220) {
let _e5310 = atomicAdd((&global_7.member[_e5306]), _e5304);
}
}
}
let _e5313 = (((_e5073 * _e5085) * 65536f) + 0.5f);
let _e5315 = select(-1073741800f, _e5313, (_e5313 > -1073741800f));
let _e5317 = select(1073741800f, _e5315, (_e5315 < 1073741800f));
let _e5324 = select(0i, select(select(i32(_e5317), i32(-2147483648), (_e5317 < -2147483600f)), 2147483647i, (_e5317 > 2147483500f)), (_e5317 == _e5317));
let _e5328 = (_e5324 - select(0i, 1i, (_e5317 < f32(_e5324))));
if (_e5328 == 0i) {
} else {
let _e5330 = bitcast<u32>(_e5328);
let _e5331 = bitcast<u32>((_e5216 + 6i));
if (_e5331 < _e220) {
let _e5335 = atomicAdd((&global_7.member[_e5331]), _e5330);
phi_16835_ = _e5335;
} else {
phi_16835_ = 0u;
}
let _e5337 = phi_16835_;
let _e5344 = (bitcast<u32>((_e5328 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e5337 + _e5330) < _e5330)));
if (_e5344 == 0u) {
} else {
let _e5346 = (_e5331 + 1u);
if (_e5346 < _e220) {
let _e5350 = atomicAdd((&global_7.member[_e5346]), _e5344);
}
}
}
let _e5353 = (((((_e5094 * _e4976) + (_e5121 * _e4977)) + (_e5148 * _e4978)) * 65536f) + 0.5f);
let _e5355 = select(-1073741800f, _e5353, (_e5353 > -1073741800f));
let _e5357 = select(1073741800f, _e5355, (_e5355 < 1073741800f));
let _e5364 = select(0i, select(select(i32(_e5357), i32(-2147483648), (_e5357 < -2147483600f)), 2147483647i, (_e5357 > 2147483500f)), (_e5357 == _e5357));
let _e5368 = (_e5364 - select(0i, 1i, (_e5357 < f32(_e5364))));
if (_e5368 == 0i) {
} else {
let _e5370 = bitcast<u32>(_e5368);
let _e5371 = bitcast<u32>((_e5216 + 8i));
if (_e5371 < _e220) {
let _e5375 = atomicAdd((&global_7.member[_e5371]), _e5370);
phi_16893_ = _e5375;
} else {
phi_16893_ = 0u;
}
let _e5377 = phi_16893_;
let _e5384 = (bitcast<u32>((_e5368 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e5377 + _e5370) < _e5370)));
if (_e5384 == 0u) {
} else {
let _e5386 = (_e5371 + 1u);
if (_e5386 < _e220) {
let _e5390 = atomicAdd((&global_7.member[_e5386]), _e5384);
}
}
}
let _e5393 = (((((_e5103 * _e4976) + (_e5130 * _e4977)) + (_e5157 * _e4978)) * 65536f) + 0.5f);
let _e5395 = select(-1073741800f, _e5393, (_e5393 > -1073741800f));
let _e5397 = select(1073741800f, _e5395, (_e5395 < 1073741800f));
let _e5404 = select(0i, select(select(i32(_e5397), i32(-2147483648), (_e5397 < -2147483600f)), 2147483647i, (_e5397 > 2147483500f)), (_e5397 == _e5397));
let _e5408 = (_e5404 - select(0i, 1i, (_e5397 < f32(_e5404))));
if (_e5408 == 0i) {
} else {
let _e5410 = bitcast<u32>(_e5408);
let _e5411 = bitcast<u32>((_e5216 + 10i));
if (_e5411 < _e220) {
let _e5415 = atomicAdd((&global_7.member[_e5411]), _e5410);
phi_16950_ = _e5415;
} else {
phi_16950_ = 0u;
}
let _e5417 = phi_16950_;
let _e5424 = (bitcast<u32>((_e5408 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e5417 + _e5410) < _e5410)));
if (_e5424 == 0u) {
} else {
let _e5426 = (_e5411 + 1u);
if (_e5426 < _e220) {
let _e5430 = atomicAdd((&global_7.member[_e5426]), _e5424);
}
}
}
let _e5433 = (((((_e5112 * _e4976) + (_e5139 * _e4977)) + (_e5166 * _e4978)) * 65536f) + 0.5f);
let _e5435 = select(-1073741800f, _e5433, (_e5433 > -1073741800f));
let _e5437 = select(1073741800f, _e5435, (_e5435 < 1073741800f));
let _e5444 = select(0i, select(select(i32(_e5437), i32(-2147483648), (_e5437 < -2147483600f)), 2147483647i, (_e5437 > 2147483500f)), (_e5437 == _e5437));
let _e5448 = (_e5444 - select(0i, 1i, (_e5437 < f32(_e5444))));
if (_e5448 == 0i) {
} else {
let _e5450 = bitcast<u32>(_e5448);
let _e5451 = bitcast<u32>((_e5216 + 12i));
if (_e5451 < _e220) {
let _e5455 = atomicAdd((&global_7.member[_e5451]), _e5450);
phi_17007_ = _e5455;
} else {
phi_17007_ = 0u;
}
let _e5457 = phi_17007_;
let _e5464 = (bitcast<u32>((_e5448 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e5457 + _e5450) < _e5450)));
if (_e5464 == 0u) {
} else {
let _e5466 = (_e5451 + 1u);
if (_e5466 < _e220) {
let _e5470 = atomicAdd((&global_7.member[_e5466]), _e5464);
}
}
}
phi_16194_ = (_e4907 + 1i);
} else {
phi_16194_ = i32();
}
let _e5473 = phi_16194_;
continue;
continuing {
phi_16193_ = _e5473;
break if !(_e4908);
}
}
phi_16067_ = (_e4824 + 1i);
} else {
phi_16067_ = i32();
}
let _e5477 = phi_16067_;
continue;
continuing {
phi_16066_ = _e5477;
break if !(_e4825);
}
}
phi_16050_ = (_e4817 + 1i);
} else {
phi_16050_ = i32();
}
let _e5481 = phi_16050_;
continue;
continuing {
phi_16049_ = _e5481;
break if !(_e4818);
}
}
} else {
if (_e952 == 3u) {
let _e2884 = (_e926.member_1.member_6 & 31u);
let _e2886 = (_e926.member_1.member_3.x << bitcast<u32>(_e2884));
let _e2889 = (_e926.member_1.member_7 & 31u);
let _e2893 = ((1i << bitcast<u32>(_e2889)) >> bitcast<u32>(1i));
let _e2899 = bitcast<i32>(_e926.member_1.member_6);
let _e2905 = bitcast<f32>((bitcast<u32>((127i + (bitcast<i32>(_e926.member_1.member_7) - _e2899))) << bitcast<u32>(23i)));
let _e2906 = (f32((((_e926.member_1.member.x - _e2886) + _e2893) >> bitcast<u32>(_e2889))) * _e2905);
let _e2911 = (_e926.member_1.member_3.y << bitcast<u32>(_e2884));
let _e2917 = (f32((((_e926.member_1.member.y - _e2911) + _e2893) >> bitcast<u32>(_e2889))) * _e2905);
let _e2922 = (_e926.member_1.member_3.z << bitcast<u32>(_e2884));
let _e2928 = (f32((((_e926.member_1.member.z - _e2922) + _e2893) >> bitcast<u32>(_e2889))) * _e2905);
let _e2936 = (f32((((_e926.member_1.member_1.x - _e2886) + _e2893) >> bitcast<u32>(_e2889))) * _e2905);
let _e2943 = (f32((((_e926.member_1.member_1.y - _e2911) + _e2893) >> bitcast<u32>(_e2889))) * _e2905);
let _e2950 = (f32((((_e926.member_1.member_1.z - _e2922) + _e2893) >> bitcast<u32>(_e2889))) * _e2905);
let _e2958 = (f32((((_e926.member_1.member_2.x - _e2886) + _e2893) >> bitcast<u32>(_e2889))) * _e2905);
let _e2965 = (f32((((_e926.member_1.member_2.y - _e2911) + _e2893) >> bitcast<u32>(_e2889))) * _e2905);
let _e2972 = (f32((((_e926.member_1.member_2.z - _e2922) + _e2893) >> bitcast<u32>(_e2889))) * _e2905);
let _e2980 = (f32(_e926.member_1.member_5) * bitcast<f32>((bitcast<u32>((127i - _e2899)) << bitcast<u32>(23i))));
let _e2981 = (_e2936 - _e2906);
let _e2982 = (_e2943 - _e2917);
let _e2983 = (_e2950 - _e2928);
let _e2984 = (_e2958 - _e2936);
let _e2985 = (_e2965 - _e2943);
let _e2986 = (_e2972 - _e2950);
let _e2989 = ((_e2982 * _e2986) - (_e2983 * _e2985));
let _e2993 = (_e2981 * _e2985);
let _e2994 = (_e2982 * _e2984);
let _e2995 = (_e2993 - _e2994);
let _e3003 = ((bitcast<f32>((bitcast<u32>(_e2993) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2994) & 2147483647u))) * 2.3841858e-7f);
let _e3004 = f32(_e926.member_1.member_4.x);
let _e3005 = (1f + _e2980);
let _e3008 = (_e926.member_1.member_4.z >= _e926.member_1.member_4.y);
if _e3008 {
let _e3102 = select(1f, -1f, (_e2989 < 0f));
let _e3107 = ((_e2928 - _e2950) * _e3102);
let _e3108 = ((_e2950 - _e2972) * _e3102);
let _e3109 = ((_e2972 - _e2928) * _e3102);
let _e3110 = ((0f - 0f) * _e3102);
let _e3112 = (_e2982 * _e3102);
let _e3113 = (_e2985 * _e3102);
let _e3114 = ((_e2917 - _e2965) * _e3102);
if (select(0u, 1u, ((_e3107 * _e3005) > -((_e3107 * _e2980)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3108 * _e3005) > -((_e3108 * _e2980)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3109 * _e3005) > -((_e3109 * _e2980)))) < 2u) {
} else {
break;
}
let _e3138 = (select(0u, 1u, ((_e3110 * _e3005) > -((_e3110 * _e2980)))) < 2u);
if _e3138 {
} else {
break;
}
if (select(0u, 1u, ((_e3112 * _e3005) > -((_e3112 * _e2980)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3113 * _e3005) > -((_e3113 * _e2980)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3114 * _e3005) > -((_e3114 * _e2980)))) < 2u) {
} else {
break;
}
if _e3138 {
} else {
break;
}
if (select(0u, 1u, (_e3107 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3108 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3109 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3110 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3107 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3108 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3109 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3110 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3107 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3108 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3109 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3110 < 0f)) < 2u) {
} else {
break;
}
} else {
let _e3010 = select(1f, -1f, (-(_e2989) < 0f));
let _e3015 = ((_e2917 - _e2943) * _e3010);
let _e3016 = ((_e2943 - _e2965) * _e3010);
let _e3017 = ((_e2965 - _e2917) * _e3010);
let _e3018 = ((0f - 0f) * _e3010);
let _e3020 = (_e2983 * _e3010);
let _e3021 = (_e2986 * _e3010);
let _e3022 = ((_e2928 - _e2972) * _e3010);
if (select(0u, 1u, ((_e3015 * _e3005) > -((_e3015 * _e2980)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3016 * _e3005) > -((_e3016 * _e2980)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3017 * _e3005) > -((_e3017 * _e2980)))) < 2u) {
} else {
break;
}
let _e3046 = (select(0u, 1u, ((_e3018 * _e3005) > -((_e3018 * _e2980)))) < 2u);
if _e3046 {
} else {
break;
}
if (select(0u, 1u, ((_e3020 * _e3005) > -((_e3020 * _e2980)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3021 * _e3005) > -((_e3021 * _e2980)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3022 * _e3005) > -((_e3022 * _e2980)))) < 2u) {
} else {
break;
}
if _e3046 {
} else {
break;
}
if (select(0u, 1u, (_e3015 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3016 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3017 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3018 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3015 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3016 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3017 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3018 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3015 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3016 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3017 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3018 < 0f)) < 2u) {
} else {
break;
}
}
let _e3195 = select(1f, -1f, (_e2995 < 0f));
let _e3201 = select(0f, (2f * _e3003), (bitcast<f32>((bitcast<u32>(_e2995) & 2147483647u)) <= _e3003));
let _e3204 = (_e2965 - _e2917);
let _e3205 = (0f - 0f);
let _e3206 = ((_e2917 - _e2943) * _e3195);
let _e3207 = ((_e2943 - _e2965) * _e3195);
let _e3208 = (_e3204 * _e3195);
let _e3209 = (_e3205 * _e3195);
let _e3210 = (_e2906 - _e2958);
let _e3211 = (_e2981 * _e3195);
let _e3212 = (_e2984 * _e3195);
let _e3213 = (_e3210 * _e3195);
let _e3214 = (_e3206 * _e3005);
let _e3215 = (_e3207 * _e3005);
let _e3216 = (_e3208 * _e3005);
let _e3222 = -((_e3206 * _e2980));
let _e3223 = -((_e3207 * _e2980));
let _e3224 = -((_e3208 * _e2980));
local_82 = array<u32, 2>(0u, 4294967295u);
let _e3230 = select(0u, 1u, (_e3214 > _e3222));
if (_e3230 < 2u) {
} else {
break;
}
let _e3233 = local_82[_e3230];
local_83 = array<u32, 2>(0u, 4294967295u);
let _e3234 = select(0u, 1u, (_e3215 > _e3223));
if (_e3234 < 2u) {
} else {
break;
}
let _e3237 = local_83[_e3234];
local_84 = array<u32, 2>(0u, 4294967295u);
let _e3238 = select(0u, 1u, (_e3216 > _e3224));
if (_e3238 < 2u) {
} else {
break;
}
let _e3241 = local_84[_e3238];
let _e3243 = (select(0u, 1u, ((_e3209 * _e3005) > -((_e3209 * _e2980)))) < 2u);
if _e3243 {
} else {
break;
}
let _e3259 = (_e3211 * _e3005);
let _e3260 = (_e3212 * _e3005);
let _e3261 = (_e3213 * _e3005);
let _e3265 = -((_e3211 * _e2980));
let _e3266 = -((_e3212 * _e2980));
let _e3267 = -((_e3213 * _e2980));
local_79 = array<u32, 2>(0u, 4294967295u);
let _e3271 = select(0u, 1u, (_e3259 > _e3265));
if (_e3271 < 2u) {
} else {
break;
}
let _e3274 = local_79[_e3271];
local_80 = array<u32, 2>(0u, 4294967295u);
let _e3275 = select(0u, 1u, (_e3260 > _e3266));
if (_e3275 < 2u) {
} else {
break;
}
let _e3278 = local_80[_e3275];
local_81 = array<u32, 2>(0u, 4294967295u);
let _e3279 = select(0u, 1u, (_e3261 > _e3267));
if (_e3279 < 2u) {
} else {
break;
}
let _e3282 = local_81[_e3279];
if _e3243 {
} else {
break;
}
local_76 = array<u32, 2>(0u, 4294967295u);
let _e3308 = select(0u, 1u, (_e3206 == 0f));
if (_e3308 < 2u) {
} else {
break;
}
let _e3311 = local_76[_e3308];
local_77 = array<u32, 2>(0u, 4294967295u);
let _e3312 = select(0u, 1u, (_e3207 == 0f));
if (_e3312 < 2u) {
} else {
break;
}
let _e3315 = local_77[_e3312];
local_78 = array<u32, 2>(0u, 4294967295u);
let _e3316 = select(0u, 1u, (_e3208 == 0f));
if (_e3316 < 2u) {
} else {
break;
}
let _e3319 = local_78[_e3316];
if (select(0u, 1u, (_e3209 == 0f)) < 2u) {
} else {
break;
}
let _e3323 = ((_e3311 & 1u) != 0u);
let _e3326 = ((_e3315 & 1u) != 0u);
let _e3329 = ((_e3319 & 1u) != 0u);
let _e3331 = (-1f / select(_e3206, 1f, _e3323));
let _e3332 = (-1f / select(_e3207, 1f, _e3326));
let _e3333 = (-1f / select(_e3208, 1f, _e3329));
local_73 = array<u32, 2>(0u, 4294967295u);
let _e3338 = select(0u, 1u, (_e3206 > 0f));
if (_e3338 < 2u) {
} else {
break;
}
let _e3341 = local_73[_e3338];
local_74 = array<u32, 2>(0u, 4294967295u);
let _e3342 = select(0u, 1u, (_e3207 > 0f));
if (_e3342 < 2u) {
} else {
break;
}
let _e3345 = local_74[_e3342];
local_75 = array<u32, 2>(0u, 4294967295u);
let _e3346 = select(0u, 1u, (_e3208 > 0f));
if (_e3346 < 2u) {
} else {
break;
}
let _e3349 = local_75[_e3346];
if (select(0u, 1u, (_e3209 > 0f)) < 2u) {
} else {
break;
}
local_70 = array<u32, 2>(0u, 4294967295u);
let _e3356 = select(0u, 1u, (_e3206 < 0f));
if (_e3356 < 2u) {
} else {
break;
}
let _e3359 = local_70[_e3356];
local_71 = array<u32, 2>(0u, 4294967295u);
let _e3360 = select(0u, 1u, (_e3207 < 0f));
if (_e3360 < 2u) {
} else {
break;
}
let _e3363 = local_71[_e3360];
local_72 = array<u32, 2>(0u, 4294967295u);
let _e3364 = select(0u, 1u, (_e3208 < 0f));
if (_e3364 < 2u) {
} else {
break;
}
let _e3367 = local_72[_e3364];
if (select(0u, 1u, (_e3209 < 0f)) < 2u) {
} else {
break;
}
let _e3383 = ((_e3359 & 1u) != 0u);
let _e3386 = ((_e3363 & 1u) != 0u);
let _e3389 = ((_e3367 & 1u) != 0u);
let _e3395 = select(1f, -1f, (-(((_e2983 * _e2984) - (_e2981 * _e2986))) < 0f));
let _e3398 = (_e2972 - _e2928);
let _e3399 = ((_e2928 - _e2950) * _e3395);
let _e3400 = ((_e2950 - _e2972) * _e3395);
let _e3401 = (_e3398 * _e3395);
let _e3402 = (_e3205 * _e3395);
let _e3403 = (_e2981 * _e3395);
let _e3404 = (_e2984 * _e3395);
let _e3405 = (_e3210 * _e3395);
if (select(0u, 1u, ((_e3399 * _e3005) > -((_e3399 * _e2980)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3400 * _e3005) > -((_e3400 * _e2980)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3401 * _e3005) > -((_e3401 * _e2980)))) < 2u) {
} else {
break;
}
let _e3429 = (select(0u, 1u, ((_e3402 * _e3005) > -((_e3402 * _e2980)))) < 2u);
if _e3429 {
} else {
break;
}
if (select(0u, 1u, ((_e3403 * _e3005) > -((_e3403 * _e2980)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3404 * _e3005) > -((_e3404 * _e2980)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3405 * _e3005) > -((_e3405 * _e2980)))) < 2u) {
} else {
break;
}
if _e3429 {
} else {
break;
}
if (select(0u, 1u, (_e3399 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3400 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3401 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3402 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3399 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3400 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3401 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3402 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3399 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3400 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3401 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3402 < 0f)) < 2u) {
} else {
break;
}
let _e3484 = (_e2958 - _e2906);
let _e3486 = (_e926.member.member * 19i);
let _e3487 = (_e3486 + 18i);
let _e3489 = (bitcast<i32>(_e214) - 1i);
let _e3491 = select(_e3489, _e3487, (_e3487 < _e3489));
let _e3497 = global_4.member[bitcast<u32>(select(0i, _e3491, (_e3491 > 0i)))];
let _e3499 = select(0f, _e3497, (_e3497 > 0f));
let _e3501 = select(16777216f, _e3499, (_e3499 < 16777216f));
let _e3508 = select(0i, select(select(i32(_e3501), i32(-2147483648), (_e3501 < -2147483600f)), 2147483647i, (_e3501 > 2147483500f)), (_e3501 == _e3501));
phi_21027_ = _e926.member.member_1;
loop {
let _e3515 = phi_21027_;
let _e3516 = (_e3515 < _e926.member.member_2);
if _e3516 {
if _e3008 {
phi_21042_ = _e926.member_1.member_4.y;
} else {
phi_21042_ = _e926.member_1.member_4.z;
}
let _e3520 = phi_21042_;
phi_21044_ = 0i;
loop {
let _e3522 = phi_21044_;
let _e3523 = (_e3522 <= _e3520);
if _e3523 {
let _e3524 = select(_e3522, _e3515, _e3008);
let _e3525 = select(_e3515, _e3522, _e3008);
let _e3526 = f32(_e3525);
let _e3528 = f32(_e926.member_1.member_4.x);
let _e3532 = ((_e3211 * _e3526) + (((select(_e3222, _e3214, ((_e3233 & 1u) != 0u)) - (_e3206 * _e2906)) + (select(_e3265, _e3259, ((_e3274 & 1u) != 0u)) - (_e3211 * _e2917))) + _e3201));
let _e3533 = ((_e3212 * _e3526) + (((select(_e3223, _e3215, ((_e3237 & 1u) != 0u)) - (_e3207 * _e2936)) + (select(_e3266, _e3260, ((_e3278 & 1u) != 0u)) - (_e3212 * _e2943))) + _e3201));
let _e3534 = ((_e3213 * _e3526) + (((select(_e3224, _e3216, ((_e3241 & 1u) != 0u)) - (_e3208 * _e2958)) + (select(_e3267, _e3261, ((_e3282 & 1u) != 0u)) - (_e3213 * _e2965))) + _e3201));
let _e3535 = (_e3532 * select(0f, _e3331, ((_e3341 & 1u) != 0u)));
let _e3536 = (_e3533 * select(0f, _e3332, ((_e3345 & 1u) != 0u)));
let _e3537 = (_e3534 * select(0f, _e3333, ((_e3349 & 1u) != 0u)));
let _e3541 = ((_e3532 * select(select(0f, 1e20f, _e3323), _e3331, _e3383)) + select(_e3004, 0f, _e3383));
let _e3542 = ((_e3533 * select(select(0f, 1e20f, _e3326), _e3332, _e3386)) + select(_e3004, 0f, _e3386));
let _e3543 = ((_e3534 * select(select(0f, 1e20f, _e3329), _e3333, _e3389)) + select(_e3004, 0f, _e3389));
let _e3545 = select(_e3535, 0f, (0f > _e3535));
let _e3547 = select(_e3537, _e3536, (_e3536 > _e3537));
let _e3551 = select(_e3541, _e3528, (_e3528 < _e3541));
let _e3553 = select(_e3543, _e3542, (_e3542 < _e3543));
let _e3555 = select(_e3553, _e3551, (_e3551 < _e3553));
let _e3556 = -(select(_e3547, _e3545, (_e3545 > _e3547)));
let _e3558 = (-(_e3528) - 1f);
let _e3560 = select(_e3558, _e3556, (_e3556 > _e3558));
let _e3562 = select(0f, _e3560, (_e3560 < 0f));
let _e3569 = select(0i, select(select(i32(_e3562), i32(-2147483648), (_e3562 < -2147483600f)), 2147483647i, (_e3562 > 2147483500f)), (_e3562 == _e3562));
let _e3576 = select(-1f, _e3555, (_e3555 > -1f));
let _e3578 = select(_e3528, _e3576, (_e3576 < _e3528));
let _e3585 = select(0i, select(select(i32(_e3578), i32(-2147483648), (_e3578 < -2147483600f)), 2147483647i, (_e3578 > 2147483500f)), (_e3578 == _e3578));
let _e3594 = global_1.member.member_2.member_1;
let _e3601 = global_1.member.member_3;
phi_21171_ = -((_e3569 - select(0i, 1i, (_e3562 < f32(_e3569)))));
loop {
let _e3605 = phi_21171_;
let _e3606 = (_e3605 <= (_e3585 - select(0i, 1i, (_e3578 < f32(_e3585)))));
if _e3606 {
let _e3612 = ((f32(_e3605) + 0.5f) - _e2906);
let _e3613 = ((_e3526 + 0.5f) - _e2917);
let _e3614 = ((f32(_e3524) + 0.5f) - _e2928);
let _e3619 = (((_e2981 * _e2981) + (_e2982 * _e2982)) + (_e2983 * _e2983));
let _e3624 = (((_e2981 * _e3484) + (_e2982 * _e3204)) + (_e2983 * _e3398));
let _e3629 = (((_e3484 * _e3484) + (_e3204 * _e3204)) + (_e3398 * _e3398));
let _e3634 = (((_e3612 * _e2981) + (_e3613 * _e2982)) + (_e3614 * _e2983));
let _e3639 = (((_e3612 * _e3484) + (_e3613 * _e3204)) + (_e3614 * _e3398));
let _e3642 = ((_e3619 * _e3629) - (_e3624 * _e3624));
let _e3643 = (_e3642 > 0f);
let _e3646 = select(0f, (1f / select(1f, _e3642, _e3643)), _e3643);
let _e3650 = (((_e3629 * _e3634) - (_e3624 * _e3639)) * _e3646);
let _e3654 = (((_e3619 * _e3639) - (_e3624 * _e3634)) * _e3646);
let _e3656 = ((1f - _e3650) - _e3654);
let _e3658 = select(0f, _e3656, (_e3656 > 0f));
let _e3660 = select(16777216f, _e3658, (_e3658 < 16777216f));
let _e3662 = select(0f, _e3650, (_e3650 > 0f));
let _e3664 = select(16777216f, _e3662, (_e3662 < 16777216f));
let _e3666 = select(0f, _e3654, (_e3654 > 0f));
let _e3668 = select(16777216f, _e3666, (_e3666 < 16777216f));
let _e3670 = ((_e3660 + _e3664) + _e3668);
let _e3673 = (1f / select(0.5f, _e3670, (_e3670 > 0.5f)));
let _e3674 = (_e3660 * _e3673);
let _e3675 = (_e3664 * _e3673);
let _e3676 = (_e3668 * _e3673);
let _e3678 = select(_e3489, _e3486, (_e3486 < _e3489));
let _e3684 = global_4.member[bitcast<u32>(select(0i, _e3678, (_e3678 > 0i)))];
let _e3685 = (_e3486 + 1i);
let _e3687 = select(_e3489, _e3685, (_e3685 < _e3489));
let _e3693 = global_4.member[bitcast<u32>(select(0i, _e3687, (_e3687 > 0i)))];
let _e3694 = (_e3486 + 2i);
let _e3696 = select(_e3489, _e3694, (_e3694 < _e3489));
let _e3702 = global_4.member[bitcast<u32>(select(0i, _e3696, (_e3696 > 0i)))];
let _e3703 = (_e3486 + 3i);
let _e3705 = select(_e3489, _e3703, (_e3703 < _e3489));
let _e3711 = global_4.member[bitcast<u32>(select(0i, _e3705, (_e3705 > 0i)))];
let _e3712 = (_e3486 + 4i);
let _e3714 = select(_e3489, _e3712, (_e3712 < _e3489));
let _e3720 = global_4.member[bitcast<u32>(select(0i, _e3714, (_e3714 > 0i)))];
let _e3721 = (_e3486 + 5i);
let _e3723 = select(_e3489, _e3721, (_e3721 < _e3489));
let _e3729 = global_4.member[bitcast<u32>(select(0i, _e3723, (_e3723 > 0i)))];
let _e3730 = (_e3486 + 6i);
let _e3732 = select(_e3489, _e3730, (_e3730 < _e3489));
let _e3738 = global_4.member[bitcast<u32>(select(0i, _e3732, (_e3732 > 0i)))];
let _e3739 = (_e3486 + 7i);
let _e3741 = select(_e3489, _e3739, (_e3739 < _e3489));
let _e3747 = global_4.member[bitcast<u32>(select(0i, _e3741, (_e3741 > 0i)))];
let _e3748 = (_e3486 + 8i);
let _e3750 = select(_e3489, _e3748, (_e3748 < _e3489));
let _e3756 = global_4.member[bitcast<u32>(select(0i, _e3750, (_e3750 > 0i)))];
let _e3761 = (((_e3684 * _e3674) + (_e3711 * _e3675)) + (_e3738 * _e3676));
let _e3766 = (((_e3693 * _e3674) + (_e3720 * _e3675)) + (_e3747 * _e3676));
let _e3771 = (((_e3702 * _e3674) + (_e3729 * _e3675)) + (_e3756 * _e3676));
let _e3776 = (((_e3761 * _e3761) + (_e3766 * _e3766)) + (_e3771 * _e3771));
let _e3779 = sqrt(select(0f, _e3776, (_e3776 > 0f)));
let _e3780 = (_e3779 > 1e-6f);
let _e3783 = select(0f, (1f / select(1e-6f, _e3779, _e3780)), _e3780);
let _e3784 = (_e3486 + 9i);
let _e3786 = select(_e3489, _e3784, (_e3784 < _e3489));
let _e3792 = global_4.member[bitcast<u32>(select(0i, _e3786, (_e3786 > 0i)))];
let _e3793 = (_e3486 + 10i);
let _e3795 = select(_e3489, _e3793, (_e3793 < _e3489));
let _e3801 = global_4.member[bitcast<u32>(select(0i, _e3795, (_e3795 > 0i)))];
let _e3802 = (_e3486 + 11i);
let _e3804 = select(_e3489, _e3802, (_e3802 < _e3489));
let _e3810 = global_4.member[bitcast<u32>(select(0i, _e3804, (_e3804 > 0i)))];
let _e3811 = (_e3486 + 12i);
let _e3813 = select(_e3489, _e3811, (_e3811 < _e3489));
let _e3819 = global_4.member[bitcast<u32>(select(0i, _e3813, (_e3813 > 0i)))];
let _e3820 = (_e3486 + 13i);
let _e3822 = select(_e3489, _e3820, (_e3820 < _e3489));
let _e3828 = global_4.member[bitcast<u32>(select(0i, _e3822, (_e3822 > 0i)))];
let _e3829 = (_e3486 + 14i);
let _e3831 = select(_e3489, _e3829, (_e3829 < _e3489));
let _e3837 = global_4.member[bitcast<u32>(select(0i, _e3831, (_e3831 > 0i)))];
let _e3838 = (_e3486 + 15i);
let _e3840 = select(_e3489, _e3838, (_e3838 < _e3489));
let _e3846 = global_4.member[bitcast<u32>(select(0i, _e3840, (_e3840 > 0i)))];
let _e3847 = (_e3486 + 16i);
let _e3849 = select(_e3489, _e3847, (_e3847 < _e3489));
let _e3855 = global_4.member[bitcast<u32>(select(0i, _e3849, (_e3849 > 0i)))];
let _e3856 = (_e3486 + 17i);
let _e3858 = select(_e3489, _e3856, (_e3856 < _e3489));
let _e3864 = global_4.member[bitcast<u32>(select(0i, _e3858, (_e3858 > 0i)))];
let _e3880 = (_e926.member_1.member_3.x + _e3605);
let _e3883 = ((((((_e926.member_1.member_3.z + _e3524) * bitcast<i32>(_e3594)) + _e926.member_1.member_3.y) + _e3525) * bitcast<i32>(_e3601)) + (_e3880 >> bitcast<u32>(5i)));
let _e3887 = (bitcast<i32>(_e218) - 1i);
let _e3889 = select(_e3887, _e3883, (_e3883 < _e3887));
let _e3895 = global_6.member[bitcast<u32>(select(0i, _e3889, (_e3889 > 0i)))];
let _e3897 = (bitcast<i32>(_e216) - 1i);
let _e3899 = select(_e3897, _e3883, (_e3883 < _e3897));
let _e3905 = global_5.member[bitcast<u32>(select(0i, _e3899, (_e3899 > 0i)))];
let _e3914 = (bitcast<i32>((_e3895 + countOneBits((_e3905 & ((1u << bitcast<u32>((bitcast<u32>((_e3880 & 31i)) & 31u))) - 1u))))) * 14i);
let _e3915 = bitcast<u32>(_e3914);
if (_e3915 < _e220) {
let _e3919 = atomicAdd((&global_7.member[_e3915]), 1u);
}
let _e3921 = bitcast<u32>((_e3914 + 1i));
if (_e3921 < _e220) {
let _e3925 = atomicMax((&global_7.member[_e3921]), bitcast<u32>((_e3508 - select(0i, 1i, (_e3501 < f32(_e3508))))));
}
let _e3931 = (((_e3761 * _e3783) * 65536f) + 0.5f);
let _e3933 = select(-1073741800f, _e3931, (_e3931 > -1073741800f));
let _e3935 = select(1073741800f, _e3933, (_e3933 < 1073741800f));
let _e3942 = select(0i, select(select(i32(_e3935), i32(-2147483648), (_e3935 < -2147483600f)), 2147483647i, (_e3935 > 2147483500f)), (_e3935 == _e3935));
let _e3946 = (_e3942 - select(0i, 1i, (_e3935 < f32(_e3942))));
if (_e3946 == 0i) {
} else {
let _e3948 = bitcast<u32>(_e3946);
let _e3949 = bitcast<u32>((_e3914 + 2i));
if (_e3949 < _e220) {
let _e3953 = atomicAdd((&global_7.member[_e3949]), _e3948);
phi_21699_ = _e3953;
} else {
phi_21699_ = 0u;
}
let _e3955 = phi_21699_;
let _e3962 = (bitcast<u32>((_e3946 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e3955 + _e3948) < _e3948)));
if (_e3962 == 0u) {
} else {
let _e3964 = (_e3949 + 1u);
if (_e3964 < _e220) {
let _e3968 = atomicAdd((&global_7.member[_e3964]), _e3962);
}
}
}
let _e3971 = (((_e3766 * _e3783) * 65536f) + 0.5f);
let _e3973 = select(-1073741800f, _e3971, (_e3971 > -1073741800f));
let _e3975 = select(1073741800f, _e3973, (_e3973 < 1073741800f));
let _e3982 = select(0i, select(select(i32(_e3975), i32(-2147483648), (_e3975 < -2147483600f)), 2147483647i, (_e3975 > 2147483500f)), (_e3975 == _e3975));
let _e3986 = (_e3982 - select(0i, 1i, (_e3975 < f32(_e3982))));
if (_e3986 == 0i) {
} else {
let _e3988 = bitcast<u32>(_e3986);
let _e3989 = bitcast<u32>((_e3914 + 4i));
if (_e3989 < _e220) {
let _e3993 = atomicAdd((&global_7.member[_e3989]), _e3988);
phi_21756_ = _e3993;
} else {
phi_21756_ = 0u;
}
let _e3995 = phi_21756_;
let _e4002 = (bitcast<u32>((_e3986 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e3995 + _e3988) < _e3988)));
if (_e4002 == 0u) {
} else {
let _e4004 = (_e3989 + 1u);
if (_e4004 < _e220) {
let _e4008 = atomicAdd((&global_7.member[_e4004]), _e4002);
}
}
}
let _e4011 = (((_e3771 * _e3783) * 65536f) + 0.5f);
let _e4013 = select(-1073741800f, _e4011, (_e4011 > -1073741800f));
let _e4015 = select(1073741800f, _e4013, (_e4013 < 1073741800f));
let _e4022 = select(0i, select(select(i32(_e4015), i32(-2147483648), (_e4015 < -2147483600f)), 2147483647i, (_e4015 > 2147483500f)), (_e4015 == _e4015));
let _e4026 = (_e4022 - select(0i, 1i, (_e4015 < f32(_e4022))));
if (_e4026 == 0i) {
} else {
let _e4028 = bitcast<u32>(_e4026);
let _e4029 = bitcast<u32>((_e3914 + 6i));
if (_e4029 < _e220) {
let _e4033 = atomicAdd((&global_7.member[_e4029]), _e4028);
phi_21813_ = _e4033;
} else {
phi_21813_ = 0u;
}
let _e4035 = phi_21813_;
let _e4042 = (bitcast<u32>((_e4026 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e4035 + _e4028) < _e4028)));
if (_e4042 == 0u) {
} else {
let _e4044 = (_e4029 + 1u);
if (_e4044 < _e220) {
let _e4048 = atomicAdd((&global_7.member[_e4044]), _e4042);
}
}
}
let _e4051 = (((((_e3792 * _e3674) + (_e3819 * _e3675)) + (_e3846 * _e3676)) * 65536f) + 0.5f);
let _e4053 = select(-1073741800f, _e4051, (_e4051 > -1073741800f));
let _e4055 = select(1073741800f, _e4053, (_e4053 < 1073741800f));
let _e4062 = select(0i, select(select(i32(_e4055), i32(-2147483648), (_e4055 < -2147483600f)), 2147483647i, (_e4055 > 2147483500f)), (_e4055 == _e4055));
let _e4066 = (_e4062 - select(0i, 1i, (_e4055 < f32(_e4062))));
if (_e4066 == 0i) {
} else {
let _e4068 = bitcast<u32>(_e4066);
let _e4069 = bitcast<u32>((_e3914 + 8i));
if (_e4069 < _e220) {
let _e4073 = atomicAdd((&global_7.member[_e4069]), _e4068);
phi_21871_ = _e4073;
} else {
phi_21871_ = 0u;
}
let _e4075 = phi_21871_;
let _e4082 = (bitcast<u32>((_e4066 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e4075 + _e4068) < _e4068)));
if (_e4082 == 0u) {
} else {
let _e4084 = (_e4069 + 1u);
if (_e4084 < _e220) {
let _e4088 = atomicAdd((&global_7.member[_e4084]), _e4082);
}
}
}
let _e4091 = (((((_e3801 * _e3674) + (_e3828 * _e3675)) + (_e3855 * _e3676)) * 65536f) + 0.5f);
let _e4093 = select(-1073741800f, _e4091, (_e4091 > -1073741800f));
let _e4095 = select(1073741800f, _e4093, (_e4093 < 1073741800f));
let _e4102 = select(0i, select(select(i32(_e4095), i32(-2147483648), (_e4095 < -2147483600f)), 2147483647i, (_e4095 > 2147483500f)), (_e4095 == _e4095));
let _e4106 = (_e4102 - select(0i, 1i, (_e4095 < f32(_e4102))));
if (_e4106 == 0i) {
} else {
let _e4108 = bitcast<u32>(_e4106);
let _e4109 = bitcast<u32>((_e3914 + 10i));
if (_e4109 < _e220) {
let _e4113 = atomicAdd((&global_7.member[_e4109]), _e4108);
phi_21928_ = _e4113;
} else {
phi_21928_ = 0u;
}
let _e4115 = phi_21928_;
let _e4122 = (bitcast<u32>((_e4106 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e4115 + _e4108) < _e4108)));
if (_e4122 == 0u) {
} else {
let _e4124 = (_e4109 + 1u);
if (_e4124 < _e220) {
let _e4128 = atomicAdd((&global_7.member[_e4124]), _e4122);
}
}
}
let _e4131 = (((((_e3810 * _e3674) + (_e3837 * _e3675)) + (_e3864 * _e3676)) * 65536f) + 0.5f);
let _e4133 = select(-1073741800f, _e4131, (_e4131 > -1073741800f));
let _e4135 = select(1073741800f, _e4133, (_e4133 < 1073741800f));
let _e4142 = select(0i, select(select(i32(_e4135), i32(-2147483648), (_e4135 < -2147483600f)), 2147483647i, (_e4135 > 2147483500f)), (_e4135 == _e4135));
let _e4146 = (_e4142 - select(0i, 1i, (_e4135 < f32(_e4142))));
if (_e4146 == 0i) {
} else {
let _e4148 = bitcast<u32>(_e4146);
let _e4149 = bitcast<u32>((_e3914 + 12i));
if (_e4149 < _e220) {
let _e4153 = atomicAdd((&global_7.member[_e4149]), _e4148);
phi_21985_ = _e4153;
} else {
phi_21985_ = 0u;
}
let _e4155 = phi_21985_;
let _e4162 = (bitcast<u32>((_e4146 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e4155 + _e4148) < _e4148)));
if (_e4162 == 0u) {
} else {
let _e4164 = (_e4149 + 1u);
if (_e4164 < _e220) {
let _e4168 = atomicAdd((&global_7.member[_e4164]), _e4162);
}
}
}
phi_21172_ = (_e3605 + 1i);
} else {
phi_21172_ = i32();
}
let _e4171 = phi_21172_;
continue;
continuing {
phi_21171_ = _e4171;
break if !(_e3606);
}
}
phi_21045_ = (_e3522 + 1i);
} else {
phi_21045_ = i32();
}
let _e4175 = phi_21045_;
continue;
continuing {
phi_21044_ = _e4175;
break if !(_e3523);
}
}
phi_21028_ = (_e3515 + 1i);
} else {
phi_21028_ = i32();
}
let _e4179 = phi_21028_;
continue;
continuing {
phi_21027_ = _e4179;
break if !(_e3516);
}
}
} else {
let _e962 = (_e926.member_1.member_6 & 31u);
let _e964 = (_e926.member_1.member_3.x << bitcast<u32>(_e962));
let _e967 = (_e926.member_1.member_7 & 31u);
let _e971 = ((1i << bitcast<u32>(_e967)) >> bitcast<u32>(1i));
let _e977 = bitcast<i32>(_e926.member_1.member_6);
let _e983 = bitcast<f32>((bitcast<u32>((127i + (bitcast<i32>(_e926.member_1.member_7) - _e977))) << bitcast<u32>(23i)));
let _e984 = (f32((((_e926.member_1.member.x - _e964) + _e971) >> bitcast<u32>(_e967))) * _e983);
let _e989 = (_e926.member_1.member_3.y << bitcast<u32>(_e962));
let _e995 = (f32((((_e926.member_1.member.y - _e989) + _e971) >> bitcast<u32>(_e967))) * _e983);
let _e1000 = (_e926.member_1.member_3.z << bitcast<u32>(_e962));
let _e1006 = (f32((((_e926.member_1.member.z - _e1000) + _e971) >> bitcast<u32>(_e967))) * _e983);
let _e1014 = (f32((((_e926.member_1.member_1.x - _e964) + _e971) >> bitcast<u32>(_e967))) * _e983);
let _e1021 = (f32((((_e926.member_1.member_1.y - _e989) + _e971) >> bitcast<u32>(_e967))) * _e983);
let _e1028 = (f32((((_e926.member_1.member_1.z - _e1000) + _e971) >> bitcast<u32>(_e967))) * _e983);
let _e1036 = (f32((((_e926.member_1.member_2.x - _e964) + _e971) >> bitcast<u32>(_e967))) * _e983);
let _e1043 = (f32((((_e926.member_1.member_2.y - _e989) + _e971) >> bitcast<u32>(_e967))) * _e983);
let _e1050 = (f32((((_e926.member_1.member_2.z - _e1000) + _e971) >> bitcast<u32>(_e967))) * _e983);
let _e1058 = (f32(_e926.member_1.member_5) * bitcast<f32>((bitcast<u32>((127i - _e977)) << bitcast<u32>(23i))));
let _e1059 = (_e1014 - _e984);
let _e1060 = (_e1021 - _e995);
let _e1061 = (_e1028 - _e1006);
let _e1062 = (_e1036 - _e1014);
let _e1063 = (_e1043 - _e1021);
let _e1064 = (_e1050 - _e1028);
let _e1065 = (_e1060 * _e1064);
let _e1066 = (_e1061 * _e1063);
let _e1067 = (_e1065 - _e1066);
let _e1068 = (_e1061 * _e1062);
let _e1069 = (_e1059 * _e1064);
let _e1070 = (_e1068 - _e1069);
let _e1071 = (_e1059 * _e1063);
let _e1072 = (_e1060 * _e1062);
let _e1073 = (_e1071 - _e1072);
let _e1081 = ((bitcast<f32>((bitcast<u32>(_e1065) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1066) & 2147483647u))) * 2.3841858e-7f);
let _e1089 = ((bitcast<f32>((bitcast<u32>(_e1068) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1069) & 2147483647u))) * 2.3841858e-7f);
let _e1097 = ((bitcast<f32>((bitcast<u32>(_e1071) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1072) & 2147483647u))) * 2.3841858e-7f);
let _e1098 = f32(_e926.member_1.member_4.x);
let _e1099 = f32(_e926.member_1.member_4.y);
let _e1100 = f32(_e926.member_1.member_4.z);
let _e1102 = select(_e1099, _e1098, (_e1098 > _e1099));
let _e1108 = (((_e1081 + _e1089) + _e1097) * (select(_e1100, _e1102, (_e1102 > _e1100)) + 2f));
let _e1113 = (((_e1067 * _e984) + (_e1070 * _e995)) + (_e1073 * _e1006));
let _e1114 = (1f + _e1058);
let _e1115 = (_e1067 * _e1114);
let _e1117 = -((_e1067 * _e1058));
let _e1120 = (_e1070 * _e1114);
let _e1122 = -((_e1070 * _e1058));
let _e1126 = (_e1073 * _e1114);
let _e1128 = -((_e1073 * _e1058));
let _e1132 = -(_e1067);
let _e1133 = (_e1132 * _e1114);
let _e1135 = -((_e1132 * _e1058));
let _e1138 = -(_e1070);
let _e1139 = (_e1138 * _e1114);
let _e1141 = -((_e1138 * _e1058));
let _e1145 = -(_e1073);
let _e1146 = (_e1145 * _e1114);
let _e1148 = -((_e1145 * _e1058));
let _e1152 = (_e926.member_1.member_4.z >= _e926.member_1.member_4.y);
if _e1152 {
let _e1393 = select(1f, -1f, (_e1067 < 0f));
let _e1399 = select(0f, (2f * _e1081), (bitcast<f32>((bitcast<u32>(_e1067) & 2147483647u)) <= _e1081));
let _e1404 = ((_e1006 - _e1028) * _e1393);
let _e1405 = ((_e1028 - _e1050) * _e1393);
let _e1406 = ((_e1050 - _e1006) * _e1393);
let _e1407 = ((0f - 0f) * _e1393);
let _e1409 = (_e1060 * _e1393);
let _e1410 = (_e1063 * _e1393);
let _e1411 = ((_e995 - _e1043) * _e1393);
let _e1413 = (_e1404 * _e1114);
let _e1414 = (_e1405 * _e1114);
let _e1415 = (_e1406 * _e1114);
let _e1416 = (_e1407 * _e1114);
let _e1421 = -((_e1404 * _e1058));
let _e1422 = -((_e1405 * _e1058));
let _e1423 = -((_e1406 * _e1058));
let _e1424 = -((_e1407 * _e1058));
local_66 = array<u32, 2>(0u, 4294967295u);
let _e1429 = select(0u, 1u, (_e1413 > _e1421));
if (_e1429 < 2u) {
} else {
break;
}
let _e1432 = local_66[_e1429];
local_67 = array<u32, 2>(0u, 4294967295u);
let _e1433 = select(0u, 1u, (_e1414 > _e1422));
if (_e1433 < 2u) {
} else {
break;
}
let _e1436 = local_67[_e1433];
local_68 = array<u32, 2>(0u, 4294967295u);
let _e1437 = select(0u, 1u, (_e1415 > _e1423));
if (_e1437 < 2u) {
} else {
break;
}
let _e1440 = local_68[_e1437];
local_69 = array<u32, 2>(0u, 4294967295u);
let _e1441 = select(0u, 1u, (_e1416 > _e1424));
let _e1442 = (_e1441 < 2u);
if _e1442 {
} else {
break;
}
let _e1444 = local_69[_e1441];
let _e1460 = (_e1407 * 0f);
let _e1465 = (_e1409 * _e1114);
let _e1466 = (_e1410 * _e1114);
let _e1467 = (_e1411 * _e1114);
let _e1471 = -((_e1409 * _e1058));
let _e1472 = -((_e1410 * _e1058));
let _e1473 = -((_e1411 * _e1058));
local_62 = array<u32, 2>(0u, 4294967295u);
let _e1477 = select(0u, 1u, (_e1465 > _e1471));
if (_e1477 < 2u) {
} else {
break;
}
let _e1480 = local_62[_e1477];
local_63 = array<u32, 2>(0u, 4294967295u);
let _e1481 = select(0u, 1u, (_e1466 > _e1472));
if (_e1481 < 2u) {
} else {
break;
}
let _e1484 = local_63[_e1481];
local_64 = array<u32, 2>(0u, 4294967295u);
let _e1485 = select(0u, 1u, (_e1467 > _e1473));
if (_e1485 < 2u) {
} else {
break;
}
let _e1488 = local_64[_e1485];
local_65 = array<u32, 2>(0u, 4294967295u);
if _e1442 {
} else {
break;
}
let _e1490 = local_65[_e1441];
local_58 = array<u32, 2>(0u, 4294967295u);
let _e1523 = select(0u, 1u, (_e1404 == 0f));
if (_e1523 < 2u) {
} else {
break;
}
let _e1526 = local_58[_e1523];
local_59 = array<u32, 2>(0u, 4294967295u);
let _e1527 = select(0u, 1u, (_e1405 == 0f));
if (_e1527 < 2u) {
} else {
break;
}
let _e1530 = local_59[_e1527];
local_60 = array<u32, 2>(0u, 4294967295u);
let _e1531 = select(0u, 1u, (_e1406 == 0f));
if (_e1531 < 2u) {
} else {
break;
}
let _e1534 = local_60[_e1531];
local_61 = array<u32, 2>(0u, 4294967295u);
let _e1535 = select(0u, 1u, (_e1407 == 0f));
if (_e1535 < 2u) {
} else {
break;
}
let _e1538 = local_61[_e1535];
let _e1540 = ((_e1526 & 1u) != 0u);
let _e1543 = ((_e1530 & 1u) != 0u);
let _e1546 = ((_e1534 & 1u) != 0u);
let _e1549 = ((_e1538 & 1u) != 0u);
let _e1551 = (-1f / select(_e1404, 1f, _e1540));
let _e1552 = (-1f / select(_e1405, 1f, _e1543));
let _e1553 = (-1f / select(_e1406, 1f, _e1546));
let _e1554 = (-1f / select(_e1407, 1f, _e1549));
local_54 = array<u32, 2>(0u, 4294967295u);
let _e1559 = select(0u, 1u, (_e1404 > 0f));
if (_e1559 < 2u) {
} else {
break;
}
let _e1562 = local_54[_e1559];
local_55 = array<u32, 2>(0u, 4294967295u);
let _e1563 = select(0u, 1u, (_e1405 > 0f));
if (_e1563 < 2u) {
} else {
break;
}
let _e1566 = local_55[_e1563];
local_56 = array<u32, 2>(0u, 4294967295u);
let _e1567 = select(0u, 1u, (_e1406 > 0f));
if (_e1567 < 2u) {
} else {
break;
}
let _e1570 = local_56[_e1567];
local_57 = array<u32, 2>(0u, 4294967295u);
let _e1571 = select(0u, 1u, (_e1407 > 0f));
if (_e1571 < 2u) {
} else {
break;
}
let _e1574 = local_57[_e1571];
local_50 = array<u32, 2>(0u, 4294967295u);
let _e1579 = select(0u, 1u, (_e1404 < 0f));
if (_e1579 < 2u) {
} else {
break;
}
let _e1582 = local_50[_e1579];
local_51 = array<u32, 2>(0u, 4294967295u);
let _e1583 = select(0u, 1u, (_e1405 < 0f));
if (_e1583 < 2u) {
} else {
break;
}
let _e1586 = local_51[_e1583];
local_52 = array<u32, 2>(0u, 4294967295u);
let _e1587 = select(0u, 1u, (_e1406 < 0f));
if (_e1587 < 2u) {
} else {
break;
}
let _e1590 = local_52[_e1587];
local_53 = array<u32, 2>(0u, 4294967295u);
let _e1591 = select(0u, 1u, (_e1407 < 0f));
if (_e1591 < 2u) {
} else {
break;
}
let _e1594 = local_53[_e1591];
let _e1613 = ((_e1582 & 1u) != 0u);
let _e1616 = ((_e1586 & 1u) != 0u);
let _e1619 = ((_e1590 & 1u) != 0u);
let _e1622 = ((_e1594 & 1u) != 0u);
phi_24044_ = type_18(vec4<f32>(_e1409, _e1410, _e1411, _e1407), vec4<f32>((((select(_e1421, _e1413, ((_e1432 & 1u) != 0u)) - (_e1404 * _e995)) + (select(_e1471, _e1465, ((_e1480 & 1u) != 0u)) - (_e1409 * _e1006))) + _e1399), (((select(_e1422, _e1414, ((_e1436 & 1u) != 0u)) - (_e1405 * _e1021)) + (select(_e1472, _e1466, ((_e1484 & 1u) != 0u)) - (_e1410 * _e1028))) + _e1399), (((select(_e1423, _e1415, ((_e1440 & 1u) != 0u)) - (_e1406 * _e1043)) + (select(_e1473, _e1467, ((_e1488 & 1u) != 0u)) - (_e1411 * _e1050))) + _e1399), (((select(_e1424, _e1416, ((_e1444 & 1u) != 0u)) - _e1460) + (select(_e1424, _e1416, ((_e1490 & 1u) != 0u)) - _e1460)) + _e1399)), vec4<f32>(select(0f, _e1551, ((_e1562 & 1u) != 0u)), select(0f, _e1552, ((_e1566 & 1u) != 0u)), select(0f, _e1553, ((_e1570 & 1u) != 0u)), select(0f, _e1554, ((_e1574 & 1u) != 0u))), vec4<f32>(select(select(0f, 1e20f, _e1540), _e1551, _e1613), select(select(0f, 1e20f, _e1543), _e1552, _e1616), select(select(0f, 1e20f, _e1546), _e1553, _e1619), select(select(0f, 1e20f, _e1549), _e1554, _e1622)), vec4<f32>(select(_e1099, 0f, _e1613), select(_e1099, 0f, _e1616), select(_e1099, 0f, _e1619), select(_e1099, 0f, _e1622)));
} else {
let _e1154 = select(1f, -1f, (_e1132 < 0f));
let _e1160 = select(0f, (2f * _e1081), (bitcast<f32>((bitcast<u32>(_e1132) & 2147483647u)) <= _e1081));
let _e1165 = ((_e995 - _e1021) * _e1154);
let _e1166 = ((_e1021 - _e1043) * _e1154);
let _e1167 = ((_e1043 - _e995) * _e1154);
let _e1168 = ((0f - 0f) * _e1154);
let _e1170 = (_e1061 * _e1154);
let _e1171 = (_e1064 * _e1154);
let _e1172 = ((_e1006 - _e1050) * _e1154);
let _e1174 = (_e1165 * _e1114);
let _e1175 = (_e1166 * _e1114);
let _e1176 = (_e1167 * _e1114);
let _e1177 = (_e1168 * _e1114);
let _e1182 = -((_e1165 * _e1058));
let _e1183 = -((_e1166 * _e1058));
let _e1184 = -((_e1167 * _e1058));
let _e1185 = -((_e1168 * _e1058));
local_46 = array<u32, 2>(0u, 4294967295u);
let _e1190 = select(0u, 1u, (_e1174 > _e1182));
if (_e1190 < 2u) {
} else {
break;
}
let _e1193 = local_46[_e1190];
local_47 = array<u32, 2>(0u, 4294967295u);
let _e1194 = select(0u, 1u, (_e1175 > _e1183));
if (_e1194 < 2u) {
} else {
break;
}
let _e1197 = local_47[_e1194];
local_48 = array<u32, 2>(0u, 4294967295u);
let _e1198 = select(0u, 1u, (_e1176 > _e1184));
if (_e1198 < 2u) {
} else {
break;
}
let _e1201 = local_48[_e1198];
local_49 = array<u32, 2>(0u, 4294967295u);
let _e1202 = select(0u, 1u, (_e1177 > _e1185));
let _e1203 = (_e1202 < 2u);
if _e1203 {
} else {
break;
}
let _e1205 = local_49[_e1202];
let _e1221 = (_e1168 * 0f);
let _e1226 = (_e1170 * _e1114);
let _e1227 = (_e1171 * _e1114);
let _e1228 = (_e1172 * _e1114);
let _e1232 = -((_e1170 * _e1058));
let _e1233 = -((_e1171 * _e1058));
let _e1234 = -((_e1172 * _e1058));
local_42 = array<u32, 2>(0u, 4294967295u);
let _e1238 = select(0u, 1u, (_e1226 > _e1232));
if (_e1238 < 2u) {
} else {
break;
}
let _e1241 = local_42[_e1238];
local_43 = array<u32, 2>(0u, 4294967295u);
let _e1242 = select(0u, 1u, (_e1227 > _e1233));
if (_e1242 < 2u) {
} else {
break;
}
let _e1245 = local_43[_e1242];
local_44 = array<u32, 2>(0u, 4294967295u);
let _e1246 = select(0u, 1u, (_e1228 > _e1234));
if (_e1246 < 2u) {
} else {
break;
}
let _e1249 = local_44[_e1246];
local_45 = array<u32, 2>(0u, 4294967295u);
if _e1203 {
} else {
break;
}
let _e1251 = local_45[_e1202];
local_38 = array<u32, 2>(0u, 4294967295u);
let _e1284 = select(0u, 1u, (_e1165 == 0f));
if (_e1284 < 2u) {
} else {
break;
}
let _e1287 = local_38[_e1284];
local_39 = array<u32, 2>(0u, 4294967295u);
let _e1288 = select(0u, 1u, (_e1166 == 0f));
if (_e1288 < 2u) {
} else {
break;
}
let _e1291 = local_39[_e1288];
local_40 = array<u32, 2>(0u, 4294967295u);
let _e1292 = select(0u, 1u, (_e1167 == 0f));
if (_e1292 < 2u) {
} else {
break;
}
let _e1295 = local_40[_e1292];
local_41 = array<u32, 2>(0u, 4294967295u);
let _e1296 = select(0u, 1u, (_e1168 == 0f));
if (_e1296 < 2u) {
} else {
break;
}
let _e1299 = local_41[_e1296];
let _e1301 = ((_e1287 & 1u) != 0u);
let _e1304 = ((_e1291 & 1u) != 0u);
let _e1307 = ((_e1295 & 1u) != 0u);
let _e1310 = ((_e1299 & 1u) != 0u);
let _e1312 = (-1f / select(_e1165, 1f, _e1301));
let _e1313 = (-1f / select(_e1166, 1f, _e1304));
let _e1314 = (-1f / select(_e1167, 1f, _e1307));
let _e1315 = (-1f / select(_e1168, 1f, _e1310));
local_34 = array<u32, 2>(0u, 4294967295u);
let _e1320 = select(0u, 1u, (_e1165 > 0f));
if (_e1320 < 2u) {
} else {
break;
}
let _e1323 = local_34[_e1320];
local_35 = array<u32, 2>(0u, 4294967295u);
let _e1324 = select(0u, 1u, (_e1166 > 0f));
if (_e1324 < 2u) {
} else {
break;
}
let _e1327 = local_35[_e1324];
local_36 = array<u32, 2>(0u, 4294967295u);
let _e1328 = select(0u, 1u, (_e1167 > 0f));
if (_e1328 < 2u) {
} else {
break;
}
let _e1331 = local_36[_e1328];
local_37 = array<u32, 2>(0u, 4294967295u);
let _e1332 = select(0u, 1u, (_e1168 > 0f));
if (_e1332 < 2u) {
} else {
break;
}
let _e1335 = local_37[_e1332];
local_30 = array<u32, 2>(0u, 4294967295u);
let _e1340 = select(0u, 1u, (_e1165 < 0f));
if (_e1340 < 2u) {
} else {
break;
}
let _e1343 = local_30[_e1340];
local_31 = array<u32, 2>(0u, 4294967295u);
let _e1344 = select(0u, 1u, (_e1166 < 0f));
if (_e1344 < 2u) {
} else {
break;
}
let _e1347 = local_31[_e1344];
local_32 = array<u32, 2>(0u, 4294967295u);
let _e1348 = select(0u, 1u, (_e1167 < 0f));
if (_e1348 < 2u) {
} else {
break;
}
let _e1351 = local_32[_e1348];
local_33 = array<u32, 2>(0u, 4294967295u);
let _e1352 = select(0u, 1u, (_e1168 < 0f));
if (_e1352 < 2u) {
} else {
break;
}
let _e1355 = local_33[_e1352];
let _e1374 = ((_e1343 & 1u) != 0u);
let _e1377 = ((_e1347 & 1u) != 0u);
let _e1380 = ((_e1351 & 1u) != 0u);
let _e1383 = ((_e1355 & 1u) != 0u);
phi_24044_ = type_18(vec4<f32>(_e1170, _e1171, _e1172, _e1168), vec4<f32>((((select(_e1182, _e1174, ((_e1193 & 1u) != 0u)) - (_e1165 * _e1006)) + (select(_e1232, _e1226, ((_e1241 & 1u) != 0u)) - (_e1170 * _e995))) + _e1160), (((select(_e1183, _e1175, ((_e1197 & 1u) != 0u)) - (_e1166 * _e1028)) + (select(_e1233, _e1227, ((_e1245 & 1u) != 0u)) - (_e1171 * _e1021))) + _e1160), (((select(_e1184, _e1176, ((_e1201 & 1u) != 0u)) - (_e1167 * _e1050)) + (select(_e1234, _e1228, ((_e1249 & 1u) != 0u)) - (_e1172 * _e1043))) + _e1160), (((select(_e1185, _e1177, ((_e1205 & 1u) != 0u)) - _e1221) + (select(_e1185, _e1177, ((_e1251 & 1u) != 0u)) - _e1221)) + _e1160)), vec4<f32>(select(0f, _e1312, ((_e1323 & 1u) != 0u)), select(0f, _e1313, ((_e1327 & 1u) != 0u)), select(0f, _e1314, ((_e1331 & 1u) != 0u)), select(0f, _e1315, ((_e1335 & 1u) != 0u))), vec4<f32>(select(select(0f, 1e20f, _e1301), _e1312, _e1374), select(select(0f, 1e20f, _e1304), _e1313, _e1377), select(select(0f, 1e20f, _e1307), _e1314, _e1380), select(select(0f, 1e20f, _e1310), _e1315, _e1383)), vec4<f32>(select(_e1100, 0f, _e1374), select(_e1100, 0f, _e1377), select(_e1100, 0f, _e1380), select(_e1100, 0f, _e1383)));
}
let _e1632 = phi_24044_;
let _e1634 = (_e1067 == 0f);
let _e1636 = (1f / select(_e1067, 1f, _e1634));
let _e1642 = select(1f, -1f, (_e1073 < 0f));
let _e1648 = select(0f, (2f * _e1097), (bitcast<f32>((bitcast<u32>(_e1073) & 2147483647u)) <= _e1097));
let _e1651 = (_e1043 - _e995);
let _e1652 = (0f - 0f);
let _e1653 = ((_e995 - _e1021) * _e1642);
let _e1654 = ((_e1021 - _e1043) * _e1642);
let _e1655 = (_e1651 * _e1642);
let _e1656 = (_e1652 * _e1642);
let _e1657 = (_e984 - _e1036);
let _e1658 = (_e1059 * _e1642);
let _e1659 = (_e1062 * _e1642);
let _e1660 = (_e1657 * _e1642);
let _e1661 = (_e1653 * _e1114);
let _e1662 = (_e1654 * _e1114);
let _e1663 = (_e1655 * _e1114);
let _e1669 = -((_e1653 * _e1058));
let _e1670 = -((_e1654 * _e1058));
let _e1671 = -((_e1655 * _e1058));
local_27 = array<u32, 2>(0u, 4294967295u);
let _e1677 = select(0u, 1u, (_e1661 > _e1669));
if (_e1677 < 2u) {
} else {
break;
}
let _e1680 = local_27[_e1677];
local_28 = array<u32, 2>(0u, 4294967295u);
let _e1681 = select(0u, 1u, (_e1662 > _e1670));
if (_e1681 < 2u) {
} else {
break;
}
let _e1684 = local_28[_e1681];
local_29 = array<u32, 2>(0u, 4294967295u);
let _e1685 = select(0u, 1u, (_e1663 > _e1671));
if (_e1685 < 2u) {
} else {
break;
}
let _e1688 = local_29[_e1685];
let _e1690 = (select(0u, 1u, ((_e1656 * _e1114) > -((_e1656 * _e1058)))) < 2u);
if _e1690 {
} else {
break;
}
let _e1706 = (_e1658 * _e1114);
let _e1707 = (_e1659 * _e1114);
let _e1708 = (_e1660 * _e1114);
let _e1712 = -((_e1658 * _e1058));
let _e1713 = -((_e1659 * _e1058));
let _e1714 = -((_e1660 * _e1058));
local_24 = array<u32, 2>(0u, 4294967295u);
let _e1718 = select(0u, 1u, (_e1706 > _e1712));
if (_e1718 < 2u) {
} else {
break;
}
let _e1721 = local_24[_e1718];
local_25 = array<u32, 2>(0u, 4294967295u);
let _e1722 = select(0u, 1u, (_e1707 > _e1713));
if (_e1722 < 2u) {
} else {
break;
}
let _e1725 = local_25[_e1722];
local_26 = array<u32, 2>(0u, 4294967295u);
let _e1726 = select(0u, 1u, (_e1708 > _e1714));
if (_e1726 < 2u) {
} else {
break;
}
let _e1729 = local_26[_e1726];
if _e1690 {
} else {
break;
}
local_21 = array<u32, 2>(0u, 4294967295u);
let _e1755 = select(0u, 1u, (_e1653 == 0f));
if (_e1755 < 2u) {
} else {
break;
}
let _e1758 = local_21[_e1755];
local_22 = array<u32, 2>(0u, 4294967295u);
let _e1759 = select(0u, 1u, (_e1654 == 0f));
if (_e1759 < 2u) {
} else {
break;
}
let _e1762 = local_22[_e1759];
local_23 = array<u32, 2>(0u, 4294967295u);
let _e1763 = select(0u, 1u, (_e1655 == 0f));
if (_e1763 < 2u) {
} else {
break;
}
let _e1766 = local_23[_e1763];
if (select(0u, 1u, (_e1656 == 0f)) < 2u) {
} else {
break;
}
let _e1770 = ((_e1758 & 1u) != 0u);
let _e1773 = ((_e1762 & 1u) != 0u);
let _e1776 = ((_e1766 & 1u) != 0u);
let _e1778 = (-1f / select(_e1653, 1f, _e1770));
let _e1779 = (-1f / select(_e1654, 1f, _e1773));
let _e1780 = (-1f / select(_e1655, 1f, _e1776));
local_18 = array<u32, 2>(0u, 4294967295u);
let _e1785 = select(0u, 1u, (_e1653 > 0f));
if (_e1785 < 2u) {
} else {
break;
}
let _e1788 = local_18[_e1785];
local_19 = array<u32, 2>(0u, 4294967295u);
let _e1789 = select(0u, 1u, (_e1654 > 0f));
if (_e1789 < 2u) {
} else {
break;
}
let _e1792 = local_19[_e1789];
local_20 = array<u32, 2>(0u, 4294967295u);
let _e1793 = select(0u, 1u, (_e1655 > 0f));
if (_e1793 < 2u) {
} else {
break;
}
let _e1796 = local_20[_e1793];
if (select(0u, 1u, (_e1656 > 0f)) < 2u) {
} else {
break;
}
local_15 = array<u32, 2>(0u, 4294967295u);
let _e1803 = select(0u, 1u, (_e1653 < 0f));
if (_e1803 < 2u) {
} else {
break;
}
let _e1806 = local_15[_e1803];
local_16 = array<u32, 2>(0u, 4294967295u);
let _e1807 = select(0u, 1u, (_e1654 < 0f));
if (_e1807 < 2u) {
} else {
break;
}
let _e1810 = local_16[_e1807];
local_17 = array<u32, 2>(0u, 4294967295u);
let _e1811 = select(0u, 1u, (_e1655 < 0f));
if (_e1811 < 2u) {
} else {
break;
}
let _e1814 = local_17[_e1811];
if (select(0u, 1u, (_e1656 < 0f)) < 2u) {
} else {
break;
}
let _e1830 = ((_e1806 & 1u) != 0u);
let _e1833 = ((_e1810 & 1u) != 0u);
let _e1836 = ((_e1814 & 1u) != 0u);
let _e1842 = select(1f, -1f, (_e1138 < 0f));
let _e1848 = select(0f, (2f * _e1089), (bitcast<f32>((bitcast<u32>(_e1138) & 2147483647u)) <= _e1089));
let _e1851 = (_e1050 - _e1006);
let _e1852 = ((_e1006 - _e1028) * _e1842);
let _e1853 = ((_e1028 - _e1050) * _e1842);
let _e1854 = (_e1851 * _e1842);
let _e1855 = (_e1652 * _e1842);
let _e1856 = (_e1059 * _e1842);
let _e1857 = (_e1062 * _e1842);
let _e1858 = (_e1657 * _e1842);
let _e1859 = (_e1852 * _e1114);
let _e1860 = (_e1853 * _e1114);
let _e1861 = (_e1854 * _e1114);
let _e1867 = -((_e1852 * _e1058));
let _e1868 = -((_e1853 * _e1058));
let _e1869 = -((_e1854 * _e1058));
local_12 = array<u32, 2>(0u, 4294967295u);
let _e1875 = select(0u, 1u, (_e1859 > _e1867));
if (_e1875 < 2u) {
} else {
break;
}
let _e1878 = local_12[_e1875];
local_13 = array<u32, 2>(0u, 4294967295u);
let _e1879 = select(0u, 1u, (_e1860 > _e1868));
if (_e1879 < 2u) {
} else {
break;
}
let _e1882 = local_13[_e1879];
local_14 = array<u32, 2>(0u, 4294967295u);
let _e1883 = select(0u, 1u, (_e1861 > _e1869));
if (_e1883 < 2u) {
} else {
break;
}
let _e1886 = local_14[_e1883];
let _e1888 = (select(0u, 1u, ((_e1855 * _e1114) > -((_e1855 * _e1058)))) < 2u);
if _e1888 {
} else {
break;
}
let _e1904 = (_e1856 * _e1114);
let _e1905 = (_e1857 * _e1114);
let _e1906 = (_e1858 * _e1114);
let _e1910 = -((_e1856 * _e1058));
let _e1911 = -((_e1857 * _e1058));
let _e1912 = -((_e1858 * _e1058));
local_9 = array<u32, 2>(0u, 4294967295u);
let _e1916 = select(0u, 1u, (_e1904 > _e1910));
if (_e1916 < 2u) {
} else {
break;
}
let _e1919 = local_9[_e1916];
local_10 = array<u32, 2>(0u, 4294967295u);
let _e1920 = select(0u, 1u, (_e1905 > _e1911));
if (_e1920 < 2u) {
} else {
break;
}
let _e1923 = local_10[_e1920];
local_11 = array<u32, 2>(0u, 4294967295u);
let _e1924 = select(0u, 1u, (_e1906 > _e1912));
if (_e1924 < 2u) {
} else {
break;
}
let _e1927 = local_11[_e1924];
if _e1888 {
} else {
break;
}
local_6 = array<u32, 2>(0u, 4294967295u);
let _e1953 = select(0u, 1u, (_e1852 == 0f));
if (_e1953 < 2u) {
} else {
break;
}
let _e1956 = local_6[_e1953];
local_7 = array<u32, 2>(0u, 4294967295u);
let _e1957 = select(0u, 1u, (_e1853 == 0f));
if (_e1957 < 2u) {
} else {
break;
}
let _e1960 = local_7[_e1957];
local_8 = array<u32, 2>(0u, 4294967295u);
let _e1961 = select(0u, 1u, (_e1854 == 0f));
if (_e1961 < 2u) {
} else {
break;
}
let _e1964 = local_8[_e1961];
if (select(0u, 1u, (_e1855 == 0f)) < 2u) {
} else {
break;
}
let _e1968 = ((_e1956 & 1u) != 0u);
let _e1971 = ((_e1960 & 1u) != 0u);
let _e1974 = ((_e1964 & 1u) != 0u);
let _e1976 = (-1f / select(_e1852, 1f, _e1968));
let _e1977 = (-1f / select(_e1853, 1f, _e1971));
let _e1978 = (-1f / select(_e1854, 1f, _e1974));
local_3 = array<u32, 2>(0u, 4294967295u);
let _e1983 = select(0u, 1u, (_e1852 > 0f));
if (_e1983 < 2u) {
} else {
break;
}
let _e1986 = local_3[_e1983];
local_4 = array<u32, 2>(0u, 4294967295u);
let _e1987 = select(0u, 1u, (_e1853 > 0f));
if (_e1987 < 2u) {
} else {
break;
}
let _e1990 = local_4[_e1987];
local_5 = array<u32, 2>(0u, 4294967295u);
let _e1991 = select(0u, 1u, (_e1854 > 0f));
if (_e1991 < 2u) {
} else {
break;
}
let _e1994 = local_5[_e1991];
if (select(0u, 1u, (_e1855 > 0f)) < 2u) {
} else {
break;
}
local = array<u32, 2>(0u, 4294967295u);
let _e2001 = select(0u, 1u, (_e1852 < 0f));
if (_e2001 < 2u) {
} else {
break;
}
let _e2004 = local[_e2001];
local_1 = array<u32, 2>(0u, 4294967295u);
let _e2005 = select(0u, 1u, (_e1853 < 0f));
if (_e2005 < 2u) {
} else {
break;
}
let _e2008 = local_1[_e2005];
local_2 = array<u32, 2>(0u, 4294967295u);
let _e2009 = select(0u, 1u, (_e1854 < 0f));
if (_e2009 < 2u) {
} else {
break;
}
let _e2012 = local_2[_e2009];
if (select(0u, 1u, (_e1855 < 0f)) < 2u) {
} else {
break;
}
let _e2028 = ((_e2004 & 1u) != 0u);
let _e2031 = ((_e2008 & 1u) != 0u);
let _e2034 = ((_e2012 & 1u) != 0u);
let _e2039 = (_e1036 - _e984);
let _e2041 = (_e926.member.member * 19i);
let _e2042 = (_e2041 + 18i);
let _e2044 = (bitcast<i32>(_e214) - 1i);
let _e2046 = select(_e2044, _e2042, (_e2042 < _e2044));
let _e2052 = global_4.member[bitcast<u32>(select(0i, _e2046, (_e2046 > 0i)))];
let _e2054 = select(0f, _e2052, (_e2052 > 0f));
let _e2056 = select(16777216f, _e2054, (_e2054 < 16777216f));
let _e2063 = select(0i, select(select(i32(_e2056), i32(-2147483648), (_e2056 < -2147483600f)), 2147483647i, (_e2056 > 2147483500f)), (_e2056 == _e2056));
phi_26001_ = _e926.member.member_1;
loop {
let _e2070 = phi_26001_;
let _e2071 = (_e2070 < _e926.member.member_2);
if _e2071 {
if _e1152 {
phi_26016_ = _e926.member_1.member_4.y;
} else {
phi_26016_ = _e926.member_1.member_4.z;
}
let _e2075 = phi_26016_;
let _e2076 = f32(_e2075);
let _e2077 = f32(_e2070);
let _e2087 = ((_e1632.member.x * _e2077) + _e1632.member_1.x);
let _e2089 = ((_e1632.member.y * _e2077) + _e1632.member_1.y);
let _e2091 = ((_e1632.member.z * _e2077) + _e1632.member_1.z);
let _e2094 = (_e2087 * _e1632.member_2.x);
let _e2096 = (_e2089 * _e1632.member_2.y);
let _e2098 = (_e2091 * _e1632.member_2.z);
let _e2108 = ((_e2087 * _e1632.member_3.x) + _e1632.member_4.x);
let _e2110 = ((_e2089 * _e1632.member_3.y) + _e1632.member_4.y);
let _e2112 = ((_e2091 * _e1632.member_3.z) + _e1632.member_4.z);
let _e2114 = select(_e2094, 0f, (0f > _e2094));
let _e2116 = select(_e2098, _e2096, (_e2096 > _e2098));
let _e2120 = select(_e2108, _e2076, (_e2076 < _e2108));
let _e2122 = select(_e2112, _e2110, (_e2110 < _e2112));
let _e2124 = select(_e2122, _e2120, (_e2120 < _e2122));
let _e2125 = -(select(_e2116, _e2114, (_e2114 > _e2116)));
let _e2127 = (-(_e2076) - 1f);
let _e2129 = select(_e2127, _e2125, (_e2125 > _e2127));
let _e2131 = select(0f, _e2129, (_e2129 < 0f));
let _e2138 = select(0i, select(select(i32(_e2131), i32(-2147483648), (_e2131 < -2147483600f)), 2147483647i, (_e2131 > 2147483500f)), (_e2131 == _e2131));
let _e2145 = select(-1f, _e2124, (_e2124 > -1f));
let _e2147 = select(_e2076, _e2145, (_e2145 < _e2076));
let _e2154 = select(0i, select(select(i32(_e2147), i32(-2147483648), (_e2147 < -2147483600f)), 2147483647i, (_e2147 > 2147483500f)), (_e2147 == _e2147));
phi_26136_ = -((_e2138 - select(0i, 1i, (_e2131 < f32(_e2138)))));
loop {
let _e2160 = phi_26136_;
let _e2161 = (_e2160 <= (_e2154 - select(0i, 1i, (_e2147 < f32(_e2154)))));
if _e2161 {
let _e2162 = select(_e2160, _e2070, _e1152);
let _e2163 = select(_e2070, _e2160, _e1152);
let _e2164 = f32(_e2163);
let _e2165 = f32(_e2162);
let _e2167 = f32(_e926.member_1.member_4.x);
let _e2170 = ((_e1070 * _e2164) + (_e1073 * _e2165));
let _e2171 = (_e2170 + ((((select(_e1117, _e1115, (_e1115 > _e1117)) + select(_e1122, _e1120, (_e1120 > _e1122))) + select(_e1128, _e1126, (_e1126 > _e1128))) - _e1113) + _e1108));
let _e2173 = -((_e2171 * _e1636));
let _e2177 = select(0f, select(_e2173, 0f, (0f > _e2173)), (_e1067 > 0f));
let _e2184 = select(select(_e2167, select(_e2173, _e2167, (_e2167 < _e2173)), (_e1067 < 0f)), -1f, (_e1634 && (_e2171 < 0f)));
let _e2186 = (((((select(_e1135, _e1133, (_e1133 > _e1135)) + select(_e1141, _e1139, (_e1139 > _e1141))) + select(_e1148, _e1146, (_e1146 > _e1148))) + _e1113) + _e1108) - _e2170);
let _e2188 = -((_e2186 * -(_e1636)));
let _e2192 = select(_e2177, select(_e2188, _e2177, (_e2177 > _e2188)), (_e1132 > 0f));
let _e2200 = select(select(_e2184, select(_e2188, _e2184, (_e2184 < _e2188)), (_e1132 < 0f)), -1f, ((_e1132 == 0f) && (_e2186 < 0f)));
let _e2204 = ((_e1658 * _e2164) + (((select(_e1669, _e1661, ((_e1680 & 1u) != 0u)) - (_e1653 * _e984)) + (select(_e1712, _e1706, ((_e1721 & 1u) != 0u)) - (_e1658 * _e995))) + _e1648));
let _e2205 = ((_e1659 * _e2164) + (((select(_e1670, _e1662, ((_e1684 & 1u) != 0u)) - (_e1654 * _e1014)) + (select(_e1713, _e1707, ((_e1725 & 1u) != 0u)) - (_e1659 * _e1021))) + _e1648));
let _e2206 = ((_e1660 * _e2164) + (((select(_e1671, _e1663, ((_e1688 & 1u) != 0u)) - (_e1655 * _e1036)) + (select(_e1714, _e1708, ((_e1729 & 1u) != 0u)) - (_e1660 * _e1043))) + _e1648));
let _e2207 = (_e2204 * select(0f, _e1778, ((_e1788 & 1u) != 0u)));
let _e2208 = (_e2205 * select(0f, _e1779, ((_e1792 & 1u) != 0u)));
let _e2209 = (_e2206 * select(0f, _e1780, ((_e1796 & 1u) != 0u)));
let _e2213 = ((_e2204 * select(select(0f, 1e20f, _e1770), _e1778, _e1830)) + select(_e1098, 0f, _e1830));
let _e2214 = ((_e2205 * select(select(0f, 1e20f, _e1773), _e1779, _e1833)) + select(_e1098, 0f, _e1833));
let _e2215 = ((_e2206 * select(select(0f, 1e20f, _e1776), _e1780, _e1836)) + select(_e1098, 0f, _e1836));
let _e2217 = select(_e2207, _e2192, (_e2192 > _e2207));
let _e2219 = select(_e2209, _e2208, (_e2208 > _e2209));
let _e2221 = select(_e2219, _e2217, (_e2217 > _e2219));
let _e2223 = select(_e2213, _e2200, (_e2200 < _e2213));
let _e2225 = select(_e2215, _e2214, (_e2214 < _e2215));
let _e2227 = select(_e2225, _e2223, (_e2223 < _e2225));
let _e2231 = ((_e1856 * _e2165) + (((select(_e1867, _e1859, ((_e1878 & 1u) != 0u)) - (_e1852 * _e984)) + (select(_e1910, _e1904, ((_e1919 & 1u) != 0u)) - (_e1856 * _e1006))) + _e1848));
let _e2232 = ((_e1857 * _e2165) + (((select(_e1868, _e1860, ((_e1882 & 1u) != 0u)) - (_e1853 * _e1014)) + (select(_e1911, _e1905, ((_e1923 & 1u) != 0u)) - (_e1857 * _e1028))) + _e1848));
let _e2233 = ((_e1858 * _e2165) + (((select(_e1869, _e1861, ((_e1886 & 1u) != 0u)) - (_e1854 * _e1036)) + (select(_e1912, _e1906, ((_e1927 & 1u) != 0u)) - (_e1858 * _e1050))) + _e1848));
let _e2234 = (_e2231 * select(0f, _e1976, ((_e1986 & 1u) != 0u)));
let _e2235 = (_e2232 * select(0f, _e1977, ((_e1990 & 1u) != 0u)));
let _e2236 = (_e2233 * select(0f, _e1978, ((_e1994 & 1u) != 0u)));
let _e2240 = ((_e2231 * select(select(0f, 1e20f, _e1968), _e1976, _e2028)) + select(_e1098, 0f, _e2028));
let _e2241 = ((_e2232 * select(select(0f, 1e20f, _e1971), _e1977, _e2031)) + select(_e1098, 0f, _e2031));
let _e2242 = ((_e2233 * select(select(0f, 1e20f, _e1974), _e1978, _e2034)) + select(_e1098, 0f, _e2034));
let _e2244 = select(_e2234, _e2221, (_e2221 > _e2234));
let _e2246 = select(_e2236, _e2235, (_e2235 > _e2236));
let _e2250 = select(_e2240, _e2227, (_e2227 < _e2240));
let _e2252 = select(_e2242, _e2241, (_e2241 < _e2242));
let _e2254 = select(_e2252, _e2250, (_e2250 < _e2252));
let _e2255 = -(select(_e2246, _e2244, (_e2244 > _e2246)));
let _e2257 = (-(_e2167) - 1f);
let _e2259 = select(_e2257, _e2255, (_e2255 > _e2257));
let _e2261 = select(0f, _e2259, (_e2259 < 0f));
let _e2268 = select(0i, select(select(i32(_e2261), i32(-2147483648), (_e2261 < -2147483600f)), 2147483647i, (_e2261 > 2147483500f)), (_e2261 == _e2261));
let _e2275 = select(-1f, _e2254, (_e2254 > -1f));
let _e2277 = select(_e2167, _e2275, (_e2275 < _e2167));
let _e2284 = select(0i, select(select(i32(_e2277), i32(-2147483648), (_e2277 < -2147483600f)), 2147483647i, (_e2277 > 2147483500f)), (_e2277 == _e2277));
let _e2293 = global_1.member.member_2.member_1;
let _e2300 = global_1.member.member_3;
phi_26374_ = -((_e2268 - select(0i, 1i, (_e2261 < f32(_e2268)))));
loop {
let _e2304 = phi_26374_;
let _e2305 = (_e2304 <= (_e2284 - select(0i, 1i, (_e2277 < f32(_e2284)))));
if _e2305 {
let _e2310 = ((f32(_e2304) + 0.5f) - _e984);
let _e2311 = ((_e2164 + 0.5f) - _e995);
let _e2312 = ((_e2165 + 0.5f) - _e1006);
let _e2317 = (((_e1059 * _e1059) + (_e1060 * _e1060)) + (_e1061 * _e1061));
let _e2322 = (((_e1059 * _e2039) + (_e1060 * _e1651)) + (_e1061 * _e1851));
let _e2327 = (((_e2039 * _e2039) + (_e1651 * _e1651)) + (_e1851 * _e1851));
let _e2332 = (((_e2310 * _e1059) + (_e2311 * _e1060)) + (_e2312 * _e1061));
let _e2337 = (((_e2310 * _e2039) + (_e2311 * _e1651)) + (_e2312 * _e1851));
let _e2340 = ((_e2317 * _e2327) - (_e2322 * _e2322));
let _e2341 = (_e2340 > 0f);
let _e2344 = select(0f, (1f / select(1f, _e2340, _e2341)), _e2341);
let _e2348 = (((_e2327 * _e2332) - (_e2322 * _e2337)) * _e2344);
let _e2352 = (((_e2317 * _e2337) - (_e2322 * _e2332)) * _e2344);
let _e2354 = ((1f - _e2348) - _e2352);
let _e2356 = select(0f, _e2354, (_e2354 > 0f));
let _e2358 = select(16777216f, _e2356, (_e2356 < 16777216f));
let _e2360 = select(0f, _e2348, (_e2348 > 0f));
let _e2362 = select(16777216f, _e2360, (_e2360 < 16777216f));
let _e2364 = select(0f, _e2352, (_e2352 > 0f));
let _e2366 = select(16777216f, _e2364, (_e2364 < 16777216f));
let _e2368 = ((_e2358 + _e2362) + _e2366);
let _e2371 = (1f / select(0.5f, _e2368, (_e2368 > 0.5f)));
let _e2372 = (_e2358 * _e2371);
let _e2373 = (_e2362 * _e2371);
let _e2374 = (_e2366 * _e2371);
let _e2376 = select(_e2044, _e2041, (_e2041 < _e2044));
let _e2382 = global_4.member[bitcast<u32>(select(0i, _e2376, (_e2376 > 0i)))];
let _e2383 = (_e2041 + 1i);
let _e2385 = select(_e2044, _e2383, (_e2383 < _e2044));
let _e2391 = global_4.member[bitcast<u32>(select(0i, _e2385, (_e2385 > 0i)))];
let _e2392 = (_e2041 + 2i);
let _e2394 = select(_e2044, _e2392, (_e2392 < _e2044));
let _e2400 = global_4.member[bitcast<u32>(select(0i, _e2394, (_e2394 > 0i)))];
let _e2401 = (_e2041 + 3i);
let _e2403 = select(_e2044, _e2401, (_e2401 < _e2044));
let _e2409 = global_4.member[bitcast<u32>(select(0i, _e2403, (_e2403 > 0i)))];
let _e2410 = (_e2041 + 4i);
let _e2412 = select(_e2044, _e2410, (_e2410 < _e2044));
let _e2418 = global_4.member[bitcast<u32>(select(0i, _e2412, (_e2412 > 0i)))];
let _e2419 = (_e2041 + 5i);
let _e2421 = select(_e2044, _e2419, (_e2419 < _e2044));
let _e2427 = global_4.member[bitcast<u32>(select(0i, _e2421, (_e2421 > 0i)))];
let _e2428 = (_e2041 + 6i);
let _e2430 = select(_e2044, _e2428, (_e2428 < _e2044));
let _e2436 = global_4.member[bitcast<u32>(select(0i, _e2430, (_e2430 > 0i)))];
let _e2437 = (_e2041 + 7i);
let _e2439 = select(_e2044, _e2437, (_e2437 < _e2044));
let _e2445 = global_4.member[bitcast<u32>(select(0i, _e2439, (_e2439 > 0i)))];
let _e2446 = (_e2041 + 8i);
let _e2448 = select(_e2044, _e2446, (_e2446 < _e2044));
let _e2454 = global_4.member[bitcast<u32>(select(0i, _e2448, (_e2448 > 0i)))];
let _e2459 = (((_e2382 * _e2372) + (_e2409 * _e2373)) + (_e2436 * _e2374));
let _e2464 = (((_e2391 * _e2372) + (_e2418 * _e2373)) + (_e2445 * _e2374));
let _e2469 = (((_e2400 * _e2372) + (_e2427 * _e2373)) + (_e2454 * _e2374));
let _e2474 = (((_e2459 * _e2459) + (_e2464 * _e2464)) + (_e2469 * _e2469));
let _e2477 = sqrt(select(0f, _e2474, (_e2474 > 0f)));
let _e2478 = (_e2477 > 1e-6f);
let _e2481 = select(0f, (1f / select(1e-6f, _e2477, _e2478)), _e2478);
let _e2482 = (_e2041 + 9i);
let _e2484 = select(_e2044, _e2482, (_e2482 < _e2044));
let _e2490 = global_4.member[bitcast<u32>(select(0i, _e2484, (_e2484 > 0i)))];
let _e2491 = (_e2041 + 10i);
let _e2493 = select(_e2044, _e2491, (_e2491 < _e2044));
let _e2499 = global_4.member[bitcast<u32>(select(0i, _e2493, (_e2493 > 0i)))];
let _e2500 = (_e2041 + 11i);
let _e2502 = select(_e2044, _e2500, (_e2500 < _e2044));
let _e2508 = global_4.member[bitcast<u32>(select(0i, _e2502, (_e2502 > 0i)))];
let _e2509 = (_e2041 + 12i);
let _e2511 = select(_e2044, _e2509, (_e2509 < _e2044));
let _e2517 = global_4.member[bitcast<u32>(select(0i, _e2511, (_e2511 > 0i)))];
let _e2518 = (_e2041 + 13i);
let _e2520 = select(_e2044, _e2518, (_e2518 < _e2044));
let _e2526 = global_4.member[bitcast<u32>(select(0i, _e2520, (_e2520 > 0i)))];
let _e2527 = (_e2041 + 14i);
let _e2529 = select(_e2044, _e2527, (_e2527 < _e2044));
let _e2535 = global_4.member[bitcast<u32>(select(0i, _e2529, (_e2529 > 0i)))];
let _e2536 = (_e2041 + 15i);
let _e2538 = select(_e2044, _e2536, (_e2536 < _e2044));
let _e2544 = global_4.member[bitcast<u32>(select(0i, _e2538, (_e2538 > 0i)))];
let _e2545 = (_e2041 + 16i);
let _e2547 = select(_e2044, _e2545, (_e2545 < _e2044));
let _e2553 = global_4.member[bitcast<u32>(select(0i, _e2547, (_e2547 > 0i)))];
let _e2554 = (_e2041 + 17i);
let _e2556 = select(_e2044, _e2554, (_e2554 < _e2044));
let _e2562 = global_4.member[bitcast<u32>(select(0i, _e2556, (_e2556 > 0i)))];
let _e2578 = (_e926.member_1.member_3.x + _e2304);
let _e2581 = ((((((_e926.member_1.member_3.z + _e2162) * bitcast<i32>(_e2293)) + _e926.member_1.member_3.y) + _e2163) * bitcast<i32>(_e2300)) + (_e2578 >> bitcast<u32>(5i)));
let _e2585 = (bitcast<i32>(_e218) - 1i);
let _e2587 = select(_e2585, _e2581, (_e2581 < _e2585));
let _e2593 = global_6.member[bitcast<u32>(select(0i, _e2587, (_e2587 > 0i)))];
let _e2595 = (bitcast<i32>(_e216) - 1i);
let _e2597 = select(_e2595, _e2581, (_e2581 < _e2595));
let _e2603 = global_5.member[bitcast<u32>(select(0i, _e2597, (_e2597 > 0i)))];
let _e2612 = (bitcast<i32>((_e2593 + countOneBits((_e2603 & ((1u << bitcast<u32>((bitcast<u32>((_e2578 & 31i)) & 31u))) - 1u))))) * 14i);
let _e2613 = bitcast<u32>(_e2612);
if (_e2613 < _e220) {
let _e2617 = atomicAdd((&global_7.member[_e2613]), 1u);
}
let _e2619 = bitcast<u32>((_e2612 + 1i));
if (_e2619 < _e220) {
let _e2623 = atomicMax((&global_7.member[_e2619]), bitcast<u32>((_e2063 - select(0i, 1i, (_e2056 < f32(_e2063))))));
}
let _e2629 = (((_e2459 * _e2481) * 65536f) + 0.5f);
let _e2631 = select(-1073741800f, _e2629, (_e2629 > -1073741800f));
let _e2633 = select(1073741800f, _e2631, (_e2631 < 1073741800f));
let _e2640 = select(0i, select(select(i32(_e2633), i32(-2147483648), (_e2633 < -2147483600f)), 2147483647i, (_e2633 > 2147483500f)), (_e2633 == _e2633));
let _e2644 = (_e2640 - select(0i, 1i, (_e2633 < f32(_e2640))));
if (_e2644 == 0i) {
} else {
let _e2646 = bitcast<u32>(_e2644);
let _e2647 = bitcast<u32>((_e2612 + 2i));
if (_e2647 < _e220) {
let _e2651 = atomicAdd((&global_7.member[_e2647]), _e2646);
phi_26902_ = _e2651;
} else {
phi_26902_ = 0u;
}
let _e2653 = phi_26902_;
let _e2660 = (bitcast<u32>((_e2644 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e2653 + _e2646) < _e2646)));
if (_e2660 == 0u) {
} else {
let _e2662 = (_e2647 + 1u);
if (_e2662 < _e220) {
let _e2666 = atomicAdd((&global_7.member[_e2662]), _e2660);
}
}
}
let _e2669 = (((_e2464 * _e2481) * 65536f) + 0.5f);
let _e2671 = select(-1073741800f, _e2669, (_e2669 > -1073741800f));
let _e2673 = select(1073741800f, _e2671, (_e2671 < 1073741800f));
let _e2680 = select(0i, select(select(i32(_e2673), i32(-2147483648), (_e2673 < -2147483600f)), 2147483647i, (_e2673 > 2147483500f)), (_e2673 == _e2673));
let _e2684 = (_e2680 - select(0i, 1i, (_e2673 < f32(_e2680))));
if (_e2684 == 0i) {
} else {
let _e2686 = bitcast<u32>(_e2684);
let _e2687 = bitcast<u32>((_e2612 + 4i));
if (_e2687 < _e220) {
let _e2691 = atomicAdd((&global_7.member[_e2687]), _e2686);
phi_26959_ = _e2691;
} else {
phi_26959_ = 0u;
}
let _e2693 = phi_26959_;
let _e2700 = (bitcast<u32>((_e2684 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e2693 + _e2686) < _e2686)));
if (_e2700 == 0u) {
} else {
let _e2702 = (_e2687 + 1u);
if (_e2702 < _e220) {
let _e2706 = atomicAdd((&global_7.member[_e2702]), _e2700);
}
}
}
let _e2709 = (((_e2469 * _e2481) * 65536f) + 0.5f);
let _e2711 = select(-1073741800f, _e2709, (_e2709 > -1073741800f));
let _e2713 = select(1073741800f, _e2711, (_e2711 < 1073741800f));
let _e2720 = select(0i, select(select(i32(_e2713), i32(-2147483648), (_e2713 < -2147483600f)), 2147483647i, (_e2713 > 2147483500f)), (_e2713 == _e2713));
let _e2724 = (_e2720 - select(0i, 1i, (_e2713 < f32(_e2720))));
if (_e2724 == 0i) {
} else {
let _e2726 = bitcast<u32>(_e2724);
let _e2727 = bitcast<u32>((_e2612 + 6i));
if (_e2727 < _e220) {
let _e2731 = atomicAdd((&global_7.member[_e2727]), _e2726);
phi_27016_ = _e2731;
} else {
phi_27016_ = 0u;
}
let _e2733 = phi_27016_;
let _e2740 = (bitcast<u32>((_e2724 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e2733 + _e2726) < _e2726)));
if (_e2740 == 0u) {
} else {
let _e2742 = (_e2727 + 1u);
if (_e2742 < _e220) {
let _e2746 = atomicAdd((&global_7.member[_e2742]), _e2740);
}
}
}
let _e2749 = (((((_e2490 * _e2372) + (_e2517 * _e2373)) + (_e2544 * _e2374)) * 65536f) + 0.5f);
let _e2751 = select(-1073741800f, _e2749, (_e2749 > -1073741800f));
let _e2753 = select(1073741800f, _e2751, (_e2751 < 1073741800f));
let _e2760 = select(0i, select(select(i32(_e2753), i32(-2147483648), (_e2753 < -2147483600f)), 2147483647i, (_e2753 > 2147483500f)), (_e2753 == _e2753));
let _e2764 = (_e2760 - select(0i, 1i, (_e2753 < f32(_e2760))));
if (_e2764 == 0i) {
} else {
let _e2766 = bitcast<u32>(_e2764);
let _e2767 = bitcast<u32>((_e2612 + 8i));
if (_e2767 < _e220) {
let _e2771 = atomicAdd((&global_7.member[_e2767]), _e2766);
phi_27074_ = _e2771;
} else {
phi_27074_ = 0u;
}
let _e2773 = phi_27074_;
let _e2780 = (bitcast<u32>((_e2764 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e2773 + _e2766) < _e2766)));
if (_e2780 == 0u) {
} else {
let _e2782 = (_e2767 + 1u);
if (_e2782 < _e220) {
let _e2786 = atomicAdd((&global_7.member[_e2782]), _e2780);
}
}
}
let _e2789 = (((((_e2499 * _e2372) + (_e2526 * _e2373)) + (_e2553 * _e2374)) * 65536f) + 0.5f);
let _e2791 = select(-1073741800f, _e2789, (_e2789 > -1073741800f));
let _e2793 = select(1073741800f, _e2791, (_e2791 < 1073741800f));
let _e2800 = select(0i, select(select(i32(_e2793), i32(-2147483648), (_e2793 < -2147483600f)), 2147483647i, (_e2793 > 2147483500f)), (_e2793 == _e2793));
let _e2804 = (_e2800 - select(0i, 1i, (_e2793 < f32(_e2800))));
if (_e2804 == 0i) {
} else {
let _e2806 = bitcast<u32>(_e2804);
let _e2807 = bitcast<u32>((_e2612 + 10i));
if (_e2807 < _e220) {
let _e2811 = atomicAdd((&global_7.member[_e2807]), _e2806);
phi_27131_ = _e2811;
} else {
phi_27131_ = 0u;
}
let _e2813 = phi_27131_;
let _e2820 = (bitcast<u32>((_e2804 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e2813 + _e2806) < _e2806)));
if (_e2820 == 0u) {
} else {
let _e2822 = (_e2807 + 1u);
if (_e2822 < _e220) {
let _e2826 = atomicAdd((&global_7.member[_e2822]), _e2820);
}
}
}
let _e2829 = (((((_e2508 * _e2372) + (_e2535 * _e2373)) + (_e2562 * _e2374)) * 65536f) + 0.5f);
let _e2831 = select(-1073741800f, _e2829, (_e2829 > -1073741800f));
let _e2833 = select(1073741800f, _e2831, (_e2831 < 1073741800f));
let _e2840 = select(0i, select(select(i32(_e2833), i32(-2147483648), (_e2833 < -2147483600f)), 2147483647i, (_e2833 > 2147483500f)), (_e2833 == _e2833));
let _e2844 = (_e2840 - select(0i, 1i, (_e2833 < f32(_e2840))));
if (_e2844 == 0i) {
} else {
let _e2846 = bitcast<u32>(_e2844);
let _e2847 = bitcast<u32>((_e2612 + 12i));
if (_e2847 < _e220) {
let _e2851 = atomicAdd((&global_7.member[_e2847]), _e2846);
phi_27188_ = _e2851;
} else {
phi_27188_ = 0u;
}
let _e2853 = phi_27188_;
let _e2860 = (bitcast<u32>((_e2844 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e2853 + _e2846) < _e2846)));
if (_e2860 == 0u) {
} else {
let _e2862 = (_e2847 + 1u);
if (_e2862 < _e220) {
let _e2866 = atomicAdd((&global_7.member[_e2862]), _e2860);
}
}
}
phi_26375_ = (_e2304 + 1i);
} else {
phi_26375_ = i32();
}
let _e2869 = phi_26375_;
continue;
continuing {
phi_26374_ = _e2869;
break if !(_e2305);
}
}
phi_26137_ = (_e2160 + 1i);
} else {
phi_26137_ = i32();
}
let _e2873 = phi_26137_;
continue;
continuing {
phi_26136_ = _e2873;
break if !(_e2161);
}
}
phi_26002_ = (_e2070 + 1i);
} else {
phi_26002_ = i32();
}
let _e2877 = phi_26002_;
continue;
continuing {
phi_26001_ = _e2877;
break if !(_e2071);
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
