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
var phi_584_: u32;
var phi_587_: bool;
var phi_589_: array<f32, 18>;
var phi_3602_: type_29;
var phi_4304_: type_30;
var phi_4946_: f32;
var phi_5335_: type_5;
var phi_6893_: type_31;
var phi_7646_: vec3<f32>;
var phi_7876_: type_25;
var phi_8194_: vec3<f32>;
var phi_8503_: f32;
var phi_8504_: f32;
var phi_8505_: f32;
var phi_8506_: bool;
var phi_8566_: array<f32, 18>;
var phi_585_: u32;
var phi_588_: bool;
var phi_590_: array<f32, 18>;
var phi_8649_: bool;
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
phi_584_ = 0u;
phi_587_ = false;
phi_589_ = array<f32, 18>(_e165, _e175, _e186, _e197, _e208, _e219, _e230, _e241, _e252, _e263, _e274, _e285, _e296, _e307, _e318, _e329, _e340, _e351);
loop {
let _e354 = phi_584_;
let _e356 = phi_587_;
let _e358 = phi_589_;
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
phi_8649_ = true;
break;
}
let _e367 = global_5.member[_e354].member_5.member_2;
let _e368 = (_e367 / _e358[4]);
let _e373 = global_5.member[_e354].member_5.member;
let _e376 = ((_e373 - _e358[16]) / _e358[4]);
let _e379 = (_e358[0] + (_e358[2] * _e376));
let _e382 = (_e358[1] + (_e358[3] * _e376));
let _e384 = (_e379 + (_e358[2] * _e368));
let _e386 = (_e382 + (_e358[3] * _e368));
let _e391 = global_5.member[_e354].member_5.member_1;
let _e397 = global_5.member[_e354].member_13.member.member;
let _e408 = ((((_e397.member.member * _e379) + (_e397.member.member_1 * _e382)) + (_e397.member.member_2 * _e373)) + _e397.member_1);
let _e414 = ((((_e397.member.member * _e384) + (_e397.member.member_1 * _e386)) + (_e397.member.member_2 * _e391)) + _e397.member_1);
let _e417 = ((_e408 > 0f) && (_e414 <= 0f));
let _e423 = global_5.member[_e354].member_13.member_1.member;
let _e434 = ((((_e423.member.member * _e379) + (_e423.member.member_1 * _e382)) + (_e423.member.member_2 * _e373)) + _e423.member_1);
let _e440 = ((((_e423.member.member * _e384) + (_e423.member.member_1 * _e386)) + (_e423.member.member_2 * _e391)) + _e423.member_1);
let _e443 = ((_e434 > 0f) && (_e440 <= 0f));
let _e444 = (_e417 || _e443);
let _e449 = global_5.member[_e354].member_6.member;
let _e460 = ((((_e449.member.member * _e379) + (_e449.member.member_1 * _e382)) + (_e449.member.member_2 * _e373)) + _e449.member_1);
let _e465 = global_5.member[_e354].member_6.member_1;
let _e476 = ((((_e465.member.member * _e379) + (_e465.member.member_1 * _e382)) + (_e465.member.member_2 * _e373)) + _e465.member_1);
let _e481 = global_5.member[_e354].member_6.member_2;
let _e492 = ((((_e481.member.member * _e379) + (_e481.member.member_1 * _e382)) + (_e481.member.member_2 * _e373)) + _e481.member_1);
let _e498 = ((((_e449.member.member * _e384) + (_e449.member.member_1 * _e386)) + (_e449.member.member_2 * _e391)) + _e449.member_1);
let _e504 = ((((_e465.member.member * _e384) + (_e465.member.member_1 * _e386)) + (_e465.member.member_2 * _e391)) + _e465.member_1);
let _e510 = ((((_e481.member.member * _e384) + (_e481.member.member_1 * _e386)) + (_e481.member.member_2 * _e391)) + _e481.member_1);
let _e515 = global_5.member[_e354].member_6.member_4;
let _e521 = global_5.member[_e354].member_6.member_3.member;
let _e522 = (_e521 - 0.5f);
let _e524 = select(-0.5f, _e498, (_e498 > -0.5f));
let _e526 = select(_e522, _e524, (_e524 < _e522));
let _e532 = global_5.member[_e354].member_6.member_3.member_1;
let _e533 = (_e532 - 0.5f);
let _e535 = select(-0.5f, _e504, (_e504 > -0.5f));
let _e537 = select(_e533, _e535, (_e535 < _e533));
let _e543 = global_5.member[_e354].member_6.member_3.member_2;
let _e544 = (_e543 - 0.5f);
let _e546 = select(-0.5f, _e510, (_e510 > -0.5f));
let _e548 = select(_e544, _e546, (_e546 < _e544));
let _e549 = (_e498 - _e460);
let _e550 = (_e504 - _e476);
let _e551 = (_e510 - _e492);
let _e554 = bitcast<f32>((bitcast<u32>(_e549) & 2147483647u));
let _e557 = bitcast<f32>((bitcast<u32>(_e550) & 2147483647u));
let _e559 = select(_e557, _e554, (_e554 > _e557));
let _e562 = bitcast<f32>((bitcast<u32>(_e551) & 2147483647u));
let _e571 = bitcast<f32>((bitcast<u32>((_e498 - _e526)) & 2147483647u));
let _e574 = bitcast<f32>((bitcast<u32>((_e504 - _e537)) & 2147483647u));
let _e576 = select(_e574, _e571, (_e571 > _e574));
let _e579 = bitcast<f32>((bitcast<u32>((_e510 - _e548)) & 2147483647u));
let _e583 = (_e526 + 0.5f);
let _e584 = (_e521 - 1f);
let _e586 = select(0f, _e583, (_e583 > 0f));
let _e588 = select(_e584, _e586, (_e586 < _e584));
let _e595 = select(0i, select(select(i32(_e588), i32(-2147483648), (_e588 < -2147483600f)), 2147483647i, (_e588 > 2147483500f)), (_e588 == _e588));
let _e604 = global_5.member[_e354].member_6.member_12;
let _e605 = (_e604 & 31u);
let _e608 = (_e537 + 0.5f);
let _e609 = (_e532 - 1f);
let _e611 = select(0f, _e608, (_e608 > 0f));
let _e613 = select(_e609, _e611, (_e611 < _e609));
let _e620 = select(0i, select(select(i32(_e613), i32(-2147483648), (_e613 < -2147483600f)), 2147483647i, (_e613 > 2147483500f)), (_e613 == _e613));
let _e627 = (_e548 + 0.5f);
let _e628 = (_e543 - 1f);
let _e630 = select(0f, _e627, (_e627 > 0f));
let _e632 = select(_e628, _e630, (_e630 < _e628));
let _e639 = select(0i, select(select(i32(_e632), i32(-2147483648), (_e632 < -2147483600f)), 2147483647i, (_e632 > 2147483500f)), (_e632 == _e632));
let _e651 = global_5.member[_e354].member_6.member_9.member;
let _e658 = global_5.member[_e354].member_6.member_9.member_1;
let _e664 = global_5.member[_e354].member_6.member_10;
let _e670 = ((bitcast<i32>(_e664) + ((_e595 - select(0i, 1i, (_e588 < f32(_e595)))) >> bitcast<u32>(_e605))) + (bitcast<i32>(_e651) * (((_e620 - select(0i, 1i, (_e613 < f32(_e620)))) >> bitcast<u32>(_e605)) + (bitcast<i32>(_e658) * ((_e639 - select(0i, 1i, (_e632 < f32(_e639)))) >> bitcast<u32>(_e605))))));
let _e672 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e674 = select(_e672, _e670, (_e670 < _e672));
let _e680 = global_2.member[bitcast<u32>(select(0i, _e674, (_e674 > 0i)))];
let _e687 = global_5.member[_e354].member_1;
let _e720 = (_e358[17] != _e373);
let _e727 = (select(0u, select(select(select(select(7u, 3u, (((((((_e460 >= 0f) && (_e460 <= _e584)) && (_e476 >= 0f)) && (_e476 <= _e609)) && (_e492 >= 0f)) && (_e492 <= _e628)) && ((((((_e498 >= 0f) && (_e498 <= _e584)) && (_e504 >= 0f)) && (_e504 <= _e609)) && (_e510 >= 0f)) && (_e510 <= _e628)))), 15u, _e720), 1u, (((_e687 & 64u) != 0u) || ((((select(_e562, _e559, (_e559 > _e562)) <= _e515) && ((select(_e579, _e576, (_e576 > _e579)) > _e515) || (_e680 != 0u))) && true) && ((_e687 & 32u) != 0u)))), 31u, _e444), (_e358[6] == 0f)) > 1u);
if _e727 {
let _e731 = global_5.member[_e354].member;
let _e733 = (_e408 - _e414);
let _e736 = (_e408 / select(1e-20f, _e733, (_e733 > 1e-20f)));
let _e737 = (_e434 - _e440);
let _e740 = (_e434 / select(1e-20f, _e737, (_e737 > 1e-20f)));
let _e744 = (_e443 && (!(_e417) || (_e740 < _e736)));
let _e751 = global_5.member[_e354].member_13.member_1.member.member;
let _e757 = global_5.member[_e354].member_13.member_1.member_1;
let _e764 = global_5.member[_e354].member_13.member.member.member;
let _e770 = global_5.member[_e354].member_13.member.member_1;
let _e789 = select(_e736, _e740, _e744);
let _e791 = (_e731.member_2 == 2u);
let _e794 = (((_e731.member_2 == 1u) || _e791) || (_e731.member_2 == 5u));
if _e794 {
let _e796 = select(-1f, _e526, (_e526 > -1f));
let _e798 = select(_e521, _e796, (_e796 < _e521));
let _e805 = select(0i, select(select(i32(_e798), i32(-2147483648), (_e798 < -2147483600f)), 2147483647i, (_e798 > 2147483500f)), (_e798 == _e798));
let _e809 = (_e805 - select(0i, 1i, (_e798 < f32(_e805))));
let _e811 = select(-1f, _e537, (_e537 > -1f));
let _e813 = select(_e532, _e811, (_e811 < _e532));
let _e820 = select(0i, select(select(i32(_e813), i32(-2147483648), (_e813 < -2147483600f)), 2147483647i, (_e813 > 2147483500f)), (_e813 == _e813));
let _e824 = (_e820 - select(0i, 1i, (_e813 < f32(_e820))));
let _e826 = select(-1f, _e548, (_e548 > -1f));
let _e828 = select(_e543, _e826, (_e826 < _e543));
let _e835 = select(0i, select(select(i32(_e828), i32(-2147483648), (_e828 < -2147483600f)), 2147483647i, (_e828 > 2147483500f)), (_e828 == _e828));
let _e839 = (_e835 - select(0i, 1i, (_e828 < f32(_e835))));
let _e844 = global_5.member[_e354].member_6.member_7;
let _e849 = global_5.member[_e354].member_6.member_8;
let _e850 = (_e809 + 1i);
let _e851 = (_e824 + 1i);
let _e852 = (_e839 + 1i);
let _e858 = global_5.member[_e354].member_6.member_11.member;
let _e865 = global_5.member[_e354].member_6.member_11.member_1;
let _e876 = ((_e850 >> bitcast<u32>(4i)) + (bitcast<i32>(_e858) * ((_e851 >> bitcast<u32>(4i)) + (bitcast<i32>(_e865) * (_e852 >> bitcast<u32>(4i))))));
let _e878 = (bitcast<i32>(_e121) - 1i);
let _e880 = select(_e878, _e876, (_e876 < _e878));
let _e886 = global_1.member[bitcast<u32>(select(0i, _e880, (_e880 > 0i)))];
let _e888 = (_e850 & 15i);
let _e891 = ((_e851 & 15i) * _e844);
let _e893 = (bitcast<i32>(_e886) + ((_e852 & 15i) * _e849));
let _e894 = (_e891 + _e844);
let _e896 = (_e891 + (2i * _e844));
let _e898 = (_e891 + (3i * _e844));
let _e899 = (_e893 + _e849);
let _e901 = (_e893 + (2i * _e849));
let _e903 = (_e893 + (3i * _e849));
local_6 = type_28(array<i32, 4>(_e888, _e888, _e888, _e888), array<u32, 6>(0u, 8u, 16u, 24u, 0u, 0u));
local_7 = vec3<f32>((_e526 - f32(_e809)), (_e537 - f32(_e824)), (_e548 - f32(_e839)));
let _e917 = local_6.member[0u];
let _e918 = ((_e899 + _e894) + _e917);
let _e920 = (_e918 >> bitcast<u32>(2i));
let _e923 = bitcast<u32>(((_e918 & 3i) * 8i));
let _e925 = select(_e878, _e920, (_e920 < _e878));
let _e930 = global_1.member[bitcast<u32>(select(0i, _e925, (_e925 > 0i)))];
let _e934 = (_e920 + 1i);
let _e936 = select(_e878, _e934, (_e934 < _e878));
let _e941 = global_1.member[bitcast<u32>(select(0i, _e936, (_e936 > 0i)))];
let _e948 = ((_e930 >> bitcast<u32>((_e923 & 31u))) | ((_e941 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e923) & 31u))));
let _e951 = local_6.member_1[0u];
let _e957 = f32(bitcast<i32>(((_e948 >> bitcast<u32>((_e951 & 31u))) & 255u)));
let _e960 = local_6.member_1[1u];
let _e966 = f32(bitcast<i32>(((_e948 >> bitcast<u32>((_e960 & 31u))) & 255u)));
let _e969 = local_6.member_1[2u];
let _e975 = f32(bitcast<i32>(((_e948 >> bitcast<u32>((_e969 & 31u))) & 255u)));
let _e978 = local_6.member_1[3u];
let _e985 = local_7[0u];
let _e988 = (_e957 + ((_e966 - _e957) * _e985));
let _e989 = local_7[0u];
let _e992 = (_e966 + ((_e975 - _e966) * _e989));
let _e993 = local_7[0u];
let _e996 = (_e975 + ((f32(bitcast<i32>(((_e948 >> bitcast<u32>((_e978 & 31u))) & 255u))) - _e975) * _e993));
let _e998 = local_6.member[0u];
let _e999 = ((_e899 + _e896) + _e998);
let _e1001 = (_e999 >> bitcast<u32>(2i));
let _e1004 = bitcast<u32>(((_e999 & 3i) * 8i));
let _e1006 = select(_e878, _e1001, (_e1001 < _e878));
let _e1011 = global_1.member[bitcast<u32>(select(0i, _e1006, (_e1006 > 0i)))];
let _e1015 = (_e1001 + 1i);
let _e1017 = select(_e878, _e1015, (_e1015 < _e878));
let _e1022 = global_1.member[bitcast<u32>(select(0i, _e1017, (_e1017 > 0i)))];
let _e1029 = ((_e1011 >> bitcast<u32>((_e1004 & 31u))) | ((_e1022 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1004) & 31u))));
let _e1030 = local_6.member_1[0u];
let _e1036 = f32(bitcast<i32>(((_e1029 >> bitcast<u32>((_e1030 & 31u))) & 255u)));
let _e1037 = local_6.member_1[1u];
let _e1043 = f32(bitcast<i32>(((_e1029 >> bitcast<u32>((_e1037 & 31u))) & 255u)));
let _e1044 = local_6.member_1[2u];
let _e1050 = f32(bitcast<i32>(((_e1029 >> bitcast<u32>((_e1044 & 31u))) & 255u)));
let _e1051 = local_6.member_1[3u];
let _e1058 = local_7[0u];
let _e1062 = local_7[0u];
let _e1065 = (_e1043 + ((_e1050 - _e1043) * _e1062));
let _e1066 = local_7[0u];
let _e1071 = local_6.member[0u];
let _e1072 = ((_e901 + _e894) + _e1071);
let _e1074 = (_e1072 >> bitcast<u32>(2i));
let _e1077 = bitcast<u32>(((_e1072 & 3i) * 8i));
let _e1079 = select(_e878, _e1074, (_e1074 < _e878));
let _e1084 = global_1.member[bitcast<u32>(select(0i, _e1079, (_e1079 > 0i)))];
let _e1088 = (_e1074 + 1i);
let _e1090 = select(_e878, _e1088, (_e1088 < _e878));
let _e1095 = global_1.member[bitcast<u32>(select(0i, _e1090, (_e1090 > 0i)))];
let _e1102 = ((_e1084 >> bitcast<u32>((_e1077 & 31u))) | ((_e1095 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1077) & 31u))));
let _e1103 = local_6.member_1[0u];
let _e1109 = f32(bitcast<i32>(((_e1102 >> bitcast<u32>((_e1103 & 31u))) & 255u)));
let _e1110 = local_6.member_1[1u];
let _e1116 = f32(bitcast<i32>(((_e1102 >> bitcast<u32>((_e1110 & 31u))) & 255u)));
let _e1117 = local_6.member_1[2u];
let _e1123 = f32(bitcast<i32>(((_e1102 >> bitcast<u32>((_e1117 & 31u))) & 255u)));
let _e1124 = local_6.member_1[3u];
let _e1131 = local_7[0u];
let _e1134 = (_e1109 + ((_e1116 - _e1109) * _e1131));
let _e1135 = local_7[0u];
let _e1138 = (_e1116 + ((_e1123 - _e1116) * _e1135));
let _e1139 = local_7[0u];
let _e1142 = (_e1123 + ((f32(bitcast<i32>(((_e1102 >> bitcast<u32>((_e1124 & 31u))) & 255u))) - _e1123) * _e1139));
let _e1144 = local_6.member[0u];
let _e1145 = ((_e901 + _e896) + _e1144);
let _e1147 = (_e1145 >> bitcast<u32>(2i));
let _e1150 = bitcast<u32>(((_e1145 & 3i) * 8i));
let _e1152 = select(_e878, _e1147, (_e1147 < _e878));
let _e1157 = global_1.member[bitcast<u32>(select(0i, _e1152, (_e1152 > 0i)))];
let _e1161 = (_e1147 + 1i);
let _e1163 = select(_e878, _e1161, (_e1161 < _e878));
let _e1168 = global_1.member[bitcast<u32>(select(0i, _e1163, (_e1163 > 0i)))];
let _e1175 = ((_e1157 >> bitcast<u32>((_e1150 & 31u))) | ((_e1168 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1150) & 31u))));
let _e1176 = local_6.member_1[0u];
let _e1182 = f32(bitcast<i32>(((_e1175 >> bitcast<u32>((_e1176 & 31u))) & 255u)));
let _e1183 = local_6.member_1[1u];
let _e1189 = f32(bitcast<i32>(((_e1175 >> bitcast<u32>((_e1183 & 31u))) & 255u)));
let _e1190 = local_6.member_1[2u];
let _e1196 = f32(bitcast<i32>(((_e1175 >> bitcast<u32>((_e1190 & 31u))) & 255u)));
let _e1197 = local_6.member_1[3u];
let _e1204 = local_7[0u];
let _e1208 = local_7[0u];
let _e1211 = (_e1189 + ((_e1196 - _e1189) * _e1208));
let _e1212 = local_7[0u];
let _e1217 = local_6.member[0u];
let _e1218 = ((_e899 + _e891) + _e1217);
let _e1220 = (_e1218 >> bitcast<u32>(2i));
let _e1223 = bitcast<u32>(((_e1218 & 3i) * 8i));
let _e1225 = select(_e878, _e1220, (_e1220 < _e878));
let _e1230 = global_1.member[bitcast<u32>(select(0i, _e1225, (_e1225 > 0i)))];
let _e1234 = (_e1220 + 1i);
let _e1236 = select(_e878, _e1234, (_e1234 < _e878));
let _e1241 = global_1.member[bitcast<u32>(select(0i, _e1236, (_e1236 > 0i)))];
let _e1248 = ((_e1230 >> bitcast<u32>((_e1223 & 31u))) | ((_e1241 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1223) & 31u))));
let _e1249 = local_6.member_1[1u];
let _e1255 = f32(bitcast<i32>(((_e1248 >> bitcast<u32>((_e1249 & 31u))) & 255u)));
let _e1256 = local_6.member_1[2u];
let _e1263 = local_7[0u];
let _e1266 = (_e1255 + ((f32(bitcast<i32>(((_e1248 >> bitcast<u32>((_e1256 & 31u))) & 255u))) - _e1255) * _e1263));
let _e1268 = local_6.member[0u];
let _e1269 = ((_e899 + _e898) + _e1268);
let _e1271 = (_e1269 >> bitcast<u32>(2i));
let _e1274 = bitcast<u32>(((_e1269 & 3i) * 8i));
let _e1276 = select(_e878, _e1271, (_e1271 < _e878));
let _e1281 = global_1.member[bitcast<u32>(select(0i, _e1276, (_e1276 > 0i)))];
let _e1285 = (_e1271 + 1i);
let _e1287 = select(_e878, _e1285, (_e1285 < _e878));
let _e1292 = global_1.member[bitcast<u32>(select(0i, _e1287, (_e1287 > 0i)))];
let _e1299 = ((_e1281 >> bitcast<u32>((_e1274 & 31u))) | ((_e1292 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1274) & 31u))));
let _e1300 = local_6.member_1[1u];
let _e1306 = f32(bitcast<i32>(((_e1299 >> bitcast<u32>((_e1300 & 31u))) & 255u)));
let _e1307 = local_6.member_1[2u];
let _e1314 = local_7[0u];
let _e1319 = local_6.member[0u];
let _e1320 = ((_e901 + _e891) + _e1319);
let _e1322 = (_e1320 >> bitcast<u32>(2i));
let _e1325 = bitcast<u32>(((_e1320 & 3i) * 8i));
let _e1327 = select(_e878, _e1322, (_e1322 < _e878));
let _e1332 = global_1.member[bitcast<u32>(select(0i, _e1327, (_e1327 > 0i)))];
let _e1336 = (_e1322 + 1i);
let _e1338 = select(_e878, _e1336, (_e1336 < _e878));
let _e1343 = global_1.member[bitcast<u32>(select(0i, _e1338, (_e1338 > 0i)))];
let _e1350 = ((_e1332 >> bitcast<u32>((_e1325 & 31u))) | ((_e1343 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1325) & 31u))));
let _e1351 = local_6.member_1[1u];
let _e1357 = f32(bitcast<i32>(((_e1350 >> bitcast<u32>((_e1351 & 31u))) & 255u)));
let _e1358 = local_6.member_1[2u];
let _e1365 = local_7[0u];
let _e1368 = (_e1357 + ((f32(bitcast<i32>(((_e1350 >> bitcast<u32>((_e1358 & 31u))) & 255u))) - _e1357) * _e1365));
let _e1370 = local_6.member[0u];
let _e1371 = ((_e901 + _e898) + _e1370);
let _e1373 = (_e1371 >> bitcast<u32>(2i));
let _e1376 = bitcast<u32>(((_e1371 & 3i) * 8i));
let _e1378 = select(_e878, _e1373, (_e1373 < _e878));
let _e1383 = global_1.member[bitcast<u32>(select(0i, _e1378, (_e1378 > 0i)))];
let _e1387 = (_e1373 + 1i);
let _e1389 = select(_e878, _e1387, (_e1387 < _e878));
let _e1394 = global_1.member[bitcast<u32>(select(0i, _e1389, (_e1389 > 0i)))];
let _e1401 = ((_e1383 >> bitcast<u32>((_e1376 & 31u))) | ((_e1394 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1376) & 31u))));
let _e1402 = local_6.member_1[1u];
let _e1408 = f32(bitcast<i32>(((_e1401 >> bitcast<u32>((_e1402 & 31u))) & 255u)));
let _e1409 = local_6.member_1[2u];
let _e1416 = local_7[0u];
let _e1421 = local_6.member[0u];
let _e1422 = ((_e893 + _e894) + _e1421);
let _e1424 = (_e1422 >> bitcast<u32>(2i));
let _e1427 = bitcast<u32>(((_e1422 & 3i) * 8i));
let _e1429 = select(_e878, _e1424, (_e1424 < _e878));
let _e1434 = global_1.member[bitcast<u32>(select(0i, _e1429, (_e1429 > 0i)))];
let _e1438 = (_e1424 + 1i);
let _e1440 = select(_e878, _e1438, (_e1438 < _e878));
let _e1445 = global_1.member[bitcast<u32>(select(0i, _e1440, (_e1440 > 0i)))];
let _e1452 = ((_e1434 >> bitcast<u32>((_e1427 & 31u))) | ((_e1445 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1427) & 31u))));
let _e1453 = local_6.member_1[1u];
let _e1459 = f32(bitcast<i32>(((_e1452 >> bitcast<u32>((_e1453 & 31u))) & 255u)));
let _e1460 = local_6.member_1[2u];
let _e1467 = local_7[0u];
let _e1470 = (_e1459 + ((f32(bitcast<i32>(((_e1452 >> bitcast<u32>((_e1460 & 31u))) & 255u))) - _e1459) * _e1467));
let _e1472 = local_6.member[0u];
let _e1473 = ((_e903 + _e894) + _e1472);
let _e1475 = (_e1473 >> bitcast<u32>(2i));
let _e1478 = bitcast<u32>(((_e1473 & 3i) * 8i));
let _e1480 = select(_e878, _e1475, (_e1475 < _e878));
let _e1485 = global_1.member[bitcast<u32>(select(0i, _e1480, (_e1480 > 0i)))];
let _e1489 = (_e1475 + 1i);
let _e1491 = select(_e878, _e1489, (_e1489 < _e878));
let _e1496 = global_1.member[bitcast<u32>(select(0i, _e1491, (_e1491 > 0i)))];
let _e1503 = ((_e1485 >> bitcast<u32>((_e1478 & 31u))) | ((_e1496 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1478) & 31u))));
let _e1504 = local_6.member_1[1u];
let _e1510 = f32(bitcast<i32>(((_e1503 >> bitcast<u32>((_e1504 & 31u))) & 255u)));
let _e1511 = local_6.member_1[2u];
let _e1518 = local_7[0u];
let _e1521 = (_e1510 + ((f32(bitcast<i32>(((_e1503 >> bitcast<u32>((_e1511 & 31u))) & 255u))) - _e1510) * _e1518));
let _e1523 = local_6.member[0u];
let _e1524 = ((_e893 + _e896) + _e1523);
let _e1526 = (_e1524 >> bitcast<u32>(2i));
let _e1529 = bitcast<u32>(((_e1524 & 3i) * 8i));
let _e1531 = select(_e878, _e1526, (_e1526 < _e878));
let _e1536 = global_1.member[bitcast<u32>(select(0i, _e1531, (_e1531 > 0i)))];
let _e1540 = (_e1526 + 1i);
let _e1542 = select(_e878, _e1540, (_e1540 < _e878));
let _e1547 = global_1.member[bitcast<u32>(select(0i, _e1542, (_e1542 > 0i)))];
let _e1554 = ((_e1536 >> bitcast<u32>((_e1529 & 31u))) | ((_e1547 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1529) & 31u))));
let _e1555 = local_6.member_1[1u];
let _e1561 = f32(bitcast<i32>(((_e1554 >> bitcast<u32>((_e1555 & 31u))) & 255u)));
let _e1562 = local_6.member_1[2u];
let _e1569 = local_7[0u];
let _e1574 = local_6.member[0u];
let _e1575 = ((_e903 + _e896) + _e1574);
let _e1577 = (_e1575 >> bitcast<u32>(2i));
let _e1580 = bitcast<u32>(((_e1575 & 3i) * 8i));
let _e1582 = select(_e878, _e1577, (_e1577 < _e878));
let _e1587 = global_1.member[bitcast<u32>(select(0i, _e1582, (_e1582 > 0i)))];
let _e1591 = (_e1577 + 1i);
let _e1593 = select(_e878, _e1591, (_e1591 < _e878));
let _e1598 = global_1.member[bitcast<u32>(select(0i, _e1593, (_e1593 > 0i)))];
let _e1605 = ((_e1587 >> bitcast<u32>((_e1580 & 31u))) | ((_e1598 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1580) & 31u))));
let _e1606 = local_6.member_1[1u];
let _e1612 = f32(bitcast<i32>(((_e1605 >> bitcast<u32>((_e1606 & 31u))) & 255u)));
let _e1613 = local_6.member_1[2u];
let _e1620 = local_7[0u];
let _e1625 = local_7[1u];
let _e1628 = (_e992 + ((_e1065 - _e992) * _e1625));
let _e1629 = local_7[1u];
let _e1632 = (_e1138 + ((_e1211 - _e1138) * _e1629));
let _e1633 = local_7[1u];
let _e1636 = (_e988 + (((_e1036 + ((_e1043 - _e1036) * _e1058)) - _e988) * _e1633));
let _e1637 = local_7[1u];
let _e1642 = local_7[2u];
let _e1646 = local_7[1u];
let _e1649 = (_e996 + (((_e1050 + ((f32(bitcast<i32>(((_e1029 >> bitcast<u32>((_e1051 & 31u))) & 255u))) - _e1050) * _e1066)) - _e996) * _e1646));
let _e1650 = local_7[1u];
let _e1654 = local_7[2u];
let _e1658 = local_7[1u];
let _e1661 = (_e1266 + ((_e992 - _e1266) * _e1658));
let _e1662 = local_7[1u];
let _e1666 = local_7[2u];
let _e1670 = local_7[1u];
let _e1673 = (_e1065 + (((_e1306 + ((f32(bitcast<i32>(((_e1299 >> bitcast<u32>((_e1307 & 31u))) & 255u))) - _e1306) * _e1314)) - _e1065) * _e1670));
let _e1674 = local_7[1u];
let _e1678 = local_7[2u];
let _e1682 = local_7[1u];
let _e1685 = (_e1470 + (((_e1561 + ((f32(bitcast<i32>(((_e1554 >> bitcast<u32>((_e1562 & 31u))) & 255u))) - _e1561) * _e1569)) - _e1470) * _e1682));
let _e1686 = local_7[2u];
let _e1690 = local_7[1u];
let _e1694 = local_7[2u];
let _e1698 = local_7[2u];
let _e1706 = global_5.member[_e354].member_6.member_5;
let _e1712 = global_5.member[_e354].member_6.member_6;
let _e1713 = (((_e1628 + ((_e1632 - _e1628) * _e1698)) * _e1706) + _e1712);
let _e1715 = select(0f, _e1713, (_e1713 > 0f));
let _e1717 = select(1f, _e1715, (_e1715 < 1f));
let _e1719 = (((_e1636 + (((_e1134 + (((_e1182 + ((_e1189 - _e1182) * _e1204)) - _e1134) * _e1637)) - _e1636) * _e1642)) * _e1706) + _e1712);
let _e1721 = select(0f, _e1719, (_e1719 > 0f));
let _e1723 = select(1f, _e1721, (_e1721 < 1f));
let _e1725 = (((_e1649 + (((_e1142 + (((_e1196 + ((f32(bitcast<i32>(((_e1175 >> bitcast<u32>((_e1197 & 31u))) & 255u))) - _e1196) * _e1212)) - _e1142) * _e1650)) - _e1649) * _e1654)) * _e1706) + _e1712);
let _e1727 = select(0f, _e1725, (_e1725 > 0f));
let _e1729 = select(1f, _e1727, (_e1727 < 1f));
let _e1731 = (((_e1661 + (((_e1368 + ((_e1138 - _e1368) * _e1662)) - _e1661) * _e1666)) * _e1706) + _e1712);
let _e1733 = select(0f, _e1731, (_e1731 > 0f));
let _e1735 = select(1f, _e1733, (_e1733 < 1f));
let _e1737 = (((_e1673 + (((_e1211 + (((_e1408 + ((f32(bitcast<i32>(((_e1401 >> bitcast<u32>((_e1409 & 31u))) & 255u))) - _e1408) * _e1416)) - _e1211) * _e1674)) - _e1673) * _e1678)) * _e1706) + _e1712);
let _e1739 = select(0f, _e1737, (_e1737 > 0f));
let _e1741 = select(1f, _e1739, (_e1739 < 1f));
let _e1743 = (((_e1685 + ((_e1628 - _e1685) * _e1686)) * _e1706) + _e1712);
let _e1745 = select(0f, _e1743, (_e1743 > 0f));
let _e1747 = select(1f, _e1745, (_e1745 < 1f));
let _e1749 = (((_e1632 + (((_e1521 + (((_e1612 + ((f32(bitcast<i32>(((_e1605 >> bitcast<u32>((_e1613 & 31u))) & 255u))) - _e1612) * _e1620)) - _e1521) * _e1690)) - _e1632) * _e1694)) * _e1706) + _e1712);
let _e1751 = select(0f, _e1749, (_e1749 > 0f));
let _e1753 = select(1f, _e1751, (_e1751 < 1f));
let _e1754 = (_e1717 * 1024f);
let _e1755 = (1024f - 1f);
let _e1757 = select(0f, _e1754, (_e1754 > 0f));
let _e1759 = select(_e1755, _e1757, (_e1757 < _e1755));
let _e1766 = select(0i, select(select(i32(_e1759), i32(-2147483648), (_e1759 < -2147483600f)), 2147483647i, (_e1759 > 2147483500f)), (_e1759 == _e1759));
let _e1770 = (_e1766 - select(0i, 1i, (_e1759 < f32(_e1766))));
let _e1771 = (262147i + _e1770);
let _e1773 = (bitcast<i32>(_e125) - 1i);
let _e1775 = select(_e1773, _e1771, (_e1771 < _e1773));
let _e1781 = global_3.member[bitcast<u32>(select(0i, _e1775, (_e1775 > 0i)))];
let _e1791 = select(_e1773, 262146i, (262146i < _e1773));
let _e1797 = global_3.member[bitcast<u32>(select(0i, _e1791, (_e1791 > 0i)))];
let _e1798 = bitcast<f32>(_e1797);
let _e1799 = (f32((bitcast<i32>((_e1781 & 4095u)) - 2048i)) * _e1798);
let _e1801 = select(_e1773, 262144i, (262144i < _e1773));
let _e1807 = global_3.member[bitcast<u32>(select(0i, _e1801, (_e1801 > 0i)))];
let _e1808 = bitcast<f32>(_e1807);
let _e1810 = select(_e1773, 262145i, (262145i < _e1773));
let _e1816 = global_3.member[bitcast<u32>(select(0i, _e1810, (_e1810 > 0i)))];
let _e1817 = bitcast<f32>(_e1816);
let _e1823 = ((_e1808 + (f32(bitcast<i32>((_e1781 >> bitcast<u32>(12u)))) * _e1817)) + (_e1799 * (_e1754 - f32(_e1770))));
let _e1824 = (_e1799 * 1024f);
if _e791 {
let _e1831 = ((0.5f * (_e1729 - _e1723)) * _e1824);
let _e1832 = ((0.5f * (_e1741 - _e1735)) * _e1824);
let _e1833 = ((0.5f * (_e1753 - _e1747)) * _e1824);
phi_3602_ = type_29(_e1823, vec3<f32>(_e1831, _e1832, _e1833), vec3<f32>((_e1831 * _e1823), (_e1832 * _e1823), (_e1833 * _e1823)));
} else {
let _e1840 = (_e1723 * 1024f);
let _e1842 = select(0f, _e1840, (_e1840 > 0f));
let _e1844 = select(_e1755, _e1842, (_e1842 < _e1755));
let _e1851 = select(0i, select(select(i32(_e1844), i32(-2147483648), (_e1844 < -2147483600f)), 2147483647i, (_e1844 > 2147483500f)), (_e1844 == _e1844));
let _e1855 = (_e1851 - select(0i, 1i, (_e1844 < f32(_e1851))));
let _e1856 = (262147i + _e1855);
let _e1858 = select(_e1773, _e1856, (_e1856 < _e1773));
let _e1864 = global_3.member[bitcast<u32>(select(0i, _e1858, (_e1858 > 0i)))];
let _e1879 = ((_e1808 + (f32(bitcast<i32>((_e1864 >> bitcast<u32>(12u)))) * _e1817)) + ((f32((bitcast<i32>((_e1864 & 4095u)) - 2048i)) * _e1798) * (_e1840 - f32(_e1855))));
let _e1880 = (_e1729 * 1024f);
let _e1882 = select(0f, _e1880, (_e1880 > 0f));
let _e1884 = select(_e1755, _e1882, (_e1882 < _e1755));
let _e1891 = select(0i, select(select(i32(_e1884), i32(-2147483648), (_e1884 < -2147483600f)), 2147483647i, (_e1884 > 2147483500f)), (_e1884 == _e1884));
let _e1895 = (_e1891 - select(0i, 1i, (_e1884 < f32(_e1891))));
let _e1896 = (262147i + _e1895);
let _e1898 = select(_e1773, _e1896, (_e1896 < _e1773));
let _e1904 = global_3.member[bitcast<u32>(select(0i, _e1898, (_e1898 > 0i)))];
let _e1919 = ((_e1808 + (f32(bitcast<i32>((_e1904 >> bitcast<u32>(12u)))) * _e1817)) + ((f32((bitcast<i32>((_e1904 & 4095u)) - 2048i)) * _e1798) * (_e1880 - f32(_e1895))));
let _e1920 = (_e1735 * 1024f);
let _e1922 = select(0f, _e1920, (_e1920 > 0f));
let _e1924 = select(_e1755, _e1922, (_e1922 < _e1755));
let _e1931 = select(0i, select(select(i32(_e1924), i32(-2147483648), (_e1924 < -2147483600f)), 2147483647i, (_e1924 > 2147483500f)), (_e1924 == _e1924));
let _e1935 = (_e1931 - select(0i, 1i, (_e1924 < f32(_e1931))));
let _e1936 = (262147i + _e1935);
let _e1938 = select(_e1773, _e1936, (_e1936 < _e1773));
let _e1944 = global_3.member[bitcast<u32>(select(0i, _e1938, (_e1938 > 0i)))];
let _e1959 = ((_e1808 + (f32(bitcast<i32>((_e1944 >> bitcast<u32>(12u)))) * _e1817)) + ((f32((bitcast<i32>((_e1944 & 4095u)) - 2048i)) * _e1798) * (_e1920 - f32(_e1935))));
let _e1960 = (_e1741 * 1024f);
let _e1962 = select(0f, _e1960, (_e1960 > 0f));
let _e1964 = select(_e1755, _e1962, (_e1962 < _e1755));
let _e1971 = select(0i, select(select(i32(_e1964), i32(-2147483648), (_e1964 < -2147483600f)), 2147483647i, (_e1964 > 2147483500f)), (_e1964 == _e1964));
let _e1975 = (_e1971 - select(0i, 1i, (_e1964 < f32(_e1971))));
let _e1976 = (262147i + _e1975);
let _e1978 = select(_e1773, _e1976, (_e1976 < _e1773));
let _e1984 = global_3.member[bitcast<u32>(select(0i, _e1978, (_e1978 > 0i)))];
let _e1999 = ((_e1808 + (f32(bitcast<i32>((_e1984 >> bitcast<u32>(12u)))) * _e1817)) + ((f32((bitcast<i32>((_e1984 & 4095u)) - 2048i)) * _e1798) * (_e1960 - f32(_e1975))));
let _e2000 = (_e1747 * 1024f);
let _e2002 = select(0f, _e2000, (_e2000 > 0f));
let _e2004 = select(_e1755, _e2002, (_e2002 < _e1755));
let _e2011 = select(0i, select(select(i32(_e2004), i32(-2147483648), (_e2004 < -2147483600f)), 2147483647i, (_e2004 > 2147483500f)), (_e2004 == _e2004));
let _e2015 = (_e2011 - select(0i, 1i, (_e2004 < f32(_e2011))));
let _e2016 = (262147i + _e2015);
let _e2018 = select(_e1773, _e2016, (_e2016 < _e1773));
let _e2024 = global_3.member[bitcast<u32>(select(0i, _e2018, (_e2018 > 0i)))];
let _e2039 = ((_e1808 + (f32(bitcast<i32>((_e2024 >> bitcast<u32>(12u)))) * _e1817)) + ((f32((bitcast<i32>((_e2024 & 4095u)) - 2048i)) * _e1798) * (_e2000 - f32(_e2015))));
let _e2040 = (_e1753 * 1024f);
let _e2042 = select(0f, _e2040, (_e2040 > 0f));
let _e2044 = select(_e1755, _e2042, (_e2042 < _e1755));
let _e2051 = select(0i, select(select(i32(_e2044), i32(-2147483648), (_e2044 < -2147483600f)), 2147483647i, (_e2044 > 2147483500f)), (_e2044 == _e2044));
let _e2055 = (_e2051 - select(0i, 1i, (_e2044 < f32(_e2051))));
let _e2056 = (262147i + _e2055);
let _e2058 = select(_e1773, _e2056, (_e2056 < _e1773));
let _e2064 = global_3.member[bitcast<u32>(select(0i, _e2058, (_e2058 > 0i)))];
let _e2079 = ((_e1808 + (f32(bitcast<i32>((_e2064 >> bitcast<u32>(12u)))) * _e1817)) + ((f32((bitcast<i32>((_e2064 & 4095u)) - 2048i)) * _e1798) * (_e2040 - f32(_e2055))));
let _e2080 = (_e1919 - _e1879);
let _e2082 = (_e1999 - _e1959);
let _e2084 = (_e2079 - _e2039);
phi_3602_ = type_29(_e1823, vec3<f32>((0.5f * _e2080), (0.5f * _e2082), (0.5f * _e2084)), vec3<f32>((0.25f * (_e2080 * (_e1919 + _e1879))), (0.25f * (_e2082 * (_e1999 + _e1959))), (0.25f * (_e2084 * (_e2079 + _e2039)))));
}
let _e2099 = phi_3602_;
let _e2114 = select(0f, 1f, ((((((_e498 >= -0.5f) && (_e498 <= _e522)) && (_e504 >= -0.5f)) && (_e504 <= _e533)) && (_e510 >= -0.5f)) && (_e510 <= _e544)));
let _e2116 = (0.5f * (_e1729 - _e1723));
let _e2118 = (0.5f * (_e1741 - _e1735));
let _e2120 = (0.5f * (_e1753 - _e1747));
let _e2127 = global_5.member[_e354].member_6.member.member.member;
let _e2134 = global_5.member[_e354].member_6.member.member.member_1;
let _e2141 = global_5.member[_e354].member_6.member.member.member_2;
let _e2148 = global_5.member[_e354].member_6.member_1.member.member;
let _e2155 = global_5.member[_e354].member_6.member_1.member.member_1;
let _e2162 = global_5.member[_e354].member_6.member_1.member.member_2;
let _e2169 = global_5.member[_e354].member_6.member_2.member.member;
let _e2176 = global_5.member[_e354].member_6.member_2.member.member_1;
let _e2183 = global_5.member[_e354].member_6.member_2.member.member_2;
phi_4304_ = type_30(_e1717, vec3<f32>(((((_e2127 * _e2116) + (_e2148 * _e2118)) + (_e2169 * _e2120)) * _e2114), ((((_e2134 * _e2116) + (_e2155 * _e2118)) + (_e2176 * _e2120)) * _e2114), ((((_e2141 * _e2116) + (_e2162 * _e2118)) + (_e2183 * _e2120)) * _e2114)), _e2099.member, vec3<f32>(((((_e2127 * _e2099.member_2.x) + (_e2148 * _e2099.member_2.y)) + (_e2169 * _e2099.member_2.z)) * _e2114), ((((_e2134 * _e2099.member_2.x) + (_e2155 * _e2099.member_2.y)) + (_e2176 * _e2099.member_2.z)) * _e2114), ((((_e2141 * _e2099.member_2.x) + (_e2162 * _e2099.member_2.y)) + (_e2183 * _e2099.member_2.z)) * _e2114)), vec3<f32>(((((_e2127 * _e2099.member_1.x) + (_e2148 * _e2099.member_1.y)) + (_e2169 * _e2099.member_1.z)) * _e2114), ((((_e2134 * _e2099.member_1.x) + (_e2155 * _e2099.member_1.y)) + (_e2176 * _e2099.member_1.z)) * _e2114), ((((_e2141 * _e2099.member_1.x) + (_e2162 * _e2099.member_1.y)) + (_e2183 * _e2099.member_1.z)) * _e2114)));
} else {
let _e2249 = select(-1f, _e526, (_e526 > -1f));
let _e2251 = select(_e521, _e2249, (_e2249 < _e521));
let _e2258 = select(0i, select(select(i32(_e2251), i32(-2147483648), (_e2251 < -2147483600f)), 2147483647i, (_e2251 > 2147483500f)), (_e2251 == _e2251));
let _e2262 = (_e2258 - select(0i, 1i, (_e2251 < f32(_e2258))));
let _e2264 = select(-1f, _e537, (_e537 > -1f));
let _e2266 = select(_e532, _e2264, (_e2264 < _e532));
let _e2273 = select(0i, select(select(i32(_e2266), i32(-2147483648), (_e2266 < -2147483600f)), 2147483647i, (_e2266 > 2147483500f)), (_e2266 == _e2266));
let _e2277 = (_e2273 - select(0i, 1i, (_e2266 < f32(_e2273))));
let _e2279 = select(-1f, _e548, (_e548 > -1f));
let _e2281 = select(_e543, _e2279, (_e2279 < _e543));
let _e2288 = select(0i, select(select(i32(_e2281), i32(-2147483648), (_e2281 < -2147483600f)), 2147483647i, (_e2281 > 2147483500f)), (_e2281 == _e2281));
let _e2292 = (_e2288 - select(0i, 1i, (_e2281 < f32(_e2288))));
let _e2297 = global_5.member[_e354].member_6.member_7;
let _e2302 = global_5.member[_e354].member_6.member_8;
let _e2303 = (_e2262 + 1i);
let _e2304 = (_e2277 + 1i);
let _e2305 = (_e2292 + 1i);
let _e2311 = global_5.member[_e354].member_6.member_11.member;
let _e2318 = global_5.member[_e354].member_6.member_11.member_1;
let _e2329 = ((_e2303 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2311) * ((_e2304 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2318) * (_e2305 >> bitcast<u32>(4i))))));
let _e2331 = (bitcast<i32>(_e121) - 1i);
let _e2333 = select(_e2331, _e2329, (_e2329 < _e2331));
let _e2339 = global_1.member[bitcast<u32>(select(0i, _e2333, (_e2333 > 0i)))];
let _e2341 = (_e2303 & 15i);
let _e2344 = ((_e2304 & 15i) * _e2297);
let _e2346 = (bitcast<i32>(_e2339) + ((_e2305 & 15i) * _e2302));
let _e2347 = (_e2344 + _e2297);
let _e2349 = (_e2344 + (2i * _e2297));
let _e2350 = (_e2346 + _e2302);
let _e2352 = (_e2346 + (2i * _e2302));
local_4 = type_28(array<i32, 4>(_e2341, _e2341, _e2341, _e2341), array<u32, 6>(0u, 8u, 16u, 24u, 0u, 0u));
local_5 = vec3<f32>((_e526 - f32(_e2262)), (_e537 - f32(_e2277)), (_e548 - f32(_e2292)));
let _e2366 = local_4.member[0u];
let _e2367 = ((_e2350 + _e2347) + _e2366);
let _e2369 = (_e2367 >> bitcast<u32>(2i));
let _e2372 = bitcast<u32>(((_e2367 & 3i) * 8i));
let _e2374 = select(_e2331, _e2369, (_e2369 < _e2331));
let _e2379 = global_1.member[bitcast<u32>(select(0i, _e2374, (_e2374 > 0i)))];
let _e2383 = (_e2369 + 1i);
let _e2385 = select(_e2331, _e2383, (_e2383 < _e2331));
let _e2390 = global_1.member[bitcast<u32>(select(0i, _e2385, (_e2385 > 0i)))];
let _e2397 = ((_e2379 >> bitcast<u32>((_e2372 & 31u))) | ((_e2390 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2372) & 31u))));
let _e2400 = local_4.member_1[1u];
let _e2406 = f32(bitcast<i32>(((_e2397 >> bitcast<u32>((_e2400 & 31u))) & 255u)));
let _e2409 = local_4.member_1[2u];
let _e2416 = local_5[0u];
let _e2419 = (_e2406 + ((f32(bitcast<i32>(((_e2397 >> bitcast<u32>((_e2409 & 31u))) & 255u))) - _e2406) * _e2416));
let _e2421 = local_4.member[0u];
let _e2422 = ((_e2350 + _e2349) + _e2421);
let _e2424 = (_e2422 >> bitcast<u32>(2i));
let _e2427 = bitcast<u32>(((_e2422 & 3i) * 8i));
let _e2429 = select(_e2331, _e2424, (_e2424 < _e2331));
let _e2434 = global_1.member[bitcast<u32>(select(0i, _e2429, (_e2429 > 0i)))];
let _e2438 = (_e2424 + 1i);
let _e2440 = select(_e2331, _e2438, (_e2438 < _e2331));
let _e2445 = global_1.member[bitcast<u32>(select(0i, _e2440, (_e2440 > 0i)))];
let _e2452 = ((_e2434 >> bitcast<u32>((_e2427 & 31u))) | ((_e2445 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2427) & 31u))));
let _e2453 = local_4.member_1[1u];
let _e2459 = f32(bitcast<i32>(((_e2452 >> bitcast<u32>((_e2453 & 31u))) & 255u)));
let _e2460 = local_4.member_1[2u];
let _e2467 = local_5[0u];
let _e2472 = local_5[1u];
let _e2475 = (_e2419 + (((_e2459 + ((f32(bitcast<i32>(((_e2452 >> bitcast<u32>((_e2460 & 31u))) & 255u))) - _e2459) * _e2467)) - _e2419) * _e2472));
let _e2477 = local_4.member[0u];
let _e2478 = ((_e2352 + _e2347) + _e2477);
let _e2480 = (_e2478 >> bitcast<u32>(2i));
let _e2483 = bitcast<u32>(((_e2478 & 3i) * 8i));
let _e2485 = select(_e2331, _e2480, (_e2480 < _e2331));
let _e2490 = global_1.member[bitcast<u32>(select(0i, _e2485, (_e2485 > 0i)))];
let _e2494 = (_e2480 + 1i);
let _e2496 = select(_e2331, _e2494, (_e2494 < _e2331));
let _e2501 = global_1.member[bitcast<u32>(select(0i, _e2496, (_e2496 > 0i)))];
let _e2508 = ((_e2490 >> bitcast<u32>((_e2483 & 31u))) | ((_e2501 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2483) & 31u))));
let _e2509 = local_4.member_1[1u];
let _e2515 = f32(bitcast<i32>(((_e2508 >> bitcast<u32>((_e2509 & 31u))) & 255u)));
let _e2516 = local_4.member_1[2u];
let _e2523 = local_5[0u];
let _e2526 = (_e2515 + ((f32(bitcast<i32>(((_e2508 >> bitcast<u32>((_e2516 & 31u))) & 255u))) - _e2515) * _e2523));
let _e2528 = local_4.member[0u];
let _e2529 = ((_e2352 + _e2349) + _e2528);
let _e2531 = (_e2529 >> bitcast<u32>(2i));
let _e2534 = bitcast<u32>(((_e2529 & 3i) * 8i));
let _e2536 = select(_e2331, _e2531, (_e2531 < _e2331));
let _e2541 = global_1.member[bitcast<u32>(select(0i, _e2536, (_e2536 > 0i)))];
let _e2545 = (_e2531 + 1i);
let _e2547 = select(_e2331, _e2545, (_e2545 < _e2331));
let _e2552 = global_1.member[bitcast<u32>(select(0i, _e2547, (_e2547 > 0i)))];
let _e2559 = ((_e2541 >> bitcast<u32>((_e2534 & 31u))) | ((_e2552 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2534) & 31u))));
let _e2560 = local_4.member_1[1u];
let _e2566 = f32(bitcast<i32>(((_e2559 >> bitcast<u32>((_e2560 & 31u))) & 255u)));
let _e2567 = local_4.member_1[2u];
let _e2574 = local_5[0u];
let _e2578 = local_5[1u];
let _e2583 = local_5[2u];
let _e2591 = global_5.member[_e354].member_6.member_5;
let _e2597 = global_5.member[_e354].member_6.member_6;
let _e2598 = (((_e2475 + (((_e2526 + (((_e2566 + ((f32(bitcast<i32>(((_e2559 >> bitcast<u32>((_e2567 & 31u))) & 255u))) - _e2566) * _e2574)) - _e2526) * _e2578)) - _e2475) * _e2583)) * _e2591) + _e2597);
let _e2600 = select(0f, _e2598, (_e2598 > 0f));
phi_4304_ = type_30(select(1f, _e2600, (_e2600 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2605 = phi_4304_;
let _e2609 = select(-0.5f, _e460, (_e460 > -0.5f));
let _e2611 = select(_e522, _e2609, (_e2609 < _e522));
let _e2613 = select(-0.5f, _e476, (_e476 > -0.5f));
let _e2615 = select(_e533, _e2613, (_e2613 < _e533));
let _e2617 = select(-0.5f, _e492, (_e492 > -0.5f));
let _e2619 = select(_e544, _e2617, (_e2617 < _e544));
let _e2621 = select(-1f, _e2611, (_e2611 > -1f));
let _e2623 = select(_e521, _e2621, (_e2621 < _e521));
let _e2630 = select(0i, select(select(i32(_e2623), i32(-2147483648), (_e2623 < -2147483600f)), 2147483647i, (_e2623 > 2147483500f)), (_e2623 == _e2623));
let _e2634 = (_e2630 - select(0i, 1i, (_e2623 < f32(_e2630))));
let _e2636 = select(-1f, _e2615, (_e2615 > -1f));
let _e2638 = select(_e532, _e2636, (_e2636 < _e532));
let _e2645 = select(0i, select(select(i32(_e2638), i32(-2147483648), (_e2638 < -2147483600f)), 2147483647i, (_e2638 > 2147483500f)), (_e2638 == _e2638));
let _e2649 = (_e2645 - select(0i, 1i, (_e2638 < f32(_e2645))));
let _e2651 = select(-1f, _e2619, (_e2619 > -1f));
let _e2653 = select(_e543, _e2651, (_e2651 < _e543));
let _e2660 = select(0i, select(select(i32(_e2653), i32(-2147483648), (_e2653 < -2147483600f)), 2147483647i, (_e2653 > 2147483500f)), (_e2653 == _e2653));
let _e2664 = (_e2660 - select(0i, 1i, (_e2653 < f32(_e2660))));
let _e2669 = global_5.member[_e354].member_6.member_7;
let _e2674 = global_5.member[_e354].member_6.member_8;
let _e2675 = (_e2634 + 1i);
let _e2676 = (_e2649 + 1i);
let _e2677 = (_e2664 + 1i);
let _e2683 = global_5.member[_e354].member_6.member_11.member;
let _e2690 = global_5.member[_e354].member_6.member_11.member_1;
let _e2701 = ((_e2675 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2683) * ((_e2676 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2690) * (_e2677 >> bitcast<u32>(4i))))));
let _e2703 = (bitcast<i32>(_e121) - 1i);
let _e2705 = select(_e2703, _e2701, (_e2701 < _e2703));
let _e2711 = global_1.member[bitcast<u32>(select(0i, _e2705, (_e2705 > 0i)))];
let _e2713 = (_e2675 & 15i);
let _e2716 = ((_e2676 & 15i) * _e2669);
let _e2718 = (bitcast<i32>(_e2711) + ((_e2677 & 15i) * _e2674));
let _e2719 = (_e2716 + _e2669);
let _e2721 = (_e2716 + (2i * _e2669));
let _e2722 = (_e2718 + _e2674);
let _e2724 = (_e2718 + (2i * _e2674));
local_2 = type_28(array<i32, 4>(_e2713, _e2713, _e2713, _e2713), array<u32, 6>(0u, 8u, 16u, 24u, 0u, 0u));
local_3 = vec3<f32>((_e2611 - f32(_e2634)), (_e2615 - f32(_e2649)), (_e2619 - f32(_e2664)));
let _e2738 = local_2.member[0u];
let _e2739 = ((_e2722 + _e2719) + _e2738);
let _e2741 = (_e2739 >> bitcast<u32>(2i));
let _e2744 = bitcast<u32>(((_e2739 & 3i) * 8i));
let _e2746 = select(_e2703, _e2741, (_e2741 < _e2703));
let _e2751 = global_1.member[bitcast<u32>(select(0i, _e2746, (_e2746 > 0i)))];
let _e2755 = (_e2741 + 1i);
let _e2757 = select(_e2703, _e2755, (_e2755 < _e2703));
let _e2762 = global_1.member[bitcast<u32>(select(0i, _e2757, (_e2757 > 0i)))];
let _e2769 = ((_e2751 >> bitcast<u32>((_e2744 & 31u))) | ((_e2762 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2744) & 31u))));
let _e2772 = local_2.member_1[1u];
let _e2778 = f32(bitcast<i32>(((_e2769 >> bitcast<u32>((_e2772 & 31u))) & 255u)));
let _e2781 = local_2.member_1[2u];
let _e2788 = local_3[0u];
let _e2791 = (_e2778 + ((f32(bitcast<i32>(((_e2769 >> bitcast<u32>((_e2781 & 31u))) & 255u))) - _e2778) * _e2788));
let _e2793 = local_2.member[0u];
let _e2794 = ((_e2722 + _e2721) + _e2793);
let _e2796 = (_e2794 >> bitcast<u32>(2i));
let _e2799 = bitcast<u32>(((_e2794 & 3i) * 8i));
let _e2801 = select(_e2703, _e2796, (_e2796 < _e2703));
let _e2806 = global_1.member[bitcast<u32>(select(0i, _e2801, (_e2801 > 0i)))];
let _e2810 = (_e2796 + 1i);
let _e2812 = select(_e2703, _e2810, (_e2810 < _e2703));
let _e2817 = global_1.member[bitcast<u32>(select(0i, _e2812, (_e2812 > 0i)))];
let _e2824 = ((_e2806 >> bitcast<u32>((_e2799 & 31u))) | ((_e2817 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2799) & 31u))));
let _e2825 = local_2.member_1[1u];
let _e2831 = f32(bitcast<i32>(((_e2824 >> bitcast<u32>((_e2825 & 31u))) & 255u)));
let _e2832 = local_2.member_1[2u];
let _e2839 = local_3[0u];
let _e2844 = local_3[1u];
let _e2847 = (_e2791 + (((_e2831 + ((f32(bitcast<i32>(((_e2824 >> bitcast<u32>((_e2832 & 31u))) & 255u))) - _e2831) * _e2839)) - _e2791) * _e2844));
let _e2849 = local_2.member[0u];
let _e2850 = ((_e2724 + _e2719) + _e2849);
let _e2852 = (_e2850 >> bitcast<u32>(2i));
let _e2855 = bitcast<u32>(((_e2850 & 3i) * 8i));
let _e2857 = select(_e2703, _e2852, (_e2852 < _e2703));
let _e2862 = global_1.member[bitcast<u32>(select(0i, _e2857, (_e2857 > 0i)))];
let _e2866 = (_e2852 + 1i);
let _e2868 = select(_e2703, _e2866, (_e2866 < _e2703));
let _e2873 = global_1.member[bitcast<u32>(select(0i, _e2868, (_e2868 > 0i)))];
let _e2880 = ((_e2862 >> bitcast<u32>((_e2855 & 31u))) | ((_e2873 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2855) & 31u))));
let _e2881 = local_2.member_1[1u];
let _e2887 = f32(bitcast<i32>(((_e2880 >> bitcast<u32>((_e2881 & 31u))) & 255u)));
let _e2888 = local_2.member_1[2u];
let _e2895 = local_3[0u];
let _e2898 = (_e2887 + ((f32(bitcast<i32>(((_e2880 >> bitcast<u32>((_e2888 & 31u))) & 255u))) - _e2887) * _e2895));
let _e2900 = local_2.member[0u];
let _e2901 = ((_e2724 + _e2721) + _e2900);
let _e2903 = (_e2901 >> bitcast<u32>(2i));
let _e2906 = bitcast<u32>(((_e2901 & 3i) * 8i));
let _e2908 = select(_e2703, _e2903, (_e2903 < _e2703));
let _e2913 = global_1.member[bitcast<u32>(select(0i, _e2908, (_e2908 > 0i)))];
let _e2917 = (_e2903 + 1i);
let _e2919 = select(_e2703, _e2917, (_e2917 < _e2703));
let _e2924 = global_1.member[bitcast<u32>(select(0i, _e2919, (_e2919 > 0i)))];
let _e2931 = ((_e2913 >> bitcast<u32>((_e2906 & 31u))) | ((_e2924 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2906) & 31u))));
let _e2932 = local_2.member_1[1u];
let _e2938 = f32(bitcast<i32>(((_e2931 >> bitcast<u32>((_e2932 & 31u))) & 255u)));
let _e2939 = local_2.member_1[2u];
let _e2946 = local_3[0u];
let _e2950 = local_3[1u];
let _e2955 = local_3[2u];
let _e2963 = global_5.member[_e354].member_6.member_5;
let _e2969 = global_5.member[_e354].member_6.member_6;
let _e2970 = (((_e2847 + (((_e2898 + (((_e2938 + ((f32(bitcast<i32>(((_e2931 >> bitcast<u32>((_e2939 & 31u))) & 255u))) - _e2938) * _e2946)) - _e2898) * _e2950)) - _e2847) * _e2955)) * _e2963) + _e2969);
let _e2972 = select(0f, _e2970, (_e2970 > 0f));
let _e2974 = select(1f, _e2972, (_e2972 < 1f));
let _e2975 = select(_e358[5], _e2974, _e720);
if _e794 {
let _e2976 = (_e2974 * 1024f);
let _e2977 = (1024f - 1f);
let _e2979 = select(0f, _e2976, (_e2976 > 0f));
let _e2981 = select(_e2977, _e2979, (_e2979 < _e2977));
let _e2988 = select(0i, select(select(i32(_e2981), i32(-2147483648), (_e2981 < -2147483600f)), 2147483647i, (_e2981 > 2147483500f)), (_e2981 == _e2981));
let _e2992 = (_e2988 - select(0i, 1i, (_e2981 < f32(_e2988))));
let _e2993 = (262147i + _e2992);
let _e2995 = (bitcast<i32>(_e125) - 1i);
let _e2997 = select(_e2995, _e2993, (_e2993 < _e2995));
let _e3003 = global_3.member[bitcast<u32>(select(0i, _e2997, (_e2997 > 0i)))];
let _e3013 = select(_e2995, 262146i, (262146i < _e2995));
let _e3019 = global_3.member[bitcast<u32>(select(0i, _e3013, (_e3013 > 0i)))];
let _e3023 = select(_e2995, 262144i, (262144i < _e2995));
let _e3029 = global_3.member[bitcast<u32>(select(0i, _e3023, (_e3023 > 0i)))];
let _e3032 = select(_e2995, 262145i, (262145i < _e2995));
let _e3038 = global_3.member[bitcast<u32>(select(0i, _e3032, (_e3032 > 0i)))];
phi_4946_ = select(_e358[15], ((bitcast<f32>(_e3029) + (f32(bitcast<i32>((_e3003 >> bitcast<u32>(12u)))) * bitcast<f32>(_e3038))) + ((f32((bitcast<i32>((_e3003 & 4095u)) - 2048i)) * bitcast<f32>(_e3019)) * (_e2976 - f32(_e2992)))), _e720);
} else {
phi_4946_ = _e358[15];
}
let _e3048 = phi_4946_;
let _e3051 = select(1f, select(1f, _e789, (_e789 < 1f)), _e444);
if ((_e687 & 16u) == 0u) {
phi_5335_ = type_5(1f, 1f, 1f);
} else {
let _e3058 = global_5.member[_e354].member_14.member;
let _e3069 = ((((_e3058.member.member * _e379) + (_e3058.member.member_1 * _e382)) + (_e3058.member.member_2 * _e373)) + _e3058.member_1);
let _e3075 = ((((_e3058.member.member * _e384) + (_e3058.member.member_1 * _e386)) + (_e3058.member.member_2 * _e391)) + _e3058.member_1);
let _e3077 = select(_e3075, _e3069, (_e3069 < _e3075));
let _e3079 = select(_e3075, _e3069, (_e3069 > _e3075));
let _e3081 = (_e3079 - _e3077);
let _e3084 = (-(_e3077) / select(1e-30f, _e3081, (_e3081 > 1e-30f)));
let _e3086 = select(0f, _e3084, (_e3084 > 0f));
let _e3092 = select(select(select(1f, _e3086, (_e3086 < 1f)), 1f, (_e3079 <= 0f)), 0f, (_e3077 > 0f));
let _e3098 = global_5.member[_e354].member_14.member_1;
let _e3099 = (_e3098 != 0u);
let _e3110 = global_5.member[_e354].member_15.member;
let _e3121 = ((((_e3110.member.member * _e379) + (_e3110.member.member_1 * _e382)) + (_e3110.member.member_2 * _e373)) + _e3110.member_1);
let _e3127 = ((((_e3110.member.member * _e384) + (_e3110.member.member_1 * _e386)) + (_e3110.member.member_2 * _e391)) + _e3110.member_1);
let _e3129 = select(_e3127, _e3121, (_e3121 < _e3127));
let _e3131 = select(_e3127, _e3121, (_e3121 > _e3127));
let _e3133 = (_e3131 - _e3129);
let _e3136 = (-(_e3129) / select(1e-30f, _e3133, (_e3133 > 1e-30f)));
let _e3138 = select(0f, _e3136, (_e3136 > 0f));
let _e3144 = select(select(select(1f, _e3138, (_e3138 < 1f)), 1f, (_e3131 <= 0f)), 0f, (_e3129 > 0f));
let _e3150 = global_5.member[_e354].member_15.member_1;
let _e3151 = (_e3150 != 0u);
let _e3162 = global_5.member[_e354].member_16.member;
let _e3173 = ((((_e3162.member.member * _e379) + (_e3162.member.member_1 * _e382)) + (_e3162.member.member_2 * _e373)) + _e3162.member_1);
let _e3179 = ((((_e3162.member.member * _e384) + (_e3162.member.member_1 * _e386)) + (_e3162.member.member_2 * _e391)) + _e3162.member_1);
let _e3181 = select(_e3179, _e3173, (_e3173 < _e3179));
let _e3183 = select(_e3179, _e3173, (_e3173 > _e3179));
let _e3185 = (_e3183 - _e3181);
let _e3188 = (-(_e3181) / select(1e-30f, _e3185, (_e3185 > 1e-30f)));
let _e3190 = select(0f, _e3188, (_e3188 > 0f));
let _e3196 = select(select(select(1f, _e3190, (_e3190 < 1f)), 1f, (_e3183 <= 0f)), 0f, (_e3181 > 0f));
let _e3202 = global_5.member[_e354].member_16.member_1;
let _e3203 = (_e3202 != 0u);
let _e3214 = global_5.member[_e354].member_17.member;
let _e3225 = ((((_e3214.member.member * _e379) + (_e3214.member.member_1 * _e382)) + (_e3214.member.member_2 * _e373)) + _e3214.member_1);
let _e3231 = ((((_e3214.member.member * _e384) + (_e3214.member.member_1 * _e386)) + (_e3214.member.member_2 * _e391)) + _e3214.member_1);
let _e3233 = select(_e3231, _e3225, (_e3225 < _e3231));
let _e3235 = select(_e3231, _e3225, (_e3225 > _e3231));
let _e3237 = (_e3235 - _e3233);
let _e3240 = (-(_e3233) / select(1e-30f, _e3237, (_e3237 > 1e-30f)));
let _e3242 = select(0f, _e3240, (_e3240 > 0f));
let _e3248 = select(select(select(1f, _e3242, (_e3242 < 1f)), 1f, (_e3235 <= 0f)), 0f, (_e3233 > 0f));
let _e3254 = global_5.member[_e354].member_17.member_1;
let _e3255 = (_e3254 != 0u);
phi_5335_ = type_5(((((1f * _e3092) * _e3144) * _e3196) * _e3248), ((((1f * select(1f, _e3092, _e3099)) * select(1f, _e3144, _e3151)) * select(1f, _e3196, _e3203)) * select(1f, _e3248, _e3255)), ((((1f * select(1f, 0f, (_e3099 && (_e3075 > 0f)))) * select(1f, 0f, (_e3151 && (_e3127 > 0f)))) * select(1f, 0f, (_e3203 && (_e3179 > 0f)))) * select(1f, 0f, (_e3255 && (_e3231 > 0f)))));
}
let _e3264 = phi_5335_;
let _e3265 = (_e554 < 1e-12f);
let _e3267 = (1f / select(_e549, 1f, _e3265));
let _e3269 = ((-0.5f - _e460) * _e3267);
let _e3271 = ((_e522 - _e460) * _e3267);
let _e3277 = select(_e3271, _e3269, (_e3269 < _e3271));
let _e3279 = select(0f, _e3277, (_e3277 > 0f));
let _e3282 = select(select(1f, _e3279, (_e3279 < 1f)), select(2f, 0f, ((_e460 >= -0.5f) && (_e460 <= _e522))), _e3265);
let _e3284 = select(_e3271, _e3269, (_e3269 > _e3271));
let _e3286 = select(0f, _e3284, (_e3284 > 0f));
let _e3289 = select(select(1f, _e3286, (_e3286 < 1f)), 1f, _e3265);
let _e3290 = (_e557 < 1e-12f);
let _e3292 = (1f / select(_e550, 1f, _e3290));
let _e3294 = ((-0.5f - _e476) * _e3292);
let _e3296 = ((_e533 - _e476) * _e3292);
let _e3302 = select(_e3296, _e3294, (_e3294 < _e3296));
let _e3304 = select(0f, _e3302, (_e3302 > 0f));
let _e3307 = select(select(1f, _e3304, (_e3304 < 1f)), select(2f, 0f, ((_e476 >= -0.5f) && (_e476 <= _e533))), _e3290);
let _e3309 = select(_e3296, _e3294, (_e3294 > _e3296));
let _e3311 = select(0f, _e3309, (_e3309 > 0f));
let _e3314 = select(select(1f, _e3311, (_e3311 < 1f)), 1f, _e3290);
let _e3315 = (_e562 < 1e-12f);
let _e3317 = (1f / select(_e551, 1f, _e3315));
let _e3319 = ((-0.5f - _e492) * _e3317);
let _e3321 = ((_e544 - _e492) * _e3317);
let _e3327 = select(_e3321, _e3319, (_e3319 < _e3321));
let _e3329 = select(0f, _e3327, (_e3327 > 0f));
let _e3332 = select(select(1f, _e3329, (_e3329 < 1f)), select(2f, 0f, ((_e492 >= -0.5f) && (_e492 <= _e544))), _e3315);
let _e3334 = select(_e3321, _e3319, (_e3319 > _e3321));
let _e3336 = select(0f, _e3334, (_e3334 > 0f));
let _e3339 = select(select(1f, _e3336, (_e3336 < 1f)), 1f, _e3315);
let _e3341 = select(_e3314, _e3289, (_e3289 < _e3314));
let _e3345 = select(_e3307, _e3282, (_e3282 > _e3307));
let _e3348 = (select(_e3339, _e3341, (_e3341 < _e3339)) - select(_e3332, _e3345, (_e3345 > _e3332)));
let _e3351 = (_e384 - _e379);
let _e3352 = (_e386 - _e382);
let _e3353 = (_e391 - _e373);
let _e3358 = (((_e3351 * _e3351) + (_e3352 * _e3352)) + (_e3353 * _e3353));
let _e3368 = global_5.member[_e354].member_5.member_3;
let _e3369 = (((sqrt(select(0f, _e3358, (_e3358 > 0f))) * select(0f, _e3348, (_e3348 > 0f))) * _e3051) * _e3368);
let _e3370 = (_e731.member_2 >= 3u);
if _e3370 {
let _e3372 = (_e2975 * 255f);
let _e3373 = (_e2605.member * 255f);
let _e3374 = (255f - 1f);
let _e3376 = select(0f, _e3372, (_e3372 > 0f));
let _e3378 = select(_e3374, _e3376, (_e3376 < _e3374));
let _e3385 = select(0i, select(select(i32(_e3378), i32(-2147483648), (_e3378 < -2147483600f)), 2147483647i, (_e3378 > 2147483500f)), (_e3378 == _e3378));
let _e3389 = (_e3385 - select(0i, 1i, (_e3378 < f32(_e3385))));
let _e3391 = select(0f, _e3373, (_e3373 > 0f));
let _e3393 = select(_e3374, _e3391, (_e3391 < _e3374));
let _e3400 = select(0i, select(select(i32(_e3393), i32(-2147483648), (_e3393 < -2147483600f)), 2147483647i, (_e3393 > 2147483500f)), (_e3393 == _e3393));
let _e3404 = (_e3400 - select(0i, 1i, (_e3393 < f32(_e3400))));
let _e3407 = (((_e3389 * 256i) + _e3404) * 4i);
let _e3409 = (_e3372 - f32(_e3389));
let _e3411 = (_e3373 - f32(_e3404));
let _e3412 = (_e3407 + 2i);
let _e3414 = (bitcast<i32>(_e125) - 1i);
let _e3416 = select(_e3414, _e3412, (_e3412 < _e3414));
let _e3422 = global_3.member[bitcast<u32>(select(0i, _e3416, (_e3416 > 0i)))];
let _e3423 = (_e3407 + 6i);
let _e3425 = select(_e3414, _e3423, (_e3423 < _e3414));
let _e3431 = global_3.member[bitcast<u32>(select(0i, _e3425, (_e3425 > 0i)))];
let _e3432 = (_e3407 + 1026i);
let _e3434 = select(_e3414, _e3432, (_e3432 < _e3414));
let _e3440 = global_3.member[bitcast<u32>(select(0i, _e3434, (_e3434 > 0i)))];
let _e3441 = (_e3407 + 1030i);
let _e3443 = select(_e3414, _e3441, (_e3441 < _e3414));
let _e3449 = global_3.member[bitcast<u32>(select(0i, _e3443, (_e3443 > 0i)))];
let _e3454 = (bitcast<f32>(((_e3422 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3462 = (_e3454 + (((bitcast<f32>(((_e3431 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3454) * _e3411));
let _e3467 = (bitcast<f32>(((_e3440 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3491 = (bitcast<f32>((((_e3422 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3499 = (_e3491 + (((bitcast<f32>((((_e3431 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3491) * _e3411));
let _e3504 = (bitcast<f32>((((_e3440 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3516 = (_e3407 + 3i);
let _e3518 = select(_e3414, _e3516, (_e3516 < _e3414));
let _e3524 = global_3.member[bitcast<u32>(select(0i, _e3518, (_e3518 > 0i)))];
let _e3525 = (_e3407 + 7i);
let _e3527 = select(_e3414, _e3525, (_e3525 < _e3414));
let _e3533 = global_3.member[bitcast<u32>(select(0i, _e3527, (_e3527 > 0i)))];
let _e3534 = (_e3407 + 1027i);
let _e3536 = select(_e3414, _e3534, (_e3534 < _e3414));
let _e3542 = global_3.member[bitcast<u32>(select(0i, _e3536, (_e3536 > 0i)))];
let _e3543 = (_e3407 + 1031i);
let _e3545 = select(_e3414, _e3543, (_e3543 < _e3414));
let _e3551 = global_3.member[bitcast<u32>(select(0i, _e3545, (_e3545 > 0i)))];
let _e3556 = (bitcast<f32>(((_e3524 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3564 = (_e3556 + (((bitcast<f32>(((_e3533 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3556) * _e3411));
let _e3569 = (bitcast<f32>(((_e3542 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3593 = (bitcast<f32>((((_e3524 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3601 = (_e3593 + (((bitcast<f32>((((_e3533 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3593) * _e3411));
let _e3606 = (bitcast<f32>((((_e3542 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3617 = (_e3601 + (((_e3606 + (((bitcast<f32>((((_e3551 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3606) * _e3411)) - _e3601) * _e3409));
let _e3621 = -((_e3617 * (_e3369 * _e3264.member)));
let _e3623 = select(-87f, _e3621, (_e3621 > -87f));
let _e3625 = select(88f, _e3623, (_e3623 < 88f));
let _e3627 = ((_e3625 * 1.442695f) + 0.5f);
let _e3629 = select(-127f, _e3627, (_e3627 > -127f));
let _e3631 = select(128f, _e3629, (_e3629 < 128f));
let _e3638 = select(0i, select(select(i32(_e3631), i32(-2147483648), (_e3631 < -2147483600f)), 2147483647i, (_e3631 > 2147483500f)), (_e3631 == _e3631));
let _e3642 = (_e3638 - select(0i, 1i, (_e3631 < f32(_e3638))));
let _e3643 = f32(_e3642);
let _e3647 = ((_e3625 - (_e3643 * 0.6933594f)) - (_e3643 * -2.1219444e-4f));
let _e3667 = ((1f + (_e3647 * (1f + (_e3647 * (0.5f + (_e3647 * (0.16666667f + (_e3647 * (0.041666668f + (_e3647 * (0.008333334f + (_e3647 * (0.001388889f + (_e3647 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3642 + 127i)) << bitcast<u32>(23i))));
let _e3668 = (1f - _e3667);
let _e3671 = (_e3668 / select(1e-12f, _e3617, (_e3617 > 1e-12f)));
phi_6893_ = type_31(_e3667, _e3668, vec3<f32>(1f, 1f, 1f), vec3<f32>(((_e3462 + (((_e3467 + (((bitcast<f32>(((_e3449 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3467) * _e3411)) - _e3462) * _e3409)) * _e3671), ((_e3499 + (((_e3504 + (((bitcast<f32>((((_e3449 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3504) * _e3411)) - _e3499) * _e3409)) * _e3671), ((_e3564 + (((_e3569 + (((bitcast<f32>(((_e3551 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3569) * _e3411)) - _e3564) * _e3409)) * _e3671)));
} else {
let _e3678 = (_e2975 * 255f);
let _e3679 = (_e2605.member * 255f);
let _e3680 = (255f - 1f);
let _e3682 = select(0f, _e3678, (_e3678 > 0f));
let _e3684 = select(_e3680, _e3682, (_e3682 < _e3680));
let _e3691 = select(0i, select(select(i32(_e3684), i32(-2147483648), (_e3684 < -2147483600f)), 2147483647i, (_e3684 > 2147483500f)), (_e3684 == _e3684));
let _e3695 = (_e3691 - select(0i, 1i, (_e3684 < f32(_e3691))));
let _e3697 = select(0f, _e3679, (_e3679 > 0f));
let _e3699 = select(_e3680, _e3697, (_e3697 < _e3680));
let _e3706 = select(0i, select(select(i32(_e3699), i32(-2147483648), (_e3699 < -2147483600f)), 2147483647i, (_e3699 > 2147483500f)), (_e3699 == _e3699));
let _e3710 = (_e3706 - select(0i, 1i, (_e3699 < f32(_e3706))));
let _e3713 = (((_e3695 * 256i) + _e3710) * 4i);
let _e3715 = (_e3678 - f32(_e3695));
let _e3717 = (_e3679 - f32(_e3710));
let _e3719 = (bitcast<i32>(_e125) - 1i);
let _e3721 = select(_e3719, _e3713, (_e3713 < _e3719));
let _e3727 = global_3.member[bitcast<u32>(select(0i, _e3721, (_e3721 > 0i)))];
let _e3728 = (_e3713 + 4i);
let _e3730 = select(_e3719, _e3728, (_e3728 < _e3719));
let _e3736 = global_3.member[bitcast<u32>(select(0i, _e3730, (_e3730 > 0i)))];
let _e3737 = (_e3713 + 1024i);
let _e3739 = select(_e3719, _e3737, (_e3737 < _e3719));
let _e3745 = global_3.member[bitcast<u32>(select(0i, _e3739, (_e3739 > 0i)))];
let _e3746 = (_e3713 + 1028i);
let _e3748 = select(_e3719, _e3746, (_e3746 < _e3719));
let _e3754 = global_3.member[bitcast<u32>(select(0i, _e3748, (_e3748 > 0i)))];
let _e3759 = (bitcast<f32>(((_e3727 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3767 = (_e3759 + (((bitcast<f32>(((_e3736 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3759) * _e3717));
let _e3772 = (bitcast<f32>(((_e3745 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3783 = (_e3767 + (((_e3772 + (((bitcast<f32>(((_e3754 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3772) * _e3717)) - _e3767) * _e3715));
let _e3796 = (bitcast<f32>((((_e3727 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3804 = (_e3796 + (((bitcast<f32>((((_e3736 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3796) * _e3717));
let _e3809 = (bitcast<f32>((((_e3745 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3821 = (_e3713 + 1i);
let _e3823 = select(_e3719, _e3821, (_e3821 < _e3719));
let _e3829 = global_3.member[bitcast<u32>(select(0i, _e3823, (_e3823 > 0i)))];
let _e3830 = (_e3713 + 5i);
let _e3832 = select(_e3719, _e3830, (_e3830 < _e3719));
let _e3838 = global_3.member[bitcast<u32>(select(0i, _e3832, (_e3832 > 0i)))];
let _e3839 = (_e3713 + 1025i);
let _e3841 = select(_e3719, _e3839, (_e3839 < _e3719));
let _e3847 = global_3.member[bitcast<u32>(select(0i, _e3841, (_e3841 > 0i)))];
let _e3848 = (_e3713 + 1029i);
let _e3850 = select(_e3719, _e3848, (_e3848 < _e3719));
let _e3856 = global_3.member[bitcast<u32>(select(0i, _e3850, (_e3850 > 0i)))];
let _e3861 = (bitcast<f32>(((_e3829 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3869 = (_e3861 + (((bitcast<f32>(((_e3838 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3861) * _e3717));
let _e3874 = (bitcast<f32>(((_e3847 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3898 = (bitcast<f32>((((_e3829 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3906 = (_e3898 + (((bitcast<f32>((((_e3838 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3898) * _e3717));
let _e3911 = (bitcast<f32>((((_e3847 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3923 = (_e3713 + 2i);
let _e3925 = select(_e3719, _e3923, (_e3923 < _e3719));
let _e3931 = global_3.member[bitcast<u32>(select(0i, _e3925, (_e3925 > 0i)))];
let _e3932 = (_e3713 + 6i);
let _e3934 = select(_e3719, _e3932, (_e3932 < _e3719));
let _e3940 = global_3.member[bitcast<u32>(select(0i, _e3934, (_e3934 > 0i)))];
let _e3941 = (_e3713 + 1026i);
let _e3943 = select(_e3719, _e3941, (_e3941 < _e3719));
let _e3949 = global_3.member[bitcast<u32>(select(0i, _e3943, (_e3943 > 0i)))];
let _e3950 = (_e3713 + 1030i);
let _e3952 = select(_e3719, _e3950, (_e3950 < _e3719));
let _e3958 = global_3.member[bitcast<u32>(select(0i, _e3952, (_e3952 > 0i)))];
let _e3963 = (bitcast<f32>(((_e3931 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3971 = (_e3963 + (((bitcast<f32>(((_e3940 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3963) * _e3717));
let _e3976 = (bitcast<f32>(((_e3949 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4000 = (bitcast<f32>((((_e3931 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4008 = (_e4000 + (((bitcast<f32>((((_e3940 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4000) * _e3717));
let _e4013 = (bitcast<f32>((((_e3949 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4025 = (_e3713 + 3i);
let _e4027 = select(_e3719, _e4025, (_e4025 < _e3719));
let _e4033 = global_3.member[bitcast<u32>(select(0i, _e4027, (_e4027 > 0i)))];
let _e4034 = (_e3713 + 7i);
let _e4036 = select(_e3719, _e4034, (_e4034 < _e3719));
let _e4042 = global_3.member[bitcast<u32>(select(0i, _e4036, (_e4036 > 0i)))];
let _e4043 = (_e3713 + 1027i);
let _e4045 = select(_e3719, _e4043, (_e4043 < _e3719));
let _e4051 = global_3.member[bitcast<u32>(select(0i, _e4045, (_e4045 > 0i)))];
let _e4052 = (_e3713 + 1031i);
let _e4054 = select(_e3719, _e4052, (_e4052 < _e3719));
let _e4060 = global_3.member[bitcast<u32>(select(0i, _e4054, (_e4054 > 0i)))];
let _e4065 = (bitcast<f32>(((_e4033 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4073 = (_e4065 + (((bitcast<f32>(((_e4042 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4065) * _e3717));
let _e4078 = (bitcast<f32>(((_e4051 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4093 = (_e3369 * _e3264.member_1);
let _e4095 = -(((_e3804 + (((_e3809 + (((bitcast<f32>((((_e3754 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3809) * _e3717)) - _e3804) * _e3715)) * _e4093));
let _e4097 = select(-87f, _e4095, (_e4095 > -87f));
let _e4099 = select(88f, _e4097, (_e4097 < 88f));
let _e4101 = ((_e4099 * 1.442695f) + 0.5f);
let _e4103 = select(-127f, _e4101, (_e4101 > -127f));
let _e4105 = select(128f, _e4103, (_e4103 < 128f));
let _e4112 = select(0i, select(select(i32(_e4105), i32(-2147483648), (_e4105 < -2147483600f)), 2147483647i, (_e4105 > 2147483500f)), (_e4105 == _e4105));
let _e4116 = (_e4112 - select(0i, 1i, (_e4105 < f32(_e4112))));
let _e4117 = f32(_e4116);
let _e4121 = ((_e4099 - (_e4117 * 0.6933594f)) - (_e4117 * -2.1219444e-4f));
let _e4143 = -(((_e3869 + (((_e3874 + (((bitcast<f32>(((_e3856 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3874) * _e3717)) - _e3869) * _e3715)) * _e4093));
let _e4145 = select(-87f, _e4143, (_e4143 > -87f));
let _e4147 = select(88f, _e4145, (_e4145 < 88f));
let _e4149 = ((_e4147 * 1.442695f) + 0.5f);
let _e4151 = select(-127f, _e4149, (_e4149 > -127f));
let _e4153 = select(128f, _e4151, (_e4151 < 128f));
let _e4160 = select(0i, select(select(i32(_e4153), i32(-2147483648), (_e4153 < -2147483600f)), 2147483647i, (_e4153 > 2147483500f)), (_e4153 == _e4153));
let _e4164 = (_e4160 - select(0i, 1i, (_e4153 < f32(_e4160))));
let _e4165 = f32(_e4164);
let _e4169 = ((_e4147 - (_e4165 * 0.6933594f)) - (_e4165 * -2.1219444e-4f));
let _e4191 = -(((_e3906 + (((_e3911 + (((bitcast<f32>((((_e3856 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3911) * _e3717)) - _e3906) * _e3715)) * _e4093));
let _e4193 = select(-87f, _e4191, (_e4191 > -87f));
let _e4195 = select(88f, _e4193, (_e4193 < 88f));
let _e4197 = ((_e4195 * 1.442695f) + 0.5f);
let _e4199 = select(-127f, _e4197, (_e4197 > -127f));
let _e4201 = select(128f, _e4199, (_e4199 < 128f));
let _e4208 = select(0i, select(select(i32(_e4201), i32(-2147483648), (_e4201 < -2147483600f)), 2147483647i, (_e4201 > 2147483500f)), (_e4201 == _e4201));
let _e4212 = (_e4208 - select(0i, 1i, (_e4201 < f32(_e4208))));
let _e4213 = f32(_e4212);
let _e4217 = ((_e4195 - (_e4213 * 0.6933594f)) - (_e4213 * -2.1219444e-4f));
let _e4240 = -((_e3783 * (_e3369 * _e3264.member)));
let _e4242 = select(-87f, _e4240, (_e4240 > -87f));
let _e4244 = select(88f, _e4242, (_e4242 < 88f));
let _e4246 = ((_e4244 * 1.442695f) + 0.5f);
let _e4248 = select(-127f, _e4246, (_e4246 > -127f));
let _e4250 = select(128f, _e4248, (_e4248 < 128f));
let _e4257 = select(0i, select(select(i32(_e4250), i32(-2147483648), (_e4250 < -2147483600f)), 2147483647i, (_e4250 > 2147483500f)), (_e4250 == _e4250));
let _e4261 = (_e4257 - select(0i, 1i, (_e4250 < f32(_e4257))));
let _e4262 = f32(_e4261);
let _e4266 = ((_e4244 - (_e4262 * 0.6933594f)) - (_e4262 * -2.1219444e-4f));
let _e4286 = ((1f + (_e4266 * (1f + (_e4266 * (0.5f + (_e4266 * (0.16666667f + (_e4266 * (0.041666668f + (_e4266 * (0.008333334f + (_e4266 * (0.001388889f + (_e4266 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4261 + 127i)) << bitcast<u32>(23i))));
let _e4287 = (1f - _e4286);
let _e4290 = (_e4287 / select(1e-12f, _e3783, (_e3783 > 1e-12f)));
phi_6893_ = type_31(_e4286, _e4287, vec3<f32>(((1f + (_e4121 * (1f + (_e4121 * (0.5f + (_e4121 * (0.16666667f + (_e4121 * (0.041666668f + (_e4121 * (0.008333334f + (_e4121 * (0.001388889f + (_e4121 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4116 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e4169 * (1f + (_e4169 * (0.5f + (_e4169 * (0.16666667f + (_e4169 * (0.041666668f + (_e4169 * (0.008333334f + (_e4169 * (0.001388889f + (_e4169 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4164 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e4217 * (1f + (_e4217 * (0.5f + (_e4217 * (0.16666667f + (_e4217 * (0.041666668f + (_e4217 * (0.008333334f + (_e4217 * (0.001388889f + (_e4217 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4212 + 127i)) << bitcast<u32>(23i))))), vec3<f32>(((_e3971 + (((_e3976 + (((bitcast<f32>(((_e3958 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3976) * _e3717)) - _e3971) * _e3715)) * _e4290), ((_e4008 + (((_e4013 + (((bitcast<f32>((((_e3958 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4013) * _e3717)) - _e4008) * _e3715)) * _e4290), ((_e4073 + (((_e4078 + (((bitcast<f32>(((_e4060 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4078) * _e3717)) - _e4073) * _e3715)) * _e4290)));
}
let _e4297 = phi_6893_;
let _e4298 = select(0f, _e3051, _e444);
let _e4302 = (_e379 + (_e3351 * _e4298));
let _e4303 = (_e382 + (_e3352 * _e4298));
let _e4304 = (_e373 + (_e3353 * _e4298));
if (_e731.member_2 == 3u) {
let _e4310 = global_5.member[_e354].member_9.member_1;
let _e4319 = global_5.member[_e354].member_9.member;
phi_7876_ = type_25(vec3<f32>(_e4310.member, _e4310.member_1, _e4310.member_2), vec3<f32>(_e4319.member, _e4319.member_1, _e4319.member_2));
} else {
let _e4329 = global_5.member[_e354].member_8.member_8;
let _e4330 = (_e4304 - _e4329);
let _e4335 = global_5.member[_e354].member_8.member_2;
let _e4340 = global_5.member[_e354].member_8.member_6;
let _e4348 = global_5.member[_e354].member_8.member_5;
let _e4350 = (((_e4302 - (_e4335 + (_e4340 * _e4330))) * _e4348) - 0.5f);
let _e4355 = global_5.member[_e354].member_8.member_3;
let _e4360 = global_5.member[_e354].member_8.member_7;
let _e4365 = (((_e4303 - (_e4355 + (_e4360 * _e4330))) * _e4348) - 0.5f);
let _e4370 = global_5.member[_e354].member_8.member;
let _e4371 = bitcast<i32>(_e4370);
let _e4373 = (f32(_e4371) - 1f);
let _e4378 = global_5.member[_e354].member_8.member_1;
let _e4381 = (f32(bitcast<i32>(_e4378)) - 1f);
let _e4383 = select(0f, _e4350, (_e4350 > 0f));
let _e4385 = select(_e4373, _e4383, (_e4383 < _e4373));
let _e4392 = select(0i, select(select(i32(_e4385), i32(-2147483648), (_e4385 < -2147483600f)), 2147483647i, (_e4385 > 2147483500f)), (_e4385 == _e4385));
let _e4396 = (_e4392 - select(0i, 1i, (_e4385 < f32(_e4392))));
let _e4398 = select(0f, _e4365, (_e4365 > 0f));
let _e4400 = select(_e4381, _e4398, (_e4398 < _e4381));
let _e4407 = select(0i, select(select(i32(_e4400), i32(-2147483648), (_e4400 < -2147483600f)), 2147483647i, (_e4400 > 2147483500f)), (_e4400 == _e4400));
let _e4411 = (_e4407 - select(0i, 1i, (_e4400 < f32(_e4407))));
let _e4415 = (_e4350 - f32(_e4396));
let _e4417 = (_e4365 - f32(_e4411));
let _e4424 = ((((_e4350 >= 0f) && (_e4350 <= _e4373)) && (_e4365 >= 0f)) && (_e4365 <= _e4381));
let _e4428 = global_5.member[_e354].member_4;
let _e4429 = bitcast<i32>(_e4428);
let _e4431 = bitcast<i32>((_e4370 * _e4378));
let _e4433 = (_e4429 + (3i * _e4431));
local_1 = (_e4433 + ((_e4411 * _e4371) + _e4396));
let _e4435 = local_1;
let _e4437 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e4439 = select(_e4437, _e4435, (_e4435 < _e4437));
let _e4444 = global_6.member[bitcast<u32>(select(0i, _e4439, (_e4439 > 0i)))];
let _e4445 = bitcast<u32>(_e4444);
let _e4449 = f32((bitcast<i32>((_e4445 & 65535u)) - 32768i));
let _e4455 = f32((bitcast<i32>(((_e4445 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4460 = select(_e4455, -(_e4455), ((_e4445 >> bitcast<u32>(31i)) != 0u));
let _e4461 = local_1;
let _e4462 = (_e4461 + 1i);
let _e4464 = select(_e4437, _e4462, (_e4462 < _e4437));
let _e4469 = global_6.member[bitcast<u32>(select(0i, _e4464, (_e4464 > 0i)))];
let _e4470 = bitcast<u32>(_e4469);
let _e4480 = f32((bitcast<i32>(((_e4470 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4486 = local_1;
let _e4487 = (_e4486 + _e4371);
let _e4489 = select(_e4437, _e4487, (_e4487 < _e4437));
let _e4494 = global_6.member[bitcast<u32>(select(0i, _e4489, (_e4489 > 0i)))];
let _e4495 = bitcast<u32>(_e4494);
let _e4499 = f32((bitcast<i32>((_e4495 & 65535u)) - 32768i));
let _e4505 = f32((bitcast<i32>(((_e4495 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4510 = select(_e4505, -(_e4505), ((_e4495 >> bitcast<u32>(31i)) != 0u));
let _e4511 = (_e4371 + 1i);
let _e4512 = local_1;
let _e4513 = (_e4512 + _e4511);
let _e4515 = select(_e4437, _e4513, (_e4513 < _e4437));
let _e4520 = global_6.member[bitcast<u32>(select(0i, _e4515, (_e4515 > 0i)))];
let _e4521 = bitcast<u32>(_e4520);
let _e4531 = f32((bitcast<i32>(((_e4521 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4539 = (_e4449 + ((f32((bitcast<i32>((_e4470 & 65535u)) - 32768i)) - _e4449) * _e4415));
let _e4548 = (_e4460 + ((select(_e4480, -(_e4480), ((_e4470 >> bitcast<u32>(31i)) != 0u)) - _e4460) * _e4415));
let _e4561 = global_5.member[_e354].member_9.member;
let _e4564 = (1f / 16255f);
let _e4566 = (_e4561.member + (select(0f, (_e4539 + (((_e4499 + ((f32((bitcast<i32>((_e4521 & 65535u)) - 32768i)) - _e4499) * _e4415)) - _e4539) * _e4417)), _e4424) * _e4564));
let _e4568 = (_e4561.member_1 + (select(0f, (_e4548 + (((_e4510 + ((select(_e4531, -(_e4531), ((_e4521 >> bitcast<u32>(31i)) != 0u)) - _e4510) * _e4415)) - _e4548) * _e4417)), _e4424) * _e4564));
let _e4572 = (1f - ((_e4566 * _e4566) + (_e4568 * _e4568)));
let _e4574 = select(1e-4f, _e4572, (_e4572 > 1e-4f));
let _e4577 = sqrt(select(0f, _e4574, (_e4574 > 0f)));
let _e4581 = (1f / select(1e-6f, _e4577, (_e4577 > 1e-6f)));
let _e4582 = ((_e4304 - _e373) * _e4348);
let _e4589 = (_e4350 - (((_e4566 * _e4581) - _e4340) * _e4582));
let _e4590 = (_e4365 - (((_e4568 * _e4581) - _e4360) * _e4582));
let _e4592 = select(0f, _e4589, (_e4589 > 0f));
let _e4594 = select(_e4373, _e4592, (_e4592 < _e4373));
let _e4601 = select(0i, select(select(i32(_e4594), i32(-2147483648), (_e4594 < -2147483600f)), 2147483647i, (_e4594 > 2147483500f)), (_e4594 == _e4594));
let _e4605 = (_e4601 - select(0i, 1i, (_e4594 < f32(_e4601))));
let _e4607 = select(0f, _e4590, (_e4590 > 0f));
let _e4609 = select(_e4381, _e4607, (_e4607 < _e4381));
let _e4616 = select(0i, select(select(i32(_e4609), i32(-2147483648), (_e4609 < -2147483600f)), 2147483647i, (_e4609 > 2147483500f)), (_e4609 == _e4609));
let _e4620 = (_e4616 - select(0i, 1i, (_e4609 < f32(_e4616))));
let _e4622 = ((_e4620 * _e4371) + _e4605);
let _e4624 = (_e4589 - f32(_e4605));
let _e4626 = (_e4590 - f32(_e4620));
let _e4633 = ((((_e4589 >= 0f) && (_e4589 <= _e4373)) && (_e4590 >= 0f)) && (_e4590 <= _e4381));
let _e4634 = (_e4429 + _e4622);
let _e4636 = select(_e4437, _e4634, (_e4634 < _e4437));
let _e4642 = global_6.member[bitcast<u32>(select(0i, _e4636, (_e4636 > 0i)))];
let _e4643 = (_e4634 + 1i);
let _e4645 = select(_e4437, _e4643, (_e4643 < _e4437));
let _e4651 = global_6.member[bitcast<u32>(select(0i, _e4645, (_e4645 > 0i)))];
let _e4654 = (_e4642 + ((_e4651 - _e4642) * _e4624));
let _e4655 = (_e4634 + _e4371);
let _e4657 = select(_e4437, _e4655, (_e4655 < _e4437));
let _e4663 = global_6.member[bitcast<u32>(select(0i, _e4657, (_e4657 > 0i)))];
let _e4664 = (_e4655 + 1i);
let _e4666 = select(_e4437, _e4664, (_e4664 < _e4437));
let _e4672 = global_6.member[bitcast<u32>(select(0i, _e4666, (_e4666 > 0i)))];
let _e4679 = select(1f, (_e4654 + (((_e4663 + ((_e4672 - _e4663) * _e4624)) - _e4654) * _e4626)), _e4633);
if _e3370 {
phi_7646_ = vec3(_e4679);
} else {
let _e4682 = ((_e4429 + _e4431) + _e4622);
let _e4684 = select(_e4437, _e4682, (_e4682 < _e4437));
let _e4690 = global_6.member[bitcast<u32>(select(0i, _e4684, (_e4684 > 0i)))];
let _e4691 = (_e4682 + 1i);
let _e4693 = select(_e4437, _e4691, (_e4691 < _e4437));
let _e4699 = global_6.member[bitcast<u32>(select(0i, _e4693, (_e4693 > 0i)))];
let _e4702 = (_e4690 + ((_e4699 - _e4690) * _e4624));
let _e4703 = (_e4682 + _e4371);
let _e4705 = select(_e4437, _e4703, (_e4703 < _e4437));
let _e4711 = global_6.member[bitcast<u32>(select(0i, _e4705, (_e4705 > 0i)))];
let _e4712 = (_e4703 + 1i);
let _e4714 = select(_e4437, _e4712, (_e4712 < _e4437));
let _e4720 = global_6.member[bitcast<u32>(select(0i, _e4714, (_e4714 > 0i)))];
let _e4730 = ((_e4429 + (2i * _e4431)) + _e4622);
let _e4732 = select(_e4437, _e4730, (_e4730 < _e4437));
let _e4738 = global_6.member[bitcast<u32>(select(0i, _e4732, (_e4732 > 0i)))];
let _e4739 = (_e4730 + 1i);
let _e4741 = select(_e4437, _e4739, (_e4739 < _e4437));
let _e4747 = global_6.member[bitcast<u32>(select(0i, _e4741, (_e4741 > 0i)))];
let _e4750 = (_e4738 + ((_e4747 - _e4738) * _e4624));
let _e4751 = (_e4730 + _e4371);
let _e4753 = select(_e4437, _e4751, (_e4751 < _e4437));
let _e4759 = global_6.member[bitcast<u32>(select(0i, _e4753, (_e4753 > 0i)))];
let _e4760 = (_e4751 + 1i);
let _e4762 = select(_e4437, _e4760, (_e4760 < _e4437));
let _e4768 = global_6.member[bitcast<u32>(select(0i, _e4762, (_e4762 > 0i)))];
phi_7646_ = vec3<f32>(_e4679, select(1f, (_e4702 + (((_e4711 + ((_e4720 - _e4711) * _e4624)) - _e4702) * _e4626)), _e4633), select(1f, (_e4750 + (((_e4759 + ((_e4768 - _e4759) * _e4624)) - _e4750) * _e4626)), _e4633));
}
let _e4778 = phi_7646_;
local = (_e4433 + _e4622);
let _e4780 = local;
let _e4782 = select(_e4437, _e4780, (_e4780 < _e4437));
let _e4787 = global_6.member[bitcast<u32>(select(0i, _e4782, (_e4782 > 0i)))];
let _e4788 = bitcast<u32>(_e4787);
let _e4792 = f32((bitcast<i32>((_e4788 & 65535u)) - 32768i));
let _e4798 = f32((bitcast<i32>(((_e4788 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4803 = select(_e4798, -(_e4798), ((_e4788 >> bitcast<u32>(31i)) != 0u));
let _e4804 = local;
let _e4805 = (_e4804 + 1i);
let _e4807 = select(_e4437, _e4805, (_e4805 < _e4437));
let _e4812 = global_6.member[bitcast<u32>(select(0i, _e4807, (_e4807 > 0i)))];
let _e4813 = bitcast<u32>(_e4812);
let _e4823 = f32((bitcast<i32>(((_e4813 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4829 = local;
let _e4830 = (_e4829 + _e4371);
let _e4832 = select(_e4437, _e4830, (_e4830 < _e4437));
let _e4837 = global_6.member[bitcast<u32>(select(0i, _e4832, (_e4832 > 0i)))];
let _e4838 = bitcast<u32>(_e4837);
let _e4842 = f32((bitcast<i32>((_e4838 & 65535u)) - 32768i));
let _e4848 = f32((bitcast<i32>(((_e4838 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4853 = select(_e4848, -(_e4848), ((_e4838 >> bitcast<u32>(31i)) != 0u));
let _e4854 = local;
let _e4855 = (_e4854 + _e4511);
let _e4857 = select(_e4437, _e4855, (_e4855 < _e4437));
let _e4862 = global_6.member[bitcast<u32>(select(0i, _e4857, (_e4857 > 0i)))];
let _e4863 = bitcast<u32>(_e4862);
let _e4873 = f32((bitcast<i32>(((_e4863 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4881 = (_e4792 + ((f32((bitcast<i32>((_e4813 & 65535u)) - 32768i)) - _e4792) * _e4624));
let _e4890 = (_e4803 + ((select(_e4823, -(_e4823), ((_e4813 >> bitcast<u32>(31i)) != 0u)) - _e4803) * _e4624));
let _e4903 = global_5.member[_e354].member_9.member_1;
let _e4910 = (_e4561.member + (select(0f, (_e4881 + (((_e4842 + ((f32((bitcast<i32>((_e4863 & 65535u)) - 32768i)) - _e4842) * _e4624)) - _e4881) * _e4626)), _e4633) * _e4564));
let _e4912 = (_e4561.member_1 + (select(0f, (_e4890 + (((_e4853 + ((select(_e4873, -(_e4873), ((_e4863 >> bitcast<u32>(31i)) != 0u)) - _e4853) * _e4624)) - _e4890) * _e4626)), _e4633) * _e4564));
let _e4916 = (1f - ((_e4910 * _e4910) + (_e4912 * _e4912)));
let _e4918 = select(1e-4f, _e4916, (_e4916 > 1e-4f));
phi_7876_ = type_25((_e4778 * vec3<f32>(_e4903.member, _e4903.member_1, _e4903.member_2)), vec3<f32>(_e4910, _e4912, sqrt(select(0f, _e4918, (_e4918 > 0f)))));
}
let _e4925 = phi_7876_;
let _e4934 = (((_e4925.member_1.x * _e4925.member_1.x) + (_e4925.member_1.y * _e4925.member_1.y)) + (_e4925.member_1.z * _e4925.member_1.z));
let _e4937 = sqrt(select(0f, _e4934, (_e4934 > 0f)));
let _e4943 = (1e-6f * _e4937);
let _e4947 = select((_e4937 / select(_e4943, _e4925.member_1.z, (_e4925.member_1.z > _e4943))), 1f, ((_e687 & 8u) != 0u));
let _e4949 = (_e4925.member.x * _e4947);
let _e4951 = (_e4925.member.y * _e4947);
let _e4953 = (_e4925.member.z * _e4947);
if _e794 {
let _e4958 = global_5.member[_e354].member_19;
let _e4967 = (((_e2605.member_1.x * _e2605.member_1.x) + (_e2605.member_1.y * _e2605.member_1.y)) + (_e2605.member_1.z * _e2605.member_1.z));
let _e4970 = sqrt(select(0f, _e4967, (_e4967 > 0f)));
let _e4973 = (1f / select(1e-20f, _e4970, (_e4970 > 1e-20f)));
let _e4974 = (_e2605.member_1.x * _e4973);
let _e4975 = (_e2605.member_1.y * _e4973);
let _e4976 = (_e2605.member_1.z * _e4973);
let _e4979 = (-1f / select(1e-20f, _e4937, (_e4937 > 1e-20f)));
let _e4980 = (_e4925.member_1.x * _e4979);
let _e4981 = (_e4925.member_1.y * _e4979);
let _e4982 = (_e4925.member_1.z * _e4979);
let _e4987 = (((_e358[2] * _e358[2]) + (_e358[3] * _e358[3])) + (_e358[4] * _e358[4]));
let _e4990 = sqrt(select(0f, _e4987, (_e4987 > 0f)));
let _e4993 = (-1f / select(1e-20f, _e4990, (_e4990 > 1e-20f)));
let _e4994 = (_e358[2] * _e4993);
let _e4995 = (_e358[3] * _e4993);
let _e4996 = (_e358[4] * _e4993);
let _e5003 = select(1f, -1f, ((((_e4974 * _e4994) + (_e4975 * _e4995)) + (_e4976 * _e4996)) < 0f));
let _e5004 = (_e4974 * _e5003);
let _e5005 = (_e4975 * _e5003);
let _e5006 = (_e4976 * _e5003);
let _e5011 = (((_e5004 * _e4994) + (_e5005 * _e4995)) + (_e5006 * _e4996));
let _e5013 = select(1e-4f, _e5011, (_e5011 > 1e-4f));
let _e5018 = (((_e5004 * _e4980) + (_e5005 * _e4981)) + (_e5006 * _e4982));
let _e5019 = (_e4980 + _e4994);
let _e5020 = (_e4981 + _e4995);
let _e5021 = (_e4982 + _e4996);
let _e5026 = (((_e5019 * _e5019) + (_e5020 * _e5020)) + (_e5021 * _e5021));
let _e5029 = sqrt(select(0f, _e5026, (_e5026 > 0f)));
let _e5032 = (1f / select(1e-6f, _e5029, (_e5029 > 1e-6f)));
let _e5033 = (_e5019 * _e5032);
let _e5034 = (_e5020 * _e5032);
let _e5035 = (_e5021 * _e5032);
let _e5040 = (((_e5004 * _e5033) + (_e5005 * _e5034)) + (_e5006 * _e5035));
let _e5042 = select(0f, _e5040, (_e5040 > 0f));
let _e5047 = (((_e4994 * _e5033) + (_e4995 * _e5034)) + (_e4996 * _e5035));
let _e5049 = select(0f, _e5047, (_e5047 > 0f));
let _e5050 = (_e4958 * _e4958);
let _e5051 = (_e5050 * _e5050);
let _e5055 = (((_e5042 * _e5042) * (_e5051 - 1f)) + 1f);
let _e5059 = (_e5018 > 0f);
let _e5060 = select(0f, _e5018, _e5059);
let _e5062 = (1f - _e5051);
let _e5064 = (((_e5060 * _e5060) * _e5062) + _e5051);
let _e5071 = (((_e5013 * _e5013) * _e5062) + _e5051);
let _e5076 = ((_e5013 * sqrt(select(0f, _e5064, (_e5064 > 0f)))) + (_e5060 * sqrt(select(0f, _e5071, (_e5071 > 0f)))));
let _e5081 = (_e2605.member_2 / _e3048);
let _e5085 = (((_e5081 * _e5081) - 1f) + (_e5049 * _e5049));
let _e5088 = sqrt(select(0f, _e5085, (_e5085 > 0f)));
let _e5089 = (_e5088 - _e5049);
let _e5090 = (_e5088 + _e5049);
let _e5093 = (_e5089 / select(1e-6f, _e5090, (_e5090 > 1e-6f)));
let _e5097 = ((_e5049 * _e5089) + 1f);
let _e5100 = (((_e5049 * _e5090) - 1f) / select(1e-6f, _e5097, (_e5097 > 1e-6f)));
let _e5118 = global_5.member[_e354].member_20;
let _e5122 = ((select(0f, ((((_e5051 / ((3.1415927f * _e5055) * _e5055)) * (0.5f / select(1e-6f, _e5076, (_e5076 > 1e-6f)))) * select(select((((0.5f * _e5093) * _e5093) * (1f + (_e5100 * _e5100))), 1f, (_e5085 <= 0f)), 0f, (_e3048 == _e2605.member_2))) * _e5060), (_e5059 && (_e4970 > 1e-12f))) * _e5118) * select(_e3264.member_2, 0f, _e444));
phi_8194_ = vec3<f32>((_e4949 * _e5122), (_e4951 * _e5122), (_e4953 * _e5122));
} else {
phi_8194_ = vec3<f32>(0f, 0f, 0f);
}
let _e5128 = phi_8194_;
let _e5139 = global_5.member[_e354].member_18;
let _e5146 = (1f - _e358[11]);
let _e5166 = (_e358[8] + ((_e358[12] * ((_e4297.member_3.x * (_e4949 + _e5139.member)) + _e5128.x)) * _e5146));
let _e5167 = (_e358[9] + ((_e358[13] * ((_e4297.member_3.y * (_e4951 + _e5139.member_1)) + _e5128.y)) * _e5146));
let _e5168 = (_e358[10] + ((_e358[14] * ((_e4297.member_3.z * (_e4953 + _e5139.member_2)) + _e5128.z)) * _e5146));
let _e5171 = (_e358[11] + (_e5146 * _e4297.member_1));
let _e5174 = (_e358[12] * _e4297.member_2.x);
let _e5176 = (_e358[13] * _e4297.member_2.y);
let _e5178 = (_e358[14] * _e4297.member_2.z);
let _e5184 = (_e358[7] + ((_e5171 - _e358[11]) * (_e373 + (_e3353 * 0.5f))));
let _e5193 = (-((((select(_e764.member, _e751.member, _e744) * _e4925.member_1.x) + (select(_e764.member_1, _e751.member_1, _e744) * _e4925.member_1.y)) + (select(_e764.member_2, _e751.member_2, _e744) * _e4925.member_1.z))) / select(1e-20f, _e4937, (_e4937 > 1e-20f)));
let _e5198 = bitcast<f32>((bitcast<u32>(select(0f, _e5193, (_e5193 > 0f))) & 2147483647u));
let _e5208 = (1f - _e5171);
let _e5221 = select(_e5171, 1f, _e444);
if _e794 {
let _e5230 = global_5.member[_e354].member_5.member_4;
let _e5233 = (_e2605.member_3.x * _e3264.member_2);
let _e5235 = (_e2605.member_3.y * _e3264.member_2);
let _e5237 = (_e2605.member_3.z * _e3264.member_2);
let _e5238 = (0.5f * _e368);
let _e5242 = (_e358[2] + (_e5233 * _e5238));
let _e5243 = (_e358[3] + (_e5235 * _e5238));
let _e5244 = (_e358[4] + (_e5237 * _e5238));
let _e5246 = (2f * _e367);
let _e5248 = ((_e5244 * _e5244) + (_e5246 * _e5237));
let _e5252 = (_e5244 + sqrt(select(0f, _e5248, (_e5248 > 0f))));
let _e5256 = (0.5f * (_e5246 / select(1e-6f, _e5252, (_e5252 > 1e-6f))));
let _e5260 = (_e5242 + (_e5233 * _e5256));
let _e5261 = (_e5243 + (_e5235 * _e5256));
let _e5262 = (_e5244 + (_e5237 * _e5256));
let _e5266 = (_e5230 * _e5230);
let _e5268 = (_e5262 * _e5262);
let _e5276 = (((_e5244 <= 0f) || (_e5248 <= 0f)) || ((_e5262 <= 0f) || (_e5268 <= (_e5266 * (((_e5260 * _e5260) + (_e5261 * _e5261)) + _e5268)))));
let _e5290 = (_e358[2] + ((_e2605.member_4.x * _e3264.member_2) * _e367));
let _e5291 = (_e358[3] + ((_e2605.member_4.y * _e3264.member_2) * _e367));
let _e5292 = (_e358[4] + ((_e2605.member_4.z * _e3264.member_2) * _e367));
let _e5294 = (_e5292 * _e5292);
let _e5303 = ((_e687 & 1u) != 0u);
phi_8503_ = select(select(_e5262, _e5244, _e5276), _e5292, _e5303);
phi_8504_ = select(select(_e5261, _e5243, _e5276), _e5291, _e5303);
phi_8505_ = select(select(_e5260, _e5242, _e5276), _e5290, _e5303);
phi_8506_ = select(_e5276, ((_e5292 <= 0f) || (_e5294 <= (_e5266 * (((_e5290 * _e5290) + (_e5291 * _e5291)) + _e5294)))), _e5303);
} else {
phi_8503_ = _e358[4];
phi_8504_ = _e358[3];
phi_8505_ = _e358[2];
phi_8506_ = false;
}
let _e5309 = phi_8503_;
let _e5311 = phi_8504_;
let _e5313 = phi_8505_;
let _e5315 = phi_8506_;
let _e5321 = (((_e444 || (_e5313 != _e358[2])) || (_e5311 != _e358[3])) || (_e5309 != _e358[4]));
let _e5323 = select(_e5176, _e5174, (_e5174 > _e5176));
phi_8566_ = array<f32, 18>(select(_e358[0], select(_e384, _e4302, _e444), _e5321), select(_e358[1], select(_e386, _e4303, _e444), _e5321), _e5313, _e5311, _e5309, _e2605.member, select(select(0f, 2f, _e5315), 1f, (_e444 || (((1f - _e5221) * select(_e5178, _e5323, (_e5323 > _e5178))) < 9.765625e-4f))), select(_e5184, (_e5184 + (_e5208 * _e4304)), _e444), select(_e5166, (_e5166 + ((_e5174 * (select(_e770.member, _e757.member, _e744) * ((_e4949 * _e5198) + _e5139.member))) * _e5208)), _e444), select(_e5167, (_e5167 + ((_e5176 * (select(_e770.member_1, _e757.member_1, _e744) * ((_e4951 * _e5198) + _e5139.member_1))) * _e5208)), _e444), select(_e5168, (_e5168 + ((_e5178 * (select(_e770.member_2, _e757.member_2, _e744) * ((_e4953 * _e5198) + _e5139.member_2))) * _e5208)), _e444), _e5221, _e5174, _e5176, _e5178, _e2605.member_2, select(_e358[16], select(_e391, _e4304, _e444), _e5321), _e391);
} else {
phi_8566_ = _e358;
}
let _e5342 = phi_8566_;
phi_585_ = (_e354 + 1u);
phi_588_ = select(_e356, true, _e727);
phi_590_ = _e5342;
} else {
phi_585_ = u32();
phi_588_ = bool();
phi_590_ = array<f32, 18>();
}
let _e5346 = phi_585_;
let _e5348 = phi_588_;
let _e5350 = phi_590_;
continue;
continuing {
phi_584_ = _e5346;
phi_587_ = _e5348;
phi_589_ = _e5350;
phi_8649_ = false;
break if !(_e359);
}
}
let _e5353 = phi_8649_;
if _e5353 {
break;
}
let _e5355 = local_8;
if _e5355 {
let _e5357 = local_9;
global_4.member[_e154] = _e5357[0];
let _e5362 = local_10;
global_4.member[_e166] = _e5362[1];
let _e5367 = local_11;
global_4.member[_e177] = _e5367[2];
let _e5372 = local_12;
global_4.member[_e188] = _e5372[3];
let _e5377 = local_13;
global_4.member[_e199] = _e5377[4];
let _e5382 = local_14;
global_4.member[_e210] = _e5382[5];
let _e5387 = local_15;
global_4.member[_e221] = _e5387[6];
let _e5392 = local_16;
global_4.member[_e232] = _e5392[7];
let _e5397 = local_17;
global_4.member[_e243] = _e5397[8];
let _e5402 = local_18;
global_4.member[_e254] = _e5402[9];
let _e5407 = local_19;
global_4.member[_e265] = _e5407[10];
let _e5412 = local_20;
global_4.member[_e276] = _e5412[11];
let _e5417 = local_21;
global_4.member[_e287] = _e5417[12];
let _e5422 = local_22;
global_4.member[_e298] = _e5422[13];
let _e5427 = local_23;
global_4.member[_e309] = _e5427[14];
let _e5432 = local_24;
global_4.member[_e320] = _e5432[15];
let _e5437 = local_25;
global_4.member[_e331] = _e5437[16];
let _e5442 = local_26;
global_4.member[_e342] = _e5442[17];
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
