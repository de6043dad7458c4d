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
var phi_2788_: vec3<f32>;
var phi_3460_: vec3<f32>;
var phi_4132_: vec3<f32>;
var phi_4632_: f32;
var phi_4840_: vec3<f32>;
var phi_5317_: bool;
var phi_5530_: vec3<f32>;
var phi_6004_: bool;
var phi_6218_: vec3<f32>;
var phi_6692_: bool;
var phi_6906_: vec3<f32>;
var phi_7380_: bool;
var phi_7593_: vec3<f32>;
var phi_8067_: bool;
var phi_8077_: f32;
var phi_8078_: f32;
var phi_8096_: array<f32, 23>;
var phi_631_: u32;
var phi_634_: bool;
var phi_636_: array<f32, 23>;
var phi_8199_: bool;
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
let _e83 = global;
let _e85 = arrayLength((&global_2.member));
let _e88 = arrayLength((&global_1.member));
if (0u < _e85) {
} else {
break;
}
let _e97 = global_2.member[0u].member_2;
let _e101 = global_2.member[0u].member;
let _e109 = (_e83.x + _e97.member);
let _e111 = (_e83.y + _e97.member_1);
if (_e109 < _e97.member_2) {
if (_e111 < _e97.member_3) {
let _e114 = (_e101.member * _e101.member_1);
let _e116 = ((_e111 * _e101.member) + _e109);
let _e117 = bitcast<i32>(_e116);
let _e119 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e121 = select(_e119, _e117, (_e117 < _e119));
let _e127 = global_4.member[bitcast<u32>(select(0i, _e121, (_e121 > 0i)))];
let _e128 = (_e114 + _e116);
let _e129 = bitcast<i32>(_e128);
let _e131 = select(_e119, _e129, (_e129 < _e119));
let _e137 = global_4.member[bitcast<u32>(select(0i, _e131, (_e131 > 0i)))];
let _e139 = ((2u * _e114) + _e116);
let _e140 = bitcast<i32>(_e139);
let _e142 = select(_e119, _e140, (_e140 < _e119));
let _e148 = global_4.member[bitcast<u32>(select(0i, _e142, (_e142 > 0i)))];
let _e150 = ((3u * _e114) + _e116);
let _e151 = bitcast<i32>(_e150);
let _e153 = select(_e119, _e151, (_e151 < _e119));
let _e159 = global_4.member[bitcast<u32>(select(0i, _e153, (_e153 > 0i)))];
let _e161 = ((4u * _e114) + _e116);
let _e162 = bitcast<i32>(_e161);
let _e164 = select(_e119, _e162, (_e162 < _e119));
let _e170 = global_4.member[bitcast<u32>(select(0i, _e164, (_e164 > 0i)))];
let _e172 = ((5u * _e114) + _e116);
let _e173 = bitcast<i32>(_e172);
let _e175 = select(_e119, _e173, (_e173 < _e119));
let _e181 = global_4.member[bitcast<u32>(select(0i, _e175, (_e175 > 0i)))];
let _e183 = ((6u * _e114) + _e116);
let _e184 = bitcast<i32>(_e183);
let _e186 = select(_e119, _e184, (_e184 < _e119));
let _e192 = global_4.member[bitcast<u32>(select(0i, _e186, (_e186 > 0i)))];
let _e194 = ((7u * _e114) + _e116);
let _e195 = bitcast<i32>(_e194);
let _e197 = select(_e119, _e195, (_e195 < _e119));
let _e203 = global_4.member[bitcast<u32>(select(0i, _e197, (_e197 > 0i)))];
let _e205 = ((8u * _e114) + _e116);
let _e206 = bitcast<i32>(_e205);
let _e208 = select(_e119, _e206, (_e206 < _e119));
let _e214 = global_4.member[bitcast<u32>(select(0i, _e208, (_e208 > 0i)))];
let _e216 = ((9u * _e114) + _e116);
let _e217 = bitcast<i32>(_e216);
let _e219 = select(_e119, _e217, (_e217 < _e119));
let _e225 = global_4.member[bitcast<u32>(select(0i, _e219, (_e219 > 0i)))];
let _e227 = ((10u * _e114) + _e116);
let _e228 = bitcast<i32>(_e227);
let _e230 = select(_e119, _e228, (_e228 < _e119));
let _e236 = global_4.member[bitcast<u32>(select(0i, _e230, (_e230 > 0i)))];
let _e238 = ((11u * _e114) + _e116);
let _e239 = bitcast<i32>(_e238);
let _e241 = select(_e119, _e239, (_e239 < _e119));
let _e247 = global_4.member[bitcast<u32>(select(0i, _e241, (_e241 > 0i)))];
let _e249 = ((12u * _e114) + _e116);
let _e250 = bitcast<i32>(_e249);
let _e252 = select(_e119, _e250, (_e250 < _e119));
let _e258 = global_4.member[bitcast<u32>(select(0i, _e252, (_e252 > 0i)))];
let _e260 = ((13u * _e114) + _e116);
let _e261 = bitcast<i32>(_e260);
let _e263 = select(_e119, _e261, (_e261 < _e119));
let _e269 = global_4.member[bitcast<u32>(select(0i, _e263, (_e263 > 0i)))];
let _e271 = ((14u * _e114) + _e116);
let _e272 = bitcast<i32>(_e271);
let _e274 = select(_e119, _e272, (_e272 < _e119));
let _e280 = global_4.member[bitcast<u32>(select(0i, _e274, (_e274 > 0i)))];
let _e282 = ((15u * _e114) + _e116);
let _e283 = bitcast<i32>(_e282);
let _e285 = select(_e119, _e283, (_e283 < _e119));
let _e291 = global_4.member[bitcast<u32>(select(0i, _e285, (_e285 > 0i)))];
let _e293 = ((16u * _e114) + _e116);
let _e294 = bitcast<i32>(_e293);
let _e296 = select(_e119, _e294, (_e294 < _e119));
let _e302 = global_4.member[bitcast<u32>(select(0i, _e296, (_e296 > 0i)))];
let _e304 = ((17u * _e114) + _e116);
let _e305 = bitcast<i32>(_e304);
let _e307 = select(_e119, _e305, (_e305 < _e119));
let _e313 = global_4.member[bitcast<u32>(select(0i, _e307, (_e307 > 0i)))];
let _e315 = ((18u * _e114) + _e116);
let _e316 = bitcast<i32>(_e315);
let _e318 = select(_e119, _e316, (_e316 < _e119));
let _e324 = global_4.member[bitcast<u32>(select(0i, _e318, (_e318 > 0i)))];
let _e326 = ((19u * _e114) + _e116);
let _e327 = bitcast<i32>(_e326);
let _e329 = select(_e119, _e327, (_e327 < _e119));
let _e335 = global_4.member[bitcast<u32>(select(0i, _e329, (_e329 > 0i)))];
let _e337 = ((20u * _e114) + _e116);
let _e338 = bitcast<i32>(_e337);
let _e340 = select(_e119, _e338, (_e338 < _e119));
let _e346 = global_4.member[bitcast<u32>(select(0i, _e340, (_e340 > 0i)))];
let _e348 = ((21u * _e114) + _e116);
let _e349 = bitcast<i32>(_e348);
let _e351 = select(_e119, _e349, (_e349 < _e119));
let _e357 = global_4.member[bitcast<u32>(select(0i, _e351, (_e351 > 0i)))];
let _e359 = ((22u * _e114) + _e116);
let _e360 = bitcast<i32>(_e359);
let _e362 = select(_e119, _e360, (_e360 < _e119));
let _e368 = global_4.member[bitcast<u32>(select(0i, _e362, (_e362 > 0i)))];
phi_630_ = 0u;
phi_633_ = false;
phi_635_ = array<f32, 23>(_e127, _e137, _e148, _e159, _e170, _e181, _e192, _e203, _e214, _e225, _e236, _e247, _e258, _e269, _e280, _e291, _e302, _e313, _e324, _e335, _e346, _e357, _e368);
loop {
let _e371 = phi_630_;
let _e373 = phi_633_;
let _e375 = phi_635_;
local_18 = _e373;
local_19 = _e375;
local_20 = _e375;
local_21 = _e375;
local_22 = _e375;
local_23 = _e375;
local_24 = _e375;
local_25 = _e375;
local_26 = _e375;
local_27 = _e375;
local_28 = _e375;
local_29 = _e375;
local_30 = _e375;
local_31 = _e375;
local_32 = _e375;
local_33 = _e375;
local_34 = _e375;
local_35 = _e375;
local_36 = _e375;
local_37 = _e375;
local_38 = _e375;
local_39 = _e375;
local_40 = _e375;
local_41 = _e375;
let _e376 = (_e371 < _e85);
if _e376 {
if _e376 {
} else {
phi_8199_ = true;
break;
}
let _e380 = global_2.member[_e371].member;
let _e395 = global_2.member[_e371].member_7.member;
let _e397 = ((_e395 - _e375[2]) / _e375[5]);
let _e402 = global_2.member[_e371].member_7.member_2;
let _e403 = (_e402 / _e375[5]);
let _e405 = (_e375[0] + (_e375[3] * _e397));
let _e407 = (_e375[1] + (_e375[4] * _e397));
let _e409 = (_e405 + (_e375[3] * _e403));
let _e411 = (_e407 + (_e375[4] * _e403));
let _e416 = global_2.member[_e371].member_7.member_1;
let _e421 = global_2.member[_e371].member_8.member;
let _e432 = ((((_e421.member.member * _e405) + (_e421.member.member_1 * _e407)) + (_e421.member.member_2 * _e395)) + _e421.member_1);
let _e437 = global_2.member[_e371].member_8.member_1;
let _e448 = ((((_e437.member.member * _e405) + (_e437.member.member_1 * _e407)) + (_e437.member.member_2 * _e395)) + _e437.member_1);
let _e453 = global_2.member[_e371].member_8.member_2;
let _e464 = ((((_e453.member.member * _e405) + (_e453.member.member_1 * _e407)) + (_e453.member.member_2 * _e395)) + _e453.member_1);
let _e470 = ((((_e421.member.member * _e409) + (_e421.member.member_1 * _e411)) + (_e421.member.member_2 * _e416)) + _e421.member_1);
let _e476 = ((((_e437.member.member * _e409) + (_e437.member.member_1 * _e411)) + (_e437.member.member_2 * _e416)) + _e437.member_1);
let _e482 = ((((_e453.member.member * _e409) + (_e453.member.member_1 * _e411)) + (_e453.member.member_2 * _e416)) + _e453.member_1);
let _e488 = global_2.member[_e371].member_8.member_4.member;
let _e494 = global_2.member[_e371].member_8.member_5.member;
let _e496 = select(_e488, _e470, (_e470 > _e488));
let _e498 = select(_e494, _e496, (_e496 < _e494));
let _e504 = global_2.member[_e371].member_8.member_4.member_1;
let _e510 = global_2.member[_e371].member_8.member_5.member_1;
let _e512 = select(_e504, _e476, (_e476 > _e504));
let _e514 = select(_e510, _e512, (_e512 < _e510));
let _e520 = global_2.member[_e371].member_8.member_4.member_2;
let _e526 = global_2.member[_e371].member_8.member_5.member_2;
let _e528 = select(_e520, _e482, (_e482 > _e520));
let _e530 = select(_e526, _e528, (_e528 < _e526));
let _e536 = bitcast<f32>((bitcast<u32>((_e470 - _e432)) & 2147483647u));
let _e539 = bitcast<f32>((bitcast<u32>((_e476 - _e448)) & 2147483647u));
let _e541 = select(_e539, _e536, (_e536 > _e539));
let _e544 = bitcast<f32>((bitcast<u32>((_e482 - _e464)) & 2147483647u));
let _e551 = global_2.member[_e371].member_8.member_6;
let _e552 = (select(_e544, _e541, (_e541 > _e544)) <= _e551);
let _e558 = bitcast<f32>((bitcast<u32>((_e470 - _e498)) & 2147483647u));
let _e561 = bitcast<f32>((bitcast<u32>((_e476 - _e514)) & 2147483647u));
let _e563 = select(_e561, _e558, (_e558 > _e561));
let _e566 = bitcast<f32>((bitcast<u32>((_e482 - _e530)) & 2147483647u));
let _e576 = global_2.member[_e371].member_8.member_3.member;
let _e577 = (_e498 + 0.5f);
let _e578 = (_e576 - 1f);
let _e580 = select(0f, _e577, (_e577 > 0f));
let _e582 = select(_e578, _e580, (_e580 < _e578));
let _e589 = select(0i, select(select(i32(_e582), i32(-2147483648), (_e582 < -2147483600f)), 2147483647i, (_e582 > 2147483500f)), (_e582 == _e582));
let _e598 = global_2.member[_e371].member_8.member_14;
let _e599 = (_e598 & 31u);
let _e607 = global_2.member[_e371].member_8.member_3.member_1;
let _e608 = (_e514 + 0.5f);
let _e609 = (_e607 - 1f);
let _e611 = select(0f, _e608, (_e608 > 0f));
let _e613 = select(_e609, _e611, (_e611 < _e609));
let _e620 = select(0i, select(select(i32(_e613), i32(-2147483648), (_e613 < -2147483600f)), 2147483647i, (_e613 > 2147483500f)), (_e613 == _e613));
let _e632 = global_2.member[_e371].member_8.member_3.member_2;
let _e633 = (_e530 + 0.5f);
let _e634 = (_e632 - 1f);
let _e636 = select(0f, _e633, (_e633 > 0f));
let _e638 = select(_e634, _e636, (_e636 < _e634));
let _e645 = select(0i, select(select(i32(_e638), i32(-2147483648), (_e638 < -2147483600f)), 2147483647i, (_e638 > 2147483500f)), (_e638 == _e638));
let _e657 = global_2.member[_e371].member_8.member_11.member;
let _e664 = global_2.member[_e371].member_8.member_11.member_1;
let _e670 = global_2.member[_e371].member_8.member_12;
let _e676 = ((bitcast<i32>(_e670) + ((_e589 - select(0i, 1i, (_e582 < f32(_e589)))) >> bitcast<u32>(_e599))) + (bitcast<i32>(_e657) * (((_e620 - select(0i, 1i, (_e613 < f32(_e620)))) >> bitcast<u32>(_e599)) + (bitcast<i32>(_e664) * ((_e645 - select(0i, 1i, (_e638 < f32(_e645)))) >> bitcast<u32>(_e599))))));
let _e678 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e680 = select(_e678, _e676, (_e676 < _e678));
let _e686 = global_3.member[bitcast<u32>(select(0i, _e680, (_e680 > 0i)))];
let _e687 = bitcast<f32>(_e686);
let _e688 = (_e375[17] == -1.2676506e30f);
let _e689 = (_e380.member_2 == 0u);
if _e689 {
phi_999_ = (_e687 <= _e375[6]);
} else {
phi_999_ = (_e687 >= _e375[6]);
}
let _e693 = phi_999_;
let _e695 = !(_e688);
let _e702 = global_2.member[_e371].member_1;
let _e710 = (_e488 + 0.5f);
let _e712 = (_e494 - 0.5f);
let _e715 = (_e504 + 0.5f);
let _e718 = (_e510 - 0.5f);
let _e721 = (_e520 + 0.5f);
let _e724 = (_e526 - 0.5f);
let _e740 = ((_e702 & 16u) == 0u);
let _e747 = (select(0u, select(select(7u, 3u, (((((((((_e432 >= _e710) && (_e432 <= _e712)) && (_e448 >= _e715)) && (_e448 <= _e718)) && (_e464 >= _e721)) && (_e464 <= _e724)) && ((((((_e470 >= _e710) && (_e470 <= _e712)) && (_e476 >= _e715)) && (_e476 <= _e718)) && (_e482 >= _e721)) && (_e482 <= _e724))) && _e740) && _e695)), 1u, (((_e552 && (select(_e566, _e563, (_e563 > _e566)) > _e551)) || (((((_e380.member_2 != 2u) && _e695) && _e552) && _e693) && ((_e702 & 32u) != 0u))) || ((_e702 & 64u) != 0u))), (_e375[7] == 0f)) > 1u);
if _e747 {
let _e762 = (_e488 - _e432);
let _e763 = (_e488 - _e470);
let _e770 = bitcast<f32>((bitcast<u32>((_e762 - _e763)) & 2147483647u));
let _e773 = (bitcast<f32>((bitcast<u32>(_e762) & 2147483647u)) / select(1e-30f, _e770, (_e770 > 1e-30f)));
let _e775 = select(0f, _e773, (_e773 > 0f));
let _e777 = select(1f, _e775, (_e775 < 1f));
let _e779 = (_e763 > 0f);
let _e781 = select(0f, select(_e777, 2f, _e779), (_e762 > 0f));
let _e784 = select(1f, _e777, (_e779 && (_e762 <= 0f)));
let _e786 = select(_e781, 0f, (0f > _e781));
let _e788 = select(_e784, 1f, (1f < _e784));
let _e789 = (_e432 - _e494);
let _e790 = (_e470 - _e494);
let _e797 = bitcast<f32>((bitcast<u32>((_e789 - _e790)) & 2147483647u));
let _e800 = (bitcast<f32>((bitcast<u32>(_e789) & 2147483647u)) / select(1e-30f, _e797, (_e797 > 1e-30f)));
let _e802 = select(0f, _e800, (_e800 > 0f));
let _e804 = select(1f, _e802, (_e802 < 1f));
let _e806 = (_e790 > 0f);
let _e808 = select(0f, select(_e804, 2f, _e806), (_e789 > 0f));
let _e811 = select(1f, _e804, (_e806 && (_e789 <= 0f)));
let _e813 = select(_e808, _e786, (_e786 > _e808));
let _e815 = select(_e811, _e788, (_e788 < _e811));
let _e816 = (_e504 - _e448);
let _e817 = (_e504 - _e476);
let _e824 = bitcast<f32>((bitcast<u32>((_e816 - _e817)) & 2147483647u));
let _e827 = (bitcast<f32>((bitcast<u32>(_e816) & 2147483647u)) / select(1e-30f, _e824, (_e824 > 1e-30f)));
let _e829 = select(0f, _e827, (_e827 > 0f));
let _e831 = select(1f, _e829, (_e829 < 1f));
let _e833 = (_e817 > 0f);
let _e835 = select(0f, select(_e831, 2f, _e833), (_e816 > 0f));
let _e838 = select(1f, _e831, (_e833 && (_e816 <= 0f)));
let _e840 = select(_e835, _e813, (_e813 > _e835));
let _e842 = select(_e838, _e815, (_e815 < _e838));
let _e843 = (_e448 - _e510);
let _e844 = (_e476 - _e510);
let _e851 = bitcast<f32>((bitcast<u32>((_e843 - _e844)) & 2147483647u));
let _e854 = (bitcast<f32>((bitcast<u32>(_e843) & 2147483647u)) / select(1e-30f, _e851, (_e851 > 1e-30f)));
let _e856 = select(0f, _e854, (_e854 > 0f));
let _e858 = select(1f, _e856, (_e856 < 1f));
let _e860 = (_e844 > 0f);
let _e862 = select(0f, select(_e858, 2f, _e860), (_e843 > 0f));
let _e865 = select(1f, _e858, (_e860 && (_e843 <= 0f)));
let _e867 = select(_e862, _e840, (_e840 > _e862));
let _e869 = select(_e865, _e842, (_e842 < _e865));
let _e870 = (_e520 - _e464);
let _e871 = (_e520 - _e482);
let _e878 = bitcast<f32>((bitcast<u32>((_e870 - _e871)) & 2147483647u));
let _e881 = (bitcast<f32>((bitcast<u32>(_e870) & 2147483647u)) / select(1e-30f, _e878, (_e878 > 1e-30f)));
let _e883 = select(0f, _e881, (_e881 > 0f));
let _e885 = select(1f, _e883, (_e883 < 1f));
let _e887 = (_e871 > 0f);
let _e889 = select(0f, select(_e885, 2f, _e887), (_e870 > 0f));
let _e892 = select(1f, _e885, (_e887 && (_e870 <= 0f)));
let _e894 = select(_e889, _e867, (_e867 > _e889));
let _e896 = select(_e892, _e869, (_e869 < _e892));
let _e897 = (_e464 - _e526);
let _e898 = (_e482 - _e526);
let _e905 = bitcast<f32>((bitcast<u32>((_e897 - _e898)) & 2147483647u));
let _e908 = (bitcast<f32>((bitcast<u32>(_e897) & 2147483647u)) / select(1e-30f, _e905, (_e905 > 1e-30f)));
let _e910 = select(0f, _e908, (_e908 > 0f));
let _e912 = select(1f, _e910, (_e910 < 1f));
let _e914 = (_e898 > 0f);
let _e916 = select(0f, select(_e912, 2f, _e914), (_e897 > 0f));
let _e919 = select(1f, _e912, (_e914 && (_e897 <= 0f)));
let _e921 = select(_e916, _e894, (_e894 > _e916));
let _e923 = select(_e919, _e896, (_e896 < _e919));
if _e740 {
phi_1895_ = type_32(_e921, _e923);
} else {
let _e929 = global_2.member[_e371].member_16.member;
let _e940 = ((((_e929.member.member * _e405) + (_e929.member.member_1 * _e407)) + (_e929.member.member_2 * _e395)) + _e929.member_1);
let _e946 = ((((_e929.member.member * _e409) + (_e929.member.member_1 * _e411)) + (_e929.member.member_2 * _e416)) + _e929.member_1);
let _e953 = bitcast<f32>((bitcast<u32>((_e940 - _e946)) & 2147483647u));
let _e956 = (bitcast<f32>((bitcast<u32>(_e940) & 2147483647u)) / select(1e-30f, _e953, (_e953 > 1e-30f)));
let _e958 = select(0f, _e956, (_e956 > 0f));
let _e960 = select(1f, _e958, (_e958 < 1f));
let _e962 = (_e946 > 0f);
let _e964 = select(0f, select(_e960, 2f, _e962), (_e940 > 0f));
let _e967 = select(1f, _e960, (_e962 && (_e940 <= 0f)));
let _e969 = select(_e964, _e921, (_e921 > _e964));
let _e971 = select(_e967, _e923, (_e923 < _e967));
let _e976 = global_2.member[_e371].member_17.member;
let _e987 = ((((_e976.member.member * _e405) + (_e976.member.member_1 * _e407)) + (_e976.member.member_2 * _e395)) + _e976.member_1);
let _e993 = ((((_e976.member.member * _e409) + (_e976.member.member_1 * _e411)) + (_e976.member.member_2 * _e416)) + _e976.member_1);
let _e1000 = bitcast<f32>((bitcast<u32>((_e987 - _e993)) & 2147483647u));
let _e1003 = (bitcast<f32>((bitcast<u32>(_e987) & 2147483647u)) / select(1e-30f, _e1000, (_e1000 > 1e-30f)));
let _e1005 = select(0f, _e1003, (_e1003 > 0f));
let _e1007 = select(1f, _e1005, (_e1005 < 1f));
let _e1009 = (_e993 > 0f);
let _e1011 = select(0f, select(_e1007, 2f, _e1009), (_e987 > 0f));
let _e1014 = select(1f, _e1007, (_e1009 && (_e987 <= 0f)));
let _e1016 = select(_e1011, _e969, (_e969 > _e1011));
let _e1018 = select(_e1014, _e971, (_e971 < _e1014));
let _e1023 = global_2.member[_e371].member_18.member;
let _e1034 = ((((_e1023.member.member * _e405) + (_e1023.member.member_1 * _e407)) + (_e1023.member.member_2 * _e395)) + _e1023.member_1);
let _e1040 = ((((_e1023.member.member * _e409) + (_e1023.member.member_1 * _e411)) + (_e1023.member.member_2 * _e416)) + _e1023.member_1);
let _e1047 = bitcast<f32>((bitcast<u32>((_e1034 - _e1040)) & 2147483647u));
let _e1050 = (bitcast<f32>((bitcast<u32>(_e1034) & 2147483647u)) / select(1e-30f, _e1047, (_e1047 > 1e-30f)));
let _e1052 = select(0f, _e1050, (_e1050 > 0f));
let _e1054 = select(1f, _e1052, (_e1052 < 1f));
let _e1056 = (_e1040 > 0f);
let _e1058 = select(0f, select(_e1054, 2f, _e1056), (_e1034 > 0f));
let _e1061 = select(1f, _e1054, (_e1056 && (_e1034 <= 0f)));
let _e1063 = select(_e1058, _e1016, (_e1016 > _e1058));
let _e1065 = select(_e1061, _e1018, (_e1018 < _e1061));
let _e1070 = global_2.member[_e371].member_19.member;
let _e1081 = ((((_e1070.member.member * _e405) + (_e1070.member.member_1 * _e407)) + (_e1070.member.member_2 * _e395)) + _e1070.member_1);
let _e1087 = ((((_e1070.member.member * _e409) + (_e1070.member.member_1 * _e411)) + (_e1070.member.member_2 * _e416)) + _e1070.member_1);
let _e1094 = bitcast<f32>((bitcast<u32>((_e1081 - _e1087)) & 2147483647u));
let _e1097 = (bitcast<f32>((bitcast<u32>(_e1081) & 2147483647u)) / select(1e-30f, _e1094, (_e1094 > 1e-30f)));
let _e1099 = select(0f, _e1097, (_e1097 > 0f));
let _e1101 = select(1f, _e1099, (_e1099 < 1f));
let _e1103 = (_e1087 > 0f);
let _e1105 = select(0f, select(_e1101, 2f, _e1103), (_e1081 > 0f));
let _e1108 = select(1f, _e1101, (_e1103 && (_e1081 <= 0f)));
phi_1895_ = type_32(select(_e1105, _e1063, (_e1063 > _e1105)), select(_e1108, _e1065, (_e1065 < _e1108)));
}
let _e1115 = phi_1895_;
let _e1118 = (_e1115.member_1 > _e1115.member);
let _e1119 = (_e409 - _e405);
let _e1120 = (_e411 - _e407);
let _e1121 = (_e416 - _e395);
if (_e380.member_2 == 2u) {
let _e1124 = (_e1115.member_1 - _e1115.member);
let _e1126 = (_e1115.member + (_e1124 * (0.5f * 0.25f)));
let _e1130 = (_e405 + (_e1119 * _e1126));
let _e1131 = (_e407 + (_e1120 * _e1126));
let _e1132 = (_e395 + (_e1121 * _e1126));
let _e1138 = ((((_e421.member.member * _e1130) + (_e421.member.member_1 * _e1131)) + (_e421.member.member_2 * _e1132)) + _e421.member_1);
let _e1144 = ((((_e437.member.member * _e1130) + (_e437.member.member_1 * _e1131)) + (_e437.member.member_2 * _e1132)) + _e437.member_1);
let _e1150 = ((((_e453.member.member * _e1130) + (_e453.member.member_1 * _e1131)) + (_e453.member.member_2 * _e1132)) + _e453.member_1);
let _e1152 = select(_e488, _e1138, (_e1138 > _e488));
let _e1154 = select(_e494, _e1152, (_e1152 < _e494));
let _e1156 = select(_e504, _e1144, (_e1144 > _e504));
let _e1158 = select(_e510, _e1156, (_e1156 < _e510));
let _e1160 = select(_e520, _e1150, (_e1150 > _e520));
let _e1162 = select(_e526, _e1160, (_e1160 < _e526));
let _e1168 = global_2.member[_e371].member_8.member_15;
let _e1169 = (_e1168 == 0u);
if _e1169 {
phi_2116_ = vec3<f32>(_e1154, _e1158, _e1162);
} else {
let _e1170 = (_e1154 + 0.5f);
let _e1172 = select(0f, _e1170, (_e1170 > 0f));
let _e1174 = select(_e578, _e1172, (_e1172 < _e578));
let _e1181 = select(0i, select(select(i32(_e1174), i32(-2147483648), (_e1174 < -2147483600f)), 2147483647i, (_e1174 > 2147483500f)), (_e1174 == _e1174));
let _e1187 = (_e1158 + 0.5f);
let _e1189 = select(0f, _e1187, (_e1187 > 0f));
let _e1191 = select(_e609, _e1189, (_e1189 < _e609));
let _e1198 = select(0i, select(select(i32(_e1191), i32(-2147483648), (_e1191 < -2147483600f)), 2147483647i, (_e1191 > 2147483500f)), (_e1191 == _e1191));
let _e1204 = (_e1162 + 0.5f);
let _e1206 = select(0f, _e1204, (_e1204 > 0f));
let _e1208 = select(_e634, _e1206, (_e1206 < _e634));
let _e1215 = select(0i, select(select(i32(_e1208), i32(-2147483648), (_e1208 < -2147483600f)), 2147483647i, (_e1208 > 2147483500f)), (_e1208 == _e1208));
phi_2116_ = vec3<f32>(f32((_e1181 - select(0i, 1i, (_e1174 < f32(_e1181))))), f32((_e1198 - select(0i, 1i, (_e1191 < f32(_e1198))))), f32((_e1215 - select(0i, 1i, (_e1208 < f32(_e1215))))));
}
let _e1223 = phi_2116_;
let _e1226 = select(-1f, _e1223.x, (_e1223.x > -1f));
let _e1228 = select(_e576, _e1226, (_e1226 < _e576));
let _e1235 = select(0i, select(select(i32(_e1228), i32(-2147483648), (_e1228 < -2147483600f)), 2147483647i, (_e1228 > 2147483500f)), (_e1228 == _e1228));
let _e1239 = (_e1235 - select(0i, 1i, (_e1228 < f32(_e1235))));
let _e1242 = select(-1f, _e1223.y, (_e1223.y > -1f));
let _e1244 = select(_e607, _e1242, (_e1242 < _e607));
let _e1251 = select(0i, select(select(i32(_e1244), i32(-2147483648), (_e1244 < -2147483600f)), 2147483647i, (_e1244 > 2147483500f)), (_e1244 == _e1244));
let _e1255 = (_e1251 - select(0i, 1i, (_e1244 < f32(_e1251))));
let _e1258 = select(-1f, _e1223.z, (_e1223.z > -1f));
let _e1260 = select(_e632, _e1258, (_e1258 < _e632));
let _e1267 = select(0i, select(select(i32(_e1260), i32(-2147483648), (_e1260 < -2147483600f)), 2147483647i, (_e1260 > 2147483500f)), (_e1260 == _e1260));
let _e1271 = (_e1267 - select(0i, 1i, (_e1260 < f32(_e1267))));
let _e1276 = global_2.member[_e371].member_8.member_9;
let _e1281 = global_2.member[_e371].member_8.member_10;
let _e1282 = (_e1239 + 1i);
let _e1283 = (_e1255 + 1i);
let _e1284 = (_e1271 + 1i);
let _e1290 = global_2.member[_e371].member_8.member_13.member;
let _e1291 = bitcast<i32>(_e1290);
let _e1297 = global_2.member[_e371].member_8.member_13.member_1;
let _e1298 = bitcast<i32>(_e1297);
let _e1308 = ((_e1282 >> bitcast<u32>(4i)) + (_e1291 * ((_e1283 >> bitcast<u32>(4i)) + (_e1298 * (_e1284 >> bitcast<u32>(4i))))));
let _e1310 = (bitcast<i32>(_e88) - 1i);
let _e1312 = select(_e1310, _e1308, (_e1308 < _e1310));
let _e1318 = global_1.member[bitcast<u32>(select(0i, _e1312, (_e1312 > 0i)))];
let _e1320 = (_e1282 & 15i);
let _e1323 = ((_e1283 & 15i) * _e1276);
let _e1325 = (bitcast<i32>(_e1318) + ((_e1284 & 15i) * _e1281));
let _e1329 = (_e1323 + _e1276);
let _e1330 = (2i * _e1276);
let _e1331 = (_e1323 + _e1330);
let _e1332 = (_e1325 + _e1281);
let _e1333 = (2i * _e1281);
let _e1334 = (_e1325 + _e1333);
local_16 = type_29(array<i32, 4>(_e1320, (_e1320 + 1i), (_e1320 + 2i), (_e1320 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_17 = (_e1223 - vec3<f32>(f32(_e1239), f32(_e1255), f32(_e1271)));
let _e1346 = local_16.member[1u];
let _e1347 = ((_e1332 + _e1329) + _e1346);
let _e1349 = (_e1347 >> bitcast<u32>(1i));
let _e1352 = bitcast<u32>(((_e1347 & 1i) * 16i));
let _e1354 = select(_e1310, _e1349, (_e1349 < _e1310));
let _e1359 = global_1.member[bitcast<u32>(select(0i, _e1354, (_e1354 > 0i)))];
let _e1363 = (_e1349 + 1i);
let _e1365 = select(_e1310, _e1363, (_e1363 < _e1310));
let _e1370 = global_1.member[bitcast<u32>(select(0i, _e1365, (_e1365 > 0i)))];
let _e1377 = ((_e1359 >> bitcast<u32>((_e1352 & 31u))) | ((_e1370 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1352) & 31u))));
let _e1380 = local_16.member_1[2u];
let _e1386 = f32(bitcast<i32>(((_e1377 >> bitcast<u32>((_e1380 & 31u))) & 65535u)));
let _e1389 = local_16.member_1[3u];
let _e1396 = local_17[0u];
let _e1399 = (_e1386 + ((f32(bitcast<i32>(((_e1377 >> bitcast<u32>((_e1389 & 31u))) & 65535u))) - _e1386) * _e1396));
let _e1401 = local_16.member[1u];
let _e1402 = ((_e1332 + _e1331) + _e1401);
let _e1404 = (_e1402 >> bitcast<u32>(1i));
let _e1407 = bitcast<u32>(((_e1402 & 1i) * 16i));
let _e1409 = select(_e1310, _e1404, (_e1404 < _e1310));
let _e1414 = global_1.member[bitcast<u32>(select(0i, _e1409, (_e1409 > 0i)))];
let _e1418 = (_e1404 + 1i);
let _e1420 = select(_e1310, _e1418, (_e1418 < _e1310));
let _e1425 = global_1.member[bitcast<u32>(select(0i, _e1420, (_e1420 > 0i)))];
let _e1432 = ((_e1414 >> bitcast<u32>((_e1407 & 31u))) | ((_e1425 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1407) & 31u))));
let _e1433 = local_16.member_1[2u];
let _e1439 = f32(bitcast<i32>(((_e1432 >> bitcast<u32>((_e1433 & 31u))) & 65535u)));
let _e1440 = local_16.member_1[3u];
let _e1447 = local_17[0u];
let _e1452 = local_17[1u];
let _e1455 = (_e1399 + (((_e1439 + ((f32(bitcast<i32>(((_e1432 >> bitcast<u32>((_e1440 & 31u))) & 65535u))) - _e1439) * _e1447)) - _e1399) * _e1452));
let _e1457 = local_16.member[1u];
let _e1458 = ((_e1334 + _e1329) + _e1457);
let _e1460 = (_e1458 >> bitcast<u32>(1i));
let _e1463 = bitcast<u32>(((_e1458 & 1i) * 16i));
let _e1465 = select(_e1310, _e1460, (_e1460 < _e1310));
let _e1470 = global_1.member[bitcast<u32>(select(0i, _e1465, (_e1465 > 0i)))];
let _e1474 = (_e1460 + 1i);
let _e1476 = select(_e1310, _e1474, (_e1474 < _e1310));
let _e1481 = global_1.member[bitcast<u32>(select(0i, _e1476, (_e1476 > 0i)))];
let _e1488 = ((_e1470 >> bitcast<u32>((_e1463 & 31u))) | ((_e1481 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1463) & 31u))));
let _e1489 = local_16.member_1[2u];
let _e1495 = f32(bitcast<i32>(((_e1488 >> bitcast<u32>((_e1489 & 31u))) & 65535u)));
let _e1496 = local_16.member_1[3u];
let _e1503 = local_17[0u];
let _e1506 = (_e1495 + ((f32(bitcast<i32>(((_e1488 >> bitcast<u32>((_e1496 & 31u))) & 65535u))) - _e1495) * _e1503));
let _e1508 = local_16.member[1u];
let _e1509 = ((_e1334 + _e1331) + _e1508);
let _e1511 = (_e1509 >> bitcast<u32>(1i));
let _e1514 = bitcast<u32>(((_e1509 & 1i) * 16i));
let _e1516 = select(_e1310, _e1511, (_e1511 < _e1310));
let _e1521 = global_1.member[bitcast<u32>(select(0i, _e1516, (_e1516 > 0i)))];
let _e1525 = (_e1511 + 1i);
let _e1527 = select(_e1310, _e1525, (_e1525 < _e1310));
let _e1532 = global_1.member[bitcast<u32>(select(0i, _e1527, (_e1527 > 0i)))];
let _e1539 = ((_e1521 >> bitcast<u32>((_e1514 & 31u))) | ((_e1532 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1514) & 31u))));
let _e1540 = local_16.member_1[2u];
let _e1546 = f32(bitcast<i32>(((_e1539 >> bitcast<u32>((_e1540 & 31u))) & 65535u)));
let _e1547 = local_16.member_1[3u];
let _e1554 = local_17[0u];
let _e1558 = local_17[1u];
let _e1563 = local_17[2u];
let _e1571 = global_2.member[_e371].member_8.member_8;
let _e1576 = global_2.member[_e371].member_8.member_7;
let _e1578 = (((_e1455 + (((_e1506 + (((_e1546 + ((f32(bitcast<i32>(((_e1539 >> bitcast<u32>((_e1547 & 31u))) & 65535u))) - _e1546) * _e1554)) - _e1506) * _e1558)) - _e1455) * _e1563)) - _e1571) * _e1576);
let _e1579 = -(1e9f);
let _e1581 = select(_e1579, _e1578, (_e1578 > _e1579));
let _e1586 = (_e1115.member + (_e1124 * (1.5f * 0.25f)));
let _e1590 = (_e405 + (_e1119 * _e1586));
let _e1591 = (_e407 + (_e1120 * _e1586));
let _e1592 = (_e395 + (_e1121 * _e1586));
let _e1598 = ((((_e421.member.member * _e1590) + (_e421.member.member_1 * _e1591)) + (_e421.member.member_2 * _e1592)) + _e421.member_1);
let _e1604 = ((((_e437.member.member * _e1590) + (_e437.member.member_1 * _e1591)) + (_e437.member.member_2 * _e1592)) + _e437.member_1);
let _e1610 = ((((_e453.member.member * _e1590) + (_e453.member.member_1 * _e1591)) + (_e453.member.member_2 * _e1592)) + _e453.member_1);
let _e1612 = select(_e488, _e1598, (_e1598 > _e488));
let _e1614 = select(_e494, _e1612, (_e1612 < _e494));
let _e1616 = select(_e504, _e1604, (_e1604 > _e504));
let _e1618 = select(_e510, _e1616, (_e1616 < _e510));
let _e1620 = select(_e520, _e1610, (_e1610 > _e520));
let _e1622 = select(_e526, _e1620, (_e1620 < _e526));
if _e1169 {
phi_2788_ = vec3<f32>(_e1614, _e1618, _e1622);
} else {
let _e1624 = (_e1614 + 0.5f);
let _e1626 = select(0f, _e1624, (_e1624 > 0f));
let _e1628 = select(_e578, _e1626, (_e1626 < _e578));
let _e1635 = select(0i, select(select(i32(_e1628), i32(-2147483648), (_e1628 < -2147483600f)), 2147483647i, (_e1628 > 2147483500f)), (_e1628 == _e1628));
let _e1641 = (_e1618 + 0.5f);
let _e1643 = select(0f, _e1641, (_e1641 > 0f));
let _e1645 = select(_e609, _e1643, (_e1643 < _e609));
let _e1652 = select(0i, select(select(i32(_e1645), i32(-2147483648), (_e1645 < -2147483600f)), 2147483647i, (_e1645 > 2147483500f)), (_e1645 == _e1645));
let _e1658 = (_e1622 + 0.5f);
let _e1660 = select(0f, _e1658, (_e1658 > 0f));
let _e1662 = select(_e634, _e1660, (_e1660 < _e634));
let _e1669 = select(0i, select(select(i32(_e1662), i32(-2147483648), (_e1662 < -2147483600f)), 2147483647i, (_e1662 > 2147483500f)), (_e1662 == _e1662));
phi_2788_ = vec3<f32>(f32((_e1635 - select(0i, 1i, (_e1628 < f32(_e1635))))), f32((_e1652 - select(0i, 1i, (_e1645 < f32(_e1652))))), f32((_e1669 - select(0i, 1i, (_e1662 < f32(_e1669))))));
}
let _e1677 = phi_2788_;
let _e1680 = select(-1f, _e1677.x, (_e1677.x > -1f));
let _e1682 = select(_e576, _e1680, (_e1680 < _e576));
let _e1689 = select(0i, select(select(i32(_e1682), i32(-2147483648), (_e1682 < -2147483600f)), 2147483647i, (_e1682 > 2147483500f)), (_e1682 == _e1682));
let _e1693 = (_e1689 - select(0i, 1i, (_e1682 < f32(_e1689))));
let _e1696 = select(-1f, _e1677.y, (_e1677.y > -1f));
let _e1698 = select(_e607, _e1696, (_e1696 < _e607));
let _e1705 = select(0i, select(select(i32(_e1698), i32(-2147483648), (_e1698 < -2147483600f)), 2147483647i, (_e1698 > 2147483500f)), (_e1698 == _e1698));
let _e1709 = (_e1705 - select(0i, 1i, (_e1698 < f32(_e1705))));
let _e1712 = select(-1f, _e1677.z, (_e1677.z > -1f));
let _e1714 = select(_e632, _e1712, (_e1712 < _e632));
let _e1721 = select(0i, select(select(i32(_e1714), i32(-2147483648), (_e1714 < -2147483600f)), 2147483647i, (_e1714 > 2147483500f)), (_e1714 == _e1714));
let _e1725 = (_e1721 - select(0i, 1i, (_e1714 < f32(_e1721))));
let _e1726 = (_e1693 + 1i);
let _e1727 = (_e1709 + 1i);
let _e1728 = (_e1725 + 1i);
let _e1738 = ((_e1726 >> bitcast<u32>(4i)) + (_e1291 * ((_e1727 >> bitcast<u32>(4i)) + (_e1298 * (_e1728 >> bitcast<u32>(4i))))));
let _e1740 = select(_e1310, _e1738, (_e1738 < _e1310));
let _e1746 = global_1.member[bitcast<u32>(select(0i, _e1740, (_e1740 > 0i)))];
let _e1748 = (_e1726 & 15i);
let _e1751 = ((_e1727 & 15i) * _e1276);
let _e1753 = (bitcast<i32>(_e1746) + ((_e1728 & 15i) * _e1281));
let _e1757 = (_e1751 + _e1276);
let _e1758 = (_e1751 + _e1330);
let _e1759 = (_e1753 + _e1281);
let _e1760 = (_e1753 + _e1333);
local_14 = type_29(array<i32, 4>(_e1748, (_e1748 + 1i), (_e1748 + 2i), (_e1748 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_15 = (_e1677 - vec3<f32>(f32(_e1693), f32(_e1709), f32(_e1725)));
let _e1772 = local_14.member[1u];
let _e1773 = ((_e1759 + _e1757) + _e1772);
let _e1775 = (_e1773 >> bitcast<u32>(1i));
let _e1778 = bitcast<u32>(((_e1773 & 1i) * 16i));
let _e1780 = select(_e1310, _e1775, (_e1775 < _e1310));
let _e1785 = global_1.member[bitcast<u32>(select(0i, _e1780, (_e1780 > 0i)))];
let _e1789 = (_e1775 + 1i);
let _e1791 = select(_e1310, _e1789, (_e1789 < _e1310));
let _e1796 = global_1.member[bitcast<u32>(select(0i, _e1791, (_e1791 > 0i)))];
let _e1803 = ((_e1785 >> bitcast<u32>((_e1778 & 31u))) | ((_e1796 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1778) & 31u))));
let _e1806 = local_14.member_1[2u];
let _e1812 = f32(bitcast<i32>(((_e1803 >> bitcast<u32>((_e1806 & 31u))) & 65535u)));
let _e1815 = local_14.member_1[3u];
let _e1822 = local_15[0u];
let _e1825 = (_e1812 + ((f32(bitcast<i32>(((_e1803 >> bitcast<u32>((_e1815 & 31u))) & 65535u))) - _e1812) * _e1822));
let _e1827 = local_14.member[1u];
let _e1828 = ((_e1759 + _e1758) + _e1827);
let _e1830 = (_e1828 >> bitcast<u32>(1i));
let _e1833 = bitcast<u32>(((_e1828 & 1i) * 16i));
let _e1835 = select(_e1310, _e1830, (_e1830 < _e1310));
let _e1840 = global_1.member[bitcast<u32>(select(0i, _e1835, (_e1835 > 0i)))];
let _e1844 = (_e1830 + 1i);
let _e1846 = select(_e1310, _e1844, (_e1844 < _e1310));
let _e1851 = global_1.member[bitcast<u32>(select(0i, _e1846, (_e1846 > 0i)))];
let _e1858 = ((_e1840 >> bitcast<u32>((_e1833 & 31u))) | ((_e1851 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1833) & 31u))));
let _e1859 = local_14.member_1[2u];
let _e1865 = f32(bitcast<i32>(((_e1858 >> bitcast<u32>((_e1859 & 31u))) & 65535u)));
let _e1866 = local_14.member_1[3u];
let _e1873 = local_15[0u];
let _e1878 = local_15[1u];
let _e1881 = (_e1825 + (((_e1865 + ((f32(bitcast<i32>(((_e1858 >> bitcast<u32>((_e1866 & 31u))) & 65535u))) - _e1865) * _e1873)) - _e1825) * _e1878));
let _e1883 = local_14.member[1u];
let _e1884 = ((_e1760 + _e1757) + _e1883);
let _e1886 = (_e1884 >> bitcast<u32>(1i));
let _e1889 = bitcast<u32>(((_e1884 & 1i) * 16i));
let _e1891 = select(_e1310, _e1886, (_e1886 < _e1310));
let _e1896 = global_1.member[bitcast<u32>(select(0i, _e1891, (_e1891 > 0i)))];
let _e1900 = (_e1886 + 1i);
let _e1902 = select(_e1310, _e1900, (_e1900 < _e1310));
let _e1907 = global_1.member[bitcast<u32>(select(0i, _e1902, (_e1902 > 0i)))];
let _e1914 = ((_e1896 >> bitcast<u32>((_e1889 & 31u))) | ((_e1907 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1889) & 31u))));
let _e1915 = local_14.member_1[2u];
let _e1921 = f32(bitcast<i32>(((_e1914 >> bitcast<u32>((_e1915 & 31u))) & 65535u)));
let _e1922 = local_14.member_1[3u];
let _e1929 = local_15[0u];
let _e1932 = (_e1921 + ((f32(bitcast<i32>(((_e1914 >> bitcast<u32>((_e1922 & 31u))) & 65535u))) - _e1921) * _e1929));
let _e1934 = local_14.member[1u];
let _e1935 = ((_e1760 + _e1758) + _e1934);
let _e1937 = (_e1935 >> bitcast<u32>(1i));
let _e1940 = bitcast<u32>(((_e1935 & 1i) * 16i));
let _e1942 = select(_e1310, _e1937, (_e1937 < _e1310));
let _e1947 = global_1.member[bitcast<u32>(select(0i, _e1942, (_e1942 > 0i)))];
let _e1951 = (_e1937 + 1i);
let _e1953 = select(_e1310, _e1951, (_e1951 < _e1310));
let _e1958 = global_1.member[bitcast<u32>(select(0i, _e1953, (_e1953 > 0i)))];
let _e1965 = ((_e1947 >> bitcast<u32>((_e1940 & 31u))) | ((_e1958 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1940) & 31u))));
let _e1966 = local_14.member_1[2u];
let _e1972 = f32(bitcast<i32>(((_e1965 >> bitcast<u32>((_e1966 & 31u))) & 65535u)));
let _e1973 = local_14.member_1[3u];
let _e1980 = local_15[0u];
let _e1984 = local_15[1u];
let _e1989 = local_15[2u];
let _e1994 = (((_e1881 + (((_e1932 + (((_e1972 + ((f32(bitcast<i32>(((_e1965 >> bitcast<u32>((_e1973 & 31u))) & 65535u))) - _e1972) * _e1980)) - _e1932) * _e1984)) - _e1881) * _e1989)) - _e1571) * _e1576);
let _e1996 = select(_e1579, _e1994, (_e1994 > _e1579));
let _e2001 = (_e1115.member + (_e1124 * (2.5f * 0.25f)));
let _e2005 = (_e405 + (_e1119 * _e2001));
let _e2006 = (_e407 + (_e1120 * _e2001));
let _e2007 = (_e395 + (_e1121 * _e2001));
let _e2013 = ((((_e421.member.member * _e2005) + (_e421.member.member_1 * _e2006)) + (_e421.member.member_2 * _e2007)) + _e421.member_1);
let _e2019 = ((((_e437.member.member * _e2005) + (_e437.member.member_1 * _e2006)) + (_e437.member.member_2 * _e2007)) + _e437.member_1);
let _e2025 = ((((_e453.member.member * _e2005) + (_e453.member.member_1 * _e2006)) + (_e453.member.member_2 * _e2007)) + _e453.member_1);
let _e2027 = select(_e488, _e2013, (_e2013 > _e488));
let _e2029 = select(_e494, _e2027, (_e2027 < _e494));
let _e2031 = select(_e504, _e2019, (_e2019 > _e504));
let _e2033 = select(_e510, _e2031, (_e2031 < _e510));
let _e2035 = select(_e520, _e2025, (_e2025 > _e520));
let _e2037 = select(_e526, _e2035, (_e2035 < _e526));
if _e1169 {
phi_3460_ = vec3<f32>(_e2029, _e2033, _e2037);
} else {
let _e2039 = (_e2029 + 0.5f);
let _e2041 = select(0f, _e2039, (_e2039 > 0f));
let _e2043 = select(_e578, _e2041, (_e2041 < _e578));
let _e2050 = select(0i, select(select(i32(_e2043), i32(-2147483648), (_e2043 < -2147483600f)), 2147483647i, (_e2043 > 2147483500f)), (_e2043 == _e2043));
let _e2056 = (_e2033 + 0.5f);
let _e2058 = select(0f, _e2056, (_e2056 > 0f));
let _e2060 = select(_e609, _e2058, (_e2058 < _e609));
let _e2067 = select(0i, select(select(i32(_e2060), i32(-2147483648), (_e2060 < -2147483600f)), 2147483647i, (_e2060 > 2147483500f)), (_e2060 == _e2060));
let _e2073 = (_e2037 + 0.5f);
let _e2075 = select(0f, _e2073, (_e2073 > 0f));
let _e2077 = select(_e634, _e2075, (_e2075 < _e634));
let _e2084 = select(0i, select(select(i32(_e2077), i32(-2147483648), (_e2077 < -2147483600f)), 2147483647i, (_e2077 > 2147483500f)), (_e2077 == _e2077));
phi_3460_ = vec3<f32>(f32((_e2050 - select(0i, 1i, (_e2043 < f32(_e2050))))), f32((_e2067 - select(0i, 1i, (_e2060 < f32(_e2067))))), f32((_e2084 - select(0i, 1i, (_e2077 < f32(_e2084))))));
}
let _e2092 = phi_3460_;
let _e2095 = select(-1f, _e2092.x, (_e2092.x > -1f));
let _e2097 = select(_e576, _e2095, (_e2095 < _e576));
let _e2104 = select(0i, select(select(i32(_e2097), i32(-2147483648), (_e2097 < -2147483600f)), 2147483647i, (_e2097 > 2147483500f)), (_e2097 == _e2097));
let _e2108 = (_e2104 - select(0i, 1i, (_e2097 < f32(_e2104))));
let _e2111 = select(-1f, _e2092.y, (_e2092.y > -1f));
let _e2113 = select(_e607, _e2111, (_e2111 < _e607));
let _e2120 = select(0i, select(select(i32(_e2113), i32(-2147483648), (_e2113 < -2147483600f)), 2147483647i, (_e2113 > 2147483500f)), (_e2113 == _e2113));
let _e2124 = (_e2120 - select(0i, 1i, (_e2113 < f32(_e2120))));
let _e2127 = select(-1f, _e2092.z, (_e2092.z > -1f));
let _e2129 = select(_e632, _e2127, (_e2127 < _e632));
let _e2136 = select(0i, select(select(i32(_e2129), i32(-2147483648), (_e2129 < -2147483600f)), 2147483647i, (_e2129 > 2147483500f)), (_e2129 == _e2129));
let _e2140 = (_e2136 - select(0i, 1i, (_e2129 < f32(_e2136))));
let _e2141 = (_e2108 + 1i);
let _e2142 = (_e2124 + 1i);
let _e2143 = (_e2140 + 1i);
let _e2153 = ((_e2141 >> bitcast<u32>(4i)) + (_e1291 * ((_e2142 >> bitcast<u32>(4i)) + (_e1298 * (_e2143 >> bitcast<u32>(4i))))));
let _e2155 = select(_e1310, _e2153, (_e2153 < _e1310));
let _e2161 = global_1.member[bitcast<u32>(select(0i, _e2155, (_e2155 > 0i)))];
let _e2163 = (_e2141 & 15i);
let _e2166 = ((_e2142 & 15i) * _e1276);
let _e2168 = (bitcast<i32>(_e2161) + ((_e2143 & 15i) * _e1281));
let _e2172 = (_e2166 + _e1276);
let _e2173 = (_e2166 + _e1330);
let _e2174 = (_e2168 + _e1281);
let _e2175 = (_e2168 + _e1333);
local_12 = type_29(array<i32, 4>(_e2163, (_e2163 + 1i), (_e2163 + 2i), (_e2163 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_13 = (_e2092 - vec3<f32>(f32(_e2108), f32(_e2124), f32(_e2140)));
let _e2187 = local_12.member[1u];
let _e2188 = ((_e2174 + _e2172) + _e2187);
let _e2190 = (_e2188 >> bitcast<u32>(1i));
let _e2193 = bitcast<u32>(((_e2188 & 1i) * 16i));
let _e2195 = select(_e1310, _e2190, (_e2190 < _e1310));
let _e2200 = global_1.member[bitcast<u32>(select(0i, _e2195, (_e2195 > 0i)))];
let _e2204 = (_e2190 + 1i);
let _e2206 = select(_e1310, _e2204, (_e2204 < _e1310));
let _e2211 = global_1.member[bitcast<u32>(select(0i, _e2206, (_e2206 > 0i)))];
let _e2218 = ((_e2200 >> bitcast<u32>((_e2193 & 31u))) | ((_e2211 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2193) & 31u))));
let _e2221 = local_12.member_1[2u];
let _e2227 = f32(bitcast<i32>(((_e2218 >> bitcast<u32>((_e2221 & 31u))) & 65535u)));
let _e2230 = local_12.member_1[3u];
let _e2237 = local_13[0u];
let _e2240 = (_e2227 + ((f32(bitcast<i32>(((_e2218 >> bitcast<u32>((_e2230 & 31u))) & 65535u))) - _e2227) * _e2237));
let _e2242 = local_12.member[1u];
let _e2243 = ((_e2174 + _e2173) + _e2242);
let _e2245 = (_e2243 >> bitcast<u32>(1i));
let _e2248 = bitcast<u32>(((_e2243 & 1i) * 16i));
let _e2250 = select(_e1310, _e2245, (_e2245 < _e1310));
let _e2255 = global_1.member[bitcast<u32>(select(0i, _e2250, (_e2250 > 0i)))];
let _e2259 = (_e2245 + 1i);
let _e2261 = select(_e1310, _e2259, (_e2259 < _e1310));
let _e2266 = global_1.member[bitcast<u32>(select(0i, _e2261, (_e2261 > 0i)))];
let _e2273 = ((_e2255 >> bitcast<u32>((_e2248 & 31u))) | ((_e2266 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2248) & 31u))));
let _e2274 = local_12.member_1[2u];
let _e2280 = f32(bitcast<i32>(((_e2273 >> bitcast<u32>((_e2274 & 31u))) & 65535u)));
let _e2281 = local_12.member_1[3u];
let _e2288 = local_13[0u];
let _e2293 = local_13[1u];
let _e2296 = (_e2240 + (((_e2280 + ((f32(bitcast<i32>(((_e2273 >> bitcast<u32>((_e2281 & 31u))) & 65535u))) - _e2280) * _e2288)) - _e2240) * _e2293));
let _e2298 = local_12.member[1u];
let _e2299 = ((_e2175 + _e2172) + _e2298);
let _e2301 = (_e2299 >> bitcast<u32>(1i));
let _e2304 = bitcast<u32>(((_e2299 & 1i) * 16i));
let _e2306 = select(_e1310, _e2301, (_e2301 < _e1310));
let _e2311 = global_1.member[bitcast<u32>(select(0i, _e2306, (_e2306 > 0i)))];
let _e2315 = (_e2301 + 1i);
let _e2317 = select(_e1310, _e2315, (_e2315 < _e1310));
let _e2322 = global_1.member[bitcast<u32>(select(0i, _e2317, (_e2317 > 0i)))];
let _e2329 = ((_e2311 >> bitcast<u32>((_e2304 & 31u))) | ((_e2322 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2304) & 31u))));
let _e2330 = local_12.member_1[2u];
let _e2336 = f32(bitcast<i32>(((_e2329 >> bitcast<u32>((_e2330 & 31u))) & 65535u)));
let _e2337 = local_12.member_1[3u];
let _e2344 = local_13[0u];
let _e2347 = (_e2336 + ((f32(bitcast<i32>(((_e2329 >> bitcast<u32>((_e2337 & 31u))) & 65535u))) - _e2336) * _e2344));
let _e2349 = local_12.member[1u];
let _e2350 = ((_e2175 + _e2173) + _e2349);
let _e2352 = (_e2350 >> bitcast<u32>(1i));
let _e2355 = bitcast<u32>(((_e2350 & 1i) * 16i));
let _e2357 = select(_e1310, _e2352, (_e2352 < _e1310));
let _e2362 = global_1.member[bitcast<u32>(select(0i, _e2357, (_e2357 > 0i)))];
let _e2366 = (_e2352 + 1i);
let _e2368 = select(_e1310, _e2366, (_e2366 < _e1310));
let _e2373 = global_1.member[bitcast<u32>(select(0i, _e2368, (_e2368 > 0i)))];
let _e2380 = ((_e2362 >> bitcast<u32>((_e2355 & 31u))) | ((_e2373 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2355) & 31u))));
let _e2381 = local_12.member_1[2u];
let _e2387 = f32(bitcast<i32>(((_e2380 >> bitcast<u32>((_e2381 & 31u))) & 65535u)));
let _e2388 = local_12.member_1[3u];
let _e2395 = local_13[0u];
let _e2399 = local_13[1u];
let _e2404 = local_13[2u];
let _e2409 = (((_e2296 + (((_e2347 + (((_e2387 + ((f32(bitcast<i32>(((_e2380 >> bitcast<u32>((_e2388 & 31u))) & 65535u))) - _e2387) * _e2395)) - _e2347) * _e2399)) - _e2296) * _e2404)) - _e1571) * _e1576);
let _e2411 = select(_e1579, _e2409, (_e2409 > _e1579));
let _e2416 = (_e1115.member + (_e1124 * (3.5f * 0.25f)));
let _e2420 = (_e405 + (_e1119 * _e2416));
let _e2421 = (_e407 + (_e1120 * _e2416));
let _e2422 = (_e395 + (_e1121 * _e2416));
let _e2428 = ((((_e421.member.member * _e2420) + (_e421.member.member_1 * _e2421)) + (_e421.member.member_2 * _e2422)) + _e421.member_1);
let _e2434 = ((((_e437.member.member * _e2420) + (_e437.member.member_1 * _e2421)) + (_e437.member.member_2 * _e2422)) + _e437.member_1);
let _e2440 = ((((_e453.member.member * _e2420) + (_e453.member.member_1 * _e2421)) + (_e453.member.member_2 * _e2422)) + _e453.member_1);
let _e2442 = select(_e488, _e2428, (_e2428 > _e488));
let _e2444 = select(_e494, _e2442, (_e2442 < _e494));
let _e2446 = select(_e504, _e2434, (_e2434 > _e504));
let _e2448 = select(_e510, _e2446, (_e2446 < _e510));
let _e2450 = select(_e520, _e2440, (_e2440 > _e520));
let _e2452 = select(_e526, _e2450, (_e2450 < _e526));
if _e1169 {
phi_4132_ = vec3<f32>(_e2444, _e2448, _e2452);
} else {
let _e2454 = (_e2444 + 0.5f);
let _e2456 = select(0f, _e2454, (_e2454 > 0f));
let _e2458 = select(_e578, _e2456, (_e2456 < _e578));
let _e2465 = select(0i, select(select(i32(_e2458), i32(-2147483648), (_e2458 < -2147483600f)), 2147483647i, (_e2458 > 2147483500f)), (_e2458 == _e2458));
let _e2471 = (_e2448 + 0.5f);
let _e2473 = select(0f, _e2471, (_e2471 > 0f));
let _e2475 = select(_e609, _e2473, (_e2473 < _e609));
let _e2482 = select(0i, select(select(i32(_e2475), i32(-2147483648), (_e2475 < -2147483600f)), 2147483647i, (_e2475 > 2147483500f)), (_e2475 == _e2475));
let _e2488 = (_e2452 + 0.5f);
let _e2490 = select(0f, _e2488, (_e2488 > 0f));
let _e2492 = select(_e634, _e2490, (_e2490 < _e634));
let _e2499 = select(0i, select(select(i32(_e2492), i32(-2147483648), (_e2492 < -2147483600f)), 2147483647i, (_e2492 > 2147483500f)), (_e2492 == _e2492));
phi_4132_ = vec3<f32>(f32((_e2465 - select(0i, 1i, (_e2458 < f32(_e2465))))), f32((_e2482 - select(0i, 1i, (_e2475 < f32(_e2482))))), f32((_e2499 - select(0i, 1i, (_e2492 < f32(_e2499))))));
}
let _e2507 = phi_4132_;
let _e2510 = select(-1f, _e2507.x, (_e2507.x > -1f));
let _e2512 = select(_e576, _e2510, (_e2510 < _e576));
let _e2519 = select(0i, select(select(i32(_e2512), i32(-2147483648), (_e2512 < -2147483600f)), 2147483647i, (_e2512 > 2147483500f)), (_e2512 == _e2512));
let _e2523 = (_e2519 - select(0i, 1i, (_e2512 < f32(_e2519))));
let _e2526 = select(-1f, _e2507.y, (_e2507.y > -1f));
let _e2528 = select(_e607, _e2526, (_e2526 < _e607));
let _e2535 = select(0i, select(select(i32(_e2528), i32(-2147483648), (_e2528 < -2147483600f)), 2147483647i, (_e2528 > 2147483500f)), (_e2528 == _e2528));
let _e2539 = (_e2535 - select(0i, 1i, (_e2528 < f32(_e2535))));
let _e2542 = select(-1f, _e2507.z, (_e2507.z > -1f));
let _e2544 = select(_e632, _e2542, (_e2542 < _e632));
let _e2551 = select(0i, select(select(i32(_e2544), i32(-2147483648), (_e2544 < -2147483600f)), 2147483647i, (_e2544 > 2147483500f)), (_e2544 == _e2544));
let _e2555 = (_e2551 - select(0i, 1i, (_e2544 < f32(_e2551))));
let _e2556 = (_e2523 + 1i);
let _e2557 = (_e2539 + 1i);
let _e2558 = (_e2555 + 1i);
let _e2568 = ((_e2556 >> bitcast<u32>(4i)) + (_e1291 * ((_e2557 >> bitcast<u32>(4i)) + (_e1298 * (_e2558 >> bitcast<u32>(4i))))));
let _e2570 = select(_e1310, _e2568, (_e2568 < _e1310));
let _e2576 = global_1.member[bitcast<u32>(select(0i, _e2570, (_e2570 > 0i)))];
let _e2578 = (_e2556 & 15i);
let _e2581 = ((_e2557 & 15i) * _e1276);
let _e2583 = (bitcast<i32>(_e2576) + ((_e2558 & 15i) * _e1281));
let _e2587 = (_e2581 + _e1276);
let _e2588 = (_e2581 + _e1330);
let _e2589 = (_e2583 + _e1281);
let _e2590 = (_e2583 + _e1333);
local_10 = type_29(array<i32, 4>(_e2578, (_e2578 + 1i), (_e2578 + 2i), (_e2578 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_11 = (_e2507 - vec3<f32>(f32(_e2523), f32(_e2539), f32(_e2555)));
let _e2602 = local_10.member[1u];
let _e2603 = ((_e2589 + _e2587) + _e2602);
let _e2605 = (_e2603 >> bitcast<u32>(1i));
let _e2608 = bitcast<u32>(((_e2603 & 1i) * 16i));
let _e2610 = select(_e1310, _e2605, (_e2605 < _e1310));
let _e2615 = global_1.member[bitcast<u32>(select(0i, _e2610, (_e2610 > 0i)))];
let _e2619 = (_e2605 + 1i);
let _e2621 = select(_e1310, _e2619, (_e2619 < _e1310));
let _e2626 = global_1.member[bitcast<u32>(select(0i, _e2621, (_e2621 > 0i)))];
let _e2633 = ((_e2615 >> bitcast<u32>((_e2608 & 31u))) | ((_e2626 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2608) & 31u))));
let _e2636 = local_10.member_1[2u];
let _e2642 = f32(bitcast<i32>(((_e2633 >> bitcast<u32>((_e2636 & 31u))) & 65535u)));
let _e2645 = local_10.member_1[3u];
let _e2652 = local_11[0u];
let _e2655 = (_e2642 + ((f32(bitcast<i32>(((_e2633 >> bitcast<u32>((_e2645 & 31u))) & 65535u))) - _e2642) * _e2652));
let _e2657 = local_10.member[1u];
let _e2658 = ((_e2589 + _e2588) + _e2657);
let _e2660 = (_e2658 >> bitcast<u32>(1i));
let _e2663 = bitcast<u32>(((_e2658 & 1i) * 16i));
let _e2665 = select(_e1310, _e2660, (_e2660 < _e1310));
let _e2670 = global_1.member[bitcast<u32>(select(0i, _e2665, (_e2665 > 0i)))];
let _e2674 = (_e2660 + 1i);
let _e2676 = select(_e1310, _e2674, (_e2674 < _e1310));
let _e2681 = global_1.member[bitcast<u32>(select(0i, _e2676, (_e2676 > 0i)))];
let _e2688 = ((_e2670 >> bitcast<u32>((_e2663 & 31u))) | ((_e2681 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2663) & 31u))));
let _e2689 = local_10.member_1[2u];
let _e2695 = f32(bitcast<i32>(((_e2688 >> bitcast<u32>((_e2689 & 31u))) & 65535u)));
let _e2696 = local_10.member_1[3u];
let _e2703 = local_11[0u];
let _e2708 = local_11[1u];
let _e2711 = (_e2655 + (((_e2695 + ((f32(bitcast<i32>(((_e2688 >> bitcast<u32>((_e2696 & 31u))) & 65535u))) - _e2695) * _e2703)) - _e2655) * _e2708));
let _e2713 = local_10.member[1u];
let _e2714 = ((_e2590 + _e2587) + _e2713);
let _e2716 = (_e2714 >> bitcast<u32>(1i));
let _e2719 = bitcast<u32>(((_e2714 & 1i) * 16i));
let _e2721 = select(_e1310, _e2716, (_e2716 < _e1310));
let _e2726 = global_1.member[bitcast<u32>(select(0i, _e2721, (_e2721 > 0i)))];
let _e2730 = (_e2716 + 1i);
let _e2732 = select(_e1310, _e2730, (_e2730 < _e1310));
let _e2737 = global_1.member[bitcast<u32>(select(0i, _e2732, (_e2732 > 0i)))];
let _e2744 = ((_e2726 >> bitcast<u32>((_e2719 & 31u))) | ((_e2737 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2719) & 31u))));
let _e2745 = local_10.member_1[2u];
let _e2751 = f32(bitcast<i32>(((_e2744 >> bitcast<u32>((_e2745 & 31u))) & 65535u)));
let _e2752 = local_10.member_1[3u];
let _e2759 = local_11[0u];
let _e2762 = (_e2751 + ((f32(bitcast<i32>(((_e2744 >> bitcast<u32>((_e2752 & 31u))) & 65535u))) - _e2751) * _e2759));
let _e2764 = local_10.member[1u];
let _e2765 = ((_e2590 + _e2588) + _e2764);
let _e2767 = (_e2765 >> bitcast<u32>(1i));
let _e2770 = bitcast<u32>(((_e2765 & 1i) * 16i));
let _e2772 = select(_e1310, _e2767, (_e2767 < _e1310));
let _e2777 = global_1.member[bitcast<u32>(select(0i, _e2772, (_e2772 > 0i)))];
let _e2781 = (_e2767 + 1i);
let _e2783 = select(_e1310, _e2781, (_e2781 < _e1310));
let _e2788 = global_1.member[bitcast<u32>(select(0i, _e2783, (_e2783 > 0i)))];
let _e2795 = ((_e2777 >> bitcast<u32>((_e2770 & 31u))) | ((_e2788 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2770) & 31u))));
let _e2796 = local_10.member_1[2u];
let _e2802 = f32(bitcast<i32>(((_e2795 >> bitcast<u32>((_e2796 & 31u))) & 65535u)));
let _e2803 = local_10.member_1[3u];
let _e2810 = local_11[0u];
let _e2814 = local_11[1u];
let _e2819 = local_11[2u];
let _e2824 = (((_e2711 + (((_e2762 + (((_e2802 + ((f32(bitcast<i32>(((_e2795 >> bitcast<u32>((_e2803 & 31u))) & 65535u))) - _e2802) * _e2810)) - _e2762) * _e2814)) - _e2711) * _e2819)) - _e1571) * _e1576);
let _e2826 = select(_e1579, _e2824, (_e2824 > _e1579));
let _e2833 = (((_e1119 * _e1119) + (_e1120 * _e1120)) + (_e1121 * _e1121));
let _e2838 = select(0f, (sqrt(select(0f, _e2833, (_e2833 > 0f))) * _e1124), _e1118);
phi_8077_ = (_e375[8] + _e2838);
phi_8078_ = (_e375[6] + ((((select(1e9f, _e1581, (_e1581 < 1e9f)) + select(1e9f, _e1996, (_e1996 < 1e9f))) + (select(1e9f, _e2411, (_e2411 < 1e9f)) + select(1e9f, _e2826, (_e2826 < 1e9f)))) * 0.25f) * _e2838));
} else {
if _e689 {
phi_4632_ = -(2e9f);
} else {
phi_4632_ = 2e9f;
}
let _e2848 = phi_4632_;
let _e2849 = select(_e375[6], _e2848, _e688);
let _e2850 = (_e1115.member_1 - _e1115.member);
let _e2852 = (_e1115.member + (_e2850 * 0f));
let _e2856 = (_e405 + (_e1119 * _e2852));
let _e2857 = (_e407 + (_e1120 * _e2852));
let _e2858 = (_e395 + (_e1121 * _e2852));
let _e2864 = ((((_e421.member.member * _e2856) + (_e421.member.member_1 * _e2857)) + (_e421.member.member_2 * _e2858)) + _e421.member_1);
let _e2870 = ((((_e437.member.member * _e2856) + (_e437.member.member_1 * _e2857)) + (_e437.member.member_2 * _e2858)) + _e437.member_1);
let _e2876 = ((((_e453.member.member * _e2856) + (_e453.member.member_1 * _e2857)) + (_e453.member.member_2 * _e2858)) + _e453.member_1);
let _e2878 = select(_e488, _e2864, (_e2864 > _e488));
let _e2880 = select(_e494, _e2878, (_e2878 < _e494));
let _e2882 = select(_e504, _e2870, (_e2870 > _e504));
let _e2884 = select(_e510, _e2882, (_e2882 < _e510));
let _e2886 = select(_e520, _e2876, (_e2876 > _e520));
let _e2888 = select(_e526, _e2886, (_e2886 < _e526));
let _e2894 = global_2.member[_e371].member_8.member_15;
let _e2895 = (_e2894 == 0u);
if _e2895 {
phi_4840_ = vec3<f32>(_e2880, _e2884, _e2888);
} else {
let _e2896 = (_e2880 + 0.5f);
let _e2898 = select(0f, _e2896, (_e2896 > 0f));
let _e2900 = select(_e578, _e2898, (_e2898 < _e578));
let _e2907 = select(0i, select(select(i32(_e2900), i32(-2147483648), (_e2900 < -2147483600f)), 2147483647i, (_e2900 > 2147483500f)), (_e2900 == _e2900));
let _e2913 = (_e2884 + 0.5f);
let _e2915 = select(0f, _e2913, (_e2913 > 0f));
let _e2917 = select(_e609, _e2915, (_e2915 < _e609));
let _e2924 = select(0i, select(select(i32(_e2917), i32(-2147483648), (_e2917 < -2147483600f)), 2147483647i, (_e2917 > 2147483500f)), (_e2917 == _e2917));
let _e2930 = (_e2888 + 0.5f);
let _e2932 = select(0f, _e2930, (_e2930 > 0f));
let _e2934 = select(_e634, _e2932, (_e2932 < _e634));
let _e2941 = select(0i, select(select(i32(_e2934), i32(-2147483648), (_e2934 < -2147483600f)), 2147483647i, (_e2934 > 2147483500f)), (_e2934 == _e2934));
phi_4840_ = vec3<f32>(f32((_e2907 - select(0i, 1i, (_e2900 < f32(_e2907))))), f32((_e2924 - select(0i, 1i, (_e2917 < f32(_e2924))))), f32((_e2941 - select(0i, 1i, (_e2934 < f32(_e2941))))));
}
let _e2949 = phi_4840_;
let _e2952 = select(-1f, _e2949.x, (_e2949.x > -1f));
let _e2954 = select(_e576, _e2952, (_e2952 < _e576));
let _e2961 = select(0i, select(select(i32(_e2954), i32(-2147483648), (_e2954 < -2147483600f)), 2147483647i, (_e2954 > 2147483500f)), (_e2954 == _e2954));
let _e2965 = (_e2961 - select(0i, 1i, (_e2954 < f32(_e2961))));
let _e2968 = select(-1f, _e2949.y, (_e2949.y > -1f));
let _e2970 = select(_e607, _e2968, (_e2968 < _e607));
let _e2977 = select(0i, select(select(i32(_e2970), i32(-2147483648), (_e2970 < -2147483600f)), 2147483647i, (_e2970 > 2147483500f)), (_e2970 == _e2970));
let _e2981 = (_e2977 - select(0i, 1i, (_e2970 < f32(_e2977))));
let _e2984 = select(-1f, _e2949.z, (_e2949.z > -1f));
let _e2986 = select(_e632, _e2984, (_e2984 < _e632));
let _e2993 = select(0i, select(select(i32(_e2986), i32(-2147483648), (_e2986 < -2147483600f)), 2147483647i, (_e2986 > 2147483500f)), (_e2986 == _e2986));
let _e2997 = (_e2993 - select(0i, 1i, (_e2986 < f32(_e2993))));
let _e3002 = global_2.member[_e371].member_8.member_9;
let _e3007 = global_2.member[_e371].member_8.member_10;
let _e3008 = (_e2965 + 1i);
let _e3009 = (_e2981 + 1i);
let _e3010 = (_e2997 + 1i);
let _e3016 = global_2.member[_e371].member_8.member_13.member;
let _e3017 = bitcast<i32>(_e3016);
let _e3023 = global_2.member[_e371].member_8.member_13.member_1;
let _e3024 = bitcast<i32>(_e3023);
let _e3034 = ((_e3008 >> bitcast<u32>(4i)) + (_e3017 * ((_e3009 >> bitcast<u32>(4i)) + (_e3024 * (_e3010 >> bitcast<u32>(4i))))));
let _e3036 = (bitcast<i32>(_e88) - 1i);
let _e3038 = select(_e3036, _e3034, (_e3034 < _e3036));
let _e3044 = global_1.member[bitcast<u32>(select(0i, _e3038, (_e3038 > 0i)))];
let _e3046 = (_e3008 & 15i);
let _e3049 = ((_e3009 & 15i) * _e3002);
let _e3051 = (bitcast<i32>(_e3044) + ((_e3010 & 15i) * _e3007));
let _e3055 = (_e3049 + _e3002);
let _e3056 = (2i * _e3002);
let _e3057 = (_e3049 + _e3056);
let _e3058 = (_e3051 + _e3007);
let _e3059 = (2i * _e3007);
let _e3060 = (_e3051 + _e3059);
local_8 = type_29(array<i32, 4>(_e3046, (_e3046 + 1i), (_e3046 + 2i), (_e3046 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_9 = (_e2949 - vec3<f32>(f32(_e2965), f32(_e2981), f32(_e2997)));
let _e3072 = local_8.member[1u];
let _e3073 = ((_e3058 + _e3055) + _e3072);
let _e3075 = (_e3073 >> bitcast<u32>(1i));
let _e3078 = bitcast<u32>(((_e3073 & 1i) * 16i));
let _e3080 = select(_e3036, _e3075, (_e3075 < _e3036));
let _e3085 = global_1.member[bitcast<u32>(select(0i, _e3080, (_e3080 > 0i)))];
let _e3089 = (_e3075 + 1i);
let _e3091 = select(_e3036, _e3089, (_e3089 < _e3036));
let _e3096 = global_1.member[bitcast<u32>(select(0i, _e3091, (_e3091 > 0i)))];
let _e3103 = ((_e3085 >> bitcast<u32>((_e3078 & 31u))) | ((_e3096 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3078) & 31u))));
let _e3106 = local_8.member_1[2u];
let _e3112 = f32(bitcast<i32>(((_e3103 >> bitcast<u32>((_e3106 & 31u))) & 65535u)));
let _e3115 = local_8.member_1[3u];
let _e3122 = local_9[0u];
let _e3125 = (_e3112 + ((f32(bitcast<i32>(((_e3103 >> bitcast<u32>((_e3115 & 31u))) & 65535u))) - _e3112) * _e3122));
let _e3127 = local_8.member[1u];
let _e3128 = ((_e3058 + _e3057) + _e3127);
let _e3130 = (_e3128 >> bitcast<u32>(1i));
let _e3133 = bitcast<u32>(((_e3128 & 1i) * 16i));
let _e3135 = select(_e3036, _e3130, (_e3130 < _e3036));
let _e3140 = global_1.member[bitcast<u32>(select(0i, _e3135, (_e3135 > 0i)))];
let _e3144 = (_e3130 + 1i);
let _e3146 = select(_e3036, _e3144, (_e3144 < _e3036));
let _e3151 = global_1.member[bitcast<u32>(select(0i, _e3146, (_e3146 > 0i)))];
let _e3158 = ((_e3140 >> bitcast<u32>((_e3133 & 31u))) | ((_e3151 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3133) & 31u))));
let _e3159 = local_8.member_1[2u];
let _e3165 = f32(bitcast<i32>(((_e3158 >> bitcast<u32>((_e3159 & 31u))) & 65535u)));
let _e3166 = local_8.member_1[3u];
let _e3173 = local_9[0u];
let _e3178 = local_9[1u];
let _e3181 = (_e3125 + (((_e3165 + ((f32(bitcast<i32>(((_e3158 >> bitcast<u32>((_e3166 & 31u))) & 65535u))) - _e3165) * _e3173)) - _e3125) * _e3178));
let _e3183 = local_8.member[1u];
let _e3184 = ((_e3060 + _e3055) + _e3183);
let _e3186 = (_e3184 >> bitcast<u32>(1i));
let _e3189 = bitcast<u32>(((_e3184 & 1i) * 16i));
let _e3191 = select(_e3036, _e3186, (_e3186 < _e3036));
let _e3196 = global_1.member[bitcast<u32>(select(0i, _e3191, (_e3191 > 0i)))];
let _e3200 = (_e3186 + 1i);
let _e3202 = select(_e3036, _e3200, (_e3200 < _e3036));
let _e3207 = global_1.member[bitcast<u32>(select(0i, _e3202, (_e3202 > 0i)))];
let _e3214 = ((_e3196 >> bitcast<u32>((_e3189 & 31u))) | ((_e3207 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3189) & 31u))));
let _e3215 = local_8.member_1[2u];
let _e3221 = f32(bitcast<i32>(((_e3214 >> bitcast<u32>((_e3215 & 31u))) & 65535u)));
let _e3222 = local_8.member_1[3u];
let _e3229 = local_9[0u];
let _e3232 = (_e3221 + ((f32(bitcast<i32>(((_e3214 >> bitcast<u32>((_e3222 & 31u))) & 65535u))) - _e3221) * _e3229));
let _e3234 = local_8.member[1u];
let _e3235 = ((_e3060 + _e3057) + _e3234);
let _e3237 = (_e3235 >> bitcast<u32>(1i));
let _e3240 = bitcast<u32>(((_e3235 & 1i) * 16i));
let _e3242 = select(_e3036, _e3237, (_e3237 < _e3036));
let _e3247 = global_1.member[bitcast<u32>(select(0i, _e3242, (_e3242 > 0i)))];
let _e3251 = (_e3237 + 1i);
let _e3253 = select(_e3036, _e3251, (_e3251 < _e3036));
let _e3258 = global_1.member[bitcast<u32>(select(0i, _e3253, (_e3253 > 0i)))];
let _e3265 = ((_e3247 >> bitcast<u32>((_e3240 & 31u))) | ((_e3258 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3240) & 31u))));
let _e3266 = local_8.member_1[2u];
let _e3272 = f32(bitcast<i32>(((_e3265 >> bitcast<u32>((_e3266 & 31u))) & 65535u)));
let _e3273 = local_8.member_1[3u];
let _e3280 = local_9[0u];
let _e3284 = local_9[1u];
let _e3289 = local_9[2u];
let _e3297 = global_2.member[_e371].member_8.member_8;
let _e3302 = global_2.member[_e371].member_8.member_7;
let _e3304 = (((_e3181 + (((_e3232 + (((_e3272 + ((f32(bitcast<i32>(((_e3265 >> bitcast<u32>((_e3273 & 31u))) & 65535u))) - _e3272) * _e3280)) - _e3232) * _e3284)) - _e3181) * _e3289)) - _e3297) * _e3302);
let _e3305 = -(1e9f);
let _e3307 = select(_e3305, _e3304, (_e3304 > _e3305));
let _e3309 = select(1e9f, _e3307, (_e3307 < 1e9f));
if _e689 {
phi_5317_ = (_e3309 > _e2849);
} else {
phi_5317_ = (_e3309 < _e2849);
}
let _e3316 = phi_5317_;
let _e3317 = ((_e1118 && (_e688 || (_e1115.member > 0f))) && _e3316);
let _e3318 = select(_e2849, _e3309, _e3317);
let _e3321 = (_e1115.member + (_e2850 * 0.25f));
let _e3325 = (_e405 + (_e1119 * _e3321));
let _e3326 = (_e407 + (_e1120 * _e3321));
let _e3327 = (_e395 + (_e1121 * _e3321));
let _e3333 = ((((_e421.member.member * _e3325) + (_e421.member.member_1 * _e3326)) + (_e421.member.member_2 * _e3327)) + _e421.member_1);
let _e3339 = ((((_e437.member.member * _e3325) + (_e437.member.member_1 * _e3326)) + (_e437.member.member_2 * _e3327)) + _e437.member_1);
let _e3345 = ((((_e453.member.member * _e3325) + (_e453.member.member_1 * _e3326)) + (_e453.member.member_2 * _e3327)) + _e453.member_1);
let _e3347 = select(_e488, _e3333, (_e3333 > _e488));
let _e3349 = select(_e494, _e3347, (_e3347 < _e494));
let _e3351 = select(_e504, _e3339, (_e3339 > _e504));
let _e3353 = select(_e510, _e3351, (_e3351 < _e510));
let _e3355 = select(_e520, _e3345, (_e3345 > _e520));
let _e3357 = select(_e526, _e3355, (_e3355 < _e526));
if _e2895 {
phi_5530_ = vec3<f32>(_e3349, _e3353, _e3357);
} else {
let _e3359 = (_e3349 + 0.5f);
let _e3361 = select(0f, _e3359, (_e3359 > 0f));
let _e3363 = select(_e578, _e3361, (_e3361 < _e578));
let _e3370 = select(0i, select(select(i32(_e3363), i32(-2147483648), (_e3363 < -2147483600f)), 2147483647i, (_e3363 > 2147483500f)), (_e3363 == _e3363));
let _e3376 = (_e3353 + 0.5f);
let _e3378 = select(0f, _e3376, (_e3376 > 0f));
let _e3380 = select(_e609, _e3378, (_e3378 < _e609));
let _e3387 = select(0i, select(select(i32(_e3380), i32(-2147483648), (_e3380 < -2147483600f)), 2147483647i, (_e3380 > 2147483500f)), (_e3380 == _e3380));
let _e3393 = (_e3357 + 0.5f);
let _e3395 = select(0f, _e3393, (_e3393 > 0f));
let _e3397 = select(_e634, _e3395, (_e3395 < _e634));
let _e3404 = select(0i, select(select(i32(_e3397), i32(-2147483648), (_e3397 < -2147483600f)), 2147483647i, (_e3397 > 2147483500f)), (_e3397 == _e3397));
phi_5530_ = vec3<f32>(f32((_e3370 - select(0i, 1i, (_e3363 < f32(_e3370))))), f32((_e3387 - select(0i, 1i, (_e3380 < f32(_e3387))))), f32((_e3404 - select(0i, 1i, (_e3397 < f32(_e3404))))));
}
let _e3412 = phi_5530_;
let _e3415 = select(-1f, _e3412.x, (_e3412.x > -1f));
let _e3417 = select(_e576, _e3415, (_e3415 < _e576));
let _e3424 = select(0i, select(select(i32(_e3417), i32(-2147483648), (_e3417 < -2147483600f)), 2147483647i, (_e3417 > 2147483500f)), (_e3417 == _e3417));
let _e3428 = (_e3424 - select(0i, 1i, (_e3417 < f32(_e3424))));
let _e3431 = select(-1f, _e3412.y, (_e3412.y > -1f));
let _e3433 = select(_e607, _e3431, (_e3431 < _e607));
let _e3440 = select(0i, select(select(i32(_e3433), i32(-2147483648), (_e3433 < -2147483600f)), 2147483647i, (_e3433 > 2147483500f)), (_e3433 == _e3433));
let _e3444 = (_e3440 - select(0i, 1i, (_e3433 < f32(_e3440))));
let _e3447 = select(-1f, _e3412.z, (_e3412.z > -1f));
let _e3449 = select(_e632, _e3447, (_e3447 < _e632));
let _e3456 = select(0i, select(select(i32(_e3449), i32(-2147483648), (_e3449 < -2147483600f)), 2147483647i, (_e3449 > 2147483500f)), (_e3449 == _e3449));
let _e3460 = (_e3456 - select(0i, 1i, (_e3449 < f32(_e3456))));
let _e3461 = (_e3428 + 1i);
let _e3462 = (_e3444 + 1i);
let _e3463 = (_e3460 + 1i);
let _e3473 = ((_e3461 >> bitcast<u32>(4i)) + (_e3017 * ((_e3462 >> bitcast<u32>(4i)) + (_e3024 * (_e3463 >> bitcast<u32>(4i))))));
let _e3475 = select(_e3036, _e3473, (_e3473 < _e3036));
let _e3481 = global_1.member[bitcast<u32>(select(0i, _e3475, (_e3475 > 0i)))];
let _e3483 = (_e3461 & 15i);
let _e3486 = ((_e3462 & 15i) * _e3002);
let _e3488 = (bitcast<i32>(_e3481) + ((_e3463 & 15i) * _e3007));
let _e3492 = (_e3486 + _e3002);
let _e3493 = (_e3486 + _e3056);
let _e3494 = (_e3488 + _e3007);
let _e3495 = (_e3488 + _e3059);
local_6 = type_29(array<i32, 4>(_e3483, (_e3483 + 1i), (_e3483 + 2i), (_e3483 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_7 = (_e3412 - vec3<f32>(f32(_e3428), f32(_e3444), f32(_e3460)));
let _e3507 = local_6.member[1u];
let _e3508 = ((_e3494 + _e3492) + _e3507);
let _e3510 = (_e3508 >> bitcast<u32>(1i));
let _e3513 = bitcast<u32>(((_e3508 & 1i) * 16i));
let _e3515 = select(_e3036, _e3510, (_e3510 < _e3036));
let _e3520 = global_1.member[bitcast<u32>(select(0i, _e3515, (_e3515 > 0i)))];
let _e3524 = (_e3510 + 1i);
let _e3526 = select(_e3036, _e3524, (_e3524 < _e3036));
let _e3531 = global_1.member[bitcast<u32>(select(0i, _e3526, (_e3526 > 0i)))];
let _e3538 = ((_e3520 >> bitcast<u32>((_e3513 & 31u))) | ((_e3531 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3513) & 31u))));
let _e3541 = local_6.member_1[2u];
let _e3547 = f32(bitcast<i32>(((_e3538 >> bitcast<u32>((_e3541 & 31u))) & 65535u)));
let _e3550 = local_6.member_1[3u];
let _e3557 = local_7[0u];
let _e3560 = (_e3547 + ((f32(bitcast<i32>(((_e3538 >> bitcast<u32>((_e3550 & 31u))) & 65535u))) - _e3547) * _e3557));
let _e3562 = local_6.member[1u];
let _e3563 = ((_e3494 + _e3493) + _e3562);
let _e3565 = (_e3563 >> bitcast<u32>(1i));
let _e3568 = bitcast<u32>(((_e3563 & 1i) * 16i));
let _e3570 = select(_e3036, _e3565, (_e3565 < _e3036));
let _e3575 = global_1.member[bitcast<u32>(select(0i, _e3570, (_e3570 > 0i)))];
let _e3579 = (_e3565 + 1i);
let _e3581 = select(_e3036, _e3579, (_e3579 < _e3036));
let _e3586 = global_1.member[bitcast<u32>(select(0i, _e3581, (_e3581 > 0i)))];
let _e3593 = ((_e3575 >> bitcast<u32>((_e3568 & 31u))) | ((_e3586 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3568) & 31u))));
let _e3594 = local_6.member_1[2u];
let _e3600 = f32(bitcast<i32>(((_e3593 >> bitcast<u32>((_e3594 & 31u))) & 65535u)));
let _e3601 = local_6.member_1[3u];
let _e3608 = local_7[0u];
let _e3613 = local_7[1u];
let _e3616 = (_e3560 + (((_e3600 + ((f32(bitcast<i32>(((_e3593 >> bitcast<u32>((_e3601 & 31u))) & 65535u))) - _e3600) * _e3608)) - _e3560) * _e3613));
let _e3618 = local_6.member[1u];
let _e3619 = ((_e3495 + _e3492) + _e3618);
let _e3621 = (_e3619 >> bitcast<u32>(1i));
let _e3624 = bitcast<u32>(((_e3619 & 1i) * 16i));
let _e3626 = select(_e3036, _e3621, (_e3621 < _e3036));
let _e3631 = global_1.member[bitcast<u32>(select(0i, _e3626, (_e3626 > 0i)))];
let _e3635 = (_e3621 + 1i);
let _e3637 = select(_e3036, _e3635, (_e3635 < _e3036));
let _e3642 = global_1.member[bitcast<u32>(select(0i, _e3637, (_e3637 > 0i)))];
let _e3649 = ((_e3631 >> bitcast<u32>((_e3624 & 31u))) | ((_e3642 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3624) & 31u))));
let _e3650 = local_6.member_1[2u];
let _e3656 = f32(bitcast<i32>(((_e3649 >> bitcast<u32>((_e3650 & 31u))) & 65535u)));
let _e3657 = local_6.member_1[3u];
let _e3664 = local_7[0u];
let _e3667 = (_e3656 + ((f32(bitcast<i32>(((_e3649 >> bitcast<u32>((_e3657 & 31u))) & 65535u))) - _e3656) * _e3664));
let _e3669 = local_6.member[1u];
let _e3670 = ((_e3495 + _e3493) + _e3669);
let _e3672 = (_e3670 >> bitcast<u32>(1i));
let _e3675 = bitcast<u32>(((_e3670 & 1i) * 16i));
let _e3677 = select(_e3036, _e3672, (_e3672 < _e3036));
let _e3682 = global_1.member[bitcast<u32>(select(0i, _e3677, (_e3677 > 0i)))];
let _e3686 = (_e3672 + 1i);
let _e3688 = select(_e3036, _e3686, (_e3686 < _e3036));
let _e3693 = global_1.member[bitcast<u32>(select(0i, _e3688, (_e3688 > 0i)))];
let _e3700 = ((_e3682 >> bitcast<u32>((_e3675 & 31u))) | ((_e3693 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3675) & 31u))));
let _e3701 = local_6.member_1[2u];
let _e3707 = f32(bitcast<i32>(((_e3700 >> bitcast<u32>((_e3701 & 31u))) & 65535u)));
let _e3708 = local_6.member_1[3u];
let _e3715 = local_7[0u];
let _e3719 = local_7[1u];
let _e3724 = local_7[2u];
let _e3729 = (((_e3616 + (((_e3667 + (((_e3707 + ((f32(bitcast<i32>(((_e3700 >> bitcast<u32>((_e3708 & 31u))) & 65535u))) - _e3707) * _e3715)) - _e3667) * _e3719)) - _e3616) * _e3724)) - _e3297) * _e3302);
let _e3731 = select(_e3305, _e3729, (_e3729 > _e3305));
let _e3733 = select(1e9f, _e3731, (_e3731 < 1e9f));
if _e689 {
phi_6004_ = (_e3733 > _e3318);
} else {
phi_6004_ = (_e3733 < _e3318);
}
let _e3737 = phi_6004_;
let _e3738 = (_e1118 && _e3737);
let _e3739 = select(_e3318, _e3733, _e3738);
let _e3743 = (_e1115.member + (_e2850 * (2f * 0.25f)));
let _e3747 = (_e405 + (_e1119 * _e3743));
let _e3748 = (_e407 + (_e1120 * _e3743));
let _e3749 = (_e395 + (_e1121 * _e3743));
let _e3755 = ((((_e421.member.member * _e3747) + (_e421.member.member_1 * _e3748)) + (_e421.member.member_2 * _e3749)) + _e421.member_1);
let _e3761 = ((((_e437.member.member * _e3747) + (_e437.member.member_1 * _e3748)) + (_e437.member.member_2 * _e3749)) + _e437.member_1);
let _e3767 = ((((_e453.member.member * _e3747) + (_e453.member.member_1 * _e3748)) + (_e453.member.member_2 * _e3749)) + _e453.member_1);
let _e3769 = select(_e488, _e3755, (_e3755 > _e488));
let _e3771 = select(_e494, _e3769, (_e3769 < _e494));
let _e3773 = select(_e504, _e3761, (_e3761 > _e504));
let _e3775 = select(_e510, _e3773, (_e3773 < _e510));
let _e3777 = select(_e520, _e3767, (_e3767 > _e520));
let _e3779 = select(_e526, _e3777, (_e3777 < _e526));
if _e2895 {
phi_6218_ = vec3<f32>(_e3771, _e3775, _e3779);
} else {
let _e3781 = (_e3771 + 0.5f);
let _e3783 = select(0f, _e3781, (_e3781 > 0f));
let _e3785 = select(_e578, _e3783, (_e3783 < _e578));
let _e3792 = select(0i, select(select(i32(_e3785), i32(-2147483648), (_e3785 < -2147483600f)), 2147483647i, (_e3785 > 2147483500f)), (_e3785 == _e3785));
let _e3798 = (_e3775 + 0.5f);
let _e3800 = select(0f, _e3798, (_e3798 > 0f));
let _e3802 = select(_e609, _e3800, (_e3800 < _e609));
let _e3809 = select(0i, select(select(i32(_e3802), i32(-2147483648), (_e3802 < -2147483600f)), 2147483647i, (_e3802 > 2147483500f)), (_e3802 == _e3802));
let _e3815 = (_e3779 + 0.5f);
let _e3817 = select(0f, _e3815, (_e3815 > 0f));
let _e3819 = select(_e634, _e3817, (_e3817 < _e634));
let _e3826 = select(0i, select(select(i32(_e3819), i32(-2147483648), (_e3819 < -2147483600f)), 2147483647i, (_e3819 > 2147483500f)), (_e3819 == _e3819));
phi_6218_ = vec3<f32>(f32((_e3792 - select(0i, 1i, (_e3785 < f32(_e3792))))), f32((_e3809 - select(0i, 1i, (_e3802 < f32(_e3809))))), f32((_e3826 - select(0i, 1i, (_e3819 < f32(_e3826))))));
}
let _e3834 = phi_6218_;
let _e3837 = select(-1f, _e3834.x, (_e3834.x > -1f));
let _e3839 = select(_e576, _e3837, (_e3837 < _e576));
let _e3846 = select(0i, select(select(i32(_e3839), i32(-2147483648), (_e3839 < -2147483600f)), 2147483647i, (_e3839 > 2147483500f)), (_e3839 == _e3839));
let _e3850 = (_e3846 - select(0i, 1i, (_e3839 < f32(_e3846))));
let _e3853 = select(-1f, _e3834.y, (_e3834.y > -1f));
let _e3855 = select(_e607, _e3853, (_e3853 < _e607));
let _e3862 = select(0i, select(select(i32(_e3855), i32(-2147483648), (_e3855 < -2147483600f)), 2147483647i, (_e3855 > 2147483500f)), (_e3855 == _e3855));
let _e3866 = (_e3862 - select(0i, 1i, (_e3855 < f32(_e3862))));
let _e3869 = select(-1f, _e3834.z, (_e3834.z > -1f));
let _e3871 = select(_e632, _e3869, (_e3869 < _e632));
let _e3878 = select(0i, select(select(i32(_e3871), i32(-2147483648), (_e3871 < -2147483600f)), 2147483647i, (_e3871 > 2147483500f)), (_e3871 == _e3871));
let _e3882 = (_e3878 - select(0i, 1i, (_e3871 < f32(_e3878))));
let _e3883 = (_e3850 + 1i);
let _e3884 = (_e3866 + 1i);
let _e3885 = (_e3882 + 1i);
let _e3895 = ((_e3883 >> bitcast<u32>(4i)) + (_e3017 * ((_e3884 >> bitcast<u32>(4i)) + (_e3024 * (_e3885 >> bitcast<u32>(4i))))));
let _e3897 = select(_e3036, _e3895, (_e3895 < _e3036));
let _e3903 = global_1.member[bitcast<u32>(select(0i, _e3897, (_e3897 > 0i)))];
let _e3905 = (_e3883 & 15i);
let _e3908 = ((_e3884 & 15i) * _e3002);
let _e3910 = (bitcast<i32>(_e3903) + ((_e3885 & 15i) * _e3007));
let _e3914 = (_e3908 + _e3002);
let _e3915 = (_e3908 + _e3056);
let _e3916 = (_e3910 + _e3007);
let _e3917 = (_e3910 + _e3059);
local_4 = type_29(array<i32, 4>(_e3905, (_e3905 + 1i), (_e3905 + 2i), (_e3905 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_5 = (_e3834 - vec3<f32>(f32(_e3850), f32(_e3866), f32(_e3882)));
let _e3929 = local_4.member[1u];
let _e3930 = ((_e3916 + _e3914) + _e3929);
let _e3932 = (_e3930 >> bitcast<u32>(1i));
let _e3935 = bitcast<u32>(((_e3930 & 1i) * 16i));
let _e3937 = select(_e3036, _e3932, (_e3932 < _e3036));
let _e3942 = global_1.member[bitcast<u32>(select(0i, _e3937, (_e3937 > 0i)))];
let _e3946 = (_e3932 + 1i);
let _e3948 = select(_e3036, _e3946, (_e3946 < _e3036));
let _e3953 = global_1.member[bitcast<u32>(select(0i, _e3948, (_e3948 > 0i)))];
let _e3960 = ((_e3942 >> bitcast<u32>((_e3935 & 31u))) | ((_e3953 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3935) & 31u))));
let _e3963 = local_4.member_1[2u];
let _e3969 = f32(bitcast<i32>(((_e3960 >> bitcast<u32>((_e3963 & 31u))) & 65535u)));
let _e3972 = local_4.member_1[3u];
let _e3979 = local_5[0u];
let _e3982 = (_e3969 + ((f32(bitcast<i32>(((_e3960 >> bitcast<u32>((_e3972 & 31u))) & 65535u))) - _e3969) * _e3979));
let _e3984 = local_4.member[1u];
let _e3985 = ((_e3916 + _e3915) + _e3984);
let _e3987 = (_e3985 >> bitcast<u32>(1i));
let _e3990 = bitcast<u32>(((_e3985 & 1i) * 16i));
let _e3992 = select(_e3036, _e3987, (_e3987 < _e3036));
let _e3997 = global_1.member[bitcast<u32>(select(0i, _e3992, (_e3992 > 0i)))];
let _e4001 = (_e3987 + 1i);
let _e4003 = select(_e3036, _e4001, (_e4001 < _e3036));
let _e4008 = global_1.member[bitcast<u32>(select(0i, _e4003, (_e4003 > 0i)))];
let _e4015 = ((_e3997 >> bitcast<u32>((_e3990 & 31u))) | ((_e4008 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3990) & 31u))));
let _e4016 = local_4.member_1[2u];
let _e4022 = f32(bitcast<i32>(((_e4015 >> bitcast<u32>((_e4016 & 31u))) & 65535u)));
let _e4023 = local_4.member_1[3u];
let _e4030 = local_5[0u];
let _e4035 = local_5[1u];
let _e4038 = (_e3982 + (((_e4022 + ((f32(bitcast<i32>(((_e4015 >> bitcast<u32>((_e4023 & 31u))) & 65535u))) - _e4022) * _e4030)) - _e3982) * _e4035));
let _e4040 = local_4.member[1u];
let _e4041 = ((_e3917 + _e3914) + _e4040);
let _e4043 = (_e4041 >> bitcast<u32>(1i));
let _e4046 = bitcast<u32>(((_e4041 & 1i) * 16i));
let _e4048 = select(_e3036, _e4043, (_e4043 < _e3036));
let _e4053 = global_1.member[bitcast<u32>(select(0i, _e4048, (_e4048 > 0i)))];
let _e4057 = (_e4043 + 1i);
let _e4059 = select(_e3036, _e4057, (_e4057 < _e3036));
let _e4064 = global_1.member[bitcast<u32>(select(0i, _e4059, (_e4059 > 0i)))];
let _e4071 = ((_e4053 >> bitcast<u32>((_e4046 & 31u))) | ((_e4064 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4046) & 31u))));
let _e4072 = local_4.member_1[2u];
let _e4078 = f32(bitcast<i32>(((_e4071 >> bitcast<u32>((_e4072 & 31u))) & 65535u)));
let _e4079 = local_4.member_1[3u];
let _e4086 = local_5[0u];
let _e4089 = (_e4078 + ((f32(bitcast<i32>(((_e4071 >> bitcast<u32>((_e4079 & 31u))) & 65535u))) - _e4078) * _e4086));
let _e4091 = local_4.member[1u];
let _e4092 = ((_e3917 + _e3915) + _e4091);
let _e4094 = (_e4092 >> bitcast<u32>(1i));
let _e4097 = bitcast<u32>(((_e4092 & 1i) * 16i));
let _e4099 = select(_e3036, _e4094, (_e4094 < _e3036));
let _e4104 = global_1.member[bitcast<u32>(select(0i, _e4099, (_e4099 > 0i)))];
let _e4108 = (_e4094 + 1i);
let _e4110 = select(_e3036, _e4108, (_e4108 < _e3036));
let _e4115 = global_1.member[bitcast<u32>(select(0i, _e4110, (_e4110 > 0i)))];
let _e4122 = ((_e4104 >> bitcast<u32>((_e4097 & 31u))) | ((_e4115 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4097) & 31u))));
let _e4123 = local_4.member_1[2u];
let _e4129 = f32(bitcast<i32>(((_e4122 >> bitcast<u32>((_e4123 & 31u))) & 65535u)));
let _e4130 = local_4.member_1[3u];
let _e4137 = local_5[0u];
let _e4141 = local_5[1u];
let _e4146 = local_5[2u];
let _e4151 = (((_e4038 + (((_e4089 + (((_e4129 + ((f32(bitcast<i32>(((_e4122 >> bitcast<u32>((_e4130 & 31u))) & 65535u))) - _e4129) * _e4137)) - _e4089) * _e4141)) - _e4038) * _e4146)) - _e3297) * _e3302);
let _e4153 = select(_e3305, _e4151, (_e4151 > _e3305));
let _e4155 = select(1e9f, _e4153, (_e4153 < 1e9f));
if _e689 {
phi_6692_ = (_e4155 > _e3739);
} else {
phi_6692_ = (_e4155 < _e3739);
}
let _e4159 = phi_6692_;
let _e4160 = (_e1118 && _e4159);
let _e4161 = select(_e3739, _e4155, _e4160);
let _e4165 = (_e1115.member + (_e2850 * (3f * 0.25f)));
let _e4169 = (_e405 + (_e1119 * _e4165));
let _e4170 = (_e407 + (_e1120 * _e4165));
let _e4171 = (_e395 + (_e1121 * _e4165));
let _e4177 = ((((_e421.member.member * _e4169) + (_e421.member.member_1 * _e4170)) + (_e421.member.member_2 * _e4171)) + _e421.member_1);
let _e4183 = ((((_e437.member.member * _e4169) + (_e437.member.member_1 * _e4170)) + (_e437.member.member_2 * _e4171)) + _e437.member_1);
let _e4189 = ((((_e453.member.member * _e4169) + (_e453.member.member_1 * _e4170)) + (_e453.member.member_2 * _e4171)) + _e453.member_1);
let _e4191 = select(_e488, _e4177, (_e4177 > _e488));
let _e4193 = select(_e494, _e4191, (_e4191 < _e494));
let _e4195 = select(_e504, _e4183, (_e4183 > _e504));
let _e4197 = select(_e510, _e4195, (_e4195 < _e510));
let _e4199 = select(_e520, _e4189, (_e4189 > _e520));
let _e4201 = select(_e526, _e4199, (_e4199 < _e526));
if _e2895 {
phi_6906_ = vec3<f32>(_e4193, _e4197, _e4201);
} else {
let _e4203 = (_e4193 + 0.5f);
let _e4205 = select(0f, _e4203, (_e4203 > 0f));
let _e4207 = select(_e578, _e4205, (_e4205 < _e578));
let _e4214 = select(0i, select(select(i32(_e4207), i32(-2147483648), (_e4207 < -2147483600f)), 2147483647i, (_e4207 > 2147483500f)), (_e4207 == _e4207));
let _e4220 = (_e4197 + 0.5f);
let _e4222 = select(0f, _e4220, (_e4220 > 0f));
let _e4224 = select(_e609, _e4222, (_e4222 < _e609));
let _e4231 = select(0i, select(select(i32(_e4224), i32(-2147483648), (_e4224 < -2147483600f)), 2147483647i, (_e4224 > 2147483500f)), (_e4224 == _e4224));
let _e4237 = (_e4201 + 0.5f);
let _e4239 = select(0f, _e4237, (_e4237 > 0f));
let _e4241 = select(_e634, _e4239, (_e4239 < _e634));
let _e4248 = select(0i, select(select(i32(_e4241), i32(-2147483648), (_e4241 < -2147483600f)), 2147483647i, (_e4241 > 2147483500f)), (_e4241 == _e4241));
phi_6906_ = vec3<f32>(f32((_e4214 - select(0i, 1i, (_e4207 < f32(_e4214))))), f32((_e4231 - select(0i, 1i, (_e4224 < f32(_e4231))))), f32((_e4248 - select(0i, 1i, (_e4241 < f32(_e4248))))));
}
let _e4256 = phi_6906_;
let _e4259 = select(-1f, _e4256.x, (_e4256.x > -1f));
let _e4261 = select(_e576, _e4259, (_e4259 < _e576));
let _e4268 = select(0i, select(select(i32(_e4261), i32(-2147483648), (_e4261 < -2147483600f)), 2147483647i, (_e4261 > 2147483500f)), (_e4261 == _e4261));
let _e4272 = (_e4268 - select(0i, 1i, (_e4261 < f32(_e4268))));
let _e4275 = select(-1f, _e4256.y, (_e4256.y > -1f));
let _e4277 = select(_e607, _e4275, (_e4275 < _e607));
let _e4284 = select(0i, select(select(i32(_e4277), i32(-2147483648), (_e4277 < -2147483600f)), 2147483647i, (_e4277 > 2147483500f)), (_e4277 == _e4277));
let _e4288 = (_e4284 - select(0i, 1i, (_e4277 < f32(_e4284))));
let _e4291 = select(-1f, _e4256.z, (_e4256.z > -1f));
let _e4293 = select(_e632, _e4291, (_e4291 < _e632));
let _e4300 = select(0i, select(select(i32(_e4293), i32(-2147483648), (_e4293 < -2147483600f)), 2147483647i, (_e4293 > 2147483500f)), (_e4293 == _e4293));
let _e4304 = (_e4300 - select(0i, 1i, (_e4293 < f32(_e4300))));
let _e4305 = (_e4272 + 1i);
let _e4306 = (_e4288 + 1i);
let _e4307 = (_e4304 + 1i);
let _e4317 = ((_e4305 >> bitcast<u32>(4i)) + (_e3017 * ((_e4306 >> bitcast<u32>(4i)) + (_e3024 * (_e4307 >> bitcast<u32>(4i))))));
let _e4319 = select(_e3036, _e4317, (_e4317 < _e3036));
let _e4325 = global_1.member[bitcast<u32>(select(0i, _e4319, (_e4319 > 0i)))];
let _e4327 = (_e4305 & 15i);
let _e4330 = ((_e4306 & 15i) * _e3002);
let _e4332 = (bitcast<i32>(_e4325) + ((_e4307 & 15i) * _e3007));
let _e4336 = (_e4330 + _e3002);
let _e4337 = (_e4330 + _e3056);
let _e4338 = (_e4332 + _e3007);
let _e4339 = (_e4332 + _e3059);
local_2 = type_29(array<i32, 4>(_e4327, (_e4327 + 1i), (_e4327 + 2i), (_e4327 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_3 = (_e4256 - vec3<f32>(f32(_e4272), f32(_e4288), f32(_e4304)));
let _e4351 = local_2.member[1u];
let _e4352 = ((_e4338 + _e4336) + _e4351);
let _e4354 = (_e4352 >> bitcast<u32>(1i));
let _e4357 = bitcast<u32>(((_e4352 & 1i) * 16i));
let _e4359 = select(_e3036, _e4354, (_e4354 < _e3036));
let _e4364 = global_1.member[bitcast<u32>(select(0i, _e4359, (_e4359 > 0i)))];
let _e4368 = (_e4354 + 1i);
let _e4370 = select(_e3036, _e4368, (_e4368 < _e3036));
let _e4375 = global_1.member[bitcast<u32>(select(0i, _e4370, (_e4370 > 0i)))];
let _e4382 = ((_e4364 >> bitcast<u32>((_e4357 & 31u))) | ((_e4375 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4357) & 31u))));
let _e4385 = local_2.member_1[2u];
let _e4391 = f32(bitcast<i32>(((_e4382 >> bitcast<u32>((_e4385 & 31u))) & 65535u)));
let _e4394 = local_2.member_1[3u];
let _e4401 = local_3[0u];
let _e4404 = (_e4391 + ((f32(bitcast<i32>(((_e4382 >> bitcast<u32>((_e4394 & 31u))) & 65535u))) - _e4391) * _e4401));
let _e4406 = local_2.member[1u];
let _e4407 = ((_e4338 + _e4337) + _e4406);
let _e4409 = (_e4407 >> bitcast<u32>(1i));
let _e4412 = bitcast<u32>(((_e4407 & 1i) * 16i));
let _e4414 = select(_e3036, _e4409, (_e4409 < _e3036));
let _e4419 = global_1.member[bitcast<u32>(select(0i, _e4414, (_e4414 > 0i)))];
let _e4423 = (_e4409 + 1i);
let _e4425 = select(_e3036, _e4423, (_e4423 < _e3036));
let _e4430 = global_1.member[bitcast<u32>(select(0i, _e4425, (_e4425 > 0i)))];
let _e4437 = ((_e4419 >> bitcast<u32>((_e4412 & 31u))) | ((_e4430 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4412) & 31u))));
let _e4438 = local_2.member_1[2u];
let _e4444 = f32(bitcast<i32>(((_e4437 >> bitcast<u32>((_e4438 & 31u))) & 65535u)));
let _e4445 = local_2.member_1[3u];
let _e4452 = local_3[0u];
let _e4457 = local_3[1u];
let _e4460 = (_e4404 + (((_e4444 + ((f32(bitcast<i32>(((_e4437 >> bitcast<u32>((_e4445 & 31u))) & 65535u))) - _e4444) * _e4452)) - _e4404) * _e4457));
let _e4462 = local_2.member[1u];
let _e4463 = ((_e4339 + _e4336) + _e4462);
let _e4465 = (_e4463 >> bitcast<u32>(1i));
let _e4468 = bitcast<u32>(((_e4463 & 1i) * 16i));
let _e4470 = select(_e3036, _e4465, (_e4465 < _e3036));
let _e4475 = global_1.member[bitcast<u32>(select(0i, _e4470, (_e4470 > 0i)))];
let _e4479 = (_e4465 + 1i);
let _e4481 = select(_e3036, _e4479, (_e4479 < _e3036));
let _e4486 = global_1.member[bitcast<u32>(select(0i, _e4481, (_e4481 > 0i)))];
let _e4493 = ((_e4475 >> bitcast<u32>((_e4468 & 31u))) | ((_e4486 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4468) & 31u))));
let _e4494 = local_2.member_1[2u];
let _e4500 = f32(bitcast<i32>(((_e4493 >> bitcast<u32>((_e4494 & 31u))) & 65535u)));
let _e4501 = local_2.member_1[3u];
let _e4508 = local_3[0u];
let _e4511 = (_e4500 + ((f32(bitcast<i32>(((_e4493 >> bitcast<u32>((_e4501 & 31u))) & 65535u))) - _e4500) * _e4508));
let _e4513 = local_2.member[1u];
let _e4514 = ((_e4339 + _e4337) + _e4513);
let _e4516 = (_e4514 >> bitcast<u32>(1i));
let _e4519 = bitcast<u32>(((_e4514 & 1i) * 16i));
let _e4521 = select(_e3036, _e4516, (_e4516 < _e3036));
let _e4526 = global_1.member[bitcast<u32>(select(0i, _e4521, (_e4521 > 0i)))];
let _e4530 = (_e4516 + 1i);
let _e4532 = select(_e3036, _e4530, (_e4530 < _e3036));
let _e4537 = global_1.member[bitcast<u32>(select(0i, _e4532, (_e4532 > 0i)))];
let _e4544 = ((_e4526 >> bitcast<u32>((_e4519 & 31u))) | ((_e4537 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4519) & 31u))));
let _e4545 = local_2.member_1[2u];
let _e4551 = f32(bitcast<i32>(((_e4544 >> bitcast<u32>((_e4545 & 31u))) & 65535u)));
let _e4552 = local_2.member_1[3u];
let _e4559 = local_3[0u];
let _e4563 = local_3[1u];
let _e4568 = local_3[2u];
let _e4573 = (((_e4460 + (((_e4511 + (((_e4551 + ((f32(bitcast<i32>(((_e4544 >> bitcast<u32>((_e4552 & 31u))) & 65535u))) - _e4551) * _e4559)) - _e4511) * _e4563)) - _e4460) * _e4568)) - _e3297) * _e3302);
let _e4575 = select(_e3305, _e4573, (_e4573 > _e3305));
let _e4577 = select(1e9f, _e4575, (_e4575 < 1e9f));
if _e689 {
phi_7380_ = (_e4577 > _e4161);
} else {
phi_7380_ = (_e4577 < _e4161);
}
let _e4581 = phi_7380_;
let _e4582 = (_e1118 && _e4581);
let _e4583 = select(_e4161, _e4577, _e4582);
let _e4586 = (_e1115.member + (_e2850 * 1f));
let _e4590 = (_e405 + (_e1119 * _e4586));
let _e4591 = (_e407 + (_e1120 * _e4586));
let _e4592 = (_e395 + (_e1121 * _e4586));
let _e4598 = ((((_e421.member.member * _e4590) + (_e421.member.member_1 * _e4591)) + (_e421.member.member_2 * _e4592)) + _e421.member_1);
let _e4604 = ((((_e437.member.member * _e4590) + (_e437.member.member_1 * _e4591)) + (_e437.member.member_2 * _e4592)) + _e437.member_1);
let _e4610 = ((((_e453.member.member * _e4590) + (_e453.member.member_1 * _e4591)) + (_e453.member.member_2 * _e4592)) + _e453.member_1);
let _e4612 = select(_e488, _e4598, (_e4598 > _e488));
let _e4614 = select(_e494, _e4612, (_e4612 < _e494));
let _e4616 = select(_e504, _e4604, (_e4604 > _e504));
let _e4618 = select(_e510, _e4616, (_e4616 < _e510));
let _e4620 = select(_e520, _e4610, (_e4610 > _e520));
let _e4622 = select(_e526, _e4620, (_e4620 < _e526));
if _e2895 {
phi_7593_ = vec3<f32>(_e4614, _e4618, _e4622);
} else {
let _e4624 = (_e4614 + 0.5f);
let _e4626 = select(0f, _e4624, (_e4624 > 0f));
let _e4628 = select(_e578, _e4626, (_e4626 < _e578));
let _e4635 = select(0i, select(select(i32(_e4628), i32(-2147483648), (_e4628 < -2147483600f)), 2147483647i, (_e4628 > 2147483500f)), (_e4628 == _e4628));
let _e4641 = (_e4618 + 0.5f);
let _e4643 = select(0f, _e4641, (_e4641 > 0f));
let _e4645 = select(_e609, _e4643, (_e4643 < _e609));
let _e4652 = select(0i, select(select(i32(_e4645), i32(-2147483648), (_e4645 < -2147483600f)), 2147483647i, (_e4645 > 2147483500f)), (_e4645 == _e4645));
let _e4658 = (_e4622 + 0.5f);
let _e4660 = select(0f, _e4658, (_e4658 > 0f));
let _e4662 = select(_e634, _e4660, (_e4660 < _e634));
let _e4669 = select(0i, select(select(i32(_e4662), i32(-2147483648), (_e4662 < -2147483600f)), 2147483647i, (_e4662 > 2147483500f)), (_e4662 == _e4662));
phi_7593_ = vec3<f32>(f32((_e4635 - select(0i, 1i, (_e4628 < f32(_e4635))))), f32((_e4652 - select(0i, 1i, (_e4645 < f32(_e4652))))), f32((_e4669 - select(0i, 1i, (_e4662 < f32(_e4669))))));
}
let _e4677 = phi_7593_;
let _e4680 = select(-1f, _e4677.x, (_e4677.x > -1f));
let _e4682 = select(_e576, _e4680, (_e4680 < _e576));
let _e4689 = select(0i, select(select(i32(_e4682), i32(-2147483648), (_e4682 < -2147483600f)), 2147483647i, (_e4682 > 2147483500f)), (_e4682 == _e4682));
let _e4693 = (_e4689 - select(0i, 1i, (_e4682 < f32(_e4689))));
let _e4696 = select(-1f, _e4677.y, (_e4677.y > -1f));
let _e4698 = select(_e607, _e4696, (_e4696 < _e607));
let _e4705 = select(0i, select(select(i32(_e4698), i32(-2147483648), (_e4698 < -2147483600f)), 2147483647i, (_e4698 > 2147483500f)), (_e4698 == _e4698));
let _e4709 = (_e4705 - select(0i, 1i, (_e4698 < f32(_e4705))));
let _e4712 = select(-1f, _e4677.z, (_e4677.z > -1f));
let _e4714 = select(_e632, _e4712, (_e4712 < _e632));
let _e4721 = select(0i, select(select(i32(_e4714), i32(-2147483648), (_e4714 < -2147483600f)), 2147483647i, (_e4714 > 2147483500f)), (_e4714 == _e4714));
let _e4725 = (_e4721 - select(0i, 1i, (_e4714 < f32(_e4721))));
let _e4726 = (_e4693 + 1i);
let _e4727 = (_e4709 + 1i);
let _e4728 = (_e4725 + 1i);
let _e4738 = ((_e4726 >> bitcast<u32>(4i)) + (_e3017 * ((_e4727 >> bitcast<u32>(4i)) + (_e3024 * (_e4728 >> bitcast<u32>(4i))))));
let _e4740 = select(_e3036, _e4738, (_e4738 < _e3036));
let _e4746 = global_1.member[bitcast<u32>(select(0i, _e4740, (_e4740 > 0i)))];
let _e4748 = (_e4726 & 15i);
let _e4751 = ((_e4727 & 15i) * _e3002);
let _e4753 = (bitcast<i32>(_e4746) + ((_e4728 & 15i) * _e3007));
let _e4757 = (_e4751 + _e3002);
let _e4758 = (_e4751 + _e3056);
let _e4759 = (_e4753 + _e3007);
let _e4760 = (_e4753 + _e3059);
local = type_29(array<i32, 4>(_e4748, (_e4748 + 1i), (_e4748 + 2i), (_e4748 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_1 = (_e4677 - vec3<f32>(f32(_e4693), f32(_e4709), f32(_e4725)));
let _e4772 = local.member[1u];
let _e4773 = ((_e4759 + _e4757) + _e4772);
let _e4775 = (_e4773 >> bitcast<u32>(1i));
let _e4778 = bitcast<u32>(((_e4773 & 1i) * 16i));
let _e4780 = select(_e3036, _e4775, (_e4775 < _e3036));
let _e4785 = global_1.member[bitcast<u32>(select(0i, _e4780, (_e4780 > 0i)))];
let _e4789 = (_e4775 + 1i);
let _e4791 = select(_e3036, _e4789, (_e4789 < _e3036));
let _e4796 = global_1.member[bitcast<u32>(select(0i, _e4791, (_e4791 > 0i)))];
let _e4803 = ((_e4785 >> bitcast<u32>((_e4778 & 31u))) | ((_e4796 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4778) & 31u))));
let _e4806 = local.member_1[2u];
let _e4812 = f32(bitcast<i32>(((_e4803 >> bitcast<u32>((_e4806 & 31u))) & 65535u)));
let _e4815 = local.member_1[3u];
let _e4822 = local_1[0u];
let _e4825 = (_e4812 + ((f32(bitcast<i32>(((_e4803 >> bitcast<u32>((_e4815 & 31u))) & 65535u))) - _e4812) * _e4822));
let _e4827 = local.member[1u];
let _e4828 = ((_e4759 + _e4758) + _e4827);
let _e4830 = (_e4828 >> bitcast<u32>(1i));
let _e4833 = bitcast<u32>(((_e4828 & 1i) * 16i));
let _e4835 = select(_e3036, _e4830, (_e4830 < _e3036));
let _e4840 = global_1.member[bitcast<u32>(select(0i, _e4835, (_e4835 > 0i)))];
let _e4844 = (_e4830 + 1i);
let _e4846 = select(_e3036, _e4844, (_e4844 < _e3036));
let _e4851 = global_1.member[bitcast<u32>(select(0i, _e4846, (_e4846 > 0i)))];
let _e4858 = ((_e4840 >> bitcast<u32>((_e4833 & 31u))) | ((_e4851 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4833) & 31u))));
let _e4859 = local.member_1[2u];
let _e4865 = f32(bitcast<i32>(((_e4858 >> bitcast<u32>((_e4859 & 31u))) & 65535u)));
let _e4866 = local.member_1[3u];
let _e4873 = local_1[0u];
let _e4878 = local_1[1u];
let _e4881 = (_e4825 + (((_e4865 + ((f32(bitcast<i32>(((_e4858 >> bitcast<u32>((_e4866 & 31u))) & 65535u))) - _e4865) * _e4873)) - _e4825) * _e4878));
let _e4883 = local.member[1u];
let _e4884 = ((_e4760 + _e4757) + _e4883);
let _e4886 = (_e4884 >> bitcast<u32>(1i));
let _e4889 = bitcast<u32>(((_e4884 & 1i) * 16i));
let _e4891 = select(_e3036, _e4886, (_e4886 < _e3036));
let _e4896 = global_1.member[bitcast<u32>(select(0i, _e4891, (_e4891 > 0i)))];
let _e4900 = (_e4886 + 1i);
let _e4902 = select(_e3036, _e4900, (_e4900 < _e3036));
let _e4907 = global_1.member[bitcast<u32>(select(0i, _e4902, (_e4902 > 0i)))];
let _e4914 = ((_e4896 >> bitcast<u32>((_e4889 & 31u))) | ((_e4907 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4889) & 31u))));
let _e4915 = local.member_1[2u];
let _e4921 = f32(bitcast<i32>(((_e4914 >> bitcast<u32>((_e4915 & 31u))) & 65535u)));
let _e4922 = local.member_1[3u];
let _e4929 = local_1[0u];
let _e4932 = (_e4921 + ((f32(bitcast<i32>(((_e4914 >> bitcast<u32>((_e4922 & 31u))) & 65535u))) - _e4921) * _e4929));
let _e4934 = local.member[1u];
let _e4935 = ((_e4760 + _e4758) + _e4934);
let _e4937 = (_e4935 >> bitcast<u32>(1i));
let _e4940 = bitcast<u32>(((_e4935 & 1i) * 16i));
let _e4942 = select(_e3036, _e4937, (_e4937 < _e3036));
let _e4947 = global_1.member[bitcast<u32>(select(0i, _e4942, (_e4942 > 0i)))];
let _e4951 = (_e4937 + 1i);
let _e4953 = select(_e3036, _e4951, (_e4951 < _e3036));
let _e4958 = global_1.member[bitcast<u32>(select(0i, _e4953, (_e4953 > 0i)))];
let _e4965 = ((_e4947 >> bitcast<u32>((_e4940 & 31u))) | ((_e4958 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4940) & 31u))));
let _e4966 = local.member_1[2u];
let _e4972 = f32(bitcast<i32>(((_e4965 >> bitcast<u32>((_e4966 & 31u))) & 65535u)));
let _e4973 = local.member_1[3u];
let _e4980 = local_1[0u];
let _e4984 = local_1[1u];
let _e4989 = local_1[2u];
let _e4994 = (((_e4881 + (((_e4932 + (((_e4972 + ((f32(bitcast<i32>(((_e4965 >> bitcast<u32>((_e4973 & 31u))) & 65535u))) - _e4972) * _e4980)) - _e4932) * _e4984)) - _e4881) * _e4989)) - _e3297) * _e3302);
let _e4996 = select(_e3305, _e4994, (_e4994 > _e3305));
let _e4998 = select(1e9f, _e4996, (_e4996 < 1e9f));
if _e689 {
phi_8067_ = (_e4998 > _e4583);
} else {
phi_8067_ = (_e4998 < _e4583);
}
let _e5002 = phi_8067_;
let _e5003 = (_e1118 && _e5002);
phi_8077_ = select(select(select(select(select(_e375[8], _e2858, _e3317), _e3327, _e3738), _e3749, _e4160), _e4171, _e4582), _e4592, _e5003);
phi_8078_ = select(_e4583, _e4998, _e5003);
}
let _e5007 = phi_8077_;
let _e5009 = phi_8078_;
phi_8096_ = array<f32, 23>(_e375[0], _e375[1], _e375[2], _e375[3], _e375[4], _e375[5], select(_e375[6], _e5009, _e1118), _e375[7], select(_e375[8], _e5007, _e1118), _e375[9], _e375[10], _e375[11], _e375[12], _e375[13], _e375[14], _e375[15], _e375[16], select(_e375[17], _e416, _e1118), _e375[18], _e375[19], _e375[20], _e375[21], _e375[22]);
} else {
phi_8096_ = _e375;
}
let _e5015 = phi_8096_;
phi_631_ = (_e371 + 1u);
phi_634_ = select(_e373, true, _e747);
phi_636_ = _e5015;
} else {
phi_631_ = u32();
phi_634_ = bool();
phi_636_ = array<f32, 23>();
}
let _e5019 = phi_631_;
let _e5021 = phi_634_;
let _e5023 = phi_636_;
continue;
continuing {
phi_630_ = _e5019;
phi_633_ = _e5021;
phi_635_ = _e5023;
phi_8199_ = false;
break if !(_e376);
}
}
let _e5026 = phi_8199_;
if _e5026 {
break;
}
let _e5028 = local_18;
if _e5028 {
let _e5030 = local_19;
global_4.member[_e116] = _e5030[0];
let _e5035 = local_20;
global_4.member[_e128] = _e5035[1];
let _e5040 = local_21;
global_4.member[_e139] = _e5040[2];
let _e5045 = local_22;
global_4.member[_e150] = _e5045[3];
let _e5050 = local_23;
global_4.member[_e161] = _e5050[4];
let _e5055 = local_24;
global_4.member[_e172] = _e5055[5];
let _e5060 = local_25;
global_4.member[_e183] = _e5060[6];
let _e5065 = local_26;
global_4.member[_e194] = _e5065[7];
let _e5070 = local_27;
global_4.member[_e205] = _e5070[8];
let _e5075 = local_28;
global_4.member[_e216] = _e5075[9];
let _e5080 = local_29;
global_4.member[_e227] = _e5080[10];
let _e5085 = local_30;
global_4.member[_e238] = _e5085[11];
let _e5090 = local_31;
global_4.member[_e249] = _e5090[12];
let _e5095 = local_32;
global_4.member[_e260] = _e5095[13];
let _e5100 = local_33;
global_4.member[_e271] = _e5100[14];
let _e5105 = local_34;
global_4.member[_e282] = _e5105[15];
let _e5110 = local_35;
global_4.member[_e293] = _e5110[16];
let _e5115 = local_36;
global_4.member[_e304] = _e5115[17];
let _e5120 = local_37;
global_4.member[_e315] = _e5120[18];
let _e5125 = local_38;
global_4.member[_e326] = _e5125[19];
let _e5130 = local_39;
global_4.member[_e337] = _e5130[20];
let _e5135 = local_40;
global_4.member[_e348] = _e5135[21];
let _e5140 = local_41;
global_4.member[_e359] = _e5140[22];
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
