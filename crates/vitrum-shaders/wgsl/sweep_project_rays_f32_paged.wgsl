struct type_2 {
member: u32,
member_1: u32,
member_2: u32,
}
struct type_3 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_4 {
member: u32,
member_1: u32,
}
struct type_6 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_7 {
member: f32,
member_1: f32,
member_2: f32,
}
struct type_8 {
member: type_7,
member_1: f32,
}
struct type_10 {
member: type_8,
member_1: type_8,
member_2: type_8,
member_3: type_7,
member_4: type_7,
member_5: type_7,
member_6: f32,
member_7: f32,
member_8: f32,
member_9: i32,
member_10: i32,
member_11: type_2,
member_12: u32,
member_13: type_2,
member_14: u32,
member_15: u32,
}
struct type_11 {
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
struct type_12 {
member: type_7,
member_1: type_7,
}
struct type_13 {
member: type_4,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
}
struct type_14 {
member: type_7,
member_1: f32,
member_2: f32,
}
struct type_15 {
member: type_8,
member_1: type_8,
member_2: type_8,
member_3: u32,
member_4: type_4,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
member_9: f32,
member_10: f32,
member_11: f32,
member_12: u32,
member_13: u32,
member_14: type_2,
member_15: u32,
member_16: u32,
member_17: type_4,
member_18: type_13,
member_19: type_7,
member_20: type_14,
member_21: f32,
member_22: f32,
member_23: f32,
member_24: f32,
}
struct type_16 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_17 {
member: type_8,
member_1: type_7,
}
struct type_18 {
member: type_17,
member_1: type_17,
}
struct type_19 {
member: type_8,
member_1: u32,
}
struct type_20 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: type_7,
member_4: type_7,
member_5: type_7,
member_6: type_7,
member_7: type_7,
member_8: type_7,
member_9: type_7,
}
struct type_21 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: type_7,
member_5: type_7,
member_6: type_7,
member_7: type_7,
member_8: type_7,
member_9: type_7,
member_10: f32,
member_11: f32,
member_12: f32,
}
struct type_22 {
member: type_2,
member_1: u32,
member_2: type_3,
member_3: type_4,
member_4: type_4,
member_5: u32,
member_6: u32,
member_7: type_6,
member_8: type_10,
member_9: type_10,
member_10: type_11,
member_11: type_12,
member_12: type_15,
member_13: type_6,
member_14: type_16,
member_15: type_18,
member_16: type_19,
member_17: type_19,
member_18: type_19,
member_19: type_19,
member_20: type_20,
member_21: f32,
member_22: f32,
member_23: type_21,
}
struct type_24 {
member: array<u32>,
}
struct type_26 {
member: array<f32>,
}
struct type_29 {
member: array<i32, 4>,
member_1: array<u32, 6>,
}
struct type_32 {
member: f32,
member_1: f32,
}
struct type_34 {
member: array<type_22>,
}
var<private> global: vec3<u32>;
@group(0) @binding(1)
var<storage> global_1: type_24;
@group(0) @binding(0)
var<storage> global_2: type_34;
@group(0) @binding(3)
var<storage> global_3: type_24;
@group(0) @binding(5)
var<storage, read_write> global_4: type_26;
fn function_() {
var local: type_29;
var local_1: vec3<f32>;
var local_2: type_29;
var local_3: vec3<f32>;
var local_4: type_29;
var local_5: vec3<f32>;
var local_6: type_29;
var local_7: vec3<f32>;
var local_8: type_29;
var local_9: vec3<f32>;
var local_10: type_29;
var local_11: vec3<f32>;
var local_12: type_29;
var local_13: vec3<f32>;
var local_14: type_29;
var local_15: vec3<f32>;
var local_16: type_29;
var local_17: vec3<f32>;
var phi_626_: u32;
var phi_629_: bool;
var phi_631_: array<f32, 23>;
var phi_995_: bool;
var phi_1891_: type_32;
var phi_2112_: vec3<f32>;
var phi_2692_: vec3<f32>;
var phi_3272_: vec3<f32>;
var phi_3852_: vec3<f32>;
var phi_4260_: f32;
var phi_4468_: vec3<f32>;
var phi_4853_: bool;
var phi_5066_: vec3<f32>;
var phi_5448_: bool;
var phi_5662_: vec3<f32>;
var phi_6044_: bool;
var phi_6258_: vec3<f32>;
var phi_6640_: bool;
var phi_6853_: vec3<f32>;
var phi_7235_: bool;
var phi_7245_: f32;
var phi_7246_: f32;
var phi_7264_: array<f32, 23>;
var phi_627_: u32;
var phi_630_: bool;
var phi_632_: array<f32, 23>;
var phi_7367_: bool;
var local_18: bool;
var local_19: array<f32, 23>;
var local_20: array<f32, 23>;
var local_21: array<f32, 23>;
var local_22: array<f32, 23>;
var local_23: array<f32, 23>;
var local_24: array<f32, 23>;
var local_25: array<f32, 23>;
var local_26: array<f32, 23>;
var local_27: array<f32, 23>;
var local_28: array<f32, 23>;
var local_29: array<f32, 23>;
var local_30: array<f32, 23>;
var local_31: array<f32, 23>;
var local_32: array<f32, 23>;
var local_33: array<f32, 23>;
var local_34: array<f32, 23>;
var local_35: array<f32, 23>;
var local_36: array<f32, 23>;
var local_37: array<f32, 23>;
var local_38: array<f32, 23>;
var local_39: array<f32, 23>;
var local_40: array<f32, 23>;
var local_41: array<f32, 23>;
switch bitcast<i32>(0u) {
default: {
let _e81 = global;
let _e83 = arrayLength((&global_2.member));
let _e86 = arrayLength((&global_1.member));
if (0u < _e83) {
} else {
break;
}
let _e95 = global_2.member[0u].member_2;
let _e99 = global_2.member[0u].member;
let _e107 = (_e81.x + _e95.member);
let _e109 = (_e81.y + _e95.member_1);
if (_e107 < _e95.member_2) {
if (_e109 < _e95.member_3) {
let _e112 = (_e99.member * _e99.member_1);
let _e114 = ((_e109 * _e99.member) + _e107);
let _e115 = bitcast<i32>(_e114);
let _e117 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e119 = select(_e117, _e115, (_e115 < _e117));
let _e125 = global_4.member[bitcast<u32>(select(0i, _e119, (_e119 > 0i)))];
let _e126 = (_e112 + _e114);
let _e127 = bitcast<i32>(_e126);
let _e129 = select(_e117, _e127, (_e127 < _e117));
let _e135 = global_4.member[bitcast<u32>(select(0i, _e129, (_e129 > 0i)))];
let _e137 = ((2u * _e112) + _e114);
let _e138 = bitcast<i32>(_e137);
let _e140 = select(_e117, _e138, (_e138 < _e117));
let _e146 = global_4.member[bitcast<u32>(select(0i, _e140, (_e140 > 0i)))];
let _e148 = ((3u * _e112) + _e114);
let _e149 = bitcast<i32>(_e148);
let _e151 = select(_e117, _e149, (_e149 < _e117));
let _e157 = global_4.member[bitcast<u32>(select(0i, _e151, (_e151 > 0i)))];
let _e159 = ((4u * _e112) + _e114);
let _e160 = bitcast<i32>(_e159);
let _e162 = select(_e117, _e160, (_e160 < _e117));
let _e168 = global_4.member[bitcast<u32>(select(0i, _e162, (_e162 > 0i)))];
let _e170 = ((5u * _e112) + _e114);
let _e171 = bitcast<i32>(_e170);
let _e173 = select(_e117, _e171, (_e171 < _e117));
let _e179 = global_4.member[bitcast<u32>(select(0i, _e173, (_e173 > 0i)))];
let _e181 = ((6u * _e112) + _e114);
let _e182 = bitcast<i32>(_e181);
let _e184 = select(_e117, _e182, (_e182 < _e117));
let _e190 = global_4.member[bitcast<u32>(select(0i, _e184, (_e184 > 0i)))];
let _e192 = ((7u * _e112) + _e114);
let _e193 = bitcast<i32>(_e192);
let _e195 = select(_e117, _e193, (_e193 < _e117));
let _e201 = global_4.member[bitcast<u32>(select(0i, _e195, (_e195 > 0i)))];
let _e203 = ((8u * _e112) + _e114);
let _e204 = bitcast<i32>(_e203);
let _e206 = select(_e117, _e204, (_e204 < _e117));
let _e212 = global_4.member[bitcast<u32>(select(0i, _e206, (_e206 > 0i)))];
let _e214 = ((9u * _e112) + _e114);
let _e215 = bitcast<i32>(_e214);
let _e217 = select(_e117, _e215, (_e215 < _e117));
let _e223 = global_4.member[bitcast<u32>(select(0i, _e217, (_e217 > 0i)))];
let _e225 = ((10u * _e112) + _e114);
let _e226 = bitcast<i32>(_e225);
let _e228 = select(_e117, _e226, (_e226 < _e117));
let _e234 = global_4.member[bitcast<u32>(select(0i, _e228, (_e228 > 0i)))];
let _e236 = ((11u * _e112) + _e114);
let _e237 = bitcast<i32>(_e236);
let _e239 = select(_e117, _e237, (_e237 < _e117));
let _e245 = global_4.member[bitcast<u32>(select(0i, _e239, (_e239 > 0i)))];
let _e247 = ((12u * _e112) + _e114);
let _e248 = bitcast<i32>(_e247);
let _e250 = select(_e117, _e248, (_e248 < _e117));
let _e256 = global_4.member[bitcast<u32>(select(0i, _e250, (_e250 > 0i)))];
let _e258 = ((13u * _e112) + _e114);
let _e259 = bitcast<i32>(_e258);
let _e261 = select(_e117, _e259, (_e259 < _e117));
let _e267 = global_4.member[bitcast<u32>(select(0i, _e261, (_e261 > 0i)))];
let _e269 = ((14u * _e112) + _e114);
let _e270 = bitcast<i32>(_e269);
let _e272 = select(_e117, _e270, (_e270 < _e117));
let _e278 = global_4.member[bitcast<u32>(select(0i, _e272, (_e272 > 0i)))];
let _e280 = ((15u * _e112) + _e114);
let _e281 = bitcast<i32>(_e280);
let _e283 = select(_e117, _e281, (_e281 < _e117));
let _e289 = global_4.member[bitcast<u32>(select(0i, _e283, (_e283 > 0i)))];
let _e291 = ((16u * _e112) + _e114);
let _e292 = bitcast<i32>(_e291);
let _e294 = select(_e117, _e292, (_e292 < _e117));
let _e300 = global_4.member[bitcast<u32>(select(0i, _e294, (_e294 > 0i)))];
let _e302 = ((17u * _e112) + _e114);
let _e303 = bitcast<i32>(_e302);
let _e305 = select(_e117, _e303, (_e303 < _e117));
let _e311 = global_4.member[bitcast<u32>(select(0i, _e305, (_e305 > 0i)))];
let _e313 = ((18u * _e112) + _e114);
let _e314 = bitcast<i32>(_e313);
let _e316 = select(_e117, _e314, (_e314 < _e117));
let _e322 = global_4.member[bitcast<u32>(select(0i, _e316, (_e316 > 0i)))];
let _e324 = ((19u * _e112) + _e114);
let _e325 = bitcast<i32>(_e324);
let _e327 = select(_e117, _e325, (_e325 < _e117));
let _e333 = global_4.member[bitcast<u32>(select(0i, _e327, (_e327 > 0i)))];
let _e335 = ((20u * _e112) + _e114);
let _e336 = bitcast<i32>(_e335);
let _e338 = select(_e117, _e336, (_e336 < _e117));
let _e344 = global_4.member[bitcast<u32>(select(0i, _e338, (_e338 > 0i)))];
let _e346 = ((21u * _e112) + _e114);
let _e347 = bitcast<i32>(_e346);
let _e349 = select(_e117, _e347, (_e347 < _e117));
let _e355 = global_4.member[bitcast<u32>(select(0i, _e349, (_e349 > 0i)))];
let _e357 = ((22u * _e112) + _e114);
let _e358 = bitcast<i32>(_e357);
let _e360 = select(_e117, _e358, (_e358 < _e117));
let _e366 = global_4.member[bitcast<u32>(select(0i, _e360, (_e360 > 0i)))];
phi_626_ = 0u;
phi_629_ = false;
phi_631_ = array<f32, 23>(_e125, _e135, _e146, _e157, _e168, _e179, _e190, _e201, _e212, _e223, _e234, _e245, _e256, _e267, _e278, _e289, _e300, _e311, _e322, _e333, _e344, _e355, _e366);
loop {
let _e369 = phi_626_;
let _e371 = phi_629_;
let _e373 = phi_631_;
local_18 = _e371;
local_19 = _e373;
local_20 = _e373;
local_21 = _e373;
local_22 = _e373;
local_23 = _e373;
local_24 = _e373;
local_25 = _e373;
local_26 = _e373;
local_27 = _e373;
local_28 = _e373;
local_29 = _e373;
local_30 = _e373;
local_31 = _e373;
local_32 = _e373;
local_33 = _e373;
local_34 = _e373;
local_35 = _e373;
local_36 = _e373;
local_37 = _e373;
local_38 = _e373;
local_39 = _e373;
local_40 = _e373;
local_41 = _e373;
let _e374 = (_e369 < _e83);
if _e374 {
if _e374 {
} else {
phi_7367_ = true;
break;
}
let _e378 = global_2.member[_e369].member;
let _e393 = global_2.member[_e369].member_7.member;
let _e395 = ((_e393 - _e373[2]) / _e373[5]);
let _e400 = global_2.member[_e369].member_7.member_2;
let _e401 = (_e400 / _e373[5]);
let _e403 = (_e373[0] + (_e373[3] * _e395));
let _e405 = (_e373[1] + (_e373[4] * _e395));
let _e407 = (_e403 + (_e373[3] * _e401));
let _e409 = (_e405 + (_e373[4] * _e401));
let _e414 = global_2.member[_e369].member_7.member_1;
let _e419 = global_2.member[_e369].member_8.member;
let _e430 = ((((_e419.member.member * _e403) + (_e419.member.member_1 * _e405)) + (_e419.member.member_2 * _e393)) + _e419.member_1);
let _e435 = global_2.member[_e369].member_8.member_1;
let _e446 = ((((_e435.member.member * _e403) + (_e435.member.member_1 * _e405)) + (_e435.member.member_2 * _e393)) + _e435.member_1);
let _e451 = global_2.member[_e369].member_8.member_2;
let _e462 = ((((_e451.member.member * _e403) + (_e451.member.member_1 * _e405)) + (_e451.member.member_2 * _e393)) + _e451.member_1);
let _e468 = ((((_e419.member.member * _e407) + (_e419.member.member_1 * _e409)) + (_e419.member.member_2 * _e414)) + _e419.member_1);
let _e474 = ((((_e435.member.member * _e407) + (_e435.member.member_1 * _e409)) + (_e435.member.member_2 * _e414)) + _e435.member_1);
let _e480 = ((((_e451.member.member * _e407) + (_e451.member.member_1 * _e409)) + (_e451.member.member_2 * _e414)) + _e451.member_1);
let _e486 = global_2.member[_e369].member_8.member_4.member;
let _e492 = global_2.member[_e369].member_8.member_5.member;
let _e494 = select(_e486, _e468, (_e468 > _e486));
let _e496 = select(_e492, _e494, (_e494 < _e492));
let _e502 = global_2.member[_e369].member_8.member_4.member_1;
let _e508 = global_2.member[_e369].member_8.member_5.member_1;
let _e510 = select(_e502, _e474, (_e474 > _e502));
let _e512 = select(_e508, _e510, (_e510 < _e508));
let _e518 = global_2.member[_e369].member_8.member_4.member_2;
let _e524 = global_2.member[_e369].member_8.member_5.member_2;
let _e526 = select(_e518, _e480, (_e480 > _e518));
let _e528 = select(_e524, _e526, (_e526 < _e524));
let _e534 = bitcast<f32>((bitcast<u32>((_e468 - _e430)) & 2147483647u));
let _e537 = bitcast<f32>((bitcast<u32>((_e474 - _e446)) & 2147483647u));
let _e539 = select(_e537, _e534, (_e534 > _e537));
let _e542 = bitcast<f32>((bitcast<u32>((_e480 - _e462)) & 2147483647u));
let _e549 = global_2.member[_e369].member_8.member_6;
let _e550 = (select(_e542, _e539, (_e539 > _e542)) <= _e549);
let _e556 = bitcast<f32>((bitcast<u32>((_e468 - _e496)) & 2147483647u));
let _e559 = bitcast<f32>((bitcast<u32>((_e474 - _e512)) & 2147483647u));
let _e561 = select(_e559, _e556, (_e556 > _e559));
let _e564 = bitcast<f32>((bitcast<u32>((_e480 - _e528)) & 2147483647u));
let _e574 = global_2.member[_e369].member_8.member_3.member;
let _e575 = (_e496 + 0.5f);
let _e576 = (_e574 - 1f);
let _e578 = select(0f, _e575, (_e575 > 0f));
let _e580 = select(_e576, _e578, (_e578 < _e576));
let _e587 = select(0i, select(select(i32(_e580), i32(-2147483648), (_e580 < -2147483600f)), 2147483647i, (_e580 > 2147483500f)), (_e580 == _e580));
let _e596 = global_2.member[_e369].member_8.member_14;
let _e597 = (_e596 & 31u);
let _e605 = global_2.member[_e369].member_8.member_3.member_1;
let _e606 = (_e512 + 0.5f);
let _e607 = (_e605 - 1f);
let _e609 = select(0f, _e606, (_e606 > 0f));
let _e611 = select(_e607, _e609, (_e609 < _e607));
let _e618 = select(0i, select(select(i32(_e611), i32(-2147483648), (_e611 < -2147483600f)), 2147483647i, (_e611 > 2147483500f)), (_e611 == _e611));
let _e630 = global_2.member[_e369].member_8.member_3.member_2;
let _e631 = (_e528 + 0.5f);
let _e632 = (_e630 - 1f);
let _e634 = select(0f, _e631, (_e631 > 0f));
let _e636 = select(_e632, _e634, (_e634 < _e632));
let _e643 = select(0i, select(select(i32(_e636), i32(-2147483648), (_e636 < -2147483600f)), 2147483647i, (_e636 > 2147483500f)), (_e636 == _e636));
let _e655 = global_2.member[_e369].member_8.member_11.member;
let _e662 = global_2.member[_e369].member_8.member_11.member_1;
let _e668 = global_2.member[_e369].member_8.member_12;
let _e674 = ((bitcast<i32>(_e668) + ((_e587 - select(0i, 1i, (_e580 < f32(_e587)))) >> bitcast<u32>(_e597))) + (bitcast<i32>(_e655) * (((_e618 - select(0i, 1i, (_e611 < f32(_e618)))) >> bitcast<u32>(_e597)) + (bitcast<i32>(_e662) * ((_e643 - select(0i, 1i, (_e636 < f32(_e643)))) >> bitcast<u32>(_e597))))));
let _e676 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e678 = select(_e676, _e674, (_e674 < _e676));
let _e684 = global_3.member[bitcast<u32>(select(0i, _e678, (_e678 > 0i)))];
let _e685 = bitcast<f32>(_e684);
let _e686 = (_e373[17] == -1.2676506e30f);
let _e687 = (_e378.member_2 == 0u);
if _e687 {
phi_995_ = (_e685 <= _e373[6]);
} else {
phi_995_ = (_e685 >= _e373[6]);
}
let _e691 = phi_995_;
let _e693 = !(_e686);
let _e700 = global_2.member[_e369].member_1;
let _e708 = (_e486 + 0.5f);
let _e710 = (_e492 - 0.5f);
let _e713 = (_e502 + 0.5f);
let _e716 = (_e508 - 0.5f);
let _e719 = (_e518 + 0.5f);
let _e722 = (_e524 - 0.5f);
let _e738 = ((_e700 & 16u) == 0u);
let _e745 = (select(0u, select(select(7u, 3u, (((((((((_e430 >= _e708) && (_e430 <= _e710)) && (_e446 >= _e713)) && (_e446 <= _e716)) && (_e462 >= _e719)) && (_e462 <= _e722)) && ((((((_e468 >= _e708) && (_e468 <= _e710)) && (_e474 >= _e713)) && (_e474 <= _e716)) && (_e480 >= _e719)) && (_e480 <= _e722))) && _e738) && _e693)), 1u, (((_e550 && (select(_e564, _e561, (_e561 > _e564)) > _e549)) || (((((_e378.member_2 != 2u) && _e693) && _e550) && _e691) && ((_e700 & 32u) != 0u))) || ((_e700 & 64u) != 0u))), (_e373[7] == 0f)) > 1u);
if _e745 {
let _e760 = (_e486 - _e430);
let _e761 = (_e486 - _e468);
let _e768 = bitcast<f32>((bitcast<u32>((_e760 - _e761)) & 2147483647u));
let _e771 = (bitcast<f32>((bitcast<u32>(_e760) & 2147483647u)) / select(1e-30f, _e768, (_e768 > 1e-30f)));
let _e773 = select(0f, _e771, (_e771 > 0f));
let _e775 = select(1f, _e773, (_e773 < 1f));
let _e777 = (_e761 > 0f);
let _e779 = select(0f, select(_e775, 2f, _e777), (_e760 > 0f));
let _e782 = select(1f, _e775, (_e777 && (_e760 <= 0f)));
let _e784 = select(_e779, 0f, (0f > _e779));
let _e786 = select(_e782, 1f, (1f < _e782));
let _e787 = (_e430 - _e492);
let _e788 = (_e468 - _e492);
let _e795 = bitcast<f32>((bitcast<u32>((_e787 - _e788)) & 2147483647u));
let _e798 = (bitcast<f32>((bitcast<u32>(_e787) & 2147483647u)) / select(1e-30f, _e795, (_e795 > 1e-30f)));
let _e800 = select(0f, _e798, (_e798 > 0f));
let _e802 = select(1f, _e800, (_e800 < 1f));
let _e804 = (_e788 > 0f);
let _e806 = select(0f, select(_e802, 2f, _e804), (_e787 > 0f));
let _e809 = select(1f, _e802, (_e804 && (_e787 <= 0f)));
let _e811 = select(_e806, _e784, (_e784 > _e806));
let _e813 = select(_e809, _e786, (_e786 < _e809));
let _e814 = (_e502 - _e446);
let _e815 = (_e502 - _e474);
let _e822 = bitcast<f32>((bitcast<u32>((_e814 - _e815)) & 2147483647u));
let _e825 = (bitcast<f32>((bitcast<u32>(_e814) & 2147483647u)) / select(1e-30f, _e822, (_e822 > 1e-30f)));
let _e827 = select(0f, _e825, (_e825 > 0f));
let _e829 = select(1f, _e827, (_e827 < 1f));
let _e831 = (_e815 > 0f);
let _e833 = select(0f, select(_e829, 2f, _e831), (_e814 > 0f));
let _e836 = select(1f, _e829, (_e831 && (_e814 <= 0f)));
let _e838 = select(_e833, _e811, (_e811 > _e833));
let _e840 = select(_e836, _e813, (_e813 < _e836));
let _e841 = (_e446 - _e508);
let _e842 = (_e474 - _e508);
let _e849 = bitcast<f32>((bitcast<u32>((_e841 - _e842)) & 2147483647u));
let _e852 = (bitcast<f32>((bitcast<u32>(_e841) & 2147483647u)) / select(1e-30f, _e849, (_e849 > 1e-30f)));
let _e854 = select(0f, _e852, (_e852 > 0f));
let _e856 = select(1f, _e854, (_e854 < 1f));
let _e858 = (_e842 > 0f);
let _e860 = select(0f, select(_e856, 2f, _e858), (_e841 > 0f));
let _e863 = select(1f, _e856, (_e858 && (_e841 <= 0f)));
let _e865 = select(_e860, _e838, (_e838 > _e860));
let _e867 = select(_e863, _e840, (_e840 < _e863));
let _e868 = (_e518 - _e462);
let _e869 = (_e518 - _e480);
let _e876 = bitcast<f32>((bitcast<u32>((_e868 - _e869)) & 2147483647u));
let _e879 = (bitcast<f32>((bitcast<u32>(_e868) & 2147483647u)) / select(1e-30f, _e876, (_e876 > 1e-30f)));
let _e881 = select(0f, _e879, (_e879 > 0f));
let _e883 = select(1f, _e881, (_e881 < 1f));
let _e885 = (_e869 > 0f);
let _e887 = select(0f, select(_e883, 2f, _e885), (_e868 > 0f));
let _e890 = select(1f, _e883, (_e885 && (_e868 <= 0f)));
let _e892 = select(_e887, _e865, (_e865 > _e887));
let _e894 = select(_e890, _e867, (_e867 < _e890));
let _e895 = (_e462 - _e524);
let _e896 = (_e480 - _e524);
let _e903 = bitcast<f32>((bitcast<u32>((_e895 - _e896)) & 2147483647u));
let _e906 = (bitcast<f32>((bitcast<u32>(_e895) & 2147483647u)) / select(1e-30f, _e903, (_e903 > 1e-30f)));
let _e908 = select(0f, _e906, (_e906 > 0f));
let _e910 = select(1f, _e908, (_e908 < 1f));
let _e912 = (_e896 > 0f);
let _e914 = select(0f, select(_e910, 2f, _e912), (_e895 > 0f));
let _e917 = select(1f, _e910, (_e912 && (_e895 <= 0f)));
let _e919 = select(_e914, _e892, (_e892 > _e914));
let _e921 = select(_e917, _e894, (_e894 < _e917));
if _e738 {
phi_1891_ = type_32(_e919, _e921);
} else {
let _e927 = global_2.member[_e369].member_16.member;
let _e938 = ((((_e927.member.member * _e403) + (_e927.member.member_1 * _e405)) + (_e927.member.member_2 * _e393)) + _e927.member_1);
let _e944 = ((((_e927.member.member * _e407) + (_e927.member.member_1 * _e409)) + (_e927.member.member_2 * _e414)) + _e927.member_1);
let _e951 = bitcast<f32>((bitcast<u32>((_e938 - _e944)) & 2147483647u));
let _e954 = (bitcast<f32>((bitcast<u32>(_e938) & 2147483647u)) / select(1e-30f, _e951, (_e951 > 1e-30f)));
let _e956 = select(0f, _e954, (_e954 > 0f));
let _e958 = select(1f, _e956, (_e956 < 1f));
let _e960 = (_e944 > 0f);
let _e962 = select(0f, select(_e958, 2f, _e960), (_e938 > 0f));
let _e965 = select(1f, _e958, (_e960 && (_e938 <= 0f)));
let _e967 = select(_e962, _e919, (_e919 > _e962));
let _e969 = select(_e965, _e921, (_e921 < _e965));
let _e974 = global_2.member[_e369].member_17.member;
let _e985 = ((((_e974.member.member * _e403) + (_e974.member.member_1 * _e405)) + (_e974.member.member_2 * _e393)) + _e974.member_1);
let _e991 = ((((_e974.member.member * _e407) + (_e974.member.member_1 * _e409)) + (_e974.member.member_2 * _e414)) + _e974.member_1);
let _e998 = bitcast<f32>((bitcast<u32>((_e985 - _e991)) & 2147483647u));
let _e1001 = (bitcast<f32>((bitcast<u32>(_e985) & 2147483647u)) / select(1e-30f, _e998, (_e998 > 1e-30f)));
let _e1003 = select(0f, _e1001, (_e1001 > 0f));
let _e1005 = select(1f, _e1003, (_e1003 < 1f));
let _e1007 = (_e991 > 0f);
let _e1009 = select(0f, select(_e1005, 2f, _e1007), (_e985 > 0f));
let _e1012 = select(1f, _e1005, (_e1007 && (_e985 <= 0f)));
let _e1014 = select(_e1009, _e967, (_e967 > _e1009));
let _e1016 = select(_e1012, _e969, (_e969 < _e1012));
let _e1021 = global_2.member[_e369].member_18.member;
let _e1032 = ((((_e1021.member.member * _e403) + (_e1021.member.member_1 * _e405)) + (_e1021.member.member_2 * _e393)) + _e1021.member_1);
let _e1038 = ((((_e1021.member.member * _e407) + (_e1021.member.member_1 * _e409)) + (_e1021.member.member_2 * _e414)) + _e1021.member_1);
let _e1045 = bitcast<f32>((bitcast<u32>((_e1032 - _e1038)) & 2147483647u));
let _e1048 = (bitcast<f32>((bitcast<u32>(_e1032) & 2147483647u)) / select(1e-30f, _e1045, (_e1045 > 1e-30f)));
let _e1050 = select(0f, _e1048, (_e1048 > 0f));
let _e1052 = select(1f, _e1050, (_e1050 < 1f));
let _e1054 = (_e1038 > 0f);
let _e1056 = select(0f, select(_e1052, 2f, _e1054), (_e1032 > 0f));
let _e1059 = select(1f, _e1052, (_e1054 && (_e1032 <= 0f)));
let _e1061 = select(_e1056, _e1014, (_e1014 > _e1056));
let _e1063 = select(_e1059, _e1016, (_e1016 < _e1059));
let _e1068 = global_2.member[_e369].member_19.member;
let _e1079 = ((((_e1068.member.member * _e403) + (_e1068.member.member_1 * _e405)) + (_e1068.member.member_2 * _e393)) + _e1068.member_1);
let _e1085 = ((((_e1068.member.member * _e407) + (_e1068.member.member_1 * _e409)) + (_e1068.member.member_2 * _e414)) + _e1068.member_1);
let _e1092 = bitcast<f32>((bitcast<u32>((_e1079 - _e1085)) & 2147483647u));
let _e1095 = (bitcast<f32>((bitcast<u32>(_e1079) & 2147483647u)) / select(1e-30f, _e1092, (_e1092 > 1e-30f)));
let _e1097 = select(0f, _e1095, (_e1095 > 0f));
let _e1099 = select(1f, _e1097, (_e1097 < 1f));
let _e1101 = (_e1085 > 0f);
let _e1103 = select(0f, select(_e1099, 2f, _e1101), (_e1079 > 0f));
let _e1106 = select(1f, _e1099, (_e1101 && (_e1079 <= 0f)));
phi_1891_ = type_32(select(_e1103, _e1061, (_e1061 > _e1103)), select(_e1106, _e1063, (_e1063 < _e1106)));
}
let _e1113 = phi_1891_;
let _e1116 = (_e1113.member_1 > _e1113.member);
let _e1117 = (_e407 - _e403);
let _e1118 = (_e409 - _e405);
let _e1119 = (_e414 - _e393);
if (_e378.member_2 == 2u) {
let _e1122 = (_e1113.member_1 - _e1113.member);
let _e1124 = (_e1113.member + (_e1122 * (0.5f * 0.25f)));
let _e1128 = (_e403 + (_e1117 * _e1124));
let _e1129 = (_e405 + (_e1118 * _e1124));
let _e1130 = (_e393 + (_e1119 * _e1124));
let _e1136 = ((((_e419.member.member * _e1128) + (_e419.member.member_1 * _e1129)) + (_e419.member.member_2 * _e1130)) + _e419.member_1);
let _e1142 = ((((_e435.member.member * _e1128) + (_e435.member.member_1 * _e1129)) + (_e435.member.member_2 * _e1130)) + _e435.member_1);
let _e1148 = ((((_e451.member.member * _e1128) + (_e451.member.member_1 * _e1129)) + (_e451.member.member_2 * _e1130)) + _e451.member_1);
let _e1150 = select(_e486, _e1136, (_e1136 > _e486));
let _e1152 = select(_e492, _e1150, (_e1150 < _e492));
let _e1154 = select(_e502, _e1142, (_e1142 > _e502));
let _e1156 = select(_e508, _e1154, (_e1154 < _e508));
let _e1158 = select(_e518, _e1148, (_e1148 > _e518));
let _e1160 = select(_e524, _e1158, (_e1158 < _e524));
let _e1166 = global_2.member[_e369].member_8.member_15;
let _e1167 = (_e1166 == 0u);
if _e1167 {
phi_2112_ = vec3<f32>(_e1152, _e1156, _e1160);
} else {
let _e1168 = (_e1152 + 0.5f);
let _e1170 = select(0f, _e1168, (_e1168 > 0f));
let _e1172 = select(_e576, _e1170, (_e1170 < _e576));
let _e1179 = select(0i, select(select(i32(_e1172), i32(-2147483648), (_e1172 < -2147483600f)), 2147483647i, (_e1172 > 2147483500f)), (_e1172 == _e1172));
let _e1185 = (_e1156 + 0.5f);
let _e1187 = select(0f, _e1185, (_e1185 > 0f));
let _e1189 = select(_e607, _e1187, (_e1187 < _e607));
let _e1196 = select(0i, select(select(i32(_e1189), i32(-2147483648), (_e1189 < -2147483600f)), 2147483647i, (_e1189 > 2147483500f)), (_e1189 == _e1189));
let _e1202 = (_e1160 + 0.5f);
let _e1204 = select(0f, _e1202, (_e1202 > 0f));
let _e1206 = select(_e632, _e1204, (_e1204 < _e632));
let _e1213 = select(0i, select(select(i32(_e1206), i32(-2147483648), (_e1206 < -2147483600f)), 2147483647i, (_e1206 > 2147483500f)), (_e1206 == _e1206));
phi_2112_ = vec3<f32>(f32((_e1179 - select(0i, 1i, (_e1172 < f32(_e1179))))), f32((_e1196 - select(0i, 1i, (_e1189 < f32(_e1196))))), f32((_e1213 - select(0i, 1i, (_e1206 < f32(_e1213))))));
}
let _e1221 = phi_2112_;
let _e1224 = select(-1f, _e1221.x, (_e1221.x > -1f));
let _e1226 = select(_e574, _e1224, (_e1224 < _e574));
let _e1233 = select(0i, select(select(i32(_e1226), i32(-2147483648), (_e1226 < -2147483600f)), 2147483647i, (_e1226 > 2147483500f)), (_e1226 == _e1226));
let _e1237 = (_e1233 - select(0i, 1i, (_e1226 < f32(_e1233))));
let _e1240 = select(-1f, _e1221.y, (_e1221.y > -1f));
let _e1242 = select(_e605, _e1240, (_e1240 < _e605));
let _e1249 = select(0i, select(select(i32(_e1242), i32(-2147483648), (_e1242 < -2147483600f)), 2147483647i, (_e1242 > 2147483500f)), (_e1242 == _e1242));
let _e1253 = (_e1249 - select(0i, 1i, (_e1242 < f32(_e1249))));
let _e1256 = select(-1f, _e1221.z, (_e1221.z > -1f));
let _e1258 = select(_e630, _e1256, (_e1256 < _e630));
let _e1265 = select(0i, select(select(i32(_e1258), i32(-2147483648), (_e1258 < -2147483600f)), 2147483647i, (_e1258 > 2147483500f)), (_e1258 == _e1258));
let _e1269 = (_e1265 - select(0i, 1i, (_e1258 < f32(_e1265))));
let _e1274 = global_2.member[_e369].member_8.member_9;
let _e1279 = global_2.member[_e369].member_8.member_10;
let _e1280 = (_e1237 + 1i);
let _e1281 = (_e1253 + 1i);
let _e1282 = (_e1269 + 1i);
let _e1288 = global_2.member[_e369].member_8.member_13.member;
let _e1289 = bitcast<i32>(_e1288);
let _e1295 = global_2.member[_e369].member_8.member_13.member_1;
let _e1296 = bitcast<i32>(_e1295);
let _e1306 = ((_e1280 >> bitcast<u32>(4i)) + (_e1289 * ((_e1281 >> bitcast<u32>(4i)) + (_e1296 * (_e1282 >> bitcast<u32>(4i))))));
let _e1308 = (bitcast<i32>(_e86) - 1i);
let _e1310 = select(_e1308, _e1306, (_e1306 < _e1308));
let _e1316 = global_1.member[bitcast<u32>(select(0i, _e1310, (_e1310 > 0i)))];
let _e1318 = (_e1280 & 15i);
let _e1321 = ((_e1281 & 15i) * _e1274);
let _e1323 = (bitcast<i32>(_e1316) + ((_e1282 & 15i) * _e1279));
let _e1327 = (_e1321 + _e1274);
let _e1328 = (2i * _e1274);
let _e1329 = (_e1321 + _e1328);
let _e1330 = (_e1323 + _e1279);
let _e1331 = (2i * _e1279);
let _e1332 = (_e1323 + _e1331);
local_16 = type_29(array<i32, 4>(_e1318, (_e1318 + 1i), (_e1318 + 2i), (_e1318 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_17 = (_e1221 - vec3<f32>(f32(_e1237), f32(_e1253), f32(_e1269)));
let _e1341 = (_e1330 + _e1327);
let _e1344 = local_16.member[1u];
let _e1345 = (_e1341 + _e1344);
let _e1347 = select(_e1308, _e1345, (_e1345 < _e1308));
let _e1352 = global_1.member[bitcast<u32>(select(0i, _e1347, (_e1347 > 0i)))];
let _e1353 = bitcast<f32>(_e1352);
let _e1356 = local_16.member[2u];
let _e1357 = (_e1341 + _e1356);
let _e1359 = select(_e1308, _e1357, (_e1357 < _e1308));
let _e1364 = global_1.member[bitcast<u32>(select(0i, _e1359, (_e1359 > 0i)))];
let _e1366 = local_17[0u];
let _e1369 = (_e1353 + ((bitcast<f32>(_e1364) - _e1353) * _e1366));
let _e1370 = (_e1330 + _e1329);
let _e1371 = local_16.member[1u];
let _e1372 = (_e1370 + _e1371);
let _e1374 = select(_e1308, _e1372, (_e1372 < _e1308));
let _e1379 = global_1.member[bitcast<u32>(select(0i, _e1374, (_e1374 > 0i)))];
let _e1380 = bitcast<f32>(_e1379);
let _e1381 = local_16.member[2u];
let _e1382 = (_e1370 + _e1381);
let _e1384 = select(_e1308, _e1382, (_e1382 < _e1308));
let _e1389 = global_1.member[bitcast<u32>(select(0i, _e1384, (_e1384 > 0i)))];
let _e1391 = local_17[0u];
let _e1396 = local_17[1u];
let _e1399 = (_e1369 + (((_e1380 + ((bitcast<f32>(_e1389) - _e1380) * _e1391)) - _e1369) * _e1396));
let _e1400 = (_e1332 + _e1327);
let _e1401 = local_16.member[1u];
let _e1402 = (_e1400 + _e1401);
let _e1404 = select(_e1308, _e1402, (_e1402 < _e1308));
let _e1409 = global_1.member[bitcast<u32>(select(0i, _e1404, (_e1404 > 0i)))];
let _e1410 = bitcast<f32>(_e1409);
let _e1411 = local_16.member[2u];
let _e1412 = (_e1400 + _e1411);
let _e1414 = select(_e1308, _e1412, (_e1412 < _e1308));
let _e1419 = global_1.member[bitcast<u32>(select(0i, _e1414, (_e1414 > 0i)))];
let _e1421 = local_17[0u];
let _e1424 = (_e1410 + ((bitcast<f32>(_e1419) - _e1410) * _e1421));
let _e1425 = (_e1332 + _e1329);
let _e1426 = local_16.member[1u];
let _e1427 = (_e1425 + _e1426);
let _e1429 = select(_e1308, _e1427, (_e1427 < _e1308));
let _e1434 = global_1.member[bitcast<u32>(select(0i, _e1429, (_e1429 > 0i)))];
let _e1435 = bitcast<f32>(_e1434);
let _e1436 = local_16.member[2u];
let _e1437 = (_e1425 + _e1436);
let _e1439 = select(_e1308, _e1437, (_e1437 < _e1308));
let _e1444 = global_1.member[bitcast<u32>(select(0i, _e1439, (_e1439 > 0i)))];
let _e1446 = local_17[0u];
let _e1450 = local_17[1u];
let _e1455 = local_17[2u];
let _e1463 = global_2.member[_e369].member_8.member_8;
let _e1468 = global_2.member[_e369].member_8.member_7;
let _e1470 = (((_e1399 + (((_e1424 + (((_e1435 + ((bitcast<f32>(_e1444) - _e1435) * _e1446)) - _e1424) * _e1450)) - _e1399) * _e1455)) - _e1463) * _e1468);
let _e1471 = -(1e9f);
let _e1473 = select(_e1471, _e1470, (_e1470 > _e1471));
let _e1478 = (_e1113.member + (_e1122 * (1.5f * 0.25f)));
let _e1482 = (_e403 + (_e1117 * _e1478));
let _e1483 = (_e405 + (_e1118 * _e1478));
let _e1484 = (_e393 + (_e1119 * _e1478));
let _e1490 = ((((_e419.member.member * _e1482) + (_e419.member.member_1 * _e1483)) + (_e419.member.member_2 * _e1484)) + _e419.member_1);
let _e1496 = ((((_e435.member.member * _e1482) + (_e435.member.member_1 * _e1483)) + (_e435.member.member_2 * _e1484)) + _e435.member_1);
let _e1502 = ((((_e451.member.member * _e1482) + (_e451.member.member_1 * _e1483)) + (_e451.member.member_2 * _e1484)) + _e451.member_1);
let _e1504 = select(_e486, _e1490, (_e1490 > _e486));
let _e1506 = select(_e492, _e1504, (_e1504 < _e492));
let _e1508 = select(_e502, _e1496, (_e1496 > _e502));
let _e1510 = select(_e508, _e1508, (_e1508 < _e508));
let _e1512 = select(_e518, _e1502, (_e1502 > _e518));
let _e1514 = select(_e524, _e1512, (_e1512 < _e524));
if _e1167 {
phi_2692_ = vec3<f32>(_e1506, _e1510, _e1514);
} else {
let _e1516 = (_e1506 + 0.5f);
let _e1518 = select(0f, _e1516, (_e1516 > 0f));
let _e1520 = select(_e576, _e1518, (_e1518 < _e576));
let _e1527 = select(0i, select(select(i32(_e1520), i32(-2147483648), (_e1520 < -2147483600f)), 2147483647i, (_e1520 > 2147483500f)), (_e1520 == _e1520));
let _e1533 = (_e1510 + 0.5f);
let _e1535 = select(0f, _e1533, (_e1533 > 0f));
let _e1537 = select(_e607, _e1535, (_e1535 < _e607));
let _e1544 = select(0i, select(select(i32(_e1537), i32(-2147483648), (_e1537 < -2147483600f)), 2147483647i, (_e1537 > 2147483500f)), (_e1537 == _e1537));
let _e1550 = (_e1514 + 0.5f);
let _e1552 = select(0f, _e1550, (_e1550 > 0f));
let _e1554 = select(_e632, _e1552, (_e1552 < _e632));
let _e1561 = select(0i, select(select(i32(_e1554), i32(-2147483648), (_e1554 < -2147483600f)), 2147483647i, (_e1554 > 2147483500f)), (_e1554 == _e1554));
phi_2692_ = vec3<f32>(f32((_e1527 - select(0i, 1i, (_e1520 < f32(_e1527))))), f32((_e1544 - select(0i, 1i, (_e1537 < f32(_e1544))))), f32((_e1561 - select(0i, 1i, (_e1554 < f32(_e1561))))));
}
let _e1569 = phi_2692_;
let _e1572 = select(-1f, _e1569.x, (_e1569.x > -1f));
let _e1574 = select(_e574, _e1572, (_e1572 < _e574));
let _e1581 = select(0i, select(select(i32(_e1574), i32(-2147483648), (_e1574 < -2147483600f)), 2147483647i, (_e1574 > 2147483500f)), (_e1574 == _e1574));
let _e1585 = (_e1581 - select(0i, 1i, (_e1574 < f32(_e1581))));
let _e1588 = select(-1f, _e1569.y, (_e1569.y > -1f));
let _e1590 = select(_e605, _e1588, (_e1588 < _e605));
let _e1597 = select(0i, select(select(i32(_e1590), i32(-2147483648), (_e1590 < -2147483600f)), 2147483647i, (_e1590 > 2147483500f)), (_e1590 == _e1590));
let _e1601 = (_e1597 - select(0i, 1i, (_e1590 < f32(_e1597))));
let _e1604 = select(-1f, _e1569.z, (_e1569.z > -1f));
let _e1606 = select(_e630, _e1604, (_e1604 < _e630));
let _e1613 = select(0i, select(select(i32(_e1606), i32(-2147483648), (_e1606 < -2147483600f)), 2147483647i, (_e1606 > 2147483500f)), (_e1606 == _e1606));
let _e1617 = (_e1613 - select(0i, 1i, (_e1606 < f32(_e1613))));
let _e1618 = (_e1585 + 1i);
let _e1619 = (_e1601 + 1i);
let _e1620 = (_e1617 + 1i);
let _e1630 = ((_e1618 >> bitcast<u32>(4i)) + (_e1289 * ((_e1619 >> bitcast<u32>(4i)) + (_e1296 * (_e1620 >> bitcast<u32>(4i))))));
let _e1632 = select(_e1308, _e1630, (_e1630 < _e1308));
let _e1638 = global_1.member[bitcast<u32>(select(0i, _e1632, (_e1632 > 0i)))];
let _e1640 = (_e1618 & 15i);
let _e1643 = ((_e1619 & 15i) * _e1274);
let _e1645 = (bitcast<i32>(_e1638) + ((_e1620 & 15i) * _e1279));
let _e1649 = (_e1643 + _e1274);
let _e1650 = (_e1643 + _e1328);
let _e1651 = (_e1645 + _e1279);
let _e1652 = (_e1645 + _e1331);
local_14 = type_29(array<i32, 4>(_e1640, (_e1640 + 1i), (_e1640 + 2i), (_e1640 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_15 = (_e1569 - vec3<f32>(f32(_e1585), f32(_e1601), f32(_e1617)));
let _e1661 = (_e1651 + _e1649);
let _e1664 = local_14.member[1u];
let _e1665 = (_e1661 + _e1664);
let _e1667 = select(_e1308, _e1665, (_e1665 < _e1308));
let _e1672 = global_1.member[bitcast<u32>(select(0i, _e1667, (_e1667 > 0i)))];
let _e1673 = bitcast<f32>(_e1672);
let _e1676 = local_14.member[2u];
let _e1677 = (_e1661 + _e1676);
let _e1679 = select(_e1308, _e1677, (_e1677 < _e1308));
let _e1684 = global_1.member[bitcast<u32>(select(0i, _e1679, (_e1679 > 0i)))];
let _e1686 = local_15[0u];
let _e1689 = (_e1673 + ((bitcast<f32>(_e1684) - _e1673) * _e1686));
let _e1690 = (_e1651 + _e1650);
let _e1691 = local_14.member[1u];
let _e1692 = (_e1690 + _e1691);
let _e1694 = select(_e1308, _e1692, (_e1692 < _e1308));
let _e1699 = global_1.member[bitcast<u32>(select(0i, _e1694, (_e1694 > 0i)))];
let _e1700 = bitcast<f32>(_e1699);
let _e1701 = local_14.member[2u];
let _e1702 = (_e1690 + _e1701);
let _e1704 = select(_e1308, _e1702, (_e1702 < _e1308));
let _e1709 = global_1.member[bitcast<u32>(select(0i, _e1704, (_e1704 > 0i)))];
let _e1711 = local_15[0u];
let _e1716 = local_15[1u];
let _e1719 = (_e1689 + (((_e1700 + ((bitcast<f32>(_e1709) - _e1700) * _e1711)) - _e1689) * _e1716));
let _e1720 = (_e1652 + _e1649);
let _e1721 = local_14.member[1u];
let _e1722 = (_e1720 + _e1721);
let _e1724 = select(_e1308, _e1722, (_e1722 < _e1308));
let _e1729 = global_1.member[bitcast<u32>(select(0i, _e1724, (_e1724 > 0i)))];
let _e1730 = bitcast<f32>(_e1729);
let _e1731 = local_14.member[2u];
let _e1732 = (_e1720 + _e1731);
let _e1734 = select(_e1308, _e1732, (_e1732 < _e1308));
let _e1739 = global_1.member[bitcast<u32>(select(0i, _e1734, (_e1734 > 0i)))];
let _e1741 = local_15[0u];
let _e1744 = (_e1730 + ((bitcast<f32>(_e1739) - _e1730) * _e1741));
let _e1745 = (_e1652 + _e1650);
let _e1746 = local_14.member[1u];
let _e1747 = (_e1745 + _e1746);
let _e1749 = select(_e1308, _e1747, (_e1747 < _e1308));
let _e1754 = global_1.member[bitcast<u32>(select(0i, _e1749, (_e1749 > 0i)))];
let _e1755 = bitcast<f32>(_e1754);
let _e1756 = local_14.member[2u];
let _e1757 = (_e1745 + _e1756);
let _e1759 = select(_e1308, _e1757, (_e1757 < _e1308));
let _e1764 = global_1.member[bitcast<u32>(select(0i, _e1759, (_e1759 > 0i)))];
let _e1766 = local_15[0u];
let _e1770 = local_15[1u];
let _e1775 = local_15[2u];
let _e1780 = (((_e1719 + (((_e1744 + (((_e1755 + ((bitcast<f32>(_e1764) - _e1755) * _e1766)) - _e1744) * _e1770)) - _e1719) * _e1775)) - _e1463) * _e1468);
let _e1782 = select(_e1471, _e1780, (_e1780 > _e1471));
let _e1787 = (_e1113.member + (_e1122 * (2.5f * 0.25f)));
let _e1791 = (_e403 + (_e1117 * _e1787));
let _e1792 = (_e405 + (_e1118 * _e1787));
let _e1793 = (_e393 + (_e1119 * _e1787));
let _e1799 = ((((_e419.member.member * _e1791) + (_e419.member.member_1 * _e1792)) + (_e419.member.member_2 * _e1793)) + _e419.member_1);
let _e1805 = ((((_e435.member.member * _e1791) + (_e435.member.member_1 * _e1792)) + (_e435.member.member_2 * _e1793)) + _e435.member_1);
let _e1811 = ((((_e451.member.member * _e1791) + (_e451.member.member_1 * _e1792)) + (_e451.member.member_2 * _e1793)) + _e451.member_1);
let _e1813 = select(_e486, _e1799, (_e1799 > _e486));
let _e1815 = select(_e492, _e1813, (_e1813 < _e492));
let _e1817 = select(_e502, _e1805, (_e1805 > _e502));
let _e1819 = select(_e508, _e1817, (_e1817 < _e508));
let _e1821 = select(_e518, _e1811, (_e1811 > _e518));
let _e1823 = select(_e524, _e1821, (_e1821 < _e524));
if _e1167 {
phi_3272_ = vec3<f32>(_e1815, _e1819, _e1823);
} else {
let _e1825 = (_e1815 + 0.5f);
let _e1827 = select(0f, _e1825, (_e1825 > 0f));
let _e1829 = select(_e576, _e1827, (_e1827 < _e576));
let _e1836 = select(0i, select(select(i32(_e1829), i32(-2147483648), (_e1829 < -2147483600f)), 2147483647i, (_e1829 > 2147483500f)), (_e1829 == _e1829));
let _e1842 = (_e1819 + 0.5f);
let _e1844 = select(0f, _e1842, (_e1842 > 0f));
let _e1846 = select(_e607, _e1844, (_e1844 < _e607));
let _e1853 = select(0i, select(select(i32(_e1846), i32(-2147483648), (_e1846 < -2147483600f)), 2147483647i, (_e1846 > 2147483500f)), (_e1846 == _e1846));
let _e1859 = (_e1823 + 0.5f);
let _e1861 = select(0f, _e1859, (_e1859 > 0f));
let _e1863 = select(_e632, _e1861, (_e1861 < _e632));
let _e1870 = select(0i, select(select(i32(_e1863), i32(-2147483648), (_e1863 < -2147483600f)), 2147483647i, (_e1863 > 2147483500f)), (_e1863 == _e1863));
phi_3272_ = vec3<f32>(f32((_e1836 - select(0i, 1i, (_e1829 < f32(_e1836))))), f32((_e1853 - select(0i, 1i, (_e1846 < f32(_e1853))))), f32((_e1870 - select(0i, 1i, (_e1863 < f32(_e1870))))));
}
let _e1878 = phi_3272_;
let _e1881 = select(-1f, _e1878.x, (_e1878.x > -1f));
let _e1883 = select(_e574, _e1881, (_e1881 < _e574));
let _e1890 = select(0i, select(select(i32(_e1883), i32(-2147483648), (_e1883 < -2147483600f)), 2147483647i, (_e1883 > 2147483500f)), (_e1883 == _e1883));
let _e1894 = (_e1890 - select(0i, 1i, (_e1883 < f32(_e1890))));
let _e1897 = select(-1f, _e1878.y, (_e1878.y > -1f));
let _e1899 = select(_e605, _e1897, (_e1897 < _e605));
let _e1906 = select(0i, select(select(i32(_e1899), i32(-2147483648), (_e1899 < -2147483600f)), 2147483647i, (_e1899 > 2147483500f)), (_e1899 == _e1899));
let _e1910 = (_e1906 - select(0i, 1i, (_e1899 < f32(_e1906))));
let _e1913 = select(-1f, _e1878.z, (_e1878.z > -1f));
let _e1915 = select(_e630, _e1913, (_e1913 < _e630));
let _e1922 = select(0i, select(select(i32(_e1915), i32(-2147483648), (_e1915 < -2147483600f)), 2147483647i, (_e1915 > 2147483500f)), (_e1915 == _e1915));
let _e1926 = (_e1922 - select(0i, 1i, (_e1915 < f32(_e1922))));
let _e1927 = (_e1894 + 1i);
let _e1928 = (_e1910 + 1i);
let _e1929 = (_e1926 + 1i);
let _e1939 = ((_e1927 >> bitcast<u32>(4i)) + (_e1289 * ((_e1928 >> bitcast<u32>(4i)) + (_e1296 * (_e1929 >> bitcast<u32>(4i))))));
let _e1941 = select(_e1308, _e1939, (_e1939 < _e1308));
let _e1947 = global_1.member[bitcast<u32>(select(0i, _e1941, (_e1941 > 0i)))];
let _e1949 = (_e1927 & 15i);
let _e1952 = ((_e1928 & 15i) * _e1274);
let _e1954 = (bitcast<i32>(_e1947) + ((_e1929 & 15i) * _e1279));
let _e1958 = (_e1952 + _e1274);
let _e1959 = (_e1952 + _e1328);
let _e1960 = (_e1954 + _e1279);
let _e1961 = (_e1954 + _e1331);
local_12 = type_29(array<i32, 4>(_e1949, (_e1949 + 1i), (_e1949 + 2i), (_e1949 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_13 = (_e1878 - vec3<f32>(f32(_e1894), f32(_e1910), f32(_e1926)));
let _e1970 = (_e1960 + _e1958);
let _e1973 = local_12.member[1u];
let _e1974 = (_e1970 + _e1973);
let _e1976 = select(_e1308, _e1974, (_e1974 < _e1308));
let _e1981 = global_1.member[bitcast<u32>(select(0i, _e1976, (_e1976 > 0i)))];
let _e1982 = bitcast<f32>(_e1981);
let _e1985 = local_12.member[2u];
let _e1986 = (_e1970 + _e1985);
let _e1988 = select(_e1308, _e1986, (_e1986 < _e1308));
let _e1993 = global_1.member[bitcast<u32>(select(0i, _e1988, (_e1988 > 0i)))];
let _e1995 = local_13[0u];
let _e1998 = (_e1982 + ((bitcast<f32>(_e1993) - _e1982) * _e1995));
let _e1999 = (_e1960 + _e1959);
let _e2000 = local_12.member[1u];
let _e2001 = (_e1999 + _e2000);
let _e2003 = select(_e1308, _e2001, (_e2001 < _e1308));
let _e2008 = global_1.member[bitcast<u32>(select(0i, _e2003, (_e2003 > 0i)))];
let _e2009 = bitcast<f32>(_e2008);
let _e2010 = local_12.member[2u];
let _e2011 = (_e1999 + _e2010);
let _e2013 = select(_e1308, _e2011, (_e2011 < _e1308));
let _e2018 = global_1.member[bitcast<u32>(select(0i, _e2013, (_e2013 > 0i)))];
let _e2020 = local_13[0u];
let _e2025 = local_13[1u];
let _e2028 = (_e1998 + (((_e2009 + ((bitcast<f32>(_e2018) - _e2009) * _e2020)) - _e1998) * _e2025));
let _e2029 = (_e1961 + _e1958);
let _e2030 = local_12.member[1u];
let _e2031 = (_e2029 + _e2030);
let _e2033 = select(_e1308, _e2031, (_e2031 < _e1308));
let _e2038 = global_1.member[bitcast<u32>(select(0i, _e2033, (_e2033 > 0i)))];
let _e2039 = bitcast<f32>(_e2038);
let _e2040 = local_12.member[2u];
let _e2041 = (_e2029 + _e2040);
let _e2043 = select(_e1308, _e2041, (_e2041 < _e1308));
let _e2048 = global_1.member[bitcast<u32>(select(0i, _e2043, (_e2043 > 0i)))];
let _e2050 = local_13[0u];
let _e2053 = (_e2039 + ((bitcast<f32>(_e2048) - _e2039) * _e2050));
let _e2054 = (_e1961 + _e1959);
let _e2055 = local_12.member[1u];
let _e2056 = (_e2054 + _e2055);
let _e2058 = select(_e1308, _e2056, (_e2056 < _e1308));
let _e2063 = global_1.member[bitcast<u32>(select(0i, _e2058, (_e2058 > 0i)))];
let _e2064 = bitcast<f32>(_e2063);
let _e2065 = local_12.member[2u];
let _e2066 = (_e2054 + _e2065);
let _e2068 = select(_e1308, _e2066, (_e2066 < _e1308));
let _e2073 = global_1.member[bitcast<u32>(select(0i, _e2068, (_e2068 > 0i)))];
let _e2075 = local_13[0u];
let _e2079 = local_13[1u];
let _e2084 = local_13[2u];
let _e2089 = (((_e2028 + (((_e2053 + (((_e2064 + ((bitcast<f32>(_e2073) - _e2064) * _e2075)) - _e2053) * _e2079)) - _e2028) * _e2084)) - _e1463) * _e1468);
let _e2091 = select(_e1471, _e2089, (_e2089 > _e1471));
let _e2096 = (_e1113.member + (_e1122 * (3.5f * 0.25f)));
let _e2100 = (_e403 + (_e1117 * _e2096));
let _e2101 = (_e405 + (_e1118 * _e2096));
let _e2102 = (_e393 + (_e1119 * _e2096));
let _e2108 = ((((_e419.member.member * _e2100) + (_e419.member.member_1 * _e2101)) + (_e419.member.member_2 * _e2102)) + _e419.member_1);
let _e2114 = ((((_e435.member.member * _e2100) + (_e435.member.member_1 * _e2101)) + (_e435.member.member_2 * _e2102)) + _e435.member_1);
let _e2120 = ((((_e451.member.member * _e2100) + (_e451.member.member_1 * _e2101)) + (_e451.member.member_2 * _e2102)) + _e451.member_1);
let _e2122 = select(_e486, _e2108, (_e2108 > _e486));
let _e2124 = select(_e492, _e2122, (_e2122 < _e492));
let _e2126 = select(_e502, _e2114, (_e2114 > _e502));
let _e2128 = select(_e508, _e2126, (_e2126 < _e508));
let _e2130 = select(_e518, _e2120, (_e2120 > _e518));
let _e2132 = select(_e524, _e2130, (_e2130 < _e524));
if _e1167 {
phi_3852_ = vec3<f32>(_e2124, _e2128, _e2132);
} else {
let _e2134 = (_e2124 + 0.5f);
let _e2136 = select(0f, _e2134, (_e2134 > 0f));
let _e2138 = select(_e576, _e2136, (_e2136 < _e576));
let _e2145 = select(0i, select(select(i32(_e2138), i32(-2147483648), (_e2138 < -2147483600f)), 2147483647i, (_e2138 > 2147483500f)), (_e2138 == _e2138));
let _e2151 = (_e2128 + 0.5f);
let _e2153 = select(0f, _e2151, (_e2151 > 0f));
let _e2155 = select(_e607, _e2153, (_e2153 < _e607));
let _e2162 = select(0i, select(select(i32(_e2155), i32(-2147483648), (_e2155 < -2147483600f)), 2147483647i, (_e2155 > 2147483500f)), (_e2155 == _e2155));
let _e2168 = (_e2132 + 0.5f);
let _e2170 = select(0f, _e2168, (_e2168 > 0f));
let _e2172 = select(_e632, _e2170, (_e2170 < _e632));
let _e2179 = select(0i, select(select(i32(_e2172), i32(-2147483648), (_e2172 < -2147483600f)), 2147483647i, (_e2172 > 2147483500f)), (_e2172 == _e2172));
phi_3852_ = vec3<f32>(f32((_e2145 - select(0i, 1i, (_e2138 < f32(_e2145))))), f32((_e2162 - select(0i, 1i, (_e2155 < f32(_e2162))))), f32((_e2179 - select(0i, 1i, (_e2172 < f32(_e2179))))));
}
let _e2187 = phi_3852_;
let _e2190 = select(-1f, _e2187.x, (_e2187.x > -1f));
let _e2192 = select(_e574, _e2190, (_e2190 < _e574));
let _e2199 = select(0i, select(select(i32(_e2192), i32(-2147483648), (_e2192 < -2147483600f)), 2147483647i, (_e2192 > 2147483500f)), (_e2192 == _e2192));
let _e2203 = (_e2199 - select(0i, 1i, (_e2192 < f32(_e2199))));
let _e2206 = select(-1f, _e2187.y, (_e2187.y > -1f));
let _e2208 = select(_e605, _e2206, (_e2206 < _e605));
let _e2215 = select(0i, select(select(i32(_e2208), i32(-2147483648), (_e2208 < -2147483600f)), 2147483647i, (_e2208 > 2147483500f)), (_e2208 == _e2208));
let _e2219 = (_e2215 - select(0i, 1i, (_e2208 < f32(_e2215))));
let _e2222 = select(-1f, _e2187.z, (_e2187.z > -1f));
let _e2224 = select(_e630, _e2222, (_e2222 < _e630));
let _e2231 = select(0i, select(select(i32(_e2224), i32(-2147483648), (_e2224 < -2147483600f)), 2147483647i, (_e2224 > 2147483500f)), (_e2224 == _e2224));
let _e2235 = (_e2231 - select(0i, 1i, (_e2224 < f32(_e2231))));
let _e2236 = (_e2203 + 1i);
let _e2237 = (_e2219 + 1i);
let _e2238 = (_e2235 + 1i);
let _e2248 = ((_e2236 >> bitcast<u32>(4i)) + (_e1289 * ((_e2237 >> bitcast<u32>(4i)) + (_e1296 * (_e2238 >> bitcast<u32>(4i))))));
let _e2250 = select(_e1308, _e2248, (_e2248 < _e1308));
let _e2256 = global_1.member[bitcast<u32>(select(0i, _e2250, (_e2250 > 0i)))];
let _e2258 = (_e2236 & 15i);
let _e2261 = ((_e2237 & 15i) * _e1274);
let _e2263 = (bitcast<i32>(_e2256) + ((_e2238 & 15i) * _e1279));
let _e2267 = (_e2261 + _e1274);
let _e2268 = (_e2261 + _e1328);
let _e2269 = (_e2263 + _e1279);
let _e2270 = (_e2263 + _e1331);
local_10 = type_29(array<i32, 4>(_e2258, (_e2258 + 1i), (_e2258 + 2i), (_e2258 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_11 = (_e2187 - vec3<f32>(f32(_e2203), f32(_e2219), f32(_e2235)));
let _e2279 = (_e2269 + _e2267);
let _e2282 = local_10.member[1u];
let _e2283 = (_e2279 + _e2282);
let _e2285 = select(_e1308, _e2283, (_e2283 < _e1308));
let _e2290 = global_1.member[bitcast<u32>(select(0i, _e2285, (_e2285 > 0i)))];
let _e2291 = bitcast<f32>(_e2290);
let _e2294 = local_10.member[2u];
let _e2295 = (_e2279 + _e2294);
let _e2297 = select(_e1308, _e2295, (_e2295 < _e1308));
let _e2302 = global_1.member[bitcast<u32>(select(0i, _e2297, (_e2297 > 0i)))];
let _e2304 = local_11[0u];
let _e2307 = (_e2291 + ((bitcast<f32>(_e2302) - _e2291) * _e2304));
let _e2308 = (_e2269 + _e2268);
let _e2309 = local_10.member[1u];
let _e2310 = (_e2308 + _e2309);
let _e2312 = select(_e1308, _e2310, (_e2310 < _e1308));
let _e2317 = global_1.member[bitcast<u32>(select(0i, _e2312, (_e2312 > 0i)))];
let _e2318 = bitcast<f32>(_e2317);
let _e2319 = local_10.member[2u];
let _e2320 = (_e2308 + _e2319);
let _e2322 = select(_e1308, _e2320, (_e2320 < _e1308));
let _e2327 = global_1.member[bitcast<u32>(select(0i, _e2322, (_e2322 > 0i)))];
let _e2329 = local_11[0u];
let _e2334 = local_11[1u];
let _e2337 = (_e2307 + (((_e2318 + ((bitcast<f32>(_e2327) - _e2318) * _e2329)) - _e2307) * _e2334));
let _e2338 = (_e2270 + _e2267);
let _e2339 = local_10.member[1u];
let _e2340 = (_e2338 + _e2339);
let _e2342 = select(_e1308, _e2340, (_e2340 < _e1308));
let _e2347 = global_1.member[bitcast<u32>(select(0i, _e2342, (_e2342 > 0i)))];
let _e2348 = bitcast<f32>(_e2347);
let _e2349 = local_10.member[2u];
let _e2350 = (_e2338 + _e2349);
let _e2352 = select(_e1308, _e2350, (_e2350 < _e1308));
let _e2357 = global_1.member[bitcast<u32>(select(0i, _e2352, (_e2352 > 0i)))];
let _e2359 = local_11[0u];
let _e2362 = (_e2348 + ((bitcast<f32>(_e2357) - _e2348) * _e2359));
let _e2363 = (_e2270 + _e2268);
let _e2364 = local_10.member[1u];
let _e2365 = (_e2363 + _e2364);
let _e2367 = select(_e1308, _e2365, (_e2365 < _e1308));
let _e2372 = global_1.member[bitcast<u32>(select(0i, _e2367, (_e2367 > 0i)))];
let _e2373 = bitcast<f32>(_e2372);
let _e2374 = local_10.member[2u];
let _e2375 = (_e2363 + _e2374);
let _e2377 = select(_e1308, _e2375, (_e2375 < _e1308));
let _e2382 = global_1.member[bitcast<u32>(select(0i, _e2377, (_e2377 > 0i)))];
let _e2384 = local_11[0u];
let _e2388 = local_11[1u];
let _e2393 = local_11[2u];
let _e2398 = (((_e2337 + (((_e2362 + (((_e2373 + ((bitcast<f32>(_e2382) - _e2373) * _e2384)) - _e2362) * _e2388)) - _e2337) * _e2393)) - _e1463) * _e1468);
let _e2400 = select(_e1471, _e2398, (_e2398 > _e1471));
let _e2407 = (((_e1117 * _e1117) + (_e1118 * _e1118)) + (_e1119 * _e1119));
let _e2412 = select(0f, (sqrt(select(0f, _e2407, (_e2407 > 0f))) * _e1122), _e1116);
phi_7245_ = (_e373[8] + _e2412);
phi_7246_ = (_e373[6] + ((((select(1e9f, _e1473, (_e1473 < 1e9f)) + select(1e9f, _e1782, (_e1782 < 1e9f))) + (select(1e9f, _e2091, (_e2091 < 1e9f)) + select(1e9f, _e2400, (_e2400 < 1e9f)))) * 0.25f) * _e2412));
} else {
if _e687 {
phi_4260_ = -(2e9f);
} else {
phi_4260_ = 2e9f;
}
let _e2422 = phi_4260_;
let _e2423 = select(_e373[6], _e2422, _e686);
let _e2424 = (_e1113.member_1 - _e1113.member);
let _e2426 = (_e1113.member + (_e2424 * 0f));
let _e2430 = (_e403 + (_e1117 * _e2426));
let _e2431 = (_e405 + (_e1118 * _e2426));
let _e2432 = (_e393 + (_e1119 * _e2426));
let _e2438 = ((((_e419.member.member * _e2430) + (_e419.member.member_1 * _e2431)) + (_e419.member.member_2 * _e2432)) + _e419.member_1);
let _e2444 = ((((_e435.member.member * _e2430) + (_e435.member.member_1 * _e2431)) + (_e435.member.member_2 * _e2432)) + _e435.member_1);
let _e2450 = ((((_e451.member.member * _e2430) + (_e451.member.member_1 * _e2431)) + (_e451.member.member_2 * _e2432)) + _e451.member_1);
let _e2452 = select(_e486, _e2438, (_e2438 > _e486));
let _e2454 = select(_e492, _e2452, (_e2452 < _e492));
let _e2456 = select(_e502, _e2444, (_e2444 > _e502));
let _e2458 = select(_e508, _e2456, (_e2456 < _e508));
let _e2460 = select(_e518, _e2450, (_e2450 > _e518));
let _e2462 = select(_e524, _e2460, (_e2460 < _e524));
let _e2468 = global_2.member[_e369].member_8.member_15;
let _e2469 = (_e2468 == 0u);
if _e2469 {
phi_4468_ = vec3<f32>(_e2454, _e2458, _e2462);
} else {
let _e2470 = (_e2454 + 0.5f);
let _e2472 = select(0f, _e2470, (_e2470 > 0f));
let _e2474 = select(_e576, _e2472, (_e2472 < _e576));
let _e2481 = select(0i, select(select(i32(_e2474), i32(-2147483648), (_e2474 < -2147483600f)), 2147483647i, (_e2474 > 2147483500f)), (_e2474 == _e2474));
let _e2487 = (_e2458 + 0.5f);
let _e2489 = select(0f, _e2487, (_e2487 > 0f));
let _e2491 = select(_e607, _e2489, (_e2489 < _e607));
let _e2498 = select(0i, select(select(i32(_e2491), i32(-2147483648), (_e2491 < -2147483600f)), 2147483647i, (_e2491 > 2147483500f)), (_e2491 == _e2491));
let _e2504 = (_e2462 + 0.5f);
let _e2506 = select(0f, _e2504, (_e2504 > 0f));
let _e2508 = select(_e632, _e2506, (_e2506 < _e632));
let _e2515 = select(0i, select(select(i32(_e2508), i32(-2147483648), (_e2508 < -2147483600f)), 2147483647i, (_e2508 > 2147483500f)), (_e2508 == _e2508));
phi_4468_ = vec3<f32>(f32((_e2481 - select(0i, 1i, (_e2474 < f32(_e2481))))), f32((_e2498 - select(0i, 1i, (_e2491 < f32(_e2498))))), f32((_e2515 - select(0i, 1i, (_e2508 < f32(_e2515))))));
}
let _e2523 = phi_4468_;
let _e2526 = select(-1f, _e2523.x, (_e2523.x > -1f));
let _e2528 = select(_e574, _e2526, (_e2526 < _e574));
let _e2535 = select(0i, select(select(i32(_e2528), i32(-2147483648), (_e2528 < -2147483600f)), 2147483647i, (_e2528 > 2147483500f)), (_e2528 == _e2528));
let _e2539 = (_e2535 - select(0i, 1i, (_e2528 < f32(_e2535))));
let _e2542 = select(-1f, _e2523.y, (_e2523.y > -1f));
let _e2544 = select(_e605, _e2542, (_e2542 < _e605));
let _e2551 = select(0i, select(select(i32(_e2544), i32(-2147483648), (_e2544 < -2147483600f)), 2147483647i, (_e2544 > 2147483500f)), (_e2544 == _e2544));
let _e2555 = (_e2551 - select(0i, 1i, (_e2544 < f32(_e2551))));
let _e2558 = select(-1f, _e2523.z, (_e2523.z > -1f));
let _e2560 = select(_e630, _e2558, (_e2558 < _e630));
let _e2567 = select(0i, select(select(i32(_e2560), i32(-2147483648), (_e2560 < -2147483600f)), 2147483647i, (_e2560 > 2147483500f)), (_e2560 == _e2560));
let _e2571 = (_e2567 - select(0i, 1i, (_e2560 < f32(_e2567))));
let _e2576 = global_2.member[_e369].member_8.member_9;
let _e2581 = global_2.member[_e369].member_8.member_10;
let _e2582 = (_e2539 + 1i);
let _e2583 = (_e2555 + 1i);
let _e2584 = (_e2571 + 1i);
let _e2590 = global_2.member[_e369].member_8.member_13.member;
let _e2591 = bitcast<i32>(_e2590);
let _e2597 = global_2.member[_e369].member_8.member_13.member_1;
let _e2598 = bitcast<i32>(_e2597);
let _e2608 = ((_e2582 >> bitcast<u32>(4i)) + (_e2591 * ((_e2583 >> bitcast<u32>(4i)) + (_e2598 * (_e2584 >> bitcast<u32>(4i))))));
let _e2610 = (bitcast<i32>(_e86) - 1i);
let _e2612 = select(_e2610, _e2608, (_e2608 < _e2610));
let _e2618 = global_1.member[bitcast<u32>(select(0i, _e2612, (_e2612 > 0i)))];
let _e2620 = (_e2582 & 15i);
let _e2623 = ((_e2583 & 15i) * _e2576);
let _e2625 = (bitcast<i32>(_e2618) + ((_e2584 & 15i) * _e2581));
let _e2629 = (_e2623 + _e2576);
let _e2630 = (2i * _e2576);
let _e2631 = (_e2623 + _e2630);
let _e2632 = (_e2625 + _e2581);
let _e2633 = (2i * _e2581);
let _e2634 = (_e2625 + _e2633);
local_8 = type_29(array<i32, 4>(_e2620, (_e2620 + 1i), (_e2620 + 2i), (_e2620 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_9 = (_e2523 - vec3<f32>(f32(_e2539), f32(_e2555), f32(_e2571)));
let _e2643 = (_e2632 + _e2629);
let _e2646 = local_8.member[1u];
let _e2647 = (_e2643 + _e2646);
let _e2649 = select(_e2610, _e2647, (_e2647 < _e2610));
let _e2654 = global_1.member[bitcast<u32>(select(0i, _e2649, (_e2649 > 0i)))];
let _e2655 = bitcast<f32>(_e2654);
let _e2658 = local_8.member[2u];
let _e2659 = (_e2643 + _e2658);
let _e2661 = select(_e2610, _e2659, (_e2659 < _e2610));
let _e2666 = global_1.member[bitcast<u32>(select(0i, _e2661, (_e2661 > 0i)))];
let _e2668 = local_9[0u];
let _e2671 = (_e2655 + ((bitcast<f32>(_e2666) - _e2655) * _e2668));
let _e2672 = (_e2632 + _e2631);
let _e2673 = local_8.member[1u];
let _e2674 = (_e2672 + _e2673);
let _e2676 = select(_e2610, _e2674, (_e2674 < _e2610));
let _e2681 = global_1.member[bitcast<u32>(select(0i, _e2676, (_e2676 > 0i)))];
let _e2682 = bitcast<f32>(_e2681);
let _e2683 = local_8.member[2u];
let _e2684 = (_e2672 + _e2683);
let _e2686 = select(_e2610, _e2684, (_e2684 < _e2610));
let _e2691 = global_1.member[bitcast<u32>(select(0i, _e2686, (_e2686 > 0i)))];
let _e2693 = local_9[0u];
let _e2698 = local_9[1u];
let _e2701 = (_e2671 + (((_e2682 + ((bitcast<f32>(_e2691) - _e2682) * _e2693)) - _e2671) * _e2698));
let _e2702 = (_e2634 + _e2629);
let _e2703 = local_8.member[1u];
let _e2704 = (_e2702 + _e2703);
let _e2706 = select(_e2610, _e2704, (_e2704 < _e2610));
let _e2711 = global_1.member[bitcast<u32>(select(0i, _e2706, (_e2706 > 0i)))];
let _e2712 = bitcast<f32>(_e2711);
let _e2713 = local_8.member[2u];
let _e2714 = (_e2702 + _e2713);
let _e2716 = select(_e2610, _e2714, (_e2714 < _e2610));
let _e2721 = global_1.member[bitcast<u32>(select(0i, _e2716, (_e2716 > 0i)))];
let _e2723 = local_9[0u];
let _e2726 = (_e2712 + ((bitcast<f32>(_e2721) - _e2712) * _e2723));
let _e2727 = (_e2634 + _e2631);
let _e2728 = local_8.member[1u];
let _e2729 = (_e2727 + _e2728);
let _e2731 = select(_e2610, _e2729, (_e2729 < _e2610));
let _e2736 = global_1.member[bitcast<u32>(select(0i, _e2731, (_e2731 > 0i)))];
let _e2737 = bitcast<f32>(_e2736);
let _e2738 = local_8.member[2u];
let _e2739 = (_e2727 + _e2738);
let _e2741 = select(_e2610, _e2739, (_e2739 < _e2610));
let _e2746 = global_1.member[bitcast<u32>(select(0i, _e2741, (_e2741 > 0i)))];
let _e2748 = local_9[0u];
let _e2752 = local_9[1u];
let _e2757 = local_9[2u];
let _e2765 = global_2.member[_e369].member_8.member_8;
let _e2770 = global_2.member[_e369].member_8.member_7;
let _e2772 = (((_e2701 + (((_e2726 + (((_e2737 + ((bitcast<f32>(_e2746) - _e2737) * _e2748)) - _e2726) * _e2752)) - _e2701) * _e2757)) - _e2765) * _e2770);
let _e2773 = -(1e9f);
let _e2775 = select(_e2773, _e2772, (_e2772 > _e2773));
let _e2777 = select(1e9f, _e2775, (_e2775 < 1e9f));
if _e687 {
phi_4853_ = (_e2777 > _e2423);
} else {
phi_4853_ = (_e2777 < _e2423);
}
let _e2784 = phi_4853_;
let _e2785 = ((_e1116 && (_e686 || (_e1113.member > 0f))) && _e2784);
let _e2786 = select(_e2423, _e2777, _e2785);
let _e2789 = (_e1113.member + (_e2424 * 0.25f));
let _e2793 = (_e403 + (_e1117 * _e2789));
let _e2794 = (_e405 + (_e1118 * _e2789));
let _e2795 = (_e393 + (_e1119 * _e2789));
let _e2801 = ((((_e419.member.member * _e2793) + (_e419.member.member_1 * _e2794)) + (_e419.member.member_2 * _e2795)) + _e419.member_1);
let _e2807 = ((((_e435.member.member * _e2793) + (_e435.member.member_1 * _e2794)) + (_e435.member.member_2 * _e2795)) + _e435.member_1);
let _e2813 = ((((_e451.member.member * _e2793) + (_e451.member.member_1 * _e2794)) + (_e451.member.member_2 * _e2795)) + _e451.member_1);
let _e2815 = select(_e486, _e2801, (_e2801 > _e486));
let _e2817 = select(_e492, _e2815, (_e2815 < _e492));
let _e2819 = select(_e502, _e2807, (_e2807 > _e502));
let _e2821 = select(_e508, _e2819, (_e2819 < _e508));
let _e2823 = select(_e518, _e2813, (_e2813 > _e518));
let _e2825 = select(_e524, _e2823, (_e2823 < _e524));
if _e2469 {
phi_5066_ = vec3<f32>(_e2817, _e2821, _e2825);
} else {
let _e2827 = (_e2817 + 0.5f);
let _e2829 = select(0f, _e2827, (_e2827 > 0f));
let _e2831 = select(_e576, _e2829, (_e2829 < _e576));
let _e2838 = select(0i, select(select(i32(_e2831), i32(-2147483648), (_e2831 < -2147483600f)), 2147483647i, (_e2831 > 2147483500f)), (_e2831 == _e2831));
let _e2844 = (_e2821 + 0.5f);
let _e2846 = select(0f, _e2844, (_e2844 > 0f));
let _e2848 = select(_e607, _e2846, (_e2846 < _e607));
let _e2855 = select(0i, select(select(i32(_e2848), i32(-2147483648), (_e2848 < -2147483600f)), 2147483647i, (_e2848 > 2147483500f)), (_e2848 == _e2848));
let _e2861 = (_e2825 + 0.5f);
let _e2863 = select(0f, _e2861, (_e2861 > 0f));
let _e2865 = select(_e632, _e2863, (_e2863 < _e632));
let _e2872 = select(0i, select(select(i32(_e2865), i32(-2147483648), (_e2865 < -2147483600f)), 2147483647i, (_e2865 > 2147483500f)), (_e2865 == _e2865));
phi_5066_ = vec3<f32>(f32((_e2838 - select(0i, 1i, (_e2831 < f32(_e2838))))), f32((_e2855 - select(0i, 1i, (_e2848 < f32(_e2855))))), f32((_e2872 - select(0i, 1i, (_e2865 < f32(_e2872))))));
}
let _e2880 = phi_5066_;
let _e2883 = select(-1f, _e2880.x, (_e2880.x > -1f));
let _e2885 = select(_e574, _e2883, (_e2883 < _e574));
let _e2892 = select(0i, select(select(i32(_e2885), i32(-2147483648), (_e2885 < -2147483600f)), 2147483647i, (_e2885 > 2147483500f)), (_e2885 == _e2885));
let _e2896 = (_e2892 - select(0i, 1i, (_e2885 < f32(_e2892))));
let _e2899 = select(-1f, _e2880.y, (_e2880.y > -1f));
let _e2901 = select(_e605, _e2899, (_e2899 < _e605));
let _e2908 = select(0i, select(select(i32(_e2901), i32(-2147483648), (_e2901 < -2147483600f)), 2147483647i, (_e2901 > 2147483500f)), (_e2901 == _e2901));
let _e2912 = (_e2908 - select(0i, 1i, (_e2901 < f32(_e2908))));
let _e2915 = select(-1f, _e2880.z, (_e2880.z > -1f));
let _e2917 = select(_e630, _e2915, (_e2915 < _e630));
let _e2924 = select(0i, select(select(i32(_e2917), i32(-2147483648), (_e2917 < -2147483600f)), 2147483647i, (_e2917 > 2147483500f)), (_e2917 == _e2917));
let _e2928 = (_e2924 - select(0i, 1i, (_e2917 < f32(_e2924))));
let _e2929 = (_e2896 + 1i);
let _e2930 = (_e2912 + 1i);
let _e2931 = (_e2928 + 1i);
let _e2941 = ((_e2929 >> bitcast<u32>(4i)) + (_e2591 * ((_e2930 >> bitcast<u32>(4i)) + (_e2598 * (_e2931 >> bitcast<u32>(4i))))));
let _e2943 = select(_e2610, _e2941, (_e2941 < _e2610));
let _e2949 = global_1.member[bitcast<u32>(select(0i, _e2943, (_e2943 > 0i)))];
let _e2951 = (_e2929 & 15i);
let _e2954 = ((_e2930 & 15i) * _e2576);
let _e2956 = (bitcast<i32>(_e2949) + ((_e2931 & 15i) * _e2581));
let _e2960 = (_e2954 + _e2576);
let _e2961 = (_e2954 + _e2630);
let _e2962 = (_e2956 + _e2581);
let _e2963 = (_e2956 + _e2633);
local_6 = type_29(array<i32, 4>(_e2951, (_e2951 + 1i), (_e2951 + 2i), (_e2951 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_7 = (_e2880 - vec3<f32>(f32(_e2896), f32(_e2912), f32(_e2928)));
let _e2972 = (_e2962 + _e2960);
let _e2975 = local_6.member[1u];
let _e2976 = (_e2972 + _e2975);
let _e2978 = select(_e2610, _e2976, (_e2976 < _e2610));
let _e2983 = global_1.member[bitcast<u32>(select(0i, _e2978, (_e2978 > 0i)))];
let _e2984 = bitcast<f32>(_e2983);
let _e2987 = local_6.member[2u];
let _e2988 = (_e2972 + _e2987);
let _e2990 = select(_e2610, _e2988, (_e2988 < _e2610));
let _e2995 = global_1.member[bitcast<u32>(select(0i, _e2990, (_e2990 > 0i)))];
let _e2997 = local_7[0u];
let _e3000 = (_e2984 + ((bitcast<f32>(_e2995) - _e2984) * _e2997));
let _e3001 = (_e2962 + _e2961);
let _e3002 = local_6.member[1u];
let _e3003 = (_e3001 + _e3002);
let _e3005 = select(_e2610, _e3003, (_e3003 < _e2610));
let _e3010 = global_1.member[bitcast<u32>(select(0i, _e3005, (_e3005 > 0i)))];
let _e3011 = bitcast<f32>(_e3010);
let _e3012 = local_6.member[2u];
let _e3013 = (_e3001 + _e3012);
let _e3015 = select(_e2610, _e3013, (_e3013 < _e2610));
let _e3020 = global_1.member[bitcast<u32>(select(0i, _e3015, (_e3015 > 0i)))];
let _e3022 = local_7[0u];
let _e3027 = local_7[1u];
let _e3030 = (_e3000 + (((_e3011 + ((bitcast<f32>(_e3020) - _e3011) * _e3022)) - _e3000) * _e3027));
let _e3031 = (_e2963 + _e2960);
let _e3032 = local_6.member[1u];
let _e3033 = (_e3031 + _e3032);
let _e3035 = select(_e2610, _e3033, (_e3033 < _e2610));
let _e3040 = global_1.member[bitcast<u32>(select(0i, _e3035, (_e3035 > 0i)))];
let _e3041 = bitcast<f32>(_e3040);
let _e3042 = local_6.member[2u];
let _e3043 = (_e3031 + _e3042);
let _e3045 = select(_e2610, _e3043, (_e3043 < _e2610));
let _e3050 = global_1.member[bitcast<u32>(select(0i, _e3045, (_e3045 > 0i)))];
let _e3052 = local_7[0u];
let _e3055 = (_e3041 + ((bitcast<f32>(_e3050) - _e3041) * _e3052));
let _e3056 = (_e2963 + _e2961);
let _e3057 = local_6.member[1u];
let _e3058 = (_e3056 + _e3057);
let _e3060 = select(_e2610, _e3058, (_e3058 < _e2610));
let _e3065 = global_1.member[bitcast<u32>(select(0i, _e3060, (_e3060 > 0i)))];
let _e3066 = bitcast<f32>(_e3065);
let _e3067 = local_6.member[2u];
let _e3068 = (_e3056 + _e3067);
let _e3070 = select(_e2610, _e3068, (_e3068 < _e2610));
let _e3075 = global_1.member[bitcast<u32>(select(0i, _e3070, (_e3070 > 0i)))];
let _e3077 = local_7[0u];
let _e3081 = local_7[1u];
let _e3086 = local_7[2u];
let _e3091 = (((_e3030 + (((_e3055 + (((_e3066 + ((bitcast<f32>(_e3075) - _e3066) * _e3077)) - _e3055) * _e3081)) - _e3030) * _e3086)) - _e2765) * _e2770);
let _e3093 = select(_e2773, _e3091, (_e3091 > _e2773));
let _e3095 = select(1e9f, _e3093, (_e3093 < 1e9f));
if _e687 {
phi_5448_ = (_e3095 > _e2786);
} else {
phi_5448_ = (_e3095 < _e2786);
}
let _e3099 = phi_5448_;
let _e3100 = (_e1116 && _e3099);
let _e3101 = select(_e2786, _e3095, _e3100);
let _e3105 = (_e1113.member + (_e2424 * (2f * 0.25f)));
let _e3109 = (_e403 + (_e1117 * _e3105));
let _e3110 = (_e405 + (_e1118 * _e3105));
let _e3111 = (_e393 + (_e1119 * _e3105));
let _e3117 = ((((_e419.member.member * _e3109) + (_e419.member.member_1 * _e3110)) + (_e419.member.member_2 * _e3111)) + _e419.member_1);
let _e3123 = ((((_e435.member.member * _e3109) + (_e435.member.member_1 * _e3110)) + (_e435.member.member_2 * _e3111)) + _e435.member_1);
let _e3129 = ((((_e451.member.member * _e3109) + (_e451.member.member_1 * _e3110)) + (_e451.member.member_2 * _e3111)) + _e451.member_1);
let _e3131 = select(_e486, _e3117, (_e3117 > _e486));
let _e3133 = select(_e492, _e3131, (_e3131 < _e492));
let _e3135 = select(_e502, _e3123, (_e3123 > _e502));
let _e3137 = select(_e508, _e3135, (_e3135 < _e508));
let _e3139 = select(_e518, _e3129, (_e3129 > _e518));
let _e3141 = select(_e524, _e3139, (_e3139 < _e524));
if _e2469 {
phi_5662_ = vec3<f32>(_e3133, _e3137, _e3141);
} else {
let _e3143 = (_e3133 + 0.5f);
let _e3145 = select(0f, _e3143, (_e3143 > 0f));
let _e3147 = select(_e576, _e3145, (_e3145 < _e576));
let _e3154 = select(0i, select(select(i32(_e3147), i32(-2147483648), (_e3147 < -2147483600f)), 2147483647i, (_e3147 > 2147483500f)), (_e3147 == _e3147));
let _e3160 = (_e3137 + 0.5f);
let _e3162 = select(0f, _e3160, (_e3160 > 0f));
let _e3164 = select(_e607, _e3162, (_e3162 < _e607));
let _e3171 = select(0i, select(select(i32(_e3164), i32(-2147483648), (_e3164 < -2147483600f)), 2147483647i, (_e3164 > 2147483500f)), (_e3164 == _e3164));
let _e3177 = (_e3141 + 0.5f);
let _e3179 = select(0f, _e3177, (_e3177 > 0f));
let _e3181 = select(_e632, _e3179, (_e3179 < _e632));
let _e3188 = select(0i, select(select(i32(_e3181), i32(-2147483648), (_e3181 < -2147483600f)), 2147483647i, (_e3181 > 2147483500f)), (_e3181 == _e3181));
phi_5662_ = vec3<f32>(f32((_e3154 - select(0i, 1i, (_e3147 < f32(_e3154))))), f32((_e3171 - select(0i, 1i, (_e3164 < f32(_e3171))))), f32((_e3188 - select(0i, 1i, (_e3181 < f32(_e3188))))));
}
let _e3196 = phi_5662_;
let _e3199 = select(-1f, _e3196.x, (_e3196.x > -1f));
let _e3201 = select(_e574, _e3199, (_e3199 < _e574));
let _e3208 = select(0i, select(select(i32(_e3201), i32(-2147483648), (_e3201 < -2147483600f)), 2147483647i, (_e3201 > 2147483500f)), (_e3201 == _e3201));
let _e3212 = (_e3208 - select(0i, 1i, (_e3201 < f32(_e3208))));
let _e3215 = select(-1f, _e3196.y, (_e3196.y > -1f));
let _e3217 = select(_e605, _e3215, (_e3215 < _e605));
let _e3224 = select(0i, select(select(i32(_e3217), i32(-2147483648), (_e3217 < -2147483600f)), 2147483647i, (_e3217 > 2147483500f)), (_e3217 == _e3217));
let _e3228 = (_e3224 - select(0i, 1i, (_e3217 < f32(_e3224))));
let _e3231 = select(-1f, _e3196.z, (_e3196.z > -1f));
let _e3233 = select(_e630, _e3231, (_e3231 < _e630));
let _e3240 = select(0i, select(select(i32(_e3233), i32(-2147483648), (_e3233 < -2147483600f)), 2147483647i, (_e3233 > 2147483500f)), (_e3233 == _e3233));
let _e3244 = (_e3240 - select(0i, 1i, (_e3233 < f32(_e3240))));
let _e3245 = (_e3212 + 1i);
let _e3246 = (_e3228 + 1i);
let _e3247 = (_e3244 + 1i);
let _e3257 = ((_e3245 >> bitcast<u32>(4i)) + (_e2591 * ((_e3246 >> bitcast<u32>(4i)) + (_e2598 * (_e3247 >> bitcast<u32>(4i))))));
let _e3259 = select(_e2610, _e3257, (_e3257 < _e2610));
let _e3265 = global_1.member[bitcast<u32>(select(0i, _e3259, (_e3259 > 0i)))];
let _e3267 = (_e3245 & 15i);
let _e3270 = ((_e3246 & 15i) * _e2576);
let _e3272 = (bitcast<i32>(_e3265) + ((_e3247 & 15i) * _e2581));
let _e3276 = (_e3270 + _e2576);
let _e3277 = (_e3270 + _e2630);
let _e3278 = (_e3272 + _e2581);
let _e3279 = (_e3272 + _e2633);
local_4 = type_29(array<i32, 4>(_e3267, (_e3267 + 1i), (_e3267 + 2i), (_e3267 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_5 = (_e3196 - vec3<f32>(f32(_e3212), f32(_e3228), f32(_e3244)));
let _e3288 = (_e3278 + _e3276);
let _e3291 = local_4.member[1u];
let _e3292 = (_e3288 + _e3291);
let _e3294 = select(_e2610, _e3292, (_e3292 < _e2610));
let _e3299 = global_1.member[bitcast<u32>(select(0i, _e3294, (_e3294 > 0i)))];
let _e3300 = bitcast<f32>(_e3299);
let _e3303 = local_4.member[2u];
let _e3304 = (_e3288 + _e3303);
let _e3306 = select(_e2610, _e3304, (_e3304 < _e2610));
let _e3311 = global_1.member[bitcast<u32>(select(0i, _e3306, (_e3306 > 0i)))];
let _e3313 = local_5[0u];
let _e3316 = (_e3300 + ((bitcast<f32>(_e3311) - _e3300) * _e3313));
let _e3317 = (_e3278 + _e3277);
let _e3318 = local_4.member[1u];
let _e3319 = (_e3317 + _e3318);
let _e3321 = select(_e2610, _e3319, (_e3319 < _e2610));
let _e3326 = global_1.member[bitcast<u32>(select(0i, _e3321, (_e3321 > 0i)))];
let _e3327 = bitcast<f32>(_e3326);
let _e3328 = local_4.member[2u];
let _e3329 = (_e3317 + _e3328);
let _e3331 = select(_e2610, _e3329, (_e3329 < _e2610));
let _e3336 = global_1.member[bitcast<u32>(select(0i, _e3331, (_e3331 > 0i)))];
let _e3338 = local_5[0u];
let _e3343 = local_5[1u];
let _e3346 = (_e3316 + (((_e3327 + ((bitcast<f32>(_e3336) - _e3327) * _e3338)) - _e3316) * _e3343));
let _e3347 = (_e3279 + _e3276);
let _e3348 = local_4.member[1u];
let _e3349 = (_e3347 + _e3348);
let _e3351 = select(_e2610, _e3349, (_e3349 < _e2610));
let _e3356 = global_1.member[bitcast<u32>(select(0i, _e3351, (_e3351 > 0i)))];
let _e3357 = bitcast<f32>(_e3356);
let _e3358 = local_4.member[2u];
let _e3359 = (_e3347 + _e3358);
let _e3361 = select(_e2610, _e3359, (_e3359 < _e2610));
let _e3366 = global_1.member[bitcast<u32>(select(0i, _e3361, (_e3361 > 0i)))];
let _e3368 = local_5[0u];
let _e3371 = (_e3357 + ((bitcast<f32>(_e3366) - _e3357) * _e3368));
let _e3372 = (_e3279 + _e3277);
let _e3373 = local_4.member[1u];
let _e3374 = (_e3372 + _e3373);
let _e3376 = select(_e2610, _e3374, (_e3374 < _e2610));
let _e3381 = global_1.member[bitcast<u32>(select(0i, _e3376, (_e3376 > 0i)))];
let _e3382 = bitcast<f32>(_e3381);
let _e3383 = local_4.member[2u];
let _e3384 = (_e3372 + _e3383);
let _e3386 = select(_e2610, _e3384, (_e3384 < _e2610));
let _e3391 = global_1.member[bitcast<u32>(select(0i, _e3386, (_e3386 > 0i)))];
let _e3393 = local_5[0u];
let _e3397 = local_5[1u];
let _e3402 = local_5[2u];
let _e3407 = (((_e3346 + (((_e3371 + (((_e3382 + ((bitcast<f32>(_e3391) - _e3382) * _e3393)) - _e3371) * _e3397)) - _e3346) * _e3402)) - _e2765) * _e2770);
let _e3409 = select(_e2773, _e3407, (_e3407 > _e2773));
let _e3411 = select(1e9f, _e3409, (_e3409 < 1e9f));
if _e687 {
phi_6044_ = (_e3411 > _e3101);
} else {
phi_6044_ = (_e3411 < _e3101);
}
let _e3415 = phi_6044_;
let _e3416 = (_e1116 && _e3415);
let _e3417 = select(_e3101, _e3411, _e3416);
let _e3421 = (_e1113.member + (_e2424 * (3f * 0.25f)));
let _e3425 = (_e403 + (_e1117 * _e3421));
let _e3426 = (_e405 + (_e1118 * _e3421));
let _e3427 = (_e393 + (_e1119 * _e3421));
let _e3433 = ((((_e419.member.member * _e3425) + (_e419.member.member_1 * _e3426)) + (_e419.member.member_2 * _e3427)) + _e419.member_1);
let _e3439 = ((((_e435.member.member * _e3425) + (_e435.member.member_1 * _e3426)) + (_e435.member.member_2 * _e3427)) + _e435.member_1);
let _e3445 = ((((_e451.member.member * _e3425) + (_e451.member.member_1 * _e3426)) + (_e451.member.member_2 * _e3427)) + _e451.member_1);
let _e3447 = select(_e486, _e3433, (_e3433 > _e486));
let _e3449 = select(_e492, _e3447, (_e3447 < _e492));
let _e3451 = select(_e502, _e3439, (_e3439 > _e502));
let _e3453 = select(_e508, _e3451, (_e3451 < _e508));
let _e3455 = select(_e518, _e3445, (_e3445 > _e518));
let _e3457 = select(_e524, _e3455, (_e3455 < _e524));
if _e2469 {
phi_6258_ = vec3<f32>(_e3449, _e3453, _e3457);
} else {
let _e3459 = (_e3449 + 0.5f);
let _e3461 = select(0f, _e3459, (_e3459 > 0f));
let _e3463 = select(_e576, _e3461, (_e3461 < _e576));
let _e3470 = select(0i, select(select(i32(_e3463), i32(-2147483648), (_e3463 < -2147483600f)), 2147483647i, (_e3463 > 2147483500f)), (_e3463 == _e3463));
let _e3476 = (_e3453 + 0.5f);
let _e3478 = select(0f, _e3476, (_e3476 > 0f));
let _e3480 = select(_e607, _e3478, (_e3478 < _e607));
let _e3487 = select(0i, select(select(i32(_e3480), i32(-2147483648), (_e3480 < -2147483600f)), 2147483647i, (_e3480 > 2147483500f)), (_e3480 == _e3480));
let _e3493 = (_e3457 + 0.5f);
let _e3495 = select(0f, _e3493, (_e3493 > 0f));
let _e3497 = select(_e632, _e3495, (_e3495 < _e632));
let _e3504 = select(0i, select(select(i32(_e3497), i32(-2147483648), (_e3497 < -2147483600f)), 2147483647i, (_e3497 > 2147483500f)), (_e3497 == _e3497));
phi_6258_ = vec3<f32>(f32((_e3470 - select(0i, 1i, (_e3463 < f32(_e3470))))), f32((_e3487 - select(0i, 1i, (_e3480 < f32(_e3487))))), f32((_e3504 - select(0i, 1i, (_e3497 < f32(_e3504))))));
}
let _e3512 = phi_6258_;
let _e3515 = select(-1f, _e3512.x, (_e3512.x > -1f));
let _e3517 = select(_e574, _e3515, (_e3515 < _e574));
let _e3524 = select(0i, select(select(i32(_e3517), i32(-2147483648), (_e3517 < -2147483600f)), 2147483647i, (_e3517 > 2147483500f)), (_e3517 == _e3517));
let _e3528 = (_e3524 - select(0i, 1i, (_e3517 < f32(_e3524))));
let _e3531 = select(-1f, _e3512.y, (_e3512.y > -1f));
let _e3533 = select(_e605, _e3531, (_e3531 < _e605));
let _e3540 = select(0i, select(select(i32(_e3533), i32(-2147483648), (_e3533 < -2147483600f)), 2147483647i, (_e3533 > 2147483500f)), (_e3533 == _e3533));
let _e3544 = (_e3540 - select(0i, 1i, (_e3533 < f32(_e3540))));
let _e3547 = select(-1f, _e3512.z, (_e3512.z > -1f));
let _e3549 = select(_e630, _e3547, (_e3547 < _e630));
let _e3556 = select(0i, select(select(i32(_e3549), i32(-2147483648), (_e3549 < -2147483600f)), 2147483647i, (_e3549 > 2147483500f)), (_e3549 == _e3549));
let _e3560 = (_e3556 - select(0i, 1i, (_e3549 < f32(_e3556))));
let _e3561 = (_e3528 + 1i);
let _e3562 = (_e3544 + 1i);
let _e3563 = (_e3560 + 1i);
let _e3573 = ((_e3561 >> bitcast<u32>(4i)) + (_e2591 * ((_e3562 >> bitcast<u32>(4i)) + (_e2598 * (_e3563 >> bitcast<u32>(4i))))));
let _e3575 = select(_e2610, _e3573, (_e3573 < _e2610));
let _e3581 = global_1.member[bitcast<u32>(select(0i, _e3575, (_e3575 > 0i)))];
let _e3583 = (_e3561 & 15i);
let _e3586 = ((_e3562 & 15i) * _e2576);
let _e3588 = (bitcast<i32>(_e3581) + ((_e3563 & 15i) * _e2581));
let _e3592 = (_e3586 + _e2576);
let _e3593 = (_e3586 + _e2630);
let _e3594 = (_e3588 + _e2581);
let _e3595 = (_e3588 + _e2633);
local_2 = type_29(array<i32, 4>(_e3583, (_e3583 + 1i), (_e3583 + 2i), (_e3583 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_3 = (_e3512 - vec3<f32>(f32(_e3528), f32(_e3544), f32(_e3560)));
let _e3604 = (_e3594 + _e3592);
let _e3607 = local_2.member[1u];
let _e3608 = (_e3604 + _e3607);
let _e3610 = select(_e2610, _e3608, (_e3608 < _e2610));
let _e3615 = global_1.member[bitcast<u32>(select(0i, _e3610, (_e3610 > 0i)))];
let _e3616 = bitcast<f32>(_e3615);
let _e3619 = local_2.member[2u];
let _e3620 = (_e3604 + _e3619);
let _e3622 = select(_e2610, _e3620, (_e3620 < _e2610));
let _e3627 = global_1.member[bitcast<u32>(select(0i, _e3622, (_e3622 > 0i)))];
let _e3629 = local_3[0u];
let _e3632 = (_e3616 + ((bitcast<f32>(_e3627) - _e3616) * _e3629));
let _e3633 = (_e3594 + _e3593);
let _e3634 = local_2.member[1u];
let _e3635 = (_e3633 + _e3634);
let _e3637 = select(_e2610, _e3635, (_e3635 < _e2610));
let _e3642 = global_1.member[bitcast<u32>(select(0i, _e3637, (_e3637 > 0i)))];
let _e3643 = bitcast<f32>(_e3642);
let _e3644 = local_2.member[2u];
let _e3645 = (_e3633 + _e3644);
let _e3647 = select(_e2610, _e3645, (_e3645 < _e2610));
let _e3652 = global_1.member[bitcast<u32>(select(0i, _e3647, (_e3647 > 0i)))];
let _e3654 = local_3[0u];
let _e3659 = local_3[1u];
let _e3662 = (_e3632 + (((_e3643 + ((bitcast<f32>(_e3652) - _e3643) * _e3654)) - _e3632) * _e3659));
let _e3663 = (_e3595 + _e3592);
let _e3664 = local_2.member[1u];
let _e3665 = (_e3663 + _e3664);
let _e3667 = select(_e2610, _e3665, (_e3665 < _e2610));
let _e3672 = global_1.member[bitcast<u32>(select(0i, _e3667, (_e3667 > 0i)))];
let _e3673 = bitcast<f32>(_e3672);
let _e3674 = local_2.member[2u];
let _e3675 = (_e3663 + _e3674);
let _e3677 = select(_e2610, _e3675, (_e3675 < _e2610));
let _e3682 = global_1.member[bitcast<u32>(select(0i, _e3677, (_e3677 > 0i)))];
let _e3684 = local_3[0u];
let _e3687 = (_e3673 + ((bitcast<f32>(_e3682) - _e3673) * _e3684));
let _e3688 = (_e3595 + _e3593);
let _e3689 = local_2.member[1u];
let _e3690 = (_e3688 + _e3689);
let _e3692 = select(_e2610, _e3690, (_e3690 < _e2610));
let _e3697 = global_1.member[bitcast<u32>(select(0i, _e3692, (_e3692 > 0i)))];
let _e3698 = bitcast<f32>(_e3697);
let _e3699 = local_2.member[2u];
let _e3700 = (_e3688 + _e3699);
let _e3702 = select(_e2610, _e3700, (_e3700 < _e2610));
let _e3707 = global_1.member[bitcast<u32>(select(0i, _e3702, (_e3702 > 0i)))];
let _e3709 = local_3[0u];
let _e3713 = local_3[1u];
let _e3718 = local_3[2u];
let _e3723 = (((_e3662 + (((_e3687 + (((_e3698 + ((bitcast<f32>(_e3707) - _e3698) * _e3709)) - _e3687) * _e3713)) - _e3662) * _e3718)) - _e2765) * _e2770);
let _e3725 = select(_e2773, _e3723, (_e3723 > _e2773));
let _e3727 = select(1e9f, _e3725, (_e3725 < 1e9f));
if _e687 {
phi_6640_ = (_e3727 > _e3417);
} else {
phi_6640_ = (_e3727 < _e3417);
}
let _e3731 = phi_6640_;
let _e3732 = (_e1116 && _e3731);
let _e3733 = select(_e3417, _e3727, _e3732);
let _e3736 = (_e1113.member + (_e2424 * 1f));
let _e3740 = (_e403 + (_e1117 * _e3736));
let _e3741 = (_e405 + (_e1118 * _e3736));
let _e3742 = (_e393 + (_e1119 * _e3736));
let _e3748 = ((((_e419.member.member * _e3740) + (_e419.member.member_1 * _e3741)) + (_e419.member.member_2 * _e3742)) + _e419.member_1);
let _e3754 = ((((_e435.member.member * _e3740) + (_e435.member.member_1 * _e3741)) + (_e435.member.member_2 * _e3742)) + _e435.member_1);
let _e3760 = ((((_e451.member.member * _e3740) + (_e451.member.member_1 * _e3741)) + (_e451.member.member_2 * _e3742)) + _e451.member_1);
let _e3762 = select(_e486, _e3748, (_e3748 > _e486));
let _e3764 = select(_e492, _e3762, (_e3762 < _e492));
let _e3766 = select(_e502, _e3754, (_e3754 > _e502));
let _e3768 = select(_e508, _e3766, (_e3766 < _e508));
let _e3770 = select(_e518, _e3760, (_e3760 > _e518));
let _e3772 = select(_e524, _e3770, (_e3770 < _e524));
if _e2469 {
phi_6853_ = vec3<f32>(_e3764, _e3768, _e3772);
} else {
let _e3774 = (_e3764 + 0.5f);
let _e3776 = select(0f, _e3774, (_e3774 > 0f));
let _e3778 = select(_e576, _e3776, (_e3776 < _e576));
let _e3785 = select(0i, select(select(i32(_e3778), i32(-2147483648), (_e3778 < -2147483600f)), 2147483647i, (_e3778 > 2147483500f)), (_e3778 == _e3778));
let _e3791 = (_e3768 + 0.5f);
let _e3793 = select(0f, _e3791, (_e3791 > 0f));
let _e3795 = select(_e607, _e3793, (_e3793 < _e607));
let _e3802 = select(0i, select(select(i32(_e3795), i32(-2147483648), (_e3795 < -2147483600f)), 2147483647i, (_e3795 > 2147483500f)), (_e3795 == _e3795));
let _e3808 = (_e3772 + 0.5f);
let _e3810 = select(0f, _e3808, (_e3808 > 0f));
let _e3812 = select(_e632, _e3810, (_e3810 < _e632));
let _e3819 = select(0i, select(select(i32(_e3812), i32(-2147483648), (_e3812 < -2147483600f)), 2147483647i, (_e3812 > 2147483500f)), (_e3812 == _e3812));
phi_6853_ = vec3<f32>(f32((_e3785 - select(0i, 1i, (_e3778 < f32(_e3785))))), f32((_e3802 - select(0i, 1i, (_e3795 < f32(_e3802))))), f32((_e3819 - select(0i, 1i, (_e3812 < f32(_e3819))))));
}
let _e3827 = phi_6853_;
let _e3830 = select(-1f, _e3827.x, (_e3827.x > -1f));
let _e3832 = select(_e574, _e3830, (_e3830 < _e574));
let _e3839 = select(0i, select(select(i32(_e3832), i32(-2147483648), (_e3832 < -2147483600f)), 2147483647i, (_e3832 > 2147483500f)), (_e3832 == _e3832));
let _e3843 = (_e3839 - select(0i, 1i, (_e3832 < f32(_e3839))));
let _e3846 = select(-1f, _e3827.y, (_e3827.y > -1f));
let _e3848 = select(_e605, _e3846, (_e3846 < _e605));
let _e3855 = select(0i, select(select(i32(_e3848), i32(-2147483648), (_e3848 < -2147483600f)), 2147483647i, (_e3848 > 2147483500f)), (_e3848 == _e3848));
let _e3859 = (_e3855 - select(0i, 1i, (_e3848 < f32(_e3855))));
let _e3862 = select(-1f, _e3827.z, (_e3827.z > -1f));
let _e3864 = select(_e630, _e3862, (_e3862 < _e630));
let _e3871 = select(0i, select(select(i32(_e3864), i32(-2147483648), (_e3864 < -2147483600f)), 2147483647i, (_e3864 > 2147483500f)), (_e3864 == _e3864));
let _e3875 = (_e3871 - select(0i, 1i, (_e3864 < f32(_e3871))));
let _e3876 = (_e3843 + 1i);
let _e3877 = (_e3859 + 1i);
let _e3878 = (_e3875 + 1i);
let _e3888 = ((_e3876 >> bitcast<u32>(4i)) + (_e2591 * ((_e3877 >> bitcast<u32>(4i)) + (_e2598 * (_e3878 >> bitcast<u32>(4i))))));
let _e3890 = select(_e2610, _e3888, (_e3888 < _e2610));
let _e3896 = global_1.member[bitcast<u32>(select(0i, _e3890, (_e3890 > 0i)))];
let _e3898 = (_e3876 & 15i);
let _e3901 = ((_e3877 & 15i) * _e2576);
let _e3903 = (bitcast<i32>(_e3896) + ((_e3878 & 15i) * _e2581));
let _e3907 = (_e3901 + _e2576);
let _e3908 = (_e3901 + _e2630);
let _e3909 = (_e3903 + _e2581);
let _e3910 = (_e3903 + _e2633);
local = type_29(array<i32, 4>(_e3898, (_e3898 + 1i), (_e3898 + 2i), (_e3898 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_1 = (_e3827 - vec3<f32>(f32(_e3843), f32(_e3859), f32(_e3875)));
let _e3919 = (_e3909 + _e3907);
let _e3922 = local.member[1u];
let _e3923 = (_e3919 + _e3922);
let _e3925 = select(_e2610, _e3923, (_e3923 < _e2610));
let _e3930 = global_1.member[bitcast<u32>(select(0i, _e3925, (_e3925 > 0i)))];
let _e3931 = bitcast<f32>(_e3930);
let _e3934 = local.member[2u];
let _e3935 = (_e3919 + _e3934);
let _e3937 = select(_e2610, _e3935, (_e3935 < _e2610));
let _e3942 = global_1.member[bitcast<u32>(select(0i, _e3937, (_e3937 > 0i)))];
let _e3944 = local_1[0u];
let _e3947 = (_e3931 + ((bitcast<f32>(_e3942) - _e3931) * _e3944));
let _e3948 = (_e3909 + _e3908);
let _e3949 = local.member[1u];
let _e3950 = (_e3948 + _e3949);
let _e3952 = select(_e2610, _e3950, (_e3950 < _e2610));
let _e3957 = global_1.member[bitcast<u32>(select(0i, _e3952, (_e3952 > 0i)))];
let _e3958 = bitcast<f32>(_e3957);
let _e3959 = local.member[2u];
let _e3960 = (_e3948 + _e3959);
let _e3962 = select(_e2610, _e3960, (_e3960 < _e2610));
let _e3967 = global_1.member[bitcast<u32>(select(0i, _e3962, (_e3962 > 0i)))];
let _e3969 = local_1[0u];
let _e3974 = local_1[1u];
let _e3977 = (_e3947 + (((_e3958 + ((bitcast<f32>(_e3967) - _e3958) * _e3969)) - _e3947) * _e3974));
let _e3978 = (_e3910 + _e3907);
let _e3979 = local.member[1u];
let _e3980 = (_e3978 + _e3979);
let _e3982 = select(_e2610, _e3980, (_e3980 < _e2610));
let _e3987 = global_1.member[bitcast<u32>(select(0i, _e3982, (_e3982 > 0i)))];
let _e3988 = bitcast<f32>(_e3987);
let _e3989 = local.member[2u];
let _e3990 = (_e3978 + _e3989);
let _e3992 = select(_e2610, _e3990, (_e3990 < _e2610));
let _e3997 = global_1.member[bitcast<u32>(select(0i, _e3992, (_e3992 > 0i)))];
let _e3999 = local_1[0u];
let _e4002 = (_e3988 + ((bitcast<f32>(_e3997) - _e3988) * _e3999));
let _e4003 = (_e3910 + _e3908);
let _e4004 = local.member[1u];
let _e4005 = (_e4003 + _e4004);
let _e4007 = select(_e2610, _e4005, (_e4005 < _e2610));
let _e4012 = global_1.member[bitcast<u32>(select(0i, _e4007, (_e4007 > 0i)))];
let _e4013 = bitcast<f32>(_e4012);
let _e4014 = local.member[2u];
let _e4015 = (_e4003 + _e4014);
let _e4017 = select(_e2610, _e4015, (_e4015 < _e2610));
let _e4022 = global_1.member[bitcast<u32>(select(0i, _e4017, (_e4017 > 0i)))];
let _e4024 = local_1[0u];
let _e4028 = local_1[1u];
let _e4033 = local_1[2u];
let _e4038 = (((_e3977 + (((_e4002 + (((_e4013 + ((bitcast<f32>(_e4022) - _e4013) * _e4024)) - _e4002) * _e4028)) - _e3977) * _e4033)) - _e2765) * _e2770);
let _e4040 = select(_e2773, _e4038, (_e4038 > _e2773));
let _e4042 = select(1e9f, _e4040, (_e4040 < 1e9f));
if _e687 {
phi_7235_ = (_e4042 > _e3733);
} else {
phi_7235_ = (_e4042 < _e3733);
}
let _e4046 = phi_7235_;
let _e4047 = (_e1116 && _e4046);
phi_7245_ = select(select(select(select(select(_e373[8], _e2432, _e2785), _e2795, _e3100), _e3111, _e3416), _e3427, _e3732), _e3742, _e4047);
phi_7246_ = select(_e3733, _e4042, _e4047);
}
let _e4051 = phi_7245_;
let _e4053 = phi_7246_;
phi_7264_ = array<f32, 23>(_e373[0], _e373[1], _e373[2], _e373[3], _e373[4], _e373[5], select(_e373[6], _e4053, _e1116), _e373[7], select(_e373[8], _e4051, _e1116), _e373[9], _e373[10], _e373[11], _e373[12], _e373[13], _e373[14], _e373[15], _e373[16], select(_e373[17], _e414, _e1116), _e373[18], _e373[19], _e373[20], _e373[21], _e373[22]);
} else {
phi_7264_ = _e373;
}
let _e4059 = phi_7264_;
phi_627_ = (_e369 + 1u);
phi_630_ = select(_e371, true, _e745);
phi_632_ = _e4059;
} else {
phi_627_ = u32();
phi_630_ = bool();
phi_632_ = array<f32, 23>();
}
let _e4063 = phi_627_;
let _e4065 = phi_630_;
let _e4067 = phi_632_;
continue;
continuing {
phi_626_ = _e4063;
phi_629_ = _e4065;
phi_631_ = _e4067;
phi_7367_ = false;
break if !(_e374);
}
}
let _e4070 = phi_7367_;
if _e4070 {
break;
}
let _e4072 = local_18;
if _e4072 {
let _e4074 = local_19;
global_4.member[_e114] = _e4074[0];
let _e4079 = local_20;
global_4.member[_e126] = _e4079[1];
let _e4084 = local_21;
global_4.member[_e137] = _e4084[2];
let _e4089 = local_22;
global_4.member[_e148] = _e4089[3];
let _e4094 = local_23;
global_4.member[_e159] = _e4094[4];
let _e4099 = local_24;
global_4.member[_e170] = _e4099[5];
let _e4104 = local_25;
global_4.member[_e181] = _e4104[6];
let _e4109 = local_26;
global_4.member[_e192] = _e4109[7];
let _e4114 = local_27;
global_4.member[_e203] = _e4114[8];
let _e4119 = local_28;
global_4.member[_e214] = _e4119[9];
let _e4124 = local_29;
global_4.member[_e225] = _e4124[10];
let _e4129 = local_30;
global_4.member[_e236] = _e4129[11];
let _e4134 = local_31;
global_4.member[_e247] = _e4134[12];
let _e4139 = local_32;
global_4.member[_e258] = _e4139[13];
let _e4144 = local_33;
global_4.member[_e269] = _e4144[14];
let _e4149 = local_34;
global_4.member[_e280] = _e4149[15];
let _e4154 = local_35;
global_4.member[_e291] = _e4154[16];
let _e4159 = local_36;
global_4.member[_e302] = _e4159[17];
let _e4164 = local_37;
global_4.member[_e313] = _e4164[18];
let _e4169 = local_38;
global_4.member[_e324] = _e4169[19];
let _e4174 = local_39;
global_4.member[_e335] = _e4174[20];
let _e4179 = local_40;
global_4.member[_e346] = _e4179[21];
let _e4184 = local_41;
global_4.member[_e357] = _e4184[22];
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
