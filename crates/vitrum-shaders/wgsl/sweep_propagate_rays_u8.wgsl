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
member: vec3<f32>,
member_1: vec3<f32>,
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
struct type_33 {
member: array<type_24>,
}
var<private> global: vec3<u32>;
@group(0) @binding(1)
var<storage> global_1: type_16;
@group(0) @binding(3)
var<storage> global_2: type_16;
@group(0) @binding(4)
var<storage> global_3: type_16;
@group(0) @binding(6)
var<storage, read_write> global_4: type_11;
@group(0) @binding(0)
var<storage> global_5: type_33;
@group(0) @binding(5)
var<storage> global_6: type_11;
fn function_() {
var local: i32;
var local_1: i32;
var local_2: type_28;
var local_3: vec3<f32>;
var local_4: type_28;
var local_5: vec3<f32>;
var local_6: type_28;
var local_7: vec3<f32>;
var phi_584_: u32;
var phi_587_: bool;
var phi_589_: array<f32, 18>;
var phi_3698_: type_29;
var phi_4460_: type_30;
var phi_5159_: f32;
var phi_5548_: type_5;
var phi_7106_: type_31;
var phi_7859_: vec3<f32>;
var phi_8089_: type_25;
var phi_8407_: vec3<f32>;
var phi_8712_: vec3<f32>;
var phi_8713_: bool;
var phi_8778_: array<f32, 18>;
var phi_585_: u32;
var phi_588_: bool;
var phi_590_: array<f32, 18>;
var phi_8861_: bool;
var local_8: bool;
var local_9: array<f32, 18>;
var local_10: array<f32, 18>;
var local_11: array<f32, 18>;
var local_12: array<f32, 18>;
var local_13: array<f32, 18>;
var local_14: array<f32, 18>;
var local_15: array<f32, 18>;
var local_16: array<f32, 18>;
var local_17: array<f32, 18>;
var local_18: array<f32, 18>;
var local_19: array<f32, 18>;
var local_20: array<f32, 18>;
var local_21: array<f32, 18>;
var local_22: array<f32, 18>;
var local_23: array<f32, 18>;
var local_24: array<f32, 18>;
var local_25: array<f32, 18>;
var local_26: array<f32, 18>;
switch bitcast<i32>(0u) {
default: {
let _e114 = global;
let _e116 = arrayLength((&global_5.member));
let _e119 = arrayLength((&global_1.member));
let _e123 = arrayLength((&global_3.member));
if (0u < _e116) {
} else {
break;
}
let _e133 = global_5.member[0u].member_2;
let _e137 = global_5.member[0u].member;
let _e145 = (_e114.x + _e133.member);
let _e147 = (_e114.y + _e133.member_1);
if (_e145 < _e133.member_2) {
if (_e147 < _e133.member_3) {
let _e150 = (_e137.member * _e137.member_1);
let _e152 = ((_e147 * _e137.member) + _e145);
let _e153 = bitcast<i32>(_e152);
let _e155 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e157 = select(_e155, _e153, (_e153 < _e155));
let _e163 = global_4.member[bitcast<u32>(select(0i, _e157, (_e157 > 0i)))];
let _e164 = (_e150 + _e152);
let _e165 = bitcast<i32>(_e164);
let _e167 = select(_e155, _e165, (_e165 < _e155));
let _e173 = global_4.member[bitcast<u32>(select(0i, _e167, (_e167 > 0i)))];
let _e175 = ((2u * _e150) + _e152);
let _e176 = bitcast<i32>(_e175);
let _e178 = select(_e155, _e176, (_e176 < _e155));
let _e184 = global_4.member[bitcast<u32>(select(0i, _e178, (_e178 > 0i)))];
let _e186 = ((3u * _e150) + _e152);
let _e187 = bitcast<i32>(_e186);
let _e189 = select(_e155, _e187, (_e187 < _e155));
let _e195 = global_4.member[bitcast<u32>(select(0i, _e189, (_e189 > 0i)))];
let _e197 = ((4u * _e150) + _e152);
let _e198 = bitcast<i32>(_e197);
let _e200 = select(_e155, _e198, (_e198 < _e155));
let _e206 = global_4.member[bitcast<u32>(select(0i, _e200, (_e200 > 0i)))];
let _e208 = ((5u * _e150) + _e152);
let _e209 = bitcast<i32>(_e208);
let _e211 = select(_e155, _e209, (_e209 < _e155));
let _e217 = global_4.member[bitcast<u32>(select(0i, _e211, (_e211 > 0i)))];
let _e219 = ((6u * _e150) + _e152);
let _e220 = bitcast<i32>(_e219);
let _e222 = select(_e155, _e220, (_e220 < _e155));
let _e228 = global_4.member[bitcast<u32>(select(0i, _e222, (_e222 > 0i)))];
let _e230 = ((7u * _e150) + _e152);
let _e231 = bitcast<i32>(_e230);
let _e233 = select(_e155, _e231, (_e231 < _e155));
let _e239 = global_4.member[bitcast<u32>(select(0i, _e233, (_e233 > 0i)))];
let _e241 = ((8u * _e150) + _e152);
let _e242 = bitcast<i32>(_e241);
let _e244 = select(_e155, _e242, (_e242 < _e155));
let _e250 = global_4.member[bitcast<u32>(select(0i, _e244, (_e244 > 0i)))];
let _e252 = ((9u * _e150) + _e152);
let _e253 = bitcast<i32>(_e252);
let _e255 = select(_e155, _e253, (_e253 < _e155));
let _e261 = global_4.member[bitcast<u32>(select(0i, _e255, (_e255 > 0i)))];
let _e263 = ((10u * _e150) + _e152);
let _e264 = bitcast<i32>(_e263);
let _e266 = select(_e155, _e264, (_e264 < _e155));
let _e272 = global_4.member[bitcast<u32>(select(0i, _e266, (_e266 > 0i)))];
let _e274 = ((11u * _e150) + _e152);
let _e275 = bitcast<i32>(_e274);
let _e277 = select(_e155, _e275, (_e275 < _e155));
let _e283 = global_4.member[bitcast<u32>(select(0i, _e277, (_e277 > 0i)))];
let _e285 = ((12u * _e150) + _e152);
let _e286 = bitcast<i32>(_e285);
let _e288 = select(_e155, _e286, (_e286 < _e155));
let _e294 = global_4.member[bitcast<u32>(select(0i, _e288, (_e288 > 0i)))];
let _e296 = ((13u * _e150) + _e152);
let _e297 = bitcast<i32>(_e296);
let _e299 = select(_e155, _e297, (_e297 < _e155));
let _e305 = global_4.member[bitcast<u32>(select(0i, _e299, (_e299 > 0i)))];
let _e307 = ((14u * _e150) + _e152);
let _e308 = bitcast<i32>(_e307);
let _e310 = select(_e155, _e308, (_e308 < _e155));
let _e316 = global_4.member[bitcast<u32>(select(0i, _e310, (_e310 > 0i)))];
let _e318 = ((15u * _e150) + _e152);
let _e319 = bitcast<i32>(_e318);
let _e321 = select(_e155, _e319, (_e319 < _e155));
let _e327 = global_4.member[bitcast<u32>(select(0i, _e321, (_e321 > 0i)))];
let _e329 = ((16u * _e150) + _e152);
let _e330 = bitcast<i32>(_e329);
let _e332 = select(_e155, _e330, (_e330 < _e155));
let _e338 = global_4.member[bitcast<u32>(select(0i, _e332, (_e332 > 0i)))];
let _e340 = ((17u * _e150) + _e152);
let _e341 = bitcast<i32>(_e340);
let _e343 = select(_e155, _e341, (_e341 < _e155));
let _e349 = global_4.member[bitcast<u32>(select(0i, _e343, (_e343 > 0i)))];
phi_584_ = 0u;
phi_587_ = false;
phi_589_ = array<f32, 18>(_e163, _e173, _e184, _e195, _e206, _e217, _e228, _e239, _e250, _e261, _e272, _e283, _e294, _e305, _e316, _e327, _e338, _e349);
loop {
let _e352 = phi_584_;
let _e354 = phi_587_;
let _e356 = phi_589_;
local_8 = _e354;
local_9 = _e356;
local_10 = _e356;
local_11 = _e356;
local_12 = _e356;
local_13 = _e356;
local_14 = _e356;
local_15 = _e356;
local_16 = _e356;
local_17 = _e356;
local_18 = _e356;
local_19 = _e356;
local_20 = _e356;
local_21 = _e356;
local_22 = _e356;
local_23 = _e356;
local_24 = _e356;
local_25 = _e356;
local_26 = _e356;
let _e357 = (_e352 < _e116);
if _e357 {
if _e357 {
} else {
phi_8861_ = true;
break;
}
let _e370 = global_5.member[_e352].member_5.member_2;
let _e371 = (_e370 / _e356[5]);
let _e376 = global_5.member[_e352].member_5.member;
let _e378 = ((_e376 - _e356[2]) / _e356[5]);
let _e380 = (_e356[0] + (_e356[3] * _e378));
let _e382 = (_e356[1] + (_e356[4] * _e378));
let _e384 = (_e380 + (_e356[3] * _e371));
let _e386 = (_e382 + (_e356[4] * _e371));
let _e391 = global_5.member[_e352].member_5.member_1;
let _e397 = global_5.member[_e352].member_13.member.member;
let _e408 = ((((_e397.member.member * _e380) + (_e397.member.member_1 * _e382)) + (_e397.member.member_2 * _e376)) + _e397.member_1);
let _e414 = ((((_e397.member.member * _e384) + (_e397.member.member_1 * _e386)) + (_e397.member.member_2 * _e391)) + _e397.member_1);
let _e417 = ((_e408 > 0f) && (_e414 <= 0f));
let _e423 = global_5.member[_e352].member_13.member_1.member;
let _e434 = ((((_e423.member.member * _e380) + (_e423.member.member_1 * _e382)) + (_e423.member.member_2 * _e376)) + _e423.member_1);
let _e440 = ((((_e423.member.member * _e384) + (_e423.member.member_1 * _e386)) + (_e423.member.member_2 * _e391)) + _e423.member_1);
let _e443 = ((_e434 > 0f) && (_e440 <= 0f));
let _e444 = (_e417 || _e443);
let _e449 = global_5.member[_e352].member_6.member;
let _e460 = ((((_e449.member.member * _e380) + (_e449.member.member_1 * _e382)) + (_e449.member.member_2 * _e376)) + _e449.member_1);
let _e465 = global_5.member[_e352].member_6.member_1;
let _e476 = ((((_e465.member.member * _e380) + (_e465.member.member_1 * _e382)) + (_e465.member.member_2 * _e376)) + _e465.member_1);
let _e481 = global_5.member[_e352].member_6.member_2;
let _e492 = ((((_e481.member.member * _e380) + (_e481.member.member_1 * _e382)) + (_e481.member.member_2 * _e376)) + _e481.member_1);
let _e498 = ((((_e449.member.member * _e384) + (_e449.member.member_1 * _e386)) + (_e449.member.member_2 * _e391)) + _e449.member_1);
let _e504 = ((((_e465.member.member * _e384) + (_e465.member.member_1 * _e386)) + (_e465.member.member_2 * _e391)) + _e465.member_1);
let _e510 = ((((_e481.member.member * _e384) + (_e481.member.member_1 * _e386)) + (_e481.member.member_2 * _e391)) + _e481.member_1);
let _e515 = global_5.member[_e352].member_6.member_4;
let _e521 = global_5.member[_e352].member_6.member_3.member;
let _e522 = (_e521 - 0.5f);
let _e524 = select(-0.5f, _e498, (_e498 > -0.5f));
let _e526 = select(_e522, _e524, (_e524 < _e522));
let _e532 = global_5.member[_e352].member_6.member_3.member_1;
let _e533 = (_e532 - 0.5f);
let _e535 = select(-0.5f, _e504, (_e504 > -0.5f));
let _e537 = select(_e533, _e535, (_e535 < _e533));
let _e543 = global_5.member[_e352].member_6.member_3.member_2;
let _e544 = (_e543 - 0.5f);
let _e546 = select(-0.5f, _e510, (_e510 > -0.5f));
let _e548 = select(_e544, _e546, (_e546 < _e544));
let _e549 = (_e498 - _e460);
let _e550 = (_e504 - _e476);
let _e551 = (_e510 - _e492);
let _e554 = bitcast<f32>((bitcast<u32>(_e549) & 2147483647u));
let _e557 = bitcast<f32>((bitcast<u32>(_e550) & 2147483647u));
let _e559 = select(_e557, _e554, (_e554 > _e557));
let _e562 = bitcast<f32>((bitcast<u32>(_e551) & 2147483647u));
let _e571 = bitcast<f32>((bitcast<u32>((_e498 - _e526)) & 2147483647u));
let _e574 = bitcast<f32>((bitcast<u32>((_e504 - _e537)) & 2147483647u));
let _e576 = select(_e574, _e571, (_e571 > _e574));
let _e579 = bitcast<f32>((bitcast<u32>((_e510 - _e548)) & 2147483647u));
let _e583 = (_e526 + 0.5f);
let _e584 = (_e521 - 1f);
let _e586 = select(0f, _e583, (_e583 > 0f));
let _e588 = select(_e584, _e586, (_e586 < _e584));
let _e595 = select(0i, select(select(i32(_e588), i32(-2147483648), (_e588 < -2147483600f)), 2147483647i, (_e588 > 2147483500f)), (_e588 == _e588));
let _e604 = global_5.member[_e352].member_6.member_12;
let _e605 = (_e604 & 31u);
let _e608 = (_e537 + 0.5f);
let _e609 = (_e532 - 1f);
let _e611 = select(0f, _e608, (_e608 > 0f));
let _e613 = select(_e609, _e611, (_e611 < _e609));
let _e620 = select(0i, select(select(i32(_e613), i32(-2147483648), (_e613 < -2147483600f)), 2147483647i, (_e613 > 2147483500f)), (_e613 == _e613));
let _e627 = (_e548 + 0.5f);
let _e628 = (_e543 - 1f);
let _e630 = select(0f, _e627, (_e627 > 0f));
let _e632 = select(_e628, _e630, (_e630 < _e628));
let _e639 = select(0i, select(select(i32(_e632), i32(-2147483648), (_e632 < -2147483600f)), 2147483647i, (_e632 > 2147483500f)), (_e632 == _e632));
let _e651 = global_5.member[_e352].member_6.member_9.member;
let _e658 = global_5.member[_e352].member_6.member_9.member_1;
let _e664 = global_5.member[_e352].member_6.member_10;
let _e670 = ((bitcast<i32>(_e664) + ((_e595 - select(0i, 1i, (_e588 < f32(_e595)))) >> bitcast<u32>(_e605))) + (bitcast<i32>(_e651) * (((_e620 - select(0i, 1i, (_e613 < f32(_e620)))) >> bitcast<u32>(_e605)) + (bitcast<i32>(_e658) * ((_e639 - select(0i, 1i, (_e632 < f32(_e639)))) >> bitcast<u32>(_e605))))));
let _e672 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e674 = select(_e672, _e670, (_e670 < _e672));
let _e680 = global_2.member[bitcast<u32>(select(0i, _e674, (_e674 > 0i)))];
let _e687 = global_5.member[_e352].member_1;
let _e719 = (_e356[17] != _e376);
let _e725 = (select(0u, select(select(select(select(7u, 3u, (((((((_e460 >= 0f) && (_e460 <= _e584)) && (_e476 >= 0f)) && (_e476 <= _e609)) && (_e492 >= 0f)) && (_e492 <= _e628)) && ((((((_e498 >= 0f) && (_e498 <= _e584)) && (_e504 >= 0f)) && (_e504 <= _e609)) && (_e510 >= 0f)) && (_e510 <= _e628)))), 15u, _e719), 1u, (((_e687 & 64u) != 0u) || ((((select(_e562, _e559, (_e559 > _e562)) <= _e515) && ((select(_e579, _e576, (_e576 > _e579)) > _e515) || (_e680 != 0u))) && true) && ((_e687 & 32u) != 0u)))), 31u, _e444), (_e356[7] == 0f)) > 1u);
if _e725 {
let _e729 = global_5.member[_e352].member;
let _e742 = (_e408 - _e414);
let _e745 = (_e408 / select(1e-20f, _e742, (_e742 > 1e-20f)));
let _e746 = (_e434 - _e440);
let _e749 = (_e434 / select(1e-20f, _e746, (_e746 > 1e-20f)));
let _e753 = (_e443 && (!(_e417) || (_e749 < _e745)));
let _e760 = global_5.member[_e352].member_13.member_1.member.member;
let _e766 = global_5.member[_e352].member_13.member_1.member_1;
let _e773 = global_5.member[_e352].member_13.member.member.member;
let _e779 = global_5.member[_e352].member_13.member.member_1;
let _e798 = select(_e745, _e749, _e753);
let _e800 = (_e729.member_2 == 2u);
let _e803 = (((_e729.member_2 == 1u) || _e800) || (_e729.member_2 == 5u));
if _e803 {
let _e805 = select(-1f, _e526, (_e526 > -1f));
let _e807 = select(_e521, _e805, (_e805 < _e521));
let _e814 = select(0i, select(select(i32(_e807), i32(-2147483648), (_e807 < -2147483600f)), 2147483647i, (_e807 > 2147483500f)), (_e807 == _e807));
let _e818 = (_e814 - select(0i, 1i, (_e807 < f32(_e814))));
let _e820 = select(-1f, _e537, (_e537 > -1f));
let _e822 = select(_e532, _e820, (_e820 < _e532));
let _e829 = select(0i, select(select(i32(_e822), i32(-2147483648), (_e822 < -2147483600f)), 2147483647i, (_e822 > 2147483500f)), (_e822 == _e822));
let _e833 = (_e829 - select(0i, 1i, (_e822 < f32(_e829))));
let _e835 = select(-1f, _e548, (_e548 > -1f));
let _e837 = select(_e543, _e835, (_e835 < _e543));
let _e844 = select(0i, select(select(i32(_e837), i32(-2147483648), (_e837 < -2147483600f)), 2147483647i, (_e837 > 2147483500f)), (_e837 == _e837));
let _e848 = (_e844 - select(0i, 1i, (_e837 < f32(_e844))));
let _e853 = global_5.member[_e352].member_6.member_7;
let _e858 = global_5.member[_e352].member_6.member_8;
let _e866 = (select(0i, select(select(i32(_e532), i32(-2147483648), (_e532 < -2147483600f)), 2147483647i, (_e532 > 2147483500f)), (_e532 == _e532)) - 1i);
let _e867 = (_e833 - 1i);
let _e872 = (_e833 + 1i);
let _e875 = (_e833 + 2i);
let _e885 = (select(0i, select(select(i32(_e543), i32(-2147483648), (_e543 < -2147483600f)), 2147483647i, (_e543 > 2147483500f)), (_e543 == _e543)) - 1i);
let _e886 = (_e848 - 1i);
let _e891 = (_e848 + 1i);
let _e894 = (_e848 + 2i);
let _e903 = select(0i, select(select(i32(_e521), i32(-2147483648), (_e521 < -2147483600f)), 2147483647i, (_e521 > 2147483500f)), (_e521 == _e521));
let _e904 = (_e903 - 1i);
let _e905 = (_e818 - 1i);
let _e907 = select(0i, _e905, (_e905 > 0i));
let _e910 = (_e818 + 1i);
let _e913 = (_e818 + 2i);
let _e916 = (_e903 - 4i);
let _e918 = select(0i, _e916, (_e916 > 0i));
let _e920 = select(_e918, _e907, (_e907 < _e918));
let _e933 = (select(0i, _e867, (_e867 > 0i)) * _e853);
let _e934 = (select(0i, _e833, (_e833 > 0i)) * _e853);
let _e935 = (select(_e866, _e872, (_e872 < _e866)) * _e853);
let _e936 = (select(_e866, _e875, (_e875 < _e866)) * _e853);
let _e937 = (select(0i, _e886, (_e886 > 0i)) * _e858);
let _e938 = (select(0i, _e848, (_e848 > 0i)) * _e858);
let _e939 = (select(_e885, _e891, (_e891 < _e885)) * _e858);
let _e940 = (select(_e885, _e894, (_e894 < _e885)) * _e858);
local_6 = type_28(array<i32, 4>(_e920, _e920, _e920, _e920), array<u32, 6>(bitcast<u32>(((_e907 - _e920) * 8i)), bitcast<u32>(((select(0i, _e818, (_e818 > 0i)) - _e920) * 8i)), bitcast<u32>(((select(_e904, _e910, (_e910 < _e904)) - _e920) * 8i)), bitcast<u32>(((select(_e904, _e913, (_e913 < _e904)) - _e920) * 8i)), 0u, 0u));
local_7 = vec3<f32>((_e526 - f32(_e818)), (_e537 - f32(_e833)), (_e548 - f32(_e848)));
let _e955 = local_6.member[0u];
let _e956 = ((_e938 + _e934) + _e955);
let _e958 = (_e956 >> bitcast<u32>(2i));
let _e961 = bitcast<u32>(((_e956 & 3i) * 8i));
let _e963 = (bitcast<i32>(_e119) - 1i);
let _e965 = select(_e963, _e958, (_e958 < _e963));
let _e970 = global_1.member[bitcast<u32>(select(0i, _e965, (_e965 > 0i)))];
let _e974 = (_e958 + 1i);
let _e976 = select(_e963, _e974, (_e974 < _e963));
let _e981 = global_1.member[bitcast<u32>(select(0i, _e976, (_e976 > 0i)))];
let _e988 = ((_e970 >> bitcast<u32>((_e961 & 31u))) | ((_e981 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e961) & 31u))));
let _e991 = local_6.member_1[0u];
let _e997 = f32(bitcast<i32>(((_e988 >> bitcast<u32>((_e991 & 31u))) & 255u)));
let _e1000 = local_6.member_1[1u];
let _e1006 = f32(bitcast<i32>(((_e988 >> bitcast<u32>((_e1000 & 31u))) & 255u)));
let _e1009 = local_6.member_1[2u];
let _e1015 = f32(bitcast<i32>(((_e988 >> bitcast<u32>((_e1009 & 31u))) & 255u)));
let _e1018 = local_6.member_1[3u];
let _e1025 = local_7[0u];
let _e1028 = (_e997 + ((_e1006 - _e997) * _e1025));
let _e1029 = local_7[0u];
let _e1032 = (_e1006 + ((_e1015 - _e1006) * _e1029));
let _e1033 = local_7[0u];
let _e1036 = (_e1015 + ((f32(bitcast<i32>(((_e988 >> bitcast<u32>((_e1018 & 31u))) & 255u))) - _e1015) * _e1033));
let _e1038 = local_6.member[0u];
let _e1039 = ((_e938 + _e935) + _e1038);
let _e1041 = (_e1039 >> bitcast<u32>(2i));
let _e1044 = bitcast<u32>(((_e1039 & 3i) * 8i));
let _e1046 = select(_e963, _e1041, (_e1041 < _e963));
let _e1051 = global_1.member[bitcast<u32>(select(0i, _e1046, (_e1046 > 0i)))];
let _e1055 = (_e1041 + 1i);
let _e1057 = select(_e963, _e1055, (_e1055 < _e963));
let _e1062 = global_1.member[bitcast<u32>(select(0i, _e1057, (_e1057 > 0i)))];
let _e1069 = ((_e1051 >> bitcast<u32>((_e1044 & 31u))) | ((_e1062 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1044) & 31u))));
let _e1070 = local_6.member_1[0u];
let _e1076 = f32(bitcast<i32>(((_e1069 >> bitcast<u32>((_e1070 & 31u))) & 255u)));
let _e1077 = local_6.member_1[1u];
let _e1083 = f32(bitcast<i32>(((_e1069 >> bitcast<u32>((_e1077 & 31u))) & 255u)));
let _e1084 = local_6.member_1[2u];
let _e1090 = f32(bitcast<i32>(((_e1069 >> bitcast<u32>((_e1084 & 31u))) & 255u)));
let _e1091 = local_6.member_1[3u];
let _e1098 = local_7[0u];
let _e1102 = local_7[0u];
let _e1105 = (_e1083 + ((_e1090 - _e1083) * _e1102));
let _e1106 = local_7[0u];
let _e1111 = local_6.member[0u];
let _e1112 = ((_e939 + _e934) + _e1111);
let _e1114 = (_e1112 >> bitcast<u32>(2i));
let _e1117 = bitcast<u32>(((_e1112 & 3i) * 8i));
let _e1119 = select(_e963, _e1114, (_e1114 < _e963));
let _e1124 = global_1.member[bitcast<u32>(select(0i, _e1119, (_e1119 > 0i)))];
let _e1128 = (_e1114 + 1i);
let _e1130 = select(_e963, _e1128, (_e1128 < _e963));
let _e1135 = global_1.member[bitcast<u32>(select(0i, _e1130, (_e1130 > 0i)))];
let _e1142 = ((_e1124 >> bitcast<u32>((_e1117 & 31u))) | ((_e1135 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1117) & 31u))));
let _e1143 = local_6.member_1[0u];
let _e1149 = f32(bitcast<i32>(((_e1142 >> bitcast<u32>((_e1143 & 31u))) & 255u)));
let _e1150 = local_6.member_1[1u];
let _e1156 = f32(bitcast<i32>(((_e1142 >> bitcast<u32>((_e1150 & 31u))) & 255u)));
let _e1157 = local_6.member_1[2u];
let _e1163 = f32(bitcast<i32>(((_e1142 >> bitcast<u32>((_e1157 & 31u))) & 255u)));
let _e1164 = local_6.member_1[3u];
let _e1171 = local_7[0u];
let _e1174 = (_e1149 + ((_e1156 - _e1149) * _e1171));
let _e1175 = local_7[0u];
let _e1178 = (_e1156 + ((_e1163 - _e1156) * _e1175));
let _e1179 = local_7[0u];
let _e1182 = (_e1163 + ((f32(bitcast<i32>(((_e1142 >> bitcast<u32>((_e1164 & 31u))) & 255u))) - _e1163) * _e1179));
let _e1184 = local_6.member[0u];
let _e1185 = ((_e939 + _e935) + _e1184);
let _e1187 = (_e1185 >> bitcast<u32>(2i));
let _e1190 = bitcast<u32>(((_e1185 & 3i) * 8i));
let _e1192 = select(_e963, _e1187, (_e1187 < _e963));
let _e1197 = global_1.member[bitcast<u32>(select(0i, _e1192, (_e1192 > 0i)))];
let _e1201 = (_e1187 + 1i);
let _e1203 = select(_e963, _e1201, (_e1201 < _e963));
let _e1208 = global_1.member[bitcast<u32>(select(0i, _e1203, (_e1203 > 0i)))];
let _e1215 = ((_e1197 >> bitcast<u32>((_e1190 & 31u))) | ((_e1208 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1190) & 31u))));
let _e1216 = local_6.member_1[0u];
let _e1222 = f32(bitcast<i32>(((_e1215 >> bitcast<u32>((_e1216 & 31u))) & 255u)));
let _e1223 = local_6.member_1[1u];
let _e1229 = f32(bitcast<i32>(((_e1215 >> bitcast<u32>((_e1223 & 31u))) & 255u)));
let _e1230 = local_6.member_1[2u];
let _e1236 = f32(bitcast<i32>(((_e1215 >> bitcast<u32>((_e1230 & 31u))) & 255u)));
let _e1237 = local_6.member_1[3u];
let _e1244 = local_7[0u];
let _e1248 = local_7[0u];
let _e1251 = (_e1229 + ((_e1236 - _e1229) * _e1248));
let _e1252 = local_7[0u];
let _e1257 = local_6.member[0u];
let _e1258 = ((_e938 + _e933) + _e1257);
let _e1260 = (_e1258 >> bitcast<u32>(2i));
let _e1263 = bitcast<u32>(((_e1258 & 3i) * 8i));
let _e1265 = select(_e963, _e1260, (_e1260 < _e963));
let _e1270 = global_1.member[bitcast<u32>(select(0i, _e1265, (_e1265 > 0i)))];
let _e1274 = (_e1260 + 1i);
let _e1276 = select(_e963, _e1274, (_e1274 < _e963));
let _e1281 = global_1.member[bitcast<u32>(select(0i, _e1276, (_e1276 > 0i)))];
let _e1288 = ((_e1270 >> bitcast<u32>((_e1263 & 31u))) | ((_e1281 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1263) & 31u))));
let _e1289 = local_6.member_1[1u];
let _e1295 = f32(bitcast<i32>(((_e1288 >> bitcast<u32>((_e1289 & 31u))) & 255u)));
let _e1296 = local_6.member_1[2u];
let _e1303 = local_7[0u];
let _e1306 = (_e1295 + ((f32(bitcast<i32>(((_e1288 >> bitcast<u32>((_e1296 & 31u))) & 255u))) - _e1295) * _e1303));
let _e1308 = local_6.member[0u];
let _e1309 = ((_e938 + _e936) + _e1308);
let _e1311 = (_e1309 >> bitcast<u32>(2i));
let _e1314 = bitcast<u32>(((_e1309 & 3i) * 8i));
let _e1316 = select(_e963, _e1311, (_e1311 < _e963));
let _e1321 = global_1.member[bitcast<u32>(select(0i, _e1316, (_e1316 > 0i)))];
let _e1325 = (_e1311 + 1i);
let _e1327 = select(_e963, _e1325, (_e1325 < _e963));
let _e1332 = global_1.member[bitcast<u32>(select(0i, _e1327, (_e1327 > 0i)))];
let _e1339 = ((_e1321 >> bitcast<u32>((_e1314 & 31u))) | ((_e1332 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1314) & 31u))));
let _e1340 = local_6.member_1[1u];
let _e1346 = f32(bitcast<i32>(((_e1339 >> bitcast<u32>((_e1340 & 31u))) & 255u)));
let _e1347 = local_6.member_1[2u];
let _e1354 = local_7[0u];
let _e1359 = local_6.member[0u];
let _e1360 = ((_e939 + _e933) + _e1359);
let _e1362 = (_e1360 >> bitcast<u32>(2i));
let _e1365 = bitcast<u32>(((_e1360 & 3i) * 8i));
let _e1367 = select(_e963, _e1362, (_e1362 < _e963));
let _e1372 = global_1.member[bitcast<u32>(select(0i, _e1367, (_e1367 > 0i)))];
let _e1376 = (_e1362 + 1i);
let _e1378 = select(_e963, _e1376, (_e1376 < _e963));
let _e1383 = global_1.member[bitcast<u32>(select(0i, _e1378, (_e1378 > 0i)))];
let _e1390 = ((_e1372 >> bitcast<u32>((_e1365 & 31u))) | ((_e1383 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1365) & 31u))));
let _e1391 = local_6.member_1[1u];
let _e1397 = f32(bitcast<i32>(((_e1390 >> bitcast<u32>((_e1391 & 31u))) & 255u)));
let _e1398 = local_6.member_1[2u];
let _e1405 = local_7[0u];
let _e1408 = (_e1397 + ((f32(bitcast<i32>(((_e1390 >> bitcast<u32>((_e1398 & 31u))) & 255u))) - _e1397) * _e1405));
let _e1410 = local_6.member[0u];
let _e1411 = ((_e939 + _e936) + _e1410);
let _e1413 = (_e1411 >> bitcast<u32>(2i));
let _e1416 = bitcast<u32>(((_e1411 & 3i) * 8i));
let _e1418 = select(_e963, _e1413, (_e1413 < _e963));
let _e1423 = global_1.member[bitcast<u32>(select(0i, _e1418, (_e1418 > 0i)))];
let _e1427 = (_e1413 + 1i);
let _e1429 = select(_e963, _e1427, (_e1427 < _e963));
let _e1434 = global_1.member[bitcast<u32>(select(0i, _e1429, (_e1429 > 0i)))];
let _e1441 = ((_e1423 >> bitcast<u32>((_e1416 & 31u))) | ((_e1434 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1416) & 31u))));
let _e1442 = local_6.member_1[1u];
let _e1448 = f32(bitcast<i32>(((_e1441 >> bitcast<u32>((_e1442 & 31u))) & 255u)));
let _e1449 = local_6.member_1[2u];
let _e1456 = local_7[0u];
let _e1461 = local_6.member[0u];
let _e1462 = ((_e937 + _e934) + _e1461);
let _e1464 = (_e1462 >> bitcast<u32>(2i));
let _e1467 = bitcast<u32>(((_e1462 & 3i) * 8i));
let _e1469 = select(_e963, _e1464, (_e1464 < _e963));
let _e1474 = global_1.member[bitcast<u32>(select(0i, _e1469, (_e1469 > 0i)))];
let _e1478 = (_e1464 + 1i);
let _e1480 = select(_e963, _e1478, (_e1478 < _e963));
let _e1485 = global_1.member[bitcast<u32>(select(0i, _e1480, (_e1480 > 0i)))];
let _e1492 = ((_e1474 >> bitcast<u32>((_e1467 & 31u))) | ((_e1485 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1467) & 31u))));
let _e1493 = local_6.member_1[1u];
let _e1499 = f32(bitcast<i32>(((_e1492 >> bitcast<u32>((_e1493 & 31u))) & 255u)));
let _e1500 = local_6.member_1[2u];
let _e1507 = local_7[0u];
let _e1510 = (_e1499 + ((f32(bitcast<i32>(((_e1492 >> bitcast<u32>((_e1500 & 31u))) & 255u))) - _e1499) * _e1507));
let _e1512 = local_6.member[0u];
let _e1513 = ((_e940 + _e934) + _e1512);
let _e1515 = (_e1513 >> bitcast<u32>(2i));
let _e1518 = bitcast<u32>(((_e1513 & 3i) * 8i));
let _e1520 = select(_e963, _e1515, (_e1515 < _e963));
let _e1525 = global_1.member[bitcast<u32>(select(0i, _e1520, (_e1520 > 0i)))];
let _e1529 = (_e1515 + 1i);
let _e1531 = select(_e963, _e1529, (_e1529 < _e963));
let _e1536 = global_1.member[bitcast<u32>(select(0i, _e1531, (_e1531 > 0i)))];
let _e1543 = ((_e1525 >> bitcast<u32>((_e1518 & 31u))) | ((_e1536 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1518) & 31u))));
let _e1544 = local_6.member_1[1u];
let _e1550 = f32(bitcast<i32>(((_e1543 >> bitcast<u32>((_e1544 & 31u))) & 255u)));
let _e1551 = local_6.member_1[2u];
let _e1558 = local_7[0u];
let _e1561 = (_e1550 + ((f32(bitcast<i32>(((_e1543 >> bitcast<u32>((_e1551 & 31u))) & 255u))) - _e1550) * _e1558));
let _e1563 = local_6.member[0u];
let _e1564 = ((_e937 + _e935) + _e1563);
let _e1566 = (_e1564 >> bitcast<u32>(2i));
let _e1569 = bitcast<u32>(((_e1564 & 3i) * 8i));
let _e1571 = select(_e963, _e1566, (_e1566 < _e963));
let _e1576 = global_1.member[bitcast<u32>(select(0i, _e1571, (_e1571 > 0i)))];
let _e1580 = (_e1566 + 1i);
let _e1582 = select(_e963, _e1580, (_e1580 < _e963));
let _e1587 = global_1.member[bitcast<u32>(select(0i, _e1582, (_e1582 > 0i)))];
let _e1594 = ((_e1576 >> bitcast<u32>((_e1569 & 31u))) | ((_e1587 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1569) & 31u))));
let _e1595 = local_6.member_1[1u];
let _e1601 = f32(bitcast<i32>(((_e1594 >> bitcast<u32>((_e1595 & 31u))) & 255u)));
let _e1602 = local_6.member_1[2u];
let _e1609 = local_7[0u];
let _e1614 = local_6.member[0u];
let _e1615 = ((_e940 + _e935) + _e1614);
let _e1617 = (_e1615 >> bitcast<u32>(2i));
let _e1620 = bitcast<u32>(((_e1615 & 3i) * 8i));
let _e1622 = select(_e963, _e1617, (_e1617 < _e963));
let _e1627 = global_1.member[bitcast<u32>(select(0i, _e1622, (_e1622 > 0i)))];
let _e1631 = (_e1617 + 1i);
let _e1633 = select(_e963, _e1631, (_e1631 < _e963));
let _e1638 = global_1.member[bitcast<u32>(select(0i, _e1633, (_e1633 > 0i)))];
let _e1645 = ((_e1627 >> bitcast<u32>((_e1620 & 31u))) | ((_e1638 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1620) & 31u))));
let _e1646 = local_6.member_1[1u];
let _e1652 = f32(bitcast<i32>(((_e1645 >> bitcast<u32>((_e1646 & 31u))) & 255u)));
let _e1653 = local_6.member_1[2u];
let _e1660 = local_7[0u];
let _e1665 = local_7[1u];
let _e1668 = (_e1032 + ((_e1105 - _e1032) * _e1665));
let _e1669 = local_7[1u];
let _e1672 = (_e1178 + ((_e1251 - _e1178) * _e1669));
let _e1673 = local_7[1u];
let _e1676 = (_e1028 + (((_e1076 + ((_e1083 - _e1076) * _e1098)) - _e1028) * _e1673));
let _e1677 = local_7[1u];
let _e1682 = local_7[2u];
let _e1686 = local_7[1u];
let _e1689 = (_e1036 + (((_e1090 + ((f32(bitcast<i32>(((_e1069 >> bitcast<u32>((_e1091 & 31u))) & 255u))) - _e1090) * _e1106)) - _e1036) * _e1686));
let _e1690 = local_7[1u];
let _e1694 = local_7[2u];
let _e1698 = local_7[1u];
let _e1701 = (_e1306 + ((_e1032 - _e1306) * _e1698));
let _e1702 = local_7[1u];
let _e1706 = local_7[2u];
let _e1710 = local_7[1u];
let _e1713 = (_e1105 + (((_e1346 + ((f32(bitcast<i32>(((_e1339 >> bitcast<u32>((_e1347 & 31u))) & 255u))) - _e1346) * _e1354)) - _e1105) * _e1710));
let _e1714 = local_7[1u];
let _e1718 = local_7[2u];
let _e1722 = local_7[1u];
let _e1725 = (_e1510 + (((_e1601 + ((f32(bitcast<i32>(((_e1594 >> bitcast<u32>((_e1602 & 31u))) & 255u))) - _e1601) * _e1609)) - _e1510) * _e1722));
let _e1726 = local_7[2u];
let _e1730 = local_7[1u];
let _e1734 = local_7[2u];
let _e1738 = local_7[2u];
let _e1746 = global_5.member[_e352].member_6.member_5;
let _e1752 = global_5.member[_e352].member_6.member_6;
let _e1753 = (((_e1668 + ((_e1672 - _e1668) * _e1738)) * _e1746) + _e1752);
let _e1755 = select(0f, _e1753, (_e1753 > 0f));
let _e1757 = select(1f, _e1755, (_e1755 < 1f));
let _e1759 = (((_e1676 + (((_e1174 + (((_e1222 + ((_e1229 - _e1222) * _e1244)) - _e1174) * _e1677)) - _e1676) * _e1682)) * _e1746) + _e1752);
let _e1761 = select(0f, _e1759, (_e1759 > 0f));
let _e1763 = select(1f, _e1761, (_e1761 < 1f));
let _e1765 = (((_e1689 + (((_e1182 + (((_e1236 + ((f32(bitcast<i32>(((_e1215 >> bitcast<u32>((_e1237 & 31u))) & 255u))) - _e1236) * _e1252)) - _e1182) * _e1690)) - _e1689) * _e1694)) * _e1746) + _e1752);
let _e1767 = select(0f, _e1765, (_e1765 > 0f));
let _e1769 = select(1f, _e1767, (_e1767 < 1f));
let _e1771 = (((_e1701 + (((_e1408 + ((_e1178 - _e1408) * _e1702)) - _e1701) * _e1706)) * _e1746) + _e1752);
let _e1773 = select(0f, _e1771, (_e1771 > 0f));
let _e1775 = select(1f, _e1773, (_e1773 < 1f));
let _e1777 = (((_e1713 + (((_e1251 + (((_e1448 + ((f32(bitcast<i32>(((_e1441 >> bitcast<u32>((_e1449 & 31u))) & 255u))) - _e1448) * _e1456)) - _e1251) * _e1714)) - _e1713) * _e1718)) * _e1746) + _e1752);
let _e1779 = select(0f, _e1777, (_e1777 > 0f));
let _e1781 = select(1f, _e1779, (_e1779 < 1f));
let _e1783 = (((_e1725 + ((_e1668 - _e1725) * _e1726)) * _e1746) + _e1752);
let _e1785 = select(0f, _e1783, (_e1783 > 0f));
let _e1787 = select(1f, _e1785, (_e1785 < 1f));
let _e1789 = (((_e1672 + (((_e1561 + (((_e1652 + ((f32(bitcast<i32>(((_e1645 >> bitcast<u32>((_e1653 & 31u))) & 255u))) - _e1652) * _e1660)) - _e1561) * _e1730)) - _e1672) * _e1734)) * _e1746) + _e1752);
let _e1791 = select(0f, _e1789, (_e1789 > 0f));
let _e1793 = select(1f, _e1791, (_e1791 < 1f));
let _e1794 = (_e1757 * 1024f);
let _e1795 = (1024f - 1f);
let _e1797 = select(0f, _e1794, (_e1794 > 0f));
let _e1799 = select(_e1795, _e1797, (_e1797 < _e1795));
let _e1806 = select(0i, select(select(i32(_e1799), i32(-2147483648), (_e1799 < -2147483600f)), 2147483647i, (_e1799 > 2147483500f)), (_e1799 == _e1799));
let _e1810 = (_e1806 - select(0i, 1i, (_e1799 < f32(_e1806))));
let _e1811 = (262147i + _e1810);
let _e1813 = (bitcast<i32>(_e123) - 1i);
let _e1815 = select(_e1813, _e1811, (_e1811 < _e1813));
let _e1821 = global_3.member[bitcast<u32>(select(0i, _e1815, (_e1815 > 0i)))];
let _e1831 = select(_e1813, 262146i, (262146i < _e1813));
let _e1837 = global_3.member[bitcast<u32>(select(0i, _e1831, (_e1831 > 0i)))];
let _e1838 = bitcast<f32>(_e1837);
let _e1839 = (f32((bitcast<i32>((_e1821 & 4095u)) - 2048i)) * _e1838);
let _e1841 = select(_e1813, 262144i, (262144i < _e1813));
let _e1847 = global_3.member[bitcast<u32>(select(0i, _e1841, (_e1841 > 0i)))];
let _e1848 = bitcast<f32>(_e1847);
let _e1850 = select(_e1813, 262145i, (262145i < _e1813));
let _e1856 = global_3.member[bitcast<u32>(select(0i, _e1850, (_e1850 > 0i)))];
let _e1857 = bitcast<f32>(_e1856);
let _e1863 = ((_e1848 + (f32(bitcast<i32>((_e1821 >> bitcast<u32>(12u)))) * _e1857)) + (_e1839 * (_e1794 - f32(_e1810))));
let _e1864 = (_e1839 * 1024f);
if _e800 {
let _e1871 = ((0.5f * (_e1769 - _e1763)) * _e1864);
let _e1872 = ((0.5f * (_e1781 - _e1775)) * _e1864);
let _e1873 = ((0.5f * (_e1793 - _e1787)) * _e1864);
phi_3698_ = type_29(_e1863, vec3<f32>(_e1871, _e1872, _e1873), vec3<f32>((_e1871 * _e1863), (_e1872 * _e1863), (_e1873 * _e1863)));
} else {
let _e1880 = (_e1763 * 1024f);
let _e1882 = select(0f, _e1880, (_e1880 > 0f));
let _e1884 = select(_e1795, _e1882, (_e1882 < _e1795));
let _e1891 = select(0i, select(select(i32(_e1884), i32(-2147483648), (_e1884 < -2147483600f)), 2147483647i, (_e1884 > 2147483500f)), (_e1884 == _e1884));
let _e1895 = (_e1891 - select(0i, 1i, (_e1884 < f32(_e1891))));
let _e1896 = (262147i + _e1895);
let _e1898 = select(_e1813, _e1896, (_e1896 < _e1813));
let _e1904 = global_3.member[bitcast<u32>(select(0i, _e1898, (_e1898 > 0i)))];
let _e1919 = ((_e1848 + (f32(bitcast<i32>((_e1904 >> bitcast<u32>(12u)))) * _e1857)) + ((f32((bitcast<i32>((_e1904 & 4095u)) - 2048i)) * _e1838) * (_e1880 - f32(_e1895))));
let _e1920 = (_e1769 * 1024f);
let _e1922 = select(0f, _e1920, (_e1920 > 0f));
let _e1924 = select(_e1795, _e1922, (_e1922 < _e1795));
let _e1931 = select(0i, select(select(i32(_e1924), i32(-2147483648), (_e1924 < -2147483600f)), 2147483647i, (_e1924 > 2147483500f)), (_e1924 == _e1924));
let _e1935 = (_e1931 - select(0i, 1i, (_e1924 < f32(_e1931))));
let _e1936 = (262147i + _e1935);
let _e1938 = select(_e1813, _e1936, (_e1936 < _e1813));
let _e1944 = global_3.member[bitcast<u32>(select(0i, _e1938, (_e1938 > 0i)))];
let _e1959 = ((_e1848 + (f32(bitcast<i32>((_e1944 >> bitcast<u32>(12u)))) * _e1857)) + ((f32((bitcast<i32>((_e1944 & 4095u)) - 2048i)) * _e1838) * (_e1920 - f32(_e1935))));
let _e1960 = (_e1775 * 1024f);
let _e1962 = select(0f, _e1960, (_e1960 > 0f));
let _e1964 = select(_e1795, _e1962, (_e1962 < _e1795));
let _e1971 = select(0i, select(select(i32(_e1964), i32(-2147483648), (_e1964 < -2147483600f)), 2147483647i, (_e1964 > 2147483500f)), (_e1964 == _e1964));
let _e1975 = (_e1971 - select(0i, 1i, (_e1964 < f32(_e1971))));
let _e1976 = (262147i + _e1975);
let _e1978 = select(_e1813, _e1976, (_e1976 < _e1813));
let _e1984 = global_3.member[bitcast<u32>(select(0i, _e1978, (_e1978 > 0i)))];
let _e1999 = ((_e1848 + (f32(bitcast<i32>((_e1984 >> bitcast<u32>(12u)))) * _e1857)) + ((f32((bitcast<i32>((_e1984 & 4095u)) - 2048i)) * _e1838) * (_e1960 - f32(_e1975))));
let _e2000 = (_e1781 * 1024f);
let _e2002 = select(0f, _e2000, (_e2000 > 0f));
let _e2004 = select(_e1795, _e2002, (_e2002 < _e1795));
let _e2011 = select(0i, select(select(i32(_e2004), i32(-2147483648), (_e2004 < -2147483600f)), 2147483647i, (_e2004 > 2147483500f)), (_e2004 == _e2004));
let _e2015 = (_e2011 - select(0i, 1i, (_e2004 < f32(_e2011))));
let _e2016 = (262147i + _e2015);
let _e2018 = select(_e1813, _e2016, (_e2016 < _e1813));
let _e2024 = global_3.member[bitcast<u32>(select(0i, _e2018, (_e2018 > 0i)))];
let _e2039 = ((_e1848 + (f32(bitcast<i32>((_e2024 >> bitcast<u32>(12u)))) * _e1857)) + ((f32((bitcast<i32>((_e2024 & 4095u)) - 2048i)) * _e1838) * (_e2000 - f32(_e2015))));
let _e2040 = (_e1787 * 1024f);
let _e2042 = select(0f, _e2040, (_e2040 > 0f));
let _e2044 = select(_e1795, _e2042, (_e2042 < _e1795));
let _e2051 = select(0i, select(select(i32(_e2044), i32(-2147483648), (_e2044 < -2147483600f)), 2147483647i, (_e2044 > 2147483500f)), (_e2044 == _e2044));
let _e2055 = (_e2051 - select(0i, 1i, (_e2044 < f32(_e2051))));
let _e2056 = (262147i + _e2055);
let _e2058 = select(_e1813, _e2056, (_e2056 < _e1813));
let _e2064 = global_3.member[bitcast<u32>(select(0i, _e2058, (_e2058 > 0i)))];
let _e2079 = ((_e1848 + (f32(bitcast<i32>((_e2064 >> bitcast<u32>(12u)))) * _e1857)) + ((f32((bitcast<i32>((_e2064 & 4095u)) - 2048i)) * _e1838) * (_e2040 - f32(_e2055))));
let _e2080 = (_e1793 * 1024f);
let _e2082 = select(0f, _e2080, (_e2080 > 0f));
let _e2084 = select(_e1795, _e2082, (_e2082 < _e1795));
let _e2091 = select(0i, select(select(i32(_e2084), i32(-2147483648), (_e2084 < -2147483600f)), 2147483647i, (_e2084 > 2147483500f)), (_e2084 == _e2084));
let _e2095 = (_e2091 - select(0i, 1i, (_e2084 < f32(_e2091))));
let _e2096 = (262147i + _e2095);
let _e2098 = select(_e1813, _e2096, (_e2096 < _e1813));
let _e2104 = global_3.member[bitcast<u32>(select(0i, _e2098, (_e2098 > 0i)))];
let _e2119 = ((_e1848 + (f32(bitcast<i32>((_e2104 >> bitcast<u32>(12u)))) * _e1857)) + ((f32((bitcast<i32>((_e2104 & 4095u)) - 2048i)) * _e1838) * (_e2080 - f32(_e2095))));
let _e2120 = (_e1959 - _e1919);
let _e2122 = (_e2039 - _e1999);
let _e2124 = (_e2119 - _e2079);
phi_3698_ = type_29(_e1863, vec3<f32>((0.5f * _e2120), (0.5f * _e2122), (0.5f * _e2124)), vec3<f32>((0.25f * (_e2120 * (_e1959 + _e1919))), (0.25f * (_e2122 * (_e2039 + _e1999))), (0.25f * (_e2124 * (_e2119 + _e2079)))));
}
let _e2139 = phi_3698_;
let _e2154 = select(0f, 1f, ((((((_e498 >= -0.5f) && (_e498 <= _e522)) && (_e504 >= -0.5f)) && (_e504 <= _e533)) && (_e510 >= -0.5f)) && (_e510 <= _e544)));
let _e2156 = (0.5f * (_e1769 - _e1763));
let _e2158 = (0.5f * (_e1781 - _e1775));
let _e2160 = (0.5f * (_e1793 - _e1787));
let _e2167 = global_5.member[_e352].member_6.member.member.member;
let _e2174 = global_5.member[_e352].member_6.member.member.member_1;
let _e2181 = global_5.member[_e352].member_6.member.member.member_2;
let _e2188 = global_5.member[_e352].member_6.member_1.member.member;
let _e2195 = global_5.member[_e352].member_6.member_1.member.member_1;
let _e2202 = global_5.member[_e352].member_6.member_1.member.member_2;
let _e2209 = global_5.member[_e352].member_6.member_2.member.member;
let _e2216 = global_5.member[_e352].member_6.member_2.member.member_1;
let _e2223 = global_5.member[_e352].member_6.member_2.member.member_2;
phi_4460_ = type_30(_e1757, vec3<f32>(((((_e2167 * _e2156) + (_e2188 * _e2158)) + (_e2209 * _e2160)) * _e2154), ((((_e2174 * _e2156) + (_e2195 * _e2158)) + (_e2216 * _e2160)) * _e2154), ((((_e2181 * _e2156) + (_e2202 * _e2158)) + (_e2223 * _e2160)) * _e2154)), _e2139.member, vec3<f32>(((((_e2167 * _e2139.member_2.x) + (_e2188 * _e2139.member_2.y)) + (_e2209 * _e2139.member_2.z)) * _e2154), ((((_e2174 * _e2139.member_2.x) + (_e2195 * _e2139.member_2.y)) + (_e2216 * _e2139.member_2.z)) * _e2154), ((((_e2181 * _e2139.member_2.x) + (_e2202 * _e2139.member_2.y)) + (_e2223 * _e2139.member_2.z)) * _e2154)), vec3<f32>(((((_e2167 * _e2139.member_1.x) + (_e2188 * _e2139.member_1.y)) + (_e2209 * _e2139.member_1.z)) * _e2154), ((((_e2174 * _e2139.member_1.x) + (_e2195 * _e2139.member_1.y)) + (_e2216 * _e2139.member_1.z)) * _e2154), ((((_e2181 * _e2139.member_1.x) + (_e2202 * _e2139.member_1.y)) + (_e2223 * _e2139.member_1.z)) * _e2154)));
} else {
let _e2289 = select(-1f, _e526, (_e526 > -1f));
let _e2291 = select(_e521, _e2289, (_e2289 < _e521));
let _e2298 = select(0i, select(select(i32(_e2291), i32(-2147483648), (_e2291 < -2147483600f)), 2147483647i, (_e2291 > 2147483500f)), (_e2291 == _e2291));
let _e2302 = (_e2298 - select(0i, 1i, (_e2291 < f32(_e2298))));
let _e2304 = select(-1f, _e537, (_e537 > -1f));
let _e2306 = select(_e532, _e2304, (_e2304 < _e532));
let _e2313 = select(0i, select(select(i32(_e2306), i32(-2147483648), (_e2306 < -2147483600f)), 2147483647i, (_e2306 > 2147483500f)), (_e2306 == _e2306));
let _e2317 = (_e2313 - select(0i, 1i, (_e2306 < f32(_e2313))));
let _e2319 = select(-1f, _e548, (_e548 > -1f));
let _e2321 = select(_e543, _e2319, (_e2319 < _e543));
let _e2328 = select(0i, select(select(i32(_e2321), i32(-2147483648), (_e2321 < -2147483600f)), 2147483647i, (_e2321 > 2147483500f)), (_e2321 == _e2321));
let _e2332 = (_e2328 - select(0i, 1i, (_e2321 < f32(_e2328))));
let _e2337 = global_5.member[_e352].member_6.member_7;
let _e2342 = global_5.member[_e352].member_6.member_8;
let _e2350 = (select(0i, select(select(i32(_e532), i32(-2147483648), (_e532 < -2147483600f)), 2147483647i, (_e532 > 2147483500f)), (_e532 == _e532)) - 1i);
let _e2353 = (_e2317 + 1i);
let _e2363 = (select(0i, select(select(i32(_e543), i32(-2147483648), (_e543 < -2147483600f)), 2147483647i, (_e543 > 2147483500f)), (_e543 == _e543)) - 1i);
let _e2366 = (_e2332 + 1i);
let _e2375 = select(0i, select(select(i32(_e521), i32(-2147483648), (_e521 < -2147483600f)), 2147483647i, (_e521 > 2147483500f)), (_e521 == _e521));
let _e2376 = (_e2375 - 1i);
let _e2377 = (_e2302 - 1i);
let _e2379 = select(0i, _e2377, (_e2377 > 0i));
let _e2382 = (_e2302 + 1i);
let _e2385 = (_e2302 + 2i);
let _e2388 = (_e2375 - 4i);
let _e2390 = select(0i, _e2388, (_e2388 > 0i));
let _e2392 = select(_e2390, _e2379, (_e2379 < _e2390));
let _e2405 = (select(0i, _e2317, (_e2317 > 0i)) * _e2337);
let _e2406 = (select(_e2350, _e2353, (_e2353 < _e2350)) * _e2337);
let _e2407 = (select(0i, _e2332, (_e2332 > 0i)) * _e2342);
let _e2408 = (select(_e2363, _e2366, (_e2366 < _e2363)) * _e2342);
local_4 = type_28(array<i32, 4>(_e2392, _e2392, _e2392, _e2392), array<u32, 6>(bitcast<u32>(((_e2379 - _e2392) * 8i)), bitcast<u32>(((select(0i, _e2302, (_e2302 > 0i)) - _e2392) * 8i)), bitcast<u32>(((select(_e2376, _e2382, (_e2382 < _e2376)) - _e2392) * 8i)), bitcast<u32>(((select(_e2376, _e2385, (_e2385 < _e2376)) - _e2392) * 8i)), 0u, 0u));
local_5 = vec3<f32>((_e526 - f32(_e2302)), (_e537 - f32(_e2317)), (_e548 - f32(_e2332)));
let _e2423 = local_4.member[0u];
let _e2424 = ((_e2407 + _e2405) + _e2423);
let _e2426 = (_e2424 >> bitcast<u32>(2i));
let _e2429 = bitcast<u32>(((_e2424 & 3i) * 8i));
let _e2431 = (bitcast<i32>(_e119) - 1i);
let _e2433 = select(_e2431, _e2426, (_e2426 < _e2431));
let _e2438 = global_1.member[bitcast<u32>(select(0i, _e2433, (_e2433 > 0i)))];
let _e2442 = (_e2426 + 1i);
let _e2444 = select(_e2431, _e2442, (_e2442 < _e2431));
let _e2449 = global_1.member[bitcast<u32>(select(0i, _e2444, (_e2444 > 0i)))];
let _e2456 = ((_e2438 >> bitcast<u32>((_e2429 & 31u))) | ((_e2449 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2429) & 31u))));
let _e2459 = local_4.member_1[1u];
let _e2465 = f32(bitcast<i32>(((_e2456 >> bitcast<u32>((_e2459 & 31u))) & 255u)));
let _e2468 = local_4.member_1[2u];
let _e2475 = local_5[0u];
let _e2478 = (_e2465 + ((f32(bitcast<i32>(((_e2456 >> bitcast<u32>((_e2468 & 31u))) & 255u))) - _e2465) * _e2475));
let _e2480 = local_4.member[0u];
let _e2481 = ((_e2407 + _e2406) + _e2480);
let _e2483 = (_e2481 >> bitcast<u32>(2i));
let _e2486 = bitcast<u32>(((_e2481 & 3i) * 8i));
let _e2488 = select(_e2431, _e2483, (_e2483 < _e2431));
let _e2493 = global_1.member[bitcast<u32>(select(0i, _e2488, (_e2488 > 0i)))];
let _e2497 = (_e2483 + 1i);
let _e2499 = select(_e2431, _e2497, (_e2497 < _e2431));
let _e2504 = global_1.member[bitcast<u32>(select(0i, _e2499, (_e2499 > 0i)))];
let _e2511 = ((_e2493 >> bitcast<u32>((_e2486 & 31u))) | ((_e2504 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2486) & 31u))));
let _e2512 = local_4.member_1[1u];
let _e2518 = f32(bitcast<i32>(((_e2511 >> bitcast<u32>((_e2512 & 31u))) & 255u)));
let _e2519 = local_4.member_1[2u];
let _e2526 = local_5[0u];
let _e2531 = local_5[1u];
let _e2534 = (_e2478 + (((_e2518 + ((f32(bitcast<i32>(((_e2511 >> bitcast<u32>((_e2519 & 31u))) & 255u))) - _e2518) * _e2526)) - _e2478) * _e2531));
let _e2536 = local_4.member[0u];
let _e2537 = ((_e2408 + _e2405) + _e2536);
let _e2539 = (_e2537 >> bitcast<u32>(2i));
let _e2542 = bitcast<u32>(((_e2537 & 3i) * 8i));
let _e2544 = select(_e2431, _e2539, (_e2539 < _e2431));
let _e2549 = global_1.member[bitcast<u32>(select(0i, _e2544, (_e2544 > 0i)))];
let _e2553 = (_e2539 + 1i);
let _e2555 = select(_e2431, _e2553, (_e2553 < _e2431));
let _e2560 = global_1.member[bitcast<u32>(select(0i, _e2555, (_e2555 > 0i)))];
let _e2567 = ((_e2549 >> bitcast<u32>((_e2542 & 31u))) | ((_e2560 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2542) & 31u))));
let _e2568 = local_4.member_1[1u];
let _e2574 = f32(bitcast<i32>(((_e2567 >> bitcast<u32>((_e2568 & 31u))) & 255u)));
let _e2575 = local_4.member_1[2u];
let _e2582 = local_5[0u];
let _e2585 = (_e2574 + ((f32(bitcast<i32>(((_e2567 >> bitcast<u32>((_e2575 & 31u))) & 255u))) - _e2574) * _e2582));
let _e2587 = local_4.member[0u];
let _e2588 = ((_e2408 + _e2406) + _e2587);
let _e2590 = (_e2588 >> bitcast<u32>(2i));
let _e2593 = bitcast<u32>(((_e2588 & 3i) * 8i));
let _e2595 = select(_e2431, _e2590, (_e2590 < _e2431));
let _e2600 = global_1.member[bitcast<u32>(select(0i, _e2595, (_e2595 > 0i)))];
let _e2604 = (_e2590 + 1i);
let _e2606 = select(_e2431, _e2604, (_e2604 < _e2431));
let _e2611 = global_1.member[bitcast<u32>(select(0i, _e2606, (_e2606 > 0i)))];
let _e2618 = ((_e2600 >> bitcast<u32>((_e2593 & 31u))) | ((_e2611 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2593) & 31u))));
let _e2619 = local_4.member_1[1u];
let _e2625 = f32(bitcast<i32>(((_e2618 >> bitcast<u32>((_e2619 & 31u))) & 255u)));
let _e2626 = local_4.member_1[2u];
let _e2633 = local_5[0u];
let _e2637 = local_5[1u];
let _e2642 = local_5[2u];
let _e2650 = global_5.member[_e352].member_6.member_5;
let _e2656 = global_5.member[_e352].member_6.member_6;
let _e2657 = (((_e2534 + (((_e2585 + (((_e2625 + ((f32(bitcast<i32>(((_e2618 >> bitcast<u32>((_e2626 & 31u))) & 255u))) - _e2625) * _e2633)) - _e2585) * _e2637)) - _e2534) * _e2642)) * _e2650) + _e2656);
let _e2659 = select(0f, _e2657, (_e2657 > 0f));
phi_4460_ = type_30(select(1f, _e2659, (_e2659 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2664 = phi_4460_;
let _e2666 = select(-0.5f, _e460, (_e460 > -0.5f));
let _e2668 = select(_e522, _e2666, (_e2666 < _e522));
let _e2670 = select(-0.5f, _e476, (_e476 > -0.5f));
let _e2672 = select(_e533, _e2670, (_e2670 < _e533));
let _e2674 = select(-0.5f, _e492, (_e492 > -0.5f));
let _e2676 = select(_e544, _e2674, (_e2674 < _e544));
let _e2678 = select(-1f, _e2668, (_e2668 > -1f));
let _e2680 = select(_e521, _e2678, (_e2678 < _e521));
let _e2687 = select(0i, select(select(i32(_e2680), i32(-2147483648), (_e2680 < -2147483600f)), 2147483647i, (_e2680 > 2147483500f)), (_e2680 == _e2680));
let _e2691 = (_e2687 - select(0i, 1i, (_e2680 < f32(_e2687))));
let _e2693 = select(-1f, _e2672, (_e2672 > -1f));
let _e2695 = select(_e532, _e2693, (_e2693 < _e532));
let _e2702 = select(0i, select(select(i32(_e2695), i32(-2147483648), (_e2695 < -2147483600f)), 2147483647i, (_e2695 > 2147483500f)), (_e2695 == _e2695));
let _e2706 = (_e2702 - select(0i, 1i, (_e2695 < f32(_e2702))));
let _e2708 = select(-1f, _e2676, (_e2676 > -1f));
let _e2710 = select(_e543, _e2708, (_e2708 < _e543));
let _e2717 = select(0i, select(select(i32(_e2710), i32(-2147483648), (_e2710 < -2147483600f)), 2147483647i, (_e2710 > 2147483500f)), (_e2710 == _e2710));
let _e2721 = (_e2717 - select(0i, 1i, (_e2710 < f32(_e2717))));
let _e2726 = global_5.member[_e352].member_6.member_7;
let _e2731 = global_5.member[_e352].member_6.member_8;
let _e2739 = (select(0i, select(select(i32(_e532), i32(-2147483648), (_e532 < -2147483600f)), 2147483647i, (_e532 > 2147483500f)), (_e532 == _e532)) - 1i);
let _e2742 = (_e2706 + 1i);
let _e2752 = (select(0i, select(select(i32(_e543), i32(-2147483648), (_e543 < -2147483600f)), 2147483647i, (_e543 > 2147483500f)), (_e543 == _e543)) - 1i);
let _e2755 = (_e2721 + 1i);
let _e2764 = select(0i, select(select(i32(_e521), i32(-2147483648), (_e521 < -2147483600f)), 2147483647i, (_e521 > 2147483500f)), (_e521 == _e521));
let _e2765 = (_e2764 - 1i);
let _e2766 = (_e2691 - 1i);
let _e2768 = select(0i, _e2766, (_e2766 > 0i));
let _e2771 = (_e2691 + 1i);
let _e2774 = (_e2691 + 2i);
let _e2777 = (_e2764 - 4i);
let _e2779 = select(0i, _e2777, (_e2777 > 0i));
let _e2781 = select(_e2779, _e2768, (_e2768 < _e2779));
let _e2794 = (select(0i, _e2706, (_e2706 > 0i)) * _e2726);
let _e2795 = (select(_e2739, _e2742, (_e2742 < _e2739)) * _e2726);
let _e2796 = (select(0i, _e2721, (_e2721 > 0i)) * _e2731);
let _e2797 = (select(_e2752, _e2755, (_e2755 < _e2752)) * _e2731);
local_2 = type_28(array<i32, 4>(_e2781, _e2781, _e2781, _e2781), array<u32, 6>(bitcast<u32>(((_e2768 - _e2781) * 8i)), bitcast<u32>(((select(0i, _e2691, (_e2691 > 0i)) - _e2781) * 8i)), bitcast<u32>(((select(_e2765, _e2771, (_e2771 < _e2765)) - _e2781) * 8i)), bitcast<u32>(((select(_e2765, _e2774, (_e2774 < _e2765)) - _e2781) * 8i)), 0u, 0u));
local_3 = vec3<f32>((_e2668 - f32(_e2691)), (_e2672 - f32(_e2706)), (_e2676 - f32(_e2721)));
let _e2812 = local_2.member[0u];
let _e2813 = ((_e2796 + _e2794) + _e2812);
let _e2815 = (_e2813 >> bitcast<u32>(2i));
let _e2818 = bitcast<u32>(((_e2813 & 3i) * 8i));
let _e2820 = (bitcast<i32>(_e119) - 1i);
let _e2822 = select(_e2820, _e2815, (_e2815 < _e2820));
let _e2827 = global_1.member[bitcast<u32>(select(0i, _e2822, (_e2822 > 0i)))];
let _e2831 = (_e2815 + 1i);
let _e2833 = select(_e2820, _e2831, (_e2831 < _e2820));
let _e2838 = global_1.member[bitcast<u32>(select(0i, _e2833, (_e2833 > 0i)))];
let _e2845 = ((_e2827 >> bitcast<u32>((_e2818 & 31u))) | ((_e2838 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2818) & 31u))));
let _e2848 = local_2.member_1[1u];
let _e2854 = f32(bitcast<i32>(((_e2845 >> bitcast<u32>((_e2848 & 31u))) & 255u)));
let _e2857 = local_2.member_1[2u];
let _e2864 = local_3[0u];
let _e2867 = (_e2854 + ((f32(bitcast<i32>(((_e2845 >> bitcast<u32>((_e2857 & 31u))) & 255u))) - _e2854) * _e2864));
let _e2869 = local_2.member[0u];
let _e2870 = ((_e2796 + _e2795) + _e2869);
let _e2872 = (_e2870 >> bitcast<u32>(2i));
let _e2875 = bitcast<u32>(((_e2870 & 3i) * 8i));
let _e2877 = select(_e2820, _e2872, (_e2872 < _e2820));
let _e2882 = global_1.member[bitcast<u32>(select(0i, _e2877, (_e2877 > 0i)))];
let _e2886 = (_e2872 + 1i);
let _e2888 = select(_e2820, _e2886, (_e2886 < _e2820));
let _e2893 = global_1.member[bitcast<u32>(select(0i, _e2888, (_e2888 > 0i)))];
let _e2900 = ((_e2882 >> bitcast<u32>((_e2875 & 31u))) | ((_e2893 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2875) & 31u))));
let _e2901 = local_2.member_1[1u];
let _e2907 = f32(bitcast<i32>(((_e2900 >> bitcast<u32>((_e2901 & 31u))) & 255u)));
let _e2908 = local_2.member_1[2u];
let _e2915 = local_3[0u];
let _e2920 = local_3[1u];
let _e2923 = (_e2867 + (((_e2907 + ((f32(bitcast<i32>(((_e2900 >> bitcast<u32>((_e2908 & 31u))) & 255u))) - _e2907) * _e2915)) - _e2867) * _e2920));
let _e2925 = local_2.member[0u];
let _e2926 = ((_e2797 + _e2794) + _e2925);
let _e2928 = (_e2926 >> bitcast<u32>(2i));
let _e2931 = bitcast<u32>(((_e2926 & 3i) * 8i));
let _e2933 = select(_e2820, _e2928, (_e2928 < _e2820));
let _e2938 = global_1.member[bitcast<u32>(select(0i, _e2933, (_e2933 > 0i)))];
let _e2942 = (_e2928 + 1i);
let _e2944 = select(_e2820, _e2942, (_e2942 < _e2820));
let _e2949 = global_1.member[bitcast<u32>(select(0i, _e2944, (_e2944 > 0i)))];
let _e2956 = ((_e2938 >> bitcast<u32>((_e2931 & 31u))) | ((_e2949 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2931) & 31u))));
let _e2957 = local_2.member_1[1u];
let _e2963 = f32(bitcast<i32>(((_e2956 >> bitcast<u32>((_e2957 & 31u))) & 255u)));
let _e2964 = local_2.member_1[2u];
let _e2971 = local_3[0u];
let _e2974 = (_e2963 + ((f32(bitcast<i32>(((_e2956 >> bitcast<u32>((_e2964 & 31u))) & 255u))) - _e2963) * _e2971));
let _e2976 = local_2.member[0u];
let _e2977 = ((_e2797 + _e2795) + _e2976);
let _e2979 = (_e2977 >> bitcast<u32>(2i));
let _e2982 = bitcast<u32>(((_e2977 & 3i) * 8i));
let _e2984 = select(_e2820, _e2979, (_e2979 < _e2820));
let _e2989 = global_1.member[bitcast<u32>(select(0i, _e2984, (_e2984 > 0i)))];
let _e2993 = (_e2979 + 1i);
let _e2995 = select(_e2820, _e2993, (_e2993 < _e2820));
let _e3000 = global_1.member[bitcast<u32>(select(0i, _e2995, (_e2995 > 0i)))];
let _e3007 = ((_e2989 >> bitcast<u32>((_e2982 & 31u))) | ((_e3000 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2982) & 31u))));
let _e3008 = local_2.member_1[1u];
let _e3014 = f32(bitcast<i32>(((_e3007 >> bitcast<u32>((_e3008 & 31u))) & 255u)));
let _e3015 = local_2.member_1[2u];
let _e3022 = local_3[0u];
let _e3026 = local_3[1u];
let _e3031 = local_3[2u];
let _e3039 = global_5.member[_e352].member_6.member_5;
let _e3045 = global_5.member[_e352].member_6.member_6;
let _e3046 = (((_e2923 + (((_e2974 + (((_e3014 + ((f32(bitcast<i32>(((_e3007 >> bitcast<u32>((_e3015 & 31u))) & 255u))) - _e3014) * _e3022)) - _e2974) * _e3026)) - _e2923) * _e3031)) * _e3039) + _e3045);
let _e3048 = select(0f, _e3046, (_e3046 > 0f));
let _e3050 = select(1f, _e3048, (_e3048 < 1f));
let _e3051 = select(_e356[6], _e3050, _e719);
if _e803 {
let _e3052 = (_e3050 * 1024f);
let _e3053 = (1024f - 1f);
let _e3055 = select(0f, _e3052, (_e3052 > 0f));
let _e3057 = select(_e3053, _e3055, (_e3055 < _e3053));
let _e3064 = select(0i, select(select(i32(_e3057), i32(-2147483648), (_e3057 < -2147483600f)), 2147483647i, (_e3057 > 2147483500f)), (_e3057 == _e3057));
let _e3068 = (_e3064 - select(0i, 1i, (_e3057 < f32(_e3064))));
let _e3069 = (262147i + _e3068);
let _e3071 = (bitcast<i32>(_e123) - 1i);
let _e3073 = select(_e3071, _e3069, (_e3069 < _e3071));
let _e3079 = global_3.member[bitcast<u32>(select(0i, _e3073, (_e3073 > 0i)))];
let _e3089 = select(_e3071, 262146i, (262146i < _e3071));
let _e3095 = global_3.member[bitcast<u32>(select(0i, _e3089, (_e3089 > 0i)))];
let _e3099 = select(_e3071, 262144i, (262144i < _e3071));
let _e3105 = global_3.member[bitcast<u32>(select(0i, _e3099, (_e3099 > 0i)))];
let _e3108 = select(_e3071, 262145i, (262145i < _e3071));
let _e3114 = global_3.member[bitcast<u32>(select(0i, _e3108, (_e3108 > 0i)))];
phi_5159_ = select(_e356[16], ((bitcast<f32>(_e3105) + (f32(bitcast<i32>((_e3079 >> bitcast<u32>(12u)))) * bitcast<f32>(_e3114))) + ((f32((bitcast<i32>((_e3079 & 4095u)) - 2048i)) * bitcast<f32>(_e3095)) * (_e3052 - f32(_e3068)))), _e719);
} else {
phi_5159_ = _e356[16];
}
let _e3124 = phi_5159_;
let _e3127 = select(1f, select(1f, _e798, (_e798 < 1f)), _e444);
if ((_e687 & 16u) == 0u) {
phi_5548_ = type_5(1f, 1f, 1f);
} else {
let _e3134 = global_5.member[_e352].member_14.member;
let _e3145 = ((((_e3134.member.member * _e380) + (_e3134.member.member_1 * _e382)) + (_e3134.member.member_2 * _e376)) + _e3134.member_1);
let _e3151 = ((((_e3134.member.member * _e384) + (_e3134.member.member_1 * _e386)) + (_e3134.member.member_2 * _e391)) + _e3134.member_1);
let _e3153 = select(_e3151, _e3145, (_e3145 < _e3151));
let _e3155 = select(_e3151, _e3145, (_e3145 > _e3151));
let _e3157 = (_e3155 - _e3153);
let _e3160 = (-(_e3153) / select(1e-30f, _e3157, (_e3157 > 1e-30f)));
let _e3162 = select(0f, _e3160, (_e3160 > 0f));
let _e3168 = select(select(select(1f, _e3162, (_e3162 < 1f)), 1f, (_e3155 <= 0f)), 0f, (_e3153 > 0f));
let _e3174 = global_5.member[_e352].member_14.member_1;
let _e3175 = (_e3174 != 0u);
let _e3186 = global_5.member[_e352].member_15.member;
let _e3197 = ((((_e3186.member.member * _e380) + (_e3186.member.member_1 * _e382)) + (_e3186.member.member_2 * _e376)) + _e3186.member_1);
let _e3203 = ((((_e3186.member.member * _e384) + (_e3186.member.member_1 * _e386)) + (_e3186.member.member_2 * _e391)) + _e3186.member_1);
let _e3205 = select(_e3203, _e3197, (_e3197 < _e3203));
let _e3207 = select(_e3203, _e3197, (_e3197 > _e3203));
let _e3209 = (_e3207 - _e3205);
let _e3212 = (-(_e3205) / select(1e-30f, _e3209, (_e3209 > 1e-30f)));
let _e3214 = select(0f, _e3212, (_e3212 > 0f));
let _e3220 = select(select(select(1f, _e3214, (_e3214 < 1f)), 1f, (_e3207 <= 0f)), 0f, (_e3205 > 0f));
let _e3226 = global_5.member[_e352].member_15.member_1;
let _e3227 = (_e3226 != 0u);
let _e3238 = global_5.member[_e352].member_16.member;
let _e3249 = ((((_e3238.member.member * _e380) + (_e3238.member.member_1 * _e382)) + (_e3238.member.member_2 * _e376)) + _e3238.member_1);
let _e3255 = ((((_e3238.member.member * _e384) + (_e3238.member.member_1 * _e386)) + (_e3238.member.member_2 * _e391)) + _e3238.member_1);
let _e3257 = select(_e3255, _e3249, (_e3249 < _e3255));
let _e3259 = select(_e3255, _e3249, (_e3249 > _e3255));
let _e3261 = (_e3259 - _e3257);
let _e3264 = (-(_e3257) / select(1e-30f, _e3261, (_e3261 > 1e-30f)));
let _e3266 = select(0f, _e3264, (_e3264 > 0f));
let _e3272 = select(select(select(1f, _e3266, (_e3266 < 1f)), 1f, (_e3259 <= 0f)), 0f, (_e3257 > 0f));
let _e3278 = global_5.member[_e352].member_16.member_1;
let _e3279 = (_e3278 != 0u);
let _e3290 = global_5.member[_e352].member_17.member;
let _e3301 = ((((_e3290.member.member * _e380) + (_e3290.member.member_1 * _e382)) + (_e3290.member.member_2 * _e376)) + _e3290.member_1);
let _e3307 = ((((_e3290.member.member * _e384) + (_e3290.member.member_1 * _e386)) + (_e3290.member.member_2 * _e391)) + _e3290.member_1);
let _e3309 = select(_e3307, _e3301, (_e3301 < _e3307));
let _e3311 = select(_e3307, _e3301, (_e3301 > _e3307));
let _e3313 = (_e3311 - _e3309);
let _e3316 = (-(_e3309) / select(1e-30f, _e3313, (_e3313 > 1e-30f)));
let _e3318 = select(0f, _e3316, (_e3316 > 0f));
let _e3324 = select(select(select(1f, _e3318, (_e3318 < 1f)), 1f, (_e3311 <= 0f)), 0f, (_e3309 > 0f));
let _e3330 = global_5.member[_e352].member_17.member_1;
let _e3331 = (_e3330 != 0u);
phi_5548_ = type_5(((((1f * _e3168) * _e3220) * _e3272) * _e3324), ((((1f * select(1f, _e3168, _e3175)) * select(1f, _e3220, _e3227)) * select(1f, _e3272, _e3279)) * select(1f, _e3324, _e3331)), ((((1f * select(1f, 0f, (_e3175 && (_e3151 > 0f)))) * select(1f, 0f, (_e3227 && (_e3203 > 0f)))) * select(1f, 0f, (_e3279 && (_e3255 > 0f)))) * select(1f, 0f, (_e3331 && (_e3307 > 0f)))));
}
let _e3340 = phi_5548_;
let _e3341 = (_e554 < 1e-12f);
let _e3343 = (1f / select(_e549, 1f, _e3341));
let _e3345 = ((-0.5f - _e460) * _e3343);
let _e3347 = ((_e522 - _e460) * _e3343);
let _e3353 = select(_e3347, _e3345, (_e3345 < _e3347));
let _e3355 = select(0f, _e3353, (_e3353 > 0f));
let _e3358 = select(select(1f, _e3355, (_e3355 < 1f)), select(2f, 0f, ((_e460 >= -0.5f) && (_e460 <= _e522))), _e3341);
let _e3360 = select(_e3347, _e3345, (_e3345 > _e3347));
let _e3362 = select(0f, _e3360, (_e3360 > 0f));
let _e3365 = select(select(1f, _e3362, (_e3362 < 1f)), 1f, _e3341);
let _e3366 = (_e557 < 1e-12f);
let _e3368 = (1f / select(_e550, 1f, _e3366));
let _e3370 = ((-0.5f - _e476) * _e3368);
let _e3372 = ((_e533 - _e476) * _e3368);
let _e3378 = select(_e3372, _e3370, (_e3370 < _e3372));
let _e3380 = select(0f, _e3378, (_e3378 > 0f));
let _e3383 = select(select(1f, _e3380, (_e3380 < 1f)), select(2f, 0f, ((_e476 >= -0.5f) && (_e476 <= _e533))), _e3366);
let _e3385 = select(_e3372, _e3370, (_e3370 > _e3372));
let _e3387 = select(0f, _e3385, (_e3385 > 0f));
let _e3390 = select(select(1f, _e3387, (_e3387 < 1f)), 1f, _e3366);
let _e3391 = (_e562 < 1e-12f);
let _e3393 = (1f / select(_e551, 1f, _e3391));
let _e3395 = ((-0.5f - _e492) * _e3393);
let _e3397 = ((_e544 - _e492) * _e3393);
let _e3403 = select(_e3397, _e3395, (_e3395 < _e3397));
let _e3405 = select(0f, _e3403, (_e3403 > 0f));
let _e3408 = select(select(1f, _e3405, (_e3405 < 1f)), select(2f, 0f, ((_e492 >= -0.5f) && (_e492 <= _e544))), _e3391);
let _e3410 = select(_e3397, _e3395, (_e3395 > _e3397));
let _e3412 = select(0f, _e3410, (_e3410 > 0f));
let _e3415 = select(select(1f, _e3412, (_e3412 < 1f)), 1f, _e3391);
let _e3417 = select(_e3390, _e3365, (_e3365 < _e3390));
let _e3421 = select(_e3383, _e3358, (_e3358 > _e3383));
let _e3424 = (select(_e3415, _e3417, (_e3417 < _e3415)) - select(_e3408, _e3421, (_e3421 > _e3408)));
let _e3427 = (_e384 - _e380);
let _e3428 = (_e386 - _e382);
let _e3429 = (_e391 - _e376);
let _e3434 = (((_e3427 * _e3427) + (_e3428 * _e3428)) + (_e3429 * _e3429));
let _e3444 = global_5.member[_e352].member_5.member_3;
let _e3445 = (((sqrt(select(0f, _e3434, (_e3434 > 0f))) * select(0f, _e3424, (_e3424 > 0f))) * _e3127) * _e3444);
let _e3446 = (_e729.member_2 >= 3u);
if _e3446 {
let _e3448 = (_e3051 * 255f);
let _e3449 = (_e2664.member * 255f);
let _e3450 = (255f - 1f);
let _e3452 = select(0f, _e3448, (_e3448 > 0f));
let _e3454 = select(_e3450, _e3452, (_e3452 < _e3450));
let _e3461 = select(0i, select(select(i32(_e3454), i32(-2147483648), (_e3454 < -2147483600f)), 2147483647i, (_e3454 > 2147483500f)), (_e3454 == _e3454));
let _e3465 = (_e3461 - select(0i, 1i, (_e3454 < f32(_e3461))));
let _e3467 = select(0f, _e3449, (_e3449 > 0f));
let _e3469 = select(_e3450, _e3467, (_e3467 < _e3450));
let _e3476 = select(0i, select(select(i32(_e3469), i32(-2147483648), (_e3469 < -2147483600f)), 2147483647i, (_e3469 > 2147483500f)), (_e3469 == _e3469));
let _e3480 = (_e3476 - select(0i, 1i, (_e3469 < f32(_e3476))));
let _e3483 = (((_e3465 * 256i) + _e3480) * 4i);
let _e3485 = (_e3448 - f32(_e3465));
let _e3487 = (_e3449 - f32(_e3480));
let _e3488 = (_e3483 + 2i);
let _e3490 = (bitcast<i32>(_e123) - 1i);
let _e3492 = select(_e3490, _e3488, (_e3488 < _e3490));
let _e3498 = global_3.member[bitcast<u32>(select(0i, _e3492, (_e3492 > 0i)))];
let _e3499 = (_e3483 + 6i);
let _e3501 = select(_e3490, _e3499, (_e3499 < _e3490));
let _e3507 = global_3.member[bitcast<u32>(select(0i, _e3501, (_e3501 > 0i)))];
let _e3508 = (_e3483 + 1026i);
let _e3510 = select(_e3490, _e3508, (_e3508 < _e3490));
let _e3516 = global_3.member[bitcast<u32>(select(0i, _e3510, (_e3510 > 0i)))];
let _e3517 = (_e3483 + 1030i);
let _e3519 = select(_e3490, _e3517, (_e3517 < _e3490));
let _e3525 = global_3.member[bitcast<u32>(select(0i, _e3519, (_e3519 > 0i)))];
let _e3530 = (bitcast<f32>(((_e3498 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3538 = (_e3530 + (((bitcast<f32>(((_e3507 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3530) * _e3487));
let _e3543 = (bitcast<f32>(((_e3516 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3567 = (bitcast<f32>((((_e3498 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3575 = (_e3567 + (((bitcast<f32>((((_e3507 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3567) * _e3487));
let _e3580 = (bitcast<f32>((((_e3516 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3592 = (_e3483 + 3i);
let _e3594 = select(_e3490, _e3592, (_e3592 < _e3490));
let _e3600 = global_3.member[bitcast<u32>(select(0i, _e3594, (_e3594 > 0i)))];
let _e3601 = (_e3483 + 7i);
let _e3603 = select(_e3490, _e3601, (_e3601 < _e3490));
let _e3609 = global_3.member[bitcast<u32>(select(0i, _e3603, (_e3603 > 0i)))];
let _e3610 = (_e3483 + 1027i);
let _e3612 = select(_e3490, _e3610, (_e3610 < _e3490));
let _e3618 = global_3.member[bitcast<u32>(select(0i, _e3612, (_e3612 > 0i)))];
let _e3619 = (_e3483 + 1031i);
let _e3621 = select(_e3490, _e3619, (_e3619 < _e3490));
let _e3627 = global_3.member[bitcast<u32>(select(0i, _e3621, (_e3621 > 0i)))];
let _e3632 = (bitcast<f32>(((_e3600 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3640 = (_e3632 + (((bitcast<f32>(((_e3609 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3632) * _e3487));
let _e3645 = (bitcast<f32>(((_e3618 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3669 = (bitcast<f32>((((_e3600 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3677 = (_e3669 + (((bitcast<f32>((((_e3609 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3669) * _e3487));
let _e3682 = (bitcast<f32>((((_e3618 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3693 = (_e3677 + (((_e3682 + (((bitcast<f32>((((_e3627 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3682) * _e3487)) - _e3677) * _e3485));
let _e3697 = -((_e3693 * (_e3445 * _e3340.member)));
let _e3699 = select(-87f, _e3697, (_e3697 > -87f));
let _e3701 = select(88f, _e3699, (_e3699 < 88f));
let _e3703 = ((_e3701 * 1.442695f) + 0.5f);
let _e3705 = select(-127f, _e3703, (_e3703 > -127f));
let _e3707 = select(128f, _e3705, (_e3705 < 128f));
let _e3714 = select(0i, select(select(i32(_e3707), i32(-2147483648), (_e3707 < -2147483600f)), 2147483647i, (_e3707 > 2147483500f)), (_e3707 == _e3707));
let _e3718 = (_e3714 - select(0i, 1i, (_e3707 < f32(_e3714))));
let _e3719 = f32(_e3718);
let _e3723 = ((_e3701 - (_e3719 * 0.6933594f)) - (_e3719 * -2.1219444e-4f));
let _e3743 = ((1f + (_e3723 * (1f + (_e3723 * (0.5f + (_e3723 * (0.16666667f + (_e3723 * (0.041666668f + (_e3723 * (0.008333334f + (_e3723 * (0.001388889f + (_e3723 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3718 + 127i)) << bitcast<u32>(23i))));
let _e3744 = (1f - _e3743);
let _e3747 = (_e3744 / select(1e-12f, _e3693, (_e3693 > 1e-12f)));
phi_7106_ = type_31(_e3743, _e3744, vec3<f32>(1f, 1f, 1f), vec3<f32>(((_e3538 + (((_e3543 + (((bitcast<f32>(((_e3525 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3543) * _e3487)) - _e3538) * _e3485)) * _e3747), ((_e3575 + (((_e3580 + (((bitcast<f32>((((_e3525 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3580) * _e3487)) - _e3575) * _e3485)) * _e3747), ((_e3640 + (((_e3645 + (((bitcast<f32>(((_e3627 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3645) * _e3487)) - _e3640) * _e3485)) * _e3747)));
} else {
let _e3754 = (_e3051 * 255f);
let _e3755 = (_e2664.member * 255f);
let _e3756 = (255f - 1f);
let _e3758 = select(0f, _e3754, (_e3754 > 0f));
let _e3760 = select(_e3756, _e3758, (_e3758 < _e3756));
let _e3767 = select(0i, select(select(i32(_e3760), i32(-2147483648), (_e3760 < -2147483600f)), 2147483647i, (_e3760 > 2147483500f)), (_e3760 == _e3760));
let _e3771 = (_e3767 - select(0i, 1i, (_e3760 < f32(_e3767))));
let _e3773 = select(0f, _e3755, (_e3755 > 0f));
let _e3775 = select(_e3756, _e3773, (_e3773 < _e3756));
let _e3782 = select(0i, select(select(i32(_e3775), i32(-2147483648), (_e3775 < -2147483600f)), 2147483647i, (_e3775 > 2147483500f)), (_e3775 == _e3775));
let _e3786 = (_e3782 - select(0i, 1i, (_e3775 < f32(_e3782))));
let _e3789 = (((_e3771 * 256i) + _e3786) * 4i);
let _e3791 = (_e3754 - f32(_e3771));
let _e3793 = (_e3755 - f32(_e3786));
let _e3795 = (bitcast<i32>(_e123) - 1i);
let _e3797 = select(_e3795, _e3789, (_e3789 < _e3795));
let _e3803 = global_3.member[bitcast<u32>(select(0i, _e3797, (_e3797 > 0i)))];
let _e3804 = (_e3789 + 4i);
let _e3806 = select(_e3795, _e3804, (_e3804 < _e3795));
let _e3812 = global_3.member[bitcast<u32>(select(0i, _e3806, (_e3806 > 0i)))];
let _e3813 = (_e3789 + 1024i);
let _e3815 = select(_e3795, _e3813, (_e3813 < _e3795));
let _e3821 = global_3.member[bitcast<u32>(select(0i, _e3815, (_e3815 > 0i)))];
let _e3822 = (_e3789 + 1028i);
let _e3824 = select(_e3795, _e3822, (_e3822 < _e3795));
let _e3830 = global_3.member[bitcast<u32>(select(0i, _e3824, (_e3824 > 0i)))];
let _e3835 = (bitcast<f32>(((_e3803 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3843 = (_e3835 + (((bitcast<f32>(((_e3812 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3835) * _e3793));
let _e3848 = (bitcast<f32>(((_e3821 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3859 = (_e3843 + (((_e3848 + (((bitcast<f32>(((_e3830 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3848) * _e3793)) - _e3843) * _e3791));
let _e3872 = (bitcast<f32>((((_e3803 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3880 = (_e3872 + (((bitcast<f32>((((_e3812 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3872) * _e3793));
let _e3885 = (bitcast<f32>((((_e3821 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3897 = (_e3789 + 1i);
let _e3899 = select(_e3795, _e3897, (_e3897 < _e3795));
let _e3905 = global_3.member[bitcast<u32>(select(0i, _e3899, (_e3899 > 0i)))];
let _e3906 = (_e3789 + 5i);
let _e3908 = select(_e3795, _e3906, (_e3906 < _e3795));
let _e3914 = global_3.member[bitcast<u32>(select(0i, _e3908, (_e3908 > 0i)))];
let _e3915 = (_e3789 + 1025i);
let _e3917 = select(_e3795, _e3915, (_e3915 < _e3795));
let _e3923 = global_3.member[bitcast<u32>(select(0i, _e3917, (_e3917 > 0i)))];
let _e3924 = (_e3789 + 1029i);
let _e3926 = select(_e3795, _e3924, (_e3924 < _e3795));
let _e3932 = global_3.member[bitcast<u32>(select(0i, _e3926, (_e3926 > 0i)))];
let _e3937 = (bitcast<f32>(((_e3905 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3945 = (_e3937 + (((bitcast<f32>(((_e3914 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3937) * _e3793));
let _e3950 = (bitcast<f32>(((_e3923 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3974 = (bitcast<f32>((((_e3905 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3982 = (_e3974 + (((bitcast<f32>((((_e3914 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3974) * _e3793));
let _e3987 = (bitcast<f32>((((_e3923 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3999 = (_e3789 + 2i);
let _e4001 = select(_e3795, _e3999, (_e3999 < _e3795));
let _e4007 = global_3.member[bitcast<u32>(select(0i, _e4001, (_e4001 > 0i)))];
let _e4008 = (_e3789 + 6i);
let _e4010 = select(_e3795, _e4008, (_e4008 < _e3795));
let _e4016 = global_3.member[bitcast<u32>(select(0i, _e4010, (_e4010 > 0i)))];
let _e4017 = (_e3789 + 1026i);
let _e4019 = select(_e3795, _e4017, (_e4017 < _e3795));
let _e4025 = global_3.member[bitcast<u32>(select(0i, _e4019, (_e4019 > 0i)))];
let _e4026 = (_e3789 + 1030i);
let _e4028 = select(_e3795, _e4026, (_e4026 < _e3795));
let _e4034 = global_3.member[bitcast<u32>(select(0i, _e4028, (_e4028 > 0i)))];
let _e4039 = (bitcast<f32>(((_e4007 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4047 = (_e4039 + (((bitcast<f32>(((_e4016 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4039) * _e3793));
let _e4052 = (bitcast<f32>(((_e4025 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4076 = (bitcast<f32>((((_e4007 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4084 = (_e4076 + (((bitcast<f32>((((_e4016 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4076) * _e3793));
let _e4089 = (bitcast<f32>((((_e4025 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4101 = (_e3789 + 3i);
let _e4103 = select(_e3795, _e4101, (_e4101 < _e3795));
let _e4109 = global_3.member[bitcast<u32>(select(0i, _e4103, (_e4103 > 0i)))];
let _e4110 = (_e3789 + 7i);
let _e4112 = select(_e3795, _e4110, (_e4110 < _e3795));
let _e4118 = global_3.member[bitcast<u32>(select(0i, _e4112, (_e4112 > 0i)))];
let _e4119 = (_e3789 + 1027i);
let _e4121 = select(_e3795, _e4119, (_e4119 < _e3795));
let _e4127 = global_3.member[bitcast<u32>(select(0i, _e4121, (_e4121 > 0i)))];
let _e4128 = (_e3789 + 1031i);
let _e4130 = select(_e3795, _e4128, (_e4128 < _e3795));
let _e4136 = global_3.member[bitcast<u32>(select(0i, _e4130, (_e4130 > 0i)))];
let _e4141 = (bitcast<f32>(((_e4109 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4149 = (_e4141 + (((bitcast<f32>(((_e4118 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4141) * _e3793));
let _e4154 = (bitcast<f32>(((_e4127 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4169 = (_e3445 * _e3340.member_1);
let _e4171 = -(((_e3880 + (((_e3885 + (((bitcast<f32>((((_e3830 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3885) * _e3793)) - _e3880) * _e3791)) * _e4169));
let _e4173 = select(-87f, _e4171, (_e4171 > -87f));
let _e4175 = select(88f, _e4173, (_e4173 < 88f));
let _e4177 = ((_e4175 * 1.442695f) + 0.5f);
let _e4179 = select(-127f, _e4177, (_e4177 > -127f));
let _e4181 = select(128f, _e4179, (_e4179 < 128f));
let _e4188 = select(0i, select(select(i32(_e4181), i32(-2147483648), (_e4181 < -2147483600f)), 2147483647i, (_e4181 > 2147483500f)), (_e4181 == _e4181));
let _e4192 = (_e4188 - select(0i, 1i, (_e4181 < f32(_e4188))));
let _e4193 = f32(_e4192);
let _e4197 = ((_e4175 - (_e4193 * 0.6933594f)) - (_e4193 * -2.1219444e-4f));
let _e4219 = -(((_e3945 + (((_e3950 + (((bitcast<f32>(((_e3932 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3950) * _e3793)) - _e3945) * _e3791)) * _e4169));
let _e4221 = select(-87f, _e4219, (_e4219 > -87f));
let _e4223 = select(88f, _e4221, (_e4221 < 88f));
let _e4225 = ((_e4223 * 1.442695f) + 0.5f);
let _e4227 = select(-127f, _e4225, (_e4225 > -127f));
let _e4229 = select(128f, _e4227, (_e4227 < 128f));
let _e4236 = select(0i, select(select(i32(_e4229), i32(-2147483648), (_e4229 < -2147483600f)), 2147483647i, (_e4229 > 2147483500f)), (_e4229 == _e4229));
let _e4240 = (_e4236 - select(0i, 1i, (_e4229 < f32(_e4236))));
let _e4241 = f32(_e4240);
let _e4245 = ((_e4223 - (_e4241 * 0.6933594f)) - (_e4241 * -2.1219444e-4f));
let _e4267 = -(((_e3982 + (((_e3987 + (((bitcast<f32>((((_e3932 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3987) * _e3793)) - _e3982) * _e3791)) * _e4169));
let _e4269 = select(-87f, _e4267, (_e4267 > -87f));
let _e4271 = select(88f, _e4269, (_e4269 < 88f));
let _e4273 = ((_e4271 * 1.442695f) + 0.5f);
let _e4275 = select(-127f, _e4273, (_e4273 > -127f));
let _e4277 = select(128f, _e4275, (_e4275 < 128f));
let _e4284 = select(0i, select(select(i32(_e4277), i32(-2147483648), (_e4277 < -2147483600f)), 2147483647i, (_e4277 > 2147483500f)), (_e4277 == _e4277));
let _e4288 = (_e4284 - select(0i, 1i, (_e4277 < f32(_e4284))));
let _e4289 = f32(_e4288);
let _e4293 = ((_e4271 - (_e4289 * 0.6933594f)) - (_e4289 * -2.1219444e-4f));
let _e4316 = -((_e3859 * (_e3445 * _e3340.member)));
let _e4318 = select(-87f, _e4316, (_e4316 > -87f));
let _e4320 = select(88f, _e4318, (_e4318 < 88f));
let _e4322 = ((_e4320 * 1.442695f) + 0.5f);
let _e4324 = select(-127f, _e4322, (_e4322 > -127f));
let _e4326 = select(128f, _e4324, (_e4324 < 128f));
let _e4333 = select(0i, select(select(i32(_e4326), i32(-2147483648), (_e4326 < -2147483600f)), 2147483647i, (_e4326 > 2147483500f)), (_e4326 == _e4326));
let _e4337 = (_e4333 - select(0i, 1i, (_e4326 < f32(_e4333))));
let _e4338 = f32(_e4337);
let _e4342 = ((_e4320 - (_e4338 * 0.6933594f)) - (_e4338 * -2.1219444e-4f));
let _e4362 = ((1f + (_e4342 * (1f + (_e4342 * (0.5f + (_e4342 * (0.16666667f + (_e4342 * (0.041666668f + (_e4342 * (0.008333334f + (_e4342 * (0.001388889f + (_e4342 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4337 + 127i)) << bitcast<u32>(23i))));
let _e4363 = (1f - _e4362);
let _e4366 = (_e4363 / select(1e-12f, _e3859, (_e3859 > 1e-12f)));
phi_7106_ = type_31(_e4362, _e4363, vec3<f32>(((1f + (_e4197 * (1f + (_e4197 * (0.5f + (_e4197 * (0.16666667f + (_e4197 * (0.041666668f + (_e4197 * (0.008333334f + (_e4197 * (0.001388889f + (_e4197 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4192 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e4245 * (1f + (_e4245 * (0.5f + (_e4245 * (0.16666667f + (_e4245 * (0.041666668f + (_e4245 * (0.008333334f + (_e4245 * (0.001388889f + (_e4245 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4240 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e4293 * (1f + (_e4293 * (0.5f + (_e4293 * (0.16666667f + (_e4293 * (0.041666668f + (_e4293 * (0.008333334f + (_e4293 * (0.001388889f + (_e4293 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4288 + 127i)) << bitcast<u32>(23i))))), vec3<f32>(((_e4047 + (((_e4052 + (((bitcast<f32>(((_e4034 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4052) * _e3793)) - _e4047) * _e3791)) * _e4366), ((_e4084 + (((_e4089 + (((bitcast<f32>((((_e4034 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4089) * _e3793)) - _e4084) * _e3791)) * _e4366), ((_e4149 + (((_e4154 + (((bitcast<f32>(((_e4136 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4154) * _e3793)) - _e4149) * _e3791)) * _e4366)));
}
let _e4373 = phi_7106_;
let _e4374 = select(0f, _e3127, _e444);
let _e4378 = (_e380 + (_e3427 * _e4374));
let _e4379 = (_e382 + (_e3428 * _e4374));
let _e4380 = (_e376 + (_e3429 * _e4374));
if (_e729.member_2 == 3u) {
let _e4386 = global_5.member[_e352].member_9.member_1;
let _e4395 = global_5.member[_e352].member_9.member;
phi_8089_ = type_25(vec3<f32>(_e4386.member, _e4386.member_1, _e4386.member_2), vec3<f32>(_e4395.member, _e4395.member_1, _e4395.member_2));
} else {
let _e4405 = global_5.member[_e352].member_8.member_8;
let _e4406 = (_e4380 - _e4405);
let _e4411 = global_5.member[_e352].member_8.member_2;
let _e4416 = global_5.member[_e352].member_8.member_6;
let _e4424 = global_5.member[_e352].member_8.member_5;
let _e4426 = (((_e4378 - (_e4411 + (_e4416 * _e4406))) * _e4424) - 0.5f);
let _e4431 = global_5.member[_e352].member_8.member_3;
let _e4436 = global_5.member[_e352].member_8.member_7;
let _e4441 = (((_e4379 - (_e4431 + (_e4436 * _e4406))) * _e4424) - 0.5f);
let _e4446 = global_5.member[_e352].member_8.member;
let _e4447 = bitcast<i32>(_e4446);
let _e4449 = (f32(_e4447) - 1f);
let _e4454 = global_5.member[_e352].member_8.member_1;
let _e4457 = (f32(bitcast<i32>(_e4454)) - 1f);
let _e4459 = select(0f, _e4426, (_e4426 > 0f));
let _e4461 = select(_e4449, _e4459, (_e4459 < _e4449));
let _e4468 = select(0i, select(select(i32(_e4461), i32(-2147483648), (_e4461 < -2147483600f)), 2147483647i, (_e4461 > 2147483500f)), (_e4461 == _e4461));
let _e4472 = (_e4468 - select(0i, 1i, (_e4461 < f32(_e4468))));
let _e4474 = select(0f, _e4441, (_e4441 > 0f));
let _e4476 = select(_e4457, _e4474, (_e4474 < _e4457));
let _e4483 = select(0i, select(select(i32(_e4476), i32(-2147483648), (_e4476 < -2147483600f)), 2147483647i, (_e4476 > 2147483500f)), (_e4476 == _e4476));
let _e4487 = (_e4483 - select(0i, 1i, (_e4476 < f32(_e4483))));
let _e4491 = (_e4426 - f32(_e4472));
let _e4493 = (_e4441 - f32(_e4487));
let _e4500 = ((((_e4426 >= 0f) && (_e4426 <= _e4449)) && (_e4441 >= 0f)) && (_e4441 <= _e4457));
let _e4504 = global_5.member[_e352].member_4;
let _e4505 = bitcast<i32>(_e4504);
let _e4507 = bitcast<i32>((_e4446 * _e4454));
let _e4509 = (_e4505 + (3i * _e4507));
local_1 = (_e4509 + ((_e4487 * _e4447) + _e4472));
let _e4511 = local_1;
let _e4513 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e4515 = select(_e4513, _e4511, (_e4511 < _e4513));
let _e4520 = global_6.member[bitcast<u32>(select(0i, _e4515, (_e4515 > 0i)))];
let _e4521 = bitcast<u32>(_e4520);
let _e4525 = f32((bitcast<i32>((_e4521 & 65535u)) - 32768i));
let _e4531 = f32((bitcast<i32>(((_e4521 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4536 = select(_e4531, -(_e4531), ((_e4521 >> bitcast<u32>(31i)) != 0u));
let _e4537 = local_1;
let _e4538 = (_e4537 + 1i);
let _e4540 = select(_e4513, _e4538, (_e4538 < _e4513));
let _e4545 = global_6.member[bitcast<u32>(select(0i, _e4540, (_e4540 > 0i)))];
let _e4546 = bitcast<u32>(_e4545);
let _e4556 = f32((bitcast<i32>(((_e4546 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4562 = local_1;
let _e4563 = (_e4562 + _e4447);
let _e4565 = select(_e4513, _e4563, (_e4563 < _e4513));
let _e4570 = global_6.member[bitcast<u32>(select(0i, _e4565, (_e4565 > 0i)))];
let _e4571 = bitcast<u32>(_e4570);
let _e4575 = f32((bitcast<i32>((_e4571 & 65535u)) - 32768i));
let _e4581 = f32((bitcast<i32>(((_e4571 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4586 = select(_e4581, -(_e4581), ((_e4571 >> bitcast<u32>(31i)) != 0u));
let _e4587 = (_e4447 + 1i);
let _e4588 = local_1;
let _e4589 = (_e4588 + _e4587);
let _e4591 = select(_e4513, _e4589, (_e4589 < _e4513));
let _e4596 = global_6.member[bitcast<u32>(select(0i, _e4591, (_e4591 > 0i)))];
let _e4597 = bitcast<u32>(_e4596);
let _e4607 = f32((bitcast<i32>(((_e4597 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4615 = (_e4525 + ((f32((bitcast<i32>((_e4546 & 65535u)) - 32768i)) - _e4525) * _e4491));
let _e4624 = (_e4536 + ((select(_e4556, -(_e4556), ((_e4546 >> bitcast<u32>(31i)) != 0u)) - _e4536) * _e4491));
let _e4637 = global_5.member[_e352].member_9.member;
let _e4640 = (1f / 16255f);
let _e4642 = (_e4637.member + (select(0f, (_e4615 + (((_e4575 + ((f32((bitcast<i32>((_e4597 & 65535u)) - 32768i)) - _e4575) * _e4491)) - _e4615) * _e4493)), _e4500) * _e4640));
let _e4644 = (_e4637.member_1 + (select(0f, (_e4624 + (((_e4586 + ((select(_e4607, -(_e4607), ((_e4597 >> bitcast<u32>(31i)) != 0u)) - _e4586) * _e4491)) - _e4624) * _e4493)), _e4500) * _e4640));
let _e4648 = (1f - ((_e4642 * _e4642) + (_e4644 * _e4644)));
let _e4650 = select(1e-4f, _e4648, (_e4648 > 1e-4f));
let _e4653 = sqrt(select(0f, _e4650, (_e4650 > 0f)));
let _e4657 = (1f / select(1e-6f, _e4653, (_e4653 > 1e-6f)));
let _e4658 = ((_e4380 - _e376) * _e4424);
let _e4665 = (_e4426 - (((_e4642 * _e4657) - _e4416) * _e4658));
let _e4666 = (_e4441 - (((_e4644 * _e4657) - _e4436) * _e4658));
let _e4668 = select(0f, _e4665, (_e4665 > 0f));
let _e4670 = select(_e4449, _e4668, (_e4668 < _e4449));
let _e4677 = select(0i, select(select(i32(_e4670), i32(-2147483648), (_e4670 < -2147483600f)), 2147483647i, (_e4670 > 2147483500f)), (_e4670 == _e4670));
let _e4681 = (_e4677 - select(0i, 1i, (_e4670 < f32(_e4677))));
let _e4683 = select(0f, _e4666, (_e4666 > 0f));
let _e4685 = select(_e4457, _e4683, (_e4683 < _e4457));
let _e4692 = select(0i, select(select(i32(_e4685), i32(-2147483648), (_e4685 < -2147483600f)), 2147483647i, (_e4685 > 2147483500f)), (_e4685 == _e4685));
let _e4696 = (_e4692 - select(0i, 1i, (_e4685 < f32(_e4692))));
let _e4698 = ((_e4696 * _e4447) + _e4681);
let _e4700 = (_e4665 - f32(_e4681));
let _e4702 = (_e4666 - f32(_e4696));
let _e4709 = ((((_e4665 >= 0f) && (_e4665 <= _e4449)) && (_e4666 >= 0f)) && (_e4666 <= _e4457));
let _e4710 = (_e4505 + _e4698);
let _e4712 = select(_e4513, _e4710, (_e4710 < _e4513));
let _e4718 = global_6.member[bitcast<u32>(select(0i, _e4712, (_e4712 > 0i)))];
let _e4719 = (_e4710 + 1i);
let _e4721 = select(_e4513, _e4719, (_e4719 < _e4513));
let _e4727 = global_6.member[bitcast<u32>(select(0i, _e4721, (_e4721 > 0i)))];
let _e4730 = (_e4718 + ((_e4727 - _e4718) * _e4700));
let _e4731 = (_e4710 + _e4447);
let _e4733 = select(_e4513, _e4731, (_e4731 < _e4513));
let _e4739 = global_6.member[bitcast<u32>(select(0i, _e4733, (_e4733 > 0i)))];
let _e4740 = (_e4731 + 1i);
let _e4742 = select(_e4513, _e4740, (_e4740 < _e4513));
let _e4748 = global_6.member[bitcast<u32>(select(0i, _e4742, (_e4742 > 0i)))];
let _e4755 = select(1f, (_e4730 + (((_e4739 + ((_e4748 - _e4739) * _e4700)) - _e4730) * _e4702)), _e4709);
if _e3446 {
phi_7859_ = vec3(_e4755);
} else {
let _e4758 = ((_e4505 + _e4507) + _e4698);
let _e4760 = select(_e4513, _e4758, (_e4758 < _e4513));
let _e4766 = global_6.member[bitcast<u32>(select(0i, _e4760, (_e4760 > 0i)))];
let _e4767 = (_e4758 + 1i);
let _e4769 = select(_e4513, _e4767, (_e4767 < _e4513));
let _e4775 = global_6.member[bitcast<u32>(select(0i, _e4769, (_e4769 > 0i)))];
let _e4778 = (_e4766 + ((_e4775 - _e4766) * _e4700));
let _e4779 = (_e4758 + _e4447);
let _e4781 = select(_e4513, _e4779, (_e4779 < _e4513));
let _e4787 = global_6.member[bitcast<u32>(select(0i, _e4781, (_e4781 > 0i)))];
let _e4788 = (_e4779 + 1i);
let _e4790 = select(_e4513, _e4788, (_e4788 < _e4513));
let _e4796 = global_6.member[bitcast<u32>(select(0i, _e4790, (_e4790 > 0i)))];
let _e4806 = ((_e4505 + (2i * _e4507)) + _e4698);
let _e4808 = select(_e4513, _e4806, (_e4806 < _e4513));
let _e4814 = global_6.member[bitcast<u32>(select(0i, _e4808, (_e4808 > 0i)))];
let _e4815 = (_e4806 + 1i);
let _e4817 = select(_e4513, _e4815, (_e4815 < _e4513));
let _e4823 = global_6.member[bitcast<u32>(select(0i, _e4817, (_e4817 > 0i)))];
let _e4826 = (_e4814 + ((_e4823 - _e4814) * _e4700));
let _e4827 = (_e4806 + _e4447);
let _e4829 = select(_e4513, _e4827, (_e4827 < _e4513));
let _e4835 = global_6.member[bitcast<u32>(select(0i, _e4829, (_e4829 > 0i)))];
let _e4836 = (_e4827 + 1i);
let _e4838 = select(_e4513, _e4836, (_e4836 < _e4513));
let _e4844 = global_6.member[bitcast<u32>(select(0i, _e4838, (_e4838 > 0i)))];
phi_7859_ = vec3<f32>(_e4755, select(1f, (_e4778 + (((_e4787 + ((_e4796 - _e4787) * _e4700)) - _e4778) * _e4702)), _e4709), select(1f, (_e4826 + (((_e4835 + ((_e4844 - _e4835) * _e4700)) - _e4826) * _e4702)), _e4709));
}
let _e4854 = phi_7859_;
local = (_e4509 + _e4698);
let _e4856 = local;
let _e4858 = select(_e4513, _e4856, (_e4856 < _e4513));
let _e4863 = global_6.member[bitcast<u32>(select(0i, _e4858, (_e4858 > 0i)))];
let _e4864 = bitcast<u32>(_e4863);
let _e4868 = f32((bitcast<i32>((_e4864 & 65535u)) - 32768i));
let _e4874 = f32((bitcast<i32>(((_e4864 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4879 = select(_e4874, -(_e4874), ((_e4864 >> bitcast<u32>(31i)) != 0u));
let _e4880 = local;
let _e4881 = (_e4880 + 1i);
let _e4883 = select(_e4513, _e4881, (_e4881 < _e4513));
let _e4888 = global_6.member[bitcast<u32>(select(0i, _e4883, (_e4883 > 0i)))];
let _e4889 = bitcast<u32>(_e4888);
let _e4899 = f32((bitcast<i32>(((_e4889 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4905 = local;
let _e4906 = (_e4905 + _e4447);
let _e4908 = select(_e4513, _e4906, (_e4906 < _e4513));
let _e4913 = global_6.member[bitcast<u32>(select(0i, _e4908, (_e4908 > 0i)))];
let _e4914 = bitcast<u32>(_e4913);
let _e4918 = f32((bitcast<i32>((_e4914 & 65535u)) - 32768i));
let _e4924 = f32((bitcast<i32>(((_e4914 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4929 = select(_e4924, -(_e4924), ((_e4914 >> bitcast<u32>(31i)) != 0u));
let _e4930 = local;
let _e4931 = (_e4930 + _e4587);
let _e4933 = select(_e4513, _e4931, (_e4931 < _e4513));
let _e4938 = global_6.member[bitcast<u32>(select(0i, _e4933, (_e4933 > 0i)))];
let _e4939 = bitcast<u32>(_e4938);
let _e4949 = f32((bitcast<i32>(((_e4939 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4957 = (_e4868 + ((f32((bitcast<i32>((_e4889 & 65535u)) - 32768i)) - _e4868) * _e4700));
let _e4966 = (_e4879 + ((select(_e4899, -(_e4899), ((_e4889 >> bitcast<u32>(31i)) != 0u)) - _e4879) * _e4700));
let _e4979 = global_5.member[_e352].member_9.member_1;
let _e4986 = (_e4637.member + (select(0f, (_e4957 + (((_e4918 + ((f32((bitcast<i32>((_e4939 & 65535u)) - 32768i)) - _e4918) * _e4700)) - _e4957) * _e4702)), _e4709) * _e4640));
let _e4988 = (_e4637.member_1 + (select(0f, (_e4966 + (((_e4929 + ((select(_e4949, -(_e4949), ((_e4939 >> bitcast<u32>(31i)) != 0u)) - _e4929) * _e4700)) - _e4966) * _e4702)), _e4709) * _e4640));
let _e4992 = (1f - ((_e4986 * _e4986) + (_e4988 * _e4988)));
let _e4994 = select(1e-4f, _e4992, (_e4992 > 1e-4f));
phi_8089_ = type_25((_e4854 * vec3<f32>(_e4979.member, _e4979.member_1, _e4979.member_2)), vec3<f32>(_e4986, _e4988, sqrt(select(0f, _e4994, (_e4994 > 0f)))));
}
let _e5001 = phi_8089_;
let _e5010 = (((_e5001.member_1.x * _e5001.member_1.x) + (_e5001.member_1.y * _e5001.member_1.y)) + (_e5001.member_1.z * _e5001.member_1.z));
let _e5013 = sqrt(select(0f, _e5010, (_e5010 > 0f)));
let _e5019 = (1e-6f * _e5013);
let _e5023 = select((_e5013 / select(_e5019, _e5001.member_1.z, (_e5001.member_1.z > _e5019))), 1f, ((_e687 & 8u) != 0u));
let _e5025 = (_e5001.member.x * _e5023);
let _e5027 = (_e5001.member.y * _e5023);
let _e5029 = (_e5001.member.z * _e5023);
if _e803 {
let _e5034 = global_5.member[_e352].member_19;
let _e5043 = (((_e2664.member_1.x * _e2664.member_1.x) + (_e2664.member_1.y * _e2664.member_1.y)) + (_e2664.member_1.z * _e2664.member_1.z));
let _e5046 = sqrt(select(0f, _e5043, (_e5043 > 0f)));
let _e5049 = (1f / select(1e-20f, _e5046, (_e5046 > 1e-20f)));
let _e5050 = (_e2664.member_1.x * _e5049);
let _e5051 = (_e2664.member_1.y * _e5049);
let _e5052 = (_e2664.member_1.z * _e5049);
let _e5055 = (-1f / select(1e-20f, _e5013, (_e5013 > 1e-20f)));
let _e5056 = (_e5001.member_1.x * _e5055);
let _e5057 = (_e5001.member_1.y * _e5055);
let _e5058 = (_e5001.member_1.z * _e5055);
let _e5063 = (((_e356[3] * _e356[3]) + (_e356[4] * _e356[4])) + (_e356[5] * _e356[5]));
let _e5066 = sqrt(select(0f, _e5063, (_e5063 > 0f)));
let _e5069 = (-1f / select(1e-20f, _e5066, (_e5066 > 1e-20f)));
let _e5070 = (_e356[3] * _e5069);
let _e5071 = (_e356[4] * _e5069);
let _e5072 = (_e356[5] * _e5069);
let _e5079 = select(1f, -1f, ((((_e5050 * _e5070) + (_e5051 * _e5071)) + (_e5052 * _e5072)) < 0f));
let _e5080 = (_e5050 * _e5079);
let _e5081 = (_e5051 * _e5079);
let _e5082 = (_e5052 * _e5079);
let _e5087 = (((_e5080 * _e5070) + (_e5081 * _e5071)) + (_e5082 * _e5072));
let _e5089 = select(1e-4f, _e5087, (_e5087 > 1e-4f));
let _e5094 = (((_e5080 * _e5056) + (_e5081 * _e5057)) + (_e5082 * _e5058));
let _e5095 = (_e5056 + _e5070);
let _e5096 = (_e5057 + _e5071);
let _e5097 = (_e5058 + _e5072);
let _e5102 = (((_e5095 * _e5095) + (_e5096 * _e5096)) + (_e5097 * _e5097));
let _e5105 = sqrt(select(0f, _e5102, (_e5102 > 0f)));
let _e5108 = (1f / select(1e-6f, _e5105, (_e5105 > 1e-6f)));
let _e5109 = (_e5095 * _e5108);
let _e5110 = (_e5096 * _e5108);
let _e5111 = (_e5097 * _e5108);
let _e5116 = (((_e5080 * _e5109) + (_e5081 * _e5110)) + (_e5082 * _e5111));
let _e5118 = select(0f, _e5116, (_e5116 > 0f));
let _e5123 = (((_e5070 * _e5109) + (_e5071 * _e5110)) + (_e5072 * _e5111));
let _e5125 = select(0f, _e5123, (_e5123 > 0f));
let _e5126 = (_e5034 * _e5034);
let _e5127 = (_e5126 * _e5126);
let _e5131 = (((_e5118 * _e5118) * (_e5127 - 1f)) + 1f);
let _e5135 = (_e5094 > 0f);
let _e5136 = select(0f, _e5094, _e5135);
let _e5138 = (1f - _e5127);
let _e5140 = (((_e5136 * _e5136) * _e5138) + _e5127);
let _e5147 = (((_e5089 * _e5089) * _e5138) + _e5127);
let _e5152 = ((_e5089 * sqrt(select(0f, _e5140, (_e5140 > 0f)))) + (_e5136 * sqrt(select(0f, _e5147, (_e5147 > 0f)))));
let _e5157 = (_e2664.member_2 / _e3124);
let _e5161 = (((_e5157 * _e5157) - 1f) + (_e5125 * _e5125));
let _e5164 = sqrt(select(0f, _e5161, (_e5161 > 0f)));
let _e5165 = (_e5164 - _e5125);
let _e5166 = (_e5164 + _e5125);
let _e5169 = (_e5165 / select(1e-6f, _e5166, (_e5166 > 1e-6f)));
let _e5173 = ((_e5125 * _e5165) + 1f);
let _e5176 = (((_e5125 * _e5166) - 1f) / select(1e-6f, _e5173, (_e5173 > 1e-6f)));
let _e5194 = global_5.member[_e352].member_20;
let _e5198 = ((select(0f, ((((_e5127 / ((3.1415927f * _e5131) * _e5131)) * (0.5f / select(1e-6f, _e5152, (_e5152 > 1e-6f)))) * select(select((((0.5f * _e5169) * _e5169) * (1f + (_e5176 * _e5176))), 1f, (_e5161 <= 0f)), 0f, (_e3124 == _e2664.member_2))) * _e5136), (_e5135 && (_e5046 > 1e-12f))) * _e5194) * select(_e3340.member_2, 0f, _e444));
phi_8407_ = vec3<f32>((_e5025 * _e5198), (_e5027 * _e5198), (_e5029 * _e5198));
} else {
phi_8407_ = vec3<f32>(0f, 0f, 0f);
}
let _e5204 = phi_8407_;
let _e5208 = global_5.member[_e352].member_18;
let _e5215 = (1f - _e356[12]);
let _e5235 = (_e356[9] + ((_e356[13] * ((_e4373.member_3.x * (_e5025 + _e5208.member)) + _e5204.x)) * _e5215));
let _e5236 = (_e356[10] + ((_e356[14] * ((_e4373.member_3.y * (_e5027 + _e5208.member_1)) + _e5204.y)) * _e5215));
let _e5237 = (_e356[11] + ((_e356[15] * ((_e4373.member_3.z * (_e5029 + _e5208.member_2)) + _e5204.z)) * _e5215));
let _e5240 = (_e356[12] + (_e5215 * _e4373.member_1));
let _e5243 = (_e356[13] * _e4373.member_2.x);
let _e5245 = (_e356[14] * _e4373.member_2.y);
let _e5247 = (_e356[15] * _e4373.member_2.z);
let _e5252 = (_e356[8] + ((_e5240 - _e356[12]) * (_e376 + (_e3429 * 0.5f))));
let _e5261 = (-((((select(_e773.member, _e760.member, _e753) * _e5001.member_1.x) + (select(_e773.member_1, _e760.member_1, _e753) * _e5001.member_1.y)) + (select(_e773.member_2, _e760.member_2, _e753) * _e5001.member_1.z))) / select(1e-20f, _e5013, (_e5013 > 1e-20f)));
let _e5266 = bitcast<f32>((bitcast<u32>(select(0f, _e5261, (_e5261 > 0f))) & 2147483647u));
let _e5276 = (1f - _e5240);
let _e5289 = select(_e5240, 1f, _e444);
if _e803 {
let _e5298 = global_5.member[_e352].member_5.member_4;
let _e5301 = (_e2664.member_3.x * _e3340.member_2);
let _e5303 = (_e2664.member_3.y * _e3340.member_2);
let _e5305 = (_e2664.member_3.z * _e3340.member_2);
let _e5306 = (0.5f * _e371);
let _e5310 = (_e356[3] + (_e5301 * _e5306));
let _e5311 = (_e356[4] + (_e5303 * _e5306));
let _e5312 = (_e356[5] + (_e5305 * _e5306));
let _e5314 = (2f * _e370);
let _e5316 = ((_e5312 * _e5312) + (_e5314 * _e5305));
let _e5320 = (_e5312 + sqrt(select(0f, _e5316, (_e5316 > 0f))));
let _e5324 = (0.5f * (_e5314 / select(1e-6f, _e5320, (_e5320 > 1e-6f))));
let _e5328 = (_e5310 + (_e5301 * _e5324));
let _e5329 = (_e5311 + (_e5303 * _e5324));
let _e5330 = (_e5312 + (_e5305 * _e5324));
let _e5334 = (_e5298 * _e5298);
let _e5336 = (_e5330 * _e5330);
let _e5344 = (((_e5312 <= 0f) || (_e5316 <= 0f)) || ((_e5330 <= 0f) || (_e5336 <= (_e5334 * (((_e5328 * _e5328) + (_e5329 * _e5329)) + _e5336)))));
let _e5358 = (_e356[3] + ((_e2664.member_4.x * _e3340.member_2) * _e370));
let _e5359 = (_e356[4] + ((_e2664.member_4.y * _e3340.member_2) * _e370));
let _e5360 = (_e356[5] + ((_e2664.member_4.z * _e3340.member_2) * _e370));
let _e5362 = (_e5360 * _e5360);
let _e5371 = ((_e687 & 1u) != 0u);
phi_8712_ = vec3<f32>(select(select(_e5328, _e5310, _e5344), _e5358, _e5371), select(select(_e5329, _e5311, _e5344), _e5359, _e5371), select(select(_e5330, _e5312, _e5344), _e5360, _e5371));
phi_8713_ = select(_e5344, ((_e5360 <= 0f) || (_e5362 <= (_e5334 * (((_e5358 * _e5358) + (_e5359 * _e5359)) + _e5362)))), _e5371);
} else {
phi_8712_ = vec3<f32>(_e356[3], _e356[4], _e356[5]);
phi_8713_ = false;
}
let _e5378 = phi_8712_;
let _e5380 = phi_8713_;
let _e5389 = (((_e444 || (_e5378.x != _e356[3])) || (_e5378.y != _e356[4])) || (_e5378.z != _e356[5]));
let _e5391 = select(_e5245, _e5243, (_e5243 > _e5245));
phi_8778_ = array<f32, 18>(select(_e356[0], select(_e384, _e4378, _e444), _e5389), select(_e356[1], select(_e386, _e4379, _e444), _e5389), select(_e356[2], select(_e391, _e4380, _e444), _e5389), _e5378.x, _e5378.y, _e5378.z, _e2664.member, select(select(0f, 2f, _e5380), 1f, (_e444 || (((1f - _e5289) * select(_e5247, _e5391, (_e5391 > _e5247))) < 9.765625e-4f))), select(_e5252, (_e5252 + (_e5276 * _e4380)), _e444), select(_e5235, (_e5235 + ((_e5243 * (select(_e779.member, _e766.member, _e753) * ((_e5025 * _e5266) + _e5208.member))) * _e5276)), _e444), select(_e5236, (_e5236 + ((_e5245 * (select(_e779.member_1, _e766.member_1, _e753) * ((_e5027 * _e5266) + _e5208.member_1))) * _e5276)), _e444), select(_e5237, (_e5237 + ((_e5247 * (select(_e779.member_2, _e766.member_2, _e753) * ((_e5029 * _e5266) + _e5208.member_2))) * _e5276)), _e444), _e5289, _e5243, _e5245, _e5247, _e2664.member_2, _e391);
} else {
phi_8778_ = _e356;
}
let _e5410 = phi_8778_;
phi_585_ = (_e352 + 1u);
phi_588_ = select(_e354, true, _e725);
phi_590_ = _e5410;
} else {
phi_585_ = u32();
phi_588_ = bool();
phi_590_ = array<f32, 18>();
}
let _e5414 = phi_585_;
let _e5416 = phi_588_;
let _e5418 = phi_590_;
continue;
continuing {
phi_584_ = _e5414;
phi_587_ = _e5416;
phi_589_ = _e5418;
phi_8861_ = false;
break if !(_e357);
}
}
let _e5421 = phi_8861_;
if _e5421 {
break;
}
let _e5423 = local_8;
if _e5423 {
let _e5425 = local_9;
global_4.member[_e152] = _e5425[0];
let _e5430 = local_10;
global_4.member[_e164] = _e5430[1];
let _e5435 = local_11;
global_4.member[_e175] = _e5435[2];
let _e5440 = local_12;
global_4.member[_e186] = _e5440[3];
let _e5445 = local_13;
global_4.member[_e197] = _e5445[4];
let _e5450 = local_14;
global_4.member[_e208] = _e5450[5];
let _e5455 = local_15;
global_4.member[_e219] = _e5455[6];
let _e5460 = local_16;
global_4.member[_e230] = _e5460[7];
let _e5465 = local_17;
global_4.member[_e241] = _e5465[8];
let _e5470 = local_18;
global_4.member[_e252] = _e5470[9];
let _e5475 = local_19;
global_4.member[_e263] = _e5475[10];
let _e5480 = local_20;
global_4.member[_e274] = _e5480[11];
let _e5485 = local_21;
global_4.member[_e285] = _e5485[12];
let _e5490 = local_22;
global_4.member[_e296] = _e5490[13];
let _e5495 = local_23;
global_4.member[_e307] = _e5495[14];
let _e5500 = local_24;
global_4.member[_e318] = _e5500[15];
let _e5505 = local_25;
global_4.member[_e329] = _e5505[16];
let _e5510 = local_26;
global_4.member[_e340] = _e5510[17];
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
