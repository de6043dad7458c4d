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
var phi_628_: u32;
var phi_631_: bool;
var phi_633_: array<f32, 23>;
var phi_997_: bool;
var phi_1893_: type_32;
var phi_2114_: vec3<f32>;
var phi_2863_: vec3<f32>;
var phi_3612_: vec3<f32>;
var phi_4361_: vec3<f32>;
var phi_4938_: f32;
var phi_5146_: vec3<f32>;
var phi_5700_: bool;
var phi_5913_: vec3<f32>;
var phi_6464_: bool;
var phi_6678_: vec3<f32>;
var phi_7229_: bool;
var phi_7443_: vec3<f32>;
var phi_7994_: bool;
var phi_8207_: vec3<f32>;
var phi_8758_: bool;
var phi_8768_: f32;
var phi_8769_: f32;
var phi_8787_: array<f32, 23>;
var phi_629_: u32;
var phi_632_: bool;
var phi_634_: array<f32, 23>;
var phi_8890_: bool;
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
let _e79 = global;
let _e81 = arrayLength((&global_2.member));
let _e84 = arrayLength((&global_1.member));
if (0u < _e81) {
} else {
break;
}
let _e93 = global_2.member[0u].member_2;
let _e97 = global_2.member[0u].member;
let _e105 = (_e79.x + _e93.member);
let _e107 = (_e79.y + _e93.member_1);
if (_e105 < _e93.member_2) {
if (_e107 < _e93.member_3) {
let _e110 = (_e97.member * _e97.member_1);
let _e112 = ((_e107 * _e97.member) + _e105);
let _e113 = bitcast<i32>(_e112);
let _e115 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e117 = select(_e115, _e113, (_e113 < _e115));
let _e123 = global_4.member[bitcast<u32>(select(0i, _e117, (_e117 > 0i)))];
let _e124 = (_e110 + _e112);
let _e125 = bitcast<i32>(_e124);
let _e127 = select(_e115, _e125, (_e125 < _e115));
let _e133 = global_4.member[bitcast<u32>(select(0i, _e127, (_e127 > 0i)))];
let _e135 = ((2u * _e110) + _e112);
let _e136 = bitcast<i32>(_e135);
let _e138 = select(_e115, _e136, (_e136 < _e115));
let _e144 = global_4.member[bitcast<u32>(select(0i, _e138, (_e138 > 0i)))];
let _e146 = ((3u * _e110) + _e112);
let _e147 = bitcast<i32>(_e146);
let _e149 = select(_e115, _e147, (_e147 < _e115));
let _e155 = global_4.member[bitcast<u32>(select(0i, _e149, (_e149 > 0i)))];
let _e157 = ((4u * _e110) + _e112);
let _e158 = bitcast<i32>(_e157);
let _e160 = select(_e115, _e158, (_e158 < _e115));
let _e166 = global_4.member[bitcast<u32>(select(0i, _e160, (_e160 > 0i)))];
let _e168 = ((5u * _e110) + _e112);
let _e169 = bitcast<i32>(_e168);
let _e171 = select(_e115, _e169, (_e169 < _e115));
let _e177 = global_4.member[bitcast<u32>(select(0i, _e171, (_e171 > 0i)))];
let _e179 = ((6u * _e110) + _e112);
let _e180 = bitcast<i32>(_e179);
let _e182 = select(_e115, _e180, (_e180 < _e115));
let _e188 = global_4.member[bitcast<u32>(select(0i, _e182, (_e182 > 0i)))];
let _e190 = ((7u * _e110) + _e112);
let _e191 = bitcast<i32>(_e190);
let _e193 = select(_e115, _e191, (_e191 < _e115));
let _e199 = global_4.member[bitcast<u32>(select(0i, _e193, (_e193 > 0i)))];
let _e201 = ((8u * _e110) + _e112);
let _e202 = bitcast<i32>(_e201);
let _e204 = select(_e115, _e202, (_e202 < _e115));
let _e210 = global_4.member[bitcast<u32>(select(0i, _e204, (_e204 > 0i)))];
let _e212 = ((9u * _e110) + _e112);
let _e213 = bitcast<i32>(_e212);
let _e215 = select(_e115, _e213, (_e213 < _e115));
let _e221 = global_4.member[bitcast<u32>(select(0i, _e215, (_e215 > 0i)))];
let _e223 = ((10u * _e110) + _e112);
let _e224 = bitcast<i32>(_e223);
let _e226 = select(_e115, _e224, (_e224 < _e115));
let _e232 = global_4.member[bitcast<u32>(select(0i, _e226, (_e226 > 0i)))];
let _e234 = ((11u * _e110) + _e112);
let _e235 = bitcast<i32>(_e234);
let _e237 = select(_e115, _e235, (_e235 < _e115));
let _e243 = global_4.member[bitcast<u32>(select(0i, _e237, (_e237 > 0i)))];
let _e245 = ((12u * _e110) + _e112);
let _e246 = bitcast<i32>(_e245);
let _e248 = select(_e115, _e246, (_e246 < _e115));
let _e254 = global_4.member[bitcast<u32>(select(0i, _e248, (_e248 > 0i)))];
let _e256 = ((13u * _e110) + _e112);
let _e257 = bitcast<i32>(_e256);
let _e259 = select(_e115, _e257, (_e257 < _e115));
let _e265 = global_4.member[bitcast<u32>(select(0i, _e259, (_e259 > 0i)))];
let _e267 = ((14u * _e110) + _e112);
let _e268 = bitcast<i32>(_e267);
let _e270 = select(_e115, _e268, (_e268 < _e115));
let _e276 = global_4.member[bitcast<u32>(select(0i, _e270, (_e270 > 0i)))];
let _e278 = ((15u * _e110) + _e112);
let _e279 = bitcast<i32>(_e278);
let _e281 = select(_e115, _e279, (_e279 < _e115));
let _e287 = global_4.member[bitcast<u32>(select(0i, _e281, (_e281 > 0i)))];
let _e289 = ((16u * _e110) + _e112);
let _e290 = bitcast<i32>(_e289);
let _e292 = select(_e115, _e290, (_e290 < _e115));
let _e298 = global_4.member[bitcast<u32>(select(0i, _e292, (_e292 > 0i)))];
let _e300 = ((17u * _e110) + _e112);
let _e301 = bitcast<i32>(_e300);
let _e303 = select(_e115, _e301, (_e301 < _e115));
let _e309 = global_4.member[bitcast<u32>(select(0i, _e303, (_e303 > 0i)))];
let _e311 = ((18u * _e110) + _e112);
let _e312 = bitcast<i32>(_e311);
let _e314 = select(_e115, _e312, (_e312 < _e115));
let _e320 = global_4.member[bitcast<u32>(select(0i, _e314, (_e314 > 0i)))];
let _e322 = ((19u * _e110) + _e112);
let _e323 = bitcast<i32>(_e322);
let _e325 = select(_e115, _e323, (_e323 < _e115));
let _e331 = global_4.member[bitcast<u32>(select(0i, _e325, (_e325 > 0i)))];
let _e333 = ((20u * _e110) + _e112);
let _e334 = bitcast<i32>(_e333);
let _e336 = select(_e115, _e334, (_e334 < _e115));
let _e342 = global_4.member[bitcast<u32>(select(0i, _e336, (_e336 > 0i)))];
let _e344 = ((21u * _e110) + _e112);
let _e345 = bitcast<i32>(_e344);
let _e347 = select(_e115, _e345, (_e345 < _e115));
let _e353 = global_4.member[bitcast<u32>(select(0i, _e347, (_e347 > 0i)))];
let _e355 = ((22u * _e110) + _e112);
let _e356 = bitcast<i32>(_e355);
let _e358 = select(_e115, _e356, (_e356 < _e115));
let _e364 = global_4.member[bitcast<u32>(select(0i, _e358, (_e358 > 0i)))];
phi_628_ = 0u;
phi_631_ = false;
phi_633_ = array<f32, 23>(_e123, _e133, _e144, _e155, _e166, _e177, _e188, _e199, _e210, _e221, _e232, _e243, _e254, _e265, _e276, _e287, _e298, _e309, _e320, _e331, _e342, _e353, _e364);
loop {
let _e367 = phi_628_;
let _e369 = phi_631_;
let _e371 = phi_633_;
local_18 = _e369;
local_19 = _e371;
local_20 = _e371;
local_21 = _e371;
local_22 = _e371;
local_23 = _e371;
local_24 = _e371;
local_25 = _e371;
local_26 = _e371;
local_27 = _e371;
local_28 = _e371;
local_29 = _e371;
local_30 = _e371;
local_31 = _e371;
local_32 = _e371;
local_33 = _e371;
local_34 = _e371;
local_35 = _e371;
local_36 = _e371;
local_37 = _e371;
local_38 = _e371;
local_39 = _e371;
local_40 = _e371;
local_41 = _e371;
let _e372 = (_e367 < _e81);
if _e372 {
if _e372 {
} else {
phi_8890_ = true;
break;
}
let _e376 = global_2.member[_e367].member;
let _e391 = global_2.member[_e367].member_7.member;
let _e393 = ((_e391 - _e371[2]) / _e371[5]);
let _e398 = global_2.member[_e367].member_7.member_2;
let _e399 = (_e398 / _e371[5]);
let _e401 = (_e371[0] + (_e371[3] * _e393));
let _e403 = (_e371[1] + (_e371[4] * _e393));
let _e405 = (_e401 + (_e371[3] * _e399));
let _e407 = (_e403 + (_e371[4] * _e399));
let _e412 = global_2.member[_e367].member_7.member_1;
let _e417 = global_2.member[_e367].member_8.member;
let _e428 = ((((_e417.member.member * _e401) + (_e417.member.member_1 * _e403)) + (_e417.member.member_2 * _e391)) + _e417.member_1);
let _e433 = global_2.member[_e367].member_8.member_1;
let _e444 = ((((_e433.member.member * _e401) + (_e433.member.member_1 * _e403)) + (_e433.member.member_2 * _e391)) + _e433.member_1);
let _e449 = global_2.member[_e367].member_8.member_2;
let _e460 = ((((_e449.member.member * _e401) + (_e449.member.member_1 * _e403)) + (_e449.member.member_2 * _e391)) + _e449.member_1);
let _e466 = ((((_e417.member.member * _e405) + (_e417.member.member_1 * _e407)) + (_e417.member.member_2 * _e412)) + _e417.member_1);
let _e472 = ((((_e433.member.member * _e405) + (_e433.member.member_1 * _e407)) + (_e433.member.member_2 * _e412)) + _e433.member_1);
let _e478 = ((((_e449.member.member * _e405) + (_e449.member.member_1 * _e407)) + (_e449.member.member_2 * _e412)) + _e449.member_1);
let _e484 = global_2.member[_e367].member_8.member_4.member;
let _e490 = global_2.member[_e367].member_8.member_5.member;
let _e492 = select(_e484, _e466, (_e466 > _e484));
let _e494 = select(_e490, _e492, (_e492 < _e490));
let _e500 = global_2.member[_e367].member_8.member_4.member_1;
let _e506 = global_2.member[_e367].member_8.member_5.member_1;
let _e508 = select(_e500, _e472, (_e472 > _e500));
let _e510 = select(_e506, _e508, (_e508 < _e506));
let _e516 = global_2.member[_e367].member_8.member_4.member_2;
let _e522 = global_2.member[_e367].member_8.member_5.member_2;
let _e524 = select(_e516, _e478, (_e478 > _e516));
let _e526 = select(_e522, _e524, (_e524 < _e522));
let _e532 = bitcast<f32>((bitcast<u32>((_e466 - _e428)) & 2147483647u));
let _e535 = bitcast<f32>((bitcast<u32>((_e472 - _e444)) & 2147483647u));
let _e537 = select(_e535, _e532, (_e532 > _e535));
let _e540 = bitcast<f32>((bitcast<u32>((_e478 - _e460)) & 2147483647u));
let _e547 = global_2.member[_e367].member_8.member_6;
let _e548 = (select(_e540, _e537, (_e537 > _e540)) <= _e547);
let _e554 = bitcast<f32>((bitcast<u32>((_e466 - _e494)) & 2147483647u));
let _e557 = bitcast<f32>((bitcast<u32>((_e472 - _e510)) & 2147483647u));
let _e559 = select(_e557, _e554, (_e554 > _e557));
let _e562 = bitcast<f32>((bitcast<u32>((_e478 - _e526)) & 2147483647u));
let _e572 = global_2.member[_e367].member_8.member_3.member;
let _e573 = (_e494 + 0.5f);
let _e574 = (_e572 - 1f);
let _e576 = select(0f, _e573, (_e573 > 0f));
let _e578 = select(_e574, _e576, (_e576 < _e574));
let _e585 = select(0i, select(select(i32(_e578), i32(-2147483648), (_e578 < -2147483600f)), 2147483647i, (_e578 > 2147483500f)), (_e578 == _e578));
let _e594 = global_2.member[_e367].member_8.member_14;
let _e595 = (_e594 & 31u);
let _e603 = global_2.member[_e367].member_8.member_3.member_1;
let _e604 = (_e510 + 0.5f);
let _e605 = (_e603 - 1f);
let _e607 = select(0f, _e604, (_e604 > 0f));
let _e609 = select(_e605, _e607, (_e607 < _e605));
let _e616 = select(0i, select(select(i32(_e609), i32(-2147483648), (_e609 < -2147483600f)), 2147483647i, (_e609 > 2147483500f)), (_e609 == _e609));
let _e628 = global_2.member[_e367].member_8.member_3.member_2;
let _e629 = (_e526 + 0.5f);
let _e630 = (_e628 - 1f);
let _e632 = select(0f, _e629, (_e629 > 0f));
let _e634 = select(_e630, _e632, (_e632 < _e630));
let _e641 = select(0i, select(select(i32(_e634), i32(-2147483648), (_e634 < -2147483600f)), 2147483647i, (_e634 > 2147483500f)), (_e634 == _e634));
let _e653 = global_2.member[_e367].member_8.member_11.member;
let _e660 = global_2.member[_e367].member_8.member_11.member_1;
let _e666 = global_2.member[_e367].member_8.member_12;
let _e672 = ((bitcast<i32>(_e666) + ((_e585 - select(0i, 1i, (_e578 < f32(_e585)))) >> bitcast<u32>(_e595))) + (bitcast<i32>(_e653) * (((_e616 - select(0i, 1i, (_e609 < f32(_e616)))) >> bitcast<u32>(_e595)) + (bitcast<i32>(_e660) * ((_e641 - select(0i, 1i, (_e634 < f32(_e641)))) >> bitcast<u32>(_e595))))));
let _e674 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e676 = select(_e674, _e672, (_e672 < _e674));
let _e682 = global_3.member[bitcast<u32>(select(0i, _e676, (_e676 > 0i)))];
let _e683 = bitcast<f32>(_e682);
let _e684 = (_e371[17] == -1.2676506e30f);
let _e685 = (_e376.member_2 == 0u);
if _e685 {
phi_997_ = (_e683 <= _e371[6]);
} else {
phi_997_ = (_e683 >= _e371[6]);
}
let _e689 = phi_997_;
let _e691 = !(_e684);
let _e698 = global_2.member[_e367].member_1;
let _e706 = (_e484 + 0.5f);
let _e708 = (_e490 - 0.5f);
let _e711 = (_e500 + 0.5f);
let _e714 = (_e506 - 0.5f);
let _e717 = (_e516 + 0.5f);
let _e720 = (_e522 - 0.5f);
let _e736 = ((_e698 & 16u) == 0u);
let _e743 = (select(0u, select(select(7u, 3u, (((((((((_e428 >= _e706) && (_e428 <= _e708)) && (_e444 >= _e711)) && (_e444 <= _e714)) && (_e460 >= _e717)) && (_e460 <= _e720)) && ((((((_e466 >= _e706) && (_e466 <= _e708)) && (_e472 >= _e711)) && (_e472 <= _e714)) && (_e478 >= _e717)) && (_e478 <= _e720))) && _e736) && _e691)), 1u, (((_e548 && (select(_e562, _e559, (_e559 > _e562)) > _e547)) || (((((_e376.member_2 != 2u) && _e691) && _e548) && _e689) && ((_e698 & 32u) != 0u))) || ((_e698 & 64u) != 0u))), (_e371[7] == 0f)) > 1u);
if _e743 {
let _e758 = (_e484 - _e428);
let _e759 = (_e484 - _e466);
let _e766 = bitcast<f32>((bitcast<u32>((_e758 - _e759)) & 2147483647u));
let _e769 = (bitcast<f32>((bitcast<u32>(_e758) & 2147483647u)) / select(1e-30f, _e766, (_e766 > 1e-30f)));
let _e771 = select(0f, _e769, (_e769 > 0f));
let _e773 = select(1f, _e771, (_e771 < 1f));
let _e775 = (_e759 > 0f);
let _e777 = select(0f, select(_e773, 2f, _e775), (_e758 > 0f));
let _e780 = select(1f, _e773, (_e775 && (_e758 <= 0f)));
let _e782 = select(_e777, 0f, (0f > _e777));
let _e784 = select(_e780, 1f, (1f < _e780));
let _e785 = (_e428 - _e490);
let _e786 = (_e466 - _e490);
let _e793 = bitcast<f32>((bitcast<u32>((_e785 - _e786)) & 2147483647u));
let _e796 = (bitcast<f32>((bitcast<u32>(_e785) & 2147483647u)) / select(1e-30f, _e793, (_e793 > 1e-30f)));
let _e798 = select(0f, _e796, (_e796 > 0f));
let _e800 = select(1f, _e798, (_e798 < 1f));
let _e802 = (_e786 > 0f);
let _e804 = select(0f, select(_e800, 2f, _e802), (_e785 > 0f));
let _e807 = select(1f, _e800, (_e802 && (_e785 <= 0f)));
let _e809 = select(_e804, _e782, (_e782 > _e804));
let _e811 = select(_e807, _e784, (_e784 < _e807));
let _e812 = (_e500 - _e444);
let _e813 = (_e500 - _e472);
let _e820 = bitcast<f32>((bitcast<u32>((_e812 - _e813)) & 2147483647u));
let _e823 = (bitcast<f32>((bitcast<u32>(_e812) & 2147483647u)) / select(1e-30f, _e820, (_e820 > 1e-30f)));
let _e825 = select(0f, _e823, (_e823 > 0f));
let _e827 = select(1f, _e825, (_e825 < 1f));
let _e829 = (_e813 > 0f);
let _e831 = select(0f, select(_e827, 2f, _e829), (_e812 > 0f));
let _e834 = select(1f, _e827, (_e829 && (_e812 <= 0f)));
let _e836 = select(_e831, _e809, (_e809 > _e831));
let _e838 = select(_e834, _e811, (_e811 < _e834));
let _e839 = (_e444 - _e506);
let _e840 = (_e472 - _e506);
let _e847 = bitcast<f32>((bitcast<u32>((_e839 - _e840)) & 2147483647u));
let _e850 = (bitcast<f32>((bitcast<u32>(_e839) & 2147483647u)) / select(1e-30f, _e847, (_e847 > 1e-30f)));
let _e852 = select(0f, _e850, (_e850 > 0f));
let _e854 = select(1f, _e852, (_e852 < 1f));
let _e856 = (_e840 > 0f);
let _e858 = select(0f, select(_e854, 2f, _e856), (_e839 > 0f));
let _e861 = select(1f, _e854, (_e856 && (_e839 <= 0f)));
let _e863 = select(_e858, _e836, (_e836 > _e858));
let _e865 = select(_e861, _e838, (_e838 < _e861));
let _e866 = (_e516 - _e460);
let _e867 = (_e516 - _e478);
let _e874 = bitcast<f32>((bitcast<u32>((_e866 - _e867)) & 2147483647u));
let _e877 = (bitcast<f32>((bitcast<u32>(_e866) & 2147483647u)) / select(1e-30f, _e874, (_e874 > 1e-30f)));
let _e879 = select(0f, _e877, (_e877 > 0f));
let _e881 = select(1f, _e879, (_e879 < 1f));
let _e883 = (_e867 > 0f);
let _e885 = select(0f, select(_e881, 2f, _e883), (_e866 > 0f));
let _e888 = select(1f, _e881, (_e883 && (_e866 <= 0f)));
let _e890 = select(_e885, _e863, (_e863 > _e885));
let _e892 = select(_e888, _e865, (_e865 < _e888));
let _e893 = (_e460 - _e522);
let _e894 = (_e478 - _e522);
let _e901 = bitcast<f32>((bitcast<u32>((_e893 - _e894)) & 2147483647u));
let _e904 = (bitcast<f32>((bitcast<u32>(_e893) & 2147483647u)) / select(1e-30f, _e901, (_e901 > 1e-30f)));
let _e906 = select(0f, _e904, (_e904 > 0f));
let _e908 = select(1f, _e906, (_e906 < 1f));
let _e910 = (_e894 > 0f);
let _e912 = select(0f, select(_e908, 2f, _e910), (_e893 > 0f));
let _e915 = select(1f, _e908, (_e910 && (_e893 <= 0f)));
let _e917 = select(_e912, _e890, (_e890 > _e912));
let _e919 = select(_e915, _e892, (_e892 < _e915));
if _e736 {
phi_1893_ = type_32(_e917, _e919);
} else {
let _e925 = global_2.member[_e367].member_16.member;
let _e936 = ((((_e925.member.member * _e401) + (_e925.member.member_1 * _e403)) + (_e925.member.member_2 * _e391)) + _e925.member_1);
let _e942 = ((((_e925.member.member * _e405) + (_e925.member.member_1 * _e407)) + (_e925.member.member_2 * _e412)) + _e925.member_1);
let _e949 = bitcast<f32>((bitcast<u32>((_e936 - _e942)) & 2147483647u));
let _e952 = (bitcast<f32>((bitcast<u32>(_e936) & 2147483647u)) / select(1e-30f, _e949, (_e949 > 1e-30f)));
let _e954 = select(0f, _e952, (_e952 > 0f));
let _e956 = select(1f, _e954, (_e954 < 1f));
let _e958 = (_e942 > 0f);
let _e960 = select(0f, select(_e956, 2f, _e958), (_e936 > 0f));
let _e963 = select(1f, _e956, (_e958 && (_e936 <= 0f)));
let _e965 = select(_e960, _e917, (_e917 > _e960));
let _e967 = select(_e963, _e919, (_e919 < _e963));
let _e972 = global_2.member[_e367].member_17.member;
let _e983 = ((((_e972.member.member * _e401) + (_e972.member.member_1 * _e403)) + (_e972.member.member_2 * _e391)) + _e972.member_1);
let _e989 = ((((_e972.member.member * _e405) + (_e972.member.member_1 * _e407)) + (_e972.member.member_2 * _e412)) + _e972.member_1);
let _e996 = bitcast<f32>((bitcast<u32>((_e983 - _e989)) & 2147483647u));
let _e999 = (bitcast<f32>((bitcast<u32>(_e983) & 2147483647u)) / select(1e-30f, _e996, (_e996 > 1e-30f)));
let _e1001 = select(0f, _e999, (_e999 > 0f));
let _e1003 = select(1f, _e1001, (_e1001 < 1f));
let _e1005 = (_e989 > 0f);
let _e1007 = select(0f, select(_e1003, 2f, _e1005), (_e983 > 0f));
let _e1010 = select(1f, _e1003, (_e1005 && (_e983 <= 0f)));
let _e1012 = select(_e1007, _e965, (_e965 > _e1007));
let _e1014 = select(_e1010, _e967, (_e967 < _e1010));
let _e1019 = global_2.member[_e367].member_18.member;
let _e1030 = ((((_e1019.member.member * _e401) + (_e1019.member.member_1 * _e403)) + (_e1019.member.member_2 * _e391)) + _e1019.member_1);
let _e1036 = ((((_e1019.member.member * _e405) + (_e1019.member.member_1 * _e407)) + (_e1019.member.member_2 * _e412)) + _e1019.member_1);
let _e1043 = bitcast<f32>((bitcast<u32>((_e1030 - _e1036)) & 2147483647u));
let _e1046 = (bitcast<f32>((bitcast<u32>(_e1030) & 2147483647u)) / select(1e-30f, _e1043, (_e1043 > 1e-30f)));
let _e1048 = select(0f, _e1046, (_e1046 > 0f));
let _e1050 = select(1f, _e1048, (_e1048 < 1f));
let _e1052 = (_e1036 > 0f);
let _e1054 = select(0f, select(_e1050, 2f, _e1052), (_e1030 > 0f));
let _e1057 = select(1f, _e1050, (_e1052 && (_e1030 <= 0f)));
let _e1059 = select(_e1054, _e1012, (_e1012 > _e1054));
let _e1061 = select(_e1057, _e1014, (_e1014 < _e1057));
let _e1066 = global_2.member[_e367].member_19.member;
let _e1077 = ((((_e1066.member.member * _e401) + (_e1066.member.member_1 * _e403)) + (_e1066.member.member_2 * _e391)) + _e1066.member_1);
let _e1083 = ((((_e1066.member.member * _e405) + (_e1066.member.member_1 * _e407)) + (_e1066.member.member_2 * _e412)) + _e1066.member_1);
let _e1090 = bitcast<f32>((bitcast<u32>((_e1077 - _e1083)) & 2147483647u));
let _e1093 = (bitcast<f32>((bitcast<u32>(_e1077) & 2147483647u)) / select(1e-30f, _e1090, (_e1090 > 1e-30f)));
let _e1095 = select(0f, _e1093, (_e1093 > 0f));
let _e1097 = select(1f, _e1095, (_e1095 < 1f));
let _e1099 = (_e1083 > 0f);
let _e1101 = select(0f, select(_e1097, 2f, _e1099), (_e1077 > 0f));
let _e1104 = select(1f, _e1097, (_e1099 && (_e1077 <= 0f)));
phi_1893_ = type_32(select(_e1101, _e1059, (_e1059 > _e1101)), select(_e1104, _e1061, (_e1061 < _e1104)));
}
let _e1111 = phi_1893_;
let _e1114 = (_e1111.member_1 > _e1111.member);
let _e1115 = (_e405 - _e401);
let _e1116 = (_e407 - _e403);
let _e1117 = (_e412 - _e391);
if (_e376.member_2 == 2u) {
let _e1120 = (_e1111.member_1 - _e1111.member);
let _e1122 = (_e1111.member + (_e1120 * (0.5f * 0.25f)));
let _e1126 = (_e401 + (_e1115 * _e1122));
let _e1127 = (_e403 + (_e1116 * _e1122));
let _e1128 = (_e391 + (_e1117 * _e1122));
let _e1134 = ((((_e417.member.member * _e1126) + (_e417.member.member_1 * _e1127)) + (_e417.member.member_2 * _e1128)) + _e417.member_1);
let _e1140 = ((((_e433.member.member * _e1126) + (_e433.member.member_1 * _e1127)) + (_e433.member.member_2 * _e1128)) + _e433.member_1);
let _e1146 = ((((_e449.member.member * _e1126) + (_e449.member.member_1 * _e1127)) + (_e449.member.member_2 * _e1128)) + _e449.member_1);
let _e1148 = select(_e484, _e1134, (_e1134 > _e484));
let _e1150 = select(_e490, _e1148, (_e1148 < _e490));
let _e1152 = select(_e500, _e1140, (_e1140 > _e500));
let _e1154 = select(_e506, _e1152, (_e1152 < _e506));
let _e1156 = select(_e516, _e1146, (_e1146 > _e516));
let _e1158 = select(_e522, _e1156, (_e1156 < _e522));
let _e1164 = global_2.member[_e367].member_8.member_15;
let _e1165 = (_e1164 == 0u);
if _e1165 {
phi_2114_ = vec3<f32>(_e1150, _e1154, _e1158);
} else {
let _e1166 = (_e1150 + 0.5f);
let _e1168 = select(0f, _e1166, (_e1166 > 0f));
let _e1170 = select(_e574, _e1168, (_e1168 < _e574));
let _e1177 = select(0i, select(select(i32(_e1170), i32(-2147483648), (_e1170 < -2147483600f)), 2147483647i, (_e1170 > 2147483500f)), (_e1170 == _e1170));
let _e1183 = (_e1154 + 0.5f);
let _e1185 = select(0f, _e1183, (_e1183 > 0f));
let _e1187 = select(_e605, _e1185, (_e1185 < _e605));
let _e1194 = select(0i, select(select(i32(_e1187), i32(-2147483648), (_e1187 < -2147483600f)), 2147483647i, (_e1187 > 2147483500f)), (_e1187 == _e1187));
let _e1200 = (_e1158 + 0.5f);
let _e1202 = select(0f, _e1200, (_e1200 > 0f));
let _e1204 = select(_e630, _e1202, (_e1202 < _e630));
let _e1211 = select(0i, select(select(i32(_e1204), i32(-2147483648), (_e1204 < -2147483600f)), 2147483647i, (_e1204 > 2147483500f)), (_e1204 == _e1204));
phi_2114_ = vec3<f32>(f32((_e1177 - select(0i, 1i, (_e1170 < f32(_e1177))))), f32((_e1194 - select(0i, 1i, (_e1187 < f32(_e1194))))), f32((_e1211 - select(0i, 1i, (_e1204 < f32(_e1211))))));
}
let _e1219 = phi_2114_;
let _e1222 = select(-1f, _e1219.x, (_e1219.x > -1f));
let _e1224 = select(_e572, _e1222, (_e1222 < _e572));
let _e1231 = select(0i, select(select(i32(_e1224), i32(-2147483648), (_e1224 < -2147483600f)), 2147483647i, (_e1224 > 2147483500f)), (_e1224 == _e1224));
let _e1235 = (_e1231 - select(0i, 1i, (_e1224 < f32(_e1231))));
let _e1238 = select(-1f, _e1219.y, (_e1219.y > -1f));
let _e1240 = select(_e603, _e1238, (_e1238 < _e603));
let _e1247 = select(0i, select(select(i32(_e1240), i32(-2147483648), (_e1240 < -2147483600f)), 2147483647i, (_e1240 > 2147483500f)), (_e1240 == _e1240));
let _e1251 = (_e1247 - select(0i, 1i, (_e1240 < f32(_e1247))));
let _e1254 = select(-1f, _e1219.z, (_e1219.z > -1f));
let _e1256 = select(_e628, _e1254, (_e1254 < _e628));
let _e1263 = select(0i, select(select(i32(_e1256), i32(-2147483648), (_e1256 < -2147483600f)), 2147483647i, (_e1256 > 2147483500f)), (_e1256 == _e1256));
let _e1267 = (_e1263 - select(0i, 1i, (_e1256 < f32(_e1263))));
let _e1272 = global_2.member[_e367].member_8.member_9;
let _e1277 = global_2.member[_e367].member_8.member_10;
let _e1285 = (select(0i, select(select(i32(_e603), i32(-2147483648), (_e603 < -2147483600f)), 2147483647i, (_e603 > 2147483500f)), (_e603 == _e603)) - 1i);
let _e1288 = (_e1251 + 1i);
let _e1298 = (select(0i, select(select(i32(_e628), i32(-2147483648), (_e628 < -2147483600f)), 2147483647i, (_e628 > 2147483500f)), (_e628 == _e628)) - 1i);
let _e1301 = (_e1267 + 1i);
let _e1310 = select(0i, select(select(i32(_e572), i32(-2147483648), (_e572 < -2147483600f)), 2147483647i, (_e572 > 2147483500f)), (_e572 == _e572));
let _e1311 = (_e1310 - 1i);
let _e1312 = (_e1235 - 1i);
let _e1314 = select(0i, _e1312, (_e1312 > 0i));
let _e1316 = select(0i, _e1235, (_e1235 > 0i));
let _e1317 = (_e1235 + 1i);
let _e1319 = select(_e1311, _e1317, (_e1317 < _e1311));
let _e1320 = (_e1235 + 2i);
let _e1323 = (_e1310 - 2i);
let _e1325 = select(0i, _e1323, (_e1323 > 0i));
let _e1327 = select(_e1325, _e1314, (_e1314 < _e1325));
let _e1329 = select(_e1325, _e1316, (_e1316 < _e1325));
let _e1331 = select(_e1325, _e1319, (_e1319 < _e1325));
let _e1350 = (select(0i, _e1251, (_e1251 > 0i)) * _e1272);
let _e1351 = (select(_e1285, _e1288, (_e1288 < _e1285)) * _e1272);
let _e1352 = (select(0i, _e1267, (_e1267 > 0i)) * _e1277);
let _e1353 = (select(_e1298, _e1301, (_e1301 < _e1298)) * _e1277);
local_16 = type_29(array<i32, 4>(_e1327, _e1329, _e1331, 0i), array<u32, 6>(bitcast<u32>(((_e1314 - _e1327) * 16i)), bitcast<u32>(((_e1316 - _e1327) * 16i)), bitcast<u32>(((_e1316 - _e1329) * 16i)), bitcast<u32>(((_e1319 - _e1329) * 16i)), bitcast<u32>(((_e1319 - _e1331) * 16i)), bitcast<u32>(((select(_e1311, _e1320, (_e1320 < _e1311)) - _e1331) * 16i))));
local_17 = (_e1219 - vec3<f32>(f32(_e1235), f32(_e1251), f32(_e1267)));
let _e1366 = local_16.member[1u];
let _e1367 = ((_e1352 + _e1350) + _e1366);
let _e1369 = (_e1367 >> bitcast<u32>(1i));
let _e1372 = bitcast<u32>(((_e1367 & 1i) * 16i));
let _e1374 = (bitcast<i32>(_e84) - 1i);
let _e1376 = select(_e1374, _e1369, (_e1369 < _e1374));
let _e1381 = global_1.member[bitcast<u32>(select(0i, _e1376, (_e1376 > 0i)))];
let _e1385 = (_e1369 + 1i);
let _e1387 = select(_e1374, _e1385, (_e1385 < _e1374));
let _e1392 = global_1.member[bitcast<u32>(select(0i, _e1387, (_e1387 > 0i)))];
let _e1399 = ((_e1381 >> bitcast<u32>((_e1372 & 31u))) | ((_e1392 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1372) & 31u))));
let _e1402 = local_16.member_1[2u];
let _e1408 = f32(bitcast<i32>(((_e1399 >> bitcast<u32>((_e1402 & 31u))) & 65535u)));
let _e1411 = local_16.member_1[3u];
let _e1418 = local_17[0u];
let _e1421 = (_e1408 + ((f32(bitcast<i32>(((_e1399 >> bitcast<u32>((_e1411 & 31u))) & 65535u))) - _e1408) * _e1418));
let _e1423 = local_16.member[1u];
let _e1424 = ((_e1352 + _e1351) + _e1423);
let _e1426 = (_e1424 >> bitcast<u32>(1i));
let _e1429 = bitcast<u32>(((_e1424 & 1i) * 16i));
let _e1431 = select(_e1374, _e1426, (_e1426 < _e1374));
let _e1436 = global_1.member[bitcast<u32>(select(0i, _e1431, (_e1431 > 0i)))];
let _e1440 = (_e1426 + 1i);
let _e1442 = select(_e1374, _e1440, (_e1440 < _e1374));
let _e1447 = global_1.member[bitcast<u32>(select(0i, _e1442, (_e1442 > 0i)))];
let _e1454 = ((_e1436 >> bitcast<u32>((_e1429 & 31u))) | ((_e1447 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1429) & 31u))));
let _e1455 = local_16.member_1[2u];
let _e1461 = f32(bitcast<i32>(((_e1454 >> bitcast<u32>((_e1455 & 31u))) & 65535u)));
let _e1462 = local_16.member_1[3u];
let _e1469 = local_17[0u];
let _e1474 = local_17[1u];
let _e1477 = (_e1421 + (((_e1461 + ((f32(bitcast<i32>(((_e1454 >> bitcast<u32>((_e1462 & 31u))) & 65535u))) - _e1461) * _e1469)) - _e1421) * _e1474));
let _e1479 = local_16.member[1u];
let _e1480 = ((_e1353 + _e1350) + _e1479);
let _e1482 = (_e1480 >> bitcast<u32>(1i));
let _e1485 = bitcast<u32>(((_e1480 & 1i) * 16i));
let _e1487 = select(_e1374, _e1482, (_e1482 < _e1374));
let _e1492 = global_1.member[bitcast<u32>(select(0i, _e1487, (_e1487 > 0i)))];
let _e1496 = (_e1482 + 1i);
let _e1498 = select(_e1374, _e1496, (_e1496 < _e1374));
let _e1503 = global_1.member[bitcast<u32>(select(0i, _e1498, (_e1498 > 0i)))];
let _e1510 = ((_e1492 >> bitcast<u32>((_e1485 & 31u))) | ((_e1503 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1485) & 31u))));
let _e1511 = local_16.member_1[2u];
let _e1517 = f32(bitcast<i32>(((_e1510 >> bitcast<u32>((_e1511 & 31u))) & 65535u)));
let _e1518 = local_16.member_1[3u];
let _e1525 = local_17[0u];
let _e1528 = (_e1517 + ((f32(bitcast<i32>(((_e1510 >> bitcast<u32>((_e1518 & 31u))) & 65535u))) - _e1517) * _e1525));
let _e1530 = local_16.member[1u];
let _e1531 = ((_e1353 + _e1351) + _e1530);
let _e1533 = (_e1531 >> bitcast<u32>(1i));
let _e1536 = bitcast<u32>(((_e1531 & 1i) * 16i));
let _e1538 = select(_e1374, _e1533, (_e1533 < _e1374));
let _e1543 = global_1.member[bitcast<u32>(select(0i, _e1538, (_e1538 > 0i)))];
let _e1547 = (_e1533 + 1i);
let _e1549 = select(_e1374, _e1547, (_e1547 < _e1374));
let _e1554 = global_1.member[bitcast<u32>(select(0i, _e1549, (_e1549 > 0i)))];
let _e1561 = ((_e1543 >> bitcast<u32>((_e1536 & 31u))) | ((_e1554 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1536) & 31u))));
let _e1562 = local_16.member_1[2u];
let _e1568 = f32(bitcast<i32>(((_e1561 >> bitcast<u32>((_e1562 & 31u))) & 65535u)));
let _e1569 = local_16.member_1[3u];
let _e1576 = local_17[0u];
let _e1580 = local_17[1u];
let _e1585 = local_17[2u];
let _e1593 = global_2.member[_e367].member_8.member_8;
let _e1598 = global_2.member[_e367].member_8.member_7;
let _e1600 = (((_e1477 + (((_e1528 + (((_e1568 + ((f32(bitcast<i32>(((_e1561 >> bitcast<u32>((_e1569 & 31u))) & 65535u))) - _e1568) * _e1576)) - _e1528) * _e1580)) - _e1477) * _e1585)) - _e1593) * _e1598);
let _e1601 = -(1e9f);
let _e1603 = select(_e1601, _e1600, (_e1600 > _e1601));
let _e1608 = (_e1111.member + (_e1120 * (1.5f * 0.25f)));
let _e1612 = (_e401 + (_e1115 * _e1608));
let _e1613 = (_e403 + (_e1116 * _e1608));
let _e1614 = (_e391 + (_e1117 * _e1608));
let _e1620 = ((((_e417.member.member * _e1612) + (_e417.member.member_1 * _e1613)) + (_e417.member.member_2 * _e1614)) + _e417.member_1);
let _e1626 = ((((_e433.member.member * _e1612) + (_e433.member.member_1 * _e1613)) + (_e433.member.member_2 * _e1614)) + _e433.member_1);
let _e1632 = ((((_e449.member.member * _e1612) + (_e449.member.member_1 * _e1613)) + (_e449.member.member_2 * _e1614)) + _e449.member_1);
let _e1634 = select(_e484, _e1620, (_e1620 > _e484));
let _e1636 = select(_e490, _e1634, (_e1634 < _e490));
let _e1638 = select(_e500, _e1626, (_e1626 > _e500));
let _e1640 = select(_e506, _e1638, (_e1638 < _e506));
let _e1642 = select(_e516, _e1632, (_e1632 > _e516));
let _e1644 = select(_e522, _e1642, (_e1642 < _e522));
if _e1165 {
phi_2863_ = vec3<f32>(_e1636, _e1640, _e1644);
} else {
let _e1646 = (_e1636 + 0.5f);
let _e1648 = select(0f, _e1646, (_e1646 > 0f));
let _e1650 = select(_e574, _e1648, (_e1648 < _e574));
let _e1657 = select(0i, select(select(i32(_e1650), i32(-2147483648), (_e1650 < -2147483600f)), 2147483647i, (_e1650 > 2147483500f)), (_e1650 == _e1650));
let _e1663 = (_e1640 + 0.5f);
let _e1665 = select(0f, _e1663, (_e1663 > 0f));
let _e1667 = select(_e605, _e1665, (_e1665 < _e605));
let _e1674 = select(0i, select(select(i32(_e1667), i32(-2147483648), (_e1667 < -2147483600f)), 2147483647i, (_e1667 > 2147483500f)), (_e1667 == _e1667));
let _e1680 = (_e1644 + 0.5f);
let _e1682 = select(0f, _e1680, (_e1680 > 0f));
let _e1684 = select(_e630, _e1682, (_e1682 < _e630));
let _e1691 = select(0i, select(select(i32(_e1684), i32(-2147483648), (_e1684 < -2147483600f)), 2147483647i, (_e1684 > 2147483500f)), (_e1684 == _e1684));
phi_2863_ = vec3<f32>(f32((_e1657 - select(0i, 1i, (_e1650 < f32(_e1657))))), f32((_e1674 - select(0i, 1i, (_e1667 < f32(_e1674))))), f32((_e1691 - select(0i, 1i, (_e1684 < f32(_e1691))))));
}
let _e1699 = phi_2863_;
let _e1702 = select(-1f, _e1699.x, (_e1699.x > -1f));
let _e1704 = select(_e572, _e1702, (_e1702 < _e572));
let _e1711 = select(0i, select(select(i32(_e1704), i32(-2147483648), (_e1704 < -2147483600f)), 2147483647i, (_e1704 > 2147483500f)), (_e1704 == _e1704));
let _e1715 = (_e1711 - select(0i, 1i, (_e1704 < f32(_e1711))));
let _e1718 = select(-1f, _e1699.y, (_e1699.y > -1f));
let _e1720 = select(_e603, _e1718, (_e1718 < _e603));
let _e1727 = select(0i, select(select(i32(_e1720), i32(-2147483648), (_e1720 < -2147483600f)), 2147483647i, (_e1720 > 2147483500f)), (_e1720 == _e1720));
let _e1731 = (_e1727 - select(0i, 1i, (_e1720 < f32(_e1727))));
let _e1734 = select(-1f, _e1699.z, (_e1699.z > -1f));
let _e1736 = select(_e628, _e1734, (_e1734 < _e628));
let _e1743 = select(0i, select(select(i32(_e1736), i32(-2147483648), (_e1736 < -2147483600f)), 2147483647i, (_e1736 > 2147483500f)), (_e1736 == _e1736));
let _e1747 = (_e1743 - select(0i, 1i, (_e1736 < f32(_e1743))));
let _e1750 = (_e1731 + 1i);
let _e1755 = (_e1747 + 1i);
let _e1758 = (_e1715 - 1i);
let _e1760 = select(0i, _e1758, (_e1758 > 0i));
let _e1762 = select(0i, _e1715, (_e1715 > 0i));
let _e1763 = (_e1715 + 1i);
let _e1765 = select(_e1311, _e1763, (_e1763 < _e1311));
let _e1766 = (_e1715 + 2i);
let _e1770 = select(_e1325, _e1760, (_e1760 < _e1325));
let _e1772 = select(_e1325, _e1762, (_e1762 < _e1325));
let _e1774 = select(_e1325, _e1765, (_e1765 < _e1325));
let _e1793 = (select(0i, _e1731, (_e1731 > 0i)) * _e1272);
let _e1794 = (select(_e1285, _e1750, (_e1750 < _e1285)) * _e1272);
let _e1795 = (select(0i, _e1747, (_e1747 > 0i)) * _e1277);
let _e1796 = (select(_e1298, _e1755, (_e1755 < _e1298)) * _e1277);
local_14 = type_29(array<i32, 4>(_e1770, _e1772, _e1774, 0i), array<u32, 6>(bitcast<u32>(((_e1760 - _e1770) * 16i)), bitcast<u32>(((_e1762 - _e1770) * 16i)), bitcast<u32>(((_e1762 - _e1772) * 16i)), bitcast<u32>(((_e1765 - _e1772) * 16i)), bitcast<u32>(((_e1765 - _e1774) * 16i)), bitcast<u32>(((select(_e1311, _e1766, (_e1766 < _e1311)) - _e1774) * 16i))));
local_15 = (_e1699 - vec3<f32>(f32(_e1715), f32(_e1731), f32(_e1747)));
let _e1809 = local_14.member[1u];
let _e1810 = ((_e1795 + _e1793) + _e1809);
let _e1812 = (_e1810 >> bitcast<u32>(1i));
let _e1815 = bitcast<u32>(((_e1810 & 1i) * 16i));
let _e1817 = select(_e1374, _e1812, (_e1812 < _e1374));
let _e1822 = global_1.member[bitcast<u32>(select(0i, _e1817, (_e1817 > 0i)))];
let _e1826 = (_e1812 + 1i);
let _e1828 = select(_e1374, _e1826, (_e1826 < _e1374));
let _e1833 = global_1.member[bitcast<u32>(select(0i, _e1828, (_e1828 > 0i)))];
let _e1840 = ((_e1822 >> bitcast<u32>((_e1815 & 31u))) | ((_e1833 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1815) & 31u))));
let _e1843 = local_14.member_1[2u];
let _e1849 = f32(bitcast<i32>(((_e1840 >> bitcast<u32>((_e1843 & 31u))) & 65535u)));
let _e1852 = local_14.member_1[3u];
let _e1859 = local_15[0u];
let _e1862 = (_e1849 + ((f32(bitcast<i32>(((_e1840 >> bitcast<u32>((_e1852 & 31u))) & 65535u))) - _e1849) * _e1859));
let _e1864 = local_14.member[1u];
let _e1865 = ((_e1795 + _e1794) + _e1864);
let _e1867 = (_e1865 >> bitcast<u32>(1i));
let _e1870 = bitcast<u32>(((_e1865 & 1i) * 16i));
let _e1872 = select(_e1374, _e1867, (_e1867 < _e1374));
let _e1877 = global_1.member[bitcast<u32>(select(0i, _e1872, (_e1872 > 0i)))];
let _e1881 = (_e1867 + 1i);
let _e1883 = select(_e1374, _e1881, (_e1881 < _e1374));
let _e1888 = global_1.member[bitcast<u32>(select(0i, _e1883, (_e1883 > 0i)))];
let _e1895 = ((_e1877 >> bitcast<u32>((_e1870 & 31u))) | ((_e1888 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1870) & 31u))));
let _e1896 = local_14.member_1[2u];
let _e1902 = f32(bitcast<i32>(((_e1895 >> bitcast<u32>((_e1896 & 31u))) & 65535u)));
let _e1903 = local_14.member_1[3u];
let _e1910 = local_15[0u];
let _e1915 = local_15[1u];
let _e1918 = (_e1862 + (((_e1902 + ((f32(bitcast<i32>(((_e1895 >> bitcast<u32>((_e1903 & 31u))) & 65535u))) - _e1902) * _e1910)) - _e1862) * _e1915));
let _e1920 = local_14.member[1u];
let _e1921 = ((_e1796 + _e1793) + _e1920);
let _e1923 = (_e1921 >> bitcast<u32>(1i));
let _e1926 = bitcast<u32>(((_e1921 & 1i) * 16i));
let _e1928 = select(_e1374, _e1923, (_e1923 < _e1374));
let _e1933 = global_1.member[bitcast<u32>(select(0i, _e1928, (_e1928 > 0i)))];
let _e1937 = (_e1923 + 1i);
let _e1939 = select(_e1374, _e1937, (_e1937 < _e1374));
let _e1944 = global_1.member[bitcast<u32>(select(0i, _e1939, (_e1939 > 0i)))];
let _e1951 = ((_e1933 >> bitcast<u32>((_e1926 & 31u))) | ((_e1944 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1926) & 31u))));
let _e1952 = local_14.member_1[2u];
let _e1958 = f32(bitcast<i32>(((_e1951 >> bitcast<u32>((_e1952 & 31u))) & 65535u)));
let _e1959 = local_14.member_1[3u];
let _e1966 = local_15[0u];
let _e1969 = (_e1958 + ((f32(bitcast<i32>(((_e1951 >> bitcast<u32>((_e1959 & 31u))) & 65535u))) - _e1958) * _e1966));
let _e1971 = local_14.member[1u];
let _e1972 = ((_e1796 + _e1794) + _e1971);
let _e1974 = (_e1972 >> bitcast<u32>(1i));
let _e1977 = bitcast<u32>(((_e1972 & 1i) * 16i));
let _e1979 = select(_e1374, _e1974, (_e1974 < _e1374));
let _e1984 = global_1.member[bitcast<u32>(select(0i, _e1979, (_e1979 > 0i)))];
let _e1988 = (_e1974 + 1i);
let _e1990 = select(_e1374, _e1988, (_e1988 < _e1374));
let _e1995 = global_1.member[bitcast<u32>(select(0i, _e1990, (_e1990 > 0i)))];
let _e2002 = ((_e1984 >> bitcast<u32>((_e1977 & 31u))) | ((_e1995 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1977) & 31u))));
let _e2003 = local_14.member_1[2u];
let _e2009 = f32(bitcast<i32>(((_e2002 >> bitcast<u32>((_e2003 & 31u))) & 65535u)));
let _e2010 = local_14.member_1[3u];
let _e2017 = local_15[0u];
let _e2021 = local_15[1u];
let _e2026 = local_15[2u];
let _e2031 = (((_e1918 + (((_e1969 + (((_e2009 + ((f32(bitcast<i32>(((_e2002 >> bitcast<u32>((_e2010 & 31u))) & 65535u))) - _e2009) * _e2017)) - _e1969) * _e2021)) - _e1918) * _e2026)) - _e1593) * _e1598);
let _e2033 = select(_e1601, _e2031, (_e2031 > _e1601));
let _e2038 = (_e1111.member + (_e1120 * (2.5f * 0.25f)));
let _e2042 = (_e401 + (_e1115 * _e2038));
let _e2043 = (_e403 + (_e1116 * _e2038));
let _e2044 = (_e391 + (_e1117 * _e2038));
let _e2050 = ((((_e417.member.member * _e2042) + (_e417.member.member_1 * _e2043)) + (_e417.member.member_2 * _e2044)) + _e417.member_1);
let _e2056 = ((((_e433.member.member * _e2042) + (_e433.member.member_1 * _e2043)) + (_e433.member.member_2 * _e2044)) + _e433.member_1);
let _e2062 = ((((_e449.member.member * _e2042) + (_e449.member.member_1 * _e2043)) + (_e449.member.member_2 * _e2044)) + _e449.member_1);
let _e2064 = select(_e484, _e2050, (_e2050 > _e484));
let _e2066 = select(_e490, _e2064, (_e2064 < _e490));
let _e2068 = select(_e500, _e2056, (_e2056 > _e500));
let _e2070 = select(_e506, _e2068, (_e2068 < _e506));
let _e2072 = select(_e516, _e2062, (_e2062 > _e516));
let _e2074 = select(_e522, _e2072, (_e2072 < _e522));
if _e1165 {
phi_3612_ = vec3<f32>(_e2066, _e2070, _e2074);
} else {
let _e2076 = (_e2066 + 0.5f);
let _e2078 = select(0f, _e2076, (_e2076 > 0f));
let _e2080 = select(_e574, _e2078, (_e2078 < _e574));
let _e2087 = select(0i, select(select(i32(_e2080), i32(-2147483648), (_e2080 < -2147483600f)), 2147483647i, (_e2080 > 2147483500f)), (_e2080 == _e2080));
let _e2093 = (_e2070 + 0.5f);
let _e2095 = select(0f, _e2093, (_e2093 > 0f));
let _e2097 = select(_e605, _e2095, (_e2095 < _e605));
let _e2104 = select(0i, select(select(i32(_e2097), i32(-2147483648), (_e2097 < -2147483600f)), 2147483647i, (_e2097 > 2147483500f)), (_e2097 == _e2097));
let _e2110 = (_e2074 + 0.5f);
let _e2112 = select(0f, _e2110, (_e2110 > 0f));
let _e2114 = select(_e630, _e2112, (_e2112 < _e630));
let _e2121 = select(0i, select(select(i32(_e2114), i32(-2147483648), (_e2114 < -2147483600f)), 2147483647i, (_e2114 > 2147483500f)), (_e2114 == _e2114));
phi_3612_ = vec3<f32>(f32((_e2087 - select(0i, 1i, (_e2080 < f32(_e2087))))), f32((_e2104 - select(0i, 1i, (_e2097 < f32(_e2104))))), f32((_e2121 - select(0i, 1i, (_e2114 < f32(_e2121))))));
}
let _e2129 = phi_3612_;
let _e2132 = select(-1f, _e2129.x, (_e2129.x > -1f));
let _e2134 = select(_e572, _e2132, (_e2132 < _e572));
let _e2141 = select(0i, select(select(i32(_e2134), i32(-2147483648), (_e2134 < -2147483600f)), 2147483647i, (_e2134 > 2147483500f)), (_e2134 == _e2134));
let _e2145 = (_e2141 - select(0i, 1i, (_e2134 < f32(_e2141))));
let _e2148 = select(-1f, _e2129.y, (_e2129.y > -1f));
let _e2150 = select(_e603, _e2148, (_e2148 < _e603));
let _e2157 = select(0i, select(select(i32(_e2150), i32(-2147483648), (_e2150 < -2147483600f)), 2147483647i, (_e2150 > 2147483500f)), (_e2150 == _e2150));
let _e2161 = (_e2157 - select(0i, 1i, (_e2150 < f32(_e2157))));
let _e2164 = select(-1f, _e2129.z, (_e2129.z > -1f));
let _e2166 = select(_e628, _e2164, (_e2164 < _e628));
let _e2173 = select(0i, select(select(i32(_e2166), i32(-2147483648), (_e2166 < -2147483600f)), 2147483647i, (_e2166 > 2147483500f)), (_e2166 == _e2166));
let _e2177 = (_e2173 - select(0i, 1i, (_e2166 < f32(_e2173))));
let _e2180 = (_e2161 + 1i);
let _e2185 = (_e2177 + 1i);
let _e2188 = (_e2145 - 1i);
let _e2190 = select(0i, _e2188, (_e2188 > 0i));
let _e2192 = select(0i, _e2145, (_e2145 > 0i));
let _e2193 = (_e2145 + 1i);
let _e2195 = select(_e1311, _e2193, (_e2193 < _e1311));
let _e2196 = (_e2145 + 2i);
let _e2200 = select(_e1325, _e2190, (_e2190 < _e1325));
let _e2202 = select(_e1325, _e2192, (_e2192 < _e1325));
let _e2204 = select(_e1325, _e2195, (_e2195 < _e1325));
let _e2223 = (select(0i, _e2161, (_e2161 > 0i)) * _e1272);
let _e2224 = (select(_e1285, _e2180, (_e2180 < _e1285)) * _e1272);
let _e2225 = (select(0i, _e2177, (_e2177 > 0i)) * _e1277);
let _e2226 = (select(_e1298, _e2185, (_e2185 < _e1298)) * _e1277);
local_12 = type_29(array<i32, 4>(_e2200, _e2202, _e2204, 0i), array<u32, 6>(bitcast<u32>(((_e2190 - _e2200) * 16i)), bitcast<u32>(((_e2192 - _e2200) * 16i)), bitcast<u32>(((_e2192 - _e2202) * 16i)), bitcast<u32>(((_e2195 - _e2202) * 16i)), bitcast<u32>(((_e2195 - _e2204) * 16i)), bitcast<u32>(((select(_e1311, _e2196, (_e2196 < _e1311)) - _e2204) * 16i))));
local_13 = (_e2129 - vec3<f32>(f32(_e2145), f32(_e2161), f32(_e2177)));
let _e2239 = local_12.member[1u];
let _e2240 = ((_e2225 + _e2223) + _e2239);
let _e2242 = (_e2240 >> bitcast<u32>(1i));
let _e2245 = bitcast<u32>(((_e2240 & 1i) * 16i));
let _e2247 = select(_e1374, _e2242, (_e2242 < _e1374));
let _e2252 = global_1.member[bitcast<u32>(select(0i, _e2247, (_e2247 > 0i)))];
let _e2256 = (_e2242 + 1i);
let _e2258 = select(_e1374, _e2256, (_e2256 < _e1374));
let _e2263 = global_1.member[bitcast<u32>(select(0i, _e2258, (_e2258 > 0i)))];
let _e2270 = ((_e2252 >> bitcast<u32>((_e2245 & 31u))) | ((_e2263 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2245) & 31u))));
let _e2273 = local_12.member_1[2u];
let _e2279 = f32(bitcast<i32>(((_e2270 >> bitcast<u32>((_e2273 & 31u))) & 65535u)));
let _e2282 = local_12.member_1[3u];
let _e2289 = local_13[0u];
let _e2292 = (_e2279 + ((f32(bitcast<i32>(((_e2270 >> bitcast<u32>((_e2282 & 31u))) & 65535u))) - _e2279) * _e2289));
let _e2294 = local_12.member[1u];
let _e2295 = ((_e2225 + _e2224) + _e2294);
let _e2297 = (_e2295 >> bitcast<u32>(1i));
let _e2300 = bitcast<u32>(((_e2295 & 1i) * 16i));
let _e2302 = select(_e1374, _e2297, (_e2297 < _e1374));
let _e2307 = global_1.member[bitcast<u32>(select(0i, _e2302, (_e2302 > 0i)))];
let _e2311 = (_e2297 + 1i);
let _e2313 = select(_e1374, _e2311, (_e2311 < _e1374));
let _e2318 = global_1.member[bitcast<u32>(select(0i, _e2313, (_e2313 > 0i)))];
let _e2325 = ((_e2307 >> bitcast<u32>((_e2300 & 31u))) | ((_e2318 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2300) & 31u))));
let _e2326 = local_12.member_1[2u];
let _e2332 = f32(bitcast<i32>(((_e2325 >> bitcast<u32>((_e2326 & 31u))) & 65535u)));
let _e2333 = local_12.member_1[3u];
let _e2340 = local_13[0u];
let _e2345 = local_13[1u];
let _e2348 = (_e2292 + (((_e2332 + ((f32(bitcast<i32>(((_e2325 >> bitcast<u32>((_e2333 & 31u))) & 65535u))) - _e2332) * _e2340)) - _e2292) * _e2345));
let _e2350 = local_12.member[1u];
let _e2351 = ((_e2226 + _e2223) + _e2350);
let _e2353 = (_e2351 >> bitcast<u32>(1i));
let _e2356 = bitcast<u32>(((_e2351 & 1i) * 16i));
let _e2358 = select(_e1374, _e2353, (_e2353 < _e1374));
let _e2363 = global_1.member[bitcast<u32>(select(0i, _e2358, (_e2358 > 0i)))];
let _e2367 = (_e2353 + 1i);
let _e2369 = select(_e1374, _e2367, (_e2367 < _e1374));
let _e2374 = global_1.member[bitcast<u32>(select(0i, _e2369, (_e2369 > 0i)))];
let _e2381 = ((_e2363 >> bitcast<u32>((_e2356 & 31u))) | ((_e2374 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2356) & 31u))));
let _e2382 = local_12.member_1[2u];
let _e2388 = f32(bitcast<i32>(((_e2381 >> bitcast<u32>((_e2382 & 31u))) & 65535u)));
let _e2389 = local_12.member_1[3u];
let _e2396 = local_13[0u];
let _e2399 = (_e2388 + ((f32(bitcast<i32>(((_e2381 >> bitcast<u32>((_e2389 & 31u))) & 65535u))) - _e2388) * _e2396));
let _e2401 = local_12.member[1u];
let _e2402 = ((_e2226 + _e2224) + _e2401);
let _e2404 = (_e2402 >> bitcast<u32>(1i));
let _e2407 = bitcast<u32>(((_e2402 & 1i) * 16i));
let _e2409 = select(_e1374, _e2404, (_e2404 < _e1374));
let _e2414 = global_1.member[bitcast<u32>(select(0i, _e2409, (_e2409 > 0i)))];
let _e2418 = (_e2404 + 1i);
let _e2420 = select(_e1374, _e2418, (_e2418 < _e1374));
let _e2425 = global_1.member[bitcast<u32>(select(0i, _e2420, (_e2420 > 0i)))];
let _e2432 = ((_e2414 >> bitcast<u32>((_e2407 & 31u))) | ((_e2425 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2407) & 31u))));
let _e2433 = local_12.member_1[2u];
let _e2439 = f32(bitcast<i32>(((_e2432 >> bitcast<u32>((_e2433 & 31u))) & 65535u)));
let _e2440 = local_12.member_1[3u];
let _e2447 = local_13[0u];
let _e2451 = local_13[1u];
let _e2456 = local_13[2u];
let _e2461 = (((_e2348 + (((_e2399 + (((_e2439 + ((f32(bitcast<i32>(((_e2432 >> bitcast<u32>((_e2440 & 31u))) & 65535u))) - _e2439) * _e2447)) - _e2399) * _e2451)) - _e2348) * _e2456)) - _e1593) * _e1598);
let _e2463 = select(_e1601, _e2461, (_e2461 > _e1601));
let _e2468 = (_e1111.member + (_e1120 * (3.5f * 0.25f)));
let _e2472 = (_e401 + (_e1115 * _e2468));
let _e2473 = (_e403 + (_e1116 * _e2468));
let _e2474 = (_e391 + (_e1117 * _e2468));
let _e2480 = ((((_e417.member.member * _e2472) + (_e417.member.member_1 * _e2473)) + (_e417.member.member_2 * _e2474)) + _e417.member_1);
let _e2486 = ((((_e433.member.member * _e2472) + (_e433.member.member_1 * _e2473)) + (_e433.member.member_2 * _e2474)) + _e433.member_1);
let _e2492 = ((((_e449.member.member * _e2472) + (_e449.member.member_1 * _e2473)) + (_e449.member.member_2 * _e2474)) + _e449.member_1);
let _e2494 = select(_e484, _e2480, (_e2480 > _e484));
let _e2496 = select(_e490, _e2494, (_e2494 < _e490));
let _e2498 = select(_e500, _e2486, (_e2486 > _e500));
let _e2500 = select(_e506, _e2498, (_e2498 < _e506));
let _e2502 = select(_e516, _e2492, (_e2492 > _e516));
let _e2504 = select(_e522, _e2502, (_e2502 < _e522));
if _e1165 {
phi_4361_ = vec3<f32>(_e2496, _e2500, _e2504);
} else {
let _e2506 = (_e2496 + 0.5f);
let _e2508 = select(0f, _e2506, (_e2506 > 0f));
let _e2510 = select(_e574, _e2508, (_e2508 < _e574));
let _e2517 = select(0i, select(select(i32(_e2510), i32(-2147483648), (_e2510 < -2147483600f)), 2147483647i, (_e2510 > 2147483500f)), (_e2510 == _e2510));
let _e2523 = (_e2500 + 0.5f);
let _e2525 = select(0f, _e2523, (_e2523 > 0f));
let _e2527 = select(_e605, _e2525, (_e2525 < _e605));
let _e2534 = select(0i, select(select(i32(_e2527), i32(-2147483648), (_e2527 < -2147483600f)), 2147483647i, (_e2527 > 2147483500f)), (_e2527 == _e2527));
let _e2540 = (_e2504 + 0.5f);
let _e2542 = select(0f, _e2540, (_e2540 > 0f));
let _e2544 = select(_e630, _e2542, (_e2542 < _e630));
let _e2551 = select(0i, select(select(i32(_e2544), i32(-2147483648), (_e2544 < -2147483600f)), 2147483647i, (_e2544 > 2147483500f)), (_e2544 == _e2544));
phi_4361_ = vec3<f32>(f32((_e2517 - select(0i, 1i, (_e2510 < f32(_e2517))))), f32((_e2534 - select(0i, 1i, (_e2527 < f32(_e2534))))), f32((_e2551 - select(0i, 1i, (_e2544 < f32(_e2551))))));
}
let _e2559 = phi_4361_;
let _e2562 = select(-1f, _e2559.x, (_e2559.x > -1f));
let _e2564 = select(_e572, _e2562, (_e2562 < _e572));
let _e2571 = select(0i, select(select(i32(_e2564), i32(-2147483648), (_e2564 < -2147483600f)), 2147483647i, (_e2564 > 2147483500f)), (_e2564 == _e2564));
let _e2575 = (_e2571 - select(0i, 1i, (_e2564 < f32(_e2571))));
let _e2578 = select(-1f, _e2559.y, (_e2559.y > -1f));
let _e2580 = select(_e603, _e2578, (_e2578 < _e603));
let _e2587 = select(0i, select(select(i32(_e2580), i32(-2147483648), (_e2580 < -2147483600f)), 2147483647i, (_e2580 > 2147483500f)), (_e2580 == _e2580));
let _e2591 = (_e2587 - select(0i, 1i, (_e2580 < f32(_e2587))));
let _e2594 = select(-1f, _e2559.z, (_e2559.z > -1f));
let _e2596 = select(_e628, _e2594, (_e2594 < _e628));
let _e2603 = select(0i, select(select(i32(_e2596), i32(-2147483648), (_e2596 < -2147483600f)), 2147483647i, (_e2596 > 2147483500f)), (_e2596 == _e2596));
let _e2607 = (_e2603 - select(0i, 1i, (_e2596 < f32(_e2603))));
let _e2610 = (_e2591 + 1i);
let _e2615 = (_e2607 + 1i);
let _e2618 = (_e2575 - 1i);
let _e2620 = select(0i, _e2618, (_e2618 > 0i));
let _e2622 = select(0i, _e2575, (_e2575 > 0i));
let _e2623 = (_e2575 + 1i);
let _e2625 = select(_e1311, _e2623, (_e2623 < _e1311));
let _e2626 = (_e2575 + 2i);
let _e2630 = select(_e1325, _e2620, (_e2620 < _e1325));
let _e2632 = select(_e1325, _e2622, (_e2622 < _e1325));
let _e2634 = select(_e1325, _e2625, (_e2625 < _e1325));
let _e2653 = (select(0i, _e2591, (_e2591 > 0i)) * _e1272);
let _e2654 = (select(_e1285, _e2610, (_e2610 < _e1285)) * _e1272);
let _e2655 = (select(0i, _e2607, (_e2607 > 0i)) * _e1277);
let _e2656 = (select(_e1298, _e2615, (_e2615 < _e1298)) * _e1277);
local_10 = type_29(array<i32, 4>(_e2630, _e2632, _e2634, 0i), array<u32, 6>(bitcast<u32>(((_e2620 - _e2630) * 16i)), bitcast<u32>(((_e2622 - _e2630) * 16i)), bitcast<u32>(((_e2622 - _e2632) * 16i)), bitcast<u32>(((_e2625 - _e2632) * 16i)), bitcast<u32>(((_e2625 - _e2634) * 16i)), bitcast<u32>(((select(_e1311, _e2626, (_e2626 < _e1311)) - _e2634) * 16i))));
local_11 = (_e2559 - vec3<f32>(f32(_e2575), f32(_e2591), f32(_e2607)));
let _e2669 = local_10.member[1u];
let _e2670 = ((_e2655 + _e2653) + _e2669);
let _e2672 = (_e2670 >> bitcast<u32>(1i));
let _e2675 = bitcast<u32>(((_e2670 & 1i) * 16i));
let _e2677 = select(_e1374, _e2672, (_e2672 < _e1374));
let _e2682 = global_1.member[bitcast<u32>(select(0i, _e2677, (_e2677 > 0i)))];
let _e2686 = (_e2672 + 1i);
let _e2688 = select(_e1374, _e2686, (_e2686 < _e1374));
let _e2693 = global_1.member[bitcast<u32>(select(0i, _e2688, (_e2688 > 0i)))];
let _e2700 = ((_e2682 >> bitcast<u32>((_e2675 & 31u))) | ((_e2693 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2675) & 31u))));
let _e2703 = local_10.member_1[2u];
let _e2709 = f32(bitcast<i32>(((_e2700 >> bitcast<u32>((_e2703 & 31u))) & 65535u)));
let _e2712 = local_10.member_1[3u];
let _e2719 = local_11[0u];
let _e2722 = (_e2709 + ((f32(bitcast<i32>(((_e2700 >> bitcast<u32>((_e2712 & 31u))) & 65535u))) - _e2709) * _e2719));
let _e2724 = local_10.member[1u];
let _e2725 = ((_e2655 + _e2654) + _e2724);
let _e2727 = (_e2725 >> bitcast<u32>(1i));
let _e2730 = bitcast<u32>(((_e2725 & 1i) * 16i));
let _e2732 = select(_e1374, _e2727, (_e2727 < _e1374));
let _e2737 = global_1.member[bitcast<u32>(select(0i, _e2732, (_e2732 > 0i)))];
let _e2741 = (_e2727 + 1i);
let _e2743 = select(_e1374, _e2741, (_e2741 < _e1374));
let _e2748 = global_1.member[bitcast<u32>(select(0i, _e2743, (_e2743 > 0i)))];
let _e2755 = ((_e2737 >> bitcast<u32>((_e2730 & 31u))) | ((_e2748 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2730) & 31u))));
let _e2756 = local_10.member_1[2u];
let _e2762 = f32(bitcast<i32>(((_e2755 >> bitcast<u32>((_e2756 & 31u))) & 65535u)));
let _e2763 = local_10.member_1[3u];
let _e2770 = local_11[0u];
let _e2775 = local_11[1u];
let _e2778 = (_e2722 + (((_e2762 + ((f32(bitcast<i32>(((_e2755 >> bitcast<u32>((_e2763 & 31u))) & 65535u))) - _e2762) * _e2770)) - _e2722) * _e2775));
let _e2780 = local_10.member[1u];
let _e2781 = ((_e2656 + _e2653) + _e2780);
let _e2783 = (_e2781 >> bitcast<u32>(1i));
let _e2786 = bitcast<u32>(((_e2781 & 1i) * 16i));
let _e2788 = select(_e1374, _e2783, (_e2783 < _e1374));
let _e2793 = global_1.member[bitcast<u32>(select(0i, _e2788, (_e2788 > 0i)))];
let _e2797 = (_e2783 + 1i);
let _e2799 = select(_e1374, _e2797, (_e2797 < _e1374));
let _e2804 = global_1.member[bitcast<u32>(select(0i, _e2799, (_e2799 > 0i)))];
let _e2811 = ((_e2793 >> bitcast<u32>((_e2786 & 31u))) | ((_e2804 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2786) & 31u))));
let _e2812 = local_10.member_1[2u];
let _e2818 = f32(bitcast<i32>(((_e2811 >> bitcast<u32>((_e2812 & 31u))) & 65535u)));
let _e2819 = local_10.member_1[3u];
let _e2826 = local_11[0u];
let _e2829 = (_e2818 + ((f32(bitcast<i32>(((_e2811 >> bitcast<u32>((_e2819 & 31u))) & 65535u))) - _e2818) * _e2826));
let _e2831 = local_10.member[1u];
let _e2832 = ((_e2656 + _e2654) + _e2831);
let _e2834 = (_e2832 >> bitcast<u32>(1i));
let _e2837 = bitcast<u32>(((_e2832 & 1i) * 16i));
let _e2839 = select(_e1374, _e2834, (_e2834 < _e1374));
let _e2844 = global_1.member[bitcast<u32>(select(0i, _e2839, (_e2839 > 0i)))];
let _e2848 = (_e2834 + 1i);
let _e2850 = select(_e1374, _e2848, (_e2848 < _e1374));
let _e2855 = global_1.member[bitcast<u32>(select(0i, _e2850, (_e2850 > 0i)))];
let _e2862 = ((_e2844 >> bitcast<u32>((_e2837 & 31u))) | ((_e2855 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2837) & 31u))));
let _e2863 = local_10.member_1[2u];
let _e2869 = f32(bitcast<i32>(((_e2862 >> bitcast<u32>((_e2863 & 31u))) & 65535u)));
let _e2870 = local_10.member_1[3u];
let _e2877 = local_11[0u];
let _e2881 = local_11[1u];
let _e2886 = local_11[2u];
let _e2891 = (((_e2778 + (((_e2829 + (((_e2869 + ((f32(bitcast<i32>(((_e2862 >> bitcast<u32>((_e2870 & 31u))) & 65535u))) - _e2869) * _e2877)) - _e2829) * _e2881)) - _e2778) * _e2886)) - _e1593) * _e1598);
let _e2893 = select(_e1601, _e2891, (_e2891 > _e1601));
let _e2900 = (((_e1115 * _e1115) + (_e1116 * _e1116)) + (_e1117 * _e1117));
let _e2905 = select(0f, (sqrt(select(0f, _e2900, (_e2900 > 0f))) * _e1120), _e1114);
phi_8768_ = (_e371[8] + _e2905);
phi_8769_ = (_e371[6] + ((((select(1e9f, _e1603, (_e1603 < 1e9f)) + select(1e9f, _e2033, (_e2033 < 1e9f))) + (select(1e9f, _e2463, (_e2463 < 1e9f)) + select(1e9f, _e2893, (_e2893 < 1e9f)))) * 0.25f) * _e2905));
} else {
if _e685 {
phi_4938_ = -(2e9f);
} else {
phi_4938_ = 2e9f;
}
let _e2915 = phi_4938_;
let _e2916 = select(_e371[6], _e2915, _e684);
let _e2917 = (_e1111.member_1 - _e1111.member);
let _e2919 = (_e1111.member + (_e2917 * 0f));
let _e2923 = (_e401 + (_e1115 * _e2919));
let _e2924 = (_e403 + (_e1116 * _e2919));
let _e2925 = (_e391 + (_e1117 * _e2919));
let _e2931 = ((((_e417.member.member * _e2923) + (_e417.member.member_1 * _e2924)) + (_e417.member.member_2 * _e2925)) + _e417.member_1);
let _e2937 = ((((_e433.member.member * _e2923) + (_e433.member.member_1 * _e2924)) + (_e433.member.member_2 * _e2925)) + _e433.member_1);
let _e2943 = ((((_e449.member.member * _e2923) + (_e449.member.member_1 * _e2924)) + (_e449.member.member_2 * _e2925)) + _e449.member_1);
let _e2945 = select(_e484, _e2931, (_e2931 > _e484));
let _e2947 = select(_e490, _e2945, (_e2945 < _e490));
let _e2949 = select(_e500, _e2937, (_e2937 > _e500));
let _e2951 = select(_e506, _e2949, (_e2949 < _e506));
let _e2953 = select(_e516, _e2943, (_e2943 > _e516));
let _e2955 = select(_e522, _e2953, (_e2953 < _e522));
let _e2961 = global_2.member[_e367].member_8.member_15;
let _e2962 = (_e2961 == 0u);
if _e2962 {
phi_5146_ = vec3<f32>(_e2947, _e2951, _e2955);
} else {
let _e2963 = (_e2947 + 0.5f);
let _e2965 = select(0f, _e2963, (_e2963 > 0f));
let _e2967 = select(_e574, _e2965, (_e2965 < _e574));
let _e2974 = select(0i, select(select(i32(_e2967), i32(-2147483648), (_e2967 < -2147483600f)), 2147483647i, (_e2967 > 2147483500f)), (_e2967 == _e2967));
let _e2980 = (_e2951 + 0.5f);
let _e2982 = select(0f, _e2980, (_e2980 > 0f));
let _e2984 = select(_e605, _e2982, (_e2982 < _e605));
let _e2991 = select(0i, select(select(i32(_e2984), i32(-2147483648), (_e2984 < -2147483600f)), 2147483647i, (_e2984 > 2147483500f)), (_e2984 == _e2984));
let _e2997 = (_e2955 + 0.5f);
let _e2999 = select(0f, _e2997, (_e2997 > 0f));
let _e3001 = select(_e630, _e2999, (_e2999 < _e630));
let _e3008 = select(0i, select(select(i32(_e3001), i32(-2147483648), (_e3001 < -2147483600f)), 2147483647i, (_e3001 > 2147483500f)), (_e3001 == _e3001));
phi_5146_ = vec3<f32>(f32((_e2974 - select(0i, 1i, (_e2967 < f32(_e2974))))), f32((_e2991 - select(0i, 1i, (_e2984 < f32(_e2991))))), f32((_e3008 - select(0i, 1i, (_e3001 < f32(_e3008))))));
}
let _e3016 = phi_5146_;
let _e3019 = select(-1f, _e3016.x, (_e3016.x > -1f));
let _e3021 = select(_e572, _e3019, (_e3019 < _e572));
let _e3028 = select(0i, select(select(i32(_e3021), i32(-2147483648), (_e3021 < -2147483600f)), 2147483647i, (_e3021 > 2147483500f)), (_e3021 == _e3021));
let _e3032 = (_e3028 - select(0i, 1i, (_e3021 < f32(_e3028))));
let _e3035 = select(-1f, _e3016.y, (_e3016.y > -1f));
let _e3037 = select(_e603, _e3035, (_e3035 < _e603));
let _e3044 = select(0i, select(select(i32(_e3037), i32(-2147483648), (_e3037 < -2147483600f)), 2147483647i, (_e3037 > 2147483500f)), (_e3037 == _e3037));
let _e3048 = (_e3044 - select(0i, 1i, (_e3037 < f32(_e3044))));
let _e3051 = select(-1f, _e3016.z, (_e3016.z > -1f));
let _e3053 = select(_e628, _e3051, (_e3051 < _e628));
let _e3060 = select(0i, select(select(i32(_e3053), i32(-2147483648), (_e3053 < -2147483600f)), 2147483647i, (_e3053 > 2147483500f)), (_e3053 == _e3053));
let _e3064 = (_e3060 - select(0i, 1i, (_e3053 < f32(_e3060))));
let _e3069 = global_2.member[_e367].member_8.member_9;
let _e3074 = global_2.member[_e367].member_8.member_10;
let _e3082 = (select(0i, select(select(i32(_e603), i32(-2147483648), (_e603 < -2147483600f)), 2147483647i, (_e603 > 2147483500f)), (_e603 == _e603)) - 1i);
let _e3085 = (_e3048 + 1i);
let _e3095 = (select(0i, select(select(i32(_e628), i32(-2147483648), (_e628 < -2147483600f)), 2147483647i, (_e628 > 2147483500f)), (_e628 == _e628)) - 1i);
let _e3098 = (_e3064 + 1i);
let _e3107 = select(0i, select(select(i32(_e572), i32(-2147483648), (_e572 < -2147483600f)), 2147483647i, (_e572 > 2147483500f)), (_e572 == _e572));
let _e3108 = (_e3107 - 1i);
let _e3109 = (_e3032 - 1i);
let _e3111 = select(0i, _e3109, (_e3109 > 0i));
let _e3113 = select(0i, _e3032, (_e3032 > 0i));
let _e3114 = (_e3032 + 1i);
let _e3116 = select(_e3108, _e3114, (_e3114 < _e3108));
let _e3117 = (_e3032 + 2i);
let _e3120 = (_e3107 - 2i);
let _e3122 = select(0i, _e3120, (_e3120 > 0i));
let _e3124 = select(_e3122, _e3111, (_e3111 < _e3122));
let _e3126 = select(_e3122, _e3113, (_e3113 < _e3122));
let _e3128 = select(_e3122, _e3116, (_e3116 < _e3122));
let _e3147 = (select(0i, _e3048, (_e3048 > 0i)) * _e3069);
let _e3148 = (select(_e3082, _e3085, (_e3085 < _e3082)) * _e3069);
let _e3149 = (select(0i, _e3064, (_e3064 > 0i)) * _e3074);
let _e3150 = (select(_e3095, _e3098, (_e3098 < _e3095)) * _e3074);
local_8 = type_29(array<i32, 4>(_e3124, _e3126, _e3128, 0i), array<u32, 6>(bitcast<u32>(((_e3111 - _e3124) * 16i)), bitcast<u32>(((_e3113 - _e3124) * 16i)), bitcast<u32>(((_e3113 - _e3126) * 16i)), bitcast<u32>(((_e3116 - _e3126) * 16i)), bitcast<u32>(((_e3116 - _e3128) * 16i)), bitcast<u32>(((select(_e3108, _e3117, (_e3117 < _e3108)) - _e3128) * 16i))));
local_9 = (_e3016 - vec3<f32>(f32(_e3032), f32(_e3048), f32(_e3064)));
let _e3163 = local_8.member[1u];
let _e3164 = ((_e3149 + _e3147) + _e3163);
let _e3166 = (_e3164 >> bitcast<u32>(1i));
let _e3169 = bitcast<u32>(((_e3164 & 1i) * 16i));
let _e3171 = (bitcast<i32>(_e84) - 1i);
let _e3173 = select(_e3171, _e3166, (_e3166 < _e3171));
let _e3178 = global_1.member[bitcast<u32>(select(0i, _e3173, (_e3173 > 0i)))];
let _e3182 = (_e3166 + 1i);
let _e3184 = select(_e3171, _e3182, (_e3182 < _e3171));
let _e3189 = global_1.member[bitcast<u32>(select(0i, _e3184, (_e3184 > 0i)))];
let _e3196 = ((_e3178 >> bitcast<u32>((_e3169 & 31u))) | ((_e3189 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3169) & 31u))));
let _e3199 = local_8.member_1[2u];
let _e3205 = f32(bitcast<i32>(((_e3196 >> bitcast<u32>((_e3199 & 31u))) & 65535u)));
let _e3208 = local_8.member_1[3u];
let _e3215 = local_9[0u];
let _e3218 = (_e3205 + ((f32(bitcast<i32>(((_e3196 >> bitcast<u32>((_e3208 & 31u))) & 65535u))) - _e3205) * _e3215));
let _e3220 = local_8.member[1u];
let _e3221 = ((_e3149 + _e3148) + _e3220);
let _e3223 = (_e3221 >> bitcast<u32>(1i));
let _e3226 = bitcast<u32>(((_e3221 & 1i) * 16i));
let _e3228 = select(_e3171, _e3223, (_e3223 < _e3171));
let _e3233 = global_1.member[bitcast<u32>(select(0i, _e3228, (_e3228 > 0i)))];
let _e3237 = (_e3223 + 1i);
let _e3239 = select(_e3171, _e3237, (_e3237 < _e3171));
let _e3244 = global_1.member[bitcast<u32>(select(0i, _e3239, (_e3239 > 0i)))];
let _e3251 = ((_e3233 >> bitcast<u32>((_e3226 & 31u))) | ((_e3244 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3226) & 31u))));
let _e3252 = local_8.member_1[2u];
let _e3258 = f32(bitcast<i32>(((_e3251 >> bitcast<u32>((_e3252 & 31u))) & 65535u)));
let _e3259 = local_8.member_1[3u];
let _e3266 = local_9[0u];
let _e3271 = local_9[1u];
let _e3274 = (_e3218 + (((_e3258 + ((f32(bitcast<i32>(((_e3251 >> bitcast<u32>((_e3259 & 31u))) & 65535u))) - _e3258) * _e3266)) - _e3218) * _e3271));
let _e3276 = local_8.member[1u];
let _e3277 = ((_e3150 + _e3147) + _e3276);
let _e3279 = (_e3277 >> bitcast<u32>(1i));
let _e3282 = bitcast<u32>(((_e3277 & 1i) * 16i));
let _e3284 = select(_e3171, _e3279, (_e3279 < _e3171));
let _e3289 = global_1.member[bitcast<u32>(select(0i, _e3284, (_e3284 > 0i)))];
let _e3293 = (_e3279 + 1i);
let _e3295 = select(_e3171, _e3293, (_e3293 < _e3171));
let _e3300 = global_1.member[bitcast<u32>(select(0i, _e3295, (_e3295 > 0i)))];
let _e3307 = ((_e3289 >> bitcast<u32>((_e3282 & 31u))) | ((_e3300 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3282) & 31u))));
let _e3308 = local_8.member_1[2u];
let _e3314 = f32(bitcast<i32>(((_e3307 >> bitcast<u32>((_e3308 & 31u))) & 65535u)));
let _e3315 = local_8.member_1[3u];
let _e3322 = local_9[0u];
let _e3325 = (_e3314 + ((f32(bitcast<i32>(((_e3307 >> bitcast<u32>((_e3315 & 31u))) & 65535u))) - _e3314) * _e3322));
let _e3327 = local_8.member[1u];
let _e3328 = ((_e3150 + _e3148) + _e3327);
let _e3330 = (_e3328 >> bitcast<u32>(1i));
let _e3333 = bitcast<u32>(((_e3328 & 1i) * 16i));
let _e3335 = select(_e3171, _e3330, (_e3330 < _e3171));
let _e3340 = global_1.member[bitcast<u32>(select(0i, _e3335, (_e3335 > 0i)))];
let _e3344 = (_e3330 + 1i);
let _e3346 = select(_e3171, _e3344, (_e3344 < _e3171));
let _e3351 = global_1.member[bitcast<u32>(select(0i, _e3346, (_e3346 > 0i)))];
let _e3358 = ((_e3340 >> bitcast<u32>((_e3333 & 31u))) | ((_e3351 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3333) & 31u))));
let _e3359 = local_8.member_1[2u];
let _e3365 = f32(bitcast<i32>(((_e3358 >> bitcast<u32>((_e3359 & 31u))) & 65535u)));
let _e3366 = local_8.member_1[3u];
let _e3373 = local_9[0u];
let _e3377 = local_9[1u];
let _e3382 = local_9[2u];
let _e3390 = global_2.member[_e367].member_8.member_8;
let _e3395 = global_2.member[_e367].member_8.member_7;
let _e3397 = (((_e3274 + (((_e3325 + (((_e3365 + ((f32(bitcast<i32>(((_e3358 >> bitcast<u32>((_e3366 & 31u))) & 65535u))) - _e3365) * _e3373)) - _e3325) * _e3377)) - _e3274) * _e3382)) - _e3390) * _e3395);
let _e3398 = -(1e9f);
let _e3400 = select(_e3398, _e3397, (_e3397 > _e3398));
let _e3402 = select(1e9f, _e3400, (_e3400 < 1e9f));
if _e685 {
phi_5700_ = (_e3402 > _e2916);
} else {
phi_5700_ = (_e3402 < _e2916);
}
let _e3409 = phi_5700_;
let _e3410 = ((_e1114 && (_e684 || (_e1111.member > 0f))) && _e3409);
let _e3411 = select(_e2916, _e3402, _e3410);
let _e3414 = (_e1111.member + (_e2917 * 0.25f));
let _e3418 = (_e401 + (_e1115 * _e3414));
let _e3419 = (_e403 + (_e1116 * _e3414));
let _e3420 = (_e391 + (_e1117 * _e3414));
let _e3426 = ((((_e417.member.member * _e3418) + (_e417.member.member_1 * _e3419)) + (_e417.member.member_2 * _e3420)) + _e417.member_1);
let _e3432 = ((((_e433.member.member * _e3418) + (_e433.member.member_1 * _e3419)) + (_e433.member.member_2 * _e3420)) + _e433.member_1);
let _e3438 = ((((_e449.member.member * _e3418) + (_e449.member.member_1 * _e3419)) + (_e449.member.member_2 * _e3420)) + _e449.member_1);
let _e3440 = select(_e484, _e3426, (_e3426 > _e484));
let _e3442 = select(_e490, _e3440, (_e3440 < _e490));
let _e3444 = select(_e500, _e3432, (_e3432 > _e500));
let _e3446 = select(_e506, _e3444, (_e3444 < _e506));
let _e3448 = select(_e516, _e3438, (_e3438 > _e516));
let _e3450 = select(_e522, _e3448, (_e3448 < _e522));
if _e2962 {
phi_5913_ = vec3<f32>(_e3442, _e3446, _e3450);
} else {
let _e3452 = (_e3442 + 0.5f);
let _e3454 = select(0f, _e3452, (_e3452 > 0f));
let _e3456 = select(_e574, _e3454, (_e3454 < _e574));
let _e3463 = select(0i, select(select(i32(_e3456), i32(-2147483648), (_e3456 < -2147483600f)), 2147483647i, (_e3456 > 2147483500f)), (_e3456 == _e3456));
let _e3469 = (_e3446 + 0.5f);
let _e3471 = select(0f, _e3469, (_e3469 > 0f));
let _e3473 = select(_e605, _e3471, (_e3471 < _e605));
let _e3480 = select(0i, select(select(i32(_e3473), i32(-2147483648), (_e3473 < -2147483600f)), 2147483647i, (_e3473 > 2147483500f)), (_e3473 == _e3473));
let _e3486 = (_e3450 + 0.5f);
let _e3488 = select(0f, _e3486, (_e3486 > 0f));
let _e3490 = select(_e630, _e3488, (_e3488 < _e630));
let _e3497 = select(0i, select(select(i32(_e3490), i32(-2147483648), (_e3490 < -2147483600f)), 2147483647i, (_e3490 > 2147483500f)), (_e3490 == _e3490));
phi_5913_ = vec3<f32>(f32((_e3463 - select(0i, 1i, (_e3456 < f32(_e3463))))), f32((_e3480 - select(0i, 1i, (_e3473 < f32(_e3480))))), f32((_e3497 - select(0i, 1i, (_e3490 < f32(_e3497))))));
}
let _e3505 = phi_5913_;
let _e3508 = select(-1f, _e3505.x, (_e3505.x > -1f));
let _e3510 = select(_e572, _e3508, (_e3508 < _e572));
let _e3517 = select(0i, select(select(i32(_e3510), i32(-2147483648), (_e3510 < -2147483600f)), 2147483647i, (_e3510 > 2147483500f)), (_e3510 == _e3510));
let _e3521 = (_e3517 - select(0i, 1i, (_e3510 < f32(_e3517))));
let _e3524 = select(-1f, _e3505.y, (_e3505.y > -1f));
let _e3526 = select(_e603, _e3524, (_e3524 < _e603));
let _e3533 = select(0i, select(select(i32(_e3526), i32(-2147483648), (_e3526 < -2147483600f)), 2147483647i, (_e3526 > 2147483500f)), (_e3526 == _e3526));
let _e3537 = (_e3533 - select(0i, 1i, (_e3526 < f32(_e3533))));
let _e3540 = select(-1f, _e3505.z, (_e3505.z > -1f));
let _e3542 = select(_e628, _e3540, (_e3540 < _e628));
let _e3549 = select(0i, select(select(i32(_e3542), i32(-2147483648), (_e3542 < -2147483600f)), 2147483647i, (_e3542 > 2147483500f)), (_e3542 == _e3542));
let _e3553 = (_e3549 - select(0i, 1i, (_e3542 < f32(_e3549))));
let _e3556 = (_e3537 + 1i);
let _e3561 = (_e3553 + 1i);
let _e3564 = (_e3521 - 1i);
let _e3566 = select(0i, _e3564, (_e3564 > 0i));
let _e3568 = select(0i, _e3521, (_e3521 > 0i));
let _e3569 = (_e3521 + 1i);
let _e3571 = select(_e3108, _e3569, (_e3569 < _e3108));
let _e3572 = (_e3521 + 2i);
let _e3576 = select(_e3122, _e3566, (_e3566 < _e3122));
let _e3578 = select(_e3122, _e3568, (_e3568 < _e3122));
let _e3580 = select(_e3122, _e3571, (_e3571 < _e3122));
let _e3599 = (select(0i, _e3537, (_e3537 > 0i)) * _e3069);
let _e3600 = (select(_e3082, _e3556, (_e3556 < _e3082)) * _e3069);
let _e3601 = (select(0i, _e3553, (_e3553 > 0i)) * _e3074);
let _e3602 = (select(_e3095, _e3561, (_e3561 < _e3095)) * _e3074);
local_6 = type_29(array<i32, 4>(_e3576, _e3578, _e3580, 0i), array<u32, 6>(bitcast<u32>(((_e3566 - _e3576) * 16i)), bitcast<u32>(((_e3568 - _e3576) * 16i)), bitcast<u32>(((_e3568 - _e3578) * 16i)), bitcast<u32>(((_e3571 - _e3578) * 16i)), bitcast<u32>(((_e3571 - _e3580) * 16i)), bitcast<u32>(((select(_e3108, _e3572, (_e3572 < _e3108)) - _e3580) * 16i))));
local_7 = (_e3505 - vec3<f32>(f32(_e3521), f32(_e3537), f32(_e3553)));
let _e3615 = local_6.member[1u];
let _e3616 = ((_e3601 + _e3599) + _e3615);
let _e3618 = (_e3616 >> bitcast<u32>(1i));
let _e3621 = bitcast<u32>(((_e3616 & 1i) * 16i));
let _e3623 = select(_e3171, _e3618, (_e3618 < _e3171));
let _e3628 = global_1.member[bitcast<u32>(select(0i, _e3623, (_e3623 > 0i)))];
let _e3632 = (_e3618 + 1i);
let _e3634 = select(_e3171, _e3632, (_e3632 < _e3171));
let _e3639 = global_1.member[bitcast<u32>(select(0i, _e3634, (_e3634 > 0i)))];
let _e3646 = ((_e3628 >> bitcast<u32>((_e3621 & 31u))) | ((_e3639 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3621) & 31u))));
let _e3649 = local_6.member_1[2u];
let _e3655 = f32(bitcast<i32>(((_e3646 >> bitcast<u32>((_e3649 & 31u))) & 65535u)));
let _e3658 = local_6.member_1[3u];
let _e3665 = local_7[0u];
let _e3668 = (_e3655 + ((f32(bitcast<i32>(((_e3646 >> bitcast<u32>((_e3658 & 31u))) & 65535u))) - _e3655) * _e3665));
let _e3670 = local_6.member[1u];
let _e3671 = ((_e3601 + _e3600) + _e3670);
let _e3673 = (_e3671 >> bitcast<u32>(1i));
let _e3676 = bitcast<u32>(((_e3671 & 1i) * 16i));
let _e3678 = select(_e3171, _e3673, (_e3673 < _e3171));
let _e3683 = global_1.member[bitcast<u32>(select(0i, _e3678, (_e3678 > 0i)))];
let _e3687 = (_e3673 + 1i);
let _e3689 = select(_e3171, _e3687, (_e3687 < _e3171));
let _e3694 = global_1.member[bitcast<u32>(select(0i, _e3689, (_e3689 > 0i)))];
let _e3701 = ((_e3683 >> bitcast<u32>((_e3676 & 31u))) | ((_e3694 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3676) & 31u))));
let _e3702 = local_6.member_1[2u];
let _e3708 = f32(bitcast<i32>(((_e3701 >> bitcast<u32>((_e3702 & 31u))) & 65535u)));
let _e3709 = local_6.member_1[3u];
let _e3716 = local_7[0u];
let _e3721 = local_7[1u];
let _e3724 = (_e3668 + (((_e3708 + ((f32(bitcast<i32>(((_e3701 >> bitcast<u32>((_e3709 & 31u))) & 65535u))) - _e3708) * _e3716)) - _e3668) * _e3721));
let _e3726 = local_6.member[1u];
let _e3727 = ((_e3602 + _e3599) + _e3726);
let _e3729 = (_e3727 >> bitcast<u32>(1i));
let _e3732 = bitcast<u32>(((_e3727 & 1i) * 16i));
let _e3734 = select(_e3171, _e3729, (_e3729 < _e3171));
let _e3739 = global_1.member[bitcast<u32>(select(0i, _e3734, (_e3734 > 0i)))];
let _e3743 = (_e3729 + 1i);
let _e3745 = select(_e3171, _e3743, (_e3743 < _e3171));
let _e3750 = global_1.member[bitcast<u32>(select(0i, _e3745, (_e3745 > 0i)))];
let _e3757 = ((_e3739 >> bitcast<u32>((_e3732 & 31u))) | ((_e3750 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3732) & 31u))));
let _e3758 = local_6.member_1[2u];
let _e3764 = f32(bitcast<i32>(((_e3757 >> bitcast<u32>((_e3758 & 31u))) & 65535u)));
let _e3765 = local_6.member_1[3u];
let _e3772 = local_7[0u];
let _e3775 = (_e3764 + ((f32(bitcast<i32>(((_e3757 >> bitcast<u32>((_e3765 & 31u))) & 65535u))) - _e3764) * _e3772));
let _e3777 = local_6.member[1u];
let _e3778 = ((_e3602 + _e3600) + _e3777);
let _e3780 = (_e3778 >> bitcast<u32>(1i));
let _e3783 = bitcast<u32>(((_e3778 & 1i) * 16i));
let _e3785 = select(_e3171, _e3780, (_e3780 < _e3171));
let _e3790 = global_1.member[bitcast<u32>(select(0i, _e3785, (_e3785 > 0i)))];
let _e3794 = (_e3780 + 1i);
let _e3796 = select(_e3171, _e3794, (_e3794 < _e3171));
let _e3801 = global_1.member[bitcast<u32>(select(0i, _e3796, (_e3796 > 0i)))];
let _e3808 = ((_e3790 >> bitcast<u32>((_e3783 & 31u))) | ((_e3801 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3783) & 31u))));
let _e3809 = local_6.member_1[2u];
let _e3815 = f32(bitcast<i32>(((_e3808 >> bitcast<u32>((_e3809 & 31u))) & 65535u)));
let _e3816 = local_6.member_1[3u];
let _e3823 = local_7[0u];
let _e3827 = local_7[1u];
let _e3832 = local_7[2u];
let _e3837 = (((_e3724 + (((_e3775 + (((_e3815 + ((f32(bitcast<i32>(((_e3808 >> bitcast<u32>((_e3816 & 31u))) & 65535u))) - _e3815) * _e3823)) - _e3775) * _e3827)) - _e3724) * _e3832)) - _e3390) * _e3395);
let _e3839 = select(_e3398, _e3837, (_e3837 > _e3398));
let _e3841 = select(1e9f, _e3839, (_e3839 < 1e9f));
if _e685 {
phi_6464_ = (_e3841 > _e3411);
} else {
phi_6464_ = (_e3841 < _e3411);
}
let _e3845 = phi_6464_;
let _e3846 = (_e1114 && _e3845);
let _e3847 = select(_e3411, _e3841, _e3846);
let _e3851 = (_e1111.member + (_e2917 * (2f * 0.25f)));
let _e3855 = (_e401 + (_e1115 * _e3851));
let _e3856 = (_e403 + (_e1116 * _e3851));
let _e3857 = (_e391 + (_e1117 * _e3851));
let _e3863 = ((((_e417.member.member * _e3855) + (_e417.member.member_1 * _e3856)) + (_e417.member.member_2 * _e3857)) + _e417.member_1);
let _e3869 = ((((_e433.member.member * _e3855) + (_e433.member.member_1 * _e3856)) + (_e433.member.member_2 * _e3857)) + _e433.member_1);
let _e3875 = ((((_e449.member.member * _e3855) + (_e449.member.member_1 * _e3856)) + (_e449.member.member_2 * _e3857)) + _e449.member_1);
let _e3877 = select(_e484, _e3863, (_e3863 > _e484));
let _e3879 = select(_e490, _e3877, (_e3877 < _e490));
let _e3881 = select(_e500, _e3869, (_e3869 > _e500));
let _e3883 = select(_e506, _e3881, (_e3881 < _e506));
let _e3885 = select(_e516, _e3875, (_e3875 > _e516));
let _e3887 = select(_e522, _e3885, (_e3885 < _e522));
if _e2962 {
phi_6678_ = vec3<f32>(_e3879, _e3883, _e3887);
} else {
let _e3889 = (_e3879 + 0.5f);
let _e3891 = select(0f, _e3889, (_e3889 > 0f));
let _e3893 = select(_e574, _e3891, (_e3891 < _e574));
let _e3900 = select(0i, select(select(i32(_e3893), i32(-2147483648), (_e3893 < -2147483600f)), 2147483647i, (_e3893 > 2147483500f)), (_e3893 == _e3893));
let _e3906 = (_e3883 + 0.5f);
let _e3908 = select(0f, _e3906, (_e3906 > 0f));
let _e3910 = select(_e605, _e3908, (_e3908 < _e605));
let _e3917 = select(0i, select(select(i32(_e3910), i32(-2147483648), (_e3910 < -2147483600f)), 2147483647i, (_e3910 > 2147483500f)), (_e3910 == _e3910));
let _e3923 = (_e3887 + 0.5f);
let _e3925 = select(0f, _e3923, (_e3923 > 0f));
let _e3927 = select(_e630, _e3925, (_e3925 < _e630));
let _e3934 = select(0i, select(select(i32(_e3927), i32(-2147483648), (_e3927 < -2147483600f)), 2147483647i, (_e3927 > 2147483500f)), (_e3927 == _e3927));
phi_6678_ = vec3<f32>(f32((_e3900 - select(0i, 1i, (_e3893 < f32(_e3900))))), f32((_e3917 - select(0i, 1i, (_e3910 < f32(_e3917))))), f32((_e3934 - select(0i, 1i, (_e3927 < f32(_e3934))))));
}
let _e3942 = phi_6678_;
let _e3945 = select(-1f, _e3942.x, (_e3942.x > -1f));
let _e3947 = select(_e572, _e3945, (_e3945 < _e572));
let _e3954 = select(0i, select(select(i32(_e3947), i32(-2147483648), (_e3947 < -2147483600f)), 2147483647i, (_e3947 > 2147483500f)), (_e3947 == _e3947));
let _e3958 = (_e3954 - select(0i, 1i, (_e3947 < f32(_e3954))));
let _e3961 = select(-1f, _e3942.y, (_e3942.y > -1f));
let _e3963 = select(_e603, _e3961, (_e3961 < _e603));
let _e3970 = select(0i, select(select(i32(_e3963), i32(-2147483648), (_e3963 < -2147483600f)), 2147483647i, (_e3963 > 2147483500f)), (_e3963 == _e3963));
let _e3974 = (_e3970 - select(0i, 1i, (_e3963 < f32(_e3970))));
let _e3977 = select(-1f, _e3942.z, (_e3942.z > -1f));
let _e3979 = select(_e628, _e3977, (_e3977 < _e628));
let _e3986 = select(0i, select(select(i32(_e3979), i32(-2147483648), (_e3979 < -2147483600f)), 2147483647i, (_e3979 > 2147483500f)), (_e3979 == _e3979));
let _e3990 = (_e3986 - select(0i, 1i, (_e3979 < f32(_e3986))));
let _e3993 = (_e3974 + 1i);
let _e3998 = (_e3990 + 1i);
let _e4001 = (_e3958 - 1i);
let _e4003 = select(0i, _e4001, (_e4001 > 0i));
let _e4005 = select(0i, _e3958, (_e3958 > 0i));
let _e4006 = (_e3958 + 1i);
let _e4008 = select(_e3108, _e4006, (_e4006 < _e3108));
let _e4009 = (_e3958 + 2i);
let _e4013 = select(_e3122, _e4003, (_e4003 < _e3122));
let _e4015 = select(_e3122, _e4005, (_e4005 < _e3122));
let _e4017 = select(_e3122, _e4008, (_e4008 < _e3122));
let _e4036 = (select(0i, _e3974, (_e3974 > 0i)) * _e3069);
let _e4037 = (select(_e3082, _e3993, (_e3993 < _e3082)) * _e3069);
let _e4038 = (select(0i, _e3990, (_e3990 > 0i)) * _e3074);
let _e4039 = (select(_e3095, _e3998, (_e3998 < _e3095)) * _e3074);
local_4 = type_29(array<i32, 4>(_e4013, _e4015, _e4017, 0i), array<u32, 6>(bitcast<u32>(((_e4003 - _e4013) * 16i)), bitcast<u32>(((_e4005 - _e4013) * 16i)), bitcast<u32>(((_e4005 - _e4015) * 16i)), bitcast<u32>(((_e4008 - _e4015) * 16i)), bitcast<u32>(((_e4008 - _e4017) * 16i)), bitcast<u32>(((select(_e3108, _e4009, (_e4009 < _e3108)) - _e4017) * 16i))));
local_5 = (_e3942 - vec3<f32>(f32(_e3958), f32(_e3974), f32(_e3990)));
let _e4052 = local_4.member[1u];
let _e4053 = ((_e4038 + _e4036) + _e4052);
let _e4055 = (_e4053 >> bitcast<u32>(1i));
let _e4058 = bitcast<u32>(((_e4053 & 1i) * 16i));
let _e4060 = select(_e3171, _e4055, (_e4055 < _e3171));
let _e4065 = global_1.member[bitcast<u32>(select(0i, _e4060, (_e4060 > 0i)))];
let _e4069 = (_e4055 + 1i);
let _e4071 = select(_e3171, _e4069, (_e4069 < _e3171));
let _e4076 = global_1.member[bitcast<u32>(select(0i, _e4071, (_e4071 > 0i)))];
let _e4083 = ((_e4065 >> bitcast<u32>((_e4058 & 31u))) | ((_e4076 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4058) & 31u))));
let _e4086 = local_4.member_1[2u];
let _e4092 = f32(bitcast<i32>(((_e4083 >> bitcast<u32>((_e4086 & 31u))) & 65535u)));
let _e4095 = local_4.member_1[3u];
let _e4102 = local_5[0u];
let _e4105 = (_e4092 + ((f32(bitcast<i32>(((_e4083 >> bitcast<u32>((_e4095 & 31u))) & 65535u))) - _e4092) * _e4102));
let _e4107 = local_4.member[1u];
let _e4108 = ((_e4038 + _e4037) + _e4107);
let _e4110 = (_e4108 >> bitcast<u32>(1i));
let _e4113 = bitcast<u32>(((_e4108 & 1i) * 16i));
let _e4115 = select(_e3171, _e4110, (_e4110 < _e3171));
let _e4120 = global_1.member[bitcast<u32>(select(0i, _e4115, (_e4115 > 0i)))];
let _e4124 = (_e4110 + 1i);
let _e4126 = select(_e3171, _e4124, (_e4124 < _e3171));
let _e4131 = global_1.member[bitcast<u32>(select(0i, _e4126, (_e4126 > 0i)))];
let _e4138 = ((_e4120 >> bitcast<u32>((_e4113 & 31u))) | ((_e4131 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4113) & 31u))));
let _e4139 = local_4.member_1[2u];
let _e4145 = f32(bitcast<i32>(((_e4138 >> bitcast<u32>((_e4139 & 31u))) & 65535u)));
let _e4146 = local_4.member_1[3u];
let _e4153 = local_5[0u];
let _e4158 = local_5[1u];
let _e4161 = (_e4105 + (((_e4145 + ((f32(bitcast<i32>(((_e4138 >> bitcast<u32>((_e4146 & 31u))) & 65535u))) - _e4145) * _e4153)) - _e4105) * _e4158));
let _e4163 = local_4.member[1u];
let _e4164 = ((_e4039 + _e4036) + _e4163);
let _e4166 = (_e4164 >> bitcast<u32>(1i));
let _e4169 = bitcast<u32>(((_e4164 & 1i) * 16i));
let _e4171 = select(_e3171, _e4166, (_e4166 < _e3171));
let _e4176 = global_1.member[bitcast<u32>(select(0i, _e4171, (_e4171 > 0i)))];
let _e4180 = (_e4166 + 1i);
let _e4182 = select(_e3171, _e4180, (_e4180 < _e3171));
let _e4187 = global_1.member[bitcast<u32>(select(0i, _e4182, (_e4182 > 0i)))];
let _e4194 = ((_e4176 >> bitcast<u32>((_e4169 & 31u))) | ((_e4187 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4169) & 31u))));
let _e4195 = local_4.member_1[2u];
let _e4201 = f32(bitcast<i32>(((_e4194 >> bitcast<u32>((_e4195 & 31u))) & 65535u)));
let _e4202 = local_4.member_1[3u];
let _e4209 = local_5[0u];
let _e4212 = (_e4201 + ((f32(bitcast<i32>(((_e4194 >> bitcast<u32>((_e4202 & 31u))) & 65535u))) - _e4201) * _e4209));
let _e4214 = local_4.member[1u];
let _e4215 = ((_e4039 + _e4037) + _e4214);
let _e4217 = (_e4215 >> bitcast<u32>(1i));
let _e4220 = bitcast<u32>(((_e4215 & 1i) * 16i));
let _e4222 = select(_e3171, _e4217, (_e4217 < _e3171));
let _e4227 = global_1.member[bitcast<u32>(select(0i, _e4222, (_e4222 > 0i)))];
let _e4231 = (_e4217 + 1i);
let _e4233 = select(_e3171, _e4231, (_e4231 < _e3171));
let _e4238 = global_1.member[bitcast<u32>(select(0i, _e4233, (_e4233 > 0i)))];
let _e4245 = ((_e4227 >> bitcast<u32>((_e4220 & 31u))) | ((_e4238 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4220) & 31u))));
let _e4246 = local_4.member_1[2u];
let _e4252 = f32(bitcast<i32>(((_e4245 >> bitcast<u32>((_e4246 & 31u))) & 65535u)));
let _e4253 = local_4.member_1[3u];
let _e4260 = local_5[0u];
let _e4264 = local_5[1u];
let _e4269 = local_5[2u];
let _e4274 = (((_e4161 + (((_e4212 + (((_e4252 + ((f32(bitcast<i32>(((_e4245 >> bitcast<u32>((_e4253 & 31u))) & 65535u))) - _e4252) * _e4260)) - _e4212) * _e4264)) - _e4161) * _e4269)) - _e3390) * _e3395);
let _e4276 = select(_e3398, _e4274, (_e4274 > _e3398));
let _e4278 = select(1e9f, _e4276, (_e4276 < 1e9f));
if _e685 {
phi_7229_ = (_e4278 > _e3847);
} else {
phi_7229_ = (_e4278 < _e3847);
}
let _e4282 = phi_7229_;
let _e4283 = (_e1114 && _e4282);
let _e4284 = select(_e3847, _e4278, _e4283);
let _e4288 = (_e1111.member + (_e2917 * (3f * 0.25f)));
let _e4292 = (_e401 + (_e1115 * _e4288));
let _e4293 = (_e403 + (_e1116 * _e4288));
let _e4294 = (_e391 + (_e1117 * _e4288));
let _e4300 = ((((_e417.member.member * _e4292) + (_e417.member.member_1 * _e4293)) + (_e417.member.member_2 * _e4294)) + _e417.member_1);
let _e4306 = ((((_e433.member.member * _e4292) + (_e433.member.member_1 * _e4293)) + (_e433.member.member_2 * _e4294)) + _e433.member_1);
let _e4312 = ((((_e449.member.member * _e4292) + (_e449.member.member_1 * _e4293)) + (_e449.member.member_2 * _e4294)) + _e449.member_1);
let _e4314 = select(_e484, _e4300, (_e4300 > _e484));
let _e4316 = select(_e490, _e4314, (_e4314 < _e490));
let _e4318 = select(_e500, _e4306, (_e4306 > _e500));
let _e4320 = select(_e506, _e4318, (_e4318 < _e506));
let _e4322 = select(_e516, _e4312, (_e4312 > _e516));
let _e4324 = select(_e522, _e4322, (_e4322 < _e522));
if _e2962 {
phi_7443_ = vec3<f32>(_e4316, _e4320, _e4324);
} else {
let _e4326 = (_e4316 + 0.5f);
let _e4328 = select(0f, _e4326, (_e4326 > 0f));
let _e4330 = select(_e574, _e4328, (_e4328 < _e574));
let _e4337 = select(0i, select(select(i32(_e4330), i32(-2147483648), (_e4330 < -2147483600f)), 2147483647i, (_e4330 > 2147483500f)), (_e4330 == _e4330));
let _e4343 = (_e4320 + 0.5f);
let _e4345 = select(0f, _e4343, (_e4343 > 0f));
let _e4347 = select(_e605, _e4345, (_e4345 < _e605));
let _e4354 = select(0i, select(select(i32(_e4347), i32(-2147483648), (_e4347 < -2147483600f)), 2147483647i, (_e4347 > 2147483500f)), (_e4347 == _e4347));
let _e4360 = (_e4324 + 0.5f);
let _e4362 = select(0f, _e4360, (_e4360 > 0f));
let _e4364 = select(_e630, _e4362, (_e4362 < _e630));
let _e4371 = select(0i, select(select(i32(_e4364), i32(-2147483648), (_e4364 < -2147483600f)), 2147483647i, (_e4364 > 2147483500f)), (_e4364 == _e4364));
phi_7443_ = vec3<f32>(f32((_e4337 - select(0i, 1i, (_e4330 < f32(_e4337))))), f32((_e4354 - select(0i, 1i, (_e4347 < f32(_e4354))))), f32((_e4371 - select(0i, 1i, (_e4364 < f32(_e4371))))));
}
let _e4379 = phi_7443_;
let _e4382 = select(-1f, _e4379.x, (_e4379.x > -1f));
let _e4384 = select(_e572, _e4382, (_e4382 < _e572));
let _e4391 = select(0i, select(select(i32(_e4384), i32(-2147483648), (_e4384 < -2147483600f)), 2147483647i, (_e4384 > 2147483500f)), (_e4384 == _e4384));
let _e4395 = (_e4391 - select(0i, 1i, (_e4384 < f32(_e4391))));
let _e4398 = select(-1f, _e4379.y, (_e4379.y > -1f));
let _e4400 = select(_e603, _e4398, (_e4398 < _e603));
let _e4407 = select(0i, select(select(i32(_e4400), i32(-2147483648), (_e4400 < -2147483600f)), 2147483647i, (_e4400 > 2147483500f)), (_e4400 == _e4400));
let _e4411 = (_e4407 - select(0i, 1i, (_e4400 < f32(_e4407))));
let _e4414 = select(-1f, _e4379.z, (_e4379.z > -1f));
let _e4416 = select(_e628, _e4414, (_e4414 < _e628));
let _e4423 = select(0i, select(select(i32(_e4416), i32(-2147483648), (_e4416 < -2147483600f)), 2147483647i, (_e4416 > 2147483500f)), (_e4416 == _e4416));
let _e4427 = (_e4423 - select(0i, 1i, (_e4416 < f32(_e4423))));
let _e4430 = (_e4411 + 1i);
let _e4435 = (_e4427 + 1i);
let _e4438 = (_e4395 - 1i);
let _e4440 = select(0i, _e4438, (_e4438 > 0i));
let _e4442 = select(0i, _e4395, (_e4395 > 0i));
let _e4443 = (_e4395 + 1i);
let _e4445 = select(_e3108, _e4443, (_e4443 < _e3108));
let _e4446 = (_e4395 + 2i);
let _e4450 = select(_e3122, _e4440, (_e4440 < _e3122));
let _e4452 = select(_e3122, _e4442, (_e4442 < _e3122));
let _e4454 = select(_e3122, _e4445, (_e4445 < _e3122));
let _e4473 = (select(0i, _e4411, (_e4411 > 0i)) * _e3069);
let _e4474 = (select(_e3082, _e4430, (_e4430 < _e3082)) * _e3069);
let _e4475 = (select(0i, _e4427, (_e4427 > 0i)) * _e3074);
let _e4476 = (select(_e3095, _e4435, (_e4435 < _e3095)) * _e3074);
local_2 = type_29(array<i32, 4>(_e4450, _e4452, _e4454, 0i), array<u32, 6>(bitcast<u32>(((_e4440 - _e4450) * 16i)), bitcast<u32>(((_e4442 - _e4450) * 16i)), bitcast<u32>(((_e4442 - _e4452) * 16i)), bitcast<u32>(((_e4445 - _e4452) * 16i)), bitcast<u32>(((_e4445 - _e4454) * 16i)), bitcast<u32>(((select(_e3108, _e4446, (_e4446 < _e3108)) - _e4454) * 16i))));
local_3 = (_e4379 - vec3<f32>(f32(_e4395), f32(_e4411), f32(_e4427)));
let _e4489 = local_2.member[1u];
let _e4490 = ((_e4475 + _e4473) + _e4489);
let _e4492 = (_e4490 >> bitcast<u32>(1i));
let _e4495 = bitcast<u32>(((_e4490 & 1i) * 16i));
let _e4497 = select(_e3171, _e4492, (_e4492 < _e3171));
let _e4502 = global_1.member[bitcast<u32>(select(0i, _e4497, (_e4497 > 0i)))];
let _e4506 = (_e4492 + 1i);
let _e4508 = select(_e3171, _e4506, (_e4506 < _e3171));
let _e4513 = global_1.member[bitcast<u32>(select(0i, _e4508, (_e4508 > 0i)))];
let _e4520 = ((_e4502 >> bitcast<u32>((_e4495 & 31u))) | ((_e4513 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4495) & 31u))));
let _e4523 = local_2.member_1[2u];
let _e4529 = f32(bitcast<i32>(((_e4520 >> bitcast<u32>((_e4523 & 31u))) & 65535u)));
let _e4532 = local_2.member_1[3u];
let _e4539 = local_3[0u];
let _e4542 = (_e4529 + ((f32(bitcast<i32>(((_e4520 >> bitcast<u32>((_e4532 & 31u))) & 65535u))) - _e4529) * _e4539));
let _e4544 = local_2.member[1u];
let _e4545 = ((_e4475 + _e4474) + _e4544);
let _e4547 = (_e4545 >> bitcast<u32>(1i));
let _e4550 = bitcast<u32>(((_e4545 & 1i) * 16i));
let _e4552 = select(_e3171, _e4547, (_e4547 < _e3171));
let _e4557 = global_1.member[bitcast<u32>(select(0i, _e4552, (_e4552 > 0i)))];
let _e4561 = (_e4547 + 1i);
let _e4563 = select(_e3171, _e4561, (_e4561 < _e3171));
let _e4568 = global_1.member[bitcast<u32>(select(0i, _e4563, (_e4563 > 0i)))];
let _e4575 = ((_e4557 >> bitcast<u32>((_e4550 & 31u))) | ((_e4568 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4550) & 31u))));
let _e4576 = local_2.member_1[2u];
let _e4582 = f32(bitcast<i32>(((_e4575 >> bitcast<u32>((_e4576 & 31u))) & 65535u)));
let _e4583 = local_2.member_1[3u];
let _e4590 = local_3[0u];
let _e4595 = local_3[1u];
let _e4598 = (_e4542 + (((_e4582 + ((f32(bitcast<i32>(((_e4575 >> bitcast<u32>((_e4583 & 31u))) & 65535u))) - _e4582) * _e4590)) - _e4542) * _e4595));
let _e4600 = local_2.member[1u];
let _e4601 = ((_e4476 + _e4473) + _e4600);
let _e4603 = (_e4601 >> bitcast<u32>(1i));
let _e4606 = bitcast<u32>(((_e4601 & 1i) * 16i));
let _e4608 = select(_e3171, _e4603, (_e4603 < _e3171));
let _e4613 = global_1.member[bitcast<u32>(select(0i, _e4608, (_e4608 > 0i)))];
let _e4617 = (_e4603 + 1i);
let _e4619 = select(_e3171, _e4617, (_e4617 < _e3171));
let _e4624 = global_1.member[bitcast<u32>(select(0i, _e4619, (_e4619 > 0i)))];
let _e4631 = ((_e4613 >> bitcast<u32>((_e4606 & 31u))) | ((_e4624 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4606) & 31u))));
let _e4632 = local_2.member_1[2u];
let _e4638 = f32(bitcast<i32>(((_e4631 >> bitcast<u32>((_e4632 & 31u))) & 65535u)));
let _e4639 = local_2.member_1[3u];
let _e4646 = local_3[0u];
let _e4649 = (_e4638 + ((f32(bitcast<i32>(((_e4631 >> bitcast<u32>((_e4639 & 31u))) & 65535u))) - _e4638) * _e4646));
let _e4651 = local_2.member[1u];
let _e4652 = ((_e4476 + _e4474) + _e4651);
let _e4654 = (_e4652 >> bitcast<u32>(1i));
let _e4657 = bitcast<u32>(((_e4652 & 1i) * 16i));
let _e4659 = select(_e3171, _e4654, (_e4654 < _e3171));
let _e4664 = global_1.member[bitcast<u32>(select(0i, _e4659, (_e4659 > 0i)))];
let _e4668 = (_e4654 + 1i);
let _e4670 = select(_e3171, _e4668, (_e4668 < _e3171));
let _e4675 = global_1.member[bitcast<u32>(select(0i, _e4670, (_e4670 > 0i)))];
let _e4682 = ((_e4664 >> bitcast<u32>((_e4657 & 31u))) | ((_e4675 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4657) & 31u))));
let _e4683 = local_2.member_1[2u];
let _e4689 = f32(bitcast<i32>(((_e4682 >> bitcast<u32>((_e4683 & 31u))) & 65535u)));
let _e4690 = local_2.member_1[3u];
let _e4697 = local_3[0u];
let _e4701 = local_3[1u];
let _e4706 = local_3[2u];
let _e4711 = (((_e4598 + (((_e4649 + (((_e4689 + ((f32(bitcast<i32>(((_e4682 >> bitcast<u32>((_e4690 & 31u))) & 65535u))) - _e4689) * _e4697)) - _e4649) * _e4701)) - _e4598) * _e4706)) - _e3390) * _e3395);
let _e4713 = select(_e3398, _e4711, (_e4711 > _e3398));
let _e4715 = select(1e9f, _e4713, (_e4713 < 1e9f));
if _e685 {
phi_7994_ = (_e4715 > _e4284);
} else {
phi_7994_ = (_e4715 < _e4284);
}
let _e4719 = phi_7994_;
let _e4720 = (_e1114 && _e4719);
let _e4721 = select(_e4284, _e4715, _e4720);
let _e4724 = (_e1111.member + (_e2917 * 1f));
let _e4728 = (_e401 + (_e1115 * _e4724));
let _e4729 = (_e403 + (_e1116 * _e4724));
let _e4730 = (_e391 + (_e1117 * _e4724));
let _e4736 = ((((_e417.member.member * _e4728) + (_e417.member.member_1 * _e4729)) + (_e417.member.member_2 * _e4730)) + _e417.member_1);
let _e4742 = ((((_e433.member.member * _e4728) + (_e433.member.member_1 * _e4729)) + (_e433.member.member_2 * _e4730)) + _e433.member_1);
let _e4748 = ((((_e449.member.member * _e4728) + (_e449.member.member_1 * _e4729)) + (_e449.member.member_2 * _e4730)) + _e449.member_1);
let _e4750 = select(_e484, _e4736, (_e4736 > _e484));
let _e4752 = select(_e490, _e4750, (_e4750 < _e490));
let _e4754 = select(_e500, _e4742, (_e4742 > _e500));
let _e4756 = select(_e506, _e4754, (_e4754 < _e506));
let _e4758 = select(_e516, _e4748, (_e4748 > _e516));
let _e4760 = select(_e522, _e4758, (_e4758 < _e522));
if _e2962 {
phi_8207_ = vec3<f32>(_e4752, _e4756, _e4760);
} else {
let _e4762 = (_e4752 + 0.5f);
let _e4764 = select(0f, _e4762, (_e4762 > 0f));
let _e4766 = select(_e574, _e4764, (_e4764 < _e574));
let _e4773 = select(0i, select(select(i32(_e4766), i32(-2147483648), (_e4766 < -2147483600f)), 2147483647i, (_e4766 > 2147483500f)), (_e4766 == _e4766));
let _e4779 = (_e4756 + 0.5f);
let _e4781 = select(0f, _e4779, (_e4779 > 0f));
let _e4783 = select(_e605, _e4781, (_e4781 < _e605));
let _e4790 = select(0i, select(select(i32(_e4783), i32(-2147483648), (_e4783 < -2147483600f)), 2147483647i, (_e4783 > 2147483500f)), (_e4783 == _e4783));
let _e4796 = (_e4760 + 0.5f);
let _e4798 = select(0f, _e4796, (_e4796 > 0f));
let _e4800 = select(_e630, _e4798, (_e4798 < _e630));
let _e4807 = select(0i, select(select(i32(_e4800), i32(-2147483648), (_e4800 < -2147483600f)), 2147483647i, (_e4800 > 2147483500f)), (_e4800 == _e4800));
phi_8207_ = vec3<f32>(f32((_e4773 - select(0i, 1i, (_e4766 < f32(_e4773))))), f32((_e4790 - select(0i, 1i, (_e4783 < f32(_e4790))))), f32((_e4807 - select(0i, 1i, (_e4800 < f32(_e4807))))));
}
let _e4815 = phi_8207_;
let _e4818 = select(-1f, _e4815.x, (_e4815.x > -1f));
let _e4820 = select(_e572, _e4818, (_e4818 < _e572));
let _e4827 = select(0i, select(select(i32(_e4820), i32(-2147483648), (_e4820 < -2147483600f)), 2147483647i, (_e4820 > 2147483500f)), (_e4820 == _e4820));
let _e4831 = (_e4827 - select(0i, 1i, (_e4820 < f32(_e4827))));
let _e4834 = select(-1f, _e4815.y, (_e4815.y > -1f));
let _e4836 = select(_e603, _e4834, (_e4834 < _e603));
let _e4843 = select(0i, select(select(i32(_e4836), i32(-2147483648), (_e4836 < -2147483600f)), 2147483647i, (_e4836 > 2147483500f)), (_e4836 == _e4836));
let _e4847 = (_e4843 - select(0i, 1i, (_e4836 < f32(_e4843))));
let _e4850 = select(-1f, _e4815.z, (_e4815.z > -1f));
let _e4852 = select(_e628, _e4850, (_e4850 < _e628));
let _e4859 = select(0i, select(select(i32(_e4852), i32(-2147483648), (_e4852 < -2147483600f)), 2147483647i, (_e4852 > 2147483500f)), (_e4852 == _e4852));
let _e4863 = (_e4859 - select(0i, 1i, (_e4852 < f32(_e4859))));
let _e4866 = (_e4847 + 1i);
let _e4871 = (_e4863 + 1i);
let _e4874 = (_e4831 - 1i);
let _e4876 = select(0i, _e4874, (_e4874 > 0i));
let _e4878 = select(0i, _e4831, (_e4831 > 0i));
let _e4879 = (_e4831 + 1i);
let _e4881 = select(_e3108, _e4879, (_e4879 < _e3108));
let _e4882 = (_e4831 + 2i);
let _e4886 = select(_e3122, _e4876, (_e4876 < _e3122));
let _e4888 = select(_e3122, _e4878, (_e4878 < _e3122));
let _e4890 = select(_e3122, _e4881, (_e4881 < _e3122));
let _e4909 = (select(0i, _e4847, (_e4847 > 0i)) * _e3069);
let _e4910 = (select(_e3082, _e4866, (_e4866 < _e3082)) * _e3069);
let _e4911 = (select(0i, _e4863, (_e4863 > 0i)) * _e3074);
let _e4912 = (select(_e3095, _e4871, (_e4871 < _e3095)) * _e3074);
local = type_29(array<i32, 4>(_e4886, _e4888, _e4890, 0i), array<u32, 6>(bitcast<u32>(((_e4876 - _e4886) * 16i)), bitcast<u32>(((_e4878 - _e4886) * 16i)), bitcast<u32>(((_e4878 - _e4888) * 16i)), bitcast<u32>(((_e4881 - _e4888) * 16i)), bitcast<u32>(((_e4881 - _e4890) * 16i)), bitcast<u32>(((select(_e3108, _e4882, (_e4882 < _e3108)) - _e4890) * 16i))));
local_1 = (_e4815 - vec3<f32>(f32(_e4831), f32(_e4847), f32(_e4863)));
let _e4925 = local.member[1u];
let _e4926 = ((_e4911 + _e4909) + _e4925);
let _e4928 = (_e4926 >> bitcast<u32>(1i));
let _e4931 = bitcast<u32>(((_e4926 & 1i) * 16i));
let _e4933 = select(_e3171, _e4928, (_e4928 < _e3171));
let _e4938 = global_1.member[bitcast<u32>(select(0i, _e4933, (_e4933 > 0i)))];
let _e4942 = (_e4928 + 1i);
let _e4944 = select(_e3171, _e4942, (_e4942 < _e3171));
let _e4949 = global_1.member[bitcast<u32>(select(0i, _e4944, (_e4944 > 0i)))];
let _e4956 = ((_e4938 >> bitcast<u32>((_e4931 & 31u))) | ((_e4949 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4931) & 31u))));
let _e4959 = local.member_1[2u];
let _e4965 = f32(bitcast<i32>(((_e4956 >> bitcast<u32>((_e4959 & 31u))) & 65535u)));
let _e4968 = local.member_1[3u];
let _e4975 = local_1[0u];
let _e4978 = (_e4965 + ((f32(bitcast<i32>(((_e4956 >> bitcast<u32>((_e4968 & 31u))) & 65535u))) - _e4965) * _e4975));
let _e4980 = local.member[1u];
let _e4981 = ((_e4911 + _e4910) + _e4980);
let _e4983 = (_e4981 >> bitcast<u32>(1i));
let _e4986 = bitcast<u32>(((_e4981 & 1i) * 16i));
let _e4988 = select(_e3171, _e4983, (_e4983 < _e3171));
let _e4993 = global_1.member[bitcast<u32>(select(0i, _e4988, (_e4988 > 0i)))];
let _e4997 = (_e4983 + 1i);
let _e4999 = select(_e3171, _e4997, (_e4997 < _e3171));
let _e5004 = global_1.member[bitcast<u32>(select(0i, _e4999, (_e4999 > 0i)))];
let _e5011 = ((_e4993 >> bitcast<u32>((_e4986 & 31u))) | ((_e5004 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4986) & 31u))));
let _e5012 = local.member_1[2u];
let _e5018 = f32(bitcast<i32>(((_e5011 >> bitcast<u32>((_e5012 & 31u))) & 65535u)));
let _e5019 = local.member_1[3u];
let _e5026 = local_1[0u];
let _e5031 = local_1[1u];
let _e5034 = (_e4978 + (((_e5018 + ((f32(bitcast<i32>(((_e5011 >> bitcast<u32>((_e5019 & 31u))) & 65535u))) - _e5018) * _e5026)) - _e4978) * _e5031));
let _e5036 = local.member[1u];
let _e5037 = ((_e4912 + _e4909) + _e5036);
let _e5039 = (_e5037 >> bitcast<u32>(1i));
let _e5042 = bitcast<u32>(((_e5037 & 1i) * 16i));
let _e5044 = select(_e3171, _e5039, (_e5039 < _e3171));
let _e5049 = global_1.member[bitcast<u32>(select(0i, _e5044, (_e5044 > 0i)))];
let _e5053 = (_e5039 + 1i);
let _e5055 = select(_e3171, _e5053, (_e5053 < _e3171));
let _e5060 = global_1.member[bitcast<u32>(select(0i, _e5055, (_e5055 > 0i)))];
let _e5067 = ((_e5049 >> bitcast<u32>((_e5042 & 31u))) | ((_e5060 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e5042) & 31u))));
let _e5068 = local.member_1[2u];
let _e5074 = f32(bitcast<i32>(((_e5067 >> bitcast<u32>((_e5068 & 31u))) & 65535u)));
let _e5075 = local.member_1[3u];
let _e5082 = local_1[0u];
let _e5085 = (_e5074 + ((f32(bitcast<i32>(((_e5067 >> bitcast<u32>((_e5075 & 31u))) & 65535u))) - _e5074) * _e5082));
let _e5087 = local.member[1u];
let _e5088 = ((_e4912 + _e4910) + _e5087);
let _e5090 = (_e5088 >> bitcast<u32>(1i));
let _e5093 = bitcast<u32>(((_e5088 & 1i) * 16i));
let _e5095 = select(_e3171, _e5090, (_e5090 < _e3171));
let _e5100 = global_1.member[bitcast<u32>(select(0i, _e5095, (_e5095 > 0i)))];
let _e5104 = (_e5090 + 1i);
let _e5106 = select(_e3171, _e5104, (_e5104 < _e3171));
let _e5111 = global_1.member[bitcast<u32>(select(0i, _e5106, (_e5106 > 0i)))];
let _e5118 = ((_e5100 >> bitcast<u32>((_e5093 & 31u))) | ((_e5111 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e5093) & 31u))));
let _e5119 = local.member_1[2u];
let _e5125 = f32(bitcast<i32>(((_e5118 >> bitcast<u32>((_e5119 & 31u))) & 65535u)));
let _e5126 = local.member_1[3u];
let _e5133 = local_1[0u];
let _e5137 = local_1[1u];
let _e5142 = local_1[2u];
let _e5147 = (((_e5034 + (((_e5085 + (((_e5125 + ((f32(bitcast<i32>(((_e5118 >> bitcast<u32>((_e5126 & 31u))) & 65535u))) - _e5125) * _e5133)) - _e5085) * _e5137)) - _e5034) * _e5142)) - _e3390) * _e3395);
let _e5149 = select(_e3398, _e5147, (_e5147 > _e3398));
let _e5151 = select(1e9f, _e5149, (_e5149 < 1e9f));
if _e685 {
phi_8758_ = (_e5151 > _e4721);
} else {
phi_8758_ = (_e5151 < _e4721);
}
let _e5155 = phi_8758_;
let _e5156 = (_e1114 && _e5155);
phi_8768_ = select(select(select(select(select(_e371[8], _e2925, _e3410), _e3420, _e3846), _e3857, _e4283), _e4294, _e4720), _e4730, _e5156);
phi_8769_ = select(_e4721, _e5151, _e5156);
}
let _e5160 = phi_8768_;
let _e5162 = phi_8769_;
phi_8787_ = array<f32, 23>(_e371[0], _e371[1], _e371[2], _e371[3], _e371[4], _e371[5], select(_e371[6], _e5162, _e1114), _e371[7], select(_e371[8], _e5160, _e1114), _e371[9], _e371[10], _e371[11], _e371[12], _e371[13], _e371[14], _e371[15], _e371[16], select(_e371[17], _e412, _e1114), _e371[18], _e371[19], _e371[20], _e371[21], _e371[22]);
} else {
phi_8787_ = _e371;
}
let _e5168 = phi_8787_;
phi_629_ = (_e367 + 1u);
phi_632_ = select(_e369, true, _e743);
phi_634_ = _e5168;
} else {
phi_629_ = u32();
phi_632_ = bool();
phi_634_ = array<f32, 23>();
}
let _e5172 = phi_629_;
let _e5174 = phi_632_;
let _e5176 = phi_634_;
continue;
continuing {
phi_628_ = _e5172;
phi_631_ = _e5174;
phi_633_ = _e5176;
phi_8890_ = false;
break if !(_e372);
}
}
let _e5179 = phi_8890_;
if _e5179 {
break;
}
let _e5181 = local_18;
if _e5181 {
let _e5183 = local_19;
global_4.member[_e112] = _e5183[0];
let _e5188 = local_20;
global_4.member[_e124] = _e5188[1];
let _e5193 = local_21;
global_4.member[_e135] = _e5193[2];
let _e5198 = local_22;
global_4.member[_e146] = _e5198[3];
let _e5203 = local_23;
global_4.member[_e157] = _e5203[4];
let _e5208 = local_24;
global_4.member[_e168] = _e5208[5];
let _e5213 = local_25;
global_4.member[_e179] = _e5213[6];
let _e5218 = local_26;
global_4.member[_e190] = _e5218[7];
let _e5223 = local_27;
global_4.member[_e201] = _e5223[8];
let _e5228 = local_28;
global_4.member[_e212] = _e5228[9];
let _e5233 = local_29;
global_4.member[_e223] = _e5233[10];
let _e5238 = local_30;
global_4.member[_e234] = _e5238[11];
let _e5243 = local_31;
global_4.member[_e245] = _e5243[12];
let _e5248 = local_32;
global_4.member[_e256] = _e5248[13];
let _e5253 = local_33;
global_4.member[_e267] = _e5253[14];
let _e5258 = local_34;
global_4.member[_e278] = _e5258[15];
let _e5263 = local_35;
global_4.member[_e289] = _e5263[16];
let _e5268 = local_36;
global_4.member[_e300] = _e5268[17];
let _e5273 = local_37;
global_4.member[_e311] = _e5273[18];
let _e5278 = local_38;
global_4.member[_e322] = _e5278[19];
let _e5283 = local_39;
global_4.member[_e333] = _e5283[20];
let _e5288 = local_40;
global_4.member[_e344] = _e5288[21];
let _e5293 = local_41;
global_4.member[_e355] = _e5293[22];
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
