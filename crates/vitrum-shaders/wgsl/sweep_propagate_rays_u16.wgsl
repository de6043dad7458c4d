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
var phi_3892_: type_29;
var phi_4670_: type_30;
var phi_5385_: f32;
var phi_5774_: type_5;
var phi_7332_: type_31;
var phi_8085_: vec3<f32>;
var phi_8315_: type_25;
var phi_8633_: vec3<f32>;
var phi_8938_: vec3<f32>;
var phi_8939_: bool;
var phi_9004_: array<f32, 18>;
var phi_583_: u32;
var phi_586_: bool;
var phi_588_: array<f32, 18>;
var phi_9087_: bool;
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
let _e112 = global;
let _e114 = arrayLength((&global_5.member));
let _e117 = arrayLength((&global_1.member));
let _e121 = arrayLength((&global_3.member));
if (0u < _e114) {
} else {
break;
}
let _e131 = global_5.member[0u].member_2;
let _e135 = global_5.member[0u].member;
let _e143 = (_e112.x + _e131.member);
let _e145 = (_e112.y + _e131.member_1);
if (_e143 < _e131.member_2) {
if (_e145 < _e131.member_3) {
let _e148 = (_e135.member * _e135.member_1);
let _e150 = ((_e145 * _e135.member) + _e143);
let _e151 = bitcast<i32>(_e150);
let _e153 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e155 = select(_e153, _e151, (_e151 < _e153));
let _e161 = global_4.member[bitcast<u32>(select(0i, _e155, (_e155 > 0i)))];
let _e162 = (_e148 + _e150);
let _e163 = bitcast<i32>(_e162);
let _e165 = select(_e153, _e163, (_e163 < _e153));
let _e171 = global_4.member[bitcast<u32>(select(0i, _e165, (_e165 > 0i)))];
let _e173 = ((2u * _e148) + _e150);
let _e174 = bitcast<i32>(_e173);
let _e176 = select(_e153, _e174, (_e174 < _e153));
let _e182 = global_4.member[bitcast<u32>(select(0i, _e176, (_e176 > 0i)))];
let _e184 = ((3u * _e148) + _e150);
let _e185 = bitcast<i32>(_e184);
let _e187 = select(_e153, _e185, (_e185 < _e153));
let _e193 = global_4.member[bitcast<u32>(select(0i, _e187, (_e187 > 0i)))];
let _e195 = ((4u * _e148) + _e150);
let _e196 = bitcast<i32>(_e195);
let _e198 = select(_e153, _e196, (_e196 < _e153));
let _e204 = global_4.member[bitcast<u32>(select(0i, _e198, (_e198 > 0i)))];
let _e206 = ((5u * _e148) + _e150);
let _e207 = bitcast<i32>(_e206);
let _e209 = select(_e153, _e207, (_e207 < _e153));
let _e215 = global_4.member[bitcast<u32>(select(0i, _e209, (_e209 > 0i)))];
let _e217 = ((6u * _e148) + _e150);
let _e218 = bitcast<i32>(_e217);
let _e220 = select(_e153, _e218, (_e218 < _e153));
let _e226 = global_4.member[bitcast<u32>(select(0i, _e220, (_e220 > 0i)))];
let _e228 = ((7u * _e148) + _e150);
let _e229 = bitcast<i32>(_e228);
let _e231 = select(_e153, _e229, (_e229 < _e153));
let _e237 = global_4.member[bitcast<u32>(select(0i, _e231, (_e231 > 0i)))];
let _e239 = ((8u * _e148) + _e150);
let _e240 = bitcast<i32>(_e239);
let _e242 = select(_e153, _e240, (_e240 < _e153));
let _e248 = global_4.member[bitcast<u32>(select(0i, _e242, (_e242 > 0i)))];
let _e250 = ((9u * _e148) + _e150);
let _e251 = bitcast<i32>(_e250);
let _e253 = select(_e153, _e251, (_e251 < _e153));
let _e259 = global_4.member[bitcast<u32>(select(0i, _e253, (_e253 > 0i)))];
let _e261 = ((10u * _e148) + _e150);
let _e262 = bitcast<i32>(_e261);
let _e264 = select(_e153, _e262, (_e262 < _e153));
let _e270 = global_4.member[bitcast<u32>(select(0i, _e264, (_e264 > 0i)))];
let _e272 = ((11u * _e148) + _e150);
let _e273 = bitcast<i32>(_e272);
let _e275 = select(_e153, _e273, (_e273 < _e153));
let _e281 = global_4.member[bitcast<u32>(select(0i, _e275, (_e275 > 0i)))];
let _e283 = ((12u * _e148) + _e150);
let _e284 = bitcast<i32>(_e283);
let _e286 = select(_e153, _e284, (_e284 < _e153));
let _e292 = global_4.member[bitcast<u32>(select(0i, _e286, (_e286 > 0i)))];
let _e294 = ((13u * _e148) + _e150);
let _e295 = bitcast<i32>(_e294);
let _e297 = select(_e153, _e295, (_e295 < _e153));
let _e303 = global_4.member[bitcast<u32>(select(0i, _e297, (_e297 > 0i)))];
let _e305 = ((14u * _e148) + _e150);
let _e306 = bitcast<i32>(_e305);
let _e308 = select(_e153, _e306, (_e306 < _e153));
let _e314 = global_4.member[bitcast<u32>(select(0i, _e308, (_e308 > 0i)))];
let _e316 = ((15u * _e148) + _e150);
let _e317 = bitcast<i32>(_e316);
let _e319 = select(_e153, _e317, (_e317 < _e153));
let _e325 = global_4.member[bitcast<u32>(select(0i, _e319, (_e319 > 0i)))];
let _e327 = ((16u * _e148) + _e150);
let _e328 = bitcast<i32>(_e327);
let _e330 = select(_e153, _e328, (_e328 < _e153));
let _e336 = global_4.member[bitcast<u32>(select(0i, _e330, (_e330 > 0i)))];
let _e338 = ((17u * _e148) + _e150);
let _e339 = bitcast<i32>(_e338);
let _e341 = select(_e153, _e339, (_e339 < _e153));
let _e347 = global_4.member[bitcast<u32>(select(0i, _e341, (_e341 > 0i)))];
phi_582_ = 0u;
phi_585_ = false;
phi_587_ = array<f32, 18>(_e161, _e171, _e182, _e193, _e204, _e215, _e226, _e237, _e248, _e259, _e270, _e281, _e292, _e303, _e314, _e325, _e336, _e347);
loop {
let _e350 = phi_582_;
let _e352 = phi_585_;
let _e354 = phi_587_;
local_8 = _e352;
local_9 = _e354;
local_10 = _e354;
local_11 = _e354;
local_12 = _e354;
local_13 = _e354;
local_14 = _e354;
local_15 = _e354;
local_16 = _e354;
local_17 = _e354;
local_18 = _e354;
local_19 = _e354;
local_20 = _e354;
local_21 = _e354;
local_22 = _e354;
local_23 = _e354;
local_24 = _e354;
local_25 = _e354;
local_26 = _e354;
let _e355 = (_e350 < _e114);
if _e355 {
if _e355 {
} else {
phi_9087_ = true;
break;
}
let _e368 = global_5.member[_e350].member_5.member_2;
let _e369 = (_e368 / _e354[5]);
let _e374 = global_5.member[_e350].member_5.member;
let _e376 = ((_e374 - _e354[2]) / _e354[5]);
let _e378 = (_e354[0] + (_e354[3] * _e376));
let _e380 = (_e354[1] + (_e354[4] * _e376));
let _e382 = (_e378 + (_e354[3] * _e369));
let _e384 = (_e380 + (_e354[4] * _e369));
let _e389 = global_5.member[_e350].member_5.member_1;
let _e395 = global_5.member[_e350].member_13.member.member;
let _e406 = ((((_e395.member.member * _e378) + (_e395.member.member_1 * _e380)) + (_e395.member.member_2 * _e374)) + _e395.member_1);
let _e412 = ((((_e395.member.member * _e382) + (_e395.member.member_1 * _e384)) + (_e395.member.member_2 * _e389)) + _e395.member_1);
let _e415 = ((_e406 > 0f) && (_e412 <= 0f));
let _e421 = global_5.member[_e350].member_13.member_1.member;
let _e432 = ((((_e421.member.member * _e378) + (_e421.member.member_1 * _e380)) + (_e421.member.member_2 * _e374)) + _e421.member_1);
let _e438 = ((((_e421.member.member * _e382) + (_e421.member.member_1 * _e384)) + (_e421.member.member_2 * _e389)) + _e421.member_1);
let _e441 = ((_e432 > 0f) && (_e438 <= 0f));
let _e442 = (_e415 || _e441);
let _e447 = global_5.member[_e350].member_6.member;
let _e458 = ((((_e447.member.member * _e378) + (_e447.member.member_1 * _e380)) + (_e447.member.member_2 * _e374)) + _e447.member_1);
let _e463 = global_5.member[_e350].member_6.member_1;
let _e474 = ((((_e463.member.member * _e378) + (_e463.member.member_1 * _e380)) + (_e463.member.member_2 * _e374)) + _e463.member_1);
let _e479 = global_5.member[_e350].member_6.member_2;
let _e490 = ((((_e479.member.member * _e378) + (_e479.member.member_1 * _e380)) + (_e479.member.member_2 * _e374)) + _e479.member_1);
let _e496 = ((((_e447.member.member * _e382) + (_e447.member.member_1 * _e384)) + (_e447.member.member_2 * _e389)) + _e447.member_1);
let _e502 = ((((_e463.member.member * _e382) + (_e463.member.member_1 * _e384)) + (_e463.member.member_2 * _e389)) + _e463.member_1);
let _e508 = ((((_e479.member.member * _e382) + (_e479.member.member_1 * _e384)) + (_e479.member.member_2 * _e389)) + _e479.member_1);
let _e513 = global_5.member[_e350].member_6.member_4;
let _e519 = global_5.member[_e350].member_6.member_3.member;
let _e520 = (_e519 - 0.5f);
let _e522 = select(-0.5f, _e496, (_e496 > -0.5f));
let _e524 = select(_e520, _e522, (_e522 < _e520));
let _e530 = global_5.member[_e350].member_6.member_3.member_1;
let _e531 = (_e530 - 0.5f);
let _e533 = select(-0.5f, _e502, (_e502 > -0.5f));
let _e535 = select(_e531, _e533, (_e533 < _e531));
let _e541 = global_5.member[_e350].member_6.member_3.member_2;
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
let _e602 = global_5.member[_e350].member_6.member_12;
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
let _e649 = global_5.member[_e350].member_6.member_9.member;
let _e656 = global_5.member[_e350].member_6.member_9.member_1;
let _e662 = global_5.member[_e350].member_6.member_10;
let _e668 = ((bitcast<i32>(_e662) + ((_e593 - select(0i, 1i, (_e586 < f32(_e593)))) >> bitcast<u32>(_e603))) + (bitcast<i32>(_e649) * (((_e618 - select(0i, 1i, (_e611 < f32(_e618)))) >> bitcast<u32>(_e603)) + (bitcast<i32>(_e656) * ((_e637 - select(0i, 1i, (_e630 < f32(_e637)))) >> bitcast<u32>(_e603))))));
let _e670 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e672 = select(_e670, _e668, (_e668 < _e670));
let _e678 = global_2.member[bitcast<u32>(select(0i, _e672, (_e672 > 0i)))];
let _e685 = global_5.member[_e350].member_1;
let _e717 = (_e354[17] != _e374);
let _e723 = (select(0u, select(select(select(select(7u, 3u, (((((((_e458 >= 0f) && (_e458 <= _e582)) && (_e474 >= 0f)) && (_e474 <= _e607)) && (_e490 >= 0f)) && (_e490 <= _e626)) && ((((((_e496 >= 0f) && (_e496 <= _e582)) && (_e502 >= 0f)) && (_e502 <= _e607)) && (_e508 >= 0f)) && (_e508 <= _e626)))), 15u, _e717), 1u, (((_e685 & 64u) != 0u) || ((((select(_e560, _e557, (_e557 > _e560)) <= _e513) && ((select(_e577, _e574, (_e574 > _e577)) > _e513) || (_e678 != 0u))) && true) && ((_e685 & 32u) != 0u)))), 31u, _e442), (_e354[7] == 0f)) > 1u);
if _e723 {
let _e727 = global_5.member[_e350].member;
let _e740 = (_e406 - _e412);
let _e743 = (_e406 / select(1e-20f, _e740, (_e740 > 1e-20f)));
let _e744 = (_e432 - _e438);
let _e747 = (_e432 / select(1e-20f, _e744, (_e744 > 1e-20f)));
let _e751 = (_e441 && (!(_e415) || (_e747 < _e743)));
let _e758 = global_5.member[_e350].member_13.member_1.member.member;
let _e764 = global_5.member[_e350].member_13.member_1.member_1;
let _e771 = global_5.member[_e350].member_13.member.member.member;
let _e777 = global_5.member[_e350].member_13.member.member_1;
let _e796 = select(_e743, _e747, _e751);
let _e798 = (_e727.member_2 == 2u);
let _e801 = (((_e727.member_2 == 1u) || _e798) || (_e727.member_2 == 5u));
if _e801 {
let _e803 = select(-1f, _e524, (_e524 > -1f));
let _e805 = select(_e519, _e803, (_e803 < _e519));
let _e812 = select(0i, select(select(i32(_e805), i32(-2147483648), (_e805 < -2147483600f)), 2147483647i, (_e805 > 2147483500f)), (_e805 == _e805));
let _e816 = (_e812 - select(0i, 1i, (_e805 < f32(_e812))));
let _e818 = select(-1f, _e535, (_e535 > -1f));
let _e820 = select(_e530, _e818, (_e818 < _e530));
let _e827 = select(0i, select(select(i32(_e820), i32(-2147483648), (_e820 < -2147483600f)), 2147483647i, (_e820 > 2147483500f)), (_e820 == _e820));
let _e831 = (_e827 - select(0i, 1i, (_e820 < f32(_e827))));
let _e833 = select(-1f, _e546, (_e546 > -1f));
let _e835 = select(_e541, _e833, (_e833 < _e541));
let _e842 = select(0i, select(select(i32(_e835), i32(-2147483648), (_e835 < -2147483600f)), 2147483647i, (_e835 > 2147483500f)), (_e835 == _e835));
let _e846 = (_e842 - select(0i, 1i, (_e835 < f32(_e842))));
let _e851 = global_5.member[_e350].member_6.member_7;
let _e856 = global_5.member[_e350].member_6.member_8;
let _e864 = (select(0i, select(select(i32(_e530), i32(-2147483648), (_e530 < -2147483600f)), 2147483647i, (_e530 > 2147483500f)), (_e530 == _e530)) - 1i);
let _e865 = (_e831 - 1i);
let _e870 = (_e831 + 1i);
let _e873 = (_e831 + 2i);
let _e883 = (select(0i, select(select(i32(_e541), i32(-2147483648), (_e541 < -2147483600f)), 2147483647i, (_e541 > 2147483500f)), (_e541 == _e541)) - 1i);
let _e884 = (_e846 - 1i);
let _e889 = (_e846 + 1i);
let _e892 = (_e846 + 2i);
let _e901 = select(0i, select(select(i32(_e519), i32(-2147483648), (_e519 < -2147483600f)), 2147483647i, (_e519 > 2147483500f)), (_e519 == _e519));
let _e902 = (_e901 - 1i);
let _e903 = (_e816 - 1i);
let _e905 = select(0i, _e903, (_e903 > 0i));
let _e907 = select(0i, _e816, (_e816 > 0i));
let _e908 = (_e816 + 1i);
let _e910 = select(_e902, _e908, (_e908 < _e902));
let _e911 = (_e816 + 2i);
let _e914 = (_e901 - 2i);
let _e916 = select(0i, _e914, (_e914 > 0i));
let _e918 = select(_e916, _e905, (_e905 < _e916));
let _e920 = select(_e916, _e907, (_e907 < _e916));
let _e922 = select(_e916, _e910, (_e910 < _e916));
let _e941 = (select(0i, _e865, (_e865 > 0i)) * _e851);
let _e942 = (select(0i, _e831, (_e831 > 0i)) * _e851);
let _e943 = (select(_e864, _e870, (_e870 < _e864)) * _e851);
let _e944 = (select(_e864, _e873, (_e873 < _e864)) * _e851);
let _e945 = (select(0i, _e884, (_e884 > 0i)) * _e856);
let _e946 = (select(0i, _e846, (_e846 > 0i)) * _e856);
let _e947 = (select(_e883, _e889, (_e889 < _e883)) * _e856);
let _e948 = (select(_e883, _e892, (_e892 < _e883)) * _e856);
local_6 = type_28(array<i32, 4>(_e918, _e920, _e922, 0i), array<u32, 6>(bitcast<u32>(((_e905 - _e918) * 16i)), bitcast<u32>(((_e907 - _e918) * 16i)), bitcast<u32>(((_e907 - _e920) * 16i)), bitcast<u32>(((_e910 - _e920) * 16i)), bitcast<u32>(((_e910 - _e922) * 16i)), bitcast<u32>(((select(_e902, _e911, (_e911 < _e902)) - _e922) * 16i))));
local_7 = vec3<f32>((_e524 - f32(_e816)), (_e535 - f32(_e831)), (_e546 - f32(_e846)));
let _e960 = (_e946 + _e942);
let _e963 = local_6.member[0u];
let _e964 = (_e960 + _e963);
let _e966 = (_e964 >> bitcast<u32>(1i));
let _e969 = bitcast<u32>(((_e964 & 1i) * 16i));
let _e971 = (bitcast<i32>(_e117) - 1i);
let _e973 = select(_e971, _e966, (_e966 < _e971));
let _e978 = global_1.member[bitcast<u32>(select(0i, _e973, (_e973 > 0i)))];
let _e982 = (_e966 + 1i);
let _e984 = select(_e971, _e982, (_e982 < _e971));
let _e989 = global_1.member[bitcast<u32>(select(0i, _e984, (_e984 > 0i)))];
let _e996 = ((_e978 >> bitcast<u32>((_e969 & 31u))) | ((_e989 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e969) & 31u))));
let _e999 = local_6.member[2u];
let _e1000 = (_e960 + _e999);
let _e1002 = (_e1000 >> bitcast<u32>(1i));
let _e1005 = bitcast<u32>(((_e1000 & 1i) * 16i));
let _e1007 = select(_e971, _e1002, (_e1002 < _e971));
let _e1012 = global_1.member[bitcast<u32>(select(0i, _e1007, (_e1007 > 0i)))];
let _e1016 = (_e1002 + 1i);
let _e1018 = select(_e971, _e1016, (_e1016 < _e971));
let _e1023 = global_1.member[bitcast<u32>(select(0i, _e1018, (_e1018 > 0i)))];
let _e1030 = ((_e1012 >> bitcast<u32>((_e1005 & 31u))) | ((_e1023 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1005) & 31u))));
let _e1033 = local_6.member_1[0u];
let _e1039 = f32(bitcast<i32>(((_e996 >> bitcast<u32>((_e1033 & 31u))) & 65535u)));
let _e1042 = local_6.member_1[1u];
let _e1048 = f32(bitcast<i32>(((_e996 >> bitcast<u32>((_e1042 & 31u))) & 65535u)));
let _e1051 = local_6.member_1[4u];
let _e1057 = f32(bitcast<i32>(((_e1030 >> bitcast<u32>((_e1051 & 31u))) & 65535u)));
let _e1060 = local_6.member_1[5u];
let _e1067 = local_7[0u];
let _e1070 = (_e1039 + ((_e1048 - _e1039) * _e1067));
let _e1071 = local_7[0u];
let _e1074 = (_e1048 + ((_e1057 - _e1048) * _e1071));
let _e1075 = local_7[0u];
let _e1078 = (_e1057 + ((f32(bitcast<i32>(((_e1030 >> bitcast<u32>((_e1060 & 31u))) & 65535u))) - _e1057) * _e1075));
let _e1079 = (_e946 + _e943);
let _e1080 = local_6.member[0u];
let _e1081 = (_e1079 + _e1080);
let _e1083 = (_e1081 >> bitcast<u32>(1i));
let _e1086 = bitcast<u32>(((_e1081 & 1i) * 16i));
let _e1088 = select(_e971, _e1083, (_e1083 < _e971));
let _e1093 = global_1.member[bitcast<u32>(select(0i, _e1088, (_e1088 > 0i)))];
let _e1097 = (_e1083 + 1i);
let _e1099 = select(_e971, _e1097, (_e1097 < _e971));
let _e1104 = global_1.member[bitcast<u32>(select(0i, _e1099, (_e1099 > 0i)))];
let _e1111 = ((_e1093 >> bitcast<u32>((_e1086 & 31u))) | ((_e1104 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1086) & 31u))));
let _e1112 = local_6.member[2u];
let _e1113 = (_e1079 + _e1112);
let _e1115 = (_e1113 >> bitcast<u32>(1i));
let _e1118 = bitcast<u32>(((_e1113 & 1i) * 16i));
let _e1120 = select(_e971, _e1115, (_e1115 < _e971));
let _e1125 = global_1.member[bitcast<u32>(select(0i, _e1120, (_e1120 > 0i)))];
let _e1129 = (_e1115 + 1i);
let _e1131 = select(_e971, _e1129, (_e1129 < _e971));
let _e1136 = global_1.member[bitcast<u32>(select(0i, _e1131, (_e1131 > 0i)))];
let _e1143 = ((_e1125 >> bitcast<u32>((_e1118 & 31u))) | ((_e1136 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1118) & 31u))));
let _e1144 = local_6.member_1[0u];
let _e1150 = f32(bitcast<i32>(((_e1111 >> bitcast<u32>((_e1144 & 31u))) & 65535u)));
let _e1151 = local_6.member_1[1u];
let _e1157 = f32(bitcast<i32>(((_e1111 >> bitcast<u32>((_e1151 & 31u))) & 65535u)));
let _e1158 = local_6.member_1[4u];
let _e1164 = f32(bitcast<i32>(((_e1143 >> bitcast<u32>((_e1158 & 31u))) & 65535u)));
let _e1165 = local_6.member_1[5u];
let _e1172 = local_7[0u];
let _e1176 = local_7[0u];
let _e1179 = (_e1157 + ((_e1164 - _e1157) * _e1176));
let _e1180 = local_7[0u];
let _e1184 = (_e947 + _e942);
let _e1185 = local_6.member[0u];
let _e1186 = (_e1184 + _e1185);
let _e1188 = (_e1186 >> bitcast<u32>(1i));
let _e1191 = bitcast<u32>(((_e1186 & 1i) * 16i));
let _e1193 = select(_e971, _e1188, (_e1188 < _e971));
let _e1198 = global_1.member[bitcast<u32>(select(0i, _e1193, (_e1193 > 0i)))];
let _e1202 = (_e1188 + 1i);
let _e1204 = select(_e971, _e1202, (_e1202 < _e971));
let _e1209 = global_1.member[bitcast<u32>(select(0i, _e1204, (_e1204 > 0i)))];
let _e1216 = ((_e1198 >> bitcast<u32>((_e1191 & 31u))) | ((_e1209 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1191) & 31u))));
let _e1217 = local_6.member[2u];
let _e1218 = (_e1184 + _e1217);
let _e1220 = (_e1218 >> bitcast<u32>(1i));
let _e1223 = bitcast<u32>(((_e1218 & 1i) * 16i));
let _e1225 = select(_e971, _e1220, (_e1220 < _e971));
let _e1230 = global_1.member[bitcast<u32>(select(0i, _e1225, (_e1225 > 0i)))];
let _e1234 = (_e1220 + 1i);
let _e1236 = select(_e971, _e1234, (_e1234 < _e971));
let _e1241 = global_1.member[bitcast<u32>(select(0i, _e1236, (_e1236 > 0i)))];
let _e1248 = ((_e1230 >> bitcast<u32>((_e1223 & 31u))) | ((_e1241 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1223) & 31u))));
let _e1249 = local_6.member_1[0u];
let _e1255 = f32(bitcast<i32>(((_e1216 >> bitcast<u32>((_e1249 & 31u))) & 65535u)));
let _e1256 = local_6.member_1[1u];
let _e1262 = f32(bitcast<i32>(((_e1216 >> bitcast<u32>((_e1256 & 31u))) & 65535u)));
let _e1263 = local_6.member_1[4u];
let _e1269 = f32(bitcast<i32>(((_e1248 >> bitcast<u32>((_e1263 & 31u))) & 65535u)));
let _e1270 = local_6.member_1[5u];
let _e1277 = local_7[0u];
let _e1280 = (_e1255 + ((_e1262 - _e1255) * _e1277));
let _e1281 = local_7[0u];
let _e1284 = (_e1262 + ((_e1269 - _e1262) * _e1281));
let _e1285 = local_7[0u];
let _e1288 = (_e1269 + ((f32(bitcast<i32>(((_e1248 >> bitcast<u32>((_e1270 & 31u))) & 65535u))) - _e1269) * _e1285));
let _e1289 = (_e947 + _e943);
let _e1290 = local_6.member[0u];
let _e1291 = (_e1289 + _e1290);
let _e1293 = (_e1291 >> bitcast<u32>(1i));
let _e1296 = bitcast<u32>(((_e1291 & 1i) * 16i));
let _e1298 = select(_e971, _e1293, (_e1293 < _e971));
let _e1303 = global_1.member[bitcast<u32>(select(0i, _e1298, (_e1298 > 0i)))];
let _e1307 = (_e1293 + 1i);
let _e1309 = select(_e971, _e1307, (_e1307 < _e971));
let _e1314 = global_1.member[bitcast<u32>(select(0i, _e1309, (_e1309 > 0i)))];
let _e1321 = ((_e1303 >> bitcast<u32>((_e1296 & 31u))) | ((_e1314 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1296) & 31u))));
let _e1322 = local_6.member[2u];
let _e1323 = (_e1289 + _e1322);
let _e1325 = (_e1323 >> bitcast<u32>(1i));
let _e1328 = bitcast<u32>(((_e1323 & 1i) * 16i));
let _e1330 = select(_e971, _e1325, (_e1325 < _e971));
let _e1335 = global_1.member[bitcast<u32>(select(0i, _e1330, (_e1330 > 0i)))];
let _e1339 = (_e1325 + 1i);
let _e1341 = select(_e971, _e1339, (_e1339 < _e971));
let _e1346 = global_1.member[bitcast<u32>(select(0i, _e1341, (_e1341 > 0i)))];
let _e1353 = ((_e1335 >> bitcast<u32>((_e1328 & 31u))) | ((_e1346 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1328) & 31u))));
let _e1354 = local_6.member_1[0u];
let _e1360 = f32(bitcast<i32>(((_e1321 >> bitcast<u32>((_e1354 & 31u))) & 65535u)));
let _e1361 = local_6.member_1[1u];
let _e1367 = f32(bitcast<i32>(((_e1321 >> bitcast<u32>((_e1361 & 31u))) & 65535u)));
let _e1368 = local_6.member_1[4u];
let _e1374 = f32(bitcast<i32>(((_e1353 >> bitcast<u32>((_e1368 & 31u))) & 65535u)));
let _e1375 = local_6.member_1[5u];
let _e1382 = local_7[0u];
let _e1386 = local_7[0u];
let _e1389 = (_e1367 + ((_e1374 - _e1367) * _e1386));
let _e1390 = local_7[0u];
let _e1397 = local_6.member[1u];
let _e1398 = ((_e946 + _e941) + _e1397);
let _e1400 = (_e1398 >> bitcast<u32>(1i));
let _e1403 = bitcast<u32>(((_e1398 & 1i) * 16i));
let _e1405 = select(_e971, _e1400, (_e1400 < _e971));
let _e1410 = global_1.member[bitcast<u32>(select(0i, _e1405, (_e1405 > 0i)))];
let _e1414 = (_e1400 + 1i);
let _e1416 = select(_e971, _e1414, (_e1414 < _e971));
let _e1421 = global_1.member[bitcast<u32>(select(0i, _e1416, (_e1416 > 0i)))];
let _e1428 = ((_e1410 >> bitcast<u32>((_e1403 & 31u))) | ((_e1421 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1403) & 31u))));
let _e1431 = local_6.member_1[2u];
let _e1437 = f32(bitcast<i32>(((_e1428 >> bitcast<u32>((_e1431 & 31u))) & 65535u)));
let _e1440 = local_6.member_1[3u];
let _e1447 = local_7[0u];
let _e1450 = (_e1437 + ((f32(bitcast<i32>(((_e1428 >> bitcast<u32>((_e1440 & 31u))) & 65535u))) - _e1437) * _e1447));
let _e1452 = local_6.member[1u];
let _e1453 = ((_e946 + _e944) + _e1452);
let _e1455 = (_e1453 >> bitcast<u32>(1i));
let _e1458 = bitcast<u32>(((_e1453 & 1i) * 16i));
let _e1460 = select(_e971, _e1455, (_e1455 < _e971));
let _e1465 = global_1.member[bitcast<u32>(select(0i, _e1460, (_e1460 > 0i)))];
let _e1469 = (_e1455 + 1i);
let _e1471 = select(_e971, _e1469, (_e1469 < _e971));
let _e1476 = global_1.member[bitcast<u32>(select(0i, _e1471, (_e1471 > 0i)))];
let _e1483 = ((_e1465 >> bitcast<u32>((_e1458 & 31u))) | ((_e1476 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1458) & 31u))));
let _e1484 = local_6.member_1[2u];
let _e1490 = f32(bitcast<i32>(((_e1483 >> bitcast<u32>((_e1484 & 31u))) & 65535u)));
let _e1491 = local_6.member_1[3u];
let _e1498 = local_7[0u];
let _e1503 = local_6.member[1u];
let _e1504 = ((_e947 + _e941) + _e1503);
let _e1506 = (_e1504 >> bitcast<u32>(1i));
let _e1509 = bitcast<u32>(((_e1504 & 1i) * 16i));
let _e1511 = select(_e971, _e1506, (_e1506 < _e971));
let _e1516 = global_1.member[bitcast<u32>(select(0i, _e1511, (_e1511 > 0i)))];
let _e1520 = (_e1506 + 1i);
let _e1522 = select(_e971, _e1520, (_e1520 < _e971));
let _e1527 = global_1.member[bitcast<u32>(select(0i, _e1522, (_e1522 > 0i)))];
let _e1534 = ((_e1516 >> bitcast<u32>((_e1509 & 31u))) | ((_e1527 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1509) & 31u))));
let _e1535 = local_6.member_1[2u];
let _e1541 = f32(bitcast<i32>(((_e1534 >> bitcast<u32>((_e1535 & 31u))) & 65535u)));
let _e1542 = local_6.member_1[3u];
let _e1549 = local_7[0u];
let _e1552 = (_e1541 + ((f32(bitcast<i32>(((_e1534 >> bitcast<u32>((_e1542 & 31u))) & 65535u))) - _e1541) * _e1549));
let _e1554 = local_6.member[1u];
let _e1555 = ((_e947 + _e944) + _e1554);
let _e1557 = (_e1555 >> bitcast<u32>(1i));
let _e1560 = bitcast<u32>(((_e1555 & 1i) * 16i));
let _e1562 = select(_e971, _e1557, (_e1557 < _e971));
let _e1567 = global_1.member[bitcast<u32>(select(0i, _e1562, (_e1562 > 0i)))];
let _e1571 = (_e1557 + 1i);
let _e1573 = select(_e971, _e1571, (_e1571 < _e971));
let _e1578 = global_1.member[bitcast<u32>(select(0i, _e1573, (_e1573 > 0i)))];
let _e1585 = ((_e1567 >> bitcast<u32>((_e1560 & 31u))) | ((_e1578 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1560) & 31u))));
let _e1586 = local_6.member_1[2u];
let _e1592 = f32(bitcast<i32>(((_e1585 >> bitcast<u32>((_e1586 & 31u))) & 65535u)));
let _e1593 = local_6.member_1[3u];
let _e1600 = local_7[0u];
let _e1605 = local_6.member[1u];
let _e1606 = ((_e945 + _e942) + _e1605);
let _e1608 = (_e1606 >> bitcast<u32>(1i));
let _e1611 = bitcast<u32>(((_e1606 & 1i) * 16i));
let _e1613 = select(_e971, _e1608, (_e1608 < _e971));
let _e1618 = global_1.member[bitcast<u32>(select(0i, _e1613, (_e1613 > 0i)))];
let _e1622 = (_e1608 + 1i);
let _e1624 = select(_e971, _e1622, (_e1622 < _e971));
let _e1629 = global_1.member[bitcast<u32>(select(0i, _e1624, (_e1624 > 0i)))];
let _e1636 = ((_e1618 >> bitcast<u32>((_e1611 & 31u))) | ((_e1629 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1611) & 31u))));
let _e1637 = local_6.member_1[2u];
let _e1643 = f32(bitcast<i32>(((_e1636 >> bitcast<u32>((_e1637 & 31u))) & 65535u)));
let _e1644 = local_6.member_1[3u];
let _e1651 = local_7[0u];
let _e1654 = (_e1643 + ((f32(bitcast<i32>(((_e1636 >> bitcast<u32>((_e1644 & 31u))) & 65535u))) - _e1643) * _e1651));
let _e1656 = local_6.member[1u];
let _e1657 = ((_e948 + _e942) + _e1656);
let _e1659 = (_e1657 >> bitcast<u32>(1i));
let _e1662 = bitcast<u32>(((_e1657 & 1i) * 16i));
let _e1664 = select(_e971, _e1659, (_e1659 < _e971));
let _e1669 = global_1.member[bitcast<u32>(select(0i, _e1664, (_e1664 > 0i)))];
let _e1673 = (_e1659 + 1i);
let _e1675 = select(_e971, _e1673, (_e1673 < _e971));
let _e1680 = global_1.member[bitcast<u32>(select(0i, _e1675, (_e1675 > 0i)))];
let _e1687 = ((_e1669 >> bitcast<u32>((_e1662 & 31u))) | ((_e1680 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1662) & 31u))));
let _e1688 = local_6.member_1[2u];
let _e1694 = f32(bitcast<i32>(((_e1687 >> bitcast<u32>((_e1688 & 31u))) & 65535u)));
let _e1695 = local_6.member_1[3u];
let _e1702 = local_7[0u];
let _e1705 = (_e1694 + ((f32(bitcast<i32>(((_e1687 >> bitcast<u32>((_e1695 & 31u))) & 65535u))) - _e1694) * _e1702));
let _e1707 = local_6.member[1u];
let _e1708 = ((_e945 + _e943) + _e1707);
let _e1710 = (_e1708 >> bitcast<u32>(1i));
let _e1713 = bitcast<u32>(((_e1708 & 1i) * 16i));
let _e1715 = select(_e971, _e1710, (_e1710 < _e971));
let _e1720 = global_1.member[bitcast<u32>(select(0i, _e1715, (_e1715 > 0i)))];
let _e1724 = (_e1710 + 1i);
let _e1726 = select(_e971, _e1724, (_e1724 < _e971));
let _e1731 = global_1.member[bitcast<u32>(select(0i, _e1726, (_e1726 > 0i)))];
let _e1738 = ((_e1720 >> bitcast<u32>((_e1713 & 31u))) | ((_e1731 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1713) & 31u))));
let _e1739 = local_6.member_1[2u];
let _e1745 = f32(bitcast<i32>(((_e1738 >> bitcast<u32>((_e1739 & 31u))) & 65535u)));
let _e1746 = local_6.member_1[3u];
let _e1753 = local_7[0u];
let _e1758 = local_6.member[1u];
let _e1759 = ((_e948 + _e943) + _e1758);
let _e1761 = (_e1759 >> bitcast<u32>(1i));
let _e1764 = bitcast<u32>(((_e1759 & 1i) * 16i));
let _e1766 = select(_e971, _e1761, (_e1761 < _e971));
let _e1771 = global_1.member[bitcast<u32>(select(0i, _e1766, (_e1766 > 0i)))];
let _e1775 = (_e1761 + 1i);
let _e1777 = select(_e971, _e1775, (_e1775 < _e971));
let _e1782 = global_1.member[bitcast<u32>(select(0i, _e1777, (_e1777 > 0i)))];
let _e1789 = ((_e1771 >> bitcast<u32>((_e1764 & 31u))) | ((_e1782 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1764) & 31u))));
let _e1790 = local_6.member_1[2u];
let _e1796 = f32(bitcast<i32>(((_e1789 >> bitcast<u32>((_e1790 & 31u))) & 65535u)));
let _e1797 = local_6.member_1[3u];
let _e1804 = local_7[0u];
let _e1809 = local_7[1u];
let _e1812 = (_e1074 + ((_e1179 - _e1074) * _e1809));
let _e1813 = local_7[1u];
let _e1816 = (_e1284 + ((_e1389 - _e1284) * _e1813));
let _e1817 = local_7[1u];
let _e1820 = (_e1070 + (((_e1150 + ((_e1157 - _e1150) * _e1172)) - _e1070) * _e1817));
let _e1821 = local_7[1u];
let _e1826 = local_7[2u];
let _e1830 = local_7[1u];
let _e1833 = (_e1078 + (((_e1164 + ((f32(bitcast<i32>(((_e1143 >> bitcast<u32>((_e1165 & 31u))) & 65535u))) - _e1164) * _e1180)) - _e1078) * _e1830));
let _e1834 = local_7[1u];
let _e1838 = local_7[2u];
let _e1842 = local_7[1u];
let _e1845 = (_e1450 + ((_e1074 - _e1450) * _e1842));
let _e1846 = local_7[1u];
let _e1850 = local_7[2u];
let _e1854 = local_7[1u];
let _e1857 = (_e1179 + (((_e1490 + ((f32(bitcast<i32>(((_e1483 >> bitcast<u32>((_e1491 & 31u))) & 65535u))) - _e1490) * _e1498)) - _e1179) * _e1854));
let _e1858 = local_7[1u];
let _e1862 = local_7[2u];
let _e1866 = local_7[1u];
let _e1869 = (_e1654 + (((_e1745 + ((f32(bitcast<i32>(((_e1738 >> bitcast<u32>((_e1746 & 31u))) & 65535u))) - _e1745) * _e1753)) - _e1654) * _e1866));
let _e1870 = local_7[2u];
let _e1874 = local_7[1u];
let _e1878 = local_7[2u];
let _e1882 = local_7[2u];
let _e1890 = global_5.member[_e350].member_6.member_5;
let _e1896 = global_5.member[_e350].member_6.member_6;
let _e1897 = (((_e1812 + ((_e1816 - _e1812) * _e1882)) * _e1890) + _e1896);
let _e1899 = select(0f, _e1897, (_e1897 > 0f));
let _e1901 = select(1f, _e1899, (_e1899 < 1f));
let _e1903 = (((_e1820 + (((_e1280 + (((_e1360 + ((_e1367 - _e1360) * _e1382)) - _e1280) * _e1821)) - _e1820) * _e1826)) * _e1890) + _e1896);
let _e1905 = select(0f, _e1903, (_e1903 > 0f));
let _e1907 = select(1f, _e1905, (_e1905 < 1f));
let _e1909 = (((_e1833 + (((_e1288 + (((_e1374 + ((f32(bitcast<i32>(((_e1353 >> bitcast<u32>((_e1375 & 31u))) & 65535u))) - _e1374) * _e1390)) - _e1288) * _e1834)) - _e1833) * _e1838)) * _e1890) + _e1896);
let _e1911 = select(0f, _e1909, (_e1909 > 0f));
let _e1913 = select(1f, _e1911, (_e1911 < 1f));
let _e1915 = (((_e1845 + (((_e1552 + ((_e1284 - _e1552) * _e1846)) - _e1845) * _e1850)) * _e1890) + _e1896);
let _e1917 = select(0f, _e1915, (_e1915 > 0f));
let _e1919 = select(1f, _e1917, (_e1917 < 1f));
let _e1921 = (((_e1857 + (((_e1389 + (((_e1592 + ((f32(bitcast<i32>(((_e1585 >> bitcast<u32>((_e1593 & 31u))) & 65535u))) - _e1592) * _e1600)) - _e1389) * _e1858)) - _e1857) * _e1862)) * _e1890) + _e1896);
let _e1923 = select(0f, _e1921, (_e1921 > 0f));
let _e1925 = select(1f, _e1923, (_e1923 < 1f));
let _e1927 = (((_e1869 + ((_e1812 - _e1869) * _e1870)) * _e1890) + _e1896);
let _e1929 = select(0f, _e1927, (_e1927 > 0f));
let _e1931 = select(1f, _e1929, (_e1929 < 1f));
let _e1933 = (((_e1816 + (((_e1705 + (((_e1796 + ((f32(bitcast<i32>(((_e1789 >> bitcast<u32>((_e1797 & 31u))) & 65535u))) - _e1796) * _e1804)) - _e1705) * _e1874)) - _e1816) * _e1878)) * _e1890) + _e1896);
let _e1935 = select(0f, _e1933, (_e1933 > 0f));
let _e1937 = select(1f, _e1935, (_e1935 < 1f));
let _e1938 = (_e1901 * 1024f);
let _e1939 = (1024f - 1f);
let _e1941 = select(0f, _e1938, (_e1938 > 0f));
let _e1943 = select(_e1939, _e1941, (_e1941 < _e1939));
let _e1950 = select(0i, select(select(i32(_e1943), i32(-2147483648), (_e1943 < -2147483600f)), 2147483647i, (_e1943 > 2147483500f)), (_e1943 == _e1943));
let _e1954 = (_e1950 - select(0i, 1i, (_e1943 < f32(_e1950))));
let _e1955 = (262147i + _e1954);
let _e1957 = (bitcast<i32>(_e121) - 1i);
let _e1959 = select(_e1957, _e1955, (_e1955 < _e1957));
let _e1965 = global_3.member[bitcast<u32>(select(0i, _e1959, (_e1959 > 0i)))];
let _e1975 = select(_e1957, 262146i, (262146i < _e1957));
let _e1981 = global_3.member[bitcast<u32>(select(0i, _e1975, (_e1975 > 0i)))];
let _e1982 = bitcast<f32>(_e1981);
let _e1983 = (f32((bitcast<i32>((_e1965 & 4095u)) - 2048i)) * _e1982);
let _e1985 = select(_e1957, 262144i, (262144i < _e1957));
let _e1991 = global_3.member[bitcast<u32>(select(0i, _e1985, (_e1985 > 0i)))];
let _e1992 = bitcast<f32>(_e1991);
let _e1994 = select(_e1957, 262145i, (262145i < _e1957));
let _e2000 = global_3.member[bitcast<u32>(select(0i, _e1994, (_e1994 > 0i)))];
let _e2001 = bitcast<f32>(_e2000);
let _e2007 = ((_e1992 + (f32(bitcast<i32>((_e1965 >> bitcast<u32>(12u)))) * _e2001)) + (_e1983 * (_e1938 - f32(_e1954))));
let _e2008 = (_e1983 * 1024f);
if _e798 {
let _e2015 = ((0.5f * (_e1913 - _e1907)) * _e2008);
let _e2016 = ((0.5f * (_e1925 - _e1919)) * _e2008);
let _e2017 = ((0.5f * (_e1937 - _e1931)) * _e2008);
phi_3892_ = type_29(_e2007, vec3<f32>(_e2015, _e2016, _e2017), vec3<f32>((_e2015 * _e2007), (_e2016 * _e2007), (_e2017 * _e2007)));
} else {
let _e2024 = (_e1907 * 1024f);
let _e2026 = select(0f, _e2024, (_e2024 > 0f));
let _e2028 = select(_e1939, _e2026, (_e2026 < _e1939));
let _e2035 = select(0i, select(select(i32(_e2028), i32(-2147483648), (_e2028 < -2147483600f)), 2147483647i, (_e2028 > 2147483500f)), (_e2028 == _e2028));
let _e2039 = (_e2035 - select(0i, 1i, (_e2028 < f32(_e2035))));
let _e2040 = (262147i + _e2039);
let _e2042 = select(_e1957, _e2040, (_e2040 < _e1957));
let _e2048 = global_3.member[bitcast<u32>(select(0i, _e2042, (_e2042 > 0i)))];
let _e2063 = ((_e1992 + (f32(bitcast<i32>((_e2048 >> bitcast<u32>(12u)))) * _e2001)) + ((f32((bitcast<i32>((_e2048 & 4095u)) - 2048i)) * _e1982) * (_e2024 - f32(_e2039))));
let _e2064 = (_e1913 * 1024f);
let _e2066 = select(0f, _e2064, (_e2064 > 0f));
let _e2068 = select(_e1939, _e2066, (_e2066 < _e1939));
let _e2075 = select(0i, select(select(i32(_e2068), i32(-2147483648), (_e2068 < -2147483600f)), 2147483647i, (_e2068 > 2147483500f)), (_e2068 == _e2068));
let _e2079 = (_e2075 - select(0i, 1i, (_e2068 < f32(_e2075))));
let _e2080 = (262147i + _e2079);
let _e2082 = select(_e1957, _e2080, (_e2080 < _e1957));
let _e2088 = global_3.member[bitcast<u32>(select(0i, _e2082, (_e2082 > 0i)))];
let _e2103 = ((_e1992 + (f32(bitcast<i32>((_e2088 >> bitcast<u32>(12u)))) * _e2001)) + ((f32((bitcast<i32>((_e2088 & 4095u)) - 2048i)) * _e1982) * (_e2064 - f32(_e2079))));
let _e2104 = (_e1919 * 1024f);
let _e2106 = select(0f, _e2104, (_e2104 > 0f));
let _e2108 = select(_e1939, _e2106, (_e2106 < _e1939));
let _e2115 = select(0i, select(select(i32(_e2108), i32(-2147483648), (_e2108 < -2147483600f)), 2147483647i, (_e2108 > 2147483500f)), (_e2108 == _e2108));
let _e2119 = (_e2115 - select(0i, 1i, (_e2108 < f32(_e2115))));
let _e2120 = (262147i + _e2119);
let _e2122 = select(_e1957, _e2120, (_e2120 < _e1957));
let _e2128 = global_3.member[bitcast<u32>(select(0i, _e2122, (_e2122 > 0i)))];
let _e2143 = ((_e1992 + (f32(bitcast<i32>((_e2128 >> bitcast<u32>(12u)))) * _e2001)) + ((f32((bitcast<i32>((_e2128 & 4095u)) - 2048i)) * _e1982) * (_e2104 - f32(_e2119))));
let _e2144 = (_e1925 * 1024f);
let _e2146 = select(0f, _e2144, (_e2144 > 0f));
let _e2148 = select(_e1939, _e2146, (_e2146 < _e1939));
let _e2155 = select(0i, select(select(i32(_e2148), i32(-2147483648), (_e2148 < -2147483600f)), 2147483647i, (_e2148 > 2147483500f)), (_e2148 == _e2148));
let _e2159 = (_e2155 - select(0i, 1i, (_e2148 < f32(_e2155))));
let _e2160 = (262147i + _e2159);
let _e2162 = select(_e1957, _e2160, (_e2160 < _e1957));
let _e2168 = global_3.member[bitcast<u32>(select(0i, _e2162, (_e2162 > 0i)))];
let _e2183 = ((_e1992 + (f32(bitcast<i32>((_e2168 >> bitcast<u32>(12u)))) * _e2001)) + ((f32((bitcast<i32>((_e2168 & 4095u)) - 2048i)) * _e1982) * (_e2144 - f32(_e2159))));
let _e2184 = (_e1931 * 1024f);
let _e2186 = select(0f, _e2184, (_e2184 > 0f));
let _e2188 = select(_e1939, _e2186, (_e2186 < _e1939));
let _e2195 = select(0i, select(select(i32(_e2188), i32(-2147483648), (_e2188 < -2147483600f)), 2147483647i, (_e2188 > 2147483500f)), (_e2188 == _e2188));
let _e2199 = (_e2195 - select(0i, 1i, (_e2188 < f32(_e2195))));
let _e2200 = (262147i + _e2199);
let _e2202 = select(_e1957, _e2200, (_e2200 < _e1957));
let _e2208 = global_3.member[bitcast<u32>(select(0i, _e2202, (_e2202 > 0i)))];
let _e2223 = ((_e1992 + (f32(bitcast<i32>((_e2208 >> bitcast<u32>(12u)))) * _e2001)) + ((f32((bitcast<i32>((_e2208 & 4095u)) - 2048i)) * _e1982) * (_e2184 - f32(_e2199))));
let _e2224 = (_e1937 * 1024f);
let _e2226 = select(0f, _e2224, (_e2224 > 0f));
let _e2228 = select(_e1939, _e2226, (_e2226 < _e1939));
let _e2235 = select(0i, select(select(i32(_e2228), i32(-2147483648), (_e2228 < -2147483600f)), 2147483647i, (_e2228 > 2147483500f)), (_e2228 == _e2228));
let _e2239 = (_e2235 - select(0i, 1i, (_e2228 < f32(_e2235))));
let _e2240 = (262147i + _e2239);
let _e2242 = select(_e1957, _e2240, (_e2240 < _e1957));
let _e2248 = global_3.member[bitcast<u32>(select(0i, _e2242, (_e2242 > 0i)))];
let _e2263 = ((_e1992 + (f32(bitcast<i32>((_e2248 >> bitcast<u32>(12u)))) * _e2001)) + ((f32((bitcast<i32>((_e2248 & 4095u)) - 2048i)) * _e1982) * (_e2224 - f32(_e2239))));
let _e2264 = (_e2103 - _e2063);
let _e2266 = (_e2183 - _e2143);
let _e2268 = (_e2263 - _e2223);
phi_3892_ = type_29(_e2007, vec3<f32>((0.5f * _e2264), (0.5f * _e2266), (0.5f * _e2268)), vec3<f32>((0.25f * (_e2264 * (_e2103 + _e2063))), (0.25f * (_e2266 * (_e2183 + _e2143))), (0.25f * (_e2268 * (_e2263 + _e2223)))));
}
let _e2283 = phi_3892_;
let _e2298 = select(0f, 1f, ((((((_e496 >= -0.5f) && (_e496 <= _e520)) && (_e502 >= -0.5f)) && (_e502 <= _e531)) && (_e508 >= -0.5f)) && (_e508 <= _e542)));
let _e2300 = (0.5f * (_e1913 - _e1907));
let _e2302 = (0.5f * (_e1925 - _e1919));
let _e2304 = (0.5f * (_e1937 - _e1931));
let _e2311 = global_5.member[_e350].member_6.member.member.member;
let _e2318 = global_5.member[_e350].member_6.member.member.member_1;
let _e2325 = global_5.member[_e350].member_6.member.member.member_2;
let _e2332 = global_5.member[_e350].member_6.member_1.member.member;
let _e2339 = global_5.member[_e350].member_6.member_1.member.member_1;
let _e2346 = global_5.member[_e350].member_6.member_1.member.member_2;
let _e2353 = global_5.member[_e350].member_6.member_2.member.member;
let _e2360 = global_5.member[_e350].member_6.member_2.member.member_1;
let _e2367 = global_5.member[_e350].member_6.member_2.member.member_2;
phi_4670_ = type_30(_e1901, vec3<f32>(((((_e2311 * _e2300) + (_e2332 * _e2302)) + (_e2353 * _e2304)) * _e2298), ((((_e2318 * _e2300) + (_e2339 * _e2302)) + (_e2360 * _e2304)) * _e2298), ((((_e2325 * _e2300) + (_e2346 * _e2302)) + (_e2367 * _e2304)) * _e2298)), _e2283.member, vec3<f32>(((((_e2311 * _e2283.member_2.x) + (_e2332 * _e2283.member_2.y)) + (_e2353 * _e2283.member_2.z)) * _e2298), ((((_e2318 * _e2283.member_2.x) + (_e2339 * _e2283.member_2.y)) + (_e2360 * _e2283.member_2.z)) * _e2298), ((((_e2325 * _e2283.member_2.x) + (_e2346 * _e2283.member_2.y)) + (_e2367 * _e2283.member_2.z)) * _e2298)), vec3<f32>(((((_e2311 * _e2283.member_1.x) + (_e2332 * _e2283.member_1.y)) + (_e2353 * _e2283.member_1.z)) * _e2298), ((((_e2318 * _e2283.member_1.x) + (_e2339 * _e2283.member_1.y)) + (_e2360 * _e2283.member_1.z)) * _e2298), ((((_e2325 * _e2283.member_1.x) + (_e2346 * _e2283.member_1.y)) + (_e2367 * _e2283.member_1.z)) * _e2298)));
} else {
let _e2433 = select(-1f, _e524, (_e524 > -1f));
let _e2435 = select(_e519, _e2433, (_e2433 < _e519));
let _e2442 = select(0i, select(select(i32(_e2435), i32(-2147483648), (_e2435 < -2147483600f)), 2147483647i, (_e2435 > 2147483500f)), (_e2435 == _e2435));
let _e2446 = (_e2442 - select(0i, 1i, (_e2435 < f32(_e2442))));
let _e2448 = select(-1f, _e535, (_e535 > -1f));
let _e2450 = select(_e530, _e2448, (_e2448 < _e530));
let _e2457 = select(0i, select(select(i32(_e2450), i32(-2147483648), (_e2450 < -2147483600f)), 2147483647i, (_e2450 > 2147483500f)), (_e2450 == _e2450));
let _e2461 = (_e2457 - select(0i, 1i, (_e2450 < f32(_e2457))));
let _e2463 = select(-1f, _e546, (_e546 > -1f));
let _e2465 = select(_e541, _e2463, (_e2463 < _e541));
let _e2472 = select(0i, select(select(i32(_e2465), i32(-2147483648), (_e2465 < -2147483600f)), 2147483647i, (_e2465 > 2147483500f)), (_e2465 == _e2465));
let _e2476 = (_e2472 - select(0i, 1i, (_e2465 < f32(_e2472))));
let _e2481 = global_5.member[_e350].member_6.member_7;
let _e2486 = global_5.member[_e350].member_6.member_8;
let _e2494 = (select(0i, select(select(i32(_e530), i32(-2147483648), (_e530 < -2147483600f)), 2147483647i, (_e530 > 2147483500f)), (_e530 == _e530)) - 1i);
let _e2497 = (_e2461 + 1i);
let _e2507 = (select(0i, select(select(i32(_e541), i32(-2147483648), (_e541 < -2147483600f)), 2147483647i, (_e541 > 2147483500f)), (_e541 == _e541)) - 1i);
let _e2510 = (_e2476 + 1i);
let _e2519 = select(0i, select(select(i32(_e519), i32(-2147483648), (_e519 < -2147483600f)), 2147483647i, (_e519 > 2147483500f)), (_e519 == _e519));
let _e2520 = (_e2519 - 1i);
let _e2521 = (_e2446 - 1i);
let _e2523 = select(0i, _e2521, (_e2521 > 0i));
let _e2525 = select(0i, _e2446, (_e2446 > 0i));
let _e2526 = (_e2446 + 1i);
let _e2528 = select(_e2520, _e2526, (_e2526 < _e2520));
let _e2529 = (_e2446 + 2i);
let _e2532 = (_e2519 - 2i);
let _e2534 = select(0i, _e2532, (_e2532 > 0i));
let _e2536 = select(_e2534, _e2523, (_e2523 < _e2534));
let _e2538 = select(_e2534, _e2525, (_e2525 < _e2534));
let _e2540 = select(_e2534, _e2528, (_e2528 < _e2534));
let _e2559 = (select(0i, _e2461, (_e2461 > 0i)) * _e2481);
let _e2560 = (select(_e2494, _e2497, (_e2497 < _e2494)) * _e2481);
let _e2561 = (select(0i, _e2476, (_e2476 > 0i)) * _e2486);
let _e2562 = (select(_e2507, _e2510, (_e2510 < _e2507)) * _e2486);
local_4 = type_28(array<i32, 4>(_e2536, _e2538, _e2540, 0i), array<u32, 6>(bitcast<u32>(((_e2523 - _e2536) * 16i)), bitcast<u32>(((_e2525 - _e2536) * 16i)), bitcast<u32>(((_e2525 - _e2538) * 16i)), bitcast<u32>(((_e2528 - _e2538) * 16i)), bitcast<u32>(((_e2528 - _e2540) * 16i)), bitcast<u32>(((select(_e2520, _e2529, (_e2529 < _e2520)) - _e2540) * 16i))));
local_5 = vec3<f32>((_e524 - f32(_e2446)), (_e535 - f32(_e2461)), (_e546 - f32(_e2476)));
let _e2577 = local_4.member[1u];
let _e2578 = ((_e2561 + _e2559) + _e2577);
let _e2580 = (_e2578 >> bitcast<u32>(1i));
let _e2583 = bitcast<u32>(((_e2578 & 1i) * 16i));
let _e2585 = (bitcast<i32>(_e117) - 1i);
let _e2587 = select(_e2585, _e2580, (_e2580 < _e2585));
let _e2592 = global_1.member[bitcast<u32>(select(0i, _e2587, (_e2587 > 0i)))];
let _e2596 = (_e2580 + 1i);
let _e2598 = select(_e2585, _e2596, (_e2596 < _e2585));
let _e2603 = global_1.member[bitcast<u32>(select(0i, _e2598, (_e2598 > 0i)))];
let _e2610 = ((_e2592 >> bitcast<u32>((_e2583 & 31u))) | ((_e2603 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2583) & 31u))));
let _e2613 = local_4.member_1[2u];
let _e2619 = f32(bitcast<i32>(((_e2610 >> bitcast<u32>((_e2613 & 31u))) & 65535u)));
let _e2622 = local_4.member_1[3u];
let _e2629 = local_5[0u];
let _e2632 = (_e2619 + ((f32(bitcast<i32>(((_e2610 >> bitcast<u32>((_e2622 & 31u))) & 65535u))) - _e2619) * _e2629));
let _e2634 = local_4.member[1u];
let _e2635 = ((_e2561 + _e2560) + _e2634);
let _e2637 = (_e2635 >> bitcast<u32>(1i));
let _e2640 = bitcast<u32>(((_e2635 & 1i) * 16i));
let _e2642 = select(_e2585, _e2637, (_e2637 < _e2585));
let _e2647 = global_1.member[bitcast<u32>(select(0i, _e2642, (_e2642 > 0i)))];
let _e2651 = (_e2637 + 1i);
let _e2653 = select(_e2585, _e2651, (_e2651 < _e2585));
let _e2658 = global_1.member[bitcast<u32>(select(0i, _e2653, (_e2653 > 0i)))];
let _e2665 = ((_e2647 >> bitcast<u32>((_e2640 & 31u))) | ((_e2658 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2640) & 31u))));
let _e2666 = local_4.member_1[2u];
let _e2672 = f32(bitcast<i32>(((_e2665 >> bitcast<u32>((_e2666 & 31u))) & 65535u)));
let _e2673 = local_4.member_1[3u];
let _e2680 = local_5[0u];
let _e2685 = local_5[1u];
let _e2688 = (_e2632 + (((_e2672 + ((f32(bitcast<i32>(((_e2665 >> bitcast<u32>((_e2673 & 31u))) & 65535u))) - _e2672) * _e2680)) - _e2632) * _e2685));
let _e2690 = local_4.member[1u];
let _e2691 = ((_e2562 + _e2559) + _e2690);
let _e2693 = (_e2691 >> bitcast<u32>(1i));
let _e2696 = bitcast<u32>(((_e2691 & 1i) * 16i));
let _e2698 = select(_e2585, _e2693, (_e2693 < _e2585));
let _e2703 = global_1.member[bitcast<u32>(select(0i, _e2698, (_e2698 > 0i)))];
let _e2707 = (_e2693 + 1i);
let _e2709 = select(_e2585, _e2707, (_e2707 < _e2585));
let _e2714 = global_1.member[bitcast<u32>(select(0i, _e2709, (_e2709 > 0i)))];
let _e2721 = ((_e2703 >> bitcast<u32>((_e2696 & 31u))) | ((_e2714 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2696) & 31u))));
let _e2722 = local_4.member_1[2u];
let _e2728 = f32(bitcast<i32>(((_e2721 >> bitcast<u32>((_e2722 & 31u))) & 65535u)));
let _e2729 = local_4.member_1[3u];
let _e2736 = local_5[0u];
let _e2739 = (_e2728 + ((f32(bitcast<i32>(((_e2721 >> bitcast<u32>((_e2729 & 31u))) & 65535u))) - _e2728) * _e2736));
let _e2741 = local_4.member[1u];
let _e2742 = ((_e2562 + _e2560) + _e2741);
let _e2744 = (_e2742 >> bitcast<u32>(1i));
let _e2747 = bitcast<u32>(((_e2742 & 1i) * 16i));
let _e2749 = select(_e2585, _e2744, (_e2744 < _e2585));
let _e2754 = global_1.member[bitcast<u32>(select(0i, _e2749, (_e2749 > 0i)))];
let _e2758 = (_e2744 + 1i);
let _e2760 = select(_e2585, _e2758, (_e2758 < _e2585));
let _e2765 = global_1.member[bitcast<u32>(select(0i, _e2760, (_e2760 > 0i)))];
let _e2772 = ((_e2754 >> bitcast<u32>((_e2747 & 31u))) | ((_e2765 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2747) & 31u))));
let _e2773 = local_4.member_1[2u];
let _e2779 = f32(bitcast<i32>(((_e2772 >> bitcast<u32>((_e2773 & 31u))) & 65535u)));
let _e2780 = local_4.member_1[3u];
let _e2787 = local_5[0u];
let _e2791 = local_5[1u];
let _e2796 = local_5[2u];
let _e2804 = global_5.member[_e350].member_6.member_5;
let _e2810 = global_5.member[_e350].member_6.member_6;
let _e2811 = (((_e2688 + (((_e2739 + (((_e2779 + ((f32(bitcast<i32>(((_e2772 >> bitcast<u32>((_e2780 & 31u))) & 65535u))) - _e2779) * _e2787)) - _e2739) * _e2791)) - _e2688) * _e2796)) * _e2804) + _e2810);
let _e2813 = select(0f, _e2811, (_e2811 > 0f));
phi_4670_ = type_30(select(1f, _e2813, (_e2813 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2818 = phi_4670_;
let _e2820 = select(-0.5f, _e458, (_e458 > -0.5f));
let _e2822 = select(_e520, _e2820, (_e2820 < _e520));
let _e2824 = select(-0.5f, _e474, (_e474 > -0.5f));
let _e2826 = select(_e531, _e2824, (_e2824 < _e531));
let _e2828 = select(-0.5f, _e490, (_e490 > -0.5f));
let _e2830 = select(_e542, _e2828, (_e2828 < _e542));
let _e2832 = select(-1f, _e2822, (_e2822 > -1f));
let _e2834 = select(_e519, _e2832, (_e2832 < _e519));
let _e2841 = select(0i, select(select(i32(_e2834), i32(-2147483648), (_e2834 < -2147483600f)), 2147483647i, (_e2834 > 2147483500f)), (_e2834 == _e2834));
let _e2845 = (_e2841 - select(0i, 1i, (_e2834 < f32(_e2841))));
let _e2847 = select(-1f, _e2826, (_e2826 > -1f));
let _e2849 = select(_e530, _e2847, (_e2847 < _e530));
let _e2856 = select(0i, select(select(i32(_e2849), i32(-2147483648), (_e2849 < -2147483600f)), 2147483647i, (_e2849 > 2147483500f)), (_e2849 == _e2849));
let _e2860 = (_e2856 - select(0i, 1i, (_e2849 < f32(_e2856))));
let _e2862 = select(-1f, _e2830, (_e2830 > -1f));
let _e2864 = select(_e541, _e2862, (_e2862 < _e541));
let _e2871 = select(0i, select(select(i32(_e2864), i32(-2147483648), (_e2864 < -2147483600f)), 2147483647i, (_e2864 > 2147483500f)), (_e2864 == _e2864));
let _e2875 = (_e2871 - select(0i, 1i, (_e2864 < f32(_e2871))));
let _e2880 = global_5.member[_e350].member_6.member_7;
let _e2885 = global_5.member[_e350].member_6.member_8;
let _e2893 = (select(0i, select(select(i32(_e530), i32(-2147483648), (_e530 < -2147483600f)), 2147483647i, (_e530 > 2147483500f)), (_e530 == _e530)) - 1i);
let _e2896 = (_e2860 + 1i);
let _e2906 = (select(0i, select(select(i32(_e541), i32(-2147483648), (_e541 < -2147483600f)), 2147483647i, (_e541 > 2147483500f)), (_e541 == _e541)) - 1i);
let _e2909 = (_e2875 + 1i);
let _e2918 = select(0i, select(select(i32(_e519), i32(-2147483648), (_e519 < -2147483600f)), 2147483647i, (_e519 > 2147483500f)), (_e519 == _e519));
let _e2919 = (_e2918 - 1i);
let _e2920 = (_e2845 - 1i);
let _e2922 = select(0i, _e2920, (_e2920 > 0i));
let _e2924 = select(0i, _e2845, (_e2845 > 0i));
let _e2925 = (_e2845 + 1i);
let _e2927 = select(_e2919, _e2925, (_e2925 < _e2919));
let _e2928 = (_e2845 + 2i);
let _e2931 = (_e2918 - 2i);
let _e2933 = select(0i, _e2931, (_e2931 > 0i));
let _e2935 = select(_e2933, _e2922, (_e2922 < _e2933));
let _e2937 = select(_e2933, _e2924, (_e2924 < _e2933));
let _e2939 = select(_e2933, _e2927, (_e2927 < _e2933));
let _e2958 = (select(0i, _e2860, (_e2860 > 0i)) * _e2880);
let _e2959 = (select(_e2893, _e2896, (_e2896 < _e2893)) * _e2880);
let _e2960 = (select(0i, _e2875, (_e2875 > 0i)) * _e2885);
let _e2961 = (select(_e2906, _e2909, (_e2909 < _e2906)) * _e2885);
local_2 = type_28(array<i32, 4>(_e2935, _e2937, _e2939, 0i), array<u32, 6>(bitcast<u32>(((_e2922 - _e2935) * 16i)), bitcast<u32>(((_e2924 - _e2935) * 16i)), bitcast<u32>(((_e2924 - _e2937) * 16i)), bitcast<u32>(((_e2927 - _e2937) * 16i)), bitcast<u32>(((_e2927 - _e2939) * 16i)), bitcast<u32>(((select(_e2919, _e2928, (_e2928 < _e2919)) - _e2939) * 16i))));
local_3 = vec3<f32>((_e2822 - f32(_e2845)), (_e2826 - f32(_e2860)), (_e2830 - f32(_e2875)));
let _e2976 = local_2.member[1u];
let _e2977 = ((_e2960 + _e2958) + _e2976);
let _e2979 = (_e2977 >> bitcast<u32>(1i));
let _e2982 = bitcast<u32>(((_e2977 & 1i) * 16i));
let _e2984 = (bitcast<i32>(_e117) - 1i);
let _e2986 = select(_e2984, _e2979, (_e2979 < _e2984));
let _e2991 = global_1.member[bitcast<u32>(select(0i, _e2986, (_e2986 > 0i)))];
let _e2995 = (_e2979 + 1i);
let _e2997 = select(_e2984, _e2995, (_e2995 < _e2984));
let _e3002 = global_1.member[bitcast<u32>(select(0i, _e2997, (_e2997 > 0i)))];
let _e3009 = ((_e2991 >> bitcast<u32>((_e2982 & 31u))) | ((_e3002 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2982) & 31u))));
let _e3012 = local_2.member_1[2u];
let _e3018 = f32(bitcast<i32>(((_e3009 >> bitcast<u32>((_e3012 & 31u))) & 65535u)));
let _e3021 = local_2.member_1[3u];
let _e3028 = local_3[0u];
let _e3031 = (_e3018 + ((f32(bitcast<i32>(((_e3009 >> bitcast<u32>((_e3021 & 31u))) & 65535u))) - _e3018) * _e3028));
let _e3033 = local_2.member[1u];
let _e3034 = ((_e2960 + _e2959) + _e3033);
let _e3036 = (_e3034 >> bitcast<u32>(1i));
let _e3039 = bitcast<u32>(((_e3034 & 1i) * 16i));
let _e3041 = select(_e2984, _e3036, (_e3036 < _e2984));
let _e3046 = global_1.member[bitcast<u32>(select(0i, _e3041, (_e3041 > 0i)))];
let _e3050 = (_e3036 + 1i);
let _e3052 = select(_e2984, _e3050, (_e3050 < _e2984));
let _e3057 = global_1.member[bitcast<u32>(select(0i, _e3052, (_e3052 > 0i)))];
let _e3064 = ((_e3046 >> bitcast<u32>((_e3039 & 31u))) | ((_e3057 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3039) & 31u))));
let _e3065 = local_2.member_1[2u];
let _e3071 = f32(bitcast<i32>(((_e3064 >> bitcast<u32>((_e3065 & 31u))) & 65535u)));
let _e3072 = local_2.member_1[3u];
let _e3079 = local_3[0u];
let _e3084 = local_3[1u];
let _e3087 = (_e3031 + (((_e3071 + ((f32(bitcast<i32>(((_e3064 >> bitcast<u32>((_e3072 & 31u))) & 65535u))) - _e3071) * _e3079)) - _e3031) * _e3084));
let _e3089 = local_2.member[1u];
let _e3090 = ((_e2961 + _e2958) + _e3089);
let _e3092 = (_e3090 >> bitcast<u32>(1i));
let _e3095 = bitcast<u32>(((_e3090 & 1i) * 16i));
let _e3097 = select(_e2984, _e3092, (_e3092 < _e2984));
let _e3102 = global_1.member[bitcast<u32>(select(0i, _e3097, (_e3097 > 0i)))];
let _e3106 = (_e3092 + 1i);
let _e3108 = select(_e2984, _e3106, (_e3106 < _e2984));
let _e3113 = global_1.member[bitcast<u32>(select(0i, _e3108, (_e3108 > 0i)))];
let _e3120 = ((_e3102 >> bitcast<u32>((_e3095 & 31u))) | ((_e3113 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3095) & 31u))));
let _e3121 = local_2.member_1[2u];
let _e3127 = f32(bitcast<i32>(((_e3120 >> bitcast<u32>((_e3121 & 31u))) & 65535u)));
let _e3128 = local_2.member_1[3u];
let _e3135 = local_3[0u];
let _e3138 = (_e3127 + ((f32(bitcast<i32>(((_e3120 >> bitcast<u32>((_e3128 & 31u))) & 65535u))) - _e3127) * _e3135));
let _e3140 = local_2.member[1u];
let _e3141 = ((_e2961 + _e2959) + _e3140);
let _e3143 = (_e3141 >> bitcast<u32>(1i));
let _e3146 = bitcast<u32>(((_e3141 & 1i) * 16i));
let _e3148 = select(_e2984, _e3143, (_e3143 < _e2984));
let _e3153 = global_1.member[bitcast<u32>(select(0i, _e3148, (_e3148 > 0i)))];
let _e3157 = (_e3143 + 1i);
let _e3159 = select(_e2984, _e3157, (_e3157 < _e2984));
let _e3164 = global_1.member[bitcast<u32>(select(0i, _e3159, (_e3159 > 0i)))];
let _e3171 = ((_e3153 >> bitcast<u32>((_e3146 & 31u))) | ((_e3164 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3146) & 31u))));
let _e3172 = local_2.member_1[2u];
let _e3178 = f32(bitcast<i32>(((_e3171 >> bitcast<u32>((_e3172 & 31u))) & 65535u)));
let _e3179 = local_2.member_1[3u];
let _e3186 = local_3[0u];
let _e3190 = local_3[1u];
let _e3195 = local_3[2u];
let _e3203 = global_5.member[_e350].member_6.member_5;
let _e3209 = global_5.member[_e350].member_6.member_6;
let _e3210 = (((_e3087 + (((_e3138 + (((_e3178 + ((f32(bitcast<i32>(((_e3171 >> bitcast<u32>((_e3179 & 31u))) & 65535u))) - _e3178) * _e3186)) - _e3138) * _e3190)) - _e3087) * _e3195)) * _e3203) + _e3209);
let _e3212 = select(0f, _e3210, (_e3210 > 0f));
let _e3214 = select(1f, _e3212, (_e3212 < 1f));
let _e3215 = select(_e354[6], _e3214, _e717);
if _e801 {
let _e3216 = (_e3214 * 1024f);
let _e3217 = (1024f - 1f);
let _e3219 = select(0f, _e3216, (_e3216 > 0f));
let _e3221 = select(_e3217, _e3219, (_e3219 < _e3217));
let _e3228 = select(0i, select(select(i32(_e3221), i32(-2147483648), (_e3221 < -2147483600f)), 2147483647i, (_e3221 > 2147483500f)), (_e3221 == _e3221));
let _e3232 = (_e3228 - select(0i, 1i, (_e3221 < f32(_e3228))));
let _e3233 = (262147i + _e3232);
let _e3235 = (bitcast<i32>(_e121) - 1i);
let _e3237 = select(_e3235, _e3233, (_e3233 < _e3235));
let _e3243 = global_3.member[bitcast<u32>(select(0i, _e3237, (_e3237 > 0i)))];
let _e3253 = select(_e3235, 262146i, (262146i < _e3235));
let _e3259 = global_3.member[bitcast<u32>(select(0i, _e3253, (_e3253 > 0i)))];
let _e3263 = select(_e3235, 262144i, (262144i < _e3235));
let _e3269 = global_3.member[bitcast<u32>(select(0i, _e3263, (_e3263 > 0i)))];
let _e3272 = select(_e3235, 262145i, (262145i < _e3235));
let _e3278 = global_3.member[bitcast<u32>(select(0i, _e3272, (_e3272 > 0i)))];
phi_5385_ = select(_e354[16], ((bitcast<f32>(_e3269) + (f32(bitcast<i32>((_e3243 >> bitcast<u32>(12u)))) * bitcast<f32>(_e3278))) + ((f32((bitcast<i32>((_e3243 & 4095u)) - 2048i)) * bitcast<f32>(_e3259)) * (_e3216 - f32(_e3232)))), _e717);
} else {
phi_5385_ = _e354[16];
}
let _e3288 = phi_5385_;
let _e3291 = select(1f, select(1f, _e796, (_e796 < 1f)), _e442);
if ((_e685 & 16u) == 0u) {
phi_5774_ = type_5(1f, 1f, 1f);
} else {
let _e3298 = global_5.member[_e350].member_14.member;
let _e3309 = ((((_e3298.member.member * _e378) + (_e3298.member.member_1 * _e380)) + (_e3298.member.member_2 * _e374)) + _e3298.member_1);
let _e3315 = ((((_e3298.member.member * _e382) + (_e3298.member.member_1 * _e384)) + (_e3298.member.member_2 * _e389)) + _e3298.member_1);
let _e3317 = select(_e3315, _e3309, (_e3309 < _e3315));
let _e3319 = select(_e3315, _e3309, (_e3309 > _e3315));
let _e3321 = (_e3319 - _e3317);
let _e3324 = (-(_e3317) / select(1e-30f, _e3321, (_e3321 > 1e-30f)));
let _e3326 = select(0f, _e3324, (_e3324 > 0f));
let _e3332 = select(select(select(1f, _e3326, (_e3326 < 1f)), 1f, (_e3319 <= 0f)), 0f, (_e3317 > 0f));
let _e3338 = global_5.member[_e350].member_14.member_1;
let _e3339 = (_e3338 != 0u);
let _e3350 = global_5.member[_e350].member_15.member;
let _e3361 = ((((_e3350.member.member * _e378) + (_e3350.member.member_1 * _e380)) + (_e3350.member.member_2 * _e374)) + _e3350.member_1);
let _e3367 = ((((_e3350.member.member * _e382) + (_e3350.member.member_1 * _e384)) + (_e3350.member.member_2 * _e389)) + _e3350.member_1);
let _e3369 = select(_e3367, _e3361, (_e3361 < _e3367));
let _e3371 = select(_e3367, _e3361, (_e3361 > _e3367));
let _e3373 = (_e3371 - _e3369);
let _e3376 = (-(_e3369) / select(1e-30f, _e3373, (_e3373 > 1e-30f)));
let _e3378 = select(0f, _e3376, (_e3376 > 0f));
let _e3384 = select(select(select(1f, _e3378, (_e3378 < 1f)), 1f, (_e3371 <= 0f)), 0f, (_e3369 > 0f));
let _e3390 = global_5.member[_e350].member_15.member_1;
let _e3391 = (_e3390 != 0u);
let _e3402 = global_5.member[_e350].member_16.member;
let _e3413 = ((((_e3402.member.member * _e378) + (_e3402.member.member_1 * _e380)) + (_e3402.member.member_2 * _e374)) + _e3402.member_1);
let _e3419 = ((((_e3402.member.member * _e382) + (_e3402.member.member_1 * _e384)) + (_e3402.member.member_2 * _e389)) + _e3402.member_1);
let _e3421 = select(_e3419, _e3413, (_e3413 < _e3419));
let _e3423 = select(_e3419, _e3413, (_e3413 > _e3419));
let _e3425 = (_e3423 - _e3421);
let _e3428 = (-(_e3421) / select(1e-30f, _e3425, (_e3425 > 1e-30f)));
let _e3430 = select(0f, _e3428, (_e3428 > 0f));
let _e3436 = select(select(select(1f, _e3430, (_e3430 < 1f)), 1f, (_e3423 <= 0f)), 0f, (_e3421 > 0f));
let _e3442 = global_5.member[_e350].member_16.member_1;
let _e3443 = (_e3442 != 0u);
let _e3454 = global_5.member[_e350].member_17.member;
let _e3465 = ((((_e3454.member.member * _e378) + (_e3454.member.member_1 * _e380)) + (_e3454.member.member_2 * _e374)) + _e3454.member_1);
let _e3471 = ((((_e3454.member.member * _e382) + (_e3454.member.member_1 * _e384)) + (_e3454.member.member_2 * _e389)) + _e3454.member_1);
let _e3473 = select(_e3471, _e3465, (_e3465 < _e3471));
let _e3475 = select(_e3471, _e3465, (_e3465 > _e3471));
let _e3477 = (_e3475 - _e3473);
let _e3480 = (-(_e3473) / select(1e-30f, _e3477, (_e3477 > 1e-30f)));
let _e3482 = select(0f, _e3480, (_e3480 > 0f));
let _e3488 = select(select(select(1f, _e3482, (_e3482 < 1f)), 1f, (_e3475 <= 0f)), 0f, (_e3473 > 0f));
let _e3494 = global_5.member[_e350].member_17.member_1;
let _e3495 = (_e3494 != 0u);
phi_5774_ = type_5(((((1f * _e3332) * _e3384) * _e3436) * _e3488), ((((1f * select(1f, _e3332, _e3339)) * select(1f, _e3384, _e3391)) * select(1f, _e3436, _e3443)) * select(1f, _e3488, _e3495)), ((((1f * select(1f, 0f, (_e3339 && (_e3315 > 0f)))) * select(1f, 0f, (_e3391 && (_e3367 > 0f)))) * select(1f, 0f, (_e3443 && (_e3419 > 0f)))) * select(1f, 0f, (_e3495 && (_e3471 > 0f)))));
}
let _e3504 = phi_5774_;
let _e3505 = (_e552 < 1e-12f);
let _e3507 = (1f / select(_e547, 1f, _e3505));
let _e3509 = ((-0.5f - _e458) * _e3507);
let _e3511 = ((_e520 - _e458) * _e3507);
let _e3517 = select(_e3511, _e3509, (_e3509 < _e3511));
let _e3519 = select(0f, _e3517, (_e3517 > 0f));
let _e3522 = select(select(1f, _e3519, (_e3519 < 1f)), select(2f, 0f, ((_e458 >= -0.5f) && (_e458 <= _e520))), _e3505);
let _e3524 = select(_e3511, _e3509, (_e3509 > _e3511));
let _e3526 = select(0f, _e3524, (_e3524 > 0f));
let _e3529 = select(select(1f, _e3526, (_e3526 < 1f)), 1f, _e3505);
let _e3530 = (_e555 < 1e-12f);
let _e3532 = (1f / select(_e548, 1f, _e3530));
let _e3534 = ((-0.5f - _e474) * _e3532);
let _e3536 = ((_e531 - _e474) * _e3532);
let _e3542 = select(_e3536, _e3534, (_e3534 < _e3536));
let _e3544 = select(0f, _e3542, (_e3542 > 0f));
let _e3547 = select(select(1f, _e3544, (_e3544 < 1f)), select(2f, 0f, ((_e474 >= -0.5f) && (_e474 <= _e531))), _e3530);
let _e3549 = select(_e3536, _e3534, (_e3534 > _e3536));
let _e3551 = select(0f, _e3549, (_e3549 > 0f));
let _e3554 = select(select(1f, _e3551, (_e3551 < 1f)), 1f, _e3530);
let _e3555 = (_e560 < 1e-12f);
let _e3557 = (1f / select(_e549, 1f, _e3555));
let _e3559 = ((-0.5f - _e490) * _e3557);
let _e3561 = ((_e542 - _e490) * _e3557);
let _e3567 = select(_e3561, _e3559, (_e3559 < _e3561));
let _e3569 = select(0f, _e3567, (_e3567 > 0f));
let _e3572 = select(select(1f, _e3569, (_e3569 < 1f)), select(2f, 0f, ((_e490 >= -0.5f) && (_e490 <= _e542))), _e3555);
let _e3574 = select(_e3561, _e3559, (_e3559 > _e3561));
let _e3576 = select(0f, _e3574, (_e3574 > 0f));
let _e3579 = select(select(1f, _e3576, (_e3576 < 1f)), 1f, _e3555);
let _e3581 = select(_e3554, _e3529, (_e3529 < _e3554));
let _e3585 = select(_e3547, _e3522, (_e3522 > _e3547));
let _e3588 = (select(_e3579, _e3581, (_e3581 < _e3579)) - select(_e3572, _e3585, (_e3585 > _e3572)));
let _e3591 = (_e382 - _e378);
let _e3592 = (_e384 - _e380);
let _e3593 = (_e389 - _e374);
let _e3598 = (((_e3591 * _e3591) + (_e3592 * _e3592)) + (_e3593 * _e3593));
let _e3608 = global_5.member[_e350].member_5.member_3;
let _e3609 = (((sqrt(select(0f, _e3598, (_e3598 > 0f))) * select(0f, _e3588, (_e3588 > 0f))) * _e3291) * _e3608);
let _e3610 = (_e727.member_2 >= 3u);
if _e3610 {
let _e3612 = (_e3215 * 255f);
let _e3613 = (_e2818.member * 255f);
let _e3614 = (255f - 1f);
let _e3616 = select(0f, _e3612, (_e3612 > 0f));
let _e3618 = select(_e3614, _e3616, (_e3616 < _e3614));
let _e3625 = select(0i, select(select(i32(_e3618), i32(-2147483648), (_e3618 < -2147483600f)), 2147483647i, (_e3618 > 2147483500f)), (_e3618 == _e3618));
let _e3629 = (_e3625 - select(0i, 1i, (_e3618 < f32(_e3625))));
let _e3631 = select(0f, _e3613, (_e3613 > 0f));
let _e3633 = select(_e3614, _e3631, (_e3631 < _e3614));
let _e3640 = select(0i, select(select(i32(_e3633), i32(-2147483648), (_e3633 < -2147483600f)), 2147483647i, (_e3633 > 2147483500f)), (_e3633 == _e3633));
let _e3644 = (_e3640 - select(0i, 1i, (_e3633 < f32(_e3640))));
let _e3647 = (((_e3629 * 256i) + _e3644) * 4i);
let _e3649 = (_e3612 - f32(_e3629));
let _e3651 = (_e3613 - f32(_e3644));
let _e3652 = (_e3647 + 2i);
let _e3654 = (bitcast<i32>(_e121) - 1i);
let _e3656 = select(_e3654, _e3652, (_e3652 < _e3654));
let _e3662 = global_3.member[bitcast<u32>(select(0i, _e3656, (_e3656 > 0i)))];
let _e3663 = (_e3647 + 6i);
let _e3665 = select(_e3654, _e3663, (_e3663 < _e3654));
let _e3671 = global_3.member[bitcast<u32>(select(0i, _e3665, (_e3665 > 0i)))];
let _e3672 = (_e3647 + 1026i);
let _e3674 = select(_e3654, _e3672, (_e3672 < _e3654));
let _e3680 = global_3.member[bitcast<u32>(select(0i, _e3674, (_e3674 > 0i)))];
let _e3681 = (_e3647 + 1030i);
let _e3683 = select(_e3654, _e3681, (_e3681 < _e3654));
let _e3689 = global_3.member[bitcast<u32>(select(0i, _e3683, (_e3683 > 0i)))];
let _e3694 = (bitcast<f32>(((_e3662 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3702 = (_e3694 + (((bitcast<f32>(((_e3671 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3694) * _e3651));
let _e3707 = (bitcast<f32>(((_e3680 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3731 = (bitcast<f32>((((_e3662 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3739 = (_e3731 + (((bitcast<f32>((((_e3671 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3731) * _e3651));
let _e3744 = (bitcast<f32>((((_e3680 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3756 = (_e3647 + 3i);
let _e3758 = select(_e3654, _e3756, (_e3756 < _e3654));
let _e3764 = global_3.member[bitcast<u32>(select(0i, _e3758, (_e3758 > 0i)))];
let _e3765 = (_e3647 + 7i);
let _e3767 = select(_e3654, _e3765, (_e3765 < _e3654));
let _e3773 = global_3.member[bitcast<u32>(select(0i, _e3767, (_e3767 > 0i)))];
let _e3774 = (_e3647 + 1027i);
let _e3776 = select(_e3654, _e3774, (_e3774 < _e3654));
let _e3782 = global_3.member[bitcast<u32>(select(0i, _e3776, (_e3776 > 0i)))];
let _e3783 = (_e3647 + 1031i);
let _e3785 = select(_e3654, _e3783, (_e3783 < _e3654));
let _e3791 = global_3.member[bitcast<u32>(select(0i, _e3785, (_e3785 > 0i)))];
let _e3796 = (bitcast<f32>(((_e3764 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3804 = (_e3796 + (((bitcast<f32>(((_e3773 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3796) * _e3651));
let _e3809 = (bitcast<f32>(((_e3782 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3833 = (bitcast<f32>((((_e3764 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3841 = (_e3833 + (((bitcast<f32>((((_e3773 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3833) * _e3651));
let _e3846 = (bitcast<f32>((((_e3782 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3857 = (_e3841 + (((_e3846 + (((bitcast<f32>((((_e3791 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3846) * _e3651)) - _e3841) * _e3649));
let _e3861 = -((_e3857 * (_e3609 * _e3504.member)));
let _e3863 = select(-87f, _e3861, (_e3861 > -87f));
let _e3865 = select(88f, _e3863, (_e3863 < 88f));
let _e3867 = ((_e3865 * 1.442695f) + 0.5f);
let _e3869 = select(-127f, _e3867, (_e3867 > -127f));
let _e3871 = select(128f, _e3869, (_e3869 < 128f));
let _e3878 = select(0i, select(select(i32(_e3871), i32(-2147483648), (_e3871 < -2147483600f)), 2147483647i, (_e3871 > 2147483500f)), (_e3871 == _e3871));
let _e3882 = (_e3878 - select(0i, 1i, (_e3871 < f32(_e3878))));
let _e3883 = f32(_e3882);
let _e3887 = ((_e3865 - (_e3883 * 0.6933594f)) - (_e3883 * -2.1219444e-4f));
let _e3907 = ((1f + (_e3887 * (1f + (_e3887 * (0.5f + (_e3887 * (0.16666667f + (_e3887 * (0.041666668f + (_e3887 * (0.008333334f + (_e3887 * (0.001388889f + (_e3887 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3882 + 127i)) << bitcast<u32>(23i))));
let _e3908 = (1f - _e3907);
let _e3911 = (_e3908 / select(1e-12f, _e3857, (_e3857 > 1e-12f)));
phi_7332_ = type_31(_e3907, _e3908, vec3<f32>(1f, 1f, 1f), vec3<f32>(((_e3702 + (((_e3707 + (((bitcast<f32>(((_e3689 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3707) * _e3651)) - _e3702) * _e3649)) * _e3911), ((_e3739 + (((_e3744 + (((bitcast<f32>((((_e3689 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3744) * _e3651)) - _e3739) * _e3649)) * _e3911), ((_e3804 + (((_e3809 + (((bitcast<f32>(((_e3791 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3809) * _e3651)) - _e3804) * _e3649)) * _e3911)));
} else {
let _e3918 = (_e3215 * 255f);
let _e3919 = (_e2818.member * 255f);
let _e3920 = (255f - 1f);
let _e3922 = select(0f, _e3918, (_e3918 > 0f));
let _e3924 = select(_e3920, _e3922, (_e3922 < _e3920));
let _e3931 = select(0i, select(select(i32(_e3924), i32(-2147483648), (_e3924 < -2147483600f)), 2147483647i, (_e3924 > 2147483500f)), (_e3924 == _e3924));
let _e3935 = (_e3931 - select(0i, 1i, (_e3924 < f32(_e3931))));
let _e3937 = select(0f, _e3919, (_e3919 > 0f));
let _e3939 = select(_e3920, _e3937, (_e3937 < _e3920));
let _e3946 = select(0i, select(select(i32(_e3939), i32(-2147483648), (_e3939 < -2147483600f)), 2147483647i, (_e3939 > 2147483500f)), (_e3939 == _e3939));
let _e3950 = (_e3946 - select(0i, 1i, (_e3939 < f32(_e3946))));
let _e3953 = (((_e3935 * 256i) + _e3950) * 4i);
let _e3955 = (_e3918 - f32(_e3935));
let _e3957 = (_e3919 - f32(_e3950));
let _e3959 = (bitcast<i32>(_e121) - 1i);
let _e3961 = select(_e3959, _e3953, (_e3953 < _e3959));
let _e3967 = global_3.member[bitcast<u32>(select(0i, _e3961, (_e3961 > 0i)))];
let _e3968 = (_e3953 + 4i);
let _e3970 = select(_e3959, _e3968, (_e3968 < _e3959));
let _e3976 = global_3.member[bitcast<u32>(select(0i, _e3970, (_e3970 > 0i)))];
let _e3977 = (_e3953 + 1024i);
let _e3979 = select(_e3959, _e3977, (_e3977 < _e3959));
let _e3985 = global_3.member[bitcast<u32>(select(0i, _e3979, (_e3979 > 0i)))];
let _e3986 = (_e3953 + 1028i);
let _e3988 = select(_e3959, _e3986, (_e3986 < _e3959));
let _e3994 = global_3.member[bitcast<u32>(select(0i, _e3988, (_e3988 > 0i)))];
let _e3999 = (bitcast<f32>(((_e3967 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4007 = (_e3999 + (((bitcast<f32>(((_e3976 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3999) * _e3957));
let _e4012 = (bitcast<f32>(((_e3985 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4023 = (_e4007 + (((_e4012 + (((bitcast<f32>(((_e3994 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4012) * _e3957)) - _e4007) * _e3955));
let _e4036 = (bitcast<f32>((((_e3967 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4044 = (_e4036 + (((bitcast<f32>((((_e3976 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4036) * _e3957));
let _e4049 = (bitcast<f32>((((_e3985 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4061 = (_e3953 + 1i);
let _e4063 = select(_e3959, _e4061, (_e4061 < _e3959));
let _e4069 = global_3.member[bitcast<u32>(select(0i, _e4063, (_e4063 > 0i)))];
let _e4070 = (_e3953 + 5i);
let _e4072 = select(_e3959, _e4070, (_e4070 < _e3959));
let _e4078 = global_3.member[bitcast<u32>(select(0i, _e4072, (_e4072 > 0i)))];
let _e4079 = (_e3953 + 1025i);
let _e4081 = select(_e3959, _e4079, (_e4079 < _e3959));
let _e4087 = global_3.member[bitcast<u32>(select(0i, _e4081, (_e4081 > 0i)))];
let _e4088 = (_e3953 + 1029i);
let _e4090 = select(_e3959, _e4088, (_e4088 < _e3959));
let _e4096 = global_3.member[bitcast<u32>(select(0i, _e4090, (_e4090 > 0i)))];
let _e4101 = (bitcast<f32>(((_e4069 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4109 = (_e4101 + (((bitcast<f32>(((_e4078 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4101) * _e3957));
let _e4114 = (bitcast<f32>(((_e4087 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4138 = (bitcast<f32>((((_e4069 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4146 = (_e4138 + (((bitcast<f32>((((_e4078 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4138) * _e3957));
let _e4151 = (bitcast<f32>((((_e4087 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4163 = (_e3953 + 2i);
let _e4165 = select(_e3959, _e4163, (_e4163 < _e3959));
let _e4171 = global_3.member[bitcast<u32>(select(0i, _e4165, (_e4165 > 0i)))];
let _e4172 = (_e3953 + 6i);
let _e4174 = select(_e3959, _e4172, (_e4172 < _e3959));
let _e4180 = global_3.member[bitcast<u32>(select(0i, _e4174, (_e4174 > 0i)))];
let _e4181 = (_e3953 + 1026i);
let _e4183 = select(_e3959, _e4181, (_e4181 < _e3959));
let _e4189 = global_3.member[bitcast<u32>(select(0i, _e4183, (_e4183 > 0i)))];
let _e4190 = (_e3953 + 1030i);
let _e4192 = select(_e3959, _e4190, (_e4190 < _e3959));
let _e4198 = global_3.member[bitcast<u32>(select(0i, _e4192, (_e4192 > 0i)))];
let _e4203 = (bitcast<f32>(((_e4171 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4211 = (_e4203 + (((bitcast<f32>(((_e4180 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4203) * _e3957));
let _e4216 = (bitcast<f32>(((_e4189 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4240 = (bitcast<f32>((((_e4171 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4248 = (_e4240 + (((bitcast<f32>((((_e4180 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4240) * _e3957));
let _e4253 = (bitcast<f32>((((_e4189 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4265 = (_e3953 + 3i);
let _e4267 = select(_e3959, _e4265, (_e4265 < _e3959));
let _e4273 = global_3.member[bitcast<u32>(select(0i, _e4267, (_e4267 > 0i)))];
let _e4274 = (_e3953 + 7i);
let _e4276 = select(_e3959, _e4274, (_e4274 < _e3959));
let _e4282 = global_3.member[bitcast<u32>(select(0i, _e4276, (_e4276 > 0i)))];
let _e4283 = (_e3953 + 1027i);
let _e4285 = select(_e3959, _e4283, (_e4283 < _e3959));
let _e4291 = global_3.member[bitcast<u32>(select(0i, _e4285, (_e4285 > 0i)))];
let _e4292 = (_e3953 + 1031i);
let _e4294 = select(_e3959, _e4292, (_e4292 < _e3959));
let _e4300 = global_3.member[bitcast<u32>(select(0i, _e4294, (_e4294 > 0i)))];
let _e4305 = (bitcast<f32>(((_e4273 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4313 = (_e4305 + (((bitcast<f32>(((_e4282 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4305) * _e3957));
let _e4318 = (bitcast<f32>(((_e4291 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4333 = (_e3609 * _e3504.member_1);
let _e4335 = -(((_e4044 + (((_e4049 + (((bitcast<f32>((((_e3994 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4049) * _e3957)) - _e4044) * _e3955)) * _e4333));
let _e4337 = select(-87f, _e4335, (_e4335 > -87f));
let _e4339 = select(88f, _e4337, (_e4337 < 88f));
let _e4341 = ((_e4339 * 1.442695f) + 0.5f);
let _e4343 = select(-127f, _e4341, (_e4341 > -127f));
let _e4345 = select(128f, _e4343, (_e4343 < 128f));
let _e4352 = select(0i, select(select(i32(_e4345), i32(-2147483648), (_e4345 < -2147483600f)), 2147483647i, (_e4345 > 2147483500f)), (_e4345 == _e4345));
let _e4356 = (_e4352 - select(0i, 1i, (_e4345 < f32(_e4352))));
let _e4357 = f32(_e4356);
let _e4361 = ((_e4339 - (_e4357 * 0.6933594f)) - (_e4357 * -2.1219444e-4f));
let _e4383 = -(((_e4109 + (((_e4114 + (((bitcast<f32>(((_e4096 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4114) * _e3957)) - _e4109) * _e3955)) * _e4333));
let _e4385 = select(-87f, _e4383, (_e4383 > -87f));
let _e4387 = select(88f, _e4385, (_e4385 < 88f));
let _e4389 = ((_e4387 * 1.442695f) + 0.5f);
let _e4391 = select(-127f, _e4389, (_e4389 > -127f));
let _e4393 = select(128f, _e4391, (_e4391 < 128f));
let _e4400 = select(0i, select(select(i32(_e4393), i32(-2147483648), (_e4393 < -2147483600f)), 2147483647i, (_e4393 > 2147483500f)), (_e4393 == _e4393));
let _e4404 = (_e4400 - select(0i, 1i, (_e4393 < f32(_e4400))));
let _e4405 = f32(_e4404);
let _e4409 = ((_e4387 - (_e4405 * 0.6933594f)) - (_e4405 * -2.1219444e-4f));
let _e4431 = -(((_e4146 + (((_e4151 + (((bitcast<f32>((((_e4096 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4151) * _e3957)) - _e4146) * _e3955)) * _e4333));
let _e4433 = select(-87f, _e4431, (_e4431 > -87f));
let _e4435 = select(88f, _e4433, (_e4433 < 88f));
let _e4437 = ((_e4435 * 1.442695f) + 0.5f);
let _e4439 = select(-127f, _e4437, (_e4437 > -127f));
let _e4441 = select(128f, _e4439, (_e4439 < 128f));
let _e4448 = select(0i, select(select(i32(_e4441), i32(-2147483648), (_e4441 < -2147483600f)), 2147483647i, (_e4441 > 2147483500f)), (_e4441 == _e4441));
let _e4452 = (_e4448 - select(0i, 1i, (_e4441 < f32(_e4448))));
let _e4453 = f32(_e4452);
let _e4457 = ((_e4435 - (_e4453 * 0.6933594f)) - (_e4453 * -2.1219444e-4f));
let _e4480 = -((_e4023 * (_e3609 * _e3504.member)));
let _e4482 = select(-87f, _e4480, (_e4480 > -87f));
let _e4484 = select(88f, _e4482, (_e4482 < 88f));
let _e4486 = ((_e4484 * 1.442695f) + 0.5f);
let _e4488 = select(-127f, _e4486, (_e4486 > -127f));
let _e4490 = select(128f, _e4488, (_e4488 < 128f));
let _e4497 = select(0i, select(select(i32(_e4490), i32(-2147483648), (_e4490 < -2147483600f)), 2147483647i, (_e4490 > 2147483500f)), (_e4490 == _e4490));
let _e4501 = (_e4497 - select(0i, 1i, (_e4490 < f32(_e4497))));
let _e4502 = f32(_e4501);
let _e4506 = ((_e4484 - (_e4502 * 0.6933594f)) - (_e4502 * -2.1219444e-4f));
let _e4526 = ((1f + (_e4506 * (1f + (_e4506 * (0.5f + (_e4506 * (0.16666667f + (_e4506 * (0.041666668f + (_e4506 * (0.008333334f + (_e4506 * (0.001388889f + (_e4506 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4501 + 127i)) << bitcast<u32>(23i))));
let _e4527 = (1f - _e4526);
let _e4530 = (_e4527 / select(1e-12f, _e4023, (_e4023 > 1e-12f)));
phi_7332_ = type_31(_e4526, _e4527, vec3<f32>(((1f + (_e4361 * (1f + (_e4361 * (0.5f + (_e4361 * (0.16666667f + (_e4361 * (0.041666668f + (_e4361 * (0.008333334f + (_e4361 * (0.001388889f + (_e4361 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4356 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e4409 * (1f + (_e4409 * (0.5f + (_e4409 * (0.16666667f + (_e4409 * (0.041666668f + (_e4409 * (0.008333334f + (_e4409 * (0.001388889f + (_e4409 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4404 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e4457 * (1f + (_e4457 * (0.5f + (_e4457 * (0.16666667f + (_e4457 * (0.041666668f + (_e4457 * (0.008333334f + (_e4457 * (0.001388889f + (_e4457 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4452 + 127i)) << bitcast<u32>(23i))))), vec3<f32>(((_e4211 + (((_e4216 + (((bitcast<f32>(((_e4198 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4216) * _e3957)) - _e4211) * _e3955)) * _e4530), ((_e4248 + (((_e4253 + (((bitcast<f32>((((_e4198 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4253) * _e3957)) - _e4248) * _e3955)) * _e4530), ((_e4313 + (((_e4318 + (((bitcast<f32>(((_e4300 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4318) * _e3957)) - _e4313) * _e3955)) * _e4530)));
}
let _e4537 = phi_7332_;
let _e4538 = select(0f, _e3291, _e442);
let _e4542 = (_e378 + (_e3591 * _e4538));
let _e4543 = (_e380 + (_e3592 * _e4538));
let _e4544 = (_e374 + (_e3593 * _e4538));
if (_e727.member_2 == 3u) {
let _e4550 = global_5.member[_e350].member_9.member_1;
let _e4559 = global_5.member[_e350].member_9.member;
phi_8315_ = type_25(vec3<f32>(_e4550.member, _e4550.member_1, _e4550.member_2), vec3<f32>(_e4559.member, _e4559.member_1, _e4559.member_2));
} else {
let _e4569 = global_5.member[_e350].member_8.member_8;
let _e4570 = (_e4544 - _e4569);
let _e4575 = global_5.member[_e350].member_8.member_2;
let _e4580 = global_5.member[_e350].member_8.member_6;
let _e4588 = global_5.member[_e350].member_8.member_5;
let _e4590 = (((_e4542 - (_e4575 + (_e4580 * _e4570))) * _e4588) - 0.5f);
let _e4595 = global_5.member[_e350].member_8.member_3;
let _e4600 = global_5.member[_e350].member_8.member_7;
let _e4605 = (((_e4543 - (_e4595 + (_e4600 * _e4570))) * _e4588) - 0.5f);
let _e4610 = global_5.member[_e350].member_8.member;
let _e4611 = bitcast<i32>(_e4610);
let _e4613 = (f32(_e4611) - 1f);
let _e4618 = global_5.member[_e350].member_8.member_1;
let _e4621 = (f32(bitcast<i32>(_e4618)) - 1f);
let _e4623 = select(0f, _e4590, (_e4590 > 0f));
let _e4625 = select(_e4613, _e4623, (_e4623 < _e4613));
let _e4632 = select(0i, select(select(i32(_e4625), i32(-2147483648), (_e4625 < -2147483600f)), 2147483647i, (_e4625 > 2147483500f)), (_e4625 == _e4625));
let _e4636 = (_e4632 - select(0i, 1i, (_e4625 < f32(_e4632))));
let _e4638 = select(0f, _e4605, (_e4605 > 0f));
let _e4640 = select(_e4621, _e4638, (_e4638 < _e4621));
let _e4647 = select(0i, select(select(i32(_e4640), i32(-2147483648), (_e4640 < -2147483600f)), 2147483647i, (_e4640 > 2147483500f)), (_e4640 == _e4640));
let _e4651 = (_e4647 - select(0i, 1i, (_e4640 < f32(_e4647))));
let _e4655 = (_e4590 - f32(_e4636));
let _e4657 = (_e4605 - f32(_e4651));
let _e4664 = ((((_e4590 >= 0f) && (_e4590 <= _e4613)) && (_e4605 >= 0f)) && (_e4605 <= _e4621));
let _e4668 = global_5.member[_e350].member_4;
let _e4669 = bitcast<i32>(_e4668);
let _e4671 = bitcast<i32>((_e4610 * _e4618));
let _e4673 = (_e4669 + (3i * _e4671));
local_1 = (_e4673 + ((_e4651 * _e4611) + _e4636));
let _e4675 = local_1;
let _e4677 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e4679 = select(_e4677, _e4675, (_e4675 < _e4677));
let _e4684 = global_6.member[bitcast<u32>(select(0i, _e4679, (_e4679 > 0i)))];
let _e4685 = bitcast<u32>(_e4684);
let _e4689 = f32((bitcast<i32>((_e4685 & 65535u)) - 32768i));
let _e4695 = f32((bitcast<i32>(((_e4685 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4700 = select(_e4695, -(_e4695), ((_e4685 >> bitcast<u32>(31i)) != 0u));
let _e4701 = local_1;
let _e4702 = (_e4701 + 1i);
let _e4704 = select(_e4677, _e4702, (_e4702 < _e4677));
let _e4709 = global_6.member[bitcast<u32>(select(0i, _e4704, (_e4704 > 0i)))];
let _e4710 = bitcast<u32>(_e4709);
let _e4720 = f32((bitcast<i32>(((_e4710 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4726 = local_1;
let _e4727 = (_e4726 + _e4611);
let _e4729 = select(_e4677, _e4727, (_e4727 < _e4677));
let _e4734 = global_6.member[bitcast<u32>(select(0i, _e4729, (_e4729 > 0i)))];
let _e4735 = bitcast<u32>(_e4734);
let _e4739 = f32((bitcast<i32>((_e4735 & 65535u)) - 32768i));
let _e4745 = f32((bitcast<i32>(((_e4735 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4750 = select(_e4745, -(_e4745), ((_e4735 >> bitcast<u32>(31i)) != 0u));
let _e4751 = (_e4611 + 1i);
let _e4752 = local_1;
let _e4753 = (_e4752 + _e4751);
let _e4755 = select(_e4677, _e4753, (_e4753 < _e4677));
let _e4760 = global_6.member[bitcast<u32>(select(0i, _e4755, (_e4755 > 0i)))];
let _e4761 = bitcast<u32>(_e4760);
let _e4771 = f32((bitcast<i32>(((_e4761 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4779 = (_e4689 + ((f32((bitcast<i32>((_e4710 & 65535u)) - 32768i)) - _e4689) * _e4655));
let _e4788 = (_e4700 + ((select(_e4720, -(_e4720), ((_e4710 >> bitcast<u32>(31i)) != 0u)) - _e4700) * _e4655));
let _e4801 = global_5.member[_e350].member_9.member;
let _e4804 = (1f / 16255f);
let _e4806 = (_e4801.member + (select(0f, (_e4779 + (((_e4739 + ((f32((bitcast<i32>((_e4761 & 65535u)) - 32768i)) - _e4739) * _e4655)) - _e4779) * _e4657)), _e4664) * _e4804));
let _e4808 = (_e4801.member_1 + (select(0f, (_e4788 + (((_e4750 + ((select(_e4771, -(_e4771), ((_e4761 >> bitcast<u32>(31i)) != 0u)) - _e4750) * _e4655)) - _e4788) * _e4657)), _e4664) * _e4804));
let _e4812 = (1f - ((_e4806 * _e4806) + (_e4808 * _e4808)));
let _e4814 = select(1e-4f, _e4812, (_e4812 > 1e-4f));
let _e4817 = sqrt(select(0f, _e4814, (_e4814 > 0f)));
let _e4821 = (1f / select(1e-6f, _e4817, (_e4817 > 1e-6f)));
let _e4822 = ((_e4544 - _e374) * _e4588);
let _e4829 = (_e4590 - (((_e4806 * _e4821) - _e4580) * _e4822));
let _e4830 = (_e4605 - (((_e4808 * _e4821) - _e4600) * _e4822));
let _e4832 = select(0f, _e4829, (_e4829 > 0f));
let _e4834 = select(_e4613, _e4832, (_e4832 < _e4613));
let _e4841 = select(0i, select(select(i32(_e4834), i32(-2147483648), (_e4834 < -2147483600f)), 2147483647i, (_e4834 > 2147483500f)), (_e4834 == _e4834));
let _e4845 = (_e4841 - select(0i, 1i, (_e4834 < f32(_e4841))));
let _e4847 = select(0f, _e4830, (_e4830 > 0f));
let _e4849 = select(_e4621, _e4847, (_e4847 < _e4621));
let _e4856 = select(0i, select(select(i32(_e4849), i32(-2147483648), (_e4849 < -2147483600f)), 2147483647i, (_e4849 > 2147483500f)), (_e4849 == _e4849));
let _e4860 = (_e4856 - select(0i, 1i, (_e4849 < f32(_e4856))));
let _e4862 = ((_e4860 * _e4611) + _e4845);
let _e4864 = (_e4829 - f32(_e4845));
let _e4866 = (_e4830 - f32(_e4860));
let _e4873 = ((((_e4829 >= 0f) && (_e4829 <= _e4613)) && (_e4830 >= 0f)) && (_e4830 <= _e4621));
let _e4874 = (_e4669 + _e4862);
let _e4876 = select(_e4677, _e4874, (_e4874 < _e4677));
let _e4882 = global_6.member[bitcast<u32>(select(0i, _e4876, (_e4876 > 0i)))];
let _e4883 = (_e4874 + 1i);
let _e4885 = select(_e4677, _e4883, (_e4883 < _e4677));
let _e4891 = global_6.member[bitcast<u32>(select(0i, _e4885, (_e4885 > 0i)))];
let _e4894 = (_e4882 + ((_e4891 - _e4882) * _e4864));
let _e4895 = (_e4874 + _e4611);
let _e4897 = select(_e4677, _e4895, (_e4895 < _e4677));
let _e4903 = global_6.member[bitcast<u32>(select(0i, _e4897, (_e4897 > 0i)))];
let _e4904 = (_e4895 + 1i);
let _e4906 = select(_e4677, _e4904, (_e4904 < _e4677));
let _e4912 = global_6.member[bitcast<u32>(select(0i, _e4906, (_e4906 > 0i)))];
let _e4919 = select(1f, (_e4894 + (((_e4903 + ((_e4912 - _e4903) * _e4864)) - _e4894) * _e4866)), _e4873);
if _e3610 {
phi_8085_ = vec3(_e4919);
} else {
let _e4922 = ((_e4669 + _e4671) + _e4862);
let _e4924 = select(_e4677, _e4922, (_e4922 < _e4677));
let _e4930 = global_6.member[bitcast<u32>(select(0i, _e4924, (_e4924 > 0i)))];
let _e4931 = (_e4922 + 1i);
let _e4933 = select(_e4677, _e4931, (_e4931 < _e4677));
let _e4939 = global_6.member[bitcast<u32>(select(0i, _e4933, (_e4933 > 0i)))];
let _e4942 = (_e4930 + ((_e4939 - _e4930) * _e4864));
let _e4943 = (_e4922 + _e4611);
let _e4945 = select(_e4677, _e4943, (_e4943 < _e4677));
let _e4951 = global_6.member[bitcast<u32>(select(0i, _e4945, (_e4945 > 0i)))];
let _e4952 = (_e4943 + 1i);
let _e4954 = select(_e4677, _e4952, (_e4952 < _e4677));
let _e4960 = global_6.member[bitcast<u32>(select(0i, _e4954, (_e4954 > 0i)))];
let _e4970 = ((_e4669 + (2i * _e4671)) + _e4862);
let _e4972 = select(_e4677, _e4970, (_e4970 < _e4677));
let _e4978 = global_6.member[bitcast<u32>(select(0i, _e4972, (_e4972 > 0i)))];
let _e4979 = (_e4970 + 1i);
let _e4981 = select(_e4677, _e4979, (_e4979 < _e4677));
let _e4987 = global_6.member[bitcast<u32>(select(0i, _e4981, (_e4981 > 0i)))];
let _e4990 = (_e4978 + ((_e4987 - _e4978) * _e4864));
let _e4991 = (_e4970 + _e4611);
let _e4993 = select(_e4677, _e4991, (_e4991 < _e4677));
let _e4999 = global_6.member[bitcast<u32>(select(0i, _e4993, (_e4993 > 0i)))];
let _e5000 = (_e4991 + 1i);
let _e5002 = select(_e4677, _e5000, (_e5000 < _e4677));
let _e5008 = global_6.member[bitcast<u32>(select(0i, _e5002, (_e5002 > 0i)))];
phi_8085_ = vec3<f32>(_e4919, select(1f, (_e4942 + (((_e4951 + ((_e4960 - _e4951) * _e4864)) - _e4942) * _e4866)), _e4873), select(1f, (_e4990 + (((_e4999 + ((_e5008 - _e4999) * _e4864)) - _e4990) * _e4866)), _e4873));
}
let _e5018 = phi_8085_;
local = (_e4673 + _e4862);
let _e5020 = local;
let _e5022 = select(_e4677, _e5020, (_e5020 < _e4677));
let _e5027 = global_6.member[bitcast<u32>(select(0i, _e5022, (_e5022 > 0i)))];
let _e5028 = bitcast<u32>(_e5027);
let _e5032 = f32((bitcast<i32>((_e5028 & 65535u)) - 32768i));
let _e5038 = f32((bitcast<i32>(((_e5028 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e5043 = select(_e5038, -(_e5038), ((_e5028 >> bitcast<u32>(31i)) != 0u));
let _e5044 = local;
let _e5045 = (_e5044 + 1i);
let _e5047 = select(_e4677, _e5045, (_e5045 < _e4677));
let _e5052 = global_6.member[bitcast<u32>(select(0i, _e5047, (_e5047 > 0i)))];
let _e5053 = bitcast<u32>(_e5052);
let _e5063 = f32((bitcast<i32>(((_e5053 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e5069 = local;
let _e5070 = (_e5069 + _e4611);
let _e5072 = select(_e4677, _e5070, (_e5070 < _e4677));
let _e5077 = global_6.member[bitcast<u32>(select(0i, _e5072, (_e5072 > 0i)))];
let _e5078 = bitcast<u32>(_e5077);
let _e5082 = f32((bitcast<i32>((_e5078 & 65535u)) - 32768i));
let _e5088 = f32((bitcast<i32>(((_e5078 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e5093 = select(_e5088, -(_e5088), ((_e5078 >> bitcast<u32>(31i)) != 0u));
let _e5094 = local;
let _e5095 = (_e5094 + _e4751);
let _e5097 = select(_e4677, _e5095, (_e5095 < _e4677));
let _e5102 = global_6.member[bitcast<u32>(select(0i, _e5097, (_e5097 > 0i)))];
let _e5103 = bitcast<u32>(_e5102);
let _e5113 = f32((bitcast<i32>(((_e5103 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e5121 = (_e5032 + ((f32((bitcast<i32>((_e5053 & 65535u)) - 32768i)) - _e5032) * _e4864));
let _e5130 = (_e5043 + ((select(_e5063, -(_e5063), ((_e5053 >> bitcast<u32>(31i)) != 0u)) - _e5043) * _e4864));
let _e5143 = global_5.member[_e350].member_9.member_1;
let _e5150 = (_e4801.member + (select(0f, (_e5121 + (((_e5082 + ((f32((bitcast<i32>((_e5103 & 65535u)) - 32768i)) - _e5082) * _e4864)) - _e5121) * _e4866)), _e4873) * _e4804));
let _e5152 = (_e4801.member_1 + (select(0f, (_e5130 + (((_e5093 + ((select(_e5113, -(_e5113), ((_e5103 >> bitcast<u32>(31i)) != 0u)) - _e5093) * _e4864)) - _e5130) * _e4866)), _e4873) * _e4804));
let _e5156 = (1f - ((_e5150 * _e5150) + (_e5152 * _e5152)));
let _e5158 = select(1e-4f, _e5156, (_e5156 > 1e-4f));
phi_8315_ = type_25((_e5018 * vec3<f32>(_e5143.member, _e5143.member_1, _e5143.member_2)), vec3<f32>(_e5150, _e5152, sqrt(select(0f, _e5158, (_e5158 > 0f)))));
}
let _e5165 = phi_8315_;
let _e5174 = (((_e5165.member_1.x * _e5165.member_1.x) + (_e5165.member_1.y * _e5165.member_1.y)) + (_e5165.member_1.z * _e5165.member_1.z));
let _e5177 = sqrt(select(0f, _e5174, (_e5174 > 0f)));
let _e5183 = (1e-6f * _e5177);
let _e5187 = select((_e5177 / select(_e5183, _e5165.member_1.z, (_e5165.member_1.z > _e5183))), 1f, ((_e685 & 8u) != 0u));
let _e5189 = (_e5165.member.x * _e5187);
let _e5191 = (_e5165.member.y * _e5187);
let _e5193 = (_e5165.member.z * _e5187);
if _e801 {
let _e5198 = global_5.member[_e350].member_19;
let _e5207 = (((_e2818.member_1.x * _e2818.member_1.x) + (_e2818.member_1.y * _e2818.member_1.y)) + (_e2818.member_1.z * _e2818.member_1.z));
let _e5210 = sqrt(select(0f, _e5207, (_e5207 > 0f)));
let _e5213 = (1f / select(1e-20f, _e5210, (_e5210 > 1e-20f)));
let _e5214 = (_e2818.member_1.x * _e5213);
let _e5215 = (_e2818.member_1.y * _e5213);
let _e5216 = (_e2818.member_1.z * _e5213);
let _e5219 = (-1f / select(1e-20f, _e5177, (_e5177 > 1e-20f)));
let _e5220 = (_e5165.member_1.x * _e5219);
let _e5221 = (_e5165.member_1.y * _e5219);
let _e5222 = (_e5165.member_1.z * _e5219);
let _e5227 = (((_e354[3] * _e354[3]) + (_e354[4] * _e354[4])) + (_e354[5] * _e354[5]));
let _e5230 = sqrt(select(0f, _e5227, (_e5227 > 0f)));
let _e5233 = (-1f / select(1e-20f, _e5230, (_e5230 > 1e-20f)));
let _e5234 = (_e354[3] * _e5233);
let _e5235 = (_e354[4] * _e5233);
let _e5236 = (_e354[5] * _e5233);
let _e5243 = select(1f, -1f, ((((_e5214 * _e5234) + (_e5215 * _e5235)) + (_e5216 * _e5236)) < 0f));
let _e5244 = (_e5214 * _e5243);
let _e5245 = (_e5215 * _e5243);
let _e5246 = (_e5216 * _e5243);
let _e5251 = (((_e5244 * _e5234) + (_e5245 * _e5235)) + (_e5246 * _e5236));
let _e5253 = select(1e-4f, _e5251, (_e5251 > 1e-4f));
let _e5258 = (((_e5244 * _e5220) + (_e5245 * _e5221)) + (_e5246 * _e5222));
let _e5259 = (_e5220 + _e5234);
let _e5260 = (_e5221 + _e5235);
let _e5261 = (_e5222 + _e5236);
let _e5266 = (((_e5259 * _e5259) + (_e5260 * _e5260)) + (_e5261 * _e5261));
let _e5269 = sqrt(select(0f, _e5266, (_e5266 > 0f)));
let _e5272 = (1f / select(1e-6f, _e5269, (_e5269 > 1e-6f)));
let _e5273 = (_e5259 * _e5272);
let _e5274 = (_e5260 * _e5272);
let _e5275 = (_e5261 * _e5272);
let _e5280 = (((_e5244 * _e5273) + (_e5245 * _e5274)) + (_e5246 * _e5275));
let _e5282 = select(0f, _e5280, (_e5280 > 0f));
let _e5287 = (((_e5234 * _e5273) + (_e5235 * _e5274)) + (_e5236 * _e5275));
let _e5289 = select(0f, _e5287, (_e5287 > 0f));
let _e5290 = (_e5198 * _e5198);
let _e5291 = (_e5290 * _e5290);
let _e5295 = (((_e5282 * _e5282) * (_e5291 - 1f)) + 1f);
let _e5299 = (_e5258 > 0f);
let _e5300 = select(0f, _e5258, _e5299);
let _e5302 = (1f - _e5291);
let _e5304 = (((_e5300 * _e5300) * _e5302) + _e5291);
let _e5311 = (((_e5253 * _e5253) * _e5302) + _e5291);
let _e5316 = ((_e5253 * sqrt(select(0f, _e5304, (_e5304 > 0f)))) + (_e5300 * sqrt(select(0f, _e5311, (_e5311 > 0f)))));
let _e5321 = (_e2818.member_2 / _e3288);
let _e5325 = (((_e5321 * _e5321) - 1f) + (_e5289 * _e5289));
let _e5328 = sqrt(select(0f, _e5325, (_e5325 > 0f)));
let _e5329 = (_e5328 - _e5289);
let _e5330 = (_e5328 + _e5289);
let _e5333 = (_e5329 / select(1e-6f, _e5330, (_e5330 > 1e-6f)));
let _e5337 = ((_e5289 * _e5329) + 1f);
let _e5340 = (((_e5289 * _e5330) - 1f) / select(1e-6f, _e5337, (_e5337 > 1e-6f)));
let _e5358 = global_5.member[_e350].member_20;
let _e5362 = ((select(0f, ((((_e5291 / ((3.1415927f * _e5295) * _e5295)) * (0.5f / select(1e-6f, _e5316, (_e5316 > 1e-6f)))) * select(select((((0.5f * _e5333) * _e5333) * (1f + (_e5340 * _e5340))), 1f, (_e5325 <= 0f)), 0f, (_e3288 == _e2818.member_2))) * _e5300), (_e5299 && (_e5210 > 1e-12f))) * _e5358) * select(_e3504.member_2, 0f, _e442));
phi_8633_ = vec3<f32>((_e5189 * _e5362), (_e5191 * _e5362), (_e5193 * _e5362));
} else {
phi_8633_ = vec3<f32>(0f, 0f, 0f);
}
let _e5368 = phi_8633_;
let _e5372 = global_5.member[_e350].member_18;
let _e5379 = (1f - _e354[12]);
let _e5399 = (_e354[9] + ((_e354[13] * ((_e4537.member_3.x * (_e5189 + _e5372.member)) + _e5368.x)) * _e5379));
let _e5400 = (_e354[10] + ((_e354[14] * ((_e4537.member_3.y * (_e5191 + _e5372.member_1)) + _e5368.y)) * _e5379));
let _e5401 = (_e354[11] + ((_e354[15] * ((_e4537.member_3.z * (_e5193 + _e5372.member_2)) + _e5368.z)) * _e5379));
let _e5404 = (_e354[12] + (_e5379 * _e4537.member_1));
let _e5407 = (_e354[13] * _e4537.member_2.x);
let _e5409 = (_e354[14] * _e4537.member_2.y);
let _e5411 = (_e354[15] * _e4537.member_2.z);
let _e5416 = (_e354[8] + ((_e5404 - _e354[12]) * (_e374 + (_e3593 * 0.5f))));
let _e5425 = (-((((select(_e771.member, _e758.member, _e751) * _e5165.member_1.x) + (select(_e771.member_1, _e758.member_1, _e751) * _e5165.member_1.y)) + (select(_e771.member_2, _e758.member_2, _e751) * _e5165.member_1.z))) / select(1e-20f, _e5177, (_e5177 > 1e-20f)));
let _e5430 = bitcast<f32>((bitcast<u32>(select(0f, _e5425, (_e5425 > 0f))) & 2147483647u));
let _e5440 = (1f - _e5404);
let _e5453 = select(_e5404, 1f, _e442);
if _e801 {
let _e5462 = global_5.member[_e350].member_5.member_4;
let _e5465 = (_e2818.member_3.x * _e3504.member_2);
let _e5467 = (_e2818.member_3.y * _e3504.member_2);
let _e5469 = (_e2818.member_3.z * _e3504.member_2);
let _e5470 = (0.5f * _e369);
let _e5474 = (_e354[3] + (_e5465 * _e5470));
let _e5475 = (_e354[4] + (_e5467 * _e5470));
let _e5476 = (_e354[5] + (_e5469 * _e5470));
let _e5478 = (2f * _e368);
let _e5480 = ((_e5476 * _e5476) + (_e5478 * _e5469));
let _e5484 = (_e5476 + sqrt(select(0f, _e5480, (_e5480 > 0f))));
let _e5488 = (0.5f * (_e5478 / select(1e-6f, _e5484, (_e5484 > 1e-6f))));
let _e5492 = (_e5474 + (_e5465 * _e5488));
let _e5493 = (_e5475 + (_e5467 * _e5488));
let _e5494 = (_e5476 + (_e5469 * _e5488));
let _e5498 = (_e5462 * _e5462);
let _e5500 = (_e5494 * _e5494);
let _e5508 = (((_e5476 <= 0f) || (_e5480 <= 0f)) || ((_e5494 <= 0f) || (_e5500 <= (_e5498 * (((_e5492 * _e5492) + (_e5493 * _e5493)) + _e5500)))));
let _e5522 = (_e354[3] + ((_e2818.member_4.x * _e3504.member_2) * _e368));
let _e5523 = (_e354[4] + ((_e2818.member_4.y * _e3504.member_2) * _e368));
let _e5524 = (_e354[5] + ((_e2818.member_4.z * _e3504.member_2) * _e368));
let _e5526 = (_e5524 * _e5524);
let _e5535 = ((_e685 & 1u) != 0u);
phi_8938_ = vec3<f32>(select(select(_e5492, _e5474, _e5508), _e5522, _e5535), select(select(_e5493, _e5475, _e5508), _e5523, _e5535), select(select(_e5494, _e5476, _e5508), _e5524, _e5535));
phi_8939_ = select(_e5508, ((_e5524 <= 0f) || (_e5526 <= (_e5498 * (((_e5522 * _e5522) + (_e5523 * _e5523)) + _e5526)))), _e5535);
} else {
phi_8938_ = vec3<f32>(_e354[3], _e354[4], _e354[5]);
phi_8939_ = false;
}
let _e5542 = phi_8938_;
let _e5544 = phi_8939_;
let _e5553 = (((_e442 || (_e5542.x != _e354[3])) || (_e5542.y != _e354[4])) || (_e5542.z != _e354[5]));
let _e5555 = select(_e5409, _e5407, (_e5407 > _e5409));
phi_9004_ = array<f32, 18>(select(_e354[0], select(_e382, _e4542, _e442), _e5553), select(_e354[1], select(_e384, _e4543, _e442), _e5553), select(_e354[2], select(_e389, _e4544, _e442), _e5553), _e5542.x, _e5542.y, _e5542.z, _e2818.member, select(select(0f, 2f, _e5544), 1f, (_e442 || (((1f - _e5453) * select(_e5411, _e5555, (_e5555 > _e5411))) < 9.765625e-4f))), select(_e5416, (_e5416 + (_e5440 * _e4544)), _e442), select(_e5399, (_e5399 + ((_e5407 * (select(_e777.member, _e764.member, _e751) * ((_e5189 * _e5430) + _e5372.member))) * _e5440)), _e442), select(_e5400, (_e5400 + ((_e5409 * (select(_e777.member_1, _e764.member_1, _e751) * ((_e5191 * _e5430) + _e5372.member_1))) * _e5440)), _e442), select(_e5401, (_e5401 + ((_e5411 * (select(_e777.member_2, _e764.member_2, _e751) * ((_e5193 * _e5430) + _e5372.member_2))) * _e5440)), _e442), _e5453, _e5407, _e5409, _e5411, _e2818.member_2, _e389);
} else {
phi_9004_ = _e354;
}
let _e5574 = phi_9004_;
phi_583_ = (_e350 + 1u);
phi_586_ = select(_e352, true, _e723);
phi_588_ = _e5574;
} else {
phi_583_ = u32();
phi_586_ = bool();
phi_588_ = array<f32, 18>();
}
let _e5578 = phi_583_;
let _e5580 = phi_586_;
let _e5582 = phi_588_;
continue;
continuing {
phi_582_ = _e5578;
phi_585_ = _e5580;
phi_587_ = _e5582;
phi_9087_ = false;
break if !(_e355);
}
}
let _e5585 = phi_9087_;
if _e5585 {
break;
}
let _e5587 = local_8;
if _e5587 {
let _e5589 = local_9;
global_4.member[_e150] = _e5589[0];
let _e5594 = local_10;
global_4.member[_e162] = _e5594[1];
let _e5599 = local_11;
global_4.member[_e173] = _e5599[2];
let _e5604 = local_12;
global_4.member[_e184] = _e5604[3];
let _e5609 = local_13;
global_4.member[_e195] = _e5609[4];
let _e5614 = local_14;
global_4.member[_e206] = _e5614[5];
let _e5619 = local_15;
global_4.member[_e217] = _e5619[6];
let _e5624 = local_16;
global_4.member[_e228] = _e5624[7];
let _e5629 = local_17;
global_4.member[_e239] = _e5629[8];
let _e5634 = local_18;
global_4.member[_e250] = _e5634[9];
let _e5639 = local_19;
global_4.member[_e261] = _e5639[10];
let _e5644 = local_20;
global_4.member[_e272] = _e5644[11];
let _e5649 = local_21;
global_4.member[_e283] = _e5649[12];
let _e5654 = local_22;
global_4.member[_e294] = _e5654[13];
let _e5659 = local_23;
global_4.member[_e305] = _e5659[14];
let _e5664 = local_24;
global_4.member[_e316] = _e5664[15];
let _e5669 = local_25;
global_4.member[_e327] = _e5669[16];
let _e5674 = local_26;
global_4.member[_e338] = _e5674[17];
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
