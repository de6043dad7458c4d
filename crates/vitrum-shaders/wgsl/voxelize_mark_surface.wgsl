struct type_2 {
member: u32,
member_1: u32,
member_2: u32,
}
struct type_7 {
member: array<u32>,
}
struct type_8 {
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
@group(0) @binding(3)
var<storage, read_write> global_1: type_19;
@group(0) @binding(0)
var<storage> global_2: type_9;
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
var phi_1364_: i32;
var phi_1990_: u32;
var phi_2024_: i32;
var phi_2038_: i32;
var phi_2052_: i32;
var phi_2067_: i32;
var phi_2081_: i32;
var phi_2095_: i32;
var phi_1638_: u32;
var phi_1672_: i32;
var phi_1686_: i32;
var phi_1700_: i32;
var phi_1715_: i32;
var phi_1729_: i32;
var phi_1743_: i32;
var phi_2101_: type_12;
var phi_1146_: u32;
var phi_1180_: i32;
var phi_1194_: i32;
var phi_1208_: i32;
var phi_1223_: i32;
var phi_1237_: i32;
var phi_1251_: i32;
var phi_794_: u32;
var phi_828_: i32;
var phi_842_: i32;
var phi_856_: i32;
var phi_871_: i32;
var phi_885_: i32;
var phi_899_: i32;
var phi_1257_: type_12;
var phi_1297_: bool;
var phi_1313_: i32;
var phi_2103_: type_14;
var phi_2136_: u32;
var phi_2137_: u32;
var phi_2138_: u32;
var phi_19764_: type_16;
var phi_21443_: i32;
var phi_21458_: i32;
var phi_21578_: i32;
var phi_21825_: i32;
var phi_21844_: u32;
var phi_21855_: u32;
var phi_21826_: i32;
var phi_21579_: i32;
var phi_21444_: i32;
var phi_17531_: i32;
var phi_17546_: i32;
var phi_17548_: i32;
var phi_17684_: i32;
var phi_17703_: u32;
var phi_17714_: u32;
var phi_17685_: i32;
var phi_17549_: i32;
var phi_17532_: i32;
var phi_13615_: i32;
var phi_13630_: i32;
var phi_13632_: i32;
var phi_13768_: i32;
var phi_13787_: u32;
var phi_13798_: u32;
var phi_13769_: i32;
var phi_13633_: i32;
var phi_13616_: i32;
var phi_7999_: type_16;
var phi_9678_: i32;
var phi_9693_: i32;
var phi_9813_: i32;
var phi_9852_: i32;
var phi_9871_: u32;
var phi_9882_: u32;
var phi_9853_: i32;
var phi_9814_: i32;
var phi_9679_: i32;
var phi_5859_: i32;
var phi_5874_: i32;
var phi_5876_: i32;
var phi_5915_: i32;
var phi_5934_: u32;
var phi_5945_: u32;
var phi_5916_: i32;
var phi_5877_: i32;
var phi_5860_: i32;
switch bitcast<i32>(0u) {
default: {
let _e191 = global;
let _e194 = arrayLength((&global_3.member));
let _e198 = arrayLength((&global_1.member));
let _e201 = global_2.member.member;
if (_e191.x < _e201.member) {
if (_e191.y < _e201.member_1) {
if (_e201.member_2 == 0u) {
let _e571 = global_2.member.member.member;
let _e573 = ((_e191.y * _e571) + _e191.x);
let _e574 = bitcast<i32>(_e573);
let _e575 = (_e574 * 9i);
let _e577 = (bitcast<i32>(_e194) - 9i);
if (_e575 < _e577) {
local_141 = _e575;
} else {
local_141 = _e577;
}
let _e579 = local_141;
if (_e579 < 0i) {
let _e786 = global_2.member.member_8;
let _e789 = global_2.member.member_9;
let _e790 = bitcast<i32>(_e789);
let _e792 = (_e786 & 31u);
let _e795 = ((2i * _e790) + (2i << bitcast<u32>(_e792)));
if ((_e795 >> bitcast<u32>(22u)) == 0i) {
phi_794_ = 0u;
} else {
let _e800 = (_e795 >> bitcast<u32>(16i));
let _e801 = (_e800 == 0i);
phi_794_ = ((((bitcast<u32>(f32(select(_e800, _e795, _e801))) >> bitcast<u32>(23i)) - 127u) + select(16u, 0u, _e801)) + 4294967275u);
}
let _e812 = phi_794_;
let _e822 = (((_e790 + 1i) + ((1i << bitcast<u32>((_e812 & 31u))) >> bitcast<u32>(1i))) + (_e795 >> bitcast<u32>(19i)));
let _e823 = (_e822 + 1i);
let _e827 = global_2.member.member_2.member;
let _e828 = bitcast<i32>(_e827);
let _e832 = global_2.member.member_2.member_1;
let _e833 = bitcast<i32>(_e832);
let _e837 = global_2.member.member_2.member_2;
let _e838 = bitcast<i32>(_e837);
let _e841 = ((-1i - _e822) >> bitcast<u32>(_e792));
let _e843 = select(0i, _e841, (_e841 > 0i));
if (_e843 < _e828) {
phi_828_ = _e843;
} else {
phi_828_ = (_e828 - 1i);
}
let _e847 = phi_828_;
if (_e843 < _e833) {
phi_842_ = _e843;
} else {
phi_842_ = (_e833 - 1i);
}
let _e851 = phi_842_;
if (_e843 < _e838) {
phi_856_ = _e843;
} else {
phi_856_ = (_e838 - 1i);
}
let _e855 = phi_856_;
let _e858 = (_e823 >> bitcast<u32>(_e792));
let _e860 = select(0i, _e858, (_e858 > 0i));
if (_e860 < _e828) {
phi_871_ = _e860;
} else {
phi_871_ = (_e828 - 1i);
}
let _e864 = phi_871_;
if (_e860 < _e833) {
phi_885_ = _e860;
} else {
phi_885_ = (_e833 - 1i);
}
let _e868 = phi_885_;
if (_e860 < _e838) {
phi_899_ = _e860;
} else {
phi_899_ = (_e838 - 1i);
}
let _e872 = phi_899_;
phi_1257_ = type_12(vec3<i32>(0i, 0i, 0i), vec3<i32>(0i, 0i, 0i), vec3<i32>(0i, 0i, 0i), vec3<i32>(_e847, _e851, _e855), vec3<i32>((_e864 - _e847), (_e868 - _e851), (_e872 - _e855)), _e823, _e786, _e812);
} else {
let _e581 = local_141;
let _e584 = global_3.member[bitcast<u32>(_e581)];
let _e585 = bitcast<i32>(_e584);
let _e586 = local_141;
let _e590 = global_3.member[bitcast<u32>((_e586 + 1i))];
let _e591 = bitcast<i32>(_e590);
let _e592 = local_141;
let _e596 = global_3.member[bitcast<u32>((_e592 + 2i))];
let _e597 = bitcast<i32>(_e596);
let _e599 = local_141;
let _e603 = global_3.member[bitcast<u32>((_e599 + 3i))];
let _e604 = bitcast<i32>(_e603);
let _e605 = local_141;
let _e609 = global_3.member[bitcast<u32>((_e605 + 4i))];
let _e610 = bitcast<i32>(_e609);
let _e611 = local_141;
let _e615 = global_3.member[bitcast<u32>((_e611 + 5i))];
let _e616 = bitcast<i32>(_e615);
let _e618 = local_141;
let _e622 = global_3.member[bitcast<u32>((_e618 + 6i))];
let _e623 = bitcast<i32>(_e622);
let _e624 = local_141;
let _e628 = global_3.member[bitcast<u32>((_e624 + 7i))];
let _e629 = bitcast<i32>(_e628);
let _e630 = local_141;
let _e634 = global_3.member[bitcast<u32>((_e630 + 8i))];
let _e635 = bitcast<i32>(_e634);
let _e639 = global_2.member.member_8;
let _e642 = global_2.member.member_9;
let _e643 = bitcast<i32>(_e642);
let _e645 = select(_e604, _e585, (_e585 < _e604));
let _e647 = select(_e610, _e591, (_e591 < _e610));
let _e649 = select(_e616, _e597, (_e597 < _e616));
let _e651 = select(_e623, _e645, (_e645 < _e623));
let _e653 = select(_e629, _e647, (_e647 < _e629));
let _e655 = select(_e635, _e649, (_e649 < _e635));
let _e657 = select(_e604, _e585, (_e585 > _e604));
let _e659 = select(_e610, _e591, (_e591 > _e610));
let _e661 = select(_e616, _e597, (_e597 > _e616));
let _e663 = select(_e623, _e657, (_e657 > _e623));
let _e665 = select(_e629, _e659, (_e659 > _e629));
let _e667 = select(_e635, _e661, (_e661 > _e635));
let _e668 = (_e663 - _e651);
let _e669 = (_e665 - _e653);
let _e670 = (_e667 - _e655);
let _e672 = select(_e669, _e668, (_e668 > _e669));
let _e677 = (_e639 & 31u);
let _e680 = ((select(_e670, _e672, (_e672 > _e670)) + (2i * _e643)) + (2i << bitcast<u32>(_e677)));
if ((_e680 >> bitcast<u32>(22u)) == 0i) {
phi_1146_ = 0u;
} else {
let _e685 = (_e680 >> bitcast<u32>(16i));
let _e686 = (_e685 == 0i);
phi_1146_ = ((((bitcast<u32>(f32(select(_e685, _e680, _e686))) >> bitcast<u32>(23i)) - 127u) + select(16u, 0u, _e686)) + 4294967275u);
}
let _e697 = phi_1146_;
let _e708 = ((((_e643 + 1i) + ((1i << bitcast<u32>((_e697 & 31u))) >> bitcast<u32>(1i))) + (_e680 >> bitcast<u32>(19i))) + 1i);
let _e712 = global_2.member.member_2.member;
let _e713 = bitcast<i32>(_e712);
let _e717 = global_2.member.member_2.member_1;
let _e718 = bitcast<i32>(_e717);
let _e722 = global_2.member.member_2.member_2;
let _e723 = bitcast<i32>(_e722);
let _e726 = ((_e651 - _e708) >> bitcast<u32>(_e677));
let _e728 = select(0i, _e726, (_e726 > 0i));
if (_e728 < _e713) {
phi_1180_ = _e728;
} else {
phi_1180_ = (_e713 - 1i);
}
let _e732 = phi_1180_;
let _e735 = ((_e653 - _e708) >> bitcast<u32>(_e677));
let _e737 = select(0i, _e735, (_e735 > 0i));
if (_e737 < _e718) {
phi_1194_ = _e737;
} else {
phi_1194_ = (_e718 - 1i);
}
let _e741 = phi_1194_;
let _e744 = ((_e655 - _e708) >> bitcast<u32>(_e677));
let _e746 = select(0i, _e744, (_e744 > 0i));
if (_e746 < _e723) {
phi_1208_ = _e746;
} else {
phi_1208_ = (_e723 - 1i);
}
let _e750 = phi_1208_;
let _e754 = ((_e663 + _e708) >> bitcast<u32>(_e677));
let _e756 = select(0i, _e754, (_e754 > 0i));
if (_e756 < _e713) {
phi_1223_ = _e756;
} else {
phi_1223_ = (_e713 - 1i);
}
let _e760 = phi_1223_;
let _e763 = ((_e665 + _e708) >> bitcast<u32>(_e677));
let _e765 = select(0i, _e763, (_e763 > 0i));
if (_e765 < _e718) {
phi_1237_ = _e765;
} else {
phi_1237_ = (_e718 - 1i);
}
let _e769 = phi_1237_;
let _e772 = ((_e667 + _e708) >> bitcast<u32>(_e677));
let _e774 = select(0i, _e772, (_e772 > 0i));
if (_e774 < _e723) {
phi_1251_ = _e774;
} else {
phi_1251_ = (_e723 - 1i);
}
let _e778 = phi_1251_;
phi_1257_ = type_12(vec3<i32>(_e585, _e591, _e597), vec3<i32>(_e604, _e610, _e616), vec3<i32>(_e623, _e629, _e635), vec3<i32>(_e732, _e741, _e750), vec3<i32>((_e760 - _e732), (_e769 - _e741), (_e778 - _e750)), _e708, _e639, _e697);
}
let _e879 = phi_1257_;
let _e882 = global_2.member.member_1;
let _e888 = (_e879.member_4.z >= _e879.member_4.y);
let _e890 = (1i + select(_e879.member_4.y, _e879.member_4.z, _e888));
if (_e890 == 1i) {
phi_1297_ = true;
} else {
phi_1297_ = ((_e890 * (1i + select(_e879.member_4.z, _e879.member_4.y, _e888))) <= 32i);
}
let _e897 = phi_1297_;
if ((_e573 < _e882) && _e897) {
phi_1313_ = _e890;
} else {
phi_1313_ = 0i;
}
let _e900 = phi_1313_;
phi_2103_ = type_14(type_13(_e574, 0i, _e900), _e879);
} else {
let _e213 = global_2.member.member.member;
let _e215 = ((_e191.y * _e213) + _e191.x);
let _e218 = global_2.member.member_1;
let _e220 = bitcast<i32>((_e215 * 3u));
let _e221 = (_e220 + 1i);
let _e223 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e225 = select(_e223, _e221, (_e221 < _e223));
let _e231 = global_4.member[bitcast<u32>(select(0i, _e225, (_e225 > 0i)))];
let _e232 = bitcast<i32>(_e231);
if (_e215 < _e218) {
let _e234 = (_e220 + 2i);
let _e236 = select(_e223, _e234, (_e234 < _e223));
let _e242 = global_4.member[bitcast<u32>(select(0i, _e236, (_e236 > 0i)))];
phi_1364_ = bitcast<i32>(_e242);
} else {
phi_1364_ = 0i;
}
let _e245 = phi_1364_;
let _e247 = select(_e223, _e220, (_e220 < _e223));
let _e253 = global_4.member[bitcast<u32>(select(0i, _e247, (_e247 > 0i)))];
let _e258 = global_2.member.member_10;
let _e260 = (bitcast<i32>(_e253) + bitcast<i32>(_e258));
let _e262 = (_e260 * 9i);
let _e264 = (bitcast<i32>(_e194) - 9i);
if (_e262 < _e264) {
local_140 = _e262;
} else {
local_140 = _e264;
}
let _e266 = local_140;
if (_e266 < 0i) {
let _e473 = global_2.member.member_8;
let _e476 = global_2.member.member_9;
let _e477 = bitcast<i32>(_e476);
let _e479 = (_e473 & 31u);
let _e482 = ((2i * _e477) + (2i << bitcast<u32>(_e479)));
if ((_e482 >> bitcast<u32>(22u)) == 0i) {
phi_1638_ = 0u;
} else {
let _e487 = (_e482 >> bitcast<u32>(16i));
let _e488 = (_e487 == 0i);
phi_1638_ = ((((bitcast<u32>(f32(select(_e487, _e482, _e488))) >> bitcast<u32>(23i)) - 127u) + select(16u, 0u, _e488)) + 4294967275u);
}
let _e499 = phi_1638_;
let _e509 = (((_e477 + 1i) + ((1i << bitcast<u32>((_e499 & 31u))) >> bitcast<u32>(1i))) + (_e482 >> bitcast<u32>(19i)));
let _e510 = (_e509 + 1i);
let _e514 = global_2.member.member_2.member;
let _e515 = bitcast<i32>(_e514);
let _e519 = global_2.member.member_2.member_1;
let _e520 = bitcast<i32>(_e519);
let _e524 = global_2.member.member_2.member_2;
let _e525 = bitcast<i32>(_e524);
let _e528 = ((-1i - _e509) >> bitcast<u32>(_e479));
let _e530 = select(0i, _e528, (_e528 > 0i));
if (_e530 < _e515) {
phi_1672_ = _e530;
} else {
phi_1672_ = (_e515 - 1i);
}
let _e534 = phi_1672_;
if (_e530 < _e520) {
phi_1686_ = _e530;
} else {
phi_1686_ = (_e520 - 1i);
}
let _e538 = phi_1686_;
if (_e530 < _e525) {
phi_1700_ = _e530;
} else {
phi_1700_ = (_e525 - 1i);
}
let _e542 = phi_1700_;
let _e545 = (_e510 >> bitcast<u32>(_e479));
let _e547 = select(0i, _e545, (_e545 > 0i));
if (_e547 < _e515) {
phi_1715_ = _e547;
} else {
phi_1715_ = (_e515 - 1i);
}
let _e551 = phi_1715_;
if (_e547 < _e520) {
phi_1729_ = _e547;
} else {
phi_1729_ = (_e520 - 1i);
}
let _e555 = phi_1729_;
if (_e547 < _e525) {
phi_1743_ = _e547;
} else {
phi_1743_ = (_e525 - 1i);
}
let _e559 = phi_1743_;
phi_2101_ = type_12(vec3<i32>(0i, 0i, 0i), vec3<i32>(0i, 0i, 0i), vec3<i32>(0i, 0i, 0i), vec3<i32>(_e534, _e538, _e542), vec3<i32>((_e551 - _e534), (_e555 - _e538), (_e559 - _e542)), _e510, _e473, _e499);
} else {
let _e268 = local_140;
let _e271 = global_3.member[bitcast<u32>(_e268)];
let _e272 = bitcast<i32>(_e271);
let _e273 = local_140;
let _e277 = global_3.member[bitcast<u32>((_e273 + 1i))];
let _e278 = bitcast<i32>(_e277);
let _e279 = local_140;
let _e283 = global_3.member[bitcast<u32>((_e279 + 2i))];
let _e284 = bitcast<i32>(_e283);
let _e286 = local_140;
let _e290 = global_3.member[bitcast<u32>((_e286 + 3i))];
let _e291 = bitcast<i32>(_e290);
let _e292 = local_140;
let _e296 = global_3.member[bitcast<u32>((_e292 + 4i))];
let _e297 = bitcast<i32>(_e296);
let _e298 = local_140;
let _e302 = global_3.member[bitcast<u32>((_e298 + 5i))];
let _e303 = bitcast<i32>(_e302);
let _e305 = local_140;
let _e309 = global_3.member[bitcast<u32>((_e305 + 6i))];
let _e310 = bitcast<i32>(_e309);
let _e311 = local_140;
let _e315 = global_3.member[bitcast<u32>((_e311 + 7i))];
let _e316 = bitcast<i32>(_e315);
let _e317 = local_140;
let _e321 = global_3.member[bitcast<u32>((_e317 + 8i))];
let _e322 = bitcast<i32>(_e321);
let _e326 = global_2.member.member_8;
let _e329 = global_2.member.member_9;
let _e330 = bitcast<i32>(_e329);
let _e332 = select(_e291, _e272, (_e272 < _e291));
let _e334 = select(_e297, _e278, (_e278 < _e297));
let _e336 = select(_e303, _e284, (_e284 < _e303));
let _e338 = select(_e310, _e332, (_e332 < _e310));
let _e340 = select(_e316, _e334, (_e334 < _e316));
let _e342 = select(_e322, _e336, (_e336 < _e322));
let _e344 = select(_e291, _e272, (_e272 > _e291));
let _e346 = select(_e297, _e278, (_e278 > _e297));
let _e348 = select(_e303, _e284, (_e284 > _e303));
let _e350 = select(_e310, _e344, (_e344 > _e310));
let _e352 = select(_e316, _e346, (_e346 > _e316));
let _e354 = select(_e322, _e348, (_e348 > _e322));
let _e355 = (_e350 - _e338);
let _e356 = (_e352 - _e340);
let _e357 = (_e354 - _e342);
let _e359 = select(_e356, _e355, (_e355 > _e356));
let _e364 = (_e326 & 31u);
let _e367 = ((select(_e357, _e359, (_e359 > _e357)) + (2i * _e330)) + (2i << bitcast<u32>(_e364)));
if ((_e367 >> bitcast<u32>(22u)) == 0i) {
phi_1990_ = 0u;
} else {
let _e372 = (_e367 >> bitcast<u32>(16i));
let _e373 = (_e372 == 0i);
phi_1990_ = ((((bitcast<u32>(f32(select(_e372, _e367, _e373))) >> bitcast<u32>(23i)) - 127u) + select(16u, 0u, _e373)) + 4294967275u);
}
let _e384 = phi_1990_;
let _e395 = ((((_e330 + 1i) + ((1i << bitcast<u32>((_e384 & 31u))) >> bitcast<u32>(1i))) + (_e367 >> bitcast<u32>(19i))) + 1i);
let _e399 = global_2.member.member_2.member;
let _e400 = bitcast<i32>(_e399);
let _e404 = global_2.member.member_2.member_1;
let _e405 = bitcast<i32>(_e404);
let _e409 = global_2.member.member_2.member_2;
let _e410 = bitcast<i32>(_e409);
let _e413 = ((_e338 - _e395) >> bitcast<u32>(_e364));
let _e415 = select(0i, _e413, (_e413 > 0i));
if (_e415 < _e400) {
phi_2024_ = _e415;
} else {
phi_2024_ = (_e400 - 1i);
}
let _e419 = phi_2024_;
let _e422 = ((_e340 - _e395) >> bitcast<u32>(_e364));
let _e424 = select(0i, _e422, (_e422 > 0i));
if (_e424 < _e405) {
phi_2038_ = _e424;
} else {
phi_2038_ = (_e405 - 1i);
}
let _e428 = phi_2038_;
let _e431 = ((_e342 - _e395) >> bitcast<u32>(_e364));
let _e433 = select(0i, _e431, (_e431 > 0i));
if (_e433 < _e410) {
phi_2052_ = _e433;
} else {
phi_2052_ = (_e410 - 1i);
}
let _e437 = phi_2052_;
let _e441 = ((_e350 + _e395) >> bitcast<u32>(_e364));
let _e443 = select(0i, _e441, (_e441 > 0i));
if (_e443 < _e400) {
phi_2067_ = _e443;
} else {
phi_2067_ = (_e400 - 1i);
}
let _e447 = phi_2067_;
let _e450 = ((_e352 + _e395) >> bitcast<u32>(_e364));
let _e452 = select(0i, _e450, (_e450 > 0i));
if (_e452 < _e405) {
phi_2081_ = _e452;
} else {
phi_2081_ = (_e405 - 1i);
}
let _e456 = phi_2081_;
let _e459 = ((_e354 + _e395) >> bitcast<u32>(_e364));
let _e461 = select(0i, _e459, (_e459 > 0i));
if (_e461 < _e410) {
phi_2095_ = _e461;
} else {
phi_2095_ = (_e410 - 1i);
}
let _e465 = phi_2095_;
phi_2101_ = type_12(vec3<i32>(_e272, _e278, _e284), vec3<i32>(_e291, _e297, _e303), vec3<i32>(_e310, _e316, _e322), vec3<i32>(_e419, _e428, _e437), vec3<i32>((_e447 - _e419), (_e456 - _e428), (_e465 - _e437)), _e395, _e326, _e384);
}
let _e566 = phi_2101_;
phi_2103_ = type_14(type_13(_e260, _e232, (_e232 + _e245)), _e566);
}
let _e904 = phi_2103_;
if (_e904.member.member_1 < _e904.member.member_2) {
let _e912 = (_e904.member_1.member_4.x == 0i);
let _e915 = (_e904.member_1.member_4.y == 0i);
let _e918 = (_e904.member_1.member_4.z == 0i);
if (((_e912 && _e915) || (_e915 && _e918)) || (_e918 && _e912)) {
phi_2138_ = 0u;
} else {
if _e912 {
phi_2137_ = 1u;
} else {
if _e915 {
phi_2136_ = 2u;
} else {
phi_2136_ = select(4u, 3u, _e918);
}
let _e926 = phi_2136_;
phi_2137_ = _e926;
}
let _e928 = phi_2137_;
phi_2138_ = _e928;
}
let _e930 = phi_2138_;
if (_e930 == 0u) {
let _e4733 = (_e904.member_1.member_6 & 31u);
let _e4735 = (_e904.member_1.member_3.x << bitcast<u32>(_e4733));
let _e4738 = (_e904.member_1.member_7 & 31u);
let _e4742 = ((1i << bitcast<u32>(_e4738)) >> bitcast<u32>(1i));
let _e4748 = bitcast<i32>(_e904.member_1.member_6);
let _e4754 = bitcast<f32>((bitcast<u32>((127i + (bitcast<i32>(_e904.member_1.member_7) - _e4748))) << bitcast<u32>(23i)));
let _e4755 = (f32((((_e904.member_1.member.x - _e4735) + _e4742) >> bitcast<u32>(_e4738))) * _e4754);
let _e4760 = (_e904.member_1.member_3.y << bitcast<u32>(_e4733));
let _e4766 = (f32((((_e904.member_1.member.y - _e4760) + _e4742) >> bitcast<u32>(_e4738))) * _e4754);
let _e4771 = (_e904.member_1.member_3.z << bitcast<u32>(_e4733));
let _e4777 = (f32((((_e904.member_1.member.z - _e4771) + _e4742) >> bitcast<u32>(_e4738))) * _e4754);
let _e4785 = (f32((((_e904.member_1.member_1.x - _e4735) + _e4742) >> bitcast<u32>(_e4738))) * _e4754);
let _e4792 = (f32((((_e904.member_1.member_1.y - _e4760) + _e4742) >> bitcast<u32>(_e4738))) * _e4754);
let _e4799 = (f32((((_e904.member_1.member_1.z - _e4771) + _e4742) >> bitcast<u32>(_e4738))) * _e4754);
let _e4807 = (f32((((_e904.member_1.member_2.x - _e4735) + _e4742) >> bitcast<u32>(_e4738))) * _e4754);
let _e4814 = (f32((((_e904.member_1.member_2.y - _e4760) + _e4742) >> bitcast<u32>(_e4738))) * _e4754);
let _e4821 = (f32((((_e904.member_1.member_2.z - _e4771) + _e4742) >> bitcast<u32>(_e4738))) * _e4754);
let _e4829 = (f32(_e904.member_1.member_5) * bitcast<f32>((bitcast<u32>((127i - _e4748)) << bitcast<u32>(23i))));
let _e4830 = (_e4785 - _e4755);
let _e4831 = (_e4792 - _e4766);
let _e4832 = (_e4799 - _e4777);
let _e4833 = (_e4807 - _e4785);
let _e4834 = (_e4814 - _e4792);
let _e4835 = (_e4821 - _e4799);
let _e4838 = ((_e4831 * _e4835) - (_e4832 * _e4834));
let _e4845 = (1f + _e4829);
let _e4848 = (_e904.member_1.member_4.z >= _e904.member_1.member_4.y);
if _e4848 {
let _e4942 = select(1f, -1f, (_e4838 < 0f));
let _e4947 = ((_e4777 - _e4799) * _e4942);
let _e4948 = ((_e4799 - _e4821) * _e4942);
let _e4949 = ((_e4821 - _e4777) * _e4942);
let _e4950 = ((0f - 0f) * _e4942);
let _e4952 = (_e4831 * _e4942);
let _e4953 = (_e4834 * _e4942);
let _e4954 = ((_e4766 - _e4814) * _e4942);
if (select(0u, 1u, ((_e4947 * _e4845) > -((_e4947 * _e4829)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4948 * _e4845) > -((_e4948 * _e4829)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4949 * _e4845) > -((_e4949 * _e4829)))) < 2u) {
} else {
break;
}
let _e4978 = (select(0u, 1u, ((_e4950 * _e4845) > -((_e4950 * _e4829)))) < 2u);
if _e4978 {
} else {
break;
}
if (select(0u, 1u, ((_e4952 * _e4845) > -((_e4952 * _e4829)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4953 * _e4845) > -((_e4953 * _e4829)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4954 * _e4845) > -((_e4954 * _e4829)))) < 2u) {
} else {
break;
}
if _e4978 {
} else {
break;
}
if (select(0u, 1u, (_e4947 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4948 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4949 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4950 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4947 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4948 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4949 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4950 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4947 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4948 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4949 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4950 < 0f)) < 2u) {
} else {
break;
}
} else {
let _e4850 = select(1f, -1f, (-(_e4838) < 0f));
let _e4855 = ((_e4766 - _e4792) * _e4850);
let _e4856 = ((_e4792 - _e4814) * _e4850);
let _e4857 = ((_e4814 - _e4766) * _e4850);
let _e4858 = ((0f - 0f) * _e4850);
let _e4860 = (_e4832 * _e4850);
let _e4861 = (_e4835 * _e4850);
let _e4862 = ((_e4777 - _e4821) * _e4850);
if (select(0u, 1u, ((_e4855 * _e4845) > -((_e4855 * _e4829)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4856 * _e4845) > -((_e4856 * _e4829)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4857 * _e4845) > -((_e4857 * _e4829)))) < 2u) {
} else {
break;
}
let _e4886 = (select(0u, 1u, ((_e4858 * _e4845) > -((_e4858 * _e4829)))) < 2u);
if _e4886 {
} else {
break;
}
if (select(0u, 1u, ((_e4860 * _e4845) > -((_e4860 * _e4829)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4861 * _e4845) > -((_e4861 * _e4829)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4862 * _e4845) > -((_e4862 * _e4829)))) < 2u) {
} else {
break;
}
if _e4886 {
} else {
break;
}
if (select(0u, 1u, (_e4855 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4856 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4857 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4858 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4855 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4856 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4857 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4858 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4855 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4856 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4857 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4858 < 0f)) < 2u) {
} else {
break;
}
}
let _e5035 = select(1f, -1f, (((_e4830 * _e4834) - (_e4831 * _e4833)) < 0f));
let _e5039 = (0f - 0f);
let _e5040 = ((_e4766 - _e4792) * _e5035);
let _e5041 = ((_e4792 - _e4814) * _e5035);
let _e5042 = ((_e4814 - _e4766) * _e5035);
let _e5043 = (_e5039 * _e5035);
let _e5044 = (_e4755 - _e4807);
let _e5045 = (_e4830 * _e5035);
let _e5046 = (_e4833 * _e5035);
let _e5047 = (_e5044 * _e5035);
if (select(0u, 1u, ((_e5040 * _e4845) > -((_e5040 * _e4829)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e5041 * _e4845) > -((_e5041 * _e4829)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e5042 * _e4845) > -((_e5042 * _e4829)))) < 2u) {
} else {
break;
}
let _e5071 = (select(0u, 1u, ((_e5043 * _e4845) > -((_e5043 * _e4829)))) < 2u);
if _e5071 {
} else {
break;
}
if (select(0u, 1u, ((_e5045 * _e4845) > -((_e5045 * _e4829)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e5046 * _e4845) > -((_e5046 * _e4829)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e5047 * _e4845) > -((_e5047 * _e4829)))) < 2u) {
} else {
break;
}
if _e5071 {
} else {
break;
}
if (select(0u, 1u, (_e5040 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e5041 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e5042 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e5043 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e5040 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e5041 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e5042 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e5043 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e5040 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e5041 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e5042 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e5043 < 0f)) < 2u) {
} else {
break;
}
let _e5127 = select(1f, -1f, (-(((_e4832 * _e4833) - (_e4830 * _e4835))) < 0f));
let _e5131 = ((_e4777 - _e4799) * _e5127);
let _e5132 = ((_e4799 - _e4821) * _e5127);
let _e5133 = ((_e4821 - _e4777) * _e5127);
let _e5134 = (_e5039 * _e5127);
let _e5135 = (_e4830 * _e5127);
let _e5136 = (_e4833 * _e5127);
let _e5137 = (_e5044 * _e5127);
if (select(0u, 1u, ((_e5131 * _e4845) > -((_e5131 * _e4829)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e5132 * _e4845) > -((_e5132 * _e4829)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e5133 * _e4845) > -((_e5133 * _e4829)))) < 2u) {
} else {
break;
}
let _e5161 = (select(0u, 1u, ((_e5134 * _e4845) > -((_e5134 * _e4829)))) < 2u);
if _e5161 {
} else {
break;
}
if (select(0u, 1u, ((_e5135 * _e4845) > -((_e5135 * _e4829)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e5136 * _e4845) > -((_e5136 * _e4829)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e5137 * _e4845) > -((_e5137 * _e4829)))) < 2u) {
} else {
break;
}
if _e5161 {
} else {
break;
}
if (select(0u, 1u, (_e5131 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e5132 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e5133 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e5134 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e5131 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e5132 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e5133 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e5134 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e5131 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e5132 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e5133 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e5134 < 0f)) < 2u) {
} else {
break;
}
phi_5859_ = _e904.member.member_1;
loop {
let _e5217 = phi_5859_;
let _e5218 = (_e5217 < _e904.member.member_2);
if _e5218 {
if _e4848 {
phi_5874_ = _e904.member_1.member_4.y;
} else {
phi_5874_ = _e904.member_1.member_4.z;
}
let _e5222 = phi_5874_;
phi_5876_ = 0i;
loop {
let _e5224 = phi_5876_;
let _e5225 = (_e5224 <= _e5222);
if _e5225 {
if (0i <= _e904.member_1.member_4.x) {
let _e5234 = global_2.member.member_2.member_1;
let _e5241 = global_2.member.member_3;
let _e5244 = (_e904.member_1.member_3.x + _e904.member_1.member_4.x);
let _e5246 = (_e904.member_1.member_3.x >> bitcast<u32>(5i));
phi_5915_ = _e5246;
loop {
let _e5248 = phi_5915_;
let _e5250 = (_e5244 >> bitcast<u32>(5i));
let _e5251 = (_e5248 <= _e5250);
if _e5251 {
if (_e5248 == _e5246) {
phi_5934_ = (4294967295u << bitcast<u32>((bitcast<u32>((_e904.member_1.member_3.x & 31i)) & 31u)));
} else {
phi_5934_ = 4294967295u;
}
let _e5259 = phi_5934_;
if (_e5248 == _e5250) {
phi_5945_ = (4294967295u >> bitcast<u32>((bitcast<u32>((31i - (_e5244 & 31i))) & 31u)));
} else {
phi_5945_ = 4294967295u;
}
let _e5268 = phi_5945_;
let _e5270 = bitcast<u32>(((((((_e904.member_1.member_3.z + select(_e5224, _e5217, _e4848)) * bitcast<i32>(_e5234)) + _e904.member_1.member_3.y) + select(_e5217, _e5224, _e4848)) * bitcast<i32>(_e5241)) + _e5248));
if (_e5270 < _e198) {
let _e5275 = atomicOr((&global_1.member[_e5270]), (_e5259 & _e5268));
}
phi_5916_ = (_e5248 + 1i);
} else {
phi_5916_ = i32();
}
let _e5278 = phi_5916_;
continue;
continuing {
phi_5915_ = _e5278;
break if !(_e5251);
}
}
}
phi_5877_ = (_e5224 + 1i);
} else {
phi_5877_ = i32();
}
let _e5282 = phi_5877_;
continue;
continuing {
phi_5876_ = _e5282;
break if !(_e5225);
}
}
phi_5860_ = (_e5217 + 1i);
} else {
phi_5860_ = i32();
}
let _e5286 = phi_5860_;
continue;
continuing {
phi_5859_ = _e5286;
break if !(_e5218);
}
}
} else {
if (_e930 == 1u) {
let _e3784 = (_e904.member_1.member_6 & 31u);
let _e3786 = (_e904.member_1.member_3.x << bitcast<u32>(_e3784));
let _e3789 = (_e904.member_1.member_7 & 31u);
let _e3793 = ((1i << bitcast<u32>(_e3789)) >> bitcast<u32>(1i));
let _e3799 = bitcast<i32>(_e904.member_1.member_6);
let _e3805 = bitcast<f32>((bitcast<u32>((127i + (bitcast<i32>(_e904.member_1.member_7) - _e3799))) << bitcast<u32>(23i)));
let _e3806 = (f32((((_e904.member_1.member.x - _e3786) + _e3793) >> bitcast<u32>(_e3789))) * _e3805);
let _e3811 = (_e904.member_1.member_3.y << bitcast<u32>(_e3784));
let _e3817 = (f32((((_e904.member_1.member.y - _e3811) + _e3793) >> bitcast<u32>(_e3789))) * _e3805);
let _e3822 = (_e904.member_1.member_3.z << bitcast<u32>(_e3784));
let _e3828 = (f32((((_e904.member_1.member.z - _e3822) + _e3793) >> bitcast<u32>(_e3789))) * _e3805);
let _e3836 = (f32((((_e904.member_1.member_1.x - _e3786) + _e3793) >> bitcast<u32>(_e3789))) * _e3805);
let _e3843 = (f32((((_e904.member_1.member_1.y - _e3811) + _e3793) >> bitcast<u32>(_e3789))) * _e3805);
let _e3850 = (f32((((_e904.member_1.member_1.z - _e3822) + _e3793) >> bitcast<u32>(_e3789))) * _e3805);
let _e3858 = (f32((((_e904.member_1.member_2.x - _e3786) + _e3793) >> bitcast<u32>(_e3789))) * _e3805);
let _e3865 = (f32((((_e904.member_1.member_2.y - _e3811) + _e3793) >> bitcast<u32>(_e3789))) * _e3805);
let _e3872 = (f32((((_e904.member_1.member_2.z - _e3822) + _e3793) >> bitcast<u32>(_e3789))) * _e3805);
let _e3880 = (f32(_e904.member_1.member_5) * bitcast<f32>((bitcast<u32>((127i - _e3799)) << bitcast<u32>(23i))));
let _e3881 = (_e3836 - _e3806);
let _e3882 = (_e3843 - _e3817);
let _e3883 = (_e3850 - _e3828);
let _e3884 = (_e3858 - _e3836);
let _e3885 = (_e3865 - _e3843);
let _e3886 = (_e3872 - _e3850);
let _e3887 = (_e3882 * _e3886);
let _e3888 = (_e3883 * _e3885);
let _e3889 = (_e3887 - _e3888);
let _e3903 = ((bitcast<f32>((bitcast<u32>(_e3887) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e3888) & 2147483647u))) * 2.3841858e-7f);
let _e3904 = f32(_e904.member_1.member_4.y);
let _e3905 = f32(_e904.member_1.member_4.z);
let _e3906 = (1f + _e3880);
let _e3907 = -(_e3889);
let _e3909 = (_e904.member_1.member_4.z >= _e904.member_1.member_4.y);
if _e3909 {
let _e4150 = select(1f, -1f, (_e3889 < 0f));
let _e4156 = select(0f, (2f * _e3903), (bitcast<f32>((bitcast<u32>(_e3889) & 2147483647u)) <= _e3903));
let _e4161 = ((_e3828 - _e3850) * _e4150);
let _e4162 = ((_e3850 - _e3872) * _e4150);
let _e4163 = ((_e3872 - _e3828) * _e4150);
let _e4164 = ((0f - 0f) * _e4150);
let _e4166 = (_e3882 * _e4150);
let _e4167 = (_e3885 * _e4150);
let _e4168 = ((_e3817 - _e3865) * _e4150);
let _e4170 = (_e4161 * _e3906);
let _e4171 = (_e4162 * _e3906);
let _e4172 = (_e4163 * _e3906);
let _e4173 = (_e4164 * _e3906);
let _e4178 = -((_e4161 * _e3880));
let _e4179 = -((_e4162 * _e3880));
let _e4180 = -((_e4163 * _e3880));
let _e4181 = -((_e4164 * _e3880));
local_136 = array<u32, 2>(0u, 4294967295u);
let _e4186 = select(0u, 1u, (_e4170 > _e4178));
if (_e4186 < 2u) {
} else {
break;
}
let _e4189 = local_136[_e4186];
local_137 = array<u32, 2>(0u, 4294967295u);
let _e4190 = select(0u, 1u, (_e4171 > _e4179));
if (_e4190 < 2u) {
} else {
break;
}
let _e4193 = local_137[_e4190];
local_138 = array<u32, 2>(0u, 4294967295u);
let _e4194 = select(0u, 1u, (_e4172 > _e4180));
if (_e4194 < 2u) {
} else {
break;
}
let _e4197 = local_138[_e4194];
local_139 = array<u32, 2>(0u, 4294967295u);
let _e4198 = select(0u, 1u, (_e4173 > _e4181));
let _e4199 = (_e4198 < 2u);
if _e4199 {
} else {
break;
}
let _e4201 = local_139[_e4198];
let _e4217 = (_e4164 * 0f);
let _e4222 = (_e4166 * _e3906);
let _e4223 = (_e4167 * _e3906);
let _e4224 = (_e4168 * _e3906);
let _e4228 = -((_e4166 * _e3880));
let _e4229 = -((_e4167 * _e3880));
let _e4230 = -((_e4168 * _e3880));
local_132 = array<u32, 2>(0u, 4294967295u);
let _e4234 = select(0u, 1u, (_e4222 > _e4228));
if (_e4234 < 2u) {
} else {
break;
}
let _e4237 = local_132[_e4234];
local_133 = array<u32, 2>(0u, 4294967295u);
let _e4238 = select(0u, 1u, (_e4223 > _e4229));
if (_e4238 < 2u) {
} else {
break;
}
let _e4241 = local_133[_e4238];
local_134 = array<u32, 2>(0u, 4294967295u);
let _e4242 = select(0u, 1u, (_e4224 > _e4230));
if (_e4242 < 2u) {
} else {
break;
}
let _e4245 = local_134[_e4242];
local_135 = array<u32, 2>(0u, 4294967295u);
if _e4199 {
} else {
break;
}
let _e4247 = local_135[_e4198];
local_128 = array<u32, 2>(0u, 4294967295u);
let _e4280 = select(0u, 1u, (_e4161 == 0f));
if (_e4280 < 2u) {
} else {
break;
}
let _e4283 = local_128[_e4280];
local_129 = array<u32, 2>(0u, 4294967295u);
let _e4284 = select(0u, 1u, (_e4162 == 0f));
if (_e4284 < 2u) {
} else {
break;
}
let _e4287 = local_129[_e4284];
local_130 = array<u32, 2>(0u, 4294967295u);
let _e4288 = select(0u, 1u, (_e4163 == 0f));
if (_e4288 < 2u) {
} else {
break;
}
let _e4291 = local_130[_e4288];
local_131 = array<u32, 2>(0u, 4294967295u);
let _e4292 = select(0u, 1u, (_e4164 == 0f));
if (_e4292 < 2u) {
} else {
break;
}
let _e4295 = local_131[_e4292];
let _e4297 = ((_e4283 & 1u) != 0u);
let _e4300 = ((_e4287 & 1u) != 0u);
let _e4303 = ((_e4291 & 1u) != 0u);
let _e4306 = ((_e4295 & 1u) != 0u);
let _e4308 = (-1f / select(_e4161, 1f, _e4297));
let _e4309 = (-1f / select(_e4162, 1f, _e4300));
let _e4310 = (-1f / select(_e4163, 1f, _e4303));
let _e4311 = (-1f / select(_e4164, 1f, _e4306));
local_124 = array<u32, 2>(0u, 4294967295u);
let _e4316 = select(0u, 1u, (_e4161 > 0f));
if (_e4316 < 2u) {
} else {
break;
}
let _e4319 = local_124[_e4316];
local_125 = array<u32, 2>(0u, 4294967295u);
let _e4320 = select(0u, 1u, (_e4162 > 0f));
if (_e4320 < 2u) {
} else {
break;
}
let _e4323 = local_125[_e4320];
local_126 = array<u32, 2>(0u, 4294967295u);
let _e4324 = select(0u, 1u, (_e4163 > 0f));
if (_e4324 < 2u) {
} else {
break;
}
let _e4327 = local_126[_e4324];
local_127 = array<u32, 2>(0u, 4294967295u);
let _e4328 = select(0u, 1u, (_e4164 > 0f));
if (_e4328 < 2u) {
} else {
break;
}
let _e4331 = local_127[_e4328];
local_120 = array<u32, 2>(0u, 4294967295u);
let _e4336 = select(0u, 1u, (_e4161 < 0f));
if (_e4336 < 2u) {
} else {
break;
}
let _e4339 = local_120[_e4336];
local_121 = array<u32, 2>(0u, 4294967295u);
let _e4340 = select(0u, 1u, (_e4162 < 0f));
if (_e4340 < 2u) {
} else {
break;
}
let _e4343 = local_121[_e4340];
local_122 = array<u32, 2>(0u, 4294967295u);
let _e4344 = select(0u, 1u, (_e4163 < 0f));
if (_e4344 < 2u) {
} else {
break;
}
let _e4347 = local_122[_e4344];
local_123 = array<u32, 2>(0u, 4294967295u);
let _e4348 = select(0u, 1u, (_e4164 < 0f));
if (_e4348 < 2u) {
} else {
break;
}
let _e4351 = local_123[_e4348];
let _e4370 = ((_e4339 & 1u) != 0u);
let _e4373 = ((_e4343 & 1u) != 0u);
let _e4376 = ((_e4347 & 1u) != 0u);
let _e4379 = ((_e4351 & 1u) != 0u);
phi_7999_ = type_16(vec4<f32>(_e4166, _e4167, _e4168, _e4164), vec4<f32>((((select(_e4178, _e4170, ((_e4189 & 1u) != 0u)) - (_e4161 * _e3817)) + (select(_e4228, _e4222, ((_e4237 & 1u) != 0u)) - (_e4166 * _e3828))) + _e4156), (((select(_e4179, _e4171, ((_e4193 & 1u) != 0u)) - (_e4162 * _e3843)) + (select(_e4229, _e4223, ((_e4241 & 1u) != 0u)) - (_e4167 * _e3850))) + _e4156), (((select(_e4180, _e4172, ((_e4197 & 1u) != 0u)) - (_e4163 * _e3865)) + (select(_e4230, _e4224, ((_e4245 & 1u) != 0u)) - (_e4168 * _e3872))) + _e4156), (((select(_e4181, _e4173, ((_e4201 & 1u) != 0u)) - _e4217) + (select(_e4181, _e4173, ((_e4247 & 1u) != 0u)) - _e4217)) + _e4156)), vec4<f32>(select(0f, _e4308, ((_e4319 & 1u) != 0u)), select(0f, _e4309, ((_e4323 & 1u) != 0u)), select(0f, _e4310, ((_e4327 & 1u) != 0u)), select(0f, _e4311, ((_e4331 & 1u) != 0u))), vec4<f32>(select(select(0f, 1e20f, _e4297), _e4308, _e4370), select(select(0f, 1e20f, _e4300), _e4309, _e4373), select(select(0f, 1e20f, _e4303), _e4310, _e4376), select(select(0f, 1e20f, _e4306), _e4311, _e4379)), vec4<f32>(select(_e3904, 0f, _e4370), select(_e3904, 0f, _e4373), select(_e3904, 0f, _e4376), select(_e3904, 0f, _e4379)));
} else {
let _e3911 = select(1f, -1f, (_e3907 < 0f));
let _e3917 = select(0f, (2f * _e3903), (bitcast<f32>((bitcast<u32>(_e3907) & 2147483647u)) <= _e3903));
let _e3922 = ((_e3817 - _e3843) * _e3911);
let _e3923 = ((_e3843 - _e3865) * _e3911);
let _e3924 = ((_e3865 - _e3817) * _e3911);
let _e3925 = ((0f - 0f) * _e3911);
let _e3927 = (_e3883 * _e3911);
let _e3928 = (_e3886 * _e3911);
let _e3929 = ((_e3828 - _e3872) * _e3911);
let _e3931 = (_e3922 * _e3906);
let _e3932 = (_e3923 * _e3906);
let _e3933 = (_e3924 * _e3906);
let _e3934 = (_e3925 * _e3906);
let _e3939 = -((_e3922 * _e3880));
let _e3940 = -((_e3923 * _e3880));
let _e3941 = -((_e3924 * _e3880));
let _e3942 = -((_e3925 * _e3880));
local_116 = array<u32, 2>(0u, 4294967295u);
let _e3947 = select(0u, 1u, (_e3931 > _e3939));
if (_e3947 < 2u) {
} else {
break;
}
let _e3950 = local_116[_e3947];
local_117 = array<u32, 2>(0u, 4294967295u);
let _e3951 = select(0u, 1u, (_e3932 > _e3940));
if (_e3951 < 2u) {
} else {
break;
}
let _e3954 = local_117[_e3951];
local_118 = array<u32, 2>(0u, 4294967295u);
let _e3955 = select(0u, 1u, (_e3933 > _e3941));
if (_e3955 < 2u) {
} else {
break;
}
let _e3958 = local_118[_e3955];
local_119 = array<u32, 2>(0u, 4294967295u);
let _e3959 = select(0u, 1u, (_e3934 > _e3942));
let _e3960 = (_e3959 < 2u);
if _e3960 {
} else {
break;
}
let _e3962 = local_119[_e3959];
let _e3978 = (_e3925 * 0f);
let _e3983 = (_e3927 * _e3906);
let _e3984 = (_e3928 * _e3906);
let _e3985 = (_e3929 * _e3906);
let _e3989 = -((_e3927 * _e3880));
let _e3990 = -((_e3928 * _e3880));
let _e3991 = -((_e3929 * _e3880));
local_112 = array<u32, 2>(0u, 4294967295u);
let _e3995 = select(0u, 1u, (_e3983 > _e3989));
if (_e3995 < 2u) {
} else {
break;
}
let _e3998 = local_112[_e3995];
local_113 = array<u32, 2>(0u, 4294967295u);
let _e3999 = select(0u, 1u, (_e3984 > _e3990));
if (_e3999 < 2u) {
} else {
break;
}
let _e4002 = local_113[_e3999];
local_114 = array<u32, 2>(0u, 4294967295u);
let _e4003 = select(0u, 1u, (_e3985 > _e3991));
if (_e4003 < 2u) {
} else {
break;
}
let _e4006 = local_114[_e4003];
local_115 = array<u32, 2>(0u, 4294967295u);
if _e3960 {
} else {
break;
}
let _e4008 = local_115[_e3959];
local_108 = array<u32, 2>(0u, 4294967295u);
let _e4041 = select(0u, 1u, (_e3922 == 0f));
if (_e4041 < 2u) {
} else {
break;
}
let _e4044 = local_108[_e4041];
local_109 = array<u32, 2>(0u, 4294967295u);
let _e4045 = select(0u, 1u, (_e3923 == 0f));
if (_e4045 < 2u) {
} else {
break;
}
let _e4048 = local_109[_e4045];
local_110 = array<u32, 2>(0u, 4294967295u);
let _e4049 = select(0u, 1u, (_e3924 == 0f));
if (_e4049 < 2u) {
} else {
break;
}
let _e4052 = local_110[_e4049];
local_111 = array<u32, 2>(0u, 4294967295u);
let _e4053 = select(0u, 1u, (_e3925 == 0f));
if (_e4053 < 2u) {
} else {
break;
}
let _e4056 = local_111[_e4053];
let _e4058 = ((_e4044 & 1u) != 0u);
let _e4061 = ((_e4048 & 1u) != 0u);
let _e4064 = ((_e4052 & 1u) != 0u);
let _e4067 = ((_e4056 & 1u) != 0u);
let _e4069 = (-1f / select(_e3922, 1f, _e4058));
let _e4070 = (-1f / select(_e3923, 1f, _e4061));
let _e4071 = (-1f / select(_e3924, 1f, _e4064));
let _e4072 = (-1f / select(_e3925, 1f, _e4067));
local_104 = array<u32, 2>(0u, 4294967295u);
let _e4077 = select(0u, 1u, (_e3922 > 0f));
if (_e4077 < 2u) {
} else {
break;
}
let _e4080 = local_104[_e4077];
local_105 = array<u32, 2>(0u, 4294967295u);
let _e4081 = select(0u, 1u, (_e3923 > 0f));
if (_e4081 < 2u) {
} else {
break;
}
let _e4084 = local_105[_e4081];
local_106 = array<u32, 2>(0u, 4294967295u);
let _e4085 = select(0u, 1u, (_e3924 > 0f));
if (_e4085 < 2u) {
} else {
break;
}
let _e4088 = local_106[_e4085];
local_107 = array<u32, 2>(0u, 4294967295u);
let _e4089 = select(0u, 1u, (_e3925 > 0f));
if (_e4089 < 2u) {
} else {
break;
}
let _e4092 = local_107[_e4089];
local_100 = array<u32, 2>(0u, 4294967295u);
let _e4097 = select(0u, 1u, (_e3922 < 0f));
if (_e4097 < 2u) {
} else {
break;
}
let _e4100 = local_100[_e4097];
local_101 = array<u32, 2>(0u, 4294967295u);
let _e4101 = select(0u, 1u, (_e3923 < 0f));
if (_e4101 < 2u) {
} else {
break;
}
let _e4104 = local_101[_e4101];
local_102 = array<u32, 2>(0u, 4294967295u);
let _e4105 = select(0u, 1u, (_e3924 < 0f));
if (_e4105 < 2u) {
} else {
break;
}
let _e4108 = local_102[_e4105];
local_103 = array<u32, 2>(0u, 4294967295u);
let _e4109 = select(0u, 1u, (_e3925 < 0f));
if (_e4109 < 2u) {
} else {
break;
}
let _e4112 = local_103[_e4109];
let _e4131 = ((_e4100 & 1u) != 0u);
let _e4134 = ((_e4104 & 1u) != 0u);
let _e4137 = ((_e4108 & 1u) != 0u);
let _e4140 = ((_e4112 & 1u) != 0u);
phi_7999_ = type_16(vec4<f32>(_e3927, _e3928, _e3929, _e3925), vec4<f32>((((select(_e3939, _e3931, ((_e3950 & 1u) != 0u)) - (_e3922 * _e3828)) + (select(_e3989, _e3983, ((_e3998 & 1u) != 0u)) - (_e3927 * _e3817))) + _e3917), (((select(_e3940, _e3932, ((_e3954 & 1u) != 0u)) - (_e3923 * _e3850)) + (select(_e3990, _e3984, ((_e4002 & 1u) != 0u)) - (_e3928 * _e3843))) + _e3917), (((select(_e3941, _e3933, ((_e3958 & 1u) != 0u)) - (_e3924 * _e3872)) + (select(_e3991, _e3985, ((_e4006 & 1u) != 0u)) - (_e3929 * _e3865))) + _e3917), (((select(_e3942, _e3934, ((_e3962 & 1u) != 0u)) - _e3978) + (select(_e3942, _e3934, ((_e4008 & 1u) != 0u)) - _e3978)) + _e3917)), vec4<f32>(select(0f, _e4069, ((_e4080 & 1u) != 0u)), select(0f, _e4070, ((_e4084 & 1u) != 0u)), select(0f, _e4071, ((_e4088 & 1u) != 0u)), select(0f, _e4072, ((_e4092 & 1u) != 0u))), vec4<f32>(select(select(0f, 1e20f, _e4058), _e4069, _e4131), select(select(0f, 1e20f, _e4061), _e4070, _e4134), select(select(0f, 1e20f, _e4064), _e4071, _e4137), select(select(0f, 1e20f, _e4067), _e4072, _e4140)), vec4<f32>(select(_e3905, 0f, _e4131), select(_e3905, 0f, _e4134), select(_e3905, 0f, _e4137), select(_e3905, 0f, _e4140)));
}
let _e4389 = phi_7999_;
let _e4392 = select(1f, -1f, (((_e3881 * _e3885) - (_e3882 * _e3884)) < 0f));
let _e4396 = (0f - 0f);
let _e4397 = ((_e3817 - _e3843) * _e4392);
let _e4398 = ((_e3843 - _e3865) * _e4392);
let _e4399 = ((_e3865 - _e3817) * _e4392);
let _e4400 = (_e4396 * _e4392);
let _e4401 = (_e3806 - _e3858);
let _e4402 = (_e3881 * _e4392);
let _e4403 = (_e3884 * _e4392);
let _e4404 = (_e4401 * _e4392);
if (select(0u, 1u, ((_e4397 * _e3906) > -((_e4397 * _e3880)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4398 * _e3906) > -((_e4398 * _e3880)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4399 * _e3906) > -((_e4399 * _e3880)))) < 2u) {
} else {
break;
}
let _e4428 = (select(0u, 1u, ((_e4400 * _e3906) > -((_e4400 * _e3880)))) < 2u);
if _e4428 {
} else {
break;
}
if (select(0u, 1u, ((_e4402 * _e3906) > -((_e4402 * _e3880)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4403 * _e3906) > -((_e4403 * _e3880)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4404 * _e3906) > -((_e4404 * _e3880)))) < 2u) {
} else {
break;
}
if _e4428 {
} else {
break;
}
if (select(0u, 1u, (_e4397 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4398 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4399 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4400 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4397 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4398 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4399 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4400 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4397 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4398 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4399 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4400 < 0f)) < 2u) {
} else {
break;
}
let _e4484 = select(1f, -1f, (-(((_e3883 * _e3884) - (_e3881 * _e3886))) < 0f));
let _e4488 = ((_e3828 - _e3850) * _e4484);
let _e4489 = ((_e3850 - _e3872) * _e4484);
let _e4490 = ((_e3872 - _e3828) * _e4484);
let _e4491 = (_e4396 * _e4484);
let _e4492 = (_e3881 * _e4484);
let _e4493 = (_e3884 * _e4484);
let _e4494 = (_e4401 * _e4484);
if (select(0u, 1u, ((_e4488 * _e3906) > -((_e4488 * _e3880)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4489 * _e3906) > -((_e4489 * _e3880)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4490 * _e3906) > -((_e4490 * _e3880)))) < 2u) {
} else {
break;
}
let _e4518 = (select(0u, 1u, ((_e4491 * _e3906) > -((_e4491 * _e3880)))) < 2u);
if _e4518 {
} else {
break;
}
if (select(0u, 1u, ((_e4492 * _e3906) > -((_e4492 * _e3880)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4493 * _e3906) > -((_e4493 * _e3880)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e4494 * _e3906) > -((_e4494 * _e3880)))) < 2u) {
} else {
break;
}
if _e4518 {
} else {
break;
}
if (select(0u, 1u, (_e4488 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4489 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4490 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4491 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4488 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4489 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4490 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4491 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4488 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4489 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4490 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e4491 < 0f)) < 2u) {
} else {
break;
}
phi_9678_ = _e904.member.member_1;
loop {
let _e4574 = phi_9678_;
let _e4575 = (_e4574 < _e904.member.member_2);
if _e4575 {
if _e3909 {
phi_9693_ = _e904.member_1.member_4.y;
} else {
phi_9693_ = _e904.member_1.member_4.z;
}
let _e4579 = phi_9693_;
let _e4580 = f32(_e4579);
let _e4581 = f32(_e4574);
let _e4591 = ((_e4389.member.x * _e4581) + _e4389.member_1.x);
let _e4593 = ((_e4389.member.y * _e4581) + _e4389.member_1.y);
let _e4595 = ((_e4389.member.z * _e4581) + _e4389.member_1.z);
let _e4598 = (_e4591 * _e4389.member_2.x);
let _e4600 = (_e4593 * _e4389.member_2.y);
let _e4602 = (_e4595 * _e4389.member_2.z);
let _e4612 = ((_e4591 * _e4389.member_3.x) + _e4389.member_4.x);
let _e4614 = ((_e4593 * _e4389.member_3.y) + _e4389.member_4.y);
let _e4616 = ((_e4595 * _e4389.member_3.z) + _e4389.member_4.z);
let _e4618 = select(_e4598, 0f, (0f > _e4598));
let _e4620 = select(_e4602, _e4600, (_e4600 > _e4602));
let _e4624 = select(_e4612, _e4580, (_e4580 < _e4612));
let _e4626 = select(_e4616, _e4614, (_e4614 < _e4616));
let _e4628 = select(_e4626, _e4624, (_e4624 < _e4626));
let _e4629 = -(select(_e4620, _e4618, (_e4618 > _e4620)));
let _e4631 = (-(_e4580) - 1f);
let _e4633 = select(_e4631, _e4629, (_e4629 > _e4631));
let _e4635 = select(0f, _e4633, (_e4633 < 0f));
let _e4642 = select(0i, select(select(i32(_e4635), i32(-2147483648), (_e4635 < -2147483600f)), 2147483647i, (_e4635 > 2147483500f)), (_e4635 == _e4635));
let _e4649 = select(-1f, _e4628, (_e4628 > -1f));
let _e4651 = select(_e4580, _e4649, (_e4649 < _e4580));
let _e4658 = select(0i, select(select(i32(_e4651), i32(-2147483648), (_e4651 < -2147483600f)), 2147483647i, (_e4651 > 2147483500f)), (_e4651 == _e4651));
phi_9813_ = -((_e4642 - select(0i, 1i, (_e4635 < f32(_e4642)))));
loop {
let _e4664 = phi_9813_;
let _e4665 = (_e4664 <= (_e4658 - select(0i, 1i, (_e4651 < f32(_e4658)))));
if _e4665 {
if (0i <= _e904.member_1.member_4.x) {
let _e4674 = global_2.member.member_2.member_1;
let _e4681 = global_2.member.member_3;
let _e4684 = (_e904.member_1.member_3.x + _e904.member_1.member_4.x);
let _e4686 = (_e904.member_1.member_3.x >> bitcast<u32>(5i));
phi_9852_ = _e4686;
loop {
let _e4688 = phi_9852_;
let _e4690 = (_e4684 >> bitcast<u32>(5i));
let _e4691 = (_e4688 <= _e4690);
if _e4691 {
if (_e4688 == _e4686) {
phi_9871_ = (4294967295u << bitcast<u32>((bitcast<u32>((_e904.member_1.member_3.x & 31i)) & 31u)));
} else {
phi_9871_ = 4294967295u;
}
let _e4699 = phi_9871_;
if (_e4688 == _e4690) {
phi_9882_ = (4294967295u >> bitcast<u32>((bitcast<u32>((31i - (_e4684 & 31i))) & 31u)));
} else {
phi_9882_ = 4294967295u;
}
let _e4708 = phi_9882_;
let _e4710 = bitcast<u32>(((((((_e904.member_1.member_3.z + select(_e4664, _e4574, _e3909)) * bitcast<i32>(_e4674)) + _e904.member_1.member_3.y) + select(_e4574, _e4664, _e3909)) * bitcast<i32>(_e4681)) + _e4688));
if (_e4710 < _e198) {
let _e4715 = atomicOr((&global_1.member[_e4710]), (_e4699 & _e4708));
}
phi_9853_ = (_e4688 + 1i);
} else {
phi_9853_ = i32();
}
let _e4718 = phi_9853_;
continue;
continuing {
phi_9852_ = _e4718;
break if !(_e4691);
}
}
}
phi_9814_ = (_e4664 + 1i);
} else {
phi_9814_ = i32();
}
let _e4722 = phi_9814_;
continue;
continuing {
phi_9813_ = _e4722;
break if !(_e4665);
}
}
phi_9679_ = (_e4574 + 1i);
} else {
phi_9679_ = i32();
}
let _e4726 = phi_9679_;
continue;
continuing {
phi_9678_ = _e4726;
break if !(_e4575);
}
}
} else {
if (_e930 == 2u) {
let _e3043 = (_e904.member_1.member_6 & 31u);
let _e3045 = (_e904.member_1.member_3.x << bitcast<u32>(_e3043));
let _e3048 = (_e904.member_1.member_7 & 31u);
let _e3052 = ((1i << bitcast<u32>(_e3048)) >> bitcast<u32>(1i));
let _e3058 = bitcast<i32>(_e904.member_1.member_6);
let _e3064 = bitcast<f32>((bitcast<u32>((127i + (bitcast<i32>(_e904.member_1.member_7) - _e3058))) << bitcast<u32>(23i)));
let _e3065 = (f32((((_e904.member_1.member.x - _e3045) + _e3052) >> bitcast<u32>(_e3048))) * _e3064);
let _e3070 = (_e904.member_1.member_3.y << bitcast<u32>(_e3043));
let _e3076 = (f32((((_e904.member_1.member.y - _e3070) + _e3052) >> bitcast<u32>(_e3048))) * _e3064);
let _e3081 = (_e904.member_1.member_3.z << bitcast<u32>(_e3043));
let _e3087 = (f32((((_e904.member_1.member.z - _e3081) + _e3052) >> bitcast<u32>(_e3048))) * _e3064);
let _e3095 = (f32((((_e904.member_1.member_1.x - _e3045) + _e3052) >> bitcast<u32>(_e3048))) * _e3064);
let _e3102 = (f32((((_e904.member_1.member_1.y - _e3070) + _e3052) >> bitcast<u32>(_e3048))) * _e3064);
let _e3109 = (f32((((_e904.member_1.member_1.z - _e3081) + _e3052) >> bitcast<u32>(_e3048))) * _e3064);
let _e3117 = (f32((((_e904.member_1.member_2.x - _e3045) + _e3052) >> bitcast<u32>(_e3048))) * _e3064);
let _e3124 = (f32((((_e904.member_1.member_2.y - _e3070) + _e3052) >> bitcast<u32>(_e3048))) * _e3064);
let _e3131 = (f32((((_e904.member_1.member_2.z - _e3081) + _e3052) >> bitcast<u32>(_e3048))) * _e3064);
let _e3139 = (f32(_e904.member_1.member_5) * bitcast<f32>((bitcast<u32>((127i - _e3058)) << bitcast<u32>(23i))));
let _e3140 = (_e3095 - _e3065);
let _e3141 = (_e3102 - _e3076);
let _e3142 = (_e3109 - _e3087);
let _e3143 = (_e3117 - _e3095);
let _e3144 = (_e3124 - _e3102);
let _e3145 = (_e3131 - _e3109);
let _e3148 = ((_e3141 * _e3145) - (_e3142 * _e3144));
let _e3149 = (_e3142 * _e3143);
let _e3150 = (_e3140 * _e3145);
let _e3162 = ((bitcast<f32>((bitcast<u32>(_e3149) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e3150) & 2147483647u))) * 2.3841858e-7f);
let _e3163 = f32(_e904.member_1.member_4.x);
let _e3164 = (1f + _e3139);
let _e3166 = -((_e3149 - _e3150));
let _e3167 = (_e904.member_1.member_4.z >= _e904.member_1.member_4.y);
if _e3167 {
let _e3261 = select(1f, -1f, (_e3148 < 0f));
let _e3266 = ((_e3087 - _e3109) * _e3261);
let _e3267 = ((_e3109 - _e3131) * _e3261);
let _e3268 = ((_e3131 - _e3087) * _e3261);
let _e3269 = ((0f - 0f) * _e3261);
let _e3271 = (_e3141 * _e3261);
let _e3272 = (_e3144 * _e3261);
let _e3273 = ((_e3076 - _e3124) * _e3261);
if (select(0u, 1u, ((_e3266 * _e3164) > -((_e3266 * _e3139)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3267 * _e3164) > -((_e3267 * _e3139)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3268 * _e3164) > -((_e3268 * _e3139)))) < 2u) {
} else {
break;
}
let _e3297 = (select(0u, 1u, ((_e3269 * _e3164) > -((_e3269 * _e3139)))) < 2u);
if _e3297 {
} else {
break;
}
if (select(0u, 1u, ((_e3271 * _e3164) > -((_e3271 * _e3139)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3272 * _e3164) > -((_e3272 * _e3139)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3273 * _e3164) > -((_e3273 * _e3139)))) < 2u) {
} else {
break;
}
if _e3297 {
} else {
break;
}
if (select(0u, 1u, (_e3266 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3267 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3268 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3269 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3266 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3267 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3268 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3269 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3266 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3267 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3268 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3269 < 0f)) < 2u) {
} else {
break;
}
} else {
let _e3169 = select(1f, -1f, (-(_e3148) < 0f));
let _e3174 = ((_e3076 - _e3102) * _e3169);
let _e3175 = ((_e3102 - _e3124) * _e3169);
let _e3176 = ((_e3124 - _e3076) * _e3169);
let _e3177 = ((0f - 0f) * _e3169);
let _e3179 = (_e3142 * _e3169);
let _e3180 = (_e3145 * _e3169);
let _e3181 = ((_e3087 - _e3131) * _e3169);
if (select(0u, 1u, ((_e3174 * _e3164) > -((_e3174 * _e3139)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3175 * _e3164) > -((_e3175 * _e3139)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3176 * _e3164) > -((_e3176 * _e3139)))) < 2u) {
} else {
break;
}
let _e3205 = (select(0u, 1u, ((_e3177 * _e3164) > -((_e3177 * _e3139)))) < 2u);
if _e3205 {
} else {
break;
}
if (select(0u, 1u, ((_e3179 * _e3164) > -((_e3179 * _e3139)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3180 * _e3164) > -((_e3180 * _e3139)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3181 * _e3164) > -((_e3181 * _e3139)))) < 2u) {
} else {
break;
}
if _e3205 {
} else {
break;
}
if (select(0u, 1u, (_e3174 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3175 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3176 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3177 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3174 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3175 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3176 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3177 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3174 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3175 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3176 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3177 < 0f)) < 2u) {
} else {
break;
}
}
let _e3354 = select(1f, -1f, (((_e3140 * _e3144) - (_e3141 * _e3143)) < 0f));
let _e3358 = (0f - 0f);
let _e3359 = ((_e3076 - _e3102) * _e3354);
let _e3360 = ((_e3102 - _e3124) * _e3354);
let _e3361 = ((_e3124 - _e3076) * _e3354);
let _e3362 = (_e3358 * _e3354);
let _e3363 = (_e3065 - _e3117);
let _e3364 = (_e3140 * _e3354);
let _e3365 = (_e3143 * _e3354);
let _e3366 = (_e3363 * _e3354);
if (select(0u, 1u, ((_e3359 * _e3164) > -((_e3359 * _e3139)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3360 * _e3164) > -((_e3360 * _e3139)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3361 * _e3164) > -((_e3361 * _e3139)))) < 2u) {
} else {
break;
}
let _e3390 = (select(0u, 1u, ((_e3362 * _e3164) > -((_e3362 * _e3139)))) < 2u);
if _e3390 {
} else {
break;
}
if (select(0u, 1u, ((_e3364 * _e3164) > -((_e3364 * _e3139)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3365 * _e3164) > -((_e3365 * _e3139)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e3366 * _e3164) > -((_e3366 * _e3139)))) < 2u) {
} else {
break;
}
if _e3390 {
} else {
break;
}
if (select(0u, 1u, (_e3359 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3360 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3361 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3362 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3359 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3360 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3361 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3362 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3359 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3360 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3361 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e3362 < 0f)) < 2u) {
} else {
break;
}
let _e3446 = select(1f, -1f, (_e3166 < 0f));
let _e3452 = select(0f, (2f * _e3162), (bitcast<f32>((bitcast<u32>(_e3166) & 2147483647u)) <= _e3162));
let _e3456 = ((_e3087 - _e3109) * _e3446);
let _e3457 = ((_e3109 - _e3131) * _e3446);
let _e3458 = ((_e3131 - _e3087) * _e3446);
let _e3459 = (_e3358 * _e3446);
let _e3460 = (_e3140 * _e3446);
let _e3461 = (_e3143 * _e3446);
let _e3462 = (_e3363 * _e3446);
let _e3463 = (_e3456 * _e3164);
let _e3464 = (_e3457 * _e3164);
let _e3465 = (_e3458 * _e3164);
let _e3471 = -((_e3456 * _e3139));
let _e3472 = -((_e3457 * _e3139));
let _e3473 = -((_e3458 * _e3139));
local_97 = array<u32, 2>(0u, 4294967295u);
let _e3479 = select(0u, 1u, (_e3463 > _e3471));
if (_e3479 < 2u) {
} else {
break;
}
let _e3482 = local_97[_e3479];
local_98 = array<u32, 2>(0u, 4294967295u);
let _e3483 = select(0u, 1u, (_e3464 > _e3472));
if (_e3483 < 2u) {
} else {
break;
}
let _e3486 = local_98[_e3483];
local_99 = array<u32, 2>(0u, 4294967295u);
let _e3487 = select(0u, 1u, (_e3465 > _e3473));
if (_e3487 < 2u) {
} else {
break;
}
let _e3490 = local_99[_e3487];
let _e3492 = (select(0u, 1u, ((_e3459 * _e3164) > -((_e3459 * _e3139)))) < 2u);
if _e3492 {
} else {
break;
}
let _e3508 = (_e3460 * _e3164);
let _e3509 = (_e3461 * _e3164);
let _e3510 = (_e3462 * _e3164);
let _e3514 = -((_e3460 * _e3139));
let _e3515 = -((_e3461 * _e3139));
let _e3516 = -((_e3462 * _e3139));
local_94 = array<u32, 2>(0u, 4294967295u);
let _e3520 = select(0u, 1u, (_e3508 > _e3514));
if (_e3520 < 2u) {
} else {
break;
}
let _e3523 = local_94[_e3520];
local_95 = array<u32, 2>(0u, 4294967295u);
let _e3524 = select(0u, 1u, (_e3509 > _e3515));
if (_e3524 < 2u) {
} else {
break;
}
let _e3527 = local_95[_e3524];
local_96 = array<u32, 2>(0u, 4294967295u);
let _e3528 = select(0u, 1u, (_e3510 > _e3516));
if (_e3528 < 2u) {
} else {
break;
}
let _e3531 = local_96[_e3528];
if _e3492 {
} else {
break;
}
local_91 = array<u32, 2>(0u, 4294967295u);
let _e3557 = select(0u, 1u, (_e3456 == 0f));
if (_e3557 < 2u) {
} else {
break;
}
let _e3560 = local_91[_e3557];
local_92 = array<u32, 2>(0u, 4294967295u);
let _e3561 = select(0u, 1u, (_e3457 == 0f));
if (_e3561 < 2u) {
} else {
break;
}
let _e3564 = local_92[_e3561];
local_93 = array<u32, 2>(0u, 4294967295u);
let _e3565 = select(0u, 1u, (_e3458 == 0f));
if (_e3565 < 2u) {
} else {
break;
}
let _e3568 = local_93[_e3565];
if (select(0u, 1u, (_e3459 == 0f)) < 2u) {
} else {
break;
}
let _e3572 = ((_e3560 & 1u) != 0u);
let _e3575 = ((_e3564 & 1u) != 0u);
let _e3578 = ((_e3568 & 1u) != 0u);
let _e3580 = (-1f / select(_e3456, 1f, _e3572));
let _e3581 = (-1f / select(_e3457, 1f, _e3575));
let _e3582 = (-1f / select(_e3458, 1f, _e3578));
local_88 = array<u32, 2>(0u, 4294967295u);
let _e3587 = select(0u, 1u, (_e3456 > 0f));
if (_e3587 < 2u) {
} else {
break;
}
let _e3590 = local_88[_e3587];
local_89 = array<u32, 2>(0u, 4294967295u);
let _e3591 = select(0u, 1u, (_e3457 > 0f));
if (_e3591 < 2u) {
} else {
break;
}
let _e3594 = local_89[_e3591];
local_90 = array<u32, 2>(0u, 4294967295u);
let _e3595 = select(0u, 1u, (_e3458 > 0f));
if (_e3595 < 2u) {
} else {
break;
}
let _e3598 = local_90[_e3595];
if (select(0u, 1u, (_e3459 > 0f)) < 2u) {
} else {
break;
}
local_85 = array<u32, 2>(0u, 4294967295u);
let _e3605 = select(0u, 1u, (_e3456 < 0f));
if (_e3605 < 2u) {
} else {
break;
}
let _e3608 = local_85[_e3605];
local_86 = array<u32, 2>(0u, 4294967295u);
let _e3609 = select(0u, 1u, (_e3457 < 0f));
if (_e3609 < 2u) {
} else {
break;
}
let _e3612 = local_86[_e3609];
local_87 = array<u32, 2>(0u, 4294967295u);
let _e3613 = select(0u, 1u, (_e3458 < 0f));
if (_e3613 < 2u) {
} else {
break;
}
let _e3616 = local_87[_e3613];
if (select(0u, 1u, (_e3459 < 0f)) < 2u) {
} else {
break;
}
let _e3632 = ((_e3608 & 1u) != 0u);
let _e3635 = ((_e3612 & 1u) != 0u);
let _e3638 = ((_e3616 & 1u) != 0u);
phi_13615_ = _e904.member.member_1;
loop {
let _e3644 = phi_13615_;
let _e3645 = (_e3644 < _e904.member.member_2);
if _e3645 {
if _e3167 {
phi_13630_ = _e904.member_1.member_4.y;
} else {
phi_13630_ = _e904.member_1.member_4.z;
}
let _e3649 = phi_13630_;
phi_13632_ = 0i;
loop {
let _e3651 = phi_13632_;
let _e3652 = (_e3651 <= _e3649);
if _e3652 {
let _e3653 = select(_e3651, _e3644, _e3167);
let _e3655 = f32(_e3653);
let _e3657 = f32(_e904.member_1.member_4.x);
let _e3661 = ((_e3460 * _e3655) + (((select(_e3471, _e3463, ((_e3482 & 1u) != 0u)) - (_e3456 * _e3065)) + (select(_e3514, _e3508, ((_e3523 & 1u) != 0u)) - (_e3460 * _e3087))) + _e3452));
let _e3662 = ((_e3461 * _e3655) + (((select(_e3472, _e3464, ((_e3486 & 1u) != 0u)) - (_e3457 * _e3095)) + (select(_e3515, _e3509, ((_e3527 & 1u) != 0u)) - (_e3461 * _e3109))) + _e3452));
let _e3663 = ((_e3462 * _e3655) + (((select(_e3473, _e3465, ((_e3490 & 1u) != 0u)) - (_e3458 * _e3117)) + (select(_e3516, _e3510, ((_e3531 & 1u) != 0u)) - (_e3462 * _e3131))) + _e3452));
let _e3664 = (_e3661 * select(0f, _e3580, ((_e3590 & 1u) != 0u)));
let _e3665 = (_e3662 * select(0f, _e3581, ((_e3594 & 1u) != 0u)));
let _e3666 = (_e3663 * select(0f, _e3582, ((_e3598 & 1u) != 0u)));
let _e3670 = ((_e3661 * select(select(0f, 1e20f, _e3572), _e3580, _e3632)) + select(_e3163, 0f, _e3632));
let _e3671 = ((_e3662 * select(select(0f, 1e20f, _e3575), _e3581, _e3635)) + select(_e3163, 0f, _e3635));
let _e3672 = ((_e3663 * select(select(0f, 1e20f, _e3578), _e3582, _e3638)) + select(_e3163, 0f, _e3638));
let _e3674 = select(_e3664, 0f, (0f > _e3664));
let _e3676 = select(_e3666, _e3665, (_e3665 > _e3666));
let _e3680 = select(_e3670, _e3657, (_e3657 < _e3670));
let _e3682 = select(_e3672, _e3671, (_e3671 < _e3672));
let _e3684 = select(_e3682, _e3680, (_e3680 < _e3682));
let _e3685 = -(select(_e3676, _e3674, (_e3674 > _e3676)));
let _e3687 = (-(_e3657) - 1f);
let _e3689 = select(_e3687, _e3685, (_e3685 > _e3687));
let _e3691 = select(0f, _e3689, (_e3689 < 0f));
let _e3698 = select(0i, select(select(i32(_e3691), i32(-2147483648), (_e3691 < -2147483600f)), 2147483647i, (_e3691 > 2147483500f)), (_e3691 == _e3691));
let _e3703 = -((_e3698 - select(0i, 1i, (_e3691 < f32(_e3698)))));
let _e3705 = select(-1f, _e3684, (_e3684 > -1f));
let _e3707 = select(_e3657, _e3705, (_e3705 < _e3657));
let _e3714 = select(0i, select(select(i32(_e3707), i32(-2147483648), (_e3707 < -2147483600f)), 2147483647i, (_e3707 > 2147483500f)), (_e3707 == _e3707));
let _e3718 = (_e3714 - select(0i, 1i, (_e3707 < f32(_e3714))));
if (_e3703 <= _e3718) {
let _e3724 = global_2.member.member_2.member_1;
let _e3731 = global_2.member.member_3;
let _e3734 = (_e904.member_1.member_3.x + _e3703);
let _e3735 = (_e904.member_1.member_3.x + _e3718);
let _e3737 = (_e3734 >> bitcast<u32>(5i));
phi_13768_ = _e3737;
loop {
let _e3739 = phi_13768_;
let _e3741 = (_e3735 >> bitcast<u32>(5i));
let _e3742 = (_e3739 <= _e3741);
if _e3742 {
if (_e3739 == _e3737) {
phi_13787_ = (4294967295u << bitcast<u32>((bitcast<u32>((_e3734 & 31i)) & 31u)));
} else {
phi_13787_ = 4294967295u;
}
let _e3750 = phi_13787_;
if (_e3739 == _e3741) {
phi_13798_ = (4294967295u >> bitcast<u32>((bitcast<u32>((31i - (_e3735 & 31i))) & 31u)));
} else {
phi_13798_ = 4294967295u;
}
let _e3759 = phi_13798_;
let _e3761 = bitcast<u32>(((((((_e904.member_1.member_3.z + _e3653) * bitcast<i32>(_e3724)) + _e904.member_1.member_3.y) + select(_e3644, _e3651, _e3167)) * bitcast<i32>(_e3731)) + _e3739));
if (_e3761 < _e198) {
let _e3766 = atomicOr((&global_1.member[_e3761]), (_e3750 & _e3759));
}
phi_13769_ = (_e3739 + 1i);
} else {
phi_13769_ = i32();
}
let _e3769 = phi_13769_;
continue;
continuing {
phi_13768_ = _e3769;
break if !(_e3742);
}
}
}
phi_13633_ = (_e3651 + 1i);
} else {
phi_13633_ = i32();
}
let _e3773 = phi_13633_;
continue;
continuing {
phi_13632_ = _e3773;
break if !(_e3652);
}
}
phi_13616_ = (_e3644 + 1i);
} else {
phi_13616_ = i32();
}
let _e3777 = phi_13616_;
continue;
continuing {
phi_13615_ = _e3777;
break if !(_e3645);
}
}
} else {
if (_e930 == 3u) {
let _e2302 = (_e904.member_1.member_6 & 31u);
let _e2304 = (_e904.member_1.member_3.x << bitcast<u32>(_e2302));
let _e2307 = (_e904.member_1.member_7 & 31u);
let _e2311 = ((1i << bitcast<u32>(_e2307)) >> bitcast<u32>(1i));
let _e2317 = bitcast<i32>(_e904.member_1.member_6);
let _e2323 = bitcast<f32>((bitcast<u32>((127i + (bitcast<i32>(_e904.member_1.member_7) - _e2317))) << bitcast<u32>(23i)));
let _e2324 = (f32((((_e904.member_1.member.x - _e2304) + _e2311) >> bitcast<u32>(_e2307))) * _e2323);
let _e2329 = (_e904.member_1.member_3.y << bitcast<u32>(_e2302));
let _e2335 = (f32((((_e904.member_1.member.y - _e2329) + _e2311) >> bitcast<u32>(_e2307))) * _e2323);
let _e2340 = (_e904.member_1.member_3.z << bitcast<u32>(_e2302));
let _e2346 = (f32((((_e904.member_1.member.z - _e2340) + _e2311) >> bitcast<u32>(_e2307))) * _e2323);
let _e2354 = (f32((((_e904.member_1.member_1.x - _e2304) + _e2311) >> bitcast<u32>(_e2307))) * _e2323);
let _e2361 = (f32((((_e904.member_1.member_1.y - _e2329) + _e2311) >> bitcast<u32>(_e2307))) * _e2323);
let _e2368 = (f32((((_e904.member_1.member_1.z - _e2340) + _e2311) >> bitcast<u32>(_e2307))) * _e2323);
let _e2376 = (f32((((_e904.member_1.member_2.x - _e2304) + _e2311) >> bitcast<u32>(_e2307))) * _e2323);
let _e2383 = (f32((((_e904.member_1.member_2.y - _e2329) + _e2311) >> bitcast<u32>(_e2307))) * _e2323);
let _e2390 = (f32((((_e904.member_1.member_2.z - _e2340) + _e2311) >> bitcast<u32>(_e2307))) * _e2323);
let _e2398 = (f32(_e904.member_1.member_5) * bitcast<f32>((bitcast<u32>((127i - _e2317)) << bitcast<u32>(23i))));
let _e2399 = (_e2354 - _e2324);
let _e2400 = (_e2361 - _e2335);
let _e2401 = (_e2368 - _e2346);
let _e2402 = (_e2376 - _e2354);
let _e2403 = (_e2383 - _e2361);
let _e2404 = (_e2390 - _e2368);
let _e2407 = ((_e2400 * _e2404) - (_e2401 * _e2403));
let _e2411 = (_e2399 * _e2403);
let _e2412 = (_e2400 * _e2402);
let _e2413 = (_e2411 - _e2412);
let _e2421 = ((bitcast<f32>((bitcast<u32>(_e2411) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2412) & 2147483647u))) * 2.3841858e-7f);
let _e2422 = f32(_e904.member_1.member_4.x);
let _e2423 = (1f + _e2398);
let _e2426 = (_e904.member_1.member_4.z >= _e904.member_1.member_4.y);
if _e2426 {
let _e2520 = select(1f, -1f, (_e2407 < 0f));
let _e2525 = ((_e2346 - _e2368) * _e2520);
let _e2526 = ((_e2368 - _e2390) * _e2520);
let _e2527 = ((_e2390 - _e2346) * _e2520);
let _e2528 = ((0f - 0f) * _e2520);
let _e2530 = (_e2400 * _e2520);
let _e2531 = (_e2403 * _e2520);
let _e2532 = ((_e2335 - _e2383) * _e2520);
if (select(0u, 1u, ((_e2525 * _e2423) > -((_e2525 * _e2398)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e2526 * _e2423) > -((_e2526 * _e2398)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e2527 * _e2423) > -((_e2527 * _e2398)))) < 2u) {
} else {
break;
}
let _e2556 = (select(0u, 1u, ((_e2528 * _e2423) > -((_e2528 * _e2398)))) < 2u);
if _e2556 {
} else {
break;
}
if (select(0u, 1u, ((_e2530 * _e2423) > -((_e2530 * _e2398)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e2531 * _e2423) > -((_e2531 * _e2398)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e2532 * _e2423) > -((_e2532 * _e2398)))) < 2u) {
} else {
break;
}
if _e2556 {
} else {
break;
}
if (select(0u, 1u, (_e2525 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2526 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2527 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2528 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2525 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2526 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2527 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2528 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2525 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2526 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2527 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2528 < 0f)) < 2u) {
} else {
break;
}
} else {
let _e2428 = select(1f, -1f, (-(_e2407) < 0f));
let _e2433 = ((_e2335 - _e2361) * _e2428);
let _e2434 = ((_e2361 - _e2383) * _e2428);
let _e2435 = ((_e2383 - _e2335) * _e2428);
let _e2436 = ((0f - 0f) * _e2428);
let _e2438 = (_e2401 * _e2428);
let _e2439 = (_e2404 * _e2428);
let _e2440 = ((_e2346 - _e2390) * _e2428);
if (select(0u, 1u, ((_e2433 * _e2423) > -((_e2433 * _e2398)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e2434 * _e2423) > -((_e2434 * _e2398)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e2435 * _e2423) > -((_e2435 * _e2398)))) < 2u) {
} else {
break;
}
let _e2464 = (select(0u, 1u, ((_e2436 * _e2423) > -((_e2436 * _e2398)))) < 2u);
if _e2464 {
} else {
break;
}
if (select(0u, 1u, ((_e2438 * _e2423) > -((_e2438 * _e2398)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e2439 * _e2423) > -((_e2439 * _e2398)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e2440 * _e2423) > -((_e2440 * _e2398)))) < 2u) {
} else {
break;
}
if _e2464 {
} else {
break;
}
if (select(0u, 1u, (_e2433 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2434 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2435 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2436 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2433 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2434 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2435 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2436 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2433 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2434 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2435 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2436 < 0f)) < 2u) {
} else {
break;
}
}
let _e2613 = select(1f, -1f, (_e2413 < 0f));
let _e2619 = select(0f, (2f * _e2421), (bitcast<f32>((bitcast<u32>(_e2413) & 2147483647u)) <= _e2421));
let _e2623 = (0f - 0f);
let _e2624 = ((_e2335 - _e2361) * _e2613);
let _e2625 = ((_e2361 - _e2383) * _e2613);
let _e2626 = ((_e2383 - _e2335) * _e2613);
let _e2627 = (_e2623 * _e2613);
let _e2628 = (_e2324 - _e2376);
let _e2629 = (_e2399 * _e2613);
let _e2630 = (_e2402 * _e2613);
let _e2631 = (_e2628 * _e2613);
let _e2632 = (_e2624 * _e2423);
let _e2633 = (_e2625 * _e2423);
let _e2634 = (_e2626 * _e2423);
let _e2640 = -((_e2624 * _e2398));
let _e2641 = -((_e2625 * _e2398));
let _e2642 = -((_e2626 * _e2398));
local_82 = array<u32, 2>(0u, 4294967295u);
let _e2648 = select(0u, 1u, (_e2632 > _e2640));
if (_e2648 < 2u) {
} else {
break;
}
let _e2651 = local_82[_e2648];
local_83 = array<u32, 2>(0u, 4294967295u);
let _e2652 = select(0u, 1u, (_e2633 > _e2641));
if (_e2652 < 2u) {
} else {
break;
}
let _e2655 = local_83[_e2652];
local_84 = array<u32, 2>(0u, 4294967295u);
let _e2656 = select(0u, 1u, (_e2634 > _e2642));
if (_e2656 < 2u) {
} else {
break;
}
let _e2659 = local_84[_e2656];
let _e2661 = (select(0u, 1u, ((_e2627 * _e2423) > -((_e2627 * _e2398)))) < 2u);
if _e2661 {
} else {
break;
}
let _e2677 = (_e2629 * _e2423);
let _e2678 = (_e2630 * _e2423);
let _e2679 = (_e2631 * _e2423);
let _e2683 = -((_e2629 * _e2398));
let _e2684 = -((_e2630 * _e2398));
let _e2685 = -((_e2631 * _e2398));
local_79 = array<u32, 2>(0u, 4294967295u);
let _e2689 = select(0u, 1u, (_e2677 > _e2683));
if (_e2689 < 2u) {
} else {
break;
}
let _e2692 = local_79[_e2689];
local_80 = array<u32, 2>(0u, 4294967295u);
let _e2693 = select(0u, 1u, (_e2678 > _e2684));
if (_e2693 < 2u) {
} else {
break;
}
let _e2696 = local_80[_e2693];
local_81 = array<u32, 2>(0u, 4294967295u);
let _e2697 = select(0u, 1u, (_e2679 > _e2685));
if (_e2697 < 2u) {
} else {
break;
}
let _e2700 = local_81[_e2697];
if _e2661 {
} else {
break;
}
local_76 = array<u32, 2>(0u, 4294967295u);
let _e2726 = select(0u, 1u, (_e2624 == 0f));
if (_e2726 < 2u) {
} else {
break;
}
let _e2729 = local_76[_e2726];
local_77 = array<u32, 2>(0u, 4294967295u);
let _e2730 = select(0u, 1u, (_e2625 == 0f));
if (_e2730 < 2u) {
} else {
break;
}
let _e2733 = local_77[_e2730];
local_78 = array<u32, 2>(0u, 4294967295u);
let _e2734 = select(0u, 1u, (_e2626 == 0f));
if (_e2734 < 2u) {
} else {
break;
}
let _e2737 = local_78[_e2734];
if (select(0u, 1u, (_e2627 == 0f)) < 2u) {
} else {
break;
}
let _e2741 = ((_e2729 & 1u) != 0u);
let _e2744 = ((_e2733 & 1u) != 0u);
let _e2747 = ((_e2737 & 1u) != 0u);
let _e2749 = (-1f / select(_e2624, 1f, _e2741));
let _e2750 = (-1f / select(_e2625, 1f, _e2744));
let _e2751 = (-1f / select(_e2626, 1f, _e2747));
local_73 = array<u32, 2>(0u, 4294967295u);
let _e2756 = select(0u, 1u, (_e2624 > 0f));
if (_e2756 < 2u) {
} else {
break;
}
let _e2759 = local_73[_e2756];
local_74 = array<u32, 2>(0u, 4294967295u);
let _e2760 = select(0u, 1u, (_e2625 > 0f));
if (_e2760 < 2u) {
} else {
break;
}
let _e2763 = local_74[_e2760];
local_75 = array<u32, 2>(0u, 4294967295u);
let _e2764 = select(0u, 1u, (_e2626 > 0f));
if (_e2764 < 2u) {
} else {
break;
}
let _e2767 = local_75[_e2764];
if (select(0u, 1u, (_e2627 > 0f)) < 2u) {
} else {
break;
}
local_70 = array<u32, 2>(0u, 4294967295u);
let _e2774 = select(0u, 1u, (_e2624 < 0f));
if (_e2774 < 2u) {
} else {
break;
}
let _e2777 = local_70[_e2774];
local_71 = array<u32, 2>(0u, 4294967295u);
let _e2778 = select(0u, 1u, (_e2625 < 0f));
if (_e2778 < 2u) {
} else {
break;
}
let _e2781 = local_71[_e2778];
local_72 = array<u32, 2>(0u, 4294967295u);
let _e2782 = select(0u, 1u, (_e2626 < 0f));
if (_e2782 < 2u) {
} else {
break;
}
let _e2785 = local_72[_e2782];
if (select(0u, 1u, (_e2627 < 0f)) < 2u) {
} else {
break;
}
let _e2801 = ((_e2777 & 1u) != 0u);
let _e2804 = ((_e2781 & 1u) != 0u);
let _e2807 = ((_e2785 & 1u) != 0u);
let _e2813 = select(1f, -1f, (-(((_e2401 * _e2402) - (_e2399 * _e2404))) < 0f));
let _e2817 = ((_e2346 - _e2368) * _e2813);
let _e2818 = ((_e2368 - _e2390) * _e2813);
let _e2819 = ((_e2390 - _e2346) * _e2813);
let _e2820 = (_e2623 * _e2813);
let _e2821 = (_e2399 * _e2813);
let _e2822 = (_e2402 * _e2813);
let _e2823 = (_e2628 * _e2813);
if (select(0u, 1u, ((_e2817 * _e2423) > -((_e2817 * _e2398)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e2818 * _e2423) > -((_e2818 * _e2398)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e2819 * _e2423) > -((_e2819 * _e2398)))) < 2u) {
} else {
break;
}
let _e2847 = (select(0u, 1u, ((_e2820 * _e2423) > -((_e2820 * _e2398)))) < 2u);
if _e2847 {
} else {
break;
}
if (select(0u, 1u, ((_e2821 * _e2423) > -((_e2821 * _e2398)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e2822 * _e2423) > -((_e2822 * _e2398)))) < 2u) {
} else {
break;
}
if (select(0u, 1u, ((_e2823 * _e2423) > -((_e2823 * _e2398)))) < 2u) {
} else {
break;
}
if _e2847 {
} else {
break;
}
if (select(0u, 1u, (_e2817 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2818 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2819 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2820 == 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2817 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2818 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2819 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2820 > 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2817 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2818 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2819 < 0f)) < 2u) {
} else {
break;
}
if (select(0u, 1u, (_e2820 < 0f)) < 2u) {
} else {
break;
}
phi_17531_ = _e904.member.member_1;
loop {
let _e2903 = phi_17531_;
let _e2904 = (_e2903 < _e904.member.member_2);
if _e2904 {
if _e2426 {
phi_17546_ = _e904.member_1.member_4.y;
} else {
phi_17546_ = _e904.member_1.member_4.z;
}
let _e2908 = phi_17546_;
phi_17548_ = 0i;
loop {
let _e2910 = phi_17548_;
let _e2911 = (_e2910 <= _e2908);
if _e2911 {
let _e2913 = select(_e2903, _e2910, _e2426);
let _e2914 = f32(_e2913);
let _e2916 = f32(_e904.member_1.member_4.x);
let _e2920 = ((_e2629 * _e2914) + (((select(_e2640, _e2632, ((_e2651 & 1u) != 0u)) - (_e2624 * _e2324)) + (select(_e2683, _e2677, ((_e2692 & 1u) != 0u)) - (_e2629 * _e2335))) + _e2619));
let _e2921 = ((_e2630 * _e2914) + (((select(_e2641, _e2633, ((_e2655 & 1u) != 0u)) - (_e2625 * _e2354)) + (select(_e2684, _e2678, ((_e2696 & 1u) != 0u)) - (_e2630 * _e2361))) + _e2619));
let _e2922 = ((_e2631 * _e2914) + (((select(_e2642, _e2634, ((_e2659 & 1u) != 0u)) - (_e2626 * _e2376)) + (select(_e2685, _e2679, ((_e2700 & 1u) != 0u)) - (_e2631 * _e2383))) + _e2619));
let _e2923 = (_e2920 * select(0f, _e2749, ((_e2759 & 1u) != 0u)));
let _e2924 = (_e2921 * select(0f, _e2750, ((_e2763 & 1u) != 0u)));
let _e2925 = (_e2922 * select(0f, _e2751, ((_e2767 & 1u) != 0u)));
let _e2929 = ((_e2920 * select(select(0f, 1e20f, _e2741), _e2749, _e2801)) + select(_e2422, 0f, _e2801));
let _e2930 = ((_e2921 * select(select(0f, 1e20f, _e2744), _e2750, _e2804)) + select(_e2422, 0f, _e2804));
let _e2931 = ((_e2922 * select(select(0f, 1e20f, _e2747), _e2751, _e2807)) + select(_e2422, 0f, _e2807));
let _e2933 = select(_e2923, 0f, (0f > _e2923));
let _e2935 = select(_e2925, _e2924, (_e2924 > _e2925));
let _e2939 = select(_e2929, _e2916, (_e2916 < _e2929));
let _e2941 = select(_e2931, _e2930, (_e2930 < _e2931));
let _e2943 = select(_e2941, _e2939, (_e2939 < _e2941));
let _e2944 = -(select(_e2935, _e2933, (_e2933 > _e2935)));
let _e2946 = (-(_e2916) - 1f);
let _e2948 = select(_e2946, _e2944, (_e2944 > _e2946));
let _e2950 = select(0f, _e2948, (_e2948 < 0f));
let _e2957 = select(0i, select(select(i32(_e2950), i32(-2147483648), (_e2950 < -2147483600f)), 2147483647i, (_e2950 > 2147483500f)), (_e2950 == _e2950));
let _e2962 = -((_e2957 - select(0i, 1i, (_e2950 < f32(_e2957)))));
let _e2964 = select(-1f, _e2943, (_e2943 > -1f));
let _e2966 = select(_e2916, _e2964, (_e2964 < _e2916));
let _e2973 = select(0i, select(select(i32(_e2966), i32(-2147483648), (_e2966 < -2147483600f)), 2147483647i, (_e2966 > 2147483500f)), (_e2966 == _e2966));
let _e2977 = (_e2973 - select(0i, 1i, (_e2966 < f32(_e2973))));
if (_e2962 <= _e2977) {
let _e2983 = global_2.member.member_2.member_1;
let _e2990 = global_2.member.member_3;
let _e2993 = (_e904.member_1.member_3.x + _e2962);
let _e2994 = (_e904.member_1.member_3.x + _e2977);
let _e2996 = (_e2993 >> bitcast<u32>(5i));
phi_17684_ = _e2996;
loop {
let _e2998 = phi_17684_;
let _e3000 = (_e2994 >> bitcast<u32>(5i));
let _e3001 = (_e2998 <= _e3000);
if _e3001 {
if (_e2998 == _e2996) {
phi_17703_ = (4294967295u << bitcast<u32>((bitcast<u32>((_e2993 & 31i)) & 31u)));
} else {
phi_17703_ = 4294967295u;
}
let _e3009 = phi_17703_;
if (_e2998 == _e3000) {
phi_17714_ = (4294967295u >> bitcast<u32>((bitcast<u32>((31i - (_e2994 & 31i))) & 31u)));
} else {
phi_17714_ = 4294967295u;
}
let _e3018 = phi_17714_;
let _e3020 = bitcast<u32>(((((((_e904.member_1.member_3.z + select(_e2910, _e2903, _e2426)) * bitcast<i32>(_e2983)) + _e904.member_1.member_3.y) + _e2913) * bitcast<i32>(_e2990)) + _e2998));
if (_e3020 < _e198) {
let _e3025 = atomicOr((&global_1.member[_e3020]), (_e3009 & _e3018));
}
phi_17685_ = (_e2998 + 1i);
} else {
phi_17685_ = i32();
}
let _e3028 = phi_17685_;
continue;
continuing {
phi_17684_ = _e3028;
break if !(_e3001);
}
}
}
phi_17549_ = (_e2910 + 1i);
} else {
phi_17549_ = i32();
}
let _e3032 = phi_17549_;
continue;
continuing {
phi_17548_ = _e3032;
break if !(_e2911);
}
}
phi_17532_ = (_e2903 + 1i);
} else {
phi_17532_ = i32();
}
let _e3036 = phi_17532_;
continue;
continuing {
phi_17531_ = _e3036;
break if !(_e2904);
}
}
} else {
let _e940 = (_e904.member_1.member_6 & 31u);
let _e942 = (_e904.member_1.member_3.x << bitcast<u32>(_e940));
let _e945 = (_e904.member_1.member_7 & 31u);
let _e949 = ((1i << bitcast<u32>(_e945)) >> bitcast<u32>(1i));
let _e955 = bitcast<i32>(_e904.member_1.member_6);
let _e961 = bitcast<f32>((bitcast<u32>((127i + (bitcast<i32>(_e904.member_1.member_7) - _e955))) << bitcast<u32>(23i)));
let _e962 = (f32((((_e904.member_1.member.x - _e942) + _e949) >> bitcast<u32>(_e945))) * _e961);
let _e967 = (_e904.member_1.member_3.y << bitcast<u32>(_e940));
let _e973 = (f32((((_e904.member_1.member.y - _e967) + _e949) >> bitcast<u32>(_e945))) * _e961);
let _e978 = (_e904.member_1.member_3.z << bitcast<u32>(_e940));
let _e984 = (f32((((_e904.member_1.member.z - _e978) + _e949) >> bitcast<u32>(_e945))) * _e961);
let _e992 = (f32((((_e904.member_1.member_1.x - _e942) + _e949) >> bitcast<u32>(_e945))) * _e961);
let _e999 = (f32((((_e904.member_1.member_1.y - _e967) + _e949) >> bitcast<u32>(_e945))) * _e961);
let _e1006 = (f32((((_e904.member_1.member_1.z - _e978) + _e949) >> bitcast<u32>(_e945))) * _e961);
let _e1014 = (f32((((_e904.member_1.member_2.x - _e942) + _e949) >> bitcast<u32>(_e945))) * _e961);
let _e1021 = (f32((((_e904.member_1.member_2.y - _e967) + _e949) >> bitcast<u32>(_e945))) * _e961);
let _e1028 = (f32((((_e904.member_1.member_2.z - _e978) + _e949) >> bitcast<u32>(_e945))) * _e961);
let _e1036 = (f32(_e904.member_1.member_5) * bitcast<f32>((bitcast<u32>((127i - _e955)) << bitcast<u32>(23i))));
let _e1037 = (_e992 - _e962);
let _e1038 = (_e999 - _e973);
let _e1039 = (_e1006 - _e984);
let _e1040 = (_e1014 - _e992);
let _e1041 = (_e1021 - _e999);
let _e1042 = (_e1028 - _e1006);
let _e1043 = (_e1038 * _e1042);
let _e1044 = (_e1039 * _e1041);
let _e1045 = (_e1043 - _e1044);
let _e1046 = (_e1039 * _e1040);
let _e1047 = (_e1037 * _e1042);
let _e1048 = (_e1046 - _e1047);
let _e1049 = (_e1037 * _e1041);
let _e1050 = (_e1038 * _e1040);
let _e1051 = (_e1049 - _e1050);
let _e1059 = ((bitcast<f32>((bitcast<u32>(_e1043) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1044) & 2147483647u))) * 2.3841858e-7f);
let _e1067 = ((bitcast<f32>((bitcast<u32>(_e1046) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1047) & 2147483647u))) * 2.3841858e-7f);
let _e1075 = ((bitcast<f32>((bitcast<u32>(_e1049) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1050) & 2147483647u))) * 2.3841858e-7f);
let _e1076 = f32(_e904.member_1.member_4.x);
let _e1077 = f32(_e904.member_1.member_4.y);
let _e1078 = f32(_e904.member_1.member_4.z);
let _e1080 = select(_e1077, _e1076, (_e1076 > _e1077));
let _e1086 = (((_e1059 + _e1067) + _e1075) * (select(_e1078, _e1080, (_e1080 > _e1078)) + 2f));
let _e1091 = (((_e1045 * _e962) + (_e1048 * _e973)) + (_e1051 * _e984));
let _e1092 = (1f + _e1036);
let _e1093 = (_e1045 * _e1092);
let _e1095 = -((_e1045 * _e1036));
let _e1098 = (_e1048 * _e1092);
let _e1100 = -((_e1048 * _e1036));
let _e1104 = (_e1051 * _e1092);
let _e1106 = -((_e1051 * _e1036));
let _e1110 = -(_e1045);
let _e1111 = (_e1110 * _e1092);
let _e1113 = -((_e1110 * _e1036));
let _e1116 = -(_e1048);
let _e1117 = (_e1116 * _e1092);
let _e1119 = -((_e1116 * _e1036));
let _e1123 = -(_e1051);
let _e1124 = (_e1123 * _e1092);
let _e1126 = -((_e1123 * _e1036));
let _e1130 = (_e904.member_1.member_4.z >= _e904.member_1.member_4.y);
if _e1130 {
let _e1371 = select(1f, -1f, (_e1045 < 0f));
let _e1377 = select(0f, (2f * _e1059), (bitcast<f32>((bitcast<u32>(_e1045) & 2147483647u)) <= _e1059));
let _e1382 = ((_e984 - _e1006) * _e1371);
let _e1383 = ((_e1006 - _e1028) * _e1371);
let _e1384 = ((_e1028 - _e984) * _e1371);
let _e1385 = ((0f - 0f) * _e1371);
let _e1387 = (_e1038 * _e1371);
let _e1388 = (_e1041 * _e1371);
let _e1389 = ((_e973 - _e1021) * _e1371);
let _e1391 = (_e1382 * _e1092);
let _e1392 = (_e1383 * _e1092);
let _e1393 = (_e1384 * _e1092);
let _e1394 = (_e1385 * _e1092);
let _e1399 = -((_e1382 * _e1036));
let _e1400 = -((_e1383 * _e1036));
let _e1401 = -((_e1384 * _e1036));
let _e1402 = -((_e1385 * _e1036));
local_66 = array<u32, 2>(0u, 4294967295u);
let _e1407 = select(0u, 1u, (_e1391 > _e1399));
if (_e1407 < 2u) {
} else {
break;
}
let _e1410 = local_66[_e1407];
local_67 = array<u32, 2>(0u, 4294967295u);
let _e1411 = select(0u, 1u, (_e1392 > _e1400));
if (_e1411 < 2u) {
} else {
break;
}
let _e1414 = local_67[_e1411];
local_68 = array<u32, 2>(0u, 4294967295u);
let _e1415 = select(0u, 1u, (_e1393 > _e1401));
if (_e1415 < 2u) {
} else {
break;
}
let _e1418 = local_68[_e1415];
local_69 = array<u32, 2>(0u, 4294967295u);
let _e1419 = select(0u, 1u, (_e1394 > _e1402));
let _e1420 = (_e1419 < 2u);
if _e1420 {
} else {
break;
}
let _e1422 = local_69[_e1419];
let _e1438 = (_e1385 * 0f);
let _e1443 = (_e1387 * _e1092);
let _e1444 = (_e1388 * _e1092);
let _e1445 = (_e1389 * _e1092);
let _e1449 = -((_e1387 * _e1036));
let _e1450 = -((_e1388 * _e1036));
let _e1451 = -((_e1389 * _e1036));
local_62 = array<u32, 2>(0u, 4294967295u);
let _e1455 = select(0u, 1u, (_e1443 > _e1449));
if (_e1455 < 2u) {
} else {
break;
}
let _e1458 = local_62[_e1455];
local_63 = array<u32, 2>(0u, 4294967295u);
let _e1459 = select(0u, 1u, (_e1444 > _e1450));
if (_e1459 < 2u) {
} else {
break;
}
let _e1462 = local_63[_e1459];
local_64 = array<u32, 2>(0u, 4294967295u);
let _e1463 = select(0u, 1u, (_e1445 > _e1451));
if (_e1463 < 2u) {
} else {
break;
}
let _e1466 = local_64[_e1463];
local_65 = array<u32, 2>(0u, 4294967295u);
if _e1420 {
} else {
break;
}
let _e1468 = local_65[_e1419];
local_58 = array<u32, 2>(0u, 4294967295u);
let _e1501 = select(0u, 1u, (_e1382 == 0f));
if (_e1501 < 2u) {
} else {
break;
}
let _e1504 = local_58[_e1501];
local_59 = array<u32, 2>(0u, 4294967295u);
let _e1505 = select(0u, 1u, (_e1383 == 0f));
if (_e1505 < 2u) {
} else {
break;
}
let _e1508 = local_59[_e1505];
local_60 = array<u32, 2>(0u, 4294967295u);
let _e1509 = select(0u, 1u, (_e1384 == 0f));
if (_e1509 < 2u) {
} else {
break;
}
let _e1512 = local_60[_e1509];
local_61 = array<u32, 2>(0u, 4294967295u);
let _e1513 = select(0u, 1u, (_e1385 == 0f));
if (_e1513 < 2u) {
} else {
break;
}
let _e1516 = local_61[_e1513];
let _e1518 = ((_e1504 & 1u) != 0u);
let _e1521 = ((_e1508 & 1u) != 0u);
let _e1524 = ((_e1512 & 1u) != 0u);
let _e1527 = ((_e1516 & 1u) != 0u);
let _e1529 = (-1f / select(_e1382, 1f, _e1518));
let _e1530 = (-1f / select(_e1383, 1f, _e1521));
let _e1531 = (-1f / select(_e1384, 1f, _e1524));
let _e1532 = (-1f / select(_e1385, 1f, _e1527));
local_54 = array<u32, 2>(0u, 4294967295u);
let _e1537 = select(0u, 1u, (_e1382 > 0f));
if (_e1537 < 2u) {
} else {
break;
}
let _e1540 = local_54[_e1537];
local_55 = array<u32, 2>(0u, 4294967295u);
let _e1541 = select(0u, 1u, (_e1383 > 0f));
if (_e1541 < 2u) {
} else {
break;
}
let _e1544 = local_55[_e1541];
local_56 = array<u32, 2>(0u, 4294967295u);
let _e1545 = select(0u, 1u, (_e1384 > 0f));
if (_e1545 < 2u) {
} else {
break;
}
let _e1548 = local_56[_e1545];
local_57 = array<u32, 2>(0u, 4294967295u);
let _e1549 = select(0u, 1u, (_e1385 > 0f));
if (_e1549 < 2u) {
} else {
break;
}
let _e1552 = local_57[_e1549];
local_50 = array<u32, 2>(0u, 4294967295u);
let _e1557 = select(0u, 1u, (_e1382 < 0f));
if (_e1557 < 2u) {
} else {
break;
}
let _e1560 = local_50[_e1557];
local_51 = array<u32, 2>(0u, 4294967295u);
let _e1561 = select(0u, 1u, (_e1383 < 0f));
if (_e1561 < 2u) {
} else {
break;
}
let _e1564 = local_51[_e1561];
local_52 = array<u32, 2>(0u, 4294967295u);
let _e1565 = select(0u, 1u, (_e1384 < 0f));
if (_e1565 < 2u) {
} else {
break;
}
let _e1568 = local_52[_e1565];
local_53 = array<u32, 2>(0u, 4294967295u);
let _e1569 = select(0u, 1u, (_e1385 < 0f));
if (_e1569 < 2u) {
} else {
break;
}
let _e1572 = local_53[_e1569];
let _e1591 = ((_e1560 & 1u) != 0u);
let _e1594 = ((_e1564 & 1u) != 0u);
let _e1597 = ((_e1568 & 1u) != 0u);
let _e1600 = ((_e1572 & 1u) != 0u);
phi_19764_ = type_16(vec4<f32>(_e1387, _e1388, _e1389, _e1385), vec4<f32>((((select(_e1399, _e1391, ((_e1410 & 1u) != 0u)) - (_e1382 * _e973)) + (select(_e1449, _e1443, ((_e1458 & 1u) != 0u)) - (_e1387 * _e984))) + _e1377), (((select(_e1400, _e1392, ((_e1414 & 1u) != 0u)) - (_e1383 * _e999)) + (select(_e1450, _e1444, ((_e1462 & 1u) != 0u)) - (_e1388 * _e1006))) + _e1377), (((select(_e1401, _e1393, ((_e1418 & 1u) != 0u)) - (_e1384 * _e1021)) + (select(_e1451, _e1445, ((_e1466 & 1u) != 0u)) - (_e1389 * _e1028))) + _e1377), (((select(_e1402, _e1394, ((_e1422 & 1u) != 0u)) - _e1438) + (select(_e1402, _e1394, ((_e1468 & 1u) != 0u)) - _e1438)) + _e1377)), vec4<f32>(select(0f, _e1529, ((_e1540 & 1u) != 0u)), select(0f, _e1530, ((_e1544 & 1u) != 0u)), select(0f, _e1531, ((_e1548 & 1u) != 0u)), select(0f, _e1532, ((_e1552 & 1u) != 0u))), vec4<f32>(select(select(0f, 1e20f, _e1518), _e1529, _e1591), select(select(0f, 1e20f, _e1521), _e1530, _e1594), select(select(0f, 1e20f, _e1524), _e1531, _e1597), select(select(0f, 1e20f, _e1527), _e1532, _e1600)), vec4<f32>(select(_e1077, 0f, _e1591), select(_e1077, 0f, _e1594), select(_e1077, 0f, _e1597), select(_e1077, 0f, _e1600)));
} else {
let _e1132 = select(1f, -1f, (_e1110 < 0f));
let _e1138 = select(0f, (2f * _e1059), (bitcast<f32>((bitcast<u32>(_e1110) & 2147483647u)) <= _e1059));
let _e1143 = ((_e973 - _e999) * _e1132);
let _e1144 = ((_e999 - _e1021) * _e1132);
let _e1145 = ((_e1021 - _e973) * _e1132);
let _e1146 = ((0f - 0f) * _e1132);
let _e1148 = (_e1039 * _e1132);
let _e1149 = (_e1042 * _e1132);
let _e1150 = ((_e984 - _e1028) * _e1132);
let _e1152 = (_e1143 * _e1092);
let _e1153 = (_e1144 * _e1092);
let _e1154 = (_e1145 * _e1092);
let _e1155 = (_e1146 * _e1092);
let _e1160 = -((_e1143 * _e1036));
let _e1161 = -((_e1144 * _e1036));
let _e1162 = -((_e1145 * _e1036));
let _e1163 = -((_e1146 * _e1036));
local_46 = array<u32, 2>(0u, 4294967295u);
let _e1168 = select(0u, 1u, (_e1152 > _e1160));
if (_e1168 < 2u) {
} else {
break;
}
let _e1171 = local_46[_e1168];
local_47 = array<u32, 2>(0u, 4294967295u);
let _e1172 = select(0u, 1u, (_e1153 > _e1161));
if (_e1172 < 2u) {
} else {
break;
}
let _e1175 = local_47[_e1172];
local_48 = array<u32, 2>(0u, 4294967295u);
let _e1176 = select(0u, 1u, (_e1154 > _e1162));
if (_e1176 < 2u) {
} else {
break;
}
let _e1179 = local_48[_e1176];
local_49 = array<u32, 2>(0u, 4294967295u);
let _e1180 = select(0u, 1u, (_e1155 > _e1163));
let _e1181 = (_e1180 < 2u);
if _e1181 {
} else {
break;
}
let _e1183 = local_49[_e1180];
let _e1199 = (_e1146 * 0f);
let _e1204 = (_e1148 * _e1092);
let _e1205 = (_e1149 * _e1092);
let _e1206 = (_e1150 * _e1092);
let _e1210 = -((_e1148 * _e1036));
let _e1211 = -((_e1149 * _e1036));
let _e1212 = -((_e1150 * _e1036));
local_42 = array<u32, 2>(0u, 4294967295u);
let _e1216 = select(0u, 1u, (_e1204 > _e1210));
if (_e1216 < 2u) {
} else {
break;
}
let _e1219 = local_42[_e1216];
local_43 = array<u32, 2>(0u, 4294967295u);
let _e1220 = select(0u, 1u, (_e1205 > _e1211));
if (_e1220 < 2u) {
} else {
break;
}
let _e1223 = local_43[_e1220];
local_44 = array<u32, 2>(0u, 4294967295u);
let _e1224 = select(0u, 1u, (_e1206 > _e1212));
if (_e1224 < 2u) {
} else {
break;
}
let _e1227 = local_44[_e1224];
local_45 = array<u32, 2>(0u, 4294967295u);
if _e1181 {
} else {
break;
}
let _e1229 = local_45[_e1180];
local_38 = array<u32, 2>(0u, 4294967295u);
let _e1262 = select(0u, 1u, (_e1143 == 0f));
if (_e1262 < 2u) {
} else {
break;
}
let _e1265 = local_38[_e1262];
local_39 = array<u32, 2>(0u, 4294967295u);
let _e1266 = select(0u, 1u, (_e1144 == 0f));
if (_e1266 < 2u) {
} else {
break;
}
let _e1269 = local_39[_e1266];
local_40 = array<u32, 2>(0u, 4294967295u);
let _e1270 = select(0u, 1u, (_e1145 == 0f));
if (_e1270 < 2u) {
} else {
break;
}
let _e1273 = local_40[_e1270];
local_41 = array<u32, 2>(0u, 4294967295u);
let _e1274 = select(0u, 1u, (_e1146 == 0f));
if (_e1274 < 2u) {
} else {
break;
}
let _e1277 = local_41[_e1274];
let _e1279 = ((_e1265 & 1u) != 0u);
let _e1282 = ((_e1269 & 1u) != 0u);
let _e1285 = ((_e1273 & 1u) != 0u);
let _e1288 = ((_e1277 & 1u) != 0u);
let _e1290 = (-1f / select(_e1143, 1f, _e1279));
let _e1291 = (-1f / select(_e1144, 1f, _e1282));
let _e1292 = (-1f / select(_e1145, 1f, _e1285));
let _e1293 = (-1f / select(_e1146, 1f, _e1288));
local_34 = array<u32, 2>(0u, 4294967295u);
let _e1298 = select(0u, 1u, (_e1143 > 0f));
if (_e1298 < 2u) {
} else {
break;
}
let _e1301 = local_34[_e1298];
local_35 = array<u32, 2>(0u, 4294967295u);
let _e1302 = select(0u, 1u, (_e1144 > 0f));
if (_e1302 < 2u) {
} else {
break;
}
let _e1305 = local_35[_e1302];
local_36 = array<u32, 2>(0u, 4294967295u);
let _e1306 = select(0u, 1u, (_e1145 > 0f));
if (_e1306 < 2u) {
} else {
break;
}
let _e1309 = local_36[_e1306];
local_37 = array<u32, 2>(0u, 4294967295u);
let _e1310 = select(0u, 1u, (_e1146 > 0f));
if (_e1310 < 2u) {
} else {
break;
}
let _e1313 = local_37[_e1310];
local_30 = array<u32, 2>(0u, 4294967295u);
let _e1318 = select(0u, 1u, (_e1143 < 0f));
if (_e1318 < 2u) {
} else {
break;
}
let _e1321 = local_30[_e1318];
local_31 = array<u32, 2>(0u, 4294967295u);
let _e1322 = select(0u, 1u, (_e1144 < 0f));
if (_e1322 < 2u) {
} else {
break;
}
let _e1325 = local_31[_e1322];
local_32 = array<u32, 2>(0u, 4294967295u);
let _e1326 = select(0u, 1u, (_e1145 < 0f));
if (_e1326 < 2u) {
} else {
break;
}
let _e1329 = local_32[_e1326];
local_33 = array<u32, 2>(0u, 4294967295u);
let _e1330 = select(0u, 1u, (_e1146 < 0f));
if (_e1330 < 2u) {
} else {
break;
}
let _e1333 = local_33[_e1330];
let _e1352 = ((_e1321 & 1u) != 0u);
let _e1355 = ((_e1325 & 1u) != 0u);
let _e1358 = ((_e1329 & 1u) != 0u);
let _e1361 = ((_e1333 & 1u) != 0u);
phi_19764_ = type_16(vec4<f32>(_e1148, _e1149, _e1150, _e1146), vec4<f32>((((select(_e1160, _e1152, ((_e1171 & 1u) != 0u)) - (_e1143 * _e984)) + (select(_e1210, _e1204, ((_e1219 & 1u) != 0u)) - (_e1148 * _e973))) + _e1138), (((select(_e1161, _e1153, ((_e1175 & 1u) != 0u)) - (_e1144 * _e1006)) + (select(_e1211, _e1205, ((_e1223 & 1u) != 0u)) - (_e1149 * _e999))) + _e1138), (((select(_e1162, _e1154, ((_e1179 & 1u) != 0u)) - (_e1145 * _e1028)) + (select(_e1212, _e1206, ((_e1227 & 1u) != 0u)) - (_e1150 * _e1021))) + _e1138), (((select(_e1163, _e1155, ((_e1183 & 1u) != 0u)) - _e1199) + (select(_e1163, _e1155, ((_e1229 & 1u) != 0u)) - _e1199)) + _e1138)), vec4<f32>(select(0f, _e1290, ((_e1301 & 1u) != 0u)), select(0f, _e1291, ((_e1305 & 1u) != 0u)), select(0f, _e1292, ((_e1309 & 1u) != 0u)), select(0f, _e1293, ((_e1313 & 1u) != 0u))), vec4<f32>(select(select(0f, 1e20f, _e1279), _e1290, _e1352), select(select(0f, 1e20f, _e1282), _e1291, _e1355), select(select(0f, 1e20f, _e1285), _e1292, _e1358), select(select(0f, 1e20f, _e1288), _e1293, _e1361)), vec4<f32>(select(_e1078, 0f, _e1352), select(_e1078, 0f, _e1355), select(_e1078, 0f, _e1358), select(_e1078, 0f, _e1361)));
}
let _e1610 = phi_19764_;
let _e1612 = (_e1045 == 0f);
let _e1614 = (1f / select(_e1045, 1f, _e1612));
let _e1620 = select(1f, -1f, (_e1051 < 0f));
let _e1626 = select(0f, (2f * _e1075), (bitcast<f32>((bitcast<u32>(_e1051) & 2147483647u)) <= _e1075));
let _e1630 = (0f - 0f);
let _e1631 = ((_e973 - _e999) * _e1620);
let _e1632 = ((_e999 - _e1021) * _e1620);
let _e1633 = ((_e1021 - _e973) * _e1620);
let _e1634 = (_e1630 * _e1620);
let _e1635 = (_e962 - _e1014);
let _e1636 = (_e1037 * _e1620);
let _e1637 = (_e1040 * _e1620);
let _e1638 = (_e1635 * _e1620);
let _e1639 = (_e1631 * _e1092);
let _e1640 = (_e1632 * _e1092);
let _e1641 = (_e1633 * _e1092);
let _e1647 = -((_e1631 * _e1036));
let _e1648 = -((_e1632 * _e1036));
let _e1649 = -((_e1633 * _e1036));
local_27 = array<u32, 2>(0u, 4294967295u);
let _e1655 = select(0u, 1u, (_e1639 > _e1647));
if (_e1655 < 2u) {
} else {
break;
}
let _e1658 = local_27[_e1655];
local_28 = array<u32, 2>(0u, 4294967295u);
let _e1659 = select(0u, 1u, (_e1640 > _e1648));
if (_e1659 < 2u) {
} else {
break;
}
let _e1662 = local_28[_e1659];
local_29 = array<u32, 2>(0u, 4294967295u);
let _e1663 = select(0u, 1u, (_e1641 > _e1649));
if (_e1663 < 2u) {
} else {
break;
}
let _e1666 = local_29[_e1663];
let _e1668 = (select(0u, 1u, ((_e1634 * _e1092) > -((_e1634 * _e1036)))) < 2u);
if _e1668 {
} else {
break;
}
let _e1684 = (_e1636 * _e1092);
let _e1685 = (_e1637 * _e1092);
let _e1686 = (_e1638 * _e1092);
let _e1690 = -((_e1636 * _e1036));
let _e1691 = -((_e1637 * _e1036));
let _e1692 = -((_e1638 * _e1036));
local_24 = array<u32, 2>(0u, 4294967295u);
let _e1696 = select(0u, 1u, (_e1684 > _e1690));
if (_e1696 < 2u) {
} else {
break;
}
let _e1699 = local_24[_e1696];
local_25 = array<u32, 2>(0u, 4294967295u);
let _e1700 = select(0u, 1u, (_e1685 > _e1691));
if (_e1700 < 2u) {
} else {
break;
}
let _e1703 = local_25[_e1700];
local_26 = array<u32, 2>(0u, 4294967295u);
let _e1704 = select(0u, 1u, (_e1686 > _e1692));
if (_e1704 < 2u) {
} else {
break;
}
let _e1707 = local_26[_e1704];
if _e1668 {
} else {
break;
}
local_21 = array<u32, 2>(0u, 4294967295u);
let _e1733 = select(0u, 1u, (_e1631 == 0f));
if (_e1733 < 2u) {
} else {
break;
}
let _e1736 = local_21[_e1733];
local_22 = array<u32, 2>(0u, 4294967295u);
let _e1737 = select(0u, 1u, (_e1632 == 0f));
if (_e1737 < 2u) {
} else {
break;
}
let _e1740 = local_22[_e1737];
local_23 = array<u32, 2>(0u, 4294967295u);
let _e1741 = select(0u, 1u, (_e1633 == 0f));
if (_e1741 < 2u) {
} else {
break;
}
let _e1744 = local_23[_e1741];
if (select(0u, 1u, (_e1634 == 0f)) < 2u) {
} else {
break;
}
let _e1748 = ((_e1736 & 1u) != 0u);
let _e1751 = ((_e1740 & 1u) != 0u);
let _e1754 = ((_e1744 & 1u) != 0u);
let _e1756 = (-1f / select(_e1631, 1f, _e1748));
let _e1757 = (-1f / select(_e1632, 1f, _e1751));
let _e1758 = (-1f / select(_e1633, 1f, _e1754));
local_18 = array<u32, 2>(0u, 4294967295u);
let _e1763 = select(0u, 1u, (_e1631 > 0f));
if (_e1763 < 2u) {
} else {
break;
}
let _e1766 = local_18[_e1763];
local_19 = array<u32, 2>(0u, 4294967295u);
let _e1767 = select(0u, 1u, (_e1632 > 0f));
if (_e1767 < 2u) {
} else {
break;
}
let _e1770 = local_19[_e1767];
local_20 = array<u32, 2>(0u, 4294967295u);
let _e1771 = select(0u, 1u, (_e1633 > 0f));
if (_e1771 < 2u) {
} else {
break;
}
let _e1774 = local_20[_e1771];
if (select(0u, 1u, (_e1634 > 0f)) < 2u) {
} else {
break;
}
local_15 = array<u32, 2>(0u, 4294967295u);
let _e1781 = select(0u, 1u, (_e1631 < 0f));
if (_e1781 < 2u) {
} else {
break;
}
let _e1784 = local_15[_e1781];
local_16 = array<u32, 2>(0u, 4294967295u);
let _e1785 = select(0u, 1u, (_e1632 < 0f));
if (_e1785 < 2u) {
} else {
break;
}
let _e1788 = local_16[_e1785];
local_17 = array<u32, 2>(0u, 4294967295u);
let _e1789 = select(0u, 1u, (_e1633 < 0f));
if (_e1789 < 2u) {
} else {
break;
}
let _e1792 = local_17[_e1789];
if (select(0u, 1u, (_e1634 < 0f)) < 2u) {
} else {
break;
}
let _e1808 = ((_e1784 & 1u) != 0u);
let _e1811 = ((_e1788 & 1u) != 0u);
let _e1814 = ((_e1792 & 1u) != 0u);
let _e1820 = select(1f, -1f, (_e1116 < 0f));
let _e1826 = select(0f, (2f * _e1067), (bitcast<f32>((bitcast<u32>(_e1116) & 2147483647u)) <= _e1067));
let _e1830 = ((_e984 - _e1006) * _e1820);
let _e1831 = ((_e1006 - _e1028) * _e1820);
let _e1832 = ((_e1028 - _e984) * _e1820);
let _e1833 = (_e1630 * _e1820);
let _e1834 = (_e1037 * _e1820);
let _e1835 = (_e1040 * _e1820);
let _e1836 = (_e1635 * _e1820);
let _e1837 = (_e1830 * _e1092);
let _e1838 = (_e1831 * _e1092);
let _e1839 = (_e1832 * _e1092);
let _e1845 = -((_e1830 * _e1036));
let _e1846 = -((_e1831 * _e1036));
let _e1847 = -((_e1832 * _e1036));
local_12 = array<u32, 2>(0u, 4294967295u);
let _e1853 = select(0u, 1u, (_e1837 > _e1845));
if (_e1853 < 2u) {
} else {
break;
}
let _e1856 = local_12[_e1853];
local_13 = array<u32, 2>(0u, 4294967295u);
let _e1857 = select(0u, 1u, (_e1838 > _e1846));
if (_e1857 < 2u) {
} else {
break;
}
let _e1860 = local_13[_e1857];
local_14 = array<u32, 2>(0u, 4294967295u);
let _e1861 = select(0u, 1u, (_e1839 > _e1847));
if (_e1861 < 2u) {
} else {
break;
}
let _e1864 = local_14[_e1861];
let _e1866 = (select(0u, 1u, ((_e1833 * _e1092) > -((_e1833 * _e1036)))) < 2u);
if _e1866 {
} else {
break;
}
let _e1882 = (_e1834 * _e1092);
let _e1883 = (_e1835 * _e1092);
let _e1884 = (_e1836 * _e1092);
let _e1888 = -((_e1834 * _e1036));
let _e1889 = -((_e1835 * _e1036));
let _e1890 = -((_e1836 * _e1036));
local_9 = array<u32, 2>(0u, 4294967295u);
let _e1894 = select(0u, 1u, (_e1882 > _e1888));
if (_e1894 < 2u) {
} else {
break;
}
let _e1897 = local_9[_e1894];
local_10 = array<u32, 2>(0u, 4294967295u);
let _e1898 = select(0u, 1u, (_e1883 > _e1889));
if (_e1898 < 2u) {
} else {
break;
}
let _e1901 = local_10[_e1898];
local_11 = array<u32, 2>(0u, 4294967295u);
let _e1902 = select(0u, 1u, (_e1884 > _e1890));
if (_e1902 < 2u) {
} else {
break;
}
let _e1905 = local_11[_e1902];
if _e1866 {
} else {
break;
}
local_6 = array<u32, 2>(0u, 4294967295u);
let _e1931 = select(0u, 1u, (_e1830 == 0f));
if (_e1931 < 2u) {
} else {
break;
}
let _e1934 = local_6[_e1931];
local_7 = array<u32, 2>(0u, 4294967295u);
let _e1935 = select(0u, 1u, (_e1831 == 0f));
if (_e1935 < 2u) {
} else {
break;
}
let _e1938 = local_7[_e1935];
local_8 = array<u32, 2>(0u, 4294967295u);
let _e1939 = select(0u, 1u, (_e1832 == 0f));
if (_e1939 < 2u) {
} else {
break;
}
let _e1942 = local_8[_e1939];
if (select(0u, 1u, (_e1833 == 0f)) < 2u) {
} else {
break;
}
let _e1946 = ((_e1934 & 1u) != 0u);
let _e1949 = ((_e1938 & 1u) != 0u);
let _e1952 = ((_e1942 & 1u) != 0u);
let _e1954 = (-1f / select(_e1830, 1f, _e1946));
let _e1955 = (-1f / select(_e1831, 1f, _e1949));
let _e1956 = (-1f / select(_e1832, 1f, _e1952));
local_3 = array<u32, 2>(0u, 4294967295u);
let _e1961 = select(0u, 1u, (_e1830 > 0f));
if (_e1961 < 2u) {
} else {
break;
}
let _e1964 = local_3[_e1961];
local_4 = array<u32, 2>(0u, 4294967295u);
let _e1965 = select(0u, 1u, (_e1831 > 0f));
if (_e1965 < 2u) {
} else {
break;
}
let _e1968 = local_4[_e1965];
local_5 = array<u32, 2>(0u, 4294967295u);
let _e1969 = select(0u, 1u, (_e1832 > 0f));
if (_e1969 < 2u) {
} else {
break;
}
let _e1972 = local_5[_e1969];
if (select(0u, 1u, (_e1833 > 0f)) < 2u) {
} else {
break;
}
local = array<u32, 2>(0u, 4294967295u);
let _e1979 = select(0u, 1u, (_e1830 < 0f));
if (_e1979 < 2u) {
} else {
break;
}
let _e1982 = local[_e1979];
local_1 = array<u32, 2>(0u, 4294967295u);
let _e1983 = select(0u, 1u, (_e1831 < 0f));
if (_e1983 < 2u) {
} else {
break;
}
let _e1986 = local_1[_e1983];
local_2 = array<u32, 2>(0u, 4294967295u);
let _e1987 = select(0u, 1u, (_e1832 < 0f));
if (_e1987 < 2u) {
} else {
break;
}
let _e1990 = local_2[_e1987];
if (select(0u, 1u, (_e1833 < 0f)) < 2u) {
} else {
break;
}
let _e2006 = ((_e1982 & 1u) != 0u);
let _e2009 = ((_e1986 & 1u) != 0u);
let _e2012 = ((_e1990 & 1u) != 0u);
phi_21443_ = _e904.member.member_1;
loop {
let _e2018 = phi_21443_;
let _e2019 = (_e2018 < _e904.member.member_2);
if _e2019 {
if _e1130 {
phi_21458_ = _e904.member_1.member_4.y;
} else {
phi_21458_ = _e904.member_1.member_4.z;
}
let _e2023 = phi_21458_;
let _e2024 = f32(_e2023);
let _e2025 = f32(_e2018);
let _e2035 = ((_e1610.member.x * _e2025) + _e1610.member_1.x);
let _e2037 = ((_e1610.member.y * _e2025) + _e1610.member_1.y);
let _e2039 = ((_e1610.member.z * _e2025) + _e1610.member_1.z);
let _e2042 = (_e2035 * _e1610.member_2.x);
let _e2044 = (_e2037 * _e1610.member_2.y);
let _e2046 = (_e2039 * _e1610.member_2.z);
let _e2056 = ((_e2035 * _e1610.member_3.x) + _e1610.member_4.x);
let _e2058 = ((_e2037 * _e1610.member_3.y) + _e1610.member_4.y);
let _e2060 = ((_e2039 * _e1610.member_3.z) + _e1610.member_4.z);
let _e2062 = select(_e2042, 0f, (0f > _e2042));
let _e2064 = select(_e2046, _e2044, (_e2044 > _e2046));
let _e2068 = select(_e2056, _e2024, (_e2024 < _e2056));
let _e2070 = select(_e2060, _e2058, (_e2058 < _e2060));
let _e2072 = select(_e2070, _e2068, (_e2068 < _e2070));
let _e2073 = -(select(_e2064, _e2062, (_e2062 > _e2064)));
let _e2075 = (-(_e2024) - 1f);
let _e2077 = select(_e2075, _e2073, (_e2073 > _e2075));
let _e2079 = select(0f, _e2077, (_e2077 < 0f));
let _e2086 = select(0i, select(select(i32(_e2079), i32(-2147483648), (_e2079 < -2147483600f)), 2147483647i, (_e2079 > 2147483500f)), (_e2079 == _e2079));
let _e2093 = select(-1f, _e2072, (_e2072 > -1f));
let _e2095 = select(_e2024, _e2093, (_e2093 < _e2024));
let _e2102 = select(0i, select(select(i32(_e2095), i32(-2147483648), (_e2095 < -2147483600f)), 2147483647i, (_e2095 > 2147483500f)), (_e2095 == _e2095));
phi_21578_ = -((_e2086 - select(0i, 1i, (_e2079 < f32(_e2086)))));
loop {
let _e2108 = phi_21578_;
let _e2109 = (_e2108 <= (_e2102 - select(0i, 1i, (_e2095 < f32(_e2102)))));
if _e2109 {
let _e2110 = select(_e2108, _e2018, _e1130);
let _e2111 = select(_e2018, _e2108, _e1130);
let _e2112 = f32(_e2111);
let _e2113 = f32(_e2110);
let _e2115 = f32(_e904.member_1.member_4.x);
let _e2118 = ((_e1048 * _e2112) + (_e1051 * _e2113));
let _e2119 = (_e2118 + ((((select(_e1095, _e1093, (_e1093 > _e1095)) + select(_e1100, _e1098, (_e1098 > _e1100))) + select(_e1106, _e1104, (_e1104 > _e1106))) - _e1091) + _e1086));
let _e2121 = -((_e2119 * _e1614));
let _e2125 = select(0f, select(_e2121, 0f, (0f > _e2121)), (_e1045 > 0f));
let _e2132 = select(select(_e2115, select(_e2121, _e2115, (_e2115 < _e2121)), (_e1045 < 0f)), -1f, (_e1612 && (_e2119 < 0f)));
let _e2134 = (((((select(_e1113, _e1111, (_e1111 > _e1113)) + select(_e1119, _e1117, (_e1117 > _e1119))) + select(_e1126, _e1124, (_e1124 > _e1126))) + _e1091) + _e1086) - _e2118);
let _e2136 = -((_e2134 * -(_e1614)));
let _e2140 = select(_e2125, select(_e2136, _e2125, (_e2125 > _e2136)), (_e1110 > 0f));
let _e2148 = select(select(_e2132, select(_e2136, _e2132, (_e2132 < _e2136)), (_e1110 < 0f)), -1f, ((_e1110 == 0f) && (_e2134 < 0f)));
let _e2152 = ((_e1636 * _e2112) + (((select(_e1647, _e1639, ((_e1658 & 1u) != 0u)) - (_e1631 * _e962)) + (select(_e1690, _e1684, ((_e1699 & 1u) != 0u)) - (_e1636 * _e973))) + _e1626));
let _e2153 = ((_e1637 * _e2112) + (((select(_e1648, _e1640, ((_e1662 & 1u) != 0u)) - (_e1632 * _e992)) + (select(_e1691, _e1685, ((_e1703 & 1u) != 0u)) - (_e1637 * _e999))) + _e1626));
let _e2154 = ((_e1638 * _e2112) + (((select(_e1649, _e1641, ((_e1666 & 1u) != 0u)) - (_e1633 * _e1014)) + (select(_e1692, _e1686, ((_e1707 & 1u) != 0u)) - (_e1638 * _e1021))) + _e1626));
let _e2155 = (_e2152 * select(0f, _e1756, ((_e1766 & 1u) != 0u)));
let _e2156 = (_e2153 * select(0f, _e1757, ((_e1770 & 1u) != 0u)));
let _e2157 = (_e2154 * select(0f, _e1758, ((_e1774 & 1u) != 0u)));
let _e2161 = ((_e2152 * select(select(0f, 1e20f, _e1748), _e1756, _e1808)) + select(_e1076, 0f, _e1808));
let _e2162 = ((_e2153 * select(select(0f, 1e20f, _e1751), _e1757, _e1811)) + select(_e1076, 0f, _e1811));
let _e2163 = ((_e2154 * select(select(0f, 1e20f, _e1754), _e1758, _e1814)) + select(_e1076, 0f, _e1814));
let _e2165 = select(_e2155, _e2140, (_e2140 > _e2155));
let _e2167 = select(_e2157, _e2156, (_e2156 > _e2157));
let _e2169 = select(_e2167, _e2165, (_e2165 > _e2167));
let _e2171 = select(_e2161, _e2148, (_e2148 < _e2161));
let _e2173 = select(_e2163, _e2162, (_e2162 < _e2163));
let _e2175 = select(_e2173, _e2171, (_e2171 < _e2173));
let _e2179 = ((_e1834 * _e2113) + (((select(_e1845, _e1837, ((_e1856 & 1u) != 0u)) - (_e1830 * _e962)) + (select(_e1888, _e1882, ((_e1897 & 1u) != 0u)) - (_e1834 * _e984))) + _e1826));
let _e2180 = ((_e1835 * _e2113) + (((select(_e1846, _e1838, ((_e1860 & 1u) != 0u)) - (_e1831 * _e992)) + (select(_e1889, _e1883, ((_e1901 & 1u) != 0u)) - (_e1835 * _e1006))) + _e1826));
let _e2181 = ((_e1836 * _e2113) + (((select(_e1847, _e1839, ((_e1864 & 1u) != 0u)) - (_e1832 * _e1014)) + (select(_e1890, _e1884, ((_e1905 & 1u) != 0u)) - (_e1836 * _e1028))) + _e1826));
let _e2182 = (_e2179 * select(0f, _e1954, ((_e1964 & 1u) != 0u)));
let _e2183 = (_e2180 * select(0f, _e1955, ((_e1968 & 1u) != 0u)));
let _e2184 = (_e2181 * select(0f, _e1956, ((_e1972 & 1u) != 0u)));
let _e2188 = ((_e2179 * select(select(0f, 1e20f, _e1946), _e1954, _e2006)) + select(_e1076, 0f, _e2006));
let _e2189 = ((_e2180 * select(select(0f, 1e20f, _e1949), _e1955, _e2009)) + select(_e1076, 0f, _e2009));
let _e2190 = ((_e2181 * select(select(0f, 1e20f, _e1952), _e1956, _e2012)) + select(_e1076, 0f, _e2012));
let _e2192 = select(_e2182, _e2169, (_e2169 > _e2182));
let _e2194 = select(_e2184, _e2183, (_e2183 > _e2184));
let _e2198 = select(_e2188, _e2175, (_e2175 < _e2188));
let _e2200 = select(_e2190, _e2189, (_e2189 < _e2190));
let _e2202 = select(_e2200, _e2198, (_e2198 < _e2200));
let _e2203 = -(select(_e2194, _e2192, (_e2192 > _e2194)));
let _e2205 = (-(_e2115) - 1f);
let _e2207 = select(_e2205, _e2203, (_e2203 > _e2205));
let _e2209 = select(0f, _e2207, (_e2207 < 0f));
let _e2216 = select(0i, select(select(i32(_e2209), i32(-2147483648), (_e2209 < -2147483600f)), 2147483647i, (_e2209 > 2147483500f)), (_e2209 == _e2209));
let _e2221 = -((_e2216 - select(0i, 1i, (_e2209 < f32(_e2216)))));
let _e2223 = select(-1f, _e2202, (_e2202 > -1f));
let _e2225 = select(_e2115, _e2223, (_e2223 < _e2115));
let _e2232 = select(0i, select(select(i32(_e2225), i32(-2147483648), (_e2225 < -2147483600f)), 2147483647i, (_e2225 > 2147483500f)), (_e2225 == _e2225));
let _e2236 = (_e2232 - select(0i, 1i, (_e2225 < f32(_e2232))));
if (_e2221 <= _e2236) {
let _e2242 = global_2.member.member_2.member_1;
let _e2249 = global_2.member.member_3;
let _e2252 = (_e904.member_1.member_3.x + _e2221);
let _e2253 = (_e904.member_1.member_3.x + _e2236);
let _e2255 = (_e2252 >> bitcast<u32>(5i));
phi_21825_ = _e2255;
loop {
let _e2257 = phi_21825_;
let _e2259 = (_e2253 >> bitcast<u32>(5i));
let _e2260 = (_e2257 <= _e2259);
if _e2260 {
if (_e2257 == _e2255) {
phi_21844_ = (4294967295u << bitcast<u32>((bitcast<u32>((_e2252 & 31i)) & 31u)));
} else {
phi_21844_ = 4294967295u;
}
let _e2268 = phi_21844_;
if (_e2257 == _e2259) {
phi_21855_ = (4294967295u >> bitcast<u32>((bitcast<u32>((31i - (_e2253 & 31i))) & 31u)));
} else {
phi_21855_ = 4294967295u;
}
let _e2277 = phi_21855_;
let _e2279 = bitcast<u32>(((((((_e904.member_1.member_3.z + _e2110) * bitcast<i32>(_e2242)) + _e904.member_1.member_3.y) + _e2111) * bitcast<i32>(_e2249)) + _e2257));
if (_e2279 < _e198) {
let _e2284 = atomicOr((&global_1.member[_e2279]), (_e2268 & _e2277));
}
phi_21826_ = (_e2257 + 1i);
} else {
phi_21826_ = i32();
}
let _e2287 = phi_21826_;
continue;
continuing {
phi_21825_ = _e2287;
break if !(_e2260);
}
}
}
phi_21579_ = (_e2108 + 1i);
} else {
phi_21579_ = i32();
}
let _e2291 = phi_21579_;
continue;
continuing {
phi_21578_ = _e2291;
break if !(_e2109);
}
}
phi_21444_ = (_e2018 + 1i);
} else {
phi_21444_ = i32();
}
let _e2295 = phi_21444_;
continue;
continuing {
phi_21443_ = _e2295;
break if !(_e2019);
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
