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
var phi_4104_: type_29;
var phi_4882_: type_30;
var phi_5883_: type_5;
var phi_6909_: vec3<f32>;
var phi_6910_: bool;
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
let _e724 = select(0i, select(select(i32(_e450), i32(-2147483648), (_e450 < -2147483600f)), 2147483647i, (_e450 > 2147483500f)), (_e450 == _e450));
let _e725 = (_e724 - 1i);
let _e726 = (_e641 - 1i);
let _e728 = select(0i, _e726, (_e726 > 0i));
let _e730 = select(0i, _e641, (_e641 > 0i));
let _e731 = (_e641 + 1i);
let _e733 = select(_e725, _e731, (_e731 < _e725));
let _e734 = (_e641 + 2i);
let _e737 = (_e724 - 2i);
let _e739 = select(0i, _e737, (_e737 > 0i));
let _e741 = select(_e739, _e728, (_e728 < _e739));
let _e743 = select(_e739, _e730, (_e730 < _e739));
let _e745 = select(_e739, _e733, (_e733 < _e739));
let _e764 = (select(0i, _e688, (_e688 > 0i)) * _e675);
let _e765 = (select(0i, _e656, (_e656 > 0i)) * _e675);
let _e766 = (select(_e687, _e693, (_e693 < _e687)) * _e675);
let _e767 = (select(_e687, _e696, (_e696 < _e687)) * _e675);
let _e768 = (select(0i, _e707, (_e707 > 0i)) * _e679);
let _e769 = (select(0i, _e671, (_e671 > 0i)) * _e679);
let _e770 = (select(_e706, _e712, (_e712 < _e706)) * _e679);
let _e771 = (select(_e706, _e715, (_e715 < _e706)) * _e679);
local_4 = type_28(array<i32, 4>(_e741, _e743, _e745, 0i), array<u32, 6>(bitcast<u32>(((_e728 - _e741) * 16i)), bitcast<u32>(((_e730 - _e741) * 16i)), bitcast<u32>(((_e730 - _e743) * 16i)), bitcast<u32>(((_e733 - _e743) * 16i)), bitcast<u32>(((_e733 - _e745) * 16i)), bitcast<u32>(((select(_e725, _e734, (_e734 < _e725)) - _e745) * 16i))));
local_5 = vec3<f32>((_e455 - f32(_e641)), (_e465 - f32(_e656)), (_e475 - f32(_e671)));
let _e783 = (_e769 + _e765);
let _e786 = local_4.member[0u];
let _e787 = (_e783 + _e786);
let _e789 = (_e787 >> bitcast<u32>(1i));
let _e792 = bitcast<u32>(((_e787 & 1i) * 16i));
let _e794 = (bitcast<i32>(_e89) - 1i);
let _e796 = select(_e794, _e789, (_e789 < _e794));
let _e801 = global_2.member[bitcast<u32>(select(0i, _e796, (_e796 > 0i)))];
let _e805 = (_e789 + 1i);
let _e807 = select(_e794, _e805, (_e805 < _e794));
let _e812 = global_2.member[bitcast<u32>(select(0i, _e807, (_e807 > 0i)))];
let _e819 = ((_e801 >> bitcast<u32>((_e792 & 31u))) | ((_e812 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e792) & 31u))));
let _e822 = local_4.member[2u];
let _e823 = (_e783 + _e822);
let _e825 = (_e823 >> bitcast<u32>(1i));
let _e828 = bitcast<u32>(((_e823 & 1i) * 16i));
let _e830 = select(_e794, _e825, (_e825 < _e794));
let _e835 = global_2.member[bitcast<u32>(select(0i, _e830, (_e830 > 0i)))];
let _e839 = (_e825 + 1i);
let _e841 = select(_e794, _e839, (_e839 < _e794));
let _e846 = global_2.member[bitcast<u32>(select(0i, _e841, (_e841 > 0i)))];
let _e853 = ((_e835 >> bitcast<u32>((_e828 & 31u))) | ((_e846 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e828) & 31u))));
let _e856 = local_4.member_1[0u];
let _e862 = f32(bitcast<i32>(((_e819 >> bitcast<u32>((_e856 & 31u))) & 65535u)));
let _e865 = local_4.member_1[1u];
let _e871 = f32(bitcast<i32>(((_e819 >> bitcast<u32>((_e865 & 31u))) & 65535u)));
let _e874 = local_4.member_1[4u];
let _e880 = f32(bitcast<i32>(((_e853 >> bitcast<u32>((_e874 & 31u))) & 65535u)));
let _e883 = local_4.member_1[5u];
let _e890 = local_5[0u];
let _e893 = (_e862 + ((_e871 - _e862) * _e890));
let _e894 = local_5[0u];
let _e897 = (_e871 + ((_e880 - _e871) * _e894));
let _e898 = local_5[0u];
let _e901 = (_e880 + ((f32(bitcast<i32>(((_e853 >> bitcast<u32>((_e883 & 31u))) & 65535u))) - _e880) * _e898));
let _e902 = (_e769 + _e766);
let _e903 = local_4.member[0u];
let _e904 = (_e902 + _e903);
let _e906 = (_e904 >> bitcast<u32>(1i));
let _e909 = bitcast<u32>(((_e904 & 1i) * 16i));
let _e911 = select(_e794, _e906, (_e906 < _e794));
let _e916 = global_2.member[bitcast<u32>(select(0i, _e911, (_e911 > 0i)))];
let _e920 = (_e906 + 1i);
let _e922 = select(_e794, _e920, (_e920 < _e794));
let _e927 = global_2.member[bitcast<u32>(select(0i, _e922, (_e922 > 0i)))];
let _e934 = ((_e916 >> bitcast<u32>((_e909 & 31u))) | ((_e927 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e909) & 31u))));
let _e935 = local_4.member[2u];
let _e936 = (_e902 + _e935);
let _e938 = (_e936 >> bitcast<u32>(1i));
let _e941 = bitcast<u32>(((_e936 & 1i) * 16i));
let _e943 = select(_e794, _e938, (_e938 < _e794));
let _e948 = global_2.member[bitcast<u32>(select(0i, _e943, (_e943 > 0i)))];
let _e952 = (_e938 + 1i);
let _e954 = select(_e794, _e952, (_e952 < _e794));
let _e959 = global_2.member[bitcast<u32>(select(0i, _e954, (_e954 > 0i)))];
let _e966 = ((_e948 >> bitcast<u32>((_e941 & 31u))) | ((_e959 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e941) & 31u))));
let _e967 = local_4.member_1[0u];
let _e973 = f32(bitcast<i32>(((_e934 >> bitcast<u32>((_e967 & 31u))) & 65535u)));
let _e974 = local_4.member_1[1u];
let _e980 = f32(bitcast<i32>(((_e934 >> bitcast<u32>((_e974 & 31u))) & 65535u)));
let _e981 = local_4.member_1[4u];
let _e987 = f32(bitcast<i32>(((_e966 >> bitcast<u32>((_e981 & 31u))) & 65535u)));
let _e988 = local_4.member_1[5u];
let _e995 = local_5[0u];
let _e999 = local_5[0u];
let _e1002 = (_e980 + ((_e987 - _e980) * _e999));
let _e1003 = local_5[0u];
let _e1007 = (_e770 + _e765);
let _e1008 = local_4.member[0u];
let _e1009 = (_e1007 + _e1008);
let _e1011 = (_e1009 >> bitcast<u32>(1i));
let _e1014 = bitcast<u32>(((_e1009 & 1i) * 16i));
let _e1016 = select(_e794, _e1011, (_e1011 < _e794));
let _e1021 = global_2.member[bitcast<u32>(select(0i, _e1016, (_e1016 > 0i)))];
let _e1025 = (_e1011 + 1i);
let _e1027 = select(_e794, _e1025, (_e1025 < _e794));
let _e1032 = global_2.member[bitcast<u32>(select(0i, _e1027, (_e1027 > 0i)))];
let _e1039 = ((_e1021 >> bitcast<u32>((_e1014 & 31u))) | ((_e1032 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1014) & 31u))));
let _e1040 = local_4.member[2u];
let _e1041 = (_e1007 + _e1040);
let _e1043 = (_e1041 >> bitcast<u32>(1i));
let _e1046 = bitcast<u32>(((_e1041 & 1i) * 16i));
let _e1048 = select(_e794, _e1043, (_e1043 < _e794));
let _e1053 = global_2.member[bitcast<u32>(select(0i, _e1048, (_e1048 > 0i)))];
let _e1057 = (_e1043 + 1i);
let _e1059 = select(_e794, _e1057, (_e1057 < _e794));
let _e1064 = global_2.member[bitcast<u32>(select(0i, _e1059, (_e1059 > 0i)))];
let _e1071 = ((_e1053 >> bitcast<u32>((_e1046 & 31u))) | ((_e1064 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1046) & 31u))));
let _e1072 = local_4.member_1[0u];
let _e1078 = f32(bitcast<i32>(((_e1039 >> bitcast<u32>((_e1072 & 31u))) & 65535u)));
let _e1079 = local_4.member_1[1u];
let _e1085 = f32(bitcast<i32>(((_e1039 >> bitcast<u32>((_e1079 & 31u))) & 65535u)));
let _e1086 = local_4.member_1[4u];
let _e1092 = f32(bitcast<i32>(((_e1071 >> bitcast<u32>((_e1086 & 31u))) & 65535u)));
let _e1093 = local_4.member_1[5u];
let _e1100 = local_5[0u];
let _e1103 = (_e1078 + ((_e1085 - _e1078) * _e1100));
let _e1104 = local_5[0u];
let _e1107 = (_e1085 + ((_e1092 - _e1085) * _e1104));
let _e1108 = local_5[0u];
let _e1111 = (_e1092 + ((f32(bitcast<i32>(((_e1071 >> bitcast<u32>((_e1093 & 31u))) & 65535u))) - _e1092) * _e1108));
let _e1112 = (_e770 + _e766);
let _e1113 = local_4.member[0u];
let _e1114 = (_e1112 + _e1113);
let _e1116 = (_e1114 >> bitcast<u32>(1i));
let _e1119 = bitcast<u32>(((_e1114 & 1i) * 16i));
let _e1121 = select(_e794, _e1116, (_e1116 < _e794));
let _e1126 = global_2.member[bitcast<u32>(select(0i, _e1121, (_e1121 > 0i)))];
let _e1130 = (_e1116 + 1i);
let _e1132 = select(_e794, _e1130, (_e1130 < _e794));
let _e1137 = global_2.member[bitcast<u32>(select(0i, _e1132, (_e1132 > 0i)))];
let _e1144 = ((_e1126 >> bitcast<u32>((_e1119 & 31u))) | ((_e1137 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1119) & 31u))));
let _e1145 = local_4.member[2u];
let _e1146 = (_e1112 + _e1145);
let _e1148 = (_e1146 >> bitcast<u32>(1i));
let _e1151 = bitcast<u32>(((_e1146 & 1i) * 16i));
let _e1153 = select(_e794, _e1148, (_e1148 < _e794));
let _e1158 = global_2.member[bitcast<u32>(select(0i, _e1153, (_e1153 > 0i)))];
let _e1162 = (_e1148 + 1i);
let _e1164 = select(_e794, _e1162, (_e1162 < _e794));
let _e1169 = global_2.member[bitcast<u32>(select(0i, _e1164, (_e1164 > 0i)))];
let _e1176 = ((_e1158 >> bitcast<u32>((_e1151 & 31u))) | ((_e1169 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1151) & 31u))));
let _e1177 = local_4.member_1[0u];
let _e1183 = f32(bitcast<i32>(((_e1144 >> bitcast<u32>((_e1177 & 31u))) & 65535u)));
let _e1184 = local_4.member_1[1u];
let _e1190 = f32(bitcast<i32>(((_e1144 >> bitcast<u32>((_e1184 & 31u))) & 65535u)));
let _e1191 = local_4.member_1[4u];
let _e1197 = f32(bitcast<i32>(((_e1176 >> bitcast<u32>((_e1191 & 31u))) & 65535u)));
let _e1198 = local_4.member_1[5u];
let _e1205 = local_5[0u];
let _e1209 = local_5[0u];
let _e1212 = (_e1190 + ((_e1197 - _e1190) * _e1209));
let _e1213 = local_5[0u];
let _e1220 = local_4.member[1u];
let _e1221 = ((_e769 + _e764) + _e1220);
let _e1223 = (_e1221 >> bitcast<u32>(1i));
let _e1226 = bitcast<u32>(((_e1221 & 1i) * 16i));
let _e1228 = select(_e794, _e1223, (_e1223 < _e794));
let _e1233 = global_2.member[bitcast<u32>(select(0i, _e1228, (_e1228 > 0i)))];
let _e1237 = (_e1223 + 1i);
let _e1239 = select(_e794, _e1237, (_e1237 < _e794));
let _e1244 = global_2.member[bitcast<u32>(select(0i, _e1239, (_e1239 > 0i)))];
let _e1251 = ((_e1233 >> bitcast<u32>((_e1226 & 31u))) | ((_e1244 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1226) & 31u))));
let _e1254 = local_4.member_1[2u];
let _e1260 = f32(bitcast<i32>(((_e1251 >> bitcast<u32>((_e1254 & 31u))) & 65535u)));
let _e1263 = local_4.member_1[3u];
let _e1270 = local_5[0u];
let _e1273 = (_e1260 + ((f32(bitcast<i32>(((_e1251 >> bitcast<u32>((_e1263 & 31u))) & 65535u))) - _e1260) * _e1270));
let _e1275 = local_4.member[1u];
let _e1276 = ((_e769 + _e767) + _e1275);
let _e1278 = (_e1276 >> bitcast<u32>(1i));
let _e1281 = bitcast<u32>(((_e1276 & 1i) * 16i));
let _e1283 = select(_e794, _e1278, (_e1278 < _e794));
let _e1288 = global_2.member[bitcast<u32>(select(0i, _e1283, (_e1283 > 0i)))];
let _e1292 = (_e1278 + 1i);
let _e1294 = select(_e794, _e1292, (_e1292 < _e794));
let _e1299 = global_2.member[bitcast<u32>(select(0i, _e1294, (_e1294 > 0i)))];
let _e1306 = ((_e1288 >> bitcast<u32>((_e1281 & 31u))) | ((_e1299 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1281) & 31u))));
let _e1307 = local_4.member_1[2u];
let _e1313 = f32(bitcast<i32>(((_e1306 >> bitcast<u32>((_e1307 & 31u))) & 65535u)));
let _e1314 = local_4.member_1[3u];
let _e1321 = local_5[0u];
let _e1326 = local_4.member[1u];
let _e1327 = ((_e770 + _e764) + _e1326);
let _e1329 = (_e1327 >> bitcast<u32>(1i));
let _e1332 = bitcast<u32>(((_e1327 & 1i) * 16i));
let _e1334 = select(_e794, _e1329, (_e1329 < _e794));
let _e1339 = global_2.member[bitcast<u32>(select(0i, _e1334, (_e1334 > 0i)))];
let _e1343 = (_e1329 + 1i);
let _e1345 = select(_e794, _e1343, (_e1343 < _e794));
let _e1350 = global_2.member[bitcast<u32>(select(0i, _e1345, (_e1345 > 0i)))];
let _e1357 = ((_e1339 >> bitcast<u32>((_e1332 & 31u))) | ((_e1350 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1332) & 31u))));
let _e1358 = local_4.member_1[2u];
let _e1364 = f32(bitcast<i32>(((_e1357 >> bitcast<u32>((_e1358 & 31u))) & 65535u)));
let _e1365 = local_4.member_1[3u];
let _e1372 = local_5[0u];
let _e1375 = (_e1364 + ((f32(bitcast<i32>(((_e1357 >> bitcast<u32>((_e1365 & 31u))) & 65535u))) - _e1364) * _e1372));
let _e1377 = local_4.member[1u];
let _e1378 = ((_e770 + _e767) + _e1377);
let _e1380 = (_e1378 >> bitcast<u32>(1i));
let _e1383 = bitcast<u32>(((_e1378 & 1i) * 16i));
let _e1385 = select(_e794, _e1380, (_e1380 < _e794));
let _e1390 = global_2.member[bitcast<u32>(select(0i, _e1385, (_e1385 > 0i)))];
let _e1394 = (_e1380 + 1i);
let _e1396 = select(_e794, _e1394, (_e1394 < _e794));
let _e1401 = global_2.member[bitcast<u32>(select(0i, _e1396, (_e1396 > 0i)))];
let _e1408 = ((_e1390 >> bitcast<u32>((_e1383 & 31u))) | ((_e1401 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1383) & 31u))));
let _e1409 = local_4.member_1[2u];
let _e1415 = f32(bitcast<i32>(((_e1408 >> bitcast<u32>((_e1409 & 31u))) & 65535u)));
let _e1416 = local_4.member_1[3u];
let _e1423 = local_5[0u];
let _e1428 = local_4.member[1u];
let _e1429 = ((_e768 + _e765) + _e1428);
let _e1431 = (_e1429 >> bitcast<u32>(1i));
let _e1434 = bitcast<u32>(((_e1429 & 1i) * 16i));
let _e1436 = select(_e794, _e1431, (_e1431 < _e794));
let _e1441 = global_2.member[bitcast<u32>(select(0i, _e1436, (_e1436 > 0i)))];
let _e1445 = (_e1431 + 1i);
let _e1447 = select(_e794, _e1445, (_e1445 < _e794));
let _e1452 = global_2.member[bitcast<u32>(select(0i, _e1447, (_e1447 > 0i)))];
let _e1459 = ((_e1441 >> bitcast<u32>((_e1434 & 31u))) | ((_e1452 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1434) & 31u))));
let _e1460 = local_4.member_1[2u];
let _e1466 = f32(bitcast<i32>(((_e1459 >> bitcast<u32>((_e1460 & 31u))) & 65535u)));
let _e1467 = local_4.member_1[3u];
let _e1474 = local_5[0u];
let _e1477 = (_e1466 + ((f32(bitcast<i32>(((_e1459 >> bitcast<u32>((_e1467 & 31u))) & 65535u))) - _e1466) * _e1474));
let _e1479 = local_4.member[1u];
let _e1480 = ((_e771 + _e765) + _e1479);
let _e1482 = (_e1480 >> bitcast<u32>(1i));
let _e1485 = bitcast<u32>(((_e1480 & 1i) * 16i));
let _e1487 = select(_e794, _e1482, (_e1482 < _e794));
let _e1492 = global_2.member[bitcast<u32>(select(0i, _e1487, (_e1487 > 0i)))];
let _e1496 = (_e1482 + 1i);
let _e1498 = select(_e794, _e1496, (_e1496 < _e794));
let _e1503 = global_2.member[bitcast<u32>(select(0i, _e1498, (_e1498 > 0i)))];
let _e1510 = ((_e1492 >> bitcast<u32>((_e1485 & 31u))) | ((_e1503 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1485) & 31u))));
let _e1511 = local_4.member_1[2u];
let _e1517 = f32(bitcast<i32>(((_e1510 >> bitcast<u32>((_e1511 & 31u))) & 65535u)));
let _e1518 = local_4.member_1[3u];
let _e1525 = local_5[0u];
let _e1528 = (_e1517 + ((f32(bitcast<i32>(((_e1510 >> bitcast<u32>((_e1518 & 31u))) & 65535u))) - _e1517) * _e1525));
let _e1530 = local_4.member[1u];
let _e1531 = ((_e768 + _e766) + _e1530);
let _e1533 = (_e1531 >> bitcast<u32>(1i));
let _e1536 = bitcast<u32>(((_e1531 & 1i) * 16i));
let _e1538 = select(_e794, _e1533, (_e1533 < _e794));
let _e1543 = global_2.member[bitcast<u32>(select(0i, _e1538, (_e1538 > 0i)))];
let _e1547 = (_e1533 + 1i);
let _e1549 = select(_e794, _e1547, (_e1547 < _e794));
let _e1554 = global_2.member[bitcast<u32>(select(0i, _e1549, (_e1549 > 0i)))];
let _e1561 = ((_e1543 >> bitcast<u32>((_e1536 & 31u))) | ((_e1554 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1536) & 31u))));
let _e1562 = local_4.member_1[2u];
let _e1568 = f32(bitcast<i32>(((_e1561 >> bitcast<u32>((_e1562 & 31u))) & 65535u)));
let _e1569 = local_4.member_1[3u];
let _e1576 = local_5[0u];
let _e1581 = local_4.member[1u];
let _e1582 = ((_e771 + _e766) + _e1581);
let _e1584 = (_e1582 >> bitcast<u32>(1i));
let _e1587 = bitcast<u32>(((_e1582 & 1i) * 16i));
let _e1589 = select(_e794, _e1584, (_e1584 < _e794));
let _e1594 = global_2.member[bitcast<u32>(select(0i, _e1589, (_e1589 > 0i)))];
let _e1598 = (_e1584 + 1i);
let _e1600 = select(_e794, _e1598, (_e1598 < _e794));
let _e1605 = global_2.member[bitcast<u32>(select(0i, _e1600, (_e1600 > 0i)))];
let _e1612 = ((_e1594 >> bitcast<u32>((_e1587 & 31u))) | ((_e1605 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1587) & 31u))));
let _e1613 = local_4.member_1[2u];
let _e1619 = f32(bitcast<i32>(((_e1612 >> bitcast<u32>((_e1613 & 31u))) & 65535u)));
let _e1620 = local_4.member_1[3u];
let _e1627 = local_5[0u];
let _e1632 = local_5[1u];
let _e1635 = (_e897 + ((_e1002 - _e897) * _e1632));
let _e1636 = local_5[1u];
let _e1639 = (_e1107 + ((_e1212 - _e1107) * _e1636));
let _e1640 = local_5[1u];
let _e1643 = (_e893 + (((_e973 + ((_e980 - _e973) * _e995)) - _e893) * _e1640));
let _e1644 = local_5[1u];
let _e1649 = local_5[2u];
let _e1653 = local_5[1u];
let _e1656 = (_e901 + (((_e987 + ((f32(bitcast<i32>(((_e966 >> bitcast<u32>((_e988 & 31u))) & 65535u))) - _e987) * _e1003)) - _e901) * _e1653));
let _e1657 = local_5[1u];
let _e1661 = local_5[2u];
let _e1665 = local_5[1u];
let _e1668 = (_e1273 + ((_e897 - _e1273) * _e1665));
let _e1669 = local_5[1u];
let _e1673 = local_5[2u];
let _e1677 = local_5[1u];
let _e1680 = (_e1002 + (((_e1313 + ((f32(bitcast<i32>(((_e1306 >> bitcast<u32>((_e1314 & 31u))) & 65535u))) - _e1313) * _e1321)) - _e1002) * _e1677));
let _e1681 = local_5[1u];
let _e1685 = local_5[2u];
let _e1689 = local_5[1u];
let _e1692 = (_e1477 + (((_e1568 + ((f32(bitcast<i32>(((_e1561 >> bitcast<u32>((_e1569 & 31u))) & 65535u))) - _e1568) * _e1576)) - _e1477) * _e1689));
let _e1693 = local_5[2u];
let _e1697 = local_5[1u];
let _e1701 = local_5[2u];
let _e1705 = local_5[2u];
let _e1712 = global_1.member.member_6.member_5;
let _e1717 = global_1.member.member_6.member_6;
let _e1718 = (((_e1635 + ((_e1639 - _e1635) * _e1705)) * _e1712) + _e1717);
let _e1720 = select(0f, _e1718, (_e1718 > 0f));
let _e1722 = select(1f, _e1720, (_e1720 < 1f));
let _e1724 = (((_e1643 + (((_e1103 + (((_e1183 + ((_e1190 - _e1183) * _e1205)) - _e1103) * _e1644)) - _e1643) * _e1649)) * _e1712) + _e1717);
let _e1726 = select(0f, _e1724, (_e1724 > 0f));
let _e1728 = select(1f, _e1726, (_e1726 < 1f));
let _e1730 = (((_e1656 + (((_e1111 + (((_e1197 + ((f32(bitcast<i32>(((_e1176 >> bitcast<u32>((_e1198 & 31u))) & 65535u))) - _e1197) * _e1213)) - _e1111) * _e1657)) - _e1656) * _e1661)) * _e1712) + _e1717);
let _e1732 = select(0f, _e1730, (_e1730 > 0f));
let _e1734 = select(1f, _e1732, (_e1732 < 1f));
let _e1736 = (((_e1668 + (((_e1375 + ((_e1107 - _e1375) * _e1669)) - _e1668) * _e1673)) * _e1712) + _e1717);
let _e1738 = select(0f, _e1736, (_e1736 > 0f));
let _e1740 = select(1f, _e1738, (_e1738 < 1f));
let _e1742 = (((_e1680 + (((_e1212 + (((_e1415 + ((f32(bitcast<i32>(((_e1408 >> bitcast<u32>((_e1416 & 31u))) & 65535u))) - _e1415) * _e1423)) - _e1212) * _e1681)) - _e1680) * _e1685)) * _e1712) + _e1717);
let _e1744 = select(0f, _e1742, (_e1742 > 0f));
let _e1746 = select(1f, _e1744, (_e1744 < 1f));
let _e1748 = (((_e1692 + ((_e1635 - _e1692) * _e1693)) * _e1712) + _e1717);
let _e1750 = select(0f, _e1748, (_e1748 > 0f));
let _e1752 = select(1f, _e1750, (_e1750 < 1f));
let _e1754 = (((_e1639 + (((_e1528 + (((_e1619 + ((f32(bitcast<i32>(((_e1612 >> bitcast<u32>((_e1620 & 31u))) & 65535u))) - _e1619) * _e1627)) - _e1528) * _e1697)) - _e1639) * _e1701)) * _e1712) + _e1717);
let _e1756 = select(0f, _e1754, (_e1754 > 0f));
let _e1758 = select(1f, _e1756, (_e1756 < 1f));
let _e1759 = (_e1722 * 1024f);
let _e1760 = (1024f - 1f);
let _e1762 = select(0f, _e1759, (_e1759 > 0f));
let _e1764 = select(_e1760, _e1762, (_e1762 < _e1760));
let _e1771 = select(0i, select(select(i32(_e1764), i32(-2147483648), (_e1764 < -2147483600f)), 2147483647i, (_e1764 > 2147483500f)), (_e1764 == _e1764));
let _e1775 = (_e1771 - select(0i, 1i, (_e1764 < f32(_e1771))));
let _e1776 = (262147i + _e1775);
let _e1778 = (bitcast<i32>(_e93) - 1i);
let _e1780 = select(_e1778, _e1776, (_e1776 < _e1778));
let _e1786 = global_4.member[bitcast<u32>(select(0i, _e1780, (_e1780 > 0i)))];
let _e1796 = select(_e1778, 262146i, (262146i < _e1778));
let _e1802 = global_4.member[bitcast<u32>(select(0i, _e1796, (_e1796 > 0i)))];
let _e1803 = bitcast<f32>(_e1802);
let _e1804 = (f32((bitcast<i32>((_e1786 & 4095u)) - 2048i)) * _e1803);
let _e1806 = select(_e1778, 262144i, (262144i < _e1778));
let _e1812 = global_4.member[bitcast<u32>(select(0i, _e1806, (_e1806 > 0i)))];
let _e1813 = bitcast<f32>(_e1812);
let _e1815 = select(_e1778, 262145i, (262145i < _e1778));
let _e1821 = global_4.member[bitcast<u32>(select(0i, _e1815, (_e1815 > 0i)))];
let _e1822 = bitcast<f32>(_e1821);
let _e1828 = ((_e1813 + (f32(bitcast<i32>((_e1786 >> bitcast<u32>(12u)))) * _e1822)) + (_e1804 * (_e1759 - f32(_e1775))));
let _e1829 = (_e1804 * 1024f);
if _e623 {
let _e1836 = ((0.5f * (_e1734 - _e1728)) * _e1829);
let _e1837 = ((0.5f * (_e1746 - _e1740)) * _e1829);
let _e1838 = ((0.5f * (_e1758 - _e1752)) * _e1829);
phi_4104_ = type_29(_e1828, vec3<f32>(_e1836, _e1837, _e1838), vec3<f32>((_e1836 * _e1828), (_e1837 * _e1828), (_e1838 * _e1828)));
} else {
let _e1845 = (_e1728 * 1024f);
let _e1847 = select(0f, _e1845, (_e1845 > 0f));
let _e1849 = select(_e1760, _e1847, (_e1847 < _e1760));
let _e1856 = select(0i, select(select(i32(_e1849), i32(-2147483648), (_e1849 < -2147483600f)), 2147483647i, (_e1849 > 2147483500f)), (_e1849 == _e1849));
let _e1860 = (_e1856 - select(0i, 1i, (_e1849 < f32(_e1856))));
let _e1861 = (262147i + _e1860);
let _e1863 = select(_e1778, _e1861, (_e1861 < _e1778));
let _e1869 = global_4.member[bitcast<u32>(select(0i, _e1863, (_e1863 > 0i)))];
let _e1884 = ((_e1813 + (f32(bitcast<i32>((_e1869 >> bitcast<u32>(12u)))) * _e1822)) + ((f32((bitcast<i32>((_e1869 & 4095u)) - 2048i)) * _e1803) * (_e1845 - f32(_e1860))));
let _e1885 = (_e1734 * 1024f);
let _e1887 = select(0f, _e1885, (_e1885 > 0f));
let _e1889 = select(_e1760, _e1887, (_e1887 < _e1760));
let _e1896 = select(0i, select(select(i32(_e1889), i32(-2147483648), (_e1889 < -2147483600f)), 2147483647i, (_e1889 > 2147483500f)), (_e1889 == _e1889));
let _e1900 = (_e1896 - select(0i, 1i, (_e1889 < f32(_e1896))));
let _e1901 = (262147i + _e1900);
let _e1903 = select(_e1778, _e1901, (_e1901 < _e1778));
let _e1909 = global_4.member[bitcast<u32>(select(0i, _e1903, (_e1903 > 0i)))];
let _e1924 = ((_e1813 + (f32(bitcast<i32>((_e1909 >> bitcast<u32>(12u)))) * _e1822)) + ((f32((bitcast<i32>((_e1909 & 4095u)) - 2048i)) * _e1803) * (_e1885 - f32(_e1900))));
let _e1925 = (_e1740 * 1024f);
let _e1927 = select(0f, _e1925, (_e1925 > 0f));
let _e1929 = select(_e1760, _e1927, (_e1927 < _e1760));
let _e1936 = select(0i, select(select(i32(_e1929), i32(-2147483648), (_e1929 < -2147483600f)), 2147483647i, (_e1929 > 2147483500f)), (_e1929 == _e1929));
let _e1940 = (_e1936 - select(0i, 1i, (_e1929 < f32(_e1936))));
let _e1941 = (262147i + _e1940);
let _e1943 = select(_e1778, _e1941, (_e1941 < _e1778));
let _e1949 = global_4.member[bitcast<u32>(select(0i, _e1943, (_e1943 > 0i)))];
let _e1964 = ((_e1813 + (f32(bitcast<i32>((_e1949 >> bitcast<u32>(12u)))) * _e1822)) + ((f32((bitcast<i32>((_e1949 & 4095u)) - 2048i)) * _e1803) * (_e1925 - f32(_e1940))));
let _e1965 = (_e1746 * 1024f);
let _e1967 = select(0f, _e1965, (_e1965 > 0f));
let _e1969 = select(_e1760, _e1967, (_e1967 < _e1760));
let _e1976 = select(0i, select(select(i32(_e1969), i32(-2147483648), (_e1969 < -2147483600f)), 2147483647i, (_e1969 > 2147483500f)), (_e1969 == _e1969));
let _e1980 = (_e1976 - select(0i, 1i, (_e1969 < f32(_e1976))));
let _e1981 = (262147i + _e1980);
let _e1983 = select(_e1778, _e1981, (_e1981 < _e1778));
let _e1989 = global_4.member[bitcast<u32>(select(0i, _e1983, (_e1983 > 0i)))];
let _e2004 = ((_e1813 + (f32(bitcast<i32>((_e1989 >> bitcast<u32>(12u)))) * _e1822)) + ((f32((bitcast<i32>((_e1989 & 4095u)) - 2048i)) * _e1803) * (_e1965 - f32(_e1980))));
let _e2005 = (_e1752 * 1024f);
let _e2007 = select(0f, _e2005, (_e2005 > 0f));
let _e2009 = select(_e1760, _e2007, (_e2007 < _e1760));
let _e2016 = select(0i, select(select(i32(_e2009), i32(-2147483648), (_e2009 < -2147483600f)), 2147483647i, (_e2009 > 2147483500f)), (_e2009 == _e2009));
let _e2020 = (_e2016 - select(0i, 1i, (_e2009 < f32(_e2016))));
let _e2021 = (262147i + _e2020);
let _e2023 = select(_e1778, _e2021, (_e2021 < _e1778));
let _e2029 = global_4.member[bitcast<u32>(select(0i, _e2023, (_e2023 > 0i)))];
let _e2044 = ((_e1813 + (f32(bitcast<i32>((_e2029 >> bitcast<u32>(12u)))) * _e1822)) + ((f32((bitcast<i32>((_e2029 & 4095u)) - 2048i)) * _e1803) * (_e2005 - f32(_e2020))));
let _e2045 = (_e1758 * 1024f);
let _e2047 = select(0f, _e2045, (_e2045 > 0f));
let _e2049 = select(_e1760, _e2047, (_e2047 < _e1760));
let _e2056 = select(0i, select(select(i32(_e2049), i32(-2147483648), (_e2049 < -2147483600f)), 2147483647i, (_e2049 > 2147483500f)), (_e2049 == _e2049));
let _e2060 = (_e2056 - select(0i, 1i, (_e2049 < f32(_e2056))));
let _e2061 = (262147i + _e2060);
let _e2063 = select(_e1778, _e2061, (_e2061 < _e1778));
let _e2069 = global_4.member[bitcast<u32>(select(0i, _e2063, (_e2063 > 0i)))];
let _e2084 = ((_e1813 + (f32(bitcast<i32>((_e2069 >> bitcast<u32>(12u)))) * _e1822)) + ((f32((bitcast<i32>((_e2069 & 4095u)) - 2048i)) * _e1803) * (_e2045 - f32(_e2060))));
let _e2085 = (_e1924 - _e1884);
let _e2087 = (_e2004 - _e1964);
let _e2089 = (_e2084 - _e2044);
phi_4104_ = type_29(_e1828, vec3<f32>((0.5f * _e2085), (0.5f * _e2087), (0.5f * _e2089)), vec3<f32>((0.25f * (_e2085 * (_e1924 + _e1884))), (0.25f * (_e2087 * (_e2004 + _e1964))), (0.25f * (_e2089 * (_e2084 + _e2044)))));
}
let _e2104 = phi_4104_;
let _e2119 = select(0f, 1f, ((((((_e429 >= -0.5f) && (_e429 <= _e451)) && (_e435 >= -0.5f)) && (_e435 <= _e461)) && (_e441 >= -0.5f)) && (_e441 <= _e471)));
let _e2121 = (0.5f * (_e1734 - _e1728));
let _e2123 = (0.5f * (_e1746 - _e1740));
let _e2125 = (0.5f * (_e1758 - _e1752));
let _e2131 = global_1.member.member_6.member.member.member;
let _e2137 = global_1.member.member_6.member.member.member_1;
let _e2143 = global_1.member.member_6.member.member.member_2;
let _e2149 = global_1.member.member_6.member_1.member.member;
let _e2155 = global_1.member.member_6.member_1.member.member_1;
let _e2161 = global_1.member.member_6.member_1.member.member_2;
let _e2167 = global_1.member.member_6.member_2.member.member;
let _e2173 = global_1.member.member_6.member_2.member.member_1;
let _e2179 = global_1.member.member_6.member_2.member.member_2;
phi_4882_ = type_30(_e1722, vec3<f32>(((((_e2131 * _e2121) + (_e2149 * _e2123)) + (_e2167 * _e2125)) * _e2119), ((((_e2137 * _e2121) + (_e2155 * _e2123)) + (_e2173 * _e2125)) * _e2119), ((((_e2143 * _e2121) + (_e2161 * _e2123)) + (_e2179 * _e2125)) * _e2119)), _e2104.member, vec3<f32>(((((_e2131 * _e2104.member_2.x) + (_e2149 * _e2104.member_2.y)) + (_e2167 * _e2104.member_2.z)) * _e2119), ((((_e2137 * _e2104.member_2.x) + (_e2155 * _e2104.member_2.y)) + (_e2173 * _e2104.member_2.z)) * _e2119), ((((_e2143 * _e2104.member_2.x) + (_e2161 * _e2104.member_2.y)) + (_e2179 * _e2104.member_2.z)) * _e2119)), vec3<f32>(((((_e2131 * _e2104.member_1.x) + (_e2149 * _e2104.member_1.y)) + (_e2167 * _e2104.member_1.z)) * _e2119), ((((_e2137 * _e2104.member_1.x) + (_e2155 * _e2104.member_1.y)) + (_e2173 * _e2104.member_1.z)) * _e2119), ((((_e2143 * _e2104.member_1.x) + (_e2161 * _e2104.member_1.y)) + (_e2179 * _e2104.member_1.z)) * _e2119)));
} else {
let _e2245 = select(-1f, _e455, (_e455 > -1f));
let _e2247 = select(_e450, _e2245, (_e2245 < _e450));
let _e2254 = select(0i, select(select(i32(_e2247), i32(-2147483648), (_e2247 < -2147483600f)), 2147483647i, (_e2247 > 2147483500f)), (_e2247 == _e2247));
let _e2258 = (_e2254 - select(0i, 1i, (_e2247 < f32(_e2254))));
let _e2260 = select(-1f, _e465, (_e465 > -1f));
let _e2262 = select(_e460, _e2260, (_e2260 < _e460));
let _e2269 = select(0i, select(select(i32(_e2262), i32(-2147483648), (_e2262 < -2147483600f)), 2147483647i, (_e2262 > 2147483500f)), (_e2262 == _e2262));
let _e2273 = (_e2269 - select(0i, 1i, (_e2262 < f32(_e2269))));
let _e2275 = select(-1f, _e475, (_e475 > -1f));
let _e2277 = select(_e470, _e2275, (_e2275 < _e470));
let _e2284 = select(0i, select(select(i32(_e2277), i32(-2147483648), (_e2277 < -2147483600f)), 2147483647i, (_e2277 > 2147483500f)), (_e2277 == _e2277));
let _e2288 = (_e2284 - select(0i, 1i, (_e2277 < f32(_e2284))));
let _e2292 = global_1.member.member_6.member_7;
let _e2296 = global_1.member.member_6.member_8;
let _e2304 = (select(0i, select(select(i32(_e460), i32(-2147483648), (_e460 < -2147483600f)), 2147483647i, (_e460 > 2147483500f)), (_e460 == _e460)) - 1i);
let _e2307 = (_e2273 + 1i);
let _e2317 = (select(0i, select(select(i32(_e470), i32(-2147483648), (_e470 < -2147483600f)), 2147483647i, (_e470 > 2147483500f)), (_e470 == _e470)) - 1i);
let _e2320 = (_e2288 + 1i);
let _e2329 = select(0i, select(select(i32(_e450), i32(-2147483648), (_e450 < -2147483600f)), 2147483647i, (_e450 > 2147483500f)), (_e450 == _e450));
let _e2330 = (_e2329 - 1i);
let _e2331 = (_e2258 - 1i);
let _e2333 = select(0i, _e2331, (_e2331 > 0i));
let _e2335 = select(0i, _e2258, (_e2258 > 0i));
let _e2336 = (_e2258 + 1i);
let _e2338 = select(_e2330, _e2336, (_e2336 < _e2330));
let _e2339 = (_e2258 + 2i);
let _e2342 = (_e2329 - 2i);
let _e2344 = select(0i, _e2342, (_e2342 > 0i));
let _e2346 = select(_e2344, _e2333, (_e2333 < _e2344));
let _e2348 = select(_e2344, _e2335, (_e2335 < _e2344));
let _e2350 = select(_e2344, _e2338, (_e2338 < _e2344));
let _e2369 = (select(0i, _e2273, (_e2273 > 0i)) * _e2292);
let _e2370 = (select(_e2304, _e2307, (_e2307 < _e2304)) * _e2292);
let _e2371 = (select(0i, _e2288, (_e2288 > 0i)) * _e2296);
let _e2372 = (select(_e2317, _e2320, (_e2320 < _e2317)) * _e2296);
local_2 = type_28(array<i32, 4>(_e2346, _e2348, _e2350, 0i), array<u32, 6>(bitcast<u32>(((_e2333 - _e2346) * 16i)), bitcast<u32>(((_e2335 - _e2346) * 16i)), bitcast<u32>(((_e2335 - _e2348) * 16i)), bitcast<u32>(((_e2338 - _e2348) * 16i)), bitcast<u32>(((_e2338 - _e2350) * 16i)), bitcast<u32>(((select(_e2330, _e2339, (_e2339 < _e2330)) - _e2350) * 16i))));
local_3 = vec3<f32>((_e455 - f32(_e2258)), (_e465 - f32(_e2273)), (_e475 - f32(_e2288)));
let _e2387 = local_2.member[1u];
let _e2388 = ((_e2371 + _e2369) + _e2387);
let _e2390 = (_e2388 >> bitcast<u32>(1i));
let _e2393 = bitcast<u32>(((_e2388 & 1i) * 16i));
let _e2395 = (bitcast<i32>(_e89) - 1i);
let _e2397 = select(_e2395, _e2390, (_e2390 < _e2395));
let _e2402 = global_2.member[bitcast<u32>(select(0i, _e2397, (_e2397 > 0i)))];
let _e2406 = (_e2390 + 1i);
let _e2408 = select(_e2395, _e2406, (_e2406 < _e2395));
let _e2413 = global_2.member[bitcast<u32>(select(0i, _e2408, (_e2408 > 0i)))];
let _e2420 = ((_e2402 >> bitcast<u32>((_e2393 & 31u))) | ((_e2413 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2393) & 31u))));
let _e2423 = local_2.member_1[2u];
let _e2429 = f32(bitcast<i32>(((_e2420 >> bitcast<u32>((_e2423 & 31u))) & 65535u)));
let _e2432 = local_2.member_1[3u];
let _e2439 = local_3[0u];
let _e2442 = (_e2429 + ((f32(bitcast<i32>(((_e2420 >> bitcast<u32>((_e2432 & 31u))) & 65535u))) - _e2429) * _e2439));
let _e2444 = local_2.member[1u];
let _e2445 = ((_e2371 + _e2370) + _e2444);
let _e2447 = (_e2445 >> bitcast<u32>(1i));
let _e2450 = bitcast<u32>(((_e2445 & 1i) * 16i));
let _e2452 = select(_e2395, _e2447, (_e2447 < _e2395));
let _e2457 = global_2.member[bitcast<u32>(select(0i, _e2452, (_e2452 > 0i)))];
let _e2461 = (_e2447 + 1i);
let _e2463 = select(_e2395, _e2461, (_e2461 < _e2395));
let _e2468 = global_2.member[bitcast<u32>(select(0i, _e2463, (_e2463 > 0i)))];
let _e2475 = ((_e2457 >> bitcast<u32>((_e2450 & 31u))) | ((_e2468 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2450) & 31u))));
let _e2476 = local_2.member_1[2u];
let _e2482 = f32(bitcast<i32>(((_e2475 >> bitcast<u32>((_e2476 & 31u))) & 65535u)));
let _e2483 = local_2.member_1[3u];
let _e2490 = local_3[0u];
let _e2495 = local_3[1u];
let _e2498 = (_e2442 + (((_e2482 + ((f32(bitcast<i32>(((_e2475 >> bitcast<u32>((_e2483 & 31u))) & 65535u))) - _e2482) * _e2490)) - _e2442) * _e2495));
let _e2500 = local_2.member[1u];
let _e2501 = ((_e2372 + _e2369) + _e2500);
let _e2503 = (_e2501 >> bitcast<u32>(1i));
let _e2506 = bitcast<u32>(((_e2501 & 1i) * 16i));
let _e2508 = select(_e2395, _e2503, (_e2503 < _e2395));
let _e2513 = global_2.member[bitcast<u32>(select(0i, _e2508, (_e2508 > 0i)))];
let _e2517 = (_e2503 + 1i);
let _e2519 = select(_e2395, _e2517, (_e2517 < _e2395));
let _e2524 = global_2.member[bitcast<u32>(select(0i, _e2519, (_e2519 > 0i)))];
let _e2531 = ((_e2513 >> bitcast<u32>((_e2506 & 31u))) | ((_e2524 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2506) & 31u))));
let _e2532 = local_2.member_1[2u];
let _e2538 = f32(bitcast<i32>(((_e2531 >> bitcast<u32>((_e2532 & 31u))) & 65535u)));
let _e2539 = local_2.member_1[3u];
let _e2546 = local_3[0u];
let _e2549 = (_e2538 + ((f32(bitcast<i32>(((_e2531 >> bitcast<u32>((_e2539 & 31u))) & 65535u))) - _e2538) * _e2546));
let _e2551 = local_2.member[1u];
let _e2552 = ((_e2372 + _e2370) + _e2551);
let _e2554 = (_e2552 >> bitcast<u32>(1i));
let _e2557 = bitcast<u32>(((_e2552 & 1i) * 16i));
let _e2559 = select(_e2395, _e2554, (_e2554 < _e2395));
let _e2564 = global_2.member[bitcast<u32>(select(0i, _e2559, (_e2559 > 0i)))];
let _e2568 = (_e2554 + 1i);
let _e2570 = select(_e2395, _e2568, (_e2568 < _e2395));
let _e2575 = global_2.member[bitcast<u32>(select(0i, _e2570, (_e2570 > 0i)))];
let _e2582 = ((_e2564 >> bitcast<u32>((_e2557 & 31u))) | ((_e2575 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2557) & 31u))));
let _e2583 = local_2.member_1[2u];
let _e2589 = f32(bitcast<i32>(((_e2582 >> bitcast<u32>((_e2583 & 31u))) & 65535u)));
let _e2590 = local_2.member_1[3u];
let _e2597 = local_3[0u];
let _e2601 = local_3[1u];
let _e2606 = local_3[2u];
let _e2613 = global_1.member.member_6.member_5;
let _e2618 = global_1.member.member_6.member_6;
let _e2619 = (((_e2498 + (((_e2549 + (((_e2589 + ((f32(bitcast<i32>(((_e2582 >> bitcast<u32>((_e2590 & 31u))) & 65535u))) - _e2589) * _e2597)) - _e2549) * _e2601)) - _e2498) * _e2606)) * _e2613) + _e2618);
let _e2621 = select(0f, _e2619, (_e2619 > 0f));
phi_4882_ = type_30(select(1f, _e2621, (_e2621 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2626 = phi_4882_;
let _e2628 = select(-0.5f, _e393, (_e393 > -0.5f));
let _e2630 = select(_e451, _e2628, (_e2628 < _e451));
let _e2632 = select(-0.5f, _e408, (_e408 > -0.5f));
let _e2634 = select(_e461, _e2632, (_e2632 < _e461));
let _e2636 = select(-0.5f, _e423, (_e423 > -0.5f));
let _e2638 = select(_e471, _e2636, (_e2636 < _e471));
let _e2640 = select(-1f, _e2630, (_e2630 > -1f));
let _e2642 = select(_e450, _e2640, (_e2640 < _e450));
let _e2649 = select(0i, select(select(i32(_e2642), i32(-2147483648), (_e2642 < -2147483600f)), 2147483647i, (_e2642 > 2147483500f)), (_e2642 == _e2642));
let _e2653 = (_e2649 - select(0i, 1i, (_e2642 < f32(_e2649))));
let _e2655 = select(-1f, _e2634, (_e2634 > -1f));
let _e2657 = select(_e460, _e2655, (_e2655 < _e460));
let _e2664 = select(0i, select(select(i32(_e2657), i32(-2147483648), (_e2657 < -2147483600f)), 2147483647i, (_e2657 > 2147483500f)), (_e2657 == _e2657));
let _e2668 = (_e2664 - select(0i, 1i, (_e2657 < f32(_e2664))));
let _e2670 = select(-1f, _e2638, (_e2638 > -1f));
let _e2672 = select(_e470, _e2670, (_e2670 < _e470));
let _e2679 = select(0i, select(select(i32(_e2672), i32(-2147483648), (_e2672 < -2147483600f)), 2147483647i, (_e2672 > 2147483500f)), (_e2672 == _e2672));
let _e2683 = (_e2679 - select(0i, 1i, (_e2672 < f32(_e2679))));
let _e2687 = global_1.member.member_6.member_7;
let _e2691 = global_1.member.member_6.member_8;
let _e2699 = (select(0i, select(select(i32(_e460), i32(-2147483648), (_e460 < -2147483600f)), 2147483647i, (_e460 > 2147483500f)), (_e460 == _e460)) - 1i);
let _e2702 = (_e2668 + 1i);
let _e2712 = (select(0i, select(select(i32(_e470), i32(-2147483648), (_e470 < -2147483600f)), 2147483647i, (_e470 > 2147483500f)), (_e470 == _e470)) - 1i);
let _e2715 = (_e2683 + 1i);
let _e2724 = select(0i, select(select(i32(_e450), i32(-2147483648), (_e450 < -2147483600f)), 2147483647i, (_e450 > 2147483500f)), (_e450 == _e450));
let _e2725 = (_e2724 - 1i);
let _e2726 = (_e2653 - 1i);
let _e2728 = select(0i, _e2726, (_e2726 > 0i));
let _e2730 = select(0i, _e2653, (_e2653 > 0i));
let _e2731 = (_e2653 + 1i);
let _e2733 = select(_e2725, _e2731, (_e2731 < _e2725));
let _e2734 = (_e2653 + 2i);
let _e2737 = (_e2724 - 2i);
let _e2739 = select(0i, _e2737, (_e2737 > 0i));
let _e2741 = select(_e2739, _e2728, (_e2728 < _e2739));
let _e2743 = select(_e2739, _e2730, (_e2730 < _e2739));
let _e2745 = select(_e2739, _e2733, (_e2733 < _e2739));
let _e2764 = (select(0i, _e2668, (_e2668 > 0i)) * _e2687);
let _e2765 = (select(_e2699, _e2702, (_e2702 < _e2699)) * _e2687);
let _e2766 = (select(0i, _e2683, (_e2683 > 0i)) * _e2691);
let _e2767 = (select(_e2712, _e2715, (_e2715 < _e2712)) * _e2691);
local = type_28(array<i32, 4>(_e2741, _e2743, _e2745, 0i), array<u32, 6>(bitcast<u32>(((_e2728 - _e2741) * 16i)), bitcast<u32>(((_e2730 - _e2741) * 16i)), bitcast<u32>(((_e2730 - _e2743) * 16i)), bitcast<u32>(((_e2733 - _e2743) * 16i)), bitcast<u32>(((_e2733 - _e2745) * 16i)), bitcast<u32>(((select(_e2725, _e2734, (_e2734 < _e2725)) - _e2745) * 16i))));
local_1 = vec3<f32>((_e2630 - f32(_e2653)), (_e2634 - f32(_e2668)), (_e2638 - f32(_e2683)));
let _e2782 = local.member[1u];
let _e2783 = ((_e2766 + _e2764) + _e2782);
let _e2785 = (_e2783 >> bitcast<u32>(1i));
let _e2788 = bitcast<u32>(((_e2783 & 1i) * 16i));
let _e2790 = (bitcast<i32>(_e89) - 1i);
let _e2792 = select(_e2790, _e2785, (_e2785 < _e2790));
let _e2797 = global_2.member[bitcast<u32>(select(0i, _e2792, (_e2792 > 0i)))];
let _e2801 = (_e2785 + 1i);
let _e2803 = select(_e2790, _e2801, (_e2801 < _e2790));
let _e2808 = global_2.member[bitcast<u32>(select(0i, _e2803, (_e2803 > 0i)))];
let _e2815 = ((_e2797 >> bitcast<u32>((_e2788 & 31u))) | ((_e2808 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2788) & 31u))));
let _e2818 = local.member_1[2u];
let _e2824 = f32(bitcast<i32>(((_e2815 >> bitcast<u32>((_e2818 & 31u))) & 65535u)));
let _e2827 = local.member_1[3u];
let _e2834 = local_1[0u];
let _e2837 = (_e2824 + ((f32(bitcast<i32>(((_e2815 >> bitcast<u32>((_e2827 & 31u))) & 65535u))) - _e2824) * _e2834));
let _e2839 = local.member[1u];
let _e2840 = ((_e2766 + _e2765) + _e2839);
let _e2842 = (_e2840 >> bitcast<u32>(1i));
let _e2845 = bitcast<u32>(((_e2840 & 1i) * 16i));
let _e2847 = select(_e2790, _e2842, (_e2842 < _e2790));
let _e2852 = global_2.member[bitcast<u32>(select(0i, _e2847, (_e2847 > 0i)))];
let _e2856 = (_e2842 + 1i);
let _e2858 = select(_e2790, _e2856, (_e2856 < _e2790));
let _e2863 = global_2.member[bitcast<u32>(select(0i, _e2858, (_e2858 > 0i)))];
let _e2870 = ((_e2852 >> bitcast<u32>((_e2845 & 31u))) | ((_e2863 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2845) & 31u))));
let _e2871 = local.member_1[2u];
let _e2877 = f32(bitcast<i32>(((_e2870 >> bitcast<u32>((_e2871 & 31u))) & 65535u)));
let _e2878 = local.member_1[3u];
let _e2885 = local_1[0u];
let _e2890 = local_1[1u];
let _e2893 = (_e2837 + (((_e2877 + ((f32(bitcast<i32>(((_e2870 >> bitcast<u32>((_e2878 & 31u))) & 65535u))) - _e2877) * _e2885)) - _e2837) * _e2890));
let _e2895 = local.member[1u];
let _e2896 = ((_e2767 + _e2764) + _e2895);
let _e2898 = (_e2896 >> bitcast<u32>(1i));
let _e2901 = bitcast<u32>(((_e2896 & 1i) * 16i));
let _e2903 = select(_e2790, _e2898, (_e2898 < _e2790));
let _e2908 = global_2.member[bitcast<u32>(select(0i, _e2903, (_e2903 > 0i)))];
let _e2912 = (_e2898 + 1i);
let _e2914 = select(_e2790, _e2912, (_e2912 < _e2790));
let _e2919 = global_2.member[bitcast<u32>(select(0i, _e2914, (_e2914 > 0i)))];
let _e2926 = ((_e2908 >> bitcast<u32>((_e2901 & 31u))) | ((_e2919 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2901) & 31u))));
let _e2927 = local.member_1[2u];
let _e2933 = f32(bitcast<i32>(((_e2926 >> bitcast<u32>((_e2927 & 31u))) & 65535u)));
let _e2934 = local.member_1[3u];
let _e2941 = local_1[0u];
let _e2944 = (_e2933 + ((f32(bitcast<i32>(((_e2926 >> bitcast<u32>((_e2934 & 31u))) & 65535u))) - _e2933) * _e2941));
let _e2946 = local.member[1u];
let _e2947 = ((_e2767 + _e2765) + _e2946);
let _e2949 = (_e2947 >> bitcast<u32>(1i));
let _e2952 = bitcast<u32>(((_e2947 & 1i) * 16i));
let _e2954 = select(_e2790, _e2949, (_e2949 < _e2790));
let _e2959 = global_2.member[bitcast<u32>(select(0i, _e2954, (_e2954 > 0i)))];
let _e2963 = (_e2949 + 1i);
let _e2965 = select(_e2790, _e2963, (_e2963 < _e2790));
let _e2970 = global_2.member[bitcast<u32>(select(0i, _e2965, (_e2965 > 0i)))];
let _e2977 = ((_e2959 >> bitcast<u32>((_e2952 & 31u))) | ((_e2970 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2952) & 31u))));
let _e2978 = local.member_1[2u];
let _e2984 = f32(bitcast<i32>(((_e2977 >> bitcast<u32>((_e2978 & 31u))) & 65535u)));
let _e2985 = local.member_1[3u];
let _e2992 = local_1[0u];
let _e2996 = local_1[1u];
let _e3001 = local_1[2u];
let _e3008 = global_1.member.member_6.member_5;
let _e3013 = global_1.member.member_6.member_6;
let _e3014 = (((_e2893 + (((_e2944 + (((_e2984 + ((f32(bitcast<i32>(((_e2977 >> bitcast<u32>((_e2985 & 31u))) & 65535u))) - _e2984) * _e2992)) - _e2944) * _e2996)) - _e2893) * _e3001)) * _e3008) + _e3013);
let _e3016 = select(0f, _e3014, (_e3014 > 0f));
if ((_e609 & 16u) == 0u) {
phi_5883_ = type_5(1f, 1f, 1f);
} else {
let _e3024 = global_1.member.member_14.member;
let _e3035 = ((((_e3024.member.member * _e304) + (_e3024.member.member_1 * _e313)) + (_e3024.member.member_2 * _e286)) + _e3024.member_1);
let _e3041 = ((((_e3024.member.member * _e325) + (_e3024.member.member_1 * _e330)) + (_e3024.member.member_2 * _e319)) + _e3024.member_1);
let _e3043 = select(_e3041, _e3035, (_e3035 < _e3041));
let _e3045 = select(_e3041, _e3035, (_e3035 > _e3041));
let _e3047 = (_e3045 - _e3043);
let _e3050 = (-(_e3043) / select(1e-30f, _e3047, (_e3047 > 1e-30f)));
let _e3052 = select(0f, _e3050, (_e3050 > 0f));
let _e3058 = select(select(select(1f, _e3052, (_e3052 < 1f)), 1f, (_e3045 <= 0f)), 0f, (_e3043 > 0f));
let _e3063 = global_1.member.member_14.member_1;
let _e3064 = (_e3063 != 0u);
let _e3074 = global_1.member.member_15.member;
let _e3085 = ((((_e3074.member.member * _e304) + (_e3074.member.member_1 * _e313)) + (_e3074.member.member_2 * _e286)) + _e3074.member_1);
let _e3091 = ((((_e3074.member.member * _e325) + (_e3074.member.member_1 * _e330)) + (_e3074.member.member_2 * _e319)) + _e3074.member_1);
let _e3093 = select(_e3091, _e3085, (_e3085 < _e3091));
let _e3095 = select(_e3091, _e3085, (_e3085 > _e3091));
let _e3097 = (_e3095 - _e3093);
let _e3100 = (-(_e3093) / select(1e-30f, _e3097, (_e3097 > 1e-30f)));
let _e3102 = select(0f, _e3100, (_e3100 > 0f));
let _e3108 = select(select(select(1f, _e3102, (_e3102 < 1f)), 1f, (_e3095 <= 0f)), 0f, (_e3093 > 0f));
let _e3113 = global_1.member.member_15.member_1;
let _e3114 = (_e3113 != 0u);
let _e3124 = global_1.member.member_16.member;
let _e3135 = ((((_e3124.member.member * _e304) + (_e3124.member.member_1 * _e313)) + (_e3124.member.member_2 * _e286)) + _e3124.member_1);
let _e3141 = ((((_e3124.member.member * _e325) + (_e3124.member.member_1 * _e330)) + (_e3124.member.member_2 * _e319)) + _e3124.member_1);
let _e3143 = select(_e3141, _e3135, (_e3135 < _e3141));
let _e3145 = select(_e3141, _e3135, (_e3135 > _e3141));
let _e3147 = (_e3145 - _e3143);
let _e3150 = (-(_e3143) / select(1e-30f, _e3147, (_e3147 > 1e-30f)));
let _e3152 = select(0f, _e3150, (_e3150 > 0f));
let _e3158 = select(select(select(1f, _e3152, (_e3152 < 1f)), 1f, (_e3145 <= 0f)), 0f, (_e3143 > 0f));
let _e3163 = global_1.member.member_16.member_1;
let _e3164 = (_e3163 != 0u);
let _e3174 = global_1.member.member_17.member;
let _e3185 = ((((_e3174.member.member * _e304) + (_e3174.member.member_1 * _e313)) + (_e3174.member.member_2 * _e286)) + _e3174.member_1);
let _e3191 = ((((_e3174.member.member * _e325) + (_e3174.member.member_1 * _e330)) + (_e3174.member.member_2 * _e319)) + _e3174.member_1);
let _e3193 = select(_e3191, _e3185, (_e3185 < _e3191));
let _e3195 = select(_e3191, _e3185, (_e3185 > _e3191));
let _e3197 = (_e3195 - _e3193);
let _e3200 = (-(_e3193) / select(1e-30f, _e3197, (_e3197 > 1e-30f)));
let _e3202 = select(0f, _e3200, (_e3200 > 0f));
let _e3208 = select(select(select(1f, _e3202, (_e3202 < 1f)), 1f, (_e3195 <= 0f)), 0f, (_e3193 > 0f));
let _e3213 = global_1.member.member_17.member_1;
let _e3214 = (_e3213 != 0u);
phi_5883_ = type_5(((((1f * _e3058) * _e3108) * _e3158) * _e3208), ((((1f * select(1f, _e3058, _e3064)) * select(1f, _e3108, _e3114)) * select(1f, _e3158, _e3164)) * select(1f, _e3208, _e3214)), ((((1f * select(1f, 0f, (_e3064 && (_e3041 > 0f)))) * select(1f, 0f, (_e3114 && (_e3091 > 0f)))) * select(1f, 0f, (_e3164 && (_e3141 > 0f)))) * select(1f, 0f, (_e3214 && (_e3191 > 0f)))));
}
let _e3223 = phi_5883_;
let _e3224 = (_e325 - _e304);
let _e3225 = (_e330 - _e313);
let _e3226 = (_e319 - _e286);
let _e3231 = (((_e3224 * _e3224) + (_e3225 * _e3225)) + (_e3226 * _e3226));
let _e3235 = (_e481 < 1e-12f);
let _e3237 = (1f / select(_e476, 1f, _e3235));
let _e3239 = ((-0.5f - _e393) * _e3237);
let _e3241 = ((_e451 - _e393) * _e3237);
let _e3247 = select(_e3241, _e3239, (_e3239 < _e3241));
let _e3249 = select(0f, _e3247, (_e3247 > 0f));
let _e3252 = select(select(1f, _e3249, (_e3249 < 1f)), select(2f, 0f, ((_e393 >= -0.5f) && (_e393 <= _e451))), _e3235);
let _e3254 = select(_e3241, _e3239, (_e3239 > _e3241));
let _e3256 = select(0f, _e3254, (_e3254 > 0f));
let _e3259 = select(select(1f, _e3256, (_e3256 < 1f)), 1f, _e3235);
let _e3260 = (_e484 < 1e-12f);
let _e3262 = (1f / select(_e477, 1f, _e3260));
let _e3264 = ((-0.5f - _e408) * _e3262);
let _e3266 = ((_e461 - _e408) * _e3262);
let _e3272 = select(_e3266, _e3264, (_e3264 < _e3266));
let _e3274 = select(0f, _e3272, (_e3272 > 0f));
let _e3277 = select(select(1f, _e3274, (_e3274 < 1f)), select(2f, 0f, ((_e408 >= -0.5f) && (_e408 <= _e461))), _e3260);
let _e3279 = select(_e3266, _e3264, (_e3264 > _e3266));
let _e3281 = select(0f, _e3279, (_e3279 > 0f));
let _e3284 = select(select(1f, _e3281, (_e3281 < 1f)), 1f, _e3260);
let _e3285 = (_e489 < 1e-12f);
let _e3287 = (1f / select(_e478, 1f, _e3285));
let _e3289 = ((-0.5f - _e423) * _e3287);
let _e3291 = ((_e471 - _e423) * _e3287);
let _e3297 = select(_e3291, _e3289, (_e3289 < _e3291));
let _e3299 = select(0f, _e3297, (_e3297 > 0f));
let _e3302 = select(select(1f, _e3299, (_e3299 < 1f)), select(2f, 0f, ((_e423 >= -0.5f) && (_e423 <= _e471))), _e3285);
let _e3304 = select(_e3291, _e3289, (_e3289 > _e3291));
let _e3306 = select(0f, _e3304, (_e3304 > 0f));
let _e3309 = select(select(1f, _e3306, (_e3306 < 1f)), 1f, _e3285);
let _e3311 = select(_e3284, _e3259, (_e3259 < _e3284));
let _e3315 = select(_e3277, _e3252, (_e3252 > _e3277));
let _e3318 = (select(_e3309, _e3311, (_e3311 < _e3309)) - select(_e3302, _e3315, (_e3315 > _e3302)));
let _e3325 = global_1.member.member_5.member_3;
let _e3326 = ((sqrt(select(0f, _e3231, (_e3231 > 0f))) * select(0f, _e3318, (_e3318 > 0f))) * _e3325);
let _e3328 = (select(1f, _e3016, (_e3016 < 1f)) * 255f);
let _e3329 = (_e2626.member * 255f);
let _e3330 = (255f - 1f);
let _e3332 = select(0f, _e3328, (_e3328 > 0f));
let _e3334 = select(_e3330, _e3332, (_e3332 < _e3330));
let _e3341 = select(0i, select(select(i32(_e3334), i32(-2147483648), (_e3334 < -2147483600f)), 2147483647i, (_e3334 > 2147483500f)), (_e3334 == _e3334));
let _e3345 = (_e3341 - select(0i, 1i, (_e3334 < f32(_e3341))));
let _e3347 = select(0f, _e3329, (_e3329 > 0f));
let _e3349 = select(_e3330, _e3347, (_e3347 < _e3330));
let _e3356 = select(0i, select(select(i32(_e3349), i32(-2147483648), (_e3349 < -2147483600f)), 2147483647i, (_e3349 > 2147483500f)), (_e3349 == _e3349));
let _e3360 = (_e3356 - select(0i, 1i, (_e3349 < f32(_e3356))));
let _e3363 = (((_e3345 * 256i) + _e3360) * 4i);
let _e3365 = (_e3328 - f32(_e3345));
let _e3367 = (_e3329 - f32(_e3360));
let _e3369 = (bitcast<i32>(_e93) - 1i);
let _e3371 = select(_e3369, _e3363, (_e3363 < _e3369));
let _e3377 = global_4.member[bitcast<u32>(select(0i, _e3371, (_e3371 > 0i)))];
let _e3378 = (_e3363 + 4i);
let _e3380 = select(_e3369, _e3378, (_e3378 < _e3369));
let _e3386 = global_4.member[bitcast<u32>(select(0i, _e3380, (_e3380 > 0i)))];
let _e3387 = (_e3363 + 1024i);
let _e3389 = select(_e3369, _e3387, (_e3387 < _e3369));
let _e3395 = global_4.member[bitcast<u32>(select(0i, _e3389, (_e3389 > 0i)))];
let _e3396 = (_e3363 + 1028i);
let _e3398 = select(_e3369, _e3396, (_e3396 < _e3369));
let _e3404 = global_4.member[bitcast<u32>(select(0i, _e3398, (_e3398 > 0i)))];
let _e3409 = (bitcast<f32>(((_e3377 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3417 = (_e3409 + (((bitcast<f32>(((_e3386 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3409) * _e3367));
let _e3422 = (bitcast<f32>(((_e3395 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3446 = (bitcast<f32>((((_e3377 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3454 = (_e3446 + (((bitcast<f32>((((_e3386 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3446) * _e3367));
let _e3459 = (bitcast<f32>((((_e3395 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3471 = (_e3363 + 1i);
let _e3473 = select(_e3369, _e3471, (_e3471 < _e3369));
let _e3479 = global_4.member[bitcast<u32>(select(0i, _e3473, (_e3473 > 0i)))];
let _e3480 = (_e3363 + 5i);
let _e3482 = select(_e3369, _e3480, (_e3480 < _e3369));
let _e3488 = global_4.member[bitcast<u32>(select(0i, _e3482, (_e3482 > 0i)))];
let _e3489 = (_e3363 + 1025i);
let _e3491 = select(_e3369, _e3489, (_e3489 < _e3369));
let _e3497 = global_4.member[bitcast<u32>(select(0i, _e3491, (_e3491 > 0i)))];
let _e3498 = (_e3363 + 1029i);
let _e3500 = select(_e3369, _e3498, (_e3498 < _e3369));
let _e3506 = global_4.member[bitcast<u32>(select(0i, _e3500, (_e3500 > 0i)))];
let _e3511 = (bitcast<f32>(((_e3479 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3519 = (_e3511 + (((bitcast<f32>(((_e3488 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3511) * _e3367));
let _e3524 = (bitcast<f32>(((_e3497 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3548 = (bitcast<f32>((((_e3479 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3556 = (_e3548 + (((bitcast<f32>((((_e3488 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3548) * _e3367));
let _e3561 = (bitcast<f32>((((_e3497 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3576 = (_e3326 * _e3223.member_1);
let _e3578 = -(((_e3454 + (((_e3459 + (((bitcast<f32>((((_e3404 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3459) * _e3367)) - _e3454) * _e3365)) * _e3576));
let _e3580 = select(-87f, _e3578, (_e3578 > -87f));
let _e3582 = select(88f, _e3580, (_e3580 < 88f));
let _e3584 = ((_e3582 * 1.442695f) + 0.5f);
let _e3586 = select(-127f, _e3584, (_e3584 > -127f));
let _e3588 = select(128f, _e3586, (_e3586 < 128f));
let _e3595 = select(0i, select(select(i32(_e3588), i32(-2147483648), (_e3588 < -2147483600f)), 2147483647i, (_e3588 > 2147483500f)), (_e3588 == _e3588));
let _e3599 = (_e3595 - select(0i, 1i, (_e3588 < f32(_e3595))));
let _e3600 = f32(_e3599);
let _e3604 = ((_e3582 - (_e3600 * 0.6933594f)) - (_e3600 * -2.1219444e-4f));
let _e3626 = -(((_e3519 + (((_e3524 + (((bitcast<f32>(((_e3506 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3524) * _e3367)) - _e3519) * _e3365)) * _e3576));
let _e3628 = select(-87f, _e3626, (_e3626 > -87f));
let _e3630 = select(88f, _e3628, (_e3628 < 88f));
let _e3632 = ((_e3630 * 1.442695f) + 0.5f);
let _e3634 = select(-127f, _e3632, (_e3632 > -127f));
let _e3636 = select(128f, _e3634, (_e3634 < 128f));
let _e3643 = select(0i, select(select(i32(_e3636), i32(-2147483648), (_e3636 < -2147483600f)), 2147483647i, (_e3636 > 2147483500f)), (_e3636 == _e3636));
let _e3647 = (_e3643 - select(0i, 1i, (_e3636 < f32(_e3643))));
let _e3648 = f32(_e3647);
let _e3652 = ((_e3630 - (_e3648 * 0.6933594f)) - (_e3648 * -2.1219444e-4f));
let _e3674 = -(((_e3556 + (((_e3561 + (((bitcast<f32>((((_e3506 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3561) * _e3367)) - _e3556) * _e3365)) * _e3576));
let _e3676 = select(-87f, _e3674, (_e3674 > -87f));
let _e3678 = select(88f, _e3676, (_e3676 < 88f));
let _e3680 = ((_e3678 * 1.442695f) + 0.5f);
let _e3682 = select(-127f, _e3680, (_e3680 > -127f));
let _e3684 = select(128f, _e3682, (_e3682 < 128f));
let _e3691 = select(0i, select(select(i32(_e3684), i32(-2147483648), (_e3684 < -2147483600f)), 2147483647i, (_e3684 > 2147483500f)), (_e3684 == _e3684));
let _e3695 = (_e3691 - select(0i, 1i, (_e3684 < f32(_e3691))));
let _e3696 = f32(_e3695);
let _e3700 = ((_e3678 - (_e3696 * 0.6933594f)) - (_e3696 * -2.1219444e-4f));
let _e3722 = -(((_e3417 + (((_e3422 + (((bitcast<f32>(((_e3404 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3422) * _e3367)) - _e3417) * _e3365)) * (_e3326 * _e3223.member)));
let _e3724 = select(-87f, _e3722, (_e3722 > -87f));
let _e3726 = select(88f, _e3724, (_e3724 < 88f));
let _e3728 = ((_e3726 * 1.442695f) + 0.5f);
let _e3730 = select(-127f, _e3728, (_e3728 > -127f));
let _e3732 = select(128f, _e3730, (_e3730 < 128f));
let _e3739 = select(0i, select(select(i32(_e3732), i32(-2147483648), (_e3732 < -2147483600f)), 2147483647i, (_e3732 > 2147483500f)), (_e3732 == _e3732));
let _e3743 = (_e3739 - select(0i, 1i, (_e3732 < f32(_e3739))));
let _e3744 = f32(_e3743);
let _e3748 = ((_e3726 - (_e3744 * 0.6933594f)) - (_e3744 * -2.1219444e-4f));
let _e3768 = ((1f + (_e3748 * (1f + (_e3748 * (0.5f + (_e3748 * (0.16666667f + (_e3748 * (0.041666668f + (_e3748 * (0.008333334f + (_e3748 * (0.001388889f + (_e3748 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3743 + 127i)) << bitcast<u32>(23i))));
if _e626 {
let _e3783 = global_1.member.member_5.member_4;
let _e3786 = (_e2626.member_3.x * _e3223.member_2);
let _e3788 = (_e2626.member_3.y * _e3223.member_2);
let _e3790 = (_e2626.member_3.z * _e3223.member_2);
let _e3791 = (0.5f * (_e243 / _e194));
let _e3795 = (_e172 + (_e3786 * _e3791));
let _e3796 = (_e183 + (_e3788 * _e3791));
let _e3797 = (_e194 + (_e3790 * _e3791));
let _e3799 = (2f * _e243);
let _e3801 = ((_e3797 * _e3797) + (_e3799 * _e3790));
let _e3805 = (_e3797 + sqrt(select(0f, _e3801, (_e3801 > 0f))));
let _e3809 = (0.5f * (_e3799 / select(1e-6f, _e3805, (_e3805 > 1e-6f))));
let _e3813 = (_e3795 + (_e3786 * _e3809));
let _e3814 = (_e3796 + (_e3788 * _e3809));
let _e3815 = (_e3797 + (_e3790 * _e3809));
let _e3819 = (_e3783 * _e3783);
let _e3821 = (_e3815 * _e3815);
let _e3829 = (((_e3797 <= 0f) || (_e3801 <= 0f)) || ((_e3815 <= 0f) || (_e3821 <= (_e3819 * (((_e3813 * _e3813) + (_e3814 * _e3814)) + _e3821)))));
let _e3843 = (_e172 + ((_e2626.member_4.x * _e3223.member_2) * _e243));
let _e3844 = (_e183 + ((_e2626.member_4.y * _e3223.member_2) * _e243));
let _e3845 = (_e194 + ((_e2626.member_4.z * _e3223.member_2) * _e243));
let _e3847 = (_e3845 * _e3845);
let _e3856 = ((_e609 & 1u) != 0u);
phi_6909_ = vec3<f32>(select(select(select(_e3813, _e3795, _e3829), _e3843, _e3856), _e172, _e616), select(select(select(_e3814, _e3796, _e3829), _e3844, _e3856), _e183, _e616), select(select(select(_e3815, _e3797, _e3829), _e3845, _e3856), _e194, _e616));
phi_6910_ = (select(_e3829, ((_e3845 <= 0f) || (_e3847 <= (_e3819 * (((_e3843 * _e3843) + (_e3844 * _e3844)) + _e3847)))), _e3856) && !(_e616));
} else {
phi_6909_ = vec3<f32>(_e172, _e183, _e194);
phi_6910_ = false;
}
let _e3868 = phi_6909_;
let _e3870 = phi_6910_;
global_6.member[_e118] = (_e129 + _e258);
global_6.member[_e130] = (_e139 + _e265);
global_6.member[_e141] = (_e150 + _e367);
global_6.member[_e152] = (_e161 + _e370);
global_6.member[_e163] = _e3868.x;
global_6.member[_e174] = _e3868.y;
global_6.member[_e185] = _e3868.z;
global_6.member[_e196] = select((_e205 * (((1f + (_e3604 * (1f + (_e3604 * (0.5f + (_e3604 * (0.16666667f + (_e3604 * (0.041666668f + (_e3604 * (0.008333334f + (_e3604 * (0.001388889f + (_e3604 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3599 + 127i)) << bitcast<u32>(23i)))) * _e3768)), _e205, _e616);
global_6.member[_e207] = select((_e216 * (((1f + (_e3652 * (1f + (_e3652 * (0.5f + (_e3652 * (0.16666667f + (_e3652 * (0.041666668f + (_e3652 * (0.008333334f + (_e3652 * (0.001388889f + (_e3652 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3647 + 127i)) << bitcast<u32>(23i)))) * _e3768)), _e216, _e616);
global_6.member[_e218] = select((_e227 * (((1f + (_e3700 * (1f + (_e3700 * (0.5f + (_e3700 * (0.16666667f + (_e3700 * (0.041666668f + (_e3700 * (0.008333334f + (_e3700 * (0.001388889f + (_e3700 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3695 + 127i)) << bitcast<u32>(23i)))) * _e3768)), _e227, _e616);
global_6.member[_e229] = select(_e238, 1f, _e3870);
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
