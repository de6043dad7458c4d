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
var phi_582_: u32;
var phi_585_: bool;
var phi_587_: array<f32, 18>;
var phi_3423_: type_29;
var phi_4032_: type_30;
var phi_4578_: f32;
var phi_4967_: type_5;
var phi_6525_: type_31;
var phi_7278_: vec3<f32>;
var phi_7508_: type_25;
var phi_7826_: vec3<f32>;
var phi_8131_: vec3<f32>;
var phi_8132_: bool;
var phi_8197_: array<f32, 18>;
var phi_583_: u32;
var phi_586_: bool;
var phi_588_: array<f32, 18>;
var phi_8280_: bool;
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
phi_582_ = 0u;
phi_585_ = false;
phi_587_ = array<f32, 18>(_e163, _e173, _e184, _e195, _e206, _e217, _e228, _e239, _e250, _e261, _e272, _e283, _e294, _e305, _e316, _e327, _e338, _e349);
loop {
let _e352 = phi_582_;
let _e354 = phi_585_;
let _e356 = phi_587_;
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
phi_8280_ = true;
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
let _e859 = (_e818 + 1i);
let _e860 = (_e833 + 1i);
let _e861 = (_e848 + 1i);
let _e867 = global_5.member[_e352].member_6.member_11.member;
let _e874 = global_5.member[_e352].member_6.member_11.member_1;
let _e885 = ((_e859 >> bitcast<u32>(4i)) + (bitcast<i32>(_e867) * ((_e860 >> bitcast<u32>(4i)) + (bitcast<i32>(_e874) * (_e861 >> bitcast<u32>(4i))))));
let _e887 = (bitcast<i32>(_e119) - 1i);
let _e889 = select(_e887, _e885, (_e885 < _e887));
let _e895 = global_1.member[bitcast<u32>(select(0i, _e889, (_e889 > 0i)))];
let _e897 = (_e859 & 15i);
let _e900 = ((_e860 & 15i) * _e853);
let _e902 = (bitcast<i32>(_e895) + ((_e861 & 15i) * _e858));
let _e906 = (_e900 + _e853);
let _e908 = (_e900 + (2i * _e853));
let _e910 = (_e900 + (3i * _e853));
let _e911 = (_e902 + _e858);
let _e913 = (_e902 + (2i * _e858));
let _e915 = (_e902 + (3i * _e858));
local_6 = type_28(array<i32, 4>(_e897, (_e897 + 1i), (_e897 + 2i), (_e897 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_7 = vec3<f32>((_e526 - f32(_e818)), (_e537 - f32(_e833)), (_e548 - f32(_e848)));
let _e926 = (_e911 + _e906);
let _e929 = local_6.member[0u];
let _e930 = (_e926 + _e929);
let _e932 = select(_e887, _e930, (_e930 < _e887));
let _e937 = global_1.member[bitcast<u32>(select(0i, _e932, (_e932 > 0i)))];
let _e938 = bitcast<f32>(_e937);
let _e941 = local_6.member[1u];
let _e942 = (_e926 + _e941);
let _e944 = select(_e887, _e942, (_e942 < _e887));
let _e949 = global_1.member[bitcast<u32>(select(0i, _e944, (_e944 > 0i)))];
let _e950 = bitcast<f32>(_e949);
let _e953 = local_6.member[2u];
let _e954 = (_e926 + _e953);
let _e956 = select(_e887, _e954, (_e954 < _e887));
let _e961 = global_1.member[bitcast<u32>(select(0i, _e956, (_e956 > 0i)))];
let _e962 = bitcast<f32>(_e961);
let _e965 = local_6.member[3u];
let _e966 = (_e926 + _e965);
let _e968 = select(_e887, _e966, (_e966 < _e887));
let _e973 = global_1.member[bitcast<u32>(select(0i, _e968, (_e968 > 0i)))];
let _e975 = local_7[0u];
let _e978 = (_e938 + ((_e950 - _e938) * _e975));
let _e979 = local_7[0u];
let _e982 = (_e950 + ((_e962 - _e950) * _e979));
let _e983 = local_7[0u];
let _e986 = (_e962 + ((bitcast<f32>(_e973) - _e962) * _e983));
let _e987 = (_e911 + _e908);
let _e988 = local_6.member[0u];
let _e989 = (_e987 + _e988);
let _e991 = select(_e887, _e989, (_e989 < _e887));
let _e996 = global_1.member[bitcast<u32>(select(0i, _e991, (_e991 > 0i)))];
let _e997 = bitcast<f32>(_e996);
let _e998 = local_6.member[1u];
let _e999 = (_e987 + _e998);
let _e1001 = select(_e887, _e999, (_e999 < _e887));
let _e1006 = global_1.member[bitcast<u32>(select(0i, _e1001, (_e1001 > 0i)))];
let _e1007 = bitcast<f32>(_e1006);
let _e1008 = local_6.member[2u];
let _e1009 = (_e987 + _e1008);
let _e1011 = select(_e887, _e1009, (_e1009 < _e887));
let _e1016 = global_1.member[bitcast<u32>(select(0i, _e1011, (_e1011 > 0i)))];
let _e1017 = bitcast<f32>(_e1016);
let _e1018 = local_6.member[3u];
let _e1019 = (_e987 + _e1018);
let _e1021 = select(_e887, _e1019, (_e1019 < _e887));
let _e1026 = global_1.member[bitcast<u32>(select(0i, _e1021, (_e1021 > 0i)))];
let _e1028 = local_7[0u];
let _e1032 = local_7[0u];
let _e1035 = (_e1007 + ((_e1017 - _e1007) * _e1032));
let _e1036 = local_7[0u];
let _e1040 = (_e913 + _e906);
let _e1041 = local_6.member[0u];
let _e1042 = (_e1040 + _e1041);
let _e1044 = select(_e887, _e1042, (_e1042 < _e887));
let _e1049 = global_1.member[bitcast<u32>(select(0i, _e1044, (_e1044 > 0i)))];
let _e1050 = bitcast<f32>(_e1049);
let _e1051 = local_6.member[1u];
let _e1052 = (_e1040 + _e1051);
let _e1054 = select(_e887, _e1052, (_e1052 < _e887));
let _e1059 = global_1.member[bitcast<u32>(select(0i, _e1054, (_e1054 > 0i)))];
let _e1060 = bitcast<f32>(_e1059);
let _e1061 = local_6.member[2u];
let _e1062 = (_e1040 + _e1061);
let _e1064 = select(_e887, _e1062, (_e1062 < _e887));
let _e1069 = global_1.member[bitcast<u32>(select(0i, _e1064, (_e1064 > 0i)))];
let _e1070 = bitcast<f32>(_e1069);
let _e1071 = local_6.member[3u];
let _e1072 = (_e1040 + _e1071);
let _e1074 = select(_e887, _e1072, (_e1072 < _e887));
let _e1079 = global_1.member[bitcast<u32>(select(0i, _e1074, (_e1074 > 0i)))];
let _e1081 = local_7[0u];
let _e1084 = (_e1050 + ((_e1060 - _e1050) * _e1081));
let _e1085 = local_7[0u];
let _e1088 = (_e1060 + ((_e1070 - _e1060) * _e1085));
let _e1089 = local_7[0u];
let _e1092 = (_e1070 + ((bitcast<f32>(_e1079) - _e1070) * _e1089));
let _e1093 = (_e913 + _e908);
let _e1094 = local_6.member[0u];
let _e1095 = (_e1093 + _e1094);
let _e1097 = select(_e887, _e1095, (_e1095 < _e887));
let _e1102 = global_1.member[bitcast<u32>(select(0i, _e1097, (_e1097 > 0i)))];
let _e1103 = bitcast<f32>(_e1102);
let _e1104 = local_6.member[1u];
let _e1105 = (_e1093 + _e1104);
let _e1107 = select(_e887, _e1105, (_e1105 < _e887));
let _e1112 = global_1.member[bitcast<u32>(select(0i, _e1107, (_e1107 > 0i)))];
let _e1113 = bitcast<f32>(_e1112);
let _e1114 = local_6.member[2u];
let _e1115 = (_e1093 + _e1114);
let _e1117 = select(_e887, _e1115, (_e1115 < _e887));
let _e1122 = global_1.member[bitcast<u32>(select(0i, _e1117, (_e1117 > 0i)))];
let _e1123 = bitcast<f32>(_e1122);
let _e1124 = local_6.member[3u];
let _e1125 = (_e1093 + _e1124);
let _e1127 = select(_e887, _e1125, (_e1125 < _e887));
let _e1132 = global_1.member[bitcast<u32>(select(0i, _e1127, (_e1127 > 0i)))];
let _e1134 = local_7[0u];
let _e1138 = local_7[0u];
let _e1141 = (_e1113 + ((_e1123 - _e1113) * _e1138));
let _e1142 = local_7[0u];
let _e1146 = (_e911 + _e900);
let _e1147 = local_6.member[1u];
let _e1148 = (_e1146 + _e1147);
let _e1150 = select(_e887, _e1148, (_e1148 < _e887));
let _e1155 = global_1.member[bitcast<u32>(select(0i, _e1150, (_e1150 > 0i)))];
let _e1156 = bitcast<f32>(_e1155);
let _e1157 = local_6.member[2u];
let _e1158 = (_e1146 + _e1157);
let _e1160 = select(_e887, _e1158, (_e1158 < _e887));
let _e1165 = global_1.member[bitcast<u32>(select(0i, _e1160, (_e1160 > 0i)))];
let _e1167 = local_7[0u];
let _e1170 = (_e1156 + ((bitcast<f32>(_e1165) - _e1156) * _e1167));
let _e1171 = (_e911 + _e910);
let _e1172 = local_6.member[1u];
let _e1173 = (_e1171 + _e1172);
let _e1175 = select(_e887, _e1173, (_e1173 < _e887));
let _e1180 = global_1.member[bitcast<u32>(select(0i, _e1175, (_e1175 > 0i)))];
let _e1181 = bitcast<f32>(_e1180);
let _e1182 = local_6.member[2u];
let _e1183 = (_e1171 + _e1182);
let _e1185 = select(_e887, _e1183, (_e1183 < _e887));
let _e1190 = global_1.member[bitcast<u32>(select(0i, _e1185, (_e1185 > 0i)))];
let _e1192 = local_7[0u];
let _e1196 = (_e913 + _e900);
let _e1197 = local_6.member[1u];
let _e1198 = (_e1196 + _e1197);
let _e1200 = select(_e887, _e1198, (_e1198 < _e887));
let _e1205 = global_1.member[bitcast<u32>(select(0i, _e1200, (_e1200 > 0i)))];
let _e1206 = bitcast<f32>(_e1205);
let _e1207 = local_6.member[2u];
let _e1208 = (_e1196 + _e1207);
let _e1210 = select(_e887, _e1208, (_e1208 < _e887));
let _e1215 = global_1.member[bitcast<u32>(select(0i, _e1210, (_e1210 > 0i)))];
let _e1217 = local_7[0u];
let _e1220 = (_e1206 + ((bitcast<f32>(_e1215) - _e1206) * _e1217));
let _e1221 = (_e913 + _e910);
let _e1222 = local_6.member[1u];
let _e1223 = (_e1221 + _e1222);
let _e1225 = select(_e887, _e1223, (_e1223 < _e887));
let _e1230 = global_1.member[bitcast<u32>(select(0i, _e1225, (_e1225 > 0i)))];
let _e1231 = bitcast<f32>(_e1230);
let _e1232 = local_6.member[2u];
let _e1233 = (_e1221 + _e1232);
let _e1235 = select(_e887, _e1233, (_e1233 < _e887));
let _e1240 = global_1.member[bitcast<u32>(select(0i, _e1235, (_e1235 > 0i)))];
let _e1242 = local_7[0u];
let _e1246 = (_e902 + _e906);
let _e1247 = local_6.member[1u];
let _e1248 = (_e1246 + _e1247);
let _e1250 = select(_e887, _e1248, (_e1248 < _e887));
let _e1255 = global_1.member[bitcast<u32>(select(0i, _e1250, (_e1250 > 0i)))];
let _e1256 = bitcast<f32>(_e1255);
let _e1257 = local_6.member[2u];
let _e1258 = (_e1246 + _e1257);
let _e1260 = select(_e887, _e1258, (_e1258 < _e887));
let _e1265 = global_1.member[bitcast<u32>(select(0i, _e1260, (_e1260 > 0i)))];
let _e1267 = local_7[0u];
let _e1270 = (_e1256 + ((bitcast<f32>(_e1265) - _e1256) * _e1267));
let _e1271 = (_e915 + _e906);
let _e1272 = local_6.member[1u];
let _e1273 = (_e1271 + _e1272);
let _e1275 = select(_e887, _e1273, (_e1273 < _e887));
let _e1280 = global_1.member[bitcast<u32>(select(0i, _e1275, (_e1275 > 0i)))];
let _e1281 = bitcast<f32>(_e1280);
let _e1282 = local_6.member[2u];
let _e1283 = (_e1271 + _e1282);
let _e1285 = select(_e887, _e1283, (_e1283 < _e887));
let _e1290 = global_1.member[bitcast<u32>(select(0i, _e1285, (_e1285 > 0i)))];
let _e1292 = local_7[0u];
let _e1295 = (_e1281 + ((bitcast<f32>(_e1290) - _e1281) * _e1292));
let _e1296 = (_e902 + _e908);
let _e1297 = local_6.member[1u];
let _e1298 = (_e1296 + _e1297);
let _e1300 = select(_e887, _e1298, (_e1298 < _e887));
let _e1305 = global_1.member[bitcast<u32>(select(0i, _e1300, (_e1300 > 0i)))];
let _e1306 = bitcast<f32>(_e1305);
let _e1307 = local_6.member[2u];
let _e1308 = (_e1296 + _e1307);
let _e1310 = select(_e887, _e1308, (_e1308 < _e887));
let _e1315 = global_1.member[bitcast<u32>(select(0i, _e1310, (_e1310 > 0i)))];
let _e1317 = local_7[0u];
let _e1321 = (_e915 + _e908);
let _e1322 = local_6.member[1u];
let _e1323 = (_e1321 + _e1322);
let _e1325 = select(_e887, _e1323, (_e1323 < _e887));
let _e1330 = global_1.member[bitcast<u32>(select(0i, _e1325, (_e1325 > 0i)))];
let _e1331 = bitcast<f32>(_e1330);
let _e1332 = local_6.member[2u];
let _e1333 = (_e1321 + _e1332);
let _e1335 = select(_e887, _e1333, (_e1333 < _e887));
let _e1340 = global_1.member[bitcast<u32>(select(0i, _e1335, (_e1335 > 0i)))];
let _e1342 = local_7[0u];
let _e1347 = local_7[1u];
let _e1350 = (_e982 + ((_e1035 - _e982) * _e1347));
let _e1351 = local_7[1u];
let _e1354 = (_e1088 + ((_e1141 - _e1088) * _e1351));
let _e1355 = local_7[1u];
let _e1358 = (_e978 + (((_e997 + ((_e1007 - _e997) * _e1028)) - _e978) * _e1355));
let _e1359 = local_7[1u];
let _e1364 = local_7[2u];
let _e1368 = local_7[1u];
let _e1371 = (_e986 + (((_e1017 + ((bitcast<f32>(_e1026) - _e1017) * _e1036)) - _e986) * _e1368));
let _e1372 = local_7[1u];
let _e1376 = local_7[2u];
let _e1380 = local_7[1u];
let _e1383 = (_e1170 + ((_e982 - _e1170) * _e1380));
let _e1384 = local_7[1u];
let _e1388 = local_7[2u];
let _e1392 = local_7[1u];
let _e1395 = (_e1035 + (((_e1181 + ((bitcast<f32>(_e1190) - _e1181) * _e1192)) - _e1035) * _e1392));
let _e1396 = local_7[1u];
let _e1400 = local_7[2u];
let _e1404 = local_7[1u];
let _e1407 = (_e1270 + (((_e1306 + ((bitcast<f32>(_e1315) - _e1306) * _e1317)) - _e1270) * _e1404));
let _e1408 = local_7[2u];
let _e1412 = local_7[1u];
let _e1416 = local_7[2u];
let _e1420 = local_7[2u];
let _e1428 = global_5.member[_e352].member_6.member_5;
let _e1434 = global_5.member[_e352].member_6.member_6;
let _e1435 = (((_e1350 + ((_e1354 - _e1350) * _e1420)) * _e1428) + _e1434);
let _e1437 = select(0f, _e1435, (_e1435 > 0f));
let _e1439 = select(1f, _e1437, (_e1437 < 1f));
let _e1441 = (((_e1358 + (((_e1084 + (((_e1103 + ((_e1113 - _e1103) * _e1134)) - _e1084) * _e1359)) - _e1358) * _e1364)) * _e1428) + _e1434);
let _e1443 = select(0f, _e1441, (_e1441 > 0f));
let _e1445 = select(1f, _e1443, (_e1443 < 1f));
let _e1447 = (((_e1371 + (((_e1092 + (((_e1123 + ((bitcast<f32>(_e1132) - _e1123) * _e1142)) - _e1092) * _e1372)) - _e1371) * _e1376)) * _e1428) + _e1434);
let _e1449 = select(0f, _e1447, (_e1447 > 0f));
let _e1451 = select(1f, _e1449, (_e1449 < 1f));
let _e1453 = (((_e1383 + (((_e1220 + ((_e1088 - _e1220) * _e1384)) - _e1383) * _e1388)) * _e1428) + _e1434);
let _e1455 = select(0f, _e1453, (_e1453 > 0f));
let _e1457 = select(1f, _e1455, (_e1455 < 1f));
let _e1459 = (((_e1395 + (((_e1141 + (((_e1231 + ((bitcast<f32>(_e1240) - _e1231) * _e1242)) - _e1141) * _e1396)) - _e1395) * _e1400)) * _e1428) + _e1434);
let _e1461 = select(0f, _e1459, (_e1459 > 0f));
let _e1463 = select(1f, _e1461, (_e1461 < 1f));
let _e1465 = (((_e1407 + ((_e1350 - _e1407) * _e1408)) * _e1428) + _e1434);
let _e1467 = select(0f, _e1465, (_e1465 > 0f));
let _e1469 = select(1f, _e1467, (_e1467 < 1f));
let _e1471 = (((_e1354 + (((_e1295 + (((_e1331 + ((bitcast<f32>(_e1340) - _e1331) * _e1342)) - _e1295) * _e1412)) - _e1354) * _e1416)) * _e1428) + _e1434);
let _e1473 = select(0f, _e1471, (_e1471 > 0f));
let _e1475 = select(1f, _e1473, (_e1473 < 1f));
let _e1476 = (_e1439 * 1024f);
let _e1477 = (1024f - 1f);
let _e1479 = select(0f, _e1476, (_e1476 > 0f));
let _e1481 = select(_e1477, _e1479, (_e1479 < _e1477));
let _e1488 = select(0i, select(select(i32(_e1481), i32(-2147483648), (_e1481 < -2147483600f)), 2147483647i, (_e1481 > 2147483500f)), (_e1481 == _e1481));
let _e1492 = (_e1488 - select(0i, 1i, (_e1481 < f32(_e1488))));
let _e1493 = (262147i + _e1492);
let _e1495 = (bitcast<i32>(_e123) - 1i);
let _e1497 = select(_e1495, _e1493, (_e1493 < _e1495));
let _e1503 = global_3.member[bitcast<u32>(select(0i, _e1497, (_e1497 > 0i)))];
let _e1513 = select(_e1495, 262146i, (262146i < _e1495));
let _e1519 = global_3.member[bitcast<u32>(select(0i, _e1513, (_e1513 > 0i)))];
let _e1520 = bitcast<f32>(_e1519);
let _e1521 = (f32((bitcast<i32>((_e1503 & 4095u)) - 2048i)) * _e1520);
let _e1523 = select(_e1495, 262144i, (262144i < _e1495));
let _e1529 = global_3.member[bitcast<u32>(select(0i, _e1523, (_e1523 > 0i)))];
let _e1530 = bitcast<f32>(_e1529);
let _e1532 = select(_e1495, 262145i, (262145i < _e1495));
let _e1538 = global_3.member[bitcast<u32>(select(0i, _e1532, (_e1532 > 0i)))];
let _e1539 = bitcast<f32>(_e1538);
let _e1545 = ((_e1530 + (f32(bitcast<i32>((_e1503 >> bitcast<u32>(12u)))) * _e1539)) + (_e1521 * (_e1476 - f32(_e1492))));
let _e1546 = (_e1521 * 1024f);
if _e800 {
let _e1553 = ((0.5f * (_e1451 - _e1445)) * _e1546);
let _e1554 = ((0.5f * (_e1463 - _e1457)) * _e1546);
let _e1555 = ((0.5f * (_e1475 - _e1469)) * _e1546);
phi_3423_ = type_29(_e1545, vec3<f32>(_e1553, _e1554, _e1555), vec3<f32>((_e1553 * _e1545), (_e1554 * _e1545), (_e1555 * _e1545)));
} else {
let _e1562 = (_e1445 * 1024f);
let _e1564 = select(0f, _e1562, (_e1562 > 0f));
let _e1566 = select(_e1477, _e1564, (_e1564 < _e1477));
let _e1573 = select(0i, select(select(i32(_e1566), i32(-2147483648), (_e1566 < -2147483600f)), 2147483647i, (_e1566 > 2147483500f)), (_e1566 == _e1566));
let _e1577 = (_e1573 - select(0i, 1i, (_e1566 < f32(_e1573))));
let _e1578 = (262147i + _e1577);
let _e1580 = select(_e1495, _e1578, (_e1578 < _e1495));
let _e1586 = global_3.member[bitcast<u32>(select(0i, _e1580, (_e1580 > 0i)))];
let _e1601 = ((_e1530 + (f32(bitcast<i32>((_e1586 >> bitcast<u32>(12u)))) * _e1539)) + ((f32((bitcast<i32>((_e1586 & 4095u)) - 2048i)) * _e1520) * (_e1562 - f32(_e1577))));
let _e1602 = (_e1451 * 1024f);
let _e1604 = select(0f, _e1602, (_e1602 > 0f));
let _e1606 = select(_e1477, _e1604, (_e1604 < _e1477));
let _e1613 = select(0i, select(select(i32(_e1606), i32(-2147483648), (_e1606 < -2147483600f)), 2147483647i, (_e1606 > 2147483500f)), (_e1606 == _e1606));
let _e1617 = (_e1613 - select(0i, 1i, (_e1606 < f32(_e1613))));
let _e1618 = (262147i + _e1617);
let _e1620 = select(_e1495, _e1618, (_e1618 < _e1495));
let _e1626 = global_3.member[bitcast<u32>(select(0i, _e1620, (_e1620 > 0i)))];
let _e1641 = ((_e1530 + (f32(bitcast<i32>((_e1626 >> bitcast<u32>(12u)))) * _e1539)) + ((f32((bitcast<i32>((_e1626 & 4095u)) - 2048i)) * _e1520) * (_e1602 - f32(_e1617))));
let _e1642 = (_e1457 * 1024f);
let _e1644 = select(0f, _e1642, (_e1642 > 0f));
let _e1646 = select(_e1477, _e1644, (_e1644 < _e1477));
let _e1653 = select(0i, select(select(i32(_e1646), i32(-2147483648), (_e1646 < -2147483600f)), 2147483647i, (_e1646 > 2147483500f)), (_e1646 == _e1646));
let _e1657 = (_e1653 - select(0i, 1i, (_e1646 < f32(_e1653))));
let _e1658 = (262147i + _e1657);
let _e1660 = select(_e1495, _e1658, (_e1658 < _e1495));
let _e1666 = global_3.member[bitcast<u32>(select(0i, _e1660, (_e1660 > 0i)))];
let _e1681 = ((_e1530 + (f32(bitcast<i32>((_e1666 >> bitcast<u32>(12u)))) * _e1539)) + ((f32((bitcast<i32>((_e1666 & 4095u)) - 2048i)) * _e1520) * (_e1642 - f32(_e1657))));
let _e1682 = (_e1463 * 1024f);
let _e1684 = select(0f, _e1682, (_e1682 > 0f));
let _e1686 = select(_e1477, _e1684, (_e1684 < _e1477));
let _e1693 = select(0i, select(select(i32(_e1686), i32(-2147483648), (_e1686 < -2147483600f)), 2147483647i, (_e1686 > 2147483500f)), (_e1686 == _e1686));
let _e1697 = (_e1693 - select(0i, 1i, (_e1686 < f32(_e1693))));
let _e1698 = (262147i + _e1697);
let _e1700 = select(_e1495, _e1698, (_e1698 < _e1495));
let _e1706 = global_3.member[bitcast<u32>(select(0i, _e1700, (_e1700 > 0i)))];
let _e1721 = ((_e1530 + (f32(bitcast<i32>((_e1706 >> bitcast<u32>(12u)))) * _e1539)) + ((f32((bitcast<i32>((_e1706 & 4095u)) - 2048i)) * _e1520) * (_e1682 - f32(_e1697))));
let _e1722 = (_e1469 * 1024f);
let _e1724 = select(0f, _e1722, (_e1722 > 0f));
let _e1726 = select(_e1477, _e1724, (_e1724 < _e1477));
let _e1733 = select(0i, select(select(i32(_e1726), i32(-2147483648), (_e1726 < -2147483600f)), 2147483647i, (_e1726 > 2147483500f)), (_e1726 == _e1726));
let _e1737 = (_e1733 - select(0i, 1i, (_e1726 < f32(_e1733))));
let _e1738 = (262147i + _e1737);
let _e1740 = select(_e1495, _e1738, (_e1738 < _e1495));
let _e1746 = global_3.member[bitcast<u32>(select(0i, _e1740, (_e1740 > 0i)))];
let _e1761 = ((_e1530 + (f32(bitcast<i32>((_e1746 >> bitcast<u32>(12u)))) * _e1539)) + ((f32((bitcast<i32>((_e1746 & 4095u)) - 2048i)) * _e1520) * (_e1722 - f32(_e1737))));
let _e1762 = (_e1475 * 1024f);
let _e1764 = select(0f, _e1762, (_e1762 > 0f));
let _e1766 = select(_e1477, _e1764, (_e1764 < _e1477));
let _e1773 = select(0i, select(select(i32(_e1766), i32(-2147483648), (_e1766 < -2147483600f)), 2147483647i, (_e1766 > 2147483500f)), (_e1766 == _e1766));
let _e1777 = (_e1773 - select(0i, 1i, (_e1766 < f32(_e1773))));
let _e1778 = (262147i + _e1777);
let _e1780 = select(_e1495, _e1778, (_e1778 < _e1495));
let _e1786 = global_3.member[bitcast<u32>(select(0i, _e1780, (_e1780 > 0i)))];
let _e1801 = ((_e1530 + (f32(bitcast<i32>((_e1786 >> bitcast<u32>(12u)))) * _e1539)) + ((f32((bitcast<i32>((_e1786 & 4095u)) - 2048i)) * _e1520) * (_e1762 - f32(_e1777))));
let _e1802 = (_e1641 - _e1601);
let _e1804 = (_e1721 - _e1681);
let _e1806 = (_e1801 - _e1761);
phi_3423_ = type_29(_e1545, vec3<f32>((0.5f * _e1802), (0.5f * _e1804), (0.5f * _e1806)), vec3<f32>((0.25f * (_e1802 * (_e1641 + _e1601))), (0.25f * (_e1804 * (_e1721 + _e1681))), (0.25f * (_e1806 * (_e1801 + _e1761)))));
}
let _e1821 = phi_3423_;
let _e1836 = select(0f, 1f, ((((((_e498 >= -0.5f) && (_e498 <= _e522)) && (_e504 >= -0.5f)) && (_e504 <= _e533)) && (_e510 >= -0.5f)) && (_e510 <= _e544)));
let _e1838 = (0.5f * (_e1451 - _e1445));
let _e1840 = (0.5f * (_e1463 - _e1457));
let _e1842 = (0.5f * (_e1475 - _e1469));
let _e1849 = global_5.member[_e352].member_6.member.member.member;
let _e1856 = global_5.member[_e352].member_6.member.member.member_1;
let _e1863 = global_5.member[_e352].member_6.member.member.member_2;
let _e1870 = global_5.member[_e352].member_6.member_1.member.member;
let _e1877 = global_5.member[_e352].member_6.member_1.member.member_1;
let _e1884 = global_5.member[_e352].member_6.member_1.member.member_2;
let _e1891 = global_5.member[_e352].member_6.member_2.member.member;
let _e1898 = global_5.member[_e352].member_6.member_2.member.member_1;
let _e1905 = global_5.member[_e352].member_6.member_2.member.member_2;
phi_4032_ = type_30(_e1439, vec3<f32>(((((_e1849 * _e1838) + (_e1870 * _e1840)) + (_e1891 * _e1842)) * _e1836), ((((_e1856 * _e1838) + (_e1877 * _e1840)) + (_e1898 * _e1842)) * _e1836), ((((_e1863 * _e1838) + (_e1884 * _e1840)) + (_e1905 * _e1842)) * _e1836)), _e1821.member, vec3<f32>(((((_e1849 * _e1821.member_2.x) + (_e1870 * _e1821.member_2.y)) + (_e1891 * _e1821.member_2.z)) * _e1836), ((((_e1856 * _e1821.member_2.x) + (_e1877 * _e1821.member_2.y)) + (_e1898 * _e1821.member_2.z)) * _e1836), ((((_e1863 * _e1821.member_2.x) + (_e1884 * _e1821.member_2.y)) + (_e1905 * _e1821.member_2.z)) * _e1836)), vec3<f32>(((((_e1849 * _e1821.member_1.x) + (_e1870 * _e1821.member_1.y)) + (_e1891 * _e1821.member_1.z)) * _e1836), ((((_e1856 * _e1821.member_1.x) + (_e1877 * _e1821.member_1.y)) + (_e1898 * _e1821.member_1.z)) * _e1836), ((((_e1863 * _e1821.member_1.x) + (_e1884 * _e1821.member_1.y)) + (_e1905 * _e1821.member_1.z)) * _e1836)));
} else {
let _e1971 = select(-1f, _e526, (_e526 > -1f));
let _e1973 = select(_e521, _e1971, (_e1971 < _e521));
let _e1980 = select(0i, select(select(i32(_e1973), i32(-2147483648), (_e1973 < -2147483600f)), 2147483647i, (_e1973 > 2147483500f)), (_e1973 == _e1973));
let _e1984 = (_e1980 - select(0i, 1i, (_e1973 < f32(_e1980))));
let _e1986 = select(-1f, _e537, (_e537 > -1f));
let _e1988 = select(_e532, _e1986, (_e1986 < _e532));
let _e1995 = select(0i, select(select(i32(_e1988), i32(-2147483648), (_e1988 < -2147483600f)), 2147483647i, (_e1988 > 2147483500f)), (_e1988 == _e1988));
let _e1999 = (_e1995 - select(0i, 1i, (_e1988 < f32(_e1995))));
let _e2001 = select(-1f, _e548, (_e548 > -1f));
let _e2003 = select(_e543, _e2001, (_e2001 < _e543));
let _e2010 = select(0i, select(select(i32(_e2003), i32(-2147483648), (_e2003 < -2147483600f)), 2147483647i, (_e2003 > 2147483500f)), (_e2003 == _e2003));
let _e2014 = (_e2010 - select(0i, 1i, (_e2003 < f32(_e2010))));
let _e2019 = global_5.member[_e352].member_6.member_7;
let _e2024 = global_5.member[_e352].member_6.member_8;
let _e2025 = (_e1984 + 1i);
let _e2026 = (_e1999 + 1i);
let _e2027 = (_e2014 + 1i);
let _e2033 = global_5.member[_e352].member_6.member_11.member;
let _e2040 = global_5.member[_e352].member_6.member_11.member_1;
let _e2051 = ((_e2025 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2033) * ((_e2026 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2040) * (_e2027 >> bitcast<u32>(4i))))));
let _e2053 = (bitcast<i32>(_e119) - 1i);
let _e2055 = select(_e2053, _e2051, (_e2051 < _e2053));
let _e2061 = global_1.member[bitcast<u32>(select(0i, _e2055, (_e2055 > 0i)))];
let _e2063 = (_e2025 & 15i);
let _e2066 = ((_e2026 & 15i) * _e2019);
let _e2068 = (bitcast<i32>(_e2061) + ((_e2027 & 15i) * _e2024));
let _e2072 = (_e2066 + _e2019);
let _e2074 = (_e2066 + (2i * _e2019));
let _e2075 = (_e2068 + _e2024);
let _e2077 = (_e2068 + (2i * _e2024));
local_4 = type_28(array<i32, 4>(_e2063, (_e2063 + 1i), (_e2063 + 2i), (_e2063 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_5 = vec3<f32>((_e526 - f32(_e1984)), (_e537 - f32(_e1999)), (_e548 - f32(_e2014)));
let _e2088 = (_e2075 + _e2072);
let _e2091 = local_4.member[1u];
let _e2092 = (_e2088 + _e2091);
let _e2094 = select(_e2053, _e2092, (_e2092 < _e2053));
let _e2099 = global_1.member[bitcast<u32>(select(0i, _e2094, (_e2094 > 0i)))];
let _e2100 = bitcast<f32>(_e2099);
let _e2103 = local_4.member[2u];
let _e2104 = (_e2088 + _e2103);
let _e2106 = select(_e2053, _e2104, (_e2104 < _e2053));
let _e2111 = global_1.member[bitcast<u32>(select(0i, _e2106, (_e2106 > 0i)))];
let _e2113 = local_5[0u];
let _e2116 = (_e2100 + ((bitcast<f32>(_e2111) - _e2100) * _e2113));
let _e2117 = (_e2075 + _e2074);
let _e2118 = local_4.member[1u];
let _e2119 = (_e2117 + _e2118);
let _e2121 = select(_e2053, _e2119, (_e2119 < _e2053));
let _e2126 = global_1.member[bitcast<u32>(select(0i, _e2121, (_e2121 > 0i)))];
let _e2127 = bitcast<f32>(_e2126);
let _e2128 = local_4.member[2u];
let _e2129 = (_e2117 + _e2128);
let _e2131 = select(_e2053, _e2129, (_e2129 < _e2053));
let _e2136 = global_1.member[bitcast<u32>(select(0i, _e2131, (_e2131 > 0i)))];
let _e2138 = local_5[0u];
let _e2143 = local_5[1u];
let _e2146 = (_e2116 + (((_e2127 + ((bitcast<f32>(_e2136) - _e2127) * _e2138)) - _e2116) * _e2143));
let _e2147 = (_e2077 + _e2072);
let _e2148 = local_4.member[1u];
let _e2149 = (_e2147 + _e2148);
let _e2151 = select(_e2053, _e2149, (_e2149 < _e2053));
let _e2156 = global_1.member[bitcast<u32>(select(0i, _e2151, (_e2151 > 0i)))];
let _e2157 = bitcast<f32>(_e2156);
let _e2158 = local_4.member[2u];
let _e2159 = (_e2147 + _e2158);
let _e2161 = select(_e2053, _e2159, (_e2159 < _e2053));
let _e2166 = global_1.member[bitcast<u32>(select(0i, _e2161, (_e2161 > 0i)))];
let _e2168 = local_5[0u];
let _e2171 = (_e2157 + ((bitcast<f32>(_e2166) - _e2157) * _e2168));
let _e2172 = (_e2077 + _e2074);
let _e2173 = local_4.member[1u];
let _e2174 = (_e2172 + _e2173);
let _e2176 = select(_e2053, _e2174, (_e2174 < _e2053));
let _e2181 = global_1.member[bitcast<u32>(select(0i, _e2176, (_e2176 > 0i)))];
let _e2182 = bitcast<f32>(_e2181);
let _e2183 = local_4.member[2u];
let _e2184 = (_e2172 + _e2183);
let _e2186 = select(_e2053, _e2184, (_e2184 < _e2053));
let _e2191 = global_1.member[bitcast<u32>(select(0i, _e2186, (_e2186 > 0i)))];
let _e2193 = local_5[0u];
let _e2197 = local_5[1u];
let _e2202 = local_5[2u];
let _e2210 = global_5.member[_e352].member_6.member_5;
let _e2216 = global_5.member[_e352].member_6.member_6;
let _e2217 = (((_e2146 + (((_e2171 + (((_e2182 + ((bitcast<f32>(_e2191) - _e2182) * _e2193)) - _e2171) * _e2197)) - _e2146) * _e2202)) * _e2210) + _e2216);
let _e2219 = select(0f, _e2217, (_e2217 > 0f));
phi_4032_ = type_30(select(1f, _e2219, (_e2219 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2224 = phi_4032_;
let _e2226 = select(-0.5f, _e460, (_e460 > -0.5f));
let _e2228 = select(_e522, _e2226, (_e2226 < _e522));
let _e2230 = select(-0.5f, _e476, (_e476 > -0.5f));
let _e2232 = select(_e533, _e2230, (_e2230 < _e533));
let _e2234 = select(-0.5f, _e492, (_e492 > -0.5f));
let _e2236 = select(_e544, _e2234, (_e2234 < _e544));
let _e2238 = select(-1f, _e2228, (_e2228 > -1f));
let _e2240 = select(_e521, _e2238, (_e2238 < _e521));
let _e2247 = select(0i, select(select(i32(_e2240), i32(-2147483648), (_e2240 < -2147483600f)), 2147483647i, (_e2240 > 2147483500f)), (_e2240 == _e2240));
let _e2251 = (_e2247 - select(0i, 1i, (_e2240 < f32(_e2247))));
let _e2253 = select(-1f, _e2232, (_e2232 > -1f));
let _e2255 = select(_e532, _e2253, (_e2253 < _e532));
let _e2262 = select(0i, select(select(i32(_e2255), i32(-2147483648), (_e2255 < -2147483600f)), 2147483647i, (_e2255 > 2147483500f)), (_e2255 == _e2255));
let _e2266 = (_e2262 - select(0i, 1i, (_e2255 < f32(_e2262))));
let _e2268 = select(-1f, _e2236, (_e2236 > -1f));
let _e2270 = select(_e543, _e2268, (_e2268 < _e543));
let _e2277 = select(0i, select(select(i32(_e2270), i32(-2147483648), (_e2270 < -2147483600f)), 2147483647i, (_e2270 > 2147483500f)), (_e2270 == _e2270));
let _e2281 = (_e2277 - select(0i, 1i, (_e2270 < f32(_e2277))));
let _e2286 = global_5.member[_e352].member_6.member_7;
let _e2291 = global_5.member[_e352].member_6.member_8;
let _e2292 = (_e2251 + 1i);
let _e2293 = (_e2266 + 1i);
let _e2294 = (_e2281 + 1i);
let _e2300 = global_5.member[_e352].member_6.member_11.member;
let _e2307 = global_5.member[_e352].member_6.member_11.member_1;
let _e2318 = ((_e2292 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2300) * ((_e2293 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2307) * (_e2294 >> bitcast<u32>(4i))))));
let _e2320 = (bitcast<i32>(_e119) - 1i);
let _e2322 = select(_e2320, _e2318, (_e2318 < _e2320));
let _e2328 = global_1.member[bitcast<u32>(select(0i, _e2322, (_e2322 > 0i)))];
let _e2330 = (_e2292 & 15i);
let _e2333 = ((_e2293 & 15i) * _e2286);
let _e2335 = (bitcast<i32>(_e2328) + ((_e2294 & 15i) * _e2291));
let _e2339 = (_e2333 + _e2286);
let _e2341 = (_e2333 + (2i * _e2286));
let _e2342 = (_e2335 + _e2291);
let _e2344 = (_e2335 + (2i * _e2291));
local_2 = type_28(array<i32, 4>(_e2330, (_e2330 + 1i), (_e2330 + 2i), (_e2330 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_3 = vec3<f32>((_e2228 - f32(_e2251)), (_e2232 - f32(_e2266)), (_e2236 - f32(_e2281)));
let _e2355 = (_e2342 + _e2339);
let _e2358 = local_2.member[1u];
let _e2359 = (_e2355 + _e2358);
let _e2361 = select(_e2320, _e2359, (_e2359 < _e2320));
let _e2366 = global_1.member[bitcast<u32>(select(0i, _e2361, (_e2361 > 0i)))];
let _e2367 = bitcast<f32>(_e2366);
let _e2370 = local_2.member[2u];
let _e2371 = (_e2355 + _e2370);
let _e2373 = select(_e2320, _e2371, (_e2371 < _e2320));
let _e2378 = global_1.member[bitcast<u32>(select(0i, _e2373, (_e2373 > 0i)))];
let _e2380 = local_3[0u];
let _e2383 = (_e2367 + ((bitcast<f32>(_e2378) - _e2367) * _e2380));
let _e2384 = (_e2342 + _e2341);
let _e2385 = local_2.member[1u];
let _e2386 = (_e2384 + _e2385);
let _e2388 = select(_e2320, _e2386, (_e2386 < _e2320));
let _e2393 = global_1.member[bitcast<u32>(select(0i, _e2388, (_e2388 > 0i)))];
let _e2394 = bitcast<f32>(_e2393);
let _e2395 = local_2.member[2u];
let _e2396 = (_e2384 + _e2395);
let _e2398 = select(_e2320, _e2396, (_e2396 < _e2320));
let _e2403 = global_1.member[bitcast<u32>(select(0i, _e2398, (_e2398 > 0i)))];
let _e2405 = local_3[0u];
let _e2410 = local_3[1u];
let _e2413 = (_e2383 + (((_e2394 + ((bitcast<f32>(_e2403) - _e2394) * _e2405)) - _e2383) * _e2410));
let _e2414 = (_e2344 + _e2339);
let _e2415 = local_2.member[1u];
let _e2416 = (_e2414 + _e2415);
let _e2418 = select(_e2320, _e2416, (_e2416 < _e2320));
let _e2423 = global_1.member[bitcast<u32>(select(0i, _e2418, (_e2418 > 0i)))];
let _e2424 = bitcast<f32>(_e2423);
let _e2425 = local_2.member[2u];
let _e2426 = (_e2414 + _e2425);
let _e2428 = select(_e2320, _e2426, (_e2426 < _e2320));
let _e2433 = global_1.member[bitcast<u32>(select(0i, _e2428, (_e2428 > 0i)))];
let _e2435 = local_3[0u];
let _e2438 = (_e2424 + ((bitcast<f32>(_e2433) - _e2424) * _e2435));
let _e2439 = (_e2344 + _e2341);
let _e2440 = local_2.member[1u];
let _e2441 = (_e2439 + _e2440);
let _e2443 = select(_e2320, _e2441, (_e2441 < _e2320));
let _e2448 = global_1.member[bitcast<u32>(select(0i, _e2443, (_e2443 > 0i)))];
let _e2449 = bitcast<f32>(_e2448);
let _e2450 = local_2.member[2u];
let _e2451 = (_e2439 + _e2450);
let _e2453 = select(_e2320, _e2451, (_e2451 < _e2320));
let _e2458 = global_1.member[bitcast<u32>(select(0i, _e2453, (_e2453 > 0i)))];
let _e2460 = local_3[0u];
let _e2464 = local_3[1u];
let _e2469 = local_3[2u];
let _e2477 = global_5.member[_e352].member_6.member_5;
let _e2483 = global_5.member[_e352].member_6.member_6;
let _e2484 = (((_e2413 + (((_e2438 + (((_e2449 + ((bitcast<f32>(_e2458) - _e2449) * _e2460)) - _e2438) * _e2464)) - _e2413) * _e2469)) * _e2477) + _e2483);
let _e2486 = select(0f, _e2484, (_e2484 > 0f));
let _e2488 = select(1f, _e2486, (_e2486 < 1f));
let _e2489 = select(_e356[6], _e2488, _e719);
if _e803 {
let _e2490 = (_e2488 * 1024f);
let _e2491 = (1024f - 1f);
let _e2493 = select(0f, _e2490, (_e2490 > 0f));
let _e2495 = select(_e2491, _e2493, (_e2493 < _e2491));
let _e2502 = select(0i, select(select(i32(_e2495), i32(-2147483648), (_e2495 < -2147483600f)), 2147483647i, (_e2495 > 2147483500f)), (_e2495 == _e2495));
let _e2506 = (_e2502 - select(0i, 1i, (_e2495 < f32(_e2502))));
let _e2507 = (262147i + _e2506);
let _e2509 = (bitcast<i32>(_e123) - 1i);
let _e2511 = select(_e2509, _e2507, (_e2507 < _e2509));
let _e2517 = global_3.member[bitcast<u32>(select(0i, _e2511, (_e2511 > 0i)))];
let _e2527 = select(_e2509, 262146i, (262146i < _e2509));
let _e2533 = global_3.member[bitcast<u32>(select(0i, _e2527, (_e2527 > 0i)))];
let _e2537 = select(_e2509, 262144i, (262144i < _e2509));
let _e2543 = global_3.member[bitcast<u32>(select(0i, _e2537, (_e2537 > 0i)))];
let _e2546 = select(_e2509, 262145i, (262145i < _e2509));
let _e2552 = global_3.member[bitcast<u32>(select(0i, _e2546, (_e2546 > 0i)))];
phi_4578_ = select(_e356[16], ((bitcast<f32>(_e2543) + (f32(bitcast<i32>((_e2517 >> bitcast<u32>(12u)))) * bitcast<f32>(_e2552))) + ((f32((bitcast<i32>((_e2517 & 4095u)) - 2048i)) * bitcast<f32>(_e2533)) * (_e2490 - f32(_e2506)))), _e719);
} else {
phi_4578_ = _e356[16];
}
let _e2562 = phi_4578_;
let _e2565 = select(1f, select(1f, _e798, (_e798 < 1f)), _e444);
if ((_e687 & 16u) == 0u) {
phi_4967_ = type_5(1f, 1f, 1f);
} else {
let _e2572 = global_5.member[_e352].member_14.member;
let _e2583 = ((((_e2572.member.member * _e380) + (_e2572.member.member_1 * _e382)) + (_e2572.member.member_2 * _e376)) + _e2572.member_1);
let _e2589 = ((((_e2572.member.member * _e384) + (_e2572.member.member_1 * _e386)) + (_e2572.member.member_2 * _e391)) + _e2572.member_1);
let _e2591 = select(_e2589, _e2583, (_e2583 < _e2589));
let _e2593 = select(_e2589, _e2583, (_e2583 > _e2589));
let _e2595 = (_e2593 - _e2591);
let _e2598 = (-(_e2591) / select(1e-30f, _e2595, (_e2595 > 1e-30f)));
let _e2600 = select(0f, _e2598, (_e2598 > 0f));
let _e2606 = select(select(select(1f, _e2600, (_e2600 < 1f)), 1f, (_e2593 <= 0f)), 0f, (_e2591 > 0f));
let _e2612 = global_5.member[_e352].member_14.member_1;
let _e2613 = (_e2612 != 0u);
let _e2624 = global_5.member[_e352].member_15.member;
let _e2635 = ((((_e2624.member.member * _e380) + (_e2624.member.member_1 * _e382)) + (_e2624.member.member_2 * _e376)) + _e2624.member_1);
let _e2641 = ((((_e2624.member.member * _e384) + (_e2624.member.member_1 * _e386)) + (_e2624.member.member_2 * _e391)) + _e2624.member_1);
let _e2643 = select(_e2641, _e2635, (_e2635 < _e2641));
let _e2645 = select(_e2641, _e2635, (_e2635 > _e2641));
let _e2647 = (_e2645 - _e2643);
let _e2650 = (-(_e2643) / select(1e-30f, _e2647, (_e2647 > 1e-30f)));
let _e2652 = select(0f, _e2650, (_e2650 > 0f));
let _e2658 = select(select(select(1f, _e2652, (_e2652 < 1f)), 1f, (_e2645 <= 0f)), 0f, (_e2643 > 0f));
let _e2664 = global_5.member[_e352].member_15.member_1;
let _e2665 = (_e2664 != 0u);
let _e2676 = global_5.member[_e352].member_16.member;
let _e2687 = ((((_e2676.member.member * _e380) + (_e2676.member.member_1 * _e382)) + (_e2676.member.member_2 * _e376)) + _e2676.member_1);
let _e2693 = ((((_e2676.member.member * _e384) + (_e2676.member.member_1 * _e386)) + (_e2676.member.member_2 * _e391)) + _e2676.member_1);
let _e2695 = select(_e2693, _e2687, (_e2687 < _e2693));
let _e2697 = select(_e2693, _e2687, (_e2687 > _e2693));
let _e2699 = (_e2697 - _e2695);
let _e2702 = (-(_e2695) / select(1e-30f, _e2699, (_e2699 > 1e-30f)));
let _e2704 = select(0f, _e2702, (_e2702 > 0f));
let _e2710 = select(select(select(1f, _e2704, (_e2704 < 1f)), 1f, (_e2697 <= 0f)), 0f, (_e2695 > 0f));
let _e2716 = global_5.member[_e352].member_16.member_1;
let _e2717 = (_e2716 != 0u);
let _e2728 = global_5.member[_e352].member_17.member;
let _e2739 = ((((_e2728.member.member * _e380) + (_e2728.member.member_1 * _e382)) + (_e2728.member.member_2 * _e376)) + _e2728.member_1);
let _e2745 = ((((_e2728.member.member * _e384) + (_e2728.member.member_1 * _e386)) + (_e2728.member.member_2 * _e391)) + _e2728.member_1);
let _e2747 = select(_e2745, _e2739, (_e2739 < _e2745));
let _e2749 = select(_e2745, _e2739, (_e2739 > _e2745));
let _e2751 = (_e2749 - _e2747);
let _e2754 = (-(_e2747) / select(1e-30f, _e2751, (_e2751 > 1e-30f)));
let _e2756 = select(0f, _e2754, (_e2754 > 0f));
let _e2762 = select(select(select(1f, _e2756, (_e2756 < 1f)), 1f, (_e2749 <= 0f)), 0f, (_e2747 > 0f));
let _e2768 = global_5.member[_e352].member_17.member_1;
let _e2769 = (_e2768 != 0u);
phi_4967_ = type_5(((((1f * _e2606) * _e2658) * _e2710) * _e2762), ((((1f * select(1f, _e2606, _e2613)) * select(1f, _e2658, _e2665)) * select(1f, _e2710, _e2717)) * select(1f, _e2762, _e2769)), ((((1f * select(1f, 0f, (_e2613 && (_e2589 > 0f)))) * select(1f, 0f, (_e2665 && (_e2641 > 0f)))) * select(1f, 0f, (_e2717 && (_e2693 > 0f)))) * select(1f, 0f, (_e2769 && (_e2745 > 0f)))));
}
let _e2778 = phi_4967_;
let _e2779 = (_e554 < 1e-12f);
let _e2781 = (1f / select(_e549, 1f, _e2779));
let _e2783 = ((-0.5f - _e460) * _e2781);
let _e2785 = ((_e522 - _e460) * _e2781);
let _e2791 = select(_e2785, _e2783, (_e2783 < _e2785));
let _e2793 = select(0f, _e2791, (_e2791 > 0f));
let _e2796 = select(select(1f, _e2793, (_e2793 < 1f)), select(2f, 0f, ((_e460 >= -0.5f) && (_e460 <= _e522))), _e2779);
let _e2798 = select(_e2785, _e2783, (_e2783 > _e2785));
let _e2800 = select(0f, _e2798, (_e2798 > 0f));
let _e2803 = select(select(1f, _e2800, (_e2800 < 1f)), 1f, _e2779);
let _e2804 = (_e557 < 1e-12f);
let _e2806 = (1f / select(_e550, 1f, _e2804));
let _e2808 = ((-0.5f - _e476) * _e2806);
let _e2810 = ((_e533 - _e476) * _e2806);
let _e2816 = select(_e2810, _e2808, (_e2808 < _e2810));
let _e2818 = select(0f, _e2816, (_e2816 > 0f));
let _e2821 = select(select(1f, _e2818, (_e2818 < 1f)), select(2f, 0f, ((_e476 >= -0.5f) && (_e476 <= _e533))), _e2804);
let _e2823 = select(_e2810, _e2808, (_e2808 > _e2810));
let _e2825 = select(0f, _e2823, (_e2823 > 0f));
let _e2828 = select(select(1f, _e2825, (_e2825 < 1f)), 1f, _e2804);
let _e2829 = (_e562 < 1e-12f);
let _e2831 = (1f / select(_e551, 1f, _e2829));
let _e2833 = ((-0.5f - _e492) * _e2831);
let _e2835 = ((_e544 - _e492) * _e2831);
let _e2841 = select(_e2835, _e2833, (_e2833 < _e2835));
let _e2843 = select(0f, _e2841, (_e2841 > 0f));
let _e2846 = select(select(1f, _e2843, (_e2843 < 1f)), select(2f, 0f, ((_e492 >= -0.5f) && (_e492 <= _e544))), _e2829);
let _e2848 = select(_e2835, _e2833, (_e2833 > _e2835));
let _e2850 = select(0f, _e2848, (_e2848 > 0f));
let _e2853 = select(select(1f, _e2850, (_e2850 < 1f)), 1f, _e2829);
let _e2855 = select(_e2828, _e2803, (_e2803 < _e2828));
let _e2859 = select(_e2821, _e2796, (_e2796 > _e2821));
let _e2862 = (select(_e2853, _e2855, (_e2855 < _e2853)) - select(_e2846, _e2859, (_e2859 > _e2846)));
let _e2865 = (_e384 - _e380);
let _e2866 = (_e386 - _e382);
let _e2867 = (_e391 - _e376);
let _e2872 = (((_e2865 * _e2865) + (_e2866 * _e2866)) + (_e2867 * _e2867));
let _e2882 = global_5.member[_e352].member_5.member_3;
let _e2883 = (((sqrt(select(0f, _e2872, (_e2872 > 0f))) * select(0f, _e2862, (_e2862 > 0f))) * _e2565) * _e2882);
let _e2884 = (_e729.member_2 >= 3u);
if _e2884 {
let _e2886 = (_e2489 * 255f);
let _e2887 = (_e2224.member * 255f);
let _e2888 = (255f - 1f);
let _e2890 = select(0f, _e2886, (_e2886 > 0f));
let _e2892 = select(_e2888, _e2890, (_e2890 < _e2888));
let _e2899 = select(0i, select(select(i32(_e2892), i32(-2147483648), (_e2892 < -2147483600f)), 2147483647i, (_e2892 > 2147483500f)), (_e2892 == _e2892));
let _e2903 = (_e2899 - select(0i, 1i, (_e2892 < f32(_e2899))));
let _e2905 = select(0f, _e2887, (_e2887 > 0f));
let _e2907 = select(_e2888, _e2905, (_e2905 < _e2888));
let _e2914 = select(0i, select(select(i32(_e2907), i32(-2147483648), (_e2907 < -2147483600f)), 2147483647i, (_e2907 > 2147483500f)), (_e2907 == _e2907));
let _e2918 = (_e2914 - select(0i, 1i, (_e2907 < f32(_e2914))));
let _e2921 = (((_e2903 * 256i) + _e2918) * 4i);
let _e2923 = (_e2886 - f32(_e2903));
let _e2925 = (_e2887 - f32(_e2918));
let _e2926 = (_e2921 + 2i);
let _e2928 = (bitcast<i32>(_e123) - 1i);
let _e2930 = select(_e2928, _e2926, (_e2926 < _e2928));
let _e2936 = global_3.member[bitcast<u32>(select(0i, _e2930, (_e2930 > 0i)))];
let _e2937 = (_e2921 + 6i);
let _e2939 = select(_e2928, _e2937, (_e2937 < _e2928));
let _e2945 = global_3.member[bitcast<u32>(select(0i, _e2939, (_e2939 > 0i)))];
let _e2946 = (_e2921 + 1026i);
let _e2948 = select(_e2928, _e2946, (_e2946 < _e2928));
let _e2954 = global_3.member[bitcast<u32>(select(0i, _e2948, (_e2948 > 0i)))];
let _e2955 = (_e2921 + 1030i);
let _e2957 = select(_e2928, _e2955, (_e2955 < _e2928));
let _e2963 = global_3.member[bitcast<u32>(select(0i, _e2957, (_e2957 > 0i)))];
let _e2968 = (bitcast<f32>(((_e2936 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2976 = (_e2968 + (((bitcast<f32>(((_e2945 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2968) * _e2925));
let _e2981 = (bitcast<f32>(((_e2954 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3005 = (bitcast<f32>((((_e2936 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3013 = (_e3005 + (((bitcast<f32>((((_e2945 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3005) * _e2925));
let _e3018 = (bitcast<f32>((((_e2954 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3030 = (_e2921 + 3i);
let _e3032 = select(_e2928, _e3030, (_e3030 < _e2928));
let _e3038 = global_3.member[bitcast<u32>(select(0i, _e3032, (_e3032 > 0i)))];
let _e3039 = (_e2921 + 7i);
let _e3041 = select(_e2928, _e3039, (_e3039 < _e2928));
let _e3047 = global_3.member[bitcast<u32>(select(0i, _e3041, (_e3041 > 0i)))];
let _e3048 = (_e2921 + 1027i);
let _e3050 = select(_e2928, _e3048, (_e3048 < _e2928));
let _e3056 = global_3.member[bitcast<u32>(select(0i, _e3050, (_e3050 > 0i)))];
let _e3057 = (_e2921 + 1031i);
let _e3059 = select(_e2928, _e3057, (_e3057 < _e2928));
let _e3065 = global_3.member[bitcast<u32>(select(0i, _e3059, (_e3059 > 0i)))];
let _e3070 = (bitcast<f32>(((_e3038 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3078 = (_e3070 + (((bitcast<f32>(((_e3047 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3070) * _e2925));
let _e3083 = (bitcast<f32>(((_e3056 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3107 = (bitcast<f32>((((_e3038 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3115 = (_e3107 + (((bitcast<f32>((((_e3047 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3107) * _e2925));
let _e3120 = (bitcast<f32>((((_e3056 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3131 = (_e3115 + (((_e3120 + (((bitcast<f32>((((_e3065 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3120) * _e2925)) - _e3115) * _e2923));
let _e3135 = -((_e3131 * (_e2883 * _e2778.member)));
let _e3137 = select(-87f, _e3135, (_e3135 > -87f));
let _e3139 = select(88f, _e3137, (_e3137 < 88f));
let _e3141 = ((_e3139 * 1.442695f) + 0.5f);
let _e3143 = select(-127f, _e3141, (_e3141 > -127f));
let _e3145 = select(128f, _e3143, (_e3143 < 128f));
let _e3152 = select(0i, select(select(i32(_e3145), i32(-2147483648), (_e3145 < -2147483600f)), 2147483647i, (_e3145 > 2147483500f)), (_e3145 == _e3145));
let _e3156 = (_e3152 - select(0i, 1i, (_e3145 < f32(_e3152))));
let _e3157 = f32(_e3156);
let _e3161 = ((_e3139 - (_e3157 * 0.6933594f)) - (_e3157 * -2.1219444e-4f));
let _e3181 = ((1f + (_e3161 * (1f + (_e3161 * (0.5f + (_e3161 * (0.16666667f + (_e3161 * (0.041666668f + (_e3161 * (0.008333334f + (_e3161 * (0.001388889f + (_e3161 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3156 + 127i)) << bitcast<u32>(23i))));
let _e3182 = (1f - _e3181);
let _e3185 = (_e3182 / select(1e-12f, _e3131, (_e3131 > 1e-12f)));
phi_6525_ = type_31(_e3181, _e3182, vec3<f32>(1f, 1f, 1f), vec3<f32>(((_e2976 + (((_e2981 + (((bitcast<f32>(((_e2963 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2981) * _e2925)) - _e2976) * _e2923)) * _e3185), ((_e3013 + (((_e3018 + (((bitcast<f32>((((_e2963 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3018) * _e2925)) - _e3013) * _e2923)) * _e3185), ((_e3078 + (((_e3083 + (((bitcast<f32>(((_e3065 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3083) * _e2925)) - _e3078) * _e2923)) * _e3185)));
} else {
let _e3192 = (_e2489 * 255f);
let _e3193 = (_e2224.member * 255f);
let _e3194 = (255f - 1f);
let _e3196 = select(0f, _e3192, (_e3192 > 0f));
let _e3198 = select(_e3194, _e3196, (_e3196 < _e3194));
let _e3205 = select(0i, select(select(i32(_e3198), i32(-2147483648), (_e3198 < -2147483600f)), 2147483647i, (_e3198 > 2147483500f)), (_e3198 == _e3198));
let _e3209 = (_e3205 - select(0i, 1i, (_e3198 < f32(_e3205))));
let _e3211 = select(0f, _e3193, (_e3193 > 0f));
let _e3213 = select(_e3194, _e3211, (_e3211 < _e3194));
let _e3220 = select(0i, select(select(i32(_e3213), i32(-2147483648), (_e3213 < -2147483600f)), 2147483647i, (_e3213 > 2147483500f)), (_e3213 == _e3213));
let _e3224 = (_e3220 - select(0i, 1i, (_e3213 < f32(_e3220))));
let _e3227 = (((_e3209 * 256i) + _e3224) * 4i);
let _e3229 = (_e3192 - f32(_e3209));
let _e3231 = (_e3193 - f32(_e3224));
let _e3233 = (bitcast<i32>(_e123) - 1i);
let _e3235 = select(_e3233, _e3227, (_e3227 < _e3233));
let _e3241 = global_3.member[bitcast<u32>(select(0i, _e3235, (_e3235 > 0i)))];
let _e3242 = (_e3227 + 4i);
let _e3244 = select(_e3233, _e3242, (_e3242 < _e3233));
let _e3250 = global_3.member[bitcast<u32>(select(0i, _e3244, (_e3244 > 0i)))];
let _e3251 = (_e3227 + 1024i);
let _e3253 = select(_e3233, _e3251, (_e3251 < _e3233));
let _e3259 = global_3.member[bitcast<u32>(select(0i, _e3253, (_e3253 > 0i)))];
let _e3260 = (_e3227 + 1028i);
let _e3262 = select(_e3233, _e3260, (_e3260 < _e3233));
let _e3268 = global_3.member[bitcast<u32>(select(0i, _e3262, (_e3262 > 0i)))];
let _e3273 = (bitcast<f32>(((_e3241 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3281 = (_e3273 + (((bitcast<f32>(((_e3250 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3273) * _e3231));
let _e3286 = (bitcast<f32>(((_e3259 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3297 = (_e3281 + (((_e3286 + (((bitcast<f32>(((_e3268 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3286) * _e3231)) - _e3281) * _e3229));
let _e3310 = (bitcast<f32>((((_e3241 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3318 = (_e3310 + (((bitcast<f32>((((_e3250 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3310) * _e3231));
let _e3323 = (bitcast<f32>((((_e3259 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3335 = (_e3227 + 1i);
let _e3337 = select(_e3233, _e3335, (_e3335 < _e3233));
let _e3343 = global_3.member[bitcast<u32>(select(0i, _e3337, (_e3337 > 0i)))];
let _e3344 = (_e3227 + 5i);
let _e3346 = select(_e3233, _e3344, (_e3344 < _e3233));
let _e3352 = global_3.member[bitcast<u32>(select(0i, _e3346, (_e3346 > 0i)))];
let _e3353 = (_e3227 + 1025i);
let _e3355 = select(_e3233, _e3353, (_e3353 < _e3233));
let _e3361 = global_3.member[bitcast<u32>(select(0i, _e3355, (_e3355 > 0i)))];
let _e3362 = (_e3227 + 1029i);
let _e3364 = select(_e3233, _e3362, (_e3362 < _e3233));
let _e3370 = global_3.member[bitcast<u32>(select(0i, _e3364, (_e3364 > 0i)))];
let _e3375 = (bitcast<f32>(((_e3343 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3383 = (_e3375 + (((bitcast<f32>(((_e3352 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3375) * _e3231));
let _e3388 = (bitcast<f32>(((_e3361 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3412 = (bitcast<f32>((((_e3343 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3420 = (_e3412 + (((bitcast<f32>((((_e3352 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3412) * _e3231));
let _e3425 = (bitcast<f32>((((_e3361 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3437 = (_e3227 + 2i);
let _e3439 = select(_e3233, _e3437, (_e3437 < _e3233));
let _e3445 = global_3.member[bitcast<u32>(select(0i, _e3439, (_e3439 > 0i)))];
let _e3446 = (_e3227 + 6i);
let _e3448 = select(_e3233, _e3446, (_e3446 < _e3233));
let _e3454 = global_3.member[bitcast<u32>(select(0i, _e3448, (_e3448 > 0i)))];
let _e3455 = (_e3227 + 1026i);
let _e3457 = select(_e3233, _e3455, (_e3455 < _e3233));
let _e3463 = global_3.member[bitcast<u32>(select(0i, _e3457, (_e3457 > 0i)))];
let _e3464 = (_e3227 + 1030i);
let _e3466 = select(_e3233, _e3464, (_e3464 < _e3233));
let _e3472 = global_3.member[bitcast<u32>(select(0i, _e3466, (_e3466 > 0i)))];
let _e3477 = (bitcast<f32>(((_e3445 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3485 = (_e3477 + (((bitcast<f32>(((_e3454 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3477) * _e3231));
let _e3490 = (bitcast<f32>(((_e3463 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3514 = (bitcast<f32>((((_e3445 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3522 = (_e3514 + (((bitcast<f32>((((_e3454 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3514) * _e3231));
let _e3527 = (bitcast<f32>((((_e3463 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3539 = (_e3227 + 3i);
let _e3541 = select(_e3233, _e3539, (_e3539 < _e3233));
let _e3547 = global_3.member[bitcast<u32>(select(0i, _e3541, (_e3541 > 0i)))];
let _e3548 = (_e3227 + 7i);
let _e3550 = select(_e3233, _e3548, (_e3548 < _e3233));
let _e3556 = global_3.member[bitcast<u32>(select(0i, _e3550, (_e3550 > 0i)))];
let _e3557 = (_e3227 + 1027i);
let _e3559 = select(_e3233, _e3557, (_e3557 < _e3233));
let _e3565 = global_3.member[bitcast<u32>(select(0i, _e3559, (_e3559 > 0i)))];
let _e3566 = (_e3227 + 1031i);
let _e3568 = select(_e3233, _e3566, (_e3566 < _e3233));
let _e3574 = global_3.member[bitcast<u32>(select(0i, _e3568, (_e3568 > 0i)))];
let _e3579 = (bitcast<f32>(((_e3547 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3587 = (_e3579 + (((bitcast<f32>(((_e3556 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3579) * _e3231));
let _e3592 = (bitcast<f32>(((_e3565 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3607 = (_e2883 * _e2778.member_1);
let _e3609 = -(((_e3318 + (((_e3323 + (((bitcast<f32>((((_e3268 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3323) * _e3231)) - _e3318) * _e3229)) * _e3607));
let _e3611 = select(-87f, _e3609, (_e3609 > -87f));
let _e3613 = select(88f, _e3611, (_e3611 < 88f));
let _e3615 = ((_e3613 * 1.442695f) + 0.5f);
let _e3617 = select(-127f, _e3615, (_e3615 > -127f));
let _e3619 = select(128f, _e3617, (_e3617 < 128f));
let _e3626 = select(0i, select(select(i32(_e3619), i32(-2147483648), (_e3619 < -2147483600f)), 2147483647i, (_e3619 > 2147483500f)), (_e3619 == _e3619));
let _e3630 = (_e3626 - select(0i, 1i, (_e3619 < f32(_e3626))));
let _e3631 = f32(_e3630);
let _e3635 = ((_e3613 - (_e3631 * 0.6933594f)) - (_e3631 * -2.1219444e-4f));
let _e3657 = -(((_e3383 + (((_e3388 + (((bitcast<f32>(((_e3370 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3388) * _e3231)) - _e3383) * _e3229)) * _e3607));
let _e3659 = select(-87f, _e3657, (_e3657 > -87f));
let _e3661 = select(88f, _e3659, (_e3659 < 88f));
let _e3663 = ((_e3661 * 1.442695f) + 0.5f);
let _e3665 = select(-127f, _e3663, (_e3663 > -127f));
let _e3667 = select(128f, _e3665, (_e3665 < 128f));
let _e3674 = select(0i, select(select(i32(_e3667), i32(-2147483648), (_e3667 < -2147483600f)), 2147483647i, (_e3667 > 2147483500f)), (_e3667 == _e3667));
let _e3678 = (_e3674 - select(0i, 1i, (_e3667 < f32(_e3674))));
let _e3679 = f32(_e3678);
let _e3683 = ((_e3661 - (_e3679 * 0.6933594f)) - (_e3679 * -2.1219444e-4f));
let _e3705 = -(((_e3420 + (((_e3425 + (((bitcast<f32>((((_e3370 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3425) * _e3231)) - _e3420) * _e3229)) * _e3607));
let _e3707 = select(-87f, _e3705, (_e3705 > -87f));
let _e3709 = select(88f, _e3707, (_e3707 < 88f));
let _e3711 = ((_e3709 * 1.442695f) + 0.5f);
let _e3713 = select(-127f, _e3711, (_e3711 > -127f));
let _e3715 = select(128f, _e3713, (_e3713 < 128f));
let _e3722 = select(0i, select(select(i32(_e3715), i32(-2147483648), (_e3715 < -2147483600f)), 2147483647i, (_e3715 > 2147483500f)), (_e3715 == _e3715));
let _e3726 = (_e3722 - select(0i, 1i, (_e3715 < f32(_e3722))));
let _e3727 = f32(_e3726);
let _e3731 = ((_e3709 - (_e3727 * 0.6933594f)) - (_e3727 * -2.1219444e-4f));
let _e3754 = -((_e3297 * (_e2883 * _e2778.member)));
let _e3756 = select(-87f, _e3754, (_e3754 > -87f));
let _e3758 = select(88f, _e3756, (_e3756 < 88f));
let _e3760 = ((_e3758 * 1.442695f) + 0.5f);
let _e3762 = select(-127f, _e3760, (_e3760 > -127f));
let _e3764 = select(128f, _e3762, (_e3762 < 128f));
let _e3771 = select(0i, select(select(i32(_e3764), i32(-2147483648), (_e3764 < -2147483600f)), 2147483647i, (_e3764 > 2147483500f)), (_e3764 == _e3764));
let _e3775 = (_e3771 - select(0i, 1i, (_e3764 < f32(_e3771))));
let _e3776 = f32(_e3775);
let _e3780 = ((_e3758 - (_e3776 * 0.6933594f)) - (_e3776 * -2.1219444e-4f));
let _e3800 = ((1f + (_e3780 * (1f + (_e3780 * (0.5f + (_e3780 * (0.16666667f + (_e3780 * (0.041666668f + (_e3780 * (0.008333334f + (_e3780 * (0.001388889f + (_e3780 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3775 + 127i)) << bitcast<u32>(23i))));
let _e3801 = (1f - _e3800);
let _e3804 = (_e3801 / select(1e-12f, _e3297, (_e3297 > 1e-12f)));
phi_6525_ = type_31(_e3800, _e3801, vec3<f32>(((1f + (_e3635 * (1f + (_e3635 * (0.5f + (_e3635 * (0.16666667f + (_e3635 * (0.041666668f + (_e3635 * (0.008333334f + (_e3635 * (0.001388889f + (_e3635 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3630 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e3683 * (1f + (_e3683 * (0.5f + (_e3683 * (0.16666667f + (_e3683 * (0.041666668f + (_e3683 * (0.008333334f + (_e3683 * (0.001388889f + (_e3683 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3678 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e3731 * (1f + (_e3731 * (0.5f + (_e3731 * (0.16666667f + (_e3731 * (0.041666668f + (_e3731 * (0.008333334f + (_e3731 * (0.001388889f + (_e3731 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3726 + 127i)) << bitcast<u32>(23i))))), vec3<f32>(((_e3485 + (((_e3490 + (((bitcast<f32>(((_e3472 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3490) * _e3231)) - _e3485) * _e3229)) * _e3804), ((_e3522 + (((_e3527 + (((bitcast<f32>((((_e3472 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3527) * _e3231)) - _e3522) * _e3229)) * _e3804), ((_e3587 + (((_e3592 + (((bitcast<f32>(((_e3574 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3592) * _e3231)) - _e3587) * _e3229)) * _e3804)));
}
let _e3811 = phi_6525_;
let _e3812 = select(0f, _e2565, _e444);
let _e3816 = (_e380 + (_e2865 * _e3812));
let _e3817 = (_e382 + (_e2866 * _e3812));
let _e3818 = (_e376 + (_e2867 * _e3812));
if (_e729.member_2 == 3u) {
let _e3824 = global_5.member[_e352].member_9.member_1;
let _e3833 = global_5.member[_e352].member_9.member;
phi_7508_ = type_25(vec3<f32>(_e3824.member, _e3824.member_1, _e3824.member_2), vec3<f32>(_e3833.member, _e3833.member_1, _e3833.member_2));
} else {
let _e3843 = global_5.member[_e352].member_8.member_8;
let _e3844 = (_e3818 - _e3843);
let _e3849 = global_5.member[_e352].member_8.member_2;
let _e3854 = global_5.member[_e352].member_8.member_6;
let _e3862 = global_5.member[_e352].member_8.member_5;
let _e3864 = (((_e3816 - (_e3849 + (_e3854 * _e3844))) * _e3862) - 0.5f);
let _e3869 = global_5.member[_e352].member_8.member_3;
let _e3874 = global_5.member[_e352].member_8.member_7;
let _e3879 = (((_e3817 - (_e3869 + (_e3874 * _e3844))) * _e3862) - 0.5f);
let _e3884 = global_5.member[_e352].member_8.member;
let _e3885 = bitcast<i32>(_e3884);
let _e3887 = (f32(_e3885) - 1f);
let _e3892 = global_5.member[_e352].member_8.member_1;
let _e3895 = (f32(bitcast<i32>(_e3892)) - 1f);
let _e3897 = select(0f, _e3864, (_e3864 > 0f));
let _e3899 = select(_e3887, _e3897, (_e3897 < _e3887));
let _e3906 = select(0i, select(select(i32(_e3899), i32(-2147483648), (_e3899 < -2147483600f)), 2147483647i, (_e3899 > 2147483500f)), (_e3899 == _e3899));
let _e3910 = (_e3906 - select(0i, 1i, (_e3899 < f32(_e3906))));
let _e3912 = select(0f, _e3879, (_e3879 > 0f));
let _e3914 = select(_e3895, _e3912, (_e3912 < _e3895));
let _e3921 = select(0i, select(select(i32(_e3914), i32(-2147483648), (_e3914 < -2147483600f)), 2147483647i, (_e3914 > 2147483500f)), (_e3914 == _e3914));
let _e3925 = (_e3921 - select(0i, 1i, (_e3914 < f32(_e3921))));
let _e3929 = (_e3864 - f32(_e3910));
let _e3931 = (_e3879 - f32(_e3925));
let _e3938 = ((((_e3864 >= 0f) && (_e3864 <= _e3887)) && (_e3879 >= 0f)) && (_e3879 <= _e3895));
let _e3942 = global_5.member[_e352].member_4;
let _e3943 = bitcast<i32>(_e3942);
let _e3945 = bitcast<i32>((_e3884 * _e3892));
let _e3947 = (_e3943 + (3i * _e3945));
local_1 = (_e3947 + ((_e3925 * _e3885) + _e3910));
let _e3949 = local_1;
let _e3951 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e3953 = select(_e3951, _e3949, (_e3949 < _e3951));
let _e3958 = global_6.member[bitcast<u32>(select(0i, _e3953, (_e3953 > 0i)))];
let _e3959 = bitcast<u32>(_e3958);
let _e3963 = f32((bitcast<i32>((_e3959 & 65535u)) - 32768i));
let _e3969 = f32((bitcast<i32>(((_e3959 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e3974 = select(_e3969, -(_e3969), ((_e3959 >> bitcast<u32>(31i)) != 0u));
let _e3975 = local_1;
let _e3976 = (_e3975 + 1i);
let _e3978 = select(_e3951, _e3976, (_e3976 < _e3951));
let _e3983 = global_6.member[bitcast<u32>(select(0i, _e3978, (_e3978 > 0i)))];
let _e3984 = bitcast<u32>(_e3983);
let _e3994 = f32((bitcast<i32>(((_e3984 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4000 = local_1;
let _e4001 = (_e4000 + _e3885);
let _e4003 = select(_e3951, _e4001, (_e4001 < _e3951));
let _e4008 = global_6.member[bitcast<u32>(select(0i, _e4003, (_e4003 > 0i)))];
let _e4009 = bitcast<u32>(_e4008);
let _e4013 = f32((bitcast<i32>((_e4009 & 65535u)) - 32768i));
let _e4019 = f32((bitcast<i32>(((_e4009 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4024 = select(_e4019, -(_e4019), ((_e4009 >> bitcast<u32>(31i)) != 0u));
let _e4025 = (_e3885 + 1i);
let _e4026 = local_1;
let _e4027 = (_e4026 + _e4025);
let _e4029 = select(_e3951, _e4027, (_e4027 < _e3951));
let _e4034 = global_6.member[bitcast<u32>(select(0i, _e4029, (_e4029 > 0i)))];
let _e4035 = bitcast<u32>(_e4034);
let _e4045 = f32((bitcast<i32>(((_e4035 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4053 = (_e3963 + ((f32((bitcast<i32>((_e3984 & 65535u)) - 32768i)) - _e3963) * _e3929));
let _e4062 = (_e3974 + ((select(_e3994, -(_e3994), ((_e3984 >> bitcast<u32>(31i)) != 0u)) - _e3974) * _e3929));
let _e4075 = global_5.member[_e352].member_9.member;
let _e4078 = (1f / 16255f);
let _e4080 = (_e4075.member + (select(0f, (_e4053 + (((_e4013 + ((f32((bitcast<i32>((_e4035 & 65535u)) - 32768i)) - _e4013) * _e3929)) - _e4053) * _e3931)), _e3938) * _e4078));
let _e4082 = (_e4075.member_1 + (select(0f, (_e4062 + (((_e4024 + ((select(_e4045, -(_e4045), ((_e4035 >> bitcast<u32>(31i)) != 0u)) - _e4024) * _e3929)) - _e4062) * _e3931)), _e3938) * _e4078));
let _e4086 = (1f - ((_e4080 * _e4080) + (_e4082 * _e4082)));
let _e4088 = select(1e-4f, _e4086, (_e4086 > 1e-4f));
let _e4091 = sqrt(select(0f, _e4088, (_e4088 > 0f)));
let _e4095 = (1f / select(1e-6f, _e4091, (_e4091 > 1e-6f)));
let _e4096 = ((_e3818 - _e376) * _e3862);
let _e4103 = (_e3864 - (((_e4080 * _e4095) - _e3854) * _e4096));
let _e4104 = (_e3879 - (((_e4082 * _e4095) - _e3874) * _e4096));
let _e4106 = select(0f, _e4103, (_e4103 > 0f));
let _e4108 = select(_e3887, _e4106, (_e4106 < _e3887));
let _e4115 = select(0i, select(select(i32(_e4108), i32(-2147483648), (_e4108 < -2147483600f)), 2147483647i, (_e4108 > 2147483500f)), (_e4108 == _e4108));
let _e4119 = (_e4115 - select(0i, 1i, (_e4108 < f32(_e4115))));
let _e4121 = select(0f, _e4104, (_e4104 > 0f));
let _e4123 = select(_e3895, _e4121, (_e4121 < _e3895));
let _e4130 = select(0i, select(select(i32(_e4123), i32(-2147483648), (_e4123 < -2147483600f)), 2147483647i, (_e4123 > 2147483500f)), (_e4123 == _e4123));
let _e4134 = (_e4130 - select(0i, 1i, (_e4123 < f32(_e4130))));
let _e4136 = ((_e4134 * _e3885) + _e4119);
let _e4138 = (_e4103 - f32(_e4119));
let _e4140 = (_e4104 - f32(_e4134));
let _e4147 = ((((_e4103 >= 0f) && (_e4103 <= _e3887)) && (_e4104 >= 0f)) && (_e4104 <= _e3895));
let _e4148 = (_e3943 + _e4136);
let _e4150 = select(_e3951, _e4148, (_e4148 < _e3951));
let _e4156 = global_6.member[bitcast<u32>(select(0i, _e4150, (_e4150 > 0i)))];
let _e4157 = (_e4148 + 1i);
let _e4159 = select(_e3951, _e4157, (_e4157 < _e3951));
let _e4165 = global_6.member[bitcast<u32>(select(0i, _e4159, (_e4159 > 0i)))];
let _e4168 = (_e4156 + ((_e4165 - _e4156) * _e4138));
let _e4169 = (_e4148 + _e3885);
let _e4171 = select(_e3951, _e4169, (_e4169 < _e3951));
let _e4177 = global_6.member[bitcast<u32>(select(0i, _e4171, (_e4171 > 0i)))];
let _e4178 = (_e4169 + 1i);
let _e4180 = select(_e3951, _e4178, (_e4178 < _e3951));
let _e4186 = global_6.member[bitcast<u32>(select(0i, _e4180, (_e4180 > 0i)))];
let _e4193 = select(1f, (_e4168 + (((_e4177 + ((_e4186 - _e4177) * _e4138)) - _e4168) * _e4140)), _e4147);
if _e2884 {
phi_7278_ = vec3(_e4193);
} else {
let _e4196 = ((_e3943 + _e3945) + _e4136);
let _e4198 = select(_e3951, _e4196, (_e4196 < _e3951));
let _e4204 = global_6.member[bitcast<u32>(select(0i, _e4198, (_e4198 > 0i)))];
let _e4205 = (_e4196 + 1i);
let _e4207 = select(_e3951, _e4205, (_e4205 < _e3951));
let _e4213 = global_6.member[bitcast<u32>(select(0i, _e4207, (_e4207 > 0i)))];
let _e4216 = (_e4204 + ((_e4213 - _e4204) * _e4138));
let _e4217 = (_e4196 + _e3885);
let _e4219 = select(_e3951, _e4217, (_e4217 < _e3951));
let _e4225 = global_6.member[bitcast<u32>(select(0i, _e4219, (_e4219 > 0i)))];
let _e4226 = (_e4217 + 1i);
let _e4228 = select(_e3951, _e4226, (_e4226 < _e3951));
let _e4234 = global_6.member[bitcast<u32>(select(0i, _e4228, (_e4228 > 0i)))];
let _e4244 = ((_e3943 + (2i * _e3945)) + _e4136);
let _e4246 = select(_e3951, _e4244, (_e4244 < _e3951));
let _e4252 = global_6.member[bitcast<u32>(select(0i, _e4246, (_e4246 > 0i)))];
let _e4253 = (_e4244 + 1i);
let _e4255 = select(_e3951, _e4253, (_e4253 < _e3951));
let _e4261 = global_6.member[bitcast<u32>(select(0i, _e4255, (_e4255 > 0i)))];
let _e4264 = (_e4252 + ((_e4261 - _e4252) * _e4138));
let _e4265 = (_e4244 + _e3885);
let _e4267 = select(_e3951, _e4265, (_e4265 < _e3951));
let _e4273 = global_6.member[bitcast<u32>(select(0i, _e4267, (_e4267 > 0i)))];
let _e4274 = (_e4265 + 1i);
let _e4276 = select(_e3951, _e4274, (_e4274 < _e3951));
let _e4282 = global_6.member[bitcast<u32>(select(0i, _e4276, (_e4276 > 0i)))];
phi_7278_ = vec3<f32>(_e4193, select(1f, (_e4216 + (((_e4225 + ((_e4234 - _e4225) * _e4138)) - _e4216) * _e4140)), _e4147), select(1f, (_e4264 + (((_e4273 + ((_e4282 - _e4273) * _e4138)) - _e4264) * _e4140)), _e4147));
}
let _e4292 = phi_7278_;
local = (_e3947 + _e4136);
let _e4294 = local;
let _e4296 = select(_e3951, _e4294, (_e4294 < _e3951));
let _e4301 = global_6.member[bitcast<u32>(select(0i, _e4296, (_e4296 > 0i)))];
let _e4302 = bitcast<u32>(_e4301);
let _e4306 = f32((bitcast<i32>((_e4302 & 65535u)) - 32768i));
let _e4312 = f32((bitcast<i32>(((_e4302 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4317 = select(_e4312, -(_e4312), ((_e4302 >> bitcast<u32>(31i)) != 0u));
let _e4318 = local;
let _e4319 = (_e4318 + 1i);
let _e4321 = select(_e3951, _e4319, (_e4319 < _e3951));
let _e4326 = global_6.member[bitcast<u32>(select(0i, _e4321, (_e4321 > 0i)))];
let _e4327 = bitcast<u32>(_e4326);
let _e4337 = f32((bitcast<i32>(((_e4327 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4343 = local;
let _e4344 = (_e4343 + _e3885);
let _e4346 = select(_e3951, _e4344, (_e4344 < _e3951));
let _e4351 = global_6.member[bitcast<u32>(select(0i, _e4346, (_e4346 > 0i)))];
let _e4352 = bitcast<u32>(_e4351);
let _e4356 = f32((bitcast<i32>((_e4352 & 65535u)) - 32768i));
let _e4362 = f32((bitcast<i32>(((_e4352 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4367 = select(_e4362, -(_e4362), ((_e4352 >> bitcast<u32>(31i)) != 0u));
let _e4368 = local;
let _e4369 = (_e4368 + _e4025);
let _e4371 = select(_e3951, _e4369, (_e4369 < _e3951));
let _e4376 = global_6.member[bitcast<u32>(select(0i, _e4371, (_e4371 > 0i)))];
let _e4377 = bitcast<u32>(_e4376);
let _e4387 = f32((bitcast<i32>(((_e4377 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4395 = (_e4306 + ((f32((bitcast<i32>((_e4327 & 65535u)) - 32768i)) - _e4306) * _e4138));
let _e4404 = (_e4317 + ((select(_e4337, -(_e4337), ((_e4327 >> bitcast<u32>(31i)) != 0u)) - _e4317) * _e4138));
let _e4417 = global_5.member[_e352].member_9.member_1;
let _e4424 = (_e4075.member + (select(0f, (_e4395 + (((_e4356 + ((f32((bitcast<i32>((_e4377 & 65535u)) - 32768i)) - _e4356) * _e4138)) - _e4395) * _e4140)), _e4147) * _e4078));
let _e4426 = (_e4075.member_1 + (select(0f, (_e4404 + (((_e4367 + ((select(_e4387, -(_e4387), ((_e4377 >> bitcast<u32>(31i)) != 0u)) - _e4367) * _e4138)) - _e4404) * _e4140)), _e4147) * _e4078));
let _e4430 = (1f - ((_e4424 * _e4424) + (_e4426 * _e4426)));
let _e4432 = select(1e-4f, _e4430, (_e4430 > 1e-4f));
phi_7508_ = type_25((_e4292 * vec3<f32>(_e4417.member, _e4417.member_1, _e4417.member_2)), vec3<f32>(_e4424, _e4426, sqrt(select(0f, _e4432, (_e4432 > 0f)))));
}
let _e4439 = phi_7508_;
let _e4448 = (((_e4439.member_1.x * _e4439.member_1.x) + (_e4439.member_1.y * _e4439.member_1.y)) + (_e4439.member_1.z * _e4439.member_1.z));
let _e4451 = sqrt(select(0f, _e4448, (_e4448 > 0f)));
let _e4457 = (1e-6f * _e4451);
let _e4461 = select((_e4451 / select(_e4457, _e4439.member_1.z, (_e4439.member_1.z > _e4457))), 1f, ((_e687 & 8u) != 0u));
let _e4463 = (_e4439.member.x * _e4461);
let _e4465 = (_e4439.member.y * _e4461);
let _e4467 = (_e4439.member.z * _e4461);
if _e803 {
let _e4472 = global_5.member[_e352].member_19;
let _e4481 = (((_e2224.member_1.x * _e2224.member_1.x) + (_e2224.member_1.y * _e2224.member_1.y)) + (_e2224.member_1.z * _e2224.member_1.z));
let _e4484 = sqrt(select(0f, _e4481, (_e4481 > 0f)));
let _e4487 = (1f / select(1e-20f, _e4484, (_e4484 > 1e-20f)));
let _e4488 = (_e2224.member_1.x * _e4487);
let _e4489 = (_e2224.member_1.y * _e4487);
let _e4490 = (_e2224.member_1.z * _e4487);
let _e4493 = (-1f / select(1e-20f, _e4451, (_e4451 > 1e-20f)));
let _e4494 = (_e4439.member_1.x * _e4493);
let _e4495 = (_e4439.member_1.y * _e4493);
let _e4496 = (_e4439.member_1.z * _e4493);
let _e4501 = (((_e356[3] * _e356[3]) + (_e356[4] * _e356[4])) + (_e356[5] * _e356[5]));
let _e4504 = sqrt(select(0f, _e4501, (_e4501 > 0f)));
let _e4507 = (-1f / select(1e-20f, _e4504, (_e4504 > 1e-20f)));
let _e4508 = (_e356[3] * _e4507);
let _e4509 = (_e356[4] * _e4507);
let _e4510 = (_e356[5] * _e4507);
let _e4517 = select(1f, -1f, ((((_e4488 * _e4508) + (_e4489 * _e4509)) + (_e4490 * _e4510)) < 0f));
let _e4518 = (_e4488 * _e4517);
let _e4519 = (_e4489 * _e4517);
let _e4520 = (_e4490 * _e4517);
let _e4525 = (((_e4518 * _e4508) + (_e4519 * _e4509)) + (_e4520 * _e4510));
let _e4527 = select(1e-4f, _e4525, (_e4525 > 1e-4f));
let _e4532 = (((_e4518 * _e4494) + (_e4519 * _e4495)) + (_e4520 * _e4496));
let _e4533 = (_e4494 + _e4508);
let _e4534 = (_e4495 + _e4509);
let _e4535 = (_e4496 + _e4510);
let _e4540 = (((_e4533 * _e4533) + (_e4534 * _e4534)) + (_e4535 * _e4535));
let _e4543 = sqrt(select(0f, _e4540, (_e4540 > 0f)));
let _e4546 = (1f / select(1e-6f, _e4543, (_e4543 > 1e-6f)));
let _e4547 = (_e4533 * _e4546);
let _e4548 = (_e4534 * _e4546);
let _e4549 = (_e4535 * _e4546);
let _e4554 = (((_e4518 * _e4547) + (_e4519 * _e4548)) + (_e4520 * _e4549));
let _e4556 = select(0f, _e4554, (_e4554 > 0f));
let _e4561 = (((_e4508 * _e4547) + (_e4509 * _e4548)) + (_e4510 * _e4549));
let _e4563 = select(0f, _e4561, (_e4561 > 0f));
let _e4564 = (_e4472 * _e4472);
let _e4565 = (_e4564 * _e4564);
let _e4569 = (((_e4556 * _e4556) * (_e4565 - 1f)) + 1f);
let _e4573 = (_e4532 > 0f);
let _e4574 = select(0f, _e4532, _e4573);
let _e4576 = (1f - _e4565);
let _e4578 = (((_e4574 * _e4574) * _e4576) + _e4565);
let _e4585 = (((_e4527 * _e4527) * _e4576) + _e4565);
let _e4590 = ((_e4527 * sqrt(select(0f, _e4578, (_e4578 > 0f)))) + (_e4574 * sqrt(select(0f, _e4585, (_e4585 > 0f)))));
let _e4595 = (_e2224.member_2 / _e2562);
let _e4599 = (((_e4595 * _e4595) - 1f) + (_e4563 * _e4563));
let _e4602 = sqrt(select(0f, _e4599, (_e4599 > 0f)));
let _e4603 = (_e4602 - _e4563);
let _e4604 = (_e4602 + _e4563);
let _e4607 = (_e4603 / select(1e-6f, _e4604, (_e4604 > 1e-6f)));
let _e4611 = ((_e4563 * _e4603) + 1f);
let _e4614 = (((_e4563 * _e4604) - 1f) / select(1e-6f, _e4611, (_e4611 > 1e-6f)));
let _e4632 = global_5.member[_e352].member_20;
let _e4636 = ((select(0f, ((((_e4565 / ((3.1415927f * _e4569) * _e4569)) * (0.5f / select(1e-6f, _e4590, (_e4590 > 1e-6f)))) * select(select((((0.5f * _e4607) * _e4607) * (1f + (_e4614 * _e4614))), 1f, (_e4599 <= 0f)), 0f, (_e2562 == _e2224.member_2))) * _e4574), (_e4573 && (_e4484 > 1e-12f))) * _e4632) * select(_e2778.member_2, 0f, _e444));
phi_7826_ = vec3<f32>((_e4463 * _e4636), (_e4465 * _e4636), (_e4467 * _e4636));
} else {
phi_7826_ = vec3<f32>(0f, 0f, 0f);
}
let _e4642 = phi_7826_;
let _e4646 = global_5.member[_e352].member_18;
let _e4653 = (1f - _e356[12]);
let _e4673 = (_e356[9] + ((_e356[13] * ((_e3811.member_3.x * (_e4463 + _e4646.member)) + _e4642.x)) * _e4653));
let _e4674 = (_e356[10] + ((_e356[14] * ((_e3811.member_3.y * (_e4465 + _e4646.member_1)) + _e4642.y)) * _e4653));
let _e4675 = (_e356[11] + ((_e356[15] * ((_e3811.member_3.z * (_e4467 + _e4646.member_2)) + _e4642.z)) * _e4653));
let _e4678 = (_e356[12] + (_e4653 * _e3811.member_1));
let _e4681 = (_e356[13] * _e3811.member_2.x);
let _e4683 = (_e356[14] * _e3811.member_2.y);
let _e4685 = (_e356[15] * _e3811.member_2.z);
let _e4690 = (_e356[8] + ((_e4678 - _e356[12]) * (_e376 + (_e2867 * 0.5f))));
let _e4699 = (-((((select(_e773.member, _e760.member, _e753) * _e4439.member_1.x) + (select(_e773.member_1, _e760.member_1, _e753) * _e4439.member_1.y)) + (select(_e773.member_2, _e760.member_2, _e753) * _e4439.member_1.z))) / select(1e-20f, _e4451, (_e4451 > 1e-20f)));
let _e4704 = bitcast<f32>((bitcast<u32>(select(0f, _e4699, (_e4699 > 0f))) & 2147483647u));
let _e4714 = (1f - _e4678);
let _e4727 = select(_e4678, 1f, _e444);
if _e803 {
let _e4736 = global_5.member[_e352].member_5.member_4;
let _e4739 = (_e2224.member_3.x * _e2778.member_2);
let _e4741 = (_e2224.member_3.y * _e2778.member_2);
let _e4743 = (_e2224.member_3.z * _e2778.member_2);
let _e4744 = (0.5f * _e371);
let _e4748 = (_e356[3] + (_e4739 * _e4744));
let _e4749 = (_e356[4] + (_e4741 * _e4744));
let _e4750 = (_e356[5] + (_e4743 * _e4744));
let _e4752 = (2f * _e370);
let _e4754 = ((_e4750 * _e4750) + (_e4752 * _e4743));
let _e4758 = (_e4750 + sqrt(select(0f, _e4754, (_e4754 > 0f))));
let _e4762 = (0.5f * (_e4752 / select(1e-6f, _e4758, (_e4758 > 1e-6f))));
let _e4766 = (_e4748 + (_e4739 * _e4762));
let _e4767 = (_e4749 + (_e4741 * _e4762));
let _e4768 = (_e4750 + (_e4743 * _e4762));
let _e4772 = (_e4736 * _e4736);
let _e4774 = (_e4768 * _e4768);
let _e4782 = (((_e4750 <= 0f) || (_e4754 <= 0f)) || ((_e4768 <= 0f) || (_e4774 <= (_e4772 * (((_e4766 * _e4766) + (_e4767 * _e4767)) + _e4774)))));
let _e4796 = (_e356[3] + ((_e2224.member_4.x * _e2778.member_2) * _e370));
let _e4797 = (_e356[4] + ((_e2224.member_4.y * _e2778.member_2) * _e370));
let _e4798 = (_e356[5] + ((_e2224.member_4.z * _e2778.member_2) * _e370));
let _e4800 = (_e4798 * _e4798);
let _e4809 = ((_e687 & 1u) != 0u);
phi_8131_ = vec3<f32>(select(select(_e4766, _e4748, _e4782), _e4796, _e4809), select(select(_e4767, _e4749, _e4782), _e4797, _e4809), select(select(_e4768, _e4750, _e4782), _e4798, _e4809));
phi_8132_ = select(_e4782, ((_e4798 <= 0f) || (_e4800 <= (_e4772 * (((_e4796 * _e4796) + (_e4797 * _e4797)) + _e4800)))), _e4809);
} else {
phi_8131_ = vec3<f32>(_e356[3], _e356[4], _e356[5]);
phi_8132_ = false;
}
let _e4816 = phi_8131_;
let _e4818 = phi_8132_;
let _e4827 = (((_e444 || (_e4816.x != _e356[3])) || (_e4816.y != _e356[4])) || (_e4816.z != _e356[5]));
let _e4829 = select(_e4683, _e4681, (_e4681 > _e4683));
phi_8197_ = array<f32, 18>(select(_e356[0], select(_e384, _e3816, _e444), _e4827), select(_e356[1], select(_e386, _e3817, _e444), _e4827), select(_e356[2], select(_e391, _e3818, _e444), _e4827), _e4816.x, _e4816.y, _e4816.z, _e2224.member, select(select(0f, 2f, _e4818), 1f, (_e444 || (((1f - _e4727) * select(_e4685, _e4829, (_e4829 > _e4685))) < 9.765625e-4f))), select(_e4690, (_e4690 + (_e4714 * _e3818)), _e444), select(_e4673, (_e4673 + ((_e4681 * (select(_e779.member, _e766.member, _e753) * ((_e4463 * _e4704) + _e4646.member))) * _e4714)), _e444), select(_e4674, (_e4674 + ((_e4683 * (select(_e779.member_1, _e766.member_1, _e753) * ((_e4465 * _e4704) + _e4646.member_1))) * _e4714)), _e444), select(_e4675, (_e4675 + ((_e4685 * (select(_e779.member_2, _e766.member_2, _e753) * ((_e4467 * _e4704) + _e4646.member_2))) * _e4714)), _e444), _e4727, _e4681, _e4683, _e4685, _e2224.member_2, _e391);
} else {
phi_8197_ = _e356;
}
let _e4848 = phi_8197_;
phi_583_ = (_e352 + 1u);
phi_586_ = select(_e354, true, _e725);
phi_588_ = _e4848;
} else {
phi_583_ = u32();
phi_586_ = bool();
phi_588_ = array<f32, 18>();
}
let _e4852 = phi_583_;
let _e4854 = phi_586_;
let _e4856 = phi_588_;
continue;
continuing {
phi_582_ = _e4852;
phi_585_ = _e4854;
phi_587_ = _e4856;
phi_8280_ = false;
break if !(_e357);
}
}
let _e4859 = phi_8280_;
if _e4859 {
break;
}
let _e4861 = local_8;
if _e4861 {
let _e4863 = local_9;
global_4.member[_e152] = _e4863[0];
let _e4868 = local_10;
global_4.member[_e164] = _e4868[1];
let _e4873 = local_11;
global_4.member[_e175] = _e4873[2];
let _e4878 = local_12;
global_4.member[_e186] = _e4878[3];
let _e4883 = local_13;
global_4.member[_e197] = _e4883[4];
let _e4888 = local_14;
global_4.member[_e208] = _e4888[5];
let _e4893 = local_15;
global_4.member[_e219] = _e4893[6];
let _e4898 = local_16;
global_4.member[_e230] = _e4898[7];
let _e4903 = local_17;
global_4.member[_e241] = _e4903[8];
let _e4908 = local_18;
global_4.member[_e252] = _e4908[9];
let _e4913 = local_19;
global_4.member[_e263] = _e4913[10];
let _e4918 = local_20;
global_4.member[_e274] = _e4918[11];
let _e4923 = local_21;
global_4.member[_e285] = _e4923[12];
let _e4928 = local_22;
global_4.member[_e296] = _e4928[13];
let _e4933 = local_23;
global_4.member[_e307] = _e4933[14];
let _e4938 = local_24;
global_4.member[_e318] = _e4938[15];
let _e4943 = local_25;
global_4.member[_e329] = _e4943[16];
let _e4948 = local_26;
global_4.member[_e340] = _e4948[17];
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
