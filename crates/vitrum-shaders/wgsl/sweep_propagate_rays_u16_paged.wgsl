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
var phi_3779_: type_29;
var phi_4480_: type_30;
var phi_5121_: f32;
var phi_5510_: type_5;
var phi_7068_: type_31;
var phi_7821_: vec3<f32>;
var phi_8051_: type_25;
var phi_8369_: vec3<f32>;
var phi_8678_: f32;
var phi_8679_: f32;
var phi_8680_: f32;
var phi_8681_: bool;
var phi_8741_: array<f32, 18>;
var phi_583_: u32;
var phi_586_: bool;
var phi_588_: array<f32, 18>;
var phi_8824_: bool;
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
phi_8824_ = true;
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
let _e921 = (_e919 >> bitcast<u32>(1i));
let _e924 = bitcast<u32>(((_e919 & 1i) * 16i));
let _e926 = select(_e876, _e921, (_e921 < _e876));
let _e931 = global_1.member[bitcast<u32>(select(0i, _e926, (_e926 > 0i)))];
let _e935 = (_e921 + 1i);
let _e937 = select(_e876, _e935, (_e935 < _e876));
let _e942 = global_1.member[bitcast<u32>(select(0i, _e937, (_e937 > 0i)))];
let _e949 = ((_e931 >> bitcast<u32>((_e924 & 31u))) | ((_e942 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e924) & 31u))));
let _e952 = local_6.member[2u];
let _e953 = (_e915 + _e952);
let _e955 = (_e953 >> bitcast<u32>(1i));
let _e958 = bitcast<u32>(((_e953 & 1i) * 16i));
let _e960 = select(_e876, _e955, (_e955 < _e876));
let _e965 = global_1.member[bitcast<u32>(select(0i, _e960, (_e960 > 0i)))];
let _e969 = (_e955 + 1i);
let _e971 = select(_e876, _e969, (_e969 < _e876));
let _e976 = global_1.member[bitcast<u32>(select(0i, _e971, (_e971 > 0i)))];
let _e983 = ((_e965 >> bitcast<u32>((_e958 & 31u))) | ((_e976 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e958) & 31u))));
let _e986 = local_6.member_1[0u];
let _e992 = f32(bitcast<i32>(((_e949 >> bitcast<u32>((_e986 & 31u))) & 65535u)));
let _e995 = local_6.member_1[1u];
let _e1001 = f32(bitcast<i32>(((_e949 >> bitcast<u32>((_e995 & 31u))) & 65535u)));
let _e1004 = local_6.member_1[4u];
let _e1010 = f32(bitcast<i32>(((_e983 >> bitcast<u32>((_e1004 & 31u))) & 65535u)));
let _e1013 = local_6.member_1[5u];
let _e1020 = local_7[0u];
let _e1023 = (_e992 + ((_e1001 - _e992) * _e1020));
let _e1024 = local_7[0u];
let _e1027 = (_e1001 + ((_e1010 - _e1001) * _e1024));
let _e1028 = local_7[0u];
let _e1031 = (_e1010 + ((f32(bitcast<i32>(((_e983 >> bitcast<u32>((_e1013 & 31u))) & 65535u))) - _e1010) * _e1028));
let _e1032 = (_e900 + _e897);
let _e1033 = local_6.member[0u];
let _e1034 = (_e1032 + _e1033);
let _e1036 = (_e1034 >> bitcast<u32>(1i));
let _e1039 = bitcast<u32>(((_e1034 & 1i) * 16i));
let _e1041 = select(_e876, _e1036, (_e1036 < _e876));
let _e1046 = global_1.member[bitcast<u32>(select(0i, _e1041, (_e1041 > 0i)))];
let _e1050 = (_e1036 + 1i);
let _e1052 = select(_e876, _e1050, (_e1050 < _e876));
let _e1057 = global_1.member[bitcast<u32>(select(0i, _e1052, (_e1052 > 0i)))];
let _e1064 = ((_e1046 >> bitcast<u32>((_e1039 & 31u))) | ((_e1057 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1039) & 31u))));
let _e1065 = local_6.member[2u];
let _e1066 = (_e1032 + _e1065);
let _e1068 = (_e1066 >> bitcast<u32>(1i));
let _e1071 = bitcast<u32>(((_e1066 & 1i) * 16i));
let _e1073 = select(_e876, _e1068, (_e1068 < _e876));
let _e1078 = global_1.member[bitcast<u32>(select(0i, _e1073, (_e1073 > 0i)))];
let _e1082 = (_e1068 + 1i);
let _e1084 = select(_e876, _e1082, (_e1082 < _e876));
let _e1089 = global_1.member[bitcast<u32>(select(0i, _e1084, (_e1084 > 0i)))];
let _e1096 = ((_e1078 >> bitcast<u32>((_e1071 & 31u))) | ((_e1089 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1071) & 31u))));
let _e1097 = local_6.member_1[0u];
let _e1103 = f32(bitcast<i32>(((_e1064 >> bitcast<u32>((_e1097 & 31u))) & 65535u)));
let _e1104 = local_6.member_1[1u];
let _e1110 = f32(bitcast<i32>(((_e1064 >> bitcast<u32>((_e1104 & 31u))) & 65535u)));
let _e1111 = local_6.member_1[4u];
let _e1117 = f32(bitcast<i32>(((_e1096 >> bitcast<u32>((_e1111 & 31u))) & 65535u)));
let _e1118 = local_6.member_1[5u];
let _e1125 = local_7[0u];
let _e1129 = local_7[0u];
let _e1132 = (_e1110 + ((_e1117 - _e1110) * _e1129));
let _e1133 = local_7[0u];
let _e1137 = (_e902 + _e895);
let _e1138 = local_6.member[0u];
let _e1139 = (_e1137 + _e1138);
let _e1141 = (_e1139 >> bitcast<u32>(1i));
let _e1144 = bitcast<u32>(((_e1139 & 1i) * 16i));
let _e1146 = select(_e876, _e1141, (_e1141 < _e876));
let _e1151 = global_1.member[bitcast<u32>(select(0i, _e1146, (_e1146 > 0i)))];
let _e1155 = (_e1141 + 1i);
let _e1157 = select(_e876, _e1155, (_e1155 < _e876));
let _e1162 = global_1.member[bitcast<u32>(select(0i, _e1157, (_e1157 > 0i)))];
let _e1169 = ((_e1151 >> bitcast<u32>((_e1144 & 31u))) | ((_e1162 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1144) & 31u))));
let _e1170 = local_6.member[2u];
let _e1171 = (_e1137 + _e1170);
let _e1173 = (_e1171 >> bitcast<u32>(1i));
let _e1176 = bitcast<u32>(((_e1171 & 1i) * 16i));
let _e1178 = select(_e876, _e1173, (_e1173 < _e876));
let _e1183 = global_1.member[bitcast<u32>(select(0i, _e1178, (_e1178 > 0i)))];
let _e1187 = (_e1173 + 1i);
let _e1189 = select(_e876, _e1187, (_e1187 < _e876));
let _e1194 = global_1.member[bitcast<u32>(select(0i, _e1189, (_e1189 > 0i)))];
let _e1201 = ((_e1183 >> bitcast<u32>((_e1176 & 31u))) | ((_e1194 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1176) & 31u))));
let _e1202 = local_6.member_1[0u];
let _e1208 = f32(bitcast<i32>(((_e1169 >> bitcast<u32>((_e1202 & 31u))) & 65535u)));
let _e1209 = local_6.member_1[1u];
let _e1215 = f32(bitcast<i32>(((_e1169 >> bitcast<u32>((_e1209 & 31u))) & 65535u)));
let _e1216 = local_6.member_1[4u];
let _e1222 = f32(bitcast<i32>(((_e1201 >> bitcast<u32>((_e1216 & 31u))) & 65535u)));
let _e1223 = local_6.member_1[5u];
let _e1230 = local_7[0u];
let _e1233 = (_e1208 + ((_e1215 - _e1208) * _e1230));
let _e1234 = local_7[0u];
let _e1237 = (_e1215 + ((_e1222 - _e1215) * _e1234));
let _e1238 = local_7[0u];
let _e1241 = (_e1222 + ((f32(bitcast<i32>(((_e1201 >> bitcast<u32>((_e1223 & 31u))) & 65535u))) - _e1222) * _e1238));
let _e1242 = (_e902 + _e897);
let _e1243 = local_6.member[0u];
let _e1244 = (_e1242 + _e1243);
let _e1246 = (_e1244 >> bitcast<u32>(1i));
let _e1249 = bitcast<u32>(((_e1244 & 1i) * 16i));
let _e1251 = select(_e876, _e1246, (_e1246 < _e876));
let _e1256 = global_1.member[bitcast<u32>(select(0i, _e1251, (_e1251 > 0i)))];
let _e1260 = (_e1246 + 1i);
let _e1262 = select(_e876, _e1260, (_e1260 < _e876));
let _e1267 = global_1.member[bitcast<u32>(select(0i, _e1262, (_e1262 > 0i)))];
let _e1274 = ((_e1256 >> bitcast<u32>((_e1249 & 31u))) | ((_e1267 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1249) & 31u))));
let _e1275 = local_6.member[2u];
let _e1276 = (_e1242 + _e1275);
let _e1278 = (_e1276 >> bitcast<u32>(1i));
let _e1281 = bitcast<u32>(((_e1276 & 1i) * 16i));
let _e1283 = select(_e876, _e1278, (_e1278 < _e876));
let _e1288 = global_1.member[bitcast<u32>(select(0i, _e1283, (_e1283 > 0i)))];
let _e1292 = (_e1278 + 1i);
let _e1294 = select(_e876, _e1292, (_e1292 < _e876));
let _e1299 = global_1.member[bitcast<u32>(select(0i, _e1294, (_e1294 > 0i)))];
let _e1306 = ((_e1288 >> bitcast<u32>((_e1281 & 31u))) | ((_e1299 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1281) & 31u))));
let _e1307 = local_6.member_1[0u];
let _e1313 = f32(bitcast<i32>(((_e1274 >> bitcast<u32>((_e1307 & 31u))) & 65535u)));
let _e1314 = local_6.member_1[1u];
let _e1320 = f32(bitcast<i32>(((_e1274 >> bitcast<u32>((_e1314 & 31u))) & 65535u)));
let _e1321 = local_6.member_1[4u];
let _e1327 = f32(bitcast<i32>(((_e1306 >> bitcast<u32>((_e1321 & 31u))) & 65535u)));
let _e1328 = local_6.member_1[5u];
let _e1335 = local_7[0u];
let _e1339 = local_7[0u];
let _e1342 = (_e1320 + ((_e1327 - _e1320) * _e1339));
let _e1343 = local_7[0u];
let _e1350 = local_6.member[1u];
let _e1351 = ((_e900 + _e889) + _e1350);
let _e1353 = (_e1351 >> bitcast<u32>(1i));
let _e1356 = bitcast<u32>(((_e1351 & 1i) * 16i));
let _e1358 = select(_e876, _e1353, (_e1353 < _e876));
let _e1363 = global_1.member[bitcast<u32>(select(0i, _e1358, (_e1358 > 0i)))];
let _e1367 = (_e1353 + 1i);
let _e1369 = select(_e876, _e1367, (_e1367 < _e876));
let _e1374 = global_1.member[bitcast<u32>(select(0i, _e1369, (_e1369 > 0i)))];
let _e1381 = ((_e1363 >> bitcast<u32>((_e1356 & 31u))) | ((_e1374 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1356) & 31u))));
let _e1384 = local_6.member_1[2u];
let _e1390 = f32(bitcast<i32>(((_e1381 >> bitcast<u32>((_e1384 & 31u))) & 65535u)));
let _e1393 = local_6.member_1[3u];
let _e1400 = local_7[0u];
let _e1403 = (_e1390 + ((f32(bitcast<i32>(((_e1381 >> bitcast<u32>((_e1393 & 31u))) & 65535u))) - _e1390) * _e1400));
let _e1405 = local_6.member[1u];
let _e1406 = ((_e900 + _e899) + _e1405);
let _e1408 = (_e1406 >> bitcast<u32>(1i));
let _e1411 = bitcast<u32>(((_e1406 & 1i) * 16i));
let _e1413 = select(_e876, _e1408, (_e1408 < _e876));
let _e1418 = global_1.member[bitcast<u32>(select(0i, _e1413, (_e1413 > 0i)))];
let _e1422 = (_e1408 + 1i);
let _e1424 = select(_e876, _e1422, (_e1422 < _e876));
let _e1429 = global_1.member[bitcast<u32>(select(0i, _e1424, (_e1424 > 0i)))];
let _e1436 = ((_e1418 >> bitcast<u32>((_e1411 & 31u))) | ((_e1429 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1411) & 31u))));
let _e1437 = local_6.member_1[2u];
let _e1443 = f32(bitcast<i32>(((_e1436 >> bitcast<u32>((_e1437 & 31u))) & 65535u)));
let _e1444 = local_6.member_1[3u];
let _e1451 = local_7[0u];
let _e1456 = local_6.member[1u];
let _e1457 = ((_e902 + _e889) + _e1456);
let _e1459 = (_e1457 >> bitcast<u32>(1i));
let _e1462 = bitcast<u32>(((_e1457 & 1i) * 16i));
let _e1464 = select(_e876, _e1459, (_e1459 < _e876));
let _e1469 = global_1.member[bitcast<u32>(select(0i, _e1464, (_e1464 > 0i)))];
let _e1473 = (_e1459 + 1i);
let _e1475 = select(_e876, _e1473, (_e1473 < _e876));
let _e1480 = global_1.member[bitcast<u32>(select(0i, _e1475, (_e1475 > 0i)))];
let _e1487 = ((_e1469 >> bitcast<u32>((_e1462 & 31u))) | ((_e1480 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1462) & 31u))));
let _e1488 = local_6.member_1[2u];
let _e1494 = f32(bitcast<i32>(((_e1487 >> bitcast<u32>((_e1488 & 31u))) & 65535u)));
let _e1495 = local_6.member_1[3u];
let _e1502 = local_7[0u];
let _e1505 = (_e1494 + ((f32(bitcast<i32>(((_e1487 >> bitcast<u32>((_e1495 & 31u))) & 65535u))) - _e1494) * _e1502));
let _e1507 = local_6.member[1u];
let _e1508 = ((_e902 + _e899) + _e1507);
let _e1510 = (_e1508 >> bitcast<u32>(1i));
let _e1513 = bitcast<u32>(((_e1508 & 1i) * 16i));
let _e1515 = select(_e876, _e1510, (_e1510 < _e876));
let _e1520 = global_1.member[bitcast<u32>(select(0i, _e1515, (_e1515 > 0i)))];
let _e1524 = (_e1510 + 1i);
let _e1526 = select(_e876, _e1524, (_e1524 < _e876));
let _e1531 = global_1.member[bitcast<u32>(select(0i, _e1526, (_e1526 > 0i)))];
let _e1538 = ((_e1520 >> bitcast<u32>((_e1513 & 31u))) | ((_e1531 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1513) & 31u))));
let _e1539 = local_6.member_1[2u];
let _e1545 = f32(bitcast<i32>(((_e1538 >> bitcast<u32>((_e1539 & 31u))) & 65535u)));
let _e1546 = local_6.member_1[3u];
let _e1553 = local_7[0u];
let _e1558 = local_6.member[1u];
let _e1559 = ((_e891 + _e895) + _e1558);
let _e1561 = (_e1559 >> bitcast<u32>(1i));
let _e1564 = bitcast<u32>(((_e1559 & 1i) * 16i));
let _e1566 = select(_e876, _e1561, (_e1561 < _e876));
let _e1571 = global_1.member[bitcast<u32>(select(0i, _e1566, (_e1566 > 0i)))];
let _e1575 = (_e1561 + 1i);
let _e1577 = select(_e876, _e1575, (_e1575 < _e876));
let _e1582 = global_1.member[bitcast<u32>(select(0i, _e1577, (_e1577 > 0i)))];
let _e1589 = ((_e1571 >> bitcast<u32>((_e1564 & 31u))) | ((_e1582 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1564) & 31u))));
let _e1590 = local_6.member_1[2u];
let _e1596 = f32(bitcast<i32>(((_e1589 >> bitcast<u32>((_e1590 & 31u))) & 65535u)));
let _e1597 = local_6.member_1[3u];
let _e1604 = local_7[0u];
let _e1607 = (_e1596 + ((f32(bitcast<i32>(((_e1589 >> bitcast<u32>((_e1597 & 31u))) & 65535u))) - _e1596) * _e1604));
let _e1609 = local_6.member[1u];
let _e1610 = ((_e904 + _e895) + _e1609);
let _e1612 = (_e1610 >> bitcast<u32>(1i));
let _e1615 = bitcast<u32>(((_e1610 & 1i) * 16i));
let _e1617 = select(_e876, _e1612, (_e1612 < _e876));
let _e1622 = global_1.member[bitcast<u32>(select(0i, _e1617, (_e1617 > 0i)))];
let _e1626 = (_e1612 + 1i);
let _e1628 = select(_e876, _e1626, (_e1626 < _e876));
let _e1633 = global_1.member[bitcast<u32>(select(0i, _e1628, (_e1628 > 0i)))];
let _e1640 = ((_e1622 >> bitcast<u32>((_e1615 & 31u))) | ((_e1633 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1615) & 31u))));
let _e1641 = local_6.member_1[2u];
let _e1647 = f32(bitcast<i32>(((_e1640 >> bitcast<u32>((_e1641 & 31u))) & 65535u)));
let _e1648 = local_6.member_1[3u];
let _e1655 = local_7[0u];
let _e1658 = (_e1647 + ((f32(bitcast<i32>(((_e1640 >> bitcast<u32>((_e1648 & 31u))) & 65535u))) - _e1647) * _e1655));
let _e1660 = local_6.member[1u];
let _e1661 = ((_e891 + _e897) + _e1660);
let _e1663 = (_e1661 >> bitcast<u32>(1i));
let _e1666 = bitcast<u32>(((_e1661 & 1i) * 16i));
let _e1668 = select(_e876, _e1663, (_e1663 < _e876));
let _e1673 = global_1.member[bitcast<u32>(select(0i, _e1668, (_e1668 > 0i)))];
let _e1677 = (_e1663 + 1i);
let _e1679 = select(_e876, _e1677, (_e1677 < _e876));
let _e1684 = global_1.member[bitcast<u32>(select(0i, _e1679, (_e1679 > 0i)))];
let _e1691 = ((_e1673 >> bitcast<u32>((_e1666 & 31u))) | ((_e1684 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1666) & 31u))));
let _e1692 = local_6.member_1[2u];
let _e1698 = f32(bitcast<i32>(((_e1691 >> bitcast<u32>((_e1692 & 31u))) & 65535u)));
let _e1699 = local_6.member_1[3u];
let _e1706 = local_7[0u];
let _e1711 = local_6.member[1u];
let _e1712 = ((_e904 + _e897) + _e1711);
let _e1714 = (_e1712 >> bitcast<u32>(1i));
let _e1717 = bitcast<u32>(((_e1712 & 1i) * 16i));
let _e1719 = select(_e876, _e1714, (_e1714 < _e876));
let _e1724 = global_1.member[bitcast<u32>(select(0i, _e1719, (_e1719 > 0i)))];
let _e1728 = (_e1714 + 1i);
let _e1730 = select(_e876, _e1728, (_e1728 < _e876));
let _e1735 = global_1.member[bitcast<u32>(select(0i, _e1730, (_e1730 > 0i)))];
let _e1742 = ((_e1724 >> bitcast<u32>((_e1717 & 31u))) | ((_e1735 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1717) & 31u))));
let _e1743 = local_6.member_1[2u];
let _e1749 = f32(bitcast<i32>(((_e1742 >> bitcast<u32>((_e1743 & 31u))) & 65535u)));
let _e1750 = local_6.member_1[3u];
let _e1757 = local_7[0u];
let _e1762 = local_7[1u];
let _e1765 = (_e1027 + ((_e1132 - _e1027) * _e1762));
let _e1766 = local_7[1u];
let _e1769 = (_e1237 + ((_e1342 - _e1237) * _e1766));
let _e1770 = local_7[1u];
let _e1773 = (_e1023 + (((_e1103 + ((_e1110 - _e1103) * _e1125)) - _e1023) * _e1770));
let _e1774 = local_7[1u];
let _e1779 = local_7[2u];
let _e1783 = local_7[1u];
let _e1786 = (_e1031 + (((_e1117 + ((f32(bitcast<i32>(((_e1096 >> bitcast<u32>((_e1118 & 31u))) & 65535u))) - _e1117) * _e1133)) - _e1031) * _e1783));
let _e1787 = local_7[1u];
let _e1791 = local_7[2u];
let _e1795 = local_7[1u];
let _e1798 = (_e1403 + ((_e1027 - _e1403) * _e1795));
let _e1799 = local_7[1u];
let _e1803 = local_7[2u];
let _e1807 = local_7[1u];
let _e1810 = (_e1132 + (((_e1443 + ((f32(bitcast<i32>(((_e1436 >> bitcast<u32>((_e1444 & 31u))) & 65535u))) - _e1443) * _e1451)) - _e1132) * _e1807));
let _e1811 = local_7[1u];
let _e1815 = local_7[2u];
let _e1819 = local_7[1u];
let _e1822 = (_e1607 + (((_e1698 + ((f32(bitcast<i32>(((_e1691 >> bitcast<u32>((_e1699 & 31u))) & 65535u))) - _e1698) * _e1706)) - _e1607) * _e1819));
let _e1823 = local_7[2u];
let _e1827 = local_7[1u];
let _e1831 = local_7[2u];
let _e1835 = local_7[2u];
let _e1843 = global_5.member[_e352].member_6.member_5;
let _e1849 = global_5.member[_e352].member_6.member_6;
let _e1850 = (((_e1765 + ((_e1769 - _e1765) * _e1835)) * _e1843) + _e1849);
let _e1852 = select(0f, _e1850, (_e1850 > 0f));
let _e1854 = select(1f, _e1852, (_e1852 < 1f));
let _e1856 = (((_e1773 + (((_e1233 + (((_e1313 + ((_e1320 - _e1313) * _e1335)) - _e1233) * _e1774)) - _e1773) * _e1779)) * _e1843) + _e1849);
let _e1858 = select(0f, _e1856, (_e1856 > 0f));
let _e1860 = select(1f, _e1858, (_e1858 < 1f));
let _e1862 = (((_e1786 + (((_e1241 + (((_e1327 + ((f32(bitcast<i32>(((_e1306 >> bitcast<u32>((_e1328 & 31u))) & 65535u))) - _e1327) * _e1343)) - _e1241) * _e1787)) - _e1786) * _e1791)) * _e1843) + _e1849);
let _e1864 = select(0f, _e1862, (_e1862 > 0f));
let _e1866 = select(1f, _e1864, (_e1864 < 1f));
let _e1868 = (((_e1798 + (((_e1505 + ((_e1237 - _e1505) * _e1799)) - _e1798) * _e1803)) * _e1843) + _e1849);
let _e1870 = select(0f, _e1868, (_e1868 > 0f));
let _e1872 = select(1f, _e1870, (_e1870 < 1f));
let _e1874 = (((_e1810 + (((_e1342 + (((_e1545 + ((f32(bitcast<i32>(((_e1538 >> bitcast<u32>((_e1546 & 31u))) & 65535u))) - _e1545) * _e1553)) - _e1342) * _e1811)) - _e1810) * _e1815)) * _e1843) + _e1849);
let _e1876 = select(0f, _e1874, (_e1874 > 0f));
let _e1878 = select(1f, _e1876, (_e1876 < 1f));
let _e1880 = (((_e1822 + ((_e1765 - _e1822) * _e1823)) * _e1843) + _e1849);
let _e1882 = select(0f, _e1880, (_e1880 > 0f));
let _e1884 = select(1f, _e1882, (_e1882 < 1f));
let _e1886 = (((_e1769 + (((_e1658 + (((_e1749 + ((f32(bitcast<i32>(((_e1742 >> bitcast<u32>((_e1750 & 31u))) & 65535u))) - _e1749) * _e1757)) - _e1658) * _e1827)) - _e1769) * _e1831)) * _e1843) + _e1849);
let _e1888 = select(0f, _e1886, (_e1886 > 0f));
let _e1890 = select(1f, _e1888, (_e1888 < 1f));
let _e1891 = (_e1854 * 1024f);
let _e1892 = (1024f - 1f);
let _e1894 = select(0f, _e1891, (_e1891 > 0f));
let _e1896 = select(_e1892, _e1894, (_e1894 < _e1892));
let _e1903 = select(0i, select(select(i32(_e1896), i32(-2147483648), (_e1896 < -2147483600f)), 2147483647i, (_e1896 > 2147483500f)), (_e1896 == _e1896));
let _e1907 = (_e1903 - select(0i, 1i, (_e1896 < f32(_e1903))));
let _e1908 = (262147i + _e1907);
let _e1910 = (bitcast<i32>(_e123) - 1i);
let _e1912 = select(_e1910, _e1908, (_e1908 < _e1910));
let _e1918 = global_3.member[bitcast<u32>(select(0i, _e1912, (_e1912 > 0i)))];
let _e1928 = select(_e1910, 262146i, (262146i < _e1910));
let _e1934 = global_3.member[bitcast<u32>(select(0i, _e1928, (_e1928 > 0i)))];
let _e1935 = bitcast<f32>(_e1934);
let _e1936 = (f32((bitcast<i32>((_e1918 & 4095u)) - 2048i)) * _e1935);
let _e1938 = select(_e1910, 262144i, (262144i < _e1910));
let _e1944 = global_3.member[bitcast<u32>(select(0i, _e1938, (_e1938 > 0i)))];
let _e1945 = bitcast<f32>(_e1944);
let _e1947 = select(_e1910, 262145i, (262145i < _e1910));
let _e1953 = global_3.member[bitcast<u32>(select(0i, _e1947, (_e1947 > 0i)))];
let _e1954 = bitcast<f32>(_e1953);
let _e1960 = ((_e1945 + (f32(bitcast<i32>((_e1918 >> bitcast<u32>(12u)))) * _e1954)) + (_e1936 * (_e1891 - f32(_e1907))));
let _e1961 = (_e1936 * 1024f);
if _e789 {
let _e1968 = ((0.5f * (_e1866 - _e1860)) * _e1961);
let _e1969 = ((0.5f * (_e1878 - _e1872)) * _e1961);
let _e1970 = ((0.5f * (_e1890 - _e1884)) * _e1961);
phi_3779_ = type_29(_e1960, vec3<f32>(_e1968, _e1969, _e1970), vec3<f32>((_e1968 * _e1960), (_e1969 * _e1960), (_e1970 * _e1960)));
} else {
let _e1977 = (_e1860 * 1024f);
let _e1979 = select(0f, _e1977, (_e1977 > 0f));
let _e1981 = select(_e1892, _e1979, (_e1979 < _e1892));
let _e1988 = select(0i, select(select(i32(_e1981), i32(-2147483648), (_e1981 < -2147483600f)), 2147483647i, (_e1981 > 2147483500f)), (_e1981 == _e1981));
let _e1992 = (_e1988 - select(0i, 1i, (_e1981 < f32(_e1988))));
let _e1993 = (262147i + _e1992);
let _e1995 = select(_e1910, _e1993, (_e1993 < _e1910));
let _e2001 = global_3.member[bitcast<u32>(select(0i, _e1995, (_e1995 > 0i)))];
let _e2016 = ((_e1945 + (f32(bitcast<i32>((_e2001 >> bitcast<u32>(12u)))) * _e1954)) + ((f32((bitcast<i32>((_e2001 & 4095u)) - 2048i)) * _e1935) * (_e1977 - f32(_e1992))));
let _e2017 = (_e1866 * 1024f);
let _e2019 = select(0f, _e2017, (_e2017 > 0f));
let _e2021 = select(_e1892, _e2019, (_e2019 < _e1892));
let _e2028 = select(0i, select(select(i32(_e2021), i32(-2147483648), (_e2021 < -2147483600f)), 2147483647i, (_e2021 > 2147483500f)), (_e2021 == _e2021));
let _e2032 = (_e2028 - select(0i, 1i, (_e2021 < f32(_e2028))));
let _e2033 = (262147i + _e2032);
let _e2035 = select(_e1910, _e2033, (_e2033 < _e1910));
let _e2041 = global_3.member[bitcast<u32>(select(0i, _e2035, (_e2035 > 0i)))];
let _e2056 = ((_e1945 + (f32(bitcast<i32>((_e2041 >> bitcast<u32>(12u)))) * _e1954)) + ((f32((bitcast<i32>((_e2041 & 4095u)) - 2048i)) * _e1935) * (_e2017 - f32(_e2032))));
let _e2057 = (_e1872 * 1024f);
let _e2059 = select(0f, _e2057, (_e2057 > 0f));
let _e2061 = select(_e1892, _e2059, (_e2059 < _e1892));
let _e2068 = select(0i, select(select(i32(_e2061), i32(-2147483648), (_e2061 < -2147483600f)), 2147483647i, (_e2061 > 2147483500f)), (_e2061 == _e2061));
let _e2072 = (_e2068 - select(0i, 1i, (_e2061 < f32(_e2068))));
let _e2073 = (262147i + _e2072);
let _e2075 = select(_e1910, _e2073, (_e2073 < _e1910));
let _e2081 = global_3.member[bitcast<u32>(select(0i, _e2075, (_e2075 > 0i)))];
let _e2096 = ((_e1945 + (f32(bitcast<i32>((_e2081 >> bitcast<u32>(12u)))) * _e1954)) + ((f32((bitcast<i32>((_e2081 & 4095u)) - 2048i)) * _e1935) * (_e2057 - f32(_e2072))));
let _e2097 = (_e1878 * 1024f);
let _e2099 = select(0f, _e2097, (_e2097 > 0f));
let _e2101 = select(_e1892, _e2099, (_e2099 < _e1892));
let _e2108 = select(0i, select(select(i32(_e2101), i32(-2147483648), (_e2101 < -2147483600f)), 2147483647i, (_e2101 > 2147483500f)), (_e2101 == _e2101));
let _e2112 = (_e2108 - select(0i, 1i, (_e2101 < f32(_e2108))));
let _e2113 = (262147i + _e2112);
let _e2115 = select(_e1910, _e2113, (_e2113 < _e1910));
let _e2121 = global_3.member[bitcast<u32>(select(0i, _e2115, (_e2115 > 0i)))];
let _e2136 = ((_e1945 + (f32(bitcast<i32>((_e2121 >> bitcast<u32>(12u)))) * _e1954)) + ((f32((bitcast<i32>((_e2121 & 4095u)) - 2048i)) * _e1935) * (_e2097 - f32(_e2112))));
let _e2137 = (_e1884 * 1024f);
let _e2139 = select(0f, _e2137, (_e2137 > 0f));
let _e2141 = select(_e1892, _e2139, (_e2139 < _e1892));
let _e2148 = select(0i, select(select(i32(_e2141), i32(-2147483648), (_e2141 < -2147483600f)), 2147483647i, (_e2141 > 2147483500f)), (_e2141 == _e2141));
let _e2152 = (_e2148 - select(0i, 1i, (_e2141 < f32(_e2148))));
let _e2153 = (262147i + _e2152);
let _e2155 = select(_e1910, _e2153, (_e2153 < _e1910));
let _e2161 = global_3.member[bitcast<u32>(select(0i, _e2155, (_e2155 > 0i)))];
let _e2176 = ((_e1945 + (f32(bitcast<i32>((_e2161 >> bitcast<u32>(12u)))) * _e1954)) + ((f32((bitcast<i32>((_e2161 & 4095u)) - 2048i)) * _e1935) * (_e2137 - f32(_e2152))));
let _e2177 = (_e1890 * 1024f);
let _e2179 = select(0f, _e2177, (_e2177 > 0f));
let _e2181 = select(_e1892, _e2179, (_e2179 < _e1892));
let _e2188 = select(0i, select(select(i32(_e2181), i32(-2147483648), (_e2181 < -2147483600f)), 2147483647i, (_e2181 > 2147483500f)), (_e2181 == _e2181));
let _e2192 = (_e2188 - select(0i, 1i, (_e2181 < f32(_e2188))));
let _e2193 = (262147i + _e2192);
let _e2195 = select(_e1910, _e2193, (_e2193 < _e1910));
let _e2201 = global_3.member[bitcast<u32>(select(0i, _e2195, (_e2195 > 0i)))];
let _e2216 = ((_e1945 + (f32(bitcast<i32>((_e2201 >> bitcast<u32>(12u)))) * _e1954)) + ((f32((bitcast<i32>((_e2201 & 4095u)) - 2048i)) * _e1935) * (_e2177 - f32(_e2192))));
let _e2217 = (_e2056 - _e2016);
let _e2219 = (_e2136 - _e2096);
let _e2221 = (_e2216 - _e2176);
phi_3779_ = type_29(_e1960, vec3<f32>((0.5f * _e2217), (0.5f * _e2219), (0.5f * _e2221)), vec3<f32>((0.25f * (_e2217 * (_e2056 + _e2016))), (0.25f * (_e2219 * (_e2136 + _e2096))), (0.25f * (_e2221 * (_e2216 + _e2176)))));
}
let _e2236 = phi_3779_;
let _e2251 = select(0f, 1f, ((((((_e496 >= -0.5f) && (_e496 <= _e520)) && (_e502 >= -0.5f)) && (_e502 <= _e531)) && (_e508 >= -0.5f)) && (_e508 <= _e542)));
let _e2253 = (0.5f * (_e1866 - _e1860));
let _e2255 = (0.5f * (_e1878 - _e1872));
let _e2257 = (0.5f * (_e1890 - _e1884));
let _e2264 = global_5.member[_e352].member_6.member.member.member;
let _e2271 = global_5.member[_e352].member_6.member.member.member_1;
let _e2278 = global_5.member[_e352].member_6.member.member.member_2;
let _e2285 = global_5.member[_e352].member_6.member_1.member.member;
let _e2292 = global_5.member[_e352].member_6.member_1.member.member_1;
let _e2299 = global_5.member[_e352].member_6.member_1.member.member_2;
let _e2306 = global_5.member[_e352].member_6.member_2.member.member;
let _e2313 = global_5.member[_e352].member_6.member_2.member.member_1;
let _e2320 = global_5.member[_e352].member_6.member_2.member.member_2;
phi_4480_ = type_30(_e1854, vec3<f32>(((((_e2264 * _e2253) + (_e2285 * _e2255)) + (_e2306 * _e2257)) * _e2251), ((((_e2271 * _e2253) + (_e2292 * _e2255)) + (_e2313 * _e2257)) * _e2251), ((((_e2278 * _e2253) + (_e2299 * _e2255)) + (_e2320 * _e2257)) * _e2251)), _e2236.member, vec3<f32>(((((_e2264 * _e2236.member_2.x) + (_e2285 * _e2236.member_2.y)) + (_e2306 * _e2236.member_2.z)) * _e2251), ((((_e2271 * _e2236.member_2.x) + (_e2292 * _e2236.member_2.y)) + (_e2313 * _e2236.member_2.z)) * _e2251), ((((_e2278 * _e2236.member_2.x) + (_e2299 * _e2236.member_2.y)) + (_e2320 * _e2236.member_2.z)) * _e2251)), vec3<f32>(((((_e2264 * _e2236.member_1.x) + (_e2285 * _e2236.member_1.y)) + (_e2306 * _e2236.member_1.z)) * _e2251), ((((_e2271 * _e2236.member_1.x) + (_e2292 * _e2236.member_1.y)) + (_e2313 * _e2236.member_1.z)) * _e2251), ((((_e2278 * _e2236.member_1.x) + (_e2299 * _e2236.member_1.y)) + (_e2320 * _e2236.member_1.z)) * _e2251)));
} else {
let _e2386 = select(-1f, _e524, (_e524 > -1f));
let _e2388 = select(_e519, _e2386, (_e2386 < _e519));
let _e2395 = select(0i, select(select(i32(_e2388), i32(-2147483648), (_e2388 < -2147483600f)), 2147483647i, (_e2388 > 2147483500f)), (_e2388 == _e2388));
let _e2399 = (_e2395 - select(0i, 1i, (_e2388 < f32(_e2395))));
let _e2401 = select(-1f, _e535, (_e535 > -1f));
let _e2403 = select(_e530, _e2401, (_e2401 < _e530));
let _e2410 = select(0i, select(select(i32(_e2403), i32(-2147483648), (_e2403 < -2147483600f)), 2147483647i, (_e2403 > 2147483500f)), (_e2403 == _e2403));
let _e2414 = (_e2410 - select(0i, 1i, (_e2403 < f32(_e2410))));
let _e2416 = select(-1f, _e546, (_e546 > -1f));
let _e2418 = select(_e541, _e2416, (_e2416 < _e541));
let _e2425 = select(0i, select(select(i32(_e2418), i32(-2147483648), (_e2418 < -2147483600f)), 2147483647i, (_e2418 > 2147483500f)), (_e2418 == _e2418));
let _e2429 = (_e2425 - select(0i, 1i, (_e2418 < f32(_e2425))));
let _e2434 = global_5.member[_e352].member_6.member_7;
let _e2439 = global_5.member[_e352].member_6.member_8;
let _e2440 = (_e2399 + 1i);
let _e2441 = (_e2414 + 1i);
let _e2442 = (_e2429 + 1i);
let _e2448 = global_5.member[_e352].member_6.member_11.member;
let _e2455 = global_5.member[_e352].member_6.member_11.member_1;
let _e2466 = ((_e2440 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2448) * ((_e2441 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2455) * (_e2442 >> bitcast<u32>(4i))))));
let _e2468 = (bitcast<i32>(_e119) - 1i);
let _e2470 = select(_e2468, _e2466, (_e2466 < _e2468));
let _e2476 = global_1.member[bitcast<u32>(select(0i, _e2470, (_e2470 > 0i)))];
let _e2478 = (_e2440 & 15i);
let _e2481 = ((_e2441 & 15i) * _e2434);
let _e2483 = (bitcast<i32>(_e2476) + ((_e2442 & 15i) * _e2439));
let _e2487 = (_e2481 + _e2434);
let _e2489 = (_e2481 + (2i * _e2434));
let _e2490 = (_e2483 + _e2439);
let _e2492 = (_e2483 + (2i * _e2439));
local_4 = type_28(array<i32, 4>(_e2478, (_e2478 + 1i), (_e2478 + 2i), (_e2478 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_5 = vec3<f32>((_e524 - f32(_e2399)), (_e535 - f32(_e2414)), (_e546 - f32(_e2429)));
let _e2506 = local_4.member[1u];
let _e2507 = ((_e2490 + _e2487) + _e2506);
let _e2509 = (_e2507 >> bitcast<u32>(1i));
let _e2512 = bitcast<u32>(((_e2507 & 1i) * 16i));
let _e2514 = select(_e2468, _e2509, (_e2509 < _e2468));
let _e2519 = global_1.member[bitcast<u32>(select(0i, _e2514, (_e2514 > 0i)))];
let _e2523 = (_e2509 + 1i);
let _e2525 = select(_e2468, _e2523, (_e2523 < _e2468));
let _e2530 = global_1.member[bitcast<u32>(select(0i, _e2525, (_e2525 > 0i)))];
let _e2537 = ((_e2519 >> bitcast<u32>((_e2512 & 31u))) | ((_e2530 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2512) & 31u))));
let _e2540 = local_4.member_1[2u];
let _e2546 = f32(bitcast<i32>(((_e2537 >> bitcast<u32>((_e2540 & 31u))) & 65535u)));
let _e2549 = local_4.member_1[3u];
let _e2556 = local_5[0u];
let _e2559 = (_e2546 + ((f32(bitcast<i32>(((_e2537 >> bitcast<u32>((_e2549 & 31u))) & 65535u))) - _e2546) * _e2556));
let _e2561 = local_4.member[1u];
let _e2562 = ((_e2490 + _e2489) + _e2561);
let _e2564 = (_e2562 >> bitcast<u32>(1i));
let _e2567 = bitcast<u32>(((_e2562 & 1i) * 16i));
let _e2569 = select(_e2468, _e2564, (_e2564 < _e2468));
let _e2574 = global_1.member[bitcast<u32>(select(0i, _e2569, (_e2569 > 0i)))];
let _e2578 = (_e2564 + 1i);
let _e2580 = select(_e2468, _e2578, (_e2578 < _e2468));
let _e2585 = global_1.member[bitcast<u32>(select(0i, _e2580, (_e2580 > 0i)))];
let _e2592 = ((_e2574 >> bitcast<u32>((_e2567 & 31u))) | ((_e2585 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2567) & 31u))));
let _e2593 = local_4.member_1[2u];
let _e2599 = f32(bitcast<i32>(((_e2592 >> bitcast<u32>((_e2593 & 31u))) & 65535u)));
let _e2600 = local_4.member_1[3u];
let _e2607 = local_5[0u];
let _e2612 = local_5[1u];
let _e2615 = (_e2559 + (((_e2599 + ((f32(bitcast<i32>(((_e2592 >> bitcast<u32>((_e2600 & 31u))) & 65535u))) - _e2599) * _e2607)) - _e2559) * _e2612));
let _e2617 = local_4.member[1u];
let _e2618 = ((_e2492 + _e2487) + _e2617);
let _e2620 = (_e2618 >> bitcast<u32>(1i));
let _e2623 = bitcast<u32>(((_e2618 & 1i) * 16i));
let _e2625 = select(_e2468, _e2620, (_e2620 < _e2468));
let _e2630 = global_1.member[bitcast<u32>(select(0i, _e2625, (_e2625 > 0i)))];
let _e2634 = (_e2620 + 1i);
let _e2636 = select(_e2468, _e2634, (_e2634 < _e2468));
let _e2641 = global_1.member[bitcast<u32>(select(0i, _e2636, (_e2636 > 0i)))];
let _e2648 = ((_e2630 >> bitcast<u32>((_e2623 & 31u))) | ((_e2641 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2623) & 31u))));
let _e2649 = local_4.member_1[2u];
let _e2655 = f32(bitcast<i32>(((_e2648 >> bitcast<u32>((_e2649 & 31u))) & 65535u)));
let _e2656 = local_4.member_1[3u];
let _e2663 = local_5[0u];
let _e2666 = (_e2655 + ((f32(bitcast<i32>(((_e2648 >> bitcast<u32>((_e2656 & 31u))) & 65535u))) - _e2655) * _e2663));
let _e2668 = local_4.member[1u];
let _e2669 = ((_e2492 + _e2489) + _e2668);
let _e2671 = (_e2669 >> bitcast<u32>(1i));
let _e2674 = bitcast<u32>(((_e2669 & 1i) * 16i));
let _e2676 = select(_e2468, _e2671, (_e2671 < _e2468));
let _e2681 = global_1.member[bitcast<u32>(select(0i, _e2676, (_e2676 > 0i)))];
let _e2685 = (_e2671 + 1i);
let _e2687 = select(_e2468, _e2685, (_e2685 < _e2468));
let _e2692 = global_1.member[bitcast<u32>(select(0i, _e2687, (_e2687 > 0i)))];
let _e2699 = ((_e2681 >> bitcast<u32>((_e2674 & 31u))) | ((_e2692 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2674) & 31u))));
let _e2700 = local_4.member_1[2u];
let _e2706 = f32(bitcast<i32>(((_e2699 >> bitcast<u32>((_e2700 & 31u))) & 65535u)));
let _e2707 = local_4.member_1[3u];
let _e2714 = local_5[0u];
let _e2718 = local_5[1u];
let _e2723 = local_5[2u];
let _e2731 = global_5.member[_e352].member_6.member_5;
let _e2737 = global_5.member[_e352].member_6.member_6;
let _e2738 = (((_e2615 + (((_e2666 + (((_e2706 + ((f32(bitcast<i32>(((_e2699 >> bitcast<u32>((_e2707 & 31u))) & 65535u))) - _e2706) * _e2714)) - _e2666) * _e2718)) - _e2615) * _e2723)) * _e2731) + _e2737);
let _e2740 = select(0f, _e2738, (_e2738 > 0f));
phi_4480_ = type_30(select(1f, _e2740, (_e2740 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2745 = phi_4480_;
let _e2749 = select(-0.5f, _e458, (_e458 > -0.5f));
let _e2751 = select(_e520, _e2749, (_e2749 < _e520));
let _e2753 = select(-0.5f, _e474, (_e474 > -0.5f));
let _e2755 = select(_e531, _e2753, (_e2753 < _e531));
let _e2757 = select(-0.5f, _e490, (_e490 > -0.5f));
let _e2759 = select(_e542, _e2757, (_e2757 < _e542));
let _e2761 = select(-1f, _e2751, (_e2751 > -1f));
let _e2763 = select(_e519, _e2761, (_e2761 < _e519));
let _e2770 = select(0i, select(select(i32(_e2763), i32(-2147483648), (_e2763 < -2147483600f)), 2147483647i, (_e2763 > 2147483500f)), (_e2763 == _e2763));
let _e2774 = (_e2770 - select(0i, 1i, (_e2763 < f32(_e2770))));
let _e2776 = select(-1f, _e2755, (_e2755 > -1f));
let _e2778 = select(_e530, _e2776, (_e2776 < _e530));
let _e2785 = select(0i, select(select(i32(_e2778), i32(-2147483648), (_e2778 < -2147483600f)), 2147483647i, (_e2778 > 2147483500f)), (_e2778 == _e2778));
let _e2789 = (_e2785 - select(0i, 1i, (_e2778 < f32(_e2785))));
let _e2791 = select(-1f, _e2759, (_e2759 > -1f));
let _e2793 = select(_e541, _e2791, (_e2791 < _e541));
let _e2800 = select(0i, select(select(i32(_e2793), i32(-2147483648), (_e2793 < -2147483600f)), 2147483647i, (_e2793 > 2147483500f)), (_e2793 == _e2793));
let _e2804 = (_e2800 - select(0i, 1i, (_e2793 < f32(_e2800))));
let _e2809 = global_5.member[_e352].member_6.member_7;
let _e2814 = global_5.member[_e352].member_6.member_8;
let _e2815 = (_e2774 + 1i);
let _e2816 = (_e2789 + 1i);
let _e2817 = (_e2804 + 1i);
let _e2823 = global_5.member[_e352].member_6.member_11.member;
let _e2830 = global_5.member[_e352].member_6.member_11.member_1;
let _e2841 = ((_e2815 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2823) * ((_e2816 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2830) * (_e2817 >> bitcast<u32>(4i))))));
let _e2843 = (bitcast<i32>(_e119) - 1i);
let _e2845 = select(_e2843, _e2841, (_e2841 < _e2843));
let _e2851 = global_1.member[bitcast<u32>(select(0i, _e2845, (_e2845 > 0i)))];
let _e2853 = (_e2815 & 15i);
let _e2856 = ((_e2816 & 15i) * _e2809);
let _e2858 = (bitcast<i32>(_e2851) + ((_e2817 & 15i) * _e2814));
let _e2862 = (_e2856 + _e2809);
let _e2864 = (_e2856 + (2i * _e2809));
let _e2865 = (_e2858 + _e2814);
let _e2867 = (_e2858 + (2i * _e2814));
local_2 = type_28(array<i32, 4>(_e2853, (_e2853 + 1i), (_e2853 + 2i), (_e2853 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_3 = vec3<f32>((_e2751 - f32(_e2774)), (_e2755 - f32(_e2789)), (_e2759 - f32(_e2804)));
let _e2881 = local_2.member[1u];
let _e2882 = ((_e2865 + _e2862) + _e2881);
let _e2884 = (_e2882 >> bitcast<u32>(1i));
let _e2887 = bitcast<u32>(((_e2882 & 1i) * 16i));
let _e2889 = select(_e2843, _e2884, (_e2884 < _e2843));
let _e2894 = global_1.member[bitcast<u32>(select(0i, _e2889, (_e2889 > 0i)))];
let _e2898 = (_e2884 + 1i);
let _e2900 = select(_e2843, _e2898, (_e2898 < _e2843));
let _e2905 = global_1.member[bitcast<u32>(select(0i, _e2900, (_e2900 > 0i)))];
let _e2912 = ((_e2894 >> bitcast<u32>((_e2887 & 31u))) | ((_e2905 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2887) & 31u))));
let _e2915 = local_2.member_1[2u];
let _e2921 = f32(bitcast<i32>(((_e2912 >> bitcast<u32>((_e2915 & 31u))) & 65535u)));
let _e2924 = local_2.member_1[3u];
let _e2931 = local_3[0u];
let _e2934 = (_e2921 + ((f32(bitcast<i32>(((_e2912 >> bitcast<u32>((_e2924 & 31u))) & 65535u))) - _e2921) * _e2931));
let _e2936 = local_2.member[1u];
let _e2937 = ((_e2865 + _e2864) + _e2936);
let _e2939 = (_e2937 >> bitcast<u32>(1i));
let _e2942 = bitcast<u32>(((_e2937 & 1i) * 16i));
let _e2944 = select(_e2843, _e2939, (_e2939 < _e2843));
let _e2949 = global_1.member[bitcast<u32>(select(0i, _e2944, (_e2944 > 0i)))];
let _e2953 = (_e2939 + 1i);
let _e2955 = select(_e2843, _e2953, (_e2953 < _e2843));
let _e2960 = global_1.member[bitcast<u32>(select(0i, _e2955, (_e2955 > 0i)))];
let _e2967 = ((_e2949 >> bitcast<u32>((_e2942 & 31u))) | ((_e2960 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2942) & 31u))));
let _e2968 = local_2.member_1[2u];
let _e2974 = f32(bitcast<i32>(((_e2967 >> bitcast<u32>((_e2968 & 31u))) & 65535u)));
let _e2975 = local_2.member_1[3u];
let _e2982 = local_3[0u];
let _e2987 = local_3[1u];
let _e2990 = (_e2934 + (((_e2974 + ((f32(bitcast<i32>(((_e2967 >> bitcast<u32>((_e2975 & 31u))) & 65535u))) - _e2974) * _e2982)) - _e2934) * _e2987));
let _e2992 = local_2.member[1u];
let _e2993 = ((_e2867 + _e2862) + _e2992);
let _e2995 = (_e2993 >> bitcast<u32>(1i));
let _e2998 = bitcast<u32>(((_e2993 & 1i) * 16i));
let _e3000 = select(_e2843, _e2995, (_e2995 < _e2843));
let _e3005 = global_1.member[bitcast<u32>(select(0i, _e3000, (_e3000 > 0i)))];
let _e3009 = (_e2995 + 1i);
let _e3011 = select(_e2843, _e3009, (_e3009 < _e2843));
let _e3016 = global_1.member[bitcast<u32>(select(0i, _e3011, (_e3011 > 0i)))];
let _e3023 = ((_e3005 >> bitcast<u32>((_e2998 & 31u))) | ((_e3016 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2998) & 31u))));
let _e3024 = local_2.member_1[2u];
let _e3030 = f32(bitcast<i32>(((_e3023 >> bitcast<u32>((_e3024 & 31u))) & 65535u)));
let _e3031 = local_2.member_1[3u];
let _e3038 = local_3[0u];
let _e3041 = (_e3030 + ((f32(bitcast<i32>(((_e3023 >> bitcast<u32>((_e3031 & 31u))) & 65535u))) - _e3030) * _e3038));
let _e3043 = local_2.member[1u];
let _e3044 = ((_e2867 + _e2864) + _e3043);
let _e3046 = (_e3044 >> bitcast<u32>(1i));
let _e3049 = bitcast<u32>(((_e3044 & 1i) * 16i));
let _e3051 = select(_e2843, _e3046, (_e3046 < _e2843));
let _e3056 = global_1.member[bitcast<u32>(select(0i, _e3051, (_e3051 > 0i)))];
let _e3060 = (_e3046 + 1i);
let _e3062 = select(_e2843, _e3060, (_e3060 < _e2843));
let _e3067 = global_1.member[bitcast<u32>(select(0i, _e3062, (_e3062 > 0i)))];
let _e3074 = ((_e3056 >> bitcast<u32>((_e3049 & 31u))) | ((_e3067 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3049) & 31u))));
let _e3075 = local_2.member_1[2u];
let _e3081 = f32(bitcast<i32>(((_e3074 >> bitcast<u32>((_e3075 & 31u))) & 65535u)));
let _e3082 = local_2.member_1[3u];
let _e3089 = local_3[0u];
let _e3093 = local_3[1u];
let _e3098 = local_3[2u];
let _e3106 = global_5.member[_e352].member_6.member_5;
let _e3112 = global_5.member[_e352].member_6.member_6;
let _e3113 = (((_e2990 + (((_e3041 + (((_e3081 + ((f32(bitcast<i32>(((_e3074 >> bitcast<u32>((_e3082 & 31u))) & 65535u))) - _e3081) * _e3089)) - _e3041) * _e3093)) - _e2990) * _e3098)) * _e3106) + _e3112);
let _e3115 = select(0f, _e3113, (_e3113 > 0f));
let _e3117 = select(1f, _e3115, (_e3115 < 1f));
let _e3118 = select(_e356[5], _e3117, _e718);
if _e792 {
let _e3119 = (_e3117 * 1024f);
let _e3120 = (1024f - 1f);
let _e3122 = select(0f, _e3119, (_e3119 > 0f));
let _e3124 = select(_e3120, _e3122, (_e3122 < _e3120));
let _e3131 = select(0i, select(select(i32(_e3124), i32(-2147483648), (_e3124 < -2147483600f)), 2147483647i, (_e3124 > 2147483500f)), (_e3124 == _e3124));
let _e3135 = (_e3131 - select(0i, 1i, (_e3124 < f32(_e3131))));
let _e3136 = (262147i + _e3135);
let _e3138 = (bitcast<i32>(_e123) - 1i);
let _e3140 = select(_e3138, _e3136, (_e3136 < _e3138));
let _e3146 = global_3.member[bitcast<u32>(select(0i, _e3140, (_e3140 > 0i)))];
let _e3156 = select(_e3138, 262146i, (262146i < _e3138));
let _e3162 = global_3.member[bitcast<u32>(select(0i, _e3156, (_e3156 > 0i)))];
let _e3166 = select(_e3138, 262144i, (262144i < _e3138));
let _e3172 = global_3.member[bitcast<u32>(select(0i, _e3166, (_e3166 > 0i)))];
let _e3175 = select(_e3138, 262145i, (262145i < _e3138));
let _e3181 = global_3.member[bitcast<u32>(select(0i, _e3175, (_e3175 > 0i)))];
phi_5121_ = select(_e356[15], ((bitcast<f32>(_e3172) + (f32(bitcast<i32>((_e3146 >> bitcast<u32>(12u)))) * bitcast<f32>(_e3181))) + ((f32((bitcast<i32>((_e3146 & 4095u)) - 2048i)) * bitcast<f32>(_e3162)) * (_e3119 - f32(_e3135)))), _e718);
} else {
phi_5121_ = _e356[15];
}
let _e3191 = phi_5121_;
let _e3194 = select(1f, select(1f, _e787, (_e787 < 1f)), _e442);
if ((_e685 & 16u) == 0u) {
phi_5510_ = type_5(1f, 1f, 1f);
} else {
let _e3201 = global_5.member[_e352].member_14.member;
let _e3212 = ((((_e3201.member.member * _e377) + (_e3201.member.member_1 * _e380)) + (_e3201.member.member_2 * _e371)) + _e3201.member_1);
let _e3218 = ((((_e3201.member.member * _e382) + (_e3201.member.member_1 * _e384)) + (_e3201.member.member_2 * _e389)) + _e3201.member_1);
let _e3220 = select(_e3218, _e3212, (_e3212 < _e3218));
let _e3222 = select(_e3218, _e3212, (_e3212 > _e3218));
let _e3224 = (_e3222 - _e3220);
let _e3227 = (-(_e3220) / select(1e-30f, _e3224, (_e3224 > 1e-30f)));
let _e3229 = select(0f, _e3227, (_e3227 > 0f));
let _e3235 = select(select(select(1f, _e3229, (_e3229 < 1f)), 1f, (_e3222 <= 0f)), 0f, (_e3220 > 0f));
let _e3241 = global_5.member[_e352].member_14.member_1;
let _e3242 = (_e3241 != 0u);
let _e3253 = global_5.member[_e352].member_15.member;
let _e3264 = ((((_e3253.member.member * _e377) + (_e3253.member.member_1 * _e380)) + (_e3253.member.member_2 * _e371)) + _e3253.member_1);
let _e3270 = ((((_e3253.member.member * _e382) + (_e3253.member.member_1 * _e384)) + (_e3253.member.member_2 * _e389)) + _e3253.member_1);
let _e3272 = select(_e3270, _e3264, (_e3264 < _e3270));
let _e3274 = select(_e3270, _e3264, (_e3264 > _e3270));
let _e3276 = (_e3274 - _e3272);
let _e3279 = (-(_e3272) / select(1e-30f, _e3276, (_e3276 > 1e-30f)));
let _e3281 = select(0f, _e3279, (_e3279 > 0f));
let _e3287 = select(select(select(1f, _e3281, (_e3281 < 1f)), 1f, (_e3274 <= 0f)), 0f, (_e3272 > 0f));
let _e3293 = global_5.member[_e352].member_15.member_1;
let _e3294 = (_e3293 != 0u);
let _e3305 = global_5.member[_e352].member_16.member;
let _e3316 = ((((_e3305.member.member * _e377) + (_e3305.member.member_1 * _e380)) + (_e3305.member.member_2 * _e371)) + _e3305.member_1);
let _e3322 = ((((_e3305.member.member * _e382) + (_e3305.member.member_1 * _e384)) + (_e3305.member.member_2 * _e389)) + _e3305.member_1);
let _e3324 = select(_e3322, _e3316, (_e3316 < _e3322));
let _e3326 = select(_e3322, _e3316, (_e3316 > _e3322));
let _e3328 = (_e3326 - _e3324);
let _e3331 = (-(_e3324) / select(1e-30f, _e3328, (_e3328 > 1e-30f)));
let _e3333 = select(0f, _e3331, (_e3331 > 0f));
let _e3339 = select(select(select(1f, _e3333, (_e3333 < 1f)), 1f, (_e3326 <= 0f)), 0f, (_e3324 > 0f));
let _e3345 = global_5.member[_e352].member_16.member_1;
let _e3346 = (_e3345 != 0u);
let _e3357 = global_5.member[_e352].member_17.member;
let _e3368 = ((((_e3357.member.member * _e377) + (_e3357.member.member_1 * _e380)) + (_e3357.member.member_2 * _e371)) + _e3357.member_1);
let _e3374 = ((((_e3357.member.member * _e382) + (_e3357.member.member_1 * _e384)) + (_e3357.member.member_2 * _e389)) + _e3357.member_1);
let _e3376 = select(_e3374, _e3368, (_e3368 < _e3374));
let _e3378 = select(_e3374, _e3368, (_e3368 > _e3374));
let _e3380 = (_e3378 - _e3376);
let _e3383 = (-(_e3376) / select(1e-30f, _e3380, (_e3380 > 1e-30f)));
let _e3385 = select(0f, _e3383, (_e3383 > 0f));
let _e3391 = select(select(select(1f, _e3385, (_e3385 < 1f)), 1f, (_e3378 <= 0f)), 0f, (_e3376 > 0f));
let _e3397 = global_5.member[_e352].member_17.member_1;
let _e3398 = (_e3397 != 0u);
phi_5510_ = type_5(((((1f * _e3235) * _e3287) * _e3339) * _e3391), ((((1f * select(1f, _e3235, _e3242)) * select(1f, _e3287, _e3294)) * select(1f, _e3339, _e3346)) * select(1f, _e3391, _e3398)), ((((1f * select(1f, 0f, (_e3242 && (_e3218 > 0f)))) * select(1f, 0f, (_e3294 && (_e3270 > 0f)))) * select(1f, 0f, (_e3346 && (_e3322 > 0f)))) * select(1f, 0f, (_e3398 && (_e3374 > 0f)))));
}
let _e3407 = phi_5510_;
let _e3408 = (_e552 < 1e-12f);
let _e3410 = (1f / select(_e547, 1f, _e3408));
let _e3412 = ((-0.5f - _e458) * _e3410);
let _e3414 = ((_e520 - _e458) * _e3410);
let _e3420 = select(_e3414, _e3412, (_e3412 < _e3414));
let _e3422 = select(0f, _e3420, (_e3420 > 0f));
let _e3425 = select(select(1f, _e3422, (_e3422 < 1f)), select(2f, 0f, ((_e458 >= -0.5f) && (_e458 <= _e520))), _e3408);
let _e3427 = select(_e3414, _e3412, (_e3412 > _e3414));
let _e3429 = select(0f, _e3427, (_e3427 > 0f));
let _e3432 = select(select(1f, _e3429, (_e3429 < 1f)), 1f, _e3408);
let _e3433 = (_e555 < 1e-12f);
let _e3435 = (1f / select(_e548, 1f, _e3433));
let _e3437 = ((-0.5f - _e474) * _e3435);
let _e3439 = ((_e531 - _e474) * _e3435);
let _e3445 = select(_e3439, _e3437, (_e3437 < _e3439));
let _e3447 = select(0f, _e3445, (_e3445 > 0f));
let _e3450 = select(select(1f, _e3447, (_e3447 < 1f)), select(2f, 0f, ((_e474 >= -0.5f) && (_e474 <= _e531))), _e3433);
let _e3452 = select(_e3439, _e3437, (_e3437 > _e3439));
let _e3454 = select(0f, _e3452, (_e3452 > 0f));
let _e3457 = select(select(1f, _e3454, (_e3454 < 1f)), 1f, _e3433);
let _e3458 = (_e560 < 1e-12f);
let _e3460 = (1f / select(_e549, 1f, _e3458));
let _e3462 = ((-0.5f - _e490) * _e3460);
let _e3464 = ((_e542 - _e490) * _e3460);
let _e3470 = select(_e3464, _e3462, (_e3462 < _e3464));
let _e3472 = select(0f, _e3470, (_e3470 > 0f));
let _e3475 = select(select(1f, _e3472, (_e3472 < 1f)), select(2f, 0f, ((_e490 >= -0.5f) && (_e490 <= _e542))), _e3458);
let _e3477 = select(_e3464, _e3462, (_e3462 > _e3464));
let _e3479 = select(0f, _e3477, (_e3477 > 0f));
let _e3482 = select(select(1f, _e3479, (_e3479 < 1f)), 1f, _e3458);
let _e3484 = select(_e3457, _e3432, (_e3432 < _e3457));
let _e3488 = select(_e3450, _e3425, (_e3425 > _e3450));
let _e3491 = (select(_e3482, _e3484, (_e3484 < _e3482)) - select(_e3475, _e3488, (_e3488 > _e3475)));
let _e3494 = (_e382 - _e377);
let _e3495 = (_e384 - _e380);
let _e3496 = (_e389 - _e371);
let _e3501 = (((_e3494 * _e3494) + (_e3495 * _e3495)) + (_e3496 * _e3496));
let _e3511 = global_5.member[_e352].member_5.member_3;
let _e3512 = (((sqrt(select(0f, _e3501, (_e3501 > 0f))) * select(0f, _e3491, (_e3491 > 0f))) * _e3194) * _e3511);
let _e3513 = (_e729.member_2 >= 3u);
if _e3513 {
let _e3515 = (_e3118 * 255f);
let _e3516 = (_e2745.member * 255f);
let _e3517 = (255f - 1f);
let _e3519 = select(0f, _e3515, (_e3515 > 0f));
let _e3521 = select(_e3517, _e3519, (_e3519 < _e3517));
let _e3528 = select(0i, select(select(i32(_e3521), i32(-2147483648), (_e3521 < -2147483600f)), 2147483647i, (_e3521 > 2147483500f)), (_e3521 == _e3521));
let _e3532 = (_e3528 - select(0i, 1i, (_e3521 < f32(_e3528))));
let _e3534 = select(0f, _e3516, (_e3516 > 0f));
let _e3536 = select(_e3517, _e3534, (_e3534 < _e3517));
let _e3543 = select(0i, select(select(i32(_e3536), i32(-2147483648), (_e3536 < -2147483600f)), 2147483647i, (_e3536 > 2147483500f)), (_e3536 == _e3536));
let _e3547 = (_e3543 - select(0i, 1i, (_e3536 < f32(_e3543))));
let _e3550 = (((_e3532 * 256i) + _e3547) * 4i);
let _e3552 = (_e3515 - f32(_e3532));
let _e3554 = (_e3516 - f32(_e3547));
let _e3555 = (_e3550 + 2i);
let _e3557 = (bitcast<i32>(_e123) - 1i);
let _e3559 = select(_e3557, _e3555, (_e3555 < _e3557));
let _e3565 = global_3.member[bitcast<u32>(select(0i, _e3559, (_e3559 > 0i)))];
let _e3566 = (_e3550 + 6i);
let _e3568 = select(_e3557, _e3566, (_e3566 < _e3557));
let _e3574 = global_3.member[bitcast<u32>(select(0i, _e3568, (_e3568 > 0i)))];
let _e3575 = (_e3550 + 1026i);
let _e3577 = select(_e3557, _e3575, (_e3575 < _e3557));
let _e3583 = global_3.member[bitcast<u32>(select(0i, _e3577, (_e3577 > 0i)))];
let _e3584 = (_e3550 + 1030i);
let _e3586 = select(_e3557, _e3584, (_e3584 < _e3557));
let _e3592 = global_3.member[bitcast<u32>(select(0i, _e3586, (_e3586 > 0i)))];
let _e3597 = (bitcast<f32>(((_e3565 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3605 = (_e3597 + (((bitcast<f32>(((_e3574 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3597) * _e3554));
let _e3610 = (bitcast<f32>(((_e3583 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3634 = (bitcast<f32>((((_e3565 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3642 = (_e3634 + (((bitcast<f32>((((_e3574 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3634) * _e3554));
let _e3647 = (bitcast<f32>((((_e3583 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3659 = (_e3550 + 3i);
let _e3661 = select(_e3557, _e3659, (_e3659 < _e3557));
let _e3667 = global_3.member[bitcast<u32>(select(0i, _e3661, (_e3661 > 0i)))];
let _e3668 = (_e3550 + 7i);
let _e3670 = select(_e3557, _e3668, (_e3668 < _e3557));
let _e3676 = global_3.member[bitcast<u32>(select(0i, _e3670, (_e3670 > 0i)))];
let _e3677 = (_e3550 + 1027i);
let _e3679 = select(_e3557, _e3677, (_e3677 < _e3557));
let _e3685 = global_3.member[bitcast<u32>(select(0i, _e3679, (_e3679 > 0i)))];
let _e3686 = (_e3550 + 1031i);
let _e3688 = select(_e3557, _e3686, (_e3686 < _e3557));
let _e3694 = global_3.member[bitcast<u32>(select(0i, _e3688, (_e3688 > 0i)))];
let _e3699 = (bitcast<f32>(((_e3667 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3707 = (_e3699 + (((bitcast<f32>(((_e3676 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3699) * _e3554));
let _e3712 = (bitcast<f32>(((_e3685 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3736 = (bitcast<f32>((((_e3667 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3744 = (_e3736 + (((bitcast<f32>((((_e3676 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3736) * _e3554));
let _e3749 = (bitcast<f32>((((_e3685 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3760 = (_e3744 + (((_e3749 + (((bitcast<f32>((((_e3694 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3749) * _e3554)) - _e3744) * _e3552));
let _e3764 = -((_e3760 * (_e3512 * _e3407.member)));
let _e3766 = select(-87f, _e3764, (_e3764 > -87f));
let _e3768 = select(88f, _e3766, (_e3766 < 88f));
let _e3770 = ((_e3768 * 1.442695f) + 0.5f);
let _e3772 = select(-127f, _e3770, (_e3770 > -127f));
let _e3774 = select(128f, _e3772, (_e3772 < 128f));
let _e3781 = select(0i, select(select(i32(_e3774), i32(-2147483648), (_e3774 < -2147483600f)), 2147483647i, (_e3774 > 2147483500f)), (_e3774 == _e3774));
let _e3785 = (_e3781 - select(0i, 1i, (_e3774 < f32(_e3781))));
let _e3786 = f32(_e3785);
let _e3790 = ((_e3768 - (_e3786 * 0.6933594f)) - (_e3786 * -2.1219444e-4f));
let _e3810 = ((1f + (_e3790 * (1f + (_e3790 * (0.5f + (_e3790 * (0.16666667f + (_e3790 * (0.041666668f + (_e3790 * (0.008333334f + (_e3790 * (0.001388889f + (_e3790 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3785 + 127i)) << bitcast<u32>(23i))));
let _e3811 = (1f - _e3810);
let _e3814 = (_e3811 / select(1e-12f, _e3760, (_e3760 > 1e-12f)));
phi_7068_ = type_31(_e3810, _e3811, vec3<f32>(1f, 1f, 1f), vec3<f32>(((_e3605 + (((_e3610 + (((bitcast<f32>(((_e3592 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3610) * _e3554)) - _e3605) * _e3552)) * _e3814), ((_e3642 + (((_e3647 + (((bitcast<f32>((((_e3592 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3647) * _e3554)) - _e3642) * _e3552)) * _e3814), ((_e3707 + (((_e3712 + (((bitcast<f32>(((_e3694 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3712) * _e3554)) - _e3707) * _e3552)) * _e3814)));
} else {
let _e3821 = (_e3118 * 255f);
let _e3822 = (_e2745.member * 255f);
let _e3823 = (255f - 1f);
let _e3825 = select(0f, _e3821, (_e3821 > 0f));
let _e3827 = select(_e3823, _e3825, (_e3825 < _e3823));
let _e3834 = select(0i, select(select(i32(_e3827), i32(-2147483648), (_e3827 < -2147483600f)), 2147483647i, (_e3827 > 2147483500f)), (_e3827 == _e3827));
let _e3838 = (_e3834 - select(0i, 1i, (_e3827 < f32(_e3834))));
let _e3840 = select(0f, _e3822, (_e3822 > 0f));
let _e3842 = select(_e3823, _e3840, (_e3840 < _e3823));
let _e3849 = select(0i, select(select(i32(_e3842), i32(-2147483648), (_e3842 < -2147483600f)), 2147483647i, (_e3842 > 2147483500f)), (_e3842 == _e3842));
let _e3853 = (_e3849 - select(0i, 1i, (_e3842 < f32(_e3849))));
let _e3856 = (((_e3838 * 256i) + _e3853) * 4i);
let _e3858 = (_e3821 - f32(_e3838));
let _e3860 = (_e3822 - f32(_e3853));
let _e3862 = (bitcast<i32>(_e123) - 1i);
let _e3864 = select(_e3862, _e3856, (_e3856 < _e3862));
let _e3870 = global_3.member[bitcast<u32>(select(0i, _e3864, (_e3864 > 0i)))];
let _e3871 = (_e3856 + 4i);
let _e3873 = select(_e3862, _e3871, (_e3871 < _e3862));
let _e3879 = global_3.member[bitcast<u32>(select(0i, _e3873, (_e3873 > 0i)))];
let _e3880 = (_e3856 + 1024i);
let _e3882 = select(_e3862, _e3880, (_e3880 < _e3862));
let _e3888 = global_3.member[bitcast<u32>(select(0i, _e3882, (_e3882 > 0i)))];
let _e3889 = (_e3856 + 1028i);
let _e3891 = select(_e3862, _e3889, (_e3889 < _e3862));
let _e3897 = global_3.member[bitcast<u32>(select(0i, _e3891, (_e3891 > 0i)))];
let _e3902 = (bitcast<f32>(((_e3870 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3910 = (_e3902 + (((bitcast<f32>(((_e3879 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3902) * _e3860));
let _e3915 = (bitcast<f32>(((_e3888 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3926 = (_e3910 + (((_e3915 + (((bitcast<f32>(((_e3897 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3915) * _e3860)) - _e3910) * _e3858));
let _e3939 = (bitcast<f32>((((_e3870 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3947 = (_e3939 + (((bitcast<f32>((((_e3879 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3939) * _e3860));
let _e3952 = (bitcast<f32>((((_e3888 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3964 = (_e3856 + 1i);
let _e3966 = select(_e3862, _e3964, (_e3964 < _e3862));
let _e3972 = global_3.member[bitcast<u32>(select(0i, _e3966, (_e3966 > 0i)))];
let _e3973 = (_e3856 + 5i);
let _e3975 = select(_e3862, _e3973, (_e3973 < _e3862));
let _e3981 = global_3.member[bitcast<u32>(select(0i, _e3975, (_e3975 > 0i)))];
let _e3982 = (_e3856 + 1025i);
let _e3984 = select(_e3862, _e3982, (_e3982 < _e3862));
let _e3990 = global_3.member[bitcast<u32>(select(0i, _e3984, (_e3984 > 0i)))];
let _e3991 = (_e3856 + 1029i);
let _e3993 = select(_e3862, _e3991, (_e3991 < _e3862));
let _e3999 = global_3.member[bitcast<u32>(select(0i, _e3993, (_e3993 > 0i)))];
let _e4004 = (bitcast<f32>(((_e3972 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4012 = (_e4004 + (((bitcast<f32>(((_e3981 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4004) * _e3860));
let _e4017 = (bitcast<f32>(((_e3990 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4041 = (bitcast<f32>((((_e3972 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4049 = (_e4041 + (((bitcast<f32>((((_e3981 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4041) * _e3860));
let _e4054 = (bitcast<f32>((((_e3990 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4066 = (_e3856 + 2i);
let _e4068 = select(_e3862, _e4066, (_e4066 < _e3862));
let _e4074 = global_3.member[bitcast<u32>(select(0i, _e4068, (_e4068 > 0i)))];
let _e4075 = (_e3856 + 6i);
let _e4077 = select(_e3862, _e4075, (_e4075 < _e3862));
let _e4083 = global_3.member[bitcast<u32>(select(0i, _e4077, (_e4077 > 0i)))];
let _e4084 = (_e3856 + 1026i);
let _e4086 = select(_e3862, _e4084, (_e4084 < _e3862));
let _e4092 = global_3.member[bitcast<u32>(select(0i, _e4086, (_e4086 > 0i)))];
let _e4093 = (_e3856 + 1030i);
let _e4095 = select(_e3862, _e4093, (_e4093 < _e3862));
let _e4101 = global_3.member[bitcast<u32>(select(0i, _e4095, (_e4095 > 0i)))];
let _e4106 = (bitcast<f32>(((_e4074 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4114 = (_e4106 + (((bitcast<f32>(((_e4083 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4106) * _e3860));
let _e4119 = (bitcast<f32>(((_e4092 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4143 = (bitcast<f32>((((_e4074 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4151 = (_e4143 + (((bitcast<f32>((((_e4083 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4143) * _e3860));
let _e4156 = (bitcast<f32>((((_e4092 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4168 = (_e3856 + 3i);
let _e4170 = select(_e3862, _e4168, (_e4168 < _e3862));
let _e4176 = global_3.member[bitcast<u32>(select(0i, _e4170, (_e4170 > 0i)))];
let _e4177 = (_e3856 + 7i);
let _e4179 = select(_e3862, _e4177, (_e4177 < _e3862));
let _e4185 = global_3.member[bitcast<u32>(select(0i, _e4179, (_e4179 > 0i)))];
let _e4186 = (_e3856 + 1027i);
let _e4188 = select(_e3862, _e4186, (_e4186 < _e3862));
let _e4194 = global_3.member[bitcast<u32>(select(0i, _e4188, (_e4188 > 0i)))];
let _e4195 = (_e3856 + 1031i);
let _e4197 = select(_e3862, _e4195, (_e4195 < _e3862));
let _e4203 = global_3.member[bitcast<u32>(select(0i, _e4197, (_e4197 > 0i)))];
let _e4208 = (bitcast<f32>(((_e4176 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4216 = (_e4208 + (((bitcast<f32>(((_e4185 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4208) * _e3860));
let _e4221 = (bitcast<f32>(((_e4194 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4236 = (_e3512 * _e3407.member_1);
let _e4238 = -(((_e3947 + (((_e3952 + (((bitcast<f32>((((_e3897 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3952) * _e3860)) - _e3947) * _e3858)) * _e4236));
let _e4240 = select(-87f, _e4238, (_e4238 > -87f));
let _e4242 = select(88f, _e4240, (_e4240 < 88f));
let _e4244 = ((_e4242 * 1.442695f) + 0.5f);
let _e4246 = select(-127f, _e4244, (_e4244 > -127f));
let _e4248 = select(128f, _e4246, (_e4246 < 128f));
let _e4255 = select(0i, select(select(i32(_e4248), i32(-2147483648), (_e4248 < -2147483600f)), 2147483647i, (_e4248 > 2147483500f)), (_e4248 == _e4248));
let _e4259 = (_e4255 - select(0i, 1i, (_e4248 < f32(_e4255))));
let _e4260 = f32(_e4259);
let _e4264 = ((_e4242 - (_e4260 * 0.6933594f)) - (_e4260 * -2.1219444e-4f));
let _e4286 = -(((_e4012 + (((_e4017 + (((bitcast<f32>(((_e3999 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4017) * _e3860)) - _e4012) * _e3858)) * _e4236));
let _e4288 = select(-87f, _e4286, (_e4286 > -87f));
let _e4290 = select(88f, _e4288, (_e4288 < 88f));
let _e4292 = ((_e4290 * 1.442695f) + 0.5f);
let _e4294 = select(-127f, _e4292, (_e4292 > -127f));
let _e4296 = select(128f, _e4294, (_e4294 < 128f));
let _e4303 = select(0i, select(select(i32(_e4296), i32(-2147483648), (_e4296 < -2147483600f)), 2147483647i, (_e4296 > 2147483500f)), (_e4296 == _e4296));
let _e4307 = (_e4303 - select(0i, 1i, (_e4296 < f32(_e4303))));
let _e4308 = f32(_e4307);
let _e4312 = ((_e4290 - (_e4308 * 0.6933594f)) - (_e4308 * -2.1219444e-4f));
let _e4334 = -(((_e4049 + (((_e4054 + (((bitcast<f32>((((_e3999 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4054) * _e3860)) - _e4049) * _e3858)) * _e4236));
let _e4336 = select(-87f, _e4334, (_e4334 > -87f));
let _e4338 = select(88f, _e4336, (_e4336 < 88f));
let _e4340 = ((_e4338 * 1.442695f) + 0.5f);
let _e4342 = select(-127f, _e4340, (_e4340 > -127f));
let _e4344 = select(128f, _e4342, (_e4342 < 128f));
let _e4351 = select(0i, select(select(i32(_e4344), i32(-2147483648), (_e4344 < -2147483600f)), 2147483647i, (_e4344 > 2147483500f)), (_e4344 == _e4344));
let _e4355 = (_e4351 - select(0i, 1i, (_e4344 < f32(_e4351))));
let _e4356 = f32(_e4355);
let _e4360 = ((_e4338 - (_e4356 * 0.6933594f)) - (_e4356 * -2.1219444e-4f));
let _e4383 = -((_e3926 * (_e3512 * _e3407.member)));
let _e4385 = select(-87f, _e4383, (_e4383 > -87f));
let _e4387 = select(88f, _e4385, (_e4385 < 88f));
let _e4389 = ((_e4387 * 1.442695f) + 0.5f);
let _e4391 = select(-127f, _e4389, (_e4389 > -127f));
let _e4393 = select(128f, _e4391, (_e4391 < 128f));
let _e4400 = select(0i, select(select(i32(_e4393), i32(-2147483648), (_e4393 < -2147483600f)), 2147483647i, (_e4393 > 2147483500f)), (_e4393 == _e4393));
let _e4404 = (_e4400 - select(0i, 1i, (_e4393 < f32(_e4400))));
let _e4405 = f32(_e4404);
let _e4409 = ((_e4387 - (_e4405 * 0.6933594f)) - (_e4405 * -2.1219444e-4f));
let _e4429 = ((1f + (_e4409 * (1f + (_e4409 * (0.5f + (_e4409 * (0.16666667f + (_e4409 * (0.041666668f + (_e4409 * (0.008333334f + (_e4409 * (0.001388889f + (_e4409 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4404 + 127i)) << bitcast<u32>(23i))));
let _e4430 = (1f - _e4429);
let _e4433 = (_e4430 / select(1e-12f, _e3926, (_e3926 > 1e-12f)));
phi_7068_ = type_31(_e4429, _e4430, vec3<f32>(((1f + (_e4264 * (1f + (_e4264 * (0.5f + (_e4264 * (0.16666667f + (_e4264 * (0.041666668f + (_e4264 * (0.008333334f + (_e4264 * (0.001388889f + (_e4264 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4259 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e4312 * (1f + (_e4312 * (0.5f + (_e4312 * (0.16666667f + (_e4312 * (0.041666668f + (_e4312 * (0.008333334f + (_e4312 * (0.001388889f + (_e4312 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4307 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e4360 * (1f + (_e4360 * (0.5f + (_e4360 * (0.16666667f + (_e4360 * (0.041666668f + (_e4360 * (0.008333334f + (_e4360 * (0.001388889f + (_e4360 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4355 + 127i)) << bitcast<u32>(23i))))), vec3<f32>(((_e4114 + (((_e4119 + (((bitcast<f32>(((_e4101 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4119) * _e3860)) - _e4114) * _e3858)) * _e4433), ((_e4151 + (((_e4156 + (((bitcast<f32>((((_e4101 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4156) * _e3860)) - _e4151) * _e3858)) * _e4433), ((_e4216 + (((_e4221 + (((bitcast<f32>(((_e4203 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4221) * _e3860)) - _e4216) * _e3858)) * _e4433)));
}
let _e4440 = phi_7068_;
let _e4441 = select(0f, _e3194, _e442);
let _e4445 = (_e377 + (_e3494 * _e4441));
let _e4446 = (_e380 + (_e3495 * _e4441));
let _e4447 = (_e371 + (_e3496 * _e4441));
if (_e729.member_2 == 3u) {
let _e4453 = global_5.member[_e352].member_9.member_1;
let _e4462 = global_5.member[_e352].member_9.member;
phi_8051_ = type_25(vec3<f32>(_e4453.member, _e4453.member_1, _e4453.member_2), vec3<f32>(_e4462.member, _e4462.member_1, _e4462.member_2));
} else {
let _e4472 = global_5.member[_e352].member_8.member_8;
let _e4473 = (_e4447 - _e4472);
let _e4478 = global_5.member[_e352].member_8.member_2;
let _e4483 = global_5.member[_e352].member_8.member_6;
let _e4491 = global_5.member[_e352].member_8.member_5;
let _e4493 = (((_e4445 - (_e4478 + (_e4483 * _e4473))) * _e4491) - 0.5f);
let _e4498 = global_5.member[_e352].member_8.member_3;
let _e4503 = global_5.member[_e352].member_8.member_7;
let _e4508 = (((_e4446 - (_e4498 + (_e4503 * _e4473))) * _e4491) - 0.5f);
let _e4513 = global_5.member[_e352].member_8.member;
let _e4514 = bitcast<i32>(_e4513);
let _e4516 = (f32(_e4514) - 1f);
let _e4521 = global_5.member[_e352].member_8.member_1;
let _e4524 = (f32(bitcast<i32>(_e4521)) - 1f);
let _e4526 = select(0f, _e4493, (_e4493 > 0f));
let _e4528 = select(_e4516, _e4526, (_e4526 < _e4516));
let _e4535 = select(0i, select(select(i32(_e4528), i32(-2147483648), (_e4528 < -2147483600f)), 2147483647i, (_e4528 > 2147483500f)), (_e4528 == _e4528));
let _e4539 = (_e4535 - select(0i, 1i, (_e4528 < f32(_e4535))));
let _e4541 = select(0f, _e4508, (_e4508 > 0f));
let _e4543 = select(_e4524, _e4541, (_e4541 < _e4524));
let _e4550 = select(0i, select(select(i32(_e4543), i32(-2147483648), (_e4543 < -2147483600f)), 2147483647i, (_e4543 > 2147483500f)), (_e4543 == _e4543));
let _e4554 = (_e4550 - select(0i, 1i, (_e4543 < f32(_e4550))));
let _e4558 = (_e4493 - f32(_e4539));
let _e4560 = (_e4508 - f32(_e4554));
let _e4567 = ((((_e4493 >= 0f) && (_e4493 <= _e4516)) && (_e4508 >= 0f)) && (_e4508 <= _e4524));
let _e4571 = global_5.member[_e352].member_4;
let _e4572 = bitcast<i32>(_e4571);
let _e4574 = bitcast<i32>((_e4513 * _e4521));
let _e4576 = (_e4572 + (3i * _e4574));
local_1 = (_e4576 + ((_e4554 * _e4514) + _e4539));
let _e4578 = local_1;
let _e4580 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e4582 = select(_e4580, _e4578, (_e4578 < _e4580));
let _e4587 = global_6.member[bitcast<u32>(select(0i, _e4582, (_e4582 > 0i)))];
let _e4588 = bitcast<u32>(_e4587);
let _e4592 = f32((bitcast<i32>((_e4588 & 65535u)) - 32768i));
let _e4598 = f32((bitcast<i32>(((_e4588 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4603 = select(_e4598, -(_e4598), ((_e4588 >> bitcast<u32>(31i)) != 0u));
let _e4604 = local_1;
let _e4605 = (_e4604 + 1i);
let _e4607 = select(_e4580, _e4605, (_e4605 < _e4580));
let _e4612 = global_6.member[bitcast<u32>(select(0i, _e4607, (_e4607 > 0i)))];
let _e4613 = bitcast<u32>(_e4612);
let _e4623 = f32((bitcast<i32>(((_e4613 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4629 = local_1;
let _e4630 = (_e4629 + _e4514);
let _e4632 = select(_e4580, _e4630, (_e4630 < _e4580));
let _e4637 = global_6.member[bitcast<u32>(select(0i, _e4632, (_e4632 > 0i)))];
let _e4638 = bitcast<u32>(_e4637);
let _e4642 = f32((bitcast<i32>((_e4638 & 65535u)) - 32768i));
let _e4648 = f32((bitcast<i32>(((_e4638 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4653 = select(_e4648, -(_e4648), ((_e4638 >> bitcast<u32>(31i)) != 0u));
let _e4654 = (_e4514 + 1i);
let _e4655 = local_1;
let _e4656 = (_e4655 + _e4654);
let _e4658 = select(_e4580, _e4656, (_e4656 < _e4580));
let _e4663 = global_6.member[bitcast<u32>(select(0i, _e4658, (_e4658 > 0i)))];
let _e4664 = bitcast<u32>(_e4663);
let _e4674 = f32((bitcast<i32>(((_e4664 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4682 = (_e4592 + ((f32((bitcast<i32>((_e4613 & 65535u)) - 32768i)) - _e4592) * _e4558));
let _e4691 = (_e4603 + ((select(_e4623, -(_e4623), ((_e4613 >> bitcast<u32>(31i)) != 0u)) - _e4603) * _e4558));
let _e4704 = global_5.member[_e352].member_9.member;
let _e4707 = (1f / 16255f);
let _e4709 = (_e4704.member + (select(0f, (_e4682 + (((_e4642 + ((f32((bitcast<i32>((_e4664 & 65535u)) - 32768i)) - _e4642) * _e4558)) - _e4682) * _e4560)), _e4567) * _e4707));
let _e4711 = (_e4704.member_1 + (select(0f, (_e4691 + (((_e4653 + ((select(_e4674, -(_e4674), ((_e4664 >> bitcast<u32>(31i)) != 0u)) - _e4653) * _e4558)) - _e4691) * _e4560)), _e4567) * _e4707));
let _e4715 = (1f - ((_e4709 * _e4709) + (_e4711 * _e4711)));
let _e4717 = select(1e-4f, _e4715, (_e4715 > 1e-4f));
let _e4720 = sqrt(select(0f, _e4717, (_e4717 > 0f)));
let _e4724 = (1f / select(1e-6f, _e4720, (_e4720 > 1e-6f)));
let _e4725 = ((_e4447 - _e371) * _e4491);
let _e4732 = (_e4493 - (((_e4709 * _e4724) - _e4483) * _e4725));
let _e4733 = (_e4508 - (((_e4711 * _e4724) - _e4503) * _e4725));
let _e4735 = select(0f, _e4732, (_e4732 > 0f));
let _e4737 = select(_e4516, _e4735, (_e4735 < _e4516));
let _e4744 = select(0i, select(select(i32(_e4737), i32(-2147483648), (_e4737 < -2147483600f)), 2147483647i, (_e4737 > 2147483500f)), (_e4737 == _e4737));
let _e4748 = (_e4744 - select(0i, 1i, (_e4737 < f32(_e4744))));
let _e4750 = select(0f, _e4733, (_e4733 > 0f));
let _e4752 = select(_e4524, _e4750, (_e4750 < _e4524));
let _e4759 = select(0i, select(select(i32(_e4752), i32(-2147483648), (_e4752 < -2147483600f)), 2147483647i, (_e4752 > 2147483500f)), (_e4752 == _e4752));
let _e4763 = (_e4759 - select(0i, 1i, (_e4752 < f32(_e4759))));
let _e4765 = ((_e4763 * _e4514) + _e4748);
let _e4767 = (_e4732 - f32(_e4748));
let _e4769 = (_e4733 - f32(_e4763));
let _e4776 = ((((_e4732 >= 0f) && (_e4732 <= _e4516)) && (_e4733 >= 0f)) && (_e4733 <= _e4524));
let _e4777 = (_e4572 + _e4765);
let _e4779 = select(_e4580, _e4777, (_e4777 < _e4580));
let _e4785 = global_6.member[bitcast<u32>(select(0i, _e4779, (_e4779 > 0i)))];
let _e4786 = (_e4777 + 1i);
let _e4788 = select(_e4580, _e4786, (_e4786 < _e4580));
let _e4794 = global_6.member[bitcast<u32>(select(0i, _e4788, (_e4788 > 0i)))];
let _e4797 = (_e4785 + ((_e4794 - _e4785) * _e4767));
let _e4798 = (_e4777 + _e4514);
let _e4800 = select(_e4580, _e4798, (_e4798 < _e4580));
let _e4806 = global_6.member[bitcast<u32>(select(0i, _e4800, (_e4800 > 0i)))];
let _e4807 = (_e4798 + 1i);
let _e4809 = select(_e4580, _e4807, (_e4807 < _e4580));
let _e4815 = global_6.member[bitcast<u32>(select(0i, _e4809, (_e4809 > 0i)))];
let _e4822 = select(1f, (_e4797 + (((_e4806 + ((_e4815 - _e4806) * _e4767)) - _e4797) * _e4769)), _e4776);
if _e3513 {
phi_7821_ = vec3(_e4822);
} else {
let _e4825 = ((_e4572 + _e4574) + _e4765);
let _e4827 = select(_e4580, _e4825, (_e4825 < _e4580));
let _e4833 = global_6.member[bitcast<u32>(select(0i, _e4827, (_e4827 > 0i)))];
let _e4834 = (_e4825 + 1i);
let _e4836 = select(_e4580, _e4834, (_e4834 < _e4580));
let _e4842 = global_6.member[bitcast<u32>(select(0i, _e4836, (_e4836 > 0i)))];
let _e4845 = (_e4833 + ((_e4842 - _e4833) * _e4767));
let _e4846 = (_e4825 + _e4514);
let _e4848 = select(_e4580, _e4846, (_e4846 < _e4580));
let _e4854 = global_6.member[bitcast<u32>(select(0i, _e4848, (_e4848 > 0i)))];
let _e4855 = (_e4846 + 1i);
let _e4857 = select(_e4580, _e4855, (_e4855 < _e4580));
let _e4863 = global_6.member[bitcast<u32>(select(0i, _e4857, (_e4857 > 0i)))];
let _e4873 = ((_e4572 + (2i * _e4574)) + _e4765);
let _e4875 = select(_e4580, _e4873, (_e4873 < _e4580));
let _e4881 = global_6.member[bitcast<u32>(select(0i, _e4875, (_e4875 > 0i)))];
let _e4882 = (_e4873 + 1i);
let _e4884 = select(_e4580, _e4882, (_e4882 < _e4580));
let _e4890 = global_6.member[bitcast<u32>(select(0i, _e4884, (_e4884 > 0i)))];
let _e4893 = (_e4881 + ((_e4890 - _e4881) * _e4767));
let _e4894 = (_e4873 + _e4514);
let _e4896 = select(_e4580, _e4894, (_e4894 < _e4580));
let _e4902 = global_6.member[bitcast<u32>(select(0i, _e4896, (_e4896 > 0i)))];
let _e4903 = (_e4894 + 1i);
let _e4905 = select(_e4580, _e4903, (_e4903 < _e4580));
let _e4911 = global_6.member[bitcast<u32>(select(0i, _e4905, (_e4905 > 0i)))];
phi_7821_ = vec3<f32>(_e4822, select(1f, (_e4845 + (((_e4854 + ((_e4863 - _e4854) * _e4767)) - _e4845) * _e4769)), _e4776), select(1f, (_e4893 + (((_e4902 + ((_e4911 - _e4902) * _e4767)) - _e4893) * _e4769)), _e4776));
}
let _e4921 = phi_7821_;
local = (_e4576 + _e4765);
let _e4923 = local;
let _e4925 = select(_e4580, _e4923, (_e4923 < _e4580));
let _e4930 = global_6.member[bitcast<u32>(select(0i, _e4925, (_e4925 > 0i)))];
let _e4931 = bitcast<u32>(_e4930);
let _e4935 = f32((bitcast<i32>((_e4931 & 65535u)) - 32768i));
let _e4941 = f32((bitcast<i32>(((_e4931 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4946 = select(_e4941, -(_e4941), ((_e4931 >> bitcast<u32>(31i)) != 0u));
let _e4947 = local;
let _e4948 = (_e4947 + 1i);
let _e4950 = select(_e4580, _e4948, (_e4948 < _e4580));
let _e4955 = global_6.member[bitcast<u32>(select(0i, _e4950, (_e4950 > 0i)))];
let _e4956 = bitcast<u32>(_e4955);
let _e4966 = f32((bitcast<i32>(((_e4956 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4972 = local;
let _e4973 = (_e4972 + _e4514);
let _e4975 = select(_e4580, _e4973, (_e4973 < _e4580));
let _e4980 = global_6.member[bitcast<u32>(select(0i, _e4975, (_e4975 > 0i)))];
let _e4981 = bitcast<u32>(_e4980);
let _e4985 = f32((bitcast<i32>((_e4981 & 65535u)) - 32768i));
let _e4991 = f32((bitcast<i32>(((_e4981 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4996 = select(_e4991, -(_e4991), ((_e4981 >> bitcast<u32>(31i)) != 0u));
let _e4997 = local;
let _e4998 = (_e4997 + _e4654);
let _e5000 = select(_e4580, _e4998, (_e4998 < _e4580));
let _e5005 = global_6.member[bitcast<u32>(select(0i, _e5000, (_e5000 > 0i)))];
let _e5006 = bitcast<u32>(_e5005);
let _e5016 = f32((bitcast<i32>(((_e5006 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e5024 = (_e4935 + ((f32((bitcast<i32>((_e4956 & 65535u)) - 32768i)) - _e4935) * _e4767));
let _e5033 = (_e4946 + ((select(_e4966, -(_e4966), ((_e4956 >> bitcast<u32>(31i)) != 0u)) - _e4946) * _e4767));
let _e5046 = global_5.member[_e352].member_9.member_1;
let _e5053 = (_e4704.member + (select(0f, (_e5024 + (((_e4985 + ((f32((bitcast<i32>((_e5006 & 65535u)) - 32768i)) - _e4985) * _e4767)) - _e5024) * _e4769)), _e4776) * _e4707));
let _e5055 = (_e4704.member_1 + (select(0f, (_e5033 + (((_e4996 + ((select(_e5016, -(_e5016), ((_e5006 >> bitcast<u32>(31i)) != 0u)) - _e4996) * _e4767)) - _e5033) * _e4769)), _e4776) * _e4707));
let _e5059 = (1f - ((_e5053 * _e5053) + (_e5055 * _e5055)));
let _e5061 = select(1e-4f, _e5059, (_e5059 > 1e-4f));
phi_8051_ = type_25((_e4921 * vec3<f32>(_e5046.member, _e5046.member_1, _e5046.member_2)), vec3<f32>(_e5053, _e5055, sqrt(select(0f, _e5061, (_e5061 > 0f)))));
}
let _e5068 = phi_8051_;
let _e5077 = (((_e5068.member_1.x * _e5068.member_1.x) + (_e5068.member_1.y * _e5068.member_1.y)) + (_e5068.member_1.z * _e5068.member_1.z));
let _e5080 = sqrt(select(0f, _e5077, (_e5077 > 0f)));
let _e5086 = (1e-6f * _e5080);
let _e5090 = select((_e5080 / select(_e5086, _e5068.member_1.z, (_e5068.member_1.z > _e5086))), 1f, ((_e685 & 8u) != 0u));
let _e5092 = (_e5068.member.x * _e5090);
let _e5094 = (_e5068.member.y * _e5090);
let _e5096 = (_e5068.member.z * _e5090);
if _e792 {
let _e5101 = global_5.member[_e352].member_19;
let _e5110 = (((_e2745.member_1.x * _e2745.member_1.x) + (_e2745.member_1.y * _e2745.member_1.y)) + (_e2745.member_1.z * _e2745.member_1.z));
let _e5113 = sqrt(select(0f, _e5110, (_e5110 > 0f)));
let _e5116 = (1f / select(1e-20f, _e5113, (_e5113 > 1e-20f)));
let _e5117 = (_e2745.member_1.x * _e5116);
let _e5118 = (_e2745.member_1.y * _e5116);
let _e5119 = (_e2745.member_1.z * _e5116);
let _e5122 = (-1f / select(1e-20f, _e5080, (_e5080 > 1e-20f)));
let _e5123 = (_e5068.member_1.x * _e5122);
let _e5124 = (_e5068.member_1.y * _e5122);
let _e5125 = (_e5068.member_1.z * _e5122);
let _e5130 = (((_e356[2] * _e356[2]) + (_e356[3] * _e356[3])) + (_e356[4] * _e356[4]));
let _e5133 = sqrt(select(0f, _e5130, (_e5130 > 0f)));
let _e5136 = (-1f / select(1e-20f, _e5133, (_e5133 > 1e-20f)));
let _e5137 = (_e356[2] * _e5136);
let _e5138 = (_e356[3] * _e5136);
let _e5139 = (_e356[4] * _e5136);
let _e5146 = select(1f, -1f, ((((_e5117 * _e5137) + (_e5118 * _e5138)) + (_e5119 * _e5139)) < 0f));
let _e5147 = (_e5117 * _e5146);
let _e5148 = (_e5118 * _e5146);
let _e5149 = (_e5119 * _e5146);
let _e5154 = (((_e5147 * _e5137) + (_e5148 * _e5138)) + (_e5149 * _e5139));
let _e5156 = select(1e-4f, _e5154, (_e5154 > 1e-4f));
let _e5161 = (((_e5147 * _e5123) + (_e5148 * _e5124)) + (_e5149 * _e5125));
let _e5162 = (_e5123 + _e5137);
let _e5163 = (_e5124 + _e5138);
let _e5164 = (_e5125 + _e5139);
let _e5169 = (((_e5162 * _e5162) + (_e5163 * _e5163)) + (_e5164 * _e5164));
let _e5172 = sqrt(select(0f, _e5169, (_e5169 > 0f)));
let _e5175 = (1f / select(1e-6f, _e5172, (_e5172 > 1e-6f)));
let _e5176 = (_e5162 * _e5175);
let _e5177 = (_e5163 * _e5175);
let _e5178 = (_e5164 * _e5175);
let _e5183 = (((_e5147 * _e5176) + (_e5148 * _e5177)) + (_e5149 * _e5178));
let _e5185 = select(0f, _e5183, (_e5183 > 0f));
let _e5190 = (((_e5137 * _e5176) + (_e5138 * _e5177)) + (_e5139 * _e5178));
let _e5192 = select(0f, _e5190, (_e5190 > 0f));
let _e5193 = (_e5101 * _e5101);
let _e5194 = (_e5193 * _e5193);
let _e5198 = (((_e5185 * _e5185) * (_e5194 - 1f)) + 1f);
let _e5202 = (_e5161 > 0f);
let _e5203 = select(0f, _e5161, _e5202);
let _e5205 = (1f - _e5194);
let _e5207 = (((_e5203 * _e5203) * _e5205) + _e5194);
let _e5214 = (((_e5156 * _e5156) * _e5205) + _e5194);
let _e5219 = ((_e5156 * sqrt(select(0f, _e5207, (_e5207 > 0f)))) + (_e5203 * sqrt(select(0f, _e5214, (_e5214 > 0f)))));
let _e5224 = (_e2745.member_2 / _e3191);
let _e5228 = (((_e5224 * _e5224) - 1f) + (_e5192 * _e5192));
let _e5231 = sqrt(select(0f, _e5228, (_e5228 > 0f)));
let _e5232 = (_e5231 - _e5192);
let _e5233 = (_e5231 + _e5192);
let _e5236 = (_e5232 / select(1e-6f, _e5233, (_e5233 > 1e-6f)));
let _e5240 = ((_e5192 * _e5232) + 1f);
let _e5243 = (((_e5192 * _e5233) - 1f) / select(1e-6f, _e5240, (_e5240 > 1e-6f)));
let _e5261 = global_5.member[_e352].member_20;
let _e5265 = ((select(0f, ((((_e5194 / ((3.1415927f * _e5198) * _e5198)) * (0.5f / select(1e-6f, _e5219, (_e5219 > 1e-6f)))) * select(select((((0.5f * _e5236) * _e5236) * (1f + (_e5243 * _e5243))), 1f, (_e5228 <= 0f)), 0f, (_e3191 == _e2745.member_2))) * _e5203), (_e5202 && (_e5113 > 1e-12f))) * _e5261) * select(_e3407.member_2, 0f, _e442));
phi_8369_ = vec3<f32>((_e5092 * _e5265), (_e5094 * _e5265), (_e5096 * _e5265));
} else {
phi_8369_ = vec3<f32>(0f, 0f, 0f);
}
let _e5271 = phi_8369_;
let _e5282 = global_5.member[_e352].member_18;
let _e5289 = (1f - _e356[11]);
let _e5309 = (_e356[8] + ((_e356[12] * ((_e4440.member_3.x * (_e5092 + _e5282.member)) + _e5271.x)) * _e5289));
let _e5310 = (_e356[9] + ((_e356[13] * ((_e4440.member_3.y * (_e5094 + _e5282.member_1)) + _e5271.y)) * _e5289));
let _e5311 = (_e356[10] + ((_e356[14] * ((_e4440.member_3.z * (_e5096 + _e5282.member_2)) + _e5271.z)) * _e5289));
let _e5314 = (_e356[11] + (_e5289 * _e4440.member_1));
let _e5317 = (_e356[12] * _e4440.member_2.x);
let _e5319 = (_e356[13] * _e4440.member_2.y);
let _e5321 = (_e356[14] * _e4440.member_2.z);
let _e5327 = (_e356[7] + ((_e5314 - _e356[11]) * (_e371 + (_e3496 * 0.5f))));
let _e5336 = (-((((select(_e762.member, _e749.member, _e742) * _e5068.member_1.x) + (select(_e762.member_1, _e749.member_1, _e742) * _e5068.member_1.y)) + (select(_e762.member_2, _e749.member_2, _e742) * _e5068.member_1.z))) / select(1e-20f, _e5080, (_e5080 > 1e-20f)));
let _e5341 = bitcast<f32>((bitcast<u32>(select(0f, _e5336, (_e5336 > 0f))) & 2147483647u));
let _e5351 = (1f - _e5314);
let _e5364 = select(_e5314, 1f, _e442);
if _e792 {
let _e5373 = global_5.member[_e352].member_5.member_4;
let _e5376 = (_e2745.member_3.x * _e3407.member_2);
let _e5378 = (_e2745.member_3.y * _e3407.member_2);
let _e5380 = (_e2745.member_3.z * _e3407.member_2);
let _e5381 = (0.5f * _e366);
let _e5385 = (_e356[2] + (_e5376 * _e5381));
let _e5386 = (_e356[3] + (_e5378 * _e5381));
let _e5387 = (_e356[4] + (_e5380 * _e5381));
let _e5389 = (2f * _e365);
let _e5391 = ((_e5387 * _e5387) + (_e5389 * _e5380));
let _e5395 = (_e5387 + sqrt(select(0f, _e5391, (_e5391 > 0f))));
let _e5399 = (0.5f * (_e5389 / select(1e-6f, _e5395, (_e5395 > 1e-6f))));
let _e5403 = (_e5385 + (_e5376 * _e5399));
let _e5404 = (_e5386 + (_e5378 * _e5399));
let _e5405 = (_e5387 + (_e5380 * _e5399));
let _e5409 = (_e5373 * _e5373);
let _e5411 = (_e5405 * _e5405);
let _e5419 = (((_e5387 <= 0f) || (_e5391 <= 0f)) || ((_e5405 <= 0f) || (_e5411 <= (_e5409 * (((_e5403 * _e5403) + (_e5404 * _e5404)) + _e5411)))));
let _e5433 = (_e356[2] + ((_e2745.member_4.x * _e3407.member_2) * _e365));
let _e5434 = (_e356[3] + ((_e2745.member_4.y * _e3407.member_2) * _e365));
let _e5435 = (_e356[4] + ((_e2745.member_4.z * _e3407.member_2) * _e365));
let _e5437 = (_e5435 * _e5435);
let _e5446 = ((_e685 & 1u) != 0u);
phi_8678_ = select(select(_e5405, _e5387, _e5419), _e5435, _e5446);
phi_8679_ = select(select(_e5404, _e5386, _e5419), _e5434, _e5446);
phi_8680_ = select(select(_e5403, _e5385, _e5419), _e5433, _e5446);
phi_8681_ = select(_e5419, ((_e5435 <= 0f) || (_e5437 <= (_e5409 * (((_e5433 * _e5433) + (_e5434 * _e5434)) + _e5437)))), _e5446);
} else {
phi_8678_ = _e356[4];
phi_8679_ = _e356[3];
phi_8680_ = _e356[2];
phi_8681_ = false;
}
let _e5452 = phi_8678_;
let _e5454 = phi_8679_;
let _e5456 = phi_8680_;
let _e5458 = phi_8681_;
let _e5464 = (((_e442 || (_e5456 != _e356[2])) || (_e5454 != _e356[3])) || (_e5452 != _e356[4]));
let _e5466 = select(_e5319, _e5317, (_e5317 > _e5319));
phi_8741_ = array<f32, 18>(select(_e356[0], select(_e382, _e4445, _e442), _e5464), select(_e356[1], select(_e384, _e4446, _e442), _e5464), _e5456, _e5454, _e5452, _e2745.member, select(select(0f, 2f, _e5458), 1f, (_e442 || (((1f - _e5364) * select(_e5321, _e5466, (_e5466 > _e5321))) < 9.765625e-4f))), select(_e5327, (_e5327 + (_e5351 * _e4447)), _e442), select(_e5309, (_e5309 + ((_e5317 * (select(_e768.member, _e755.member, _e742) * ((_e5092 * _e5341) + _e5282.member))) * _e5351)), _e442), select(_e5310, (_e5310 + ((_e5319 * (select(_e768.member_1, _e755.member_1, _e742) * ((_e5094 * _e5341) + _e5282.member_1))) * _e5351)), _e442), select(_e5311, (_e5311 + ((_e5321 * (select(_e768.member_2, _e755.member_2, _e742) * ((_e5096 * _e5341) + _e5282.member_2))) * _e5351)), _e442), _e5364, _e5317, _e5319, _e5321, _e2745.member_2, select(_e356[16], select(_e389, _e4447, _e442), _e5464), _e389);
} else {
phi_8741_ = _e356;
}
let _e5485 = phi_8741_;
phi_583_ = (_e352 + 1u);
phi_586_ = select(_e354, true, _e725);
phi_588_ = _e5485;
} else {
phi_583_ = u32();
phi_586_ = bool();
phi_588_ = array<f32, 18>();
}
let _e5489 = phi_583_;
let _e5491 = phi_586_;
let _e5493 = phi_588_;
continue;
continuing {
phi_582_ = _e5489;
phi_585_ = _e5491;
phi_587_ = _e5493;
phi_8824_ = false;
break if !(_e357);
}
}
let _e5496 = phi_8824_;
if _e5496 {
break;
}
let _e5498 = local_8;
if _e5498 {
let _e5500 = local_9;
global_4.member[_e152] = _e5500[0];
let _e5505 = local_10;
global_4.member[_e164] = _e5505[1];
let _e5510 = local_11;
global_4.member[_e175] = _e5510[2];
let _e5515 = local_12;
global_4.member[_e186] = _e5515[3];
let _e5520 = local_13;
global_4.member[_e197] = _e5520[4];
let _e5525 = local_14;
global_4.member[_e208] = _e5525[5];
let _e5530 = local_15;
global_4.member[_e219] = _e5530[6];
let _e5535 = local_16;
global_4.member[_e230] = _e5535[7];
let _e5540 = local_17;
global_4.member[_e241] = _e5540[8];
let _e5545 = local_18;
global_4.member[_e252] = _e5545[9];
let _e5550 = local_19;
global_4.member[_e263] = _e5550[10];
let _e5555 = local_20;
global_4.member[_e274] = _e5555[11];
let _e5560 = local_21;
global_4.member[_e285] = _e5560[12];
let _e5565 = local_22;
global_4.member[_e296] = _e5565[13];
let _e5570 = local_23;
global_4.member[_e307] = _e5570[14];
let _e5575 = local_24;
global_4.member[_e318] = _e5575[15];
let _e5580 = local_25;
global_4.member[_e329] = _e5580[16];
let _e5585 = local_26;
global_4.member[_e340] = _e5585[17];
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
