struct type_5 {
member: array<f32>,
}
struct type_9 {
member: array<u32>,
}
struct type_10 {
member: vec4<u32>,
member_1: vec4<u32>,
member_2: vec4<u32>,
member_3: vec4<u32>,
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
var phi_1401_: i32;
var phi_2032_: u32;
var phi_2066_: i32;
var phi_2080_: i32;
var phi_2094_: i32;
var phi_2109_: i32;
var phi_2123_: i32;
var phi_2137_: i32;
var phi_1678_: u32;
var phi_1712_: i32;
var phi_1726_: i32;
var phi_1740_: i32;
var phi_1755_: i32;
var phi_1769_: i32;
var phi_1783_: i32;
var phi_2143_: type_14;
var phi_1183_: u32;
var phi_1217_: i32;
var phi_1231_: i32;
var phi_1245_: i32;
var phi_1260_: i32;
var phi_1274_: i32;
var phi_1288_: i32;
var phi_829_: u32;
var phi_863_: i32;
var phi_877_: i32;
var phi_891_: i32;
var phi_906_: i32;
var phi_920_: i32;
var phi_934_: i32;
var phi_1294_: type_14;
var phi_1334_: bool;
var phi_1350_: i32;
var phi_2145_: type_16;
var phi_2178_: u32;
var phi_2179_: u32;
var phi_2180_: u32;
var phi_24058_: type_18;
var phi_26015_: i32;
var phi_26030_: i32;
var phi_26150_: i32;
var phi_26389_: i32;
var phi_26917_: u32;
var phi_26974_: u32;
var phi_27031_: u32;
var phi_27089_: u32;
var phi_27146_: u32;
var phi_27203_: u32;
var phi_26390_: i32;
var phi_26151_: i32;
var phi_26016_: i32;
var phi_21040_: i32;
var phi_21055_: i32;
var phi_21057_: i32;
var phi_21185_: i32;
var phi_21713_: u32;
var phi_21770_: u32;
var phi_21827_: u32;
var phi_21885_: u32;
var phi_21942_: u32;
var phi_21999_: u32;
var phi_21186_: i32;
var phi_21058_: i32;
var phi_21041_: i32;
var phi_16061_: i32;
var phi_16076_: i32;
var phi_16078_: i32;
var phi_16206_: i32;
var phi_16734_: u32;
var phi_16791_: u32;
var phi_16848_: u32;
var phi_16906_: u32;
var phi_16963_: u32;
var phi_17020_: u32;
var phi_16207_: i32;
var phi_16079_: i32;
var phi_16062_: i32;
var phi_9104_: type_18;
var phi_11061_: i32;
var phi_11076_: i32;
var phi_11196_: i32;
var phi_11227_: i32;
var phi_11755_: u32;
var phi_11812_: u32;
var phi_11869_: u32;
var phi_11927_: u32;
var phi_11984_: u32;
var phi_12041_: u32;
var phi_11228_: i32;
var phi_11197_: i32;
var phi_11062_: i32;
var phi_6179_: i32;
var phi_6194_: i32;
var phi_6196_: i32;
var phi_6227_: i32;
var phi_6755_: u32;
var phi_6812_: u32;
var phi_6869_: u32;
var phi_6927_: u32;
var phi_6984_: u32;
var phi_7041_: u32;
var phi_6228_: i32;
var phi_6197_: i32;
var phi_6180_: i32;
switch bitcast<i32>(0u) {
default: {
let _e207 = global;
let _e210 = arrayLength((&global_2.member));
let _e214 = arrayLength((&global_4.member));
let _e216 = arrayLength((&global_5.member));
let _e218 = arrayLength((&global_6.member));
let _e220 = arrayLength((&global_7.member));
let _e224 = global_1.member.member[0u];
let _e228 = global_1.member.member[1u];
if (_e207.x < _e224) {
if (_e207.y < _e228) {
let _e236 = global_1.member.member[2u];
if (_e236 == 0u) {
let _e599 = ((_e207.y * _e224) + _e207.x);
let _e600 = bitcast<i32>(_e599);
let _e601 = (_e600 * 9i);
let _e603 = (bitcast<i32>(_e210) - 9i);
if (_e601 < _e603) {
local_141 = _e601;
} else {
local_141 = _e603;
}
let _e605 = local_141;
if (_e605 < 0i) {
let _e815 = global_1.member.member_3[0u];
let _e819 = global_1.member.member_3[1u];
let _e820 = bitcast<i32>(_e819);
let _e822 = (_e815 & 31u);
let _e825 = ((2i * _e820) + (2i << bitcast<u32>(_e822)));
if ((_e825 >> bitcast<u32>(22u)) == 0i) {
phi_829_ = 0u;
} else {
let _e830 = (_e825 >> bitcast<u32>(16i));
let _e831 = (_e830 == 0i);
phi_829_ = ((((bitcast<u32>(f32(select(_e830, _e825, _e831))) >> bitcast<u32>(23i)) - 127u) + select(16u, 0u, _e831)) + 4294967275u);
}
let _e842 = phi_829_;
let _e852 = (((_e820 + 1i) + ((1i << bitcast<u32>((_e842 & 31u))) >> bitcast<u32>(1i))) + (_e825 >> bitcast<u32>(19i)));
let _e853 = (_e852 + 1i);
let _e857 = global_1.member.member_1[0u];
let _e858 = bitcast<i32>(_e857);
let _e862 = global_1.member.member_1[1u];
let _e863 = bitcast<i32>(_e862);
let _e867 = global_1.member.member_1[2u];
let _e868 = bitcast<i32>(_e867);
let _e871 = ((-1i - _e852) >> bitcast<u32>(_e822));
let _e873 = select(0i, _e871, (_e871 > 0i));
if (_e873 < _e858) {
phi_863_ = _e873;
} else {
phi_863_ = (_e858 - 1i);
}
let _e877 = phi_863_;
if (_e873 < _e863) {
phi_877_ = _e873;
} else {
phi_877_ = (_e863 - 1i);
}
let _e881 = phi_877_;
if (_e873 < _e868) {
phi_891_ = _e873;
} else {
phi_891_ = (_e868 - 1i);
}
let _e885 = phi_891_;
let _e888 = (_e853 >> bitcast<u32>(_e822));
let _e890 = select(0i, _e888, (_e888 > 0i));
if (_e890 < _e858) {
phi_906_ = _e890;
} else {
phi_906_ = (_e858 - 1i);
}
let _e894 = phi_906_;
if (_e890 < _e863) {
phi_920_ = _e890;
} else {
phi_920_ = (_e863 - 1i);
}
let _e898 = phi_920_;
if (_e890 < _e868) {
phi_934_ = _e890;
} else {
phi_934_ = (_e868 - 1i);
}
let _e902 = phi_934_;
phi_1294_ = type_14(vec3<i32>(0i, 0i, 0i), vec3<i32>(0i, 0i, 0i), vec3<i32>(0i, 0i, 0i), vec3<i32>(_e877, _e881, _e885), vec3<i32>((_e894 - _e877), (_e898 - _e881), (_e902 - _e885)), _e853, _e815, _e842);
} else {
let _e607 = local_141;
let _e610 = global_2.member[bitcast<u32>(_e607)];
let _e611 = bitcast<i32>(_e610);
let _e612 = local_141;
let _e616 = global_2.member[bitcast<u32>((_e612 + 1i))];
let _e617 = bitcast<i32>(_e616);
let _e618 = local_141;
let _e622 = global_2.member[bitcast<u32>((_e618 + 2i))];
let _e623 = bitcast<i32>(_e622);
let _e625 = local_141;
let _e629 = global_2.member[bitcast<u32>((_e625 + 3i))];
let _e630 = bitcast<i32>(_e629);
let _e631 = local_141;
let _e635 = global_2.member[bitcast<u32>((_e631 + 4i))];
let _e636 = bitcast<i32>(_e635);
let _e637 = local_141;
let _e641 = global_2.member[bitcast<u32>((_e637 + 5i))];
let _e642 = bitcast<i32>(_e641);
let _e644 = local_141;
let _e648 = global_2.member[bitcast<u32>((_e644 + 6i))];
let _e649 = bitcast<i32>(_e648);
let _e650 = local_141;
let _e654 = global_2.member[bitcast<u32>((_e650 + 7i))];
let _e655 = bitcast<i32>(_e654);
let _e656 = local_141;
let _e660 = global_2.member[bitcast<u32>((_e656 + 8i))];
let _e661 = bitcast<i32>(_e660);
let _e666 = global_1.member.member_3[0u];
let _e670 = global_1.member.member_3[1u];
let _e671 = bitcast<i32>(_e670);
let _e673 = select(_e630, _e611, (_e611 < _e630));
let _e675 = select(_e636, _e617, (_e617 < _e636));
let _e677 = select(_e642, _e623, (_e623 < _e642));
let _e679 = select(_e649, _e673, (_e673 < _e649));
let _e681 = select(_e655, _e675, (_e675 < _e655));
let _e683 = select(_e661, _e677, (_e677 < _e661));
let _e685 = select(_e630, _e611, (_e611 > _e630));
let _e687 = select(_e636, _e617, (_e617 > _e636));
let _e689 = select(_e642, _e623, (_e623 > _e642));
let _e691 = select(_e649, _e685, (_e685 > _e649));
let _e693 = select(_e655, _e687, (_e687 > _e655));
let _e695 = select(_e661, _e689, (_e689 > _e661));
let _e696 = (_e691 - _e679);
let _e697 = (_e693 - _e681);
let _e698 = (_e695 - _e683);
let _e700 = select(_e697, _e696, (_e696 > _e697));
let _e705 = (_e666 & 31u);
let _e708 = ((select(_e698, _e700, (_e700 > _e698)) + (2i * _e671)) + (2i << bitcast<u32>(_e705)));
if ((_e708 >> bitcast<u32>(22u)) == 0i) {
phi_1183_ = 0u;
} else {
let _e713 = (_e708 >> bitcast<u32>(16i));
let _e714 = (_e713 == 0i);
phi_1183_ = ((((bitcast<u32>(f32(select(_e713, _e708, _e714))) >> bitcast<u32>(23i)) - 127u) + select(16u, 0u, _e714)) + 4294967275u);
}
let _e725 = phi_1183_;
let _e736 = ((((_e671 + 1i) + ((1i << bitcast<u32>((_e725 & 31u))) >> bitcast<u32>(1i))) + (_e708 >> bitcast<u32>(19i))) + 1i);
let _e740 = global_1.member.member_1[0u];
let _e741 = bitcast<i32>(_e740);
let _e745 = global_1.member.member_1[1u];
let _e746 = bitcast<i32>(_e745);
let _e750 = global_1.member.member_1[2u];
let _e751 = bitcast<i32>(_e750);
let _e754 = ((_e679 - _e736) >> bitcast<u32>(_e705));
let _e756 = select(0i, _e754, (_e754 > 0i));
if (_e756 < _e741) {
phi_1217_ = _e756;
} else {
phi_1217_ = (_e741 - 1i);
}
let _e760 = phi_1217_;
let _e763 = ((_e681 - _e736) >> bitcast<u32>(_e705));
let _e765 = select(0i, _e763, (_e763 > 0i));
if (_e765 < _e746) {
phi_1231_ = _e765;
} else {
phi_1231_ = (_e746 - 1i);
}
let _e769 = phi_1231_;
let _e772 = ((_e683 - _e736) >> bitcast<u32>(_e705));
let _e774 = select(0i, _e772, (_e772 > 0i));
if (_e774 < _e751) {
phi_1245_ = _e774;
} else {
phi_1245_ = (_e751 - 1i);
}
let _e778 = phi_1245_;
let _e782 = ((_e691 + _e736) >> bitcast<u32>(_e705));
let _e784 = select(0i, _e782, (_e782 > 0i));
if (_e784 < _e741) {
phi_1260_ = _e784;
} else {
phi_1260_ = (_e741 - 1i);
}
let _e788 = phi_1260_;
let _e791 = ((_e693 + _e736) >> bitcast<u32>(_e705));
let _e793 = select(0i, _e791, (_e791 > 0i));
if (_e793 < _e746) {
phi_1274_ = _e793;
} else {
phi_1274_ = (_e746 - 1i);
}
let _e797 = phi_1274_;
let _e800 = ((_e695 + _e736) >> bitcast<u32>(_e705));
let _e802 = select(0i, _e800, (_e800 > 0i));
if (_e802 < _e751) {
phi_1288_ = _e802;
} else {
phi_1288_ = (_e751 - 1i);
}
let _e806 = phi_1288_;
phi_1294_ = type_14(vec3<i32>(_e611, _e617, _e623), vec3<i32>(_e630, _e636, _e642), vec3<i32>(_e649, _e655, _e661), vec3<i32>(_e760, _e769, _e778), vec3<i32>((_e788 - _e760), (_e797 - _e769), (_e806 - _e778)), _e736, _e666, _e725);
}
let _e909 = phi_1294_;
let _e913 = global_1.member.member[3u];
let _e919 = (_e909.member_4.z >= _e909.member_4.y);
let _e921 = (1i + select(_e909.member_4.y, _e909.member_4.z, _e919));
if (_e921 == 1i) {
phi_1334_ = true;
} else {
phi_1334_ = ((_e921 * (1i + select(_e909.member_4.z, _e909.member_4.y, _e919))) <= 32i);
}
let _e928 = phi_1334_;
if ((_e599 < _e913) && _e928) {
phi_1350_ = _e921;
} else {
phi_1350_ = 0i;
}
let _e931 = phi_1350_;
phi_2145_ = type_16(type_15(_e600, 0i, _e931), _e909);
} else {
let _e239 = ((_e207.y * _e224) + _e207.x);
let _e243 = global_1.member.member[3u];
let _e245 = bitcast<i32>((_e239 * 3u));
let _e246 = (_e245 + 1i);
let _e248 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e250 = select(_e248, _e246, (_e246 < _e248));
let _e256 = global_3.member[bitcast<u32>(select(0i, _e250, (_e250 > 0i)))];
let _e257 = bitcast<i32>(_e256);
if (_e239 < _e243) {
let _e259 = (_e245 + 2i);
let _e261 = select(_e248, _e259, (_e259 < _e248));
let _e267 = global_3.member[bitcast<u32>(select(0i, _e261, (_e261 > 0i)))];
phi_1401_ = bitcast<i32>(_e267);
} else {
phi_1401_ = 0i;
}
let _e270 = phi_1401_;
let _e272 = select(_e248, _e245, (_e245 < _e248));
let _e278 = global_3.member[bitcast<u32>(select(0i, _e272, (_e272 > 0i)))];
let _e284 = global_1.member.member_3[2u];
let _e286 = (bitcast<i32>(_e278) + bitcast<i32>(_e284));
let _e288 = (_e286 * 9i);
let _e290 = (bitcast<i32>(_e210) - 9i);
if (_e288 < _e290) {
local_140 = _e288;
} else {
local_140 = _e290;
}
let _e292 = local_140;
if (_e292 < 0i) {
let _e502 = global_1.member.member_3[0u];
let _e506 = global_1.member.member_3[1u];
let _e507 = bitcast<i32>(_e506);
let _e509 = (_e502 & 31u);
let _e512 = ((2i * _e507) + (2i << bitcast<u32>(_e509)));
if ((_e512 >> bitcast<u32>(22u)) == 0i) {
phi_1678_ = 0u;
} else {
let _e517 = (_e512 >> bitcast<u32>(16i));
let _e518 = (_e517 == 0i);
phi_1678_ = ((((bitcast<u32>(f32(select(_e517, _e512, _e518))) >> bitcast<u32>(23i)) - 127u) + select(16u, 0u, _e518)) + 4294967275u);
}
let _e529 = phi_1678_;
let _e539 = (((_e507 + 1i) + ((1i << bitcast<u32>((_e529 & 31u))) >> bitcast<u32>(1i))) + (_e512 >> bitcast<u32>(19i)));
let _e540 = (_e539 + 1i);
let _e544 = global_1.member.member_1[0u];
let _e545 = bitcast<i32>(_e544);
let _e549 = global_1.member.member_1[1u];
let _e550 = bitcast<i32>(_e549);
let _e554 = global_1.member.member_1[2u];
let _e555 = bitcast<i32>(_e554);
let _e558 = ((-1i - _e539) >> bitcast<u32>(_e509));
let _e560 = select(0i, _e558, (_e558 > 0i));
if (_e560 < _e545) {
phi_1712_ = _e560;
} else {
phi_1712_ = (_e545 - 1i);
}
let _e564 = phi_1712_;
if (_e560 < _e550) {
phi_1726_ = _e560;
} else {
phi_1726_ = (_e550 - 1i);
}
let _e568 = phi_1726_;
if (_e560 < _e555) {
phi_1740_ = _e560;
} else {
phi_1740_ = (_e555 - 1i);
}
let _e572 = phi_1740_;
let _e575 = (_e540 >> bitcast<u32>(_e509));
let _e577 = select(0i, _e575, (_e575 > 0i));
if (_e577 < _e545) {
phi_1755_ = _e577;
} else {
phi_1755_ = (_e545 - 1i);
}
let _e581 = phi_1755_;
if (_e577 < _e550) {
phi_1769_ = _e577;
} else {
phi_1769_ = (_e550 - 1i);
}
let _e585 = phi_1769_;
if (_e577 < _e555) {
phi_1783_ = _e577;
} else {
phi_1783_ = (_e555 - 1i);
}
let _e589 = phi_1783_;
phi_2143_ = type_14(vec3<i32>(0i, 0i, 0i), vec3<i32>(0i, 0i, 0i), vec3<i32>(0i, 0i, 0i), vec3<i32>(_e564, _e568, _e572), vec3<i32>((_e581 - _e564), (_e585 - _e568), (_e589 - _e572)), _e540, _e502, _e529);
} else {
let _e294 = local_140;
let _e297 = global_2.member[bitcast<u32>(_e294)];
let _e298 = bitcast<i32>(_e297);
let _e299 = local_140;
let _e303 = global_2.member[bitcast<u32>((_e299 + 1i))];
let _e304 = bitcast<i32>(_e303);
let _e305 = local_140;
let _e309 = global_2.member[bitcast<u32>((_e305 + 2i))];
let _e310 = bitcast<i32>(_e309);
let _e312 = local_140;
let _e316 = global_2.member[bitcast<u32>((_e312 + 3i))];
let _e317 = bitcast<i32>(_e316);
let _e318 = local_140;
let _e322 = global_2.member[bitcast<u32>((_e318 + 4i))];
let _e323 = bitcast<i32>(_e322);
let _e324 = local_140;
let _e328 = global_2.member[bitcast<u32>((_e324 + 5i))];
let _e329 = bitcast<i32>(_e328);
let _e331 = local_140;
let _e335 = global_2.member[bitcast<u32>((_e331 + 6i))];
let _e336 = bitcast<i32>(_e335);
let _e337 = local_140;
let _e341 = global_2.member[bitcast<u32>((_e337 + 7i))];
let _e342 = bitcast<i32>(_e341);
let _e343 = local_140;
let _e347 = global_2.member[bitcast<u32>((_e343 + 8i))];
let _e348 = bitcast<i32>(_e347);
let _e353 = global_1.member.member_3[0u];
let _e357 = global_1.member.member_3[1u];
let _e358 = bitcast<i32>(_e357);
let _e360 = select(_e317, _e298, (_e298 < _e317));
let _e362 = select(_e323, _e304, (_e304 < _e323));
let _e364 = select(_e329, _e310, (_e310 < _e329));
let _e366 = select(_e336, _e360, (_e360 < _e336));
let _e368 = select(_e342, _e362, (_e362 < _e342));
let _e370 = select(_e348, _e364, (_e364 < _e348));
let _e372 = select(_e317, _e298, (_e298 > _e317));
let _e374 = select(_e323, _e304, (_e304 > _e323));
let _e376 = select(_e329, _e310, (_e310 > _e329));
let _e378 = select(_e336, _e372, (_e372 > _e336));
let _e380 = select(_e342, _e374, (_e374 > _e342));
let _e382 = select(_e348, _e376, (_e376 > _e348));
let _e383 = (_e378 - _e366);
let _e384 = (_e380 - _e368);
let _e385 = (_e382 - _e370);
let _e387 = select(_e384, _e383, (_e383 > _e384));
let _e392 = (_e353 & 31u);
let _e395 = ((select(_e385, _e387, (_e387 > _e385)) + (2i * _e358)) + (2i << bitcast<u32>(_e392)));
if ((_e395 >> bitcast<u32>(22u)) == 0i) {
phi_2032_ = 0u;
} else {
let _e400 = (_e395 >> bitcast<u32>(16i));
let _e401 = (_e400 == 0i);
phi_2032_ = ((((bitcast<u32>(f32(select(_e400, _e395, _e401))) >> bitcast<u32>(23i)) - 127u) + select(16u, 0u, _e401)) + 4294967275u);
}
let _e412 = phi_2032_;
let _e423 = ((((_e358 + 1i) + ((1i << bitcast<u32>((_e412 & 31u))) >> bitcast<u32>(1i))) + (_e395 >> bitcast<u32>(19i))) + 1i);
let _e427 = global_1.member.member_1[0u];
let _e428 = bitcast<i32>(_e427);
let _e432 = global_1.member.member_1[1u];
let _e433 = bitcast<i32>(_e432);
let _e437 = global_1.member.member_1[2u];
let _e438 = bitcast<i32>(_e437);
let _e441 = ((_e366 - _e423) >> bitcast<u32>(_e392));
let _e443 = select(0i, _e441, (_e441 > 0i));
if (_e443 < _e428) {
phi_2066_ = _e443;
} else {
phi_2066_ = (_e428 - 1i);
}
let _e447 = phi_2066_;
let _e450 = ((_e368 - _e423) >> bitcast<u32>(_e392));
let _e452 = select(0i, _e450, (_e450 > 0i));
if (_e452 < _e433) {
phi_2080_ = _e452;
} else {
phi_2080_ = (_e433 - 1i);
}
let _e456 = phi_2080_;
let _e459 = ((_e370 - _e423) >> bitcast<u32>(_e392));
let _e461 = select(0i, _e459, (_e459 > 0i));
if (_e461 < _e438) {
phi_2094_ = _e461;
} else {
phi_2094_ = (_e438 - 1i);
}
let _e465 = phi_2094_;
let _e469 = ((_e378 + _e423) >> bitcast<u32>(_e392));
let _e471 = select(0i, _e469, (_e469 > 0i));
if (_e471 < _e428) {
phi_2109_ = _e471;
} else {
phi_2109_ = (_e428 - 1i);
}
let _e475 = phi_2109_;
let _e478 = ((_e380 + _e423) >> bitcast<u32>(_e392));
let _e480 = select(0i, _e478, (_e478 > 0i));
if (_e480 < _e433) {
phi_2123_ = _e480;
} else {
phi_2123_ = (_e433 - 1i);
}
let _e484 = phi_2123_;
let _e487 = ((_e382 + _e423) >> bitcast<u32>(_e392));
let _e489 = select(0i, _e487, (_e487 > 0i));
if (_e489 < _e438) {
phi_2137_ = _e489;
} else {
phi_2137_ = (_e438 - 1i);
}
let _e493 = phi_2137_;
phi_2143_ = type_14(vec3<i32>(_e298, _e304, _e310), vec3<i32>(_e317, _e323, _e329), vec3<i32>(_e336, _e342, _e348), vec3<i32>(_e447, _e456, _e465), vec3<i32>((_e475 - _e447), (_e484 - _e456), (_e493 - _e465)), _e423, _e353, _e412);
}
let _e596 = phi_2143_;
phi_2145_ = type_16(type_15(_e286, _e257, (_e257 + _e270)), _e596);
}
let _e935 = phi_2145_;
if (_e935.member.member_1 < _e935.member.member_2) {
let _e943 = (_e935.member_1.member_4.x == 0i);
let _e946 = (_e935.member_1.member_4.y == 0i);
let _e949 = (_e935.member_1.member_4.z == 0i);
if (((_e943 && _e946) || (_e946 && _e949)) || (_e949 && _e943)) {
phi_2180_ = 0u;
} else {
if _e943 {
phi_2179_ = 1u;
} else {
if _e946 {
phi_2178_ = 2u;
} else {
phi_2178_ = select(4u, 3u, _e949);
}
let _e957 = phi_2178_;
phi_2179_ = _e957;
}
let _e959 = phi_2179_;
phi_2180_ = _e959;
}
let _e961 = phi_2180_;
if (_e961 == 0u) {
let _e7013 = (_e935.member_1.member_6 & 31u);
let _e7015 = (_e935.member_1.member_3.x << bitcast<u32>(_e7013));
let _e7018 = (_e935.member_1.member_7 & 31u);
let _e7022 = ((1i << bitcast<u32>(_e7018)) >> bitcast<u32>(1i));
let _e7028 = bitcast<i32>(_e935.member_1.member_6);
let _e7034 = bitcast<f32>((bitcast<u32>((127i + (bitcast<i32>(_e935.member_1.member_7) - _e7028))) << bitcast<u32>(23i)));
let _e7035 = (f32((((_e935.member_1.member.x - _e7015) + _e7022) >> bitcast<u32>(_e7018))) * _e7034);
let _e7040 = (_e935.member_1.member_3.y << bitcast<u32>(_e7013));
let _e7046 = (f32((((_e935.member_1.member.y - _e7040) + _e7022) >> bitcast<u32>(_e7018))) * _e7034);
let _e7051 = (_e935.member_1.member_3.z << bitcast<u32>(_e7013));
let _e7057 = (f32((((_e935.member_1.member.z - _e7051) + _e7022) >> bitcast<u32>(_e7018))) * _e7034);
let _e7065 = (f32((((_e935.member_1.member_1.x - _e7015) + _e7022) >> bitcast<u32>(_e7018))) * _e7034);
let _e7072 = (f32((((_e935.member_1.member_1.y - _e7040) + _e7022) >> bitcast<u32>(_e7018))) * _e7034);
let _e7079 = (f32((((_e935.member_1.member_1.z - _e7051) + _e7022) >> bitcast<u32>(_e7018))) * _e7034);
let _e7087 = (f32((((_e935.member_1.member_2.x - _e7015) + _e7022) >> bitcast<u32>(_e7018))) * _e7034);
let _e7094 = (f32((((_e935.member_1.member_2.y - _e7040) + _e7022) >> bitcast<u32>(_e7018))) * _e7034);
let _e7101 = (f32((((_e935.member_1.member_2.z - _e7051) + _e7022) >> bitcast<u32>(_e7018))) * _e7034);
let _e7109 = (f32(_e935.member_1.member_5) * bitcast<f32>((bitcast<u32>((127i - _e7028)) << bitcast<u32>(23i))));
let _e7110 = (_e7065 - _e7035);
let _e7111 = (_e7072 - _e7046);
let _e7112 = (_e7079 - _e7057);
let _e7113 = (_e7087 - _e7065);
let _e7114 = (_e7094 - _e7072);
let _e7115 = (_e7101 - _e7079);
let _e7118 = ((_e7111 * _e7115) - (_e7112 * _e7114));
let _e7125 = (1f + _e7109);
let _e7128 = (_e935.member_1.member_4.z >= _e935.member_1.member_4.y);
if _e7128 {
let _e7222 = select(1f, -1f, (_e7118 < 0f));
let _e7227 = ((_e7057 - _e7079) * _e7222);
let _e7228 = ((_e7079 - _e7101) * _e7222);
let _e7229 = ((_e7101 - _e7057) * _e7222);
let _e7230 = ((0f - 0f) * _e7222);
let _e7232 = (_e7111 * _e7222);
let _e7233 = (_e7114 * _e7222);
let _e7234 = ((_e7046 - _e7094) * _e7222);
if (select(0u, 1u, ((_e7227 * _e7125) > -((_e7227 * _e7109)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e7228 * _e7125) > -((_e7228 * _e7109)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e7229 * _e7125) > -((_e7229 * _e7109)))) < 2u) {
} else {
break;
}
let _e7258 = (select(0u, 1u, ((_e7230 * _e7125) > -((_e7230 * _e7109)))) < 2u);
if _e7258 {
} else {
break;
}
if (select(0u, 1u, ((_e7232 * _e7125) > -((_e7232 * _e7109)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e7233 * _e7125) > -((_e7233 * _e7109)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e7234 * _e7125) > -((_e7234 * _e7109)))) < 2u) {
} else {
break;
}
if _e7258 {
} else {
break;
}
if (select(0u, 1u, (_e7227 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7228 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7229 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7230 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7227 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7228 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7229 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7230 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7227 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7228 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7229 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7230 < 0f)) < 2u) {
} else {
break;
}
} else {
let _e7130 = select(1f, -1f, (-(_e7118) < 0f));
let _e7135 = ((_e7046 - _e7072) * _e7130);
let _e7136 = ((_e7072 - _e7094) * _e7130);
let _e7137 = ((_e7094 - _e7046) * _e7130);
let _e7138 = ((0f - 0f) * _e7130);
let _e7140 = (_e7112 * _e7130);
let _e7141 = (_e7115 * _e7130);
let _e7142 = ((_e7057 - _e7101) * _e7130);
if (select(0u, 1u, ((_e7135 * _e7125) > -((_e7135 * _e7109)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e7136 * _e7125) > -((_e7136 * _e7109)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e7137 * _e7125) > -((_e7137 * _e7109)))) < 2u) {
} else {
break;
}
let _e7166 = (select(0u, 1u, ((_e7138 * _e7125) > -((_e7138 * _e7109)))) < 2u);
if _e7166 {
} else {
break;
}
if (select(0u, 1u, ((_e7140 * _e7125) > -((_e7140 * _e7109)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e7141 * _e7125) > -((_e7141 * _e7109)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e7142 * _e7125) > -((_e7142 * _e7109)))) < 2u) {
} else {
break;
}
if _e7166 {
} else {
break;
}
if (select(0u, 1u, (_e7135 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7136 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7137 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7138 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7135 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7136 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7137 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7138 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7135 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7136 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7137 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7138 < 0f)) < 2u) {
} else {
break;
}
}
let _e7315 = select(1f, -1f, (((_e7110 * _e7114) - (_e7111 * _e7113)) < 0f));
let _e7318 = (_e7094 - _e7046);
let _e7319 = (0f - 0f);
let _e7320 = ((_e7046 - _e7072) * _e7315);
let _e7321 = ((_e7072 - _e7094) * _e7315);
let _e7322 = (_e7318 * _e7315);
let _e7323 = (_e7319 * _e7315);
let _e7324 = (_e7035 - _e7087);
let _e7325 = (_e7110 * _e7315);
let _e7326 = (_e7113 * _e7315);
let _e7327 = (_e7324 * _e7315);
if (select(0u, 1u, ((_e7320 * _e7125) > -((_e7320 * _e7109)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e7321 * _e7125) > -((_e7321 * _e7109)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e7322 * _e7125) > -((_e7322 * _e7109)))) < 2u) {
} else {
break;
}
let _e7351 = (select(0u, 1u, ((_e7323 * _e7125) > -((_e7323 * _e7109)))) < 2u);
if _e7351 {
} else {
break;
}
if (select(0u, 1u, ((_e7325 * _e7125) > -((_e7325 * _e7109)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e7326 * _e7125) > -((_e7326 * _e7109)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e7327 * _e7125) > -((_e7327 * _e7109)))) < 2u) {
} else {
break;
}
if _e7351 {
} else {
break;
}
if (select(0u, 1u, (_e7320 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7321 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7322 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7323 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7320 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7321 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7322 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7323 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7320 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7321 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7322 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7323 < 0f)) < 2u) {
} else {
break;
}
let _e7407 = select(1f, -1f, (-(((_e7112 * _e7113) - (_e7110 * _e7115))) < 0f));
let _e7410 = (_e7101 - _e7057);
let _e7411 = ((_e7057 - _e7079) * _e7407);
let _e7412 = ((_e7079 - _e7101) * _e7407);
let _e7413 = (_e7410 * _e7407);
let _e7414 = (_e7319 * _e7407);
let _e7415 = (_e7110 * _e7407);
let _e7416 = (_e7113 * _e7407);
let _e7417 = (_e7324 * _e7407);
if (select(0u, 1u, ((_e7411 * _e7125) > -((_e7411 * _e7109)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e7412 * _e7125) > -((_e7412 * _e7109)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e7413 * _e7125) > -((_e7413 * _e7109)))) < 2u) {
} else {
break;
}
let _e7441 = (select(0u, 1u, ((_e7414 * _e7125) > -((_e7414 * _e7109)))) < 2u);
if _e7441 {
} else {
break;
}
if (select(0u, 1u, ((_e7415 * _e7125) > -((_e7415 * _e7109)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e7416 * _e7125) > -((_e7416 * _e7109)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e7417 * _e7125) > -((_e7417 * _e7109)))) < 2u) {
} else {
break;
}
if _e7441 {
} else {
break;
}
if (select(0u, 1u, (_e7411 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7412 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7413 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7414 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7411 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7412 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7413 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7414 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7411 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7412 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7413 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e7414 < 0f)) < 2u) {
} else {
break;
}
let _e7496 = (_e7087 - _e7035);
let _e7498 = (_e935.member.member * 19i);
let _e7499 = (_e7498 + 18i);
let _e7501 = (bitcast<i32>(_e214) - 1i);
let _e7503 = select(_e7501, _e7499, (_e7499 < _e7501));
let _e7509 = global_4.member[bitcast<u32>(select(0i, _e7503, (_e7503 > 0i)))];
let _e7511 = select(0f, _e7509, (_e7509 > 0f));
let _e7513 = select(16777216f, _e7511, (_e7511 < 16777216f));
let _e7520 = select(0i, select(select(i32(_e7513), i32(-2147483648), (_e7513 < -2147483600f)), 2147483647i, (_e7513 > 2147483500f)), (_e7513 == _e7513));
phi_6179_ = _e935.member.member_1;
loop {
let _e7527 = phi_6179_;
let _e7528 = (_e7527 < _e935.member.member_2);
if _e7528 {
if _e7128 {
phi_6194_ = _e935.member_1.member_4.y;
} else {
phi_6194_ = _e935.member_1.member_4.z;
}
let _e7532 = phi_6194_;
phi_6196_ = 0i;
loop {
let _e7534 = phi_6196_;
let _e7535 = (_e7534 <= _e7532);
if _e7535 {
let _e7536 = select(_e7534, _e7527, _e7128);
let _e7537 = select(_e7527, _e7534, _e7128);
let _e7543 = global_1.member.member_1[1u];
let _e7551 = global_1.member.member_1[3u];
phi_6227_ = 0i;
loop {
let _e7555 = phi_6227_;
let _e7556 = (_e7555 <= _e935.member_1.member_4.x);
if _e7556 {
let _e7563 = ((f32(_e7555) + 0.5f) - _e7035);
let _e7564 = ((f32(_e7537) + 0.5f) - _e7046);
let _e7565 = ((f32(_e7536) + 0.5f) - _e7057);
let _e7570 = (((_e7110 * _e7110) + (_e7111 * _e7111)) + (_e7112 * _e7112));
let _e7575 = (((_e7110 * _e7496) + (_e7111 * _e7318)) + (_e7112 * _e7410));
let _e7580 = (((_e7496 * _e7496) + (_e7318 * _e7318)) + (_e7410 * _e7410));
let _e7585 = (((_e7563 * _e7110) + (_e7564 * _e7111)) + (_e7565 * _e7112));
let _e7590 = (((_e7563 * _e7496) + (_e7564 * _e7318)) + (_e7565 * _e7410));
let _e7593 = ((_e7570 * _e7580) - (_e7575 * _e7575));
let _e7594 = (_e7593 > 0f);
let _e7597 = select(0f, (1f / select(1f, _e7593, _e7594)), _e7594);
let _e7601 = (((_e7580 * _e7585) - (_e7575 * _e7590)) * _e7597);
let _e7605 = (((_e7570 * _e7590) - (_e7575 * _e7585)) * _e7597);
let _e7607 = ((1f - _e7601) - _e7605);
let _e7609 = select(0f, _e7607, (_e7607 > 0f));
let _e7611 = select(16777216f, _e7609, (_e7609 < 16777216f));
let _e7613 = select(0f, _e7601, (_e7601 > 0f));
let _e7615 = select(16777216f, _e7613, (_e7613 < 16777216f));
let _e7617 = select(0f, _e7605, (_e7605 > 0f));
let _e7619 = select(16777216f, _e7617, (_e7617 < 16777216f));
let _e7621 = ((_e7611 + _e7615) + _e7619);
let _e7624 = (1f / select(0.5f, _e7621, (_e7621 > 0.5f)));
let _e7625 = (_e7611 * _e7624);
let _e7626 = (_e7615 * _e7624);
let _e7627 = (_e7619 * _e7624);
let _e7629 = select(_e7501, _e7498, (_e7498 < _e7501));
let _e7635 = global_4.member[bitcast<u32>(select(0i, _e7629, (_e7629 > 0i)))];
let _e7636 = (_e7498 + 1i);
let _e7638 = select(_e7501, _e7636, (_e7636 < _e7501));
let _e7644 = global_4.member[bitcast<u32>(select(0i, _e7638, (_e7638 > 0i)))];
let _e7645 = (_e7498 + 2i);
let _e7647 = select(_e7501, _e7645, (_e7645 < _e7501));
let _e7653 = global_4.member[bitcast<u32>(select(0i, _e7647, (_e7647 > 0i)))];
let _e7654 = (_e7498 + 3i);
let _e7656 = select(_e7501, _e7654, (_e7654 < _e7501));
let _e7662 = global_4.member[bitcast<u32>(select(0i, _e7656, (_e7656 > 0i)))];
let _e7663 = (_e7498 + 4i);
let _e7665 = select(_e7501, _e7663, (_e7663 < _e7501));
let _e7671 = global_4.member[bitcast<u32>(select(0i, _e7665, (_e7665 > 0i)))];
let _e7672 = (_e7498 + 5i);
let _e7674 = select(_e7501, _e7672, (_e7672 < _e7501));
let _e7680 = global_4.member[bitcast<u32>(select(0i, _e7674, (_e7674 > 0i)))];
let _e7681 = (_e7498 + 6i);
let _e7683 = select(_e7501, _e7681, (_e7681 < _e7501));
let _e7689 = global_4.member[bitcast<u32>(select(0i, _e7683, (_e7683 > 0i)))];
let _e7690 = (_e7498 + 7i);
let _e7692 = select(_e7501, _e7690, (_e7690 < _e7501));
let _e7698 = global_4.member[bitcast<u32>(select(0i, _e7692, (_e7692 > 0i)))];
let _e7699 = (_e7498 + 8i);
let _e7701 = select(_e7501, _e7699, (_e7699 < _e7501));
let _e7707 = global_4.member[bitcast<u32>(select(0i, _e7701, (_e7701 > 0i)))];
let _e7712 = (((_e7635 * _e7625) + (_e7662 * _e7626)) + (_e7689 * _e7627));
let _e7717 = (((_e7644 * _e7625) + (_e7671 * _e7626)) + (_e7698 * _e7627));
let _e7722 = (((_e7653 * _e7625) + (_e7680 * _e7626)) + (_e7707 * _e7627));
let _e7727 = (((_e7712 * _e7712) + (_e7717 * _e7717)) + (_e7722 * _e7722));
let _e7730 = sqrt(select(0f, _e7727, (_e7727 > 0f)));
let _e7731 = (_e7730 > 1e-6f);
let _e7734 = select(0f, (1f / select(1e-6f, _e7730, _e7731)), _e7731);
let _e7735 = (_e7498 + 9i);
let _e7737 = select(_e7501, _e7735, (_e7735 < _e7501));
let _e7743 = global_4.member[bitcast<u32>(select(0i, _e7737, (_e7737 > 0i)))];
let _e7744 = (_e7498 + 10i);
let _e7746 = select(_e7501, _e7744, (_e7744 < _e7501));
let _e7752 = global_4.member[bitcast<u32>(select(0i, _e7746, (_e7746 > 0i)))];
let _e7753 = (_e7498 + 11i);
let _e7755 = select(_e7501, _e7753, (_e7753 < _e7501));
let _e7761 = global_4.member[bitcast<u32>(select(0i, _e7755, (_e7755 > 0i)))];
let _e7762 = (_e7498 + 12i);
let _e7764 = select(_e7501, _e7762, (_e7762 < _e7501));
let _e7770 = global_4.member[bitcast<u32>(select(0i, _e7764, (_e7764 > 0i)))];
let _e7771 = (_e7498 + 13i);
let _e7773 = select(_e7501, _e7771, (_e7771 < _e7501));
let _e7779 = global_4.member[bitcast<u32>(select(0i, _e7773, (_e7773 > 0i)))];
let _e7780 = (_e7498 + 14i);
let _e7782 = select(_e7501, _e7780, (_e7780 < _e7501));
let _e7788 = global_4.member[bitcast<u32>(select(0i, _e7782, (_e7782 > 0i)))];
let _e7789 = (_e7498 + 15i);
let _e7791 = select(_e7501, _e7789, (_e7789 < _e7501));
let _e7797 = global_4.member[bitcast<u32>(select(0i, _e7791, (_e7791 > 0i)))];
let _e7798 = (_e7498 + 16i);
let _e7800 = select(_e7501, _e7798, (_e7798 < _e7501));
let _e7806 = global_4.member[bitcast<u32>(select(0i, _e7800, (_e7800 > 0i)))];
let _e7807 = (_e7498 + 17i);
let _e7809 = select(_e7501, _e7807, (_e7807 < _e7501));
let _e7815 = global_4.member[bitcast<u32>(select(0i, _e7809, (_e7809 > 0i)))];
let _e7831 = (_e935.member_1.member_3.x + _e7555);
let _e7834 = ((((((_e935.member_1.member_3.z + _e7536) * bitcast<i32>(_e7543)) + _e935.member_1.member_3.y) + _e7537) * bitcast<i32>(_e7551)) + (_e7831 >> bitcast<u32>(5i)));
let _e7838 = (bitcast<i32>(_e218) - 1i);
let _e7840 = select(_e7838, _e7834, (_e7834 < _e7838));
let _e7846 = global_6.member[bitcast<u32>(select(0i, _e7840, (_e7840 > 0i)))];
let _e7848 = (bitcast<i32>(_e216) - 1i);
let _e7850 = select(_e7848, _e7834, (_e7834 < _e7848));
let _e7856 = global_5.member[bitcast<u32>(select(0i, _e7850, (_e7850 > 0i)))];
let _e7865 = (bitcast<i32>((_e7846 + countOneBits((_e7856 & ((1u << bitcast<u32>((bitcast<u32>((_e7831 & 31i)) & 31u))) - 1u))))) * 14i);
let _e7866 = bitcast<u32>(_e7865);
if (_e7866 < _e220) {
let _e7870 = atomicAdd((&global_7.member[_e7866]), 1u);
}
let _e7872 = bitcast<u32>((_e7865 + 1i));
if (_e7872 < _e220) {
let _e7876 = atomicMax((&global_7.member[_e7872]), bitcast<u32>((_e7520 - select(0i, 1i, (_e7513 < f32(_e7520))))));
}
let _e7882 = (((_e7712 * _e7734) * 65536f) + 0.5f);
let _e7884 = select(-1073741800f, _e7882, (_e7882 > -1073741800f));
let _e7886 = select(1073741800f, _e7884, (_e7884 < 1073741800f));
let _e7893 = select(0i, select(select(i32(_e7886), i32(-2147483648), (_e7886 < -2147483600f)), 2147483647i, (_e7886 > 2147483500f)), (_e7886 == _e7886));
let _e7897 = (_e7893 - select(0i, 1i, (_e7886 < f32(_e7893))));
if (_e7897 == 0i) {
} else {
let _e7899 = bitcast<u32>(_e7897);
let _e7900 = bitcast<u32>((_e7865 + 2i));
if (_e7900 < _e220) {
let _e7904 = atomicAdd((&global_7.member[_e7900]), _e7899);
phi_6755_ = _e7904;
} else {
phi_6755_ = 0u;
}
let _e7906 = phi_6755_;
let _e7913 = (bitcast<u32>((_e7897 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e7906 + _e7899) < _e7899)));
if (_e7913 == 0u) {
} else {
let _e7915 = (_e7900 + 1u);
if (_e7915 < _e220) {
let _e7919 = atomicAdd((&global_7.member[_e7915]), _e7913);
}
}
}
let _e7922 = (((_e7717 * _e7734) * 65536f) + 0.5f);
let _e7924 = select(-1073741800f, _e7922, (_e7922 > -1073741800f));
let _e7926 = select(1073741800f, _e7924, (_e7924 < 1073741800f));
let _e7933 = select(0i, select(select(i32(_e7926), i32(-2147483648), (_e7926 < -2147483600f)), 2147483647i, (_e7926 > 2147483500f)), (_e7926 == _e7926));
let _e7937 = (_e7933 - select(0i, 1i, (_e7926 < f32(_e7933))));
if (_e7937 == 0i) {
} else {
let _e7939 = bitcast<u32>(_e7937);
let _e7940 = bitcast<u32>((_e7865 + 4i));
if (_e7940 < _e220) {
let _e7944 = atomicAdd((&global_7.member[_e7940]), _e7939);
phi_6812_ = _e7944;
} else {
phi_6812_ = 0u;
}
let _e7946 = phi_6812_;
let _e7953 = (bitcast<u32>((_e7937 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e7946 + _e7939) < _e7939)));
if (_e7953 == 0u) {
} else {
let _e7955 = (_e7940 + 1u);
if (_e7955 < _e220) {
let _e7959 = atomicAdd((&global_7.member[_e7955]), _e7953);
}
}
}
let _e7962 = (((_e7722 * _e7734) * 65536f) + 0.5f);
let _e7964 = select(-1073741800f, _e7962, (_e7962 > -1073741800f));
let _e7966 = select(1073741800f, _e7964, (_e7964 < 1073741800f));
let _e7973 = select(0i, select(select(i32(_e7966), i32(-2147483648), (_e7966 < -2147483600f)), 2147483647i, (_e7966 > 2147483500f)), (_e7966 == _e7966));
let _e7977 = (_e7973 - select(0i, 1i, (_e7966 < f32(_e7973))));
if (_e7977 == 0i) {
} else {
let _e7979 = bitcast<u32>(_e7977);
let _e7980 = bitcast<u32>((_e7865 + 6i));
if (_e7980 < _e220) {
let _e7984 = atomicAdd((&global_7.member[_e7980]), _e7979);
phi_6869_ = _e7984;
} else {
phi_6869_ = 0u;
}
let _e7986 = phi_6869_;
let _e7993 = (bitcast<u32>((_e7977 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e7986 + _e7979) < _e7979)));
if (_e7993 == 0u) {
} else {
let _e7995 = (_e7980 + 1u);
if (_e7995 < _e220) {
let _e7999 = atomicAdd((&global_7.member[_e7995]), _e7993);
}
}
}
let _e8002 = (((((_e7743 * _e7625) + (_e7770 * _e7626)) + (_e7797 * _e7627)) * 65536f) + 0.5f);
let _e8004 = select(-1073741800f, _e8002, (_e8002 > -1073741800f));
let _e8006 = select(1073741800f, _e8004, (_e8004 < 1073741800f));
let _e8013 = select(0i, select(select(i32(_e8006), i32(-2147483648), (_e8006 < -2147483600f)), 2147483647i, (_e8006 > 2147483500f)), (_e8006 == _e8006));
let _e8017 = (_e8013 - select(0i, 1i, (_e8006 < f32(_e8013))));
if (_e8017 == 0i) {
} else {
let _e8019 = bitcast<u32>(_e8017);
let _e8020 = bitcast<u32>((_e7865 + 8i));
if (_e8020 < _e220) {
let _e8024 = atomicAdd((&global_7.member[_e8020]), _e8019);
phi_6927_ = _e8024;
} else {
phi_6927_ = 0u;
}
let _e8026 = phi_6927_;
let _e8033 = (bitcast<u32>((_e8017 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e8026 + _e8019) < _e8019)));
if (_e8033 == 0u) {
} else {
let _e8035 = (_e8020 + 1u);
if (_e8035 < _e220) {
let _e8039 = atomicAdd((&global_7.member[_e8035]), _e8033);
}
}
}
let _e8042 = (((((_e7752 * _e7625) + (_e7779 * _e7626)) + (_e7806 * _e7627)) * 65536f) + 0.5f);
let _e8044 = select(-1073741800f, _e8042, (_e8042 > -1073741800f));
let _e8046 = select(1073741800f, _e8044, (_e8044 < 1073741800f));
let _e8053 = select(0i, select(select(i32(_e8046), i32(-2147483648), (_e8046 < -2147483600f)), 2147483647i, (_e8046 > 2147483500f)), (_e8046 == _e8046));
let _e8057 = (_e8053 - select(0i, 1i, (_e8046 < f32(_e8053))));
if (_e8057 == 0i) {
} else {
let _e8059 = bitcast<u32>(_e8057);
let _e8060 = bitcast<u32>((_e7865 + 10i));
if (_e8060 < _e220) {
let _e8064 = atomicAdd((&global_7.member[_e8060]), _e8059);
phi_6984_ = _e8064;
} else {
phi_6984_ = 0u;
}
let _e8066 = phi_6984_;
let _e8073 = (bitcast<u32>((_e8057 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e8066 + _e8059) < _e8059)));
if (_e8073 == 0u) {
} else {
let _e8075 = (_e8060 + 1u);
if (_e8075 < _e220) {
let _e8079 = atomicAdd((&global_7.member[_e8075]), _e8073);
}
}
}
let _e8082 = (((((_e7761 * _e7625) + (_e7788 * _e7626)) + (_e7815 * _e7627)) * 65536f) + 0.5f);
let _e8084 = select(-1073741800f, _e8082, (_e8082 > -1073741800f));
let _e8086 = select(1073741800f, _e8084, (_e8084 < 1073741800f));
let _e8093 = select(0i, select(select(i32(_e8086), i32(-2147483648), (_e8086 < -2147483600f)), 2147483647i, (_e8086 > 2147483500f)), (_e8086 == _e8086));
let _e8097 = (_e8093 - select(0i, 1i, (_e8086 < f32(_e8093))));
if (_e8097 == 0i) {
} else {
let _e8099 = bitcast<u32>(_e8097);
let _e8100 = bitcast<u32>((_e7865 + 12i));
if (_e8100 < _e220) {
let _e8104 = atomicAdd((&global_7.member[_e8100]), _e8099);
phi_7041_ = _e8104;
} else {
phi_7041_ = 0u;
}
let _e8106 = phi_7041_;
let _e8113 = (bitcast<u32>((_e8097 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e8106 + _e8099) < _e8099)));
if (_e8113 == 0u) {
} else {
let _e8115 = (_e8100 + 1u);
if (_e8115 < _e220) {
let _e8119 = atomicAdd((&global_7.member[_e8115]), _e8113);
}
}
}
phi_6228_ = (_e7555 + 1i);
} else {
phi_6228_ = i32();
}
let _e8122 = phi_6228_;
continue;
continuing {
phi_6227_ = _e8122;
break if !(_e7556);
}
}
phi_6197_ = (_e7534 + 1i);
} else {
phi_6197_ = i32();
}
let _e8126 = phi_6197_;
continue;
continuing {
phi_6196_ = _e8126;
break if !(_e7535);
}
}
phi_6180_ = (_e7527 + 1i);
} else {
phi_6180_ = i32();
}
let _e8130 = phi_6180_;
continue;
continuing {
phi_6179_ = _e8130;
break if !(_e7528);
}
}
} else {
if (_e961 == 1u) {
let _e5500 = (_e935.member_1.member_6 & 31u);
let _e5502 = (_e935.member_1.member_3.x << bitcast<u32>(_e5500));
let _e5505 = (_e935.member_1.member_7 & 31u);
let _e5509 = ((1i << bitcast<u32>(_e5505)) >> bitcast<u32>(1i));
let _e5515 = bitcast<i32>(_e935.member_1.member_6);
let _e5521 = bitcast<f32>((bitcast<u32>((127i + (bitcast<i32>(_e935.member_1.member_7) - _e5515))) << bitcast<u32>(23i)));
let _e5522 = (f32((((_e935.member_1.member.x - _e5502) + _e5509) >> bitcast<u32>(_e5505))) * _e5521);
let _e5527 = (_e935.member_1.member_3.y << bitcast<u32>(_e5500));
let _e5533 = (f32((((_e935.member_1.member.y - _e5527) + _e5509) >> bitcast<u32>(_e5505))) * _e5521);
let _e5538 = (_e935.member_1.member_3.z << bitcast<u32>(_e5500));
let _e5544 = (f32((((_e935.member_1.member.z - _e5538) + _e5509) >> bitcast<u32>(_e5505))) * _e5521);
let _e5552 = (f32((((_e935.member_1.member_1.x - _e5502) + _e5509) >> bitcast<u32>(_e5505))) * _e5521);
let _e5559 = (f32((((_e935.member_1.member_1.y - _e5527) + _e5509) >> bitcast<u32>(_e5505))) * _e5521);
let _e5566 = (f32((((_e935.member_1.member_1.z - _e5538) + _e5509) >> bitcast<u32>(_e5505))) * _e5521);
let _e5574 = (f32((((_e935.member_1.member_2.x - _e5502) + _e5509) >> bitcast<u32>(_e5505))) * _e5521);
let _e5581 = (f32((((_e935.member_1.member_2.y - _e5527) + _e5509) >> bitcast<u32>(_e5505))) * _e5521);
let _e5588 = (f32((((_e935.member_1.member_2.z - _e5538) + _e5509) >> bitcast<u32>(_e5505))) * _e5521);
let _e5596 = (f32(_e935.member_1.member_5) * bitcast<f32>((bitcast<u32>((127i - _e5515)) << bitcast<u32>(23i))));
let _e5597 = (_e5552 - _e5522);
let _e5598 = (_e5559 - _e5533);
let _e5599 = (_e5566 - _e5544);
let _e5600 = (_e5574 - _e5552);
let _e5601 = (_e5581 - _e5559);
let _e5602 = (_e5588 - _e5566);
let _e5603 = (_e5598 * _e5602);
let _e5604 = (_e5599 * _e5601);
let _e5605 = (_e5603 - _e5604);
let _e5619 = ((bitcast<f32>((bitcast<u32>(_e5603) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e5604) & 2147483647u))) * 2.3841858e-7f);
let _e5620 = f32(_e935.member_1.member_4.y);
let _e5621 = f32(_e935.member_1.member_4.z);
let _e5622 = (1f + _e5596);
let _e5623 = -(_e5605);
let _e5625 = (_e935.member_1.member_4.z >= _e935.member_1.member_4.y);
if _e5625 {
let _e5866 = select(1f, -1f, (_e5605 < 0f));
let _e5872 = select(0f, (2f * _e5619), (bitcast<f32>((bitcast<u32>(_e5605) & 2147483647u)) <= _e5619));
let _e5877 = ((_e5544 - _e5566) * _e5866);
let _e5878 = ((_e5566 - _e5588) * _e5866);
let _e5879 = ((_e5588 - _e5544) * _e5866);
let _e5880 = ((0f - 0f) * _e5866);
let _e5882 = (_e5598 * _e5866);
let _e5883 = (_e5601 * _e5866);
let _e5884 = ((_e5533 - _e5581) * _e5866);
let _e5886 = (_e5877 * _e5622);
let _e5887 = (_e5878 * _e5622);
let _e5888 = (_e5879 * _e5622);
let _e5889 = (_e5880 * _e5622);
let _e5894 = -((_e5877 * _e5596));
let _e5895 = -((_e5878 * _e5596));
let _e5896 = -((_e5879 * _e5596));
let _e5897 = -((_e5880 * _e5596));
local_136 = array<u32, 2>(0u, 4294967295u);
let _e5902 = select(0u, 1u, (_e5886 > _e5894));
if (_e5902 < 2u) {
} else {
break;
}
let _e5905 = local_136[_e5902];
local_137 = array<u32, 2>(0u, 4294967295u);
let _e5906 = select(0u, 1u, (_e5887 > _e5895));
if (_e5906 < 2u) {
} else {
break;
}
let _e5909 = local_137[_e5906];
local_138 = array<u32, 2>(0u, 4294967295u);
let _e5910 = select(0u, 1u, (_e5888 > _e5896));
if (_e5910 < 2u) {
} else {
break;
}
let _e5913 = local_138[_e5910];
local_139 = array<u32, 2>(0u, 4294967295u);
let _e5914 = select(0u, 1u, (_e5889 > _e5897));
let _e5915 = (_e5914 < 2u);
if _e5915 {
} else {
break;
}
let _e5917 = local_139[_e5914];
let _e5933 = (_e5880 * 0f);
let _e5938 = (_e5882 * _e5622);
let _e5939 = (_e5883 * _e5622);
let _e5940 = (_e5884 * _e5622);
let _e5944 = -((_e5882 * _e5596));
let _e5945 = -((_e5883 * _e5596));
let _e5946 = -((_e5884 * _e5596));
local_132 = array<u32, 2>(0u, 4294967295u);
let _e5950 = select(0u, 1u, (_e5938 > _e5944));
if (_e5950 < 2u) {
} else {
break;
}
let _e5953 = local_132[_e5950];
local_133 = array<u32, 2>(0u, 4294967295u);
let _e5954 = select(0u, 1u, (_e5939 > _e5945));
if (_e5954 < 2u) {
} else {
break;
}
let _e5957 = local_133[_e5954];
local_134 = array<u32, 2>(0u, 4294967295u);
let _e5958 = select(0u, 1u, (_e5940 > _e5946));
if (_e5958 < 2u) {
} else {
break;
}
let _e5961 = local_134[_e5958];
local_135 = array<u32, 2>(0u, 4294967295u);
if _e5915 {
} else {
break;
}
let _e5963 = local_135[_e5914];
local_128 = array<u32, 2>(0u, 4294967295u);
let _e5996 = select(0u, 1u, (_e5877 == 0f));
if (_e5996 < 2u) {
} else {
break;
}
let _e5999 = local_128[_e5996];
local_129 = array<u32, 2>(0u, 4294967295u);
let _e6000 = select(0u, 1u, (_e5878 == 0f));
if (_e6000 < 2u) {
} else {
break;
}
let _e6003 = local_129[_e6000];
local_130 = array<u32, 2>(0u, 4294967295u);
let _e6004 = select(0u, 1u, (_e5879 == 0f));
if (_e6004 < 2u) {
} else {
break;
}
let _e6007 = local_130[_e6004];
local_131 = array<u32, 2>(0u, 4294967295u);
let _e6008 = select(0u, 1u, (_e5880 == 0f));
if (_e6008 < 2u) {
} else {
break;
}
let _e6011 = local_131[_e6008];
let _e6013 = ((_e5999 & 1u) != 0u);
let _e6016 = ((_e6003 & 1u) != 0u);
let _e6019 = ((_e6007 & 1u) != 0u);
let _e6022 = ((_e6011 & 1u) != 0u);
let _e6024 = (-1f / select(_e5877, 1f, _e6013));
let _e6025 = (-1f / select(_e5878, 1f, _e6016));
let _e6026 = (-1f / select(_e5879, 1f, _e6019));
let _e6027 = (-1f / select(_e5880, 1f, _e6022));
local_124 = array<u32, 2>(0u, 4294967295u);
let _e6032 = select(0u, 1u, (_e5877 > 0f));
if (_e6032 < 2u) {
} else {
break;
}
let _e6035 = local_124[_e6032];
local_125 = array<u32, 2>(0u, 4294967295u);
let _e6036 = select(0u, 1u, (_e5878 > 0f));
if (_e6036 < 2u) {
} else {
break;
}
let _e6039 = local_125[_e6036];
local_126 = array<u32, 2>(0u, 4294967295u);
let _e6040 = select(0u, 1u, (_e5879 > 0f));
if (_e6040 < 2u) {
} else {
break;
}
let _e6043 = local_126[_e6040];
local_127 = array<u32, 2>(0u, 4294967295u);
let _e6044 = select(0u, 1u, (_e5880 > 0f));
if (_e6044 < 2u) {
} else {
break;
}
let _e6047 = local_127[_e6044];
local_120 = array<u32, 2>(0u, 4294967295u);
let _e6052 = select(0u, 1u, (_e5877 < 0f));
if (_e6052 < 2u) {
} else {
break;
}
let _e6055 = local_120[_e6052];
local_121 = array<u32, 2>(0u, 4294967295u);
let _e6056 = select(0u, 1u, (_e5878 < 0f));
if (_e6056 < 2u) {
} else {
break;
}
let _e6059 = local_121[_e6056];
local_122 = array<u32, 2>(0u, 4294967295u);
let _e6060 = select(0u, 1u, (_e5879 < 0f));
if (_e6060 < 2u) {
} else {
break;
}
let _e6063 = local_122[_e6060];
local_123 = array<u32, 2>(0u, 4294967295u);
let _e6064 = select(0u, 1u, (_e5880 < 0f));
if (_e6064 < 2u) {
} else {
break;
}
let _e6067 = local_123[_e6064];
let _e6086 = ((_e6055 & 1u) != 0u);
let _e6089 = ((_e6059 & 1u) != 0u);
let _e6092 = ((_e6063 & 1u) != 0u);
let _e6095 = ((_e6067 & 1u) != 0u);
phi_9104_ = type_18(vec4<f32>(_e5882, _e5883, _e5884, _e5880), vec4<f32>((((select(_e5894, _e5886, ((_e5905 & 1u) != 0u)) - (_e5877 * _e5533)) + (select(_e5944, _e5938, ((_e5953 & 1u) != 0u)) - (_e5882 * _e5544))) + _e5872), (((select(_e5895, _e5887, ((_e5909 & 1u) != 0u)) - (_e5878 * _e5559)) + (select(_e5945, _e5939, ((_e5957 & 1u) != 0u)) - (_e5883 * _e5566))) + _e5872), (((select(_e5896, _e5888, ((_e5913 & 1u) != 0u)) - (_e5879 * _e5581)) + (select(_e5946, _e5940, ((_e5961 & 1u) != 0u)) - (_e5884 * _e5588))) + _e5872), (((select(_e5897, _e5889, ((_e5917 & 1u) != 0u)) - _e5933) + (select(_e5897, _e5889, ((_e5963 & 1u) != 0u)) - _e5933)) + _e5872)), vec4<f32>(select(0f, _e6024, ((_e6035 & 1u) != 0u)), select(0f, _e6025, ((_e6039 & 1u) != 0u)), select(0f, _e6026, ((_e6043 & 1u) != 0u)), select(0f, _e6027, ((_e6047 & 1u) != 0u))), vec4<f32>(select(select(0f, 1e20f, _e6013), _e6024, _e6086), select(select(0f, 1e20f, _e6016), _e6025, _e6089), select(select(0f, 1e20f, _e6019), _e6026, _e6092), select(select(0f, 1e20f, _e6022), _e6027, _e6095)), vec4<f32>(select(_e5620, 0f, _e6086), select(_e5620, 0f, _e6089), select(_e5620, 0f, _e6092), select(_e5620, 0f, _e6095)));
} else {
let _e5627 = select(1f, -1f, (_e5623 < 0f));
let _e5633 = select(0f, (2f * _e5619), (bitcast<f32>((bitcast<u32>(_e5623) & 2147483647u)) <= _e5619));
let _e5638 = ((_e5533 - _e5559) * _e5627);
let _e5639 = ((_e5559 - _e5581) * _e5627);
let _e5640 = ((_e5581 - _e5533) * _e5627);
let _e5641 = ((0f - 0f) * _e5627);
let _e5643 = (_e5599 * _e5627);
let _e5644 = (_e5602 * _e5627);
let _e5645 = ((_e5544 - _e5588) * _e5627);
let _e5647 = (_e5638 * _e5622);
let _e5648 = (_e5639 * _e5622);
let _e5649 = (_e5640 * _e5622);
let _e5650 = (_e5641 * _e5622);
let _e5655 = -((_e5638 * _e5596));
let _e5656 = -((_e5639 * _e5596));
let _e5657 = -((_e5640 * _e5596));
let _e5658 = -((_e5641 * _e5596));
local_116 = array<u32, 2>(0u, 4294967295u);
let _e5663 = select(0u, 1u, (_e5647 > _e5655));
if (_e5663 < 2u) {
} else {
break;
}
let _e5666 = local_116[_e5663];
local_117 = array<u32, 2>(0u, 4294967295u);
let _e5667 = select(0u, 1u, (_e5648 > _e5656));
if (_e5667 < 2u) {
} else {
break;
}
let _e5670 = local_117[_e5667];
local_118 = array<u32, 2>(0u, 4294967295u);
let _e5671 = select(0u, 1u, (_e5649 > _e5657));
if (_e5671 < 2u) {
} else {
break;
}
let _e5674 = local_118[_e5671];
local_119 = array<u32, 2>(0u, 4294967295u);
let _e5675 = select(0u, 1u, (_e5650 > _e5658));
let _e5676 = (_e5675 < 2u);
if _e5676 {
} else {
break;
}
let _e5678 = local_119[_e5675];
let _e5694 = (_e5641 * 0f);
let _e5699 = (_e5643 * _e5622);
let _e5700 = (_e5644 * _e5622);
let _e5701 = (_e5645 * _e5622);
let _e5705 = -((_e5643 * _e5596));
let _e5706 = -((_e5644 * _e5596));
let _e5707 = -((_e5645 * _e5596));
local_112 = array<u32, 2>(0u, 4294967295u);
let _e5711 = select(0u, 1u, (_e5699 > _e5705));
if (_e5711 < 2u) {
} else {
break;
}
let _e5714 = local_112[_e5711];
local_113 = array<u32, 2>(0u, 4294967295u);
let _e5715 = select(0u, 1u, (_e5700 > _e5706));
if (_e5715 < 2u) {
} else {
break;
}
let _e5718 = local_113[_e5715];
local_114 = array<u32, 2>(0u, 4294967295u);
let _e5719 = select(0u, 1u, (_e5701 > _e5707));
if (_e5719 < 2u) {
} else {
break;
}
let _e5722 = local_114[_e5719];
local_115 = array<u32, 2>(0u, 4294967295u);
if _e5676 {
} else {
break;
}
let _e5724 = local_115[_e5675];
local_108 = array<u32, 2>(0u, 4294967295u);
let _e5757 = select(0u, 1u, (_e5638 == 0f));
if (_e5757 < 2u) {
} else {
break;
}
let _e5760 = local_108[_e5757];
local_109 = array<u32, 2>(0u, 4294967295u);
let _e5761 = select(0u, 1u, (_e5639 == 0f));
if (_e5761 < 2u) {
} else {
break;
}
let _e5764 = local_109[_e5761];
local_110 = array<u32, 2>(0u, 4294967295u);
let _e5765 = select(0u, 1u, (_e5640 == 0f));
if (_e5765 < 2u) {
} else {
break;
}
let _e5768 = local_110[_e5765];
local_111 = array<u32, 2>(0u, 4294967295u);
let _e5769 = select(0u, 1u, (_e5641 == 0f));
if (_e5769 < 2u) {
} else {
break;
}
let _e5772 = local_111[_e5769];
let _e5774 = ((_e5760 & 1u) != 0u);
let _e5777 = ((_e5764 & 1u) != 0u);
let _e5780 = ((_e5768 & 1u) != 0u);
let _e5783 = ((_e5772 & 1u) != 0u);
let _e5785 = (-1f / select(_e5638, 1f, _e5774));
let _e5786 = (-1f / select(_e5639, 1f, _e5777));
let _e5787 = (-1f / select(_e5640, 1f, _e5780));
let _e5788 = (-1f / select(_e5641, 1f, _e5783));
local_104 = array<u32, 2>(0u, 4294967295u);
let _e5793 = select(0u, 1u, (_e5638 > 0f));
if (_e5793 < 2u) {
} else {
break;
}
let _e5796 = local_104[_e5793];
local_105 = array<u32, 2>(0u, 4294967295u);
let _e5797 = select(0u, 1u, (_e5639 > 0f));
if (_e5797 < 2u) {
} else {
break;
}
let _e5800 = local_105[_e5797];
local_106 = array<u32, 2>(0u, 4294967295u);
let _e5801 = select(0u, 1u, (_e5640 > 0f));
if (_e5801 < 2u) {
} else {
break;
}
let _e5804 = local_106[_e5801];
local_107 = array<u32, 2>(0u, 4294967295u);
let _e5805 = select(0u, 1u, (_e5641 > 0f));
if (_e5805 < 2u) {
} else {
break;
}
let _e5808 = local_107[_e5805];
local_100 = array<u32, 2>(0u, 4294967295u);
let _e5813 = select(0u, 1u, (_e5638 < 0f));
if (_e5813 < 2u) {
} else {
break;
}
let _e5816 = local_100[_e5813];
local_101 = array<u32, 2>(0u, 4294967295u);
let _e5817 = select(0u, 1u, (_e5639 < 0f));
if (_e5817 < 2u) {
} else {
break;
}
let _e5820 = local_101[_e5817];
local_102 = array<u32, 2>(0u, 4294967295u);
let _e5821 = select(0u, 1u, (_e5640 < 0f));
if (_e5821 < 2u) {
} else {
break;
}
let _e5824 = local_102[_e5821];
local_103 = array<u32, 2>(0u, 4294967295u);
let _e5825 = select(0u, 1u, (_e5641 < 0f));
if (_e5825 < 2u) {
} else {
break;
}
let _e5828 = local_103[_e5825];
let _e5847 = ((_e5816 & 1u) != 0u);
let _e5850 = ((_e5820 & 1u) != 0u);
let _e5853 = ((_e5824 & 1u) != 0u);
let _e5856 = ((_e5828 & 1u) != 0u);
phi_9104_ = type_18(vec4<f32>(_e5643, _e5644, _e5645, _e5641), vec4<f32>((((select(_e5655, _e5647, ((_e5666 & 1u) != 0u)) - (_e5638 * _e5544)) + (select(_e5705, _e5699, ((_e5714 & 1u) != 0u)) - (_e5643 * _e5533))) + _e5633), (((select(_e5656, _e5648, ((_e5670 & 1u) != 0u)) - (_e5639 * _e5566)) + (select(_e5706, _e5700, ((_e5718 & 1u) != 0u)) - (_e5644 * _e5559))) + _e5633), (((select(_e5657, _e5649, ((_e5674 & 1u) != 0u)) - (_e5640 * _e5588)) + (select(_e5707, _e5701, ((_e5722 & 1u) != 0u)) - (_e5645 * _e5581))) + _e5633), (((select(_e5658, _e5650, ((_e5678 & 1u) != 0u)) - _e5694) + (select(_e5658, _e5650, ((_e5724 & 1u) != 0u)) - _e5694)) + _e5633)), vec4<f32>(select(0f, _e5785, ((_e5796 & 1u) != 0u)), select(0f, _e5786, ((_e5800 & 1u) != 0u)), select(0f, _e5787, ((_e5804 & 1u) != 0u)), select(0f, _e5788, ((_e5808 & 1u) != 0u))), vec4<f32>(select(select(0f, 1e20f, _e5774), _e5785, _e5847), select(select(0f, 1e20f, _e5777), _e5786, _e5850), select(select(0f, 1e20f, _e5780), _e5787, _e5853), select(select(0f, 1e20f, _e5783), _e5788, _e5856)), vec4<f32>(select(_e5621, 0f, _e5847), select(_e5621, 0f, _e5850), select(_e5621, 0f, _e5853), select(_e5621, 0f, _e5856)));
}
let _e6105 = phi_9104_;
let _e6108 = select(1f, -1f, (((_e5597 * _e5601) - (_e5598 * _e5600)) < 0f));
let _e6111 = (_e5581 - _e5533);
let _e6112 = (0f - 0f);
let _e6113 = ((_e5533 - _e5559) * _e6108);
let _e6114 = ((_e5559 - _e5581) * _e6108);
let _e6115 = (_e6111 * _e6108);
let _e6116 = (_e6112 * _e6108);
let _e6117 = (_e5522 - _e5574);
let _e6118 = (_e5597 * _e6108);
let _e6119 = (_e5600 * _e6108);
let _e6120 = (_e6117 * _e6108);
if (select(0u, 1u, ((_e6113 * _e5622) > -((_e6113 * _e5596)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e6114 * _e5622) > -((_e6114 * _e5596)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e6115 * _e5622) > -((_e6115 * _e5596)))) < 2u) {
} else {
break;
}
let _e6144 = (select(0u, 1u, ((_e6116 * _e5622) > -((_e6116 * _e5596)))) < 2u);
if _e6144 {
} else {
break;
}
if (select(0u, 1u, ((_e6118 * _e5622) > -((_e6118 * _e5596)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e6119 * _e5622) > -((_e6119 * _e5596)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e6120 * _e5622) > -((_e6120 * _e5596)))) < 2u) {
} else {
break;
}
if _e6144 {
} else {
break;
}
if (select(0u, 1u, (_e6113 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6114 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6115 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6116 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6113 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6114 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6115 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6116 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6113 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6114 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6115 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6116 < 0f)) < 2u) {
} else {
break;
}
let _e6200 = select(1f, -1f, (-(((_e5599 * _e5600) - (_e5597 * _e5602))) < 0f));
let _e6203 = (_e5588 - _e5544);
let _e6204 = ((_e5544 - _e5566) * _e6200);
let _e6205 = ((_e5566 - _e5588) * _e6200);
let _e6206 = (_e6203 * _e6200);
let _e6207 = (_e6112 * _e6200);
let _e6208 = (_e5597 * _e6200);
let _e6209 = (_e5600 * _e6200);
let _e6210 = (_e6117 * _e6200);
if (select(0u, 1u, ((_e6204 * _e5622) > -((_e6204 * _e5596)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e6205 * _e5622) > -((_e6205 * _e5596)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e6206 * _e5622) > -((_e6206 * _e5596)))) < 2u) {
} else {
break;
}
let _e6234 = (select(0u, 1u, ((_e6207 * _e5622) > -((_e6207 * _e5596)))) < 2u);
if _e6234 {
} else {
break;
}
if (select(0u, 1u, ((_e6208 * _e5622) > -((_e6208 * _e5596)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e6209 * _e5622) > -((_e6209 * _e5596)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e6210 * _e5622) > -((_e6210 * _e5596)))) < 2u) {
} else {
break;
}
if _e6234 {
} else {
break;
}
if (select(0u, 1u, (_e6204 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6205 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6206 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6207 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6204 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6205 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6206 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6207 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6204 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6205 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6206 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e6207 < 0f)) < 2u) {
} else {
break;
}
let _e6289 = (_e5574 - _e5522);
let _e6291 = (_e935.member.member * 19i);
let _e6292 = (_e6291 + 18i);
let _e6294 = (bitcast<i32>(_e214) - 1i);
let _e6296 = select(_e6294, _e6292, (_e6292 < _e6294));
let _e6302 = global_4.member[bitcast<u32>(select(0i, _e6296, (_e6296 > 0i)))];
let _e6304 = select(0f, _e6302, (_e6302 > 0f));
let _e6306 = select(16777216f, _e6304, (_e6304 < 16777216f));
let _e6313 = select(0i, select(select(i32(_e6306), i32(-2147483648), (_e6306 < -2147483600f)), 2147483647i, (_e6306 > 2147483500f)), (_e6306 == _e6306));
phi_11061_ = _e935.member.member_1;
loop {
let _e6320 = phi_11061_;
let _e6321 = (_e6320 < _e935.member.member_2);
if _e6321 {
if _e5625 {
phi_11076_ = _e935.member_1.member_4.y;
} else {
phi_11076_ = _e935.member_1.member_4.z;
}
let _e6325 = phi_11076_;
let _e6326 = f32(_e6325);
let _e6327 = f32(_e6320);
let _e6337 = ((_e6105.member.x * _e6327) + _e6105.member_1.x);
let _e6339 = ((_e6105.member.y * _e6327) + _e6105.member_1.y);
let _e6341 = ((_e6105.member.z * _e6327) + _e6105.member_1.z);
let _e6344 = (_e6337 * _e6105.member_2.x);
let _e6346 = (_e6339 * _e6105.member_2.y);
let _e6348 = (_e6341 * _e6105.member_2.z);
let _e6358 = ((_e6337 * _e6105.member_3.x) + _e6105.member_4.x);
let _e6360 = ((_e6339 * _e6105.member_3.y) + _e6105.member_4.y);
let _e6362 = ((_e6341 * _e6105.member_3.z) + _e6105.member_4.z);
let _e6364 = select(_e6344, 0f, (0f > _e6344));
let _e6366 = select(_e6348, _e6346, (_e6346 > _e6348));
let _e6370 = select(_e6358, _e6326, (_e6326 < _e6358));
let _e6372 = select(_e6362, _e6360, (_e6360 < _e6362));
let _e6374 = select(_e6372, _e6370, (_e6370 < _e6372));
let _e6375 = -(select(_e6366, _e6364, (_e6364 > _e6366)));
let _e6377 = (-(_e6326) - 1f);
let _e6379 = select(_e6377, _e6375, (_e6375 > _e6377));
let _e6381 = select(0f, _e6379, (_e6379 < 0f));
let _e6388 = select(0i, select(select(i32(_e6381), i32(-2147483648), (_e6381 < -2147483600f)), 2147483647i, (_e6381 > 2147483500f)), (_e6381 == _e6381));
let _e6395 = select(-1f, _e6374, (_e6374 > -1f));
let _e6397 = select(_e6326, _e6395, (_e6395 < _e6326));
let _e6404 = select(0i, select(select(i32(_e6397), i32(-2147483648), (_e6397 < -2147483600f)), 2147483647i, (_e6397 > 2147483500f)), (_e6397 == _e6397));
phi_11196_ = -((_e6388 - select(0i, 1i, (_e6381 < f32(_e6388)))));
loop {
let _e6410 = phi_11196_;
let _e6411 = (_e6410 <= (_e6404 - select(0i, 1i, (_e6397 < f32(_e6404)))));
if _e6411 {
let _e6412 = select(_e6410, _e6320, _e5625);
let _e6413 = select(_e6320, _e6410, _e5625);
let _e6419 = global_1.member.member_1[1u];
let _e6427 = global_1.member.member_1[3u];
phi_11227_ = 0i;
loop {
let _e6431 = phi_11227_;
let _e6432 = (_e6431 <= _e935.member_1.member_4.x);
if _e6432 {
let _e6439 = ((f32(_e6431) + 0.5f) - _e5522);
let _e6440 = ((f32(_e6413) + 0.5f) - _e5533);
let _e6441 = ((f32(_e6412) + 0.5f) - _e5544);
let _e6446 = (((_e5597 * _e5597) + (_e5598 * _e5598)) + (_e5599 * _e5599));
let _e6451 = (((_e5597 * _e6289) + (_e5598 * _e6111)) + (_e5599 * _e6203));
let _e6456 = (((_e6289 * _e6289) + (_e6111 * _e6111)) + (_e6203 * _e6203));
let _e6461 = (((_e6439 * _e5597) + (_e6440 * _e5598)) + (_e6441 * _e5599));
let _e6466 = (((_e6439 * _e6289) + (_e6440 * _e6111)) + (_e6441 * _e6203));
let _e6469 = ((_e6446 * _e6456) - (_e6451 * _e6451));
let _e6470 = (_e6469 > 0f);
let _e6473 = select(0f, (1f / select(1f, _e6469, _e6470)), _e6470);
let _e6477 = (((_e6456 * _e6461) - (_e6451 * _e6466)) * _e6473);
let _e6481 = (((_e6446 * _e6466) - (_e6451 * _e6461)) * _e6473);
let _e6483 = ((1f - _e6477) - _e6481);
let _e6485 = select(0f, _e6483, (_e6483 > 0f));
let _e6487 = select(16777216f, _e6485, (_e6485 < 16777216f));
let _e6489 = select(0f, _e6477, (_e6477 > 0f));
let _e6491 = select(16777216f, _e6489, (_e6489 < 16777216f));
let _e6493 = select(0f, _e6481, (_e6481 > 0f));
let _e6495 = select(16777216f, _e6493, (_e6493 < 16777216f));
let _e6497 = ((_e6487 + _e6491) + _e6495);
let _e6500 = (1f / select(0.5f, _e6497, (_e6497 > 0.5f)));
let _e6501 = (_e6487 * _e6500);
let _e6502 = (_e6491 * _e6500);
let _e6503 = (_e6495 * _e6500);
let _e6505 = select(_e6294, _e6291, (_e6291 < _e6294));
let _e6511 = global_4.member[bitcast<u32>(select(0i, _e6505, (_e6505 > 0i)))];
let _e6512 = (_e6291 + 1i);
let _e6514 = select(_e6294, _e6512, (_e6512 < _e6294));
let _e6520 = global_4.member[bitcast<u32>(select(0i, _e6514, (_e6514 > 0i)))];
let _e6521 = (_e6291 + 2i);
let _e6523 = select(_e6294, _e6521, (_e6521 < _e6294));
let _e6529 = global_4.member[bitcast<u32>(select(0i, _e6523, (_e6523 > 0i)))];
let _e6530 = (_e6291 + 3i);
let _e6532 = select(_e6294, _e6530, (_e6530 < _e6294));
let _e6538 = global_4.member[bitcast<u32>(select(0i, _e6532, (_e6532 > 0i)))];
let _e6539 = (_e6291 + 4i);
let _e6541 = select(_e6294, _e6539, (_e6539 < _e6294));
let _e6547 = global_4.member[bitcast<u32>(select(0i, _e6541, (_e6541 > 0i)))];
let _e6548 = (_e6291 + 5i);
let _e6550 = select(_e6294, _e6548, (_e6548 < _e6294));
let _e6556 = global_4.member[bitcast<u32>(select(0i, _e6550, (_e6550 > 0i)))];
let _e6557 = (_e6291 + 6i);
let _e6559 = select(_e6294, _e6557, (_e6557 < _e6294));
let _e6565 = global_4.member[bitcast<u32>(select(0i, _e6559, (_e6559 > 0i)))];
let _e6566 = (_e6291 + 7i);
let _e6568 = select(_e6294, _e6566, (_e6566 < _e6294));
let _e6574 = global_4.member[bitcast<u32>(select(0i, _e6568, (_e6568 > 0i)))];
let _e6575 = (_e6291 + 8i);
let _e6577 = select(_e6294, _e6575, (_e6575 < _e6294));
let _e6583 = global_4.member[bitcast<u32>(select(0i, _e6577, (_e6577 > 0i)))];
let _e6588 = (((_e6511 * _e6501) + (_e6538 * _e6502)) + (_e6565 * _e6503));
let _e6593 = (((_e6520 * _e6501) + (_e6547 * _e6502)) + (_e6574 * _e6503));
let _e6598 = (((_e6529 * _e6501) + (_e6556 * _e6502)) + (_e6583 * _e6503));
let _e6603 = (((_e6588 * _e6588) + (_e6593 * _e6593)) + (_e6598 * _e6598));
let _e6606 = sqrt(select(0f, _e6603, (_e6603 > 0f)));
let _e6607 = (_e6606 > 1e-6f);
let _e6610 = select(0f, (1f / select(1e-6f, _e6606, _e6607)), _e6607);
let _e6611 = (_e6291 + 9i);
let _e6613 = select(_e6294, _e6611, (_e6611 < _e6294));
let _e6619 = global_4.member[bitcast<u32>(select(0i, _e6613, (_e6613 > 0i)))];
let _e6620 = (_e6291 + 10i);
let _e6622 = select(_e6294, _e6620, (_e6620 < _e6294));
let _e6628 = global_4.member[bitcast<u32>(select(0i, _e6622, (_e6622 > 0i)))];
let _e6629 = (_e6291 + 11i);
let _e6631 = select(_e6294, _e6629, (_e6629 < _e6294));
let _e6637 = global_4.member[bitcast<u32>(select(0i, _e6631, (_e6631 > 0i)))];
let _e6638 = (_e6291 + 12i);
let _e6640 = select(_e6294, _e6638, (_e6638 < _e6294));
let _e6646 = global_4.member[bitcast<u32>(select(0i, _e6640, (_e6640 > 0i)))];
let _e6647 = (_e6291 + 13i);
let _e6649 = select(_e6294, _e6647, (_e6647 < _e6294));
let _e6655 = global_4.member[bitcast<u32>(select(0i, _e6649, (_e6649 > 0i)))];
let _e6656 = (_e6291 + 14i);
let _e6658 = select(_e6294, _e6656, (_e6656 < _e6294));
let _e6664 = global_4.member[bitcast<u32>(select(0i, _e6658, (_e6658 > 0i)))];
let _e6665 = (_e6291 + 15i);
let _e6667 = select(_e6294, _e6665, (_e6665 < _e6294));
let _e6673 = global_4.member[bitcast<u32>(select(0i, _e6667, (_e6667 > 0i)))];
let _e6674 = (_e6291 + 16i);
let _e6676 = select(_e6294, _e6674, (_e6674 < _e6294));
let _e6682 = global_4.member[bitcast<u32>(select(0i, _e6676, (_e6676 > 0i)))];
let _e6683 = (_e6291 + 17i);
let _e6685 = select(_e6294, _e6683, (_e6683 < _e6294));
let _e6691 = global_4.member[bitcast<u32>(select(0i, _e6685, (_e6685 > 0i)))];
let _e6707 = (_e935.member_1.member_3.x + _e6431);
let _e6710 = ((((((_e935.member_1.member_3.z + _e6412) * bitcast<i32>(_e6419)) + _e935.member_1.member_3.y) + _e6413) * bitcast<i32>(_e6427)) + (_e6707 >> bitcast<u32>(5i)));
let _e6714 = (bitcast<i32>(_e218) - 1i);
let _e6716 = select(_e6714, _e6710, (_e6710 < _e6714));
let _e6722 = global_6.member[bitcast<u32>(select(0i, _e6716, (_e6716 > 0i)))];
let _e6724 = (bitcast<i32>(_e216) - 1i);
let _e6726 = select(_e6724, _e6710, (_e6710 < _e6724));
let _e6732 = global_5.member[bitcast<u32>(select(0i, _e6726, (_e6726 > 0i)))];
let _e6741 = (bitcast<i32>((_e6722 + countOneBits((_e6732 & ((1u << bitcast<u32>((bitcast<u32>((_e6707 & 31i)) & 31u))) - 1u))))) * 14i);
let _e6742 = bitcast<u32>(_e6741);
if (_e6742 < _e220) {
let _e6746 = atomicAdd((&global_7.member[_e6742]), 1u);
}
let _e6748 = bitcast<u32>((_e6741 + 1i));
if (_e6748 < _e220) {
let _e6752 = atomicMax((&global_7.member[_e6748]), bitcast<u32>((_e6313 - select(0i, 1i, (_e6306 < f32(_e6313))))));
}
let _e6758 = (((_e6588 * _e6610) * 65536f) + 0.5f);
let _e6760 = select(-1073741800f, _e6758, (_e6758 > -1073741800f));
let _e6762 = select(1073741800f, _e6760, (_e6760 < 1073741800f));
let _e6769 = select(0i, select(select(i32(_e6762), i32(-2147483648), (_e6762 < -2147483600f)), 2147483647i, (_e6762 > 2147483500f)), (_e6762 == _e6762));
let _e6773 = (_e6769 - select(0i, 1i, (_e6762 < f32(_e6769))));
if (_e6773 == 0i) {
} else {
let _e6775 = bitcast<u32>(_e6773);
let _e6776 = bitcast<u32>((_e6741 + 2i));
if (_e6776 < _e220) {
let _e6780 = atomicAdd((&global_7.member[_e6776]), _e6775);
phi_11755_ = _e6780;
} else {
phi_11755_ = 0u;
}
let _e6782 = phi_11755_;
let _e6789 = (bitcast<u32>((_e6773 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e6782 + _e6775) < _e6775)));
if (_e6789 == 0u) {
} else {
let _e6791 = (_e6776 + 1u);
if (_e6791 < _e220) {
let _e6795 = atomicAdd((&global_7.member[_e6791]), _e6789);
}
}
}
let _e6798 = (((_e6593 * _e6610) * 65536f) + 0.5f);
let _e6800 = select(-1073741800f, _e6798, (_e6798 > -1073741800f));
let _e6802 = select(1073741800f, _e6800, (_e6800 < 1073741800f));
let _e6809 = select(0i, select(select(i32(_e6802), i32(-2147483648), (_e6802 < -2147483600f)), 2147483647i, (_e6802 > 2147483500f)), (_e6802 == _e6802));
let _e6813 = (_e6809 - select(0i, 1i, (_e6802 < f32(_e6809))));
if (_e6813 == 0i) {
} else {
let _e6815 = bitcast<u32>(_e6813);
let _e6816 = bitcast<u32>((_e6741 + 4i));
if (_e6816 < _e220) {
let _e6820 = atomicAdd((&global_7.member[_e6816]), _e6815);
phi_11812_ = _e6820;
} else {
phi_11812_ = 0u;
}
let _e6822 = phi_11812_;
let _e6829 = (bitcast<u32>((_e6813 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e6822 + _e6815) < _e6815)));
if (_e6829 == 0u) {
} else {
let _e6831 = (_e6816 + 1u);
if (_e6831 < _e220) {
let _e6835 = atomicAdd((&global_7.member[_e6831]), _e6829);
}
}
}
let _e6838 = (((_e6598 * _e6610) * 65536f) + 0.5f);
let _e6840 = select(-1073741800f, _e6838, (_e6838 > -1073741800f));
let _e6842 = select(1073741800f, _e6840, (_e6840 < 1073741800f));
let _e6849 = select(0i, select(select(i32(_e6842), i32(-2147483648), (_e6842 < -2147483600f)), 2147483647i, (_e6842 > 2147483500f)), (_e6842 == _e6842));
let _e6853 = (_e6849 - select(0i, 1i, (_e6842 < f32(_e6849))));
if (_e6853 == 0i) {
} else {
let _e6855 = bitcast<u32>(_e6853);
let _e6856 = bitcast<u32>((_e6741 + 6i));
if (_e6856 < _e220) {
let _e6860 = atomicAdd((&global_7.member[_e6856]), _e6855);
phi_11869_ = _e6860;
} else {
phi_11869_ = 0u;
}
let _e6862 = phi_11869_;
let _e6869 = (bitcast<u32>((_e6853 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e6862 + _e6855) < _e6855)));
if (_e6869 == 0u) {
} else {
let _e6871 = (_e6856 + 1u);
if (_e6871 < _e220) {
let _e6875 = atomicAdd((&global_7.member[_e6871]), _e6869);
}
}
}
let _e6878 = (((((_e6619 * _e6501) + (_e6646 * _e6502)) + (_e6673 * _e6503)) * 65536f) + 0.5f);
let _e6880 = select(-1073741800f, _e6878, (_e6878 > -1073741800f));
let _e6882 = select(1073741800f, _e6880, (_e6880 < 1073741800f));
let _e6889 = select(0i, select(select(i32(_e6882), i32(-2147483648), (_e6882 < -2147483600f)), 2147483647i, (_e6882 > 2147483500f)), (_e6882 == _e6882));
let _e6893 = (_e6889 - select(0i, 1i, (_e6882 < f32(_e6889))));
if (_e6893 == 0i) {
} else {
let _e6895 = bitcast<u32>(_e6893);
let _e6896 = bitcast<u32>((_e6741 + 8i));
if (_e6896 < _e220) {
let _e6900 = atomicAdd((&global_7.member[_e6896]), _e6895);
phi_11927_ = _e6900;
} else {
phi_11927_ = 0u;
}
let _e6902 = phi_11927_;
let _e6909 = (bitcast<u32>((_e6893 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e6902 + _e6895) < _e6895)));
if (_e6909 == 0u) {
} else {
let _e6911 = (_e6896 + 1u);
if (_e6911 < _e220) {
let _e6915 = atomicAdd((&global_7.member[_e6911]), _e6909);
}
}
}
let _e6918 = (((((_e6628 * _e6501) + (_e6655 * _e6502)) + (_e6682 * _e6503)) * 65536f) + 0.5f);
let _e6920 = select(-1073741800f, _e6918, (_e6918 > -1073741800f));
let _e6922 = select(1073741800f, _e6920, (_e6920 < 1073741800f));
let _e6929 = select(0i, select(select(i32(_e6922), i32(-2147483648), (_e6922 < -2147483600f)), 2147483647i, (_e6922 > 2147483500f)), (_e6922 == _e6922));
let _e6933 = (_e6929 - select(0i, 1i, (_e6922 < f32(_e6929))));
if (_e6933 == 0i) {
} else {
let _e6935 = bitcast<u32>(_e6933);
let _e6936 = bitcast<u32>((_e6741 + 10i));
if (_e6936 < _e220) {
let _e6940 = atomicAdd((&global_7.member[_e6936]), _e6935);
phi_11984_ = _e6940;
} else {
phi_11984_ = 0u;
}
let _e6942 = phi_11984_;
let _e6949 = (bitcast<u32>((_e6933 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e6942 + _e6935) < _e6935)));
if (_e6949 == 0u) {
} else {
let _e6951 = (_e6936 + 1u);
if (_e6951 < _e220) {
let _e6955 = atomicAdd((&global_7.member[_e6951]), _e6949);
}
}
}
let _e6958 = (((((_e6637 * _e6501) + (_e6664 * _e6502)) + (_e6691 * _e6503)) * 65536f) + 0.5f);
let _e6960 = select(-1073741800f, _e6958, (_e6958 > -1073741800f));
let _e6962 = select(1073741800f, _e6960, (_e6960 < 1073741800f));
let _e6969 = select(0i, select(select(i32(_e6962), i32(-2147483648), (_e6962 < -2147483600f)), 2147483647i, (_e6962 > 2147483500f)), (_e6962 == _e6962));
let _e6973 = (_e6969 - select(0i, 1i, (_e6962 < f32(_e6969))));
if (_e6973 == 0i) {
} else {
let _e6975 = bitcast<u32>(_e6973);
let _e6976 = bitcast<u32>((_e6741 + 12i));
if (_e6976 < _e220) {
let _e6980 = atomicAdd((&global_7.member[_e6976]), _e6975);
phi_12041_ = _e6980;
} else {
phi_12041_ = 0u;
}
let _e6982 = phi_12041_;
let _e6989 = (bitcast<u32>((_e6973 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e6982 + _e6975) < _e6975)));
if (_e6989 == 0u) {
} else {
let _e6991 = (_e6976 + 1u);
if (_e6991 < _e220) {
let _e6995 = atomicAdd((&global_7.member[_e6991]), _e6989);
}
}
}
phi_11228_ = (_e6431 + 1i);
} else {
phi_11228_ = i32();
}
let _e6998 = phi_11228_;
continue;
continuing {
phi_11227_ = _e6998;
break if !(_e6432);
}
}
phi_11197_ = (_e6410 + 1i);
} else {
phi_11197_ = i32();
}
let _e7002 = phi_11197_;
continue;
continuing {
phi_11196_ = _e7002;
break if !(_e6411);
}
}
phi_11062_ = (_e6320 + 1i);
} else {
phi_11062_ = i32();
}
let _e7006 = phi_11062_;
continue;
continuing {
phi_11061_ = _e7006;
break if !(_e6321);
}
}
} else {
if (_e961 == 2u) {
let _e4197 = (_e935.member_1.member_6 & 31u);
let _e4199 = (_e935.member_1.member_3.x << bitcast<u32>(_e4197));
let _e4202 = (_e935.member_1.member_7 & 31u);
let _e4206 = ((1i << bitcast<u32>(_e4202)) >> bitcast<u32>(1i));
let _e4212 = bitcast<i32>(_e935.member_1.member_6);
let _e4218 = bitcast<f32>((bitcast<u32>((127i + (bitcast<i32>(_e935.member_1.member_7) - _e4212))) << bitcast<u32>(23i)));
let _e4219 = (f32((((_e935.member_1.member.x - _e4199) + _e4206) >> bitcast<u32>(_e4202))) * _e4218);
let _e4224 = (_e935.member_1.member_3.y << bitcast<u32>(_e4197));
let _e4230 = (f32((((_e935.member_1.member.y - _e4224) + _e4206) >> bitcast<u32>(_e4202))) * _e4218);
let _e4235 = (_e935.member_1.member_3.z << bitcast<u32>(_e4197));
let _e4241 = (f32((((_e935.member_1.member.z - _e4235) + _e4206) >> bitcast<u32>(_e4202))) * _e4218);
let _e4249 = (f32((((_e935.member_1.member_1.x - _e4199) + _e4206) >> bitcast<u32>(_e4202))) * _e4218);
let _e4256 = (f32((((_e935.member_1.member_1.y - _e4224) + _e4206) >> bitcast<u32>(_e4202))) * _e4218);
let _e4263 = (f32((((_e935.member_1.member_1.z - _e4235) + _e4206) >> bitcast<u32>(_e4202))) * _e4218);
let _e4271 = (f32((((_e935.member_1.member_2.x - _e4199) + _e4206) >> bitcast<u32>(_e4202))) * _e4218);
let _e4278 = (f32((((_e935.member_1.member_2.y - _e4224) + _e4206) >> bitcast<u32>(_e4202))) * _e4218);
let _e4285 = (f32((((_e935.member_1.member_2.z - _e4235) + _e4206) >> bitcast<u32>(_e4202))) * _e4218);
let _e4293 = (f32(_e935.member_1.member_5) * bitcast<f32>((bitcast<u32>((127i - _e4212)) << bitcast<u32>(23i))));
let _e4294 = (_e4249 - _e4219);
let _e4295 = (_e4256 - _e4230);
let _e4296 = (_e4263 - _e4241);
let _e4297 = (_e4271 - _e4249);
let _e4298 = (_e4278 - _e4256);
let _e4299 = (_e4285 - _e4263);
let _e4302 = ((_e4295 * _e4299) - (_e4296 * _e4298));
let _e4303 = (_e4296 * _e4297);
let _e4304 = (_e4294 * _e4299);
let _e4316 = ((bitcast<f32>((bitcast<u32>(_e4303) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e4304) & 2147483647u))) * 2.3841858e-7f);
let _e4317 = f32(_e935.member_1.member_4.x);
let _e4318 = (1f + _e4293);
let _e4320 = -((_e4303 - _e4304));
let _e4321 = (_e935.member_1.member_4.z >= _e935.member_1.member_4.y);
if _e4321 {
let _e4415 = select(1f, -1f, (_e4302 < 0f));
let _e4420 = ((_e4241 - _e4263) * _e4415);
let _e4421 = ((_e4263 - _e4285) * _e4415);
let _e4422 = ((_e4285 - _e4241) * _e4415);
let _e4423 = ((0f - 0f) * _e4415);
let _e4425 = (_e4295 * _e4415);
let _e4426 = (_e4298 * _e4415);
let _e4427 = ((_e4230 - _e4278) * _e4415);
if (select(0u, 1u, ((_e4420 * _e4318) > -((_e4420 * _e4293)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4421 * _e4318) > -((_e4421 * _e4293)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4422 * _e4318) > -((_e4422 * _e4293)))) < 2u) {
} else {
break;
}
let _e4451 = (select(0u, 1u, ((_e4423 * _e4318) > -((_e4423 * _e4293)))) < 2u);
if _e4451 {
} else {
break;
}
if (select(0u, 1u, ((_e4425 * _e4318) > -((_e4425 * _e4293)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4426 * _e4318) > -((_e4426 * _e4293)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4427 * _e4318) > -((_e4427 * _e4293)))) < 2u) {
} else {
break;
}
if _e4451 {
} else {
break;
}
if (select(0u, 1u, (_e4420 == 0f)) < 2u) {
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
if (select(0u, 1u, (_e4420 > 0f)) < 2u) {
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
if (select(0u, 1u, (_e4420 < 0f)) < 2u) {
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
} else {
let _e4323 = select(1f, -1f, (-(_e4302) < 0f));
let _e4328 = ((_e4230 - _e4256) * _e4323);
let _e4329 = ((_e4256 - _e4278) * _e4323);
let _e4330 = ((_e4278 - _e4230) * _e4323);
let _e4331 = ((0f - 0f) * _e4323);
let _e4333 = (_e4296 * _e4323);
let _e4334 = (_e4299 * _e4323);
let _e4335 = ((_e4241 - _e4285) * _e4323);
if (select(0u, 1u, ((_e4328 * _e4318) > -((_e4328 * _e4293)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4329 * _e4318) > -((_e4329 * _e4293)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4330 * _e4318) > -((_e4330 * _e4293)))) < 2u) {
} else {
break;
}
let _e4359 = (select(0u, 1u, ((_e4331 * _e4318) > -((_e4331 * _e4293)))) < 2u);
if _e4359 {
} else {
break;
}
if (select(0u, 1u, ((_e4333 * _e4318) > -((_e4333 * _e4293)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4334 * _e4318) > -((_e4334 * _e4293)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4335 * _e4318) > -((_e4335 * _e4293)))) < 2u) {
} else {
break;
}
if _e4359 {
} else {
break;
}
if (select(0u, 1u, (_e4328 == 0f)) < 2u) {
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
if (select(0u, 1u, (_e4328 > 0f)) < 2u) {
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
if (select(0u, 1u, (_e4328 < 0f)) < 2u) {
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
}
let _e4508 = select(1f, -1f, (((_e4294 * _e4298) - (_e4295 * _e4297)) < 0f));
let _e4511 = (_e4278 - _e4230);
let _e4512 = (0f - 0f);
let _e4513 = ((_e4230 - _e4256) * _e4508);
let _e4514 = ((_e4256 - _e4278) * _e4508);
let _e4515 = (_e4511 * _e4508);
let _e4516 = (_e4512 * _e4508);
let _e4517 = (_e4219 - _e4271);
let _e4518 = (_e4294 * _e4508);
let _e4519 = (_e4297 * _e4508);
let _e4520 = (_e4517 * _e4508);
if (select(0u, 1u, ((_e4513 * _e4318) > -((_e4513 * _e4293)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4514 * _e4318) > -((_e4514 * _e4293)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4515 * _e4318) > -((_e4515 * _e4293)))) < 2u) {
} else {
break;
}
let _e4544 = (select(0u, 1u, ((_e4516 * _e4318) > -((_e4516 * _e4293)))) < 2u);
if _e4544 {
} else {
break;
}
if (select(0u, 1u, ((_e4518 * _e4318) > -((_e4518 * _e4293)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4519 * _e4318) > -((_e4519 * _e4293)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4520 * _e4318) > -((_e4520 * _e4293)))) < 2u) {
} else {
break;
}
if _e4544 {
} else {
break;
}
if (select(0u, 1u, (_e4513 == 0f)) < 2u) {
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
if (select(0u, 1u, (_e4513 > 0f)) < 2u) {
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
if (select(0u, 1u, (_e4513 < 0f)) < 2u) {
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
let _e4600 = select(1f, -1f, (_e4320 < 0f));
let _e4606 = select(0f, (2f * _e4316), (bitcast<f32>((bitcast<u32>(_e4320) & 2147483647u)) <= _e4316));
let _e4609 = (_e4285 - _e4241);
let _e4610 = ((_e4241 - _e4263) * _e4600);
let _e4611 = ((_e4263 - _e4285) * _e4600);
let _e4612 = (_e4609 * _e4600);
let _e4613 = (_e4512 * _e4600);
let _e4614 = (_e4294 * _e4600);
let _e4615 = (_e4297 * _e4600);
let _e4616 = (_e4517 * _e4600);
let _e4617 = (_e4610 * _e4318);
let _e4618 = (_e4611 * _e4318);
let _e4619 = (_e4612 * _e4318);
let _e4625 = -((_e4610 * _e4293));
let _e4626 = -((_e4611 * _e4293));
let _e4627 = -((_e4612 * _e4293));
local_97 = array<u32, 2>(0u, 4294967295u);
let _e4633 = select(0u, 1u, (_e4617 > _e4625));
if (_e4633 < 2u) {
} else {
break;
}
let _e4636 = local_97[_e4633];
local_98 = array<u32, 2>(0u, 4294967295u);
let _e4637 = select(0u, 1u, (_e4618 > _e4626));
if (_e4637 < 2u) {
} else {
break;
}
let _e4640 = local_98[_e4637];
local_99 = array<u32, 2>(0u, 4294967295u);
let _e4641 = select(0u, 1u, (_e4619 > _e4627));
if (_e4641 < 2u) {
} else {
break;
}
let _e4644 = local_99[_e4641];
let _e4646 = (select(0u, 1u, ((_e4613 * _e4318) > -((_e4613 * _e4293)))) < 2u);
if _e4646 {
} else {
break;
}
let _e4662 = (_e4614 * _e4318);
let _e4663 = (_e4615 * _e4318);
let _e4664 = (_e4616 * _e4318);
let _e4668 = -((_e4614 * _e4293));
let _e4669 = -((_e4615 * _e4293));
let _e4670 = -((_e4616 * _e4293));
local_94 = array<u32, 2>(0u, 4294967295u);
let _e4674 = select(0u, 1u, (_e4662 > _e4668));
if (_e4674 < 2u) {
} else {
break;
}
let _e4677 = local_94[_e4674];
local_95 = array<u32, 2>(0u, 4294967295u);
let _e4678 = select(0u, 1u, (_e4663 > _e4669));
if (_e4678 < 2u) {
} else {
break;
}
let _e4681 = local_95[_e4678];
local_96 = array<u32, 2>(0u, 4294967295u);
let _e4682 = select(0u, 1u, (_e4664 > _e4670));
if (_e4682 < 2u) {
} else {
break;
}
let _e4685 = local_96[_e4682];
if _e4646 {
} else {
break;
}
local_91 = array<u32, 2>(0u, 4294967295u);
let _e4711 = select(0u, 1u, (_e4610 == 0f));
if (_e4711 < 2u) {
} else {
break;
}
let _e4714 = local_91[_e4711];
local_92 = array<u32, 2>(0u, 4294967295u);
let _e4715 = select(0u, 1u, (_e4611 == 0f));
if (_e4715 < 2u) {
} else {
break;
}
let _e4718 = local_92[_e4715];
local_93 = array<u32, 2>(0u, 4294967295u);
let _e4719 = select(0u, 1u, (_e4612 == 0f));
if (_e4719 < 2u) {
} else {
break;
}
let _e4722 = local_93[_e4719];
if (select(0u, 1u, (_e4613 == 0f)) < 2u) {
} else {
break;
}
let _e4726 = ((_e4714 & 1u) != 0u);
let _e4729 = ((_e4718 & 1u) != 0u);
let _e4732 = ((_e4722 & 1u) != 0u);
let _e4734 = (-1f / select(_e4610, 1f, _e4726));
let _e4735 = (-1f / select(_e4611, 1f, _e4729));
let _e4736 = (-1f / select(_e4612, 1f, _e4732));
local_88 = array<u32, 2>(0u, 4294967295u);
let _e4741 = select(0u, 1u, (_e4610 > 0f));
if (_e4741 < 2u) {
} else {
break;
}
let _e4744 = local_88[_e4741];
local_89 = array<u32, 2>(0u, 4294967295u);
let _e4745 = select(0u, 1u, (_e4611 > 0f));
if (_e4745 < 2u) {
} else {
break;
}
let _e4748 = local_89[_e4745];
local_90 = array<u32, 2>(0u, 4294967295u);
let _e4749 = select(0u, 1u, (_e4612 > 0f));
if (_e4749 < 2u) {
} else {
break;
}
let _e4752 = local_90[_e4749];
if (select(0u, 1u, (_e4613 > 0f)) < 2u) {
} else {
break;
}
local_85 = array<u32, 2>(0u, 4294967295u);
let _e4759 = select(0u, 1u, (_e4610 < 0f));
if (_e4759 < 2u) {
} else {
break;
}
let _e4762 = local_85[_e4759];
local_86 = array<u32, 2>(0u, 4294967295u);
let _e4763 = select(0u, 1u, (_e4611 < 0f));
if (_e4763 < 2u) {
} else {
break;
}
let _e4766 = local_86[_e4763];
local_87 = array<u32, 2>(0u, 4294967295u);
let _e4767 = select(0u, 1u, (_e4612 < 0f));
if (_e4767 < 2u) {
} else {
break;
}
let _e4770 = local_87[_e4767];
if (select(0u, 1u, (_e4613 < 0f)) < 2u) {
} else {
break;
}
let _e4786 = ((_e4762 & 1u) != 0u);
let _e4789 = ((_e4766 & 1u) != 0u);
let _e4792 = ((_e4770 & 1u) != 0u);
let _e4797 = (_e4271 - _e4219);
let _e4799 = (_e935.member.member * 19i);
let _e4800 = (_e4799 + 18i);
let _e4802 = (bitcast<i32>(_e214) - 1i);
let _e4804 = select(_e4802, _e4800, (_e4800 < _e4802));
let _e4810 = global_4.member[bitcast<u32>(select(0i, _e4804, (_e4804 > 0i)))];
let _e4812 = select(0f, _e4810, (_e4810 > 0f));
let _e4814 = select(16777216f, _e4812, (_e4812 < 16777216f));
let _e4821 = select(0i, select(select(i32(_e4814), i32(-2147483648), (_e4814 < -2147483600f)), 2147483647i, (_e4814 > 2147483500f)), (_e4814 == _e4814));
phi_16061_ = _e935.member.member_1;
loop {
let _e4828 = phi_16061_;
let _e4829 = (_e4828 < _e935.member.member_2);
if _e4829 {
if _e4321 {
phi_16076_ = _e935.member_1.member_4.y;
} else {
phi_16076_ = _e935.member_1.member_4.z;
}
let _e4833 = phi_16076_;
phi_16078_ = 0i;
loop {
let _e4835 = phi_16078_;
let _e4836 = (_e4835 <= _e4833);
if _e4836 {
let _e4837 = select(_e4835, _e4828, _e4321);
let _e4838 = select(_e4828, _e4835, _e4321);
let _e4839 = f32(_e4837);
let _e4841 = f32(_e935.member_1.member_4.x);
let _e4845 = ((_e4614 * _e4839) + (((select(_e4625, _e4617, ((_e4636 & 1u) != 0u)) - (_e4610 * _e4219)) + (select(_e4668, _e4662, ((_e4677 & 1u) != 0u)) - (_e4614 * _e4241))) + _e4606));
let _e4846 = ((_e4615 * _e4839) + (((select(_e4626, _e4618, ((_e4640 & 1u) != 0u)) - (_e4611 * _e4249)) + (select(_e4669, _e4663, ((_e4681 & 1u) != 0u)) - (_e4615 * _e4263))) + _e4606));
let _e4847 = ((_e4616 * _e4839) + (((select(_e4627, _e4619, ((_e4644 & 1u) != 0u)) - (_e4612 * _e4271)) + (select(_e4670, _e4664, ((_e4685 & 1u) != 0u)) - (_e4616 * _e4285))) + _e4606));
let _e4848 = (_e4845 * select(0f, _e4734, ((_e4744 & 1u) != 0u)));
let _e4849 = (_e4846 * select(0f, _e4735, ((_e4748 & 1u) != 0u)));
let _e4850 = (_e4847 * select(0f, _e4736, ((_e4752 & 1u) != 0u)));
let _e4854 = ((_e4845 * select(select(0f, 1e20f, _e4726), _e4734, _e4786)) + select(_e4317, 0f, _e4786));
let _e4855 = ((_e4846 * select(select(0f, 1e20f, _e4729), _e4735, _e4789)) + select(_e4317, 0f, _e4789));
let _e4856 = ((_e4847 * select(select(0f, 1e20f, _e4732), _e4736, _e4792)) + select(_e4317, 0f, _e4792));
let _e4858 = select(_e4848, 0f, (0f > _e4848));
let _e4860 = select(_e4850, _e4849, (_e4849 > _e4850));
let _e4864 = select(_e4854, _e4841, (_e4841 < _e4854));
let _e4866 = select(_e4856, _e4855, (_e4855 < _e4856));
let _e4868 = select(_e4866, _e4864, (_e4864 < _e4866));
let _e4869 = -(select(_e4860, _e4858, (_e4858 > _e4860)));
let _e4871 = (-(_e4841) - 1f);
let _e4873 = select(_e4871, _e4869, (_e4869 > _e4871));
let _e4875 = select(0f, _e4873, (_e4873 < 0f));
let _e4882 = select(0i, select(select(i32(_e4875), i32(-2147483648), (_e4875 < -2147483600f)), 2147483647i, (_e4875 > 2147483500f)), (_e4875 == _e4875));
let _e4889 = select(-1f, _e4868, (_e4868 > -1f));
let _e4891 = select(_e4841, _e4889, (_e4889 < _e4841));
let _e4898 = select(0i, select(select(i32(_e4891), i32(-2147483648), (_e4891 < -2147483600f)), 2147483647i, (_e4891 > 2147483500f)), (_e4891 == _e4891));
let _e4907 = global_1.member.member_1[1u];
let _e4915 = global_1.member.member_1[3u];
phi_16206_ = -((_e4882 - select(0i, 1i, (_e4875 < f32(_e4882)))));
loop {
let _e4919 = phi_16206_;
let _e4920 = (_e4919 <= (_e4898 - select(0i, 1i, (_e4891 < f32(_e4898)))));
if _e4920 {
let _e4926 = ((f32(_e4919) + 0.5f) - _e4219);
let _e4927 = ((f32(_e4838) + 0.5f) - _e4230);
let _e4928 = ((_e4839 + 0.5f) - _e4241);
let _e4933 = (((_e4294 * _e4294) + (_e4295 * _e4295)) + (_e4296 * _e4296));
let _e4938 = (((_e4294 * _e4797) + (_e4295 * _e4511)) + (_e4296 * _e4609));
let _e4943 = (((_e4797 * _e4797) + (_e4511 * _e4511)) + (_e4609 * _e4609));
let _e4948 = (((_e4926 * _e4294) + (_e4927 * _e4295)) + (_e4928 * _e4296));
let _e4953 = (((_e4926 * _e4797) + (_e4927 * _e4511)) + (_e4928 * _e4609));
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
let _e4992 = select(_e4802, _e4799, (_e4799 < _e4802));
let _e4998 = global_4.member[bitcast<u32>(select(0i, _e4992, (_e4992 > 0i)))];
let _e4999 = (_e4799 + 1i);
let _e5001 = select(_e4802, _e4999, (_e4999 < _e4802));
let _e5007 = global_4.member[bitcast<u32>(select(0i, _e5001, (_e5001 > 0i)))];
let _e5008 = (_e4799 + 2i);
let _e5010 = select(_e4802, _e5008, (_e5008 < _e4802));
let _e5016 = global_4.member[bitcast<u32>(select(0i, _e5010, (_e5010 > 0i)))];
let _e5017 = (_e4799 + 3i);
let _e5019 = select(_e4802, _e5017, (_e5017 < _e4802));
let _e5025 = global_4.member[bitcast<u32>(select(0i, _e5019, (_e5019 > 0i)))];
let _e5026 = (_e4799 + 4i);
let _e5028 = select(_e4802, _e5026, (_e5026 < _e4802));
let _e5034 = global_4.member[bitcast<u32>(select(0i, _e5028, (_e5028 > 0i)))];
let _e5035 = (_e4799 + 5i);
let _e5037 = select(_e4802, _e5035, (_e5035 < _e4802));
let _e5043 = global_4.member[bitcast<u32>(select(0i, _e5037, (_e5037 > 0i)))];
let _e5044 = (_e4799 + 6i);
let _e5046 = select(_e4802, _e5044, (_e5044 < _e4802));
let _e5052 = global_4.member[bitcast<u32>(select(0i, _e5046, (_e5046 > 0i)))];
let _e5053 = (_e4799 + 7i);
let _e5055 = select(_e4802, _e5053, (_e5053 < _e4802));
let _e5061 = global_4.member[bitcast<u32>(select(0i, _e5055, (_e5055 > 0i)))];
let _e5062 = (_e4799 + 8i);
let _e5064 = select(_e4802, _e5062, (_e5062 < _e4802));
let _e5070 = global_4.member[bitcast<u32>(select(0i, _e5064, (_e5064 > 0i)))];
let _e5075 = (((_e4998 * _e4988) + (_e5025 * _e4989)) + (_e5052 * _e4990));
let _e5080 = (((_e5007 * _e4988) + (_e5034 * _e4989)) + (_e5061 * _e4990));
let _e5085 = (((_e5016 * _e4988) + (_e5043 * _e4989)) + (_e5070 * _e4990));
let _e5090 = (((_e5075 * _e5075) + (_e5080 * _e5080)) + (_e5085 * _e5085));
let _e5093 = sqrt(select(0f, _e5090, (_e5090 > 0f)));
let _e5094 = (_e5093 > 1e-6f);
let _e5097 = select(0f, (1f / select(1e-6f, _e5093, _e5094)), _e5094);
let _e5098 = (_e4799 + 9i);
let _e5100 = select(_e4802, _e5098, (_e5098 < _e4802));
let _e5106 = global_4.member[bitcast<u32>(select(0i, _e5100, (_e5100 > 0i)))];
let _e5107 = (_e4799 + 10i);
let _e5109 = select(_e4802, _e5107, (_e5107 < _e4802));
let _e5115 = global_4.member[bitcast<u32>(select(0i, _e5109, (_e5109 > 0i)))];
let _e5116 = (_e4799 + 11i);
let _e5118 = select(_e4802, _e5116, (_e5116 < _e4802));
let _e5124 = global_4.member[bitcast<u32>(select(0i, _e5118, (_e5118 > 0i)))];
let _e5125 = (_e4799 + 12i);
let _e5127 = select(_e4802, _e5125, (_e5125 < _e4802));
let _e5133 = global_4.member[bitcast<u32>(select(0i, _e5127, (_e5127 > 0i)))];
let _e5134 = (_e4799 + 13i);
let _e5136 = select(_e4802, _e5134, (_e5134 < _e4802));
let _e5142 = global_4.member[bitcast<u32>(select(0i, _e5136, (_e5136 > 0i)))];
let _e5143 = (_e4799 + 14i);
let _e5145 = select(_e4802, _e5143, (_e5143 < _e4802));
let _e5151 = global_4.member[bitcast<u32>(select(0i, _e5145, (_e5145 > 0i)))];
let _e5152 = (_e4799 + 15i);
let _e5154 = select(_e4802, _e5152, (_e5152 < _e4802));
let _e5160 = global_4.member[bitcast<u32>(select(0i, _e5154, (_e5154 > 0i)))];
let _e5161 = (_e4799 + 16i);
let _e5163 = select(_e4802, _e5161, (_e5161 < _e4802));
let _e5169 = global_4.member[bitcast<u32>(select(0i, _e5163, (_e5163 > 0i)))];
let _e5170 = (_e4799 + 17i);
let _e5172 = select(_e4802, _e5170, (_e5170 < _e4802));
let _e5178 = global_4.member[bitcast<u32>(select(0i, _e5172, (_e5172 > 0i)))];
let _e5194 = (_e935.member_1.member_3.x + _e4919);
let _e5197 = ((((((_e935.member_1.member_3.z + _e4837) * bitcast<i32>(_e4907)) + _e935.member_1.member_3.y) + _e4838) * bitcast<i32>(_e4915)) + (_e5194 >> bitcast<u32>(5i)));
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
let _e5239 = atomicMax((&global_7.member[_e5235]), bitcast<u32>((_e4821 - select(0i, 1i, (_e4814 < f32(_e4821))))));
}
let _e5245 = (((_e5075 * _e5097) * 65536f) + 0.5f);
let _e5247 = select(-1073741800f, _e5245, (_e5245 > -1073741800f));
let _e5249 = select(1073741800f, _e5247, (_e5247 < 1073741800f));
let _e5256 = select(0i, select(select(i32(_e5249), i32(-2147483648), (_e5249 < -2147483600f)), 2147483647i, (_e5249 > 2147483500f)), (_e5249 == _e5249));
let _e5260 = (_e5256 - select(0i, 1i, (_e5249 < f32(_e5256))));
if (_e5260 == 0i) {
} else {
let _e5262 = bitcast<u32>(_e5260);
let _e5263 = bitcast<u32>((_e5228 + 2i));
if (_e5263 < _e220) {
let _e5267 = atomicAdd((&global_7.member[_e5263]), _e5262);
phi_16734_ = _e5267;
} else {
phi_16734_ = 0u;
}
let _e5269 = phi_16734_;
let _e5276 = (bitcast<u32>((_e5260 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e5269 + _e5262) < _e5262)));
if (_e5276 == 0u) {
} else {
let _e5278 = (_e5263 + 1u);
if (_e5278 < _e220) {
let _e5282 = atomicAdd((&global_7.member[_e5278]), _e5276);
}
}
}
let _e5285 = (((_e5080 * _e5097) * 65536f) + 0.5f);
let _e5287 = select(-1073741800f, _e5285, (_e5285 > -1073741800f));
let _e5289 = select(1073741800f, _e5287, (_e5287 < 1073741800f));
let _e5296 = select(0i, select(select(i32(_e5289), i32(-2147483648), (_e5289 < -2147483600f)), 2147483647i, (_e5289 > 2147483500f)), (_e5289 == _e5289));
let _e5300 = (_e5296 - select(0i, 1i, (_e5289 < f32(_e5296))));
if (_e5300 == 0i) {
} else {
let _e5302 = bitcast<u32>(_e5300);
let _e5303 = bitcast<u32>((_e5228 + 4i));
if (_e5303 < _e220) {
let _e5307 = atomicAdd((&global_7.member[_e5303]), _e5302);
phi_16791_ = _e5307;
} else {
phi_16791_ = 0u;
}
let _e5309 = phi_16791_;
let _e5316 = (bitcast<u32>((_e5300 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e5309 + _e5302) < _e5302)));
if (_e5316 == 0u) {
} else {
let _e5318 = (_e5303 + 1u);
if (_e5318 < _e220) {
let _e5322 = atomicAdd((&global_7.member[_e5318]), _e5316);
}
}
}
let _e5325 = (((_e5085 * _e5097) * 65536f) + 0.5f);
let _e5327 = select(-1073741800f, _e5325, (_e5325 > -1073741800f));
let _e5329 = select(1073741800f, _e5327, (_e5327 < 1073741800f));
let _e5336 = select(0i, select(select(i32(_e5329), i32(-2147483648), (_e5329 < -2147483600f)), 2147483647i, (_e5329 > 2147483500f)), (_e5329 == _e5329));
let _e5340 = (_e5336 - select(0i, 1i, (_e5329 < f32(_e5336))));
if (_e5340 == 0i) {
} else {
let _e5342 = bitcast<u32>(_e5340);
let _e5343 = bitcast<u32>((_e5228 + 6i));
if (_e5343 < _e220) {
let _e5347 = atomicAdd((&global_7.member[_e5343]), _e5342);
phi_16848_ = _e5347;
} else {
phi_16848_ = 0u;
}
let _e5349 = phi_16848_;
let _e5356 = (bitcast<u32>((_e5340 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e5349 + _e5342) < _e5342)));
if (_e5356 == 0u) {
} else {
let _e5358 = (_e5343 + 1u);
if (_e5358 < _e220) {
let _e5362 = atomicAdd((&global_7.member[_e5358]), _e5356);
}
}
}
let _e5365 = (((((_e5106 * _e4988) + (_e5133 * _e4989)) + (_e5160 * _e4990)) * 65536f) + 0.5f);
let _e5367 = select(-1073741800f, _e5365, (_e5365 > -1073741800f));
let _e5369 = select(1073741800f, _e5367, (_e5367 < 1073741800f));
let _e5376 = select(0i, select(select(i32(_e5369), i32(-2147483648), (_e5369 < -2147483600f)), 2147483647i, (_e5369 > 2147483500f)), (_e5369 == _e5369));
let _e5380 = (_e5376 - select(0i, 1i, (_e5369 < f32(_e5376))));
if (_e5380 == 0i) {
} else {
let _e5382 = bitcast<u32>(_e5380);
let _e5383 = bitcast<u32>((_e5228 + 8i));
if (_e5383 < _e220) {
let _e5387 = atomicAdd((&global_7.member[_e5383]), _e5382);
phi_16906_ = _e5387;
} else {
phi_16906_ = 0u;
}
let _e5389 = phi_16906_;
let _e5396 = (bitcast<u32>((_e5380 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e5389 + _e5382) < _e5382)));
if (_e5396 == 0u) {
} else {
let _e5398 = (_e5383 + 1u);
if (_e5398 < _e220) {
let _e5402 = atomicAdd((&global_7.member[_e5398]), _e5396);
}
}
}
let _e5405 = (((((_e5115 * _e4988) + (_e5142 * _e4989)) + (_e5169 * _e4990)) * 65536f) + 0.5f);
let _e5407 = select(-1073741800f, _e5405, (_e5405 > -1073741800f));
let _e5409 = select(1073741800f, _e5407, (_e5407 < 1073741800f));
let _e5416 = select(0i, select(select(i32(_e5409), i32(-2147483648), (_e5409 < -2147483600f)), 2147483647i, (_e5409 > 2147483500f)), (_e5409 == _e5409));
let _e5420 = (_e5416 - select(0i, 1i, (_e5409 < f32(_e5416))));
if (_e5420 == 0i) {
} else {
let _e5422 = bitcast<u32>(_e5420);
let _e5423 = bitcast<u32>((_e5228 + 10i));
if (_e5423 < _e220) {
let _e5427 = atomicAdd((&global_7.member[_e5423]), _e5422);
phi_16963_ = _e5427;
} else {
phi_16963_ = 0u;
}
let _e5429 = phi_16963_;
let _e5436 = (bitcast<u32>((_e5420 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e5429 + _e5422) < _e5422)));
if (_e5436 == 0u) {
} else {
let _e5438 = (_e5423 + 1u);
if (_e5438 < _e220) {
let _e5442 = atomicAdd((&global_7.member[_e5438]), _e5436);
}
}
}
let _e5445 = (((((_e5124 * _e4988) + (_e5151 * _e4989)) + (_e5178 * _e4990)) * 65536f) + 0.5f);
let _e5447 = select(-1073741800f, _e5445, (_e5445 > -1073741800f));
let _e5449 = select(1073741800f, _e5447, (_e5447 < 1073741800f));
let _e5456 = select(0i, select(select(i32(_e5449), i32(-2147483648), (_e5449 < -2147483600f)), 2147483647i, (_e5449 > 2147483500f)), (_e5449 == _e5449));
let _e5460 = (_e5456 - select(0i, 1i, (_e5449 < f32(_e5456))));
if (_e5460 == 0i) {
} else {
let _e5462 = bitcast<u32>(_e5460);
let _e5463 = bitcast<u32>((_e5228 + 12i));
if (_e5463 < _e220) {
let _e5467 = atomicAdd((&global_7.member[_e5463]), _e5462);
phi_17020_ = _e5467;
} else {
phi_17020_ = 0u;
}
let _e5469 = phi_17020_;
let _e5476 = (bitcast<u32>((_e5460 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e5469 + _e5462) < _e5462)));
if (_e5476 == 0u) {
} else {
let _e5478 = (_e5463 + 1u);
if (_e5478 < _e220) {
let _e5482 = atomicAdd((&global_7.member[_e5478]), _e5476);
}
}
}
phi_16207_ = (_e4919 + 1i);
} else {
phi_16207_ = i32();
}
let _e5485 = phi_16207_;
continue;
continuing {
phi_16206_ = _e5485;
break if !(_e4920);
}
}
phi_16079_ = (_e4835 + 1i);
} else {
phi_16079_ = i32();
}
let _e5489 = phi_16079_;
continue;
continuing {
phi_16078_ = _e5489;
break if !(_e4836);
}
}
phi_16062_ = (_e4828 + 1i);
} else {
phi_16062_ = i32();
}
let _e5493 = phi_16062_;
continue;
continuing {
phi_16061_ = _e5493;
break if !(_e4829);
}
}
} else {
if (_e961 == 3u) {
let _e2894 = (_e935.member_1.member_6 & 31u);
let _e2896 = (_e935.member_1.member_3.x << bitcast<u32>(_e2894));
let _e2899 = (_e935.member_1.member_7 & 31u);
let _e2903 = ((1i << bitcast<u32>(_e2899)) >> bitcast<u32>(1i));
let _e2909 = bitcast<i32>(_e935.member_1.member_6);
let _e2915 = bitcast<f32>((bitcast<u32>((127i + (bitcast<i32>(_e935.member_1.member_7) - _e2909))) << bitcast<u32>(23i)));
let _e2916 = (f32((((_e935.member_1.member.x - _e2896) + _e2903) >> bitcast<u32>(_e2899))) * _e2915);
let _e2921 = (_e935.member_1.member_3.y << bitcast<u32>(_e2894));
let _e2927 = (f32((((_e935.member_1.member.y - _e2921) + _e2903) >> bitcast<u32>(_e2899))) * _e2915);
let _e2932 = (_e935.member_1.member_3.z << bitcast<u32>(_e2894));
let _e2938 = (f32((((_e935.member_1.member.z - _e2932) + _e2903) >> bitcast<u32>(_e2899))) * _e2915);
let _e2946 = (f32((((_e935.member_1.member_1.x - _e2896) + _e2903) >> bitcast<u32>(_e2899))) * _e2915);
let _e2953 = (f32((((_e935.member_1.member_1.y - _e2921) + _e2903) >> bitcast<u32>(_e2899))) * _e2915);
let _e2960 = (f32((((_e935.member_1.member_1.z - _e2932) + _e2903) >> bitcast<u32>(_e2899))) * _e2915);
let _e2968 = (f32((((_e935.member_1.member_2.x - _e2896) + _e2903) >> bitcast<u32>(_e2899))) * _e2915);
let _e2975 = (f32((((_e935.member_1.member_2.y - _e2921) + _e2903) >> bitcast<u32>(_e2899))) * _e2915);
let _e2982 = (f32((((_e935.member_1.member_2.z - _e2932) + _e2903) >> bitcast<u32>(_e2899))) * _e2915);
let _e2990 = (f32(_e935.member_1.member_5) * bitcast<f32>((bitcast<u32>((127i - _e2909)) << bitcast<u32>(23i))));
let _e2991 = (_e2946 - _e2916);
let _e2992 = (_e2953 - _e2927);
let _e2993 = (_e2960 - _e2938);
let _e2994 = (_e2968 - _e2946);
let _e2995 = (_e2975 - _e2953);
let _e2996 = (_e2982 - _e2960);
let _e2999 = ((_e2992 * _e2996) - (_e2993 * _e2995));
let _e3003 = (_e2991 * _e2995);
let _e3004 = (_e2992 * _e2994);
let _e3005 = (_e3003 - _e3004);
let _e3013 = ((bitcast<f32>((bitcast<u32>(_e3003) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e3004) & 2147483647u))) * 2.3841858e-7f);
let _e3014 = f32(_e935.member_1.member_4.x);
let _e3015 = (1f + _e2990);
let _e3018 = (_e935.member_1.member_4.z >= _e935.member_1.member_4.y);
if _e3018 {
let _e3112 = select(1f, -1f, (_e2999 < 0f));
let _e3117 = ((_e2938 - _e2960) * _e3112);
let _e3118 = ((_e2960 - _e2982) * _e3112);
let _e3119 = ((_e2982 - _e2938) * _e3112);
let _e3120 = ((0f - 0f) * _e3112);
let _e3122 = (_e2992 * _e3112);
let _e3123 = (_e2995 * _e3112);
let _e3124 = ((_e2927 - _e2975) * _e3112);
if (select(0u, 1u, ((_e3117 * _e3015) > -((_e3117 * _e2990)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3118 * _e3015) > -((_e3118 * _e2990)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3119 * _e3015) > -((_e3119 * _e2990)))) < 2u) {
} else {
break;
}
let _e3148 = (select(0u, 1u, ((_e3120 * _e3015) > -((_e3120 * _e2990)))) < 2u);
if _e3148 {
} else {
break;
}
if (select(0u, 1u, ((_e3122 * _e3015) > -((_e3122 * _e2990)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3123 * _e3015) > -((_e3123 * _e2990)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3124 * _e3015) > -((_e3124 * _e2990)))) < 2u) {
} else {
break;
}
if _e3148 {
} else {
break;
}
if (select(0u, 1u, (_e3117 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3118 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3119 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3120 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3117 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3118 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3119 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3120 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3117 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3118 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3119 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3120 < 0f)) < 2u) {
} else {
break;
}
} else {
let _e3020 = select(1f, -1f, (-(_e2999) < 0f));
let _e3025 = ((_e2927 - _e2953) * _e3020);
let _e3026 = ((_e2953 - _e2975) * _e3020);
let _e3027 = ((_e2975 - _e2927) * _e3020);
let _e3028 = ((0f - 0f) * _e3020);
let _e3030 = (_e2993 * _e3020);
let _e3031 = (_e2996 * _e3020);
let _e3032 = ((_e2938 - _e2982) * _e3020);
if (select(0u, 1u, ((_e3025 * _e3015) > -((_e3025 * _e2990)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3026 * _e3015) > -((_e3026 * _e2990)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3027 * _e3015) > -((_e3027 * _e2990)))) < 2u) {
} else {
break;
}
let _e3056 = (select(0u, 1u, ((_e3028 * _e3015) > -((_e3028 * _e2990)))) < 2u);
if _e3056 {
} else {
break;
}
if (select(0u, 1u, ((_e3030 * _e3015) > -((_e3030 * _e2990)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3031 * _e3015) > -((_e3031 * _e2990)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3032 * _e3015) > -((_e3032 * _e2990)))) < 2u) {
} else {
break;
}
if _e3056 {
} else {
break;
}
if (select(0u, 1u, (_e3025 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3026 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3027 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3028 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3025 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3026 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3027 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3028 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3025 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3026 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3027 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3028 < 0f)) < 2u) {
} else {
break;
}
}
let _e3205 = select(1f, -1f, (_e3005 < 0f));
let _e3211 = select(0f, (2f * _e3013), (bitcast<f32>((bitcast<u32>(_e3005) & 2147483647u)) <= _e3013));
let _e3214 = (_e2975 - _e2927);
let _e3215 = (0f - 0f);
let _e3216 = ((_e2927 - _e2953) * _e3205);
let _e3217 = ((_e2953 - _e2975) * _e3205);
let _e3218 = (_e3214 * _e3205);
let _e3219 = (_e3215 * _e3205);
let _e3220 = (_e2916 - _e2968);
let _e3221 = (_e2991 * _e3205);
let _e3222 = (_e2994 * _e3205);
let _e3223 = (_e3220 * _e3205);
let _e3224 = (_e3216 * _e3015);
let _e3225 = (_e3217 * _e3015);
let _e3226 = (_e3218 * _e3015);
let _e3232 = -((_e3216 * _e2990));
let _e3233 = -((_e3217 * _e2990));
let _e3234 = -((_e3218 * _e2990));
local_82 = array<u32, 2>(0u, 4294967295u);
let _e3240 = select(0u, 1u, (_e3224 > _e3232));
if (_e3240 < 2u) {
} else {
break;
}
let _e3243 = local_82[_e3240];
local_83 = array<u32, 2>(0u, 4294967295u);
let _e3244 = select(0u, 1u, (_e3225 > _e3233));
if (_e3244 < 2u) {
} else {
break;
}
let _e3247 = local_83[_e3244];
local_84 = array<u32, 2>(0u, 4294967295u);
let _e3248 = select(0u, 1u, (_e3226 > _e3234));
if (_e3248 < 2u) {
} else {
break;
}
let _e3251 = local_84[_e3248];
let _e3253 = (select(0u, 1u, ((_e3219 * _e3015) > -((_e3219 * _e2990)))) < 2u);
if _e3253 {
} else {
break;
}
let _e3269 = (_e3221 * _e3015);
let _e3270 = (_e3222 * _e3015);
let _e3271 = (_e3223 * _e3015);
let _e3275 = -((_e3221 * _e2990));
let _e3276 = -((_e3222 * _e2990));
let _e3277 = -((_e3223 * _e2990));
local_79 = array<u32, 2>(0u, 4294967295u);
let _e3281 = select(0u, 1u, (_e3269 > _e3275));
if (_e3281 < 2u) {
} else {
break;
}
let _e3284 = local_79[_e3281];
local_80 = array<u32, 2>(0u, 4294967295u);
let _e3285 = select(0u, 1u, (_e3270 > _e3276));
if (_e3285 < 2u) {
} else {
break;
}
let _e3288 = local_80[_e3285];
local_81 = array<u32, 2>(0u, 4294967295u);
let _e3289 = select(0u, 1u, (_e3271 > _e3277));
if (_e3289 < 2u) {
} else {
break;
}
let _e3292 = local_81[_e3289];
if _e3253 {
} else {
break;
}
local_76 = array<u32, 2>(0u, 4294967295u);
let _e3318 = select(0u, 1u, (_e3216 == 0f));
if (_e3318 < 2u) {
} else {
break;
}
let _e3321 = local_76[_e3318];
local_77 = array<u32, 2>(0u, 4294967295u);
let _e3322 = select(0u, 1u, (_e3217 == 0f));
if (_e3322 < 2u) {
} else {
break;
}
let _e3325 = local_77[_e3322];
local_78 = array<u32, 2>(0u, 4294967295u);
let _e3326 = select(0u, 1u, (_e3218 == 0f));
if (_e3326 < 2u) {
} else {
break;
}
let _e3329 = local_78[_e3326];
if (select(0u, 1u, (_e3219 == 0f)) < 2u) {
} else {
break;
}
let _e3333 = ((_e3321 & 1u) != 0u);
let _e3336 = ((_e3325 & 1u) != 0u);
let _e3339 = ((_e3329 & 1u) != 0u);
let _e3341 = (-1f / select(_e3216, 1f, _e3333));
let _e3342 = (-1f / select(_e3217, 1f, _e3336));
let _e3343 = (-1f / select(_e3218, 1f, _e3339));
local_73 = array<u32, 2>(0u, 4294967295u);
let _e3348 = select(0u, 1u, (_e3216 > 0f));
if (_e3348 < 2u) {
} else {
break;
}
let _e3351 = local_73[_e3348];
local_74 = array<u32, 2>(0u, 4294967295u);
let _e3352 = select(0u, 1u, (_e3217 > 0f));
if (_e3352 < 2u) {
} else {
break;
}
let _e3355 = local_74[_e3352];
local_75 = array<u32, 2>(0u, 4294967295u);
let _e3356 = select(0u, 1u, (_e3218 > 0f));
if (_e3356 < 2u) {
} else {
break;
}
let _e3359 = local_75[_e3356];
if (select(0u, 1u, (_e3219 > 0f)) < 2u) {
} else {
break;
}
local_70 = array<u32, 2>(0u, 4294967295u);
let _e3366 = select(0u, 1u, (_e3216 < 0f));
if (_e3366 < 2u) {
} else {
break;
}
let _e3369 = local_70[_e3366];
local_71 = array<u32, 2>(0u, 4294967295u);
let _e3370 = select(0u, 1u, (_e3217 < 0f));
if (_e3370 < 2u) {
} else {
break;
}
let _e3373 = local_71[_e3370];
local_72 = array<u32, 2>(0u, 4294967295u);
let _e3374 = select(0u, 1u, (_e3218 < 0f));
if (_e3374 < 2u) {
} else {
break;
}
let _e3377 = local_72[_e3374];
if (select(0u, 1u, (_e3219 < 0f)) < 2u) {
} else {
break;
}
let _e3393 = ((_e3369 & 1u) != 0u);
let _e3396 = ((_e3373 & 1u) != 0u);
let _e3399 = ((_e3377 & 1u) != 0u);
let _e3405 = select(1f, -1f, (-(((_e2993 * _e2994) - (_e2991 * _e2996))) < 0f));
let _e3408 = (_e2982 - _e2938);
let _e3409 = ((_e2938 - _e2960) * _e3405);
let _e3410 = ((_e2960 - _e2982) * _e3405);
let _e3411 = (_e3408 * _e3405);
let _e3412 = (_e3215 * _e3405);
let _e3413 = (_e2991 * _e3405);
let _e3414 = (_e2994 * _e3405);
let _e3415 = (_e3220 * _e3405);
if (select(0u, 1u, ((_e3409 * _e3015) > -((_e3409 * _e2990)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3410 * _e3015) > -((_e3410 * _e2990)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3411 * _e3015) > -((_e3411 * _e2990)))) < 2u) {
} else {
break;
}
let _e3439 = (select(0u, 1u, ((_e3412 * _e3015) > -((_e3412 * _e2990)))) < 2u);
if _e3439 {
} else {
break;
}
if (select(0u, 1u, ((_e3413 * _e3015) > -((_e3413 * _e2990)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3414 * _e3015) > -((_e3414 * _e2990)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3415 * _e3015) > -((_e3415 * _e2990)))) < 2u) {
} else {
break;
}
if _e3439 {
} else {
break;
}
if (select(0u, 1u, (_e3409 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3410 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3411 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3412 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3409 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3410 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3411 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3412 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3409 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3410 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3411 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3412 < 0f)) < 2u) {
} else {
break;
}
let _e3494 = (_e2968 - _e2916);
let _e3496 = (_e935.member.member * 19i);
let _e3497 = (_e3496 + 18i);
let _e3499 = (bitcast<i32>(_e214) - 1i);
let _e3501 = select(_e3499, _e3497, (_e3497 < _e3499));
let _e3507 = global_4.member[bitcast<u32>(select(0i, _e3501, (_e3501 > 0i)))];
let _e3509 = select(0f, _e3507, (_e3507 > 0f));
let _e3511 = select(16777216f, _e3509, (_e3509 < 16777216f));
let _e3518 = select(0i, select(select(i32(_e3511), i32(-2147483648), (_e3511 < -2147483600f)), 2147483647i, (_e3511 > 2147483500f)), (_e3511 == _e3511));
phi_21040_ = _e935.member.member_1;
loop {
let _e3525 = phi_21040_;
let _e3526 = (_e3525 < _e935.member.member_2);
if _e3526 {
if _e3018 {
phi_21055_ = _e935.member_1.member_4.y;
} else {
phi_21055_ = _e935.member_1.member_4.z;
}
let _e3530 = phi_21055_;
phi_21057_ = 0i;
loop {
let _e3532 = phi_21057_;
let _e3533 = (_e3532 <= _e3530);
if _e3533 {
let _e3534 = select(_e3532, _e3525, _e3018);
let _e3535 = select(_e3525, _e3532, _e3018);
let _e3536 = f32(_e3535);
let _e3538 = f32(_e935.member_1.member_4.x);
let _e3542 = ((_e3221 * _e3536) + (((select(_e3232, _e3224, ((_e3243 & 1u) != 0u)) - (_e3216 * _e2916)) + (select(_e3275, _e3269, ((_e3284 & 1u) != 0u)) - (_e3221 * _e2927))) + _e3211));
let _e3543 = ((_e3222 * _e3536) + (((select(_e3233, _e3225, ((_e3247 & 1u) != 0u)) - (_e3217 * _e2946)) + (select(_e3276, _e3270, ((_e3288 & 1u) != 0u)) - (_e3222 * _e2953))) + _e3211));
let _e3544 = ((_e3223 * _e3536) + (((select(_e3234, _e3226, ((_e3251 & 1u) != 0u)) - (_e3218 * _e2968)) + (select(_e3277, _e3271, ((_e3292 & 1u) != 0u)) - (_e3223 * _e2975))) + _e3211));
let _e3545 = (_e3542 * select(0f, _e3341, ((_e3351 & 1u) != 0u)));
let _e3546 = (_e3543 * select(0f, _e3342, ((_e3355 & 1u) != 0u)));
let _e3547 = (_e3544 * select(0f, _e3343, ((_e3359 & 1u) != 0u)));
let _e3551 = ((_e3542 * select(select(0f, 1e20f, _e3333), _e3341, _e3393)) + select(_e3014, 0f, _e3393));
let _e3552 = ((_e3543 * select(select(0f, 1e20f, _e3336), _e3342, _e3396)) + select(_e3014, 0f, _e3396));
let _e3553 = ((_e3544 * select(select(0f, 1e20f, _e3339), _e3343, _e3399)) + select(_e3014, 0f, _e3399));
let _e3555 = select(_e3545, 0f, (0f > _e3545));
let _e3557 = select(_e3547, _e3546, (_e3546 > _e3547));
let _e3561 = select(_e3551, _e3538, (_e3538 < _e3551));
let _e3563 = select(_e3553, _e3552, (_e3552 < _e3553));
let _e3565 = select(_e3563, _e3561, (_e3561 < _e3563));
let _e3566 = -(select(_e3557, _e3555, (_e3555 > _e3557)));
let _e3568 = (-(_e3538) - 1f);
let _e3570 = select(_e3568, _e3566, (_e3566 > _e3568));
let _e3572 = select(0f, _e3570, (_e3570 < 0f));
let _e3579 = select(0i, select(select(i32(_e3572), i32(-2147483648), (_e3572 < -2147483600f)), 2147483647i, (_e3572 > 2147483500f)), (_e3572 == _e3572));
let _e3586 = select(-1f, _e3565, (_e3565 > -1f));
let _e3588 = select(_e3538, _e3586, (_e3586 < _e3538));
let _e3595 = select(0i, select(select(i32(_e3588), i32(-2147483648), (_e3588 < -2147483600f)), 2147483647i, (_e3588 > 2147483500f)), (_e3588 == _e3588));
let _e3604 = global_1.member.member_1[1u];
let _e3612 = global_1.member.member_1[3u];
phi_21185_ = -((_e3579 - select(0i, 1i, (_e3572 < f32(_e3579)))));
loop {
let _e3616 = phi_21185_;
let _e3617 = (_e3616 <= (_e3595 - select(0i, 1i, (_e3588 < f32(_e3595)))));
if _e3617 {
let _e3623 = ((f32(_e3616) + 0.5f) - _e2916);
let _e3624 = ((_e3536 + 0.5f) - _e2927);
let _e3625 = ((f32(_e3534) + 0.5f) - _e2938);
let _e3630 = (((_e2991 * _e2991) + (_e2992 * _e2992)) + (_e2993 * _e2993));
let _e3635 = (((_e2991 * _e3494) + (_e2992 * _e3214)) + (_e2993 * _e3408));
let _e3640 = (((_e3494 * _e3494) + (_e3214 * _e3214)) + (_e3408 * _e3408));
let _e3645 = (((_e3623 * _e2991) + (_e3624 * _e2992)) + (_e3625 * _e2993));
let _e3650 = (((_e3623 * _e3494) + (_e3624 * _e3214)) + (_e3625 * _e3408));
let _e3653 = ((_e3630 * _e3640) - (_e3635 * _e3635));
let _e3654 = (_e3653 > 0f);
let _e3657 = select(0f, (1f / select(1f, _e3653, _e3654)), _e3654);
let _e3661 = (((_e3640 * _e3645) - (_e3635 * _e3650)) * _e3657);
let _e3665 = (((_e3630 * _e3650) - (_e3635 * _e3645)) * _e3657);
let _e3667 = ((1f - _e3661) - _e3665);
let _e3669 = select(0f, _e3667, (_e3667 > 0f));
let _e3671 = select(16777216f, _e3669, (_e3669 < 16777216f));
let _e3673 = select(0f, _e3661, (_e3661 > 0f));
let _e3675 = select(16777216f, _e3673, (_e3673 < 16777216f));
let _e3677 = select(0f, _e3665, (_e3665 > 0f));
let _e3679 = select(16777216f, _e3677, (_e3677 < 16777216f));
let _e3681 = ((_e3671 + _e3675) + _e3679);
let _e3684 = (1f / select(0.5f, _e3681, (_e3681 > 0.5f)));
let _e3685 = (_e3671 * _e3684);
let _e3686 = (_e3675 * _e3684);
let _e3687 = (_e3679 * _e3684);
let _e3689 = select(_e3499, _e3496, (_e3496 < _e3499));
let _e3695 = global_4.member[bitcast<u32>(select(0i, _e3689, (_e3689 > 0i)))];
let _e3696 = (_e3496 + 1i);
let _e3698 = select(_e3499, _e3696, (_e3696 < _e3499));
let _e3704 = global_4.member[bitcast<u32>(select(0i, _e3698, (_e3698 > 0i)))];
let _e3705 = (_e3496 + 2i);
let _e3707 = select(_e3499, _e3705, (_e3705 < _e3499));
let _e3713 = global_4.member[bitcast<u32>(select(0i, _e3707, (_e3707 > 0i)))];
let _e3714 = (_e3496 + 3i);
let _e3716 = select(_e3499, _e3714, (_e3714 < _e3499));
let _e3722 = global_4.member[bitcast<u32>(select(0i, _e3716, (_e3716 > 0i)))];
let _e3723 = (_e3496 + 4i);
let _e3725 = select(_e3499, _e3723, (_e3723 < _e3499));
let _e3731 = global_4.member[bitcast<u32>(select(0i, _e3725, (_e3725 > 0i)))];
let _e3732 = (_e3496 + 5i);
let _e3734 = select(_e3499, _e3732, (_e3732 < _e3499));
let _e3740 = global_4.member[bitcast<u32>(select(0i, _e3734, (_e3734 > 0i)))];
let _e3741 = (_e3496 + 6i);
let _e3743 = select(_e3499, _e3741, (_e3741 < _e3499));
let _e3749 = global_4.member[bitcast<u32>(select(0i, _e3743, (_e3743 > 0i)))];
let _e3750 = (_e3496 + 7i);
let _e3752 = select(_e3499, _e3750, (_e3750 < _e3499));
let _e3758 = global_4.member[bitcast<u32>(select(0i, _e3752, (_e3752 > 0i)))];
let _e3759 = (_e3496 + 8i);
let _e3761 = select(_e3499, _e3759, (_e3759 < _e3499));
let _e3767 = global_4.member[bitcast<u32>(select(0i, _e3761, (_e3761 > 0i)))];
let _e3772 = (((_e3695 * _e3685) + (_e3722 * _e3686)) + (_e3749 * _e3687));
let _e3777 = (((_e3704 * _e3685) + (_e3731 * _e3686)) + (_e3758 * _e3687));
let _e3782 = (((_e3713 * _e3685) + (_e3740 * _e3686)) + (_e3767 * _e3687));
let _e3787 = (((_e3772 * _e3772) + (_e3777 * _e3777)) + (_e3782 * _e3782));
let _e3790 = sqrt(select(0f, _e3787, (_e3787 > 0f)));
let _e3791 = (_e3790 > 1e-6f);
let _e3794 = select(0f, (1f / select(1e-6f, _e3790, _e3791)), _e3791);
let _e3795 = (_e3496 + 9i);
let _e3797 = select(_e3499, _e3795, (_e3795 < _e3499));
let _e3803 = global_4.member[bitcast<u32>(select(0i, _e3797, (_e3797 > 0i)))];
let _e3804 = (_e3496 + 10i);
let _e3806 = select(_e3499, _e3804, (_e3804 < _e3499));
let _e3812 = global_4.member[bitcast<u32>(select(0i, _e3806, (_e3806 > 0i)))];
let _e3813 = (_e3496 + 11i);
let _e3815 = select(_e3499, _e3813, (_e3813 < _e3499));
let _e3821 = global_4.member[bitcast<u32>(select(0i, _e3815, (_e3815 > 0i)))];
let _e3822 = (_e3496 + 12i);
let _e3824 = select(_e3499, _e3822, (_e3822 < _e3499));
let _e3830 = global_4.member[bitcast<u32>(select(0i, _e3824, (_e3824 > 0i)))];
let _e3831 = (_e3496 + 13i);
let _e3833 = select(_e3499, _e3831, (_e3831 < _e3499));
let _e3839 = global_4.member[bitcast<u32>(select(0i, _e3833, (_e3833 > 0i)))];
let _e3840 = (_e3496 + 14i);
let _e3842 = select(_e3499, _e3840, (_e3840 < _e3499));
let _e3848 = global_4.member[bitcast<u32>(select(0i, _e3842, (_e3842 > 0i)))];
let _e3849 = (_e3496 + 15i);
let _e3851 = select(_e3499, _e3849, (_e3849 < _e3499));
let _e3857 = global_4.member[bitcast<u32>(select(0i, _e3851, (_e3851 > 0i)))];
let _e3858 = (_e3496 + 16i);
let _e3860 = select(_e3499, _e3858, (_e3858 < _e3499));
let _e3866 = global_4.member[bitcast<u32>(select(0i, _e3860, (_e3860 > 0i)))];
let _e3867 = (_e3496 + 17i);
let _e3869 = select(_e3499, _e3867, (_e3867 < _e3499));
let _e3875 = global_4.member[bitcast<u32>(select(0i, _e3869, (_e3869 > 0i)))];
let _e3891 = (_e935.member_1.member_3.x + _e3616);
let _e3894 = ((((((_e935.member_1.member_3.z + _e3534) * bitcast<i32>(_e3604)) + _e935.member_1.member_3.y) + _e3535) * bitcast<i32>(_e3612)) + (_e3891 >> bitcast<u32>(5i)));
let _e3898 = (bitcast<i32>(_e218) - 1i);
let _e3900 = select(_e3898, _e3894, (_e3894 < _e3898));
let _e3906 = global_6.member[bitcast<u32>(select(0i, _e3900, (_e3900 > 0i)))];
let _e3908 = (bitcast<i32>(_e216) - 1i);
let _e3910 = select(_e3908, _e3894, (_e3894 < _e3908));
let _e3916 = global_5.member[bitcast<u32>(select(0i, _e3910, (_e3910 > 0i)))];
let _e3925 = (bitcast<i32>((_e3906 + countOneBits((_e3916 & ((1u << bitcast<u32>((bitcast<u32>((_e3891 & 31i)) & 31u))) - 1u))))) * 14i);
let _e3926 = bitcast<u32>(_e3925);
if (_e3926 < _e220) {
let _e3930 = atomicAdd((&global_7.member[_e3926]), 1u);
}
let _e3932 = bitcast<u32>((_e3925 + 1i));
if (_e3932 < _e220) {
let _e3936 = atomicMax((&global_7.member[_e3932]), bitcast<u32>((_e3518 - select(0i, 1i, (_e3511 < f32(_e3518))))));
}
let _e3942 = (((_e3772 * _e3794) * 65536f) + 0.5f);
let _e3944 = select(-1073741800f, _e3942, (_e3942 > -1073741800f));
let _e3946 = select(1073741800f, _e3944, (_e3944 < 1073741800f));
let _e3953 = select(0i, select(select(i32(_e3946), i32(-2147483648), (_e3946 < -2147483600f)), 2147483647i, (_e3946 > 2147483500f)), (_e3946 == _e3946));
let _e3957 = (_e3953 - select(0i, 1i, (_e3946 < f32(_e3953))));
if (_e3957 == 0i) {
} else {
let _e3959 = bitcast<u32>(_e3957);
let _e3960 = bitcast<u32>((_e3925 + 2i));
if (_e3960 < _e220) {
let _e3964 = atomicAdd((&global_7.member[_e3960]), _e3959);
phi_21713_ = _e3964;
} else {
phi_21713_ = 0u;
}
let _e3966 = phi_21713_;
let _e3973 = (bitcast<u32>((_e3957 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e3966 + _e3959) < _e3959)));
if (_e3973 == 0u) {
} else {
let _e3975 = (_e3960 + 1u);
if (_e3975 < _e220) {
let _e3979 = atomicAdd((&global_7.member[_e3975]), _e3973);
}
}
}
let _e3982 = (((_e3777 * _e3794) * 65536f) + 0.5f);
let _e3984 = select(-1073741800f, _e3982, (_e3982 > -1073741800f));
let _e3986 = select(1073741800f, _e3984, (_e3984 < 1073741800f));
let _e3993 = select(0i, select(select(i32(_e3986), i32(-2147483648), (_e3986 < -2147483600f)), 2147483647i, (_e3986 > 2147483500f)), (_e3986 == _e3986));
let _e3997 = (_e3993 - select(0i, 1i, (_e3986 < f32(_e3993))));
if (_e3997 == 0i) {
} else {
let _e3999 = bitcast<u32>(_e3997);
let _e4000 = bitcast<u32>((_e3925 + 4i));
if (_e4000 < _e220) {
let _e4004 = atomicAdd((&global_7.member[_e4000]), _e3999);
phi_21770_ = _e4004;
} else {
phi_21770_ = 0u;
}
let _e4006 = phi_21770_;
let _e4013 = (bitcast<u32>((_e3997 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e4006 + _e3999) < _e3999)));
if (_e4013 == 0u) {
} else {
let _e4015 = (_e4000 + 1u);
if (_e4015 < _e220) {
let _e4019 = atomicAdd((&global_7.member[_e4015]), _e4013);
}
}
}
let _e4022 = (((_e3782 * _e3794) * 65536f) + 0.5f);
let _e4024 = select(-1073741800f, _e4022, (_e4022 > -1073741800f));
let _e4026 = select(1073741800f, _e4024, (_e4024 < 1073741800f));
let _e4033 = select(0i, select(select(i32(_e4026), i32(-2147483648), (_e4026 < -2147483600f)), 2147483647i, (_e4026 > 2147483500f)), (_e4026 == _e4026));
let _e4037 = (_e4033 - select(0i, 1i, (_e4026 < f32(_e4033))));
if (_e4037 == 0i) {
} else {
let _e4039 = bitcast<u32>(_e4037);
let _e4040 = bitcast<u32>((_e3925 + 6i));
if (_e4040 < _e220) {
let _e4044 = atomicAdd((&global_7.member[_e4040]), _e4039);
phi_21827_ = _e4044;
} else {
phi_21827_ = 0u;
}
let _e4046 = phi_21827_;
let _e4053 = (bitcast<u32>((_e4037 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e4046 + _e4039) < _e4039)));
if (_e4053 == 0u) {
} else {
let _e4055 = (_e4040 + 1u);
if (_e4055 < _e220) {
let _e4059 = atomicAdd((&global_7.member[_e4055]), _e4053);
}
}
}
let _e4062 = (((((_e3803 * _e3685) + (_e3830 * _e3686)) + (_e3857 * _e3687)) * 65536f) + 0.5f);
let _e4064 = select(-1073741800f, _e4062, (_e4062 > -1073741800f));
let _e4066 = select(1073741800f, _e4064, (_e4064 < 1073741800f));
let _e4073 = select(0i, select(select(i32(_e4066), i32(-2147483648), (_e4066 < -2147483600f)), 2147483647i, (_e4066 > 2147483500f)), (_e4066 == _e4066));
let _e4077 = (_e4073 - select(0i, 1i, (_e4066 < f32(_e4073))));
if (_e4077 == 0i) {
} else {
let _e4079 = bitcast<u32>(_e4077);
let _e4080 = bitcast<u32>((_e3925 + 8i));
if (_e4080 < _e220) {
let _e4084 = atomicAdd((&global_7.member[_e4080]), _e4079);
phi_21885_ = _e4084;
} else {
phi_21885_ = 0u;
}
let _e4086 = phi_21885_;
let _e4093 = (bitcast<u32>((_e4077 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e4086 + _e4079) < _e4079)));
if (_e4093 == 0u) {
} else {
let _e4095 = (_e4080 + 1u);
if (_e4095 < _e220) {
let _e4099 = atomicAdd((&global_7.member[_e4095]), _e4093);
}
}
}
let _e4102 = (((((_e3812 * _e3685) + (_e3839 * _e3686)) + (_e3866 * _e3687)) * 65536f) + 0.5f);
let _e4104 = select(-1073741800f, _e4102, (_e4102 > -1073741800f));
let _e4106 = select(1073741800f, _e4104, (_e4104 < 1073741800f));
let _e4113 = select(0i, select(select(i32(_e4106), i32(-2147483648), (_e4106 < -2147483600f)), 2147483647i, (_e4106 > 2147483500f)), (_e4106 == _e4106));
let _e4117 = (_e4113 - select(0i, 1i, (_e4106 < f32(_e4113))));
if (_e4117 == 0i) {
} else {
let _e4119 = bitcast<u32>(_e4117);
let _e4120 = bitcast<u32>((_e3925 + 10i));
if (_e4120 < _e220) {
let _e4124 = atomicAdd((&global_7.member[_e4120]), _e4119);
phi_21942_ = _e4124;
} else {
phi_21942_ = 0u;
}
let _e4126 = phi_21942_;
let _e4133 = (bitcast<u32>((_e4117 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e4126 + _e4119) < _e4119)));
if (_e4133 == 0u) {
} else {
let _e4135 = (_e4120 + 1u);
if (_e4135 < _e220) {
let _e4139 = atomicAdd((&global_7.member[_e4135]), _e4133);
}
}
}
let _e4142 = (((((_e3821 * _e3685) + (_e3848 * _e3686)) + (_e3875 * _e3687)) * 65536f) + 0.5f);
let _e4144 = select(-1073741800f, _e4142, (_e4142 > -1073741800f));
let _e4146 = select(1073741800f, _e4144, (_e4144 < 1073741800f));
let _e4153 = select(0i, select(select(i32(_e4146), i32(-2147483648), (_e4146 < -2147483600f)), 2147483647i, (_e4146 > 2147483500f)), (_e4146 == _e4146));
let _e4157 = (_e4153 - select(0i, 1i, (_e4146 < f32(_e4153))));
if (_e4157 == 0i) {
} else {
let _e4159 = bitcast<u32>(_e4157);
let _e4160 = bitcast<u32>((_e3925 + 12i));
if (_e4160 < _e220) {
let _e4164 = atomicAdd((&global_7.member[_e4160]), _e4159);
phi_21999_ = _e4164;
} else {
phi_21999_ = 0u;
}
let _e4166 = phi_21999_;
let _e4173 = (bitcast<u32>((_e4157 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e4166 + _e4159) < _e4159)));
if (_e4173 == 0u) {
} else {
let _e4175 = (_e4160 + 1u);
if (_e4175 < _e220) {
let _e4179 = atomicAdd((&global_7.member[_e4175]), _e4173);
}
}
}
phi_21186_ = (_e3616 + 1i);
} else {
phi_21186_ = i32();
}
let _e4182 = phi_21186_;
continue;
continuing {
phi_21185_ = _e4182;
break if !(_e3617);
}
}
phi_21058_ = (_e3532 + 1i);
} else {
phi_21058_ = i32();
}
let _e4186 = phi_21058_;
continue;
continuing {
phi_21057_ = _e4186;
break if !(_e3533);
}
}
phi_21041_ = (_e3525 + 1i);
} else {
phi_21041_ = i32();
}
let _e4190 = phi_21041_;
continue;
continuing {
phi_21040_ = _e4190;
break if !(_e3526);
}
}
} else {
let _e971 = (_e935.member_1.member_6 & 31u);
let _e973 = (_e935.member_1.member_3.x << bitcast<u32>(_e971));
let _e976 = (_e935.member_1.member_7 & 31u);
let _e980 = ((1i << bitcast<u32>(_e976)) >> bitcast<u32>(1i));
let _e986 = bitcast<i32>(_e935.member_1.member_6);
let _e992 = bitcast<f32>((bitcast<u32>((127i + (bitcast<i32>(_e935.member_1.member_7) - _e986))) << bitcast<u32>(23i)));
let _e993 = (f32((((_e935.member_1.member.x - _e973) + _e980) >> bitcast<u32>(_e976))) * _e992);
let _e998 = (_e935.member_1.member_3.y << bitcast<u32>(_e971));
let _e1004 = (f32((((_e935.member_1.member.y - _e998) + _e980) >> bitcast<u32>(_e976))) * _e992);
let _e1009 = (_e935.member_1.member_3.z << bitcast<u32>(_e971));
let _e1015 = (f32((((_e935.member_1.member.z - _e1009) + _e980) >> bitcast<u32>(_e976))) * _e992);
let _e1023 = (f32((((_e935.member_1.member_1.x - _e973) + _e980) >> bitcast<u32>(_e976))) * _e992);
let _e1030 = (f32((((_e935.member_1.member_1.y - _e998) + _e980) >> bitcast<u32>(_e976))) * _e992);
let _e1037 = (f32((((_e935.member_1.member_1.z - _e1009) + _e980) >> bitcast<u32>(_e976))) * _e992);
let _e1045 = (f32((((_e935.member_1.member_2.x - _e973) + _e980) >> bitcast<u32>(_e976))) * _e992);
let _e1052 = (f32((((_e935.member_1.member_2.y - _e998) + _e980) >> bitcast<u32>(_e976))) * _e992);
let _e1059 = (f32((((_e935.member_1.member_2.z - _e1009) + _e980) >> bitcast<u32>(_e976))) * _e992);
let _e1067 = (f32(_e935.member_1.member_5) * bitcast<f32>((bitcast<u32>((127i - _e986)) << bitcast<u32>(23i))));
let _e1068 = (_e1023 - _e993);
let _e1069 = (_e1030 - _e1004);
let _e1070 = (_e1037 - _e1015);
let _e1071 = (_e1045 - _e1023);
let _e1072 = (_e1052 - _e1030);
let _e1073 = (_e1059 - _e1037);
let _e1074 = (_e1069 * _e1073);
let _e1075 = (_e1070 * _e1072);
let _e1076 = (_e1074 - _e1075);
let _e1077 = (_e1070 * _e1071);
let _e1078 = (_e1068 * _e1073);
let _e1079 = (_e1077 - _e1078);
let _e1080 = (_e1068 * _e1072);
let _e1081 = (_e1069 * _e1071);
let _e1082 = (_e1080 - _e1081);
let _e1090 = ((bitcast<f32>((bitcast<u32>(_e1074) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1075) & 2147483647u))) * 2.3841858e-7f);
let _e1098 = ((bitcast<f32>((bitcast<u32>(_e1077) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1078) & 2147483647u))) * 2.3841858e-7f);
let _e1106 = ((bitcast<f32>((bitcast<u32>(_e1080) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1081) & 2147483647u))) * 2.3841858e-7f);
let _e1107 = f32(_e935.member_1.member_4.x);
let _e1108 = f32(_e935.member_1.member_4.y);
let _e1109 = f32(_e935.member_1.member_4.z);
let _e1111 = select(_e1108, _e1107, (_e1107 > _e1108));
let _e1117 = (((_e1090 + _e1098) + _e1106) * (select(_e1109, _e1111, (_e1111 > _e1109)) + 2f));
let _e1122 = (((_e1076 * _e993) + (_e1079 * _e1004)) + (_e1082 * _e1015));
let _e1123 = (1f + _e1067);
let _e1124 = (_e1076 * _e1123);
let _e1126 = -((_e1076 * _e1067));
let _e1129 = (_e1079 * _e1123);
let _e1131 = -((_e1079 * _e1067));
let _e1135 = (_e1082 * _e1123);
let _e1137 = -((_e1082 * _e1067));
let _e1141 = -(_e1076);
let _e1142 = (_e1141 * _e1123);
let _e1144 = -((_e1141 * _e1067));
let _e1147 = -(_e1079);
let _e1148 = (_e1147 * _e1123);
let _e1150 = -((_e1147 * _e1067));
let _e1154 = -(_e1082);
let _e1155 = (_e1154 * _e1123);
let _e1157 = -((_e1154 * _e1067));
let _e1161 = (_e935.member_1.member_4.z >= _e935.member_1.member_4.y);
if _e1161 {
let _e1402 = select(1f, -1f, (_e1076 < 0f));
let _e1408 = select(0f, (2f * _e1090), (bitcast<f32>((bitcast<u32>(_e1076) & 2147483647u)) <= _e1090));
let _e1413 = ((_e1015 - _e1037) * _e1402);
let _e1414 = ((_e1037 - _e1059) * _e1402);
let _e1415 = ((_e1059 - _e1015) * _e1402);
let _e1416 = ((0f - 0f) * _e1402);
let _e1418 = (_e1069 * _e1402);
let _e1419 = (_e1072 * _e1402);
let _e1420 = ((_e1004 - _e1052) * _e1402);
let _e1422 = (_e1413 * _e1123);
let _e1423 = (_e1414 * _e1123);
let _e1424 = (_e1415 * _e1123);
let _e1425 = (_e1416 * _e1123);
let _e1430 = -((_e1413 * _e1067));
let _e1431 = -((_e1414 * _e1067));
let _e1432 = -((_e1415 * _e1067));
let _e1433 = -((_e1416 * _e1067));
local_66 = array<u32, 2>(0u, 4294967295u);
let _e1438 = select(0u, 1u, (_e1422 > _e1430));
if (_e1438 < 2u) {
} else {
break;
}
let _e1441 = local_66[_e1438];
local_67 = array<u32, 2>(0u, 4294967295u);
let _e1442 = select(0u, 1u, (_e1423 > _e1431));
if (_e1442 < 2u) {
} else {
break;
}
let _e1445 = local_67[_e1442];
local_68 = array<u32, 2>(0u, 4294967295u);
let _e1446 = select(0u, 1u, (_e1424 > _e1432));
if (_e1446 < 2u) {
} else {
break;
}
let _e1449 = local_68[_e1446];
local_69 = array<u32, 2>(0u, 4294967295u);
let _e1450 = select(0u, 1u, (_e1425 > _e1433));
let _e1451 = (_e1450 < 2u);
if _e1451 {
} else {
break;
}
let _e1453 = local_69[_e1450];
let _e1469 = (_e1416 * 0f);
let _e1474 = (_e1418 * _e1123);
let _e1475 = (_e1419 * _e1123);
let _e1476 = (_e1420 * _e1123);
let _e1480 = -((_e1418 * _e1067));
let _e1481 = -((_e1419 * _e1067));
let _e1482 = -((_e1420 * _e1067));
local_62 = array<u32, 2>(0u, 4294967295u);
let _e1486 = select(0u, 1u, (_e1474 > _e1480));
if (_e1486 < 2u) {
} else {
break;
}
let _e1489 = local_62[_e1486];
local_63 = array<u32, 2>(0u, 4294967295u);
let _e1490 = select(0u, 1u, (_e1475 > _e1481));
if (_e1490 < 2u) {
} else {
break;
}
let _e1493 = local_63[_e1490];
local_64 = array<u32, 2>(0u, 4294967295u);
let _e1494 = select(0u, 1u, (_e1476 > _e1482));
if (_e1494 < 2u) {
} else {
break;
}
let _e1497 = local_64[_e1494];
local_65 = array<u32, 2>(0u, 4294967295u);
if _e1451 {
} else {
break;
}
let _e1499 = local_65[_e1450];
local_58 = array<u32, 2>(0u, 4294967295u);
let _e1532 = select(0u, 1u, (_e1413 == 0f));
if (_e1532 < 2u) {
} else {
break;
}
let _e1535 = local_58[_e1532];
local_59 = array<u32, 2>(0u, 4294967295u);
let _e1536 = select(0u, 1u, (_e1414 == 0f));
if (_e1536 < 2u) {
} else {
break;
}
let _e1539 = local_59[_e1536];
local_60 = array<u32, 2>(0u, 4294967295u);
let _e1540 = select(0u, 1u, (_e1415 == 0f));
if (_e1540 < 2u) {
} else {
break;
}
let _e1543 = local_60[_e1540];
local_61 = array<u32, 2>(0u, 4294967295u);
let _e1544 = select(0u, 1u, (_e1416 == 0f));
if (_e1544 < 2u) {
} else {
break;
}
let _e1547 = local_61[_e1544];
let _e1549 = ((_e1535 & 1u) != 0u);
let _e1552 = ((_e1539 & 1u) != 0u);
let _e1555 = ((_e1543 & 1u) != 0u);
let _e1558 = ((_e1547 & 1u) != 0u);
let _e1560 = (-1f / select(_e1413, 1f, _e1549));
let _e1561 = (-1f / select(_e1414, 1f, _e1552));
let _e1562 = (-1f / select(_e1415, 1f, _e1555));
let _e1563 = (-1f / select(_e1416, 1f, _e1558));
local_54 = array<u32, 2>(0u, 4294967295u);
let _e1568 = select(0u, 1u, (_e1413 > 0f));
if (_e1568 < 2u) {
} else {
break;
}
let _e1571 = local_54[_e1568];
local_55 = array<u32, 2>(0u, 4294967295u);
let _e1572 = select(0u, 1u, (_e1414 > 0f));
if (_e1572 < 2u) {
} else {
break;
}
let _e1575 = local_55[_e1572];
local_56 = array<u32, 2>(0u, 4294967295u);
let _e1576 = select(0u, 1u, (_e1415 > 0f));
if (_e1576 < 2u) {
} else {
break;
}
let _e1579 = local_56[_e1576];
local_57 = array<u32, 2>(0u, 4294967295u);
let _e1580 = select(0u, 1u, (_e1416 > 0f));
if (_e1580 < 2u) {
} else {
break;
}
let _e1583 = local_57[_e1580];
local_50 = array<u32, 2>(0u, 4294967295u);
let _e1588 = select(0u, 1u, (_e1413 < 0f));
if (_e1588 < 2u) {
} else {
break;
}
let _e1591 = local_50[_e1588];
local_51 = array<u32, 2>(0u, 4294967295u);
let _e1592 = select(0u, 1u, (_e1414 < 0f));
if (_e1592 < 2u) {
} else {
break;
}
let _e1595 = local_51[_e1592];
local_52 = array<u32, 2>(0u, 4294967295u);
let _e1596 = select(0u, 1u, (_e1415 < 0f));
if (_e1596 < 2u) {
} else {
break;
}
let _e1599 = local_52[_e1596];
local_53 = array<u32, 2>(0u, 4294967295u);
let _e1600 = select(0u, 1u, (_e1416 < 0f));
if (_e1600 < 2u) {
} else {
break;
}
let _e1603 = local_53[_e1600];
let _e1622 = ((_e1591 & 1u) != 0u);
let _e1625 = ((_e1595 & 1u) != 0u);
let _e1628 = ((_e1599 & 1u) != 0u);
let _e1631 = ((_e1603 & 1u) != 0u);
phi_24058_ = type_18(vec4<f32>(_e1418, _e1419, _e1420, _e1416), vec4<f32>((((select(_e1430, _e1422, ((_e1441 & 1u) != 0u)) - (_e1413 * _e1004)) + (select(_e1480, _e1474, ((_e1489 & 1u) != 0u)) - (_e1418 * _e1015))) + _e1408), (((select(_e1431, _e1423, ((_e1445 & 1u) != 0u)) - (_e1414 * _e1030)) + (select(_e1481, _e1475, ((_e1493 & 1u) != 0u)) - (_e1419 * _e1037))) + _e1408), (((select(_e1432, _e1424, ((_e1449 & 1u) != 0u)) - (_e1415 * _e1052)) + (select(_e1482, _e1476, ((_e1497 & 1u) != 0u)) - (_e1420 * _e1059))) + _e1408), (((select(_e1433, _e1425, ((_e1453 & 1u) != 0u)) - _e1469) + (select(_e1433, _e1425, ((_e1499 & 1u) != 0u)) - _e1469)) + _e1408)), vec4<f32>(select(0f, _e1560, ((_e1571 & 1u) != 0u)), select(0f, _e1561, ((_e1575 & 1u) != 0u)), select(0f, _e1562, ((_e1579 & 1u) != 0u)), select(0f, _e1563, ((_e1583 & 1u) != 0u))), vec4<f32>(select(select(0f, 1e20f, _e1549), _e1560, _e1622), select(select(0f, 1e20f, _e1552), _e1561, _e1625), select(select(0f, 1e20f, _e1555), _e1562, _e1628), select(select(0f, 1e20f, _e1558), _e1563, _e1631)), vec4<f32>(select(_e1108, 0f, _e1622), select(_e1108, 0f, _e1625), select(_e1108, 0f, _e1628), select(_e1108, 0f, _e1631)));
} else {
let _e1163 = select(1f, -1f, (_e1141 < 0f));
let _e1169 = select(0f, (2f * _e1090), (bitcast<f32>((bitcast<u32>(_e1141) & 2147483647u)) <= _e1090));
let _e1174 = ((_e1004 - _e1030) * _e1163);
let _e1175 = ((_e1030 - _e1052) * _e1163);
let _e1176 = ((_e1052 - _e1004) * _e1163);
let _e1177 = ((0f - 0f) * _e1163);
let _e1179 = (_e1070 * _e1163);
let _e1180 = (_e1073 * _e1163);
let _e1181 = ((_e1015 - _e1059) * _e1163);
let _e1183 = (_e1174 * _e1123);
let _e1184 = (_e1175 * _e1123);
let _e1185 = (_e1176 * _e1123);
let _e1186 = (_e1177 * _e1123);
let _e1191 = -((_e1174 * _e1067));
let _e1192 = -((_e1175 * _e1067));
let _e1193 = -((_e1176 * _e1067));
let _e1194 = -((_e1177 * _e1067));
local_46 = array<u32, 2>(0u, 4294967295u);
let _e1199 = select(0u, 1u, (_e1183 > _e1191));
if (_e1199 < 2u) {
} else {
break;
}
let _e1202 = local_46[_e1199];
local_47 = array<u32, 2>(0u, 4294967295u);
let _e1203 = select(0u, 1u, (_e1184 > _e1192));
if (_e1203 < 2u) {
} else {
break;
}
let _e1206 = local_47[_e1203];
local_48 = array<u32, 2>(0u, 4294967295u);
let _e1207 = select(0u, 1u, (_e1185 > _e1193));
if (_e1207 < 2u) {
} else {
break;
}
let _e1210 = local_48[_e1207];
local_49 = array<u32, 2>(0u, 4294967295u);
let _e1211 = select(0u, 1u, (_e1186 > _e1194));
let _e1212 = (_e1211 < 2u);
if _e1212 {
} else {
break;
}
let _e1214 = local_49[_e1211];
let _e1230 = (_e1177 * 0f);
let _e1235 = (_e1179 * _e1123);
let _e1236 = (_e1180 * _e1123);
let _e1237 = (_e1181 * _e1123);
let _e1241 = -((_e1179 * _e1067));
let _e1242 = -((_e1180 * _e1067));
let _e1243 = -((_e1181 * _e1067));
local_42 = array<u32, 2>(0u, 4294967295u);
let _e1247 = select(0u, 1u, (_e1235 > _e1241));
if (_e1247 < 2u) {
} else {
break;
}
let _e1250 = local_42[_e1247];
local_43 = array<u32, 2>(0u, 4294967295u);
let _e1251 = select(0u, 1u, (_e1236 > _e1242));
if (_e1251 < 2u) {
} else {
break;
}
let _e1254 = local_43[_e1251];
local_44 = array<u32, 2>(0u, 4294967295u);
let _e1255 = select(0u, 1u, (_e1237 > _e1243));
if (_e1255 < 2u) {
} else {
break;
}
let _e1258 = local_44[_e1255];
local_45 = array<u32, 2>(0u, 4294967295u);
if _e1212 {
} else {
break;
}
let _e1260 = local_45[_e1211];
local_38 = array<u32, 2>(0u, 4294967295u);
let _e1293 = select(0u, 1u, (_e1174 == 0f));
if (_e1293 < 2u) {
} else {
break;
}
let _e1296 = local_38[_e1293];
local_39 = array<u32, 2>(0u, 4294967295u);
let _e1297 = select(0u, 1u, (_e1175 == 0f));
if (_e1297 < 2u) {
} else {
break;
}
let _e1300 = local_39[_e1297];
local_40 = array<u32, 2>(0u, 4294967295u);
let _e1301 = select(0u, 1u, (_e1176 == 0f));
if (_e1301 < 2u) {
} else {
break;
}
let _e1304 = local_40[_e1301];
local_41 = array<u32, 2>(0u, 4294967295u);
let _e1305 = select(0u, 1u, (_e1177 == 0f));
if (_e1305 < 2u) {
} else {
break;
}
let _e1308 = local_41[_e1305];
let _e1310 = ((_e1296 & 1u) != 0u);
let _e1313 = ((_e1300 & 1u) != 0u);
let _e1316 = ((_e1304 & 1u) != 0u);
let _e1319 = ((_e1308 & 1u) != 0u);
let _e1321 = (-1f / select(_e1174, 1f, _e1310));
let _e1322 = (-1f / select(_e1175, 1f, _e1313));
let _e1323 = (-1f / select(_e1176, 1f, _e1316));
let _e1324 = (-1f / select(_e1177, 1f, _e1319));
local_34 = array<u32, 2>(0u, 4294967295u);
let _e1329 = select(0u, 1u, (_e1174 > 0f));
if (_e1329 < 2u) {
} else {
break;
}
let _e1332 = local_34[_e1329];
local_35 = array<u32, 2>(0u, 4294967295u);
let _e1333 = select(0u, 1u, (_e1175 > 0f));
if (_e1333 < 2u) {
} else {
break;
}
let _e1336 = local_35[_e1333];
local_36 = array<u32, 2>(0u, 4294967295u);
let _e1337 = select(0u, 1u, (_e1176 > 0f));
if (_e1337 < 2u) {
} else {
break;
}
let _e1340 = local_36[_e1337];
local_37 = array<u32, 2>(0u, 4294967295u);
let _e1341 = select(0u, 1u, (_e1177 > 0f));
if (_e1341 < 2u) {
} else {
break;
}
let _e1344 = local_37[_e1341];
local_30 = array<u32, 2>(0u, 4294967295u);
let _e1349 = select(0u, 1u, (_e1174 < 0f));
if (_e1349 < 2u) {
} else {
break;
}
let _e1352 = local_30[_e1349];
local_31 = array<u32, 2>(0u, 4294967295u);
let _e1353 = select(0u, 1u, (_e1175 < 0f));
if (_e1353 < 2u) {
} else {
break;
}
let _e1356 = local_31[_e1353];
local_32 = array<u32, 2>(0u, 4294967295u);
let _e1357 = select(0u, 1u, (_e1176 < 0f));
if (_e1357 < 2u) {
} else {
break;
}
let _e1360 = local_32[_e1357];
local_33 = array<u32, 2>(0u, 4294967295u);
let _e1361 = select(0u, 1u, (_e1177 < 0f));
if (_e1361 < 2u) {
} else {
break;
}
let _e1364 = local_33[_e1361];
let _e1383 = ((_e1352 & 1u) != 0u);
let _e1386 = ((_e1356 & 1u) != 0u);
let _e1389 = ((_e1360 & 1u) != 0u);
let _e1392 = ((_e1364 & 1u) != 0u);
phi_24058_ = type_18(vec4<f32>(_e1179, _e1180, _e1181, _e1177), vec4<f32>((((select(_e1191, _e1183, ((_e1202 & 1u) != 0u)) - (_e1174 * _e1015)) + (select(_e1241, _e1235, ((_e1250 & 1u) != 0u)) - (_e1179 * _e1004))) + _e1169), (((select(_e1192, _e1184, ((_e1206 & 1u) != 0u)) - (_e1175 * _e1037)) + (select(_e1242, _e1236, ((_e1254 & 1u) != 0u)) - (_e1180 * _e1030))) + _e1169), (((select(_e1193, _e1185, ((_e1210 & 1u) != 0u)) - (_e1176 * _e1059)) + (select(_e1243, _e1237, ((_e1258 & 1u) != 0u)) - (_e1181 * _e1052))) + _e1169), (((select(_e1194, _e1186, ((_e1214 & 1u) != 0u)) - _e1230) + (select(_e1194, _e1186, ((_e1260 & 1u) != 0u)) - _e1230)) + _e1169)), vec4<f32>(select(0f, _e1321, ((_e1332 & 1u) != 0u)), select(0f, _e1322, ((_e1336 & 1u) != 0u)), select(0f, _e1323, ((_e1340 & 1u) != 0u)), select(0f, _e1324, ((_e1344 & 1u) != 0u))), vec4<f32>(select(select(0f, 1e20f, _e1310), _e1321, _e1383), select(select(0f, 1e20f, _e1313), _e1322, _e1386), select(select(0f, 1e20f, _e1316), _e1323, _e1389), select(select(0f, 1e20f, _e1319), _e1324, _e1392)), vec4<f32>(select(_e1109, 0f, _e1383), select(_e1109, 0f, _e1386), select(_e1109, 0f, _e1389), select(_e1109, 0f, _e1392)));
}
let _e1641 = phi_24058_;
let _e1643 = (_e1076 == 0f);
let _e1645 = (1f / select(_e1076, 1f, _e1643));
let _e1651 = select(1f, -1f, (_e1082 < 0f));
let _e1657 = select(0f, (2f * _e1106), (bitcast<f32>((bitcast<u32>(_e1082) & 2147483647u)) <= _e1106));
let _e1660 = (_e1052 - _e1004);
let _e1661 = (0f - 0f);
let _e1662 = ((_e1004 - _e1030) * _e1651);
let _e1663 = ((_e1030 - _e1052) * _e1651);
let _e1664 = (_e1660 * _e1651);
let _e1665 = (_e1661 * _e1651);
let _e1666 = (_e993 - _e1045);
let _e1667 = (_e1068 * _e1651);
let _e1668 = (_e1071 * _e1651);
let _e1669 = (_e1666 * _e1651);
let _e1670 = (_e1662 * _e1123);
let _e1671 = (_e1663 * _e1123);
let _e1672 = (_e1664 * _e1123);
let _e1678 = -((_e1662 * _e1067));
let _e1679 = -((_e1663 * _e1067));
let _e1680 = -((_e1664 * _e1067));
local_27 = array<u32, 2>(0u, 4294967295u);
let _e1686 = select(0u, 1u, (_e1670 > _e1678));
if (_e1686 < 2u) {
} else {
break;
}
let _e1689 = local_27[_e1686];
local_28 = array<u32, 2>(0u, 4294967295u);
let _e1690 = select(0u, 1u, (_e1671 > _e1679));
if (_e1690 < 2u) {
} else {
break;
}
let _e1693 = local_28[_e1690];
local_29 = array<u32, 2>(0u, 4294967295u);
let _e1694 = select(0u, 1u, (_e1672 > _e1680));
if (_e1694 < 2u) {
} else {
break;
}
let _e1697 = local_29[_e1694];
let _e1699 = (select(0u, 1u, ((_e1665 * _e1123) > -((_e1665 * _e1067)))) < 2u);
if _e1699 {
} else {
break;
}
let _e1715 = (_e1667 * _e1123);
let _e1716 = (_e1668 * _e1123);
let _e1717 = (_e1669 * _e1123);
let _e1721 = -((_e1667 * _e1067));
let _e1722 = -((_e1668 * _e1067));
let _e1723 = -((_e1669 * _e1067));
local_24 = array<u32, 2>(0u, 4294967295u);
let _e1727 = select(0u, 1u, (_e1715 > _e1721));
if (_e1727 < 2u) {
} else {
break;
}
let _e1730 = local_24[_e1727];
local_25 = array<u32, 2>(0u, 4294967295u);
let _e1731 = select(0u, 1u, (_e1716 > _e1722));
if (_e1731 < 2u) {
} else {
break;
}
let _e1734 = local_25[_e1731];
local_26 = array<u32, 2>(0u, 4294967295u);
let _e1735 = select(0u, 1u, (_e1717 > _e1723));
if (_e1735 < 2u) {
} else {
break;
}
let _e1738 = local_26[_e1735];
if _e1699 {
} else {
break;
}
local_21 = array<u32, 2>(0u, 4294967295u);
let _e1764 = select(0u, 1u, (_e1662 == 0f));
if (_e1764 < 2u) {
} else {
break;
}
let _e1767 = local_21[_e1764];
local_22 = array<u32, 2>(0u, 4294967295u);
let _e1768 = select(0u, 1u, (_e1663 == 0f));
if (_e1768 < 2u) {
} else {
break;
}
let _e1771 = local_22[_e1768];
local_23 = array<u32, 2>(0u, 4294967295u);
let _e1772 = select(0u, 1u, (_e1664 == 0f));
if (_e1772 < 2u) {
} else {
break;
}
let _e1775 = local_23[_e1772];
if (select(0u, 1u, (_e1665 == 0f)) < 2u) {
} else {
break;
}
let _e1779 = ((_e1767 & 1u) != 0u);
let _e1782 = ((_e1771 & 1u) != 0u);
let _e1785 = ((_e1775 & 1u) != 0u);
let _e1787 = (-1f / select(_e1662, 1f, _e1779));
let _e1788 = (-1f / select(_e1663, 1f, _e1782));
let _e1789 = (-1f / select(_e1664, 1f, _e1785));
local_18 = array<u32, 2>(0u, 4294967295u);
let _e1794 = select(0u, 1u, (_e1662 > 0f));
if (_e1794 < 2u) {
} else {
break;
}
let _e1797 = local_18[_e1794];
local_19 = array<u32, 2>(0u, 4294967295u);
let _e1798 = select(0u, 1u, (_e1663 > 0f));
if (_e1798 < 2u) {
} else {
break;
}
let _e1801 = local_19[_e1798];
local_20 = array<u32, 2>(0u, 4294967295u);
let _e1802 = select(0u, 1u, (_e1664 > 0f));
if (_e1802 < 2u) {
} else {
break;
}
let _e1805 = local_20[_e1802];
if (select(0u, 1u, (_e1665 > 0f)) < 2u) {
} else {
break;
}
local_15 = array<u32, 2>(0u, 4294967295u);
let _e1812 = select(0u, 1u, (_e1662 < 0f));
if (_e1812 < 2u) {
} else {
break;
}
let _e1815 = local_15[_e1812];
local_16 = array<u32, 2>(0u, 4294967295u);
let _e1816 = select(0u, 1u, (_e1663 < 0f));
if (_e1816 < 2u) {
} else {
break;
}
let _e1819 = local_16[_e1816];
local_17 = array<u32, 2>(0u, 4294967295u);
let _e1820 = select(0u, 1u, (_e1664 < 0f));
if (_e1820 < 2u) {
} else {
break;
}
let _e1823 = local_17[_e1820];
if (select(0u, 1u, (_e1665 < 0f)) < 2u) {
} else {
break;
}
let _e1839 = ((_e1815 & 1u) != 0u);
let _e1842 = ((_e1819 & 1u) != 0u);
let _e1845 = ((_e1823 & 1u) != 0u);
let _e1851 = select(1f, -1f, (_e1147 < 0f));
let _e1857 = select(0f, (2f * _e1098), (bitcast<f32>((bitcast<u32>(_e1147) & 2147483647u)) <= _e1098));
let _e1860 = (_e1059 - _e1015);
let _e1861 = ((_e1015 - _e1037) * _e1851);
let _e1862 = ((_e1037 - _e1059) * _e1851);
let _e1863 = (_e1860 * _e1851);
let _e1864 = (_e1661 * _e1851);
let _e1865 = (_e1068 * _e1851);
let _e1866 = (_e1071 * _e1851);
let _e1867 = (_e1666 * _e1851);
let _e1868 = (_e1861 * _e1123);
let _e1869 = (_e1862 * _e1123);
let _e1870 = (_e1863 * _e1123);
let _e1876 = -((_e1861 * _e1067));
let _e1877 = -((_e1862 * _e1067));
let _e1878 = -((_e1863 * _e1067));
local_12 = array<u32, 2>(0u, 4294967295u);
let _e1884 = select(0u, 1u, (_e1868 > _e1876));
if (_e1884 < 2u) {
} else {
break;
}
let _e1887 = local_12[_e1884];
local_13 = array<u32, 2>(0u, 4294967295u);
let _e1888 = select(0u, 1u, (_e1869 > _e1877));
if (_e1888 < 2u) {
} else {
break;
}
let _e1891 = local_13[_e1888];
local_14 = array<u32, 2>(0u, 4294967295u);
let _e1892 = select(0u, 1u, (_e1870 > _e1878));
if (_e1892 < 2u) {
} else {
break;
}
let _e1895 = local_14[_e1892];
let _e1897 = (select(0u, 1u, ((_e1864 * _e1123) > -((_e1864 * _e1067)))) < 2u);
if _e1897 {
} else {
break;
}
let _e1913 = (_e1865 * _e1123);
let _e1914 = (_e1866 * _e1123);
let _e1915 = (_e1867 * _e1123);
let _e1919 = -((_e1865 * _e1067));
let _e1920 = -((_e1866 * _e1067));
let _e1921 = -((_e1867 * _e1067));
local_9 = array<u32, 2>(0u, 4294967295u);
let _e1925 = select(0u, 1u, (_e1913 > _e1919));
if (_e1925 < 2u) {
} else {
break;
}
let _e1928 = local_9[_e1925];
local_10 = array<u32, 2>(0u, 4294967295u);
let _e1929 = select(0u, 1u, (_e1914 > _e1920));
if (_e1929 < 2u) {
} else {
break;
}
let _e1932 = local_10[_e1929];
local_11 = array<u32, 2>(0u, 4294967295u);
let _e1933 = select(0u, 1u, (_e1915 > _e1921));
if (_e1933 < 2u) {
} else {
break;
}
let _e1936 = local_11[_e1933];
if _e1897 {
} else {
break;
}
local_6 = array<u32, 2>(0u, 4294967295u);
let _e1962 = select(0u, 1u, (_e1861 == 0f));
if (_e1962 < 2u) {
} else {
break;
}
let _e1965 = local_6[_e1962];
local_7 = array<u32, 2>(0u, 4294967295u);
let _e1966 = select(0u, 1u, (_e1862 == 0f));
if (_e1966 < 2u) {
} else {
break;
}
let _e1969 = local_7[_e1966];
local_8 = array<u32, 2>(0u, 4294967295u);
let _e1970 = select(0u, 1u, (_e1863 == 0f));
if (_e1970 < 2u) {
} else {
break;
}
let _e1973 = local_8[_e1970];
if (select(0u, 1u, (_e1864 == 0f)) < 2u) {
} else {
break;
}
let _e1977 = ((_e1965 & 1u) != 0u);
let _e1980 = ((_e1969 & 1u) != 0u);
let _e1983 = ((_e1973 & 1u) != 0u);
let _e1985 = (-1f / select(_e1861, 1f, _e1977));
let _e1986 = (-1f / select(_e1862, 1f, _e1980));
let _e1987 = (-1f / select(_e1863, 1f, _e1983));
local_3 = array<u32, 2>(0u, 4294967295u);
let _e1992 = select(0u, 1u, (_e1861 > 0f));
if (_e1992 < 2u) {
} else {
break;
}
let _e1995 = local_3[_e1992];
local_4 = array<u32, 2>(0u, 4294967295u);
let _e1996 = select(0u, 1u, (_e1862 > 0f));
if (_e1996 < 2u) {
} else {
break;
}
let _e1999 = local_4[_e1996];
local_5 = array<u32, 2>(0u, 4294967295u);
let _e2000 = select(0u, 1u, (_e1863 > 0f));
if (_e2000 < 2u) {
} else {
break;
}
let _e2003 = local_5[_e2000];
if (select(0u, 1u, (_e1864 > 0f)) < 2u) {
} else {
break;
}
local = array<u32, 2>(0u, 4294967295u);
let _e2010 = select(0u, 1u, (_e1861 < 0f));
if (_e2010 < 2u) {
} else {
break;
}
let _e2013 = local[_e2010];
local_1 = array<u32, 2>(0u, 4294967295u);
let _e2014 = select(0u, 1u, (_e1862 < 0f));
if (_e2014 < 2u) {
} else {
break;
}
let _e2017 = local_1[_e2014];
local_2 = array<u32, 2>(0u, 4294967295u);
let _e2018 = select(0u, 1u, (_e1863 < 0f));
if (_e2018 < 2u) {
} else {
break;
}
let _e2021 = local_2[_e2018];
if (select(0u, 1u, (_e1864 < 0f)) < 2u) {
} else {
break;
}
let _e2037 = ((_e2013 & 1u) != 0u);
let _e2040 = ((_e2017 & 1u) != 0u);
let _e2043 = ((_e2021 & 1u) != 0u);
let _e2048 = (_e1045 - _e993);
let _e2050 = (_e935.member.member * 19i);
let _e2051 = (_e2050 + 18i);
let _e2053 = (bitcast<i32>(_e214) - 1i);
let _e2055 = select(_e2053, _e2051, (_e2051 < _e2053));
let _e2061 = global_4.member[bitcast<u32>(select(0i, _e2055, (_e2055 > 0i)))];
let _e2063 = select(0f, _e2061, (_e2061 > 0f));
let _e2065 = select(16777216f, _e2063, (_e2063 < 16777216f));
let _e2072 = select(0i, select(select(i32(_e2065), i32(-2147483648), (_e2065 < -2147483600f)), 2147483647i, (_e2065 > 2147483500f)), (_e2065 == _e2065));
phi_26015_ = _e935.member.member_1;
loop {
let _e2079 = phi_26015_;
let _e2080 = (_e2079 < _e935.member.member_2);
if _e2080 {
if _e1161 {
phi_26030_ = _e935.member_1.member_4.y;
} else {
phi_26030_ = _e935.member_1.member_4.z;
}
let _e2084 = phi_26030_;
let _e2085 = f32(_e2084);
let _e2086 = f32(_e2079);
let _e2096 = ((_e1641.member.x * _e2086) + _e1641.member_1.x);
let _e2098 = ((_e1641.member.y * _e2086) + _e1641.member_1.y);
let _e2100 = ((_e1641.member.z * _e2086) + _e1641.member_1.z);
let _e2103 = (_e2096 * _e1641.member_2.x);
let _e2105 = (_e2098 * _e1641.member_2.y);
let _e2107 = (_e2100 * _e1641.member_2.z);
let _e2117 = ((_e2096 * _e1641.member_3.x) + _e1641.member_4.x);
let _e2119 = ((_e2098 * _e1641.member_3.y) + _e1641.member_4.y);
let _e2121 = ((_e2100 * _e1641.member_3.z) + _e1641.member_4.z);
let _e2123 = select(_e2103, 0f, (0f > _e2103));
let _e2125 = select(_e2107, _e2105, (_e2105 > _e2107));
let _e2129 = select(_e2117, _e2085, (_e2085 < _e2117));
let _e2131 = select(_e2121, _e2119, (_e2119 < _e2121));
let _e2133 = select(_e2131, _e2129, (_e2129 < _e2131));
let _e2134 = -(select(_e2125, _e2123, (_e2123 > _e2125)));
let _e2136 = (-(_e2085) - 1f);
let _e2138 = select(_e2136, _e2134, (_e2134 > _e2136));
let _e2140 = select(0f, _e2138, (_e2138 < 0f));
let _e2147 = select(0i, select(select(i32(_e2140), i32(-2147483648), (_e2140 < -2147483600f)), 2147483647i, (_e2140 > 2147483500f)), (_e2140 == _e2140));
let _e2154 = select(-1f, _e2133, (_e2133 > -1f));
let _e2156 = select(_e2085, _e2154, (_e2154 < _e2085));
let _e2163 = select(0i, select(select(i32(_e2156), i32(-2147483648), (_e2156 < -2147483600f)), 2147483647i, (_e2156 > 2147483500f)), (_e2156 == _e2156));
phi_26150_ = -((_e2147 - select(0i, 1i, (_e2140 < f32(_e2147)))));
loop {
let _e2169 = phi_26150_;
let _e2170 = (_e2169 <= (_e2163 - select(0i, 1i, (_e2156 < f32(_e2163)))));
if _e2170 {
let _e2171 = select(_e2169, _e2079, _e1161);
let _e2172 = select(_e2079, _e2169, _e1161);
let _e2173 = f32(_e2172);
let _e2174 = f32(_e2171);
let _e2176 = f32(_e935.member_1.member_4.x);
let _e2179 = ((_e1079 * _e2173) + (_e1082 * _e2174));
let _e2180 = (_e2179 + ((((select(_e1126, _e1124, (_e1124 > _e1126)) + select(_e1131, _e1129, (_e1129 > _e1131))) + select(_e1137, _e1135, (_e1135 > _e1137))) - _e1122) + _e1117));
let _e2182 = -((_e2180 * _e1645));
let _e2186 = select(0f, select(_e2182, 0f, (0f > _e2182)), (_e1076 > 0f));
let _e2193 = select(select(_e2176, select(_e2182, _e2176, (_e2176 < _e2182)), (_e1076 < 0f)), -1f, (_e1643 && (_e2180 < 0f)));
let _e2195 = (((((select(_e1144, _e1142, (_e1142 > _e1144)) + select(_e1150, _e1148, (_e1148 > _e1150))) + select(_e1157, _e1155, (_e1155 > _e1157))) + _e1122) + _e1117) - _e2179);
let _e2197 = -((_e2195 * -(_e1645)));
let _e2201 = select(_e2186, select(_e2197, _e2186, (_e2186 > _e2197)), (_e1141 > 0f));
let _e2209 = select(select(_e2193, select(_e2197, _e2193, (_e2193 < _e2197)), (_e1141 < 0f)), -1f, ((_e1141 == 0f) && (_e2195 < 0f)));
let _e2213 = ((_e1667 * _e2173) + (((select(_e1678, _e1670, ((_e1689 & 1u) != 0u)) - (_e1662 * _e993)) + (select(_e1721, _e1715, ((_e1730 & 1u) != 0u)) - (_e1667 * _e1004))) + _e1657));
let _e2214 = ((_e1668 * _e2173) + (((select(_e1679, _e1671, ((_e1693 & 1u) != 0u)) - (_e1663 * _e1023)) + (select(_e1722, _e1716, ((_e1734 & 1u) != 0u)) - (_e1668 * _e1030))) + _e1657));
let _e2215 = ((_e1669 * _e2173) + (((select(_e1680, _e1672, ((_e1697 & 1u) != 0u)) - (_e1664 * _e1045)) + (select(_e1723, _e1717, ((_e1738 & 1u) != 0u)) - (_e1669 * _e1052))) + _e1657));
let _e2216 = (_e2213 * select(0f, _e1787, ((_e1797 & 1u) != 0u)));
let _e2217 = (_e2214 * select(0f, _e1788, ((_e1801 & 1u) != 0u)));
let _e2218 = (_e2215 * select(0f, _e1789, ((_e1805 & 1u) != 0u)));
let _e2222 = ((_e2213 * select(select(0f, 1e20f, _e1779), _e1787, _e1839)) + select(_e1107, 0f, _e1839));
let _e2223 = ((_e2214 * select(select(0f, 1e20f, _e1782), _e1788, _e1842)) + select(_e1107, 0f, _e1842));
let _e2224 = ((_e2215 * select(select(0f, 1e20f, _e1785), _e1789, _e1845)) + select(_e1107, 0f, _e1845));
let _e2226 = select(_e2216, _e2201, (_e2201 > _e2216));
let _e2228 = select(_e2218, _e2217, (_e2217 > _e2218));
let _e2230 = select(_e2228, _e2226, (_e2226 > _e2228));
let _e2232 = select(_e2222, _e2209, (_e2209 < _e2222));
let _e2234 = select(_e2224, _e2223, (_e2223 < _e2224));
let _e2236 = select(_e2234, _e2232, (_e2232 < _e2234));
let _e2240 = ((_e1865 * _e2174) + (((select(_e1876, _e1868, ((_e1887 & 1u) != 0u)) - (_e1861 * _e993)) + (select(_e1919, _e1913, ((_e1928 & 1u) != 0u)) - (_e1865 * _e1015))) + _e1857));
let _e2241 = ((_e1866 * _e2174) + (((select(_e1877, _e1869, ((_e1891 & 1u) != 0u)) - (_e1862 * _e1023)) + (select(_e1920, _e1914, ((_e1932 & 1u) != 0u)) - (_e1866 * _e1037))) + _e1857));
let _e2242 = ((_e1867 * _e2174) + (((select(_e1878, _e1870, ((_e1895 & 1u) != 0u)) - (_e1863 * _e1045)) + (select(_e1921, _e1915, ((_e1936 & 1u) != 0u)) - (_e1867 * _e1059))) + _e1857));
let _e2243 = (_e2240 * select(0f, _e1985, ((_e1995 & 1u) != 0u)));
let _e2244 = (_e2241 * select(0f, _e1986, ((_e1999 & 1u) != 0u)));
let _e2245 = (_e2242 * select(0f, _e1987, ((_e2003 & 1u) != 0u)));
let _e2249 = ((_e2240 * select(select(0f, 1e20f, _e1977), _e1985, _e2037)) + select(_e1107, 0f, _e2037));
let _e2250 = ((_e2241 * select(select(0f, 1e20f, _e1980), _e1986, _e2040)) + select(_e1107, 0f, _e2040));
let _e2251 = ((_e2242 * select(select(0f, 1e20f, _e1983), _e1987, _e2043)) + select(_e1107, 0f, _e2043));
let _e2253 = select(_e2243, _e2230, (_e2230 > _e2243));
let _e2255 = select(_e2245, _e2244, (_e2244 > _e2245));
let _e2259 = select(_e2249, _e2236, (_e2236 < _e2249));
let _e2261 = select(_e2251, _e2250, (_e2250 < _e2251));
let _e2263 = select(_e2261, _e2259, (_e2259 < _e2261));
let _e2264 = -(select(_e2255, _e2253, (_e2253 > _e2255)));
let _e2266 = (-(_e2176) - 1f);
let _e2268 = select(_e2266, _e2264, (_e2264 > _e2266));
let _e2270 = select(0f, _e2268, (_e2268 < 0f));
let _e2277 = select(0i, select(select(i32(_e2270), i32(-2147483648), (_e2270 < -2147483600f)), 2147483647i, (_e2270 > 2147483500f)), (_e2270 == _e2270));
let _e2284 = select(-1f, _e2263, (_e2263 > -1f));
let _e2286 = select(_e2176, _e2284, (_e2284 < _e2176));
let _e2293 = select(0i, select(select(i32(_e2286), i32(-2147483648), (_e2286 < -2147483600f)), 2147483647i, (_e2286 > 2147483500f)), (_e2286 == _e2286));
let _e2302 = global_1.member.member_1[1u];
let _e2310 = global_1.member.member_1[3u];
phi_26389_ = -((_e2277 - select(0i, 1i, (_e2270 < f32(_e2277)))));
loop {
let _e2314 = phi_26389_;
let _e2315 = (_e2314 <= (_e2293 - select(0i, 1i, (_e2286 < f32(_e2293)))));
if _e2315 {
let _e2320 = ((f32(_e2314) + 0.5f) - _e993);
let _e2321 = ((_e2173 + 0.5f) - _e1004);
let _e2322 = ((_e2174 + 0.5f) - _e1015);
let _e2327 = (((_e1068 * _e1068) + (_e1069 * _e1069)) + (_e1070 * _e1070));
let _e2332 = (((_e1068 * _e2048) + (_e1069 * _e1660)) + (_e1070 * _e1860));
let _e2337 = (((_e2048 * _e2048) + (_e1660 * _e1660)) + (_e1860 * _e1860));
let _e2342 = (((_e2320 * _e1068) + (_e2321 * _e1069)) + (_e2322 * _e1070));
let _e2347 = (((_e2320 * _e2048) + (_e2321 * _e1660)) + (_e2322 * _e1860));
let _e2350 = ((_e2327 * _e2337) - (_e2332 * _e2332));
let _e2351 = (_e2350 > 0f);
let _e2354 = select(0f, (1f / select(1f, _e2350, _e2351)), _e2351);
let _e2358 = (((_e2337 * _e2342) - (_e2332 * _e2347)) * _e2354);
let _e2362 = (((_e2327 * _e2347) - (_e2332 * _e2342)) * _e2354);
let _e2364 = ((1f - _e2358) - _e2362);
let _e2366 = select(0f, _e2364, (_e2364 > 0f));
let _e2368 = select(16777216f, _e2366, (_e2366 < 16777216f));
let _e2370 = select(0f, _e2358, (_e2358 > 0f));
let _e2372 = select(16777216f, _e2370, (_e2370 < 16777216f));
let _e2374 = select(0f, _e2362, (_e2362 > 0f));
let _e2376 = select(16777216f, _e2374, (_e2374 < 16777216f));
let _e2378 = ((_e2368 + _e2372) + _e2376);
let _e2381 = (1f / select(0.5f, _e2378, (_e2378 > 0.5f)));
let _e2382 = (_e2368 * _e2381);
let _e2383 = (_e2372 * _e2381);
let _e2384 = (_e2376 * _e2381);
let _e2386 = select(_e2053, _e2050, (_e2050 < _e2053));
let _e2392 = global_4.member[bitcast<u32>(select(0i, _e2386, (_e2386 > 0i)))];
let _e2393 = (_e2050 + 1i);
let _e2395 = select(_e2053, _e2393, (_e2393 < _e2053));
let _e2401 = global_4.member[bitcast<u32>(select(0i, _e2395, (_e2395 > 0i)))];
let _e2402 = (_e2050 + 2i);
let _e2404 = select(_e2053, _e2402, (_e2402 < _e2053));
let _e2410 = global_4.member[bitcast<u32>(select(0i, _e2404, (_e2404 > 0i)))];
let _e2411 = (_e2050 + 3i);
let _e2413 = select(_e2053, _e2411, (_e2411 < _e2053));
let _e2419 = global_4.member[bitcast<u32>(select(0i, _e2413, (_e2413 > 0i)))];
let _e2420 = (_e2050 + 4i);
let _e2422 = select(_e2053, _e2420, (_e2420 < _e2053));
let _e2428 = global_4.member[bitcast<u32>(select(0i, _e2422, (_e2422 > 0i)))];
let _e2429 = (_e2050 + 5i);
let _e2431 = select(_e2053, _e2429, (_e2429 < _e2053));
let _e2437 = global_4.member[bitcast<u32>(select(0i, _e2431, (_e2431 > 0i)))];
let _e2438 = (_e2050 + 6i);
let _e2440 = select(_e2053, _e2438, (_e2438 < _e2053));
let _e2446 = global_4.member[bitcast<u32>(select(0i, _e2440, (_e2440 > 0i)))];
let _e2447 = (_e2050 + 7i);
let _e2449 = select(_e2053, _e2447, (_e2447 < _e2053));
let _e2455 = global_4.member[bitcast<u32>(select(0i, _e2449, (_e2449 > 0i)))];
let _e2456 = (_e2050 + 8i);
let _e2458 = select(_e2053, _e2456, (_e2456 < _e2053));
let _e2464 = global_4.member[bitcast<u32>(select(0i, _e2458, (_e2458 > 0i)))];
let _e2469 = (((_e2392 * _e2382) + (_e2419 * _e2383)) + (_e2446 * _e2384));
let _e2474 = (((_e2401 * _e2382) + (_e2428 * _e2383)) + (_e2455 * _e2384));
let _e2479 = (((_e2410 * _e2382) + (_e2437 * _e2383)) + (_e2464 * _e2384));
let _e2484 = (((_e2469 * _e2469) + (_e2474 * _e2474)) + (_e2479 * _e2479));
let _e2487 = sqrt(select(0f, _e2484, (_e2484 > 0f)));
let _e2488 = (_e2487 > 1e-6f);
let _e2491 = select(0f, (1f / select(1e-6f, _e2487, _e2488)), _e2488);
let _e2492 = (_e2050 + 9i);
let _e2494 = select(_e2053, _e2492, (_e2492 < _e2053));
let _e2500 = global_4.member[bitcast<u32>(select(0i, _e2494, (_e2494 > 0i)))];
let _e2501 = (_e2050 + 10i);
let _e2503 = select(_e2053, _e2501, (_e2501 < _e2053));
let _e2509 = global_4.member[bitcast<u32>(select(0i, _e2503, (_e2503 > 0i)))];
let _e2510 = (_e2050 + 11i);
let _e2512 = select(_e2053, _e2510, (_e2510 < _e2053));
let _e2518 = global_4.member[bitcast<u32>(select(0i, _e2512, (_e2512 > 0i)))];
let _e2519 = (_e2050 + 12i);
let _e2521 = select(_e2053, _e2519, (_e2519 < _e2053));
let _e2527 = global_4.member[bitcast<u32>(select(0i, _e2521, (_e2521 > 0i)))];
let _e2528 = (_e2050 + 13i);
let _e2530 = select(_e2053, _e2528, (_e2528 < _e2053));
let _e2536 = global_4.member[bitcast<u32>(select(0i, _e2530, (_e2530 > 0i)))];
let _e2537 = (_e2050 + 14i);
let _e2539 = select(_e2053, _e2537, (_e2537 < _e2053));
let _e2545 = global_4.member[bitcast<u32>(select(0i, _e2539, (_e2539 > 0i)))];
let _e2546 = (_e2050 + 15i);
let _e2548 = select(_e2053, _e2546, (_e2546 < _e2053));
let _e2554 = global_4.member[bitcast<u32>(select(0i, _e2548, (_e2548 > 0i)))];
let _e2555 = (_e2050 + 16i);
let _e2557 = select(_e2053, _e2555, (_e2555 < _e2053));
let _e2563 = global_4.member[bitcast<u32>(select(0i, _e2557, (_e2557 > 0i)))];
let _e2564 = (_e2050 + 17i);
let _e2566 = select(_e2053, _e2564, (_e2564 < _e2053));
let _e2572 = global_4.member[bitcast<u32>(select(0i, _e2566, (_e2566 > 0i)))];
let _e2588 = (_e935.member_1.member_3.x + _e2314);
let _e2591 = ((((((_e935.member_1.member_3.z + _e2171) * bitcast<i32>(_e2302)) + _e935.member_1.member_3.y) + _e2172) * bitcast<i32>(_e2310)) + (_e2588 >> bitcast<u32>(5i)));
let _e2595 = (bitcast<i32>(_e218) - 1i);
let _e2597 = select(_e2595, _e2591, (_e2591 < _e2595));
let _e2603 = global_6.member[bitcast<u32>(select(0i, _e2597, (_e2597 > 0i)))];
let _e2605 = (bitcast<i32>(_e216) - 1i);
let _e2607 = select(_e2605, _e2591, (_e2591 < _e2605));
let _e2613 = global_5.member[bitcast<u32>(select(0i, _e2607, (_e2607 > 0i)))];
let _e2622 = (bitcast<i32>((_e2603 + countOneBits((_e2613 & ((1u << bitcast<u32>((bitcast<u32>((_e2588 & 31i)) & 31u))) - 1u))))) * 14i);
let _e2623 = bitcast<u32>(_e2622);
if (_e2623 < _e220) {
let _e2627 = atomicAdd((&global_7.member[_e2623]), 1u);
}
let _e2629 = bitcast<u32>((_e2622 + 1i));
if (_e2629 < _e220) {
let _e2633 = atomicMax((&global_7.member[_e2629]), bitcast<u32>((_e2072 - select(0i, 1i, (_e2065 < f32(_e2072))))));
}
let _e2639 = (((_e2469 * _e2491) * 65536f) + 0.5f);
let _e2641 = select(-1073741800f, _e2639, (_e2639 > -1073741800f));
let _e2643 = select(1073741800f, _e2641, (_e2641 < 1073741800f));
let _e2650 = select(0i, select(select(i32(_e2643), i32(-2147483648), (_e2643 < -2147483600f)), 2147483647i, (_e2643 > 2147483500f)), (_e2643 == _e2643));
let _e2654 = (_e2650 - select(0i, 1i, (_e2643 < f32(_e2650))));
if (_e2654 == 0i) {
} else {
let _e2656 = bitcast<u32>(_e2654);
let _e2657 = bitcast<u32>((_e2622 + 2i));
if (_e2657 < _e220) {
let _e2661 = atomicAdd((&global_7.member[_e2657]), _e2656);
phi_26917_ = _e2661;
} else {
phi_26917_ = 0u;
}
let _e2663 = phi_26917_;
let _e2670 = (bitcast<u32>((_e2654 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e2663 + _e2656) < _e2656)));
if (_e2670 == 0u) {
} else {
let _e2672 = (_e2657 + 1u);
if (_e2672 < _e220) {
let _e2676 = atomicAdd((&global_7.member[_e2672]), _e2670);
}
}
}
let _e2679 = (((_e2474 * _e2491) * 65536f) + 0.5f);
let _e2681 = select(-1073741800f, _e2679, (_e2679 > -1073741800f));
let _e2683 = select(1073741800f, _e2681, (_e2681 < 1073741800f));
let _e2690 = select(0i, select(select(i32(_e2683), i32(-2147483648), (_e2683 < -2147483600f)), 2147483647i, (_e2683 > 2147483500f)), (_e2683 == _e2683));
let _e2694 = (_e2690 - select(0i, 1i, (_e2683 < f32(_e2690))));
if (_e2694 == 0i) {
} else {
let _e2696 = bitcast<u32>(_e2694);
let _e2697 = bitcast<u32>((_e2622 + 4i));
if (_e2697 < _e220) {
let _e2701 = atomicAdd((&global_7.member[_e2697]), _e2696);
phi_26974_ = _e2701;
} else {
phi_26974_ = 0u;
}
let _e2703 = phi_26974_;
let _e2710 = (bitcast<u32>((_e2694 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e2703 + _e2696) < _e2696)));
if (_e2710 == 0u) {
} else {
let _e2712 = (_e2697 + 1u);
if (_e2712 < _e220) {
let _e2716 = atomicAdd((&global_7.member[_e2712]), _e2710);
}
}
}
let _e2719 = (((_e2479 * _e2491) * 65536f) + 0.5f);
let _e2721 = select(-1073741800f, _e2719, (_e2719 > -1073741800f));
let _e2723 = select(1073741800f, _e2721, (_e2721 < 1073741800f));
let _e2730 = select(0i, select(select(i32(_e2723), i32(-2147483648), (_e2723 < -2147483600f)), 2147483647i, (_e2723 > 2147483500f)), (_e2723 == _e2723));
let _e2734 = (_e2730 - select(0i, 1i, (_e2723 < f32(_e2730))));
if (_e2734 == 0i) {
} else {
let _e2736 = bitcast<u32>(_e2734);
let _e2737 = bitcast<u32>((_e2622 + 6i));
if (_e2737 < _e220) {
let _e2741 = atomicAdd((&global_7.member[_e2737]), _e2736);
phi_27031_ = _e2741;
} else {
phi_27031_ = 0u;
}
let _e2743 = phi_27031_;
let _e2750 = (bitcast<u32>((_e2734 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e2743 + _e2736) < _e2736)));
if (_e2750 == 0u) {
} else {
let _e2752 = (_e2737 + 1u);
if (_e2752 < _e220) {
let _e2756 = atomicAdd((&global_7.member[_e2752]), _e2750);
}
}
}
let _e2759 = (((((_e2500 * _e2382) + (_e2527 * _e2383)) + (_e2554 * _e2384)) * 65536f) + 0.5f);
let _e2761 = select(-1073741800f, _e2759, (_e2759 > -1073741800f));
let _e2763 = select(1073741800f, _e2761, (_e2761 < 1073741800f));
let _e2770 = select(0i, select(select(i32(_e2763), i32(-2147483648), (_e2763 < -2147483600f)), 2147483647i, (_e2763 > 2147483500f)), (_e2763 == _e2763));
let _e2774 = (_e2770 - select(0i, 1i, (_e2763 < f32(_e2770))));
if (_e2774 == 0i) {
} else {
let _e2776 = bitcast<u32>(_e2774);
let _e2777 = bitcast<u32>((_e2622 + 8i));
if (_e2777 < _e220) {
let _e2781 = atomicAdd((&global_7.member[_e2777]), _e2776);
phi_27089_ = _e2781;
} else {
phi_27089_ = 0u;
}
let _e2783 = phi_27089_;
let _e2790 = (bitcast<u32>((_e2774 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e2783 + _e2776) < _e2776)));
if (_e2790 == 0u) {
} else {
let _e2792 = (_e2777 + 1u);
if (_e2792 < _e220) {
let _e2796 = atomicAdd((&global_7.member[_e2792]), _e2790);
}
}
}
let _e2799 = (((((_e2509 * _e2382) + (_e2536 * _e2383)) + (_e2563 * _e2384)) * 65536f) + 0.5f);
let _e2801 = select(-1073741800f, _e2799, (_e2799 > -1073741800f));
let _e2803 = select(1073741800f, _e2801, (_e2801 < 1073741800f));
let _e2810 = select(0i, select(select(i32(_e2803), i32(-2147483648), (_e2803 < -2147483600f)), 2147483647i, (_e2803 > 2147483500f)), (_e2803 == _e2803));
let _e2814 = (_e2810 - select(0i, 1i, (_e2803 < f32(_e2810))));
if (_e2814 == 0i) {
} else {
let _e2816 = bitcast<u32>(_e2814);
let _e2817 = bitcast<u32>((_e2622 + 10i));
if (_e2817 < _e220) {
let _e2821 = atomicAdd((&global_7.member[_e2817]), _e2816);
phi_27146_ = _e2821;
} else {
phi_27146_ = 0u;
}
let _e2823 = phi_27146_;
let _e2830 = (bitcast<u32>((_e2814 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e2823 + _e2816) < _e2816)));
if (_e2830 == 0u) {
} else {
let _e2832 = (_e2817 + 1u);
if (_e2832 < _e220) {
let _e2836 = atomicAdd((&global_7.member[_e2832]), _e2830);
}
}
}
let _e2839 = (((((_e2518 * _e2382) + (_e2545 * _e2383)) + (_e2572 * _e2384)) * 65536f) + 0.5f);
let _e2841 = select(-1073741800f, _e2839, (_e2839 > -1073741800f));
let _e2843 = select(1073741800f, _e2841, (_e2841 < 1073741800f));
let _e2850 = select(0i, select(select(i32(_e2843), i32(-2147483648), (_e2843 < -2147483600f)), 2147483647i, (_e2843 > 2147483500f)), (_e2843 == _e2843));
let _e2854 = (_e2850 - select(0i, 1i, (_e2843 < f32(_e2850))));
if (_e2854 == 0i) {
} else {
let _e2856 = bitcast<u32>(_e2854);
let _e2857 = bitcast<u32>((_e2622 + 12i));
if (_e2857 < _e220) {
let _e2861 = atomicAdd((&global_7.member[_e2857]), _e2856);
phi_27203_ = _e2861;
} else {
phi_27203_ = 0u;
}
let _e2863 = phi_27203_;
let _e2870 = (bitcast<u32>((_e2854 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e2863 + _e2856) < _e2856)));
if (_e2870 == 0u) {
} else {
let _e2872 = (_e2857 + 1u);
if (_e2872 < _e220) {
let _e2876 = atomicAdd((&global_7.member[_e2872]), _e2870);
}
}
}
phi_26390_ = (_e2314 + 1i);
} else {
phi_26390_ = i32();
}
let _e2879 = phi_26390_;
continue;
continuing {
phi_26389_ = _e2879;
break if !(_e2315);
}
}
phi_26151_ = (_e2169 + 1i);
} else {
phi_26151_ = i32();
}
let _e2883 = phi_26151_;
continue;
continuing {
phi_26150_ = _e2883;
break if !(_e2170);
}
}
phi_26016_ = (_e2079 + 1i);
} else {
phi_26016_ = i32();
}
let _e2887 = phi_26016_;
continue;
continuing {
phi_26015_ = _e2887;
break if !(_e2080);
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
