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
var phi_632_: u32;
var phi_635_: bool;
var phi_637_: array<f32, 23>;
var phi_1001_: bool;
var phi_1897_: type_32;
var phi_2118_: vec3<f32>;
var phi_2791_: vec3<f32>;
var phi_3464_: vec3<f32>;
var phi_4137_: vec3<f32>;
var phi_4638_: f32;
var phi_4846_: vec3<f32>;
var phi_5324_: bool;
var phi_5537_: vec3<f32>;
var phi_6012_: bool;
var phi_6226_: vec3<f32>;
var phi_6701_: bool;
var phi_6915_: vec3<f32>;
var phi_7390_: bool;
var phi_7603_: vec3<f32>;
var phi_8078_: bool;
var phi_8088_: f32;
var phi_8089_: f32;
var phi_8107_: array<f32, 23>;
var phi_633_: u32;
var phi_636_: bool;
var phi_638_: array<f32, 23>;
var phi_8210_: bool;
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
phi_632_ = 0u;
phi_635_ = false;
phi_637_ = array<f32, 23>(_e127, _e137, _e148, _e159, _e170, _e181, _e192, _e203, _e214, _e225, _e236, _e247, _e258, _e269, _e280, _e291, _e302, _e313, _e324, _e335, _e346, _e357, _e368);
loop {
let _e371 = phi_632_;
let _e373 = phi_635_;
let _e375 = phi_637_;
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
phi_8210_ = true;
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
phi_1001_ = (_e687 <= _e375[6]);
} else {
phi_1001_ = (_e687 >= _e375[6]);
}
let _e693 = phi_1001_;
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
phi_1897_ = type_32(_e921, _e923);
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
phi_1897_ = type_32(select(_e1105, _e1063, (_e1063 > _e1105)), select(_e1108, _e1065, (_e1065 < _e1108)));
}
let _e1115 = phi_1897_;
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
phi_2118_ = vec3<f32>(_e1154, _e1158, _e1162);
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
phi_2118_ = vec3<f32>(f32((_e1181 - select(0i, 1i, (_e1174 < f32(_e1181))))), f32((_e1198 - select(0i, 1i, (_e1191 < f32(_e1198))))), f32((_e1215 - select(0i, 1i, (_e1208 < f32(_e1215))))));
}
let _e1223 = phi_2118_;
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
let _e1326 = (_e1323 + _e1276);
let _e1327 = (2i * _e1276);
let _e1328 = (_e1323 + _e1327);
let _e1329 = (_e1325 + _e1281);
let _e1330 = (2i * _e1281);
let _e1331 = (_e1325 + _e1330);
local_16 = type_29(array<i32, 4>(_e1320, _e1320, _e1320, _e1320), array<u32, 6>(0u, 8u, 16u, 24u, 0u, 0u));
local_17 = (_e1223 - vec3<f32>(f32(_e1239), f32(_e1255), f32(_e1271)));
let _e1343 = local_16.member[0u];
let _e1344 = ((_e1329 + _e1326) + _e1343);
let _e1346 = (_e1344 >> bitcast<u32>(2i));
let _e1349 = bitcast<u32>(((_e1344 & 3i) * 8i));
let _e1351 = select(_e1310, _e1346, (_e1346 < _e1310));
let _e1356 = global_1.member[bitcast<u32>(select(0i, _e1351, (_e1351 > 0i)))];
let _e1360 = (_e1346 + 1i);
let _e1362 = select(_e1310, _e1360, (_e1360 < _e1310));
let _e1367 = global_1.member[bitcast<u32>(select(0i, _e1362, (_e1362 > 0i)))];
let _e1374 = ((_e1356 >> bitcast<u32>((_e1349 & 31u))) | ((_e1367 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1349) & 31u))));
let _e1377 = local_16.member_1[1u];
let _e1383 = f32(bitcast<i32>(((_e1374 >> bitcast<u32>((_e1377 & 31u))) & 255u)));
let _e1386 = local_16.member_1[2u];
let _e1393 = local_17[0u];
let _e1396 = (_e1383 + ((f32(bitcast<i32>(((_e1374 >> bitcast<u32>((_e1386 & 31u))) & 255u))) - _e1383) * _e1393));
let _e1398 = local_16.member[0u];
let _e1399 = ((_e1329 + _e1328) + _e1398);
let _e1401 = (_e1399 >> bitcast<u32>(2i));
let _e1404 = bitcast<u32>(((_e1399 & 3i) * 8i));
let _e1406 = select(_e1310, _e1401, (_e1401 < _e1310));
let _e1411 = global_1.member[bitcast<u32>(select(0i, _e1406, (_e1406 > 0i)))];
let _e1415 = (_e1401 + 1i);
let _e1417 = select(_e1310, _e1415, (_e1415 < _e1310));
let _e1422 = global_1.member[bitcast<u32>(select(0i, _e1417, (_e1417 > 0i)))];
let _e1429 = ((_e1411 >> bitcast<u32>((_e1404 & 31u))) | ((_e1422 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1404) & 31u))));
let _e1430 = local_16.member_1[1u];
let _e1436 = f32(bitcast<i32>(((_e1429 >> bitcast<u32>((_e1430 & 31u))) & 255u)));
let _e1437 = local_16.member_1[2u];
let _e1444 = local_17[0u];
let _e1449 = local_17[1u];
let _e1452 = (_e1396 + (((_e1436 + ((f32(bitcast<i32>(((_e1429 >> bitcast<u32>((_e1437 & 31u))) & 255u))) - _e1436) * _e1444)) - _e1396) * _e1449));
let _e1454 = local_16.member[0u];
let _e1455 = ((_e1331 + _e1326) + _e1454);
let _e1457 = (_e1455 >> bitcast<u32>(2i));
let _e1460 = bitcast<u32>(((_e1455 & 3i) * 8i));
let _e1462 = select(_e1310, _e1457, (_e1457 < _e1310));
let _e1467 = global_1.member[bitcast<u32>(select(0i, _e1462, (_e1462 > 0i)))];
let _e1471 = (_e1457 + 1i);
let _e1473 = select(_e1310, _e1471, (_e1471 < _e1310));
let _e1478 = global_1.member[bitcast<u32>(select(0i, _e1473, (_e1473 > 0i)))];
let _e1485 = ((_e1467 >> bitcast<u32>((_e1460 & 31u))) | ((_e1478 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1460) & 31u))));
let _e1486 = local_16.member_1[1u];
let _e1492 = f32(bitcast<i32>(((_e1485 >> bitcast<u32>((_e1486 & 31u))) & 255u)));
let _e1493 = local_16.member_1[2u];
let _e1500 = local_17[0u];
let _e1503 = (_e1492 + ((f32(bitcast<i32>(((_e1485 >> bitcast<u32>((_e1493 & 31u))) & 255u))) - _e1492) * _e1500));
let _e1505 = local_16.member[0u];
let _e1506 = ((_e1331 + _e1328) + _e1505);
let _e1508 = (_e1506 >> bitcast<u32>(2i));
let _e1511 = bitcast<u32>(((_e1506 & 3i) * 8i));
let _e1513 = select(_e1310, _e1508, (_e1508 < _e1310));
let _e1518 = global_1.member[bitcast<u32>(select(0i, _e1513, (_e1513 > 0i)))];
let _e1522 = (_e1508 + 1i);
let _e1524 = select(_e1310, _e1522, (_e1522 < _e1310));
let _e1529 = global_1.member[bitcast<u32>(select(0i, _e1524, (_e1524 > 0i)))];
let _e1536 = ((_e1518 >> bitcast<u32>((_e1511 & 31u))) | ((_e1529 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1511) & 31u))));
let _e1537 = local_16.member_1[1u];
let _e1543 = f32(bitcast<i32>(((_e1536 >> bitcast<u32>((_e1537 & 31u))) & 255u)));
let _e1544 = local_16.member_1[2u];
let _e1551 = local_17[0u];
let _e1555 = local_17[1u];
let _e1560 = local_17[2u];
let _e1568 = global_2.member[_e371].member_8.member_8;
let _e1573 = global_2.member[_e371].member_8.member_7;
let _e1575 = (((_e1452 + (((_e1503 + (((_e1543 + ((f32(bitcast<i32>(((_e1536 >> bitcast<u32>((_e1544 & 31u))) & 255u))) - _e1543) * _e1551)) - _e1503) * _e1555)) - _e1452) * _e1560)) - _e1568) * _e1573);
let _e1576 = -(1e9f);
let _e1578 = select(_e1576, _e1575, (_e1575 > _e1576));
let _e1583 = (_e1115.member + (_e1124 * (1.5f * 0.25f)));
let _e1587 = (_e405 + (_e1119 * _e1583));
let _e1588 = (_e407 + (_e1120 * _e1583));
let _e1589 = (_e395 + (_e1121 * _e1583));
let _e1595 = ((((_e421.member.member * _e1587) + (_e421.member.member_1 * _e1588)) + (_e421.member.member_2 * _e1589)) + _e421.member_1);
let _e1601 = ((((_e437.member.member * _e1587) + (_e437.member.member_1 * _e1588)) + (_e437.member.member_2 * _e1589)) + _e437.member_1);
let _e1607 = ((((_e453.member.member * _e1587) + (_e453.member.member_1 * _e1588)) + (_e453.member.member_2 * _e1589)) + _e453.member_1);
let _e1609 = select(_e488, _e1595, (_e1595 > _e488));
let _e1611 = select(_e494, _e1609, (_e1609 < _e494));
let _e1613 = select(_e504, _e1601, (_e1601 > _e504));
let _e1615 = select(_e510, _e1613, (_e1613 < _e510));
let _e1617 = select(_e520, _e1607, (_e1607 > _e520));
let _e1619 = select(_e526, _e1617, (_e1617 < _e526));
if _e1169 {
phi_2791_ = vec3<f32>(_e1611, _e1615, _e1619);
} else {
let _e1621 = (_e1611 + 0.5f);
let _e1623 = select(0f, _e1621, (_e1621 > 0f));
let _e1625 = select(_e578, _e1623, (_e1623 < _e578));
let _e1632 = select(0i, select(select(i32(_e1625), i32(-2147483648), (_e1625 < -2147483600f)), 2147483647i, (_e1625 > 2147483500f)), (_e1625 == _e1625));
let _e1638 = (_e1615 + 0.5f);
let _e1640 = select(0f, _e1638, (_e1638 > 0f));
let _e1642 = select(_e609, _e1640, (_e1640 < _e609));
let _e1649 = select(0i, select(select(i32(_e1642), i32(-2147483648), (_e1642 < -2147483600f)), 2147483647i, (_e1642 > 2147483500f)), (_e1642 == _e1642));
let _e1655 = (_e1619 + 0.5f);
let _e1657 = select(0f, _e1655, (_e1655 > 0f));
let _e1659 = select(_e634, _e1657, (_e1657 < _e634));
let _e1666 = select(0i, select(select(i32(_e1659), i32(-2147483648), (_e1659 < -2147483600f)), 2147483647i, (_e1659 > 2147483500f)), (_e1659 == _e1659));
phi_2791_ = vec3<f32>(f32((_e1632 - select(0i, 1i, (_e1625 < f32(_e1632))))), f32((_e1649 - select(0i, 1i, (_e1642 < f32(_e1649))))), f32((_e1666 - select(0i, 1i, (_e1659 < f32(_e1666))))));
}
let _e1674 = phi_2791_;
let _e1677 = select(-1f, _e1674.x, (_e1674.x > -1f));
let _e1679 = select(_e576, _e1677, (_e1677 < _e576));
let _e1686 = select(0i, select(select(i32(_e1679), i32(-2147483648), (_e1679 < -2147483600f)), 2147483647i, (_e1679 > 2147483500f)), (_e1679 == _e1679));
let _e1690 = (_e1686 - select(0i, 1i, (_e1679 < f32(_e1686))));
let _e1693 = select(-1f, _e1674.y, (_e1674.y > -1f));
let _e1695 = select(_e607, _e1693, (_e1693 < _e607));
let _e1702 = select(0i, select(select(i32(_e1695), i32(-2147483648), (_e1695 < -2147483600f)), 2147483647i, (_e1695 > 2147483500f)), (_e1695 == _e1695));
let _e1706 = (_e1702 - select(0i, 1i, (_e1695 < f32(_e1702))));
let _e1709 = select(-1f, _e1674.z, (_e1674.z > -1f));
let _e1711 = select(_e632, _e1709, (_e1709 < _e632));
let _e1718 = select(0i, select(select(i32(_e1711), i32(-2147483648), (_e1711 < -2147483600f)), 2147483647i, (_e1711 > 2147483500f)), (_e1711 == _e1711));
let _e1722 = (_e1718 - select(0i, 1i, (_e1711 < f32(_e1718))));
let _e1723 = (_e1690 + 1i);
let _e1724 = (_e1706 + 1i);
let _e1725 = (_e1722 + 1i);
let _e1735 = ((_e1723 >> bitcast<u32>(4i)) + (_e1291 * ((_e1724 >> bitcast<u32>(4i)) + (_e1298 * (_e1725 >> bitcast<u32>(4i))))));
let _e1737 = select(_e1310, _e1735, (_e1735 < _e1310));
let _e1743 = global_1.member[bitcast<u32>(select(0i, _e1737, (_e1737 > 0i)))];
let _e1745 = (_e1723 & 15i);
let _e1748 = ((_e1724 & 15i) * _e1276);
let _e1750 = (bitcast<i32>(_e1743) + ((_e1725 & 15i) * _e1281));
let _e1751 = (_e1748 + _e1276);
let _e1752 = (_e1748 + _e1327);
let _e1753 = (_e1750 + _e1281);
let _e1754 = (_e1750 + _e1330);
local_14 = type_29(array<i32, 4>(_e1745, _e1745, _e1745, _e1745), array<u32, 6>(0u, 8u, 16u, 24u, 0u, 0u));
local_15 = (_e1674 - vec3<f32>(f32(_e1690), f32(_e1706), f32(_e1722)));
let _e1766 = local_14.member[0u];
let _e1767 = ((_e1753 + _e1751) + _e1766);
let _e1769 = (_e1767 >> bitcast<u32>(2i));
let _e1772 = bitcast<u32>(((_e1767 & 3i) * 8i));
let _e1774 = select(_e1310, _e1769, (_e1769 < _e1310));
let _e1779 = global_1.member[bitcast<u32>(select(0i, _e1774, (_e1774 > 0i)))];
let _e1783 = (_e1769 + 1i);
let _e1785 = select(_e1310, _e1783, (_e1783 < _e1310));
let _e1790 = global_1.member[bitcast<u32>(select(0i, _e1785, (_e1785 > 0i)))];
let _e1797 = ((_e1779 >> bitcast<u32>((_e1772 & 31u))) | ((_e1790 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1772) & 31u))));
let _e1800 = local_14.member_1[1u];
let _e1806 = f32(bitcast<i32>(((_e1797 >> bitcast<u32>((_e1800 & 31u))) & 255u)));
let _e1809 = local_14.member_1[2u];
let _e1816 = local_15[0u];
let _e1819 = (_e1806 + ((f32(bitcast<i32>(((_e1797 >> bitcast<u32>((_e1809 & 31u))) & 255u))) - _e1806) * _e1816));
let _e1821 = local_14.member[0u];
let _e1822 = ((_e1753 + _e1752) + _e1821);
let _e1824 = (_e1822 >> bitcast<u32>(2i));
let _e1827 = bitcast<u32>(((_e1822 & 3i) * 8i));
let _e1829 = select(_e1310, _e1824, (_e1824 < _e1310));
let _e1834 = global_1.member[bitcast<u32>(select(0i, _e1829, (_e1829 > 0i)))];
let _e1838 = (_e1824 + 1i);
let _e1840 = select(_e1310, _e1838, (_e1838 < _e1310));
let _e1845 = global_1.member[bitcast<u32>(select(0i, _e1840, (_e1840 > 0i)))];
let _e1852 = ((_e1834 >> bitcast<u32>((_e1827 & 31u))) | ((_e1845 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1827) & 31u))));
let _e1853 = local_14.member_1[1u];
let _e1859 = f32(bitcast<i32>(((_e1852 >> bitcast<u32>((_e1853 & 31u))) & 255u)));
let _e1860 = local_14.member_1[2u];
let _e1867 = local_15[0u];
let _e1872 = local_15[1u];
let _e1875 = (_e1819 + (((_e1859 + ((f32(bitcast<i32>(((_e1852 >> bitcast<u32>((_e1860 & 31u))) & 255u))) - _e1859) * _e1867)) - _e1819) * _e1872));
let _e1877 = local_14.member[0u];
let _e1878 = ((_e1754 + _e1751) + _e1877);
let _e1880 = (_e1878 >> bitcast<u32>(2i));
let _e1883 = bitcast<u32>(((_e1878 & 3i) * 8i));
let _e1885 = select(_e1310, _e1880, (_e1880 < _e1310));
let _e1890 = global_1.member[bitcast<u32>(select(0i, _e1885, (_e1885 > 0i)))];
let _e1894 = (_e1880 + 1i);
let _e1896 = select(_e1310, _e1894, (_e1894 < _e1310));
let _e1901 = global_1.member[bitcast<u32>(select(0i, _e1896, (_e1896 > 0i)))];
let _e1908 = ((_e1890 >> bitcast<u32>((_e1883 & 31u))) | ((_e1901 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1883) & 31u))));
let _e1909 = local_14.member_1[1u];
let _e1915 = f32(bitcast<i32>(((_e1908 >> bitcast<u32>((_e1909 & 31u))) & 255u)));
let _e1916 = local_14.member_1[2u];
let _e1923 = local_15[0u];
let _e1926 = (_e1915 + ((f32(bitcast<i32>(((_e1908 >> bitcast<u32>((_e1916 & 31u))) & 255u))) - _e1915) * _e1923));
let _e1928 = local_14.member[0u];
let _e1929 = ((_e1754 + _e1752) + _e1928);
let _e1931 = (_e1929 >> bitcast<u32>(2i));
let _e1934 = bitcast<u32>(((_e1929 & 3i) * 8i));
let _e1936 = select(_e1310, _e1931, (_e1931 < _e1310));
let _e1941 = global_1.member[bitcast<u32>(select(0i, _e1936, (_e1936 > 0i)))];
let _e1945 = (_e1931 + 1i);
let _e1947 = select(_e1310, _e1945, (_e1945 < _e1310));
let _e1952 = global_1.member[bitcast<u32>(select(0i, _e1947, (_e1947 > 0i)))];
let _e1959 = ((_e1941 >> bitcast<u32>((_e1934 & 31u))) | ((_e1952 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1934) & 31u))));
let _e1960 = local_14.member_1[1u];
let _e1966 = f32(bitcast<i32>(((_e1959 >> bitcast<u32>((_e1960 & 31u))) & 255u)));
let _e1967 = local_14.member_1[2u];
let _e1974 = local_15[0u];
let _e1978 = local_15[1u];
let _e1983 = local_15[2u];
let _e1988 = (((_e1875 + (((_e1926 + (((_e1966 + ((f32(bitcast<i32>(((_e1959 >> bitcast<u32>((_e1967 & 31u))) & 255u))) - _e1966) * _e1974)) - _e1926) * _e1978)) - _e1875) * _e1983)) - _e1568) * _e1573);
let _e1990 = select(_e1576, _e1988, (_e1988 > _e1576));
let _e1995 = (_e1115.member + (_e1124 * (2.5f * 0.25f)));
let _e1999 = (_e405 + (_e1119 * _e1995));
let _e2000 = (_e407 + (_e1120 * _e1995));
let _e2001 = (_e395 + (_e1121 * _e1995));
let _e2007 = ((((_e421.member.member * _e1999) + (_e421.member.member_1 * _e2000)) + (_e421.member.member_2 * _e2001)) + _e421.member_1);
let _e2013 = ((((_e437.member.member * _e1999) + (_e437.member.member_1 * _e2000)) + (_e437.member.member_2 * _e2001)) + _e437.member_1);
let _e2019 = ((((_e453.member.member * _e1999) + (_e453.member.member_1 * _e2000)) + (_e453.member.member_2 * _e2001)) + _e453.member_1);
let _e2021 = select(_e488, _e2007, (_e2007 > _e488));
let _e2023 = select(_e494, _e2021, (_e2021 < _e494));
let _e2025 = select(_e504, _e2013, (_e2013 > _e504));
let _e2027 = select(_e510, _e2025, (_e2025 < _e510));
let _e2029 = select(_e520, _e2019, (_e2019 > _e520));
let _e2031 = select(_e526, _e2029, (_e2029 < _e526));
if _e1169 {
phi_3464_ = vec3<f32>(_e2023, _e2027, _e2031);
} else {
let _e2033 = (_e2023 + 0.5f);
let _e2035 = select(0f, _e2033, (_e2033 > 0f));
let _e2037 = select(_e578, _e2035, (_e2035 < _e578));
let _e2044 = select(0i, select(select(i32(_e2037), i32(-2147483648), (_e2037 < -2147483600f)), 2147483647i, (_e2037 > 2147483500f)), (_e2037 == _e2037));
let _e2050 = (_e2027 + 0.5f);
let _e2052 = select(0f, _e2050, (_e2050 > 0f));
let _e2054 = select(_e609, _e2052, (_e2052 < _e609));
let _e2061 = select(0i, select(select(i32(_e2054), i32(-2147483648), (_e2054 < -2147483600f)), 2147483647i, (_e2054 > 2147483500f)), (_e2054 == _e2054));
let _e2067 = (_e2031 + 0.5f);
let _e2069 = select(0f, _e2067, (_e2067 > 0f));
let _e2071 = select(_e634, _e2069, (_e2069 < _e634));
let _e2078 = select(0i, select(select(i32(_e2071), i32(-2147483648), (_e2071 < -2147483600f)), 2147483647i, (_e2071 > 2147483500f)), (_e2071 == _e2071));
phi_3464_ = vec3<f32>(f32((_e2044 - select(0i, 1i, (_e2037 < f32(_e2044))))), f32((_e2061 - select(0i, 1i, (_e2054 < f32(_e2061))))), f32((_e2078 - select(0i, 1i, (_e2071 < f32(_e2078))))));
}
let _e2086 = phi_3464_;
let _e2089 = select(-1f, _e2086.x, (_e2086.x > -1f));
let _e2091 = select(_e576, _e2089, (_e2089 < _e576));
let _e2098 = select(0i, select(select(i32(_e2091), i32(-2147483648), (_e2091 < -2147483600f)), 2147483647i, (_e2091 > 2147483500f)), (_e2091 == _e2091));
let _e2102 = (_e2098 - select(0i, 1i, (_e2091 < f32(_e2098))));
let _e2105 = select(-1f, _e2086.y, (_e2086.y > -1f));
let _e2107 = select(_e607, _e2105, (_e2105 < _e607));
let _e2114 = select(0i, select(select(i32(_e2107), i32(-2147483648), (_e2107 < -2147483600f)), 2147483647i, (_e2107 > 2147483500f)), (_e2107 == _e2107));
let _e2118 = (_e2114 - select(0i, 1i, (_e2107 < f32(_e2114))));
let _e2121 = select(-1f, _e2086.z, (_e2086.z > -1f));
let _e2123 = select(_e632, _e2121, (_e2121 < _e632));
let _e2130 = select(0i, select(select(i32(_e2123), i32(-2147483648), (_e2123 < -2147483600f)), 2147483647i, (_e2123 > 2147483500f)), (_e2123 == _e2123));
let _e2134 = (_e2130 - select(0i, 1i, (_e2123 < f32(_e2130))));
let _e2135 = (_e2102 + 1i);
let _e2136 = (_e2118 + 1i);
let _e2137 = (_e2134 + 1i);
let _e2147 = ((_e2135 >> bitcast<u32>(4i)) + (_e1291 * ((_e2136 >> bitcast<u32>(4i)) + (_e1298 * (_e2137 >> bitcast<u32>(4i))))));
let _e2149 = select(_e1310, _e2147, (_e2147 < _e1310));
let _e2155 = global_1.member[bitcast<u32>(select(0i, _e2149, (_e2149 > 0i)))];
let _e2157 = (_e2135 & 15i);
let _e2160 = ((_e2136 & 15i) * _e1276);
let _e2162 = (bitcast<i32>(_e2155) + ((_e2137 & 15i) * _e1281));
let _e2163 = (_e2160 + _e1276);
let _e2164 = (_e2160 + _e1327);
let _e2165 = (_e2162 + _e1281);
let _e2166 = (_e2162 + _e1330);
local_12 = type_29(array<i32, 4>(_e2157, _e2157, _e2157, _e2157), array<u32, 6>(0u, 8u, 16u, 24u, 0u, 0u));
local_13 = (_e2086 - vec3<f32>(f32(_e2102), f32(_e2118), f32(_e2134)));
let _e2178 = local_12.member[0u];
let _e2179 = ((_e2165 + _e2163) + _e2178);
let _e2181 = (_e2179 >> bitcast<u32>(2i));
let _e2184 = bitcast<u32>(((_e2179 & 3i) * 8i));
let _e2186 = select(_e1310, _e2181, (_e2181 < _e1310));
let _e2191 = global_1.member[bitcast<u32>(select(0i, _e2186, (_e2186 > 0i)))];
let _e2195 = (_e2181 + 1i);
let _e2197 = select(_e1310, _e2195, (_e2195 < _e1310));
let _e2202 = global_1.member[bitcast<u32>(select(0i, _e2197, (_e2197 > 0i)))];
let _e2209 = ((_e2191 >> bitcast<u32>((_e2184 & 31u))) | ((_e2202 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2184) & 31u))));
let _e2212 = local_12.member_1[1u];
let _e2218 = f32(bitcast<i32>(((_e2209 >> bitcast<u32>((_e2212 & 31u))) & 255u)));
let _e2221 = local_12.member_1[2u];
let _e2228 = local_13[0u];
let _e2231 = (_e2218 + ((f32(bitcast<i32>(((_e2209 >> bitcast<u32>((_e2221 & 31u))) & 255u))) - _e2218) * _e2228));
let _e2233 = local_12.member[0u];
let _e2234 = ((_e2165 + _e2164) + _e2233);
let _e2236 = (_e2234 >> bitcast<u32>(2i));
let _e2239 = bitcast<u32>(((_e2234 & 3i) * 8i));
let _e2241 = select(_e1310, _e2236, (_e2236 < _e1310));
let _e2246 = global_1.member[bitcast<u32>(select(0i, _e2241, (_e2241 > 0i)))];
let _e2250 = (_e2236 + 1i);
let _e2252 = select(_e1310, _e2250, (_e2250 < _e1310));
let _e2257 = global_1.member[bitcast<u32>(select(0i, _e2252, (_e2252 > 0i)))];
let _e2264 = ((_e2246 >> bitcast<u32>((_e2239 & 31u))) | ((_e2257 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2239) & 31u))));
let _e2265 = local_12.member_1[1u];
let _e2271 = f32(bitcast<i32>(((_e2264 >> bitcast<u32>((_e2265 & 31u))) & 255u)));
let _e2272 = local_12.member_1[2u];
let _e2279 = local_13[0u];
let _e2284 = local_13[1u];
let _e2287 = (_e2231 + (((_e2271 + ((f32(bitcast<i32>(((_e2264 >> bitcast<u32>((_e2272 & 31u))) & 255u))) - _e2271) * _e2279)) - _e2231) * _e2284));
let _e2289 = local_12.member[0u];
let _e2290 = ((_e2166 + _e2163) + _e2289);
let _e2292 = (_e2290 >> bitcast<u32>(2i));
let _e2295 = bitcast<u32>(((_e2290 & 3i) * 8i));
let _e2297 = select(_e1310, _e2292, (_e2292 < _e1310));
let _e2302 = global_1.member[bitcast<u32>(select(0i, _e2297, (_e2297 > 0i)))];
let _e2306 = (_e2292 + 1i);
let _e2308 = select(_e1310, _e2306, (_e2306 < _e1310));
let _e2313 = global_1.member[bitcast<u32>(select(0i, _e2308, (_e2308 > 0i)))];
let _e2320 = ((_e2302 >> bitcast<u32>((_e2295 & 31u))) | ((_e2313 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2295) & 31u))));
let _e2321 = local_12.member_1[1u];
let _e2327 = f32(bitcast<i32>(((_e2320 >> bitcast<u32>((_e2321 & 31u))) & 255u)));
let _e2328 = local_12.member_1[2u];
let _e2335 = local_13[0u];
let _e2338 = (_e2327 + ((f32(bitcast<i32>(((_e2320 >> bitcast<u32>((_e2328 & 31u))) & 255u))) - _e2327) * _e2335));
let _e2340 = local_12.member[0u];
let _e2341 = ((_e2166 + _e2164) + _e2340);
let _e2343 = (_e2341 >> bitcast<u32>(2i));
let _e2346 = bitcast<u32>(((_e2341 & 3i) * 8i));
let _e2348 = select(_e1310, _e2343, (_e2343 < _e1310));
let _e2353 = global_1.member[bitcast<u32>(select(0i, _e2348, (_e2348 > 0i)))];
let _e2357 = (_e2343 + 1i);
let _e2359 = select(_e1310, _e2357, (_e2357 < _e1310));
let _e2364 = global_1.member[bitcast<u32>(select(0i, _e2359, (_e2359 > 0i)))];
let _e2371 = ((_e2353 >> bitcast<u32>((_e2346 & 31u))) | ((_e2364 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2346) & 31u))));
let _e2372 = local_12.member_1[1u];
let _e2378 = f32(bitcast<i32>(((_e2371 >> bitcast<u32>((_e2372 & 31u))) & 255u)));
let _e2379 = local_12.member_1[2u];
let _e2386 = local_13[0u];
let _e2390 = local_13[1u];
let _e2395 = local_13[2u];
let _e2400 = (((_e2287 + (((_e2338 + (((_e2378 + ((f32(bitcast<i32>(((_e2371 >> bitcast<u32>((_e2379 & 31u))) & 255u))) - _e2378) * _e2386)) - _e2338) * _e2390)) - _e2287) * _e2395)) - _e1568) * _e1573);
let _e2402 = select(_e1576, _e2400, (_e2400 > _e1576));
let _e2407 = (_e1115.member + (_e1124 * (3.5f * 0.25f)));
let _e2411 = (_e405 + (_e1119 * _e2407));
let _e2412 = (_e407 + (_e1120 * _e2407));
let _e2413 = (_e395 + (_e1121 * _e2407));
let _e2419 = ((((_e421.member.member * _e2411) + (_e421.member.member_1 * _e2412)) + (_e421.member.member_2 * _e2413)) + _e421.member_1);
let _e2425 = ((((_e437.member.member * _e2411) + (_e437.member.member_1 * _e2412)) + (_e437.member.member_2 * _e2413)) + _e437.member_1);
let _e2431 = ((((_e453.member.member * _e2411) + (_e453.member.member_1 * _e2412)) + (_e453.member.member_2 * _e2413)) + _e453.member_1);
let _e2433 = select(_e488, _e2419, (_e2419 > _e488));
let _e2435 = select(_e494, _e2433, (_e2433 < _e494));
let _e2437 = select(_e504, _e2425, (_e2425 > _e504));
let _e2439 = select(_e510, _e2437, (_e2437 < _e510));
let _e2441 = select(_e520, _e2431, (_e2431 > _e520));
let _e2443 = select(_e526, _e2441, (_e2441 < _e526));
if _e1169 {
phi_4137_ = vec3<f32>(_e2435, _e2439, _e2443);
} else {
let _e2445 = (_e2435 + 0.5f);
let _e2447 = select(0f, _e2445, (_e2445 > 0f));
let _e2449 = select(_e578, _e2447, (_e2447 < _e578));
let _e2456 = select(0i, select(select(i32(_e2449), i32(-2147483648), (_e2449 < -2147483600f)), 2147483647i, (_e2449 > 2147483500f)), (_e2449 == _e2449));
let _e2462 = (_e2439 + 0.5f);
let _e2464 = select(0f, _e2462, (_e2462 > 0f));
let _e2466 = select(_e609, _e2464, (_e2464 < _e609));
let _e2473 = select(0i, select(select(i32(_e2466), i32(-2147483648), (_e2466 < -2147483600f)), 2147483647i, (_e2466 > 2147483500f)), (_e2466 == _e2466));
let _e2479 = (_e2443 + 0.5f);
let _e2481 = select(0f, _e2479, (_e2479 > 0f));
let _e2483 = select(_e634, _e2481, (_e2481 < _e634));
let _e2490 = select(0i, select(select(i32(_e2483), i32(-2147483648), (_e2483 < -2147483600f)), 2147483647i, (_e2483 > 2147483500f)), (_e2483 == _e2483));
phi_4137_ = vec3<f32>(f32((_e2456 - select(0i, 1i, (_e2449 < f32(_e2456))))), f32((_e2473 - select(0i, 1i, (_e2466 < f32(_e2473))))), f32((_e2490 - select(0i, 1i, (_e2483 < f32(_e2490))))));
}
let _e2498 = phi_4137_;
let _e2501 = select(-1f, _e2498.x, (_e2498.x > -1f));
let _e2503 = select(_e576, _e2501, (_e2501 < _e576));
let _e2510 = select(0i, select(select(i32(_e2503), i32(-2147483648), (_e2503 < -2147483600f)), 2147483647i, (_e2503 > 2147483500f)), (_e2503 == _e2503));
let _e2514 = (_e2510 - select(0i, 1i, (_e2503 < f32(_e2510))));
let _e2517 = select(-1f, _e2498.y, (_e2498.y > -1f));
let _e2519 = select(_e607, _e2517, (_e2517 < _e607));
let _e2526 = select(0i, select(select(i32(_e2519), i32(-2147483648), (_e2519 < -2147483600f)), 2147483647i, (_e2519 > 2147483500f)), (_e2519 == _e2519));
let _e2530 = (_e2526 - select(0i, 1i, (_e2519 < f32(_e2526))));
let _e2533 = select(-1f, _e2498.z, (_e2498.z > -1f));
let _e2535 = select(_e632, _e2533, (_e2533 < _e632));
let _e2542 = select(0i, select(select(i32(_e2535), i32(-2147483648), (_e2535 < -2147483600f)), 2147483647i, (_e2535 > 2147483500f)), (_e2535 == _e2535));
let _e2546 = (_e2542 - select(0i, 1i, (_e2535 < f32(_e2542))));
let _e2547 = (_e2514 + 1i);
let _e2548 = (_e2530 + 1i);
let _e2549 = (_e2546 + 1i);
let _e2559 = ((_e2547 >> bitcast<u32>(4i)) + (_e1291 * ((_e2548 >> bitcast<u32>(4i)) + (_e1298 * (_e2549 >> bitcast<u32>(4i))))));
let _e2561 = select(_e1310, _e2559, (_e2559 < _e1310));
let _e2567 = global_1.member[bitcast<u32>(select(0i, _e2561, (_e2561 > 0i)))];
let _e2569 = (_e2547 & 15i);
let _e2572 = ((_e2548 & 15i) * _e1276);
let _e2574 = (bitcast<i32>(_e2567) + ((_e2549 & 15i) * _e1281));
let _e2575 = (_e2572 + _e1276);
let _e2576 = (_e2572 + _e1327);
let _e2577 = (_e2574 + _e1281);
let _e2578 = (_e2574 + _e1330);
local_10 = type_29(array<i32, 4>(_e2569, _e2569, _e2569, _e2569), array<u32, 6>(0u, 8u, 16u, 24u, 0u, 0u));
local_11 = (_e2498 - vec3<f32>(f32(_e2514), f32(_e2530), f32(_e2546)));
let _e2590 = local_10.member[0u];
let _e2591 = ((_e2577 + _e2575) + _e2590);
let _e2593 = (_e2591 >> bitcast<u32>(2i));
let _e2596 = bitcast<u32>(((_e2591 & 3i) * 8i));
let _e2598 = select(_e1310, _e2593, (_e2593 < _e1310));
let _e2603 = global_1.member[bitcast<u32>(select(0i, _e2598, (_e2598 > 0i)))];
let _e2607 = (_e2593 + 1i);
let _e2609 = select(_e1310, _e2607, (_e2607 < _e1310));
let _e2614 = global_1.member[bitcast<u32>(select(0i, _e2609, (_e2609 > 0i)))];
let _e2621 = ((_e2603 >> bitcast<u32>((_e2596 & 31u))) | ((_e2614 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2596) & 31u))));
let _e2624 = local_10.member_1[1u];
let _e2630 = f32(bitcast<i32>(((_e2621 >> bitcast<u32>((_e2624 & 31u))) & 255u)));
let _e2633 = local_10.member_1[2u];
let _e2640 = local_11[0u];
let _e2643 = (_e2630 + ((f32(bitcast<i32>(((_e2621 >> bitcast<u32>((_e2633 & 31u))) & 255u))) - _e2630) * _e2640));
let _e2645 = local_10.member[0u];
let _e2646 = ((_e2577 + _e2576) + _e2645);
let _e2648 = (_e2646 >> bitcast<u32>(2i));
let _e2651 = bitcast<u32>(((_e2646 & 3i) * 8i));
let _e2653 = select(_e1310, _e2648, (_e2648 < _e1310));
let _e2658 = global_1.member[bitcast<u32>(select(0i, _e2653, (_e2653 > 0i)))];
let _e2662 = (_e2648 + 1i);
let _e2664 = select(_e1310, _e2662, (_e2662 < _e1310));
let _e2669 = global_1.member[bitcast<u32>(select(0i, _e2664, (_e2664 > 0i)))];
let _e2676 = ((_e2658 >> bitcast<u32>((_e2651 & 31u))) | ((_e2669 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2651) & 31u))));
let _e2677 = local_10.member_1[1u];
let _e2683 = f32(bitcast<i32>(((_e2676 >> bitcast<u32>((_e2677 & 31u))) & 255u)));
let _e2684 = local_10.member_1[2u];
let _e2691 = local_11[0u];
let _e2696 = local_11[1u];
let _e2699 = (_e2643 + (((_e2683 + ((f32(bitcast<i32>(((_e2676 >> bitcast<u32>((_e2684 & 31u))) & 255u))) - _e2683) * _e2691)) - _e2643) * _e2696));
let _e2701 = local_10.member[0u];
let _e2702 = ((_e2578 + _e2575) + _e2701);
let _e2704 = (_e2702 >> bitcast<u32>(2i));
let _e2707 = bitcast<u32>(((_e2702 & 3i) * 8i));
let _e2709 = select(_e1310, _e2704, (_e2704 < _e1310));
let _e2714 = global_1.member[bitcast<u32>(select(0i, _e2709, (_e2709 > 0i)))];
let _e2718 = (_e2704 + 1i);
let _e2720 = select(_e1310, _e2718, (_e2718 < _e1310));
let _e2725 = global_1.member[bitcast<u32>(select(0i, _e2720, (_e2720 > 0i)))];
let _e2732 = ((_e2714 >> bitcast<u32>((_e2707 & 31u))) | ((_e2725 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2707) & 31u))));
let _e2733 = local_10.member_1[1u];
let _e2739 = f32(bitcast<i32>(((_e2732 >> bitcast<u32>((_e2733 & 31u))) & 255u)));
let _e2740 = local_10.member_1[2u];
let _e2747 = local_11[0u];
let _e2750 = (_e2739 + ((f32(bitcast<i32>(((_e2732 >> bitcast<u32>((_e2740 & 31u))) & 255u))) - _e2739) * _e2747));
let _e2752 = local_10.member[0u];
let _e2753 = ((_e2578 + _e2576) + _e2752);
let _e2755 = (_e2753 >> bitcast<u32>(2i));
let _e2758 = bitcast<u32>(((_e2753 & 3i) * 8i));
let _e2760 = select(_e1310, _e2755, (_e2755 < _e1310));
let _e2765 = global_1.member[bitcast<u32>(select(0i, _e2760, (_e2760 > 0i)))];
let _e2769 = (_e2755 + 1i);
let _e2771 = select(_e1310, _e2769, (_e2769 < _e1310));
let _e2776 = global_1.member[bitcast<u32>(select(0i, _e2771, (_e2771 > 0i)))];
let _e2783 = ((_e2765 >> bitcast<u32>((_e2758 & 31u))) | ((_e2776 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2758) & 31u))));
let _e2784 = local_10.member_1[1u];
let _e2790 = f32(bitcast<i32>(((_e2783 >> bitcast<u32>((_e2784 & 31u))) & 255u)));
let _e2791 = local_10.member_1[2u];
let _e2798 = local_11[0u];
let _e2802 = local_11[1u];
let _e2807 = local_11[2u];
let _e2812 = (((_e2699 + (((_e2750 + (((_e2790 + ((f32(bitcast<i32>(((_e2783 >> bitcast<u32>((_e2791 & 31u))) & 255u))) - _e2790) * _e2798)) - _e2750) * _e2802)) - _e2699) * _e2807)) - _e1568) * _e1573);
let _e2814 = select(_e1576, _e2812, (_e2812 > _e1576));
let _e2821 = (((_e1119 * _e1119) + (_e1120 * _e1120)) + (_e1121 * _e1121));
let _e2826 = select(0f, (sqrt(select(0f, _e2821, (_e2821 > 0f))) * _e1124), _e1118);
phi_8088_ = (_e375[8] + _e2826);
phi_8089_ = (_e375[6] + ((((select(1e9f, _e1578, (_e1578 < 1e9f)) + select(1e9f, _e1990, (_e1990 < 1e9f))) + (select(1e9f, _e2402, (_e2402 < 1e9f)) + select(1e9f, _e2814, (_e2814 < 1e9f)))) * 0.25f) * _e2826));
} else {
if _e689 {
phi_4638_ = -(2e9f);
} else {
phi_4638_ = 2e9f;
}
let _e2836 = phi_4638_;
let _e2837 = select(_e375[6], _e2836, _e688);
let _e2838 = (_e1115.member_1 - _e1115.member);
let _e2840 = (_e1115.member + (_e2838 * 0f));
let _e2844 = (_e405 + (_e1119 * _e2840));
let _e2845 = (_e407 + (_e1120 * _e2840));
let _e2846 = (_e395 + (_e1121 * _e2840));
let _e2852 = ((((_e421.member.member * _e2844) + (_e421.member.member_1 * _e2845)) + (_e421.member.member_2 * _e2846)) + _e421.member_1);
let _e2858 = ((((_e437.member.member * _e2844) + (_e437.member.member_1 * _e2845)) + (_e437.member.member_2 * _e2846)) + _e437.member_1);
let _e2864 = ((((_e453.member.member * _e2844) + (_e453.member.member_1 * _e2845)) + (_e453.member.member_2 * _e2846)) + _e453.member_1);
let _e2866 = select(_e488, _e2852, (_e2852 > _e488));
let _e2868 = select(_e494, _e2866, (_e2866 < _e494));
let _e2870 = select(_e504, _e2858, (_e2858 > _e504));
let _e2872 = select(_e510, _e2870, (_e2870 < _e510));
let _e2874 = select(_e520, _e2864, (_e2864 > _e520));
let _e2876 = select(_e526, _e2874, (_e2874 < _e526));
let _e2882 = global_2.member[_e371].member_8.member_15;
let _e2883 = (_e2882 == 0u);
if _e2883 {
phi_4846_ = vec3<f32>(_e2868, _e2872, _e2876);
} else {
let _e2884 = (_e2868 + 0.5f);
let _e2886 = select(0f, _e2884, (_e2884 > 0f));
let _e2888 = select(_e578, _e2886, (_e2886 < _e578));
let _e2895 = select(0i, select(select(i32(_e2888), i32(-2147483648), (_e2888 < -2147483600f)), 2147483647i, (_e2888 > 2147483500f)), (_e2888 == _e2888));
let _e2901 = (_e2872 + 0.5f);
let _e2903 = select(0f, _e2901, (_e2901 > 0f));
let _e2905 = select(_e609, _e2903, (_e2903 < _e609));
let _e2912 = select(0i, select(select(i32(_e2905), i32(-2147483648), (_e2905 < -2147483600f)), 2147483647i, (_e2905 > 2147483500f)), (_e2905 == _e2905));
let _e2918 = (_e2876 + 0.5f);
let _e2920 = select(0f, _e2918, (_e2918 > 0f));
let _e2922 = select(_e634, _e2920, (_e2920 < _e634));
let _e2929 = select(0i, select(select(i32(_e2922), i32(-2147483648), (_e2922 < -2147483600f)), 2147483647i, (_e2922 > 2147483500f)), (_e2922 == _e2922));
phi_4846_ = vec3<f32>(f32((_e2895 - select(0i, 1i, (_e2888 < f32(_e2895))))), f32((_e2912 - select(0i, 1i, (_e2905 < f32(_e2912))))), f32((_e2929 - select(0i, 1i, (_e2922 < f32(_e2929))))));
}
let _e2937 = phi_4846_;
let _e2940 = select(-1f, _e2937.x, (_e2937.x > -1f));
let _e2942 = select(_e576, _e2940, (_e2940 < _e576));
let _e2949 = select(0i, select(select(i32(_e2942), i32(-2147483648), (_e2942 < -2147483600f)), 2147483647i, (_e2942 > 2147483500f)), (_e2942 == _e2942));
let _e2953 = (_e2949 - select(0i, 1i, (_e2942 < f32(_e2949))));
let _e2956 = select(-1f, _e2937.y, (_e2937.y > -1f));
let _e2958 = select(_e607, _e2956, (_e2956 < _e607));
let _e2965 = select(0i, select(select(i32(_e2958), i32(-2147483648), (_e2958 < -2147483600f)), 2147483647i, (_e2958 > 2147483500f)), (_e2958 == _e2958));
let _e2969 = (_e2965 - select(0i, 1i, (_e2958 < f32(_e2965))));
let _e2972 = select(-1f, _e2937.z, (_e2937.z > -1f));
let _e2974 = select(_e632, _e2972, (_e2972 < _e632));
let _e2981 = select(0i, select(select(i32(_e2974), i32(-2147483648), (_e2974 < -2147483600f)), 2147483647i, (_e2974 > 2147483500f)), (_e2974 == _e2974));
let _e2985 = (_e2981 - select(0i, 1i, (_e2974 < f32(_e2981))));
let _e2990 = global_2.member[_e371].member_8.member_9;
let _e2995 = global_2.member[_e371].member_8.member_10;
let _e2996 = (_e2953 + 1i);
let _e2997 = (_e2969 + 1i);
let _e2998 = (_e2985 + 1i);
let _e3004 = global_2.member[_e371].member_8.member_13.member;
let _e3005 = bitcast<i32>(_e3004);
let _e3011 = global_2.member[_e371].member_8.member_13.member_1;
let _e3012 = bitcast<i32>(_e3011);
let _e3022 = ((_e2996 >> bitcast<u32>(4i)) + (_e3005 * ((_e2997 >> bitcast<u32>(4i)) + (_e3012 * (_e2998 >> bitcast<u32>(4i))))));
let _e3024 = (bitcast<i32>(_e88) - 1i);
let _e3026 = select(_e3024, _e3022, (_e3022 < _e3024));
let _e3032 = global_1.member[bitcast<u32>(select(0i, _e3026, (_e3026 > 0i)))];
let _e3034 = (_e2996 & 15i);
let _e3037 = ((_e2997 & 15i) * _e2990);
let _e3039 = (bitcast<i32>(_e3032) + ((_e2998 & 15i) * _e2995));
let _e3040 = (_e3037 + _e2990);
let _e3041 = (2i * _e2990);
let _e3042 = (_e3037 + _e3041);
let _e3043 = (_e3039 + _e2995);
let _e3044 = (2i * _e2995);
let _e3045 = (_e3039 + _e3044);
local_8 = type_29(array<i32, 4>(_e3034, _e3034, _e3034, _e3034), array<u32, 6>(0u, 8u, 16u, 24u, 0u, 0u));
local_9 = (_e2937 - vec3<f32>(f32(_e2953), f32(_e2969), f32(_e2985)));
let _e3057 = local_8.member[0u];
let _e3058 = ((_e3043 + _e3040) + _e3057);
let _e3060 = (_e3058 >> bitcast<u32>(2i));
let _e3063 = bitcast<u32>(((_e3058 & 3i) * 8i));
let _e3065 = select(_e3024, _e3060, (_e3060 < _e3024));
let _e3070 = global_1.member[bitcast<u32>(select(0i, _e3065, (_e3065 > 0i)))];
let _e3074 = (_e3060 + 1i);
let _e3076 = select(_e3024, _e3074, (_e3074 < _e3024));
let _e3081 = global_1.member[bitcast<u32>(select(0i, _e3076, (_e3076 > 0i)))];
let _e3088 = ((_e3070 >> bitcast<u32>((_e3063 & 31u))) | ((_e3081 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3063) & 31u))));
let _e3091 = local_8.member_1[1u];
let _e3097 = f32(bitcast<i32>(((_e3088 >> bitcast<u32>((_e3091 & 31u))) & 255u)));
let _e3100 = local_8.member_1[2u];
let _e3107 = local_9[0u];
let _e3110 = (_e3097 + ((f32(bitcast<i32>(((_e3088 >> bitcast<u32>((_e3100 & 31u))) & 255u))) - _e3097) * _e3107));
let _e3112 = local_8.member[0u];
let _e3113 = ((_e3043 + _e3042) + _e3112);
let _e3115 = (_e3113 >> bitcast<u32>(2i));
let _e3118 = bitcast<u32>(((_e3113 & 3i) * 8i));
let _e3120 = select(_e3024, _e3115, (_e3115 < _e3024));
let _e3125 = global_1.member[bitcast<u32>(select(0i, _e3120, (_e3120 > 0i)))];
let _e3129 = (_e3115 + 1i);
let _e3131 = select(_e3024, _e3129, (_e3129 < _e3024));
let _e3136 = global_1.member[bitcast<u32>(select(0i, _e3131, (_e3131 > 0i)))];
let _e3143 = ((_e3125 >> bitcast<u32>((_e3118 & 31u))) | ((_e3136 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3118) & 31u))));
let _e3144 = local_8.member_1[1u];
let _e3150 = f32(bitcast<i32>(((_e3143 >> bitcast<u32>((_e3144 & 31u))) & 255u)));
let _e3151 = local_8.member_1[2u];
let _e3158 = local_9[0u];
let _e3163 = local_9[1u];
let _e3166 = (_e3110 + (((_e3150 + ((f32(bitcast<i32>(((_e3143 >> bitcast<u32>((_e3151 & 31u))) & 255u))) - _e3150) * _e3158)) - _e3110) * _e3163));
let _e3168 = local_8.member[0u];
let _e3169 = ((_e3045 + _e3040) + _e3168);
let _e3171 = (_e3169 >> bitcast<u32>(2i));
let _e3174 = bitcast<u32>(((_e3169 & 3i) * 8i));
let _e3176 = select(_e3024, _e3171, (_e3171 < _e3024));
let _e3181 = global_1.member[bitcast<u32>(select(0i, _e3176, (_e3176 > 0i)))];
let _e3185 = (_e3171 + 1i);
let _e3187 = select(_e3024, _e3185, (_e3185 < _e3024));
let _e3192 = global_1.member[bitcast<u32>(select(0i, _e3187, (_e3187 > 0i)))];
let _e3199 = ((_e3181 >> bitcast<u32>((_e3174 & 31u))) | ((_e3192 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3174) & 31u))));
let _e3200 = local_8.member_1[1u];
let _e3206 = f32(bitcast<i32>(((_e3199 >> bitcast<u32>((_e3200 & 31u))) & 255u)));
let _e3207 = local_8.member_1[2u];
let _e3214 = local_9[0u];
let _e3217 = (_e3206 + ((f32(bitcast<i32>(((_e3199 >> bitcast<u32>((_e3207 & 31u))) & 255u))) - _e3206) * _e3214));
let _e3219 = local_8.member[0u];
let _e3220 = ((_e3045 + _e3042) + _e3219);
let _e3222 = (_e3220 >> bitcast<u32>(2i));
let _e3225 = bitcast<u32>(((_e3220 & 3i) * 8i));
let _e3227 = select(_e3024, _e3222, (_e3222 < _e3024));
let _e3232 = global_1.member[bitcast<u32>(select(0i, _e3227, (_e3227 > 0i)))];
let _e3236 = (_e3222 + 1i);
let _e3238 = select(_e3024, _e3236, (_e3236 < _e3024));
let _e3243 = global_1.member[bitcast<u32>(select(0i, _e3238, (_e3238 > 0i)))];
let _e3250 = ((_e3232 >> bitcast<u32>((_e3225 & 31u))) | ((_e3243 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3225) & 31u))));
let _e3251 = local_8.member_1[1u];
let _e3257 = f32(bitcast<i32>(((_e3250 >> bitcast<u32>((_e3251 & 31u))) & 255u)));
let _e3258 = local_8.member_1[2u];
let _e3265 = local_9[0u];
let _e3269 = local_9[1u];
let _e3274 = local_9[2u];
let _e3282 = global_2.member[_e371].member_8.member_8;
let _e3287 = global_2.member[_e371].member_8.member_7;
let _e3289 = (((_e3166 + (((_e3217 + (((_e3257 + ((f32(bitcast<i32>(((_e3250 >> bitcast<u32>((_e3258 & 31u))) & 255u))) - _e3257) * _e3265)) - _e3217) * _e3269)) - _e3166) * _e3274)) - _e3282) * _e3287);
let _e3290 = -(1e9f);
let _e3292 = select(_e3290, _e3289, (_e3289 > _e3290));
let _e3294 = select(1e9f, _e3292, (_e3292 < 1e9f));
if _e689 {
phi_5324_ = (_e3294 > _e2837);
} else {
phi_5324_ = (_e3294 < _e2837);
}
let _e3301 = phi_5324_;
let _e3302 = ((_e1118 && (_e688 || (_e1115.member > 0f))) && _e3301);
let _e3303 = select(_e2837, _e3294, _e3302);
let _e3306 = (_e1115.member + (_e2838 * 0.25f));
let _e3310 = (_e405 + (_e1119 * _e3306));
let _e3311 = (_e407 + (_e1120 * _e3306));
let _e3312 = (_e395 + (_e1121 * _e3306));
let _e3318 = ((((_e421.member.member * _e3310) + (_e421.member.member_1 * _e3311)) + (_e421.member.member_2 * _e3312)) + _e421.member_1);
let _e3324 = ((((_e437.member.member * _e3310) + (_e437.member.member_1 * _e3311)) + (_e437.member.member_2 * _e3312)) + _e437.member_1);
let _e3330 = ((((_e453.member.member * _e3310) + (_e453.member.member_1 * _e3311)) + (_e453.member.member_2 * _e3312)) + _e453.member_1);
let _e3332 = select(_e488, _e3318, (_e3318 > _e488));
let _e3334 = select(_e494, _e3332, (_e3332 < _e494));
let _e3336 = select(_e504, _e3324, (_e3324 > _e504));
let _e3338 = select(_e510, _e3336, (_e3336 < _e510));
let _e3340 = select(_e520, _e3330, (_e3330 > _e520));
let _e3342 = select(_e526, _e3340, (_e3340 < _e526));
if _e2883 {
phi_5537_ = vec3<f32>(_e3334, _e3338, _e3342);
} else {
let _e3344 = (_e3334 + 0.5f);
let _e3346 = select(0f, _e3344, (_e3344 > 0f));
let _e3348 = select(_e578, _e3346, (_e3346 < _e578));
let _e3355 = select(0i, select(select(i32(_e3348), i32(-2147483648), (_e3348 < -2147483600f)), 2147483647i, (_e3348 > 2147483500f)), (_e3348 == _e3348));
let _e3361 = (_e3338 + 0.5f);
let _e3363 = select(0f, _e3361, (_e3361 > 0f));
let _e3365 = select(_e609, _e3363, (_e3363 < _e609));
let _e3372 = select(0i, select(select(i32(_e3365), i32(-2147483648), (_e3365 < -2147483600f)), 2147483647i, (_e3365 > 2147483500f)), (_e3365 == _e3365));
let _e3378 = (_e3342 + 0.5f);
let _e3380 = select(0f, _e3378, (_e3378 > 0f));
let _e3382 = select(_e634, _e3380, (_e3380 < _e634));
let _e3389 = select(0i, select(select(i32(_e3382), i32(-2147483648), (_e3382 < -2147483600f)), 2147483647i, (_e3382 > 2147483500f)), (_e3382 == _e3382));
phi_5537_ = vec3<f32>(f32((_e3355 - select(0i, 1i, (_e3348 < f32(_e3355))))), f32((_e3372 - select(0i, 1i, (_e3365 < f32(_e3372))))), f32((_e3389 - select(0i, 1i, (_e3382 < f32(_e3389))))));
}
let _e3397 = phi_5537_;
let _e3400 = select(-1f, _e3397.x, (_e3397.x > -1f));
let _e3402 = select(_e576, _e3400, (_e3400 < _e576));
let _e3409 = select(0i, select(select(i32(_e3402), i32(-2147483648), (_e3402 < -2147483600f)), 2147483647i, (_e3402 > 2147483500f)), (_e3402 == _e3402));
let _e3413 = (_e3409 - select(0i, 1i, (_e3402 < f32(_e3409))));
let _e3416 = select(-1f, _e3397.y, (_e3397.y > -1f));
let _e3418 = select(_e607, _e3416, (_e3416 < _e607));
let _e3425 = select(0i, select(select(i32(_e3418), i32(-2147483648), (_e3418 < -2147483600f)), 2147483647i, (_e3418 > 2147483500f)), (_e3418 == _e3418));
let _e3429 = (_e3425 - select(0i, 1i, (_e3418 < f32(_e3425))));
let _e3432 = select(-1f, _e3397.z, (_e3397.z > -1f));
let _e3434 = select(_e632, _e3432, (_e3432 < _e632));
let _e3441 = select(0i, select(select(i32(_e3434), i32(-2147483648), (_e3434 < -2147483600f)), 2147483647i, (_e3434 > 2147483500f)), (_e3434 == _e3434));
let _e3445 = (_e3441 - select(0i, 1i, (_e3434 < f32(_e3441))));
let _e3446 = (_e3413 + 1i);
let _e3447 = (_e3429 + 1i);
let _e3448 = (_e3445 + 1i);
let _e3458 = ((_e3446 >> bitcast<u32>(4i)) + (_e3005 * ((_e3447 >> bitcast<u32>(4i)) + (_e3012 * (_e3448 >> bitcast<u32>(4i))))));
let _e3460 = select(_e3024, _e3458, (_e3458 < _e3024));
let _e3466 = global_1.member[bitcast<u32>(select(0i, _e3460, (_e3460 > 0i)))];
let _e3468 = (_e3446 & 15i);
let _e3471 = ((_e3447 & 15i) * _e2990);
let _e3473 = (bitcast<i32>(_e3466) + ((_e3448 & 15i) * _e2995));
let _e3474 = (_e3471 + _e2990);
let _e3475 = (_e3471 + _e3041);
let _e3476 = (_e3473 + _e2995);
let _e3477 = (_e3473 + _e3044);
local_6 = type_29(array<i32, 4>(_e3468, _e3468, _e3468, _e3468), array<u32, 6>(0u, 8u, 16u, 24u, 0u, 0u));
local_7 = (_e3397 - vec3<f32>(f32(_e3413), f32(_e3429), f32(_e3445)));
let _e3489 = local_6.member[0u];
let _e3490 = ((_e3476 + _e3474) + _e3489);
let _e3492 = (_e3490 >> bitcast<u32>(2i));
let _e3495 = bitcast<u32>(((_e3490 & 3i) * 8i));
let _e3497 = select(_e3024, _e3492, (_e3492 < _e3024));
let _e3502 = global_1.member[bitcast<u32>(select(0i, _e3497, (_e3497 > 0i)))];
let _e3506 = (_e3492 + 1i);
let _e3508 = select(_e3024, _e3506, (_e3506 < _e3024));
let _e3513 = global_1.member[bitcast<u32>(select(0i, _e3508, (_e3508 > 0i)))];
let _e3520 = ((_e3502 >> bitcast<u32>((_e3495 & 31u))) | ((_e3513 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3495) & 31u))));
let _e3523 = local_6.member_1[1u];
let _e3529 = f32(bitcast<i32>(((_e3520 >> bitcast<u32>((_e3523 & 31u))) & 255u)));
let _e3532 = local_6.member_1[2u];
let _e3539 = local_7[0u];
let _e3542 = (_e3529 + ((f32(bitcast<i32>(((_e3520 >> bitcast<u32>((_e3532 & 31u))) & 255u))) - _e3529) * _e3539));
let _e3544 = local_6.member[0u];
let _e3545 = ((_e3476 + _e3475) + _e3544);
let _e3547 = (_e3545 >> bitcast<u32>(2i));
let _e3550 = bitcast<u32>(((_e3545 & 3i) * 8i));
let _e3552 = select(_e3024, _e3547, (_e3547 < _e3024));
let _e3557 = global_1.member[bitcast<u32>(select(0i, _e3552, (_e3552 > 0i)))];
let _e3561 = (_e3547 + 1i);
let _e3563 = select(_e3024, _e3561, (_e3561 < _e3024));
let _e3568 = global_1.member[bitcast<u32>(select(0i, _e3563, (_e3563 > 0i)))];
let _e3575 = ((_e3557 >> bitcast<u32>((_e3550 & 31u))) | ((_e3568 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3550) & 31u))));
let _e3576 = local_6.member_1[1u];
let _e3582 = f32(bitcast<i32>(((_e3575 >> bitcast<u32>((_e3576 & 31u))) & 255u)));
let _e3583 = local_6.member_1[2u];
let _e3590 = local_7[0u];
let _e3595 = local_7[1u];
let _e3598 = (_e3542 + (((_e3582 + ((f32(bitcast<i32>(((_e3575 >> bitcast<u32>((_e3583 & 31u))) & 255u))) - _e3582) * _e3590)) - _e3542) * _e3595));
let _e3600 = local_6.member[0u];
let _e3601 = ((_e3477 + _e3474) + _e3600);
let _e3603 = (_e3601 >> bitcast<u32>(2i));
let _e3606 = bitcast<u32>(((_e3601 & 3i) * 8i));
let _e3608 = select(_e3024, _e3603, (_e3603 < _e3024));
let _e3613 = global_1.member[bitcast<u32>(select(0i, _e3608, (_e3608 > 0i)))];
let _e3617 = (_e3603 + 1i);
let _e3619 = select(_e3024, _e3617, (_e3617 < _e3024));
let _e3624 = global_1.member[bitcast<u32>(select(0i, _e3619, (_e3619 > 0i)))];
let _e3631 = ((_e3613 >> bitcast<u32>((_e3606 & 31u))) | ((_e3624 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3606) & 31u))));
let _e3632 = local_6.member_1[1u];
let _e3638 = f32(bitcast<i32>(((_e3631 >> bitcast<u32>((_e3632 & 31u))) & 255u)));
let _e3639 = local_6.member_1[2u];
let _e3646 = local_7[0u];
let _e3649 = (_e3638 + ((f32(bitcast<i32>(((_e3631 >> bitcast<u32>((_e3639 & 31u))) & 255u))) - _e3638) * _e3646));
let _e3651 = local_6.member[0u];
let _e3652 = ((_e3477 + _e3475) + _e3651);
let _e3654 = (_e3652 >> bitcast<u32>(2i));
let _e3657 = bitcast<u32>(((_e3652 & 3i) * 8i));
let _e3659 = select(_e3024, _e3654, (_e3654 < _e3024));
let _e3664 = global_1.member[bitcast<u32>(select(0i, _e3659, (_e3659 > 0i)))];
let _e3668 = (_e3654 + 1i);
let _e3670 = select(_e3024, _e3668, (_e3668 < _e3024));
let _e3675 = global_1.member[bitcast<u32>(select(0i, _e3670, (_e3670 > 0i)))];
let _e3682 = ((_e3664 >> bitcast<u32>((_e3657 & 31u))) | ((_e3675 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3657) & 31u))));
let _e3683 = local_6.member_1[1u];
let _e3689 = f32(bitcast<i32>(((_e3682 >> bitcast<u32>((_e3683 & 31u))) & 255u)));
let _e3690 = local_6.member_1[2u];
let _e3697 = local_7[0u];
let _e3701 = local_7[1u];
let _e3706 = local_7[2u];
let _e3711 = (((_e3598 + (((_e3649 + (((_e3689 + ((f32(bitcast<i32>(((_e3682 >> bitcast<u32>((_e3690 & 31u))) & 255u))) - _e3689) * _e3697)) - _e3649) * _e3701)) - _e3598) * _e3706)) - _e3282) * _e3287);
let _e3713 = select(_e3290, _e3711, (_e3711 > _e3290));
let _e3715 = select(1e9f, _e3713, (_e3713 < 1e9f));
if _e689 {
phi_6012_ = (_e3715 > _e3303);
} else {
phi_6012_ = (_e3715 < _e3303);
}
let _e3719 = phi_6012_;
let _e3720 = (_e1118 && _e3719);
let _e3721 = select(_e3303, _e3715, _e3720);
let _e3725 = (_e1115.member + (_e2838 * (2f * 0.25f)));
let _e3729 = (_e405 + (_e1119 * _e3725));
let _e3730 = (_e407 + (_e1120 * _e3725));
let _e3731 = (_e395 + (_e1121 * _e3725));
let _e3737 = ((((_e421.member.member * _e3729) + (_e421.member.member_1 * _e3730)) + (_e421.member.member_2 * _e3731)) + _e421.member_1);
let _e3743 = ((((_e437.member.member * _e3729) + (_e437.member.member_1 * _e3730)) + (_e437.member.member_2 * _e3731)) + _e437.member_1);
let _e3749 = ((((_e453.member.member * _e3729) + (_e453.member.member_1 * _e3730)) + (_e453.member.member_2 * _e3731)) + _e453.member_1);
let _e3751 = select(_e488, _e3737, (_e3737 > _e488));
let _e3753 = select(_e494, _e3751, (_e3751 < _e494));
let _e3755 = select(_e504, _e3743, (_e3743 > _e504));
let _e3757 = select(_e510, _e3755, (_e3755 < _e510));
let _e3759 = select(_e520, _e3749, (_e3749 > _e520));
let _e3761 = select(_e526, _e3759, (_e3759 < _e526));
if _e2883 {
phi_6226_ = vec3<f32>(_e3753, _e3757, _e3761);
} else {
let _e3763 = (_e3753 + 0.5f);
let _e3765 = select(0f, _e3763, (_e3763 > 0f));
let _e3767 = select(_e578, _e3765, (_e3765 < _e578));
let _e3774 = select(0i, select(select(i32(_e3767), i32(-2147483648), (_e3767 < -2147483600f)), 2147483647i, (_e3767 > 2147483500f)), (_e3767 == _e3767));
let _e3780 = (_e3757 + 0.5f);
let _e3782 = select(0f, _e3780, (_e3780 > 0f));
let _e3784 = select(_e609, _e3782, (_e3782 < _e609));
let _e3791 = select(0i, select(select(i32(_e3784), i32(-2147483648), (_e3784 < -2147483600f)), 2147483647i, (_e3784 > 2147483500f)), (_e3784 == _e3784));
let _e3797 = (_e3761 + 0.5f);
let _e3799 = select(0f, _e3797, (_e3797 > 0f));
let _e3801 = select(_e634, _e3799, (_e3799 < _e634));
let _e3808 = select(0i, select(select(i32(_e3801), i32(-2147483648), (_e3801 < -2147483600f)), 2147483647i, (_e3801 > 2147483500f)), (_e3801 == _e3801));
phi_6226_ = vec3<f32>(f32((_e3774 - select(0i, 1i, (_e3767 < f32(_e3774))))), f32((_e3791 - select(0i, 1i, (_e3784 < f32(_e3791))))), f32((_e3808 - select(0i, 1i, (_e3801 < f32(_e3808))))));
}
let _e3816 = phi_6226_;
let _e3819 = select(-1f, _e3816.x, (_e3816.x > -1f));
let _e3821 = select(_e576, _e3819, (_e3819 < _e576));
let _e3828 = select(0i, select(select(i32(_e3821), i32(-2147483648), (_e3821 < -2147483600f)), 2147483647i, (_e3821 > 2147483500f)), (_e3821 == _e3821));
let _e3832 = (_e3828 - select(0i, 1i, (_e3821 < f32(_e3828))));
let _e3835 = select(-1f, _e3816.y, (_e3816.y > -1f));
let _e3837 = select(_e607, _e3835, (_e3835 < _e607));
let _e3844 = select(0i, select(select(i32(_e3837), i32(-2147483648), (_e3837 < -2147483600f)), 2147483647i, (_e3837 > 2147483500f)), (_e3837 == _e3837));
let _e3848 = (_e3844 - select(0i, 1i, (_e3837 < f32(_e3844))));
let _e3851 = select(-1f, _e3816.z, (_e3816.z > -1f));
let _e3853 = select(_e632, _e3851, (_e3851 < _e632));
let _e3860 = select(0i, select(select(i32(_e3853), i32(-2147483648), (_e3853 < -2147483600f)), 2147483647i, (_e3853 > 2147483500f)), (_e3853 == _e3853));
let _e3864 = (_e3860 - select(0i, 1i, (_e3853 < f32(_e3860))));
let _e3865 = (_e3832 + 1i);
let _e3866 = (_e3848 + 1i);
let _e3867 = (_e3864 + 1i);
let _e3877 = ((_e3865 >> bitcast<u32>(4i)) + (_e3005 * ((_e3866 >> bitcast<u32>(4i)) + (_e3012 * (_e3867 >> bitcast<u32>(4i))))));
let _e3879 = select(_e3024, _e3877, (_e3877 < _e3024));
let _e3885 = global_1.member[bitcast<u32>(select(0i, _e3879, (_e3879 > 0i)))];
let _e3887 = (_e3865 & 15i);
let _e3890 = ((_e3866 & 15i) * _e2990);
let _e3892 = (bitcast<i32>(_e3885) + ((_e3867 & 15i) * _e2995));
let _e3893 = (_e3890 + _e2990);
let _e3894 = (_e3890 + _e3041);
let _e3895 = (_e3892 + _e2995);
let _e3896 = (_e3892 + _e3044);
local_4 = type_29(array<i32, 4>(_e3887, _e3887, _e3887, _e3887), array<u32, 6>(0u, 8u, 16u, 24u, 0u, 0u));
local_5 = (_e3816 - vec3<f32>(f32(_e3832), f32(_e3848), f32(_e3864)));
let _e3908 = local_4.member[0u];
let _e3909 = ((_e3895 + _e3893) + _e3908);
let _e3911 = (_e3909 >> bitcast<u32>(2i));
let _e3914 = bitcast<u32>(((_e3909 & 3i) * 8i));
let _e3916 = select(_e3024, _e3911, (_e3911 < _e3024));
let _e3921 = global_1.member[bitcast<u32>(select(0i, _e3916, (_e3916 > 0i)))];
let _e3925 = (_e3911 + 1i);
let _e3927 = select(_e3024, _e3925, (_e3925 < _e3024));
let _e3932 = global_1.member[bitcast<u32>(select(0i, _e3927, (_e3927 > 0i)))];
let _e3939 = ((_e3921 >> bitcast<u32>((_e3914 & 31u))) | ((_e3932 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3914) & 31u))));
let _e3942 = local_4.member_1[1u];
let _e3948 = f32(bitcast<i32>(((_e3939 >> bitcast<u32>((_e3942 & 31u))) & 255u)));
let _e3951 = local_4.member_1[2u];
let _e3958 = local_5[0u];
let _e3961 = (_e3948 + ((f32(bitcast<i32>(((_e3939 >> bitcast<u32>((_e3951 & 31u))) & 255u))) - _e3948) * _e3958));
let _e3963 = local_4.member[0u];
let _e3964 = ((_e3895 + _e3894) + _e3963);
let _e3966 = (_e3964 >> bitcast<u32>(2i));
let _e3969 = bitcast<u32>(((_e3964 & 3i) * 8i));
let _e3971 = select(_e3024, _e3966, (_e3966 < _e3024));
let _e3976 = global_1.member[bitcast<u32>(select(0i, _e3971, (_e3971 > 0i)))];
let _e3980 = (_e3966 + 1i);
let _e3982 = select(_e3024, _e3980, (_e3980 < _e3024));
let _e3987 = global_1.member[bitcast<u32>(select(0i, _e3982, (_e3982 > 0i)))];
let _e3994 = ((_e3976 >> bitcast<u32>((_e3969 & 31u))) | ((_e3987 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3969) & 31u))));
let _e3995 = local_4.member_1[1u];
let _e4001 = f32(bitcast<i32>(((_e3994 >> bitcast<u32>((_e3995 & 31u))) & 255u)));
let _e4002 = local_4.member_1[2u];
let _e4009 = local_5[0u];
let _e4014 = local_5[1u];
let _e4017 = (_e3961 + (((_e4001 + ((f32(bitcast<i32>(((_e3994 >> bitcast<u32>((_e4002 & 31u))) & 255u))) - _e4001) * _e4009)) - _e3961) * _e4014));
let _e4019 = local_4.member[0u];
let _e4020 = ((_e3896 + _e3893) + _e4019);
let _e4022 = (_e4020 >> bitcast<u32>(2i));
let _e4025 = bitcast<u32>(((_e4020 & 3i) * 8i));
let _e4027 = select(_e3024, _e4022, (_e4022 < _e3024));
let _e4032 = global_1.member[bitcast<u32>(select(0i, _e4027, (_e4027 > 0i)))];
let _e4036 = (_e4022 + 1i);
let _e4038 = select(_e3024, _e4036, (_e4036 < _e3024));
let _e4043 = global_1.member[bitcast<u32>(select(0i, _e4038, (_e4038 > 0i)))];
let _e4050 = ((_e4032 >> bitcast<u32>((_e4025 & 31u))) | ((_e4043 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4025) & 31u))));
let _e4051 = local_4.member_1[1u];
let _e4057 = f32(bitcast<i32>(((_e4050 >> bitcast<u32>((_e4051 & 31u))) & 255u)));
let _e4058 = local_4.member_1[2u];
let _e4065 = local_5[0u];
let _e4068 = (_e4057 + ((f32(bitcast<i32>(((_e4050 >> bitcast<u32>((_e4058 & 31u))) & 255u))) - _e4057) * _e4065));
let _e4070 = local_4.member[0u];
let _e4071 = ((_e3896 + _e3894) + _e4070);
let _e4073 = (_e4071 >> bitcast<u32>(2i));
let _e4076 = bitcast<u32>(((_e4071 & 3i) * 8i));
let _e4078 = select(_e3024, _e4073, (_e4073 < _e3024));
let _e4083 = global_1.member[bitcast<u32>(select(0i, _e4078, (_e4078 > 0i)))];
let _e4087 = (_e4073 + 1i);
let _e4089 = select(_e3024, _e4087, (_e4087 < _e3024));
let _e4094 = global_1.member[bitcast<u32>(select(0i, _e4089, (_e4089 > 0i)))];
let _e4101 = ((_e4083 >> bitcast<u32>((_e4076 & 31u))) | ((_e4094 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4076) & 31u))));
let _e4102 = local_4.member_1[1u];
let _e4108 = f32(bitcast<i32>(((_e4101 >> bitcast<u32>((_e4102 & 31u))) & 255u)));
let _e4109 = local_4.member_1[2u];
let _e4116 = local_5[0u];
let _e4120 = local_5[1u];
let _e4125 = local_5[2u];
let _e4130 = (((_e4017 + (((_e4068 + (((_e4108 + ((f32(bitcast<i32>(((_e4101 >> bitcast<u32>((_e4109 & 31u))) & 255u))) - _e4108) * _e4116)) - _e4068) * _e4120)) - _e4017) * _e4125)) - _e3282) * _e3287);
let _e4132 = select(_e3290, _e4130, (_e4130 > _e3290));
let _e4134 = select(1e9f, _e4132, (_e4132 < 1e9f));
if _e689 {
phi_6701_ = (_e4134 > _e3721);
} else {
phi_6701_ = (_e4134 < _e3721);
}
let _e4138 = phi_6701_;
let _e4139 = (_e1118 && _e4138);
let _e4140 = select(_e3721, _e4134, _e4139);
let _e4144 = (_e1115.member + (_e2838 * (3f * 0.25f)));
let _e4148 = (_e405 + (_e1119 * _e4144));
let _e4149 = (_e407 + (_e1120 * _e4144));
let _e4150 = (_e395 + (_e1121 * _e4144));
let _e4156 = ((((_e421.member.member * _e4148) + (_e421.member.member_1 * _e4149)) + (_e421.member.member_2 * _e4150)) + _e421.member_1);
let _e4162 = ((((_e437.member.member * _e4148) + (_e437.member.member_1 * _e4149)) + (_e437.member.member_2 * _e4150)) + _e437.member_1);
let _e4168 = ((((_e453.member.member * _e4148) + (_e453.member.member_1 * _e4149)) + (_e453.member.member_2 * _e4150)) + _e453.member_1);
let _e4170 = select(_e488, _e4156, (_e4156 > _e488));
let _e4172 = select(_e494, _e4170, (_e4170 < _e494));
let _e4174 = select(_e504, _e4162, (_e4162 > _e504));
let _e4176 = select(_e510, _e4174, (_e4174 < _e510));
let _e4178 = select(_e520, _e4168, (_e4168 > _e520));
let _e4180 = select(_e526, _e4178, (_e4178 < _e526));
if _e2883 {
phi_6915_ = vec3<f32>(_e4172, _e4176, _e4180);
} else {
let _e4182 = (_e4172 + 0.5f);
let _e4184 = select(0f, _e4182, (_e4182 > 0f));
let _e4186 = select(_e578, _e4184, (_e4184 < _e578));
let _e4193 = select(0i, select(select(i32(_e4186), i32(-2147483648), (_e4186 < -2147483600f)), 2147483647i, (_e4186 > 2147483500f)), (_e4186 == _e4186));
let _e4199 = (_e4176 + 0.5f);
let _e4201 = select(0f, _e4199, (_e4199 > 0f));
let _e4203 = select(_e609, _e4201, (_e4201 < _e609));
let _e4210 = select(0i, select(select(i32(_e4203), i32(-2147483648), (_e4203 < -2147483600f)), 2147483647i, (_e4203 > 2147483500f)), (_e4203 == _e4203));
let _e4216 = (_e4180 + 0.5f);
let _e4218 = select(0f, _e4216, (_e4216 > 0f));
let _e4220 = select(_e634, _e4218, (_e4218 < _e634));
let _e4227 = select(0i, select(select(i32(_e4220), i32(-2147483648), (_e4220 < -2147483600f)), 2147483647i, (_e4220 > 2147483500f)), (_e4220 == _e4220));
phi_6915_ = vec3<f32>(f32((_e4193 - select(0i, 1i, (_e4186 < f32(_e4193))))), f32((_e4210 - select(0i, 1i, (_e4203 < f32(_e4210))))), f32((_e4227 - select(0i, 1i, (_e4220 < f32(_e4227))))));
}
let _e4235 = phi_6915_;
let _e4238 = select(-1f, _e4235.x, (_e4235.x > -1f));
let _e4240 = select(_e576, _e4238, (_e4238 < _e576));
let _e4247 = select(0i, select(select(i32(_e4240), i32(-2147483648), (_e4240 < -2147483600f)), 2147483647i, (_e4240 > 2147483500f)), (_e4240 == _e4240));
let _e4251 = (_e4247 - select(0i, 1i, (_e4240 < f32(_e4247))));
let _e4254 = select(-1f, _e4235.y, (_e4235.y > -1f));
let _e4256 = select(_e607, _e4254, (_e4254 < _e607));
let _e4263 = select(0i, select(select(i32(_e4256), i32(-2147483648), (_e4256 < -2147483600f)), 2147483647i, (_e4256 > 2147483500f)), (_e4256 == _e4256));
let _e4267 = (_e4263 - select(0i, 1i, (_e4256 < f32(_e4263))));
let _e4270 = select(-1f, _e4235.z, (_e4235.z > -1f));
let _e4272 = select(_e632, _e4270, (_e4270 < _e632));
let _e4279 = select(0i, select(select(i32(_e4272), i32(-2147483648), (_e4272 < -2147483600f)), 2147483647i, (_e4272 > 2147483500f)), (_e4272 == _e4272));
let _e4283 = (_e4279 - select(0i, 1i, (_e4272 < f32(_e4279))));
let _e4284 = (_e4251 + 1i);
let _e4285 = (_e4267 + 1i);
let _e4286 = (_e4283 + 1i);
let _e4296 = ((_e4284 >> bitcast<u32>(4i)) + (_e3005 * ((_e4285 >> bitcast<u32>(4i)) + (_e3012 * (_e4286 >> bitcast<u32>(4i))))));
let _e4298 = select(_e3024, _e4296, (_e4296 < _e3024));
let _e4304 = global_1.member[bitcast<u32>(select(0i, _e4298, (_e4298 > 0i)))];
let _e4306 = (_e4284 & 15i);
let _e4309 = ((_e4285 & 15i) * _e2990);
let _e4311 = (bitcast<i32>(_e4304) + ((_e4286 & 15i) * _e2995));
let _e4312 = (_e4309 + _e2990);
let _e4313 = (_e4309 + _e3041);
let _e4314 = (_e4311 + _e2995);
let _e4315 = (_e4311 + _e3044);
local_2 = type_29(array<i32, 4>(_e4306, _e4306, _e4306, _e4306), array<u32, 6>(0u, 8u, 16u, 24u, 0u, 0u));
local_3 = (_e4235 - vec3<f32>(f32(_e4251), f32(_e4267), f32(_e4283)));
let _e4327 = local_2.member[0u];
let _e4328 = ((_e4314 + _e4312) + _e4327);
let _e4330 = (_e4328 >> bitcast<u32>(2i));
let _e4333 = bitcast<u32>(((_e4328 & 3i) * 8i));
let _e4335 = select(_e3024, _e4330, (_e4330 < _e3024));
let _e4340 = global_1.member[bitcast<u32>(select(0i, _e4335, (_e4335 > 0i)))];
let _e4344 = (_e4330 + 1i);
let _e4346 = select(_e3024, _e4344, (_e4344 < _e3024));
let _e4351 = global_1.member[bitcast<u32>(select(0i, _e4346, (_e4346 > 0i)))];
let _e4358 = ((_e4340 >> bitcast<u32>((_e4333 & 31u))) | ((_e4351 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4333) & 31u))));
let _e4361 = local_2.member_1[1u];
let _e4367 = f32(bitcast<i32>(((_e4358 >> bitcast<u32>((_e4361 & 31u))) & 255u)));
let _e4370 = local_2.member_1[2u];
let _e4377 = local_3[0u];
let _e4380 = (_e4367 + ((f32(bitcast<i32>(((_e4358 >> bitcast<u32>((_e4370 & 31u))) & 255u))) - _e4367) * _e4377));
let _e4382 = local_2.member[0u];
let _e4383 = ((_e4314 + _e4313) + _e4382);
let _e4385 = (_e4383 >> bitcast<u32>(2i));
let _e4388 = bitcast<u32>(((_e4383 & 3i) * 8i));
let _e4390 = select(_e3024, _e4385, (_e4385 < _e3024));
let _e4395 = global_1.member[bitcast<u32>(select(0i, _e4390, (_e4390 > 0i)))];
let _e4399 = (_e4385 + 1i);
let _e4401 = select(_e3024, _e4399, (_e4399 < _e3024));
let _e4406 = global_1.member[bitcast<u32>(select(0i, _e4401, (_e4401 > 0i)))];
let _e4413 = ((_e4395 >> bitcast<u32>((_e4388 & 31u))) | ((_e4406 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4388) & 31u))));
let _e4414 = local_2.member_1[1u];
let _e4420 = f32(bitcast<i32>(((_e4413 >> bitcast<u32>((_e4414 & 31u))) & 255u)));
let _e4421 = local_2.member_1[2u];
let _e4428 = local_3[0u];
let _e4433 = local_3[1u];
let _e4436 = (_e4380 + (((_e4420 + ((f32(bitcast<i32>(((_e4413 >> bitcast<u32>((_e4421 & 31u))) & 255u))) - _e4420) * _e4428)) - _e4380) * _e4433));
let _e4438 = local_2.member[0u];
let _e4439 = ((_e4315 + _e4312) + _e4438);
let _e4441 = (_e4439 >> bitcast<u32>(2i));
let _e4444 = bitcast<u32>(((_e4439 & 3i) * 8i));
let _e4446 = select(_e3024, _e4441, (_e4441 < _e3024));
let _e4451 = global_1.member[bitcast<u32>(select(0i, _e4446, (_e4446 > 0i)))];
let _e4455 = (_e4441 + 1i);
let _e4457 = select(_e3024, _e4455, (_e4455 < _e3024));
let _e4462 = global_1.member[bitcast<u32>(select(0i, _e4457, (_e4457 > 0i)))];
let _e4469 = ((_e4451 >> bitcast<u32>((_e4444 & 31u))) | ((_e4462 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4444) & 31u))));
let _e4470 = local_2.member_1[1u];
let _e4476 = f32(bitcast<i32>(((_e4469 >> bitcast<u32>((_e4470 & 31u))) & 255u)));
let _e4477 = local_2.member_1[2u];
let _e4484 = local_3[0u];
let _e4487 = (_e4476 + ((f32(bitcast<i32>(((_e4469 >> bitcast<u32>((_e4477 & 31u))) & 255u))) - _e4476) * _e4484));
let _e4489 = local_2.member[0u];
let _e4490 = ((_e4315 + _e4313) + _e4489);
let _e4492 = (_e4490 >> bitcast<u32>(2i));
let _e4495 = bitcast<u32>(((_e4490 & 3i) * 8i));
let _e4497 = select(_e3024, _e4492, (_e4492 < _e3024));
let _e4502 = global_1.member[bitcast<u32>(select(0i, _e4497, (_e4497 > 0i)))];
let _e4506 = (_e4492 + 1i);
let _e4508 = select(_e3024, _e4506, (_e4506 < _e3024));
let _e4513 = global_1.member[bitcast<u32>(select(0i, _e4508, (_e4508 > 0i)))];
let _e4520 = ((_e4502 >> bitcast<u32>((_e4495 & 31u))) | ((_e4513 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4495) & 31u))));
let _e4521 = local_2.member_1[1u];
let _e4527 = f32(bitcast<i32>(((_e4520 >> bitcast<u32>((_e4521 & 31u))) & 255u)));
let _e4528 = local_2.member_1[2u];
let _e4535 = local_3[0u];
let _e4539 = local_3[1u];
let _e4544 = local_3[2u];
let _e4549 = (((_e4436 + (((_e4487 + (((_e4527 + ((f32(bitcast<i32>(((_e4520 >> bitcast<u32>((_e4528 & 31u))) & 255u))) - _e4527) * _e4535)) - _e4487) * _e4539)) - _e4436) * _e4544)) - _e3282) * _e3287);
let _e4551 = select(_e3290, _e4549, (_e4549 > _e3290));
let _e4553 = select(1e9f, _e4551, (_e4551 < 1e9f));
if _e689 {
phi_7390_ = (_e4553 > _e4140);
} else {
phi_7390_ = (_e4553 < _e4140);
}
let _e4557 = phi_7390_;
let _e4558 = (_e1118 && _e4557);
let _e4559 = select(_e4140, _e4553, _e4558);
let _e4562 = (_e1115.member + (_e2838 * 1f));
let _e4566 = (_e405 + (_e1119 * _e4562));
let _e4567 = (_e407 + (_e1120 * _e4562));
let _e4568 = (_e395 + (_e1121 * _e4562));
let _e4574 = ((((_e421.member.member * _e4566) + (_e421.member.member_1 * _e4567)) + (_e421.member.member_2 * _e4568)) + _e421.member_1);
let _e4580 = ((((_e437.member.member * _e4566) + (_e437.member.member_1 * _e4567)) + (_e437.member.member_2 * _e4568)) + _e437.member_1);
let _e4586 = ((((_e453.member.member * _e4566) + (_e453.member.member_1 * _e4567)) + (_e453.member.member_2 * _e4568)) + _e453.member_1);
let _e4588 = select(_e488, _e4574, (_e4574 > _e488));
let _e4590 = select(_e494, _e4588, (_e4588 < _e494));
let _e4592 = select(_e504, _e4580, (_e4580 > _e504));
let _e4594 = select(_e510, _e4592, (_e4592 < _e510));
let _e4596 = select(_e520, _e4586, (_e4586 > _e520));
let _e4598 = select(_e526, _e4596, (_e4596 < _e526));
if _e2883 {
phi_7603_ = vec3<f32>(_e4590, _e4594, _e4598);
} else {
let _e4600 = (_e4590 + 0.5f);
let _e4602 = select(0f, _e4600, (_e4600 > 0f));
let _e4604 = select(_e578, _e4602, (_e4602 < _e578));
let _e4611 = select(0i, select(select(i32(_e4604), i32(-2147483648), (_e4604 < -2147483600f)), 2147483647i, (_e4604 > 2147483500f)), (_e4604 == _e4604));
let _e4617 = (_e4594 + 0.5f);
let _e4619 = select(0f, _e4617, (_e4617 > 0f));
let _e4621 = select(_e609, _e4619, (_e4619 < _e609));
let _e4628 = select(0i, select(select(i32(_e4621), i32(-2147483648), (_e4621 < -2147483600f)), 2147483647i, (_e4621 > 2147483500f)), (_e4621 == _e4621));
let _e4634 = (_e4598 + 0.5f);
let _e4636 = select(0f, _e4634, (_e4634 > 0f));
let _e4638 = select(_e634, _e4636, (_e4636 < _e634));
let _e4645 = select(0i, select(select(i32(_e4638), i32(-2147483648), (_e4638 < -2147483600f)), 2147483647i, (_e4638 > 2147483500f)), (_e4638 == _e4638));
phi_7603_ = vec3<f32>(f32((_e4611 - select(0i, 1i, (_e4604 < f32(_e4611))))), f32((_e4628 - select(0i, 1i, (_e4621 < f32(_e4628))))), f32((_e4645 - select(0i, 1i, (_e4638 < f32(_e4645))))));
}
let _e4653 = phi_7603_;
let _e4656 = select(-1f, _e4653.x, (_e4653.x > -1f));
let _e4658 = select(_e576, _e4656, (_e4656 < _e576));
let _e4665 = select(0i, select(select(i32(_e4658), i32(-2147483648), (_e4658 < -2147483600f)), 2147483647i, (_e4658 > 2147483500f)), (_e4658 == _e4658));
let _e4669 = (_e4665 - select(0i, 1i, (_e4658 < f32(_e4665))));
let _e4672 = select(-1f, _e4653.y, (_e4653.y > -1f));
let _e4674 = select(_e607, _e4672, (_e4672 < _e607));
let _e4681 = select(0i, select(select(i32(_e4674), i32(-2147483648), (_e4674 < -2147483600f)), 2147483647i, (_e4674 > 2147483500f)), (_e4674 == _e4674));
let _e4685 = (_e4681 - select(0i, 1i, (_e4674 < f32(_e4681))));
let _e4688 = select(-1f, _e4653.z, (_e4653.z > -1f));
let _e4690 = select(_e632, _e4688, (_e4688 < _e632));
let _e4697 = select(0i, select(select(i32(_e4690), i32(-2147483648), (_e4690 < -2147483600f)), 2147483647i, (_e4690 > 2147483500f)), (_e4690 == _e4690));
let _e4701 = (_e4697 - select(0i, 1i, (_e4690 < f32(_e4697))));
let _e4702 = (_e4669 + 1i);
let _e4703 = (_e4685 + 1i);
let _e4704 = (_e4701 + 1i);
let _e4714 = ((_e4702 >> bitcast<u32>(4i)) + (_e3005 * ((_e4703 >> bitcast<u32>(4i)) + (_e3012 * (_e4704 >> bitcast<u32>(4i))))));
let _e4716 = select(_e3024, _e4714, (_e4714 < _e3024));
let _e4722 = global_1.member[bitcast<u32>(select(0i, _e4716, (_e4716 > 0i)))];
let _e4724 = (_e4702 & 15i);
let _e4727 = ((_e4703 & 15i) * _e2990);
let _e4729 = (bitcast<i32>(_e4722) + ((_e4704 & 15i) * _e2995));
let _e4730 = (_e4727 + _e2990);
let _e4731 = (_e4727 + _e3041);
let _e4732 = (_e4729 + _e2995);
let _e4733 = (_e4729 + _e3044);
local = type_29(array<i32, 4>(_e4724, _e4724, _e4724, _e4724), array<u32, 6>(0u, 8u, 16u, 24u, 0u, 0u));
local_1 = (_e4653 - vec3<f32>(f32(_e4669), f32(_e4685), f32(_e4701)));
let _e4745 = local.member[0u];
let _e4746 = ((_e4732 + _e4730) + _e4745);
let _e4748 = (_e4746 >> bitcast<u32>(2i));
let _e4751 = bitcast<u32>(((_e4746 & 3i) * 8i));
let _e4753 = select(_e3024, _e4748, (_e4748 < _e3024));
let _e4758 = global_1.member[bitcast<u32>(select(0i, _e4753, (_e4753 > 0i)))];
let _e4762 = (_e4748 + 1i);
let _e4764 = select(_e3024, _e4762, (_e4762 < _e3024));
let _e4769 = global_1.member[bitcast<u32>(select(0i, _e4764, (_e4764 > 0i)))];
let _e4776 = ((_e4758 >> bitcast<u32>((_e4751 & 31u))) | ((_e4769 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4751) & 31u))));
let _e4779 = local.member_1[1u];
let _e4785 = f32(bitcast<i32>(((_e4776 >> bitcast<u32>((_e4779 & 31u))) & 255u)));
let _e4788 = local.member_1[2u];
let _e4795 = local_1[0u];
let _e4798 = (_e4785 + ((f32(bitcast<i32>(((_e4776 >> bitcast<u32>((_e4788 & 31u))) & 255u))) - _e4785) * _e4795));
let _e4800 = local.member[0u];
let _e4801 = ((_e4732 + _e4731) + _e4800);
let _e4803 = (_e4801 >> bitcast<u32>(2i));
let _e4806 = bitcast<u32>(((_e4801 & 3i) * 8i));
let _e4808 = select(_e3024, _e4803, (_e4803 < _e3024));
let _e4813 = global_1.member[bitcast<u32>(select(0i, _e4808, (_e4808 > 0i)))];
let _e4817 = (_e4803 + 1i);
let _e4819 = select(_e3024, _e4817, (_e4817 < _e3024));
let _e4824 = global_1.member[bitcast<u32>(select(0i, _e4819, (_e4819 > 0i)))];
let _e4831 = ((_e4813 >> bitcast<u32>((_e4806 & 31u))) | ((_e4824 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4806) & 31u))));
let _e4832 = local.member_1[1u];
let _e4838 = f32(bitcast<i32>(((_e4831 >> bitcast<u32>((_e4832 & 31u))) & 255u)));
let _e4839 = local.member_1[2u];
let _e4846 = local_1[0u];
let _e4851 = local_1[1u];
let _e4854 = (_e4798 + (((_e4838 + ((f32(bitcast<i32>(((_e4831 >> bitcast<u32>((_e4839 & 31u))) & 255u))) - _e4838) * _e4846)) - _e4798) * _e4851));
let _e4856 = local.member[0u];
let _e4857 = ((_e4733 + _e4730) + _e4856);
let _e4859 = (_e4857 >> bitcast<u32>(2i));
let _e4862 = bitcast<u32>(((_e4857 & 3i) * 8i));
let _e4864 = select(_e3024, _e4859, (_e4859 < _e3024));
let _e4869 = global_1.member[bitcast<u32>(select(0i, _e4864, (_e4864 > 0i)))];
let _e4873 = (_e4859 + 1i);
let _e4875 = select(_e3024, _e4873, (_e4873 < _e3024));
let _e4880 = global_1.member[bitcast<u32>(select(0i, _e4875, (_e4875 > 0i)))];
let _e4887 = ((_e4869 >> bitcast<u32>((_e4862 & 31u))) | ((_e4880 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4862) & 31u))));
let _e4888 = local.member_1[1u];
let _e4894 = f32(bitcast<i32>(((_e4887 >> bitcast<u32>((_e4888 & 31u))) & 255u)));
let _e4895 = local.member_1[2u];
let _e4902 = local_1[0u];
let _e4905 = (_e4894 + ((f32(bitcast<i32>(((_e4887 >> bitcast<u32>((_e4895 & 31u))) & 255u))) - _e4894) * _e4902));
let _e4907 = local.member[0u];
let _e4908 = ((_e4733 + _e4731) + _e4907);
let _e4910 = (_e4908 >> bitcast<u32>(2i));
let _e4913 = bitcast<u32>(((_e4908 & 3i) * 8i));
let _e4915 = select(_e3024, _e4910, (_e4910 < _e3024));
let _e4920 = global_1.member[bitcast<u32>(select(0i, _e4915, (_e4915 > 0i)))];
let _e4924 = (_e4910 + 1i);
let _e4926 = select(_e3024, _e4924, (_e4924 < _e3024));
let _e4931 = global_1.member[bitcast<u32>(select(0i, _e4926, (_e4926 > 0i)))];
let _e4938 = ((_e4920 >> bitcast<u32>((_e4913 & 31u))) | ((_e4931 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4913) & 31u))));
let _e4939 = local.member_1[1u];
let _e4945 = f32(bitcast<i32>(((_e4938 >> bitcast<u32>((_e4939 & 31u))) & 255u)));
let _e4946 = local.member_1[2u];
let _e4953 = local_1[0u];
let _e4957 = local_1[1u];
let _e4962 = local_1[2u];
let _e4967 = (((_e4854 + (((_e4905 + (((_e4945 + ((f32(bitcast<i32>(((_e4938 >> bitcast<u32>((_e4946 & 31u))) & 255u))) - _e4945) * _e4953)) - _e4905) * _e4957)) - _e4854) * _e4962)) - _e3282) * _e3287);
let _e4969 = select(_e3290, _e4967, (_e4967 > _e3290));
let _e4971 = select(1e9f, _e4969, (_e4969 < 1e9f));
if _e689 {
phi_8078_ = (_e4971 > _e4559);
} else {
phi_8078_ = (_e4971 < _e4559);
}
let _e4975 = phi_8078_;
let _e4976 = (_e1118 && _e4975);
phi_8088_ = select(select(select(select(select(_e375[8], _e2846, _e3302), _e3312, _e3720), _e3731, _e4139), _e4150, _e4558), _e4568, _e4976);
phi_8089_ = select(_e4559, _e4971, _e4976);
}
let _e4980 = phi_8088_;
let _e4982 = phi_8089_;
phi_8107_ = array<f32, 23>(_e375[0], _e375[1], _e375[2], _e375[3], _e375[4], _e375[5], select(_e375[6], _e4982, _e1118), _e375[7], select(_e375[8], _e4980, _e1118), _e375[9], _e375[10], _e375[11], _e375[12], _e375[13], _e375[14], _e375[15], _e375[16], select(_e375[17], _e416, _e1118), _e375[18], _e375[19], _e375[20], _e375[21], _e375[22]);
} else {
phi_8107_ = _e375;
}
let _e4988 = phi_8107_;
phi_633_ = (_e371 + 1u);
phi_636_ = select(_e373, true, _e747);
phi_638_ = _e4988;
} else {
phi_633_ = u32();
phi_636_ = bool();
phi_638_ = array<f32, 23>();
}
let _e4992 = phi_633_;
let _e4994 = phi_636_;
let _e4996 = phi_638_;
continue;
continuing {
phi_632_ = _e4992;
phi_635_ = _e4994;
phi_637_ = _e4996;
phi_8210_ = false;
break if !(_e376);
}
}
let _e4999 = phi_8210_;
if _e4999 {
break;
}
let _e5001 = local_18;
if _e5001 {
let _e5003 = local_19;
global_4.member[_e116] = _e5003[0];
let _e5008 = local_20;
global_4.member[_e128] = _e5008[1];
let _e5013 = local_21;
global_4.member[_e139] = _e5013[2];
let _e5018 = local_22;
global_4.member[_e150] = _e5018[3];
let _e5023 = local_23;
global_4.member[_e161] = _e5023[4];
let _e5028 = local_24;
global_4.member[_e172] = _e5028[5];
let _e5033 = local_25;
global_4.member[_e183] = _e5033[6];
let _e5038 = local_26;
global_4.member[_e194] = _e5038[7];
let _e5043 = local_27;
global_4.member[_e205] = _e5043[8];
let _e5048 = local_28;
global_4.member[_e216] = _e5048[9];
let _e5053 = local_29;
global_4.member[_e227] = _e5053[10];
let _e5058 = local_30;
global_4.member[_e238] = _e5058[11];
let _e5063 = local_31;
global_4.member[_e249] = _e5063[12];
let _e5068 = local_32;
global_4.member[_e260] = _e5068[13];
let _e5073 = local_33;
global_4.member[_e271] = _e5073[14];
let _e5078 = local_34;
global_4.member[_e282] = _e5078[15];
let _e5083 = local_35;
global_4.member[_e293] = _e5083[16];
let _e5088 = local_36;
global_4.member[_e304] = _e5088[17];
let _e5093 = local_37;
global_4.member[_e315] = _e5093[18];
let _e5098 = local_38;
global_4.member[_e326] = _e5098[19];
let _e5103 = local_39;
global_4.member[_e337] = _e5103[20];
let _e5108 = local_40;
global_4.member[_e348] = _e5108[21];
let _e5113 = local_41;
global_4.member[_e359] = _e5113[22];
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
