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
struct type_23 {
member: type_22,
}
struct type_25 {
member: array<u32>,
}
struct type_27 {
member: array<f32>,
}
struct type_30 {
member: array<i32, 4>,
member_1: array<u32, 6>,
}
struct type_33 {
member: f32,
member_1: f32,
}
struct type_34 {
member: f32,
member_1: vec3<f32>,
member_2: vec3<f32>,
}
struct type_35 {
member: f32,
member_1: vec3<f32>,
member_2: vec3<f32>,
member_3: f32,
member_4: vec3<f32>,
member_5: vec3<f32>,
}
struct type_36 {
member: type_33,
member_1: type_33,
member_2: f32,
}
struct type_37 {
member: f32,
member_1: vec3<f32>,
member_2: f32,
member_3: vec3<f32>,
member_4: f32,
member_5: f32,
member_6: vec3<f32>,
}
struct type_38 {
member: f32,
member_1: f32,
member_2: vec3<f32>,
member_3: vec3<f32>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_23;
@group(0) @binding(1)
var<storage> global_2: type_25;
@group(0) @binding(4)
var<storage> global_3: type_25;
@group(0) @binding(6)
var<storage, read_write> global_4: type_27;
@group(0) @binding(3)
var<storage> global_5: type_25;
@group(0) @binding(5)
var<storage> global_6: type_27;
fn function_() {
var local: f32;
var local_1: f32;
var local_2: type_30;
var local_3: vec3<f32>;
var local_4: f32;
var local_5: f32;
var local_6: f32;
var local_7: f32;
var local_8: type_30;
var local_9: vec3<f32>;
var local_10: type_30;
var local_11: vec3<f32>;
var local_12: type_30;
var local_13: vec3<f32>;
var local_14: f32;
var local_15: f32;
var local_16: f32;
var local_17: f32;
var local_18: f32;
var local_19: f32;
var local_20: f32;
var local_21: f32;
var local_22: f32;
var local_23: f32;
var local_24: f32;
var local_25: f32;
var local_26: f32;
var local_27: f32;
var local_28: type_30;
var local_29: vec3<f32>;
var phi_951_: bool;
var phi_1141_: bool;
var phi_1144_: bool;
var phi_1338_: bool;
var phi_1674_: u32;
var phi_2047_: vec3<f32>;
var phi_7240_: type_34;
var phi_7587_: vec3<f32>;
var phi_8962_: vec3<f32>;
var phi_9375_: f32;
var phi_9376_: vec3<f32>;
var phi_9378_: type_35;
var phi_9524_: vec3<f32>;
var phi_10457_: type_36;
var phi_14401_: type_38;
var phi_14799_: f32;
var phi_16124_: type_37;
var phi_16137_: vec3<f32>;
var phi_16138_: f32;
var phi_16368_: vec3<f32>;
var phi_18863_: type_37;
var phi_19015_: vec3<f32>;
var phi_19016_: f32;
let _e169 = global;
let _e172 = arrayLength((&global_2.member));
let _e177 = arrayLength((&global_3.member));
let _e179 = arrayLength((&global_6.member));
let _e184 = global_1.member.member_2;
let _e187 = global_1.member.member;
let _e195 = (_e169.x + _e184.member);
let _e197 = (_e169.y + _e184.member_1);
if (_e195 < _e184.member_2) {
if (_e197 < _e184.member_3) {
let _e200 = (_e187.member * _e187.member_1);
let _e202 = ((_e197 * _e187.member) + _e195);
let _e203 = bitcast<i32>(_e202);
let _e205 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e207 = select(_e205, _e203, (_e203 < _e205));
let _e213 = global_4.member[bitcast<u32>(select(0i, _e207, (_e207 > 0i)))];
let _e214 = (_e200 + _e202);
let _e215 = bitcast<i32>(_e214);
let _e217 = select(_e205, _e215, (_e215 < _e205));
let _e223 = global_4.member[bitcast<u32>(select(0i, _e217, (_e217 > 0i)))];
let _e225 = ((2u * _e200) + _e202);
let _e226 = bitcast<i32>(_e225);
let _e228 = select(_e205, _e226, (_e226 < _e205));
let _e234 = global_4.member[bitcast<u32>(select(0i, _e228, (_e228 > 0i)))];
let _e236 = ((3u * _e200) + _e202);
let _e237 = bitcast<i32>(_e236);
let _e239 = select(_e205, _e237, (_e237 < _e205));
let _e245 = global_4.member[bitcast<u32>(select(0i, _e239, (_e239 > 0i)))];
let _e247 = ((4u * _e200) + _e202);
let _e248 = bitcast<i32>(_e247);
let _e250 = select(_e205, _e248, (_e248 < _e205));
let _e256 = global_4.member[bitcast<u32>(select(0i, _e250, (_e250 > 0i)))];
let _e258 = ((5u * _e200) + _e202);
let _e259 = bitcast<i32>(_e258);
let _e261 = select(_e205, _e259, (_e259 < _e205));
let _e267 = global_4.member[bitcast<u32>(select(0i, _e261, (_e261 > 0i)))];
let _e269 = ((6u * _e200) + _e202);
let _e270 = bitcast<i32>(_e269);
let _e272 = select(_e205, _e270, (_e270 < _e205));
let _e278 = global_4.member[bitcast<u32>(select(0i, _e272, (_e272 > 0i)))];
let _e280 = ((7u * _e200) + _e202);
let _e281 = bitcast<i32>(_e280);
let _e283 = select(_e205, _e281, (_e281 < _e205));
let _e289 = global_4.member[bitcast<u32>(select(0i, _e283, (_e283 > 0i)))];
let _e291 = ((8u * _e200) + _e202);
let _e292 = bitcast<i32>(_e291);
let _e294 = select(_e205, _e292, (_e292 < _e205));
let _e300 = global_4.member[bitcast<u32>(select(0i, _e294, (_e294 > 0i)))];
let _e305 = global_1.member.member_10.member;
let _e309 = global_1.member.member_10.member_1;
let _e310 = (_e305 * _e309);
if (_e179 >= (_e310 * 4u)) {
let _e314 = bitcast<i32>((_e197 * _e305));
let _e316 = bitcast<i32>(_e195);
let _e321 = global_6.member[bitcast<u32>((_e314 + _e316))];
let _e327 = global_6.member[bitcast<u32>(((bitcast<i32>(_e310) + _e314) + _e316))];
let _e328 = f32(_e316);
let _e330 = f32(bitcast<i32>(_e197));
let _e336 = global_1.member.member_7.member;
let _e340 = global_1.member.member_10.member_8;
let _e341 = (_e336 - _e340);
let _e345 = global_1.member.member_10.member_2;
let _e349 = global_1.member.member_10.member_6;
let _e356 = global_1.member.member_10.member_4;
let _e358 = ((_e345 + (_e349 * _e341)) + (((_e328 - _e321) + 0.5f) * _e356));
let _e362 = global_1.member.member_10.member_3;
let _e366 = global_1.member.member_10.member_7;
let _e371 = ((_e362 + (_e366 * _e341)) + (((_e330 - _e327) + 0.5f) * _e356));
let _e375 = global_1.member.member_7.member_1;
let _e376 = (_e375 - _e340);
let _e381 = ((_e345 + (_e349 * _e376)) + ((_e328 + 0.5f) * _e356));
let _e386 = ((_e362 + (_e366 * _e376)) + ((_e330 + 0.5f) * _e356));
let _e392 = global_1.member.member_8.member.member;
let _e400 = (((_e392.member * _e392.member) + (_e392.member_1 * _e392.member_1)) + (_e392.member_2 * _e392.member_2));
let _e403 = sqrt(select(0f, _e400, (_e400 > 0f)));
let _e404 = ((1.5f * _e356) * _e403);
let _e408 = (select(1f, _e404, (_e404 < 1f)) + (1f / 64f));
let _e410 = select(_e408, 0.5f, (0.5f > _e408));
let _e414 = global_1.member.member_7.member_2;
let _e417 = (_e414 / select(1e-6f, _e267, (_e267 > 1e-6f)));
let _e421 = (_e381 + (_e245 * _e417));
let _e422 = (_e386 + (_e256 * _e417));
let _e423 = (_e375 + (_e267 * _e417));
let _e427 = global_1.member.member_8.member;
let _e438 = ((((_e427.member.member * _e358) + (_e427.member.member_1 * _e371)) + (_e427.member.member_2 * _e336)) + _e427.member_1);
let _e442 = global_1.member.member_8.member_1;
let _e453 = ((((_e442.member.member * _e358) + (_e442.member.member_1 * _e371)) + (_e442.member.member_2 * _e336)) + _e442.member_1);
let _e457 = global_1.member.member_8.member_2;
let _e468 = ((((_e457.member.member * _e358) + (_e457.member.member_1 * _e371)) + (_e457.member.member_2 * _e336)) + _e457.member_1);
let _e474 = ((((_e427.member.member * _e381) + (_e427.member.member_1 * _e386)) + (_e427.member.member_2 * _e375)) + _e427.member_1);
let _e480 = ((((_e442.member.member * _e381) + (_e442.member.member_1 * _e386)) + (_e442.member.member_2 * _e375)) + _e442.member_1);
let _e486 = ((((_e457.member.member * _e381) + (_e457.member.member_1 * _e386)) + (_e457.member.member_2 * _e375)) + _e457.member_1);
let _e491 = global_1.member.member_8.member_4.member;
let _e492 = (_e491 + 0.5f);
let _e498 = global_1.member.member_8.member_5.member;
let _e499 = (_e498 - 0.5f);
let _e506 = global_1.member.member_8.member_4.member_1;
let _e507 = (_e506 + 0.5f);
let _e514 = global_1.member.member_8.member_5.member_1;
let _e515 = (_e514 - 0.5f);
let _e522 = global_1.member.member_8.member_4.member_2;
let _e523 = (_e522 + 0.5f);
let _e530 = global_1.member.member_8.member_5.member_2;
let _e531 = (_e530 - 0.5f);
let _e545 = (((((((_e438 >= _e492) && (_e438 <= _e499)) && (_e453 >= _e507)) && (_e453 <= _e515)) && (_e468 >= _e523)) && (_e468 <= _e531)) && ((((((_e474 >= _e492) && (_e474 <= _e499)) && (_e480 >= _e507)) && (_e480 <= _e515)) && (_e486 >= _e523)) && (_e486 <= _e531)));
let _e554 = ((((_e187.member_2 == 1u) || (_e187.member_2 == 5u)) || (_e187.member_2 == 6u)) || ((_e187.member_2 == 2u) || (_e187.member_2 == 7u)));
if _e554 {
let _e555 = (_e491 + _e410);
let _e557 = (_e498 - _e410);
let _e560 = (_e506 + _e410);
let _e562 = (_e514 - _e410);
let _e566 = (_e522 + _e410);
let _e568 = (_e530 - _e410);
let _e571 = ((((_e438 >= _e555) && (_e438 <= _e557)) && ((_e453 >= _e560) && (_e453 <= _e562))) && ((_e468 >= _e566) && (_e468 <= _e568)));
let _e574 = global_1.member.member_1;
let _e576 = ((_e574 & 16u) == 0u);
if _e576 {
phi_951_ = _e571;
} else {
let _e581 = global_1.member.member_16.member;
let _e593 = -((_e410 / _e403));
let _e598 = global_1.member.member_16.member_1;
let _e604 = global_1.member.member_17.member;
let _e620 = global_1.member.member_17.member_1;
let _e627 = global_1.member.member_18.member;
let _e643 = global_1.member.member_18.member_1;
let _e650 = global_1.member.member_19.member;
let _e666 = global_1.member.member_19.member_1;
phi_951_ = (_e571 && (((((((((_e581.member.member * _e358) + (_e581.member.member_1 * _e371)) + (_e581.member.member_2 * _e336)) + _e581.member_1) <= _e593) || (_e598 == 0u)) && ((((((_e604.member.member * _e358) + (_e604.member.member_1 * _e371)) + (_e604.member.member_2 * _e336)) + _e604.member_1) <= _e593) || (_e620 == 0u))) && ((((((_e627.member.member * _e358) + (_e627.member.member_1 * _e371)) + (_e627.member.member_2 * _e336)) + _e627.member_1) <= _e593) || (_e643 == 0u))) && ((((((_e650.member.member * _e358) + (_e650.member.member_1 * _e371)) + (_e650.member.member_2 * _e336)) + _e650.member_1) <= _e593) || (_e666 == 0u))));
}
let _e672 = phi_951_;
let _e676 = (_e381 + (_e381 - _e358));
let _e677 = (_e386 + (_e386 - _e371));
let _e678 = (_e375 + (_e375 - _e336));
let _e684 = ((((_e427.member.member * _e676) + (_e427.member.member_1 * _e677)) + (_e427.member.member_2 * _e678)) + _e427.member_1);
let _e690 = ((((_e442.member.member * _e676) + (_e442.member.member_1 * _e677)) + (_e442.member.member_2 * _e678)) + _e442.member_1);
let _e696 = ((((_e457.member.member * _e676) + (_e457.member.member_1 * _e677)) + (_e457.member.member_2 * _e678)) + _e457.member_1);
let _e707 = ((((_e684 >= _e555) && (_e684 <= _e557)) && ((_e690 >= _e560) && (_e690 <= _e562))) && ((_e696 >= _e566) && (_e696 <= _e568)));
if _e576 {
phi_1141_ = _e707;
} else {
let _e712 = global_1.member.member_16.member;
let _e724 = -((_e410 / _e403));
let _e729 = global_1.member.member_16.member_1;
let _e735 = global_1.member.member_17.member;
let _e751 = global_1.member.member_17.member_1;
let _e758 = global_1.member.member_18.member;
let _e774 = global_1.member.member_18.member_1;
let _e781 = global_1.member.member_19.member;
let _e797 = global_1.member.member_19.member_1;
phi_1141_ = (_e707 && (((((((((_e712.member.member * _e676) + (_e712.member.member_1 * _e677)) + (_e712.member.member_2 * _e678)) + _e712.member_1) <= _e724) || (_e729 == 0u)) && ((((((_e735.member.member * _e676) + (_e735.member.member_1 * _e677)) + (_e735.member.member_2 * _e678)) + _e735.member_1) <= _e724) || (_e751 == 0u))) && ((((((_e758.member.member * _e676) + (_e758.member.member_1 * _e677)) + (_e758.member.member_2 * _e678)) + _e758.member_1) <= _e724) || (_e774 == 0u))) && ((((((_e781.member.member * _e676) + (_e781.member.member_1 * _e677)) + (_e781.member.member_2 * _e678)) + _e781.member_1) <= _e724) || (_e797 == 0u))));
}
let _e803 = phi_1141_;
phi_1144_ = (_e545 && (_e672 && _e803));
} else {
phi_1144_ = _e545;
}
let _e807 = phi_1144_;
let _e814 = ((((_e427.member.member * _e421) + (_e427.member.member_1 * _e422)) + (_e427.member.member_2 * _e423)) + _e427.member_1);
let _e820 = ((((_e442.member.member * _e421) + (_e442.member.member_1 * _e422)) + (_e442.member.member_2 * _e423)) + _e442.member_1);
let _e826 = ((((_e457.member.member * _e421) + (_e457.member.member_1 * _e422)) + (_e457.member.member_2 * _e423)) + _e457.member_1);
let _e843 = ((((_e814 >= (_e491 + _e410)) && (_e814 <= (_e498 - _e410))) && ((_e820 >= (_e506 + _e410)) && (_e820 <= (_e514 - _e410)))) && ((_e826 >= (_e522 + _e410)) && (_e826 <= (_e530 - _e410))));
let _e846 = global_1.member.member_1;
if ((_e846 & 16u) == 0u) {
phi_1338_ = _e843;
} else {
let _e853 = global_1.member.member_16.member;
let _e865 = -((_e410 / _e403));
let _e870 = global_1.member.member_16.member_1;
let _e876 = global_1.member.member_17.member;
let _e892 = global_1.member.member_17.member_1;
let _e899 = global_1.member.member_18.member;
let _e915 = global_1.member.member_18.member_1;
let _e922 = global_1.member.member_19.member;
let _e938 = global_1.member.member_19.member_1;
phi_1338_ = (_e843 && (((((((((_e853.member.member * _e421) + (_e853.member.member_1 * _e422)) + (_e853.member.member_2 * _e423)) + _e853.member_1) <= _e865) || (_e870 == 0u)) && ((((((_e876.member.member * _e421) + (_e876.member.member_1 * _e422)) + (_e876.member.member_2 * _e423)) + _e876.member_1) <= _e865) || (_e892 == 0u))) && ((((((_e899.member.member * _e421) + (_e899.member.member_1 * _e422)) + (_e899.member.member_2 * _e423)) + _e899.member_1) <= _e865) || (_e915 == 0u))) && ((((((_e922.member.member * _e421) + (_e922.member.member_1 * _e422)) + (_e922.member.member_2 * _e423)) + _e922.member_1) <= _e865) || (_e938 == 0u))));
}
let _e944 = phi_1338_;
let _e955 = global_1.member.member_8.member_6;
let _e957 = select(_e491, _e474, (_e474 > _e491));
let _e959 = select(_e498, _e957, (_e957 < _e498));
let _e961 = select(_e506, _e480, (_e480 > _e506));
let _e963 = select(_e514, _e961, (_e961 < _e514));
let _e965 = select(_e522, _e486, (_e486 > _e522));
let _e967 = select(_e530, _e965, (_e965 < _e530));
let _e973 = bitcast<f32>((bitcast<u32>((_e474 - _e438)) & 2147483647u));
let _e976 = bitcast<f32>((bitcast<u32>((_e480 - _e453)) & 2147483647u));
let _e978 = select(_e976, _e973, (_e973 > _e976));
let _e981 = bitcast<f32>((bitcast<u32>((_e486 - _e468)) & 2147483647u));
let _e990 = bitcast<f32>((bitcast<u32>((_e474 - _e959)) & 2147483647u));
let _e993 = bitcast<f32>((bitcast<u32>((_e480 - _e963)) & 2147483647u));
let _e995 = select(_e993, _e990, (_e990 > _e993));
let _e998 = bitcast<f32>((bitcast<u32>((_e486 - _e967)) & 2147483647u));
let _e1006 = global_1.member.member_8.member_3.member;
let _e1007 = (_e959 + 0.5f);
let _e1008 = (_e1006 - 1f);
let _e1010 = select(0f, _e1007, (_e1007 > 0f));
let _e1012 = select(_e1008, _e1010, (_e1010 < _e1008));
let _e1019 = select(0i, select(select(i32(_e1012), i32(-2147483648), (_e1012 < -2147483600f)), 2147483647i, (_e1012 > 2147483500f)), (_e1012 == _e1012));
let _e1027 = global_1.member.member_8.member_14;
let _e1028 = (_e1027 & 31u);
let _e1035 = global_1.member.member_8.member_3.member_1;
let _e1036 = (_e963 + 0.5f);
let _e1037 = (_e1035 - 1f);
let _e1039 = select(0f, _e1036, (_e1036 > 0f));
let _e1041 = select(_e1037, _e1039, (_e1039 < _e1037));
let _e1048 = select(0i, select(select(i32(_e1041), i32(-2147483648), (_e1041 < -2147483600f)), 2147483647i, (_e1041 > 2147483500f)), (_e1041 == _e1041));
let _e1059 = global_1.member.member_8.member_3.member_2;
let _e1060 = (_e967 + 0.5f);
let _e1061 = (_e1059 - 1f);
let _e1063 = select(0f, _e1060, (_e1060 > 0f));
let _e1065 = select(_e1061, _e1063, (_e1063 < _e1061));
let _e1072 = select(0i, select(select(i32(_e1065), i32(-2147483648), (_e1065 < -2147483600f)), 2147483647i, (_e1065 > 2147483500f)), (_e1065 == _e1065));
let _e1083 = global_1.member.member_8.member_11.member;
let _e1089 = global_1.member.member_8.member_11.member_1;
let _e1094 = global_1.member.member_8.member_12;
let _e1100 = ((bitcast<i32>(_e1094) + ((_e1019 - select(0i, 1i, (_e1012 < f32(_e1019)))) >> bitcast<u32>(_e1028))) + (bitcast<i32>(_e1083) * (((_e1048 - select(0i, 1i, (_e1041 < f32(_e1048)))) >> bitcast<u32>(_e1028)) + (bitcast<i32>(_e1089) * ((_e1072 - select(0i, 1i, (_e1065 < f32(_e1072)))) >> bitcast<u32>(_e1028))))));
let _e1102 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e1104 = select(_e1102, _e1100, (_e1100 < _e1102));
let _e1110 = global_5.member[bitcast<u32>(select(0i, _e1104, (_e1104 > 0i)))];
phi_1674_ = select(select(7u, 3u, ((_e807 && (!(_e554) || _e944)) && (true && ((_e846 & 1024u) == 0u)))), 1u, (((_e846 & 64u) != 0u) || ((((select(_e981, _e978, (_e978 > _e981)) <= _e955) && ((select(_e998, _e995, (_e995 > _e998)) > _e955) || (_e1110 != 0u))) && true) && ((_e846 & 32u) != 0u))));
} else {
phi_1674_ = 7u;
}
let _e1123 = phi_1674_;
if (_e1123 > 1u) {
let _e1128 = bitcast<i32>(((_e197 * _e305) + _e195));
let _e1131 = (bitcast<i32>(_e179) - 1i);
let _e1133 = select(_e1131, _e1128, (_e1128 < _e1131));
let _e1139 = global_6.member[bitcast<u32>(select(0i, _e1133, (_e1133 > 0i)))];
let _e1140 = (bitcast<i32>(_e310) + _e1128);
let _e1142 = select(_e1131, _e1140, (_e1140 < _e1131));
let _e1148 = global_6.member[bitcast<u32>(select(0i, _e1142, (_e1142 > 0i)))];
let _e1150 = f32(bitcast<i32>(_e195));
let _e1152 = f32(bitcast<i32>(_e197));
let _e1158 = global_1.member.member_7.member;
let _e1162 = global_1.member.member_10.member_8;
let _e1163 = (_e1158 - _e1162);
let _e1167 = global_1.member.member_10.member_2;
let _e1171 = global_1.member.member_10.member_6;
let _e1178 = global_1.member.member_10.member_4;
let _e1180 = ((_e1167 + (_e1171 * _e1163)) + (((_e1150 - _e1139) + 0.5f) * _e1178));
let _e1184 = global_1.member.member_10.member_3;
let _e1188 = global_1.member.member_10.member_7;
let _e1193 = ((_e1184 + (_e1188 * _e1163)) + (((_e1152 - _e1148) + 0.5f) * _e1178));
let _e1197 = global_1.member.member_7.member_1;
let _e1198 = (_e1197 - _e1162);
let _e1203 = ((_e1167 + (_e1171 * _e1198)) + ((_e1150 + 0.5f) * _e1178));
let _e1208 = ((_e1184 + (_e1188 * _e1198)) + ((_e1152 + 0.5f) * _e1178));
let _e1212 = global_1.member.member_8.member;
let _e1223 = ((((_e1212.member.member * _e1180) + (_e1212.member.member_1 * _e1193)) + (_e1212.member.member_2 * _e1158)) + _e1212.member_1);
let _e1227 = global_1.member.member_8.member_1;
let _e1238 = ((((_e1227.member.member * _e1180) + (_e1227.member.member_1 * _e1193)) + (_e1227.member.member_2 * _e1158)) + _e1227.member_1);
let _e1242 = global_1.member.member_8.member_2;
let _e1253 = ((((_e1242.member.member * _e1180) + (_e1242.member.member_1 * _e1193)) + (_e1242.member.member_2 * _e1158)) + _e1242.member_1);
let _e1259 = ((((_e1212.member.member * _e1203) + (_e1212.member.member_1 * _e1208)) + (_e1212.member.member_2 * _e1197)) + _e1212.member_1);
let _e1265 = ((((_e1227.member.member * _e1203) + (_e1227.member.member_1 * _e1208)) + (_e1227.member.member_2 * _e1197)) + _e1227.member_1);
let _e1271 = ((((_e1242.member.member * _e1203) + (_e1242.member.member_1 * _e1208)) + (_e1242.member.member_2 * _e1197)) + _e1242.member_1);
let _e1273 = (_e187.member_2 == 5u);
let _e1279 = ((_e187.member_2 == 2u) || (_e187.member_2 == 7u));
let _e1280 = ((((_e187.member_2 == 1u) || _e1273) || (_e187.member_2 == 6u)) || _e1279);
if _e1280 {
let _e1285 = global_1.member.member_8.member_4.member;
let _e1290 = global_1.member.member_8.member_5.member;
let _e1292 = select(_e1285, _e1259, (_e1259 > _e1285));
let _e1294 = select(_e1290, _e1292, (_e1292 < _e1290));
let _e1299 = global_1.member.member_8.member_4.member_1;
let _e1304 = global_1.member.member_8.member_5.member_1;
let _e1306 = select(_e1299, _e1265, (_e1265 > _e1299));
let _e1308 = select(_e1304, _e1306, (_e1306 < _e1304));
let _e1313 = global_1.member.member_8.member_4.member_2;
let _e1318 = global_1.member.member_8.member_5.member_2;
let _e1320 = select(_e1313, _e1271, (_e1271 > _e1313));
let _e1322 = select(_e1318, _e1320, (_e1320 < _e1318));
let _e1327 = global_1.member.member_8.member_15;
if (_e1327 == 0u) {
phi_2047_ = vec3<f32>(_e1294, _e1308, _e1322);
} else {
let _e1329 = (_e1294 + 0.5f);
let _e1334 = global_1.member.member_8.member_3.member;
let _e1335 = (_e1334 - 1f);
let _e1337 = select(0f, _e1329, (_e1329 > 0f));
let _e1339 = select(_e1335, _e1337, (_e1337 < _e1335));
let _e1346 = select(0i, select(select(i32(_e1339), i32(-2147483648), (_e1339 < -2147483600f)), 2147483647i, (_e1339 > 2147483500f)), (_e1339 == _e1339));
let _e1352 = (_e1308 + 0.5f);
let _e1357 = global_1.member.member_8.member_3.member_1;
let _e1358 = (_e1357 - 1f);
let _e1360 = select(0f, _e1352, (_e1352 > 0f));
let _e1362 = select(_e1358, _e1360, (_e1360 < _e1358));
let _e1369 = select(0i, select(select(i32(_e1362), i32(-2147483648), (_e1362 < -2147483600f)), 2147483647i, (_e1362 > 2147483500f)), (_e1362 == _e1362));
let _e1375 = (_e1322 + 0.5f);
let _e1380 = global_1.member.member_8.member_3.member_2;
let _e1381 = (_e1380 - 1f);
let _e1383 = select(0f, _e1375, (_e1375 > 0f));
let _e1385 = select(_e1381, _e1383, (_e1383 < _e1381));
let _e1392 = select(0i, select(select(i32(_e1385), i32(-2147483648), (_e1385 < -2147483600f)), 2147483647i, (_e1385 > 2147483500f)), (_e1385 == _e1385));
phi_2047_ = vec3<f32>(f32((_e1346 - select(0i, 1i, (_e1339 < f32(_e1346))))), f32((_e1369 - select(0i, 1i, (_e1362 < f32(_e1369))))), f32((_e1392 - select(0i, 1i, (_e1385 < f32(_e1392))))));
}
let _e1400 = phi_2047_;
let _e1406 = global_1.member.member_8.member_3.member;
let _e1408 = select(-1f, _e1400.x, (_e1400.x > -1f));
let _e1410 = select(_e1406, _e1408, (_e1408 < _e1406));
let _e1417 = select(0i, select(select(i32(_e1410), i32(-2147483648), (_e1410 < -2147483600f)), 2147483647i, (_e1410 > 2147483500f)), (_e1410 == _e1410));
let _e1421 = (_e1417 - select(0i, 1i, (_e1410 < f32(_e1417))));
let _e1427 = global_1.member.member_8.member_3.member_1;
let _e1429 = select(-1f, _e1400.y, (_e1400.y > -1f));
let _e1431 = select(_e1427, _e1429, (_e1429 < _e1427));
let _e1438 = select(0i, select(select(i32(_e1431), i32(-2147483648), (_e1431 < -2147483600f)), 2147483647i, (_e1431 > 2147483500f)), (_e1431 == _e1431));
let _e1442 = (_e1438 - select(0i, 1i, (_e1431 < f32(_e1438))));
let _e1448 = global_1.member.member_8.member_3.member_2;
let _e1450 = select(-1f, _e1400.z, (_e1400.z > -1f));
let _e1452 = select(_e1448, _e1450, (_e1450 < _e1448));
let _e1459 = select(0i, select(select(i32(_e1452), i32(-2147483648), (_e1452 < -2147483600f)), 2147483647i, (_e1452 > 2147483500f)), (_e1452 == _e1452));
let _e1463 = (_e1459 - select(0i, 1i, (_e1452 < f32(_e1459))));
let _e1467 = global_1.member.member_8.member_9;
let _e1471 = global_1.member.member_8.member_10;
let _e1479 = (select(0i, select(select(i32(_e1427), i32(-2147483648), (_e1427 < -2147483600f)), 2147483647i, (_e1427 > 2147483500f)), (_e1427 == _e1427)) - 1i);
let _e1480 = (_e1442 - 1i);
let _e1485 = (_e1442 + 1i);
let _e1488 = (_e1442 + 2i);
let _e1498 = (select(0i, select(select(i32(_e1448), i32(-2147483648), (_e1448 < -2147483600f)), 2147483647i, (_e1448 > 2147483500f)), (_e1448 == _e1448)) - 1i);
let _e1499 = (_e1463 - 1i);
let _e1504 = (_e1463 + 1i);
let _e1507 = (_e1463 + 2i);
let _e1517 = (select(0i, select(select(i32(_e1406), i32(-2147483648), (_e1406 < -2147483600f)), 2147483647i, (_e1406 > 2147483500f)), (_e1406 == _e1406)) - 1i);
let _e1518 = (_e1421 - 1i);
let _e1523 = (_e1421 + 1i);
let _e1526 = (_e1421 + 2i);
let _e1529 = (select(0i, _e1480, (_e1480 > 0i)) * _e1467);
let _e1530 = (select(0i, _e1442, (_e1442 > 0i)) * _e1467);
let _e1531 = (select(_e1479, _e1485, (_e1485 < _e1479)) * _e1467);
let _e1532 = (select(_e1479, _e1488, (_e1488 < _e1479)) * _e1467);
let _e1533 = (select(0i, _e1499, (_e1499 > 0i)) * _e1471);
let _e1534 = (select(0i, _e1463, (_e1463 > 0i)) * _e1471);
let _e1535 = (select(_e1498, _e1504, (_e1504 < _e1498)) * _e1471);
let _e1536 = (select(_e1498, _e1507, (_e1507 < _e1498)) * _e1471);
local_28 = type_30(array<i32, 4>(select(0i, _e1518, (_e1518 > 0i)), select(0i, _e1421, (_e1421 > 0i)), select(_e1517, _e1523, (_e1523 < _e1517)), select(_e1517, _e1526, (_e1526 < _e1517))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_29 = (_e1400 - vec3<f32>(f32(_e1421), f32(_e1442), f32(_e1463)));
let _e1545 = (_e1534 + _e1530);
let _e1548 = local_28.member[0u];
let _e1549 = (_e1545 + _e1548);
let _e1551 = (bitcast<i32>(_e172) - 1i);
let _e1553 = select(_e1551, _e1549, (_e1549 < _e1551));
let _e1558 = global_2.member[bitcast<u32>(select(0i, _e1553, (_e1553 > 0i)))];
let _e1559 = bitcast<f32>(_e1558);
let _e1562 = local_28.member[1u];
let _e1563 = (_e1545 + _e1562);
let _e1565 = select(_e1551, _e1563, (_e1563 < _e1551));
let _e1570 = global_2.member[bitcast<u32>(select(0i, _e1565, (_e1565 > 0i)))];
let _e1571 = bitcast<f32>(_e1570);
let _e1574 = local_28.member[2u];
let _e1575 = (_e1545 + _e1574);
let _e1577 = select(_e1551, _e1575, (_e1575 < _e1551));
let _e1582 = global_2.member[bitcast<u32>(select(0i, _e1577, (_e1577 > 0i)))];
let _e1583 = bitcast<f32>(_e1582);
let _e1586 = local_28.member[3u];
let _e1587 = (_e1545 + _e1586);
let _e1589 = select(_e1551, _e1587, (_e1587 < _e1551));
let _e1594 = global_2.member[bitcast<u32>(select(0i, _e1589, (_e1589 > 0i)))];
let _e1596 = local_29[0u];
let _e1599 = (_e1559 + ((_e1571 - _e1559) * _e1596));
let _e1600 = local_29[0u];
let _e1603 = (_e1571 + ((_e1583 - _e1571) * _e1600));
let _e1604 = local_29[0u];
let _e1607 = (_e1583 + ((bitcast<f32>(_e1594) - _e1583) * _e1604));
let _e1608 = (_e1534 + _e1531);
let _e1609 = local_28.member[0u];
let _e1610 = (_e1608 + _e1609);
let _e1612 = select(_e1551, _e1610, (_e1610 < _e1551));
let _e1617 = global_2.member[bitcast<u32>(select(0i, _e1612, (_e1612 > 0i)))];
let _e1618 = bitcast<f32>(_e1617);
let _e1619 = local_28.member[1u];
let _e1620 = (_e1608 + _e1619);
let _e1622 = select(_e1551, _e1620, (_e1620 < _e1551));
let _e1627 = global_2.member[bitcast<u32>(select(0i, _e1622, (_e1622 > 0i)))];
let _e1628 = bitcast<f32>(_e1627);
let _e1629 = local_28.member[2u];
let _e1630 = (_e1608 + _e1629);
let _e1632 = select(_e1551, _e1630, (_e1630 < _e1551));
let _e1637 = global_2.member[bitcast<u32>(select(0i, _e1632, (_e1632 > 0i)))];
let _e1638 = bitcast<f32>(_e1637);
let _e1639 = local_28.member[3u];
let _e1640 = (_e1608 + _e1639);
let _e1642 = select(_e1551, _e1640, (_e1640 < _e1551));
let _e1647 = global_2.member[bitcast<u32>(select(0i, _e1642, (_e1642 > 0i)))];
let _e1649 = local_29[0u];
let _e1653 = local_29[0u];
let _e1656 = (_e1628 + ((_e1638 - _e1628) * _e1653));
let _e1657 = local_29[0u];
let _e1661 = (_e1535 + _e1530);
let _e1662 = local_28.member[0u];
let _e1663 = (_e1661 + _e1662);
let _e1665 = select(_e1551, _e1663, (_e1663 < _e1551));
let _e1670 = global_2.member[bitcast<u32>(select(0i, _e1665, (_e1665 > 0i)))];
let _e1671 = bitcast<f32>(_e1670);
let _e1672 = local_28.member[1u];
let _e1673 = (_e1661 + _e1672);
let _e1675 = select(_e1551, _e1673, (_e1673 < _e1551));
let _e1680 = global_2.member[bitcast<u32>(select(0i, _e1675, (_e1675 > 0i)))];
let _e1681 = bitcast<f32>(_e1680);
let _e1682 = local_28.member[2u];
let _e1683 = (_e1661 + _e1682);
let _e1685 = select(_e1551, _e1683, (_e1683 < _e1551));
let _e1690 = global_2.member[bitcast<u32>(select(0i, _e1685, (_e1685 > 0i)))];
let _e1691 = bitcast<f32>(_e1690);
let _e1692 = local_28.member[3u];
let _e1693 = (_e1661 + _e1692);
let _e1695 = select(_e1551, _e1693, (_e1693 < _e1551));
let _e1700 = global_2.member[bitcast<u32>(select(0i, _e1695, (_e1695 > 0i)))];
let _e1702 = local_29[0u];
let _e1705 = (_e1671 + ((_e1681 - _e1671) * _e1702));
let _e1706 = local_29[0u];
let _e1709 = (_e1681 + ((_e1691 - _e1681) * _e1706));
let _e1710 = local_29[0u];
let _e1713 = (_e1691 + ((bitcast<f32>(_e1700) - _e1691) * _e1710));
let _e1714 = (_e1535 + _e1531);
let _e1715 = local_28.member[0u];
let _e1716 = (_e1714 + _e1715);
let _e1718 = select(_e1551, _e1716, (_e1716 < _e1551));
let _e1723 = global_2.member[bitcast<u32>(select(0i, _e1718, (_e1718 > 0i)))];
let _e1724 = bitcast<f32>(_e1723);
let _e1725 = local_28.member[1u];
let _e1726 = (_e1714 + _e1725);
let _e1728 = select(_e1551, _e1726, (_e1726 < _e1551));
let _e1733 = global_2.member[bitcast<u32>(select(0i, _e1728, (_e1728 > 0i)))];
let _e1734 = bitcast<f32>(_e1733);
let _e1735 = local_28.member[2u];
let _e1736 = (_e1714 + _e1735);
let _e1738 = select(_e1551, _e1736, (_e1736 < _e1551));
let _e1743 = global_2.member[bitcast<u32>(select(0i, _e1738, (_e1738 > 0i)))];
let _e1744 = bitcast<f32>(_e1743);
let _e1745 = local_28.member[3u];
let _e1746 = (_e1714 + _e1745);
let _e1748 = select(_e1551, _e1746, (_e1746 < _e1551));
let _e1753 = global_2.member[bitcast<u32>(select(0i, _e1748, (_e1748 > 0i)))];
let _e1755 = local_29[0u];
let _e1759 = local_29[0u];
let _e1762 = (_e1734 + ((_e1744 - _e1734) * _e1759));
let _e1763 = local_29[0u];
let _e1767 = (_e1534 + _e1529);
let _e1768 = local_28.member[1u];
let _e1769 = (_e1767 + _e1768);
let _e1771 = select(_e1551, _e1769, (_e1769 < _e1551));
let _e1776 = global_2.member[bitcast<u32>(select(0i, _e1771, (_e1771 > 0i)))];
let _e1777 = bitcast<f32>(_e1776);
let _e1778 = local_28.member[2u];
let _e1779 = (_e1767 + _e1778);
let _e1781 = select(_e1551, _e1779, (_e1779 < _e1551));
let _e1786 = global_2.member[bitcast<u32>(select(0i, _e1781, (_e1781 > 0i)))];
let _e1788 = local_29[0u];
let _e1791 = (_e1777 + ((bitcast<f32>(_e1786) - _e1777) * _e1788));
let _e1792 = (_e1534 + _e1532);
let _e1793 = local_28.member[1u];
let _e1794 = (_e1792 + _e1793);
let _e1796 = select(_e1551, _e1794, (_e1794 < _e1551));
let _e1801 = global_2.member[bitcast<u32>(select(0i, _e1796, (_e1796 > 0i)))];
let _e1802 = bitcast<f32>(_e1801);
let _e1803 = local_28.member[2u];
let _e1804 = (_e1792 + _e1803);
let _e1806 = select(_e1551, _e1804, (_e1804 < _e1551));
let _e1811 = global_2.member[bitcast<u32>(select(0i, _e1806, (_e1806 > 0i)))];
let _e1813 = local_29[0u];
let _e1817 = (_e1535 + _e1529);
let _e1818 = local_28.member[1u];
let _e1819 = (_e1817 + _e1818);
let _e1821 = select(_e1551, _e1819, (_e1819 < _e1551));
let _e1826 = global_2.member[bitcast<u32>(select(0i, _e1821, (_e1821 > 0i)))];
let _e1827 = bitcast<f32>(_e1826);
let _e1828 = local_28.member[2u];
let _e1829 = (_e1817 + _e1828);
let _e1831 = select(_e1551, _e1829, (_e1829 < _e1551));
let _e1836 = global_2.member[bitcast<u32>(select(0i, _e1831, (_e1831 > 0i)))];
let _e1838 = local_29[0u];
let _e1841 = (_e1827 + ((bitcast<f32>(_e1836) - _e1827) * _e1838));
let _e1842 = (_e1535 + _e1532);
let _e1843 = local_28.member[1u];
let _e1844 = (_e1842 + _e1843);
let _e1846 = select(_e1551, _e1844, (_e1844 < _e1551));
let _e1851 = global_2.member[bitcast<u32>(select(0i, _e1846, (_e1846 > 0i)))];
let _e1852 = bitcast<f32>(_e1851);
let _e1853 = local_28.member[2u];
let _e1854 = (_e1842 + _e1853);
let _e1856 = select(_e1551, _e1854, (_e1854 < _e1551));
let _e1861 = global_2.member[bitcast<u32>(select(0i, _e1856, (_e1856 > 0i)))];
let _e1863 = local_29[0u];
let _e1867 = (_e1533 + _e1530);
let _e1868 = local_28.member[1u];
let _e1869 = (_e1867 + _e1868);
let _e1871 = select(_e1551, _e1869, (_e1869 < _e1551));
let _e1876 = global_2.member[bitcast<u32>(select(0i, _e1871, (_e1871 > 0i)))];
let _e1877 = bitcast<f32>(_e1876);
let _e1878 = local_28.member[2u];
let _e1879 = (_e1867 + _e1878);
let _e1881 = select(_e1551, _e1879, (_e1879 < _e1551));
let _e1886 = global_2.member[bitcast<u32>(select(0i, _e1881, (_e1881 > 0i)))];
let _e1888 = local_29[0u];
let _e1891 = (_e1877 + ((bitcast<f32>(_e1886) - _e1877) * _e1888));
let _e1892 = (_e1536 + _e1530);
let _e1893 = local_28.member[1u];
let _e1894 = (_e1892 + _e1893);
let _e1896 = select(_e1551, _e1894, (_e1894 < _e1551));
let _e1901 = global_2.member[bitcast<u32>(select(0i, _e1896, (_e1896 > 0i)))];
let _e1902 = bitcast<f32>(_e1901);
let _e1903 = local_28.member[2u];
let _e1904 = (_e1892 + _e1903);
let _e1906 = select(_e1551, _e1904, (_e1904 < _e1551));
let _e1911 = global_2.member[bitcast<u32>(select(0i, _e1906, (_e1906 > 0i)))];
let _e1913 = local_29[0u];
let _e1916 = (_e1902 + ((bitcast<f32>(_e1911) - _e1902) * _e1913));
let _e1917 = (_e1533 + _e1531);
let _e1918 = local_28.member[1u];
let _e1919 = (_e1917 + _e1918);
let _e1921 = select(_e1551, _e1919, (_e1919 < _e1551));
let _e1926 = global_2.member[bitcast<u32>(select(0i, _e1921, (_e1921 > 0i)))];
let _e1927 = bitcast<f32>(_e1926);
let _e1928 = local_28.member[2u];
let _e1929 = (_e1917 + _e1928);
let _e1931 = select(_e1551, _e1929, (_e1929 < _e1551));
let _e1936 = global_2.member[bitcast<u32>(select(0i, _e1931, (_e1931 > 0i)))];
let _e1938 = local_29[0u];
let _e1942 = (_e1536 + _e1531);
let _e1943 = local_28.member[1u];
let _e1944 = (_e1942 + _e1943);
let _e1946 = select(_e1551, _e1944, (_e1944 < _e1551));
let _e1951 = global_2.member[bitcast<u32>(select(0i, _e1946, (_e1946 > 0i)))];
let _e1952 = bitcast<f32>(_e1951);
let _e1953 = local_28.member[2u];
let _e1954 = (_e1942 + _e1953);
let _e1956 = select(_e1551, _e1954, (_e1954 < _e1551));
let _e1961 = global_2.member[bitcast<u32>(select(0i, _e1956, (_e1956 > 0i)))];
let _e1963 = local_29[0u];
let _e1968 = local_29[1u];
let _e1971 = (_e1603 + ((_e1656 - _e1603) * _e1968));
let _e1972 = local_29[1u];
let _e1975 = (_e1709 + ((_e1762 - _e1709) * _e1972));
let _e1976 = local_29[1u];
let _e1979 = (_e1599 + (((_e1618 + ((_e1628 - _e1618) * _e1649)) - _e1599) * _e1976));
let _e1980 = local_29[1u];
let _e1985 = local_29[2u];
let _e1989 = local_29[1u];
let _e1992 = (_e1607 + (((_e1638 + ((bitcast<f32>(_e1647) - _e1638) * _e1657)) - _e1607) * _e1989));
let _e1993 = local_29[1u];
let _e1997 = local_29[2u];
let _e2001 = local_29[1u];
let _e2004 = (_e1791 + ((_e1603 - _e1791) * _e2001));
let _e2005 = local_29[1u];
let _e2009 = local_29[2u];
let _e2013 = local_29[1u];
let _e2016 = (_e1656 + (((_e1802 + ((bitcast<f32>(_e1811) - _e1802) * _e1813)) - _e1656) * _e2013));
let _e2017 = local_29[1u];
let _e2021 = local_29[2u];
let _e2025 = local_29[1u];
let _e2028 = (_e1891 + (((_e1927 + ((bitcast<f32>(_e1936) - _e1927) * _e1938)) - _e1891) * _e2025));
let _e2029 = local_29[2u];
let _e2033 = local_29[1u];
let _e2037 = local_29[2u];
let _e2041 = local_29[2u];
let _e2048 = global_1.member.member_8.member_8;
let _e2052 = global_1.member.member_8.member_7;
let _e2054 = (((_e1971 + ((_e1975 - _e1971) * _e2041)) - _e2048) * _e2052);
let _e2055 = -(1e9f);
let _e2057 = select(_e2055, _e2054, (_e2054 > _e2055));
let _e2059 = select(1e9f, _e2057, (_e2057 < 1e9f));
let _e2061 = (((_e1979 + (((_e1705 + (((_e1724 + ((_e1734 - _e1724) * _e1755)) - _e1705) * _e1980)) - _e1979) * _e1985)) - _e2048) * _e2052);
let _e2063 = select(_e2055, _e2061, (_e2061 > _e2055));
let _e2065 = select(1e9f, _e2063, (_e2063 < 1e9f));
let _e2067 = (((_e1992 + (((_e1713 + (((_e1744 + ((bitcast<f32>(_e1753) - _e1744) * _e1763)) - _e1713) * _e1993)) - _e1992) * _e1997)) - _e2048) * _e2052);
let _e2069 = select(_e2055, _e2067, (_e2067 > _e2055));
let _e2071 = select(1e9f, _e2069, (_e2069 < 1e9f));
let _e2073 = (((_e2004 + (((_e1841 + ((_e1709 - _e1841) * _e2005)) - _e2004) * _e2009)) - _e2048) * _e2052);
let _e2075 = select(_e2055, _e2073, (_e2073 > _e2055));
let _e2077 = select(1e9f, _e2075, (_e2075 < 1e9f));
let _e2079 = (((_e2016 + (((_e1762 + (((_e1852 + ((bitcast<f32>(_e1861) - _e1852) * _e1863)) - _e1762) * _e2017)) - _e2016) * _e2021)) - _e2048) * _e2052);
let _e2081 = select(_e2055, _e2079, (_e2079 > _e2055));
let _e2083 = select(1e9f, _e2081, (_e2081 < 1e9f));
let _e2085 = (((_e2028 + ((_e1971 - _e2028) * _e2029)) - _e2048) * _e2052);
let _e2087 = select(_e2055, _e2085, (_e2085 > _e2055));
let _e2089 = select(1e9f, _e2087, (_e2087 < 1e9f));
let _e2091 = (((_e1975 + (((_e1916 + (((_e1952 + ((bitcast<f32>(_e1961) - _e1952) * _e1963)) - _e1916) * _e2033)) - _e1975) * _e2037)) - _e2048) * _e2052);
let _e2093 = select(_e2055, _e2091, (_e2091 > _e2055));
let _e2095 = select(1e9f, _e2093, (_e2093 < 1e9f));
local_26 = _e2059;
let _e2096 = local_26;
local_27 = _e2096;
let _e2097 = local_27;
let _e2099 = (bitcast<i32>(_e177) - 1i);
let _e2101 = select(_e2099, 263197i, (263197i < _e2099));
let _e2106 = global_3.member[bitcast<u32>(select(0i, _e2101, (_e2101 > 0i)))];
let _e2107 = bitcast<f32>(_e2106);
let _e2109 = select(_e2099, 263198i, (263198i < _e2099));
let _e2112 = bitcast<u32>(select(0i, _e2109, (_e2109 > 0i)));
let _e2114 = global_3.member[_e2112];
let _e2115 = bitcast<f32>(_e2114);
let _e2117 = select(_e2099, 263199i, (263199i < _e2099));
let _e2122 = global_3.member[bitcast<u32>(select(0i, _e2117, (_e2117 > 0i)))];
let _e2123 = bitcast<f32>(_e2122);
let _e2125 = ((_e2097 - _e2107) * _e2115);
let _e2127 = select(0f, _e2125, (_e2125 > 0f));
let _e2130 = local_27;
let _e2132 = select(_e2099, 263200i, (263200i < _e2099));
let _e2137 = global_3.member[bitcast<u32>(select(0i, _e2132, (_e2132 > 0i)))];
let _e2138 = bitcast<f32>(_e2137);
let _e2140 = select(_e2099, 263201i, (263201i < _e2099));
let _e2145 = global_3.member[bitcast<u32>(select(0i, _e2140, (_e2140 > 0i)))];
let _e2146 = bitcast<f32>(_e2145);
let _e2148 = select(_e2099, 263202i, (263202i < _e2099));
let _e2153 = global_3.member[bitcast<u32>(select(0i, _e2148, (_e2148 > 0i)))];
let _e2154 = bitcast<f32>(_e2153);
let _e2156 = ((_e2130 - _e2138) * _e2146);
let _e2158 = select(0f, _e2156, (_e2156 > 0f));
let _e2162 = local_27;
let _e2164 = select(_e2099, 263203i, (263203i < _e2099));
let _e2169 = global_3.member[bitcast<u32>(select(0i, _e2164, (_e2164 > 0i)))];
let _e2170 = bitcast<f32>(_e2169);
let _e2172 = select(_e2099, 263204i, (263204i < _e2099));
let _e2177 = global_3.member[bitcast<u32>(select(0i, _e2172, (_e2172 > 0i)))];
let _e2178 = bitcast<f32>(_e2177);
let _e2180 = select(_e2099, 263205i, (263205i < _e2099));
let _e2185 = global_3.member[bitcast<u32>(select(0i, _e2180, (_e2180 > 0i)))];
let _e2186 = bitcast<f32>(_e2185);
let _e2188 = ((_e2162 - _e2170) * _e2178);
let _e2190 = select(0f, _e2188, (_e2188 > 0f));
let _e2193 = local_27;
let _e2195 = select(_e2099, 263206i, (263206i < _e2099));
let _e2200 = global_3.member[bitcast<u32>(select(0i, _e2195, (_e2195 > 0i)))];
let _e2201 = bitcast<f32>(_e2200);
let _e2203 = select(_e2099, 263207i, (263207i < _e2099));
let _e2208 = global_3.member[bitcast<u32>(select(0i, _e2203, (_e2203 > 0i)))];
let _e2209 = bitcast<f32>(_e2208);
let _e2211 = select(_e2099, 263208i, (263208i < _e2099));
let _e2216 = global_3.member[bitcast<u32>(select(0i, _e2211, (_e2211 > 0i)))];
let _e2217 = bitcast<f32>(_e2216);
let _e2219 = ((_e2193 - _e2201) * _e2209);
let _e2221 = select(0f, _e2219, (_e2219 > 0f));
let _e2225 = ((select(_e2123, _e2127, (_e2127 < _e2123)) + select(_e2154, _e2158, (_e2158 < _e2154))) + (select(_e2186, _e2190, (_e2190 < _e2186)) + select(_e2217, _e2221, (_e2221 < _e2217))));
let _e2227 = select(0f, _e2225, (_e2225 > 0f));
let _e2229 = select(1023f, _e2227, (_e2227 < 1023f));
let _e2236 = select(0i, select(select(i32(_e2229), i32(-2147483648), (_e2229 < -2147483600f)), 2147483647i, (_e2229 > 2147483500f)), (_e2229 == _e2229));
let _e2240 = (_e2236 - select(0i, 1i, (_e2229 < f32(_e2236))));
let _e2241 = (262147i + _e2240);
let _e2243 = select(_e2099, _e2241, (_e2241 < _e2099));
let _e2249 = global_3.member[bitcast<u32>(select(0i, _e2243, (_e2243 > 0i)))];
let _e2259 = select(_e2099, 262146i, (262146i < _e2099));
let _e2265 = global_3.member[bitcast<u32>(select(0i, _e2259, (_e2259 > 0i)))];
let _e2266 = bitcast<f32>(_e2265);
let _e2267 = (f32((bitcast<i32>((_e2249 & 4095u)) - 2048i)) * _e2266);
let _e2269 = select(_e2099, 262144i, (262144i < _e2099));
let _e2275 = global_3.member[bitcast<u32>(select(0i, _e2269, (_e2269 > 0i)))];
let _e2276 = bitcast<f32>(_e2275);
let _e2278 = select(_e2099, 262145i, (262145i < _e2099));
let _e2284 = global_3.member[bitcast<u32>(select(0i, _e2278, (_e2278 > 0i)))];
let _e2285 = bitcast<f32>(_e2284);
let _e2291 = ((_e2276 + (f32(bitcast<i32>((_e2249 >> bitcast<u32>(12u)))) * _e2285)) + (_e2267 * (_e2225 - f32(_e2240))));
let _e2294 = global_3.member[_e2112];
let _e2296 = local_26;
let _e2299 = local_26;
let _e2302 = local_26;
let _e2306 = select(_e2099, 263209i, (263209i < _e2099));
let _e2312 = global_3.member[bitcast<u32>(select(0i, _e2306, (_e2306 > 0i)))];
let _e2314 = local_26;
let _e2317 = select(_e2099, 263210i, (263210i < _e2099));
let _e2323 = global_3.member[bitcast<u32>(select(0i, _e2317, (_e2317 > 0i)))];
let _e2325 = local_26;
let _e2329 = (_e2267 * select(0f, select(select(select(bitcast<f32>(_e2294), _e2146, (_e2296 >= _e2138)), _e2178, (_e2299 >= _e2170)), _e2209, (_e2302 >= _e2201)), ((_e2314 >= bitcast<f32>(_e2312)) && (_e2325 <= bitcast<f32>(_e2323)))));
if _e1279 {
let _e2336 = ((0.5f * (_e2071 - _e2065)) * _e2329);
let _e2337 = ((0.5f * (_e2083 - _e2077)) * _e2329);
let _e2338 = ((0.5f * (_e2095 - _e2089)) * _e2329);
phi_7240_ = type_34(_e2291, vec3<f32>(_e2336, _e2337, _e2338), vec3<f32>((_e2336 * _e2291), (_e2337 * _e2291), (_e2338 * _e2291)));
} else {
local_24 = _e2065;
let _e2345 = local_24;
local_25 = _e2345;
let _e2346 = local_25;
let _e2348 = ((_e2346 - _e2107) * _e2115);
let _e2350 = select(0f, _e2348, (_e2348 > 0f));
let _e2353 = local_25;
let _e2355 = ((_e2353 - _e2138) * _e2146);
let _e2357 = select(0f, _e2355, (_e2355 > 0f));
let _e2361 = local_25;
let _e2363 = ((_e2361 - _e2170) * _e2178);
let _e2365 = select(0f, _e2363, (_e2363 > 0f));
let _e2368 = local_25;
let _e2370 = ((_e2368 - _e2201) * _e2209);
let _e2372 = select(0f, _e2370, (_e2370 > 0f));
let _e2376 = ((select(_e2123, _e2350, (_e2350 < _e2123)) + select(_e2154, _e2357, (_e2357 < _e2154))) + (select(_e2186, _e2365, (_e2365 < _e2186)) + select(_e2217, _e2372, (_e2372 < _e2217))));
let _e2378 = select(0f, _e2376, (_e2376 > 0f));
let _e2380 = select(1023f, _e2378, (_e2378 < 1023f));
let _e2387 = select(0i, select(select(i32(_e2380), i32(-2147483648), (_e2380 < -2147483600f)), 2147483647i, (_e2380 > 2147483500f)), (_e2380 == _e2380));
let _e2391 = (_e2387 - select(0i, 1i, (_e2380 < f32(_e2387))));
let _e2392 = (262147i + _e2391);
let _e2394 = select(_e2099, _e2392, (_e2392 < _e2099));
let _e2400 = global_3.member[bitcast<u32>(select(0i, _e2394, (_e2394 > 0i)))];
let _e2415 = ((_e2276 + (f32(bitcast<i32>((_e2400 >> bitcast<u32>(12u)))) * _e2285)) + ((f32((bitcast<i32>((_e2400 & 4095u)) - 2048i)) * _e2266) * (_e2376 - f32(_e2391))));
local_22 = _e2071;
let _e2416 = local_22;
local_23 = _e2416;
let _e2417 = local_23;
let _e2419 = ((_e2417 - _e2107) * _e2115);
let _e2421 = select(0f, _e2419, (_e2419 > 0f));
let _e2424 = local_23;
let _e2426 = ((_e2424 - _e2138) * _e2146);
let _e2428 = select(0f, _e2426, (_e2426 > 0f));
let _e2432 = local_23;
let _e2434 = ((_e2432 - _e2170) * _e2178);
let _e2436 = select(0f, _e2434, (_e2434 > 0f));
let _e2439 = local_23;
let _e2441 = ((_e2439 - _e2201) * _e2209);
let _e2443 = select(0f, _e2441, (_e2441 > 0f));
let _e2447 = ((select(_e2123, _e2421, (_e2421 < _e2123)) + select(_e2154, _e2428, (_e2428 < _e2154))) + (select(_e2186, _e2436, (_e2436 < _e2186)) + select(_e2217, _e2443, (_e2443 < _e2217))));
let _e2449 = select(0f, _e2447, (_e2447 > 0f));
let _e2451 = select(1023f, _e2449, (_e2449 < 1023f));
let _e2458 = select(0i, select(select(i32(_e2451), i32(-2147483648), (_e2451 < -2147483600f)), 2147483647i, (_e2451 > 2147483500f)), (_e2451 == _e2451));
let _e2462 = (_e2458 - select(0i, 1i, (_e2451 < f32(_e2458))));
let _e2463 = (262147i + _e2462);
let _e2465 = select(_e2099, _e2463, (_e2463 < _e2099));
let _e2471 = global_3.member[bitcast<u32>(select(0i, _e2465, (_e2465 > 0i)))];
let _e2486 = ((_e2276 + (f32(bitcast<i32>((_e2471 >> bitcast<u32>(12u)))) * _e2285)) + ((f32((bitcast<i32>((_e2471 & 4095u)) - 2048i)) * _e2266) * (_e2447 - f32(_e2462))));
local_20 = _e2077;
let _e2487 = local_20;
local_21 = _e2487;
let _e2488 = local_21;
let _e2490 = ((_e2488 - _e2107) * _e2115);
let _e2492 = select(0f, _e2490, (_e2490 > 0f));
let _e2495 = local_21;
let _e2497 = ((_e2495 - _e2138) * _e2146);
let _e2499 = select(0f, _e2497, (_e2497 > 0f));
let _e2503 = local_21;
let _e2505 = ((_e2503 - _e2170) * _e2178);
let _e2507 = select(0f, _e2505, (_e2505 > 0f));
let _e2510 = local_21;
let _e2512 = ((_e2510 - _e2201) * _e2209);
let _e2514 = select(0f, _e2512, (_e2512 > 0f));
let _e2518 = ((select(_e2123, _e2492, (_e2492 < _e2123)) + select(_e2154, _e2499, (_e2499 < _e2154))) + (select(_e2186, _e2507, (_e2507 < _e2186)) + select(_e2217, _e2514, (_e2514 < _e2217))));
let _e2520 = select(0f, _e2518, (_e2518 > 0f));
let _e2522 = select(1023f, _e2520, (_e2520 < 1023f));
let _e2529 = select(0i, select(select(i32(_e2522), i32(-2147483648), (_e2522 < -2147483600f)), 2147483647i, (_e2522 > 2147483500f)), (_e2522 == _e2522));
let _e2533 = (_e2529 - select(0i, 1i, (_e2522 < f32(_e2529))));
let _e2534 = (262147i + _e2533);
let _e2536 = select(_e2099, _e2534, (_e2534 < _e2099));
let _e2542 = global_3.member[bitcast<u32>(select(0i, _e2536, (_e2536 > 0i)))];
let _e2557 = ((_e2276 + (f32(bitcast<i32>((_e2542 >> bitcast<u32>(12u)))) * _e2285)) + ((f32((bitcast<i32>((_e2542 & 4095u)) - 2048i)) * _e2266) * (_e2518 - f32(_e2533))));
local_18 = _e2083;
let _e2558 = local_18;
local_19 = _e2558;
let _e2559 = local_19;
let _e2561 = ((_e2559 - _e2107) * _e2115);
let _e2563 = select(0f, _e2561, (_e2561 > 0f));
let _e2566 = local_19;
let _e2568 = ((_e2566 - _e2138) * _e2146);
let _e2570 = select(0f, _e2568, (_e2568 > 0f));
let _e2574 = local_19;
let _e2576 = ((_e2574 - _e2170) * _e2178);
let _e2578 = select(0f, _e2576, (_e2576 > 0f));
let _e2581 = local_19;
let _e2583 = ((_e2581 - _e2201) * _e2209);
let _e2585 = select(0f, _e2583, (_e2583 > 0f));
let _e2589 = ((select(_e2123, _e2563, (_e2563 < _e2123)) + select(_e2154, _e2570, (_e2570 < _e2154))) + (select(_e2186, _e2578, (_e2578 < _e2186)) + select(_e2217, _e2585, (_e2585 < _e2217))));
let _e2591 = select(0f, _e2589, (_e2589 > 0f));
let _e2593 = select(1023f, _e2591, (_e2591 < 1023f));
let _e2600 = select(0i, select(select(i32(_e2593), i32(-2147483648), (_e2593 < -2147483600f)), 2147483647i, (_e2593 > 2147483500f)), (_e2593 == _e2593));
let _e2604 = (_e2600 - select(0i, 1i, (_e2593 < f32(_e2600))));
let _e2605 = (262147i + _e2604);
let _e2607 = select(_e2099, _e2605, (_e2605 < _e2099));
let _e2613 = global_3.member[bitcast<u32>(select(0i, _e2607, (_e2607 > 0i)))];
let _e2628 = ((_e2276 + (f32(bitcast<i32>((_e2613 >> bitcast<u32>(12u)))) * _e2285)) + ((f32((bitcast<i32>((_e2613 & 4095u)) - 2048i)) * _e2266) * (_e2589 - f32(_e2604))));
local_16 = _e2089;
let _e2629 = local_16;
local_17 = _e2629;
let _e2630 = local_17;
let _e2632 = ((_e2630 - _e2107) * _e2115);
let _e2634 = select(0f, _e2632, (_e2632 > 0f));
let _e2637 = local_17;
let _e2639 = ((_e2637 - _e2138) * _e2146);
let _e2641 = select(0f, _e2639, (_e2639 > 0f));
let _e2645 = local_17;
let _e2647 = ((_e2645 - _e2170) * _e2178);
let _e2649 = select(0f, _e2647, (_e2647 > 0f));
let _e2652 = local_17;
let _e2654 = ((_e2652 - _e2201) * _e2209);
let _e2656 = select(0f, _e2654, (_e2654 > 0f));
let _e2660 = ((select(_e2123, _e2634, (_e2634 < _e2123)) + select(_e2154, _e2641, (_e2641 < _e2154))) + (select(_e2186, _e2649, (_e2649 < _e2186)) + select(_e2217, _e2656, (_e2656 < _e2217))));
let _e2662 = select(0f, _e2660, (_e2660 > 0f));
let _e2664 = select(1023f, _e2662, (_e2662 < 1023f));
let _e2671 = select(0i, select(select(i32(_e2664), i32(-2147483648), (_e2664 < -2147483600f)), 2147483647i, (_e2664 > 2147483500f)), (_e2664 == _e2664));
let _e2675 = (_e2671 - select(0i, 1i, (_e2664 < f32(_e2671))));
let _e2676 = (262147i + _e2675);
let _e2678 = select(_e2099, _e2676, (_e2676 < _e2099));
let _e2684 = global_3.member[bitcast<u32>(select(0i, _e2678, (_e2678 > 0i)))];
let _e2699 = ((_e2276 + (f32(bitcast<i32>((_e2684 >> bitcast<u32>(12u)))) * _e2285)) + ((f32((bitcast<i32>((_e2684 & 4095u)) - 2048i)) * _e2266) * (_e2660 - f32(_e2675))));
local_14 = _e2095;
let _e2700 = local_14;
local_15 = _e2700;
let _e2701 = local_15;
let _e2703 = ((_e2701 - _e2107) * _e2115);
let _e2705 = select(0f, _e2703, (_e2703 > 0f));
let _e2708 = local_15;
let _e2710 = ((_e2708 - _e2138) * _e2146);
let _e2712 = select(0f, _e2710, (_e2710 > 0f));
let _e2716 = local_15;
let _e2718 = ((_e2716 - _e2170) * _e2178);
let _e2720 = select(0f, _e2718, (_e2718 > 0f));
let _e2723 = local_15;
let _e2725 = ((_e2723 - _e2201) * _e2209);
let _e2727 = select(0f, _e2725, (_e2725 > 0f));
let _e2731 = ((select(_e2123, _e2705, (_e2705 < _e2123)) + select(_e2154, _e2712, (_e2712 < _e2154))) + (select(_e2186, _e2720, (_e2720 < _e2186)) + select(_e2217, _e2727, (_e2727 < _e2217))));
let _e2733 = select(0f, _e2731, (_e2731 > 0f));
let _e2735 = select(1023f, _e2733, (_e2733 < 1023f));
let _e2742 = select(0i, select(select(i32(_e2735), i32(-2147483648), (_e2735 < -2147483600f)), 2147483647i, (_e2735 > 2147483500f)), (_e2735 == _e2735));
let _e2746 = (_e2742 - select(0i, 1i, (_e2735 < f32(_e2742))));
let _e2747 = (262147i + _e2746);
let _e2749 = select(_e2099, _e2747, (_e2747 < _e2099));
let _e2755 = global_3.member[bitcast<u32>(select(0i, _e2749, (_e2749 > 0i)))];
let _e2770 = ((_e2276 + (f32(bitcast<i32>((_e2755 >> bitcast<u32>(12u)))) * _e2285)) + ((f32((bitcast<i32>((_e2755 & 4095u)) - 2048i)) * _e2266) * (_e2731 - f32(_e2746))));
let _e2771 = (_e2486 - _e2415);
let _e2773 = (_e2628 - _e2557);
let _e2775 = (_e2770 - _e2699);
phi_7240_ = type_34(_e2291, vec3<f32>((0.5f * _e2771), (0.5f * _e2773), (0.5f * _e2775)), vec3<f32>((0.25f * (_e2771 * (_e2486 + _e2415))), (0.25f * (_e2773 * (_e2628 + _e2557))), (0.25f * (_e2775 * (_e2770 + _e2699)))));
}
let _e2790 = phi_7240_;
let _e2805 = select(0f, 1f, ((((((_e1259 >= _e1285) && (_e1259 <= _e1290)) && (_e1265 >= _e1299)) && (_e1265 <= _e1304)) && (_e1271 >= _e1313)) && (_e1271 <= _e1318)));
let _e2807 = (0.5f * (_e2071 - _e2065));
let _e2809 = (0.5f * (_e2083 - _e2077));
let _e2811 = (0.5f * (_e2095 - _e2089));
let _e2817 = global_1.member.member_8.member.member.member;
let _e2823 = global_1.member.member_8.member.member.member_1;
let _e2829 = global_1.member.member_8.member.member.member_2;
let _e2835 = global_1.member.member_8.member_1.member.member;
let _e2841 = global_1.member.member_8.member_1.member.member_1;
let _e2847 = global_1.member.member_8.member_1.member.member_2;
let _e2853 = global_1.member.member_8.member_2.member.member;
let _e2859 = global_1.member.member_8.member_2.member.member_1;
let _e2865 = global_1.member.member_8.member_2.member.member_2;
let _e2870 = (((_e2817 * _e2807) + (_e2835 * _e2809)) + (_e2853 * _e2811));
let _e2875 = (((_e2823 * _e2807) + (_e2841 * _e2809)) + (_e2859 * _e2811));
let _e2880 = (((_e2829 * _e2807) + (_e2847 * _e2809)) + (_e2865 * _e2811));
phi_9378_ = type_35(_e2059, vec3<f32>((_e2870 * _e2805), (_e2875 * _e2805), (_e2880 * _e2805)), vec3<f32>(_e2870, _e2875, _e2880), _e2790.member, vec3<f32>(((((_e2817 * _e2790.member_2.x) + (_e2835 * _e2790.member_2.y)) + (_e2853 * _e2790.member_2.z)) * _e2805), ((((_e2823 * _e2790.member_2.x) + (_e2841 * _e2790.member_2.y)) + (_e2859 * _e2790.member_2.z)) * _e2805), ((((_e2829 * _e2790.member_2.x) + (_e2847 * _e2790.member_2.y)) + (_e2865 * _e2790.member_2.z)) * _e2805)), vec3<f32>(((((_e2817 * _e2790.member_1.x) + (_e2835 * _e2790.member_1.y)) + (_e2853 * _e2790.member_1.z)) * _e2805), ((((_e2823 * _e2790.member_1.x) + (_e2841 * _e2790.member_1.y)) + (_e2859 * _e2790.member_1.z)) * _e2805), ((((_e2829 * _e2790.member_1.x) + (_e2847 * _e2790.member_1.y)) + (_e2865 * _e2790.member_1.z)) * _e2805)));
} else {
if (_e187.member_2 == 8u) {
let _e2936 = global_1.member.member_8.member_4.member;
let _e2941 = global_1.member.member_8.member_5.member;
let _e2943 = select(_e2936, _e1259, (_e1259 > _e2936));
let _e2945 = select(_e2941, _e2943, (_e2943 < _e2941));
let _e2950 = global_1.member.member_8.member_4.member_1;
let _e2955 = global_1.member.member_8.member_5.member_1;
let _e2957 = select(_e2950, _e1265, (_e1265 > _e2950));
let _e2959 = select(_e2955, _e2957, (_e2957 < _e2955));
let _e2964 = global_1.member.member_8.member_4.member_2;
let _e2969 = global_1.member.member_8.member_5.member_2;
let _e2971 = select(_e2964, _e1271, (_e1271 > _e2964));
let _e2973 = select(_e2969, _e2971, (_e2971 < _e2969));
let _e2978 = global_1.member.member_8.member_15;
if (_e2978 == 0u) {
phi_7587_ = vec3<f32>(_e2945, _e2959, _e2973);
} else {
let _e2980 = (_e2945 + 0.5f);
let _e2985 = global_1.member.member_8.member_3.member;
let _e2986 = (_e2985 - 1f);
let _e2988 = select(0f, _e2980, (_e2980 > 0f));
let _e2990 = select(_e2986, _e2988, (_e2988 < _e2986));
let _e2997 = select(0i, select(select(i32(_e2990), i32(-2147483648), (_e2990 < -2147483600f)), 2147483647i, (_e2990 > 2147483500f)), (_e2990 == _e2990));
let _e3003 = (_e2959 + 0.5f);
let _e3008 = global_1.member.member_8.member_3.member_1;
let _e3009 = (_e3008 - 1f);
let _e3011 = select(0f, _e3003, (_e3003 > 0f));
let _e3013 = select(_e3009, _e3011, (_e3011 < _e3009));
let _e3020 = select(0i, select(select(i32(_e3013), i32(-2147483648), (_e3013 < -2147483600f)), 2147483647i, (_e3013 > 2147483500f)), (_e3013 == _e3013));
let _e3026 = (_e2973 + 0.5f);
let _e3031 = global_1.member.member_8.member_3.member_2;
let _e3032 = (_e3031 - 1f);
let _e3034 = select(0f, _e3026, (_e3026 > 0f));
let _e3036 = select(_e3032, _e3034, (_e3034 < _e3032));
let _e3043 = select(0i, select(select(i32(_e3036), i32(-2147483648), (_e3036 < -2147483600f)), 2147483647i, (_e3036 > 2147483500f)), (_e3036 == _e3036));
phi_7587_ = vec3<f32>(f32((_e2997 - select(0i, 1i, (_e2990 < f32(_e2997))))), f32((_e3020 - select(0i, 1i, (_e3013 < f32(_e3020))))), f32((_e3043 - select(0i, 1i, (_e3036 < f32(_e3043))))));
}
let _e3051 = phi_7587_;
let _e3057 = global_1.member.member_8.member_3.member;
let _e3059 = select(-1f, _e3051.x, (_e3051.x > -1f));
let _e3061 = select(_e3057, _e3059, (_e3059 < _e3057));
let _e3068 = select(0i, select(select(i32(_e3061), i32(-2147483648), (_e3061 < -2147483600f)), 2147483647i, (_e3061 > 2147483500f)), (_e3061 == _e3061));
let _e3072 = (_e3068 - select(0i, 1i, (_e3061 < f32(_e3068))));
let _e3078 = global_1.member.member_8.member_3.member_1;
let _e3080 = select(-1f, _e3051.y, (_e3051.y > -1f));
let _e3082 = select(_e3078, _e3080, (_e3080 < _e3078));
let _e3089 = select(0i, select(select(i32(_e3082), i32(-2147483648), (_e3082 < -2147483600f)), 2147483647i, (_e3082 > 2147483500f)), (_e3082 == _e3082));
let _e3093 = (_e3089 - select(0i, 1i, (_e3082 < f32(_e3089))));
let _e3099 = global_1.member.member_8.member_3.member_2;
let _e3101 = select(-1f, _e3051.z, (_e3051.z > -1f));
let _e3103 = select(_e3099, _e3101, (_e3101 < _e3099));
let _e3110 = select(0i, select(select(i32(_e3103), i32(-2147483648), (_e3103 < -2147483600f)), 2147483647i, (_e3103 > 2147483500f)), (_e3103 == _e3103));
let _e3114 = (_e3110 - select(0i, 1i, (_e3103 < f32(_e3110))));
let _e3118 = global_1.member.member_8.member_9;
let _e3122 = global_1.member.member_8.member_10;
let _e3130 = (select(0i, select(select(i32(_e3078), i32(-2147483648), (_e3078 < -2147483600f)), 2147483647i, (_e3078 > 2147483500f)), (_e3078 == _e3078)) - 1i);
let _e3131 = (_e3093 - 1i);
let _e3136 = (_e3093 + 1i);
let _e3139 = (_e3093 + 2i);
let _e3149 = (select(0i, select(select(i32(_e3099), i32(-2147483648), (_e3099 < -2147483600f)), 2147483647i, (_e3099 > 2147483500f)), (_e3099 == _e3099)) - 1i);
let _e3150 = (_e3114 - 1i);
let _e3155 = (_e3114 + 1i);
let _e3158 = (_e3114 + 2i);
let _e3168 = (select(0i, select(select(i32(_e3057), i32(-2147483648), (_e3057 < -2147483600f)), 2147483647i, (_e3057 > 2147483500f)), (_e3057 == _e3057)) - 1i);
let _e3169 = (_e3072 - 1i);
let _e3174 = (_e3072 + 1i);
let _e3177 = (_e3072 + 2i);
let _e3180 = (select(0i, _e3131, (_e3131 > 0i)) * _e3118);
let _e3181 = (select(0i, _e3093, (_e3093 > 0i)) * _e3118);
let _e3182 = (select(_e3130, _e3136, (_e3136 < _e3130)) * _e3118);
let _e3183 = (select(_e3130, _e3139, (_e3139 < _e3130)) * _e3118);
let _e3184 = (select(0i, _e3150, (_e3150 > 0i)) * _e3122);
let _e3185 = (select(0i, _e3114, (_e3114 > 0i)) * _e3122);
let _e3186 = (select(_e3149, _e3155, (_e3155 < _e3149)) * _e3122);
let _e3187 = (select(_e3149, _e3158, (_e3158 < _e3149)) * _e3122);
local_12 = type_30(array<i32, 4>(select(0i, _e3169, (_e3169 > 0i)), select(0i, _e3072, (_e3072 > 0i)), select(_e3168, _e3174, (_e3174 < _e3168)), select(_e3168, _e3177, (_e3177 < _e3168))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_13 = (_e3051 - vec3<f32>(f32(_e3072), f32(_e3093), f32(_e3114)));
let _e3196 = (_e3185 + _e3181);
let _e3199 = local_12.member[0u];
let _e3200 = (_e3196 + _e3199);
let _e3202 = (bitcast<i32>(_e172) - 1i);
let _e3204 = select(_e3202, _e3200, (_e3200 < _e3202));
let _e3209 = global_2.member[bitcast<u32>(select(0i, _e3204, (_e3204 > 0i)))];
let _e3210 = bitcast<f32>(_e3209);
let _e3213 = local_12.member[1u];
let _e3214 = (_e3196 + _e3213);
let _e3216 = select(_e3202, _e3214, (_e3214 < _e3202));
let _e3221 = global_2.member[bitcast<u32>(select(0i, _e3216, (_e3216 > 0i)))];
let _e3222 = bitcast<f32>(_e3221);
let _e3225 = local_12.member[2u];
let _e3226 = (_e3196 + _e3225);
let _e3228 = select(_e3202, _e3226, (_e3226 < _e3202));
let _e3233 = global_2.member[bitcast<u32>(select(0i, _e3228, (_e3228 > 0i)))];
let _e3234 = bitcast<f32>(_e3233);
let _e3237 = local_12.member[3u];
let _e3238 = (_e3196 + _e3237);
let _e3240 = select(_e3202, _e3238, (_e3238 < _e3202));
let _e3245 = global_2.member[bitcast<u32>(select(0i, _e3240, (_e3240 > 0i)))];
let _e3247 = local_13[0u];
let _e3250 = (_e3210 + ((_e3222 - _e3210) * _e3247));
let _e3251 = local_13[0u];
let _e3254 = (_e3222 + ((_e3234 - _e3222) * _e3251));
let _e3255 = local_13[0u];
let _e3258 = (_e3234 + ((bitcast<f32>(_e3245) - _e3234) * _e3255));
let _e3259 = (_e3185 + _e3182);
let _e3260 = local_12.member[0u];
let _e3261 = (_e3259 + _e3260);
let _e3263 = select(_e3202, _e3261, (_e3261 < _e3202));
let _e3268 = global_2.member[bitcast<u32>(select(0i, _e3263, (_e3263 > 0i)))];
let _e3269 = bitcast<f32>(_e3268);
let _e3270 = local_12.member[1u];
let _e3271 = (_e3259 + _e3270);
let _e3273 = select(_e3202, _e3271, (_e3271 < _e3202));
let _e3278 = global_2.member[bitcast<u32>(select(0i, _e3273, (_e3273 > 0i)))];
let _e3279 = bitcast<f32>(_e3278);
let _e3280 = local_12.member[2u];
let _e3281 = (_e3259 + _e3280);
let _e3283 = select(_e3202, _e3281, (_e3281 < _e3202));
let _e3288 = global_2.member[bitcast<u32>(select(0i, _e3283, (_e3283 > 0i)))];
let _e3289 = bitcast<f32>(_e3288);
let _e3290 = local_12.member[3u];
let _e3291 = (_e3259 + _e3290);
let _e3293 = select(_e3202, _e3291, (_e3291 < _e3202));
let _e3298 = global_2.member[bitcast<u32>(select(0i, _e3293, (_e3293 > 0i)))];
let _e3300 = local_13[0u];
let _e3304 = local_13[0u];
let _e3307 = (_e3279 + ((_e3289 - _e3279) * _e3304));
let _e3308 = local_13[0u];
let _e3312 = (_e3186 + _e3181);
let _e3313 = local_12.member[0u];
let _e3314 = (_e3312 + _e3313);
let _e3316 = select(_e3202, _e3314, (_e3314 < _e3202));
let _e3321 = global_2.member[bitcast<u32>(select(0i, _e3316, (_e3316 > 0i)))];
let _e3322 = bitcast<f32>(_e3321);
let _e3323 = local_12.member[1u];
let _e3324 = (_e3312 + _e3323);
let _e3326 = select(_e3202, _e3324, (_e3324 < _e3202));
let _e3331 = global_2.member[bitcast<u32>(select(0i, _e3326, (_e3326 > 0i)))];
let _e3332 = bitcast<f32>(_e3331);
let _e3333 = local_12.member[2u];
let _e3334 = (_e3312 + _e3333);
let _e3336 = select(_e3202, _e3334, (_e3334 < _e3202));
let _e3341 = global_2.member[bitcast<u32>(select(0i, _e3336, (_e3336 > 0i)))];
let _e3342 = bitcast<f32>(_e3341);
let _e3343 = local_12.member[3u];
let _e3344 = (_e3312 + _e3343);
let _e3346 = select(_e3202, _e3344, (_e3344 < _e3202));
let _e3351 = global_2.member[bitcast<u32>(select(0i, _e3346, (_e3346 > 0i)))];
let _e3353 = local_13[0u];
let _e3356 = (_e3322 + ((_e3332 - _e3322) * _e3353));
let _e3357 = local_13[0u];
let _e3360 = (_e3332 + ((_e3342 - _e3332) * _e3357));
let _e3361 = local_13[0u];
let _e3364 = (_e3342 + ((bitcast<f32>(_e3351) - _e3342) * _e3361));
let _e3365 = (_e3186 + _e3182);
let _e3366 = local_12.member[0u];
let _e3367 = (_e3365 + _e3366);
let _e3369 = select(_e3202, _e3367, (_e3367 < _e3202));
let _e3374 = global_2.member[bitcast<u32>(select(0i, _e3369, (_e3369 > 0i)))];
let _e3375 = bitcast<f32>(_e3374);
let _e3376 = local_12.member[1u];
let _e3377 = (_e3365 + _e3376);
let _e3379 = select(_e3202, _e3377, (_e3377 < _e3202));
let _e3384 = global_2.member[bitcast<u32>(select(0i, _e3379, (_e3379 > 0i)))];
let _e3385 = bitcast<f32>(_e3384);
let _e3386 = local_12.member[2u];
let _e3387 = (_e3365 + _e3386);
let _e3389 = select(_e3202, _e3387, (_e3387 < _e3202));
let _e3394 = global_2.member[bitcast<u32>(select(0i, _e3389, (_e3389 > 0i)))];
let _e3395 = bitcast<f32>(_e3394);
let _e3396 = local_12.member[3u];
let _e3397 = (_e3365 + _e3396);
let _e3399 = select(_e3202, _e3397, (_e3397 < _e3202));
let _e3404 = global_2.member[bitcast<u32>(select(0i, _e3399, (_e3399 > 0i)))];
let _e3406 = local_13[0u];
let _e3410 = local_13[0u];
let _e3413 = (_e3385 + ((_e3395 - _e3385) * _e3410));
let _e3414 = local_13[0u];
let _e3418 = (_e3185 + _e3180);
let _e3419 = local_12.member[1u];
let _e3420 = (_e3418 + _e3419);
let _e3422 = select(_e3202, _e3420, (_e3420 < _e3202));
let _e3427 = global_2.member[bitcast<u32>(select(0i, _e3422, (_e3422 > 0i)))];
let _e3428 = bitcast<f32>(_e3427);
let _e3429 = local_12.member[2u];
let _e3430 = (_e3418 + _e3429);
let _e3432 = select(_e3202, _e3430, (_e3430 < _e3202));
let _e3437 = global_2.member[bitcast<u32>(select(0i, _e3432, (_e3432 > 0i)))];
let _e3439 = local_13[0u];
let _e3442 = (_e3428 + ((bitcast<f32>(_e3437) - _e3428) * _e3439));
let _e3443 = (_e3185 + _e3183);
let _e3444 = local_12.member[1u];
let _e3445 = (_e3443 + _e3444);
let _e3447 = select(_e3202, _e3445, (_e3445 < _e3202));
let _e3452 = global_2.member[bitcast<u32>(select(0i, _e3447, (_e3447 > 0i)))];
let _e3453 = bitcast<f32>(_e3452);
let _e3454 = local_12.member[2u];
let _e3455 = (_e3443 + _e3454);
let _e3457 = select(_e3202, _e3455, (_e3455 < _e3202));
let _e3462 = global_2.member[bitcast<u32>(select(0i, _e3457, (_e3457 > 0i)))];
let _e3464 = local_13[0u];
let _e3468 = (_e3186 + _e3180);
let _e3469 = local_12.member[1u];
let _e3470 = (_e3468 + _e3469);
let _e3472 = select(_e3202, _e3470, (_e3470 < _e3202));
let _e3477 = global_2.member[bitcast<u32>(select(0i, _e3472, (_e3472 > 0i)))];
let _e3478 = bitcast<f32>(_e3477);
let _e3479 = local_12.member[2u];
let _e3480 = (_e3468 + _e3479);
let _e3482 = select(_e3202, _e3480, (_e3480 < _e3202));
let _e3487 = global_2.member[bitcast<u32>(select(0i, _e3482, (_e3482 > 0i)))];
let _e3489 = local_13[0u];
let _e3492 = (_e3478 + ((bitcast<f32>(_e3487) - _e3478) * _e3489));
let _e3493 = (_e3186 + _e3183);
let _e3494 = local_12.member[1u];
let _e3495 = (_e3493 + _e3494);
let _e3497 = select(_e3202, _e3495, (_e3495 < _e3202));
let _e3502 = global_2.member[bitcast<u32>(select(0i, _e3497, (_e3497 > 0i)))];
let _e3503 = bitcast<f32>(_e3502);
let _e3504 = local_12.member[2u];
let _e3505 = (_e3493 + _e3504);
let _e3507 = select(_e3202, _e3505, (_e3505 < _e3202));
let _e3512 = global_2.member[bitcast<u32>(select(0i, _e3507, (_e3507 > 0i)))];
let _e3514 = local_13[0u];
let _e3518 = (_e3184 + _e3181);
let _e3519 = local_12.member[1u];
let _e3520 = (_e3518 + _e3519);
let _e3522 = select(_e3202, _e3520, (_e3520 < _e3202));
let _e3527 = global_2.member[bitcast<u32>(select(0i, _e3522, (_e3522 > 0i)))];
let _e3528 = bitcast<f32>(_e3527);
let _e3529 = local_12.member[2u];
let _e3530 = (_e3518 + _e3529);
let _e3532 = select(_e3202, _e3530, (_e3530 < _e3202));
let _e3537 = global_2.member[bitcast<u32>(select(0i, _e3532, (_e3532 > 0i)))];
let _e3539 = local_13[0u];
let _e3542 = (_e3528 + ((bitcast<f32>(_e3537) - _e3528) * _e3539));
let _e3543 = (_e3187 + _e3181);
let _e3544 = local_12.member[1u];
let _e3545 = (_e3543 + _e3544);
let _e3547 = select(_e3202, _e3545, (_e3545 < _e3202));
let _e3552 = global_2.member[bitcast<u32>(select(0i, _e3547, (_e3547 > 0i)))];
let _e3553 = bitcast<f32>(_e3552);
let _e3554 = local_12.member[2u];
let _e3555 = (_e3543 + _e3554);
let _e3557 = select(_e3202, _e3555, (_e3555 < _e3202));
let _e3562 = global_2.member[bitcast<u32>(select(0i, _e3557, (_e3557 > 0i)))];
let _e3564 = local_13[0u];
let _e3567 = (_e3553 + ((bitcast<f32>(_e3562) - _e3553) * _e3564));
let _e3568 = (_e3184 + _e3182);
let _e3569 = local_12.member[1u];
let _e3570 = (_e3568 + _e3569);
let _e3572 = select(_e3202, _e3570, (_e3570 < _e3202));
let _e3577 = global_2.member[bitcast<u32>(select(0i, _e3572, (_e3572 > 0i)))];
let _e3578 = bitcast<f32>(_e3577);
let _e3579 = local_12.member[2u];
let _e3580 = (_e3568 + _e3579);
let _e3582 = select(_e3202, _e3580, (_e3580 < _e3202));
let _e3587 = global_2.member[bitcast<u32>(select(0i, _e3582, (_e3582 > 0i)))];
let _e3589 = local_13[0u];
let _e3593 = (_e3187 + _e3182);
let _e3594 = local_12.member[1u];
let _e3595 = (_e3593 + _e3594);
let _e3597 = select(_e3202, _e3595, (_e3595 < _e3202));
let _e3602 = global_2.member[bitcast<u32>(select(0i, _e3597, (_e3597 > 0i)))];
let _e3603 = bitcast<f32>(_e3602);
let _e3604 = local_12.member[2u];
let _e3605 = (_e3593 + _e3604);
let _e3607 = select(_e3202, _e3605, (_e3605 < _e3202));
let _e3612 = global_2.member[bitcast<u32>(select(0i, _e3607, (_e3607 > 0i)))];
let _e3614 = local_13[0u];
let _e3619 = local_13[1u];
let _e3622 = (_e3254 + ((_e3307 - _e3254) * _e3619));
let _e3623 = local_13[1u];
let _e3626 = (_e3360 + ((_e3413 - _e3360) * _e3623));
let _e3627 = local_13[1u];
let _e3630 = (_e3250 + (((_e3269 + ((_e3279 - _e3269) * _e3300)) - _e3250) * _e3627));
let _e3631 = local_13[1u];
let _e3636 = local_13[2u];
let _e3640 = local_13[1u];
let _e3643 = (_e3258 + (((_e3289 + ((bitcast<f32>(_e3298) - _e3289) * _e3308)) - _e3258) * _e3640));
let _e3644 = local_13[1u];
let _e3648 = local_13[2u];
let _e3652 = local_13[1u];
let _e3655 = (_e3442 + ((_e3254 - _e3442) * _e3652));
let _e3656 = local_13[1u];
let _e3660 = local_13[2u];
let _e3664 = local_13[1u];
let _e3667 = (_e3307 + (((_e3453 + ((bitcast<f32>(_e3462) - _e3453) * _e3464)) - _e3307) * _e3664));
let _e3668 = local_13[1u];
let _e3672 = local_13[2u];
let _e3676 = local_13[1u];
let _e3679 = (_e3542 + (((_e3578 + ((bitcast<f32>(_e3587) - _e3578) * _e3589)) - _e3542) * _e3676));
let _e3680 = local_13[2u];
let _e3684 = local_13[1u];
let _e3688 = local_13[2u];
let _e3692 = local_13[2u];
let _e3699 = global_1.member.member_8.member_8;
let _e3703 = global_1.member.member_8.member_7;
let _e3705 = (((_e3622 + ((_e3626 - _e3622) * _e3692)) - _e3699) * _e3703);
let _e3706 = -(1e9f);
let _e3708 = select(_e3706, _e3705, (_e3705 > _e3706));
let _e3712 = (((_e3630 + (((_e3356 + (((_e3375 + ((_e3385 - _e3375) * _e3406)) - _e3356) * _e3631)) - _e3630) * _e3636)) - _e3699) * _e3703);
let _e3714 = select(_e3706, _e3712, (_e3712 > _e3706));
let _e3718 = (((_e3643 + (((_e3364 + (((_e3395 + ((bitcast<f32>(_e3404) - _e3395) * _e3414)) - _e3364) * _e3644)) - _e3643) * _e3648)) - _e3699) * _e3703);
let _e3720 = select(_e3706, _e3718, (_e3718 > _e3706));
let _e3724 = (((_e3655 + (((_e3492 + ((_e3360 - _e3492) * _e3656)) - _e3655) * _e3660)) - _e3699) * _e3703);
let _e3726 = select(_e3706, _e3724, (_e3724 > _e3706));
let _e3730 = (((_e3667 + (((_e3413 + (((_e3503 + ((bitcast<f32>(_e3512) - _e3503) * _e3514)) - _e3413) * _e3668)) - _e3667) * _e3672)) - _e3699) * _e3703);
let _e3732 = select(_e3706, _e3730, (_e3730 > _e3706));
let _e3736 = (((_e3679 + ((_e3622 - _e3679) * _e3680)) - _e3699) * _e3703);
let _e3738 = select(_e3706, _e3736, (_e3736 > _e3706));
let _e3742 = (((_e3626 + (((_e3567 + (((_e3603 + ((bitcast<f32>(_e3612) - _e3603) * _e3614)) - _e3567) * _e3684)) - _e3626) * _e3688)) - _e3699) * _e3703);
let _e3744 = select(_e3706, _e3742, (_e3742 > _e3706));
let _e3748 = (0.5f * (select(1e9f, _e3720, (_e3720 < 1e9f)) - select(1e9f, _e3714, (_e3714 < 1e9f))));
let _e3750 = (0.5f * (select(1e9f, _e3732, (_e3732 < 1e9f)) - select(1e9f, _e3726, (_e3726 < 1e9f))));
let _e3752 = (0.5f * (select(1e9f, _e3744, (_e3744 < 1e9f)) - select(1e9f, _e3738, (_e3738 < 1e9f))));
let _e3758 = global_1.member.member_8.member.member.member;
let _e3764 = global_1.member.member_8.member.member.member_1;
let _e3770 = global_1.member.member_8.member.member.member_2;
let _e3776 = global_1.member.member_8.member_1.member.member;
let _e3782 = global_1.member.member_8.member_1.member.member_1;
let _e3788 = global_1.member.member_8.member_1.member.member_2;
let _e3794 = global_1.member.member_8.member_2.member.member;
let _e3800 = global_1.member.member_8.member_2.member.member_1;
let _e3806 = global_1.member.member_8.member_2.member.member_2;
phi_9375_ = select(1e9f, _e3708, (_e3708 < 1e9f));
phi_9376_ = vec3<f32>((((_e3758 * _e3748) + (_e3776 * _e3750)) + (_e3794 * _e3752)), (((_e3764 * _e3748) + (_e3782 * _e3750)) + (_e3800 * _e3752)), (((_e3770 * _e3748) + (_e3788 * _e3750)) + (_e3806 * _e3752)));
} else {
let _e3827 = global_1.member.member_8.member_4.member;
let _e3832 = global_1.member.member_8.member_5.member;
let _e3834 = select(_e3827, _e1259, (_e1259 > _e3827));
let _e3836 = select(_e3832, _e3834, (_e3834 < _e3832));
let _e3841 = global_1.member.member_8.member_4.member_1;
let _e3846 = global_1.member.member_8.member_5.member_1;
let _e3848 = select(_e3841, _e1265, (_e1265 > _e3841));
let _e3850 = select(_e3846, _e3848, (_e3848 < _e3846));
let _e3855 = global_1.member.member_8.member_4.member_2;
let _e3860 = global_1.member.member_8.member_5.member_2;
let _e3862 = select(_e3855, _e1271, (_e1271 > _e3855));
let _e3864 = select(_e3860, _e3862, (_e3862 < _e3860));
let _e3869 = global_1.member.member_8.member_15;
if (_e3869 == 0u) {
phi_8962_ = vec3<f32>(_e3836, _e3850, _e3864);
} else {
let _e3871 = (_e3836 + 0.5f);
let _e3876 = global_1.member.member_8.member_3.member;
let _e3877 = (_e3876 - 1f);
let _e3879 = select(0f, _e3871, (_e3871 > 0f));
let _e3881 = select(_e3877, _e3879, (_e3879 < _e3877));
let _e3888 = select(0i, select(select(i32(_e3881), i32(-2147483648), (_e3881 < -2147483600f)), 2147483647i, (_e3881 > 2147483500f)), (_e3881 == _e3881));
let _e3894 = (_e3850 + 0.5f);
let _e3899 = global_1.member.member_8.member_3.member_1;
let _e3900 = (_e3899 - 1f);
let _e3902 = select(0f, _e3894, (_e3894 > 0f));
let _e3904 = select(_e3900, _e3902, (_e3902 < _e3900));
let _e3911 = select(0i, select(select(i32(_e3904), i32(-2147483648), (_e3904 < -2147483600f)), 2147483647i, (_e3904 > 2147483500f)), (_e3904 == _e3904));
let _e3917 = (_e3864 + 0.5f);
let _e3922 = global_1.member.member_8.member_3.member_2;
let _e3923 = (_e3922 - 1f);
let _e3925 = select(0f, _e3917, (_e3917 > 0f));
let _e3927 = select(_e3923, _e3925, (_e3925 < _e3923));
let _e3934 = select(0i, select(select(i32(_e3927), i32(-2147483648), (_e3927 < -2147483600f)), 2147483647i, (_e3927 > 2147483500f)), (_e3927 == _e3927));
phi_8962_ = vec3<f32>(f32((_e3888 - select(0i, 1i, (_e3881 < f32(_e3888))))), f32((_e3911 - select(0i, 1i, (_e3904 < f32(_e3911))))), f32((_e3934 - select(0i, 1i, (_e3927 < f32(_e3934))))));
}
let _e3942 = phi_8962_;
let _e3948 = global_1.member.member_8.member_3.member;
let _e3950 = select(-1f, _e3942.x, (_e3942.x > -1f));
let _e3952 = select(_e3948, _e3950, (_e3950 < _e3948));
let _e3959 = select(0i, select(select(i32(_e3952), i32(-2147483648), (_e3952 < -2147483600f)), 2147483647i, (_e3952 > 2147483500f)), (_e3952 == _e3952));
let _e3963 = (_e3959 - select(0i, 1i, (_e3952 < f32(_e3959))));
let _e3969 = global_1.member.member_8.member_3.member_1;
let _e3971 = select(-1f, _e3942.y, (_e3942.y > -1f));
let _e3973 = select(_e3969, _e3971, (_e3971 < _e3969));
let _e3980 = select(0i, select(select(i32(_e3973), i32(-2147483648), (_e3973 < -2147483600f)), 2147483647i, (_e3973 > 2147483500f)), (_e3973 == _e3973));
let _e3984 = (_e3980 - select(0i, 1i, (_e3973 < f32(_e3980))));
let _e3990 = global_1.member.member_8.member_3.member_2;
let _e3992 = select(-1f, _e3942.z, (_e3942.z > -1f));
let _e3994 = select(_e3990, _e3992, (_e3992 < _e3990));
let _e4001 = select(0i, select(select(i32(_e3994), i32(-2147483648), (_e3994 < -2147483600f)), 2147483647i, (_e3994 > 2147483500f)), (_e3994 == _e3994));
let _e4005 = (_e4001 - select(0i, 1i, (_e3994 < f32(_e4001))));
let _e4009 = global_1.member.member_8.member_9;
let _e4013 = global_1.member.member_8.member_10;
let _e4021 = (select(0i, select(select(i32(_e3969), i32(-2147483648), (_e3969 < -2147483600f)), 2147483647i, (_e3969 > 2147483500f)), (_e3969 == _e3969)) - 1i);
let _e4024 = (_e3984 + 1i);
let _e4034 = (select(0i, select(select(i32(_e3990), i32(-2147483648), (_e3990 < -2147483600f)), 2147483647i, (_e3990 > 2147483500f)), (_e3990 == _e3990)) - 1i);
let _e4037 = (_e4005 + 1i);
let _e4047 = (select(0i, select(select(i32(_e3948), i32(-2147483648), (_e3948 < -2147483600f)), 2147483647i, (_e3948 > 2147483500f)), (_e3948 == _e3948)) - 1i);
let _e4048 = (_e3963 - 1i);
let _e4053 = (_e3963 + 1i);
let _e4056 = (_e3963 + 2i);
let _e4059 = (select(0i, _e3984, (_e3984 > 0i)) * _e4009);
let _e4060 = (select(_e4021, _e4024, (_e4024 < _e4021)) * _e4009);
let _e4061 = (select(0i, _e4005, (_e4005 > 0i)) * _e4013);
let _e4062 = (select(_e4034, _e4037, (_e4037 < _e4034)) * _e4013);
local_10 = type_30(array<i32, 4>(select(0i, _e4048, (_e4048 > 0i)), select(0i, _e3963, (_e3963 > 0i)), select(_e4047, _e4053, (_e4053 < _e4047)), select(_e4047, _e4056, (_e4056 < _e4047))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_11 = (_e3942 - vec3<f32>(f32(_e3963), f32(_e3984), f32(_e4005)));
let _e4071 = (_e4061 + _e4059);
let _e4074 = local_10.member[1u];
let _e4075 = (_e4071 + _e4074);
let _e4077 = (bitcast<i32>(_e172) - 1i);
let _e4079 = select(_e4077, _e4075, (_e4075 < _e4077));
let _e4084 = global_2.member[bitcast<u32>(select(0i, _e4079, (_e4079 > 0i)))];
let _e4085 = bitcast<f32>(_e4084);
let _e4088 = local_10.member[2u];
let _e4089 = (_e4071 + _e4088);
let _e4091 = select(_e4077, _e4089, (_e4089 < _e4077));
let _e4096 = global_2.member[bitcast<u32>(select(0i, _e4091, (_e4091 > 0i)))];
let _e4098 = local_11[0u];
let _e4101 = (_e4085 + ((bitcast<f32>(_e4096) - _e4085) * _e4098));
let _e4102 = (_e4061 + _e4060);
let _e4103 = local_10.member[1u];
let _e4104 = (_e4102 + _e4103);
let _e4106 = select(_e4077, _e4104, (_e4104 < _e4077));
let _e4111 = global_2.member[bitcast<u32>(select(0i, _e4106, (_e4106 > 0i)))];
let _e4112 = bitcast<f32>(_e4111);
let _e4113 = local_10.member[2u];
let _e4114 = (_e4102 + _e4113);
let _e4116 = select(_e4077, _e4114, (_e4114 < _e4077));
let _e4121 = global_2.member[bitcast<u32>(select(0i, _e4116, (_e4116 > 0i)))];
let _e4123 = local_11[0u];
let _e4128 = local_11[1u];
let _e4131 = (_e4101 + (((_e4112 + ((bitcast<f32>(_e4121) - _e4112) * _e4123)) - _e4101) * _e4128));
let _e4132 = (_e4062 + _e4059);
let _e4133 = local_10.member[1u];
let _e4134 = (_e4132 + _e4133);
let _e4136 = select(_e4077, _e4134, (_e4134 < _e4077));
let _e4141 = global_2.member[bitcast<u32>(select(0i, _e4136, (_e4136 > 0i)))];
let _e4142 = bitcast<f32>(_e4141);
let _e4143 = local_10.member[2u];
let _e4144 = (_e4132 + _e4143);
let _e4146 = select(_e4077, _e4144, (_e4144 < _e4077));
let _e4151 = global_2.member[bitcast<u32>(select(0i, _e4146, (_e4146 > 0i)))];
let _e4153 = local_11[0u];
let _e4156 = (_e4142 + ((bitcast<f32>(_e4151) - _e4142) * _e4153));
let _e4157 = (_e4062 + _e4060);
let _e4158 = local_10.member[1u];
let _e4159 = (_e4157 + _e4158);
let _e4161 = select(_e4077, _e4159, (_e4159 < _e4077));
let _e4166 = global_2.member[bitcast<u32>(select(0i, _e4161, (_e4161 > 0i)))];
let _e4167 = bitcast<f32>(_e4166);
let _e4168 = local_10.member[2u];
let _e4169 = (_e4157 + _e4168);
let _e4171 = select(_e4077, _e4169, (_e4169 < _e4077));
let _e4176 = global_2.member[bitcast<u32>(select(0i, _e4171, (_e4171 > 0i)))];
let _e4178 = local_11[0u];
let _e4182 = local_11[1u];
let _e4187 = local_11[2u];
let _e4194 = global_1.member.member_8.member_8;
let _e4198 = global_1.member.member_8.member_7;
let _e4200 = (((_e4131 + (((_e4156 + (((_e4167 + ((bitcast<f32>(_e4176) - _e4167) * _e4178)) - _e4156) * _e4182)) - _e4131) * _e4187)) - _e4194) * _e4198);
let _e4201 = -(1e9f);
let _e4203 = select(_e4201, _e4200, (_e4200 > _e4201));
phi_9375_ = select(1e9f, _e4203, (_e4203 < 1e9f));
phi_9376_ = vec3<f32>(0f, 0f, 0f);
}
let _e4207 = phi_9375_;
let _e4209 = phi_9376_;
phi_9378_ = type_35(_e4207, vec3<f32>(0f, 0f, 0f), _e4209, 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e4212 = phi_9378_;
let _e4217 = global_1.member.member_8.member_4.member;
let _e4222 = global_1.member.member_8.member_5.member;
let _e4224 = select(_e4217, _e1223, (_e1223 > _e4217));
let _e4226 = select(_e4222, _e4224, (_e4224 < _e4222));
let _e4231 = global_1.member.member_8.member_4.member_1;
let _e4236 = global_1.member.member_8.member_5.member_1;
let _e4238 = select(_e4231, _e1238, (_e1238 > _e4231));
let _e4240 = select(_e4236, _e4238, (_e4238 < _e4236));
let _e4245 = global_1.member.member_8.member_4.member_2;
let _e4250 = global_1.member.member_8.member_5.member_2;
let _e4252 = select(_e4245, _e1253, (_e1253 > _e4245));
let _e4254 = select(_e4250, _e4252, (_e4252 < _e4250));
let _e4259 = global_1.member.member_8.member_15;
let _e4260 = (_e4259 == 0u);
if _e4260 {
phi_9524_ = vec3<f32>(_e4226, _e4240, _e4254);
} else {
let _e4261 = (_e4226 + 0.5f);
let _e4266 = global_1.member.member_8.member_3.member;
let _e4267 = (_e4266 - 1f);
let _e4269 = select(0f, _e4261, (_e4261 > 0f));
let _e4271 = select(_e4267, _e4269, (_e4269 < _e4267));
let _e4278 = select(0i, select(select(i32(_e4271), i32(-2147483648), (_e4271 < -2147483600f)), 2147483647i, (_e4271 > 2147483500f)), (_e4271 == _e4271));
let _e4284 = (_e4240 + 0.5f);
let _e4289 = global_1.member.member_8.member_3.member_1;
let _e4290 = (_e4289 - 1f);
let _e4292 = select(0f, _e4284, (_e4284 > 0f));
let _e4294 = select(_e4290, _e4292, (_e4292 < _e4290));
let _e4301 = select(0i, select(select(i32(_e4294), i32(-2147483648), (_e4294 < -2147483600f)), 2147483647i, (_e4294 > 2147483500f)), (_e4294 == _e4294));
let _e4307 = (_e4254 + 0.5f);
let _e4312 = global_1.member.member_8.member_3.member_2;
let _e4313 = (_e4312 - 1f);
let _e4315 = select(0f, _e4307, (_e4307 > 0f));
let _e4317 = select(_e4313, _e4315, (_e4315 < _e4313));
let _e4324 = select(0i, select(select(i32(_e4317), i32(-2147483648), (_e4317 < -2147483600f)), 2147483647i, (_e4317 > 2147483500f)), (_e4317 == _e4317));
phi_9524_ = vec3<f32>(f32((_e4278 - select(0i, 1i, (_e4271 < f32(_e4278))))), f32((_e4301 - select(0i, 1i, (_e4294 < f32(_e4301))))), f32((_e4324 - select(0i, 1i, (_e4317 < f32(_e4324))))));
}
let _e4332 = phi_9524_;
let _e4338 = global_1.member.member_8.member_3.member;
let _e4340 = select(-1f, _e4332.x, (_e4332.x > -1f));
let _e4342 = select(_e4338, _e4340, (_e4340 < _e4338));
let _e4349 = select(0i, select(select(i32(_e4342), i32(-2147483648), (_e4342 < -2147483600f)), 2147483647i, (_e4342 > 2147483500f)), (_e4342 == _e4342));
let _e4353 = (_e4349 - select(0i, 1i, (_e4342 < f32(_e4349))));
let _e4359 = global_1.member.member_8.member_3.member_1;
let _e4361 = select(-1f, _e4332.y, (_e4332.y > -1f));
let _e4363 = select(_e4359, _e4361, (_e4361 < _e4359));
let _e4370 = select(0i, select(select(i32(_e4363), i32(-2147483648), (_e4363 < -2147483600f)), 2147483647i, (_e4363 > 2147483500f)), (_e4363 == _e4363));
let _e4374 = (_e4370 - select(0i, 1i, (_e4363 < f32(_e4370))));
let _e4380 = global_1.member.member_8.member_3.member_2;
let _e4382 = select(-1f, _e4332.z, (_e4332.z > -1f));
let _e4384 = select(_e4380, _e4382, (_e4382 < _e4380));
let _e4391 = select(0i, select(select(i32(_e4384), i32(-2147483648), (_e4384 < -2147483600f)), 2147483647i, (_e4384 > 2147483500f)), (_e4384 == _e4384));
let _e4395 = (_e4391 - select(0i, 1i, (_e4384 < f32(_e4391))));
let _e4399 = global_1.member.member_8.member_9;
let _e4403 = global_1.member.member_8.member_10;
let _e4411 = (select(0i, select(select(i32(_e4359), i32(-2147483648), (_e4359 < -2147483600f)), 2147483647i, (_e4359 > 2147483500f)), (_e4359 == _e4359)) - 1i);
let _e4414 = (_e4374 + 1i);
let _e4424 = (select(0i, select(select(i32(_e4380), i32(-2147483648), (_e4380 < -2147483600f)), 2147483647i, (_e4380 > 2147483500f)), (_e4380 == _e4380)) - 1i);
let _e4427 = (_e4395 + 1i);
let _e4437 = (select(0i, select(select(i32(_e4338), i32(-2147483648), (_e4338 < -2147483600f)), 2147483647i, (_e4338 > 2147483500f)), (_e4338 == _e4338)) - 1i);
let _e4438 = (_e4353 - 1i);
let _e4443 = (_e4353 + 1i);
let _e4446 = (_e4353 + 2i);
let _e4449 = (select(0i, _e4374, (_e4374 > 0i)) * _e4399);
let _e4450 = (select(_e4411, _e4414, (_e4414 < _e4411)) * _e4399);
let _e4451 = (select(0i, _e4395, (_e4395 > 0i)) * _e4403);
let _e4452 = (select(_e4424, _e4427, (_e4427 < _e4424)) * _e4403);
local_8 = type_30(array<i32, 4>(select(0i, _e4438, (_e4438 > 0i)), select(0i, _e4353, (_e4353 > 0i)), select(_e4437, _e4443, (_e4443 < _e4437)), select(_e4437, _e4446, (_e4446 < _e4437))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_9 = (_e4332 - vec3<f32>(f32(_e4353), f32(_e4374), f32(_e4395)));
let _e4461 = (_e4451 + _e4449);
let _e4464 = local_8.member[1u];
let _e4465 = (_e4461 + _e4464);
let _e4467 = (bitcast<i32>(_e172) - 1i);
let _e4469 = select(_e4467, _e4465, (_e4465 < _e4467));
let _e4474 = global_2.member[bitcast<u32>(select(0i, _e4469, (_e4469 > 0i)))];
let _e4475 = bitcast<f32>(_e4474);
let _e4478 = local_8.member[2u];
let _e4479 = (_e4461 + _e4478);
let _e4481 = select(_e4467, _e4479, (_e4479 < _e4467));
let _e4486 = global_2.member[bitcast<u32>(select(0i, _e4481, (_e4481 > 0i)))];
let _e4488 = local_9[0u];
let _e4491 = (_e4475 + ((bitcast<f32>(_e4486) - _e4475) * _e4488));
let _e4492 = (_e4451 + _e4450);
let _e4493 = local_8.member[1u];
let _e4494 = (_e4492 + _e4493);
let _e4496 = select(_e4467, _e4494, (_e4494 < _e4467));
let _e4501 = global_2.member[bitcast<u32>(select(0i, _e4496, (_e4496 > 0i)))];
let _e4502 = bitcast<f32>(_e4501);
let _e4503 = local_8.member[2u];
let _e4504 = (_e4492 + _e4503);
let _e4506 = select(_e4467, _e4504, (_e4504 < _e4467));
let _e4511 = global_2.member[bitcast<u32>(select(0i, _e4506, (_e4506 > 0i)))];
let _e4513 = local_9[0u];
let _e4518 = local_9[1u];
let _e4521 = (_e4491 + (((_e4502 + ((bitcast<f32>(_e4511) - _e4502) * _e4513)) - _e4491) * _e4518));
let _e4522 = (_e4452 + _e4449);
let _e4523 = local_8.member[1u];
let _e4524 = (_e4522 + _e4523);
let _e4526 = select(_e4467, _e4524, (_e4524 < _e4467));
let _e4531 = global_2.member[bitcast<u32>(select(0i, _e4526, (_e4526 > 0i)))];
let _e4532 = bitcast<f32>(_e4531);
let _e4533 = local_8.member[2u];
let _e4534 = (_e4522 + _e4533);
let _e4536 = select(_e4467, _e4534, (_e4534 < _e4467));
let _e4541 = global_2.member[bitcast<u32>(select(0i, _e4536, (_e4536 > 0i)))];
let _e4543 = local_9[0u];
let _e4546 = (_e4532 + ((bitcast<f32>(_e4541) - _e4532) * _e4543));
let _e4547 = (_e4452 + _e4450);
let _e4548 = local_8.member[1u];
let _e4549 = (_e4547 + _e4548);
let _e4551 = select(_e4467, _e4549, (_e4549 < _e4467));
let _e4556 = global_2.member[bitcast<u32>(select(0i, _e4551, (_e4551 > 0i)))];
let _e4557 = bitcast<f32>(_e4556);
let _e4558 = local_8.member[2u];
let _e4559 = (_e4547 + _e4558);
let _e4561 = select(_e4467, _e4559, (_e4559 < _e4467));
let _e4566 = global_2.member[bitcast<u32>(select(0i, _e4561, (_e4561 > 0i)))];
let _e4568 = local_9[0u];
let _e4572 = local_9[1u];
let _e4577 = local_9[2u];
let _e4584 = global_1.member.member_8.member_8;
let _e4588 = global_1.member.member_8.member_7;
let _e4590 = (((_e4521 + (((_e4546 + (((_e4557 + ((bitcast<f32>(_e4566) - _e4557) * _e4568)) - _e4546) * _e4572)) - _e4521) * _e4577)) - _e4584) * _e4588);
let _e4591 = -(1e9f);
let _e4593 = select(_e4591, _e4590, (_e4590 > _e4591));
let _e4598 = select(select(1e9f, _e4593, (_e4593 < 1e9f)), _e4212.member, (_e4259 != 0u));
let _e4601 = global_1.member.member_1;
let _e4603 = ((_e4601 & 16u) == 0u);
if _e4603 {
phi_10457_ = type_36(type_33(0f, 1f), type_33(0f, 1f), 1f);
} else {
let _e4607 = global_1.member.member_16.member;
let _e4618 = ((((_e4607.member.member * _e1180) + (_e4607.member.member_1 * _e1193)) + (_e4607.member.member_2 * _e1158)) + _e4607.member_1);
let _e4624 = ((((_e4607.member.member * _e1203) + (_e4607.member.member_1 * _e1208)) + (_e4607.member.member_2 * _e1197)) + _e4607.member_1);
let _e4631 = bitcast<f32>((bitcast<u32>((_e4618 - _e4624)) & 2147483647u));
let _e4634 = (bitcast<f32>((bitcast<u32>(_e4618) & 2147483647u)) / select(1e-30f, _e4631, (_e4631 > 1e-30f)));
let _e4636 = select(0f, _e4634, (_e4634 > 0f));
let _e4638 = select(1f, _e4636, (_e4636 < 1f));
let _e4639 = (_e4618 > 0f);
let _e4640 = (_e4624 > 0f);
let _e4642 = select(0f, select(_e4638, 1f, _e4640), _e4639);
let _e4644 = select(1f, select(_e4638, 1f, _e4639), _e4640);
let _e4648 = global_1.member.member_16.member_1;
let _e4649 = (_e4648 != 0u);
let _e4651 = select(_e4642, 0f, (0f > _e4642));
let _e4653 = select(_e4644, 1f, (1f < _e4644));
let _e4654 = select(0f, _e4642, _e4649);
let _e4655 = select(1f, _e4644, _e4649);
let _e4657 = select(_e4654, 0f, (0f > _e4654));
let _e4659 = select(_e4655, 1f, (1f < _e4655));
let _e4666 = global_1.member.member_17.member;
let _e4677 = ((((_e4666.member.member * _e1180) + (_e4666.member.member_1 * _e1193)) + (_e4666.member.member_2 * _e1158)) + _e4666.member_1);
let _e4683 = ((((_e4666.member.member * _e1203) + (_e4666.member.member_1 * _e1208)) + (_e4666.member.member_2 * _e1197)) + _e4666.member_1);
let _e4690 = bitcast<f32>((bitcast<u32>((_e4677 - _e4683)) & 2147483647u));
let _e4693 = (bitcast<f32>((bitcast<u32>(_e4677) & 2147483647u)) / select(1e-30f, _e4690, (_e4690 > 1e-30f)));
let _e4695 = select(0f, _e4693, (_e4693 > 0f));
let _e4697 = select(1f, _e4695, (_e4695 < 1f));
let _e4698 = (_e4677 > 0f);
let _e4699 = (_e4683 > 0f);
let _e4701 = select(0f, select(_e4697, 1f, _e4699), _e4698);
let _e4703 = select(1f, select(_e4697, 1f, _e4698), _e4699);
let _e4707 = global_1.member.member_17.member_1;
let _e4708 = (_e4707 != 0u);
let _e4710 = select(_e4701, _e4651, (_e4651 > _e4701));
let _e4712 = select(_e4703, _e4653, (_e4653 < _e4703));
let _e4713 = select(0f, _e4701, _e4708);
let _e4714 = select(1f, _e4703, _e4708);
let _e4716 = select(_e4713, _e4657, (_e4657 > _e4713));
let _e4718 = select(_e4714, _e4659, (_e4659 < _e4714));
let _e4725 = global_1.member.member_18.member;
let _e4736 = ((((_e4725.member.member * _e1180) + (_e4725.member.member_1 * _e1193)) + (_e4725.member.member_2 * _e1158)) + _e4725.member_1);
let _e4742 = ((((_e4725.member.member * _e1203) + (_e4725.member.member_1 * _e1208)) + (_e4725.member.member_2 * _e1197)) + _e4725.member_1);
let _e4749 = bitcast<f32>((bitcast<u32>((_e4736 - _e4742)) & 2147483647u));
let _e4752 = (bitcast<f32>((bitcast<u32>(_e4736) & 2147483647u)) / select(1e-30f, _e4749, (_e4749 > 1e-30f)));
let _e4754 = select(0f, _e4752, (_e4752 > 0f));
let _e4756 = select(1f, _e4754, (_e4754 < 1f));
let _e4757 = (_e4736 > 0f);
let _e4758 = (_e4742 > 0f);
let _e4760 = select(0f, select(_e4756, 1f, _e4758), _e4757);
let _e4762 = select(1f, select(_e4756, 1f, _e4757), _e4758);
let _e4766 = global_1.member.member_18.member_1;
let _e4767 = (_e4766 != 0u);
let _e4769 = select(_e4760, _e4710, (_e4710 > _e4760));
let _e4771 = select(_e4762, _e4712, (_e4712 < _e4762));
let _e4772 = select(0f, _e4760, _e4767);
let _e4773 = select(1f, _e4762, _e4767);
let _e4775 = select(_e4772, _e4716, (_e4716 > _e4772));
let _e4777 = select(_e4773, _e4718, (_e4718 < _e4773));
let _e4784 = global_1.member.member_19.member;
let _e4795 = ((((_e4784.member.member * _e1180) + (_e4784.member.member_1 * _e1193)) + (_e4784.member.member_2 * _e1158)) + _e4784.member_1);
let _e4801 = ((((_e4784.member.member * _e1203) + (_e4784.member.member_1 * _e1208)) + (_e4784.member.member_2 * _e1197)) + _e4784.member_1);
let _e4808 = bitcast<f32>((bitcast<u32>((_e4795 - _e4801)) & 2147483647u));
let _e4811 = (bitcast<f32>((bitcast<u32>(_e4795) & 2147483647u)) / select(1e-30f, _e4808, (_e4808 > 1e-30f)));
let _e4813 = select(0f, _e4811, (_e4811 > 0f));
let _e4815 = select(1f, _e4813, (_e4813 < 1f));
let _e4816 = (_e4795 > 0f);
let _e4817 = (_e4801 > 0f);
let _e4819 = select(0f, select(_e4815, 1f, _e4817), _e4816);
let _e4821 = select(1f, select(_e4815, 1f, _e4816), _e4817);
let _e4825 = global_1.member.member_19.member_1;
let _e4826 = (_e4825 != 0u);
let _e4831 = select(0f, _e4819, _e4826);
let _e4832 = select(1f, _e4821, _e4826);
phi_10457_ = type_36(type_33(select(_e4819, _e4769, (_e4769 > _e4819)), select(_e4821, _e4771, (_e4771 < _e4821))), type_33(select(_e4831, _e4775, (_e4775 > _e4831)), select(_e4832, _e4777, (_e4777 < _e4832))), ((((1f * select(1f, 0f, (_e4649 && _e4640))) * select(1f, 0f, (_e4708 && _e4699))) * select(1f, 0f, (_e4767 && _e4758))) * select(1f, 0f, (_e4826 && _e4817))));
}
let _e4844 = phi_10457_;
let _e4845 = (_e1259 - _e1223);
let _e4849 = (bitcast<f32>((bitcast<u32>(_e4845) & 2147483647u)) < 1e-12f);
let _e4851 = (1f / select(_e4845, 1f, _e4849));
let _e4852 = (_e4217 - _e1223);
let _e4853 = (_e4852 * _e4851);
let _e4855 = ((_e4222 - _e1223) * _e4851);
let _e4861 = select(_e4855, _e4853, (_e4853 < _e4855));
let _e4863 = select(0f, _e4861, (_e4861 > 0f));
let _e4866 = select(select(1f, _e4863, (_e4863 < 1f)), select(2f, 0f, ((_e1223 >= _e4217) && (_e1223 <= _e4222))), _e4849);
let _e4868 = select(_e4855, _e4853, (_e4853 > _e4855));
let _e4870 = select(0f, _e4868, (_e4868 > 0f));
let _e4873 = select(select(1f, _e4870, (_e4870 < 1f)), 1f, _e4849);
let _e4874 = (_e1265 - _e1238);
let _e4878 = (bitcast<f32>((bitcast<u32>(_e4874) & 2147483647u)) < 1e-12f);
let _e4880 = (1f / select(_e4874, 1f, _e4878));
let _e4881 = (_e4231 - _e1238);
let _e4882 = (_e4881 * _e4880);
let _e4884 = ((_e4236 - _e1238) * _e4880);
let _e4890 = select(_e4884, _e4882, (_e4882 < _e4884));
let _e4892 = select(0f, _e4890, (_e4890 > 0f));
let _e4895 = select(select(1f, _e4892, (_e4892 < 1f)), select(2f, 0f, ((_e1238 >= _e4231) && (_e1238 <= _e4236))), _e4878);
let _e4897 = select(_e4884, _e4882, (_e4882 > _e4884));
let _e4899 = select(0f, _e4897, (_e4897 > 0f));
let _e4902 = select(select(1f, _e4899, (_e4899 < 1f)), 1f, _e4878);
let _e4903 = (_e1271 - _e1253);
let _e4907 = (bitcast<f32>((bitcast<u32>(_e4903) & 2147483647u)) < 1e-12f);
let _e4909 = (1f / select(_e4903, 1f, _e4907));
let _e4910 = (_e4245 - _e1253);
let _e4911 = (_e4910 * _e4909);
let _e4913 = ((_e4250 - _e1253) * _e4909);
let _e4919 = select(_e4913, _e4911, (_e4911 < _e4913));
let _e4921 = select(0f, _e4919, (_e4919 > 0f));
let _e4924 = select(select(1f, _e4921, (_e4921 < 1f)), select(2f, 0f, ((_e1253 >= _e4245) && (_e1253 <= _e4250))), _e4907);
let _e4926 = select(_e4913, _e4911, (_e4911 > _e4913));
let _e4928 = select(0f, _e4926, (_e4926 > 0f));
let _e4931 = select(select(1f, _e4928, (_e4928 < 1f)), 1f, _e4907);
let _e4933 = select(_e4895, _e4866, (_e4866 > _e4895));
let _e4937 = select(_e4902, _e4873, (_e4873 < _e4902));
let _e4940 = (select(_e4931, _e4937, (_e4937 < _e4931)) - select(_e4924, _e4933, (_e4933 > _e4924)));
let _e4942 = select(0f, _e4940, (_e4940 > 0f));
let _e4943 = (_e1203 - _e1180);
let _e4944 = (_e1208 - _e1193);
let _e4945 = (_e1197 - _e1158);
let _e4950 = (((_e4943 * _e4943) + (_e4944 * _e4944)) + (_e4945 * _e4945));
let _e4958 = global_1.member.member_7.member_3;
let _e4959 = ((sqrt(select(0f, _e4950, (_e4950 > 0f))) * _e4942) * _e4958);
if (((_e187.member_2 == 3u) || (_e187.member_2 == 4u)) || _e1273) {
local_7 = _e4598;
let _e4964 = local_7;
let _e4966 = (bitcast<i32>(_e177) - 1i);
let _e4968 = select(_e4966, 263171i, (263171i < _e4966));
let _e4973 = global_3.member[bitcast<u32>(select(0i, _e4968, (_e4968 > 0i)))];
let _e4974 = bitcast<f32>(_e4973);
let _e4976 = select(_e4966, 263172i, (263172i < _e4966));
let _e4981 = global_3.member[bitcast<u32>(select(0i, _e4976, (_e4976 > 0i)))];
let _e4982 = bitcast<f32>(_e4981);
let _e4984 = select(_e4966, 263173i, (263173i < _e4966));
let _e4989 = global_3.member[bitcast<u32>(select(0i, _e4984, (_e4984 > 0i)))];
let _e4990 = bitcast<f32>(_e4989);
let _e4992 = ((_e4964 - _e4974) * _e4982);
let _e4994 = select(0f, _e4992, (_e4992 > 0f));
let _e4997 = local_7;
let _e4999 = select(_e4966, 263174i, (263174i < _e4966));
let _e5004 = global_3.member[bitcast<u32>(select(0i, _e4999, (_e4999 > 0i)))];
let _e5005 = bitcast<f32>(_e5004);
let _e5007 = select(_e4966, 263175i, (263175i < _e4966));
let _e5012 = global_3.member[bitcast<u32>(select(0i, _e5007, (_e5007 > 0i)))];
let _e5013 = bitcast<f32>(_e5012);
let _e5015 = select(_e4966, 263176i, (263176i < _e4966));
let _e5020 = global_3.member[bitcast<u32>(select(0i, _e5015, (_e5015 > 0i)))];
let _e5021 = bitcast<f32>(_e5020);
let _e5023 = ((_e4997 - _e5005) * _e5013);
let _e5025 = select(0f, _e5023, (_e5023 > 0f));
let _e5029 = local_7;
let _e5031 = select(_e4966, 263177i, (263177i < _e4966));
let _e5036 = global_3.member[bitcast<u32>(select(0i, _e5031, (_e5031 > 0i)))];
let _e5037 = bitcast<f32>(_e5036);
let _e5039 = select(_e4966, 263178i, (263178i < _e4966));
let _e5044 = global_3.member[bitcast<u32>(select(0i, _e5039, (_e5039 > 0i)))];
let _e5045 = bitcast<f32>(_e5044);
let _e5047 = select(_e4966, 263179i, (263179i < _e4966));
let _e5052 = global_3.member[bitcast<u32>(select(0i, _e5047, (_e5047 > 0i)))];
let _e5053 = bitcast<f32>(_e5052);
let _e5055 = ((_e5029 - _e5037) * _e5045);
let _e5057 = select(0f, _e5055, (_e5055 > 0f));
let _e5060 = local_7;
let _e5062 = select(_e4966, 263180i, (263180i < _e4966));
let _e5067 = global_3.member[bitcast<u32>(select(0i, _e5062, (_e5062 > 0i)))];
let _e5068 = bitcast<f32>(_e5067);
let _e5070 = select(_e4966, 263181i, (263181i < _e4966));
let _e5075 = global_3.member[bitcast<u32>(select(0i, _e5070, (_e5070 > 0i)))];
let _e5076 = bitcast<f32>(_e5075);
let _e5078 = select(_e4966, 263182i, (263182i < _e4966));
let _e5083 = global_3.member[bitcast<u32>(select(0i, _e5078, (_e5078 > 0i)))];
let _e5084 = bitcast<f32>(_e5083);
let _e5086 = ((_e5060 - _e5068) * _e5076);
let _e5088 = select(0f, _e5086, (_e5086 > 0f));
let _e5093 = local_7;
let _e5095 = select(_e4966, 263183i, (263183i < _e4966));
let _e5100 = global_3.member[bitcast<u32>(select(0i, _e5095, (_e5095 > 0i)))];
let _e5101 = bitcast<f32>(_e5100);
let _e5103 = select(_e4966, 263184i, (263184i < _e4966));
let _e5108 = global_3.member[bitcast<u32>(select(0i, _e5103, (_e5103 > 0i)))];
let _e5109 = bitcast<f32>(_e5108);
let _e5111 = select(_e4966, 263185i, (263185i < _e4966));
let _e5116 = global_3.member[bitcast<u32>(select(0i, _e5111, (_e5111 > 0i)))];
let _e5117 = bitcast<f32>(_e5116);
let _e5119 = ((_e5093 - _e5101) * _e5109);
let _e5121 = select(0f, _e5119, (_e5119 > 0f));
let _e5124 = local_7;
let _e5126 = select(_e4966, 263186i, (263186i < _e4966));
let _e5131 = global_3.member[bitcast<u32>(select(0i, _e5126, (_e5126 > 0i)))];
let _e5132 = bitcast<f32>(_e5131);
let _e5134 = select(_e4966, 263187i, (263187i < _e4966));
let _e5139 = global_3.member[bitcast<u32>(select(0i, _e5134, (_e5134 > 0i)))];
let _e5140 = bitcast<f32>(_e5139);
let _e5142 = select(_e4966, 263188i, (263188i < _e4966));
let _e5147 = global_3.member[bitcast<u32>(select(0i, _e5142, (_e5142 > 0i)))];
let _e5148 = bitcast<f32>(_e5147);
let _e5150 = ((_e5124 - _e5132) * _e5140);
let _e5152 = select(0f, _e5150, (_e5150 > 0f));
let _e5156 = local_7;
let _e5158 = select(_e4966, 263189i, (263189i < _e4966));
let _e5163 = global_3.member[bitcast<u32>(select(0i, _e5158, (_e5158 > 0i)))];
let _e5164 = bitcast<f32>(_e5163);
let _e5166 = select(_e4966, 263190i, (263190i < _e4966));
let _e5171 = global_3.member[bitcast<u32>(select(0i, _e5166, (_e5166 > 0i)))];
let _e5172 = bitcast<f32>(_e5171);
let _e5174 = select(_e4966, 263191i, (263191i < _e4966));
let _e5179 = global_3.member[bitcast<u32>(select(0i, _e5174, (_e5174 > 0i)))];
let _e5180 = bitcast<f32>(_e5179);
let _e5182 = ((_e5156 - _e5164) * _e5172);
let _e5184 = select(0f, _e5182, (_e5182 > 0f));
let _e5187 = local_7;
let _e5189 = select(_e4966, 263192i, (263192i < _e4966));
let _e5194 = global_3.member[bitcast<u32>(select(0i, _e5189, (_e5189 > 0i)))];
let _e5195 = bitcast<f32>(_e5194);
let _e5197 = select(_e4966, 263193i, (263193i < _e4966));
let _e5202 = global_3.member[bitcast<u32>(select(0i, _e5197, (_e5197 > 0i)))];
let _e5203 = bitcast<f32>(_e5202);
let _e5205 = select(_e4966, 263194i, (263194i < _e4966));
let _e5210 = global_3.member[bitcast<u32>(select(0i, _e5205, (_e5205 > 0i)))];
let _e5211 = bitcast<f32>(_e5210);
let _e5213 = ((_e5187 - _e5195) * _e5203);
let _e5215 = select(0f, _e5213, (_e5213 > 0f));
let _e5220 = (((select(_e4990, _e4994, (_e4994 < _e4990)) + select(_e5021, _e5025, (_e5025 < _e5021))) + (select(_e5053, _e5057, (_e5057 < _e5053)) + select(_e5084, _e5088, (_e5088 < _e5084)))) + ((select(_e5117, _e5121, (_e5121 < _e5117)) + select(_e5148, _e5152, (_e5152 < _e5148))) + (select(_e5180, _e5184, (_e5184 < _e5180)) + select(_e5211, _e5215, (_e5215 < _e5211)))));
local_6 = _e4212.member;
let _e5221 = local_6;
let _e5223 = ((_e5221 - _e4974) * _e4982);
let _e5225 = select(0f, _e5223, (_e5223 > 0f));
let _e5228 = local_6;
let _e5230 = ((_e5228 - _e5005) * _e5013);
let _e5232 = select(0f, _e5230, (_e5230 > 0f));
let _e5236 = local_6;
let _e5238 = ((_e5236 - _e5037) * _e5045);
let _e5240 = select(0f, _e5238, (_e5238 > 0f));
let _e5243 = local_6;
let _e5245 = ((_e5243 - _e5068) * _e5076);
let _e5247 = select(0f, _e5245, (_e5245 > 0f));
let _e5252 = local_6;
let _e5254 = ((_e5252 - _e5101) * _e5109);
let _e5256 = select(0f, _e5254, (_e5254 > 0f));
let _e5259 = local_6;
let _e5261 = ((_e5259 - _e5132) * _e5140);
let _e5263 = select(0f, _e5261, (_e5261 > 0f));
let _e5267 = local_6;
let _e5269 = ((_e5267 - _e5164) * _e5172);
let _e5271 = select(0f, _e5269, (_e5269 > 0f));
let _e5274 = local_6;
let _e5276 = ((_e5274 - _e5195) * _e5203);
let _e5278 = select(0f, _e5276, (_e5276 > 0f));
let _e5283 = (((select(_e4990, _e5225, (_e5225 < _e4990)) + select(_e5021, _e5232, (_e5232 < _e5021))) + (select(_e5053, _e5240, (_e5240 < _e5053)) + select(_e5084, _e5247, (_e5247 < _e5084)))) + ((select(_e5117, _e5256, (_e5256 < _e5117)) + select(_e5148, _e5263, (_e5263 < _e5148))) + (select(_e5180, _e5271, (_e5271 < _e5180)) + select(_e5211, _e5278, (_e5278 < _e5211)))));
let _e5284 = (255f - 1f);
let _e5286 = select(0f, _e5220, (_e5220 > 0f));
let _e5288 = select(_e5284, _e5286, (_e5286 < _e5284));
let _e5295 = select(0i, select(select(i32(_e5288), i32(-2147483648), (_e5288 < -2147483600f)), 2147483647i, (_e5288 > 2147483500f)), (_e5288 == _e5288));
let _e5299 = (_e5295 - select(0i, 1i, (_e5288 < f32(_e5295))));
let _e5301 = select(0f, _e5283, (_e5283 > 0f));
let _e5303 = select(_e5284, _e5301, (_e5301 < _e5284));
let _e5310 = select(0i, select(select(i32(_e5303), i32(-2147483648), (_e5303 < -2147483600f)), 2147483647i, (_e5303 > 2147483500f)), (_e5303 == _e5303));
let _e5314 = (_e5310 - select(0i, 1i, (_e5303 < f32(_e5310))));
let _e5316 = select(_e4966, 263195i, (263195i < _e4966));
let _e5322 = global_3.member[bitcast<u32>(select(0i, _e5316, (_e5316 > 0i)))];
let _e5323 = bitcast<f32>(_e5322);
let _e5325 = select(_e4966, 263196i, (263196i < _e4966));
let _e5331 = global_3.member[bitcast<u32>(select(0i, _e5325, (_e5325 > 0i)))];
let _e5332 = bitcast<f32>(_e5331);
let _e5333 = (_e4212.member - _e4598);
let _e5339 = (1f / select(_e5333, 1f, (bitcast<f32>((bitcast<u32>(_e5333) & 2147483647u)) < 1e-20f)));
let _e5345 = ((select(_e5323, _e4212.member, (_e4212.member < _e5323)) - select(_e5323, _e4598, (_e4598 < _e5323))) * _e5339);
let _e5351 = ((select(_e5332, _e4212.member, (_e4212.member > _e5332)) - select(_e5332, _e4598, (_e4598 > _e5332))) * _e5339);
let _e5354 = (((_e5299 * 256i) + _e5314) * 4i);
let _e5358 = (_e5283 - f32(_e5314));
let _e5361 = (_e5354 + 1i);
let _e5363 = select(_e4966, _e5361, (_e5361 < _e4966));
let _e5369 = global_3.member[bitcast<u32>(select(0i, _e5363, (_e5363 > 0i)))];
let _e5376 = (bitcast<f32>((((_e5369 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5377 = (_e5354 + 5i);
let _e5379 = select(_e4966, _e5377, (_e5377 < _e4966));
let _e5385 = global_3.member[bitcast<u32>(select(0i, _e5379, (_e5379 > 0i)))];
let _e5393 = (_e5354 + 1025i);
let _e5395 = select(_e4966, _e5393, (_e5393 < _e4966));
let _e5401 = global_3.member[bitcast<u32>(select(0i, _e5395, (_e5395 > 0i)))];
let _e5408 = (bitcast<f32>((((_e5401 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5409 = (_e5354 + 1029i);
let _e5411 = select(_e4966, _e5409, (_e5409 < _e4966));
let _e5417 = global_3.member[bitcast<u32>(select(0i, _e5411, (_e5411 > 0i)))];
let _e5427 = (_e5376 + (((bitcast<f32>((((_e5385 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5376) * _e5358));
let _e5435 = select(_e4966, 1i, (1i < _e4966));
let _e5441 = global_3.member[bitcast<u32>(select(0i, _e5435, (_e5435 > 0i)))];
let _e5450 = select(_e4966, 262141i, (262141i < _e4966));
let _e5456 = global_3.member[bitcast<u32>(select(0i, _e5450, (_e5450 > 0i)))];
let _e5468 = (((_e5427 + (((_e5408 + (((bitcast<f32>((((_e5417 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5408) * _e5358)) - _e5427) * (_e5220 - f32(_e5299)))) * (1f - (_e5345 + _e5351))) + (((bitcast<f32>((((_e5441 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5345) + ((bitcast<f32>((((_e5456 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5351)));
let _e5473 = (_e4844.member.member_1 - _e4844.member.member);
let _e5478 = -((_e5468 * (_e4959 * select(0f, _e5473, (_e5473 > 0f)))));
let _e5480 = select(-87f, _e5478, (_e5478 > -87f));
let _e5482 = select(88f, _e5480, (_e5480 < 88f));
let _e5484 = ((_e5482 * 1.442695f) + 0.5f);
let _e5486 = select(-127f, _e5484, (_e5484 > -127f));
let _e5488 = select(128f, _e5486, (_e5486 < 128f));
let _e5495 = select(0i, select(select(i32(_e5488), i32(-2147483648), (_e5488 < -2147483600f)), 2147483647i, (_e5488 > 2147483500f)), (_e5488 == _e5488));
let _e5499 = (_e5495 - select(0i, 1i, (_e5488 < f32(_e5495))));
let _e5500 = f32(_e5499);
let _e5504 = ((_e5482 - (_e5500 * 0.6933594f)) - (_e5500 * -2.1219444e-4f));
let _e5524 = ((1f + (_e5504 * (1f + (_e5504 * (0.5f + (_e5504 * (0.16666667f + (_e5504 * (0.041666668f + (_e5504 * (0.008333334f + (_e5504 * (0.001388889f + (_e5504 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5499 + 127i)) << bitcast<u32>(23i))));
let _e5525 = (1f - _e5524);
phi_14401_ = type_38(_e5524, _e5525, vec3<f32>(1f, 1f, 1f), vec3((0f * (_e5525 / select(1e-12f, _e5468, (_e5468 > 1e-12f))))));
} else {
local_5 = _e4598;
let _e5532 = local_5;
let _e5534 = (bitcast<i32>(_e177) - 1i);
let _e5536 = select(_e5534, 263171i, (263171i < _e5534));
let _e5541 = global_3.member[bitcast<u32>(select(0i, _e5536, (_e5536 > 0i)))];
let _e5542 = bitcast<f32>(_e5541);
let _e5544 = select(_e5534, 263172i, (263172i < _e5534));
let _e5549 = global_3.member[bitcast<u32>(select(0i, _e5544, (_e5544 > 0i)))];
let _e5550 = bitcast<f32>(_e5549);
let _e5552 = select(_e5534, 263173i, (263173i < _e5534));
let _e5557 = global_3.member[bitcast<u32>(select(0i, _e5552, (_e5552 > 0i)))];
let _e5558 = bitcast<f32>(_e5557);
let _e5560 = ((_e5532 - _e5542) * _e5550);
let _e5562 = select(0f, _e5560, (_e5560 > 0f));
let _e5565 = local_5;
let _e5567 = select(_e5534, 263174i, (263174i < _e5534));
let _e5572 = global_3.member[bitcast<u32>(select(0i, _e5567, (_e5567 > 0i)))];
let _e5573 = bitcast<f32>(_e5572);
let _e5575 = select(_e5534, 263175i, (263175i < _e5534));
let _e5580 = global_3.member[bitcast<u32>(select(0i, _e5575, (_e5575 > 0i)))];
let _e5581 = bitcast<f32>(_e5580);
let _e5583 = select(_e5534, 263176i, (263176i < _e5534));
let _e5588 = global_3.member[bitcast<u32>(select(0i, _e5583, (_e5583 > 0i)))];
let _e5589 = bitcast<f32>(_e5588);
let _e5591 = ((_e5565 - _e5573) * _e5581);
let _e5593 = select(0f, _e5591, (_e5591 > 0f));
let _e5597 = local_5;
let _e5599 = select(_e5534, 263177i, (263177i < _e5534));
let _e5604 = global_3.member[bitcast<u32>(select(0i, _e5599, (_e5599 > 0i)))];
let _e5605 = bitcast<f32>(_e5604);
let _e5607 = select(_e5534, 263178i, (263178i < _e5534));
let _e5612 = global_3.member[bitcast<u32>(select(0i, _e5607, (_e5607 > 0i)))];
let _e5613 = bitcast<f32>(_e5612);
let _e5615 = select(_e5534, 263179i, (263179i < _e5534));
let _e5620 = global_3.member[bitcast<u32>(select(0i, _e5615, (_e5615 > 0i)))];
let _e5621 = bitcast<f32>(_e5620);
let _e5623 = ((_e5597 - _e5605) * _e5613);
let _e5625 = select(0f, _e5623, (_e5623 > 0f));
let _e5628 = local_5;
let _e5630 = select(_e5534, 263180i, (263180i < _e5534));
let _e5635 = global_3.member[bitcast<u32>(select(0i, _e5630, (_e5630 > 0i)))];
let _e5636 = bitcast<f32>(_e5635);
let _e5638 = select(_e5534, 263181i, (263181i < _e5534));
let _e5643 = global_3.member[bitcast<u32>(select(0i, _e5638, (_e5638 > 0i)))];
let _e5644 = bitcast<f32>(_e5643);
let _e5646 = select(_e5534, 263182i, (263182i < _e5534));
let _e5651 = global_3.member[bitcast<u32>(select(0i, _e5646, (_e5646 > 0i)))];
let _e5652 = bitcast<f32>(_e5651);
let _e5654 = ((_e5628 - _e5636) * _e5644);
let _e5656 = select(0f, _e5654, (_e5654 > 0f));
let _e5661 = local_5;
let _e5663 = select(_e5534, 263183i, (263183i < _e5534));
let _e5668 = global_3.member[bitcast<u32>(select(0i, _e5663, (_e5663 > 0i)))];
let _e5669 = bitcast<f32>(_e5668);
let _e5671 = select(_e5534, 263184i, (263184i < _e5534));
let _e5676 = global_3.member[bitcast<u32>(select(0i, _e5671, (_e5671 > 0i)))];
let _e5677 = bitcast<f32>(_e5676);
let _e5679 = select(_e5534, 263185i, (263185i < _e5534));
let _e5684 = global_3.member[bitcast<u32>(select(0i, _e5679, (_e5679 > 0i)))];
let _e5685 = bitcast<f32>(_e5684);
let _e5687 = ((_e5661 - _e5669) * _e5677);
let _e5689 = select(0f, _e5687, (_e5687 > 0f));
let _e5692 = local_5;
let _e5694 = select(_e5534, 263186i, (263186i < _e5534));
let _e5699 = global_3.member[bitcast<u32>(select(0i, _e5694, (_e5694 > 0i)))];
let _e5700 = bitcast<f32>(_e5699);
let _e5702 = select(_e5534, 263187i, (263187i < _e5534));
let _e5707 = global_3.member[bitcast<u32>(select(0i, _e5702, (_e5702 > 0i)))];
let _e5708 = bitcast<f32>(_e5707);
let _e5710 = select(_e5534, 263188i, (263188i < _e5534));
let _e5715 = global_3.member[bitcast<u32>(select(0i, _e5710, (_e5710 > 0i)))];
let _e5716 = bitcast<f32>(_e5715);
let _e5718 = ((_e5692 - _e5700) * _e5708);
let _e5720 = select(0f, _e5718, (_e5718 > 0f));
let _e5724 = local_5;
let _e5726 = select(_e5534, 263189i, (263189i < _e5534));
let _e5731 = global_3.member[bitcast<u32>(select(0i, _e5726, (_e5726 > 0i)))];
let _e5732 = bitcast<f32>(_e5731);
let _e5734 = select(_e5534, 263190i, (263190i < _e5534));
let _e5739 = global_3.member[bitcast<u32>(select(0i, _e5734, (_e5734 > 0i)))];
let _e5740 = bitcast<f32>(_e5739);
let _e5742 = select(_e5534, 263191i, (263191i < _e5534));
let _e5747 = global_3.member[bitcast<u32>(select(0i, _e5742, (_e5742 > 0i)))];
let _e5748 = bitcast<f32>(_e5747);
let _e5750 = ((_e5724 - _e5732) * _e5740);
let _e5752 = select(0f, _e5750, (_e5750 > 0f));
let _e5755 = local_5;
let _e5757 = select(_e5534, 263192i, (263192i < _e5534));
let _e5762 = global_3.member[bitcast<u32>(select(0i, _e5757, (_e5757 > 0i)))];
let _e5763 = bitcast<f32>(_e5762);
let _e5765 = select(_e5534, 263193i, (263193i < _e5534));
let _e5770 = global_3.member[bitcast<u32>(select(0i, _e5765, (_e5765 > 0i)))];
let _e5771 = bitcast<f32>(_e5770);
let _e5773 = select(_e5534, 263194i, (263194i < _e5534));
let _e5778 = global_3.member[bitcast<u32>(select(0i, _e5773, (_e5773 > 0i)))];
let _e5779 = bitcast<f32>(_e5778);
let _e5781 = ((_e5755 - _e5763) * _e5771);
let _e5783 = select(0f, _e5781, (_e5781 > 0f));
let _e5788 = (((select(_e5558, _e5562, (_e5562 < _e5558)) + select(_e5589, _e5593, (_e5593 < _e5589))) + (select(_e5621, _e5625, (_e5625 < _e5621)) + select(_e5652, _e5656, (_e5656 < _e5652)))) + ((select(_e5685, _e5689, (_e5689 < _e5685)) + select(_e5716, _e5720, (_e5720 < _e5716))) + (select(_e5748, _e5752, (_e5752 < _e5748)) + select(_e5779, _e5783, (_e5783 < _e5779)))));
local_4 = _e4212.member;
let _e5789 = local_4;
let _e5791 = ((_e5789 - _e5542) * _e5550);
let _e5793 = select(0f, _e5791, (_e5791 > 0f));
let _e5796 = local_4;
let _e5798 = ((_e5796 - _e5573) * _e5581);
let _e5800 = select(0f, _e5798, (_e5798 > 0f));
let _e5804 = local_4;
let _e5806 = ((_e5804 - _e5605) * _e5613);
let _e5808 = select(0f, _e5806, (_e5806 > 0f));
let _e5811 = local_4;
let _e5813 = ((_e5811 - _e5636) * _e5644);
let _e5815 = select(0f, _e5813, (_e5813 > 0f));
let _e5820 = local_4;
let _e5822 = ((_e5820 - _e5669) * _e5677);
let _e5824 = select(0f, _e5822, (_e5822 > 0f));
let _e5827 = local_4;
let _e5829 = ((_e5827 - _e5700) * _e5708);
let _e5831 = select(0f, _e5829, (_e5829 > 0f));
let _e5835 = local_4;
let _e5837 = ((_e5835 - _e5732) * _e5740);
let _e5839 = select(0f, _e5837, (_e5837 > 0f));
let _e5842 = local_4;
let _e5844 = ((_e5842 - _e5763) * _e5771);
let _e5846 = select(0f, _e5844, (_e5844 > 0f));
let _e5851 = (((select(_e5558, _e5793, (_e5793 < _e5558)) + select(_e5589, _e5800, (_e5800 < _e5589))) + (select(_e5621, _e5808, (_e5808 < _e5621)) + select(_e5652, _e5815, (_e5815 < _e5652)))) + ((select(_e5685, _e5824, (_e5824 < _e5685)) + select(_e5716, _e5831, (_e5831 < _e5716))) + (select(_e5748, _e5839, (_e5839 < _e5748)) + select(_e5779, _e5846, (_e5846 < _e5779)))));
let _e5852 = (255f - 1f);
let _e5854 = select(0f, _e5788, (_e5788 > 0f));
let _e5856 = select(_e5852, _e5854, (_e5854 < _e5852));
let _e5863 = select(0i, select(select(i32(_e5856), i32(-2147483648), (_e5856 < -2147483600f)), 2147483647i, (_e5856 > 2147483500f)), (_e5856 == _e5856));
let _e5867 = (_e5863 - select(0i, 1i, (_e5856 < f32(_e5863))));
let _e5869 = select(0f, _e5851, (_e5851 > 0f));
let _e5871 = select(_e5852, _e5869, (_e5869 < _e5852));
let _e5878 = select(0i, select(select(i32(_e5871), i32(-2147483648), (_e5871 < -2147483600f)), 2147483647i, (_e5871 > 2147483500f)), (_e5871 == _e5871));
let _e5882 = (_e5878 - select(0i, 1i, (_e5871 < f32(_e5878))));
let _e5884 = select(_e5534, 263195i, (263195i < _e5534));
let _e5890 = global_3.member[bitcast<u32>(select(0i, _e5884, (_e5884 > 0i)))];
let _e5891 = bitcast<f32>(_e5890);
let _e5893 = select(_e5534, 263196i, (263196i < _e5534));
let _e5899 = global_3.member[bitcast<u32>(select(0i, _e5893, (_e5893 > 0i)))];
let _e5900 = bitcast<f32>(_e5899);
let _e5901 = (_e4212.member - _e4598);
let _e5907 = (1f / select(_e5901, 1f, (bitcast<f32>((bitcast<u32>(_e5901) & 2147483647u)) < 1e-20f)));
let _e5913 = ((select(_e5891, _e4212.member, (_e4212.member < _e5891)) - select(_e5891, _e4598, (_e4598 < _e5891))) * _e5907);
let _e5919 = ((select(_e5900, _e4212.member, (_e4212.member > _e5900)) - select(_e5900, _e4598, (_e4598 > _e5900))) * _e5907);
let _e5922 = (((_e5867 * 256i) + _e5882) * 4i);
let _e5924 = (_e5788 - f32(_e5867));
let _e5926 = (_e5851 - f32(_e5882));
let _e5928 = (1f - (_e5913 + _e5919));
let _e5930 = select(_e5534, _e5922, (_e5922 < _e5534));
let _e5936 = global_3.member[bitcast<u32>(select(0i, _e5930, (_e5930 > 0i)))];
let _e5941 = (bitcast<f32>(((_e5936 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5948 = (bitcast<f32>((((_e5936 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5949 = (_e5922 + 4i);
let _e5951 = select(_e5534, _e5949, (_e5949 < _e5534));
let _e5957 = global_3.member[bitcast<u32>(select(0i, _e5951, (_e5951 > 0i)))];
let _e5970 = (_e5922 + 1024i);
let _e5972 = select(_e5534, _e5970, (_e5970 < _e5534));
let _e5978 = global_3.member[bitcast<u32>(select(0i, _e5972, (_e5972 > 0i)))];
let _e5983 = (bitcast<f32>(((_e5978 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5990 = (bitcast<f32>((((_e5978 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5991 = (_e5922 + 1028i);
let _e5993 = select(_e5534, _e5991, (_e5991 < _e5534));
let _e5999 = global_3.member[bitcast<u32>(select(0i, _e5993, (_e5993 > 0i)))];
let _e6014 = (_e5941 + (((bitcast<f32>(((_e5957 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5941) * _e5926));
let _e6023 = (_e5948 + (((bitcast<f32>((((_e5957 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5948) * _e5926));
let _e6031 = select(_e5534, 0i, (0i < _e5534));
let _e6037 = global_3.member[bitcast<u32>(select(0i, _e6031, (_e6031 > 0i)))];
let _e6051 = select(_e5534, 262140i, (262140i < _e5534));
let _e6057 = global_3.member[bitcast<u32>(select(0i, _e6051, (_e6051 > 0i)))];
let _e6080 = (_e5922 + 1i);
let _e6082 = select(_e5534, _e6080, (_e6080 < _e5534));
let _e6088 = global_3.member[bitcast<u32>(select(0i, _e6082, (_e6082 > 0i)))];
let _e6093 = (bitcast<f32>(((_e6088 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e6100 = (bitcast<f32>((((_e6088 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e6101 = (_e5922 + 5i);
let _e6103 = select(_e5534, _e6101, (_e6101 < _e5534));
let _e6109 = global_3.member[bitcast<u32>(select(0i, _e6103, (_e6103 > 0i)))];
let _e6122 = (_e5922 + 1025i);
let _e6124 = select(_e5534, _e6122, (_e6122 < _e5534));
let _e6130 = global_3.member[bitcast<u32>(select(0i, _e6124, (_e6124 > 0i)))];
let _e6135 = (bitcast<f32>(((_e6130 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e6142 = (bitcast<f32>((((_e6130 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e6143 = (_e5922 + 1029i);
let _e6145 = select(_e5534, _e6143, (_e6143 < _e5534));
let _e6151 = global_3.member[bitcast<u32>(select(0i, _e6145, (_e6145 > 0i)))];
let _e6166 = (_e6093 + (((bitcast<f32>(((_e6109 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e6093) * _e5926));
let _e6175 = (_e6100 + (((bitcast<f32>((((_e6109 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e6100) * _e5926));
let _e6183 = select(_e5534, 1i, (1i < _e5534));
let _e6189 = global_3.member[bitcast<u32>(select(0i, _e6183, (_e6183 > 0i)))];
let _e6203 = select(_e5534, 262141i, (262141i < _e5534));
let _e6209 = global_3.member[bitcast<u32>(select(0i, _e6203, (_e6203 > 0i)))];
let _e6231 = (((_e6175 + (((_e6142 + (((bitcast<f32>((((_e6151 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e6142) * _e5926)) - _e6175) * _e5924)) * _e5928) + (((bitcast<f32>((((_e6189 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5913) + ((bitcast<f32>((((_e6209 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5919)));
let _e6236 = (_e4844.member.member_1 - _e4844.member.member);
let _e6244 = (_e4844.member_1.member_1 - _e4844.member_1.member);
let _e6247 = (_e4959 * select(0f, _e6244, (_e6244 > 0f)));
let _e6249 = -(((((_e6166 + (((_e6135 + (((bitcast<f32>(((_e6151 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e6135) * _e5926)) - _e6166) * _e5924)) * _e5928) + (((bitcast<f32>(((_e6189 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5913) + ((bitcast<f32>(((_e6209 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5919))) * _e6247));
let _e6251 = select(-87f, _e6249, (_e6249 > -87f));
let _e6253 = select(88f, _e6251, (_e6251 < 88f));
let _e6255 = ((_e6253 * 1.442695f) + 0.5f);
let _e6257 = select(-127f, _e6255, (_e6255 > -127f));
let _e6259 = select(128f, _e6257, (_e6257 < 128f));
let _e6266 = select(0i, select(select(i32(_e6259), i32(-2147483648), (_e6259 < -2147483600f)), 2147483647i, (_e6259 > 2147483500f)), (_e6259 == _e6259));
let _e6270 = (_e6266 - select(0i, 1i, (_e6259 < f32(_e6266))));
let _e6271 = f32(_e6270);
let _e6275 = ((_e6253 - (_e6271 * 0.6933594f)) - (_e6271 * -2.1219444e-4f));
let _e6297 = -(((((_e6014 + (((_e5983 + (((bitcast<f32>(((_e5999 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5983) * _e5926)) - _e6014) * _e5924)) * _e5928) + (((bitcast<f32>(((_e6037 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5913) + ((bitcast<f32>(((_e6057 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5919))) * _e6247));
let _e6299 = select(-87f, _e6297, (_e6297 > -87f));
let _e6301 = select(88f, _e6299, (_e6299 < 88f));
let _e6303 = ((_e6301 * 1.442695f) + 0.5f);
let _e6305 = select(-127f, _e6303, (_e6303 > -127f));
let _e6307 = select(128f, _e6305, (_e6305 < 128f));
let _e6314 = select(0i, select(select(i32(_e6307), i32(-2147483648), (_e6307 < -2147483600f)), 2147483647i, (_e6307 > 2147483500f)), (_e6307 == _e6307));
let _e6318 = (_e6314 - select(0i, 1i, (_e6307 < f32(_e6314))));
let _e6319 = f32(_e6318);
let _e6323 = ((_e6301 - (_e6319 * 0.6933594f)) - (_e6319 * -2.1219444e-4f));
let _e6345 = -(((((_e6023 + (((_e5990 + (((bitcast<f32>((((_e5999 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5990) * _e5926)) - _e6023) * _e5924)) * _e5928) + (((bitcast<f32>((((_e6037 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5913) + ((bitcast<f32>((((_e6057 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5919))) * _e6247));
let _e6347 = select(-87f, _e6345, (_e6345 > -87f));
let _e6349 = select(88f, _e6347, (_e6347 < 88f));
let _e6351 = ((_e6349 * 1.442695f) + 0.5f);
let _e6353 = select(-127f, _e6351, (_e6351 > -127f));
let _e6355 = select(128f, _e6353, (_e6353 < 128f));
let _e6362 = select(0i, select(select(i32(_e6355), i32(-2147483648), (_e6355 < -2147483600f)), 2147483647i, (_e6355 > 2147483500f)), (_e6355 == _e6355));
let _e6366 = (_e6362 - select(0i, 1i, (_e6355 < f32(_e6362))));
let _e6367 = f32(_e6366);
let _e6371 = ((_e6349 - (_e6367 * 0.6933594f)) - (_e6367 * -2.1219444e-4f));
let _e6394 = -((_e6231 * (_e4959 * select(0f, _e6236, (_e6236 > 0f)))));
let _e6396 = select(-87f, _e6394, (_e6394 > -87f));
let _e6398 = select(88f, _e6396, (_e6396 < 88f));
let _e6400 = ((_e6398 * 1.442695f) + 0.5f);
let _e6402 = select(-127f, _e6400, (_e6400 > -127f));
let _e6404 = select(128f, _e6402, (_e6402 < 128f));
let _e6411 = select(0i, select(select(i32(_e6404), i32(-2147483648), (_e6404 < -2147483600f)), 2147483647i, (_e6404 > 2147483500f)), (_e6404 == _e6404));
let _e6415 = (_e6411 - select(0i, 1i, (_e6404 < f32(_e6411))));
let _e6416 = f32(_e6415);
let _e6420 = ((_e6398 - (_e6416 * 0.6933594f)) - (_e6416 * -2.1219444e-4f));
let _e6440 = ((1f + (_e6420 * (1f + (_e6420 * (0.5f + (_e6420 * (0.16666667f + (_e6420 * (0.041666668f + (_e6420 * (0.008333334f + (_e6420 * (0.001388889f + (_e6420 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6415 + 127i)) << bitcast<u32>(23i))));
let _e6441 = (1f - _e6440);
phi_14401_ = type_38(_e6440, _e6441, vec3<f32>(((1f + (_e6275 * (1f + (_e6275 * (0.5f + (_e6275 * (0.16666667f + (_e6275 * (0.041666668f + (_e6275 * (0.008333334f + (_e6275 * (0.001388889f + (_e6275 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6270 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e6323 * (1f + (_e6323 * (0.5f + (_e6323 * (0.16666667f + (_e6323 * (0.041666668f + (_e6323 * (0.008333334f + (_e6323 * (0.001388889f + (_e6323 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6318 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e6371 * (1f + (_e6371 * (0.5f + (_e6371 * (0.16666667f + (_e6371 * (0.041666668f + (_e6371 * (0.008333334f + (_e6371 * (0.001388889f + (_e6371 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6366 + 127i)) << bitcast<u32>(23i))))), vec3((0f * (_e6441 / select(1e-12f, _e6231, (_e6231 > 1e-12f))))));
}
let _e6449 = phi_14401_;
if (false || ((_e4601 & 1024u) != 0u)) {
let _e6460 = (_e4212.member - _e4598);
let _e6463 = select(_e4212.member, (_e4598 + (_e6460 * _e4844.member.member)), (_e4844.member.member < 1f));
let _e6469 = select(_e6463, select(_e4212.member, (_e4598 + (_e6460 * _e4844.member.member_1)), (_e4844.member.member_1 < 1f)), (_e4844.member.member_1 > _e4844.member.member));
let _e6471 = (bitcast<i32>(_e177) - 1i);
let _e6473 = select(_e6471, 263211i, (263211i < _e6471));
let _e6479 = global_3.member[bitcast<u32>(select(0i, _e6473, (_e6473 > 0i)))];
let _e6480 = bitcast<f32>(_e6479);
let _e6484 = select(_e6471, 263212i, (263212i < _e6471));
let _e6490 = global_3.member[bitcast<u32>(select(0i, _e6484, (_e6484 > 0i)))];
let _e6491 = bitcast<f32>(_e6490);
let _e6496 = select(_e6471, 263213i, (263213i < _e6471));
let _e6502 = global_3.member[bitcast<u32>(select(0i, _e6496, (_e6496 > 0i)))];
let _e6503 = bitcast<f32>(_e6502);
let _e6507 = select(_e6471, 263214i, (263214i < _e6471));
let _e6513 = global_3.member[bitcast<u32>(select(0i, _e6507, (_e6507 > 0i)))];
let _e6514 = bitcast<f32>(_e6513);
let _e6520 = select(_e6471, 263215i, (263215i < _e6471));
let _e6526 = global_3.member[bitcast<u32>(select(0i, _e6520, (_e6520 > 0i)))];
let _e6527 = bitcast<f32>(_e6526);
let _e6531 = select(_e6471, 263216i, (263216i < _e6471));
let _e6537 = global_3.member[bitcast<u32>(select(0i, _e6531, (_e6531 > 0i)))];
let _e6538 = bitcast<f32>(_e6537);
let _e6543 = select(_e6471, 263217i, (263217i < _e6471));
let _e6549 = global_3.member[bitcast<u32>(select(0i, _e6543, (_e6543 > 0i)))];
let _e6550 = bitcast<f32>(_e6549);
let _e6554 = select(_e6471, 263218i, (263218i < _e6471));
let _e6560 = global_3.member[bitcast<u32>(select(0i, _e6554, (_e6554 > 0i)))];
let _e6561 = bitcast<f32>(_e6560);
let _e6593 = (263219i + ((((((select(0i, 1i, (_e6463 >= _e6480)) + select(0i, 1i, (_e6463 >= _e6491))) + (select(0i, 1i, (_e6463 >= _e6503)) + select(0i, 1i, (_e6463 >= _e6514)))) + ((select(0i, 1i, (_e6463 >= _e6527)) + select(0i, 1i, (_e6463 >= _e6538))) + (select(0i, 1i, (_e6463 >= _e6550)) + select(0i, 1i, (_e6463 >= _e6561))))) * 9i) + (((select(0i, 1i, (_e6469 >= _e6480)) + select(0i, 1i, (_e6469 >= _e6491))) + (select(0i, 1i, (_e6469 >= _e6503)) + select(0i, 1i, (_e6469 >= _e6514)))) + ((select(0i, 1i, (_e6469 >= _e6527)) + select(0i, 1i, (_e6469 >= _e6538))) + (select(0i, 1i, (_e6469 >= _e6550)) + select(0i, 1i, (_e6469 >= _e6561)))))) * 6i));
let _e6595 = select(_e6471, _e6593, (_e6593 < _e6471));
let _e6601 = global_3.member[bitcast<u32>(select(0i, _e6595, (_e6595 > 0i)))];
phi_14799_ = (_e6449.member * select(1f, bitcast<f32>(_e6601), (_e4942 > 0f)));
} else {
phi_14799_ = _e6449.member;
}
let _e6606 = phi_14799_;
if _e1280 {
let _e6611 = global_1.member.member_8.member.member;
let _e6619 = global_1.member.member_8.member_1.member;
let _e6627 = global_1.member.member_8.member_2.member;
let _e6631 = (_e4217 - _e1259);
let _e6632 = -(_e4852);
let _e6635 = (_e4852 - _e6631);
let _e6636 = (_e6631 - _e4852);
let _e6638 = select(_e6636, _e6635, (_e6635 > _e6636));
let _e6641 = (select(_e6632, _e4852, (_e4852 > _e6632)) / select(1e-30f, _e6638, (_e6638 > 1e-30f)));
let _e6643 = (_e6631 < 0f);
let _e6645 = select(0f, select(2f, _e6641, _e6643), (_e4852 > 0f));
let _e6646 = (_e6631 > 0f);
let _e6649 = select(2f, select(0f, _e6641, (_e4852 < 0f)), _e6646);
let _e6650 = (_e4852 > -1e30f);
let _e6654 = ((_e6645 > -1f) || ((_e6645 == -1f) && _e6650));
let _e6655 = (_e6649 < 2f);
let _e6656 = select(-1f, _e6645, _e6654);
let _e6660 = select(2f, _e6649, _e6655);
let _e6664 = select(-1e30f, _e4852, _e6650);
let _e6665 = (_e6631 > -1e30f);
let _e6666 = select(-1e30f, _e6631, _e6665);
let _e6670 = (_e1223 - _e4222);
let _e6671 = (_e1259 - _e4222);
let _e6672 = -(_e6670);
let _e6675 = (_e6670 - _e6671);
let _e6676 = (_e6671 - _e6670);
let _e6678 = select(_e6676, _e6675, (_e6675 > _e6676));
let _e6681 = (select(_e6672, _e6670, (_e6670 > _e6672)) / select(1e-30f, _e6678, (_e6678 > 1e-30f)));
let _e6683 = (_e6671 < 0f);
let _e6685 = select(0f, select(2f, _e6681, _e6683), (_e6670 > 0f));
let _e6686 = (_e6671 > 0f);
let _e6689 = select(2f, select(0f, _e6681, (_e6670 < 0f)), _e6686);
let _e6690 = (_e6670 > _e6664);
let _e6694 = ((_e6685 > _e6656) || ((_e6685 == _e6656) && _e6690));
let _e6695 = (_e6689 < _e6660);
let _e6696 = select(_e6656, _e6685, _e6694);
let _e6700 = select(_e6660, _e6689, _e6695);
let _e6704 = select(_e6664, _e6670, _e6690);
let _e6705 = (_e6671 > _e6666);
let _e6706 = select(_e6666, _e6671, _e6705);
let _e6710 = (_e4231 - _e1265);
let _e6711 = -(_e4881);
let _e6714 = (_e4881 - _e6710);
let _e6715 = (_e6710 - _e4881);
let _e6717 = select(_e6715, _e6714, (_e6714 > _e6715));
let _e6720 = (select(_e6711, _e4881, (_e4881 > _e6711)) / select(1e-30f, _e6717, (_e6717 > 1e-30f)));
let _e6722 = (_e6710 < 0f);
let _e6724 = select(0f, select(2f, _e6720, _e6722), (_e4881 > 0f));
let _e6725 = (_e6710 > 0f);
let _e6728 = select(2f, select(0f, _e6720, (_e4881 < 0f)), _e6725);
let _e6729 = (_e4881 > _e6704);
let _e6733 = ((_e6724 > _e6696) || ((_e6724 == _e6696) && _e6729));
let _e6734 = (_e6728 < _e6700);
let _e6735 = select(_e6696, _e6724, _e6733);
let _e6739 = select(_e6700, _e6728, _e6734);
let _e6743 = select(_e6704, _e4881, _e6729);
let _e6744 = (_e6710 > _e6706);
let _e6745 = select(_e6706, _e6710, _e6744);
let _e6749 = (_e1238 - _e4236);
let _e6750 = (_e1265 - _e4236);
let _e6751 = -(_e6749);
let _e6754 = (_e6749 - _e6750);
let _e6755 = (_e6750 - _e6749);
let _e6757 = select(_e6755, _e6754, (_e6754 > _e6755));
let _e6760 = (select(_e6751, _e6749, (_e6749 > _e6751)) / select(1e-30f, _e6757, (_e6757 > 1e-30f)));
let _e6762 = (_e6750 < 0f);
let _e6764 = select(0f, select(2f, _e6760, _e6762), (_e6749 > 0f));
let _e6765 = (_e6750 > 0f);
let _e6768 = select(2f, select(0f, _e6760, (_e6749 < 0f)), _e6765);
let _e6769 = (_e6749 > _e6743);
let _e6773 = ((_e6764 > _e6735) || ((_e6764 == _e6735) && _e6769));
let _e6774 = (_e6768 < _e6739);
let _e6775 = select(_e6735, _e6764, _e6773);
let _e6779 = select(_e6739, _e6768, _e6774);
let _e6783 = select(_e6743, _e6749, _e6769);
let _e6784 = (_e6750 > _e6745);
let _e6785 = select(_e6745, _e6750, _e6784);
let _e6789 = (_e4245 - _e1271);
let _e6790 = -(_e4910);
let _e6793 = (_e4910 - _e6789);
let _e6794 = (_e6789 - _e4910);
let _e6796 = select(_e6794, _e6793, (_e6793 > _e6794));
let _e6799 = (select(_e6790, _e4910, (_e4910 > _e6790)) / select(1e-30f, _e6796, (_e6796 > 1e-30f)));
let _e6801 = (_e6789 < 0f);
let _e6803 = select(0f, select(2f, _e6799, _e6801), (_e4910 > 0f));
let _e6804 = (_e6789 > 0f);
let _e6807 = select(2f, select(0f, _e6799, (_e4910 < 0f)), _e6804);
let _e6808 = (_e4910 > _e6783);
let _e6812 = ((_e6803 > _e6775) || ((_e6803 == _e6775) && _e6808));
let _e6813 = (_e6807 < _e6779);
let _e6814 = select(_e6775, _e6803, _e6812);
let _e6818 = select(_e6779, _e6807, _e6813);
let _e6822 = select(_e6783, _e4910, _e6808);
let _e6823 = (_e6789 > _e6785);
let _e6824 = select(_e6785, _e6789, _e6823);
let _e6828 = (_e1253 - _e4250);
let _e6829 = (_e1271 - _e4250);
let _e6830 = -(_e6828);
let _e6833 = (_e6828 - _e6829);
let _e6834 = (_e6829 - _e6828);
let _e6836 = select(_e6834, _e6833, (_e6833 > _e6834));
let _e6839 = (select(_e6830, _e6828, (_e6828 > _e6830)) / select(1e-30f, _e6836, (_e6836 > 1e-30f)));
let _e6841 = (_e6829 < 0f);
let _e6843 = select(0f, select(2f, _e6839, _e6841), (_e6828 > 0f));
let _e6844 = (_e6829 > 0f);
let _e6847 = select(2f, select(0f, _e6839, (_e6828 < 0f)), _e6844);
let _e6848 = (_e6828 > _e6822);
let _e6852 = ((_e6843 > _e6814) || ((_e6843 == _e6814) && _e6848));
let _e6853 = (_e6847 < _e6818);
let _e6854 = select(_e6814, _e6843, _e6852);
let _e6855 = select(select(select(select(select(select(0f, _e6611.member, _e6654), _e6611.member, _e6694), _e6619.member, _e6733), _e6619.member, _e6773), _e6627.member, _e6812), _e6627.member, _e6852);
let _e6856 = select(select(select(select(select(select(0f, _e6611.member_1, _e6654), _e6611.member_1, _e6694), _e6619.member_1, _e6733), _e6619.member_1, _e6773), _e6627.member_1, _e6812), _e6627.member_1, _e6852);
let _e6857 = select(select(select(select(select(select(1f, _e6611.member_2, _e6654), _e6611.member_2, _e6694), _e6619.member_2, _e6733), _e6619.member_2, _e6773), _e6627.member_2, _e6812), _e6627.member_2, _e6852);
let _e6859 = select(_e6818, _e6847, _e6853);
let _e6860 = select(select(select(select(select(select(0f, _e6611.member, _e6655), _e6611.member, _e6695), _e6619.member, _e6734), _e6619.member, _e6774), _e6627.member, _e6813), _e6627.member, _e6853);
let _e6861 = select(select(select(select(select(select(0f, _e6611.member_1, _e6655), _e6611.member_1, _e6695), _e6619.member_1, _e6734), _e6619.member_1, _e6774), _e6627.member_1, _e6813), _e6627.member_1, _e6853);
let _e6862 = select(select(select(select(select(select(1f, _e6611.member_2, _e6655), _e6611.member_2, _e6695), _e6619.member_2, _e6734), _e6619.member_2, _e6774), _e6627.member_2, _e6813), _e6627.member_2, _e6853);
let _e6864 = select(_e6822, _e6828, _e6848);
let _e6865 = (_e6829 > _e6824);
let _e6866 = select(_e6824, _e6829, _e6865);
let _e6867 = select(select(select(select(select(select(0f, _e6611.member, _e6650), _e6611.member, _e6690), _e6619.member, _e6729), _e6619.member, _e6769), _e6627.member, _e6808), _e6627.member, _e6848);
let _e6868 = select(select(select(select(select(select(0f, _e6611.member_1, _e6650), _e6611.member_1, _e6690), _e6619.member_1, _e6729), _e6619.member_1, _e6769), _e6627.member_1, _e6808), _e6627.member_1, _e6848);
let _e6869 = select(select(select(select(select(select(1f, _e6611.member_2, _e6650), _e6611.member_2, _e6690), _e6619.member_2, _e6729), _e6619.member_2, _e6769), _e6627.member_2, _e6808), _e6627.member_2, _e6848);
if _e4603 {
phi_16124_ = type_37(_e6854, vec3<f32>(_e6855, _e6856, _e6857), _e6859, vec3<f32>(_e6860, _e6861, _e6862), _e6864, _e6866, vec3<f32>(_e6867, _e6868, _e6869));
} else {
let _e6876 = (((_e6611.member * _e6611.member) + (_e6611.member_1 * _e6611.member_1)) + (_e6611.member_2 * _e6611.member_2));
let _e6879 = sqrt(select(0f, _e6876, (_e6876 > 0f)));
let _e6883 = global_1.member.member_16.member_1;
let _e6884 = (_e6883 != 0u);
let _e6888 = global_1.member.member_16.member;
let _e6908 = select(-1e6f, (((((_e6888.member.member * _e1180) + (_e6888.member.member_1 * _e1193)) + (_e6888.member.member_2 * _e1158)) + _e6888.member_1) * _e6879), _e6884);
let _e6909 = select(-1e6f, (((((_e6888.member.member * _e1203) + (_e6888.member.member_1 * _e1208)) + (_e6888.member.member_2 * _e1197)) + _e6888.member_1) * _e6879), _e6884);
let _e6914 = global_1.member.member_16.member.member;
let _e6918 = -(_e6908);
let _e6921 = (_e6908 - _e6909);
let _e6922 = (_e6909 - _e6908);
let _e6924 = select(_e6922, _e6921, (_e6921 > _e6922));
let _e6927 = (select(_e6918, _e6908, (_e6908 > _e6918)) / select(1e-30f, _e6924, (_e6924 > 1e-30f)));
let _e6931 = select(0f, select(2f, _e6927, (_e6909 < 0f)), (_e6908 > 0f));
let _e6935 = select(2f, select(0f, _e6927, (_e6908 < 0f)), (_e6909 > 0f));
let _e6936 = (_e6908 > _e6864);
let _e6940 = ((_e6931 > _e6854) || ((_e6931 == _e6854) && _e6936));
let _e6941 = (_e6935 < _e6859);
let _e6942 = select(_e6854, _e6931, _e6940);
let _e6946 = select(_e6859, _e6935, _e6941);
let _e6950 = select(_e6864, _e6908, _e6936);
let _e6952 = select(_e6866, _e6909, (_e6909 > _e6866));
let _e6959 = global_1.member.member_17.member_1;
let _e6960 = (_e6959 != 0u);
let _e6964 = global_1.member.member_17.member;
let _e6984 = select(-1e6f, (((((_e6964.member.member * _e1180) + (_e6964.member.member_1 * _e1193)) + (_e6964.member.member_2 * _e1158)) + _e6964.member_1) * _e6879), _e6960);
let _e6985 = select(-1e6f, (((((_e6964.member.member * _e1203) + (_e6964.member.member_1 * _e1208)) + (_e6964.member.member_2 * _e1197)) + _e6964.member_1) * _e6879), _e6960);
let _e6990 = global_1.member.member_17.member.member;
let _e6994 = -(_e6984);
let _e6997 = (_e6984 - _e6985);
let _e6998 = (_e6985 - _e6984);
let _e7000 = select(_e6998, _e6997, (_e6997 > _e6998));
let _e7003 = (select(_e6994, _e6984, (_e6984 > _e6994)) / select(1e-30f, _e7000, (_e7000 > 1e-30f)));
let _e7007 = select(0f, select(2f, _e7003, (_e6985 < 0f)), (_e6984 > 0f));
let _e7011 = select(2f, select(0f, _e7003, (_e6984 < 0f)), (_e6985 > 0f));
let _e7012 = (_e6984 > _e6950);
let _e7016 = ((_e7007 > _e6942) || ((_e7007 == _e6942) && _e7012));
let _e7017 = (_e7011 < _e6946);
let _e7018 = select(_e6942, _e7007, _e7016);
let _e7022 = select(_e6946, _e7011, _e7017);
let _e7026 = select(_e6950, _e6984, _e7012);
let _e7028 = select(_e6952, _e6985, (_e6985 > _e6952));
let _e7035 = global_1.member.member_18.member_1;
let _e7036 = (_e7035 != 0u);
let _e7040 = global_1.member.member_18.member;
let _e7060 = select(-1e6f, (((((_e7040.member.member * _e1180) + (_e7040.member.member_1 * _e1193)) + (_e7040.member.member_2 * _e1158)) + _e7040.member_1) * _e6879), _e7036);
let _e7061 = select(-1e6f, (((((_e7040.member.member * _e1203) + (_e7040.member.member_1 * _e1208)) + (_e7040.member.member_2 * _e1197)) + _e7040.member_1) * _e6879), _e7036);
let _e7066 = global_1.member.member_18.member.member;
let _e7070 = -(_e7060);
let _e7073 = (_e7060 - _e7061);
let _e7074 = (_e7061 - _e7060);
let _e7076 = select(_e7074, _e7073, (_e7073 > _e7074));
let _e7079 = (select(_e7070, _e7060, (_e7060 > _e7070)) / select(1e-30f, _e7076, (_e7076 > 1e-30f)));
let _e7083 = select(0f, select(2f, _e7079, (_e7061 < 0f)), (_e7060 > 0f));
let _e7087 = select(2f, select(0f, _e7079, (_e7060 < 0f)), (_e7061 > 0f));
let _e7088 = (_e7060 > _e7026);
let _e7092 = ((_e7083 > _e7018) || ((_e7083 == _e7018) && _e7088));
let _e7093 = (_e7087 < _e7022);
let _e7094 = select(_e7018, _e7083, _e7092);
let _e7098 = select(_e7022, _e7087, _e7093);
let _e7102 = select(_e7026, _e7060, _e7088);
let _e7104 = select(_e7028, _e7061, (_e7061 > _e7028));
let _e7111 = global_1.member.member_19.member_1;
let _e7112 = (_e7111 != 0u);
let _e7116 = global_1.member.member_19.member;
let _e7136 = select(-1e6f, (((((_e7116.member.member * _e1180) + (_e7116.member.member_1 * _e1193)) + (_e7116.member.member_2 * _e1158)) + _e7116.member_1) * _e6879), _e7112);
let _e7137 = select(-1e6f, (((((_e7116.member.member * _e1203) + (_e7116.member.member_1 * _e1208)) + (_e7116.member.member_2 * _e1197)) + _e7116.member_1) * _e6879), _e7112);
let _e7142 = global_1.member.member_19.member.member;
let _e7146 = -(_e7136);
let _e7149 = (_e7136 - _e7137);
let _e7150 = (_e7137 - _e7136);
let _e7152 = select(_e7150, _e7149, (_e7149 > _e7150));
let _e7155 = (select(_e7146, _e7136, (_e7136 > _e7146)) / select(1e-30f, _e7152, (_e7152 > 1e-30f)));
let _e7159 = select(0f, select(2f, _e7155, (_e7137 < 0f)), (_e7136 > 0f));
let _e7163 = select(2f, select(0f, _e7155, (_e7136 < 0f)), (_e7137 > 0f));
let _e7164 = (_e7136 > _e7102);
let _e7168 = ((_e7159 > _e7094) || ((_e7159 == _e7094) && _e7164));
let _e7169 = (_e7163 < _e7098);
phi_16124_ = type_37(select(_e7094, _e7159, _e7168), vec3<f32>(select(select(select(select(_e6855, _e6914.member, _e6940), _e6990.member, _e7016), _e7066.member, _e7092), _e7142.member, _e7168), select(select(select(select(_e6856, _e6914.member_1, _e6940), _e6990.member_1, _e7016), _e7066.member_1, _e7092), _e7142.member_1, _e7168), select(select(select(select(_e6857, _e6914.member_2, _e6940), _e6990.member_2, _e7016), _e7066.member_2, _e7092), _e7142.member_2, _e7168)), select(_e7098, _e7163, _e7169), vec3<f32>(select(select(select(select(_e6860, _e6914.member, _e6941), _e6990.member, _e7017), _e7066.member, _e7093), _e7142.member, _e7169), select(select(select(select(_e6861, _e6914.member_1, _e6941), _e6990.member_1, _e7017), _e7066.member_1, _e7093), _e7142.member_1, _e7169), select(select(select(select(_e6862, _e6914.member_2, _e6941), _e6990.member_2, _e7017), _e7066.member_2, _e7093), _e7142.member_2, _e7169)), select(_e7102, _e7136, _e7164), select(_e7104, _e7137, (_e7137 > _e7104)), vec3<f32>(select(select(select(select(_e6867, _e6914.member, _e6936), _e6990.member, _e7012), _e7066.member, _e7088), _e7142.member, _e7164), select(select(select(select(_e6868, _e6914.member_1, _e6936), _e6990.member_1, _e7012), _e7066.member_1, _e7088), _e7142.member_1, _e7164), select(select(select(select(_e6869, _e6914.member_2, _e6936), _e6990.member_2, _e7012), _e7066.member_2, _e7088), _e7142.member_2, _e7164)));
}
let _e7189 = phi_16124_;
let _e7191 = (_e7189.member_4 < 0f);
let _e7193 = (_e7189.member_5 < 0f);
let _e7194 = (_e7191 != _e7193);
if _e7191 {
phi_16137_ = _e7189.member_3;
phi_16138_ = _e7189.member_2;
} else {
phi_16137_ = _e7189.member_1;
phi_16138_ = _e7189.member;
}
let _e7200 = phi_16137_;
let _e7202 = phi_16138_;
let _e7211 = (((_e6611.member * _e6611.member) + (_e6611.member_1 * _e6611.member_1)) + (_e6611.member_2 * _e6611.member_2));
let _e7214 = sqrt(select(0f, _e7211, (_e7211 > 0f)));
let _e7215 = ((1.5f * _e1178) * _e7214);
let _e7220 = select(0f, _e7202, _e7194);
let _e7224 = (_e1180 + (_e4943 * _e7220));
let _e7225 = (_e1193 + (_e4944 * _e7220));
let _e7226 = (_e1158 + (_e4945 * _e7220));
let _e7232 = ((((_e1212.member.member * _e7224) + (_e1212.member.member_1 * _e7225)) + (_e1212.member.member_2 * _e7226)) + _e1212.member_1);
let _e7238 = ((((_e1227.member.member * _e7224) + (_e1227.member.member_1 * _e7225)) + (_e1227.member.member_2 * _e7226)) + _e1227.member_1);
let _e7244 = ((((_e1242.member.member * _e7224) + (_e1242.member.member_1 * _e7225)) + (_e1242.member.member_2 * _e7226)) + _e1242.member_1);
let _e7246 = select(_e4217, _e7232, (_e7232 > _e4217));
let _e7248 = select(_e4222, _e7246, (_e7246 < _e4222));
let _e7250 = select(_e4231, _e7238, (_e7238 > _e4231));
let _e7252 = select(_e4236, _e7250, (_e7250 < _e4236));
let _e7254 = select(_e4245, _e7244, (_e7244 > _e4245));
let _e7256 = select(_e4250, _e7254, (_e7254 < _e4250));
if _e4260 {
phi_16368_ = vec3<f32>(_e7248, _e7252, _e7256);
} else {
let _e7258 = (_e7248 + 0.5f);
let _e7259 = (_e4338 - 1f);
let _e7261 = select(0f, _e7258, (_e7258 > 0f));
let _e7263 = select(_e7259, _e7261, (_e7261 < _e7259));
let _e7270 = select(0i, select(select(i32(_e7263), i32(-2147483648), (_e7263 < -2147483600f)), 2147483647i, (_e7263 > 2147483500f)), (_e7263 == _e7263));
let _e7276 = (_e7252 + 0.5f);
let _e7277 = (_e4359 - 1f);
let _e7279 = select(0f, _e7276, (_e7276 > 0f));
let _e7281 = select(_e7277, _e7279, (_e7279 < _e7277));
let _e7288 = select(0i, select(select(i32(_e7281), i32(-2147483648), (_e7281 < -2147483600f)), 2147483647i, (_e7281 > 2147483500f)), (_e7281 == _e7281));
let _e7294 = (_e7256 + 0.5f);
let _e7295 = (_e4380 - 1f);
let _e7297 = select(0f, _e7294, (_e7294 > 0f));
let _e7299 = select(_e7295, _e7297, (_e7297 < _e7295));
let _e7306 = select(0i, select(select(i32(_e7299), i32(-2147483648), (_e7299 < -2147483600f)), 2147483647i, (_e7299 > 2147483500f)), (_e7299 == _e7299));
phi_16368_ = vec3<f32>(f32((_e7270 - select(0i, 1i, (_e7263 < f32(_e7270))))), f32((_e7288 - select(0i, 1i, (_e7281 < f32(_e7288))))), f32((_e7306 - select(0i, 1i, (_e7299 < f32(_e7306))))));
}
let _e7314 = phi_16368_;
let _e7317 = select(-1f, _e7314.x, (_e7314.x > -1f));
let _e7319 = select(_e4338, _e7317, (_e7317 < _e4338));
let _e7326 = select(0i, select(select(i32(_e7319), i32(-2147483648), (_e7319 < -2147483600f)), 2147483647i, (_e7319 > 2147483500f)), (_e7319 == _e7319));
let _e7330 = (_e7326 - select(0i, 1i, (_e7319 < f32(_e7326))));
let _e7333 = select(-1f, _e7314.y, (_e7314.y > -1f));
let _e7335 = select(_e4359, _e7333, (_e7333 < _e4359));
let _e7342 = select(0i, select(select(i32(_e7335), i32(-2147483648), (_e7335 < -2147483600f)), 2147483647i, (_e7335 > 2147483500f)), (_e7335 == _e7335));
let _e7346 = (_e7342 - select(0i, 1i, (_e7335 < f32(_e7342))));
let _e7349 = select(-1f, _e7314.z, (_e7314.z > -1f));
let _e7351 = select(_e4380, _e7349, (_e7349 < _e4380));
let _e7358 = select(0i, select(select(i32(_e7351), i32(-2147483648), (_e7351 < -2147483600f)), 2147483647i, (_e7351 > 2147483500f)), (_e7351 == _e7351));
let _e7362 = (_e7358 - select(0i, 1i, (_e7351 < f32(_e7358))));
let _e7365 = (_e7346 + 1i);
let _e7370 = (_e7362 + 1i);
let _e7373 = (_e7330 - 1i);
let _e7378 = (_e7330 + 1i);
let _e7381 = (_e7330 + 2i);
let _e7384 = (select(0i, _e7346, (_e7346 > 0i)) * _e4399);
let _e7385 = (select(_e4411, _e7365, (_e7365 < _e4411)) * _e4399);
let _e7386 = (select(0i, _e7362, (_e7362 > 0i)) * _e4403);
let _e7387 = (select(_e4424, _e7370, (_e7370 < _e4424)) * _e4403);
local_2 = type_30(array<i32, 4>(select(0i, _e7373, (_e7373 > 0i)), select(0i, _e7330, (_e7330 > 0i)), select(_e4437, _e7378, (_e7378 < _e4437)), select(_e4437, _e7381, (_e7381 < _e4437))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_3 = (_e7314 - vec3<f32>(f32(_e7330), f32(_e7346), f32(_e7362)));
let _e7396 = (_e7386 + _e7384);
let _e7399 = local_2.member[1u];
let _e7400 = (_e7396 + _e7399);
let _e7402 = select(_e4467, _e7400, (_e7400 < _e4467));
let _e7407 = global_2.member[bitcast<u32>(select(0i, _e7402, (_e7402 > 0i)))];
let _e7408 = bitcast<f32>(_e7407);
let _e7411 = local_2.member[2u];
let _e7412 = (_e7396 + _e7411);
let _e7414 = select(_e4467, _e7412, (_e7412 < _e4467));
let _e7419 = global_2.member[bitcast<u32>(select(0i, _e7414, (_e7414 > 0i)))];
let _e7421 = local_3[0u];
let _e7424 = (_e7408 + ((bitcast<f32>(_e7419) - _e7408) * _e7421));
let _e7425 = (_e7386 + _e7385);
let _e7426 = local_2.member[1u];
let _e7427 = (_e7425 + _e7426);
let _e7429 = select(_e4467, _e7427, (_e7427 < _e4467));
let _e7434 = global_2.member[bitcast<u32>(select(0i, _e7429, (_e7429 > 0i)))];
let _e7435 = bitcast<f32>(_e7434);
let _e7436 = local_2.member[2u];
let _e7437 = (_e7425 + _e7436);
let _e7439 = select(_e4467, _e7437, (_e7437 < _e4467));
let _e7444 = global_2.member[bitcast<u32>(select(0i, _e7439, (_e7439 > 0i)))];
let _e7446 = local_3[0u];
let _e7451 = local_3[1u];
let _e7454 = (_e7424 + (((_e7435 + ((bitcast<f32>(_e7444) - _e7435) * _e7446)) - _e7424) * _e7451));
let _e7455 = (_e7387 + _e7384);
let _e7456 = local_2.member[1u];
let _e7457 = (_e7455 + _e7456);
let _e7459 = select(_e4467, _e7457, (_e7457 < _e4467));
let _e7464 = global_2.member[bitcast<u32>(select(0i, _e7459, (_e7459 > 0i)))];
let _e7465 = bitcast<f32>(_e7464);
let _e7466 = local_2.member[2u];
let _e7467 = (_e7455 + _e7466);
let _e7469 = select(_e4467, _e7467, (_e7467 < _e4467));
let _e7474 = global_2.member[bitcast<u32>(select(0i, _e7469, (_e7469 > 0i)))];
let _e7476 = local_3[0u];
let _e7479 = (_e7465 + ((bitcast<f32>(_e7474) - _e7465) * _e7476));
let _e7480 = (_e7387 + _e7385);
let _e7481 = local_2.member[1u];
let _e7482 = (_e7480 + _e7481);
let _e7484 = select(_e4467, _e7482, (_e7482 < _e4467));
let _e7489 = global_2.member[bitcast<u32>(select(0i, _e7484, (_e7484 > 0i)))];
let _e7490 = bitcast<f32>(_e7489);
let _e7491 = local_2.member[2u];
let _e7492 = (_e7480 + _e7491);
let _e7494 = select(_e4467, _e7492, (_e7492 < _e4467));
let _e7499 = global_2.member[bitcast<u32>(select(0i, _e7494, (_e7494 > 0i)))];
let _e7501 = local_3[0u];
let _e7505 = local_3[1u];
let _e7510 = local_3[2u];
let _e7515 = (((_e7454 + (((_e7479 + (((_e7490 + ((bitcast<f32>(_e7499) - _e7490) * _e7501)) - _e7479) * _e7505)) - _e7454) * _e7510)) - _e4584) * _e4588);
let _e7517 = select(_e4591, _e7515, (_e7515 > _e4591));
local = select(1e9f, _e7517, (_e7517 < 1e9f));
let _e7520 = local;
local_1 = _e7520;
let _e7521 = local_1;
let _e7523 = (bitcast<i32>(_e177) - 1i);
let _e7525 = select(_e7523, 263197i, (263197i < _e7523));
let _e7530 = global_3.member[bitcast<u32>(select(0i, _e7525, (_e7525 > 0i)))];
let _e7533 = select(_e7523, 263198i, (263198i < _e7523));
let _e7538 = global_3.member[bitcast<u32>(select(0i, _e7533, (_e7533 > 0i)))];
let _e7541 = select(_e7523, 263199i, (263199i < _e7523));
let _e7546 = global_3.member[bitcast<u32>(select(0i, _e7541, (_e7541 > 0i)))];
let _e7547 = bitcast<f32>(_e7546);
let _e7549 = ((_e7521 - bitcast<f32>(_e7530)) * bitcast<f32>(_e7538));
let _e7551 = select(0f, _e7549, (_e7549 > 0f));
let _e7554 = local_1;
let _e7556 = select(_e7523, 263200i, (263200i < _e7523));
let _e7561 = global_3.member[bitcast<u32>(select(0i, _e7556, (_e7556 > 0i)))];
let _e7564 = select(_e7523, 263201i, (263201i < _e7523));
let _e7569 = global_3.member[bitcast<u32>(select(0i, _e7564, (_e7564 > 0i)))];
let _e7572 = select(_e7523, 263202i, (263202i < _e7523));
let _e7577 = global_3.member[bitcast<u32>(select(0i, _e7572, (_e7572 > 0i)))];
let _e7578 = bitcast<f32>(_e7577);
let _e7580 = ((_e7554 - bitcast<f32>(_e7561)) * bitcast<f32>(_e7569));
let _e7582 = select(0f, _e7580, (_e7580 > 0f));
let _e7586 = local_1;
let _e7588 = select(_e7523, 263203i, (263203i < _e7523));
let _e7593 = global_3.member[bitcast<u32>(select(0i, _e7588, (_e7588 > 0i)))];
let _e7596 = select(_e7523, 263204i, (263204i < _e7523));
let _e7601 = global_3.member[bitcast<u32>(select(0i, _e7596, (_e7596 > 0i)))];
let _e7604 = select(_e7523, 263205i, (263205i < _e7523));
let _e7609 = global_3.member[bitcast<u32>(select(0i, _e7604, (_e7604 > 0i)))];
let _e7610 = bitcast<f32>(_e7609);
let _e7612 = ((_e7586 - bitcast<f32>(_e7593)) * bitcast<f32>(_e7601));
let _e7614 = select(0f, _e7612, (_e7612 > 0f));
let _e7617 = local_1;
let _e7619 = select(_e7523, 263206i, (263206i < _e7523));
let _e7624 = global_3.member[bitcast<u32>(select(0i, _e7619, (_e7619 > 0i)))];
let _e7627 = select(_e7523, 263207i, (263207i < _e7523));
let _e7632 = global_3.member[bitcast<u32>(select(0i, _e7627, (_e7627 > 0i)))];
let _e7635 = select(_e7523, 263208i, (263208i < _e7523));
let _e7640 = global_3.member[bitcast<u32>(select(0i, _e7635, (_e7635 > 0i)))];
let _e7641 = bitcast<f32>(_e7640);
let _e7643 = ((_e7617 - bitcast<f32>(_e7624)) * bitcast<f32>(_e7632));
let _e7645 = select(0f, _e7643, (_e7643 > 0f));
let _e7649 = ((select(_e7547, _e7551, (_e7551 < _e7547)) + select(_e7578, _e7582, (_e7582 < _e7578))) + (select(_e7610, _e7614, (_e7614 < _e7610)) + select(_e7641, _e7645, (_e7645 < _e7641))));
let _e7651 = select(0f, _e7649, (_e7649 > 0f));
let _e7653 = select(1023f, _e7651, (_e7651 < 1023f));
let _e7660 = select(0i, select(select(i32(_e7653), i32(-2147483648), (_e7653 < -2147483600f)), 2147483647i, (_e7653 > 2147483500f)), (_e7653 == _e7653));
let _e7664 = (_e7660 - select(0i, 1i, (_e7653 < f32(_e7660))));
let _e7665 = (262147i + _e7664);
let _e7667 = select(_e7523, _e7665, (_e7665 < _e7523));
let _e7673 = global_3.member[bitcast<u32>(select(0i, _e7667, (_e7667 > 0i)))];
let _e7683 = select(_e7523, 262146i, (262146i < _e7523));
let _e7689 = global_3.member[bitcast<u32>(select(0i, _e7683, (_e7683 > 0i)))];
let _e7693 = select(_e7523, 262144i, (262144i < _e7523));
let _e7699 = global_3.member[bitcast<u32>(select(0i, _e7693, (_e7693 > 0i)))];
let _e7702 = select(_e7523, 262145i, (262145i < _e7523));
let _e7708 = global_3.member[bitcast<u32>(select(0i, _e7702, (_e7702 > 0i)))];
let _e7715 = ((bitcast<f32>(_e7699) + (f32(bitcast<i32>((_e7673 >> bitcast<u32>(12u)))) * bitcast<f32>(_e7708))) + ((f32((bitcast<i32>((_e7673 & 4095u)) - 2048i)) * bitcast<f32>(_e7689)) * (_e7649 - f32(_e7664))));
let _e7719 = select(_e7189.member_6.x, _e7200.x, _e7194);
let _e7722 = select(_e7189.member_6.y, _e7200.y, _e7194);
let _e7725 = select(_e7189.member_6.z, _e7200.z, _e7194);
let _e7726 = select(1f, _e7715, _e7193);
let _e7731 = (((_e7719 * _e7719) + (_e7722 * _e7722)) + (_e7725 * _e7725));
let _e7734 = sqrt(select(0f, _e7731, (_e7731 > 0f)));
let _e7737 = (1f / select(1e-20f, _e7734, (_e7734 > 1e-20f)));
let _e7738 = (_e7719 * _e7737);
let _e7739 = (_e7722 * _e7737);
let _e7740 = (_e7725 * _e7737);
let _e7745 = (((_e245 * _e7738) + (_e256 * _e7739)) + (_e267 * _e7740));
let _e7750 = (((_e245 * _e245) + (_e256 * _e256)) + (_e267 * _e267));
let _e7752 = ((_e7726 * _e7726) - _e7750);
let _e7753 = (_e7745 * _e7745);
let _e7754 = (_e7753 + _e7752);
let _e7757 = sqrt(select(0f, _e7754, (_e7754 > 0f)));
let _e7761 = (_e7754 <= 0f);
let _e7764 = select((select(_e7757, -(_e7757), (_e7745 < 0f)) - _e7745), (-2f * _e7745), _e7761);
let _e7765 = (_e7752 == 0f);
let _e7776 = (_e7761 && (_e7752 != 0f));
let _e7782 = (!(_e7194) && (_e7776 || (_e7753 < ((0.1f * 0.1f) * _e7750))));
let _e7784 = select(1e-12f, _e7750, (_e7750 > 1e-12f));
let _e7788 = (_e7726 / sqrt(select(0f, _e7784, (_e7784 > 0f))));
let _e7800 = ((_e7194 || (bitcast<f32>((bitcast<u32>(_e7189.member_4) & 2147483647u)) < select(1f, _e7215, (_e7215 < 1f)))) && (_e7715 != 1f));
let _e7801 = select(_e245, select(select(select((_e245 + (_e7738 * _e7764)), _e245, _e7765), _e245, _e7776), (_e245 * _e7788), _e7782), _e7800);
let _e7802 = select(_e256, select(select(select((_e256 + (_e7739 * _e7764)), _e256, _e7765), _e256, _e7776), (_e256 * _e7788), _e7782), _e7800);
let _e7803 = select(_e267, select(select(select((_e267 + (_e7740 * _e7764)), _e267, _e7765), _e267, _e7776), (_e267 * _e7788), _e7782), _e7800);
let _e7815 = global_1.member.member_7.member_2;
let _e7818 = (_e7815 / select(1e-6f, _e7803, (_e7803 > 1e-6f)));
let _e7822 = (_e1203 + (_e7801 * _e7818));
let _e7823 = (_e1208 + (_e7802 * _e7818));
let _e7824 = (_e1197 + (_e7803 * _e7818));
let _e7830 = ((((_e1212.member.member * _e7822) + (_e1212.member.member_1 * _e7823)) + (_e1212.member.member_2 * _e7824)) + _e1212.member_1);
let _e7836 = ((((_e1227.member.member * _e7822) + (_e1227.member.member_1 * _e7823)) + (_e1227.member.member_2 * _e7824)) + _e1227.member_1);
let _e7842 = ((((_e1242.member.member * _e7822) + (_e1242.member.member_1 * _e7823)) + (_e1242.member.member_2 * _e7824)) + _e1242.member_1);
let _e7843 = (_e4217 - _e7830);
let _e7844 = -(_e6631);
let _e7847 = (_e6631 - _e7843);
let _e7848 = (_e7843 - _e6631);
let _e7850 = select(_e7848, _e7847, (_e7847 > _e7848));
let _e7853 = (select(_e7844, _e6631, (_e6631 > _e7844)) / select(1e-30f, _e7850, (_e7850 > 1e-30f)));
let _e7856 = select(0f, select(2f, _e7853, (_e7843 < 0f)), _e6646);
let _e7859 = select(2f, select(0f, _e7853, _e6643), (_e7843 > 0f));
let _e7863 = ((_e7856 > -1f) || ((_e7856 == -1f) && _e6665));
let _e7864 = (_e7859 < 2f);
let _e7865 = select(-1f, _e7856, _e7863);
let _e7869 = select(2f, _e7859, _e7864);
let _e7874 = select(-1e30f, _e7843, (_e7843 > -1e30f));
let _e7878 = (_e7830 - _e4222);
let _e7879 = -(_e6671);
let _e7882 = (_e6671 - _e7878);
let _e7883 = (_e7878 - _e6671);
let _e7885 = select(_e7883, _e7882, (_e7882 > _e7883));
let _e7888 = (select(_e7879, _e6671, (_e6671 > _e7879)) / select(1e-30f, _e7885, (_e7885 > 1e-30f)));
let _e7891 = select(0f, select(2f, _e7888, (_e7878 < 0f)), _e6686);
let _e7894 = select(2f, select(0f, _e7888, _e6683), (_e7878 > 0f));
let _e7898 = ((_e7891 > _e7865) || ((_e7891 == _e7865) && _e6705));
let _e7899 = (_e7894 < _e7869);
let _e7900 = select(_e7865, _e7891, _e7898);
let _e7904 = select(_e7869, _e7894, _e7899);
let _e7909 = select(_e7874, _e7878, (_e7878 > _e7874));
let _e7913 = (_e4231 - _e7836);
let _e7914 = -(_e6710);
let _e7917 = (_e6710 - _e7913);
let _e7918 = (_e7913 - _e6710);
let _e7920 = select(_e7918, _e7917, (_e7917 > _e7918));
let _e7923 = (select(_e7914, _e6710, (_e6710 > _e7914)) / select(1e-30f, _e7920, (_e7920 > 1e-30f)));
let _e7926 = select(0f, select(2f, _e7923, (_e7913 < 0f)), _e6725);
let _e7929 = select(2f, select(0f, _e7923, _e6722), (_e7913 > 0f));
let _e7933 = ((_e7926 > _e7900) || ((_e7926 == _e7900) && _e6744));
let _e7934 = (_e7929 < _e7904);
let _e7935 = select(_e7900, _e7926, _e7933);
let _e7939 = select(_e7904, _e7929, _e7934);
let _e7944 = select(_e7909, _e7913, (_e7913 > _e7909));
let _e7948 = (_e7836 - _e4236);
let _e7949 = -(_e6750);
let _e7952 = (_e6750 - _e7948);
let _e7953 = (_e7948 - _e6750);
let _e7955 = select(_e7953, _e7952, (_e7952 > _e7953));
let _e7958 = (select(_e7949, _e6750, (_e6750 > _e7949)) / select(1e-30f, _e7955, (_e7955 > 1e-30f)));
let _e7961 = select(0f, select(2f, _e7958, (_e7948 < 0f)), _e6765);
let _e7964 = select(2f, select(0f, _e7958, _e6762), (_e7948 > 0f));
let _e7968 = ((_e7961 > _e7935) || ((_e7961 == _e7935) && _e6784));
let _e7969 = (_e7964 < _e7939);
let _e7970 = select(_e7935, _e7961, _e7968);
let _e7974 = select(_e7939, _e7964, _e7969);
let _e7979 = select(_e7944, _e7948, (_e7948 > _e7944));
let _e7983 = (_e4245 - _e7842);
let _e7984 = -(_e6789);
let _e7987 = (_e6789 - _e7983);
let _e7988 = (_e7983 - _e6789);
let _e7990 = select(_e7988, _e7987, (_e7987 > _e7988));
let _e7993 = (select(_e7984, _e6789, (_e6789 > _e7984)) / select(1e-30f, _e7990, (_e7990 > 1e-30f)));
let _e7996 = select(0f, select(2f, _e7993, (_e7983 < 0f)), _e6804);
let _e7999 = select(2f, select(0f, _e7993, _e6801), (_e7983 > 0f));
let _e8003 = ((_e7996 > _e7970) || ((_e7996 == _e7970) && _e6823));
let _e8004 = (_e7999 < _e7974);
let _e8005 = select(_e7970, _e7996, _e8003);
let _e8009 = select(_e7974, _e7999, _e8004);
let _e8014 = select(_e7979, _e7983, (_e7983 > _e7979));
let _e8018 = (_e7842 - _e4250);
let _e8019 = -(_e6829);
let _e8022 = (_e6829 - _e8018);
let _e8023 = (_e8018 - _e6829);
let _e8025 = select(_e8023, _e8022, (_e8022 > _e8023));
let _e8028 = (select(_e8019, _e6829, (_e6829 > _e8019)) / select(1e-30f, _e8025, (_e8025 > 1e-30f)));
let _e8031 = select(0f, select(2f, _e8028, (_e8018 < 0f)), _e6844);
let _e8034 = select(2f, select(0f, _e8028, _e6841), (_e8018 > 0f));
let _e8038 = ((_e8031 > _e8005) || ((_e8031 == _e8005) && _e6865));
let _e8039 = (_e8034 < _e8009);
let _e8040 = select(_e8005, _e8031, _e8038);
let _e8041 = select(select(select(select(select(select(0f, _e6611.member, _e7863), _e6611.member, _e7898), _e6619.member, _e7933), _e6619.member, _e7968), _e6627.member, _e8003), _e6627.member, _e8038);
let _e8042 = select(select(select(select(select(select(0f, _e6611.member_1, _e7863), _e6611.member_1, _e7898), _e6619.member_1, _e7933), _e6619.member_1, _e7968), _e6627.member_1, _e8003), _e6627.member_1, _e8038);
let _e8043 = select(select(select(select(select(select(1f, _e6611.member_2, _e7863), _e6611.member_2, _e7898), _e6619.member_2, _e7933), _e6619.member_2, _e7968), _e6627.member_2, _e8003), _e6627.member_2, _e8038);
let _e8045 = select(_e8009, _e8034, _e8039);
let _e8046 = select(select(select(select(select(select(0f, _e6611.member, _e7864), _e6611.member, _e7899), _e6619.member, _e7934), _e6619.member, _e7969), _e6627.member, _e8004), _e6627.member, _e8039);
let _e8047 = select(select(select(select(select(select(0f, _e6611.member_1, _e7864), _e6611.member_1, _e7899), _e6619.member_1, _e7934), _e6619.member_1, _e7969), _e6627.member_1, _e8004), _e6627.member_1, _e8039);
let _e8048 = select(select(select(select(select(select(1f, _e6611.member_2, _e7864), _e6611.member_2, _e7899), _e6619.member_2, _e7934), _e6619.member_2, _e7969), _e6627.member_2, _e8004), _e6627.member_2, _e8039);
let _e8051 = select(_e8014, _e8018, (_e8018 > _e8014));
let _e8052 = select(select(select(select(select(select(0f, _e6611.member, _e6665), _e6611.member, _e6705), _e6619.member, _e6744), _e6619.member, _e6784), _e6627.member, _e6823), _e6627.member, _e6865);
let _e8053 = select(select(select(select(select(select(0f, _e6611.member_1, _e6665), _e6611.member_1, _e6705), _e6619.member_1, _e6744), _e6619.member_1, _e6784), _e6627.member_1, _e6823), _e6627.member_1, _e6865);
let _e8054 = select(select(select(select(select(select(1f, _e6611.member_2, _e6665), _e6611.member_2, _e6705), _e6619.member_2, _e6744), _e6619.member_2, _e6784), _e6627.member_2, _e6823), _e6627.member_2, _e6865);
if _e4603 {
phi_18863_ = type_37(_e8040, vec3<f32>(_e8041, _e8042, _e8043), _e8045, vec3<f32>(_e8046, _e8047, _e8048), _e6866, _e8051, vec3<f32>(_e8052, _e8053, _e8054));
} else {
let _e8060 = global_1.member.member_16.member_1;
let _e8061 = (_e8060 != 0u);
let _e8065 = global_1.member.member_16.member;
let _e8085 = select(-1e6f, (((((_e8065.member.member * _e1203) + (_e8065.member.member_1 * _e1208)) + (_e8065.member.member_2 * _e1197)) + _e8065.member_1) * _e7214), _e8061);
let _e8086 = select(-1e6f, (((((_e8065.member.member * _e7822) + (_e8065.member.member_1 * _e7823)) + (_e8065.member.member_2 * _e7824)) + _e8065.member_1) * _e7214), _e8061);
let _e8091 = global_1.member.member_16.member.member;
let _e8095 = -(_e8085);
let _e8098 = (_e8085 - _e8086);
let _e8099 = (_e8086 - _e8085);
let _e8101 = select(_e8099, _e8098, (_e8098 > _e8099));
let _e8104 = (select(_e8095, _e8085, (_e8085 > _e8095)) / select(1e-30f, _e8101, (_e8101 > 1e-30f)));
let _e8108 = select(0f, select(2f, _e8104, (_e8086 < 0f)), (_e8085 > 0f));
let _e8112 = select(2f, select(0f, _e8104, (_e8085 < 0f)), (_e8086 > 0f));
let _e8113 = (_e8085 > _e6866);
let _e8117 = ((_e8108 > _e8040) || ((_e8108 == _e8040) && _e8113));
let _e8118 = (_e8112 < _e8045);
let _e8119 = select(_e8040, _e8108, _e8117);
let _e8123 = select(_e8045, _e8112, _e8118);
let _e8127 = select(_e6866, _e8085, _e8113);
let _e8129 = select(_e8051, _e8086, (_e8086 > _e8051));
let _e8136 = global_1.member.member_17.member_1;
let _e8137 = (_e8136 != 0u);
let _e8141 = global_1.member.member_17.member;
let _e8161 = select(-1e6f, (((((_e8141.member.member * _e1203) + (_e8141.member.member_1 * _e1208)) + (_e8141.member.member_2 * _e1197)) + _e8141.member_1) * _e7214), _e8137);
let _e8162 = select(-1e6f, (((((_e8141.member.member * _e7822) + (_e8141.member.member_1 * _e7823)) + (_e8141.member.member_2 * _e7824)) + _e8141.member_1) * _e7214), _e8137);
let _e8167 = global_1.member.member_17.member.member;
let _e8171 = -(_e8161);
let _e8174 = (_e8161 - _e8162);
let _e8175 = (_e8162 - _e8161);
let _e8177 = select(_e8175, _e8174, (_e8174 > _e8175));
let _e8180 = (select(_e8171, _e8161, (_e8161 > _e8171)) / select(1e-30f, _e8177, (_e8177 > 1e-30f)));
let _e8184 = select(0f, select(2f, _e8180, (_e8162 < 0f)), (_e8161 > 0f));
let _e8188 = select(2f, select(0f, _e8180, (_e8161 < 0f)), (_e8162 > 0f));
let _e8189 = (_e8161 > _e8127);
let _e8193 = ((_e8184 > _e8119) || ((_e8184 == _e8119) && _e8189));
let _e8194 = (_e8188 < _e8123);
let _e8195 = select(_e8119, _e8184, _e8193);
let _e8199 = select(_e8123, _e8188, _e8194);
let _e8203 = select(_e8127, _e8161, _e8189);
let _e8205 = select(_e8129, _e8162, (_e8162 > _e8129));
let _e8212 = global_1.member.member_18.member_1;
let _e8213 = (_e8212 != 0u);
let _e8217 = global_1.member.member_18.member;
let _e8237 = select(-1e6f, (((((_e8217.member.member * _e1203) + (_e8217.member.member_1 * _e1208)) + (_e8217.member.member_2 * _e1197)) + _e8217.member_1) * _e7214), _e8213);
let _e8238 = select(-1e6f, (((((_e8217.member.member * _e7822) + (_e8217.member.member_1 * _e7823)) + (_e8217.member.member_2 * _e7824)) + _e8217.member_1) * _e7214), _e8213);
let _e8243 = global_1.member.member_18.member.member;
let _e8247 = -(_e8237);
let _e8250 = (_e8237 - _e8238);
let _e8251 = (_e8238 - _e8237);
let _e8253 = select(_e8251, _e8250, (_e8250 > _e8251));
let _e8256 = (select(_e8247, _e8237, (_e8237 > _e8247)) / select(1e-30f, _e8253, (_e8253 > 1e-30f)));
let _e8260 = select(0f, select(2f, _e8256, (_e8238 < 0f)), (_e8237 > 0f));
let _e8264 = select(2f, select(0f, _e8256, (_e8237 < 0f)), (_e8238 > 0f));
let _e8265 = (_e8237 > _e8203);
let _e8269 = ((_e8260 > _e8195) || ((_e8260 == _e8195) && _e8265));
let _e8270 = (_e8264 < _e8199);
let _e8271 = select(_e8195, _e8260, _e8269);
let _e8275 = select(_e8199, _e8264, _e8270);
let _e8279 = select(_e8203, _e8237, _e8265);
let _e8281 = select(_e8205, _e8238, (_e8238 > _e8205));
let _e8288 = global_1.member.member_19.member_1;
let _e8289 = (_e8288 != 0u);
let _e8293 = global_1.member.member_19.member;
let _e8313 = select(-1e6f, (((((_e8293.member.member * _e1203) + (_e8293.member.member_1 * _e1208)) + (_e8293.member.member_2 * _e1197)) + _e8293.member_1) * _e7214), _e8289);
let _e8314 = select(-1e6f, (((((_e8293.member.member * _e7822) + (_e8293.member.member_1 * _e7823)) + (_e8293.member.member_2 * _e7824)) + _e8293.member_1) * _e7214), _e8289);
let _e8319 = global_1.member.member_19.member.member;
let _e8323 = -(_e8313);
let _e8326 = (_e8313 - _e8314);
let _e8327 = (_e8314 - _e8313);
let _e8329 = select(_e8327, _e8326, (_e8326 > _e8327));
let _e8332 = (select(_e8323, _e8313, (_e8313 > _e8323)) / select(1e-30f, _e8329, (_e8329 > 1e-30f)));
let _e8336 = select(0f, select(2f, _e8332, (_e8314 < 0f)), (_e8313 > 0f));
let _e8340 = select(2f, select(0f, _e8332, (_e8313 < 0f)), (_e8314 > 0f));
let _e8341 = (_e8313 > _e8279);
let _e8345 = ((_e8336 > _e8271) || ((_e8336 == _e8271) && _e8341));
let _e8346 = (_e8340 < _e8275);
phi_18863_ = type_37(select(_e8271, _e8336, _e8345), vec3<f32>(select(select(select(select(_e8041, _e8091.member, _e8117), _e8167.member, _e8193), _e8243.member, _e8269), _e8319.member, _e8345), select(select(select(select(_e8042, _e8091.member_1, _e8117), _e8167.member_1, _e8193), _e8243.member_1, _e8269), _e8319.member_1, _e8345), select(select(select(select(_e8043, _e8091.member_2, _e8117), _e8167.member_2, _e8193), _e8243.member_2, _e8269), _e8319.member_2, _e8345)), select(_e8275, _e8340, _e8346), vec3<f32>(select(select(select(select(_e8046, _e8091.member, _e8118), _e8167.member, _e8194), _e8243.member, _e8270), _e8319.member, _e8346), select(select(select(select(_e8047, _e8091.member_1, _e8118), _e8167.member_1, _e8194), _e8243.member_1, _e8270), _e8319.member_1, _e8346), select(select(select(select(_e8048, _e8091.member_2, _e8118), _e8167.member_2, _e8194), _e8243.member_2, _e8270), _e8319.member_2, _e8346)), select(_e8279, _e8313, _e8341), select(_e8281, _e8314, (_e8314 > _e8281)), vec3<f32>(select(select(select(select(_e8052, _e8091.member, _e8113), _e8167.member, _e8189), _e8243.member, _e8265), _e8319.member, _e8341), select(select(select(select(_e8053, _e8091.member_1, _e8113), _e8167.member_1, _e8189), _e8243.member_1, _e8265), _e8319.member_1, _e8341), select(select(select(select(_e8054, _e8091.member_2, _e8113), _e8167.member_2, _e8189), _e8243.member_2, _e8265), _e8319.member_2, _e8341)));
}
let _e8366 = phi_18863_;
let _e8375 = global_1.member.member_7.member_4;
let _e8378 = (_e4212.member_4.x * _e4844.member_2);
let _e8380 = (_e4212.member_4.y * _e4844.member_2);
let _e8382 = (_e4212.member_4.z * _e4844.member_2);
let _e8383 = (0.5f * (_e7818 * select(1f, (2f * (1f - _e7202)), (_e7194 && _e7193))));
let _e8387 = (_e7801 + (_e8378 * _e8383));
let _e8388 = (_e7802 + (_e8380 * _e8383));
let _e8389 = (_e7803 + (_e8382 * _e8383));
let _e8391 = (2f * _e7815);
let _e8393 = ((_e8389 * _e8389) + (_e8391 * _e8382));
let _e8397 = (_e8389 + sqrt(select(0f, _e8393, (_e8393 > 0f))));
let _e8401 = (select(0.5f, _e8366.member_2, (_e8366.member_2 < 1f)) * (_e8391 / select(1e-6f, _e8397, (_e8397 > 1e-6f))));
let _e8405 = (_e8387 + (_e8378 * _e8401));
let _e8406 = (_e8388 + (_e8380 * _e8401));
let _e8407 = (_e8389 + (_e8382 * _e8401));
let _e8411 = (_e8375 * _e8375);
let _e8413 = (_e8407 * _e8407);
let _e8421 = (((_e8389 <= 0f) || (_e8393 <= 0f)) || ((_e8407 <= 0f) || (_e8413 <= (_e8411 * (((_e8405 * _e8405) + (_e8406 * _e8406)) + _e8413)))));
let _e8435 = (_e7801 + ((_e4212.member_5.x * _e4844.member_2) * _e7815));
let _e8436 = (_e7802 + ((_e4212.member_5.y * _e4844.member_2) * _e7815));
let _e8437 = (_e7803 + ((_e4212.member_5.z * _e4844.member_2) * _e7815));
let _e8439 = (_e8437 * _e8437);
let _e8448 = ((_e4601 & 1u) != 0u);
let _e8453 = (select(_e8421, ((_e8437 <= 0f) || (_e8439 <= (_e8411 * (((_e8435 * _e8435) + (_e8436 * _e8436)) + _e8439)))), _e8448) || (_e7800 && ((_e7776 && _e7194) || (_e7194 && (_e7803 <= 0f)))));
phi_19015_ = vec3<f32>(select(select(select(_e8405, _e8387, _e8421), _e8435, _e8448), _e245, _e8453), select(select(select(_e8406, _e8388, _e8421), _e8436, _e8448), _e256, _e8453), select(select(select(_e8407, _e8389, _e8421), _e8437, _e8448), _e267, _e8453));
phi_19016_ = select(1f, 0f, _e8453);
} else {
phi_19015_ = vec3<f32>(_e245, _e256, _e267);
phi_19016_ = 1f;
}
let _e8460 = phi_19015_;
let _e8462 = phi_19016_;
let _e8464 = (_e6606 * _e8462);
global_4.member[_e202] = (_e213 * (_e6449.member_2.x * _e8464));
global_4.member[_e214] = (_e223 * (_e6449.member_2.y * _e8464));
global_4.member[_e225] = (_e234 * (_e6449.member_2.z * _e8464));
global_4.member[_e236] = _e8460.x;
global_4.member[_e247] = _e8460.y;
global_4.member[_e258] = _e8460.z;
global_4.member[_e269] = _e278;
global_4.member[_e280] = _e289;
global_4.member[_e291] = _e300;
}
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
