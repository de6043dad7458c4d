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
var phi_586_: u32;
var phi_589_: bool;
var phi_591_: array<f32, 18>;
var phi_5023_: type_29;
var phi_5669_: type_30;
var phi_6748_: f32;
var phi_7137_: type_5;
var phi_8695_: type_31;
var phi_9448_: vec3<f32>;
var phi_9678_: type_25;
var phi_9996_: vec3<f32>;
var phi_10305_: f32;
var phi_10306_: f32;
var phi_10307_: f32;
var phi_10308_: bool;
var phi_10368_: array<f32, 18>;
var phi_587_: u32;
var phi_590_: bool;
var phi_592_: array<f32, 18>;
var phi_10451_: bool;
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
let _e118 = global;
let _e120 = arrayLength((&global_5.member));
let _e123 = arrayLength((&global_1.member));
let _e126 = arrayLength((&global_7.member));
let _e130 = arrayLength((&global_3.member));
if (0u < _e120) {
} else {
break;
}
let _e140 = global_5.member[0u].member_2;
let _e144 = global_5.member[0u].member;
let _e152 = (_e118.x + _e140.member);
let _e154 = (_e118.y + _e140.member_1);
if (_e152 < _e140.member_2) {
if (_e154 < _e140.member_3) {
let _e157 = (_e144.member * _e144.member_1);
let _e159 = ((_e154 * _e144.member) + _e152);
let _e160 = bitcast<i32>(_e159);
let _e162 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e164 = select(_e162, _e160, (_e160 < _e162));
let _e170 = global_4.member[bitcast<u32>(select(0i, _e164, (_e164 > 0i)))];
let _e171 = (_e157 + _e159);
let _e172 = bitcast<i32>(_e171);
let _e174 = select(_e162, _e172, (_e172 < _e162));
let _e180 = global_4.member[bitcast<u32>(select(0i, _e174, (_e174 > 0i)))];
let _e182 = ((2u * _e157) + _e159);
let _e183 = bitcast<i32>(_e182);
let _e185 = select(_e162, _e183, (_e183 < _e162));
let _e191 = global_4.member[bitcast<u32>(select(0i, _e185, (_e185 > 0i)))];
let _e193 = ((3u * _e157) + _e159);
let _e194 = bitcast<i32>(_e193);
let _e196 = select(_e162, _e194, (_e194 < _e162));
let _e202 = global_4.member[bitcast<u32>(select(0i, _e196, (_e196 > 0i)))];
let _e204 = ((4u * _e157) + _e159);
let _e205 = bitcast<i32>(_e204);
let _e207 = select(_e162, _e205, (_e205 < _e162));
let _e213 = global_4.member[bitcast<u32>(select(0i, _e207, (_e207 > 0i)))];
let _e215 = ((5u * _e157) + _e159);
let _e216 = bitcast<i32>(_e215);
let _e218 = select(_e162, _e216, (_e216 < _e162));
let _e224 = global_4.member[bitcast<u32>(select(0i, _e218, (_e218 > 0i)))];
let _e226 = ((6u * _e157) + _e159);
let _e227 = bitcast<i32>(_e226);
let _e229 = select(_e162, _e227, (_e227 < _e162));
let _e235 = global_4.member[bitcast<u32>(select(0i, _e229, (_e229 > 0i)))];
let _e237 = ((7u * _e157) + _e159);
let _e238 = bitcast<i32>(_e237);
let _e240 = select(_e162, _e238, (_e238 < _e162));
let _e246 = global_4.member[bitcast<u32>(select(0i, _e240, (_e240 > 0i)))];
let _e248 = ((8u * _e157) + _e159);
let _e249 = bitcast<i32>(_e248);
let _e251 = select(_e162, _e249, (_e249 < _e162));
let _e257 = global_4.member[bitcast<u32>(select(0i, _e251, (_e251 > 0i)))];
let _e259 = ((9u * _e157) + _e159);
let _e260 = bitcast<i32>(_e259);
let _e262 = select(_e162, _e260, (_e260 < _e162));
let _e268 = global_4.member[bitcast<u32>(select(0i, _e262, (_e262 > 0i)))];
let _e270 = ((10u * _e157) + _e159);
let _e271 = bitcast<i32>(_e270);
let _e273 = select(_e162, _e271, (_e271 < _e162));
let _e279 = global_4.member[bitcast<u32>(select(0i, _e273, (_e273 > 0i)))];
let _e281 = ((11u * _e157) + _e159);
let _e282 = bitcast<i32>(_e281);
let _e284 = select(_e162, _e282, (_e282 < _e162));
let _e290 = global_4.member[bitcast<u32>(select(0i, _e284, (_e284 > 0i)))];
let _e292 = ((12u * _e157) + _e159);
let _e293 = bitcast<i32>(_e292);
let _e295 = select(_e162, _e293, (_e293 < _e162));
let _e301 = global_4.member[bitcast<u32>(select(0i, _e295, (_e295 > 0i)))];
let _e303 = ((13u * _e157) + _e159);
let _e304 = bitcast<i32>(_e303);
let _e306 = select(_e162, _e304, (_e304 < _e162));
let _e312 = global_4.member[bitcast<u32>(select(0i, _e306, (_e306 > 0i)))];
let _e314 = ((14u * _e157) + _e159);
let _e315 = bitcast<i32>(_e314);
let _e317 = select(_e162, _e315, (_e315 < _e162));
let _e323 = global_4.member[bitcast<u32>(select(0i, _e317, (_e317 > 0i)))];
let _e325 = ((15u * _e157) + _e159);
let _e326 = bitcast<i32>(_e325);
let _e328 = select(_e162, _e326, (_e326 < _e162));
let _e334 = global_4.member[bitcast<u32>(select(0i, _e328, (_e328 > 0i)))];
let _e336 = ((16u * _e157) + _e159);
let _e337 = bitcast<i32>(_e336);
let _e339 = select(_e162, _e337, (_e337 < _e162));
let _e345 = global_4.member[bitcast<u32>(select(0i, _e339, (_e339 > 0i)))];
let _e347 = ((17u * _e157) + _e159);
let _e348 = bitcast<i32>(_e347);
let _e350 = select(_e162, _e348, (_e348 < _e162));
let _e356 = global_4.member[bitcast<u32>(select(0i, _e350, (_e350 > 0i)))];
phi_586_ = 0u;
phi_589_ = false;
phi_591_ = array<f32, 18>(_e170, _e180, _e191, _e202, _e213, _e224, _e235, _e246, _e257, _e268, _e279, _e290, _e301, _e312, _e323, _e334, _e345, _e356);
loop {
let _e359 = phi_586_;
let _e361 = phi_589_;
let _e363 = phi_591_;
local_12 = _e361;
local_13 = _e363;
local_14 = _e363;
local_15 = _e363;
local_16 = _e363;
local_17 = _e363;
local_18 = _e363;
local_19 = _e363;
local_20 = _e363;
local_21 = _e363;
local_22 = _e363;
local_23 = _e363;
local_24 = _e363;
local_25 = _e363;
local_26 = _e363;
local_27 = _e363;
local_28 = _e363;
local_29 = _e363;
local_30 = _e363;
let _e364 = (_e359 < _e120);
if _e364 {
if _e364 {
} else {
phi_10451_ = true;
break;
}
let _e372 = global_5.member[_e359].member_5.member_2;
let _e373 = (_e372 / _e363[4]);
let _e378 = global_5.member[_e359].member_5.member;
let _e381 = ((_e378 - _e363[16]) / _e363[4]);
let _e384 = (_e363[0] + (_e363[2] * _e381));
let _e387 = (_e363[1] + (_e363[3] * _e381));
let _e389 = (_e384 + (_e363[2] * _e373));
let _e391 = (_e387 + (_e363[3] * _e373));
let _e396 = global_5.member[_e359].member_5.member_1;
let _e402 = global_5.member[_e359].member_13.member.member;
let _e413 = ((((_e402.member.member * _e384) + (_e402.member.member_1 * _e387)) + (_e402.member.member_2 * _e378)) + _e402.member_1);
let _e419 = ((((_e402.member.member * _e389) + (_e402.member.member_1 * _e391)) + (_e402.member.member_2 * _e396)) + _e402.member_1);
let _e422 = ((_e413 > 0f) && (_e419 <= 0f));
let _e428 = global_5.member[_e359].member_13.member_1.member;
let _e439 = ((((_e428.member.member * _e384) + (_e428.member.member_1 * _e387)) + (_e428.member.member_2 * _e378)) + _e428.member_1);
let _e445 = ((((_e428.member.member * _e389) + (_e428.member.member_1 * _e391)) + (_e428.member.member_2 * _e396)) + _e428.member_1);
let _e448 = ((_e439 > 0f) && (_e445 <= 0f));
let _e449 = (_e422 || _e448);
let _e454 = global_5.member[_e359].member_6.member;
let _e465 = ((((_e454.member.member * _e384) + (_e454.member.member_1 * _e387)) + (_e454.member.member_2 * _e378)) + _e454.member_1);
let _e470 = global_5.member[_e359].member_6.member_1;
let _e481 = ((((_e470.member.member * _e384) + (_e470.member.member_1 * _e387)) + (_e470.member.member_2 * _e378)) + _e470.member_1);
let _e486 = global_5.member[_e359].member_6.member_2;
let _e497 = ((((_e486.member.member * _e384) + (_e486.member.member_1 * _e387)) + (_e486.member.member_2 * _e378)) + _e486.member_1);
let _e503 = ((((_e454.member.member * _e389) + (_e454.member.member_1 * _e391)) + (_e454.member.member_2 * _e396)) + _e454.member_1);
let _e509 = ((((_e470.member.member * _e389) + (_e470.member.member_1 * _e391)) + (_e470.member.member_2 * _e396)) + _e470.member_1);
let _e515 = ((((_e486.member.member * _e389) + (_e486.member.member_1 * _e391)) + (_e486.member.member_2 * _e396)) + _e486.member_1);
let _e520 = global_5.member[_e359].member_6.member_4;
let _e526 = global_5.member[_e359].member_6.member_3.member;
let _e527 = (_e526 - 0.5f);
let _e529 = select(-0.5f, _e503, (_e503 > -0.5f));
let _e531 = select(_e527, _e529, (_e529 < _e527));
let _e537 = global_5.member[_e359].member_6.member_3.member_1;
let _e538 = (_e537 - 0.5f);
let _e540 = select(-0.5f, _e509, (_e509 > -0.5f));
let _e542 = select(_e538, _e540, (_e540 < _e538));
let _e548 = global_5.member[_e359].member_6.member_3.member_2;
let _e549 = (_e548 - 0.5f);
let _e551 = select(-0.5f, _e515, (_e515 > -0.5f));
let _e553 = select(_e549, _e551, (_e551 < _e549));
let _e554 = (_e503 - _e465);
let _e555 = (_e509 - _e481);
let _e556 = (_e515 - _e497);
let _e559 = bitcast<f32>((bitcast<u32>(_e554) & 2147483647u));
let _e562 = bitcast<f32>((bitcast<u32>(_e555) & 2147483647u));
let _e564 = select(_e562, _e559, (_e559 > _e562));
let _e567 = bitcast<f32>((bitcast<u32>(_e556) & 2147483647u));
let _e576 = bitcast<f32>((bitcast<u32>((_e503 - _e531)) & 2147483647u));
let _e579 = bitcast<f32>((bitcast<u32>((_e509 - _e542)) & 2147483647u));
let _e581 = select(_e579, _e576, (_e576 > _e579));
let _e584 = bitcast<f32>((bitcast<u32>((_e515 - _e553)) & 2147483647u));
let _e588 = (_e531 + 0.5f);
let _e589 = (_e526 - 1f);
let _e591 = select(0f, _e588, (_e588 > 0f));
let _e593 = select(_e589, _e591, (_e591 < _e589));
let _e600 = select(0i, select(select(i32(_e593), i32(-2147483648), (_e593 < -2147483600f)), 2147483647i, (_e593 > 2147483500f)), (_e593 == _e593));
let _e609 = global_5.member[_e359].member_6.member_12;
let _e610 = (_e609 & 31u);
let _e613 = (_e542 + 0.5f);
let _e614 = (_e537 - 1f);
let _e616 = select(0f, _e613, (_e613 > 0f));
let _e618 = select(_e614, _e616, (_e616 < _e614));
let _e625 = select(0i, select(select(i32(_e618), i32(-2147483648), (_e618 < -2147483600f)), 2147483647i, (_e618 > 2147483500f)), (_e618 == _e618));
let _e632 = (_e553 + 0.5f);
let _e633 = (_e548 - 1f);
let _e635 = select(0f, _e632, (_e632 > 0f));
let _e637 = select(_e633, _e635, (_e635 < _e633));
let _e644 = select(0i, select(select(i32(_e637), i32(-2147483648), (_e637 < -2147483600f)), 2147483647i, (_e637 > 2147483500f)), (_e637 == _e637));
let _e656 = global_5.member[_e359].member_6.member_9.member;
let _e663 = global_5.member[_e359].member_6.member_9.member_1;
let _e669 = global_5.member[_e359].member_6.member_10;
let _e675 = ((bitcast<i32>(_e669) + ((_e600 - select(0i, 1i, (_e593 < f32(_e600)))) >> bitcast<u32>(_e610))) + (bitcast<i32>(_e656) * (((_e625 - select(0i, 1i, (_e618 < f32(_e625)))) >> bitcast<u32>(_e610)) + (bitcast<i32>(_e663) * ((_e644 - select(0i, 1i, (_e637 < f32(_e644)))) >> bitcast<u32>(_e610))))));
let _e677 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e679 = select(_e677, _e675, (_e675 < _e677));
let _e685 = global_2.member[bitcast<u32>(select(0i, _e679, (_e679 > 0i)))];
let _e693 = global_5.member[_e359].member_7.member;
let _e704 = ((((_e693.member.member * _e384) + (_e693.member.member_1 * _e387)) + (_e693.member.member_2 * _e378)) + _e693.member_1);
let _e709 = global_5.member[_e359].member_7.member_1;
let _e720 = ((((_e709.member.member * _e384) + (_e709.member.member_1 * _e387)) + (_e709.member.member_2 * _e378)) + _e709.member_1);
let _e725 = global_5.member[_e359].member_7.member_2;
let _e736 = ((((_e725.member.member * _e384) + (_e725.member.member_1 * _e387)) + (_e725.member.member_2 * _e378)) + _e725.member_1);
let _e742 = ((((_e693.member.member * _e389) + (_e693.member.member_1 * _e391)) + (_e693.member.member_2 * _e396)) + _e693.member_1);
let _e748 = ((((_e709.member.member * _e389) + (_e709.member.member_1 * _e391)) + (_e709.member.member_2 * _e396)) + _e709.member_1);
let _e754 = ((((_e725.member.member * _e389) + (_e725.member.member_1 * _e391)) + (_e725.member.member_2 * _e396)) + _e725.member_1);
let _e759 = global_5.member[_e359].member_7.member_4;
let _e765 = global_5.member[_e359].member_7.member_3.member;
let _e766 = (_e765 - 0.5f);
let _e768 = select(-0.5f, _e742, (_e742 > -0.5f));
let _e770 = select(_e766, _e768, (_e768 < _e766));
let _e776 = global_5.member[_e359].member_7.member_3.member_1;
let _e777 = (_e776 - 0.5f);
let _e779 = select(-0.5f, _e748, (_e748 > -0.5f));
let _e781 = select(_e777, _e779, (_e779 < _e777));
let _e787 = global_5.member[_e359].member_7.member_3.member_2;
let _e788 = (_e787 - 0.5f);
let _e790 = select(-0.5f, _e754, (_e754 > -0.5f));
let _e792 = select(_e788, _e790, (_e790 < _e788));
let _e798 = bitcast<f32>((bitcast<u32>((_e742 - _e704)) & 2147483647u));
let _e801 = bitcast<f32>((bitcast<u32>((_e748 - _e720)) & 2147483647u));
let _e803 = select(_e801, _e798, (_e798 > _e801));
let _e806 = bitcast<f32>((bitcast<u32>((_e754 - _e736)) & 2147483647u));
let _e815 = bitcast<f32>((bitcast<u32>((_e742 - _e770)) & 2147483647u));
let _e818 = bitcast<f32>((bitcast<u32>((_e748 - _e781)) & 2147483647u));
let _e820 = select(_e818, _e815, (_e815 > _e818));
let _e823 = bitcast<f32>((bitcast<u32>((_e754 - _e792)) & 2147483647u));
let _e827 = (_e770 + 0.5f);
let _e828 = (_e765 - 1f);
let _e830 = select(0f, _e827, (_e827 > 0f));
let _e832 = select(_e828, _e830, (_e830 < _e828));
let _e839 = select(0i, select(select(i32(_e832), i32(-2147483648), (_e832 < -2147483600f)), 2147483647i, (_e832 > 2147483500f)), (_e832 == _e832));
let _e848 = global_5.member[_e359].member_7.member_12;
let _e849 = (_e848 & 31u);
let _e852 = (_e781 + 0.5f);
let _e853 = (_e776 - 1f);
let _e855 = select(0f, _e852, (_e852 > 0f));
let _e857 = select(_e853, _e855, (_e855 < _e853));
let _e864 = select(0i, select(select(i32(_e857), i32(-2147483648), (_e857 < -2147483600f)), 2147483647i, (_e857 > 2147483500f)), (_e857 == _e857));
let _e871 = (_e792 + 0.5f);
let _e872 = (_e787 - 1f);
let _e874 = select(0f, _e871, (_e871 > 0f));
let _e876 = select(_e872, _e874, (_e874 < _e872));
let _e883 = select(0i, select(select(i32(_e876), i32(-2147483648), (_e876 < -2147483600f)), 2147483647i, (_e876 > 2147483500f)), (_e876 == _e876));
let _e895 = global_5.member[_e359].member_7.member_9.member;
let _e902 = global_5.member[_e359].member_7.member_9.member_1;
let _e908 = global_5.member[_e359].member_7.member_10;
let _e914 = ((bitcast<i32>(_e908) + ((_e839 - select(0i, 1i, (_e832 < f32(_e839)))) >> bitcast<u32>(_e849))) + (bitcast<i32>(_e895) * (((_e864 - select(0i, 1i, (_e857 < f32(_e864)))) >> bitcast<u32>(_e849)) + (bitcast<i32>(_e902) * ((_e883 - select(0i, 1i, (_e876 < f32(_e883)))) >> bitcast<u32>(_e849))))));
let _e916 = select(_e677, _e914, (_e914 < _e677));
let _e922 = global_2.member[bitcast<u32>(select(0i, _e916, (_e916 > 0i)))];
let _e929 = global_5.member[_e359].member_1;
let _e962 = (_e363[17] != _e378);
let _e969 = (select(0u, select(select(select(select(7u, 3u, (((((((_e465 >= 0f) && (_e465 <= _e589)) && (_e481 >= 0f)) && (_e481 <= _e614)) && (_e497 >= 0f)) && (_e497 <= _e633)) && ((((((_e503 >= 0f) && (_e503 <= _e589)) && (_e509 >= 0f)) && (_e509 <= _e614)) && (_e515 >= 0f)) && (_e515 <= _e633)))), 15u, _e962), 1u, (((_e929 & 64u) != 0u) || ((((select(_e567, _e564, (_e564 > _e567)) <= _e520) && ((select(_e584, _e581, (_e581 > _e584)) > _e520) || (_e685 != 0u))) && ((select(_e806, _e803, (_e803 > _e806)) <= _e759) && ((select(_e823, _e820, (_e820 > _e823)) > _e759) || (_e922 != 0u)))) && ((_e929 & 32u) != 0u)))), 31u, _e449), (_e363[6] == 0f)) > 1u);
if _e969 {
let _e973 = global_5.member[_e359].member;
let _e975 = (_e413 - _e419);
let _e978 = (_e413 / select(1e-20f, _e975, (_e975 > 1e-20f)));
let _e979 = (_e439 - _e445);
let _e982 = (_e439 / select(1e-20f, _e979, (_e979 > 1e-20f)));
let _e986 = (_e448 && (!(_e422) || (_e982 < _e978)));
let _e993 = global_5.member[_e359].member_13.member_1.member.member;
let _e999 = global_5.member[_e359].member_13.member_1.member_1;
let _e1006 = global_5.member[_e359].member_13.member.member.member;
let _e1012 = global_5.member[_e359].member_13.member.member_1;
let _e1031 = select(_e978, _e982, _e986);
let _e1033 = (_e973.member_2 == 2u);
let _e1036 = (((_e973.member_2 == 1u) || _e1033) || (_e973.member_2 == 5u));
if _e1036 {
let _e1038 = select(-1f, _e531, (_e531 > -1f));
let _e1040 = select(_e526, _e1038, (_e1038 < _e526));
let _e1047 = select(0i, select(select(i32(_e1040), i32(-2147483648), (_e1040 < -2147483600f)), 2147483647i, (_e1040 > 2147483500f)), (_e1040 == _e1040));
let _e1051 = (_e1047 - select(0i, 1i, (_e1040 < f32(_e1047))));
let _e1053 = select(-1f, _e542, (_e542 > -1f));
let _e1055 = select(_e537, _e1053, (_e1053 < _e537));
let _e1062 = select(0i, select(select(i32(_e1055), i32(-2147483648), (_e1055 < -2147483600f)), 2147483647i, (_e1055 > 2147483500f)), (_e1055 == _e1055));
let _e1066 = (_e1062 - select(0i, 1i, (_e1055 < f32(_e1062))));
let _e1068 = select(-1f, _e553, (_e553 > -1f));
let _e1070 = select(_e548, _e1068, (_e1068 < _e548));
let _e1077 = select(0i, select(select(i32(_e1070), i32(-2147483648), (_e1070 < -2147483600f)), 2147483647i, (_e1070 > 2147483500f)), (_e1070 == _e1070));
let _e1081 = (_e1077 - select(0i, 1i, (_e1070 < f32(_e1077))));
let _e1086 = global_5.member[_e359].member_6.member_7;
let _e1091 = global_5.member[_e359].member_6.member_8;
let _e1099 = (select(0i, select(select(i32(_e537), i32(-2147483648), (_e537 < -2147483600f)), 2147483647i, (_e537 > 2147483500f)), (_e537 == _e537)) - 1i);
let _e1102 = (_e1066 + 1i);
let _e1112 = (select(0i, select(select(i32(_e548), i32(-2147483648), (_e548 < -2147483600f)), 2147483647i, (_e548 > 2147483500f)), (_e548 == _e548)) - 1i);
let _e1115 = (_e1081 + 1i);
let _e1125 = (select(0i, select(select(i32(_e526), i32(-2147483648), (_e526 < -2147483600f)), 2147483647i, (_e526 > 2147483500f)), (_e526 == _e526)) - 1i);
let _e1126 = (_e1051 - 1i);
let _e1131 = (_e1051 + 1i);
let _e1134 = (_e1051 + 2i);
let _e1137 = (select(0i, _e1066, (_e1066 > 0i)) * _e1086);
let _e1138 = (select(_e1099, _e1102, (_e1102 < _e1099)) * _e1086);
let _e1139 = (select(0i, _e1081, (_e1081 > 0i)) * _e1091);
let _e1140 = (select(_e1112, _e1115, (_e1115 < _e1112)) * _e1091);
local_10 = type_28(array<i32, 4>(select(0i, _e1126, (_e1126 > 0i)), select(0i, _e1051, (_e1051 > 0i)), select(_e1125, _e1131, (_e1131 < _e1125)), select(_e1125, _e1134, (_e1134 < _e1125))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_11 = vec3<f32>((_e531 - f32(_e1051)), (_e542 - f32(_e1066)), (_e553 - f32(_e1081)));
let _e1151 = (_e1139 + _e1137);
let _e1153 = (bitcast<i32>(_e123) - 1i);
let _e1156 = local_10.member[1u];
let _e1157 = (_e1151 + _e1156);
let _e1159 = select(_e1153, _e1157, (_e1157 < _e1153));
let _e1164 = global_1.member[bitcast<u32>(select(0i, _e1159, (_e1159 > 0i)))];
let _e1165 = bitcast<f32>(_e1164);
let _e1168 = local_10.member[2u];
let _e1169 = (_e1151 + _e1168);
let _e1171 = select(_e1153, _e1169, (_e1169 < _e1153));
let _e1176 = global_1.member[bitcast<u32>(select(0i, _e1171, (_e1171 > 0i)))];
let _e1178 = local_11[0u];
let _e1181 = (_e1165 + ((bitcast<f32>(_e1176) - _e1165) * _e1178));
let _e1182 = (_e1139 + _e1138);
let _e1183 = local_10.member[1u];
let _e1184 = (_e1182 + _e1183);
let _e1186 = select(_e1153, _e1184, (_e1184 < _e1153));
let _e1191 = global_1.member[bitcast<u32>(select(0i, _e1186, (_e1186 > 0i)))];
let _e1192 = bitcast<f32>(_e1191);
let _e1193 = local_10.member[2u];
let _e1194 = (_e1182 + _e1193);
let _e1196 = select(_e1153, _e1194, (_e1194 < _e1153));
let _e1201 = global_1.member[bitcast<u32>(select(0i, _e1196, (_e1196 > 0i)))];
let _e1203 = local_11[0u];
let _e1207 = (_e1140 + _e1137);
let _e1208 = local_10.member[1u];
let _e1209 = (_e1207 + _e1208);
let _e1211 = select(_e1153, _e1209, (_e1209 < _e1153));
let _e1216 = global_1.member[bitcast<u32>(select(0i, _e1211, (_e1211 > 0i)))];
let _e1217 = bitcast<f32>(_e1216);
let _e1218 = local_10.member[2u];
let _e1219 = (_e1207 + _e1218);
let _e1221 = select(_e1153, _e1219, (_e1219 < _e1153));
let _e1226 = global_1.member[bitcast<u32>(select(0i, _e1221, (_e1221 > 0i)))];
let _e1228 = local_11[0u];
let _e1231 = (_e1217 + ((bitcast<f32>(_e1226) - _e1217) * _e1228));
let _e1232 = (_e1140 + _e1138);
let _e1233 = local_10.member[1u];
let _e1234 = (_e1232 + _e1233);
let _e1236 = select(_e1153, _e1234, (_e1234 < _e1153));
let _e1241 = global_1.member[bitcast<u32>(select(0i, _e1236, (_e1236 > 0i)))];
let _e1242 = bitcast<f32>(_e1241);
let _e1243 = local_10.member[2u];
let _e1244 = (_e1232 + _e1243);
let _e1246 = select(_e1153, _e1244, (_e1244 < _e1153));
let _e1251 = global_1.member[bitcast<u32>(select(0i, _e1246, (_e1246 > 0i)))];
let _e1253 = local_11[0u];
let _e1258 = local_11[1u];
let _e1261 = (_e1181 + (((_e1192 + ((bitcast<f32>(_e1201) - _e1192) * _e1203)) - _e1181) * _e1258));
let _e1262 = local_11[1u];
let _e1267 = local_11[2u];
let _e1275 = global_5.member[_e359].member_6.member_5;
let _e1281 = global_5.member[_e359].member_6.member_6;
let _e1282 = (((_e1261 + (((_e1231 + (((_e1242 + ((bitcast<f32>(_e1251) - _e1242) * _e1253)) - _e1231) * _e1262)) - _e1261) * _e1267)) * _e1275) + _e1281);
let _e1284 = select(0f, _e1282, (_e1282 > 0f));
let _e1288 = select(-1f, _e770, (_e770 > -1f));
let _e1290 = select(_e765, _e1288, (_e1288 < _e765));
let _e1297 = select(0i, select(select(i32(_e1290), i32(-2147483648), (_e1290 < -2147483600f)), 2147483647i, (_e1290 > 2147483500f)), (_e1290 == _e1290));
let _e1301 = (_e1297 - select(0i, 1i, (_e1290 < f32(_e1297))));
let _e1303 = select(-1f, _e781, (_e781 > -1f));
let _e1305 = select(_e776, _e1303, (_e1303 < _e776));
let _e1312 = select(0i, select(select(i32(_e1305), i32(-2147483648), (_e1305 < -2147483600f)), 2147483647i, (_e1305 > 2147483500f)), (_e1305 == _e1305));
let _e1316 = (_e1312 - select(0i, 1i, (_e1305 < f32(_e1312))));
let _e1318 = select(-1f, _e792, (_e792 > -1f));
let _e1320 = select(_e787, _e1318, (_e1318 < _e787));
let _e1327 = select(0i, select(select(i32(_e1320), i32(-2147483648), (_e1320 < -2147483600f)), 2147483647i, (_e1320 > 2147483500f)), (_e1320 == _e1320));
let _e1331 = (_e1327 - select(0i, 1i, (_e1320 < f32(_e1327))));
let _e1336 = global_5.member[_e359].member_7.member_7;
let _e1341 = global_5.member[_e359].member_7.member_8;
let _e1349 = (select(0i, select(select(i32(_e776), i32(-2147483648), (_e776 < -2147483600f)), 2147483647i, (_e776 > 2147483500f)), (_e776 == _e776)) - 1i);
let _e1350 = (_e1316 - 1i);
let _e1355 = (_e1316 + 1i);
let _e1358 = (_e1316 + 2i);
let _e1368 = (select(0i, select(select(i32(_e787), i32(-2147483648), (_e787 < -2147483600f)), 2147483647i, (_e787 > 2147483500f)), (_e787 == _e787)) - 1i);
let _e1369 = (_e1331 - 1i);
let _e1374 = (_e1331 + 1i);
let _e1377 = (_e1331 + 2i);
let _e1387 = (select(0i, select(select(i32(_e765), i32(-2147483648), (_e765 < -2147483600f)), 2147483647i, (_e765 > 2147483500f)), (_e765 == _e765)) - 1i);
let _e1388 = (_e1301 - 1i);
let _e1393 = (_e1301 + 1i);
let _e1396 = (_e1301 + 2i);
let _e1399 = (select(0i, _e1350, (_e1350 > 0i)) * _e1336);
let _e1400 = (select(0i, _e1316, (_e1316 > 0i)) * _e1336);
let _e1401 = (select(_e1349, _e1355, (_e1355 < _e1349)) * _e1336);
let _e1402 = (select(_e1349, _e1358, (_e1358 < _e1349)) * _e1336);
let _e1403 = (select(0i, _e1369, (_e1369 > 0i)) * _e1341);
let _e1404 = (select(0i, _e1331, (_e1331 > 0i)) * _e1341);
let _e1405 = (select(_e1368, _e1374, (_e1374 < _e1368)) * _e1341);
let _e1406 = (select(_e1368, _e1377, (_e1377 < _e1368)) * _e1341);
local_8 = type_28(array<i32, 4>(select(0i, _e1388, (_e1388 > 0i)), select(0i, _e1301, (_e1301 > 0i)), select(_e1387, _e1393, (_e1393 < _e1387)), select(_e1387, _e1396, (_e1396 < _e1387))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_9 = vec3<f32>((_e770 - f32(_e1301)), (_e781 - f32(_e1316)), (_e792 - f32(_e1331)));
let _e1417 = (_e1404 + _e1400);
let _e1420 = local_8.member[0u];
let _e1421 = (_e1417 + _e1420);
let _e1423 = (bitcast<i32>(_e126) - 1i);
let _e1425 = select(_e1423, _e1421, (_e1421 < _e1423));
let _e1430 = global_7.member[bitcast<u32>(select(0i, _e1425, (_e1425 > 0i)))];
let _e1431 = bitcast<f32>(_e1430);
let _e1434 = local_8.member[1u];
let _e1435 = (_e1417 + _e1434);
let _e1437 = select(_e1423, _e1435, (_e1435 < _e1423));
let _e1442 = global_7.member[bitcast<u32>(select(0i, _e1437, (_e1437 > 0i)))];
let _e1443 = bitcast<f32>(_e1442);
let _e1446 = local_8.member[2u];
let _e1447 = (_e1417 + _e1446);
let _e1449 = select(_e1423, _e1447, (_e1447 < _e1423));
let _e1454 = global_7.member[bitcast<u32>(select(0i, _e1449, (_e1449 > 0i)))];
let _e1455 = bitcast<f32>(_e1454);
let _e1458 = local_8.member[3u];
let _e1459 = (_e1417 + _e1458);
let _e1461 = select(_e1423, _e1459, (_e1459 < _e1423));
let _e1466 = global_7.member[bitcast<u32>(select(0i, _e1461, (_e1461 > 0i)))];
let _e1468 = local_9[0u];
let _e1471 = (_e1431 + ((_e1443 - _e1431) * _e1468));
let _e1472 = local_9[0u];
let _e1475 = (_e1443 + ((_e1455 - _e1443) * _e1472));
let _e1476 = local_9[0u];
let _e1479 = (_e1455 + ((bitcast<f32>(_e1466) - _e1455) * _e1476));
let _e1480 = (_e1404 + _e1401);
let _e1481 = local_8.member[0u];
let _e1482 = (_e1480 + _e1481);
let _e1484 = select(_e1423, _e1482, (_e1482 < _e1423));
let _e1489 = global_7.member[bitcast<u32>(select(0i, _e1484, (_e1484 > 0i)))];
let _e1490 = bitcast<f32>(_e1489);
let _e1491 = local_8.member[1u];
let _e1492 = (_e1480 + _e1491);
let _e1494 = select(_e1423, _e1492, (_e1492 < _e1423));
let _e1499 = global_7.member[bitcast<u32>(select(0i, _e1494, (_e1494 > 0i)))];
let _e1500 = bitcast<f32>(_e1499);
let _e1501 = local_8.member[2u];
let _e1502 = (_e1480 + _e1501);
let _e1504 = select(_e1423, _e1502, (_e1502 < _e1423));
let _e1509 = global_7.member[bitcast<u32>(select(0i, _e1504, (_e1504 > 0i)))];
let _e1510 = bitcast<f32>(_e1509);
let _e1511 = local_8.member[3u];
let _e1512 = (_e1480 + _e1511);
let _e1514 = select(_e1423, _e1512, (_e1512 < _e1423));
let _e1519 = global_7.member[bitcast<u32>(select(0i, _e1514, (_e1514 > 0i)))];
let _e1521 = local_9[0u];
let _e1525 = local_9[0u];
let _e1528 = (_e1500 + ((_e1510 - _e1500) * _e1525));
let _e1529 = local_9[0u];
let _e1533 = (_e1405 + _e1400);
let _e1534 = local_8.member[0u];
let _e1535 = (_e1533 + _e1534);
let _e1537 = select(_e1423, _e1535, (_e1535 < _e1423));
let _e1542 = global_7.member[bitcast<u32>(select(0i, _e1537, (_e1537 > 0i)))];
let _e1543 = bitcast<f32>(_e1542);
let _e1544 = local_8.member[1u];
let _e1545 = (_e1533 + _e1544);
let _e1547 = select(_e1423, _e1545, (_e1545 < _e1423));
let _e1552 = global_7.member[bitcast<u32>(select(0i, _e1547, (_e1547 > 0i)))];
let _e1553 = bitcast<f32>(_e1552);
let _e1554 = local_8.member[2u];
let _e1555 = (_e1533 + _e1554);
let _e1557 = select(_e1423, _e1555, (_e1555 < _e1423));
let _e1562 = global_7.member[bitcast<u32>(select(0i, _e1557, (_e1557 > 0i)))];
let _e1563 = bitcast<f32>(_e1562);
let _e1564 = local_8.member[3u];
let _e1565 = (_e1533 + _e1564);
let _e1567 = select(_e1423, _e1565, (_e1565 < _e1423));
let _e1572 = global_7.member[bitcast<u32>(select(0i, _e1567, (_e1567 > 0i)))];
let _e1574 = local_9[0u];
let _e1577 = (_e1543 + ((_e1553 - _e1543) * _e1574));
let _e1578 = local_9[0u];
let _e1581 = (_e1553 + ((_e1563 - _e1553) * _e1578));
let _e1582 = local_9[0u];
let _e1585 = (_e1563 + ((bitcast<f32>(_e1572) - _e1563) * _e1582));
let _e1586 = (_e1405 + _e1401);
let _e1587 = local_8.member[0u];
let _e1588 = (_e1586 + _e1587);
let _e1590 = select(_e1423, _e1588, (_e1588 < _e1423));
let _e1595 = global_7.member[bitcast<u32>(select(0i, _e1590, (_e1590 > 0i)))];
let _e1596 = bitcast<f32>(_e1595);
let _e1597 = local_8.member[1u];
let _e1598 = (_e1586 + _e1597);
let _e1600 = select(_e1423, _e1598, (_e1598 < _e1423));
let _e1605 = global_7.member[bitcast<u32>(select(0i, _e1600, (_e1600 > 0i)))];
let _e1606 = bitcast<f32>(_e1605);
let _e1607 = local_8.member[2u];
let _e1608 = (_e1586 + _e1607);
let _e1610 = select(_e1423, _e1608, (_e1608 < _e1423));
let _e1615 = global_7.member[bitcast<u32>(select(0i, _e1610, (_e1610 > 0i)))];
let _e1616 = bitcast<f32>(_e1615);
let _e1617 = local_8.member[3u];
let _e1618 = (_e1586 + _e1617);
let _e1620 = select(_e1423, _e1618, (_e1618 < _e1423));
let _e1625 = global_7.member[bitcast<u32>(select(0i, _e1620, (_e1620 > 0i)))];
let _e1627 = local_9[0u];
let _e1631 = local_9[0u];
let _e1634 = (_e1606 + ((_e1616 - _e1606) * _e1631));
let _e1635 = local_9[0u];
let _e1639 = (_e1404 + _e1399);
let _e1640 = local_8.member[1u];
let _e1641 = (_e1639 + _e1640);
let _e1643 = select(_e1423, _e1641, (_e1641 < _e1423));
let _e1648 = global_7.member[bitcast<u32>(select(0i, _e1643, (_e1643 > 0i)))];
let _e1649 = bitcast<f32>(_e1648);
let _e1650 = local_8.member[2u];
let _e1651 = (_e1639 + _e1650);
let _e1653 = select(_e1423, _e1651, (_e1651 < _e1423));
let _e1658 = global_7.member[bitcast<u32>(select(0i, _e1653, (_e1653 > 0i)))];
let _e1660 = local_9[0u];
let _e1663 = (_e1649 + ((bitcast<f32>(_e1658) - _e1649) * _e1660));
let _e1664 = (_e1404 + _e1402);
let _e1665 = local_8.member[1u];
let _e1666 = (_e1664 + _e1665);
let _e1668 = select(_e1423, _e1666, (_e1666 < _e1423));
let _e1673 = global_7.member[bitcast<u32>(select(0i, _e1668, (_e1668 > 0i)))];
let _e1674 = bitcast<f32>(_e1673);
let _e1675 = local_8.member[2u];
let _e1676 = (_e1664 + _e1675);
let _e1678 = select(_e1423, _e1676, (_e1676 < _e1423));
let _e1683 = global_7.member[bitcast<u32>(select(0i, _e1678, (_e1678 > 0i)))];
let _e1685 = local_9[0u];
let _e1689 = (_e1405 + _e1399);
let _e1690 = local_8.member[1u];
let _e1691 = (_e1689 + _e1690);
let _e1693 = select(_e1423, _e1691, (_e1691 < _e1423));
let _e1698 = global_7.member[bitcast<u32>(select(0i, _e1693, (_e1693 > 0i)))];
let _e1699 = bitcast<f32>(_e1698);
let _e1700 = local_8.member[2u];
let _e1701 = (_e1689 + _e1700);
let _e1703 = select(_e1423, _e1701, (_e1701 < _e1423));
let _e1708 = global_7.member[bitcast<u32>(select(0i, _e1703, (_e1703 > 0i)))];
let _e1710 = local_9[0u];
let _e1713 = (_e1699 + ((bitcast<f32>(_e1708) - _e1699) * _e1710));
let _e1714 = (_e1405 + _e1402);
let _e1715 = local_8.member[1u];
let _e1716 = (_e1714 + _e1715);
let _e1718 = select(_e1423, _e1716, (_e1716 < _e1423));
let _e1723 = global_7.member[bitcast<u32>(select(0i, _e1718, (_e1718 > 0i)))];
let _e1724 = bitcast<f32>(_e1723);
let _e1725 = local_8.member[2u];
let _e1726 = (_e1714 + _e1725);
let _e1728 = select(_e1423, _e1726, (_e1726 < _e1423));
let _e1733 = global_7.member[bitcast<u32>(select(0i, _e1728, (_e1728 > 0i)))];
let _e1735 = local_9[0u];
let _e1739 = (_e1403 + _e1400);
let _e1740 = local_8.member[1u];
let _e1741 = (_e1739 + _e1740);
let _e1743 = select(_e1423, _e1741, (_e1741 < _e1423));
let _e1748 = global_7.member[bitcast<u32>(select(0i, _e1743, (_e1743 > 0i)))];
let _e1749 = bitcast<f32>(_e1748);
let _e1750 = local_8.member[2u];
let _e1751 = (_e1739 + _e1750);
let _e1753 = select(_e1423, _e1751, (_e1751 < _e1423));
let _e1758 = global_7.member[bitcast<u32>(select(0i, _e1753, (_e1753 > 0i)))];
let _e1760 = local_9[0u];
let _e1763 = (_e1749 + ((bitcast<f32>(_e1758) - _e1749) * _e1760));
let _e1764 = (_e1406 + _e1400);
let _e1765 = local_8.member[1u];
let _e1766 = (_e1764 + _e1765);
let _e1768 = select(_e1423, _e1766, (_e1766 < _e1423));
let _e1773 = global_7.member[bitcast<u32>(select(0i, _e1768, (_e1768 > 0i)))];
let _e1774 = bitcast<f32>(_e1773);
let _e1775 = local_8.member[2u];
let _e1776 = (_e1764 + _e1775);
let _e1778 = select(_e1423, _e1776, (_e1776 < _e1423));
let _e1783 = global_7.member[bitcast<u32>(select(0i, _e1778, (_e1778 > 0i)))];
let _e1785 = local_9[0u];
let _e1788 = (_e1774 + ((bitcast<f32>(_e1783) - _e1774) * _e1785));
let _e1789 = (_e1403 + _e1401);
let _e1790 = local_8.member[1u];
let _e1791 = (_e1789 + _e1790);
let _e1793 = select(_e1423, _e1791, (_e1791 < _e1423));
let _e1798 = global_7.member[bitcast<u32>(select(0i, _e1793, (_e1793 > 0i)))];
let _e1799 = bitcast<f32>(_e1798);
let _e1800 = local_8.member[2u];
let _e1801 = (_e1789 + _e1800);
let _e1803 = select(_e1423, _e1801, (_e1801 < _e1423));
let _e1808 = global_7.member[bitcast<u32>(select(0i, _e1803, (_e1803 > 0i)))];
let _e1810 = local_9[0u];
let _e1814 = (_e1406 + _e1401);
let _e1815 = local_8.member[1u];
let _e1816 = (_e1814 + _e1815);
let _e1818 = select(_e1423, _e1816, (_e1816 < _e1423));
let _e1823 = global_7.member[bitcast<u32>(select(0i, _e1818, (_e1818 > 0i)))];
let _e1824 = bitcast<f32>(_e1823);
let _e1825 = local_8.member[2u];
let _e1826 = (_e1814 + _e1825);
let _e1828 = select(_e1423, _e1826, (_e1826 < _e1423));
let _e1833 = global_7.member[bitcast<u32>(select(0i, _e1828, (_e1828 > 0i)))];
let _e1835 = local_9[0u];
let _e1840 = local_9[1u];
let _e1843 = (_e1475 + ((_e1528 - _e1475) * _e1840));
let _e1844 = local_9[1u];
let _e1847 = (_e1581 + ((_e1634 - _e1581) * _e1844));
let _e1848 = local_9[1u];
let _e1851 = (_e1471 + (((_e1490 + ((_e1500 - _e1490) * _e1521)) - _e1471) * _e1848));
let _e1852 = local_9[1u];
let _e1857 = local_9[2u];
let _e1861 = local_9[1u];
let _e1864 = (_e1479 + (((_e1510 + ((bitcast<f32>(_e1519) - _e1510) * _e1529)) - _e1479) * _e1861));
let _e1865 = local_9[1u];
let _e1869 = local_9[2u];
let _e1873 = local_9[1u];
let _e1876 = (_e1663 + ((_e1475 - _e1663) * _e1873));
let _e1877 = local_9[1u];
let _e1881 = local_9[2u];
let _e1885 = local_9[1u];
let _e1888 = (_e1528 + (((_e1674 + ((bitcast<f32>(_e1683) - _e1674) * _e1685)) - _e1528) * _e1885));
let _e1889 = local_9[1u];
let _e1893 = local_9[2u];
let _e1897 = local_9[1u];
let _e1900 = (_e1763 + (((_e1799 + ((bitcast<f32>(_e1808) - _e1799) * _e1810)) - _e1763) * _e1897));
let _e1901 = local_9[2u];
let _e1905 = local_9[1u];
let _e1909 = local_9[2u];
let _e1913 = local_9[2u];
let _e1921 = global_5.member[_e359].member_7.member_5;
let _e1927 = global_5.member[_e359].member_7.member_6;
let _e1928 = (((_e1843 + ((_e1847 - _e1843) * _e1913)) * _e1921) + _e1927);
let _e1930 = select(0f, _e1928, (_e1928 > 0f));
let _e1934 = (((_e1851 + (((_e1577 + (((_e1596 + ((_e1606 - _e1596) * _e1627)) - _e1577) * _e1852)) - _e1851) * _e1857)) * _e1921) + _e1927);
let _e1936 = select(0f, _e1934, (_e1934 > 0f));
let _e1938 = select(1f, _e1936, (_e1936 < 1f));
let _e1940 = (((_e1864 + (((_e1585 + (((_e1616 + ((bitcast<f32>(_e1625) - _e1616) * _e1635)) - _e1585) * _e1865)) - _e1864) * _e1869)) * _e1921) + _e1927);
let _e1942 = select(0f, _e1940, (_e1940 > 0f));
let _e1944 = select(1f, _e1942, (_e1942 < 1f));
let _e1946 = (((_e1876 + (((_e1713 + ((_e1581 - _e1713) * _e1877)) - _e1876) * _e1881)) * _e1921) + _e1927);
let _e1948 = select(0f, _e1946, (_e1946 > 0f));
let _e1950 = select(1f, _e1948, (_e1948 < 1f));
let _e1952 = (((_e1888 + (((_e1634 + (((_e1724 + ((bitcast<f32>(_e1733) - _e1724) * _e1735)) - _e1634) * _e1889)) - _e1888) * _e1893)) * _e1921) + _e1927);
let _e1954 = select(0f, _e1952, (_e1952 > 0f));
let _e1956 = select(1f, _e1954, (_e1954 < 1f));
let _e1958 = (((_e1900 + ((_e1843 - _e1900) * _e1901)) * _e1921) + _e1927);
let _e1960 = select(0f, _e1958, (_e1958 > 0f));
let _e1962 = select(1f, _e1960, (_e1960 < 1f));
let _e1964 = (((_e1847 + (((_e1788 + (((_e1824 + ((bitcast<f32>(_e1833) - _e1824) * _e1835)) - _e1788) * _e1905)) - _e1847) * _e1909)) * _e1921) + _e1927);
let _e1966 = select(0f, _e1964, (_e1964 > 0f));
let _e1968 = select(1f, _e1966, (_e1966 < 1f));
let _e1969 = (select(1f, _e1930, (_e1930 < 1f)) * 1024f);
let _e1970 = (1024f - 1f);
let _e1972 = select(0f, _e1969, (_e1969 > 0f));
let _e1974 = select(_e1970, _e1972, (_e1972 < _e1970));
let _e1981 = select(0i, select(select(i32(_e1974), i32(-2147483648), (_e1974 < -2147483600f)), 2147483647i, (_e1974 > 2147483500f)), (_e1974 == _e1974));
let _e1985 = (_e1981 - select(0i, 1i, (_e1974 < f32(_e1981))));
let _e1986 = (262147i + _e1985);
let _e1988 = (bitcast<i32>(_e130) - 1i);
let _e1990 = select(_e1988, _e1986, (_e1986 < _e1988));
let _e1996 = global_3.member[bitcast<u32>(select(0i, _e1990, (_e1990 > 0i)))];
let _e2006 = select(_e1988, 262146i, (262146i < _e1988));
let _e2012 = global_3.member[bitcast<u32>(select(0i, _e2006, (_e2006 > 0i)))];
let _e2013 = bitcast<f32>(_e2012);
let _e2014 = (f32((bitcast<i32>((_e1996 & 4095u)) - 2048i)) * _e2013);
let _e2016 = select(_e1988, 262144i, (262144i < _e1988));
let _e2022 = global_3.member[bitcast<u32>(select(0i, _e2016, (_e2016 > 0i)))];
let _e2023 = bitcast<f32>(_e2022);
let _e2025 = select(_e1988, 262145i, (262145i < _e1988));
let _e2031 = global_3.member[bitcast<u32>(select(0i, _e2025, (_e2025 > 0i)))];
let _e2032 = bitcast<f32>(_e2031);
let _e2038 = ((_e2023 + (f32(bitcast<i32>((_e1996 >> bitcast<u32>(12u)))) * _e2032)) + (_e2014 * (_e1969 - f32(_e1985))));
let _e2039 = (_e2014 * 1024f);
if _e1033 {
let _e2046 = ((0.5f * (_e1944 - _e1938)) * _e2039);
let _e2047 = ((0.5f * (_e1956 - _e1950)) * _e2039);
let _e2048 = ((0.5f * (_e1968 - _e1962)) * _e2039);
phi_5023_ = type_29(_e2038, vec3<f32>(_e2046, _e2047, _e2048), vec3<f32>((_e2046 * _e2038), (_e2047 * _e2038), (_e2048 * _e2038)));
} else {
let _e2055 = (_e1938 * 1024f);
let _e2057 = select(0f, _e2055, (_e2055 > 0f));
let _e2059 = select(_e1970, _e2057, (_e2057 < _e1970));
let _e2066 = select(0i, select(select(i32(_e2059), i32(-2147483648), (_e2059 < -2147483600f)), 2147483647i, (_e2059 > 2147483500f)), (_e2059 == _e2059));
let _e2070 = (_e2066 - select(0i, 1i, (_e2059 < f32(_e2066))));
let _e2071 = (262147i + _e2070);
let _e2073 = select(_e1988, _e2071, (_e2071 < _e1988));
let _e2079 = global_3.member[bitcast<u32>(select(0i, _e2073, (_e2073 > 0i)))];
let _e2094 = ((_e2023 + (f32(bitcast<i32>((_e2079 >> bitcast<u32>(12u)))) * _e2032)) + ((f32((bitcast<i32>((_e2079 & 4095u)) - 2048i)) * _e2013) * (_e2055 - f32(_e2070))));
let _e2095 = (_e1944 * 1024f);
let _e2097 = select(0f, _e2095, (_e2095 > 0f));
let _e2099 = select(_e1970, _e2097, (_e2097 < _e1970));
let _e2106 = select(0i, select(select(i32(_e2099), i32(-2147483648), (_e2099 < -2147483600f)), 2147483647i, (_e2099 > 2147483500f)), (_e2099 == _e2099));
let _e2110 = (_e2106 - select(0i, 1i, (_e2099 < f32(_e2106))));
let _e2111 = (262147i + _e2110);
let _e2113 = select(_e1988, _e2111, (_e2111 < _e1988));
let _e2119 = global_3.member[bitcast<u32>(select(0i, _e2113, (_e2113 > 0i)))];
let _e2134 = ((_e2023 + (f32(bitcast<i32>((_e2119 >> bitcast<u32>(12u)))) * _e2032)) + ((f32((bitcast<i32>((_e2119 & 4095u)) - 2048i)) * _e2013) * (_e2095 - f32(_e2110))));
let _e2135 = (_e1950 * 1024f);
let _e2137 = select(0f, _e2135, (_e2135 > 0f));
let _e2139 = select(_e1970, _e2137, (_e2137 < _e1970));
let _e2146 = select(0i, select(select(i32(_e2139), i32(-2147483648), (_e2139 < -2147483600f)), 2147483647i, (_e2139 > 2147483500f)), (_e2139 == _e2139));
let _e2150 = (_e2146 - select(0i, 1i, (_e2139 < f32(_e2146))));
let _e2151 = (262147i + _e2150);
let _e2153 = select(_e1988, _e2151, (_e2151 < _e1988));
let _e2159 = global_3.member[bitcast<u32>(select(0i, _e2153, (_e2153 > 0i)))];
let _e2174 = ((_e2023 + (f32(bitcast<i32>((_e2159 >> bitcast<u32>(12u)))) * _e2032)) + ((f32((bitcast<i32>((_e2159 & 4095u)) - 2048i)) * _e2013) * (_e2135 - f32(_e2150))));
let _e2175 = (_e1956 * 1024f);
let _e2177 = select(0f, _e2175, (_e2175 > 0f));
let _e2179 = select(_e1970, _e2177, (_e2177 < _e1970));
let _e2186 = select(0i, select(select(i32(_e2179), i32(-2147483648), (_e2179 < -2147483600f)), 2147483647i, (_e2179 > 2147483500f)), (_e2179 == _e2179));
let _e2190 = (_e2186 - select(0i, 1i, (_e2179 < f32(_e2186))));
let _e2191 = (262147i + _e2190);
let _e2193 = select(_e1988, _e2191, (_e2191 < _e1988));
let _e2199 = global_3.member[bitcast<u32>(select(0i, _e2193, (_e2193 > 0i)))];
let _e2214 = ((_e2023 + (f32(bitcast<i32>((_e2199 >> bitcast<u32>(12u)))) * _e2032)) + ((f32((bitcast<i32>((_e2199 & 4095u)) - 2048i)) * _e2013) * (_e2175 - f32(_e2190))));
let _e2215 = (_e1962 * 1024f);
let _e2217 = select(0f, _e2215, (_e2215 > 0f));
let _e2219 = select(_e1970, _e2217, (_e2217 < _e1970));
let _e2226 = select(0i, select(select(i32(_e2219), i32(-2147483648), (_e2219 < -2147483600f)), 2147483647i, (_e2219 > 2147483500f)), (_e2219 == _e2219));
let _e2230 = (_e2226 - select(0i, 1i, (_e2219 < f32(_e2226))));
let _e2231 = (262147i + _e2230);
let _e2233 = select(_e1988, _e2231, (_e2231 < _e1988));
let _e2239 = global_3.member[bitcast<u32>(select(0i, _e2233, (_e2233 > 0i)))];
let _e2254 = ((_e2023 + (f32(bitcast<i32>((_e2239 >> bitcast<u32>(12u)))) * _e2032)) + ((f32((bitcast<i32>((_e2239 & 4095u)) - 2048i)) * _e2013) * (_e2215 - f32(_e2230))));
let _e2255 = (_e1968 * 1024f);
let _e2257 = select(0f, _e2255, (_e2255 > 0f));
let _e2259 = select(_e1970, _e2257, (_e2257 < _e1970));
let _e2266 = select(0i, select(select(i32(_e2259), i32(-2147483648), (_e2259 < -2147483600f)), 2147483647i, (_e2259 > 2147483500f)), (_e2259 == _e2259));
let _e2270 = (_e2266 - select(0i, 1i, (_e2259 < f32(_e2266))));
let _e2271 = (262147i + _e2270);
let _e2273 = select(_e1988, _e2271, (_e2271 < _e1988));
let _e2279 = global_3.member[bitcast<u32>(select(0i, _e2273, (_e2273 > 0i)))];
let _e2294 = ((_e2023 + (f32(bitcast<i32>((_e2279 >> bitcast<u32>(12u)))) * _e2032)) + ((f32((bitcast<i32>((_e2279 & 4095u)) - 2048i)) * _e2013) * (_e2255 - f32(_e2270))));
let _e2295 = (_e2134 - _e2094);
let _e2297 = (_e2214 - _e2174);
let _e2299 = (_e2294 - _e2254);
phi_5023_ = type_29(_e2038, vec3<f32>((0.5f * _e2295), (0.5f * _e2297), (0.5f * _e2299)), vec3<f32>((0.25f * (_e2295 * (_e2134 + _e2094))), (0.25f * (_e2297 * (_e2214 + _e2174))), (0.25f * (_e2299 * (_e2294 + _e2254)))));
}
let _e2314 = phi_5023_;
let _e2329 = select(0f, 1f, ((((((_e742 >= -0.5f) && (_e742 <= _e766)) && (_e748 >= -0.5f)) && (_e748 <= _e777)) && (_e754 >= -0.5f)) && (_e754 <= _e788)));
let _e2331 = (0.5f * (_e1944 - _e1938));
let _e2333 = (0.5f * (_e1956 - _e1950));
let _e2335 = (0.5f * (_e1968 - _e1962));
let _e2342 = global_5.member[_e359].member_7.member.member.member;
let _e2349 = global_5.member[_e359].member_7.member.member.member_1;
let _e2356 = global_5.member[_e359].member_7.member.member.member_2;
let _e2363 = global_5.member[_e359].member_7.member_1.member.member;
let _e2370 = global_5.member[_e359].member_7.member_1.member.member_1;
let _e2377 = global_5.member[_e359].member_7.member_1.member.member_2;
let _e2384 = global_5.member[_e359].member_7.member_2.member.member;
let _e2391 = global_5.member[_e359].member_7.member_2.member.member_1;
let _e2398 = global_5.member[_e359].member_7.member_2.member.member_2;
phi_5669_ = type_30(select(1f, _e1284, (_e1284 < 1f)), vec3<f32>(((((_e2342 * _e2331) + (_e2363 * _e2333)) + (_e2384 * _e2335)) * _e2329), ((((_e2349 * _e2331) + (_e2370 * _e2333)) + (_e2391 * _e2335)) * _e2329), ((((_e2356 * _e2331) + (_e2377 * _e2333)) + (_e2398 * _e2335)) * _e2329)), _e2314.member, vec3<f32>(((((_e2342 * _e2314.member_2.x) + (_e2363 * _e2314.member_2.y)) + (_e2384 * _e2314.member_2.z)) * _e2329), ((((_e2349 * _e2314.member_2.x) + (_e2370 * _e2314.member_2.y)) + (_e2391 * _e2314.member_2.z)) * _e2329), ((((_e2356 * _e2314.member_2.x) + (_e2377 * _e2314.member_2.y)) + (_e2398 * _e2314.member_2.z)) * _e2329)), vec3<f32>(((((_e2342 * _e2314.member_1.x) + (_e2363 * _e2314.member_1.y)) + (_e2384 * _e2314.member_1.z)) * _e2329), ((((_e2349 * _e2314.member_1.x) + (_e2370 * _e2314.member_1.y)) + (_e2391 * _e2314.member_1.z)) * _e2329), ((((_e2356 * _e2314.member_1.x) + (_e2377 * _e2314.member_1.y)) + (_e2398 * _e2314.member_1.z)) * _e2329)));
} else {
let _e2464 = select(-1f, _e531, (_e531 > -1f));
let _e2466 = select(_e526, _e2464, (_e2464 < _e526));
let _e2473 = select(0i, select(select(i32(_e2466), i32(-2147483648), (_e2466 < -2147483600f)), 2147483647i, (_e2466 > 2147483500f)), (_e2466 == _e2466));
let _e2477 = (_e2473 - select(0i, 1i, (_e2466 < f32(_e2473))));
let _e2479 = select(-1f, _e542, (_e542 > -1f));
let _e2481 = select(_e537, _e2479, (_e2479 < _e537));
let _e2488 = select(0i, select(select(i32(_e2481), i32(-2147483648), (_e2481 < -2147483600f)), 2147483647i, (_e2481 > 2147483500f)), (_e2481 == _e2481));
let _e2492 = (_e2488 - select(0i, 1i, (_e2481 < f32(_e2488))));
let _e2494 = select(-1f, _e553, (_e553 > -1f));
let _e2496 = select(_e548, _e2494, (_e2494 < _e548));
let _e2503 = select(0i, select(select(i32(_e2496), i32(-2147483648), (_e2496 < -2147483600f)), 2147483647i, (_e2496 > 2147483500f)), (_e2496 == _e2496));
let _e2507 = (_e2503 - select(0i, 1i, (_e2496 < f32(_e2503))));
let _e2512 = global_5.member[_e359].member_6.member_7;
let _e2517 = global_5.member[_e359].member_6.member_8;
let _e2525 = (select(0i, select(select(i32(_e537), i32(-2147483648), (_e537 < -2147483600f)), 2147483647i, (_e537 > 2147483500f)), (_e537 == _e537)) - 1i);
let _e2528 = (_e2492 + 1i);
let _e2538 = (select(0i, select(select(i32(_e548), i32(-2147483648), (_e548 < -2147483600f)), 2147483647i, (_e548 > 2147483500f)), (_e548 == _e548)) - 1i);
let _e2541 = (_e2507 + 1i);
let _e2551 = (select(0i, select(select(i32(_e526), i32(-2147483648), (_e526 < -2147483600f)), 2147483647i, (_e526 > 2147483500f)), (_e526 == _e526)) - 1i);
let _e2552 = (_e2477 - 1i);
let _e2557 = (_e2477 + 1i);
let _e2560 = (_e2477 + 2i);
let _e2563 = (select(0i, _e2492, (_e2492 > 0i)) * _e2512);
let _e2564 = (select(_e2525, _e2528, (_e2528 < _e2525)) * _e2512);
let _e2565 = (select(0i, _e2507, (_e2507 > 0i)) * _e2517);
let _e2566 = (select(_e2538, _e2541, (_e2541 < _e2538)) * _e2517);
local_6 = type_28(array<i32, 4>(select(0i, _e2552, (_e2552 > 0i)), select(0i, _e2477, (_e2477 > 0i)), select(_e2551, _e2557, (_e2557 < _e2551)), select(_e2551, _e2560, (_e2560 < _e2551))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_7 = vec3<f32>((_e531 - f32(_e2477)), (_e542 - f32(_e2492)), (_e553 - f32(_e2507)));
let _e2577 = (_e2565 + _e2563);
let _e2580 = local_6.member[1u];
let _e2581 = (_e2577 + _e2580);
let _e2583 = (bitcast<i32>(_e123) - 1i);
let _e2585 = select(_e2583, _e2581, (_e2581 < _e2583));
let _e2590 = global_1.member[bitcast<u32>(select(0i, _e2585, (_e2585 > 0i)))];
let _e2591 = bitcast<f32>(_e2590);
let _e2594 = local_6.member[2u];
let _e2595 = (_e2577 + _e2594);
let _e2597 = select(_e2583, _e2595, (_e2595 < _e2583));
let _e2602 = global_1.member[bitcast<u32>(select(0i, _e2597, (_e2597 > 0i)))];
let _e2604 = local_7[0u];
let _e2607 = (_e2591 + ((bitcast<f32>(_e2602) - _e2591) * _e2604));
let _e2608 = (_e2565 + _e2564);
let _e2609 = local_6.member[1u];
let _e2610 = (_e2608 + _e2609);
let _e2612 = select(_e2583, _e2610, (_e2610 < _e2583));
let _e2617 = global_1.member[bitcast<u32>(select(0i, _e2612, (_e2612 > 0i)))];
let _e2618 = bitcast<f32>(_e2617);
let _e2619 = local_6.member[2u];
let _e2620 = (_e2608 + _e2619);
let _e2622 = select(_e2583, _e2620, (_e2620 < _e2583));
let _e2627 = global_1.member[bitcast<u32>(select(0i, _e2622, (_e2622 > 0i)))];
let _e2629 = local_7[0u];
let _e2634 = local_7[1u];
let _e2637 = (_e2607 + (((_e2618 + ((bitcast<f32>(_e2627) - _e2618) * _e2629)) - _e2607) * _e2634));
let _e2638 = (_e2566 + _e2563);
let _e2639 = local_6.member[1u];
let _e2640 = (_e2638 + _e2639);
let _e2642 = select(_e2583, _e2640, (_e2640 < _e2583));
let _e2647 = global_1.member[bitcast<u32>(select(0i, _e2642, (_e2642 > 0i)))];
let _e2648 = bitcast<f32>(_e2647);
let _e2649 = local_6.member[2u];
let _e2650 = (_e2638 + _e2649);
let _e2652 = select(_e2583, _e2650, (_e2650 < _e2583));
let _e2657 = global_1.member[bitcast<u32>(select(0i, _e2652, (_e2652 > 0i)))];
let _e2659 = local_7[0u];
let _e2662 = (_e2648 + ((bitcast<f32>(_e2657) - _e2648) * _e2659));
let _e2663 = (_e2566 + _e2564);
let _e2664 = local_6.member[1u];
let _e2665 = (_e2663 + _e2664);
let _e2667 = select(_e2583, _e2665, (_e2665 < _e2583));
let _e2672 = global_1.member[bitcast<u32>(select(0i, _e2667, (_e2667 > 0i)))];
let _e2673 = bitcast<f32>(_e2672);
let _e2674 = local_6.member[2u];
let _e2675 = (_e2663 + _e2674);
let _e2677 = select(_e2583, _e2675, (_e2675 < _e2583));
let _e2682 = global_1.member[bitcast<u32>(select(0i, _e2677, (_e2677 > 0i)))];
let _e2684 = local_7[0u];
let _e2688 = local_7[1u];
let _e2693 = local_7[2u];
let _e2701 = global_5.member[_e359].member_6.member_5;
let _e2707 = global_5.member[_e359].member_6.member_6;
let _e2708 = (((_e2637 + (((_e2662 + (((_e2673 + ((bitcast<f32>(_e2682) - _e2673) * _e2684)) - _e2662) * _e2688)) - _e2637) * _e2693)) * _e2701) + _e2707);
let _e2710 = select(0f, _e2708, (_e2708 > 0f));
phi_5669_ = type_30(select(1f, _e2710, (_e2710 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2715 = phi_5669_;
let _e2719 = select(-0.5f, _e465, (_e465 > -0.5f));
let _e2721 = select(_e527, _e2719, (_e2719 < _e527));
let _e2723 = select(-0.5f, _e481, (_e481 > -0.5f));
let _e2725 = select(_e538, _e2723, (_e2723 < _e538));
let _e2727 = select(-0.5f, _e497, (_e497 > -0.5f));
let _e2729 = select(_e549, _e2727, (_e2727 < _e549));
let _e2731 = select(-1f, _e2721, (_e2721 > -1f));
let _e2733 = select(_e526, _e2731, (_e2731 < _e526));
let _e2740 = select(0i, select(select(i32(_e2733), i32(-2147483648), (_e2733 < -2147483600f)), 2147483647i, (_e2733 > 2147483500f)), (_e2733 == _e2733));
let _e2744 = (_e2740 - select(0i, 1i, (_e2733 < f32(_e2740))));
let _e2746 = select(-1f, _e2725, (_e2725 > -1f));
let _e2748 = select(_e537, _e2746, (_e2746 < _e537));
let _e2755 = select(0i, select(select(i32(_e2748), i32(-2147483648), (_e2748 < -2147483600f)), 2147483647i, (_e2748 > 2147483500f)), (_e2748 == _e2748));
let _e2759 = (_e2755 - select(0i, 1i, (_e2748 < f32(_e2755))));
let _e2761 = select(-1f, _e2729, (_e2729 > -1f));
let _e2763 = select(_e548, _e2761, (_e2761 < _e548));
let _e2770 = select(0i, select(select(i32(_e2763), i32(-2147483648), (_e2763 < -2147483600f)), 2147483647i, (_e2763 > 2147483500f)), (_e2763 == _e2763));
let _e2774 = (_e2770 - select(0i, 1i, (_e2763 < f32(_e2770))));
let _e2779 = global_5.member[_e359].member_6.member_7;
let _e2784 = global_5.member[_e359].member_6.member_8;
let _e2792 = (select(0i, select(select(i32(_e537), i32(-2147483648), (_e537 < -2147483600f)), 2147483647i, (_e537 > 2147483500f)), (_e537 == _e537)) - 1i);
let _e2795 = (_e2759 + 1i);
let _e2805 = (select(0i, select(select(i32(_e548), i32(-2147483648), (_e548 < -2147483600f)), 2147483647i, (_e548 > 2147483500f)), (_e548 == _e548)) - 1i);
let _e2808 = (_e2774 + 1i);
let _e2818 = (select(0i, select(select(i32(_e526), i32(-2147483648), (_e526 < -2147483600f)), 2147483647i, (_e526 > 2147483500f)), (_e526 == _e526)) - 1i);
let _e2819 = (_e2744 - 1i);
let _e2824 = (_e2744 + 1i);
let _e2827 = (_e2744 + 2i);
let _e2830 = (select(0i, _e2759, (_e2759 > 0i)) * _e2779);
let _e2831 = (select(_e2792, _e2795, (_e2795 < _e2792)) * _e2779);
let _e2832 = (select(0i, _e2774, (_e2774 > 0i)) * _e2784);
let _e2833 = (select(_e2805, _e2808, (_e2808 < _e2805)) * _e2784);
local_4 = type_28(array<i32, 4>(select(0i, _e2819, (_e2819 > 0i)), select(0i, _e2744, (_e2744 > 0i)), select(_e2818, _e2824, (_e2824 < _e2818)), select(_e2818, _e2827, (_e2827 < _e2818))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_5 = vec3<f32>((_e2721 - f32(_e2744)), (_e2725 - f32(_e2759)), (_e2729 - f32(_e2774)));
let _e2844 = (_e2832 + _e2830);
let _e2847 = local_4.member[1u];
let _e2848 = (_e2844 + _e2847);
let _e2850 = (bitcast<i32>(_e123) - 1i);
let _e2852 = select(_e2850, _e2848, (_e2848 < _e2850));
let _e2857 = global_1.member[bitcast<u32>(select(0i, _e2852, (_e2852 > 0i)))];
let _e2858 = bitcast<f32>(_e2857);
let _e2861 = local_4.member[2u];
let _e2862 = (_e2844 + _e2861);
let _e2864 = select(_e2850, _e2862, (_e2862 < _e2850));
let _e2869 = global_1.member[bitcast<u32>(select(0i, _e2864, (_e2864 > 0i)))];
let _e2871 = local_5[0u];
let _e2874 = (_e2858 + ((bitcast<f32>(_e2869) - _e2858) * _e2871));
let _e2875 = (_e2832 + _e2831);
let _e2876 = local_4.member[1u];
let _e2877 = (_e2875 + _e2876);
let _e2879 = select(_e2850, _e2877, (_e2877 < _e2850));
let _e2884 = global_1.member[bitcast<u32>(select(0i, _e2879, (_e2879 > 0i)))];
let _e2885 = bitcast<f32>(_e2884);
let _e2886 = local_4.member[2u];
let _e2887 = (_e2875 + _e2886);
let _e2889 = select(_e2850, _e2887, (_e2887 < _e2850));
let _e2894 = global_1.member[bitcast<u32>(select(0i, _e2889, (_e2889 > 0i)))];
let _e2896 = local_5[0u];
let _e2901 = local_5[1u];
let _e2904 = (_e2874 + (((_e2885 + ((bitcast<f32>(_e2894) - _e2885) * _e2896)) - _e2874) * _e2901));
let _e2905 = (_e2833 + _e2830);
let _e2906 = local_4.member[1u];
let _e2907 = (_e2905 + _e2906);
let _e2909 = select(_e2850, _e2907, (_e2907 < _e2850));
let _e2914 = global_1.member[bitcast<u32>(select(0i, _e2909, (_e2909 > 0i)))];
let _e2915 = bitcast<f32>(_e2914);
let _e2916 = local_4.member[2u];
let _e2917 = (_e2905 + _e2916);
let _e2919 = select(_e2850, _e2917, (_e2917 < _e2850));
let _e2924 = global_1.member[bitcast<u32>(select(0i, _e2919, (_e2919 > 0i)))];
let _e2926 = local_5[0u];
let _e2929 = (_e2915 + ((bitcast<f32>(_e2924) - _e2915) * _e2926));
let _e2930 = (_e2833 + _e2831);
let _e2931 = local_4.member[1u];
let _e2932 = (_e2930 + _e2931);
let _e2934 = select(_e2850, _e2932, (_e2932 < _e2850));
let _e2939 = global_1.member[bitcast<u32>(select(0i, _e2934, (_e2934 > 0i)))];
let _e2940 = bitcast<f32>(_e2939);
let _e2941 = local_4.member[2u];
let _e2942 = (_e2930 + _e2941);
let _e2944 = select(_e2850, _e2942, (_e2942 < _e2850));
let _e2949 = global_1.member[bitcast<u32>(select(0i, _e2944, (_e2944 > 0i)))];
let _e2951 = local_5[0u];
let _e2955 = local_5[1u];
let _e2960 = local_5[2u];
let _e2968 = global_5.member[_e359].member_6.member_5;
let _e2974 = global_5.member[_e359].member_6.member_6;
let _e2975 = (((_e2904 + (((_e2929 + (((_e2940 + ((bitcast<f32>(_e2949) - _e2940) * _e2951)) - _e2929) * _e2955)) - _e2904) * _e2960)) * _e2968) + _e2974);
let _e2977 = select(0f, _e2975, (_e2975 > 0f));
let _e2980 = select(_e363[5], select(1f, _e2977, (_e2977 < 1f)), _e962);
if _e1036 {
let _e2982 = select(-0.5f, _e704, (_e704 > -0.5f));
let _e2984 = select(_e766, _e2982, (_e2982 < _e766));
let _e2986 = select(-0.5f, _e720, (_e720 > -0.5f));
let _e2988 = select(_e777, _e2986, (_e2986 < _e777));
let _e2990 = select(-0.5f, _e736, (_e736 > -0.5f));
let _e2992 = select(_e788, _e2990, (_e2990 < _e788));
let _e2994 = select(-1f, _e2984, (_e2984 > -1f));
let _e2996 = select(_e765, _e2994, (_e2994 < _e765));
let _e3003 = select(0i, select(select(i32(_e2996), i32(-2147483648), (_e2996 < -2147483600f)), 2147483647i, (_e2996 > 2147483500f)), (_e2996 == _e2996));
let _e3007 = (_e3003 - select(0i, 1i, (_e2996 < f32(_e3003))));
let _e3009 = select(-1f, _e2988, (_e2988 > -1f));
let _e3011 = select(_e776, _e3009, (_e3009 < _e776));
let _e3018 = select(0i, select(select(i32(_e3011), i32(-2147483648), (_e3011 < -2147483600f)), 2147483647i, (_e3011 > 2147483500f)), (_e3011 == _e3011));
let _e3022 = (_e3018 - select(0i, 1i, (_e3011 < f32(_e3018))));
let _e3024 = select(-1f, _e2992, (_e2992 > -1f));
let _e3026 = select(_e787, _e3024, (_e3024 < _e787));
let _e3033 = select(0i, select(select(i32(_e3026), i32(-2147483648), (_e3026 < -2147483600f)), 2147483647i, (_e3026 > 2147483500f)), (_e3026 == _e3026));
let _e3037 = (_e3033 - select(0i, 1i, (_e3026 < f32(_e3033))));
let _e3042 = global_5.member[_e359].member_7.member_7;
let _e3047 = global_5.member[_e359].member_7.member_8;
let _e3055 = (select(0i, select(select(i32(_e776), i32(-2147483648), (_e776 < -2147483600f)), 2147483647i, (_e776 > 2147483500f)), (_e776 == _e776)) - 1i);
let _e3058 = (_e3022 + 1i);
let _e3068 = (select(0i, select(select(i32(_e787), i32(-2147483648), (_e787 < -2147483600f)), 2147483647i, (_e787 > 2147483500f)), (_e787 == _e787)) - 1i);
let _e3071 = (_e3037 + 1i);
let _e3081 = (select(0i, select(select(i32(_e765), i32(-2147483648), (_e765 < -2147483600f)), 2147483647i, (_e765 > 2147483500f)), (_e765 == _e765)) - 1i);
let _e3082 = (_e3007 - 1i);
let _e3087 = (_e3007 + 1i);
let _e3090 = (_e3007 + 2i);
let _e3093 = (select(0i, _e3022, (_e3022 > 0i)) * _e3042);
let _e3094 = (select(_e3055, _e3058, (_e3058 < _e3055)) * _e3042);
let _e3095 = (select(0i, _e3037, (_e3037 > 0i)) * _e3047);
let _e3096 = (select(_e3068, _e3071, (_e3071 < _e3068)) * _e3047);
local_2 = type_28(array<i32, 4>(select(0i, _e3082, (_e3082 > 0i)), select(0i, _e3007, (_e3007 > 0i)), select(_e3081, _e3087, (_e3087 < _e3081)), select(_e3081, _e3090, (_e3090 < _e3081))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_3 = vec3<f32>((_e2984 - f32(_e3007)), (_e2988 - f32(_e3022)), (_e2992 - f32(_e3037)));
let _e3107 = (_e3095 + _e3093);
let _e3110 = local_2.member[1u];
let _e3111 = (_e3107 + _e3110);
let _e3113 = (bitcast<i32>(_e126) - 1i);
let _e3115 = select(_e3113, _e3111, (_e3111 < _e3113));
let _e3120 = global_7.member[bitcast<u32>(select(0i, _e3115, (_e3115 > 0i)))];
let _e3121 = bitcast<f32>(_e3120);
let _e3124 = local_2.member[2u];
let _e3125 = (_e3107 + _e3124);
let _e3127 = select(_e3113, _e3125, (_e3125 < _e3113));
let _e3132 = global_7.member[bitcast<u32>(select(0i, _e3127, (_e3127 > 0i)))];
let _e3134 = local_3[0u];
let _e3137 = (_e3121 + ((bitcast<f32>(_e3132) - _e3121) * _e3134));
let _e3138 = (_e3095 + _e3094);
let _e3139 = local_2.member[1u];
let _e3140 = (_e3138 + _e3139);
let _e3142 = select(_e3113, _e3140, (_e3140 < _e3113));
let _e3147 = global_7.member[bitcast<u32>(select(0i, _e3142, (_e3142 > 0i)))];
let _e3148 = bitcast<f32>(_e3147);
let _e3149 = local_2.member[2u];
let _e3150 = (_e3138 + _e3149);
let _e3152 = select(_e3113, _e3150, (_e3150 < _e3113));
let _e3157 = global_7.member[bitcast<u32>(select(0i, _e3152, (_e3152 > 0i)))];
let _e3159 = local_3[0u];
let _e3164 = local_3[1u];
let _e3167 = (_e3137 + (((_e3148 + ((bitcast<f32>(_e3157) - _e3148) * _e3159)) - _e3137) * _e3164));
let _e3168 = (_e3096 + _e3093);
let _e3169 = local_2.member[1u];
let _e3170 = (_e3168 + _e3169);
let _e3172 = select(_e3113, _e3170, (_e3170 < _e3113));
let _e3177 = global_7.member[bitcast<u32>(select(0i, _e3172, (_e3172 > 0i)))];
let _e3178 = bitcast<f32>(_e3177);
let _e3179 = local_2.member[2u];
let _e3180 = (_e3168 + _e3179);
let _e3182 = select(_e3113, _e3180, (_e3180 < _e3113));
let _e3187 = global_7.member[bitcast<u32>(select(0i, _e3182, (_e3182 > 0i)))];
let _e3189 = local_3[0u];
let _e3192 = (_e3178 + ((bitcast<f32>(_e3187) - _e3178) * _e3189));
let _e3193 = (_e3096 + _e3094);
let _e3194 = local_2.member[1u];
let _e3195 = (_e3193 + _e3194);
let _e3197 = select(_e3113, _e3195, (_e3195 < _e3113));
let _e3202 = global_7.member[bitcast<u32>(select(0i, _e3197, (_e3197 > 0i)))];
let _e3203 = bitcast<f32>(_e3202);
let _e3204 = local_2.member[2u];
let _e3205 = (_e3193 + _e3204);
let _e3207 = select(_e3113, _e3205, (_e3205 < _e3113));
let _e3212 = global_7.member[bitcast<u32>(select(0i, _e3207, (_e3207 > 0i)))];
let _e3214 = local_3[0u];
let _e3218 = local_3[1u];
let _e3223 = local_3[2u];
let _e3231 = global_5.member[_e359].member_7.member_5;
let _e3237 = global_5.member[_e359].member_7.member_6;
let _e3238 = (((_e3167 + (((_e3192 + (((_e3203 + ((bitcast<f32>(_e3212) - _e3203) * _e3214)) - _e3192) * _e3218)) - _e3167) * _e3223)) * _e3231) + _e3237);
let _e3240 = select(0f, _e3238, (_e3238 > 0f));
let _e3243 = (select(1f, _e3240, (_e3240 < 1f)) * 1024f);
let _e3244 = (1024f - 1f);
let _e3246 = select(0f, _e3243, (_e3243 > 0f));
let _e3248 = select(_e3244, _e3246, (_e3246 < _e3244));
let _e3255 = select(0i, select(select(i32(_e3248), i32(-2147483648), (_e3248 < -2147483600f)), 2147483647i, (_e3248 > 2147483500f)), (_e3248 == _e3248));
let _e3259 = (_e3255 - select(0i, 1i, (_e3248 < f32(_e3255))));
let _e3260 = (262147i + _e3259);
let _e3262 = (bitcast<i32>(_e130) - 1i);
let _e3264 = select(_e3262, _e3260, (_e3260 < _e3262));
let _e3270 = global_3.member[bitcast<u32>(select(0i, _e3264, (_e3264 > 0i)))];
let _e3280 = select(_e3262, 262146i, (262146i < _e3262));
let _e3286 = global_3.member[bitcast<u32>(select(0i, _e3280, (_e3280 > 0i)))];
let _e3290 = select(_e3262, 262144i, (262144i < _e3262));
let _e3296 = global_3.member[bitcast<u32>(select(0i, _e3290, (_e3290 > 0i)))];
let _e3299 = select(_e3262, 262145i, (262145i < _e3262));
let _e3305 = global_3.member[bitcast<u32>(select(0i, _e3299, (_e3299 > 0i)))];
phi_6748_ = select(_e363[15], ((bitcast<f32>(_e3296) + (f32(bitcast<i32>((_e3270 >> bitcast<u32>(12u)))) * bitcast<f32>(_e3305))) + ((f32((bitcast<i32>((_e3270 & 4095u)) - 2048i)) * bitcast<f32>(_e3286)) * (_e3243 - f32(_e3259)))), _e962);
} else {
phi_6748_ = _e363[15];
}
let _e3315 = phi_6748_;
let _e3318 = select(1f, select(1f, _e1031, (_e1031 < 1f)), _e449);
if ((_e929 & 16u) == 0u) {
phi_7137_ = type_5(1f, 1f, 1f);
} else {
let _e3325 = global_5.member[_e359].member_14.member;
let _e3336 = ((((_e3325.member.member * _e384) + (_e3325.member.member_1 * _e387)) + (_e3325.member.member_2 * _e378)) + _e3325.member_1);
let _e3342 = ((((_e3325.member.member * _e389) + (_e3325.member.member_1 * _e391)) + (_e3325.member.member_2 * _e396)) + _e3325.member_1);
let _e3344 = select(_e3342, _e3336, (_e3336 < _e3342));
let _e3346 = select(_e3342, _e3336, (_e3336 > _e3342));
let _e3348 = (_e3346 - _e3344);
let _e3351 = (-(_e3344) / select(1e-30f, _e3348, (_e3348 > 1e-30f)));
let _e3353 = select(0f, _e3351, (_e3351 > 0f));
let _e3359 = select(select(select(1f, _e3353, (_e3353 < 1f)), 1f, (_e3346 <= 0f)), 0f, (_e3344 > 0f));
let _e3365 = global_5.member[_e359].member_14.member_1;
let _e3366 = (_e3365 != 0u);
let _e3377 = global_5.member[_e359].member_15.member;
let _e3388 = ((((_e3377.member.member * _e384) + (_e3377.member.member_1 * _e387)) + (_e3377.member.member_2 * _e378)) + _e3377.member_1);
let _e3394 = ((((_e3377.member.member * _e389) + (_e3377.member.member_1 * _e391)) + (_e3377.member.member_2 * _e396)) + _e3377.member_1);
let _e3396 = select(_e3394, _e3388, (_e3388 < _e3394));
let _e3398 = select(_e3394, _e3388, (_e3388 > _e3394));
let _e3400 = (_e3398 - _e3396);
let _e3403 = (-(_e3396) / select(1e-30f, _e3400, (_e3400 > 1e-30f)));
let _e3405 = select(0f, _e3403, (_e3403 > 0f));
let _e3411 = select(select(select(1f, _e3405, (_e3405 < 1f)), 1f, (_e3398 <= 0f)), 0f, (_e3396 > 0f));
let _e3417 = global_5.member[_e359].member_15.member_1;
let _e3418 = (_e3417 != 0u);
let _e3429 = global_5.member[_e359].member_16.member;
let _e3440 = ((((_e3429.member.member * _e384) + (_e3429.member.member_1 * _e387)) + (_e3429.member.member_2 * _e378)) + _e3429.member_1);
let _e3446 = ((((_e3429.member.member * _e389) + (_e3429.member.member_1 * _e391)) + (_e3429.member.member_2 * _e396)) + _e3429.member_1);
let _e3448 = select(_e3446, _e3440, (_e3440 < _e3446));
let _e3450 = select(_e3446, _e3440, (_e3440 > _e3446));
let _e3452 = (_e3450 - _e3448);
let _e3455 = (-(_e3448) / select(1e-30f, _e3452, (_e3452 > 1e-30f)));
let _e3457 = select(0f, _e3455, (_e3455 > 0f));
let _e3463 = select(select(select(1f, _e3457, (_e3457 < 1f)), 1f, (_e3450 <= 0f)), 0f, (_e3448 > 0f));
let _e3469 = global_5.member[_e359].member_16.member_1;
let _e3470 = (_e3469 != 0u);
let _e3481 = global_5.member[_e359].member_17.member;
let _e3492 = ((((_e3481.member.member * _e384) + (_e3481.member.member_1 * _e387)) + (_e3481.member.member_2 * _e378)) + _e3481.member_1);
let _e3498 = ((((_e3481.member.member * _e389) + (_e3481.member.member_1 * _e391)) + (_e3481.member.member_2 * _e396)) + _e3481.member_1);
let _e3500 = select(_e3498, _e3492, (_e3492 < _e3498));
let _e3502 = select(_e3498, _e3492, (_e3492 > _e3498));
let _e3504 = (_e3502 - _e3500);
let _e3507 = (-(_e3500) / select(1e-30f, _e3504, (_e3504 > 1e-30f)));
let _e3509 = select(0f, _e3507, (_e3507 > 0f));
let _e3515 = select(select(select(1f, _e3509, (_e3509 < 1f)), 1f, (_e3502 <= 0f)), 0f, (_e3500 > 0f));
let _e3521 = global_5.member[_e359].member_17.member_1;
let _e3522 = (_e3521 != 0u);
phi_7137_ = type_5(((((1f * _e3359) * _e3411) * _e3463) * _e3515), ((((1f * select(1f, _e3359, _e3366)) * select(1f, _e3411, _e3418)) * select(1f, _e3463, _e3470)) * select(1f, _e3515, _e3522)), ((((1f * select(1f, 0f, (_e3366 && (_e3342 > 0f)))) * select(1f, 0f, (_e3418 && (_e3394 > 0f)))) * select(1f, 0f, (_e3470 && (_e3446 > 0f)))) * select(1f, 0f, (_e3522 && (_e3498 > 0f)))));
}
let _e3531 = phi_7137_;
let _e3532 = (_e559 < 1e-12f);
let _e3534 = (1f / select(_e554, 1f, _e3532));
let _e3536 = ((-0.5f - _e465) * _e3534);
let _e3538 = ((_e527 - _e465) * _e3534);
let _e3544 = select(_e3538, _e3536, (_e3536 < _e3538));
let _e3546 = select(0f, _e3544, (_e3544 > 0f));
let _e3549 = select(select(1f, _e3546, (_e3546 < 1f)), select(2f, 0f, ((_e465 >= -0.5f) && (_e465 <= _e527))), _e3532);
let _e3551 = select(_e3538, _e3536, (_e3536 > _e3538));
let _e3553 = select(0f, _e3551, (_e3551 > 0f));
let _e3556 = select(select(1f, _e3553, (_e3553 < 1f)), 1f, _e3532);
let _e3557 = (_e562 < 1e-12f);
let _e3559 = (1f / select(_e555, 1f, _e3557));
let _e3561 = ((-0.5f - _e481) * _e3559);
let _e3563 = ((_e538 - _e481) * _e3559);
let _e3569 = select(_e3563, _e3561, (_e3561 < _e3563));
let _e3571 = select(0f, _e3569, (_e3569 > 0f));
let _e3574 = select(select(1f, _e3571, (_e3571 < 1f)), select(2f, 0f, ((_e481 >= -0.5f) && (_e481 <= _e538))), _e3557);
let _e3576 = select(_e3563, _e3561, (_e3561 > _e3563));
let _e3578 = select(0f, _e3576, (_e3576 > 0f));
let _e3581 = select(select(1f, _e3578, (_e3578 < 1f)), 1f, _e3557);
let _e3582 = (_e567 < 1e-12f);
let _e3584 = (1f / select(_e556, 1f, _e3582));
let _e3586 = ((-0.5f - _e497) * _e3584);
let _e3588 = ((_e549 - _e497) * _e3584);
let _e3594 = select(_e3588, _e3586, (_e3586 < _e3588));
let _e3596 = select(0f, _e3594, (_e3594 > 0f));
let _e3599 = select(select(1f, _e3596, (_e3596 < 1f)), select(2f, 0f, ((_e497 >= -0.5f) && (_e497 <= _e549))), _e3582);
let _e3601 = select(_e3588, _e3586, (_e3586 > _e3588));
let _e3603 = select(0f, _e3601, (_e3601 > 0f));
let _e3606 = select(select(1f, _e3603, (_e3603 < 1f)), 1f, _e3582);
let _e3608 = select(_e3581, _e3556, (_e3556 < _e3581));
let _e3612 = select(_e3574, _e3549, (_e3549 > _e3574));
let _e3615 = (select(_e3606, _e3608, (_e3608 < _e3606)) - select(_e3599, _e3612, (_e3612 > _e3599)));
let _e3618 = (_e389 - _e384);
let _e3619 = (_e391 - _e387);
let _e3620 = (_e396 - _e378);
let _e3625 = (((_e3618 * _e3618) + (_e3619 * _e3619)) + (_e3620 * _e3620));
let _e3635 = global_5.member[_e359].member_5.member_3;
let _e3636 = (((sqrt(select(0f, _e3625, (_e3625 > 0f))) * select(0f, _e3615, (_e3615 > 0f))) * _e3318) * _e3635);
let _e3637 = (_e973.member_2 >= 3u);
if _e3637 {
let _e3639 = (_e2980 * 255f);
let _e3640 = (_e2715.member * 255f);
let _e3641 = (255f - 1f);
let _e3643 = select(0f, _e3639, (_e3639 > 0f));
let _e3645 = select(_e3641, _e3643, (_e3643 < _e3641));
let _e3652 = select(0i, select(select(i32(_e3645), i32(-2147483648), (_e3645 < -2147483600f)), 2147483647i, (_e3645 > 2147483500f)), (_e3645 == _e3645));
let _e3656 = (_e3652 - select(0i, 1i, (_e3645 < f32(_e3652))));
let _e3658 = select(0f, _e3640, (_e3640 > 0f));
let _e3660 = select(_e3641, _e3658, (_e3658 < _e3641));
let _e3667 = select(0i, select(select(i32(_e3660), i32(-2147483648), (_e3660 < -2147483600f)), 2147483647i, (_e3660 > 2147483500f)), (_e3660 == _e3660));
let _e3671 = (_e3667 - select(0i, 1i, (_e3660 < f32(_e3667))));
let _e3674 = (((_e3656 * 256i) + _e3671) * 4i);
let _e3676 = (_e3639 - f32(_e3656));
let _e3678 = (_e3640 - f32(_e3671));
let _e3679 = (_e3674 + 2i);
let _e3681 = (bitcast<i32>(_e130) - 1i);
let _e3683 = select(_e3681, _e3679, (_e3679 < _e3681));
let _e3689 = global_3.member[bitcast<u32>(select(0i, _e3683, (_e3683 > 0i)))];
let _e3690 = (_e3674 + 6i);
let _e3692 = select(_e3681, _e3690, (_e3690 < _e3681));
let _e3698 = global_3.member[bitcast<u32>(select(0i, _e3692, (_e3692 > 0i)))];
let _e3699 = (_e3674 + 1026i);
let _e3701 = select(_e3681, _e3699, (_e3699 < _e3681));
let _e3707 = global_3.member[bitcast<u32>(select(0i, _e3701, (_e3701 > 0i)))];
let _e3708 = (_e3674 + 1030i);
let _e3710 = select(_e3681, _e3708, (_e3708 < _e3681));
let _e3716 = global_3.member[bitcast<u32>(select(0i, _e3710, (_e3710 > 0i)))];
let _e3721 = (bitcast<f32>(((_e3689 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3729 = (_e3721 + (((bitcast<f32>(((_e3698 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3721) * _e3678));
let _e3734 = (bitcast<f32>(((_e3707 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3758 = (bitcast<f32>((((_e3689 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3766 = (_e3758 + (((bitcast<f32>((((_e3698 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3758) * _e3678));
let _e3771 = (bitcast<f32>((((_e3707 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3783 = (_e3674 + 3i);
let _e3785 = select(_e3681, _e3783, (_e3783 < _e3681));
let _e3791 = global_3.member[bitcast<u32>(select(0i, _e3785, (_e3785 > 0i)))];
let _e3792 = (_e3674 + 7i);
let _e3794 = select(_e3681, _e3792, (_e3792 < _e3681));
let _e3800 = global_3.member[bitcast<u32>(select(0i, _e3794, (_e3794 > 0i)))];
let _e3801 = (_e3674 + 1027i);
let _e3803 = select(_e3681, _e3801, (_e3801 < _e3681));
let _e3809 = global_3.member[bitcast<u32>(select(0i, _e3803, (_e3803 > 0i)))];
let _e3810 = (_e3674 + 1031i);
let _e3812 = select(_e3681, _e3810, (_e3810 < _e3681));
let _e3818 = global_3.member[bitcast<u32>(select(0i, _e3812, (_e3812 > 0i)))];
let _e3823 = (bitcast<f32>(((_e3791 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3831 = (_e3823 + (((bitcast<f32>(((_e3800 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3823) * _e3678));
let _e3836 = (bitcast<f32>(((_e3809 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3860 = (bitcast<f32>((((_e3791 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3868 = (_e3860 + (((bitcast<f32>((((_e3800 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3860) * _e3678));
let _e3873 = (bitcast<f32>((((_e3809 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3884 = (_e3868 + (((_e3873 + (((bitcast<f32>((((_e3818 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3873) * _e3678)) - _e3868) * _e3676));
let _e3888 = -((_e3884 * (_e3636 * _e3531.member)));
let _e3890 = select(-87f, _e3888, (_e3888 > -87f));
let _e3892 = select(88f, _e3890, (_e3890 < 88f));
let _e3894 = ((_e3892 * 1.442695f) + 0.5f);
let _e3896 = select(-127f, _e3894, (_e3894 > -127f));
let _e3898 = select(128f, _e3896, (_e3896 < 128f));
let _e3905 = select(0i, select(select(i32(_e3898), i32(-2147483648), (_e3898 < -2147483600f)), 2147483647i, (_e3898 > 2147483500f)), (_e3898 == _e3898));
let _e3909 = (_e3905 - select(0i, 1i, (_e3898 < f32(_e3905))));
let _e3910 = f32(_e3909);
let _e3914 = ((_e3892 - (_e3910 * 0.6933594f)) - (_e3910 * -2.1219444e-4f));
let _e3934 = ((1f + (_e3914 * (1f + (_e3914 * (0.5f + (_e3914 * (0.16666667f + (_e3914 * (0.041666668f + (_e3914 * (0.008333334f + (_e3914 * (0.001388889f + (_e3914 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3909 + 127i)) << bitcast<u32>(23i))));
let _e3935 = (1f - _e3934);
let _e3938 = (_e3935 / select(1e-12f, _e3884, (_e3884 > 1e-12f)));
phi_8695_ = type_31(_e3934, _e3935, vec3<f32>(1f, 1f, 1f), vec3<f32>(((_e3729 + (((_e3734 + (((bitcast<f32>(((_e3716 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3734) * _e3678)) - _e3729) * _e3676)) * _e3938), ((_e3766 + (((_e3771 + (((bitcast<f32>((((_e3716 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3771) * _e3678)) - _e3766) * _e3676)) * _e3938), ((_e3831 + (((_e3836 + (((bitcast<f32>(((_e3818 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3836) * _e3678)) - _e3831) * _e3676)) * _e3938)));
} else {
let _e3945 = (_e2980 * 255f);
let _e3946 = (_e2715.member * 255f);
let _e3947 = (255f - 1f);
let _e3949 = select(0f, _e3945, (_e3945 > 0f));
let _e3951 = select(_e3947, _e3949, (_e3949 < _e3947));
let _e3958 = select(0i, select(select(i32(_e3951), i32(-2147483648), (_e3951 < -2147483600f)), 2147483647i, (_e3951 > 2147483500f)), (_e3951 == _e3951));
let _e3962 = (_e3958 - select(0i, 1i, (_e3951 < f32(_e3958))));
let _e3964 = select(0f, _e3946, (_e3946 > 0f));
let _e3966 = select(_e3947, _e3964, (_e3964 < _e3947));
let _e3973 = select(0i, select(select(i32(_e3966), i32(-2147483648), (_e3966 < -2147483600f)), 2147483647i, (_e3966 > 2147483500f)), (_e3966 == _e3966));
let _e3977 = (_e3973 - select(0i, 1i, (_e3966 < f32(_e3973))));
let _e3980 = (((_e3962 * 256i) + _e3977) * 4i);
let _e3982 = (_e3945 - f32(_e3962));
let _e3984 = (_e3946 - f32(_e3977));
let _e3986 = (bitcast<i32>(_e130) - 1i);
let _e3988 = select(_e3986, _e3980, (_e3980 < _e3986));
let _e3994 = global_3.member[bitcast<u32>(select(0i, _e3988, (_e3988 > 0i)))];
let _e3995 = (_e3980 + 4i);
let _e3997 = select(_e3986, _e3995, (_e3995 < _e3986));
let _e4003 = global_3.member[bitcast<u32>(select(0i, _e3997, (_e3997 > 0i)))];
let _e4004 = (_e3980 + 1024i);
let _e4006 = select(_e3986, _e4004, (_e4004 < _e3986));
let _e4012 = global_3.member[bitcast<u32>(select(0i, _e4006, (_e4006 > 0i)))];
let _e4013 = (_e3980 + 1028i);
let _e4015 = select(_e3986, _e4013, (_e4013 < _e3986));
let _e4021 = global_3.member[bitcast<u32>(select(0i, _e4015, (_e4015 > 0i)))];
let _e4026 = (bitcast<f32>(((_e3994 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4034 = (_e4026 + (((bitcast<f32>(((_e4003 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4026) * _e3984));
let _e4039 = (bitcast<f32>(((_e4012 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4050 = (_e4034 + (((_e4039 + (((bitcast<f32>(((_e4021 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4039) * _e3984)) - _e4034) * _e3982));
let _e4063 = (bitcast<f32>((((_e3994 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4071 = (_e4063 + (((bitcast<f32>((((_e4003 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4063) * _e3984));
let _e4076 = (bitcast<f32>((((_e4012 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4088 = (_e3980 + 1i);
let _e4090 = select(_e3986, _e4088, (_e4088 < _e3986));
let _e4096 = global_3.member[bitcast<u32>(select(0i, _e4090, (_e4090 > 0i)))];
let _e4097 = (_e3980 + 5i);
let _e4099 = select(_e3986, _e4097, (_e4097 < _e3986));
let _e4105 = global_3.member[bitcast<u32>(select(0i, _e4099, (_e4099 > 0i)))];
let _e4106 = (_e3980 + 1025i);
let _e4108 = select(_e3986, _e4106, (_e4106 < _e3986));
let _e4114 = global_3.member[bitcast<u32>(select(0i, _e4108, (_e4108 > 0i)))];
let _e4115 = (_e3980 + 1029i);
let _e4117 = select(_e3986, _e4115, (_e4115 < _e3986));
let _e4123 = global_3.member[bitcast<u32>(select(0i, _e4117, (_e4117 > 0i)))];
let _e4128 = (bitcast<f32>(((_e4096 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4136 = (_e4128 + (((bitcast<f32>(((_e4105 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4128) * _e3984));
let _e4141 = (bitcast<f32>(((_e4114 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4165 = (bitcast<f32>((((_e4096 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4173 = (_e4165 + (((bitcast<f32>((((_e4105 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4165) * _e3984));
let _e4178 = (bitcast<f32>((((_e4114 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4190 = (_e3980 + 2i);
let _e4192 = select(_e3986, _e4190, (_e4190 < _e3986));
let _e4198 = global_3.member[bitcast<u32>(select(0i, _e4192, (_e4192 > 0i)))];
let _e4199 = (_e3980 + 6i);
let _e4201 = select(_e3986, _e4199, (_e4199 < _e3986));
let _e4207 = global_3.member[bitcast<u32>(select(0i, _e4201, (_e4201 > 0i)))];
let _e4208 = (_e3980 + 1026i);
let _e4210 = select(_e3986, _e4208, (_e4208 < _e3986));
let _e4216 = global_3.member[bitcast<u32>(select(0i, _e4210, (_e4210 > 0i)))];
let _e4217 = (_e3980 + 1030i);
let _e4219 = select(_e3986, _e4217, (_e4217 < _e3986));
let _e4225 = global_3.member[bitcast<u32>(select(0i, _e4219, (_e4219 > 0i)))];
let _e4230 = (bitcast<f32>(((_e4198 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4238 = (_e4230 + (((bitcast<f32>(((_e4207 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4230) * _e3984));
let _e4243 = (bitcast<f32>(((_e4216 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4267 = (bitcast<f32>((((_e4198 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4275 = (_e4267 + (((bitcast<f32>((((_e4207 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4267) * _e3984));
let _e4280 = (bitcast<f32>((((_e4216 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4292 = (_e3980 + 3i);
let _e4294 = select(_e3986, _e4292, (_e4292 < _e3986));
let _e4300 = global_3.member[bitcast<u32>(select(0i, _e4294, (_e4294 > 0i)))];
let _e4301 = (_e3980 + 7i);
let _e4303 = select(_e3986, _e4301, (_e4301 < _e3986));
let _e4309 = global_3.member[bitcast<u32>(select(0i, _e4303, (_e4303 > 0i)))];
let _e4310 = (_e3980 + 1027i);
let _e4312 = select(_e3986, _e4310, (_e4310 < _e3986));
let _e4318 = global_3.member[bitcast<u32>(select(0i, _e4312, (_e4312 > 0i)))];
let _e4319 = (_e3980 + 1031i);
let _e4321 = select(_e3986, _e4319, (_e4319 < _e3986));
let _e4327 = global_3.member[bitcast<u32>(select(0i, _e4321, (_e4321 > 0i)))];
let _e4332 = (bitcast<f32>(((_e4300 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4340 = (_e4332 + (((bitcast<f32>(((_e4309 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4332) * _e3984));
let _e4345 = (bitcast<f32>(((_e4318 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4360 = (_e3636 * _e3531.member_1);
let _e4362 = -(((_e4071 + (((_e4076 + (((bitcast<f32>((((_e4021 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4076) * _e3984)) - _e4071) * _e3982)) * _e4360));
let _e4364 = select(-87f, _e4362, (_e4362 > -87f));
let _e4366 = select(88f, _e4364, (_e4364 < 88f));
let _e4368 = ((_e4366 * 1.442695f) + 0.5f);
let _e4370 = select(-127f, _e4368, (_e4368 > -127f));
let _e4372 = select(128f, _e4370, (_e4370 < 128f));
let _e4379 = select(0i, select(select(i32(_e4372), i32(-2147483648), (_e4372 < -2147483600f)), 2147483647i, (_e4372 > 2147483500f)), (_e4372 == _e4372));
let _e4383 = (_e4379 - select(0i, 1i, (_e4372 < f32(_e4379))));
let _e4384 = f32(_e4383);
let _e4388 = ((_e4366 - (_e4384 * 0.6933594f)) - (_e4384 * -2.1219444e-4f));
let _e4410 = -(((_e4136 + (((_e4141 + (((bitcast<f32>(((_e4123 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4141) * _e3984)) - _e4136) * _e3982)) * _e4360));
let _e4412 = select(-87f, _e4410, (_e4410 > -87f));
let _e4414 = select(88f, _e4412, (_e4412 < 88f));
let _e4416 = ((_e4414 * 1.442695f) + 0.5f);
let _e4418 = select(-127f, _e4416, (_e4416 > -127f));
let _e4420 = select(128f, _e4418, (_e4418 < 128f));
let _e4427 = select(0i, select(select(i32(_e4420), i32(-2147483648), (_e4420 < -2147483600f)), 2147483647i, (_e4420 > 2147483500f)), (_e4420 == _e4420));
let _e4431 = (_e4427 - select(0i, 1i, (_e4420 < f32(_e4427))));
let _e4432 = f32(_e4431);
let _e4436 = ((_e4414 - (_e4432 * 0.6933594f)) - (_e4432 * -2.1219444e-4f));
let _e4458 = -(((_e4173 + (((_e4178 + (((bitcast<f32>((((_e4123 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4178) * _e3984)) - _e4173) * _e3982)) * _e4360));
let _e4460 = select(-87f, _e4458, (_e4458 > -87f));
let _e4462 = select(88f, _e4460, (_e4460 < 88f));
let _e4464 = ((_e4462 * 1.442695f) + 0.5f);
let _e4466 = select(-127f, _e4464, (_e4464 > -127f));
let _e4468 = select(128f, _e4466, (_e4466 < 128f));
let _e4475 = select(0i, select(select(i32(_e4468), i32(-2147483648), (_e4468 < -2147483600f)), 2147483647i, (_e4468 > 2147483500f)), (_e4468 == _e4468));
let _e4479 = (_e4475 - select(0i, 1i, (_e4468 < f32(_e4475))));
let _e4480 = f32(_e4479);
let _e4484 = ((_e4462 - (_e4480 * 0.6933594f)) - (_e4480 * -2.1219444e-4f));
let _e4507 = -((_e4050 * (_e3636 * _e3531.member)));
let _e4509 = select(-87f, _e4507, (_e4507 > -87f));
let _e4511 = select(88f, _e4509, (_e4509 < 88f));
let _e4513 = ((_e4511 * 1.442695f) + 0.5f);
let _e4515 = select(-127f, _e4513, (_e4513 > -127f));
let _e4517 = select(128f, _e4515, (_e4515 < 128f));
let _e4524 = select(0i, select(select(i32(_e4517), i32(-2147483648), (_e4517 < -2147483600f)), 2147483647i, (_e4517 > 2147483500f)), (_e4517 == _e4517));
let _e4528 = (_e4524 - select(0i, 1i, (_e4517 < f32(_e4524))));
let _e4529 = f32(_e4528);
let _e4533 = ((_e4511 - (_e4529 * 0.6933594f)) - (_e4529 * -2.1219444e-4f));
let _e4553 = ((1f + (_e4533 * (1f + (_e4533 * (0.5f + (_e4533 * (0.16666667f + (_e4533 * (0.041666668f + (_e4533 * (0.008333334f + (_e4533 * (0.001388889f + (_e4533 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4528 + 127i)) << bitcast<u32>(23i))));
let _e4554 = (1f - _e4553);
let _e4557 = (_e4554 / select(1e-12f, _e4050, (_e4050 > 1e-12f)));
phi_8695_ = type_31(_e4553, _e4554, vec3<f32>(((1f + (_e4388 * (1f + (_e4388 * (0.5f + (_e4388 * (0.16666667f + (_e4388 * (0.041666668f + (_e4388 * (0.008333334f + (_e4388 * (0.001388889f + (_e4388 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4383 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e4436 * (1f + (_e4436 * (0.5f + (_e4436 * (0.16666667f + (_e4436 * (0.041666668f + (_e4436 * (0.008333334f + (_e4436 * (0.001388889f + (_e4436 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4431 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e4484 * (1f + (_e4484 * (0.5f + (_e4484 * (0.16666667f + (_e4484 * (0.041666668f + (_e4484 * (0.008333334f + (_e4484 * (0.001388889f + (_e4484 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4479 + 127i)) << bitcast<u32>(23i))))), vec3<f32>(((_e4238 + (((_e4243 + (((bitcast<f32>(((_e4225 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4243) * _e3984)) - _e4238) * _e3982)) * _e4557), ((_e4275 + (((_e4280 + (((bitcast<f32>((((_e4225 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4280) * _e3984)) - _e4275) * _e3982)) * _e4557), ((_e4340 + (((_e4345 + (((bitcast<f32>(((_e4327 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4345) * _e3984)) - _e4340) * _e3982)) * _e4557)));
}
let _e4564 = phi_8695_;
let _e4565 = select(0f, _e3318, _e449);
let _e4569 = (_e384 + (_e3618 * _e4565));
let _e4570 = (_e387 + (_e3619 * _e4565));
let _e4571 = (_e378 + (_e3620 * _e4565));
if (_e973.member_2 == 3u) {
let _e4577 = global_5.member[_e359].member_9.member_1;
let _e4586 = global_5.member[_e359].member_9.member;
phi_9678_ = type_25(vec3<f32>(_e4577.member, _e4577.member_1, _e4577.member_2), vec3<f32>(_e4586.member, _e4586.member_1, _e4586.member_2));
} else {
let _e4596 = global_5.member[_e359].member_8.member_8;
let _e4597 = (_e4571 - _e4596);
let _e4602 = global_5.member[_e359].member_8.member_2;
let _e4607 = global_5.member[_e359].member_8.member_6;
let _e4615 = global_5.member[_e359].member_8.member_5;
let _e4617 = (((_e4569 - (_e4602 + (_e4607 * _e4597))) * _e4615) - 0.5f);
let _e4622 = global_5.member[_e359].member_8.member_3;
let _e4627 = global_5.member[_e359].member_8.member_7;
let _e4632 = (((_e4570 - (_e4622 + (_e4627 * _e4597))) * _e4615) - 0.5f);
let _e4637 = global_5.member[_e359].member_8.member;
let _e4638 = bitcast<i32>(_e4637);
let _e4640 = (f32(_e4638) - 1f);
let _e4645 = global_5.member[_e359].member_8.member_1;
let _e4648 = (f32(bitcast<i32>(_e4645)) - 1f);
let _e4650 = select(0f, _e4617, (_e4617 > 0f));
let _e4652 = select(_e4640, _e4650, (_e4650 < _e4640));
let _e4659 = select(0i, select(select(i32(_e4652), i32(-2147483648), (_e4652 < -2147483600f)), 2147483647i, (_e4652 > 2147483500f)), (_e4652 == _e4652));
let _e4663 = (_e4659 - select(0i, 1i, (_e4652 < f32(_e4659))));
let _e4665 = select(0f, _e4632, (_e4632 > 0f));
let _e4667 = select(_e4648, _e4665, (_e4665 < _e4648));
let _e4674 = select(0i, select(select(i32(_e4667), i32(-2147483648), (_e4667 < -2147483600f)), 2147483647i, (_e4667 > 2147483500f)), (_e4667 == _e4667));
let _e4678 = (_e4674 - select(0i, 1i, (_e4667 < f32(_e4674))));
let _e4682 = (_e4617 - f32(_e4663));
let _e4684 = (_e4632 - f32(_e4678));
let _e4691 = ((((_e4617 >= 0f) && (_e4617 <= _e4640)) && (_e4632 >= 0f)) && (_e4632 <= _e4648));
let _e4695 = global_5.member[_e359].member_4;
let _e4696 = bitcast<i32>(_e4695);
let _e4698 = bitcast<i32>((_e4637 * _e4645));
let _e4700 = (_e4696 + (3i * _e4698));
local_1 = (_e4700 + ((_e4678 * _e4638) + _e4663));
let _e4702 = local_1;
let _e4704 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e4706 = select(_e4704, _e4702, (_e4702 < _e4704));
let _e4711 = global_6.member[bitcast<u32>(select(0i, _e4706, (_e4706 > 0i)))];
let _e4712 = bitcast<u32>(_e4711);
let _e4716 = f32((bitcast<i32>((_e4712 & 65535u)) - 32768i));
let _e4722 = f32((bitcast<i32>(((_e4712 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4727 = select(_e4722, -(_e4722), ((_e4712 >> bitcast<u32>(31i)) != 0u));
let _e4728 = local_1;
let _e4729 = (_e4728 + 1i);
let _e4731 = select(_e4704, _e4729, (_e4729 < _e4704));
let _e4736 = global_6.member[bitcast<u32>(select(0i, _e4731, (_e4731 > 0i)))];
let _e4737 = bitcast<u32>(_e4736);
let _e4747 = f32((bitcast<i32>(((_e4737 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4753 = local_1;
let _e4754 = (_e4753 + _e4638);
let _e4756 = select(_e4704, _e4754, (_e4754 < _e4704));
let _e4761 = global_6.member[bitcast<u32>(select(0i, _e4756, (_e4756 > 0i)))];
let _e4762 = bitcast<u32>(_e4761);
let _e4766 = f32((bitcast<i32>((_e4762 & 65535u)) - 32768i));
let _e4772 = f32((bitcast<i32>(((_e4762 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4777 = select(_e4772, -(_e4772), ((_e4762 >> bitcast<u32>(31i)) != 0u));
let _e4778 = (_e4638 + 1i);
let _e4779 = local_1;
let _e4780 = (_e4779 + _e4778);
let _e4782 = select(_e4704, _e4780, (_e4780 < _e4704));
let _e4787 = global_6.member[bitcast<u32>(select(0i, _e4782, (_e4782 > 0i)))];
let _e4788 = bitcast<u32>(_e4787);
let _e4798 = f32((bitcast<i32>(((_e4788 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4806 = (_e4716 + ((f32((bitcast<i32>((_e4737 & 65535u)) - 32768i)) - _e4716) * _e4682));
let _e4815 = (_e4727 + ((select(_e4747, -(_e4747), ((_e4737 >> bitcast<u32>(31i)) != 0u)) - _e4727) * _e4682));
let _e4828 = global_5.member[_e359].member_9.member;
let _e4831 = (1f / 16255f);
let _e4833 = (_e4828.member + (select(0f, (_e4806 + (((_e4766 + ((f32((bitcast<i32>((_e4788 & 65535u)) - 32768i)) - _e4766) * _e4682)) - _e4806) * _e4684)), _e4691) * _e4831));
let _e4835 = (_e4828.member_1 + (select(0f, (_e4815 + (((_e4777 + ((select(_e4798, -(_e4798), ((_e4788 >> bitcast<u32>(31i)) != 0u)) - _e4777) * _e4682)) - _e4815) * _e4684)), _e4691) * _e4831));
let _e4839 = (1f - ((_e4833 * _e4833) + (_e4835 * _e4835)));
let _e4841 = select(1e-4f, _e4839, (_e4839 > 1e-4f));
let _e4844 = sqrt(select(0f, _e4841, (_e4841 > 0f)));
let _e4848 = (1f / select(1e-6f, _e4844, (_e4844 > 1e-6f)));
let _e4849 = ((_e4571 - _e378) * _e4615);
let _e4856 = (_e4617 - (((_e4833 * _e4848) - _e4607) * _e4849));
let _e4857 = (_e4632 - (((_e4835 * _e4848) - _e4627) * _e4849));
let _e4859 = select(0f, _e4856, (_e4856 > 0f));
let _e4861 = select(_e4640, _e4859, (_e4859 < _e4640));
let _e4868 = select(0i, select(select(i32(_e4861), i32(-2147483648), (_e4861 < -2147483600f)), 2147483647i, (_e4861 > 2147483500f)), (_e4861 == _e4861));
let _e4872 = (_e4868 - select(0i, 1i, (_e4861 < f32(_e4868))));
let _e4874 = select(0f, _e4857, (_e4857 > 0f));
let _e4876 = select(_e4648, _e4874, (_e4874 < _e4648));
let _e4883 = select(0i, select(select(i32(_e4876), i32(-2147483648), (_e4876 < -2147483600f)), 2147483647i, (_e4876 > 2147483500f)), (_e4876 == _e4876));
let _e4887 = (_e4883 - select(0i, 1i, (_e4876 < f32(_e4883))));
let _e4889 = ((_e4887 * _e4638) + _e4872);
let _e4891 = (_e4856 - f32(_e4872));
let _e4893 = (_e4857 - f32(_e4887));
let _e4900 = ((((_e4856 >= 0f) && (_e4856 <= _e4640)) && (_e4857 >= 0f)) && (_e4857 <= _e4648));
let _e4901 = (_e4696 + _e4889);
let _e4903 = select(_e4704, _e4901, (_e4901 < _e4704));
let _e4909 = global_6.member[bitcast<u32>(select(0i, _e4903, (_e4903 > 0i)))];
let _e4910 = (_e4901 + 1i);
let _e4912 = select(_e4704, _e4910, (_e4910 < _e4704));
let _e4918 = global_6.member[bitcast<u32>(select(0i, _e4912, (_e4912 > 0i)))];
let _e4921 = (_e4909 + ((_e4918 - _e4909) * _e4891));
let _e4922 = (_e4901 + _e4638);
let _e4924 = select(_e4704, _e4922, (_e4922 < _e4704));
let _e4930 = global_6.member[bitcast<u32>(select(0i, _e4924, (_e4924 > 0i)))];
let _e4931 = (_e4922 + 1i);
let _e4933 = select(_e4704, _e4931, (_e4931 < _e4704));
let _e4939 = global_6.member[bitcast<u32>(select(0i, _e4933, (_e4933 > 0i)))];
let _e4946 = select(1f, (_e4921 + (((_e4930 + ((_e4939 - _e4930) * _e4891)) - _e4921) * _e4893)), _e4900);
if _e3637 {
phi_9448_ = vec3(_e4946);
} else {
let _e4949 = ((_e4696 + _e4698) + _e4889);
let _e4951 = select(_e4704, _e4949, (_e4949 < _e4704));
let _e4957 = global_6.member[bitcast<u32>(select(0i, _e4951, (_e4951 > 0i)))];
let _e4958 = (_e4949 + 1i);
let _e4960 = select(_e4704, _e4958, (_e4958 < _e4704));
let _e4966 = global_6.member[bitcast<u32>(select(0i, _e4960, (_e4960 > 0i)))];
let _e4969 = (_e4957 + ((_e4966 - _e4957) * _e4891));
let _e4970 = (_e4949 + _e4638);
let _e4972 = select(_e4704, _e4970, (_e4970 < _e4704));
let _e4978 = global_6.member[bitcast<u32>(select(0i, _e4972, (_e4972 > 0i)))];
let _e4979 = (_e4970 + 1i);
let _e4981 = select(_e4704, _e4979, (_e4979 < _e4704));
let _e4987 = global_6.member[bitcast<u32>(select(0i, _e4981, (_e4981 > 0i)))];
let _e4997 = ((_e4696 + (2i * _e4698)) + _e4889);
let _e4999 = select(_e4704, _e4997, (_e4997 < _e4704));
let _e5005 = global_6.member[bitcast<u32>(select(0i, _e4999, (_e4999 > 0i)))];
let _e5006 = (_e4997 + 1i);
let _e5008 = select(_e4704, _e5006, (_e5006 < _e4704));
let _e5014 = global_6.member[bitcast<u32>(select(0i, _e5008, (_e5008 > 0i)))];
let _e5017 = (_e5005 + ((_e5014 - _e5005) * _e4891));
let _e5018 = (_e4997 + _e4638);
let _e5020 = select(_e4704, _e5018, (_e5018 < _e4704));
let _e5026 = global_6.member[bitcast<u32>(select(0i, _e5020, (_e5020 > 0i)))];
let _e5027 = (_e5018 + 1i);
let _e5029 = select(_e4704, _e5027, (_e5027 < _e4704));
let _e5035 = global_6.member[bitcast<u32>(select(0i, _e5029, (_e5029 > 0i)))];
phi_9448_ = vec3<f32>(_e4946, select(1f, (_e4969 + (((_e4978 + ((_e4987 - _e4978) * _e4891)) - _e4969) * _e4893)), _e4900), select(1f, (_e5017 + (((_e5026 + ((_e5035 - _e5026) * _e4891)) - _e5017) * _e4893)), _e4900));
}
let _e5045 = phi_9448_;
local = (_e4700 + _e4889);
let _e5047 = local;
let _e5049 = select(_e4704, _e5047, (_e5047 < _e4704));
let _e5054 = global_6.member[bitcast<u32>(select(0i, _e5049, (_e5049 > 0i)))];
let _e5055 = bitcast<u32>(_e5054);
let _e5059 = f32((bitcast<i32>((_e5055 & 65535u)) - 32768i));
let _e5065 = f32((bitcast<i32>(((_e5055 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e5070 = select(_e5065, -(_e5065), ((_e5055 >> bitcast<u32>(31i)) != 0u));
let _e5071 = local;
let _e5072 = (_e5071 + 1i);
let _e5074 = select(_e4704, _e5072, (_e5072 < _e4704));
let _e5079 = global_6.member[bitcast<u32>(select(0i, _e5074, (_e5074 > 0i)))];
let _e5080 = bitcast<u32>(_e5079);
let _e5090 = f32((bitcast<i32>(((_e5080 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e5096 = local;
let _e5097 = (_e5096 + _e4638);
let _e5099 = select(_e4704, _e5097, (_e5097 < _e4704));
let _e5104 = global_6.member[bitcast<u32>(select(0i, _e5099, (_e5099 > 0i)))];
let _e5105 = bitcast<u32>(_e5104);
let _e5109 = f32((bitcast<i32>((_e5105 & 65535u)) - 32768i));
let _e5115 = f32((bitcast<i32>(((_e5105 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e5120 = select(_e5115, -(_e5115), ((_e5105 >> bitcast<u32>(31i)) != 0u));
let _e5121 = local;
let _e5122 = (_e5121 + _e4778);
let _e5124 = select(_e4704, _e5122, (_e5122 < _e4704));
let _e5129 = global_6.member[bitcast<u32>(select(0i, _e5124, (_e5124 > 0i)))];
let _e5130 = bitcast<u32>(_e5129);
let _e5140 = f32((bitcast<i32>(((_e5130 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e5148 = (_e5059 + ((f32((bitcast<i32>((_e5080 & 65535u)) - 32768i)) - _e5059) * _e4891));
let _e5157 = (_e5070 + ((select(_e5090, -(_e5090), ((_e5080 >> bitcast<u32>(31i)) != 0u)) - _e5070) * _e4891));
let _e5170 = global_5.member[_e359].member_9.member_1;
let _e5177 = (_e4828.member + (select(0f, (_e5148 + (((_e5109 + ((f32((bitcast<i32>((_e5130 & 65535u)) - 32768i)) - _e5109) * _e4891)) - _e5148) * _e4893)), _e4900) * _e4831));
let _e5179 = (_e4828.member_1 + (select(0f, (_e5157 + (((_e5120 + ((select(_e5140, -(_e5140), ((_e5130 >> bitcast<u32>(31i)) != 0u)) - _e5120) * _e4891)) - _e5157) * _e4893)), _e4900) * _e4831));
let _e5183 = (1f - ((_e5177 * _e5177) + (_e5179 * _e5179)));
let _e5185 = select(1e-4f, _e5183, (_e5183 > 1e-4f));
phi_9678_ = type_25((_e5045 * vec3<f32>(_e5170.member, _e5170.member_1, _e5170.member_2)), vec3<f32>(_e5177, _e5179, sqrt(select(0f, _e5185, (_e5185 > 0f)))));
}
let _e5192 = phi_9678_;
let _e5201 = (((_e5192.member_1.x * _e5192.member_1.x) + (_e5192.member_1.y * _e5192.member_1.y)) + (_e5192.member_1.z * _e5192.member_1.z));
let _e5204 = sqrt(select(0f, _e5201, (_e5201 > 0f)));
let _e5210 = (1e-6f * _e5204);
let _e5214 = select((_e5204 / select(_e5210, _e5192.member_1.z, (_e5192.member_1.z > _e5210))), 1f, ((_e929 & 8u) != 0u));
let _e5216 = (_e5192.member.x * _e5214);
let _e5218 = (_e5192.member.y * _e5214);
let _e5220 = (_e5192.member.z * _e5214);
if _e1036 {
let _e5225 = global_5.member[_e359].member_19;
let _e5234 = (((_e2715.member_1.x * _e2715.member_1.x) + (_e2715.member_1.y * _e2715.member_1.y)) + (_e2715.member_1.z * _e2715.member_1.z));
let _e5237 = sqrt(select(0f, _e5234, (_e5234 > 0f)));
let _e5240 = (1f / select(1e-20f, _e5237, (_e5237 > 1e-20f)));
let _e5241 = (_e2715.member_1.x * _e5240);
let _e5242 = (_e2715.member_1.y * _e5240);
let _e5243 = (_e2715.member_1.z * _e5240);
let _e5246 = (-1f / select(1e-20f, _e5204, (_e5204 > 1e-20f)));
let _e5247 = (_e5192.member_1.x * _e5246);
let _e5248 = (_e5192.member_1.y * _e5246);
let _e5249 = (_e5192.member_1.z * _e5246);
let _e5254 = (((_e363[2] * _e363[2]) + (_e363[3] * _e363[3])) + (_e363[4] * _e363[4]));
let _e5257 = sqrt(select(0f, _e5254, (_e5254 > 0f)));
let _e5260 = (-1f / select(1e-20f, _e5257, (_e5257 > 1e-20f)));
let _e5261 = (_e363[2] * _e5260);
let _e5262 = (_e363[3] * _e5260);
let _e5263 = (_e363[4] * _e5260);
let _e5270 = select(1f, -1f, ((((_e5241 * _e5261) + (_e5242 * _e5262)) + (_e5243 * _e5263)) < 0f));
let _e5271 = (_e5241 * _e5270);
let _e5272 = (_e5242 * _e5270);
let _e5273 = (_e5243 * _e5270);
let _e5278 = (((_e5271 * _e5261) + (_e5272 * _e5262)) + (_e5273 * _e5263));
let _e5280 = select(1e-4f, _e5278, (_e5278 > 1e-4f));
let _e5285 = (((_e5271 * _e5247) + (_e5272 * _e5248)) + (_e5273 * _e5249));
let _e5286 = (_e5247 + _e5261);
let _e5287 = (_e5248 + _e5262);
let _e5288 = (_e5249 + _e5263);
let _e5293 = (((_e5286 * _e5286) + (_e5287 * _e5287)) + (_e5288 * _e5288));
let _e5296 = sqrt(select(0f, _e5293, (_e5293 > 0f)));
let _e5299 = (1f / select(1e-6f, _e5296, (_e5296 > 1e-6f)));
let _e5300 = (_e5286 * _e5299);
let _e5301 = (_e5287 * _e5299);
let _e5302 = (_e5288 * _e5299);
let _e5307 = (((_e5271 * _e5300) + (_e5272 * _e5301)) + (_e5273 * _e5302));
let _e5309 = select(0f, _e5307, (_e5307 > 0f));
let _e5314 = (((_e5261 * _e5300) + (_e5262 * _e5301)) + (_e5263 * _e5302));
let _e5316 = select(0f, _e5314, (_e5314 > 0f));
let _e5317 = (_e5225 * _e5225);
let _e5318 = (_e5317 * _e5317);
let _e5322 = (((_e5309 * _e5309) * (_e5318 - 1f)) + 1f);
let _e5326 = (_e5285 > 0f);
let _e5327 = select(0f, _e5285, _e5326);
let _e5329 = (1f - _e5318);
let _e5331 = (((_e5327 * _e5327) * _e5329) + _e5318);
let _e5338 = (((_e5280 * _e5280) * _e5329) + _e5318);
let _e5343 = ((_e5280 * sqrt(select(0f, _e5331, (_e5331 > 0f)))) + (_e5327 * sqrt(select(0f, _e5338, (_e5338 > 0f)))));
let _e5348 = (_e2715.member_2 / _e3315);
let _e5352 = (((_e5348 * _e5348) - 1f) + (_e5316 * _e5316));
let _e5355 = sqrt(select(0f, _e5352, (_e5352 > 0f)));
let _e5356 = (_e5355 - _e5316);
let _e5357 = (_e5355 + _e5316);
let _e5360 = (_e5356 / select(1e-6f, _e5357, (_e5357 > 1e-6f)));
let _e5364 = ((_e5316 * _e5356) + 1f);
let _e5367 = (((_e5316 * _e5357) - 1f) / select(1e-6f, _e5364, (_e5364 > 1e-6f)));
let _e5385 = global_5.member[_e359].member_20;
let _e5389 = ((select(0f, ((((_e5318 / ((3.1415927f * _e5322) * _e5322)) * (0.5f / select(1e-6f, _e5343, (_e5343 > 1e-6f)))) * select(select((((0.5f * _e5360) * _e5360) * (1f + (_e5367 * _e5367))), 1f, (_e5352 <= 0f)), 0f, (_e3315 == _e2715.member_2))) * _e5327), (_e5326 && (_e5237 > 1e-12f))) * _e5385) * select(_e3531.member_2, 0f, _e449));
phi_9996_ = vec3<f32>((_e5216 * _e5389), (_e5218 * _e5389), (_e5220 * _e5389));
} else {
phi_9996_ = vec3<f32>(0f, 0f, 0f);
}
let _e5395 = phi_9996_;
let _e5406 = global_5.member[_e359].member_18;
let _e5413 = (1f - _e363[11]);
let _e5433 = (_e363[8] + ((_e363[12] * ((_e4564.member_3.x * (_e5216 + _e5406.member)) + _e5395.x)) * _e5413));
let _e5434 = (_e363[9] + ((_e363[13] * ((_e4564.member_3.y * (_e5218 + _e5406.member_1)) + _e5395.y)) * _e5413));
let _e5435 = (_e363[10] + ((_e363[14] * ((_e4564.member_3.z * (_e5220 + _e5406.member_2)) + _e5395.z)) * _e5413));
let _e5438 = (_e363[11] + (_e5413 * _e4564.member_1));
let _e5441 = (_e363[12] * _e4564.member_2.x);
let _e5443 = (_e363[13] * _e4564.member_2.y);
let _e5445 = (_e363[14] * _e4564.member_2.z);
let _e5451 = (_e363[7] + ((_e5438 - _e363[11]) * (_e378 + (_e3620 * 0.5f))));
let _e5460 = (-((((select(_e1006.member, _e993.member, _e986) * _e5192.member_1.x) + (select(_e1006.member_1, _e993.member_1, _e986) * _e5192.member_1.y)) + (select(_e1006.member_2, _e993.member_2, _e986) * _e5192.member_1.z))) / select(1e-20f, _e5204, (_e5204 > 1e-20f)));
let _e5465 = bitcast<f32>((bitcast<u32>(select(0f, _e5460, (_e5460 > 0f))) & 2147483647u));
let _e5475 = (1f - _e5438);
let _e5488 = select(_e5438, 1f, _e449);
if _e1036 {
let _e5497 = global_5.member[_e359].member_5.member_4;
let _e5500 = (_e2715.member_3.x * _e3531.member_2);
let _e5502 = (_e2715.member_3.y * _e3531.member_2);
let _e5504 = (_e2715.member_3.z * _e3531.member_2);
let _e5505 = (0.5f * _e373);
let _e5509 = (_e363[2] + (_e5500 * _e5505));
let _e5510 = (_e363[3] + (_e5502 * _e5505));
let _e5511 = (_e363[4] + (_e5504 * _e5505));
let _e5513 = (2f * _e372);
let _e5515 = ((_e5511 * _e5511) + (_e5513 * _e5504));
let _e5519 = (_e5511 + sqrt(select(0f, _e5515, (_e5515 > 0f))));
let _e5523 = (0.5f * (_e5513 / select(1e-6f, _e5519, (_e5519 > 1e-6f))));
let _e5527 = (_e5509 + (_e5500 * _e5523));
let _e5528 = (_e5510 + (_e5502 * _e5523));
let _e5529 = (_e5511 + (_e5504 * _e5523));
let _e5533 = (_e5497 * _e5497);
let _e5535 = (_e5529 * _e5529);
let _e5543 = (((_e5511 <= 0f) || (_e5515 <= 0f)) || ((_e5529 <= 0f) || (_e5535 <= (_e5533 * (((_e5527 * _e5527) + (_e5528 * _e5528)) + _e5535)))));
let _e5557 = (_e363[2] + ((_e2715.member_4.x * _e3531.member_2) * _e372));
let _e5558 = (_e363[3] + ((_e2715.member_4.y * _e3531.member_2) * _e372));
let _e5559 = (_e363[4] + ((_e2715.member_4.z * _e3531.member_2) * _e372));
let _e5561 = (_e5559 * _e5559);
let _e5570 = ((_e929 & 1u) != 0u);
phi_10305_ = select(select(_e5529, _e5511, _e5543), _e5559, _e5570);
phi_10306_ = select(select(_e5528, _e5510, _e5543), _e5558, _e5570);
phi_10307_ = select(select(_e5527, _e5509, _e5543), _e5557, _e5570);
phi_10308_ = select(_e5543, ((_e5559 <= 0f) || (_e5561 <= (_e5533 * (((_e5557 * _e5557) + (_e5558 * _e5558)) + _e5561)))), _e5570);
} else {
phi_10305_ = _e363[4];
phi_10306_ = _e363[3];
phi_10307_ = _e363[2];
phi_10308_ = false;
}
let _e5576 = phi_10305_;
let _e5578 = phi_10306_;
let _e5580 = phi_10307_;
let _e5582 = phi_10308_;
let _e5588 = (((_e449 || (_e5580 != _e363[2])) || (_e5578 != _e363[3])) || (_e5576 != _e363[4]));
let _e5590 = select(_e5443, _e5441, (_e5441 > _e5443));
phi_10368_ = array<f32, 18>(select(_e363[0], select(_e389, _e4569, _e449), _e5588), select(_e363[1], select(_e391, _e4570, _e449), _e5588), _e5580, _e5578, _e5576, _e2715.member, select(select(0f, 2f, _e5582), 1f, (_e449 || (((1f - _e5488) * select(_e5445, _e5590, (_e5590 > _e5445))) < 9.765625e-4f))), select(_e5451, (_e5451 + (_e5475 * _e4571)), _e449), select(_e5433, (_e5433 + ((_e5441 * (select(_e1012.member, _e999.member, _e986) * ((_e5216 * _e5465) + _e5406.member))) * _e5475)), _e449), select(_e5434, (_e5434 + ((_e5443 * (select(_e1012.member_1, _e999.member_1, _e986) * ((_e5218 * _e5465) + _e5406.member_1))) * _e5475)), _e449), select(_e5435, (_e5435 + ((_e5445 * (select(_e1012.member_2, _e999.member_2, _e986) * ((_e5220 * _e5465) + _e5406.member_2))) * _e5475)), _e449), _e5488, _e5441, _e5443, _e5445, _e2715.member_2, select(_e363[16], select(_e396, _e4571, _e449), _e5588), _e396);
} else {
phi_10368_ = _e363;
}
let _e5609 = phi_10368_;
phi_587_ = (_e359 + 1u);
phi_590_ = select(_e361, true, _e969);
phi_592_ = _e5609;
} else {
phi_587_ = u32();
phi_590_ = bool();
phi_592_ = array<f32, 18>();
}
let _e5613 = phi_587_;
let _e5615 = phi_590_;
let _e5617 = phi_592_;
continue;
continuing {
phi_586_ = _e5613;
phi_589_ = _e5615;
phi_591_ = _e5617;
phi_10451_ = false;
break if !(_e364);
}
}
let _e5620 = phi_10451_;
if _e5620 {
break;
}
let _e5622 = local_12;
if _e5622 {
let _e5624 = local_13;
global_4.member[_e159] = _e5624[0];
let _e5629 = local_14;
global_4.member[_e171] = _e5629[1];
let _e5634 = local_15;
global_4.member[_e182] = _e5634[2];
let _e5639 = local_16;
global_4.member[_e193] = _e5639[3];
let _e5644 = local_17;
global_4.member[_e204] = _e5644[4];
let _e5649 = local_18;
global_4.member[_e215] = _e5649[5];
let _e5654 = local_19;
global_4.member[_e226] = _e5654[6];
let _e5659 = local_20;
global_4.member[_e237] = _e5659[7];
let _e5664 = local_21;
global_4.member[_e248] = _e5664[8];
let _e5669 = local_22;
global_4.member[_e259] = _e5669[9];
let _e5674 = local_23;
global_4.member[_e270] = _e5674[10];
let _e5679 = local_24;
global_4.member[_e281] = _e5679[11];
let _e5684 = local_25;
global_4.member[_e292] = _e5684[12];
let _e5689 = local_26;
global_4.member[_e303] = _e5689[13];
let _e5694 = local_27;
global_4.member[_e314] = _e5694[14];
let _e5699 = local_28;
global_4.member[_e325] = _e5699[15];
let _e5704 = local_29;
global_4.member[_e336] = _e5704[16];
let _e5709 = local_30;
global_4.member[_e347] = _e5709[17];
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
