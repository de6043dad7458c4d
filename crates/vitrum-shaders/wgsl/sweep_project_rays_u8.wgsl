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
var phi_630_: u32;
var phi_633_: bool;
var phi_635_: array<f32, 23>;
var phi_999_: bool;
var phi_1895_: type_32;
var phi_2116_: vec3<f32>;
var phi_2849_: vec3<f32>;
var phi_3582_: vec3<f32>;
var phi_4315_: vec3<f32>;
var phi_4876_: f32;
var phi_5084_: vec3<f32>;
var phi_5622_: bool;
var phi_5835_: vec3<f32>;
var phi_6370_: bool;
var phi_6584_: vec3<f32>;
var phi_7119_: bool;
var phi_7333_: vec3<f32>;
var phi_7868_: bool;
var phi_8081_: vec3<f32>;
var phi_8616_: bool;
var phi_8626_: f32;
var phi_8627_: f32;
var phi_8645_: array<f32, 23>;
var phi_631_: u32;
var phi_634_: bool;
var phi_636_: array<f32, 23>;
var phi_8748_: bool;
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
phi_630_ = 0u;
phi_633_ = false;
phi_635_ = array<f32, 23>(_e125, _e135, _e146, _e157, _e168, _e179, _e190, _e201, _e212, _e223, _e234, _e245, _e256, _e267, _e278, _e289, _e300, _e311, _e322, _e333, _e344, _e355, _e366);
loop {
let _e369 = phi_630_;
let _e371 = phi_633_;
let _e373 = phi_635_;
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
phi_8748_ = true;
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
phi_999_ = (_e685 <= _e373[6]);
} else {
phi_999_ = (_e685 >= _e373[6]);
}
let _e691 = phi_999_;
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
phi_1895_ = type_32(_e919, _e921);
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
phi_1895_ = type_32(select(_e1103, _e1061, (_e1061 > _e1103)), select(_e1106, _e1063, (_e1063 < _e1106)));
}
let _e1113 = phi_1895_;
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
phi_2116_ = vec3<f32>(_e1152, _e1156, _e1160);
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
phi_2116_ = vec3<f32>(f32((_e1179 - select(0i, 1i, (_e1172 < f32(_e1179))))), f32((_e1196 - select(0i, 1i, (_e1189 < f32(_e1196))))), f32((_e1213 - select(0i, 1i, (_e1206 < f32(_e1213))))));
}
let _e1221 = phi_2116_;
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
let _e1287 = (select(0i, select(select(i32(_e605), i32(-2147483648), (_e605 < -2147483600f)), 2147483647i, (_e605 > 2147483500f)), (_e605 == _e605)) - 1i);
let _e1290 = (_e1253 + 1i);
let _e1300 = (select(0i, select(select(i32(_e630), i32(-2147483648), (_e630 < -2147483600f)), 2147483647i, (_e630 > 2147483500f)), (_e630 == _e630)) - 1i);
let _e1303 = (_e1269 + 1i);
let _e1312 = select(0i, select(select(i32(_e574), i32(-2147483648), (_e574 < -2147483600f)), 2147483647i, (_e574 > 2147483500f)), (_e574 == _e574));
let _e1313 = (_e1312 - 1i);
let _e1314 = (_e1237 - 1i);
let _e1316 = select(0i, _e1314, (_e1314 > 0i));
let _e1319 = (_e1237 + 1i);
let _e1322 = (_e1237 + 2i);
let _e1325 = (_e1312 - 4i);
let _e1327 = select(0i, _e1325, (_e1325 > 0i));
let _e1329 = select(_e1327, _e1316, (_e1316 < _e1327));
let _e1342 = (select(0i, _e1253, (_e1253 > 0i)) * _e1274);
let _e1343 = (select(_e1287, _e1290, (_e1290 < _e1287)) * _e1274);
let _e1344 = (select(0i, _e1269, (_e1269 > 0i)) * _e1279);
let _e1345 = (select(_e1300, _e1303, (_e1303 < _e1300)) * _e1279);
local_16 = type_29(array<i32, 4>(_e1329, _e1329, _e1329, _e1329), array<u32, 6>(bitcast<u32>(((_e1316 - _e1329) * 8i)), bitcast<u32>(((select(0i, _e1237, (_e1237 > 0i)) - _e1329) * 8i)), bitcast<u32>(((select(_e1313, _e1319, (_e1319 < _e1313)) - _e1329) * 8i)), bitcast<u32>(((select(_e1313, _e1322, (_e1322 < _e1313)) - _e1329) * 8i)), 0u, 0u));
local_17 = (_e1221 - vec3<f32>(f32(_e1237), f32(_e1253), f32(_e1269)));
let _e1358 = local_16.member[0u];
let _e1359 = ((_e1344 + _e1342) + _e1358);
let _e1361 = (_e1359 >> bitcast<u32>(2i));
let _e1364 = bitcast<u32>(((_e1359 & 3i) * 8i));
let _e1366 = (bitcast<i32>(_e86) - 1i);
let _e1368 = select(_e1366, _e1361, (_e1361 < _e1366));
let _e1373 = global_1.member[bitcast<u32>(select(0i, _e1368, (_e1368 > 0i)))];
let _e1377 = (_e1361 + 1i);
let _e1379 = select(_e1366, _e1377, (_e1377 < _e1366));
let _e1384 = global_1.member[bitcast<u32>(select(0i, _e1379, (_e1379 > 0i)))];
let _e1391 = ((_e1373 >> bitcast<u32>((_e1364 & 31u))) | ((_e1384 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1364) & 31u))));
let _e1394 = local_16.member_1[1u];
let _e1400 = f32(bitcast<i32>(((_e1391 >> bitcast<u32>((_e1394 & 31u))) & 255u)));
let _e1403 = local_16.member_1[2u];
let _e1410 = local_17[0u];
let _e1413 = (_e1400 + ((f32(bitcast<i32>(((_e1391 >> bitcast<u32>((_e1403 & 31u))) & 255u))) - _e1400) * _e1410));
let _e1415 = local_16.member[0u];
let _e1416 = ((_e1344 + _e1343) + _e1415);
let _e1418 = (_e1416 >> bitcast<u32>(2i));
let _e1421 = bitcast<u32>(((_e1416 & 3i) * 8i));
let _e1423 = select(_e1366, _e1418, (_e1418 < _e1366));
let _e1428 = global_1.member[bitcast<u32>(select(0i, _e1423, (_e1423 > 0i)))];
let _e1432 = (_e1418 + 1i);
let _e1434 = select(_e1366, _e1432, (_e1432 < _e1366));
let _e1439 = global_1.member[bitcast<u32>(select(0i, _e1434, (_e1434 > 0i)))];
let _e1446 = ((_e1428 >> bitcast<u32>((_e1421 & 31u))) | ((_e1439 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1421) & 31u))));
let _e1447 = local_16.member_1[1u];
let _e1453 = f32(bitcast<i32>(((_e1446 >> bitcast<u32>((_e1447 & 31u))) & 255u)));
let _e1454 = local_16.member_1[2u];
let _e1461 = local_17[0u];
let _e1466 = local_17[1u];
let _e1469 = (_e1413 + (((_e1453 + ((f32(bitcast<i32>(((_e1446 >> bitcast<u32>((_e1454 & 31u))) & 255u))) - _e1453) * _e1461)) - _e1413) * _e1466));
let _e1471 = local_16.member[0u];
let _e1472 = ((_e1345 + _e1342) + _e1471);
let _e1474 = (_e1472 >> bitcast<u32>(2i));
let _e1477 = bitcast<u32>(((_e1472 & 3i) * 8i));
let _e1479 = select(_e1366, _e1474, (_e1474 < _e1366));
let _e1484 = global_1.member[bitcast<u32>(select(0i, _e1479, (_e1479 > 0i)))];
let _e1488 = (_e1474 + 1i);
let _e1490 = select(_e1366, _e1488, (_e1488 < _e1366));
let _e1495 = global_1.member[bitcast<u32>(select(0i, _e1490, (_e1490 > 0i)))];
let _e1502 = ((_e1484 >> bitcast<u32>((_e1477 & 31u))) | ((_e1495 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1477) & 31u))));
let _e1503 = local_16.member_1[1u];
let _e1509 = f32(bitcast<i32>(((_e1502 >> bitcast<u32>((_e1503 & 31u))) & 255u)));
let _e1510 = local_16.member_1[2u];
let _e1517 = local_17[0u];
let _e1520 = (_e1509 + ((f32(bitcast<i32>(((_e1502 >> bitcast<u32>((_e1510 & 31u))) & 255u))) - _e1509) * _e1517));
let _e1522 = local_16.member[0u];
let _e1523 = ((_e1345 + _e1343) + _e1522);
let _e1525 = (_e1523 >> bitcast<u32>(2i));
let _e1528 = bitcast<u32>(((_e1523 & 3i) * 8i));
let _e1530 = select(_e1366, _e1525, (_e1525 < _e1366));
let _e1535 = global_1.member[bitcast<u32>(select(0i, _e1530, (_e1530 > 0i)))];
let _e1539 = (_e1525 + 1i);
let _e1541 = select(_e1366, _e1539, (_e1539 < _e1366));
let _e1546 = global_1.member[bitcast<u32>(select(0i, _e1541, (_e1541 > 0i)))];
let _e1553 = ((_e1535 >> bitcast<u32>((_e1528 & 31u))) | ((_e1546 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1528) & 31u))));
let _e1554 = local_16.member_1[1u];
let _e1560 = f32(bitcast<i32>(((_e1553 >> bitcast<u32>((_e1554 & 31u))) & 255u)));
let _e1561 = local_16.member_1[2u];
let _e1568 = local_17[0u];
let _e1572 = local_17[1u];
let _e1577 = local_17[2u];
let _e1585 = global_2.member[_e369].member_8.member_8;
let _e1590 = global_2.member[_e369].member_8.member_7;
let _e1592 = (((_e1469 + (((_e1520 + (((_e1560 + ((f32(bitcast<i32>(((_e1553 >> bitcast<u32>((_e1561 & 31u))) & 255u))) - _e1560) * _e1568)) - _e1520) * _e1572)) - _e1469) * _e1577)) - _e1585) * _e1590);
let _e1593 = -(1e9f);
let _e1595 = select(_e1593, _e1592, (_e1592 > _e1593));
let _e1600 = (_e1113.member + (_e1122 * (1.5f * 0.25f)));
let _e1604 = (_e403 + (_e1117 * _e1600));
let _e1605 = (_e405 + (_e1118 * _e1600));
let _e1606 = (_e393 + (_e1119 * _e1600));
let _e1612 = ((((_e419.member.member * _e1604) + (_e419.member.member_1 * _e1605)) + (_e419.member.member_2 * _e1606)) + _e419.member_1);
let _e1618 = ((((_e435.member.member * _e1604) + (_e435.member.member_1 * _e1605)) + (_e435.member.member_2 * _e1606)) + _e435.member_1);
let _e1624 = ((((_e451.member.member * _e1604) + (_e451.member.member_1 * _e1605)) + (_e451.member.member_2 * _e1606)) + _e451.member_1);
let _e1626 = select(_e486, _e1612, (_e1612 > _e486));
let _e1628 = select(_e492, _e1626, (_e1626 < _e492));
let _e1630 = select(_e502, _e1618, (_e1618 > _e502));
let _e1632 = select(_e508, _e1630, (_e1630 < _e508));
let _e1634 = select(_e518, _e1624, (_e1624 > _e518));
let _e1636 = select(_e524, _e1634, (_e1634 < _e524));
if _e1167 {
phi_2849_ = vec3<f32>(_e1628, _e1632, _e1636);
} else {
let _e1638 = (_e1628 + 0.5f);
let _e1640 = select(0f, _e1638, (_e1638 > 0f));
let _e1642 = select(_e576, _e1640, (_e1640 < _e576));
let _e1649 = select(0i, select(select(i32(_e1642), i32(-2147483648), (_e1642 < -2147483600f)), 2147483647i, (_e1642 > 2147483500f)), (_e1642 == _e1642));
let _e1655 = (_e1632 + 0.5f);
let _e1657 = select(0f, _e1655, (_e1655 > 0f));
let _e1659 = select(_e607, _e1657, (_e1657 < _e607));
let _e1666 = select(0i, select(select(i32(_e1659), i32(-2147483648), (_e1659 < -2147483600f)), 2147483647i, (_e1659 > 2147483500f)), (_e1659 == _e1659));
let _e1672 = (_e1636 + 0.5f);
let _e1674 = select(0f, _e1672, (_e1672 > 0f));
let _e1676 = select(_e632, _e1674, (_e1674 < _e632));
let _e1683 = select(0i, select(select(i32(_e1676), i32(-2147483648), (_e1676 < -2147483600f)), 2147483647i, (_e1676 > 2147483500f)), (_e1676 == _e1676));
phi_2849_ = vec3<f32>(f32((_e1649 - select(0i, 1i, (_e1642 < f32(_e1649))))), f32((_e1666 - select(0i, 1i, (_e1659 < f32(_e1666))))), f32((_e1683 - select(0i, 1i, (_e1676 < f32(_e1683))))));
}
let _e1691 = phi_2849_;
let _e1694 = select(-1f, _e1691.x, (_e1691.x > -1f));
let _e1696 = select(_e574, _e1694, (_e1694 < _e574));
let _e1703 = select(0i, select(select(i32(_e1696), i32(-2147483648), (_e1696 < -2147483600f)), 2147483647i, (_e1696 > 2147483500f)), (_e1696 == _e1696));
let _e1707 = (_e1703 - select(0i, 1i, (_e1696 < f32(_e1703))));
let _e1710 = select(-1f, _e1691.y, (_e1691.y > -1f));
let _e1712 = select(_e605, _e1710, (_e1710 < _e605));
let _e1719 = select(0i, select(select(i32(_e1712), i32(-2147483648), (_e1712 < -2147483600f)), 2147483647i, (_e1712 > 2147483500f)), (_e1712 == _e1712));
let _e1723 = (_e1719 - select(0i, 1i, (_e1712 < f32(_e1719))));
let _e1726 = select(-1f, _e1691.z, (_e1691.z > -1f));
let _e1728 = select(_e630, _e1726, (_e1726 < _e630));
let _e1735 = select(0i, select(select(i32(_e1728), i32(-2147483648), (_e1728 < -2147483600f)), 2147483647i, (_e1728 > 2147483500f)), (_e1728 == _e1728));
let _e1739 = (_e1735 - select(0i, 1i, (_e1728 < f32(_e1735))));
let _e1742 = (_e1723 + 1i);
let _e1747 = (_e1739 + 1i);
let _e1750 = (_e1707 - 1i);
let _e1752 = select(0i, _e1750, (_e1750 > 0i));
let _e1755 = (_e1707 + 1i);
let _e1758 = (_e1707 + 2i);
let _e1762 = select(_e1327, _e1752, (_e1752 < _e1327));
let _e1775 = (select(0i, _e1723, (_e1723 > 0i)) * _e1274);
let _e1776 = (select(_e1287, _e1742, (_e1742 < _e1287)) * _e1274);
let _e1777 = (select(0i, _e1739, (_e1739 > 0i)) * _e1279);
let _e1778 = (select(_e1300, _e1747, (_e1747 < _e1300)) * _e1279);
local_14 = type_29(array<i32, 4>(_e1762, _e1762, _e1762, _e1762), array<u32, 6>(bitcast<u32>(((_e1752 - _e1762) * 8i)), bitcast<u32>(((select(0i, _e1707, (_e1707 > 0i)) - _e1762) * 8i)), bitcast<u32>(((select(_e1313, _e1755, (_e1755 < _e1313)) - _e1762) * 8i)), bitcast<u32>(((select(_e1313, _e1758, (_e1758 < _e1313)) - _e1762) * 8i)), 0u, 0u));
local_15 = (_e1691 - vec3<f32>(f32(_e1707), f32(_e1723), f32(_e1739)));
let _e1791 = local_14.member[0u];
let _e1792 = ((_e1777 + _e1775) + _e1791);
let _e1794 = (_e1792 >> bitcast<u32>(2i));
let _e1797 = bitcast<u32>(((_e1792 & 3i) * 8i));
let _e1799 = select(_e1366, _e1794, (_e1794 < _e1366));
let _e1804 = global_1.member[bitcast<u32>(select(0i, _e1799, (_e1799 > 0i)))];
let _e1808 = (_e1794 + 1i);
let _e1810 = select(_e1366, _e1808, (_e1808 < _e1366));
let _e1815 = global_1.member[bitcast<u32>(select(0i, _e1810, (_e1810 > 0i)))];
let _e1822 = ((_e1804 >> bitcast<u32>((_e1797 & 31u))) | ((_e1815 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1797) & 31u))));
let _e1825 = local_14.member_1[1u];
let _e1831 = f32(bitcast<i32>(((_e1822 >> bitcast<u32>((_e1825 & 31u))) & 255u)));
let _e1834 = local_14.member_1[2u];
let _e1841 = local_15[0u];
let _e1844 = (_e1831 + ((f32(bitcast<i32>(((_e1822 >> bitcast<u32>((_e1834 & 31u))) & 255u))) - _e1831) * _e1841));
let _e1846 = local_14.member[0u];
let _e1847 = ((_e1777 + _e1776) + _e1846);
let _e1849 = (_e1847 >> bitcast<u32>(2i));
let _e1852 = bitcast<u32>(((_e1847 & 3i) * 8i));
let _e1854 = select(_e1366, _e1849, (_e1849 < _e1366));
let _e1859 = global_1.member[bitcast<u32>(select(0i, _e1854, (_e1854 > 0i)))];
let _e1863 = (_e1849 + 1i);
let _e1865 = select(_e1366, _e1863, (_e1863 < _e1366));
let _e1870 = global_1.member[bitcast<u32>(select(0i, _e1865, (_e1865 > 0i)))];
let _e1877 = ((_e1859 >> bitcast<u32>((_e1852 & 31u))) | ((_e1870 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1852) & 31u))));
let _e1878 = local_14.member_1[1u];
let _e1884 = f32(bitcast<i32>(((_e1877 >> bitcast<u32>((_e1878 & 31u))) & 255u)));
let _e1885 = local_14.member_1[2u];
let _e1892 = local_15[0u];
let _e1897 = local_15[1u];
let _e1900 = (_e1844 + (((_e1884 + ((f32(bitcast<i32>(((_e1877 >> bitcast<u32>((_e1885 & 31u))) & 255u))) - _e1884) * _e1892)) - _e1844) * _e1897));
let _e1902 = local_14.member[0u];
let _e1903 = ((_e1778 + _e1775) + _e1902);
let _e1905 = (_e1903 >> bitcast<u32>(2i));
let _e1908 = bitcast<u32>(((_e1903 & 3i) * 8i));
let _e1910 = select(_e1366, _e1905, (_e1905 < _e1366));
let _e1915 = global_1.member[bitcast<u32>(select(0i, _e1910, (_e1910 > 0i)))];
let _e1919 = (_e1905 + 1i);
let _e1921 = select(_e1366, _e1919, (_e1919 < _e1366));
let _e1926 = global_1.member[bitcast<u32>(select(0i, _e1921, (_e1921 > 0i)))];
let _e1933 = ((_e1915 >> bitcast<u32>((_e1908 & 31u))) | ((_e1926 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1908) & 31u))));
let _e1934 = local_14.member_1[1u];
let _e1940 = f32(bitcast<i32>(((_e1933 >> bitcast<u32>((_e1934 & 31u))) & 255u)));
let _e1941 = local_14.member_1[2u];
let _e1948 = local_15[0u];
let _e1951 = (_e1940 + ((f32(bitcast<i32>(((_e1933 >> bitcast<u32>((_e1941 & 31u))) & 255u))) - _e1940) * _e1948));
let _e1953 = local_14.member[0u];
let _e1954 = ((_e1778 + _e1776) + _e1953);
let _e1956 = (_e1954 >> bitcast<u32>(2i));
let _e1959 = bitcast<u32>(((_e1954 & 3i) * 8i));
let _e1961 = select(_e1366, _e1956, (_e1956 < _e1366));
let _e1966 = global_1.member[bitcast<u32>(select(0i, _e1961, (_e1961 > 0i)))];
let _e1970 = (_e1956 + 1i);
let _e1972 = select(_e1366, _e1970, (_e1970 < _e1366));
let _e1977 = global_1.member[bitcast<u32>(select(0i, _e1972, (_e1972 > 0i)))];
let _e1984 = ((_e1966 >> bitcast<u32>((_e1959 & 31u))) | ((_e1977 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1959) & 31u))));
let _e1985 = local_14.member_1[1u];
let _e1991 = f32(bitcast<i32>(((_e1984 >> bitcast<u32>((_e1985 & 31u))) & 255u)));
let _e1992 = local_14.member_1[2u];
let _e1999 = local_15[0u];
let _e2003 = local_15[1u];
let _e2008 = local_15[2u];
let _e2013 = (((_e1900 + (((_e1951 + (((_e1991 + ((f32(bitcast<i32>(((_e1984 >> bitcast<u32>((_e1992 & 31u))) & 255u))) - _e1991) * _e1999)) - _e1951) * _e2003)) - _e1900) * _e2008)) - _e1585) * _e1590);
let _e2015 = select(_e1593, _e2013, (_e2013 > _e1593));
let _e2020 = (_e1113.member + (_e1122 * (2.5f * 0.25f)));
let _e2024 = (_e403 + (_e1117 * _e2020));
let _e2025 = (_e405 + (_e1118 * _e2020));
let _e2026 = (_e393 + (_e1119 * _e2020));
let _e2032 = ((((_e419.member.member * _e2024) + (_e419.member.member_1 * _e2025)) + (_e419.member.member_2 * _e2026)) + _e419.member_1);
let _e2038 = ((((_e435.member.member * _e2024) + (_e435.member.member_1 * _e2025)) + (_e435.member.member_2 * _e2026)) + _e435.member_1);
let _e2044 = ((((_e451.member.member * _e2024) + (_e451.member.member_1 * _e2025)) + (_e451.member.member_2 * _e2026)) + _e451.member_1);
let _e2046 = select(_e486, _e2032, (_e2032 > _e486));
let _e2048 = select(_e492, _e2046, (_e2046 < _e492));
let _e2050 = select(_e502, _e2038, (_e2038 > _e502));
let _e2052 = select(_e508, _e2050, (_e2050 < _e508));
let _e2054 = select(_e518, _e2044, (_e2044 > _e518));
let _e2056 = select(_e524, _e2054, (_e2054 < _e524));
if _e1167 {
phi_3582_ = vec3<f32>(_e2048, _e2052, _e2056);
} else {
let _e2058 = (_e2048 + 0.5f);
let _e2060 = select(0f, _e2058, (_e2058 > 0f));
let _e2062 = select(_e576, _e2060, (_e2060 < _e576));
let _e2069 = select(0i, select(select(i32(_e2062), i32(-2147483648), (_e2062 < -2147483600f)), 2147483647i, (_e2062 > 2147483500f)), (_e2062 == _e2062));
let _e2075 = (_e2052 + 0.5f);
let _e2077 = select(0f, _e2075, (_e2075 > 0f));
let _e2079 = select(_e607, _e2077, (_e2077 < _e607));
let _e2086 = select(0i, select(select(i32(_e2079), i32(-2147483648), (_e2079 < -2147483600f)), 2147483647i, (_e2079 > 2147483500f)), (_e2079 == _e2079));
let _e2092 = (_e2056 + 0.5f);
let _e2094 = select(0f, _e2092, (_e2092 > 0f));
let _e2096 = select(_e632, _e2094, (_e2094 < _e632));
let _e2103 = select(0i, select(select(i32(_e2096), i32(-2147483648), (_e2096 < -2147483600f)), 2147483647i, (_e2096 > 2147483500f)), (_e2096 == _e2096));
phi_3582_ = vec3<f32>(f32((_e2069 - select(0i, 1i, (_e2062 < f32(_e2069))))), f32((_e2086 - select(0i, 1i, (_e2079 < f32(_e2086))))), f32((_e2103 - select(0i, 1i, (_e2096 < f32(_e2103))))));
}
let _e2111 = phi_3582_;
let _e2114 = select(-1f, _e2111.x, (_e2111.x > -1f));
let _e2116 = select(_e574, _e2114, (_e2114 < _e574));
let _e2123 = select(0i, select(select(i32(_e2116), i32(-2147483648), (_e2116 < -2147483600f)), 2147483647i, (_e2116 > 2147483500f)), (_e2116 == _e2116));
let _e2127 = (_e2123 - select(0i, 1i, (_e2116 < f32(_e2123))));
let _e2130 = select(-1f, _e2111.y, (_e2111.y > -1f));
let _e2132 = select(_e605, _e2130, (_e2130 < _e605));
let _e2139 = select(0i, select(select(i32(_e2132), i32(-2147483648), (_e2132 < -2147483600f)), 2147483647i, (_e2132 > 2147483500f)), (_e2132 == _e2132));
let _e2143 = (_e2139 - select(0i, 1i, (_e2132 < f32(_e2139))));
let _e2146 = select(-1f, _e2111.z, (_e2111.z > -1f));
let _e2148 = select(_e630, _e2146, (_e2146 < _e630));
let _e2155 = select(0i, select(select(i32(_e2148), i32(-2147483648), (_e2148 < -2147483600f)), 2147483647i, (_e2148 > 2147483500f)), (_e2148 == _e2148));
let _e2159 = (_e2155 - select(0i, 1i, (_e2148 < f32(_e2155))));
let _e2162 = (_e2143 + 1i);
let _e2167 = (_e2159 + 1i);
let _e2170 = (_e2127 - 1i);
let _e2172 = select(0i, _e2170, (_e2170 > 0i));
let _e2175 = (_e2127 + 1i);
let _e2178 = (_e2127 + 2i);
let _e2182 = select(_e1327, _e2172, (_e2172 < _e1327));
let _e2195 = (select(0i, _e2143, (_e2143 > 0i)) * _e1274);
let _e2196 = (select(_e1287, _e2162, (_e2162 < _e1287)) * _e1274);
let _e2197 = (select(0i, _e2159, (_e2159 > 0i)) * _e1279);
let _e2198 = (select(_e1300, _e2167, (_e2167 < _e1300)) * _e1279);
local_12 = type_29(array<i32, 4>(_e2182, _e2182, _e2182, _e2182), array<u32, 6>(bitcast<u32>(((_e2172 - _e2182) * 8i)), bitcast<u32>(((select(0i, _e2127, (_e2127 > 0i)) - _e2182) * 8i)), bitcast<u32>(((select(_e1313, _e2175, (_e2175 < _e1313)) - _e2182) * 8i)), bitcast<u32>(((select(_e1313, _e2178, (_e2178 < _e1313)) - _e2182) * 8i)), 0u, 0u));
local_13 = (_e2111 - vec3<f32>(f32(_e2127), f32(_e2143), f32(_e2159)));
let _e2211 = local_12.member[0u];
let _e2212 = ((_e2197 + _e2195) + _e2211);
let _e2214 = (_e2212 >> bitcast<u32>(2i));
let _e2217 = bitcast<u32>(((_e2212 & 3i) * 8i));
let _e2219 = select(_e1366, _e2214, (_e2214 < _e1366));
let _e2224 = global_1.member[bitcast<u32>(select(0i, _e2219, (_e2219 > 0i)))];
let _e2228 = (_e2214 + 1i);
let _e2230 = select(_e1366, _e2228, (_e2228 < _e1366));
let _e2235 = global_1.member[bitcast<u32>(select(0i, _e2230, (_e2230 > 0i)))];
let _e2242 = ((_e2224 >> bitcast<u32>((_e2217 & 31u))) | ((_e2235 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2217) & 31u))));
let _e2245 = local_12.member_1[1u];
let _e2251 = f32(bitcast<i32>(((_e2242 >> bitcast<u32>((_e2245 & 31u))) & 255u)));
let _e2254 = local_12.member_1[2u];
let _e2261 = local_13[0u];
let _e2264 = (_e2251 + ((f32(bitcast<i32>(((_e2242 >> bitcast<u32>((_e2254 & 31u))) & 255u))) - _e2251) * _e2261));
let _e2266 = local_12.member[0u];
let _e2267 = ((_e2197 + _e2196) + _e2266);
let _e2269 = (_e2267 >> bitcast<u32>(2i));
let _e2272 = bitcast<u32>(((_e2267 & 3i) * 8i));
let _e2274 = select(_e1366, _e2269, (_e2269 < _e1366));
let _e2279 = global_1.member[bitcast<u32>(select(0i, _e2274, (_e2274 > 0i)))];
let _e2283 = (_e2269 + 1i);
let _e2285 = select(_e1366, _e2283, (_e2283 < _e1366));
let _e2290 = global_1.member[bitcast<u32>(select(0i, _e2285, (_e2285 > 0i)))];
let _e2297 = ((_e2279 >> bitcast<u32>((_e2272 & 31u))) | ((_e2290 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2272) & 31u))));
let _e2298 = local_12.member_1[1u];
let _e2304 = f32(bitcast<i32>(((_e2297 >> bitcast<u32>((_e2298 & 31u))) & 255u)));
let _e2305 = local_12.member_1[2u];
let _e2312 = local_13[0u];
let _e2317 = local_13[1u];
let _e2320 = (_e2264 + (((_e2304 + ((f32(bitcast<i32>(((_e2297 >> bitcast<u32>((_e2305 & 31u))) & 255u))) - _e2304) * _e2312)) - _e2264) * _e2317));
let _e2322 = local_12.member[0u];
let _e2323 = ((_e2198 + _e2195) + _e2322);
let _e2325 = (_e2323 >> bitcast<u32>(2i));
let _e2328 = bitcast<u32>(((_e2323 & 3i) * 8i));
let _e2330 = select(_e1366, _e2325, (_e2325 < _e1366));
let _e2335 = global_1.member[bitcast<u32>(select(0i, _e2330, (_e2330 > 0i)))];
let _e2339 = (_e2325 + 1i);
let _e2341 = select(_e1366, _e2339, (_e2339 < _e1366));
let _e2346 = global_1.member[bitcast<u32>(select(0i, _e2341, (_e2341 > 0i)))];
let _e2353 = ((_e2335 >> bitcast<u32>((_e2328 & 31u))) | ((_e2346 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2328) & 31u))));
let _e2354 = local_12.member_1[1u];
let _e2360 = f32(bitcast<i32>(((_e2353 >> bitcast<u32>((_e2354 & 31u))) & 255u)));
let _e2361 = local_12.member_1[2u];
let _e2368 = local_13[0u];
let _e2371 = (_e2360 + ((f32(bitcast<i32>(((_e2353 >> bitcast<u32>((_e2361 & 31u))) & 255u))) - _e2360) * _e2368));
let _e2373 = local_12.member[0u];
let _e2374 = ((_e2198 + _e2196) + _e2373);
let _e2376 = (_e2374 >> bitcast<u32>(2i));
let _e2379 = bitcast<u32>(((_e2374 & 3i) * 8i));
let _e2381 = select(_e1366, _e2376, (_e2376 < _e1366));
let _e2386 = global_1.member[bitcast<u32>(select(0i, _e2381, (_e2381 > 0i)))];
let _e2390 = (_e2376 + 1i);
let _e2392 = select(_e1366, _e2390, (_e2390 < _e1366));
let _e2397 = global_1.member[bitcast<u32>(select(0i, _e2392, (_e2392 > 0i)))];
let _e2404 = ((_e2386 >> bitcast<u32>((_e2379 & 31u))) | ((_e2397 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2379) & 31u))));
let _e2405 = local_12.member_1[1u];
let _e2411 = f32(bitcast<i32>(((_e2404 >> bitcast<u32>((_e2405 & 31u))) & 255u)));
let _e2412 = local_12.member_1[2u];
let _e2419 = local_13[0u];
let _e2423 = local_13[1u];
let _e2428 = local_13[2u];
let _e2433 = (((_e2320 + (((_e2371 + (((_e2411 + ((f32(bitcast<i32>(((_e2404 >> bitcast<u32>((_e2412 & 31u))) & 255u))) - _e2411) * _e2419)) - _e2371) * _e2423)) - _e2320) * _e2428)) - _e1585) * _e1590);
let _e2435 = select(_e1593, _e2433, (_e2433 > _e1593));
let _e2440 = (_e1113.member + (_e1122 * (3.5f * 0.25f)));
let _e2444 = (_e403 + (_e1117 * _e2440));
let _e2445 = (_e405 + (_e1118 * _e2440));
let _e2446 = (_e393 + (_e1119 * _e2440));
let _e2452 = ((((_e419.member.member * _e2444) + (_e419.member.member_1 * _e2445)) + (_e419.member.member_2 * _e2446)) + _e419.member_1);
let _e2458 = ((((_e435.member.member * _e2444) + (_e435.member.member_1 * _e2445)) + (_e435.member.member_2 * _e2446)) + _e435.member_1);
let _e2464 = ((((_e451.member.member * _e2444) + (_e451.member.member_1 * _e2445)) + (_e451.member.member_2 * _e2446)) + _e451.member_1);
let _e2466 = select(_e486, _e2452, (_e2452 > _e486));
let _e2468 = select(_e492, _e2466, (_e2466 < _e492));
let _e2470 = select(_e502, _e2458, (_e2458 > _e502));
let _e2472 = select(_e508, _e2470, (_e2470 < _e508));
let _e2474 = select(_e518, _e2464, (_e2464 > _e518));
let _e2476 = select(_e524, _e2474, (_e2474 < _e524));
if _e1167 {
phi_4315_ = vec3<f32>(_e2468, _e2472, _e2476);
} else {
let _e2478 = (_e2468 + 0.5f);
let _e2480 = select(0f, _e2478, (_e2478 > 0f));
let _e2482 = select(_e576, _e2480, (_e2480 < _e576));
let _e2489 = select(0i, select(select(i32(_e2482), i32(-2147483648), (_e2482 < -2147483600f)), 2147483647i, (_e2482 > 2147483500f)), (_e2482 == _e2482));
let _e2495 = (_e2472 + 0.5f);
let _e2497 = select(0f, _e2495, (_e2495 > 0f));
let _e2499 = select(_e607, _e2497, (_e2497 < _e607));
let _e2506 = select(0i, select(select(i32(_e2499), i32(-2147483648), (_e2499 < -2147483600f)), 2147483647i, (_e2499 > 2147483500f)), (_e2499 == _e2499));
let _e2512 = (_e2476 + 0.5f);
let _e2514 = select(0f, _e2512, (_e2512 > 0f));
let _e2516 = select(_e632, _e2514, (_e2514 < _e632));
let _e2523 = select(0i, select(select(i32(_e2516), i32(-2147483648), (_e2516 < -2147483600f)), 2147483647i, (_e2516 > 2147483500f)), (_e2516 == _e2516));
phi_4315_ = vec3<f32>(f32((_e2489 - select(0i, 1i, (_e2482 < f32(_e2489))))), f32((_e2506 - select(0i, 1i, (_e2499 < f32(_e2506))))), f32((_e2523 - select(0i, 1i, (_e2516 < f32(_e2523))))));
}
let _e2531 = phi_4315_;
let _e2534 = select(-1f, _e2531.x, (_e2531.x > -1f));
let _e2536 = select(_e574, _e2534, (_e2534 < _e574));
let _e2543 = select(0i, select(select(i32(_e2536), i32(-2147483648), (_e2536 < -2147483600f)), 2147483647i, (_e2536 > 2147483500f)), (_e2536 == _e2536));
let _e2547 = (_e2543 - select(0i, 1i, (_e2536 < f32(_e2543))));
let _e2550 = select(-1f, _e2531.y, (_e2531.y > -1f));
let _e2552 = select(_e605, _e2550, (_e2550 < _e605));
let _e2559 = select(0i, select(select(i32(_e2552), i32(-2147483648), (_e2552 < -2147483600f)), 2147483647i, (_e2552 > 2147483500f)), (_e2552 == _e2552));
let _e2563 = (_e2559 - select(0i, 1i, (_e2552 < f32(_e2559))));
let _e2566 = select(-1f, _e2531.z, (_e2531.z > -1f));
let _e2568 = select(_e630, _e2566, (_e2566 < _e630));
let _e2575 = select(0i, select(select(i32(_e2568), i32(-2147483648), (_e2568 < -2147483600f)), 2147483647i, (_e2568 > 2147483500f)), (_e2568 == _e2568));
let _e2579 = (_e2575 - select(0i, 1i, (_e2568 < f32(_e2575))));
let _e2582 = (_e2563 + 1i);
let _e2587 = (_e2579 + 1i);
let _e2590 = (_e2547 - 1i);
let _e2592 = select(0i, _e2590, (_e2590 > 0i));
let _e2595 = (_e2547 + 1i);
let _e2598 = (_e2547 + 2i);
let _e2602 = select(_e1327, _e2592, (_e2592 < _e1327));
let _e2615 = (select(0i, _e2563, (_e2563 > 0i)) * _e1274);
let _e2616 = (select(_e1287, _e2582, (_e2582 < _e1287)) * _e1274);
let _e2617 = (select(0i, _e2579, (_e2579 > 0i)) * _e1279);
let _e2618 = (select(_e1300, _e2587, (_e2587 < _e1300)) * _e1279);
local_10 = type_29(array<i32, 4>(_e2602, _e2602, _e2602, _e2602), array<u32, 6>(bitcast<u32>(((_e2592 - _e2602) * 8i)), bitcast<u32>(((select(0i, _e2547, (_e2547 > 0i)) - _e2602) * 8i)), bitcast<u32>(((select(_e1313, _e2595, (_e2595 < _e1313)) - _e2602) * 8i)), bitcast<u32>(((select(_e1313, _e2598, (_e2598 < _e1313)) - _e2602) * 8i)), 0u, 0u));
local_11 = (_e2531 - vec3<f32>(f32(_e2547), f32(_e2563), f32(_e2579)));
let _e2631 = local_10.member[0u];
let _e2632 = ((_e2617 + _e2615) + _e2631);
let _e2634 = (_e2632 >> bitcast<u32>(2i));
let _e2637 = bitcast<u32>(((_e2632 & 3i) * 8i));
let _e2639 = select(_e1366, _e2634, (_e2634 < _e1366));
let _e2644 = global_1.member[bitcast<u32>(select(0i, _e2639, (_e2639 > 0i)))];
let _e2648 = (_e2634 + 1i);
let _e2650 = select(_e1366, _e2648, (_e2648 < _e1366));
let _e2655 = global_1.member[bitcast<u32>(select(0i, _e2650, (_e2650 > 0i)))];
let _e2662 = ((_e2644 >> bitcast<u32>((_e2637 & 31u))) | ((_e2655 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2637) & 31u))));
let _e2665 = local_10.member_1[1u];
let _e2671 = f32(bitcast<i32>(((_e2662 >> bitcast<u32>((_e2665 & 31u))) & 255u)));
let _e2674 = local_10.member_1[2u];
let _e2681 = local_11[0u];
let _e2684 = (_e2671 + ((f32(bitcast<i32>(((_e2662 >> bitcast<u32>((_e2674 & 31u))) & 255u))) - _e2671) * _e2681));
let _e2686 = local_10.member[0u];
let _e2687 = ((_e2617 + _e2616) + _e2686);
let _e2689 = (_e2687 >> bitcast<u32>(2i));
let _e2692 = bitcast<u32>(((_e2687 & 3i) * 8i));
let _e2694 = select(_e1366, _e2689, (_e2689 < _e1366));
let _e2699 = global_1.member[bitcast<u32>(select(0i, _e2694, (_e2694 > 0i)))];
let _e2703 = (_e2689 + 1i);
let _e2705 = select(_e1366, _e2703, (_e2703 < _e1366));
let _e2710 = global_1.member[bitcast<u32>(select(0i, _e2705, (_e2705 > 0i)))];
let _e2717 = ((_e2699 >> bitcast<u32>((_e2692 & 31u))) | ((_e2710 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2692) & 31u))));
let _e2718 = local_10.member_1[1u];
let _e2724 = f32(bitcast<i32>(((_e2717 >> bitcast<u32>((_e2718 & 31u))) & 255u)));
let _e2725 = local_10.member_1[2u];
let _e2732 = local_11[0u];
let _e2737 = local_11[1u];
let _e2740 = (_e2684 + (((_e2724 + ((f32(bitcast<i32>(((_e2717 >> bitcast<u32>((_e2725 & 31u))) & 255u))) - _e2724) * _e2732)) - _e2684) * _e2737));
let _e2742 = local_10.member[0u];
let _e2743 = ((_e2618 + _e2615) + _e2742);
let _e2745 = (_e2743 >> bitcast<u32>(2i));
let _e2748 = bitcast<u32>(((_e2743 & 3i) * 8i));
let _e2750 = select(_e1366, _e2745, (_e2745 < _e1366));
let _e2755 = global_1.member[bitcast<u32>(select(0i, _e2750, (_e2750 > 0i)))];
let _e2759 = (_e2745 + 1i);
let _e2761 = select(_e1366, _e2759, (_e2759 < _e1366));
let _e2766 = global_1.member[bitcast<u32>(select(0i, _e2761, (_e2761 > 0i)))];
let _e2773 = ((_e2755 >> bitcast<u32>((_e2748 & 31u))) | ((_e2766 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2748) & 31u))));
let _e2774 = local_10.member_1[1u];
let _e2780 = f32(bitcast<i32>(((_e2773 >> bitcast<u32>((_e2774 & 31u))) & 255u)));
let _e2781 = local_10.member_1[2u];
let _e2788 = local_11[0u];
let _e2791 = (_e2780 + ((f32(bitcast<i32>(((_e2773 >> bitcast<u32>((_e2781 & 31u))) & 255u))) - _e2780) * _e2788));
let _e2793 = local_10.member[0u];
let _e2794 = ((_e2618 + _e2616) + _e2793);
let _e2796 = (_e2794 >> bitcast<u32>(2i));
let _e2799 = bitcast<u32>(((_e2794 & 3i) * 8i));
let _e2801 = select(_e1366, _e2796, (_e2796 < _e1366));
let _e2806 = global_1.member[bitcast<u32>(select(0i, _e2801, (_e2801 > 0i)))];
let _e2810 = (_e2796 + 1i);
let _e2812 = select(_e1366, _e2810, (_e2810 < _e1366));
let _e2817 = global_1.member[bitcast<u32>(select(0i, _e2812, (_e2812 > 0i)))];
let _e2824 = ((_e2806 >> bitcast<u32>((_e2799 & 31u))) | ((_e2817 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2799) & 31u))));
let _e2825 = local_10.member_1[1u];
let _e2831 = f32(bitcast<i32>(((_e2824 >> bitcast<u32>((_e2825 & 31u))) & 255u)));
let _e2832 = local_10.member_1[2u];
let _e2839 = local_11[0u];
let _e2843 = local_11[1u];
let _e2848 = local_11[2u];
let _e2853 = (((_e2740 + (((_e2791 + (((_e2831 + ((f32(bitcast<i32>(((_e2824 >> bitcast<u32>((_e2832 & 31u))) & 255u))) - _e2831) * _e2839)) - _e2791) * _e2843)) - _e2740) * _e2848)) - _e1585) * _e1590);
let _e2855 = select(_e1593, _e2853, (_e2853 > _e1593));
let _e2862 = (((_e1117 * _e1117) + (_e1118 * _e1118)) + (_e1119 * _e1119));
let _e2867 = select(0f, (sqrt(select(0f, _e2862, (_e2862 > 0f))) * _e1122), _e1116);
phi_8626_ = (_e373[8] + _e2867);
phi_8627_ = (_e373[6] + ((((select(1e9f, _e1595, (_e1595 < 1e9f)) + select(1e9f, _e2015, (_e2015 < 1e9f))) + (select(1e9f, _e2435, (_e2435 < 1e9f)) + select(1e9f, _e2855, (_e2855 < 1e9f)))) * 0.25f) * _e2867));
} else {
if _e687 {
phi_4876_ = -(2e9f);
} else {
phi_4876_ = 2e9f;
}
let _e2877 = phi_4876_;
let _e2878 = select(_e373[6], _e2877, _e686);
let _e2879 = (_e1113.member_1 - _e1113.member);
let _e2881 = (_e1113.member + (_e2879 * 0f));
let _e2885 = (_e403 + (_e1117 * _e2881));
let _e2886 = (_e405 + (_e1118 * _e2881));
let _e2887 = (_e393 + (_e1119 * _e2881));
let _e2893 = ((((_e419.member.member * _e2885) + (_e419.member.member_1 * _e2886)) + (_e419.member.member_2 * _e2887)) + _e419.member_1);
let _e2899 = ((((_e435.member.member * _e2885) + (_e435.member.member_1 * _e2886)) + (_e435.member.member_2 * _e2887)) + _e435.member_1);
let _e2905 = ((((_e451.member.member * _e2885) + (_e451.member.member_1 * _e2886)) + (_e451.member.member_2 * _e2887)) + _e451.member_1);
let _e2907 = select(_e486, _e2893, (_e2893 > _e486));
let _e2909 = select(_e492, _e2907, (_e2907 < _e492));
let _e2911 = select(_e502, _e2899, (_e2899 > _e502));
let _e2913 = select(_e508, _e2911, (_e2911 < _e508));
let _e2915 = select(_e518, _e2905, (_e2905 > _e518));
let _e2917 = select(_e524, _e2915, (_e2915 < _e524));
let _e2923 = global_2.member[_e369].member_8.member_15;
let _e2924 = (_e2923 == 0u);
if _e2924 {
phi_5084_ = vec3<f32>(_e2909, _e2913, _e2917);
} else {
let _e2925 = (_e2909 + 0.5f);
let _e2927 = select(0f, _e2925, (_e2925 > 0f));
let _e2929 = select(_e576, _e2927, (_e2927 < _e576));
let _e2936 = select(0i, select(select(i32(_e2929), i32(-2147483648), (_e2929 < -2147483600f)), 2147483647i, (_e2929 > 2147483500f)), (_e2929 == _e2929));
let _e2942 = (_e2913 + 0.5f);
let _e2944 = select(0f, _e2942, (_e2942 > 0f));
let _e2946 = select(_e607, _e2944, (_e2944 < _e607));
let _e2953 = select(0i, select(select(i32(_e2946), i32(-2147483648), (_e2946 < -2147483600f)), 2147483647i, (_e2946 > 2147483500f)), (_e2946 == _e2946));
let _e2959 = (_e2917 + 0.5f);
let _e2961 = select(0f, _e2959, (_e2959 > 0f));
let _e2963 = select(_e632, _e2961, (_e2961 < _e632));
let _e2970 = select(0i, select(select(i32(_e2963), i32(-2147483648), (_e2963 < -2147483600f)), 2147483647i, (_e2963 > 2147483500f)), (_e2963 == _e2963));
phi_5084_ = vec3<f32>(f32((_e2936 - select(0i, 1i, (_e2929 < f32(_e2936))))), f32((_e2953 - select(0i, 1i, (_e2946 < f32(_e2953))))), f32((_e2970 - select(0i, 1i, (_e2963 < f32(_e2970))))));
}
let _e2978 = phi_5084_;
let _e2981 = select(-1f, _e2978.x, (_e2978.x > -1f));
let _e2983 = select(_e574, _e2981, (_e2981 < _e574));
let _e2990 = select(0i, select(select(i32(_e2983), i32(-2147483648), (_e2983 < -2147483600f)), 2147483647i, (_e2983 > 2147483500f)), (_e2983 == _e2983));
let _e2994 = (_e2990 - select(0i, 1i, (_e2983 < f32(_e2990))));
let _e2997 = select(-1f, _e2978.y, (_e2978.y > -1f));
let _e2999 = select(_e605, _e2997, (_e2997 < _e605));
let _e3006 = select(0i, select(select(i32(_e2999), i32(-2147483648), (_e2999 < -2147483600f)), 2147483647i, (_e2999 > 2147483500f)), (_e2999 == _e2999));
let _e3010 = (_e3006 - select(0i, 1i, (_e2999 < f32(_e3006))));
let _e3013 = select(-1f, _e2978.z, (_e2978.z > -1f));
let _e3015 = select(_e630, _e3013, (_e3013 < _e630));
let _e3022 = select(0i, select(select(i32(_e3015), i32(-2147483648), (_e3015 < -2147483600f)), 2147483647i, (_e3015 > 2147483500f)), (_e3015 == _e3015));
let _e3026 = (_e3022 - select(0i, 1i, (_e3015 < f32(_e3022))));
let _e3031 = global_2.member[_e369].member_8.member_9;
let _e3036 = global_2.member[_e369].member_8.member_10;
let _e3044 = (select(0i, select(select(i32(_e605), i32(-2147483648), (_e605 < -2147483600f)), 2147483647i, (_e605 > 2147483500f)), (_e605 == _e605)) - 1i);
let _e3047 = (_e3010 + 1i);
let _e3057 = (select(0i, select(select(i32(_e630), i32(-2147483648), (_e630 < -2147483600f)), 2147483647i, (_e630 > 2147483500f)), (_e630 == _e630)) - 1i);
let _e3060 = (_e3026 + 1i);
let _e3069 = select(0i, select(select(i32(_e574), i32(-2147483648), (_e574 < -2147483600f)), 2147483647i, (_e574 > 2147483500f)), (_e574 == _e574));
let _e3070 = (_e3069 - 1i);
let _e3071 = (_e2994 - 1i);
let _e3073 = select(0i, _e3071, (_e3071 > 0i));
let _e3076 = (_e2994 + 1i);
let _e3079 = (_e2994 + 2i);
let _e3082 = (_e3069 - 4i);
let _e3084 = select(0i, _e3082, (_e3082 > 0i));
let _e3086 = select(_e3084, _e3073, (_e3073 < _e3084));
let _e3099 = (select(0i, _e3010, (_e3010 > 0i)) * _e3031);
let _e3100 = (select(_e3044, _e3047, (_e3047 < _e3044)) * _e3031);
let _e3101 = (select(0i, _e3026, (_e3026 > 0i)) * _e3036);
let _e3102 = (select(_e3057, _e3060, (_e3060 < _e3057)) * _e3036);
local_8 = type_29(array<i32, 4>(_e3086, _e3086, _e3086, _e3086), array<u32, 6>(bitcast<u32>(((_e3073 - _e3086) * 8i)), bitcast<u32>(((select(0i, _e2994, (_e2994 > 0i)) - _e3086) * 8i)), bitcast<u32>(((select(_e3070, _e3076, (_e3076 < _e3070)) - _e3086) * 8i)), bitcast<u32>(((select(_e3070, _e3079, (_e3079 < _e3070)) - _e3086) * 8i)), 0u, 0u));
local_9 = (_e2978 - vec3<f32>(f32(_e2994), f32(_e3010), f32(_e3026)));
let _e3115 = local_8.member[0u];
let _e3116 = ((_e3101 + _e3099) + _e3115);
let _e3118 = (_e3116 >> bitcast<u32>(2i));
let _e3121 = bitcast<u32>(((_e3116 & 3i) * 8i));
let _e3123 = (bitcast<i32>(_e86) - 1i);
let _e3125 = select(_e3123, _e3118, (_e3118 < _e3123));
let _e3130 = global_1.member[bitcast<u32>(select(0i, _e3125, (_e3125 > 0i)))];
let _e3134 = (_e3118 + 1i);
let _e3136 = select(_e3123, _e3134, (_e3134 < _e3123));
let _e3141 = global_1.member[bitcast<u32>(select(0i, _e3136, (_e3136 > 0i)))];
let _e3148 = ((_e3130 >> bitcast<u32>((_e3121 & 31u))) | ((_e3141 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3121) & 31u))));
let _e3151 = local_8.member_1[1u];
let _e3157 = f32(bitcast<i32>(((_e3148 >> bitcast<u32>((_e3151 & 31u))) & 255u)));
let _e3160 = local_8.member_1[2u];
let _e3167 = local_9[0u];
let _e3170 = (_e3157 + ((f32(bitcast<i32>(((_e3148 >> bitcast<u32>((_e3160 & 31u))) & 255u))) - _e3157) * _e3167));
let _e3172 = local_8.member[0u];
let _e3173 = ((_e3101 + _e3100) + _e3172);
let _e3175 = (_e3173 >> bitcast<u32>(2i));
let _e3178 = bitcast<u32>(((_e3173 & 3i) * 8i));
let _e3180 = select(_e3123, _e3175, (_e3175 < _e3123));
let _e3185 = global_1.member[bitcast<u32>(select(0i, _e3180, (_e3180 > 0i)))];
let _e3189 = (_e3175 + 1i);
let _e3191 = select(_e3123, _e3189, (_e3189 < _e3123));
let _e3196 = global_1.member[bitcast<u32>(select(0i, _e3191, (_e3191 > 0i)))];
let _e3203 = ((_e3185 >> bitcast<u32>((_e3178 & 31u))) | ((_e3196 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3178) & 31u))));
let _e3204 = local_8.member_1[1u];
let _e3210 = f32(bitcast<i32>(((_e3203 >> bitcast<u32>((_e3204 & 31u))) & 255u)));
let _e3211 = local_8.member_1[2u];
let _e3218 = local_9[0u];
let _e3223 = local_9[1u];
let _e3226 = (_e3170 + (((_e3210 + ((f32(bitcast<i32>(((_e3203 >> bitcast<u32>((_e3211 & 31u))) & 255u))) - _e3210) * _e3218)) - _e3170) * _e3223));
let _e3228 = local_8.member[0u];
let _e3229 = ((_e3102 + _e3099) + _e3228);
let _e3231 = (_e3229 >> bitcast<u32>(2i));
let _e3234 = bitcast<u32>(((_e3229 & 3i) * 8i));
let _e3236 = select(_e3123, _e3231, (_e3231 < _e3123));
let _e3241 = global_1.member[bitcast<u32>(select(0i, _e3236, (_e3236 > 0i)))];
let _e3245 = (_e3231 + 1i);
let _e3247 = select(_e3123, _e3245, (_e3245 < _e3123));
let _e3252 = global_1.member[bitcast<u32>(select(0i, _e3247, (_e3247 > 0i)))];
let _e3259 = ((_e3241 >> bitcast<u32>((_e3234 & 31u))) | ((_e3252 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3234) & 31u))));
let _e3260 = local_8.member_1[1u];
let _e3266 = f32(bitcast<i32>(((_e3259 >> bitcast<u32>((_e3260 & 31u))) & 255u)));
let _e3267 = local_8.member_1[2u];
let _e3274 = local_9[0u];
let _e3277 = (_e3266 + ((f32(bitcast<i32>(((_e3259 >> bitcast<u32>((_e3267 & 31u))) & 255u))) - _e3266) * _e3274));
let _e3279 = local_8.member[0u];
let _e3280 = ((_e3102 + _e3100) + _e3279);
let _e3282 = (_e3280 >> bitcast<u32>(2i));
let _e3285 = bitcast<u32>(((_e3280 & 3i) * 8i));
let _e3287 = select(_e3123, _e3282, (_e3282 < _e3123));
let _e3292 = global_1.member[bitcast<u32>(select(0i, _e3287, (_e3287 > 0i)))];
let _e3296 = (_e3282 + 1i);
let _e3298 = select(_e3123, _e3296, (_e3296 < _e3123));
let _e3303 = global_1.member[bitcast<u32>(select(0i, _e3298, (_e3298 > 0i)))];
let _e3310 = ((_e3292 >> bitcast<u32>((_e3285 & 31u))) | ((_e3303 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3285) & 31u))));
let _e3311 = local_8.member_1[1u];
let _e3317 = f32(bitcast<i32>(((_e3310 >> bitcast<u32>((_e3311 & 31u))) & 255u)));
let _e3318 = local_8.member_1[2u];
let _e3325 = local_9[0u];
let _e3329 = local_9[1u];
let _e3334 = local_9[2u];
let _e3342 = global_2.member[_e369].member_8.member_8;
let _e3347 = global_2.member[_e369].member_8.member_7;
let _e3349 = (((_e3226 + (((_e3277 + (((_e3317 + ((f32(bitcast<i32>(((_e3310 >> bitcast<u32>((_e3318 & 31u))) & 255u))) - _e3317) * _e3325)) - _e3277) * _e3329)) - _e3226) * _e3334)) - _e3342) * _e3347);
let _e3350 = -(1e9f);
let _e3352 = select(_e3350, _e3349, (_e3349 > _e3350));
let _e3354 = select(1e9f, _e3352, (_e3352 < 1e9f));
if _e687 {
phi_5622_ = (_e3354 > _e2878);
} else {
phi_5622_ = (_e3354 < _e2878);
}
let _e3361 = phi_5622_;
let _e3362 = ((_e1116 && (_e686 || (_e1113.member > 0f))) && _e3361);
let _e3363 = select(_e2878, _e3354, _e3362);
let _e3366 = (_e1113.member + (_e2879 * 0.25f));
let _e3370 = (_e403 + (_e1117 * _e3366));
let _e3371 = (_e405 + (_e1118 * _e3366));
let _e3372 = (_e393 + (_e1119 * _e3366));
let _e3378 = ((((_e419.member.member * _e3370) + (_e419.member.member_1 * _e3371)) + (_e419.member.member_2 * _e3372)) + _e419.member_1);
let _e3384 = ((((_e435.member.member * _e3370) + (_e435.member.member_1 * _e3371)) + (_e435.member.member_2 * _e3372)) + _e435.member_1);
let _e3390 = ((((_e451.member.member * _e3370) + (_e451.member.member_1 * _e3371)) + (_e451.member.member_2 * _e3372)) + _e451.member_1);
let _e3392 = select(_e486, _e3378, (_e3378 > _e486));
let _e3394 = select(_e492, _e3392, (_e3392 < _e492));
let _e3396 = select(_e502, _e3384, (_e3384 > _e502));
let _e3398 = select(_e508, _e3396, (_e3396 < _e508));
let _e3400 = select(_e518, _e3390, (_e3390 > _e518));
let _e3402 = select(_e524, _e3400, (_e3400 < _e524));
if _e2924 {
phi_5835_ = vec3<f32>(_e3394, _e3398, _e3402);
} else {
let _e3404 = (_e3394 + 0.5f);
let _e3406 = select(0f, _e3404, (_e3404 > 0f));
let _e3408 = select(_e576, _e3406, (_e3406 < _e576));
let _e3415 = select(0i, select(select(i32(_e3408), i32(-2147483648), (_e3408 < -2147483600f)), 2147483647i, (_e3408 > 2147483500f)), (_e3408 == _e3408));
let _e3421 = (_e3398 + 0.5f);
let _e3423 = select(0f, _e3421, (_e3421 > 0f));
let _e3425 = select(_e607, _e3423, (_e3423 < _e607));
let _e3432 = select(0i, select(select(i32(_e3425), i32(-2147483648), (_e3425 < -2147483600f)), 2147483647i, (_e3425 > 2147483500f)), (_e3425 == _e3425));
let _e3438 = (_e3402 + 0.5f);
let _e3440 = select(0f, _e3438, (_e3438 > 0f));
let _e3442 = select(_e632, _e3440, (_e3440 < _e632));
let _e3449 = select(0i, select(select(i32(_e3442), i32(-2147483648), (_e3442 < -2147483600f)), 2147483647i, (_e3442 > 2147483500f)), (_e3442 == _e3442));
phi_5835_ = vec3<f32>(f32((_e3415 - select(0i, 1i, (_e3408 < f32(_e3415))))), f32((_e3432 - select(0i, 1i, (_e3425 < f32(_e3432))))), f32((_e3449 - select(0i, 1i, (_e3442 < f32(_e3449))))));
}
let _e3457 = phi_5835_;
let _e3460 = select(-1f, _e3457.x, (_e3457.x > -1f));
let _e3462 = select(_e574, _e3460, (_e3460 < _e574));
let _e3469 = select(0i, select(select(i32(_e3462), i32(-2147483648), (_e3462 < -2147483600f)), 2147483647i, (_e3462 > 2147483500f)), (_e3462 == _e3462));
let _e3473 = (_e3469 - select(0i, 1i, (_e3462 < f32(_e3469))));
let _e3476 = select(-1f, _e3457.y, (_e3457.y > -1f));
let _e3478 = select(_e605, _e3476, (_e3476 < _e605));
let _e3485 = select(0i, select(select(i32(_e3478), i32(-2147483648), (_e3478 < -2147483600f)), 2147483647i, (_e3478 > 2147483500f)), (_e3478 == _e3478));
let _e3489 = (_e3485 - select(0i, 1i, (_e3478 < f32(_e3485))));
let _e3492 = select(-1f, _e3457.z, (_e3457.z > -1f));
let _e3494 = select(_e630, _e3492, (_e3492 < _e630));
let _e3501 = select(0i, select(select(i32(_e3494), i32(-2147483648), (_e3494 < -2147483600f)), 2147483647i, (_e3494 > 2147483500f)), (_e3494 == _e3494));
let _e3505 = (_e3501 - select(0i, 1i, (_e3494 < f32(_e3501))));
let _e3508 = (_e3489 + 1i);
let _e3513 = (_e3505 + 1i);
let _e3516 = (_e3473 - 1i);
let _e3518 = select(0i, _e3516, (_e3516 > 0i));
let _e3521 = (_e3473 + 1i);
let _e3524 = (_e3473 + 2i);
let _e3528 = select(_e3084, _e3518, (_e3518 < _e3084));
let _e3541 = (select(0i, _e3489, (_e3489 > 0i)) * _e3031);
let _e3542 = (select(_e3044, _e3508, (_e3508 < _e3044)) * _e3031);
let _e3543 = (select(0i, _e3505, (_e3505 > 0i)) * _e3036);
let _e3544 = (select(_e3057, _e3513, (_e3513 < _e3057)) * _e3036);
local_6 = type_29(array<i32, 4>(_e3528, _e3528, _e3528, _e3528), array<u32, 6>(bitcast<u32>(((_e3518 - _e3528) * 8i)), bitcast<u32>(((select(0i, _e3473, (_e3473 > 0i)) - _e3528) * 8i)), bitcast<u32>(((select(_e3070, _e3521, (_e3521 < _e3070)) - _e3528) * 8i)), bitcast<u32>(((select(_e3070, _e3524, (_e3524 < _e3070)) - _e3528) * 8i)), 0u, 0u));
local_7 = (_e3457 - vec3<f32>(f32(_e3473), f32(_e3489), f32(_e3505)));
let _e3557 = local_6.member[0u];
let _e3558 = ((_e3543 + _e3541) + _e3557);
let _e3560 = (_e3558 >> bitcast<u32>(2i));
let _e3563 = bitcast<u32>(((_e3558 & 3i) * 8i));
let _e3565 = select(_e3123, _e3560, (_e3560 < _e3123));
let _e3570 = global_1.member[bitcast<u32>(select(0i, _e3565, (_e3565 > 0i)))];
let _e3574 = (_e3560 + 1i);
let _e3576 = select(_e3123, _e3574, (_e3574 < _e3123));
let _e3581 = global_1.member[bitcast<u32>(select(0i, _e3576, (_e3576 > 0i)))];
let _e3588 = ((_e3570 >> bitcast<u32>((_e3563 & 31u))) | ((_e3581 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3563) & 31u))));
let _e3591 = local_6.member_1[1u];
let _e3597 = f32(bitcast<i32>(((_e3588 >> bitcast<u32>((_e3591 & 31u))) & 255u)));
let _e3600 = local_6.member_1[2u];
let _e3607 = local_7[0u];
let _e3610 = (_e3597 + ((f32(bitcast<i32>(((_e3588 >> bitcast<u32>((_e3600 & 31u))) & 255u))) - _e3597) * _e3607));
let _e3612 = local_6.member[0u];
let _e3613 = ((_e3543 + _e3542) + _e3612);
let _e3615 = (_e3613 >> bitcast<u32>(2i));
let _e3618 = bitcast<u32>(((_e3613 & 3i) * 8i));
let _e3620 = select(_e3123, _e3615, (_e3615 < _e3123));
let _e3625 = global_1.member[bitcast<u32>(select(0i, _e3620, (_e3620 > 0i)))];
let _e3629 = (_e3615 + 1i);
let _e3631 = select(_e3123, _e3629, (_e3629 < _e3123));
let _e3636 = global_1.member[bitcast<u32>(select(0i, _e3631, (_e3631 > 0i)))];
let _e3643 = ((_e3625 >> bitcast<u32>((_e3618 & 31u))) | ((_e3636 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3618) & 31u))));
let _e3644 = local_6.member_1[1u];
let _e3650 = f32(bitcast<i32>(((_e3643 >> bitcast<u32>((_e3644 & 31u))) & 255u)));
let _e3651 = local_6.member_1[2u];
let _e3658 = local_7[0u];
let _e3663 = local_7[1u];
let _e3666 = (_e3610 + (((_e3650 + ((f32(bitcast<i32>(((_e3643 >> bitcast<u32>((_e3651 & 31u))) & 255u))) - _e3650) * _e3658)) - _e3610) * _e3663));
let _e3668 = local_6.member[0u];
let _e3669 = ((_e3544 + _e3541) + _e3668);
let _e3671 = (_e3669 >> bitcast<u32>(2i));
let _e3674 = bitcast<u32>(((_e3669 & 3i) * 8i));
let _e3676 = select(_e3123, _e3671, (_e3671 < _e3123));
let _e3681 = global_1.member[bitcast<u32>(select(0i, _e3676, (_e3676 > 0i)))];
let _e3685 = (_e3671 + 1i);
let _e3687 = select(_e3123, _e3685, (_e3685 < _e3123));
let _e3692 = global_1.member[bitcast<u32>(select(0i, _e3687, (_e3687 > 0i)))];
let _e3699 = ((_e3681 >> bitcast<u32>((_e3674 & 31u))) | ((_e3692 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3674) & 31u))));
let _e3700 = local_6.member_1[1u];
let _e3706 = f32(bitcast<i32>(((_e3699 >> bitcast<u32>((_e3700 & 31u))) & 255u)));
let _e3707 = local_6.member_1[2u];
let _e3714 = local_7[0u];
let _e3717 = (_e3706 + ((f32(bitcast<i32>(((_e3699 >> bitcast<u32>((_e3707 & 31u))) & 255u))) - _e3706) * _e3714));
let _e3719 = local_6.member[0u];
let _e3720 = ((_e3544 + _e3542) + _e3719);
let _e3722 = (_e3720 >> bitcast<u32>(2i));
let _e3725 = bitcast<u32>(((_e3720 & 3i) * 8i));
let _e3727 = select(_e3123, _e3722, (_e3722 < _e3123));
let _e3732 = global_1.member[bitcast<u32>(select(0i, _e3727, (_e3727 > 0i)))];
let _e3736 = (_e3722 + 1i);
let _e3738 = select(_e3123, _e3736, (_e3736 < _e3123));
let _e3743 = global_1.member[bitcast<u32>(select(0i, _e3738, (_e3738 > 0i)))];
let _e3750 = ((_e3732 >> bitcast<u32>((_e3725 & 31u))) | ((_e3743 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3725) & 31u))));
let _e3751 = local_6.member_1[1u];
let _e3757 = f32(bitcast<i32>(((_e3750 >> bitcast<u32>((_e3751 & 31u))) & 255u)));
let _e3758 = local_6.member_1[2u];
let _e3765 = local_7[0u];
let _e3769 = local_7[1u];
let _e3774 = local_7[2u];
let _e3779 = (((_e3666 + (((_e3717 + (((_e3757 + ((f32(bitcast<i32>(((_e3750 >> bitcast<u32>((_e3758 & 31u))) & 255u))) - _e3757) * _e3765)) - _e3717) * _e3769)) - _e3666) * _e3774)) - _e3342) * _e3347);
let _e3781 = select(_e3350, _e3779, (_e3779 > _e3350));
let _e3783 = select(1e9f, _e3781, (_e3781 < 1e9f));
if _e687 {
phi_6370_ = (_e3783 > _e3363);
} else {
phi_6370_ = (_e3783 < _e3363);
}
let _e3787 = phi_6370_;
let _e3788 = (_e1116 && _e3787);
let _e3789 = select(_e3363, _e3783, _e3788);
let _e3793 = (_e1113.member + (_e2879 * (2f * 0.25f)));
let _e3797 = (_e403 + (_e1117 * _e3793));
let _e3798 = (_e405 + (_e1118 * _e3793));
let _e3799 = (_e393 + (_e1119 * _e3793));
let _e3805 = ((((_e419.member.member * _e3797) + (_e419.member.member_1 * _e3798)) + (_e419.member.member_2 * _e3799)) + _e419.member_1);
let _e3811 = ((((_e435.member.member * _e3797) + (_e435.member.member_1 * _e3798)) + (_e435.member.member_2 * _e3799)) + _e435.member_1);
let _e3817 = ((((_e451.member.member * _e3797) + (_e451.member.member_1 * _e3798)) + (_e451.member.member_2 * _e3799)) + _e451.member_1);
let _e3819 = select(_e486, _e3805, (_e3805 > _e486));
let _e3821 = select(_e492, _e3819, (_e3819 < _e492));
let _e3823 = select(_e502, _e3811, (_e3811 > _e502));
let _e3825 = select(_e508, _e3823, (_e3823 < _e508));
let _e3827 = select(_e518, _e3817, (_e3817 > _e518));
let _e3829 = select(_e524, _e3827, (_e3827 < _e524));
if _e2924 {
phi_6584_ = vec3<f32>(_e3821, _e3825, _e3829);
} else {
let _e3831 = (_e3821 + 0.5f);
let _e3833 = select(0f, _e3831, (_e3831 > 0f));
let _e3835 = select(_e576, _e3833, (_e3833 < _e576));
let _e3842 = select(0i, select(select(i32(_e3835), i32(-2147483648), (_e3835 < -2147483600f)), 2147483647i, (_e3835 > 2147483500f)), (_e3835 == _e3835));
let _e3848 = (_e3825 + 0.5f);
let _e3850 = select(0f, _e3848, (_e3848 > 0f));
let _e3852 = select(_e607, _e3850, (_e3850 < _e607));
let _e3859 = select(0i, select(select(i32(_e3852), i32(-2147483648), (_e3852 < -2147483600f)), 2147483647i, (_e3852 > 2147483500f)), (_e3852 == _e3852));
let _e3865 = (_e3829 + 0.5f);
let _e3867 = select(0f, _e3865, (_e3865 > 0f));
let _e3869 = select(_e632, _e3867, (_e3867 < _e632));
let _e3876 = select(0i, select(select(i32(_e3869), i32(-2147483648), (_e3869 < -2147483600f)), 2147483647i, (_e3869 > 2147483500f)), (_e3869 == _e3869));
phi_6584_ = vec3<f32>(f32((_e3842 - select(0i, 1i, (_e3835 < f32(_e3842))))), f32((_e3859 - select(0i, 1i, (_e3852 < f32(_e3859))))), f32((_e3876 - select(0i, 1i, (_e3869 < f32(_e3876))))));
}
let _e3884 = phi_6584_;
let _e3887 = select(-1f, _e3884.x, (_e3884.x > -1f));
let _e3889 = select(_e574, _e3887, (_e3887 < _e574));
let _e3896 = select(0i, select(select(i32(_e3889), i32(-2147483648), (_e3889 < -2147483600f)), 2147483647i, (_e3889 > 2147483500f)), (_e3889 == _e3889));
let _e3900 = (_e3896 - select(0i, 1i, (_e3889 < f32(_e3896))));
let _e3903 = select(-1f, _e3884.y, (_e3884.y > -1f));
let _e3905 = select(_e605, _e3903, (_e3903 < _e605));
let _e3912 = select(0i, select(select(i32(_e3905), i32(-2147483648), (_e3905 < -2147483600f)), 2147483647i, (_e3905 > 2147483500f)), (_e3905 == _e3905));
let _e3916 = (_e3912 - select(0i, 1i, (_e3905 < f32(_e3912))));
let _e3919 = select(-1f, _e3884.z, (_e3884.z > -1f));
let _e3921 = select(_e630, _e3919, (_e3919 < _e630));
let _e3928 = select(0i, select(select(i32(_e3921), i32(-2147483648), (_e3921 < -2147483600f)), 2147483647i, (_e3921 > 2147483500f)), (_e3921 == _e3921));
let _e3932 = (_e3928 - select(0i, 1i, (_e3921 < f32(_e3928))));
let _e3935 = (_e3916 + 1i);
let _e3940 = (_e3932 + 1i);
let _e3943 = (_e3900 - 1i);
let _e3945 = select(0i, _e3943, (_e3943 > 0i));
let _e3948 = (_e3900 + 1i);
let _e3951 = (_e3900 + 2i);
let _e3955 = select(_e3084, _e3945, (_e3945 < _e3084));
let _e3968 = (select(0i, _e3916, (_e3916 > 0i)) * _e3031);
let _e3969 = (select(_e3044, _e3935, (_e3935 < _e3044)) * _e3031);
let _e3970 = (select(0i, _e3932, (_e3932 > 0i)) * _e3036);
let _e3971 = (select(_e3057, _e3940, (_e3940 < _e3057)) * _e3036);
local_4 = type_29(array<i32, 4>(_e3955, _e3955, _e3955, _e3955), array<u32, 6>(bitcast<u32>(((_e3945 - _e3955) * 8i)), bitcast<u32>(((select(0i, _e3900, (_e3900 > 0i)) - _e3955) * 8i)), bitcast<u32>(((select(_e3070, _e3948, (_e3948 < _e3070)) - _e3955) * 8i)), bitcast<u32>(((select(_e3070, _e3951, (_e3951 < _e3070)) - _e3955) * 8i)), 0u, 0u));
local_5 = (_e3884 - vec3<f32>(f32(_e3900), f32(_e3916), f32(_e3932)));
let _e3984 = local_4.member[0u];
let _e3985 = ((_e3970 + _e3968) + _e3984);
let _e3987 = (_e3985 >> bitcast<u32>(2i));
let _e3990 = bitcast<u32>(((_e3985 & 3i) * 8i));
let _e3992 = select(_e3123, _e3987, (_e3987 < _e3123));
let _e3997 = global_1.member[bitcast<u32>(select(0i, _e3992, (_e3992 > 0i)))];
let _e4001 = (_e3987 + 1i);
let _e4003 = select(_e3123, _e4001, (_e4001 < _e3123));
let _e4008 = global_1.member[bitcast<u32>(select(0i, _e4003, (_e4003 > 0i)))];
let _e4015 = ((_e3997 >> bitcast<u32>((_e3990 & 31u))) | ((_e4008 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3990) & 31u))));
let _e4018 = local_4.member_1[1u];
let _e4024 = f32(bitcast<i32>(((_e4015 >> bitcast<u32>((_e4018 & 31u))) & 255u)));
let _e4027 = local_4.member_1[2u];
let _e4034 = local_5[0u];
let _e4037 = (_e4024 + ((f32(bitcast<i32>(((_e4015 >> bitcast<u32>((_e4027 & 31u))) & 255u))) - _e4024) * _e4034));
let _e4039 = local_4.member[0u];
let _e4040 = ((_e3970 + _e3969) + _e4039);
let _e4042 = (_e4040 >> bitcast<u32>(2i));
let _e4045 = bitcast<u32>(((_e4040 & 3i) * 8i));
let _e4047 = select(_e3123, _e4042, (_e4042 < _e3123));
let _e4052 = global_1.member[bitcast<u32>(select(0i, _e4047, (_e4047 > 0i)))];
let _e4056 = (_e4042 + 1i);
let _e4058 = select(_e3123, _e4056, (_e4056 < _e3123));
let _e4063 = global_1.member[bitcast<u32>(select(0i, _e4058, (_e4058 > 0i)))];
let _e4070 = ((_e4052 >> bitcast<u32>((_e4045 & 31u))) | ((_e4063 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4045) & 31u))));
let _e4071 = local_4.member_1[1u];
let _e4077 = f32(bitcast<i32>(((_e4070 >> bitcast<u32>((_e4071 & 31u))) & 255u)));
let _e4078 = local_4.member_1[2u];
let _e4085 = local_5[0u];
let _e4090 = local_5[1u];
let _e4093 = (_e4037 + (((_e4077 + ((f32(bitcast<i32>(((_e4070 >> bitcast<u32>((_e4078 & 31u))) & 255u))) - _e4077) * _e4085)) - _e4037) * _e4090));
let _e4095 = local_4.member[0u];
let _e4096 = ((_e3971 + _e3968) + _e4095);
let _e4098 = (_e4096 >> bitcast<u32>(2i));
let _e4101 = bitcast<u32>(((_e4096 & 3i) * 8i));
let _e4103 = select(_e3123, _e4098, (_e4098 < _e3123));
let _e4108 = global_1.member[bitcast<u32>(select(0i, _e4103, (_e4103 > 0i)))];
let _e4112 = (_e4098 + 1i);
let _e4114 = select(_e3123, _e4112, (_e4112 < _e3123));
let _e4119 = global_1.member[bitcast<u32>(select(0i, _e4114, (_e4114 > 0i)))];
let _e4126 = ((_e4108 >> bitcast<u32>((_e4101 & 31u))) | ((_e4119 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4101) & 31u))));
let _e4127 = local_4.member_1[1u];
let _e4133 = f32(bitcast<i32>(((_e4126 >> bitcast<u32>((_e4127 & 31u))) & 255u)));
let _e4134 = local_4.member_1[2u];
let _e4141 = local_5[0u];
let _e4144 = (_e4133 + ((f32(bitcast<i32>(((_e4126 >> bitcast<u32>((_e4134 & 31u))) & 255u))) - _e4133) * _e4141));
let _e4146 = local_4.member[0u];
let _e4147 = ((_e3971 + _e3969) + _e4146);
let _e4149 = (_e4147 >> bitcast<u32>(2i));
let _e4152 = bitcast<u32>(((_e4147 & 3i) * 8i));
let _e4154 = select(_e3123, _e4149, (_e4149 < _e3123));
let _e4159 = global_1.member[bitcast<u32>(select(0i, _e4154, (_e4154 > 0i)))];
let _e4163 = (_e4149 + 1i);
let _e4165 = select(_e3123, _e4163, (_e4163 < _e3123));
let _e4170 = global_1.member[bitcast<u32>(select(0i, _e4165, (_e4165 > 0i)))];
let _e4177 = ((_e4159 >> bitcast<u32>((_e4152 & 31u))) | ((_e4170 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4152) & 31u))));
let _e4178 = local_4.member_1[1u];
let _e4184 = f32(bitcast<i32>(((_e4177 >> bitcast<u32>((_e4178 & 31u))) & 255u)));
let _e4185 = local_4.member_1[2u];
let _e4192 = local_5[0u];
let _e4196 = local_5[1u];
let _e4201 = local_5[2u];
let _e4206 = (((_e4093 + (((_e4144 + (((_e4184 + ((f32(bitcast<i32>(((_e4177 >> bitcast<u32>((_e4185 & 31u))) & 255u))) - _e4184) * _e4192)) - _e4144) * _e4196)) - _e4093) * _e4201)) - _e3342) * _e3347);
let _e4208 = select(_e3350, _e4206, (_e4206 > _e3350));
let _e4210 = select(1e9f, _e4208, (_e4208 < 1e9f));
if _e687 {
phi_7119_ = (_e4210 > _e3789);
} else {
phi_7119_ = (_e4210 < _e3789);
}
let _e4214 = phi_7119_;
let _e4215 = (_e1116 && _e4214);
let _e4216 = select(_e3789, _e4210, _e4215);
let _e4220 = (_e1113.member + (_e2879 * (3f * 0.25f)));
let _e4224 = (_e403 + (_e1117 * _e4220));
let _e4225 = (_e405 + (_e1118 * _e4220));
let _e4226 = (_e393 + (_e1119 * _e4220));
let _e4232 = ((((_e419.member.member * _e4224) + (_e419.member.member_1 * _e4225)) + (_e419.member.member_2 * _e4226)) + _e419.member_1);
let _e4238 = ((((_e435.member.member * _e4224) + (_e435.member.member_1 * _e4225)) + (_e435.member.member_2 * _e4226)) + _e435.member_1);
let _e4244 = ((((_e451.member.member * _e4224) + (_e451.member.member_1 * _e4225)) + (_e451.member.member_2 * _e4226)) + _e451.member_1);
let _e4246 = select(_e486, _e4232, (_e4232 > _e486));
let _e4248 = select(_e492, _e4246, (_e4246 < _e492));
let _e4250 = select(_e502, _e4238, (_e4238 > _e502));
let _e4252 = select(_e508, _e4250, (_e4250 < _e508));
let _e4254 = select(_e518, _e4244, (_e4244 > _e518));
let _e4256 = select(_e524, _e4254, (_e4254 < _e524));
if _e2924 {
phi_7333_ = vec3<f32>(_e4248, _e4252, _e4256);
} else {
let _e4258 = (_e4248 + 0.5f);
let _e4260 = select(0f, _e4258, (_e4258 > 0f));
let _e4262 = select(_e576, _e4260, (_e4260 < _e576));
let _e4269 = select(0i, select(select(i32(_e4262), i32(-2147483648), (_e4262 < -2147483600f)), 2147483647i, (_e4262 > 2147483500f)), (_e4262 == _e4262));
let _e4275 = (_e4252 + 0.5f);
let _e4277 = select(0f, _e4275, (_e4275 > 0f));
let _e4279 = select(_e607, _e4277, (_e4277 < _e607));
let _e4286 = select(0i, select(select(i32(_e4279), i32(-2147483648), (_e4279 < -2147483600f)), 2147483647i, (_e4279 > 2147483500f)), (_e4279 == _e4279));
let _e4292 = (_e4256 + 0.5f);
let _e4294 = select(0f, _e4292, (_e4292 > 0f));
let _e4296 = select(_e632, _e4294, (_e4294 < _e632));
let _e4303 = select(0i, select(select(i32(_e4296), i32(-2147483648), (_e4296 < -2147483600f)), 2147483647i, (_e4296 > 2147483500f)), (_e4296 == _e4296));
phi_7333_ = vec3<f32>(f32((_e4269 - select(0i, 1i, (_e4262 < f32(_e4269))))), f32((_e4286 - select(0i, 1i, (_e4279 < f32(_e4286))))), f32((_e4303 - select(0i, 1i, (_e4296 < f32(_e4303))))));
}
let _e4311 = phi_7333_;
let _e4314 = select(-1f, _e4311.x, (_e4311.x > -1f));
let _e4316 = select(_e574, _e4314, (_e4314 < _e574));
let _e4323 = select(0i, select(select(i32(_e4316), i32(-2147483648), (_e4316 < -2147483600f)), 2147483647i, (_e4316 > 2147483500f)), (_e4316 == _e4316));
let _e4327 = (_e4323 - select(0i, 1i, (_e4316 < f32(_e4323))));
let _e4330 = select(-1f, _e4311.y, (_e4311.y > -1f));
let _e4332 = select(_e605, _e4330, (_e4330 < _e605));
let _e4339 = select(0i, select(select(i32(_e4332), i32(-2147483648), (_e4332 < -2147483600f)), 2147483647i, (_e4332 > 2147483500f)), (_e4332 == _e4332));
let _e4343 = (_e4339 - select(0i, 1i, (_e4332 < f32(_e4339))));
let _e4346 = select(-1f, _e4311.z, (_e4311.z > -1f));
let _e4348 = select(_e630, _e4346, (_e4346 < _e630));
let _e4355 = select(0i, select(select(i32(_e4348), i32(-2147483648), (_e4348 < -2147483600f)), 2147483647i, (_e4348 > 2147483500f)), (_e4348 == _e4348));
let _e4359 = (_e4355 - select(0i, 1i, (_e4348 < f32(_e4355))));
let _e4362 = (_e4343 + 1i);
let _e4367 = (_e4359 + 1i);
let _e4370 = (_e4327 - 1i);
let _e4372 = select(0i, _e4370, (_e4370 > 0i));
let _e4375 = (_e4327 + 1i);
let _e4378 = (_e4327 + 2i);
let _e4382 = select(_e3084, _e4372, (_e4372 < _e3084));
let _e4395 = (select(0i, _e4343, (_e4343 > 0i)) * _e3031);
let _e4396 = (select(_e3044, _e4362, (_e4362 < _e3044)) * _e3031);
let _e4397 = (select(0i, _e4359, (_e4359 > 0i)) * _e3036);
let _e4398 = (select(_e3057, _e4367, (_e4367 < _e3057)) * _e3036);
local_2 = type_29(array<i32, 4>(_e4382, _e4382, _e4382, _e4382), array<u32, 6>(bitcast<u32>(((_e4372 - _e4382) * 8i)), bitcast<u32>(((select(0i, _e4327, (_e4327 > 0i)) - _e4382) * 8i)), bitcast<u32>(((select(_e3070, _e4375, (_e4375 < _e3070)) - _e4382) * 8i)), bitcast<u32>(((select(_e3070, _e4378, (_e4378 < _e3070)) - _e4382) * 8i)), 0u, 0u));
local_3 = (_e4311 - vec3<f32>(f32(_e4327), f32(_e4343), f32(_e4359)));
let _e4411 = local_2.member[0u];
let _e4412 = ((_e4397 + _e4395) + _e4411);
let _e4414 = (_e4412 >> bitcast<u32>(2i));
let _e4417 = bitcast<u32>(((_e4412 & 3i) * 8i));
let _e4419 = select(_e3123, _e4414, (_e4414 < _e3123));
let _e4424 = global_1.member[bitcast<u32>(select(0i, _e4419, (_e4419 > 0i)))];
let _e4428 = (_e4414 + 1i);
let _e4430 = select(_e3123, _e4428, (_e4428 < _e3123));
let _e4435 = global_1.member[bitcast<u32>(select(0i, _e4430, (_e4430 > 0i)))];
let _e4442 = ((_e4424 >> bitcast<u32>((_e4417 & 31u))) | ((_e4435 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4417) & 31u))));
let _e4445 = local_2.member_1[1u];
let _e4451 = f32(bitcast<i32>(((_e4442 >> bitcast<u32>((_e4445 & 31u))) & 255u)));
let _e4454 = local_2.member_1[2u];
let _e4461 = local_3[0u];
let _e4464 = (_e4451 + ((f32(bitcast<i32>(((_e4442 >> bitcast<u32>((_e4454 & 31u))) & 255u))) - _e4451) * _e4461));
let _e4466 = local_2.member[0u];
let _e4467 = ((_e4397 + _e4396) + _e4466);
let _e4469 = (_e4467 >> bitcast<u32>(2i));
let _e4472 = bitcast<u32>(((_e4467 & 3i) * 8i));
let _e4474 = select(_e3123, _e4469, (_e4469 < _e3123));
let _e4479 = global_1.member[bitcast<u32>(select(0i, _e4474, (_e4474 > 0i)))];
let _e4483 = (_e4469 + 1i);
let _e4485 = select(_e3123, _e4483, (_e4483 < _e3123));
let _e4490 = global_1.member[bitcast<u32>(select(0i, _e4485, (_e4485 > 0i)))];
let _e4497 = ((_e4479 >> bitcast<u32>((_e4472 & 31u))) | ((_e4490 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4472) & 31u))));
let _e4498 = local_2.member_1[1u];
let _e4504 = f32(bitcast<i32>(((_e4497 >> bitcast<u32>((_e4498 & 31u))) & 255u)));
let _e4505 = local_2.member_1[2u];
let _e4512 = local_3[0u];
let _e4517 = local_3[1u];
let _e4520 = (_e4464 + (((_e4504 + ((f32(bitcast<i32>(((_e4497 >> bitcast<u32>((_e4505 & 31u))) & 255u))) - _e4504) * _e4512)) - _e4464) * _e4517));
let _e4522 = local_2.member[0u];
let _e4523 = ((_e4398 + _e4395) + _e4522);
let _e4525 = (_e4523 >> bitcast<u32>(2i));
let _e4528 = bitcast<u32>(((_e4523 & 3i) * 8i));
let _e4530 = select(_e3123, _e4525, (_e4525 < _e3123));
let _e4535 = global_1.member[bitcast<u32>(select(0i, _e4530, (_e4530 > 0i)))];
let _e4539 = (_e4525 + 1i);
let _e4541 = select(_e3123, _e4539, (_e4539 < _e3123));
let _e4546 = global_1.member[bitcast<u32>(select(0i, _e4541, (_e4541 > 0i)))];
let _e4553 = ((_e4535 >> bitcast<u32>((_e4528 & 31u))) | ((_e4546 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4528) & 31u))));
let _e4554 = local_2.member_1[1u];
let _e4560 = f32(bitcast<i32>(((_e4553 >> bitcast<u32>((_e4554 & 31u))) & 255u)));
let _e4561 = local_2.member_1[2u];
let _e4568 = local_3[0u];
let _e4571 = (_e4560 + ((f32(bitcast<i32>(((_e4553 >> bitcast<u32>((_e4561 & 31u))) & 255u))) - _e4560) * _e4568));
let _e4573 = local_2.member[0u];
let _e4574 = ((_e4398 + _e4396) + _e4573);
let _e4576 = (_e4574 >> bitcast<u32>(2i));
let _e4579 = bitcast<u32>(((_e4574 & 3i) * 8i));
let _e4581 = select(_e3123, _e4576, (_e4576 < _e3123));
let _e4586 = global_1.member[bitcast<u32>(select(0i, _e4581, (_e4581 > 0i)))];
let _e4590 = (_e4576 + 1i);
let _e4592 = select(_e3123, _e4590, (_e4590 < _e3123));
let _e4597 = global_1.member[bitcast<u32>(select(0i, _e4592, (_e4592 > 0i)))];
let _e4604 = ((_e4586 >> bitcast<u32>((_e4579 & 31u))) | ((_e4597 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4579) & 31u))));
let _e4605 = local_2.member_1[1u];
let _e4611 = f32(bitcast<i32>(((_e4604 >> bitcast<u32>((_e4605 & 31u))) & 255u)));
let _e4612 = local_2.member_1[2u];
let _e4619 = local_3[0u];
let _e4623 = local_3[1u];
let _e4628 = local_3[2u];
let _e4633 = (((_e4520 + (((_e4571 + (((_e4611 + ((f32(bitcast<i32>(((_e4604 >> bitcast<u32>((_e4612 & 31u))) & 255u))) - _e4611) * _e4619)) - _e4571) * _e4623)) - _e4520) * _e4628)) - _e3342) * _e3347);
let _e4635 = select(_e3350, _e4633, (_e4633 > _e3350));
let _e4637 = select(1e9f, _e4635, (_e4635 < 1e9f));
if _e687 {
phi_7868_ = (_e4637 > _e4216);
} else {
phi_7868_ = (_e4637 < _e4216);
}
let _e4641 = phi_7868_;
let _e4642 = (_e1116 && _e4641);
let _e4643 = select(_e4216, _e4637, _e4642);
let _e4646 = (_e1113.member + (_e2879 * 1f));
let _e4650 = (_e403 + (_e1117 * _e4646));
let _e4651 = (_e405 + (_e1118 * _e4646));
let _e4652 = (_e393 + (_e1119 * _e4646));
let _e4658 = ((((_e419.member.member * _e4650) + (_e419.member.member_1 * _e4651)) + (_e419.member.member_2 * _e4652)) + _e419.member_1);
let _e4664 = ((((_e435.member.member * _e4650) + (_e435.member.member_1 * _e4651)) + (_e435.member.member_2 * _e4652)) + _e435.member_1);
let _e4670 = ((((_e451.member.member * _e4650) + (_e451.member.member_1 * _e4651)) + (_e451.member.member_2 * _e4652)) + _e451.member_1);
let _e4672 = select(_e486, _e4658, (_e4658 > _e486));
let _e4674 = select(_e492, _e4672, (_e4672 < _e492));
let _e4676 = select(_e502, _e4664, (_e4664 > _e502));
let _e4678 = select(_e508, _e4676, (_e4676 < _e508));
let _e4680 = select(_e518, _e4670, (_e4670 > _e518));
let _e4682 = select(_e524, _e4680, (_e4680 < _e524));
if _e2924 {
phi_8081_ = vec3<f32>(_e4674, _e4678, _e4682);
} else {
let _e4684 = (_e4674 + 0.5f);
let _e4686 = select(0f, _e4684, (_e4684 > 0f));
let _e4688 = select(_e576, _e4686, (_e4686 < _e576));
let _e4695 = select(0i, select(select(i32(_e4688), i32(-2147483648), (_e4688 < -2147483600f)), 2147483647i, (_e4688 > 2147483500f)), (_e4688 == _e4688));
let _e4701 = (_e4678 + 0.5f);
let _e4703 = select(0f, _e4701, (_e4701 > 0f));
let _e4705 = select(_e607, _e4703, (_e4703 < _e607));
let _e4712 = select(0i, select(select(i32(_e4705), i32(-2147483648), (_e4705 < -2147483600f)), 2147483647i, (_e4705 > 2147483500f)), (_e4705 == _e4705));
let _e4718 = (_e4682 + 0.5f);
let _e4720 = select(0f, _e4718, (_e4718 > 0f));
let _e4722 = select(_e632, _e4720, (_e4720 < _e632));
let _e4729 = select(0i, select(select(i32(_e4722), i32(-2147483648), (_e4722 < -2147483600f)), 2147483647i, (_e4722 > 2147483500f)), (_e4722 == _e4722));
phi_8081_ = vec3<f32>(f32((_e4695 - select(0i, 1i, (_e4688 < f32(_e4695))))), f32((_e4712 - select(0i, 1i, (_e4705 < f32(_e4712))))), f32((_e4729 - select(0i, 1i, (_e4722 < f32(_e4729))))));
}
let _e4737 = phi_8081_;
let _e4740 = select(-1f, _e4737.x, (_e4737.x > -1f));
let _e4742 = select(_e574, _e4740, (_e4740 < _e574));
let _e4749 = select(0i, select(select(i32(_e4742), i32(-2147483648), (_e4742 < -2147483600f)), 2147483647i, (_e4742 > 2147483500f)), (_e4742 == _e4742));
let _e4753 = (_e4749 - select(0i, 1i, (_e4742 < f32(_e4749))));
let _e4756 = select(-1f, _e4737.y, (_e4737.y > -1f));
let _e4758 = select(_e605, _e4756, (_e4756 < _e605));
let _e4765 = select(0i, select(select(i32(_e4758), i32(-2147483648), (_e4758 < -2147483600f)), 2147483647i, (_e4758 > 2147483500f)), (_e4758 == _e4758));
let _e4769 = (_e4765 - select(0i, 1i, (_e4758 < f32(_e4765))));
let _e4772 = select(-1f, _e4737.z, (_e4737.z > -1f));
let _e4774 = select(_e630, _e4772, (_e4772 < _e630));
let _e4781 = select(0i, select(select(i32(_e4774), i32(-2147483648), (_e4774 < -2147483600f)), 2147483647i, (_e4774 > 2147483500f)), (_e4774 == _e4774));
let _e4785 = (_e4781 - select(0i, 1i, (_e4774 < f32(_e4781))));
let _e4788 = (_e4769 + 1i);
let _e4793 = (_e4785 + 1i);
let _e4796 = (_e4753 - 1i);
let _e4798 = select(0i, _e4796, (_e4796 > 0i));
let _e4801 = (_e4753 + 1i);
let _e4804 = (_e4753 + 2i);
let _e4808 = select(_e3084, _e4798, (_e4798 < _e3084));
let _e4821 = (select(0i, _e4769, (_e4769 > 0i)) * _e3031);
let _e4822 = (select(_e3044, _e4788, (_e4788 < _e3044)) * _e3031);
let _e4823 = (select(0i, _e4785, (_e4785 > 0i)) * _e3036);
let _e4824 = (select(_e3057, _e4793, (_e4793 < _e3057)) * _e3036);
local = type_29(array<i32, 4>(_e4808, _e4808, _e4808, _e4808), array<u32, 6>(bitcast<u32>(((_e4798 - _e4808) * 8i)), bitcast<u32>(((select(0i, _e4753, (_e4753 > 0i)) - _e4808) * 8i)), bitcast<u32>(((select(_e3070, _e4801, (_e4801 < _e3070)) - _e4808) * 8i)), bitcast<u32>(((select(_e3070, _e4804, (_e4804 < _e3070)) - _e4808) * 8i)), 0u, 0u));
local_1 = (_e4737 - vec3<f32>(f32(_e4753), f32(_e4769), f32(_e4785)));
let _e4837 = local.member[0u];
let _e4838 = ((_e4823 + _e4821) + _e4837);
let _e4840 = (_e4838 >> bitcast<u32>(2i));
let _e4843 = bitcast<u32>(((_e4838 & 3i) * 8i));
let _e4845 = select(_e3123, _e4840, (_e4840 < _e3123));
let _e4850 = global_1.member[bitcast<u32>(select(0i, _e4845, (_e4845 > 0i)))];
let _e4854 = (_e4840 + 1i);
let _e4856 = select(_e3123, _e4854, (_e4854 < _e3123));
let _e4861 = global_1.member[bitcast<u32>(select(0i, _e4856, (_e4856 > 0i)))];
let _e4868 = ((_e4850 >> bitcast<u32>((_e4843 & 31u))) | ((_e4861 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4843) & 31u))));
let _e4871 = local.member_1[1u];
let _e4877 = f32(bitcast<i32>(((_e4868 >> bitcast<u32>((_e4871 & 31u))) & 255u)));
let _e4880 = local.member_1[2u];
let _e4887 = local_1[0u];
let _e4890 = (_e4877 + ((f32(bitcast<i32>(((_e4868 >> bitcast<u32>((_e4880 & 31u))) & 255u))) - _e4877) * _e4887));
let _e4892 = local.member[0u];
let _e4893 = ((_e4823 + _e4822) + _e4892);
let _e4895 = (_e4893 >> bitcast<u32>(2i));
let _e4898 = bitcast<u32>(((_e4893 & 3i) * 8i));
let _e4900 = select(_e3123, _e4895, (_e4895 < _e3123));
let _e4905 = global_1.member[bitcast<u32>(select(0i, _e4900, (_e4900 > 0i)))];
let _e4909 = (_e4895 + 1i);
let _e4911 = select(_e3123, _e4909, (_e4909 < _e3123));
let _e4916 = global_1.member[bitcast<u32>(select(0i, _e4911, (_e4911 > 0i)))];
let _e4923 = ((_e4905 >> bitcast<u32>((_e4898 & 31u))) | ((_e4916 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4898) & 31u))));
let _e4924 = local.member_1[1u];
let _e4930 = f32(bitcast<i32>(((_e4923 >> bitcast<u32>((_e4924 & 31u))) & 255u)));
let _e4931 = local.member_1[2u];
let _e4938 = local_1[0u];
let _e4943 = local_1[1u];
let _e4946 = (_e4890 + (((_e4930 + ((f32(bitcast<i32>(((_e4923 >> bitcast<u32>((_e4931 & 31u))) & 255u))) - _e4930) * _e4938)) - _e4890) * _e4943));
let _e4948 = local.member[0u];
let _e4949 = ((_e4824 + _e4821) + _e4948);
let _e4951 = (_e4949 >> bitcast<u32>(2i));
let _e4954 = bitcast<u32>(((_e4949 & 3i) * 8i));
let _e4956 = select(_e3123, _e4951, (_e4951 < _e3123));
let _e4961 = global_1.member[bitcast<u32>(select(0i, _e4956, (_e4956 > 0i)))];
let _e4965 = (_e4951 + 1i);
let _e4967 = select(_e3123, _e4965, (_e4965 < _e3123));
let _e4972 = global_1.member[bitcast<u32>(select(0i, _e4967, (_e4967 > 0i)))];
let _e4979 = ((_e4961 >> bitcast<u32>((_e4954 & 31u))) | ((_e4972 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4954) & 31u))));
let _e4980 = local.member_1[1u];
let _e4986 = f32(bitcast<i32>(((_e4979 >> bitcast<u32>((_e4980 & 31u))) & 255u)));
let _e4987 = local.member_1[2u];
let _e4994 = local_1[0u];
let _e4997 = (_e4986 + ((f32(bitcast<i32>(((_e4979 >> bitcast<u32>((_e4987 & 31u))) & 255u))) - _e4986) * _e4994));
let _e4999 = local.member[0u];
let _e5000 = ((_e4824 + _e4822) + _e4999);
let _e5002 = (_e5000 >> bitcast<u32>(2i));
let _e5005 = bitcast<u32>(((_e5000 & 3i) * 8i));
let _e5007 = select(_e3123, _e5002, (_e5002 < _e3123));
let _e5012 = global_1.member[bitcast<u32>(select(0i, _e5007, (_e5007 > 0i)))];
let _e5016 = (_e5002 + 1i);
let _e5018 = select(_e3123, _e5016, (_e5016 < _e3123));
let _e5023 = global_1.member[bitcast<u32>(select(0i, _e5018, (_e5018 > 0i)))];
let _e5030 = ((_e5012 >> bitcast<u32>((_e5005 & 31u))) | ((_e5023 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e5005) & 31u))));
let _e5031 = local.member_1[1u];
let _e5037 = f32(bitcast<i32>(((_e5030 >> bitcast<u32>((_e5031 & 31u))) & 255u)));
let _e5038 = local.member_1[2u];
let _e5045 = local_1[0u];
let _e5049 = local_1[1u];
let _e5054 = local_1[2u];
let _e5059 = (((_e4946 + (((_e4997 + (((_e5037 + ((f32(bitcast<i32>(((_e5030 >> bitcast<u32>((_e5038 & 31u))) & 255u))) - _e5037) * _e5045)) - _e4997) * _e5049)) - _e4946) * _e5054)) - _e3342) * _e3347);
let _e5061 = select(_e3350, _e5059, (_e5059 > _e3350));
let _e5063 = select(1e9f, _e5061, (_e5061 < 1e9f));
if _e687 {
phi_8616_ = (_e5063 > _e4643);
} else {
phi_8616_ = (_e5063 < _e4643);
}
let _e5067 = phi_8616_;
let _e5068 = (_e1116 && _e5067);
phi_8626_ = select(select(select(select(select(_e373[8], _e2887, _e3362), _e3372, _e3788), _e3799, _e4215), _e4226, _e4642), _e4652, _e5068);
phi_8627_ = select(_e4643, _e5063, _e5068);
}
let _e5072 = phi_8626_;
let _e5074 = phi_8627_;
phi_8645_ = array<f32, 23>(_e373[0], _e373[1], _e373[2], _e373[3], _e373[4], _e373[5], select(_e373[6], _e5074, _e1116), _e373[7], select(_e373[8], _e5072, _e1116), _e373[9], _e373[10], _e373[11], _e373[12], _e373[13], _e373[14], _e373[15], _e373[16], select(_e373[17], _e414, _e1116), _e373[18], _e373[19], _e373[20], _e373[21], _e373[22]);
} else {
phi_8645_ = _e373;
}
let _e5080 = phi_8645_;
phi_631_ = (_e369 + 1u);
phi_634_ = select(_e371, true, _e745);
phi_636_ = _e5080;
} else {
phi_631_ = u32();
phi_634_ = bool();
phi_636_ = array<f32, 23>();
}
let _e5084 = phi_631_;
let _e5086 = phi_634_;
let _e5088 = phi_636_;
continue;
continuing {
phi_630_ = _e5084;
phi_633_ = _e5086;
phi_635_ = _e5088;
phi_8748_ = false;
break if !(_e374);
}
}
let _e5091 = phi_8748_;
if _e5091 {
break;
}
let _e5093 = local_18;
if _e5093 {
let _e5095 = local_19;
global_4.member[_e114] = _e5095[0];
let _e5100 = local_20;
global_4.member[_e126] = _e5100[1];
let _e5105 = local_21;
global_4.member[_e137] = _e5105[2];
let _e5110 = local_22;
global_4.member[_e148] = _e5110[3];
let _e5115 = local_23;
global_4.member[_e159] = _e5115[4];
let _e5120 = local_24;
global_4.member[_e170] = _e5120[5];
let _e5125 = local_25;
global_4.member[_e181] = _e5125[6];
let _e5130 = local_26;
global_4.member[_e192] = _e5130[7];
let _e5135 = local_27;
global_4.member[_e203] = _e5135[8];
let _e5140 = local_28;
global_4.member[_e214] = _e5140[9];
let _e5145 = local_29;
global_4.member[_e225] = _e5145[10];
let _e5150 = local_30;
global_4.member[_e236] = _e5150[11];
let _e5155 = local_31;
global_4.member[_e247] = _e5155[12];
let _e5160 = local_32;
global_4.member[_e258] = _e5160[13];
let _e5165 = local_33;
global_4.member[_e269] = _e5165[14];
let _e5170 = local_34;
global_4.member[_e280] = _e5170[15];
let _e5175 = local_35;
global_4.member[_e291] = _e5175[16];
let _e5180 = local_36;
global_4.member[_e302] = _e5180[17];
let _e5185 = local_37;
global_4.member[_e313] = _e5185[18];
let _e5190 = local_38;
global_4.member[_e324] = _e5190[19];
let _e5195 = local_39;
global_4.member[_e335] = _e5195[20];
let _e5200 = local_40;
global_4.member[_e346] = _e5200[21];
let _e5205 = local_41;
global_4.member[_e357] = _e5205[22];
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
