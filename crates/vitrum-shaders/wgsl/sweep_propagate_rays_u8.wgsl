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
var phi_3684_: type_29;
var phi_4446_: type_30;
var phi_5148_: f32;
var phi_5537_: type_5;
var phi_7095_: type_31;
var phi_7848_: vec3<f32>;
var phi_8078_: type_25;
var phi_8396_: vec3<f32>;
var phi_8705_: f32;
var phi_8706_: f32;
var phi_8707_: f32;
var phi_8708_: bool;
var phi_8768_: array<f32, 18>;
var phi_583_: u32;
var phi_586_: bool;
var phi_588_: array<f32, 18>;
var phi_8851_: bool;
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
phi_8851_ = true;
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
let _e855 = (select(0i, select(select(i32(_e530), i32(-2147483648), (_e530 < -2147483600f)), 2147483647i, (_e530 > 2147483500f)), (_e530 == _e530)) - 1i);
let _e856 = (_e822 - 1i);
let _e861 = (_e822 + 1i);
let _e864 = (_e822 + 2i);
let _e874 = (select(0i, select(select(i32(_e541), i32(-2147483648), (_e541 < -2147483600f)), 2147483647i, (_e541 > 2147483500f)), (_e541 == _e541)) - 1i);
let _e875 = (_e837 - 1i);
let _e880 = (_e837 + 1i);
let _e883 = (_e837 + 2i);
let _e892 = select(0i, select(select(i32(_e519), i32(-2147483648), (_e519 < -2147483600f)), 2147483647i, (_e519 > 2147483500f)), (_e519 == _e519));
let _e893 = (_e892 - 1i);
let _e894 = (_e807 - 1i);
let _e896 = select(0i, _e894, (_e894 > 0i));
let _e899 = (_e807 + 1i);
let _e902 = (_e807 + 2i);
let _e905 = (_e892 - 4i);
let _e907 = select(0i, _e905, (_e905 > 0i));
let _e909 = select(_e907, _e896, (_e896 < _e907));
let _e922 = (select(0i, _e856, (_e856 > 0i)) * _e842);
let _e923 = (select(0i, _e822, (_e822 > 0i)) * _e842);
let _e924 = (select(_e855, _e861, (_e861 < _e855)) * _e842);
let _e925 = (select(_e855, _e864, (_e864 < _e855)) * _e842);
let _e926 = (select(0i, _e875, (_e875 > 0i)) * _e847);
let _e927 = (select(0i, _e837, (_e837 > 0i)) * _e847);
let _e928 = (select(_e874, _e880, (_e880 < _e874)) * _e847);
let _e929 = (select(_e874, _e883, (_e883 < _e874)) * _e847);
local_6 = type_28(array<i32, 4>(_e909, _e909, _e909, _e909), array<u32, 6>(bitcast<u32>(((_e896 - _e909) * 8i)), bitcast<u32>(((select(0i, _e807, (_e807 > 0i)) - _e909) * 8i)), bitcast<u32>(((select(_e893, _e899, (_e899 < _e893)) - _e909) * 8i)), bitcast<u32>(((select(_e893, _e902, (_e902 < _e893)) - _e909) * 8i)), 0u, 0u));
local_7 = vec3<f32>((_e524 - f32(_e807)), (_e535 - f32(_e822)), (_e546 - f32(_e837)));
let _e944 = local_6.member[0u];
let _e945 = ((_e927 + _e923) + _e944);
let _e947 = (_e945 >> bitcast<u32>(2i));
let _e950 = bitcast<u32>(((_e945 & 3i) * 8i));
let _e952 = (bitcast<i32>(_e119) - 1i);
let _e954 = select(_e952, _e947, (_e947 < _e952));
let _e959 = global_1.member[bitcast<u32>(select(0i, _e954, (_e954 > 0i)))];
let _e963 = (_e947 + 1i);
let _e965 = select(_e952, _e963, (_e963 < _e952));
let _e970 = global_1.member[bitcast<u32>(select(0i, _e965, (_e965 > 0i)))];
let _e977 = ((_e959 >> bitcast<u32>((_e950 & 31u))) | ((_e970 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e950) & 31u))));
let _e980 = local_6.member_1[0u];
let _e986 = f32(bitcast<i32>(((_e977 >> bitcast<u32>((_e980 & 31u))) & 255u)));
let _e989 = local_6.member_1[1u];
let _e995 = f32(bitcast<i32>(((_e977 >> bitcast<u32>((_e989 & 31u))) & 255u)));
let _e998 = local_6.member_1[2u];
let _e1004 = f32(bitcast<i32>(((_e977 >> bitcast<u32>((_e998 & 31u))) & 255u)));
let _e1007 = local_6.member_1[3u];
let _e1014 = local_7[0u];
let _e1017 = (_e986 + ((_e995 - _e986) * _e1014));
let _e1018 = local_7[0u];
let _e1021 = (_e995 + ((_e1004 - _e995) * _e1018));
let _e1022 = local_7[0u];
let _e1025 = (_e1004 + ((f32(bitcast<i32>(((_e977 >> bitcast<u32>((_e1007 & 31u))) & 255u))) - _e1004) * _e1022));
let _e1027 = local_6.member[0u];
let _e1028 = ((_e927 + _e924) + _e1027);
let _e1030 = (_e1028 >> bitcast<u32>(2i));
let _e1033 = bitcast<u32>(((_e1028 & 3i) * 8i));
let _e1035 = select(_e952, _e1030, (_e1030 < _e952));
let _e1040 = global_1.member[bitcast<u32>(select(0i, _e1035, (_e1035 > 0i)))];
let _e1044 = (_e1030 + 1i);
let _e1046 = select(_e952, _e1044, (_e1044 < _e952));
let _e1051 = global_1.member[bitcast<u32>(select(0i, _e1046, (_e1046 > 0i)))];
let _e1058 = ((_e1040 >> bitcast<u32>((_e1033 & 31u))) | ((_e1051 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1033) & 31u))));
let _e1059 = local_6.member_1[0u];
let _e1065 = f32(bitcast<i32>(((_e1058 >> bitcast<u32>((_e1059 & 31u))) & 255u)));
let _e1066 = local_6.member_1[1u];
let _e1072 = f32(bitcast<i32>(((_e1058 >> bitcast<u32>((_e1066 & 31u))) & 255u)));
let _e1073 = local_6.member_1[2u];
let _e1079 = f32(bitcast<i32>(((_e1058 >> bitcast<u32>((_e1073 & 31u))) & 255u)));
let _e1080 = local_6.member_1[3u];
let _e1087 = local_7[0u];
let _e1091 = local_7[0u];
let _e1094 = (_e1072 + ((_e1079 - _e1072) * _e1091));
let _e1095 = local_7[0u];
let _e1100 = local_6.member[0u];
let _e1101 = ((_e928 + _e923) + _e1100);
let _e1103 = (_e1101 >> bitcast<u32>(2i));
let _e1106 = bitcast<u32>(((_e1101 & 3i) * 8i));
let _e1108 = select(_e952, _e1103, (_e1103 < _e952));
let _e1113 = global_1.member[bitcast<u32>(select(0i, _e1108, (_e1108 > 0i)))];
let _e1117 = (_e1103 + 1i);
let _e1119 = select(_e952, _e1117, (_e1117 < _e952));
let _e1124 = global_1.member[bitcast<u32>(select(0i, _e1119, (_e1119 > 0i)))];
let _e1131 = ((_e1113 >> bitcast<u32>((_e1106 & 31u))) | ((_e1124 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1106) & 31u))));
let _e1132 = local_6.member_1[0u];
let _e1138 = f32(bitcast<i32>(((_e1131 >> bitcast<u32>((_e1132 & 31u))) & 255u)));
let _e1139 = local_6.member_1[1u];
let _e1145 = f32(bitcast<i32>(((_e1131 >> bitcast<u32>((_e1139 & 31u))) & 255u)));
let _e1146 = local_6.member_1[2u];
let _e1152 = f32(bitcast<i32>(((_e1131 >> bitcast<u32>((_e1146 & 31u))) & 255u)));
let _e1153 = local_6.member_1[3u];
let _e1160 = local_7[0u];
let _e1163 = (_e1138 + ((_e1145 - _e1138) * _e1160));
let _e1164 = local_7[0u];
let _e1167 = (_e1145 + ((_e1152 - _e1145) * _e1164));
let _e1168 = local_7[0u];
let _e1171 = (_e1152 + ((f32(bitcast<i32>(((_e1131 >> bitcast<u32>((_e1153 & 31u))) & 255u))) - _e1152) * _e1168));
let _e1173 = local_6.member[0u];
let _e1174 = ((_e928 + _e924) + _e1173);
let _e1176 = (_e1174 >> bitcast<u32>(2i));
let _e1179 = bitcast<u32>(((_e1174 & 3i) * 8i));
let _e1181 = select(_e952, _e1176, (_e1176 < _e952));
let _e1186 = global_1.member[bitcast<u32>(select(0i, _e1181, (_e1181 > 0i)))];
let _e1190 = (_e1176 + 1i);
let _e1192 = select(_e952, _e1190, (_e1190 < _e952));
let _e1197 = global_1.member[bitcast<u32>(select(0i, _e1192, (_e1192 > 0i)))];
let _e1204 = ((_e1186 >> bitcast<u32>((_e1179 & 31u))) | ((_e1197 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1179) & 31u))));
let _e1205 = local_6.member_1[0u];
let _e1211 = f32(bitcast<i32>(((_e1204 >> bitcast<u32>((_e1205 & 31u))) & 255u)));
let _e1212 = local_6.member_1[1u];
let _e1218 = f32(bitcast<i32>(((_e1204 >> bitcast<u32>((_e1212 & 31u))) & 255u)));
let _e1219 = local_6.member_1[2u];
let _e1225 = f32(bitcast<i32>(((_e1204 >> bitcast<u32>((_e1219 & 31u))) & 255u)));
let _e1226 = local_6.member_1[3u];
let _e1233 = local_7[0u];
let _e1237 = local_7[0u];
let _e1240 = (_e1218 + ((_e1225 - _e1218) * _e1237));
let _e1241 = local_7[0u];
let _e1246 = local_6.member[0u];
let _e1247 = ((_e927 + _e922) + _e1246);
let _e1249 = (_e1247 >> bitcast<u32>(2i));
let _e1252 = bitcast<u32>(((_e1247 & 3i) * 8i));
let _e1254 = select(_e952, _e1249, (_e1249 < _e952));
let _e1259 = global_1.member[bitcast<u32>(select(0i, _e1254, (_e1254 > 0i)))];
let _e1263 = (_e1249 + 1i);
let _e1265 = select(_e952, _e1263, (_e1263 < _e952));
let _e1270 = global_1.member[bitcast<u32>(select(0i, _e1265, (_e1265 > 0i)))];
let _e1277 = ((_e1259 >> bitcast<u32>((_e1252 & 31u))) | ((_e1270 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1252) & 31u))));
let _e1278 = local_6.member_1[1u];
let _e1284 = f32(bitcast<i32>(((_e1277 >> bitcast<u32>((_e1278 & 31u))) & 255u)));
let _e1285 = local_6.member_1[2u];
let _e1292 = local_7[0u];
let _e1295 = (_e1284 + ((f32(bitcast<i32>(((_e1277 >> bitcast<u32>((_e1285 & 31u))) & 255u))) - _e1284) * _e1292));
let _e1297 = local_6.member[0u];
let _e1298 = ((_e927 + _e925) + _e1297);
let _e1300 = (_e1298 >> bitcast<u32>(2i));
let _e1303 = bitcast<u32>(((_e1298 & 3i) * 8i));
let _e1305 = select(_e952, _e1300, (_e1300 < _e952));
let _e1310 = global_1.member[bitcast<u32>(select(0i, _e1305, (_e1305 > 0i)))];
let _e1314 = (_e1300 + 1i);
let _e1316 = select(_e952, _e1314, (_e1314 < _e952));
let _e1321 = global_1.member[bitcast<u32>(select(0i, _e1316, (_e1316 > 0i)))];
let _e1328 = ((_e1310 >> bitcast<u32>((_e1303 & 31u))) | ((_e1321 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1303) & 31u))));
let _e1329 = local_6.member_1[1u];
let _e1335 = f32(bitcast<i32>(((_e1328 >> bitcast<u32>((_e1329 & 31u))) & 255u)));
let _e1336 = local_6.member_1[2u];
let _e1343 = local_7[0u];
let _e1348 = local_6.member[0u];
let _e1349 = ((_e928 + _e922) + _e1348);
let _e1351 = (_e1349 >> bitcast<u32>(2i));
let _e1354 = bitcast<u32>(((_e1349 & 3i) * 8i));
let _e1356 = select(_e952, _e1351, (_e1351 < _e952));
let _e1361 = global_1.member[bitcast<u32>(select(0i, _e1356, (_e1356 > 0i)))];
let _e1365 = (_e1351 + 1i);
let _e1367 = select(_e952, _e1365, (_e1365 < _e952));
let _e1372 = global_1.member[bitcast<u32>(select(0i, _e1367, (_e1367 > 0i)))];
let _e1379 = ((_e1361 >> bitcast<u32>((_e1354 & 31u))) | ((_e1372 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1354) & 31u))));
let _e1380 = local_6.member_1[1u];
let _e1386 = f32(bitcast<i32>(((_e1379 >> bitcast<u32>((_e1380 & 31u))) & 255u)));
let _e1387 = local_6.member_1[2u];
let _e1394 = local_7[0u];
let _e1397 = (_e1386 + ((f32(bitcast<i32>(((_e1379 >> bitcast<u32>((_e1387 & 31u))) & 255u))) - _e1386) * _e1394));
let _e1399 = local_6.member[0u];
let _e1400 = ((_e928 + _e925) + _e1399);
let _e1402 = (_e1400 >> bitcast<u32>(2i));
let _e1405 = bitcast<u32>(((_e1400 & 3i) * 8i));
let _e1407 = select(_e952, _e1402, (_e1402 < _e952));
let _e1412 = global_1.member[bitcast<u32>(select(0i, _e1407, (_e1407 > 0i)))];
let _e1416 = (_e1402 + 1i);
let _e1418 = select(_e952, _e1416, (_e1416 < _e952));
let _e1423 = global_1.member[bitcast<u32>(select(0i, _e1418, (_e1418 > 0i)))];
let _e1430 = ((_e1412 >> bitcast<u32>((_e1405 & 31u))) | ((_e1423 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1405) & 31u))));
let _e1431 = local_6.member_1[1u];
let _e1437 = f32(bitcast<i32>(((_e1430 >> bitcast<u32>((_e1431 & 31u))) & 255u)));
let _e1438 = local_6.member_1[2u];
let _e1445 = local_7[0u];
let _e1450 = local_6.member[0u];
let _e1451 = ((_e926 + _e923) + _e1450);
let _e1453 = (_e1451 >> bitcast<u32>(2i));
let _e1456 = bitcast<u32>(((_e1451 & 3i) * 8i));
let _e1458 = select(_e952, _e1453, (_e1453 < _e952));
let _e1463 = global_1.member[bitcast<u32>(select(0i, _e1458, (_e1458 > 0i)))];
let _e1467 = (_e1453 + 1i);
let _e1469 = select(_e952, _e1467, (_e1467 < _e952));
let _e1474 = global_1.member[bitcast<u32>(select(0i, _e1469, (_e1469 > 0i)))];
let _e1481 = ((_e1463 >> bitcast<u32>((_e1456 & 31u))) | ((_e1474 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1456) & 31u))));
let _e1482 = local_6.member_1[1u];
let _e1488 = f32(bitcast<i32>(((_e1481 >> bitcast<u32>((_e1482 & 31u))) & 255u)));
let _e1489 = local_6.member_1[2u];
let _e1496 = local_7[0u];
let _e1499 = (_e1488 + ((f32(bitcast<i32>(((_e1481 >> bitcast<u32>((_e1489 & 31u))) & 255u))) - _e1488) * _e1496));
let _e1501 = local_6.member[0u];
let _e1502 = ((_e929 + _e923) + _e1501);
let _e1504 = (_e1502 >> bitcast<u32>(2i));
let _e1507 = bitcast<u32>(((_e1502 & 3i) * 8i));
let _e1509 = select(_e952, _e1504, (_e1504 < _e952));
let _e1514 = global_1.member[bitcast<u32>(select(0i, _e1509, (_e1509 > 0i)))];
let _e1518 = (_e1504 + 1i);
let _e1520 = select(_e952, _e1518, (_e1518 < _e952));
let _e1525 = global_1.member[bitcast<u32>(select(0i, _e1520, (_e1520 > 0i)))];
let _e1532 = ((_e1514 >> bitcast<u32>((_e1507 & 31u))) | ((_e1525 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1507) & 31u))));
let _e1533 = local_6.member_1[1u];
let _e1539 = f32(bitcast<i32>(((_e1532 >> bitcast<u32>((_e1533 & 31u))) & 255u)));
let _e1540 = local_6.member_1[2u];
let _e1547 = local_7[0u];
let _e1550 = (_e1539 + ((f32(bitcast<i32>(((_e1532 >> bitcast<u32>((_e1540 & 31u))) & 255u))) - _e1539) * _e1547));
let _e1552 = local_6.member[0u];
let _e1553 = ((_e926 + _e924) + _e1552);
let _e1555 = (_e1553 >> bitcast<u32>(2i));
let _e1558 = bitcast<u32>(((_e1553 & 3i) * 8i));
let _e1560 = select(_e952, _e1555, (_e1555 < _e952));
let _e1565 = global_1.member[bitcast<u32>(select(0i, _e1560, (_e1560 > 0i)))];
let _e1569 = (_e1555 + 1i);
let _e1571 = select(_e952, _e1569, (_e1569 < _e952));
let _e1576 = global_1.member[bitcast<u32>(select(0i, _e1571, (_e1571 > 0i)))];
let _e1583 = ((_e1565 >> bitcast<u32>((_e1558 & 31u))) | ((_e1576 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1558) & 31u))));
let _e1584 = local_6.member_1[1u];
let _e1590 = f32(bitcast<i32>(((_e1583 >> bitcast<u32>((_e1584 & 31u))) & 255u)));
let _e1591 = local_6.member_1[2u];
let _e1598 = local_7[0u];
let _e1603 = local_6.member[0u];
let _e1604 = ((_e929 + _e924) + _e1603);
let _e1606 = (_e1604 >> bitcast<u32>(2i));
let _e1609 = bitcast<u32>(((_e1604 & 3i) * 8i));
let _e1611 = select(_e952, _e1606, (_e1606 < _e952));
let _e1616 = global_1.member[bitcast<u32>(select(0i, _e1611, (_e1611 > 0i)))];
let _e1620 = (_e1606 + 1i);
let _e1622 = select(_e952, _e1620, (_e1620 < _e952));
let _e1627 = global_1.member[bitcast<u32>(select(0i, _e1622, (_e1622 > 0i)))];
let _e1634 = ((_e1616 >> bitcast<u32>((_e1609 & 31u))) | ((_e1627 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1609) & 31u))));
let _e1635 = local_6.member_1[1u];
let _e1641 = f32(bitcast<i32>(((_e1634 >> bitcast<u32>((_e1635 & 31u))) & 255u)));
let _e1642 = local_6.member_1[2u];
let _e1649 = local_7[0u];
let _e1654 = local_7[1u];
let _e1657 = (_e1021 + ((_e1094 - _e1021) * _e1654));
let _e1658 = local_7[1u];
let _e1661 = (_e1167 + ((_e1240 - _e1167) * _e1658));
let _e1662 = local_7[1u];
let _e1665 = (_e1017 + (((_e1065 + ((_e1072 - _e1065) * _e1087)) - _e1017) * _e1662));
let _e1666 = local_7[1u];
let _e1671 = local_7[2u];
let _e1675 = local_7[1u];
let _e1678 = (_e1025 + (((_e1079 + ((f32(bitcast<i32>(((_e1058 >> bitcast<u32>((_e1080 & 31u))) & 255u))) - _e1079) * _e1095)) - _e1025) * _e1675));
let _e1679 = local_7[1u];
let _e1683 = local_7[2u];
let _e1687 = local_7[1u];
let _e1690 = (_e1295 + ((_e1021 - _e1295) * _e1687));
let _e1691 = local_7[1u];
let _e1695 = local_7[2u];
let _e1699 = local_7[1u];
let _e1702 = (_e1094 + (((_e1335 + ((f32(bitcast<i32>(((_e1328 >> bitcast<u32>((_e1336 & 31u))) & 255u))) - _e1335) * _e1343)) - _e1094) * _e1699));
let _e1703 = local_7[1u];
let _e1707 = local_7[2u];
let _e1711 = local_7[1u];
let _e1714 = (_e1499 + (((_e1590 + ((f32(bitcast<i32>(((_e1583 >> bitcast<u32>((_e1591 & 31u))) & 255u))) - _e1590) * _e1598)) - _e1499) * _e1711));
let _e1715 = local_7[2u];
let _e1719 = local_7[1u];
let _e1723 = local_7[2u];
let _e1727 = local_7[2u];
let _e1735 = global_5.member[_e352].member_6.member_5;
let _e1741 = global_5.member[_e352].member_6.member_6;
let _e1742 = (((_e1657 + ((_e1661 - _e1657) * _e1727)) * _e1735) + _e1741);
let _e1744 = select(0f, _e1742, (_e1742 > 0f));
let _e1746 = select(1f, _e1744, (_e1744 < 1f));
let _e1748 = (((_e1665 + (((_e1163 + (((_e1211 + ((_e1218 - _e1211) * _e1233)) - _e1163) * _e1666)) - _e1665) * _e1671)) * _e1735) + _e1741);
let _e1750 = select(0f, _e1748, (_e1748 > 0f));
let _e1752 = select(1f, _e1750, (_e1750 < 1f));
let _e1754 = (((_e1678 + (((_e1171 + (((_e1225 + ((f32(bitcast<i32>(((_e1204 >> bitcast<u32>((_e1226 & 31u))) & 255u))) - _e1225) * _e1241)) - _e1171) * _e1679)) - _e1678) * _e1683)) * _e1735) + _e1741);
let _e1756 = select(0f, _e1754, (_e1754 > 0f));
let _e1758 = select(1f, _e1756, (_e1756 < 1f));
let _e1760 = (((_e1690 + (((_e1397 + ((_e1167 - _e1397) * _e1691)) - _e1690) * _e1695)) * _e1735) + _e1741);
let _e1762 = select(0f, _e1760, (_e1760 > 0f));
let _e1764 = select(1f, _e1762, (_e1762 < 1f));
let _e1766 = (((_e1702 + (((_e1240 + (((_e1437 + ((f32(bitcast<i32>(((_e1430 >> bitcast<u32>((_e1438 & 31u))) & 255u))) - _e1437) * _e1445)) - _e1240) * _e1703)) - _e1702) * _e1707)) * _e1735) + _e1741);
let _e1768 = select(0f, _e1766, (_e1766 > 0f));
let _e1770 = select(1f, _e1768, (_e1768 < 1f));
let _e1772 = (((_e1714 + ((_e1657 - _e1714) * _e1715)) * _e1735) + _e1741);
let _e1774 = select(0f, _e1772, (_e1772 > 0f));
let _e1776 = select(1f, _e1774, (_e1774 < 1f));
let _e1778 = (((_e1661 + (((_e1550 + (((_e1641 + ((f32(bitcast<i32>(((_e1634 >> bitcast<u32>((_e1642 & 31u))) & 255u))) - _e1641) * _e1649)) - _e1550) * _e1719)) - _e1661) * _e1723)) * _e1735) + _e1741);
let _e1780 = select(0f, _e1778, (_e1778 > 0f));
let _e1782 = select(1f, _e1780, (_e1780 < 1f));
let _e1783 = (_e1746 * 1024f);
let _e1784 = (1024f - 1f);
let _e1786 = select(0f, _e1783, (_e1783 > 0f));
let _e1788 = select(_e1784, _e1786, (_e1786 < _e1784));
let _e1795 = select(0i, select(select(i32(_e1788), i32(-2147483648), (_e1788 < -2147483600f)), 2147483647i, (_e1788 > 2147483500f)), (_e1788 == _e1788));
let _e1799 = (_e1795 - select(0i, 1i, (_e1788 < f32(_e1795))));
let _e1800 = (262147i + _e1799);
let _e1802 = (bitcast<i32>(_e123) - 1i);
let _e1804 = select(_e1802, _e1800, (_e1800 < _e1802));
let _e1810 = global_3.member[bitcast<u32>(select(0i, _e1804, (_e1804 > 0i)))];
let _e1820 = select(_e1802, 262146i, (262146i < _e1802));
let _e1826 = global_3.member[bitcast<u32>(select(0i, _e1820, (_e1820 > 0i)))];
let _e1827 = bitcast<f32>(_e1826);
let _e1828 = (f32((bitcast<i32>((_e1810 & 4095u)) - 2048i)) * _e1827);
let _e1830 = select(_e1802, 262144i, (262144i < _e1802));
let _e1836 = global_3.member[bitcast<u32>(select(0i, _e1830, (_e1830 > 0i)))];
let _e1837 = bitcast<f32>(_e1836);
let _e1839 = select(_e1802, 262145i, (262145i < _e1802));
let _e1845 = global_3.member[bitcast<u32>(select(0i, _e1839, (_e1839 > 0i)))];
let _e1846 = bitcast<f32>(_e1845);
let _e1852 = ((_e1837 + (f32(bitcast<i32>((_e1810 >> bitcast<u32>(12u)))) * _e1846)) + (_e1828 * (_e1783 - f32(_e1799))));
let _e1853 = (_e1828 * 1024f);
if _e789 {
let _e1860 = ((0.5f * (_e1758 - _e1752)) * _e1853);
let _e1861 = ((0.5f * (_e1770 - _e1764)) * _e1853);
let _e1862 = ((0.5f * (_e1782 - _e1776)) * _e1853);
phi_3684_ = type_29(_e1852, vec3<f32>(_e1860, _e1861, _e1862), vec3<f32>((_e1860 * _e1852), (_e1861 * _e1852), (_e1862 * _e1852)));
} else {
let _e1869 = (_e1752 * 1024f);
let _e1871 = select(0f, _e1869, (_e1869 > 0f));
let _e1873 = select(_e1784, _e1871, (_e1871 < _e1784));
let _e1880 = select(0i, select(select(i32(_e1873), i32(-2147483648), (_e1873 < -2147483600f)), 2147483647i, (_e1873 > 2147483500f)), (_e1873 == _e1873));
let _e1884 = (_e1880 - select(0i, 1i, (_e1873 < f32(_e1880))));
let _e1885 = (262147i + _e1884);
let _e1887 = select(_e1802, _e1885, (_e1885 < _e1802));
let _e1893 = global_3.member[bitcast<u32>(select(0i, _e1887, (_e1887 > 0i)))];
let _e1908 = ((_e1837 + (f32(bitcast<i32>((_e1893 >> bitcast<u32>(12u)))) * _e1846)) + ((f32((bitcast<i32>((_e1893 & 4095u)) - 2048i)) * _e1827) * (_e1869 - f32(_e1884))));
let _e1909 = (_e1758 * 1024f);
let _e1911 = select(0f, _e1909, (_e1909 > 0f));
let _e1913 = select(_e1784, _e1911, (_e1911 < _e1784));
let _e1920 = select(0i, select(select(i32(_e1913), i32(-2147483648), (_e1913 < -2147483600f)), 2147483647i, (_e1913 > 2147483500f)), (_e1913 == _e1913));
let _e1924 = (_e1920 - select(0i, 1i, (_e1913 < f32(_e1920))));
let _e1925 = (262147i + _e1924);
let _e1927 = select(_e1802, _e1925, (_e1925 < _e1802));
let _e1933 = global_3.member[bitcast<u32>(select(0i, _e1927, (_e1927 > 0i)))];
let _e1948 = ((_e1837 + (f32(bitcast<i32>((_e1933 >> bitcast<u32>(12u)))) * _e1846)) + ((f32((bitcast<i32>((_e1933 & 4095u)) - 2048i)) * _e1827) * (_e1909 - f32(_e1924))));
let _e1949 = (_e1764 * 1024f);
let _e1951 = select(0f, _e1949, (_e1949 > 0f));
let _e1953 = select(_e1784, _e1951, (_e1951 < _e1784));
let _e1960 = select(0i, select(select(i32(_e1953), i32(-2147483648), (_e1953 < -2147483600f)), 2147483647i, (_e1953 > 2147483500f)), (_e1953 == _e1953));
let _e1964 = (_e1960 - select(0i, 1i, (_e1953 < f32(_e1960))));
let _e1965 = (262147i + _e1964);
let _e1967 = select(_e1802, _e1965, (_e1965 < _e1802));
let _e1973 = global_3.member[bitcast<u32>(select(0i, _e1967, (_e1967 > 0i)))];
let _e1988 = ((_e1837 + (f32(bitcast<i32>((_e1973 >> bitcast<u32>(12u)))) * _e1846)) + ((f32((bitcast<i32>((_e1973 & 4095u)) - 2048i)) * _e1827) * (_e1949 - f32(_e1964))));
let _e1989 = (_e1770 * 1024f);
let _e1991 = select(0f, _e1989, (_e1989 > 0f));
let _e1993 = select(_e1784, _e1991, (_e1991 < _e1784));
let _e2000 = select(0i, select(select(i32(_e1993), i32(-2147483648), (_e1993 < -2147483600f)), 2147483647i, (_e1993 > 2147483500f)), (_e1993 == _e1993));
let _e2004 = (_e2000 - select(0i, 1i, (_e1993 < f32(_e2000))));
let _e2005 = (262147i + _e2004);
let _e2007 = select(_e1802, _e2005, (_e2005 < _e1802));
let _e2013 = global_3.member[bitcast<u32>(select(0i, _e2007, (_e2007 > 0i)))];
let _e2028 = ((_e1837 + (f32(bitcast<i32>((_e2013 >> bitcast<u32>(12u)))) * _e1846)) + ((f32((bitcast<i32>((_e2013 & 4095u)) - 2048i)) * _e1827) * (_e1989 - f32(_e2004))));
let _e2029 = (_e1776 * 1024f);
let _e2031 = select(0f, _e2029, (_e2029 > 0f));
let _e2033 = select(_e1784, _e2031, (_e2031 < _e1784));
let _e2040 = select(0i, select(select(i32(_e2033), i32(-2147483648), (_e2033 < -2147483600f)), 2147483647i, (_e2033 > 2147483500f)), (_e2033 == _e2033));
let _e2044 = (_e2040 - select(0i, 1i, (_e2033 < f32(_e2040))));
let _e2045 = (262147i + _e2044);
let _e2047 = select(_e1802, _e2045, (_e2045 < _e1802));
let _e2053 = global_3.member[bitcast<u32>(select(0i, _e2047, (_e2047 > 0i)))];
let _e2068 = ((_e1837 + (f32(bitcast<i32>((_e2053 >> bitcast<u32>(12u)))) * _e1846)) + ((f32((bitcast<i32>((_e2053 & 4095u)) - 2048i)) * _e1827) * (_e2029 - f32(_e2044))));
let _e2069 = (_e1782 * 1024f);
let _e2071 = select(0f, _e2069, (_e2069 > 0f));
let _e2073 = select(_e1784, _e2071, (_e2071 < _e1784));
let _e2080 = select(0i, select(select(i32(_e2073), i32(-2147483648), (_e2073 < -2147483600f)), 2147483647i, (_e2073 > 2147483500f)), (_e2073 == _e2073));
let _e2084 = (_e2080 - select(0i, 1i, (_e2073 < f32(_e2080))));
let _e2085 = (262147i + _e2084);
let _e2087 = select(_e1802, _e2085, (_e2085 < _e1802));
let _e2093 = global_3.member[bitcast<u32>(select(0i, _e2087, (_e2087 > 0i)))];
let _e2108 = ((_e1837 + (f32(bitcast<i32>((_e2093 >> bitcast<u32>(12u)))) * _e1846)) + ((f32((bitcast<i32>((_e2093 & 4095u)) - 2048i)) * _e1827) * (_e2069 - f32(_e2084))));
let _e2109 = (_e1948 - _e1908);
let _e2111 = (_e2028 - _e1988);
let _e2113 = (_e2108 - _e2068);
phi_3684_ = type_29(_e1852, vec3<f32>((0.5f * _e2109), (0.5f * _e2111), (0.5f * _e2113)), vec3<f32>((0.25f * (_e2109 * (_e1948 + _e1908))), (0.25f * (_e2111 * (_e2028 + _e1988))), (0.25f * (_e2113 * (_e2108 + _e2068)))));
}
let _e2128 = phi_3684_;
let _e2143 = select(0f, 1f, ((((((_e496 >= -0.5f) && (_e496 <= _e520)) && (_e502 >= -0.5f)) && (_e502 <= _e531)) && (_e508 >= -0.5f)) && (_e508 <= _e542)));
let _e2145 = (0.5f * (_e1758 - _e1752));
let _e2147 = (0.5f * (_e1770 - _e1764));
let _e2149 = (0.5f * (_e1782 - _e1776));
let _e2156 = global_5.member[_e352].member_6.member.member.member;
let _e2163 = global_5.member[_e352].member_6.member.member.member_1;
let _e2170 = global_5.member[_e352].member_6.member.member.member_2;
let _e2177 = global_5.member[_e352].member_6.member_1.member.member;
let _e2184 = global_5.member[_e352].member_6.member_1.member.member_1;
let _e2191 = global_5.member[_e352].member_6.member_1.member.member_2;
let _e2198 = global_5.member[_e352].member_6.member_2.member.member;
let _e2205 = global_5.member[_e352].member_6.member_2.member.member_1;
let _e2212 = global_5.member[_e352].member_6.member_2.member.member_2;
phi_4446_ = type_30(_e1746, vec3<f32>(((((_e2156 * _e2145) + (_e2177 * _e2147)) + (_e2198 * _e2149)) * _e2143), ((((_e2163 * _e2145) + (_e2184 * _e2147)) + (_e2205 * _e2149)) * _e2143), ((((_e2170 * _e2145) + (_e2191 * _e2147)) + (_e2212 * _e2149)) * _e2143)), _e2128.member, vec3<f32>(((((_e2156 * _e2128.member_2.x) + (_e2177 * _e2128.member_2.y)) + (_e2198 * _e2128.member_2.z)) * _e2143), ((((_e2163 * _e2128.member_2.x) + (_e2184 * _e2128.member_2.y)) + (_e2205 * _e2128.member_2.z)) * _e2143), ((((_e2170 * _e2128.member_2.x) + (_e2191 * _e2128.member_2.y)) + (_e2212 * _e2128.member_2.z)) * _e2143)), vec3<f32>(((((_e2156 * _e2128.member_1.x) + (_e2177 * _e2128.member_1.y)) + (_e2198 * _e2128.member_1.z)) * _e2143), ((((_e2163 * _e2128.member_1.x) + (_e2184 * _e2128.member_1.y)) + (_e2205 * _e2128.member_1.z)) * _e2143), ((((_e2170 * _e2128.member_1.x) + (_e2191 * _e2128.member_1.y)) + (_e2212 * _e2128.member_1.z)) * _e2143)));
} else {
let _e2278 = select(-1f, _e524, (_e524 > -1f));
let _e2280 = select(_e519, _e2278, (_e2278 < _e519));
let _e2287 = select(0i, select(select(i32(_e2280), i32(-2147483648), (_e2280 < -2147483600f)), 2147483647i, (_e2280 > 2147483500f)), (_e2280 == _e2280));
let _e2291 = (_e2287 - select(0i, 1i, (_e2280 < f32(_e2287))));
let _e2293 = select(-1f, _e535, (_e535 > -1f));
let _e2295 = select(_e530, _e2293, (_e2293 < _e530));
let _e2302 = select(0i, select(select(i32(_e2295), i32(-2147483648), (_e2295 < -2147483600f)), 2147483647i, (_e2295 > 2147483500f)), (_e2295 == _e2295));
let _e2306 = (_e2302 - select(0i, 1i, (_e2295 < f32(_e2302))));
let _e2308 = select(-1f, _e546, (_e546 > -1f));
let _e2310 = select(_e541, _e2308, (_e2308 < _e541));
let _e2317 = select(0i, select(select(i32(_e2310), i32(-2147483648), (_e2310 < -2147483600f)), 2147483647i, (_e2310 > 2147483500f)), (_e2310 == _e2310));
let _e2321 = (_e2317 - select(0i, 1i, (_e2310 < f32(_e2317))));
let _e2326 = global_5.member[_e352].member_6.member_7;
let _e2331 = global_5.member[_e352].member_6.member_8;
let _e2339 = (select(0i, select(select(i32(_e530), i32(-2147483648), (_e530 < -2147483600f)), 2147483647i, (_e530 > 2147483500f)), (_e530 == _e530)) - 1i);
let _e2342 = (_e2306 + 1i);
let _e2352 = (select(0i, select(select(i32(_e541), i32(-2147483648), (_e541 < -2147483600f)), 2147483647i, (_e541 > 2147483500f)), (_e541 == _e541)) - 1i);
let _e2355 = (_e2321 + 1i);
let _e2364 = select(0i, select(select(i32(_e519), i32(-2147483648), (_e519 < -2147483600f)), 2147483647i, (_e519 > 2147483500f)), (_e519 == _e519));
let _e2365 = (_e2364 - 1i);
let _e2366 = (_e2291 - 1i);
let _e2368 = select(0i, _e2366, (_e2366 > 0i));
let _e2371 = (_e2291 + 1i);
let _e2374 = (_e2291 + 2i);
let _e2377 = (_e2364 - 4i);
let _e2379 = select(0i, _e2377, (_e2377 > 0i));
let _e2381 = select(_e2379, _e2368, (_e2368 < _e2379));
let _e2394 = (select(0i, _e2306, (_e2306 > 0i)) * _e2326);
let _e2395 = (select(_e2339, _e2342, (_e2342 < _e2339)) * _e2326);
let _e2396 = (select(0i, _e2321, (_e2321 > 0i)) * _e2331);
let _e2397 = (select(_e2352, _e2355, (_e2355 < _e2352)) * _e2331);
local_4 = type_28(array<i32, 4>(_e2381, _e2381, _e2381, _e2381), array<u32, 6>(bitcast<u32>(((_e2368 - _e2381) * 8i)), bitcast<u32>(((select(0i, _e2291, (_e2291 > 0i)) - _e2381) * 8i)), bitcast<u32>(((select(_e2365, _e2371, (_e2371 < _e2365)) - _e2381) * 8i)), bitcast<u32>(((select(_e2365, _e2374, (_e2374 < _e2365)) - _e2381) * 8i)), 0u, 0u));
local_5 = vec3<f32>((_e524 - f32(_e2291)), (_e535 - f32(_e2306)), (_e546 - f32(_e2321)));
let _e2412 = local_4.member[0u];
let _e2413 = ((_e2396 + _e2394) + _e2412);
let _e2415 = (_e2413 >> bitcast<u32>(2i));
let _e2418 = bitcast<u32>(((_e2413 & 3i) * 8i));
let _e2420 = (bitcast<i32>(_e119) - 1i);
let _e2422 = select(_e2420, _e2415, (_e2415 < _e2420));
let _e2427 = global_1.member[bitcast<u32>(select(0i, _e2422, (_e2422 > 0i)))];
let _e2431 = (_e2415 + 1i);
let _e2433 = select(_e2420, _e2431, (_e2431 < _e2420));
let _e2438 = global_1.member[bitcast<u32>(select(0i, _e2433, (_e2433 > 0i)))];
let _e2445 = ((_e2427 >> bitcast<u32>((_e2418 & 31u))) | ((_e2438 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2418) & 31u))));
let _e2448 = local_4.member_1[1u];
let _e2454 = f32(bitcast<i32>(((_e2445 >> bitcast<u32>((_e2448 & 31u))) & 255u)));
let _e2457 = local_4.member_1[2u];
let _e2464 = local_5[0u];
let _e2467 = (_e2454 + ((f32(bitcast<i32>(((_e2445 >> bitcast<u32>((_e2457 & 31u))) & 255u))) - _e2454) * _e2464));
let _e2469 = local_4.member[0u];
let _e2470 = ((_e2396 + _e2395) + _e2469);
let _e2472 = (_e2470 >> bitcast<u32>(2i));
let _e2475 = bitcast<u32>(((_e2470 & 3i) * 8i));
let _e2477 = select(_e2420, _e2472, (_e2472 < _e2420));
let _e2482 = global_1.member[bitcast<u32>(select(0i, _e2477, (_e2477 > 0i)))];
let _e2486 = (_e2472 + 1i);
let _e2488 = select(_e2420, _e2486, (_e2486 < _e2420));
let _e2493 = global_1.member[bitcast<u32>(select(0i, _e2488, (_e2488 > 0i)))];
let _e2500 = ((_e2482 >> bitcast<u32>((_e2475 & 31u))) | ((_e2493 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2475) & 31u))));
let _e2501 = local_4.member_1[1u];
let _e2507 = f32(bitcast<i32>(((_e2500 >> bitcast<u32>((_e2501 & 31u))) & 255u)));
let _e2508 = local_4.member_1[2u];
let _e2515 = local_5[0u];
let _e2520 = local_5[1u];
let _e2523 = (_e2467 + (((_e2507 + ((f32(bitcast<i32>(((_e2500 >> bitcast<u32>((_e2508 & 31u))) & 255u))) - _e2507) * _e2515)) - _e2467) * _e2520));
let _e2525 = local_4.member[0u];
let _e2526 = ((_e2397 + _e2394) + _e2525);
let _e2528 = (_e2526 >> bitcast<u32>(2i));
let _e2531 = bitcast<u32>(((_e2526 & 3i) * 8i));
let _e2533 = select(_e2420, _e2528, (_e2528 < _e2420));
let _e2538 = global_1.member[bitcast<u32>(select(0i, _e2533, (_e2533 > 0i)))];
let _e2542 = (_e2528 + 1i);
let _e2544 = select(_e2420, _e2542, (_e2542 < _e2420));
let _e2549 = global_1.member[bitcast<u32>(select(0i, _e2544, (_e2544 > 0i)))];
let _e2556 = ((_e2538 >> bitcast<u32>((_e2531 & 31u))) | ((_e2549 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2531) & 31u))));
let _e2557 = local_4.member_1[1u];
let _e2563 = f32(bitcast<i32>(((_e2556 >> bitcast<u32>((_e2557 & 31u))) & 255u)));
let _e2564 = local_4.member_1[2u];
let _e2571 = local_5[0u];
let _e2574 = (_e2563 + ((f32(bitcast<i32>(((_e2556 >> bitcast<u32>((_e2564 & 31u))) & 255u))) - _e2563) * _e2571));
let _e2576 = local_4.member[0u];
let _e2577 = ((_e2397 + _e2395) + _e2576);
let _e2579 = (_e2577 >> bitcast<u32>(2i));
let _e2582 = bitcast<u32>(((_e2577 & 3i) * 8i));
let _e2584 = select(_e2420, _e2579, (_e2579 < _e2420));
let _e2589 = global_1.member[bitcast<u32>(select(0i, _e2584, (_e2584 > 0i)))];
let _e2593 = (_e2579 + 1i);
let _e2595 = select(_e2420, _e2593, (_e2593 < _e2420));
let _e2600 = global_1.member[bitcast<u32>(select(0i, _e2595, (_e2595 > 0i)))];
let _e2607 = ((_e2589 >> bitcast<u32>((_e2582 & 31u))) | ((_e2600 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2582) & 31u))));
let _e2608 = local_4.member_1[1u];
let _e2614 = f32(bitcast<i32>(((_e2607 >> bitcast<u32>((_e2608 & 31u))) & 255u)));
let _e2615 = local_4.member_1[2u];
let _e2622 = local_5[0u];
let _e2626 = local_5[1u];
let _e2631 = local_5[2u];
let _e2639 = global_5.member[_e352].member_6.member_5;
let _e2645 = global_5.member[_e352].member_6.member_6;
let _e2646 = (((_e2523 + (((_e2574 + (((_e2614 + ((f32(bitcast<i32>(((_e2607 >> bitcast<u32>((_e2615 & 31u))) & 255u))) - _e2614) * _e2622)) - _e2574) * _e2626)) - _e2523) * _e2631)) * _e2639) + _e2645);
let _e2648 = select(0f, _e2646, (_e2646 > 0f));
phi_4446_ = type_30(select(1f, _e2648, (_e2648 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2653 = phi_4446_;
let _e2657 = select(-0.5f, _e458, (_e458 > -0.5f));
let _e2659 = select(_e520, _e2657, (_e2657 < _e520));
let _e2661 = select(-0.5f, _e474, (_e474 > -0.5f));
let _e2663 = select(_e531, _e2661, (_e2661 < _e531));
let _e2665 = select(-0.5f, _e490, (_e490 > -0.5f));
let _e2667 = select(_e542, _e2665, (_e2665 < _e542));
let _e2669 = select(-1f, _e2659, (_e2659 > -1f));
let _e2671 = select(_e519, _e2669, (_e2669 < _e519));
let _e2678 = select(0i, select(select(i32(_e2671), i32(-2147483648), (_e2671 < -2147483600f)), 2147483647i, (_e2671 > 2147483500f)), (_e2671 == _e2671));
let _e2682 = (_e2678 - select(0i, 1i, (_e2671 < f32(_e2678))));
let _e2684 = select(-1f, _e2663, (_e2663 > -1f));
let _e2686 = select(_e530, _e2684, (_e2684 < _e530));
let _e2693 = select(0i, select(select(i32(_e2686), i32(-2147483648), (_e2686 < -2147483600f)), 2147483647i, (_e2686 > 2147483500f)), (_e2686 == _e2686));
let _e2697 = (_e2693 - select(0i, 1i, (_e2686 < f32(_e2693))));
let _e2699 = select(-1f, _e2667, (_e2667 > -1f));
let _e2701 = select(_e541, _e2699, (_e2699 < _e541));
let _e2708 = select(0i, select(select(i32(_e2701), i32(-2147483648), (_e2701 < -2147483600f)), 2147483647i, (_e2701 > 2147483500f)), (_e2701 == _e2701));
let _e2712 = (_e2708 - select(0i, 1i, (_e2701 < f32(_e2708))));
let _e2717 = global_5.member[_e352].member_6.member_7;
let _e2722 = global_5.member[_e352].member_6.member_8;
let _e2730 = (select(0i, select(select(i32(_e530), i32(-2147483648), (_e530 < -2147483600f)), 2147483647i, (_e530 > 2147483500f)), (_e530 == _e530)) - 1i);
let _e2733 = (_e2697 + 1i);
let _e2743 = (select(0i, select(select(i32(_e541), i32(-2147483648), (_e541 < -2147483600f)), 2147483647i, (_e541 > 2147483500f)), (_e541 == _e541)) - 1i);
let _e2746 = (_e2712 + 1i);
let _e2755 = select(0i, select(select(i32(_e519), i32(-2147483648), (_e519 < -2147483600f)), 2147483647i, (_e519 > 2147483500f)), (_e519 == _e519));
let _e2756 = (_e2755 - 1i);
let _e2757 = (_e2682 - 1i);
let _e2759 = select(0i, _e2757, (_e2757 > 0i));
let _e2762 = (_e2682 + 1i);
let _e2765 = (_e2682 + 2i);
let _e2768 = (_e2755 - 4i);
let _e2770 = select(0i, _e2768, (_e2768 > 0i));
let _e2772 = select(_e2770, _e2759, (_e2759 < _e2770));
let _e2785 = (select(0i, _e2697, (_e2697 > 0i)) * _e2717);
let _e2786 = (select(_e2730, _e2733, (_e2733 < _e2730)) * _e2717);
let _e2787 = (select(0i, _e2712, (_e2712 > 0i)) * _e2722);
let _e2788 = (select(_e2743, _e2746, (_e2746 < _e2743)) * _e2722);
local_2 = type_28(array<i32, 4>(_e2772, _e2772, _e2772, _e2772), array<u32, 6>(bitcast<u32>(((_e2759 - _e2772) * 8i)), bitcast<u32>(((select(0i, _e2682, (_e2682 > 0i)) - _e2772) * 8i)), bitcast<u32>(((select(_e2756, _e2762, (_e2762 < _e2756)) - _e2772) * 8i)), bitcast<u32>(((select(_e2756, _e2765, (_e2765 < _e2756)) - _e2772) * 8i)), 0u, 0u));
local_3 = vec3<f32>((_e2659 - f32(_e2682)), (_e2663 - f32(_e2697)), (_e2667 - f32(_e2712)));
let _e2803 = local_2.member[0u];
let _e2804 = ((_e2787 + _e2785) + _e2803);
let _e2806 = (_e2804 >> bitcast<u32>(2i));
let _e2809 = bitcast<u32>(((_e2804 & 3i) * 8i));
let _e2811 = (bitcast<i32>(_e119) - 1i);
let _e2813 = select(_e2811, _e2806, (_e2806 < _e2811));
let _e2818 = global_1.member[bitcast<u32>(select(0i, _e2813, (_e2813 > 0i)))];
let _e2822 = (_e2806 + 1i);
let _e2824 = select(_e2811, _e2822, (_e2822 < _e2811));
let _e2829 = global_1.member[bitcast<u32>(select(0i, _e2824, (_e2824 > 0i)))];
let _e2836 = ((_e2818 >> bitcast<u32>((_e2809 & 31u))) | ((_e2829 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2809) & 31u))));
let _e2839 = local_2.member_1[1u];
let _e2845 = f32(bitcast<i32>(((_e2836 >> bitcast<u32>((_e2839 & 31u))) & 255u)));
let _e2848 = local_2.member_1[2u];
let _e2855 = local_3[0u];
let _e2858 = (_e2845 + ((f32(bitcast<i32>(((_e2836 >> bitcast<u32>((_e2848 & 31u))) & 255u))) - _e2845) * _e2855));
let _e2860 = local_2.member[0u];
let _e2861 = ((_e2787 + _e2786) + _e2860);
let _e2863 = (_e2861 >> bitcast<u32>(2i));
let _e2866 = bitcast<u32>(((_e2861 & 3i) * 8i));
let _e2868 = select(_e2811, _e2863, (_e2863 < _e2811));
let _e2873 = global_1.member[bitcast<u32>(select(0i, _e2868, (_e2868 > 0i)))];
let _e2877 = (_e2863 + 1i);
let _e2879 = select(_e2811, _e2877, (_e2877 < _e2811));
let _e2884 = global_1.member[bitcast<u32>(select(0i, _e2879, (_e2879 > 0i)))];
let _e2891 = ((_e2873 >> bitcast<u32>((_e2866 & 31u))) | ((_e2884 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2866) & 31u))));
let _e2892 = local_2.member_1[1u];
let _e2898 = f32(bitcast<i32>(((_e2891 >> bitcast<u32>((_e2892 & 31u))) & 255u)));
let _e2899 = local_2.member_1[2u];
let _e2906 = local_3[0u];
let _e2911 = local_3[1u];
let _e2914 = (_e2858 + (((_e2898 + ((f32(bitcast<i32>(((_e2891 >> bitcast<u32>((_e2899 & 31u))) & 255u))) - _e2898) * _e2906)) - _e2858) * _e2911));
let _e2916 = local_2.member[0u];
let _e2917 = ((_e2788 + _e2785) + _e2916);
let _e2919 = (_e2917 >> bitcast<u32>(2i));
let _e2922 = bitcast<u32>(((_e2917 & 3i) * 8i));
let _e2924 = select(_e2811, _e2919, (_e2919 < _e2811));
let _e2929 = global_1.member[bitcast<u32>(select(0i, _e2924, (_e2924 > 0i)))];
let _e2933 = (_e2919 + 1i);
let _e2935 = select(_e2811, _e2933, (_e2933 < _e2811));
let _e2940 = global_1.member[bitcast<u32>(select(0i, _e2935, (_e2935 > 0i)))];
let _e2947 = ((_e2929 >> bitcast<u32>((_e2922 & 31u))) | ((_e2940 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2922) & 31u))));
let _e2948 = local_2.member_1[1u];
let _e2954 = f32(bitcast<i32>(((_e2947 >> bitcast<u32>((_e2948 & 31u))) & 255u)));
let _e2955 = local_2.member_1[2u];
let _e2962 = local_3[0u];
let _e2965 = (_e2954 + ((f32(bitcast<i32>(((_e2947 >> bitcast<u32>((_e2955 & 31u))) & 255u))) - _e2954) * _e2962));
let _e2967 = local_2.member[0u];
let _e2968 = ((_e2788 + _e2786) + _e2967);
let _e2970 = (_e2968 >> bitcast<u32>(2i));
let _e2973 = bitcast<u32>(((_e2968 & 3i) * 8i));
let _e2975 = select(_e2811, _e2970, (_e2970 < _e2811));
let _e2980 = global_1.member[bitcast<u32>(select(0i, _e2975, (_e2975 > 0i)))];
let _e2984 = (_e2970 + 1i);
let _e2986 = select(_e2811, _e2984, (_e2984 < _e2811));
let _e2991 = global_1.member[bitcast<u32>(select(0i, _e2986, (_e2986 > 0i)))];
let _e2998 = ((_e2980 >> bitcast<u32>((_e2973 & 31u))) | ((_e2991 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2973) & 31u))));
let _e2999 = local_2.member_1[1u];
let _e3005 = f32(bitcast<i32>(((_e2998 >> bitcast<u32>((_e2999 & 31u))) & 255u)));
let _e3006 = local_2.member_1[2u];
let _e3013 = local_3[0u];
let _e3017 = local_3[1u];
let _e3022 = local_3[2u];
let _e3030 = global_5.member[_e352].member_6.member_5;
let _e3036 = global_5.member[_e352].member_6.member_6;
let _e3037 = (((_e2914 + (((_e2965 + (((_e3005 + ((f32(bitcast<i32>(((_e2998 >> bitcast<u32>((_e3006 & 31u))) & 255u))) - _e3005) * _e3013)) - _e2965) * _e3017)) - _e2914) * _e3022)) * _e3030) + _e3036);
let _e3039 = select(0f, _e3037, (_e3037 > 0f));
let _e3041 = select(1f, _e3039, (_e3039 < 1f));
let _e3042 = select(_e356[5], _e3041, _e718);
if _e792 {
let _e3043 = (_e3041 * 1024f);
let _e3044 = (1024f - 1f);
let _e3046 = select(0f, _e3043, (_e3043 > 0f));
let _e3048 = select(_e3044, _e3046, (_e3046 < _e3044));
let _e3055 = select(0i, select(select(i32(_e3048), i32(-2147483648), (_e3048 < -2147483600f)), 2147483647i, (_e3048 > 2147483500f)), (_e3048 == _e3048));
let _e3059 = (_e3055 - select(0i, 1i, (_e3048 < f32(_e3055))));
let _e3060 = (262147i + _e3059);
let _e3062 = (bitcast<i32>(_e123) - 1i);
let _e3064 = select(_e3062, _e3060, (_e3060 < _e3062));
let _e3070 = global_3.member[bitcast<u32>(select(0i, _e3064, (_e3064 > 0i)))];
let _e3080 = select(_e3062, 262146i, (262146i < _e3062));
let _e3086 = global_3.member[bitcast<u32>(select(0i, _e3080, (_e3080 > 0i)))];
let _e3090 = select(_e3062, 262144i, (262144i < _e3062));
let _e3096 = global_3.member[bitcast<u32>(select(0i, _e3090, (_e3090 > 0i)))];
let _e3099 = select(_e3062, 262145i, (262145i < _e3062));
let _e3105 = global_3.member[bitcast<u32>(select(0i, _e3099, (_e3099 > 0i)))];
phi_5148_ = select(_e356[15], ((bitcast<f32>(_e3096) + (f32(bitcast<i32>((_e3070 >> bitcast<u32>(12u)))) * bitcast<f32>(_e3105))) + ((f32((bitcast<i32>((_e3070 & 4095u)) - 2048i)) * bitcast<f32>(_e3086)) * (_e3043 - f32(_e3059)))), _e718);
} else {
phi_5148_ = _e356[15];
}
let _e3115 = phi_5148_;
let _e3118 = select(1f, select(1f, _e787, (_e787 < 1f)), _e442);
if ((_e685 & 16u) == 0u) {
phi_5537_ = type_5(1f, 1f, 1f);
} else {
let _e3125 = global_5.member[_e352].member_14.member;
let _e3136 = ((((_e3125.member.member * _e377) + (_e3125.member.member_1 * _e380)) + (_e3125.member.member_2 * _e371)) + _e3125.member_1);
let _e3142 = ((((_e3125.member.member * _e382) + (_e3125.member.member_1 * _e384)) + (_e3125.member.member_2 * _e389)) + _e3125.member_1);
let _e3144 = select(_e3142, _e3136, (_e3136 < _e3142));
let _e3146 = select(_e3142, _e3136, (_e3136 > _e3142));
let _e3148 = (_e3146 - _e3144);
let _e3151 = (-(_e3144) / select(1e-30f, _e3148, (_e3148 > 1e-30f)));
let _e3153 = select(0f, _e3151, (_e3151 > 0f));
let _e3159 = select(select(select(1f, _e3153, (_e3153 < 1f)), 1f, (_e3146 <= 0f)), 0f, (_e3144 > 0f));
let _e3165 = global_5.member[_e352].member_14.member_1;
let _e3166 = (_e3165 != 0u);
let _e3177 = global_5.member[_e352].member_15.member;
let _e3188 = ((((_e3177.member.member * _e377) + (_e3177.member.member_1 * _e380)) + (_e3177.member.member_2 * _e371)) + _e3177.member_1);
let _e3194 = ((((_e3177.member.member * _e382) + (_e3177.member.member_1 * _e384)) + (_e3177.member.member_2 * _e389)) + _e3177.member_1);
let _e3196 = select(_e3194, _e3188, (_e3188 < _e3194));
let _e3198 = select(_e3194, _e3188, (_e3188 > _e3194));
let _e3200 = (_e3198 - _e3196);
let _e3203 = (-(_e3196) / select(1e-30f, _e3200, (_e3200 > 1e-30f)));
let _e3205 = select(0f, _e3203, (_e3203 > 0f));
let _e3211 = select(select(select(1f, _e3205, (_e3205 < 1f)), 1f, (_e3198 <= 0f)), 0f, (_e3196 > 0f));
let _e3217 = global_5.member[_e352].member_15.member_1;
let _e3218 = (_e3217 != 0u);
let _e3229 = global_5.member[_e352].member_16.member;
let _e3240 = ((((_e3229.member.member * _e377) + (_e3229.member.member_1 * _e380)) + (_e3229.member.member_2 * _e371)) + _e3229.member_1);
let _e3246 = ((((_e3229.member.member * _e382) + (_e3229.member.member_1 * _e384)) + (_e3229.member.member_2 * _e389)) + _e3229.member_1);
let _e3248 = select(_e3246, _e3240, (_e3240 < _e3246));
let _e3250 = select(_e3246, _e3240, (_e3240 > _e3246));
let _e3252 = (_e3250 - _e3248);
let _e3255 = (-(_e3248) / select(1e-30f, _e3252, (_e3252 > 1e-30f)));
let _e3257 = select(0f, _e3255, (_e3255 > 0f));
let _e3263 = select(select(select(1f, _e3257, (_e3257 < 1f)), 1f, (_e3250 <= 0f)), 0f, (_e3248 > 0f));
let _e3269 = global_5.member[_e352].member_16.member_1;
let _e3270 = (_e3269 != 0u);
let _e3281 = global_5.member[_e352].member_17.member;
let _e3292 = ((((_e3281.member.member * _e377) + (_e3281.member.member_1 * _e380)) + (_e3281.member.member_2 * _e371)) + _e3281.member_1);
let _e3298 = ((((_e3281.member.member * _e382) + (_e3281.member.member_1 * _e384)) + (_e3281.member.member_2 * _e389)) + _e3281.member_1);
let _e3300 = select(_e3298, _e3292, (_e3292 < _e3298));
let _e3302 = select(_e3298, _e3292, (_e3292 > _e3298));
let _e3304 = (_e3302 - _e3300);
let _e3307 = (-(_e3300) / select(1e-30f, _e3304, (_e3304 > 1e-30f)));
let _e3309 = select(0f, _e3307, (_e3307 > 0f));
let _e3315 = select(select(select(1f, _e3309, (_e3309 < 1f)), 1f, (_e3302 <= 0f)), 0f, (_e3300 > 0f));
let _e3321 = global_5.member[_e352].member_17.member_1;
let _e3322 = (_e3321 != 0u);
phi_5537_ = type_5(((((1f * _e3159) * _e3211) * _e3263) * _e3315), ((((1f * select(1f, _e3159, _e3166)) * select(1f, _e3211, _e3218)) * select(1f, _e3263, _e3270)) * select(1f, _e3315, _e3322)), ((((1f * select(1f, 0f, (_e3166 && (_e3142 > 0f)))) * select(1f, 0f, (_e3218 && (_e3194 > 0f)))) * select(1f, 0f, (_e3270 && (_e3246 > 0f)))) * select(1f, 0f, (_e3322 && (_e3298 > 0f)))));
}
let _e3331 = phi_5537_;
let _e3332 = (_e552 < 1e-12f);
let _e3334 = (1f / select(_e547, 1f, _e3332));
let _e3336 = ((-0.5f - _e458) * _e3334);
let _e3338 = ((_e520 - _e458) * _e3334);
let _e3344 = select(_e3338, _e3336, (_e3336 < _e3338));
let _e3346 = select(0f, _e3344, (_e3344 > 0f));
let _e3349 = select(select(1f, _e3346, (_e3346 < 1f)), select(2f, 0f, ((_e458 >= -0.5f) && (_e458 <= _e520))), _e3332);
let _e3351 = select(_e3338, _e3336, (_e3336 > _e3338));
let _e3353 = select(0f, _e3351, (_e3351 > 0f));
let _e3356 = select(select(1f, _e3353, (_e3353 < 1f)), 1f, _e3332);
let _e3357 = (_e555 < 1e-12f);
let _e3359 = (1f / select(_e548, 1f, _e3357));
let _e3361 = ((-0.5f - _e474) * _e3359);
let _e3363 = ((_e531 - _e474) * _e3359);
let _e3369 = select(_e3363, _e3361, (_e3361 < _e3363));
let _e3371 = select(0f, _e3369, (_e3369 > 0f));
let _e3374 = select(select(1f, _e3371, (_e3371 < 1f)), select(2f, 0f, ((_e474 >= -0.5f) && (_e474 <= _e531))), _e3357);
let _e3376 = select(_e3363, _e3361, (_e3361 > _e3363));
let _e3378 = select(0f, _e3376, (_e3376 > 0f));
let _e3381 = select(select(1f, _e3378, (_e3378 < 1f)), 1f, _e3357);
let _e3382 = (_e560 < 1e-12f);
let _e3384 = (1f / select(_e549, 1f, _e3382));
let _e3386 = ((-0.5f - _e490) * _e3384);
let _e3388 = ((_e542 - _e490) * _e3384);
let _e3394 = select(_e3388, _e3386, (_e3386 < _e3388));
let _e3396 = select(0f, _e3394, (_e3394 > 0f));
let _e3399 = select(select(1f, _e3396, (_e3396 < 1f)), select(2f, 0f, ((_e490 >= -0.5f) && (_e490 <= _e542))), _e3382);
let _e3401 = select(_e3388, _e3386, (_e3386 > _e3388));
let _e3403 = select(0f, _e3401, (_e3401 > 0f));
let _e3406 = select(select(1f, _e3403, (_e3403 < 1f)), 1f, _e3382);
let _e3408 = select(_e3381, _e3356, (_e3356 < _e3381));
let _e3412 = select(_e3374, _e3349, (_e3349 > _e3374));
let _e3415 = (select(_e3406, _e3408, (_e3408 < _e3406)) - select(_e3399, _e3412, (_e3412 > _e3399)));
let _e3418 = (_e382 - _e377);
let _e3419 = (_e384 - _e380);
let _e3420 = (_e389 - _e371);
let _e3425 = (((_e3418 * _e3418) + (_e3419 * _e3419)) + (_e3420 * _e3420));
let _e3435 = global_5.member[_e352].member_5.member_3;
let _e3436 = (((sqrt(select(0f, _e3425, (_e3425 > 0f))) * select(0f, _e3415, (_e3415 > 0f))) * _e3118) * _e3435);
let _e3437 = (_e729.member_2 >= 3u);
if _e3437 {
let _e3439 = (_e3042 * 255f);
let _e3440 = (_e2653.member * 255f);
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
let _e3479 = (_e3474 + 2i);
let _e3481 = (bitcast<i32>(_e123) - 1i);
let _e3483 = select(_e3481, _e3479, (_e3479 < _e3481));
let _e3489 = global_3.member[bitcast<u32>(select(0i, _e3483, (_e3483 > 0i)))];
let _e3490 = (_e3474 + 6i);
let _e3492 = select(_e3481, _e3490, (_e3490 < _e3481));
let _e3498 = global_3.member[bitcast<u32>(select(0i, _e3492, (_e3492 > 0i)))];
let _e3499 = (_e3474 + 1026i);
let _e3501 = select(_e3481, _e3499, (_e3499 < _e3481));
let _e3507 = global_3.member[bitcast<u32>(select(0i, _e3501, (_e3501 > 0i)))];
let _e3508 = (_e3474 + 1030i);
let _e3510 = select(_e3481, _e3508, (_e3508 < _e3481));
let _e3516 = global_3.member[bitcast<u32>(select(0i, _e3510, (_e3510 > 0i)))];
let _e3521 = (bitcast<f32>(((_e3489 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3529 = (_e3521 + (((bitcast<f32>(((_e3498 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3521) * _e3478));
let _e3534 = (bitcast<f32>(((_e3507 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3558 = (bitcast<f32>((((_e3489 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3566 = (_e3558 + (((bitcast<f32>((((_e3498 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3558) * _e3478));
let _e3571 = (bitcast<f32>((((_e3507 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3583 = (_e3474 + 3i);
let _e3585 = select(_e3481, _e3583, (_e3583 < _e3481));
let _e3591 = global_3.member[bitcast<u32>(select(0i, _e3585, (_e3585 > 0i)))];
let _e3592 = (_e3474 + 7i);
let _e3594 = select(_e3481, _e3592, (_e3592 < _e3481));
let _e3600 = global_3.member[bitcast<u32>(select(0i, _e3594, (_e3594 > 0i)))];
let _e3601 = (_e3474 + 1027i);
let _e3603 = select(_e3481, _e3601, (_e3601 < _e3481));
let _e3609 = global_3.member[bitcast<u32>(select(0i, _e3603, (_e3603 > 0i)))];
let _e3610 = (_e3474 + 1031i);
let _e3612 = select(_e3481, _e3610, (_e3610 < _e3481));
let _e3618 = global_3.member[bitcast<u32>(select(0i, _e3612, (_e3612 > 0i)))];
let _e3623 = (bitcast<f32>(((_e3591 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3631 = (_e3623 + (((bitcast<f32>(((_e3600 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3623) * _e3478));
let _e3636 = (bitcast<f32>(((_e3609 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3660 = (bitcast<f32>((((_e3591 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3668 = (_e3660 + (((bitcast<f32>((((_e3600 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3660) * _e3478));
let _e3673 = (bitcast<f32>((((_e3609 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3684 = (_e3668 + (((_e3673 + (((bitcast<f32>((((_e3618 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3673) * _e3478)) - _e3668) * _e3476));
let _e3688 = -((_e3684 * (_e3436 * _e3331.member)));
let _e3690 = select(-87f, _e3688, (_e3688 > -87f));
let _e3692 = select(88f, _e3690, (_e3690 < 88f));
let _e3694 = ((_e3692 * 1.442695f) + 0.5f);
let _e3696 = select(-127f, _e3694, (_e3694 > -127f));
let _e3698 = select(128f, _e3696, (_e3696 < 128f));
let _e3705 = select(0i, select(select(i32(_e3698), i32(-2147483648), (_e3698 < -2147483600f)), 2147483647i, (_e3698 > 2147483500f)), (_e3698 == _e3698));
let _e3709 = (_e3705 - select(0i, 1i, (_e3698 < f32(_e3705))));
let _e3710 = f32(_e3709);
let _e3714 = ((_e3692 - (_e3710 * 0.6933594f)) - (_e3710 * -2.1219444e-4f));
let _e3734 = ((1f + (_e3714 * (1f + (_e3714 * (0.5f + (_e3714 * (0.16666667f + (_e3714 * (0.041666668f + (_e3714 * (0.008333334f + (_e3714 * (0.001388889f + (_e3714 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3709 + 127i)) << bitcast<u32>(23i))));
let _e3735 = (1f - _e3734);
let _e3738 = (_e3735 / select(1e-12f, _e3684, (_e3684 > 1e-12f)));
phi_7095_ = type_31(_e3734, _e3735, vec3<f32>(1f, 1f, 1f), vec3<f32>(((_e3529 + (((_e3534 + (((bitcast<f32>(((_e3516 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3534) * _e3478)) - _e3529) * _e3476)) * _e3738), ((_e3566 + (((_e3571 + (((bitcast<f32>((((_e3516 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3571) * _e3478)) - _e3566) * _e3476)) * _e3738), ((_e3631 + (((_e3636 + (((bitcast<f32>(((_e3618 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3636) * _e3478)) - _e3631) * _e3476)) * _e3738)));
} else {
let _e3745 = (_e3042 * 255f);
let _e3746 = (_e2653.member * 255f);
let _e3747 = (255f - 1f);
let _e3749 = select(0f, _e3745, (_e3745 > 0f));
let _e3751 = select(_e3747, _e3749, (_e3749 < _e3747));
let _e3758 = select(0i, select(select(i32(_e3751), i32(-2147483648), (_e3751 < -2147483600f)), 2147483647i, (_e3751 > 2147483500f)), (_e3751 == _e3751));
let _e3762 = (_e3758 - select(0i, 1i, (_e3751 < f32(_e3758))));
let _e3764 = select(0f, _e3746, (_e3746 > 0f));
let _e3766 = select(_e3747, _e3764, (_e3764 < _e3747));
let _e3773 = select(0i, select(select(i32(_e3766), i32(-2147483648), (_e3766 < -2147483600f)), 2147483647i, (_e3766 > 2147483500f)), (_e3766 == _e3766));
let _e3777 = (_e3773 - select(0i, 1i, (_e3766 < f32(_e3773))));
let _e3780 = (((_e3762 * 256i) + _e3777) * 4i);
let _e3782 = (_e3745 - f32(_e3762));
let _e3784 = (_e3746 - f32(_e3777));
let _e3786 = (bitcast<i32>(_e123) - 1i);
let _e3788 = select(_e3786, _e3780, (_e3780 < _e3786));
let _e3794 = global_3.member[bitcast<u32>(select(0i, _e3788, (_e3788 > 0i)))];
let _e3795 = (_e3780 + 4i);
let _e3797 = select(_e3786, _e3795, (_e3795 < _e3786));
let _e3803 = global_3.member[bitcast<u32>(select(0i, _e3797, (_e3797 > 0i)))];
let _e3804 = (_e3780 + 1024i);
let _e3806 = select(_e3786, _e3804, (_e3804 < _e3786));
let _e3812 = global_3.member[bitcast<u32>(select(0i, _e3806, (_e3806 > 0i)))];
let _e3813 = (_e3780 + 1028i);
let _e3815 = select(_e3786, _e3813, (_e3813 < _e3786));
let _e3821 = global_3.member[bitcast<u32>(select(0i, _e3815, (_e3815 > 0i)))];
let _e3826 = (bitcast<f32>(((_e3794 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3834 = (_e3826 + (((bitcast<f32>(((_e3803 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3826) * _e3784));
let _e3839 = (bitcast<f32>(((_e3812 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3850 = (_e3834 + (((_e3839 + (((bitcast<f32>(((_e3821 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3839) * _e3784)) - _e3834) * _e3782));
let _e3863 = (bitcast<f32>((((_e3794 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3871 = (_e3863 + (((bitcast<f32>((((_e3803 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3863) * _e3784));
let _e3876 = (bitcast<f32>((((_e3812 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3888 = (_e3780 + 1i);
let _e3890 = select(_e3786, _e3888, (_e3888 < _e3786));
let _e3896 = global_3.member[bitcast<u32>(select(0i, _e3890, (_e3890 > 0i)))];
let _e3897 = (_e3780 + 5i);
let _e3899 = select(_e3786, _e3897, (_e3897 < _e3786));
let _e3905 = global_3.member[bitcast<u32>(select(0i, _e3899, (_e3899 > 0i)))];
let _e3906 = (_e3780 + 1025i);
let _e3908 = select(_e3786, _e3906, (_e3906 < _e3786));
let _e3914 = global_3.member[bitcast<u32>(select(0i, _e3908, (_e3908 > 0i)))];
let _e3915 = (_e3780 + 1029i);
let _e3917 = select(_e3786, _e3915, (_e3915 < _e3786));
let _e3923 = global_3.member[bitcast<u32>(select(0i, _e3917, (_e3917 > 0i)))];
let _e3928 = (bitcast<f32>(((_e3896 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3936 = (_e3928 + (((bitcast<f32>(((_e3905 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3928) * _e3784));
let _e3941 = (bitcast<f32>(((_e3914 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3965 = (bitcast<f32>((((_e3896 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3973 = (_e3965 + (((bitcast<f32>((((_e3905 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3965) * _e3784));
let _e3978 = (bitcast<f32>((((_e3914 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3990 = (_e3780 + 2i);
let _e3992 = select(_e3786, _e3990, (_e3990 < _e3786));
let _e3998 = global_3.member[bitcast<u32>(select(0i, _e3992, (_e3992 > 0i)))];
let _e3999 = (_e3780 + 6i);
let _e4001 = select(_e3786, _e3999, (_e3999 < _e3786));
let _e4007 = global_3.member[bitcast<u32>(select(0i, _e4001, (_e4001 > 0i)))];
let _e4008 = (_e3780 + 1026i);
let _e4010 = select(_e3786, _e4008, (_e4008 < _e3786));
let _e4016 = global_3.member[bitcast<u32>(select(0i, _e4010, (_e4010 > 0i)))];
let _e4017 = (_e3780 + 1030i);
let _e4019 = select(_e3786, _e4017, (_e4017 < _e3786));
let _e4025 = global_3.member[bitcast<u32>(select(0i, _e4019, (_e4019 > 0i)))];
let _e4030 = (bitcast<f32>(((_e3998 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4038 = (_e4030 + (((bitcast<f32>(((_e4007 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4030) * _e3784));
let _e4043 = (bitcast<f32>(((_e4016 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4067 = (bitcast<f32>((((_e3998 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4075 = (_e4067 + (((bitcast<f32>((((_e4007 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4067) * _e3784));
let _e4080 = (bitcast<f32>((((_e4016 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4092 = (_e3780 + 3i);
let _e4094 = select(_e3786, _e4092, (_e4092 < _e3786));
let _e4100 = global_3.member[bitcast<u32>(select(0i, _e4094, (_e4094 > 0i)))];
let _e4101 = (_e3780 + 7i);
let _e4103 = select(_e3786, _e4101, (_e4101 < _e3786));
let _e4109 = global_3.member[bitcast<u32>(select(0i, _e4103, (_e4103 > 0i)))];
let _e4110 = (_e3780 + 1027i);
let _e4112 = select(_e3786, _e4110, (_e4110 < _e3786));
let _e4118 = global_3.member[bitcast<u32>(select(0i, _e4112, (_e4112 > 0i)))];
let _e4119 = (_e3780 + 1031i);
let _e4121 = select(_e3786, _e4119, (_e4119 < _e3786));
let _e4127 = global_3.member[bitcast<u32>(select(0i, _e4121, (_e4121 > 0i)))];
let _e4132 = (bitcast<f32>(((_e4100 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4140 = (_e4132 + (((bitcast<f32>(((_e4109 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4132) * _e3784));
let _e4145 = (bitcast<f32>(((_e4118 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4160 = (_e3436 * _e3331.member_1);
let _e4162 = -(((_e3871 + (((_e3876 + (((bitcast<f32>((((_e3821 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3876) * _e3784)) - _e3871) * _e3782)) * _e4160));
let _e4164 = select(-87f, _e4162, (_e4162 > -87f));
let _e4166 = select(88f, _e4164, (_e4164 < 88f));
let _e4168 = ((_e4166 * 1.442695f) + 0.5f);
let _e4170 = select(-127f, _e4168, (_e4168 > -127f));
let _e4172 = select(128f, _e4170, (_e4170 < 128f));
let _e4179 = select(0i, select(select(i32(_e4172), i32(-2147483648), (_e4172 < -2147483600f)), 2147483647i, (_e4172 > 2147483500f)), (_e4172 == _e4172));
let _e4183 = (_e4179 - select(0i, 1i, (_e4172 < f32(_e4179))));
let _e4184 = f32(_e4183);
let _e4188 = ((_e4166 - (_e4184 * 0.6933594f)) - (_e4184 * -2.1219444e-4f));
let _e4210 = -(((_e3936 + (((_e3941 + (((bitcast<f32>(((_e3923 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3941) * _e3784)) - _e3936) * _e3782)) * _e4160));
let _e4212 = select(-87f, _e4210, (_e4210 > -87f));
let _e4214 = select(88f, _e4212, (_e4212 < 88f));
let _e4216 = ((_e4214 * 1.442695f) + 0.5f);
let _e4218 = select(-127f, _e4216, (_e4216 > -127f));
let _e4220 = select(128f, _e4218, (_e4218 < 128f));
let _e4227 = select(0i, select(select(i32(_e4220), i32(-2147483648), (_e4220 < -2147483600f)), 2147483647i, (_e4220 > 2147483500f)), (_e4220 == _e4220));
let _e4231 = (_e4227 - select(0i, 1i, (_e4220 < f32(_e4227))));
let _e4232 = f32(_e4231);
let _e4236 = ((_e4214 - (_e4232 * 0.6933594f)) - (_e4232 * -2.1219444e-4f));
let _e4258 = -(((_e3973 + (((_e3978 + (((bitcast<f32>((((_e3923 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3978) * _e3784)) - _e3973) * _e3782)) * _e4160));
let _e4260 = select(-87f, _e4258, (_e4258 > -87f));
let _e4262 = select(88f, _e4260, (_e4260 < 88f));
let _e4264 = ((_e4262 * 1.442695f) + 0.5f);
let _e4266 = select(-127f, _e4264, (_e4264 > -127f));
let _e4268 = select(128f, _e4266, (_e4266 < 128f));
let _e4275 = select(0i, select(select(i32(_e4268), i32(-2147483648), (_e4268 < -2147483600f)), 2147483647i, (_e4268 > 2147483500f)), (_e4268 == _e4268));
let _e4279 = (_e4275 - select(0i, 1i, (_e4268 < f32(_e4275))));
let _e4280 = f32(_e4279);
let _e4284 = ((_e4262 - (_e4280 * 0.6933594f)) - (_e4280 * -2.1219444e-4f));
let _e4307 = -((_e3850 * (_e3436 * _e3331.member)));
let _e4309 = select(-87f, _e4307, (_e4307 > -87f));
let _e4311 = select(88f, _e4309, (_e4309 < 88f));
let _e4313 = ((_e4311 * 1.442695f) + 0.5f);
let _e4315 = select(-127f, _e4313, (_e4313 > -127f));
let _e4317 = select(128f, _e4315, (_e4315 < 128f));
let _e4324 = select(0i, select(select(i32(_e4317), i32(-2147483648), (_e4317 < -2147483600f)), 2147483647i, (_e4317 > 2147483500f)), (_e4317 == _e4317));
let _e4328 = (_e4324 - select(0i, 1i, (_e4317 < f32(_e4324))));
let _e4329 = f32(_e4328);
let _e4333 = ((_e4311 - (_e4329 * 0.6933594f)) - (_e4329 * -2.1219444e-4f));
let _e4353 = ((1f + (_e4333 * (1f + (_e4333 * (0.5f + (_e4333 * (0.16666667f + (_e4333 * (0.041666668f + (_e4333 * (0.008333334f + (_e4333 * (0.001388889f + (_e4333 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4328 + 127i)) << bitcast<u32>(23i))));
let _e4354 = (1f - _e4353);
let _e4357 = (_e4354 / select(1e-12f, _e3850, (_e3850 > 1e-12f)));
phi_7095_ = type_31(_e4353, _e4354, vec3<f32>(((1f + (_e4188 * (1f + (_e4188 * (0.5f + (_e4188 * (0.16666667f + (_e4188 * (0.041666668f + (_e4188 * (0.008333334f + (_e4188 * (0.001388889f + (_e4188 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4183 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e4236 * (1f + (_e4236 * (0.5f + (_e4236 * (0.16666667f + (_e4236 * (0.041666668f + (_e4236 * (0.008333334f + (_e4236 * (0.001388889f + (_e4236 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4231 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e4284 * (1f + (_e4284 * (0.5f + (_e4284 * (0.16666667f + (_e4284 * (0.041666668f + (_e4284 * (0.008333334f + (_e4284 * (0.001388889f + (_e4284 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4279 + 127i)) << bitcast<u32>(23i))))), vec3<f32>(((_e4038 + (((_e4043 + (((bitcast<f32>(((_e4025 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4043) * _e3784)) - _e4038) * _e3782)) * _e4357), ((_e4075 + (((_e4080 + (((bitcast<f32>((((_e4025 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4080) * _e3784)) - _e4075) * _e3782)) * _e4357), ((_e4140 + (((_e4145 + (((bitcast<f32>(((_e4127 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4145) * _e3784)) - _e4140) * _e3782)) * _e4357)));
}
let _e4364 = phi_7095_;
let _e4365 = select(0f, _e3118, _e442);
let _e4369 = (_e377 + (_e3418 * _e4365));
let _e4370 = (_e380 + (_e3419 * _e4365));
let _e4371 = (_e371 + (_e3420 * _e4365));
if (_e729.member_2 == 3u) {
let _e4377 = global_5.member[_e352].member_9.member_1;
let _e4386 = global_5.member[_e352].member_9.member;
phi_8078_ = type_25(vec3<f32>(_e4377.member, _e4377.member_1, _e4377.member_2), vec3<f32>(_e4386.member, _e4386.member_1, _e4386.member_2));
} else {
let _e4396 = global_5.member[_e352].member_8.member_8;
let _e4397 = (_e4371 - _e4396);
let _e4402 = global_5.member[_e352].member_8.member_2;
let _e4407 = global_5.member[_e352].member_8.member_6;
let _e4415 = global_5.member[_e352].member_8.member_5;
let _e4417 = (((_e4369 - (_e4402 + (_e4407 * _e4397))) * _e4415) - 0.5f);
let _e4422 = global_5.member[_e352].member_8.member_3;
let _e4427 = global_5.member[_e352].member_8.member_7;
let _e4432 = (((_e4370 - (_e4422 + (_e4427 * _e4397))) * _e4415) - 0.5f);
let _e4437 = global_5.member[_e352].member_8.member;
let _e4438 = bitcast<i32>(_e4437);
let _e4440 = (f32(_e4438) - 1f);
let _e4445 = global_5.member[_e352].member_8.member_1;
let _e4448 = (f32(bitcast<i32>(_e4445)) - 1f);
let _e4450 = select(0f, _e4417, (_e4417 > 0f));
let _e4452 = select(_e4440, _e4450, (_e4450 < _e4440));
let _e4459 = select(0i, select(select(i32(_e4452), i32(-2147483648), (_e4452 < -2147483600f)), 2147483647i, (_e4452 > 2147483500f)), (_e4452 == _e4452));
let _e4463 = (_e4459 - select(0i, 1i, (_e4452 < f32(_e4459))));
let _e4465 = select(0f, _e4432, (_e4432 > 0f));
let _e4467 = select(_e4448, _e4465, (_e4465 < _e4448));
let _e4474 = select(0i, select(select(i32(_e4467), i32(-2147483648), (_e4467 < -2147483600f)), 2147483647i, (_e4467 > 2147483500f)), (_e4467 == _e4467));
let _e4478 = (_e4474 - select(0i, 1i, (_e4467 < f32(_e4474))));
let _e4482 = (_e4417 - f32(_e4463));
let _e4484 = (_e4432 - f32(_e4478));
let _e4491 = ((((_e4417 >= 0f) && (_e4417 <= _e4440)) && (_e4432 >= 0f)) && (_e4432 <= _e4448));
let _e4495 = global_5.member[_e352].member_4;
let _e4496 = bitcast<i32>(_e4495);
let _e4498 = bitcast<i32>((_e4437 * _e4445));
let _e4500 = (_e4496 + (3i * _e4498));
local_1 = (_e4500 + ((_e4478 * _e4438) + _e4463));
let _e4502 = local_1;
let _e4504 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e4506 = select(_e4504, _e4502, (_e4502 < _e4504));
let _e4511 = global_6.member[bitcast<u32>(select(0i, _e4506, (_e4506 > 0i)))];
let _e4512 = bitcast<u32>(_e4511);
let _e4516 = f32((bitcast<i32>((_e4512 & 65535u)) - 32768i));
let _e4522 = f32((bitcast<i32>(((_e4512 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4527 = select(_e4522, -(_e4522), ((_e4512 >> bitcast<u32>(31i)) != 0u));
let _e4528 = local_1;
let _e4529 = (_e4528 + 1i);
let _e4531 = select(_e4504, _e4529, (_e4529 < _e4504));
let _e4536 = global_6.member[bitcast<u32>(select(0i, _e4531, (_e4531 > 0i)))];
let _e4537 = bitcast<u32>(_e4536);
let _e4547 = f32((bitcast<i32>(((_e4537 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4553 = local_1;
let _e4554 = (_e4553 + _e4438);
let _e4556 = select(_e4504, _e4554, (_e4554 < _e4504));
let _e4561 = global_6.member[bitcast<u32>(select(0i, _e4556, (_e4556 > 0i)))];
let _e4562 = bitcast<u32>(_e4561);
let _e4566 = f32((bitcast<i32>((_e4562 & 65535u)) - 32768i));
let _e4572 = f32((bitcast<i32>(((_e4562 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4577 = select(_e4572, -(_e4572), ((_e4562 >> bitcast<u32>(31i)) != 0u));
let _e4578 = (_e4438 + 1i);
let _e4579 = local_1;
let _e4580 = (_e4579 + _e4578);
let _e4582 = select(_e4504, _e4580, (_e4580 < _e4504));
let _e4587 = global_6.member[bitcast<u32>(select(0i, _e4582, (_e4582 > 0i)))];
let _e4588 = bitcast<u32>(_e4587);
let _e4598 = f32((bitcast<i32>(((_e4588 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4606 = (_e4516 + ((f32((bitcast<i32>((_e4537 & 65535u)) - 32768i)) - _e4516) * _e4482));
let _e4615 = (_e4527 + ((select(_e4547, -(_e4547), ((_e4537 >> bitcast<u32>(31i)) != 0u)) - _e4527) * _e4482));
let _e4628 = global_5.member[_e352].member_9.member;
let _e4631 = (1f / 16255f);
let _e4633 = (_e4628.member + (select(0f, (_e4606 + (((_e4566 + ((f32((bitcast<i32>((_e4588 & 65535u)) - 32768i)) - _e4566) * _e4482)) - _e4606) * _e4484)), _e4491) * _e4631));
let _e4635 = (_e4628.member_1 + (select(0f, (_e4615 + (((_e4577 + ((select(_e4598, -(_e4598), ((_e4588 >> bitcast<u32>(31i)) != 0u)) - _e4577) * _e4482)) - _e4615) * _e4484)), _e4491) * _e4631));
let _e4639 = (1f - ((_e4633 * _e4633) + (_e4635 * _e4635)));
let _e4641 = select(1e-4f, _e4639, (_e4639 > 1e-4f));
let _e4644 = sqrt(select(0f, _e4641, (_e4641 > 0f)));
let _e4648 = (1f / select(1e-6f, _e4644, (_e4644 > 1e-6f)));
let _e4649 = ((_e4371 - _e371) * _e4415);
let _e4656 = (_e4417 - (((_e4633 * _e4648) - _e4407) * _e4649));
let _e4657 = (_e4432 - (((_e4635 * _e4648) - _e4427) * _e4649));
let _e4659 = select(0f, _e4656, (_e4656 > 0f));
let _e4661 = select(_e4440, _e4659, (_e4659 < _e4440));
let _e4668 = select(0i, select(select(i32(_e4661), i32(-2147483648), (_e4661 < -2147483600f)), 2147483647i, (_e4661 > 2147483500f)), (_e4661 == _e4661));
let _e4672 = (_e4668 - select(0i, 1i, (_e4661 < f32(_e4668))));
let _e4674 = select(0f, _e4657, (_e4657 > 0f));
let _e4676 = select(_e4448, _e4674, (_e4674 < _e4448));
let _e4683 = select(0i, select(select(i32(_e4676), i32(-2147483648), (_e4676 < -2147483600f)), 2147483647i, (_e4676 > 2147483500f)), (_e4676 == _e4676));
let _e4687 = (_e4683 - select(0i, 1i, (_e4676 < f32(_e4683))));
let _e4689 = ((_e4687 * _e4438) + _e4672);
let _e4691 = (_e4656 - f32(_e4672));
let _e4693 = (_e4657 - f32(_e4687));
let _e4700 = ((((_e4656 >= 0f) && (_e4656 <= _e4440)) && (_e4657 >= 0f)) && (_e4657 <= _e4448));
let _e4701 = (_e4496 + _e4689);
let _e4703 = select(_e4504, _e4701, (_e4701 < _e4504));
let _e4709 = global_6.member[bitcast<u32>(select(0i, _e4703, (_e4703 > 0i)))];
let _e4710 = (_e4701 + 1i);
let _e4712 = select(_e4504, _e4710, (_e4710 < _e4504));
let _e4718 = global_6.member[bitcast<u32>(select(0i, _e4712, (_e4712 > 0i)))];
let _e4721 = (_e4709 + ((_e4718 - _e4709) * _e4691));
let _e4722 = (_e4701 + _e4438);
let _e4724 = select(_e4504, _e4722, (_e4722 < _e4504));
let _e4730 = global_6.member[bitcast<u32>(select(0i, _e4724, (_e4724 > 0i)))];
let _e4731 = (_e4722 + 1i);
let _e4733 = select(_e4504, _e4731, (_e4731 < _e4504));
let _e4739 = global_6.member[bitcast<u32>(select(0i, _e4733, (_e4733 > 0i)))];
let _e4746 = select(1f, (_e4721 + (((_e4730 + ((_e4739 - _e4730) * _e4691)) - _e4721) * _e4693)), _e4700);
if _e3437 {
phi_7848_ = vec3(_e4746);
} else {
let _e4749 = ((_e4496 + _e4498) + _e4689);
let _e4751 = select(_e4504, _e4749, (_e4749 < _e4504));
let _e4757 = global_6.member[bitcast<u32>(select(0i, _e4751, (_e4751 > 0i)))];
let _e4758 = (_e4749 + 1i);
let _e4760 = select(_e4504, _e4758, (_e4758 < _e4504));
let _e4766 = global_6.member[bitcast<u32>(select(0i, _e4760, (_e4760 > 0i)))];
let _e4769 = (_e4757 + ((_e4766 - _e4757) * _e4691));
let _e4770 = (_e4749 + _e4438);
let _e4772 = select(_e4504, _e4770, (_e4770 < _e4504));
let _e4778 = global_6.member[bitcast<u32>(select(0i, _e4772, (_e4772 > 0i)))];
let _e4779 = (_e4770 + 1i);
let _e4781 = select(_e4504, _e4779, (_e4779 < _e4504));
let _e4787 = global_6.member[bitcast<u32>(select(0i, _e4781, (_e4781 > 0i)))];
let _e4797 = ((_e4496 + (2i * _e4498)) + _e4689);
let _e4799 = select(_e4504, _e4797, (_e4797 < _e4504));
let _e4805 = global_6.member[bitcast<u32>(select(0i, _e4799, (_e4799 > 0i)))];
let _e4806 = (_e4797 + 1i);
let _e4808 = select(_e4504, _e4806, (_e4806 < _e4504));
let _e4814 = global_6.member[bitcast<u32>(select(0i, _e4808, (_e4808 > 0i)))];
let _e4817 = (_e4805 + ((_e4814 - _e4805) * _e4691));
let _e4818 = (_e4797 + _e4438);
let _e4820 = select(_e4504, _e4818, (_e4818 < _e4504));
let _e4826 = global_6.member[bitcast<u32>(select(0i, _e4820, (_e4820 > 0i)))];
let _e4827 = (_e4818 + 1i);
let _e4829 = select(_e4504, _e4827, (_e4827 < _e4504));
let _e4835 = global_6.member[bitcast<u32>(select(0i, _e4829, (_e4829 > 0i)))];
phi_7848_ = vec3<f32>(_e4746, select(1f, (_e4769 + (((_e4778 + ((_e4787 - _e4778) * _e4691)) - _e4769) * _e4693)), _e4700), select(1f, (_e4817 + (((_e4826 + ((_e4835 - _e4826) * _e4691)) - _e4817) * _e4693)), _e4700));
}
let _e4845 = phi_7848_;
local = (_e4500 + _e4689);
let _e4847 = local;
let _e4849 = select(_e4504, _e4847, (_e4847 < _e4504));
let _e4854 = global_6.member[bitcast<u32>(select(0i, _e4849, (_e4849 > 0i)))];
let _e4855 = bitcast<u32>(_e4854);
let _e4859 = f32((bitcast<i32>((_e4855 & 65535u)) - 32768i));
let _e4865 = f32((bitcast<i32>(((_e4855 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4870 = select(_e4865, -(_e4865), ((_e4855 >> bitcast<u32>(31i)) != 0u));
let _e4871 = local;
let _e4872 = (_e4871 + 1i);
let _e4874 = select(_e4504, _e4872, (_e4872 < _e4504));
let _e4879 = global_6.member[bitcast<u32>(select(0i, _e4874, (_e4874 > 0i)))];
let _e4880 = bitcast<u32>(_e4879);
let _e4890 = f32((bitcast<i32>(((_e4880 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4896 = local;
let _e4897 = (_e4896 + _e4438);
let _e4899 = select(_e4504, _e4897, (_e4897 < _e4504));
let _e4904 = global_6.member[bitcast<u32>(select(0i, _e4899, (_e4899 > 0i)))];
let _e4905 = bitcast<u32>(_e4904);
let _e4909 = f32((bitcast<i32>((_e4905 & 65535u)) - 32768i));
let _e4915 = f32((bitcast<i32>(((_e4905 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4920 = select(_e4915, -(_e4915), ((_e4905 >> bitcast<u32>(31i)) != 0u));
let _e4921 = local;
let _e4922 = (_e4921 + _e4578);
let _e4924 = select(_e4504, _e4922, (_e4922 < _e4504));
let _e4929 = global_6.member[bitcast<u32>(select(0i, _e4924, (_e4924 > 0i)))];
let _e4930 = bitcast<u32>(_e4929);
let _e4940 = f32((bitcast<i32>(((_e4930 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4948 = (_e4859 + ((f32((bitcast<i32>((_e4880 & 65535u)) - 32768i)) - _e4859) * _e4691));
let _e4957 = (_e4870 + ((select(_e4890, -(_e4890), ((_e4880 >> bitcast<u32>(31i)) != 0u)) - _e4870) * _e4691));
let _e4970 = global_5.member[_e352].member_9.member_1;
let _e4977 = (_e4628.member + (select(0f, (_e4948 + (((_e4909 + ((f32((bitcast<i32>((_e4930 & 65535u)) - 32768i)) - _e4909) * _e4691)) - _e4948) * _e4693)), _e4700) * _e4631));
let _e4979 = (_e4628.member_1 + (select(0f, (_e4957 + (((_e4920 + ((select(_e4940, -(_e4940), ((_e4930 >> bitcast<u32>(31i)) != 0u)) - _e4920) * _e4691)) - _e4957) * _e4693)), _e4700) * _e4631));
let _e4983 = (1f - ((_e4977 * _e4977) + (_e4979 * _e4979)));
let _e4985 = select(1e-4f, _e4983, (_e4983 > 1e-4f));
phi_8078_ = type_25((_e4845 * vec3<f32>(_e4970.member, _e4970.member_1, _e4970.member_2)), vec3<f32>(_e4977, _e4979, sqrt(select(0f, _e4985, (_e4985 > 0f)))));
}
let _e4992 = phi_8078_;
let _e5001 = (((_e4992.member_1.x * _e4992.member_1.x) + (_e4992.member_1.y * _e4992.member_1.y)) + (_e4992.member_1.z * _e4992.member_1.z));
let _e5004 = sqrt(select(0f, _e5001, (_e5001 > 0f)));
let _e5010 = (1e-6f * _e5004);
let _e5014 = select((_e5004 / select(_e5010, _e4992.member_1.z, (_e4992.member_1.z > _e5010))), 1f, ((_e685 & 8u) != 0u));
let _e5016 = (_e4992.member.x * _e5014);
let _e5018 = (_e4992.member.y * _e5014);
let _e5020 = (_e4992.member.z * _e5014);
if _e792 {
let _e5025 = global_5.member[_e352].member_19;
let _e5034 = (((_e2653.member_1.x * _e2653.member_1.x) + (_e2653.member_1.y * _e2653.member_1.y)) + (_e2653.member_1.z * _e2653.member_1.z));
let _e5037 = sqrt(select(0f, _e5034, (_e5034 > 0f)));
let _e5040 = (1f / select(1e-20f, _e5037, (_e5037 > 1e-20f)));
let _e5041 = (_e2653.member_1.x * _e5040);
let _e5042 = (_e2653.member_1.y * _e5040);
let _e5043 = (_e2653.member_1.z * _e5040);
let _e5046 = (-1f / select(1e-20f, _e5004, (_e5004 > 1e-20f)));
let _e5047 = (_e4992.member_1.x * _e5046);
let _e5048 = (_e4992.member_1.y * _e5046);
let _e5049 = (_e4992.member_1.z * _e5046);
let _e5054 = (((_e356[2] * _e356[2]) + (_e356[3] * _e356[3])) + (_e356[4] * _e356[4]));
let _e5057 = sqrt(select(0f, _e5054, (_e5054 > 0f)));
let _e5060 = (-1f / select(1e-20f, _e5057, (_e5057 > 1e-20f)));
let _e5061 = (_e356[2] * _e5060);
let _e5062 = (_e356[3] * _e5060);
let _e5063 = (_e356[4] * _e5060);
let _e5070 = select(1f, -1f, ((((_e5041 * _e5061) + (_e5042 * _e5062)) + (_e5043 * _e5063)) < 0f));
let _e5071 = (_e5041 * _e5070);
let _e5072 = (_e5042 * _e5070);
let _e5073 = (_e5043 * _e5070);
let _e5078 = (((_e5071 * _e5061) + (_e5072 * _e5062)) + (_e5073 * _e5063));
let _e5080 = select(1e-4f, _e5078, (_e5078 > 1e-4f));
let _e5085 = (((_e5071 * _e5047) + (_e5072 * _e5048)) + (_e5073 * _e5049));
let _e5086 = (_e5047 + _e5061);
let _e5087 = (_e5048 + _e5062);
let _e5088 = (_e5049 + _e5063);
let _e5093 = (((_e5086 * _e5086) + (_e5087 * _e5087)) + (_e5088 * _e5088));
let _e5096 = sqrt(select(0f, _e5093, (_e5093 > 0f)));
let _e5099 = (1f / select(1e-6f, _e5096, (_e5096 > 1e-6f)));
let _e5100 = (_e5086 * _e5099);
let _e5101 = (_e5087 * _e5099);
let _e5102 = (_e5088 * _e5099);
let _e5107 = (((_e5071 * _e5100) + (_e5072 * _e5101)) + (_e5073 * _e5102));
let _e5109 = select(0f, _e5107, (_e5107 > 0f));
let _e5114 = (((_e5061 * _e5100) + (_e5062 * _e5101)) + (_e5063 * _e5102));
let _e5116 = select(0f, _e5114, (_e5114 > 0f));
let _e5117 = (_e5025 * _e5025);
let _e5118 = (_e5117 * _e5117);
let _e5122 = (((_e5109 * _e5109) * (_e5118 - 1f)) + 1f);
let _e5126 = (_e5085 > 0f);
let _e5127 = select(0f, _e5085, _e5126);
let _e5129 = (1f - _e5118);
let _e5131 = (((_e5127 * _e5127) * _e5129) + _e5118);
let _e5138 = (((_e5080 * _e5080) * _e5129) + _e5118);
let _e5143 = ((_e5080 * sqrt(select(0f, _e5131, (_e5131 > 0f)))) + (_e5127 * sqrt(select(0f, _e5138, (_e5138 > 0f)))));
let _e5148 = (_e2653.member_2 / _e3115);
let _e5152 = (((_e5148 * _e5148) - 1f) + (_e5116 * _e5116));
let _e5155 = sqrt(select(0f, _e5152, (_e5152 > 0f)));
let _e5156 = (_e5155 - _e5116);
let _e5157 = (_e5155 + _e5116);
let _e5160 = (_e5156 / select(1e-6f, _e5157, (_e5157 > 1e-6f)));
let _e5164 = ((_e5116 * _e5156) + 1f);
let _e5167 = (((_e5116 * _e5157) - 1f) / select(1e-6f, _e5164, (_e5164 > 1e-6f)));
let _e5185 = global_5.member[_e352].member_20;
let _e5189 = ((select(0f, ((((_e5118 / ((3.1415927f * _e5122) * _e5122)) * (0.5f / select(1e-6f, _e5143, (_e5143 > 1e-6f)))) * select(select((((0.5f * _e5160) * _e5160) * (1f + (_e5167 * _e5167))), 1f, (_e5152 <= 0f)), 0f, (_e3115 == _e2653.member_2))) * _e5127), (_e5126 && (_e5037 > 1e-12f))) * _e5185) * select(_e3331.member_2, 0f, _e442));
phi_8396_ = vec3<f32>((_e5016 * _e5189), (_e5018 * _e5189), (_e5020 * _e5189));
} else {
phi_8396_ = vec3<f32>(0f, 0f, 0f);
}
let _e5195 = phi_8396_;
let _e5206 = global_5.member[_e352].member_18;
let _e5213 = (1f - _e356[11]);
let _e5233 = (_e356[8] + ((_e356[12] * ((_e4364.member_3.x * (_e5016 + _e5206.member)) + _e5195.x)) * _e5213));
let _e5234 = (_e356[9] + ((_e356[13] * ((_e4364.member_3.y * (_e5018 + _e5206.member_1)) + _e5195.y)) * _e5213));
let _e5235 = (_e356[10] + ((_e356[14] * ((_e4364.member_3.z * (_e5020 + _e5206.member_2)) + _e5195.z)) * _e5213));
let _e5238 = (_e356[11] + (_e5213 * _e4364.member_1));
let _e5241 = (_e356[12] * _e4364.member_2.x);
let _e5243 = (_e356[13] * _e4364.member_2.y);
let _e5245 = (_e356[14] * _e4364.member_2.z);
let _e5251 = (_e356[7] + ((_e5238 - _e356[11]) * (_e371 + (_e3420 * 0.5f))));
let _e5260 = (-((((select(_e762.member, _e749.member, _e742) * _e4992.member_1.x) + (select(_e762.member_1, _e749.member_1, _e742) * _e4992.member_1.y)) + (select(_e762.member_2, _e749.member_2, _e742) * _e4992.member_1.z))) / select(1e-20f, _e5004, (_e5004 > 1e-20f)));
let _e5265 = bitcast<f32>((bitcast<u32>(select(0f, _e5260, (_e5260 > 0f))) & 2147483647u));
let _e5275 = (1f - _e5238);
let _e5288 = select(_e5238, 1f, _e442);
if _e792 {
let _e5297 = global_5.member[_e352].member_5.member_4;
let _e5300 = (_e2653.member_3.x * _e3331.member_2);
let _e5302 = (_e2653.member_3.y * _e3331.member_2);
let _e5304 = (_e2653.member_3.z * _e3331.member_2);
let _e5305 = (0.5f * _e366);
let _e5309 = (_e356[2] + (_e5300 * _e5305));
let _e5310 = (_e356[3] + (_e5302 * _e5305));
let _e5311 = (_e356[4] + (_e5304 * _e5305));
let _e5313 = (2f * _e365);
let _e5315 = ((_e5311 * _e5311) + (_e5313 * _e5304));
let _e5319 = (_e5311 + sqrt(select(0f, _e5315, (_e5315 > 0f))));
let _e5323 = (0.5f * (_e5313 / select(1e-6f, _e5319, (_e5319 > 1e-6f))));
let _e5327 = (_e5309 + (_e5300 * _e5323));
let _e5328 = (_e5310 + (_e5302 * _e5323));
let _e5329 = (_e5311 + (_e5304 * _e5323));
let _e5333 = (_e5297 * _e5297);
let _e5335 = (_e5329 * _e5329);
let _e5343 = (((_e5311 <= 0f) || (_e5315 <= 0f)) || ((_e5329 <= 0f) || (_e5335 <= (_e5333 * (((_e5327 * _e5327) + (_e5328 * _e5328)) + _e5335)))));
let _e5357 = (_e356[2] + ((_e2653.member_4.x * _e3331.member_2) * _e365));
let _e5358 = (_e356[3] + ((_e2653.member_4.y * _e3331.member_2) * _e365));
let _e5359 = (_e356[4] + ((_e2653.member_4.z * _e3331.member_2) * _e365));
let _e5361 = (_e5359 * _e5359);
let _e5370 = ((_e685 & 1u) != 0u);
phi_8705_ = select(select(_e5329, _e5311, _e5343), _e5359, _e5370);
phi_8706_ = select(select(_e5328, _e5310, _e5343), _e5358, _e5370);
phi_8707_ = select(select(_e5327, _e5309, _e5343), _e5357, _e5370);
phi_8708_ = select(_e5343, ((_e5359 <= 0f) || (_e5361 <= (_e5333 * (((_e5357 * _e5357) + (_e5358 * _e5358)) + _e5361)))), _e5370);
} else {
phi_8705_ = _e356[4];
phi_8706_ = _e356[3];
phi_8707_ = _e356[2];
phi_8708_ = false;
}
let _e5376 = phi_8705_;
let _e5378 = phi_8706_;
let _e5380 = phi_8707_;
let _e5382 = phi_8708_;
let _e5388 = (((_e442 || (_e5380 != _e356[2])) || (_e5378 != _e356[3])) || (_e5376 != _e356[4]));
let _e5390 = select(_e5243, _e5241, (_e5241 > _e5243));
phi_8768_ = array<f32, 18>(select(_e356[0], select(_e382, _e4369, _e442), _e5388), select(_e356[1], select(_e384, _e4370, _e442), _e5388), _e5380, _e5378, _e5376, _e2653.member, select(select(0f, 2f, _e5382), 1f, (_e442 || (((1f - _e5288) * select(_e5245, _e5390, (_e5390 > _e5245))) < 9.765625e-4f))), select(_e5251, (_e5251 + (_e5275 * _e4371)), _e442), select(_e5233, (_e5233 + ((_e5241 * (select(_e768.member, _e755.member, _e742) * ((_e5016 * _e5265) + _e5206.member))) * _e5275)), _e442), select(_e5234, (_e5234 + ((_e5243 * (select(_e768.member_1, _e755.member_1, _e742) * ((_e5018 * _e5265) + _e5206.member_1))) * _e5275)), _e442), select(_e5235, (_e5235 + ((_e5245 * (select(_e768.member_2, _e755.member_2, _e742) * ((_e5020 * _e5265) + _e5206.member_2))) * _e5275)), _e442), _e5288, _e5241, _e5243, _e5245, _e2653.member_2, select(_e356[16], select(_e389, _e4371, _e442), _e5388), _e389);
} else {
phi_8768_ = _e356;
}
let _e5409 = phi_8768_;
phi_583_ = (_e352 + 1u);
phi_586_ = select(_e354, true, _e725);
phi_588_ = _e5409;
} else {
phi_583_ = u32();
phi_586_ = bool();
phi_588_ = array<f32, 18>();
}
let _e5413 = phi_583_;
let _e5415 = phi_586_;
let _e5417 = phi_588_;
continue;
continuing {
phi_582_ = _e5413;
phi_585_ = _e5415;
phi_587_ = _e5417;
phi_8851_ = false;
break if !(_e357);
}
}
let _e5420 = phi_8851_;
if _e5420 {
break;
}
let _e5422 = local_8;
if _e5422 {
let _e5424 = local_9;
global_4.member[_e152] = _e5424[0];
let _e5429 = local_10;
global_4.member[_e164] = _e5429[1];
let _e5434 = local_11;
global_4.member[_e175] = _e5434[2];
let _e5439 = local_12;
global_4.member[_e186] = _e5439[3];
let _e5444 = local_13;
global_4.member[_e197] = _e5444[4];
let _e5449 = local_14;
global_4.member[_e208] = _e5449[5];
let _e5454 = local_15;
global_4.member[_e219] = _e5454[6];
let _e5459 = local_16;
global_4.member[_e230] = _e5459[7];
let _e5464 = local_17;
global_4.member[_e241] = _e5464[8];
let _e5469 = local_18;
global_4.member[_e252] = _e5469[9];
let _e5474 = local_19;
global_4.member[_e263] = _e5474[10];
let _e5479 = local_20;
global_4.member[_e274] = _e5479[11];
let _e5484 = local_21;
global_4.member[_e285] = _e5484[12];
let _e5489 = local_22;
global_4.member[_e296] = _e5489[13];
let _e5494 = local_23;
global_4.member[_e307] = _e5494[14];
let _e5499 = local_24;
global_4.member[_e318] = _e5499[15];
let _e5504 = local_25;
global_4.member[_e329] = _e5504[16];
let _e5509 = local_26;
global_4.member[_e340] = _e5509[17];
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
