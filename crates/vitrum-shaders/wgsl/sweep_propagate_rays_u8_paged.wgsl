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
var phi_586_: u32;
var phi_589_: bool;
var phi_591_: array<f32, 18>;
var phi_3616_: type_29;
var phi_4318_: type_30;
var phi_4957_: f32;
var phi_5346_: type_5;
var phi_6904_: type_31;
var phi_7657_: vec3<f32>;
var phi_7887_: type_25;
var phi_8205_: vec3<f32>;
var phi_8510_: vec3<f32>;
var phi_8511_: bool;
var phi_8576_: array<f32, 18>;
var phi_587_: u32;
var phi_590_: bool;
var phi_592_: array<f32, 18>;
var phi_8659_: bool;
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
let _e116 = global;
let _e118 = arrayLength((&global_5.member));
let _e121 = arrayLength((&global_1.member));
let _e125 = arrayLength((&global_3.member));
if (0u < _e118) {
} else {
break;
}
let _e135 = global_5.member[0u].member_2;
let _e139 = global_5.member[0u].member;
let _e147 = (_e116.x + _e135.member);
let _e149 = (_e116.y + _e135.member_1);
if (_e147 < _e135.member_2) {
if (_e149 < _e135.member_3) {
let _e152 = (_e139.member * _e139.member_1);
let _e154 = ((_e149 * _e139.member) + _e147);
let _e155 = bitcast<i32>(_e154);
let _e157 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e159 = select(_e157, _e155, (_e155 < _e157));
let _e165 = global_4.member[bitcast<u32>(select(0i, _e159, (_e159 > 0i)))];
let _e166 = (_e152 + _e154);
let _e167 = bitcast<i32>(_e166);
let _e169 = select(_e157, _e167, (_e167 < _e157));
let _e175 = global_4.member[bitcast<u32>(select(0i, _e169, (_e169 > 0i)))];
let _e177 = ((2u * _e152) + _e154);
let _e178 = bitcast<i32>(_e177);
let _e180 = select(_e157, _e178, (_e178 < _e157));
let _e186 = global_4.member[bitcast<u32>(select(0i, _e180, (_e180 > 0i)))];
let _e188 = ((3u * _e152) + _e154);
let _e189 = bitcast<i32>(_e188);
let _e191 = select(_e157, _e189, (_e189 < _e157));
let _e197 = global_4.member[bitcast<u32>(select(0i, _e191, (_e191 > 0i)))];
let _e199 = ((4u * _e152) + _e154);
let _e200 = bitcast<i32>(_e199);
let _e202 = select(_e157, _e200, (_e200 < _e157));
let _e208 = global_4.member[bitcast<u32>(select(0i, _e202, (_e202 > 0i)))];
let _e210 = ((5u * _e152) + _e154);
let _e211 = bitcast<i32>(_e210);
let _e213 = select(_e157, _e211, (_e211 < _e157));
let _e219 = global_4.member[bitcast<u32>(select(0i, _e213, (_e213 > 0i)))];
let _e221 = ((6u * _e152) + _e154);
let _e222 = bitcast<i32>(_e221);
let _e224 = select(_e157, _e222, (_e222 < _e157));
let _e230 = global_4.member[bitcast<u32>(select(0i, _e224, (_e224 > 0i)))];
let _e232 = ((7u * _e152) + _e154);
let _e233 = bitcast<i32>(_e232);
let _e235 = select(_e157, _e233, (_e233 < _e157));
let _e241 = global_4.member[bitcast<u32>(select(0i, _e235, (_e235 > 0i)))];
let _e243 = ((8u * _e152) + _e154);
let _e244 = bitcast<i32>(_e243);
let _e246 = select(_e157, _e244, (_e244 < _e157));
let _e252 = global_4.member[bitcast<u32>(select(0i, _e246, (_e246 > 0i)))];
let _e254 = ((9u * _e152) + _e154);
let _e255 = bitcast<i32>(_e254);
let _e257 = select(_e157, _e255, (_e255 < _e157));
let _e263 = global_4.member[bitcast<u32>(select(0i, _e257, (_e257 > 0i)))];
let _e265 = ((10u * _e152) + _e154);
let _e266 = bitcast<i32>(_e265);
let _e268 = select(_e157, _e266, (_e266 < _e157));
let _e274 = global_4.member[bitcast<u32>(select(0i, _e268, (_e268 > 0i)))];
let _e276 = ((11u * _e152) + _e154);
let _e277 = bitcast<i32>(_e276);
let _e279 = select(_e157, _e277, (_e277 < _e157));
let _e285 = global_4.member[bitcast<u32>(select(0i, _e279, (_e279 > 0i)))];
let _e287 = ((12u * _e152) + _e154);
let _e288 = bitcast<i32>(_e287);
let _e290 = select(_e157, _e288, (_e288 < _e157));
let _e296 = global_4.member[bitcast<u32>(select(0i, _e290, (_e290 > 0i)))];
let _e298 = ((13u * _e152) + _e154);
let _e299 = bitcast<i32>(_e298);
let _e301 = select(_e157, _e299, (_e299 < _e157));
let _e307 = global_4.member[bitcast<u32>(select(0i, _e301, (_e301 > 0i)))];
let _e309 = ((14u * _e152) + _e154);
let _e310 = bitcast<i32>(_e309);
let _e312 = select(_e157, _e310, (_e310 < _e157));
let _e318 = global_4.member[bitcast<u32>(select(0i, _e312, (_e312 > 0i)))];
let _e320 = ((15u * _e152) + _e154);
let _e321 = bitcast<i32>(_e320);
let _e323 = select(_e157, _e321, (_e321 < _e157));
let _e329 = global_4.member[bitcast<u32>(select(0i, _e323, (_e323 > 0i)))];
let _e331 = ((16u * _e152) + _e154);
let _e332 = bitcast<i32>(_e331);
let _e334 = select(_e157, _e332, (_e332 < _e157));
let _e340 = global_4.member[bitcast<u32>(select(0i, _e334, (_e334 > 0i)))];
let _e342 = ((17u * _e152) + _e154);
let _e343 = bitcast<i32>(_e342);
let _e345 = select(_e157, _e343, (_e343 < _e157));
let _e351 = global_4.member[bitcast<u32>(select(0i, _e345, (_e345 > 0i)))];
phi_586_ = 0u;
phi_589_ = false;
phi_591_ = array<f32, 18>(_e165, _e175, _e186, _e197, _e208, _e219, _e230, _e241, _e252, _e263, _e274, _e285, _e296, _e307, _e318, _e329, _e340, _e351);
loop {
let _e354 = phi_586_;
let _e356 = phi_589_;
let _e358 = phi_591_;
local_8 = _e356;
local_9 = _e358;
local_10 = _e358;
local_11 = _e358;
local_12 = _e358;
local_13 = _e358;
local_14 = _e358;
local_15 = _e358;
local_16 = _e358;
local_17 = _e358;
local_18 = _e358;
local_19 = _e358;
local_20 = _e358;
local_21 = _e358;
local_22 = _e358;
local_23 = _e358;
local_24 = _e358;
local_25 = _e358;
local_26 = _e358;
let _e359 = (_e354 < _e118);
if _e359 {
if _e359 {
} else {
phi_8659_ = true;
break;
}
let _e372 = global_5.member[_e354].member_5.member_2;
let _e373 = (_e372 / _e358[5]);
let _e378 = global_5.member[_e354].member_5.member;
let _e380 = ((_e378 - _e358[2]) / _e358[5]);
let _e382 = (_e358[0] + (_e358[3] * _e380));
let _e384 = (_e358[1] + (_e358[4] * _e380));
let _e386 = (_e382 + (_e358[3] * _e373));
let _e388 = (_e384 + (_e358[4] * _e373));
let _e393 = global_5.member[_e354].member_5.member_1;
let _e399 = global_5.member[_e354].member_13.member.member;
let _e410 = ((((_e399.member.member * _e382) + (_e399.member.member_1 * _e384)) + (_e399.member.member_2 * _e378)) + _e399.member_1);
let _e416 = ((((_e399.member.member * _e386) + (_e399.member.member_1 * _e388)) + (_e399.member.member_2 * _e393)) + _e399.member_1);
let _e419 = ((_e410 > 0f) && (_e416 <= 0f));
let _e425 = global_5.member[_e354].member_13.member_1.member;
let _e436 = ((((_e425.member.member * _e382) + (_e425.member.member_1 * _e384)) + (_e425.member.member_2 * _e378)) + _e425.member_1);
let _e442 = ((((_e425.member.member * _e386) + (_e425.member.member_1 * _e388)) + (_e425.member.member_2 * _e393)) + _e425.member_1);
let _e445 = ((_e436 > 0f) && (_e442 <= 0f));
let _e446 = (_e419 || _e445);
let _e451 = global_5.member[_e354].member_6.member;
let _e462 = ((((_e451.member.member * _e382) + (_e451.member.member_1 * _e384)) + (_e451.member.member_2 * _e378)) + _e451.member_1);
let _e467 = global_5.member[_e354].member_6.member_1;
let _e478 = ((((_e467.member.member * _e382) + (_e467.member.member_1 * _e384)) + (_e467.member.member_2 * _e378)) + _e467.member_1);
let _e483 = global_5.member[_e354].member_6.member_2;
let _e494 = ((((_e483.member.member * _e382) + (_e483.member.member_1 * _e384)) + (_e483.member.member_2 * _e378)) + _e483.member_1);
let _e500 = ((((_e451.member.member * _e386) + (_e451.member.member_1 * _e388)) + (_e451.member.member_2 * _e393)) + _e451.member_1);
let _e506 = ((((_e467.member.member * _e386) + (_e467.member.member_1 * _e388)) + (_e467.member.member_2 * _e393)) + _e467.member_1);
let _e512 = ((((_e483.member.member * _e386) + (_e483.member.member_1 * _e388)) + (_e483.member.member_2 * _e393)) + _e483.member_1);
let _e517 = global_5.member[_e354].member_6.member_4;
let _e523 = global_5.member[_e354].member_6.member_3.member;
let _e524 = (_e523 - 0.5f);
let _e526 = select(-0.5f, _e500, (_e500 > -0.5f));
let _e528 = select(_e524, _e526, (_e526 < _e524));
let _e534 = global_5.member[_e354].member_6.member_3.member_1;
let _e535 = (_e534 - 0.5f);
let _e537 = select(-0.5f, _e506, (_e506 > -0.5f));
let _e539 = select(_e535, _e537, (_e537 < _e535));
let _e545 = global_5.member[_e354].member_6.member_3.member_2;
let _e546 = (_e545 - 0.5f);
let _e548 = select(-0.5f, _e512, (_e512 > -0.5f));
let _e550 = select(_e546, _e548, (_e548 < _e546));
let _e551 = (_e500 - _e462);
let _e552 = (_e506 - _e478);
let _e553 = (_e512 - _e494);
let _e556 = bitcast<f32>((bitcast<u32>(_e551) & 2147483647u));
let _e559 = bitcast<f32>((bitcast<u32>(_e552) & 2147483647u));
let _e561 = select(_e559, _e556, (_e556 > _e559));
let _e564 = bitcast<f32>((bitcast<u32>(_e553) & 2147483647u));
let _e573 = bitcast<f32>((bitcast<u32>((_e500 - _e528)) & 2147483647u));
let _e576 = bitcast<f32>((bitcast<u32>((_e506 - _e539)) & 2147483647u));
let _e578 = select(_e576, _e573, (_e573 > _e576));
let _e581 = bitcast<f32>((bitcast<u32>((_e512 - _e550)) & 2147483647u));
let _e585 = (_e528 + 0.5f);
let _e586 = (_e523 - 1f);
let _e588 = select(0f, _e585, (_e585 > 0f));
let _e590 = select(_e586, _e588, (_e588 < _e586));
let _e597 = select(0i, select(select(i32(_e590), i32(-2147483648), (_e590 < -2147483600f)), 2147483647i, (_e590 > 2147483500f)), (_e590 == _e590));
let _e606 = global_5.member[_e354].member_6.member_12;
let _e607 = (_e606 & 31u);
let _e610 = (_e539 + 0.5f);
let _e611 = (_e534 - 1f);
let _e613 = select(0f, _e610, (_e610 > 0f));
let _e615 = select(_e611, _e613, (_e613 < _e611));
let _e622 = select(0i, select(select(i32(_e615), i32(-2147483648), (_e615 < -2147483600f)), 2147483647i, (_e615 > 2147483500f)), (_e615 == _e615));
let _e629 = (_e550 + 0.5f);
let _e630 = (_e545 - 1f);
let _e632 = select(0f, _e629, (_e629 > 0f));
let _e634 = select(_e630, _e632, (_e632 < _e630));
let _e641 = select(0i, select(select(i32(_e634), i32(-2147483648), (_e634 < -2147483600f)), 2147483647i, (_e634 > 2147483500f)), (_e634 == _e634));
let _e653 = global_5.member[_e354].member_6.member_9.member;
let _e660 = global_5.member[_e354].member_6.member_9.member_1;
let _e666 = global_5.member[_e354].member_6.member_10;
let _e672 = ((bitcast<i32>(_e666) + ((_e597 - select(0i, 1i, (_e590 < f32(_e597)))) >> bitcast<u32>(_e607))) + (bitcast<i32>(_e653) * (((_e622 - select(0i, 1i, (_e615 < f32(_e622)))) >> bitcast<u32>(_e607)) + (bitcast<i32>(_e660) * ((_e641 - select(0i, 1i, (_e634 < f32(_e641)))) >> bitcast<u32>(_e607))))));
let _e674 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e676 = select(_e674, _e672, (_e672 < _e674));
let _e682 = global_2.member[bitcast<u32>(select(0i, _e676, (_e676 > 0i)))];
let _e689 = global_5.member[_e354].member_1;
let _e721 = (_e358[17] != _e378);
let _e727 = (select(0u, select(select(select(select(7u, 3u, (((((((_e462 >= 0f) && (_e462 <= _e586)) && (_e478 >= 0f)) && (_e478 <= _e611)) && (_e494 >= 0f)) && (_e494 <= _e630)) && ((((((_e500 >= 0f) && (_e500 <= _e586)) && (_e506 >= 0f)) && (_e506 <= _e611)) && (_e512 >= 0f)) && (_e512 <= _e630)))), 15u, _e721), 1u, (((_e689 & 64u) != 0u) || ((((select(_e564, _e561, (_e561 > _e564)) <= _e517) && ((select(_e581, _e578, (_e578 > _e581)) > _e517) || (_e682 != 0u))) && true) && ((_e689 & 32u) != 0u)))), 31u, _e446), (_e358[7] == 0f)) > 1u);
if _e727 {
let _e731 = global_5.member[_e354].member;
let _e744 = (_e410 - _e416);
let _e747 = (_e410 / select(1e-20f, _e744, (_e744 > 1e-20f)));
let _e748 = (_e436 - _e442);
let _e751 = (_e436 / select(1e-20f, _e748, (_e748 > 1e-20f)));
let _e755 = (_e445 && (!(_e419) || (_e751 < _e747)));
let _e762 = global_5.member[_e354].member_13.member_1.member.member;
let _e768 = global_5.member[_e354].member_13.member_1.member_1;
let _e775 = global_5.member[_e354].member_13.member.member.member;
let _e781 = global_5.member[_e354].member_13.member.member_1;
let _e800 = select(_e747, _e751, _e755);
let _e802 = (_e731.member_2 == 2u);
let _e805 = (((_e731.member_2 == 1u) || _e802) || (_e731.member_2 == 5u));
if _e805 {
let _e807 = select(-1f, _e528, (_e528 > -1f));
let _e809 = select(_e523, _e807, (_e807 < _e523));
let _e816 = select(0i, select(select(i32(_e809), i32(-2147483648), (_e809 < -2147483600f)), 2147483647i, (_e809 > 2147483500f)), (_e809 == _e809));
let _e820 = (_e816 - select(0i, 1i, (_e809 < f32(_e816))));
let _e822 = select(-1f, _e539, (_e539 > -1f));
let _e824 = select(_e534, _e822, (_e822 < _e534));
let _e831 = select(0i, select(select(i32(_e824), i32(-2147483648), (_e824 < -2147483600f)), 2147483647i, (_e824 > 2147483500f)), (_e824 == _e824));
let _e835 = (_e831 - select(0i, 1i, (_e824 < f32(_e831))));
let _e837 = select(-1f, _e550, (_e550 > -1f));
let _e839 = select(_e545, _e837, (_e837 < _e545));
let _e846 = select(0i, select(select(i32(_e839), i32(-2147483648), (_e839 < -2147483600f)), 2147483647i, (_e839 > 2147483500f)), (_e839 == _e839));
let _e850 = (_e846 - select(0i, 1i, (_e839 < f32(_e846))));
let _e855 = global_5.member[_e354].member_6.member_7;
let _e860 = global_5.member[_e354].member_6.member_8;
let _e861 = (_e820 + 1i);
let _e862 = (_e835 + 1i);
let _e863 = (_e850 + 1i);
let _e869 = global_5.member[_e354].member_6.member_11.member;
let _e876 = global_5.member[_e354].member_6.member_11.member_1;
let _e887 = ((_e861 >> bitcast<u32>(4i)) + (bitcast<i32>(_e869) * ((_e862 >> bitcast<u32>(4i)) + (bitcast<i32>(_e876) * (_e863 >> bitcast<u32>(4i))))));
let _e889 = (bitcast<i32>(_e121) - 1i);
let _e891 = select(_e889, _e887, (_e887 < _e889));
let _e897 = global_1.member[bitcast<u32>(select(0i, _e891, (_e891 > 0i)))];
let _e899 = (_e861 & 15i);
let _e902 = ((_e862 & 15i) * _e855);
let _e904 = (bitcast<i32>(_e897) + ((_e863 & 15i) * _e860));
let _e905 = (_e902 + _e855);
let _e907 = (_e902 + (2i * _e855));
let _e909 = (_e902 + (3i * _e855));
let _e910 = (_e904 + _e860);
let _e912 = (_e904 + (2i * _e860));
let _e914 = (_e904 + (3i * _e860));
local_6 = type_28(array<i32, 4>(_e899, _e899, _e899, _e899), array<u32, 6>(0u, 8u, 16u, 24u, 0u, 0u));
local_7 = vec3<f32>((_e528 - f32(_e820)), (_e539 - f32(_e835)), (_e550 - f32(_e850)));
let _e928 = local_6.member[0u];
let _e929 = ((_e910 + _e905) + _e928);
let _e931 = (_e929 >> bitcast<u32>(2i));
let _e934 = bitcast<u32>(((_e929 & 3i) * 8i));
let _e936 = select(_e889, _e931, (_e931 < _e889));
let _e941 = global_1.member[bitcast<u32>(select(0i, _e936, (_e936 > 0i)))];
let _e945 = (_e931 + 1i);
let _e947 = select(_e889, _e945, (_e945 < _e889));
let _e952 = global_1.member[bitcast<u32>(select(0i, _e947, (_e947 > 0i)))];
let _e959 = ((_e941 >> bitcast<u32>((_e934 & 31u))) | ((_e952 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e934) & 31u))));
let _e962 = local_6.member_1[0u];
let _e968 = f32(bitcast<i32>(((_e959 >> bitcast<u32>((_e962 & 31u))) & 255u)));
let _e971 = local_6.member_1[1u];
let _e977 = f32(bitcast<i32>(((_e959 >> bitcast<u32>((_e971 & 31u))) & 255u)));
let _e980 = local_6.member_1[2u];
let _e986 = f32(bitcast<i32>(((_e959 >> bitcast<u32>((_e980 & 31u))) & 255u)));
let _e989 = local_6.member_1[3u];
let _e996 = local_7[0u];
let _e999 = (_e968 + ((_e977 - _e968) * _e996));
let _e1000 = local_7[0u];
let _e1003 = (_e977 + ((_e986 - _e977) * _e1000));
let _e1004 = local_7[0u];
let _e1007 = (_e986 + ((f32(bitcast<i32>(((_e959 >> bitcast<u32>((_e989 & 31u))) & 255u))) - _e986) * _e1004));
let _e1009 = local_6.member[0u];
let _e1010 = ((_e910 + _e907) + _e1009);
let _e1012 = (_e1010 >> bitcast<u32>(2i));
let _e1015 = bitcast<u32>(((_e1010 & 3i) * 8i));
let _e1017 = select(_e889, _e1012, (_e1012 < _e889));
let _e1022 = global_1.member[bitcast<u32>(select(0i, _e1017, (_e1017 > 0i)))];
let _e1026 = (_e1012 + 1i);
let _e1028 = select(_e889, _e1026, (_e1026 < _e889));
let _e1033 = global_1.member[bitcast<u32>(select(0i, _e1028, (_e1028 > 0i)))];
let _e1040 = ((_e1022 >> bitcast<u32>((_e1015 & 31u))) | ((_e1033 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1015) & 31u))));
let _e1041 = local_6.member_1[0u];
let _e1047 = f32(bitcast<i32>(((_e1040 >> bitcast<u32>((_e1041 & 31u))) & 255u)));
let _e1048 = local_6.member_1[1u];
let _e1054 = f32(bitcast<i32>(((_e1040 >> bitcast<u32>((_e1048 & 31u))) & 255u)));
let _e1055 = local_6.member_1[2u];
let _e1061 = f32(bitcast<i32>(((_e1040 >> bitcast<u32>((_e1055 & 31u))) & 255u)));
let _e1062 = local_6.member_1[3u];
let _e1069 = local_7[0u];
let _e1073 = local_7[0u];
let _e1076 = (_e1054 + ((_e1061 - _e1054) * _e1073));
let _e1077 = local_7[0u];
let _e1082 = local_6.member[0u];
let _e1083 = ((_e912 + _e905) + _e1082);
let _e1085 = (_e1083 >> bitcast<u32>(2i));
let _e1088 = bitcast<u32>(((_e1083 & 3i) * 8i));
let _e1090 = select(_e889, _e1085, (_e1085 < _e889));
let _e1095 = global_1.member[bitcast<u32>(select(0i, _e1090, (_e1090 > 0i)))];
let _e1099 = (_e1085 + 1i);
let _e1101 = select(_e889, _e1099, (_e1099 < _e889));
let _e1106 = global_1.member[bitcast<u32>(select(0i, _e1101, (_e1101 > 0i)))];
let _e1113 = ((_e1095 >> bitcast<u32>((_e1088 & 31u))) | ((_e1106 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1088) & 31u))));
let _e1114 = local_6.member_1[0u];
let _e1120 = f32(bitcast<i32>(((_e1113 >> bitcast<u32>((_e1114 & 31u))) & 255u)));
let _e1121 = local_6.member_1[1u];
let _e1127 = f32(bitcast<i32>(((_e1113 >> bitcast<u32>((_e1121 & 31u))) & 255u)));
let _e1128 = local_6.member_1[2u];
let _e1134 = f32(bitcast<i32>(((_e1113 >> bitcast<u32>((_e1128 & 31u))) & 255u)));
let _e1135 = local_6.member_1[3u];
let _e1142 = local_7[0u];
let _e1145 = (_e1120 + ((_e1127 - _e1120) * _e1142));
let _e1146 = local_7[0u];
let _e1149 = (_e1127 + ((_e1134 - _e1127) * _e1146));
let _e1150 = local_7[0u];
let _e1153 = (_e1134 + ((f32(bitcast<i32>(((_e1113 >> bitcast<u32>((_e1135 & 31u))) & 255u))) - _e1134) * _e1150));
let _e1155 = local_6.member[0u];
let _e1156 = ((_e912 + _e907) + _e1155);
let _e1158 = (_e1156 >> bitcast<u32>(2i));
let _e1161 = bitcast<u32>(((_e1156 & 3i) * 8i));
let _e1163 = select(_e889, _e1158, (_e1158 < _e889));
let _e1168 = global_1.member[bitcast<u32>(select(0i, _e1163, (_e1163 > 0i)))];
let _e1172 = (_e1158 + 1i);
let _e1174 = select(_e889, _e1172, (_e1172 < _e889));
let _e1179 = global_1.member[bitcast<u32>(select(0i, _e1174, (_e1174 > 0i)))];
let _e1186 = ((_e1168 >> bitcast<u32>((_e1161 & 31u))) | ((_e1179 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1161) & 31u))));
let _e1187 = local_6.member_1[0u];
let _e1193 = f32(bitcast<i32>(((_e1186 >> bitcast<u32>((_e1187 & 31u))) & 255u)));
let _e1194 = local_6.member_1[1u];
let _e1200 = f32(bitcast<i32>(((_e1186 >> bitcast<u32>((_e1194 & 31u))) & 255u)));
let _e1201 = local_6.member_1[2u];
let _e1207 = f32(bitcast<i32>(((_e1186 >> bitcast<u32>((_e1201 & 31u))) & 255u)));
let _e1208 = local_6.member_1[3u];
let _e1215 = local_7[0u];
let _e1219 = local_7[0u];
let _e1222 = (_e1200 + ((_e1207 - _e1200) * _e1219));
let _e1223 = local_7[0u];
let _e1228 = local_6.member[0u];
let _e1229 = ((_e910 + _e902) + _e1228);
let _e1231 = (_e1229 >> bitcast<u32>(2i));
let _e1234 = bitcast<u32>(((_e1229 & 3i) * 8i));
let _e1236 = select(_e889, _e1231, (_e1231 < _e889));
let _e1241 = global_1.member[bitcast<u32>(select(0i, _e1236, (_e1236 > 0i)))];
let _e1245 = (_e1231 + 1i);
let _e1247 = select(_e889, _e1245, (_e1245 < _e889));
let _e1252 = global_1.member[bitcast<u32>(select(0i, _e1247, (_e1247 > 0i)))];
let _e1259 = ((_e1241 >> bitcast<u32>((_e1234 & 31u))) | ((_e1252 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1234) & 31u))));
let _e1260 = local_6.member_1[1u];
let _e1266 = f32(bitcast<i32>(((_e1259 >> bitcast<u32>((_e1260 & 31u))) & 255u)));
let _e1267 = local_6.member_1[2u];
let _e1274 = local_7[0u];
let _e1277 = (_e1266 + ((f32(bitcast<i32>(((_e1259 >> bitcast<u32>((_e1267 & 31u))) & 255u))) - _e1266) * _e1274));
let _e1279 = local_6.member[0u];
let _e1280 = ((_e910 + _e909) + _e1279);
let _e1282 = (_e1280 >> bitcast<u32>(2i));
let _e1285 = bitcast<u32>(((_e1280 & 3i) * 8i));
let _e1287 = select(_e889, _e1282, (_e1282 < _e889));
let _e1292 = global_1.member[bitcast<u32>(select(0i, _e1287, (_e1287 > 0i)))];
let _e1296 = (_e1282 + 1i);
let _e1298 = select(_e889, _e1296, (_e1296 < _e889));
let _e1303 = global_1.member[bitcast<u32>(select(0i, _e1298, (_e1298 > 0i)))];
let _e1310 = ((_e1292 >> bitcast<u32>((_e1285 & 31u))) | ((_e1303 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1285) & 31u))));
let _e1311 = local_6.member_1[1u];
let _e1317 = f32(bitcast<i32>(((_e1310 >> bitcast<u32>((_e1311 & 31u))) & 255u)));
let _e1318 = local_6.member_1[2u];
let _e1325 = local_7[0u];
let _e1330 = local_6.member[0u];
let _e1331 = ((_e912 + _e902) + _e1330);
let _e1333 = (_e1331 >> bitcast<u32>(2i));
let _e1336 = bitcast<u32>(((_e1331 & 3i) * 8i));
let _e1338 = select(_e889, _e1333, (_e1333 < _e889));
let _e1343 = global_1.member[bitcast<u32>(select(0i, _e1338, (_e1338 > 0i)))];
let _e1347 = (_e1333 + 1i);
let _e1349 = select(_e889, _e1347, (_e1347 < _e889));
let _e1354 = global_1.member[bitcast<u32>(select(0i, _e1349, (_e1349 > 0i)))];
let _e1361 = ((_e1343 >> bitcast<u32>((_e1336 & 31u))) | ((_e1354 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1336) & 31u))));
let _e1362 = local_6.member_1[1u];
let _e1368 = f32(bitcast<i32>(((_e1361 >> bitcast<u32>((_e1362 & 31u))) & 255u)));
let _e1369 = local_6.member_1[2u];
let _e1376 = local_7[0u];
let _e1379 = (_e1368 + ((f32(bitcast<i32>(((_e1361 >> bitcast<u32>((_e1369 & 31u))) & 255u))) - _e1368) * _e1376));
let _e1381 = local_6.member[0u];
let _e1382 = ((_e912 + _e909) + _e1381);
let _e1384 = (_e1382 >> bitcast<u32>(2i));
let _e1387 = bitcast<u32>(((_e1382 & 3i) * 8i));
let _e1389 = select(_e889, _e1384, (_e1384 < _e889));
let _e1394 = global_1.member[bitcast<u32>(select(0i, _e1389, (_e1389 > 0i)))];
let _e1398 = (_e1384 + 1i);
let _e1400 = select(_e889, _e1398, (_e1398 < _e889));
let _e1405 = global_1.member[bitcast<u32>(select(0i, _e1400, (_e1400 > 0i)))];
let _e1412 = ((_e1394 >> bitcast<u32>((_e1387 & 31u))) | ((_e1405 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1387) & 31u))));
let _e1413 = local_6.member_1[1u];
let _e1419 = f32(bitcast<i32>(((_e1412 >> bitcast<u32>((_e1413 & 31u))) & 255u)));
let _e1420 = local_6.member_1[2u];
let _e1427 = local_7[0u];
let _e1432 = local_6.member[0u];
let _e1433 = ((_e904 + _e905) + _e1432);
let _e1435 = (_e1433 >> bitcast<u32>(2i));
let _e1438 = bitcast<u32>(((_e1433 & 3i) * 8i));
let _e1440 = select(_e889, _e1435, (_e1435 < _e889));
let _e1445 = global_1.member[bitcast<u32>(select(0i, _e1440, (_e1440 > 0i)))];
let _e1449 = (_e1435 + 1i);
let _e1451 = select(_e889, _e1449, (_e1449 < _e889));
let _e1456 = global_1.member[bitcast<u32>(select(0i, _e1451, (_e1451 > 0i)))];
let _e1463 = ((_e1445 >> bitcast<u32>((_e1438 & 31u))) | ((_e1456 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1438) & 31u))));
let _e1464 = local_6.member_1[1u];
let _e1470 = f32(bitcast<i32>(((_e1463 >> bitcast<u32>((_e1464 & 31u))) & 255u)));
let _e1471 = local_6.member_1[2u];
let _e1478 = local_7[0u];
let _e1481 = (_e1470 + ((f32(bitcast<i32>(((_e1463 >> bitcast<u32>((_e1471 & 31u))) & 255u))) - _e1470) * _e1478));
let _e1483 = local_6.member[0u];
let _e1484 = ((_e914 + _e905) + _e1483);
let _e1486 = (_e1484 >> bitcast<u32>(2i));
let _e1489 = bitcast<u32>(((_e1484 & 3i) * 8i));
let _e1491 = select(_e889, _e1486, (_e1486 < _e889));
let _e1496 = global_1.member[bitcast<u32>(select(0i, _e1491, (_e1491 > 0i)))];
let _e1500 = (_e1486 + 1i);
let _e1502 = select(_e889, _e1500, (_e1500 < _e889));
let _e1507 = global_1.member[bitcast<u32>(select(0i, _e1502, (_e1502 > 0i)))];
let _e1514 = ((_e1496 >> bitcast<u32>((_e1489 & 31u))) | ((_e1507 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1489) & 31u))));
let _e1515 = local_6.member_1[1u];
let _e1521 = f32(bitcast<i32>(((_e1514 >> bitcast<u32>((_e1515 & 31u))) & 255u)));
let _e1522 = local_6.member_1[2u];
let _e1529 = local_7[0u];
let _e1532 = (_e1521 + ((f32(bitcast<i32>(((_e1514 >> bitcast<u32>((_e1522 & 31u))) & 255u))) - _e1521) * _e1529));
let _e1534 = local_6.member[0u];
let _e1535 = ((_e904 + _e907) + _e1534);
let _e1537 = (_e1535 >> bitcast<u32>(2i));
let _e1540 = bitcast<u32>(((_e1535 & 3i) * 8i));
let _e1542 = select(_e889, _e1537, (_e1537 < _e889));
let _e1547 = global_1.member[bitcast<u32>(select(0i, _e1542, (_e1542 > 0i)))];
let _e1551 = (_e1537 + 1i);
let _e1553 = select(_e889, _e1551, (_e1551 < _e889));
let _e1558 = global_1.member[bitcast<u32>(select(0i, _e1553, (_e1553 > 0i)))];
let _e1565 = ((_e1547 >> bitcast<u32>((_e1540 & 31u))) | ((_e1558 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1540) & 31u))));
let _e1566 = local_6.member_1[1u];
let _e1572 = f32(bitcast<i32>(((_e1565 >> bitcast<u32>((_e1566 & 31u))) & 255u)));
let _e1573 = local_6.member_1[2u];
let _e1580 = local_7[0u];
let _e1585 = local_6.member[0u];
let _e1586 = ((_e914 + _e907) + _e1585);
let _e1588 = (_e1586 >> bitcast<u32>(2i));
let _e1591 = bitcast<u32>(((_e1586 & 3i) * 8i));
let _e1593 = select(_e889, _e1588, (_e1588 < _e889));
let _e1598 = global_1.member[bitcast<u32>(select(0i, _e1593, (_e1593 > 0i)))];
let _e1602 = (_e1588 + 1i);
let _e1604 = select(_e889, _e1602, (_e1602 < _e889));
let _e1609 = global_1.member[bitcast<u32>(select(0i, _e1604, (_e1604 > 0i)))];
let _e1616 = ((_e1598 >> bitcast<u32>((_e1591 & 31u))) | ((_e1609 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1591) & 31u))));
let _e1617 = local_6.member_1[1u];
let _e1623 = f32(bitcast<i32>(((_e1616 >> bitcast<u32>((_e1617 & 31u))) & 255u)));
let _e1624 = local_6.member_1[2u];
let _e1631 = local_7[0u];
let _e1636 = local_7[1u];
let _e1639 = (_e1003 + ((_e1076 - _e1003) * _e1636));
let _e1640 = local_7[1u];
let _e1643 = (_e1149 + ((_e1222 - _e1149) * _e1640));
let _e1644 = local_7[1u];
let _e1647 = (_e999 + (((_e1047 + ((_e1054 - _e1047) * _e1069)) - _e999) * _e1644));
let _e1648 = local_7[1u];
let _e1653 = local_7[2u];
let _e1657 = local_7[1u];
let _e1660 = (_e1007 + (((_e1061 + ((f32(bitcast<i32>(((_e1040 >> bitcast<u32>((_e1062 & 31u))) & 255u))) - _e1061) * _e1077)) - _e1007) * _e1657));
let _e1661 = local_7[1u];
let _e1665 = local_7[2u];
let _e1669 = local_7[1u];
let _e1672 = (_e1277 + ((_e1003 - _e1277) * _e1669));
let _e1673 = local_7[1u];
let _e1677 = local_7[2u];
let _e1681 = local_7[1u];
let _e1684 = (_e1076 + (((_e1317 + ((f32(bitcast<i32>(((_e1310 >> bitcast<u32>((_e1318 & 31u))) & 255u))) - _e1317) * _e1325)) - _e1076) * _e1681));
let _e1685 = local_7[1u];
let _e1689 = local_7[2u];
let _e1693 = local_7[1u];
let _e1696 = (_e1481 + (((_e1572 + ((f32(bitcast<i32>(((_e1565 >> bitcast<u32>((_e1573 & 31u))) & 255u))) - _e1572) * _e1580)) - _e1481) * _e1693));
let _e1697 = local_7[2u];
let _e1701 = local_7[1u];
let _e1705 = local_7[2u];
let _e1709 = local_7[2u];
let _e1717 = global_5.member[_e354].member_6.member_5;
let _e1723 = global_5.member[_e354].member_6.member_6;
let _e1724 = (((_e1639 + ((_e1643 - _e1639) * _e1709)) * _e1717) + _e1723);
let _e1726 = select(0f, _e1724, (_e1724 > 0f));
let _e1728 = select(1f, _e1726, (_e1726 < 1f));
let _e1730 = (((_e1647 + (((_e1145 + (((_e1193 + ((_e1200 - _e1193) * _e1215)) - _e1145) * _e1648)) - _e1647) * _e1653)) * _e1717) + _e1723);
let _e1732 = select(0f, _e1730, (_e1730 > 0f));
let _e1734 = select(1f, _e1732, (_e1732 < 1f));
let _e1736 = (((_e1660 + (((_e1153 + (((_e1207 + ((f32(bitcast<i32>(((_e1186 >> bitcast<u32>((_e1208 & 31u))) & 255u))) - _e1207) * _e1223)) - _e1153) * _e1661)) - _e1660) * _e1665)) * _e1717) + _e1723);
let _e1738 = select(0f, _e1736, (_e1736 > 0f));
let _e1740 = select(1f, _e1738, (_e1738 < 1f));
let _e1742 = (((_e1672 + (((_e1379 + ((_e1149 - _e1379) * _e1673)) - _e1672) * _e1677)) * _e1717) + _e1723);
let _e1744 = select(0f, _e1742, (_e1742 > 0f));
let _e1746 = select(1f, _e1744, (_e1744 < 1f));
let _e1748 = (((_e1684 + (((_e1222 + (((_e1419 + ((f32(bitcast<i32>(((_e1412 >> bitcast<u32>((_e1420 & 31u))) & 255u))) - _e1419) * _e1427)) - _e1222) * _e1685)) - _e1684) * _e1689)) * _e1717) + _e1723);
let _e1750 = select(0f, _e1748, (_e1748 > 0f));
let _e1752 = select(1f, _e1750, (_e1750 < 1f));
let _e1754 = (((_e1696 + ((_e1639 - _e1696) * _e1697)) * _e1717) + _e1723);
let _e1756 = select(0f, _e1754, (_e1754 > 0f));
let _e1758 = select(1f, _e1756, (_e1756 < 1f));
let _e1760 = (((_e1643 + (((_e1532 + (((_e1623 + ((f32(bitcast<i32>(((_e1616 >> bitcast<u32>((_e1624 & 31u))) & 255u))) - _e1623) * _e1631)) - _e1532) * _e1701)) - _e1643) * _e1705)) * _e1717) + _e1723);
let _e1762 = select(0f, _e1760, (_e1760 > 0f));
let _e1764 = select(1f, _e1762, (_e1762 < 1f));
let _e1765 = (_e1728 * 1024f);
let _e1766 = (1024f - 1f);
let _e1768 = select(0f, _e1765, (_e1765 > 0f));
let _e1770 = select(_e1766, _e1768, (_e1768 < _e1766));
let _e1777 = select(0i, select(select(i32(_e1770), i32(-2147483648), (_e1770 < -2147483600f)), 2147483647i, (_e1770 > 2147483500f)), (_e1770 == _e1770));
let _e1781 = (_e1777 - select(0i, 1i, (_e1770 < f32(_e1777))));
let _e1782 = (262147i + _e1781);
let _e1784 = (bitcast<i32>(_e125) - 1i);
let _e1786 = select(_e1784, _e1782, (_e1782 < _e1784));
let _e1792 = global_3.member[bitcast<u32>(select(0i, _e1786, (_e1786 > 0i)))];
let _e1802 = select(_e1784, 262146i, (262146i < _e1784));
let _e1808 = global_3.member[bitcast<u32>(select(0i, _e1802, (_e1802 > 0i)))];
let _e1809 = bitcast<f32>(_e1808);
let _e1810 = (f32((bitcast<i32>((_e1792 & 4095u)) - 2048i)) * _e1809);
let _e1812 = select(_e1784, 262144i, (262144i < _e1784));
let _e1818 = global_3.member[bitcast<u32>(select(0i, _e1812, (_e1812 > 0i)))];
let _e1819 = bitcast<f32>(_e1818);
let _e1821 = select(_e1784, 262145i, (262145i < _e1784));
let _e1827 = global_3.member[bitcast<u32>(select(0i, _e1821, (_e1821 > 0i)))];
let _e1828 = bitcast<f32>(_e1827);
let _e1834 = ((_e1819 + (f32(bitcast<i32>((_e1792 >> bitcast<u32>(12u)))) * _e1828)) + (_e1810 * (_e1765 - f32(_e1781))));
let _e1835 = (_e1810 * 1024f);
if _e802 {
let _e1842 = ((0.5f * (_e1740 - _e1734)) * _e1835);
let _e1843 = ((0.5f * (_e1752 - _e1746)) * _e1835);
let _e1844 = ((0.5f * (_e1764 - _e1758)) * _e1835);
phi_3616_ = type_29(_e1834, vec3<f32>(_e1842, _e1843, _e1844), vec3<f32>((_e1842 * _e1834), (_e1843 * _e1834), (_e1844 * _e1834)));
} else {
let _e1851 = (_e1734 * 1024f);
let _e1853 = select(0f, _e1851, (_e1851 > 0f));
let _e1855 = select(_e1766, _e1853, (_e1853 < _e1766));
let _e1862 = select(0i, select(select(i32(_e1855), i32(-2147483648), (_e1855 < -2147483600f)), 2147483647i, (_e1855 > 2147483500f)), (_e1855 == _e1855));
let _e1866 = (_e1862 - select(0i, 1i, (_e1855 < f32(_e1862))));
let _e1867 = (262147i + _e1866);
let _e1869 = select(_e1784, _e1867, (_e1867 < _e1784));
let _e1875 = global_3.member[bitcast<u32>(select(0i, _e1869, (_e1869 > 0i)))];
let _e1890 = ((_e1819 + (f32(bitcast<i32>((_e1875 >> bitcast<u32>(12u)))) * _e1828)) + ((f32((bitcast<i32>((_e1875 & 4095u)) - 2048i)) * _e1809) * (_e1851 - f32(_e1866))));
let _e1891 = (_e1740 * 1024f);
let _e1893 = select(0f, _e1891, (_e1891 > 0f));
let _e1895 = select(_e1766, _e1893, (_e1893 < _e1766));
let _e1902 = select(0i, select(select(i32(_e1895), i32(-2147483648), (_e1895 < -2147483600f)), 2147483647i, (_e1895 > 2147483500f)), (_e1895 == _e1895));
let _e1906 = (_e1902 - select(0i, 1i, (_e1895 < f32(_e1902))));
let _e1907 = (262147i + _e1906);
let _e1909 = select(_e1784, _e1907, (_e1907 < _e1784));
let _e1915 = global_3.member[bitcast<u32>(select(0i, _e1909, (_e1909 > 0i)))];
let _e1930 = ((_e1819 + (f32(bitcast<i32>((_e1915 >> bitcast<u32>(12u)))) * _e1828)) + ((f32((bitcast<i32>((_e1915 & 4095u)) - 2048i)) * _e1809) * (_e1891 - f32(_e1906))));
let _e1931 = (_e1746 * 1024f);
let _e1933 = select(0f, _e1931, (_e1931 > 0f));
let _e1935 = select(_e1766, _e1933, (_e1933 < _e1766));
let _e1942 = select(0i, select(select(i32(_e1935), i32(-2147483648), (_e1935 < -2147483600f)), 2147483647i, (_e1935 > 2147483500f)), (_e1935 == _e1935));
let _e1946 = (_e1942 - select(0i, 1i, (_e1935 < f32(_e1942))));
let _e1947 = (262147i + _e1946);
let _e1949 = select(_e1784, _e1947, (_e1947 < _e1784));
let _e1955 = global_3.member[bitcast<u32>(select(0i, _e1949, (_e1949 > 0i)))];
let _e1970 = ((_e1819 + (f32(bitcast<i32>((_e1955 >> bitcast<u32>(12u)))) * _e1828)) + ((f32((bitcast<i32>((_e1955 & 4095u)) - 2048i)) * _e1809) * (_e1931 - f32(_e1946))));
let _e1971 = (_e1752 * 1024f);
let _e1973 = select(0f, _e1971, (_e1971 > 0f));
let _e1975 = select(_e1766, _e1973, (_e1973 < _e1766));
let _e1982 = select(0i, select(select(i32(_e1975), i32(-2147483648), (_e1975 < -2147483600f)), 2147483647i, (_e1975 > 2147483500f)), (_e1975 == _e1975));
let _e1986 = (_e1982 - select(0i, 1i, (_e1975 < f32(_e1982))));
let _e1987 = (262147i + _e1986);
let _e1989 = select(_e1784, _e1987, (_e1987 < _e1784));
let _e1995 = global_3.member[bitcast<u32>(select(0i, _e1989, (_e1989 > 0i)))];
let _e2010 = ((_e1819 + (f32(bitcast<i32>((_e1995 >> bitcast<u32>(12u)))) * _e1828)) + ((f32((bitcast<i32>((_e1995 & 4095u)) - 2048i)) * _e1809) * (_e1971 - f32(_e1986))));
let _e2011 = (_e1758 * 1024f);
let _e2013 = select(0f, _e2011, (_e2011 > 0f));
let _e2015 = select(_e1766, _e2013, (_e2013 < _e1766));
let _e2022 = select(0i, select(select(i32(_e2015), i32(-2147483648), (_e2015 < -2147483600f)), 2147483647i, (_e2015 > 2147483500f)), (_e2015 == _e2015));
let _e2026 = (_e2022 - select(0i, 1i, (_e2015 < f32(_e2022))));
let _e2027 = (262147i + _e2026);
let _e2029 = select(_e1784, _e2027, (_e2027 < _e1784));
let _e2035 = global_3.member[bitcast<u32>(select(0i, _e2029, (_e2029 > 0i)))];
let _e2050 = ((_e1819 + (f32(bitcast<i32>((_e2035 >> bitcast<u32>(12u)))) * _e1828)) + ((f32((bitcast<i32>((_e2035 & 4095u)) - 2048i)) * _e1809) * (_e2011 - f32(_e2026))));
let _e2051 = (_e1764 * 1024f);
let _e2053 = select(0f, _e2051, (_e2051 > 0f));
let _e2055 = select(_e1766, _e2053, (_e2053 < _e1766));
let _e2062 = select(0i, select(select(i32(_e2055), i32(-2147483648), (_e2055 < -2147483600f)), 2147483647i, (_e2055 > 2147483500f)), (_e2055 == _e2055));
let _e2066 = (_e2062 - select(0i, 1i, (_e2055 < f32(_e2062))));
let _e2067 = (262147i + _e2066);
let _e2069 = select(_e1784, _e2067, (_e2067 < _e1784));
let _e2075 = global_3.member[bitcast<u32>(select(0i, _e2069, (_e2069 > 0i)))];
let _e2090 = ((_e1819 + (f32(bitcast<i32>((_e2075 >> bitcast<u32>(12u)))) * _e1828)) + ((f32((bitcast<i32>((_e2075 & 4095u)) - 2048i)) * _e1809) * (_e2051 - f32(_e2066))));
let _e2091 = (_e1930 - _e1890);
let _e2093 = (_e2010 - _e1970);
let _e2095 = (_e2090 - _e2050);
phi_3616_ = type_29(_e1834, vec3<f32>((0.5f * _e2091), (0.5f * _e2093), (0.5f * _e2095)), vec3<f32>((0.25f * (_e2091 * (_e1930 + _e1890))), (0.25f * (_e2093 * (_e2010 + _e1970))), (0.25f * (_e2095 * (_e2090 + _e2050)))));
}
let _e2110 = phi_3616_;
let _e2125 = select(0f, 1f, ((((((_e500 >= -0.5f) && (_e500 <= _e524)) && (_e506 >= -0.5f)) && (_e506 <= _e535)) && (_e512 >= -0.5f)) && (_e512 <= _e546)));
let _e2127 = (0.5f * (_e1740 - _e1734));
let _e2129 = (0.5f * (_e1752 - _e1746));
let _e2131 = (0.5f * (_e1764 - _e1758));
let _e2138 = global_5.member[_e354].member_6.member.member.member;
let _e2145 = global_5.member[_e354].member_6.member.member.member_1;
let _e2152 = global_5.member[_e354].member_6.member.member.member_2;
let _e2159 = global_5.member[_e354].member_6.member_1.member.member;
let _e2166 = global_5.member[_e354].member_6.member_1.member.member_1;
let _e2173 = global_5.member[_e354].member_6.member_1.member.member_2;
let _e2180 = global_5.member[_e354].member_6.member_2.member.member;
let _e2187 = global_5.member[_e354].member_6.member_2.member.member_1;
let _e2194 = global_5.member[_e354].member_6.member_2.member.member_2;
phi_4318_ = type_30(_e1728, vec3<f32>(((((_e2138 * _e2127) + (_e2159 * _e2129)) + (_e2180 * _e2131)) * _e2125), ((((_e2145 * _e2127) + (_e2166 * _e2129)) + (_e2187 * _e2131)) * _e2125), ((((_e2152 * _e2127) + (_e2173 * _e2129)) + (_e2194 * _e2131)) * _e2125)), _e2110.member, vec3<f32>(((((_e2138 * _e2110.member_2.x) + (_e2159 * _e2110.member_2.y)) + (_e2180 * _e2110.member_2.z)) * _e2125), ((((_e2145 * _e2110.member_2.x) + (_e2166 * _e2110.member_2.y)) + (_e2187 * _e2110.member_2.z)) * _e2125), ((((_e2152 * _e2110.member_2.x) + (_e2173 * _e2110.member_2.y)) + (_e2194 * _e2110.member_2.z)) * _e2125)), vec3<f32>(((((_e2138 * _e2110.member_1.x) + (_e2159 * _e2110.member_1.y)) + (_e2180 * _e2110.member_1.z)) * _e2125), ((((_e2145 * _e2110.member_1.x) + (_e2166 * _e2110.member_1.y)) + (_e2187 * _e2110.member_1.z)) * _e2125), ((((_e2152 * _e2110.member_1.x) + (_e2173 * _e2110.member_1.y)) + (_e2194 * _e2110.member_1.z)) * _e2125)));
} else {
let _e2260 = select(-1f, _e528, (_e528 > -1f));
let _e2262 = select(_e523, _e2260, (_e2260 < _e523));
let _e2269 = select(0i, select(select(i32(_e2262), i32(-2147483648), (_e2262 < -2147483600f)), 2147483647i, (_e2262 > 2147483500f)), (_e2262 == _e2262));
let _e2273 = (_e2269 - select(0i, 1i, (_e2262 < f32(_e2269))));
let _e2275 = select(-1f, _e539, (_e539 > -1f));
let _e2277 = select(_e534, _e2275, (_e2275 < _e534));
let _e2284 = select(0i, select(select(i32(_e2277), i32(-2147483648), (_e2277 < -2147483600f)), 2147483647i, (_e2277 > 2147483500f)), (_e2277 == _e2277));
let _e2288 = (_e2284 - select(0i, 1i, (_e2277 < f32(_e2284))));
let _e2290 = select(-1f, _e550, (_e550 > -1f));
let _e2292 = select(_e545, _e2290, (_e2290 < _e545));
let _e2299 = select(0i, select(select(i32(_e2292), i32(-2147483648), (_e2292 < -2147483600f)), 2147483647i, (_e2292 > 2147483500f)), (_e2292 == _e2292));
let _e2303 = (_e2299 - select(0i, 1i, (_e2292 < f32(_e2299))));
let _e2308 = global_5.member[_e354].member_6.member_7;
let _e2313 = global_5.member[_e354].member_6.member_8;
let _e2314 = (_e2273 + 1i);
let _e2315 = (_e2288 + 1i);
let _e2316 = (_e2303 + 1i);
let _e2322 = global_5.member[_e354].member_6.member_11.member;
let _e2329 = global_5.member[_e354].member_6.member_11.member_1;
let _e2340 = ((_e2314 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2322) * ((_e2315 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2329) * (_e2316 >> bitcast<u32>(4i))))));
let _e2342 = (bitcast<i32>(_e121) - 1i);
let _e2344 = select(_e2342, _e2340, (_e2340 < _e2342));
let _e2350 = global_1.member[bitcast<u32>(select(0i, _e2344, (_e2344 > 0i)))];
let _e2352 = (_e2314 & 15i);
let _e2355 = ((_e2315 & 15i) * _e2308);
let _e2357 = (bitcast<i32>(_e2350) + ((_e2316 & 15i) * _e2313));
let _e2358 = (_e2355 + _e2308);
let _e2360 = (_e2355 + (2i * _e2308));
let _e2361 = (_e2357 + _e2313);
let _e2363 = (_e2357 + (2i * _e2313));
local_4 = type_28(array<i32, 4>(_e2352, _e2352, _e2352, _e2352), array<u32, 6>(0u, 8u, 16u, 24u, 0u, 0u));
local_5 = vec3<f32>((_e528 - f32(_e2273)), (_e539 - f32(_e2288)), (_e550 - f32(_e2303)));
let _e2377 = local_4.member[0u];
let _e2378 = ((_e2361 + _e2358) + _e2377);
let _e2380 = (_e2378 >> bitcast<u32>(2i));
let _e2383 = bitcast<u32>(((_e2378 & 3i) * 8i));
let _e2385 = select(_e2342, _e2380, (_e2380 < _e2342));
let _e2390 = global_1.member[bitcast<u32>(select(0i, _e2385, (_e2385 > 0i)))];
let _e2394 = (_e2380 + 1i);
let _e2396 = select(_e2342, _e2394, (_e2394 < _e2342));
let _e2401 = global_1.member[bitcast<u32>(select(0i, _e2396, (_e2396 > 0i)))];
let _e2408 = ((_e2390 >> bitcast<u32>((_e2383 & 31u))) | ((_e2401 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2383) & 31u))));
let _e2411 = local_4.member_1[1u];
let _e2417 = f32(bitcast<i32>(((_e2408 >> bitcast<u32>((_e2411 & 31u))) & 255u)));
let _e2420 = local_4.member_1[2u];
let _e2427 = local_5[0u];
let _e2430 = (_e2417 + ((f32(bitcast<i32>(((_e2408 >> bitcast<u32>((_e2420 & 31u))) & 255u))) - _e2417) * _e2427));
let _e2432 = local_4.member[0u];
let _e2433 = ((_e2361 + _e2360) + _e2432);
let _e2435 = (_e2433 >> bitcast<u32>(2i));
let _e2438 = bitcast<u32>(((_e2433 & 3i) * 8i));
let _e2440 = select(_e2342, _e2435, (_e2435 < _e2342));
let _e2445 = global_1.member[bitcast<u32>(select(0i, _e2440, (_e2440 > 0i)))];
let _e2449 = (_e2435 + 1i);
let _e2451 = select(_e2342, _e2449, (_e2449 < _e2342));
let _e2456 = global_1.member[bitcast<u32>(select(0i, _e2451, (_e2451 > 0i)))];
let _e2463 = ((_e2445 >> bitcast<u32>((_e2438 & 31u))) | ((_e2456 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2438) & 31u))));
let _e2464 = local_4.member_1[1u];
let _e2470 = f32(bitcast<i32>(((_e2463 >> bitcast<u32>((_e2464 & 31u))) & 255u)));
let _e2471 = local_4.member_1[2u];
let _e2478 = local_5[0u];
let _e2483 = local_5[1u];
let _e2486 = (_e2430 + (((_e2470 + ((f32(bitcast<i32>(((_e2463 >> bitcast<u32>((_e2471 & 31u))) & 255u))) - _e2470) * _e2478)) - _e2430) * _e2483));
let _e2488 = local_4.member[0u];
let _e2489 = ((_e2363 + _e2358) + _e2488);
let _e2491 = (_e2489 >> bitcast<u32>(2i));
let _e2494 = bitcast<u32>(((_e2489 & 3i) * 8i));
let _e2496 = select(_e2342, _e2491, (_e2491 < _e2342));
let _e2501 = global_1.member[bitcast<u32>(select(0i, _e2496, (_e2496 > 0i)))];
let _e2505 = (_e2491 + 1i);
let _e2507 = select(_e2342, _e2505, (_e2505 < _e2342));
let _e2512 = global_1.member[bitcast<u32>(select(0i, _e2507, (_e2507 > 0i)))];
let _e2519 = ((_e2501 >> bitcast<u32>((_e2494 & 31u))) | ((_e2512 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2494) & 31u))));
let _e2520 = local_4.member_1[1u];
let _e2526 = f32(bitcast<i32>(((_e2519 >> bitcast<u32>((_e2520 & 31u))) & 255u)));
let _e2527 = local_4.member_1[2u];
let _e2534 = local_5[0u];
let _e2537 = (_e2526 + ((f32(bitcast<i32>(((_e2519 >> bitcast<u32>((_e2527 & 31u))) & 255u))) - _e2526) * _e2534));
let _e2539 = local_4.member[0u];
let _e2540 = ((_e2363 + _e2360) + _e2539);
let _e2542 = (_e2540 >> bitcast<u32>(2i));
let _e2545 = bitcast<u32>(((_e2540 & 3i) * 8i));
let _e2547 = select(_e2342, _e2542, (_e2542 < _e2342));
let _e2552 = global_1.member[bitcast<u32>(select(0i, _e2547, (_e2547 > 0i)))];
let _e2556 = (_e2542 + 1i);
let _e2558 = select(_e2342, _e2556, (_e2556 < _e2342));
let _e2563 = global_1.member[bitcast<u32>(select(0i, _e2558, (_e2558 > 0i)))];
let _e2570 = ((_e2552 >> bitcast<u32>((_e2545 & 31u))) | ((_e2563 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2545) & 31u))));
let _e2571 = local_4.member_1[1u];
let _e2577 = f32(bitcast<i32>(((_e2570 >> bitcast<u32>((_e2571 & 31u))) & 255u)));
let _e2578 = local_4.member_1[2u];
let _e2585 = local_5[0u];
let _e2589 = local_5[1u];
let _e2594 = local_5[2u];
let _e2602 = global_5.member[_e354].member_6.member_5;
let _e2608 = global_5.member[_e354].member_6.member_6;
let _e2609 = (((_e2486 + (((_e2537 + (((_e2577 + ((f32(bitcast<i32>(((_e2570 >> bitcast<u32>((_e2578 & 31u))) & 255u))) - _e2577) * _e2585)) - _e2537) * _e2589)) - _e2486) * _e2594)) * _e2602) + _e2608);
let _e2611 = select(0f, _e2609, (_e2609 > 0f));
phi_4318_ = type_30(select(1f, _e2611, (_e2611 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2616 = phi_4318_;
let _e2618 = select(-0.5f, _e462, (_e462 > -0.5f));
let _e2620 = select(_e524, _e2618, (_e2618 < _e524));
let _e2622 = select(-0.5f, _e478, (_e478 > -0.5f));
let _e2624 = select(_e535, _e2622, (_e2622 < _e535));
let _e2626 = select(-0.5f, _e494, (_e494 > -0.5f));
let _e2628 = select(_e546, _e2626, (_e2626 < _e546));
let _e2630 = select(-1f, _e2620, (_e2620 > -1f));
let _e2632 = select(_e523, _e2630, (_e2630 < _e523));
let _e2639 = select(0i, select(select(i32(_e2632), i32(-2147483648), (_e2632 < -2147483600f)), 2147483647i, (_e2632 > 2147483500f)), (_e2632 == _e2632));
let _e2643 = (_e2639 - select(0i, 1i, (_e2632 < f32(_e2639))));
let _e2645 = select(-1f, _e2624, (_e2624 > -1f));
let _e2647 = select(_e534, _e2645, (_e2645 < _e534));
let _e2654 = select(0i, select(select(i32(_e2647), i32(-2147483648), (_e2647 < -2147483600f)), 2147483647i, (_e2647 > 2147483500f)), (_e2647 == _e2647));
let _e2658 = (_e2654 - select(0i, 1i, (_e2647 < f32(_e2654))));
let _e2660 = select(-1f, _e2628, (_e2628 > -1f));
let _e2662 = select(_e545, _e2660, (_e2660 < _e545));
let _e2669 = select(0i, select(select(i32(_e2662), i32(-2147483648), (_e2662 < -2147483600f)), 2147483647i, (_e2662 > 2147483500f)), (_e2662 == _e2662));
let _e2673 = (_e2669 - select(0i, 1i, (_e2662 < f32(_e2669))));
let _e2678 = global_5.member[_e354].member_6.member_7;
let _e2683 = global_5.member[_e354].member_6.member_8;
let _e2684 = (_e2643 + 1i);
let _e2685 = (_e2658 + 1i);
let _e2686 = (_e2673 + 1i);
let _e2692 = global_5.member[_e354].member_6.member_11.member;
let _e2699 = global_5.member[_e354].member_6.member_11.member_1;
let _e2710 = ((_e2684 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2692) * ((_e2685 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2699) * (_e2686 >> bitcast<u32>(4i))))));
let _e2712 = (bitcast<i32>(_e121) - 1i);
let _e2714 = select(_e2712, _e2710, (_e2710 < _e2712));
let _e2720 = global_1.member[bitcast<u32>(select(0i, _e2714, (_e2714 > 0i)))];
let _e2722 = (_e2684 & 15i);
let _e2725 = ((_e2685 & 15i) * _e2678);
let _e2727 = (bitcast<i32>(_e2720) + ((_e2686 & 15i) * _e2683));
let _e2728 = (_e2725 + _e2678);
let _e2730 = (_e2725 + (2i * _e2678));
let _e2731 = (_e2727 + _e2683);
let _e2733 = (_e2727 + (2i * _e2683));
local_2 = type_28(array<i32, 4>(_e2722, _e2722, _e2722, _e2722), array<u32, 6>(0u, 8u, 16u, 24u, 0u, 0u));
local_3 = vec3<f32>((_e2620 - f32(_e2643)), (_e2624 - f32(_e2658)), (_e2628 - f32(_e2673)));
let _e2747 = local_2.member[0u];
let _e2748 = ((_e2731 + _e2728) + _e2747);
let _e2750 = (_e2748 >> bitcast<u32>(2i));
let _e2753 = bitcast<u32>(((_e2748 & 3i) * 8i));
let _e2755 = select(_e2712, _e2750, (_e2750 < _e2712));
let _e2760 = global_1.member[bitcast<u32>(select(0i, _e2755, (_e2755 > 0i)))];
let _e2764 = (_e2750 + 1i);
let _e2766 = select(_e2712, _e2764, (_e2764 < _e2712));
let _e2771 = global_1.member[bitcast<u32>(select(0i, _e2766, (_e2766 > 0i)))];
let _e2778 = ((_e2760 >> bitcast<u32>((_e2753 & 31u))) | ((_e2771 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2753) & 31u))));
let _e2781 = local_2.member_1[1u];
let _e2787 = f32(bitcast<i32>(((_e2778 >> bitcast<u32>((_e2781 & 31u))) & 255u)));
let _e2790 = local_2.member_1[2u];
let _e2797 = local_3[0u];
let _e2800 = (_e2787 + ((f32(bitcast<i32>(((_e2778 >> bitcast<u32>((_e2790 & 31u))) & 255u))) - _e2787) * _e2797));
let _e2802 = local_2.member[0u];
let _e2803 = ((_e2731 + _e2730) + _e2802);
let _e2805 = (_e2803 >> bitcast<u32>(2i));
let _e2808 = bitcast<u32>(((_e2803 & 3i) * 8i));
let _e2810 = select(_e2712, _e2805, (_e2805 < _e2712));
let _e2815 = global_1.member[bitcast<u32>(select(0i, _e2810, (_e2810 > 0i)))];
let _e2819 = (_e2805 + 1i);
let _e2821 = select(_e2712, _e2819, (_e2819 < _e2712));
let _e2826 = global_1.member[bitcast<u32>(select(0i, _e2821, (_e2821 > 0i)))];
let _e2833 = ((_e2815 >> bitcast<u32>((_e2808 & 31u))) | ((_e2826 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2808) & 31u))));
let _e2834 = local_2.member_1[1u];
let _e2840 = f32(bitcast<i32>(((_e2833 >> bitcast<u32>((_e2834 & 31u))) & 255u)));
let _e2841 = local_2.member_1[2u];
let _e2848 = local_3[0u];
let _e2853 = local_3[1u];
let _e2856 = (_e2800 + (((_e2840 + ((f32(bitcast<i32>(((_e2833 >> bitcast<u32>((_e2841 & 31u))) & 255u))) - _e2840) * _e2848)) - _e2800) * _e2853));
let _e2858 = local_2.member[0u];
let _e2859 = ((_e2733 + _e2728) + _e2858);
let _e2861 = (_e2859 >> bitcast<u32>(2i));
let _e2864 = bitcast<u32>(((_e2859 & 3i) * 8i));
let _e2866 = select(_e2712, _e2861, (_e2861 < _e2712));
let _e2871 = global_1.member[bitcast<u32>(select(0i, _e2866, (_e2866 > 0i)))];
let _e2875 = (_e2861 + 1i);
let _e2877 = select(_e2712, _e2875, (_e2875 < _e2712));
let _e2882 = global_1.member[bitcast<u32>(select(0i, _e2877, (_e2877 > 0i)))];
let _e2889 = ((_e2871 >> bitcast<u32>((_e2864 & 31u))) | ((_e2882 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2864) & 31u))));
let _e2890 = local_2.member_1[1u];
let _e2896 = f32(bitcast<i32>(((_e2889 >> bitcast<u32>((_e2890 & 31u))) & 255u)));
let _e2897 = local_2.member_1[2u];
let _e2904 = local_3[0u];
let _e2907 = (_e2896 + ((f32(bitcast<i32>(((_e2889 >> bitcast<u32>((_e2897 & 31u))) & 255u))) - _e2896) * _e2904));
let _e2909 = local_2.member[0u];
let _e2910 = ((_e2733 + _e2730) + _e2909);
let _e2912 = (_e2910 >> bitcast<u32>(2i));
let _e2915 = bitcast<u32>(((_e2910 & 3i) * 8i));
let _e2917 = select(_e2712, _e2912, (_e2912 < _e2712));
let _e2922 = global_1.member[bitcast<u32>(select(0i, _e2917, (_e2917 > 0i)))];
let _e2926 = (_e2912 + 1i);
let _e2928 = select(_e2712, _e2926, (_e2926 < _e2712));
let _e2933 = global_1.member[bitcast<u32>(select(0i, _e2928, (_e2928 > 0i)))];
let _e2940 = ((_e2922 >> bitcast<u32>((_e2915 & 31u))) | ((_e2933 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2915) & 31u))));
let _e2941 = local_2.member_1[1u];
let _e2947 = f32(bitcast<i32>(((_e2940 >> bitcast<u32>((_e2941 & 31u))) & 255u)));
let _e2948 = local_2.member_1[2u];
let _e2955 = local_3[0u];
let _e2959 = local_3[1u];
let _e2964 = local_3[2u];
let _e2972 = global_5.member[_e354].member_6.member_5;
let _e2978 = global_5.member[_e354].member_6.member_6;
let _e2979 = (((_e2856 + (((_e2907 + (((_e2947 + ((f32(bitcast<i32>(((_e2940 >> bitcast<u32>((_e2948 & 31u))) & 255u))) - _e2947) * _e2955)) - _e2907) * _e2959)) - _e2856) * _e2964)) * _e2972) + _e2978);
let _e2981 = select(0f, _e2979, (_e2979 > 0f));
let _e2983 = select(1f, _e2981, (_e2981 < 1f));
let _e2984 = select(_e358[6], _e2983, _e721);
if _e805 {
let _e2985 = (_e2983 * 1024f);
let _e2986 = (1024f - 1f);
let _e2988 = select(0f, _e2985, (_e2985 > 0f));
let _e2990 = select(_e2986, _e2988, (_e2988 < _e2986));
let _e2997 = select(0i, select(select(i32(_e2990), i32(-2147483648), (_e2990 < -2147483600f)), 2147483647i, (_e2990 > 2147483500f)), (_e2990 == _e2990));
let _e3001 = (_e2997 - select(0i, 1i, (_e2990 < f32(_e2997))));
let _e3002 = (262147i + _e3001);
let _e3004 = (bitcast<i32>(_e125) - 1i);
let _e3006 = select(_e3004, _e3002, (_e3002 < _e3004));
let _e3012 = global_3.member[bitcast<u32>(select(0i, _e3006, (_e3006 > 0i)))];
let _e3022 = select(_e3004, 262146i, (262146i < _e3004));
let _e3028 = global_3.member[bitcast<u32>(select(0i, _e3022, (_e3022 > 0i)))];
let _e3032 = select(_e3004, 262144i, (262144i < _e3004));
let _e3038 = global_3.member[bitcast<u32>(select(0i, _e3032, (_e3032 > 0i)))];
let _e3041 = select(_e3004, 262145i, (262145i < _e3004));
let _e3047 = global_3.member[bitcast<u32>(select(0i, _e3041, (_e3041 > 0i)))];
phi_4957_ = select(_e358[16], ((bitcast<f32>(_e3038) + (f32(bitcast<i32>((_e3012 >> bitcast<u32>(12u)))) * bitcast<f32>(_e3047))) + ((f32((bitcast<i32>((_e3012 & 4095u)) - 2048i)) * bitcast<f32>(_e3028)) * (_e2985 - f32(_e3001)))), _e721);
} else {
phi_4957_ = _e358[16];
}
let _e3057 = phi_4957_;
let _e3060 = select(1f, select(1f, _e800, (_e800 < 1f)), _e446);
if ((_e689 & 16u) == 0u) {
phi_5346_ = type_5(1f, 1f, 1f);
} else {
let _e3067 = global_5.member[_e354].member_14.member;
let _e3078 = ((((_e3067.member.member * _e382) + (_e3067.member.member_1 * _e384)) + (_e3067.member.member_2 * _e378)) + _e3067.member_1);
let _e3084 = ((((_e3067.member.member * _e386) + (_e3067.member.member_1 * _e388)) + (_e3067.member.member_2 * _e393)) + _e3067.member_1);
let _e3086 = select(_e3084, _e3078, (_e3078 < _e3084));
let _e3088 = select(_e3084, _e3078, (_e3078 > _e3084));
let _e3090 = (_e3088 - _e3086);
let _e3093 = (-(_e3086) / select(1e-30f, _e3090, (_e3090 > 1e-30f)));
let _e3095 = select(0f, _e3093, (_e3093 > 0f));
let _e3101 = select(select(select(1f, _e3095, (_e3095 < 1f)), 1f, (_e3088 <= 0f)), 0f, (_e3086 > 0f));
let _e3107 = global_5.member[_e354].member_14.member_1;
let _e3108 = (_e3107 != 0u);
let _e3119 = global_5.member[_e354].member_15.member;
let _e3130 = ((((_e3119.member.member * _e382) + (_e3119.member.member_1 * _e384)) + (_e3119.member.member_2 * _e378)) + _e3119.member_1);
let _e3136 = ((((_e3119.member.member * _e386) + (_e3119.member.member_1 * _e388)) + (_e3119.member.member_2 * _e393)) + _e3119.member_1);
let _e3138 = select(_e3136, _e3130, (_e3130 < _e3136));
let _e3140 = select(_e3136, _e3130, (_e3130 > _e3136));
let _e3142 = (_e3140 - _e3138);
let _e3145 = (-(_e3138) / select(1e-30f, _e3142, (_e3142 > 1e-30f)));
let _e3147 = select(0f, _e3145, (_e3145 > 0f));
let _e3153 = select(select(select(1f, _e3147, (_e3147 < 1f)), 1f, (_e3140 <= 0f)), 0f, (_e3138 > 0f));
let _e3159 = global_5.member[_e354].member_15.member_1;
let _e3160 = (_e3159 != 0u);
let _e3171 = global_5.member[_e354].member_16.member;
let _e3182 = ((((_e3171.member.member * _e382) + (_e3171.member.member_1 * _e384)) + (_e3171.member.member_2 * _e378)) + _e3171.member_1);
let _e3188 = ((((_e3171.member.member * _e386) + (_e3171.member.member_1 * _e388)) + (_e3171.member.member_2 * _e393)) + _e3171.member_1);
let _e3190 = select(_e3188, _e3182, (_e3182 < _e3188));
let _e3192 = select(_e3188, _e3182, (_e3182 > _e3188));
let _e3194 = (_e3192 - _e3190);
let _e3197 = (-(_e3190) / select(1e-30f, _e3194, (_e3194 > 1e-30f)));
let _e3199 = select(0f, _e3197, (_e3197 > 0f));
let _e3205 = select(select(select(1f, _e3199, (_e3199 < 1f)), 1f, (_e3192 <= 0f)), 0f, (_e3190 > 0f));
let _e3211 = global_5.member[_e354].member_16.member_1;
let _e3212 = (_e3211 != 0u);
let _e3223 = global_5.member[_e354].member_17.member;
let _e3234 = ((((_e3223.member.member * _e382) + (_e3223.member.member_1 * _e384)) + (_e3223.member.member_2 * _e378)) + _e3223.member_1);
let _e3240 = ((((_e3223.member.member * _e386) + (_e3223.member.member_1 * _e388)) + (_e3223.member.member_2 * _e393)) + _e3223.member_1);
let _e3242 = select(_e3240, _e3234, (_e3234 < _e3240));
let _e3244 = select(_e3240, _e3234, (_e3234 > _e3240));
let _e3246 = (_e3244 - _e3242);
let _e3249 = (-(_e3242) / select(1e-30f, _e3246, (_e3246 > 1e-30f)));
let _e3251 = select(0f, _e3249, (_e3249 > 0f));
let _e3257 = select(select(select(1f, _e3251, (_e3251 < 1f)), 1f, (_e3244 <= 0f)), 0f, (_e3242 > 0f));
let _e3263 = global_5.member[_e354].member_17.member_1;
let _e3264 = (_e3263 != 0u);
phi_5346_ = type_5(((((1f * _e3101) * _e3153) * _e3205) * _e3257), ((((1f * select(1f, _e3101, _e3108)) * select(1f, _e3153, _e3160)) * select(1f, _e3205, _e3212)) * select(1f, _e3257, _e3264)), ((((1f * select(1f, 0f, (_e3108 && (_e3084 > 0f)))) * select(1f, 0f, (_e3160 && (_e3136 > 0f)))) * select(1f, 0f, (_e3212 && (_e3188 > 0f)))) * select(1f, 0f, (_e3264 && (_e3240 > 0f)))));
}
let _e3273 = phi_5346_;
let _e3274 = (_e556 < 1e-12f);
let _e3276 = (1f / select(_e551, 1f, _e3274));
let _e3278 = ((-0.5f - _e462) * _e3276);
let _e3280 = ((_e524 - _e462) * _e3276);
let _e3286 = select(_e3280, _e3278, (_e3278 < _e3280));
let _e3288 = select(0f, _e3286, (_e3286 > 0f));
let _e3291 = select(select(1f, _e3288, (_e3288 < 1f)), select(2f, 0f, ((_e462 >= -0.5f) && (_e462 <= _e524))), _e3274);
let _e3293 = select(_e3280, _e3278, (_e3278 > _e3280));
let _e3295 = select(0f, _e3293, (_e3293 > 0f));
let _e3298 = select(select(1f, _e3295, (_e3295 < 1f)), 1f, _e3274);
let _e3299 = (_e559 < 1e-12f);
let _e3301 = (1f / select(_e552, 1f, _e3299));
let _e3303 = ((-0.5f - _e478) * _e3301);
let _e3305 = ((_e535 - _e478) * _e3301);
let _e3311 = select(_e3305, _e3303, (_e3303 < _e3305));
let _e3313 = select(0f, _e3311, (_e3311 > 0f));
let _e3316 = select(select(1f, _e3313, (_e3313 < 1f)), select(2f, 0f, ((_e478 >= -0.5f) && (_e478 <= _e535))), _e3299);
let _e3318 = select(_e3305, _e3303, (_e3303 > _e3305));
let _e3320 = select(0f, _e3318, (_e3318 > 0f));
let _e3323 = select(select(1f, _e3320, (_e3320 < 1f)), 1f, _e3299);
let _e3324 = (_e564 < 1e-12f);
let _e3326 = (1f / select(_e553, 1f, _e3324));
let _e3328 = ((-0.5f - _e494) * _e3326);
let _e3330 = ((_e546 - _e494) * _e3326);
let _e3336 = select(_e3330, _e3328, (_e3328 < _e3330));
let _e3338 = select(0f, _e3336, (_e3336 > 0f));
let _e3341 = select(select(1f, _e3338, (_e3338 < 1f)), select(2f, 0f, ((_e494 >= -0.5f) && (_e494 <= _e546))), _e3324);
let _e3343 = select(_e3330, _e3328, (_e3328 > _e3330));
let _e3345 = select(0f, _e3343, (_e3343 > 0f));
let _e3348 = select(select(1f, _e3345, (_e3345 < 1f)), 1f, _e3324);
let _e3350 = select(_e3323, _e3298, (_e3298 < _e3323));
let _e3354 = select(_e3316, _e3291, (_e3291 > _e3316));
let _e3357 = (select(_e3348, _e3350, (_e3350 < _e3348)) - select(_e3341, _e3354, (_e3354 > _e3341)));
let _e3360 = (_e386 - _e382);
let _e3361 = (_e388 - _e384);
let _e3362 = (_e393 - _e378);
let _e3367 = (((_e3360 * _e3360) + (_e3361 * _e3361)) + (_e3362 * _e3362));
let _e3377 = global_5.member[_e354].member_5.member_3;
let _e3378 = (((sqrt(select(0f, _e3367, (_e3367 > 0f))) * select(0f, _e3357, (_e3357 > 0f))) * _e3060) * _e3377);
let _e3379 = (_e731.member_2 >= 3u);
if _e3379 {
let _e3381 = (_e2984 * 255f);
let _e3382 = (_e2616.member * 255f);
let _e3383 = (255f - 1f);
let _e3385 = select(0f, _e3381, (_e3381 > 0f));
let _e3387 = select(_e3383, _e3385, (_e3385 < _e3383));
let _e3394 = select(0i, select(select(i32(_e3387), i32(-2147483648), (_e3387 < -2147483600f)), 2147483647i, (_e3387 > 2147483500f)), (_e3387 == _e3387));
let _e3398 = (_e3394 - select(0i, 1i, (_e3387 < f32(_e3394))));
let _e3400 = select(0f, _e3382, (_e3382 > 0f));
let _e3402 = select(_e3383, _e3400, (_e3400 < _e3383));
let _e3409 = select(0i, select(select(i32(_e3402), i32(-2147483648), (_e3402 < -2147483600f)), 2147483647i, (_e3402 > 2147483500f)), (_e3402 == _e3402));
let _e3413 = (_e3409 - select(0i, 1i, (_e3402 < f32(_e3409))));
let _e3416 = (((_e3398 * 256i) + _e3413) * 4i);
let _e3418 = (_e3381 - f32(_e3398));
let _e3420 = (_e3382 - f32(_e3413));
let _e3421 = (_e3416 + 2i);
let _e3423 = (bitcast<i32>(_e125) - 1i);
let _e3425 = select(_e3423, _e3421, (_e3421 < _e3423));
let _e3431 = global_3.member[bitcast<u32>(select(0i, _e3425, (_e3425 > 0i)))];
let _e3432 = (_e3416 + 6i);
let _e3434 = select(_e3423, _e3432, (_e3432 < _e3423));
let _e3440 = global_3.member[bitcast<u32>(select(0i, _e3434, (_e3434 > 0i)))];
let _e3441 = (_e3416 + 1026i);
let _e3443 = select(_e3423, _e3441, (_e3441 < _e3423));
let _e3449 = global_3.member[bitcast<u32>(select(0i, _e3443, (_e3443 > 0i)))];
let _e3450 = (_e3416 + 1030i);
let _e3452 = select(_e3423, _e3450, (_e3450 < _e3423));
let _e3458 = global_3.member[bitcast<u32>(select(0i, _e3452, (_e3452 > 0i)))];
let _e3463 = (bitcast<f32>(((_e3431 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3471 = (_e3463 + (((bitcast<f32>(((_e3440 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3463) * _e3420));
let _e3476 = (bitcast<f32>(((_e3449 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3500 = (bitcast<f32>((((_e3431 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3508 = (_e3500 + (((bitcast<f32>((((_e3440 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3500) * _e3420));
let _e3513 = (bitcast<f32>((((_e3449 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3525 = (_e3416 + 3i);
let _e3527 = select(_e3423, _e3525, (_e3525 < _e3423));
let _e3533 = global_3.member[bitcast<u32>(select(0i, _e3527, (_e3527 > 0i)))];
let _e3534 = (_e3416 + 7i);
let _e3536 = select(_e3423, _e3534, (_e3534 < _e3423));
let _e3542 = global_3.member[bitcast<u32>(select(0i, _e3536, (_e3536 > 0i)))];
let _e3543 = (_e3416 + 1027i);
let _e3545 = select(_e3423, _e3543, (_e3543 < _e3423));
let _e3551 = global_3.member[bitcast<u32>(select(0i, _e3545, (_e3545 > 0i)))];
let _e3552 = (_e3416 + 1031i);
let _e3554 = select(_e3423, _e3552, (_e3552 < _e3423));
let _e3560 = global_3.member[bitcast<u32>(select(0i, _e3554, (_e3554 > 0i)))];
let _e3565 = (bitcast<f32>(((_e3533 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3573 = (_e3565 + (((bitcast<f32>(((_e3542 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3565) * _e3420));
let _e3578 = (bitcast<f32>(((_e3551 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3602 = (bitcast<f32>((((_e3533 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3610 = (_e3602 + (((bitcast<f32>((((_e3542 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3602) * _e3420));
let _e3615 = (bitcast<f32>((((_e3551 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3626 = (_e3610 + (((_e3615 + (((bitcast<f32>((((_e3560 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3615) * _e3420)) - _e3610) * _e3418));
let _e3630 = -((_e3626 * (_e3378 * _e3273.member)));
let _e3632 = select(-87f, _e3630, (_e3630 > -87f));
let _e3634 = select(88f, _e3632, (_e3632 < 88f));
let _e3636 = ((_e3634 * 1.442695f) + 0.5f);
let _e3638 = select(-127f, _e3636, (_e3636 > -127f));
let _e3640 = select(128f, _e3638, (_e3638 < 128f));
let _e3647 = select(0i, select(select(i32(_e3640), i32(-2147483648), (_e3640 < -2147483600f)), 2147483647i, (_e3640 > 2147483500f)), (_e3640 == _e3640));
let _e3651 = (_e3647 - select(0i, 1i, (_e3640 < f32(_e3647))));
let _e3652 = f32(_e3651);
let _e3656 = ((_e3634 - (_e3652 * 0.6933594f)) - (_e3652 * -2.1219444e-4f));
let _e3676 = ((1f + (_e3656 * (1f + (_e3656 * (0.5f + (_e3656 * (0.16666667f + (_e3656 * (0.041666668f + (_e3656 * (0.008333334f + (_e3656 * (0.001388889f + (_e3656 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3651 + 127i)) << bitcast<u32>(23i))));
let _e3677 = (1f - _e3676);
let _e3680 = (_e3677 / select(1e-12f, _e3626, (_e3626 > 1e-12f)));
phi_6904_ = type_31(_e3676, _e3677, vec3<f32>(1f, 1f, 1f), vec3<f32>(((_e3471 + (((_e3476 + (((bitcast<f32>(((_e3458 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3476) * _e3420)) - _e3471) * _e3418)) * _e3680), ((_e3508 + (((_e3513 + (((bitcast<f32>((((_e3458 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3513) * _e3420)) - _e3508) * _e3418)) * _e3680), ((_e3573 + (((_e3578 + (((bitcast<f32>(((_e3560 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3578) * _e3420)) - _e3573) * _e3418)) * _e3680)));
} else {
let _e3687 = (_e2984 * 255f);
let _e3688 = (_e2616.member * 255f);
let _e3689 = (255f - 1f);
let _e3691 = select(0f, _e3687, (_e3687 > 0f));
let _e3693 = select(_e3689, _e3691, (_e3691 < _e3689));
let _e3700 = select(0i, select(select(i32(_e3693), i32(-2147483648), (_e3693 < -2147483600f)), 2147483647i, (_e3693 > 2147483500f)), (_e3693 == _e3693));
let _e3704 = (_e3700 - select(0i, 1i, (_e3693 < f32(_e3700))));
let _e3706 = select(0f, _e3688, (_e3688 > 0f));
let _e3708 = select(_e3689, _e3706, (_e3706 < _e3689));
let _e3715 = select(0i, select(select(i32(_e3708), i32(-2147483648), (_e3708 < -2147483600f)), 2147483647i, (_e3708 > 2147483500f)), (_e3708 == _e3708));
let _e3719 = (_e3715 - select(0i, 1i, (_e3708 < f32(_e3715))));
let _e3722 = (((_e3704 * 256i) + _e3719) * 4i);
let _e3724 = (_e3687 - f32(_e3704));
let _e3726 = (_e3688 - f32(_e3719));
let _e3728 = (bitcast<i32>(_e125) - 1i);
let _e3730 = select(_e3728, _e3722, (_e3722 < _e3728));
let _e3736 = global_3.member[bitcast<u32>(select(0i, _e3730, (_e3730 > 0i)))];
let _e3737 = (_e3722 + 4i);
let _e3739 = select(_e3728, _e3737, (_e3737 < _e3728));
let _e3745 = global_3.member[bitcast<u32>(select(0i, _e3739, (_e3739 > 0i)))];
let _e3746 = (_e3722 + 1024i);
let _e3748 = select(_e3728, _e3746, (_e3746 < _e3728));
let _e3754 = global_3.member[bitcast<u32>(select(0i, _e3748, (_e3748 > 0i)))];
let _e3755 = (_e3722 + 1028i);
let _e3757 = select(_e3728, _e3755, (_e3755 < _e3728));
let _e3763 = global_3.member[bitcast<u32>(select(0i, _e3757, (_e3757 > 0i)))];
let _e3768 = (bitcast<f32>(((_e3736 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3776 = (_e3768 + (((bitcast<f32>(((_e3745 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3768) * _e3726));
let _e3781 = (bitcast<f32>(((_e3754 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3792 = (_e3776 + (((_e3781 + (((bitcast<f32>(((_e3763 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3781) * _e3726)) - _e3776) * _e3724));
let _e3805 = (bitcast<f32>((((_e3736 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3813 = (_e3805 + (((bitcast<f32>((((_e3745 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3805) * _e3726));
let _e3818 = (bitcast<f32>((((_e3754 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3830 = (_e3722 + 1i);
let _e3832 = select(_e3728, _e3830, (_e3830 < _e3728));
let _e3838 = global_3.member[bitcast<u32>(select(0i, _e3832, (_e3832 > 0i)))];
let _e3839 = (_e3722 + 5i);
let _e3841 = select(_e3728, _e3839, (_e3839 < _e3728));
let _e3847 = global_3.member[bitcast<u32>(select(0i, _e3841, (_e3841 > 0i)))];
let _e3848 = (_e3722 + 1025i);
let _e3850 = select(_e3728, _e3848, (_e3848 < _e3728));
let _e3856 = global_3.member[bitcast<u32>(select(0i, _e3850, (_e3850 > 0i)))];
let _e3857 = (_e3722 + 1029i);
let _e3859 = select(_e3728, _e3857, (_e3857 < _e3728));
let _e3865 = global_3.member[bitcast<u32>(select(0i, _e3859, (_e3859 > 0i)))];
let _e3870 = (bitcast<f32>(((_e3838 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3878 = (_e3870 + (((bitcast<f32>(((_e3847 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3870) * _e3726));
let _e3883 = (bitcast<f32>(((_e3856 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3907 = (bitcast<f32>((((_e3838 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3915 = (_e3907 + (((bitcast<f32>((((_e3847 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3907) * _e3726));
let _e3920 = (bitcast<f32>((((_e3856 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3932 = (_e3722 + 2i);
let _e3934 = select(_e3728, _e3932, (_e3932 < _e3728));
let _e3940 = global_3.member[bitcast<u32>(select(0i, _e3934, (_e3934 > 0i)))];
let _e3941 = (_e3722 + 6i);
let _e3943 = select(_e3728, _e3941, (_e3941 < _e3728));
let _e3949 = global_3.member[bitcast<u32>(select(0i, _e3943, (_e3943 > 0i)))];
let _e3950 = (_e3722 + 1026i);
let _e3952 = select(_e3728, _e3950, (_e3950 < _e3728));
let _e3958 = global_3.member[bitcast<u32>(select(0i, _e3952, (_e3952 > 0i)))];
let _e3959 = (_e3722 + 1030i);
let _e3961 = select(_e3728, _e3959, (_e3959 < _e3728));
let _e3967 = global_3.member[bitcast<u32>(select(0i, _e3961, (_e3961 > 0i)))];
let _e3972 = (bitcast<f32>(((_e3940 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3980 = (_e3972 + (((bitcast<f32>(((_e3949 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3972) * _e3726));
let _e3985 = (bitcast<f32>(((_e3958 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4009 = (bitcast<f32>((((_e3940 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4017 = (_e4009 + (((bitcast<f32>((((_e3949 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4009) * _e3726));
let _e4022 = (bitcast<f32>((((_e3958 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4034 = (_e3722 + 3i);
let _e4036 = select(_e3728, _e4034, (_e4034 < _e3728));
let _e4042 = global_3.member[bitcast<u32>(select(0i, _e4036, (_e4036 > 0i)))];
let _e4043 = (_e3722 + 7i);
let _e4045 = select(_e3728, _e4043, (_e4043 < _e3728));
let _e4051 = global_3.member[bitcast<u32>(select(0i, _e4045, (_e4045 > 0i)))];
let _e4052 = (_e3722 + 1027i);
let _e4054 = select(_e3728, _e4052, (_e4052 < _e3728));
let _e4060 = global_3.member[bitcast<u32>(select(0i, _e4054, (_e4054 > 0i)))];
let _e4061 = (_e3722 + 1031i);
let _e4063 = select(_e3728, _e4061, (_e4061 < _e3728));
let _e4069 = global_3.member[bitcast<u32>(select(0i, _e4063, (_e4063 > 0i)))];
let _e4074 = (bitcast<f32>(((_e4042 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4082 = (_e4074 + (((bitcast<f32>(((_e4051 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4074) * _e3726));
let _e4087 = (bitcast<f32>(((_e4060 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4102 = (_e3378 * _e3273.member_1);
let _e4104 = -(((_e3813 + (((_e3818 + (((bitcast<f32>((((_e3763 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3818) * _e3726)) - _e3813) * _e3724)) * _e4102));
let _e4106 = select(-87f, _e4104, (_e4104 > -87f));
let _e4108 = select(88f, _e4106, (_e4106 < 88f));
let _e4110 = ((_e4108 * 1.442695f) + 0.5f);
let _e4112 = select(-127f, _e4110, (_e4110 > -127f));
let _e4114 = select(128f, _e4112, (_e4112 < 128f));
let _e4121 = select(0i, select(select(i32(_e4114), i32(-2147483648), (_e4114 < -2147483600f)), 2147483647i, (_e4114 > 2147483500f)), (_e4114 == _e4114));
let _e4125 = (_e4121 - select(0i, 1i, (_e4114 < f32(_e4121))));
let _e4126 = f32(_e4125);
let _e4130 = ((_e4108 - (_e4126 * 0.6933594f)) - (_e4126 * -2.1219444e-4f));
let _e4152 = -(((_e3878 + (((_e3883 + (((bitcast<f32>(((_e3865 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3883) * _e3726)) - _e3878) * _e3724)) * _e4102));
let _e4154 = select(-87f, _e4152, (_e4152 > -87f));
let _e4156 = select(88f, _e4154, (_e4154 < 88f));
let _e4158 = ((_e4156 * 1.442695f) + 0.5f);
let _e4160 = select(-127f, _e4158, (_e4158 > -127f));
let _e4162 = select(128f, _e4160, (_e4160 < 128f));
let _e4169 = select(0i, select(select(i32(_e4162), i32(-2147483648), (_e4162 < -2147483600f)), 2147483647i, (_e4162 > 2147483500f)), (_e4162 == _e4162));
let _e4173 = (_e4169 - select(0i, 1i, (_e4162 < f32(_e4169))));
let _e4174 = f32(_e4173);
let _e4178 = ((_e4156 - (_e4174 * 0.6933594f)) - (_e4174 * -2.1219444e-4f));
let _e4200 = -(((_e3915 + (((_e3920 + (((bitcast<f32>((((_e3865 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3920) * _e3726)) - _e3915) * _e3724)) * _e4102));
let _e4202 = select(-87f, _e4200, (_e4200 > -87f));
let _e4204 = select(88f, _e4202, (_e4202 < 88f));
let _e4206 = ((_e4204 * 1.442695f) + 0.5f);
let _e4208 = select(-127f, _e4206, (_e4206 > -127f));
let _e4210 = select(128f, _e4208, (_e4208 < 128f));
let _e4217 = select(0i, select(select(i32(_e4210), i32(-2147483648), (_e4210 < -2147483600f)), 2147483647i, (_e4210 > 2147483500f)), (_e4210 == _e4210));
let _e4221 = (_e4217 - select(0i, 1i, (_e4210 < f32(_e4217))));
let _e4222 = f32(_e4221);
let _e4226 = ((_e4204 - (_e4222 * 0.6933594f)) - (_e4222 * -2.1219444e-4f));
let _e4249 = -((_e3792 * (_e3378 * _e3273.member)));
let _e4251 = select(-87f, _e4249, (_e4249 > -87f));
let _e4253 = select(88f, _e4251, (_e4251 < 88f));
let _e4255 = ((_e4253 * 1.442695f) + 0.5f);
let _e4257 = select(-127f, _e4255, (_e4255 > -127f));
let _e4259 = select(128f, _e4257, (_e4257 < 128f));
let _e4266 = select(0i, select(select(i32(_e4259), i32(-2147483648), (_e4259 < -2147483600f)), 2147483647i, (_e4259 > 2147483500f)), (_e4259 == _e4259));
let _e4270 = (_e4266 - select(0i, 1i, (_e4259 < f32(_e4266))));
let _e4271 = f32(_e4270);
let _e4275 = ((_e4253 - (_e4271 * 0.6933594f)) - (_e4271 * -2.1219444e-4f));
let _e4295 = ((1f + (_e4275 * (1f + (_e4275 * (0.5f + (_e4275 * (0.16666667f + (_e4275 * (0.041666668f + (_e4275 * (0.008333334f + (_e4275 * (0.001388889f + (_e4275 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4270 + 127i)) << bitcast<u32>(23i))));
let _e4296 = (1f - _e4295);
let _e4299 = (_e4296 / select(1e-12f, _e3792, (_e3792 > 1e-12f)));
phi_6904_ = type_31(_e4295, _e4296, vec3<f32>(((1f + (_e4130 * (1f + (_e4130 * (0.5f + (_e4130 * (0.16666667f + (_e4130 * (0.041666668f + (_e4130 * (0.008333334f + (_e4130 * (0.001388889f + (_e4130 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4125 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e4178 * (1f + (_e4178 * (0.5f + (_e4178 * (0.16666667f + (_e4178 * (0.041666668f + (_e4178 * (0.008333334f + (_e4178 * (0.001388889f + (_e4178 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4173 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e4226 * (1f + (_e4226 * (0.5f + (_e4226 * (0.16666667f + (_e4226 * (0.041666668f + (_e4226 * (0.008333334f + (_e4226 * (0.001388889f + (_e4226 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4221 + 127i)) << bitcast<u32>(23i))))), vec3<f32>(((_e3980 + (((_e3985 + (((bitcast<f32>(((_e3967 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3985) * _e3726)) - _e3980) * _e3724)) * _e4299), ((_e4017 + (((_e4022 + (((bitcast<f32>((((_e3967 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4022) * _e3726)) - _e4017) * _e3724)) * _e4299), ((_e4082 + (((_e4087 + (((bitcast<f32>(((_e4069 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4087) * _e3726)) - _e4082) * _e3724)) * _e4299)));
}
let _e4306 = phi_6904_;
let _e4307 = select(0f, _e3060, _e446);
let _e4311 = (_e382 + (_e3360 * _e4307));
let _e4312 = (_e384 + (_e3361 * _e4307));
let _e4313 = (_e378 + (_e3362 * _e4307));
if (_e731.member_2 == 3u) {
let _e4319 = global_5.member[_e354].member_9.member_1;
let _e4328 = global_5.member[_e354].member_9.member;
phi_7887_ = type_25(vec3<f32>(_e4319.member, _e4319.member_1, _e4319.member_2), vec3<f32>(_e4328.member, _e4328.member_1, _e4328.member_2));
} else {
let _e4338 = global_5.member[_e354].member_8.member_8;
let _e4339 = (_e4313 - _e4338);
let _e4344 = global_5.member[_e354].member_8.member_2;
let _e4349 = global_5.member[_e354].member_8.member_6;
let _e4357 = global_5.member[_e354].member_8.member_5;
let _e4359 = (((_e4311 - (_e4344 + (_e4349 * _e4339))) * _e4357) - 0.5f);
let _e4364 = global_5.member[_e354].member_8.member_3;
let _e4369 = global_5.member[_e354].member_8.member_7;
let _e4374 = (((_e4312 - (_e4364 + (_e4369 * _e4339))) * _e4357) - 0.5f);
let _e4379 = global_5.member[_e354].member_8.member;
let _e4380 = bitcast<i32>(_e4379);
let _e4382 = (f32(_e4380) - 1f);
let _e4387 = global_5.member[_e354].member_8.member_1;
let _e4390 = (f32(bitcast<i32>(_e4387)) - 1f);
let _e4392 = select(0f, _e4359, (_e4359 > 0f));
let _e4394 = select(_e4382, _e4392, (_e4392 < _e4382));
let _e4401 = select(0i, select(select(i32(_e4394), i32(-2147483648), (_e4394 < -2147483600f)), 2147483647i, (_e4394 > 2147483500f)), (_e4394 == _e4394));
let _e4405 = (_e4401 - select(0i, 1i, (_e4394 < f32(_e4401))));
let _e4407 = select(0f, _e4374, (_e4374 > 0f));
let _e4409 = select(_e4390, _e4407, (_e4407 < _e4390));
let _e4416 = select(0i, select(select(i32(_e4409), i32(-2147483648), (_e4409 < -2147483600f)), 2147483647i, (_e4409 > 2147483500f)), (_e4409 == _e4409));
let _e4420 = (_e4416 - select(0i, 1i, (_e4409 < f32(_e4416))));
let _e4424 = (_e4359 - f32(_e4405));
let _e4426 = (_e4374 - f32(_e4420));
let _e4433 = ((((_e4359 >= 0f) && (_e4359 <= _e4382)) && (_e4374 >= 0f)) && (_e4374 <= _e4390));
let _e4437 = global_5.member[_e354].member_4;
let _e4438 = bitcast<i32>(_e4437);
let _e4440 = bitcast<i32>((_e4379 * _e4387));
let _e4442 = (_e4438 + (3i * _e4440));
local_1 = (_e4442 + ((_e4420 * _e4380) + _e4405));
let _e4444 = local_1;
let _e4446 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e4448 = select(_e4446, _e4444, (_e4444 < _e4446));
let _e4453 = global_6.member[bitcast<u32>(select(0i, _e4448, (_e4448 > 0i)))];
let _e4454 = bitcast<u32>(_e4453);
let _e4458 = f32((bitcast<i32>((_e4454 & 65535u)) - 32768i));
let _e4464 = f32((bitcast<i32>(((_e4454 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4469 = select(_e4464, -(_e4464), ((_e4454 >> bitcast<u32>(31i)) != 0u));
let _e4470 = local_1;
let _e4471 = (_e4470 + 1i);
let _e4473 = select(_e4446, _e4471, (_e4471 < _e4446));
let _e4478 = global_6.member[bitcast<u32>(select(0i, _e4473, (_e4473 > 0i)))];
let _e4479 = bitcast<u32>(_e4478);
let _e4489 = f32((bitcast<i32>(((_e4479 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4495 = local_1;
let _e4496 = (_e4495 + _e4380);
let _e4498 = select(_e4446, _e4496, (_e4496 < _e4446));
let _e4503 = global_6.member[bitcast<u32>(select(0i, _e4498, (_e4498 > 0i)))];
let _e4504 = bitcast<u32>(_e4503);
let _e4508 = f32((bitcast<i32>((_e4504 & 65535u)) - 32768i));
let _e4514 = f32((bitcast<i32>(((_e4504 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4519 = select(_e4514, -(_e4514), ((_e4504 >> bitcast<u32>(31i)) != 0u));
let _e4520 = (_e4380 + 1i);
let _e4521 = local_1;
let _e4522 = (_e4521 + _e4520);
let _e4524 = select(_e4446, _e4522, (_e4522 < _e4446));
let _e4529 = global_6.member[bitcast<u32>(select(0i, _e4524, (_e4524 > 0i)))];
let _e4530 = bitcast<u32>(_e4529);
let _e4540 = f32((bitcast<i32>(((_e4530 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4548 = (_e4458 + ((f32((bitcast<i32>((_e4479 & 65535u)) - 32768i)) - _e4458) * _e4424));
let _e4557 = (_e4469 + ((select(_e4489, -(_e4489), ((_e4479 >> bitcast<u32>(31i)) != 0u)) - _e4469) * _e4424));
let _e4570 = global_5.member[_e354].member_9.member;
let _e4573 = (1f / 16255f);
let _e4575 = (_e4570.member + (select(0f, (_e4548 + (((_e4508 + ((f32((bitcast<i32>((_e4530 & 65535u)) - 32768i)) - _e4508) * _e4424)) - _e4548) * _e4426)), _e4433) * _e4573));
let _e4577 = (_e4570.member_1 + (select(0f, (_e4557 + (((_e4519 + ((select(_e4540, -(_e4540), ((_e4530 >> bitcast<u32>(31i)) != 0u)) - _e4519) * _e4424)) - _e4557) * _e4426)), _e4433) * _e4573));
let _e4581 = (1f - ((_e4575 * _e4575) + (_e4577 * _e4577)));
let _e4583 = select(1e-4f, _e4581, (_e4581 > 1e-4f));
let _e4586 = sqrt(select(0f, _e4583, (_e4583 > 0f)));
let _e4590 = (1f / select(1e-6f, _e4586, (_e4586 > 1e-6f)));
let _e4591 = ((_e4313 - _e378) * _e4357);
let _e4598 = (_e4359 - (((_e4575 * _e4590) - _e4349) * _e4591));
let _e4599 = (_e4374 - (((_e4577 * _e4590) - _e4369) * _e4591));
let _e4601 = select(0f, _e4598, (_e4598 > 0f));
let _e4603 = select(_e4382, _e4601, (_e4601 < _e4382));
let _e4610 = select(0i, select(select(i32(_e4603), i32(-2147483648), (_e4603 < -2147483600f)), 2147483647i, (_e4603 > 2147483500f)), (_e4603 == _e4603));
let _e4614 = (_e4610 - select(0i, 1i, (_e4603 < f32(_e4610))));
let _e4616 = select(0f, _e4599, (_e4599 > 0f));
let _e4618 = select(_e4390, _e4616, (_e4616 < _e4390));
let _e4625 = select(0i, select(select(i32(_e4618), i32(-2147483648), (_e4618 < -2147483600f)), 2147483647i, (_e4618 > 2147483500f)), (_e4618 == _e4618));
let _e4629 = (_e4625 - select(0i, 1i, (_e4618 < f32(_e4625))));
let _e4631 = ((_e4629 * _e4380) + _e4614);
let _e4633 = (_e4598 - f32(_e4614));
let _e4635 = (_e4599 - f32(_e4629));
let _e4642 = ((((_e4598 >= 0f) && (_e4598 <= _e4382)) && (_e4599 >= 0f)) && (_e4599 <= _e4390));
let _e4643 = (_e4438 + _e4631);
let _e4645 = select(_e4446, _e4643, (_e4643 < _e4446));
let _e4651 = global_6.member[bitcast<u32>(select(0i, _e4645, (_e4645 > 0i)))];
let _e4652 = (_e4643 + 1i);
let _e4654 = select(_e4446, _e4652, (_e4652 < _e4446));
let _e4660 = global_6.member[bitcast<u32>(select(0i, _e4654, (_e4654 > 0i)))];
let _e4663 = (_e4651 + ((_e4660 - _e4651) * _e4633));
let _e4664 = (_e4643 + _e4380);
let _e4666 = select(_e4446, _e4664, (_e4664 < _e4446));
let _e4672 = global_6.member[bitcast<u32>(select(0i, _e4666, (_e4666 > 0i)))];
let _e4673 = (_e4664 + 1i);
let _e4675 = select(_e4446, _e4673, (_e4673 < _e4446));
let _e4681 = global_6.member[bitcast<u32>(select(0i, _e4675, (_e4675 > 0i)))];
let _e4688 = select(1f, (_e4663 + (((_e4672 + ((_e4681 - _e4672) * _e4633)) - _e4663) * _e4635)), _e4642);
if _e3379 {
phi_7657_ = vec3(_e4688);
} else {
let _e4691 = ((_e4438 + _e4440) + _e4631);
let _e4693 = select(_e4446, _e4691, (_e4691 < _e4446));
let _e4699 = global_6.member[bitcast<u32>(select(0i, _e4693, (_e4693 > 0i)))];
let _e4700 = (_e4691 + 1i);
let _e4702 = select(_e4446, _e4700, (_e4700 < _e4446));
let _e4708 = global_6.member[bitcast<u32>(select(0i, _e4702, (_e4702 > 0i)))];
let _e4711 = (_e4699 + ((_e4708 - _e4699) * _e4633));
let _e4712 = (_e4691 + _e4380);
let _e4714 = select(_e4446, _e4712, (_e4712 < _e4446));
let _e4720 = global_6.member[bitcast<u32>(select(0i, _e4714, (_e4714 > 0i)))];
let _e4721 = (_e4712 + 1i);
let _e4723 = select(_e4446, _e4721, (_e4721 < _e4446));
let _e4729 = global_6.member[bitcast<u32>(select(0i, _e4723, (_e4723 > 0i)))];
let _e4739 = ((_e4438 + (2i * _e4440)) + _e4631);
let _e4741 = select(_e4446, _e4739, (_e4739 < _e4446));
let _e4747 = global_6.member[bitcast<u32>(select(0i, _e4741, (_e4741 > 0i)))];
let _e4748 = (_e4739 + 1i);
let _e4750 = select(_e4446, _e4748, (_e4748 < _e4446));
let _e4756 = global_6.member[bitcast<u32>(select(0i, _e4750, (_e4750 > 0i)))];
let _e4759 = (_e4747 + ((_e4756 - _e4747) * _e4633));
let _e4760 = (_e4739 + _e4380);
let _e4762 = select(_e4446, _e4760, (_e4760 < _e4446));
let _e4768 = global_6.member[bitcast<u32>(select(0i, _e4762, (_e4762 > 0i)))];
let _e4769 = (_e4760 + 1i);
let _e4771 = select(_e4446, _e4769, (_e4769 < _e4446));
let _e4777 = global_6.member[bitcast<u32>(select(0i, _e4771, (_e4771 > 0i)))];
phi_7657_ = vec3<f32>(_e4688, select(1f, (_e4711 + (((_e4720 + ((_e4729 - _e4720) * _e4633)) - _e4711) * _e4635)), _e4642), select(1f, (_e4759 + (((_e4768 + ((_e4777 - _e4768) * _e4633)) - _e4759) * _e4635)), _e4642));
}
let _e4787 = phi_7657_;
local = (_e4442 + _e4631);
let _e4789 = local;
let _e4791 = select(_e4446, _e4789, (_e4789 < _e4446));
let _e4796 = global_6.member[bitcast<u32>(select(0i, _e4791, (_e4791 > 0i)))];
let _e4797 = bitcast<u32>(_e4796);
let _e4801 = f32((bitcast<i32>((_e4797 & 65535u)) - 32768i));
let _e4807 = f32((bitcast<i32>(((_e4797 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4812 = select(_e4807, -(_e4807), ((_e4797 >> bitcast<u32>(31i)) != 0u));
let _e4813 = local;
let _e4814 = (_e4813 + 1i);
let _e4816 = select(_e4446, _e4814, (_e4814 < _e4446));
let _e4821 = global_6.member[bitcast<u32>(select(0i, _e4816, (_e4816 > 0i)))];
let _e4822 = bitcast<u32>(_e4821);
let _e4832 = f32((bitcast<i32>(((_e4822 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4838 = local;
let _e4839 = (_e4838 + _e4380);
let _e4841 = select(_e4446, _e4839, (_e4839 < _e4446));
let _e4846 = global_6.member[bitcast<u32>(select(0i, _e4841, (_e4841 > 0i)))];
let _e4847 = bitcast<u32>(_e4846);
let _e4851 = f32((bitcast<i32>((_e4847 & 65535u)) - 32768i));
let _e4857 = f32((bitcast<i32>(((_e4847 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4862 = select(_e4857, -(_e4857), ((_e4847 >> bitcast<u32>(31i)) != 0u));
let _e4863 = local;
let _e4864 = (_e4863 + _e4520);
let _e4866 = select(_e4446, _e4864, (_e4864 < _e4446));
let _e4871 = global_6.member[bitcast<u32>(select(0i, _e4866, (_e4866 > 0i)))];
let _e4872 = bitcast<u32>(_e4871);
let _e4882 = f32((bitcast<i32>(((_e4872 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4890 = (_e4801 + ((f32((bitcast<i32>((_e4822 & 65535u)) - 32768i)) - _e4801) * _e4633));
let _e4899 = (_e4812 + ((select(_e4832, -(_e4832), ((_e4822 >> bitcast<u32>(31i)) != 0u)) - _e4812) * _e4633));
let _e4912 = global_5.member[_e354].member_9.member_1;
let _e4919 = (_e4570.member + (select(0f, (_e4890 + (((_e4851 + ((f32((bitcast<i32>((_e4872 & 65535u)) - 32768i)) - _e4851) * _e4633)) - _e4890) * _e4635)), _e4642) * _e4573));
let _e4921 = (_e4570.member_1 + (select(0f, (_e4899 + (((_e4862 + ((select(_e4882, -(_e4882), ((_e4872 >> bitcast<u32>(31i)) != 0u)) - _e4862) * _e4633)) - _e4899) * _e4635)), _e4642) * _e4573));
let _e4925 = (1f - ((_e4919 * _e4919) + (_e4921 * _e4921)));
let _e4927 = select(1e-4f, _e4925, (_e4925 > 1e-4f));
phi_7887_ = type_25((_e4787 * vec3<f32>(_e4912.member, _e4912.member_1, _e4912.member_2)), vec3<f32>(_e4919, _e4921, sqrt(select(0f, _e4927, (_e4927 > 0f)))));
}
let _e4934 = phi_7887_;
let _e4943 = (((_e4934.member_1.x * _e4934.member_1.x) + (_e4934.member_1.y * _e4934.member_1.y)) + (_e4934.member_1.z * _e4934.member_1.z));
let _e4946 = sqrt(select(0f, _e4943, (_e4943 > 0f)));
let _e4952 = (1e-6f * _e4946);
let _e4956 = select((_e4946 / select(_e4952, _e4934.member_1.z, (_e4934.member_1.z > _e4952))), 1f, ((_e689 & 8u) != 0u));
let _e4958 = (_e4934.member.x * _e4956);
let _e4960 = (_e4934.member.y * _e4956);
let _e4962 = (_e4934.member.z * _e4956);
if _e805 {
let _e4967 = global_5.member[_e354].member_19;
let _e4976 = (((_e2616.member_1.x * _e2616.member_1.x) + (_e2616.member_1.y * _e2616.member_1.y)) + (_e2616.member_1.z * _e2616.member_1.z));
let _e4979 = sqrt(select(0f, _e4976, (_e4976 > 0f)));
let _e4982 = (1f / select(1e-20f, _e4979, (_e4979 > 1e-20f)));
let _e4983 = (_e2616.member_1.x * _e4982);
let _e4984 = (_e2616.member_1.y * _e4982);
let _e4985 = (_e2616.member_1.z * _e4982);
let _e4988 = (-1f / select(1e-20f, _e4946, (_e4946 > 1e-20f)));
let _e4989 = (_e4934.member_1.x * _e4988);
let _e4990 = (_e4934.member_1.y * _e4988);
let _e4991 = (_e4934.member_1.z * _e4988);
let _e4996 = (((_e358[3] * _e358[3]) + (_e358[4] * _e358[4])) + (_e358[5] * _e358[5]));
let _e4999 = sqrt(select(0f, _e4996, (_e4996 > 0f)));
let _e5002 = (-1f / select(1e-20f, _e4999, (_e4999 > 1e-20f)));
let _e5003 = (_e358[3] * _e5002);
let _e5004 = (_e358[4] * _e5002);
let _e5005 = (_e358[5] * _e5002);
let _e5012 = select(1f, -1f, ((((_e4983 * _e5003) + (_e4984 * _e5004)) + (_e4985 * _e5005)) < 0f));
let _e5013 = (_e4983 * _e5012);
let _e5014 = (_e4984 * _e5012);
let _e5015 = (_e4985 * _e5012);
let _e5020 = (((_e5013 * _e5003) + (_e5014 * _e5004)) + (_e5015 * _e5005));
let _e5022 = select(1e-4f, _e5020, (_e5020 > 1e-4f));
let _e5027 = (((_e5013 * _e4989) + (_e5014 * _e4990)) + (_e5015 * _e4991));
let _e5028 = (_e4989 + _e5003);
let _e5029 = (_e4990 + _e5004);
let _e5030 = (_e4991 + _e5005);
let _e5035 = (((_e5028 * _e5028) + (_e5029 * _e5029)) + (_e5030 * _e5030));
let _e5038 = sqrt(select(0f, _e5035, (_e5035 > 0f)));
let _e5041 = (1f / select(1e-6f, _e5038, (_e5038 > 1e-6f)));
let _e5042 = (_e5028 * _e5041);
let _e5043 = (_e5029 * _e5041);
let _e5044 = (_e5030 * _e5041);
let _e5049 = (((_e5013 * _e5042) + (_e5014 * _e5043)) + (_e5015 * _e5044));
let _e5051 = select(0f, _e5049, (_e5049 > 0f));
let _e5056 = (((_e5003 * _e5042) + (_e5004 * _e5043)) + (_e5005 * _e5044));
let _e5058 = select(0f, _e5056, (_e5056 > 0f));
let _e5059 = (_e4967 * _e4967);
let _e5060 = (_e5059 * _e5059);
let _e5064 = (((_e5051 * _e5051) * (_e5060 - 1f)) + 1f);
let _e5068 = (_e5027 > 0f);
let _e5069 = select(0f, _e5027, _e5068);
let _e5071 = (1f - _e5060);
let _e5073 = (((_e5069 * _e5069) * _e5071) + _e5060);
let _e5080 = (((_e5022 * _e5022) * _e5071) + _e5060);
let _e5085 = ((_e5022 * sqrt(select(0f, _e5073, (_e5073 > 0f)))) + (_e5069 * sqrt(select(0f, _e5080, (_e5080 > 0f)))));
let _e5090 = (_e2616.member_2 / _e3057);
let _e5094 = (((_e5090 * _e5090) - 1f) + (_e5058 * _e5058));
let _e5097 = sqrt(select(0f, _e5094, (_e5094 > 0f)));
let _e5098 = (_e5097 - _e5058);
let _e5099 = (_e5097 + _e5058);
let _e5102 = (_e5098 / select(1e-6f, _e5099, (_e5099 > 1e-6f)));
let _e5106 = ((_e5058 * _e5098) + 1f);
let _e5109 = (((_e5058 * _e5099) - 1f) / select(1e-6f, _e5106, (_e5106 > 1e-6f)));
let _e5127 = global_5.member[_e354].member_20;
let _e5131 = ((select(0f, ((((_e5060 / ((3.1415927f * _e5064) * _e5064)) * (0.5f / select(1e-6f, _e5085, (_e5085 > 1e-6f)))) * select(select((((0.5f * _e5102) * _e5102) * (1f + (_e5109 * _e5109))), 1f, (_e5094 <= 0f)), 0f, (_e3057 == _e2616.member_2))) * _e5069), (_e5068 && (_e4979 > 1e-12f))) * _e5127) * select(_e3273.member_2, 0f, _e446));
phi_8205_ = vec3<f32>((_e4958 * _e5131), (_e4960 * _e5131), (_e4962 * _e5131));
} else {
phi_8205_ = vec3<f32>(0f, 0f, 0f);
}
let _e5137 = phi_8205_;
let _e5141 = global_5.member[_e354].member_18;
let _e5148 = (1f - _e358[12]);
let _e5168 = (_e358[9] + ((_e358[13] * ((_e4306.member_3.x * (_e4958 + _e5141.member)) + _e5137.x)) * _e5148));
let _e5169 = (_e358[10] + ((_e358[14] * ((_e4306.member_3.y * (_e4960 + _e5141.member_1)) + _e5137.y)) * _e5148));
let _e5170 = (_e358[11] + ((_e358[15] * ((_e4306.member_3.z * (_e4962 + _e5141.member_2)) + _e5137.z)) * _e5148));
let _e5173 = (_e358[12] + (_e5148 * _e4306.member_1));
let _e5176 = (_e358[13] * _e4306.member_2.x);
let _e5178 = (_e358[14] * _e4306.member_2.y);
let _e5180 = (_e358[15] * _e4306.member_2.z);
let _e5185 = (_e358[8] + ((_e5173 - _e358[12]) * (_e378 + (_e3362 * 0.5f))));
let _e5194 = (-((((select(_e775.member, _e762.member, _e755) * _e4934.member_1.x) + (select(_e775.member_1, _e762.member_1, _e755) * _e4934.member_1.y)) + (select(_e775.member_2, _e762.member_2, _e755) * _e4934.member_1.z))) / select(1e-20f, _e4946, (_e4946 > 1e-20f)));
let _e5199 = bitcast<f32>((bitcast<u32>(select(0f, _e5194, (_e5194 > 0f))) & 2147483647u));
let _e5209 = (1f - _e5173);
let _e5222 = select(_e5173, 1f, _e446);
if _e805 {
let _e5231 = global_5.member[_e354].member_5.member_4;
let _e5234 = (_e2616.member_3.x * _e3273.member_2);
let _e5236 = (_e2616.member_3.y * _e3273.member_2);
let _e5238 = (_e2616.member_3.z * _e3273.member_2);
let _e5239 = (0.5f * _e373);
let _e5243 = (_e358[3] + (_e5234 * _e5239));
let _e5244 = (_e358[4] + (_e5236 * _e5239));
let _e5245 = (_e358[5] + (_e5238 * _e5239));
let _e5247 = (2f * _e372);
let _e5249 = ((_e5245 * _e5245) + (_e5247 * _e5238));
let _e5253 = (_e5245 + sqrt(select(0f, _e5249, (_e5249 > 0f))));
let _e5257 = (0.5f * (_e5247 / select(1e-6f, _e5253, (_e5253 > 1e-6f))));
let _e5261 = (_e5243 + (_e5234 * _e5257));
let _e5262 = (_e5244 + (_e5236 * _e5257));
let _e5263 = (_e5245 + (_e5238 * _e5257));
let _e5267 = (_e5231 * _e5231);
let _e5269 = (_e5263 * _e5263);
let _e5277 = (((_e5245 <= 0f) || (_e5249 <= 0f)) || ((_e5263 <= 0f) || (_e5269 <= (_e5267 * (((_e5261 * _e5261) + (_e5262 * _e5262)) + _e5269)))));
let _e5291 = (_e358[3] + ((_e2616.member_4.x * _e3273.member_2) * _e372));
let _e5292 = (_e358[4] + ((_e2616.member_4.y * _e3273.member_2) * _e372));
let _e5293 = (_e358[5] + ((_e2616.member_4.z * _e3273.member_2) * _e372));
let _e5295 = (_e5293 * _e5293);
let _e5304 = ((_e689 & 1u) != 0u);
phi_8510_ = vec3<f32>(select(select(_e5261, _e5243, _e5277), _e5291, _e5304), select(select(_e5262, _e5244, _e5277), _e5292, _e5304), select(select(_e5263, _e5245, _e5277), _e5293, _e5304));
phi_8511_ = select(_e5277, ((_e5293 <= 0f) || (_e5295 <= (_e5267 * (((_e5291 * _e5291) + (_e5292 * _e5292)) + _e5295)))), _e5304);
} else {
phi_8510_ = vec3<f32>(_e358[3], _e358[4], _e358[5]);
phi_8511_ = false;
}
let _e5311 = phi_8510_;
let _e5313 = phi_8511_;
let _e5322 = (((_e446 || (_e5311.x != _e358[3])) || (_e5311.y != _e358[4])) || (_e5311.z != _e358[5]));
let _e5324 = select(_e5178, _e5176, (_e5176 > _e5178));
phi_8576_ = array<f32, 18>(select(_e358[0], select(_e386, _e4311, _e446), _e5322), select(_e358[1], select(_e388, _e4312, _e446), _e5322), select(_e358[2], select(_e393, _e4313, _e446), _e5322), _e5311.x, _e5311.y, _e5311.z, _e2616.member, select(select(0f, 2f, _e5313), 1f, (_e446 || (((1f - _e5222) * select(_e5180, _e5324, (_e5324 > _e5180))) < 9.765625e-4f))), select(_e5185, (_e5185 + (_e5209 * _e4313)), _e446), select(_e5168, (_e5168 + ((_e5176 * (select(_e781.member, _e768.member, _e755) * ((_e4958 * _e5199) + _e5141.member))) * _e5209)), _e446), select(_e5169, (_e5169 + ((_e5178 * (select(_e781.member_1, _e768.member_1, _e755) * ((_e4960 * _e5199) + _e5141.member_1))) * _e5209)), _e446), select(_e5170, (_e5170 + ((_e5180 * (select(_e781.member_2, _e768.member_2, _e755) * ((_e4962 * _e5199) + _e5141.member_2))) * _e5209)), _e446), _e5222, _e5176, _e5178, _e5180, _e2616.member_2, _e393);
} else {
phi_8576_ = _e358;
}
let _e5343 = phi_8576_;
phi_587_ = (_e354 + 1u);
phi_590_ = select(_e356, true, _e727);
phi_592_ = _e5343;
} else {
phi_587_ = u32();
phi_590_ = bool();
phi_592_ = array<f32, 18>();
}
let _e5347 = phi_587_;
let _e5349 = phi_590_;
let _e5351 = phi_592_;
continue;
continuing {
phi_586_ = _e5347;
phi_589_ = _e5349;
phi_591_ = _e5351;
phi_8659_ = false;
break if !(_e359);
}
}
let _e5354 = phi_8659_;
if _e5354 {
break;
}
let _e5356 = local_8;
if _e5356 {
let _e5358 = local_9;
global_4.member[_e154] = _e5358[0];
let _e5363 = local_10;
global_4.member[_e166] = _e5363[1];
let _e5368 = local_11;
global_4.member[_e177] = _e5368[2];
let _e5373 = local_12;
global_4.member[_e188] = _e5373[3];
let _e5378 = local_13;
global_4.member[_e199] = _e5378[4];
let _e5383 = local_14;
global_4.member[_e210] = _e5383[5];
let _e5388 = local_15;
global_4.member[_e221] = _e5388[6];
let _e5393 = local_16;
global_4.member[_e232] = _e5393[7];
let _e5398 = local_17;
global_4.member[_e243] = _e5398[8];
let _e5403 = local_18;
global_4.member[_e254] = _e5403[9];
let _e5408 = local_19;
global_4.member[_e265] = _e5408[10];
let _e5413 = local_20;
global_4.member[_e276] = _e5413[11];
let _e5418 = local_21;
global_4.member[_e287] = _e5418[12];
let _e5423 = local_22;
global_4.member[_e298] = _e5423[13];
let _e5428 = local_23;
global_4.member[_e309] = _e5428[14];
let _e5433 = local_24;
global_4.member[_e320] = _e5433[15];
let _e5438 = local_25;
global_4.member[_e331] = _e5438[16];
let _e5443 = local_26;
global_4.member[_e342] = _e5443[17];
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
