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
var phi_589_: u32;
var phi_592_: bool;
var phi_594_: array<f32, 18>;
var phi_4916_: type_29;
var phi_5525_: type_30;
var phi_6527_: f32;
var phi_6916_: type_5;
var phi_8474_: type_31;
var phi_9227_: vec3<f32>;
var phi_9457_: type_25;
var phi_9775_: vec3<f32>;
var phi_10080_: vec3<f32>;
var phi_10081_: bool;
var phi_10146_: array<f32, 18>;
var phi_590_: u32;
var phi_593_: bool;
var phi_595_: array<f32, 18>;
var phi_10229_: bool;
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
phi_589_ = 0u;
phi_592_ = false;
phi_594_ = array<f32, 18>(_e171, _e181, _e192, _e203, _e214, _e225, _e236, _e247, _e258, _e269, _e280, _e291, _e302, _e313, _e324, _e335, _e346, _e357);
loop {
let _e360 = phi_589_;
let _e362 = phi_592_;
let _e364 = phi_594_;
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
phi_10229_ = true;
break;
}
let _e378 = global_5.member[_e360].member_5.member_2;
let _e379 = (_e378 / _e364[5]);
let _e384 = global_5.member[_e360].member_5.member;
let _e386 = ((_e384 - _e364[2]) / _e364[5]);
let _e388 = (_e364[0] + (_e364[3] * _e386));
let _e390 = (_e364[1] + (_e364[4] * _e386));
let _e392 = (_e388 + (_e364[3] * _e379));
let _e394 = (_e390 + (_e364[4] * _e379));
let _e399 = global_5.member[_e360].member_5.member_1;
let _e405 = global_5.member[_e360].member_13.member.member;
let _e416 = ((((_e405.member.member * _e388) + (_e405.member.member_1 * _e390)) + (_e405.member.member_2 * _e384)) + _e405.member_1);
let _e422 = ((((_e405.member.member * _e392) + (_e405.member.member_1 * _e394)) + (_e405.member.member_2 * _e399)) + _e405.member_1);
let _e425 = ((_e416 > 0f) && (_e422 <= 0f));
let _e431 = global_5.member[_e360].member_13.member_1.member;
let _e442 = ((((_e431.member.member * _e388) + (_e431.member.member_1 * _e390)) + (_e431.member.member_2 * _e384)) + _e431.member_1);
let _e448 = ((((_e431.member.member * _e392) + (_e431.member.member_1 * _e394)) + (_e431.member.member_2 * _e399)) + _e431.member_1);
let _e451 = ((_e442 > 0f) && (_e448 <= 0f));
let _e452 = (_e425 || _e451);
let _e457 = global_5.member[_e360].member_6.member;
let _e468 = ((((_e457.member.member * _e388) + (_e457.member.member_1 * _e390)) + (_e457.member.member_2 * _e384)) + _e457.member_1);
let _e473 = global_5.member[_e360].member_6.member_1;
let _e484 = ((((_e473.member.member * _e388) + (_e473.member.member_1 * _e390)) + (_e473.member.member_2 * _e384)) + _e473.member_1);
let _e489 = global_5.member[_e360].member_6.member_2;
let _e500 = ((((_e489.member.member * _e388) + (_e489.member.member_1 * _e390)) + (_e489.member.member_2 * _e384)) + _e489.member_1);
let _e506 = ((((_e457.member.member * _e392) + (_e457.member.member_1 * _e394)) + (_e457.member.member_2 * _e399)) + _e457.member_1);
let _e512 = ((((_e473.member.member * _e392) + (_e473.member.member_1 * _e394)) + (_e473.member.member_2 * _e399)) + _e473.member_1);
let _e518 = ((((_e489.member.member * _e392) + (_e489.member.member_1 * _e394)) + (_e489.member.member_2 * _e399)) + _e489.member_1);
let _e523 = global_5.member[_e360].member_6.member_4;
let _e529 = global_5.member[_e360].member_6.member_3.member;
let _e530 = (_e529 - 0.5f);
let _e532 = select(-0.5f, _e506, (_e506 > -0.5f));
let _e534 = select(_e530, _e532, (_e532 < _e530));
let _e540 = global_5.member[_e360].member_6.member_3.member_1;
let _e541 = (_e540 - 0.5f);
let _e543 = select(-0.5f, _e512, (_e512 > -0.5f));
let _e545 = select(_e541, _e543, (_e543 < _e541));
let _e551 = global_5.member[_e360].member_6.member_3.member_2;
let _e552 = (_e551 - 0.5f);
let _e554 = select(-0.5f, _e518, (_e518 > -0.5f));
let _e556 = select(_e552, _e554, (_e554 < _e552));
let _e557 = (_e506 - _e468);
let _e558 = (_e512 - _e484);
let _e559 = (_e518 - _e500);
let _e562 = bitcast<f32>((bitcast<u32>(_e557) & 2147483647u));
let _e565 = bitcast<f32>((bitcast<u32>(_e558) & 2147483647u));
let _e567 = select(_e565, _e562, (_e562 > _e565));
let _e570 = bitcast<f32>((bitcast<u32>(_e559) & 2147483647u));
let _e579 = bitcast<f32>((bitcast<u32>((_e506 - _e534)) & 2147483647u));
let _e582 = bitcast<f32>((bitcast<u32>((_e512 - _e545)) & 2147483647u));
let _e584 = select(_e582, _e579, (_e579 > _e582));
let _e587 = bitcast<f32>((bitcast<u32>((_e518 - _e556)) & 2147483647u));
let _e591 = (_e534 + 0.5f);
let _e592 = (_e529 - 1f);
let _e594 = select(0f, _e591, (_e591 > 0f));
let _e596 = select(_e592, _e594, (_e594 < _e592));
let _e603 = select(0i, select(select(i32(_e596), i32(-2147483648), (_e596 < -2147483600f)), 2147483647i, (_e596 > 2147483500f)), (_e596 == _e596));
let _e612 = global_5.member[_e360].member_6.member_12;
let _e613 = (_e612 & 31u);
let _e616 = (_e545 + 0.5f);
let _e617 = (_e540 - 1f);
let _e619 = select(0f, _e616, (_e616 > 0f));
let _e621 = select(_e617, _e619, (_e619 < _e617));
let _e628 = select(0i, select(select(i32(_e621), i32(-2147483648), (_e621 < -2147483600f)), 2147483647i, (_e621 > 2147483500f)), (_e621 == _e621));
let _e635 = (_e556 + 0.5f);
let _e636 = (_e551 - 1f);
let _e638 = select(0f, _e635, (_e635 > 0f));
let _e640 = select(_e636, _e638, (_e638 < _e636));
let _e647 = select(0i, select(select(i32(_e640), i32(-2147483648), (_e640 < -2147483600f)), 2147483647i, (_e640 > 2147483500f)), (_e640 == _e640));
let _e659 = global_5.member[_e360].member_6.member_9.member;
let _e666 = global_5.member[_e360].member_6.member_9.member_1;
let _e672 = global_5.member[_e360].member_6.member_10;
let _e678 = ((bitcast<i32>(_e672) + ((_e603 - select(0i, 1i, (_e596 < f32(_e603)))) >> bitcast<u32>(_e613))) + (bitcast<i32>(_e659) * (((_e628 - select(0i, 1i, (_e621 < f32(_e628)))) >> bitcast<u32>(_e613)) + (bitcast<i32>(_e666) * ((_e647 - select(0i, 1i, (_e640 < f32(_e647)))) >> bitcast<u32>(_e613))))));
let _e680 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e682 = select(_e680, _e678, (_e678 < _e680));
let _e688 = global_2.member[bitcast<u32>(select(0i, _e682, (_e682 > 0i)))];
let _e696 = global_5.member[_e360].member_7.member;
let _e707 = ((((_e696.member.member * _e388) + (_e696.member.member_1 * _e390)) + (_e696.member.member_2 * _e384)) + _e696.member_1);
let _e712 = global_5.member[_e360].member_7.member_1;
let _e723 = ((((_e712.member.member * _e388) + (_e712.member.member_1 * _e390)) + (_e712.member.member_2 * _e384)) + _e712.member_1);
let _e728 = global_5.member[_e360].member_7.member_2;
let _e739 = ((((_e728.member.member * _e388) + (_e728.member.member_1 * _e390)) + (_e728.member.member_2 * _e384)) + _e728.member_1);
let _e745 = ((((_e696.member.member * _e392) + (_e696.member.member_1 * _e394)) + (_e696.member.member_2 * _e399)) + _e696.member_1);
let _e751 = ((((_e712.member.member * _e392) + (_e712.member.member_1 * _e394)) + (_e712.member.member_2 * _e399)) + _e712.member_1);
let _e757 = ((((_e728.member.member * _e392) + (_e728.member.member_1 * _e394)) + (_e728.member.member_2 * _e399)) + _e728.member_1);
let _e762 = global_5.member[_e360].member_7.member_4;
let _e768 = global_5.member[_e360].member_7.member_3.member;
let _e769 = (_e768 - 0.5f);
let _e771 = select(-0.5f, _e745, (_e745 > -0.5f));
let _e773 = select(_e769, _e771, (_e771 < _e769));
let _e779 = global_5.member[_e360].member_7.member_3.member_1;
let _e780 = (_e779 - 0.5f);
let _e782 = select(-0.5f, _e751, (_e751 > -0.5f));
let _e784 = select(_e780, _e782, (_e782 < _e780));
let _e790 = global_5.member[_e360].member_7.member_3.member_2;
let _e791 = (_e790 - 0.5f);
let _e793 = select(-0.5f, _e757, (_e757 > -0.5f));
let _e795 = select(_e791, _e793, (_e793 < _e791));
let _e801 = bitcast<f32>((bitcast<u32>((_e745 - _e707)) & 2147483647u));
let _e804 = bitcast<f32>((bitcast<u32>((_e751 - _e723)) & 2147483647u));
let _e806 = select(_e804, _e801, (_e801 > _e804));
let _e809 = bitcast<f32>((bitcast<u32>((_e757 - _e739)) & 2147483647u));
let _e818 = bitcast<f32>((bitcast<u32>((_e745 - _e773)) & 2147483647u));
let _e821 = bitcast<f32>((bitcast<u32>((_e751 - _e784)) & 2147483647u));
let _e823 = select(_e821, _e818, (_e818 > _e821));
let _e826 = bitcast<f32>((bitcast<u32>((_e757 - _e795)) & 2147483647u));
let _e830 = (_e773 + 0.5f);
let _e831 = (_e768 - 1f);
let _e833 = select(0f, _e830, (_e830 > 0f));
let _e835 = select(_e831, _e833, (_e833 < _e831));
let _e842 = select(0i, select(select(i32(_e835), i32(-2147483648), (_e835 < -2147483600f)), 2147483647i, (_e835 > 2147483500f)), (_e835 == _e835));
let _e851 = global_5.member[_e360].member_7.member_12;
let _e852 = (_e851 & 31u);
let _e855 = (_e784 + 0.5f);
let _e856 = (_e779 - 1f);
let _e858 = select(0f, _e855, (_e855 > 0f));
let _e860 = select(_e856, _e858, (_e858 < _e856));
let _e867 = select(0i, select(select(i32(_e860), i32(-2147483648), (_e860 < -2147483600f)), 2147483647i, (_e860 > 2147483500f)), (_e860 == _e860));
let _e874 = (_e795 + 0.5f);
let _e875 = (_e790 - 1f);
let _e877 = select(0f, _e874, (_e874 > 0f));
let _e879 = select(_e875, _e877, (_e877 < _e875));
let _e886 = select(0i, select(select(i32(_e879), i32(-2147483648), (_e879 < -2147483600f)), 2147483647i, (_e879 > 2147483500f)), (_e879 == _e879));
let _e898 = global_5.member[_e360].member_7.member_9.member;
let _e905 = global_5.member[_e360].member_7.member_9.member_1;
let _e911 = global_5.member[_e360].member_7.member_10;
let _e917 = ((bitcast<i32>(_e911) + ((_e842 - select(0i, 1i, (_e835 < f32(_e842)))) >> bitcast<u32>(_e852))) + (bitcast<i32>(_e898) * (((_e867 - select(0i, 1i, (_e860 < f32(_e867)))) >> bitcast<u32>(_e852)) + (bitcast<i32>(_e905) * ((_e886 - select(0i, 1i, (_e879 < f32(_e886)))) >> bitcast<u32>(_e852))))));
let _e919 = select(_e680, _e917, (_e917 < _e680));
let _e925 = global_2.member[bitcast<u32>(select(0i, _e919, (_e919 > 0i)))];
let _e932 = global_5.member[_e360].member_1;
let _e964 = (_e364[17] != _e384);
let _e970 = (select(0u, select(select(select(select(7u, 3u, (((((((_e468 >= 0f) && (_e468 <= _e592)) && (_e484 >= 0f)) && (_e484 <= _e617)) && (_e500 >= 0f)) && (_e500 <= _e636)) && ((((((_e506 >= 0f) && (_e506 <= _e592)) && (_e512 >= 0f)) && (_e512 <= _e617)) && (_e518 >= 0f)) && (_e518 <= _e636)))), 15u, _e964), 1u, (((_e932 & 64u) != 0u) || ((((select(_e570, _e567, (_e567 > _e570)) <= _e523) && ((select(_e587, _e584, (_e584 > _e587)) > _e523) || (_e688 != 0u))) && ((select(_e809, _e806, (_e806 > _e809)) <= _e762) && ((select(_e826, _e823, (_e823 > _e826)) > _e762) || (_e925 != 0u)))) && ((_e932 & 32u) != 0u)))), 31u, _e452), (_e364[7] == 0f)) > 1u);
if _e970 {
let _e974 = global_5.member[_e360].member;
let _e987 = (_e416 - _e422);
let _e990 = (_e416 / select(1e-20f, _e987, (_e987 > 1e-20f)));
let _e991 = (_e442 - _e448);
let _e994 = (_e442 / select(1e-20f, _e991, (_e991 > 1e-20f)));
let _e998 = (_e451 && (!(_e425) || (_e994 < _e990)));
let _e1005 = global_5.member[_e360].member_13.member_1.member.member;
let _e1011 = global_5.member[_e360].member_13.member_1.member_1;
let _e1018 = global_5.member[_e360].member_13.member.member.member;
let _e1024 = global_5.member[_e360].member_13.member.member_1;
let _e1043 = select(_e990, _e994, _e998);
let _e1045 = (_e974.member_2 == 2u);
let _e1048 = (((_e974.member_2 == 1u) || _e1045) || (_e974.member_2 == 5u));
if _e1048 {
let _e1050 = select(-1f, _e534, (_e534 > -1f));
let _e1052 = select(_e529, _e1050, (_e1050 < _e529));
let _e1059 = select(0i, select(select(i32(_e1052), i32(-2147483648), (_e1052 < -2147483600f)), 2147483647i, (_e1052 > 2147483500f)), (_e1052 == _e1052));
let _e1063 = (_e1059 - select(0i, 1i, (_e1052 < f32(_e1059))));
let _e1065 = select(-1f, _e545, (_e545 > -1f));
let _e1067 = select(_e540, _e1065, (_e1065 < _e540));
let _e1074 = select(0i, select(select(i32(_e1067), i32(-2147483648), (_e1067 < -2147483600f)), 2147483647i, (_e1067 > 2147483500f)), (_e1067 == _e1067));
let _e1078 = (_e1074 - select(0i, 1i, (_e1067 < f32(_e1074))));
let _e1080 = select(-1f, _e556, (_e556 > -1f));
let _e1082 = select(_e551, _e1080, (_e1080 < _e551));
let _e1089 = select(0i, select(select(i32(_e1082), i32(-2147483648), (_e1082 < -2147483600f)), 2147483647i, (_e1082 > 2147483500f)), (_e1082 == _e1082));
let _e1093 = (_e1089 - select(0i, 1i, (_e1082 < f32(_e1089))));
let _e1098 = global_5.member[_e360].member_6.member_7;
let _e1103 = global_5.member[_e360].member_6.member_8;
let _e1104 = (_e1063 + 1i);
let _e1105 = (_e1078 + 1i);
let _e1106 = (_e1093 + 1i);
let _e1112 = global_5.member[_e360].member_6.member_11.member;
let _e1119 = global_5.member[_e360].member_6.member_11.member_1;
let _e1130 = ((_e1104 >> bitcast<u32>(4i)) + (bitcast<i32>(_e1112) * ((_e1105 >> bitcast<u32>(4i)) + (bitcast<i32>(_e1119) * (_e1106 >> bitcast<u32>(4i))))));
let _e1132 = (bitcast<i32>(_e124) - 1i);
let _e1134 = select(_e1132, _e1130, (_e1130 < _e1132));
let _e1140 = global_1.member[bitcast<u32>(select(0i, _e1134, (_e1134 > 0i)))];
let _e1142 = (_e1104 & 15i);
let _e1145 = ((_e1105 & 15i) * _e1098);
let _e1147 = (bitcast<i32>(_e1140) + ((_e1106 & 15i) * _e1103));
let _e1151 = (_e1145 + _e1098);
let _e1153 = (_e1145 + (2i * _e1098));
let _e1154 = (_e1147 + _e1103);
let _e1156 = (_e1147 + (2i * _e1103));
local_10 = type_28(array<i32, 4>(_e1142, (_e1142 + 1i), (_e1142 + 2i), (_e1142 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_11 = vec3<f32>((_e534 - f32(_e1063)), (_e545 - f32(_e1078)), (_e556 - f32(_e1093)));
let _e1167 = (_e1154 + _e1151);
let _e1170 = local_10.member[1u];
let _e1171 = (_e1167 + _e1170);
let _e1173 = select(_e1132, _e1171, (_e1171 < _e1132));
let _e1178 = global_1.member[bitcast<u32>(select(0i, _e1173, (_e1173 > 0i)))];
let _e1179 = bitcast<f32>(_e1178);
let _e1182 = local_10.member[2u];
let _e1183 = (_e1167 + _e1182);
let _e1185 = select(_e1132, _e1183, (_e1183 < _e1132));
let _e1190 = global_1.member[bitcast<u32>(select(0i, _e1185, (_e1185 > 0i)))];
let _e1192 = local_11[0u];
let _e1195 = (_e1179 + ((bitcast<f32>(_e1190) - _e1179) * _e1192));
let _e1196 = (_e1154 + _e1153);
let _e1197 = local_10.member[1u];
let _e1198 = (_e1196 + _e1197);
let _e1200 = select(_e1132, _e1198, (_e1198 < _e1132));
let _e1205 = global_1.member[bitcast<u32>(select(0i, _e1200, (_e1200 > 0i)))];
let _e1206 = bitcast<f32>(_e1205);
let _e1207 = local_10.member[2u];
let _e1208 = (_e1196 + _e1207);
let _e1210 = select(_e1132, _e1208, (_e1208 < _e1132));
let _e1215 = global_1.member[bitcast<u32>(select(0i, _e1210, (_e1210 > 0i)))];
let _e1217 = local_11[0u];
let _e1221 = (_e1156 + _e1151);
let _e1222 = local_10.member[1u];
let _e1223 = (_e1221 + _e1222);
let _e1225 = select(_e1132, _e1223, (_e1223 < _e1132));
let _e1230 = global_1.member[bitcast<u32>(select(0i, _e1225, (_e1225 > 0i)))];
let _e1231 = bitcast<f32>(_e1230);
let _e1232 = local_10.member[2u];
let _e1233 = (_e1221 + _e1232);
let _e1235 = select(_e1132, _e1233, (_e1233 < _e1132));
let _e1240 = global_1.member[bitcast<u32>(select(0i, _e1235, (_e1235 > 0i)))];
let _e1242 = local_11[0u];
let _e1245 = (_e1231 + ((bitcast<f32>(_e1240) - _e1231) * _e1242));
let _e1246 = (_e1156 + _e1153);
let _e1247 = local_10.member[1u];
let _e1248 = (_e1246 + _e1247);
let _e1250 = select(_e1132, _e1248, (_e1248 < _e1132));
let _e1255 = global_1.member[bitcast<u32>(select(0i, _e1250, (_e1250 > 0i)))];
let _e1256 = bitcast<f32>(_e1255);
let _e1257 = local_10.member[2u];
let _e1258 = (_e1246 + _e1257);
let _e1260 = select(_e1132, _e1258, (_e1258 < _e1132));
let _e1265 = global_1.member[bitcast<u32>(select(0i, _e1260, (_e1260 > 0i)))];
let _e1267 = local_11[0u];
let _e1272 = local_11[1u];
let _e1275 = (_e1195 + (((_e1206 + ((bitcast<f32>(_e1215) - _e1206) * _e1217)) - _e1195) * _e1272));
let _e1276 = local_11[1u];
let _e1281 = local_11[2u];
let _e1289 = global_5.member[_e360].member_6.member_5;
let _e1295 = global_5.member[_e360].member_6.member_6;
let _e1296 = (((_e1275 + (((_e1245 + (((_e1256 + ((bitcast<f32>(_e1265) - _e1256) * _e1267)) - _e1245) * _e1276)) - _e1275) * _e1281)) * _e1289) + _e1295);
let _e1298 = select(0f, _e1296, (_e1296 > 0f));
let _e1302 = select(-1f, _e773, (_e773 > -1f));
let _e1304 = select(_e768, _e1302, (_e1302 < _e768));
let _e1311 = select(0i, select(select(i32(_e1304), i32(-2147483648), (_e1304 < -2147483600f)), 2147483647i, (_e1304 > 2147483500f)), (_e1304 == _e1304));
let _e1315 = (_e1311 - select(0i, 1i, (_e1304 < f32(_e1311))));
let _e1317 = select(-1f, _e784, (_e784 > -1f));
let _e1319 = select(_e779, _e1317, (_e1317 < _e779));
let _e1326 = select(0i, select(select(i32(_e1319), i32(-2147483648), (_e1319 < -2147483600f)), 2147483647i, (_e1319 > 2147483500f)), (_e1319 == _e1319));
let _e1330 = (_e1326 - select(0i, 1i, (_e1319 < f32(_e1326))));
let _e1332 = select(-1f, _e795, (_e795 > -1f));
let _e1334 = select(_e790, _e1332, (_e1332 < _e790));
let _e1341 = select(0i, select(select(i32(_e1334), i32(-2147483648), (_e1334 < -2147483600f)), 2147483647i, (_e1334 > 2147483500f)), (_e1334 == _e1334));
let _e1345 = (_e1341 - select(0i, 1i, (_e1334 < f32(_e1341))));
let _e1350 = global_5.member[_e360].member_7.member_7;
let _e1355 = global_5.member[_e360].member_7.member_8;
let _e1356 = (_e1315 + 1i);
let _e1357 = (_e1330 + 1i);
let _e1358 = (_e1345 + 1i);
let _e1364 = global_5.member[_e360].member_7.member_11.member;
let _e1371 = global_5.member[_e360].member_7.member_11.member_1;
let _e1382 = ((_e1356 >> bitcast<u32>(4i)) + (bitcast<i32>(_e1364) * ((_e1357 >> bitcast<u32>(4i)) + (bitcast<i32>(_e1371) * (_e1358 >> bitcast<u32>(4i))))));
let _e1384 = (bitcast<i32>(_e127) - 1i);
let _e1386 = select(_e1384, _e1382, (_e1382 < _e1384));
let _e1392 = global_7.member[bitcast<u32>(select(0i, _e1386, (_e1386 > 0i)))];
let _e1394 = (_e1356 & 15i);
let _e1397 = ((_e1357 & 15i) * _e1350);
let _e1399 = (bitcast<i32>(_e1392) + ((_e1358 & 15i) * _e1355));
let _e1403 = (_e1397 + _e1350);
let _e1405 = (_e1397 + (2i * _e1350));
let _e1407 = (_e1397 + (3i * _e1350));
let _e1408 = (_e1399 + _e1355);
let _e1410 = (_e1399 + (2i * _e1355));
let _e1412 = (_e1399 + (3i * _e1355));
local_8 = type_28(array<i32, 4>(_e1394, (_e1394 + 1i), (_e1394 + 2i), (_e1394 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_9 = vec3<f32>((_e773 - f32(_e1315)), (_e784 - f32(_e1330)), (_e795 - f32(_e1345)));
let _e1423 = (_e1408 + _e1403);
let _e1426 = local_8.member[0u];
let _e1427 = (_e1423 + _e1426);
let _e1429 = select(_e1384, _e1427, (_e1427 < _e1384));
let _e1434 = global_7.member[bitcast<u32>(select(0i, _e1429, (_e1429 > 0i)))];
let _e1435 = bitcast<f32>(_e1434);
let _e1438 = local_8.member[1u];
let _e1439 = (_e1423 + _e1438);
let _e1441 = select(_e1384, _e1439, (_e1439 < _e1384));
let _e1446 = global_7.member[bitcast<u32>(select(0i, _e1441, (_e1441 > 0i)))];
let _e1447 = bitcast<f32>(_e1446);
let _e1450 = local_8.member[2u];
let _e1451 = (_e1423 + _e1450);
let _e1453 = select(_e1384, _e1451, (_e1451 < _e1384));
let _e1458 = global_7.member[bitcast<u32>(select(0i, _e1453, (_e1453 > 0i)))];
let _e1459 = bitcast<f32>(_e1458);
let _e1462 = local_8.member[3u];
let _e1463 = (_e1423 + _e1462);
let _e1465 = select(_e1384, _e1463, (_e1463 < _e1384));
let _e1470 = global_7.member[bitcast<u32>(select(0i, _e1465, (_e1465 > 0i)))];
let _e1472 = local_9[0u];
let _e1475 = (_e1435 + ((_e1447 - _e1435) * _e1472));
let _e1476 = local_9[0u];
let _e1479 = (_e1447 + ((_e1459 - _e1447) * _e1476));
let _e1480 = local_9[0u];
let _e1483 = (_e1459 + ((bitcast<f32>(_e1470) - _e1459) * _e1480));
let _e1484 = (_e1408 + _e1405);
let _e1485 = local_8.member[0u];
let _e1486 = (_e1484 + _e1485);
let _e1488 = select(_e1384, _e1486, (_e1486 < _e1384));
let _e1493 = global_7.member[bitcast<u32>(select(0i, _e1488, (_e1488 > 0i)))];
let _e1494 = bitcast<f32>(_e1493);
let _e1495 = local_8.member[1u];
let _e1496 = (_e1484 + _e1495);
let _e1498 = select(_e1384, _e1496, (_e1496 < _e1384));
let _e1503 = global_7.member[bitcast<u32>(select(0i, _e1498, (_e1498 > 0i)))];
let _e1504 = bitcast<f32>(_e1503);
let _e1505 = local_8.member[2u];
let _e1506 = (_e1484 + _e1505);
let _e1508 = select(_e1384, _e1506, (_e1506 < _e1384));
let _e1513 = global_7.member[bitcast<u32>(select(0i, _e1508, (_e1508 > 0i)))];
let _e1514 = bitcast<f32>(_e1513);
let _e1515 = local_8.member[3u];
let _e1516 = (_e1484 + _e1515);
let _e1518 = select(_e1384, _e1516, (_e1516 < _e1384));
let _e1523 = global_7.member[bitcast<u32>(select(0i, _e1518, (_e1518 > 0i)))];
let _e1525 = local_9[0u];
let _e1529 = local_9[0u];
let _e1532 = (_e1504 + ((_e1514 - _e1504) * _e1529));
let _e1533 = local_9[0u];
let _e1537 = (_e1410 + _e1403);
let _e1538 = local_8.member[0u];
let _e1539 = (_e1537 + _e1538);
let _e1541 = select(_e1384, _e1539, (_e1539 < _e1384));
let _e1546 = global_7.member[bitcast<u32>(select(0i, _e1541, (_e1541 > 0i)))];
let _e1547 = bitcast<f32>(_e1546);
let _e1548 = local_8.member[1u];
let _e1549 = (_e1537 + _e1548);
let _e1551 = select(_e1384, _e1549, (_e1549 < _e1384));
let _e1556 = global_7.member[bitcast<u32>(select(0i, _e1551, (_e1551 > 0i)))];
let _e1557 = bitcast<f32>(_e1556);
let _e1558 = local_8.member[2u];
let _e1559 = (_e1537 + _e1558);
let _e1561 = select(_e1384, _e1559, (_e1559 < _e1384));
let _e1566 = global_7.member[bitcast<u32>(select(0i, _e1561, (_e1561 > 0i)))];
let _e1567 = bitcast<f32>(_e1566);
let _e1568 = local_8.member[3u];
let _e1569 = (_e1537 + _e1568);
let _e1571 = select(_e1384, _e1569, (_e1569 < _e1384));
let _e1576 = global_7.member[bitcast<u32>(select(0i, _e1571, (_e1571 > 0i)))];
let _e1578 = local_9[0u];
let _e1581 = (_e1547 + ((_e1557 - _e1547) * _e1578));
let _e1582 = local_9[0u];
let _e1585 = (_e1557 + ((_e1567 - _e1557) * _e1582));
let _e1586 = local_9[0u];
let _e1589 = (_e1567 + ((bitcast<f32>(_e1576) - _e1567) * _e1586));
let _e1590 = (_e1410 + _e1405);
let _e1591 = local_8.member[0u];
let _e1592 = (_e1590 + _e1591);
let _e1594 = select(_e1384, _e1592, (_e1592 < _e1384));
let _e1599 = global_7.member[bitcast<u32>(select(0i, _e1594, (_e1594 > 0i)))];
let _e1600 = bitcast<f32>(_e1599);
let _e1601 = local_8.member[1u];
let _e1602 = (_e1590 + _e1601);
let _e1604 = select(_e1384, _e1602, (_e1602 < _e1384));
let _e1609 = global_7.member[bitcast<u32>(select(0i, _e1604, (_e1604 > 0i)))];
let _e1610 = bitcast<f32>(_e1609);
let _e1611 = local_8.member[2u];
let _e1612 = (_e1590 + _e1611);
let _e1614 = select(_e1384, _e1612, (_e1612 < _e1384));
let _e1619 = global_7.member[bitcast<u32>(select(0i, _e1614, (_e1614 > 0i)))];
let _e1620 = bitcast<f32>(_e1619);
let _e1621 = local_8.member[3u];
let _e1622 = (_e1590 + _e1621);
let _e1624 = select(_e1384, _e1622, (_e1622 < _e1384));
let _e1629 = global_7.member[bitcast<u32>(select(0i, _e1624, (_e1624 > 0i)))];
let _e1631 = local_9[0u];
let _e1635 = local_9[0u];
let _e1638 = (_e1610 + ((_e1620 - _e1610) * _e1635));
let _e1639 = local_9[0u];
let _e1643 = (_e1408 + _e1397);
let _e1644 = local_8.member[1u];
let _e1645 = (_e1643 + _e1644);
let _e1647 = select(_e1384, _e1645, (_e1645 < _e1384));
let _e1652 = global_7.member[bitcast<u32>(select(0i, _e1647, (_e1647 > 0i)))];
let _e1653 = bitcast<f32>(_e1652);
let _e1654 = local_8.member[2u];
let _e1655 = (_e1643 + _e1654);
let _e1657 = select(_e1384, _e1655, (_e1655 < _e1384));
let _e1662 = global_7.member[bitcast<u32>(select(0i, _e1657, (_e1657 > 0i)))];
let _e1664 = local_9[0u];
let _e1667 = (_e1653 + ((bitcast<f32>(_e1662) - _e1653) * _e1664));
let _e1668 = (_e1408 + _e1407);
let _e1669 = local_8.member[1u];
let _e1670 = (_e1668 + _e1669);
let _e1672 = select(_e1384, _e1670, (_e1670 < _e1384));
let _e1677 = global_7.member[bitcast<u32>(select(0i, _e1672, (_e1672 > 0i)))];
let _e1678 = bitcast<f32>(_e1677);
let _e1679 = local_8.member[2u];
let _e1680 = (_e1668 + _e1679);
let _e1682 = select(_e1384, _e1680, (_e1680 < _e1384));
let _e1687 = global_7.member[bitcast<u32>(select(0i, _e1682, (_e1682 > 0i)))];
let _e1689 = local_9[0u];
let _e1693 = (_e1410 + _e1397);
let _e1694 = local_8.member[1u];
let _e1695 = (_e1693 + _e1694);
let _e1697 = select(_e1384, _e1695, (_e1695 < _e1384));
let _e1702 = global_7.member[bitcast<u32>(select(0i, _e1697, (_e1697 > 0i)))];
let _e1703 = bitcast<f32>(_e1702);
let _e1704 = local_8.member[2u];
let _e1705 = (_e1693 + _e1704);
let _e1707 = select(_e1384, _e1705, (_e1705 < _e1384));
let _e1712 = global_7.member[bitcast<u32>(select(0i, _e1707, (_e1707 > 0i)))];
let _e1714 = local_9[0u];
let _e1717 = (_e1703 + ((bitcast<f32>(_e1712) - _e1703) * _e1714));
let _e1718 = (_e1410 + _e1407);
let _e1719 = local_8.member[1u];
let _e1720 = (_e1718 + _e1719);
let _e1722 = select(_e1384, _e1720, (_e1720 < _e1384));
let _e1727 = global_7.member[bitcast<u32>(select(0i, _e1722, (_e1722 > 0i)))];
let _e1728 = bitcast<f32>(_e1727);
let _e1729 = local_8.member[2u];
let _e1730 = (_e1718 + _e1729);
let _e1732 = select(_e1384, _e1730, (_e1730 < _e1384));
let _e1737 = global_7.member[bitcast<u32>(select(0i, _e1732, (_e1732 > 0i)))];
let _e1739 = local_9[0u];
let _e1743 = (_e1399 + _e1403);
let _e1744 = local_8.member[1u];
let _e1745 = (_e1743 + _e1744);
let _e1747 = select(_e1384, _e1745, (_e1745 < _e1384));
let _e1752 = global_7.member[bitcast<u32>(select(0i, _e1747, (_e1747 > 0i)))];
let _e1753 = bitcast<f32>(_e1752);
let _e1754 = local_8.member[2u];
let _e1755 = (_e1743 + _e1754);
let _e1757 = select(_e1384, _e1755, (_e1755 < _e1384));
let _e1762 = global_7.member[bitcast<u32>(select(0i, _e1757, (_e1757 > 0i)))];
let _e1764 = local_9[0u];
let _e1767 = (_e1753 + ((bitcast<f32>(_e1762) - _e1753) * _e1764));
let _e1768 = (_e1412 + _e1403);
let _e1769 = local_8.member[1u];
let _e1770 = (_e1768 + _e1769);
let _e1772 = select(_e1384, _e1770, (_e1770 < _e1384));
let _e1777 = global_7.member[bitcast<u32>(select(0i, _e1772, (_e1772 > 0i)))];
let _e1778 = bitcast<f32>(_e1777);
let _e1779 = local_8.member[2u];
let _e1780 = (_e1768 + _e1779);
let _e1782 = select(_e1384, _e1780, (_e1780 < _e1384));
let _e1787 = global_7.member[bitcast<u32>(select(0i, _e1782, (_e1782 > 0i)))];
let _e1789 = local_9[0u];
let _e1792 = (_e1778 + ((bitcast<f32>(_e1787) - _e1778) * _e1789));
let _e1793 = (_e1399 + _e1405);
let _e1794 = local_8.member[1u];
let _e1795 = (_e1793 + _e1794);
let _e1797 = select(_e1384, _e1795, (_e1795 < _e1384));
let _e1802 = global_7.member[bitcast<u32>(select(0i, _e1797, (_e1797 > 0i)))];
let _e1803 = bitcast<f32>(_e1802);
let _e1804 = local_8.member[2u];
let _e1805 = (_e1793 + _e1804);
let _e1807 = select(_e1384, _e1805, (_e1805 < _e1384));
let _e1812 = global_7.member[bitcast<u32>(select(0i, _e1807, (_e1807 > 0i)))];
let _e1814 = local_9[0u];
let _e1818 = (_e1412 + _e1405);
let _e1819 = local_8.member[1u];
let _e1820 = (_e1818 + _e1819);
let _e1822 = select(_e1384, _e1820, (_e1820 < _e1384));
let _e1827 = global_7.member[bitcast<u32>(select(0i, _e1822, (_e1822 > 0i)))];
let _e1828 = bitcast<f32>(_e1827);
let _e1829 = local_8.member[2u];
let _e1830 = (_e1818 + _e1829);
let _e1832 = select(_e1384, _e1830, (_e1830 < _e1384));
let _e1837 = global_7.member[bitcast<u32>(select(0i, _e1832, (_e1832 > 0i)))];
let _e1839 = local_9[0u];
let _e1844 = local_9[1u];
let _e1847 = (_e1479 + ((_e1532 - _e1479) * _e1844));
let _e1848 = local_9[1u];
let _e1851 = (_e1585 + ((_e1638 - _e1585) * _e1848));
let _e1852 = local_9[1u];
let _e1855 = (_e1475 + (((_e1494 + ((_e1504 - _e1494) * _e1525)) - _e1475) * _e1852));
let _e1856 = local_9[1u];
let _e1861 = local_9[2u];
let _e1865 = local_9[1u];
let _e1868 = (_e1483 + (((_e1514 + ((bitcast<f32>(_e1523) - _e1514) * _e1533)) - _e1483) * _e1865));
let _e1869 = local_9[1u];
let _e1873 = local_9[2u];
let _e1877 = local_9[1u];
let _e1880 = (_e1667 + ((_e1479 - _e1667) * _e1877));
let _e1881 = local_9[1u];
let _e1885 = local_9[2u];
let _e1889 = local_9[1u];
let _e1892 = (_e1532 + (((_e1678 + ((bitcast<f32>(_e1687) - _e1678) * _e1689)) - _e1532) * _e1889));
let _e1893 = local_9[1u];
let _e1897 = local_9[2u];
let _e1901 = local_9[1u];
let _e1904 = (_e1767 + (((_e1803 + ((bitcast<f32>(_e1812) - _e1803) * _e1814)) - _e1767) * _e1901));
let _e1905 = local_9[2u];
let _e1909 = local_9[1u];
let _e1913 = local_9[2u];
let _e1917 = local_9[2u];
let _e1925 = global_5.member[_e360].member_7.member_5;
let _e1931 = global_5.member[_e360].member_7.member_6;
let _e1932 = (((_e1847 + ((_e1851 - _e1847) * _e1917)) * _e1925) + _e1931);
let _e1934 = select(0f, _e1932, (_e1932 > 0f));
let _e1938 = (((_e1855 + (((_e1581 + (((_e1600 + ((_e1610 - _e1600) * _e1631)) - _e1581) * _e1856)) - _e1855) * _e1861)) * _e1925) + _e1931);
let _e1940 = select(0f, _e1938, (_e1938 > 0f));
let _e1942 = select(1f, _e1940, (_e1940 < 1f));
let _e1944 = (((_e1868 + (((_e1589 + (((_e1620 + ((bitcast<f32>(_e1629) - _e1620) * _e1639)) - _e1589) * _e1869)) - _e1868) * _e1873)) * _e1925) + _e1931);
let _e1946 = select(0f, _e1944, (_e1944 > 0f));
let _e1948 = select(1f, _e1946, (_e1946 < 1f));
let _e1950 = (((_e1880 + (((_e1717 + ((_e1585 - _e1717) * _e1881)) - _e1880) * _e1885)) * _e1925) + _e1931);
let _e1952 = select(0f, _e1950, (_e1950 > 0f));
let _e1954 = select(1f, _e1952, (_e1952 < 1f));
let _e1956 = (((_e1892 + (((_e1638 + (((_e1728 + ((bitcast<f32>(_e1737) - _e1728) * _e1739)) - _e1638) * _e1893)) - _e1892) * _e1897)) * _e1925) + _e1931);
let _e1958 = select(0f, _e1956, (_e1956 > 0f));
let _e1960 = select(1f, _e1958, (_e1958 < 1f));
let _e1962 = (((_e1904 + ((_e1847 - _e1904) * _e1905)) * _e1925) + _e1931);
let _e1964 = select(0f, _e1962, (_e1962 > 0f));
let _e1966 = select(1f, _e1964, (_e1964 < 1f));
let _e1968 = (((_e1851 + (((_e1792 + (((_e1828 + ((bitcast<f32>(_e1837) - _e1828) * _e1839)) - _e1792) * _e1909)) - _e1851) * _e1913)) * _e1925) + _e1931);
let _e1970 = select(0f, _e1968, (_e1968 > 0f));
let _e1972 = select(1f, _e1970, (_e1970 < 1f));
let _e1973 = (select(1f, _e1934, (_e1934 < 1f)) * 1024f);
let _e1974 = (1024f - 1f);
let _e1976 = select(0f, _e1973, (_e1973 > 0f));
let _e1978 = select(_e1974, _e1976, (_e1976 < _e1974));
let _e1985 = select(0i, select(select(i32(_e1978), i32(-2147483648), (_e1978 < -2147483600f)), 2147483647i, (_e1978 > 2147483500f)), (_e1978 == _e1978));
let _e1989 = (_e1985 - select(0i, 1i, (_e1978 < f32(_e1985))));
let _e1990 = (262147i + _e1989);
let _e1992 = (bitcast<i32>(_e131) - 1i);
let _e1994 = select(_e1992, _e1990, (_e1990 < _e1992));
let _e2000 = global_3.member[bitcast<u32>(select(0i, _e1994, (_e1994 > 0i)))];
let _e2010 = select(_e1992, 262146i, (262146i < _e1992));
let _e2016 = global_3.member[bitcast<u32>(select(0i, _e2010, (_e2010 > 0i)))];
let _e2017 = bitcast<f32>(_e2016);
let _e2018 = (f32((bitcast<i32>((_e2000 & 4095u)) - 2048i)) * _e2017);
let _e2020 = select(_e1992, 262144i, (262144i < _e1992));
let _e2026 = global_3.member[bitcast<u32>(select(0i, _e2020, (_e2020 > 0i)))];
let _e2027 = bitcast<f32>(_e2026);
let _e2029 = select(_e1992, 262145i, (262145i < _e1992));
let _e2035 = global_3.member[bitcast<u32>(select(0i, _e2029, (_e2029 > 0i)))];
let _e2036 = bitcast<f32>(_e2035);
let _e2042 = ((_e2027 + (f32(bitcast<i32>((_e2000 >> bitcast<u32>(12u)))) * _e2036)) + (_e2018 * (_e1973 - f32(_e1989))));
let _e2043 = (_e2018 * 1024f);
if _e1045 {
let _e2050 = ((0.5f * (_e1948 - _e1942)) * _e2043);
let _e2051 = ((0.5f * (_e1960 - _e1954)) * _e2043);
let _e2052 = ((0.5f * (_e1972 - _e1966)) * _e2043);
phi_4916_ = type_29(_e2042, vec3<f32>(_e2050, _e2051, _e2052), vec3<f32>((_e2050 * _e2042), (_e2051 * _e2042), (_e2052 * _e2042)));
} else {
let _e2059 = (_e1942 * 1024f);
let _e2061 = select(0f, _e2059, (_e2059 > 0f));
let _e2063 = select(_e1974, _e2061, (_e2061 < _e1974));
let _e2070 = select(0i, select(select(i32(_e2063), i32(-2147483648), (_e2063 < -2147483600f)), 2147483647i, (_e2063 > 2147483500f)), (_e2063 == _e2063));
let _e2074 = (_e2070 - select(0i, 1i, (_e2063 < f32(_e2070))));
let _e2075 = (262147i + _e2074);
let _e2077 = select(_e1992, _e2075, (_e2075 < _e1992));
let _e2083 = global_3.member[bitcast<u32>(select(0i, _e2077, (_e2077 > 0i)))];
let _e2098 = ((_e2027 + (f32(bitcast<i32>((_e2083 >> bitcast<u32>(12u)))) * _e2036)) + ((f32((bitcast<i32>((_e2083 & 4095u)) - 2048i)) * _e2017) * (_e2059 - f32(_e2074))));
let _e2099 = (_e1948 * 1024f);
let _e2101 = select(0f, _e2099, (_e2099 > 0f));
let _e2103 = select(_e1974, _e2101, (_e2101 < _e1974));
let _e2110 = select(0i, select(select(i32(_e2103), i32(-2147483648), (_e2103 < -2147483600f)), 2147483647i, (_e2103 > 2147483500f)), (_e2103 == _e2103));
let _e2114 = (_e2110 - select(0i, 1i, (_e2103 < f32(_e2110))));
let _e2115 = (262147i + _e2114);
let _e2117 = select(_e1992, _e2115, (_e2115 < _e1992));
let _e2123 = global_3.member[bitcast<u32>(select(0i, _e2117, (_e2117 > 0i)))];
let _e2138 = ((_e2027 + (f32(bitcast<i32>((_e2123 >> bitcast<u32>(12u)))) * _e2036)) + ((f32((bitcast<i32>((_e2123 & 4095u)) - 2048i)) * _e2017) * (_e2099 - f32(_e2114))));
let _e2139 = (_e1954 * 1024f);
let _e2141 = select(0f, _e2139, (_e2139 > 0f));
let _e2143 = select(_e1974, _e2141, (_e2141 < _e1974));
let _e2150 = select(0i, select(select(i32(_e2143), i32(-2147483648), (_e2143 < -2147483600f)), 2147483647i, (_e2143 > 2147483500f)), (_e2143 == _e2143));
let _e2154 = (_e2150 - select(0i, 1i, (_e2143 < f32(_e2150))));
let _e2155 = (262147i + _e2154);
let _e2157 = select(_e1992, _e2155, (_e2155 < _e1992));
let _e2163 = global_3.member[bitcast<u32>(select(0i, _e2157, (_e2157 > 0i)))];
let _e2178 = ((_e2027 + (f32(bitcast<i32>((_e2163 >> bitcast<u32>(12u)))) * _e2036)) + ((f32((bitcast<i32>((_e2163 & 4095u)) - 2048i)) * _e2017) * (_e2139 - f32(_e2154))));
let _e2179 = (_e1960 * 1024f);
let _e2181 = select(0f, _e2179, (_e2179 > 0f));
let _e2183 = select(_e1974, _e2181, (_e2181 < _e1974));
let _e2190 = select(0i, select(select(i32(_e2183), i32(-2147483648), (_e2183 < -2147483600f)), 2147483647i, (_e2183 > 2147483500f)), (_e2183 == _e2183));
let _e2194 = (_e2190 - select(0i, 1i, (_e2183 < f32(_e2190))));
let _e2195 = (262147i + _e2194);
let _e2197 = select(_e1992, _e2195, (_e2195 < _e1992));
let _e2203 = global_3.member[bitcast<u32>(select(0i, _e2197, (_e2197 > 0i)))];
let _e2218 = ((_e2027 + (f32(bitcast<i32>((_e2203 >> bitcast<u32>(12u)))) * _e2036)) + ((f32((bitcast<i32>((_e2203 & 4095u)) - 2048i)) * _e2017) * (_e2179 - f32(_e2194))));
let _e2219 = (_e1966 * 1024f);
let _e2221 = select(0f, _e2219, (_e2219 > 0f));
let _e2223 = select(_e1974, _e2221, (_e2221 < _e1974));
let _e2230 = select(0i, select(select(i32(_e2223), i32(-2147483648), (_e2223 < -2147483600f)), 2147483647i, (_e2223 > 2147483500f)), (_e2223 == _e2223));
let _e2234 = (_e2230 - select(0i, 1i, (_e2223 < f32(_e2230))));
let _e2235 = (262147i + _e2234);
let _e2237 = select(_e1992, _e2235, (_e2235 < _e1992));
let _e2243 = global_3.member[bitcast<u32>(select(0i, _e2237, (_e2237 > 0i)))];
let _e2258 = ((_e2027 + (f32(bitcast<i32>((_e2243 >> bitcast<u32>(12u)))) * _e2036)) + ((f32((bitcast<i32>((_e2243 & 4095u)) - 2048i)) * _e2017) * (_e2219 - f32(_e2234))));
let _e2259 = (_e1972 * 1024f);
let _e2261 = select(0f, _e2259, (_e2259 > 0f));
let _e2263 = select(_e1974, _e2261, (_e2261 < _e1974));
let _e2270 = select(0i, select(select(i32(_e2263), i32(-2147483648), (_e2263 < -2147483600f)), 2147483647i, (_e2263 > 2147483500f)), (_e2263 == _e2263));
let _e2274 = (_e2270 - select(0i, 1i, (_e2263 < f32(_e2270))));
let _e2275 = (262147i + _e2274);
let _e2277 = select(_e1992, _e2275, (_e2275 < _e1992));
let _e2283 = global_3.member[bitcast<u32>(select(0i, _e2277, (_e2277 > 0i)))];
let _e2298 = ((_e2027 + (f32(bitcast<i32>((_e2283 >> bitcast<u32>(12u)))) * _e2036)) + ((f32((bitcast<i32>((_e2283 & 4095u)) - 2048i)) * _e2017) * (_e2259 - f32(_e2274))));
let _e2299 = (_e2138 - _e2098);
let _e2301 = (_e2218 - _e2178);
let _e2303 = (_e2298 - _e2258);
phi_4916_ = type_29(_e2042, vec3<f32>((0.5f * _e2299), (0.5f * _e2301), (0.5f * _e2303)), vec3<f32>((0.25f * (_e2299 * (_e2138 + _e2098))), (0.25f * (_e2301 * (_e2218 + _e2178))), (0.25f * (_e2303 * (_e2298 + _e2258)))));
}
let _e2318 = phi_4916_;
let _e2333 = select(0f, 1f, ((((((_e745 >= -0.5f) && (_e745 <= _e769)) && (_e751 >= -0.5f)) && (_e751 <= _e780)) && (_e757 >= -0.5f)) && (_e757 <= _e791)));
let _e2335 = (0.5f * (_e1948 - _e1942));
let _e2337 = (0.5f * (_e1960 - _e1954));
let _e2339 = (0.5f * (_e1972 - _e1966));
let _e2346 = global_5.member[_e360].member_7.member.member.member;
let _e2353 = global_5.member[_e360].member_7.member.member.member_1;
let _e2360 = global_5.member[_e360].member_7.member.member.member_2;
let _e2367 = global_5.member[_e360].member_7.member_1.member.member;
let _e2374 = global_5.member[_e360].member_7.member_1.member.member_1;
let _e2381 = global_5.member[_e360].member_7.member_1.member.member_2;
let _e2388 = global_5.member[_e360].member_7.member_2.member.member;
let _e2395 = global_5.member[_e360].member_7.member_2.member.member_1;
let _e2402 = global_5.member[_e360].member_7.member_2.member.member_2;
phi_5525_ = type_30(select(1f, _e1298, (_e1298 < 1f)), vec3<f32>(((((_e2346 * _e2335) + (_e2367 * _e2337)) + (_e2388 * _e2339)) * _e2333), ((((_e2353 * _e2335) + (_e2374 * _e2337)) + (_e2395 * _e2339)) * _e2333), ((((_e2360 * _e2335) + (_e2381 * _e2337)) + (_e2402 * _e2339)) * _e2333)), _e2318.member, vec3<f32>(((((_e2346 * _e2318.member_2.x) + (_e2367 * _e2318.member_2.y)) + (_e2388 * _e2318.member_2.z)) * _e2333), ((((_e2353 * _e2318.member_2.x) + (_e2374 * _e2318.member_2.y)) + (_e2395 * _e2318.member_2.z)) * _e2333), ((((_e2360 * _e2318.member_2.x) + (_e2381 * _e2318.member_2.y)) + (_e2402 * _e2318.member_2.z)) * _e2333)), vec3<f32>(((((_e2346 * _e2318.member_1.x) + (_e2367 * _e2318.member_1.y)) + (_e2388 * _e2318.member_1.z)) * _e2333), ((((_e2353 * _e2318.member_1.x) + (_e2374 * _e2318.member_1.y)) + (_e2395 * _e2318.member_1.z)) * _e2333), ((((_e2360 * _e2318.member_1.x) + (_e2381 * _e2318.member_1.y)) + (_e2402 * _e2318.member_1.z)) * _e2333)));
} else {
let _e2468 = select(-1f, _e534, (_e534 > -1f));
let _e2470 = select(_e529, _e2468, (_e2468 < _e529));
let _e2477 = select(0i, select(select(i32(_e2470), i32(-2147483648), (_e2470 < -2147483600f)), 2147483647i, (_e2470 > 2147483500f)), (_e2470 == _e2470));
let _e2481 = (_e2477 - select(0i, 1i, (_e2470 < f32(_e2477))));
let _e2483 = select(-1f, _e545, (_e545 > -1f));
let _e2485 = select(_e540, _e2483, (_e2483 < _e540));
let _e2492 = select(0i, select(select(i32(_e2485), i32(-2147483648), (_e2485 < -2147483600f)), 2147483647i, (_e2485 > 2147483500f)), (_e2485 == _e2485));
let _e2496 = (_e2492 - select(0i, 1i, (_e2485 < f32(_e2492))));
let _e2498 = select(-1f, _e556, (_e556 > -1f));
let _e2500 = select(_e551, _e2498, (_e2498 < _e551));
let _e2507 = select(0i, select(select(i32(_e2500), i32(-2147483648), (_e2500 < -2147483600f)), 2147483647i, (_e2500 > 2147483500f)), (_e2500 == _e2500));
let _e2511 = (_e2507 - select(0i, 1i, (_e2500 < f32(_e2507))));
let _e2516 = global_5.member[_e360].member_6.member_7;
let _e2521 = global_5.member[_e360].member_6.member_8;
let _e2522 = (_e2481 + 1i);
let _e2523 = (_e2496 + 1i);
let _e2524 = (_e2511 + 1i);
let _e2530 = global_5.member[_e360].member_6.member_11.member;
let _e2537 = global_5.member[_e360].member_6.member_11.member_1;
let _e2548 = ((_e2522 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2530) * ((_e2523 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2537) * (_e2524 >> bitcast<u32>(4i))))));
let _e2550 = (bitcast<i32>(_e124) - 1i);
let _e2552 = select(_e2550, _e2548, (_e2548 < _e2550));
let _e2558 = global_1.member[bitcast<u32>(select(0i, _e2552, (_e2552 > 0i)))];
let _e2560 = (_e2522 & 15i);
let _e2563 = ((_e2523 & 15i) * _e2516);
let _e2565 = (bitcast<i32>(_e2558) + ((_e2524 & 15i) * _e2521));
let _e2569 = (_e2563 + _e2516);
let _e2571 = (_e2563 + (2i * _e2516));
let _e2572 = (_e2565 + _e2521);
let _e2574 = (_e2565 + (2i * _e2521));
local_6 = type_28(array<i32, 4>(_e2560, (_e2560 + 1i), (_e2560 + 2i), (_e2560 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_7 = vec3<f32>((_e534 - f32(_e2481)), (_e545 - f32(_e2496)), (_e556 - f32(_e2511)));
let _e2585 = (_e2572 + _e2569);
let _e2588 = local_6.member[1u];
let _e2589 = (_e2585 + _e2588);
let _e2591 = select(_e2550, _e2589, (_e2589 < _e2550));
let _e2596 = global_1.member[bitcast<u32>(select(0i, _e2591, (_e2591 > 0i)))];
let _e2597 = bitcast<f32>(_e2596);
let _e2600 = local_6.member[2u];
let _e2601 = (_e2585 + _e2600);
let _e2603 = select(_e2550, _e2601, (_e2601 < _e2550));
let _e2608 = global_1.member[bitcast<u32>(select(0i, _e2603, (_e2603 > 0i)))];
let _e2610 = local_7[0u];
let _e2613 = (_e2597 + ((bitcast<f32>(_e2608) - _e2597) * _e2610));
let _e2614 = (_e2572 + _e2571);
let _e2615 = local_6.member[1u];
let _e2616 = (_e2614 + _e2615);
let _e2618 = select(_e2550, _e2616, (_e2616 < _e2550));
let _e2623 = global_1.member[bitcast<u32>(select(0i, _e2618, (_e2618 > 0i)))];
let _e2624 = bitcast<f32>(_e2623);
let _e2625 = local_6.member[2u];
let _e2626 = (_e2614 + _e2625);
let _e2628 = select(_e2550, _e2626, (_e2626 < _e2550));
let _e2633 = global_1.member[bitcast<u32>(select(0i, _e2628, (_e2628 > 0i)))];
let _e2635 = local_7[0u];
let _e2640 = local_7[1u];
let _e2643 = (_e2613 + (((_e2624 + ((bitcast<f32>(_e2633) - _e2624) * _e2635)) - _e2613) * _e2640));
let _e2644 = (_e2574 + _e2569);
let _e2645 = local_6.member[1u];
let _e2646 = (_e2644 + _e2645);
let _e2648 = select(_e2550, _e2646, (_e2646 < _e2550));
let _e2653 = global_1.member[bitcast<u32>(select(0i, _e2648, (_e2648 > 0i)))];
let _e2654 = bitcast<f32>(_e2653);
let _e2655 = local_6.member[2u];
let _e2656 = (_e2644 + _e2655);
let _e2658 = select(_e2550, _e2656, (_e2656 < _e2550));
let _e2663 = global_1.member[bitcast<u32>(select(0i, _e2658, (_e2658 > 0i)))];
let _e2665 = local_7[0u];
let _e2668 = (_e2654 + ((bitcast<f32>(_e2663) - _e2654) * _e2665));
let _e2669 = (_e2574 + _e2571);
let _e2670 = local_6.member[1u];
let _e2671 = (_e2669 + _e2670);
let _e2673 = select(_e2550, _e2671, (_e2671 < _e2550));
let _e2678 = global_1.member[bitcast<u32>(select(0i, _e2673, (_e2673 > 0i)))];
let _e2679 = bitcast<f32>(_e2678);
let _e2680 = local_6.member[2u];
let _e2681 = (_e2669 + _e2680);
let _e2683 = select(_e2550, _e2681, (_e2681 < _e2550));
let _e2688 = global_1.member[bitcast<u32>(select(0i, _e2683, (_e2683 > 0i)))];
let _e2690 = local_7[0u];
let _e2694 = local_7[1u];
let _e2699 = local_7[2u];
let _e2707 = global_5.member[_e360].member_6.member_5;
let _e2713 = global_5.member[_e360].member_6.member_6;
let _e2714 = (((_e2643 + (((_e2668 + (((_e2679 + ((bitcast<f32>(_e2688) - _e2679) * _e2690)) - _e2668) * _e2694)) - _e2643) * _e2699)) * _e2707) + _e2713);
let _e2716 = select(0f, _e2714, (_e2714 > 0f));
phi_5525_ = type_30(select(1f, _e2716, (_e2716 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2721 = phi_5525_;
let _e2723 = select(-0.5f, _e468, (_e468 > -0.5f));
let _e2725 = select(_e530, _e2723, (_e2723 < _e530));
let _e2727 = select(-0.5f, _e484, (_e484 > -0.5f));
let _e2729 = select(_e541, _e2727, (_e2727 < _e541));
let _e2731 = select(-0.5f, _e500, (_e500 > -0.5f));
let _e2733 = select(_e552, _e2731, (_e2731 < _e552));
let _e2735 = select(-1f, _e2725, (_e2725 > -1f));
let _e2737 = select(_e529, _e2735, (_e2735 < _e529));
let _e2744 = select(0i, select(select(i32(_e2737), i32(-2147483648), (_e2737 < -2147483600f)), 2147483647i, (_e2737 > 2147483500f)), (_e2737 == _e2737));
let _e2748 = (_e2744 - select(0i, 1i, (_e2737 < f32(_e2744))));
let _e2750 = select(-1f, _e2729, (_e2729 > -1f));
let _e2752 = select(_e540, _e2750, (_e2750 < _e540));
let _e2759 = select(0i, select(select(i32(_e2752), i32(-2147483648), (_e2752 < -2147483600f)), 2147483647i, (_e2752 > 2147483500f)), (_e2752 == _e2752));
let _e2763 = (_e2759 - select(0i, 1i, (_e2752 < f32(_e2759))));
let _e2765 = select(-1f, _e2733, (_e2733 > -1f));
let _e2767 = select(_e551, _e2765, (_e2765 < _e551));
let _e2774 = select(0i, select(select(i32(_e2767), i32(-2147483648), (_e2767 < -2147483600f)), 2147483647i, (_e2767 > 2147483500f)), (_e2767 == _e2767));
let _e2778 = (_e2774 - select(0i, 1i, (_e2767 < f32(_e2774))));
let _e2783 = global_5.member[_e360].member_6.member_7;
let _e2788 = global_5.member[_e360].member_6.member_8;
let _e2789 = (_e2748 + 1i);
let _e2790 = (_e2763 + 1i);
let _e2791 = (_e2778 + 1i);
let _e2797 = global_5.member[_e360].member_6.member_11.member;
let _e2804 = global_5.member[_e360].member_6.member_11.member_1;
let _e2815 = ((_e2789 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2797) * ((_e2790 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2804) * (_e2791 >> bitcast<u32>(4i))))));
let _e2817 = (bitcast<i32>(_e124) - 1i);
let _e2819 = select(_e2817, _e2815, (_e2815 < _e2817));
let _e2825 = global_1.member[bitcast<u32>(select(0i, _e2819, (_e2819 > 0i)))];
let _e2827 = (_e2789 & 15i);
let _e2830 = ((_e2790 & 15i) * _e2783);
let _e2832 = (bitcast<i32>(_e2825) + ((_e2791 & 15i) * _e2788));
let _e2836 = (_e2830 + _e2783);
let _e2838 = (_e2830 + (2i * _e2783));
let _e2839 = (_e2832 + _e2788);
let _e2841 = (_e2832 + (2i * _e2788));
local_4 = type_28(array<i32, 4>(_e2827, (_e2827 + 1i), (_e2827 + 2i), (_e2827 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_5 = vec3<f32>((_e2725 - f32(_e2748)), (_e2729 - f32(_e2763)), (_e2733 - f32(_e2778)));
let _e2852 = (_e2839 + _e2836);
let _e2855 = local_4.member[1u];
let _e2856 = (_e2852 + _e2855);
let _e2858 = select(_e2817, _e2856, (_e2856 < _e2817));
let _e2863 = global_1.member[bitcast<u32>(select(0i, _e2858, (_e2858 > 0i)))];
let _e2864 = bitcast<f32>(_e2863);
let _e2867 = local_4.member[2u];
let _e2868 = (_e2852 + _e2867);
let _e2870 = select(_e2817, _e2868, (_e2868 < _e2817));
let _e2875 = global_1.member[bitcast<u32>(select(0i, _e2870, (_e2870 > 0i)))];
let _e2877 = local_5[0u];
let _e2880 = (_e2864 + ((bitcast<f32>(_e2875) - _e2864) * _e2877));
let _e2881 = (_e2839 + _e2838);
let _e2882 = local_4.member[1u];
let _e2883 = (_e2881 + _e2882);
let _e2885 = select(_e2817, _e2883, (_e2883 < _e2817));
let _e2890 = global_1.member[bitcast<u32>(select(0i, _e2885, (_e2885 > 0i)))];
let _e2891 = bitcast<f32>(_e2890);
let _e2892 = local_4.member[2u];
let _e2893 = (_e2881 + _e2892);
let _e2895 = select(_e2817, _e2893, (_e2893 < _e2817));
let _e2900 = global_1.member[bitcast<u32>(select(0i, _e2895, (_e2895 > 0i)))];
let _e2902 = local_5[0u];
let _e2907 = local_5[1u];
let _e2910 = (_e2880 + (((_e2891 + ((bitcast<f32>(_e2900) - _e2891) * _e2902)) - _e2880) * _e2907));
let _e2911 = (_e2841 + _e2836);
let _e2912 = local_4.member[1u];
let _e2913 = (_e2911 + _e2912);
let _e2915 = select(_e2817, _e2913, (_e2913 < _e2817));
let _e2920 = global_1.member[bitcast<u32>(select(0i, _e2915, (_e2915 > 0i)))];
let _e2921 = bitcast<f32>(_e2920);
let _e2922 = local_4.member[2u];
let _e2923 = (_e2911 + _e2922);
let _e2925 = select(_e2817, _e2923, (_e2923 < _e2817));
let _e2930 = global_1.member[bitcast<u32>(select(0i, _e2925, (_e2925 > 0i)))];
let _e2932 = local_5[0u];
let _e2935 = (_e2921 + ((bitcast<f32>(_e2930) - _e2921) * _e2932));
let _e2936 = (_e2841 + _e2838);
let _e2937 = local_4.member[1u];
let _e2938 = (_e2936 + _e2937);
let _e2940 = select(_e2817, _e2938, (_e2938 < _e2817));
let _e2945 = global_1.member[bitcast<u32>(select(0i, _e2940, (_e2940 > 0i)))];
let _e2946 = bitcast<f32>(_e2945);
let _e2947 = local_4.member[2u];
let _e2948 = (_e2936 + _e2947);
let _e2950 = select(_e2817, _e2948, (_e2948 < _e2817));
let _e2955 = global_1.member[bitcast<u32>(select(0i, _e2950, (_e2950 > 0i)))];
let _e2957 = local_5[0u];
let _e2961 = local_5[1u];
let _e2966 = local_5[2u];
let _e2974 = global_5.member[_e360].member_6.member_5;
let _e2980 = global_5.member[_e360].member_6.member_6;
let _e2981 = (((_e2910 + (((_e2935 + (((_e2946 + ((bitcast<f32>(_e2955) - _e2946) * _e2957)) - _e2935) * _e2961)) - _e2910) * _e2966)) * _e2974) + _e2980);
let _e2983 = select(0f, _e2981, (_e2981 > 0f));
let _e2986 = select(_e364[6], select(1f, _e2983, (_e2983 < 1f)), _e964);
if _e1048 {
let _e2988 = select(-0.5f, _e707, (_e707 > -0.5f));
let _e2990 = select(_e769, _e2988, (_e2988 < _e769));
let _e2992 = select(-0.5f, _e723, (_e723 > -0.5f));
let _e2994 = select(_e780, _e2992, (_e2992 < _e780));
let _e2996 = select(-0.5f, _e739, (_e739 > -0.5f));
let _e2998 = select(_e791, _e2996, (_e2996 < _e791));
let _e3000 = select(-1f, _e2990, (_e2990 > -1f));
let _e3002 = select(_e768, _e3000, (_e3000 < _e768));
let _e3009 = select(0i, select(select(i32(_e3002), i32(-2147483648), (_e3002 < -2147483600f)), 2147483647i, (_e3002 > 2147483500f)), (_e3002 == _e3002));
let _e3013 = (_e3009 - select(0i, 1i, (_e3002 < f32(_e3009))));
let _e3015 = select(-1f, _e2994, (_e2994 > -1f));
let _e3017 = select(_e779, _e3015, (_e3015 < _e779));
let _e3024 = select(0i, select(select(i32(_e3017), i32(-2147483648), (_e3017 < -2147483600f)), 2147483647i, (_e3017 > 2147483500f)), (_e3017 == _e3017));
let _e3028 = (_e3024 - select(0i, 1i, (_e3017 < f32(_e3024))));
let _e3030 = select(-1f, _e2998, (_e2998 > -1f));
let _e3032 = select(_e790, _e3030, (_e3030 < _e790));
let _e3039 = select(0i, select(select(i32(_e3032), i32(-2147483648), (_e3032 < -2147483600f)), 2147483647i, (_e3032 > 2147483500f)), (_e3032 == _e3032));
let _e3043 = (_e3039 - select(0i, 1i, (_e3032 < f32(_e3039))));
let _e3048 = global_5.member[_e360].member_7.member_7;
let _e3053 = global_5.member[_e360].member_7.member_8;
let _e3054 = (_e3013 + 1i);
let _e3055 = (_e3028 + 1i);
let _e3056 = (_e3043 + 1i);
let _e3062 = global_5.member[_e360].member_7.member_11.member;
let _e3069 = global_5.member[_e360].member_7.member_11.member_1;
let _e3080 = ((_e3054 >> bitcast<u32>(4i)) + (bitcast<i32>(_e3062) * ((_e3055 >> bitcast<u32>(4i)) + (bitcast<i32>(_e3069) * (_e3056 >> bitcast<u32>(4i))))));
let _e3082 = (bitcast<i32>(_e127) - 1i);
let _e3084 = select(_e3082, _e3080, (_e3080 < _e3082));
let _e3090 = global_7.member[bitcast<u32>(select(0i, _e3084, (_e3084 > 0i)))];
let _e3092 = (_e3054 & 15i);
let _e3095 = ((_e3055 & 15i) * _e3048);
let _e3097 = (bitcast<i32>(_e3090) + ((_e3056 & 15i) * _e3053));
let _e3101 = (_e3095 + _e3048);
let _e3103 = (_e3095 + (2i * _e3048));
let _e3104 = (_e3097 + _e3053);
let _e3106 = (_e3097 + (2i * _e3053));
local_2 = type_28(array<i32, 4>(_e3092, (_e3092 + 1i), (_e3092 + 2i), (_e3092 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_3 = vec3<f32>((_e2990 - f32(_e3013)), (_e2994 - f32(_e3028)), (_e2998 - f32(_e3043)));
let _e3117 = (_e3104 + _e3101);
let _e3120 = local_2.member[1u];
let _e3121 = (_e3117 + _e3120);
let _e3123 = select(_e3082, _e3121, (_e3121 < _e3082));
let _e3128 = global_7.member[bitcast<u32>(select(0i, _e3123, (_e3123 > 0i)))];
let _e3129 = bitcast<f32>(_e3128);
let _e3132 = local_2.member[2u];
let _e3133 = (_e3117 + _e3132);
let _e3135 = select(_e3082, _e3133, (_e3133 < _e3082));
let _e3140 = global_7.member[bitcast<u32>(select(0i, _e3135, (_e3135 > 0i)))];
let _e3142 = local_3[0u];
let _e3145 = (_e3129 + ((bitcast<f32>(_e3140) - _e3129) * _e3142));
let _e3146 = (_e3104 + _e3103);
let _e3147 = local_2.member[1u];
let _e3148 = (_e3146 + _e3147);
let _e3150 = select(_e3082, _e3148, (_e3148 < _e3082));
let _e3155 = global_7.member[bitcast<u32>(select(0i, _e3150, (_e3150 > 0i)))];
let _e3156 = bitcast<f32>(_e3155);
let _e3157 = local_2.member[2u];
let _e3158 = (_e3146 + _e3157);
let _e3160 = select(_e3082, _e3158, (_e3158 < _e3082));
let _e3165 = global_7.member[bitcast<u32>(select(0i, _e3160, (_e3160 > 0i)))];
let _e3167 = local_3[0u];
let _e3172 = local_3[1u];
let _e3175 = (_e3145 + (((_e3156 + ((bitcast<f32>(_e3165) - _e3156) * _e3167)) - _e3145) * _e3172));
let _e3176 = (_e3106 + _e3101);
let _e3177 = local_2.member[1u];
let _e3178 = (_e3176 + _e3177);
let _e3180 = select(_e3082, _e3178, (_e3178 < _e3082));
let _e3185 = global_7.member[bitcast<u32>(select(0i, _e3180, (_e3180 > 0i)))];
let _e3186 = bitcast<f32>(_e3185);
let _e3187 = local_2.member[2u];
let _e3188 = (_e3176 + _e3187);
let _e3190 = select(_e3082, _e3188, (_e3188 < _e3082));
let _e3195 = global_7.member[bitcast<u32>(select(0i, _e3190, (_e3190 > 0i)))];
let _e3197 = local_3[0u];
let _e3200 = (_e3186 + ((bitcast<f32>(_e3195) - _e3186) * _e3197));
let _e3201 = (_e3106 + _e3103);
let _e3202 = local_2.member[1u];
let _e3203 = (_e3201 + _e3202);
let _e3205 = select(_e3082, _e3203, (_e3203 < _e3082));
let _e3210 = global_7.member[bitcast<u32>(select(0i, _e3205, (_e3205 > 0i)))];
let _e3211 = bitcast<f32>(_e3210);
let _e3212 = local_2.member[2u];
let _e3213 = (_e3201 + _e3212);
let _e3215 = select(_e3082, _e3213, (_e3213 < _e3082));
let _e3220 = global_7.member[bitcast<u32>(select(0i, _e3215, (_e3215 > 0i)))];
let _e3222 = local_3[0u];
let _e3226 = local_3[1u];
let _e3231 = local_3[2u];
let _e3239 = global_5.member[_e360].member_7.member_5;
let _e3245 = global_5.member[_e360].member_7.member_6;
let _e3246 = (((_e3175 + (((_e3200 + (((_e3211 + ((bitcast<f32>(_e3220) - _e3211) * _e3222)) - _e3200) * _e3226)) - _e3175) * _e3231)) * _e3239) + _e3245);
let _e3248 = select(0f, _e3246, (_e3246 > 0f));
let _e3251 = (select(1f, _e3248, (_e3248 < 1f)) * 1024f);
let _e3252 = (1024f - 1f);
let _e3254 = select(0f, _e3251, (_e3251 > 0f));
let _e3256 = select(_e3252, _e3254, (_e3254 < _e3252));
let _e3263 = select(0i, select(select(i32(_e3256), i32(-2147483648), (_e3256 < -2147483600f)), 2147483647i, (_e3256 > 2147483500f)), (_e3256 == _e3256));
let _e3267 = (_e3263 - select(0i, 1i, (_e3256 < f32(_e3263))));
let _e3268 = (262147i + _e3267);
let _e3270 = (bitcast<i32>(_e131) - 1i);
let _e3272 = select(_e3270, _e3268, (_e3268 < _e3270));
let _e3278 = global_3.member[bitcast<u32>(select(0i, _e3272, (_e3272 > 0i)))];
let _e3288 = select(_e3270, 262146i, (262146i < _e3270));
let _e3294 = global_3.member[bitcast<u32>(select(0i, _e3288, (_e3288 > 0i)))];
let _e3298 = select(_e3270, 262144i, (262144i < _e3270));
let _e3304 = global_3.member[bitcast<u32>(select(0i, _e3298, (_e3298 > 0i)))];
let _e3307 = select(_e3270, 262145i, (262145i < _e3270));
let _e3313 = global_3.member[bitcast<u32>(select(0i, _e3307, (_e3307 > 0i)))];
phi_6527_ = select(_e364[16], ((bitcast<f32>(_e3304) + (f32(bitcast<i32>((_e3278 >> bitcast<u32>(12u)))) * bitcast<f32>(_e3313))) + ((f32((bitcast<i32>((_e3278 & 4095u)) - 2048i)) * bitcast<f32>(_e3294)) * (_e3251 - f32(_e3267)))), _e964);
} else {
phi_6527_ = _e364[16];
}
let _e3323 = phi_6527_;
let _e3326 = select(1f, select(1f, _e1043, (_e1043 < 1f)), _e452);
if ((_e932 & 16u) == 0u) {
phi_6916_ = type_5(1f, 1f, 1f);
} else {
let _e3333 = global_5.member[_e360].member_14.member;
let _e3344 = ((((_e3333.member.member * _e388) + (_e3333.member.member_1 * _e390)) + (_e3333.member.member_2 * _e384)) + _e3333.member_1);
let _e3350 = ((((_e3333.member.member * _e392) + (_e3333.member.member_1 * _e394)) + (_e3333.member.member_2 * _e399)) + _e3333.member_1);
let _e3352 = select(_e3350, _e3344, (_e3344 < _e3350));
let _e3354 = select(_e3350, _e3344, (_e3344 > _e3350));
let _e3356 = (_e3354 - _e3352);
let _e3359 = (-(_e3352) / select(1e-30f, _e3356, (_e3356 > 1e-30f)));
let _e3361 = select(0f, _e3359, (_e3359 > 0f));
let _e3367 = select(select(select(1f, _e3361, (_e3361 < 1f)), 1f, (_e3354 <= 0f)), 0f, (_e3352 > 0f));
let _e3373 = global_5.member[_e360].member_14.member_1;
let _e3374 = (_e3373 != 0u);
let _e3385 = global_5.member[_e360].member_15.member;
let _e3396 = ((((_e3385.member.member * _e388) + (_e3385.member.member_1 * _e390)) + (_e3385.member.member_2 * _e384)) + _e3385.member_1);
let _e3402 = ((((_e3385.member.member * _e392) + (_e3385.member.member_1 * _e394)) + (_e3385.member.member_2 * _e399)) + _e3385.member_1);
let _e3404 = select(_e3402, _e3396, (_e3396 < _e3402));
let _e3406 = select(_e3402, _e3396, (_e3396 > _e3402));
let _e3408 = (_e3406 - _e3404);
let _e3411 = (-(_e3404) / select(1e-30f, _e3408, (_e3408 > 1e-30f)));
let _e3413 = select(0f, _e3411, (_e3411 > 0f));
let _e3419 = select(select(select(1f, _e3413, (_e3413 < 1f)), 1f, (_e3406 <= 0f)), 0f, (_e3404 > 0f));
let _e3425 = global_5.member[_e360].member_15.member_1;
let _e3426 = (_e3425 != 0u);
let _e3437 = global_5.member[_e360].member_16.member;
let _e3448 = ((((_e3437.member.member * _e388) + (_e3437.member.member_1 * _e390)) + (_e3437.member.member_2 * _e384)) + _e3437.member_1);
let _e3454 = ((((_e3437.member.member * _e392) + (_e3437.member.member_1 * _e394)) + (_e3437.member.member_2 * _e399)) + _e3437.member_1);
let _e3456 = select(_e3454, _e3448, (_e3448 < _e3454));
let _e3458 = select(_e3454, _e3448, (_e3448 > _e3454));
let _e3460 = (_e3458 - _e3456);
let _e3463 = (-(_e3456) / select(1e-30f, _e3460, (_e3460 > 1e-30f)));
let _e3465 = select(0f, _e3463, (_e3463 > 0f));
let _e3471 = select(select(select(1f, _e3465, (_e3465 < 1f)), 1f, (_e3458 <= 0f)), 0f, (_e3456 > 0f));
let _e3477 = global_5.member[_e360].member_16.member_1;
let _e3478 = (_e3477 != 0u);
let _e3489 = global_5.member[_e360].member_17.member;
let _e3500 = ((((_e3489.member.member * _e388) + (_e3489.member.member_1 * _e390)) + (_e3489.member.member_2 * _e384)) + _e3489.member_1);
let _e3506 = ((((_e3489.member.member * _e392) + (_e3489.member.member_1 * _e394)) + (_e3489.member.member_2 * _e399)) + _e3489.member_1);
let _e3508 = select(_e3506, _e3500, (_e3500 < _e3506));
let _e3510 = select(_e3506, _e3500, (_e3500 > _e3506));
let _e3512 = (_e3510 - _e3508);
let _e3515 = (-(_e3508) / select(1e-30f, _e3512, (_e3512 > 1e-30f)));
let _e3517 = select(0f, _e3515, (_e3515 > 0f));
let _e3523 = select(select(select(1f, _e3517, (_e3517 < 1f)), 1f, (_e3510 <= 0f)), 0f, (_e3508 > 0f));
let _e3529 = global_5.member[_e360].member_17.member_1;
let _e3530 = (_e3529 != 0u);
phi_6916_ = type_5(((((1f * _e3367) * _e3419) * _e3471) * _e3523), ((((1f * select(1f, _e3367, _e3374)) * select(1f, _e3419, _e3426)) * select(1f, _e3471, _e3478)) * select(1f, _e3523, _e3530)), ((((1f * select(1f, 0f, (_e3374 && (_e3350 > 0f)))) * select(1f, 0f, (_e3426 && (_e3402 > 0f)))) * select(1f, 0f, (_e3478 && (_e3454 > 0f)))) * select(1f, 0f, (_e3530 && (_e3506 > 0f)))));
}
let _e3539 = phi_6916_;
let _e3540 = (_e562 < 1e-12f);
let _e3542 = (1f / select(_e557, 1f, _e3540));
let _e3544 = ((-0.5f - _e468) * _e3542);
let _e3546 = ((_e530 - _e468) * _e3542);
let _e3552 = select(_e3546, _e3544, (_e3544 < _e3546));
let _e3554 = select(0f, _e3552, (_e3552 > 0f));
let _e3557 = select(select(1f, _e3554, (_e3554 < 1f)), select(2f, 0f, ((_e468 >= -0.5f) && (_e468 <= _e530))), _e3540);
let _e3559 = select(_e3546, _e3544, (_e3544 > _e3546));
let _e3561 = select(0f, _e3559, (_e3559 > 0f));
let _e3564 = select(select(1f, _e3561, (_e3561 < 1f)), 1f, _e3540);
let _e3565 = (_e565 < 1e-12f);
let _e3567 = (1f / select(_e558, 1f, _e3565));
let _e3569 = ((-0.5f - _e484) * _e3567);
let _e3571 = ((_e541 - _e484) * _e3567);
let _e3577 = select(_e3571, _e3569, (_e3569 < _e3571));
let _e3579 = select(0f, _e3577, (_e3577 > 0f));
let _e3582 = select(select(1f, _e3579, (_e3579 < 1f)), select(2f, 0f, ((_e484 >= -0.5f) && (_e484 <= _e541))), _e3565);
let _e3584 = select(_e3571, _e3569, (_e3569 > _e3571));
let _e3586 = select(0f, _e3584, (_e3584 > 0f));
let _e3589 = select(select(1f, _e3586, (_e3586 < 1f)), 1f, _e3565);
let _e3590 = (_e570 < 1e-12f);
let _e3592 = (1f / select(_e559, 1f, _e3590));
let _e3594 = ((-0.5f - _e500) * _e3592);
let _e3596 = ((_e552 - _e500) * _e3592);
let _e3602 = select(_e3596, _e3594, (_e3594 < _e3596));
let _e3604 = select(0f, _e3602, (_e3602 > 0f));
let _e3607 = select(select(1f, _e3604, (_e3604 < 1f)), select(2f, 0f, ((_e500 >= -0.5f) && (_e500 <= _e552))), _e3590);
let _e3609 = select(_e3596, _e3594, (_e3594 > _e3596));
let _e3611 = select(0f, _e3609, (_e3609 > 0f));
let _e3614 = select(select(1f, _e3611, (_e3611 < 1f)), 1f, _e3590);
let _e3616 = select(_e3589, _e3564, (_e3564 < _e3589));
let _e3620 = select(_e3582, _e3557, (_e3557 > _e3582));
let _e3623 = (select(_e3614, _e3616, (_e3616 < _e3614)) - select(_e3607, _e3620, (_e3620 > _e3607)));
let _e3626 = (_e392 - _e388);
let _e3627 = (_e394 - _e390);
let _e3628 = (_e399 - _e384);
let _e3633 = (((_e3626 * _e3626) + (_e3627 * _e3627)) + (_e3628 * _e3628));
let _e3643 = global_5.member[_e360].member_5.member_3;
let _e3644 = (((sqrt(select(0f, _e3633, (_e3633 > 0f))) * select(0f, _e3623, (_e3623 > 0f))) * _e3326) * _e3643);
let _e3645 = (_e974.member_2 >= 3u);
if _e3645 {
let _e3647 = (_e2986 * 255f);
let _e3648 = (_e2721.member * 255f);
let _e3649 = (255f - 1f);
let _e3651 = select(0f, _e3647, (_e3647 > 0f));
let _e3653 = select(_e3649, _e3651, (_e3651 < _e3649));
let _e3660 = select(0i, select(select(i32(_e3653), i32(-2147483648), (_e3653 < -2147483600f)), 2147483647i, (_e3653 > 2147483500f)), (_e3653 == _e3653));
let _e3664 = (_e3660 - select(0i, 1i, (_e3653 < f32(_e3660))));
let _e3666 = select(0f, _e3648, (_e3648 > 0f));
let _e3668 = select(_e3649, _e3666, (_e3666 < _e3649));
let _e3675 = select(0i, select(select(i32(_e3668), i32(-2147483648), (_e3668 < -2147483600f)), 2147483647i, (_e3668 > 2147483500f)), (_e3668 == _e3668));
let _e3679 = (_e3675 - select(0i, 1i, (_e3668 < f32(_e3675))));
let _e3682 = (((_e3664 * 256i) + _e3679) * 4i);
let _e3684 = (_e3647 - f32(_e3664));
let _e3686 = (_e3648 - f32(_e3679));
let _e3687 = (_e3682 + 2i);
let _e3689 = (bitcast<i32>(_e131) - 1i);
let _e3691 = select(_e3689, _e3687, (_e3687 < _e3689));
let _e3697 = global_3.member[bitcast<u32>(select(0i, _e3691, (_e3691 > 0i)))];
let _e3698 = (_e3682 + 6i);
let _e3700 = select(_e3689, _e3698, (_e3698 < _e3689));
let _e3706 = global_3.member[bitcast<u32>(select(0i, _e3700, (_e3700 > 0i)))];
let _e3707 = (_e3682 + 1026i);
let _e3709 = select(_e3689, _e3707, (_e3707 < _e3689));
let _e3715 = global_3.member[bitcast<u32>(select(0i, _e3709, (_e3709 > 0i)))];
let _e3716 = (_e3682 + 1030i);
let _e3718 = select(_e3689, _e3716, (_e3716 < _e3689));
let _e3724 = global_3.member[bitcast<u32>(select(0i, _e3718, (_e3718 > 0i)))];
let _e3729 = (bitcast<f32>(((_e3697 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3737 = (_e3729 + (((bitcast<f32>(((_e3706 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3729) * _e3686));
let _e3742 = (bitcast<f32>(((_e3715 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3766 = (bitcast<f32>((((_e3697 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3774 = (_e3766 + (((bitcast<f32>((((_e3706 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3766) * _e3686));
let _e3779 = (bitcast<f32>((((_e3715 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3791 = (_e3682 + 3i);
let _e3793 = select(_e3689, _e3791, (_e3791 < _e3689));
let _e3799 = global_3.member[bitcast<u32>(select(0i, _e3793, (_e3793 > 0i)))];
let _e3800 = (_e3682 + 7i);
let _e3802 = select(_e3689, _e3800, (_e3800 < _e3689));
let _e3808 = global_3.member[bitcast<u32>(select(0i, _e3802, (_e3802 > 0i)))];
let _e3809 = (_e3682 + 1027i);
let _e3811 = select(_e3689, _e3809, (_e3809 < _e3689));
let _e3817 = global_3.member[bitcast<u32>(select(0i, _e3811, (_e3811 > 0i)))];
let _e3818 = (_e3682 + 1031i);
let _e3820 = select(_e3689, _e3818, (_e3818 < _e3689));
let _e3826 = global_3.member[bitcast<u32>(select(0i, _e3820, (_e3820 > 0i)))];
let _e3831 = (bitcast<f32>(((_e3799 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3839 = (_e3831 + (((bitcast<f32>(((_e3808 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3831) * _e3686));
let _e3844 = (bitcast<f32>(((_e3817 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3868 = (bitcast<f32>((((_e3799 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3876 = (_e3868 + (((bitcast<f32>((((_e3808 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3868) * _e3686));
let _e3881 = (bitcast<f32>((((_e3817 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3892 = (_e3876 + (((_e3881 + (((bitcast<f32>((((_e3826 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3881) * _e3686)) - _e3876) * _e3684));
let _e3896 = -((_e3892 * (_e3644 * _e3539.member)));
let _e3898 = select(-87f, _e3896, (_e3896 > -87f));
let _e3900 = select(88f, _e3898, (_e3898 < 88f));
let _e3902 = ((_e3900 * 1.442695f) + 0.5f);
let _e3904 = select(-127f, _e3902, (_e3902 > -127f));
let _e3906 = select(128f, _e3904, (_e3904 < 128f));
let _e3913 = select(0i, select(select(i32(_e3906), i32(-2147483648), (_e3906 < -2147483600f)), 2147483647i, (_e3906 > 2147483500f)), (_e3906 == _e3906));
let _e3917 = (_e3913 - select(0i, 1i, (_e3906 < f32(_e3913))));
let _e3918 = f32(_e3917);
let _e3922 = ((_e3900 - (_e3918 * 0.6933594f)) - (_e3918 * -2.1219444e-4f));
let _e3942 = ((1f + (_e3922 * (1f + (_e3922 * (0.5f + (_e3922 * (0.16666667f + (_e3922 * (0.041666668f + (_e3922 * (0.008333334f + (_e3922 * (0.001388889f + (_e3922 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3917 + 127i)) << bitcast<u32>(23i))));
let _e3943 = (1f - _e3942);
let _e3946 = (_e3943 / select(1e-12f, _e3892, (_e3892 > 1e-12f)));
phi_8474_ = type_31(_e3942, _e3943, vec3<f32>(1f, 1f, 1f), vec3<f32>(((_e3737 + (((_e3742 + (((bitcast<f32>(((_e3724 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3742) * _e3686)) - _e3737) * _e3684)) * _e3946), ((_e3774 + (((_e3779 + (((bitcast<f32>((((_e3724 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3779) * _e3686)) - _e3774) * _e3684)) * _e3946), ((_e3839 + (((_e3844 + (((bitcast<f32>(((_e3826 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3844) * _e3686)) - _e3839) * _e3684)) * _e3946)));
} else {
let _e3953 = (_e2986 * 255f);
let _e3954 = (_e2721.member * 255f);
let _e3955 = (255f - 1f);
let _e3957 = select(0f, _e3953, (_e3953 > 0f));
let _e3959 = select(_e3955, _e3957, (_e3957 < _e3955));
let _e3966 = select(0i, select(select(i32(_e3959), i32(-2147483648), (_e3959 < -2147483600f)), 2147483647i, (_e3959 > 2147483500f)), (_e3959 == _e3959));
let _e3970 = (_e3966 - select(0i, 1i, (_e3959 < f32(_e3966))));
let _e3972 = select(0f, _e3954, (_e3954 > 0f));
let _e3974 = select(_e3955, _e3972, (_e3972 < _e3955));
let _e3981 = select(0i, select(select(i32(_e3974), i32(-2147483648), (_e3974 < -2147483600f)), 2147483647i, (_e3974 > 2147483500f)), (_e3974 == _e3974));
let _e3985 = (_e3981 - select(0i, 1i, (_e3974 < f32(_e3981))));
let _e3988 = (((_e3970 * 256i) + _e3985) * 4i);
let _e3990 = (_e3953 - f32(_e3970));
let _e3992 = (_e3954 - f32(_e3985));
let _e3994 = (bitcast<i32>(_e131) - 1i);
let _e3996 = select(_e3994, _e3988, (_e3988 < _e3994));
let _e4002 = global_3.member[bitcast<u32>(select(0i, _e3996, (_e3996 > 0i)))];
let _e4003 = (_e3988 + 4i);
let _e4005 = select(_e3994, _e4003, (_e4003 < _e3994));
let _e4011 = global_3.member[bitcast<u32>(select(0i, _e4005, (_e4005 > 0i)))];
let _e4012 = (_e3988 + 1024i);
let _e4014 = select(_e3994, _e4012, (_e4012 < _e3994));
let _e4020 = global_3.member[bitcast<u32>(select(0i, _e4014, (_e4014 > 0i)))];
let _e4021 = (_e3988 + 1028i);
let _e4023 = select(_e3994, _e4021, (_e4021 < _e3994));
let _e4029 = global_3.member[bitcast<u32>(select(0i, _e4023, (_e4023 > 0i)))];
let _e4034 = (bitcast<f32>(((_e4002 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4042 = (_e4034 + (((bitcast<f32>(((_e4011 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4034) * _e3992));
let _e4047 = (bitcast<f32>(((_e4020 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4058 = (_e4042 + (((_e4047 + (((bitcast<f32>(((_e4029 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4047) * _e3992)) - _e4042) * _e3990));
let _e4071 = (bitcast<f32>((((_e4002 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4079 = (_e4071 + (((bitcast<f32>((((_e4011 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4071) * _e3992));
let _e4084 = (bitcast<f32>((((_e4020 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4096 = (_e3988 + 1i);
let _e4098 = select(_e3994, _e4096, (_e4096 < _e3994));
let _e4104 = global_3.member[bitcast<u32>(select(0i, _e4098, (_e4098 > 0i)))];
let _e4105 = (_e3988 + 5i);
let _e4107 = select(_e3994, _e4105, (_e4105 < _e3994));
let _e4113 = global_3.member[bitcast<u32>(select(0i, _e4107, (_e4107 > 0i)))];
let _e4114 = (_e3988 + 1025i);
let _e4116 = select(_e3994, _e4114, (_e4114 < _e3994));
let _e4122 = global_3.member[bitcast<u32>(select(0i, _e4116, (_e4116 > 0i)))];
let _e4123 = (_e3988 + 1029i);
let _e4125 = select(_e3994, _e4123, (_e4123 < _e3994));
let _e4131 = global_3.member[bitcast<u32>(select(0i, _e4125, (_e4125 > 0i)))];
let _e4136 = (bitcast<f32>(((_e4104 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4144 = (_e4136 + (((bitcast<f32>(((_e4113 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4136) * _e3992));
let _e4149 = (bitcast<f32>(((_e4122 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4173 = (bitcast<f32>((((_e4104 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4181 = (_e4173 + (((bitcast<f32>((((_e4113 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4173) * _e3992));
let _e4186 = (bitcast<f32>((((_e4122 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4198 = (_e3988 + 2i);
let _e4200 = select(_e3994, _e4198, (_e4198 < _e3994));
let _e4206 = global_3.member[bitcast<u32>(select(0i, _e4200, (_e4200 > 0i)))];
let _e4207 = (_e3988 + 6i);
let _e4209 = select(_e3994, _e4207, (_e4207 < _e3994));
let _e4215 = global_3.member[bitcast<u32>(select(0i, _e4209, (_e4209 > 0i)))];
let _e4216 = (_e3988 + 1026i);
let _e4218 = select(_e3994, _e4216, (_e4216 < _e3994));
let _e4224 = global_3.member[bitcast<u32>(select(0i, _e4218, (_e4218 > 0i)))];
let _e4225 = (_e3988 + 1030i);
let _e4227 = select(_e3994, _e4225, (_e4225 < _e3994));
let _e4233 = global_3.member[bitcast<u32>(select(0i, _e4227, (_e4227 > 0i)))];
let _e4238 = (bitcast<f32>(((_e4206 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4246 = (_e4238 + (((bitcast<f32>(((_e4215 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4238) * _e3992));
let _e4251 = (bitcast<f32>(((_e4224 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4275 = (bitcast<f32>((((_e4206 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4283 = (_e4275 + (((bitcast<f32>((((_e4215 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4275) * _e3992));
let _e4288 = (bitcast<f32>((((_e4224 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4300 = (_e3988 + 3i);
let _e4302 = select(_e3994, _e4300, (_e4300 < _e3994));
let _e4308 = global_3.member[bitcast<u32>(select(0i, _e4302, (_e4302 > 0i)))];
let _e4309 = (_e3988 + 7i);
let _e4311 = select(_e3994, _e4309, (_e4309 < _e3994));
let _e4317 = global_3.member[bitcast<u32>(select(0i, _e4311, (_e4311 > 0i)))];
let _e4318 = (_e3988 + 1027i);
let _e4320 = select(_e3994, _e4318, (_e4318 < _e3994));
let _e4326 = global_3.member[bitcast<u32>(select(0i, _e4320, (_e4320 > 0i)))];
let _e4327 = (_e3988 + 1031i);
let _e4329 = select(_e3994, _e4327, (_e4327 < _e3994));
let _e4335 = global_3.member[bitcast<u32>(select(0i, _e4329, (_e4329 > 0i)))];
let _e4340 = (bitcast<f32>(((_e4308 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4348 = (_e4340 + (((bitcast<f32>(((_e4317 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4340) * _e3992));
let _e4353 = (bitcast<f32>(((_e4326 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4368 = (_e3644 * _e3539.member_1);
let _e4370 = -(((_e4079 + (((_e4084 + (((bitcast<f32>((((_e4029 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4084) * _e3992)) - _e4079) * _e3990)) * _e4368));
let _e4372 = select(-87f, _e4370, (_e4370 > -87f));
let _e4374 = select(88f, _e4372, (_e4372 < 88f));
let _e4376 = ((_e4374 * 1.442695f) + 0.5f);
let _e4378 = select(-127f, _e4376, (_e4376 > -127f));
let _e4380 = select(128f, _e4378, (_e4378 < 128f));
let _e4387 = select(0i, select(select(i32(_e4380), i32(-2147483648), (_e4380 < -2147483600f)), 2147483647i, (_e4380 > 2147483500f)), (_e4380 == _e4380));
let _e4391 = (_e4387 - select(0i, 1i, (_e4380 < f32(_e4387))));
let _e4392 = f32(_e4391);
let _e4396 = ((_e4374 - (_e4392 * 0.6933594f)) - (_e4392 * -2.1219444e-4f));
let _e4418 = -(((_e4144 + (((_e4149 + (((bitcast<f32>(((_e4131 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4149) * _e3992)) - _e4144) * _e3990)) * _e4368));
let _e4420 = select(-87f, _e4418, (_e4418 > -87f));
let _e4422 = select(88f, _e4420, (_e4420 < 88f));
let _e4424 = ((_e4422 * 1.442695f) + 0.5f);
let _e4426 = select(-127f, _e4424, (_e4424 > -127f));
let _e4428 = select(128f, _e4426, (_e4426 < 128f));
let _e4435 = select(0i, select(select(i32(_e4428), i32(-2147483648), (_e4428 < -2147483600f)), 2147483647i, (_e4428 > 2147483500f)), (_e4428 == _e4428));
let _e4439 = (_e4435 - select(0i, 1i, (_e4428 < f32(_e4435))));
let _e4440 = f32(_e4439);
let _e4444 = ((_e4422 - (_e4440 * 0.6933594f)) - (_e4440 * -2.1219444e-4f));
let _e4466 = -(((_e4181 + (((_e4186 + (((bitcast<f32>((((_e4131 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4186) * _e3992)) - _e4181) * _e3990)) * _e4368));
let _e4468 = select(-87f, _e4466, (_e4466 > -87f));
let _e4470 = select(88f, _e4468, (_e4468 < 88f));
let _e4472 = ((_e4470 * 1.442695f) + 0.5f);
let _e4474 = select(-127f, _e4472, (_e4472 > -127f));
let _e4476 = select(128f, _e4474, (_e4474 < 128f));
let _e4483 = select(0i, select(select(i32(_e4476), i32(-2147483648), (_e4476 < -2147483600f)), 2147483647i, (_e4476 > 2147483500f)), (_e4476 == _e4476));
let _e4487 = (_e4483 - select(0i, 1i, (_e4476 < f32(_e4483))));
let _e4488 = f32(_e4487);
let _e4492 = ((_e4470 - (_e4488 * 0.6933594f)) - (_e4488 * -2.1219444e-4f));
let _e4515 = -((_e4058 * (_e3644 * _e3539.member)));
let _e4517 = select(-87f, _e4515, (_e4515 > -87f));
let _e4519 = select(88f, _e4517, (_e4517 < 88f));
let _e4521 = ((_e4519 * 1.442695f) + 0.5f);
let _e4523 = select(-127f, _e4521, (_e4521 > -127f));
let _e4525 = select(128f, _e4523, (_e4523 < 128f));
let _e4532 = select(0i, select(select(i32(_e4525), i32(-2147483648), (_e4525 < -2147483600f)), 2147483647i, (_e4525 > 2147483500f)), (_e4525 == _e4525));
let _e4536 = (_e4532 - select(0i, 1i, (_e4525 < f32(_e4532))));
let _e4537 = f32(_e4536);
let _e4541 = ((_e4519 - (_e4537 * 0.6933594f)) - (_e4537 * -2.1219444e-4f));
let _e4561 = ((1f + (_e4541 * (1f + (_e4541 * (0.5f + (_e4541 * (0.16666667f + (_e4541 * (0.041666668f + (_e4541 * (0.008333334f + (_e4541 * (0.001388889f + (_e4541 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4536 + 127i)) << bitcast<u32>(23i))));
let _e4562 = (1f - _e4561);
let _e4565 = (_e4562 / select(1e-12f, _e4058, (_e4058 > 1e-12f)));
phi_8474_ = type_31(_e4561, _e4562, vec3<f32>(((1f + (_e4396 * (1f + (_e4396 * (0.5f + (_e4396 * (0.16666667f + (_e4396 * (0.041666668f + (_e4396 * (0.008333334f + (_e4396 * (0.001388889f + (_e4396 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4391 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e4444 * (1f + (_e4444 * (0.5f + (_e4444 * (0.16666667f + (_e4444 * (0.041666668f + (_e4444 * (0.008333334f + (_e4444 * (0.001388889f + (_e4444 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4439 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e4492 * (1f + (_e4492 * (0.5f + (_e4492 * (0.16666667f + (_e4492 * (0.041666668f + (_e4492 * (0.008333334f + (_e4492 * (0.001388889f + (_e4492 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4487 + 127i)) << bitcast<u32>(23i))))), vec3<f32>(((_e4246 + (((_e4251 + (((bitcast<f32>(((_e4233 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4251) * _e3992)) - _e4246) * _e3990)) * _e4565), ((_e4283 + (((_e4288 + (((bitcast<f32>((((_e4233 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4288) * _e3992)) - _e4283) * _e3990)) * _e4565), ((_e4348 + (((_e4353 + (((bitcast<f32>(((_e4335 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4353) * _e3992)) - _e4348) * _e3990)) * _e4565)));
}
let _e4572 = phi_8474_;
let _e4573 = select(0f, _e3326, _e452);
let _e4577 = (_e388 + (_e3626 * _e4573));
let _e4578 = (_e390 + (_e3627 * _e4573));
let _e4579 = (_e384 + (_e3628 * _e4573));
if (_e974.member_2 == 3u) {
let _e4585 = global_5.member[_e360].member_9.member_1;
let _e4594 = global_5.member[_e360].member_9.member;
phi_9457_ = type_25(vec3<f32>(_e4585.member, _e4585.member_1, _e4585.member_2), vec3<f32>(_e4594.member, _e4594.member_1, _e4594.member_2));
} else {
let _e4604 = global_5.member[_e360].member_8.member_8;
let _e4605 = (_e4579 - _e4604);
let _e4610 = global_5.member[_e360].member_8.member_2;
let _e4615 = global_5.member[_e360].member_8.member_6;
let _e4623 = global_5.member[_e360].member_8.member_5;
let _e4625 = (((_e4577 - (_e4610 + (_e4615 * _e4605))) * _e4623) - 0.5f);
let _e4630 = global_5.member[_e360].member_8.member_3;
let _e4635 = global_5.member[_e360].member_8.member_7;
let _e4640 = (((_e4578 - (_e4630 + (_e4635 * _e4605))) * _e4623) - 0.5f);
let _e4645 = global_5.member[_e360].member_8.member;
let _e4646 = bitcast<i32>(_e4645);
let _e4648 = (f32(_e4646) - 1f);
let _e4653 = global_5.member[_e360].member_8.member_1;
let _e4656 = (f32(bitcast<i32>(_e4653)) - 1f);
let _e4658 = select(0f, _e4625, (_e4625 > 0f));
let _e4660 = select(_e4648, _e4658, (_e4658 < _e4648));
let _e4667 = select(0i, select(select(i32(_e4660), i32(-2147483648), (_e4660 < -2147483600f)), 2147483647i, (_e4660 > 2147483500f)), (_e4660 == _e4660));
let _e4671 = (_e4667 - select(0i, 1i, (_e4660 < f32(_e4667))));
let _e4673 = select(0f, _e4640, (_e4640 > 0f));
let _e4675 = select(_e4656, _e4673, (_e4673 < _e4656));
let _e4682 = select(0i, select(select(i32(_e4675), i32(-2147483648), (_e4675 < -2147483600f)), 2147483647i, (_e4675 > 2147483500f)), (_e4675 == _e4675));
let _e4686 = (_e4682 - select(0i, 1i, (_e4675 < f32(_e4682))));
let _e4690 = (_e4625 - f32(_e4671));
let _e4692 = (_e4640 - f32(_e4686));
let _e4699 = ((((_e4625 >= 0f) && (_e4625 <= _e4648)) && (_e4640 >= 0f)) && (_e4640 <= _e4656));
let _e4703 = global_5.member[_e360].member_4;
let _e4704 = bitcast<i32>(_e4703);
let _e4706 = bitcast<i32>((_e4645 * _e4653));
let _e4708 = (_e4704 + (3i * _e4706));
local_1 = (_e4708 + ((_e4686 * _e4646) + _e4671));
let _e4710 = local_1;
let _e4712 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e4714 = select(_e4712, _e4710, (_e4710 < _e4712));
let _e4719 = global_6.member[bitcast<u32>(select(0i, _e4714, (_e4714 > 0i)))];
let _e4720 = bitcast<u32>(_e4719);
let _e4724 = f32((bitcast<i32>((_e4720 & 65535u)) - 32768i));
let _e4730 = f32((bitcast<i32>(((_e4720 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4735 = select(_e4730, -(_e4730), ((_e4720 >> bitcast<u32>(31i)) != 0u));
let _e4736 = local_1;
let _e4737 = (_e4736 + 1i);
let _e4739 = select(_e4712, _e4737, (_e4737 < _e4712));
let _e4744 = global_6.member[bitcast<u32>(select(0i, _e4739, (_e4739 > 0i)))];
let _e4745 = bitcast<u32>(_e4744);
let _e4755 = f32((bitcast<i32>(((_e4745 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4761 = local_1;
let _e4762 = (_e4761 + _e4646);
let _e4764 = select(_e4712, _e4762, (_e4762 < _e4712));
let _e4769 = global_6.member[bitcast<u32>(select(0i, _e4764, (_e4764 > 0i)))];
let _e4770 = bitcast<u32>(_e4769);
let _e4774 = f32((bitcast<i32>((_e4770 & 65535u)) - 32768i));
let _e4780 = f32((bitcast<i32>(((_e4770 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4785 = select(_e4780, -(_e4780), ((_e4770 >> bitcast<u32>(31i)) != 0u));
let _e4786 = (_e4646 + 1i);
let _e4787 = local_1;
let _e4788 = (_e4787 + _e4786);
let _e4790 = select(_e4712, _e4788, (_e4788 < _e4712));
let _e4795 = global_6.member[bitcast<u32>(select(0i, _e4790, (_e4790 > 0i)))];
let _e4796 = bitcast<u32>(_e4795);
let _e4806 = f32((bitcast<i32>(((_e4796 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4814 = (_e4724 + ((f32((bitcast<i32>((_e4745 & 65535u)) - 32768i)) - _e4724) * _e4690));
let _e4823 = (_e4735 + ((select(_e4755, -(_e4755), ((_e4745 >> bitcast<u32>(31i)) != 0u)) - _e4735) * _e4690));
let _e4836 = global_5.member[_e360].member_9.member;
let _e4839 = (1f / 16255f);
let _e4841 = (_e4836.member + (select(0f, (_e4814 + (((_e4774 + ((f32((bitcast<i32>((_e4796 & 65535u)) - 32768i)) - _e4774) * _e4690)) - _e4814) * _e4692)), _e4699) * _e4839));
let _e4843 = (_e4836.member_1 + (select(0f, (_e4823 + (((_e4785 + ((select(_e4806, -(_e4806), ((_e4796 >> bitcast<u32>(31i)) != 0u)) - _e4785) * _e4690)) - _e4823) * _e4692)), _e4699) * _e4839));
let _e4847 = (1f - ((_e4841 * _e4841) + (_e4843 * _e4843)));
let _e4849 = select(1e-4f, _e4847, (_e4847 > 1e-4f));
let _e4852 = sqrt(select(0f, _e4849, (_e4849 > 0f)));
let _e4856 = (1f / select(1e-6f, _e4852, (_e4852 > 1e-6f)));
let _e4857 = ((_e4579 - _e384) * _e4623);
let _e4864 = (_e4625 - (((_e4841 * _e4856) - _e4615) * _e4857));
let _e4865 = (_e4640 - (((_e4843 * _e4856) - _e4635) * _e4857));
let _e4867 = select(0f, _e4864, (_e4864 > 0f));
let _e4869 = select(_e4648, _e4867, (_e4867 < _e4648));
let _e4876 = select(0i, select(select(i32(_e4869), i32(-2147483648), (_e4869 < -2147483600f)), 2147483647i, (_e4869 > 2147483500f)), (_e4869 == _e4869));
let _e4880 = (_e4876 - select(0i, 1i, (_e4869 < f32(_e4876))));
let _e4882 = select(0f, _e4865, (_e4865 > 0f));
let _e4884 = select(_e4656, _e4882, (_e4882 < _e4656));
let _e4891 = select(0i, select(select(i32(_e4884), i32(-2147483648), (_e4884 < -2147483600f)), 2147483647i, (_e4884 > 2147483500f)), (_e4884 == _e4884));
let _e4895 = (_e4891 - select(0i, 1i, (_e4884 < f32(_e4891))));
let _e4897 = ((_e4895 * _e4646) + _e4880);
let _e4899 = (_e4864 - f32(_e4880));
let _e4901 = (_e4865 - f32(_e4895));
let _e4908 = ((((_e4864 >= 0f) && (_e4864 <= _e4648)) && (_e4865 >= 0f)) && (_e4865 <= _e4656));
let _e4909 = (_e4704 + _e4897);
let _e4911 = select(_e4712, _e4909, (_e4909 < _e4712));
let _e4917 = global_6.member[bitcast<u32>(select(0i, _e4911, (_e4911 > 0i)))];
let _e4918 = (_e4909 + 1i);
let _e4920 = select(_e4712, _e4918, (_e4918 < _e4712));
let _e4926 = global_6.member[bitcast<u32>(select(0i, _e4920, (_e4920 > 0i)))];
let _e4929 = (_e4917 + ((_e4926 - _e4917) * _e4899));
let _e4930 = (_e4909 + _e4646);
let _e4932 = select(_e4712, _e4930, (_e4930 < _e4712));
let _e4938 = global_6.member[bitcast<u32>(select(0i, _e4932, (_e4932 > 0i)))];
let _e4939 = (_e4930 + 1i);
let _e4941 = select(_e4712, _e4939, (_e4939 < _e4712));
let _e4947 = global_6.member[bitcast<u32>(select(0i, _e4941, (_e4941 > 0i)))];
let _e4954 = select(1f, (_e4929 + (((_e4938 + ((_e4947 - _e4938) * _e4899)) - _e4929) * _e4901)), _e4908);
if _e3645 {
phi_9227_ = vec3(_e4954);
} else {
let _e4957 = ((_e4704 + _e4706) + _e4897);
let _e4959 = select(_e4712, _e4957, (_e4957 < _e4712));
let _e4965 = global_6.member[bitcast<u32>(select(0i, _e4959, (_e4959 > 0i)))];
let _e4966 = (_e4957 + 1i);
let _e4968 = select(_e4712, _e4966, (_e4966 < _e4712));
let _e4974 = global_6.member[bitcast<u32>(select(0i, _e4968, (_e4968 > 0i)))];
let _e4977 = (_e4965 + ((_e4974 - _e4965) * _e4899));
let _e4978 = (_e4957 + _e4646);
let _e4980 = select(_e4712, _e4978, (_e4978 < _e4712));
let _e4986 = global_6.member[bitcast<u32>(select(0i, _e4980, (_e4980 > 0i)))];
let _e4987 = (_e4978 + 1i);
let _e4989 = select(_e4712, _e4987, (_e4987 < _e4712));
let _e4995 = global_6.member[bitcast<u32>(select(0i, _e4989, (_e4989 > 0i)))];
let _e5005 = ((_e4704 + (2i * _e4706)) + _e4897);
let _e5007 = select(_e4712, _e5005, (_e5005 < _e4712));
let _e5013 = global_6.member[bitcast<u32>(select(0i, _e5007, (_e5007 > 0i)))];
let _e5014 = (_e5005 + 1i);
let _e5016 = select(_e4712, _e5014, (_e5014 < _e4712));
let _e5022 = global_6.member[bitcast<u32>(select(0i, _e5016, (_e5016 > 0i)))];
let _e5025 = (_e5013 + ((_e5022 - _e5013) * _e4899));
let _e5026 = (_e5005 + _e4646);
let _e5028 = select(_e4712, _e5026, (_e5026 < _e4712));
let _e5034 = global_6.member[bitcast<u32>(select(0i, _e5028, (_e5028 > 0i)))];
let _e5035 = (_e5026 + 1i);
let _e5037 = select(_e4712, _e5035, (_e5035 < _e4712));
let _e5043 = global_6.member[bitcast<u32>(select(0i, _e5037, (_e5037 > 0i)))];
phi_9227_ = vec3<f32>(_e4954, select(1f, (_e4977 + (((_e4986 + ((_e4995 - _e4986) * _e4899)) - _e4977) * _e4901)), _e4908), select(1f, (_e5025 + (((_e5034 + ((_e5043 - _e5034) * _e4899)) - _e5025) * _e4901)), _e4908));
}
let _e5053 = phi_9227_;
local = (_e4708 + _e4897);
let _e5055 = local;
let _e5057 = select(_e4712, _e5055, (_e5055 < _e4712));
let _e5062 = global_6.member[bitcast<u32>(select(0i, _e5057, (_e5057 > 0i)))];
let _e5063 = bitcast<u32>(_e5062);
let _e5067 = f32((bitcast<i32>((_e5063 & 65535u)) - 32768i));
let _e5073 = f32((bitcast<i32>(((_e5063 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e5078 = select(_e5073, -(_e5073), ((_e5063 >> bitcast<u32>(31i)) != 0u));
let _e5079 = local;
let _e5080 = (_e5079 + 1i);
let _e5082 = select(_e4712, _e5080, (_e5080 < _e4712));
let _e5087 = global_6.member[bitcast<u32>(select(0i, _e5082, (_e5082 > 0i)))];
let _e5088 = bitcast<u32>(_e5087);
let _e5098 = f32((bitcast<i32>(((_e5088 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e5104 = local;
let _e5105 = (_e5104 + _e4646);
let _e5107 = select(_e4712, _e5105, (_e5105 < _e4712));
let _e5112 = global_6.member[bitcast<u32>(select(0i, _e5107, (_e5107 > 0i)))];
let _e5113 = bitcast<u32>(_e5112);
let _e5117 = f32((bitcast<i32>((_e5113 & 65535u)) - 32768i));
let _e5123 = f32((bitcast<i32>(((_e5113 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e5128 = select(_e5123, -(_e5123), ((_e5113 >> bitcast<u32>(31i)) != 0u));
let _e5129 = local;
let _e5130 = (_e5129 + _e4786);
let _e5132 = select(_e4712, _e5130, (_e5130 < _e4712));
let _e5137 = global_6.member[bitcast<u32>(select(0i, _e5132, (_e5132 > 0i)))];
let _e5138 = bitcast<u32>(_e5137);
let _e5148 = f32((bitcast<i32>(((_e5138 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e5156 = (_e5067 + ((f32((bitcast<i32>((_e5088 & 65535u)) - 32768i)) - _e5067) * _e4899));
let _e5165 = (_e5078 + ((select(_e5098, -(_e5098), ((_e5088 >> bitcast<u32>(31i)) != 0u)) - _e5078) * _e4899));
let _e5178 = global_5.member[_e360].member_9.member_1;
let _e5185 = (_e4836.member + (select(0f, (_e5156 + (((_e5117 + ((f32((bitcast<i32>((_e5138 & 65535u)) - 32768i)) - _e5117) * _e4899)) - _e5156) * _e4901)), _e4908) * _e4839));
let _e5187 = (_e4836.member_1 + (select(0f, (_e5165 + (((_e5128 + ((select(_e5148, -(_e5148), ((_e5138 >> bitcast<u32>(31i)) != 0u)) - _e5128) * _e4899)) - _e5165) * _e4901)), _e4908) * _e4839));
let _e5191 = (1f - ((_e5185 * _e5185) + (_e5187 * _e5187)));
let _e5193 = select(1e-4f, _e5191, (_e5191 > 1e-4f));
phi_9457_ = type_25((_e5053 * vec3<f32>(_e5178.member, _e5178.member_1, _e5178.member_2)), vec3<f32>(_e5185, _e5187, sqrt(select(0f, _e5193, (_e5193 > 0f)))));
}
let _e5200 = phi_9457_;
let _e5209 = (((_e5200.member_1.x * _e5200.member_1.x) + (_e5200.member_1.y * _e5200.member_1.y)) + (_e5200.member_1.z * _e5200.member_1.z));
let _e5212 = sqrt(select(0f, _e5209, (_e5209 > 0f)));
let _e5218 = (1e-6f * _e5212);
let _e5222 = select((_e5212 / select(_e5218, _e5200.member_1.z, (_e5200.member_1.z > _e5218))), 1f, ((_e932 & 8u) != 0u));
let _e5224 = (_e5200.member.x * _e5222);
let _e5226 = (_e5200.member.y * _e5222);
let _e5228 = (_e5200.member.z * _e5222);
if _e1048 {
let _e5233 = global_5.member[_e360].member_19;
let _e5242 = (((_e2721.member_1.x * _e2721.member_1.x) + (_e2721.member_1.y * _e2721.member_1.y)) + (_e2721.member_1.z * _e2721.member_1.z));
let _e5245 = sqrt(select(0f, _e5242, (_e5242 > 0f)));
let _e5248 = (1f / select(1e-20f, _e5245, (_e5245 > 1e-20f)));
let _e5249 = (_e2721.member_1.x * _e5248);
let _e5250 = (_e2721.member_1.y * _e5248);
let _e5251 = (_e2721.member_1.z * _e5248);
let _e5254 = (-1f / select(1e-20f, _e5212, (_e5212 > 1e-20f)));
let _e5255 = (_e5200.member_1.x * _e5254);
let _e5256 = (_e5200.member_1.y * _e5254);
let _e5257 = (_e5200.member_1.z * _e5254);
let _e5262 = (((_e364[3] * _e364[3]) + (_e364[4] * _e364[4])) + (_e364[5] * _e364[5]));
let _e5265 = sqrt(select(0f, _e5262, (_e5262 > 0f)));
let _e5268 = (-1f / select(1e-20f, _e5265, (_e5265 > 1e-20f)));
let _e5269 = (_e364[3] * _e5268);
let _e5270 = (_e364[4] * _e5268);
let _e5271 = (_e364[5] * _e5268);
let _e5278 = select(1f, -1f, ((((_e5249 * _e5269) + (_e5250 * _e5270)) + (_e5251 * _e5271)) < 0f));
let _e5279 = (_e5249 * _e5278);
let _e5280 = (_e5250 * _e5278);
let _e5281 = (_e5251 * _e5278);
let _e5286 = (((_e5279 * _e5269) + (_e5280 * _e5270)) + (_e5281 * _e5271));
let _e5288 = select(1e-4f, _e5286, (_e5286 > 1e-4f));
let _e5293 = (((_e5279 * _e5255) + (_e5280 * _e5256)) + (_e5281 * _e5257));
let _e5294 = (_e5255 + _e5269);
let _e5295 = (_e5256 + _e5270);
let _e5296 = (_e5257 + _e5271);
let _e5301 = (((_e5294 * _e5294) + (_e5295 * _e5295)) + (_e5296 * _e5296));
let _e5304 = sqrt(select(0f, _e5301, (_e5301 > 0f)));
let _e5307 = (1f / select(1e-6f, _e5304, (_e5304 > 1e-6f)));
let _e5308 = (_e5294 * _e5307);
let _e5309 = (_e5295 * _e5307);
let _e5310 = (_e5296 * _e5307);
let _e5315 = (((_e5279 * _e5308) + (_e5280 * _e5309)) + (_e5281 * _e5310));
let _e5317 = select(0f, _e5315, (_e5315 > 0f));
let _e5322 = (((_e5269 * _e5308) + (_e5270 * _e5309)) + (_e5271 * _e5310));
let _e5324 = select(0f, _e5322, (_e5322 > 0f));
let _e5325 = (_e5233 * _e5233);
let _e5326 = (_e5325 * _e5325);
let _e5330 = (((_e5317 * _e5317) * (_e5326 - 1f)) + 1f);
let _e5334 = (_e5293 > 0f);
let _e5335 = select(0f, _e5293, _e5334);
let _e5337 = (1f - _e5326);
let _e5339 = (((_e5335 * _e5335) * _e5337) + _e5326);
let _e5346 = (((_e5288 * _e5288) * _e5337) + _e5326);
let _e5351 = ((_e5288 * sqrt(select(0f, _e5339, (_e5339 > 0f)))) + (_e5335 * sqrt(select(0f, _e5346, (_e5346 > 0f)))));
let _e5356 = (_e2721.member_2 / _e3323);
let _e5360 = (((_e5356 * _e5356) - 1f) + (_e5324 * _e5324));
let _e5363 = sqrt(select(0f, _e5360, (_e5360 > 0f)));
let _e5364 = (_e5363 - _e5324);
let _e5365 = (_e5363 + _e5324);
let _e5368 = (_e5364 / select(1e-6f, _e5365, (_e5365 > 1e-6f)));
let _e5372 = ((_e5324 * _e5364) + 1f);
let _e5375 = (((_e5324 * _e5365) - 1f) / select(1e-6f, _e5372, (_e5372 > 1e-6f)));
let _e5393 = global_5.member[_e360].member_20;
let _e5397 = ((select(0f, ((((_e5326 / ((3.1415927f * _e5330) * _e5330)) * (0.5f / select(1e-6f, _e5351, (_e5351 > 1e-6f)))) * select(select((((0.5f * _e5368) * _e5368) * (1f + (_e5375 * _e5375))), 1f, (_e5360 <= 0f)), 0f, (_e3323 == _e2721.member_2))) * _e5335), (_e5334 && (_e5245 > 1e-12f))) * _e5393) * select(_e3539.member_2, 0f, _e452));
phi_9775_ = vec3<f32>((_e5224 * _e5397), (_e5226 * _e5397), (_e5228 * _e5397));
} else {
phi_9775_ = vec3<f32>(0f, 0f, 0f);
}
let _e5403 = phi_9775_;
let _e5407 = global_5.member[_e360].member_18;
let _e5414 = (1f - _e364[12]);
let _e5434 = (_e364[9] + ((_e364[13] * ((_e4572.member_3.x * (_e5224 + _e5407.member)) + _e5403.x)) * _e5414));
let _e5435 = (_e364[10] + ((_e364[14] * ((_e4572.member_3.y * (_e5226 + _e5407.member_1)) + _e5403.y)) * _e5414));
let _e5436 = (_e364[11] + ((_e364[15] * ((_e4572.member_3.z * (_e5228 + _e5407.member_2)) + _e5403.z)) * _e5414));
let _e5439 = (_e364[12] + (_e5414 * _e4572.member_1));
let _e5442 = (_e364[13] * _e4572.member_2.x);
let _e5444 = (_e364[14] * _e4572.member_2.y);
let _e5446 = (_e364[15] * _e4572.member_2.z);
let _e5451 = (_e364[8] + ((_e5439 - _e364[12]) * (_e384 + (_e3628 * 0.5f))));
let _e5460 = (-((((select(_e1018.member, _e1005.member, _e998) * _e5200.member_1.x) + (select(_e1018.member_1, _e1005.member_1, _e998) * _e5200.member_1.y)) + (select(_e1018.member_2, _e1005.member_2, _e998) * _e5200.member_1.z))) / select(1e-20f, _e5212, (_e5212 > 1e-20f)));
let _e5465 = bitcast<f32>((bitcast<u32>(select(0f, _e5460, (_e5460 > 0f))) & 2147483647u));
let _e5475 = (1f - _e5439);
let _e5488 = select(_e5439, 1f, _e452);
if _e1048 {
let _e5497 = global_5.member[_e360].member_5.member_4;
let _e5500 = (_e2721.member_3.x * _e3539.member_2);
let _e5502 = (_e2721.member_3.y * _e3539.member_2);
let _e5504 = (_e2721.member_3.z * _e3539.member_2);
let _e5505 = (0.5f * _e379);
let _e5509 = (_e364[3] + (_e5500 * _e5505));
let _e5510 = (_e364[4] + (_e5502 * _e5505));
let _e5511 = (_e364[5] + (_e5504 * _e5505));
let _e5513 = (2f * _e378);
let _e5515 = ((_e5511 * _e5511) + (_e5513 * _e5504));
let _e5519 = (_e5511 + sqrt(select(0f, _e5515, (_e5515 > 0f))));
let _e5523 = (0.5f * (_e5513 / select(1e-6f, _e5519, (_e5519 > 1e-6f))));
let _e5527 = (_e5509 + (_e5500 * _e5523));
let _e5528 = (_e5510 + (_e5502 * _e5523));
let _e5529 = (_e5511 + (_e5504 * _e5523));
let _e5533 = (_e5497 * _e5497);
let _e5535 = (_e5529 * _e5529);
let _e5543 = (((_e5511 <= 0f) || (_e5515 <= 0f)) || ((_e5529 <= 0f) || (_e5535 <= (_e5533 * (((_e5527 * _e5527) + (_e5528 * _e5528)) + _e5535)))));
let _e5557 = (_e364[3] + ((_e2721.member_4.x * _e3539.member_2) * _e378));
let _e5558 = (_e364[4] + ((_e2721.member_4.y * _e3539.member_2) * _e378));
let _e5559 = (_e364[5] + ((_e2721.member_4.z * _e3539.member_2) * _e378));
let _e5561 = (_e5559 * _e5559);
let _e5570 = ((_e932 & 1u) != 0u);
phi_10080_ = vec3<f32>(select(select(_e5527, _e5509, _e5543), _e5557, _e5570), select(select(_e5528, _e5510, _e5543), _e5558, _e5570), select(select(_e5529, _e5511, _e5543), _e5559, _e5570));
phi_10081_ = select(_e5543, ((_e5559 <= 0f) || (_e5561 <= (_e5533 * (((_e5557 * _e5557) + (_e5558 * _e5558)) + _e5561)))), _e5570);
} else {
phi_10080_ = vec3<f32>(_e364[3], _e364[4], _e364[5]);
phi_10081_ = false;
}
let _e5577 = phi_10080_;
let _e5579 = phi_10081_;
let _e5588 = (((_e452 || (_e5577.x != _e364[3])) || (_e5577.y != _e364[4])) || (_e5577.z != _e364[5]));
let _e5590 = select(_e5444, _e5442, (_e5442 > _e5444));
phi_10146_ = array<f32, 18>(select(_e364[0], select(_e392, _e4577, _e452), _e5588), select(_e364[1], select(_e394, _e4578, _e452), _e5588), select(_e364[2], select(_e399, _e4579, _e452), _e5588), _e5577.x, _e5577.y, _e5577.z, _e2721.member, select(select(0f, 2f, _e5579), 1f, (_e452 || (((1f - _e5488) * select(_e5446, _e5590, (_e5590 > _e5446))) < 9.765625e-4f))), select(_e5451, (_e5451 + (_e5475 * _e4579)), _e452), select(_e5434, (_e5434 + ((_e5442 * (select(_e1024.member, _e1011.member, _e998) * ((_e5224 * _e5465) + _e5407.member))) * _e5475)), _e452), select(_e5435, (_e5435 + ((_e5444 * (select(_e1024.member_1, _e1011.member_1, _e998) * ((_e5226 * _e5465) + _e5407.member_1))) * _e5475)), _e452), select(_e5436, (_e5436 + ((_e5446 * (select(_e1024.member_2, _e1011.member_2, _e998) * ((_e5228 * _e5465) + _e5407.member_2))) * _e5475)), _e452), _e5488, _e5442, _e5444, _e5446, _e2721.member_2, _e399);
} else {
phi_10146_ = _e364;
}
let _e5609 = phi_10146_;
phi_590_ = (_e360 + 1u);
phi_593_ = select(_e362, true, _e970);
phi_595_ = _e5609;
} else {
phi_590_ = u32();
phi_593_ = bool();
phi_595_ = array<f32, 18>();
}
let _e5613 = phi_590_;
let _e5615 = phi_593_;
let _e5617 = phi_595_;
continue;
continuing {
phi_589_ = _e5613;
phi_592_ = _e5615;
phi_594_ = _e5617;
phi_10229_ = false;
break if !(_e365);
}
}
let _e5620 = phi_10229_;
if _e5620 {
break;
}
let _e5622 = local_12;
if _e5622 {
let _e5624 = local_13;
global_4.member[_e160] = _e5624[0];
let _e5629 = local_14;
global_4.member[_e172] = _e5629[1];
let _e5634 = local_15;
global_4.member[_e183] = _e5634[2];
let _e5639 = local_16;
global_4.member[_e194] = _e5639[3];
let _e5644 = local_17;
global_4.member[_e205] = _e5644[4];
let _e5649 = local_18;
global_4.member[_e216] = _e5649[5];
let _e5654 = local_19;
global_4.member[_e227] = _e5654[6];
let _e5659 = local_20;
global_4.member[_e238] = _e5659[7];
let _e5664 = local_21;
global_4.member[_e249] = _e5664[8];
let _e5669 = local_22;
global_4.member[_e260] = _e5669[9];
let _e5674 = local_23;
global_4.member[_e271] = _e5674[10];
let _e5679 = local_24;
global_4.member[_e282] = _e5679[11];
let _e5684 = local_25;
global_4.member[_e293] = _e5684[12];
let _e5689 = local_26;
global_4.member[_e304] = _e5689[13];
let _e5694 = local_27;
global_4.member[_e315] = _e5694[14];
let _e5699 = local_28;
global_4.member[_e326] = _e5699[15];
let _e5704 = local_29;
global_4.member[_e337] = _e5704[16];
let _e5709 = local_30;
global_4.member[_e348] = _e5709[17];
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
