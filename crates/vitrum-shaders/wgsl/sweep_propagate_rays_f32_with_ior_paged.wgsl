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
@group(0) @binding(2)
var<storage> global_7: type_16;
fn function_() {
var local: i32;
var local_1: i32;
var local_2: type_28;
var local_3: vec3<f32>;
var local_4: type_28;
var local_5: vec3<f32>;
var local_6: type_28;
var local_7: vec3<f32>;
var local_8: type_28;
var local_9: vec3<f32>;
var local_10: type_28;
var local_11: vec3<f32>;
var phi_587_: u32;
var phi_590_: bool;
var phi_592_: array<f32, 18>;
var phi_4902_: type_29;
var phi_5511_: type_30;
var phi_6516_: f32;
var phi_6905_: type_5;
var phi_8463_: type_31;
var phi_9216_: vec3<f32>;
var phi_9446_: type_25;
var phi_9764_: vec3<f32>;
var phi_10073_: f32;
var phi_10074_: f32;
var phi_10075_: f32;
var phi_10076_: bool;
var phi_10136_: array<f32, 18>;
var phi_588_: u32;
var phi_591_: bool;
var phi_593_: array<f32, 18>;
var phi_10219_: bool;
var local_12: bool;
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
var local_27: array<f32, 18>;
var local_28: array<f32, 18>;
var local_29: array<f32, 18>;
var local_30: array<f32, 18>;
switch bitcast<i32>(0u) {
default: {
let _e119 = global;
let _e121 = arrayLength((&global_5.member));
let _e124 = arrayLength((&global_1.member));
let _e127 = arrayLength((&global_7.member));
let _e131 = arrayLength((&global_3.member));
if (0u < _e121) {
} else {
break;
}
let _e141 = global_5.member[0u].member_2;
let _e145 = global_5.member[0u].member;
let _e153 = (_e119.x + _e141.member);
let _e155 = (_e119.y + _e141.member_1);
if (_e153 < _e141.member_2) {
if (_e155 < _e141.member_3) {
let _e158 = (_e145.member * _e145.member_1);
let _e160 = ((_e155 * _e145.member) + _e153);
let _e161 = bitcast<i32>(_e160);
let _e163 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e165 = select(_e163, _e161, (_e161 < _e163));
let _e171 = global_4.member[bitcast<u32>(select(0i, _e165, (_e165 > 0i)))];
let _e172 = (_e158 + _e160);
let _e173 = bitcast<i32>(_e172);
let _e175 = select(_e163, _e173, (_e173 < _e163));
let _e181 = global_4.member[bitcast<u32>(select(0i, _e175, (_e175 > 0i)))];
let _e183 = ((2u * _e158) + _e160);
let _e184 = bitcast<i32>(_e183);
let _e186 = select(_e163, _e184, (_e184 < _e163));
let _e192 = global_4.member[bitcast<u32>(select(0i, _e186, (_e186 > 0i)))];
let _e194 = ((3u * _e158) + _e160);
let _e195 = bitcast<i32>(_e194);
let _e197 = select(_e163, _e195, (_e195 < _e163));
let _e203 = global_4.member[bitcast<u32>(select(0i, _e197, (_e197 > 0i)))];
let _e205 = ((4u * _e158) + _e160);
let _e206 = bitcast<i32>(_e205);
let _e208 = select(_e163, _e206, (_e206 < _e163));
let _e214 = global_4.member[bitcast<u32>(select(0i, _e208, (_e208 > 0i)))];
let _e216 = ((5u * _e158) + _e160);
let _e217 = bitcast<i32>(_e216);
let _e219 = select(_e163, _e217, (_e217 < _e163));
let _e225 = global_4.member[bitcast<u32>(select(0i, _e219, (_e219 > 0i)))];
let _e227 = ((6u * _e158) + _e160);
let _e228 = bitcast<i32>(_e227);
let _e230 = select(_e163, _e228, (_e228 < _e163));
let _e236 = global_4.member[bitcast<u32>(select(0i, _e230, (_e230 > 0i)))];
let _e238 = ((7u * _e158) + _e160);
let _e239 = bitcast<i32>(_e238);
let _e241 = select(_e163, _e239, (_e239 < _e163));
let _e247 = global_4.member[bitcast<u32>(select(0i, _e241, (_e241 > 0i)))];
let _e249 = ((8u * _e158) + _e160);
let _e250 = bitcast<i32>(_e249);
let _e252 = select(_e163, _e250, (_e250 < _e163));
let _e258 = global_4.member[bitcast<u32>(select(0i, _e252, (_e252 > 0i)))];
let _e260 = ((9u * _e158) + _e160);
let _e261 = bitcast<i32>(_e260);
let _e263 = select(_e163, _e261, (_e261 < _e163));
let _e269 = global_4.member[bitcast<u32>(select(0i, _e263, (_e263 > 0i)))];
let _e271 = ((10u * _e158) + _e160);
let _e272 = bitcast<i32>(_e271);
let _e274 = select(_e163, _e272, (_e272 < _e163));
let _e280 = global_4.member[bitcast<u32>(select(0i, _e274, (_e274 > 0i)))];
let _e282 = ((11u * _e158) + _e160);
let _e283 = bitcast<i32>(_e282);
let _e285 = select(_e163, _e283, (_e283 < _e163));
let _e291 = global_4.member[bitcast<u32>(select(0i, _e285, (_e285 > 0i)))];
let _e293 = ((12u * _e158) + _e160);
let _e294 = bitcast<i32>(_e293);
let _e296 = select(_e163, _e294, (_e294 < _e163));
let _e302 = global_4.member[bitcast<u32>(select(0i, _e296, (_e296 > 0i)))];
let _e304 = ((13u * _e158) + _e160);
let _e305 = bitcast<i32>(_e304);
let _e307 = select(_e163, _e305, (_e305 < _e163));
let _e313 = global_4.member[bitcast<u32>(select(0i, _e307, (_e307 > 0i)))];
let _e315 = ((14u * _e158) + _e160);
let _e316 = bitcast<i32>(_e315);
let _e318 = select(_e163, _e316, (_e316 < _e163));
let _e324 = global_4.member[bitcast<u32>(select(0i, _e318, (_e318 > 0i)))];
let _e326 = ((15u * _e158) + _e160);
let _e327 = bitcast<i32>(_e326);
let _e329 = select(_e163, _e327, (_e327 < _e163));
let _e335 = global_4.member[bitcast<u32>(select(0i, _e329, (_e329 > 0i)))];
let _e337 = ((16u * _e158) + _e160);
let _e338 = bitcast<i32>(_e337);
let _e340 = select(_e163, _e338, (_e338 < _e163));
let _e346 = global_4.member[bitcast<u32>(select(0i, _e340, (_e340 > 0i)))];
let _e348 = ((17u * _e158) + _e160);
let _e349 = bitcast<i32>(_e348);
let _e351 = select(_e163, _e349, (_e349 < _e163));
let _e357 = global_4.member[bitcast<u32>(select(0i, _e351, (_e351 > 0i)))];
phi_587_ = 0u;
phi_590_ = false;
phi_592_ = array<f32, 18>(_e171, _e181, _e192, _e203, _e214, _e225, _e236, _e247, _e258, _e269, _e280, _e291, _e302, _e313, _e324, _e335, _e346, _e357);
loop {
let _e360 = phi_587_;
let _e362 = phi_590_;
let _e364 = phi_592_;
local_12 = _e362;
local_13 = _e364;
local_14 = _e364;
local_15 = _e364;
local_16 = _e364;
local_17 = _e364;
local_18 = _e364;
local_19 = _e364;
local_20 = _e364;
local_21 = _e364;
local_22 = _e364;
local_23 = _e364;
local_24 = _e364;
local_25 = _e364;
local_26 = _e364;
local_27 = _e364;
local_28 = _e364;
local_29 = _e364;
local_30 = _e364;
let _e365 = (_e360 < _e121);
if _e365 {
if _e365 {
} else {
phi_10219_ = true;
break;
}
let _e373 = global_5.member[_e360].member_5.member_2;
let _e374 = (_e373 / _e364[4]);
let _e379 = global_5.member[_e360].member_5.member;
let _e382 = ((_e379 - _e364[16]) / _e364[4]);
let _e385 = (_e364[0] + (_e364[2] * _e382));
let _e388 = (_e364[1] + (_e364[3] * _e382));
let _e390 = (_e385 + (_e364[2] * _e374));
let _e392 = (_e388 + (_e364[3] * _e374));
let _e397 = global_5.member[_e360].member_5.member_1;
let _e403 = global_5.member[_e360].member_13.member.member;
let _e414 = ((((_e403.member.member * _e385) + (_e403.member.member_1 * _e388)) + (_e403.member.member_2 * _e379)) + _e403.member_1);
let _e420 = ((((_e403.member.member * _e390) + (_e403.member.member_1 * _e392)) + (_e403.member.member_2 * _e397)) + _e403.member_1);
let _e423 = ((_e414 > 0f) && (_e420 <= 0f));
let _e429 = global_5.member[_e360].member_13.member_1.member;
let _e440 = ((((_e429.member.member * _e385) + (_e429.member.member_1 * _e388)) + (_e429.member.member_2 * _e379)) + _e429.member_1);
let _e446 = ((((_e429.member.member * _e390) + (_e429.member.member_1 * _e392)) + (_e429.member.member_2 * _e397)) + _e429.member_1);
let _e449 = ((_e440 > 0f) && (_e446 <= 0f));
let _e450 = (_e423 || _e449);
let _e455 = global_5.member[_e360].member_6.member;
let _e466 = ((((_e455.member.member * _e385) + (_e455.member.member_1 * _e388)) + (_e455.member.member_2 * _e379)) + _e455.member_1);
let _e471 = global_5.member[_e360].member_6.member_1;
let _e482 = ((((_e471.member.member * _e385) + (_e471.member.member_1 * _e388)) + (_e471.member.member_2 * _e379)) + _e471.member_1);
let _e487 = global_5.member[_e360].member_6.member_2;
let _e498 = ((((_e487.member.member * _e385) + (_e487.member.member_1 * _e388)) + (_e487.member.member_2 * _e379)) + _e487.member_1);
let _e504 = ((((_e455.member.member * _e390) + (_e455.member.member_1 * _e392)) + (_e455.member.member_2 * _e397)) + _e455.member_1);
let _e510 = ((((_e471.member.member * _e390) + (_e471.member.member_1 * _e392)) + (_e471.member.member_2 * _e397)) + _e471.member_1);
let _e516 = ((((_e487.member.member * _e390) + (_e487.member.member_1 * _e392)) + (_e487.member.member_2 * _e397)) + _e487.member_1);
let _e521 = global_5.member[_e360].member_6.member_4;
let _e527 = global_5.member[_e360].member_6.member_3.member;
let _e528 = (_e527 - 0.5f);
let _e530 = select(-0.5f, _e504, (_e504 > -0.5f));
let _e532 = select(_e528, _e530, (_e530 < _e528));
let _e538 = global_5.member[_e360].member_6.member_3.member_1;
let _e539 = (_e538 - 0.5f);
let _e541 = select(-0.5f, _e510, (_e510 > -0.5f));
let _e543 = select(_e539, _e541, (_e541 < _e539));
let _e549 = global_5.member[_e360].member_6.member_3.member_2;
let _e550 = (_e549 - 0.5f);
let _e552 = select(-0.5f, _e516, (_e516 > -0.5f));
let _e554 = select(_e550, _e552, (_e552 < _e550));
let _e555 = (_e504 - _e466);
let _e556 = (_e510 - _e482);
let _e557 = (_e516 - _e498);
let _e560 = bitcast<f32>((bitcast<u32>(_e555) & 2147483647u));
let _e563 = bitcast<f32>((bitcast<u32>(_e556) & 2147483647u));
let _e565 = select(_e563, _e560, (_e560 > _e563));
let _e568 = bitcast<f32>((bitcast<u32>(_e557) & 2147483647u));
let _e577 = bitcast<f32>((bitcast<u32>((_e504 - _e532)) & 2147483647u));
let _e580 = bitcast<f32>((bitcast<u32>((_e510 - _e543)) & 2147483647u));
let _e582 = select(_e580, _e577, (_e577 > _e580));
let _e585 = bitcast<f32>((bitcast<u32>((_e516 - _e554)) & 2147483647u));
let _e589 = (_e532 + 0.5f);
let _e590 = (_e527 - 1f);
let _e592 = select(0f, _e589, (_e589 > 0f));
let _e594 = select(_e590, _e592, (_e592 < _e590));
let _e601 = select(0i, select(select(i32(_e594), i32(-2147483648), (_e594 < -2147483600f)), 2147483647i, (_e594 > 2147483500f)), (_e594 == _e594));
let _e610 = global_5.member[_e360].member_6.member_12;
let _e611 = (_e610 & 31u);
let _e614 = (_e543 + 0.5f);
let _e615 = (_e538 - 1f);
let _e617 = select(0f, _e614, (_e614 > 0f));
let _e619 = select(_e615, _e617, (_e617 < _e615));
let _e626 = select(0i, select(select(i32(_e619), i32(-2147483648), (_e619 < -2147483600f)), 2147483647i, (_e619 > 2147483500f)), (_e619 == _e619));
let _e633 = (_e554 + 0.5f);
let _e634 = (_e549 - 1f);
let _e636 = select(0f, _e633, (_e633 > 0f));
let _e638 = select(_e634, _e636, (_e636 < _e634));
let _e645 = select(0i, select(select(i32(_e638), i32(-2147483648), (_e638 < -2147483600f)), 2147483647i, (_e638 > 2147483500f)), (_e638 == _e638));
let _e657 = global_5.member[_e360].member_6.member_9.member;
let _e664 = global_5.member[_e360].member_6.member_9.member_1;
let _e670 = global_5.member[_e360].member_6.member_10;
let _e676 = ((bitcast<i32>(_e670) + ((_e601 - select(0i, 1i, (_e594 < f32(_e601)))) >> bitcast<u32>(_e611))) + (bitcast<i32>(_e657) * (((_e626 - select(0i, 1i, (_e619 < f32(_e626)))) >> bitcast<u32>(_e611)) + (bitcast<i32>(_e664) * ((_e645 - select(0i, 1i, (_e638 < f32(_e645)))) >> bitcast<u32>(_e611))))));
let _e678 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e680 = select(_e678, _e676, (_e676 < _e678));
let _e686 = global_2.member[bitcast<u32>(select(0i, _e680, (_e680 > 0i)))];
let _e694 = global_5.member[_e360].member_7.member;
let _e705 = ((((_e694.member.member * _e385) + (_e694.member.member_1 * _e388)) + (_e694.member.member_2 * _e379)) + _e694.member_1);
let _e710 = global_5.member[_e360].member_7.member_1;
let _e721 = ((((_e710.member.member * _e385) + (_e710.member.member_1 * _e388)) + (_e710.member.member_2 * _e379)) + _e710.member_1);
let _e726 = global_5.member[_e360].member_7.member_2;
let _e737 = ((((_e726.member.member * _e385) + (_e726.member.member_1 * _e388)) + (_e726.member.member_2 * _e379)) + _e726.member_1);
let _e743 = ((((_e694.member.member * _e390) + (_e694.member.member_1 * _e392)) + (_e694.member.member_2 * _e397)) + _e694.member_1);
let _e749 = ((((_e710.member.member * _e390) + (_e710.member.member_1 * _e392)) + (_e710.member.member_2 * _e397)) + _e710.member_1);
let _e755 = ((((_e726.member.member * _e390) + (_e726.member.member_1 * _e392)) + (_e726.member.member_2 * _e397)) + _e726.member_1);
let _e760 = global_5.member[_e360].member_7.member_4;
let _e766 = global_5.member[_e360].member_7.member_3.member;
let _e767 = (_e766 - 0.5f);
let _e769 = select(-0.5f, _e743, (_e743 > -0.5f));
let _e771 = select(_e767, _e769, (_e769 < _e767));
let _e777 = global_5.member[_e360].member_7.member_3.member_1;
let _e778 = (_e777 - 0.5f);
let _e780 = select(-0.5f, _e749, (_e749 > -0.5f));
let _e782 = select(_e778, _e780, (_e780 < _e778));
let _e788 = global_5.member[_e360].member_7.member_3.member_2;
let _e789 = (_e788 - 0.5f);
let _e791 = select(-0.5f, _e755, (_e755 > -0.5f));
let _e793 = select(_e789, _e791, (_e791 < _e789));
let _e799 = bitcast<f32>((bitcast<u32>((_e743 - _e705)) & 2147483647u));
let _e802 = bitcast<f32>((bitcast<u32>((_e749 - _e721)) & 2147483647u));
let _e804 = select(_e802, _e799, (_e799 > _e802));
let _e807 = bitcast<f32>((bitcast<u32>((_e755 - _e737)) & 2147483647u));
let _e816 = bitcast<f32>((bitcast<u32>((_e743 - _e771)) & 2147483647u));
let _e819 = bitcast<f32>((bitcast<u32>((_e749 - _e782)) & 2147483647u));
let _e821 = select(_e819, _e816, (_e816 > _e819));
let _e824 = bitcast<f32>((bitcast<u32>((_e755 - _e793)) & 2147483647u));
let _e828 = (_e771 + 0.5f);
let _e829 = (_e766 - 1f);
let _e831 = select(0f, _e828, (_e828 > 0f));
let _e833 = select(_e829, _e831, (_e831 < _e829));
let _e840 = select(0i, select(select(i32(_e833), i32(-2147483648), (_e833 < -2147483600f)), 2147483647i, (_e833 > 2147483500f)), (_e833 == _e833));
let _e849 = global_5.member[_e360].member_7.member_12;
let _e850 = (_e849 & 31u);
let _e853 = (_e782 + 0.5f);
let _e854 = (_e777 - 1f);
let _e856 = select(0f, _e853, (_e853 > 0f));
let _e858 = select(_e854, _e856, (_e856 < _e854));
let _e865 = select(0i, select(select(i32(_e858), i32(-2147483648), (_e858 < -2147483600f)), 2147483647i, (_e858 > 2147483500f)), (_e858 == _e858));
let _e872 = (_e793 + 0.5f);
let _e873 = (_e788 - 1f);
let _e875 = select(0f, _e872, (_e872 > 0f));
let _e877 = select(_e873, _e875, (_e875 < _e873));
let _e884 = select(0i, select(select(i32(_e877), i32(-2147483648), (_e877 < -2147483600f)), 2147483647i, (_e877 > 2147483500f)), (_e877 == _e877));
let _e896 = global_5.member[_e360].member_7.member_9.member;
let _e903 = global_5.member[_e360].member_7.member_9.member_1;
let _e909 = global_5.member[_e360].member_7.member_10;
let _e915 = ((bitcast<i32>(_e909) + ((_e840 - select(0i, 1i, (_e833 < f32(_e840)))) >> bitcast<u32>(_e850))) + (bitcast<i32>(_e896) * (((_e865 - select(0i, 1i, (_e858 < f32(_e865)))) >> bitcast<u32>(_e850)) + (bitcast<i32>(_e903) * ((_e884 - select(0i, 1i, (_e877 < f32(_e884)))) >> bitcast<u32>(_e850))))));
let _e917 = select(_e678, _e915, (_e915 < _e678));
let _e923 = global_2.member[bitcast<u32>(select(0i, _e917, (_e917 > 0i)))];
let _e930 = global_5.member[_e360].member_1;
let _e963 = (_e364[17] != _e379);
let _e970 = (select(0u, select(select(select(select(7u, 3u, (((((((_e466 >= 0f) && (_e466 <= _e590)) && (_e482 >= 0f)) && (_e482 <= _e615)) && (_e498 >= 0f)) && (_e498 <= _e634)) && ((((((_e504 >= 0f) && (_e504 <= _e590)) && (_e510 >= 0f)) && (_e510 <= _e615)) && (_e516 >= 0f)) && (_e516 <= _e634)))), 15u, _e963), 1u, (((_e930 & 64u) != 0u) || ((((select(_e568, _e565, (_e565 > _e568)) <= _e521) && ((select(_e585, _e582, (_e582 > _e585)) > _e521) || (_e686 != 0u))) && ((select(_e807, _e804, (_e804 > _e807)) <= _e760) && ((select(_e824, _e821, (_e821 > _e824)) > _e760) || (_e923 != 0u)))) && ((_e930 & 32u) != 0u)))), 31u, _e450), (_e364[6] == 0f)) > 1u);
if _e970 {
let _e974 = global_5.member[_e360].member;
let _e976 = (_e414 - _e420);
let _e979 = (_e414 / select(1e-20f, _e976, (_e976 > 1e-20f)));
let _e980 = (_e440 - _e446);
let _e983 = (_e440 / select(1e-20f, _e980, (_e980 > 1e-20f)));
let _e987 = (_e449 && (!(_e423) || (_e983 < _e979)));
let _e994 = global_5.member[_e360].member_13.member_1.member.member;
let _e1000 = global_5.member[_e360].member_13.member_1.member_1;
let _e1007 = global_5.member[_e360].member_13.member.member.member;
let _e1013 = global_5.member[_e360].member_13.member.member_1;
let _e1032 = select(_e979, _e983, _e987);
let _e1034 = (_e974.member_2 == 2u);
let _e1037 = (((_e974.member_2 == 1u) || _e1034) || (_e974.member_2 == 5u));
if _e1037 {
let _e1039 = select(-1f, _e532, (_e532 > -1f));
let _e1041 = select(_e527, _e1039, (_e1039 < _e527));
let _e1048 = select(0i, select(select(i32(_e1041), i32(-2147483648), (_e1041 < -2147483600f)), 2147483647i, (_e1041 > 2147483500f)), (_e1041 == _e1041));
let _e1052 = (_e1048 - select(0i, 1i, (_e1041 < f32(_e1048))));
let _e1054 = select(-1f, _e543, (_e543 > -1f));
let _e1056 = select(_e538, _e1054, (_e1054 < _e538));
let _e1063 = select(0i, select(select(i32(_e1056), i32(-2147483648), (_e1056 < -2147483600f)), 2147483647i, (_e1056 > 2147483500f)), (_e1056 == _e1056));
let _e1067 = (_e1063 - select(0i, 1i, (_e1056 < f32(_e1063))));
let _e1069 = select(-1f, _e554, (_e554 > -1f));
let _e1071 = select(_e549, _e1069, (_e1069 < _e549));
let _e1078 = select(0i, select(select(i32(_e1071), i32(-2147483648), (_e1071 < -2147483600f)), 2147483647i, (_e1071 > 2147483500f)), (_e1071 == _e1071));
let _e1082 = (_e1078 - select(0i, 1i, (_e1071 < f32(_e1078))));
let _e1087 = global_5.member[_e360].member_6.member_7;
let _e1092 = global_5.member[_e360].member_6.member_8;
let _e1093 = (_e1052 + 1i);
let _e1094 = (_e1067 + 1i);
let _e1095 = (_e1082 + 1i);
let _e1101 = global_5.member[_e360].member_6.member_11.member;
let _e1108 = global_5.member[_e360].member_6.member_11.member_1;
let _e1119 = ((_e1093 >> bitcast<u32>(4i)) + (bitcast<i32>(_e1101) * ((_e1094 >> bitcast<u32>(4i)) + (bitcast<i32>(_e1108) * (_e1095 >> bitcast<u32>(4i))))));
let _e1121 = (bitcast<i32>(_e124) - 1i);
let _e1123 = select(_e1121, _e1119, (_e1119 < _e1121));
let _e1129 = global_1.member[bitcast<u32>(select(0i, _e1123, (_e1123 > 0i)))];
let _e1131 = (_e1093 & 15i);
let _e1134 = ((_e1094 & 15i) * _e1087);
let _e1136 = (bitcast<i32>(_e1129) + ((_e1095 & 15i) * _e1092));
let _e1140 = (_e1134 + _e1087);
let _e1142 = (_e1134 + (2i * _e1087));
let _e1143 = (_e1136 + _e1092);
let _e1145 = (_e1136 + (2i * _e1092));
local_10 = type_28(array<i32, 4>(_e1131, (_e1131 + 1i), (_e1131 + 2i), (_e1131 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_11 = vec3<f32>((_e532 - f32(_e1052)), (_e543 - f32(_e1067)), (_e554 - f32(_e1082)));
let _e1156 = (_e1143 + _e1140);
let _e1159 = local_10.member[1u];
let _e1160 = (_e1156 + _e1159);
let _e1162 = select(_e1121, _e1160, (_e1160 < _e1121));
let _e1167 = global_1.member[bitcast<u32>(select(0i, _e1162, (_e1162 > 0i)))];
let _e1168 = bitcast<f32>(_e1167);
let _e1171 = local_10.member[2u];
let _e1172 = (_e1156 + _e1171);
let _e1174 = select(_e1121, _e1172, (_e1172 < _e1121));
let _e1179 = global_1.member[bitcast<u32>(select(0i, _e1174, (_e1174 > 0i)))];
let _e1181 = local_11[0u];
let _e1184 = (_e1168 + ((bitcast<f32>(_e1179) - _e1168) * _e1181));
let _e1185 = (_e1143 + _e1142);
let _e1186 = local_10.member[1u];
let _e1187 = (_e1185 + _e1186);
let _e1189 = select(_e1121, _e1187, (_e1187 < _e1121));
let _e1194 = global_1.member[bitcast<u32>(select(0i, _e1189, (_e1189 > 0i)))];
let _e1195 = bitcast<f32>(_e1194);
let _e1196 = local_10.member[2u];
let _e1197 = (_e1185 + _e1196);
let _e1199 = select(_e1121, _e1197, (_e1197 < _e1121));
let _e1204 = global_1.member[bitcast<u32>(select(0i, _e1199, (_e1199 > 0i)))];
let _e1206 = local_11[0u];
let _e1210 = (_e1145 + _e1140);
let _e1211 = local_10.member[1u];
let _e1212 = (_e1210 + _e1211);
let _e1214 = select(_e1121, _e1212, (_e1212 < _e1121));
let _e1219 = global_1.member[bitcast<u32>(select(0i, _e1214, (_e1214 > 0i)))];
let _e1220 = bitcast<f32>(_e1219);
let _e1221 = local_10.member[2u];
let _e1222 = (_e1210 + _e1221);
let _e1224 = select(_e1121, _e1222, (_e1222 < _e1121));
let _e1229 = global_1.member[bitcast<u32>(select(0i, _e1224, (_e1224 > 0i)))];
let _e1231 = local_11[0u];
let _e1234 = (_e1220 + ((bitcast<f32>(_e1229) - _e1220) * _e1231));
let _e1235 = (_e1145 + _e1142);
let _e1236 = local_10.member[1u];
let _e1237 = (_e1235 + _e1236);
let _e1239 = select(_e1121, _e1237, (_e1237 < _e1121));
let _e1244 = global_1.member[bitcast<u32>(select(0i, _e1239, (_e1239 > 0i)))];
let _e1245 = bitcast<f32>(_e1244);
let _e1246 = local_10.member[2u];
let _e1247 = (_e1235 + _e1246);
let _e1249 = select(_e1121, _e1247, (_e1247 < _e1121));
let _e1254 = global_1.member[bitcast<u32>(select(0i, _e1249, (_e1249 > 0i)))];
let _e1256 = local_11[0u];
let _e1261 = local_11[1u];
let _e1264 = (_e1184 + (((_e1195 + ((bitcast<f32>(_e1204) - _e1195) * _e1206)) - _e1184) * _e1261));
let _e1265 = local_11[1u];
let _e1270 = local_11[2u];
let _e1278 = global_5.member[_e360].member_6.member_5;
let _e1284 = global_5.member[_e360].member_6.member_6;
let _e1285 = (((_e1264 + (((_e1234 + (((_e1245 + ((bitcast<f32>(_e1254) - _e1245) * _e1256)) - _e1234) * _e1265)) - _e1264) * _e1270)) * _e1278) + _e1284);
let _e1287 = select(0f, _e1285, (_e1285 > 0f));
let _e1291 = select(-1f, _e771, (_e771 > -1f));
let _e1293 = select(_e766, _e1291, (_e1291 < _e766));
let _e1300 = select(0i, select(select(i32(_e1293), i32(-2147483648), (_e1293 < -2147483600f)), 2147483647i, (_e1293 > 2147483500f)), (_e1293 == _e1293));
let _e1304 = (_e1300 - select(0i, 1i, (_e1293 < f32(_e1300))));
let _e1306 = select(-1f, _e782, (_e782 > -1f));
let _e1308 = select(_e777, _e1306, (_e1306 < _e777));
let _e1315 = select(0i, select(select(i32(_e1308), i32(-2147483648), (_e1308 < -2147483600f)), 2147483647i, (_e1308 > 2147483500f)), (_e1308 == _e1308));
let _e1319 = (_e1315 - select(0i, 1i, (_e1308 < f32(_e1315))));
let _e1321 = select(-1f, _e793, (_e793 > -1f));
let _e1323 = select(_e788, _e1321, (_e1321 < _e788));
let _e1330 = select(0i, select(select(i32(_e1323), i32(-2147483648), (_e1323 < -2147483600f)), 2147483647i, (_e1323 > 2147483500f)), (_e1323 == _e1323));
let _e1334 = (_e1330 - select(0i, 1i, (_e1323 < f32(_e1330))));
let _e1339 = global_5.member[_e360].member_7.member_7;
let _e1344 = global_5.member[_e360].member_7.member_8;
let _e1345 = (_e1304 + 1i);
let _e1346 = (_e1319 + 1i);
let _e1347 = (_e1334 + 1i);
let _e1353 = global_5.member[_e360].member_7.member_11.member;
let _e1360 = global_5.member[_e360].member_7.member_11.member_1;
let _e1371 = ((_e1345 >> bitcast<u32>(4i)) + (bitcast<i32>(_e1353) * ((_e1346 >> bitcast<u32>(4i)) + (bitcast<i32>(_e1360) * (_e1347 >> bitcast<u32>(4i))))));
let _e1373 = (bitcast<i32>(_e127) - 1i);
let _e1375 = select(_e1373, _e1371, (_e1371 < _e1373));
let _e1381 = global_7.member[bitcast<u32>(select(0i, _e1375, (_e1375 > 0i)))];
let _e1383 = (_e1345 & 15i);
let _e1386 = ((_e1346 & 15i) * _e1339);
let _e1388 = (bitcast<i32>(_e1381) + ((_e1347 & 15i) * _e1344));
let _e1392 = (_e1386 + _e1339);
let _e1394 = (_e1386 + (2i * _e1339));
let _e1396 = (_e1386 + (3i * _e1339));
let _e1397 = (_e1388 + _e1344);
let _e1399 = (_e1388 + (2i * _e1344));
let _e1401 = (_e1388 + (3i * _e1344));
local_8 = type_28(array<i32, 4>(_e1383, (_e1383 + 1i), (_e1383 + 2i), (_e1383 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_9 = vec3<f32>((_e771 - f32(_e1304)), (_e782 - f32(_e1319)), (_e793 - f32(_e1334)));
let _e1412 = (_e1397 + _e1392);
let _e1415 = local_8.member[0u];
let _e1416 = (_e1412 + _e1415);
let _e1418 = select(_e1373, _e1416, (_e1416 < _e1373));
let _e1423 = global_7.member[bitcast<u32>(select(0i, _e1418, (_e1418 > 0i)))];
let _e1424 = bitcast<f32>(_e1423);
let _e1427 = local_8.member[1u];
let _e1428 = (_e1412 + _e1427);
let _e1430 = select(_e1373, _e1428, (_e1428 < _e1373));
let _e1435 = global_7.member[bitcast<u32>(select(0i, _e1430, (_e1430 > 0i)))];
let _e1436 = bitcast<f32>(_e1435);
let _e1439 = local_8.member[2u];
let _e1440 = (_e1412 + _e1439);
let _e1442 = select(_e1373, _e1440, (_e1440 < _e1373));
let _e1447 = global_7.member[bitcast<u32>(select(0i, _e1442, (_e1442 > 0i)))];
let _e1448 = bitcast<f32>(_e1447);
let _e1451 = local_8.member[3u];
let _e1452 = (_e1412 + _e1451);
let _e1454 = select(_e1373, _e1452, (_e1452 < _e1373));
let _e1459 = global_7.member[bitcast<u32>(select(0i, _e1454, (_e1454 > 0i)))];
let _e1461 = local_9[0u];
let _e1464 = (_e1424 + ((_e1436 - _e1424) * _e1461));
let _e1465 = local_9[0u];
let _e1468 = (_e1436 + ((_e1448 - _e1436) * _e1465));
let _e1469 = local_9[0u];
let _e1472 = (_e1448 + ((bitcast<f32>(_e1459) - _e1448) * _e1469));
let _e1473 = (_e1397 + _e1394);
let _e1474 = local_8.member[0u];
let _e1475 = (_e1473 + _e1474);
let _e1477 = select(_e1373, _e1475, (_e1475 < _e1373));
let _e1482 = global_7.member[bitcast<u32>(select(0i, _e1477, (_e1477 > 0i)))];
let _e1483 = bitcast<f32>(_e1482);
let _e1484 = local_8.member[1u];
let _e1485 = (_e1473 + _e1484);
let _e1487 = select(_e1373, _e1485, (_e1485 < _e1373));
let _e1492 = global_7.member[bitcast<u32>(select(0i, _e1487, (_e1487 > 0i)))];
let _e1493 = bitcast<f32>(_e1492);
let _e1494 = local_8.member[2u];
let _e1495 = (_e1473 + _e1494);
let _e1497 = select(_e1373, _e1495, (_e1495 < _e1373));
let _e1502 = global_7.member[bitcast<u32>(select(0i, _e1497, (_e1497 > 0i)))];
let _e1503 = bitcast<f32>(_e1502);
let _e1504 = local_8.member[3u];
let _e1505 = (_e1473 + _e1504);
let _e1507 = select(_e1373, _e1505, (_e1505 < _e1373));
let _e1512 = global_7.member[bitcast<u32>(select(0i, _e1507, (_e1507 > 0i)))];
let _e1514 = local_9[0u];
let _e1518 = local_9[0u];
let _e1521 = (_e1493 + ((_e1503 - _e1493) * _e1518));
let _e1522 = local_9[0u];
let _e1526 = (_e1399 + _e1392);
let _e1527 = local_8.member[0u];
let _e1528 = (_e1526 + _e1527);
let _e1530 = select(_e1373, _e1528, (_e1528 < _e1373));
let _e1535 = global_7.member[bitcast<u32>(select(0i, _e1530, (_e1530 > 0i)))];
let _e1536 = bitcast<f32>(_e1535);
let _e1537 = local_8.member[1u];
let _e1538 = (_e1526 + _e1537);
let _e1540 = select(_e1373, _e1538, (_e1538 < _e1373));
let _e1545 = global_7.member[bitcast<u32>(select(0i, _e1540, (_e1540 > 0i)))];
let _e1546 = bitcast<f32>(_e1545);
let _e1547 = local_8.member[2u];
let _e1548 = (_e1526 + _e1547);
let _e1550 = select(_e1373, _e1548, (_e1548 < _e1373));
let _e1555 = global_7.member[bitcast<u32>(select(0i, _e1550, (_e1550 > 0i)))];
let _e1556 = bitcast<f32>(_e1555);
let _e1557 = local_8.member[3u];
let _e1558 = (_e1526 + _e1557);
let _e1560 = select(_e1373, _e1558, (_e1558 < _e1373));
let _e1565 = global_7.member[bitcast<u32>(select(0i, _e1560, (_e1560 > 0i)))];
let _e1567 = local_9[0u];
let _e1570 = (_e1536 + ((_e1546 - _e1536) * _e1567));
let _e1571 = local_9[0u];
let _e1574 = (_e1546 + ((_e1556 - _e1546) * _e1571));
let _e1575 = local_9[0u];
let _e1578 = (_e1556 + ((bitcast<f32>(_e1565) - _e1556) * _e1575));
let _e1579 = (_e1399 + _e1394);
let _e1580 = local_8.member[0u];
let _e1581 = (_e1579 + _e1580);
let _e1583 = select(_e1373, _e1581, (_e1581 < _e1373));
let _e1588 = global_7.member[bitcast<u32>(select(0i, _e1583, (_e1583 > 0i)))];
let _e1589 = bitcast<f32>(_e1588);
let _e1590 = local_8.member[1u];
let _e1591 = (_e1579 + _e1590);
let _e1593 = select(_e1373, _e1591, (_e1591 < _e1373));
let _e1598 = global_7.member[bitcast<u32>(select(0i, _e1593, (_e1593 > 0i)))];
let _e1599 = bitcast<f32>(_e1598);
let _e1600 = local_8.member[2u];
let _e1601 = (_e1579 + _e1600);
let _e1603 = select(_e1373, _e1601, (_e1601 < _e1373));
let _e1608 = global_7.member[bitcast<u32>(select(0i, _e1603, (_e1603 > 0i)))];
let _e1609 = bitcast<f32>(_e1608);
let _e1610 = local_8.member[3u];
let _e1611 = (_e1579 + _e1610);
let _e1613 = select(_e1373, _e1611, (_e1611 < _e1373));
let _e1618 = global_7.member[bitcast<u32>(select(0i, _e1613, (_e1613 > 0i)))];
let _e1620 = local_9[0u];
let _e1624 = local_9[0u];
let _e1627 = (_e1599 + ((_e1609 - _e1599) * _e1624));
let _e1628 = local_9[0u];
let _e1632 = (_e1397 + _e1386);
let _e1633 = local_8.member[1u];
let _e1634 = (_e1632 + _e1633);
let _e1636 = select(_e1373, _e1634, (_e1634 < _e1373));
let _e1641 = global_7.member[bitcast<u32>(select(0i, _e1636, (_e1636 > 0i)))];
let _e1642 = bitcast<f32>(_e1641);
let _e1643 = local_8.member[2u];
let _e1644 = (_e1632 + _e1643);
let _e1646 = select(_e1373, _e1644, (_e1644 < _e1373));
let _e1651 = global_7.member[bitcast<u32>(select(0i, _e1646, (_e1646 > 0i)))];
let _e1653 = local_9[0u];
let _e1656 = (_e1642 + ((bitcast<f32>(_e1651) - _e1642) * _e1653));
let _e1657 = (_e1397 + _e1396);
let _e1658 = local_8.member[1u];
let _e1659 = (_e1657 + _e1658);
let _e1661 = select(_e1373, _e1659, (_e1659 < _e1373));
let _e1666 = global_7.member[bitcast<u32>(select(0i, _e1661, (_e1661 > 0i)))];
let _e1667 = bitcast<f32>(_e1666);
let _e1668 = local_8.member[2u];
let _e1669 = (_e1657 + _e1668);
let _e1671 = select(_e1373, _e1669, (_e1669 < _e1373));
let _e1676 = global_7.member[bitcast<u32>(select(0i, _e1671, (_e1671 > 0i)))];
let _e1678 = local_9[0u];
let _e1682 = (_e1399 + _e1386);
let _e1683 = local_8.member[1u];
let _e1684 = (_e1682 + _e1683);
let _e1686 = select(_e1373, _e1684, (_e1684 < _e1373));
let _e1691 = global_7.member[bitcast<u32>(select(0i, _e1686, (_e1686 > 0i)))];
let _e1692 = bitcast<f32>(_e1691);
let _e1693 = local_8.member[2u];
let _e1694 = (_e1682 + _e1693);
let _e1696 = select(_e1373, _e1694, (_e1694 < _e1373));
let _e1701 = global_7.member[bitcast<u32>(select(0i, _e1696, (_e1696 > 0i)))];
let _e1703 = local_9[0u];
let _e1706 = (_e1692 + ((bitcast<f32>(_e1701) - _e1692) * _e1703));
let _e1707 = (_e1399 + _e1396);
let _e1708 = local_8.member[1u];
let _e1709 = (_e1707 + _e1708);
let _e1711 = select(_e1373, _e1709, (_e1709 < _e1373));
let _e1716 = global_7.member[bitcast<u32>(select(0i, _e1711, (_e1711 > 0i)))];
let _e1717 = bitcast<f32>(_e1716);
let _e1718 = local_8.member[2u];
let _e1719 = (_e1707 + _e1718);
let _e1721 = select(_e1373, _e1719, (_e1719 < _e1373));
let _e1726 = global_7.member[bitcast<u32>(select(0i, _e1721, (_e1721 > 0i)))];
let _e1728 = local_9[0u];
let _e1732 = (_e1388 + _e1392);
let _e1733 = local_8.member[1u];
let _e1734 = (_e1732 + _e1733);
let _e1736 = select(_e1373, _e1734, (_e1734 < _e1373));
let _e1741 = global_7.member[bitcast<u32>(select(0i, _e1736, (_e1736 > 0i)))];
let _e1742 = bitcast<f32>(_e1741);
let _e1743 = local_8.member[2u];
let _e1744 = (_e1732 + _e1743);
let _e1746 = select(_e1373, _e1744, (_e1744 < _e1373));
let _e1751 = global_7.member[bitcast<u32>(select(0i, _e1746, (_e1746 > 0i)))];
let _e1753 = local_9[0u];
let _e1756 = (_e1742 + ((bitcast<f32>(_e1751) - _e1742) * _e1753));
let _e1757 = (_e1401 + _e1392);
let _e1758 = local_8.member[1u];
let _e1759 = (_e1757 + _e1758);
let _e1761 = select(_e1373, _e1759, (_e1759 < _e1373));
let _e1766 = global_7.member[bitcast<u32>(select(0i, _e1761, (_e1761 > 0i)))];
let _e1767 = bitcast<f32>(_e1766);
let _e1768 = local_8.member[2u];
let _e1769 = (_e1757 + _e1768);
let _e1771 = select(_e1373, _e1769, (_e1769 < _e1373));
let _e1776 = global_7.member[bitcast<u32>(select(0i, _e1771, (_e1771 > 0i)))];
let _e1778 = local_9[0u];
let _e1781 = (_e1767 + ((bitcast<f32>(_e1776) - _e1767) * _e1778));
let _e1782 = (_e1388 + _e1394);
let _e1783 = local_8.member[1u];
let _e1784 = (_e1782 + _e1783);
let _e1786 = select(_e1373, _e1784, (_e1784 < _e1373));
let _e1791 = global_7.member[bitcast<u32>(select(0i, _e1786, (_e1786 > 0i)))];
let _e1792 = bitcast<f32>(_e1791);
let _e1793 = local_8.member[2u];
let _e1794 = (_e1782 + _e1793);
let _e1796 = select(_e1373, _e1794, (_e1794 < _e1373));
let _e1801 = global_7.member[bitcast<u32>(select(0i, _e1796, (_e1796 > 0i)))];
let _e1803 = local_9[0u];
let _e1807 = (_e1401 + _e1394);
let _e1808 = local_8.member[1u];
let _e1809 = (_e1807 + _e1808);
let _e1811 = select(_e1373, _e1809, (_e1809 < _e1373));
let _e1816 = global_7.member[bitcast<u32>(select(0i, _e1811, (_e1811 > 0i)))];
let _e1817 = bitcast<f32>(_e1816);
let _e1818 = local_8.member[2u];
let _e1819 = (_e1807 + _e1818);
let _e1821 = select(_e1373, _e1819, (_e1819 < _e1373));
let _e1826 = global_7.member[bitcast<u32>(select(0i, _e1821, (_e1821 > 0i)))];
let _e1828 = local_9[0u];
let _e1833 = local_9[1u];
let _e1836 = (_e1468 + ((_e1521 - _e1468) * _e1833));
let _e1837 = local_9[1u];
let _e1840 = (_e1574 + ((_e1627 - _e1574) * _e1837));
let _e1841 = local_9[1u];
let _e1844 = (_e1464 + (((_e1483 + ((_e1493 - _e1483) * _e1514)) - _e1464) * _e1841));
let _e1845 = local_9[1u];
let _e1850 = local_9[2u];
let _e1854 = local_9[1u];
let _e1857 = (_e1472 + (((_e1503 + ((bitcast<f32>(_e1512) - _e1503) * _e1522)) - _e1472) * _e1854));
let _e1858 = local_9[1u];
let _e1862 = local_9[2u];
let _e1866 = local_9[1u];
let _e1869 = (_e1656 + ((_e1468 - _e1656) * _e1866));
let _e1870 = local_9[1u];
let _e1874 = local_9[2u];
let _e1878 = local_9[1u];
let _e1881 = (_e1521 + (((_e1667 + ((bitcast<f32>(_e1676) - _e1667) * _e1678)) - _e1521) * _e1878));
let _e1882 = local_9[1u];
let _e1886 = local_9[2u];
let _e1890 = local_9[1u];
let _e1893 = (_e1756 + (((_e1792 + ((bitcast<f32>(_e1801) - _e1792) * _e1803)) - _e1756) * _e1890));
let _e1894 = local_9[2u];
let _e1898 = local_9[1u];
let _e1902 = local_9[2u];
let _e1906 = local_9[2u];
let _e1914 = global_5.member[_e360].member_7.member_5;
let _e1920 = global_5.member[_e360].member_7.member_6;
let _e1921 = (((_e1836 + ((_e1840 - _e1836) * _e1906)) * _e1914) + _e1920);
let _e1923 = select(0f, _e1921, (_e1921 > 0f));
let _e1927 = (((_e1844 + (((_e1570 + (((_e1589 + ((_e1599 - _e1589) * _e1620)) - _e1570) * _e1845)) - _e1844) * _e1850)) * _e1914) + _e1920);
let _e1929 = select(0f, _e1927, (_e1927 > 0f));
let _e1931 = select(1f, _e1929, (_e1929 < 1f));
let _e1933 = (((_e1857 + (((_e1578 + (((_e1609 + ((bitcast<f32>(_e1618) - _e1609) * _e1628)) - _e1578) * _e1858)) - _e1857) * _e1862)) * _e1914) + _e1920);
let _e1935 = select(0f, _e1933, (_e1933 > 0f));
let _e1937 = select(1f, _e1935, (_e1935 < 1f));
let _e1939 = (((_e1869 + (((_e1706 + ((_e1574 - _e1706) * _e1870)) - _e1869) * _e1874)) * _e1914) + _e1920);
let _e1941 = select(0f, _e1939, (_e1939 > 0f));
let _e1943 = select(1f, _e1941, (_e1941 < 1f));
let _e1945 = (((_e1881 + (((_e1627 + (((_e1717 + ((bitcast<f32>(_e1726) - _e1717) * _e1728)) - _e1627) * _e1882)) - _e1881) * _e1886)) * _e1914) + _e1920);
let _e1947 = select(0f, _e1945, (_e1945 > 0f));
let _e1949 = select(1f, _e1947, (_e1947 < 1f));
let _e1951 = (((_e1893 + ((_e1836 - _e1893) * _e1894)) * _e1914) + _e1920);
let _e1953 = select(0f, _e1951, (_e1951 > 0f));
let _e1955 = select(1f, _e1953, (_e1953 < 1f));
let _e1957 = (((_e1840 + (((_e1781 + (((_e1817 + ((bitcast<f32>(_e1826) - _e1817) * _e1828)) - _e1781) * _e1898)) - _e1840) * _e1902)) * _e1914) + _e1920);
let _e1959 = select(0f, _e1957, (_e1957 > 0f));
let _e1961 = select(1f, _e1959, (_e1959 < 1f));
let _e1962 = (select(1f, _e1923, (_e1923 < 1f)) * 1024f);
let _e1963 = (1024f - 1f);
let _e1965 = select(0f, _e1962, (_e1962 > 0f));
let _e1967 = select(_e1963, _e1965, (_e1965 < _e1963));
let _e1974 = select(0i, select(select(i32(_e1967), i32(-2147483648), (_e1967 < -2147483600f)), 2147483647i, (_e1967 > 2147483500f)), (_e1967 == _e1967));
let _e1978 = (_e1974 - select(0i, 1i, (_e1967 < f32(_e1974))));
let _e1979 = (262147i + _e1978);
let _e1981 = (bitcast<i32>(_e131) - 1i);
let _e1983 = select(_e1981, _e1979, (_e1979 < _e1981));
let _e1989 = global_3.member[bitcast<u32>(select(0i, _e1983, (_e1983 > 0i)))];
let _e1999 = select(_e1981, 262146i, (262146i < _e1981));
let _e2005 = global_3.member[bitcast<u32>(select(0i, _e1999, (_e1999 > 0i)))];
let _e2006 = bitcast<f32>(_e2005);
let _e2007 = (f32((bitcast<i32>((_e1989 & 4095u)) - 2048i)) * _e2006);
let _e2009 = select(_e1981, 262144i, (262144i < _e1981));
let _e2015 = global_3.member[bitcast<u32>(select(0i, _e2009, (_e2009 > 0i)))];
let _e2016 = bitcast<f32>(_e2015);
let _e2018 = select(_e1981, 262145i, (262145i < _e1981));
let _e2024 = global_3.member[bitcast<u32>(select(0i, _e2018, (_e2018 > 0i)))];
let _e2025 = bitcast<f32>(_e2024);
let _e2031 = ((_e2016 + (f32(bitcast<i32>((_e1989 >> bitcast<u32>(12u)))) * _e2025)) + (_e2007 * (_e1962 - f32(_e1978))));
let _e2032 = (_e2007 * 1024f);
if _e1034 {
let _e2039 = ((0.5f * (_e1937 - _e1931)) * _e2032);
let _e2040 = ((0.5f * (_e1949 - _e1943)) * _e2032);
let _e2041 = ((0.5f * (_e1961 - _e1955)) * _e2032);
phi_4902_ = type_29(_e2031, vec3<f32>(_e2039, _e2040, _e2041), vec3<f32>((_e2039 * _e2031), (_e2040 * _e2031), (_e2041 * _e2031)));
} else {
let _e2048 = (_e1931 * 1024f);
let _e2050 = select(0f, _e2048, (_e2048 > 0f));
let _e2052 = select(_e1963, _e2050, (_e2050 < _e1963));
let _e2059 = select(0i, select(select(i32(_e2052), i32(-2147483648), (_e2052 < -2147483600f)), 2147483647i, (_e2052 > 2147483500f)), (_e2052 == _e2052));
let _e2063 = (_e2059 - select(0i, 1i, (_e2052 < f32(_e2059))));
let _e2064 = (262147i + _e2063);
let _e2066 = select(_e1981, _e2064, (_e2064 < _e1981));
let _e2072 = global_3.member[bitcast<u32>(select(0i, _e2066, (_e2066 > 0i)))];
let _e2087 = ((_e2016 + (f32(bitcast<i32>((_e2072 >> bitcast<u32>(12u)))) * _e2025)) + ((f32((bitcast<i32>((_e2072 & 4095u)) - 2048i)) * _e2006) * (_e2048 - f32(_e2063))));
let _e2088 = (_e1937 * 1024f);
let _e2090 = select(0f, _e2088, (_e2088 > 0f));
let _e2092 = select(_e1963, _e2090, (_e2090 < _e1963));
let _e2099 = select(0i, select(select(i32(_e2092), i32(-2147483648), (_e2092 < -2147483600f)), 2147483647i, (_e2092 > 2147483500f)), (_e2092 == _e2092));
let _e2103 = (_e2099 - select(0i, 1i, (_e2092 < f32(_e2099))));
let _e2104 = (262147i + _e2103);
let _e2106 = select(_e1981, _e2104, (_e2104 < _e1981));
let _e2112 = global_3.member[bitcast<u32>(select(0i, _e2106, (_e2106 > 0i)))];
let _e2127 = ((_e2016 + (f32(bitcast<i32>((_e2112 >> bitcast<u32>(12u)))) * _e2025)) + ((f32((bitcast<i32>((_e2112 & 4095u)) - 2048i)) * _e2006) * (_e2088 - f32(_e2103))));
let _e2128 = (_e1943 * 1024f);
let _e2130 = select(0f, _e2128, (_e2128 > 0f));
let _e2132 = select(_e1963, _e2130, (_e2130 < _e1963));
let _e2139 = select(0i, select(select(i32(_e2132), i32(-2147483648), (_e2132 < -2147483600f)), 2147483647i, (_e2132 > 2147483500f)), (_e2132 == _e2132));
let _e2143 = (_e2139 - select(0i, 1i, (_e2132 < f32(_e2139))));
let _e2144 = (262147i + _e2143);
let _e2146 = select(_e1981, _e2144, (_e2144 < _e1981));
let _e2152 = global_3.member[bitcast<u32>(select(0i, _e2146, (_e2146 > 0i)))];
let _e2167 = ((_e2016 + (f32(bitcast<i32>((_e2152 >> bitcast<u32>(12u)))) * _e2025)) + ((f32((bitcast<i32>((_e2152 & 4095u)) - 2048i)) * _e2006) * (_e2128 - f32(_e2143))));
let _e2168 = (_e1949 * 1024f);
let _e2170 = select(0f, _e2168, (_e2168 > 0f));
let _e2172 = select(_e1963, _e2170, (_e2170 < _e1963));
let _e2179 = select(0i, select(select(i32(_e2172), i32(-2147483648), (_e2172 < -2147483600f)), 2147483647i, (_e2172 > 2147483500f)), (_e2172 == _e2172));
let _e2183 = (_e2179 - select(0i, 1i, (_e2172 < f32(_e2179))));
let _e2184 = (262147i + _e2183);
let _e2186 = select(_e1981, _e2184, (_e2184 < _e1981));
let _e2192 = global_3.member[bitcast<u32>(select(0i, _e2186, (_e2186 > 0i)))];
let _e2207 = ((_e2016 + (f32(bitcast<i32>((_e2192 >> bitcast<u32>(12u)))) * _e2025)) + ((f32((bitcast<i32>((_e2192 & 4095u)) - 2048i)) * _e2006) * (_e2168 - f32(_e2183))));
let _e2208 = (_e1955 * 1024f);
let _e2210 = select(0f, _e2208, (_e2208 > 0f));
let _e2212 = select(_e1963, _e2210, (_e2210 < _e1963));
let _e2219 = select(0i, select(select(i32(_e2212), i32(-2147483648), (_e2212 < -2147483600f)), 2147483647i, (_e2212 > 2147483500f)), (_e2212 == _e2212));
let _e2223 = (_e2219 - select(0i, 1i, (_e2212 < f32(_e2219))));
let _e2224 = (262147i + _e2223);
let _e2226 = select(_e1981, _e2224, (_e2224 < _e1981));
let _e2232 = global_3.member[bitcast<u32>(select(0i, _e2226, (_e2226 > 0i)))];
let _e2247 = ((_e2016 + (f32(bitcast<i32>((_e2232 >> bitcast<u32>(12u)))) * _e2025)) + ((f32((bitcast<i32>((_e2232 & 4095u)) - 2048i)) * _e2006) * (_e2208 - f32(_e2223))));
let _e2248 = (_e1961 * 1024f);
let _e2250 = select(0f, _e2248, (_e2248 > 0f));
let _e2252 = select(_e1963, _e2250, (_e2250 < _e1963));
let _e2259 = select(0i, select(select(i32(_e2252), i32(-2147483648), (_e2252 < -2147483600f)), 2147483647i, (_e2252 > 2147483500f)), (_e2252 == _e2252));
let _e2263 = (_e2259 - select(0i, 1i, (_e2252 < f32(_e2259))));
let _e2264 = (262147i + _e2263);
let _e2266 = select(_e1981, _e2264, (_e2264 < _e1981));
let _e2272 = global_3.member[bitcast<u32>(select(0i, _e2266, (_e2266 > 0i)))];
let _e2287 = ((_e2016 + (f32(bitcast<i32>((_e2272 >> bitcast<u32>(12u)))) * _e2025)) + ((f32((bitcast<i32>((_e2272 & 4095u)) - 2048i)) * _e2006) * (_e2248 - f32(_e2263))));
let _e2288 = (_e2127 - _e2087);
let _e2290 = (_e2207 - _e2167);
let _e2292 = (_e2287 - _e2247);
phi_4902_ = type_29(_e2031, vec3<f32>((0.5f * _e2288), (0.5f * _e2290), (0.5f * _e2292)), vec3<f32>((0.25f * (_e2288 * (_e2127 + _e2087))), (0.25f * (_e2290 * (_e2207 + _e2167))), (0.25f * (_e2292 * (_e2287 + _e2247)))));
}
let _e2307 = phi_4902_;
let _e2322 = select(0f, 1f, ((((((_e743 >= -0.5f) && (_e743 <= _e767)) && (_e749 >= -0.5f)) && (_e749 <= _e778)) && (_e755 >= -0.5f)) && (_e755 <= _e789)));
let _e2324 = (0.5f * (_e1937 - _e1931));
let _e2326 = (0.5f * (_e1949 - _e1943));
let _e2328 = (0.5f * (_e1961 - _e1955));
let _e2335 = global_5.member[_e360].member_7.member.member.member;
let _e2342 = global_5.member[_e360].member_7.member.member.member_1;
let _e2349 = global_5.member[_e360].member_7.member.member.member_2;
let _e2356 = global_5.member[_e360].member_7.member_1.member.member;
let _e2363 = global_5.member[_e360].member_7.member_1.member.member_1;
let _e2370 = global_5.member[_e360].member_7.member_1.member.member_2;
let _e2377 = global_5.member[_e360].member_7.member_2.member.member;
let _e2384 = global_5.member[_e360].member_7.member_2.member.member_1;
let _e2391 = global_5.member[_e360].member_7.member_2.member.member_2;
phi_5511_ = type_30(select(1f, _e1287, (_e1287 < 1f)), vec3<f32>(((((_e2335 * _e2324) + (_e2356 * _e2326)) + (_e2377 * _e2328)) * _e2322), ((((_e2342 * _e2324) + (_e2363 * _e2326)) + (_e2384 * _e2328)) * _e2322), ((((_e2349 * _e2324) + (_e2370 * _e2326)) + (_e2391 * _e2328)) * _e2322)), _e2307.member, vec3<f32>(((((_e2335 * _e2307.member_2.x) + (_e2356 * _e2307.member_2.y)) + (_e2377 * _e2307.member_2.z)) * _e2322), ((((_e2342 * _e2307.member_2.x) + (_e2363 * _e2307.member_2.y)) + (_e2384 * _e2307.member_2.z)) * _e2322), ((((_e2349 * _e2307.member_2.x) + (_e2370 * _e2307.member_2.y)) + (_e2391 * _e2307.member_2.z)) * _e2322)), vec3<f32>(((((_e2335 * _e2307.member_1.x) + (_e2356 * _e2307.member_1.y)) + (_e2377 * _e2307.member_1.z)) * _e2322), ((((_e2342 * _e2307.member_1.x) + (_e2363 * _e2307.member_1.y)) + (_e2384 * _e2307.member_1.z)) * _e2322), ((((_e2349 * _e2307.member_1.x) + (_e2370 * _e2307.member_1.y)) + (_e2391 * _e2307.member_1.z)) * _e2322)));
} else {
let _e2457 = select(-1f, _e532, (_e532 > -1f));
let _e2459 = select(_e527, _e2457, (_e2457 < _e527));
let _e2466 = select(0i, select(select(i32(_e2459), i32(-2147483648), (_e2459 < -2147483600f)), 2147483647i, (_e2459 > 2147483500f)), (_e2459 == _e2459));
let _e2470 = (_e2466 - select(0i, 1i, (_e2459 < f32(_e2466))));
let _e2472 = select(-1f, _e543, (_e543 > -1f));
let _e2474 = select(_e538, _e2472, (_e2472 < _e538));
let _e2481 = select(0i, select(select(i32(_e2474), i32(-2147483648), (_e2474 < -2147483600f)), 2147483647i, (_e2474 > 2147483500f)), (_e2474 == _e2474));
let _e2485 = (_e2481 - select(0i, 1i, (_e2474 < f32(_e2481))));
let _e2487 = select(-1f, _e554, (_e554 > -1f));
let _e2489 = select(_e549, _e2487, (_e2487 < _e549));
let _e2496 = select(0i, select(select(i32(_e2489), i32(-2147483648), (_e2489 < -2147483600f)), 2147483647i, (_e2489 > 2147483500f)), (_e2489 == _e2489));
let _e2500 = (_e2496 - select(0i, 1i, (_e2489 < f32(_e2496))));
let _e2505 = global_5.member[_e360].member_6.member_7;
let _e2510 = global_5.member[_e360].member_6.member_8;
let _e2511 = (_e2470 + 1i);
let _e2512 = (_e2485 + 1i);
let _e2513 = (_e2500 + 1i);
let _e2519 = global_5.member[_e360].member_6.member_11.member;
let _e2526 = global_5.member[_e360].member_6.member_11.member_1;
let _e2537 = ((_e2511 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2519) * ((_e2512 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2526) * (_e2513 >> bitcast<u32>(4i))))));
let _e2539 = (bitcast<i32>(_e124) - 1i);
let _e2541 = select(_e2539, _e2537, (_e2537 < _e2539));
let _e2547 = global_1.member[bitcast<u32>(select(0i, _e2541, (_e2541 > 0i)))];
let _e2549 = (_e2511 & 15i);
let _e2552 = ((_e2512 & 15i) * _e2505);
let _e2554 = (bitcast<i32>(_e2547) + ((_e2513 & 15i) * _e2510));
let _e2558 = (_e2552 + _e2505);
let _e2560 = (_e2552 + (2i * _e2505));
let _e2561 = (_e2554 + _e2510);
let _e2563 = (_e2554 + (2i * _e2510));
local_6 = type_28(array<i32, 4>(_e2549, (_e2549 + 1i), (_e2549 + 2i), (_e2549 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_7 = vec3<f32>((_e532 - f32(_e2470)), (_e543 - f32(_e2485)), (_e554 - f32(_e2500)));
let _e2574 = (_e2561 + _e2558);
let _e2577 = local_6.member[1u];
let _e2578 = (_e2574 + _e2577);
let _e2580 = select(_e2539, _e2578, (_e2578 < _e2539));
let _e2585 = global_1.member[bitcast<u32>(select(0i, _e2580, (_e2580 > 0i)))];
let _e2586 = bitcast<f32>(_e2585);
let _e2589 = local_6.member[2u];
let _e2590 = (_e2574 + _e2589);
let _e2592 = select(_e2539, _e2590, (_e2590 < _e2539));
let _e2597 = global_1.member[bitcast<u32>(select(0i, _e2592, (_e2592 > 0i)))];
let _e2599 = local_7[0u];
let _e2602 = (_e2586 + ((bitcast<f32>(_e2597) - _e2586) * _e2599));
let _e2603 = (_e2561 + _e2560);
let _e2604 = local_6.member[1u];
let _e2605 = (_e2603 + _e2604);
let _e2607 = select(_e2539, _e2605, (_e2605 < _e2539));
let _e2612 = global_1.member[bitcast<u32>(select(0i, _e2607, (_e2607 > 0i)))];
let _e2613 = bitcast<f32>(_e2612);
let _e2614 = local_6.member[2u];
let _e2615 = (_e2603 + _e2614);
let _e2617 = select(_e2539, _e2615, (_e2615 < _e2539));
let _e2622 = global_1.member[bitcast<u32>(select(0i, _e2617, (_e2617 > 0i)))];
let _e2624 = local_7[0u];
let _e2629 = local_7[1u];
let _e2632 = (_e2602 + (((_e2613 + ((bitcast<f32>(_e2622) - _e2613) * _e2624)) - _e2602) * _e2629));
let _e2633 = (_e2563 + _e2558);
let _e2634 = local_6.member[1u];
let _e2635 = (_e2633 + _e2634);
let _e2637 = select(_e2539, _e2635, (_e2635 < _e2539));
let _e2642 = global_1.member[bitcast<u32>(select(0i, _e2637, (_e2637 > 0i)))];
let _e2643 = bitcast<f32>(_e2642);
let _e2644 = local_6.member[2u];
let _e2645 = (_e2633 + _e2644);
let _e2647 = select(_e2539, _e2645, (_e2645 < _e2539));
let _e2652 = global_1.member[bitcast<u32>(select(0i, _e2647, (_e2647 > 0i)))];
let _e2654 = local_7[0u];
let _e2657 = (_e2643 + ((bitcast<f32>(_e2652) - _e2643) * _e2654));
let _e2658 = (_e2563 + _e2560);
let _e2659 = local_6.member[1u];
let _e2660 = (_e2658 + _e2659);
let _e2662 = select(_e2539, _e2660, (_e2660 < _e2539));
let _e2667 = global_1.member[bitcast<u32>(select(0i, _e2662, (_e2662 > 0i)))];
let _e2668 = bitcast<f32>(_e2667);
let _e2669 = local_6.member[2u];
let _e2670 = (_e2658 + _e2669);
let _e2672 = select(_e2539, _e2670, (_e2670 < _e2539));
let _e2677 = global_1.member[bitcast<u32>(select(0i, _e2672, (_e2672 > 0i)))];
let _e2679 = local_7[0u];
let _e2683 = local_7[1u];
let _e2688 = local_7[2u];
let _e2696 = global_5.member[_e360].member_6.member_5;
let _e2702 = global_5.member[_e360].member_6.member_6;
let _e2703 = (((_e2632 + (((_e2657 + (((_e2668 + ((bitcast<f32>(_e2677) - _e2668) * _e2679)) - _e2657) * _e2683)) - _e2632) * _e2688)) * _e2696) + _e2702);
let _e2705 = select(0f, _e2703, (_e2703 > 0f));
phi_5511_ = type_30(select(1f, _e2705, (_e2705 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2710 = phi_5511_;
let _e2714 = select(-0.5f, _e466, (_e466 > -0.5f));
let _e2716 = select(_e528, _e2714, (_e2714 < _e528));
let _e2718 = select(-0.5f, _e482, (_e482 > -0.5f));
let _e2720 = select(_e539, _e2718, (_e2718 < _e539));
let _e2722 = select(-0.5f, _e498, (_e498 > -0.5f));
let _e2724 = select(_e550, _e2722, (_e2722 < _e550));
let _e2726 = select(-1f, _e2716, (_e2716 > -1f));
let _e2728 = select(_e527, _e2726, (_e2726 < _e527));
let _e2735 = select(0i, select(select(i32(_e2728), i32(-2147483648), (_e2728 < -2147483600f)), 2147483647i, (_e2728 > 2147483500f)), (_e2728 == _e2728));
let _e2739 = (_e2735 - select(0i, 1i, (_e2728 < f32(_e2735))));
let _e2741 = select(-1f, _e2720, (_e2720 > -1f));
let _e2743 = select(_e538, _e2741, (_e2741 < _e538));
let _e2750 = select(0i, select(select(i32(_e2743), i32(-2147483648), (_e2743 < -2147483600f)), 2147483647i, (_e2743 > 2147483500f)), (_e2743 == _e2743));
let _e2754 = (_e2750 - select(0i, 1i, (_e2743 < f32(_e2750))));
let _e2756 = select(-1f, _e2724, (_e2724 > -1f));
let _e2758 = select(_e549, _e2756, (_e2756 < _e549));
let _e2765 = select(0i, select(select(i32(_e2758), i32(-2147483648), (_e2758 < -2147483600f)), 2147483647i, (_e2758 > 2147483500f)), (_e2758 == _e2758));
let _e2769 = (_e2765 - select(0i, 1i, (_e2758 < f32(_e2765))));
let _e2774 = global_5.member[_e360].member_6.member_7;
let _e2779 = global_5.member[_e360].member_6.member_8;
let _e2780 = (_e2739 + 1i);
let _e2781 = (_e2754 + 1i);
let _e2782 = (_e2769 + 1i);
let _e2788 = global_5.member[_e360].member_6.member_11.member;
let _e2795 = global_5.member[_e360].member_6.member_11.member_1;
let _e2806 = ((_e2780 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2788) * ((_e2781 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2795) * (_e2782 >> bitcast<u32>(4i))))));
let _e2808 = (bitcast<i32>(_e124) - 1i);
let _e2810 = select(_e2808, _e2806, (_e2806 < _e2808));
let _e2816 = global_1.member[bitcast<u32>(select(0i, _e2810, (_e2810 > 0i)))];
let _e2818 = (_e2780 & 15i);
let _e2821 = ((_e2781 & 15i) * _e2774);
let _e2823 = (bitcast<i32>(_e2816) + ((_e2782 & 15i) * _e2779));
let _e2827 = (_e2821 + _e2774);
let _e2829 = (_e2821 + (2i * _e2774));
let _e2830 = (_e2823 + _e2779);
let _e2832 = (_e2823 + (2i * _e2779));
local_4 = type_28(array<i32, 4>(_e2818, (_e2818 + 1i), (_e2818 + 2i), (_e2818 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_5 = vec3<f32>((_e2716 - f32(_e2739)), (_e2720 - f32(_e2754)), (_e2724 - f32(_e2769)));
let _e2843 = (_e2830 + _e2827);
let _e2846 = local_4.member[1u];
let _e2847 = (_e2843 + _e2846);
let _e2849 = select(_e2808, _e2847, (_e2847 < _e2808));
let _e2854 = global_1.member[bitcast<u32>(select(0i, _e2849, (_e2849 > 0i)))];
let _e2855 = bitcast<f32>(_e2854);
let _e2858 = local_4.member[2u];
let _e2859 = (_e2843 + _e2858);
let _e2861 = select(_e2808, _e2859, (_e2859 < _e2808));
let _e2866 = global_1.member[bitcast<u32>(select(0i, _e2861, (_e2861 > 0i)))];
let _e2868 = local_5[0u];
let _e2871 = (_e2855 + ((bitcast<f32>(_e2866) - _e2855) * _e2868));
let _e2872 = (_e2830 + _e2829);
let _e2873 = local_4.member[1u];
let _e2874 = (_e2872 + _e2873);
let _e2876 = select(_e2808, _e2874, (_e2874 < _e2808));
let _e2881 = global_1.member[bitcast<u32>(select(0i, _e2876, (_e2876 > 0i)))];
let _e2882 = bitcast<f32>(_e2881);
let _e2883 = local_4.member[2u];
let _e2884 = (_e2872 + _e2883);
let _e2886 = select(_e2808, _e2884, (_e2884 < _e2808));
let _e2891 = global_1.member[bitcast<u32>(select(0i, _e2886, (_e2886 > 0i)))];
let _e2893 = local_5[0u];
let _e2898 = local_5[1u];
let _e2901 = (_e2871 + (((_e2882 + ((bitcast<f32>(_e2891) - _e2882) * _e2893)) - _e2871) * _e2898));
let _e2902 = (_e2832 + _e2827);
let _e2903 = local_4.member[1u];
let _e2904 = (_e2902 + _e2903);
let _e2906 = select(_e2808, _e2904, (_e2904 < _e2808));
let _e2911 = global_1.member[bitcast<u32>(select(0i, _e2906, (_e2906 > 0i)))];
let _e2912 = bitcast<f32>(_e2911);
let _e2913 = local_4.member[2u];
let _e2914 = (_e2902 + _e2913);
let _e2916 = select(_e2808, _e2914, (_e2914 < _e2808));
let _e2921 = global_1.member[bitcast<u32>(select(0i, _e2916, (_e2916 > 0i)))];
let _e2923 = local_5[0u];
let _e2926 = (_e2912 + ((bitcast<f32>(_e2921) - _e2912) * _e2923));
let _e2927 = (_e2832 + _e2829);
let _e2928 = local_4.member[1u];
let _e2929 = (_e2927 + _e2928);
let _e2931 = select(_e2808, _e2929, (_e2929 < _e2808));
let _e2936 = global_1.member[bitcast<u32>(select(0i, _e2931, (_e2931 > 0i)))];
let _e2937 = bitcast<f32>(_e2936);
let _e2938 = local_4.member[2u];
let _e2939 = (_e2927 + _e2938);
let _e2941 = select(_e2808, _e2939, (_e2939 < _e2808));
let _e2946 = global_1.member[bitcast<u32>(select(0i, _e2941, (_e2941 > 0i)))];
let _e2948 = local_5[0u];
let _e2952 = local_5[1u];
let _e2957 = local_5[2u];
let _e2965 = global_5.member[_e360].member_6.member_5;
let _e2971 = global_5.member[_e360].member_6.member_6;
let _e2972 = (((_e2901 + (((_e2926 + (((_e2937 + ((bitcast<f32>(_e2946) - _e2937) * _e2948)) - _e2926) * _e2952)) - _e2901) * _e2957)) * _e2965) + _e2971);
let _e2974 = select(0f, _e2972, (_e2972 > 0f));
let _e2977 = select(_e364[5], select(1f, _e2974, (_e2974 < 1f)), _e963);
if _e1037 {
let _e2979 = select(-0.5f, _e705, (_e705 > -0.5f));
let _e2981 = select(_e767, _e2979, (_e2979 < _e767));
let _e2983 = select(-0.5f, _e721, (_e721 > -0.5f));
let _e2985 = select(_e778, _e2983, (_e2983 < _e778));
let _e2987 = select(-0.5f, _e737, (_e737 > -0.5f));
let _e2989 = select(_e789, _e2987, (_e2987 < _e789));
let _e2991 = select(-1f, _e2981, (_e2981 > -1f));
let _e2993 = select(_e766, _e2991, (_e2991 < _e766));
let _e3000 = select(0i, select(select(i32(_e2993), i32(-2147483648), (_e2993 < -2147483600f)), 2147483647i, (_e2993 > 2147483500f)), (_e2993 == _e2993));
let _e3004 = (_e3000 - select(0i, 1i, (_e2993 < f32(_e3000))));
let _e3006 = select(-1f, _e2985, (_e2985 > -1f));
let _e3008 = select(_e777, _e3006, (_e3006 < _e777));
let _e3015 = select(0i, select(select(i32(_e3008), i32(-2147483648), (_e3008 < -2147483600f)), 2147483647i, (_e3008 > 2147483500f)), (_e3008 == _e3008));
let _e3019 = (_e3015 - select(0i, 1i, (_e3008 < f32(_e3015))));
let _e3021 = select(-1f, _e2989, (_e2989 > -1f));
let _e3023 = select(_e788, _e3021, (_e3021 < _e788));
let _e3030 = select(0i, select(select(i32(_e3023), i32(-2147483648), (_e3023 < -2147483600f)), 2147483647i, (_e3023 > 2147483500f)), (_e3023 == _e3023));
let _e3034 = (_e3030 - select(0i, 1i, (_e3023 < f32(_e3030))));
let _e3039 = global_5.member[_e360].member_7.member_7;
let _e3044 = global_5.member[_e360].member_7.member_8;
let _e3045 = (_e3004 + 1i);
let _e3046 = (_e3019 + 1i);
let _e3047 = (_e3034 + 1i);
let _e3053 = global_5.member[_e360].member_7.member_11.member;
let _e3060 = global_5.member[_e360].member_7.member_11.member_1;
let _e3071 = ((_e3045 >> bitcast<u32>(4i)) + (bitcast<i32>(_e3053) * ((_e3046 >> bitcast<u32>(4i)) + (bitcast<i32>(_e3060) * (_e3047 >> bitcast<u32>(4i))))));
let _e3073 = (bitcast<i32>(_e127) - 1i);
let _e3075 = select(_e3073, _e3071, (_e3071 < _e3073));
let _e3081 = global_7.member[bitcast<u32>(select(0i, _e3075, (_e3075 > 0i)))];
let _e3083 = (_e3045 & 15i);
let _e3086 = ((_e3046 & 15i) * _e3039);
let _e3088 = (bitcast<i32>(_e3081) + ((_e3047 & 15i) * _e3044));
let _e3092 = (_e3086 + _e3039);
let _e3094 = (_e3086 + (2i * _e3039));
let _e3095 = (_e3088 + _e3044);
let _e3097 = (_e3088 + (2i * _e3044));
local_2 = type_28(array<i32, 4>(_e3083, (_e3083 + 1i), (_e3083 + 2i), (_e3083 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_3 = vec3<f32>((_e2981 - f32(_e3004)), (_e2985 - f32(_e3019)), (_e2989 - f32(_e3034)));
let _e3108 = (_e3095 + _e3092);
let _e3111 = local_2.member[1u];
let _e3112 = (_e3108 + _e3111);
let _e3114 = select(_e3073, _e3112, (_e3112 < _e3073));
let _e3119 = global_7.member[bitcast<u32>(select(0i, _e3114, (_e3114 > 0i)))];
let _e3120 = bitcast<f32>(_e3119);
let _e3123 = local_2.member[2u];
let _e3124 = (_e3108 + _e3123);
let _e3126 = select(_e3073, _e3124, (_e3124 < _e3073));
let _e3131 = global_7.member[bitcast<u32>(select(0i, _e3126, (_e3126 > 0i)))];
let _e3133 = local_3[0u];
let _e3136 = (_e3120 + ((bitcast<f32>(_e3131) - _e3120) * _e3133));
let _e3137 = (_e3095 + _e3094);
let _e3138 = local_2.member[1u];
let _e3139 = (_e3137 + _e3138);
let _e3141 = select(_e3073, _e3139, (_e3139 < _e3073));
let _e3146 = global_7.member[bitcast<u32>(select(0i, _e3141, (_e3141 > 0i)))];
let _e3147 = bitcast<f32>(_e3146);
let _e3148 = local_2.member[2u];
let _e3149 = (_e3137 + _e3148);
let _e3151 = select(_e3073, _e3149, (_e3149 < _e3073));
let _e3156 = global_7.member[bitcast<u32>(select(0i, _e3151, (_e3151 > 0i)))];
let _e3158 = local_3[0u];
let _e3163 = local_3[1u];
let _e3166 = (_e3136 + (((_e3147 + ((bitcast<f32>(_e3156) - _e3147) * _e3158)) - _e3136) * _e3163));
let _e3167 = (_e3097 + _e3092);
let _e3168 = local_2.member[1u];
let _e3169 = (_e3167 + _e3168);
let _e3171 = select(_e3073, _e3169, (_e3169 < _e3073));
let _e3176 = global_7.member[bitcast<u32>(select(0i, _e3171, (_e3171 > 0i)))];
let _e3177 = bitcast<f32>(_e3176);
let _e3178 = local_2.member[2u];
let _e3179 = (_e3167 + _e3178);
let _e3181 = select(_e3073, _e3179, (_e3179 < _e3073));
let _e3186 = global_7.member[bitcast<u32>(select(0i, _e3181, (_e3181 > 0i)))];
let _e3188 = local_3[0u];
let _e3191 = (_e3177 + ((bitcast<f32>(_e3186) - _e3177) * _e3188));
let _e3192 = (_e3097 + _e3094);
let _e3193 = local_2.member[1u];
let _e3194 = (_e3192 + _e3193);
let _e3196 = select(_e3073, _e3194, (_e3194 < _e3073));
let _e3201 = global_7.member[bitcast<u32>(select(0i, _e3196, (_e3196 > 0i)))];
let _e3202 = bitcast<f32>(_e3201);
let _e3203 = local_2.member[2u];
let _e3204 = (_e3192 + _e3203);
let _e3206 = select(_e3073, _e3204, (_e3204 < _e3073));
let _e3211 = global_7.member[bitcast<u32>(select(0i, _e3206, (_e3206 > 0i)))];
let _e3213 = local_3[0u];
let _e3217 = local_3[1u];
let _e3222 = local_3[2u];
let _e3230 = global_5.member[_e360].member_7.member_5;
let _e3236 = global_5.member[_e360].member_7.member_6;
let _e3237 = (((_e3166 + (((_e3191 + (((_e3202 + ((bitcast<f32>(_e3211) - _e3202) * _e3213)) - _e3191) * _e3217)) - _e3166) * _e3222)) * _e3230) + _e3236);
let _e3239 = select(0f, _e3237, (_e3237 > 0f));
let _e3242 = (select(1f, _e3239, (_e3239 < 1f)) * 1024f);
let _e3243 = (1024f - 1f);
let _e3245 = select(0f, _e3242, (_e3242 > 0f));
let _e3247 = select(_e3243, _e3245, (_e3245 < _e3243));
let _e3254 = select(0i, select(select(i32(_e3247), i32(-2147483648), (_e3247 < -2147483600f)), 2147483647i, (_e3247 > 2147483500f)), (_e3247 == _e3247));
let _e3258 = (_e3254 - select(0i, 1i, (_e3247 < f32(_e3254))));
let _e3259 = (262147i + _e3258);
let _e3261 = (bitcast<i32>(_e131) - 1i);
let _e3263 = select(_e3261, _e3259, (_e3259 < _e3261));
let _e3269 = global_3.member[bitcast<u32>(select(0i, _e3263, (_e3263 > 0i)))];
let _e3279 = select(_e3261, 262146i, (262146i < _e3261));
let _e3285 = global_3.member[bitcast<u32>(select(0i, _e3279, (_e3279 > 0i)))];
let _e3289 = select(_e3261, 262144i, (262144i < _e3261));
let _e3295 = global_3.member[bitcast<u32>(select(0i, _e3289, (_e3289 > 0i)))];
let _e3298 = select(_e3261, 262145i, (262145i < _e3261));
let _e3304 = global_3.member[bitcast<u32>(select(0i, _e3298, (_e3298 > 0i)))];
phi_6516_ = select(_e364[15], ((bitcast<f32>(_e3295) + (f32(bitcast<i32>((_e3269 >> bitcast<u32>(12u)))) * bitcast<f32>(_e3304))) + ((f32((bitcast<i32>((_e3269 & 4095u)) - 2048i)) * bitcast<f32>(_e3285)) * (_e3242 - f32(_e3258)))), _e963);
} else {
phi_6516_ = _e364[15];
}
let _e3314 = phi_6516_;
let _e3317 = select(1f, select(1f, _e1032, (_e1032 < 1f)), _e450);
if ((_e930 & 16u) == 0u) {
phi_6905_ = type_5(1f, 1f, 1f);
} else {
let _e3324 = global_5.member[_e360].member_14.member;
let _e3335 = ((((_e3324.member.member * _e385) + (_e3324.member.member_1 * _e388)) + (_e3324.member.member_2 * _e379)) + _e3324.member_1);
let _e3341 = ((((_e3324.member.member * _e390) + (_e3324.member.member_1 * _e392)) + (_e3324.member.member_2 * _e397)) + _e3324.member_1);
let _e3343 = select(_e3341, _e3335, (_e3335 < _e3341));
let _e3345 = select(_e3341, _e3335, (_e3335 > _e3341));
let _e3347 = (_e3345 - _e3343);
let _e3350 = (-(_e3343) / select(1e-30f, _e3347, (_e3347 > 1e-30f)));
let _e3352 = select(0f, _e3350, (_e3350 > 0f));
let _e3358 = select(select(select(1f, _e3352, (_e3352 < 1f)), 1f, (_e3345 <= 0f)), 0f, (_e3343 > 0f));
let _e3364 = global_5.member[_e360].member_14.member_1;
let _e3365 = (_e3364 != 0u);
let _e3376 = global_5.member[_e360].member_15.member;
let _e3387 = ((((_e3376.member.member * _e385) + (_e3376.member.member_1 * _e388)) + (_e3376.member.member_2 * _e379)) + _e3376.member_1);
let _e3393 = ((((_e3376.member.member * _e390) + (_e3376.member.member_1 * _e392)) + (_e3376.member.member_2 * _e397)) + _e3376.member_1);
let _e3395 = select(_e3393, _e3387, (_e3387 < _e3393));
let _e3397 = select(_e3393, _e3387, (_e3387 > _e3393));
let _e3399 = (_e3397 - _e3395);
let _e3402 = (-(_e3395) / select(1e-30f, _e3399, (_e3399 > 1e-30f)));
let _e3404 = select(0f, _e3402, (_e3402 > 0f));
let _e3410 = select(select(select(1f, _e3404, (_e3404 < 1f)), 1f, (_e3397 <= 0f)), 0f, (_e3395 > 0f));
let _e3416 = global_5.member[_e360].member_15.member_1;
let _e3417 = (_e3416 != 0u);
let _e3428 = global_5.member[_e360].member_16.member;
let _e3439 = ((((_e3428.member.member * _e385) + (_e3428.member.member_1 * _e388)) + (_e3428.member.member_2 * _e379)) + _e3428.member_1);
let _e3445 = ((((_e3428.member.member * _e390) + (_e3428.member.member_1 * _e392)) + (_e3428.member.member_2 * _e397)) + _e3428.member_1);
let _e3447 = select(_e3445, _e3439, (_e3439 < _e3445));
let _e3449 = select(_e3445, _e3439, (_e3439 > _e3445));
let _e3451 = (_e3449 - _e3447);
let _e3454 = (-(_e3447) / select(1e-30f, _e3451, (_e3451 > 1e-30f)));
let _e3456 = select(0f, _e3454, (_e3454 > 0f));
let _e3462 = select(select(select(1f, _e3456, (_e3456 < 1f)), 1f, (_e3449 <= 0f)), 0f, (_e3447 > 0f));
let _e3468 = global_5.member[_e360].member_16.member_1;
let _e3469 = (_e3468 != 0u);
let _e3480 = global_5.member[_e360].member_17.member;
let _e3491 = ((((_e3480.member.member * _e385) + (_e3480.member.member_1 * _e388)) + (_e3480.member.member_2 * _e379)) + _e3480.member_1);
let _e3497 = ((((_e3480.member.member * _e390) + (_e3480.member.member_1 * _e392)) + (_e3480.member.member_2 * _e397)) + _e3480.member_1);
let _e3499 = select(_e3497, _e3491, (_e3491 < _e3497));
let _e3501 = select(_e3497, _e3491, (_e3491 > _e3497));
let _e3503 = (_e3501 - _e3499);
let _e3506 = (-(_e3499) / select(1e-30f, _e3503, (_e3503 > 1e-30f)));
let _e3508 = select(0f, _e3506, (_e3506 > 0f));
let _e3514 = select(select(select(1f, _e3508, (_e3508 < 1f)), 1f, (_e3501 <= 0f)), 0f, (_e3499 > 0f));
let _e3520 = global_5.member[_e360].member_17.member_1;
let _e3521 = (_e3520 != 0u);
phi_6905_ = type_5(((((1f * _e3358) * _e3410) * _e3462) * _e3514), ((((1f * select(1f, _e3358, _e3365)) * select(1f, _e3410, _e3417)) * select(1f, _e3462, _e3469)) * select(1f, _e3514, _e3521)), ((((1f * select(1f, 0f, (_e3365 && (_e3341 > 0f)))) * select(1f, 0f, (_e3417 && (_e3393 > 0f)))) * select(1f, 0f, (_e3469 && (_e3445 > 0f)))) * select(1f, 0f, (_e3521 && (_e3497 > 0f)))));
}
let _e3530 = phi_6905_;
let _e3531 = (_e560 < 1e-12f);
let _e3533 = (1f / select(_e555, 1f, _e3531));
let _e3535 = ((-0.5f - _e466) * _e3533);
let _e3537 = ((_e528 - _e466) * _e3533);
let _e3543 = select(_e3537, _e3535, (_e3535 < _e3537));
let _e3545 = select(0f, _e3543, (_e3543 > 0f));
let _e3548 = select(select(1f, _e3545, (_e3545 < 1f)), select(2f, 0f, ((_e466 >= -0.5f) && (_e466 <= _e528))), _e3531);
let _e3550 = select(_e3537, _e3535, (_e3535 > _e3537));
let _e3552 = select(0f, _e3550, (_e3550 > 0f));
let _e3555 = select(select(1f, _e3552, (_e3552 < 1f)), 1f, _e3531);
let _e3556 = (_e563 < 1e-12f);
let _e3558 = (1f / select(_e556, 1f, _e3556));
let _e3560 = ((-0.5f - _e482) * _e3558);
let _e3562 = ((_e539 - _e482) * _e3558);
let _e3568 = select(_e3562, _e3560, (_e3560 < _e3562));
let _e3570 = select(0f, _e3568, (_e3568 > 0f));
let _e3573 = select(select(1f, _e3570, (_e3570 < 1f)), select(2f, 0f, ((_e482 >= -0.5f) && (_e482 <= _e539))), _e3556);
let _e3575 = select(_e3562, _e3560, (_e3560 > _e3562));
let _e3577 = select(0f, _e3575, (_e3575 > 0f));
let _e3580 = select(select(1f, _e3577, (_e3577 < 1f)), 1f, _e3556);
let _e3581 = (_e568 < 1e-12f);
let _e3583 = (1f / select(_e557, 1f, _e3581));
let _e3585 = ((-0.5f - _e498) * _e3583);
let _e3587 = ((_e550 - _e498) * _e3583);
let _e3593 = select(_e3587, _e3585, (_e3585 < _e3587));
let _e3595 = select(0f, _e3593, (_e3593 > 0f));
let _e3598 = select(select(1f, _e3595, (_e3595 < 1f)), select(2f, 0f, ((_e498 >= -0.5f) && (_e498 <= _e550))), _e3581);
let _e3600 = select(_e3587, _e3585, (_e3585 > _e3587));
let _e3602 = select(0f, _e3600, (_e3600 > 0f));
let _e3605 = select(select(1f, _e3602, (_e3602 < 1f)), 1f, _e3581);
let _e3607 = select(_e3580, _e3555, (_e3555 < _e3580));
let _e3611 = select(_e3573, _e3548, (_e3548 > _e3573));
let _e3614 = (select(_e3605, _e3607, (_e3607 < _e3605)) - select(_e3598, _e3611, (_e3611 > _e3598)));
let _e3617 = (_e390 - _e385);
let _e3618 = (_e392 - _e388);
let _e3619 = (_e397 - _e379);
let _e3624 = (((_e3617 * _e3617) + (_e3618 * _e3618)) + (_e3619 * _e3619));
let _e3634 = global_5.member[_e360].member_5.member_3;
let _e3635 = (((sqrt(select(0f, _e3624, (_e3624 > 0f))) * select(0f, _e3614, (_e3614 > 0f))) * _e3317) * _e3634);
let _e3636 = (_e974.member_2 >= 3u);
if _e3636 {
let _e3638 = (_e2977 * 255f);
let _e3639 = (_e2710.member * 255f);
let _e3640 = (255f - 1f);
let _e3642 = select(0f, _e3638, (_e3638 > 0f));
let _e3644 = select(_e3640, _e3642, (_e3642 < _e3640));
let _e3651 = select(0i, select(select(i32(_e3644), i32(-2147483648), (_e3644 < -2147483600f)), 2147483647i, (_e3644 > 2147483500f)), (_e3644 == _e3644));
let _e3655 = (_e3651 - select(0i, 1i, (_e3644 < f32(_e3651))));
let _e3657 = select(0f, _e3639, (_e3639 > 0f));
let _e3659 = select(_e3640, _e3657, (_e3657 < _e3640));
let _e3666 = select(0i, select(select(i32(_e3659), i32(-2147483648), (_e3659 < -2147483600f)), 2147483647i, (_e3659 > 2147483500f)), (_e3659 == _e3659));
let _e3670 = (_e3666 - select(0i, 1i, (_e3659 < f32(_e3666))));
let _e3673 = (((_e3655 * 256i) + _e3670) * 4i);
let _e3675 = (_e3638 - f32(_e3655));
let _e3677 = (_e3639 - f32(_e3670));
let _e3678 = (_e3673 + 2i);
let _e3680 = (bitcast<i32>(_e131) - 1i);
let _e3682 = select(_e3680, _e3678, (_e3678 < _e3680));
let _e3688 = global_3.member[bitcast<u32>(select(0i, _e3682, (_e3682 > 0i)))];
let _e3689 = (_e3673 + 6i);
let _e3691 = select(_e3680, _e3689, (_e3689 < _e3680));
let _e3697 = global_3.member[bitcast<u32>(select(0i, _e3691, (_e3691 > 0i)))];
let _e3698 = (_e3673 + 1026i);
let _e3700 = select(_e3680, _e3698, (_e3698 < _e3680));
let _e3706 = global_3.member[bitcast<u32>(select(0i, _e3700, (_e3700 > 0i)))];
let _e3707 = (_e3673 + 1030i);
let _e3709 = select(_e3680, _e3707, (_e3707 < _e3680));
let _e3715 = global_3.member[bitcast<u32>(select(0i, _e3709, (_e3709 > 0i)))];
let _e3720 = (bitcast<f32>(((_e3688 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3728 = (_e3720 + (((bitcast<f32>(((_e3697 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3720) * _e3677));
let _e3733 = (bitcast<f32>(((_e3706 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3757 = (bitcast<f32>((((_e3688 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3765 = (_e3757 + (((bitcast<f32>((((_e3697 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3757) * _e3677));
let _e3770 = (bitcast<f32>((((_e3706 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3782 = (_e3673 + 3i);
let _e3784 = select(_e3680, _e3782, (_e3782 < _e3680));
let _e3790 = global_3.member[bitcast<u32>(select(0i, _e3784, (_e3784 > 0i)))];
let _e3791 = (_e3673 + 7i);
let _e3793 = select(_e3680, _e3791, (_e3791 < _e3680));
let _e3799 = global_3.member[bitcast<u32>(select(0i, _e3793, (_e3793 > 0i)))];
let _e3800 = (_e3673 + 1027i);
let _e3802 = select(_e3680, _e3800, (_e3800 < _e3680));
let _e3808 = global_3.member[bitcast<u32>(select(0i, _e3802, (_e3802 > 0i)))];
let _e3809 = (_e3673 + 1031i);
let _e3811 = select(_e3680, _e3809, (_e3809 < _e3680));
let _e3817 = global_3.member[bitcast<u32>(select(0i, _e3811, (_e3811 > 0i)))];
let _e3822 = (bitcast<f32>(((_e3790 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3830 = (_e3822 + (((bitcast<f32>(((_e3799 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3822) * _e3677));
let _e3835 = (bitcast<f32>(((_e3808 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3859 = (bitcast<f32>((((_e3790 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3867 = (_e3859 + (((bitcast<f32>((((_e3799 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3859) * _e3677));
let _e3872 = (bitcast<f32>((((_e3808 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3883 = (_e3867 + (((_e3872 + (((bitcast<f32>((((_e3817 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3872) * _e3677)) - _e3867) * _e3675));
let _e3887 = -((_e3883 * (_e3635 * _e3530.member)));
let _e3889 = select(-87f, _e3887, (_e3887 > -87f));
let _e3891 = select(88f, _e3889, (_e3889 < 88f));
let _e3893 = ((_e3891 * 1.442695f) + 0.5f);
let _e3895 = select(-127f, _e3893, (_e3893 > -127f));
let _e3897 = select(128f, _e3895, (_e3895 < 128f));
let _e3904 = select(0i, select(select(i32(_e3897), i32(-2147483648), (_e3897 < -2147483600f)), 2147483647i, (_e3897 > 2147483500f)), (_e3897 == _e3897));
let _e3908 = (_e3904 - select(0i, 1i, (_e3897 < f32(_e3904))));
let _e3909 = f32(_e3908);
let _e3913 = ((_e3891 - (_e3909 * 0.6933594f)) - (_e3909 * -2.1219444e-4f));
let _e3933 = ((1f + (_e3913 * (1f + (_e3913 * (0.5f + (_e3913 * (0.16666667f + (_e3913 * (0.041666668f + (_e3913 * (0.008333334f + (_e3913 * (0.001388889f + (_e3913 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3908 + 127i)) << bitcast<u32>(23i))));
let _e3934 = (1f - _e3933);
let _e3937 = (_e3934 / select(1e-12f, _e3883, (_e3883 > 1e-12f)));
phi_8463_ = type_31(_e3933, _e3934, vec3<f32>(1f, 1f, 1f), vec3<f32>(((_e3728 + (((_e3733 + (((bitcast<f32>(((_e3715 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3733) * _e3677)) - _e3728) * _e3675)) * _e3937), ((_e3765 + (((_e3770 + (((bitcast<f32>((((_e3715 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3770) * _e3677)) - _e3765) * _e3675)) * _e3937), ((_e3830 + (((_e3835 + (((bitcast<f32>(((_e3817 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3835) * _e3677)) - _e3830) * _e3675)) * _e3937)));
} else {
let _e3944 = (_e2977 * 255f);
let _e3945 = (_e2710.member * 255f);
let _e3946 = (255f - 1f);
let _e3948 = select(0f, _e3944, (_e3944 > 0f));
let _e3950 = select(_e3946, _e3948, (_e3948 < _e3946));
let _e3957 = select(0i, select(select(i32(_e3950), i32(-2147483648), (_e3950 < -2147483600f)), 2147483647i, (_e3950 > 2147483500f)), (_e3950 == _e3950));
let _e3961 = (_e3957 - select(0i, 1i, (_e3950 < f32(_e3957))));
let _e3963 = select(0f, _e3945, (_e3945 > 0f));
let _e3965 = select(_e3946, _e3963, (_e3963 < _e3946));
let _e3972 = select(0i, select(select(i32(_e3965), i32(-2147483648), (_e3965 < -2147483600f)), 2147483647i, (_e3965 > 2147483500f)), (_e3965 == _e3965));
let _e3976 = (_e3972 - select(0i, 1i, (_e3965 < f32(_e3972))));
let _e3979 = (((_e3961 * 256i) + _e3976) * 4i);
let _e3981 = (_e3944 - f32(_e3961));
let _e3983 = (_e3945 - f32(_e3976));
let _e3985 = (bitcast<i32>(_e131) - 1i);
let _e3987 = select(_e3985, _e3979, (_e3979 < _e3985));
let _e3993 = global_3.member[bitcast<u32>(select(0i, _e3987, (_e3987 > 0i)))];
let _e3994 = (_e3979 + 4i);
let _e3996 = select(_e3985, _e3994, (_e3994 < _e3985));
let _e4002 = global_3.member[bitcast<u32>(select(0i, _e3996, (_e3996 > 0i)))];
let _e4003 = (_e3979 + 1024i);
let _e4005 = select(_e3985, _e4003, (_e4003 < _e3985));
let _e4011 = global_3.member[bitcast<u32>(select(0i, _e4005, (_e4005 > 0i)))];
let _e4012 = (_e3979 + 1028i);
let _e4014 = select(_e3985, _e4012, (_e4012 < _e3985));
let _e4020 = global_3.member[bitcast<u32>(select(0i, _e4014, (_e4014 > 0i)))];
let _e4025 = (bitcast<f32>(((_e3993 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4033 = (_e4025 + (((bitcast<f32>(((_e4002 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4025) * _e3983));
let _e4038 = (bitcast<f32>(((_e4011 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4049 = (_e4033 + (((_e4038 + (((bitcast<f32>(((_e4020 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4038) * _e3983)) - _e4033) * _e3981));
let _e4062 = (bitcast<f32>((((_e3993 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4070 = (_e4062 + (((bitcast<f32>((((_e4002 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4062) * _e3983));
let _e4075 = (bitcast<f32>((((_e4011 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4087 = (_e3979 + 1i);
let _e4089 = select(_e3985, _e4087, (_e4087 < _e3985));
let _e4095 = global_3.member[bitcast<u32>(select(0i, _e4089, (_e4089 > 0i)))];
let _e4096 = (_e3979 + 5i);
let _e4098 = select(_e3985, _e4096, (_e4096 < _e3985));
let _e4104 = global_3.member[bitcast<u32>(select(0i, _e4098, (_e4098 > 0i)))];
let _e4105 = (_e3979 + 1025i);
let _e4107 = select(_e3985, _e4105, (_e4105 < _e3985));
let _e4113 = global_3.member[bitcast<u32>(select(0i, _e4107, (_e4107 > 0i)))];
let _e4114 = (_e3979 + 1029i);
let _e4116 = select(_e3985, _e4114, (_e4114 < _e3985));
let _e4122 = global_3.member[bitcast<u32>(select(0i, _e4116, (_e4116 > 0i)))];
let _e4127 = (bitcast<f32>(((_e4095 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4135 = (_e4127 + (((bitcast<f32>(((_e4104 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4127) * _e3983));
let _e4140 = (bitcast<f32>(((_e4113 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4164 = (bitcast<f32>((((_e4095 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4172 = (_e4164 + (((bitcast<f32>((((_e4104 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4164) * _e3983));
let _e4177 = (bitcast<f32>((((_e4113 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4189 = (_e3979 + 2i);
let _e4191 = select(_e3985, _e4189, (_e4189 < _e3985));
let _e4197 = global_3.member[bitcast<u32>(select(0i, _e4191, (_e4191 > 0i)))];
let _e4198 = (_e3979 + 6i);
let _e4200 = select(_e3985, _e4198, (_e4198 < _e3985));
let _e4206 = global_3.member[bitcast<u32>(select(0i, _e4200, (_e4200 > 0i)))];
let _e4207 = (_e3979 + 1026i);
let _e4209 = select(_e3985, _e4207, (_e4207 < _e3985));
let _e4215 = global_3.member[bitcast<u32>(select(0i, _e4209, (_e4209 > 0i)))];
let _e4216 = (_e3979 + 1030i);
let _e4218 = select(_e3985, _e4216, (_e4216 < _e3985));
let _e4224 = global_3.member[bitcast<u32>(select(0i, _e4218, (_e4218 > 0i)))];
let _e4229 = (bitcast<f32>(((_e4197 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4237 = (_e4229 + (((bitcast<f32>(((_e4206 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4229) * _e3983));
let _e4242 = (bitcast<f32>(((_e4215 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4266 = (bitcast<f32>((((_e4197 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4274 = (_e4266 + (((bitcast<f32>((((_e4206 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4266) * _e3983));
let _e4279 = (bitcast<f32>((((_e4215 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4291 = (_e3979 + 3i);
let _e4293 = select(_e3985, _e4291, (_e4291 < _e3985));
let _e4299 = global_3.member[bitcast<u32>(select(0i, _e4293, (_e4293 > 0i)))];
let _e4300 = (_e3979 + 7i);
let _e4302 = select(_e3985, _e4300, (_e4300 < _e3985));
let _e4308 = global_3.member[bitcast<u32>(select(0i, _e4302, (_e4302 > 0i)))];
let _e4309 = (_e3979 + 1027i);
let _e4311 = select(_e3985, _e4309, (_e4309 < _e3985));
let _e4317 = global_3.member[bitcast<u32>(select(0i, _e4311, (_e4311 > 0i)))];
let _e4318 = (_e3979 + 1031i);
let _e4320 = select(_e3985, _e4318, (_e4318 < _e3985));
let _e4326 = global_3.member[bitcast<u32>(select(0i, _e4320, (_e4320 > 0i)))];
let _e4331 = (bitcast<f32>(((_e4299 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4339 = (_e4331 + (((bitcast<f32>(((_e4308 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4331) * _e3983));
let _e4344 = (bitcast<f32>(((_e4317 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4359 = (_e3635 * _e3530.member_1);
let _e4361 = -(((_e4070 + (((_e4075 + (((bitcast<f32>((((_e4020 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4075) * _e3983)) - _e4070) * _e3981)) * _e4359));
let _e4363 = select(-87f, _e4361, (_e4361 > -87f));
let _e4365 = select(88f, _e4363, (_e4363 < 88f));
let _e4367 = ((_e4365 * 1.442695f) + 0.5f);
let _e4369 = select(-127f, _e4367, (_e4367 > -127f));
let _e4371 = select(128f, _e4369, (_e4369 < 128f));
let _e4378 = select(0i, select(select(i32(_e4371), i32(-2147483648), (_e4371 < -2147483600f)), 2147483647i, (_e4371 > 2147483500f)), (_e4371 == _e4371));
let _e4382 = (_e4378 - select(0i, 1i, (_e4371 < f32(_e4378))));
let _e4383 = f32(_e4382);
let _e4387 = ((_e4365 - (_e4383 * 0.6933594f)) - (_e4383 * -2.1219444e-4f));
let _e4409 = -(((_e4135 + (((_e4140 + (((bitcast<f32>(((_e4122 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4140) * _e3983)) - _e4135) * _e3981)) * _e4359));
let _e4411 = select(-87f, _e4409, (_e4409 > -87f));
let _e4413 = select(88f, _e4411, (_e4411 < 88f));
let _e4415 = ((_e4413 * 1.442695f) + 0.5f);
let _e4417 = select(-127f, _e4415, (_e4415 > -127f));
let _e4419 = select(128f, _e4417, (_e4417 < 128f));
let _e4426 = select(0i, select(select(i32(_e4419), i32(-2147483648), (_e4419 < -2147483600f)), 2147483647i, (_e4419 > 2147483500f)), (_e4419 == _e4419));
let _e4430 = (_e4426 - select(0i, 1i, (_e4419 < f32(_e4426))));
let _e4431 = f32(_e4430);
let _e4435 = ((_e4413 - (_e4431 * 0.6933594f)) - (_e4431 * -2.1219444e-4f));
let _e4457 = -(((_e4172 + (((_e4177 + (((bitcast<f32>((((_e4122 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4177) * _e3983)) - _e4172) * _e3981)) * _e4359));
let _e4459 = select(-87f, _e4457, (_e4457 > -87f));
let _e4461 = select(88f, _e4459, (_e4459 < 88f));
let _e4463 = ((_e4461 * 1.442695f) + 0.5f);
let _e4465 = select(-127f, _e4463, (_e4463 > -127f));
let _e4467 = select(128f, _e4465, (_e4465 < 128f));
let _e4474 = select(0i, select(select(i32(_e4467), i32(-2147483648), (_e4467 < -2147483600f)), 2147483647i, (_e4467 > 2147483500f)), (_e4467 == _e4467));
let _e4478 = (_e4474 - select(0i, 1i, (_e4467 < f32(_e4474))));
let _e4479 = f32(_e4478);
let _e4483 = ((_e4461 - (_e4479 * 0.6933594f)) - (_e4479 * -2.1219444e-4f));
let _e4506 = -((_e4049 * (_e3635 * _e3530.member)));
let _e4508 = select(-87f, _e4506, (_e4506 > -87f));
let _e4510 = select(88f, _e4508, (_e4508 < 88f));
let _e4512 = ((_e4510 * 1.442695f) + 0.5f);
let _e4514 = select(-127f, _e4512, (_e4512 > -127f));
let _e4516 = select(128f, _e4514, (_e4514 < 128f));
let _e4523 = select(0i, select(select(i32(_e4516), i32(-2147483648), (_e4516 < -2147483600f)), 2147483647i, (_e4516 > 2147483500f)), (_e4516 == _e4516));
let _e4527 = (_e4523 - select(0i, 1i, (_e4516 < f32(_e4523))));
let _e4528 = f32(_e4527);
let _e4532 = ((_e4510 - (_e4528 * 0.6933594f)) - (_e4528 * -2.1219444e-4f));
let _e4552 = ((1f + (_e4532 * (1f + (_e4532 * (0.5f + (_e4532 * (0.16666667f + (_e4532 * (0.041666668f + (_e4532 * (0.008333334f + (_e4532 * (0.001388889f + (_e4532 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4527 + 127i)) << bitcast<u32>(23i))));
let _e4553 = (1f - _e4552);
let _e4556 = (_e4553 / select(1e-12f, _e4049, (_e4049 > 1e-12f)));
phi_8463_ = type_31(_e4552, _e4553, vec3<f32>(((1f + (_e4387 * (1f + (_e4387 * (0.5f + (_e4387 * (0.16666667f + (_e4387 * (0.041666668f + (_e4387 * (0.008333334f + (_e4387 * (0.001388889f + (_e4387 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4382 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e4435 * (1f + (_e4435 * (0.5f + (_e4435 * (0.16666667f + (_e4435 * (0.041666668f + (_e4435 * (0.008333334f + (_e4435 * (0.001388889f + (_e4435 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4430 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e4483 * (1f + (_e4483 * (0.5f + (_e4483 * (0.16666667f + (_e4483 * (0.041666668f + (_e4483 * (0.008333334f + (_e4483 * (0.001388889f + (_e4483 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4478 + 127i)) << bitcast<u32>(23i))))), vec3<f32>(((_e4237 + (((_e4242 + (((bitcast<f32>(((_e4224 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4242) * _e3983)) - _e4237) * _e3981)) * _e4556), ((_e4274 + (((_e4279 + (((bitcast<f32>((((_e4224 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4279) * _e3983)) - _e4274) * _e3981)) * _e4556), ((_e4339 + (((_e4344 + (((bitcast<f32>(((_e4326 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4344) * _e3983)) - _e4339) * _e3981)) * _e4556)));
}
let _e4563 = phi_8463_;
let _e4564 = select(0f, _e3317, _e450);
let _e4568 = (_e385 + (_e3617 * _e4564));
let _e4569 = (_e388 + (_e3618 * _e4564));
let _e4570 = (_e379 + (_e3619 * _e4564));
if (_e974.member_2 == 3u) {
let _e4576 = global_5.member[_e360].member_9.member_1;
let _e4585 = global_5.member[_e360].member_9.member;
phi_9446_ = type_25(vec3<f32>(_e4576.member, _e4576.member_1, _e4576.member_2), vec3<f32>(_e4585.member, _e4585.member_1, _e4585.member_2));
} else {
let _e4595 = global_5.member[_e360].member_8.member_8;
let _e4596 = (_e4570 - _e4595);
let _e4601 = global_5.member[_e360].member_8.member_2;
let _e4606 = global_5.member[_e360].member_8.member_6;
let _e4614 = global_5.member[_e360].member_8.member_5;
let _e4616 = (((_e4568 - (_e4601 + (_e4606 * _e4596))) * _e4614) - 0.5f);
let _e4621 = global_5.member[_e360].member_8.member_3;
let _e4626 = global_5.member[_e360].member_8.member_7;
let _e4631 = (((_e4569 - (_e4621 + (_e4626 * _e4596))) * _e4614) - 0.5f);
let _e4636 = global_5.member[_e360].member_8.member;
let _e4637 = bitcast<i32>(_e4636);
let _e4639 = (f32(_e4637) - 1f);
let _e4644 = global_5.member[_e360].member_8.member_1;
let _e4647 = (f32(bitcast<i32>(_e4644)) - 1f);
let _e4649 = select(0f, _e4616, (_e4616 > 0f));
let _e4651 = select(_e4639, _e4649, (_e4649 < _e4639));
let _e4658 = select(0i, select(select(i32(_e4651), i32(-2147483648), (_e4651 < -2147483600f)), 2147483647i, (_e4651 > 2147483500f)), (_e4651 == _e4651));
let _e4662 = (_e4658 - select(0i, 1i, (_e4651 < f32(_e4658))));
let _e4664 = select(0f, _e4631, (_e4631 > 0f));
let _e4666 = select(_e4647, _e4664, (_e4664 < _e4647));
let _e4673 = select(0i, select(select(i32(_e4666), i32(-2147483648), (_e4666 < -2147483600f)), 2147483647i, (_e4666 > 2147483500f)), (_e4666 == _e4666));
let _e4677 = (_e4673 - select(0i, 1i, (_e4666 < f32(_e4673))));
let _e4681 = (_e4616 - f32(_e4662));
let _e4683 = (_e4631 - f32(_e4677));
let _e4690 = ((((_e4616 >= 0f) && (_e4616 <= _e4639)) && (_e4631 >= 0f)) && (_e4631 <= _e4647));
let _e4694 = global_5.member[_e360].member_4;
let _e4695 = bitcast<i32>(_e4694);
let _e4697 = bitcast<i32>((_e4636 * _e4644));
let _e4699 = (_e4695 + (3i * _e4697));
local_1 = (_e4699 + ((_e4677 * _e4637) + _e4662));
let _e4701 = local_1;
let _e4703 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e4705 = select(_e4703, _e4701, (_e4701 < _e4703));
let _e4710 = global_6.member[bitcast<u32>(select(0i, _e4705, (_e4705 > 0i)))];
let _e4711 = bitcast<u32>(_e4710);
let _e4715 = f32((bitcast<i32>((_e4711 & 65535u)) - 32768i));
let _e4721 = f32((bitcast<i32>(((_e4711 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4726 = select(_e4721, -(_e4721), ((_e4711 >> bitcast<u32>(31i)) != 0u));
let _e4727 = local_1;
let _e4728 = (_e4727 + 1i);
let _e4730 = select(_e4703, _e4728, (_e4728 < _e4703));
let _e4735 = global_6.member[bitcast<u32>(select(0i, _e4730, (_e4730 > 0i)))];
let _e4736 = bitcast<u32>(_e4735);
let _e4746 = f32((bitcast<i32>(((_e4736 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4752 = local_1;
let _e4753 = (_e4752 + _e4637);
let _e4755 = select(_e4703, _e4753, (_e4753 < _e4703));
let _e4760 = global_6.member[bitcast<u32>(select(0i, _e4755, (_e4755 > 0i)))];
let _e4761 = bitcast<u32>(_e4760);
let _e4765 = f32((bitcast<i32>((_e4761 & 65535u)) - 32768i));
let _e4771 = f32((bitcast<i32>(((_e4761 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4776 = select(_e4771, -(_e4771), ((_e4761 >> bitcast<u32>(31i)) != 0u));
let _e4777 = (_e4637 + 1i);
let _e4778 = local_1;
let _e4779 = (_e4778 + _e4777);
let _e4781 = select(_e4703, _e4779, (_e4779 < _e4703));
let _e4786 = global_6.member[bitcast<u32>(select(0i, _e4781, (_e4781 > 0i)))];
let _e4787 = bitcast<u32>(_e4786);
let _e4797 = f32((bitcast<i32>(((_e4787 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4805 = (_e4715 + ((f32((bitcast<i32>((_e4736 & 65535u)) - 32768i)) - _e4715) * _e4681));
let _e4814 = (_e4726 + ((select(_e4746, -(_e4746), ((_e4736 >> bitcast<u32>(31i)) != 0u)) - _e4726) * _e4681));
let _e4827 = global_5.member[_e360].member_9.member;
let _e4830 = (1f / 16255f);
let _e4832 = (_e4827.member + (select(0f, (_e4805 + (((_e4765 + ((f32((bitcast<i32>((_e4787 & 65535u)) - 32768i)) - _e4765) * _e4681)) - _e4805) * _e4683)), _e4690) * _e4830));
let _e4834 = (_e4827.member_1 + (select(0f, (_e4814 + (((_e4776 + ((select(_e4797, -(_e4797), ((_e4787 >> bitcast<u32>(31i)) != 0u)) - _e4776) * _e4681)) - _e4814) * _e4683)), _e4690) * _e4830));
let _e4838 = (1f - ((_e4832 * _e4832) + (_e4834 * _e4834)));
let _e4840 = select(1e-4f, _e4838, (_e4838 > 1e-4f));
let _e4843 = sqrt(select(0f, _e4840, (_e4840 > 0f)));
let _e4847 = (1f / select(1e-6f, _e4843, (_e4843 > 1e-6f)));
let _e4848 = ((_e4570 - _e379) * _e4614);
let _e4855 = (_e4616 - (((_e4832 * _e4847) - _e4606) * _e4848));
let _e4856 = (_e4631 - (((_e4834 * _e4847) - _e4626) * _e4848));
let _e4858 = select(0f, _e4855, (_e4855 > 0f));
let _e4860 = select(_e4639, _e4858, (_e4858 < _e4639));
let _e4867 = select(0i, select(select(i32(_e4860), i32(-2147483648), (_e4860 < -2147483600f)), 2147483647i, (_e4860 > 2147483500f)), (_e4860 == _e4860));
let _e4871 = (_e4867 - select(0i, 1i, (_e4860 < f32(_e4867))));
let _e4873 = select(0f, _e4856, (_e4856 > 0f));
let _e4875 = select(_e4647, _e4873, (_e4873 < _e4647));
let _e4882 = select(0i, select(select(i32(_e4875), i32(-2147483648), (_e4875 < -2147483600f)), 2147483647i, (_e4875 > 2147483500f)), (_e4875 == _e4875));
let _e4886 = (_e4882 - select(0i, 1i, (_e4875 < f32(_e4882))));
let _e4888 = ((_e4886 * _e4637) + _e4871);
let _e4890 = (_e4855 - f32(_e4871));
let _e4892 = (_e4856 - f32(_e4886));
let _e4899 = ((((_e4855 >= 0f) && (_e4855 <= _e4639)) && (_e4856 >= 0f)) && (_e4856 <= _e4647));
let _e4900 = (_e4695 + _e4888);
let _e4902 = select(_e4703, _e4900, (_e4900 < _e4703));
let _e4908 = global_6.member[bitcast<u32>(select(0i, _e4902, (_e4902 > 0i)))];
let _e4909 = (_e4900 + 1i);
let _e4911 = select(_e4703, _e4909, (_e4909 < _e4703));
let _e4917 = global_6.member[bitcast<u32>(select(0i, _e4911, (_e4911 > 0i)))];
let _e4920 = (_e4908 + ((_e4917 - _e4908) * _e4890));
let _e4921 = (_e4900 + _e4637);
let _e4923 = select(_e4703, _e4921, (_e4921 < _e4703));
let _e4929 = global_6.member[bitcast<u32>(select(0i, _e4923, (_e4923 > 0i)))];
let _e4930 = (_e4921 + 1i);
let _e4932 = select(_e4703, _e4930, (_e4930 < _e4703));
let _e4938 = global_6.member[bitcast<u32>(select(0i, _e4932, (_e4932 > 0i)))];
let _e4945 = select(1f, (_e4920 + (((_e4929 + ((_e4938 - _e4929) * _e4890)) - _e4920) * _e4892)), _e4899);
if _e3636 {
phi_9216_ = vec3(_e4945);
} else {
let _e4948 = ((_e4695 + _e4697) + _e4888);
let _e4950 = select(_e4703, _e4948, (_e4948 < _e4703));
let _e4956 = global_6.member[bitcast<u32>(select(0i, _e4950, (_e4950 > 0i)))];
let _e4957 = (_e4948 + 1i);
let _e4959 = select(_e4703, _e4957, (_e4957 < _e4703));
let _e4965 = global_6.member[bitcast<u32>(select(0i, _e4959, (_e4959 > 0i)))];
let _e4968 = (_e4956 + ((_e4965 - _e4956) * _e4890));
let _e4969 = (_e4948 + _e4637);
let _e4971 = select(_e4703, _e4969, (_e4969 < _e4703));
let _e4977 = global_6.member[bitcast<u32>(select(0i, _e4971, (_e4971 > 0i)))];
let _e4978 = (_e4969 + 1i);
let _e4980 = select(_e4703, _e4978, (_e4978 < _e4703));
let _e4986 = global_6.member[bitcast<u32>(select(0i, _e4980, (_e4980 > 0i)))];
let _e4996 = ((_e4695 + (2i * _e4697)) + _e4888);
let _e4998 = select(_e4703, _e4996, (_e4996 < _e4703));
let _e5004 = global_6.member[bitcast<u32>(select(0i, _e4998, (_e4998 > 0i)))];
let _e5005 = (_e4996 + 1i);
let _e5007 = select(_e4703, _e5005, (_e5005 < _e4703));
let _e5013 = global_6.member[bitcast<u32>(select(0i, _e5007, (_e5007 > 0i)))];
let _e5016 = (_e5004 + ((_e5013 - _e5004) * _e4890));
let _e5017 = (_e4996 + _e4637);
let _e5019 = select(_e4703, _e5017, (_e5017 < _e4703));
let _e5025 = global_6.member[bitcast<u32>(select(0i, _e5019, (_e5019 > 0i)))];
let _e5026 = (_e5017 + 1i);
let _e5028 = select(_e4703, _e5026, (_e5026 < _e4703));
let _e5034 = global_6.member[bitcast<u32>(select(0i, _e5028, (_e5028 > 0i)))];
phi_9216_ = vec3<f32>(_e4945, select(1f, (_e4968 + (((_e4977 + ((_e4986 - _e4977) * _e4890)) - _e4968) * _e4892)), _e4899), select(1f, (_e5016 + (((_e5025 + ((_e5034 - _e5025) * _e4890)) - _e5016) * _e4892)), _e4899));
}
let _e5044 = phi_9216_;
local = (_e4699 + _e4888);
let _e5046 = local;
let _e5048 = select(_e4703, _e5046, (_e5046 < _e4703));
let _e5053 = global_6.member[bitcast<u32>(select(0i, _e5048, (_e5048 > 0i)))];
let _e5054 = bitcast<u32>(_e5053);
let _e5058 = f32((bitcast<i32>((_e5054 & 65535u)) - 32768i));
let _e5064 = f32((bitcast<i32>(((_e5054 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e5069 = select(_e5064, -(_e5064), ((_e5054 >> bitcast<u32>(31i)) != 0u));
let _e5070 = local;
let _e5071 = (_e5070 + 1i);
let _e5073 = select(_e4703, _e5071, (_e5071 < _e4703));
let _e5078 = global_6.member[bitcast<u32>(select(0i, _e5073, (_e5073 > 0i)))];
let _e5079 = bitcast<u32>(_e5078);
let _e5089 = f32((bitcast<i32>(((_e5079 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e5095 = local;
let _e5096 = (_e5095 + _e4637);
let _e5098 = select(_e4703, _e5096, (_e5096 < _e4703));
let _e5103 = global_6.member[bitcast<u32>(select(0i, _e5098, (_e5098 > 0i)))];
let _e5104 = bitcast<u32>(_e5103);
let _e5108 = f32((bitcast<i32>((_e5104 & 65535u)) - 32768i));
let _e5114 = f32((bitcast<i32>(((_e5104 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e5119 = select(_e5114, -(_e5114), ((_e5104 >> bitcast<u32>(31i)) != 0u));
let _e5120 = local;
let _e5121 = (_e5120 + _e4777);
let _e5123 = select(_e4703, _e5121, (_e5121 < _e4703));
let _e5128 = global_6.member[bitcast<u32>(select(0i, _e5123, (_e5123 > 0i)))];
let _e5129 = bitcast<u32>(_e5128);
let _e5139 = f32((bitcast<i32>(((_e5129 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e5147 = (_e5058 + ((f32((bitcast<i32>((_e5079 & 65535u)) - 32768i)) - _e5058) * _e4890));
let _e5156 = (_e5069 + ((select(_e5089, -(_e5089), ((_e5079 >> bitcast<u32>(31i)) != 0u)) - _e5069) * _e4890));
let _e5169 = global_5.member[_e360].member_9.member_1;
let _e5176 = (_e4827.member + (select(0f, (_e5147 + (((_e5108 + ((f32((bitcast<i32>((_e5129 & 65535u)) - 32768i)) - _e5108) * _e4890)) - _e5147) * _e4892)), _e4899) * _e4830));
let _e5178 = (_e4827.member_1 + (select(0f, (_e5156 + (((_e5119 + ((select(_e5139, -(_e5139), ((_e5129 >> bitcast<u32>(31i)) != 0u)) - _e5119) * _e4890)) - _e5156) * _e4892)), _e4899) * _e4830));
let _e5182 = (1f - ((_e5176 * _e5176) + (_e5178 * _e5178)));
let _e5184 = select(1e-4f, _e5182, (_e5182 > 1e-4f));
phi_9446_ = type_25((_e5044 * vec3<f32>(_e5169.member, _e5169.member_1, _e5169.member_2)), vec3<f32>(_e5176, _e5178, sqrt(select(0f, _e5184, (_e5184 > 0f)))));
}
let _e5191 = phi_9446_;
let _e5200 = (((_e5191.member_1.x * _e5191.member_1.x) + (_e5191.member_1.y * _e5191.member_1.y)) + (_e5191.member_1.z * _e5191.member_1.z));
let _e5203 = sqrt(select(0f, _e5200, (_e5200 > 0f)));
let _e5209 = (1e-6f * _e5203);
let _e5213 = select((_e5203 / select(_e5209, _e5191.member_1.z, (_e5191.member_1.z > _e5209))), 1f, ((_e930 & 8u) != 0u));
let _e5215 = (_e5191.member.x * _e5213);
let _e5217 = (_e5191.member.y * _e5213);
let _e5219 = (_e5191.member.z * _e5213);
if _e1037 {
let _e5224 = global_5.member[_e360].member_19;
let _e5233 = (((_e2710.member_1.x * _e2710.member_1.x) + (_e2710.member_1.y * _e2710.member_1.y)) + (_e2710.member_1.z * _e2710.member_1.z));
let _e5236 = sqrt(select(0f, _e5233, (_e5233 > 0f)));
let _e5239 = (1f / select(1e-20f, _e5236, (_e5236 > 1e-20f)));
let _e5240 = (_e2710.member_1.x * _e5239);
let _e5241 = (_e2710.member_1.y * _e5239);
let _e5242 = (_e2710.member_1.z * _e5239);
let _e5245 = (-1f / select(1e-20f, _e5203, (_e5203 > 1e-20f)));
let _e5246 = (_e5191.member_1.x * _e5245);
let _e5247 = (_e5191.member_1.y * _e5245);
let _e5248 = (_e5191.member_1.z * _e5245);
let _e5253 = (((_e364[2] * _e364[2]) + (_e364[3] * _e364[3])) + (_e364[4] * _e364[4]));
let _e5256 = sqrt(select(0f, _e5253, (_e5253 > 0f)));
let _e5259 = (-1f / select(1e-20f, _e5256, (_e5256 > 1e-20f)));
let _e5260 = (_e364[2] * _e5259);
let _e5261 = (_e364[3] * _e5259);
let _e5262 = (_e364[4] * _e5259);
let _e5269 = select(1f, -1f, ((((_e5240 * _e5260) + (_e5241 * _e5261)) + (_e5242 * _e5262)) < 0f));
let _e5270 = (_e5240 * _e5269);
let _e5271 = (_e5241 * _e5269);
let _e5272 = (_e5242 * _e5269);
let _e5277 = (((_e5270 * _e5260) + (_e5271 * _e5261)) + (_e5272 * _e5262));
let _e5279 = select(1e-4f, _e5277, (_e5277 > 1e-4f));
let _e5284 = (((_e5270 * _e5246) + (_e5271 * _e5247)) + (_e5272 * _e5248));
let _e5285 = (_e5246 + _e5260);
let _e5286 = (_e5247 + _e5261);
let _e5287 = (_e5248 + _e5262);
let _e5292 = (((_e5285 * _e5285) + (_e5286 * _e5286)) + (_e5287 * _e5287));
let _e5295 = sqrt(select(0f, _e5292, (_e5292 > 0f)));
let _e5298 = (1f / select(1e-6f, _e5295, (_e5295 > 1e-6f)));
let _e5299 = (_e5285 * _e5298);
let _e5300 = (_e5286 * _e5298);
let _e5301 = (_e5287 * _e5298);
let _e5306 = (((_e5270 * _e5299) + (_e5271 * _e5300)) + (_e5272 * _e5301));
let _e5308 = select(0f, _e5306, (_e5306 > 0f));
let _e5313 = (((_e5260 * _e5299) + (_e5261 * _e5300)) + (_e5262 * _e5301));
let _e5315 = select(0f, _e5313, (_e5313 > 0f));
let _e5316 = (_e5224 * _e5224);
let _e5317 = (_e5316 * _e5316);
let _e5321 = (((_e5308 * _e5308) * (_e5317 - 1f)) + 1f);
let _e5325 = (_e5284 > 0f);
let _e5326 = select(0f, _e5284, _e5325);
let _e5328 = (1f - _e5317);
let _e5330 = (((_e5326 * _e5326) * _e5328) + _e5317);
let _e5337 = (((_e5279 * _e5279) * _e5328) + _e5317);
let _e5342 = ((_e5279 * sqrt(select(0f, _e5330, (_e5330 > 0f)))) + (_e5326 * sqrt(select(0f, _e5337, (_e5337 > 0f)))));
let _e5347 = (_e2710.member_2 / _e3314);
let _e5351 = (((_e5347 * _e5347) - 1f) + (_e5315 * _e5315));
let _e5354 = sqrt(select(0f, _e5351, (_e5351 > 0f)));
let _e5355 = (_e5354 - _e5315);
let _e5356 = (_e5354 + _e5315);
let _e5359 = (_e5355 / select(1e-6f, _e5356, (_e5356 > 1e-6f)));
let _e5363 = ((_e5315 * _e5355) + 1f);
let _e5366 = (((_e5315 * _e5356) - 1f) / select(1e-6f, _e5363, (_e5363 > 1e-6f)));
let _e5384 = global_5.member[_e360].member_20;
let _e5388 = ((select(0f, ((((_e5317 / ((3.1415927f * _e5321) * _e5321)) * (0.5f / select(1e-6f, _e5342, (_e5342 > 1e-6f)))) * select(select((((0.5f * _e5359) * _e5359) * (1f + (_e5366 * _e5366))), 1f, (_e5351 <= 0f)), 0f, (_e3314 == _e2710.member_2))) * _e5326), (_e5325 && (_e5236 > 1e-12f))) * _e5384) * select(_e3530.member_2, 0f, _e450));
phi_9764_ = vec3<f32>((_e5215 * _e5388), (_e5217 * _e5388), (_e5219 * _e5388));
} else {
phi_9764_ = vec3<f32>(0f, 0f, 0f);
}
let _e5394 = phi_9764_;
let _e5405 = global_5.member[_e360].member_18;
let _e5412 = (1f - _e364[11]);
let _e5432 = (_e364[8] + ((_e364[12] * ((_e4563.member_3.x * (_e5215 + _e5405.member)) + _e5394.x)) * _e5412));
let _e5433 = (_e364[9] + ((_e364[13] * ((_e4563.member_3.y * (_e5217 + _e5405.member_1)) + _e5394.y)) * _e5412));
let _e5434 = (_e364[10] + ((_e364[14] * ((_e4563.member_3.z * (_e5219 + _e5405.member_2)) + _e5394.z)) * _e5412));
let _e5437 = (_e364[11] + (_e5412 * _e4563.member_1));
let _e5440 = (_e364[12] * _e4563.member_2.x);
let _e5442 = (_e364[13] * _e4563.member_2.y);
let _e5444 = (_e364[14] * _e4563.member_2.z);
let _e5450 = (_e364[7] + ((_e5437 - _e364[11]) * (_e379 + (_e3619 * 0.5f))));
let _e5459 = (-((((select(_e1007.member, _e994.member, _e987) * _e5191.member_1.x) + (select(_e1007.member_1, _e994.member_1, _e987) * _e5191.member_1.y)) + (select(_e1007.member_2, _e994.member_2, _e987) * _e5191.member_1.z))) / select(1e-20f, _e5203, (_e5203 > 1e-20f)));
let _e5464 = bitcast<f32>((bitcast<u32>(select(0f, _e5459, (_e5459 > 0f))) & 2147483647u));
let _e5474 = (1f - _e5437);
let _e5487 = select(_e5437, 1f, _e450);
if _e1037 {
let _e5496 = global_5.member[_e360].member_5.member_4;
let _e5499 = (_e2710.member_3.x * _e3530.member_2);
let _e5501 = (_e2710.member_3.y * _e3530.member_2);
let _e5503 = (_e2710.member_3.z * _e3530.member_2);
let _e5504 = (0.5f * _e374);
let _e5508 = (_e364[2] + (_e5499 * _e5504));
let _e5509 = (_e364[3] + (_e5501 * _e5504));
let _e5510 = (_e364[4] + (_e5503 * _e5504));
let _e5512 = (2f * _e373);
let _e5514 = ((_e5510 * _e5510) + (_e5512 * _e5503));
let _e5518 = (_e5510 + sqrt(select(0f, _e5514, (_e5514 > 0f))));
let _e5522 = (0.5f * (_e5512 / select(1e-6f, _e5518, (_e5518 > 1e-6f))));
let _e5526 = (_e5508 + (_e5499 * _e5522));
let _e5527 = (_e5509 + (_e5501 * _e5522));
let _e5528 = (_e5510 + (_e5503 * _e5522));
let _e5532 = (_e5496 * _e5496);
let _e5534 = (_e5528 * _e5528);
let _e5542 = (((_e5510 <= 0f) || (_e5514 <= 0f)) || ((_e5528 <= 0f) || (_e5534 <= (_e5532 * (((_e5526 * _e5526) + (_e5527 * _e5527)) + _e5534)))));
let _e5556 = (_e364[2] + ((_e2710.member_4.x * _e3530.member_2) * _e373));
let _e5557 = (_e364[3] + ((_e2710.member_4.y * _e3530.member_2) * _e373));
let _e5558 = (_e364[4] + ((_e2710.member_4.z * _e3530.member_2) * _e373));
let _e5560 = (_e5558 * _e5558);
let _e5569 = ((_e930 & 1u) != 0u);
phi_10073_ = select(select(_e5528, _e5510, _e5542), _e5558, _e5569);
phi_10074_ = select(select(_e5527, _e5509, _e5542), _e5557, _e5569);
phi_10075_ = select(select(_e5526, _e5508, _e5542), _e5556, _e5569);
phi_10076_ = select(_e5542, ((_e5558 <= 0f) || (_e5560 <= (_e5532 * (((_e5556 * _e5556) + (_e5557 * _e5557)) + _e5560)))), _e5569);
} else {
phi_10073_ = _e364[4];
phi_10074_ = _e364[3];
phi_10075_ = _e364[2];
phi_10076_ = false;
}
let _e5575 = phi_10073_;
let _e5577 = phi_10074_;
let _e5579 = phi_10075_;
let _e5581 = phi_10076_;
let _e5587 = (((_e450 || (_e5579 != _e364[2])) || (_e5577 != _e364[3])) || (_e5575 != _e364[4]));
let _e5589 = select(_e5442, _e5440, (_e5440 > _e5442));
phi_10136_ = array<f32, 18>(select(_e364[0], select(_e390, _e4568, _e450), _e5587), select(_e364[1], select(_e392, _e4569, _e450), _e5587), _e5579, _e5577, _e5575, _e2710.member, select(select(0f, 2f, _e5581), 1f, (_e450 || (((1f - _e5487) * select(_e5444, _e5589, (_e5589 > _e5444))) < 9.765625e-4f))), select(_e5450, (_e5450 + (_e5474 * _e4570)), _e450), select(_e5432, (_e5432 + ((_e5440 * (select(_e1013.member, _e1000.member, _e987) * ((_e5215 * _e5464) + _e5405.member))) * _e5474)), _e450), select(_e5433, (_e5433 + ((_e5442 * (select(_e1013.member_1, _e1000.member_1, _e987) * ((_e5217 * _e5464) + _e5405.member_1))) * _e5474)), _e450), select(_e5434, (_e5434 + ((_e5444 * (select(_e1013.member_2, _e1000.member_2, _e987) * ((_e5219 * _e5464) + _e5405.member_2))) * _e5474)), _e450), _e5487, _e5440, _e5442, _e5444, _e2710.member_2, select(_e364[16], select(_e397, _e4570, _e450), _e5587), _e397);
} else {
phi_10136_ = _e364;
}
let _e5608 = phi_10136_;
phi_588_ = (_e360 + 1u);
phi_591_ = select(_e362, true, _e970);
phi_593_ = _e5608;
} else {
phi_588_ = u32();
phi_591_ = bool();
phi_593_ = array<f32, 18>();
}
let _e5612 = phi_588_;
let _e5614 = phi_591_;
let _e5616 = phi_593_;
continue;
continuing {
phi_587_ = _e5612;
phi_590_ = _e5614;
phi_592_ = _e5616;
phi_10219_ = false;
break if !(_e365);
}
}
let _e5619 = phi_10219_;
if _e5619 {
break;
}
let _e5621 = local_12;
if _e5621 {
let _e5623 = local_13;
global_4.member[_e160] = _e5623[0];
let _e5628 = local_14;
global_4.member[_e172] = _e5628[1];
let _e5633 = local_15;
global_4.member[_e183] = _e5633[2];
let _e5638 = local_16;
global_4.member[_e194] = _e5638[3];
let _e5643 = local_17;
global_4.member[_e205] = _e5643[4];
let _e5648 = local_18;
global_4.member[_e216] = _e5648[5];
let _e5653 = local_19;
global_4.member[_e227] = _e5653[6];
let _e5658 = local_20;
global_4.member[_e238] = _e5658[7];
let _e5663 = local_21;
global_4.member[_e249] = _e5663[8];
let _e5668 = local_22;
global_4.member[_e260] = _e5668[9];
let _e5673 = local_23;
global_4.member[_e271] = _e5673[10];
let _e5678 = local_24;
global_4.member[_e282] = _e5678[11];
let _e5683 = local_25;
global_4.member[_e293] = _e5683[12];
let _e5688 = local_26;
global_4.member[_e304] = _e5688[13];
let _e5693 = local_27;
global_4.member[_e315] = _e5693[14];
let _e5698 = local_28;
global_4.member[_e326] = _e5698[15];
let _e5703 = local_29;
global_4.member[_e337] = _e5703[16];
let _e5708 = local_30;
global_4.member[_e348] = _e5708[17];
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
