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
var phi_579_: u32;
var phi_582_: bool;
var phi_584_: array<f32, 18>;
var phi_3469_: type_29;
var phi_4115_: type_30;
var phi_4701_: f32;
var phi_5090_: type_5;
var phi_6648_: type_31;
var phi_7401_: vec3<f32>;
var phi_7631_: type_25;
var phi_7949_: vec3<f32>;
var phi_8258_: f32;
var phi_8259_: f32;
var phi_8260_: f32;
var phi_8261_: bool;
var phi_8321_: array<f32, 18>;
var phi_580_: u32;
var phi_583_: bool;
var phi_585_: array<f32, 18>;
var phi_8404_: bool;
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
let _e113 = global;
let _e115 = arrayLength((&global_5.member));
let _e118 = arrayLength((&global_1.member));
let _e122 = arrayLength((&global_3.member));
if (0u < _e115) {
} else {
break;
}
let _e132 = global_5.member[0u].member_2;
let _e136 = global_5.member[0u].member;
let _e144 = (_e113.x + _e132.member);
let _e146 = (_e113.y + _e132.member_1);
if (_e144 < _e132.member_2) {
if (_e146 < _e132.member_3) {
let _e149 = (_e136.member * _e136.member_1);
let _e151 = ((_e146 * _e136.member) + _e144);
let _e152 = bitcast<i32>(_e151);
let _e154 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e156 = select(_e154, _e152, (_e152 < _e154));
let _e162 = global_4.member[bitcast<u32>(select(0i, _e156, (_e156 > 0i)))];
let _e163 = (_e149 + _e151);
let _e164 = bitcast<i32>(_e163);
let _e166 = select(_e154, _e164, (_e164 < _e154));
let _e172 = global_4.member[bitcast<u32>(select(0i, _e166, (_e166 > 0i)))];
let _e174 = ((2u * _e149) + _e151);
let _e175 = bitcast<i32>(_e174);
let _e177 = select(_e154, _e175, (_e175 < _e154));
let _e183 = global_4.member[bitcast<u32>(select(0i, _e177, (_e177 > 0i)))];
let _e185 = ((3u * _e149) + _e151);
let _e186 = bitcast<i32>(_e185);
let _e188 = select(_e154, _e186, (_e186 < _e154));
let _e194 = global_4.member[bitcast<u32>(select(0i, _e188, (_e188 > 0i)))];
let _e196 = ((4u * _e149) + _e151);
let _e197 = bitcast<i32>(_e196);
let _e199 = select(_e154, _e197, (_e197 < _e154));
let _e205 = global_4.member[bitcast<u32>(select(0i, _e199, (_e199 > 0i)))];
let _e207 = ((5u * _e149) + _e151);
let _e208 = bitcast<i32>(_e207);
let _e210 = select(_e154, _e208, (_e208 < _e154));
let _e216 = global_4.member[bitcast<u32>(select(0i, _e210, (_e210 > 0i)))];
let _e218 = ((6u * _e149) + _e151);
let _e219 = bitcast<i32>(_e218);
let _e221 = select(_e154, _e219, (_e219 < _e154));
let _e227 = global_4.member[bitcast<u32>(select(0i, _e221, (_e221 > 0i)))];
let _e229 = ((7u * _e149) + _e151);
let _e230 = bitcast<i32>(_e229);
let _e232 = select(_e154, _e230, (_e230 < _e154));
let _e238 = global_4.member[bitcast<u32>(select(0i, _e232, (_e232 > 0i)))];
let _e240 = ((8u * _e149) + _e151);
let _e241 = bitcast<i32>(_e240);
let _e243 = select(_e154, _e241, (_e241 < _e154));
let _e249 = global_4.member[bitcast<u32>(select(0i, _e243, (_e243 > 0i)))];
let _e251 = ((9u * _e149) + _e151);
let _e252 = bitcast<i32>(_e251);
let _e254 = select(_e154, _e252, (_e252 < _e154));
let _e260 = global_4.member[bitcast<u32>(select(0i, _e254, (_e254 > 0i)))];
let _e262 = ((10u * _e149) + _e151);
let _e263 = bitcast<i32>(_e262);
let _e265 = select(_e154, _e263, (_e263 < _e154));
let _e271 = global_4.member[bitcast<u32>(select(0i, _e265, (_e265 > 0i)))];
let _e273 = ((11u * _e149) + _e151);
let _e274 = bitcast<i32>(_e273);
let _e276 = select(_e154, _e274, (_e274 < _e154));
let _e282 = global_4.member[bitcast<u32>(select(0i, _e276, (_e276 > 0i)))];
let _e284 = ((12u * _e149) + _e151);
let _e285 = bitcast<i32>(_e284);
let _e287 = select(_e154, _e285, (_e285 < _e154));
let _e293 = global_4.member[bitcast<u32>(select(0i, _e287, (_e287 > 0i)))];
let _e295 = ((13u * _e149) + _e151);
let _e296 = bitcast<i32>(_e295);
let _e298 = select(_e154, _e296, (_e296 < _e154));
let _e304 = global_4.member[bitcast<u32>(select(0i, _e298, (_e298 > 0i)))];
let _e306 = ((14u * _e149) + _e151);
let _e307 = bitcast<i32>(_e306);
let _e309 = select(_e154, _e307, (_e307 < _e154));
let _e315 = global_4.member[bitcast<u32>(select(0i, _e309, (_e309 > 0i)))];
let _e317 = ((15u * _e149) + _e151);
let _e318 = bitcast<i32>(_e317);
let _e320 = select(_e154, _e318, (_e318 < _e154));
let _e326 = global_4.member[bitcast<u32>(select(0i, _e320, (_e320 > 0i)))];
let _e328 = ((16u * _e149) + _e151);
let _e329 = bitcast<i32>(_e328);
let _e331 = select(_e154, _e329, (_e329 < _e154));
let _e337 = global_4.member[bitcast<u32>(select(0i, _e331, (_e331 > 0i)))];
let _e339 = ((17u * _e149) + _e151);
let _e340 = bitcast<i32>(_e339);
let _e342 = select(_e154, _e340, (_e340 < _e154));
let _e348 = global_4.member[bitcast<u32>(select(0i, _e342, (_e342 > 0i)))];
phi_579_ = 0u;
phi_582_ = false;
phi_584_ = array<f32, 18>(_e162, _e172, _e183, _e194, _e205, _e216, _e227, _e238, _e249, _e260, _e271, _e282, _e293, _e304, _e315, _e326, _e337, _e348);
loop {
let _e351 = phi_579_;
let _e353 = phi_582_;
let _e355 = phi_584_;
local_8 = _e353;
local_9 = _e355;
local_10 = _e355;
local_11 = _e355;
local_12 = _e355;
local_13 = _e355;
local_14 = _e355;
local_15 = _e355;
local_16 = _e355;
local_17 = _e355;
local_18 = _e355;
local_19 = _e355;
local_20 = _e355;
local_21 = _e355;
local_22 = _e355;
local_23 = _e355;
local_24 = _e355;
local_25 = _e355;
local_26 = _e355;
let _e356 = (_e351 < _e115);
if _e356 {
if _e356 {
} else {
phi_8404_ = true;
break;
}
let _e364 = global_5.member[_e351].member_5.member_2;
let _e365 = (_e364 / _e355[4]);
let _e370 = global_5.member[_e351].member_5.member;
let _e373 = ((_e370 - _e355[16]) / _e355[4]);
let _e376 = (_e355[0] + (_e355[2] * _e373));
let _e379 = (_e355[1] + (_e355[3] * _e373));
let _e381 = (_e376 + (_e355[2] * _e365));
let _e383 = (_e379 + (_e355[3] * _e365));
let _e388 = global_5.member[_e351].member_5.member_1;
let _e394 = global_5.member[_e351].member_13.member.member;
let _e405 = ((((_e394.member.member * _e376) + (_e394.member.member_1 * _e379)) + (_e394.member.member_2 * _e370)) + _e394.member_1);
let _e411 = ((((_e394.member.member * _e381) + (_e394.member.member_1 * _e383)) + (_e394.member.member_2 * _e388)) + _e394.member_1);
let _e414 = ((_e405 > 0f) && (_e411 <= 0f));
let _e420 = global_5.member[_e351].member_13.member_1.member;
let _e431 = ((((_e420.member.member * _e376) + (_e420.member.member_1 * _e379)) + (_e420.member.member_2 * _e370)) + _e420.member_1);
let _e437 = ((((_e420.member.member * _e381) + (_e420.member.member_1 * _e383)) + (_e420.member.member_2 * _e388)) + _e420.member_1);
let _e440 = ((_e431 > 0f) && (_e437 <= 0f));
let _e441 = (_e414 || _e440);
let _e446 = global_5.member[_e351].member_6.member;
let _e457 = ((((_e446.member.member * _e376) + (_e446.member.member_1 * _e379)) + (_e446.member.member_2 * _e370)) + _e446.member_1);
let _e462 = global_5.member[_e351].member_6.member_1;
let _e473 = ((((_e462.member.member * _e376) + (_e462.member.member_1 * _e379)) + (_e462.member.member_2 * _e370)) + _e462.member_1);
let _e478 = global_5.member[_e351].member_6.member_2;
let _e489 = ((((_e478.member.member * _e376) + (_e478.member.member_1 * _e379)) + (_e478.member.member_2 * _e370)) + _e478.member_1);
let _e495 = ((((_e446.member.member * _e381) + (_e446.member.member_1 * _e383)) + (_e446.member.member_2 * _e388)) + _e446.member_1);
let _e501 = ((((_e462.member.member * _e381) + (_e462.member.member_1 * _e383)) + (_e462.member.member_2 * _e388)) + _e462.member_1);
let _e507 = ((((_e478.member.member * _e381) + (_e478.member.member_1 * _e383)) + (_e478.member.member_2 * _e388)) + _e478.member_1);
let _e512 = global_5.member[_e351].member_6.member_4;
let _e518 = global_5.member[_e351].member_6.member_3.member;
let _e519 = (_e518 - 0.5f);
let _e521 = select(-0.5f, _e495, (_e495 > -0.5f));
let _e523 = select(_e519, _e521, (_e521 < _e519));
let _e529 = global_5.member[_e351].member_6.member_3.member_1;
let _e530 = (_e529 - 0.5f);
let _e532 = select(-0.5f, _e501, (_e501 > -0.5f));
let _e534 = select(_e530, _e532, (_e532 < _e530));
let _e540 = global_5.member[_e351].member_6.member_3.member_2;
let _e541 = (_e540 - 0.5f);
let _e543 = select(-0.5f, _e507, (_e507 > -0.5f));
let _e545 = select(_e541, _e543, (_e543 < _e541));
let _e546 = (_e495 - _e457);
let _e547 = (_e501 - _e473);
let _e548 = (_e507 - _e489);
let _e551 = bitcast<f32>((bitcast<u32>(_e546) & 2147483647u));
let _e554 = bitcast<f32>((bitcast<u32>(_e547) & 2147483647u));
let _e556 = select(_e554, _e551, (_e551 > _e554));
let _e559 = bitcast<f32>((bitcast<u32>(_e548) & 2147483647u));
let _e568 = bitcast<f32>((bitcast<u32>((_e495 - _e523)) & 2147483647u));
let _e571 = bitcast<f32>((bitcast<u32>((_e501 - _e534)) & 2147483647u));
let _e573 = select(_e571, _e568, (_e568 > _e571));
let _e576 = bitcast<f32>((bitcast<u32>((_e507 - _e545)) & 2147483647u));
let _e580 = (_e523 + 0.5f);
let _e581 = (_e518 - 1f);
let _e583 = select(0f, _e580, (_e580 > 0f));
let _e585 = select(_e581, _e583, (_e583 < _e581));
let _e592 = select(0i, select(select(i32(_e585), i32(-2147483648), (_e585 < -2147483600f)), 2147483647i, (_e585 > 2147483500f)), (_e585 == _e585));
let _e601 = global_5.member[_e351].member_6.member_12;
let _e602 = (_e601 & 31u);
let _e605 = (_e534 + 0.5f);
let _e606 = (_e529 - 1f);
let _e608 = select(0f, _e605, (_e605 > 0f));
let _e610 = select(_e606, _e608, (_e608 < _e606));
let _e617 = select(0i, select(select(i32(_e610), i32(-2147483648), (_e610 < -2147483600f)), 2147483647i, (_e610 > 2147483500f)), (_e610 == _e610));
let _e624 = (_e545 + 0.5f);
let _e625 = (_e540 - 1f);
let _e627 = select(0f, _e624, (_e624 > 0f));
let _e629 = select(_e625, _e627, (_e627 < _e625));
let _e636 = select(0i, select(select(i32(_e629), i32(-2147483648), (_e629 < -2147483600f)), 2147483647i, (_e629 > 2147483500f)), (_e629 == _e629));
let _e648 = global_5.member[_e351].member_6.member_9.member;
let _e655 = global_5.member[_e351].member_6.member_9.member_1;
let _e661 = global_5.member[_e351].member_6.member_10;
let _e667 = ((bitcast<i32>(_e661) + ((_e592 - select(0i, 1i, (_e585 < f32(_e592)))) >> bitcast<u32>(_e602))) + (bitcast<i32>(_e648) * (((_e617 - select(0i, 1i, (_e610 < f32(_e617)))) >> bitcast<u32>(_e602)) + (bitcast<i32>(_e655) * ((_e636 - select(0i, 1i, (_e629 < f32(_e636)))) >> bitcast<u32>(_e602))))));
let _e669 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e671 = select(_e669, _e667, (_e667 < _e669));
let _e677 = global_2.member[bitcast<u32>(select(0i, _e671, (_e671 > 0i)))];
let _e684 = global_5.member[_e351].member_1;
let _e717 = (_e355[17] != _e370);
let _e724 = (select(0u, select(select(select(select(7u, 3u, (((((((_e457 >= 0f) && (_e457 <= _e581)) && (_e473 >= 0f)) && (_e473 <= _e606)) && (_e489 >= 0f)) && (_e489 <= _e625)) && ((((((_e495 >= 0f) && (_e495 <= _e581)) && (_e501 >= 0f)) && (_e501 <= _e606)) && (_e507 >= 0f)) && (_e507 <= _e625)))), 15u, _e717), 1u, (((_e684 & 64u) != 0u) || ((((select(_e559, _e556, (_e556 > _e559)) <= _e512) && ((select(_e576, _e573, (_e573 > _e576)) > _e512) || (_e677 != 0u))) && true) && ((_e684 & 32u) != 0u)))), 31u, _e441), (_e355[6] == 0f)) > 1u);
if _e724 {
let _e728 = global_5.member[_e351].member;
let _e730 = (_e405 - _e411);
let _e733 = (_e405 / select(1e-20f, _e730, (_e730 > 1e-20f)));
let _e734 = (_e431 - _e437);
let _e737 = (_e431 / select(1e-20f, _e734, (_e734 > 1e-20f)));
let _e741 = (_e440 && (!(_e414) || (_e737 < _e733)));
let _e748 = global_5.member[_e351].member_13.member_1.member.member;
let _e754 = global_5.member[_e351].member_13.member_1.member_1;
let _e761 = global_5.member[_e351].member_13.member.member.member;
let _e767 = global_5.member[_e351].member_13.member.member_1;
let _e786 = select(_e733, _e737, _e741);
let _e788 = (_e728.member_2 == 2u);
let _e791 = (((_e728.member_2 == 1u) || _e788) || (_e728.member_2 == 5u));
if _e791 {
let _e793 = select(-1f, _e523, (_e523 > -1f));
let _e795 = select(_e518, _e793, (_e793 < _e518));
let _e802 = select(0i, select(select(i32(_e795), i32(-2147483648), (_e795 < -2147483600f)), 2147483647i, (_e795 > 2147483500f)), (_e795 == _e795));
let _e806 = (_e802 - select(0i, 1i, (_e795 < f32(_e802))));
let _e808 = select(-1f, _e534, (_e534 > -1f));
let _e810 = select(_e529, _e808, (_e808 < _e529));
let _e817 = select(0i, select(select(i32(_e810), i32(-2147483648), (_e810 < -2147483600f)), 2147483647i, (_e810 > 2147483500f)), (_e810 == _e810));
let _e821 = (_e817 - select(0i, 1i, (_e810 < f32(_e817))));
let _e823 = select(-1f, _e545, (_e545 > -1f));
let _e825 = select(_e540, _e823, (_e823 < _e540));
let _e832 = select(0i, select(select(i32(_e825), i32(-2147483648), (_e825 < -2147483600f)), 2147483647i, (_e825 > 2147483500f)), (_e825 == _e825));
let _e836 = (_e832 - select(0i, 1i, (_e825 < f32(_e832))));
let _e841 = global_5.member[_e351].member_6.member_7;
let _e846 = global_5.member[_e351].member_6.member_8;
let _e854 = (select(0i, select(select(i32(_e529), i32(-2147483648), (_e529 < -2147483600f)), 2147483647i, (_e529 > 2147483500f)), (_e529 == _e529)) - 1i);
let _e855 = (_e821 - 1i);
let _e860 = (_e821 + 1i);
let _e863 = (_e821 + 2i);
let _e873 = (select(0i, select(select(i32(_e540), i32(-2147483648), (_e540 < -2147483600f)), 2147483647i, (_e540 > 2147483500f)), (_e540 == _e540)) - 1i);
let _e874 = (_e836 - 1i);
let _e879 = (_e836 + 1i);
let _e882 = (_e836 + 2i);
let _e892 = (select(0i, select(select(i32(_e518), i32(-2147483648), (_e518 < -2147483600f)), 2147483647i, (_e518 > 2147483500f)), (_e518 == _e518)) - 1i);
let _e893 = (_e806 - 1i);
let _e898 = (_e806 + 1i);
let _e901 = (_e806 + 2i);
let _e904 = (select(0i, _e855, (_e855 > 0i)) * _e841);
let _e905 = (select(0i, _e821, (_e821 > 0i)) * _e841);
let _e906 = (select(_e854, _e860, (_e860 < _e854)) * _e841);
let _e907 = (select(_e854, _e863, (_e863 < _e854)) * _e841);
let _e908 = (select(0i, _e874, (_e874 > 0i)) * _e846);
let _e909 = (select(0i, _e836, (_e836 > 0i)) * _e846);
let _e910 = (select(_e873, _e879, (_e879 < _e873)) * _e846);
let _e911 = (select(_e873, _e882, (_e882 < _e873)) * _e846);
local_6 = type_28(array<i32, 4>(select(0i, _e893, (_e893 > 0i)), select(0i, _e806, (_e806 > 0i)), select(_e892, _e898, (_e898 < _e892)), select(_e892, _e901, (_e901 < _e892))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_7 = vec3<f32>((_e523 - f32(_e806)), (_e534 - f32(_e821)), (_e545 - f32(_e836)));
let _e922 = (_e909 + _e905);
let _e925 = local_6.member[0u];
let _e926 = (_e922 + _e925);
let _e928 = (bitcast<i32>(_e118) - 1i);
let _e930 = select(_e928, _e926, (_e926 < _e928));
let _e935 = global_1.member[bitcast<u32>(select(0i, _e930, (_e930 > 0i)))];
let _e936 = bitcast<f32>(_e935);
let _e939 = local_6.member[1u];
let _e940 = (_e922 + _e939);
let _e942 = select(_e928, _e940, (_e940 < _e928));
let _e947 = global_1.member[bitcast<u32>(select(0i, _e942, (_e942 > 0i)))];
let _e948 = bitcast<f32>(_e947);
let _e951 = local_6.member[2u];
let _e952 = (_e922 + _e951);
let _e954 = select(_e928, _e952, (_e952 < _e928));
let _e959 = global_1.member[bitcast<u32>(select(0i, _e954, (_e954 > 0i)))];
let _e960 = bitcast<f32>(_e959);
let _e963 = local_6.member[3u];
let _e964 = (_e922 + _e963);
let _e966 = select(_e928, _e964, (_e964 < _e928));
let _e971 = global_1.member[bitcast<u32>(select(0i, _e966, (_e966 > 0i)))];
let _e973 = local_7[0u];
let _e976 = (_e936 + ((_e948 - _e936) * _e973));
let _e977 = local_7[0u];
let _e980 = (_e948 + ((_e960 - _e948) * _e977));
let _e981 = local_7[0u];
let _e984 = (_e960 + ((bitcast<f32>(_e971) - _e960) * _e981));
let _e985 = (_e909 + _e906);
let _e986 = local_6.member[0u];
let _e987 = (_e985 + _e986);
let _e989 = select(_e928, _e987, (_e987 < _e928));
let _e994 = global_1.member[bitcast<u32>(select(0i, _e989, (_e989 > 0i)))];
let _e995 = bitcast<f32>(_e994);
let _e996 = local_6.member[1u];
let _e997 = (_e985 + _e996);
let _e999 = select(_e928, _e997, (_e997 < _e928));
let _e1004 = global_1.member[bitcast<u32>(select(0i, _e999, (_e999 > 0i)))];
let _e1005 = bitcast<f32>(_e1004);
let _e1006 = local_6.member[2u];
let _e1007 = (_e985 + _e1006);
let _e1009 = select(_e928, _e1007, (_e1007 < _e928));
let _e1014 = global_1.member[bitcast<u32>(select(0i, _e1009, (_e1009 > 0i)))];
let _e1015 = bitcast<f32>(_e1014);
let _e1016 = local_6.member[3u];
let _e1017 = (_e985 + _e1016);
let _e1019 = select(_e928, _e1017, (_e1017 < _e928));
let _e1024 = global_1.member[bitcast<u32>(select(0i, _e1019, (_e1019 > 0i)))];
let _e1026 = local_7[0u];
let _e1030 = local_7[0u];
let _e1033 = (_e1005 + ((_e1015 - _e1005) * _e1030));
let _e1034 = local_7[0u];
let _e1038 = (_e910 + _e905);
let _e1039 = local_6.member[0u];
let _e1040 = (_e1038 + _e1039);
let _e1042 = select(_e928, _e1040, (_e1040 < _e928));
let _e1047 = global_1.member[bitcast<u32>(select(0i, _e1042, (_e1042 > 0i)))];
let _e1048 = bitcast<f32>(_e1047);
let _e1049 = local_6.member[1u];
let _e1050 = (_e1038 + _e1049);
let _e1052 = select(_e928, _e1050, (_e1050 < _e928));
let _e1057 = global_1.member[bitcast<u32>(select(0i, _e1052, (_e1052 > 0i)))];
let _e1058 = bitcast<f32>(_e1057);
let _e1059 = local_6.member[2u];
let _e1060 = (_e1038 + _e1059);
let _e1062 = select(_e928, _e1060, (_e1060 < _e928));
let _e1067 = global_1.member[bitcast<u32>(select(0i, _e1062, (_e1062 > 0i)))];
let _e1068 = bitcast<f32>(_e1067);
let _e1069 = local_6.member[3u];
let _e1070 = (_e1038 + _e1069);
let _e1072 = select(_e928, _e1070, (_e1070 < _e928));
let _e1077 = global_1.member[bitcast<u32>(select(0i, _e1072, (_e1072 > 0i)))];
let _e1079 = local_7[0u];
let _e1082 = (_e1048 + ((_e1058 - _e1048) * _e1079));
let _e1083 = local_7[0u];
let _e1086 = (_e1058 + ((_e1068 - _e1058) * _e1083));
let _e1087 = local_7[0u];
let _e1090 = (_e1068 + ((bitcast<f32>(_e1077) - _e1068) * _e1087));
let _e1091 = (_e910 + _e906);
let _e1092 = local_6.member[0u];
let _e1093 = (_e1091 + _e1092);
let _e1095 = select(_e928, _e1093, (_e1093 < _e928));
let _e1100 = global_1.member[bitcast<u32>(select(0i, _e1095, (_e1095 > 0i)))];
let _e1101 = bitcast<f32>(_e1100);
let _e1102 = local_6.member[1u];
let _e1103 = (_e1091 + _e1102);
let _e1105 = select(_e928, _e1103, (_e1103 < _e928));
let _e1110 = global_1.member[bitcast<u32>(select(0i, _e1105, (_e1105 > 0i)))];
let _e1111 = bitcast<f32>(_e1110);
let _e1112 = local_6.member[2u];
let _e1113 = (_e1091 + _e1112);
let _e1115 = select(_e928, _e1113, (_e1113 < _e928));
let _e1120 = global_1.member[bitcast<u32>(select(0i, _e1115, (_e1115 > 0i)))];
let _e1121 = bitcast<f32>(_e1120);
let _e1122 = local_6.member[3u];
let _e1123 = (_e1091 + _e1122);
let _e1125 = select(_e928, _e1123, (_e1123 < _e928));
let _e1130 = global_1.member[bitcast<u32>(select(0i, _e1125, (_e1125 > 0i)))];
let _e1132 = local_7[0u];
let _e1136 = local_7[0u];
let _e1139 = (_e1111 + ((_e1121 - _e1111) * _e1136));
let _e1140 = local_7[0u];
let _e1144 = (_e909 + _e904);
let _e1145 = local_6.member[1u];
let _e1146 = (_e1144 + _e1145);
let _e1148 = select(_e928, _e1146, (_e1146 < _e928));
let _e1153 = global_1.member[bitcast<u32>(select(0i, _e1148, (_e1148 > 0i)))];
let _e1154 = bitcast<f32>(_e1153);
let _e1155 = local_6.member[2u];
let _e1156 = (_e1144 + _e1155);
let _e1158 = select(_e928, _e1156, (_e1156 < _e928));
let _e1163 = global_1.member[bitcast<u32>(select(0i, _e1158, (_e1158 > 0i)))];
let _e1165 = local_7[0u];
let _e1168 = (_e1154 + ((bitcast<f32>(_e1163) - _e1154) * _e1165));
let _e1169 = (_e909 + _e907);
let _e1170 = local_6.member[1u];
let _e1171 = (_e1169 + _e1170);
let _e1173 = select(_e928, _e1171, (_e1171 < _e928));
let _e1178 = global_1.member[bitcast<u32>(select(0i, _e1173, (_e1173 > 0i)))];
let _e1179 = bitcast<f32>(_e1178);
let _e1180 = local_6.member[2u];
let _e1181 = (_e1169 + _e1180);
let _e1183 = select(_e928, _e1181, (_e1181 < _e928));
let _e1188 = global_1.member[bitcast<u32>(select(0i, _e1183, (_e1183 > 0i)))];
let _e1190 = local_7[0u];
let _e1194 = (_e910 + _e904);
let _e1195 = local_6.member[1u];
let _e1196 = (_e1194 + _e1195);
let _e1198 = select(_e928, _e1196, (_e1196 < _e928));
let _e1203 = global_1.member[bitcast<u32>(select(0i, _e1198, (_e1198 > 0i)))];
let _e1204 = bitcast<f32>(_e1203);
let _e1205 = local_6.member[2u];
let _e1206 = (_e1194 + _e1205);
let _e1208 = select(_e928, _e1206, (_e1206 < _e928));
let _e1213 = global_1.member[bitcast<u32>(select(0i, _e1208, (_e1208 > 0i)))];
let _e1215 = local_7[0u];
let _e1218 = (_e1204 + ((bitcast<f32>(_e1213) - _e1204) * _e1215));
let _e1219 = (_e910 + _e907);
let _e1220 = local_6.member[1u];
let _e1221 = (_e1219 + _e1220);
let _e1223 = select(_e928, _e1221, (_e1221 < _e928));
let _e1228 = global_1.member[bitcast<u32>(select(0i, _e1223, (_e1223 > 0i)))];
let _e1229 = bitcast<f32>(_e1228);
let _e1230 = local_6.member[2u];
let _e1231 = (_e1219 + _e1230);
let _e1233 = select(_e928, _e1231, (_e1231 < _e928));
let _e1238 = global_1.member[bitcast<u32>(select(0i, _e1233, (_e1233 > 0i)))];
let _e1240 = local_7[0u];
let _e1244 = (_e908 + _e905);
let _e1245 = local_6.member[1u];
let _e1246 = (_e1244 + _e1245);
let _e1248 = select(_e928, _e1246, (_e1246 < _e928));
let _e1253 = global_1.member[bitcast<u32>(select(0i, _e1248, (_e1248 > 0i)))];
let _e1254 = bitcast<f32>(_e1253);
let _e1255 = local_6.member[2u];
let _e1256 = (_e1244 + _e1255);
let _e1258 = select(_e928, _e1256, (_e1256 < _e928));
let _e1263 = global_1.member[bitcast<u32>(select(0i, _e1258, (_e1258 > 0i)))];
let _e1265 = local_7[0u];
let _e1268 = (_e1254 + ((bitcast<f32>(_e1263) - _e1254) * _e1265));
let _e1269 = (_e911 + _e905);
let _e1270 = local_6.member[1u];
let _e1271 = (_e1269 + _e1270);
let _e1273 = select(_e928, _e1271, (_e1271 < _e928));
let _e1278 = global_1.member[bitcast<u32>(select(0i, _e1273, (_e1273 > 0i)))];
let _e1279 = bitcast<f32>(_e1278);
let _e1280 = local_6.member[2u];
let _e1281 = (_e1269 + _e1280);
let _e1283 = select(_e928, _e1281, (_e1281 < _e928));
let _e1288 = global_1.member[bitcast<u32>(select(0i, _e1283, (_e1283 > 0i)))];
let _e1290 = local_7[0u];
let _e1293 = (_e1279 + ((bitcast<f32>(_e1288) - _e1279) * _e1290));
let _e1294 = (_e908 + _e906);
let _e1295 = local_6.member[1u];
let _e1296 = (_e1294 + _e1295);
let _e1298 = select(_e928, _e1296, (_e1296 < _e928));
let _e1303 = global_1.member[bitcast<u32>(select(0i, _e1298, (_e1298 > 0i)))];
let _e1304 = bitcast<f32>(_e1303);
let _e1305 = local_6.member[2u];
let _e1306 = (_e1294 + _e1305);
let _e1308 = select(_e928, _e1306, (_e1306 < _e928));
let _e1313 = global_1.member[bitcast<u32>(select(0i, _e1308, (_e1308 > 0i)))];
let _e1315 = local_7[0u];
let _e1319 = (_e911 + _e906);
let _e1320 = local_6.member[1u];
let _e1321 = (_e1319 + _e1320);
let _e1323 = select(_e928, _e1321, (_e1321 < _e928));
let _e1328 = global_1.member[bitcast<u32>(select(0i, _e1323, (_e1323 > 0i)))];
let _e1329 = bitcast<f32>(_e1328);
let _e1330 = local_6.member[2u];
let _e1331 = (_e1319 + _e1330);
let _e1333 = select(_e928, _e1331, (_e1331 < _e928));
let _e1338 = global_1.member[bitcast<u32>(select(0i, _e1333, (_e1333 > 0i)))];
let _e1340 = local_7[0u];
let _e1345 = local_7[1u];
let _e1348 = (_e980 + ((_e1033 - _e980) * _e1345));
let _e1349 = local_7[1u];
let _e1352 = (_e1086 + ((_e1139 - _e1086) * _e1349));
let _e1353 = local_7[1u];
let _e1356 = (_e976 + (((_e995 + ((_e1005 - _e995) * _e1026)) - _e976) * _e1353));
let _e1357 = local_7[1u];
let _e1362 = local_7[2u];
let _e1366 = local_7[1u];
let _e1369 = (_e984 + (((_e1015 + ((bitcast<f32>(_e1024) - _e1015) * _e1034)) - _e984) * _e1366));
let _e1370 = local_7[1u];
let _e1374 = local_7[2u];
let _e1378 = local_7[1u];
let _e1381 = (_e1168 + ((_e980 - _e1168) * _e1378));
let _e1382 = local_7[1u];
let _e1386 = local_7[2u];
let _e1390 = local_7[1u];
let _e1393 = (_e1033 + (((_e1179 + ((bitcast<f32>(_e1188) - _e1179) * _e1190)) - _e1033) * _e1390));
let _e1394 = local_7[1u];
let _e1398 = local_7[2u];
let _e1402 = local_7[1u];
let _e1405 = (_e1268 + (((_e1304 + ((bitcast<f32>(_e1313) - _e1304) * _e1315)) - _e1268) * _e1402));
let _e1406 = local_7[2u];
let _e1410 = local_7[1u];
let _e1414 = local_7[2u];
let _e1418 = local_7[2u];
let _e1426 = global_5.member[_e351].member_6.member_5;
let _e1432 = global_5.member[_e351].member_6.member_6;
let _e1433 = (((_e1348 + ((_e1352 - _e1348) * _e1418)) * _e1426) + _e1432);
let _e1435 = select(0f, _e1433, (_e1433 > 0f));
let _e1437 = select(1f, _e1435, (_e1435 < 1f));
let _e1439 = (((_e1356 + (((_e1082 + (((_e1101 + ((_e1111 - _e1101) * _e1132)) - _e1082) * _e1357)) - _e1356) * _e1362)) * _e1426) + _e1432);
let _e1441 = select(0f, _e1439, (_e1439 > 0f));
let _e1443 = select(1f, _e1441, (_e1441 < 1f));
let _e1445 = (((_e1369 + (((_e1090 + (((_e1121 + ((bitcast<f32>(_e1130) - _e1121) * _e1140)) - _e1090) * _e1370)) - _e1369) * _e1374)) * _e1426) + _e1432);
let _e1447 = select(0f, _e1445, (_e1445 > 0f));
let _e1449 = select(1f, _e1447, (_e1447 < 1f));
let _e1451 = (((_e1381 + (((_e1218 + ((_e1086 - _e1218) * _e1382)) - _e1381) * _e1386)) * _e1426) + _e1432);
let _e1453 = select(0f, _e1451, (_e1451 > 0f));
let _e1455 = select(1f, _e1453, (_e1453 < 1f));
let _e1457 = (((_e1393 + (((_e1139 + (((_e1229 + ((bitcast<f32>(_e1238) - _e1229) * _e1240)) - _e1139) * _e1394)) - _e1393) * _e1398)) * _e1426) + _e1432);
let _e1459 = select(0f, _e1457, (_e1457 > 0f));
let _e1461 = select(1f, _e1459, (_e1459 < 1f));
let _e1463 = (((_e1405 + ((_e1348 - _e1405) * _e1406)) * _e1426) + _e1432);
let _e1465 = select(0f, _e1463, (_e1463 > 0f));
let _e1467 = select(1f, _e1465, (_e1465 < 1f));
let _e1469 = (((_e1352 + (((_e1293 + (((_e1329 + ((bitcast<f32>(_e1338) - _e1329) * _e1340)) - _e1293) * _e1410)) - _e1352) * _e1414)) * _e1426) + _e1432);
let _e1471 = select(0f, _e1469, (_e1469 > 0f));
let _e1473 = select(1f, _e1471, (_e1471 < 1f));
let _e1474 = (_e1437 * 1024f);
let _e1475 = (1024f - 1f);
let _e1477 = select(0f, _e1474, (_e1474 > 0f));
let _e1479 = select(_e1475, _e1477, (_e1477 < _e1475));
let _e1486 = select(0i, select(select(i32(_e1479), i32(-2147483648), (_e1479 < -2147483600f)), 2147483647i, (_e1479 > 2147483500f)), (_e1479 == _e1479));
let _e1490 = (_e1486 - select(0i, 1i, (_e1479 < f32(_e1486))));
let _e1491 = (262147i + _e1490);
let _e1493 = (bitcast<i32>(_e122) - 1i);
let _e1495 = select(_e1493, _e1491, (_e1491 < _e1493));
let _e1501 = global_3.member[bitcast<u32>(select(0i, _e1495, (_e1495 > 0i)))];
let _e1511 = select(_e1493, 262146i, (262146i < _e1493));
let _e1517 = global_3.member[bitcast<u32>(select(0i, _e1511, (_e1511 > 0i)))];
let _e1518 = bitcast<f32>(_e1517);
let _e1519 = (f32((bitcast<i32>((_e1501 & 4095u)) - 2048i)) * _e1518);
let _e1521 = select(_e1493, 262144i, (262144i < _e1493));
let _e1527 = global_3.member[bitcast<u32>(select(0i, _e1521, (_e1521 > 0i)))];
let _e1528 = bitcast<f32>(_e1527);
let _e1530 = select(_e1493, 262145i, (262145i < _e1493));
let _e1536 = global_3.member[bitcast<u32>(select(0i, _e1530, (_e1530 > 0i)))];
let _e1537 = bitcast<f32>(_e1536);
let _e1543 = ((_e1528 + (f32(bitcast<i32>((_e1501 >> bitcast<u32>(12u)))) * _e1537)) + (_e1519 * (_e1474 - f32(_e1490))));
let _e1544 = (_e1519 * 1024f);
if _e788 {
let _e1551 = ((0.5f * (_e1449 - _e1443)) * _e1544);
let _e1552 = ((0.5f * (_e1461 - _e1455)) * _e1544);
let _e1553 = ((0.5f * (_e1473 - _e1467)) * _e1544);
phi_3469_ = type_29(_e1543, vec3<f32>(_e1551, _e1552, _e1553), vec3<f32>((_e1551 * _e1543), (_e1552 * _e1543), (_e1553 * _e1543)));
} else {
let _e1560 = (_e1443 * 1024f);
let _e1562 = select(0f, _e1560, (_e1560 > 0f));
let _e1564 = select(_e1475, _e1562, (_e1562 < _e1475));
let _e1571 = select(0i, select(select(i32(_e1564), i32(-2147483648), (_e1564 < -2147483600f)), 2147483647i, (_e1564 > 2147483500f)), (_e1564 == _e1564));
let _e1575 = (_e1571 - select(0i, 1i, (_e1564 < f32(_e1571))));
let _e1576 = (262147i + _e1575);
let _e1578 = select(_e1493, _e1576, (_e1576 < _e1493));
let _e1584 = global_3.member[bitcast<u32>(select(0i, _e1578, (_e1578 > 0i)))];
let _e1599 = ((_e1528 + (f32(bitcast<i32>((_e1584 >> bitcast<u32>(12u)))) * _e1537)) + ((f32((bitcast<i32>((_e1584 & 4095u)) - 2048i)) * _e1518) * (_e1560 - f32(_e1575))));
let _e1600 = (_e1449 * 1024f);
let _e1602 = select(0f, _e1600, (_e1600 > 0f));
let _e1604 = select(_e1475, _e1602, (_e1602 < _e1475));
let _e1611 = select(0i, select(select(i32(_e1604), i32(-2147483648), (_e1604 < -2147483600f)), 2147483647i, (_e1604 > 2147483500f)), (_e1604 == _e1604));
let _e1615 = (_e1611 - select(0i, 1i, (_e1604 < f32(_e1611))));
let _e1616 = (262147i + _e1615);
let _e1618 = select(_e1493, _e1616, (_e1616 < _e1493));
let _e1624 = global_3.member[bitcast<u32>(select(0i, _e1618, (_e1618 > 0i)))];
let _e1639 = ((_e1528 + (f32(bitcast<i32>((_e1624 >> bitcast<u32>(12u)))) * _e1537)) + ((f32((bitcast<i32>((_e1624 & 4095u)) - 2048i)) * _e1518) * (_e1600 - f32(_e1615))));
let _e1640 = (_e1455 * 1024f);
let _e1642 = select(0f, _e1640, (_e1640 > 0f));
let _e1644 = select(_e1475, _e1642, (_e1642 < _e1475));
let _e1651 = select(0i, select(select(i32(_e1644), i32(-2147483648), (_e1644 < -2147483600f)), 2147483647i, (_e1644 > 2147483500f)), (_e1644 == _e1644));
let _e1655 = (_e1651 - select(0i, 1i, (_e1644 < f32(_e1651))));
let _e1656 = (262147i + _e1655);
let _e1658 = select(_e1493, _e1656, (_e1656 < _e1493));
let _e1664 = global_3.member[bitcast<u32>(select(0i, _e1658, (_e1658 > 0i)))];
let _e1679 = ((_e1528 + (f32(bitcast<i32>((_e1664 >> bitcast<u32>(12u)))) * _e1537)) + ((f32((bitcast<i32>((_e1664 & 4095u)) - 2048i)) * _e1518) * (_e1640 - f32(_e1655))));
let _e1680 = (_e1461 * 1024f);
let _e1682 = select(0f, _e1680, (_e1680 > 0f));
let _e1684 = select(_e1475, _e1682, (_e1682 < _e1475));
let _e1691 = select(0i, select(select(i32(_e1684), i32(-2147483648), (_e1684 < -2147483600f)), 2147483647i, (_e1684 > 2147483500f)), (_e1684 == _e1684));
let _e1695 = (_e1691 - select(0i, 1i, (_e1684 < f32(_e1691))));
let _e1696 = (262147i + _e1695);
let _e1698 = select(_e1493, _e1696, (_e1696 < _e1493));
let _e1704 = global_3.member[bitcast<u32>(select(0i, _e1698, (_e1698 > 0i)))];
let _e1719 = ((_e1528 + (f32(bitcast<i32>((_e1704 >> bitcast<u32>(12u)))) * _e1537)) + ((f32((bitcast<i32>((_e1704 & 4095u)) - 2048i)) * _e1518) * (_e1680 - f32(_e1695))));
let _e1720 = (_e1467 * 1024f);
let _e1722 = select(0f, _e1720, (_e1720 > 0f));
let _e1724 = select(_e1475, _e1722, (_e1722 < _e1475));
let _e1731 = select(0i, select(select(i32(_e1724), i32(-2147483648), (_e1724 < -2147483600f)), 2147483647i, (_e1724 > 2147483500f)), (_e1724 == _e1724));
let _e1735 = (_e1731 - select(0i, 1i, (_e1724 < f32(_e1731))));
let _e1736 = (262147i + _e1735);
let _e1738 = select(_e1493, _e1736, (_e1736 < _e1493));
let _e1744 = global_3.member[bitcast<u32>(select(0i, _e1738, (_e1738 > 0i)))];
let _e1759 = ((_e1528 + (f32(bitcast<i32>((_e1744 >> bitcast<u32>(12u)))) * _e1537)) + ((f32((bitcast<i32>((_e1744 & 4095u)) - 2048i)) * _e1518) * (_e1720 - f32(_e1735))));
let _e1760 = (_e1473 * 1024f);
let _e1762 = select(0f, _e1760, (_e1760 > 0f));
let _e1764 = select(_e1475, _e1762, (_e1762 < _e1475));
let _e1771 = select(0i, select(select(i32(_e1764), i32(-2147483648), (_e1764 < -2147483600f)), 2147483647i, (_e1764 > 2147483500f)), (_e1764 == _e1764));
let _e1775 = (_e1771 - select(0i, 1i, (_e1764 < f32(_e1771))));
let _e1776 = (262147i + _e1775);
let _e1778 = select(_e1493, _e1776, (_e1776 < _e1493));
let _e1784 = global_3.member[bitcast<u32>(select(0i, _e1778, (_e1778 > 0i)))];
let _e1799 = ((_e1528 + (f32(bitcast<i32>((_e1784 >> bitcast<u32>(12u)))) * _e1537)) + ((f32((bitcast<i32>((_e1784 & 4095u)) - 2048i)) * _e1518) * (_e1760 - f32(_e1775))));
let _e1800 = (_e1639 - _e1599);
let _e1802 = (_e1719 - _e1679);
let _e1804 = (_e1799 - _e1759);
phi_3469_ = type_29(_e1543, vec3<f32>((0.5f * _e1800), (0.5f * _e1802), (0.5f * _e1804)), vec3<f32>((0.25f * (_e1800 * (_e1639 + _e1599))), (0.25f * (_e1802 * (_e1719 + _e1679))), (0.25f * (_e1804 * (_e1799 + _e1759)))));
}
let _e1819 = phi_3469_;
let _e1834 = select(0f, 1f, ((((((_e495 >= -0.5f) && (_e495 <= _e519)) && (_e501 >= -0.5f)) && (_e501 <= _e530)) && (_e507 >= -0.5f)) && (_e507 <= _e541)));
let _e1836 = (0.5f * (_e1449 - _e1443));
let _e1838 = (0.5f * (_e1461 - _e1455));
let _e1840 = (0.5f * (_e1473 - _e1467));
let _e1847 = global_5.member[_e351].member_6.member.member.member;
let _e1854 = global_5.member[_e351].member_6.member.member.member_1;
let _e1861 = global_5.member[_e351].member_6.member.member.member_2;
let _e1868 = global_5.member[_e351].member_6.member_1.member.member;
let _e1875 = global_5.member[_e351].member_6.member_1.member.member_1;
let _e1882 = global_5.member[_e351].member_6.member_1.member.member_2;
let _e1889 = global_5.member[_e351].member_6.member_2.member.member;
let _e1896 = global_5.member[_e351].member_6.member_2.member.member_1;
let _e1903 = global_5.member[_e351].member_6.member_2.member.member_2;
phi_4115_ = type_30(_e1437, vec3<f32>(((((_e1847 * _e1836) + (_e1868 * _e1838)) + (_e1889 * _e1840)) * _e1834), ((((_e1854 * _e1836) + (_e1875 * _e1838)) + (_e1896 * _e1840)) * _e1834), ((((_e1861 * _e1836) + (_e1882 * _e1838)) + (_e1903 * _e1840)) * _e1834)), _e1819.member, vec3<f32>(((((_e1847 * _e1819.member_2.x) + (_e1868 * _e1819.member_2.y)) + (_e1889 * _e1819.member_2.z)) * _e1834), ((((_e1854 * _e1819.member_2.x) + (_e1875 * _e1819.member_2.y)) + (_e1896 * _e1819.member_2.z)) * _e1834), ((((_e1861 * _e1819.member_2.x) + (_e1882 * _e1819.member_2.y)) + (_e1903 * _e1819.member_2.z)) * _e1834)), vec3<f32>(((((_e1847 * _e1819.member_1.x) + (_e1868 * _e1819.member_1.y)) + (_e1889 * _e1819.member_1.z)) * _e1834), ((((_e1854 * _e1819.member_1.x) + (_e1875 * _e1819.member_1.y)) + (_e1896 * _e1819.member_1.z)) * _e1834), ((((_e1861 * _e1819.member_1.x) + (_e1882 * _e1819.member_1.y)) + (_e1903 * _e1819.member_1.z)) * _e1834)));
} else {
let _e1969 = select(-1f, _e523, (_e523 > -1f));
let _e1971 = select(_e518, _e1969, (_e1969 < _e518));
let _e1978 = select(0i, select(select(i32(_e1971), i32(-2147483648), (_e1971 < -2147483600f)), 2147483647i, (_e1971 > 2147483500f)), (_e1971 == _e1971));
let _e1982 = (_e1978 - select(0i, 1i, (_e1971 < f32(_e1978))));
let _e1984 = select(-1f, _e534, (_e534 > -1f));
let _e1986 = select(_e529, _e1984, (_e1984 < _e529));
let _e1993 = select(0i, select(select(i32(_e1986), i32(-2147483648), (_e1986 < -2147483600f)), 2147483647i, (_e1986 > 2147483500f)), (_e1986 == _e1986));
let _e1997 = (_e1993 - select(0i, 1i, (_e1986 < f32(_e1993))));
let _e1999 = select(-1f, _e545, (_e545 > -1f));
let _e2001 = select(_e540, _e1999, (_e1999 < _e540));
let _e2008 = select(0i, select(select(i32(_e2001), i32(-2147483648), (_e2001 < -2147483600f)), 2147483647i, (_e2001 > 2147483500f)), (_e2001 == _e2001));
let _e2012 = (_e2008 - select(0i, 1i, (_e2001 < f32(_e2008))));
let _e2017 = global_5.member[_e351].member_6.member_7;
let _e2022 = global_5.member[_e351].member_6.member_8;
let _e2030 = (select(0i, select(select(i32(_e529), i32(-2147483648), (_e529 < -2147483600f)), 2147483647i, (_e529 > 2147483500f)), (_e529 == _e529)) - 1i);
let _e2033 = (_e1997 + 1i);
let _e2043 = (select(0i, select(select(i32(_e540), i32(-2147483648), (_e540 < -2147483600f)), 2147483647i, (_e540 > 2147483500f)), (_e540 == _e540)) - 1i);
let _e2046 = (_e2012 + 1i);
let _e2056 = (select(0i, select(select(i32(_e518), i32(-2147483648), (_e518 < -2147483600f)), 2147483647i, (_e518 > 2147483500f)), (_e518 == _e518)) - 1i);
let _e2057 = (_e1982 - 1i);
let _e2062 = (_e1982 + 1i);
let _e2065 = (_e1982 + 2i);
let _e2068 = (select(0i, _e1997, (_e1997 > 0i)) * _e2017);
let _e2069 = (select(_e2030, _e2033, (_e2033 < _e2030)) * _e2017);
let _e2070 = (select(0i, _e2012, (_e2012 > 0i)) * _e2022);
let _e2071 = (select(_e2043, _e2046, (_e2046 < _e2043)) * _e2022);
local_4 = type_28(array<i32, 4>(select(0i, _e2057, (_e2057 > 0i)), select(0i, _e1982, (_e1982 > 0i)), select(_e2056, _e2062, (_e2062 < _e2056)), select(_e2056, _e2065, (_e2065 < _e2056))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_5 = vec3<f32>((_e523 - f32(_e1982)), (_e534 - f32(_e1997)), (_e545 - f32(_e2012)));
let _e2082 = (_e2070 + _e2068);
let _e2085 = local_4.member[1u];
let _e2086 = (_e2082 + _e2085);
let _e2088 = (bitcast<i32>(_e118) - 1i);
let _e2090 = select(_e2088, _e2086, (_e2086 < _e2088));
let _e2095 = global_1.member[bitcast<u32>(select(0i, _e2090, (_e2090 > 0i)))];
let _e2096 = bitcast<f32>(_e2095);
let _e2099 = local_4.member[2u];
let _e2100 = (_e2082 + _e2099);
let _e2102 = select(_e2088, _e2100, (_e2100 < _e2088));
let _e2107 = global_1.member[bitcast<u32>(select(0i, _e2102, (_e2102 > 0i)))];
let _e2109 = local_5[0u];
let _e2112 = (_e2096 + ((bitcast<f32>(_e2107) - _e2096) * _e2109));
let _e2113 = (_e2070 + _e2069);
let _e2114 = local_4.member[1u];
let _e2115 = (_e2113 + _e2114);
let _e2117 = select(_e2088, _e2115, (_e2115 < _e2088));
let _e2122 = global_1.member[bitcast<u32>(select(0i, _e2117, (_e2117 > 0i)))];
let _e2123 = bitcast<f32>(_e2122);
let _e2124 = local_4.member[2u];
let _e2125 = (_e2113 + _e2124);
let _e2127 = select(_e2088, _e2125, (_e2125 < _e2088));
let _e2132 = global_1.member[bitcast<u32>(select(0i, _e2127, (_e2127 > 0i)))];
let _e2134 = local_5[0u];
let _e2139 = local_5[1u];
let _e2142 = (_e2112 + (((_e2123 + ((bitcast<f32>(_e2132) - _e2123) * _e2134)) - _e2112) * _e2139));
let _e2143 = (_e2071 + _e2068);
let _e2144 = local_4.member[1u];
let _e2145 = (_e2143 + _e2144);
let _e2147 = select(_e2088, _e2145, (_e2145 < _e2088));
let _e2152 = global_1.member[bitcast<u32>(select(0i, _e2147, (_e2147 > 0i)))];
let _e2153 = bitcast<f32>(_e2152);
let _e2154 = local_4.member[2u];
let _e2155 = (_e2143 + _e2154);
let _e2157 = select(_e2088, _e2155, (_e2155 < _e2088));
let _e2162 = global_1.member[bitcast<u32>(select(0i, _e2157, (_e2157 > 0i)))];
let _e2164 = local_5[0u];
let _e2167 = (_e2153 + ((bitcast<f32>(_e2162) - _e2153) * _e2164));
let _e2168 = (_e2071 + _e2069);
let _e2169 = local_4.member[1u];
let _e2170 = (_e2168 + _e2169);
let _e2172 = select(_e2088, _e2170, (_e2170 < _e2088));
let _e2177 = global_1.member[bitcast<u32>(select(0i, _e2172, (_e2172 > 0i)))];
let _e2178 = bitcast<f32>(_e2177);
let _e2179 = local_4.member[2u];
let _e2180 = (_e2168 + _e2179);
let _e2182 = select(_e2088, _e2180, (_e2180 < _e2088));
let _e2187 = global_1.member[bitcast<u32>(select(0i, _e2182, (_e2182 > 0i)))];
let _e2189 = local_5[0u];
let _e2193 = local_5[1u];
let _e2198 = local_5[2u];
let _e2206 = global_5.member[_e351].member_6.member_5;
let _e2212 = global_5.member[_e351].member_6.member_6;
let _e2213 = (((_e2142 + (((_e2167 + (((_e2178 + ((bitcast<f32>(_e2187) - _e2178) * _e2189)) - _e2167) * _e2193)) - _e2142) * _e2198)) * _e2206) + _e2212);
let _e2215 = select(0f, _e2213, (_e2213 > 0f));
phi_4115_ = type_30(select(1f, _e2215, (_e2215 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2220 = phi_4115_;
let _e2224 = select(-0.5f, _e457, (_e457 > -0.5f));
let _e2226 = select(_e519, _e2224, (_e2224 < _e519));
let _e2228 = select(-0.5f, _e473, (_e473 > -0.5f));
let _e2230 = select(_e530, _e2228, (_e2228 < _e530));
let _e2232 = select(-0.5f, _e489, (_e489 > -0.5f));
let _e2234 = select(_e541, _e2232, (_e2232 < _e541));
let _e2236 = select(-1f, _e2226, (_e2226 > -1f));
let _e2238 = select(_e518, _e2236, (_e2236 < _e518));
let _e2245 = select(0i, select(select(i32(_e2238), i32(-2147483648), (_e2238 < -2147483600f)), 2147483647i, (_e2238 > 2147483500f)), (_e2238 == _e2238));
let _e2249 = (_e2245 - select(0i, 1i, (_e2238 < f32(_e2245))));
let _e2251 = select(-1f, _e2230, (_e2230 > -1f));
let _e2253 = select(_e529, _e2251, (_e2251 < _e529));
let _e2260 = select(0i, select(select(i32(_e2253), i32(-2147483648), (_e2253 < -2147483600f)), 2147483647i, (_e2253 > 2147483500f)), (_e2253 == _e2253));
let _e2264 = (_e2260 - select(0i, 1i, (_e2253 < f32(_e2260))));
let _e2266 = select(-1f, _e2234, (_e2234 > -1f));
let _e2268 = select(_e540, _e2266, (_e2266 < _e540));
let _e2275 = select(0i, select(select(i32(_e2268), i32(-2147483648), (_e2268 < -2147483600f)), 2147483647i, (_e2268 > 2147483500f)), (_e2268 == _e2268));
let _e2279 = (_e2275 - select(0i, 1i, (_e2268 < f32(_e2275))));
let _e2284 = global_5.member[_e351].member_6.member_7;
let _e2289 = global_5.member[_e351].member_6.member_8;
let _e2297 = (select(0i, select(select(i32(_e529), i32(-2147483648), (_e529 < -2147483600f)), 2147483647i, (_e529 > 2147483500f)), (_e529 == _e529)) - 1i);
let _e2300 = (_e2264 + 1i);
let _e2310 = (select(0i, select(select(i32(_e540), i32(-2147483648), (_e540 < -2147483600f)), 2147483647i, (_e540 > 2147483500f)), (_e540 == _e540)) - 1i);
let _e2313 = (_e2279 + 1i);
let _e2323 = (select(0i, select(select(i32(_e518), i32(-2147483648), (_e518 < -2147483600f)), 2147483647i, (_e518 > 2147483500f)), (_e518 == _e518)) - 1i);
let _e2324 = (_e2249 - 1i);
let _e2329 = (_e2249 + 1i);
let _e2332 = (_e2249 + 2i);
let _e2335 = (select(0i, _e2264, (_e2264 > 0i)) * _e2284);
let _e2336 = (select(_e2297, _e2300, (_e2300 < _e2297)) * _e2284);
let _e2337 = (select(0i, _e2279, (_e2279 > 0i)) * _e2289);
let _e2338 = (select(_e2310, _e2313, (_e2313 < _e2310)) * _e2289);
local_2 = type_28(array<i32, 4>(select(0i, _e2324, (_e2324 > 0i)), select(0i, _e2249, (_e2249 > 0i)), select(_e2323, _e2329, (_e2329 < _e2323)), select(_e2323, _e2332, (_e2332 < _e2323))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_3 = vec3<f32>((_e2226 - f32(_e2249)), (_e2230 - f32(_e2264)), (_e2234 - f32(_e2279)));
let _e2349 = (_e2337 + _e2335);
let _e2352 = local_2.member[1u];
let _e2353 = (_e2349 + _e2352);
let _e2355 = (bitcast<i32>(_e118) - 1i);
let _e2357 = select(_e2355, _e2353, (_e2353 < _e2355));
let _e2362 = global_1.member[bitcast<u32>(select(0i, _e2357, (_e2357 > 0i)))];
let _e2363 = bitcast<f32>(_e2362);
let _e2366 = local_2.member[2u];
let _e2367 = (_e2349 + _e2366);
let _e2369 = select(_e2355, _e2367, (_e2367 < _e2355));
let _e2374 = global_1.member[bitcast<u32>(select(0i, _e2369, (_e2369 > 0i)))];
let _e2376 = local_3[0u];
let _e2379 = (_e2363 + ((bitcast<f32>(_e2374) - _e2363) * _e2376));
let _e2380 = (_e2337 + _e2336);
let _e2381 = local_2.member[1u];
let _e2382 = (_e2380 + _e2381);
let _e2384 = select(_e2355, _e2382, (_e2382 < _e2355));
let _e2389 = global_1.member[bitcast<u32>(select(0i, _e2384, (_e2384 > 0i)))];
let _e2390 = bitcast<f32>(_e2389);
let _e2391 = local_2.member[2u];
let _e2392 = (_e2380 + _e2391);
let _e2394 = select(_e2355, _e2392, (_e2392 < _e2355));
let _e2399 = global_1.member[bitcast<u32>(select(0i, _e2394, (_e2394 > 0i)))];
let _e2401 = local_3[0u];
let _e2406 = local_3[1u];
let _e2409 = (_e2379 + (((_e2390 + ((bitcast<f32>(_e2399) - _e2390) * _e2401)) - _e2379) * _e2406));
let _e2410 = (_e2338 + _e2335);
let _e2411 = local_2.member[1u];
let _e2412 = (_e2410 + _e2411);
let _e2414 = select(_e2355, _e2412, (_e2412 < _e2355));
let _e2419 = global_1.member[bitcast<u32>(select(0i, _e2414, (_e2414 > 0i)))];
let _e2420 = bitcast<f32>(_e2419);
let _e2421 = local_2.member[2u];
let _e2422 = (_e2410 + _e2421);
let _e2424 = select(_e2355, _e2422, (_e2422 < _e2355));
let _e2429 = global_1.member[bitcast<u32>(select(0i, _e2424, (_e2424 > 0i)))];
let _e2431 = local_3[0u];
let _e2434 = (_e2420 + ((bitcast<f32>(_e2429) - _e2420) * _e2431));
let _e2435 = (_e2338 + _e2336);
let _e2436 = local_2.member[1u];
let _e2437 = (_e2435 + _e2436);
let _e2439 = select(_e2355, _e2437, (_e2437 < _e2355));
let _e2444 = global_1.member[bitcast<u32>(select(0i, _e2439, (_e2439 > 0i)))];
let _e2445 = bitcast<f32>(_e2444);
let _e2446 = local_2.member[2u];
let _e2447 = (_e2435 + _e2446);
let _e2449 = select(_e2355, _e2447, (_e2447 < _e2355));
let _e2454 = global_1.member[bitcast<u32>(select(0i, _e2449, (_e2449 > 0i)))];
let _e2456 = local_3[0u];
let _e2460 = local_3[1u];
let _e2465 = local_3[2u];
let _e2473 = global_5.member[_e351].member_6.member_5;
let _e2479 = global_5.member[_e351].member_6.member_6;
let _e2480 = (((_e2409 + (((_e2434 + (((_e2445 + ((bitcast<f32>(_e2454) - _e2445) * _e2456)) - _e2434) * _e2460)) - _e2409) * _e2465)) * _e2473) + _e2479);
let _e2482 = select(0f, _e2480, (_e2480 > 0f));
let _e2484 = select(1f, _e2482, (_e2482 < 1f));
let _e2485 = select(_e355[5], _e2484, _e717);
if _e791 {
let _e2486 = (_e2484 * 1024f);
let _e2487 = (1024f - 1f);
let _e2489 = select(0f, _e2486, (_e2486 > 0f));
let _e2491 = select(_e2487, _e2489, (_e2489 < _e2487));
let _e2498 = select(0i, select(select(i32(_e2491), i32(-2147483648), (_e2491 < -2147483600f)), 2147483647i, (_e2491 > 2147483500f)), (_e2491 == _e2491));
let _e2502 = (_e2498 - select(0i, 1i, (_e2491 < f32(_e2498))));
let _e2503 = (262147i + _e2502);
let _e2505 = (bitcast<i32>(_e122) - 1i);
let _e2507 = select(_e2505, _e2503, (_e2503 < _e2505));
let _e2513 = global_3.member[bitcast<u32>(select(0i, _e2507, (_e2507 > 0i)))];
let _e2523 = select(_e2505, 262146i, (262146i < _e2505));
let _e2529 = global_3.member[bitcast<u32>(select(0i, _e2523, (_e2523 > 0i)))];
let _e2533 = select(_e2505, 262144i, (262144i < _e2505));
let _e2539 = global_3.member[bitcast<u32>(select(0i, _e2533, (_e2533 > 0i)))];
let _e2542 = select(_e2505, 262145i, (262145i < _e2505));
let _e2548 = global_3.member[bitcast<u32>(select(0i, _e2542, (_e2542 > 0i)))];
phi_4701_ = select(_e355[15], ((bitcast<f32>(_e2539) + (f32(bitcast<i32>((_e2513 >> bitcast<u32>(12u)))) * bitcast<f32>(_e2548))) + ((f32((bitcast<i32>((_e2513 & 4095u)) - 2048i)) * bitcast<f32>(_e2529)) * (_e2486 - f32(_e2502)))), _e717);
} else {
phi_4701_ = _e355[15];
}
let _e2558 = phi_4701_;
let _e2561 = select(1f, select(1f, _e786, (_e786 < 1f)), _e441);
if ((_e684 & 16u) == 0u) {
phi_5090_ = type_5(1f, 1f, 1f);
} else {
let _e2568 = global_5.member[_e351].member_14.member;
let _e2579 = ((((_e2568.member.member * _e376) + (_e2568.member.member_1 * _e379)) + (_e2568.member.member_2 * _e370)) + _e2568.member_1);
let _e2585 = ((((_e2568.member.member * _e381) + (_e2568.member.member_1 * _e383)) + (_e2568.member.member_2 * _e388)) + _e2568.member_1);
let _e2587 = select(_e2585, _e2579, (_e2579 < _e2585));
let _e2589 = select(_e2585, _e2579, (_e2579 > _e2585));
let _e2591 = (_e2589 - _e2587);
let _e2594 = (-(_e2587) / select(1e-30f, _e2591, (_e2591 > 1e-30f)));
let _e2596 = select(0f, _e2594, (_e2594 > 0f));
let _e2602 = select(select(select(1f, _e2596, (_e2596 < 1f)), 1f, (_e2589 <= 0f)), 0f, (_e2587 > 0f));
let _e2608 = global_5.member[_e351].member_14.member_1;
let _e2609 = (_e2608 != 0u);
let _e2620 = global_5.member[_e351].member_15.member;
let _e2631 = ((((_e2620.member.member * _e376) + (_e2620.member.member_1 * _e379)) + (_e2620.member.member_2 * _e370)) + _e2620.member_1);
let _e2637 = ((((_e2620.member.member * _e381) + (_e2620.member.member_1 * _e383)) + (_e2620.member.member_2 * _e388)) + _e2620.member_1);
let _e2639 = select(_e2637, _e2631, (_e2631 < _e2637));
let _e2641 = select(_e2637, _e2631, (_e2631 > _e2637));
let _e2643 = (_e2641 - _e2639);
let _e2646 = (-(_e2639) / select(1e-30f, _e2643, (_e2643 > 1e-30f)));
let _e2648 = select(0f, _e2646, (_e2646 > 0f));
let _e2654 = select(select(select(1f, _e2648, (_e2648 < 1f)), 1f, (_e2641 <= 0f)), 0f, (_e2639 > 0f));
let _e2660 = global_5.member[_e351].member_15.member_1;
let _e2661 = (_e2660 != 0u);
let _e2672 = global_5.member[_e351].member_16.member;
let _e2683 = ((((_e2672.member.member * _e376) + (_e2672.member.member_1 * _e379)) + (_e2672.member.member_2 * _e370)) + _e2672.member_1);
let _e2689 = ((((_e2672.member.member * _e381) + (_e2672.member.member_1 * _e383)) + (_e2672.member.member_2 * _e388)) + _e2672.member_1);
let _e2691 = select(_e2689, _e2683, (_e2683 < _e2689));
let _e2693 = select(_e2689, _e2683, (_e2683 > _e2689));
let _e2695 = (_e2693 - _e2691);
let _e2698 = (-(_e2691) / select(1e-30f, _e2695, (_e2695 > 1e-30f)));
let _e2700 = select(0f, _e2698, (_e2698 > 0f));
let _e2706 = select(select(select(1f, _e2700, (_e2700 < 1f)), 1f, (_e2693 <= 0f)), 0f, (_e2691 > 0f));
let _e2712 = global_5.member[_e351].member_16.member_1;
let _e2713 = (_e2712 != 0u);
let _e2724 = global_5.member[_e351].member_17.member;
let _e2735 = ((((_e2724.member.member * _e376) + (_e2724.member.member_1 * _e379)) + (_e2724.member.member_2 * _e370)) + _e2724.member_1);
let _e2741 = ((((_e2724.member.member * _e381) + (_e2724.member.member_1 * _e383)) + (_e2724.member.member_2 * _e388)) + _e2724.member_1);
let _e2743 = select(_e2741, _e2735, (_e2735 < _e2741));
let _e2745 = select(_e2741, _e2735, (_e2735 > _e2741));
let _e2747 = (_e2745 - _e2743);
let _e2750 = (-(_e2743) / select(1e-30f, _e2747, (_e2747 > 1e-30f)));
let _e2752 = select(0f, _e2750, (_e2750 > 0f));
let _e2758 = select(select(select(1f, _e2752, (_e2752 < 1f)), 1f, (_e2745 <= 0f)), 0f, (_e2743 > 0f));
let _e2764 = global_5.member[_e351].member_17.member_1;
let _e2765 = (_e2764 != 0u);
phi_5090_ = type_5(((((1f * _e2602) * _e2654) * _e2706) * _e2758), ((((1f * select(1f, _e2602, _e2609)) * select(1f, _e2654, _e2661)) * select(1f, _e2706, _e2713)) * select(1f, _e2758, _e2765)), ((((1f * select(1f, 0f, (_e2609 && (_e2585 > 0f)))) * select(1f, 0f, (_e2661 && (_e2637 > 0f)))) * select(1f, 0f, (_e2713 && (_e2689 > 0f)))) * select(1f, 0f, (_e2765 && (_e2741 > 0f)))));
}
let _e2774 = phi_5090_;
let _e2775 = (_e551 < 1e-12f);
let _e2777 = (1f / select(_e546, 1f, _e2775));
let _e2779 = ((-0.5f - _e457) * _e2777);
let _e2781 = ((_e519 - _e457) * _e2777);
let _e2787 = select(_e2781, _e2779, (_e2779 < _e2781));
let _e2789 = select(0f, _e2787, (_e2787 > 0f));
let _e2792 = select(select(1f, _e2789, (_e2789 < 1f)), select(2f, 0f, ((_e457 >= -0.5f) && (_e457 <= _e519))), _e2775);
let _e2794 = select(_e2781, _e2779, (_e2779 > _e2781));
let _e2796 = select(0f, _e2794, (_e2794 > 0f));
let _e2799 = select(select(1f, _e2796, (_e2796 < 1f)), 1f, _e2775);
let _e2800 = (_e554 < 1e-12f);
let _e2802 = (1f / select(_e547, 1f, _e2800));
let _e2804 = ((-0.5f - _e473) * _e2802);
let _e2806 = ((_e530 - _e473) * _e2802);
let _e2812 = select(_e2806, _e2804, (_e2804 < _e2806));
let _e2814 = select(0f, _e2812, (_e2812 > 0f));
let _e2817 = select(select(1f, _e2814, (_e2814 < 1f)), select(2f, 0f, ((_e473 >= -0.5f) && (_e473 <= _e530))), _e2800);
let _e2819 = select(_e2806, _e2804, (_e2804 > _e2806));
let _e2821 = select(0f, _e2819, (_e2819 > 0f));
let _e2824 = select(select(1f, _e2821, (_e2821 < 1f)), 1f, _e2800);
let _e2825 = (_e559 < 1e-12f);
let _e2827 = (1f / select(_e548, 1f, _e2825));
let _e2829 = ((-0.5f - _e489) * _e2827);
let _e2831 = ((_e541 - _e489) * _e2827);
let _e2837 = select(_e2831, _e2829, (_e2829 < _e2831));
let _e2839 = select(0f, _e2837, (_e2837 > 0f));
let _e2842 = select(select(1f, _e2839, (_e2839 < 1f)), select(2f, 0f, ((_e489 >= -0.5f) && (_e489 <= _e541))), _e2825);
let _e2844 = select(_e2831, _e2829, (_e2829 > _e2831));
let _e2846 = select(0f, _e2844, (_e2844 > 0f));
let _e2849 = select(select(1f, _e2846, (_e2846 < 1f)), 1f, _e2825);
let _e2851 = select(_e2824, _e2799, (_e2799 < _e2824));
let _e2855 = select(_e2817, _e2792, (_e2792 > _e2817));
let _e2858 = (select(_e2849, _e2851, (_e2851 < _e2849)) - select(_e2842, _e2855, (_e2855 > _e2842)));
let _e2861 = (_e381 - _e376);
let _e2862 = (_e383 - _e379);
let _e2863 = (_e388 - _e370);
let _e2868 = (((_e2861 * _e2861) + (_e2862 * _e2862)) + (_e2863 * _e2863));
let _e2878 = global_5.member[_e351].member_5.member_3;
let _e2879 = (((sqrt(select(0f, _e2868, (_e2868 > 0f))) * select(0f, _e2858, (_e2858 > 0f))) * _e2561) * _e2878);
let _e2880 = (_e728.member_2 >= 3u);
if _e2880 {
let _e2882 = (_e2485 * 255f);
let _e2883 = (_e2220.member * 255f);
let _e2884 = (255f - 1f);
let _e2886 = select(0f, _e2882, (_e2882 > 0f));
let _e2888 = select(_e2884, _e2886, (_e2886 < _e2884));
let _e2895 = select(0i, select(select(i32(_e2888), i32(-2147483648), (_e2888 < -2147483600f)), 2147483647i, (_e2888 > 2147483500f)), (_e2888 == _e2888));
let _e2899 = (_e2895 - select(0i, 1i, (_e2888 < f32(_e2895))));
let _e2901 = select(0f, _e2883, (_e2883 > 0f));
let _e2903 = select(_e2884, _e2901, (_e2901 < _e2884));
let _e2910 = select(0i, select(select(i32(_e2903), i32(-2147483648), (_e2903 < -2147483600f)), 2147483647i, (_e2903 > 2147483500f)), (_e2903 == _e2903));
let _e2914 = (_e2910 - select(0i, 1i, (_e2903 < f32(_e2910))));
let _e2917 = (((_e2899 * 256i) + _e2914) * 4i);
let _e2919 = (_e2882 - f32(_e2899));
let _e2921 = (_e2883 - f32(_e2914));
let _e2922 = (_e2917 + 2i);
let _e2924 = (bitcast<i32>(_e122) - 1i);
let _e2926 = select(_e2924, _e2922, (_e2922 < _e2924));
let _e2932 = global_3.member[bitcast<u32>(select(0i, _e2926, (_e2926 > 0i)))];
let _e2933 = (_e2917 + 6i);
let _e2935 = select(_e2924, _e2933, (_e2933 < _e2924));
let _e2941 = global_3.member[bitcast<u32>(select(0i, _e2935, (_e2935 > 0i)))];
let _e2942 = (_e2917 + 1026i);
let _e2944 = select(_e2924, _e2942, (_e2942 < _e2924));
let _e2950 = global_3.member[bitcast<u32>(select(0i, _e2944, (_e2944 > 0i)))];
let _e2951 = (_e2917 + 1030i);
let _e2953 = select(_e2924, _e2951, (_e2951 < _e2924));
let _e2959 = global_3.member[bitcast<u32>(select(0i, _e2953, (_e2953 > 0i)))];
let _e2964 = (bitcast<f32>(((_e2932 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2972 = (_e2964 + (((bitcast<f32>(((_e2941 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2964) * _e2921));
let _e2977 = (bitcast<f32>(((_e2950 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3001 = (bitcast<f32>((((_e2932 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3009 = (_e3001 + (((bitcast<f32>((((_e2941 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3001) * _e2921));
let _e3014 = (bitcast<f32>((((_e2950 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3026 = (_e2917 + 3i);
let _e3028 = select(_e2924, _e3026, (_e3026 < _e2924));
let _e3034 = global_3.member[bitcast<u32>(select(0i, _e3028, (_e3028 > 0i)))];
let _e3035 = (_e2917 + 7i);
let _e3037 = select(_e2924, _e3035, (_e3035 < _e2924));
let _e3043 = global_3.member[bitcast<u32>(select(0i, _e3037, (_e3037 > 0i)))];
let _e3044 = (_e2917 + 1027i);
let _e3046 = select(_e2924, _e3044, (_e3044 < _e2924));
let _e3052 = global_3.member[bitcast<u32>(select(0i, _e3046, (_e3046 > 0i)))];
let _e3053 = (_e2917 + 1031i);
let _e3055 = select(_e2924, _e3053, (_e3053 < _e2924));
let _e3061 = global_3.member[bitcast<u32>(select(0i, _e3055, (_e3055 > 0i)))];
let _e3066 = (bitcast<f32>(((_e3034 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3074 = (_e3066 + (((bitcast<f32>(((_e3043 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3066) * _e2921));
let _e3079 = (bitcast<f32>(((_e3052 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3103 = (bitcast<f32>((((_e3034 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3111 = (_e3103 + (((bitcast<f32>((((_e3043 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3103) * _e2921));
let _e3116 = (bitcast<f32>((((_e3052 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3127 = (_e3111 + (((_e3116 + (((bitcast<f32>((((_e3061 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3116) * _e2921)) - _e3111) * _e2919));
let _e3131 = -((_e3127 * (_e2879 * _e2774.member)));
let _e3133 = select(-87f, _e3131, (_e3131 > -87f));
let _e3135 = select(88f, _e3133, (_e3133 < 88f));
let _e3137 = ((_e3135 * 1.442695f) + 0.5f);
let _e3139 = select(-127f, _e3137, (_e3137 > -127f));
let _e3141 = select(128f, _e3139, (_e3139 < 128f));
let _e3148 = select(0i, select(select(i32(_e3141), i32(-2147483648), (_e3141 < -2147483600f)), 2147483647i, (_e3141 > 2147483500f)), (_e3141 == _e3141));
let _e3152 = (_e3148 - select(0i, 1i, (_e3141 < f32(_e3148))));
let _e3153 = f32(_e3152);
let _e3157 = ((_e3135 - (_e3153 * 0.6933594f)) - (_e3153 * -2.1219444e-4f));
let _e3177 = ((1f + (_e3157 * (1f + (_e3157 * (0.5f + (_e3157 * (0.16666667f + (_e3157 * (0.041666668f + (_e3157 * (0.008333334f + (_e3157 * (0.001388889f + (_e3157 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3152 + 127i)) << bitcast<u32>(23i))));
let _e3178 = (1f - _e3177);
let _e3181 = (_e3178 / select(1e-12f, _e3127, (_e3127 > 1e-12f)));
phi_6648_ = type_31(_e3177, _e3178, vec3<f32>(1f, 1f, 1f), vec3<f32>(((_e2972 + (((_e2977 + (((bitcast<f32>(((_e2959 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2977) * _e2921)) - _e2972) * _e2919)) * _e3181), ((_e3009 + (((_e3014 + (((bitcast<f32>((((_e2959 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3014) * _e2921)) - _e3009) * _e2919)) * _e3181), ((_e3074 + (((_e3079 + (((bitcast<f32>(((_e3061 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3079) * _e2921)) - _e3074) * _e2919)) * _e3181)));
} else {
let _e3188 = (_e2485 * 255f);
let _e3189 = (_e2220.member * 255f);
let _e3190 = (255f - 1f);
let _e3192 = select(0f, _e3188, (_e3188 > 0f));
let _e3194 = select(_e3190, _e3192, (_e3192 < _e3190));
let _e3201 = select(0i, select(select(i32(_e3194), i32(-2147483648), (_e3194 < -2147483600f)), 2147483647i, (_e3194 > 2147483500f)), (_e3194 == _e3194));
let _e3205 = (_e3201 - select(0i, 1i, (_e3194 < f32(_e3201))));
let _e3207 = select(0f, _e3189, (_e3189 > 0f));
let _e3209 = select(_e3190, _e3207, (_e3207 < _e3190));
let _e3216 = select(0i, select(select(i32(_e3209), i32(-2147483648), (_e3209 < -2147483600f)), 2147483647i, (_e3209 > 2147483500f)), (_e3209 == _e3209));
let _e3220 = (_e3216 - select(0i, 1i, (_e3209 < f32(_e3216))));
let _e3223 = (((_e3205 * 256i) + _e3220) * 4i);
let _e3225 = (_e3188 - f32(_e3205));
let _e3227 = (_e3189 - f32(_e3220));
let _e3229 = (bitcast<i32>(_e122) - 1i);
let _e3231 = select(_e3229, _e3223, (_e3223 < _e3229));
let _e3237 = global_3.member[bitcast<u32>(select(0i, _e3231, (_e3231 > 0i)))];
let _e3238 = (_e3223 + 4i);
let _e3240 = select(_e3229, _e3238, (_e3238 < _e3229));
let _e3246 = global_3.member[bitcast<u32>(select(0i, _e3240, (_e3240 > 0i)))];
let _e3247 = (_e3223 + 1024i);
let _e3249 = select(_e3229, _e3247, (_e3247 < _e3229));
let _e3255 = global_3.member[bitcast<u32>(select(0i, _e3249, (_e3249 > 0i)))];
let _e3256 = (_e3223 + 1028i);
let _e3258 = select(_e3229, _e3256, (_e3256 < _e3229));
let _e3264 = global_3.member[bitcast<u32>(select(0i, _e3258, (_e3258 > 0i)))];
let _e3269 = (bitcast<f32>(((_e3237 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3277 = (_e3269 + (((bitcast<f32>(((_e3246 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3269) * _e3227));
let _e3282 = (bitcast<f32>(((_e3255 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3293 = (_e3277 + (((_e3282 + (((bitcast<f32>(((_e3264 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3282) * _e3227)) - _e3277) * _e3225));
let _e3306 = (bitcast<f32>((((_e3237 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3314 = (_e3306 + (((bitcast<f32>((((_e3246 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3306) * _e3227));
let _e3319 = (bitcast<f32>((((_e3255 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3331 = (_e3223 + 1i);
let _e3333 = select(_e3229, _e3331, (_e3331 < _e3229));
let _e3339 = global_3.member[bitcast<u32>(select(0i, _e3333, (_e3333 > 0i)))];
let _e3340 = (_e3223 + 5i);
let _e3342 = select(_e3229, _e3340, (_e3340 < _e3229));
let _e3348 = global_3.member[bitcast<u32>(select(0i, _e3342, (_e3342 > 0i)))];
let _e3349 = (_e3223 + 1025i);
let _e3351 = select(_e3229, _e3349, (_e3349 < _e3229));
let _e3357 = global_3.member[bitcast<u32>(select(0i, _e3351, (_e3351 > 0i)))];
let _e3358 = (_e3223 + 1029i);
let _e3360 = select(_e3229, _e3358, (_e3358 < _e3229));
let _e3366 = global_3.member[bitcast<u32>(select(0i, _e3360, (_e3360 > 0i)))];
let _e3371 = (bitcast<f32>(((_e3339 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3379 = (_e3371 + (((bitcast<f32>(((_e3348 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3371) * _e3227));
let _e3384 = (bitcast<f32>(((_e3357 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3408 = (bitcast<f32>((((_e3339 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3416 = (_e3408 + (((bitcast<f32>((((_e3348 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3408) * _e3227));
let _e3421 = (bitcast<f32>((((_e3357 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3433 = (_e3223 + 2i);
let _e3435 = select(_e3229, _e3433, (_e3433 < _e3229));
let _e3441 = global_3.member[bitcast<u32>(select(0i, _e3435, (_e3435 > 0i)))];
let _e3442 = (_e3223 + 6i);
let _e3444 = select(_e3229, _e3442, (_e3442 < _e3229));
let _e3450 = global_3.member[bitcast<u32>(select(0i, _e3444, (_e3444 > 0i)))];
let _e3451 = (_e3223 + 1026i);
let _e3453 = select(_e3229, _e3451, (_e3451 < _e3229));
let _e3459 = global_3.member[bitcast<u32>(select(0i, _e3453, (_e3453 > 0i)))];
let _e3460 = (_e3223 + 1030i);
let _e3462 = select(_e3229, _e3460, (_e3460 < _e3229));
let _e3468 = global_3.member[bitcast<u32>(select(0i, _e3462, (_e3462 > 0i)))];
let _e3473 = (bitcast<f32>(((_e3441 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3481 = (_e3473 + (((bitcast<f32>(((_e3450 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3473) * _e3227));
let _e3486 = (bitcast<f32>(((_e3459 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3510 = (bitcast<f32>((((_e3441 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3518 = (_e3510 + (((bitcast<f32>((((_e3450 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3510) * _e3227));
let _e3523 = (bitcast<f32>((((_e3459 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3535 = (_e3223 + 3i);
let _e3537 = select(_e3229, _e3535, (_e3535 < _e3229));
let _e3543 = global_3.member[bitcast<u32>(select(0i, _e3537, (_e3537 > 0i)))];
let _e3544 = (_e3223 + 7i);
let _e3546 = select(_e3229, _e3544, (_e3544 < _e3229));
let _e3552 = global_3.member[bitcast<u32>(select(0i, _e3546, (_e3546 > 0i)))];
let _e3553 = (_e3223 + 1027i);
let _e3555 = select(_e3229, _e3553, (_e3553 < _e3229));
let _e3561 = global_3.member[bitcast<u32>(select(0i, _e3555, (_e3555 > 0i)))];
let _e3562 = (_e3223 + 1031i);
let _e3564 = select(_e3229, _e3562, (_e3562 < _e3229));
let _e3570 = global_3.member[bitcast<u32>(select(0i, _e3564, (_e3564 > 0i)))];
let _e3575 = (bitcast<f32>(((_e3543 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3583 = (_e3575 + (((bitcast<f32>(((_e3552 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3575) * _e3227));
let _e3588 = (bitcast<f32>(((_e3561 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3603 = (_e2879 * _e2774.member_1);
let _e3605 = -(((_e3314 + (((_e3319 + (((bitcast<f32>((((_e3264 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3319) * _e3227)) - _e3314) * _e3225)) * _e3603));
let _e3607 = select(-87f, _e3605, (_e3605 > -87f));
let _e3609 = select(88f, _e3607, (_e3607 < 88f));
let _e3611 = ((_e3609 * 1.442695f) + 0.5f);
let _e3613 = select(-127f, _e3611, (_e3611 > -127f));
let _e3615 = select(128f, _e3613, (_e3613 < 128f));
let _e3622 = select(0i, select(select(i32(_e3615), i32(-2147483648), (_e3615 < -2147483600f)), 2147483647i, (_e3615 > 2147483500f)), (_e3615 == _e3615));
let _e3626 = (_e3622 - select(0i, 1i, (_e3615 < f32(_e3622))));
let _e3627 = f32(_e3626);
let _e3631 = ((_e3609 - (_e3627 * 0.6933594f)) - (_e3627 * -2.1219444e-4f));
let _e3653 = -(((_e3379 + (((_e3384 + (((bitcast<f32>(((_e3366 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3384) * _e3227)) - _e3379) * _e3225)) * _e3603));
let _e3655 = select(-87f, _e3653, (_e3653 > -87f));
let _e3657 = select(88f, _e3655, (_e3655 < 88f));
let _e3659 = ((_e3657 * 1.442695f) + 0.5f);
let _e3661 = select(-127f, _e3659, (_e3659 > -127f));
let _e3663 = select(128f, _e3661, (_e3661 < 128f));
let _e3670 = select(0i, select(select(i32(_e3663), i32(-2147483648), (_e3663 < -2147483600f)), 2147483647i, (_e3663 > 2147483500f)), (_e3663 == _e3663));
let _e3674 = (_e3670 - select(0i, 1i, (_e3663 < f32(_e3670))));
let _e3675 = f32(_e3674);
let _e3679 = ((_e3657 - (_e3675 * 0.6933594f)) - (_e3675 * -2.1219444e-4f));
let _e3701 = -(((_e3416 + (((_e3421 + (((bitcast<f32>((((_e3366 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3421) * _e3227)) - _e3416) * _e3225)) * _e3603));
let _e3703 = select(-87f, _e3701, (_e3701 > -87f));
let _e3705 = select(88f, _e3703, (_e3703 < 88f));
let _e3707 = ((_e3705 * 1.442695f) + 0.5f);
let _e3709 = select(-127f, _e3707, (_e3707 > -127f));
let _e3711 = select(128f, _e3709, (_e3709 < 128f));
let _e3718 = select(0i, select(select(i32(_e3711), i32(-2147483648), (_e3711 < -2147483600f)), 2147483647i, (_e3711 > 2147483500f)), (_e3711 == _e3711));
let _e3722 = (_e3718 - select(0i, 1i, (_e3711 < f32(_e3718))));
let _e3723 = f32(_e3722);
let _e3727 = ((_e3705 - (_e3723 * 0.6933594f)) - (_e3723 * -2.1219444e-4f));
let _e3750 = -((_e3293 * (_e2879 * _e2774.member)));
let _e3752 = select(-87f, _e3750, (_e3750 > -87f));
let _e3754 = select(88f, _e3752, (_e3752 < 88f));
let _e3756 = ((_e3754 * 1.442695f) + 0.5f);
let _e3758 = select(-127f, _e3756, (_e3756 > -127f));
let _e3760 = select(128f, _e3758, (_e3758 < 128f));
let _e3767 = select(0i, select(select(i32(_e3760), i32(-2147483648), (_e3760 < -2147483600f)), 2147483647i, (_e3760 > 2147483500f)), (_e3760 == _e3760));
let _e3771 = (_e3767 - select(0i, 1i, (_e3760 < f32(_e3767))));
let _e3772 = f32(_e3771);
let _e3776 = ((_e3754 - (_e3772 * 0.6933594f)) - (_e3772 * -2.1219444e-4f));
let _e3796 = ((1f + (_e3776 * (1f + (_e3776 * (0.5f + (_e3776 * (0.16666667f + (_e3776 * (0.041666668f + (_e3776 * (0.008333334f + (_e3776 * (0.001388889f + (_e3776 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3771 + 127i)) << bitcast<u32>(23i))));
let _e3797 = (1f - _e3796);
let _e3800 = (_e3797 / select(1e-12f, _e3293, (_e3293 > 1e-12f)));
phi_6648_ = type_31(_e3796, _e3797, vec3<f32>(((1f + (_e3631 * (1f + (_e3631 * (0.5f + (_e3631 * (0.16666667f + (_e3631 * (0.041666668f + (_e3631 * (0.008333334f + (_e3631 * (0.001388889f + (_e3631 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3626 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e3679 * (1f + (_e3679 * (0.5f + (_e3679 * (0.16666667f + (_e3679 * (0.041666668f + (_e3679 * (0.008333334f + (_e3679 * (0.001388889f + (_e3679 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3674 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e3727 * (1f + (_e3727 * (0.5f + (_e3727 * (0.16666667f + (_e3727 * (0.041666668f + (_e3727 * (0.008333334f + (_e3727 * (0.001388889f + (_e3727 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3722 + 127i)) << bitcast<u32>(23i))))), vec3<f32>(((_e3481 + (((_e3486 + (((bitcast<f32>(((_e3468 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3486) * _e3227)) - _e3481) * _e3225)) * _e3800), ((_e3518 + (((_e3523 + (((bitcast<f32>((((_e3468 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3523) * _e3227)) - _e3518) * _e3225)) * _e3800), ((_e3583 + (((_e3588 + (((bitcast<f32>(((_e3570 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3588) * _e3227)) - _e3583) * _e3225)) * _e3800)));
}
let _e3807 = phi_6648_;
let _e3808 = select(0f, _e2561, _e441);
let _e3812 = (_e376 + (_e2861 * _e3808));
let _e3813 = (_e379 + (_e2862 * _e3808));
let _e3814 = (_e370 + (_e2863 * _e3808));
if (_e728.member_2 == 3u) {
let _e3820 = global_5.member[_e351].member_9.member_1;
let _e3829 = global_5.member[_e351].member_9.member;
phi_7631_ = type_25(vec3<f32>(_e3820.member, _e3820.member_1, _e3820.member_2), vec3<f32>(_e3829.member, _e3829.member_1, _e3829.member_2));
} else {
let _e3839 = global_5.member[_e351].member_8.member_8;
let _e3840 = (_e3814 - _e3839);
let _e3845 = global_5.member[_e351].member_8.member_2;
let _e3850 = global_5.member[_e351].member_8.member_6;
let _e3858 = global_5.member[_e351].member_8.member_5;
let _e3860 = (((_e3812 - (_e3845 + (_e3850 * _e3840))) * _e3858) - 0.5f);
let _e3865 = global_5.member[_e351].member_8.member_3;
let _e3870 = global_5.member[_e351].member_8.member_7;
let _e3875 = (((_e3813 - (_e3865 + (_e3870 * _e3840))) * _e3858) - 0.5f);
let _e3880 = global_5.member[_e351].member_8.member;
let _e3881 = bitcast<i32>(_e3880);
let _e3883 = (f32(_e3881) - 1f);
let _e3888 = global_5.member[_e351].member_8.member_1;
let _e3891 = (f32(bitcast<i32>(_e3888)) - 1f);
let _e3893 = select(0f, _e3860, (_e3860 > 0f));
let _e3895 = select(_e3883, _e3893, (_e3893 < _e3883));
let _e3902 = select(0i, select(select(i32(_e3895), i32(-2147483648), (_e3895 < -2147483600f)), 2147483647i, (_e3895 > 2147483500f)), (_e3895 == _e3895));
let _e3906 = (_e3902 - select(0i, 1i, (_e3895 < f32(_e3902))));
let _e3908 = select(0f, _e3875, (_e3875 > 0f));
let _e3910 = select(_e3891, _e3908, (_e3908 < _e3891));
let _e3917 = select(0i, select(select(i32(_e3910), i32(-2147483648), (_e3910 < -2147483600f)), 2147483647i, (_e3910 > 2147483500f)), (_e3910 == _e3910));
let _e3921 = (_e3917 - select(0i, 1i, (_e3910 < f32(_e3917))));
let _e3925 = (_e3860 - f32(_e3906));
let _e3927 = (_e3875 - f32(_e3921));
let _e3934 = ((((_e3860 >= 0f) && (_e3860 <= _e3883)) && (_e3875 >= 0f)) && (_e3875 <= _e3891));
let _e3938 = global_5.member[_e351].member_4;
let _e3939 = bitcast<i32>(_e3938);
let _e3941 = bitcast<i32>((_e3880 * _e3888));
let _e3943 = (_e3939 + (3i * _e3941));
local_1 = (_e3943 + ((_e3921 * _e3881) + _e3906));
let _e3945 = local_1;
let _e3947 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e3949 = select(_e3947, _e3945, (_e3945 < _e3947));
let _e3954 = global_6.member[bitcast<u32>(select(0i, _e3949, (_e3949 > 0i)))];
let _e3955 = bitcast<u32>(_e3954);
let _e3959 = f32((bitcast<i32>((_e3955 & 65535u)) - 32768i));
let _e3965 = f32((bitcast<i32>(((_e3955 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e3970 = select(_e3965, -(_e3965), ((_e3955 >> bitcast<u32>(31i)) != 0u));
let _e3971 = local_1;
let _e3972 = (_e3971 + 1i);
let _e3974 = select(_e3947, _e3972, (_e3972 < _e3947));
let _e3979 = global_6.member[bitcast<u32>(select(0i, _e3974, (_e3974 > 0i)))];
let _e3980 = bitcast<u32>(_e3979);
let _e3990 = f32((bitcast<i32>(((_e3980 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e3996 = local_1;
let _e3997 = (_e3996 + _e3881);
let _e3999 = select(_e3947, _e3997, (_e3997 < _e3947));
let _e4004 = global_6.member[bitcast<u32>(select(0i, _e3999, (_e3999 > 0i)))];
let _e4005 = bitcast<u32>(_e4004);
let _e4009 = f32((bitcast<i32>((_e4005 & 65535u)) - 32768i));
let _e4015 = f32((bitcast<i32>(((_e4005 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4020 = select(_e4015, -(_e4015), ((_e4005 >> bitcast<u32>(31i)) != 0u));
let _e4021 = (_e3881 + 1i);
let _e4022 = local_1;
let _e4023 = (_e4022 + _e4021);
let _e4025 = select(_e3947, _e4023, (_e4023 < _e3947));
let _e4030 = global_6.member[bitcast<u32>(select(0i, _e4025, (_e4025 > 0i)))];
let _e4031 = bitcast<u32>(_e4030);
let _e4041 = f32((bitcast<i32>(((_e4031 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4049 = (_e3959 + ((f32((bitcast<i32>((_e3980 & 65535u)) - 32768i)) - _e3959) * _e3925));
let _e4058 = (_e3970 + ((select(_e3990, -(_e3990), ((_e3980 >> bitcast<u32>(31i)) != 0u)) - _e3970) * _e3925));
let _e4071 = global_5.member[_e351].member_9.member;
let _e4074 = (1f / 16255f);
let _e4076 = (_e4071.member + (select(0f, (_e4049 + (((_e4009 + ((f32((bitcast<i32>((_e4031 & 65535u)) - 32768i)) - _e4009) * _e3925)) - _e4049) * _e3927)), _e3934) * _e4074));
let _e4078 = (_e4071.member_1 + (select(0f, (_e4058 + (((_e4020 + ((select(_e4041, -(_e4041), ((_e4031 >> bitcast<u32>(31i)) != 0u)) - _e4020) * _e3925)) - _e4058) * _e3927)), _e3934) * _e4074));
let _e4082 = (1f - ((_e4076 * _e4076) + (_e4078 * _e4078)));
let _e4084 = select(1e-4f, _e4082, (_e4082 > 1e-4f));
let _e4087 = sqrt(select(0f, _e4084, (_e4084 > 0f)));
let _e4091 = (1f / select(1e-6f, _e4087, (_e4087 > 1e-6f)));
let _e4092 = ((_e3814 - _e370) * _e3858);
let _e4099 = (_e3860 - (((_e4076 * _e4091) - _e3850) * _e4092));
let _e4100 = (_e3875 - (((_e4078 * _e4091) - _e3870) * _e4092));
let _e4102 = select(0f, _e4099, (_e4099 > 0f));
let _e4104 = select(_e3883, _e4102, (_e4102 < _e3883));
let _e4111 = select(0i, select(select(i32(_e4104), i32(-2147483648), (_e4104 < -2147483600f)), 2147483647i, (_e4104 > 2147483500f)), (_e4104 == _e4104));
let _e4115 = (_e4111 - select(0i, 1i, (_e4104 < f32(_e4111))));
let _e4117 = select(0f, _e4100, (_e4100 > 0f));
let _e4119 = select(_e3891, _e4117, (_e4117 < _e3891));
let _e4126 = select(0i, select(select(i32(_e4119), i32(-2147483648), (_e4119 < -2147483600f)), 2147483647i, (_e4119 > 2147483500f)), (_e4119 == _e4119));
let _e4130 = (_e4126 - select(0i, 1i, (_e4119 < f32(_e4126))));
let _e4132 = ((_e4130 * _e3881) + _e4115);
let _e4134 = (_e4099 - f32(_e4115));
let _e4136 = (_e4100 - f32(_e4130));
let _e4143 = ((((_e4099 >= 0f) && (_e4099 <= _e3883)) && (_e4100 >= 0f)) && (_e4100 <= _e3891));
let _e4144 = (_e3939 + _e4132);
let _e4146 = select(_e3947, _e4144, (_e4144 < _e3947));
let _e4152 = global_6.member[bitcast<u32>(select(0i, _e4146, (_e4146 > 0i)))];
let _e4153 = (_e4144 + 1i);
let _e4155 = select(_e3947, _e4153, (_e4153 < _e3947));
let _e4161 = global_6.member[bitcast<u32>(select(0i, _e4155, (_e4155 > 0i)))];
let _e4164 = (_e4152 + ((_e4161 - _e4152) * _e4134));
let _e4165 = (_e4144 + _e3881);
let _e4167 = select(_e3947, _e4165, (_e4165 < _e3947));
let _e4173 = global_6.member[bitcast<u32>(select(0i, _e4167, (_e4167 > 0i)))];
let _e4174 = (_e4165 + 1i);
let _e4176 = select(_e3947, _e4174, (_e4174 < _e3947));
let _e4182 = global_6.member[bitcast<u32>(select(0i, _e4176, (_e4176 > 0i)))];
let _e4189 = select(1f, (_e4164 + (((_e4173 + ((_e4182 - _e4173) * _e4134)) - _e4164) * _e4136)), _e4143);
if _e2880 {
phi_7401_ = vec3(_e4189);
} else {
let _e4192 = ((_e3939 + _e3941) + _e4132);
let _e4194 = select(_e3947, _e4192, (_e4192 < _e3947));
let _e4200 = global_6.member[bitcast<u32>(select(0i, _e4194, (_e4194 > 0i)))];
let _e4201 = (_e4192 + 1i);
let _e4203 = select(_e3947, _e4201, (_e4201 < _e3947));
let _e4209 = global_6.member[bitcast<u32>(select(0i, _e4203, (_e4203 > 0i)))];
let _e4212 = (_e4200 + ((_e4209 - _e4200) * _e4134));
let _e4213 = (_e4192 + _e3881);
let _e4215 = select(_e3947, _e4213, (_e4213 < _e3947));
let _e4221 = global_6.member[bitcast<u32>(select(0i, _e4215, (_e4215 > 0i)))];
let _e4222 = (_e4213 + 1i);
let _e4224 = select(_e3947, _e4222, (_e4222 < _e3947));
let _e4230 = global_6.member[bitcast<u32>(select(0i, _e4224, (_e4224 > 0i)))];
let _e4240 = ((_e3939 + (2i * _e3941)) + _e4132);
let _e4242 = select(_e3947, _e4240, (_e4240 < _e3947));
let _e4248 = global_6.member[bitcast<u32>(select(0i, _e4242, (_e4242 > 0i)))];
let _e4249 = (_e4240 + 1i);
let _e4251 = select(_e3947, _e4249, (_e4249 < _e3947));
let _e4257 = global_6.member[bitcast<u32>(select(0i, _e4251, (_e4251 > 0i)))];
let _e4260 = (_e4248 + ((_e4257 - _e4248) * _e4134));
let _e4261 = (_e4240 + _e3881);
let _e4263 = select(_e3947, _e4261, (_e4261 < _e3947));
let _e4269 = global_6.member[bitcast<u32>(select(0i, _e4263, (_e4263 > 0i)))];
let _e4270 = (_e4261 + 1i);
let _e4272 = select(_e3947, _e4270, (_e4270 < _e3947));
let _e4278 = global_6.member[bitcast<u32>(select(0i, _e4272, (_e4272 > 0i)))];
phi_7401_ = vec3<f32>(_e4189, select(1f, (_e4212 + (((_e4221 + ((_e4230 - _e4221) * _e4134)) - _e4212) * _e4136)), _e4143), select(1f, (_e4260 + (((_e4269 + ((_e4278 - _e4269) * _e4134)) - _e4260) * _e4136)), _e4143));
}
let _e4288 = phi_7401_;
local = (_e3943 + _e4132);
let _e4290 = local;
let _e4292 = select(_e3947, _e4290, (_e4290 < _e3947));
let _e4297 = global_6.member[bitcast<u32>(select(0i, _e4292, (_e4292 > 0i)))];
let _e4298 = bitcast<u32>(_e4297);
let _e4302 = f32((bitcast<i32>((_e4298 & 65535u)) - 32768i));
let _e4308 = f32((bitcast<i32>(((_e4298 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4313 = select(_e4308, -(_e4308), ((_e4298 >> bitcast<u32>(31i)) != 0u));
let _e4314 = local;
let _e4315 = (_e4314 + 1i);
let _e4317 = select(_e3947, _e4315, (_e4315 < _e3947));
let _e4322 = global_6.member[bitcast<u32>(select(0i, _e4317, (_e4317 > 0i)))];
let _e4323 = bitcast<u32>(_e4322);
let _e4333 = f32((bitcast<i32>(((_e4323 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4339 = local;
let _e4340 = (_e4339 + _e3881);
let _e4342 = select(_e3947, _e4340, (_e4340 < _e3947));
let _e4347 = global_6.member[bitcast<u32>(select(0i, _e4342, (_e4342 > 0i)))];
let _e4348 = bitcast<u32>(_e4347);
let _e4352 = f32((bitcast<i32>((_e4348 & 65535u)) - 32768i));
let _e4358 = f32((bitcast<i32>(((_e4348 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4363 = select(_e4358, -(_e4358), ((_e4348 >> bitcast<u32>(31i)) != 0u));
let _e4364 = local;
let _e4365 = (_e4364 + _e4021);
let _e4367 = select(_e3947, _e4365, (_e4365 < _e3947));
let _e4372 = global_6.member[bitcast<u32>(select(0i, _e4367, (_e4367 > 0i)))];
let _e4373 = bitcast<u32>(_e4372);
let _e4383 = f32((bitcast<i32>(((_e4373 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4391 = (_e4302 + ((f32((bitcast<i32>((_e4323 & 65535u)) - 32768i)) - _e4302) * _e4134));
let _e4400 = (_e4313 + ((select(_e4333, -(_e4333), ((_e4323 >> bitcast<u32>(31i)) != 0u)) - _e4313) * _e4134));
let _e4413 = global_5.member[_e351].member_9.member_1;
let _e4420 = (_e4071.member + (select(0f, (_e4391 + (((_e4352 + ((f32((bitcast<i32>((_e4373 & 65535u)) - 32768i)) - _e4352) * _e4134)) - _e4391) * _e4136)), _e4143) * _e4074));
let _e4422 = (_e4071.member_1 + (select(0f, (_e4400 + (((_e4363 + ((select(_e4383, -(_e4383), ((_e4373 >> bitcast<u32>(31i)) != 0u)) - _e4363) * _e4134)) - _e4400) * _e4136)), _e4143) * _e4074));
let _e4426 = (1f - ((_e4420 * _e4420) + (_e4422 * _e4422)));
let _e4428 = select(1e-4f, _e4426, (_e4426 > 1e-4f));
phi_7631_ = type_25((_e4288 * vec3<f32>(_e4413.member, _e4413.member_1, _e4413.member_2)), vec3<f32>(_e4420, _e4422, sqrt(select(0f, _e4428, (_e4428 > 0f)))));
}
let _e4435 = phi_7631_;
let _e4444 = (((_e4435.member_1.x * _e4435.member_1.x) + (_e4435.member_1.y * _e4435.member_1.y)) + (_e4435.member_1.z * _e4435.member_1.z));
let _e4447 = sqrt(select(0f, _e4444, (_e4444 > 0f)));
let _e4453 = (1e-6f * _e4447);
let _e4457 = select((_e4447 / select(_e4453, _e4435.member_1.z, (_e4435.member_1.z > _e4453))), 1f, ((_e684 & 8u) != 0u));
let _e4459 = (_e4435.member.x * _e4457);
let _e4461 = (_e4435.member.y * _e4457);
let _e4463 = (_e4435.member.z * _e4457);
if _e791 {
let _e4468 = global_5.member[_e351].member_19;
let _e4477 = (((_e2220.member_1.x * _e2220.member_1.x) + (_e2220.member_1.y * _e2220.member_1.y)) + (_e2220.member_1.z * _e2220.member_1.z));
let _e4480 = sqrt(select(0f, _e4477, (_e4477 > 0f)));
let _e4483 = (1f / select(1e-20f, _e4480, (_e4480 > 1e-20f)));
let _e4484 = (_e2220.member_1.x * _e4483);
let _e4485 = (_e2220.member_1.y * _e4483);
let _e4486 = (_e2220.member_1.z * _e4483);
let _e4489 = (-1f / select(1e-20f, _e4447, (_e4447 > 1e-20f)));
let _e4490 = (_e4435.member_1.x * _e4489);
let _e4491 = (_e4435.member_1.y * _e4489);
let _e4492 = (_e4435.member_1.z * _e4489);
let _e4497 = (((_e355[2] * _e355[2]) + (_e355[3] * _e355[3])) + (_e355[4] * _e355[4]));
let _e4500 = sqrt(select(0f, _e4497, (_e4497 > 0f)));
let _e4503 = (-1f / select(1e-20f, _e4500, (_e4500 > 1e-20f)));
let _e4504 = (_e355[2] * _e4503);
let _e4505 = (_e355[3] * _e4503);
let _e4506 = (_e355[4] * _e4503);
let _e4513 = select(1f, -1f, ((((_e4484 * _e4504) + (_e4485 * _e4505)) + (_e4486 * _e4506)) < 0f));
let _e4514 = (_e4484 * _e4513);
let _e4515 = (_e4485 * _e4513);
let _e4516 = (_e4486 * _e4513);
let _e4521 = (((_e4514 * _e4504) + (_e4515 * _e4505)) + (_e4516 * _e4506));
let _e4523 = select(1e-4f, _e4521, (_e4521 > 1e-4f));
let _e4528 = (((_e4514 * _e4490) + (_e4515 * _e4491)) + (_e4516 * _e4492));
let _e4529 = (_e4490 + _e4504);
let _e4530 = (_e4491 + _e4505);
let _e4531 = (_e4492 + _e4506);
let _e4536 = (((_e4529 * _e4529) + (_e4530 * _e4530)) + (_e4531 * _e4531));
let _e4539 = sqrt(select(0f, _e4536, (_e4536 > 0f)));
let _e4542 = (1f / select(1e-6f, _e4539, (_e4539 > 1e-6f)));
let _e4543 = (_e4529 * _e4542);
let _e4544 = (_e4530 * _e4542);
let _e4545 = (_e4531 * _e4542);
let _e4550 = (((_e4514 * _e4543) + (_e4515 * _e4544)) + (_e4516 * _e4545));
let _e4552 = select(0f, _e4550, (_e4550 > 0f));
let _e4557 = (((_e4504 * _e4543) + (_e4505 * _e4544)) + (_e4506 * _e4545));
let _e4559 = select(0f, _e4557, (_e4557 > 0f));
let _e4560 = (_e4468 * _e4468);
let _e4561 = (_e4560 * _e4560);
let _e4565 = (((_e4552 * _e4552) * (_e4561 - 1f)) + 1f);
let _e4569 = (_e4528 > 0f);
let _e4570 = select(0f, _e4528, _e4569);
let _e4572 = (1f - _e4561);
let _e4574 = (((_e4570 * _e4570) * _e4572) + _e4561);
let _e4581 = (((_e4523 * _e4523) * _e4572) + _e4561);
let _e4586 = ((_e4523 * sqrt(select(0f, _e4574, (_e4574 > 0f)))) + (_e4570 * sqrt(select(0f, _e4581, (_e4581 > 0f)))));
let _e4591 = (_e2220.member_2 / _e2558);
let _e4595 = (((_e4591 * _e4591) - 1f) + (_e4559 * _e4559));
let _e4598 = sqrt(select(0f, _e4595, (_e4595 > 0f)));
let _e4599 = (_e4598 - _e4559);
let _e4600 = (_e4598 + _e4559);
let _e4603 = (_e4599 / select(1e-6f, _e4600, (_e4600 > 1e-6f)));
let _e4607 = ((_e4559 * _e4599) + 1f);
let _e4610 = (((_e4559 * _e4600) - 1f) / select(1e-6f, _e4607, (_e4607 > 1e-6f)));
let _e4628 = global_5.member[_e351].member_20;
let _e4632 = ((select(0f, ((((_e4561 / ((3.1415927f * _e4565) * _e4565)) * (0.5f / select(1e-6f, _e4586, (_e4586 > 1e-6f)))) * select(select((((0.5f * _e4603) * _e4603) * (1f + (_e4610 * _e4610))), 1f, (_e4595 <= 0f)), 0f, (_e2558 == _e2220.member_2))) * _e4570), (_e4569 && (_e4480 > 1e-12f))) * _e4628) * select(_e2774.member_2, 0f, _e441));
phi_7949_ = vec3<f32>((_e4459 * _e4632), (_e4461 * _e4632), (_e4463 * _e4632));
} else {
phi_7949_ = vec3<f32>(0f, 0f, 0f);
}
let _e4638 = phi_7949_;
let _e4649 = global_5.member[_e351].member_18;
let _e4656 = (1f - _e355[11]);
let _e4676 = (_e355[8] + ((_e355[12] * ((_e3807.member_3.x * (_e4459 + _e4649.member)) + _e4638.x)) * _e4656));
let _e4677 = (_e355[9] + ((_e355[13] * ((_e3807.member_3.y * (_e4461 + _e4649.member_1)) + _e4638.y)) * _e4656));
let _e4678 = (_e355[10] + ((_e355[14] * ((_e3807.member_3.z * (_e4463 + _e4649.member_2)) + _e4638.z)) * _e4656));
let _e4681 = (_e355[11] + (_e4656 * _e3807.member_1));
let _e4684 = (_e355[12] * _e3807.member_2.x);
let _e4686 = (_e355[13] * _e3807.member_2.y);
let _e4688 = (_e355[14] * _e3807.member_2.z);
let _e4694 = (_e355[7] + ((_e4681 - _e355[11]) * (_e370 + (_e2863 * 0.5f))));
let _e4703 = (-((((select(_e761.member, _e748.member, _e741) * _e4435.member_1.x) + (select(_e761.member_1, _e748.member_1, _e741) * _e4435.member_1.y)) + (select(_e761.member_2, _e748.member_2, _e741) * _e4435.member_1.z))) / select(1e-20f, _e4447, (_e4447 > 1e-20f)));
let _e4708 = bitcast<f32>((bitcast<u32>(select(0f, _e4703, (_e4703 > 0f))) & 2147483647u));
let _e4718 = (1f - _e4681);
let _e4731 = select(_e4681, 1f, _e441);
if _e791 {
let _e4740 = global_5.member[_e351].member_5.member_4;
let _e4743 = (_e2220.member_3.x * _e2774.member_2);
let _e4745 = (_e2220.member_3.y * _e2774.member_2);
let _e4747 = (_e2220.member_3.z * _e2774.member_2);
let _e4748 = (0.5f * _e365);
let _e4752 = (_e355[2] + (_e4743 * _e4748));
let _e4753 = (_e355[3] + (_e4745 * _e4748));
let _e4754 = (_e355[4] + (_e4747 * _e4748));
let _e4756 = (2f * _e364);
let _e4758 = ((_e4754 * _e4754) + (_e4756 * _e4747));
let _e4762 = (_e4754 + sqrt(select(0f, _e4758, (_e4758 > 0f))));
let _e4766 = (0.5f * (_e4756 / select(1e-6f, _e4762, (_e4762 > 1e-6f))));
let _e4770 = (_e4752 + (_e4743 * _e4766));
let _e4771 = (_e4753 + (_e4745 * _e4766));
let _e4772 = (_e4754 + (_e4747 * _e4766));
let _e4776 = (_e4740 * _e4740);
let _e4778 = (_e4772 * _e4772);
let _e4786 = (((_e4754 <= 0f) || (_e4758 <= 0f)) || ((_e4772 <= 0f) || (_e4778 <= (_e4776 * (((_e4770 * _e4770) + (_e4771 * _e4771)) + _e4778)))));
let _e4800 = (_e355[2] + ((_e2220.member_4.x * _e2774.member_2) * _e364));
let _e4801 = (_e355[3] + ((_e2220.member_4.y * _e2774.member_2) * _e364));
let _e4802 = (_e355[4] + ((_e2220.member_4.z * _e2774.member_2) * _e364));
let _e4804 = (_e4802 * _e4802);
let _e4813 = ((_e684 & 1u) != 0u);
phi_8258_ = select(select(_e4772, _e4754, _e4786), _e4802, _e4813);
phi_8259_ = select(select(_e4771, _e4753, _e4786), _e4801, _e4813);
phi_8260_ = select(select(_e4770, _e4752, _e4786), _e4800, _e4813);
phi_8261_ = select(_e4786, ((_e4802 <= 0f) || (_e4804 <= (_e4776 * (((_e4800 * _e4800) + (_e4801 * _e4801)) + _e4804)))), _e4813);
} else {
phi_8258_ = _e355[4];
phi_8259_ = _e355[3];
phi_8260_ = _e355[2];
phi_8261_ = false;
}
let _e4819 = phi_8258_;
let _e4821 = phi_8259_;
let _e4823 = phi_8260_;
let _e4825 = phi_8261_;
let _e4831 = (((_e441 || (_e4823 != _e355[2])) || (_e4821 != _e355[3])) || (_e4819 != _e355[4]));
let _e4833 = select(_e4686, _e4684, (_e4684 > _e4686));
phi_8321_ = array<f32, 18>(select(_e355[0], select(_e381, _e3812, _e441), _e4831), select(_e355[1], select(_e383, _e3813, _e441), _e4831), _e4823, _e4821, _e4819, _e2220.member, select(select(0f, 2f, _e4825), 1f, (_e441 || (((1f - _e4731) * select(_e4688, _e4833, (_e4833 > _e4688))) < 9.765625e-4f))), select(_e4694, (_e4694 + (_e4718 * _e3814)), _e441), select(_e4676, (_e4676 + ((_e4684 * (select(_e767.member, _e754.member, _e741) * ((_e4459 * _e4708) + _e4649.member))) * _e4718)), _e441), select(_e4677, (_e4677 + ((_e4686 * (select(_e767.member_1, _e754.member_1, _e741) * ((_e4461 * _e4708) + _e4649.member_1))) * _e4718)), _e441), select(_e4678, (_e4678 + ((_e4688 * (select(_e767.member_2, _e754.member_2, _e741) * ((_e4463 * _e4708) + _e4649.member_2))) * _e4718)), _e441), _e4731, _e4684, _e4686, _e4688, _e2220.member_2, select(_e355[16], select(_e388, _e3814, _e441), _e4831), _e388);
} else {
phi_8321_ = _e355;
}
let _e4852 = phi_8321_;
phi_580_ = (_e351 + 1u);
phi_583_ = select(_e353, true, _e724);
phi_585_ = _e4852;
} else {
phi_580_ = u32();
phi_583_ = bool();
phi_585_ = array<f32, 18>();
}
let _e4856 = phi_580_;
let _e4858 = phi_583_;
let _e4860 = phi_585_;
continue;
continuing {
phi_579_ = _e4856;
phi_582_ = _e4858;
phi_584_ = _e4860;
phi_8404_ = false;
break if !(_e356);
}
}
let _e4863 = phi_8404_;
if _e4863 {
break;
}
let _e4865 = local_8;
if _e4865 {
let _e4867 = local_9;
global_4.member[_e151] = _e4867[0];
let _e4872 = local_10;
global_4.member[_e163] = _e4872[1];
let _e4877 = local_11;
global_4.member[_e174] = _e4877[2];
let _e4882 = local_12;
global_4.member[_e185] = _e4882[3];
let _e4887 = local_13;
global_4.member[_e196] = _e4887[4];
let _e4892 = local_14;
global_4.member[_e207] = _e4892[5];
let _e4897 = local_15;
global_4.member[_e218] = _e4897[6];
let _e4902 = local_16;
global_4.member[_e229] = _e4902[7];
let _e4907 = local_17;
global_4.member[_e240] = _e4907[8];
let _e4912 = local_18;
global_4.member[_e251] = _e4912[9];
let _e4917 = local_19;
global_4.member[_e262] = _e4917[10];
let _e4922 = local_20;
global_4.member[_e273] = _e4922[11];
let _e4927 = local_21;
global_4.member[_e284] = _e4927[12];
let _e4932 = local_22;
global_4.member[_e295] = _e4932[13];
let _e4937 = local_23;
global_4.member[_e306] = _e4937[14];
let _e4942 = local_24;
global_4.member[_e317] = _e4942[15];
let _e4947 = local_25;
global_4.member[_e328] = _e4947[16];
let _e4952 = local_26;
global_4.member[_e339] = _e4952[17];
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
