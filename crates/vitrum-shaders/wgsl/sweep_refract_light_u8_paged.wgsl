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
var phi_943_: u32;
var phi_3325_: type_29;
var phi_4027_: type_30;
var phi_4916_: type_5;
var phi_6026_: type_31;
var phi_6177_: f32;
var phi_6178_: f32;
var phi_6179_: f32;
var phi_6180_: f32;
let _e87 = global;
let _e90 = arrayLength((&global_2.member));
let _e94 = arrayLength((&global_4.member));
let _e96 = arrayLength((&global_6.member));
let _e101 = global_1.member.member_2;
let _e104 = global_1.member.member;
let _e112 = (_e87.x + _e101.member);
let _e114 = (_e87.y + _e101.member_1);
if (_e112 < _e101.member_2) {
if (_e114 < _e101.member_3) {
let _e117 = (_e104.member * _e104.member_1);
let _e119 = ((_e114 * _e104.member) + _e112);
let _e120 = bitcast<i32>(_e119);
let _e122 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e124 = select(_e122, _e120, (_e120 < _e122));
let _e130 = global_5.member[bitcast<u32>(select(0i, _e124, (_e124 > 0i)))];
let _e131 = (_e117 + _e119);
let _e132 = bitcast<i32>(_e131);
let _e134 = select(_e122, _e132, (_e132 < _e122));
let _e140 = global_5.member[bitcast<u32>(select(0i, _e134, (_e134 > 0i)))];
let _e142 = ((2u * _e117) + _e119);
let _e143 = bitcast<i32>(_e142);
let _e145 = select(_e122, _e143, (_e143 < _e122));
let _e151 = global_5.member[bitcast<u32>(select(0i, _e145, (_e145 > 0i)))];
let _e153 = ((3u * _e117) + _e119);
let _e154 = bitcast<i32>(_e153);
let _e156 = select(_e122, _e154, (_e154 < _e122));
let _e162 = global_5.member[bitcast<u32>(select(0i, _e156, (_e156 > 0i)))];
let _e164 = ((4u * _e117) + _e119);
let _e165 = bitcast<i32>(_e164);
let _e167 = select(_e122, _e165, (_e165 < _e122));
let _e173 = global_5.member[bitcast<u32>(select(0i, _e167, (_e167 > 0i)))];
let _e175 = ((5u * _e117) + _e119);
let _e176 = bitcast<i32>(_e175);
let _e178 = select(_e122, _e176, (_e176 < _e122));
let _e184 = global_5.member[bitcast<u32>(select(0i, _e178, (_e178 > 0i)))];
let _e186 = ((6u * _e117) + _e119);
let _e187 = bitcast<i32>(_e186);
let _e189 = select(_e122, _e187, (_e187 < _e122));
let _e195 = global_5.member[bitcast<u32>(select(0i, _e189, (_e189 > 0i)))];
let _e197 = ((7u * _e117) + _e119);
let _e198 = bitcast<i32>(_e197);
let _e200 = select(_e122, _e198, (_e198 < _e122));
let _e206 = global_5.member[bitcast<u32>(select(0i, _e200, (_e200 > 0i)))];
let _e208 = ((8u * _e117) + _e119);
let _e209 = bitcast<i32>(_e208);
let _e211 = select(_e122, _e209, (_e209 < _e122));
let _e217 = global_5.member[bitcast<u32>(select(0i, _e211, (_e211 > 0i)))];
let _e221 = global_1.member.member_8.member;
let _e225 = global_1.member.member_8.member_1;
let _e226 = (_e221 * _e225);
if (_e96 >= (_e226 * 2u)) {
let _e230 = bitcast<i32>((_e114 * _e221));
let _e232 = bitcast<i32>(_e112);
let _e237 = global_6.member[bitcast<u32>((_e230 + _e232))];
let _e243 = global_6.member[bitcast<u32>(((bitcast<i32>(_e226) + _e230) + _e232))];
let _e244 = f32(_e232);
let _e246 = f32(bitcast<i32>(_e114));
let _e252 = global_1.member.member_5.member;
let _e256 = global_1.member.member_8.member_8;
let _e257 = (_e252 - _e256);
let _e261 = global_1.member.member_8.member_2;
let _e265 = global_1.member.member_8.member_6;
let _e272 = global_1.member.member_8.member_4;
let _e274 = ((_e261 + (_e265 * _e257)) + (((_e244 - _e237) + 0.5f) * _e272));
let _e278 = global_1.member.member_8.member_3;
let _e282 = global_1.member.member_8.member_7;
let _e287 = ((_e278 + (_e282 * _e257)) + (((_e246 - _e243) + 0.5f) * _e272));
let _e291 = global_1.member.member_5.member_1;
let _e292 = (_e291 - _e256);
let _e297 = ((_e261 + (_e265 * _e292)) + ((_e244 + 0.5f) * _e272));
let _e302 = ((_e278 + (_e282 * _e292)) + ((_e246 + 0.5f) * _e272));
let _e306 = global_1.member.member_6.member;
let _e317 = ((((_e306.member.member * _e274) + (_e306.member.member_1 * _e287)) + (_e306.member.member_2 * _e252)) + _e306.member_1);
let _e321 = global_1.member.member_6.member_1;
let _e332 = ((((_e321.member.member * _e274) + (_e321.member.member_1 * _e287)) + (_e321.member.member_2 * _e252)) + _e321.member_1);
let _e336 = global_1.member.member_6.member_2;
let _e347 = ((((_e336.member.member * _e274) + (_e336.member.member_1 * _e287)) + (_e336.member.member_2 * _e252)) + _e336.member_1);
let _e353 = ((((_e306.member.member * _e297) + (_e306.member.member_1 * _e302)) + (_e306.member.member_2 * _e291)) + _e306.member_1);
let _e359 = ((((_e321.member.member * _e297) + (_e321.member.member_1 * _e302)) + (_e321.member.member_2 * _e291)) + _e321.member_1);
let _e365 = ((((_e336.member.member * _e297) + (_e336.member.member_1 * _e302)) + (_e336.member.member_2 * _e291)) + _e336.member_1);
let _e371 = global_1.member.member_6.member_3.member;
let _e372 = (_e371 - 1f);
let _e381 = global_1.member.member_6.member_3.member_1;
let _e382 = (_e381 - 1f);
let _e391 = global_1.member.member_6.member_3.member_2;
let _e392 = (_e391 - 1f);
let _e411 = global_1.member.member_6.member_4;
let _e412 = (_e371 - 0.5f);
let _e414 = select(-0.5f, _e353, (_e353 > -0.5f));
let _e416 = select(_e412, _e414, (_e414 < _e412));
let _e417 = (_e381 - 0.5f);
let _e419 = select(-0.5f, _e359, (_e359 > -0.5f));
let _e421 = select(_e417, _e419, (_e419 < _e417));
let _e422 = (_e391 - 0.5f);
let _e424 = select(-0.5f, _e365, (_e365 > -0.5f));
let _e426 = select(_e422, _e424, (_e424 < _e422));
let _e432 = bitcast<f32>((bitcast<u32>((_e353 - _e317)) & 2147483647u));
let _e435 = bitcast<f32>((bitcast<u32>((_e359 - _e332)) & 2147483647u));
let _e437 = select(_e435, _e432, (_e432 > _e435));
let _e440 = bitcast<f32>((bitcast<u32>((_e365 - _e347)) & 2147483647u));
let _e449 = bitcast<f32>((bitcast<u32>((_e353 - _e416)) & 2147483647u));
let _e452 = bitcast<f32>((bitcast<u32>((_e359 - _e421)) & 2147483647u));
let _e454 = select(_e452, _e449, (_e449 > _e452));
let _e457 = bitcast<f32>((bitcast<u32>((_e365 - _e426)) & 2147483647u));
let _e461 = (_e416 + 0.5f);
let _e463 = select(0f, _e461, (_e461 > 0f));
let _e465 = select(_e372, _e463, (_e463 < _e372));
let _e472 = select(0i, select(select(i32(_e465), i32(-2147483648), (_e465 < -2147483600f)), 2147483647i, (_e465 > 2147483500f)), (_e465 == _e465));
let _e480 = global_1.member.member_6.member_12;
let _e481 = (_e480 & 31u);
let _e484 = (_e421 + 0.5f);
let _e486 = select(0f, _e484, (_e484 > 0f));
let _e488 = select(_e382, _e486, (_e486 < _e382));
let _e495 = select(0i, select(select(i32(_e488), i32(-2147483648), (_e488 < -2147483600f)), 2147483647i, (_e488 > 2147483500f)), (_e488 == _e488));
let _e502 = (_e426 + 0.5f);
let _e504 = select(0f, _e502, (_e502 > 0f));
let _e506 = select(_e392, _e504, (_e504 < _e392));
let _e513 = select(0i, select(select(i32(_e506), i32(-2147483648), (_e506 < -2147483600f)), 2147483647i, (_e506 > 2147483500f)), (_e506 == _e506));
let _e524 = global_1.member.member_6.member_9.member;
let _e530 = global_1.member.member_6.member_9.member_1;
let _e535 = global_1.member.member_6.member_10;
let _e541 = ((bitcast<i32>(_e535) + ((_e472 - select(0i, 1i, (_e465 < f32(_e472)))) >> bitcast<u32>(_e481))) + (bitcast<i32>(_e524) * (((_e495 - select(0i, 1i, (_e488 < f32(_e495)))) >> bitcast<u32>(_e481)) + (bitcast<i32>(_e530) * ((_e513 - select(0i, 1i, (_e506 < f32(_e513)))) >> bitcast<u32>(_e481))))));
let _e543 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e545 = select(_e543, _e541, (_e541 < _e543));
let _e551 = global_3.member[bitcast<u32>(select(0i, _e545, (_e545 > 0i)))];
let _e557 = global_1.member.member_1;
phi_943_ = select(select(7u, 3u, (((((((_e317 >= 0f) && (_e317 <= _e372)) && (_e332 >= 0f)) && (_e332 <= _e382)) && (_e347 >= 0f)) && (_e347 <= _e392)) && ((((((_e353 >= 0f) && (_e353 <= _e372)) && (_e359 >= 0f)) && (_e359 <= _e382)) && (_e365 >= 0f)) && (_e365 <= _e392)))), 1u, (((_e557 & 64u) != 0u) || ((((select(_e440, _e437, (_e437 > _e440)) <= _e411) && ((select(_e457, _e454, (_e454 > _e457)) > _e411) || (_e551 != 0u))) && true) && ((_e557 & 32u) != 0u))));
} else {
phi_943_ = 7u;
}
let _e567 = phi_943_;
if (_e567 > 1u) {
let _e572 = bitcast<i32>(((_e114 * _e221) + _e112));
let _e575 = (bitcast<i32>(_e96) - 1i);
let _e577 = select(_e575, _e572, (_e572 < _e575));
let _e583 = global_6.member[bitcast<u32>(select(0i, _e577, (_e577 > 0i)))];
let _e584 = (bitcast<i32>(_e226) + _e572);
let _e586 = select(_e575, _e584, (_e584 < _e575));
let _e592 = global_6.member[bitcast<u32>(select(0i, _e586, (_e586 > 0i)))];
let _e594 = f32(bitcast<i32>(_e112));
let _e596 = f32(bitcast<i32>(_e114));
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
let _e717 = (_e104.member_2 == 2u);
let _e720 = (((_e104.member_2 == 1u) || _e717) || (_e104.member_2 == 5u));
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
let _e830 = (bitcast<i32>(_e90) - 1i);
let _e832 = select(_e830, _e828, (_e828 < _e830));
let _e838 = global_2.member[bitcast<u32>(select(0i, _e832, (_e832 > 0i)))];
let _e840 = (_e804 & 15i);
let _e843 = ((_e805 & 15i) * _e799);
let _e845 = (bitcast<i32>(_e838) + ((_e806 & 15i) * _e803));
let _e846 = (_e843 + _e799);
let _e848 = (_e843 + (2i * _e799));
let _e850 = (_e843 + (3i * _e799));
let _e851 = (_e845 + _e803);
let _e853 = (_e845 + (2i * _e803));
let _e855 = (_e845 + (3i * _e803));
local_4 = type_28(array<i32, 4>(_e840, _e840, _e840, _e840), array<u32, 6>(0u, 8u, 16u, 24u, 0u, 0u));
local_5 = vec3<f32>((_e730 - f32(_e765)), (_e740 - f32(_e780)), (_e750 - f32(_e795)));
let _e869 = local_4.member[0u];
let _e870 = ((_e851 + _e846) + _e869);
let _e872 = (_e870 >> bitcast<u32>(2i));
let _e875 = bitcast<u32>(((_e870 & 3i) * 8i));
let _e877 = select(_e830, _e872, (_e872 < _e830));
let _e882 = global_2.member[bitcast<u32>(select(0i, _e877, (_e877 > 0i)))];
let _e886 = (_e872 + 1i);
let _e888 = select(_e830, _e886, (_e886 < _e830));
let _e893 = global_2.member[bitcast<u32>(select(0i, _e888, (_e888 > 0i)))];
let _e900 = ((_e882 >> bitcast<u32>((_e875 & 31u))) | ((_e893 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e875) & 31u))));
let _e903 = local_4.member_1[0u];
let _e909 = f32(bitcast<i32>(((_e900 >> bitcast<u32>((_e903 & 31u))) & 255u)));
let _e912 = local_4.member_1[1u];
let _e918 = f32(bitcast<i32>(((_e900 >> bitcast<u32>((_e912 & 31u))) & 255u)));
let _e921 = local_4.member_1[2u];
let _e927 = f32(bitcast<i32>(((_e900 >> bitcast<u32>((_e921 & 31u))) & 255u)));
let _e930 = local_4.member_1[3u];
let _e937 = local_5[0u];
let _e940 = (_e909 + ((_e918 - _e909) * _e937));
let _e941 = local_5[0u];
let _e944 = (_e918 + ((_e927 - _e918) * _e941));
let _e945 = local_5[0u];
let _e948 = (_e927 + ((f32(bitcast<i32>(((_e900 >> bitcast<u32>((_e930 & 31u))) & 255u))) - _e927) * _e945));
let _e950 = local_4.member[0u];
let _e951 = ((_e851 + _e848) + _e950);
let _e953 = (_e951 >> bitcast<u32>(2i));
let _e956 = bitcast<u32>(((_e951 & 3i) * 8i));
let _e958 = select(_e830, _e953, (_e953 < _e830));
let _e963 = global_2.member[bitcast<u32>(select(0i, _e958, (_e958 > 0i)))];
let _e967 = (_e953 + 1i);
let _e969 = select(_e830, _e967, (_e967 < _e830));
let _e974 = global_2.member[bitcast<u32>(select(0i, _e969, (_e969 > 0i)))];
let _e981 = ((_e963 >> bitcast<u32>((_e956 & 31u))) | ((_e974 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e956) & 31u))));
let _e982 = local_4.member_1[0u];
let _e988 = f32(bitcast<i32>(((_e981 >> bitcast<u32>((_e982 & 31u))) & 255u)));
let _e989 = local_4.member_1[1u];
let _e995 = f32(bitcast<i32>(((_e981 >> bitcast<u32>((_e989 & 31u))) & 255u)));
let _e996 = local_4.member_1[2u];
let _e1002 = f32(bitcast<i32>(((_e981 >> bitcast<u32>((_e996 & 31u))) & 255u)));
let _e1003 = local_4.member_1[3u];
let _e1010 = local_5[0u];
let _e1014 = local_5[0u];
let _e1017 = (_e995 + ((_e1002 - _e995) * _e1014));
let _e1018 = local_5[0u];
let _e1023 = local_4.member[0u];
let _e1024 = ((_e853 + _e846) + _e1023);
let _e1026 = (_e1024 >> bitcast<u32>(2i));
let _e1029 = bitcast<u32>(((_e1024 & 3i) * 8i));
let _e1031 = select(_e830, _e1026, (_e1026 < _e830));
let _e1036 = global_2.member[bitcast<u32>(select(0i, _e1031, (_e1031 > 0i)))];
let _e1040 = (_e1026 + 1i);
let _e1042 = select(_e830, _e1040, (_e1040 < _e830));
let _e1047 = global_2.member[bitcast<u32>(select(0i, _e1042, (_e1042 > 0i)))];
let _e1054 = ((_e1036 >> bitcast<u32>((_e1029 & 31u))) | ((_e1047 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1029) & 31u))));
let _e1055 = local_4.member_1[0u];
let _e1061 = f32(bitcast<i32>(((_e1054 >> bitcast<u32>((_e1055 & 31u))) & 255u)));
let _e1062 = local_4.member_1[1u];
let _e1068 = f32(bitcast<i32>(((_e1054 >> bitcast<u32>((_e1062 & 31u))) & 255u)));
let _e1069 = local_4.member_1[2u];
let _e1075 = f32(bitcast<i32>(((_e1054 >> bitcast<u32>((_e1069 & 31u))) & 255u)));
let _e1076 = local_4.member_1[3u];
let _e1083 = local_5[0u];
let _e1086 = (_e1061 + ((_e1068 - _e1061) * _e1083));
let _e1087 = local_5[0u];
let _e1090 = (_e1068 + ((_e1075 - _e1068) * _e1087));
let _e1091 = local_5[0u];
let _e1094 = (_e1075 + ((f32(bitcast<i32>(((_e1054 >> bitcast<u32>((_e1076 & 31u))) & 255u))) - _e1075) * _e1091));
let _e1096 = local_4.member[0u];
let _e1097 = ((_e853 + _e848) + _e1096);
let _e1099 = (_e1097 >> bitcast<u32>(2i));
let _e1102 = bitcast<u32>(((_e1097 & 3i) * 8i));
let _e1104 = select(_e830, _e1099, (_e1099 < _e830));
let _e1109 = global_2.member[bitcast<u32>(select(0i, _e1104, (_e1104 > 0i)))];
let _e1113 = (_e1099 + 1i);
let _e1115 = select(_e830, _e1113, (_e1113 < _e830));
let _e1120 = global_2.member[bitcast<u32>(select(0i, _e1115, (_e1115 > 0i)))];
let _e1127 = ((_e1109 >> bitcast<u32>((_e1102 & 31u))) | ((_e1120 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1102) & 31u))));
let _e1128 = local_4.member_1[0u];
let _e1134 = f32(bitcast<i32>(((_e1127 >> bitcast<u32>((_e1128 & 31u))) & 255u)));
let _e1135 = local_4.member_1[1u];
let _e1141 = f32(bitcast<i32>(((_e1127 >> bitcast<u32>((_e1135 & 31u))) & 255u)));
let _e1142 = local_4.member_1[2u];
let _e1148 = f32(bitcast<i32>(((_e1127 >> bitcast<u32>((_e1142 & 31u))) & 255u)));
let _e1149 = local_4.member_1[3u];
let _e1156 = local_5[0u];
let _e1160 = local_5[0u];
let _e1163 = (_e1141 + ((_e1148 - _e1141) * _e1160));
let _e1164 = local_5[0u];
let _e1169 = local_4.member[0u];
let _e1170 = ((_e851 + _e843) + _e1169);
let _e1172 = (_e1170 >> bitcast<u32>(2i));
let _e1175 = bitcast<u32>(((_e1170 & 3i) * 8i));
let _e1177 = select(_e830, _e1172, (_e1172 < _e830));
let _e1182 = global_2.member[bitcast<u32>(select(0i, _e1177, (_e1177 > 0i)))];
let _e1186 = (_e1172 + 1i);
let _e1188 = select(_e830, _e1186, (_e1186 < _e830));
let _e1193 = global_2.member[bitcast<u32>(select(0i, _e1188, (_e1188 > 0i)))];
let _e1200 = ((_e1182 >> bitcast<u32>((_e1175 & 31u))) | ((_e1193 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1175) & 31u))));
let _e1201 = local_4.member_1[1u];
let _e1207 = f32(bitcast<i32>(((_e1200 >> bitcast<u32>((_e1201 & 31u))) & 255u)));
let _e1208 = local_4.member_1[2u];
let _e1215 = local_5[0u];
let _e1218 = (_e1207 + ((f32(bitcast<i32>(((_e1200 >> bitcast<u32>((_e1208 & 31u))) & 255u))) - _e1207) * _e1215));
let _e1220 = local_4.member[0u];
let _e1221 = ((_e851 + _e850) + _e1220);
let _e1223 = (_e1221 >> bitcast<u32>(2i));
let _e1226 = bitcast<u32>(((_e1221 & 3i) * 8i));
let _e1228 = select(_e830, _e1223, (_e1223 < _e830));
let _e1233 = global_2.member[bitcast<u32>(select(0i, _e1228, (_e1228 > 0i)))];
let _e1237 = (_e1223 + 1i);
let _e1239 = select(_e830, _e1237, (_e1237 < _e830));
let _e1244 = global_2.member[bitcast<u32>(select(0i, _e1239, (_e1239 > 0i)))];
let _e1251 = ((_e1233 >> bitcast<u32>((_e1226 & 31u))) | ((_e1244 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1226) & 31u))));
let _e1252 = local_4.member_1[1u];
let _e1258 = f32(bitcast<i32>(((_e1251 >> bitcast<u32>((_e1252 & 31u))) & 255u)));
let _e1259 = local_4.member_1[2u];
let _e1266 = local_5[0u];
let _e1271 = local_4.member[0u];
let _e1272 = ((_e853 + _e843) + _e1271);
let _e1274 = (_e1272 >> bitcast<u32>(2i));
let _e1277 = bitcast<u32>(((_e1272 & 3i) * 8i));
let _e1279 = select(_e830, _e1274, (_e1274 < _e830));
let _e1284 = global_2.member[bitcast<u32>(select(0i, _e1279, (_e1279 > 0i)))];
let _e1288 = (_e1274 + 1i);
let _e1290 = select(_e830, _e1288, (_e1288 < _e830));
let _e1295 = global_2.member[bitcast<u32>(select(0i, _e1290, (_e1290 > 0i)))];
let _e1302 = ((_e1284 >> bitcast<u32>((_e1277 & 31u))) | ((_e1295 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1277) & 31u))));
let _e1303 = local_4.member_1[1u];
let _e1309 = f32(bitcast<i32>(((_e1302 >> bitcast<u32>((_e1303 & 31u))) & 255u)));
let _e1310 = local_4.member_1[2u];
let _e1317 = local_5[0u];
let _e1320 = (_e1309 + ((f32(bitcast<i32>(((_e1302 >> bitcast<u32>((_e1310 & 31u))) & 255u))) - _e1309) * _e1317));
let _e1322 = local_4.member[0u];
let _e1323 = ((_e853 + _e850) + _e1322);
let _e1325 = (_e1323 >> bitcast<u32>(2i));
let _e1328 = bitcast<u32>(((_e1323 & 3i) * 8i));
let _e1330 = select(_e830, _e1325, (_e1325 < _e830));
let _e1335 = global_2.member[bitcast<u32>(select(0i, _e1330, (_e1330 > 0i)))];
let _e1339 = (_e1325 + 1i);
let _e1341 = select(_e830, _e1339, (_e1339 < _e830));
let _e1346 = global_2.member[bitcast<u32>(select(0i, _e1341, (_e1341 > 0i)))];
let _e1353 = ((_e1335 >> bitcast<u32>((_e1328 & 31u))) | ((_e1346 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1328) & 31u))));
let _e1354 = local_4.member_1[1u];
let _e1360 = f32(bitcast<i32>(((_e1353 >> bitcast<u32>((_e1354 & 31u))) & 255u)));
let _e1361 = local_4.member_1[2u];
let _e1368 = local_5[0u];
let _e1373 = local_4.member[0u];
let _e1374 = ((_e845 + _e846) + _e1373);
let _e1376 = (_e1374 >> bitcast<u32>(2i));
let _e1379 = bitcast<u32>(((_e1374 & 3i) * 8i));
let _e1381 = select(_e830, _e1376, (_e1376 < _e830));
let _e1386 = global_2.member[bitcast<u32>(select(0i, _e1381, (_e1381 > 0i)))];
let _e1390 = (_e1376 + 1i);
let _e1392 = select(_e830, _e1390, (_e1390 < _e830));
let _e1397 = global_2.member[bitcast<u32>(select(0i, _e1392, (_e1392 > 0i)))];
let _e1404 = ((_e1386 >> bitcast<u32>((_e1379 & 31u))) | ((_e1397 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1379) & 31u))));
let _e1405 = local_4.member_1[1u];
let _e1411 = f32(bitcast<i32>(((_e1404 >> bitcast<u32>((_e1405 & 31u))) & 255u)));
let _e1412 = local_4.member_1[2u];
let _e1419 = local_5[0u];
let _e1422 = (_e1411 + ((f32(bitcast<i32>(((_e1404 >> bitcast<u32>((_e1412 & 31u))) & 255u))) - _e1411) * _e1419));
let _e1424 = local_4.member[0u];
let _e1425 = ((_e855 + _e846) + _e1424);
let _e1427 = (_e1425 >> bitcast<u32>(2i));
let _e1430 = bitcast<u32>(((_e1425 & 3i) * 8i));
let _e1432 = select(_e830, _e1427, (_e1427 < _e830));
let _e1437 = global_2.member[bitcast<u32>(select(0i, _e1432, (_e1432 > 0i)))];
let _e1441 = (_e1427 + 1i);
let _e1443 = select(_e830, _e1441, (_e1441 < _e830));
let _e1448 = global_2.member[bitcast<u32>(select(0i, _e1443, (_e1443 > 0i)))];
let _e1455 = ((_e1437 >> bitcast<u32>((_e1430 & 31u))) | ((_e1448 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1430) & 31u))));
let _e1456 = local_4.member_1[1u];
let _e1462 = f32(bitcast<i32>(((_e1455 >> bitcast<u32>((_e1456 & 31u))) & 255u)));
let _e1463 = local_4.member_1[2u];
let _e1470 = local_5[0u];
let _e1473 = (_e1462 + ((f32(bitcast<i32>(((_e1455 >> bitcast<u32>((_e1463 & 31u))) & 255u))) - _e1462) * _e1470));
let _e1475 = local_4.member[0u];
let _e1476 = ((_e845 + _e848) + _e1475);
let _e1478 = (_e1476 >> bitcast<u32>(2i));
let _e1481 = bitcast<u32>(((_e1476 & 3i) * 8i));
let _e1483 = select(_e830, _e1478, (_e1478 < _e830));
let _e1488 = global_2.member[bitcast<u32>(select(0i, _e1483, (_e1483 > 0i)))];
let _e1492 = (_e1478 + 1i);
let _e1494 = select(_e830, _e1492, (_e1492 < _e830));
let _e1499 = global_2.member[bitcast<u32>(select(0i, _e1494, (_e1494 > 0i)))];
let _e1506 = ((_e1488 >> bitcast<u32>((_e1481 & 31u))) | ((_e1499 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1481) & 31u))));
let _e1507 = local_4.member_1[1u];
let _e1513 = f32(bitcast<i32>(((_e1506 >> bitcast<u32>((_e1507 & 31u))) & 255u)));
let _e1514 = local_4.member_1[2u];
let _e1521 = local_5[0u];
let _e1526 = local_4.member[0u];
let _e1527 = ((_e855 + _e848) + _e1526);
let _e1529 = (_e1527 >> bitcast<u32>(2i));
let _e1532 = bitcast<u32>(((_e1527 & 3i) * 8i));
let _e1534 = select(_e830, _e1529, (_e1529 < _e830));
let _e1539 = global_2.member[bitcast<u32>(select(0i, _e1534, (_e1534 > 0i)))];
let _e1543 = (_e1529 + 1i);
let _e1545 = select(_e830, _e1543, (_e1543 < _e830));
let _e1550 = global_2.member[bitcast<u32>(select(0i, _e1545, (_e1545 > 0i)))];
let _e1557 = ((_e1539 >> bitcast<u32>((_e1532 & 31u))) | ((_e1550 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1532) & 31u))));
let _e1558 = local_4.member_1[1u];
let _e1564 = f32(bitcast<i32>(((_e1557 >> bitcast<u32>((_e1558 & 31u))) & 255u)));
let _e1565 = local_4.member_1[2u];
let _e1572 = local_5[0u];
let _e1577 = local_5[1u];
let _e1580 = (_e944 + ((_e1017 - _e944) * _e1577));
let _e1581 = local_5[1u];
let _e1584 = (_e1090 + ((_e1163 - _e1090) * _e1581));
let _e1585 = local_5[1u];
let _e1588 = (_e940 + (((_e988 + ((_e995 - _e988) * _e1010)) - _e940) * _e1585));
let _e1589 = local_5[1u];
let _e1594 = local_5[2u];
let _e1598 = local_5[1u];
let _e1601 = (_e948 + (((_e1002 + ((f32(bitcast<i32>(((_e981 >> bitcast<u32>((_e1003 & 31u))) & 255u))) - _e1002) * _e1018)) - _e948) * _e1598));
let _e1602 = local_5[1u];
let _e1606 = local_5[2u];
let _e1610 = local_5[1u];
let _e1613 = (_e1218 + ((_e944 - _e1218) * _e1610));
let _e1614 = local_5[1u];
let _e1618 = local_5[2u];
let _e1622 = local_5[1u];
let _e1625 = (_e1017 + (((_e1258 + ((f32(bitcast<i32>(((_e1251 >> bitcast<u32>((_e1259 & 31u))) & 255u))) - _e1258) * _e1266)) - _e1017) * _e1622));
let _e1626 = local_5[1u];
let _e1630 = local_5[2u];
let _e1634 = local_5[1u];
let _e1637 = (_e1422 + (((_e1513 + ((f32(bitcast<i32>(((_e1506 >> bitcast<u32>((_e1514 & 31u))) & 255u))) - _e1513) * _e1521)) - _e1422) * _e1634));
let _e1638 = local_5[2u];
let _e1642 = local_5[1u];
let _e1646 = local_5[2u];
let _e1650 = local_5[2u];
let _e1657 = global_1.member.member_6.member_5;
let _e1662 = global_1.member.member_6.member_6;
let _e1663 = (((_e1580 + ((_e1584 - _e1580) * _e1650)) * _e1657) + _e1662);
let _e1665 = select(0f, _e1663, (_e1663 > 0f));
let _e1667 = select(1f, _e1665, (_e1665 < 1f));
let _e1669 = (((_e1588 + (((_e1086 + (((_e1134 + ((_e1141 - _e1134) * _e1156)) - _e1086) * _e1589)) - _e1588) * _e1594)) * _e1657) + _e1662);
let _e1671 = select(0f, _e1669, (_e1669 > 0f));
let _e1673 = select(1f, _e1671, (_e1671 < 1f));
let _e1675 = (((_e1601 + (((_e1094 + (((_e1148 + ((f32(bitcast<i32>(((_e1127 >> bitcast<u32>((_e1149 & 31u))) & 255u))) - _e1148) * _e1164)) - _e1094) * _e1602)) - _e1601) * _e1606)) * _e1657) + _e1662);
let _e1677 = select(0f, _e1675, (_e1675 > 0f));
let _e1679 = select(1f, _e1677, (_e1677 < 1f));
let _e1681 = (((_e1613 + (((_e1320 + ((_e1090 - _e1320) * _e1614)) - _e1613) * _e1618)) * _e1657) + _e1662);
let _e1683 = select(0f, _e1681, (_e1681 > 0f));
let _e1685 = select(1f, _e1683, (_e1683 < 1f));
let _e1687 = (((_e1625 + (((_e1163 + (((_e1360 + ((f32(bitcast<i32>(((_e1353 >> bitcast<u32>((_e1361 & 31u))) & 255u))) - _e1360) * _e1368)) - _e1163) * _e1626)) - _e1625) * _e1630)) * _e1657) + _e1662);
let _e1689 = select(0f, _e1687, (_e1687 > 0f));
let _e1691 = select(1f, _e1689, (_e1689 < 1f));
let _e1693 = (((_e1637 + ((_e1580 - _e1637) * _e1638)) * _e1657) + _e1662);
let _e1695 = select(0f, _e1693, (_e1693 > 0f));
let _e1697 = select(1f, _e1695, (_e1695 < 1f));
let _e1699 = (((_e1584 + (((_e1473 + (((_e1564 + ((f32(bitcast<i32>(((_e1557 >> bitcast<u32>((_e1565 & 31u))) & 255u))) - _e1564) * _e1572)) - _e1473) * _e1642)) - _e1584) * _e1646)) * _e1657) + _e1662);
let _e1701 = select(0f, _e1699, (_e1699 > 0f));
let _e1703 = select(1f, _e1701, (_e1701 < 1f));
let _e1704 = (_e1667 * 1024f);
let _e1705 = (1024f - 1f);
let _e1707 = select(0f, _e1704, (_e1704 > 0f));
let _e1709 = select(_e1705, _e1707, (_e1707 < _e1705));
let _e1716 = select(0i, select(select(i32(_e1709), i32(-2147483648), (_e1709 < -2147483600f)), 2147483647i, (_e1709 > 2147483500f)), (_e1709 == _e1709));
let _e1720 = (_e1716 - select(0i, 1i, (_e1709 < f32(_e1716))));
let _e1721 = (262147i + _e1720);
let _e1723 = (bitcast<i32>(_e94) - 1i);
let _e1725 = select(_e1723, _e1721, (_e1721 < _e1723));
let _e1731 = global_4.member[bitcast<u32>(select(0i, _e1725, (_e1725 > 0i)))];
let _e1741 = select(_e1723, 262146i, (262146i < _e1723));
let _e1747 = global_4.member[bitcast<u32>(select(0i, _e1741, (_e1741 > 0i)))];
let _e1748 = bitcast<f32>(_e1747);
let _e1749 = (f32((bitcast<i32>((_e1731 & 4095u)) - 2048i)) * _e1748);
let _e1751 = select(_e1723, 262144i, (262144i < _e1723));
let _e1757 = global_4.member[bitcast<u32>(select(0i, _e1751, (_e1751 > 0i)))];
let _e1758 = bitcast<f32>(_e1757);
let _e1760 = select(_e1723, 262145i, (262145i < _e1723));
let _e1766 = global_4.member[bitcast<u32>(select(0i, _e1760, (_e1760 > 0i)))];
let _e1767 = bitcast<f32>(_e1766);
let _e1773 = ((_e1758 + (f32(bitcast<i32>((_e1731 >> bitcast<u32>(12u)))) * _e1767)) + (_e1749 * (_e1704 - f32(_e1720))));
let _e1774 = (_e1749 * 1024f);
if _e717 {
let _e1781 = ((0.5f * (_e1679 - _e1673)) * _e1774);
let _e1782 = ((0.5f * (_e1691 - _e1685)) * _e1774);
let _e1783 = ((0.5f * (_e1703 - _e1697)) * _e1774);
phi_3325_ = type_29(_e1773, vec3<f32>(_e1781, _e1782, _e1783), vec3<f32>((_e1781 * _e1773), (_e1782 * _e1773), (_e1783 * _e1773)));
} else {
let _e1790 = (_e1673 * 1024f);
let _e1792 = select(0f, _e1790, (_e1790 > 0f));
let _e1794 = select(_e1705, _e1792, (_e1792 < _e1705));
let _e1801 = select(0i, select(select(i32(_e1794), i32(-2147483648), (_e1794 < -2147483600f)), 2147483647i, (_e1794 > 2147483500f)), (_e1794 == _e1794));
let _e1805 = (_e1801 - select(0i, 1i, (_e1794 < f32(_e1801))));
let _e1806 = (262147i + _e1805);
let _e1808 = select(_e1723, _e1806, (_e1806 < _e1723));
let _e1814 = global_4.member[bitcast<u32>(select(0i, _e1808, (_e1808 > 0i)))];
let _e1829 = ((_e1758 + (f32(bitcast<i32>((_e1814 >> bitcast<u32>(12u)))) * _e1767)) + ((f32((bitcast<i32>((_e1814 & 4095u)) - 2048i)) * _e1748) * (_e1790 - f32(_e1805))));
let _e1830 = (_e1679 * 1024f);
let _e1832 = select(0f, _e1830, (_e1830 > 0f));
let _e1834 = select(_e1705, _e1832, (_e1832 < _e1705));
let _e1841 = select(0i, select(select(i32(_e1834), i32(-2147483648), (_e1834 < -2147483600f)), 2147483647i, (_e1834 > 2147483500f)), (_e1834 == _e1834));
let _e1845 = (_e1841 - select(0i, 1i, (_e1834 < f32(_e1841))));
let _e1846 = (262147i + _e1845);
let _e1848 = select(_e1723, _e1846, (_e1846 < _e1723));
let _e1854 = global_4.member[bitcast<u32>(select(0i, _e1848, (_e1848 > 0i)))];
let _e1869 = ((_e1758 + (f32(bitcast<i32>((_e1854 >> bitcast<u32>(12u)))) * _e1767)) + ((f32((bitcast<i32>((_e1854 & 4095u)) - 2048i)) * _e1748) * (_e1830 - f32(_e1845))));
let _e1870 = (_e1685 * 1024f);
let _e1872 = select(0f, _e1870, (_e1870 > 0f));
let _e1874 = select(_e1705, _e1872, (_e1872 < _e1705));
let _e1881 = select(0i, select(select(i32(_e1874), i32(-2147483648), (_e1874 < -2147483600f)), 2147483647i, (_e1874 > 2147483500f)), (_e1874 == _e1874));
let _e1885 = (_e1881 - select(0i, 1i, (_e1874 < f32(_e1881))));
let _e1886 = (262147i + _e1885);
let _e1888 = select(_e1723, _e1886, (_e1886 < _e1723));
let _e1894 = global_4.member[bitcast<u32>(select(0i, _e1888, (_e1888 > 0i)))];
let _e1909 = ((_e1758 + (f32(bitcast<i32>((_e1894 >> bitcast<u32>(12u)))) * _e1767)) + ((f32((bitcast<i32>((_e1894 & 4095u)) - 2048i)) * _e1748) * (_e1870 - f32(_e1885))));
let _e1910 = (_e1691 * 1024f);
let _e1912 = select(0f, _e1910, (_e1910 > 0f));
let _e1914 = select(_e1705, _e1912, (_e1912 < _e1705));
let _e1921 = select(0i, select(select(i32(_e1914), i32(-2147483648), (_e1914 < -2147483600f)), 2147483647i, (_e1914 > 2147483500f)), (_e1914 == _e1914));
let _e1925 = (_e1921 - select(0i, 1i, (_e1914 < f32(_e1921))));
let _e1926 = (262147i + _e1925);
let _e1928 = select(_e1723, _e1926, (_e1926 < _e1723));
let _e1934 = global_4.member[bitcast<u32>(select(0i, _e1928, (_e1928 > 0i)))];
let _e1949 = ((_e1758 + (f32(bitcast<i32>((_e1934 >> bitcast<u32>(12u)))) * _e1767)) + ((f32((bitcast<i32>((_e1934 & 4095u)) - 2048i)) * _e1748) * (_e1910 - f32(_e1925))));
let _e1950 = (_e1697 * 1024f);
let _e1952 = select(0f, _e1950, (_e1950 > 0f));
let _e1954 = select(_e1705, _e1952, (_e1952 < _e1705));
let _e1961 = select(0i, select(select(i32(_e1954), i32(-2147483648), (_e1954 < -2147483600f)), 2147483647i, (_e1954 > 2147483500f)), (_e1954 == _e1954));
let _e1965 = (_e1961 - select(0i, 1i, (_e1954 < f32(_e1961))));
let _e1966 = (262147i + _e1965);
let _e1968 = select(_e1723, _e1966, (_e1966 < _e1723));
let _e1974 = global_4.member[bitcast<u32>(select(0i, _e1968, (_e1968 > 0i)))];
let _e1989 = ((_e1758 + (f32(bitcast<i32>((_e1974 >> bitcast<u32>(12u)))) * _e1767)) + ((f32((bitcast<i32>((_e1974 & 4095u)) - 2048i)) * _e1748) * (_e1950 - f32(_e1965))));
let _e1990 = (_e1703 * 1024f);
let _e1992 = select(0f, _e1990, (_e1990 > 0f));
let _e1994 = select(_e1705, _e1992, (_e1992 < _e1705));
let _e2001 = select(0i, select(select(i32(_e1994), i32(-2147483648), (_e1994 < -2147483600f)), 2147483647i, (_e1994 > 2147483500f)), (_e1994 == _e1994));
let _e2005 = (_e2001 - select(0i, 1i, (_e1994 < f32(_e2001))));
let _e2006 = (262147i + _e2005);
let _e2008 = select(_e1723, _e2006, (_e2006 < _e1723));
let _e2014 = global_4.member[bitcast<u32>(select(0i, _e2008, (_e2008 > 0i)))];
let _e2029 = ((_e1758 + (f32(bitcast<i32>((_e2014 >> bitcast<u32>(12u)))) * _e1767)) + ((f32((bitcast<i32>((_e2014 & 4095u)) - 2048i)) * _e1748) * (_e1990 - f32(_e2005))));
let _e2030 = (_e1869 - _e1829);
let _e2032 = (_e1949 - _e1909);
let _e2034 = (_e2029 - _e1989);
phi_3325_ = type_29(_e1773, vec3<f32>((0.5f * _e2030), (0.5f * _e2032), (0.5f * _e2034)), vec3<f32>((0.25f * (_e2030 * (_e1869 + _e1829))), (0.25f * (_e2032 * (_e1949 + _e1909))), (0.25f * (_e2034 * (_e2029 + _e1989)))));
}
let _e2049 = phi_3325_;
let _e2064 = select(0f, 1f, ((((((_e703 >= -0.5f) && (_e703 <= _e726)) && (_e709 >= -0.5f)) && (_e709 <= _e736)) && (_e715 >= -0.5f)) && (_e715 <= _e746)));
let _e2066 = (0.5f * (_e1679 - _e1673));
let _e2068 = (0.5f * (_e1691 - _e1685));
let _e2070 = (0.5f * (_e1703 - _e1697));
let _e2076 = global_1.member.member_6.member.member.member;
let _e2082 = global_1.member.member_6.member.member.member_1;
let _e2088 = global_1.member.member_6.member.member.member_2;
let _e2094 = global_1.member.member_6.member_1.member.member;
let _e2100 = global_1.member.member_6.member_1.member.member_1;
let _e2106 = global_1.member.member_6.member_1.member.member_2;
let _e2112 = global_1.member.member_6.member_2.member.member;
let _e2118 = global_1.member.member_6.member_2.member.member_1;
let _e2124 = global_1.member.member_6.member_2.member.member_2;
phi_4027_ = type_30(_e1667, vec3<f32>(((((_e2076 * _e2066) + (_e2094 * _e2068)) + (_e2112 * _e2070)) * _e2064), ((((_e2082 * _e2066) + (_e2100 * _e2068)) + (_e2118 * _e2070)) * _e2064), ((((_e2088 * _e2066) + (_e2106 * _e2068)) + (_e2124 * _e2070)) * _e2064)), _e2049.member, vec3<f32>(((((_e2076 * _e2049.member_2.x) + (_e2094 * _e2049.member_2.y)) + (_e2112 * _e2049.member_2.z)) * _e2064), ((((_e2082 * _e2049.member_2.x) + (_e2100 * _e2049.member_2.y)) + (_e2118 * _e2049.member_2.z)) * _e2064), ((((_e2088 * _e2049.member_2.x) + (_e2106 * _e2049.member_2.y)) + (_e2124 * _e2049.member_2.z)) * _e2064)), vec3<f32>(((((_e2076 * _e2049.member_1.x) + (_e2094 * _e2049.member_1.y)) + (_e2112 * _e2049.member_1.z)) * _e2064), ((((_e2082 * _e2049.member_1.x) + (_e2100 * _e2049.member_1.y)) + (_e2118 * _e2049.member_1.z)) * _e2064), ((((_e2088 * _e2049.member_1.x) + (_e2106 * _e2049.member_1.y)) + (_e2124 * _e2049.member_1.z)) * _e2064)));
} else {
let _e2193 = global_1.member.member_6.member_3.member;
let _e2194 = (_e2193 - 0.5f);
let _e2196 = select(-0.5f, _e703, (_e703 > -0.5f));
let _e2198 = select(_e2194, _e2196, (_e2196 < _e2194));
let _e2203 = global_1.member.member_6.member_3.member_1;
let _e2204 = (_e2203 - 0.5f);
let _e2206 = select(-0.5f, _e709, (_e709 > -0.5f));
let _e2208 = select(_e2204, _e2206, (_e2206 < _e2204));
let _e2213 = global_1.member.member_6.member_3.member_2;
let _e2214 = (_e2213 - 0.5f);
let _e2216 = select(-0.5f, _e715, (_e715 > -0.5f));
let _e2218 = select(_e2214, _e2216, (_e2216 < _e2214));
let _e2220 = select(-1f, _e2198, (_e2198 > -1f));
let _e2222 = select(_e2193, _e2220, (_e2220 < _e2193));
let _e2229 = select(0i, select(select(i32(_e2222), i32(-2147483648), (_e2222 < -2147483600f)), 2147483647i, (_e2222 > 2147483500f)), (_e2222 == _e2222));
let _e2233 = (_e2229 - select(0i, 1i, (_e2222 < f32(_e2229))));
let _e2235 = select(-1f, _e2208, (_e2208 > -1f));
let _e2237 = select(_e2203, _e2235, (_e2235 < _e2203));
let _e2244 = select(0i, select(select(i32(_e2237), i32(-2147483648), (_e2237 < -2147483600f)), 2147483647i, (_e2237 > 2147483500f)), (_e2237 == _e2237));
let _e2248 = (_e2244 - select(0i, 1i, (_e2237 < f32(_e2244))));
let _e2250 = select(-1f, _e2218, (_e2218 > -1f));
let _e2252 = select(_e2213, _e2250, (_e2250 < _e2213));
let _e2259 = select(0i, select(select(i32(_e2252), i32(-2147483648), (_e2252 < -2147483600f)), 2147483647i, (_e2252 > 2147483500f)), (_e2252 == _e2252));
let _e2263 = (_e2259 - select(0i, 1i, (_e2252 < f32(_e2259))));
let _e2267 = global_1.member.member_6.member_7;
let _e2271 = global_1.member.member_6.member_8;
let _e2272 = (_e2233 + 1i);
let _e2273 = (_e2248 + 1i);
let _e2274 = (_e2263 + 1i);
let _e2279 = global_1.member.member_6.member_11.member;
let _e2285 = global_1.member.member_6.member_11.member_1;
let _e2296 = ((_e2272 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2279) * ((_e2273 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2285) * (_e2274 >> bitcast<u32>(4i))))));
let _e2298 = (bitcast<i32>(_e90) - 1i);
let _e2300 = select(_e2298, _e2296, (_e2296 < _e2298));
let _e2306 = global_2.member[bitcast<u32>(select(0i, _e2300, (_e2300 > 0i)))];
let _e2308 = (_e2272 & 15i);
let _e2311 = ((_e2273 & 15i) * _e2267);
let _e2313 = (bitcast<i32>(_e2306) + ((_e2274 & 15i) * _e2271));
let _e2314 = (_e2311 + _e2267);
let _e2316 = (_e2311 + (2i * _e2267));
let _e2317 = (_e2313 + _e2271);
let _e2319 = (_e2313 + (2i * _e2271));
local_2 = type_28(array<i32, 4>(_e2308, _e2308, _e2308, _e2308), array<u32, 6>(0u, 8u, 16u, 24u, 0u, 0u));
local_3 = vec3<f32>((_e2198 - f32(_e2233)), (_e2208 - f32(_e2248)), (_e2218 - f32(_e2263)));
let _e2333 = local_2.member[0u];
let _e2334 = ((_e2317 + _e2314) + _e2333);
let _e2336 = (_e2334 >> bitcast<u32>(2i));
let _e2339 = bitcast<u32>(((_e2334 & 3i) * 8i));
let _e2341 = select(_e2298, _e2336, (_e2336 < _e2298));
let _e2346 = global_2.member[bitcast<u32>(select(0i, _e2341, (_e2341 > 0i)))];
let _e2350 = (_e2336 + 1i);
let _e2352 = select(_e2298, _e2350, (_e2350 < _e2298));
let _e2357 = global_2.member[bitcast<u32>(select(0i, _e2352, (_e2352 > 0i)))];
let _e2364 = ((_e2346 >> bitcast<u32>((_e2339 & 31u))) | ((_e2357 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2339) & 31u))));
let _e2367 = local_2.member_1[1u];
let _e2373 = f32(bitcast<i32>(((_e2364 >> bitcast<u32>((_e2367 & 31u))) & 255u)));
let _e2376 = local_2.member_1[2u];
let _e2383 = local_3[0u];
let _e2386 = (_e2373 + ((f32(bitcast<i32>(((_e2364 >> bitcast<u32>((_e2376 & 31u))) & 255u))) - _e2373) * _e2383));
let _e2388 = local_2.member[0u];
let _e2389 = ((_e2317 + _e2316) + _e2388);
let _e2391 = (_e2389 >> bitcast<u32>(2i));
let _e2394 = bitcast<u32>(((_e2389 & 3i) * 8i));
let _e2396 = select(_e2298, _e2391, (_e2391 < _e2298));
let _e2401 = global_2.member[bitcast<u32>(select(0i, _e2396, (_e2396 > 0i)))];
let _e2405 = (_e2391 + 1i);
let _e2407 = select(_e2298, _e2405, (_e2405 < _e2298));
let _e2412 = global_2.member[bitcast<u32>(select(0i, _e2407, (_e2407 > 0i)))];
let _e2419 = ((_e2401 >> bitcast<u32>((_e2394 & 31u))) | ((_e2412 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2394) & 31u))));
let _e2420 = local_2.member_1[1u];
let _e2426 = f32(bitcast<i32>(((_e2419 >> bitcast<u32>((_e2420 & 31u))) & 255u)));
let _e2427 = local_2.member_1[2u];
let _e2434 = local_3[0u];
let _e2439 = local_3[1u];
let _e2442 = (_e2386 + (((_e2426 + ((f32(bitcast<i32>(((_e2419 >> bitcast<u32>((_e2427 & 31u))) & 255u))) - _e2426) * _e2434)) - _e2386) * _e2439));
let _e2444 = local_2.member[0u];
let _e2445 = ((_e2319 + _e2314) + _e2444);
let _e2447 = (_e2445 >> bitcast<u32>(2i));
let _e2450 = bitcast<u32>(((_e2445 & 3i) * 8i));
let _e2452 = select(_e2298, _e2447, (_e2447 < _e2298));
let _e2457 = global_2.member[bitcast<u32>(select(0i, _e2452, (_e2452 > 0i)))];
let _e2461 = (_e2447 + 1i);
let _e2463 = select(_e2298, _e2461, (_e2461 < _e2298));
let _e2468 = global_2.member[bitcast<u32>(select(0i, _e2463, (_e2463 > 0i)))];
let _e2475 = ((_e2457 >> bitcast<u32>((_e2450 & 31u))) | ((_e2468 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2450) & 31u))));
let _e2476 = local_2.member_1[1u];
let _e2482 = f32(bitcast<i32>(((_e2475 >> bitcast<u32>((_e2476 & 31u))) & 255u)));
let _e2483 = local_2.member_1[2u];
let _e2490 = local_3[0u];
let _e2493 = (_e2482 + ((f32(bitcast<i32>(((_e2475 >> bitcast<u32>((_e2483 & 31u))) & 255u))) - _e2482) * _e2490));
let _e2495 = local_2.member[0u];
let _e2496 = ((_e2319 + _e2316) + _e2495);
let _e2498 = (_e2496 >> bitcast<u32>(2i));
let _e2501 = bitcast<u32>(((_e2496 & 3i) * 8i));
let _e2503 = select(_e2298, _e2498, (_e2498 < _e2298));
let _e2508 = global_2.member[bitcast<u32>(select(0i, _e2503, (_e2503 > 0i)))];
let _e2512 = (_e2498 + 1i);
let _e2514 = select(_e2298, _e2512, (_e2512 < _e2298));
let _e2519 = global_2.member[bitcast<u32>(select(0i, _e2514, (_e2514 > 0i)))];
let _e2526 = ((_e2508 >> bitcast<u32>((_e2501 & 31u))) | ((_e2519 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2501) & 31u))));
let _e2527 = local_2.member_1[1u];
let _e2533 = f32(bitcast<i32>(((_e2526 >> bitcast<u32>((_e2527 & 31u))) & 255u)));
let _e2534 = local_2.member_1[2u];
let _e2541 = local_3[0u];
let _e2545 = local_3[1u];
let _e2550 = local_3[2u];
let _e2557 = global_1.member.member_6.member_5;
let _e2562 = global_1.member.member_6.member_6;
let _e2563 = (((_e2442 + (((_e2493 + (((_e2533 + ((f32(bitcast<i32>(((_e2526 >> bitcast<u32>((_e2534 & 31u))) & 255u))) - _e2533) * _e2541)) - _e2493) * _e2545)) - _e2442) * _e2550)) * _e2557) + _e2562);
let _e2565 = select(0f, _e2563, (_e2563 > 0f));
phi_4027_ = type_30(select(1f, _e2565, (_e2565 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2570 = phi_4027_;
let _e2575 = global_1.member.member_6.member_3.member;
let _e2576 = (_e2575 - 0.5f);
let _e2578 = select(-0.5f, _e667, (_e667 > -0.5f));
let _e2580 = select(_e2576, _e2578, (_e2578 < _e2576));
let _e2585 = global_1.member.member_6.member_3.member_1;
let _e2586 = (_e2585 - 0.5f);
let _e2588 = select(-0.5f, _e682, (_e682 > -0.5f));
let _e2590 = select(_e2586, _e2588, (_e2588 < _e2586));
let _e2595 = global_1.member.member_6.member_3.member_2;
let _e2596 = (_e2595 - 0.5f);
let _e2598 = select(-0.5f, _e697, (_e697 > -0.5f));
let _e2600 = select(_e2596, _e2598, (_e2598 < _e2596));
let _e2602 = select(-1f, _e2580, (_e2580 > -1f));
let _e2604 = select(_e2575, _e2602, (_e2602 < _e2575));
let _e2611 = select(0i, select(select(i32(_e2604), i32(-2147483648), (_e2604 < -2147483600f)), 2147483647i, (_e2604 > 2147483500f)), (_e2604 == _e2604));
let _e2615 = (_e2611 - select(0i, 1i, (_e2604 < f32(_e2611))));
let _e2617 = select(-1f, _e2590, (_e2590 > -1f));
let _e2619 = select(_e2585, _e2617, (_e2617 < _e2585));
let _e2626 = select(0i, select(select(i32(_e2619), i32(-2147483648), (_e2619 < -2147483600f)), 2147483647i, (_e2619 > 2147483500f)), (_e2619 == _e2619));
let _e2630 = (_e2626 - select(0i, 1i, (_e2619 < f32(_e2626))));
let _e2632 = select(-1f, _e2600, (_e2600 > -1f));
let _e2634 = select(_e2595, _e2632, (_e2632 < _e2595));
let _e2641 = select(0i, select(select(i32(_e2634), i32(-2147483648), (_e2634 < -2147483600f)), 2147483647i, (_e2634 > 2147483500f)), (_e2634 == _e2634));
let _e2645 = (_e2641 - select(0i, 1i, (_e2634 < f32(_e2641))));
let _e2649 = global_1.member.member_6.member_7;
let _e2653 = global_1.member.member_6.member_8;
let _e2654 = (_e2615 + 1i);
let _e2655 = (_e2630 + 1i);
let _e2656 = (_e2645 + 1i);
let _e2661 = global_1.member.member_6.member_11.member;
let _e2667 = global_1.member.member_6.member_11.member_1;
let _e2678 = ((_e2654 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2661) * ((_e2655 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2667) * (_e2656 >> bitcast<u32>(4i))))));
let _e2680 = (bitcast<i32>(_e90) - 1i);
let _e2682 = select(_e2680, _e2678, (_e2678 < _e2680));
let _e2688 = global_2.member[bitcast<u32>(select(0i, _e2682, (_e2682 > 0i)))];
let _e2690 = (_e2654 & 15i);
let _e2693 = ((_e2655 & 15i) * _e2649);
let _e2695 = (bitcast<i32>(_e2688) + ((_e2656 & 15i) * _e2653));
let _e2696 = (_e2693 + _e2649);
let _e2698 = (_e2693 + (2i * _e2649));
let _e2699 = (_e2695 + _e2653);
let _e2701 = (_e2695 + (2i * _e2653));
local = type_28(array<i32, 4>(_e2690, _e2690, _e2690, _e2690), array<u32, 6>(0u, 8u, 16u, 24u, 0u, 0u));
local_1 = vec3<f32>((_e2580 - f32(_e2615)), (_e2590 - f32(_e2630)), (_e2600 - f32(_e2645)));
let _e2715 = local.member[0u];
let _e2716 = ((_e2699 + _e2696) + _e2715);
let _e2718 = (_e2716 >> bitcast<u32>(2i));
let _e2721 = bitcast<u32>(((_e2716 & 3i) * 8i));
let _e2723 = select(_e2680, _e2718, (_e2718 < _e2680));
let _e2728 = global_2.member[bitcast<u32>(select(0i, _e2723, (_e2723 > 0i)))];
let _e2732 = (_e2718 + 1i);
let _e2734 = select(_e2680, _e2732, (_e2732 < _e2680));
let _e2739 = global_2.member[bitcast<u32>(select(0i, _e2734, (_e2734 > 0i)))];
let _e2746 = ((_e2728 >> bitcast<u32>((_e2721 & 31u))) | ((_e2739 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2721) & 31u))));
let _e2749 = local.member_1[1u];
let _e2755 = f32(bitcast<i32>(((_e2746 >> bitcast<u32>((_e2749 & 31u))) & 255u)));
let _e2758 = local.member_1[2u];
let _e2765 = local_1[0u];
let _e2768 = (_e2755 + ((f32(bitcast<i32>(((_e2746 >> bitcast<u32>((_e2758 & 31u))) & 255u))) - _e2755) * _e2765));
let _e2770 = local.member[0u];
let _e2771 = ((_e2699 + _e2698) + _e2770);
let _e2773 = (_e2771 >> bitcast<u32>(2i));
let _e2776 = bitcast<u32>(((_e2771 & 3i) * 8i));
let _e2778 = select(_e2680, _e2773, (_e2773 < _e2680));
let _e2783 = global_2.member[bitcast<u32>(select(0i, _e2778, (_e2778 > 0i)))];
let _e2787 = (_e2773 + 1i);
let _e2789 = select(_e2680, _e2787, (_e2787 < _e2680));
let _e2794 = global_2.member[bitcast<u32>(select(0i, _e2789, (_e2789 > 0i)))];
let _e2801 = ((_e2783 >> bitcast<u32>((_e2776 & 31u))) | ((_e2794 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2776) & 31u))));
let _e2802 = local.member_1[1u];
let _e2808 = f32(bitcast<i32>(((_e2801 >> bitcast<u32>((_e2802 & 31u))) & 255u)));
let _e2809 = local.member_1[2u];
let _e2816 = local_1[0u];
let _e2821 = local_1[1u];
let _e2824 = (_e2768 + (((_e2808 + ((f32(bitcast<i32>(((_e2801 >> bitcast<u32>((_e2809 & 31u))) & 255u))) - _e2808) * _e2816)) - _e2768) * _e2821));
let _e2826 = local.member[0u];
let _e2827 = ((_e2701 + _e2696) + _e2826);
let _e2829 = (_e2827 >> bitcast<u32>(2i));
let _e2832 = bitcast<u32>(((_e2827 & 3i) * 8i));
let _e2834 = select(_e2680, _e2829, (_e2829 < _e2680));
let _e2839 = global_2.member[bitcast<u32>(select(0i, _e2834, (_e2834 > 0i)))];
let _e2843 = (_e2829 + 1i);
let _e2845 = select(_e2680, _e2843, (_e2843 < _e2680));
let _e2850 = global_2.member[bitcast<u32>(select(0i, _e2845, (_e2845 > 0i)))];
let _e2857 = ((_e2839 >> bitcast<u32>((_e2832 & 31u))) | ((_e2850 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2832) & 31u))));
let _e2858 = local.member_1[1u];
let _e2864 = f32(bitcast<i32>(((_e2857 >> bitcast<u32>((_e2858 & 31u))) & 255u)));
let _e2865 = local.member_1[2u];
let _e2872 = local_1[0u];
let _e2875 = (_e2864 + ((f32(bitcast<i32>(((_e2857 >> bitcast<u32>((_e2865 & 31u))) & 255u))) - _e2864) * _e2872));
let _e2877 = local.member[0u];
let _e2878 = ((_e2701 + _e2698) + _e2877);
let _e2880 = (_e2878 >> bitcast<u32>(2i));
let _e2883 = bitcast<u32>(((_e2878 & 3i) * 8i));
let _e2885 = select(_e2680, _e2880, (_e2880 < _e2680));
let _e2890 = global_2.member[bitcast<u32>(select(0i, _e2885, (_e2885 > 0i)))];
let _e2894 = (_e2880 + 1i);
let _e2896 = select(_e2680, _e2894, (_e2894 < _e2680));
let _e2901 = global_2.member[bitcast<u32>(select(0i, _e2896, (_e2896 > 0i)))];
let _e2908 = ((_e2890 >> bitcast<u32>((_e2883 & 31u))) | ((_e2901 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2883) & 31u))));
let _e2909 = local.member_1[1u];
let _e2915 = f32(bitcast<i32>(((_e2908 >> bitcast<u32>((_e2909 & 31u))) & 255u)));
let _e2916 = local.member_1[2u];
let _e2923 = local_1[0u];
let _e2927 = local_1[1u];
let _e2932 = local_1[2u];
let _e2939 = global_1.member.member_6.member_5;
let _e2944 = global_1.member.member_6.member_6;
let _e2945 = (((_e2824 + (((_e2875 + (((_e2915 + ((f32(bitcast<i32>(((_e2908 >> bitcast<u32>((_e2916 & 31u))) & 255u))) - _e2915) * _e2923)) - _e2875) * _e2927)) - _e2824) * _e2932)) * _e2939) + _e2944);
let _e2947 = select(0f, _e2945, (_e2945 > 0f));
let _e2949 = select(1f, _e2947, (_e2947 < 1f));
let _e2952 = global_1.member.member_1;
if ((_e2952 & 16u) == 0u) {
phi_4916_ = type_5(1f, 1f, 1f);
} else {
let _e2958 = global_1.member.member_14.member;
let _e2969 = ((((_e2958.member.member * _e624) + (_e2958.member.member_1 * _e637)) + (_e2958.member.member_2 * _e602)) + _e2958.member_1);
let _e2975 = ((((_e2958.member.member * _e647) + (_e2958.member.member_1 * _e652)) + (_e2958.member.member_2 * _e641)) + _e2958.member_1);
let _e2977 = select(_e2975, _e2969, (_e2969 < _e2975));
let _e2979 = select(_e2975, _e2969, (_e2969 > _e2975));
let _e2981 = (_e2979 - _e2977);
let _e2984 = (-(_e2977) / select(1e-30f, _e2981, (_e2981 > 1e-30f)));
let _e2986 = select(0f, _e2984, (_e2984 > 0f));
let _e2992 = select(select(select(1f, _e2986, (_e2986 < 1f)), 1f, (_e2979 <= 0f)), 0f, (_e2977 > 0f));
let _e2997 = global_1.member.member_14.member_1;
let _e2998 = (_e2997 != 0u);
let _e3008 = global_1.member.member_15.member;
let _e3019 = ((((_e3008.member.member * _e624) + (_e3008.member.member_1 * _e637)) + (_e3008.member.member_2 * _e602)) + _e3008.member_1);
let _e3025 = ((((_e3008.member.member * _e647) + (_e3008.member.member_1 * _e652)) + (_e3008.member.member_2 * _e641)) + _e3008.member_1);
let _e3027 = select(_e3025, _e3019, (_e3019 < _e3025));
let _e3029 = select(_e3025, _e3019, (_e3019 > _e3025));
let _e3031 = (_e3029 - _e3027);
let _e3034 = (-(_e3027) / select(1e-30f, _e3031, (_e3031 > 1e-30f)));
let _e3036 = select(0f, _e3034, (_e3034 > 0f));
let _e3042 = select(select(select(1f, _e3036, (_e3036 < 1f)), 1f, (_e3029 <= 0f)), 0f, (_e3027 > 0f));
let _e3047 = global_1.member.member_15.member_1;
let _e3048 = (_e3047 != 0u);
let _e3058 = global_1.member.member_16.member;
let _e3069 = ((((_e3058.member.member * _e624) + (_e3058.member.member_1 * _e637)) + (_e3058.member.member_2 * _e602)) + _e3058.member_1);
let _e3075 = ((((_e3058.member.member * _e647) + (_e3058.member.member_1 * _e652)) + (_e3058.member.member_2 * _e641)) + _e3058.member_1);
let _e3077 = select(_e3075, _e3069, (_e3069 < _e3075));
let _e3079 = select(_e3075, _e3069, (_e3069 > _e3075));
let _e3081 = (_e3079 - _e3077);
let _e3084 = (-(_e3077) / select(1e-30f, _e3081, (_e3081 > 1e-30f)));
let _e3086 = select(0f, _e3084, (_e3084 > 0f));
let _e3092 = select(select(select(1f, _e3086, (_e3086 < 1f)), 1f, (_e3079 <= 0f)), 0f, (_e3077 > 0f));
let _e3097 = global_1.member.member_16.member_1;
let _e3098 = (_e3097 != 0u);
let _e3108 = global_1.member.member_17.member;
let _e3119 = ((((_e3108.member.member * _e624) + (_e3108.member.member_1 * _e637)) + (_e3108.member.member_2 * _e602)) + _e3108.member_1);
let _e3125 = ((((_e3108.member.member * _e647) + (_e3108.member.member_1 * _e652)) + (_e3108.member.member_2 * _e641)) + _e3108.member_1);
let _e3127 = select(_e3125, _e3119, (_e3119 < _e3125));
let _e3129 = select(_e3125, _e3119, (_e3119 > _e3125));
let _e3131 = (_e3129 - _e3127);
let _e3134 = (-(_e3127) / select(1e-30f, _e3131, (_e3131 > 1e-30f)));
let _e3136 = select(0f, _e3134, (_e3134 > 0f));
let _e3142 = select(select(select(1f, _e3136, (_e3136 < 1f)), 1f, (_e3129 <= 0f)), 0f, (_e3127 > 0f));
let _e3147 = global_1.member.member_17.member_1;
let _e3148 = (_e3147 != 0u);
phi_4916_ = type_5(((((1f * _e2992) * _e3042) * _e3092) * _e3142), ((((1f * select(1f, _e2992, _e2998)) * select(1f, _e3042, _e3048)) * select(1f, _e3092, _e3098)) * select(1f, _e3142, _e3148)), ((((1f * select(1f, 0f, (_e2998 && (_e2975 > 0f)))) * select(1f, 0f, (_e3048 && (_e3025 > 0f)))) * select(1f, 0f, (_e3098 && (_e3075 > 0f)))) * select(1f, 0f, (_e3148 && (_e3125 > 0f)))));
}
let _e3157 = phi_4916_;
let _e3158 = (_e703 - _e667);
let _e3162 = (bitcast<f32>((bitcast<u32>(_e3158) & 2147483647u)) < 1e-12f);
let _e3164 = (1f / select(_e3158, 1f, _e3162));
let _e3166 = ((-0.5f - _e667) * _e3164);
let _e3168 = ((_e2576 - _e667) * _e3164);
let _e3174 = select(_e3168, _e3166, (_e3166 < _e3168));
let _e3176 = select(0f, _e3174, (_e3174 > 0f));
let _e3179 = select(select(1f, _e3176, (_e3176 < 1f)), select(2f, 0f, ((_e667 >= -0.5f) && (_e667 <= _e2576))), _e3162);
let _e3181 = select(_e3168, _e3166, (_e3166 > _e3168));
let _e3183 = select(0f, _e3181, (_e3181 > 0f));
let _e3186 = select(select(1f, _e3183, (_e3183 < 1f)), 1f, _e3162);
let _e3187 = (_e709 - _e682);
let _e3191 = (bitcast<f32>((bitcast<u32>(_e3187) & 2147483647u)) < 1e-12f);
let _e3193 = (1f / select(_e3187, 1f, _e3191));
let _e3195 = ((-0.5f - _e682) * _e3193);
let _e3197 = ((_e2586 - _e682) * _e3193);
let _e3203 = select(_e3197, _e3195, (_e3195 < _e3197));
let _e3205 = select(0f, _e3203, (_e3203 > 0f));
let _e3208 = select(select(1f, _e3205, (_e3205 < 1f)), select(2f, 0f, ((_e682 >= -0.5f) && (_e682 <= _e2586))), _e3191);
let _e3210 = select(_e3197, _e3195, (_e3195 > _e3197));
let _e3212 = select(0f, _e3210, (_e3210 > 0f));
let _e3215 = select(select(1f, _e3212, (_e3212 < 1f)), 1f, _e3191);
let _e3216 = (_e715 - _e697);
let _e3220 = (bitcast<f32>((bitcast<u32>(_e3216) & 2147483647u)) < 1e-12f);
let _e3222 = (1f / select(_e3216, 1f, _e3220));
let _e3224 = ((-0.5f - _e697) * _e3222);
let _e3226 = ((_e2596 - _e697) * _e3222);
let _e3232 = select(_e3226, _e3224, (_e3224 < _e3226));
let _e3234 = select(0f, _e3232, (_e3232 > 0f));
let _e3237 = select(select(1f, _e3234, (_e3234 < 1f)), select(2f, 0f, ((_e697 >= -0.5f) && (_e697 <= _e2596))), _e3220);
let _e3239 = select(_e3226, _e3224, (_e3224 > _e3226));
let _e3241 = select(0f, _e3239, (_e3239 > 0f));
let _e3244 = select(select(1f, _e3241, (_e3241 < 1f)), 1f, _e3220);
let _e3246 = select(_e3215, _e3186, (_e3186 < _e3215));
let _e3250 = select(_e3208, _e3179, (_e3179 > _e3208));
let _e3253 = (select(_e3244, _e3246, (_e3246 < _e3244)) - select(_e3237, _e3250, (_e3250 > _e3237)));
let _e3256 = (_e647 - _e624);
let _e3257 = (_e652 - _e637);
let _e3258 = (_e641 - _e602);
let _e3263 = (((_e3256 * _e3256) + (_e3257 * _e3257)) + (_e3258 * _e3258));
let _e3271 = global_1.member.member_5.member_3;
let _e3272 = ((sqrt(select(0f, _e3263, (_e3263 > 0f))) * select(0f, _e3253, (_e3253 > 0f))) * _e3271);
if (_e104.member_2 >= 3u) {
let _e3275 = (_e2949 * 255f);
let _e3276 = (_e2570.member * 255f);
let _e3277 = (255f - 1f);
let _e3279 = select(0f, _e3275, (_e3275 > 0f));
let _e3281 = select(_e3277, _e3279, (_e3279 < _e3277));
let _e3288 = select(0i, select(select(i32(_e3281), i32(-2147483648), (_e3281 < -2147483600f)), 2147483647i, (_e3281 > 2147483500f)), (_e3281 == _e3281));
let _e3292 = (_e3288 - select(0i, 1i, (_e3281 < f32(_e3288))));
let _e3294 = select(0f, _e3276, (_e3276 > 0f));
let _e3296 = select(_e3277, _e3294, (_e3294 < _e3277));
let _e3303 = select(0i, select(select(i32(_e3296), i32(-2147483648), (_e3296 < -2147483600f)), 2147483647i, (_e3296 > 2147483500f)), (_e3296 == _e3296));
let _e3307 = (_e3303 - select(0i, 1i, (_e3296 < f32(_e3303))));
let _e3310 = (((_e3292 * 256i) + _e3307) * 4i);
let _e3314 = (_e3276 - f32(_e3307));
let _e3316 = (bitcast<i32>(_e94) - 1i);
let _e3318 = select(_e3316, _e3310, (_e3310 < _e3316));
let _e3324 = global_4.member[bitcast<u32>(select(0i, _e3318, (_e3318 > 0i)))];
let _e3325 = (_e3310 + 4i);
let _e3327 = select(_e3316, _e3325, (_e3325 < _e3316));
let _e3333 = global_4.member[bitcast<u32>(select(0i, _e3327, (_e3327 > 0i)))];
let _e3334 = (_e3310 + 1024i);
let _e3336 = select(_e3316, _e3334, (_e3334 < _e3316));
let _e3342 = global_4.member[bitcast<u32>(select(0i, _e3336, (_e3336 > 0i)))];
let _e3343 = (_e3310 + 1028i);
let _e3345 = select(_e3316, _e3343, (_e3343 < _e3316));
let _e3351 = global_4.member[bitcast<u32>(select(0i, _e3345, (_e3345 > 0i)))];
let _e3356 = (bitcast<f32>(((_e3324 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3364 = (_e3356 + (((bitcast<f32>(((_e3333 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3356) * _e3314));
let _e3369 = (bitcast<f32>(((_e3342 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3380 = (_e3364 + (((_e3369 + (((bitcast<f32>(((_e3351 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3369) * _e3314)) - _e3364) * (_e3275 - f32(_e3292))));
let _e3384 = -((_e3380 * (_e3272 * _e3157.member)));
let _e3386 = select(-87f, _e3384, (_e3384 > -87f));
let _e3388 = select(88f, _e3386, (_e3386 < 88f));
let _e3390 = ((_e3388 * 1.442695f) + 0.5f);
let _e3392 = select(-127f, _e3390, (_e3390 > -127f));
let _e3394 = select(128f, _e3392, (_e3392 < 128f));
let _e3401 = select(0i, select(select(i32(_e3394), i32(-2147483648), (_e3394 < -2147483600f)), 2147483647i, (_e3394 > 2147483500f)), (_e3394 == _e3394));
let _e3405 = (_e3401 - select(0i, 1i, (_e3394 < f32(_e3401))));
let _e3406 = f32(_e3405);
let _e3410 = ((_e3388 - (_e3406 * 0.6933594f)) - (_e3406 * -2.1219444e-4f));
let _e3430 = ((1f + (_e3410 * (1f + (_e3410 * (0.5f + (_e3410 * (0.16666667f + (_e3410 * (0.041666668f + (_e3410 * (0.008333334f + (_e3410 * (0.001388889f + (_e3410 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3405 + 127i)) << bitcast<u32>(23i))));
let _e3431 = (1f - _e3430);
phi_6026_ = type_31(_e3430, _e3431, vec3<f32>(1f, 1f, 1f), vec3((0f * (_e3431 / select(1e-12f, _e3380, (_e3380 > 1e-12f))))));
} else {
let _e3439 = (_e2949 * 255f);
let _e3440 = (_e2570.member * 255f);
let _e3441 = (255f - 1f);
let _e3443 = select(0f, _e3439, (_e3439 > 0f));
let _e3445 = select(_e3441, _e3443, (_e3443 < _e3441));
let _e3452 = select(0i, select(select(i32(_e3445), i32(-2147483648), (_e3445 < -2147483600f)), 2147483647i, (_e3445 > 2147483500f)), (_e3445 == _e3445));
let _e3456 = (_e3452 - select(0i, 1i, (_e3445 < f32(_e3452))));
let _e3458 = select(0f, _e3440, (_e3440 > 0f));
let _e3460 = select(_e3441, _e3458, (_e3458 < _e3441));
let _e3467 = select(0i, select(select(i32(_e3460), i32(-2147483648), (_e3460 < -2147483600f)), 2147483647i, (_e3460 > 2147483500f)), (_e3460 == _e3460));
let _e3471 = (_e3467 - select(0i, 1i, (_e3460 < f32(_e3467))));
let _e3474 = (((_e3456 * 256i) + _e3471) * 4i);
let _e3476 = (_e3439 - f32(_e3456));
let _e3478 = (_e3440 - f32(_e3471));
let _e3480 = (bitcast<i32>(_e94) - 1i);
let _e3482 = select(_e3480, _e3474, (_e3474 < _e3480));
let _e3488 = global_4.member[bitcast<u32>(select(0i, _e3482, (_e3482 > 0i)))];
let _e3489 = (_e3474 + 4i);
let _e3491 = select(_e3480, _e3489, (_e3489 < _e3480));
let _e3497 = global_4.member[bitcast<u32>(select(0i, _e3491, (_e3491 > 0i)))];
let _e3498 = (_e3474 + 1024i);
let _e3500 = select(_e3480, _e3498, (_e3498 < _e3480));
let _e3506 = global_4.member[bitcast<u32>(select(0i, _e3500, (_e3500 > 0i)))];
let _e3507 = (_e3474 + 1028i);
let _e3509 = select(_e3480, _e3507, (_e3507 < _e3480));
let _e3515 = global_4.member[bitcast<u32>(select(0i, _e3509, (_e3509 > 0i)))];
let _e3520 = (bitcast<f32>(((_e3488 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3528 = (_e3520 + (((bitcast<f32>(((_e3497 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3520) * _e3478));
let _e3533 = (bitcast<f32>(((_e3506 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3544 = (_e3528 + (((_e3533 + (((bitcast<f32>(((_e3515 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3533) * _e3478)) - _e3528) * _e3476));
let _e3557 = (bitcast<f32>((((_e3488 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3565 = (_e3557 + (((bitcast<f32>((((_e3497 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3557) * _e3478));
let _e3570 = (bitcast<f32>((((_e3506 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3582 = (_e3474 + 1i);
let _e3584 = select(_e3480, _e3582, (_e3582 < _e3480));
let _e3590 = global_4.member[bitcast<u32>(select(0i, _e3584, (_e3584 > 0i)))];
let _e3591 = (_e3474 + 5i);
let _e3593 = select(_e3480, _e3591, (_e3591 < _e3480));
let _e3599 = global_4.member[bitcast<u32>(select(0i, _e3593, (_e3593 > 0i)))];
let _e3600 = (_e3474 + 1025i);
let _e3602 = select(_e3480, _e3600, (_e3600 < _e3480));
let _e3608 = global_4.member[bitcast<u32>(select(0i, _e3602, (_e3602 > 0i)))];
let _e3609 = (_e3474 + 1029i);
let _e3611 = select(_e3480, _e3609, (_e3609 < _e3480));
let _e3617 = global_4.member[bitcast<u32>(select(0i, _e3611, (_e3611 > 0i)))];
let _e3622 = (bitcast<f32>(((_e3590 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3630 = (_e3622 + (((bitcast<f32>(((_e3599 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3622) * _e3478));
let _e3635 = (bitcast<f32>(((_e3608 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3659 = (bitcast<f32>((((_e3590 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3667 = (_e3659 + (((bitcast<f32>((((_e3599 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3659) * _e3478));
let _e3672 = (bitcast<f32>((((_e3608 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3687 = (_e3272 * _e3157.member_1);
let _e3689 = -(((_e3565 + (((_e3570 + (((bitcast<f32>((((_e3515 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3570) * _e3478)) - _e3565) * _e3476)) * _e3687));
let _e3691 = select(-87f, _e3689, (_e3689 > -87f));
let _e3693 = select(88f, _e3691, (_e3691 < 88f));
let _e3695 = ((_e3693 * 1.442695f) + 0.5f);
let _e3697 = select(-127f, _e3695, (_e3695 > -127f));
let _e3699 = select(128f, _e3697, (_e3697 < 128f));
let _e3706 = select(0i, select(select(i32(_e3699), i32(-2147483648), (_e3699 < -2147483600f)), 2147483647i, (_e3699 > 2147483500f)), (_e3699 == _e3699));
let _e3710 = (_e3706 - select(0i, 1i, (_e3699 < f32(_e3706))));
let _e3711 = f32(_e3710);
let _e3715 = ((_e3693 - (_e3711 * 0.6933594f)) - (_e3711 * -2.1219444e-4f));
let _e3737 = -(((_e3630 + (((_e3635 + (((bitcast<f32>(((_e3617 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3635) * _e3478)) - _e3630) * _e3476)) * _e3687));
let _e3739 = select(-87f, _e3737, (_e3737 > -87f));
let _e3741 = select(88f, _e3739, (_e3739 < 88f));
let _e3743 = ((_e3741 * 1.442695f) + 0.5f);
let _e3745 = select(-127f, _e3743, (_e3743 > -127f));
let _e3747 = select(128f, _e3745, (_e3745 < 128f));
let _e3754 = select(0i, select(select(i32(_e3747), i32(-2147483648), (_e3747 < -2147483600f)), 2147483647i, (_e3747 > 2147483500f)), (_e3747 == _e3747));
let _e3758 = (_e3754 - select(0i, 1i, (_e3747 < f32(_e3754))));
let _e3759 = f32(_e3758);
let _e3763 = ((_e3741 - (_e3759 * 0.6933594f)) - (_e3759 * -2.1219444e-4f));
let _e3785 = -(((_e3667 + (((_e3672 + (((bitcast<f32>((((_e3617 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3672) * _e3478)) - _e3667) * _e3476)) * _e3687));
let _e3787 = select(-87f, _e3785, (_e3785 > -87f));
let _e3789 = select(88f, _e3787, (_e3787 < 88f));
let _e3791 = ((_e3789 * 1.442695f) + 0.5f);
let _e3793 = select(-127f, _e3791, (_e3791 > -127f));
let _e3795 = select(128f, _e3793, (_e3793 < 128f));
let _e3802 = select(0i, select(select(i32(_e3795), i32(-2147483648), (_e3795 < -2147483600f)), 2147483647i, (_e3795 > 2147483500f)), (_e3795 == _e3795));
let _e3806 = (_e3802 - select(0i, 1i, (_e3795 < f32(_e3802))));
let _e3807 = f32(_e3806);
let _e3811 = ((_e3789 - (_e3807 * 0.6933594f)) - (_e3807 * -2.1219444e-4f));
let _e3834 = -((_e3544 * (_e3272 * _e3157.member)));
let _e3836 = select(-87f, _e3834, (_e3834 > -87f));
let _e3838 = select(88f, _e3836, (_e3836 < 88f));
let _e3840 = ((_e3838 * 1.442695f) + 0.5f);
let _e3842 = select(-127f, _e3840, (_e3840 > -127f));
let _e3844 = select(128f, _e3842, (_e3842 < 128f));
let _e3851 = select(0i, select(select(i32(_e3844), i32(-2147483648), (_e3844 < -2147483600f)), 2147483647i, (_e3844 > 2147483500f)), (_e3844 == _e3844));
let _e3855 = (_e3851 - select(0i, 1i, (_e3844 < f32(_e3851))));
let _e3856 = f32(_e3855);
let _e3860 = ((_e3838 - (_e3856 * 0.6933594f)) - (_e3856 * -2.1219444e-4f));
let _e3880 = ((1f + (_e3860 * (1f + (_e3860 * (0.5f + (_e3860 * (0.16666667f + (_e3860 * (0.041666668f + (_e3860 * (0.008333334f + (_e3860 * (0.001388889f + (_e3860 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3855 + 127i)) << bitcast<u32>(23i))));
let _e3881 = (1f - _e3880);
phi_6026_ = type_31(_e3880, _e3881, vec3<f32>(((1f + (_e3715 * (1f + (_e3715 * (0.5f + (_e3715 * (0.16666667f + (_e3715 * (0.041666668f + (_e3715 * (0.008333334f + (_e3715 * (0.001388889f + (_e3715 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3710 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e3763 * (1f + (_e3763 * (0.5f + (_e3763 * (0.16666667f + (_e3763 * (0.041666668f + (_e3763 * (0.008333334f + (_e3763 * (0.001388889f + (_e3763 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3758 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e3811 * (1f + (_e3811 * (0.5f + (_e3811 * (0.16666667f + (_e3811 * (0.041666668f + (_e3811 * (0.008333334f + (_e3811 * (0.001388889f + (_e3811 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3806 + 127i)) << bitcast<u32>(23i))))), vec3((0f * (_e3881 / select(1e-12f, _e3544, (_e3544 > 1e-12f))))));
}
let _e3889 = phi_6026_;
if _e720 {
let _e3893 = global_1.member.member_5.member_2;
let _e3901 = global_1.member.member_5.member_4;
let _e3904 = (_e2570.member_3.x * _e3157.member_2);
let _e3906 = (_e2570.member_3.y * _e3157.member_2);
let _e3908 = (_e2570.member_3.z * _e3157.member_2);
let _e3909 = (0.5f * (_e3893 / select(1e-6f, _e184, (_e184 > 1e-6f))));
let _e3913 = (_e162 + (_e3904 * _e3909));
let _e3914 = (_e173 + (_e3906 * _e3909));
let _e3915 = (_e184 + (_e3908 * _e3909));
let _e3917 = (2f * _e3893);
let _e3919 = ((_e3915 * _e3915) + (_e3917 * _e3908));
let _e3923 = (_e3915 + sqrt(select(0f, _e3919, (_e3919 > 0f))));
let _e3927 = (0.5f * (_e3917 / select(1e-6f, _e3923, (_e3923 > 1e-6f))));
let _e3931 = (_e3913 + (_e3904 * _e3927));
let _e3932 = (_e3914 + (_e3906 * _e3927));
let _e3933 = (_e3915 + (_e3908 * _e3927));
let _e3937 = (_e3901 * _e3901);
let _e3939 = (_e3933 * _e3933);
let _e3947 = (((_e3915 <= 0f) || (_e3919 <= 0f)) || ((_e3933 <= 0f) || (_e3939 <= (_e3937 * (((_e3931 * _e3931) + (_e3932 * _e3932)) + _e3939)))));
let _e3961 = (_e162 + ((_e2570.member_4.x * _e3157.member_2) * _e3893));
let _e3962 = (_e173 + ((_e2570.member_4.y * _e3157.member_2) * _e3893));
let _e3963 = (_e184 + ((_e2570.member_4.z * _e3157.member_2) * _e3893));
let _e3965 = (_e3963 * _e3963);
let _e3974 = ((_e2952 & 1u) != 0u);
let _e3978 = select(_e3947, ((_e3963 <= 0f) || (_e3965 <= (_e3937 * (((_e3961 * _e3961) + (_e3962 * _e3962)) + _e3965)))), _e3974);
phi_6177_ = select(select(select(_e3933, _e3915, _e3947), _e3963, _e3974), _e184, _e3978);
phi_6178_ = select(select(select(_e3932, _e3914, _e3947), _e3962, _e3974), _e173, _e3978);
phi_6179_ = select(select(select(_e3931, _e3913, _e3947), _e3961, _e3974), _e162, _e3978);
phi_6180_ = select(1f, 0f, _e3978);
} else {
phi_6177_ = _e184;
phi_6178_ = _e173;
phi_6179_ = _e162;
phi_6180_ = 1f;
}
let _e3984 = phi_6177_;
let _e3986 = phi_6178_;
let _e3988 = phi_6179_;
let _e3990 = phi_6180_;
let _e3993 = (_e3889.member * _e3990);
global_5.member[_e119] = (_e130 * (_e3889.member_2.x * _e3993));
global_5.member[_e131] = (_e140 * (_e3889.member_2.y * _e3993));
global_5.member[_e142] = (_e151 * (_e3889.member_2.z * _e3993));
global_5.member[_e153] = _e3988;
global_5.member[_e164] = _e3986;
global_5.member[_e175] = _e3984;
global_5.member[_e186] = _e195;
global_5.member[_e197] = _e206;
global_5.member[_e208] = _e217;
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
