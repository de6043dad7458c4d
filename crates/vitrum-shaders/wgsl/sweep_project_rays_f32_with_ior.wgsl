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
var phi_625_: u32;
var phi_628_: bool;
var phi_630_: array<f32, 23>;
var phi_994_: bool;
var phi_1890_: type_32;
var phi_2111_: vec3<f32>;
var phi_2728_: vec3<f32>;
var phi_3345_: vec3<f32>;
var phi_3962_: vec3<f32>;
var phi_4407_: f32;
var phi_4615_: vec3<f32>;
var phi_5037_: bool;
var phi_5250_: vec3<f32>;
var phi_5669_: bool;
var phi_5883_: vec3<f32>;
var phi_6302_: bool;
var phi_6516_: vec3<f32>;
var phi_6935_: bool;
var phi_7148_: vec3<f32>;
var phi_7567_: bool;
var phi_7577_: f32;
var phi_7578_: f32;
var phi_7596_: array<f32, 23>;
var phi_626_: u32;
var phi_629_: bool;
var phi_631_: array<f32, 23>;
var phi_7699_: bool;
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
let _e78 = global;
let _e80 = arrayLength((&global_2.member));
let _e83 = arrayLength((&global_1.member));
if (0u < _e80) {
} else {
break;
}
let _e92 = global_2.member[0u].member_2;
let _e96 = global_2.member[0u].member;
let _e104 = (_e78.x + _e92.member);
let _e106 = (_e78.y + _e92.member_1);
if (_e104 < _e92.member_2) {
if (_e106 < _e92.member_3) {
let _e109 = (_e96.member * _e96.member_1);
let _e111 = ((_e106 * _e96.member) + _e104);
let _e112 = bitcast<i32>(_e111);
let _e114 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e116 = select(_e114, _e112, (_e112 < _e114));
let _e122 = global_4.member[bitcast<u32>(select(0i, _e116, (_e116 > 0i)))];
let _e123 = (_e109 + _e111);
let _e124 = bitcast<i32>(_e123);
let _e126 = select(_e114, _e124, (_e124 < _e114));
let _e132 = global_4.member[bitcast<u32>(select(0i, _e126, (_e126 > 0i)))];
let _e134 = ((2u * _e109) + _e111);
let _e135 = bitcast<i32>(_e134);
let _e137 = select(_e114, _e135, (_e135 < _e114));
let _e143 = global_4.member[bitcast<u32>(select(0i, _e137, (_e137 > 0i)))];
let _e145 = ((3u * _e109) + _e111);
let _e146 = bitcast<i32>(_e145);
let _e148 = select(_e114, _e146, (_e146 < _e114));
let _e154 = global_4.member[bitcast<u32>(select(0i, _e148, (_e148 > 0i)))];
let _e156 = ((4u * _e109) + _e111);
let _e157 = bitcast<i32>(_e156);
let _e159 = select(_e114, _e157, (_e157 < _e114));
let _e165 = global_4.member[bitcast<u32>(select(0i, _e159, (_e159 > 0i)))];
let _e167 = ((5u * _e109) + _e111);
let _e168 = bitcast<i32>(_e167);
let _e170 = select(_e114, _e168, (_e168 < _e114));
let _e176 = global_4.member[bitcast<u32>(select(0i, _e170, (_e170 > 0i)))];
let _e178 = ((6u * _e109) + _e111);
let _e179 = bitcast<i32>(_e178);
let _e181 = select(_e114, _e179, (_e179 < _e114));
let _e187 = global_4.member[bitcast<u32>(select(0i, _e181, (_e181 > 0i)))];
let _e189 = ((7u * _e109) + _e111);
let _e190 = bitcast<i32>(_e189);
let _e192 = select(_e114, _e190, (_e190 < _e114));
let _e198 = global_4.member[bitcast<u32>(select(0i, _e192, (_e192 > 0i)))];
let _e200 = ((8u * _e109) + _e111);
let _e201 = bitcast<i32>(_e200);
let _e203 = select(_e114, _e201, (_e201 < _e114));
let _e209 = global_4.member[bitcast<u32>(select(0i, _e203, (_e203 > 0i)))];
let _e211 = ((9u * _e109) + _e111);
let _e212 = bitcast<i32>(_e211);
let _e214 = select(_e114, _e212, (_e212 < _e114));
let _e220 = global_4.member[bitcast<u32>(select(0i, _e214, (_e214 > 0i)))];
let _e222 = ((10u * _e109) + _e111);
let _e223 = bitcast<i32>(_e222);
let _e225 = select(_e114, _e223, (_e223 < _e114));
let _e231 = global_4.member[bitcast<u32>(select(0i, _e225, (_e225 > 0i)))];
let _e233 = ((11u * _e109) + _e111);
let _e234 = bitcast<i32>(_e233);
let _e236 = select(_e114, _e234, (_e234 < _e114));
let _e242 = global_4.member[bitcast<u32>(select(0i, _e236, (_e236 > 0i)))];
let _e244 = ((12u * _e109) + _e111);
let _e245 = bitcast<i32>(_e244);
let _e247 = select(_e114, _e245, (_e245 < _e114));
let _e253 = global_4.member[bitcast<u32>(select(0i, _e247, (_e247 > 0i)))];
let _e255 = ((13u * _e109) + _e111);
let _e256 = bitcast<i32>(_e255);
let _e258 = select(_e114, _e256, (_e256 < _e114));
let _e264 = global_4.member[bitcast<u32>(select(0i, _e258, (_e258 > 0i)))];
let _e266 = ((14u * _e109) + _e111);
let _e267 = bitcast<i32>(_e266);
let _e269 = select(_e114, _e267, (_e267 < _e114));
let _e275 = global_4.member[bitcast<u32>(select(0i, _e269, (_e269 > 0i)))];
let _e277 = ((15u * _e109) + _e111);
let _e278 = bitcast<i32>(_e277);
let _e280 = select(_e114, _e278, (_e278 < _e114));
let _e286 = global_4.member[bitcast<u32>(select(0i, _e280, (_e280 > 0i)))];
let _e288 = ((16u * _e109) + _e111);
let _e289 = bitcast<i32>(_e288);
let _e291 = select(_e114, _e289, (_e289 < _e114));
let _e297 = global_4.member[bitcast<u32>(select(0i, _e291, (_e291 > 0i)))];
let _e299 = ((17u * _e109) + _e111);
let _e300 = bitcast<i32>(_e299);
let _e302 = select(_e114, _e300, (_e300 < _e114));
let _e308 = global_4.member[bitcast<u32>(select(0i, _e302, (_e302 > 0i)))];
let _e310 = ((18u * _e109) + _e111);
let _e311 = bitcast<i32>(_e310);
let _e313 = select(_e114, _e311, (_e311 < _e114));
let _e319 = global_4.member[bitcast<u32>(select(0i, _e313, (_e313 > 0i)))];
let _e321 = ((19u * _e109) + _e111);
let _e322 = bitcast<i32>(_e321);
let _e324 = select(_e114, _e322, (_e322 < _e114));
let _e330 = global_4.member[bitcast<u32>(select(0i, _e324, (_e324 > 0i)))];
let _e332 = ((20u * _e109) + _e111);
let _e333 = bitcast<i32>(_e332);
let _e335 = select(_e114, _e333, (_e333 < _e114));
let _e341 = global_4.member[bitcast<u32>(select(0i, _e335, (_e335 > 0i)))];
let _e343 = ((21u * _e109) + _e111);
let _e344 = bitcast<i32>(_e343);
let _e346 = select(_e114, _e344, (_e344 < _e114));
let _e352 = global_4.member[bitcast<u32>(select(0i, _e346, (_e346 > 0i)))];
let _e354 = ((22u * _e109) + _e111);
let _e355 = bitcast<i32>(_e354);
let _e357 = select(_e114, _e355, (_e355 < _e114));
let _e363 = global_4.member[bitcast<u32>(select(0i, _e357, (_e357 > 0i)))];
phi_625_ = 0u;
phi_628_ = false;
phi_630_ = array<f32, 23>(_e122, _e132, _e143, _e154, _e165, _e176, _e187, _e198, _e209, _e220, _e231, _e242, _e253, _e264, _e275, _e286, _e297, _e308, _e319, _e330, _e341, _e352, _e363);
loop {
let _e366 = phi_625_;
let _e368 = phi_628_;
let _e370 = phi_630_;
local_18 = _e368;
local_19 = _e370;
local_20 = _e370;
local_21 = _e370;
local_22 = _e370;
local_23 = _e370;
local_24 = _e370;
local_25 = _e370;
local_26 = _e370;
local_27 = _e370;
local_28 = _e370;
local_29 = _e370;
local_30 = _e370;
local_31 = _e370;
local_32 = _e370;
local_33 = _e370;
local_34 = _e370;
local_35 = _e370;
local_36 = _e370;
local_37 = _e370;
local_38 = _e370;
local_39 = _e370;
local_40 = _e370;
local_41 = _e370;
let _e371 = (_e366 < _e80);
if _e371 {
if _e371 {
} else {
phi_7699_ = true;
break;
}
let _e375 = global_2.member[_e366].member;
let _e390 = global_2.member[_e366].member_7.member;
let _e392 = ((_e390 - _e370[2]) / _e370[5]);
let _e397 = global_2.member[_e366].member_7.member_2;
let _e398 = (_e397 / _e370[5]);
let _e400 = (_e370[0] + (_e370[3] * _e392));
let _e402 = (_e370[1] + (_e370[4] * _e392));
let _e404 = (_e400 + (_e370[3] * _e398));
let _e406 = (_e402 + (_e370[4] * _e398));
let _e411 = global_2.member[_e366].member_7.member_1;
let _e416 = global_2.member[_e366].member_8.member;
let _e427 = ((((_e416.member.member * _e400) + (_e416.member.member_1 * _e402)) + (_e416.member.member_2 * _e390)) + _e416.member_1);
let _e432 = global_2.member[_e366].member_8.member_1;
let _e443 = ((((_e432.member.member * _e400) + (_e432.member.member_1 * _e402)) + (_e432.member.member_2 * _e390)) + _e432.member_1);
let _e448 = global_2.member[_e366].member_8.member_2;
let _e459 = ((((_e448.member.member * _e400) + (_e448.member.member_1 * _e402)) + (_e448.member.member_2 * _e390)) + _e448.member_1);
let _e465 = ((((_e416.member.member * _e404) + (_e416.member.member_1 * _e406)) + (_e416.member.member_2 * _e411)) + _e416.member_1);
let _e471 = ((((_e432.member.member * _e404) + (_e432.member.member_1 * _e406)) + (_e432.member.member_2 * _e411)) + _e432.member_1);
let _e477 = ((((_e448.member.member * _e404) + (_e448.member.member_1 * _e406)) + (_e448.member.member_2 * _e411)) + _e448.member_1);
let _e483 = global_2.member[_e366].member_8.member_4.member;
let _e489 = global_2.member[_e366].member_8.member_5.member;
let _e491 = select(_e483, _e465, (_e465 > _e483));
let _e493 = select(_e489, _e491, (_e491 < _e489));
let _e499 = global_2.member[_e366].member_8.member_4.member_1;
let _e505 = global_2.member[_e366].member_8.member_5.member_1;
let _e507 = select(_e499, _e471, (_e471 > _e499));
let _e509 = select(_e505, _e507, (_e507 < _e505));
let _e515 = global_2.member[_e366].member_8.member_4.member_2;
let _e521 = global_2.member[_e366].member_8.member_5.member_2;
let _e523 = select(_e515, _e477, (_e477 > _e515));
let _e525 = select(_e521, _e523, (_e523 < _e521));
let _e531 = bitcast<f32>((bitcast<u32>((_e465 - _e427)) & 2147483647u));
let _e534 = bitcast<f32>((bitcast<u32>((_e471 - _e443)) & 2147483647u));
let _e536 = select(_e534, _e531, (_e531 > _e534));
let _e539 = bitcast<f32>((bitcast<u32>((_e477 - _e459)) & 2147483647u));
let _e546 = global_2.member[_e366].member_8.member_6;
let _e547 = (select(_e539, _e536, (_e536 > _e539)) <= _e546);
let _e553 = bitcast<f32>((bitcast<u32>((_e465 - _e493)) & 2147483647u));
let _e556 = bitcast<f32>((bitcast<u32>((_e471 - _e509)) & 2147483647u));
let _e558 = select(_e556, _e553, (_e553 > _e556));
let _e561 = bitcast<f32>((bitcast<u32>((_e477 - _e525)) & 2147483647u));
let _e571 = global_2.member[_e366].member_8.member_3.member;
let _e572 = (_e493 + 0.5f);
let _e573 = (_e571 - 1f);
let _e575 = select(0f, _e572, (_e572 > 0f));
let _e577 = select(_e573, _e575, (_e575 < _e573));
let _e584 = select(0i, select(select(i32(_e577), i32(-2147483648), (_e577 < -2147483600f)), 2147483647i, (_e577 > 2147483500f)), (_e577 == _e577));
let _e593 = global_2.member[_e366].member_8.member_14;
let _e594 = (_e593 & 31u);
let _e602 = global_2.member[_e366].member_8.member_3.member_1;
let _e603 = (_e509 + 0.5f);
let _e604 = (_e602 - 1f);
let _e606 = select(0f, _e603, (_e603 > 0f));
let _e608 = select(_e604, _e606, (_e606 < _e604));
let _e615 = select(0i, select(select(i32(_e608), i32(-2147483648), (_e608 < -2147483600f)), 2147483647i, (_e608 > 2147483500f)), (_e608 == _e608));
let _e627 = global_2.member[_e366].member_8.member_3.member_2;
let _e628 = (_e525 + 0.5f);
let _e629 = (_e627 - 1f);
let _e631 = select(0f, _e628, (_e628 > 0f));
let _e633 = select(_e629, _e631, (_e631 < _e629));
let _e640 = select(0i, select(select(i32(_e633), i32(-2147483648), (_e633 < -2147483600f)), 2147483647i, (_e633 > 2147483500f)), (_e633 == _e633));
let _e652 = global_2.member[_e366].member_8.member_11.member;
let _e659 = global_2.member[_e366].member_8.member_11.member_1;
let _e665 = global_2.member[_e366].member_8.member_12;
let _e671 = ((bitcast<i32>(_e665) + ((_e584 - select(0i, 1i, (_e577 < f32(_e584)))) >> bitcast<u32>(_e594))) + (bitcast<i32>(_e652) * (((_e615 - select(0i, 1i, (_e608 < f32(_e615)))) >> bitcast<u32>(_e594)) + (bitcast<i32>(_e659) * ((_e640 - select(0i, 1i, (_e633 < f32(_e640)))) >> bitcast<u32>(_e594))))));
let _e673 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e675 = select(_e673, _e671, (_e671 < _e673));
let _e681 = global_3.member[bitcast<u32>(select(0i, _e675, (_e675 > 0i)))];
let _e682 = bitcast<f32>(_e681);
let _e683 = (_e370[17] == -1.2676506e30f);
let _e684 = (_e375.member_2 == 0u);
if _e684 {
phi_994_ = (_e682 <= _e370[6]);
} else {
phi_994_ = (_e682 >= _e370[6]);
}
let _e688 = phi_994_;
let _e690 = !(_e683);
let _e697 = global_2.member[_e366].member_1;
let _e705 = (_e483 + 0.5f);
let _e707 = (_e489 - 0.5f);
let _e710 = (_e499 + 0.5f);
let _e713 = (_e505 - 0.5f);
let _e716 = (_e515 + 0.5f);
let _e719 = (_e521 - 0.5f);
let _e735 = ((_e697 & 16u) == 0u);
let _e742 = (select(0u, select(select(7u, 3u, (((((((((_e427 >= _e705) && (_e427 <= _e707)) && (_e443 >= _e710)) && (_e443 <= _e713)) && (_e459 >= _e716)) && (_e459 <= _e719)) && ((((((_e465 >= _e705) && (_e465 <= _e707)) && (_e471 >= _e710)) && (_e471 <= _e713)) && (_e477 >= _e716)) && (_e477 <= _e719))) && _e735) && _e690)), 1u, (((_e547 && (select(_e561, _e558, (_e558 > _e561)) > _e546)) || (((((_e375.member_2 != 2u) && _e690) && _e547) && _e688) && ((_e697 & 32u) != 0u))) || ((_e697 & 64u) != 0u))), (_e370[7] == 0f)) > 1u);
if _e742 {
let _e757 = (_e483 - _e427);
let _e758 = (_e483 - _e465);
let _e765 = bitcast<f32>((bitcast<u32>((_e757 - _e758)) & 2147483647u));
let _e768 = (bitcast<f32>((bitcast<u32>(_e757) & 2147483647u)) / select(1e-30f, _e765, (_e765 > 1e-30f)));
let _e770 = select(0f, _e768, (_e768 > 0f));
let _e772 = select(1f, _e770, (_e770 < 1f));
let _e774 = (_e758 > 0f);
let _e776 = select(0f, select(_e772, 2f, _e774), (_e757 > 0f));
let _e779 = select(1f, _e772, (_e774 && (_e757 <= 0f)));
let _e781 = select(_e776, 0f, (0f > _e776));
let _e783 = select(_e779, 1f, (1f < _e779));
let _e784 = (_e427 - _e489);
let _e785 = (_e465 - _e489);
let _e792 = bitcast<f32>((bitcast<u32>((_e784 - _e785)) & 2147483647u));
let _e795 = (bitcast<f32>((bitcast<u32>(_e784) & 2147483647u)) / select(1e-30f, _e792, (_e792 > 1e-30f)));
let _e797 = select(0f, _e795, (_e795 > 0f));
let _e799 = select(1f, _e797, (_e797 < 1f));
let _e801 = (_e785 > 0f);
let _e803 = select(0f, select(_e799, 2f, _e801), (_e784 > 0f));
let _e806 = select(1f, _e799, (_e801 && (_e784 <= 0f)));
let _e808 = select(_e803, _e781, (_e781 > _e803));
let _e810 = select(_e806, _e783, (_e783 < _e806));
let _e811 = (_e499 - _e443);
let _e812 = (_e499 - _e471);
let _e819 = bitcast<f32>((bitcast<u32>((_e811 - _e812)) & 2147483647u));
let _e822 = (bitcast<f32>((bitcast<u32>(_e811) & 2147483647u)) / select(1e-30f, _e819, (_e819 > 1e-30f)));
let _e824 = select(0f, _e822, (_e822 > 0f));
let _e826 = select(1f, _e824, (_e824 < 1f));
let _e828 = (_e812 > 0f);
let _e830 = select(0f, select(_e826, 2f, _e828), (_e811 > 0f));
let _e833 = select(1f, _e826, (_e828 && (_e811 <= 0f)));
let _e835 = select(_e830, _e808, (_e808 > _e830));
let _e837 = select(_e833, _e810, (_e810 < _e833));
let _e838 = (_e443 - _e505);
let _e839 = (_e471 - _e505);
let _e846 = bitcast<f32>((bitcast<u32>((_e838 - _e839)) & 2147483647u));
let _e849 = (bitcast<f32>((bitcast<u32>(_e838) & 2147483647u)) / select(1e-30f, _e846, (_e846 > 1e-30f)));
let _e851 = select(0f, _e849, (_e849 > 0f));
let _e853 = select(1f, _e851, (_e851 < 1f));
let _e855 = (_e839 > 0f);
let _e857 = select(0f, select(_e853, 2f, _e855), (_e838 > 0f));
let _e860 = select(1f, _e853, (_e855 && (_e838 <= 0f)));
let _e862 = select(_e857, _e835, (_e835 > _e857));
let _e864 = select(_e860, _e837, (_e837 < _e860));
let _e865 = (_e515 - _e459);
let _e866 = (_e515 - _e477);
let _e873 = bitcast<f32>((bitcast<u32>((_e865 - _e866)) & 2147483647u));
let _e876 = (bitcast<f32>((bitcast<u32>(_e865) & 2147483647u)) / select(1e-30f, _e873, (_e873 > 1e-30f)));
let _e878 = select(0f, _e876, (_e876 > 0f));
let _e880 = select(1f, _e878, (_e878 < 1f));
let _e882 = (_e866 > 0f);
let _e884 = select(0f, select(_e880, 2f, _e882), (_e865 > 0f));
let _e887 = select(1f, _e880, (_e882 && (_e865 <= 0f)));
let _e889 = select(_e884, _e862, (_e862 > _e884));
let _e891 = select(_e887, _e864, (_e864 < _e887));
let _e892 = (_e459 - _e521);
let _e893 = (_e477 - _e521);
let _e900 = bitcast<f32>((bitcast<u32>((_e892 - _e893)) & 2147483647u));
let _e903 = (bitcast<f32>((bitcast<u32>(_e892) & 2147483647u)) / select(1e-30f, _e900, (_e900 > 1e-30f)));
let _e905 = select(0f, _e903, (_e903 > 0f));
let _e907 = select(1f, _e905, (_e905 < 1f));
let _e909 = (_e893 > 0f);
let _e911 = select(0f, select(_e907, 2f, _e909), (_e892 > 0f));
let _e914 = select(1f, _e907, (_e909 && (_e892 <= 0f)));
let _e916 = select(_e911, _e889, (_e889 > _e911));
let _e918 = select(_e914, _e891, (_e891 < _e914));
if _e735 {
phi_1890_ = type_32(_e916, _e918);
} else {
let _e924 = global_2.member[_e366].member_16.member;
let _e935 = ((((_e924.member.member * _e400) + (_e924.member.member_1 * _e402)) + (_e924.member.member_2 * _e390)) + _e924.member_1);
let _e941 = ((((_e924.member.member * _e404) + (_e924.member.member_1 * _e406)) + (_e924.member.member_2 * _e411)) + _e924.member_1);
let _e948 = bitcast<f32>((bitcast<u32>((_e935 - _e941)) & 2147483647u));
let _e951 = (bitcast<f32>((bitcast<u32>(_e935) & 2147483647u)) / select(1e-30f, _e948, (_e948 > 1e-30f)));
let _e953 = select(0f, _e951, (_e951 > 0f));
let _e955 = select(1f, _e953, (_e953 < 1f));
let _e957 = (_e941 > 0f);
let _e959 = select(0f, select(_e955, 2f, _e957), (_e935 > 0f));
let _e962 = select(1f, _e955, (_e957 && (_e935 <= 0f)));
let _e964 = select(_e959, _e916, (_e916 > _e959));
let _e966 = select(_e962, _e918, (_e918 < _e962));
let _e971 = global_2.member[_e366].member_17.member;
let _e982 = ((((_e971.member.member * _e400) + (_e971.member.member_1 * _e402)) + (_e971.member.member_2 * _e390)) + _e971.member_1);
let _e988 = ((((_e971.member.member * _e404) + (_e971.member.member_1 * _e406)) + (_e971.member.member_2 * _e411)) + _e971.member_1);
let _e995 = bitcast<f32>((bitcast<u32>((_e982 - _e988)) & 2147483647u));
let _e998 = (bitcast<f32>((bitcast<u32>(_e982) & 2147483647u)) / select(1e-30f, _e995, (_e995 > 1e-30f)));
let _e1000 = select(0f, _e998, (_e998 > 0f));
let _e1002 = select(1f, _e1000, (_e1000 < 1f));
let _e1004 = (_e988 > 0f);
let _e1006 = select(0f, select(_e1002, 2f, _e1004), (_e982 > 0f));
let _e1009 = select(1f, _e1002, (_e1004 && (_e982 <= 0f)));
let _e1011 = select(_e1006, _e964, (_e964 > _e1006));
let _e1013 = select(_e1009, _e966, (_e966 < _e1009));
let _e1018 = global_2.member[_e366].member_18.member;
let _e1029 = ((((_e1018.member.member * _e400) + (_e1018.member.member_1 * _e402)) + (_e1018.member.member_2 * _e390)) + _e1018.member_1);
let _e1035 = ((((_e1018.member.member * _e404) + (_e1018.member.member_1 * _e406)) + (_e1018.member.member_2 * _e411)) + _e1018.member_1);
let _e1042 = bitcast<f32>((bitcast<u32>((_e1029 - _e1035)) & 2147483647u));
let _e1045 = (bitcast<f32>((bitcast<u32>(_e1029) & 2147483647u)) / select(1e-30f, _e1042, (_e1042 > 1e-30f)));
let _e1047 = select(0f, _e1045, (_e1045 > 0f));
let _e1049 = select(1f, _e1047, (_e1047 < 1f));
let _e1051 = (_e1035 > 0f);
let _e1053 = select(0f, select(_e1049, 2f, _e1051), (_e1029 > 0f));
let _e1056 = select(1f, _e1049, (_e1051 && (_e1029 <= 0f)));
let _e1058 = select(_e1053, _e1011, (_e1011 > _e1053));
let _e1060 = select(_e1056, _e1013, (_e1013 < _e1056));
let _e1065 = global_2.member[_e366].member_19.member;
let _e1076 = ((((_e1065.member.member * _e400) + (_e1065.member.member_1 * _e402)) + (_e1065.member.member_2 * _e390)) + _e1065.member_1);
let _e1082 = ((((_e1065.member.member * _e404) + (_e1065.member.member_1 * _e406)) + (_e1065.member.member_2 * _e411)) + _e1065.member_1);
let _e1089 = bitcast<f32>((bitcast<u32>((_e1076 - _e1082)) & 2147483647u));
let _e1092 = (bitcast<f32>((bitcast<u32>(_e1076) & 2147483647u)) / select(1e-30f, _e1089, (_e1089 > 1e-30f)));
let _e1094 = select(0f, _e1092, (_e1092 > 0f));
let _e1096 = select(1f, _e1094, (_e1094 < 1f));
let _e1098 = (_e1082 > 0f);
let _e1100 = select(0f, select(_e1096, 2f, _e1098), (_e1076 > 0f));
let _e1103 = select(1f, _e1096, (_e1098 && (_e1076 <= 0f)));
phi_1890_ = type_32(select(_e1100, _e1058, (_e1058 > _e1100)), select(_e1103, _e1060, (_e1060 < _e1103)));
}
let _e1110 = phi_1890_;
let _e1113 = (_e1110.member_1 > _e1110.member);
let _e1114 = (_e404 - _e400);
let _e1115 = (_e406 - _e402);
let _e1116 = (_e411 - _e390);
if (_e375.member_2 == 2u) {
let _e1119 = (_e1110.member_1 - _e1110.member);
let _e1121 = (_e1110.member + (_e1119 * (0.5f * 0.25f)));
let _e1125 = (_e400 + (_e1114 * _e1121));
let _e1126 = (_e402 + (_e1115 * _e1121));
let _e1127 = (_e390 + (_e1116 * _e1121));
let _e1133 = ((((_e416.member.member * _e1125) + (_e416.member.member_1 * _e1126)) + (_e416.member.member_2 * _e1127)) + _e416.member_1);
let _e1139 = ((((_e432.member.member * _e1125) + (_e432.member.member_1 * _e1126)) + (_e432.member.member_2 * _e1127)) + _e432.member_1);
let _e1145 = ((((_e448.member.member * _e1125) + (_e448.member.member_1 * _e1126)) + (_e448.member.member_2 * _e1127)) + _e448.member_1);
let _e1147 = select(_e483, _e1133, (_e1133 > _e483));
let _e1149 = select(_e489, _e1147, (_e1147 < _e489));
let _e1151 = select(_e499, _e1139, (_e1139 > _e499));
let _e1153 = select(_e505, _e1151, (_e1151 < _e505));
let _e1155 = select(_e515, _e1145, (_e1145 > _e515));
let _e1157 = select(_e521, _e1155, (_e1155 < _e521));
let _e1163 = global_2.member[_e366].member_8.member_15;
let _e1164 = (_e1163 == 0u);
if _e1164 {
phi_2111_ = vec3<f32>(_e1149, _e1153, _e1157);
} else {
let _e1165 = (_e1149 + 0.5f);
let _e1167 = select(0f, _e1165, (_e1165 > 0f));
let _e1169 = select(_e573, _e1167, (_e1167 < _e573));
let _e1176 = select(0i, select(select(i32(_e1169), i32(-2147483648), (_e1169 < -2147483600f)), 2147483647i, (_e1169 > 2147483500f)), (_e1169 == _e1169));
let _e1182 = (_e1153 + 0.5f);
let _e1184 = select(0f, _e1182, (_e1182 > 0f));
let _e1186 = select(_e604, _e1184, (_e1184 < _e604));
let _e1193 = select(0i, select(select(i32(_e1186), i32(-2147483648), (_e1186 < -2147483600f)), 2147483647i, (_e1186 > 2147483500f)), (_e1186 == _e1186));
let _e1199 = (_e1157 + 0.5f);
let _e1201 = select(0f, _e1199, (_e1199 > 0f));
let _e1203 = select(_e629, _e1201, (_e1201 < _e629));
let _e1210 = select(0i, select(select(i32(_e1203), i32(-2147483648), (_e1203 < -2147483600f)), 2147483647i, (_e1203 > 2147483500f)), (_e1203 == _e1203));
phi_2111_ = vec3<f32>(f32((_e1176 - select(0i, 1i, (_e1169 < f32(_e1176))))), f32((_e1193 - select(0i, 1i, (_e1186 < f32(_e1193))))), f32((_e1210 - select(0i, 1i, (_e1203 < f32(_e1210))))));
}
let _e1218 = phi_2111_;
let _e1221 = select(-1f, _e1218.x, (_e1218.x > -1f));
let _e1223 = select(_e571, _e1221, (_e1221 < _e571));
let _e1230 = select(0i, select(select(i32(_e1223), i32(-2147483648), (_e1223 < -2147483600f)), 2147483647i, (_e1223 > 2147483500f)), (_e1223 == _e1223));
let _e1234 = (_e1230 - select(0i, 1i, (_e1223 < f32(_e1230))));
let _e1237 = select(-1f, _e1218.y, (_e1218.y > -1f));
let _e1239 = select(_e602, _e1237, (_e1237 < _e602));
let _e1246 = select(0i, select(select(i32(_e1239), i32(-2147483648), (_e1239 < -2147483600f)), 2147483647i, (_e1239 > 2147483500f)), (_e1239 == _e1239));
let _e1250 = (_e1246 - select(0i, 1i, (_e1239 < f32(_e1246))));
let _e1253 = select(-1f, _e1218.z, (_e1218.z > -1f));
let _e1255 = select(_e627, _e1253, (_e1253 < _e627));
let _e1262 = select(0i, select(select(i32(_e1255), i32(-2147483648), (_e1255 < -2147483600f)), 2147483647i, (_e1255 > 2147483500f)), (_e1255 == _e1255));
let _e1266 = (_e1262 - select(0i, 1i, (_e1255 < f32(_e1262))));
let _e1271 = global_2.member[_e366].member_8.member_9;
let _e1276 = global_2.member[_e366].member_8.member_10;
let _e1284 = (select(0i, select(select(i32(_e602), i32(-2147483648), (_e602 < -2147483600f)), 2147483647i, (_e602 > 2147483500f)), (_e602 == _e602)) - 1i);
let _e1287 = (_e1250 + 1i);
let _e1297 = (select(0i, select(select(i32(_e627), i32(-2147483648), (_e627 < -2147483600f)), 2147483647i, (_e627 > 2147483500f)), (_e627 == _e627)) - 1i);
let _e1300 = (_e1266 + 1i);
let _e1310 = (select(0i, select(select(i32(_e571), i32(-2147483648), (_e571 < -2147483600f)), 2147483647i, (_e571 > 2147483500f)), (_e571 == _e571)) - 1i);
let _e1311 = (_e1234 - 1i);
let _e1316 = (_e1234 + 1i);
let _e1319 = (_e1234 + 2i);
let _e1322 = (select(0i, _e1250, (_e1250 > 0i)) * _e1271);
let _e1323 = (select(_e1284, _e1287, (_e1287 < _e1284)) * _e1271);
let _e1324 = (select(0i, _e1266, (_e1266 > 0i)) * _e1276);
let _e1325 = (select(_e1297, _e1300, (_e1300 < _e1297)) * _e1276);
local_16 = type_29(array<i32, 4>(select(0i, _e1311, (_e1311 > 0i)), select(0i, _e1234, (_e1234 > 0i)), select(_e1310, _e1316, (_e1316 < _e1310)), select(_e1310, _e1319, (_e1319 < _e1310))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_17 = (_e1218 - vec3<f32>(f32(_e1234), f32(_e1250), f32(_e1266)));
let _e1334 = (_e1324 + _e1322);
let _e1337 = local_16.member[1u];
let _e1338 = (_e1334 + _e1337);
let _e1340 = (bitcast<i32>(_e83) - 1i);
let _e1342 = select(_e1340, _e1338, (_e1338 < _e1340));
let _e1347 = global_1.member[bitcast<u32>(select(0i, _e1342, (_e1342 > 0i)))];
let _e1348 = bitcast<f32>(_e1347);
let _e1351 = local_16.member[2u];
let _e1352 = (_e1334 + _e1351);
let _e1354 = select(_e1340, _e1352, (_e1352 < _e1340));
let _e1359 = global_1.member[bitcast<u32>(select(0i, _e1354, (_e1354 > 0i)))];
let _e1361 = local_17[0u];
let _e1364 = (_e1348 + ((bitcast<f32>(_e1359) - _e1348) * _e1361));
let _e1365 = (_e1324 + _e1323);
let _e1366 = local_16.member[1u];
let _e1367 = (_e1365 + _e1366);
let _e1369 = select(_e1340, _e1367, (_e1367 < _e1340));
let _e1374 = global_1.member[bitcast<u32>(select(0i, _e1369, (_e1369 > 0i)))];
let _e1375 = bitcast<f32>(_e1374);
let _e1376 = local_16.member[2u];
let _e1377 = (_e1365 + _e1376);
let _e1379 = select(_e1340, _e1377, (_e1377 < _e1340));
let _e1384 = global_1.member[bitcast<u32>(select(0i, _e1379, (_e1379 > 0i)))];
let _e1386 = local_17[0u];
let _e1391 = local_17[1u];
let _e1394 = (_e1364 + (((_e1375 + ((bitcast<f32>(_e1384) - _e1375) * _e1386)) - _e1364) * _e1391));
let _e1395 = (_e1325 + _e1322);
let _e1396 = local_16.member[1u];
let _e1397 = (_e1395 + _e1396);
let _e1399 = select(_e1340, _e1397, (_e1397 < _e1340));
let _e1404 = global_1.member[bitcast<u32>(select(0i, _e1399, (_e1399 > 0i)))];
let _e1405 = bitcast<f32>(_e1404);
let _e1406 = local_16.member[2u];
let _e1407 = (_e1395 + _e1406);
let _e1409 = select(_e1340, _e1407, (_e1407 < _e1340));
let _e1414 = global_1.member[bitcast<u32>(select(0i, _e1409, (_e1409 > 0i)))];
let _e1416 = local_17[0u];
let _e1419 = (_e1405 + ((bitcast<f32>(_e1414) - _e1405) * _e1416));
let _e1420 = (_e1325 + _e1323);
let _e1421 = local_16.member[1u];
let _e1422 = (_e1420 + _e1421);
let _e1424 = select(_e1340, _e1422, (_e1422 < _e1340));
let _e1429 = global_1.member[bitcast<u32>(select(0i, _e1424, (_e1424 > 0i)))];
let _e1430 = bitcast<f32>(_e1429);
let _e1431 = local_16.member[2u];
let _e1432 = (_e1420 + _e1431);
let _e1434 = select(_e1340, _e1432, (_e1432 < _e1340));
let _e1439 = global_1.member[bitcast<u32>(select(0i, _e1434, (_e1434 > 0i)))];
let _e1441 = local_17[0u];
let _e1445 = local_17[1u];
let _e1450 = local_17[2u];
let _e1458 = global_2.member[_e366].member_8.member_8;
let _e1463 = global_2.member[_e366].member_8.member_7;
let _e1465 = (((_e1394 + (((_e1419 + (((_e1430 + ((bitcast<f32>(_e1439) - _e1430) * _e1441)) - _e1419) * _e1445)) - _e1394) * _e1450)) - _e1458) * _e1463);
let _e1466 = -(1e9f);
let _e1468 = select(_e1466, _e1465, (_e1465 > _e1466));
let _e1473 = (_e1110.member + (_e1119 * (1.5f * 0.25f)));
let _e1477 = (_e400 + (_e1114 * _e1473));
let _e1478 = (_e402 + (_e1115 * _e1473));
let _e1479 = (_e390 + (_e1116 * _e1473));
let _e1485 = ((((_e416.member.member * _e1477) + (_e416.member.member_1 * _e1478)) + (_e416.member.member_2 * _e1479)) + _e416.member_1);
let _e1491 = ((((_e432.member.member * _e1477) + (_e432.member.member_1 * _e1478)) + (_e432.member.member_2 * _e1479)) + _e432.member_1);
let _e1497 = ((((_e448.member.member * _e1477) + (_e448.member.member_1 * _e1478)) + (_e448.member.member_2 * _e1479)) + _e448.member_1);
let _e1499 = select(_e483, _e1485, (_e1485 > _e483));
let _e1501 = select(_e489, _e1499, (_e1499 < _e489));
let _e1503 = select(_e499, _e1491, (_e1491 > _e499));
let _e1505 = select(_e505, _e1503, (_e1503 < _e505));
let _e1507 = select(_e515, _e1497, (_e1497 > _e515));
let _e1509 = select(_e521, _e1507, (_e1507 < _e521));
if _e1164 {
phi_2728_ = vec3<f32>(_e1501, _e1505, _e1509);
} else {
let _e1511 = (_e1501 + 0.5f);
let _e1513 = select(0f, _e1511, (_e1511 > 0f));
let _e1515 = select(_e573, _e1513, (_e1513 < _e573));
let _e1522 = select(0i, select(select(i32(_e1515), i32(-2147483648), (_e1515 < -2147483600f)), 2147483647i, (_e1515 > 2147483500f)), (_e1515 == _e1515));
let _e1528 = (_e1505 + 0.5f);
let _e1530 = select(0f, _e1528, (_e1528 > 0f));
let _e1532 = select(_e604, _e1530, (_e1530 < _e604));
let _e1539 = select(0i, select(select(i32(_e1532), i32(-2147483648), (_e1532 < -2147483600f)), 2147483647i, (_e1532 > 2147483500f)), (_e1532 == _e1532));
let _e1545 = (_e1509 + 0.5f);
let _e1547 = select(0f, _e1545, (_e1545 > 0f));
let _e1549 = select(_e629, _e1547, (_e1547 < _e629));
let _e1556 = select(0i, select(select(i32(_e1549), i32(-2147483648), (_e1549 < -2147483600f)), 2147483647i, (_e1549 > 2147483500f)), (_e1549 == _e1549));
phi_2728_ = vec3<f32>(f32((_e1522 - select(0i, 1i, (_e1515 < f32(_e1522))))), f32((_e1539 - select(0i, 1i, (_e1532 < f32(_e1539))))), f32((_e1556 - select(0i, 1i, (_e1549 < f32(_e1556))))));
}
let _e1564 = phi_2728_;
let _e1567 = select(-1f, _e1564.x, (_e1564.x > -1f));
let _e1569 = select(_e571, _e1567, (_e1567 < _e571));
let _e1576 = select(0i, select(select(i32(_e1569), i32(-2147483648), (_e1569 < -2147483600f)), 2147483647i, (_e1569 > 2147483500f)), (_e1569 == _e1569));
let _e1580 = (_e1576 - select(0i, 1i, (_e1569 < f32(_e1576))));
let _e1583 = select(-1f, _e1564.y, (_e1564.y > -1f));
let _e1585 = select(_e602, _e1583, (_e1583 < _e602));
let _e1592 = select(0i, select(select(i32(_e1585), i32(-2147483648), (_e1585 < -2147483600f)), 2147483647i, (_e1585 > 2147483500f)), (_e1585 == _e1585));
let _e1596 = (_e1592 - select(0i, 1i, (_e1585 < f32(_e1592))));
let _e1599 = select(-1f, _e1564.z, (_e1564.z > -1f));
let _e1601 = select(_e627, _e1599, (_e1599 < _e627));
let _e1608 = select(0i, select(select(i32(_e1601), i32(-2147483648), (_e1601 < -2147483600f)), 2147483647i, (_e1601 > 2147483500f)), (_e1601 == _e1601));
let _e1612 = (_e1608 - select(0i, 1i, (_e1601 < f32(_e1608))));
let _e1615 = (_e1596 + 1i);
let _e1620 = (_e1612 + 1i);
let _e1623 = (_e1580 - 1i);
let _e1628 = (_e1580 + 1i);
let _e1631 = (_e1580 + 2i);
let _e1634 = (select(0i, _e1596, (_e1596 > 0i)) * _e1271);
let _e1635 = (select(_e1284, _e1615, (_e1615 < _e1284)) * _e1271);
let _e1636 = (select(0i, _e1612, (_e1612 > 0i)) * _e1276);
let _e1637 = (select(_e1297, _e1620, (_e1620 < _e1297)) * _e1276);
local_14 = type_29(array<i32, 4>(select(0i, _e1623, (_e1623 > 0i)), select(0i, _e1580, (_e1580 > 0i)), select(_e1310, _e1628, (_e1628 < _e1310)), select(_e1310, _e1631, (_e1631 < _e1310))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_15 = (_e1564 - vec3<f32>(f32(_e1580), f32(_e1596), f32(_e1612)));
let _e1646 = (_e1636 + _e1634);
let _e1649 = local_14.member[1u];
let _e1650 = (_e1646 + _e1649);
let _e1652 = select(_e1340, _e1650, (_e1650 < _e1340));
let _e1657 = global_1.member[bitcast<u32>(select(0i, _e1652, (_e1652 > 0i)))];
let _e1658 = bitcast<f32>(_e1657);
let _e1661 = local_14.member[2u];
let _e1662 = (_e1646 + _e1661);
let _e1664 = select(_e1340, _e1662, (_e1662 < _e1340));
let _e1669 = global_1.member[bitcast<u32>(select(0i, _e1664, (_e1664 > 0i)))];
let _e1671 = local_15[0u];
let _e1674 = (_e1658 + ((bitcast<f32>(_e1669) - _e1658) * _e1671));
let _e1675 = (_e1636 + _e1635);
let _e1676 = local_14.member[1u];
let _e1677 = (_e1675 + _e1676);
let _e1679 = select(_e1340, _e1677, (_e1677 < _e1340));
let _e1684 = global_1.member[bitcast<u32>(select(0i, _e1679, (_e1679 > 0i)))];
let _e1685 = bitcast<f32>(_e1684);
let _e1686 = local_14.member[2u];
let _e1687 = (_e1675 + _e1686);
let _e1689 = select(_e1340, _e1687, (_e1687 < _e1340));
let _e1694 = global_1.member[bitcast<u32>(select(0i, _e1689, (_e1689 > 0i)))];
let _e1696 = local_15[0u];
let _e1701 = local_15[1u];
let _e1704 = (_e1674 + (((_e1685 + ((bitcast<f32>(_e1694) - _e1685) * _e1696)) - _e1674) * _e1701));
let _e1705 = (_e1637 + _e1634);
let _e1706 = local_14.member[1u];
let _e1707 = (_e1705 + _e1706);
let _e1709 = select(_e1340, _e1707, (_e1707 < _e1340));
let _e1714 = global_1.member[bitcast<u32>(select(0i, _e1709, (_e1709 > 0i)))];
let _e1715 = bitcast<f32>(_e1714);
let _e1716 = local_14.member[2u];
let _e1717 = (_e1705 + _e1716);
let _e1719 = select(_e1340, _e1717, (_e1717 < _e1340));
let _e1724 = global_1.member[bitcast<u32>(select(0i, _e1719, (_e1719 > 0i)))];
let _e1726 = local_15[0u];
let _e1729 = (_e1715 + ((bitcast<f32>(_e1724) - _e1715) * _e1726));
let _e1730 = (_e1637 + _e1635);
let _e1731 = local_14.member[1u];
let _e1732 = (_e1730 + _e1731);
let _e1734 = select(_e1340, _e1732, (_e1732 < _e1340));
let _e1739 = global_1.member[bitcast<u32>(select(0i, _e1734, (_e1734 > 0i)))];
let _e1740 = bitcast<f32>(_e1739);
let _e1741 = local_14.member[2u];
let _e1742 = (_e1730 + _e1741);
let _e1744 = select(_e1340, _e1742, (_e1742 < _e1340));
let _e1749 = global_1.member[bitcast<u32>(select(0i, _e1744, (_e1744 > 0i)))];
let _e1751 = local_15[0u];
let _e1755 = local_15[1u];
let _e1760 = local_15[2u];
let _e1765 = (((_e1704 + (((_e1729 + (((_e1740 + ((bitcast<f32>(_e1749) - _e1740) * _e1751)) - _e1729) * _e1755)) - _e1704) * _e1760)) - _e1458) * _e1463);
let _e1767 = select(_e1466, _e1765, (_e1765 > _e1466));
let _e1772 = (_e1110.member + (_e1119 * (2.5f * 0.25f)));
let _e1776 = (_e400 + (_e1114 * _e1772));
let _e1777 = (_e402 + (_e1115 * _e1772));
let _e1778 = (_e390 + (_e1116 * _e1772));
let _e1784 = ((((_e416.member.member * _e1776) + (_e416.member.member_1 * _e1777)) + (_e416.member.member_2 * _e1778)) + _e416.member_1);
let _e1790 = ((((_e432.member.member * _e1776) + (_e432.member.member_1 * _e1777)) + (_e432.member.member_2 * _e1778)) + _e432.member_1);
let _e1796 = ((((_e448.member.member * _e1776) + (_e448.member.member_1 * _e1777)) + (_e448.member.member_2 * _e1778)) + _e448.member_1);
let _e1798 = select(_e483, _e1784, (_e1784 > _e483));
let _e1800 = select(_e489, _e1798, (_e1798 < _e489));
let _e1802 = select(_e499, _e1790, (_e1790 > _e499));
let _e1804 = select(_e505, _e1802, (_e1802 < _e505));
let _e1806 = select(_e515, _e1796, (_e1796 > _e515));
let _e1808 = select(_e521, _e1806, (_e1806 < _e521));
if _e1164 {
phi_3345_ = vec3<f32>(_e1800, _e1804, _e1808);
} else {
let _e1810 = (_e1800 + 0.5f);
let _e1812 = select(0f, _e1810, (_e1810 > 0f));
let _e1814 = select(_e573, _e1812, (_e1812 < _e573));
let _e1821 = select(0i, select(select(i32(_e1814), i32(-2147483648), (_e1814 < -2147483600f)), 2147483647i, (_e1814 > 2147483500f)), (_e1814 == _e1814));
let _e1827 = (_e1804 + 0.5f);
let _e1829 = select(0f, _e1827, (_e1827 > 0f));
let _e1831 = select(_e604, _e1829, (_e1829 < _e604));
let _e1838 = select(0i, select(select(i32(_e1831), i32(-2147483648), (_e1831 < -2147483600f)), 2147483647i, (_e1831 > 2147483500f)), (_e1831 == _e1831));
let _e1844 = (_e1808 + 0.5f);
let _e1846 = select(0f, _e1844, (_e1844 > 0f));
let _e1848 = select(_e629, _e1846, (_e1846 < _e629));
let _e1855 = select(0i, select(select(i32(_e1848), i32(-2147483648), (_e1848 < -2147483600f)), 2147483647i, (_e1848 > 2147483500f)), (_e1848 == _e1848));
phi_3345_ = vec3<f32>(f32((_e1821 - select(0i, 1i, (_e1814 < f32(_e1821))))), f32((_e1838 - select(0i, 1i, (_e1831 < f32(_e1838))))), f32((_e1855 - select(0i, 1i, (_e1848 < f32(_e1855))))));
}
let _e1863 = phi_3345_;
let _e1866 = select(-1f, _e1863.x, (_e1863.x > -1f));
let _e1868 = select(_e571, _e1866, (_e1866 < _e571));
let _e1875 = select(0i, select(select(i32(_e1868), i32(-2147483648), (_e1868 < -2147483600f)), 2147483647i, (_e1868 > 2147483500f)), (_e1868 == _e1868));
let _e1879 = (_e1875 - select(0i, 1i, (_e1868 < f32(_e1875))));
let _e1882 = select(-1f, _e1863.y, (_e1863.y > -1f));
let _e1884 = select(_e602, _e1882, (_e1882 < _e602));
let _e1891 = select(0i, select(select(i32(_e1884), i32(-2147483648), (_e1884 < -2147483600f)), 2147483647i, (_e1884 > 2147483500f)), (_e1884 == _e1884));
let _e1895 = (_e1891 - select(0i, 1i, (_e1884 < f32(_e1891))));
let _e1898 = select(-1f, _e1863.z, (_e1863.z > -1f));
let _e1900 = select(_e627, _e1898, (_e1898 < _e627));
let _e1907 = select(0i, select(select(i32(_e1900), i32(-2147483648), (_e1900 < -2147483600f)), 2147483647i, (_e1900 > 2147483500f)), (_e1900 == _e1900));
let _e1911 = (_e1907 - select(0i, 1i, (_e1900 < f32(_e1907))));
let _e1914 = (_e1895 + 1i);
let _e1919 = (_e1911 + 1i);
let _e1922 = (_e1879 - 1i);
let _e1927 = (_e1879 + 1i);
let _e1930 = (_e1879 + 2i);
let _e1933 = (select(0i, _e1895, (_e1895 > 0i)) * _e1271);
let _e1934 = (select(_e1284, _e1914, (_e1914 < _e1284)) * _e1271);
let _e1935 = (select(0i, _e1911, (_e1911 > 0i)) * _e1276);
let _e1936 = (select(_e1297, _e1919, (_e1919 < _e1297)) * _e1276);
local_12 = type_29(array<i32, 4>(select(0i, _e1922, (_e1922 > 0i)), select(0i, _e1879, (_e1879 > 0i)), select(_e1310, _e1927, (_e1927 < _e1310)), select(_e1310, _e1930, (_e1930 < _e1310))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_13 = (_e1863 - vec3<f32>(f32(_e1879), f32(_e1895), f32(_e1911)));
let _e1945 = (_e1935 + _e1933);
let _e1948 = local_12.member[1u];
let _e1949 = (_e1945 + _e1948);
let _e1951 = select(_e1340, _e1949, (_e1949 < _e1340));
let _e1956 = global_1.member[bitcast<u32>(select(0i, _e1951, (_e1951 > 0i)))];
let _e1957 = bitcast<f32>(_e1956);
let _e1960 = local_12.member[2u];
let _e1961 = (_e1945 + _e1960);
let _e1963 = select(_e1340, _e1961, (_e1961 < _e1340));
let _e1968 = global_1.member[bitcast<u32>(select(0i, _e1963, (_e1963 > 0i)))];
let _e1970 = local_13[0u];
let _e1973 = (_e1957 + ((bitcast<f32>(_e1968) - _e1957) * _e1970));
let _e1974 = (_e1935 + _e1934);
let _e1975 = local_12.member[1u];
let _e1976 = (_e1974 + _e1975);
let _e1978 = select(_e1340, _e1976, (_e1976 < _e1340));
let _e1983 = global_1.member[bitcast<u32>(select(0i, _e1978, (_e1978 > 0i)))];
let _e1984 = bitcast<f32>(_e1983);
let _e1985 = local_12.member[2u];
let _e1986 = (_e1974 + _e1985);
let _e1988 = select(_e1340, _e1986, (_e1986 < _e1340));
let _e1993 = global_1.member[bitcast<u32>(select(0i, _e1988, (_e1988 > 0i)))];
let _e1995 = local_13[0u];
let _e2000 = local_13[1u];
let _e2003 = (_e1973 + (((_e1984 + ((bitcast<f32>(_e1993) - _e1984) * _e1995)) - _e1973) * _e2000));
let _e2004 = (_e1936 + _e1933);
let _e2005 = local_12.member[1u];
let _e2006 = (_e2004 + _e2005);
let _e2008 = select(_e1340, _e2006, (_e2006 < _e1340));
let _e2013 = global_1.member[bitcast<u32>(select(0i, _e2008, (_e2008 > 0i)))];
let _e2014 = bitcast<f32>(_e2013);
let _e2015 = local_12.member[2u];
let _e2016 = (_e2004 + _e2015);
let _e2018 = select(_e1340, _e2016, (_e2016 < _e1340));
let _e2023 = global_1.member[bitcast<u32>(select(0i, _e2018, (_e2018 > 0i)))];
let _e2025 = local_13[0u];
let _e2028 = (_e2014 + ((bitcast<f32>(_e2023) - _e2014) * _e2025));
let _e2029 = (_e1936 + _e1934);
let _e2030 = local_12.member[1u];
let _e2031 = (_e2029 + _e2030);
let _e2033 = select(_e1340, _e2031, (_e2031 < _e1340));
let _e2038 = global_1.member[bitcast<u32>(select(0i, _e2033, (_e2033 > 0i)))];
let _e2039 = bitcast<f32>(_e2038);
let _e2040 = local_12.member[2u];
let _e2041 = (_e2029 + _e2040);
let _e2043 = select(_e1340, _e2041, (_e2041 < _e1340));
let _e2048 = global_1.member[bitcast<u32>(select(0i, _e2043, (_e2043 > 0i)))];
let _e2050 = local_13[0u];
let _e2054 = local_13[1u];
let _e2059 = local_13[2u];
let _e2064 = (((_e2003 + (((_e2028 + (((_e2039 + ((bitcast<f32>(_e2048) - _e2039) * _e2050)) - _e2028) * _e2054)) - _e2003) * _e2059)) - _e1458) * _e1463);
let _e2066 = select(_e1466, _e2064, (_e2064 > _e1466));
let _e2071 = (_e1110.member + (_e1119 * (3.5f * 0.25f)));
let _e2075 = (_e400 + (_e1114 * _e2071));
let _e2076 = (_e402 + (_e1115 * _e2071));
let _e2077 = (_e390 + (_e1116 * _e2071));
let _e2083 = ((((_e416.member.member * _e2075) + (_e416.member.member_1 * _e2076)) + (_e416.member.member_2 * _e2077)) + _e416.member_1);
let _e2089 = ((((_e432.member.member * _e2075) + (_e432.member.member_1 * _e2076)) + (_e432.member.member_2 * _e2077)) + _e432.member_1);
let _e2095 = ((((_e448.member.member * _e2075) + (_e448.member.member_1 * _e2076)) + (_e448.member.member_2 * _e2077)) + _e448.member_1);
let _e2097 = select(_e483, _e2083, (_e2083 > _e483));
let _e2099 = select(_e489, _e2097, (_e2097 < _e489));
let _e2101 = select(_e499, _e2089, (_e2089 > _e499));
let _e2103 = select(_e505, _e2101, (_e2101 < _e505));
let _e2105 = select(_e515, _e2095, (_e2095 > _e515));
let _e2107 = select(_e521, _e2105, (_e2105 < _e521));
if _e1164 {
phi_3962_ = vec3<f32>(_e2099, _e2103, _e2107);
} else {
let _e2109 = (_e2099 + 0.5f);
let _e2111 = select(0f, _e2109, (_e2109 > 0f));
let _e2113 = select(_e573, _e2111, (_e2111 < _e573));
let _e2120 = select(0i, select(select(i32(_e2113), i32(-2147483648), (_e2113 < -2147483600f)), 2147483647i, (_e2113 > 2147483500f)), (_e2113 == _e2113));
let _e2126 = (_e2103 + 0.5f);
let _e2128 = select(0f, _e2126, (_e2126 > 0f));
let _e2130 = select(_e604, _e2128, (_e2128 < _e604));
let _e2137 = select(0i, select(select(i32(_e2130), i32(-2147483648), (_e2130 < -2147483600f)), 2147483647i, (_e2130 > 2147483500f)), (_e2130 == _e2130));
let _e2143 = (_e2107 + 0.5f);
let _e2145 = select(0f, _e2143, (_e2143 > 0f));
let _e2147 = select(_e629, _e2145, (_e2145 < _e629));
let _e2154 = select(0i, select(select(i32(_e2147), i32(-2147483648), (_e2147 < -2147483600f)), 2147483647i, (_e2147 > 2147483500f)), (_e2147 == _e2147));
phi_3962_ = vec3<f32>(f32((_e2120 - select(0i, 1i, (_e2113 < f32(_e2120))))), f32((_e2137 - select(0i, 1i, (_e2130 < f32(_e2137))))), f32((_e2154 - select(0i, 1i, (_e2147 < f32(_e2154))))));
}
let _e2162 = phi_3962_;
let _e2165 = select(-1f, _e2162.x, (_e2162.x > -1f));
let _e2167 = select(_e571, _e2165, (_e2165 < _e571));
let _e2174 = select(0i, select(select(i32(_e2167), i32(-2147483648), (_e2167 < -2147483600f)), 2147483647i, (_e2167 > 2147483500f)), (_e2167 == _e2167));
let _e2178 = (_e2174 - select(0i, 1i, (_e2167 < f32(_e2174))));
let _e2181 = select(-1f, _e2162.y, (_e2162.y > -1f));
let _e2183 = select(_e602, _e2181, (_e2181 < _e602));
let _e2190 = select(0i, select(select(i32(_e2183), i32(-2147483648), (_e2183 < -2147483600f)), 2147483647i, (_e2183 > 2147483500f)), (_e2183 == _e2183));
let _e2194 = (_e2190 - select(0i, 1i, (_e2183 < f32(_e2190))));
let _e2197 = select(-1f, _e2162.z, (_e2162.z > -1f));
let _e2199 = select(_e627, _e2197, (_e2197 < _e627));
let _e2206 = select(0i, select(select(i32(_e2199), i32(-2147483648), (_e2199 < -2147483600f)), 2147483647i, (_e2199 > 2147483500f)), (_e2199 == _e2199));
let _e2210 = (_e2206 - select(0i, 1i, (_e2199 < f32(_e2206))));
let _e2213 = (_e2194 + 1i);
let _e2218 = (_e2210 + 1i);
let _e2221 = (_e2178 - 1i);
let _e2226 = (_e2178 + 1i);
let _e2229 = (_e2178 + 2i);
let _e2232 = (select(0i, _e2194, (_e2194 > 0i)) * _e1271);
let _e2233 = (select(_e1284, _e2213, (_e2213 < _e1284)) * _e1271);
let _e2234 = (select(0i, _e2210, (_e2210 > 0i)) * _e1276);
let _e2235 = (select(_e1297, _e2218, (_e2218 < _e1297)) * _e1276);
local_10 = type_29(array<i32, 4>(select(0i, _e2221, (_e2221 > 0i)), select(0i, _e2178, (_e2178 > 0i)), select(_e1310, _e2226, (_e2226 < _e1310)), select(_e1310, _e2229, (_e2229 < _e1310))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_11 = (_e2162 - vec3<f32>(f32(_e2178), f32(_e2194), f32(_e2210)));
let _e2244 = (_e2234 + _e2232);
let _e2247 = local_10.member[1u];
let _e2248 = (_e2244 + _e2247);
let _e2250 = select(_e1340, _e2248, (_e2248 < _e1340));
let _e2255 = global_1.member[bitcast<u32>(select(0i, _e2250, (_e2250 > 0i)))];
let _e2256 = bitcast<f32>(_e2255);
let _e2259 = local_10.member[2u];
let _e2260 = (_e2244 + _e2259);
let _e2262 = select(_e1340, _e2260, (_e2260 < _e1340));
let _e2267 = global_1.member[bitcast<u32>(select(0i, _e2262, (_e2262 > 0i)))];
let _e2269 = local_11[0u];
let _e2272 = (_e2256 + ((bitcast<f32>(_e2267) - _e2256) * _e2269));
let _e2273 = (_e2234 + _e2233);
let _e2274 = local_10.member[1u];
let _e2275 = (_e2273 + _e2274);
let _e2277 = select(_e1340, _e2275, (_e2275 < _e1340));
let _e2282 = global_1.member[bitcast<u32>(select(0i, _e2277, (_e2277 > 0i)))];
let _e2283 = bitcast<f32>(_e2282);
let _e2284 = local_10.member[2u];
let _e2285 = (_e2273 + _e2284);
let _e2287 = select(_e1340, _e2285, (_e2285 < _e1340));
let _e2292 = global_1.member[bitcast<u32>(select(0i, _e2287, (_e2287 > 0i)))];
let _e2294 = local_11[0u];
let _e2299 = local_11[1u];
let _e2302 = (_e2272 + (((_e2283 + ((bitcast<f32>(_e2292) - _e2283) * _e2294)) - _e2272) * _e2299));
let _e2303 = (_e2235 + _e2232);
let _e2304 = local_10.member[1u];
let _e2305 = (_e2303 + _e2304);
let _e2307 = select(_e1340, _e2305, (_e2305 < _e1340));
let _e2312 = global_1.member[bitcast<u32>(select(0i, _e2307, (_e2307 > 0i)))];
let _e2313 = bitcast<f32>(_e2312);
let _e2314 = local_10.member[2u];
let _e2315 = (_e2303 + _e2314);
let _e2317 = select(_e1340, _e2315, (_e2315 < _e1340));
let _e2322 = global_1.member[bitcast<u32>(select(0i, _e2317, (_e2317 > 0i)))];
let _e2324 = local_11[0u];
let _e2327 = (_e2313 + ((bitcast<f32>(_e2322) - _e2313) * _e2324));
let _e2328 = (_e2235 + _e2233);
let _e2329 = local_10.member[1u];
let _e2330 = (_e2328 + _e2329);
let _e2332 = select(_e1340, _e2330, (_e2330 < _e1340));
let _e2337 = global_1.member[bitcast<u32>(select(0i, _e2332, (_e2332 > 0i)))];
let _e2338 = bitcast<f32>(_e2337);
let _e2339 = local_10.member[2u];
let _e2340 = (_e2328 + _e2339);
let _e2342 = select(_e1340, _e2340, (_e2340 < _e1340));
let _e2347 = global_1.member[bitcast<u32>(select(0i, _e2342, (_e2342 > 0i)))];
let _e2349 = local_11[0u];
let _e2353 = local_11[1u];
let _e2358 = local_11[2u];
let _e2363 = (((_e2302 + (((_e2327 + (((_e2338 + ((bitcast<f32>(_e2347) - _e2338) * _e2349)) - _e2327) * _e2353)) - _e2302) * _e2358)) - _e1458) * _e1463);
let _e2365 = select(_e1466, _e2363, (_e2363 > _e1466));
let _e2372 = (((_e1114 * _e1114) + (_e1115 * _e1115)) + (_e1116 * _e1116));
let _e2377 = select(0f, (sqrt(select(0f, _e2372, (_e2372 > 0f))) * _e1119), _e1113);
phi_7577_ = (_e370[8] + _e2377);
phi_7578_ = (_e370[6] + ((((select(1e9f, _e1468, (_e1468 < 1e9f)) + select(1e9f, _e1767, (_e1767 < 1e9f))) + (select(1e9f, _e2066, (_e2066 < 1e9f)) + select(1e9f, _e2365, (_e2365 < 1e9f)))) * 0.25f) * _e2377));
} else {
if _e684 {
phi_4407_ = -(2e9f);
} else {
phi_4407_ = 2e9f;
}
let _e2387 = phi_4407_;
let _e2388 = select(_e370[6], _e2387, _e683);
let _e2389 = (_e1110.member_1 - _e1110.member);
let _e2391 = (_e1110.member + (_e2389 * 0f));
let _e2395 = (_e400 + (_e1114 * _e2391));
let _e2396 = (_e402 + (_e1115 * _e2391));
let _e2397 = (_e390 + (_e1116 * _e2391));
let _e2403 = ((((_e416.member.member * _e2395) + (_e416.member.member_1 * _e2396)) + (_e416.member.member_2 * _e2397)) + _e416.member_1);
let _e2409 = ((((_e432.member.member * _e2395) + (_e432.member.member_1 * _e2396)) + (_e432.member.member_2 * _e2397)) + _e432.member_1);
let _e2415 = ((((_e448.member.member * _e2395) + (_e448.member.member_1 * _e2396)) + (_e448.member.member_2 * _e2397)) + _e448.member_1);
let _e2417 = select(_e483, _e2403, (_e2403 > _e483));
let _e2419 = select(_e489, _e2417, (_e2417 < _e489));
let _e2421 = select(_e499, _e2409, (_e2409 > _e499));
let _e2423 = select(_e505, _e2421, (_e2421 < _e505));
let _e2425 = select(_e515, _e2415, (_e2415 > _e515));
let _e2427 = select(_e521, _e2425, (_e2425 < _e521));
let _e2433 = global_2.member[_e366].member_8.member_15;
let _e2434 = (_e2433 == 0u);
if _e2434 {
phi_4615_ = vec3<f32>(_e2419, _e2423, _e2427);
} else {
let _e2435 = (_e2419 + 0.5f);
let _e2437 = select(0f, _e2435, (_e2435 > 0f));
let _e2439 = select(_e573, _e2437, (_e2437 < _e573));
let _e2446 = select(0i, select(select(i32(_e2439), i32(-2147483648), (_e2439 < -2147483600f)), 2147483647i, (_e2439 > 2147483500f)), (_e2439 == _e2439));
let _e2452 = (_e2423 + 0.5f);
let _e2454 = select(0f, _e2452, (_e2452 > 0f));
let _e2456 = select(_e604, _e2454, (_e2454 < _e604));
let _e2463 = select(0i, select(select(i32(_e2456), i32(-2147483648), (_e2456 < -2147483600f)), 2147483647i, (_e2456 > 2147483500f)), (_e2456 == _e2456));
let _e2469 = (_e2427 + 0.5f);
let _e2471 = select(0f, _e2469, (_e2469 > 0f));
let _e2473 = select(_e629, _e2471, (_e2471 < _e629));
let _e2480 = select(0i, select(select(i32(_e2473), i32(-2147483648), (_e2473 < -2147483600f)), 2147483647i, (_e2473 > 2147483500f)), (_e2473 == _e2473));
phi_4615_ = vec3<f32>(f32((_e2446 - select(0i, 1i, (_e2439 < f32(_e2446))))), f32((_e2463 - select(0i, 1i, (_e2456 < f32(_e2463))))), f32((_e2480 - select(0i, 1i, (_e2473 < f32(_e2480))))));
}
let _e2488 = phi_4615_;
let _e2491 = select(-1f, _e2488.x, (_e2488.x > -1f));
let _e2493 = select(_e571, _e2491, (_e2491 < _e571));
let _e2500 = select(0i, select(select(i32(_e2493), i32(-2147483648), (_e2493 < -2147483600f)), 2147483647i, (_e2493 > 2147483500f)), (_e2493 == _e2493));
let _e2504 = (_e2500 - select(0i, 1i, (_e2493 < f32(_e2500))));
let _e2507 = select(-1f, _e2488.y, (_e2488.y > -1f));
let _e2509 = select(_e602, _e2507, (_e2507 < _e602));
let _e2516 = select(0i, select(select(i32(_e2509), i32(-2147483648), (_e2509 < -2147483600f)), 2147483647i, (_e2509 > 2147483500f)), (_e2509 == _e2509));
let _e2520 = (_e2516 - select(0i, 1i, (_e2509 < f32(_e2516))));
let _e2523 = select(-1f, _e2488.z, (_e2488.z > -1f));
let _e2525 = select(_e627, _e2523, (_e2523 < _e627));
let _e2532 = select(0i, select(select(i32(_e2525), i32(-2147483648), (_e2525 < -2147483600f)), 2147483647i, (_e2525 > 2147483500f)), (_e2525 == _e2525));
let _e2536 = (_e2532 - select(0i, 1i, (_e2525 < f32(_e2532))));
let _e2541 = global_2.member[_e366].member_8.member_9;
let _e2546 = global_2.member[_e366].member_8.member_10;
let _e2554 = (select(0i, select(select(i32(_e602), i32(-2147483648), (_e602 < -2147483600f)), 2147483647i, (_e602 > 2147483500f)), (_e602 == _e602)) - 1i);
let _e2557 = (_e2520 + 1i);
let _e2567 = (select(0i, select(select(i32(_e627), i32(-2147483648), (_e627 < -2147483600f)), 2147483647i, (_e627 > 2147483500f)), (_e627 == _e627)) - 1i);
let _e2570 = (_e2536 + 1i);
let _e2580 = (select(0i, select(select(i32(_e571), i32(-2147483648), (_e571 < -2147483600f)), 2147483647i, (_e571 > 2147483500f)), (_e571 == _e571)) - 1i);
let _e2581 = (_e2504 - 1i);
let _e2586 = (_e2504 + 1i);
let _e2589 = (_e2504 + 2i);
let _e2592 = (select(0i, _e2520, (_e2520 > 0i)) * _e2541);
let _e2593 = (select(_e2554, _e2557, (_e2557 < _e2554)) * _e2541);
let _e2594 = (select(0i, _e2536, (_e2536 > 0i)) * _e2546);
let _e2595 = (select(_e2567, _e2570, (_e2570 < _e2567)) * _e2546);
local_8 = type_29(array<i32, 4>(select(0i, _e2581, (_e2581 > 0i)), select(0i, _e2504, (_e2504 > 0i)), select(_e2580, _e2586, (_e2586 < _e2580)), select(_e2580, _e2589, (_e2589 < _e2580))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_9 = (_e2488 - vec3<f32>(f32(_e2504), f32(_e2520), f32(_e2536)));
let _e2604 = (_e2594 + _e2592);
let _e2607 = local_8.member[1u];
let _e2608 = (_e2604 + _e2607);
let _e2610 = (bitcast<i32>(_e83) - 1i);
let _e2612 = select(_e2610, _e2608, (_e2608 < _e2610));
let _e2617 = global_1.member[bitcast<u32>(select(0i, _e2612, (_e2612 > 0i)))];
let _e2618 = bitcast<f32>(_e2617);
let _e2621 = local_8.member[2u];
let _e2622 = (_e2604 + _e2621);
let _e2624 = select(_e2610, _e2622, (_e2622 < _e2610));
let _e2629 = global_1.member[bitcast<u32>(select(0i, _e2624, (_e2624 > 0i)))];
let _e2631 = local_9[0u];
let _e2634 = (_e2618 + ((bitcast<f32>(_e2629) - _e2618) * _e2631));
let _e2635 = (_e2594 + _e2593);
let _e2636 = local_8.member[1u];
let _e2637 = (_e2635 + _e2636);
let _e2639 = select(_e2610, _e2637, (_e2637 < _e2610));
let _e2644 = global_1.member[bitcast<u32>(select(0i, _e2639, (_e2639 > 0i)))];
let _e2645 = bitcast<f32>(_e2644);
let _e2646 = local_8.member[2u];
let _e2647 = (_e2635 + _e2646);
let _e2649 = select(_e2610, _e2647, (_e2647 < _e2610));
let _e2654 = global_1.member[bitcast<u32>(select(0i, _e2649, (_e2649 > 0i)))];
let _e2656 = local_9[0u];
let _e2661 = local_9[1u];
let _e2664 = (_e2634 + (((_e2645 + ((bitcast<f32>(_e2654) - _e2645) * _e2656)) - _e2634) * _e2661));
let _e2665 = (_e2595 + _e2592);
let _e2666 = local_8.member[1u];
let _e2667 = (_e2665 + _e2666);
let _e2669 = select(_e2610, _e2667, (_e2667 < _e2610));
let _e2674 = global_1.member[bitcast<u32>(select(0i, _e2669, (_e2669 > 0i)))];
let _e2675 = bitcast<f32>(_e2674);
let _e2676 = local_8.member[2u];
let _e2677 = (_e2665 + _e2676);
let _e2679 = select(_e2610, _e2677, (_e2677 < _e2610));
let _e2684 = global_1.member[bitcast<u32>(select(0i, _e2679, (_e2679 > 0i)))];
let _e2686 = local_9[0u];
let _e2689 = (_e2675 + ((bitcast<f32>(_e2684) - _e2675) * _e2686));
let _e2690 = (_e2595 + _e2593);
let _e2691 = local_8.member[1u];
let _e2692 = (_e2690 + _e2691);
let _e2694 = select(_e2610, _e2692, (_e2692 < _e2610));
let _e2699 = global_1.member[bitcast<u32>(select(0i, _e2694, (_e2694 > 0i)))];
let _e2700 = bitcast<f32>(_e2699);
let _e2701 = local_8.member[2u];
let _e2702 = (_e2690 + _e2701);
let _e2704 = select(_e2610, _e2702, (_e2702 < _e2610));
let _e2709 = global_1.member[bitcast<u32>(select(0i, _e2704, (_e2704 > 0i)))];
let _e2711 = local_9[0u];
let _e2715 = local_9[1u];
let _e2720 = local_9[2u];
let _e2728 = global_2.member[_e366].member_8.member_8;
let _e2733 = global_2.member[_e366].member_8.member_7;
let _e2735 = (((_e2664 + (((_e2689 + (((_e2700 + ((bitcast<f32>(_e2709) - _e2700) * _e2711)) - _e2689) * _e2715)) - _e2664) * _e2720)) - _e2728) * _e2733);
let _e2736 = -(1e9f);
let _e2738 = select(_e2736, _e2735, (_e2735 > _e2736));
let _e2740 = select(1e9f, _e2738, (_e2738 < 1e9f));
if _e684 {
phi_5037_ = (_e2740 > _e2388);
} else {
phi_5037_ = (_e2740 < _e2388);
}
let _e2747 = phi_5037_;
let _e2748 = ((_e1113 && (_e683 || (_e1110.member > 0f))) && _e2747);
let _e2749 = select(_e2388, _e2740, _e2748);
let _e2752 = (_e1110.member + (_e2389 * 0.25f));
let _e2756 = (_e400 + (_e1114 * _e2752));
let _e2757 = (_e402 + (_e1115 * _e2752));
let _e2758 = (_e390 + (_e1116 * _e2752));
let _e2764 = ((((_e416.member.member * _e2756) + (_e416.member.member_1 * _e2757)) + (_e416.member.member_2 * _e2758)) + _e416.member_1);
let _e2770 = ((((_e432.member.member * _e2756) + (_e432.member.member_1 * _e2757)) + (_e432.member.member_2 * _e2758)) + _e432.member_1);
let _e2776 = ((((_e448.member.member * _e2756) + (_e448.member.member_1 * _e2757)) + (_e448.member.member_2 * _e2758)) + _e448.member_1);
let _e2778 = select(_e483, _e2764, (_e2764 > _e483));
let _e2780 = select(_e489, _e2778, (_e2778 < _e489));
let _e2782 = select(_e499, _e2770, (_e2770 > _e499));
let _e2784 = select(_e505, _e2782, (_e2782 < _e505));
let _e2786 = select(_e515, _e2776, (_e2776 > _e515));
let _e2788 = select(_e521, _e2786, (_e2786 < _e521));
if _e2434 {
phi_5250_ = vec3<f32>(_e2780, _e2784, _e2788);
} else {
let _e2790 = (_e2780 + 0.5f);
let _e2792 = select(0f, _e2790, (_e2790 > 0f));
let _e2794 = select(_e573, _e2792, (_e2792 < _e573));
let _e2801 = select(0i, select(select(i32(_e2794), i32(-2147483648), (_e2794 < -2147483600f)), 2147483647i, (_e2794 > 2147483500f)), (_e2794 == _e2794));
let _e2807 = (_e2784 + 0.5f);
let _e2809 = select(0f, _e2807, (_e2807 > 0f));
let _e2811 = select(_e604, _e2809, (_e2809 < _e604));
let _e2818 = select(0i, select(select(i32(_e2811), i32(-2147483648), (_e2811 < -2147483600f)), 2147483647i, (_e2811 > 2147483500f)), (_e2811 == _e2811));
let _e2824 = (_e2788 + 0.5f);
let _e2826 = select(0f, _e2824, (_e2824 > 0f));
let _e2828 = select(_e629, _e2826, (_e2826 < _e629));
let _e2835 = select(0i, select(select(i32(_e2828), i32(-2147483648), (_e2828 < -2147483600f)), 2147483647i, (_e2828 > 2147483500f)), (_e2828 == _e2828));
phi_5250_ = vec3<f32>(f32((_e2801 - select(0i, 1i, (_e2794 < f32(_e2801))))), f32((_e2818 - select(0i, 1i, (_e2811 < f32(_e2818))))), f32((_e2835 - select(0i, 1i, (_e2828 < f32(_e2835))))));
}
let _e2843 = phi_5250_;
let _e2846 = select(-1f, _e2843.x, (_e2843.x > -1f));
let _e2848 = select(_e571, _e2846, (_e2846 < _e571));
let _e2855 = select(0i, select(select(i32(_e2848), i32(-2147483648), (_e2848 < -2147483600f)), 2147483647i, (_e2848 > 2147483500f)), (_e2848 == _e2848));
let _e2859 = (_e2855 - select(0i, 1i, (_e2848 < f32(_e2855))));
let _e2862 = select(-1f, _e2843.y, (_e2843.y > -1f));
let _e2864 = select(_e602, _e2862, (_e2862 < _e602));
let _e2871 = select(0i, select(select(i32(_e2864), i32(-2147483648), (_e2864 < -2147483600f)), 2147483647i, (_e2864 > 2147483500f)), (_e2864 == _e2864));
let _e2875 = (_e2871 - select(0i, 1i, (_e2864 < f32(_e2871))));
let _e2878 = select(-1f, _e2843.z, (_e2843.z > -1f));
let _e2880 = select(_e627, _e2878, (_e2878 < _e627));
let _e2887 = select(0i, select(select(i32(_e2880), i32(-2147483648), (_e2880 < -2147483600f)), 2147483647i, (_e2880 > 2147483500f)), (_e2880 == _e2880));
let _e2891 = (_e2887 - select(0i, 1i, (_e2880 < f32(_e2887))));
let _e2894 = (_e2875 + 1i);
let _e2899 = (_e2891 + 1i);
let _e2902 = (_e2859 - 1i);
let _e2907 = (_e2859 + 1i);
let _e2910 = (_e2859 + 2i);
let _e2913 = (select(0i, _e2875, (_e2875 > 0i)) * _e2541);
let _e2914 = (select(_e2554, _e2894, (_e2894 < _e2554)) * _e2541);
let _e2915 = (select(0i, _e2891, (_e2891 > 0i)) * _e2546);
let _e2916 = (select(_e2567, _e2899, (_e2899 < _e2567)) * _e2546);
local_6 = type_29(array<i32, 4>(select(0i, _e2902, (_e2902 > 0i)), select(0i, _e2859, (_e2859 > 0i)), select(_e2580, _e2907, (_e2907 < _e2580)), select(_e2580, _e2910, (_e2910 < _e2580))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_7 = (_e2843 - vec3<f32>(f32(_e2859), f32(_e2875), f32(_e2891)));
let _e2925 = (_e2915 + _e2913);
let _e2928 = local_6.member[1u];
let _e2929 = (_e2925 + _e2928);
let _e2931 = select(_e2610, _e2929, (_e2929 < _e2610));
let _e2936 = global_1.member[bitcast<u32>(select(0i, _e2931, (_e2931 > 0i)))];
let _e2937 = bitcast<f32>(_e2936);
let _e2940 = local_6.member[2u];
let _e2941 = (_e2925 + _e2940);
let _e2943 = select(_e2610, _e2941, (_e2941 < _e2610));
let _e2948 = global_1.member[bitcast<u32>(select(0i, _e2943, (_e2943 > 0i)))];
let _e2950 = local_7[0u];
let _e2953 = (_e2937 + ((bitcast<f32>(_e2948) - _e2937) * _e2950));
let _e2954 = (_e2915 + _e2914);
let _e2955 = local_6.member[1u];
let _e2956 = (_e2954 + _e2955);
let _e2958 = select(_e2610, _e2956, (_e2956 < _e2610));
let _e2963 = global_1.member[bitcast<u32>(select(0i, _e2958, (_e2958 > 0i)))];
let _e2964 = bitcast<f32>(_e2963);
let _e2965 = local_6.member[2u];
let _e2966 = (_e2954 + _e2965);
let _e2968 = select(_e2610, _e2966, (_e2966 < _e2610));
let _e2973 = global_1.member[bitcast<u32>(select(0i, _e2968, (_e2968 > 0i)))];
let _e2975 = local_7[0u];
let _e2980 = local_7[1u];
let _e2983 = (_e2953 + (((_e2964 + ((bitcast<f32>(_e2973) - _e2964) * _e2975)) - _e2953) * _e2980));
let _e2984 = (_e2916 + _e2913);
let _e2985 = local_6.member[1u];
let _e2986 = (_e2984 + _e2985);
let _e2988 = select(_e2610, _e2986, (_e2986 < _e2610));
let _e2993 = global_1.member[bitcast<u32>(select(0i, _e2988, (_e2988 > 0i)))];
let _e2994 = bitcast<f32>(_e2993);
let _e2995 = local_6.member[2u];
let _e2996 = (_e2984 + _e2995);
let _e2998 = select(_e2610, _e2996, (_e2996 < _e2610));
let _e3003 = global_1.member[bitcast<u32>(select(0i, _e2998, (_e2998 > 0i)))];
let _e3005 = local_7[0u];
let _e3008 = (_e2994 + ((bitcast<f32>(_e3003) - _e2994) * _e3005));
let _e3009 = (_e2916 + _e2914);
let _e3010 = local_6.member[1u];
let _e3011 = (_e3009 + _e3010);
let _e3013 = select(_e2610, _e3011, (_e3011 < _e2610));
let _e3018 = global_1.member[bitcast<u32>(select(0i, _e3013, (_e3013 > 0i)))];
let _e3019 = bitcast<f32>(_e3018);
let _e3020 = local_6.member[2u];
let _e3021 = (_e3009 + _e3020);
let _e3023 = select(_e2610, _e3021, (_e3021 < _e2610));
let _e3028 = global_1.member[bitcast<u32>(select(0i, _e3023, (_e3023 > 0i)))];
let _e3030 = local_7[0u];
let _e3034 = local_7[1u];
let _e3039 = local_7[2u];
let _e3044 = (((_e2983 + (((_e3008 + (((_e3019 + ((bitcast<f32>(_e3028) - _e3019) * _e3030)) - _e3008) * _e3034)) - _e2983) * _e3039)) - _e2728) * _e2733);
let _e3046 = select(_e2736, _e3044, (_e3044 > _e2736));
let _e3048 = select(1e9f, _e3046, (_e3046 < 1e9f));
if _e684 {
phi_5669_ = (_e3048 > _e2749);
} else {
phi_5669_ = (_e3048 < _e2749);
}
let _e3052 = phi_5669_;
let _e3053 = (_e1113 && _e3052);
let _e3054 = select(_e2749, _e3048, _e3053);
let _e3058 = (_e1110.member + (_e2389 * (2f * 0.25f)));
let _e3062 = (_e400 + (_e1114 * _e3058));
let _e3063 = (_e402 + (_e1115 * _e3058));
let _e3064 = (_e390 + (_e1116 * _e3058));
let _e3070 = ((((_e416.member.member * _e3062) + (_e416.member.member_1 * _e3063)) + (_e416.member.member_2 * _e3064)) + _e416.member_1);
let _e3076 = ((((_e432.member.member * _e3062) + (_e432.member.member_1 * _e3063)) + (_e432.member.member_2 * _e3064)) + _e432.member_1);
let _e3082 = ((((_e448.member.member * _e3062) + (_e448.member.member_1 * _e3063)) + (_e448.member.member_2 * _e3064)) + _e448.member_1);
let _e3084 = select(_e483, _e3070, (_e3070 > _e483));
let _e3086 = select(_e489, _e3084, (_e3084 < _e489));
let _e3088 = select(_e499, _e3076, (_e3076 > _e499));
let _e3090 = select(_e505, _e3088, (_e3088 < _e505));
let _e3092 = select(_e515, _e3082, (_e3082 > _e515));
let _e3094 = select(_e521, _e3092, (_e3092 < _e521));
if _e2434 {
phi_5883_ = vec3<f32>(_e3086, _e3090, _e3094);
} else {
let _e3096 = (_e3086 + 0.5f);
let _e3098 = select(0f, _e3096, (_e3096 > 0f));
let _e3100 = select(_e573, _e3098, (_e3098 < _e573));
let _e3107 = select(0i, select(select(i32(_e3100), i32(-2147483648), (_e3100 < -2147483600f)), 2147483647i, (_e3100 > 2147483500f)), (_e3100 == _e3100));
let _e3113 = (_e3090 + 0.5f);
let _e3115 = select(0f, _e3113, (_e3113 > 0f));
let _e3117 = select(_e604, _e3115, (_e3115 < _e604));
let _e3124 = select(0i, select(select(i32(_e3117), i32(-2147483648), (_e3117 < -2147483600f)), 2147483647i, (_e3117 > 2147483500f)), (_e3117 == _e3117));
let _e3130 = (_e3094 + 0.5f);
let _e3132 = select(0f, _e3130, (_e3130 > 0f));
let _e3134 = select(_e629, _e3132, (_e3132 < _e629));
let _e3141 = select(0i, select(select(i32(_e3134), i32(-2147483648), (_e3134 < -2147483600f)), 2147483647i, (_e3134 > 2147483500f)), (_e3134 == _e3134));
phi_5883_ = vec3<f32>(f32((_e3107 - select(0i, 1i, (_e3100 < f32(_e3107))))), f32((_e3124 - select(0i, 1i, (_e3117 < f32(_e3124))))), f32((_e3141 - select(0i, 1i, (_e3134 < f32(_e3141))))));
}
let _e3149 = phi_5883_;
let _e3152 = select(-1f, _e3149.x, (_e3149.x > -1f));
let _e3154 = select(_e571, _e3152, (_e3152 < _e571));
let _e3161 = select(0i, select(select(i32(_e3154), i32(-2147483648), (_e3154 < -2147483600f)), 2147483647i, (_e3154 > 2147483500f)), (_e3154 == _e3154));
let _e3165 = (_e3161 - select(0i, 1i, (_e3154 < f32(_e3161))));
let _e3168 = select(-1f, _e3149.y, (_e3149.y > -1f));
let _e3170 = select(_e602, _e3168, (_e3168 < _e602));
let _e3177 = select(0i, select(select(i32(_e3170), i32(-2147483648), (_e3170 < -2147483600f)), 2147483647i, (_e3170 > 2147483500f)), (_e3170 == _e3170));
let _e3181 = (_e3177 - select(0i, 1i, (_e3170 < f32(_e3177))));
let _e3184 = select(-1f, _e3149.z, (_e3149.z > -1f));
let _e3186 = select(_e627, _e3184, (_e3184 < _e627));
let _e3193 = select(0i, select(select(i32(_e3186), i32(-2147483648), (_e3186 < -2147483600f)), 2147483647i, (_e3186 > 2147483500f)), (_e3186 == _e3186));
let _e3197 = (_e3193 - select(0i, 1i, (_e3186 < f32(_e3193))));
let _e3200 = (_e3181 + 1i);
let _e3205 = (_e3197 + 1i);
let _e3208 = (_e3165 - 1i);
let _e3213 = (_e3165 + 1i);
let _e3216 = (_e3165 + 2i);
let _e3219 = (select(0i, _e3181, (_e3181 > 0i)) * _e2541);
let _e3220 = (select(_e2554, _e3200, (_e3200 < _e2554)) * _e2541);
let _e3221 = (select(0i, _e3197, (_e3197 > 0i)) * _e2546);
let _e3222 = (select(_e2567, _e3205, (_e3205 < _e2567)) * _e2546);
local_4 = type_29(array<i32, 4>(select(0i, _e3208, (_e3208 > 0i)), select(0i, _e3165, (_e3165 > 0i)), select(_e2580, _e3213, (_e3213 < _e2580)), select(_e2580, _e3216, (_e3216 < _e2580))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_5 = (_e3149 - vec3<f32>(f32(_e3165), f32(_e3181), f32(_e3197)));
let _e3231 = (_e3221 + _e3219);
let _e3234 = local_4.member[1u];
let _e3235 = (_e3231 + _e3234);
let _e3237 = select(_e2610, _e3235, (_e3235 < _e2610));
let _e3242 = global_1.member[bitcast<u32>(select(0i, _e3237, (_e3237 > 0i)))];
let _e3243 = bitcast<f32>(_e3242);
let _e3246 = local_4.member[2u];
let _e3247 = (_e3231 + _e3246);
let _e3249 = select(_e2610, _e3247, (_e3247 < _e2610));
let _e3254 = global_1.member[bitcast<u32>(select(0i, _e3249, (_e3249 > 0i)))];
let _e3256 = local_5[0u];
let _e3259 = (_e3243 + ((bitcast<f32>(_e3254) - _e3243) * _e3256));
let _e3260 = (_e3221 + _e3220);
let _e3261 = local_4.member[1u];
let _e3262 = (_e3260 + _e3261);
let _e3264 = select(_e2610, _e3262, (_e3262 < _e2610));
let _e3269 = global_1.member[bitcast<u32>(select(0i, _e3264, (_e3264 > 0i)))];
let _e3270 = bitcast<f32>(_e3269);
let _e3271 = local_4.member[2u];
let _e3272 = (_e3260 + _e3271);
let _e3274 = select(_e2610, _e3272, (_e3272 < _e2610));
let _e3279 = global_1.member[bitcast<u32>(select(0i, _e3274, (_e3274 > 0i)))];
let _e3281 = local_5[0u];
let _e3286 = local_5[1u];
let _e3289 = (_e3259 + (((_e3270 + ((bitcast<f32>(_e3279) - _e3270) * _e3281)) - _e3259) * _e3286));
let _e3290 = (_e3222 + _e3219);
let _e3291 = local_4.member[1u];
let _e3292 = (_e3290 + _e3291);
let _e3294 = select(_e2610, _e3292, (_e3292 < _e2610));
let _e3299 = global_1.member[bitcast<u32>(select(0i, _e3294, (_e3294 > 0i)))];
let _e3300 = bitcast<f32>(_e3299);
let _e3301 = local_4.member[2u];
let _e3302 = (_e3290 + _e3301);
let _e3304 = select(_e2610, _e3302, (_e3302 < _e2610));
let _e3309 = global_1.member[bitcast<u32>(select(0i, _e3304, (_e3304 > 0i)))];
let _e3311 = local_5[0u];
let _e3314 = (_e3300 + ((bitcast<f32>(_e3309) - _e3300) * _e3311));
let _e3315 = (_e3222 + _e3220);
let _e3316 = local_4.member[1u];
let _e3317 = (_e3315 + _e3316);
let _e3319 = select(_e2610, _e3317, (_e3317 < _e2610));
let _e3324 = global_1.member[bitcast<u32>(select(0i, _e3319, (_e3319 > 0i)))];
let _e3325 = bitcast<f32>(_e3324);
let _e3326 = local_4.member[2u];
let _e3327 = (_e3315 + _e3326);
let _e3329 = select(_e2610, _e3327, (_e3327 < _e2610));
let _e3334 = global_1.member[bitcast<u32>(select(0i, _e3329, (_e3329 > 0i)))];
let _e3336 = local_5[0u];
let _e3340 = local_5[1u];
let _e3345 = local_5[2u];
let _e3350 = (((_e3289 + (((_e3314 + (((_e3325 + ((bitcast<f32>(_e3334) - _e3325) * _e3336)) - _e3314) * _e3340)) - _e3289) * _e3345)) - _e2728) * _e2733);
let _e3352 = select(_e2736, _e3350, (_e3350 > _e2736));
let _e3354 = select(1e9f, _e3352, (_e3352 < 1e9f));
if _e684 {
phi_6302_ = (_e3354 > _e3054);
} else {
phi_6302_ = (_e3354 < _e3054);
}
let _e3358 = phi_6302_;
let _e3359 = (_e1113 && _e3358);
let _e3360 = select(_e3054, _e3354, _e3359);
let _e3364 = (_e1110.member + (_e2389 * (3f * 0.25f)));
let _e3368 = (_e400 + (_e1114 * _e3364));
let _e3369 = (_e402 + (_e1115 * _e3364));
let _e3370 = (_e390 + (_e1116 * _e3364));
let _e3376 = ((((_e416.member.member * _e3368) + (_e416.member.member_1 * _e3369)) + (_e416.member.member_2 * _e3370)) + _e416.member_1);
let _e3382 = ((((_e432.member.member * _e3368) + (_e432.member.member_1 * _e3369)) + (_e432.member.member_2 * _e3370)) + _e432.member_1);
let _e3388 = ((((_e448.member.member * _e3368) + (_e448.member.member_1 * _e3369)) + (_e448.member.member_2 * _e3370)) + _e448.member_1);
let _e3390 = select(_e483, _e3376, (_e3376 > _e483));
let _e3392 = select(_e489, _e3390, (_e3390 < _e489));
let _e3394 = select(_e499, _e3382, (_e3382 > _e499));
let _e3396 = select(_e505, _e3394, (_e3394 < _e505));
let _e3398 = select(_e515, _e3388, (_e3388 > _e515));
let _e3400 = select(_e521, _e3398, (_e3398 < _e521));
if _e2434 {
phi_6516_ = vec3<f32>(_e3392, _e3396, _e3400);
} else {
let _e3402 = (_e3392 + 0.5f);
let _e3404 = select(0f, _e3402, (_e3402 > 0f));
let _e3406 = select(_e573, _e3404, (_e3404 < _e573));
let _e3413 = select(0i, select(select(i32(_e3406), i32(-2147483648), (_e3406 < -2147483600f)), 2147483647i, (_e3406 > 2147483500f)), (_e3406 == _e3406));
let _e3419 = (_e3396 + 0.5f);
let _e3421 = select(0f, _e3419, (_e3419 > 0f));
let _e3423 = select(_e604, _e3421, (_e3421 < _e604));
let _e3430 = select(0i, select(select(i32(_e3423), i32(-2147483648), (_e3423 < -2147483600f)), 2147483647i, (_e3423 > 2147483500f)), (_e3423 == _e3423));
let _e3436 = (_e3400 + 0.5f);
let _e3438 = select(0f, _e3436, (_e3436 > 0f));
let _e3440 = select(_e629, _e3438, (_e3438 < _e629));
let _e3447 = select(0i, select(select(i32(_e3440), i32(-2147483648), (_e3440 < -2147483600f)), 2147483647i, (_e3440 > 2147483500f)), (_e3440 == _e3440));
phi_6516_ = vec3<f32>(f32((_e3413 - select(0i, 1i, (_e3406 < f32(_e3413))))), f32((_e3430 - select(0i, 1i, (_e3423 < f32(_e3430))))), f32((_e3447 - select(0i, 1i, (_e3440 < f32(_e3447))))));
}
let _e3455 = phi_6516_;
let _e3458 = select(-1f, _e3455.x, (_e3455.x > -1f));
let _e3460 = select(_e571, _e3458, (_e3458 < _e571));
let _e3467 = select(0i, select(select(i32(_e3460), i32(-2147483648), (_e3460 < -2147483600f)), 2147483647i, (_e3460 > 2147483500f)), (_e3460 == _e3460));
let _e3471 = (_e3467 - select(0i, 1i, (_e3460 < f32(_e3467))));
let _e3474 = select(-1f, _e3455.y, (_e3455.y > -1f));
let _e3476 = select(_e602, _e3474, (_e3474 < _e602));
let _e3483 = select(0i, select(select(i32(_e3476), i32(-2147483648), (_e3476 < -2147483600f)), 2147483647i, (_e3476 > 2147483500f)), (_e3476 == _e3476));
let _e3487 = (_e3483 - select(0i, 1i, (_e3476 < f32(_e3483))));
let _e3490 = select(-1f, _e3455.z, (_e3455.z > -1f));
let _e3492 = select(_e627, _e3490, (_e3490 < _e627));
let _e3499 = select(0i, select(select(i32(_e3492), i32(-2147483648), (_e3492 < -2147483600f)), 2147483647i, (_e3492 > 2147483500f)), (_e3492 == _e3492));
let _e3503 = (_e3499 - select(0i, 1i, (_e3492 < f32(_e3499))));
let _e3506 = (_e3487 + 1i);
let _e3511 = (_e3503 + 1i);
let _e3514 = (_e3471 - 1i);
let _e3519 = (_e3471 + 1i);
let _e3522 = (_e3471 + 2i);
let _e3525 = (select(0i, _e3487, (_e3487 > 0i)) * _e2541);
let _e3526 = (select(_e2554, _e3506, (_e3506 < _e2554)) * _e2541);
let _e3527 = (select(0i, _e3503, (_e3503 > 0i)) * _e2546);
let _e3528 = (select(_e2567, _e3511, (_e3511 < _e2567)) * _e2546);
local_2 = type_29(array<i32, 4>(select(0i, _e3514, (_e3514 > 0i)), select(0i, _e3471, (_e3471 > 0i)), select(_e2580, _e3519, (_e3519 < _e2580)), select(_e2580, _e3522, (_e3522 < _e2580))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_3 = (_e3455 - vec3<f32>(f32(_e3471), f32(_e3487), f32(_e3503)));
let _e3537 = (_e3527 + _e3525);
let _e3540 = local_2.member[1u];
let _e3541 = (_e3537 + _e3540);
let _e3543 = select(_e2610, _e3541, (_e3541 < _e2610));
let _e3548 = global_1.member[bitcast<u32>(select(0i, _e3543, (_e3543 > 0i)))];
let _e3549 = bitcast<f32>(_e3548);
let _e3552 = local_2.member[2u];
let _e3553 = (_e3537 + _e3552);
let _e3555 = select(_e2610, _e3553, (_e3553 < _e2610));
let _e3560 = global_1.member[bitcast<u32>(select(0i, _e3555, (_e3555 > 0i)))];
let _e3562 = local_3[0u];
let _e3565 = (_e3549 + ((bitcast<f32>(_e3560) - _e3549) * _e3562));
let _e3566 = (_e3527 + _e3526);
let _e3567 = local_2.member[1u];
let _e3568 = (_e3566 + _e3567);
let _e3570 = select(_e2610, _e3568, (_e3568 < _e2610));
let _e3575 = global_1.member[bitcast<u32>(select(0i, _e3570, (_e3570 > 0i)))];
let _e3576 = bitcast<f32>(_e3575);
let _e3577 = local_2.member[2u];
let _e3578 = (_e3566 + _e3577);
let _e3580 = select(_e2610, _e3578, (_e3578 < _e2610));
let _e3585 = global_1.member[bitcast<u32>(select(0i, _e3580, (_e3580 > 0i)))];
let _e3587 = local_3[0u];
let _e3592 = local_3[1u];
let _e3595 = (_e3565 + (((_e3576 + ((bitcast<f32>(_e3585) - _e3576) * _e3587)) - _e3565) * _e3592));
let _e3596 = (_e3528 + _e3525);
let _e3597 = local_2.member[1u];
let _e3598 = (_e3596 + _e3597);
let _e3600 = select(_e2610, _e3598, (_e3598 < _e2610));
let _e3605 = global_1.member[bitcast<u32>(select(0i, _e3600, (_e3600 > 0i)))];
let _e3606 = bitcast<f32>(_e3605);
let _e3607 = local_2.member[2u];
let _e3608 = (_e3596 + _e3607);
let _e3610 = select(_e2610, _e3608, (_e3608 < _e2610));
let _e3615 = global_1.member[bitcast<u32>(select(0i, _e3610, (_e3610 > 0i)))];
let _e3617 = local_3[0u];
let _e3620 = (_e3606 + ((bitcast<f32>(_e3615) - _e3606) * _e3617));
let _e3621 = (_e3528 + _e3526);
let _e3622 = local_2.member[1u];
let _e3623 = (_e3621 + _e3622);
let _e3625 = select(_e2610, _e3623, (_e3623 < _e2610));
let _e3630 = global_1.member[bitcast<u32>(select(0i, _e3625, (_e3625 > 0i)))];
let _e3631 = bitcast<f32>(_e3630);
let _e3632 = local_2.member[2u];
let _e3633 = (_e3621 + _e3632);
let _e3635 = select(_e2610, _e3633, (_e3633 < _e2610));
let _e3640 = global_1.member[bitcast<u32>(select(0i, _e3635, (_e3635 > 0i)))];
let _e3642 = local_3[0u];
let _e3646 = local_3[1u];
let _e3651 = local_3[2u];
let _e3656 = (((_e3595 + (((_e3620 + (((_e3631 + ((bitcast<f32>(_e3640) - _e3631) * _e3642)) - _e3620) * _e3646)) - _e3595) * _e3651)) - _e2728) * _e2733);
let _e3658 = select(_e2736, _e3656, (_e3656 > _e2736));
let _e3660 = select(1e9f, _e3658, (_e3658 < 1e9f));
if _e684 {
phi_6935_ = (_e3660 > _e3360);
} else {
phi_6935_ = (_e3660 < _e3360);
}
let _e3664 = phi_6935_;
let _e3665 = (_e1113 && _e3664);
let _e3666 = select(_e3360, _e3660, _e3665);
let _e3669 = (_e1110.member + (_e2389 * 1f));
let _e3673 = (_e400 + (_e1114 * _e3669));
let _e3674 = (_e402 + (_e1115 * _e3669));
let _e3675 = (_e390 + (_e1116 * _e3669));
let _e3681 = ((((_e416.member.member * _e3673) + (_e416.member.member_1 * _e3674)) + (_e416.member.member_2 * _e3675)) + _e416.member_1);
let _e3687 = ((((_e432.member.member * _e3673) + (_e432.member.member_1 * _e3674)) + (_e432.member.member_2 * _e3675)) + _e432.member_1);
let _e3693 = ((((_e448.member.member * _e3673) + (_e448.member.member_1 * _e3674)) + (_e448.member.member_2 * _e3675)) + _e448.member_1);
let _e3695 = select(_e483, _e3681, (_e3681 > _e483));
let _e3697 = select(_e489, _e3695, (_e3695 < _e489));
let _e3699 = select(_e499, _e3687, (_e3687 > _e499));
let _e3701 = select(_e505, _e3699, (_e3699 < _e505));
let _e3703 = select(_e515, _e3693, (_e3693 > _e515));
let _e3705 = select(_e521, _e3703, (_e3703 < _e521));
if _e2434 {
phi_7148_ = vec3<f32>(_e3697, _e3701, _e3705);
} else {
let _e3707 = (_e3697 + 0.5f);
let _e3709 = select(0f, _e3707, (_e3707 > 0f));
let _e3711 = select(_e573, _e3709, (_e3709 < _e573));
let _e3718 = select(0i, select(select(i32(_e3711), i32(-2147483648), (_e3711 < -2147483600f)), 2147483647i, (_e3711 > 2147483500f)), (_e3711 == _e3711));
let _e3724 = (_e3701 + 0.5f);
let _e3726 = select(0f, _e3724, (_e3724 > 0f));
let _e3728 = select(_e604, _e3726, (_e3726 < _e604));
let _e3735 = select(0i, select(select(i32(_e3728), i32(-2147483648), (_e3728 < -2147483600f)), 2147483647i, (_e3728 > 2147483500f)), (_e3728 == _e3728));
let _e3741 = (_e3705 + 0.5f);
let _e3743 = select(0f, _e3741, (_e3741 > 0f));
let _e3745 = select(_e629, _e3743, (_e3743 < _e629));
let _e3752 = select(0i, select(select(i32(_e3745), i32(-2147483648), (_e3745 < -2147483600f)), 2147483647i, (_e3745 > 2147483500f)), (_e3745 == _e3745));
phi_7148_ = vec3<f32>(f32((_e3718 - select(0i, 1i, (_e3711 < f32(_e3718))))), f32((_e3735 - select(0i, 1i, (_e3728 < f32(_e3735))))), f32((_e3752 - select(0i, 1i, (_e3745 < f32(_e3752))))));
}
let _e3760 = phi_7148_;
let _e3763 = select(-1f, _e3760.x, (_e3760.x > -1f));
let _e3765 = select(_e571, _e3763, (_e3763 < _e571));
let _e3772 = select(0i, select(select(i32(_e3765), i32(-2147483648), (_e3765 < -2147483600f)), 2147483647i, (_e3765 > 2147483500f)), (_e3765 == _e3765));
let _e3776 = (_e3772 - select(0i, 1i, (_e3765 < f32(_e3772))));
let _e3779 = select(-1f, _e3760.y, (_e3760.y > -1f));
let _e3781 = select(_e602, _e3779, (_e3779 < _e602));
let _e3788 = select(0i, select(select(i32(_e3781), i32(-2147483648), (_e3781 < -2147483600f)), 2147483647i, (_e3781 > 2147483500f)), (_e3781 == _e3781));
let _e3792 = (_e3788 - select(0i, 1i, (_e3781 < f32(_e3788))));
let _e3795 = select(-1f, _e3760.z, (_e3760.z > -1f));
let _e3797 = select(_e627, _e3795, (_e3795 < _e627));
let _e3804 = select(0i, select(select(i32(_e3797), i32(-2147483648), (_e3797 < -2147483600f)), 2147483647i, (_e3797 > 2147483500f)), (_e3797 == _e3797));
let _e3808 = (_e3804 - select(0i, 1i, (_e3797 < f32(_e3804))));
let _e3811 = (_e3792 + 1i);
let _e3816 = (_e3808 + 1i);
let _e3819 = (_e3776 - 1i);
let _e3824 = (_e3776 + 1i);
let _e3827 = (_e3776 + 2i);
let _e3830 = (select(0i, _e3792, (_e3792 > 0i)) * _e2541);
let _e3831 = (select(_e2554, _e3811, (_e3811 < _e2554)) * _e2541);
let _e3832 = (select(0i, _e3808, (_e3808 > 0i)) * _e2546);
let _e3833 = (select(_e2567, _e3816, (_e3816 < _e2567)) * _e2546);
local = type_29(array<i32, 4>(select(0i, _e3819, (_e3819 > 0i)), select(0i, _e3776, (_e3776 > 0i)), select(_e2580, _e3824, (_e3824 < _e2580)), select(_e2580, _e3827, (_e3827 < _e2580))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_1 = (_e3760 - vec3<f32>(f32(_e3776), f32(_e3792), f32(_e3808)));
let _e3842 = (_e3832 + _e3830);
let _e3845 = local.member[1u];
let _e3846 = (_e3842 + _e3845);
let _e3848 = select(_e2610, _e3846, (_e3846 < _e2610));
let _e3853 = global_1.member[bitcast<u32>(select(0i, _e3848, (_e3848 > 0i)))];
let _e3854 = bitcast<f32>(_e3853);
let _e3857 = local.member[2u];
let _e3858 = (_e3842 + _e3857);
let _e3860 = select(_e2610, _e3858, (_e3858 < _e2610));
let _e3865 = global_1.member[bitcast<u32>(select(0i, _e3860, (_e3860 > 0i)))];
let _e3867 = local_1[0u];
let _e3870 = (_e3854 + ((bitcast<f32>(_e3865) - _e3854) * _e3867));
let _e3871 = (_e3832 + _e3831);
let _e3872 = local.member[1u];
let _e3873 = (_e3871 + _e3872);
let _e3875 = select(_e2610, _e3873, (_e3873 < _e2610));
let _e3880 = global_1.member[bitcast<u32>(select(0i, _e3875, (_e3875 > 0i)))];
let _e3881 = bitcast<f32>(_e3880);
let _e3882 = local.member[2u];
let _e3883 = (_e3871 + _e3882);
let _e3885 = select(_e2610, _e3883, (_e3883 < _e2610));
let _e3890 = global_1.member[bitcast<u32>(select(0i, _e3885, (_e3885 > 0i)))];
let _e3892 = local_1[0u];
let _e3897 = local_1[1u];
let _e3900 = (_e3870 + (((_e3881 + ((bitcast<f32>(_e3890) - _e3881) * _e3892)) - _e3870) * _e3897));
let _e3901 = (_e3833 + _e3830);
let _e3902 = local.member[1u];
let _e3903 = (_e3901 + _e3902);
let _e3905 = select(_e2610, _e3903, (_e3903 < _e2610));
let _e3910 = global_1.member[bitcast<u32>(select(0i, _e3905, (_e3905 > 0i)))];
let _e3911 = bitcast<f32>(_e3910);
let _e3912 = local.member[2u];
let _e3913 = (_e3901 + _e3912);
let _e3915 = select(_e2610, _e3913, (_e3913 < _e2610));
let _e3920 = global_1.member[bitcast<u32>(select(0i, _e3915, (_e3915 > 0i)))];
let _e3922 = local_1[0u];
let _e3925 = (_e3911 + ((bitcast<f32>(_e3920) - _e3911) * _e3922));
let _e3926 = (_e3833 + _e3831);
let _e3927 = local.member[1u];
let _e3928 = (_e3926 + _e3927);
let _e3930 = select(_e2610, _e3928, (_e3928 < _e2610));
let _e3935 = global_1.member[bitcast<u32>(select(0i, _e3930, (_e3930 > 0i)))];
let _e3936 = bitcast<f32>(_e3935);
let _e3937 = local.member[2u];
let _e3938 = (_e3926 + _e3937);
let _e3940 = select(_e2610, _e3938, (_e3938 < _e2610));
let _e3945 = global_1.member[bitcast<u32>(select(0i, _e3940, (_e3940 > 0i)))];
let _e3947 = local_1[0u];
let _e3951 = local_1[1u];
let _e3956 = local_1[2u];
let _e3961 = (((_e3900 + (((_e3925 + (((_e3936 + ((bitcast<f32>(_e3945) - _e3936) * _e3947)) - _e3925) * _e3951)) - _e3900) * _e3956)) - _e2728) * _e2733);
let _e3963 = select(_e2736, _e3961, (_e3961 > _e2736));
let _e3965 = select(1e9f, _e3963, (_e3963 < 1e9f));
if _e684 {
phi_7567_ = (_e3965 > _e3666);
} else {
phi_7567_ = (_e3965 < _e3666);
}
let _e3969 = phi_7567_;
let _e3970 = (_e1113 && _e3969);
phi_7577_ = select(select(select(select(select(_e370[8], _e2397, _e2748), _e2758, _e3053), _e3064, _e3359), _e3370, _e3665), _e3675, _e3970);
phi_7578_ = select(_e3666, _e3965, _e3970);
}
let _e3974 = phi_7577_;
let _e3976 = phi_7578_;
phi_7596_ = array<f32, 23>(_e370[0], _e370[1], _e370[2], _e370[3], _e370[4], _e370[5], select(_e370[6], _e3976, _e1113), _e370[7], select(_e370[8], _e3974, _e1113), _e370[9], _e370[10], _e370[11], _e370[12], _e370[13], _e370[14], _e370[15], _e370[16], select(_e370[17], _e411, _e1113), _e370[18], _e370[19], _e370[20], _e370[21], _e370[22]);
} else {
phi_7596_ = _e370;
}
let _e3982 = phi_7596_;
phi_626_ = (_e366 + 1u);
phi_629_ = select(_e368, true, _e742);
phi_631_ = _e3982;
} else {
phi_626_ = u32();
phi_629_ = bool();
phi_631_ = array<f32, 23>();
}
let _e3986 = phi_626_;
let _e3988 = phi_629_;
let _e3990 = phi_631_;
continue;
continuing {
phi_625_ = _e3986;
phi_628_ = _e3988;
phi_630_ = _e3990;
phi_7699_ = false;
break if !(_e371);
}
}
let _e3993 = phi_7699_;
if _e3993 {
break;
}
let _e3995 = local_18;
if _e3995 {
let _e3997 = local_19;
global_4.member[_e111] = _e3997[0];
let _e4002 = local_20;
global_4.member[_e123] = _e4002[1];
let _e4007 = local_21;
global_4.member[_e134] = _e4007[2];
let _e4012 = local_22;
global_4.member[_e145] = _e4012[3];
let _e4017 = local_23;
global_4.member[_e156] = _e4017[4];
let _e4022 = local_24;
global_4.member[_e167] = _e4022[5];
let _e4027 = local_25;
global_4.member[_e178] = _e4027[6];
let _e4032 = local_26;
global_4.member[_e189] = _e4032[7];
let _e4037 = local_27;
global_4.member[_e200] = _e4037[8];
let _e4042 = local_28;
global_4.member[_e211] = _e4042[9];
let _e4047 = local_29;
global_4.member[_e222] = _e4047[10];
let _e4052 = local_30;
global_4.member[_e233] = _e4052[11];
let _e4057 = local_31;
global_4.member[_e244] = _e4057[12];
let _e4062 = local_32;
global_4.member[_e255] = _e4062[13];
let _e4067 = local_33;
global_4.member[_e266] = _e4067[14];
let _e4072 = local_34;
global_4.member[_e277] = _e4072[15];
let _e4077 = local_35;
global_4.member[_e288] = _e4077[16];
let _e4082 = local_36;
global_4.member[_e299] = _e4082[17];
let _e4087 = local_37;
global_4.member[_e310] = _e4087[18];
let _e4092 = local_38;
global_4.member[_e321] = _e4092[19];
let _e4097 = local_39;
global_4.member[_e332] = _e4097[20];
let _e4102 = local_40;
global_4.member[_e343] = _e4102[21];
let _e4107 = local_41;
global_4.member[_e354] = _e4107[22];
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
