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
var phi_580_: u32;
var phi_583_: bool;
var phi_585_: array<f32, 18>;
var phi_3409_: type_29;
var phi_4018_: type_30;
var phi_4567_: f32;
var phi_4956_: type_5;
var phi_6514_: type_31;
var phi_7267_: vec3<f32>;
var phi_7497_: type_25;
var phi_7815_: vec3<f32>;
var phi_8124_: f32;
var phi_8125_: f32;
var phi_8126_: f32;
var phi_8127_: bool;
var phi_8187_: array<f32, 18>;
var phi_581_: u32;
var phi_584_: bool;
var phi_586_: array<f32, 18>;
var phi_8270_: bool;
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
phi_580_ = 0u;
phi_583_ = false;
phi_585_ = array<f32, 18>(_e163, _e173, _e184, _e195, _e206, _e217, _e228, _e239, _e250, _e261, _e272, _e283, _e294, _e305, _e316, _e327, _e338, _e349);
loop {
let _e352 = phi_580_;
let _e354 = phi_583_;
let _e356 = phi_585_;
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
phi_8270_ = true;
break;
}
let _e365 = global_5.member[_e352].member_5.member_2;
let _e366 = (_e365 / _e356[4]);
let _e371 = global_5.member[_e352].member_5.member;
let _e374 = ((_e371 - _e356[16]) / _e356[4]);
let _e377 = (_e356[0] + (_e356[2] * _e374));
let _e380 = (_e356[1] + (_e356[3] * _e374));
let _e382 = (_e377 + (_e356[2] * _e366));
let _e384 = (_e380 + (_e356[3] * _e366));
let _e389 = global_5.member[_e352].member_5.member_1;
let _e395 = global_5.member[_e352].member_13.member.member;
let _e406 = ((((_e395.member.member * _e377) + (_e395.member.member_1 * _e380)) + (_e395.member.member_2 * _e371)) + _e395.member_1);
let _e412 = ((((_e395.member.member * _e382) + (_e395.member.member_1 * _e384)) + (_e395.member.member_2 * _e389)) + _e395.member_1);
let _e415 = ((_e406 > 0f) && (_e412 <= 0f));
let _e421 = global_5.member[_e352].member_13.member_1.member;
let _e432 = ((((_e421.member.member * _e377) + (_e421.member.member_1 * _e380)) + (_e421.member.member_2 * _e371)) + _e421.member_1);
let _e438 = ((((_e421.member.member * _e382) + (_e421.member.member_1 * _e384)) + (_e421.member.member_2 * _e389)) + _e421.member_1);
let _e441 = ((_e432 > 0f) && (_e438 <= 0f));
let _e442 = (_e415 || _e441);
let _e447 = global_5.member[_e352].member_6.member;
let _e458 = ((((_e447.member.member * _e377) + (_e447.member.member_1 * _e380)) + (_e447.member.member_2 * _e371)) + _e447.member_1);
let _e463 = global_5.member[_e352].member_6.member_1;
let _e474 = ((((_e463.member.member * _e377) + (_e463.member.member_1 * _e380)) + (_e463.member.member_2 * _e371)) + _e463.member_1);
let _e479 = global_5.member[_e352].member_6.member_2;
let _e490 = ((((_e479.member.member * _e377) + (_e479.member.member_1 * _e380)) + (_e479.member.member_2 * _e371)) + _e479.member_1);
let _e496 = ((((_e447.member.member * _e382) + (_e447.member.member_1 * _e384)) + (_e447.member.member_2 * _e389)) + _e447.member_1);
let _e502 = ((((_e463.member.member * _e382) + (_e463.member.member_1 * _e384)) + (_e463.member.member_2 * _e389)) + _e463.member_1);
let _e508 = ((((_e479.member.member * _e382) + (_e479.member.member_1 * _e384)) + (_e479.member.member_2 * _e389)) + _e479.member_1);
let _e513 = global_5.member[_e352].member_6.member_4;
let _e519 = global_5.member[_e352].member_6.member_3.member;
let _e520 = (_e519 - 0.5f);
let _e522 = select(-0.5f, _e496, (_e496 > -0.5f));
let _e524 = select(_e520, _e522, (_e522 < _e520));
let _e530 = global_5.member[_e352].member_6.member_3.member_1;
let _e531 = (_e530 - 0.5f);
let _e533 = select(-0.5f, _e502, (_e502 > -0.5f));
let _e535 = select(_e531, _e533, (_e533 < _e531));
let _e541 = global_5.member[_e352].member_6.member_3.member_2;
let _e542 = (_e541 - 0.5f);
let _e544 = select(-0.5f, _e508, (_e508 > -0.5f));
let _e546 = select(_e542, _e544, (_e544 < _e542));
let _e547 = (_e496 - _e458);
let _e548 = (_e502 - _e474);
let _e549 = (_e508 - _e490);
let _e552 = bitcast<f32>((bitcast<u32>(_e547) & 2147483647u));
let _e555 = bitcast<f32>((bitcast<u32>(_e548) & 2147483647u));
let _e557 = select(_e555, _e552, (_e552 > _e555));
let _e560 = bitcast<f32>((bitcast<u32>(_e549) & 2147483647u));
let _e569 = bitcast<f32>((bitcast<u32>((_e496 - _e524)) & 2147483647u));
let _e572 = bitcast<f32>((bitcast<u32>((_e502 - _e535)) & 2147483647u));
let _e574 = select(_e572, _e569, (_e569 > _e572));
let _e577 = bitcast<f32>((bitcast<u32>((_e508 - _e546)) & 2147483647u));
let _e581 = (_e524 + 0.5f);
let _e582 = (_e519 - 1f);
let _e584 = select(0f, _e581, (_e581 > 0f));
let _e586 = select(_e582, _e584, (_e584 < _e582));
let _e593 = select(0i, select(select(i32(_e586), i32(-2147483648), (_e586 < -2147483600f)), 2147483647i, (_e586 > 2147483500f)), (_e586 == _e586));
let _e602 = global_5.member[_e352].member_6.member_12;
let _e603 = (_e602 & 31u);
let _e606 = (_e535 + 0.5f);
let _e607 = (_e530 - 1f);
let _e609 = select(0f, _e606, (_e606 > 0f));
let _e611 = select(_e607, _e609, (_e609 < _e607));
let _e618 = select(0i, select(select(i32(_e611), i32(-2147483648), (_e611 < -2147483600f)), 2147483647i, (_e611 > 2147483500f)), (_e611 == _e611));
let _e625 = (_e546 + 0.5f);
let _e626 = (_e541 - 1f);
let _e628 = select(0f, _e625, (_e625 > 0f));
let _e630 = select(_e626, _e628, (_e628 < _e626));
let _e637 = select(0i, select(select(i32(_e630), i32(-2147483648), (_e630 < -2147483600f)), 2147483647i, (_e630 > 2147483500f)), (_e630 == _e630));
let _e649 = global_5.member[_e352].member_6.member_9.member;
let _e656 = global_5.member[_e352].member_6.member_9.member_1;
let _e662 = global_5.member[_e352].member_6.member_10;
let _e668 = ((bitcast<i32>(_e662) + ((_e593 - select(0i, 1i, (_e586 < f32(_e593)))) >> bitcast<u32>(_e603))) + (bitcast<i32>(_e649) * (((_e618 - select(0i, 1i, (_e611 < f32(_e618)))) >> bitcast<u32>(_e603)) + (bitcast<i32>(_e656) * ((_e637 - select(0i, 1i, (_e630 < f32(_e637)))) >> bitcast<u32>(_e603))))));
let _e670 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e672 = select(_e670, _e668, (_e668 < _e670));
let _e678 = global_2.member[bitcast<u32>(select(0i, _e672, (_e672 > 0i)))];
let _e685 = global_5.member[_e352].member_1;
let _e718 = (_e356[17] != _e371);
let _e725 = (select(0u, select(select(select(select(7u, 3u, (((((((_e458 >= 0f) && (_e458 <= _e582)) && (_e474 >= 0f)) && (_e474 <= _e607)) && (_e490 >= 0f)) && (_e490 <= _e626)) && ((((((_e496 >= 0f) && (_e496 <= _e582)) && (_e502 >= 0f)) && (_e502 <= _e607)) && (_e508 >= 0f)) && (_e508 <= _e626)))), 15u, _e718), 1u, (((_e685 & 64u) != 0u) || ((((select(_e560, _e557, (_e557 > _e560)) <= _e513) && ((select(_e577, _e574, (_e574 > _e577)) > _e513) || (_e678 != 0u))) && true) && ((_e685 & 32u) != 0u)))), 31u, _e442), (_e356[6] == 0f)) > 1u);
if _e725 {
let _e729 = global_5.member[_e352].member;
let _e731 = (_e406 - _e412);
let _e734 = (_e406 / select(1e-20f, _e731, (_e731 > 1e-20f)));
let _e735 = (_e432 - _e438);
let _e738 = (_e432 / select(1e-20f, _e735, (_e735 > 1e-20f)));
let _e742 = (_e441 && (!(_e415) || (_e738 < _e734)));
let _e749 = global_5.member[_e352].member_13.member_1.member.member;
let _e755 = global_5.member[_e352].member_13.member_1.member_1;
let _e762 = global_5.member[_e352].member_13.member.member.member;
let _e768 = global_5.member[_e352].member_13.member.member_1;
let _e787 = select(_e734, _e738, _e742);
let _e789 = (_e729.member_2 == 2u);
let _e792 = (((_e729.member_2 == 1u) || _e789) || (_e729.member_2 == 5u));
if _e792 {
let _e794 = select(-1f, _e524, (_e524 > -1f));
let _e796 = select(_e519, _e794, (_e794 < _e519));
let _e803 = select(0i, select(select(i32(_e796), i32(-2147483648), (_e796 < -2147483600f)), 2147483647i, (_e796 > 2147483500f)), (_e796 == _e796));
let _e807 = (_e803 - select(0i, 1i, (_e796 < f32(_e803))));
let _e809 = select(-1f, _e535, (_e535 > -1f));
let _e811 = select(_e530, _e809, (_e809 < _e530));
let _e818 = select(0i, select(select(i32(_e811), i32(-2147483648), (_e811 < -2147483600f)), 2147483647i, (_e811 > 2147483500f)), (_e811 == _e811));
let _e822 = (_e818 - select(0i, 1i, (_e811 < f32(_e818))));
let _e824 = select(-1f, _e546, (_e546 > -1f));
let _e826 = select(_e541, _e824, (_e824 < _e541));
let _e833 = select(0i, select(select(i32(_e826), i32(-2147483648), (_e826 < -2147483600f)), 2147483647i, (_e826 > 2147483500f)), (_e826 == _e826));
let _e837 = (_e833 - select(0i, 1i, (_e826 < f32(_e833))));
let _e842 = global_5.member[_e352].member_6.member_7;
let _e847 = global_5.member[_e352].member_6.member_8;
let _e848 = (_e807 + 1i);
let _e849 = (_e822 + 1i);
let _e850 = (_e837 + 1i);
let _e856 = global_5.member[_e352].member_6.member_11.member;
let _e863 = global_5.member[_e352].member_6.member_11.member_1;
let _e874 = ((_e848 >> bitcast<u32>(4i)) + (bitcast<i32>(_e856) * ((_e849 >> bitcast<u32>(4i)) + (bitcast<i32>(_e863) * (_e850 >> bitcast<u32>(4i))))));
let _e876 = (bitcast<i32>(_e119) - 1i);
let _e878 = select(_e876, _e874, (_e874 < _e876));
let _e884 = global_1.member[bitcast<u32>(select(0i, _e878, (_e878 > 0i)))];
let _e886 = (_e848 & 15i);
let _e889 = ((_e849 & 15i) * _e842);
let _e891 = (bitcast<i32>(_e884) + ((_e850 & 15i) * _e847));
let _e895 = (_e889 + _e842);
let _e897 = (_e889 + (2i * _e842));
let _e899 = (_e889 + (3i * _e842));
let _e900 = (_e891 + _e847);
let _e902 = (_e891 + (2i * _e847));
let _e904 = (_e891 + (3i * _e847));
local_6 = type_28(array<i32, 4>(_e886, (_e886 + 1i), (_e886 + 2i), (_e886 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_7 = vec3<f32>((_e524 - f32(_e807)), (_e535 - f32(_e822)), (_e546 - f32(_e837)));
let _e915 = (_e900 + _e895);
let _e918 = local_6.member[0u];
let _e919 = (_e915 + _e918);
let _e921 = select(_e876, _e919, (_e919 < _e876));
let _e926 = global_1.member[bitcast<u32>(select(0i, _e921, (_e921 > 0i)))];
let _e927 = bitcast<f32>(_e926);
let _e930 = local_6.member[1u];
let _e931 = (_e915 + _e930);
let _e933 = select(_e876, _e931, (_e931 < _e876));
let _e938 = global_1.member[bitcast<u32>(select(0i, _e933, (_e933 > 0i)))];
let _e939 = bitcast<f32>(_e938);
let _e942 = local_6.member[2u];
let _e943 = (_e915 + _e942);
let _e945 = select(_e876, _e943, (_e943 < _e876));
let _e950 = global_1.member[bitcast<u32>(select(0i, _e945, (_e945 > 0i)))];
let _e951 = bitcast<f32>(_e950);
let _e954 = local_6.member[3u];
let _e955 = (_e915 + _e954);
let _e957 = select(_e876, _e955, (_e955 < _e876));
let _e962 = global_1.member[bitcast<u32>(select(0i, _e957, (_e957 > 0i)))];
let _e964 = local_7[0u];
let _e967 = (_e927 + ((_e939 - _e927) * _e964));
let _e968 = local_7[0u];
let _e971 = (_e939 + ((_e951 - _e939) * _e968));
let _e972 = local_7[0u];
let _e975 = (_e951 + ((bitcast<f32>(_e962) - _e951) * _e972));
let _e976 = (_e900 + _e897);
let _e977 = local_6.member[0u];
let _e978 = (_e976 + _e977);
let _e980 = select(_e876, _e978, (_e978 < _e876));
let _e985 = global_1.member[bitcast<u32>(select(0i, _e980, (_e980 > 0i)))];
let _e986 = bitcast<f32>(_e985);
let _e987 = local_6.member[1u];
let _e988 = (_e976 + _e987);
let _e990 = select(_e876, _e988, (_e988 < _e876));
let _e995 = global_1.member[bitcast<u32>(select(0i, _e990, (_e990 > 0i)))];
let _e996 = bitcast<f32>(_e995);
let _e997 = local_6.member[2u];
let _e998 = (_e976 + _e997);
let _e1000 = select(_e876, _e998, (_e998 < _e876));
let _e1005 = global_1.member[bitcast<u32>(select(0i, _e1000, (_e1000 > 0i)))];
let _e1006 = bitcast<f32>(_e1005);
let _e1007 = local_6.member[3u];
let _e1008 = (_e976 + _e1007);
let _e1010 = select(_e876, _e1008, (_e1008 < _e876));
let _e1015 = global_1.member[bitcast<u32>(select(0i, _e1010, (_e1010 > 0i)))];
let _e1017 = local_7[0u];
let _e1021 = local_7[0u];
let _e1024 = (_e996 + ((_e1006 - _e996) * _e1021));
let _e1025 = local_7[0u];
let _e1029 = (_e902 + _e895);
let _e1030 = local_6.member[0u];
let _e1031 = (_e1029 + _e1030);
let _e1033 = select(_e876, _e1031, (_e1031 < _e876));
let _e1038 = global_1.member[bitcast<u32>(select(0i, _e1033, (_e1033 > 0i)))];
let _e1039 = bitcast<f32>(_e1038);
let _e1040 = local_6.member[1u];
let _e1041 = (_e1029 + _e1040);
let _e1043 = select(_e876, _e1041, (_e1041 < _e876));
let _e1048 = global_1.member[bitcast<u32>(select(0i, _e1043, (_e1043 > 0i)))];
let _e1049 = bitcast<f32>(_e1048);
let _e1050 = local_6.member[2u];
let _e1051 = (_e1029 + _e1050);
let _e1053 = select(_e876, _e1051, (_e1051 < _e876));
let _e1058 = global_1.member[bitcast<u32>(select(0i, _e1053, (_e1053 > 0i)))];
let _e1059 = bitcast<f32>(_e1058);
let _e1060 = local_6.member[3u];
let _e1061 = (_e1029 + _e1060);
let _e1063 = select(_e876, _e1061, (_e1061 < _e876));
let _e1068 = global_1.member[bitcast<u32>(select(0i, _e1063, (_e1063 > 0i)))];
let _e1070 = local_7[0u];
let _e1073 = (_e1039 + ((_e1049 - _e1039) * _e1070));
let _e1074 = local_7[0u];
let _e1077 = (_e1049 + ((_e1059 - _e1049) * _e1074));
let _e1078 = local_7[0u];
let _e1081 = (_e1059 + ((bitcast<f32>(_e1068) - _e1059) * _e1078));
let _e1082 = (_e902 + _e897);
let _e1083 = local_6.member[0u];
let _e1084 = (_e1082 + _e1083);
let _e1086 = select(_e876, _e1084, (_e1084 < _e876));
let _e1091 = global_1.member[bitcast<u32>(select(0i, _e1086, (_e1086 > 0i)))];
let _e1092 = bitcast<f32>(_e1091);
let _e1093 = local_6.member[1u];
let _e1094 = (_e1082 + _e1093);
let _e1096 = select(_e876, _e1094, (_e1094 < _e876));
let _e1101 = global_1.member[bitcast<u32>(select(0i, _e1096, (_e1096 > 0i)))];
let _e1102 = bitcast<f32>(_e1101);
let _e1103 = local_6.member[2u];
let _e1104 = (_e1082 + _e1103);
let _e1106 = select(_e876, _e1104, (_e1104 < _e876));
let _e1111 = global_1.member[bitcast<u32>(select(0i, _e1106, (_e1106 > 0i)))];
let _e1112 = bitcast<f32>(_e1111);
let _e1113 = local_6.member[3u];
let _e1114 = (_e1082 + _e1113);
let _e1116 = select(_e876, _e1114, (_e1114 < _e876));
let _e1121 = global_1.member[bitcast<u32>(select(0i, _e1116, (_e1116 > 0i)))];
let _e1123 = local_7[0u];
let _e1127 = local_7[0u];
let _e1130 = (_e1102 + ((_e1112 - _e1102) * _e1127));
let _e1131 = local_7[0u];
let _e1135 = (_e900 + _e889);
let _e1136 = local_6.member[1u];
let _e1137 = (_e1135 + _e1136);
let _e1139 = select(_e876, _e1137, (_e1137 < _e876));
let _e1144 = global_1.member[bitcast<u32>(select(0i, _e1139, (_e1139 > 0i)))];
let _e1145 = bitcast<f32>(_e1144);
let _e1146 = local_6.member[2u];
let _e1147 = (_e1135 + _e1146);
let _e1149 = select(_e876, _e1147, (_e1147 < _e876));
let _e1154 = global_1.member[bitcast<u32>(select(0i, _e1149, (_e1149 > 0i)))];
let _e1156 = local_7[0u];
let _e1159 = (_e1145 + ((bitcast<f32>(_e1154) - _e1145) * _e1156));
let _e1160 = (_e900 + _e899);
let _e1161 = local_6.member[1u];
let _e1162 = (_e1160 + _e1161);
let _e1164 = select(_e876, _e1162, (_e1162 < _e876));
let _e1169 = global_1.member[bitcast<u32>(select(0i, _e1164, (_e1164 > 0i)))];
let _e1170 = bitcast<f32>(_e1169);
let _e1171 = local_6.member[2u];
let _e1172 = (_e1160 + _e1171);
let _e1174 = select(_e876, _e1172, (_e1172 < _e876));
let _e1179 = global_1.member[bitcast<u32>(select(0i, _e1174, (_e1174 > 0i)))];
let _e1181 = local_7[0u];
let _e1185 = (_e902 + _e889);
let _e1186 = local_6.member[1u];
let _e1187 = (_e1185 + _e1186);
let _e1189 = select(_e876, _e1187, (_e1187 < _e876));
let _e1194 = global_1.member[bitcast<u32>(select(0i, _e1189, (_e1189 > 0i)))];
let _e1195 = bitcast<f32>(_e1194);
let _e1196 = local_6.member[2u];
let _e1197 = (_e1185 + _e1196);
let _e1199 = select(_e876, _e1197, (_e1197 < _e876));
let _e1204 = global_1.member[bitcast<u32>(select(0i, _e1199, (_e1199 > 0i)))];
let _e1206 = local_7[0u];
let _e1209 = (_e1195 + ((bitcast<f32>(_e1204) - _e1195) * _e1206));
let _e1210 = (_e902 + _e899);
let _e1211 = local_6.member[1u];
let _e1212 = (_e1210 + _e1211);
let _e1214 = select(_e876, _e1212, (_e1212 < _e876));
let _e1219 = global_1.member[bitcast<u32>(select(0i, _e1214, (_e1214 > 0i)))];
let _e1220 = bitcast<f32>(_e1219);
let _e1221 = local_6.member[2u];
let _e1222 = (_e1210 + _e1221);
let _e1224 = select(_e876, _e1222, (_e1222 < _e876));
let _e1229 = global_1.member[bitcast<u32>(select(0i, _e1224, (_e1224 > 0i)))];
let _e1231 = local_7[0u];
let _e1235 = (_e891 + _e895);
let _e1236 = local_6.member[1u];
let _e1237 = (_e1235 + _e1236);
let _e1239 = select(_e876, _e1237, (_e1237 < _e876));
let _e1244 = global_1.member[bitcast<u32>(select(0i, _e1239, (_e1239 > 0i)))];
let _e1245 = bitcast<f32>(_e1244);
let _e1246 = local_6.member[2u];
let _e1247 = (_e1235 + _e1246);
let _e1249 = select(_e876, _e1247, (_e1247 < _e876));
let _e1254 = global_1.member[bitcast<u32>(select(0i, _e1249, (_e1249 > 0i)))];
let _e1256 = local_7[0u];
let _e1259 = (_e1245 + ((bitcast<f32>(_e1254) - _e1245) * _e1256));
let _e1260 = (_e904 + _e895);
let _e1261 = local_6.member[1u];
let _e1262 = (_e1260 + _e1261);
let _e1264 = select(_e876, _e1262, (_e1262 < _e876));
let _e1269 = global_1.member[bitcast<u32>(select(0i, _e1264, (_e1264 > 0i)))];
let _e1270 = bitcast<f32>(_e1269);
let _e1271 = local_6.member[2u];
let _e1272 = (_e1260 + _e1271);
let _e1274 = select(_e876, _e1272, (_e1272 < _e876));
let _e1279 = global_1.member[bitcast<u32>(select(0i, _e1274, (_e1274 > 0i)))];
let _e1281 = local_7[0u];
let _e1284 = (_e1270 + ((bitcast<f32>(_e1279) - _e1270) * _e1281));
let _e1285 = (_e891 + _e897);
let _e1286 = local_6.member[1u];
let _e1287 = (_e1285 + _e1286);
let _e1289 = select(_e876, _e1287, (_e1287 < _e876));
let _e1294 = global_1.member[bitcast<u32>(select(0i, _e1289, (_e1289 > 0i)))];
let _e1295 = bitcast<f32>(_e1294);
let _e1296 = local_6.member[2u];
let _e1297 = (_e1285 + _e1296);
let _e1299 = select(_e876, _e1297, (_e1297 < _e876));
let _e1304 = global_1.member[bitcast<u32>(select(0i, _e1299, (_e1299 > 0i)))];
let _e1306 = local_7[0u];
let _e1310 = (_e904 + _e897);
let _e1311 = local_6.member[1u];
let _e1312 = (_e1310 + _e1311);
let _e1314 = select(_e876, _e1312, (_e1312 < _e876));
let _e1319 = global_1.member[bitcast<u32>(select(0i, _e1314, (_e1314 > 0i)))];
let _e1320 = bitcast<f32>(_e1319);
let _e1321 = local_6.member[2u];
let _e1322 = (_e1310 + _e1321);
let _e1324 = select(_e876, _e1322, (_e1322 < _e876));
let _e1329 = global_1.member[bitcast<u32>(select(0i, _e1324, (_e1324 > 0i)))];
let _e1331 = local_7[0u];
let _e1336 = local_7[1u];
let _e1339 = (_e971 + ((_e1024 - _e971) * _e1336));
let _e1340 = local_7[1u];
let _e1343 = (_e1077 + ((_e1130 - _e1077) * _e1340));
let _e1344 = local_7[1u];
let _e1347 = (_e967 + (((_e986 + ((_e996 - _e986) * _e1017)) - _e967) * _e1344));
let _e1348 = local_7[1u];
let _e1353 = local_7[2u];
let _e1357 = local_7[1u];
let _e1360 = (_e975 + (((_e1006 + ((bitcast<f32>(_e1015) - _e1006) * _e1025)) - _e975) * _e1357));
let _e1361 = local_7[1u];
let _e1365 = local_7[2u];
let _e1369 = local_7[1u];
let _e1372 = (_e1159 + ((_e971 - _e1159) * _e1369));
let _e1373 = local_7[1u];
let _e1377 = local_7[2u];
let _e1381 = local_7[1u];
let _e1384 = (_e1024 + (((_e1170 + ((bitcast<f32>(_e1179) - _e1170) * _e1181)) - _e1024) * _e1381));
let _e1385 = local_7[1u];
let _e1389 = local_7[2u];
let _e1393 = local_7[1u];
let _e1396 = (_e1259 + (((_e1295 + ((bitcast<f32>(_e1304) - _e1295) * _e1306)) - _e1259) * _e1393));
let _e1397 = local_7[2u];
let _e1401 = local_7[1u];
let _e1405 = local_7[2u];
let _e1409 = local_7[2u];
let _e1417 = global_5.member[_e352].member_6.member_5;
let _e1423 = global_5.member[_e352].member_6.member_6;
let _e1424 = (((_e1339 + ((_e1343 - _e1339) * _e1409)) * _e1417) + _e1423);
let _e1426 = select(0f, _e1424, (_e1424 > 0f));
let _e1428 = select(1f, _e1426, (_e1426 < 1f));
let _e1430 = (((_e1347 + (((_e1073 + (((_e1092 + ((_e1102 - _e1092) * _e1123)) - _e1073) * _e1348)) - _e1347) * _e1353)) * _e1417) + _e1423);
let _e1432 = select(0f, _e1430, (_e1430 > 0f));
let _e1434 = select(1f, _e1432, (_e1432 < 1f));
let _e1436 = (((_e1360 + (((_e1081 + (((_e1112 + ((bitcast<f32>(_e1121) - _e1112) * _e1131)) - _e1081) * _e1361)) - _e1360) * _e1365)) * _e1417) + _e1423);
let _e1438 = select(0f, _e1436, (_e1436 > 0f));
let _e1440 = select(1f, _e1438, (_e1438 < 1f));
let _e1442 = (((_e1372 + (((_e1209 + ((_e1077 - _e1209) * _e1373)) - _e1372) * _e1377)) * _e1417) + _e1423);
let _e1444 = select(0f, _e1442, (_e1442 > 0f));
let _e1446 = select(1f, _e1444, (_e1444 < 1f));
let _e1448 = (((_e1384 + (((_e1130 + (((_e1220 + ((bitcast<f32>(_e1229) - _e1220) * _e1231)) - _e1130) * _e1385)) - _e1384) * _e1389)) * _e1417) + _e1423);
let _e1450 = select(0f, _e1448, (_e1448 > 0f));
let _e1452 = select(1f, _e1450, (_e1450 < 1f));
let _e1454 = (((_e1396 + ((_e1339 - _e1396) * _e1397)) * _e1417) + _e1423);
let _e1456 = select(0f, _e1454, (_e1454 > 0f));
let _e1458 = select(1f, _e1456, (_e1456 < 1f));
let _e1460 = (((_e1343 + (((_e1284 + (((_e1320 + ((bitcast<f32>(_e1329) - _e1320) * _e1331)) - _e1284) * _e1401)) - _e1343) * _e1405)) * _e1417) + _e1423);
let _e1462 = select(0f, _e1460, (_e1460 > 0f));
let _e1464 = select(1f, _e1462, (_e1462 < 1f));
let _e1465 = (_e1428 * 1024f);
let _e1466 = (1024f - 1f);
let _e1468 = select(0f, _e1465, (_e1465 > 0f));
let _e1470 = select(_e1466, _e1468, (_e1468 < _e1466));
let _e1477 = select(0i, select(select(i32(_e1470), i32(-2147483648), (_e1470 < -2147483600f)), 2147483647i, (_e1470 > 2147483500f)), (_e1470 == _e1470));
let _e1481 = (_e1477 - select(0i, 1i, (_e1470 < f32(_e1477))));
let _e1482 = (262147i + _e1481);
let _e1484 = (bitcast<i32>(_e123) - 1i);
let _e1486 = select(_e1484, _e1482, (_e1482 < _e1484));
let _e1492 = global_3.member[bitcast<u32>(select(0i, _e1486, (_e1486 > 0i)))];
let _e1502 = select(_e1484, 262146i, (262146i < _e1484));
let _e1508 = global_3.member[bitcast<u32>(select(0i, _e1502, (_e1502 > 0i)))];
let _e1509 = bitcast<f32>(_e1508);
let _e1510 = (f32((bitcast<i32>((_e1492 & 4095u)) - 2048i)) * _e1509);
let _e1512 = select(_e1484, 262144i, (262144i < _e1484));
let _e1518 = global_3.member[bitcast<u32>(select(0i, _e1512, (_e1512 > 0i)))];
let _e1519 = bitcast<f32>(_e1518);
let _e1521 = select(_e1484, 262145i, (262145i < _e1484));
let _e1527 = global_3.member[bitcast<u32>(select(0i, _e1521, (_e1521 > 0i)))];
let _e1528 = bitcast<f32>(_e1527);
let _e1534 = ((_e1519 + (f32(bitcast<i32>((_e1492 >> bitcast<u32>(12u)))) * _e1528)) + (_e1510 * (_e1465 - f32(_e1481))));
let _e1535 = (_e1510 * 1024f);
if _e789 {
let _e1542 = ((0.5f * (_e1440 - _e1434)) * _e1535);
let _e1543 = ((0.5f * (_e1452 - _e1446)) * _e1535);
let _e1544 = ((0.5f * (_e1464 - _e1458)) * _e1535);
phi_3409_ = type_29(_e1534, vec3<f32>(_e1542, _e1543, _e1544), vec3<f32>((_e1542 * _e1534), (_e1543 * _e1534), (_e1544 * _e1534)));
} else {
let _e1551 = (_e1434 * 1024f);
let _e1553 = select(0f, _e1551, (_e1551 > 0f));
let _e1555 = select(_e1466, _e1553, (_e1553 < _e1466));
let _e1562 = select(0i, select(select(i32(_e1555), i32(-2147483648), (_e1555 < -2147483600f)), 2147483647i, (_e1555 > 2147483500f)), (_e1555 == _e1555));
let _e1566 = (_e1562 - select(0i, 1i, (_e1555 < f32(_e1562))));
let _e1567 = (262147i + _e1566);
let _e1569 = select(_e1484, _e1567, (_e1567 < _e1484));
let _e1575 = global_3.member[bitcast<u32>(select(0i, _e1569, (_e1569 > 0i)))];
let _e1590 = ((_e1519 + (f32(bitcast<i32>((_e1575 >> bitcast<u32>(12u)))) * _e1528)) + ((f32((bitcast<i32>((_e1575 & 4095u)) - 2048i)) * _e1509) * (_e1551 - f32(_e1566))));
let _e1591 = (_e1440 * 1024f);
let _e1593 = select(0f, _e1591, (_e1591 > 0f));
let _e1595 = select(_e1466, _e1593, (_e1593 < _e1466));
let _e1602 = select(0i, select(select(i32(_e1595), i32(-2147483648), (_e1595 < -2147483600f)), 2147483647i, (_e1595 > 2147483500f)), (_e1595 == _e1595));
let _e1606 = (_e1602 - select(0i, 1i, (_e1595 < f32(_e1602))));
let _e1607 = (262147i + _e1606);
let _e1609 = select(_e1484, _e1607, (_e1607 < _e1484));
let _e1615 = global_3.member[bitcast<u32>(select(0i, _e1609, (_e1609 > 0i)))];
let _e1630 = ((_e1519 + (f32(bitcast<i32>((_e1615 >> bitcast<u32>(12u)))) * _e1528)) + ((f32((bitcast<i32>((_e1615 & 4095u)) - 2048i)) * _e1509) * (_e1591 - f32(_e1606))));
let _e1631 = (_e1446 * 1024f);
let _e1633 = select(0f, _e1631, (_e1631 > 0f));
let _e1635 = select(_e1466, _e1633, (_e1633 < _e1466));
let _e1642 = select(0i, select(select(i32(_e1635), i32(-2147483648), (_e1635 < -2147483600f)), 2147483647i, (_e1635 > 2147483500f)), (_e1635 == _e1635));
let _e1646 = (_e1642 - select(0i, 1i, (_e1635 < f32(_e1642))));
let _e1647 = (262147i + _e1646);
let _e1649 = select(_e1484, _e1647, (_e1647 < _e1484));
let _e1655 = global_3.member[bitcast<u32>(select(0i, _e1649, (_e1649 > 0i)))];
let _e1670 = ((_e1519 + (f32(bitcast<i32>((_e1655 >> bitcast<u32>(12u)))) * _e1528)) + ((f32((bitcast<i32>((_e1655 & 4095u)) - 2048i)) * _e1509) * (_e1631 - f32(_e1646))));
let _e1671 = (_e1452 * 1024f);
let _e1673 = select(0f, _e1671, (_e1671 > 0f));
let _e1675 = select(_e1466, _e1673, (_e1673 < _e1466));
let _e1682 = select(0i, select(select(i32(_e1675), i32(-2147483648), (_e1675 < -2147483600f)), 2147483647i, (_e1675 > 2147483500f)), (_e1675 == _e1675));
let _e1686 = (_e1682 - select(0i, 1i, (_e1675 < f32(_e1682))));
let _e1687 = (262147i + _e1686);
let _e1689 = select(_e1484, _e1687, (_e1687 < _e1484));
let _e1695 = global_3.member[bitcast<u32>(select(0i, _e1689, (_e1689 > 0i)))];
let _e1710 = ((_e1519 + (f32(bitcast<i32>((_e1695 >> bitcast<u32>(12u)))) * _e1528)) + ((f32((bitcast<i32>((_e1695 & 4095u)) - 2048i)) * _e1509) * (_e1671 - f32(_e1686))));
let _e1711 = (_e1458 * 1024f);
let _e1713 = select(0f, _e1711, (_e1711 > 0f));
let _e1715 = select(_e1466, _e1713, (_e1713 < _e1466));
let _e1722 = select(0i, select(select(i32(_e1715), i32(-2147483648), (_e1715 < -2147483600f)), 2147483647i, (_e1715 > 2147483500f)), (_e1715 == _e1715));
let _e1726 = (_e1722 - select(0i, 1i, (_e1715 < f32(_e1722))));
let _e1727 = (262147i + _e1726);
let _e1729 = select(_e1484, _e1727, (_e1727 < _e1484));
let _e1735 = global_3.member[bitcast<u32>(select(0i, _e1729, (_e1729 > 0i)))];
let _e1750 = ((_e1519 + (f32(bitcast<i32>((_e1735 >> bitcast<u32>(12u)))) * _e1528)) + ((f32((bitcast<i32>((_e1735 & 4095u)) - 2048i)) * _e1509) * (_e1711 - f32(_e1726))));
let _e1751 = (_e1464 * 1024f);
let _e1753 = select(0f, _e1751, (_e1751 > 0f));
let _e1755 = select(_e1466, _e1753, (_e1753 < _e1466));
let _e1762 = select(0i, select(select(i32(_e1755), i32(-2147483648), (_e1755 < -2147483600f)), 2147483647i, (_e1755 > 2147483500f)), (_e1755 == _e1755));
let _e1766 = (_e1762 - select(0i, 1i, (_e1755 < f32(_e1762))));
let _e1767 = (262147i + _e1766);
let _e1769 = select(_e1484, _e1767, (_e1767 < _e1484));
let _e1775 = global_3.member[bitcast<u32>(select(0i, _e1769, (_e1769 > 0i)))];
let _e1790 = ((_e1519 + (f32(bitcast<i32>((_e1775 >> bitcast<u32>(12u)))) * _e1528)) + ((f32((bitcast<i32>((_e1775 & 4095u)) - 2048i)) * _e1509) * (_e1751 - f32(_e1766))));
let _e1791 = (_e1630 - _e1590);
let _e1793 = (_e1710 - _e1670);
let _e1795 = (_e1790 - _e1750);
phi_3409_ = type_29(_e1534, vec3<f32>((0.5f * _e1791), (0.5f * _e1793), (0.5f * _e1795)), vec3<f32>((0.25f * (_e1791 * (_e1630 + _e1590))), (0.25f * (_e1793 * (_e1710 + _e1670))), (0.25f * (_e1795 * (_e1790 + _e1750)))));
}
let _e1810 = phi_3409_;
let _e1825 = select(0f, 1f, ((((((_e496 >= -0.5f) && (_e496 <= _e520)) && (_e502 >= -0.5f)) && (_e502 <= _e531)) && (_e508 >= -0.5f)) && (_e508 <= _e542)));
let _e1827 = (0.5f * (_e1440 - _e1434));
let _e1829 = (0.5f * (_e1452 - _e1446));
let _e1831 = (0.5f * (_e1464 - _e1458));
let _e1838 = global_5.member[_e352].member_6.member.member.member;
let _e1845 = global_5.member[_e352].member_6.member.member.member_1;
let _e1852 = global_5.member[_e352].member_6.member.member.member_2;
let _e1859 = global_5.member[_e352].member_6.member_1.member.member;
let _e1866 = global_5.member[_e352].member_6.member_1.member.member_1;
let _e1873 = global_5.member[_e352].member_6.member_1.member.member_2;
let _e1880 = global_5.member[_e352].member_6.member_2.member.member;
let _e1887 = global_5.member[_e352].member_6.member_2.member.member_1;
let _e1894 = global_5.member[_e352].member_6.member_2.member.member_2;
phi_4018_ = type_30(_e1428, vec3<f32>(((((_e1838 * _e1827) + (_e1859 * _e1829)) + (_e1880 * _e1831)) * _e1825), ((((_e1845 * _e1827) + (_e1866 * _e1829)) + (_e1887 * _e1831)) * _e1825), ((((_e1852 * _e1827) + (_e1873 * _e1829)) + (_e1894 * _e1831)) * _e1825)), _e1810.member, vec3<f32>(((((_e1838 * _e1810.member_2.x) + (_e1859 * _e1810.member_2.y)) + (_e1880 * _e1810.member_2.z)) * _e1825), ((((_e1845 * _e1810.member_2.x) + (_e1866 * _e1810.member_2.y)) + (_e1887 * _e1810.member_2.z)) * _e1825), ((((_e1852 * _e1810.member_2.x) + (_e1873 * _e1810.member_2.y)) + (_e1894 * _e1810.member_2.z)) * _e1825)), vec3<f32>(((((_e1838 * _e1810.member_1.x) + (_e1859 * _e1810.member_1.y)) + (_e1880 * _e1810.member_1.z)) * _e1825), ((((_e1845 * _e1810.member_1.x) + (_e1866 * _e1810.member_1.y)) + (_e1887 * _e1810.member_1.z)) * _e1825), ((((_e1852 * _e1810.member_1.x) + (_e1873 * _e1810.member_1.y)) + (_e1894 * _e1810.member_1.z)) * _e1825)));
} else {
let _e1960 = select(-1f, _e524, (_e524 > -1f));
let _e1962 = select(_e519, _e1960, (_e1960 < _e519));
let _e1969 = select(0i, select(select(i32(_e1962), i32(-2147483648), (_e1962 < -2147483600f)), 2147483647i, (_e1962 > 2147483500f)), (_e1962 == _e1962));
let _e1973 = (_e1969 - select(0i, 1i, (_e1962 < f32(_e1969))));
let _e1975 = select(-1f, _e535, (_e535 > -1f));
let _e1977 = select(_e530, _e1975, (_e1975 < _e530));
let _e1984 = select(0i, select(select(i32(_e1977), i32(-2147483648), (_e1977 < -2147483600f)), 2147483647i, (_e1977 > 2147483500f)), (_e1977 == _e1977));
let _e1988 = (_e1984 - select(0i, 1i, (_e1977 < f32(_e1984))));
let _e1990 = select(-1f, _e546, (_e546 > -1f));
let _e1992 = select(_e541, _e1990, (_e1990 < _e541));
let _e1999 = select(0i, select(select(i32(_e1992), i32(-2147483648), (_e1992 < -2147483600f)), 2147483647i, (_e1992 > 2147483500f)), (_e1992 == _e1992));
let _e2003 = (_e1999 - select(0i, 1i, (_e1992 < f32(_e1999))));
let _e2008 = global_5.member[_e352].member_6.member_7;
let _e2013 = global_5.member[_e352].member_6.member_8;
let _e2014 = (_e1973 + 1i);
let _e2015 = (_e1988 + 1i);
let _e2016 = (_e2003 + 1i);
let _e2022 = global_5.member[_e352].member_6.member_11.member;
let _e2029 = global_5.member[_e352].member_6.member_11.member_1;
let _e2040 = ((_e2014 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2022) * ((_e2015 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2029) * (_e2016 >> bitcast<u32>(4i))))));
let _e2042 = (bitcast<i32>(_e119) - 1i);
let _e2044 = select(_e2042, _e2040, (_e2040 < _e2042));
let _e2050 = global_1.member[bitcast<u32>(select(0i, _e2044, (_e2044 > 0i)))];
let _e2052 = (_e2014 & 15i);
let _e2055 = ((_e2015 & 15i) * _e2008);
let _e2057 = (bitcast<i32>(_e2050) + ((_e2016 & 15i) * _e2013));
let _e2061 = (_e2055 + _e2008);
let _e2063 = (_e2055 + (2i * _e2008));
let _e2064 = (_e2057 + _e2013);
let _e2066 = (_e2057 + (2i * _e2013));
local_4 = type_28(array<i32, 4>(_e2052, (_e2052 + 1i), (_e2052 + 2i), (_e2052 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_5 = vec3<f32>((_e524 - f32(_e1973)), (_e535 - f32(_e1988)), (_e546 - f32(_e2003)));
let _e2077 = (_e2064 + _e2061);
let _e2080 = local_4.member[1u];
let _e2081 = (_e2077 + _e2080);
let _e2083 = select(_e2042, _e2081, (_e2081 < _e2042));
let _e2088 = global_1.member[bitcast<u32>(select(0i, _e2083, (_e2083 > 0i)))];
let _e2089 = bitcast<f32>(_e2088);
let _e2092 = local_4.member[2u];
let _e2093 = (_e2077 + _e2092);
let _e2095 = select(_e2042, _e2093, (_e2093 < _e2042));
let _e2100 = global_1.member[bitcast<u32>(select(0i, _e2095, (_e2095 > 0i)))];
let _e2102 = local_5[0u];
let _e2105 = (_e2089 + ((bitcast<f32>(_e2100) - _e2089) * _e2102));
let _e2106 = (_e2064 + _e2063);
let _e2107 = local_4.member[1u];
let _e2108 = (_e2106 + _e2107);
let _e2110 = select(_e2042, _e2108, (_e2108 < _e2042));
let _e2115 = global_1.member[bitcast<u32>(select(0i, _e2110, (_e2110 > 0i)))];
let _e2116 = bitcast<f32>(_e2115);
let _e2117 = local_4.member[2u];
let _e2118 = (_e2106 + _e2117);
let _e2120 = select(_e2042, _e2118, (_e2118 < _e2042));
let _e2125 = global_1.member[bitcast<u32>(select(0i, _e2120, (_e2120 > 0i)))];
let _e2127 = local_5[0u];
let _e2132 = local_5[1u];
let _e2135 = (_e2105 + (((_e2116 + ((bitcast<f32>(_e2125) - _e2116) * _e2127)) - _e2105) * _e2132));
let _e2136 = (_e2066 + _e2061);
let _e2137 = local_4.member[1u];
let _e2138 = (_e2136 + _e2137);
let _e2140 = select(_e2042, _e2138, (_e2138 < _e2042));
let _e2145 = global_1.member[bitcast<u32>(select(0i, _e2140, (_e2140 > 0i)))];
let _e2146 = bitcast<f32>(_e2145);
let _e2147 = local_4.member[2u];
let _e2148 = (_e2136 + _e2147);
let _e2150 = select(_e2042, _e2148, (_e2148 < _e2042));
let _e2155 = global_1.member[bitcast<u32>(select(0i, _e2150, (_e2150 > 0i)))];
let _e2157 = local_5[0u];
let _e2160 = (_e2146 + ((bitcast<f32>(_e2155) - _e2146) * _e2157));
let _e2161 = (_e2066 + _e2063);
let _e2162 = local_4.member[1u];
let _e2163 = (_e2161 + _e2162);
let _e2165 = select(_e2042, _e2163, (_e2163 < _e2042));
let _e2170 = global_1.member[bitcast<u32>(select(0i, _e2165, (_e2165 > 0i)))];
let _e2171 = bitcast<f32>(_e2170);
let _e2172 = local_4.member[2u];
let _e2173 = (_e2161 + _e2172);
let _e2175 = select(_e2042, _e2173, (_e2173 < _e2042));
let _e2180 = global_1.member[bitcast<u32>(select(0i, _e2175, (_e2175 > 0i)))];
let _e2182 = local_5[0u];
let _e2186 = local_5[1u];
let _e2191 = local_5[2u];
let _e2199 = global_5.member[_e352].member_6.member_5;
let _e2205 = global_5.member[_e352].member_6.member_6;
let _e2206 = (((_e2135 + (((_e2160 + (((_e2171 + ((bitcast<f32>(_e2180) - _e2171) * _e2182)) - _e2160) * _e2186)) - _e2135) * _e2191)) * _e2199) + _e2205);
let _e2208 = select(0f, _e2206, (_e2206 > 0f));
phi_4018_ = type_30(select(1f, _e2208, (_e2208 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2213 = phi_4018_;
let _e2217 = select(-0.5f, _e458, (_e458 > -0.5f));
let _e2219 = select(_e520, _e2217, (_e2217 < _e520));
let _e2221 = select(-0.5f, _e474, (_e474 > -0.5f));
let _e2223 = select(_e531, _e2221, (_e2221 < _e531));
let _e2225 = select(-0.5f, _e490, (_e490 > -0.5f));
let _e2227 = select(_e542, _e2225, (_e2225 < _e542));
let _e2229 = select(-1f, _e2219, (_e2219 > -1f));
let _e2231 = select(_e519, _e2229, (_e2229 < _e519));
let _e2238 = select(0i, select(select(i32(_e2231), i32(-2147483648), (_e2231 < -2147483600f)), 2147483647i, (_e2231 > 2147483500f)), (_e2231 == _e2231));
let _e2242 = (_e2238 - select(0i, 1i, (_e2231 < f32(_e2238))));
let _e2244 = select(-1f, _e2223, (_e2223 > -1f));
let _e2246 = select(_e530, _e2244, (_e2244 < _e530));
let _e2253 = select(0i, select(select(i32(_e2246), i32(-2147483648), (_e2246 < -2147483600f)), 2147483647i, (_e2246 > 2147483500f)), (_e2246 == _e2246));
let _e2257 = (_e2253 - select(0i, 1i, (_e2246 < f32(_e2253))));
let _e2259 = select(-1f, _e2227, (_e2227 > -1f));
let _e2261 = select(_e541, _e2259, (_e2259 < _e541));
let _e2268 = select(0i, select(select(i32(_e2261), i32(-2147483648), (_e2261 < -2147483600f)), 2147483647i, (_e2261 > 2147483500f)), (_e2261 == _e2261));
let _e2272 = (_e2268 - select(0i, 1i, (_e2261 < f32(_e2268))));
let _e2277 = global_5.member[_e352].member_6.member_7;
let _e2282 = global_5.member[_e352].member_6.member_8;
let _e2283 = (_e2242 + 1i);
let _e2284 = (_e2257 + 1i);
let _e2285 = (_e2272 + 1i);
let _e2291 = global_5.member[_e352].member_6.member_11.member;
let _e2298 = global_5.member[_e352].member_6.member_11.member_1;
let _e2309 = ((_e2283 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2291) * ((_e2284 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2298) * (_e2285 >> bitcast<u32>(4i))))));
let _e2311 = (bitcast<i32>(_e119) - 1i);
let _e2313 = select(_e2311, _e2309, (_e2309 < _e2311));
let _e2319 = global_1.member[bitcast<u32>(select(0i, _e2313, (_e2313 > 0i)))];
let _e2321 = (_e2283 & 15i);
let _e2324 = ((_e2284 & 15i) * _e2277);
let _e2326 = (bitcast<i32>(_e2319) + ((_e2285 & 15i) * _e2282));
let _e2330 = (_e2324 + _e2277);
let _e2332 = (_e2324 + (2i * _e2277));
let _e2333 = (_e2326 + _e2282);
let _e2335 = (_e2326 + (2i * _e2282));
local_2 = type_28(array<i32, 4>(_e2321, (_e2321 + 1i), (_e2321 + 2i), (_e2321 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_3 = vec3<f32>((_e2219 - f32(_e2242)), (_e2223 - f32(_e2257)), (_e2227 - f32(_e2272)));
let _e2346 = (_e2333 + _e2330);
let _e2349 = local_2.member[1u];
let _e2350 = (_e2346 + _e2349);
let _e2352 = select(_e2311, _e2350, (_e2350 < _e2311));
let _e2357 = global_1.member[bitcast<u32>(select(0i, _e2352, (_e2352 > 0i)))];
let _e2358 = bitcast<f32>(_e2357);
let _e2361 = local_2.member[2u];
let _e2362 = (_e2346 + _e2361);
let _e2364 = select(_e2311, _e2362, (_e2362 < _e2311));
let _e2369 = global_1.member[bitcast<u32>(select(0i, _e2364, (_e2364 > 0i)))];
let _e2371 = local_3[0u];
let _e2374 = (_e2358 + ((bitcast<f32>(_e2369) - _e2358) * _e2371));
let _e2375 = (_e2333 + _e2332);
let _e2376 = local_2.member[1u];
let _e2377 = (_e2375 + _e2376);
let _e2379 = select(_e2311, _e2377, (_e2377 < _e2311));
let _e2384 = global_1.member[bitcast<u32>(select(0i, _e2379, (_e2379 > 0i)))];
let _e2385 = bitcast<f32>(_e2384);
let _e2386 = local_2.member[2u];
let _e2387 = (_e2375 + _e2386);
let _e2389 = select(_e2311, _e2387, (_e2387 < _e2311));
let _e2394 = global_1.member[bitcast<u32>(select(0i, _e2389, (_e2389 > 0i)))];
let _e2396 = local_3[0u];
let _e2401 = local_3[1u];
let _e2404 = (_e2374 + (((_e2385 + ((bitcast<f32>(_e2394) - _e2385) * _e2396)) - _e2374) * _e2401));
let _e2405 = (_e2335 + _e2330);
let _e2406 = local_2.member[1u];
let _e2407 = (_e2405 + _e2406);
let _e2409 = select(_e2311, _e2407, (_e2407 < _e2311));
let _e2414 = global_1.member[bitcast<u32>(select(0i, _e2409, (_e2409 > 0i)))];
let _e2415 = bitcast<f32>(_e2414);
let _e2416 = local_2.member[2u];
let _e2417 = (_e2405 + _e2416);
let _e2419 = select(_e2311, _e2417, (_e2417 < _e2311));
let _e2424 = global_1.member[bitcast<u32>(select(0i, _e2419, (_e2419 > 0i)))];
let _e2426 = local_3[0u];
let _e2429 = (_e2415 + ((bitcast<f32>(_e2424) - _e2415) * _e2426));
let _e2430 = (_e2335 + _e2332);
let _e2431 = local_2.member[1u];
let _e2432 = (_e2430 + _e2431);
let _e2434 = select(_e2311, _e2432, (_e2432 < _e2311));
let _e2439 = global_1.member[bitcast<u32>(select(0i, _e2434, (_e2434 > 0i)))];
let _e2440 = bitcast<f32>(_e2439);
let _e2441 = local_2.member[2u];
let _e2442 = (_e2430 + _e2441);
let _e2444 = select(_e2311, _e2442, (_e2442 < _e2311));
let _e2449 = global_1.member[bitcast<u32>(select(0i, _e2444, (_e2444 > 0i)))];
let _e2451 = local_3[0u];
let _e2455 = local_3[1u];
let _e2460 = local_3[2u];
let _e2468 = global_5.member[_e352].member_6.member_5;
let _e2474 = global_5.member[_e352].member_6.member_6;
let _e2475 = (((_e2404 + (((_e2429 + (((_e2440 + ((bitcast<f32>(_e2449) - _e2440) * _e2451)) - _e2429) * _e2455)) - _e2404) * _e2460)) * _e2468) + _e2474);
let _e2477 = select(0f, _e2475, (_e2475 > 0f));
let _e2479 = select(1f, _e2477, (_e2477 < 1f));
let _e2480 = select(_e356[5], _e2479, _e718);
if _e792 {
let _e2481 = (_e2479 * 1024f);
let _e2482 = (1024f - 1f);
let _e2484 = select(0f, _e2481, (_e2481 > 0f));
let _e2486 = select(_e2482, _e2484, (_e2484 < _e2482));
let _e2493 = select(0i, select(select(i32(_e2486), i32(-2147483648), (_e2486 < -2147483600f)), 2147483647i, (_e2486 > 2147483500f)), (_e2486 == _e2486));
let _e2497 = (_e2493 - select(0i, 1i, (_e2486 < f32(_e2493))));
let _e2498 = (262147i + _e2497);
let _e2500 = (bitcast<i32>(_e123) - 1i);
let _e2502 = select(_e2500, _e2498, (_e2498 < _e2500));
let _e2508 = global_3.member[bitcast<u32>(select(0i, _e2502, (_e2502 > 0i)))];
let _e2518 = select(_e2500, 262146i, (262146i < _e2500));
let _e2524 = global_3.member[bitcast<u32>(select(0i, _e2518, (_e2518 > 0i)))];
let _e2528 = select(_e2500, 262144i, (262144i < _e2500));
let _e2534 = global_3.member[bitcast<u32>(select(0i, _e2528, (_e2528 > 0i)))];
let _e2537 = select(_e2500, 262145i, (262145i < _e2500));
let _e2543 = global_3.member[bitcast<u32>(select(0i, _e2537, (_e2537 > 0i)))];
phi_4567_ = select(_e356[15], ((bitcast<f32>(_e2534) + (f32(bitcast<i32>((_e2508 >> bitcast<u32>(12u)))) * bitcast<f32>(_e2543))) + ((f32((bitcast<i32>((_e2508 & 4095u)) - 2048i)) * bitcast<f32>(_e2524)) * (_e2481 - f32(_e2497)))), _e718);
} else {
phi_4567_ = _e356[15];
}
let _e2553 = phi_4567_;
let _e2556 = select(1f, select(1f, _e787, (_e787 < 1f)), _e442);
if ((_e685 & 16u) == 0u) {
phi_4956_ = type_5(1f, 1f, 1f);
} else {
let _e2563 = global_5.member[_e352].member_14.member;
let _e2574 = ((((_e2563.member.member * _e377) + (_e2563.member.member_1 * _e380)) + (_e2563.member.member_2 * _e371)) + _e2563.member_1);
let _e2580 = ((((_e2563.member.member * _e382) + (_e2563.member.member_1 * _e384)) + (_e2563.member.member_2 * _e389)) + _e2563.member_1);
let _e2582 = select(_e2580, _e2574, (_e2574 < _e2580));
let _e2584 = select(_e2580, _e2574, (_e2574 > _e2580));
let _e2586 = (_e2584 - _e2582);
let _e2589 = (-(_e2582) / select(1e-30f, _e2586, (_e2586 > 1e-30f)));
let _e2591 = select(0f, _e2589, (_e2589 > 0f));
let _e2597 = select(select(select(1f, _e2591, (_e2591 < 1f)), 1f, (_e2584 <= 0f)), 0f, (_e2582 > 0f));
let _e2603 = global_5.member[_e352].member_14.member_1;
let _e2604 = (_e2603 != 0u);
let _e2615 = global_5.member[_e352].member_15.member;
let _e2626 = ((((_e2615.member.member * _e377) + (_e2615.member.member_1 * _e380)) + (_e2615.member.member_2 * _e371)) + _e2615.member_1);
let _e2632 = ((((_e2615.member.member * _e382) + (_e2615.member.member_1 * _e384)) + (_e2615.member.member_2 * _e389)) + _e2615.member_1);
let _e2634 = select(_e2632, _e2626, (_e2626 < _e2632));
let _e2636 = select(_e2632, _e2626, (_e2626 > _e2632));
let _e2638 = (_e2636 - _e2634);
let _e2641 = (-(_e2634) / select(1e-30f, _e2638, (_e2638 > 1e-30f)));
let _e2643 = select(0f, _e2641, (_e2641 > 0f));
let _e2649 = select(select(select(1f, _e2643, (_e2643 < 1f)), 1f, (_e2636 <= 0f)), 0f, (_e2634 > 0f));
let _e2655 = global_5.member[_e352].member_15.member_1;
let _e2656 = (_e2655 != 0u);
let _e2667 = global_5.member[_e352].member_16.member;
let _e2678 = ((((_e2667.member.member * _e377) + (_e2667.member.member_1 * _e380)) + (_e2667.member.member_2 * _e371)) + _e2667.member_1);
let _e2684 = ((((_e2667.member.member * _e382) + (_e2667.member.member_1 * _e384)) + (_e2667.member.member_2 * _e389)) + _e2667.member_1);
let _e2686 = select(_e2684, _e2678, (_e2678 < _e2684));
let _e2688 = select(_e2684, _e2678, (_e2678 > _e2684));
let _e2690 = (_e2688 - _e2686);
let _e2693 = (-(_e2686) / select(1e-30f, _e2690, (_e2690 > 1e-30f)));
let _e2695 = select(0f, _e2693, (_e2693 > 0f));
let _e2701 = select(select(select(1f, _e2695, (_e2695 < 1f)), 1f, (_e2688 <= 0f)), 0f, (_e2686 > 0f));
let _e2707 = global_5.member[_e352].member_16.member_1;
let _e2708 = (_e2707 != 0u);
let _e2719 = global_5.member[_e352].member_17.member;
let _e2730 = ((((_e2719.member.member * _e377) + (_e2719.member.member_1 * _e380)) + (_e2719.member.member_2 * _e371)) + _e2719.member_1);
let _e2736 = ((((_e2719.member.member * _e382) + (_e2719.member.member_1 * _e384)) + (_e2719.member.member_2 * _e389)) + _e2719.member_1);
let _e2738 = select(_e2736, _e2730, (_e2730 < _e2736));
let _e2740 = select(_e2736, _e2730, (_e2730 > _e2736));
let _e2742 = (_e2740 - _e2738);
let _e2745 = (-(_e2738) / select(1e-30f, _e2742, (_e2742 > 1e-30f)));
let _e2747 = select(0f, _e2745, (_e2745 > 0f));
let _e2753 = select(select(select(1f, _e2747, (_e2747 < 1f)), 1f, (_e2740 <= 0f)), 0f, (_e2738 > 0f));
let _e2759 = global_5.member[_e352].member_17.member_1;
let _e2760 = (_e2759 != 0u);
phi_4956_ = type_5(((((1f * _e2597) * _e2649) * _e2701) * _e2753), ((((1f * select(1f, _e2597, _e2604)) * select(1f, _e2649, _e2656)) * select(1f, _e2701, _e2708)) * select(1f, _e2753, _e2760)), ((((1f * select(1f, 0f, (_e2604 && (_e2580 > 0f)))) * select(1f, 0f, (_e2656 && (_e2632 > 0f)))) * select(1f, 0f, (_e2708 && (_e2684 > 0f)))) * select(1f, 0f, (_e2760 && (_e2736 > 0f)))));
}
let _e2769 = phi_4956_;
let _e2770 = (_e552 < 1e-12f);
let _e2772 = (1f / select(_e547, 1f, _e2770));
let _e2774 = ((-0.5f - _e458) * _e2772);
let _e2776 = ((_e520 - _e458) * _e2772);
let _e2782 = select(_e2776, _e2774, (_e2774 < _e2776));
let _e2784 = select(0f, _e2782, (_e2782 > 0f));
let _e2787 = select(select(1f, _e2784, (_e2784 < 1f)), select(2f, 0f, ((_e458 >= -0.5f) && (_e458 <= _e520))), _e2770);
let _e2789 = select(_e2776, _e2774, (_e2774 > _e2776));
let _e2791 = select(0f, _e2789, (_e2789 > 0f));
let _e2794 = select(select(1f, _e2791, (_e2791 < 1f)), 1f, _e2770);
let _e2795 = (_e555 < 1e-12f);
let _e2797 = (1f / select(_e548, 1f, _e2795));
let _e2799 = ((-0.5f - _e474) * _e2797);
let _e2801 = ((_e531 - _e474) * _e2797);
let _e2807 = select(_e2801, _e2799, (_e2799 < _e2801));
let _e2809 = select(0f, _e2807, (_e2807 > 0f));
let _e2812 = select(select(1f, _e2809, (_e2809 < 1f)), select(2f, 0f, ((_e474 >= -0.5f) && (_e474 <= _e531))), _e2795);
let _e2814 = select(_e2801, _e2799, (_e2799 > _e2801));
let _e2816 = select(0f, _e2814, (_e2814 > 0f));
let _e2819 = select(select(1f, _e2816, (_e2816 < 1f)), 1f, _e2795);
let _e2820 = (_e560 < 1e-12f);
let _e2822 = (1f / select(_e549, 1f, _e2820));
let _e2824 = ((-0.5f - _e490) * _e2822);
let _e2826 = ((_e542 - _e490) * _e2822);
let _e2832 = select(_e2826, _e2824, (_e2824 < _e2826));
let _e2834 = select(0f, _e2832, (_e2832 > 0f));
let _e2837 = select(select(1f, _e2834, (_e2834 < 1f)), select(2f, 0f, ((_e490 >= -0.5f) && (_e490 <= _e542))), _e2820);
let _e2839 = select(_e2826, _e2824, (_e2824 > _e2826));
let _e2841 = select(0f, _e2839, (_e2839 > 0f));
let _e2844 = select(select(1f, _e2841, (_e2841 < 1f)), 1f, _e2820);
let _e2846 = select(_e2819, _e2794, (_e2794 < _e2819));
let _e2850 = select(_e2812, _e2787, (_e2787 > _e2812));
let _e2853 = (select(_e2844, _e2846, (_e2846 < _e2844)) - select(_e2837, _e2850, (_e2850 > _e2837)));
let _e2856 = (_e382 - _e377);
let _e2857 = (_e384 - _e380);
let _e2858 = (_e389 - _e371);
let _e2863 = (((_e2856 * _e2856) + (_e2857 * _e2857)) + (_e2858 * _e2858));
let _e2873 = global_5.member[_e352].member_5.member_3;
let _e2874 = (((sqrt(select(0f, _e2863, (_e2863 > 0f))) * select(0f, _e2853, (_e2853 > 0f))) * _e2556) * _e2873);
let _e2875 = (_e729.member_2 >= 3u);
if _e2875 {
let _e2877 = (_e2480 * 255f);
let _e2878 = (_e2213.member * 255f);
let _e2879 = (255f - 1f);
let _e2881 = select(0f, _e2877, (_e2877 > 0f));
let _e2883 = select(_e2879, _e2881, (_e2881 < _e2879));
let _e2890 = select(0i, select(select(i32(_e2883), i32(-2147483648), (_e2883 < -2147483600f)), 2147483647i, (_e2883 > 2147483500f)), (_e2883 == _e2883));
let _e2894 = (_e2890 - select(0i, 1i, (_e2883 < f32(_e2890))));
let _e2896 = select(0f, _e2878, (_e2878 > 0f));
let _e2898 = select(_e2879, _e2896, (_e2896 < _e2879));
let _e2905 = select(0i, select(select(i32(_e2898), i32(-2147483648), (_e2898 < -2147483600f)), 2147483647i, (_e2898 > 2147483500f)), (_e2898 == _e2898));
let _e2909 = (_e2905 - select(0i, 1i, (_e2898 < f32(_e2905))));
let _e2912 = (((_e2894 * 256i) + _e2909) * 4i);
let _e2914 = (_e2877 - f32(_e2894));
let _e2916 = (_e2878 - f32(_e2909));
let _e2917 = (_e2912 + 2i);
let _e2919 = (bitcast<i32>(_e123) - 1i);
let _e2921 = select(_e2919, _e2917, (_e2917 < _e2919));
let _e2927 = global_3.member[bitcast<u32>(select(0i, _e2921, (_e2921 > 0i)))];
let _e2928 = (_e2912 + 6i);
let _e2930 = select(_e2919, _e2928, (_e2928 < _e2919));
let _e2936 = global_3.member[bitcast<u32>(select(0i, _e2930, (_e2930 > 0i)))];
let _e2937 = (_e2912 + 1026i);
let _e2939 = select(_e2919, _e2937, (_e2937 < _e2919));
let _e2945 = global_3.member[bitcast<u32>(select(0i, _e2939, (_e2939 > 0i)))];
let _e2946 = (_e2912 + 1030i);
let _e2948 = select(_e2919, _e2946, (_e2946 < _e2919));
let _e2954 = global_3.member[bitcast<u32>(select(0i, _e2948, (_e2948 > 0i)))];
let _e2959 = (bitcast<f32>(((_e2927 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2967 = (_e2959 + (((bitcast<f32>(((_e2936 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2959) * _e2916));
let _e2972 = (bitcast<f32>(((_e2945 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2996 = (bitcast<f32>((((_e2927 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3004 = (_e2996 + (((bitcast<f32>((((_e2936 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2996) * _e2916));
let _e3009 = (bitcast<f32>((((_e2945 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3021 = (_e2912 + 3i);
let _e3023 = select(_e2919, _e3021, (_e3021 < _e2919));
let _e3029 = global_3.member[bitcast<u32>(select(0i, _e3023, (_e3023 > 0i)))];
let _e3030 = (_e2912 + 7i);
let _e3032 = select(_e2919, _e3030, (_e3030 < _e2919));
let _e3038 = global_3.member[bitcast<u32>(select(0i, _e3032, (_e3032 > 0i)))];
let _e3039 = (_e2912 + 1027i);
let _e3041 = select(_e2919, _e3039, (_e3039 < _e2919));
let _e3047 = global_3.member[bitcast<u32>(select(0i, _e3041, (_e3041 > 0i)))];
let _e3048 = (_e2912 + 1031i);
let _e3050 = select(_e2919, _e3048, (_e3048 < _e2919));
let _e3056 = global_3.member[bitcast<u32>(select(0i, _e3050, (_e3050 > 0i)))];
let _e3061 = (bitcast<f32>(((_e3029 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3069 = (_e3061 + (((bitcast<f32>(((_e3038 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3061) * _e2916));
let _e3074 = (bitcast<f32>(((_e3047 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3098 = (bitcast<f32>((((_e3029 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3106 = (_e3098 + (((bitcast<f32>((((_e3038 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3098) * _e2916));
let _e3111 = (bitcast<f32>((((_e3047 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3122 = (_e3106 + (((_e3111 + (((bitcast<f32>((((_e3056 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3111) * _e2916)) - _e3106) * _e2914));
let _e3126 = -((_e3122 * (_e2874 * _e2769.member)));
let _e3128 = select(-87f, _e3126, (_e3126 > -87f));
let _e3130 = select(88f, _e3128, (_e3128 < 88f));
let _e3132 = ((_e3130 * 1.442695f) + 0.5f);
let _e3134 = select(-127f, _e3132, (_e3132 > -127f));
let _e3136 = select(128f, _e3134, (_e3134 < 128f));
let _e3143 = select(0i, select(select(i32(_e3136), i32(-2147483648), (_e3136 < -2147483600f)), 2147483647i, (_e3136 > 2147483500f)), (_e3136 == _e3136));
let _e3147 = (_e3143 - select(0i, 1i, (_e3136 < f32(_e3143))));
let _e3148 = f32(_e3147);
let _e3152 = ((_e3130 - (_e3148 * 0.6933594f)) - (_e3148 * -2.1219444e-4f));
let _e3172 = ((1f + (_e3152 * (1f + (_e3152 * (0.5f + (_e3152 * (0.16666667f + (_e3152 * (0.041666668f + (_e3152 * (0.008333334f + (_e3152 * (0.001388889f + (_e3152 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3147 + 127i)) << bitcast<u32>(23i))));
let _e3173 = (1f - _e3172);
let _e3176 = (_e3173 / select(1e-12f, _e3122, (_e3122 > 1e-12f)));
phi_6514_ = type_31(_e3172, _e3173, vec3<f32>(1f, 1f, 1f), vec3<f32>(((_e2967 + (((_e2972 + (((bitcast<f32>(((_e2954 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2972) * _e2916)) - _e2967) * _e2914)) * _e3176), ((_e3004 + (((_e3009 + (((bitcast<f32>((((_e2954 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3009) * _e2916)) - _e3004) * _e2914)) * _e3176), ((_e3069 + (((_e3074 + (((bitcast<f32>(((_e3056 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3074) * _e2916)) - _e3069) * _e2914)) * _e3176)));
} else {
let _e3183 = (_e2480 * 255f);
let _e3184 = (_e2213.member * 255f);
let _e3185 = (255f - 1f);
let _e3187 = select(0f, _e3183, (_e3183 > 0f));
let _e3189 = select(_e3185, _e3187, (_e3187 < _e3185));
let _e3196 = select(0i, select(select(i32(_e3189), i32(-2147483648), (_e3189 < -2147483600f)), 2147483647i, (_e3189 > 2147483500f)), (_e3189 == _e3189));
let _e3200 = (_e3196 - select(0i, 1i, (_e3189 < f32(_e3196))));
let _e3202 = select(0f, _e3184, (_e3184 > 0f));
let _e3204 = select(_e3185, _e3202, (_e3202 < _e3185));
let _e3211 = select(0i, select(select(i32(_e3204), i32(-2147483648), (_e3204 < -2147483600f)), 2147483647i, (_e3204 > 2147483500f)), (_e3204 == _e3204));
let _e3215 = (_e3211 - select(0i, 1i, (_e3204 < f32(_e3211))));
let _e3218 = (((_e3200 * 256i) + _e3215) * 4i);
let _e3220 = (_e3183 - f32(_e3200));
let _e3222 = (_e3184 - f32(_e3215));
let _e3224 = (bitcast<i32>(_e123) - 1i);
let _e3226 = select(_e3224, _e3218, (_e3218 < _e3224));
let _e3232 = global_3.member[bitcast<u32>(select(0i, _e3226, (_e3226 > 0i)))];
let _e3233 = (_e3218 + 4i);
let _e3235 = select(_e3224, _e3233, (_e3233 < _e3224));
let _e3241 = global_3.member[bitcast<u32>(select(0i, _e3235, (_e3235 > 0i)))];
let _e3242 = (_e3218 + 1024i);
let _e3244 = select(_e3224, _e3242, (_e3242 < _e3224));
let _e3250 = global_3.member[bitcast<u32>(select(0i, _e3244, (_e3244 > 0i)))];
let _e3251 = (_e3218 + 1028i);
let _e3253 = select(_e3224, _e3251, (_e3251 < _e3224));
let _e3259 = global_3.member[bitcast<u32>(select(0i, _e3253, (_e3253 > 0i)))];
let _e3264 = (bitcast<f32>(((_e3232 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3272 = (_e3264 + (((bitcast<f32>(((_e3241 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3264) * _e3222));
let _e3277 = (bitcast<f32>(((_e3250 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3288 = (_e3272 + (((_e3277 + (((bitcast<f32>(((_e3259 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3277) * _e3222)) - _e3272) * _e3220));
let _e3301 = (bitcast<f32>((((_e3232 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3309 = (_e3301 + (((bitcast<f32>((((_e3241 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3301) * _e3222));
let _e3314 = (bitcast<f32>((((_e3250 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3326 = (_e3218 + 1i);
let _e3328 = select(_e3224, _e3326, (_e3326 < _e3224));
let _e3334 = global_3.member[bitcast<u32>(select(0i, _e3328, (_e3328 > 0i)))];
let _e3335 = (_e3218 + 5i);
let _e3337 = select(_e3224, _e3335, (_e3335 < _e3224));
let _e3343 = global_3.member[bitcast<u32>(select(0i, _e3337, (_e3337 > 0i)))];
let _e3344 = (_e3218 + 1025i);
let _e3346 = select(_e3224, _e3344, (_e3344 < _e3224));
let _e3352 = global_3.member[bitcast<u32>(select(0i, _e3346, (_e3346 > 0i)))];
let _e3353 = (_e3218 + 1029i);
let _e3355 = select(_e3224, _e3353, (_e3353 < _e3224));
let _e3361 = global_3.member[bitcast<u32>(select(0i, _e3355, (_e3355 > 0i)))];
let _e3366 = (bitcast<f32>(((_e3334 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3374 = (_e3366 + (((bitcast<f32>(((_e3343 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3366) * _e3222));
let _e3379 = (bitcast<f32>(((_e3352 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3403 = (bitcast<f32>((((_e3334 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3411 = (_e3403 + (((bitcast<f32>((((_e3343 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3403) * _e3222));
let _e3416 = (bitcast<f32>((((_e3352 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3428 = (_e3218 + 2i);
let _e3430 = select(_e3224, _e3428, (_e3428 < _e3224));
let _e3436 = global_3.member[bitcast<u32>(select(0i, _e3430, (_e3430 > 0i)))];
let _e3437 = (_e3218 + 6i);
let _e3439 = select(_e3224, _e3437, (_e3437 < _e3224));
let _e3445 = global_3.member[bitcast<u32>(select(0i, _e3439, (_e3439 > 0i)))];
let _e3446 = (_e3218 + 1026i);
let _e3448 = select(_e3224, _e3446, (_e3446 < _e3224));
let _e3454 = global_3.member[bitcast<u32>(select(0i, _e3448, (_e3448 > 0i)))];
let _e3455 = (_e3218 + 1030i);
let _e3457 = select(_e3224, _e3455, (_e3455 < _e3224));
let _e3463 = global_3.member[bitcast<u32>(select(0i, _e3457, (_e3457 > 0i)))];
let _e3468 = (bitcast<f32>(((_e3436 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3476 = (_e3468 + (((bitcast<f32>(((_e3445 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3468) * _e3222));
let _e3481 = (bitcast<f32>(((_e3454 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3505 = (bitcast<f32>((((_e3436 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3513 = (_e3505 + (((bitcast<f32>((((_e3445 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3505) * _e3222));
let _e3518 = (bitcast<f32>((((_e3454 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3530 = (_e3218 + 3i);
let _e3532 = select(_e3224, _e3530, (_e3530 < _e3224));
let _e3538 = global_3.member[bitcast<u32>(select(0i, _e3532, (_e3532 > 0i)))];
let _e3539 = (_e3218 + 7i);
let _e3541 = select(_e3224, _e3539, (_e3539 < _e3224));
let _e3547 = global_3.member[bitcast<u32>(select(0i, _e3541, (_e3541 > 0i)))];
let _e3548 = (_e3218 + 1027i);
let _e3550 = select(_e3224, _e3548, (_e3548 < _e3224));
let _e3556 = global_3.member[bitcast<u32>(select(0i, _e3550, (_e3550 > 0i)))];
let _e3557 = (_e3218 + 1031i);
let _e3559 = select(_e3224, _e3557, (_e3557 < _e3224));
let _e3565 = global_3.member[bitcast<u32>(select(0i, _e3559, (_e3559 > 0i)))];
let _e3570 = (bitcast<f32>(((_e3538 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3578 = (_e3570 + (((bitcast<f32>(((_e3547 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3570) * _e3222));
let _e3583 = (bitcast<f32>(((_e3556 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3598 = (_e2874 * _e2769.member_1);
let _e3600 = -(((_e3309 + (((_e3314 + (((bitcast<f32>((((_e3259 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3314) * _e3222)) - _e3309) * _e3220)) * _e3598));
let _e3602 = select(-87f, _e3600, (_e3600 > -87f));
let _e3604 = select(88f, _e3602, (_e3602 < 88f));
let _e3606 = ((_e3604 * 1.442695f) + 0.5f);
let _e3608 = select(-127f, _e3606, (_e3606 > -127f));
let _e3610 = select(128f, _e3608, (_e3608 < 128f));
let _e3617 = select(0i, select(select(i32(_e3610), i32(-2147483648), (_e3610 < -2147483600f)), 2147483647i, (_e3610 > 2147483500f)), (_e3610 == _e3610));
let _e3621 = (_e3617 - select(0i, 1i, (_e3610 < f32(_e3617))));
let _e3622 = f32(_e3621);
let _e3626 = ((_e3604 - (_e3622 * 0.6933594f)) - (_e3622 * -2.1219444e-4f));
let _e3648 = -(((_e3374 + (((_e3379 + (((bitcast<f32>(((_e3361 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3379) * _e3222)) - _e3374) * _e3220)) * _e3598));
let _e3650 = select(-87f, _e3648, (_e3648 > -87f));
let _e3652 = select(88f, _e3650, (_e3650 < 88f));
let _e3654 = ((_e3652 * 1.442695f) + 0.5f);
let _e3656 = select(-127f, _e3654, (_e3654 > -127f));
let _e3658 = select(128f, _e3656, (_e3656 < 128f));
let _e3665 = select(0i, select(select(i32(_e3658), i32(-2147483648), (_e3658 < -2147483600f)), 2147483647i, (_e3658 > 2147483500f)), (_e3658 == _e3658));
let _e3669 = (_e3665 - select(0i, 1i, (_e3658 < f32(_e3665))));
let _e3670 = f32(_e3669);
let _e3674 = ((_e3652 - (_e3670 * 0.6933594f)) - (_e3670 * -2.1219444e-4f));
let _e3696 = -(((_e3411 + (((_e3416 + (((bitcast<f32>((((_e3361 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3416) * _e3222)) - _e3411) * _e3220)) * _e3598));
let _e3698 = select(-87f, _e3696, (_e3696 > -87f));
let _e3700 = select(88f, _e3698, (_e3698 < 88f));
let _e3702 = ((_e3700 * 1.442695f) + 0.5f);
let _e3704 = select(-127f, _e3702, (_e3702 > -127f));
let _e3706 = select(128f, _e3704, (_e3704 < 128f));
let _e3713 = select(0i, select(select(i32(_e3706), i32(-2147483648), (_e3706 < -2147483600f)), 2147483647i, (_e3706 > 2147483500f)), (_e3706 == _e3706));
let _e3717 = (_e3713 - select(0i, 1i, (_e3706 < f32(_e3713))));
let _e3718 = f32(_e3717);
let _e3722 = ((_e3700 - (_e3718 * 0.6933594f)) - (_e3718 * -2.1219444e-4f));
let _e3745 = -((_e3288 * (_e2874 * _e2769.member)));
let _e3747 = select(-87f, _e3745, (_e3745 > -87f));
let _e3749 = select(88f, _e3747, (_e3747 < 88f));
let _e3751 = ((_e3749 * 1.442695f) + 0.5f);
let _e3753 = select(-127f, _e3751, (_e3751 > -127f));
let _e3755 = select(128f, _e3753, (_e3753 < 128f));
let _e3762 = select(0i, select(select(i32(_e3755), i32(-2147483648), (_e3755 < -2147483600f)), 2147483647i, (_e3755 > 2147483500f)), (_e3755 == _e3755));
let _e3766 = (_e3762 - select(0i, 1i, (_e3755 < f32(_e3762))));
let _e3767 = f32(_e3766);
let _e3771 = ((_e3749 - (_e3767 * 0.6933594f)) - (_e3767 * -2.1219444e-4f));
let _e3791 = ((1f + (_e3771 * (1f + (_e3771 * (0.5f + (_e3771 * (0.16666667f + (_e3771 * (0.041666668f + (_e3771 * (0.008333334f + (_e3771 * (0.001388889f + (_e3771 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3766 + 127i)) << bitcast<u32>(23i))));
let _e3792 = (1f - _e3791);
let _e3795 = (_e3792 / select(1e-12f, _e3288, (_e3288 > 1e-12f)));
phi_6514_ = type_31(_e3791, _e3792, vec3<f32>(((1f + (_e3626 * (1f + (_e3626 * (0.5f + (_e3626 * (0.16666667f + (_e3626 * (0.041666668f + (_e3626 * (0.008333334f + (_e3626 * (0.001388889f + (_e3626 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3621 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e3674 * (1f + (_e3674 * (0.5f + (_e3674 * (0.16666667f + (_e3674 * (0.041666668f + (_e3674 * (0.008333334f + (_e3674 * (0.001388889f + (_e3674 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3669 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e3722 * (1f + (_e3722 * (0.5f + (_e3722 * (0.16666667f + (_e3722 * (0.041666668f + (_e3722 * (0.008333334f + (_e3722 * (0.001388889f + (_e3722 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3717 + 127i)) << bitcast<u32>(23i))))), vec3<f32>(((_e3476 + (((_e3481 + (((bitcast<f32>(((_e3463 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3481) * _e3222)) - _e3476) * _e3220)) * _e3795), ((_e3513 + (((_e3518 + (((bitcast<f32>((((_e3463 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3518) * _e3222)) - _e3513) * _e3220)) * _e3795), ((_e3578 + (((_e3583 + (((bitcast<f32>(((_e3565 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3583) * _e3222)) - _e3578) * _e3220)) * _e3795)));
}
let _e3802 = phi_6514_;
let _e3803 = select(0f, _e2556, _e442);
let _e3807 = (_e377 + (_e2856 * _e3803));
let _e3808 = (_e380 + (_e2857 * _e3803));
let _e3809 = (_e371 + (_e2858 * _e3803));
if (_e729.member_2 == 3u) {
let _e3815 = global_5.member[_e352].member_9.member_1;
let _e3824 = global_5.member[_e352].member_9.member;
phi_7497_ = type_25(vec3<f32>(_e3815.member, _e3815.member_1, _e3815.member_2), vec3<f32>(_e3824.member, _e3824.member_1, _e3824.member_2));
} else {
let _e3834 = global_5.member[_e352].member_8.member_8;
let _e3835 = (_e3809 - _e3834);
let _e3840 = global_5.member[_e352].member_8.member_2;
let _e3845 = global_5.member[_e352].member_8.member_6;
let _e3853 = global_5.member[_e352].member_8.member_5;
let _e3855 = (((_e3807 - (_e3840 + (_e3845 * _e3835))) * _e3853) - 0.5f);
let _e3860 = global_5.member[_e352].member_8.member_3;
let _e3865 = global_5.member[_e352].member_8.member_7;
let _e3870 = (((_e3808 - (_e3860 + (_e3865 * _e3835))) * _e3853) - 0.5f);
let _e3875 = global_5.member[_e352].member_8.member;
let _e3876 = bitcast<i32>(_e3875);
let _e3878 = (f32(_e3876) - 1f);
let _e3883 = global_5.member[_e352].member_8.member_1;
let _e3886 = (f32(bitcast<i32>(_e3883)) - 1f);
let _e3888 = select(0f, _e3855, (_e3855 > 0f));
let _e3890 = select(_e3878, _e3888, (_e3888 < _e3878));
let _e3897 = select(0i, select(select(i32(_e3890), i32(-2147483648), (_e3890 < -2147483600f)), 2147483647i, (_e3890 > 2147483500f)), (_e3890 == _e3890));
let _e3901 = (_e3897 - select(0i, 1i, (_e3890 < f32(_e3897))));
let _e3903 = select(0f, _e3870, (_e3870 > 0f));
let _e3905 = select(_e3886, _e3903, (_e3903 < _e3886));
let _e3912 = select(0i, select(select(i32(_e3905), i32(-2147483648), (_e3905 < -2147483600f)), 2147483647i, (_e3905 > 2147483500f)), (_e3905 == _e3905));
let _e3916 = (_e3912 - select(0i, 1i, (_e3905 < f32(_e3912))));
let _e3920 = (_e3855 - f32(_e3901));
let _e3922 = (_e3870 - f32(_e3916));
let _e3929 = ((((_e3855 >= 0f) && (_e3855 <= _e3878)) && (_e3870 >= 0f)) && (_e3870 <= _e3886));
let _e3933 = global_5.member[_e352].member_4;
let _e3934 = bitcast<i32>(_e3933);
let _e3936 = bitcast<i32>((_e3875 * _e3883));
let _e3938 = (_e3934 + (3i * _e3936));
local_1 = (_e3938 + ((_e3916 * _e3876) + _e3901));
let _e3940 = local_1;
let _e3942 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e3944 = select(_e3942, _e3940, (_e3940 < _e3942));
let _e3949 = global_6.member[bitcast<u32>(select(0i, _e3944, (_e3944 > 0i)))];
let _e3950 = bitcast<u32>(_e3949);
let _e3954 = f32((bitcast<i32>((_e3950 & 65535u)) - 32768i));
let _e3960 = f32((bitcast<i32>(((_e3950 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e3965 = select(_e3960, -(_e3960), ((_e3950 >> bitcast<u32>(31i)) != 0u));
let _e3966 = local_1;
let _e3967 = (_e3966 + 1i);
let _e3969 = select(_e3942, _e3967, (_e3967 < _e3942));
let _e3974 = global_6.member[bitcast<u32>(select(0i, _e3969, (_e3969 > 0i)))];
let _e3975 = bitcast<u32>(_e3974);
let _e3985 = f32((bitcast<i32>(((_e3975 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e3991 = local_1;
let _e3992 = (_e3991 + _e3876);
let _e3994 = select(_e3942, _e3992, (_e3992 < _e3942));
let _e3999 = global_6.member[bitcast<u32>(select(0i, _e3994, (_e3994 > 0i)))];
let _e4000 = bitcast<u32>(_e3999);
let _e4004 = f32((bitcast<i32>((_e4000 & 65535u)) - 32768i));
let _e4010 = f32((bitcast<i32>(((_e4000 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4015 = select(_e4010, -(_e4010), ((_e4000 >> bitcast<u32>(31i)) != 0u));
let _e4016 = (_e3876 + 1i);
let _e4017 = local_1;
let _e4018 = (_e4017 + _e4016);
let _e4020 = select(_e3942, _e4018, (_e4018 < _e3942));
let _e4025 = global_6.member[bitcast<u32>(select(0i, _e4020, (_e4020 > 0i)))];
let _e4026 = bitcast<u32>(_e4025);
let _e4036 = f32((bitcast<i32>(((_e4026 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4044 = (_e3954 + ((f32((bitcast<i32>((_e3975 & 65535u)) - 32768i)) - _e3954) * _e3920));
let _e4053 = (_e3965 + ((select(_e3985, -(_e3985), ((_e3975 >> bitcast<u32>(31i)) != 0u)) - _e3965) * _e3920));
let _e4066 = global_5.member[_e352].member_9.member;
let _e4069 = (1f / 16255f);
let _e4071 = (_e4066.member + (select(0f, (_e4044 + (((_e4004 + ((f32((bitcast<i32>((_e4026 & 65535u)) - 32768i)) - _e4004) * _e3920)) - _e4044) * _e3922)), _e3929) * _e4069));
let _e4073 = (_e4066.member_1 + (select(0f, (_e4053 + (((_e4015 + ((select(_e4036, -(_e4036), ((_e4026 >> bitcast<u32>(31i)) != 0u)) - _e4015) * _e3920)) - _e4053) * _e3922)), _e3929) * _e4069));
let _e4077 = (1f - ((_e4071 * _e4071) + (_e4073 * _e4073)));
let _e4079 = select(1e-4f, _e4077, (_e4077 > 1e-4f));
let _e4082 = sqrt(select(0f, _e4079, (_e4079 > 0f)));
let _e4086 = (1f / select(1e-6f, _e4082, (_e4082 > 1e-6f)));
let _e4087 = ((_e3809 - _e371) * _e3853);
let _e4094 = (_e3855 - (((_e4071 * _e4086) - _e3845) * _e4087));
let _e4095 = (_e3870 - (((_e4073 * _e4086) - _e3865) * _e4087));
let _e4097 = select(0f, _e4094, (_e4094 > 0f));
let _e4099 = select(_e3878, _e4097, (_e4097 < _e3878));
let _e4106 = select(0i, select(select(i32(_e4099), i32(-2147483648), (_e4099 < -2147483600f)), 2147483647i, (_e4099 > 2147483500f)), (_e4099 == _e4099));
let _e4110 = (_e4106 - select(0i, 1i, (_e4099 < f32(_e4106))));
let _e4112 = select(0f, _e4095, (_e4095 > 0f));
let _e4114 = select(_e3886, _e4112, (_e4112 < _e3886));
let _e4121 = select(0i, select(select(i32(_e4114), i32(-2147483648), (_e4114 < -2147483600f)), 2147483647i, (_e4114 > 2147483500f)), (_e4114 == _e4114));
let _e4125 = (_e4121 - select(0i, 1i, (_e4114 < f32(_e4121))));
let _e4127 = ((_e4125 * _e3876) + _e4110);
let _e4129 = (_e4094 - f32(_e4110));
let _e4131 = (_e4095 - f32(_e4125));
let _e4138 = ((((_e4094 >= 0f) && (_e4094 <= _e3878)) && (_e4095 >= 0f)) && (_e4095 <= _e3886));
let _e4139 = (_e3934 + _e4127);
let _e4141 = select(_e3942, _e4139, (_e4139 < _e3942));
let _e4147 = global_6.member[bitcast<u32>(select(0i, _e4141, (_e4141 > 0i)))];
let _e4148 = (_e4139 + 1i);
let _e4150 = select(_e3942, _e4148, (_e4148 < _e3942));
let _e4156 = global_6.member[bitcast<u32>(select(0i, _e4150, (_e4150 > 0i)))];
let _e4159 = (_e4147 + ((_e4156 - _e4147) * _e4129));
let _e4160 = (_e4139 + _e3876);
let _e4162 = select(_e3942, _e4160, (_e4160 < _e3942));
let _e4168 = global_6.member[bitcast<u32>(select(0i, _e4162, (_e4162 > 0i)))];
let _e4169 = (_e4160 + 1i);
let _e4171 = select(_e3942, _e4169, (_e4169 < _e3942));
let _e4177 = global_6.member[bitcast<u32>(select(0i, _e4171, (_e4171 > 0i)))];
let _e4184 = select(1f, (_e4159 + (((_e4168 + ((_e4177 - _e4168) * _e4129)) - _e4159) * _e4131)), _e4138);
if _e2875 {
phi_7267_ = vec3(_e4184);
} else {
let _e4187 = ((_e3934 + _e3936) + _e4127);
let _e4189 = select(_e3942, _e4187, (_e4187 < _e3942));
let _e4195 = global_6.member[bitcast<u32>(select(0i, _e4189, (_e4189 > 0i)))];
let _e4196 = (_e4187 + 1i);
let _e4198 = select(_e3942, _e4196, (_e4196 < _e3942));
let _e4204 = global_6.member[bitcast<u32>(select(0i, _e4198, (_e4198 > 0i)))];
let _e4207 = (_e4195 + ((_e4204 - _e4195) * _e4129));
let _e4208 = (_e4187 + _e3876);
let _e4210 = select(_e3942, _e4208, (_e4208 < _e3942));
let _e4216 = global_6.member[bitcast<u32>(select(0i, _e4210, (_e4210 > 0i)))];
let _e4217 = (_e4208 + 1i);
let _e4219 = select(_e3942, _e4217, (_e4217 < _e3942));
let _e4225 = global_6.member[bitcast<u32>(select(0i, _e4219, (_e4219 > 0i)))];
let _e4235 = ((_e3934 + (2i * _e3936)) + _e4127);
let _e4237 = select(_e3942, _e4235, (_e4235 < _e3942));
let _e4243 = global_6.member[bitcast<u32>(select(0i, _e4237, (_e4237 > 0i)))];
let _e4244 = (_e4235 + 1i);
let _e4246 = select(_e3942, _e4244, (_e4244 < _e3942));
let _e4252 = global_6.member[bitcast<u32>(select(0i, _e4246, (_e4246 > 0i)))];
let _e4255 = (_e4243 + ((_e4252 - _e4243) * _e4129));
let _e4256 = (_e4235 + _e3876);
let _e4258 = select(_e3942, _e4256, (_e4256 < _e3942));
let _e4264 = global_6.member[bitcast<u32>(select(0i, _e4258, (_e4258 > 0i)))];
let _e4265 = (_e4256 + 1i);
let _e4267 = select(_e3942, _e4265, (_e4265 < _e3942));
let _e4273 = global_6.member[bitcast<u32>(select(0i, _e4267, (_e4267 > 0i)))];
phi_7267_ = vec3<f32>(_e4184, select(1f, (_e4207 + (((_e4216 + ((_e4225 - _e4216) * _e4129)) - _e4207) * _e4131)), _e4138), select(1f, (_e4255 + (((_e4264 + ((_e4273 - _e4264) * _e4129)) - _e4255) * _e4131)), _e4138));
}
let _e4283 = phi_7267_;
local = (_e3938 + _e4127);
let _e4285 = local;
let _e4287 = select(_e3942, _e4285, (_e4285 < _e3942));
let _e4292 = global_6.member[bitcast<u32>(select(0i, _e4287, (_e4287 > 0i)))];
let _e4293 = bitcast<u32>(_e4292);
let _e4297 = f32((bitcast<i32>((_e4293 & 65535u)) - 32768i));
let _e4303 = f32((bitcast<i32>(((_e4293 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4308 = select(_e4303, -(_e4303), ((_e4293 >> bitcast<u32>(31i)) != 0u));
let _e4309 = local;
let _e4310 = (_e4309 + 1i);
let _e4312 = select(_e3942, _e4310, (_e4310 < _e3942));
let _e4317 = global_6.member[bitcast<u32>(select(0i, _e4312, (_e4312 > 0i)))];
let _e4318 = bitcast<u32>(_e4317);
let _e4328 = f32((bitcast<i32>(((_e4318 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4334 = local;
let _e4335 = (_e4334 + _e3876);
let _e4337 = select(_e3942, _e4335, (_e4335 < _e3942));
let _e4342 = global_6.member[bitcast<u32>(select(0i, _e4337, (_e4337 > 0i)))];
let _e4343 = bitcast<u32>(_e4342);
let _e4347 = f32((bitcast<i32>((_e4343 & 65535u)) - 32768i));
let _e4353 = f32((bitcast<i32>(((_e4343 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4358 = select(_e4353, -(_e4353), ((_e4343 >> bitcast<u32>(31i)) != 0u));
let _e4359 = local;
let _e4360 = (_e4359 + _e4016);
let _e4362 = select(_e3942, _e4360, (_e4360 < _e3942));
let _e4367 = global_6.member[bitcast<u32>(select(0i, _e4362, (_e4362 > 0i)))];
let _e4368 = bitcast<u32>(_e4367);
let _e4378 = f32((bitcast<i32>(((_e4368 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4386 = (_e4297 + ((f32((bitcast<i32>((_e4318 & 65535u)) - 32768i)) - _e4297) * _e4129));
let _e4395 = (_e4308 + ((select(_e4328, -(_e4328), ((_e4318 >> bitcast<u32>(31i)) != 0u)) - _e4308) * _e4129));
let _e4408 = global_5.member[_e352].member_9.member_1;
let _e4415 = (_e4066.member + (select(0f, (_e4386 + (((_e4347 + ((f32((bitcast<i32>((_e4368 & 65535u)) - 32768i)) - _e4347) * _e4129)) - _e4386) * _e4131)), _e4138) * _e4069));
let _e4417 = (_e4066.member_1 + (select(0f, (_e4395 + (((_e4358 + ((select(_e4378, -(_e4378), ((_e4368 >> bitcast<u32>(31i)) != 0u)) - _e4358) * _e4129)) - _e4395) * _e4131)), _e4138) * _e4069));
let _e4421 = (1f - ((_e4415 * _e4415) + (_e4417 * _e4417)));
let _e4423 = select(1e-4f, _e4421, (_e4421 > 1e-4f));
phi_7497_ = type_25((_e4283 * vec3<f32>(_e4408.member, _e4408.member_1, _e4408.member_2)), vec3<f32>(_e4415, _e4417, sqrt(select(0f, _e4423, (_e4423 > 0f)))));
}
let _e4430 = phi_7497_;
let _e4439 = (((_e4430.member_1.x * _e4430.member_1.x) + (_e4430.member_1.y * _e4430.member_1.y)) + (_e4430.member_1.z * _e4430.member_1.z));
let _e4442 = sqrt(select(0f, _e4439, (_e4439 > 0f)));
let _e4448 = (1e-6f * _e4442);
let _e4452 = select((_e4442 / select(_e4448, _e4430.member_1.z, (_e4430.member_1.z > _e4448))), 1f, ((_e685 & 8u) != 0u));
let _e4454 = (_e4430.member.x * _e4452);
let _e4456 = (_e4430.member.y * _e4452);
let _e4458 = (_e4430.member.z * _e4452);
if _e792 {
let _e4463 = global_5.member[_e352].member_19;
let _e4472 = (((_e2213.member_1.x * _e2213.member_1.x) + (_e2213.member_1.y * _e2213.member_1.y)) + (_e2213.member_1.z * _e2213.member_1.z));
let _e4475 = sqrt(select(0f, _e4472, (_e4472 > 0f)));
let _e4478 = (1f / select(1e-20f, _e4475, (_e4475 > 1e-20f)));
let _e4479 = (_e2213.member_1.x * _e4478);
let _e4480 = (_e2213.member_1.y * _e4478);
let _e4481 = (_e2213.member_1.z * _e4478);
let _e4484 = (-1f / select(1e-20f, _e4442, (_e4442 > 1e-20f)));
let _e4485 = (_e4430.member_1.x * _e4484);
let _e4486 = (_e4430.member_1.y * _e4484);
let _e4487 = (_e4430.member_1.z * _e4484);
let _e4492 = (((_e356[2] * _e356[2]) + (_e356[3] * _e356[3])) + (_e356[4] * _e356[4]));
let _e4495 = sqrt(select(0f, _e4492, (_e4492 > 0f)));
let _e4498 = (-1f / select(1e-20f, _e4495, (_e4495 > 1e-20f)));
let _e4499 = (_e356[2] * _e4498);
let _e4500 = (_e356[3] * _e4498);
let _e4501 = (_e356[4] * _e4498);
let _e4508 = select(1f, -1f, ((((_e4479 * _e4499) + (_e4480 * _e4500)) + (_e4481 * _e4501)) < 0f));
let _e4509 = (_e4479 * _e4508);
let _e4510 = (_e4480 * _e4508);
let _e4511 = (_e4481 * _e4508);
let _e4516 = (((_e4509 * _e4499) + (_e4510 * _e4500)) + (_e4511 * _e4501));
let _e4518 = select(1e-4f, _e4516, (_e4516 > 1e-4f));
let _e4523 = (((_e4509 * _e4485) + (_e4510 * _e4486)) + (_e4511 * _e4487));
let _e4524 = (_e4485 + _e4499);
let _e4525 = (_e4486 + _e4500);
let _e4526 = (_e4487 + _e4501);
let _e4531 = (((_e4524 * _e4524) + (_e4525 * _e4525)) + (_e4526 * _e4526));
let _e4534 = sqrt(select(0f, _e4531, (_e4531 > 0f)));
let _e4537 = (1f / select(1e-6f, _e4534, (_e4534 > 1e-6f)));
let _e4538 = (_e4524 * _e4537);
let _e4539 = (_e4525 * _e4537);
let _e4540 = (_e4526 * _e4537);
let _e4545 = (((_e4509 * _e4538) + (_e4510 * _e4539)) + (_e4511 * _e4540));
let _e4547 = select(0f, _e4545, (_e4545 > 0f));
let _e4552 = (((_e4499 * _e4538) + (_e4500 * _e4539)) + (_e4501 * _e4540));
let _e4554 = select(0f, _e4552, (_e4552 > 0f));
let _e4555 = (_e4463 * _e4463);
let _e4556 = (_e4555 * _e4555);
let _e4560 = (((_e4547 * _e4547) * (_e4556 - 1f)) + 1f);
let _e4564 = (_e4523 > 0f);
let _e4565 = select(0f, _e4523, _e4564);
let _e4567 = (1f - _e4556);
let _e4569 = (((_e4565 * _e4565) * _e4567) + _e4556);
let _e4576 = (((_e4518 * _e4518) * _e4567) + _e4556);
let _e4581 = ((_e4518 * sqrt(select(0f, _e4569, (_e4569 > 0f)))) + (_e4565 * sqrt(select(0f, _e4576, (_e4576 > 0f)))));
let _e4586 = (_e2213.member_2 / _e2553);
let _e4590 = (((_e4586 * _e4586) - 1f) + (_e4554 * _e4554));
let _e4593 = sqrt(select(0f, _e4590, (_e4590 > 0f)));
let _e4594 = (_e4593 - _e4554);
let _e4595 = (_e4593 + _e4554);
let _e4598 = (_e4594 / select(1e-6f, _e4595, (_e4595 > 1e-6f)));
let _e4602 = ((_e4554 * _e4594) + 1f);
let _e4605 = (((_e4554 * _e4595) - 1f) / select(1e-6f, _e4602, (_e4602 > 1e-6f)));
let _e4623 = global_5.member[_e352].member_20;
let _e4627 = ((select(0f, ((((_e4556 / ((3.1415927f * _e4560) * _e4560)) * (0.5f / select(1e-6f, _e4581, (_e4581 > 1e-6f)))) * select(select((((0.5f * _e4598) * _e4598) * (1f + (_e4605 * _e4605))), 1f, (_e4590 <= 0f)), 0f, (_e2553 == _e2213.member_2))) * _e4565), (_e4564 && (_e4475 > 1e-12f))) * _e4623) * select(_e2769.member_2, 0f, _e442));
phi_7815_ = vec3<f32>((_e4454 * _e4627), (_e4456 * _e4627), (_e4458 * _e4627));
} else {
phi_7815_ = vec3<f32>(0f, 0f, 0f);
}
let _e4633 = phi_7815_;
let _e4644 = global_5.member[_e352].member_18;
let _e4651 = (1f - _e356[11]);
let _e4671 = (_e356[8] + ((_e356[12] * ((_e3802.member_3.x * (_e4454 + _e4644.member)) + _e4633.x)) * _e4651));
let _e4672 = (_e356[9] + ((_e356[13] * ((_e3802.member_3.y * (_e4456 + _e4644.member_1)) + _e4633.y)) * _e4651));
let _e4673 = (_e356[10] + ((_e356[14] * ((_e3802.member_3.z * (_e4458 + _e4644.member_2)) + _e4633.z)) * _e4651));
let _e4676 = (_e356[11] + (_e4651 * _e3802.member_1));
let _e4679 = (_e356[12] * _e3802.member_2.x);
let _e4681 = (_e356[13] * _e3802.member_2.y);
let _e4683 = (_e356[14] * _e3802.member_2.z);
let _e4689 = (_e356[7] + ((_e4676 - _e356[11]) * (_e371 + (_e2858 * 0.5f))));
let _e4698 = (-((((select(_e762.member, _e749.member, _e742) * _e4430.member_1.x) + (select(_e762.member_1, _e749.member_1, _e742) * _e4430.member_1.y)) + (select(_e762.member_2, _e749.member_2, _e742) * _e4430.member_1.z))) / select(1e-20f, _e4442, (_e4442 > 1e-20f)));
let _e4703 = bitcast<f32>((bitcast<u32>(select(0f, _e4698, (_e4698 > 0f))) & 2147483647u));
let _e4713 = (1f - _e4676);
let _e4726 = select(_e4676, 1f, _e442);
if _e792 {
let _e4735 = global_5.member[_e352].member_5.member_4;
let _e4738 = (_e2213.member_3.x * _e2769.member_2);
let _e4740 = (_e2213.member_3.y * _e2769.member_2);
let _e4742 = (_e2213.member_3.z * _e2769.member_2);
let _e4743 = (0.5f * _e366);
let _e4747 = (_e356[2] + (_e4738 * _e4743));
let _e4748 = (_e356[3] + (_e4740 * _e4743));
let _e4749 = (_e356[4] + (_e4742 * _e4743));
let _e4751 = (2f * _e365);
let _e4753 = ((_e4749 * _e4749) + (_e4751 * _e4742));
let _e4757 = (_e4749 + sqrt(select(0f, _e4753, (_e4753 > 0f))));
let _e4761 = (0.5f * (_e4751 / select(1e-6f, _e4757, (_e4757 > 1e-6f))));
let _e4765 = (_e4747 + (_e4738 * _e4761));
let _e4766 = (_e4748 + (_e4740 * _e4761));
let _e4767 = (_e4749 + (_e4742 * _e4761));
let _e4771 = (_e4735 * _e4735);
let _e4773 = (_e4767 * _e4767);
let _e4781 = (((_e4749 <= 0f) || (_e4753 <= 0f)) || ((_e4767 <= 0f) || (_e4773 <= (_e4771 * (((_e4765 * _e4765) + (_e4766 * _e4766)) + _e4773)))));
let _e4795 = (_e356[2] + ((_e2213.member_4.x * _e2769.member_2) * _e365));
let _e4796 = (_e356[3] + ((_e2213.member_4.y * _e2769.member_2) * _e365));
let _e4797 = (_e356[4] + ((_e2213.member_4.z * _e2769.member_2) * _e365));
let _e4799 = (_e4797 * _e4797);
let _e4808 = ((_e685 & 1u) != 0u);
phi_8124_ = select(select(_e4767, _e4749, _e4781), _e4797, _e4808);
phi_8125_ = select(select(_e4766, _e4748, _e4781), _e4796, _e4808);
phi_8126_ = select(select(_e4765, _e4747, _e4781), _e4795, _e4808);
phi_8127_ = select(_e4781, ((_e4797 <= 0f) || (_e4799 <= (_e4771 * (((_e4795 * _e4795) + (_e4796 * _e4796)) + _e4799)))), _e4808);
} else {
phi_8124_ = _e356[4];
phi_8125_ = _e356[3];
phi_8126_ = _e356[2];
phi_8127_ = false;
}
let _e4814 = phi_8124_;
let _e4816 = phi_8125_;
let _e4818 = phi_8126_;
let _e4820 = phi_8127_;
let _e4826 = (((_e442 || (_e4818 != _e356[2])) || (_e4816 != _e356[3])) || (_e4814 != _e356[4]));
let _e4828 = select(_e4681, _e4679, (_e4679 > _e4681));
phi_8187_ = array<f32, 18>(select(_e356[0], select(_e382, _e3807, _e442), _e4826), select(_e356[1], select(_e384, _e3808, _e442), _e4826), _e4818, _e4816, _e4814, _e2213.member, select(select(0f, 2f, _e4820), 1f, (_e442 || (((1f - _e4726) * select(_e4683, _e4828, (_e4828 > _e4683))) < 9.765625e-4f))), select(_e4689, (_e4689 + (_e4713 * _e3809)), _e442), select(_e4671, (_e4671 + ((_e4679 * (select(_e768.member, _e755.member, _e742) * ((_e4454 * _e4703) + _e4644.member))) * _e4713)), _e442), select(_e4672, (_e4672 + ((_e4681 * (select(_e768.member_1, _e755.member_1, _e742) * ((_e4456 * _e4703) + _e4644.member_1))) * _e4713)), _e442), select(_e4673, (_e4673 + ((_e4683 * (select(_e768.member_2, _e755.member_2, _e742) * ((_e4458 * _e4703) + _e4644.member_2))) * _e4713)), _e442), _e4726, _e4679, _e4681, _e4683, _e2213.member_2, select(_e356[16], select(_e389, _e3809, _e442), _e4826), _e389);
} else {
phi_8187_ = _e356;
}
let _e4847 = phi_8187_;
phi_581_ = (_e352 + 1u);
phi_584_ = select(_e354, true, _e725);
phi_586_ = _e4847;
} else {
phi_581_ = u32();
phi_584_ = bool();
phi_586_ = array<f32, 18>();
}
let _e4851 = phi_581_;
let _e4853 = phi_584_;
let _e4855 = phi_586_;
continue;
continuing {
phi_580_ = _e4851;
phi_583_ = _e4853;
phi_585_ = _e4855;
phi_8270_ = false;
break if !(_e357);
}
}
let _e4858 = phi_8270_;
if _e4858 {
break;
}
let _e4860 = local_8;
if _e4860 {
let _e4862 = local_9;
global_4.member[_e152] = _e4862[0];
let _e4867 = local_10;
global_4.member[_e164] = _e4867[1];
let _e4872 = local_11;
global_4.member[_e175] = _e4872[2];
let _e4877 = local_12;
global_4.member[_e186] = _e4877[3];
let _e4882 = local_13;
global_4.member[_e197] = _e4882[4];
let _e4887 = local_14;
global_4.member[_e208] = _e4887[5];
let _e4892 = local_15;
global_4.member[_e219] = _e4892[6];
let _e4897 = local_16;
global_4.member[_e230] = _e4897[7];
let _e4902 = local_17;
global_4.member[_e241] = _e4902[8];
let _e4907 = local_18;
global_4.member[_e252] = _e4907[9];
let _e4912 = local_19;
global_4.member[_e263] = _e4912[10];
let _e4917 = local_20;
global_4.member[_e274] = _e4917[11];
let _e4922 = local_21;
global_4.member[_e285] = _e4922[12];
let _e4927 = local_22;
global_4.member[_e296] = _e4927[13];
let _e4932 = local_23;
global_4.member[_e307] = _e4932[14];
let _e4937 = local_24;
global_4.member[_e318] = _e4937[15];
let _e4942 = local_25;
global_4.member[_e329] = _e4942[16];
let _e4947 = local_26;
global_4.member[_e340] = _e4947[17];
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
