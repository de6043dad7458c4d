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
var phi_26905_: u32;
var phi_26962_: u32;
var phi_27019_: u32;
var phi_27077_: u32;
var phi_27134_: u32;
var phi_27191_: u32;
var phi_26375_: i32;
var phi_26137_: i32;
var phi_26002_: i32;
var phi_21027_: i32;
var phi_21042_: i32;
var phi_21044_: i32;
var phi_21171_: i32;
var phi_21702_: u32;
var phi_21759_: u32;
var phi_21816_: u32;
var phi_21874_: u32;
var phi_21931_: u32;
var phi_21988_: u32;
var phi_21172_: i32;
var phi_21045_: i32;
var phi_21028_: i32;
var phi_16049_: i32;
var phi_16064_: i32;
var phi_16066_: i32;
var phi_16193_: i32;
var phi_16724_: u32;
var phi_16781_: u32;
var phi_16838_: u32;
var phi_16896_: u32;
var phi_16953_: u32;
var phi_17010_: u32;
var phi_16194_: i32;
var phi_16067_: i32;
var phi_16050_: i32;
var phi_9093_: type_18;
var phi_11050_: i32;
var phi_11065_: i32;
var phi_11185_: i32;
var phi_11215_: i32;
var phi_11746_: u32;
var phi_11803_: u32;
var phi_11860_: u32;
var phi_11918_: u32;
var phi_11975_: u32;
var phi_12032_: u32;
var phi_11216_: i32;
var phi_11186_: i32;
var phi_11051_: i32;
var phi_6169_: i32;
var phi_6184_: i32;
var phi_6186_: i32;
var phi_6216_: i32;
var phi_6747_: u32;
var phi_6804_: u32;
var phi_6861_: u32;
var phi_6919_: u32;
var phi_6976_: u32;
var phi_7033_: u32;
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
let _e7024 = (_e926.member_1.member_6 & 31u);
let _e7026 = (_e926.member_1.member_3.x << bitcast<u32>(_e7024));
let _e7029 = (_e926.member_1.member_7 & 31u);
let _e7033 = ((1i << bitcast<u32>(_e7029)) >> bitcast<u32>(1i));
let _e7039 = bitcast<i32>(_e926.member_1.member_6);
let _e7045 = bitcast<f32>((bitcast<u32>((127i + (bitcast<i32>(_e926.member_1.member_7) - _e7039))) << bitcast<u32>(23i)));
let _e7046 = (f32((((_e926.member_1.member.x - _e7026) + _e7033) >> bitcast<u32>(_e7029))) * _e7045);
let _e7051 = (_e926.member_1.member_3.y << bitcast<u32>(_e7024));
let _e7057 = (f32((((_e926.member_1.member.y - _e7051) + _e7033) >> bitcast<u32>(_e7029))) * _e7045);
let _e7062 = (_e926.member_1.member_3.z << bitcast<u32>(_e7024));
let _e7068 = (f32((((_e926.member_1.member.z - _e7062) + _e7033) >> bitcast<u32>(_e7029))) * _e7045);
let _e7076 = (f32((((_e926.member_1.member_1.x - _e7026) + _e7033) >> bitcast<u32>(_e7029))) * _e7045);
let _e7083 = (f32((((_e926.member_1.member_1.y - _e7051) + _e7033) >> bitcast<u32>(_e7029))) * _e7045);
let _e7090 = (f32((((_e926.member_1.member_1.z - _e7062) + _e7033) >> bitcast<u32>(_e7029))) * _e7045);
let _e7098 = (f32((((_e926.member_1.member_2.x - _e7026) + _e7033) >> bitcast<u32>(_e7029))) * _e7045);
let _e7105 = (f32((((_e926.member_1.member_2.y - _e7051) + _e7033) >> bitcast<u32>(_e7029))) * _e7045);
let _e7112 = (f32((((_e926.member_1.member_2.z - _e7062) + _e7033) >> bitcast<u32>(_e7029))) * _e7045);
let _e7120 = (f32(_e926.member_1.member_5) * bitcast<f32>((bitcast<u32>((127i - _e7039)) << bitcast<u32>(23i))));
let _e7121 = (_e7076 - _e7046);
let _e7122 = (_e7083 - _e7057);
let _e7123 = (_e7090 - _e7068);
let _e7124 = (_e7098 - _e7076);
let _e7125 = (_e7105 - _e7083);
let _e7126 = (_e7112 - _e7090);
let _e7129 = ((_e7122 * _e7126) - (_e7123 * _e7125));
let _e7136 = (1f + _e7120);
let _e7139 = (_e926.member_1.member_4.z >= _e926.member_1.member_4.y);
if _e7139 {
let _e7233 = select(1f, -1f, (_e7129 < 0f));
let _e7238 = ((_e7068 - _e7090) * _e7233);
let _e7239 = ((_e7090 - _e7112) * _e7233);
let _e7240 = ((_e7112 - _e7068) * _e7233);
let _e7241 = ((0f - 0f) * _e7233);
let _e7243 = (_e7122 * _e7233);
let _e7244 = (_e7125 * _e7233);
let _e7245 = ((_e7057 - _e7105) * _e7233);
if (select(0u, 1u, ((_e7238 * _e7136) > -((_e7238 * _e7120)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e7239 * _e7136) > -((_e7239 * _e7120)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e7240 * _e7136) > -((_e7240 * _e7120)))) < 2u) {
} else {
break;
}
let _e7269 = (select(0u, 1u, ((_e7241 * _e7136) > -((_e7241 * _e7120)))) < 2u);
if _e7269 {
} else {
break;
}
if (select(0u, 1u, ((_e7243 * _e7136) > -((_e7243 * _e7120)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e7244 * _e7136) > -((_e7244 * _e7120)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e7245 * _e7136) > -((_e7245 * _e7120)))) < 2u) {
} else {
break;
}
if _e7269 {
} else {
break;
}
if (select(0u, 1u, (_e7238 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7239 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7240 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7241 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7238 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7239 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7240 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7241 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7238 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7239 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7240 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7241 < 0f)) < 2u) {
} else {
break;
}
} else {
let _e7141 = select(1f, -1f, (-(_e7129) < 0f));
let _e7146 = ((_e7057 - _e7083) * _e7141);
let _e7147 = ((_e7083 - _e7105) * _e7141);
let _e7148 = ((_e7105 - _e7057) * _e7141);
let _e7149 = ((0f - 0f) * _e7141);
let _e7151 = (_e7123 * _e7141);
let _e7152 = (_e7126 * _e7141);
let _e7153 = ((_e7068 - _e7112) * _e7141);
if (select(0u, 1u, ((_e7146 * _e7136) > -((_e7146 * _e7120)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e7147 * _e7136) > -((_e7147 * _e7120)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e7148 * _e7136) > -((_e7148 * _e7120)))) < 2u) {
} else {
break;
}
let _e7177 = (select(0u, 1u, ((_e7149 * _e7136) > -((_e7149 * _e7120)))) < 2u);
if _e7177 {
} else {
break;
}
if (select(0u, 1u, ((_e7151 * _e7136) > -((_e7151 * _e7120)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e7152 * _e7136) > -((_e7152 * _e7120)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e7153 * _e7136) > -((_e7153 * _e7120)))) < 2u) {
} else {
break;
}
if _e7177 {
} else {
break;
}
if (select(0u, 1u, (_e7146 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7147 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7148 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7149 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7146 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7147 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7148 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7149 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7146 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7147 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7148 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7149 < 0f)) < 2u) {
} else {
break;
}
}
let _e7326 = select(1f, -1f, (((_e7121 * _e7125) - (_e7122 * _e7124)) < 0f));
let _e7329 = (_e7105 - _e7057);
let _e7330 = (0f - 0f);
let _e7331 = ((_e7057 - _e7083) * _e7326);
let _e7332 = ((_e7083 - _e7105) * _e7326);
let _e7333 = (_e7329 * _e7326);
let _e7334 = (_e7330 * _e7326);
let _e7335 = (_e7046 - _e7098);
let _e7336 = (_e7121 * _e7326);
let _e7337 = (_e7124 * _e7326);
let _e7338 = (_e7335 * _e7326);
if (select(0u, 1u, ((_e7331 * _e7136) > -((_e7331 * _e7120)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e7332 * _e7136) > -((_e7332 * _e7120)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e7333 * _e7136) > -((_e7333 * _e7120)))) < 2u) {
} else {
break;
}
let _e7362 = (select(0u, 1u, ((_e7334 * _e7136) > -((_e7334 * _e7120)))) < 2u);
if _e7362 {
} else {
break;
}
if (select(0u, 1u, ((_e7336 * _e7136) > -((_e7336 * _e7120)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e7337 * _e7136) > -((_e7337 * _e7120)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e7338 * _e7136) > -((_e7338 * _e7120)))) < 2u) {
} else {
break;
}
if _e7362 {
} else {
break;
}
if (select(0u, 1u, (_e7331 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7332 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7333 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7334 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7331 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7332 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7333 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7334 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7331 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7332 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7333 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7334 < 0f)) < 2u) {
} else {
break;
}
let _e7418 = select(1f, -1f, (-(((_e7123 * _e7124) - (_e7121 * _e7126))) < 0f));
let _e7421 = (_e7112 - _e7068);
let _e7422 = ((_e7068 - _e7090) * _e7418);
let _e7423 = ((_e7090 - _e7112) * _e7418);
let _e7424 = (_e7421 * _e7418);
let _e7425 = (_e7330 * _e7418);
let _e7426 = (_e7121 * _e7418);
let _e7427 = (_e7124 * _e7418);
let _e7428 = (_e7335 * _e7418);
if (select(0u, 1u, ((_e7422 * _e7136) > -((_e7422 * _e7120)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e7423 * _e7136) > -((_e7423 * _e7120)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e7424 * _e7136) > -((_e7424 * _e7120)))) < 2u) {
} else {
break;
}
let _e7452 = (select(0u, 1u, ((_e7425 * _e7136) > -((_e7425 * _e7120)))) < 2u);
if _e7452 {
} else {
break;
}
if (select(0u, 1u, ((_e7426 * _e7136) > -((_e7426 * _e7120)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e7427 * _e7136) > -((_e7427 * _e7120)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e7428 * _e7136) > -((_e7428 * _e7120)))) < 2u) {
} else {
break;
}
if _e7452 {
} else {
break;
}
if (select(0u, 1u, (_e7422 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7423 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7424 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7425 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7422 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7423 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7424 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7425 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7422 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7423 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7424 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7425 < 0f)) < 2u) {
} else {
break;
}
let _e7507 = (_e7098 - _e7046);
let _e7509 = (_e926.member.member * 19i);
let _e7510 = (_e7509 + 18i);
let _e7512 = (bitcast<i32>(_e214) - 1i);
let _e7514 = select(_e7512, _e7510, (_e7510 < _e7512));
let _e7520 = global_4.member[bitcast<u32>(select(0i, _e7514, (_e7514 > 0i)))];
let _e7522 = select(0f, _e7520, (_e7520 > 0f));
let _e7524 = select(16777216f, _e7522, (_e7522 < 16777216f));
let _e7531 = select(0i, select(select(i32(_e7524), i32(-2147483648), (_e7524 < -2147483600f)), 2147483647i, (_e7524 > 2147483500f)), (_e7524 == _e7524));
phi_6169_ = _e926.member.member_1;
loop {
let _e7538 = phi_6169_;
let _e7539 = (_e7538 < _e926.member.member_2);
if _e7539 {
if _e7139 {
phi_6184_ = _e926.member_1.member_4.y;
} else {
phi_6184_ = _e926.member_1.member_4.z;
}
let _e7543 = phi_6184_;
phi_6186_ = 0i;
loop {
let _e7545 = phi_6186_;
let _e7546 = (_e7545 <= _e7543);
if _e7546 {
let _e7547 = select(_e7545, _e7538, _e7139);
let _e7548 = select(_e7538, _e7545, _e7139);
let _e7554 = global_1.member.member_2.member_1;
let _e7561 = global_1.member.member_3;
phi_6216_ = 0i;
loop {
let _e7565 = phi_6216_;
let _e7566 = (_e7565 <= _e926.member_1.member_4.x);
if _e7566 {
let _e7573 = ((f32(_e7565) + 0.5f) - _e7046);
let _e7574 = ((f32(_e7548) + 0.5f) - _e7057);
let _e7575 = ((f32(_e7547) + 0.5f) - _e7068);
let _e7580 = (((_e7121 * _e7121) + (_e7122 * _e7122)) + (_e7123 * _e7123));
let _e7585 = (((_e7121 * _e7507) + (_e7122 * _e7329)) + (_e7123 * _e7421));
let _e7590 = (((_e7507 * _e7507) + (_e7329 * _e7329)) + (_e7421 * _e7421));
let _e7595 = (((_e7573 * _e7121) + (_e7574 * _e7122)) + (_e7575 * _e7123));
let _e7600 = (((_e7573 * _e7507) + (_e7574 * _e7329)) + (_e7575 * _e7421));
let _e7603 = ((_e7580 * _e7590) - (_e7585 * _e7585));
let _e7604 = (_e7603 > 0f);
let _e7607 = select(0f, (1f / select(1f, _e7603, _e7604)), _e7604);
let _e7611 = (((_e7590 * _e7595) - (_e7585 * _e7600)) * _e7607);
let _e7615 = (((_e7580 * _e7600) - (_e7585 * _e7595)) * _e7607);
let _e7617 = ((1f - _e7611) - _e7615);
let _e7619 = select(0f, _e7617, (_e7617 > 0f));
let _e7621 = select(16777216f, _e7619, (_e7619 < 16777216f));
let _e7623 = select(0f, _e7611, (_e7611 > 0f));
let _e7625 = select(16777216f, _e7623, (_e7623 < 16777216f));
let _e7627 = select(0f, _e7615, (_e7615 > 0f));
let _e7629 = select(16777216f, _e7627, (_e7627 < 16777216f));
let _e7631 = ((_e7621 + _e7625) + _e7629);
let _e7634 = (1f / select(0.5f, _e7631, (_e7631 > 0.5f)));
let _e7635 = (_e7621 * _e7634);
let _e7636 = (_e7625 * _e7634);
let _e7637 = (_e7629 * _e7634);
let _e7639 = select(_e7512, _e7509, (_e7509 < _e7512));
let _e7645 = global_4.member[bitcast<u32>(select(0i, _e7639, (_e7639 > 0i)))];
let _e7646 = (_e7509 + 1i);
let _e7648 = select(_e7512, _e7646, (_e7646 < _e7512));
let _e7654 = global_4.member[bitcast<u32>(select(0i, _e7648, (_e7648 > 0i)))];
let _e7655 = (_e7509 + 2i);
let _e7657 = select(_e7512, _e7655, (_e7655 < _e7512));
let _e7663 = global_4.member[bitcast<u32>(select(0i, _e7657, (_e7657 > 0i)))];
let _e7664 = (_e7509 + 3i);
let _e7666 = select(_e7512, _e7664, (_e7664 < _e7512));
let _e7672 = global_4.member[bitcast<u32>(select(0i, _e7666, (_e7666 > 0i)))];
let _e7673 = (_e7509 + 4i);
let _e7675 = select(_e7512, _e7673, (_e7673 < _e7512));
let _e7681 = global_4.member[bitcast<u32>(select(0i, _e7675, (_e7675 > 0i)))];
let _e7682 = (_e7509 + 5i);
let _e7684 = select(_e7512, _e7682, (_e7682 < _e7512));
let _e7690 = global_4.member[bitcast<u32>(select(0i, _e7684, (_e7684 > 0i)))];
let _e7691 = (_e7509 + 6i);
let _e7693 = select(_e7512, _e7691, (_e7691 < _e7512));
let _e7699 = global_4.member[bitcast<u32>(select(0i, _e7693, (_e7693 > 0i)))];
let _e7700 = (_e7509 + 7i);
let _e7702 = select(_e7512, _e7700, (_e7700 < _e7512));
let _e7708 = global_4.member[bitcast<u32>(select(0i, _e7702, (_e7702 > 0i)))];
let _e7709 = (_e7509 + 8i);
let _e7711 = select(_e7512, _e7709, (_e7709 < _e7512));
let _e7717 = global_4.member[bitcast<u32>(select(0i, _e7711, (_e7711 > 0i)))];
let _e7722 = (((_e7645 * _e7635) + (_e7672 * _e7636)) + (_e7699 * _e7637));
let _e7727 = (((_e7654 * _e7635) + (_e7681 * _e7636)) + (_e7708 * _e7637));
let _e7732 = (((_e7663 * _e7635) + (_e7690 * _e7636)) + (_e7717 * _e7637));
let _e7737 = (((_e7722 * _e7722) + (_e7727 * _e7727)) + (_e7732 * _e7732));
let _e7740 = sqrt(select(0f, _e7737, (_e7737 > 0f)));
let _e7741 = (_e7740 > 1e-6f);
let _e7744 = select(0f, (1f / select(1e-6f, _e7740, _e7741)), _e7741);
let _e7745 = (_e7509 + 9i);
let _e7747 = select(_e7512, _e7745, (_e7745 < _e7512));
let _e7753 = global_4.member[bitcast<u32>(select(0i, _e7747, (_e7747 > 0i)))];
let _e7754 = (_e7509 + 10i);
let _e7756 = select(_e7512, _e7754, (_e7754 < _e7512));
let _e7762 = global_4.member[bitcast<u32>(select(0i, _e7756, (_e7756 > 0i)))];
let _e7763 = (_e7509 + 11i);
let _e7765 = select(_e7512, _e7763, (_e7763 < _e7512));
let _e7771 = global_4.member[bitcast<u32>(select(0i, _e7765, (_e7765 > 0i)))];
let _e7772 = (_e7509 + 12i);
let _e7774 = select(_e7512, _e7772, (_e7772 < _e7512));
let _e7780 = global_4.member[bitcast<u32>(select(0i, _e7774, (_e7774 > 0i)))];
let _e7781 = (_e7509 + 13i);
let _e7783 = select(_e7512, _e7781, (_e7781 < _e7512));
let _e7789 = global_4.member[bitcast<u32>(select(0i, _e7783, (_e7783 > 0i)))];
let _e7790 = (_e7509 + 14i);
let _e7792 = select(_e7512, _e7790, (_e7790 < _e7512));
let _e7798 = global_4.member[bitcast<u32>(select(0i, _e7792, (_e7792 > 0i)))];
let _e7799 = (_e7509 + 15i);
let _e7801 = select(_e7512, _e7799, (_e7799 < _e7512));
let _e7807 = global_4.member[bitcast<u32>(select(0i, _e7801, (_e7801 > 0i)))];
let _e7808 = (_e7509 + 16i);
let _e7810 = select(_e7512, _e7808, (_e7808 < _e7512));
let _e7816 = global_4.member[bitcast<u32>(select(0i, _e7810, (_e7810 > 0i)))];
let _e7817 = (_e7509 + 17i);
let _e7819 = select(_e7512, _e7817, (_e7817 < _e7512));
let _e7825 = global_4.member[bitcast<u32>(select(0i, _e7819, (_e7819 > 0i)))];
let _e7841 = (_e926.member_1.member_3.x + _e7565);
let _e7844 = ((((((_e926.member_1.member_3.z + _e7547) * bitcast<i32>(_e7554)) + _e926.member_1.member_3.y) + _e7548) * bitcast<i32>(_e7561)) + (_e7841 >> bitcast<u32>(5i)));
let _e7848 = (bitcast<i32>(_e218) - 1i);
let _e7850 = select(_e7848, _e7844, (_e7844 < _e7848));
let _e7856 = global_6.member[bitcast<u32>(select(0i, _e7850, (_e7850 > 0i)))];
let _e7858 = (bitcast<i32>(_e216) - 1i);
let _e7860 = select(_e7858, _e7844, (_e7844 < _e7858));
let _e7866 = global_5.member[bitcast<u32>(select(0i, _e7860, (_e7860 > 0i)))];
let _e7875 = (bitcast<i32>((_e7856 + countOneBits((_e7866 & ((1u << bitcast<u32>((bitcast<u32>((_e7841 & 31i)) & 31u))) - 1u))))) * 14i);
let _e7876 = bitcast<u32>(_e7875);
if (_e7876 < _e220) {
let _e7880 = atomicAdd((&global_7.member[_e7876]), 1u);
}
let _e7882 = bitcast<u32>((_e7875 + 1i));
if (_e7882 < _e220) {
let _e7886 = atomicMax((&global_7.member[_e7882]), bitcast<u32>((_e7531 - select(0i, 1i, (_e7524 < f32(_e7531))))));
}
let _e7892 = (((_e7722 * _e7744) * 65536f) + 0.5f);
let _e7894 = select(-1073741800f, _e7892, (_e7892 > -1073741800f));
let _e7896 = select(1073741800f, _e7894, (_e7894 < 1073741800f));
let _e7903 = select(0i, select(select(i32(_e7896), i32(-2147483648), (_e7896 < -2147483600f)), 2147483647i, (_e7896 > 2147483500f)), (_e7896 == _e7896));
let _e7907 = (_e7903 - select(0i, 1i, (_e7896 < f32(_e7903))));
let _e7908 = bitcast<u32>(_e7907);
let _e7911 = bitcast<u32>((_e7907 >> bitcast<u32>(31i)));
if ((_e7908 | _e7911) == 0u) {
} else {
let _e7914 = bitcast<u32>((_e7875 + 2i));
if (_e7914 < _e220) {
let _e7918 = atomicAdd((&global_7.member[_e7914]), _e7908);
phi_6747_ = _e7918;
} else {
phi_6747_ = 0u;
}
let _e7920 = phi_6747_;
let _e7924 = (_e7911 + select(0u, 1u, ((_e7920 + _e7908) < _e7908)));
if (_e7924 == 0u) {
} else {
let _e7926 = (_e7914 + 1u);
if (_e7926 < _e220) {
let _e7930 = atomicAdd((&global_7.member[_e7926]), _e7924);
}
}
}
let _e7933 = (((_e7727 * _e7744) * 65536f) + 0.5f);
let _e7935 = select(-1073741800f, _e7933, (_e7933 > -1073741800f));
let _e7937 = select(1073741800f, _e7935, (_e7935 < 1073741800f));
let _e7944 = select(0i, select(select(i32(_e7937), i32(-2147483648), (_e7937 < -2147483600f)), 2147483647i, (_e7937 > 2147483500f)), (_e7937 == _e7937));
let _e7948 = (_e7944 - select(0i, 1i, (_e7937 < f32(_e7944))));
let _e7949 = bitcast<u32>(_e7948);
let _e7952 = bitcast<u32>((_e7948 >> bitcast<u32>(31i)));
if ((_e7949 | _e7952) == 0u) {
} else {
let _e7955 = bitcast<u32>((_e7875 + 4i));
if (_e7955 < _e220) {
let _e7959 = atomicAdd((&global_7.member[_e7955]), _e7949);
phi_6804_ = _e7959;
} else {
phi_6804_ = 0u;
}
let _e7961 = phi_6804_;
let _e7965 = (_e7952 + select(0u, 1u, ((_e7961 + _e7949) < _e7949)));
if (_e7965 == 0u) {
} else {
let _e7967 = (_e7955 + 1u);
if (_e7967 < _e220) {
let _e7971 = atomicAdd((&global_7.member[_e7967]), _e7965);
}
}
}
let _e7974 = (((_e7732 * _e7744) * 65536f) + 0.5f);
let _e7976 = select(-1073741800f, _e7974, (_e7974 > -1073741800f));
let _e7978 = select(1073741800f, _e7976, (_e7976 < 1073741800f));
let _e7985 = select(0i, select(select(i32(_e7978), i32(-2147483648), (_e7978 < -2147483600f)), 2147483647i, (_e7978 > 2147483500f)), (_e7978 == _e7978));
let _e7989 = (_e7985 - select(0i, 1i, (_e7978 < f32(_e7985))));
let _e7990 = bitcast<u32>(_e7989);
let _e7993 = bitcast<u32>((_e7989 >> bitcast<u32>(31i)));
if ((_e7990 | _e7993) == 0u) {
} else {
let _e7996 = bitcast<u32>((_e7875 + 6i));
if (_e7996 < _e220) {
let _e8000 = atomicAdd((&global_7.member[_e7996]), _e7990);
phi_6861_ = _e8000;
} else {
phi_6861_ = 0u;
}
let _e8002 = phi_6861_;
let _e8006 = (_e7993 + select(0u, 1u, ((_e8002 + _e7990) < _e7990)));
if (_e8006 == 0u) {
} else {
let _e8008 = (_e7996 + 1u);
if (_e8008 < _e220) {
let _e8012 = atomicAdd((&global_7.member[_e8008]), _e8006);
}
}
}
let _e8015 = (((((_e7753 * _e7635) + (_e7780 * _e7636)) + (_e7807 * _e7637)) * 65536f) + 0.5f);
let _e8017 = select(-1073741800f, _e8015, (_e8015 > -1073741800f));
let _e8019 = select(1073741800f, _e8017, (_e8017 < 1073741800f));
let _e8026 = select(0i, select(select(i32(_e8019), i32(-2147483648), (_e8019 < -2147483600f)), 2147483647i, (_e8019 > 2147483500f)), (_e8019 == _e8019));
let _e8030 = (_e8026 - select(0i, 1i, (_e8019 < f32(_e8026))));
let _e8031 = bitcast<u32>(_e8030);
let _e8034 = bitcast<u32>((_e8030 >> bitcast<u32>(31i)));
if ((_e8031 | _e8034) == 0u) {
} else {
let _e8037 = bitcast<u32>((_e7875 + 8i));
if (_e8037 < _e220) {
let _e8041 = atomicAdd((&global_7.member[_e8037]), _e8031);
phi_6919_ = _e8041;
} else {
phi_6919_ = 0u;
}
let _e8043 = phi_6919_;
let _e8047 = (_e8034 + select(0u, 1u, ((_e8043 + _e8031) < _e8031)));
if (_e8047 == 0u) {
} else {
let _e8049 = (_e8037 + 1u);
if (_e8049 < _e220) {
let _e8053 = atomicAdd((&global_7.member[_e8049]), _e8047);
}
}
}
let _e8056 = (((((_e7762 * _e7635) + (_e7789 * _e7636)) + (_e7816 * _e7637)) * 65536f) + 0.5f);
let _e8058 = select(-1073741800f, _e8056, (_e8056 > -1073741800f));
let _e8060 = select(1073741800f, _e8058, (_e8058 < 1073741800f));
let _e8067 = select(0i, select(select(i32(_e8060), i32(-2147483648), (_e8060 < -2147483600f)), 2147483647i, (_e8060 > 2147483500f)), (_e8060 == _e8060));
let _e8071 = (_e8067 - select(0i, 1i, (_e8060 < f32(_e8067))));
let _e8072 = bitcast<u32>(_e8071);
let _e8075 = bitcast<u32>((_e8071 >> bitcast<u32>(31i)));
if ((_e8072 | _e8075) == 0u) {
} else {
let _e8078 = bitcast<u32>((_e7875 + 10i));
if (_e8078 < _e220) {
let _e8082 = atomicAdd((&global_7.member[_e8078]), _e8072);
phi_6976_ = _e8082;
} else {
phi_6976_ = 0u;
}
let _e8084 = phi_6976_;
let _e8088 = (_e8075 + select(0u, 1u, ((_e8084 + _e8072) < _e8072)));
if (_e8088 == 0u) {
} else {
let _e8090 = (_e8078 + 1u);
if (_e8090 < _e220) {
let _e8094 = atomicAdd((&global_7.member[_e8090]), _e8088);
}
}
}
let _e8097 = (((((_e7771 * _e7635) + (_e7798 * _e7636)) + (_e7825 * _e7637)) * 65536f) + 0.5f);
let _e8099 = select(-1073741800f, _e8097, (_e8097 > -1073741800f));
let _e8101 = select(1073741800f, _e8099, (_e8099 < 1073741800f));
let _e8108 = select(0i, select(select(i32(_e8101), i32(-2147483648), (_e8101 < -2147483600f)), 2147483647i, (_e8101 > 2147483500f)), (_e8101 == _e8101));
let _e8112 = (_e8108 - select(0i, 1i, (_e8101 < f32(_e8108))));
let _e8113 = bitcast<u32>(_e8112);
let _e8116 = bitcast<u32>((_e8112 >> bitcast<u32>(31i)));
if ((_e8113 | _e8116) == 0u) {
} else {
let _e8119 = bitcast<u32>((_e7875 + 12i));
if (_e8119 < _e220) {
let _e8123 = atomicAdd((&global_7.member[_e8119]), _e8113);
phi_7033_ = _e8123;
} else {
phi_7033_ = 0u;
}
let _e8125 = phi_7033_;
let _e8129 = (_e8116 + select(0u, 1u, ((_e8125 + _e8113) < _e8113)));
if (_e8129 == 0u) {
} else {
let _e8131 = (_e8119 + 1u);
if (_e8131 < _e220) {
let _e8135 = atomicAdd((&global_7.member[_e8131]), _e8129);
}
}
}
phi_6217_ = (_e7565 + 1i);
} else {
phi_6217_ = i32();
}
let _e8138 = phi_6217_;
continue;
continuing {
phi_6216_ = _e8138;
break if !(_e7566);
}
}
phi_6187_ = (_e7545 + 1i);
} else {
phi_6187_ = i32();
}
let _e8142 = phi_6187_;
continue;
continuing {
phi_6186_ = _e8142;
break if !(_e7546);
}
}
phi_6170_ = (_e7538 + 1i);
} else {
phi_6170_ = i32();
}
let _e8146 = phi_6170_;
continue;
continuing {
phi_6169_ = _e8146;
break if !(_e7539);
}
}
} else {
if (_e952 == 1u) {
let _e5506 = (_e926.member_1.member_6 & 31u);
let _e5508 = (_e926.member_1.member_3.x << bitcast<u32>(_e5506));
let _e5511 = (_e926.member_1.member_7 & 31u);
let _e5515 = ((1i << bitcast<u32>(_e5511)) >> bitcast<u32>(1i));
let _e5521 = bitcast<i32>(_e926.member_1.member_6);
let _e5527 = bitcast<f32>((bitcast<u32>((127i + (bitcast<i32>(_e926.member_1.member_7) - _e5521))) << bitcast<u32>(23i)));
let _e5528 = (f32((((_e926.member_1.member.x - _e5508) + _e5515) >> bitcast<u32>(_e5511))) * _e5527);
let _e5533 = (_e926.member_1.member_3.y << bitcast<u32>(_e5506));
let _e5539 = (f32((((_e926.member_1.member.y - _e5533) + _e5515) >> bitcast<u32>(_e5511))) * _e5527);
let _e5544 = (_e926.member_1.member_3.z << bitcast<u32>(_e5506));
let _e5550 = (f32((((_e926.member_1.member.z - _e5544) + _e5515) >> bitcast<u32>(_e5511))) * _e5527);
let _e5558 = (f32((((_e926.member_1.member_1.x - _e5508) + _e5515) >> bitcast<u32>(_e5511))) * _e5527);
let _e5565 = (f32((((_e926.member_1.member_1.y - _e5533) + _e5515) >> bitcast<u32>(_e5511))) * _e5527);
let _e5572 = (f32((((_e926.member_1.member_1.z - _e5544) + _e5515) >> bitcast<u32>(_e5511))) * _e5527);
let _e5580 = (f32((((_e926.member_1.member_2.x - _e5508) + _e5515) >> bitcast<u32>(_e5511))) * _e5527);
let _e5587 = (f32((((_e926.member_1.member_2.y - _e5533) + _e5515) >> bitcast<u32>(_e5511))) * _e5527);
let _e5594 = (f32((((_e926.member_1.member_2.z - _e5544) + _e5515) >> bitcast<u32>(_e5511))) * _e5527);
let _e5602 = (f32(_e926.member_1.member_5) * bitcast<f32>((bitcast<u32>((127i - _e5521)) << bitcast<u32>(23i))));
let _e5603 = (_e5558 - _e5528);
let _e5604 = (_e5565 - _e5539);
let _e5605 = (_e5572 - _e5550);
let _e5606 = (_e5580 - _e5558);
let _e5607 = (_e5587 - _e5565);
let _e5608 = (_e5594 - _e5572);
let _e5609 = (_e5604 * _e5608);
let _e5610 = (_e5605 * _e5607);
let _e5611 = (_e5609 - _e5610);
let _e5625 = ((bitcast<f32>((bitcast<u32>(_e5609) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e5610) & 2147483647u))) * 2.3841858e-7f);
let _e5626 = f32(_e926.member_1.member_4.y);
let _e5627 = f32(_e926.member_1.member_4.z);
let _e5628 = (1f + _e5602);
let _e5629 = -(_e5611);
let _e5631 = (_e926.member_1.member_4.z >= _e926.member_1.member_4.y);
if _e5631 {
let _e5872 = select(1f, -1f, (_e5611 < 0f));
let _e5878 = select(0f, (2f * _e5625), (bitcast<f32>((bitcast<u32>(_e5611) & 2147483647u)) <= _e5625));
let _e5883 = ((_e5550 - _e5572) * _e5872);
let _e5884 = ((_e5572 - _e5594) * _e5872);
let _e5885 = ((_e5594 - _e5550) * _e5872);
let _e5886 = ((0f - 0f) * _e5872);
let _e5888 = (_e5604 * _e5872);
let _e5889 = (_e5607 * _e5872);
let _e5890 = ((_e5539 - _e5587) * _e5872);
let _e5892 = (_e5883 * _e5628);
let _e5893 = (_e5884 * _e5628);
let _e5894 = (_e5885 * _e5628);
let _e5895 = (_e5886 * _e5628);
let _e5900 = -((_e5883 * _e5602));
let _e5901 = -((_e5884 * _e5602));
let _e5902 = -((_e5885 * _e5602));
let _e5903 = -((_e5886 * _e5602));
local_136 = array<u32, 2>(0u, 4294967295u);
let _e5908 = select(0u, 1u, (_e5892 > _e5900));
if (_e5908 < 2u) {
} else {
break;
}
let _e5911 = local_136[_e5908];
local_137 = array<u32, 2>(0u, 4294967295u);
let _e5912 = select(0u, 1u, (_e5893 > _e5901));
if (_e5912 < 2u) {
} else {
break;
}
let _e5915 = local_137[_e5912];
local_138 = array<u32, 2>(0u, 4294967295u);
let _e5916 = select(0u, 1u, (_e5894 > _e5902));
if (_e5916 < 2u) {
} else {
break;
}
let _e5919 = local_138[_e5916];
local_139 = array<u32, 2>(0u, 4294967295u);
let _e5920 = select(0u, 1u, (_e5895 > _e5903));
let _e5921 = (_e5920 < 2u);
if _e5921 {
} else {
break;
}
let _e5923 = local_139[_e5920];
let _e5939 = (_e5886 * 0f);
let _e5944 = (_e5888 * _e5628);
let _e5945 = (_e5889 * _e5628);
let _e5946 = (_e5890 * _e5628);
let _e5950 = -((_e5888 * _e5602));
let _e5951 = -((_e5889 * _e5602));
let _e5952 = -((_e5890 * _e5602));
local_132 = array<u32, 2>(0u, 4294967295u);
let _e5956 = select(0u, 1u, (_e5944 > _e5950));
if (_e5956 < 2u) {
} else {
break;
}
let _e5959 = local_132[_e5956];
local_133 = array<u32, 2>(0u, 4294967295u);
let _e5960 = select(0u, 1u, (_e5945 > _e5951));
if (_e5960 < 2u) {
} else {
break;
}
let _e5963 = local_133[_e5960];
local_134 = array<u32, 2>(0u, 4294967295u);
let _e5964 = select(0u, 1u, (_e5946 > _e5952));
if (_e5964 < 2u) {
} else {
break;
}
let _e5967 = local_134[_e5964];
local_135 = array<u32, 2>(0u, 4294967295u);
if _e5921 {
} else {
break;
}
let _e5969 = local_135[_e5920];
local_128 = array<u32, 2>(0u, 4294967295u);
let _e6002 = select(0u, 1u, (_e5883 == 0f));
if (_e6002 < 2u) {
} else {
break;
}
let _e6005 = local_128[_e6002];
local_129 = array<u32, 2>(0u, 4294967295u);
let _e6006 = select(0u, 1u, (_e5884 == 0f));
if (_e6006 < 2u) {
} else {
break;
}
let _e6009 = local_129[_e6006];
local_130 = array<u32, 2>(0u, 4294967295u);
let _e6010 = select(0u, 1u, (_e5885 == 0f));
if (_e6010 < 2u) {
} else {
break;
}
let _e6013 = local_130[_e6010];
local_131 = array<u32, 2>(0u, 4294967295u);
let _e6014 = select(0u, 1u, (_e5886 == 0f));
if (_e6014 < 2u) {
} else {
break;
}
let _e6017 = local_131[_e6014];
let _e6019 = ((_e6005 & 1u) != 0u);
let _e6022 = ((_e6009 & 1u) != 0u);
let _e6025 = ((_e6013 & 1u) != 0u);
let _e6028 = ((_e6017 & 1u) != 0u);
let _e6030 = (-1f / select(_e5883, 1f, _e6019));
let _e6031 = (-1f / select(_e5884, 1f, _e6022));
let _e6032 = (-1f / select(_e5885, 1f, _e6025));
let _e6033 = (-1f / select(_e5886, 1f, _e6028));
local_124 = array<u32, 2>(0u, 4294967295u);
let _e6038 = select(0u, 1u, (_e5883 > 0f));
if (_e6038 < 2u) {
} else {
break;
}
let _e6041 = local_124[_e6038];
local_125 = array<u32, 2>(0u, 4294967295u);
let _e6042 = select(0u, 1u, (_e5884 > 0f));
if (_e6042 < 2u) {
} else {
break;
}
let _e6045 = local_125[_e6042];
local_126 = array<u32, 2>(0u, 4294967295u);
let _e6046 = select(0u, 1u, (_e5885 > 0f));
if (_e6046 < 2u) {
} else {
break;
}
let _e6049 = local_126[_e6046];
local_127 = array<u32, 2>(0u, 4294967295u);
let _e6050 = select(0u, 1u, (_e5886 > 0f));
if (_e6050 < 2u) {
} else {
break;
}
let _e6053 = local_127[_e6050];
local_120 = array<u32, 2>(0u, 4294967295u);
let _e6058 = select(0u, 1u, (_e5883 < 0f));
if (_e6058 < 2u) {
} else {
break;
}
let _e6061 = local_120[_e6058];
local_121 = array<u32, 2>(0u, 4294967295u);
let _e6062 = select(0u, 1u, (_e5884 < 0f));
if (_e6062 < 2u) {
} else {
break;
}
let _e6065 = local_121[_e6062];
local_122 = array<u32, 2>(0u, 4294967295u);
let _e6066 = select(0u, 1u, (_e5885 < 0f));
if (_e6066 < 2u) {
} else {
break;
}
let _e6069 = local_122[_e6066];
local_123 = array<u32, 2>(0u, 4294967295u);
let _e6070 = select(0u, 1u, (_e5886 < 0f));
if (_e6070 < 2u) {
} else {
break;
}
let _e6073 = local_123[_e6070];
let _e6092 = ((_e6061 & 1u) != 0u);
let _e6095 = ((_e6065 & 1u) != 0u);
let _e6098 = ((_e6069 & 1u) != 0u);
let _e6101 = ((_e6073 & 1u) != 0u);
phi_9093_ = type_18(vec4<f32>(_e5888, _e5889, _e5890, _e5886), vec4<f32>((((select(_e5900, _e5892, ((_e5911 & 1u) != 0u)) - (_e5883 * _e5539)) + (select(_e5950, _e5944, ((_e5959 & 1u) != 0u)) - (_e5888 * _e5550))) + _e5878), (((select(_e5901, _e5893, ((_e5915 & 1u) != 0u)) - (_e5884 * _e5565)) + (select(_e5951, _e5945, ((_e5963 & 1u) != 0u)) - (_e5889 * _e5572))) + _e5878), (((select(_e5902, _e5894, ((_e5919 & 1u) != 0u)) - (_e5885 * _e5587)) + (select(_e5952, _e5946, ((_e5967 & 1u) != 0u)) - (_e5890 * _e5594))) + _e5878), (((select(_e5903, _e5895, ((_e5923 & 1u) != 0u)) - _e5939) + (select(_e5903, _e5895, ((_e5969 & 1u) != 0u)) - _e5939)) + _e5878)), vec4<f32>(select(0f, _e6030, ((_e6041 & 1u) != 0u)), select(0f, _e6031, ((_e6045 & 1u) != 0u)), select(0f, _e6032, ((_e6049 & 1u) != 0u)), select(0f, _e6033, ((_e6053 & 1u) != 0u))), vec4<f32>(select(select(0f, 1e20f, _e6019), _e6030, _e6092), select(select(0f, 1e20f, _e6022), _e6031, _e6095), select(select(0f, 1e20f, _e6025), _e6032, _e6098), select(select(0f, 1e20f, _e6028), _e6033, _e6101)), vec4<f32>(select(_e5626, 0f, _e6092), select(_e5626, 0f, _e6095), select(_e5626, 0f, _e6098), select(_e5626, 0f, _e6101)));
} else {
let _e5633 = select(1f, -1f, (_e5629 < 0f));
let _e5639 = select(0f, (2f * _e5625), (bitcast<f32>((bitcast<u32>(_e5629) & 2147483647u)) <= _e5625));
let _e5644 = ((_e5539 - _e5565) * _e5633);
let _e5645 = ((_e5565 - _e5587) * _e5633);
let _e5646 = ((_e5587 - _e5539) * _e5633);
let _e5647 = ((0f - 0f) * _e5633);
let _e5649 = (_e5605 * _e5633);
let _e5650 = (_e5608 * _e5633);
let _e5651 = ((_e5550 - _e5594) * _e5633);
let _e5653 = (_e5644 * _e5628);
let _e5654 = (_e5645 * _e5628);
let _e5655 = (_e5646 * _e5628);
let _e5656 = (_e5647 * _e5628);
let _e5661 = -((_e5644 * _e5602));
let _e5662 = -((_e5645 * _e5602));
let _e5663 = -((_e5646 * _e5602));
let _e5664 = -((_e5647 * _e5602));
local_116 = array<u32, 2>(0u, 4294967295u);
let _e5669 = select(0u, 1u, (_e5653 > _e5661));
if (_e5669 < 2u) {
} else {
break;
}
let _e5672 = local_116[_e5669];
local_117 = array<u32, 2>(0u, 4294967295u);
let _e5673 = select(0u, 1u, (_e5654 > _e5662));
if (_e5673 < 2u) {
} else {
break;
}
let _e5676 = local_117[_e5673];
local_118 = array<u32, 2>(0u, 4294967295u);
let _e5677 = select(0u, 1u, (_e5655 > _e5663));
if (_e5677 < 2u) {
} else {
break;
}
let _e5680 = local_118[_e5677];
local_119 = array<u32, 2>(0u, 4294967295u);
let _e5681 = select(0u, 1u, (_e5656 > _e5664));
let _e5682 = (_e5681 < 2u);
if _e5682 {
} else {
break;
}
let _e5684 = local_119[_e5681];
let _e5700 = (_e5647 * 0f);
let _e5705 = (_e5649 * _e5628);
let _e5706 = (_e5650 * _e5628);
let _e5707 = (_e5651 * _e5628);
let _e5711 = -((_e5649 * _e5602));
let _e5712 = -((_e5650 * _e5602));
let _e5713 = -((_e5651 * _e5602));
local_112 = array<u32, 2>(0u, 4294967295u);
let _e5717 = select(0u, 1u, (_e5705 > _e5711));
if (_e5717 < 2u) {
} else {
break;
}
let _e5720 = local_112[_e5717];
local_113 = array<u32, 2>(0u, 4294967295u);
let _e5721 = select(0u, 1u, (_e5706 > _e5712));
if (_e5721 < 2u) {
} else {
break;
}
let _e5724 = local_113[_e5721];
local_114 = array<u32, 2>(0u, 4294967295u);
let _e5725 = select(0u, 1u, (_e5707 > _e5713));
if (_e5725 < 2u) {
} else {
break;
}
let _e5728 = local_114[_e5725];
local_115 = array<u32, 2>(0u, 4294967295u);
if _e5682 {
} else {
break;
}
let _e5730 = local_115[_e5681];
local_108 = array<u32, 2>(0u, 4294967295u);
let _e5763 = select(0u, 1u, (_e5644 == 0f));
if (_e5763 < 2u) {
} else {
break;
}
let _e5766 = local_108[_e5763];
local_109 = array<u32, 2>(0u, 4294967295u);
let _e5767 = select(0u, 1u, (_e5645 == 0f));
if (_e5767 < 2u) {
} else {
break;
}
let _e5770 = local_109[_e5767];
local_110 = array<u32, 2>(0u, 4294967295u);
let _e5771 = select(0u, 1u, (_e5646 == 0f));
if (_e5771 < 2u) {
} else {
break;
}
let _e5774 = local_110[_e5771];
local_111 = array<u32, 2>(0u, 4294967295u);
let _e5775 = select(0u, 1u, (_e5647 == 0f));
if (_e5775 < 2u) {
} else {
break;
}
let _e5778 = local_111[_e5775];
let _e5780 = ((_e5766 & 1u) != 0u);
let _e5783 = ((_e5770 & 1u) != 0u);
let _e5786 = ((_e5774 & 1u) != 0u);
let _e5789 = ((_e5778 & 1u) != 0u);
let _e5791 = (-1f / select(_e5644, 1f, _e5780));
let _e5792 = (-1f / select(_e5645, 1f, _e5783));
let _e5793 = (-1f / select(_e5646, 1f, _e5786));
let _e5794 = (-1f / select(_e5647, 1f, _e5789));
local_104 = array<u32, 2>(0u, 4294967295u);
let _e5799 = select(0u, 1u, (_e5644 > 0f));
if (_e5799 < 2u) {
} else {
break;
}
let _e5802 = local_104[_e5799];
local_105 = array<u32, 2>(0u, 4294967295u);
let _e5803 = select(0u, 1u, (_e5645 > 0f));
if (_e5803 < 2u) {
} else {
break;
}
let _e5806 = local_105[_e5803];
local_106 = array<u32, 2>(0u, 4294967295u);
let _e5807 = select(0u, 1u, (_e5646 > 0f));
if (_e5807 < 2u) {
} else {
break;
}
let _e5810 = local_106[_e5807];
local_107 = array<u32, 2>(0u, 4294967295u);
let _e5811 = select(0u, 1u, (_e5647 > 0f));
if (_e5811 < 2u) {
} else {
break;
}
let _e5814 = local_107[_e5811];
local_100 = array<u32, 2>(0u, 4294967295u);
let _e5819 = select(0u, 1u, (_e5644 < 0f));
if (_e5819 < 2u) {
} else {
break;
}
let _e5822 = local_100[_e5819];
local_101 = array<u32, 2>(0u, 4294967295u);
let _e5823 = select(0u, 1u, (_e5645 < 0f));
if (_e5823 < 2u) {
} else {
break;
}
let _e5826 = local_101[_e5823];
local_102 = array<u32, 2>(0u, 4294967295u);
let _e5827 = select(0u, 1u, (_e5646 < 0f));
if (_e5827 < 2u) {
} else {
break;
}
let _e5830 = local_102[_e5827];
local_103 = array<u32, 2>(0u, 4294967295u);
let _e5831 = select(0u, 1u, (_e5647 < 0f));
if (_e5831 < 2u) {
} else {
break;
}
let _e5834 = local_103[_e5831];
let _e5853 = ((_e5822 & 1u) != 0u);
let _e5856 = ((_e5826 & 1u) != 0u);
let _e5859 = ((_e5830 & 1u) != 0u);
let _e5862 = ((_e5834 & 1u) != 0u);
phi_9093_ = type_18(vec4<f32>(_e5649, _e5650, _e5651, _e5647), vec4<f32>((((select(_e5661, _e5653, ((_e5672 & 1u) != 0u)) - (_e5644 * _e5550)) + (select(_e5711, _e5705, ((_e5720 & 1u) != 0u)) - (_e5649 * _e5539))) + _e5639), (((select(_e5662, _e5654, ((_e5676 & 1u) != 0u)) - (_e5645 * _e5572)) + (select(_e5712, _e5706, ((_e5724 & 1u) != 0u)) - (_e5650 * _e5565))) + _e5639), (((select(_e5663, _e5655, ((_e5680 & 1u) != 0u)) - (_e5646 * _e5594)) + (select(_e5713, _e5707, ((_e5728 & 1u) != 0u)) - (_e5651 * _e5587))) + _e5639), (((select(_e5664, _e5656, ((_e5684 & 1u) != 0u)) - _e5700) + (select(_e5664, _e5656, ((_e5730 & 1u) != 0u)) - _e5700)) + _e5639)), vec4<f32>(select(0f, _e5791, ((_e5802 & 1u) != 0u)), select(0f, _e5792, ((_e5806 & 1u) != 0u)), select(0f, _e5793, ((_e5810 & 1u) != 0u)), select(0f, _e5794, ((_e5814 & 1u) != 0u))), vec4<f32>(select(select(0f, 1e20f, _e5780), _e5791, _e5853), select(select(0f, 1e20f, _e5783), _e5792, _e5856), select(select(0f, 1e20f, _e5786), _e5793, _e5859), select(select(0f, 1e20f, _e5789), _e5794, _e5862)), vec4<f32>(select(_e5627, 0f, _e5853), select(_e5627, 0f, _e5856), select(_e5627, 0f, _e5859), select(_e5627, 0f, _e5862)));
}
let _e6111 = phi_9093_;
let _e6114 = select(1f, -1f, (((_e5603 * _e5607) - (_e5604 * _e5606)) < 0f));
let _e6117 = (_e5587 - _e5539);
let _e6118 = (0f - 0f);
let _e6119 = ((_e5539 - _e5565) * _e6114);
let _e6120 = ((_e5565 - _e5587) * _e6114);
let _e6121 = (_e6117 * _e6114);
let _e6122 = (_e6118 * _e6114);
let _e6123 = (_e5528 - _e5580);
let _e6124 = (_e5603 * _e6114);
let _e6125 = (_e5606 * _e6114);
let _e6126 = (_e6123 * _e6114);
if (select(0u, 1u, ((_e6119 * _e5628) > -((_e6119 * _e5602)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e6120 * _e5628) > -((_e6120 * _e5602)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e6121 * _e5628) > -((_e6121 * _e5602)))) < 2u) {
} else {
break;
}
let _e6150 = (select(0u, 1u, ((_e6122 * _e5628) > -((_e6122 * _e5602)))) < 2u);
if _e6150 {
} else {
break;
}
if (select(0u, 1u, ((_e6124 * _e5628) > -((_e6124 * _e5602)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e6125 * _e5628) > -((_e6125 * _e5602)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e6126 * _e5628) > -((_e6126 * _e5602)))) < 2u) {
} else {
break;
}
if _e6150 {
} else {
break;
}
if (select(0u, 1u, (_e6119 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6120 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6121 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6122 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6119 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6120 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6121 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6122 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6119 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6120 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6121 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6122 < 0f)) < 2u) {
} else {
break;
}
let _e6206 = select(1f, -1f, (-(((_e5605 * _e5606) - (_e5603 * _e5608))) < 0f));
let _e6209 = (_e5594 - _e5550);
let _e6210 = ((_e5550 - _e5572) * _e6206);
let _e6211 = ((_e5572 - _e5594) * _e6206);
let _e6212 = (_e6209 * _e6206);
let _e6213 = (_e6118 * _e6206);
let _e6214 = (_e5603 * _e6206);
let _e6215 = (_e5606 * _e6206);
let _e6216 = (_e6123 * _e6206);
if (select(0u, 1u, ((_e6210 * _e5628) > -((_e6210 * _e5602)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e6211 * _e5628) > -((_e6211 * _e5602)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e6212 * _e5628) > -((_e6212 * _e5602)))) < 2u) {
} else {
break;
}
let _e6240 = (select(0u, 1u, ((_e6213 * _e5628) > -((_e6213 * _e5602)))) < 2u);
if _e6240 {
} else {
break;
}
if (select(0u, 1u, ((_e6214 * _e5628) > -((_e6214 * _e5602)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e6215 * _e5628) > -((_e6215 * _e5602)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e6216 * _e5628) > -((_e6216 * _e5602)))) < 2u) {
} else {
break;
}
if _e6240 {
} else {
break;
}
if (select(0u, 1u, (_e6210 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6211 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6212 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6213 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6210 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6211 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6212 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6213 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6210 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6211 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6212 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6213 < 0f)) < 2u) {
} else {
break;
}
let _e6295 = (_e5580 - _e5528);
let _e6297 = (_e926.member.member * 19i);
let _e6298 = (_e6297 + 18i);
let _e6300 = (bitcast<i32>(_e214) - 1i);
let _e6302 = select(_e6300, _e6298, (_e6298 < _e6300));
let _e6308 = global_4.member[bitcast<u32>(select(0i, _e6302, (_e6302 > 0i)))];
let _e6310 = select(0f, _e6308, (_e6308 > 0f));
let _e6312 = select(16777216f, _e6310, (_e6310 < 16777216f));
let _e6319 = select(0i, select(select(i32(_e6312), i32(-2147483648), (_e6312 < -2147483600f)), 2147483647i, (_e6312 > 2147483500f)), (_e6312 == _e6312));
phi_11050_ = _e926.member.member_1;
loop {
let _e6326 = phi_11050_;
let _e6327 = (_e6326 < _e926.member.member_2);
if _e6327 {
if _e5631 {
phi_11065_ = _e926.member_1.member_4.y;
} else {
phi_11065_ = _e926.member_1.member_4.z;
}
let _e6331 = phi_11065_;
let _e6332 = f32(_e6331);
let _e6333 = f32(_e6326);
let _e6343 = ((_e6111.member.x * _e6333) + _e6111.member_1.x);
let _e6345 = ((_e6111.member.y * _e6333) + _e6111.member_1.y);
let _e6347 = ((_e6111.member.z * _e6333) + _e6111.member_1.z);
let _e6350 = (_e6343 * _e6111.member_2.x);
let _e6352 = (_e6345 * _e6111.member_2.y);
let _e6354 = (_e6347 * _e6111.member_2.z);
let _e6364 = ((_e6343 * _e6111.member_3.x) + _e6111.member_4.x);
let _e6366 = ((_e6345 * _e6111.member_3.y) + _e6111.member_4.y);
let _e6368 = ((_e6347 * _e6111.member_3.z) + _e6111.member_4.z);
let _e6370 = select(_e6350, 0f, (0f > _e6350));
let _e6372 = select(_e6354, _e6352, (_e6352 > _e6354));
let _e6376 = select(_e6364, _e6332, (_e6332 < _e6364));
let _e6378 = select(_e6368, _e6366, (_e6366 < _e6368));
let _e6380 = select(_e6378, _e6376, (_e6376 < _e6378));
let _e6381 = -(select(_e6372, _e6370, (_e6370 > _e6372)));
let _e6383 = (-(_e6332) - 1f);
let _e6385 = select(_e6383, _e6381, (_e6381 > _e6383));
let _e6387 = select(0f, _e6385, (_e6385 < 0f));
let _e6394 = select(0i, select(select(i32(_e6387), i32(-2147483648), (_e6387 < -2147483600f)), 2147483647i, (_e6387 > 2147483500f)), (_e6387 == _e6387));
let _e6401 = select(-1f, _e6380, (_e6380 > -1f));
let _e6403 = select(_e6332, _e6401, (_e6401 < _e6332));
let _e6410 = select(0i, select(select(i32(_e6403), i32(-2147483648), (_e6403 < -2147483600f)), 2147483647i, (_e6403 > 2147483500f)), (_e6403 == _e6403));
phi_11185_ = -((_e6394 - select(0i, 1i, (_e6387 < f32(_e6394)))));
loop {
let _e6416 = phi_11185_;
let _e6417 = (_e6416 <= (_e6410 - select(0i, 1i, (_e6403 < f32(_e6410)))));
if _e6417 {
let _e6418 = select(_e6416, _e6326, _e5631);
let _e6419 = select(_e6326, _e6416, _e5631);
let _e6425 = global_1.member.member_2.member_1;
let _e6432 = global_1.member.member_3;
phi_11215_ = 0i;
loop {
let _e6436 = phi_11215_;
let _e6437 = (_e6436 <= _e926.member_1.member_4.x);
if _e6437 {
let _e6444 = ((f32(_e6436) + 0.5f) - _e5528);
let _e6445 = ((f32(_e6419) + 0.5f) - _e5539);
let _e6446 = ((f32(_e6418) + 0.5f) - _e5550);
let _e6451 = (((_e5603 * _e5603) + (_e5604 * _e5604)) + (_e5605 * _e5605));
let _e6456 = (((_e5603 * _e6295) + (_e5604 * _e6117)) + (_e5605 * _e6209));
let _e6461 = (((_e6295 * _e6295) + (_e6117 * _e6117)) + (_e6209 * _e6209));
let _e6466 = (((_e6444 * _e5603) + (_e6445 * _e5604)) + (_e6446 * _e5605));
let _e6471 = (((_e6444 * _e6295) + (_e6445 * _e6117)) + (_e6446 * _e6209));
let _e6474 = ((_e6451 * _e6461) - (_e6456 * _e6456));
let _e6475 = (_e6474 > 0f);
let _e6478 = select(0f, (1f / select(1f, _e6474, _e6475)), _e6475);
let _e6482 = (((_e6461 * _e6466) - (_e6456 * _e6471)) * _e6478);
let _e6486 = (((_e6451 * _e6471) - (_e6456 * _e6466)) * _e6478);
let _e6488 = ((1f - _e6482) - _e6486);
let _e6490 = select(0f, _e6488, (_e6488 > 0f));
let _e6492 = select(16777216f, _e6490, (_e6490 < 16777216f));
let _e6494 = select(0f, _e6482, (_e6482 > 0f));
let _e6496 = select(16777216f, _e6494, (_e6494 < 16777216f));
let _e6498 = select(0f, _e6486, (_e6486 > 0f));
let _e6500 = select(16777216f, _e6498, (_e6498 < 16777216f));
let _e6502 = ((_e6492 + _e6496) + _e6500);
let _e6505 = (1f / select(0.5f, _e6502, (_e6502 > 0.5f)));
let _e6506 = (_e6492 * _e6505);
let _e6507 = (_e6496 * _e6505);
let _e6508 = (_e6500 * _e6505);
let _e6510 = select(_e6300, _e6297, (_e6297 < _e6300));
let _e6516 = global_4.member[bitcast<u32>(select(0i, _e6510, (_e6510 > 0i)))];
let _e6517 = (_e6297 + 1i);
let _e6519 = select(_e6300, _e6517, (_e6517 < _e6300));
let _e6525 = global_4.member[bitcast<u32>(select(0i, _e6519, (_e6519 > 0i)))];
let _e6526 = (_e6297 + 2i);
let _e6528 = select(_e6300, _e6526, (_e6526 < _e6300));
let _e6534 = global_4.member[bitcast<u32>(select(0i, _e6528, (_e6528 > 0i)))];
let _e6535 = (_e6297 + 3i);
let _e6537 = select(_e6300, _e6535, (_e6535 < _e6300));
let _e6543 = global_4.member[bitcast<u32>(select(0i, _e6537, (_e6537 > 0i)))];
let _e6544 = (_e6297 + 4i);
let _e6546 = select(_e6300, _e6544, (_e6544 < _e6300));
let _e6552 = global_4.member[bitcast<u32>(select(0i, _e6546, (_e6546 > 0i)))];
let _e6553 = (_e6297 + 5i);
let _e6555 = select(_e6300, _e6553, (_e6553 < _e6300));
let _e6561 = global_4.member[bitcast<u32>(select(0i, _e6555, (_e6555 > 0i)))];
let _e6562 = (_e6297 + 6i);
let _e6564 = select(_e6300, _e6562, (_e6562 < _e6300));
let _e6570 = global_4.member[bitcast<u32>(select(0i, _e6564, (_e6564 > 0i)))];
let _e6571 = (_e6297 + 7i);
let _e6573 = select(_e6300, _e6571, (_e6571 < _e6300));
let _e6579 = global_4.member[bitcast<u32>(select(0i, _e6573, (_e6573 > 0i)))];
let _e6580 = (_e6297 + 8i);
let _e6582 = select(_e6300, _e6580, (_e6580 < _e6300));
let _e6588 = global_4.member[bitcast<u32>(select(0i, _e6582, (_e6582 > 0i)))];
let _e6593 = (((_e6516 * _e6506) + (_e6543 * _e6507)) + (_e6570 * _e6508));
let _e6598 = (((_e6525 * _e6506) + (_e6552 * _e6507)) + (_e6579 * _e6508));
let _e6603 = (((_e6534 * _e6506) + (_e6561 * _e6507)) + (_e6588 * _e6508));
let _e6608 = (((_e6593 * _e6593) + (_e6598 * _e6598)) + (_e6603 * _e6603));
let _e6611 = sqrt(select(0f, _e6608, (_e6608 > 0f)));
let _e6612 = (_e6611 > 1e-6f);
let _e6615 = select(0f, (1f / select(1e-6f, _e6611, _e6612)), _e6612);
let _e6616 = (_e6297 + 9i);
let _e6618 = select(_e6300, _e6616, (_e6616 < _e6300));
let _e6624 = global_4.member[bitcast<u32>(select(0i, _e6618, (_e6618 > 0i)))];
let _e6625 = (_e6297 + 10i);
let _e6627 = select(_e6300, _e6625, (_e6625 < _e6300));
let _e6633 = global_4.member[bitcast<u32>(select(0i, _e6627, (_e6627 > 0i)))];
let _e6634 = (_e6297 + 11i);
let _e6636 = select(_e6300, _e6634, (_e6634 < _e6300));
let _e6642 = global_4.member[bitcast<u32>(select(0i, _e6636, (_e6636 > 0i)))];
let _e6643 = (_e6297 + 12i);
let _e6645 = select(_e6300, _e6643, (_e6643 < _e6300));
let _e6651 = global_4.member[bitcast<u32>(select(0i, _e6645, (_e6645 > 0i)))];
let _e6652 = (_e6297 + 13i);
let _e6654 = select(_e6300, _e6652, (_e6652 < _e6300));
let _e6660 = global_4.member[bitcast<u32>(select(0i, _e6654, (_e6654 > 0i)))];
let _e6661 = (_e6297 + 14i);
let _e6663 = select(_e6300, _e6661, (_e6661 < _e6300));
let _e6669 = global_4.member[bitcast<u32>(select(0i, _e6663, (_e6663 > 0i)))];
let _e6670 = (_e6297 + 15i);
let _e6672 = select(_e6300, _e6670, (_e6670 < _e6300));
let _e6678 = global_4.member[bitcast<u32>(select(0i, _e6672, (_e6672 > 0i)))];
let _e6679 = (_e6297 + 16i);
let _e6681 = select(_e6300, _e6679, (_e6679 < _e6300));
let _e6687 = global_4.member[bitcast<u32>(select(0i, _e6681, (_e6681 > 0i)))];
let _e6688 = (_e6297 + 17i);
let _e6690 = select(_e6300, _e6688, (_e6688 < _e6300));
let _e6696 = global_4.member[bitcast<u32>(select(0i, _e6690, (_e6690 > 0i)))];
let _e6712 = (_e926.member_1.member_3.x + _e6436);
let _e6715 = ((((((_e926.member_1.member_3.z + _e6418) * bitcast<i32>(_e6425)) + _e926.member_1.member_3.y) + _e6419) * bitcast<i32>(_e6432)) + (_e6712 >> bitcast<u32>(5i)));
let _e6719 = (bitcast<i32>(_e218) - 1i);
let _e6721 = select(_e6719, _e6715, (_e6715 < _e6719));
let _e6727 = global_6.member[bitcast<u32>(select(0i, _e6721, (_e6721 > 0i)))];
let _e6729 = (bitcast<i32>(_e216) - 1i);
let _e6731 = select(_e6729, _e6715, (_e6715 < _e6729));
let _e6737 = global_5.member[bitcast<u32>(select(0i, _e6731, (_e6731 > 0i)))];
let _e6746 = (bitcast<i32>((_e6727 + countOneBits((_e6737 & ((1u << bitcast<u32>((bitcast<u32>((_e6712 & 31i)) & 31u))) - 1u))))) * 14i);
let _e6747 = bitcast<u32>(_e6746);
if (_e6747 < _e220) {
let _e6751 = atomicAdd((&global_7.member[_e6747]), 1u);
}
let _e6753 = bitcast<u32>((_e6746 + 1i));
if (_e6753 < _e220) {
let _e6757 = atomicMax((&global_7.member[_e6753]), bitcast<u32>((_e6319 - select(0i, 1i, (_e6312 < f32(_e6319))))));
}
let _e6763 = (((_e6593 * _e6615) * 65536f) + 0.5f);
let _e6765 = select(-1073741800f, _e6763, (_e6763 > -1073741800f));
let _e6767 = select(1073741800f, _e6765, (_e6765 < 1073741800f));
let _e6774 = select(0i, select(select(i32(_e6767), i32(-2147483648), (_e6767 < -2147483600f)), 2147483647i, (_e6767 > 2147483500f)), (_e6767 == _e6767));
let _e6778 = (_e6774 - select(0i, 1i, (_e6767 < f32(_e6774))));
let _e6779 = bitcast<u32>(_e6778);
let _e6782 = bitcast<u32>((_e6778 >> bitcast<u32>(31i)));
if ((_e6779 | _e6782) == 0u) {
} else {
let _e6785 = bitcast<u32>((_e6746 + 2i));
if (_e6785 < _e220) {
let _e6789 = atomicAdd((&global_7.member[_e6785]), _e6779);
phi_11746_ = _e6789;
} else {
phi_11746_ = 0u;
}
let _e6791 = phi_11746_;
let _e6795 = (_e6782 + select(0u, 1u, ((_e6791 + _e6779) < _e6779)));
if (_e6795 == 0u) {
} else {
let _e6797 = (_e6785 + 1u);
if (_e6797 < _e220) {
let _e6801 = atomicAdd((&global_7.member[_e6797]), _e6795);
}
}
}
let _e6804 = (((_e6598 * _e6615) * 65536f) + 0.5f);
let _e6806 = select(-1073741800f, _e6804, (_e6804 > -1073741800f));
let _e6808 = select(1073741800f, _e6806, (_e6806 < 1073741800f));
let _e6815 = select(0i, select(select(i32(_e6808), i32(-2147483648), (_e6808 < -2147483600f)), 2147483647i, (_e6808 > 2147483500f)), (_e6808 == _e6808));
let _e6819 = (_e6815 - select(0i, 1i, (_e6808 < f32(_e6815))));
let _e6820 = bitcast<u32>(_e6819);
let _e6823 = bitcast<u32>((_e6819 >> bitcast<u32>(31i)));
if ((_e6820 | _e6823) == 0u) {
} else {
let _e6826 = bitcast<u32>((_e6746 + 4i));
if (_e6826 < _e220) {
let _e6830 = atomicAdd((&global_7.member[_e6826]), _e6820);
phi_11803_ = _e6830;
} else {
phi_11803_ = 0u;
}
let _e6832 = phi_11803_;
let _e6836 = (_e6823 + select(0u, 1u, ((_e6832 + _e6820) < _e6820)));
if (_e6836 == 0u) {
} else {
let _e6838 = (_e6826 + 1u);
if (_e6838 < _e220) {
let _e6842 = atomicAdd((&global_7.member[_e6838]), _e6836);
}
}
}
let _e6845 = (((_e6603 * _e6615) * 65536f) + 0.5f);
let _e6847 = select(-1073741800f, _e6845, (_e6845 > -1073741800f));
let _e6849 = select(1073741800f, _e6847, (_e6847 < 1073741800f));
let _e6856 = select(0i, select(select(i32(_e6849), i32(-2147483648), (_e6849 < -2147483600f)), 2147483647i, (_e6849 > 2147483500f)), (_e6849 == _e6849));
let _e6860 = (_e6856 - select(0i, 1i, (_e6849 < f32(_e6856))));
let _e6861 = bitcast<u32>(_e6860);
let _e6864 = bitcast<u32>((_e6860 >> bitcast<u32>(31i)));
if ((_e6861 | _e6864) == 0u) {
} else {
let _e6867 = bitcast<u32>((_e6746 + 6i));
if (_e6867 < _e220) {
let _e6871 = atomicAdd((&global_7.member[_e6867]), _e6861);
phi_11860_ = _e6871;
} else {
phi_11860_ = 0u;
}
let _e6873 = phi_11860_;
let _e6877 = (_e6864 + select(0u, 1u, ((_e6873 + _e6861) < _e6861)));
if (_e6877 == 0u) {
} else {
let _e6879 = (_e6867 + 1u);
if (_e6879 < _e220) {
let _e6883 = atomicAdd((&global_7.member[_e6879]), _e6877);
}
}
}
let _e6886 = (((((_e6624 * _e6506) + (_e6651 * _e6507)) + (_e6678 * _e6508)) * 65536f) + 0.5f);
let _e6888 = select(-1073741800f, _e6886, (_e6886 > -1073741800f));
let _e6890 = select(1073741800f, _e6888, (_e6888 < 1073741800f));
let _e6897 = select(0i, select(select(i32(_e6890), i32(-2147483648), (_e6890 < -2147483600f)), 2147483647i, (_e6890 > 2147483500f)), (_e6890 == _e6890));
let _e6901 = (_e6897 - select(0i, 1i, (_e6890 < f32(_e6897))));
let _e6902 = bitcast<u32>(_e6901);
let _e6905 = bitcast<u32>((_e6901 >> bitcast<u32>(31i)));
if ((_e6902 | _e6905) == 0u) {
} else {
let _e6908 = bitcast<u32>((_e6746 + 8i));
if (_e6908 < _e220) {
let _e6912 = atomicAdd((&global_7.member[_e6908]), _e6902);
phi_11918_ = _e6912;
} else {
phi_11918_ = 0u;
}
let _e6914 = phi_11918_;
let _e6918 = (_e6905 + select(0u, 1u, ((_e6914 + _e6902) < _e6902)));
if (_e6918 == 0u) {
} else {
let _e6920 = (_e6908 + 1u);
if (_e6920 < _e220) {
let _e6924 = atomicAdd((&global_7.member[_e6920]), _e6918);
}
}
}
let _e6927 = (((((_e6633 * _e6506) + (_e6660 * _e6507)) + (_e6687 * _e6508)) * 65536f) + 0.5f);
let _e6929 = select(-1073741800f, _e6927, (_e6927 > -1073741800f));
let _e6931 = select(1073741800f, _e6929, (_e6929 < 1073741800f));
let _e6938 = select(0i, select(select(i32(_e6931), i32(-2147483648), (_e6931 < -2147483600f)), 2147483647i, (_e6931 > 2147483500f)), (_e6931 == _e6931));
let _e6942 = (_e6938 - select(0i, 1i, (_e6931 < f32(_e6938))));
let _e6943 = bitcast<u32>(_e6942);
let _e6946 = bitcast<u32>((_e6942 >> bitcast<u32>(31i)));
if ((_e6943 | _e6946) == 0u) {
} else {
let _e6949 = bitcast<u32>((_e6746 + 10i));
if (_e6949 < _e220) {
let _e6953 = atomicAdd((&global_7.member[_e6949]), _e6943);
phi_11975_ = _e6953;
} else {
phi_11975_ = 0u;
}
let _e6955 = phi_11975_;
let _e6959 = (_e6946 + select(0u, 1u, ((_e6955 + _e6943) < _e6943)));
if (_e6959 == 0u) {
} else {
let _e6961 = (_e6949 + 1u);
if (_e6961 < _e220) {
let _e6965 = atomicAdd((&global_7.member[_e6961]), _e6959);
}
}
}
let _e6968 = (((((_e6642 * _e6506) + (_e6669 * _e6507)) + (_e6696 * _e6508)) * 65536f) + 0.5f);
let _e6970 = select(-1073741800f, _e6968, (_e6968 > -1073741800f));
let _e6972 = select(1073741800f, _e6970, (_e6970 < 1073741800f));
let _e6979 = select(0i, select(select(i32(_e6972), i32(-2147483648), (_e6972 < -2147483600f)), 2147483647i, (_e6972 > 2147483500f)), (_e6972 == _e6972));
let _e6983 = (_e6979 - select(0i, 1i, (_e6972 < f32(_e6979))));
let _e6984 = bitcast<u32>(_e6983);
let _e6987 = bitcast<u32>((_e6983 >> bitcast<u32>(31i)));
if ((_e6984 | _e6987) == 0u) {
} else {
let _e6990 = bitcast<u32>((_e6746 + 12i));
if (_e6990 < _e220) {
let _e6994 = atomicAdd((&global_7.member[_e6990]), _e6984);
phi_12032_ = _e6994;
} else {
phi_12032_ = 0u;
}
let _e6996 = phi_12032_;
let _e7000 = (_e6987 + select(0u, 1u, ((_e6996 + _e6984) < _e6984)));
if (_e7000 == 0u) {
} else {
let _e7002 = (_e6990 + 1u);
if (_e7002 < _e220) {
let _e7006 = atomicAdd((&global_7.member[_e7002]), _e7000);
}
}
}
phi_11216_ = (_e6436 + 1i);
} else {
phi_11216_ = i32();
}
let _e7009 = phi_11216_;
continue;
continuing {
phi_11215_ = _e7009;
break if !(_e6437);
}
}
phi_11186_ = (_e6416 + 1i);
} else {
phi_11186_ = i32();
}
let _e7013 = phi_11186_;
continue;
continuing {
phi_11185_ = _e7013;
break if !(_e6417);
}
}
phi_11051_ = (_e6326 + 1i);
} else {
phi_11051_ = i32();
}
let _e7017 = phi_11051_;
continue;
continuing {
phi_11050_ = _e7017;
break if !(_e6327);
}
}
} else {
if (_e952 == 2u) {
let _e4198 = (_e926.member_1.member_6 & 31u);
let _e4200 = (_e926.member_1.member_3.x << bitcast<u32>(_e4198));
let _e4203 = (_e926.member_1.member_7 & 31u);
let _e4207 = ((1i << bitcast<u32>(_e4203)) >> bitcast<u32>(1i));
let _e4213 = bitcast<i32>(_e926.member_1.member_6);
let _e4219 = bitcast<f32>((bitcast<u32>((127i + (bitcast<i32>(_e926.member_1.member_7) - _e4213))) << bitcast<u32>(23i)));
let _e4220 = (f32((((_e926.member_1.member.x - _e4200) + _e4207) >> bitcast<u32>(_e4203))) * _e4219);
let _e4225 = (_e926.member_1.member_3.y << bitcast<u32>(_e4198));
let _e4231 = (f32((((_e926.member_1.member.y - _e4225) + _e4207) >> bitcast<u32>(_e4203))) * _e4219);
let _e4236 = (_e926.member_1.member_3.z << bitcast<u32>(_e4198));
let _e4242 = (f32((((_e926.member_1.member.z - _e4236) + _e4207) >> bitcast<u32>(_e4203))) * _e4219);
let _e4250 = (f32((((_e926.member_1.member_1.x - _e4200) + _e4207) >> bitcast<u32>(_e4203))) * _e4219);
let _e4257 = (f32((((_e926.member_1.member_1.y - _e4225) + _e4207) >> bitcast<u32>(_e4203))) * _e4219);
let _e4264 = (f32((((_e926.member_1.member_1.z - _e4236) + _e4207) >> bitcast<u32>(_e4203))) * _e4219);
let _e4272 = (f32((((_e926.member_1.member_2.x - _e4200) + _e4207) >> bitcast<u32>(_e4203))) * _e4219);
let _e4279 = (f32((((_e926.member_1.member_2.y - _e4225) + _e4207) >> bitcast<u32>(_e4203))) * _e4219);
let _e4286 = (f32((((_e926.member_1.member_2.z - _e4236) + _e4207) >> bitcast<u32>(_e4203))) * _e4219);
let _e4294 = (f32(_e926.member_1.member_5) * bitcast<f32>((bitcast<u32>((127i - _e4213)) << bitcast<u32>(23i))));
let _e4295 = (_e4250 - _e4220);
let _e4296 = (_e4257 - _e4231);
let _e4297 = (_e4264 - _e4242);
let _e4298 = (_e4272 - _e4250);
let _e4299 = (_e4279 - _e4257);
let _e4300 = (_e4286 - _e4264);
let _e4303 = ((_e4296 * _e4300) - (_e4297 * _e4299));
let _e4304 = (_e4297 * _e4298);
let _e4305 = (_e4295 * _e4300);
let _e4317 = ((bitcast<f32>((bitcast<u32>(_e4304) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e4305) & 2147483647u))) * 2.3841858e-7f);
let _e4318 = f32(_e926.member_1.member_4.x);
let _e4319 = (1f + _e4294);
let _e4321 = -((_e4304 - _e4305));
let _e4322 = (_e926.member_1.member_4.z >= _e926.member_1.member_4.y);
if _e4322 {
let _e4416 = select(1f, -1f, (_e4303 < 0f));
let _e4421 = ((_e4242 - _e4264) * _e4416);
let _e4422 = ((_e4264 - _e4286) * _e4416);
let _e4423 = ((_e4286 - _e4242) * _e4416);
let _e4424 = ((0f - 0f) * _e4416);
let _e4426 = (_e4296 * _e4416);
let _e4427 = (_e4299 * _e4416);
let _e4428 = ((_e4231 - _e4279) * _e4416);
if (select(0u, 1u, ((_e4421 * _e4319) > -((_e4421 * _e4294)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4422 * _e4319) > -((_e4422 * _e4294)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4423 * _e4319) > -((_e4423 * _e4294)))) < 2u) {
} else {
break;
}
let _e4452 = (select(0u, 1u, ((_e4424 * _e4319) > -((_e4424 * _e4294)))) < 2u);
if _e4452 {
} else {
break;
}
if (select(0u, 1u, ((_e4426 * _e4319) > -((_e4426 * _e4294)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4427 * _e4319) > -((_e4427 * _e4294)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4428 * _e4319) > -((_e4428 * _e4294)))) < 2u) {
} else {
break;
}
if _e4452 {
} else {
break;
}
if (select(0u, 1u, (_e4421 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4422 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4423 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4424 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4421 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4422 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4423 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4424 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4421 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4422 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4423 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4424 < 0f)) < 2u) {
} else {
break;
}
} else {
let _e4324 = select(1f, -1f, (-(_e4303) < 0f));
let _e4329 = ((_e4231 - _e4257) * _e4324);
let _e4330 = ((_e4257 - _e4279) * _e4324);
let _e4331 = ((_e4279 - _e4231) * _e4324);
let _e4332 = ((0f - 0f) * _e4324);
let _e4334 = (_e4297 * _e4324);
let _e4335 = (_e4300 * _e4324);
let _e4336 = ((_e4242 - _e4286) * _e4324);
if (select(0u, 1u, ((_e4329 * _e4319) > -((_e4329 * _e4294)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4330 * _e4319) > -((_e4330 * _e4294)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4331 * _e4319) > -((_e4331 * _e4294)))) < 2u) {
} else {
break;
}
let _e4360 = (select(0u, 1u, ((_e4332 * _e4319) > -((_e4332 * _e4294)))) < 2u);
if _e4360 {
} else {
break;
}
if (select(0u, 1u, ((_e4334 * _e4319) > -((_e4334 * _e4294)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4335 * _e4319) > -((_e4335 * _e4294)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4336 * _e4319) > -((_e4336 * _e4294)))) < 2u) {
} else {
break;
}
if _e4360 {
} else {
break;
}
if (select(0u, 1u, (_e4329 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4330 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4331 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4332 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4329 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4330 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4331 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4332 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4329 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4330 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4331 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4332 < 0f)) < 2u) {
} else {
break;
}
}
let _e4509 = select(1f, -1f, (((_e4295 * _e4299) - (_e4296 * _e4298)) < 0f));
let _e4512 = (_e4279 - _e4231);
let _e4513 = (0f - 0f);
let _e4514 = ((_e4231 - _e4257) * _e4509);
let _e4515 = ((_e4257 - _e4279) * _e4509);
let _e4516 = (_e4512 * _e4509);
let _e4517 = (_e4513 * _e4509);
let _e4518 = (_e4220 - _e4272);
let _e4519 = (_e4295 * _e4509);
let _e4520 = (_e4298 * _e4509);
let _e4521 = (_e4518 * _e4509);
if (select(0u, 1u, ((_e4514 * _e4319) > -((_e4514 * _e4294)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4515 * _e4319) > -((_e4515 * _e4294)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4516 * _e4319) > -((_e4516 * _e4294)))) < 2u) {
} else {
break;
}
let _e4545 = (select(0u, 1u, ((_e4517 * _e4319) > -((_e4517 * _e4294)))) < 2u);
if _e4545 {
} else {
break;
}
if (select(0u, 1u, ((_e4519 * _e4319) > -((_e4519 * _e4294)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4520 * _e4319) > -((_e4520 * _e4294)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4521 * _e4319) > -((_e4521 * _e4294)))) < 2u) {
} else {
break;
}
if _e4545 {
} else {
break;
}
if (select(0u, 1u, (_e4514 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4515 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4516 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4517 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4514 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4515 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4516 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4517 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4514 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4515 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4516 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4517 < 0f)) < 2u) {
} else {
break;
}
let _e4601 = select(1f, -1f, (_e4321 < 0f));
let _e4607 = select(0f, (2f * _e4317), (bitcast<f32>((bitcast<u32>(_e4321) & 2147483647u)) <= _e4317));
let _e4610 = (_e4286 - _e4242);
let _e4611 = ((_e4242 - _e4264) * _e4601);
let _e4612 = ((_e4264 - _e4286) * _e4601);
let _e4613 = (_e4610 * _e4601);
let _e4614 = (_e4513 * _e4601);
let _e4615 = (_e4295 * _e4601);
let _e4616 = (_e4298 * _e4601);
let _e4617 = (_e4518 * _e4601);
let _e4618 = (_e4611 * _e4319);
let _e4619 = (_e4612 * _e4319);
let _e4620 = (_e4613 * _e4319);
let _e4626 = -((_e4611 * _e4294));
let _e4627 = -((_e4612 * _e4294));
let _e4628 = -((_e4613 * _e4294));
local_97 = array<u32, 2>(0u, 4294967295u);
let _e4634 = select(0u, 1u, (_e4618 > _e4626));
if (_e4634 < 2u) {
} else {
break;
}
let _e4637 = local_97[_e4634];
local_98 = array<u32, 2>(0u, 4294967295u);
let _e4638 = select(0u, 1u, (_e4619 > _e4627));
if (_e4638 < 2u) {
} else {
break;
}
let _e4641 = local_98[_e4638];
local_99 = array<u32, 2>(0u, 4294967295u);
let _e4642 = select(0u, 1u, (_e4620 > _e4628));
if (_e4642 < 2u) {
} else {
break;
}
let _e4645 = local_99[_e4642];
let _e4647 = (select(0u, 1u, ((_e4614 * _e4319) > -((_e4614 * _e4294)))) < 2u);
if _e4647 {
} else {
break;
}
let _e4663 = (_e4615 * _e4319);
let _e4664 = (_e4616 * _e4319);
let _e4665 = (_e4617 * _e4319);
let _e4669 = -((_e4615 * _e4294));
let _e4670 = -((_e4616 * _e4294));
let _e4671 = -((_e4617 * _e4294));
local_94 = array<u32, 2>(0u, 4294967295u);
let _e4675 = select(0u, 1u, (_e4663 > _e4669));
if (_e4675 < 2u) {
} else {
break;
}
let _e4678 = local_94[_e4675];
local_95 = array<u32, 2>(0u, 4294967295u);
let _e4679 = select(0u, 1u, (_e4664 > _e4670));
if (_e4679 < 2u) {
} else {
break;
}
let _e4682 = local_95[_e4679];
local_96 = array<u32, 2>(0u, 4294967295u);
let _e4683 = select(0u, 1u, (_e4665 > _e4671));
if (_e4683 < 2u) {
} else {
break;
}
let _e4686 = local_96[_e4683];
if _e4647 {
} else {
break;
}
local_91 = array<u32, 2>(0u, 4294967295u);
let _e4712 = select(0u, 1u, (_e4611 == 0f));
if (_e4712 < 2u) {
} else {
break;
}
let _e4715 = local_91[_e4712];
local_92 = array<u32, 2>(0u, 4294967295u);
let _e4716 = select(0u, 1u, (_e4612 == 0f));
if (_e4716 < 2u) {
} else {
break;
}
let _e4719 = local_92[_e4716];
local_93 = array<u32, 2>(0u, 4294967295u);
let _e4720 = select(0u, 1u, (_e4613 == 0f));
if (_e4720 < 2u) {
} else {
break;
}
let _e4723 = local_93[_e4720];
if (select(0u, 1u, (_e4614 == 0f)) < 2u) {
} else {
break;
}
let _e4727 = ((_e4715 & 1u) != 0u);
let _e4730 = ((_e4719 & 1u) != 0u);
let _e4733 = ((_e4723 & 1u) != 0u);
let _e4735 = (-1f / select(_e4611, 1f, _e4727));
let _e4736 = (-1f / select(_e4612, 1f, _e4730));
let _e4737 = (-1f / select(_e4613, 1f, _e4733));
local_88 = array<u32, 2>(0u, 4294967295u);
let _e4742 = select(0u, 1u, (_e4611 > 0f));
if (_e4742 < 2u) {
} else {
break;
}
let _e4745 = local_88[_e4742];
local_89 = array<u32, 2>(0u, 4294967295u);
let _e4746 = select(0u, 1u, (_e4612 > 0f));
if (_e4746 < 2u) {
} else {
break;
}
let _e4749 = local_89[_e4746];
local_90 = array<u32, 2>(0u, 4294967295u);
let _e4750 = select(0u, 1u, (_e4613 > 0f));
if (_e4750 < 2u) {
} else {
break;
}
let _e4753 = local_90[_e4750];
if (select(0u, 1u, (_e4614 > 0f)) < 2u) {
} else {
break;
}
local_85 = array<u32, 2>(0u, 4294967295u);
let _e4760 = select(0u, 1u, (_e4611 < 0f));
if (_e4760 < 2u) {
} else {
break;
}
let _e4763 = local_85[_e4760];
local_86 = array<u32, 2>(0u, 4294967295u);
let _e4764 = select(0u, 1u, (_e4612 < 0f));
if (_e4764 < 2u) {
} else {
break;
}
let _e4767 = local_86[_e4764];
local_87 = array<u32, 2>(0u, 4294967295u);
let _e4768 = select(0u, 1u, (_e4613 < 0f));
if (_e4768 < 2u) {
} else {
break;
}
let _e4771 = local_87[_e4768];
if (select(0u, 1u, (_e4614 < 0f)) < 2u) {
} else {
break;
}
let _e4787 = ((_e4763 & 1u) != 0u);
let _e4790 = ((_e4767 & 1u) != 0u);
let _e4793 = ((_e4771 & 1u) != 0u);
let _e4798 = (_e4272 - _e4220);
let _e4800 = (_e926.member.member * 19i);
let _e4801 = (_e4800 + 18i);
let _e4803 = (bitcast<i32>(_e214) - 1i);
let _e4805 = select(_e4803, _e4801, (_e4801 < _e4803));
let _e4811 = global_4.member[bitcast<u32>(select(0i, _e4805, (_e4805 > 0i)))];
let _e4813 = select(0f, _e4811, (_e4811 > 0f));
let _e4815 = select(16777216f, _e4813, (_e4813 < 16777216f));
let _e4822 = select(0i, select(select(i32(_e4815), i32(-2147483648), (_e4815 < -2147483600f)), 2147483647i, (_e4815 > 2147483500f)), (_e4815 == _e4815));
phi_16049_ = _e926.member.member_1;
loop {
let _e4829 = phi_16049_;
let _e4830 = (_e4829 < _e926.member.member_2);
if _e4830 {
if _e4322 {
phi_16064_ = _e926.member_1.member_4.y;
} else {
phi_16064_ = _e926.member_1.member_4.z;
}
let _e4834 = phi_16064_;
phi_16066_ = 0i;
loop {
let _e4836 = phi_16066_;
let _e4837 = (_e4836 <= _e4834);
if _e4837 {
let _e4838 = select(_e4836, _e4829, _e4322);
let _e4839 = select(_e4829, _e4836, _e4322);
let _e4840 = f32(_e4838);
let _e4842 = f32(_e926.member_1.member_4.x);
let _e4846 = ((_e4615 * _e4840) + (((select(_e4626, _e4618, ((_e4637 & 1u) != 0u)) - (_e4611 * _e4220)) + (select(_e4669, _e4663, ((_e4678 & 1u) != 0u)) - (_e4615 * _e4242))) + _e4607));
let _e4847 = ((_e4616 * _e4840) + (((select(_e4627, _e4619, ((_e4641 & 1u) != 0u)) - (_e4612 * _e4250)) + (select(_e4670, _e4664, ((_e4682 & 1u) != 0u)) - (_e4616 * _e4264))) + _e4607));
let _e4848 = ((_e4617 * _e4840) + (((select(_e4628, _e4620, ((_e4645 & 1u) != 0u)) - (_e4613 * _e4272)) + (select(_e4671, _e4665, ((_e4686 & 1u) != 0u)) - (_e4617 * _e4286))) + _e4607));
let _e4849 = (_e4846 * select(0f, _e4735, ((_e4745 & 1u) != 0u)));
let _e4850 = (_e4847 * select(0f, _e4736, ((_e4749 & 1u) != 0u)));
let _e4851 = (_e4848 * select(0f, _e4737, ((_e4753 & 1u) != 0u)));
let _e4855 = ((_e4846 * select(select(0f, 1e20f, _e4727), _e4735, _e4787)) + select(_e4318, 0f, _e4787));
let _e4856 = ((_e4847 * select(select(0f, 1e20f, _e4730), _e4736, _e4790)) + select(_e4318, 0f, _e4790));
let _e4857 = ((_e4848 * select(select(0f, 1e20f, _e4733), _e4737, _e4793)) + select(_e4318, 0f, _e4793));
let _e4859 = select(_e4849, 0f, (0f > _e4849));
let _e4861 = select(_e4851, _e4850, (_e4850 > _e4851));
let _e4865 = select(_e4855, _e4842, (_e4842 < _e4855));
let _e4867 = select(_e4857, _e4856, (_e4856 < _e4857));
let _e4869 = select(_e4867, _e4865, (_e4865 < _e4867));
let _e4870 = -(select(_e4861, _e4859, (_e4859 > _e4861)));
let _e4872 = (-(_e4842) - 1f);
let _e4874 = select(_e4872, _e4870, (_e4870 > _e4872));
let _e4876 = select(0f, _e4874, (_e4874 < 0f));
let _e4883 = select(0i, select(select(i32(_e4876), i32(-2147483648), (_e4876 < -2147483600f)), 2147483647i, (_e4876 > 2147483500f)), (_e4876 == _e4876));
let _e4890 = select(-1f, _e4869, (_e4869 > -1f));
let _e4892 = select(_e4842, _e4890, (_e4890 < _e4842));
let _e4899 = select(0i, select(select(i32(_e4892), i32(-2147483648), (_e4892 < -2147483600f)), 2147483647i, (_e4892 > 2147483500f)), (_e4892 == _e4892));
let _e4908 = global_1.member.member_2.member_1;
let _e4915 = global_1.member.member_3;
phi_16193_ = -((_e4883 - select(0i, 1i, (_e4876 < f32(_e4883)))));
loop {
let _e4919 = phi_16193_;
let _e4920 = (_e4919 <= (_e4899 - select(0i, 1i, (_e4892 < f32(_e4899)))));
if _e4920 {
let _e4926 = ((f32(_e4919) + 0.5f) - _e4220);
let _e4927 = ((f32(_e4839) + 0.5f) - _e4231);
let _e4928 = ((_e4840 + 0.5f) - _e4242);
let _e4933 = (((_e4295 * _e4295) + (_e4296 * _e4296)) + (_e4297 * _e4297));
let _e4938 = (((_e4295 * _e4798) + (_e4296 * _e4512)) + (_e4297 * _e4610));
let _e4943 = (((_e4798 * _e4798) + (_e4512 * _e4512)) + (_e4610 * _e4610));
let _e4948 = (((_e4926 * _e4295) + (_e4927 * _e4296)) + (_e4928 * _e4297));
let _e4953 = (((_e4926 * _e4798) + (_e4927 * _e4512)) + (_e4928 * _e4610));
let _e4956 = ((_e4933 * _e4943) - (_e4938 * _e4938));
let _e4957 = (_e4956 > 0f);
let _e4960 = select(0f, (1f / select(1f, _e4956, _e4957)), _e4957);
let _e4964 = (((_e4943 * _e4948) - (_e4938 * _e4953)) * _e4960);
let _e4968 = (((_e4933 * _e4953) - (_e4938 * _e4948)) * _e4960);
let _e4970 = ((1f - _e4964) - _e4968);
let _e4972 = select(0f, _e4970, (_e4970 > 0f));
let _e4974 = select(16777216f, _e4972, (_e4972 < 16777216f));
let _e4976 = select(0f, _e4964, (_e4964 > 0f));
let _e4978 = select(16777216f, _e4976, (_e4976 < 16777216f));
let _e4980 = select(0f, _e4968, (_e4968 > 0f));
let _e4982 = select(16777216f, _e4980, (_e4980 < 16777216f));
let _e4984 = ((_e4974 + _e4978) + _e4982);
let _e4987 = (1f / select(0.5f, _e4984, (_e4984 > 0.5f)));
let _e4988 = (_e4974 * _e4987);
let _e4989 = (_e4978 * _e4987);
let _e4990 = (_e4982 * _e4987);
let _e4992 = select(_e4803, _e4800, (_e4800 < _e4803));
let _e4998 = global_4.member[bitcast<u32>(select(0i, _e4992, (_e4992 > 0i)))];
let _e4999 = (_e4800 + 1i);
let _e5001 = select(_e4803, _e4999, (_e4999 < _e4803));
let _e5007 = global_4.member[bitcast<u32>(select(0i, _e5001, (_e5001 > 0i)))];
let _e5008 = (_e4800 + 2i);
let _e5010 = select(_e4803, _e5008, (_e5008 < _e4803));
let _e5016 = global_4.member[bitcast<u32>(select(0i, _e5010, (_e5010 > 0i)))];
let _e5017 = (_e4800 + 3i);
let _e5019 = select(_e4803, _e5017, (_e5017 < _e4803));
let _e5025 = global_4.member[bitcast<u32>(select(0i, _e5019, (_e5019 > 0i)))];
let _e5026 = (_e4800 + 4i);
let _e5028 = select(_e4803, _e5026, (_e5026 < _e4803));
let _e5034 = global_4.member[bitcast<u32>(select(0i, _e5028, (_e5028 > 0i)))];
let _e5035 = (_e4800 + 5i);
let _e5037 = select(_e4803, _e5035, (_e5035 < _e4803));
let _e5043 = global_4.member[bitcast<u32>(select(0i, _e5037, (_e5037 > 0i)))];
let _e5044 = (_e4800 + 6i);
let _e5046 = select(_e4803, _e5044, (_e5044 < _e4803));
let _e5052 = global_4.member[bitcast<u32>(select(0i, _e5046, (_e5046 > 0i)))];
let _e5053 = (_e4800 + 7i);
let _e5055 = select(_e4803, _e5053, (_e5053 < _e4803));
let _e5061 = global_4.member[bitcast<u32>(select(0i, _e5055, (_e5055 > 0i)))];
let _e5062 = (_e4800 + 8i);
let _e5064 = select(_e4803, _e5062, (_e5062 < _e4803));
let _e5070 = global_4.member[bitcast<u32>(select(0i, _e5064, (_e5064 > 0i)))];
let _e5075 = (((_e4998 * _e4988) + (_e5025 * _e4989)) + (_e5052 * _e4990));
let _e5080 = (((_e5007 * _e4988) + (_e5034 * _e4989)) + (_e5061 * _e4990));
let _e5085 = (((_e5016 * _e4988) + (_e5043 * _e4989)) + (_e5070 * _e4990));
let _e5090 = (((_e5075 * _e5075) + (_e5080 * _e5080)) + (_e5085 * _e5085));
let _e5093 = sqrt(select(0f, _e5090, (_e5090 > 0f)));
let _e5094 = (_e5093 > 1e-6f);
let _e5097 = select(0f, (1f / select(1e-6f, _e5093, _e5094)), _e5094);
let _e5098 = (_e4800 + 9i);
let _e5100 = select(_e4803, _e5098, (_e5098 < _e4803));
let _e5106 = global_4.member[bitcast<u32>(select(0i, _e5100, (_e5100 > 0i)))];
let _e5107 = (_e4800 + 10i);
let _e5109 = select(_e4803, _e5107, (_e5107 < _e4803));
let _e5115 = global_4.member[bitcast<u32>(select(0i, _e5109, (_e5109 > 0i)))];
let _e5116 = (_e4800 + 11i);
let _e5118 = select(_e4803, _e5116, (_e5116 < _e4803));
let _e5124 = global_4.member[bitcast<u32>(select(0i, _e5118, (_e5118 > 0i)))];
let _e5125 = (_e4800 + 12i);
let _e5127 = select(_e4803, _e5125, (_e5125 < _e4803));
let _e5133 = global_4.member[bitcast<u32>(select(0i, _e5127, (_e5127 > 0i)))];
let _e5134 = (_e4800 + 13i);
let _e5136 = select(_e4803, _e5134, (_e5134 < _e4803));
let _e5142 = global_4.member[bitcast<u32>(select(0i, _e5136, (_e5136 > 0i)))];
let _e5143 = (_e4800 + 14i);
let _e5145 = select(_e4803, _e5143, (_e5143 < _e4803));
let _e5151 = global_4.member[bitcast<u32>(select(0i, _e5145, (_e5145 > 0i)))];
let _e5152 = (_e4800 + 15i);
let _e5154 = select(_e4803, _e5152, (_e5152 < _e4803));
let _e5160 = global_4.member[bitcast<u32>(select(0i, _e5154, (_e5154 > 0i)))];
let _e5161 = (_e4800 + 16i);
let _e5163 = select(_e4803, _e5161, (_e5161 < _e4803));
let _e5169 = global_4.member[bitcast<u32>(select(0i, _e5163, (_e5163 > 0i)))];
let _e5170 = (_e4800 + 17i);
let _e5172 = select(_e4803, _e5170, (_e5170 < _e4803));
let _e5178 = global_4.member[bitcast<u32>(select(0i, _e5172, (_e5172 > 0i)))];
let _e5194 = (_e926.member_1.member_3.x + _e4919);
let _e5197 = ((((((_e926.member_1.member_3.z + _e4838) * bitcast<i32>(_e4908)) + _e926.member_1.member_3.y) + _e4839) * bitcast<i32>(_e4915)) + (_e5194 >> bitcast<u32>(5i)));
let _e5201 = (bitcast<i32>(_e218) - 1i);
let _e5203 = select(_e5201, _e5197, (_e5197 < _e5201));
let _e5209 = global_6.member[bitcast<u32>(select(0i, _e5203, (_e5203 > 0i)))];
let _e5211 = (bitcast<i32>(_e216) - 1i);
let _e5213 = select(_e5211, _e5197, (_e5197 < _e5211));
let _e5219 = global_5.member[bitcast<u32>(select(0i, _e5213, (_e5213 > 0i)))];
let _e5228 = (bitcast<i32>((_e5209 + countOneBits((_e5219 & ((1u << bitcast<u32>((bitcast<u32>((_e5194 & 31i)) & 31u))) - 1u))))) * 14i);
let _e5229 = bitcast<u32>(_e5228);
if (_e5229 < _e220) {
let _e5233 = atomicAdd((&global_7.member[_e5229]), 1u);
}
let _e5235 = bitcast<u32>((_e5228 + 1i));
if (_e5235 < _e220) {
let _e5239 = atomicMax((&global_7.member[_e5235]), bitcast<u32>((_e4822 - select(0i, 1i, (_e4815 < f32(_e4822))))));
}
let _e5245 = (((_e5075 * _e5097) * 65536f) + 0.5f);
let _e5247 = select(-1073741800f, _e5245, (_e5245 > -1073741800f));
let _e5249 = select(1073741800f, _e5247, (_e5247 < 1073741800f));
let _e5256 = select(0i, select(select(i32(_e5249), i32(-2147483648), (_e5249 < -2147483600f)), 2147483647i, (_e5249 > 2147483500f)), (_e5249 == _e5249));
let _e5260 = (_e5256 - select(0i, 1i, (_e5249 < f32(_e5256))));
let _e5261 = bitcast<u32>(_e5260);
let _e5264 = bitcast<u32>((_e5260 >> bitcast<u32>(31i)));
if ((_e5261 | _e5264) == 0u) {
} else {
let _e5267 = bitcast<u32>((_e5228 + 2i));
if (_e5267 < _e220) {
let _e5271 = atomicAdd((&global_7.member[_e5267]), _e5261);
phi_16724_ = _e5271;
} else {
phi_16724_ = 0u;
}
let _e5273 = phi_16724_;
let _e5277 = (_e5264 + select(0u, 1u, ((_e5273 + _e5261) < _e5261)));
if (_e5277 == 0u) {
} else {
let _e5279 = (_e5267 + 1u);
if (_e5279 < _e220) {
let _e5283 = atomicAdd((&global_7.member[_e5279]), _e5277);
}
}
}
let _e5286 = (((_e5080 * _e5097) * 65536f) + 0.5f);
let _e5288 = select(-1073741800f, _e5286, (_e5286 > -1073741800f));
let _e5290 = select(1073741800f, _e5288, (_e5288 < 1073741800f));
let _e5297 = select(0i, select(select(i32(_e5290), i32(-2147483648), (_e5290 < -2147483600f)), 2147483647i, (_e5290 > 2147483500f)), (_e5290 == _e5290));
let _e5301 = (_e5297 - select(0i, 1i, (_e5290 < f32(_e5297))));
let _e5302 = bitcast<u32>(_e5301);
let _e5305 = bitcast<u32>((_e5301 >> bitcast<u32>(31i)));
if ((_e5302 | _e5305) == 0u) {
} else {
let _e5308 = bitcast<u32>((_e5228 + 4i));
if (_e5308 < _e220) {
let _e5312 = atomicAdd((&global_7.member[_e5308]), _e5302);
phi_16781_ = _e5312;
} else {
phi_16781_ = 0u;
}
let _e5314 = phi_16781_;
let _e5318 = (_e5305 + select(0u, 1u, ((_e5314 + _e5302) < _e5302)));
if (_e5318 == 0u) {
} else {
let _e5320 = (_e5308 + 1u);
if (_e5320 < _e220) {
let _e5324 = atomicAdd((&global_7.member[_e5320]), _e5318);
}
}
}
let _e5327 = (((_e5085 * _e5097) * 65536f) + 0.5f);
let _e5329 = select(-1073741800f, _e5327, (_e5327 > -1073741800f));
let _e5331 = select(1073741800f, _e5329, (_e5329 < 1073741800f));
let _e5338 = select(0i, select(select(i32(_e5331), i32(-2147483648), (_e5331 < -2147483600f)), 2147483647i, (_e5331 > 2147483500f)), (_e5331 == _e5331));
let _e5342 = (_e5338 - select(0i, 1i, (_e5331 < f32(_e5338))));
let _e5343 = bitcast<u32>(_e5342);
let _e5346 = bitcast<u32>((_e5342 >> bitcast<u32>(31i)));
if ((_e5343 | _e5346) == 0u) {
} else {
let _e5349 = bitcast<u32>((_e5228 + 6i));
if (_e5349 < _e220) {
let _e5353 = atomicAdd((&global_7.member[_e5349]), _e5343);
phi_16838_ = _e5353;
} else {
phi_16838_ = 0u;
}
let _e5355 = phi_16838_;
let _e5359 = (_e5346 + select(0u, 1u, ((_e5355 + _e5343) < _e5343)));
if (_e5359 == 0u) {
} else {
let _e5361 = (_e5349 + 1u);
if (_e5361 < _e220) {
let _e5365 = atomicAdd((&global_7.member[_e5361]), _e5359);
}
}
}
let _e5368 = (((((_e5106 * _e4988) + (_e5133 * _e4989)) + (_e5160 * _e4990)) * 65536f) + 0.5f);
let _e5370 = select(-1073741800f, _e5368, (_e5368 > -1073741800f));
let _e5372 = select(1073741800f, _e5370, (_e5370 < 1073741800f));
let _e5379 = select(0i, select(select(i32(_e5372), i32(-2147483648), (_e5372 < -2147483600f)), 2147483647i, (_e5372 > 2147483500f)), (_e5372 == _e5372));
let _e5383 = (_e5379 - select(0i, 1i, (_e5372 < f32(_e5379))));
let _e5384 = bitcast<u32>(_e5383);
let _e5387 = bitcast<u32>((_e5383 >> bitcast<u32>(31i)));
if ((_e5384 | _e5387) == 0u) {
} else {
let _e5390 = bitcast<u32>((_e5228 + 8i));
if (_e5390 < _e220) {
let _e5394 = atomicAdd((&global_7.member[_e5390]), _e5384);
phi_16896_ = _e5394;
} else {
phi_16896_ = 0u;
}
let _e5396 = phi_16896_;
let _e5400 = (_e5387 + select(0u, 1u, ((_e5396 + _e5384) < _e5384)));
if (_e5400 == 0u) {
} else {
let _e5402 = (_e5390 + 1u);
if (_e5402 < _e220) {
let _e5406 = atomicAdd((&global_7.member[_e5402]), _e5400);
}
}
}
let _e5409 = (((((_e5115 * _e4988) + (_e5142 * _e4989)) + (_e5169 * _e4990)) * 65536f) + 0.5f);
let _e5411 = select(-1073741800f, _e5409, (_e5409 > -1073741800f));
let _e5413 = select(1073741800f, _e5411, (_e5411 < 1073741800f));
let _e5420 = select(0i, select(select(i32(_e5413), i32(-2147483648), (_e5413 < -2147483600f)), 2147483647i, (_e5413 > 2147483500f)), (_e5413 == _e5413));
let _e5424 = (_e5420 - select(0i, 1i, (_e5413 < f32(_e5420))));
let _e5425 = bitcast<u32>(_e5424);
let _e5428 = bitcast<u32>((_e5424 >> bitcast<u32>(31i)));
if ((_e5425 | _e5428) == 0u) {
} else {
let _e5431 = bitcast<u32>((_e5228 + 10i));
if (_e5431 < _e220) {
let _e5435 = atomicAdd((&global_7.member[_e5431]), _e5425);
phi_16953_ = _e5435;
} else {
phi_16953_ = 0u;
}
let _e5437 = phi_16953_;
let _e5441 = (_e5428 + select(0u, 1u, ((_e5437 + _e5425) < _e5425)));
if (_e5441 == 0u) {
} else {
let _e5443 = (_e5431 + 1u);
if (_e5443 < _e220) {
let _e5447 = atomicAdd((&global_7.member[_e5443]), _e5441);
}
}
}
let _e5450 = (((((_e5124 * _e4988) + (_e5151 * _e4989)) + (_e5178 * _e4990)) * 65536f) + 0.5f);
let _e5452 = select(-1073741800f, _e5450, (_e5450 > -1073741800f));
let _e5454 = select(1073741800f, _e5452, (_e5452 < 1073741800f));
let _e5461 = select(0i, select(select(i32(_e5454), i32(-2147483648), (_e5454 < -2147483600f)), 2147483647i, (_e5454 > 2147483500f)), (_e5454 == _e5454));
let _e5465 = (_e5461 - select(0i, 1i, (_e5454 < f32(_e5461))));
let _e5466 = bitcast<u32>(_e5465);
let _e5469 = bitcast<u32>((_e5465 >> bitcast<u32>(31i)));
if ((_e5466 | _e5469) == 0u) {
} else {
let _e5472 = bitcast<u32>((_e5228 + 12i));
if (_e5472 < _e220) {
let _e5476 = atomicAdd((&global_7.member[_e5472]), _e5466);
phi_17010_ = _e5476;
} else {
phi_17010_ = 0u;
}
let _e5478 = phi_17010_;
let _e5482 = (_e5469 + select(0u, 1u, ((_e5478 + _e5466) < _e5466)));
if (_e5482 == 0u) {
} else {
let _e5484 = (_e5472 + 1u);
if (_e5484 < _e220) {
let _e5488 = atomicAdd((&global_7.member[_e5484]), _e5482);
}
}
}
phi_16194_ = (_e4919 + 1i);
} else {
phi_16194_ = i32();
}
let _e5491 = phi_16194_;
continue;
continuing {
phi_16193_ = _e5491;
break if !(_e4920);
}
}
phi_16067_ = (_e4836 + 1i);
} else {
phi_16067_ = i32();
}
let _e5495 = phi_16067_;
continue;
continuing {
phi_16066_ = _e5495;
break if !(_e4837);
}
}
phi_16050_ = (_e4829 + 1i);
} else {
phi_16050_ = i32();
}
let _e5499 = phi_16050_;
continue;
continuing {
phi_16049_ = _e5499;
break if !(_e4830);
}
}
} else {
if (_e952 == 3u) {
let _e2890 = (_e926.member_1.member_6 & 31u);
let _e2892 = (_e926.member_1.member_3.x << bitcast<u32>(_e2890));
let _e2895 = (_e926.member_1.member_7 & 31u);
let _e2899 = ((1i << bitcast<u32>(_e2895)) >> bitcast<u32>(1i));
let _e2905 = bitcast<i32>(_e926.member_1.member_6);
let _e2911 = bitcast<f32>((bitcast<u32>((127i + (bitcast<i32>(_e926.member_1.member_7) - _e2905))) << bitcast<u32>(23i)));
let _e2912 = (f32((((_e926.member_1.member.x - _e2892) + _e2899) >> bitcast<u32>(_e2895))) * _e2911);
let _e2917 = (_e926.member_1.member_3.y << bitcast<u32>(_e2890));
let _e2923 = (f32((((_e926.member_1.member.y - _e2917) + _e2899) >> bitcast<u32>(_e2895))) * _e2911);
let _e2928 = (_e926.member_1.member_3.z << bitcast<u32>(_e2890));
let _e2934 = (f32((((_e926.member_1.member.z - _e2928) + _e2899) >> bitcast<u32>(_e2895))) * _e2911);
let _e2942 = (f32((((_e926.member_1.member_1.x - _e2892) + _e2899) >> bitcast<u32>(_e2895))) * _e2911);
let _e2949 = (f32((((_e926.member_1.member_1.y - _e2917) + _e2899) >> bitcast<u32>(_e2895))) * _e2911);
let _e2956 = (f32((((_e926.member_1.member_1.z - _e2928) + _e2899) >> bitcast<u32>(_e2895))) * _e2911);
let _e2964 = (f32((((_e926.member_1.member_2.x - _e2892) + _e2899) >> bitcast<u32>(_e2895))) * _e2911);
let _e2971 = (f32((((_e926.member_1.member_2.y - _e2917) + _e2899) >> bitcast<u32>(_e2895))) * _e2911);
let _e2978 = (f32((((_e926.member_1.member_2.z - _e2928) + _e2899) >> bitcast<u32>(_e2895))) * _e2911);
let _e2986 = (f32(_e926.member_1.member_5) * bitcast<f32>((bitcast<u32>((127i - _e2905)) << bitcast<u32>(23i))));
let _e2987 = (_e2942 - _e2912);
let _e2988 = (_e2949 - _e2923);
let _e2989 = (_e2956 - _e2934);
let _e2990 = (_e2964 - _e2942);
let _e2991 = (_e2971 - _e2949);
let _e2992 = (_e2978 - _e2956);
let _e2995 = ((_e2988 * _e2992) - (_e2989 * _e2991));
let _e2999 = (_e2987 * _e2991);
let _e3000 = (_e2988 * _e2990);
let _e3001 = (_e2999 - _e3000);
let _e3009 = ((bitcast<f32>((bitcast<u32>(_e2999) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e3000) & 2147483647u))) * 2.3841858e-7f);
let _e3010 = f32(_e926.member_1.member_4.x);
let _e3011 = (1f + _e2986);
let _e3014 = (_e926.member_1.member_4.z >= _e926.member_1.member_4.y);
if _e3014 {
let _e3108 = select(1f, -1f, (_e2995 < 0f));
let _e3113 = ((_e2934 - _e2956) * _e3108);
let _e3114 = ((_e2956 - _e2978) * _e3108);
let _e3115 = ((_e2978 - _e2934) * _e3108);
let _e3116 = ((0f - 0f) * _e3108);
let _e3118 = (_e2988 * _e3108);
let _e3119 = (_e2991 * _e3108);
let _e3120 = ((_e2923 - _e2971) * _e3108);
if (select(0u, 1u, ((_e3113 * _e3011) > -((_e3113 * _e2986)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3114 * _e3011) > -((_e3114 * _e2986)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3115 * _e3011) > -((_e3115 * _e2986)))) < 2u) {
} else {
break;
}
let _e3144 = (select(0u, 1u, ((_e3116 * _e3011) > -((_e3116 * _e2986)))) < 2u);
if _e3144 {
} else {
break;
}
if (select(0u, 1u, ((_e3118 * _e3011) > -((_e3118 * _e2986)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3119 * _e3011) > -((_e3119 * _e2986)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3120 * _e3011) > -((_e3120 * _e2986)))) < 2u) {
} else {
break;
}
if _e3144 {
} else {
break;
}
if (select(0u, 1u, (_e3113 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3114 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3115 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3116 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3113 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3114 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3115 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3116 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3113 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3114 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3115 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3116 < 0f)) < 2u) {
} else {
break;
}
} else {
let _e3016 = select(1f, -1f, (-(_e2995) < 0f));
let _e3021 = ((_e2923 - _e2949) * _e3016);
let _e3022 = ((_e2949 - _e2971) * _e3016);
let _e3023 = ((_e2971 - _e2923) * _e3016);
let _e3024 = ((0f - 0f) * _e3016);
let _e3026 = (_e2989 * _e3016);
let _e3027 = (_e2992 * _e3016);
let _e3028 = ((_e2934 - _e2978) * _e3016);
if (select(0u, 1u, ((_e3021 * _e3011) > -((_e3021 * _e2986)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3022 * _e3011) > -((_e3022 * _e2986)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3023 * _e3011) > -((_e3023 * _e2986)))) < 2u) {
} else {
break;
}
let _e3052 = (select(0u, 1u, ((_e3024 * _e3011) > -((_e3024 * _e2986)))) < 2u);
if _e3052 {
} else {
break;
}
if (select(0u, 1u, ((_e3026 * _e3011) > -((_e3026 * _e2986)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3027 * _e3011) > -((_e3027 * _e2986)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3028 * _e3011) > -((_e3028 * _e2986)))) < 2u) {
} else {
break;
}
if _e3052 {
} else {
break;
}
if (select(0u, 1u, (_e3021 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3022 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3023 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3024 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3021 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3022 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3023 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3024 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3021 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3022 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3023 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3024 < 0f)) < 2u) {
} else {
break;
}
}
let _e3201 = select(1f, -1f, (_e3001 < 0f));
let _e3207 = select(0f, (2f * _e3009), (bitcast<f32>((bitcast<u32>(_e3001) & 2147483647u)) <= _e3009));
let _e3210 = (_e2971 - _e2923);
let _e3211 = (0f - 0f);
let _e3212 = ((_e2923 - _e2949) * _e3201);
let _e3213 = ((_e2949 - _e2971) * _e3201);
let _e3214 = (_e3210 * _e3201);
let _e3215 = (_e3211 * _e3201);
let _e3216 = (_e2912 - _e2964);
let _e3217 = (_e2987 * _e3201);
let _e3218 = (_e2990 * _e3201);
let _e3219 = (_e3216 * _e3201);
let _e3220 = (_e3212 * _e3011);
let _e3221 = (_e3213 * _e3011);
let _e3222 = (_e3214 * _e3011);
let _e3228 = -((_e3212 * _e2986));
let _e3229 = -((_e3213 * _e2986));
let _e3230 = -((_e3214 * _e2986));
local_82 = array<u32, 2>(0u, 4294967295u);
let _e3236 = select(0u, 1u, (_e3220 > _e3228));
if (_e3236 < 2u) {
} else {
break;
}
let _e3239 = local_82[_e3236];
local_83 = array<u32, 2>(0u, 4294967295u);
let _e3240 = select(0u, 1u, (_e3221 > _e3229));
if (_e3240 < 2u) {
} else {
break;
}
let _e3243 = local_83[_e3240];
local_84 = array<u32, 2>(0u, 4294967295u);
let _e3244 = select(0u, 1u, (_e3222 > _e3230));
if (_e3244 < 2u) {
} else {
break;
}
let _e3247 = local_84[_e3244];
let _e3249 = (select(0u, 1u, ((_e3215 * _e3011) > -((_e3215 * _e2986)))) < 2u);
if _e3249 {
} else {
break;
}
let _e3265 = (_e3217 * _e3011);
let _e3266 = (_e3218 * _e3011);
let _e3267 = (_e3219 * _e3011);
let _e3271 = -((_e3217 * _e2986));
let _e3272 = -((_e3218 * _e2986));
let _e3273 = -((_e3219 * _e2986));
local_79 = array<u32, 2>(0u, 4294967295u);
let _e3277 = select(0u, 1u, (_e3265 > _e3271));
if (_e3277 < 2u) {
} else {
break;
}
let _e3280 = local_79[_e3277];
local_80 = array<u32, 2>(0u, 4294967295u);
let _e3281 = select(0u, 1u, (_e3266 > _e3272));
if (_e3281 < 2u) {
} else {
break;
}
let _e3284 = local_80[_e3281];
local_81 = array<u32, 2>(0u, 4294967295u);
let _e3285 = select(0u, 1u, (_e3267 > _e3273));
if (_e3285 < 2u) {
} else {
break;
}
let _e3288 = local_81[_e3285];
if _e3249 {
} else {
break;
}
local_76 = array<u32, 2>(0u, 4294967295u);
let _e3314 = select(0u, 1u, (_e3212 == 0f));
if (_e3314 < 2u) {
} else {
break;
}
let _e3317 = local_76[_e3314];
local_77 = array<u32, 2>(0u, 4294967295u);
let _e3318 = select(0u, 1u, (_e3213 == 0f));
if (_e3318 < 2u) {
} else {
break;
}
let _e3321 = local_77[_e3318];
local_78 = array<u32, 2>(0u, 4294967295u);
let _e3322 = select(0u, 1u, (_e3214 == 0f));
if (_e3322 < 2u) {
} else {
break;
}
let _e3325 = local_78[_e3322];
if (select(0u, 1u, (_e3215 == 0f)) < 2u) {
} else {
break;
}
let _e3329 = ((_e3317 & 1u) != 0u);
let _e3332 = ((_e3321 & 1u) != 0u);
let _e3335 = ((_e3325 & 1u) != 0u);
let _e3337 = (-1f / select(_e3212, 1f, _e3329));
let _e3338 = (-1f / select(_e3213, 1f, _e3332));
let _e3339 = (-1f / select(_e3214, 1f, _e3335));
local_73 = array<u32, 2>(0u, 4294967295u);
let _e3344 = select(0u, 1u, (_e3212 > 0f));
if (_e3344 < 2u) {
} else {
break;
}
let _e3347 = local_73[_e3344];
local_74 = array<u32, 2>(0u, 4294967295u);
let _e3348 = select(0u, 1u, (_e3213 > 0f));
if (_e3348 < 2u) {
} else {
break;
}
let _e3351 = local_74[_e3348];
local_75 = array<u32, 2>(0u, 4294967295u);
let _e3352 = select(0u, 1u, (_e3214 > 0f));
if (_e3352 < 2u) {
} else {
break;
}
let _e3355 = local_75[_e3352];
if (select(0u, 1u, (_e3215 > 0f)) < 2u) {
} else {
break;
}
local_70 = array<u32, 2>(0u, 4294967295u);
let _e3362 = select(0u, 1u, (_e3212 < 0f));
if (_e3362 < 2u) {
} else {
break;
}
let _e3365 = local_70[_e3362];
local_71 = array<u32, 2>(0u, 4294967295u);
let _e3366 = select(0u, 1u, (_e3213 < 0f));
if (_e3366 < 2u) {
} else {
break;
}
let _e3369 = local_71[_e3366];
local_72 = array<u32, 2>(0u, 4294967295u);
let _e3370 = select(0u, 1u, (_e3214 < 0f));
if (_e3370 < 2u) {
} else {
break;
}
let _e3373 = local_72[_e3370];
if (select(0u, 1u, (_e3215 < 0f)) < 2u) {
} else {
break;
}
let _e3389 = ((_e3365 & 1u) != 0u);
let _e3392 = ((_e3369 & 1u) != 0u);
let _e3395 = ((_e3373 & 1u) != 0u);
let _e3401 = select(1f, -1f, (-(((_e2989 * _e2990) - (_e2987 * _e2992))) < 0f));
let _e3404 = (_e2978 - _e2934);
let _e3405 = ((_e2934 - _e2956) * _e3401);
let _e3406 = ((_e2956 - _e2978) * _e3401);
let _e3407 = (_e3404 * _e3401);
let _e3408 = (_e3211 * _e3401);
let _e3409 = (_e2987 * _e3401);
let _e3410 = (_e2990 * _e3401);
let _e3411 = (_e3216 * _e3401);
if (select(0u, 1u, ((_e3405 * _e3011) > -((_e3405 * _e2986)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3406 * _e3011) > -((_e3406 * _e2986)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3407 * _e3011) > -((_e3407 * _e2986)))) < 2u) {
} else {
break;
}
let _e3435 = (select(0u, 1u, ((_e3408 * _e3011) > -((_e3408 * _e2986)))) < 2u);
if _e3435 {
} else {
break;
}
if (select(0u, 1u, ((_e3409 * _e3011) > -((_e3409 * _e2986)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3410 * _e3011) > -((_e3410 * _e2986)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3411 * _e3011) > -((_e3411 * _e2986)))) < 2u) {
} else {
break;
}
if _e3435 {
} else {
break;
}
if (select(0u, 1u, (_e3405 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3406 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3407 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3408 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3405 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3406 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3407 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3408 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3405 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3406 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3407 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3408 < 0f)) < 2u) {
} else {
break;
}
let _e3490 = (_e2964 - _e2912);
let _e3492 = (_e926.member.member * 19i);
let _e3493 = (_e3492 + 18i);
let _e3495 = (bitcast<i32>(_e214) - 1i);
let _e3497 = select(_e3495, _e3493, (_e3493 < _e3495));
let _e3503 = global_4.member[bitcast<u32>(select(0i, _e3497, (_e3497 > 0i)))];
let _e3505 = select(0f, _e3503, (_e3503 > 0f));
let _e3507 = select(16777216f, _e3505, (_e3505 < 16777216f));
let _e3514 = select(0i, select(select(i32(_e3507), i32(-2147483648), (_e3507 < -2147483600f)), 2147483647i, (_e3507 > 2147483500f)), (_e3507 == _e3507));
phi_21027_ = _e926.member.member_1;
loop {
let _e3521 = phi_21027_;
let _e3522 = (_e3521 < _e926.member.member_2);
if _e3522 {
if _e3014 {
phi_21042_ = _e926.member_1.member_4.y;
} else {
phi_21042_ = _e926.member_1.member_4.z;
}
let _e3526 = phi_21042_;
phi_21044_ = 0i;
loop {
let _e3528 = phi_21044_;
let _e3529 = (_e3528 <= _e3526);
if _e3529 {
let _e3530 = select(_e3528, _e3521, _e3014);
let _e3531 = select(_e3521, _e3528, _e3014);
let _e3532 = f32(_e3531);
let _e3534 = f32(_e926.member_1.member_4.x);
let _e3538 = ((_e3217 * _e3532) + (((select(_e3228, _e3220, ((_e3239 & 1u) != 0u)) - (_e3212 * _e2912)) + (select(_e3271, _e3265, ((_e3280 & 1u) != 0u)) - (_e3217 * _e2923))) + _e3207));
let _e3539 = ((_e3218 * _e3532) + (((select(_e3229, _e3221, ((_e3243 & 1u) != 0u)) - (_e3213 * _e2942)) + (select(_e3272, _e3266, ((_e3284 & 1u) != 0u)) - (_e3218 * _e2949))) + _e3207));
let _e3540 = ((_e3219 * _e3532) + (((select(_e3230, _e3222, ((_e3247 & 1u) != 0u)) - (_e3214 * _e2964)) + (select(_e3273, _e3267, ((_e3288 & 1u) != 0u)) - (_e3219 * _e2971))) + _e3207));
let _e3541 = (_e3538 * select(0f, _e3337, ((_e3347 & 1u) != 0u)));
let _e3542 = (_e3539 * select(0f, _e3338, ((_e3351 & 1u) != 0u)));
let _e3543 = (_e3540 * select(0f, _e3339, ((_e3355 & 1u) != 0u)));
let _e3547 = ((_e3538 * select(select(0f, 1e20f, _e3329), _e3337, _e3389)) + select(_e3010, 0f, _e3389));
let _e3548 = ((_e3539 * select(select(0f, 1e20f, _e3332), _e3338, _e3392)) + select(_e3010, 0f, _e3392));
let _e3549 = ((_e3540 * select(select(0f, 1e20f, _e3335), _e3339, _e3395)) + select(_e3010, 0f, _e3395));
let _e3551 = select(_e3541, 0f, (0f > _e3541));
let _e3553 = select(_e3543, _e3542, (_e3542 > _e3543));
let _e3557 = select(_e3547, _e3534, (_e3534 < _e3547));
let _e3559 = select(_e3549, _e3548, (_e3548 < _e3549));
let _e3561 = select(_e3559, _e3557, (_e3557 < _e3559));
let _e3562 = -(select(_e3553, _e3551, (_e3551 > _e3553)));
let _e3564 = (-(_e3534) - 1f);
let _e3566 = select(_e3564, _e3562, (_e3562 > _e3564));
let _e3568 = select(0f, _e3566, (_e3566 < 0f));
let _e3575 = select(0i, select(select(i32(_e3568), i32(-2147483648), (_e3568 < -2147483600f)), 2147483647i, (_e3568 > 2147483500f)), (_e3568 == _e3568));
let _e3582 = select(-1f, _e3561, (_e3561 > -1f));
let _e3584 = select(_e3534, _e3582, (_e3582 < _e3534));
let _e3591 = select(0i, select(select(i32(_e3584), i32(-2147483648), (_e3584 < -2147483600f)), 2147483647i, (_e3584 > 2147483500f)), (_e3584 == _e3584));
let _e3600 = global_1.member.member_2.member_1;
let _e3607 = global_1.member.member_3;
phi_21171_ = -((_e3575 - select(0i, 1i, (_e3568 < f32(_e3575)))));
loop {
let _e3611 = phi_21171_;
let _e3612 = (_e3611 <= (_e3591 - select(0i, 1i, (_e3584 < f32(_e3591)))));
if _e3612 {
let _e3618 = ((f32(_e3611) + 0.5f) - _e2912);
let _e3619 = ((_e3532 + 0.5f) - _e2923);
let _e3620 = ((f32(_e3530) + 0.5f) - _e2934);
let _e3625 = (((_e2987 * _e2987) + (_e2988 * _e2988)) + (_e2989 * _e2989));
let _e3630 = (((_e2987 * _e3490) + (_e2988 * _e3210)) + (_e2989 * _e3404));
let _e3635 = (((_e3490 * _e3490) + (_e3210 * _e3210)) + (_e3404 * _e3404));
let _e3640 = (((_e3618 * _e2987) + (_e3619 * _e2988)) + (_e3620 * _e2989));
let _e3645 = (((_e3618 * _e3490) + (_e3619 * _e3210)) + (_e3620 * _e3404));
let _e3648 = ((_e3625 * _e3635) - (_e3630 * _e3630));
let _e3649 = (_e3648 > 0f);
let _e3652 = select(0f, (1f / select(1f, _e3648, _e3649)), _e3649);
let _e3656 = (((_e3635 * _e3640) - (_e3630 * _e3645)) * _e3652);
let _e3660 = (((_e3625 * _e3645) - (_e3630 * _e3640)) * _e3652);
let _e3662 = ((1f - _e3656) - _e3660);
let _e3664 = select(0f, _e3662, (_e3662 > 0f));
let _e3666 = select(16777216f, _e3664, (_e3664 < 16777216f));
let _e3668 = select(0f, _e3656, (_e3656 > 0f));
let _e3670 = select(16777216f, _e3668, (_e3668 < 16777216f));
let _e3672 = select(0f, _e3660, (_e3660 > 0f));
let _e3674 = select(16777216f, _e3672, (_e3672 < 16777216f));
let _e3676 = ((_e3666 + _e3670) + _e3674);
let _e3679 = (1f / select(0.5f, _e3676, (_e3676 > 0.5f)));
let _e3680 = (_e3666 * _e3679);
let _e3681 = (_e3670 * _e3679);
let _e3682 = (_e3674 * _e3679);
let _e3684 = select(_e3495, _e3492, (_e3492 < _e3495));
let _e3690 = global_4.member[bitcast<u32>(select(0i, _e3684, (_e3684 > 0i)))];
let _e3691 = (_e3492 + 1i);
let _e3693 = select(_e3495, _e3691, (_e3691 < _e3495));
let _e3699 = global_4.member[bitcast<u32>(select(0i, _e3693, (_e3693 > 0i)))];
let _e3700 = (_e3492 + 2i);
let _e3702 = select(_e3495, _e3700, (_e3700 < _e3495));
let _e3708 = global_4.member[bitcast<u32>(select(0i, _e3702, (_e3702 > 0i)))];
let _e3709 = (_e3492 + 3i);
let _e3711 = select(_e3495, _e3709, (_e3709 < _e3495));
let _e3717 = global_4.member[bitcast<u32>(select(0i, _e3711, (_e3711 > 0i)))];
let _e3718 = (_e3492 + 4i);
let _e3720 = select(_e3495, _e3718, (_e3718 < _e3495));
let _e3726 = global_4.member[bitcast<u32>(select(0i, _e3720, (_e3720 > 0i)))];
let _e3727 = (_e3492 + 5i);
let _e3729 = select(_e3495, _e3727, (_e3727 < _e3495));
let _e3735 = global_4.member[bitcast<u32>(select(0i, _e3729, (_e3729 > 0i)))];
let _e3736 = (_e3492 + 6i);
let _e3738 = select(_e3495, _e3736, (_e3736 < _e3495));
let _e3744 = global_4.member[bitcast<u32>(select(0i, _e3738, (_e3738 > 0i)))];
let _e3745 = (_e3492 + 7i);
let _e3747 = select(_e3495, _e3745, (_e3745 < _e3495));
let _e3753 = global_4.member[bitcast<u32>(select(0i, _e3747, (_e3747 > 0i)))];
let _e3754 = (_e3492 + 8i);
let _e3756 = select(_e3495, _e3754, (_e3754 < _e3495));
let _e3762 = global_4.member[bitcast<u32>(select(0i, _e3756, (_e3756 > 0i)))];
let _e3767 = (((_e3690 * _e3680) + (_e3717 * _e3681)) + (_e3744 * _e3682));
let _e3772 = (((_e3699 * _e3680) + (_e3726 * _e3681)) + (_e3753 * _e3682));
let _e3777 = (((_e3708 * _e3680) + (_e3735 * _e3681)) + (_e3762 * _e3682));
let _e3782 = (((_e3767 * _e3767) + (_e3772 * _e3772)) + (_e3777 * _e3777));
let _e3785 = sqrt(select(0f, _e3782, (_e3782 > 0f)));
let _e3786 = (_e3785 > 1e-6f);
let _e3789 = select(0f, (1f / select(1e-6f, _e3785, _e3786)), _e3786);
let _e3790 = (_e3492 + 9i);
let _e3792 = select(_e3495, _e3790, (_e3790 < _e3495));
let _e3798 = global_4.member[bitcast<u32>(select(0i, _e3792, (_e3792 > 0i)))];
let _e3799 = (_e3492 + 10i);
let _e3801 = select(_e3495, _e3799, (_e3799 < _e3495));
let _e3807 = global_4.member[bitcast<u32>(select(0i, _e3801, (_e3801 > 0i)))];
let _e3808 = (_e3492 + 11i);
let _e3810 = select(_e3495, _e3808, (_e3808 < _e3495));
let _e3816 = global_4.member[bitcast<u32>(select(0i, _e3810, (_e3810 > 0i)))];
let _e3817 = (_e3492 + 12i);
let _e3819 = select(_e3495, _e3817, (_e3817 < _e3495));
let _e3825 = global_4.member[bitcast<u32>(select(0i, _e3819, (_e3819 > 0i)))];
let _e3826 = (_e3492 + 13i);
let _e3828 = select(_e3495, _e3826, (_e3826 < _e3495));
let _e3834 = global_4.member[bitcast<u32>(select(0i, _e3828, (_e3828 > 0i)))];
let _e3835 = (_e3492 + 14i);
let _e3837 = select(_e3495, _e3835, (_e3835 < _e3495));
let _e3843 = global_4.member[bitcast<u32>(select(0i, _e3837, (_e3837 > 0i)))];
let _e3844 = (_e3492 + 15i);
let _e3846 = select(_e3495, _e3844, (_e3844 < _e3495));
let _e3852 = global_4.member[bitcast<u32>(select(0i, _e3846, (_e3846 > 0i)))];
let _e3853 = (_e3492 + 16i);
let _e3855 = select(_e3495, _e3853, (_e3853 < _e3495));
let _e3861 = global_4.member[bitcast<u32>(select(0i, _e3855, (_e3855 > 0i)))];
let _e3862 = (_e3492 + 17i);
let _e3864 = select(_e3495, _e3862, (_e3862 < _e3495));
let _e3870 = global_4.member[bitcast<u32>(select(0i, _e3864, (_e3864 > 0i)))];
let _e3886 = (_e926.member_1.member_3.x + _e3611);
let _e3889 = ((((((_e926.member_1.member_3.z + _e3530) * bitcast<i32>(_e3600)) + _e926.member_1.member_3.y) + _e3531) * bitcast<i32>(_e3607)) + (_e3886 >> bitcast<u32>(5i)));
let _e3893 = (bitcast<i32>(_e218) - 1i);
let _e3895 = select(_e3893, _e3889, (_e3889 < _e3893));
let _e3901 = global_6.member[bitcast<u32>(select(0i, _e3895, (_e3895 > 0i)))];
let _e3903 = (bitcast<i32>(_e216) - 1i);
let _e3905 = select(_e3903, _e3889, (_e3889 < _e3903));
let _e3911 = global_5.member[bitcast<u32>(select(0i, _e3905, (_e3905 > 0i)))];
let _e3920 = (bitcast<i32>((_e3901 + countOneBits((_e3911 & ((1u << bitcast<u32>((bitcast<u32>((_e3886 & 31i)) & 31u))) - 1u))))) * 14i);
let _e3921 = bitcast<u32>(_e3920);
if (_e3921 < _e220) {
let _e3925 = atomicAdd((&global_7.member[_e3921]), 1u);
}
let _e3927 = bitcast<u32>((_e3920 + 1i));
if (_e3927 < _e220) {
let _e3931 = atomicMax((&global_7.member[_e3927]), bitcast<u32>((_e3514 - select(0i, 1i, (_e3507 < f32(_e3514))))));
}
let _e3937 = (((_e3767 * _e3789) * 65536f) + 0.5f);
let _e3939 = select(-1073741800f, _e3937, (_e3937 > -1073741800f));
let _e3941 = select(1073741800f, _e3939, (_e3939 < 1073741800f));
let _e3948 = select(0i, select(select(i32(_e3941), i32(-2147483648), (_e3941 < -2147483600f)), 2147483647i, (_e3941 > 2147483500f)), (_e3941 == _e3941));
let _e3952 = (_e3948 - select(0i, 1i, (_e3941 < f32(_e3948))));
let _e3953 = bitcast<u32>(_e3952);
let _e3956 = bitcast<u32>((_e3952 >> bitcast<u32>(31i)));
if ((_e3953 | _e3956) == 0u) {
} else {
let _e3959 = bitcast<u32>((_e3920 + 2i));
if (_e3959 < _e220) {
let _e3963 = atomicAdd((&global_7.member[_e3959]), _e3953);
phi_21702_ = _e3963;
} else {
phi_21702_ = 0u;
}
let _e3965 = phi_21702_;
let _e3969 = (_e3956 + select(0u, 1u, ((_e3965 + _e3953) < _e3953)));
if (_e3969 == 0u) {
} else {
let _e3971 = (_e3959 + 1u);
if (_e3971 < _e220) {
let _e3975 = atomicAdd((&global_7.member[_e3971]), _e3969);
}
}
}
let _e3978 = (((_e3772 * _e3789) * 65536f) + 0.5f);
let _e3980 = select(-1073741800f, _e3978, (_e3978 > -1073741800f));
let _e3982 = select(1073741800f, _e3980, (_e3980 < 1073741800f));
let _e3989 = select(0i, select(select(i32(_e3982), i32(-2147483648), (_e3982 < -2147483600f)), 2147483647i, (_e3982 > 2147483500f)), (_e3982 == _e3982));
let _e3993 = (_e3989 - select(0i, 1i, (_e3982 < f32(_e3989))));
let _e3994 = bitcast<u32>(_e3993);
let _e3997 = bitcast<u32>((_e3993 >> bitcast<u32>(31i)));
if ((_e3994 | _e3997) == 0u) {
} else {
let _e4000 = bitcast<u32>((_e3920 + 4i));
if (_e4000 < _e220) {
let _e4004 = atomicAdd((&global_7.member[_e4000]), _e3994);
phi_21759_ = _e4004;
} else {
phi_21759_ = 0u;
}
let _e4006 = phi_21759_;
let _e4010 = (_e3997 + select(0u, 1u, ((_e4006 + _e3994) < _e3994)));
if (_e4010 == 0u) {
} else {
let _e4012 = (_e4000 + 1u);
if (_e4012 < _e220) {
let _e4016 = atomicAdd((&global_7.member[_e4012]), _e4010);
}
}
}
let _e4019 = (((_e3777 * _e3789) * 65536f) + 0.5f);
let _e4021 = select(-1073741800f, _e4019, (_e4019 > -1073741800f));
let _e4023 = select(1073741800f, _e4021, (_e4021 < 1073741800f));
let _e4030 = select(0i, select(select(i32(_e4023), i32(-2147483648), (_e4023 < -2147483600f)), 2147483647i, (_e4023 > 2147483500f)), (_e4023 == _e4023));
let _e4034 = (_e4030 - select(0i, 1i, (_e4023 < f32(_e4030))));
let _e4035 = bitcast<u32>(_e4034);
let _e4038 = bitcast<u32>((_e4034 >> bitcast<u32>(31i)));
if ((_e4035 | _e4038) == 0u) {
} else {
let _e4041 = bitcast<u32>((_e3920 + 6i));
if (_e4041 < _e220) {
let _e4045 = atomicAdd((&global_7.member[_e4041]), _e4035);
phi_21816_ = _e4045;
} else {
phi_21816_ = 0u;
}
let _e4047 = phi_21816_;
let _e4051 = (_e4038 + select(0u, 1u, ((_e4047 + _e4035) < _e4035)));
if (_e4051 == 0u) {
} else {
let _e4053 = (_e4041 + 1u);
if (_e4053 < _e220) {
let _e4057 = atomicAdd((&global_7.member[_e4053]), _e4051);
}
}
}
let _e4060 = (((((_e3798 * _e3680) + (_e3825 * _e3681)) + (_e3852 * _e3682)) * 65536f) + 0.5f);
let _e4062 = select(-1073741800f, _e4060, (_e4060 > -1073741800f));
let _e4064 = select(1073741800f, _e4062, (_e4062 < 1073741800f));
let _e4071 = select(0i, select(select(i32(_e4064), i32(-2147483648), (_e4064 < -2147483600f)), 2147483647i, (_e4064 > 2147483500f)), (_e4064 == _e4064));
let _e4075 = (_e4071 - select(0i, 1i, (_e4064 < f32(_e4071))));
let _e4076 = bitcast<u32>(_e4075);
let _e4079 = bitcast<u32>((_e4075 >> bitcast<u32>(31i)));
if ((_e4076 | _e4079) == 0u) {
} else {
let _e4082 = bitcast<u32>((_e3920 + 8i));
if (_e4082 < _e220) {
let _e4086 = atomicAdd((&global_7.member[_e4082]), _e4076);
phi_21874_ = _e4086;
} else {
phi_21874_ = 0u;
}
let _e4088 = phi_21874_;
let _e4092 = (_e4079 + select(0u, 1u, ((_e4088 + _e4076) < _e4076)));
if (_e4092 == 0u) {
} else {
let _e4094 = (_e4082 + 1u);
if (_e4094 < _e220) {
let _e4098 = atomicAdd((&global_7.member[_e4094]), _e4092);
}
}
}
let _e4101 = (((((_e3807 * _e3680) + (_e3834 * _e3681)) + (_e3861 * _e3682)) * 65536f) + 0.5f);
let _e4103 = select(-1073741800f, _e4101, (_e4101 > -1073741800f));
let _e4105 = select(1073741800f, _e4103, (_e4103 < 1073741800f));
let _e4112 = select(0i, select(select(i32(_e4105), i32(-2147483648), (_e4105 < -2147483600f)), 2147483647i, (_e4105 > 2147483500f)), (_e4105 == _e4105));
let _e4116 = (_e4112 - select(0i, 1i, (_e4105 < f32(_e4112))));
let _e4117 = bitcast<u32>(_e4116);
let _e4120 = bitcast<u32>((_e4116 >> bitcast<u32>(31i)));
if ((_e4117 | _e4120) == 0u) {
} else {
let _e4123 = bitcast<u32>((_e3920 + 10i));
if (_e4123 < _e220) {
let _e4127 = atomicAdd((&global_7.member[_e4123]), _e4117);
phi_21931_ = _e4127;
} else {
phi_21931_ = 0u;
}
let _e4129 = phi_21931_;
let _e4133 = (_e4120 + select(0u, 1u, ((_e4129 + _e4117) < _e4117)));
if (_e4133 == 0u) {
} else {
let _e4135 = (_e4123 + 1u);
if (_e4135 < _e220) {
let _e4139 = atomicAdd((&global_7.member[_e4135]), _e4133);
}
}
}
let _e4142 = (((((_e3816 * _e3680) + (_e3843 * _e3681)) + (_e3870 * _e3682)) * 65536f) + 0.5f);
let _e4144 = select(-1073741800f, _e4142, (_e4142 > -1073741800f));
let _e4146 = select(1073741800f, _e4144, (_e4144 < 1073741800f));
let _e4153 = select(0i, select(select(i32(_e4146), i32(-2147483648), (_e4146 < -2147483600f)), 2147483647i, (_e4146 > 2147483500f)), (_e4146 == _e4146));
let _e4157 = (_e4153 - select(0i, 1i, (_e4146 < f32(_e4153))));
let _e4158 = bitcast<u32>(_e4157);
let _e4161 = bitcast<u32>((_e4157 >> bitcast<u32>(31i)));
if ((_e4158 | _e4161) == 0u) {
} else {
let _e4164 = bitcast<u32>((_e3920 + 12i));
if (_e4164 < _e220) {
let _e4168 = atomicAdd((&global_7.member[_e4164]), _e4158);
phi_21988_ = _e4168;
} else {
phi_21988_ = 0u;
}
let _e4170 = phi_21988_;
let _e4174 = (_e4161 + select(0u, 1u, ((_e4170 + _e4158) < _e4158)));
if (_e4174 == 0u) {
} else {
let _e4176 = (_e4164 + 1u);
if (_e4176 < _e220) {
let _e4180 = atomicAdd((&global_7.member[_e4176]), _e4174);
}
}
}
phi_21172_ = (_e3611 + 1i);
} else {
phi_21172_ = i32();
}
let _e4183 = phi_21172_;
continue;
continuing {
phi_21171_ = _e4183;
break if !(_e3612);
}
}
phi_21045_ = (_e3528 + 1i);
} else {
phi_21045_ = i32();
}
let _e4187 = phi_21045_;
continue;
continuing {
phi_21044_ = _e4187;
break if !(_e3529);
}
}
phi_21028_ = (_e3521 + 1i);
} else {
phi_21028_ = i32();
}
let _e4191 = phi_21028_;
continue;
continuing {
phi_21027_ = _e4191;
break if !(_e3522);
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
let _e2645 = bitcast<u32>(_e2644);
let _e2648 = bitcast<u32>((_e2644 >> bitcast<u32>(31i)));
if ((_e2645 | _e2648) == 0u) {
} else {
let _e2651 = bitcast<u32>((_e2612 + 2i));
if (_e2651 < _e220) {
let _e2655 = atomicAdd((&global_7.member[_e2651]), _e2645);
phi_26905_ = _e2655;
} else {
phi_26905_ = 0u;
}
let _e2657 = phi_26905_;
let _e2661 = (_e2648 + select(0u, 1u, ((_e2657 + _e2645) < _e2645)));
if (_e2661 == 0u) {
} else {
let _e2663 = (_e2651 + 1u);
if (_e2663 < _e220) {
let _e2667 = atomicAdd((&global_7.member[_e2663]), _e2661);
}
}
}
let _e2670 = (((_e2464 * _e2481) * 65536f) + 0.5f);
let _e2672 = select(-1073741800f, _e2670, (_e2670 > -1073741800f));
let _e2674 = select(1073741800f, _e2672, (_e2672 < 1073741800f));
let _e2681 = select(0i, select(select(i32(_e2674), i32(-2147483648), (_e2674 < -2147483600f)), 2147483647i, (_e2674 > 2147483500f)), (_e2674 == _e2674));
let _e2685 = (_e2681 - select(0i, 1i, (_e2674 < f32(_e2681))));
let _e2686 = bitcast<u32>(_e2685);
let _e2689 = bitcast<u32>((_e2685 >> bitcast<u32>(31i)));
if ((_e2686 | _e2689) == 0u) {
} else {
let _e2692 = bitcast<u32>((_e2612 + 4i));
if (_e2692 < _e220) {
let _e2696 = atomicAdd((&global_7.member[_e2692]), _e2686);
phi_26962_ = _e2696;
} else {
phi_26962_ = 0u;
}
let _e2698 = phi_26962_;
let _e2702 = (_e2689 + select(0u, 1u, ((_e2698 + _e2686) < _e2686)));
if (_e2702 == 0u) {
} else {
let _e2704 = (_e2692 + 1u);
if (_e2704 < _e220) {
let _e2708 = atomicAdd((&global_7.member[_e2704]), _e2702);
}
}
}
let _e2711 = (((_e2469 * _e2481) * 65536f) + 0.5f);
let _e2713 = select(-1073741800f, _e2711, (_e2711 > -1073741800f));
let _e2715 = select(1073741800f, _e2713, (_e2713 < 1073741800f));
let _e2722 = select(0i, select(select(i32(_e2715), i32(-2147483648), (_e2715 < -2147483600f)), 2147483647i, (_e2715 > 2147483500f)), (_e2715 == _e2715));
let _e2726 = (_e2722 - select(0i, 1i, (_e2715 < f32(_e2722))));
let _e2727 = bitcast<u32>(_e2726);
let _e2730 = bitcast<u32>((_e2726 >> bitcast<u32>(31i)));
if ((_e2727 | _e2730) == 0u) {
} else {
let _e2733 = bitcast<u32>((_e2612 + 6i));
if (_e2733 < _e220) {
let _e2737 = atomicAdd((&global_7.member[_e2733]), _e2727);
phi_27019_ = _e2737;
} else {
phi_27019_ = 0u;
}
let _e2739 = phi_27019_;
let _e2743 = (_e2730 + select(0u, 1u, ((_e2739 + _e2727) < _e2727)));
if (_e2743 == 0u) {
} else {
let _e2745 = (_e2733 + 1u);
if (_e2745 < _e220) {
let _e2749 = atomicAdd((&global_7.member[_e2745]), _e2743);
}
}
}
let _e2752 = (((((_e2490 * _e2372) + (_e2517 * _e2373)) + (_e2544 * _e2374)) * 65536f) + 0.5f);
let _e2754 = select(-1073741800f, _e2752, (_e2752 > -1073741800f));
let _e2756 = select(1073741800f, _e2754, (_e2754 < 1073741800f));
let _e2763 = select(0i, select(select(i32(_e2756), i32(-2147483648), (_e2756 < -2147483600f)), 2147483647i, (_e2756 > 2147483500f)), (_e2756 == _e2756));
let _e2767 = (_e2763 - select(0i, 1i, (_e2756 < f32(_e2763))));
let _e2768 = bitcast<u32>(_e2767);
let _e2771 = bitcast<u32>((_e2767 >> bitcast<u32>(31i)));
if ((_e2768 | _e2771) == 0u) {
} else {
let _e2774 = bitcast<u32>((_e2612 + 8i));
if (_e2774 < _e220) {
let _e2778 = atomicAdd((&global_7.member[_e2774]), _e2768);
phi_27077_ = _e2778;
} else {
phi_27077_ = 0u;
}
let _e2780 = phi_27077_;
let _e2784 = (_e2771 + select(0u, 1u, ((_e2780 + _e2768) < _e2768)));
if (_e2784 == 0u) {
} else {
let _e2786 = (_e2774 + 1u);
if (_e2786 < _e220) {
let _e2790 = atomicAdd((&global_7.member[_e2786]), _e2784);
}
}
}
let _e2793 = (((((_e2499 * _e2372) + (_e2526 * _e2373)) + (_e2553 * _e2374)) * 65536f) + 0.5f);
let _e2795 = select(-1073741800f, _e2793, (_e2793 > -1073741800f));
let _e2797 = select(1073741800f, _e2795, (_e2795 < 1073741800f));
let _e2804 = select(0i, select(select(i32(_e2797), i32(-2147483648), (_e2797 < -2147483600f)), 2147483647i, (_e2797 > 2147483500f)), (_e2797 == _e2797));
let _e2808 = (_e2804 - select(0i, 1i, (_e2797 < f32(_e2804))));
let _e2809 = bitcast<u32>(_e2808);
let _e2812 = bitcast<u32>((_e2808 >> bitcast<u32>(31i)));
if ((_e2809 | _e2812) == 0u) {
} else {
let _e2815 = bitcast<u32>((_e2612 + 10i));
if (_e2815 < _e220) {
let _e2819 = atomicAdd((&global_7.member[_e2815]), _e2809);
phi_27134_ = _e2819;
} else {
phi_27134_ = 0u;
}
let _e2821 = phi_27134_;
let _e2825 = (_e2812 + select(0u, 1u, ((_e2821 + _e2809) < _e2809)));
if (_e2825 == 0u) {
} else {
let _e2827 = (_e2815 + 1u);
if (_e2827 < _e220) {
let _e2831 = atomicAdd((&global_7.member[_e2827]), _e2825);
}
}
}
let _e2834 = (((((_e2508 * _e2372) + (_e2535 * _e2373)) + (_e2562 * _e2374)) * 65536f) + 0.5f);
let _e2836 = select(-1073741800f, _e2834, (_e2834 > -1073741800f));
let _e2838 = select(1073741800f, _e2836, (_e2836 < 1073741800f));
let _e2845 = select(0i, select(select(i32(_e2838), i32(-2147483648), (_e2838 < -2147483600f)), 2147483647i, (_e2838 > 2147483500f)), (_e2838 == _e2838));
let _e2849 = (_e2845 - select(0i, 1i, (_e2838 < f32(_e2845))));
let _e2850 = bitcast<u32>(_e2849);
let _e2853 = bitcast<u32>((_e2849 >> bitcast<u32>(31i)));
if ((_e2850 | _e2853) == 0u) {
} else {
let _e2856 = bitcast<u32>((_e2612 + 12i));
if (_e2856 < _e220) {
let _e2860 = atomicAdd((&global_7.member[_e2856]), _e2850);
phi_27191_ = _e2860;
} else {
phi_27191_ = 0u;
}
let _e2862 = phi_27191_;
let _e2866 = (_e2853 + select(0u, 1u, ((_e2862 + _e2850) < _e2850)));
if (_e2866 == 0u) {
} else {
let _e2868 = (_e2856 + 1u);
if (_e2868 < _e220) {
let _e2872 = atomicAdd((&global_7.member[_e2868]), _e2866);
}
}
}
phi_26375_ = (_e2304 + 1i);
} else {
phi_26375_ = i32();
}
let _e2875 = phi_26375_;
continue;
continuing {
phi_26374_ = _e2875;
break if !(_e2305);
}
}
phi_26137_ = (_e2160 + 1i);
} else {
phi_26137_ = i32();
}
let _e2879 = phi_26137_;
continue;
continuing {
phi_26136_ = _e2879;
break if !(_e2161);
}
}
phi_26002_ = (_e2070 + 1i);
} else {
phi_26002_ = i32();
}
let _e2883 = phi_26002_;
continue;
continuing {
phi_26001_ = _e2883;
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
