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
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_25;
@group(0) @binding(1)
var<storage> global_2: type_16;
@group(0) @binding(3)
var<storage> global_3: type_16;
@group(0) @binding(4)
var<storage> global_4: type_16;
@group(0) @binding(5)
var<storage> global_5: type_11;
@group(0) @binding(6)
var<storage, read_write> global_6: type_11;
fn function_() {
var local: type_28;
var local_1: vec3<f32>;
var local_2: type_28;
var local_3: vec3<f32>;
var local_4: type_28;
var local_5: vec3<f32>;
var phi_3694_: type_29;
var phi_4340_: type_30;
var phi_5209_: type_5;
var phi_6235_: vec3<f32>;
var phi_6236_: bool;
switch bitcast<i32>(0u) {
default: {
let _e86 = global;
let _e89 = arrayLength((&global_2.member));
let _e93 = arrayLength((&global_4.member));
let _e100 = global_1.member.member_2;
let _e103 = global_1.member.member;
let _e111 = (_e86.x + _e100.member);
let _e113 = (_e86.y + _e100.member_1);
if (_e111 < _e100.member_2) {
if (_e113 < _e100.member_3) {
let _e116 = (_e103.member * _e103.member_1);
let _e118 = ((_e113 * _e103.member) + _e111);
let _e119 = bitcast<i32>(_e118);
let _e121 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e123 = select(_e121, _e119, (_e119 < _e121));
let _e129 = global_6.member[bitcast<u32>(select(0i, _e123, (_e123 > 0i)))];
let _e130 = (_e116 + _e118);
let _e131 = bitcast<i32>(_e130);
let _e133 = select(_e121, _e131, (_e131 < _e121));
let _e139 = global_6.member[bitcast<u32>(select(0i, _e133, (_e133 > 0i)))];
let _e141 = ((2u * _e116) + _e118);
let _e142 = bitcast<i32>(_e141);
let _e144 = select(_e121, _e142, (_e142 < _e121));
let _e150 = global_6.member[bitcast<u32>(select(0i, _e144, (_e144 > 0i)))];
let _e152 = ((3u * _e116) + _e118);
let _e153 = bitcast<i32>(_e152);
let _e155 = select(_e121, _e153, (_e153 < _e121));
let _e161 = global_6.member[bitcast<u32>(select(0i, _e155, (_e155 > 0i)))];
let _e163 = ((4u * _e116) + _e118);
let _e164 = bitcast<i32>(_e163);
let _e166 = select(_e121, _e164, (_e164 < _e121));
let _e172 = global_6.member[bitcast<u32>(select(0i, _e166, (_e166 > 0i)))];
let _e174 = ((5u * _e116) + _e118);
let _e175 = bitcast<i32>(_e174);
let _e177 = select(_e121, _e175, (_e175 < _e121));
let _e183 = global_6.member[bitcast<u32>(select(0i, _e177, (_e177 > 0i)))];
let _e185 = ((6u * _e116) + _e118);
let _e186 = bitcast<i32>(_e185);
let _e188 = select(_e121, _e186, (_e186 < _e121));
let _e194 = global_6.member[bitcast<u32>(select(0i, _e188, (_e188 > 0i)))];
let _e196 = ((7u * _e116) + _e118);
let _e197 = bitcast<i32>(_e196);
let _e199 = select(_e121, _e197, (_e197 < _e121));
let _e205 = global_6.member[bitcast<u32>(select(0i, _e199, (_e199 > 0i)))];
let _e207 = ((8u * _e116) + _e118);
let _e208 = bitcast<i32>(_e207);
let _e210 = select(_e121, _e208, (_e208 < _e121));
let _e216 = global_6.member[bitcast<u32>(select(0i, _e210, (_e210 > 0i)))];
let _e218 = ((9u * _e116) + _e118);
let _e219 = bitcast<i32>(_e218);
let _e221 = select(_e121, _e219, (_e219 < _e121));
let _e227 = global_6.member[bitcast<u32>(select(0i, _e221, (_e221 > 0i)))];
let _e229 = ((10u * _e116) + _e118);
let _e230 = bitcast<i32>(_e229);
let _e232 = select(_e121, _e230, (_e230 < _e121));
let _e238 = global_6.member[bitcast<u32>(select(0i, _e232, (_e232 > 0i)))];
let _e243 = global_1.member.member_5.member_2;
let _e246 = (1f / select(1e-6f, _e194, (_e194 > 1e-6f)));
let _e250 = global_1.member.member_8.member_5;
let _e251 = (_e243 * _e250);
let _e256 = global_1.member.member_8.member_6;
let _e258 = (((_e172 * _e246) - _e256) * _e251);
let _e263 = global_1.member.member_8.member_7;
let _e265 = (((_e183 * _e246) - _e263) * _e251);
let _e269 = ((f32(bitcast<i32>(_e111)) - 0.5f) + _e129);
let _e273 = global_1.member.member_8.member_1;
let _e274 = (_e273 + 1u);
let _e276 = select(1u, _e274, (_e274 > 0u));
let _e277 = (_e276 == 0u);
if _e277 {
break;
}
let _e282 = ((f32(bitcast<i32>((_e113 % _e276))) - 0.5f) + _e139);
let _e286 = global_1.member.member_5.member;
let _e290 = global_1.member.member_8.member_8;
let _e291 = (_e286 - _e290);
let _e295 = global_1.member.member_8.member_2;
let _e302 = global_1.member.member_8.member_4;
let _e304 = ((_e295 + (_e256 * _e291)) + ((_e269 + 0.5f) * _e302));
let _e308 = global_1.member.member_8.member_3;
let _e313 = ((_e308 + (_e263 * _e291)) + ((_e282 + 0.5f) * _e302));
let _e319 = global_1.member.member_5.member_1;
let _e320 = (_e319 - _e290);
let _e325 = ((_e295 + (_e256 * _e320)) + (((_e269 + _e258) + 0.5f) * _e302));
let _e330 = ((_e308 + (_e263 * _e320)) + (((_e282 + _e265) + 0.5f) * _e302));
if _e277 {
break;
}
let _e333 = bitcast<i32>(((_e113 / _e276) * 3u));
let _e335 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e337 = select(_e335, _e333, (_e333 < _e335));
let _e343 = global_5.member[bitcast<u32>(select(0i, _e337, (_e337 > 0i)))];
let _e344 = (_e333 + 1i);
let _e346 = select(_e335, _e344, (_e344 < _e335));
let _e352 = global_5.member[bitcast<u32>(select(0i, _e346, (_e346 > 0i)))];
let _e353 = (_e333 + 2i);
let _e355 = select(_e335, _e353, (_e353 < _e335));
let _e361 = global_5.member[bitcast<u32>(select(0i, _e355, (_e355 > 0i)))];
let _e364 = (1f / select(1e-6f, _e361, (_e361 > 1e-6f)));
let _e367 = (((_e343 * _e364) - _e256) * _e251);
let _e370 = (((_e352 * _e364) - _e263) * _e251);
let _e382 = global_1.member.member_6.member;
let _e393 = ((((_e382.member.member * _e304) + (_e382.member.member_1 * _e313)) + (_e382.member.member_2 * _e286)) + _e382.member_1);
let _e397 = global_1.member.member_6.member_1;
let _e408 = ((((_e397.member.member * _e304) + (_e397.member.member_1 * _e313)) + (_e397.member.member_2 * _e286)) + _e397.member_1);
let _e412 = global_1.member.member_6.member_2;
let _e423 = ((((_e412.member.member * _e304) + (_e412.member.member_1 * _e313)) + (_e412.member.member_2 * _e286)) + _e412.member_1);
let _e429 = ((((_e382.member.member * _e325) + (_e382.member.member_1 * _e330)) + (_e382.member.member_2 * _e319)) + _e382.member_1);
let _e435 = ((((_e397.member.member * _e325) + (_e397.member.member_1 * _e330)) + (_e397.member.member_2 * _e319)) + _e397.member_1);
let _e441 = ((((_e412.member.member * _e325) + (_e412.member.member_1 * _e330)) + (_e412.member.member_2 * _e319)) + _e412.member_1);
let _e445 = global_1.member.member_6.member_4;
let _e450 = global_1.member.member_6.member_3.member;
let _e451 = (_e450 - 0.5f);
let _e453 = select(-0.5f, _e429, (_e429 > -0.5f));
let _e455 = select(_e451, _e453, (_e453 < _e451));
let _e460 = global_1.member.member_6.member_3.member_1;
let _e461 = (_e460 - 0.5f);
let _e463 = select(-0.5f, _e435, (_e435 > -0.5f));
let _e465 = select(_e461, _e463, (_e463 < _e461));
let _e470 = global_1.member.member_6.member_3.member_2;
let _e471 = (_e470 - 0.5f);
let _e473 = select(-0.5f, _e441, (_e441 > -0.5f));
let _e475 = select(_e471, _e473, (_e473 < _e471));
let _e476 = (_e429 - _e393);
let _e477 = (_e435 - _e408);
let _e478 = (_e441 - _e423);
let _e481 = bitcast<f32>((bitcast<u32>(_e476) & 2147483647u));
let _e484 = bitcast<f32>((bitcast<u32>(_e477) & 2147483647u));
let _e486 = select(_e484, _e481, (_e481 > _e484));
let _e489 = bitcast<f32>((bitcast<u32>(_e478) & 2147483647u));
let _e498 = bitcast<f32>((bitcast<u32>((_e429 - _e455)) & 2147483647u));
let _e501 = bitcast<f32>((bitcast<u32>((_e435 - _e465)) & 2147483647u));
let _e503 = select(_e501, _e498, (_e498 > _e501));
let _e506 = bitcast<f32>((bitcast<u32>((_e441 - _e475)) & 2147483647u));
let _e510 = (_e455 + 0.5f);
let _e511 = (_e450 - 1f);
let _e513 = select(0f, _e510, (_e510 > 0f));
let _e515 = select(_e511, _e513, (_e513 < _e511));
let _e522 = select(0i, select(select(i32(_e515), i32(-2147483648), (_e515 < -2147483600f)), 2147483647i, (_e515 > 2147483500f)), (_e515 == _e515));
let _e530 = global_1.member.member_6.member_12;
let _e531 = (_e530 & 31u);
let _e534 = (_e465 + 0.5f);
let _e535 = (_e460 - 1f);
let _e537 = select(0f, _e534, (_e534 > 0f));
let _e539 = select(_e535, _e537, (_e537 < _e535));
let _e546 = select(0i, select(select(i32(_e539), i32(-2147483648), (_e539 < -2147483600f)), 2147483647i, (_e539 > 2147483500f)), (_e539 == _e539));
let _e553 = (_e475 + 0.5f);
let _e554 = (_e470 - 1f);
let _e556 = select(0f, _e553, (_e553 > 0f));
let _e558 = select(_e554, _e556, (_e556 < _e554));
let _e565 = select(0i, select(select(i32(_e558), i32(-2147483648), (_e558 < -2147483600f)), 2147483647i, (_e558 > 2147483500f)), (_e558 == _e558));
let _e576 = global_1.member.member_6.member_9.member;
let _e582 = global_1.member.member_6.member_9.member_1;
let _e587 = global_1.member.member_6.member_10;
let _e593 = ((bitcast<i32>(_e587) + ((_e522 - select(0i, 1i, (_e515 < f32(_e522)))) >> bitcast<u32>(_e531))) + (bitcast<i32>(_e576) * (((_e546 - select(0i, 1i, (_e539 < f32(_e546)))) >> bitcast<u32>(_e531)) + (bitcast<i32>(_e582) * ((_e565 - select(0i, 1i, (_e558 < f32(_e565)))) >> bitcast<u32>(_e531))))));
let _e595 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e597 = select(_e595, _e593, (_e593 < _e595));
let _e603 = global_3.member[bitcast<u32>(select(0i, _e597, (_e597 > 0i)))];
let _e609 = global_1.member.member_1;
let _e616 = (((_e609 & 64u) != 0u) || ((((select(_e489, _e486, (_e486 > _e489)) <= _e445) && ((select(_e506, _e503, (_e503 > _e506)) > _e445) || (_e603 != 0u))) && true) && ((_e609 & 32u) != 0u)));
if (select(0u, select(7u, select(3u, 1u, ((((_e258 == 0f) && (_e265 == 0f)) && (_e367 == 0f)) && (_e370 == 0f))), _e616), (_e238 == 0f)) > 1u) {
if _e277 {
break;
}
if _e277 {
break;
}
let _e623 = (_e103.member_2 == 2u);
let _e626 = (((_e103.member_2 == 1u) || _e623) || (_e103.member_2 == 5u));
if _e626 {
let _e628 = select(-1f, _e455, (_e455 > -1f));
let _e630 = select(_e450, _e628, (_e628 < _e450));
let _e637 = select(0i, select(select(i32(_e630), i32(-2147483648), (_e630 < -2147483600f)), 2147483647i, (_e630 > 2147483500f)), (_e630 == _e630));
let _e641 = (_e637 - select(0i, 1i, (_e630 < f32(_e637))));
let _e643 = select(-1f, _e465, (_e465 > -1f));
let _e645 = select(_e460, _e643, (_e643 < _e460));
let _e652 = select(0i, select(select(i32(_e645), i32(-2147483648), (_e645 < -2147483600f)), 2147483647i, (_e645 > 2147483500f)), (_e645 == _e645));
let _e656 = (_e652 - select(0i, 1i, (_e645 < f32(_e652))));
let _e658 = select(-1f, _e475, (_e475 > -1f));
let _e660 = select(_e470, _e658, (_e658 < _e470));
let _e667 = select(0i, select(select(i32(_e660), i32(-2147483648), (_e660 < -2147483600f)), 2147483647i, (_e660 > 2147483500f)), (_e660 == _e660));
let _e671 = (_e667 - select(0i, 1i, (_e660 < f32(_e667))));
let _e675 = global_1.member.member_6.member_7;
let _e679 = global_1.member.member_6.member_8;
let _e687 = (select(0i, select(select(i32(_e460), i32(-2147483648), (_e460 < -2147483600f)), 2147483647i, (_e460 > 2147483500f)), (_e460 == _e460)) - 1i);
let _e688 = (_e656 - 1i);
let _e693 = (_e656 + 1i);
let _e696 = (_e656 + 2i);
let _e706 = (select(0i, select(select(i32(_e470), i32(-2147483648), (_e470 < -2147483600f)), 2147483647i, (_e470 > 2147483500f)), (_e470 == _e470)) - 1i);
let _e707 = (_e671 - 1i);
let _e712 = (_e671 + 1i);
let _e715 = (_e671 + 2i);
let _e725 = (select(0i, select(select(i32(_e450), i32(-2147483648), (_e450 < -2147483600f)), 2147483647i, (_e450 > 2147483500f)), (_e450 == _e450)) - 1i);
let _e726 = (_e641 - 1i);
let _e731 = (_e641 + 1i);
let _e734 = (_e641 + 2i);
let _e737 = (select(0i, _e688, (_e688 > 0i)) * _e675);
let _e738 = (select(0i, _e656, (_e656 > 0i)) * _e675);
let _e739 = (select(_e687, _e693, (_e693 < _e687)) * _e675);
let _e740 = (select(_e687, _e696, (_e696 < _e687)) * _e675);
let _e741 = (select(0i, _e707, (_e707 > 0i)) * _e679);
let _e742 = (select(0i, _e671, (_e671 > 0i)) * _e679);
let _e743 = (select(_e706, _e712, (_e712 < _e706)) * _e679);
let _e744 = (select(_e706, _e715, (_e715 < _e706)) * _e679);
local_4 = type_28(array<i32, 4>(select(0i, _e726, (_e726 > 0i)), select(0i, _e641, (_e641 > 0i)), select(_e725, _e731, (_e731 < _e725)), select(_e725, _e734, (_e734 < _e725))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_5 = vec3<f32>((_e455 - f32(_e641)), (_e465 - f32(_e656)), (_e475 - f32(_e671)));
let _e755 = (_e742 + _e738);
let _e758 = local_4.member[0u];
let _e759 = (_e755 + _e758);
let _e761 = (bitcast<i32>(_e89) - 1i);
let _e763 = select(_e761, _e759, (_e759 < _e761));
let _e768 = global_2.member[bitcast<u32>(select(0i, _e763, (_e763 > 0i)))];
let _e769 = bitcast<f32>(_e768);
let _e772 = local_4.member[1u];
let _e773 = (_e755 + _e772);
let _e775 = select(_e761, _e773, (_e773 < _e761));
let _e780 = global_2.member[bitcast<u32>(select(0i, _e775, (_e775 > 0i)))];
let _e781 = bitcast<f32>(_e780);
let _e784 = local_4.member[2u];
let _e785 = (_e755 + _e784);
let _e787 = select(_e761, _e785, (_e785 < _e761));
let _e792 = global_2.member[bitcast<u32>(select(0i, _e787, (_e787 > 0i)))];
let _e793 = bitcast<f32>(_e792);
let _e796 = local_4.member[3u];
let _e797 = (_e755 + _e796);
let _e799 = select(_e761, _e797, (_e797 < _e761));
let _e804 = global_2.member[bitcast<u32>(select(0i, _e799, (_e799 > 0i)))];
let _e806 = local_5[0u];
let _e809 = (_e769 + ((_e781 - _e769) * _e806));
let _e810 = local_5[0u];
let _e813 = (_e781 + ((_e793 - _e781) * _e810));
let _e814 = local_5[0u];
let _e817 = (_e793 + ((bitcast<f32>(_e804) - _e793) * _e814));
let _e818 = (_e742 + _e739);
let _e819 = local_4.member[0u];
let _e820 = (_e818 + _e819);
let _e822 = select(_e761, _e820, (_e820 < _e761));
let _e827 = global_2.member[bitcast<u32>(select(0i, _e822, (_e822 > 0i)))];
let _e828 = bitcast<f32>(_e827);
let _e829 = local_4.member[1u];
let _e830 = (_e818 + _e829);
let _e832 = select(_e761, _e830, (_e830 < _e761));
let _e837 = global_2.member[bitcast<u32>(select(0i, _e832, (_e832 > 0i)))];
let _e838 = bitcast<f32>(_e837);
let _e839 = local_4.member[2u];
let _e840 = (_e818 + _e839);
let _e842 = select(_e761, _e840, (_e840 < _e761));
let _e847 = global_2.member[bitcast<u32>(select(0i, _e842, (_e842 > 0i)))];
let _e848 = bitcast<f32>(_e847);
let _e849 = local_4.member[3u];
let _e850 = (_e818 + _e849);
let _e852 = select(_e761, _e850, (_e850 < _e761));
let _e857 = global_2.member[bitcast<u32>(select(0i, _e852, (_e852 > 0i)))];
let _e859 = local_5[0u];
let _e863 = local_5[0u];
let _e866 = (_e838 + ((_e848 - _e838) * _e863));
let _e867 = local_5[0u];
let _e871 = (_e743 + _e738);
let _e872 = local_4.member[0u];
let _e873 = (_e871 + _e872);
let _e875 = select(_e761, _e873, (_e873 < _e761));
let _e880 = global_2.member[bitcast<u32>(select(0i, _e875, (_e875 > 0i)))];
let _e881 = bitcast<f32>(_e880);
let _e882 = local_4.member[1u];
let _e883 = (_e871 + _e882);
let _e885 = select(_e761, _e883, (_e883 < _e761));
let _e890 = global_2.member[bitcast<u32>(select(0i, _e885, (_e885 > 0i)))];
let _e891 = bitcast<f32>(_e890);
let _e892 = local_4.member[2u];
let _e893 = (_e871 + _e892);
let _e895 = select(_e761, _e893, (_e893 < _e761));
let _e900 = global_2.member[bitcast<u32>(select(0i, _e895, (_e895 > 0i)))];
let _e901 = bitcast<f32>(_e900);
let _e902 = local_4.member[3u];
let _e903 = (_e871 + _e902);
let _e905 = select(_e761, _e903, (_e903 < _e761));
let _e910 = global_2.member[bitcast<u32>(select(0i, _e905, (_e905 > 0i)))];
let _e912 = local_5[0u];
let _e915 = (_e881 + ((_e891 - _e881) * _e912));
let _e916 = local_5[0u];
let _e919 = (_e891 + ((_e901 - _e891) * _e916));
let _e920 = local_5[0u];
let _e923 = (_e901 + ((bitcast<f32>(_e910) - _e901) * _e920));
let _e924 = (_e743 + _e739);
let _e925 = local_4.member[0u];
let _e926 = (_e924 + _e925);
let _e928 = select(_e761, _e926, (_e926 < _e761));
let _e933 = global_2.member[bitcast<u32>(select(0i, _e928, (_e928 > 0i)))];
let _e934 = bitcast<f32>(_e933);
let _e935 = local_4.member[1u];
let _e936 = (_e924 + _e935);
let _e938 = select(_e761, _e936, (_e936 < _e761));
let _e943 = global_2.member[bitcast<u32>(select(0i, _e938, (_e938 > 0i)))];
let _e944 = bitcast<f32>(_e943);
let _e945 = local_4.member[2u];
let _e946 = (_e924 + _e945);
let _e948 = select(_e761, _e946, (_e946 < _e761));
let _e953 = global_2.member[bitcast<u32>(select(0i, _e948, (_e948 > 0i)))];
let _e954 = bitcast<f32>(_e953);
let _e955 = local_4.member[3u];
let _e956 = (_e924 + _e955);
let _e958 = select(_e761, _e956, (_e956 < _e761));
let _e963 = global_2.member[bitcast<u32>(select(0i, _e958, (_e958 > 0i)))];
let _e965 = local_5[0u];
let _e969 = local_5[0u];
let _e972 = (_e944 + ((_e954 - _e944) * _e969));
let _e973 = local_5[0u];
let _e977 = (_e742 + _e737);
let _e978 = local_4.member[1u];
let _e979 = (_e977 + _e978);
let _e981 = select(_e761, _e979, (_e979 < _e761));
let _e986 = global_2.member[bitcast<u32>(select(0i, _e981, (_e981 > 0i)))];
let _e987 = bitcast<f32>(_e986);
let _e988 = local_4.member[2u];
let _e989 = (_e977 + _e988);
let _e991 = select(_e761, _e989, (_e989 < _e761));
let _e996 = global_2.member[bitcast<u32>(select(0i, _e991, (_e991 > 0i)))];
let _e998 = local_5[0u];
let _e1001 = (_e987 + ((bitcast<f32>(_e996) - _e987) * _e998));
let _e1002 = (_e742 + _e740);
let _e1003 = local_4.member[1u];
let _e1004 = (_e1002 + _e1003);
let _e1006 = select(_e761, _e1004, (_e1004 < _e761));
let _e1011 = global_2.member[bitcast<u32>(select(0i, _e1006, (_e1006 > 0i)))];
let _e1012 = bitcast<f32>(_e1011);
let _e1013 = local_4.member[2u];
let _e1014 = (_e1002 + _e1013);
let _e1016 = select(_e761, _e1014, (_e1014 < _e761));
let _e1021 = global_2.member[bitcast<u32>(select(0i, _e1016, (_e1016 > 0i)))];
let _e1023 = local_5[0u];
let _e1027 = (_e743 + _e737);
let _e1028 = local_4.member[1u];
let _e1029 = (_e1027 + _e1028);
let _e1031 = select(_e761, _e1029, (_e1029 < _e761));
let _e1036 = global_2.member[bitcast<u32>(select(0i, _e1031, (_e1031 > 0i)))];
let _e1037 = bitcast<f32>(_e1036);
let _e1038 = local_4.member[2u];
let _e1039 = (_e1027 + _e1038);
let _e1041 = select(_e761, _e1039, (_e1039 < _e761));
let _e1046 = global_2.member[bitcast<u32>(select(0i, _e1041, (_e1041 > 0i)))];
let _e1048 = local_5[0u];
let _e1051 = (_e1037 + ((bitcast<f32>(_e1046) - _e1037) * _e1048));
let _e1052 = (_e743 + _e740);
let _e1053 = local_4.member[1u];
let _e1054 = (_e1052 + _e1053);
let _e1056 = select(_e761, _e1054, (_e1054 < _e761));
let _e1061 = global_2.member[bitcast<u32>(select(0i, _e1056, (_e1056 > 0i)))];
let _e1062 = bitcast<f32>(_e1061);
let _e1063 = local_4.member[2u];
let _e1064 = (_e1052 + _e1063);
let _e1066 = select(_e761, _e1064, (_e1064 < _e761));
let _e1071 = global_2.member[bitcast<u32>(select(0i, _e1066, (_e1066 > 0i)))];
let _e1073 = local_5[0u];
let _e1077 = (_e741 + _e738);
let _e1078 = local_4.member[1u];
let _e1079 = (_e1077 + _e1078);
let _e1081 = select(_e761, _e1079, (_e1079 < _e761));
let _e1086 = global_2.member[bitcast<u32>(select(0i, _e1081, (_e1081 > 0i)))];
let _e1087 = bitcast<f32>(_e1086);
let _e1088 = local_4.member[2u];
let _e1089 = (_e1077 + _e1088);
let _e1091 = select(_e761, _e1089, (_e1089 < _e761));
let _e1096 = global_2.member[bitcast<u32>(select(0i, _e1091, (_e1091 > 0i)))];
let _e1098 = local_5[0u];
let _e1101 = (_e1087 + ((bitcast<f32>(_e1096) - _e1087) * _e1098));
let _e1102 = (_e744 + _e738);
let _e1103 = local_4.member[1u];
let _e1104 = (_e1102 + _e1103);
let _e1106 = select(_e761, _e1104, (_e1104 < _e761));
let _e1111 = global_2.member[bitcast<u32>(select(0i, _e1106, (_e1106 > 0i)))];
let _e1112 = bitcast<f32>(_e1111);
let _e1113 = local_4.member[2u];
let _e1114 = (_e1102 + _e1113);
let _e1116 = select(_e761, _e1114, (_e1114 < _e761));
let _e1121 = global_2.member[bitcast<u32>(select(0i, _e1116, (_e1116 > 0i)))];
let _e1123 = local_5[0u];
let _e1126 = (_e1112 + ((bitcast<f32>(_e1121) - _e1112) * _e1123));
let _e1127 = (_e741 + _e739);
let _e1128 = local_4.member[1u];
let _e1129 = (_e1127 + _e1128);
let _e1131 = select(_e761, _e1129, (_e1129 < _e761));
let _e1136 = global_2.member[bitcast<u32>(select(0i, _e1131, (_e1131 > 0i)))];
let _e1137 = bitcast<f32>(_e1136);
let _e1138 = local_4.member[2u];
let _e1139 = (_e1127 + _e1138);
let _e1141 = select(_e761, _e1139, (_e1139 < _e761));
let _e1146 = global_2.member[bitcast<u32>(select(0i, _e1141, (_e1141 > 0i)))];
let _e1148 = local_5[0u];
let _e1152 = (_e744 + _e739);
let _e1153 = local_4.member[1u];
let _e1154 = (_e1152 + _e1153);
let _e1156 = select(_e761, _e1154, (_e1154 < _e761));
let _e1161 = global_2.member[bitcast<u32>(select(0i, _e1156, (_e1156 > 0i)))];
let _e1162 = bitcast<f32>(_e1161);
let _e1163 = local_4.member[2u];
let _e1164 = (_e1152 + _e1163);
let _e1166 = select(_e761, _e1164, (_e1164 < _e761));
let _e1171 = global_2.member[bitcast<u32>(select(0i, _e1166, (_e1166 > 0i)))];
let _e1173 = local_5[0u];
let _e1178 = local_5[1u];
let _e1181 = (_e813 + ((_e866 - _e813) * _e1178));
let _e1182 = local_5[1u];
let _e1185 = (_e919 + ((_e972 - _e919) * _e1182));
let _e1186 = local_5[1u];
let _e1189 = (_e809 + (((_e828 + ((_e838 - _e828) * _e859)) - _e809) * _e1186));
let _e1190 = local_5[1u];
let _e1195 = local_5[2u];
let _e1199 = local_5[1u];
let _e1202 = (_e817 + (((_e848 + ((bitcast<f32>(_e857) - _e848) * _e867)) - _e817) * _e1199));
let _e1203 = local_5[1u];
let _e1207 = local_5[2u];
let _e1211 = local_5[1u];
let _e1214 = (_e1001 + ((_e813 - _e1001) * _e1211));
let _e1215 = local_5[1u];
let _e1219 = local_5[2u];
let _e1223 = local_5[1u];
let _e1226 = (_e866 + (((_e1012 + ((bitcast<f32>(_e1021) - _e1012) * _e1023)) - _e866) * _e1223));
let _e1227 = local_5[1u];
let _e1231 = local_5[2u];
let _e1235 = local_5[1u];
let _e1238 = (_e1101 + (((_e1137 + ((bitcast<f32>(_e1146) - _e1137) * _e1148)) - _e1101) * _e1235));
let _e1239 = local_5[2u];
let _e1243 = local_5[1u];
let _e1247 = local_5[2u];
let _e1251 = local_5[2u];
let _e1258 = global_1.member.member_6.member_5;
let _e1263 = global_1.member.member_6.member_6;
let _e1264 = (((_e1181 + ((_e1185 - _e1181) * _e1251)) * _e1258) + _e1263);
let _e1266 = select(0f, _e1264, (_e1264 > 0f));
let _e1268 = select(1f, _e1266, (_e1266 < 1f));
let _e1270 = (((_e1189 + (((_e915 + (((_e934 + ((_e944 - _e934) * _e965)) - _e915) * _e1190)) - _e1189) * _e1195)) * _e1258) + _e1263);
let _e1272 = select(0f, _e1270, (_e1270 > 0f));
let _e1274 = select(1f, _e1272, (_e1272 < 1f));
let _e1276 = (((_e1202 + (((_e923 + (((_e954 + ((bitcast<f32>(_e963) - _e954) * _e973)) - _e923) * _e1203)) - _e1202) * _e1207)) * _e1258) + _e1263);
let _e1278 = select(0f, _e1276, (_e1276 > 0f));
let _e1280 = select(1f, _e1278, (_e1278 < 1f));
let _e1282 = (((_e1214 + (((_e1051 + ((_e919 - _e1051) * _e1215)) - _e1214) * _e1219)) * _e1258) + _e1263);
let _e1284 = select(0f, _e1282, (_e1282 > 0f));
let _e1286 = select(1f, _e1284, (_e1284 < 1f));
let _e1288 = (((_e1226 + (((_e972 + (((_e1062 + ((bitcast<f32>(_e1071) - _e1062) * _e1073)) - _e972) * _e1227)) - _e1226) * _e1231)) * _e1258) + _e1263);
let _e1290 = select(0f, _e1288, (_e1288 > 0f));
let _e1292 = select(1f, _e1290, (_e1290 < 1f));
let _e1294 = (((_e1238 + ((_e1181 - _e1238) * _e1239)) * _e1258) + _e1263);
let _e1296 = select(0f, _e1294, (_e1294 > 0f));
let _e1298 = select(1f, _e1296, (_e1296 < 1f));
let _e1300 = (((_e1185 + (((_e1126 + (((_e1162 + ((bitcast<f32>(_e1171) - _e1162) * _e1173)) - _e1126) * _e1243)) - _e1185) * _e1247)) * _e1258) + _e1263);
let _e1302 = select(0f, _e1300, (_e1300 > 0f));
let _e1304 = select(1f, _e1302, (_e1302 < 1f));
let _e1305 = (_e1268 * 1024f);
let _e1306 = (1024f - 1f);
let _e1308 = select(0f, _e1305, (_e1305 > 0f));
let _e1310 = select(_e1306, _e1308, (_e1308 < _e1306));
let _e1317 = select(0i, select(select(i32(_e1310), i32(-2147483648), (_e1310 < -2147483600f)), 2147483647i, (_e1310 > 2147483500f)), (_e1310 == _e1310));
let _e1321 = (_e1317 - select(0i, 1i, (_e1310 < f32(_e1317))));
let _e1322 = (262147i + _e1321);
let _e1324 = (bitcast<i32>(_e93) - 1i);
let _e1326 = select(_e1324, _e1322, (_e1322 < _e1324));
let _e1332 = global_4.member[bitcast<u32>(select(0i, _e1326, (_e1326 > 0i)))];
let _e1342 = select(_e1324, 262146i, (262146i < _e1324));
let _e1348 = global_4.member[bitcast<u32>(select(0i, _e1342, (_e1342 > 0i)))];
let _e1349 = bitcast<f32>(_e1348);
let _e1350 = (f32((bitcast<i32>((_e1332 & 4095u)) - 2048i)) * _e1349);
let _e1352 = select(_e1324, 262144i, (262144i < _e1324));
let _e1358 = global_4.member[bitcast<u32>(select(0i, _e1352, (_e1352 > 0i)))];
let _e1359 = bitcast<f32>(_e1358);
let _e1361 = select(_e1324, 262145i, (262145i < _e1324));
let _e1367 = global_4.member[bitcast<u32>(select(0i, _e1361, (_e1361 > 0i)))];
let _e1368 = bitcast<f32>(_e1367);
let _e1374 = ((_e1359 + (f32(bitcast<i32>((_e1332 >> bitcast<u32>(12u)))) * _e1368)) + (_e1350 * (_e1305 - f32(_e1321))));
let _e1375 = (_e1350 * 1024f);
if _e623 {
let _e1382 = ((0.5f * (_e1280 - _e1274)) * _e1375);
let _e1383 = ((0.5f * (_e1292 - _e1286)) * _e1375);
let _e1384 = ((0.5f * (_e1304 - _e1298)) * _e1375);
phi_3694_ = type_29(_e1374, vec3<f32>(_e1382, _e1383, _e1384), vec3<f32>((_e1382 * _e1374), (_e1383 * _e1374), (_e1384 * _e1374)));
} else {
let _e1391 = (_e1274 * 1024f);
let _e1393 = select(0f, _e1391, (_e1391 > 0f));
let _e1395 = select(_e1306, _e1393, (_e1393 < _e1306));
let _e1402 = select(0i, select(select(i32(_e1395), i32(-2147483648), (_e1395 < -2147483600f)), 2147483647i, (_e1395 > 2147483500f)), (_e1395 == _e1395));
let _e1406 = (_e1402 - select(0i, 1i, (_e1395 < f32(_e1402))));
let _e1407 = (262147i + _e1406);
let _e1409 = select(_e1324, _e1407, (_e1407 < _e1324));
let _e1415 = global_4.member[bitcast<u32>(select(0i, _e1409, (_e1409 > 0i)))];
let _e1430 = ((_e1359 + (f32(bitcast<i32>((_e1415 >> bitcast<u32>(12u)))) * _e1368)) + ((f32((bitcast<i32>((_e1415 & 4095u)) - 2048i)) * _e1349) * (_e1391 - f32(_e1406))));
let _e1431 = (_e1280 * 1024f);
let _e1433 = select(0f, _e1431, (_e1431 > 0f));
let _e1435 = select(_e1306, _e1433, (_e1433 < _e1306));
let _e1442 = select(0i, select(select(i32(_e1435), i32(-2147483648), (_e1435 < -2147483600f)), 2147483647i, (_e1435 > 2147483500f)), (_e1435 == _e1435));
let _e1446 = (_e1442 - select(0i, 1i, (_e1435 < f32(_e1442))));
let _e1447 = (262147i + _e1446);
let _e1449 = select(_e1324, _e1447, (_e1447 < _e1324));
let _e1455 = global_4.member[bitcast<u32>(select(0i, _e1449, (_e1449 > 0i)))];
let _e1470 = ((_e1359 + (f32(bitcast<i32>((_e1455 >> bitcast<u32>(12u)))) * _e1368)) + ((f32((bitcast<i32>((_e1455 & 4095u)) - 2048i)) * _e1349) * (_e1431 - f32(_e1446))));
let _e1471 = (_e1286 * 1024f);
let _e1473 = select(0f, _e1471, (_e1471 > 0f));
let _e1475 = select(_e1306, _e1473, (_e1473 < _e1306));
let _e1482 = select(0i, select(select(i32(_e1475), i32(-2147483648), (_e1475 < -2147483600f)), 2147483647i, (_e1475 > 2147483500f)), (_e1475 == _e1475));
let _e1486 = (_e1482 - select(0i, 1i, (_e1475 < f32(_e1482))));
let _e1487 = (262147i + _e1486);
let _e1489 = select(_e1324, _e1487, (_e1487 < _e1324));
let _e1495 = global_4.member[bitcast<u32>(select(0i, _e1489, (_e1489 > 0i)))];
let _e1510 = ((_e1359 + (f32(bitcast<i32>((_e1495 >> bitcast<u32>(12u)))) * _e1368)) + ((f32((bitcast<i32>((_e1495 & 4095u)) - 2048i)) * _e1349) * (_e1471 - f32(_e1486))));
let _e1511 = (_e1292 * 1024f);
let _e1513 = select(0f, _e1511, (_e1511 > 0f));
let _e1515 = select(_e1306, _e1513, (_e1513 < _e1306));
let _e1522 = select(0i, select(select(i32(_e1515), i32(-2147483648), (_e1515 < -2147483600f)), 2147483647i, (_e1515 > 2147483500f)), (_e1515 == _e1515));
let _e1526 = (_e1522 - select(0i, 1i, (_e1515 < f32(_e1522))));
let _e1527 = (262147i + _e1526);
let _e1529 = select(_e1324, _e1527, (_e1527 < _e1324));
let _e1535 = global_4.member[bitcast<u32>(select(0i, _e1529, (_e1529 > 0i)))];
let _e1550 = ((_e1359 + (f32(bitcast<i32>((_e1535 >> bitcast<u32>(12u)))) * _e1368)) + ((f32((bitcast<i32>((_e1535 & 4095u)) - 2048i)) * _e1349) * (_e1511 - f32(_e1526))));
let _e1551 = (_e1298 * 1024f);
let _e1553 = select(0f, _e1551, (_e1551 > 0f));
let _e1555 = select(_e1306, _e1553, (_e1553 < _e1306));
let _e1562 = select(0i, select(select(i32(_e1555), i32(-2147483648), (_e1555 < -2147483600f)), 2147483647i, (_e1555 > 2147483500f)), (_e1555 == _e1555));
let _e1566 = (_e1562 - select(0i, 1i, (_e1555 < f32(_e1562))));
let _e1567 = (262147i + _e1566);
let _e1569 = select(_e1324, _e1567, (_e1567 < _e1324));
let _e1575 = global_4.member[bitcast<u32>(select(0i, _e1569, (_e1569 > 0i)))];
let _e1590 = ((_e1359 + (f32(bitcast<i32>((_e1575 >> bitcast<u32>(12u)))) * _e1368)) + ((f32((bitcast<i32>((_e1575 & 4095u)) - 2048i)) * _e1349) * (_e1551 - f32(_e1566))));
let _e1591 = (_e1304 * 1024f);
let _e1593 = select(0f, _e1591, (_e1591 > 0f));
let _e1595 = select(_e1306, _e1593, (_e1593 < _e1306));
let _e1602 = select(0i, select(select(i32(_e1595), i32(-2147483648), (_e1595 < -2147483600f)), 2147483647i, (_e1595 > 2147483500f)), (_e1595 == _e1595));
let _e1606 = (_e1602 - select(0i, 1i, (_e1595 < f32(_e1602))));
let _e1607 = (262147i + _e1606);
let _e1609 = select(_e1324, _e1607, (_e1607 < _e1324));
let _e1615 = global_4.member[bitcast<u32>(select(0i, _e1609, (_e1609 > 0i)))];
let _e1630 = ((_e1359 + (f32(bitcast<i32>((_e1615 >> bitcast<u32>(12u)))) * _e1368)) + ((f32((bitcast<i32>((_e1615 & 4095u)) - 2048i)) * _e1349) * (_e1591 - f32(_e1606))));
let _e1631 = (_e1470 - _e1430);
let _e1633 = (_e1550 - _e1510);
let _e1635 = (_e1630 - _e1590);
phi_3694_ = type_29(_e1374, vec3<f32>((0.5f * _e1631), (0.5f * _e1633), (0.5f * _e1635)), vec3<f32>((0.25f * (_e1631 * (_e1470 + _e1430))), (0.25f * (_e1633 * (_e1550 + _e1510))), (0.25f * (_e1635 * (_e1630 + _e1590)))));
}
let _e1650 = phi_3694_;
let _e1665 = select(0f, 1f, ((((((_e429 >= -0.5f) && (_e429 <= _e451)) && (_e435 >= -0.5f)) && (_e435 <= _e461)) && (_e441 >= -0.5f)) && (_e441 <= _e471)));
let _e1667 = (0.5f * (_e1280 - _e1274));
let _e1669 = (0.5f * (_e1292 - _e1286));
let _e1671 = (0.5f * (_e1304 - _e1298));
let _e1677 = global_1.member.member_6.member.member.member;
let _e1683 = global_1.member.member_6.member.member.member_1;
let _e1689 = global_1.member.member_6.member.member.member_2;
let _e1695 = global_1.member.member_6.member_1.member.member;
let _e1701 = global_1.member.member_6.member_1.member.member_1;
let _e1707 = global_1.member.member_6.member_1.member.member_2;
let _e1713 = global_1.member.member_6.member_2.member.member;
let _e1719 = global_1.member.member_6.member_2.member.member_1;
let _e1725 = global_1.member.member_6.member_2.member.member_2;
phi_4340_ = type_30(_e1268, vec3<f32>(((((_e1677 * _e1667) + (_e1695 * _e1669)) + (_e1713 * _e1671)) * _e1665), ((((_e1683 * _e1667) + (_e1701 * _e1669)) + (_e1719 * _e1671)) * _e1665), ((((_e1689 * _e1667) + (_e1707 * _e1669)) + (_e1725 * _e1671)) * _e1665)), _e1650.member, vec3<f32>(((((_e1677 * _e1650.member_2.x) + (_e1695 * _e1650.member_2.y)) + (_e1713 * _e1650.member_2.z)) * _e1665), ((((_e1683 * _e1650.member_2.x) + (_e1701 * _e1650.member_2.y)) + (_e1719 * _e1650.member_2.z)) * _e1665), ((((_e1689 * _e1650.member_2.x) + (_e1707 * _e1650.member_2.y)) + (_e1725 * _e1650.member_2.z)) * _e1665)), vec3<f32>(((((_e1677 * _e1650.member_1.x) + (_e1695 * _e1650.member_1.y)) + (_e1713 * _e1650.member_1.z)) * _e1665), ((((_e1683 * _e1650.member_1.x) + (_e1701 * _e1650.member_1.y)) + (_e1719 * _e1650.member_1.z)) * _e1665), ((((_e1689 * _e1650.member_1.x) + (_e1707 * _e1650.member_1.y)) + (_e1725 * _e1650.member_1.z)) * _e1665)));
} else {
let _e1791 = select(-1f, _e455, (_e455 > -1f));
let _e1793 = select(_e450, _e1791, (_e1791 < _e450));
let _e1800 = select(0i, select(select(i32(_e1793), i32(-2147483648), (_e1793 < -2147483600f)), 2147483647i, (_e1793 > 2147483500f)), (_e1793 == _e1793));
let _e1804 = (_e1800 - select(0i, 1i, (_e1793 < f32(_e1800))));
let _e1806 = select(-1f, _e465, (_e465 > -1f));
let _e1808 = select(_e460, _e1806, (_e1806 < _e460));
let _e1815 = select(0i, select(select(i32(_e1808), i32(-2147483648), (_e1808 < -2147483600f)), 2147483647i, (_e1808 > 2147483500f)), (_e1808 == _e1808));
let _e1819 = (_e1815 - select(0i, 1i, (_e1808 < f32(_e1815))));
let _e1821 = select(-1f, _e475, (_e475 > -1f));
let _e1823 = select(_e470, _e1821, (_e1821 < _e470));
let _e1830 = select(0i, select(select(i32(_e1823), i32(-2147483648), (_e1823 < -2147483600f)), 2147483647i, (_e1823 > 2147483500f)), (_e1823 == _e1823));
let _e1834 = (_e1830 - select(0i, 1i, (_e1823 < f32(_e1830))));
let _e1838 = global_1.member.member_6.member_7;
let _e1842 = global_1.member.member_6.member_8;
let _e1850 = (select(0i, select(select(i32(_e460), i32(-2147483648), (_e460 < -2147483600f)), 2147483647i, (_e460 > 2147483500f)), (_e460 == _e460)) - 1i);
let _e1853 = (_e1819 + 1i);
let _e1863 = (select(0i, select(select(i32(_e470), i32(-2147483648), (_e470 < -2147483600f)), 2147483647i, (_e470 > 2147483500f)), (_e470 == _e470)) - 1i);
let _e1866 = (_e1834 + 1i);
let _e1876 = (select(0i, select(select(i32(_e450), i32(-2147483648), (_e450 < -2147483600f)), 2147483647i, (_e450 > 2147483500f)), (_e450 == _e450)) - 1i);
let _e1877 = (_e1804 - 1i);
let _e1882 = (_e1804 + 1i);
let _e1885 = (_e1804 + 2i);
let _e1888 = (select(0i, _e1819, (_e1819 > 0i)) * _e1838);
let _e1889 = (select(_e1850, _e1853, (_e1853 < _e1850)) * _e1838);
let _e1890 = (select(0i, _e1834, (_e1834 > 0i)) * _e1842);
let _e1891 = (select(_e1863, _e1866, (_e1866 < _e1863)) * _e1842);
local_2 = type_28(array<i32, 4>(select(0i, _e1877, (_e1877 > 0i)), select(0i, _e1804, (_e1804 > 0i)), select(_e1876, _e1882, (_e1882 < _e1876)), select(_e1876, _e1885, (_e1885 < _e1876))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_3 = vec3<f32>((_e455 - f32(_e1804)), (_e465 - f32(_e1819)), (_e475 - f32(_e1834)));
let _e1902 = (_e1890 + _e1888);
let _e1905 = local_2.member[1u];
let _e1906 = (_e1902 + _e1905);
let _e1908 = (bitcast<i32>(_e89) - 1i);
let _e1910 = select(_e1908, _e1906, (_e1906 < _e1908));
let _e1915 = global_2.member[bitcast<u32>(select(0i, _e1910, (_e1910 > 0i)))];
let _e1916 = bitcast<f32>(_e1915);
let _e1919 = local_2.member[2u];
let _e1920 = (_e1902 + _e1919);
let _e1922 = select(_e1908, _e1920, (_e1920 < _e1908));
let _e1927 = global_2.member[bitcast<u32>(select(0i, _e1922, (_e1922 > 0i)))];
let _e1929 = local_3[0u];
let _e1932 = (_e1916 + ((bitcast<f32>(_e1927) - _e1916) * _e1929));
let _e1933 = (_e1890 + _e1889);
let _e1934 = local_2.member[1u];
let _e1935 = (_e1933 + _e1934);
let _e1937 = select(_e1908, _e1935, (_e1935 < _e1908));
let _e1942 = global_2.member[bitcast<u32>(select(0i, _e1937, (_e1937 > 0i)))];
let _e1943 = bitcast<f32>(_e1942);
let _e1944 = local_2.member[2u];
let _e1945 = (_e1933 + _e1944);
let _e1947 = select(_e1908, _e1945, (_e1945 < _e1908));
let _e1952 = global_2.member[bitcast<u32>(select(0i, _e1947, (_e1947 > 0i)))];
let _e1954 = local_3[0u];
let _e1959 = local_3[1u];
let _e1962 = (_e1932 + (((_e1943 + ((bitcast<f32>(_e1952) - _e1943) * _e1954)) - _e1932) * _e1959));
let _e1963 = (_e1891 + _e1888);
let _e1964 = local_2.member[1u];
let _e1965 = (_e1963 + _e1964);
let _e1967 = select(_e1908, _e1965, (_e1965 < _e1908));
let _e1972 = global_2.member[bitcast<u32>(select(0i, _e1967, (_e1967 > 0i)))];
let _e1973 = bitcast<f32>(_e1972);
let _e1974 = local_2.member[2u];
let _e1975 = (_e1963 + _e1974);
let _e1977 = select(_e1908, _e1975, (_e1975 < _e1908));
let _e1982 = global_2.member[bitcast<u32>(select(0i, _e1977, (_e1977 > 0i)))];
let _e1984 = local_3[0u];
let _e1987 = (_e1973 + ((bitcast<f32>(_e1982) - _e1973) * _e1984));
let _e1988 = (_e1891 + _e1889);
let _e1989 = local_2.member[1u];
let _e1990 = (_e1988 + _e1989);
let _e1992 = select(_e1908, _e1990, (_e1990 < _e1908));
let _e1997 = global_2.member[bitcast<u32>(select(0i, _e1992, (_e1992 > 0i)))];
let _e1998 = bitcast<f32>(_e1997);
let _e1999 = local_2.member[2u];
let _e2000 = (_e1988 + _e1999);
let _e2002 = select(_e1908, _e2000, (_e2000 < _e1908));
let _e2007 = global_2.member[bitcast<u32>(select(0i, _e2002, (_e2002 > 0i)))];
let _e2009 = local_3[0u];
let _e2013 = local_3[1u];
let _e2018 = local_3[2u];
let _e2025 = global_1.member.member_6.member_5;
let _e2030 = global_1.member.member_6.member_6;
let _e2031 = (((_e1962 + (((_e1987 + (((_e1998 + ((bitcast<f32>(_e2007) - _e1998) * _e2009)) - _e1987) * _e2013)) - _e1962) * _e2018)) * _e2025) + _e2030);
let _e2033 = select(0f, _e2031, (_e2031 > 0f));
phi_4340_ = type_30(select(1f, _e2033, (_e2033 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2038 = phi_4340_;
let _e2040 = select(-0.5f, _e393, (_e393 > -0.5f));
let _e2042 = select(_e451, _e2040, (_e2040 < _e451));
let _e2044 = select(-0.5f, _e408, (_e408 > -0.5f));
let _e2046 = select(_e461, _e2044, (_e2044 < _e461));
let _e2048 = select(-0.5f, _e423, (_e423 > -0.5f));
let _e2050 = select(_e471, _e2048, (_e2048 < _e471));
let _e2052 = select(-1f, _e2042, (_e2042 > -1f));
let _e2054 = select(_e450, _e2052, (_e2052 < _e450));
let _e2061 = select(0i, select(select(i32(_e2054), i32(-2147483648), (_e2054 < -2147483600f)), 2147483647i, (_e2054 > 2147483500f)), (_e2054 == _e2054));
let _e2065 = (_e2061 - select(0i, 1i, (_e2054 < f32(_e2061))));
let _e2067 = select(-1f, _e2046, (_e2046 > -1f));
let _e2069 = select(_e460, _e2067, (_e2067 < _e460));
let _e2076 = select(0i, select(select(i32(_e2069), i32(-2147483648), (_e2069 < -2147483600f)), 2147483647i, (_e2069 > 2147483500f)), (_e2069 == _e2069));
let _e2080 = (_e2076 - select(0i, 1i, (_e2069 < f32(_e2076))));
let _e2082 = select(-1f, _e2050, (_e2050 > -1f));
let _e2084 = select(_e470, _e2082, (_e2082 < _e470));
let _e2091 = select(0i, select(select(i32(_e2084), i32(-2147483648), (_e2084 < -2147483600f)), 2147483647i, (_e2084 > 2147483500f)), (_e2084 == _e2084));
let _e2095 = (_e2091 - select(0i, 1i, (_e2084 < f32(_e2091))));
let _e2099 = global_1.member.member_6.member_7;
let _e2103 = global_1.member.member_6.member_8;
let _e2111 = (select(0i, select(select(i32(_e460), i32(-2147483648), (_e460 < -2147483600f)), 2147483647i, (_e460 > 2147483500f)), (_e460 == _e460)) - 1i);
let _e2114 = (_e2080 + 1i);
let _e2124 = (select(0i, select(select(i32(_e470), i32(-2147483648), (_e470 < -2147483600f)), 2147483647i, (_e470 > 2147483500f)), (_e470 == _e470)) - 1i);
let _e2127 = (_e2095 + 1i);
let _e2137 = (select(0i, select(select(i32(_e450), i32(-2147483648), (_e450 < -2147483600f)), 2147483647i, (_e450 > 2147483500f)), (_e450 == _e450)) - 1i);
let _e2138 = (_e2065 - 1i);
let _e2143 = (_e2065 + 1i);
let _e2146 = (_e2065 + 2i);
let _e2149 = (select(0i, _e2080, (_e2080 > 0i)) * _e2099);
let _e2150 = (select(_e2111, _e2114, (_e2114 < _e2111)) * _e2099);
let _e2151 = (select(0i, _e2095, (_e2095 > 0i)) * _e2103);
let _e2152 = (select(_e2124, _e2127, (_e2127 < _e2124)) * _e2103);
local = type_28(array<i32, 4>(select(0i, _e2138, (_e2138 > 0i)), select(0i, _e2065, (_e2065 > 0i)), select(_e2137, _e2143, (_e2143 < _e2137)), select(_e2137, _e2146, (_e2146 < _e2137))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_1 = vec3<f32>((_e2042 - f32(_e2065)), (_e2046 - f32(_e2080)), (_e2050 - f32(_e2095)));
let _e2163 = (_e2151 + _e2149);
let _e2166 = local.member[1u];
let _e2167 = (_e2163 + _e2166);
let _e2169 = (bitcast<i32>(_e89) - 1i);
let _e2171 = select(_e2169, _e2167, (_e2167 < _e2169));
let _e2176 = global_2.member[bitcast<u32>(select(0i, _e2171, (_e2171 > 0i)))];
let _e2177 = bitcast<f32>(_e2176);
let _e2180 = local.member[2u];
let _e2181 = (_e2163 + _e2180);
let _e2183 = select(_e2169, _e2181, (_e2181 < _e2169));
let _e2188 = global_2.member[bitcast<u32>(select(0i, _e2183, (_e2183 > 0i)))];
let _e2190 = local_1[0u];
let _e2193 = (_e2177 + ((bitcast<f32>(_e2188) - _e2177) * _e2190));
let _e2194 = (_e2151 + _e2150);
let _e2195 = local.member[1u];
let _e2196 = (_e2194 + _e2195);
let _e2198 = select(_e2169, _e2196, (_e2196 < _e2169));
let _e2203 = global_2.member[bitcast<u32>(select(0i, _e2198, (_e2198 > 0i)))];
let _e2204 = bitcast<f32>(_e2203);
let _e2205 = local.member[2u];
let _e2206 = (_e2194 + _e2205);
let _e2208 = select(_e2169, _e2206, (_e2206 < _e2169));
let _e2213 = global_2.member[bitcast<u32>(select(0i, _e2208, (_e2208 > 0i)))];
let _e2215 = local_1[0u];
let _e2220 = local_1[1u];
let _e2223 = (_e2193 + (((_e2204 + ((bitcast<f32>(_e2213) - _e2204) * _e2215)) - _e2193) * _e2220));
let _e2224 = (_e2152 + _e2149);
let _e2225 = local.member[1u];
let _e2226 = (_e2224 + _e2225);
let _e2228 = select(_e2169, _e2226, (_e2226 < _e2169));
let _e2233 = global_2.member[bitcast<u32>(select(0i, _e2228, (_e2228 > 0i)))];
let _e2234 = bitcast<f32>(_e2233);
let _e2235 = local.member[2u];
let _e2236 = (_e2224 + _e2235);
let _e2238 = select(_e2169, _e2236, (_e2236 < _e2169));
let _e2243 = global_2.member[bitcast<u32>(select(0i, _e2238, (_e2238 > 0i)))];
let _e2245 = local_1[0u];
let _e2248 = (_e2234 + ((bitcast<f32>(_e2243) - _e2234) * _e2245));
let _e2249 = (_e2152 + _e2150);
let _e2250 = local.member[1u];
let _e2251 = (_e2249 + _e2250);
let _e2253 = select(_e2169, _e2251, (_e2251 < _e2169));
let _e2258 = global_2.member[bitcast<u32>(select(0i, _e2253, (_e2253 > 0i)))];
let _e2259 = bitcast<f32>(_e2258);
let _e2260 = local.member[2u];
let _e2261 = (_e2249 + _e2260);
let _e2263 = select(_e2169, _e2261, (_e2261 < _e2169));
let _e2268 = global_2.member[bitcast<u32>(select(0i, _e2263, (_e2263 > 0i)))];
let _e2270 = local_1[0u];
let _e2274 = local_1[1u];
let _e2279 = local_1[2u];
let _e2286 = global_1.member.member_6.member_5;
let _e2291 = global_1.member.member_6.member_6;
let _e2292 = (((_e2223 + (((_e2248 + (((_e2259 + ((bitcast<f32>(_e2268) - _e2259) * _e2270)) - _e2248) * _e2274)) - _e2223) * _e2279)) * _e2286) + _e2291);
let _e2294 = select(0f, _e2292, (_e2292 > 0f));
if ((_e609 & 16u) == 0u) {
phi_5209_ = type_5(1f, 1f, 1f);
} else {
let _e2302 = global_1.member.member_14.member;
let _e2313 = ((((_e2302.member.member * _e304) + (_e2302.member.member_1 * _e313)) + (_e2302.member.member_2 * _e286)) + _e2302.member_1);
let _e2319 = ((((_e2302.member.member * _e325) + (_e2302.member.member_1 * _e330)) + (_e2302.member.member_2 * _e319)) + _e2302.member_1);
let _e2321 = select(_e2319, _e2313, (_e2313 < _e2319));
let _e2323 = select(_e2319, _e2313, (_e2313 > _e2319));
let _e2325 = (_e2323 - _e2321);
let _e2328 = (-(_e2321) / select(1e-30f, _e2325, (_e2325 > 1e-30f)));
let _e2330 = select(0f, _e2328, (_e2328 > 0f));
let _e2336 = select(select(select(1f, _e2330, (_e2330 < 1f)), 1f, (_e2323 <= 0f)), 0f, (_e2321 > 0f));
let _e2341 = global_1.member.member_14.member_1;
let _e2342 = (_e2341 != 0u);
let _e2352 = global_1.member.member_15.member;
let _e2363 = ((((_e2352.member.member * _e304) + (_e2352.member.member_1 * _e313)) + (_e2352.member.member_2 * _e286)) + _e2352.member_1);
let _e2369 = ((((_e2352.member.member * _e325) + (_e2352.member.member_1 * _e330)) + (_e2352.member.member_2 * _e319)) + _e2352.member_1);
let _e2371 = select(_e2369, _e2363, (_e2363 < _e2369));
let _e2373 = select(_e2369, _e2363, (_e2363 > _e2369));
let _e2375 = (_e2373 - _e2371);
let _e2378 = (-(_e2371) / select(1e-30f, _e2375, (_e2375 > 1e-30f)));
let _e2380 = select(0f, _e2378, (_e2378 > 0f));
let _e2386 = select(select(select(1f, _e2380, (_e2380 < 1f)), 1f, (_e2373 <= 0f)), 0f, (_e2371 > 0f));
let _e2391 = global_1.member.member_15.member_1;
let _e2392 = (_e2391 != 0u);
let _e2402 = global_1.member.member_16.member;
let _e2413 = ((((_e2402.member.member * _e304) + (_e2402.member.member_1 * _e313)) + (_e2402.member.member_2 * _e286)) + _e2402.member_1);
let _e2419 = ((((_e2402.member.member * _e325) + (_e2402.member.member_1 * _e330)) + (_e2402.member.member_2 * _e319)) + _e2402.member_1);
let _e2421 = select(_e2419, _e2413, (_e2413 < _e2419));
let _e2423 = select(_e2419, _e2413, (_e2413 > _e2419));
let _e2425 = (_e2423 - _e2421);
let _e2428 = (-(_e2421) / select(1e-30f, _e2425, (_e2425 > 1e-30f)));
let _e2430 = select(0f, _e2428, (_e2428 > 0f));
let _e2436 = select(select(select(1f, _e2430, (_e2430 < 1f)), 1f, (_e2423 <= 0f)), 0f, (_e2421 > 0f));
let _e2441 = global_1.member.member_16.member_1;
let _e2442 = (_e2441 != 0u);
let _e2452 = global_1.member.member_17.member;
let _e2463 = ((((_e2452.member.member * _e304) + (_e2452.member.member_1 * _e313)) + (_e2452.member.member_2 * _e286)) + _e2452.member_1);
let _e2469 = ((((_e2452.member.member * _e325) + (_e2452.member.member_1 * _e330)) + (_e2452.member.member_2 * _e319)) + _e2452.member_1);
let _e2471 = select(_e2469, _e2463, (_e2463 < _e2469));
let _e2473 = select(_e2469, _e2463, (_e2463 > _e2469));
let _e2475 = (_e2473 - _e2471);
let _e2478 = (-(_e2471) / select(1e-30f, _e2475, (_e2475 > 1e-30f)));
let _e2480 = select(0f, _e2478, (_e2478 > 0f));
let _e2486 = select(select(select(1f, _e2480, (_e2480 < 1f)), 1f, (_e2473 <= 0f)), 0f, (_e2471 > 0f));
let _e2491 = global_1.member.member_17.member_1;
let _e2492 = (_e2491 != 0u);
phi_5209_ = type_5(((((1f * _e2336) * _e2386) * _e2436) * _e2486), ((((1f * select(1f, _e2336, _e2342)) * select(1f, _e2386, _e2392)) * select(1f, _e2436, _e2442)) * select(1f, _e2486, _e2492)), ((((1f * select(1f, 0f, (_e2342 && (_e2319 > 0f)))) * select(1f, 0f, (_e2392 && (_e2369 > 0f)))) * select(1f, 0f, (_e2442 && (_e2419 > 0f)))) * select(1f, 0f, (_e2492 && (_e2469 > 0f)))));
}
let _e2501 = phi_5209_;
let _e2502 = (_e325 - _e304);
let _e2503 = (_e330 - _e313);
let _e2504 = (_e319 - _e286);
let _e2509 = (((_e2502 * _e2502) + (_e2503 * _e2503)) + (_e2504 * _e2504));
let _e2513 = (_e481 < 1e-12f);
let _e2515 = (1f / select(_e476, 1f, _e2513));
let _e2517 = ((-0.5f - _e393) * _e2515);
let _e2519 = ((_e451 - _e393) * _e2515);
let _e2525 = select(_e2519, _e2517, (_e2517 < _e2519));
let _e2527 = select(0f, _e2525, (_e2525 > 0f));
let _e2530 = select(select(1f, _e2527, (_e2527 < 1f)), select(2f, 0f, ((_e393 >= -0.5f) && (_e393 <= _e451))), _e2513);
let _e2532 = select(_e2519, _e2517, (_e2517 > _e2519));
let _e2534 = select(0f, _e2532, (_e2532 > 0f));
let _e2537 = select(select(1f, _e2534, (_e2534 < 1f)), 1f, _e2513);
let _e2538 = (_e484 < 1e-12f);
let _e2540 = (1f / select(_e477, 1f, _e2538));
let _e2542 = ((-0.5f - _e408) * _e2540);
let _e2544 = ((_e461 - _e408) * _e2540);
let _e2550 = select(_e2544, _e2542, (_e2542 < _e2544));
let _e2552 = select(0f, _e2550, (_e2550 > 0f));
let _e2555 = select(select(1f, _e2552, (_e2552 < 1f)), select(2f, 0f, ((_e408 >= -0.5f) && (_e408 <= _e461))), _e2538);
let _e2557 = select(_e2544, _e2542, (_e2542 > _e2544));
let _e2559 = select(0f, _e2557, (_e2557 > 0f));
let _e2562 = select(select(1f, _e2559, (_e2559 < 1f)), 1f, _e2538);
let _e2563 = (_e489 < 1e-12f);
let _e2565 = (1f / select(_e478, 1f, _e2563));
let _e2567 = ((-0.5f - _e423) * _e2565);
let _e2569 = ((_e471 - _e423) * _e2565);
let _e2575 = select(_e2569, _e2567, (_e2567 < _e2569));
let _e2577 = select(0f, _e2575, (_e2575 > 0f));
let _e2580 = select(select(1f, _e2577, (_e2577 < 1f)), select(2f, 0f, ((_e423 >= -0.5f) && (_e423 <= _e471))), _e2563);
let _e2582 = select(_e2569, _e2567, (_e2567 > _e2569));
let _e2584 = select(0f, _e2582, (_e2582 > 0f));
let _e2587 = select(select(1f, _e2584, (_e2584 < 1f)), 1f, _e2563);
let _e2589 = select(_e2562, _e2537, (_e2537 < _e2562));
let _e2593 = select(_e2555, _e2530, (_e2530 > _e2555));
let _e2596 = (select(_e2587, _e2589, (_e2589 < _e2587)) - select(_e2580, _e2593, (_e2593 > _e2580)));
let _e2603 = global_1.member.member_5.member_3;
let _e2604 = ((sqrt(select(0f, _e2509, (_e2509 > 0f))) * select(0f, _e2596, (_e2596 > 0f))) * _e2603);
let _e2606 = (select(1f, _e2294, (_e2294 < 1f)) * 255f);
let _e2607 = (_e2038.member * 255f);
let _e2608 = (255f - 1f);
let _e2610 = select(0f, _e2606, (_e2606 > 0f));
let _e2612 = select(_e2608, _e2610, (_e2610 < _e2608));
let _e2619 = select(0i, select(select(i32(_e2612), i32(-2147483648), (_e2612 < -2147483600f)), 2147483647i, (_e2612 > 2147483500f)), (_e2612 == _e2612));
let _e2623 = (_e2619 - select(0i, 1i, (_e2612 < f32(_e2619))));
let _e2625 = select(0f, _e2607, (_e2607 > 0f));
let _e2627 = select(_e2608, _e2625, (_e2625 < _e2608));
let _e2634 = select(0i, select(select(i32(_e2627), i32(-2147483648), (_e2627 < -2147483600f)), 2147483647i, (_e2627 > 2147483500f)), (_e2627 == _e2627));
let _e2638 = (_e2634 - select(0i, 1i, (_e2627 < f32(_e2634))));
let _e2641 = (((_e2623 * 256i) + _e2638) * 4i);
let _e2643 = (_e2606 - f32(_e2623));
let _e2645 = (_e2607 - f32(_e2638));
let _e2647 = (bitcast<i32>(_e93) - 1i);
let _e2649 = select(_e2647, _e2641, (_e2641 < _e2647));
let _e2655 = global_4.member[bitcast<u32>(select(0i, _e2649, (_e2649 > 0i)))];
let _e2656 = (_e2641 + 4i);
let _e2658 = select(_e2647, _e2656, (_e2656 < _e2647));
let _e2664 = global_4.member[bitcast<u32>(select(0i, _e2658, (_e2658 > 0i)))];
let _e2665 = (_e2641 + 1024i);
let _e2667 = select(_e2647, _e2665, (_e2665 < _e2647));
let _e2673 = global_4.member[bitcast<u32>(select(0i, _e2667, (_e2667 > 0i)))];
let _e2674 = (_e2641 + 1028i);
let _e2676 = select(_e2647, _e2674, (_e2674 < _e2647));
let _e2682 = global_4.member[bitcast<u32>(select(0i, _e2676, (_e2676 > 0i)))];
let _e2687 = (bitcast<f32>(((_e2655 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2695 = (_e2687 + (((bitcast<f32>(((_e2664 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2687) * _e2645));
let _e2700 = (bitcast<f32>(((_e2673 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2724 = (bitcast<f32>((((_e2655 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2732 = (_e2724 + (((bitcast<f32>((((_e2664 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2724) * _e2645));
let _e2737 = (bitcast<f32>((((_e2673 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2749 = (_e2641 + 1i);
let _e2751 = select(_e2647, _e2749, (_e2749 < _e2647));
let _e2757 = global_4.member[bitcast<u32>(select(0i, _e2751, (_e2751 > 0i)))];
let _e2758 = (_e2641 + 5i);
let _e2760 = select(_e2647, _e2758, (_e2758 < _e2647));
let _e2766 = global_4.member[bitcast<u32>(select(0i, _e2760, (_e2760 > 0i)))];
let _e2767 = (_e2641 + 1025i);
let _e2769 = select(_e2647, _e2767, (_e2767 < _e2647));
let _e2775 = global_4.member[bitcast<u32>(select(0i, _e2769, (_e2769 > 0i)))];
let _e2776 = (_e2641 + 1029i);
let _e2778 = select(_e2647, _e2776, (_e2776 < _e2647));
let _e2784 = global_4.member[bitcast<u32>(select(0i, _e2778, (_e2778 > 0i)))];
let _e2789 = (bitcast<f32>(((_e2757 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2797 = (_e2789 + (((bitcast<f32>(((_e2766 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2789) * _e2645));
let _e2802 = (bitcast<f32>(((_e2775 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2826 = (bitcast<f32>((((_e2757 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2834 = (_e2826 + (((bitcast<f32>((((_e2766 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2826) * _e2645));
let _e2839 = (bitcast<f32>((((_e2775 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2854 = (_e2604 * _e2501.member_1);
let _e2856 = -(((_e2732 + (((_e2737 + (((bitcast<f32>((((_e2682 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2737) * _e2645)) - _e2732) * _e2643)) * _e2854));
let _e2858 = select(-87f, _e2856, (_e2856 > -87f));
let _e2860 = select(88f, _e2858, (_e2858 < 88f));
let _e2862 = ((_e2860 * 1.442695f) + 0.5f);
let _e2864 = select(-127f, _e2862, (_e2862 > -127f));
let _e2866 = select(128f, _e2864, (_e2864 < 128f));
let _e2873 = select(0i, select(select(i32(_e2866), i32(-2147483648), (_e2866 < -2147483600f)), 2147483647i, (_e2866 > 2147483500f)), (_e2866 == _e2866));
let _e2877 = (_e2873 - select(0i, 1i, (_e2866 < f32(_e2873))));
let _e2878 = f32(_e2877);
let _e2882 = ((_e2860 - (_e2878 * 0.6933594f)) - (_e2878 * -2.1219444e-4f));
let _e2904 = -(((_e2797 + (((_e2802 + (((bitcast<f32>(((_e2784 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2802) * _e2645)) - _e2797) * _e2643)) * _e2854));
let _e2906 = select(-87f, _e2904, (_e2904 > -87f));
let _e2908 = select(88f, _e2906, (_e2906 < 88f));
let _e2910 = ((_e2908 * 1.442695f) + 0.5f);
let _e2912 = select(-127f, _e2910, (_e2910 > -127f));
let _e2914 = select(128f, _e2912, (_e2912 < 128f));
let _e2921 = select(0i, select(select(i32(_e2914), i32(-2147483648), (_e2914 < -2147483600f)), 2147483647i, (_e2914 > 2147483500f)), (_e2914 == _e2914));
let _e2925 = (_e2921 - select(0i, 1i, (_e2914 < f32(_e2921))));
let _e2926 = f32(_e2925);
let _e2930 = ((_e2908 - (_e2926 * 0.6933594f)) - (_e2926 * -2.1219444e-4f));
let _e2952 = -(((_e2834 + (((_e2839 + (((bitcast<f32>((((_e2784 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2839) * _e2645)) - _e2834) * _e2643)) * _e2854));
let _e2954 = select(-87f, _e2952, (_e2952 > -87f));
let _e2956 = select(88f, _e2954, (_e2954 < 88f));
let _e2958 = ((_e2956 * 1.442695f) + 0.5f);
let _e2960 = select(-127f, _e2958, (_e2958 > -127f));
let _e2962 = select(128f, _e2960, (_e2960 < 128f));
let _e2969 = select(0i, select(select(i32(_e2962), i32(-2147483648), (_e2962 < -2147483600f)), 2147483647i, (_e2962 > 2147483500f)), (_e2962 == _e2962));
let _e2973 = (_e2969 - select(0i, 1i, (_e2962 < f32(_e2969))));
let _e2974 = f32(_e2973);
let _e2978 = ((_e2956 - (_e2974 * 0.6933594f)) - (_e2974 * -2.1219444e-4f));
let _e3000 = -(((_e2695 + (((_e2700 + (((bitcast<f32>(((_e2682 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2700) * _e2645)) - _e2695) * _e2643)) * (_e2604 * _e2501.member)));
let _e3002 = select(-87f, _e3000, (_e3000 > -87f));
let _e3004 = select(88f, _e3002, (_e3002 < 88f));
let _e3006 = ((_e3004 * 1.442695f) + 0.5f);
let _e3008 = select(-127f, _e3006, (_e3006 > -127f));
let _e3010 = select(128f, _e3008, (_e3008 < 128f));
let _e3017 = select(0i, select(select(i32(_e3010), i32(-2147483648), (_e3010 < -2147483600f)), 2147483647i, (_e3010 > 2147483500f)), (_e3010 == _e3010));
let _e3021 = (_e3017 - select(0i, 1i, (_e3010 < f32(_e3017))));
let _e3022 = f32(_e3021);
let _e3026 = ((_e3004 - (_e3022 * 0.6933594f)) - (_e3022 * -2.1219444e-4f));
let _e3046 = ((1f + (_e3026 * (1f + (_e3026 * (0.5f + (_e3026 * (0.16666667f + (_e3026 * (0.041666668f + (_e3026 * (0.008333334f + (_e3026 * (0.001388889f + (_e3026 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3021 + 127i)) << bitcast<u32>(23i))));
if _e626 {
let _e3061 = global_1.member.member_5.member_4;
let _e3064 = (_e2038.member_3.x * _e2501.member_2);
let _e3066 = (_e2038.member_3.y * _e2501.member_2);
let _e3068 = (_e2038.member_3.z * _e2501.member_2);
let _e3069 = (0.5f * (_e243 / _e194));
let _e3073 = (_e172 + (_e3064 * _e3069));
let _e3074 = (_e183 + (_e3066 * _e3069));
let _e3075 = (_e194 + (_e3068 * _e3069));
let _e3077 = (2f * _e243);
let _e3079 = ((_e3075 * _e3075) + (_e3077 * _e3068));
let _e3083 = (_e3075 + sqrt(select(0f, _e3079, (_e3079 > 0f))));
let _e3087 = (0.5f * (_e3077 / select(1e-6f, _e3083, (_e3083 > 1e-6f))));
let _e3091 = (_e3073 + (_e3064 * _e3087));
let _e3092 = (_e3074 + (_e3066 * _e3087));
let _e3093 = (_e3075 + (_e3068 * _e3087));
let _e3097 = (_e3061 * _e3061);
let _e3099 = (_e3093 * _e3093);
let _e3107 = (((_e3075 <= 0f) || (_e3079 <= 0f)) || ((_e3093 <= 0f) || (_e3099 <= (_e3097 * (((_e3091 * _e3091) + (_e3092 * _e3092)) + _e3099)))));
let _e3121 = (_e172 + ((_e2038.member_4.x * _e2501.member_2) * _e243));
let _e3122 = (_e183 + ((_e2038.member_4.y * _e2501.member_2) * _e243));
let _e3123 = (_e194 + ((_e2038.member_4.z * _e2501.member_2) * _e243));
let _e3125 = (_e3123 * _e3123);
let _e3134 = ((_e609 & 1u) != 0u);
phi_6235_ = vec3<f32>(select(select(select(_e3091, _e3073, _e3107), _e3121, _e3134), _e172, _e616), select(select(select(_e3092, _e3074, _e3107), _e3122, _e3134), _e183, _e616), select(select(select(_e3093, _e3075, _e3107), _e3123, _e3134), _e194, _e616));
phi_6236_ = (select(_e3107, ((_e3123 <= 0f) || (_e3125 <= (_e3097 * (((_e3121 * _e3121) + (_e3122 * _e3122)) + _e3125)))), _e3134) && !(_e616));
} else {
phi_6235_ = vec3<f32>(_e172, _e183, _e194);
phi_6236_ = false;
}
let _e3146 = phi_6235_;
let _e3148 = phi_6236_;
global_6.member[_e118] = (_e129 + _e258);
global_6.member[_e130] = (_e139 + _e265);
global_6.member[_e141] = (_e150 + _e367);
global_6.member[_e152] = (_e161 + _e370);
global_6.member[_e163] = _e3146.x;
global_6.member[_e174] = _e3146.y;
global_6.member[_e185] = _e3146.z;
global_6.member[_e196] = select((_e205 * (((1f + (_e2882 * (1f + (_e2882 * (0.5f + (_e2882 * (0.16666667f + (_e2882 * (0.041666668f + (_e2882 * (0.008333334f + (_e2882 * (0.001388889f + (_e2882 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2877 + 127i)) << bitcast<u32>(23i)))) * _e3046)), _e205, _e616);
global_6.member[_e207] = select((_e216 * (((1f + (_e2930 * (1f + (_e2930 * (0.5f + (_e2930 * (0.16666667f + (_e2930 * (0.041666668f + (_e2930 * (0.008333334f + (_e2930 * (0.001388889f + (_e2930 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2925 + 127i)) << bitcast<u32>(23i)))) * _e3046)), _e216, _e616);
global_6.member[_e218] = select((_e227 * (((1f + (_e2978 * (1f + (_e2978 * (0.5f + (_e2978 * (0.16666667f + (_e2978 * (0.041666668f + (_e2978 * (0.008333334f + (_e2978 * (0.001388889f + (_e2978 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2973 + 127i)) << bitcast<u32>(23i)))) * _e3046)), _e227, _e616);
global_6.member[_e229] = select(_e238, 1f, _e3148);
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
