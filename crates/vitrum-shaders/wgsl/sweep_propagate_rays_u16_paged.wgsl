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
var phi_3793_: type_29;
var phi_4494_: type_30;
var phi_5132_: f32;
var phi_5521_: type_5;
var phi_7079_: type_31;
var phi_7832_: vec3<f32>;
var phi_8062_: type_25;
var phi_8380_: vec3<f32>;
var phi_8685_: vec3<f32>;
var phi_8686_: bool;
var phi_8751_: array<f32, 18>;
var phi_585_: u32;
var phi_588_: bool;
var phi_590_: array<f32, 18>;
var phi_8834_: bool;
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
phi_8834_ = true;
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
let _e932 = (_e930 >> bitcast<u32>(1i));
let _e935 = bitcast<u32>(((_e930 & 1i) * 16i));
let _e937 = select(_e887, _e932, (_e932 < _e887));
let _e942 = global_1.member[bitcast<u32>(select(0i, _e937, (_e937 > 0i)))];
let _e946 = (_e932 + 1i);
let _e948 = select(_e887, _e946, (_e946 < _e887));
let _e953 = global_1.member[bitcast<u32>(select(0i, _e948, (_e948 > 0i)))];
let _e960 = ((_e942 >> bitcast<u32>((_e935 & 31u))) | ((_e953 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e935) & 31u))));
let _e963 = local_6.member[2u];
let _e964 = (_e926 + _e963);
let _e966 = (_e964 >> bitcast<u32>(1i));
let _e969 = bitcast<u32>(((_e964 & 1i) * 16i));
let _e971 = select(_e887, _e966, (_e966 < _e887));
let _e976 = global_1.member[bitcast<u32>(select(0i, _e971, (_e971 > 0i)))];
let _e980 = (_e966 + 1i);
let _e982 = select(_e887, _e980, (_e980 < _e887));
let _e987 = global_1.member[bitcast<u32>(select(0i, _e982, (_e982 > 0i)))];
let _e994 = ((_e976 >> bitcast<u32>((_e969 & 31u))) | ((_e987 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e969) & 31u))));
let _e997 = local_6.member_1[0u];
let _e1003 = f32(bitcast<i32>(((_e960 >> bitcast<u32>((_e997 & 31u))) & 65535u)));
let _e1006 = local_6.member_1[1u];
let _e1012 = f32(bitcast<i32>(((_e960 >> bitcast<u32>((_e1006 & 31u))) & 65535u)));
let _e1015 = local_6.member_1[4u];
let _e1021 = f32(bitcast<i32>(((_e994 >> bitcast<u32>((_e1015 & 31u))) & 65535u)));
let _e1024 = local_6.member_1[5u];
let _e1031 = local_7[0u];
let _e1034 = (_e1003 + ((_e1012 - _e1003) * _e1031));
let _e1035 = local_7[0u];
let _e1038 = (_e1012 + ((_e1021 - _e1012) * _e1035));
let _e1039 = local_7[0u];
let _e1042 = (_e1021 + ((f32(bitcast<i32>(((_e994 >> bitcast<u32>((_e1024 & 31u))) & 65535u))) - _e1021) * _e1039));
let _e1043 = (_e911 + _e908);
let _e1044 = local_6.member[0u];
let _e1045 = (_e1043 + _e1044);
let _e1047 = (_e1045 >> bitcast<u32>(1i));
let _e1050 = bitcast<u32>(((_e1045 & 1i) * 16i));
let _e1052 = select(_e887, _e1047, (_e1047 < _e887));
let _e1057 = global_1.member[bitcast<u32>(select(0i, _e1052, (_e1052 > 0i)))];
let _e1061 = (_e1047 + 1i);
let _e1063 = select(_e887, _e1061, (_e1061 < _e887));
let _e1068 = global_1.member[bitcast<u32>(select(0i, _e1063, (_e1063 > 0i)))];
let _e1075 = ((_e1057 >> bitcast<u32>((_e1050 & 31u))) | ((_e1068 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1050) & 31u))));
let _e1076 = local_6.member[2u];
let _e1077 = (_e1043 + _e1076);
let _e1079 = (_e1077 >> bitcast<u32>(1i));
let _e1082 = bitcast<u32>(((_e1077 & 1i) * 16i));
let _e1084 = select(_e887, _e1079, (_e1079 < _e887));
let _e1089 = global_1.member[bitcast<u32>(select(0i, _e1084, (_e1084 > 0i)))];
let _e1093 = (_e1079 + 1i);
let _e1095 = select(_e887, _e1093, (_e1093 < _e887));
let _e1100 = global_1.member[bitcast<u32>(select(0i, _e1095, (_e1095 > 0i)))];
let _e1107 = ((_e1089 >> bitcast<u32>((_e1082 & 31u))) | ((_e1100 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1082) & 31u))));
let _e1108 = local_6.member_1[0u];
let _e1114 = f32(bitcast<i32>(((_e1075 >> bitcast<u32>((_e1108 & 31u))) & 65535u)));
let _e1115 = local_6.member_1[1u];
let _e1121 = f32(bitcast<i32>(((_e1075 >> bitcast<u32>((_e1115 & 31u))) & 65535u)));
let _e1122 = local_6.member_1[4u];
let _e1128 = f32(bitcast<i32>(((_e1107 >> bitcast<u32>((_e1122 & 31u))) & 65535u)));
let _e1129 = local_6.member_1[5u];
let _e1136 = local_7[0u];
let _e1140 = local_7[0u];
let _e1143 = (_e1121 + ((_e1128 - _e1121) * _e1140));
let _e1144 = local_7[0u];
let _e1148 = (_e913 + _e906);
let _e1149 = local_6.member[0u];
let _e1150 = (_e1148 + _e1149);
let _e1152 = (_e1150 >> bitcast<u32>(1i));
let _e1155 = bitcast<u32>(((_e1150 & 1i) * 16i));
let _e1157 = select(_e887, _e1152, (_e1152 < _e887));
let _e1162 = global_1.member[bitcast<u32>(select(0i, _e1157, (_e1157 > 0i)))];
let _e1166 = (_e1152 + 1i);
let _e1168 = select(_e887, _e1166, (_e1166 < _e887));
let _e1173 = global_1.member[bitcast<u32>(select(0i, _e1168, (_e1168 > 0i)))];
let _e1180 = ((_e1162 >> bitcast<u32>((_e1155 & 31u))) | ((_e1173 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1155) & 31u))));
let _e1181 = local_6.member[2u];
let _e1182 = (_e1148 + _e1181);
let _e1184 = (_e1182 >> bitcast<u32>(1i));
let _e1187 = bitcast<u32>(((_e1182 & 1i) * 16i));
let _e1189 = select(_e887, _e1184, (_e1184 < _e887));
let _e1194 = global_1.member[bitcast<u32>(select(0i, _e1189, (_e1189 > 0i)))];
let _e1198 = (_e1184 + 1i);
let _e1200 = select(_e887, _e1198, (_e1198 < _e887));
let _e1205 = global_1.member[bitcast<u32>(select(0i, _e1200, (_e1200 > 0i)))];
let _e1212 = ((_e1194 >> bitcast<u32>((_e1187 & 31u))) | ((_e1205 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1187) & 31u))));
let _e1213 = local_6.member_1[0u];
let _e1219 = f32(bitcast<i32>(((_e1180 >> bitcast<u32>((_e1213 & 31u))) & 65535u)));
let _e1220 = local_6.member_1[1u];
let _e1226 = f32(bitcast<i32>(((_e1180 >> bitcast<u32>((_e1220 & 31u))) & 65535u)));
let _e1227 = local_6.member_1[4u];
let _e1233 = f32(bitcast<i32>(((_e1212 >> bitcast<u32>((_e1227 & 31u))) & 65535u)));
let _e1234 = local_6.member_1[5u];
let _e1241 = local_7[0u];
let _e1244 = (_e1219 + ((_e1226 - _e1219) * _e1241));
let _e1245 = local_7[0u];
let _e1248 = (_e1226 + ((_e1233 - _e1226) * _e1245));
let _e1249 = local_7[0u];
let _e1252 = (_e1233 + ((f32(bitcast<i32>(((_e1212 >> bitcast<u32>((_e1234 & 31u))) & 65535u))) - _e1233) * _e1249));
let _e1253 = (_e913 + _e908);
let _e1254 = local_6.member[0u];
let _e1255 = (_e1253 + _e1254);
let _e1257 = (_e1255 >> bitcast<u32>(1i));
let _e1260 = bitcast<u32>(((_e1255 & 1i) * 16i));
let _e1262 = select(_e887, _e1257, (_e1257 < _e887));
let _e1267 = global_1.member[bitcast<u32>(select(0i, _e1262, (_e1262 > 0i)))];
let _e1271 = (_e1257 + 1i);
let _e1273 = select(_e887, _e1271, (_e1271 < _e887));
let _e1278 = global_1.member[bitcast<u32>(select(0i, _e1273, (_e1273 > 0i)))];
let _e1285 = ((_e1267 >> bitcast<u32>((_e1260 & 31u))) | ((_e1278 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1260) & 31u))));
let _e1286 = local_6.member[2u];
let _e1287 = (_e1253 + _e1286);
let _e1289 = (_e1287 >> bitcast<u32>(1i));
let _e1292 = bitcast<u32>(((_e1287 & 1i) * 16i));
let _e1294 = select(_e887, _e1289, (_e1289 < _e887));
let _e1299 = global_1.member[bitcast<u32>(select(0i, _e1294, (_e1294 > 0i)))];
let _e1303 = (_e1289 + 1i);
let _e1305 = select(_e887, _e1303, (_e1303 < _e887));
let _e1310 = global_1.member[bitcast<u32>(select(0i, _e1305, (_e1305 > 0i)))];
let _e1317 = ((_e1299 >> bitcast<u32>((_e1292 & 31u))) | ((_e1310 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1292) & 31u))));
let _e1318 = local_6.member_1[0u];
let _e1324 = f32(bitcast<i32>(((_e1285 >> bitcast<u32>((_e1318 & 31u))) & 65535u)));
let _e1325 = local_6.member_1[1u];
let _e1331 = f32(bitcast<i32>(((_e1285 >> bitcast<u32>((_e1325 & 31u))) & 65535u)));
let _e1332 = local_6.member_1[4u];
let _e1338 = f32(bitcast<i32>(((_e1317 >> bitcast<u32>((_e1332 & 31u))) & 65535u)));
let _e1339 = local_6.member_1[5u];
let _e1346 = local_7[0u];
let _e1350 = local_7[0u];
let _e1353 = (_e1331 + ((_e1338 - _e1331) * _e1350));
let _e1354 = local_7[0u];
let _e1361 = local_6.member[1u];
let _e1362 = ((_e911 + _e900) + _e1361);
let _e1364 = (_e1362 >> bitcast<u32>(1i));
let _e1367 = bitcast<u32>(((_e1362 & 1i) * 16i));
let _e1369 = select(_e887, _e1364, (_e1364 < _e887));
let _e1374 = global_1.member[bitcast<u32>(select(0i, _e1369, (_e1369 > 0i)))];
let _e1378 = (_e1364 + 1i);
let _e1380 = select(_e887, _e1378, (_e1378 < _e887));
let _e1385 = global_1.member[bitcast<u32>(select(0i, _e1380, (_e1380 > 0i)))];
let _e1392 = ((_e1374 >> bitcast<u32>((_e1367 & 31u))) | ((_e1385 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1367) & 31u))));
let _e1395 = local_6.member_1[2u];
let _e1401 = f32(bitcast<i32>(((_e1392 >> bitcast<u32>((_e1395 & 31u))) & 65535u)));
let _e1404 = local_6.member_1[3u];
let _e1411 = local_7[0u];
let _e1414 = (_e1401 + ((f32(bitcast<i32>(((_e1392 >> bitcast<u32>((_e1404 & 31u))) & 65535u))) - _e1401) * _e1411));
let _e1416 = local_6.member[1u];
let _e1417 = ((_e911 + _e910) + _e1416);
let _e1419 = (_e1417 >> bitcast<u32>(1i));
let _e1422 = bitcast<u32>(((_e1417 & 1i) * 16i));
let _e1424 = select(_e887, _e1419, (_e1419 < _e887));
let _e1429 = global_1.member[bitcast<u32>(select(0i, _e1424, (_e1424 > 0i)))];
let _e1433 = (_e1419 + 1i);
let _e1435 = select(_e887, _e1433, (_e1433 < _e887));
let _e1440 = global_1.member[bitcast<u32>(select(0i, _e1435, (_e1435 > 0i)))];
let _e1447 = ((_e1429 >> bitcast<u32>((_e1422 & 31u))) | ((_e1440 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1422) & 31u))));
let _e1448 = local_6.member_1[2u];
let _e1454 = f32(bitcast<i32>(((_e1447 >> bitcast<u32>((_e1448 & 31u))) & 65535u)));
let _e1455 = local_6.member_1[3u];
let _e1462 = local_7[0u];
let _e1467 = local_6.member[1u];
let _e1468 = ((_e913 + _e900) + _e1467);
let _e1470 = (_e1468 >> bitcast<u32>(1i));
let _e1473 = bitcast<u32>(((_e1468 & 1i) * 16i));
let _e1475 = select(_e887, _e1470, (_e1470 < _e887));
let _e1480 = global_1.member[bitcast<u32>(select(0i, _e1475, (_e1475 > 0i)))];
let _e1484 = (_e1470 + 1i);
let _e1486 = select(_e887, _e1484, (_e1484 < _e887));
let _e1491 = global_1.member[bitcast<u32>(select(0i, _e1486, (_e1486 > 0i)))];
let _e1498 = ((_e1480 >> bitcast<u32>((_e1473 & 31u))) | ((_e1491 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1473) & 31u))));
let _e1499 = local_6.member_1[2u];
let _e1505 = f32(bitcast<i32>(((_e1498 >> bitcast<u32>((_e1499 & 31u))) & 65535u)));
let _e1506 = local_6.member_1[3u];
let _e1513 = local_7[0u];
let _e1516 = (_e1505 + ((f32(bitcast<i32>(((_e1498 >> bitcast<u32>((_e1506 & 31u))) & 65535u))) - _e1505) * _e1513));
let _e1518 = local_6.member[1u];
let _e1519 = ((_e913 + _e910) + _e1518);
let _e1521 = (_e1519 >> bitcast<u32>(1i));
let _e1524 = bitcast<u32>(((_e1519 & 1i) * 16i));
let _e1526 = select(_e887, _e1521, (_e1521 < _e887));
let _e1531 = global_1.member[bitcast<u32>(select(0i, _e1526, (_e1526 > 0i)))];
let _e1535 = (_e1521 + 1i);
let _e1537 = select(_e887, _e1535, (_e1535 < _e887));
let _e1542 = global_1.member[bitcast<u32>(select(0i, _e1537, (_e1537 > 0i)))];
let _e1549 = ((_e1531 >> bitcast<u32>((_e1524 & 31u))) | ((_e1542 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1524) & 31u))));
let _e1550 = local_6.member_1[2u];
let _e1556 = f32(bitcast<i32>(((_e1549 >> bitcast<u32>((_e1550 & 31u))) & 65535u)));
let _e1557 = local_6.member_1[3u];
let _e1564 = local_7[0u];
let _e1569 = local_6.member[1u];
let _e1570 = ((_e902 + _e906) + _e1569);
let _e1572 = (_e1570 >> bitcast<u32>(1i));
let _e1575 = bitcast<u32>(((_e1570 & 1i) * 16i));
let _e1577 = select(_e887, _e1572, (_e1572 < _e887));
let _e1582 = global_1.member[bitcast<u32>(select(0i, _e1577, (_e1577 > 0i)))];
let _e1586 = (_e1572 + 1i);
let _e1588 = select(_e887, _e1586, (_e1586 < _e887));
let _e1593 = global_1.member[bitcast<u32>(select(0i, _e1588, (_e1588 > 0i)))];
let _e1600 = ((_e1582 >> bitcast<u32>((_e1575 & 31u))) | ((_e1593 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1575) & 31u))));
let _e1601 = local_6.member_1[2u];
let _e1607 = f32(bitcast<i32>(((_e1600 >> bitcast<u32>((_e1601 & 31u))) & 65535u)));
let _e1608 = local_6.member_1[3u];
let _e1615 = local_7[0u];
let _e1618 = (_e1607 + ((f32(bitcast<i32>(((_e1600 >> bitcast<u32>((_e1608 & 31u))) & 65535u))) - _e1607) * _e1615));
let _e1620 = local_6.member[1u];
let _e1621 = ((_e915 + _e906) + _e1620);
let _e1623 = (_e1621 >> bitcast<u32>(1i));
let _e1626 = bitcast<u32>(((_e1621 & 1i) * 16i));
let _e1628 = select(_e887, _e1623, (_e1623 < _e887));
let _e1633 = global_1.member[bitcast<u32>(select(0i, _e1628, (_e1628 > 0i)))];
let _e1637 = (_e1623 + 1i);
let _e1639 = select(_e887, _e1637, (_e1637 < _e887));
let _e1644 = global_1.member[bitcast<u32>(select(0i, _e1639, (_e1639 > 0i)))];
let _e1651 = ((_e1633 >> bitcast<u32>((_e1626 & 31u))) | ((_e1644 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1626) & 31u))));
let _e1652 = local_6.member_1[2u];
let _e1658 = f32(bitcast<i32>(((_e1651 >> bitcast<u32>((_e1652 & 31u))) & 65535u)));
let _e1659 = local_6.member_1[3u];
let _e1666 = local_7[0u];
let _e1669 = (_e1658 + ((f32(bitcast<i32>(((_e1651 >> bitcast<u32>((_e1659 & 31u))) & 65535u))) - _e1658) * _e1666));
let _e1671 = local_6.member[1u];
let _e1672 = ((_e902 + _e908) + _e1671);
let _e1674 = (_e1672 >> bitcast<u32>(1i));
let _e1677 = bitcast<u32>(((_e1672 & 1i) * 16i));
let _e1679 = select(_e887, _e1674, (_e1674 < _e887));
let _e1684 = global_1.member[bitcast<u32>(select(0i, _e1679, (_e1679 > 0i)))];
let _e1688 = (_e1674 + 1i);
let _e1690 = select(_e887, _e1688, (_e1688 < _e887));
let _e1695 = global_1.member[bitcast<u32>(select(0i, _e1690, (_e1690 > 0i)))];
let _e1702 = ((_e1684 >> bitcast<u32>((_e1677 & 31u))) | ((_e1695 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1677) & 31u))));
let _e1703 = local_6.member_1[2u];
let _e1709 = f32(bitcast<i32>(((_e1702 >> bitcast<u32>((_e1703 & 31u))) & 65535u)));
let _e1710 = local_6.member_1[3u];
let _e1717 = local_7[0u];
let _e1722 = local_6.member[1u];
let _e1723 = ((_e915 + _e908) + _e1722);
let _e1725 = (_e1723 >> bitcast<u32>(1i));
let _e1728 = bitcast<u32>(((_e1723 & 1i) * 16i));
let _e1730 = select(_e887, _e1725, (_e1725 < _e887));
let _e1735 = global_1.member[bitcast<u32>(select(0i, _e1730, (_e1730 > 0i)))];
let _e1739 = (_e1725 + 1i);
let _e1741 = select(_e887, _e1739, (_e1739 < _e887));
let _e1746 = global_1.member[bitcast<u32>(select(0i, _e1741, (_e1741 > 0i)))];
let _e1753 = ((_e1735 >> bitcast<u32>((_e1728 & 31u))) | ((_e1746 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1728) & 31u))));
let _e1754 = local_6.member_1[2u];
let _e1760 = f32(bitcast<i32>(((_e1753 >> bitcast<u32>((_e1754 & 31u))) & 65535u)));
let _e1761 = local_6.member_1[3u];
let _e1768 = local_7[0u];
let _e1773 = local_7[1u];
let _e1776 = (_e1038 + ((_e1143 - _e1038) * _e1773));
let _e1777 = local_7[1u];
let _e1780 = (_e1248 + ((_e1353 - _e1248) * _e1777));
let _e1781 = local_7[1u];
let _e1784 = (_e1034 + (((_e1114 + ((_e1121 - _e1114) * _e1136)) - _e1034) * _e1781));
let _e1785 = local_7[1u];
let _e1790 = local_7[2u];
let _e1794 = local_7[1u];
let _e1797 = (_e1042 + (((_e1128 + ((f32(bitcast<i32>(((_e1107 >> bitcast<u32>((_e1129 & 31u))) & 65535u))) - _e1128) * _e1144)) - _e1042) * _e1794));
let _e1798 = local_7[1u];
let _e1802 = local_7[2u];
let _e1806 = local_7[1u];
let _e1809 = (_e1414 + ((_e1038 - _e1414) * _e1806));
let _e1810 = local_7[1u];
let _e1814 = local_7[2u];
let _e1818 = local_7[1u];
let _e1821 = (_e1143 + (((_e1454 + ((f32(bitcast<i32>(((_e1447 >> bitcast<u32>((_e1455 & 31u))) & 65535u))) - _e1454) * _e1462)) - _e1143) * _e1818));
let _e1822 = local_7[1u];
let _e1826 = local_7[2u];
let _e1830 = local_7[1u];
let _e1833 = (_e1618 + (((_e1709 + ((f32(bitcast<i32>(((_e1702 >> bitcast<u32>((_e1710 & 31u))) & 65535u))) - _e1709) * _e1717)) - _e1618) * _e1830));
let _e1834 = local_7[2u];
let _e1838 = local_7[1u];
let _e1842 = local_7[2u];
let _e1846 = local_7[2u];
let _e1854 = global_5.member[_e352].member_6.member_5;
let _e1860 = global_5.member[_e352].member_6.member_6;
let _e1861 = (((_e1776 + ((_e1780 - _e1776) * _e1846)) * _e1854) + _e1860);
let _e1863 = select(0f, _e1861, (_e1861 > 0f));
let _e1865 = select(1f, _e1863, (_e1863 < 1f));
let _e1867 = (((_e1784 + (((_e1244 + (((_e1324 + ((_e1331 - _e1324) * _e1346)) - _e1244) * _e1785)) - _e1784) * _e1790)) * _e1854) + _e1860);
let _e1869 = select(0f, _e1867, (_e1867 > 0f));
let _e1871 = select(1f, _e1869, (_e1869 < 1f));
let _e1873 = (((_e1797 + (((_e1252 + (((_e1338 + ((f32(bitcast<i32>(((_e1317 >> bitcast<u32>((_e1339 & 31u))) & 65535u))) - _e1338) * _e1354)) - _e1252) * _e1798)) - _e1797) * _e1802)) * _e1854) + _e1860);
let _e1875 = select(0f, _e1873, (_e1873 > 0f));
let _e1877 = select(1f, _e1875, (_e1875 < 1f));
let _e1879 = (((_e1809 + (((_e1516 + ((_e1248 - _e1516) * _e1810)) - _e1809) * _e1814)) * _e1854) + _e1860);
let _e1881 = select(0f, _e1879, (_e1879 > 0f));
let _e1883 = select(1f, _e1881, (_e1881 < 1f));
let _e1885 = (((_e1821 + (((_e1353 + (((_e1556 + ((f32(bitcast<i32>(((_e1549 >> bitcast<u32>((_e1557 & 31u))) & 65535u))) - _e1556) * _e1564)) - _e1353) * _e1822)) - _e1821) * _e1826)) * _e1854) + _e1860);
let _e1887 = select(0f, _e1885, (_e1885 > 0f));
let _e1889 = select(1f, _e1887, (_e1887 < 1f));
let _e1891 = (((_e1833 + ((_e1776 - _e1833) * _e1834)) * _e1854) + _e1860);
let _e1893 = select(0f, _e1891, (_e1891 > 0f));
let _e1895 = select(1f, _e1893, (_e1893 < 1f));
let _e1897 = (((_e1780 + (((_e1669 + (((_e1760 + ((f32(bitcast<i32>(((_e1753 >> bitcast<u32>((_e1761 & 31u))) & 65535u))) - _e1760) * _e1768)) - _e1669) * _e1838)) - _e1780) * _e1842)) * _e1854) + _e1860);
let _e1899 = select(0f, _e1897, (_e1897 > 0f));
let _e1901 = select(1f, _e1899, (_e1899 < 1f));
let _e1902 = (_e1865 * 1024f);
let _e1903 = (1024f - 1f);
let _e1905 = select(0f, _e1902, (_e1902 > 0f));
let _e1907 = select(_e1903, _e1905, (_e1905 < _e1903));
let _e1914 = select(0i, select(select(i32(_e1907), i32(-2147483648), (_e1907 < -2147483600f)), 2147483647i, (_e1907 > 2147483500f)), (_e1907 == _e1907));
let _e1918 = (_e1914 - select(0i, 1i, (_e1907 < f32(_e1914))));
let _e1919 = (262147i + _e1918);
let _e1921 = (bitcast<i32>(_e123) - 1i);
let _e1923 = select(_e1921, _e1919, (_e1919 < _e1921));
let _e1929 = global_3.member[bitcast<u32>(select(0i, _e1923, (_e1923 > 0i)))];
let _e1939 = select(_e1921, 262146i, (262146i < _e1921));
let _e1945 = global_3.member[bitcast<u32>(select(0i, _e1939, (_e1939 > 0i)))];
let _e1946 = bitcast<f32>(_e1945);
let _e1947 = (f32((bitcast<i32>((_e1929 & 4095u)) - 2048i)) * _e1946);
let _e1949 = select(_e1921, 262144i, (262144i < _e1921));
let _e1955 = global_3.member[bitcast<u32>(select(0i, _e1949, (_e1949 > 0i)))];
let _e1956 = bitcast<f32>(_e1955);
let _e1958 = select(_e1921, 262145i, (262145i < _e1921));
let _e1964 = global_3.member[bitcast<u32>(select(0i, _e1958, (_e1958 > 0i)))];
let _e1965 = bitcast<f32>(_e1964);
let _e1971 = ((_e1956 + (f32(bitcast<i32>((_e1929 >> bitcast<u32>(12u)))) * _e1965)) + (_e1947 * (_e1902 - f32(_e1918))));
let _e1972 = (_e1947 * 1024f);
if _e800 {
let _e1979 = ((0.5f * (_e1877 - _e1871)) * _e1972);
let _e1980 = ((0.5f * (_e1889 - _e1883)) * _e1972);
let _e1981 = ((0.5f * (_e1901 - _e1895)) * _e1972);
phi_3793_ = type_29(_e1971, vec3<f32>(_e1979, _e1980, _e1981), vec3<f32>((_e1979 * _e1971), (_e1980 * _e1971), (_e1981 * _e1971)));
} else {
let _e1988 = (_e1871 * 1024f);
let _e1990 = select(0f, _e1988, (_e1988 > 0f));
let _e1992 = select(_e1903, _e1990, (_e1990 < _e1903));
let _e1999 = select(0i, select(select(i32(_e1992), i32(-2147483648), (_e1992 < -2147483600f)), 2147483647i, (_e1992 > 2147483500f)), (_e1992 == _e1992));
let _e2003 = (_e1999 - select(0i, 1i, (_e1992 < f32(_e1999))));
let _e2004 = (262147i + _e2003);
let _e2006 = select(_e1921, _e2004, (_e2004 < _e1921));
let _e2012 = global_3.member[bitcast<u32>(select(0i, _e2006, (_e2006 > 0i)))];
let _e2027 = ((_e1956 + (f32(bitcast<i32>((_e2012 >> bitcast<u32>(12u)))) * _e1965)) + ((f32((bitcast<i32>((_e2012 & 4095u)) - 2048i)) * _e1946) * (_e1988 - f32(_e2003))));
let _e2028 = (_e1877 * 1024f);
let _e2030 = select(0f, _e2028, (_e2028 > 0f));
let _e2032 = select(_e1903, _e2030, (_e2030 < _e1903));
let _e2039 = select(0i, select(select(i32(_e2032), i32(-2147483648), (_e2032 < -2147483600f)), 2147483647i, (_e2032 > 2147483500f)), (_e2032 == _e2032));
let _e2043 = (_e2039 - select(0i, 1i, (_e2032 < f32(_e2039))));
let _e2044 = (262147i + _e2043);
let _e2046 = select(_e1921, _e2044, (_e2044 < _e1921));
let _e2052 = global_3.member[bitcast<u32>(select(0i, _e2046, (_e2046 > 0i)))];
let _e2067 = ((_e1956 + (f32(bitcast<i32>((_e2052 >> bitcast<u32>(12u)))) * _e1965)) + ((f32((bitcast<i32>((_e2052 & 4095u)) - 2048i)) * _e1946) * (_e2028 - f32(_e2043))));
let _e2068 = (_e1883 * 1024f);
let _e2070 = select(0f, _e2068, (_e2068 > 0f));
let _e2072 = select(_e1903, _e2070, (_e2070 < _e1903));
let _e2079 = select(0i, select(select(i32(_e2072), i32(-2147483648), (_e2072 < -2147483600f)), 2147483647i, (_e2072 > 2147483500f)), (_e2072 == _e2072));
let _e2083 = (_e2079 - select(0i, 1i, (_e2072 < f32(_e2079))));
let _e2084 = (262147i + _e2083);
let _e2086 = select(_e1921, _e2084, (_e2084 < _e1921));
let _e2092 = global_3.member[bitcast<u32>(select(0i, _e2086, (_e2086 > 0i)))];
let _e2107 = ((_e1956 + (f32(bitcast<i32>((_e2092 >> bitcast<u32>(12u)))) * _e1965)) + ((f32((bitcast<i32>((_e2092 & 4095u)) - 2048i)) * _e1946) * (_e2068 - f32(_e2083))));
let _e2108 = (_e1889 * 1024f);
let _e2110 = select(0f, _e2108, (_e2108 > 0f));
let _e2112 = select(_e1903, _e2110, (_e2110 < _e1903));
let _e2119 = select(0i, select(select(i32(_e2112), i32(-2147483648), (_e2112 < -2147483600f)), 2147483647i, (_e2112 > 2147483500f)), (_e2112 == _e2112));
let _e2123 = (_e2119 - select(0i, 1i, (_e2112 < f32(_e2119))));
let _e2124 = (262147i + _e2123);
let _e2126 = select(_e1921, _e2124, (_e2124 < _e1921));
let _e2132 = global_3.member[bitcast<u32>(select(0i, _e2126, (_e2126 > 0i)))];
let _e2147 = ((_e1956 + (f32(bitcast<i32>((_e2132 >> bitcast<u32>(12u)))) * _e1965)) + ((f32((bitcast<i32>((_e2132 & 4095u)) - 2048i)) * _e1946) * (_e2108 - f32(_e2123))));
let _e2148 = (_e1895 * 1024f);
let _e2150 = select(0f, _e2148, (_e2148 > 0f));
let _e2152 = select(_e1903, _e2150, (_e2150 < _e1903));
let _e2159 = select(0i, select(select(i32(_e2152), i32(-2147483648), (_e2152 < -2147483600f)), 2147483647i, (_e2152 > 2147483500f)), (_e2152 == _e2152));
let _e2163 = (_e2159 - select(0i, 1i, (_e2152 < f32(_e2159))));
let _e2164 = (262147i + _e2163);
let _e2166 = select(_e1921, _e2164, (_e2164 < _e1921));
let _e2172 = global_3.member[bitcast<u32>(select(0i, _e2166, (_e2166 > 0i)))];
let _e2187 = ((_e1956 + (f32(bitcast<i32>((_e2172 >> bitcast<u32>(12u)))) * _e1965)) + ((f32((bitcast<i32>((_e2172 & 4095u)) - 2048i)) * _e1946) * (_e2148 - f32(_e2163))));
let _e2188 = (_e1901 * 1024f);
let _e2190 = select(0f, _e2188, (_e2188 > 0f));
let _e2192 = select(_e1903, _e2190, (_e2190 < _e1903));
let _e2199 = select(0i, select(select(i32(_e2192), i32(-2147483648), (_e2192 < -2147483600f)), 2147483647i, (_e2192 > 2147483500f)), (_e2192 == _e2192));
let _e2203 = (_e2199 - select(0i, 1i, (_e2192 < f32(_e2199))));
let _e2204 = (262147i + _e2203);
let _e2206 = select(_e1921, _e2204, (_e2204 < _e1921));
let _e2212 = global_3.member[bitcast<u32>(select(0i, _e2206, (_e2206 > 0i)))];
let _e2227 = ((_e1956 + (f32(bitcast<i32>((_e2212 >> bitcast<u32>(12u)))) * _e1965)) + ((f32((bitcast<i32>((_e2212 & 4095u)) - 2048i)) * _e1946) * (_e2188 - f32(_e2203))));
let _e2228 = (_e2067 - _e2027);
let _e2230 = (_e2147 - _e2107);
let _e2232 = (_e2227 - _e2187);
phi_3793_ = type_29(_e1971, vec3<f32>((0.5f * _e2228), (0.5f * _e2230), (0.5f * _e2232)), vec3<f32>((0.25f * (_e2228 * (_e2067 + _e2027))), (0.25f * (_e2230 * (_e2147 + _e2107))), (0.25f * (_e2232 * (_e2227 + _e2187)))));
}
let _e2247 = phi_3793_;
let _e2262 = select(0f, 1f, ((((((_e498 >= -0.5f) && (_e498 <= _e522)) && (_e504 >= -0.5f)) && (_e504 <= _e533)) && (_e510 >= -0.5f)) && (_e510 <= _e544)));
let _e2264 = (0.5f * (_e1877 - _e1871));
let _e2266 = (0.5f * (_e1889 - _e1883));
let _e2268 = (0.5f * (_e1901 - _e1895));
let _e2275 = global_5.member[_e352].member_6.member.member.member;
let _e2282 = global_5.member[_e352].member_6.member.member.member_1;
let _e2289 = global_5.member[_e352].member_6.member.member.member_2;
let _e2296 = global_5.member[_e352].member_6.member_1.member.member;
let _e2303 = global_5.member[_e352].member_6.member_1.member.member_1;
let _e2310 = global_5.member[_e352].member_6.member_1.member.member_2;
let _e2317 = global_5.member[_e352].member_6.member_2.member.member;
let _e2324 = global_5.member[_e352].member_6.member_2.member.member_1;
let _e2331 = global_5.member[_e352].member_6.member_2.member.member_2;
phi_4494_ = type_30(_e1865, vec3<f32>(((((_e2275 * _e2264) + (_e2296 * _e2266)) + (_e2317 * _e2268)) * _e2262), ((((_e2282 * _e2264) + (_e2303 * _e2266)) + (_e2324 * _e2268)) * _e2262), ((((_e2289 * _e2264) + (_e2310 * _e2266)) + (_e2331 * _e2268)) * _e2262)), _e2247.member, vec3<f32>(((((_e2275 * _e2247.member_2.x) + (_e2296 * _e2247.member_2.y)) + (_e2317 * _e2247.member_2.z)) * _e2262), ((((_e2282 * _e2247.member_2.x) + (_e2303 * _e2247.member_2.y)) + (_e2324 * _e2247.member_2.z)) * _e2262), ((((_e2289 * _e2247.member_2.x) + (_e2310 * _e2247.member_2.y)) + (_e2331 * _e2247.member_2.z)) * _e2262)), vec3<f32>(((((_e2275 * _e2247.member_1.x) + (_e2296 * _e2247.member_1.y)) + (_e2317 * _e2247.member_1.z)) * _e2262), ((((_e2282 * _e2247.member_1.x) + (_e2303 * _e2247.member_1.y)) + (_e2324 * _e2247.member_1.z)) * _e2262), ((((_e2289 * _e2247.member_1.x) + (_e2310 * _e2247.member_1.y)) + (_e2331 * _e2247.member_1.z)) * _e2262)));
} else {
let _e2397 = select(-1f, _e526, (_e526 > -1f));
let _e2399 = select(_e521, _e2397, (_e2397 < _e521));
let _e2406 = select(0i, select(select(i32(_e2399), i32(-2147483648), (_e2399 < -2147483600f)), 2147483647i, (_e2399 > 2147483500f)), (_e2399 == _e2399));
let _e2410 = (_e2406 - select(0i, 1i, (_e2399 < f32(_e2406))));
let _e2412 = select(-1f, _e537, (_e537 > -1f));
let _e2414 = select(_e532, _e2412, (_e2412 < _e532));
let _e2421 = select(0i, select(select(i32(_e2414), i32(-2147483648), (_e2414 < -2147483600f)), 2147483647i, (_e2414 > 2147483500f)), (_e2414 == _e2414));
let _e2425 = (_e2421 - select(0i, 1i, (_e2414 < f32(_e2421))));
let _e2427 = select(-1f, _e548, (_e548 > -1f));
let _e2429 = select(_e543, _e2427, (_e2427 < _e543));
let _e2436 = select(0i, select(select(i32(_e2429), i32(-2147483648), (_e2429 < -2147483600f)), 2147483647i, (_e2429 > 2147483500f)), (_e2429 == _e2429));
let _e2440 = (_e2436 - select(0i, 1i, (_e2429 < f32(_e2436))));
let _e2445 = global_5.member[_e352].member_6.member_7;
let _e2450 = global_5.member[_e352].member_6.member_8;
let _e2451 = (_e2410 + 1i);
let _e2452 = (_e2425 + 1i);
let _e2453 = (_e2440 + 1i);
let _e2459 = global_5.member[_e352].member_6.member_11.member;
let _e2466 = global_5.member[_e352].member_6.member_11.member_1;
let _e2477 = ((_e2451 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2459) * ((_e2452 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2466) * (_e2453 >> bitcast<u32>(4i))))));
let _e2479 = (bitcast<i32>(_e119) - 1i);
let _e2481 = select(_e2479, _e2477, (_e2477 < _e2479));
let _e2487 = global_1.member[bitcast<u32>(select(0i, _e2481, (_e2481 > 0i)))];
let _e2489 = (_e2451 & 15i);
let _e2492 = ((_e2452 & 15i) * _e2445);
let _e2494 = (bitcast<i32>(_e2487) + ((_e2453 & 15i) * _e2450));
let _e2498 = (_e2492 + _e2445);
let _e2500 = (_e2492 + (2i * _e2445));
let _e2501 = (_e2494 + _e2450);
let _e2503 = (_e2494 + (2i * _e2450));
local_4 = type_28(array<i32, 4>(_e2489, (_e2489 + 1i), (_e2489 + 2i), (_e2489 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_5 = vec3<f32>((_e526 - f32(_e2410)), (_e537 - f32(_e2425)), (_e548 - f32(_e2440)));
let _e2517 = local_4.member[1u];
let _e2518 = ((_e2501 + _e2498) + _e2517);
let _e2520 = (_e2518 >> bitcast<u32>(1i));
let _e2523 = bitcast<u32>(((_e2518 & 1i) * 16i));
let _e2525 = select(_e2479, _e2520, (_e2520 < _e2479));
let _e2530 = global_1.member[bitcast<u32>(select(0i, _e2525, (_e2525 > 0i)))];
let _e2534 = (_e2520 + 1i);
let _e2536 = select(_e2479, _e2534, (_e2534 < _e2479));
let _e2541 = global_1.member[bitcast<u32>(select(0i, _e2536, (_e2536 > 0i)))];
let _e2548 = ((_e2530 >> bitcast<u32>((_e2523 & 31u))) | ((_e2541 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2523) & 31u))));
let _e2551 = local_4.member_1[2u];
let _e2557 = f32(bitcast<i32>(((_e2548 >> bitcast<u32>((_e2551 & 31u))) & 65535u)));
let _e2560 = local_4.member_1[3u];
let _e2567 = local_5[0u];
let _e2570 = (_e2557 + ((f32(bitcast<i32>(((_e2548 >> bitcast<u32>((_e2560 & 31u))) & 65535u))) - _e2557) * _e2567));
let _e2572 = local_4.member[1u];
let _e2573 = ((_e2501 + _e2500) + _e2572);
let _e2575 = (_e2573 >> bitcast<u32>(1i));
let _e2578 = bitcast<u32>(((_e2573 & 1i) * 16i));
let _e2580 = select(_e2479, _e2575, (_e2575 < _e2479));
let _e2585 = global_1.member[bitcast<u32>(select(0i, _e2580, (_e2580 > 0i)))];
let _e2589 = (_e2575 + 1i);
let _e2591 = select(_e2479, _e2589, (_e2589 < _e2479));
let _e2596 = global_1.member[bitcast<u32>(select(0i, _e2591, (_e2591 > 0i)))];
let _e2603 = ((_e2585 >> bitcast<u32>((_e2578 & 31u))) | ((_e2596 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2578) & 31u))));
let _e2604 = local_4.member_1[2u];
let _e2610 = f32(bitcast<i32>(((_e2603 >> bitcast<u32>((_e2604 & 31u))) & 65535u)));
let _e2611 = local_4.member_1[3u];
let _e2618 = local_5[0u];
let _e2623 = local_5[1u];
let _e2626 = (_e2570 + (((_e2610 + ((f32(bitcast<i32>(((_e2603 >> bitcast<u32>((_e2611 & 31u))) & 65535u))) - _e2610) * _e2618)) - _e2570) * _e2623));
let _e2628 = local_4.member[1u];
let _e2629 = ((_e2503 + _e2498) + _e2628);
let _e2631 = (_e2629 >> bitcast<u32>(1i));
let _e2634 = bitcast<u32>(((_e2629 & 1i) * 16i));
let _e2636 = select(_e2479, _e2631, (_e2631 < _e2479));
let _e2641 = global_1.member[bitcast<u32>(select(0i, _e2636, (_e2636 > 0i)))];
let _e2645 = (_e2631 + 1i);
let _e2647 = select(_e2479, _e2645, (_e2645 < _e2479));
let _e2652 = global_1.member[bitcast<u32>(select(0i, _e2647, (_e2647 > 0i)))];
let _e2659 = ((_e2641 >> bitcast<u32>((_e2634 & 31u))) | ((_e2652 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2634) & 31u))));
let _e2660 = local_4.member_1[2u];
let _e2666 = f32(bitcast<i32>(((_e2659 >> bitcast<u32>((_e2660 & 31u))) & 65535u)));
let _e2667 = local_4.member_1[3u];
let _e2674 = local_5[0u];
let _e2677 = (_e2666 + ((f32(bitcast<i32>(((_e2659 >> bitcast<u32>((_e2667 & 31u))) & 65535u))) - _e2666) * _e2674));
let _e2679 = local_4.member[1u];
let _e2680 = ((_e2503 + _e2500) + _e2679);
let _e2682 = (_e2680 >> bitcast<u32>(1i));
let _e2685 = bitcast<u32>(((_e2680 & 1i) * 16i));
let _e2687 = select(_e2479, _e2682, (_e2682 < _e2479));
let _e2692 = global_1.member[bitcast<u32>(select(0i, _e2687, (_e2687 > 0i)))];
let _e2696 = (_e2682 + 1i);
let _e2698 = select(_e2479, _e2696, (_e2696 < _e2479));
let _e2703 = global_1.member[bitcast<u32>(select(0i, _e2698, (_e2698 > 0i)))];
let _e2710 = ((_e2692 >> bitcast<u32>((_e2685 & 31u))) | ((_e2703 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2685) & 31u))));
let _e2711 = local_4.member_1[2u];
let _e2717 = f32(bitcast<i32>(((_e2710 >> bitcast<u32>((_e2711 & 31u))) & 65535u)));
let _e2718 = local_4.member_1[3u];
let _e2725 = local_5[0u];
let _e2729 = local_5[1u];
let _e2734 = local_5[2u];
let _e2742 = global_5.member[_e352].member_6.member_5;
let _e2748 = global_5.member[_e352].member_6.member_6;
let _e2749 = (((_e2626 + (((_e2677 + (((_e2717 + ((f32(bitcast<i32>(((_e2710 >> bitcast<u32>((_e2718 & 31u))) & 65535u))) - _e2717) * _e2725)) - _e2677) * _e2729)) - _e2626) * _e2734)) * _e2742) + _e2748);
let _e2751 = select(0f, _e2749, (_e2749 > 0f));
phi_4494_ = type_30(select(1f, _e2751, (_e2751 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2756 = phi_4494_;
let _e2758 = select(-0.5f, _e460, (_e460 > -0.5f));
let _e2760 = select(_e522, _e2758, (_e2758 < _e522));
let _e2762 = select(-0.5f, _e476, (_e476 > -0.5f));
let _e2764 = select(_e533, _e2762, (_e2762 < _e533));
let _e2766 = select(-0.5f, _e492, (_e492 > -0.5f));
let _e2768 = select(_e544, _e2766, (_e2766 < _e544));
let _e2770 = select(-1f, _e2760, (_e2760 > -1f));
let _e2772 = select(_e521, _e2770, (_e2770 < _e521));
let _e2779 = select(0i, select(select(i32(_e2772), i32(-2147483648), (_e2772 < -2147483600f)), 2147483647i, (_e2772 > 2147483500f)), (_e2772 == _e2772));
let _e2783 = (_e2779 - select(0i, 1i, (_e2772 < f32(_e2779))));
let _e2785 = select(-1f, _e2764, (_e2764 > -1f));
let _e2787 = select(_e532, _e2785, (_e2785 < _e532));
let _e2794 = select(0i, select(select(i32(_e2787), i32(-2147483648), (_e2787 < -2147483600f)), 2147483647i, (_e2787 > 2147483500f)), (_e2787 == _e2787));
let _e2798 = (_e2794 - select(0i, 1i, (_e2787 < f32(_e2794))));
let _e2800 = select(-1f, _e2768, (_e2768 > -1f));
let _e2802 = select(_e543, _e2800, (_e2800 < _e543));
let _e2809 = select(0i, select(select(i32(_e2802), i32(-2147483648), (_e2802 < -2147483600f)), 2147483647i, (_e2802 > 2147483500f)), (_e2802 == _e2802));
let _e2813 = (_e2809 - select(0i, 1i, (_e2802 < f32(_e2809))));
let _e2818 = global_5.member[_e352].member_6.member_7;
let _e2823 = global_5.member[_e352].member_6.member_8;
let _e2824 = (_e2783 + 1i);
let _e2825 = (_e2798 + 1i);
let _e2826 = (_e2813 + 1i);
let _e2832 = global_5.member[_e352].member_6.member_11.member;
let _e2839 = global_5.member[_e352].member_6.member_11.member_1;
let _e2850 = ((_e2824 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2832) * ((_e2825 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2839) * (_e2826 >> bitcast<u32>(4i))))));
let _e2852 = (bitcast<i32>(_e119) - 1i);
let _e2854 = select(_e2852, _e2850, (_e2850 < _e2852));
let _e2860 = global_1.member[bitcast<u32>(select(0i, _e2854, (_e2854 > 0i)))];
let _e2862 = (_e2824 & 15i);
let _e2865 = ((_e2825 & 15i) * _e2818);
let _e2867 = (bitcast<i32>(_e2860) + ((_e2826 & 15i) * _e2823));
let _e2871 = (_e2865 + _e2818);
let _e2873 = (_e2865 + (2i * _e2818));
let _e2874 = (_e2867 + _e2823);
let _e2876 = (_e2867 + (2i * _e2823));
local_2 = type_28(array<i32, 4>(_e2862, (_e2862 + 1i), (_e2862 + 2i), (_e2862 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_3 = vec3<f32>((_e2760 - f32(_e2783)), (_e2764 - f32(_e2798)), (_e2768 - f32(_e2813)));
let _e2890 = local_2.member[1u];
let _e2891 = ((_e2874 + _e2871) + _e2890);
let _e2893 = (_e2891 >> bitcast<u32>(1i));
let _e2896 = bitcast<u32>(((_e2891 & 1i) * 16i));
let _e2898 = select(_e2852, _e2893, (_e2893 < _e2852));
let _e2903 = global_1.member[bitcast<u32>(select(0i, _e2898, (_e2898 > 0i)))];
let _e2907 = (_e2893 + 1i);
let _e2909 = select(_e2852, _e2907, (_e2907 < _e2852));
let _e2914 = global_1.member[bitcast<u32>(select(0i, _e2909, (_e2909 > 0i)))];
let _e2921 = ((_e2903 >> bitcast<u32>((_e2896 & 31u))) | ((_e2914 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2896) & 31u))));
let _e2924 = local_2.member_1[2u];
let _e2930 = f32(bitcast<i32>(((_e2921 >> bitcast<u32>((_e2924 & 31u))) & 65535u)));
let _e2933 = local_2.member_1[3u];
let _e2940 = local_3[0u];
let _e2943 = (_e2930 + ((f32(bitcast<i32>(((_e2921 >> bitcast<u32>((_e2933 & 31u))) & 65535u))) - _e2930) * _e2940));
let _e2945 = local_2.member[1u];
let _e2946 = ((_e2874 + _e2873) + _e2945);
let _e2948 = (_e2946 >> bitcast<u32>(1i));
let _e2951 = bitcast<u32>(((_e2946 & 1i) * 16i));
let _e2953 = select(_e2852, _e2948, (_e2948 < _e2852));
let _e2958 = global_1.member[bitcast<u32>(select(0i, _e2953, (_e2953 > 0i)))];
let _e2962 = (_e2948 + 1i);
let _e2964 = select(_e2852, _e2962, (_e2962 < _e2852));
let _e2969 = global_1.member[bitcast<u32>(select(0i, _e2964, (_e2964 > 0i)))];
let _e2976 = ((_e2958 >> bitcast<u32>((_e2951 & 31u))) | ((_e2969 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2951) & 31u))));
let _e2977 = local_2.member_1[2u];
let _e2983 = f32(bitcast<i32>(((_e2976 >> bitcast<u32>((_e2977 & 31u))) & 65535u)));
let _e2984 = local_2.member_1[3u];
let _e2991 = local_3[0u];
let _e2996 = local_3[1u];
let _e2999 = (_e2943 + (((_e2983 + ((f32(bitcast<i32>(((_e2976 >> bitcast<u32>((_e2984 & 31u))) & 65535u))) - _e2983) * _e2991)) - _e2943) * _e2996));
let _e3001 = local_2.member[1u];
let _e3002 = ((_e2876 + _e2871) + _e3001);
let _e3004 = (_e3002 >> bitcast<u32>(1i));
let _e3007 = bitcast<u32>(((_e3002 & 1i) * 16i));
let _e3009 = select(_e2852, _e3004, (_e3004 < _e2852));
let _e3014 = global_1.member[bitcast<u32>(select(0i, _e3009, (_e3009 > 0i)))];
let _e3018 = (_e3004 + 1i);
let _e3020 = select(_e2852, _e3018, (_e3018 < _e2852));
let _e3025 = global_1.member[bitcast<u32>(select(0i, _e3020, (_e3020 > 0i)))];
let _e3032 = ((_e3014 >> bitcast<u32>((_e3007 & 31u))) | ((_e3025 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3007) & 31u))));
let _e3033 = local_2.member_1[2u];
let _e3039 = f32(bitcast<i32>(((_e3032 >> bitcast<u32>((_e3033 & 31u))) & 65535u)));
let _e3040 = local_2.member_1[3u];
let _e3047 = local_3[0u];
let _e3050 = (_e3039 + ((f32(bitcast<i32>(((_e3032 >> bitcast<u32>((_e3040 & 31u))) & 65535u))) - _e3039) * _e3047));
let _e3052 = local_2.member[1u];
let _e3053 = ((_e2876 + _e2873) + _e3052);
let _e3055 = (_e3053 >> bitcast<u32>(1i));
let _e3058 = bitcast<u32>(((_e3053 & 1i) * 16i));
let _e3060 = select(_e2852, _e3055, (_e3055 < _e2852));
let _e3065 = global_1.member[bitcast<u32>(select(0i, _e3060, (_e3060 > 0i)))];
let _e3069 = (_e3055 + 1i);
let _e3071 = select(_e2852, _e3069, (_e3069 < _e2852));
let _e3076 = global_1.member[bitcast<u32>(select(0i, _e3071, (_e3071 > 0i)))];
let _e3083 = ((_e3065 >> bitcast<u32>((_e3058 & 31u))) | ((_e3076 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3058) & 31u))));
let _e3084 = local_2.member_1[2u];
let _e3090 = f32(bitcast<i32>(((_e3083 >> bitcast<u32>((_e3084 & 31u))) & 65535u)));
let _e3091 = local_2.member_1[3u];
let _e3098 = local_3[0u];
let _e3102 = local_3[1u];
let _e3107 = local_3[2u];
let _e3115 = global_5.member[_e352].member_6.member_5;
let _e3121 = global_5.member[_e352].member_6.member_6;
let _e3122 = (((_e2999 + (((_e3050 + (((_e3090 + ((f32(bitcast<i32>(((_e3083 >> bitcast<u32>((_e3091 & 31u))) & 65535u))) - _e3090) * _e3098)) - _e3050) * _e3102)) - _e2999) * _e3107)) * _e3115) + _e3121);
let _e3124 = select(0f, _e3122, (_e3122 > 0f));
let _e3126 = select(1f, _e3124, (_e3124 < 1f));
let _e3127 = select(_e356[6], _e3126, _e719);
if _e803 {
let _e3128 = (_e3126 * 1024f);
let _e3129 = (1024f - 1f);
let _e3131 = select(0f, _e3128, (_e3128 > 0f));
let _e3133 = select(_e3129, _e3131, (_e3131 < _e3129));
let _e3140 = select(0i, select(select(i32(_e3133), i32(-2147483648), (_e3133 < -2147483600f)), 2147483647i, (_e3133 > 2147483500f)), (_e3133 == _e3133));
let _e3144 = (_e3140 - select(0i, 1i, (_e3133 < f32(_e3140))));
let _e3145 = (262147i + _e3144);
let _e3147 = (bitcast<i32>(_e123) - 1i);
let _e3149 = select(_e3147, _e3145, (_e3145 < _e3147));
let _e3155 = global_3.member[bitcast<u32>(select(0i, _e3149, (_e3149 > 0i)))];
let _e3165 = select(_e3147, 262146i, (262146i < _e3147));
let _e3171 = global_3.member[bitcast<u32>(select(0i, _e3165, (_e3165 > 0i)))];
let _e3175 = select(_e3147, 262144i, (262144i < _e3147));
let _e3181 = global_3.member[bitcast<u32>(select(0i, _e3175, (_e3175 > 0i)))];
let _e3184 = select(_e3147, 262145i, (262145i < _e3147));
let _e3190 = global_3.member[bitcast<u32>(select(0i, _e3184, (_e3184 > 0i)))];
phi_5132_ = select(_e356[16], ((bitcast<f32>(_e3181) + (f32(bitcast<i32>((_e3155 >> bitcast<u32>(12u)))) * bitcast<f32>(_e3190))) + ((f32((bitcast<i32>((_e3155 & 4095u)) - 2048i)) * bitcast<f32>(_e3171)) * (_e3128 - f32(_e3144)))), _e719);
} else {
phi_5132_ = _e356[16];
}
let _e3200 = phi_5132_;
let _e3203 = select(1f, select(1f, _e798, (_e798 < 1f)), _e444);
if ((_e687 & 16u) == 0u) {
phi_5521_ = type_5(1f, 1f, 1f);
} else {
let _e3210 = global_5.member[_e352].member_14.member;
let _e3221 = ((((_e3210.member.member * _e380) + (_e3210.member.member_1 * _e382)) + (_e3210.member.member_2 * _e376)) + _e3210.member_1);
let _e3227 = ((((_e3210.member.member * _e384) + (_e3210.member.member_1 * _e386)) + (_e3210.member.member_2 * _e391)) + _e3210.member_1);
let _e3229 = select(_e3227, _e3221, (_e3221 < _e3227));
let _e3231 = select(_e3227, _e3221, (_e3221 > _e3227));
let _e3233 = (_e3231 - _e3229);
let _e3236 = (-(_e3229) / select(1e-30f, _e3233, (_e3233 > 1e-30f)));
let _e3238 = select(0f, _e3236, (_e3236 > 0f));
let _e3244 = select(select(select(1f, _e3238, (_e3238 < 1f)), 1f, (_e3231 <= 0f)), 0f, (_e3229 > 0f));
let _e3250 = global_5.member[_e352].member_14.member_1;
let _e3251 = (_e3250 != 0u);
let _e3262 = global_5.member[_e352].member_15.member;
let _e3273 = ((((_e3262.member.member * _e380) + (_e3262.member.member_1 * _e382)) + (_e3262.member.member_2 * _e376)) + _e3262.member_1);
let _e3279 = ((((_e3262.member.member * _e384) + (_e3262.member.member_1 * _e386)) + (_e3262.member.member_2 * _e391)) + _e3262.member_1);
let _e3281 = select(_e3279, _e3273, (_e3273 < _e3279));
let _e3283 = select(_e3279, _e3273, (_e3273 > _e3279));
let _e3285 = (_e3283 - _e3281);
let _e3288 = (-(_e3281) / select(1e-30f, _e3285, (_e3285 > 1e-30f)));
let _e3290 = select(0f, _e3288, (_e3288 > 0f));
let _e3296 = select(select(select(1f, _e3290, (_e3290 < 1f)), 1f, (_e3283 <= 0f)), 0f, (_e3281 > 0f));
let _e3302 = global_5.member[_e352].member_15.member_1;
let _e3303 = (_e3302 != 0u);
let _e3314 = global_5.member[_e352].member_16.member;
let _e3325 = ((((_e3314.member.member * _e380) + (_e3314.member.member_1 * _e382)) + (_e3314.member.member_2 * _e376)) + _e3314.member_1);
let _e3331 = ((((_e3314.member.member * _e384) + (_e3314.member.member_1 * _e386)) + (_e3314.member.member_2 * _e391)) + _e3314.member_1);
let _e3333 = select(_e3331, _e3325, (_e3325 < _e3331));
let _e3335 = select(_e3331, _e3325, (_e3325 > _e3331));
let _e3337 = (_e3335 - _e3333);
let _e3340 = (-(_e3333) / select(1e-30f, _e3337, (_e3337 > 1e-30f)));
let _e3342 = select(0f, _e3340, (_e3340 > 0f));
let _e3348 = select(select(select(1f, _e3342, (_e3342 < 1f)), 1f, (_e3335 <= 0f)), 0f, (_e3333 > 0f));
let _e3354 = global_5.member[_e352].member_16.member_1;
let _e3355 = (_e3354 != 0u);
let _e3366 = global_5.member[_e352].member_17.member;
let _e3377 = ((((_e3366.member.member * _e380) + (_e3366.member.member_1 * _e382)) + (_e3366.member.member_2 * _e376)) + _e3366.member_1);
let _e3383 = ((((_e3366.member.member * _e384) + (_e3366.member.member_1 * _e386)) + (_e3366.member.member_2 * _e391)) + _e3366.member_1);
let _e3385 = select(_e3383, _e3377, (_e3377 < _e3383));
let _e3387 = select(_e3383, _e3377, (_e3377 > _e3383));
let _e3389 = (_e3387 - _e3385);
let _e3392 = (-(_e3385) / select(1e-30f, _e3389, (_e3389 > 1e-30f)));
let _e3394 = select(0f, _e3392, (_e3392 > 0f));
let _e3400 = select(select(select(1f, _e3394, (_e3394 < 1f)), 1f, (_e3387 <= 0f)), 0f, (_e3385 > 0f));
let _e3406 = global_5.member[_e352].member_17.member_1;
let _e3407 = (_e3406 != 0u);
phi_5521_ = type_5(((((1f * _e3244) * _e3296) * _e3348) * _e3400), ((((1f * select(1f, _e3244, _e3251)) * select(1f, _e3296, _e3303)) * select(1f, _e3348, _e3355)) * select(1f, _e3400, _e3407)), ((((1f * select(1f, 0f, (_e3251 && (_e3227 > 0f)))) * select(1f, 0f, (_e3303 && (_e3279 > 0f)))) * select(1f, 0f, (_e3355 && (_e3331 > 0f)))) * select(1f, 0f, (_e3407 && (_e3383 > 0f)))));
}
let _e3416 = phi_5521_;
let _e3417 = (_e554 < 1e-12f);
let _e3419 = (1f / select(_e549, 1f, _e3417));
let _e3421 = ((-0.5f - _e460) * _e3419);
let _e3423 = ((_e522 - _e460) * _e3419);
let _e3429 = select(_e3423, _e3421, (_e3421 < _e3423));
let _e3431 = select(0f, _e3429, (_e3429 > 0f));
let _e3434 = select(select(1f, _e3431, (_e3431 < 1f)), select(2f, 0f, ((_e460 >= -0.5f) && (_e460 <= _e522))), _e3417);
let _e3436 = select(_e3423, _e3421, (_e3421 > _e3423));
let _e3438 = select(0f, _e3436, (_e3436 > 0f));
let _e3441 = select(select(1f, _e3438, (_e3438 < 1f)), 1f, _e3417);
let _e3442 = (_e557 < 1e-12f);
let _e3444 = (1f / select(_e550, 1f, _e3442));
let _e3446 = ((-0.5f - _e476) * _e3444);
let _e3448 = ((_e533 - _e476) * _e3444);
let _e3454 = select(_e3448, _e3446, (_e3446 < _e3448));
let _e3456 = select(0f, _e3454, (_e3454 > 0f));
let _e3459 = select(select(1f, _e3456, (_e3456 < 1f)), select(2f, 0f, ((_e476 >= -0.5f) && (_e476 <= _e533))), _e3442);
let _e3461 = select(_e3448, _e3446, (_e3446 > _e3448));
let _e3463 = select(0f, _e3461, (_e3461 > 0f));
let _e3466 = select(select(1f, _e3463, (_e3463 < 1f)), 1f, _e3442);
let _e3467 = (_e562 < 1e-12f);
let _e3469 = (1f / select(_e551, 1f, _e3467));
let _e3471 = ((-0.5f - _e492) * _e3469);
let _e3473 = ((_e544 - _e492) * _e3469);
let _e3479 = select(_e3473, _e3471, (_e3471 < _e3473));
let _e3481 = select(0f, _e3479, (_e3479 > 0f));
let _e3484 = select(select(1f, _e3481, (_e3481 < 1f)), select(2f, 0f, ((_e492 >= -0.5f) && (_e492 <= _e544))), _e3467);
let _e3486 = select(_e3473, _e3471, (_e3471 > _e3473));
let _e3488 = select(0f, _e3486, (_e3486 > 0f));
let _e3491 = select(select(1f, _e3488, (_e3488 < 1f)), 1f, _e3467);
let _e3493 = select(_e3466, _e3441, (_e3441 < _e3466));
let _e3497 = select(_e3459, _e3434, (_e3434 > _e3459));
let _e3500 = (select(_e3491, _e3493, (_e3493 < _e3491)) - select(_e3484, _e3497, (_e3497 > _e3484)));
let _e3503 = (_e384 - _e380);
let _e3504 = (_e386 - _e382);
let _e3505 = (_e391 - _e376);
let _e3510 = (((_e3503 * _e3503) + (_e3504 * _e3504)) + (_e3505 * _e3505));
let _e3520 = global_5.member[_e352].member_5.member_3;
let _e3521 = (((sqrt(select(0f, _e3510, (_e3510 > 0f))) * select(0f, _e3500, (_e3500 > 0f))) * _e3203) * _e3520);
let _e3522 = (_e729.member_2 >= 3u);
if _e3522 {
let _e3524 = (_e3127 * 255f);
let _e3525 = (_e2756.member * 255f);
let _e3526 = (255f - 1f);
let _e3528 = select(0f, _e3524, (_e3524 > 0f));
let _e3530 = select(_e3526, _e3528, (_e3528 < _e3526));
let _e3537 = select(0i, select(select(i32(_e3530), i32(-2147483648), (_e3530 < -2147483600f)), 2147483647i, (_e3530 > 2147483500f)), (_e3530 == _e3530));
let _e3541 = (_e3537 - select(0i, 1i, (_e3530 < f32(_e3537))));
let _e3543 = select(0f, _e3525, (_e3525 > 0f));
let _e3545 = select(_e3526, _e3543, (_e3543 < _e3526));
let _e3552 = select(0i, select(select(i32(_e3545), i32(-2147483648), (_e3545 < -2147483600f)), 2147483647i, (_e3545 > 2147483500f)), (_e3545 == _e3545));
let _e3556 = (_e3552 - select(0i, 1i, (_e3545 < f32(_e3552))));
let _e3559 = (((_e3541 * 256i) + _e3556) * 4i);
let _e3561 = (_e3524 - f32(_e3541));
let _e3563 = (_e3525 - f32(_e3556));
let _e3564 = (_e3559 + 2i);
let _e3566 = (bitcast<i32>(_e123) - 1i);
let _e3568 = select(_e3566, _e3564, (_e3564 < _e3566));
let _e3574 = global_3.member[bitcast<u32>(select(0i, _e3568, (_e3568 > 0i)))];
let _e3575 = (_e3559 + 6i);
let _e3577 = select(_e3566, _e3575, (_e3575 < _e3566));
let _e3583 = global_3.member[bitcast<u32>(select(0i, _e3577, (_e3577 > 0i)))];
let _e3584 = (_e3559 + 1026i);
let _e3586 = select(_e3566, _e3584, (_e3584 < _e3566));
let _e3592 = global_3.member[bitcast<u32>(select(0i, _e3586, (_e3586 > 0i)))];
let _e3593 = (_e3559 + 1030i);
let _e3595 = select(_e3566, _e3593, (_e3593 < _e3566));
let _e3601 = global_3.member[bitcast<u32>(select(0i, _e3595, (_e3595 > 0i)))];
let _e3606 = (bitcast<f32>(((_e3574 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3614 = (_e3606 + (((bitcast<f32>(((_e3583 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3606) * _e3563));
let _e3619 = (bitcast<f32>(((_e3592 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3643 = (bitcast<f32>((((_e3574 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3651 = (_e3643 + (((bitcast<f32>((((_e3583 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3643) * _e3563));
let _e3656 = (bitcast<f32>((((_e3592 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3668 = (_e3559 + 3i);
let _e3670 = select(_e3566, _e3668, (_e3668 < _e3566));
let _e3676 = global_3.member[bitcast<u32>(select(0i, _e3670, (_e3670 > 0i)))];
let _e3677 = (_e3559 + 7i);
let _e3679 = select(_e3566, _e3677, (_e3677 < _e3566));
let _e3685 = global_3.member[bitcast<u32>(select(0i, _e3679, (_e3679 > 0i)))];
let _e3686 = (_e3559 + 1027i);
let _e3688 = select(_e3566, _e3686, (_e3686 < _e3566));
let _e3694 = global_3.member[bitcast<u32>(select(0i, _e3688, (_e3688 > 0i)))];
let _e3695 = (_e3559 + 1031i);
let _e3697 = select(_e3566, _e3695, (_e3695 < _e3566));
let _e3703 = global_3.member[bitcast<u32>(select(0i, _e3697, (_e3697 > 0i)))];
let _e3708 = (bitcast<f32>(((_e3676 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3716 = (_e3708 + (((bitcast<f32>(((_e3685 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3708) * _e3563));
let _e3721 = (bitcast<f32>(((_e3694 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3745 = (bitcast<f32>((((_e3676 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3753 = (_e3745 + (((bitcast<f32>((((_e3685 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3745) * _e3563));
let _e3758 = (bitcast<f32>((((_e3694 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3769 = (_e3753 + (((_e3758 + (((bitcast<f32>((((_e3703 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3758) * _e3563)) - _e3753) * _e3561));
let _e3773 = -((_e3769 * (_e3521 * _e3416.member)));
let _e3775 = select(-87f, _e3773, (_e3773 > -87f));
let _e3777 = select(88f, _e3775, (_e3775 < 88f));
let _e3779 = ((_e3777 * 1.442695f) + 0.5f);
let _e3781 = select(-127f, _e3779, (_e3779 > -127f));
let _e3783 = select(128f, _e3781, (_e3781 < 128f));
let _e3790 = select(0i, select(select(i32(_e3783), i32(-2147483648), (_e3783 < -2147483600f)), 2147483647i, (_e3783 > 2147483500f)), (_e3783 == _e3783));
let _e3794 = (_e3790 - select(0i, 1i, (_e3783 < f32(_e3790))));
let _e3795 = f32(_e3794);
let _e3799 = ((_e3777 - (_e3795 * 0.6933594f)) - (_e3795 * -2.1219444e-4f));
let _e3819 = ((1f + (_e3799 * (1f + (_e3799 * (0.5f + (_e3799 * (0.16666667f + (_e3799 * (0.041666668f + (_e3799 * (0.008333334f + (_e3799 * (0.001388889f + (_e3799 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3794 + 127i)) << bitcast<u32>(23i))));
let _e3820 = (1f - _e3819);
let _e3823 = (_e3820 / select(1e-12f, _e3769, (_e3769 > 1e-12f)));
phi_7079_ = type_31(_e3819, _e3820, vec3<f32>(1f, 1f, 1f), vec3<f32>(((_e3614 + (((_e3619 + (((bitcast<f32>(((_e3601 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3619) * _e3563)) - _e3614) * _e3561)) * _e3823), ((_e3651 + (((_e3656 + (((bitcast<f32>((((_e3601 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3656) * _e3563)) - _e3651) * _e3561)) * _e3823), ((_e3716 + (((_e3721 + (((bitcast<f32>(((_e3703 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3721) * _e3563)) - _e3716) * _e3561)) * _e3823)));
} else {
let _e3830 = (_e3127 * 255f);
let _e3831 = (_e2756.member * 255f);
let _e3832 = (255f - 1f);
let _e3834 = select(0f, _e3830, (_e3830 > 0f));
let _e3836 = select(_e3832, _e3834, (_e3834 < _e3832));
let _e3843 = select(0i, select(select(i32(_e3836), i32(-2147483648), (_e3836 < -2147483600f)), 2147483647i, (_e3836 > 2147483500f)), (_e3836 == _e3836));
let _e3847 = (_e3843 - select(0i, 1i, (_e3836 < f32(_e3843))));
let _e3849 = select(0f, _e3831, (_e3831 > 0f));
let _e3851 = select(_e3832, _e3849, (_e3849 < _e3832));
let _e3858 = select(0i, select(select(i32(_e3851), i32(-2147483648), (_e3851 < -2147483600f)), 2147483647i, (_e3851 > 2147483500f)), (_e3851 == _e3851));
let _e3862 = (_e3858 - select(0i, 1i, (_e3851 < f32(_e3858))));
let _e3865 = (((_e3847 * 256i) + _e3862) * 4i);
let _e3867 = (_e3830 - f32(_e3847));
let _e3869 = (_e3831 - f32(_e3862));
let _e3871 = (bitcast<i32>(_e123) - 1i);
let _e3873 = select(_e3871, _e3865, (_e3865 < _e3871));
let _e3879 = global_3.member[bitcast<u32>(select(0i, _e3873, (_e3873 > 0i)))];
let _e3880 = (_e3865 + 4i);
let _e3882 = select(_e3871, _e3880, (_e3880 < _e3871));
let _e3888 = global_3.member[bitcast<u32>(select(0i, _e3882, (_e3882 > 0i)))];
let _e3889 = (_e3865 + 1024i);
let _e3891 = select(_e3871, _e3889, (_e3889 < _e3871));
let _e3897 = global_3.member[bitcast<u32>(select(0i, _e3891, (_e3891 > 0i)))];
let _e3898 = (_e3865 + 1028i);
let _e3900 = select(_e3871, _e3898, (_e3898 < _e3871));
let _e3906 = global_3.member[bitcast<u32>(select(0i, _e3900, (_e3900 > 0i)))];
let _e3911 = (bitcast<f32>(((_e3879 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3919 = (_e3911 + (((bitcast<f32>(((_e3888 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3911) * _e3869));
let _e3924 = (bitcast<f32>(((_e3897 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3935 = (_e3919 + (((_e3924 + (((bitcast<f32>(((_e3906 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3924) * _e3869)) - _e3919) * _e3867));
let _e3948 = (bitcast<f32>((((_e3879 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3956 = (_e3948 + (((bitcast<f32>((((_e3888 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3948) * _e3869));
let _e3961 = (bitcast<f32>((((_e3897 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3973 = (_e3865 + 1i);
let _e3975 = select(_e3871, _e3973, (_e3973 < _e3871));
let _e3981 = global_3.member[bitcast<u32>(select(0i, _e3975, (_e3975 > 0i)))];
let _e3982 = (_e3865 + 5i);
let _e3984 = select(_e3871, _e3982, (_e3982 < _e3871));
let _e3990 = global_3.member[bitcast<u32>(select(0i, _e3984, (_e3984 > 0i)))];
let _e3991 = (_e3865 + 1025i);
let _e3993 = select(_e3871, _e3991, (_e3991 < _e3871));
let _e3999 = global_3.member[bitcast<u32>(select(0i, _e3993, (_e3993 > 0i)))];
let _e4000 = (_e3865 + 1029i);
let _e4002 = select(_e3871, _e4000, (_e4000 < _e3871));
let _e4008 = global_3.member[bitcast<u32>(select(0i, _e4002, (_e4002 > 0i)))];
let _e4013 = (bitcast<f32>(((_e3981 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4021 = (_e4013 + (((bitcast<f32>(((_e3990 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4013) * _e3869));
let _e4026 = (bitcast<f32>(((_e3999 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4050 = (bitcast<f32>((((_e3981 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4058 = (_e4050 + (((bitcast<f32>((((_e3990 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4050) * _e3869));
let _e4063 = (bitcast<f32>((((_e3999 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4075 = (_e3865 + 2i);
let _e4077 = select(_e3871, _e4075, (_e4075 < _e3871));
let _e4083 = global_3.member[bitcast<u32>(select(0i, _e4077, (_e4077 > 0i)))];
let _e4084 = (_e3865 + 6i);
let _e4086 = select(_e3871, _e4084, (_e4084 < _e3871));
let _e4092 = global_3.member[bitcast<u32>(select(0i, _e4086, (_e4086 > 0i)))];
let _e4093 = (_e3865 + 1026i);
let _e4095 = select(_e3871, _e4093, (_e4093 < _e3871));
let _e4101 = global_3.member[bitcast<u32>(select(0i, _e4095, (_e4095 > 0i)))];
let _e4102 = (_e3865 + 1030i);
let _e4104 = select(_e3871, _e4102, (_e4102 < _e3871));
let _e4110 = global_3.member[bitcast<u32>(select(0i, _e4104, (_e4104 > 0i)))];
let _e4115 = (bitcast<f32>(((_e4083 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4123 = (_e4115 + (((bitcast<f32>(((_e4092 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4115) * _e3869));
let _e4128 = (bitcast<f32>(((_e4101 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4152 = (bitcast<f32>((((_e4083 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4160 = (_e4152 + (((bitcast<f32>((((_e4092 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4152) * _e3869));
let _e4165 = (bitcast<f32>((((_e4101 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4177 = (_e3865 + 3i);
let _e4179 = select(_e3871, _e4177, (_e4177 < _e3871));
let _e4185 = global_3.member[bitcast<u32>(select(0i, _e4179, (_e4179 > 0i)))];
let _e4186 = (_e3865 + 7i);
let _e4188 = select(_e3871, _e4186, (_e4186 < _e3871));
let _e4194 = global_3.member[bitcast<u32>(select(0i, _e4188, (_e4188 > 0i)))];
let _e4195 = (_e3865 + 1027i);
let _e4197 = select(_e3871, _e4195, (_e4195 < _e3871));
let _e4203 = global_3.member[bitcast<u32>(select(0i, _e4197, (_e4197 > 0i)))];
let _e4204 = (_e3865 + 1031i);
let _e4206 = select(_e3871, _e4204, (_e4204 < _e3871));
let _e4212 = global_3.member[bitcast<u32>(select(0i, _e4206, (_e4206 > 0i)))];
let _e4217 = (bitcast<f32>(((_e4185 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4225 = (_e4217 + (((bitcast<f32>(((_e4194 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4217) * _e3869));
let _e4230 = (bitcast<f32>(((_e4203 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4245 = (_e3521 * _e3416.member_1);
let _e4247 = -(((_e3956 + (((_e3961 + (((bitcast<f32>((((_e3906 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3961) * _e3869)) - _e3956) * _e3867)) * _e4245));
let _e4249 = select(-87f, _e4247, (_e4247 > -87f));
let _e4251 = select(88f, _e4249, (_e4249 < 88f));
let _e4253 = ((_e4251 * 1.442695f) + 0.5f);
let _e4255 = select(-127f, _e4253, (_e4253 > -127f));
let _e4257 = select(128f, _e4255, (_e4255 < 128f));
let _e4264 = select(0i, select(select(i32(_e4257), i32(-2147483648), (_e4257 < -2147483600f)), 2147483647i, (_e4257 > 2147483500f)), (_e4257 == _e4257));
let _e4268 = (_e4264 - select(0i, 1i, (_e4257 < f32(_e4264))));
let _e4269 = f32(_e4268);
let _e4273 = ((_e4251 - (_e4269 * 0.6933594f)) - (_e4269 * -2.1219444e-4f));
let _e4295 = -(((_e4021 + (((_e4026 + (((bitcast<f32>(((_e4008 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4026) * _e3869)) - _e4021) * _e3867)) * _e4245));
let _e4297 = select(-87f, _e4295, (_e4295 > -87f));
let _e4299 = select(88f, _e4297, (_e4297 < 88f));
let _e4301 = ((_e4299 * 1.442695f) + 0.5f);
let _e4303 = select(-127f, _e4301, (_e4301 > -127f));
let _e4305 = select(128f, _e4303, (_e4303 < 128f));
let _e4312 = select(0i, select(select(i32(_e4305), i32(-2147483648), (_e4305 < -2147483600f)), 2147483647i, (_e4305 > 2147483500f)), (_e4305 == _e4305));
let _e4316 = (_e4312 - select(0i, 1i, (_e4305 < f32(_e4312))));
let _e4317 = f32(_e4316);
let _e4321 = ((_e4299 - (_e4317 * 0.6933594f)) - (_e4317 * -2.1219444e-4f));
let _e4343 = -(((_e4058 + (((_e4063 + (((bitcast<f32>((((_e4008 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4063) * _e3869)) - _e4058) * _e3867)) * _e4245));
let _e4345 = select(-87f, _e4343, (_e4343 > -87f));
let _e4347 = select(88f, _e4345, (_e4345 < 88f));
let _e4349 = ((_e4347 * 1.442695f) + 0.5f);
let _e4351 = select(-127f, _e4349, (_e4349 > -127f));
let _e4353 = select(128f, _e4351, (_e4351 < 128f));
let _e4360 = select(0i, select(select(i32(_e4353), i32(-2147483648), (_e4353 < -2147483600f)), 2147483647i, (_e4353 > 2147483500f)), (_e4353 == _e4353));
let _e4364 = (_e4360 - select(0i, 1i, (_e4353 < f32(_e4360))));
let _e4365 = f32(_e4364);
let _e4369 = ((_e4347 - (_e4365 * 0.6933594f)) - (_e4365 * -2.1219444e-4f));
let _e4392 = -((_e3935 * (_e3521 * _e3416.member)));
let _e4394 = select(-87f, _e4392, (_e4392 > -87f));
let _e4396 = select(88f, _e4394, (_e4394 < 88f));
let _e4398 = ((_e4396 * 1.442695f) + 0.5f);
let _e4400 = select(-127f, _e4398, (_e4398 > -127f));
let _e4402 = select(128f, _e4400, (_e4400 < 128f));
let _e4409 = select(0i, select(select(i32(_e4402), i32(-2147483648), (_e4402 < -2147483600f)), 2147483647i, (_e4402 > 2147483500f)), (_e4402 == _e4402));
let _e4413 = (_e4409 - select(0i, 1i, (_e4402 < f32(_e4409))));
let _e4414 = f32(_e4413);
let _e4418 = ((_e4396 - (_e4414 * 0.6933594f)) - (_e4414 * -2.1219444e-4f));
let _e4438 = ((1f + (_e4418 * (1f + (_e4418 * (0.5f + (_e4418 * (0.16666667f + (_e4418 * (0.041666668f + (_e4418 * (0.008333334f + (_e4418 * (0.001388889f + (_e4418 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4413 + 127i)) << bitcast<u32>(23i))));
let _e4439 = (1f - _e4438);
let _e4442 = (_e4439 / select(1e-12f, _e3935, (_e3935 > 1e-12f)));
phi_7079_ = type_31(_e4438, _e4439, vec3<f32>(((1f + (_e4273 * (1f + (_e4273 * (0.5f + (_e4273 * (0.16666667f + (_e4273 * (0.041666668f + (_e4273 * (0.008333334f + (_e4273 * (0.001388889f + (_e4273 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4268 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e4321 * (1f + (_e4321 * (0.5f + (_e4321 * (0.16666667f + (_e4321 * (0.041666668f + (_e4321 * (0.008333334f + (_e4321 * (0.001388889f + (_e4321 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4316 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e4369 * (1f + (_e4369 * (0.5f + (_e4369 * (0.16666667f + (_e4369 * (0.041666668f + (_e4369 * (0.008333334f + (_e4369 * (0.001388889f + (_e4369 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4364 + 127i)) << bitcast<u32>(23i))))), vec3<f32>(((_e4123 + (((_e4128 + (((bitcast<f32>(((_e4110 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4128) * _e3869)) - _e4123) * _e3867)) * _e4442), ((_e4160 + (((_e4165 + (((bitcast<f32>((((_e4110 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4165) * _e3869)) - _e4160) * _e3867)) * _e4442), ((_e4225 + (((_e4230 + (((bitcast<f32>(((_e4212 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4230) * _e3869)) - _e4225) * _e3867)) * _e4442)));
}
let _e4449 = phi_7079_;
let _e4450 = select(0f, _e3203, _e444);
let _e4454 = (_e380 + (_e3503 * _e4450));
let _e4455 = (_e382 + (_e3504 * _e4450));
let _e4456 = (_e376 + (_e3505 * _e4450));
if (_e729.member_2 == 3u) {
let _e4462 = global_5.member[_e352].member_9.member_1;
let _e4471 = global_5.member[_e352].member_9.member;
phi_8062_ = type_25(vec3<f32>(_e4462.member, _e4462.member_1, _e4462.member_2), vec3<f32>(_e4471.member, _e4471.member_1, _e4471.member_2));
} else {
let _e4481 = global_5.member[_e352].member_8.member_8;
let _e4482 = (_e4456 - _e4481);
let _e4487 = global_5.member[_e352].member_8.member_2;
let _e4492 = global_5.member[_e352].member_8.member_6;
let _e4500 = global_5.member[_e352].member_8.member_5;
let _e4502 = (((_e4454 - (_e4487 + (_e4492 * _e4482))) * _e4500) - 0.5f);
let _e4507 = global_5.member[_e352].member_8.member_3;
let _e4512 = global_5.member[_e352].member_8.member_7;
let _e4517 = (((_e4455 - (_e4507 + (_e4512 * _e4482))) * _e4500) - 0.5f);
let _e4522 = global_5.member[_e352].member_8.member;
let _e4523 = bitcast<i32>(_e4522);
let _e4525 = (f32(_e4523) - 1f);
let _e4530 = global_5.member[_e352].member_8.member_1;
let _e4533 = (f32(bitcast<i32>(_e4530)) - 1f);
let _e4535 = select(0f, _e4502, (_e4502 > 0f));
let _e4537 = select(_e4525, _e4535, (_e4535 < _e4525));
let _e4544 = select(0i, select(select(i32(_e4537), i32(-2147483648), (_e4537 < -2147483600f)), 2147483647i, (_e4537 > 2147483500f)), (_e4537 == _e4537));
let _e4548 = (_e4544 - select(0i, 1i, (_e4537 < f32(_e4544))));
let _e4550 = select(0f, _e4517, (_e4517 > 0f));
let _e4552 = select(_e4533, _e4550, (_e4550 < _e4533));
let _e4559 = select(0i, select(select(i32(_e4552), i32(-2147483648), (_e4552 < -2147483600f)), 2147483647i, (_e4552 > 2147483500f)), (_e4552 == _e4552));
let _e4563 = (_e4559 - select(0i, 1i, (_e4552 < f32(_e4559))));
let _e4567 = (_e4502 - f32(_e4548));
let _e4569 = (_e4517 - f32(_e4563));
let _e4576 = ((((_e4502 >= 0f) && (_e4502 <= _e4525)) && (_e4517 >= 0f)) && (_e4517 <= _e4533));
let _e4580 = global_5.member[_e352].member_4;
let _e4581 = bitcast<i32>(_e4580);
let _e4583 = bitcast<i32>((_e4522 * _e4530));
let _e4585 = (_e4581 + (3i * _e4583));
local_1 = (_e4585 + ((_e4563 * _e4523) + _e4548));
let _e4587 = local_1;
let _e4589 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e4591 = select(_e4589, _e4587, (_e4587 < _e4589));
let _e4596 = global_6.member[bitcast<u32>(select(0i, _e4591, (_e4591 > 0i)))];
let _e4597 = bitcast<u32>(_e4596);
let _e4601 = f32((bitcast<i32>((_e4597 & 65535u)) - 32768i));
let _e4607 = f32((bitcast<i32>(((_e4597 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4612 = select(_e4607, -(_e4607), ((_e4597 >> bitcast<u32>(31i)) != 0u));
let _e4613 = local_1;
let _e4614 = (_e4613 + 1i);
let _e4616 = select(_e4589, _e4614, (_e4614 < _e4589));
let _e4621 = global_6.member[bitcast<u32>(select(0i, _e4616, (_e4616 > 0i)))];
let _e4622 = bitcast<u32>(_e4621);
let _e4632 = f32((bitcast<i32>(((_e4622 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4638 = local_1;
let _e4639 = (_e4638 + _e4523);
let _e4641 = select(_e4589, _e4639, (_e4639 < _e4589));
let _e4646 = global_6.member[bitcast<u32>(select(0i, _e4641, (_e4641 > 0i)))];
let _e4647 = bitcast<u32>(_e4646);
let _e4651 = f32((bitcast<i32>((_e4647 & 65535u)) - 32768i));
let _e4657 = f32((bitcast<i32>(((_e4647 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4662 = select(_e4657, -(_e4657), ((_e4647 >> bitcast<u32>(31i)) != 0u));
let _e4663 = (_e4523 + 1i);
let _e4664 = local_1;
let _e4665 = (_e4664 + _e4663);
let _e4667 = select(_e4589, _e4665, (_e4665 < _e4589));
let _e4672 = global_6.member[bitcast<u32>(select(0i, _e4667, (_e4667 > 0i)))];
let _e4673 = bitcast<u32>(_e4672);
let _e4683 = f32((bitcast<i32>(((_e4673 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4691 = (_e4601 + ((f32((bitcast<i32>((_e4622 & 65535u)) - 32768i)) - _e4601) * _e4567));
let _e4700 = (_e4612 + ((select(_e4632, -(_e4632), ((_e4622 >> bitcast<u32>(31i)) != 0u)) - _e4612) * _e4567));
let _e4713 = global_5.member[_e352].member_9.member;
let _e4716 = (1f / 16255f);
let _e4718 = (_e4713.member + (select(0f, (_e4691 + (((_e4651 + ((f32((bitcast<i32>((_e4673 & 65535u)) - 32768i)) - _e4651) * _e4567)) - _e4691) * _e4569)), _e4576) * _e4716));
let _e4720 = (_e4713.member_1 + (select(0f, (_e4700 + (((_e4662 + ((select(_e4683, -(_e4683), ((_e4673 >> bitcast<u32>(31i)) != 0u)) - _e4662) * _e4567)) - _e4700) * _e4569)), _e4576) * _e4716));
let _e4724 = (1f - ((_e4718 * _e4718) + (_e4720 * _e4720)));
let _e4726 = select(1e-4f, _e4724, (_e4724 > 1e-4f));
let _e4729 = sqrt(select(0f, _e4726, (_e4726 > 0f)));
let _e4733 = (1f / select(1e-6f, _e4729, (_e4729 > 1e-6f)));
let _e4734 = ((_e4456 - _e376) * _e4500);
let _e4741 = (_e4502 - (((_e4718 * _e4733) - _e4492) * _e4734));
let _e4742 = (_e4517 - (((_e4720 * _e4733) - _e4512) * _e4734));
let _e4744 = select(0f, _e4741, (_e4741 > 0f));
let _e4746 = select(_e4525, _e4744, (_e4744 < _e4525));
let _e4753 = select(0i, select(select(i32(_e4746), i32(-2147483648), (_e4746 < -2147483600f)), 2147483647i, (_e4746 > 2147483500f)), (_e4746 == _e4746));
let _e4757 = (_e4753 - select(0i, 1i, (_e4746 < f32(_e4753))));
let _e4759 = select(0f, _e4742, (_e4742 > 0f));
let _e4761 = select(_e4533, _e4759, (_e4759 < _e4533));
let _e4768 = select(0i, select(select(i32(_e4761), i32(-2147483648), (_e4761 < -2147483600f)), 2147483647i, (_e4761 > 2147483500f)), (_e4761 == _e4761));
let _e4772 = (_e4768 - select(0i, 1i, (_e4761 < f32(_e4768))));
let _e4774 = ((_e4772 * _e4523) + _e4757);
let _e4776 = (_e4741 - f32(_e4757));
let _e4778 = (_e4742 - f32(_e4772));
let _e4785 = ((((_e4741 >= 0f) && (_e4741 <= _e4525)) && (_e4742 >= 0f)) && (_e4742 <= _e4533));
let _e4786 = (_e4581 + _e4774);
let _e4788 = select(_e4589, _e4786, (_e4786 < _e4589));
let _e4794 = global_6.member[bitcast<u32>(select(0i, _e4788, (_e4788 > 0i)))];
let _e4795 = (_e4786 + 1i);
let _e4797 = select(_e4589, _e4795, (_e4795 < _e4589));
let _e4803 = global_6.member[bitcast<u32>(select(0i, _e4797, (_e4797 > 0i)))];
let _e4806 = (_e4794 + ((_e4803 - _e4794) * _e4776));
let _e4807 = (_e4786 + _e4523);
let _e4809 = select(_e4589, _e4807, (_e4807 < _e4589));
let _e4815 = global_6.member[bitcast<u32>(select(0i, _e4809, (_e4809 > 0i)))];
let _e4816 = (_e4807 + 1i);
let _e4818 = select(_e4589, _e4816, (_e4816 < _e4589));
let _e4824 = global_6.member[bitcast<u32>(select(0i, _e4818, (_e4818 > 0i)))];
let _e4831 = select(1f, (_e4806 + (((_e4815 + ((_e4824 - _e4815) * _e4776)) - _e4806) * _e4778)), _e4785);
if _e3522 {
phi_7832_ = vec3(_e4831);
} else {
let _e4834 = ((_e4581 + _e4583) + _e4774);
let _e4836 = select(_e4589, _e4834, (_e4834 < _e4589));
let _e4842 = global_6.member[bitcast<u32>(select(0i, _e4836, (_e4836 > 0i)))];
let _e4843 = (_e4834 + 1i);
let _e4845 = select(_e4589, _e4843, (_e4843 < _e4589));
let _e4851 = global_6.member[bitcast<u32>(select(0i, _e4845, (_e4845 > 0i)))];
let _e4854 = (_e4842 + ((_e4851 - _e4842) * _e4776));
let _e4855 = (_e4834 + _e4523);
let _e4857 = select(_e4589, _e4855, (_e4855 < _e4589));
let _e4863 = global_6.member[bitcast<u32>(select(0i, _e4857, (_e4857 > 0i)))];
let _e4864 = (_e4855 + 1i);
let _e4866 = select(_e4589, _e4864, (_e4864 < _e4589));
let _e4872 = global_6.member[bitcast<u32>(select(0i, _e4866, (_e4866 > 0i)))];
let _e4882 = ((_e4581 + (2i * _e4583)) + _e4774);
let _e4884 = select(_e4589, _e4882, (_e4882 < _e4589));
let _e4890 = global_6.member[bitcast<u32>(select(0i, _e4884, (_e4884 > 0i)))];
let _e4891 = (_e4882 + 1i);
let _e4893 = select(_e4589, _e4891, (_e4891 < _e4589));
let _e4899 = global_6.member[bitcast<u32>(select(0i, _e4893, (_e4893 > 0i)))];
let _e4902 = (_e4890 + ((_e4899 - _e4890) * _e4776));
let _e4903 = (_e4882 + _e4523);
let _e4905 = select(_e4589, _e4903, (_e4903 < _e4589));
let _e4911 = global_6.member[bitcast<u32>(select(0i, _e4905, (_e4905 > 0i)))];
let _e4912 = (_e4903 + 1i);
let _e4914 = select(_e4589, _e4912, (_e4912 < _e4589));
let _e4920 = global_6.member[bitcast<u32>(select(0i, _e4914, (_e4914 > 0i)))];
phi_7832_ = vec3<f32>(_e4831, select(1f, (_e4854 + (((_e4863 + ((_e4872 - _e4863) * _e4776)) - _e4854) * _e4778)), _e4785), select(1f, (_e4902 + (((_e4911 + ((_e4920 - _e4911) * _e4776)) - _e4902) * _e4778)), _e4785));
}
let _e4930 = phi_7832_;
local = (_e4585 + _e4774);
let _e4932 = local;
let _e4934 = select(_e4589, _e4932, (_e4932 < _e4589));
let _e4939 = global_6.member[bitcast<u32>(select(0i, _e4934, (_e4934 > 0i)))];
let _e4940 = bitcast<u32>(_e4939);
let _e4944 = f32((bitcast<i32>((_e4940 & 65535u)) - 32768i));
let _e4950 = f32((bitcast<i32>(((_e4940 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4955 = select(_e4950, -(_e4950), ((_e4940 >> bitcast<u32>(31i)) != 0u));
let _e4956 = local;
let _e4957 = (_e4956 + 1i);
let _e4959 = select(_e4589, _e4957, (_e4957 < _e4589));
let _e4964 = global_6.member[bitcast<u32>(select(0i, _e4959, (_e4959 > 0i)))];
let _e4965 = bitcast<u32>(_e4964);
let _e4975 = f32((bitcast<i32>(((_e4965 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4981 = local;
let _e4982 = (_e4981 + _e4523);
let _e4984 = select(_e4589, _e4982, (_e4982 < _e4589));
let _e4989 = global_6.member[bitcast<u32>(select(0i, _e4984, (_e4984 > 0i)))];
let _e4990 = bitcast<u32>(_e4989);
let _e4994 = f32((bitcast<i32>((_e4990 & 65535u)) - 32768i));
let _e5000 = f32((bitcast<i32>(((_e4990 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e5005 = select(_e5000, -(_e5000), ((_e4990 >> bitcast<u32>(31i)) != 0u));
let _e5006 = local;
let _e5007 = (_e5006 + _e4663);
let _e5009 = select(_e4589, _e5007, (_e5007 < _e4589));
let _e5014 = global_6.member[bitcast<u32>(select(0i, _e5009, (_e5009 > 0i)))];
let _e5015 = bitcast<u32>(_e5014);
let _e5025 = f32((bitcast<i32>(((_e5015 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e5033 = (_e4944 + ((f32((bitcast<i32>((_e4965 & 65535u)) - 32768i)) - _e4944) * _e4776));
let _e5042 = (_e4955 + ((select(_e4975, -(_e4975), ((_e4965 >> bitcast<u32>(31i)) != 0u)) - _e4955) * _e4776));
let _e5055 = global_5.member[_e352].member_9.member_1;
let _e5062 = (_e4713.member + (select(0f, (_e5033 + (((_e4994 + ((f32((bitcast<i32>((_e5015 & 65535u)) - 32768i)) - _e4994) * _e4776)) - _e5033) * _e4778)), _e4785) * _e4716));
let _e5064 = (_e4713.member_1 + (select(0f, (_e5042 + (((_e5005 + ((select(_e5025, -(_e5025), ((_e5015 >> bitcast<u32>(31i)) != 0u)) - _e5005) * _e4776)) - _e5042) * _e4778)), _e4785) * _e4716));
let _e5068 = (1f - ((_e5062 * _e5062) + (_e5064 * _e5064)));
let _e5070 = select(1e-4f, _e5068, (_e5068 > 1e-4f));
phi_8062_ = type_25((_e4930 * vec3<f32>(_e5055.member, _e5055.member_1, _e5055.member_2)), vec3<f32>(_e5062, _e5064, sqrt(select(0f, _e5070, (_e5070 > 0f)))));
}
let _e5077 = phi_8062_;
let _e5086 = (((_e5077.member_1.x * _e5077.member_1.x) + (_e5077.member_1.y * _e5077.member_1.y)) + (_e5077.member_1.z * _e5077.member_1.z));
let _e5089 = sqrt(select(0f, _e5086, (_e5086 > 0f)));
let _e5095 = (1e-6f * _e5089);
let _e5099 = select((_e5089 / select(_e5095, _e5077.member_1.z, (_e5077.member_1.z > _e5095))), 1f, ((_e687 & 8u) != 0u));
let _e5101 = (_e5077.member.x * _e5099);
let _e5103 = (_e5077.member.y * _e5099);
let _e5105 = (_e5077.member.z * _e5099);
if _e803 {
let _e5110 = global_5.member[_e352].member_19;
let _e5119 = (((_e2756.member_1.x * _e2756.member_1.x) + (_e2756.member_1.y * _e2756.member_1.y)) + (_e2756.member_1.z * _e2756.member_1.z));
let _e5122 = sqrt(select(0f, _e5119, (_e5119 > 0f)));
let _e5125 = (1f / select(1e-20f, _e5122, (_e5122 > 1e-20f)));
let _e5126 = (_e2756.member_1.x * _e5125);
let _e5127 = (_e2756.member_1.y * _e5125);
let _e5128 = (_e2756.member_1.z * _e5125);
let _e5131 = (-1f / select(1e-20f, _e5089, (_e5089 > 1e-20f)));
let _e5132 = (_e5077.member_1.x * _e5131);
let _e5133 = (_e5077.member_1.y * _e5131);
let _e5134 = (_e5077.member_1.z * _e5131);
let _e5139 = (((_e356[3] * _e356[3]) + (_e356[4] * _e356[4])) + (_e356[5] * _e356[5]));
let _e5142 = sqrt(select(0f, _e5139, (_e5139 > 0f)));
let _e5145 = (-1f / select(1e-20f, _e5142, (_e5142 > 1e-20f)));
let _e5146 = (_e356[3] * _e5145);
let _e5147 = (_e356[4] * _e5145);
let _e5148 = (_e356[5] * _e5145);
let _e5155 = select(1f, -1f, ((((_e5126 * _e5146) + (_e5127 * _e5147)) + (_e5128 * _e5148)) < 0f));
let _e5156 = (_e5126 * _e5155);
let _e5157 = (_e5127 * _e5155);
let _e5158 = (_e5128 * _e5155);
let _e5163 = (((_e5156 * _e5146) + (_e5157 * _e5147)) + (_e5158 * _e5148));
let _e5165 = select(1e-4f, _e5163, (_e5163 > 1e-4f));
let _e5170 = (((_e5156 * _e5132) + (_e5157 * _e5133)) + (_e5158 * _e5134));
let _e5171 = (_e5132 + _e5146);
let _e5172 = (_e5133 + _e5147);
let _e5173 = (_e5134 + _e5148);
let _e5178 = (((_e5171 * _e5171) + (_e5172 * _e5172)) + (_e5173 * _e5173));
let _e5181 = sqrt(select(0f, _e5178, (_e5178 > 0f)));
let _e5184 = (1f / select(1e-6f, _e5181, (_e5181 > 1e-6f)));
let _e5185 = (_e5171 * _e5184);
let _e5186 = (_e5172 * _e5184);
let _e5187 = (_e5173 * _e5184);
let _e5192 = (((_e5156 * _e5185) + (_e5157 * _e5186)) + (_e5158 * _e5187));
let _e5194 = select(0f, _e5192, (_e5192 > 0f));
let _e5199 = (((_e5146 * _e5185) + (_e5147 * _e5186)) + (_e5148 * _e5187));
let _e5201 = select(0f, _e5199, (_e5199 > 0f));
let _e5202 = (_e5110 * _e5110);
let _e5203 = (_e5202 * _e5202);
let _e5207 = (((_e5194 * _e5194) * (_e5203 - 1f)) + 1f);
let _e5211 = (_e5170 > 0f);
let _e5212 = select(0f, _e5170, _e5211);
let _e5214 = (1f - _e5203);
let _e5216 = (((_e5212 * _e5212) * _e5214) + _e5203);
let _e5223 = (((_e5165 * _e5165) * _e5214) + _e5203);
let _e5228 = ((_e5165 * sqrt(select(0f, _e5216, (_e5216 > 0f)))) + (_e5212 * sqrt(select(0f, _e5223, (_e5223 > 0f)))));
let _e5233 = (_e2756.member_2 / _e3200);
let _e5237 = (((_e5233 * _e5233) - 1f) + (_e5201 * _e5201));
let _e5240 = sqrt(select(0f, _e5237, (_e5237 > 0f)));
let _e5241 = (_e5240 - _e5201);
let _e5242 = (_e5240 + _e5201);
let _e5245 = (_e5241 / select(1e-6f, _e5242, (_e5242 > 1e-6f)));
let _e5249 = ((_e5201 * _e5241) + 1f);
let _e5252 = (((_e5201 * _e5242) - 1f) / select(1e-6f, _e5249, (_e5249 > 1e-6f)));
let _e5270 = global_5.member[_e352].member_20;
let _e5274 = ((select(0f, ((((_e5203 / ((3.1415927f * _e5207) * _e5207)) * (0.5f / select(1e-6f, _e5228, (_e5228 > 1e-6f)))) * select(select((((0.5f * _e5245) * _e5245) * (1f + (_e5252 * _e5252))), 1f, (_e5237 <= 0f)), 0f, (_e3200 == _e2756.member_2))) * _e5212), (_e5211 && (_e5122 > 1e-12f))) * _e5270) * select(_e3416.member_2, 0f, _e444));
phi_8380_ = vec3<f32>((_e5101 * _e5274), (_e5103 * _e5274), (_e5105 * _e5274));
} else {
phi_8380_ = vec3<f32>(0f, 0f, 0f);
}
let _e5280 = phi_8380_;
let _e5284 = global_5.member[_e352].member_18;
let _e5291 = (1f - _e356[12]);
let _e5311 = (_e356[9] + ((_e356[13] * ((_e4449.member_3.x * (_e5101 + _e5284.member)) + _e5280.x)) * _e5291));
let _e5312 = (_e356[10] + ((_e356[14] * ((_e4449.member_3.y * (_e5103 + _e5284.member_1)) + _e5280.y)) * _e5291));
let _e5313 = (_e356[11] + ((_e356[15] * ((_e4449.member_3.z * (_e5105 + _e5284.member_2)) + _e5280.z)) * _e5291));
let _e5316 = (_e356[12] + (_e5291 * _e4449.member_1));
let _e5319 = (_e356[13] * _e4449.member_2.x);
let _e5321 = (_e356[14] * _e4449.member_2.y);
let _e5323 = (_e356[15] * _e4449.member_2.z);
let _e5328 = (_e356[8] + ((_e5316 - _e356[12]) * (_e376 + (_e3505 * 0.5f))));
let _e5337 = (-((((select(_e773.member, _e760.member, _e753) * _e5077.member_1.x) + (select(_e773.member_1, _e760.member_1, _e753) * _e5077.member_1.y)) + (select(_e773.member_2, _e760.member_2, _e753) * _e5077.member_1.z))) / select(1e-20f, _e5089, (_e5089 > 1e-20f)));
let _e5342 = bitcast<f32>((bitcast<u32>(select(0f, _e5337, (_e5337 > 0f))) & 2147483647u));
let _e5352 = (1f - _e5316);
let _e5365 = select(_e5316, 1f, _e444);
if _e803 {
let _e5374 = global_5.member[_e352].member_5.member_4;
let _e5377 = (_e2756.member_3.x * _e3416.member_2);
let _e5379 = (_e2756.member_3.y * _e3416.member_2);
let _e5381 = (_e2756.member_3.z * _e3416.member_2);
let _e5382 = (0.5f * _e371);
let _e5386 = (_e356[3] + (_e5377 * _e5382));
let _e5387 = (_e356[4] + (_e5379 * _e5382));
let _e5388 = (_e356[5] + (_e5381 * _e5382));
let _e5390 = (2f * _e370);
let _e5392 = ((_e5388 * _e5388) + (_e5390 * _e5381));
let _e5396 = (_e5388 + sqrt(select(0f, _e5392, (_e5392 > 0f))));
let _e5400 = (0.5f * (_e5390 / select(1e-6f, _e5396, (_e5396 > 1e-6f))));
let _e5404 = (_e5386 + (_e5377 * _e5400));
let _e5405 = (_e5387 + (_e5379 * _e5400));
let _e5406 = (_e5388 + (_e5381 * _e5400));
let _e5410 = (_e5374 * _e5374);
let _e5412 = (_e5406 * _e5406);
let _e5420 = (((_e5388 <= 0f) || (_e5392 <= 0f)) || ((_e5406 <= 0f) || (_e5412 <= (_e5410 * (((_e5404 * _e5404) + (_e5405 * _e5405)) + _e5412)))));
let _e5434 = (_e356[3] + ((_e2756.member_4.x * _e3416.member_2) * _e370));
let _e5435 = (_e356[4] + ((_e2756.member_4.y * _e3416.member_2) * _e370));
let _e5436 = (_e356[5] + ((_e2756.member_4.z * _e3416.member_2) * _e370));
let _e5438 = (_e5436 * _e5436);
let _e5447 = ((_e687 & 1u) != 0u);
phi_8685_ = vec3<f32>(select(select(_e5404, _e5386, _e5420), _e5434, _e5447), select(select(_e5405, _e5387, _e5420), _e5435, _e5447), select(select(_e5406, _e5388, _e5420), _e5436, _e5447));
phi_8686_ = select(_e5420, ((_e5436 <= 0f) || (_e5438 <= (_e5410 * (((_e5434 * _e5434) + (_e5435 * _e5435)) + _e5438)))), _e5447);
} else {
phi_8685_ = vec3<f32>(_e356[3], _e356[4], _e356[5]);
phi_8686_ = false;
}
let _e5454 = phi_8685_;
let _e5456 = phi_8686_;
let _e5465 = (((_e444 || (_e5454.x != _e356[3])) || (_e5454.y != _e356[4])) || (_e5454.z != _e356[5]));
let _e5467 = select(_e5321, _e5319, (_e5319 > _e5321));
phi_8751_ = array<f32, 18>(select(_e356[0], select(_e384, _e4454, _e444), _e5465), select(_e356[1], select(_e386, _e4455, _e444), _e5465), select(_e356[2], select(_e391, _e4456, _e444), _e5465), _e5454.x, _e5454.y, _e5454.z, _e2756.member, select(select(0f, 2f, _e5456), 1f, (_e444 || (((1f - _e5365) * select(_e5323, _e5467, (_e5467 > _e5323))) < 9.765625e-4f))), select(_e5328, (_e5328 + (_e5352 * _e4456)), _e444), select(_e5311, (_e5311 + ((_e5319 * (select(_e779.member, _e766.member, _e753) * ((_e5101 * _e5342) + _e5284.member))) * _e5352)), _e444), select(_e5312, (_e5312 + ((_e5321 * (select(_e779.member_1, _e766.member_1, _e753) * ((_e5103 * _e5342) + _e5284.member_1))) * _e5352)), _e444), select(_e5313, (_e5313 + ((_e5323 * (select(_e779.member_2, _e766.member_2, _e753) * ((_e5105 * _e5342) + _e5284.member_2))) * _e5352)), _e444), _e5365, _e5319, _e5321, _e5323, _e2756.member_2, _e391);
} else {
phi_8751_ = _e356;
}
let _e5486 = phi_8751_;
phi_585_ = (_e352 + 1u);
phi_588_ = select(_e354, true, _e725);
phi_590_ = _e5486;
} else {
phi_585_ = u32();
phi_588_ = bool();
phi_590_ = array<f32, 18>();
}
let _e5490 = phi_585_;
let _e5492 = phi_588_;
let _e5494 = phi_590_;
continue;
continuing {
phi_584_ = _e5490;
phi_587_ = _e5492;
phi_589_ = _e5494;
phi_8834_ = false;
break if !(_e357);
}
}
let _e5497 = phi_8834_;
if _e5497 {
break;
}
let _e5499 = local_8;
if _e5499 {
let _e5501 = local_9;
global_4.member[_e152] = _e5501[0];
let _e5506 = local_10;
global_4.member[_e164] = _e5506[1];
let _e5511 = local_11;
global_4.member[_e175] = _e5511[2];
let _e5516 = local_12;
global_4.member[_e186] = _e5516[3];
let _e5521 = local_13;
global_4.member[_e197] = _e5521[4];
let _e5526 = local_14;
global_4.member[_e208] = _e5526[5];
let _e5531 = local_15;
global_4.member[_e219] = _e5531[6];
let _e5536 = local_16;
global_4.member[_e230] = _e5536[7];
let _e5541 = local_17;
global_4.member[_e241] = _e5541[8];
let _e5546 = local_18;
global_4.member[_e252] = _e5546[9];
let _e5551 = local_19;
global_4.member[_e263] = _e5551[10];
let _e5556 = local_20;
global_4.member[_e274] = _e5556[11];
let _e5561 = local_21;
global_4.member[_e285] = _e5561[12];
let _e5566 = local_22;
global_4.member[_e296] = _e5566[13];
let _e5571 = local_23;
global_4.member[_e307] = _e5571[14];
let _e5576 = local_24;
global_4.member[_e318] = _e5576[15];
let _e5581 = local_25;
global_4.member[_e329] = _e5581[16];
let _e5586 = local_26;
global_4.member[_e340] = _e5586[17];
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
