struct type_2 {
member: u32,
member_1: u32,
member_2: u32,
}
struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_5 {
member: f32,
member_1: f32,
member_2: f32,
}
struct type_6 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
member_10: f32,
member_11: f32,
member_12: f32,
}
struct type_7 {
member: type_5,
member_1: f32,
}
struct type_8 {
member: type_7,
member_1: type_5,
}
struct type_9 {
member: type_8,
member_1: type_8,
}
struct type_11 {
member: array<f32>,
}
struct type_16 {
member: array<u32>,
}
struct type_17 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_18 {
member: u32,
member_1: u32,
}
struct type_19 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_20 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: type_5,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: i32,
member_8: i32,
member_9: type_2,
member_10: u32,
member_11: type_2,
member_12: u32,
}
struct type_21 {
member: u32,
member_1: u32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
}
struct type_22 {
member: type_5,
member_1: type_5,
}
struct type_23 {
member: type_7,
member_1: u32,
}
struct type_24 {
member: type_2,
member_1: u32,
member_2: type_17,
member_3: type_18,
member_4: u32,
member_5: type_19,
member_6: type_20,
member_7: type_20,
member_8: type_21,
member_9: type_22,
member_10: f32,
member_11: type_19,
member_12: type_4,
member_13: type_9,
member_14: type_23,
member_15: type_23,
member_16: type_23,
member_17: type_23,
member_18: type_5,
member_19: f32,
member_20: f32,
member_21: type_6,
}
struct type_25 {
member: type_24,
}
struct type_28 {
member: array<i32, 4>,
member_1: array<u32, 6>,
}
struct type_29 {
member: f32,
member_1: vec3<f32>,
member_2: vec3<f32>,
}
struct type_30 {
member: f32,
member_1: vec3<f32>,
member_2: f32,
member_3: vec3<f32>,
member_4: vec3<f32>,
}
struct type_31 {
member: f32,
member_1: f32,
member_2: vec3<f32>,
member_3: vec3<f32>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_25;
@group(0) @binding(1)
var<storage> global_2: type_16;
@group(0) @binding(3)
var<storage> global_3: type_16;
@group(0) @binding(4)
var<storage> global_4: type_16;
@group(0) @binding(6)
var<storage, read_write> global_5: type_11;
@group(0) @binding(5)
var<storage> global_6: type_11;
fn function_() {
var local: type_28;
var local_1: vec3<f32>;
var local_2: type_28;
var local_3: vec3<f32>;
var local_4: type_28;
var local_5: vec3<f32>;
var phi_944_: u32;
var phi_3506_: type_29;
var phi_4207_: type_30;
var phi_5095_: type_5;
var phi_6205_: type_31;
var phi_6357_: vec3<f32>;
var phi_6358_: f32;
let _e86 = global;
let _e89 = arrayLength((&global_2.member));
let _e93 = arrayLength((&global_4.member));
let _e95 = arrayLength((&global_6.member));
let _e100 = global_1.member.member_2;
let _e103 = global_1.member.member;
let _e111 = (_e86.x + _e100.member);
let _e113 = (_e86.y + _e100.member_1);
if (_e111 < _e100.member_2) {
if (_e113 < _e100.member_3) {
let _e116 = (_e103.member * _e103.member_1);
let _e118 = ((_e113 * _e103.member) + _e111);
let _e119 = bitcast<i32>(_e118);
let _e121 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e123 = select(_e121, _e119, (_e119 < _e121));
let _e129 = global_5.member[bitcast<u32>(select(0i, _e123, (_e123 > 0i)))];
let _e130 = (_e116 + _e118);
let _e131 = bitcast<i32>(_e130);
let _e133 = select(_e121, _e131, (_e131 < _e121));
let _e139 = global_5.member[bitcast<u32>(select(0i, _e133, (_e133 > 0i)))];
let _e141 = ((2u * _e116) + _e118);
let _e142 = bitcast<i32>(_e141);
let _e144 = select(_e121, _e142, (_e142 < _e121));
let _e150 = global_5.member[bitcast<u32>(select(0i, _e144, (_e144 > 0i)))];
let _e152 = ((3u * _e116) + _e118);
let _e153 = bitcast<i32>(_e152);
let _e155 = select(_e121, _e153, (_e153 < _e121));
let _e161 = global_5.member[bitcast<u32>(select(0i, _e155, (_e155 > 0i)))];
let _e163 = ((4u * _e116) + _e118);
let _e164 = bitcast<i32>(_e163);
let _e166 = select(_e121, _e164, (_e164 < _e121));
let _e172 = global_5.member[bitcast<u32>(select(0i, _e166, (_e166 > 0i)))];
let _e174 = ((5u * _e116) + _e118);
let _e175 = bitcast<i32>(_e174);
let _e177 = select(_e121, _e175, (_e175 < _e121));
let _e183 = global_5.member[bitcast<u32>(select(0i, _e177, (_e177 > 0i)))];
let _e185 = ((6u * _e116) + _e118);
let _e186 = bitcast<i32>(_e185);
let _e188 = select(_e121, _e186, (_e186 < _e121));
let _e194 = global_5.member[bitcast<u32>(select(0i, _e188, (_e188 > 0i)))];
let _e196 = ((7u * _e116) + _e118);
let _e197 = bitcast<i32>(_e196);
let _e199 = select(_e121, _e197, (_e197 < _e121));
let _e205 = global_5.member[bitcast<u32>(select(0i, _e199, (_e199 > 0i)))];
let _e207 = ((8u * _e116) + _e118);
let _e208 = bitcast<i32>(_e207);
let _e210 = select(_e121, _e208, (_e208 < _e121));
let _e216 = global_5.member[bitcast<u32>(select(0i, _e210, (_e210 > 0i)))];
let _e220 = global_1.member.member_8.member;
let _e224 = global_1.member.member_8.member_1;
let _e225 = (_e220 * _e224);
if (_e95 >= (_e225 * 2u)) {
let _e229 = bitcast<i32>((_e113 * _e220));
let _e231 = bitcast<i32>(_e111);
let _e236 = global_6.member[bitcast<u32>((_e229 + _e231))];
let _e242 = global_6.member[bitcast<u32>(((bitcast<i32>(_e225) + _e229) + _e231))];
let _e243 = f32(_e231);
let _e245 = f32(bitcast<i32>(_e113));
let _e251 = global_1.member.member_5.member;
let _e255 = global_1.member.member_8.member_8;
let _e256 = (_e251 - _e255);
let _e260 = global_1.member.member_8.member_2;
let _e264 = global_1.member.member_8.member_6;
let _e271 = global_1.member.member_8.member_4;
let _e273 = ((_e260 + (_e264 * _e256)) + (((_e243 - _e236) + 0.5f) * _e271));
let _e277 = global_1.member.member_8.member_3;
let _e281 = global_1.member.member_8.member_7;
let _e286 = ((_e277 + (_e281 * _e256)) + (((_e245 - _e242) + 0.5f) * _e271));
let _e290 = global_1.member.member_5.member_1;
let _e291 = (_e290 - _e255);
let _e296 = ((_e260 + (_e264 * _e291)) + ((_e243 + 0.5f) * _e271));
let _e301 = ((_e277 + (_e281 * _e291)) + ((_e245 + 0.5f) * _e271));
let _e305 = global_1.member.member_6.member;
let _e316 = ((((_e305.member.member * _e273) + (_e305.member.member_1 * _e286)) + (_e305.member.member_2 * _e251)) + _e305.member_1);
let _e320 = global_1.member.member_6.member_1;
let _e331 = ((((_e320.member.member * _e273) + (_e320.member.member_1 * _e286)) + (_e320.member.member_2 * _e251)) + _e320.member_1);
let _e335 = global_1.member.member_6.member_2;
let _e346 = ((((_e335.member.member * _e273) + (_e335.member.member_1 * _e286)) + (_e335.member.member_2 * _e251)) + _e335.member_1);
let _e352 = ((((_e305.member.member * _e296) + (_e305.member.member_1 * _e301)) + (_e305.member.member_2 * _e290)) + _e305.member_1);
let _e358 = ((((_e320.member.member * _e296) + (_e320.member.member_1 * _e301)) + (_e320.member.member_2 * _e290)) + _e320.member_1);
let _e364 = ((((_e335.member.member * _e296) + (_e335.member.member_1 * _e301)) + (_e335.member.member_2 * _e290)) + _e335.member_1);
let _e370 = global_1.member.member_6.member_3.member;
let _e371 = (_e370 - 1f);
let _e380 = global_1.member.member_6.member_3.member_1;
let _e381 = (_e380 - 1f);
let _e390 = global_1.member.member_6.member_3.member_2;
let _e391 = (_e390 - 1f);
let _e410 = global_1.member.member_6.member_4;
let _e411 = (_e370 - 0.5f);
let _e413 = select(-0.5f, _e352, (_e352 > -0.5f));
let _e415 = select(_e411, _e413, (_e413 < _e411));
let _e416 = (_e380 - 0.5f);
let _e418 = select(-0.5f, _e358, (_e358 > -0.5f));
let _e420 = select(_e416, _e418, (_e418 < _e416));
let _e421 = (_e390 - 0.5f);
let _e423 = select(-0.5f, _e364, (_e364 > -0.5f));
let _e425 = select(_e421, _e423, (_e423 < _e421));
let _e431 = bitcast<f32>((bitcast<u32>((_e352 - _e316)) & 2147483647u));
let _e434 = bitcast<f32>((bitcast<u32>((_e358 - _e331)) & 2147483647u));
let _e436 = select(_e434, _e431, (_e431 > _e434));
let _e439 = bitcast<f32>((bitcast<u32>((_e364 - _e346)) & 2147483647u));
let _e448 = bitcast<f32>((bitcast<u32>((_e352 - _e415)) & 2147483647u));
let _e451 = bitcast<f32>((bitcast<u32>((_e358 - _e420)) & 2147483647u));
let _e453 = select(_e451, _e448, (_e448 > _e451));
let _e456 = bitcast<f32>((bitcast<u32>((_e364 - _e425)) & 2147483647u));
let _e460 = (_e415 + 0.5f);
let _e462 = select(0f, _e460, (_e460 > 0f));
let _e464 = select(_e371, _e462, (_e462 < _e371));
let _e471 = select(0i, select(select(i32(_e464), i32(-2147483648), (_e464 < -2147483600f)), 2147483647i, (_e464 > 2147483500f)), (_e464 == _e464));
let _e479 = global_1.member.member_6.member_12;
let _e480 = (_e479 & 31u);
let _e483 = (_e420 + 0.5f);
let _e485 = select(0f, _e483, (_e483 > 0f));
let _e487 = select(_e381, _e485, (_e485 < _e381));
let _e494 = select(0i, select(select(i32(_e487), i32(-2147483648), (_e487 < -2147483600f)), 2147483647i, (_e487 > 2147483500f)), (_e487 == _e487));
let _e501 = (_e425 + 0.5f);
let _e503 = select(0f, _e501, (_e501 > 0f));
let _e505 = select(_e391, _e503, (_e503 < _e391));
let _e512 = select(0i, select(select(i32(_e505), i32(-2147483648), (_e505 < -2147483600f)), 2147483647i, (_e505 > 2147483500f)), (_e505 == _e505));
let _e523 = global_1.member.member_6.member_9.member;
let _e529 = global_1.member.member_6.member_9.member_1;
let _e534 = global_1.member.member_6.member_10;
let _e540 = ((bitcast<i32>(_e534) + ((_e471 - select(0i, 1i, (_e464 < f32(_e471)))) >> bitcast<u32>(_e480))) + (bitcast<i32>(_e523) * (((_e494 - select(0i, 1i, (_e487 < f32(_e494)))) >> bitcast<u32>(_e480)) + (bitcast<i32>(_e529) * ((_e512 - select(0i, 1i, (_e505 < f32(_e512)))) >> bitcast<u32>(_e480))))));
let _e542 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e544 = select(_e542, _e540, (_e540 < _e542));
let _e550 = global_3.member[bitcast<u32>(select(0i, _e544, (_e544 > 0i)))];
let _e556 = global_1.member.member_1;
phi_944_ = select(select(7u, 3u, (((((((_e316 >= 0f) && (_e316 <= _e371)) && (_e331 >= 0f)) && (_e331 <= _e381)) && (_e346 >= 0f)) && (_e346 <= _e391)) && ((((((_e352 >= 0f) && (_e352 <= _e371)) && (_e358 >= 0f)) && (_e358 <= _e381)) && (_e364 >= 0f)) && (_e364 <= _e391)))), 1u, (((_e556 & 64u) != 0u) || ((((select(_e439, _e436, (_e436 > _e439)) <= _e410) && ((select(_e456, _e453, (_e453 > _e456)) > _e410) || (_e550 != 0u))) && true) && ((_e556 & 32u) != 0u))));
} else {
phi_944_ = 7u;
}
let _e566 = phi_944_;
if (_e566 > 1u) {
let _e572 = bitcast<i32>(((_e113 * _e220) + _e111));
let _e575 = (bitcast<i32>(_e95) - 1i);
let _e577 = select(_e575, _e572, (_e572 < _e575));
let _e583 = global_6.member[bitcast<u32>(select(0i, _e577, (_e577 > 0i)))];
let _e584 = (bitcast<i32>(_e225) + _e572);
let _e586 = select(_e575, _e584, (_e584 < _e575));
let _e592 = global_6.member[bitcast<u32>(select(0i, _e586, (_e586 > 0i)))];
let _e594 = f32(bitcast<i32>(_e111));
let _e596 = f32(bitcast<i32>(_e113));
let _e602 = global_1.member.member_5.member;
let _e606 = global_1.member.member_8.member_8;
let _e607 = (_e602 - _e606);
let _e611 = global_1.member.member_8.member_2;
let _e615 = global_1.member.member_8.member_6;
let _e622 = global_1.member.member_8.member_4;
let _e624 = ((_e611 + (_e615 * _e607)) + (((_e594 - _e583) + 0.5f) * _e622));
let _e628 = global_1.member.member_8.member_3;
let _e632 = global_1.member.member_8.member_7;
let _e637 = ((_e628 + (_e632 * _e607)) + (((_e596 - _e592) + 0.5f) * _e622));
let _e641 = global_1.member.member_5.member_1;
let _e642 = (_e641 - _e606);
let _e647 = ((_e611 + (_e615 * _e642)) + ((_e594 + 0.5f) * _e622));
let _e652 = ((_e628 + (_e632 * _e642)) + ((_e596 + 0.5f) * _e622));
let _e656 = global_1.member.member_6.member;
let _e667 = ((((_e656.member.member * _e624) + (_e656.member.member_1 * _e637)) + (_e656.member.member_2 * _e602)) + _e656.member_1);
let _e671 = global_1.member.member_6.member_1;
let _e682 = ((((_e671.member.member * _e624) + (_e671.member.member_1 * _e637)) + (_e671.member.member_2 * _e602)) + _e671.member_1);
let _e686 = global_1.member.member_6.member_2;
let _e697 = ((((_e686.member.member * _e624) + (_e686.member.member_1 * _e637)) + (_e686.member.member_2 * _e602)) + _e686.member_1);
let _e703 = ((((_e656.member.member * _e647) + (_e656.member.member_1 * _e652)) + (_e656.member.member_2 * _e641)) + _e656.member_1);
let _e709 = ((((_e671.member.member * _e647) + (_e671.member.member_1 * _e652)) + (_e671.member.member_2 * _e641)) + _e671.member_1);
let _e715 = ((((_e686.member.member * _e647) + (_e686.member.member_1 * _e652)) + (_e686.member.member_2 * _e641)) + _e686.member_1);
let _e717 = (_e103.member_2 == 2u);
let _e720 = (((_e103.member_2 == 1u) || _e717) || (_e103.member_2 == 5u));
if _e720 {
let _e725 = global_1.member.member_6.member_3.member;
let _e726 = (_e725 - 0.5f);
let _e728 = select(-0.5f, _e703, (_e703 > -0.5f));
let _e730 = select(_e726, _e728, (_e728 < _e726));
let _e735 = global_1.member.member_6.member_3.member_1;
let _e736 = (_e735 - 0.5f);
let _e738 = select(-0.5f, _e709, (_e709 > -0.5f));
let _e740 = select(_e736, _e738, (_e738 < _e736));
let _e745 = global_1.member.member_6.member_3.member_2;
let _e746 = (_e745 - 0.5f);
let _e748 = select(-0.5f, _e715, (_e715 > -0.5f));
let _e750 = select(_e746, _e748, (_e748 < _e746));
let _e752 = select(-1f, _e730, (_e730 > -1f));
let _e754 = select(_e725, _e752, (_e752 < _e725));
let _e761 = select(0i, select(select(i32(_e754), i32(-2147483648), (_e754 < -2147483600f)), 2147483647i, (_e754 > 2147483500f)), (_e754 == _e754));
let _e765 = (_e761 - select(0i, 1i, (_e754 < f32(_e761))));
let _e767 = select(-1f, _e740, (_e740 > -1f));
let _e769 = select(_e735, _e767, (_e767 < _e735));
let _e776 = select(0i, select(select(i32(_e769), i32(-2147483648), (_e769 < -2147483600f)), 2147483647i, (_e769 > 2147483500f)), (_e769 == _e769));
let _e780 = (_e776 - select(0i, 1i, (_e769 < f32(_e776))));
let _e782 = select(-1f, _e750, (_e750 > -1f));
let _e784 = select(_e745, _e782, (_e782 < _e745));
let _e791 = select(0i, select(select(i32(_e784), i32(-2147483648), (_e784 < -2147483600f)), 2147483647i, (_e784 > 2147483500f)), (_e784 == _e784));
let _e795 = (_e791 - select(0i, 1i, (_e784 < f32(_e791))));
let _e799 = global_1.member.member_6.member_7;
let _e803 = global_1.member.member_6.member_8;
let _e804 = (_e765 + 1i);
let _e805 = (_e780 + 1i);
let _e806 = (_e795 + 1i);
let _e811 = global_1.member.member_6.member_11.member;
let _e817 = global_1.member.member_6.member_11.member_1;
let _e828 = ((_e804 >> bitcast<u32>(4i)) + (bitcast<i32>(_e811) * ((_e805 >> bitcast<u32>(4i)) + (bitcast<i32>(_e817) * (_e806 >> bitcast<u32>(4i))))));
let _e830 = (bitcast<i32>(_e89) - 1i);
let _e832 = select(_e830, _e828, (_e828 < _e830));
let _e838 = global_2.member[bitcast<u32>(select(0i, _e832, (_e832 > 0i)))];
let _e840 = (_e804 & 15i);
let _e843 = ((_e805 & 15i) * _e799);
let _e845 = (bitcast<i32>(_e838) + ((_e806 & 15i) * _e803));
let _e849 = (_e843 + _e799);
let _e851 = (_e843 + (2i * _e799));
let _e853 = (_e843 + (3i * _e799));
let _e854 = (_e845 + _e803);
let _e856 = (_e845 + (2i * _e803));
let _e858 = (_e845 + (3i * _e803));
local_4 = type_28(array<i32, 4>(_e840, (_e840 + 1i), (_e840 + 2i), (_e840 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_5 = vec3<f32>((_e730 - f32(_e765)), (_e740 - f32(_e780)), (_e750 - f32(_e795)));
let _e869 = (_e854 + _e849);
let _e872 = local_4.member[0u];
let _e873 = (_e869 + _e872);
let _e875 = (_e873 >> bitcast<u32>(1i));
let _e878 = bitcast<u32>(((_e873 & 1i) * 16i));
let _e880 = select(_e830, _e875, (_e875 < _e830));
let _e885 = global_2.member[bitcast<u32>(select(0i, _e880, (_e880 > 0i)))];
let _e889 = (_e875 + 1i);
let _e891 = select(_e830, _e889, (_e889 < _e830));
let _e896 = global_2.member[bitcast<u32>(select(0i, _e891, (_e891 > 0i)))];
let _e903 = ((_e885 >> bitcast<u32>((_e878 & 31u))) | ((_e896 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e878) & 31u))));
let _e906 = local_4.member[2u];
let _e907 = (_e869 + _e906);
let _e909 = (_e907 >> bitcast<u32>(1i));
let _e912 = bitcast<u32>(((_e907 & 1i) * 16i));
let _e914 = select(_e830, _e909, (_e909 < _e830));
let _e919 = global_2.member[bitcast<u32>(select(0i, _e914, (_e914 > 0i)))];
let _e923 = (_e909 + 1i);
let _e925 = select(_e830, _e923, (_e923 < _e830));
let _e930 = global_2.member[bitcast<u32>(select(0i, _e925, (_e925 > 0i)))];
let _e937 = ((_e919 >> bitcast<u32>((_e912 & 31u))) | ((_e930 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e912) & 31u))));
let _e940 = local_4.member_1[0u];
let _e946 = f32(bitcast<i32>(((_e903 >> bitcast<u32>((_e940 & 31u))) & 65535u)));
let _e949 = local_4.member_1[1u];
let _e955 = f32(bitcast<i32>(((_e903 >> bitcast<u32>((_e949 & 31u))) & 65535u)));
let _e958 = local_4.member_1[4u];
let _e964 = f32(bitcast<i32>(((_e937 >> bitcast<u32>((_e958 & 31u))) & 65535u)));
let _e967 = local_4.member_1[5u];
let _e974 = local_5[0u];
let _e977 = (_e946 + ((_e955 - _e946) * _e974));
let _e978 = local_5[0u];
let _e981 = (_e955 + ((_e964 - _e955) * _e978));
let _e982 = local_5[0u];
let _e985 = (_e964 + ((f32(bitcast<i32>(((_e937 >> bitcast<u32>((_e967 & 31u))) & 65535u))) - _e964) * _e982));
let _e986 = (_e854 + _e851);
let _e987 = local_4.member[0u];
let _e988 = (_e986 + _e987);
let _e990 = (_e988 >> bitcast<u32>(1i));
let _e993 = bitcast<u32>(((_e988 & 1i) * 16i));
let _e995 = select(_e830, _e990, (_e990 < _e830));
let _e1000 = global_2.member[bitcast<u32>(select(0i, _e995, (_e995 > 0i)))];
let _e1004 = (_e990 + 1i);
let _e1006 = select(_e830, _e1004, (_e1004 < _e830));
let _e1011 = global_2.member[bitcast<u32>(select(0i, _e1006, (_e1006 > 0i)))];
let _e1018 = ((_e1000 >> bitcast<u32>((_e993 & 31u))) | ((_e1011 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e993) & 31u))));
let _e1019 = local_4.member[2u];
let _e1020 = (_e986 + _e1019);
let _e1022 = (_e1020 >> bitcast<u32>(1i));
let _e1025 = bitcast<u32>(((_e1020 & 1i) * 16i));
let _e1027 = select(_e830, _e1022, (_e1022 < _e830));
let _e1032 = global_2.member[bitcast<u32>(select(0i, _e1027, (_e1027 > 0i)))];
let _e1036 = (_e1022 + 1i);
let _e1038 = select(_e830, _e1036, (_e1036 < _e830));
let _e1043 = global_2.member[bitcast<u32>(select(0i, _e1038, (_e1038 > 0i)))];
let _e1050 = ((_e1032 >> bitcast<u32>((_e1025 & 31u))) | ((_e1043 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1025) & 31u))));
let _e1051 = local_4.member_1[0u];
let _e1057 = f32(bitcast<i32>(((_e1018 >> bitcast<u32>((_e1051 & 31u))) & 65535u)));
let _e1058 = local_4.member_1[1u];
let _e1064 = f32(bitcast<i32>(((_e1018 >> bitcast<u32>((_e1058 & 31u))) & 65535u)));
let _e1065 = local_4.member_1[4u];
let _e1071 = f32(bitcast<i32>(((_e1050 >> bitcast<u32>((_e1065 & 31u))) & 65535u)));
let _e1072 = local_4.member_1[5u];
let _e1079 = local_5[0u];
let _e1083 = local_5[0u];
let _e1086 = (_e1064 + ((_e1071 - _e1064) * _e1083));
let _e1087 = local_5[0u];
let _e1091 = (_e856 + _e849);
let _e1092 = local_4.member[0u];
let _e1093 = (_e1091 + _e1092);
let _e1095 = (_e1093 >> bitcast<u32>(1i));
let _e1098 = bitcast<u32>(((_e1093 & 1i) * 16i));
let _e1100 = select(_e830, _e1095, (_e1095 < _e830));
let _e1105 = global_2.member[bitcast<u32>(select(0i, _e1100, (_e1100 > 0i)))];
let _e1109 = (_e1095 + 1i);
let _e1111 = select(_e830, _e1109, (_e1109 < _e830));
let _e1116 = global_2.member[bitcast<u32>(select(0i, _e1111, (_e1111 > 0i)))];
let _e1123 = ((_e1105 >> bitcast<u32>((_e1098 & 31u))) | ((_e1116 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1098) & 31u))));
let _e1124 = local_4.member[2u];
let _e1125 = (_e1091 + _e1124);
let _e1127 = (_e1125 >> bitcast<u32>(1i));
let _e1130 = bitcast<u32>(((_e1125 & 1i) * 16i));
let _e1132 = select(_e830, _e1127, (_e1127 < _e830));
let _e1137 = global_2.member[bitcast<u32>(select(0i, _e1132, (_e1132 > 0i)))];
let _e1141 = (_e1127 + 1i);
let _e1143 = select(_e830, _e1141, (_e1141 < _e830));
let _e1148 = global_2.member[bitcast<u32>(select(0i, _e1143, (_e1143 > 0i)))];
let _e1155 = ((_e1137 >> bitcast<u32>((_e1130 & 31u))) | ((_e1148 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1130) & 31u))));
let _e1156 = local_4.member_1[0u];
let _e1162 = f32(bitcast<i32>(((_e1123 >> bitcast<u32>((_e1156 & 31u))) & 65535u)));
let _e1163 = local_4.member_1[1u];
let _e1169 = f32(bitcast<i32>(((_e1123 >> bitcast<u32>((_e1163 & 31u))) & 65535u)));
let _e1170 = local_4.member_1[4u];
let _e1176 = f32(bitcast<i32>(((_e1155 >> bitcast<u32>((_e1170 & 31u))) & 65535u)));
let _e1177 = local_4.member_1[5u];
let _e1184 = local_5[0u];
let _e1187 = (_e1162 + ((_e1169 - _e1162) * _e1184));
let _e1188 = local_5[0u];
let _e1191 = (_e1169 + ((_e1176 - _e1169) * _e1188));
let _e1192 = local_5[0u];
let _e1195 = (_e1176 + ((f32(bitcast<i32>(((_e1155 >> bitcast<u32>((_e1177 & 31u))) & 65535u))) - _e1176) * _e1192));
let _e1196 = (_e856 + _e851);
let _e1197 = local_4.member[0u];
let _e1198 = (_e1196 + _e1197);
let _e1200 = (_e1198 >> bitcast<u32>(1i));
let _e1203 = bitcast<u32>(((_e1198 & 1i) * 16i));
let _e1205 = select(_e830, _e1200, (_e1200 < _e830));
let _e1210 = global_2.member[bitcast<u32>(select(0i, _e1205, (_e1205 > 0i)))];
let _e1214 = (_e1200 + 1i);
let _e1216 = select(_e830, _e1214, (_e1214 < _e830));
let _e1221 = global_2.member[bitcast<u32>(select(0i, _e1216, (_e1216 > 0i)))];
let _e1228 = ((_e1210 >> bitcast<u32>((_e1203 & 31u))) | ((_e1221 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1203) & 31u))));
let _e1229 = local_4.member[2u];
let _e1230 = (_e1196 + _e1229);
let _e1232 = (_e1230 >> bitcast<u32>(1i));
let _e1235 = bitcast<u32>(((_e1230 & 1i) * 16i));
let _e1237 = select(_e830, _e1232, (_e1232 < _e830));
let _e1242 = global_2.member[bitcast<u32>(select(0i, _e1237, (_e1237 > 0i)))];
let _e1246 = (_e1232 + 1i);
let _e1248 = select(_e830, _e1246, (_e1246 < _e830));
let _e1253 = global_2.member[bitcast<u32>(select(0i, _e1248, (_e1248 > 0i)))];
let _e1260 = ((_e1242 >> bitcast<u32>((_e1235 & 31u))) | ((_e1253 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1235) & 31u))));
let _e1261 = local_4.member_1[0u];
let _e1267 = f32(bitcast<i32>(((_e1228 >> bitcast<u32>((_e1261 & 31u))) & 65535u)));
let _e1268 = local_4.member_1[1u];
let _e1274 = f32(bitcast<i32>(((_e1228 >> bitcast<u32>((_e1268 & 31u))) & 65535u)));
let _e1275 = local_4.member_1[4u];
let _e1281 = f32(bitcast<i32>(((_e1260 >> bitcast<u32>((_e1275 & 31u))) & 65535u)));
let _e1282 = local_4.member_1[5u];
let _e1289 = local_5[0u];
let _e1293 = local_5[0u];
let _e1296 = (_e1274 + ((_e1281 - _e1274) * _e1293));
let _e1297 = local_5[0u];
let _e1304 = local_4.member[1u];
let _e1305 = ((_e854 + _e843) + _e1304);
let _e1307 = (_e1305 >> bitcast<u32>(1i));
let _e1310 = bitcast<u32>(((_e1305 & 1i) * 16i));
let _e1312 = select(_e830, _e1307, (_e1307 < _e830));
let _e1317 = global_2.member[bitcast<u32>(select(0i, _e1312, (_e1312 > 0i)))];
let _e1321 = (_e1307 + 1i);
let _e1323 = select(_e830, _e1321, (_e1321 < _e830));
let _e1328 = global_2.member[bitcast<u32>(select(0i, _e1323, (_e1323 > 0i)))];
let _e1335 = ((_e1317 >> bitcast<u32>((_e1310 & 31u))) | ((_e1328 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1310) & 31u))));
let _e1338 = local_4.member_1[2u];
let _e1344 = f32(bitcast<i32>(((_e1335 >> bitcast<u32>((_e1338 & 31u))) & 65535u)));
let _e1347 = local_4.member_1[3u];
let _e1354 = local_5[0u];
let _e1357 = (_e1344 + ((f32(bitcast<i32>(((_e1335 >> bitcast<u32>((_e1347 & 31u))) & 65535u))) - _e1344) * _e1354));
let _e1359 = local_4.member[1u];
let _e1360 = ((_e854 + _e853) + _e1359);
let _e1362 = (_e1360 >> bitcast<u32>(1i));
let _e1365 = bitcast<u32>(((_e1360 & 1i) * 16i));
let _e1367 = select(_e830, _e1362, (_e1362 < _e830));
let _e1372 = global_2.member[bitcast<u32>(select(0i, _e1367, (_e1367 > 0i)))];
let _e1376 = (_e1362 + 1i);
let _e1378 = select(_e830, _e1376, (_e1376 < _e830));
let _e1383 = global_2.member[bitcast<u32>(select(0i, _e1378, (_e1378 > 0i)))];
let _e1390 = ((_e1372 >> bitcast<u32>((_e1365 & 31u))) | ((_e1383 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1365) & 31u))));
let _e1391 = local_4.member_1[2u];
let _e1397 = f32(bitcast<i32>(((_e1390 >> bitcast<u32>((_e1391 & 31u))) & 65535u)));
let _e1398 = local_4.member_1[3u];
let _e1405 = local_5[0u];
let _e1410 = local_4.member[1u];
let _e1411 = ((_e856 + _e843) + _e1410);
let _e1413 = (_e1411 >> bitcast<u32>(1i));
let _e1416 = bitcast<u32>(((_e1411 & 1i) * 16i));
let _e1418 = select(_e830, _e1413, (_e1413 < _e830));
let _e1423 = global_2.member[bitcast<u32>(select(0i, _e1418, (_e1418 > 0i)))];
let _e1427 = (_e1413 + 1i);
let _e1429 = select(_e830, _e1427, (_e1427 < _e830));
let _e1434 = global_2.member[bitcast<u32>(select(0i, _e1429, (_e1429 > 0i)))];
let _e1441 = ((_e1423 >> bitcast<u32>((_e1416 & 31u))) | ((_e1434 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1416) & 31u))));
let _e1442 = local_4.member_1[2u];
let _e1448 = f32(bitcast<i32>(((_e1441 >> bitcast<u32>((_e1442 & 31u))) & 65535u)));
let _e1449 = local_4.member_1[3u];
let _e1456 = local_5[0u];
let _e1459 = (_e1448 + ((f32(bitcast<i32>(((_e1441 >> bitcast<u32>((_e1449 & 31u))) & 65535u))) - _e1448) * _e1456));
let _e1461 = local_4.member[1u];
let _e1462 = ((_e856 + _e853) + _e1461);
let _e1464 = (_e1462 >> bitcast<u32>(1i));
let _e1467 = bitcast<u32>(((_e1462 & 1i) * 16i));
let _e1469 = select(_e830, _e1464, (_e1464 < _e830));
let _e1474 = global_2.member[bitcast<u32>(select(0i, _e1469, (_e1469 > 0i)))];
let _e1478 = (_e1464 + 1i);
let _e1480 = select(_e830, _e1478, (_e1478 < _e830));
let _e1485 = global_2.member[bitcast<u32>(select(0i, _e1480, (_e1480 > 0i)))];
let _e1492 = ((_e1474 >> bitcast<u32>((_e1467 & 31u))) | ((_e1485 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1467) & 31u))));
let _e1493 = local_4.member_1[2u];
let _e1499 = f32(bitcast<i32>(((_e1492 >> bitcast<u32>((_e1493 & 31u))) & 65535u)));
let _e1500 = local_4.member_1[3u];
let _e1507 = local_5[0u];
let _e1512 = local_4.member[1u];
let _e1513 = ((_e845 + _e849) + _e1512);
let _e1515 = (_e1513 >> bitcast<u32>(1i));
let _e1518 = bitcast<u32>(((_e1513 & 1i) * 16i));
let _e1520 = select(_e830, _e1515, (_e1515 < _e830));
let _e1525 = global_2.member[bitcast<u32>(select(0i, _e1520, (_e1520 > 0i)))];
let _e1529 = (_e1515 + 1i);
let _e1531 = select(_e830, _e1529, (_e1529 < _e830));
let _e1536 = global_2.member[bitcast<u32>(select(0i, _e1531, (_e1531 > 0i)))];
let _e1543 = ((_e1525 >> bitcast<u32>((_e1518 & 31u))) | ((_e1536 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1518) & 31u))));
let _e1544 = local_4.member_1[2u];
let _e1550 = f32(bitcast<i32>(((_e1543 >> bitcast<u32>((_e1544 & 31u))) & 65535u)));
let _e1551 = local_4.member_1[3u];
let _e1558 = local_5[0u];
let _e1561 = (_e1550 + ((f32(bitcast<i32>(((_e1543 >> bitcast<u32>((_e1551 & 31u))) & 65535u))) - _e1550) * _e1558));
let _e1563 = local_4.member[1u];
let _e1564 = ((_e858 + _e849) + _e1563);
let _e1566 = (_e1564 >> bitcast<u32>(1i));
let _e1569 = bitcast<u32>(((_e1564 & 1i) * 16i));
let _e1571 = select(_e830, _e1566, (_e1566 < _e830));
let _e1576 = global_2.member[bitcast<u32>(select(0i, _e1571, (_e1571 > 0i)))];
let _e1580 = (_e1566 + 1i);
let _e1582 = select(_e830, _e1580, (_e1580 < _e830));
let _e1587 = global_2.member[bitcast<u32>(select(0i, _e1582, (_e1582 > 0i)))];
let _e1594 = ((_e1576 >> bitcast<u32>((_e1569 & 31u))) | ((_e1587 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1569) & 31u))));
let _e1595 = local_4.member_1[2u];
let _e1601 = f32(bitcast<i32>(((_e1594 >> bitcast<u32>((_e1595 & 31u))) & 65535u)));
let _e1602 = local_4.member_1[3u];
let _e1609 = local_5[0u];
let _e1612 = (_e1601 + ((f32(bitcast<i32>(((_e1594 >> bitcast<u32>((_e1602 & 31u))) & 65535u))) - _e1601) * _e1609));
let _e1614 = local_4.member[1u];
let _e1615 = ((_e845 + _e851) + _e1614);
let _e1617 = (_e1615 >> bitcast<u32>(1i));
let _e1620 = bitcast<u32>(((_e1615 & 1i) * 16i));
let _e1622 = select(_e830, _e1617, (_e1617 < _e830));
let _e1627 = global_2.member[bitcast<u32>(select(0i, _e1622, (_e1622 > 0i)))];
let _e1631 = (_e1617 + 1i);
let _e1633 = select(_e830, _e1631, (_e1631 < _e830));
let _e1638 = global_2.member[bitcast<u32>(select(0i, _e1633, (_e1633 > 0i)))];
let _e1645 = ((_e1627 >> bitcast<u32>((_e1620 & 31u))) | ((_e1638 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1620) & 31u))));
let _e1646 = local_4.member_1[2u];
let _e1652 = f32(bitcast<i32>(((_e1645 >> bitcast<u32>((_e1646 & 31u))) & 65535u)));
let _e1653 = local_4.member_1[3u];
let _e1660 = local_5[0u];
let _e1665 = local_4.member[1u];
let _e1666 = ((_e858 + _e851) + _e1665);
let _e1668 = (_e1666 >> bitcast<u32>(1i));
let _e1671 = bitcast<u32>(((_e1666 & 1i) * 16i));
let _e1673 = select(_e830, _e1668, (_e1668 < _e830));
let _e1678 = global_2.member[bitcast<u32>(select(0i, _e1673, (_e1673 > 0i)))];
let _e1682 = (_e1668 + 1i);
let _e1684 = select(_e830, _e1682, (_e1682 < _e830));
let _e1689 = global_2.member[bitcast<u32>(select(0i, _e1684, (_e1684 > 0i)))];
let _e1696 = ((_e1678 >> bitcast<u32>((_e1671 & 31u))) | ((_e1689 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1671) & 31u))));
let _e1697 = local_4.member_1[2u];
let _e1703 = f32(bitcast<i32>(((_e1696 >> bitcast<u32>((_e1697 & 31u))) & 65535u)));
let _e1704 = local_4.member_1[3u];
let _e1711 = local_5[0u];
let _e1716 = local_5[1u];
let _e1719 = (_e981 + ((_e1086 - _e981) * _e1716));
let _e1720 = local_5[1u];
let _e1723 = (_e1191 + ((_e1296 - _e1191) * _e1720));
let _e1724 = local_5[1u];
let _e1727 = (_e977 + (((_e1057 + ((_e1064 - _e1057) * _e1079)) - _e977) * _e1724));
let _e1728 = local_5[1u];
let _e1733 = local_5[2u];
let _e1737 = local_5[1u];
let _e1740 = (_e985 + (((_e1071 + ((f32(bitcast<i32>(((_e1050 >> bitcast<u32>((_e1072 & 31u))) & 65535u))) - _e1071) * _e1087)) - _e985) * _e1737));
let _e1741 = local_5[1u];
let _e1745 = local_5[2u];
let _e1749 = local_5[1u];
let _e1752 = (_e1357 + ((_e981 - _e1357) * _e1749));
let _e1753 = local_5[1u];
let _e1757 = local_5[2u];
let _e1761 = local_5[1u];
let _e1764 = (_e1086 + (((_e1397 + ((f32(bitcast<i32>(((_e1390 >> bitcast<u32>((_e1398 & 31u))) & 65535u))) - _e1397) * _e1405)) - _e1086) * _e1761));
let _e1765 = local_5[1u];
let _e1769 = local_5[2u];
let _e1773 = local_5[1u];
let _e1776 = (_e1561 + (((_e1652 + ((f32(bitcast<i32>(((_e1645 >> bitcast<u32>((_e1653 & 31u))) & 65535u))) - _e1652) * _e1660)) - _e1561) * _e1773));
let _e1777 = local_5[2u];
let _e1781 = local_5[1u];
let _e1785 = local_5[2u];
let _e1789 = local_5[2u];
let _e1796 = global_1.member.member_6.member_5;
let _e1801 = global_1.member.member_6.member_6;
let _e1802 = (((_e1719 + ((_e1723 - _e1719) * _e1789)) * _e1796) + _e1801);
let _e1804 = select(0f, _e1802, (_e1802 > 0f));
let _e1806 = select(1f, _e1804, (_e1804 < 1f));
let _e1808 = (((_e1727 + (((_e1187 + (((_e1267 + ((_e1274 - _e1267) * _e1289)) - _e1187) * _e1728)) - _e1727) * _e1733)) * _e1796) + _e1801);
let _e1810 = select(0f, _e1808, (_e1808 > 0f));
let _e1812 = select(1f, _e1810, (_e1810 < 1f));
let _e1814 = (((_e1740 + (((_e1195 + (((_e1281 + ((f32(bitcast<i32>(((_e1260 >> bitcast<u32>((_e1282 & 31u))) & 65535u))) - _e1281) * _e1297)) - _e1195) * _e1741)) - _e1740) * _e1745)) * _e1796) + _e1801);
let _e1816 = select(0f, _e1814, (_e1814 > 0f));
let _e1818 = select(1f, _e1816, (_e1816 < 1f));
let _e1820 = (((_e1752 + (((_e1459 + ((_e1191 - _e1459) * _e1753)) - _e1752) * _e1757)) * _e1796) + _e1801);
let _e1822 = select(0f, _e1820, (_e1820 > 0f));
let _e1824 = select(1f, _e1822, (_e1822 < 1f));
let _e1826 = (((_e1764 + (((_e1296 + (((_e1499 + ((f32(bitcast<i32>(((_e1492 >> bitcast<u32>((_e1500 & 31u))) & 65535u))) - _e1499) * _e1507)) - _e1296) * _e1765)) - _e1764) * _e1769)) * _e1796) + _e1801);
let _e1828 = select(0f, _e1826, (_e1826 > 0f));
let _e1830 = select(1f, _e1828, (_e1828 < 1f));
let _e1832 = (((_e1776 + ((_e1719 - _e1776) * _e1777)) * _e1796) + _e1801);
let _e1834 = select(0f, _e1832, (_e1832 > 0f));
let _e1836 = select(1f, _e1834, (_e1834 < 1f));
let _e1838 = (((_e1723 + (((_e1612 + (((_e1703 + ((f32(bitcast<i32>(((_e1696 >> bitcast<u32>((_e1704 & 31u))) & 65535u))) - _e1703) * _e1711)) - _e1612) * _e1781)) - _e1723) * _e1785)) * _e1796) + _e1801);
let _e1840 = select(0f, _e1838, (_e1838 > 0f));
let _e1842 = select(1f, _e1840, (_e1840 < 1f));
let _e1843 = (_e1806 * 1024f);
let _e1844 = (1024f - 1f);
let _e1846 = select(0f, _e1843, (_e1843 > 0f));
let _e1848 = select(_e1844, _e1846, (_e1846 < _e1844));
let _e1855 = select(0i, select(select(i32(_e1848), i32(-2147483648), (_e1848 < -2147483600f)), 2147483647i, (_e1848 > 2147483500f)), (_e1848 == _e1848));
let _e1859 = (_e1855 - select(0i, 1i, (_e1848 < f32(_e1855))));
let _e1860 = (262147i + _e1859);
let _e1862 = (bitcast<i32>(_e93) - 1i);
let _e1864 = select(_e1862, _e1860, (_e1860 < _e1862));
let _e1870 = global_4.member[bitcast<u32>(select(0i, _e1864, (_e1864 > 0i)))];
let _e1880 = select(_e1862, 262146i, (262146i < _e1862));
let _e1886 = global_4.member[bitcast<u32>(select(0i, _e1880, (_e1880 > 0i)))];
let _e1887 = bitcast<f32>(_e1886);
let _e1888 = (f32((bitcast<i32>((_e1870 & 4095u)) - 2048i)) * _e1887);
let _e1890 = select(_e1862, 262144i, (262144i < _e1862));
let _e1896 = global_4.member[bitcast<u32>(select(0i, _e1890, (_e1890 > 0i)))];
let _e1897 = bitcast<f32>(_e1896);
let _e1899 = select(_e1862, 262145i, (262145i < _e1862));
let _e1905 = global_4.member[bitcast<u32>(select(0i, _e1899, (_e1899 > 0i)))];
let _e1906 = bitcast<f32>(_e1905);
let _e1912 = ((_e1897 + (f32(bitcast<i32>((_e1870 >> bitcast<u32>(12u)))) * _e1906)) + (_e1888 * (_e1843 - f32(_e1859))));
let _e1913 = (_e1888 * 1024f);
if _e717 {
let _e1920 = ((0.5f * (_e1818 - _e1812)) * _e1913);
let _e1921 = ((0.5f * (_e1830 - _e1824)) * _e1913);
let _e1922 = ((0.5f * (_e1842 - _e1836)) * _e1913);
phi_3506_ = type_29(_e1912, vec3<f32>(_e1920, _e1921, _e1922), vec3<f32>((_e1920 * _e1912), (_e1921 * _e1912), (_e1922 * _e1912)));
} else {
let _e1929 = (_e1812 * 1024f);
let _e1931 = select(0f, _e1929, (_e1929 > 0f));
let _e1933 = select(_e1844, _e1931, (_e1931 < _e1844));
let _e1940 = select(0i, select(select(i32(_e1933), i32(-2147483648), (_e1933 < -2147483600f)), 2147483647i, (_e1933 > 2147483500f)), (_e1933 == _e1933));
let _e1944 = (_e1940 - select(0i, 1i, (_e1933 < f32(_e1940))));
let _e1945 = (262147i + _e1944);
let _e1947 = select(_e1862, _e1945, (_e1945 < _e1862));
let _e1953 = global_4.member[bitcast<u32>(select(0i, _e1947, (_e1947 > 0i)))];
let _e1968 = ((_e1897 + (f32(bitcast<i32>((_e1953 >> bitcast<u32>(12u)))) * _e1906)) + ((f32((bitcast<i32>((_e1953 & 4095u)) - 2048i)) * _e1887) * (_e1929 - f32(_e1944))));
let _e1969 = (_e1818 * 1024f);
let _e1971 = select(0f, _e1969, (_e1969 > 0f));
let _e1973 = select(_e1844, _e1971, (_e1971 < _e1844));
let _e1980 = select(0i, select(select(i32(_e1973), i32(-2147483648), (_e1973 < -2147483600f)), 2147483647i, (_e1973 > 2147483500f)), (_e1973 == _e1973));
let _e1984 = (_e1980 - select(0i, 1i, (_e1973 < f32(_e1980))));
let _e1985 = (262147i + _e1984);
let _e1987 = select(_e1862, _e1985, (_e1985 < _e1862));
let _e1993 = global_4.member[bitcast<u32>(select(0i, _e1987, (_e1987 > 0i)))];
let _e2008 = ((_e1897 + (f32(bitcast<i32>((_e1993 >> bitcast<u32>(12u)))) * _e1906)) + ((f32((bitcast<i32>((_e1993 & 4095u)) - 2048i)) * _e1887) * (_e1969 - f32(_e1984))));
let _e2009 = (_e1824 * 1024f);
let _e2011 = select(0f, _e2009, (_e2009 > 0f));
let _e2013 = select(_e1844, _e2011, (_e2011 < _e1844));
let _e2020 = select(0i, select(select(i32(_e2013), i32(-2147483648), (_e2013 < -2147483600f)), 2147483647i, (_e2013 > 2147483500f)), (_e2013 == _e2013));
let _e2024 = (_e2020 - select(0i, 1i, (_e2013 < f32(_e2020))));
let _e2025 = (262147i + _e2024);
let _e2027 = select(_e1862, _e2025, (_e2025 < _e1862));
let _e2033 = global_4.member[bitcast<u32>(select(0i, _e2027, (_e2027 > 0i)))];
let _e2048 = ((_e1897 + (f32(bitcast<i32>((_e2033 >> bitcast<u32>(12u)))) * _e1906)) + ((f32((bitcast<i32>((_e2033 & 4095u)) - 2048i)) * _e1887) * (_e2009 - f32(_e2024))));
let _e2049 = (_e1830 * 1024f);
let _e2051 = select(0f, _e2049, (_e2049 > 0f));
let _e2053 = select(_e1844, _e2051, (_e2051 < _e1844));
let _e2060 = select(0i, select(select(i32(_e2053), i32(-2147483648), (_e2053 < -2147483600f)), 2147483647i, (_e2053 > 2147483500f)), (_e2053 == _e2053));
let _e2064 = (_e2060 - select(0i, 1i, (_e2053 < f32(_e2060))));
let _e2065 = (262147i + _e2064);
let _e2067 = select(_e1862, _e2065, (_e2065 < _e1862));
let _e2073 = global_4.member[bitcast<u32>(select(0i, _e2067, (_e2067 > 0i)))];
let _e2088 = ((_e1897 + (f32(bitcast<i32>((_e2073 >> bitcast<u32>(12u)))) * _e1906)) + ((f32((bitcast<i32>((_e2073 & 4095u)) - 2048i)) * _e1887) * (_e2049 - f32(_e2064))));
let _e2089 = (_e1836 * 1024f);
let _e2091 = select(0f, _e2089, (_e2089 > 0f));
let _e2093 = select(_e1844, _e2091, (_e2091 < _e1844));
let _e2100 = select(0i, select(select(i32(_e2093), i32(-2147483648), (_e2093 < -2147483600f)), 2147483647i, (_e2093 > 2147483500f)), (_e2093 == _e2093));
let _e2104 = (_e2100 - select(0i, 1i, (_e2093 < f32(_e2100))));
let _e2105 = (262147i + _e2104);
let _e2107 = select(_e1862, _e2105, (_e2105 < _e1862));
let _e2113 = global_4.member[bitcast<u32>(select(0i, _e2107, (_e2107 > 0i)))];
let _e2128 = ((_e1897 + (f32(bitcast<i32>((_e2113 >> bitcast<u32>(12u)))) * _e1906)) + ((f32((bitcast<i32>((_e2113 & 4095u)) - 2048i)) * _e1887) * (_e2089 - f32(_e2104))));
let _e2129 = (_e1842 * 1024f);
let _e2131 = select(0f, _e2129, (_e2129 > 0f));
let _e2133 = select(_e1844, _e2131, (_e2131 < _e1844));
let _e2140 = select(0i, select(select(i32(_e2133), i32(-2147483648), (_e2133 < -2147483600f)), 2147483647i, (_e2133 > 2147483500f)), (_e2133 == _e2133));
let _e2144 = (_e2140 - select(0i, 1i, (_e2133 < f32(_e2140))));
let _e2145 = (262147i + _e2144);
let _e2147 = select(_e1862, _e2145, (_e2145 < _e1862));
let _e2153 = global_4.member[bitcast<u32>(select(0i, _e2147, (_e2147 > 0i)))];
let _e2168 = ((_e1897 + (f32(bitcast<i32>((_e2153 >> bitcast<u32>(12u)))) * _e1906)) + ((f32((bitcast<i32>((_e2153 & 4095u)) - 2048i)) * _e1887) * (_e2129 - f32(_e2144))));
let _e2169 = (_e2008 - _e1968);
let _e2171 = (_e2088 - _e2048);
let _e2173 = (_e2168 - _e2128);
phi_3506_ = type_29(_e1912, vec3<f32>((0.5f * _e2169), (0.5f * _e2171), (0.5f * _e2173)), vec3<f32>((0.25f * (_e2169 * (_e2008 + _e1968))), (0.25f * (_e2171 * (_e2088 + _e2048))), (0.25f * (_e2173 * (_e2168 + _e2128)))));
}
let _e2188 = phi_3506_;
let _e2203 = select(0f, 1f, ((((((_e703 >= -0.5f) && (_e703 <= _e726)) && (_e709 >= -0.5f)) && (_e709 <= _e736)) && (_e715 >= -0.5f)) && (_e715 <= _e746)));
let _e2205 = (0.5f * (_e1818 - _e1812));
let _e2207 = (0.5f * (_e1830 - _e1824));
let _e2209 = (0.5f * (_e1842 - _e1836));
let _e2215 = global_1.member.member_6.member.member.member;
let _e2221 = global_1.member.member_6.member.member.member_1;
let _e2227 = global_1.member.member_6.member.member.member_2;
let _e2233 = global_1.member.member_6.member_1.member.member;
let _e2239 = global_1.member.member_6.member_1.member.member_1;
let _e2245 = global_1.member.member_6.member_1.member.member_2;
let _e2251 = global_1.member.member_6.member_2.member.member;
let _e2257 = global_1.member.member_6.member_2.member.member_1;
let _e2263 = global_1.member.member_6.member_2.member.member_2;
phi_4207_ = type_30(_e1806, vec3<f32>(((((_e2215 * _e2205) + (_e2233 * _e2207)) + (_e2251 * _e2209)) * _e2203), ((((_e2221 * _e2205) + (_e2239 * _e2207)) + (_e2257 * _e2209)) * _e2203), ((((_e2227 * _e2205) + (_e2245 * _e2207)) + (_e2263 * _e2209)) * _e2203)), _e2188.member, vec3<f32>(((((_e2215 * _e2188.member_2.x) + (_e2233 * _e2188.member_2.y)) + (_e2251 * _e2188.member_2.z)) * _e2203), ((((_e2221 * _e2188.member_2.x) + (_e2239 * _e2188.member_2.y)) + (_e2257 * _e2188.member_2.z)) * _e2203), ((((_e2227 * _e2188.member_2.x) + (_e2245 * _e2188.member_2.y)) + (_e2263 * _e2188.member_2.z)) * _e2203)), vec3<f32>(((((_e2215 * _e2188.member_1.x) + (_e2233 * _e2188.member_1.y)) + (_e2251 * _e2188.member_1.z)) * _e2203), ((((_e2221 * _e2188.member_1.x) + (_e2239 * _e2188.member_1.y)) + (_e2257 * _e2188.member_1.z)) * _e2203), ((((_e2227 * _e2188.member_1.x) + (_e2245 * _e2188.member_1.y)) + (_e2263 * _e2188.member_1.z)) * _e2203)));
} else {
let _e2332 = global_1.member.member_6.member_3.member;
let _e2333 = (_e2332 - 0.5f);
let _e2335 = select(-0.5f, _e703, (_e703 > -0.5f));
let _e2337 = select(_e2333, _e2335, (_e2335 < _e2333));
let _e2342 = global_1.member.member_6.member_3.member_1;
let _e2343 = (_e2342 - 0.5f);
let _e2345 = select(-0.5f, _e709, (_e709 > -0.5f));
let _e2347 = select(_e2343, _e2345, (_e2345 < _e2343));
let _e2352 = global_1.member.member_6.member_3.member_2;
let _e2353 = (_e2352 - 0.5f);
let _e2355 = select(-0.5f, _e715, (_e715 > -0.5f));
let _e2357 = select(_e2353, _e2355, (_e2355 < _e2353));
let _e2359 = select(-1f, _e2337, (_e2337 > -1f));
let _e2361 = select(_e2332, _e2359, (_e2359 < _e2332));
let _e2368 = select(0i, select(select(i32(_e2361), i32(-2147483648), (_e2361 < -2147483600f)), 2147483647i, (_e2361 > 2147483500f)), (_e2361 == _e2361));
let _e2372 = (_e2368 - select(0i, 1i, (_e2361 < f32(_e2368))));
let _e2374 = select(-1f, _e2347, (_e2347 > -1f));
let _e2376 = select(_e2342, _e2374, (_e2374 < _e2342));
let _e2383 = select(0i, select(select(i32(_e2376), i32(-2147483648), (_e2376 < -2147483600f)), 2147483647i, (_e2376 > 2147483500f)), (_e2376 == _e2376));
let _e2387 = (_e2383 - select(0i, 1i, (_e2376 < f32(_e2383))));
let _e2389 = select(-1f, _e2357, (_e2357 > -1f));
let _e2391 = select(_e2352, _e2389, (_e2389 < _e2352));
let _e2398 = select(0i, select(select(i32(_e2391), i32(-2147483648), (_e2391 < -2147483600f)), 2147483647i, (_e2391 > 2147483500f)), (_e2391 == _e2391));
let _e2402 = (_e2398 - select(0i, 1i, (_e2391 < f32(_e2398))));
let _e2406 = global_1.member.member_6.member_7;
let _e2410 = global_1.member.member_6.member_8;
let _e2411 = (_e2372 + 1i);
let _e2412 = (_e2387 + 1i);
let _e2413 = (_e2402 + 1i);
let _e2418 = global_1.member.member_6.member_11.member;
let _e2424 = global_1.member.member_6.member_11.member_1;
let _e2435 = ((_e2411 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2418) * ((_e2412 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2424) * (_e2413 >> bitcast<u32>(4i))))));
let _e2437 = (bitcast<i32>(_e89) - 1i);
let _e2439 = select(_e2437, _e2435, (_e2435 < _e2437));
let _e2445 = global_2.member[bitcast<u32>(select(0i, _e2439, (_e2439 > 0i)))];
let _e2447 = (_e2411 & 15i);
let _e2450 = ((_e2412 & 15i) * _e2406);
let _e2452 = (bitcast<i32>(_e2445) + ((_e2413 & 15i) * _e2410));
let _e2456 = (_e2450 + _e2406);
let _e2458 = (_e2450 + (2i * _e2406));
let _e2459 = (_e2452 + _e2410);
let _e2461 = (_e2452 + (2i * _e2410));
local_2 = type_28(array<i32, 4>(_e2447, (_e2447 + 1i), (_e2447 + 2i), (_e2447 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_3 = vec3<f32>((_e2337 - f32(_e2372)), (_e2347 - f32(_e2387)), (_e2357 - f32(_e2402)));
let _e2475 = local_2.member[1u];
let _e2476 = ((_e2459 + _e2456) + _e2475);
let _e2478 = (_e2476 >> bitcast<u32>(1i));
let _e2481 = bitcast<u32>(((_e2476 & 1i) * 16i));
let _e2483 = select(_e2437, _e2478, (_e2478 < _e2437));
let _e2488 = global_2.member[bitcast<u32>(select(0i, _e2483, (_e2483 > 0i)))];
let _e2492 = (_e2478 + 1i);
let _e2494 = select(_e2437, _e2492, (_e2492 < _e2437));
let _e2499 = global_2.member[bitcast<u32>(select(0i, _e2494, (_e2494 > 0i)))];
let _e2506 = ((_e2488 >> bitcast<u32>((_e2481 & 31u))) | ((_e2499 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2481) & 31u))));
let _e2509 = local_2.member_1[2u];
let _e2515 = f32(bitcast<i32>(((_e2506 >> bitcast<u32>((_e2509 & 31u))) & 65535u)));
let _e2518 = local_2.member_1[3u];
let _e2525 = local_3[0u];
let _e2528 = (_e2515 + ((f32(bitcast<i32>(((_e2506 >> bitcast<u32>((_e2518 & 31u))) & 65535u))) - _e2515) * _e2525));
let _e2530 = local_2.member[1u];
let _e2531 = ((_e2459 + _e2458) + _e2530);
let _e2533 = (_e2531 >> bitcast<u32>(1i));
let _e2536 = bitcast<u32>(((_e2531 & 1i) * 16i));
let _e2538 = select(_e2437, _e2533, (_e2533 < _e2437));
let _e2543 = global_2.member[bitcast<u32>(select(0i, _e2538, (_e2538 > 0i)))];
let _e2547 = (_e2533 + 1i);
let _e2549 = select(_e2437, _e2547, (_e2547 < _e2437));
let _e2554 = global_2.member[bitcast<u32>(select(0i, _e2549, (_e2549 > 0i)))];
let _e2561 = ((_e2543 >> bitcast<u32>((_e2536 & 31u))) | ((_e2554 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2536) & 31u))));
let _e2562 = local_2.member_1[2u];
let _e2568 = f32(bitcast<i32>(((_e2561 >> bitcast<u32>((_e2562 & 31u))) & 65535u)));
let _e2569 = local_2.member_1[3u];
let _e2576 = local_3[0u];
let _e2581 = local_3[1u];
let _e2584 = (_e2528 + (((_e2568 + ((f32(bitcast<i32>(((_e2561 >> bitcast<u32>((_e2569 & 31u))) & 65535u))) - _e2568) * _e2576)) - _e2528) * _e2581));
let _e2586 = local_2.member[1u];
let _e2587 = ((_e2461 + _e2456) + _e2586);
let _e2589 = (_e2587 >> bitcast<u32>(1i));
let _e2592 = bitcast<u32>(((_e2587 & 1i) * 16i));
let _e2594 = select(_e2437, _e2589, (_e2589 < _e2437));
let _e2599 = global_2.member[bitcast<u32>(select(0i, _e2594, (_e2594 > 0i)))];
let _e2603 = (_e2589 + 1i);
let _e2605 = select(_e2437, _e2603, (_e2603 < _e2437));
let _e2610 = global_2.member[bitcast<u32>(select(0i, _e2605, (_e2605 > 0i)))];
let _e2617 = ((_e2599 >> bitcast<u32>((_e2592 & 31u))) | ((_e2610 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2592) & 31u))));
let _e2618 = local_2.member_1[2u];
let _e2624 = f32(bitcast<i32>(((_e2617 >> bitcast<u32>((_e2618 & 31u))) & 65535u)));
let _e2625 = local_2.member_1[3u];
let _e2632 = local_3[0u];
let _e2635 = (_e2624 + ((f32(bitcast<i32>(((_e2617 >> bitcast<u32>((_e2625 & 31u))) & 65535u))) - _e2624) * _e2632));
let _e2637 = local_2.member[1u];
let _e2638 = ((_e2461 + _e2458) + _e2637);
let _e2640 = (_e2638 >> bitcast<u32>(1i));
let _e2643 = bitcast<u32>(((_e2638 & 1i) * 16i));
let _e2645 = select(_e2437, _e2640, (_e2640 < _e2437));
let _e2650 = global_2.member[bitcast<u32>(select(0i, _e2645, (_e2645 > 0i)))];
let _e2654 = (_e2640 + 1i);
let _e2656 = select(_e2437, _e2654, (_e2654 < _e2437));
let _e2661 = global_2.member[bitcast<u32>(select(0i, _e2656, (_e2656 > 0i)))];
let _e2668 = ((_e2650 >> bitcast<u32>((_e2643 & 31u))) | ((_e2661 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2643) & 31u))));
let _e2669 = local_2.member_1[2u];
let _e2675 = f32(bitcast<i32>(((_e2668 >> bitcast<u32>((_e2669 & 31u))) & 65535u)));
let _e2676 = local_2.member_1[3u];
let _e2683 = local_3[0u];
let _e2687 = local_3[1u];
let _e2692 = local_3[2u];
let _e2699 = global_1.member.member_6.member_5;
let _e2704 = global_1.member.member_6.member_6;
let _e2705 = (((_e2584 + (((_e2635 + (((_e2675 + ((f32(bitcast<i32>(((_e2668 >> bitcast<u32>((_e2676 & 31u))) & 65535u))) - _e2675) * _e2683)) - _e2635) * _e2687)) - _e2584) * _e2692)) * _e2699) + _e2704);
let _e2707 = select(0f, _e2705, (_e2705 > 0f));
phi_4207_ = type_30(select(1f, _e2707, (_e2707 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2712 = phi_4207_;
let _e2717 = global_1.member.member_6.member_3.member;
let _e2718 = (_e2717 - 0.5f);
let _e2720 = select(-0.5f, _e667, (_e667 > -0.5f));
let _e2722 = select(_e2718, _e2720, (_e2720 < _e2718));
let _e2727 = global_1.member.member_6.member_3.member_1;
let _e2728 = (_e2727 - 0.5f);
let _e2730 = select(-0.5f, _e682, (_e682 > -0.5f));
let _e2732 = select(_e2728, _e2730, (_e2730 < _e2728));
let _e2737 = global_1.member.member_6.member_3.member_2;
let _e2738 = (_e2737 - 0.5f);
let _e2740 = select(-0.5f, _e697, (_e697 > -0.5f));
let _e2742 = select(_e2738, _e2740, (_e2740 < _e2738));
let _e2744 = select(-1f, _e2722, (_e2722 > -1f));
let _e2746 = select(_e2717, _e2744, (_e2744 < _e2717));
let _e2753 = select(0i, select(select(i32(_e2746), i32(-2147483648), (_e2746 < -2147483600f)), 2147483647i, (_e2746 > 2147483500f)), (_e2746 == _e2746));
let _e2757 = (_e2753 - select(0i, 1i, (_e2746 < f32(_e2753))));
let _e2759 = select(-1f, _e2732, (_e2732 > -1f));
let _e2761 = select(_e2727, _e2759, (_e2759 < _e2727));
let _e2768 = select(0i, select(select(i32(_e2761), i32(-2147483648), (_e2761 < -2147483600f)), 2147483647i, (_e2761 > 2147483500f)), (_e2761 == _e2761));
let _e2772 = (_e2768 - select(0i, 1i, (_e2761 < f32(_e2768))));
let _e2774 = select(-1f, _e2742, (_e2742 > -1f));
let _e2776 = select(_e2737, _e2774, (_e2774 < _e2737));
let _e2783 = select(0i, select(select(i32(_e2776), i32(-2147483648), (_e2776 < -2147483600f)), 2147483647i, (_e2776 > 2147483500f)), (_e2776 == _e2776));
let _e2787 = (_e2783 - select(0i, 1i, (_e2776 < f32(_e2783))));
let _e2791 = global_1.member.member_6.member_7;
let _e2795 = global_1.member.member_6.member_8;
let _e2796 = (_e2757 + 1i);
let _e2797 = (_e2772 + 1i);
let _e2798 = (_e2787 + 1i);
let _e2803 = global_1.member.member_6.member_11.member;
let _e2809 = global_1.member.member_6.member_11.member_1;
let _e2820 = ((_e2796 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2803) * ((_e2797 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2809) * (_e2798 >> bitcast<u32>(4i))))));
let _e2822 = (bitcast<i32>(_e89) - 1i);
let _e2824 = select(_e2822, _e2820, (_e2820 < _e2822));
let _e2830 = global_2.member[bitcast<u32>(select(0i, _e2824, (_e2824 > 0i)))];
let _e2832 = (_e2796 & 15i);
let _e2835 = ((_e2797 & 15i) * _e2791);
let _e2837 = (bitcast<i32>(_e2830) + ((_e2798 & 15i) * _e2795));
let _e2841 = (_e2835 + _e2791);
let _e2843 = (_e2835 + (2i * _e2791));
let _e2844 = (_e2837 + _e2795);
let _e2846 = (_e2837 + (2i * _e2795));
local = type_28(array<i32, 4>(_e2832, (_e2832 + 1i), (_e2832 + 2i), (_e2832 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_1 = vec3<f32>((_e2722 - f32(_e2757)), (_e2732 - f32(_e2772)), (_e2742 - f32(_e2787)));
let _e2860 = local.member[1u];
let _e2861 = ((_e2844 + _e2841) + _e2860);
let _e2863 = (_e2861 >> bitcast<u32>(1i));
let _e2866 = bitcast<u32>(((_e2861 & 1i) * 16i));
let _e2868 = select(_e2822, _e2863, (_e2863 < _e2822));
let _e2873 = global_2.member[bitcast<u32>(select(0i, _e2868, (_e2868 > 0i)))];
let _e2877 = (_e2863 + 1i);
let _e2879 = select(_e2822, _e2877, (_e2877 < _e2822));
let _e2884 = global_2.member[bitcast<u32>(select(0i, _e2879, (_e2879 > 0i)))];
let _e2891 = ((_e2873 >> bitcast<u32>((_e2866 & 31u))) | ((_e2884 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2866) & 31u))));
let _e2894 = local.member_1[2u];
let _e2900 = f32(bitcast<i32>(((_e2891 >> bitcast<u32>((_e2894 & 31u))) & 65535u)));
let _e2903 = local.member_1[3u];
let _e2910 = local_1[0u];
let _e2913 = (_e2900 + ((f32(bitcast<i32>(((_e2891 >> bitcast<u32>((_e2903 & 31u))) & 65535u))) - _e2900) * _e2910));
let _e2915 = local.member[1u];
let _e2916 = ((_e2844 + _e2843) + _e2915);
let _e2918 = (_e2916 >> bitcast<u32>(1i));
let _e2921 = bitcast<u32>(((_e2916 & 1i) * 16i));
let _e2923 = select(_e2822, _e2918, (_e2918 < _e2822));
let _e2928 = global_2.member[bitcast<u32>(select(0i, _e2923, (_e2923 > 0i)))];
let _e2932 = (_e2918 + 1i);
let _e2934 = select(_e2822, _e2932, (_e2932 < _e2822));
let _e2939 = global_2.member[bitcast<u32>(select(0i, _e2934, (_e2934 > 0i)))];
let _e2946 = ((_e2928 >> bitcast<u32>((_e2921 & 31u))) | ((_e2939 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2921) & 31u))));
let _e2947 = local.member_1[2u];
let _e2953 = f32(bitcast<i32>(((_e2946 >> bitcast<u32>((_e2947 & 31u))) & 65535u)));
let _e2954 = local.member_1[3u];
let _e2961 = local_1[0u];
let _e2966 = local_1[1u];
let _e2969 = (_e2913 + (((_e2953 + ((f32(bitcast<i32>(((_e2946 >> bitcast<u32>((_e2954 & 31u))) & 65535u))) - _e2953) * _e2961)) - _e2913) * _e2966));
let _e2971 = local.member[1u];
let _e2972 = ((_e2846 + _e2841) + _e2971);
let _e2974 = (_e2972 >> bitcast<u32>(1i));
let _e2977 = bitcast<u32>(((_e2972 & 1i) * 16i));
let _e2979 = select(_e2822, _e2974, (_e2974 < _e2822));
let _e2984 = global_2.member[bitcast<u32>(select(0i, _e2979, (_e2979 > 0i)))];
let _e2988 = (_e2974 + 1i);
let _e2990 = select(_e2822, _e2988, (_e2988 < _e2822));
let _e2995 = global_2.member[bitcast<u32>(select(0i, _e2990, (_e2990 > 0i)))];
let _e3002 = ((_e2984 >> bitcast<u32>((_e2977 & 31u))) | ((_e2995 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2977) & 31u))));
let _e3003 = local.member_1[2u];
let _e3009 = f32(bitcast<i32>(((_e3002 >> bitcast<u32>((_e3003 & 31u))) & 65535u)));
let _e3010 = local.member_1[3u];
let _e3017 = local_1[0u];
let _e3020 = (_e3009 + ((f32(bitcast<i32>(((_e3002 >> bitcast<u32>((_e3010 & 31u))) & 65535u))) - _e3009) * _e3017));
let _e3022 = local.member[1u];
let _e3023 = ((_e2846 + _e2843) + _e3022);
let _e3025 = (_e3023 >> bitcast<u32>(1i));
let _e3028 = bitcast<u32>(((_e3023 & 1i) * 16i));
let _e3030 = select(_e2822, _e3025, (_e3025 < _e2822));
let _e3035 = global_2.member[bitcast<u32>(select(0i, _e3030, (_e3030 > 0i)))];
let _e3039 = (_e3025 + 1i);
let _e3041 = select(_e2822, _e3039, (_e3039 < _e2822));
let _e3046 = global_2.member[bitcast<u32>(select(0i, _e3041, (_e3041 > 0i)))];
let _e3053 = ((_e3035 >> bitcast<u32>((_e3028 & 31u))) | ((_e3046 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3028) & 31u))));
let _e3054 = local.member_1[2u];
let _e3060 = f32(bitcast<i32>(((_e3053 >> bitcast<u32>((_e3054 & 31u))) & 65535u)));
let _e3061 = local.member_1[3u];
let _e3068 = local_1[0u];
let _e3072 = local_1[1u];
let _e3077 = local_1[2u];
let _e3084 = global_1.member.member_6.member_5;
let _e3089 = global_1.member.member_6.member_6;
let _e3090 = (((_e2969 + (((_e3020 + (((_e3060 + ((f32(bitcast<i32>(((_e3053 >> bitcast<u32>((_e3061 & 31u))) & 65535u))) - _e3060) * _e3068)) - _e3020) * _e3072)) - _e2969) * _e3077)) * _e3084) + _e3089);
let _e3092 = select(0f, _e3090, (_e3090 > 0f));
let _e3094 = select(1f, _e3092, (_e3092 < 1f));
let _e3097 = global_1.member.member_1;
if ((_e3097 & 16u) == 0u) {
phi_5095_ = type_5(1f, 1f, 1f);
} else {
let _e3103 = global_1.member.member_14.member;
let _e3114 = ((((_e3103.member.member * _e624) + (_e3103.member.member_1 * _e637)) + (_e3103.member.member_2 * _e602)) + _e3103.member_1);
let _e3120 = ((((_e3103.member.member * _e647) + (_e3103.member.member_1 * _e652)) + (_e3103.member.member_2 * _e641)) + _e3103.member_1);
let _e3122 = select(_e3120, _e3114, (_e3114 < _e3120));
let _e3124 = select(_e3120, _e3114, (_e3114 > _e3120));
let _e3126 = (_e3124 - _e3122);
let _e3129 = (-(_e3122) / select(1e-30f, _e3126, (_e3126 > 1e-30f)));
let _e3131 = select(0f, _e3129, (_e3129 > 0f));
let _e3137 = select(select(select(1f, _e3131, (_e3131 < 1f)), 1f, (_e3124 <= 0f)), 0f, (_e3122 > 0f));
let _e3142 = global_1.member.member_14.member_1;
let _e3143 = (_e3142 != 0u);
let _e3153 = global_1.member.member_15.member;
let _e3164 = ((((_e3153.member.member * _e624) + (_e3153.member.member_1 * _e637)) + (_e3153.member.member_2 * _e602)) + _e3153.member_1);
let _e3170 = ((((_e3153.member.member * _e647) + (_e3153.member.member_1 * _e652)) + (_e3153.member.member_2 * _e641)) + _e3153.member_1);
let _e3172 = select(_e3170, _e3164, (_e3164 < _e3170));
let _e3174 = select(_e3170, _e3164, (_e3164 > _e3170));
let _e3176 = (_e3174 - _e3172);
let _e3179 = (-(_e3172) / select(1e-30f, _e3176, (_e3176 > 1e-30f)));
let _e3181 = select(0f, _e3179, (_e3179 > 0f));
let _e3187 = select(select(select(1f, _e3181, (_e3181 < 1f)), 1f, (_e3174 <= 0f)), 0f, (_e3172 > 0f));
let _e3192 = global_1.member.member_15.member_1;
let _e3193 = (_e3192 != 0u);
let _e3203 = global_1.member.member_16.member;
let _e3214 = ((((_e3203.member.member * _e624) + (_e3203.member.member_1 * _e637)) + (_e3203.member.member_2 * _e602)) + _e3203.member_1);
let _e3220 = ((((_e3203.member.member * _e647) + (_e3203.member.member_1 * _e652)) + (_e3203.member.member_2 * _e641)) + _e3203.member_1);
let _e3222 = select(_e3220, _e3214, (_e3214 < _e3220));
let _e3224 = select(_e3220, _e3214, (_e3214 > _e3220));
let _e3226 = (_e3224 - _e3222);
let _e3229 = (-(_e3222) / select(1e-30f, _e3226, (_e3226 > 1e-30f)));
let _e3231 = select(0f, _e3229, (_e3229 > 0f));
let _e3237 = select(select(select(1f, _e3231, (_e3231 < 1f)), 1f, (_e3224 <= 0f)), 0f, (_e3222 > 0f));
let _e3242 = global_1.member.member_16.member_1;
let _e3243 = (_e3242 != 0u);
let _e3253 = global_1.member.member_17.member;
let _e3264 = ((((_e3253.member.member * _e624) + (_e3253.member.member_1 * _e637)) + (_e3253.member.member_2 * _e602)) + _e3253.member_1);
let _e3270 = ((((_e3253.member.member * _e647) + (_e3253.member.member_1 * _e652)) + (_e3253.member.member_2 * _e641)) + _e3253.member_1);
let _e3272 = select(_e3270, _e3264, (_e3264 < _e3270));
let _e3274 = select(_e3270, _e3264, (_e3264 > _e3270));
let _e3276 = (_e3274 - _e3272);
let _e3279 = (-(_e3272) / select(1e-30f, _e3276, (_e3276 > 1e-30f)));
let _e3281 = select(0f, _e3279, (_e3279 > 0f));
let _e3287 = select(select(select(1f, _e3281, (_e3281 < 1f)), 1f, (_e3274 <= 0f)), 0f, (_e3272 > 0f));
let _e3292 = global_1.member.member_17.member_1;
let _e3293 = (_e3292 != 0u);
phi_5095_ = type_5(((((1f * _e3137) * _e3187) * _e3237) * _e3287), ((((1f * select(1f, _e3137, _e3143)) * select(1f, _e3187, _e3193)) * select(1f, _e3237, _e3243)) * select(1f, _e3287, _e3293)), ((((1f * select(1f, 0f, (_e3143 && (_e3120 > 0f)))) * select(1f, 0f, (_e3193 && (_e3170 > 0f)))) * select(1f, 0f, (_e3243 && (_e3220 > 0f)))) * select(1f, 0f, (_e3293 && (_e3270 > 0f)))));
}
let _e3302 = phi_5095_;
let _e3303 = (_e703 - _e667);
let _e3307 = (bitcast<f32>((bitcast<u32>(_e3303) & 2147483647u)) < 1e-12f);
let _e3309 = (1f / select(_e3303, 1f, _e3307));
let _e3311 = ((-0.5f - _e667) * _e3309);
let _e3313 = ((_e2718 - _e667) * _e3309);
let _e3319 = select(_e3313, _e3311, (_e3311 < _e3313));
let _e3321 = select(0f, _e3319, (_e3319 > 0f));
let _e3324 = select(select(1f, _e3321, (_e3321 < 1f)), select(2f, 0f, ((_e667 >= -0.5f) && (_e667 <= _e2718))), _e3307);
let _e3326 = select(_e3313, _e3311, (_e3311 > _e3313));
let _e3328 = select(0f, _e3326, (_e3326 > 0f));
let _e3331 = select(select(1f, _e3328, (_e3328 < 1f)), 1f, _e3307);
let _e3332 = (_e709 - _e682);
let _e3336 = (bitcast<f32>((bitcast<u32>(_e3332) & 2147483647u)) < 1e-12f);
let _e3338 = (1f / select(_e3332, 1f, _e3336));
let _e3340 = ((-0.5f - _e682) * _e3338);
let _e3342 = ((_e2728 - _e682) * _e3338);
let _e3348 = select(_e3342, _e3340, (_e3340 < _e3342));
let _e3350 = select(0f, _e3348, (_e3348 > 0f));
let _e3353 = select(select(1f, _e3350, (_e3350 < 1f)), select(2f, 0f, ((_e682 >= -0.5f) && (_e682 <= _e2728))), _e3336);
let _e3355 = select(_e3342, _e3340, (_e3340 > _e3342));
let _e3357 = select(0f, _e3355, (_e3355 > 0f));
let _e3360 = select(select(1f, _e3357, (_e3357 < 1f)), 1f, _e3336);
let _e3361 = (_e715 - _e697);
let _e3365 = (bitcast<f32>((bitcast<u32>(_e3361) & 2147483647u)) < 1e-12f);
let _e3367 = (1f / select(_e3361, 1f, _e3365));
let _e3369 = ((-0.5f - _e697) * _e3367);
let _e3371 = ((_e2738 - _e697) * _e3367);
let _e3377 = select(_e3371, _e3369, (_e3369 < _e3371));
let _e3379 = select(0f, _e3377, (_e3377 > 0f));
let _e3382 = select(select(1f, _e3379, (_e3379 < 1f)), select(2f, 0f, ((_e697 >= -0.5f) && (_e697 <= _e2738))), _e3365);
let _e3384 = select(_e3371, _e3369, (_e3369 > _e3371));
let _e3386 = select(0f, _e3384, (_e3384 > 0f));
let _e3389 = select(select(1f, _e3386, (_e3386 < 1f)), 1f, _e3365);
let _e3391 = select(_e3360, _e3331, (_e3331 < _e3360));
let _e3395 = select(_e3353, _e3324, (_e3324 > _e3353));
let _e3398 = (select(_e3389, _e3391, (_e3391 < _e3389)) - select(_e3382, _e3395, (_e3395 > _e3382)));
let _e3401 = (_e647 - _e624);
let _e3402 = (_e652 - _e637);
let _e3403 = (_e641 - _e602);
let _e3408 = (((_e3401 * _e3401) + (_e3402 * _e3402)) + (_e3403 * _e3403));
let _e3416 = global_1.member.member_5.member_3;
let _e3417 = ((sqrt(select(0f, _e3408, (_e3408 > 0f))) * select(0f, _e3398, (_e3398 > 0f))) * _e3416);
if (_e103.member_2 >= 3u) {
let _e3420 = (_e3094 * 255f);
let _e3421 = (_e2712.member * 255f);
let _e3422 = (255f - 1f);
let _e3424 = select(0f, _e3420, (_e3420 > 0f));
let _e3426 = select(_e3422, _e3424, (_e3424 < _e3422));
let _e3433 = select(0i, select(select(i32(_e3426), i32(-2147483648), (_e3426 < -2147483600f)), 2147483647i, (_e3426 > 2147483500f)), (_e3426 == _e3426));
let _e3437 = (_e3433 - select(0i, 1i, (_e3426 < f32(_e3433))));
let _e3439 = select(0f, _e3421, (_e3421 > 0f));
let _e3441 = select(_e3422, _e3439, (_e3439 < _e3422));
let _e3448 = select(0i, select(select(i32(_e3441), i32(-2147483648), (_e3441 < -2147483600f)), 2147483647i, (_e3441 > 2147483500f)), (_e3441 == _e3441));
let _e3452 = (_e3448 - select(0i, 1i, (_e3441 < f32(_e3448))));
let _e3455 = (((_e3437 * 256i) + _e3452) * 4i);
let _e3459 = (_e3421 - f32(_e3452));
let _e3461 = (bitcast<i32>(_e93) - 1i);
let _e3463 = select(_e3461, _e3455, (_e3455 < _e3461));
let _e3469 = global_4.member[bitcast<u32>(select(0i, _e3463, (_e3463 > 0i)))];
let _e3470 = (_e3455 + 4i);
let _e3472 = select(_e3461, _e3470, (_e3470 < _e3461));
let _e3478 = global_4.member[bitcast<u32>(select(0i, _e3472, (_e3472 > 0i)))];
let _e3479 = (_e3455 + 1024i);
let _e3481 = select(_e3461, _e3479, (_e3479 < _e3461));
let _e3487 = global_4.member[bitcast<u32>(select(0i, _e3481, (_e3481 > 0i)))];
let _e3488 = (_e3455 + 1028i);
let _e3490 = select(_e3461, _e3488, (_e3488 < _e3461));
let _e3496 = global_4.member[bitcast<u32>(select(0i, _e3490, (_e3490 > 0i)))];
let _e3501 = (bitcast<f32>(((_e3469 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3509 = (_e3501 + (((bitcast<f32>(((_e3478 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3501) * _e3459));
let _e3514 = (bitcast<f32>(((_e3487 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3525 = (_e3509 + (((_e3514 + (((bitcast<f32>(((_e3496 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3514) * _e3459)) - _e3509) * (_e3420 - f32(_e3437))));
let _e3529 = -((_e3525 * (_e3417 * _e3302.member)));
let _e3531 = select(-87f, _e3529, (_e3529 > -87f));
let _e3533 = select(88f, _e3531, (_e3531 < 88f));
let _e3535 = ((_e3533 * 1.442695f) + 0.5f);
let _e3537 = select(-127f, _e3535, (_e3535 > -127f));
let _e3539 = select(128f, _e3537, (_e3537 < 128f));
let _e3546 = select(0i, select(select(i32(_e3539), i32(-2147483648), (_e3539 < -2147483600f)), 2147483647i, (_e3539 > 2147483500f)), (_e3539 == _e3539));
let _e3550 = (_e3546 - select(0i, 1i, (_e3539 < f32(_e3546))));
let _e3551 = f32(_e3550);
let _e3555 = ((_e3533 - (_e3551 * 0.6933594f)) - (_e3551 * -2.1219444e-4f));
let _e3575 = ((1f + (_e3555 * (1f + (_e3555 * (0.5f + (_e3555 * (0.16666667f + (_e3555 * (0.041666668f + (_e3555 * (0.008333334f + (_e3555 * (0.001388889f + (_e3555 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3550 + 127i)) << bitcast<u32>(23i))));
let _e3576 = (1f - _e3575);
phi_6205_ = type_31(_e3575, _e3576, vec3<f32>(1f, 1f, 1f), vec3((0f * (_e3576 / select(1e-12f, _e3525, (_e3525 > 1e-12f))))));
} else {
let _e3584 = (_e3094 * 255f);
let _e3585 = (_e2712.member * 255f);
let _e3586 = (255f - 1f);
let _e3588 = select(0f, _e3584, (_e3584 > 0f));
let _e3590 = select(_e3586, _e3588, (_e3588 < _e3586));
let _e3597 = select(0i, select(select(i32(_e3590), i32(-2147483648), (_e3590 < -2147483600f)), 2147483647i, (_e3590 > 2147483500f)), (_e3590 == _e3590));
let _e3601 = (_e3597 - select(0i, 1i, (_e3590 < f32(_e3597))));
let _e3603 = select(0f, _e3585, (_e3585 > 0f));
let _e3605 = select(_e3586, _e3603, (_e3603 < _e3586));
let _e3612 = select(0i, select(select(i32(_e3605), i32(-2147483648), (_e3605 < -2147483600f)), 2147483647i, (_e3605 > 2147483500f)), (_e3605 == _e3605));
let _e3616 = (_e3612 - select(0i, 1i, (_e3605 < f32(_e3612))));
let _e3619 = (((_e3601 * 256i) + _e3616) * 4i);
let _e3621 = (_e3584 - f32(_e3601));
let _e3623 = (_e3585 - f32(_e3616));
let _e3625 = (bitcast<i32>(_e93) - 1i);
let _e3627 = select(_e3625, _e3619, (_e3619 < _e3625));
let _e3633 = global_4.member[bitcast<u32>(select(0i, _e3627, (_e3627 > 0i)))];
let _e3634 = (_e3619 + 4i);
let _e3636 = select(_e3625, _e3634, (_e3634 < _e3625));
let _e3642 = global_4.member[bitcast<u32>(select(0i, _e3636, (_e3636 > 0i)))];
let _e3643 = (_e3619 + 1024i);
let _e3645 = select(_e3625, _e3643, (_e3643 < _e3625));
let _e3651 = global_4.member[bitcast<u32>(select(0i, _e3645, (_e3645 > 0i)))];
let _e3652 = (_e3619 + 1028i);
let _e3654 = select(_e3625, _e3652, (_e3652 < _e3625));
let _e3660 = global_4.member[bitcast<u32>(select(0i, _e3654, (_e3654 > 0i)))];
let _e3665 = (bitcast<f32>(((_e3633 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3673 = (_e3665 + (((bitcast<f32>(((_e3642 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3665) * _e3623));
let _e3678 = (bitcast<f32>(((_e3651 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3689 = (_e3673 + (((_e3678 + (((bitcast<f32>(((_e3660 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3678) * _e3623)) - _e3673) * _e3621));
let _e3702 = (bitcast<f32>((((_e3633 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3710 = (_e3702 + (((bitcast<f32>((((_e3642 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3702) * _e3623));
let _e3715 = (bitcast<f32>((((_e3651 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3727 = (_e3619 + 1i);
let _e3729 = select(_e3625, _e3727, (_e3727 < _e3625));
let _e3735 = global_4.member[bitcast<u32>(select(0i, _e3729, (_e3729 > 0i)))];
let _e3736 = (_e3619 + 5i);
let _e3738 = select(_e3625, _e3736, (_e3736 < _e3625));
let _e3744 = global_4.member[bitcast<u32>(select(0i, _e3738, (_e3738 > 0i)))];
let _e3745 = (_e3619 + 1025i);
let _e3747 = select(_e3625, _e3745, (_e3745 < _e3625));
let _e3753 = global_4.member[bitcast<u32>(select(0i, _e3747, (_e3747 > 0i)))];
let _e3754 = (_e3619 + 1029i);
let _e3756 = select(_e3625, _e3754, (_e3754 < _e3625));
let _e3762 = global_4.member[bitcast<u32>(select(0i, _e3756, (_e3756 > 0i)))];
let _e3767 = (bitcast<f32>(((_e3735 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3775 = (_e3767 + (((bitcast<f32>(((_e3744 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3767) * _e3623));
let _e3780 = (bitcast<f32>(((_e3753 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3804 = (bitcast<f32>((((_e3735 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3812 = (_e3804 + (((bitcast<f32>((((_e3744 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3804) * _e3623));
let _e3817 = (bitcast<f32>((((_e3753 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3832 = (_e3417 * _e3302.member_1);
let _e3834 = -(((_e3710 + (((_e3715 + (((bitcast<f32>((((_e3660 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3715) * _e3623)) - _e3710) * _e3621)) * _e3832));
let _e3836 = select(-87f, _e3834, (_e3834 > -87f));
let _e3838 = select(88f, _e3836, (_e3836 < 88f));
let _e3840 = ((_e3838 * 1.442695f) + 0.5f);
let _e3842 = select(-127f, _e3840, (_e3840 > -127f));
let _e3844 = select(128f, _e3842, (_e3842 < 128f));
let _e3851 = select(0i, select(select(i32(_e3844), i32(-2147483648), (_e3844 < -2147483600f)), 2147483647i, (_e3844 > 2147483500f)), (_e3844 == _e3844));
let _e3855 = (_e3851 - select(0i, 1i, (_e3844 < f32(_e3851))));
let _e3856 = f32(_e3855);
let _e3860 = ((_e3838 - (_e3856 * 0.6933594f)) - (_e3856 * -2.1219444e-4f));
let _e3882 = -(((_e3775 + (((_e3780 + (((bitcast<f32>(((_e3762 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3780) * _e3623)) - _e3775) * _e3621)) * _e3832));
let _e3884 = select(-87f, _e3882, (_e3882 > -87f));
let _e3886 = select(88f, _e3884, (_e3884 < 88f));
let _e3888 = ((_e3886 * 1.442695f) + 0.5f);
let _e3890 = select(-127f, _e3888, (_e3888 > -127f));
let _e3892 = select(128f, _e3890, (_e3890 < 128f));
let _e3899 = select(0i, select(select(i32(_e3892), i32(-2147483648), (_e3892 < -2147483600f)), 2147483647i, (_e3892 > 2147483500f)), (_e3892 == _e3892));
let _e3903 = (_e3899 - select(0i, 1i, (_e3892 < f32(_e3899))));
let _e3904 = f32(_e3903);
let _e3908 = ((_e3886 - (_e3904 * 0.6933594f)) - (_e3904 * -2.1219444e-4f));
let _e3930 = -(((_e3812 + (((_e3817 + (((bitcast<f32>((((_e3762 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3817) * _e3623)) - _e3812) * _e3621)) * _e3832));
let _e3932 = select(-87f, _e3930, (_e3930 > -87f));
let _e3934 = select(88f, _e3932, (_e3932 < 88f));
let _e3936 = ((_e3934 * 1.442695f) + 0.5f);
let _e3938 = select(-127f, _e3936, (_e3936 > -127f));
let _e3940 = select(128f, _e3938, (_e3938 < 128f));
let _e3947 = select(0i, select(select(i32(_e3940), i32(-2147483648), (_e3940 < -2147483600f)), 2147483647i, (_e3940 > 2147483500f)), (_e3940 == _e3940));
let _e3951 = (_e3947 - select(0i, 1i, (_e3940 < f32(_e3947))));
let _e3952 = f32(_e3951);
let _e3956 = ((_e3934 - (_e3952 * 0.6933594f)) - (_e3952 * -2.1219444e-4f));
let _e3979 = -((_e3689 * (_e3417 * _e3302.member)));
let _e3981 = select(-87f, _e3979, (_e3979 > -87f));
let _e3983 = select(88f, _e3981, (_e3981 < 88f));
let _e3985 = ((_e3983 * 1.442695f) + 0.5f);
let _e3987 = select(-127f, _e3985, (_e3985 > -127f));
let _e3989 = select(128f, _e3987, (_e3987 < 128f));
let _e3996 = select(0i, select(select(i32(_e3989), i32(-2147483648), (_e3989 < -2147483600f)), 2147483647i, (_e3989 > 2147483500f)), (_e3989 == _e3989));
let _e4000 = (_e3996 - select(0i, 1i, (_e3989 < f32(_e3996))));
let _e4001 = f32(_e4000);
let _e4005 = ((_e3983 - (_e4001 * 0.6933594f)) - (_e4001 * -2.1219444e-4f));
let _e4025 = ((1f + (_e4005 * (1f + (_e4005 * (0.5f + (_e4005 * (0.16666667f + (_e4005 * (0.041666668f + (_e4005 * (0.008333334f + (_e4005 * (0.001388889f + (_e4005 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4000 + 127i)) << bitcast<u32>(23i))));
let _e4026 = (1f - _e4025);
phi_6205_ = type_31(_e4025, _e4026, vec3<f32>(((1f + (_e3860 * (1f + (_e3860 * (0.5f + (_e3860 * (0.16666667f + (_e3860 * (0.041666668f + (_e3860 * (0.008333334f + (_e3860 * (0.001388889f + (_e3860 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3855 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e3908 * (1f + (_e3908 * (0.5f + (_e3908 * (0.16666667f + (_e3908 * (0.041666668f + (_e3908 * (0.008333334f + (_e3908 * (0.001388889f + (_e3908 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3903 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e3956 * (1f + (_e3956 * (0.5f + (_e3956 * (0.16666667f + (_e3956 * (0.041666668f + (_e3956 * (0.008333334f + (_e3956 * (0.001388889f + (_e3956 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3951 + 127i)) << bitcast<u32>(23i))))), vec3((0f * (_e4026 / select(1e-12f, _e3689, (_e3689 > 1e-12f))))));
}
let _e4034 = phi_6205_;
if _e720 {
let _e4038 = global_1.member.member_5.member_2;
let _e4046 = global_1.member.member_5.member_4;
let _e4049 = (_e2712.member_3.x * _e3302.member_2);
let _e4051 = (_e2712.member_3.y * _e3302.member_2);
let _e4053 = (_e2712.member_3.z * _e3302.member_2);
let _e4054 = (0.5f * (_e4038 / select(1e-6f, _e183, (_e183 > 1e-6f))));
let _e4058 = (_e161 + (_e4049 * _e4054));
let _e4059 = (_e172 + (_e4051 * _e4054));
let _e4060 = (_e183 + (_e4053 * _e4054));
let _e4062 = (2f * _e4038);
let _e4064 = ((_e4060 * _e4060) + (_e4062 * _e4053));
let _e4068 = (_e4060 + sqrt(select(0f, _e4064, (_e4064 > 0f))));
let _e4072 = (0.5f * (_e4062 / select(1e-6f, _e4068, (_e4068 > 1e-6f))));
let _e4076 = (_e4058 + (_e4049 * _e4072));
let _e4077 = (_e4059 + (_e4051 * _e4072));
let _e4078 = (_e4060 + (_e4053 * _e4072));
let _e4082 = (_e4046 * _e4046);
let _e4084 = (_e4078 * _e4078);
let _e4092 = (((_e4060 <= 0f) || (_e4064 <= 0f)) || ((_e4078 <= 0f) || (_e4084 <= (_e4082 * (((_e4076 * _e4076) + (_e4077 * _e4077)) + _e4084)))));
let _e4106 = (_e161 + ((_e2712.member_4.x * _e3302.member_2) * _e4038));
let _e4107 = (_e172 + ((_e2712.member_4.y * _e3302.member_2) * _e4038));
let _e4108 = (_e183 + ((_e2712.member_4.z * _e3302.member_2) * _e4038));
let _e4110 = (_e4108 * _e4108);
let _e4119 = ((_e3097 & 1u) != 0u);
let _e4123 = select(_e4092, ((_e4108 <= 0f) || (_e4110 <= (_e4082 * (((_e4106 * _e4106) + (_e4107 * _e4107)) + _e4110)))), _e4119);
phi_6357_ = vec3<f32>(select(select(select(_e4076, _e4058, _e4092), _e4106, _e4119), _e161, _e4123), select(select(select(_e4077, _e4059, _e4092), _e4107, _e4119), _e172, _e4123), select(select(select(_e4078, _e4060, _e4092), _e4108, _e4119), _e183, _e4123));
phi_6358_ = select(1f, 0f, _e4123);
} else {
phi_6357_ = vec3<f32>(_e161, _e172, _e183);
phi_6358_ = 1f;
}
let _e4130 = phi_6357_;
let _e4132 = phi_6358_;
let _e4135 = (_e4034.member * _e4132);
global_5.member[_e118] = (_e129 * (_e4034.member_2.x * _e4135));
global_5.member[_e130] = (_e139 * (_e4034.member_2.y * _e4135));
global_5.member[_e141] = (_e150 * (_e4034.member_2.z * _e4135));
global_5.member[_e152] = _e4130.x;
global_5.member[_e163] = _e4130.y;
global_5.member[_e174] = _e4130.z;
global_5.member[_e185] = _e194;
global_5.member[_e196] = _e205;
global_5.member[_e207] = _e216;
}
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
