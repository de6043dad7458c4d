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
var phi_1672_: u32;
var phi_2045_: vec3<f32>;
var phi_7238_: type_34;
var phi_7585_: vec3<f32>;
var phi_8960_: vec3<f32>;
var phi_9373_: f32;
var phi_9374_: vec3<f32>;
var phi_9376_: type_35;
var phi_9522_: vec3<f32>;
var phi_10455_: type_36;
var phi_14399_: type_38;
var phi_14797_: f32;
var phi_16122_: type_37;
var phi_16135_: vec3<f32>;
var phi_16136_: f32;
var phi_16366_: vec3<f32>;
var phi_18861_: type_37;
var phi_19013_: vec3<f32>;
var phi_19014_: f32;
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
let _e954 = global_1.member.member_8.member_6;
let _e956 = select(_e491, _e474, (_e474 > _e491));
let _e958 = select(_e498, _e956, (_e956 < _e498));
let _e960 = select(_e506, _e480, (_e480 > _e506));
let _e962 = select(_e514, _e960, (_e960 < _e514));
let _e964 = select(_e522, _e486, (_e486 > _e522));
let _e966 = select(_e530, _e964, (_e964 < _e530));
let _e972 = bitcast<f32>((bitcast<u32>((_e474 - _e438)) & 2147483647u));
let _e975 = bitcast<f32>((bitcast<u32>((_e480 - _e453)) & 2147483647u));
let _e977 = select(_e975, _e972, (_e972 > _e975));
let _e980 = bitcast<f32>((bitcast<u32>((_e486 - _e468)) & 2147483647u));
let _e989 = bitcast<f32>((bitcast<u32>((_e474 - _e958)) & 2147483647u));
let _e992 = bitcast<f32>((bitcast<u32>((_e480 - _e962)) & 2147483647u));
let _e994 = select(_e992, _e989, (_e989 > _e992));
let _e997 = bitcast<f32>((bitcast<u32>((_e486 - _e966)) & 2147483647u));
let _e1005 = global_1.member.member_8.member_3.member;
let _e1006 = (_e958 + 0.5f);
let _e1007 = (_e1005 - 1f);
let _e1009 = select(0f, _e1006, (_e1006 > 0f));
let _e1011 = select(_e1007, _e1009, (_e1009 < _e1007));
let _e1018 = select(0i, select(select(i32(_e1011), i32(-2147483648), (_e1011 < -2147483600f)), 2147483647i, (_e1011 > 2147483500f)), (_e1011 == _e1011));
let _e1026 = global_1.member.member_8.member_14;
let _e1027 = (_e1026 & 31u);
let _e1034 = global_1.member.member_8.member_3.member_1;
let _e1035 = (_e962 + 0.5f);
let _e1036 = (_e1034 - 1f);
let _e1038 = select(0f, _e1035, (_e1035 > 0f));
let _e1040 = select(_e1036, _e1038, (_e1038 < _e1036));
let _e1047 = select(0i, select(select(i32(_e1040), i32(-2147483648), (_e1040 < -2147483600f)), 2147483647i, (_e1040 > 2147483500f)), (_e1040 == _e1040));
let _e1058 = global_1.member.member_8.member_3.member_2;
let _e1059 = (_e966 + 0.5f);
let _e1060 = (_e1058 - 1f);
let _e1062 = select(0f, _e1059, (_e1059 > 0f));
let _e1064 = select(_e1060, _e1062, (_e1062 < _e1060));
let _e1071 = select(0i, select(select(i32(_e1064), i32(-2147483648), (_e1064 < -2147483600f)), 2147483647i, (_e1064 > 2147483500f)), (_e1064 == _e1064));
let _e1082 = global_1.member.member_8.member_11.member;
let _e1088 = global_1.member.member_8.member_11.member_1;
let _e1093 = global_1.member.member_8.member_12;
let _e1099 = ((bitcast<i32>(_e1093) + ((_e1018 - select(0i, 1i, (_e1011 < f32(_e1018)))) >> bitcast<u32>(_e1027))) + (bitcast<i32>(_e1082) * (((_e1047 - select(0i, 1i, (_e1040 < f32(_e1047)))) >> bitcast<u32>(_e1027)) + (bitcast<i32>(_e1088) * ((_e1071 - select(0i, 1i, (_e1064 < f32(_e1071)))) >> bitcast<u32>(_e1027))))));
let _e1101 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e1103 = select(_e1101, _e1099, (_e1099 < _e1101));
let _e1109 = global_5.member[bitcast<u32>(select(0i, _e1103, (_e1103 > 0i)))];
phi_1672_ = select(select(7u, 3u, ((_e807 && (!(_e554) || _e944)) && ((_e846 & 1024u) == 0u))), 1u, (((_e846 & 64u) != 0u) || ((((select(_e980, _e977, (_e977 > _e980)) <= _e954) && ((select(_e997, _e994, (_e994 > _e997)) > _e954) || (_e1109 != 0u))) && true) && ((_e846 & 32u) != 0u))));
} else {
phi_1672_ = 7u;
}
let _e1122 = phi_1672_;
if (_e1122 > 1u) {
let _e1127 = bitcast<i32>(((_e197 * _e305) + _e195));
let _e1130 = (bitcast<i32>(_e179) - 1i);
let _e1132 = select(_e1130, _e1127, (_e1127 < _e1130));
let _e1138 = global_6.member[bitcast<u32>(select(0i, _e1132, (_e1132 > 0i)))];
let _e1139 = (bitcast<i32>(_e310) + _e1127);
let _e1141 = select(_e1130, _e1139, (_e1139 < _e1130));
let _e1147 = global_6.member[bitcast<u32>(select(0i, _e1141, (_e1141 > 0i)))];
let _e1149 = f32(bitcast<i32>(_e195));
let _e1151 = f32(bitcast<i32>(_e197));
let _e1157 = global_1.member.member_7.member;
let _e1161 = global_1.member.member_10.member_8;
let _e1162 = (_e1157 - _e1161);
let _e1166 = global_1.member.member_10.member_2;
let _e1170 = global_1.member.member_10.member_6;
let _e1177 = global_1.member.member_10.member_4;
let _e1179 = ((_e1166 + (_e1170 * _e1162)) + (((_e1149 - _e1138) + 0.5f) * _e1177));
let _e1183 = global_1.member.member_10.member_3;
let _e1187 = global_1.member.member_10.member_7;
let _e1192 = ((_e1183 + (_e1187 * _e1162)) + (((_e1151 - _e1147) + 0.5f) * _e1177));
let _e1196 = global_1.member.member_7.member_1;
let _e1197 = (_e1196 - _e1161);
let _e1202 = ((_e1166 + (_e1170 * _e1197)) + ((_e1149 + 0.5f) * _e1177));
let _e1207 = ((_e1183 + (_e1187 * _e1197)) + ((_e1151 + 0.5f) * _e1177));
let _e1211 = global_1.member.member_8.member;
let _e1222 = ((((_e1211.member.member * _e1179) + (_e1211.member.member_1 * _e1192)) + (_e1211.member.member_2 * _e1157)) + _e1211.member_1);
let _e1226 = global_1.member.member_8.member_1;
let _e1237 = ((((_e1226.member.member * _e1179) + (_e1226.member.member_1 * _e1192)) + (_e1226.member.member_2 * _e1157)) + _e1226.member_1);
let _e1241 = global_1.member.member_8.member_2;
let _e1252 = ((((_e1241.member.member * _e1179) + (_e1241.member.member_1 * _e1192)) + (_e1241.member.member_2 * _e1157)) + _e1241.member_1);
let _e1258 = ((((_e1211.member.member * _e1202) + (_e1211.member.member_1 * _e1207)) + (_e1211.member.member_2 * _e1196)) + _e1211.member_1);
let _e1264 = ((((_e1226.member.member * _e1202) + (_e1226.member.member_1 * _e1207)) + (_e1226.member.member_2 * _e1196)) + _e1226.member_1);
let _e1270 = ((((_e1241.member.member * _e1202) + (_e1241.member.member_1 * _e1207)) + (_e1241.member.member_2 * _e1196)) + _e1241.member_1);
let _e1272 = (_e187.member_2 == 5u);
let _e1278 = ((_e187.member_2 == 2u) || (_e187.member_2 == 7u));
let _e1279 = ((((_e187.member_2 == 1u) || _e1272) || (_e187.member_2 == 6u)) || _e1278);
if _e1279 {
let _e1284 = global_1.member.member_8.member_4.member;
let _e1289 = global_1.member.member_8.member_5.member;
let _e1291 = select(_e1284, _e1258, (_e1258 > _e1284));
let _e1293 = select(_e1289, _e1291, (_e1291 < _e1289));
let _e1298 = global_1.member.member_8.member_4.member_1;
let _e1303 = global_1.member.member_8.member_5.member_1;
let _e1305 = select(_e1298, _e1264, (_e1264 > _e1298));
let _e1307 = select(_e1303, _e1305, (_e1305 < _e1303));
let _e1312 = global_1.member.member_8.member_4.member_2;
let _e1317 = global_1.member.member_8.member_5.member_2;
let _e1319 = select(_e1312, _e1270, (_e1270 > _e1312));
let _e1321 = select(_e1317, _e1319, (_e1319 < _e1317));
let _e1326 = global_1.member.member_8.member_15;
if (_e1326 == 0u) {
phi_2045_ = vec3<f32>(_e1293, _e1307, _e1321);
} else {
let _e1328 = (_e1293 + 0.5f);
let _e1333 = global_1.member.member_8.member_3.member;
let _e1334 = (_e1333 - 1f);
let _e1336 = select(0f, _e1328, (_e1328 > 0f));
let _e1338 = select(_e1334, _e1336, (_e1336 < _e1334));
let _e1345 = select(0i, select(select(i32(_e1338), i32(-2147483648), (_e1338 < -2147483600f)), 2147483647i, (_e1338 > 2147483500f)), (_e1338 == _e1338));
let _e1351 = (_e1307 + 0.5f);
let _e1356 = global_1.member.member_8.member_3.member_1;
let _e1357 = (_e1356 - 1f);
let _e1359 = select(0f, _e1351, (_e1351 > 0f));
let _e1361 = select(_e1357, _e1359, (_e1359 < _e1357));
let _e1368 = select(0i, select(select(i32(_e1361), i32(-2147483648), (_e1361 < -2147483600f)), 2147483647i, (_e1361 > 2147483500f)), (_e1361 == _e1361));
let _e1374 = (_e1321 + 0.5f);
let _e1379 = global_1.member.member_8.member_3.member_2;
let _e1380 = (_e1379 - 1f);
let _e1382 = select(0f, _e1374, (_e1374 > 0f));
let _e1384 = select(_e1380, _e1382, (_e1382 < _e1380));
let _e1391 = select(0i, select(select(i32(_e1384), i32(-2147483648), (_e1384 < -2147483600f)), 2147483647i, (_e1384 > 2147483500f)), (_e1384 == _e1384));
phi_2045_ = vec3<f32>(f32((_e1345 - select(0i, 1i, (_e1338 < f32(_e1345))))), f32((_e1368 - select(0i, 1i, (_e1361 < f32(_e1368))))), f32((_e1391 - select(0i, 1i, (_e1384 < f32(_e1391))))));
}
let _e1399 = phi_2045_;
let _e1405 = global_1.member.member_8.member_3.member;
let _e1407 = select(-1f, _e1399.x, (_e1399.x > -1f));
let _e1409 = select(_e1405, _e1407, (_e1407 < _e1405));
let _e1416 = select(0i, select(select(i32(_e1409), i32(-2147483648), (_e1409 < -2147483600f)), 2147483647i, (_e1409 > 2147483500f)), (_e1409 == _e1409));
let _e1420 = (_e1416 - select(0i, 1i, (_e1409 < f32(_e1416))));
let _e1426 = global_1.member.member_8.member_3.member_1;
let _e1428 = select(-1f, _e1399.y, (_e1399.y > -1f));
let _e1430 = select(_e1426, _e1428, (_e1428 < _e1426));
let _e1437 = select(0i, select(select(i32(_e1430), i32(-2147483648), (_e1430 < -2147483600f)), 2147483647i, (_e1430 > 2147483500f)), (_e1430 == _e1430));
let _e1441 = (_e1437 - select(0i, 1i, (_e1430 < f32(_e1437))));
let _e1447 = global_1.member.member_8.member_3.member_2;
let _e1449 = select(-1f, _e1399.z, (_e1399.z > -1f));
let _e1451 = select(_e1447, _e1449, (_e1449 < _e1447));
let _e1458 = select(0i, select(select(i32(_e1451), i32(-2147483648), (_e1451 < -2147483600f)), 2147483647i, (_e1451 > 2147483500f)), (_e1451 == _e1451));
let _e1462 = (_e1458 - select(0i, 1i, (_e1451 < f32(_e1458))));
let _e1466 = global_1.member.member_8.member_9;
let _e1470 = global_1.member.member_8.member_10;
let _e1478 = (select(0i, select(select(i32(_e1426), i32(-2147483648), (_e1426 < -2147483600f)), 2147483647i, (_e1426 > 2147483500f)), (_e1426 == _e1426)) - 1i);
let _e1479 = (_e1441 - 1i);
let _e1484 = (_e1441 + 1i);
let _e1487 = (_e1441 + 2i);
let _e1497 = (select(0i, select(select(i32(_e1447), i32(-2147483648), (_e1447 < -2147483600f)), 2147483647i, (_e1447 > 2147483500f)), (_e1447 == _e1447)) - 1i);
let _e1498 = (_e1462 - 1i);
let _e1503 = (_e1462 + 1i);
let _e1506 = (_e1462 + 2i);
let _e1516 = (select(0i, select(select(i32(_e1405), i32(-2147483648), (_e1405 < -2147483600f)), 2147483647i, (_e1405 > 2147483500f)), (_e1405 == _e1405)) - 1i);
let _e1517 = (_e1420 - 1i);
let _e1522 = (_e1420 + 1i);
let _e1525 = (_e1420 + 2i);
let _e1528 = (select(0i, _e1479, (_e1479 > 0i)) * _e1466);
let _e1529 = (select(0i, _e1441, (_e1441 > 0i)) * _e1466);
let _e1530 = (select(_e1478, _e1484, (_e1484 < _e1478)) * _e1466);
let _e1531 = (select(_e1478, _e1487, (_e1487 < _e1478)) * _e1466);
let _e1532 = (select(0i, _e1498, (_e1498 > 0i)) * _e1470);
let _e1533 = (select(0i, _e1462, (_e1462 > 0i)) * _e1470);
let _e1534 = (select(_e1497, _e1503, (_e1503 < _e1497)) * _e1470);
let _e1535 = (select(_e1497, _e1506, (_e1506 < _e1497)) * _e1470);
local_28 = type_30(array<i32, 4>(select(0i, _e1517, (_e1517 > 0i)), select(0i, _e1420, (_e1420 > 0i)), select(_e1516, _e1522, (_e1522 < _e1516)), select(_e1516, _e1525, (_e1525 < _e1516))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_29 = (_e1399 - vec3<f32>(f32(_e1420), f32(_e1441), f32(_e1462)));
let _e1544 = (_e1533 + _e1529);
let _e1547 = local_28.member[0u];
let _e1548 = (_e1544 + _e1547);
let _e1550 = (bitcast<i32>(_e172) - 1i);
let _e1552 = select(_e1550, _e1548, (_e1548 < _e1550));
let _e1557 = global_2.member[bitcast<u32>(select(0i, _e1552, (_e1552 > 0i)))];
let _e1558 = bitcast<f32>(_e1557);
let _e1561 = local_28.member[1u];
let _e1562 = (_e1544 + _e1561);
let _e1564 = select(_e1550, _e1562, (_e1562 < _e1550));
let _e1569 = global_2.member[bitcast<u32>(select(0i, _e1564, (_e1564 > 0i)))];
let _e1570 = bitcast<f32>(_e1569);
let _e1573 = local_28.member[2u];
let _e1574 = (_e1544 + _e1573);
let _e1576 = select(_e1550, _e1574, (_e1574 < _e1550));
let _e1581 = global_2.member[bitcast<u32>(select(0i, _e1576, (_e1576 > 0i)))];
let _e1582 = bitcast<f32>(_e1581);
let _e1585 = local_28.member[3u];
let _e1586 = (_e1544 + _e1585);
let _e1588 = select(_e1550, _e1586, (_e1586 < _e1550));
let _e1593 = global_2.member[bitcast<u32>(select(0i, _e1588, (_e1588 > 0i)))];
let _e1595 = local_29[0u];
let _e1598 = (_e1558 + ((_e1570 - _e1558) * _e1595));
let _e1599 = local_29[0u];
let _e1602 = (_e1570 + ((_e1582 - _e1570) * _e1599));
let _e1603 = local_29[0u];
let _e1606 = (_e1582 + ((bitcast<f32>(_e1593) - _e1582) * _e1603));
let _e1607 = (_e1533 + _e1530);
let _e1608 = local_28.member[0u];
let _e1609 = (_e1607 + _e1608);
let _e1611 = select(_e1550, _e1609, (_e1609 < _e1550));
let _e1616 = global_2.member[bitcast<u32>(select(0i, _e1611, (_e1611 > 0i)))];
let _e1617 = bitcast<f32>(_e1616);
let _e1618 = local_28.member[1u];
let _e1619 = (_e1607 + _e1618);
let _e1621 = select(_e1550, _e1619, (_e1619 < _e1550));
let _e1626 = global_2.member[bitcast<u32>(select(0i, _e1621, (_e1621 > 0i)))];
let _e1627 = bitcast<f32>(_e1626);
let _e1628 = local_28.member[2u];
let _e1629 = (_e1607 + _e1628);
let _e1631 = select(_e1550, _e1629, (_e1629 < _e1550));
let _e1636 = global_2.member[bitcast<u32>(select(0i, _e1631, (_e1631 > 0i)))];
let _e1637 = bitcast<f32>(_e1636);
let _e1638 = local_28.member[3u];
let _e1639 = (_e1607 + _e1638);
let _e1641 = select(_e1550, _e1639, (_e1639 < _e1550));
let _e1646 = global_2.member[bitcast<u32>(select(0i, _e1641, (_e1641 > 0i)))];
let _e1648 = local_29[0u];
let _e1652 = local_29[0u];
let _e1655 = (_e1627 + ((_e1637 - _e1627) * _e1652));
let _e1656 = local_29[0u];
let _e1660 = (_e1534 + _e1529);
let _e1661 = local_28.member[0u];
let _e1662 = (_e1660 + _e1661);
let _e1664 = select(_e1550, _e1662, (_e1662 < _e1550));
let _e1669 = global_2.member[bitcast<u32>(select(0i, _e1664, (_e1664 > 0i)))];
let _e1670 = bitcast<f32>(_e1669);
let _e1671 = local_28.member[1u];
let _e1672 = (_e1660 + _e1671);
let _e1674 = select(_e1550, _e1672, (_e1672 < _e1550));
let _e1679 = global_2.member[bitcast<u32>(select(0i, _e1674, (_e1674 > 0i)))];
let _e1680 = bitcast<f32>(_e1679);
let _e1681 = local_28.member[2u];
let _e1682 = (_e1660 + _e1681);
let _e1684 = select(_e1550, _e1682, (_e1682 < _e1550));
let _e1689 = global_2.member[bitcast<u32>(select(0i, _e1684, (_e1684 > 0i)))];
let _e1690 = bitcast<f32>(_e1689);
let _e1691 = local_28.member[3u];
let _e1692 = (_e1660 + _e1691);
let _e1694 = select(_e1550, _e1692, (_e1692 < _e1550));
let _e1699 = global_2.member[bitcast<u32>(select(0i, _e1694, (_e1694 > 0i)))];
let _e1701 = local_29[0u];
let _e1704 = (_e1670 + ((_e1680 - _e1670) * _e1701));
let _e1705 = local_29[0u];
let _e1708 = (_e1680 + ((_e1690 - _e1680) * _e1705));
let _e1709 = local_29[0u];
let _e1712 = (_e1690 + ((bitcast<f32>(_e1699) - _e1690) * _e1709));
let _e1713 = (_e1534 + _e1530);
let _e1714 = local_28.member[0u];
let _e1715 = (_e1713 + _e1714);
let _e1717 = select(_e1550, _e1715, (_e1715 < _e1550));
let _e1722 = global_2.member[bitcast<u32>(select(0i, _e1717, (_e1717 > 0i)))];
let _e1723 = bitcast<f32>(_e1722);
let _e1724 = local_28.member[1u];
let _e1725 = (_e1713 + _e1724);
let _e1727 = select(_e1550, _e1725, (_e1725 < _e1550));
let _e1732 = global_2.member[bitcast<u32>(select(0i, _e1727, (_e1727 > 0i)))];
let _e1733 = bitcast<f32>(_e1732);
let _e1734 = local_28.member[2u];
let _e1735 = (_e1713 + _e1734);
let _e1737 = select(_e1550, _e1735, (_e1735 < _e1550));
let _e1742 = global_2.member[bitcast<u32>(select(0i, _e1737, (_e1737 > 0i)))];
let _e1743 = bitcast<f32>(_e1742);
let _e1744 = local_28.member[3u];
let _e1745 = (_e1713 + _e1744);
let _e1747 = select(_e1550, _e1745, (_e1745 < _e1550));
let _e1752 = global_2.member[bitcast<u32>(select(0i, _e1747, (_e1747 > 0i)))];
let _e1754 = local_29[0u];
let _e1758 = local_29[0u];
let _e1761 = (_e1733 + ((_e1743 - _e1733) * _e1758));
let _e1762 = local_29[0u];
let _e1766 = (_e1533 + _e1528);
let _e1767 = local_28.member[1u];
let _e1768 = (_e1766 + _e1767);
let _e1770 = select(_e1550, _e1768, (_e1768 < _e1550));
let _e1775 = global_2.member[bitcast<u32>(select(0i, _e1770, (_e1770 > 0i)))];
let _e1776 = bitcast<f32>(_e1775);
let _e1777 = local_28.member[2u];
let _e1778 = (_e1766 + _e1777);
let _e1780 = select(_e1550, _e1778, (_e1778 < _e1550));
let _e1785 = global_2.member[bitcast<u32>(select(0i, _e1780, (_e1780 > 0i)))];
let _e1787 = local_29[0u];
let _e1790 = (_e1776 + ((bitcast<f32>(_e1785) - _e1776) * _e1787));
let _e1791 = (_e1533 + _e1531);
let _e1792 = local_28.member[1u];
let _e1793 = (_e1791 + _e1792);
let _e1795 = select(_e1550, _e1793, (_e1793 < _e1550));
let _e1800 = global_2.member[bitcast<u32>(select(0i, _e1795, (_e1795 > 0i)))];
let _e1801 = bitcast<f32>(_e1800);
let _e1802 = local_28.member[2u];
let _e1803 = (_e1791 + _e1802);
let _e1805 = select(_e1550, _e1803, (_e1803 < _e1550));
let _e1810 = global_2.member[bitcast<u32>(select(0i, _e1805, (_e1805 > 0i)))];
let _e1812 = local_29[0u];
let _e1816 = (_e1534 + _e1528);
let _e1817 = local_28.member[1u];
let _e1818 = (_e1816 + _e1817);
let _e1820 = select(_e1550, _e1818, (_e1818 < _e1550));
let _e1825 = global_2.member[bitcast<u32>(select(0i, _e1820, (_e1820 > 0i)))];
let _e1826 = bitcast<f32>(_e1825);
let _e1827 = local_28.member[2u];
let _e1828 = (_e1816 + _e1827);
let _e1830 = select(_e1550, _e1828, (_e1828 < _e1550));
let _e1835 = global_2.member[bitcast<u32>(select(0i, _e1830, (_e1830 > 0i)))];
let _e1837 = local_29[0u];
let _e1840 = (_e1826 + ((bitcast<f32>(_e1835) - _e1826) * _e1837));
let _e1841 = (_e1534 + _e1531);
let _e1842 = local_28.member[1u];
let _e1843 = (_e1841 + _e1842);
let _e1845 = select(_e1550, _e1843, (_e1843 < _e1550));
let _e1850 = global_2.member[bitcast<u32>(select(0i, _e1845, (_e1845 > 0i)))];
let _e1851 = bitcast<f32>(_e1850);
let _e1852 = local_28.member[2u];
let _e1853 = (_e1841 + _e1852);
let _e1855 = select(_e1550, _e1853, (_e1853 < _e1550));
let _e1860 = global_2.member[bitcast<u32>(select(0i, _e1855, (_e1855 > 0i)))];
let _e1862 = local_29[0u];
let _e1866 = (_e1532 + _e1529);
let _e1867 = local_28.member[1u];
let _e1868 = (_e1866 + _e1867);
let _e1870 = select(_e1550, _e1868, (_e1868 < _e1550));
let _e1875 = global_2.member[bitcast<u32>(select(0i, _e1870, (_e1870 > 0i)))];
let _e1876 = bitcast<f32>(_e1875);
let _e1877 = local_28.member[2u];
let _e1878 = (_e1866 + _e1877);
let _e1880 = select(_e1550, _e1878, (_e1878 < _e1550));
let _e1885 = global_2.member[bitcast<u32>(select(0i, _e1880, (_e1880 > 0i)))];
let _e1887 = local_29[0u];
let _e1890 = (_e1876 + ((bitcast<f32>(_e1885) - _e1876) * _e1887));
let _e1891 = (_e1535 + _e1529);
let _e1892 = local_28.member[1u];
let _e1893 = (_e1891 + _e1892);
let _e1895 = select(_e1550, _e1893, (_e1893 < _e1550));
let _e1900 = global_2.member[bitcast<u32>(select(0i, _e1895, (_e1895 > 0i)))];
let _e1901 = bitcast<f32>(_e1900);
let _e1902 = local_28.member[2u];
let _e1903 = (_e1891 + _e1902);
let _e1905 = select(_e1550, _e1903, (_e1903 < _e1550));
let _e1910 = global_2.member[bitcast<u32>(select(0i, _e1905, (_e1905 > 0i)))];
let _e1912 = local_29[0u];
let _e1915 = (_e1901 + ((bitcast<f32>(_e1910) - _e1901) * _e1912));
let _e1916 = (_e1532 + _e1530);
let _e1917 = local_28.member[1u];
let _e1918 = (_e1916 + _e1917);
let _e1920 = select(_e1550, _e1918, (_e1918 < _e1550));
let _e1925 = global_2.member[bitcast<u32>(select(0i, _e1920, (_e1920 > 0i)))];
let _e1926 = bitcast<f32>(_e1925);
let _e1927 = local_28.member[2u];
let _e1928 = (_e1916 + _e1927);
let _e1930 = select(_e1550, _e1928, (_e1928 < _e1550));
let _e1935 = global_2.member[bitcast<u32>(select(0i, _e1930, (_e1930 > 0i)))];
let _e1937 = local_29[0u];
let _e1941 = (_e1535 + _e1530);
let _e1942 = local_28.member[1u];
let _e1943 = (_e1941 + _e1942);
let _e1945 = select(_e1550, _e1943, (_e1943 < _e1550));
let _e1950 = global_2.member[bitcast<u32>(select(0i, _e1945, (_e1945 > 0i)))];
let _e1951 = bitcast<f32>(_e1950);
let _e1952 = local_28.member[2u];
let _e1953 = (_e1941 + _e1952);
let _e1955 = select(_e1550, _e1953, (_e1953 < _e1550));
let _e1960 = global_2.member[bitcast<u32>(select(0i, _e1955, (_e1955 > 0i)))];
let _e1962 = local_29[0u];
let _e1967 = local_29[1u];
let _e1970 = (_e1602 + ((_e1655 - _e1602) * _e1967));
let _e1971 = local_29[1u];
let _e1974 = (_e1708 + ((_e1761 - _e1708) * _e1971));
let _e1975 = local_29[1u];
let _e1978 = (_e1598 + (((_e1617 + ((_e1627 - _e1617) * _e1648)) - _e1598) * _e1975));
let _e1979 = local_29[1u];
let _e1984 = local_29[2u];
let _e1988 = local_29[1u];
let _e1991 = (_e1606 + (((_e1637 + ((bitcast<f32>(_e1646) - _e1637) * _e1656)) - _e1606) * _e1988));
let _e1992 = local_29[1u];
let _e1996 = local_29[2u];
let _e2000 = local_29[1u];
let _e2003 = (_e1790 + ((_e1602 - _e1790) * _e2000));
let _e2004 = local_29[1u];
let _e2008 = local_29[2u];
let _e2012 = local_29[1u];
let _e2015 = (_e1655 + (((_e1801 + ((bitcast<f32>(_e1810) - _e1801) * _e1812)) - _e1655) * _e2012));
let _e2016 = local_29[1u];
let _e2020 = local_29[2u];
let _e2024 = local_29[1u];
let _e2027 = (_e1890 + (((_e1926 + ((bitcast<f32>(_e1935) - _e1926) * _e1937)) - _e1890) * _e2024));
let _e2028 = local_29[2u];
let _e2032 = local_29[1u];
let _e2036 = local_29[2u];
let _e2040 = local_29[2u];
let _e2047 = global_1.member.member_8.member_8;
let _e2051 = global_1.member.member_8.member_7;
let _e2053 = (((_e1970 + ((_e1974 - _e1970) * _e2040)) - _e2047) * _e2051);
let _e2054 = -(1e9f);
let _e2056 = select(_e2054, _e2053, (_e2053 > _e2054));
let _e2058 = select(1e9f, _e2056, (_e2056 < 1e9f));
let _e2060 = (((_e1978 + (((_e1704 + (((_e1723 + ((_e1733 - _e1723) * _e1754)) - _e1704) * _e1979)) - _e1978) * _e1984)) - _e2047) * _e2051);
let _e2062 = select(_e2054, _e2060, (_e2060 > _e2054));
let _e2064 = select(1e9f, _e2062, (_e2062 < 1e9f));
let _e2066 = (((_e1991 + (((_e1712 + (((_e1743 + ((bitcast<f32>(_e1752) - _e1743) * _e1762)) - _e1712) * _e1992)) - _e1991) * _e1996)) - _e2047) * _e2051);
let _e2068 = select(_e2054, _e2066, (_e2066 > _e2054));
let _e2070 = select(1e9f, _e2068, (_e2068 < 1e9f));
let _e2072 = (((_e2003 + (((_e1840 + ((_e1708 - _e1840) * _e2004)) - _e2003) * _e2008)) - _e2047) * _e2051);
let _e2074 = select(_e2054, _e2072, (_e2072 > _e2054));
let _e2076 = select(1e9f, _e2074, (_e2074 < 1e9f));
let _e2078 = (((_e2015 + (((_e1761 + (((_e1851 + ((bitcast<f32>(_e1860) - _e1851) * _e1862)) - _e1761) * _e2016)) - _e2015) * _e2020)) - _e2047) * _e2051);
let _e2080 = select(_e2054, _e2078, (_e2078 > _e2054));
let _e2082 = select(1e9f, _e2080, (_e2080 < 1e9f));
let _e2084 = (((_e2027 + ((_e1970 - _e2027) * _e2028)) - _e2047) * _e2051);
let _e2086 = select(_e2054, _e2084, (_e2084 > _e2054));
let _e2088 = select(1e9f, _e2086, (_e2086 < 1e9f));
let _e2090 = (((_e1974 + (((_e1915 + (((_e1951 + ((bitcast<f32>(_e1960) - _e1951) * _e1962)) - _e1915) * _e2032)) - _e1974) * _e2036)) - _e2047) * _e2051);
let _e2092 = select(_e2054, _e2090, (_e2090 > _e2054));
let _e2094 = select(1e9f, _e2092, (_e2092 < 1e9f));
local_26 = _e2058;
let _e2095 = local_26;
local_27 = _e2095;
let _e2096 = local_27;
let _e2098 = (bitcast<i32>(_e177) - 1i);
let _e2100 = select(_e2098, 263197i, (263197i < _e2098));
let _e2105 = global_3.member[bitcast<u32>(select(0i, _e2100, (_e2100 > 0i)))];
let _e2106 = bitcast<f32>(_e2105);
let _e2108 = select(_e2098, 263198i, (263198i < _e2098));
let _e2111 = bitcast<u32>(select(0i, _e2108, (_e2108 > 0i)));
let _e2113 = global_3.member[_e2111];
let _e2114 = bitcast<f32>(_e2113);
let _e2116 = select(_e2098, 263199i, (263199i < _e2098));
let _e2121 = global_3.member[bitcast<u32>(select(0i, _e2116, (_e2116 > 0i)))];
let _e2122 = bitcast<f32>(_e2121);
let _e2124 = ((_e2096 - _e2106) * _e2114);
let _e2126 = select(0f, _e2124, (_e2124 > 0f));
let _e2129 = local_27;
let _e2131 = select(_e2098, 263200i, (263200i < _e2098));
let _e2136 = global_3.member[bitcast<u32>(select(0i, _e2131, (_e2131 > 0i)))];
let _e2137 = bitcast<f32>(_e2136);
let _e2139 = select(_e2098, 263201i, (263201i < _e2098));
let _e2144 = global_3.member[bitcast<u32>(select(0i, _e2139, (_e2139 > 0i)))];
let _e2145 = bitcast<f32>(_e2144);
let _e2147 = select(_e2098, 263202i, (263202i < _e2098));
let _e2152 = global_3.member[bitcast<u32>(select(0i, _e2147, (_e2147 > 0i)))];
let _e2153 = bitcast<f32>(_e2152);
let _e2155 = ((_e2129 - _e2137) * _e2145);
let _e2157 = select(0f, _e2155, (_e2155 > 0f));
let _e2161 = local_27;
let _e2163 = select(_e2098, 263203i, (263203i < _e2098));
let _e2168 = global_3.member[bitcast<u32>(select(0i, _e2163, (_e2163 > 0i)))];
let _e2169 = bitcast<f32>(_e2168);
let _e2171 = select(_e2098, 263204i, (263204i < _e2098));
let _e2176 = global_3.member[bitcast<u32>(select(0i, _e2171, (_e2171 > 0i)))];
let _e2177 = bitcast<f32>(_e2176);
let _e2179 = select(_e2098, 263205i, (263205i < _e2098));
let _e2184 = global_3.member[bitcast<u32>(select(0i, _e2179, (_e2179 > 0i)))];
let _e2185 = bitcast<f32>(_e2184);
let _e2187 = ((_e2161 - _e2169) * _e2177);
let _e2189 = select(0f, _e2187, (_e2187 > 0f));
let _e2192 = local_27;
let _e2194 = select(_e2098, 263206i, (263206i < _e2098));
let _e2199 = global_3.member[bitcast<u32>(select(0i, _e2194, (_e2194 > 0i)))];
let _e2200 = bitcast<f32>(_e2199);
let _e2202 = select(_e2098, 263207i, (263207i < _e2098));
let _e2207 = global_3.member[bitcast<u32>(select(0i, _e2202, (_e2202 > 0i)))];
let _e2208 = bitcast<f32>(_e2207);
let _e2210 = select(_e2098, 263208i, (263208i < _e2098));
let _e2215 = global_3.member[bitcast<u32>(select(0i, _e2210, (_e2210 > 0i)))];
let _e2216 = bitcast<f32>(_e2215);
let _e2218 = ((_e2192 - _e2200) * _e2208);
let _e2220 = select(0f, _e2218, (_e2218 > 0f));
let _e2224 = ((select(_e2122, _e2126, (_e2126 < _e2122)) + select(_e2153, _e2157, (_e2157 < _e2153))) + (select(_e2185, _e2189, (_e2189 < _e2185)) + select(_e2216, _e2220, (_e2220 < _e2216))));
let _e2226 = select(0f, _e2224, (_e2224 > 0f));
let _e2228 = select(1023f, _e2226, (_e2226 < 1023f));
let _e2235 = select(0i, select(select(i32(_e2228), i32(-2147483648), (_e2228 < -2147483600f)), 2147483647i, (_e2228 > 2147483500f)), (_e2228 == _e2228));
let _e2239 = (_e2235 - select(0i, 1i, (_e2228 < f32(_e2235))));
let _e2240 = (262147i + _e2239);
let _e2242 = select(_e2098, _e2240, (_e2240 < _e2098));
let _e2248 = global_3.member[bitcast<u32>(select(0i, _e2242, (_e2242 > 0i)))];
let _e2258 = select(_e2098, 262146i, (262146i < _e2098));
let _e2264 = global_3.member[bitcast<u32>(select(0i, _e2258, (_e2258 > 0i)))];
let _e2265 = bitcast<f32>(_e2264);
let _e2266 = (f32((bitcast<i32>((_e2248 & 4095u)) - 2048i)) * _e2265);
let _e2268 = select(_e2098, 262144i, (262144i < _e2098));
let _e2274 = global_3.member[bitcast<u32>(select(0i, _e2268, (_e2268 > 0i)))];
let _e2275 = bitcast<f32>(_e2274);
let _e2277 = select(_e2098, 262145i, (262145i < _e2098));
let _e2283 = global_3.member[bitcast<u32>(select(0i, _e2277, (_e2277 > 0i)))];
let _e2284 = bitcast<f32>(_e2283);
let _e2290 = ((_e2275 + (f32(bitcast<i32>((_e2248 >> bitcast<u32>(12u)))) * _e2284)) + (_e2266 * (_e2224 - f32(_e2239))));
let _e2293 = global_3.member[_e2111];
let _e2295 = local_26;
let _e2298 = local_26;
let _e2301 = local_26;
let _e2305 = select(_e2098, 263209i, (263209i < _e2098));
let _e2311 = global_3.member[bitcast<u32>(select(0i, _e2305, (_e2305 > 0i)))];
let _e2313 = local_26;
let _e2316 = select(_e2098, 263210i, (263210i < _e2098));
let _e2322 = global_3.member[bitcast<u32>(select(0i, _e2316, (_e2316 > 0i)))];
let _e2324 = local_26;
let _e2328 = (_e2266 * select(0f, select(select(select(bitcast<f32>(_e2293), _e2145, (_e2295 >= _e2137)), _e2177, (_e2298 >= _e2169)), _e2208, (_e2301 >= _e2200)), ((_e2313 >= bitcast<f32>(_e2311)) && (_e2324 <= bitcast<f32>(_e2322)))));
if _e1278 {
let _e2335 = ((0.5f * (_e2070 - _e2064)) * _e2328);
let _e2336 = ((0.5f * (_e2082 - _e2076)) * _e2328);
let _e2337 = ((0.5f * (_e2094 - _e2088)) * _e2328);
phi_7238_ = type_34(_e2290, vec3<f32>(_e2335, _e2336, _e2337), vec3<f32>((_e2335 * _e2290), (_e2336 * _e2290), (_e2337 * _e2290)));
} else {
local_24 = _e2064;
let _e2344 = local_24;
local_25 = _e2344;
let _e2345 = local_25;
let _e2347 = ((_e2345 - _e2106) * _e2114);
let _e2349 = select(0f, _e2347, (_e2347 > 0f));
let _e2352 = local_25;
let _e2354 = ((_e2352 - _e2137) * _e2145);
let _e2356 = select(0f, _e2354, (_e2354 > 0f));
let _e2360 = local_25;
let _e2362 = ((_e2360 - _e2169) * _e2177);
let _e2364 = select(0f, _e2362, (_e2362 > 0f));
let _e2367 = local_25;
let _e2369 = ((_e2367 - _e2200) * _e2208);
let _e2371 = select(0f, _e2369, (_e2369 > 0f));
let _e2375 = ((select(_e2122, _e2349, (_e2349 < _e2122)) + select(_e2153, _e2356, (_e2356 < _e2153))) + (select(_e2185, _e2364, (_e2364 < _e2185)) + select(_e2216, _e2371, (_e2371 < _e2216))));
let _e2377 = select(0f, _e2375, (_e2375 > 0f));
let _e2379 = select(1023f, _e2377, (_e2377 < 1023f));
let _e2386 = select(0i, select(select(i32(_e2379), i32(-2147483648), (_e2379 < -2147483600f)), 2147483647i, (_e2379 > 2147483500f)), (_e2379 == _e2379));
let _e2390 = (_e2386 - select(0i, 1i, (_e2379 < f32(_e2386))));
let _e2391 = (262147i + _e2390);
let _e2393 = select(_e2098, _e2391, (_e2391 < _e2098));
let _e2399 = global_3.member[bitcast<u32>(select(0i, _e2393, (_e2393 > 0i)))];
let _e2414 = ((_e2275 + (f32(bitcast<i32>((_e2399 >> bitcast<u32>(12u)))) * _e2284)) + ((f32((bitcast<i32>((_e2399 & 4095u)) - 2048i)) * _e2265) * (_e2375 - f32(_e2390))));
local_22 = _e2070;
let _e2415 = local_22;
local_23 = _e2415;
let _e2416 = local_23;
let _e2418 = ((_e2416 - _e2106) * _e2114);
let _e2420 = select(0f, _e2418, (_e2418 > 0f));
let _e2423 = local_23;
let _e2425 = ((_e2423 - _e2137) * _e2145);
let _e2427 = select(0f, _e2425, (_e2425 > 0f));
let _e2431 = local_23;
let _e2433 = ((_e2431 - _e2169) * _e2177);
let _e2435 = select(0f, _e2433, (_e2433 > 0f));
let _e2438 = local_23;
let _e2440 = ((_e2438 - _e2200) * _e2208);
let _e2442 = select(0f, _e2440, (_e2440 > 0f));
let _e2446 = ((select(_e2122, _e2420, (_e2420 < _e2122)) + select(_e2153, _e2427, (_e2427 < _e2153))) + (select(_e2185, _e2435, (_e2435 < _e2185)) + select(_e2216, _e2442, (_e2442 < _e2216))));
let _e2448 = select(0f, _e2446, (_e2446 > 0f));
let _e2450 = select(1023f, _e2448, (_e2448 < 1023f));
let _e2457 = select(0i, select(select(i32(_e2450), i32(-2147483648), (_e2450 < -2147483600f)), 2147483647i, (_e2450 > 2147483500f)), (_e2450 == _e2450));
let _e2461 = (_e2457 - select(0i, 1i, (_e2450 < f32(_e2457))));
let _e2462 = (262147i + _e2461);
let _e2464 = select(_e2098, _e2462, (_e2462 < _e2098));
let _e2470 = global_3.member[bitcast<u32>(select(0i, _e2464, (_e2464 > 0i)))];
let _e2485 = ((_e2275 + (f32(bitcast<i32>((_e2470 >> bitcast<u32>(12u)))) * _e2284)) + ((f32((bitcast<i32>((_e2470 & 4095u)) - 2048i)) * _e2265) * (_e2446 - f32(_e2461))));
local_20 = _e2076;
let _e2486 = local_20;
local_21 = _e2486;
let _e2487 = local_21;
let _e2489 = ((_e2487 - _e2106) * _e2114);
let _e2491 = select(0f, _e2489, (_e2489 > 0f));
let _e2494 = local_21;
let _e2496 = ((_e2494 - _e2137) * _e2145);
let _e2498 = select(0f, _e2496, (_e2496 > 0f));
let _e2502 = local_21;
let _e2504 = ((_e2502 - _e2169) * _e2177);
let _e2506 = select(0f, _e2504, (_e2504 > 0f));
let _e2509 = local_21;
let _e2511 = ((_e2509 - _e2200) * _e2208);
let _e2513 = select(0f, _e2511, (_e2511 > 0f));
let _e2517 = ((select(_e2122, _e2491, (_e2491 < _e2122)) + select(_e2153, _e2498, (_e2498 < _e2153))) + (select(_e2185, _e2506, (_e2506 < _e2185)) + select(_e2216, _e2513, (_e2513 < _e2216))));
let _e2519 = select(0f, _e2517, (_e2517 > 0f));
let _e2521 = select(1023f, _e2519, (_e2519 < 1023f));
let _e2528 = select(0i, select(select(i32(_e2521), i32(-2147483648), (_e2521 < -2147483600f)), 2147483647i, (_e2521 > 2147483500f)), (_e2521 == _e2521));
let _e2532 = (_e2528 - select(0i, 1i, (_e2521 < f32(_e2528))));
let _e2533 = (262147i + _e2532);
let _e2535 = select(_e2098, _e2533, (_e2533 < _e2098));
let _e2541 = global_3.member[bitcast<u32>(select(0i, _e2535, (_e2535 > 0i)))];
let _e2556 = ((_e2275 + (f32(bitcast<i32>((_e2541 >> bitcast<u32>(12u)))) * _e2284)) + ((f32((bitcast<i32>((_e2541 & 4095u)) - 2048i)) * _e2265) * (_e2517 - f32(_e2532))));
local_18 = _e2082;
let _e2557 = local_18;
local_19 = _e2557;
let _e2558 = local_19;
let _e2560 = ((_e2558 - _e2106) * _e2114);
let _e2562 = select(0f, _e2560, (_e2560 > 0f));
let _e2565 = local_19;
let _e2567 = ((_e2565 - _e2137) * _e2145);
let _e2569 = select(0f, _e2567, (_e2567 > 0f));
let _e2573 = local_19;
let _e2575 = ((_e2573 - _e2169) * _e2177);
let _e2577 = select(0f, _e2575, (_e2575 > 0f));
let _e2580 = local_19;
let _e2582 = ((_e2580 - _e2200) * _e2208);
let _e2584 = select(0f, _e2582, (_e2582 > 0f));
let _e2588 = ((select(_e2122, _e2562, (_e2562 < _e2122)) + select(_e2153, _e2569, (_e2569 < _e2153))) + (select(_e2185, _e2577, (_e2577 < _e2185)) + select(_e2216, _e2584, (_e2584 < _e2216))));
let _e2590 = select(0f, _e2588, (_e2588 > 0f));
let _e2592 = select(1023f, _e2590, (_e2590 < 1023f));
let _e2599 = select(0i, select(select(i32(_e2592), i32(-2147483648), (_e2592 < -2147483600f)), 2147483647i, (_e2592 > 2147483500f)), (_e2592 == _e2592));
let _e2603 = (_e2599 - select(0i, 1i, (_e2592 < f32(_e2599))));
let _e2604 = (262147i + _e2603);
let _e2606 = select(_e2098, _e2604, (_e2604 < _e2098));
let _e2612 = global_3.member[bitcast<u32>(select(0i, _e2606, (_e2606 > 0i)))];
let _e2627 = ((_e2275 + (f32(bitcast<i32>((_e2612 >> bitcast<u32>(12u)))) * _e2284)) + ((f32((bitcast<i32>((_e2612 & 4095u)) - 2048i)) * _e2265) * (_e2588 - f32(_e2603))));
local_16 = _e2088;
let _e2628 = local_16;
local_17 = _e2628;
let _e2629 = local_17;
let _e2631 = ((_e2629 - _e2106) * _e2114);
let _e2633 = select(0f, _e2631, (_e2631 > 0f));
let _e2636 = local_17;
let _e2638 = ((_e2636 - _e2137) * _e2145);
let _e2640 = select(0f, _e2638, (_e2638 > 0f));
let _e2644 = local_17;
let _e2646 = ((_e2644 - _e2169) * _e2177);
let _e2648 = select(0f, _e2646, (_e2646 > 0f));
let _e2651 = local_17;
let _e2653 = ((_e2651 - _e2200) * _e2208);
let _e2655 = select(0f, _e2653, (_e2653 > 0f));
let _e2659 = ((select(_e2122, _e2633, (_e2633 < _e2122)) + select(_e2153, _e2640, (_e2640 < _e2153))) + (select(_e2185, _e2648, (_e2648 < _e2185)) + select(_e2216, _e2655, (_e2655 < _e2216))));
let _e2661 = select(0f, _e2659, (_e2659 > 0f));
let _e2663 = select(1023f, _e2661, (_e2661 < 1023f));
let _e2670 = select(0i, select(select(i32(_e2663), i32(-2147483648), (_e2663 < -2147483600f)), 2147483647i, (_e2663 > 2147483500f)), (_e2663 == _e2663));
let _e2674 = (_e2670 - select(0i, 1i, (_e2663 < f32(_e2670))));
let _e2675 = (262147i + _e2674);
let _e2677 = select(_e2098, _e2675, (_e2675 < _e2098));
let _e2683 = global_3.member[bitcast<u32>(select(0i, _e2677, (_e2677 > 0i)))];
let _e2698 = ((_e2275 + (f32(bitcast<i32>((_e2683 >> bitcast<u32>(12u)))) * _e2284)) + ((f32((bitcast<i32>((_e2683 & 4095u)) - 2048i)) * _e2265) * (_e2659 - f32(_e2674))));
local_14 = _e2094;
let _e2699 = local_14;
local_15 = _e2699;
let _e2700 = local_15;
let _e2702 = ((_e2700 - _e2106) * _e2114);
let _e2704 = select(0f, _e2702, (_e2702 > 0f));
let _e2707 = local_15;
let _e2709 = ((_e2707 - _e2137) * _e2145);
let _e2711 = select(0f, _e2709, (_e2709 > 0f));
let _e2715 = local_15;
let _e2717 = ((_e2715 - _e2169) * _e2177);
let _e2719 = select(0f, _e2717, (_e2717 > 0f));
let _e2722 = local_15;
let _e2724 = ((_e2722 - _e2200) * _e2208);
let _e2726 = select(0f, _e2724, (_e2724 > 0f));
let _e2730 = ((select(_e2122, _e2704, (_e2704 < _e2122)) + select(_e2153, _e2711, (_e2711 < _e2153))) + (select(_e2185, _e2719, (_e2719 < _e2185)) + select(_e2216, _e2726, (_e2726 < _e2216))));
let _e2732 = select(0f, _e2730, (_e2730 > 0f));
let _e2734 = select(1023f, _e2732, (_e2732 < 1023f));
let _e2741 = select(0i, select(select(i32(_e2734), i32(-2147483648), (_e2734 < -2147483600f)), 2147483647i, (_e2734 > 2147483500f)), (_e2734 == _e2734));
let _e2745 = (_e2741 - select(0i, 1i, (_e2734 < f32(_e2741))));
let _e2746 = (262147i + _e2745);
let _e2748 = select(_e2098, _e2746, (_e2746 < _e2098));
let _e2754 = global_3.member[bitcast<u32>(select(0i, _e2748, (_e2748 > 0i)))];
let _e2769 = ((_e2275 + (f32(bitcast<i32>((_e2754 >> bitcast<u32>(12u)))) * _e2284)) + ((f32((bitcast<i32>((_e2754 & 4095u)) - 2048i)) * _e2265) * (_e2730 - f32(_e2745))));
let _e2770 = (_e2485 - _e2414);
let _e2772 = (_e2627 - _e2556);
let _e2774 = (_e2769 - _e2698);
phi_7238_ = type_34(_e2290, vec3<f32>((0.5f * _e2770), (0.5f * _e2772), (0.5f * _e2774)), vec3<f32>((0.25f * (_e2770 * (_e2485 + _e2414))), (0.25f * (_e2772 * (_e2627 + _e2556))), (0.25f * (_e2774 * (_e2769 + _e2698)))));
}
let _e2789 = phi_7238_;
let _e2804 = select(0f, 1f, ((((((_e1258 >= _e1284) && (_e1258 <= _e1289)) && (_e1264 >= _e1298)) && (_e1264 <= _e1303)) && (_e1270 >= _e1312)) && (_e1270 <= _e1317)));
let _e2806 = (0.5f * (_e2070 - _e2064));
let _e2808 = (0.5f * (_e2082 - _e2076));
let _e2810 = (0.5f * (_e2094 - _e2088));
let _e2816 = global_1.member.member_8.member.member.member;
let _e2822 = global_1.member.member_8.member.member.member_1;
let _e2828 = global_1.member.member_8.member.member.member_2;
let _e2834 = global_1.member.member_8.member_1.member.member;
let _e2840 = global_1.member.member_8.member_1.member.member_1;
let _e2846 = global_1.member.member_8.member_1.member.member_2;
let _e2852 = global_1.member.member_8.member_2.member.member;
let _e2858 = global_1.member.member_8.member_2.member.member_1;
let _e2864 = global_1.member.member_8.member_2.member.member_2;
let _e2869 = (((_e2816 * _e2806) + (_e2834 * _e2808)) + (_e2852 * _e2810));
let _e2874 = (((_e2822 * _e2806) + (_e2840 * _e2808)) + (_e2858 * _e2810));
let _e2879 = (((_e2828 * _e2806) + (_e2846 * _e2808)) + (_e2864 * _e2810));
phi_9376_ = type_35(_e2058, vec3<f32>((_e2869 * _e2804), (_e2874 * _e2804), (_e2879 * _e2804)), vec3<f32>(_e2869, _e2874, _e2879), _e2789.member, vec3<f32>(((((_e2816 * _e2789.member_2.x) + (_e2834 * _e2789.member_2.y)) + (_e2852 * _e2789.member_2.z)) * _e2804), ((((_e2822 * _e2789.member_2.x) + (_e2840 * _e2789.member_2.y)) + (_e2858 * _e2789.member_2.z)) * _e2804), ((((_e2828 * _e2789.member_2.x) + (_e2846 * _e2789.member_2.y)) + (_e2864 * _e2789.member_2.z)) * _e2804)), vec3<f32>(((((_e2816 * _e2789.member_1.x) + (_e2834 * _e2789.member_1.y)) + (_e2852 * _e2789.member_1.z)) * _e2804), ((((_e2822 * _e2789.member_1.x) + (_e2840 * _e2789.member_1.y)) + (_e2858 * _e2789.member_1.z)) * _e2804), ((((_e2828 * _e2789.member_1.x) + (_e2846 * _e2789.member_1.y)) + (_e2864 * _e2789.member_1.z)) * _e2804)));
} else {
if (_e187.member_2 == 8u) {
let _e2935 = global_1.member.member_8.member_4.member;
let _e2940 = global_1.member.member_8.member_5.member;
let _e2942 = select(_e2935, _e1258, (_e1258 > _e2935));
let _e2944 = select(_e2940, _e2942, (_e2942 < _e2940));
let _e2949 = global_1.member.member_8.member_4.member_1;
let _e2954 = global_1.member.member_8.member_5.member_1;
let _e2956 = select(_e2949, _e1264, (_e1264 > _e2949));
let _e2958 = select(_e2954, _e2956, (_e2956 < _e2954));
let _e2963 = global_1.member.member_8.member_4.member_2;
let _e2968 = global_1.member.member_8.member_5.member_2;
let _e2970 = select(_e2963, _e1270, (_e1270 > _e2963));
let _e2972 = select(_e2968, _e2970, (_e2970 < _e2968));
let _e2977 = global_1.member.member_8.member_15;
if (_e2977 == 0u) {
phi_7585_ = vec3<f32>(_e2944, _e2958, _e2972);
} else {
let _e2979 = (_e2944 + 0.5f);
let _e2984 = global_1.member.member_8.member_3.member;
let _e2985 = (_e2984 - 1f);
let _e2987 = select(0f, _e2979, (_e2979 > 0f));
let _e2989 = select(_e2985, _e2987, (_e2987 < _e2985));
let _e2996 = select(0i, select(select(i32(_e2989), i32(-2147483648), (_e2989 < -2147483600f)), 2147483647i, (_e2989 > 2147483500f)), (_e2989 == _e2989));
let _e3002 = (_e2958 + 0.5f);
let _e3007 = global_1.member.member_8.member_3.member_1;
let _e3008 = (_e3007 - 1f);
let _e3010 = select(0f, _e3002, (_e3002 > 0f));
let _e3012 = select(_e3008, _e3010, (_e3010 < _e3008));
let _e3019 = select(0i, select(select(i32(_e3012), i32(-2147483648), (_e3012 < -2147483600f)), 2147483647i, (_e3012 > 2147483500f)), (_e3012 == _e3012));
let _e3025 = (_e2972 + 0.5f);
let _e3030 = global_1.member.member_8.member_3.member_2;
let _e3031 = (_e3030 - 1f);
let _e3033 = select(0f, _e3025, (_e3025 > 0f));
let _e3035 = select(_e3031, _e3033, (_e3033 < _e3031));
let _e3042 = select(0i, select(select(i32(_e3035), i32(-2147483648), (_e3035 < -2147483600f)), 2147483647i, (_e3035 > 2147483500f)), (_e3035 == _e3035));
phi_7585_ = vec3<f32>(f32((_e2996 - select(0i, 1i, (_e2989 < f32(_e2996))))), f32((_e3019 - select(0i, 1i, (_e3012 < f32(_e3019))))), f32((_e3042 - select(0i, 1i, (_e3035 < f32(_e3042))))));
}
let _e3050 = phi_7585_;
let _e3056 = global_1.member.member_8.member_3.member;
let _e3058 = select(-1f, _e3050.x, (_e3050.x > -1f));
let _e3060 = select(_e3056, _e3058, (_e3058 < _e3056));
let _e3067 = select(0i, select(select(i32(_e3060), i32(-2147483648), (_e3060 < -2147483600f)), 2147483647i, (_e3060 > 2147483500f)), (_e3060 == _e3060));
let _e3071 = (_e3067 - select(0i, 1i, (_e3060 < f32(_e3067))));
let _e3077 = global_1.member.member_8.member_3.member_1;
let _e3079 = select(-1f, _e3050.y, (_e3050.y > -1f));
let _e3081 = select(_e3077, _e3079, (_e3079 < _e3077));
let _e3088 = select(0i, select(select(i32(_e3081), i32(-2147483648), (_e3081 < -2147483600f)), 2147483647i, (_e3081 > 2147483500f)), (_e3081 == _e3081));
let _e3092 = (_e3088 - select(0i, 1i, (_e3081 < f32(_e3088))));
let _e3098 = global_1.member.member_8.member_3.member_2;
let _e3100 = select(-1f, _e3050.z, (_e3050.z > -1f));
let _e3102 = select(_e3098, _e3100, (_e3100 < _e3098));
let _e3109 = select(0i, select(select(i32(_e3102), i32(-2147483648), (_e3102 < -2147483600f)), 2147483647i, (_e3102 > 2147483500f)), (_e3102 == _e3102));
let _e3113 = (_e3109 - select(0i, 1i, (_e3102 < f32(_e3109))));
let _e3117 = global_1.member.member_8.member_9;
let _e3121 = global_1.member.member_8.member_10;
let _e3129 = (select(0i, select(select(i32(_e3077), i32(-2147483648), (_e3077 < -2147483600f)), 2147483647i, (_e3077 > 2147483500f)), (_e3077 == _e3077)) - 1i);
let _e3130 = (_e3092 - 1i);
let _e3135 = (_e3092 + 1i);
let _e3138 = (_e3092 + 2i);
let _e3148 = (select(0i, select(select(i32(_e3098), i32(-2147483648), (_e3098 < -2147483600f)), 2147483647i, (_e3098 > 2147483500f)), (_e3098 == _e3098)) - 1i);
let _e3149 = (_e3113 - 1i);
let _e3154 = (_e3113 + 1i);
let _e3157 = (_e3113 + 2i);
let _e3167 = (select(0i, select(select(i32(_e3056), i32(-2147483648), (_e3056 < -2147483600f)), 2147483647i, (_e3056 > 2147483500f)), (_e3056 == _e3056)) - 1i);
let _e3168 = (_e3071 - 1i);
let _e3173 = (_e3071 + 1i);
let _e3176 = (_e3071 + 2i);
let _e3179 = (select(0i, _e3130, (_e3130 > 0i)) * _e3117);
let _e3180 = (select(0i, _e3092, (_e3092 > 0i)) * _e3117);
let _e3181 = (select(_e3129, _e3135, (_e3135 < _e3129)) * _e3117);
let _e3182 = (select(_e3129, _e3138, (_e3138 < _e3129)) * _e3117);
let _e3183 = (select(0i, _e3149, (_e3149 > 0i)) * _e3121);
let _e3184 = (select(0i, _e3113, (_e3113 > 0i)) * _e3121);
let _e3185 = (select(_e3148, _e3154, (_e3154 < _e3148)) * _e3121);
let _e3186 = (select(_e3148, _e3157, (_e3157 < _e3148)) * _e3121);
local_12 = type_30(array<i32, 4>(select(0i, _e3168, (_e3168 > 0i)), select(0i, _e3071, (_e3071 > 0i)), select(_e3167, _e3173, (_e3173 < _e3167)), select(_e3167, _e3176, (_e3176 < _e3167))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_13 = (_e3050 - vec3<f32>(f32(_e3071), f32(_e3092), f32(_e3113)));
let _e3195 = (_e3184 + _e3180);
let _e3198 = local_12.member[0u];
let _e3199 = (_e3195 + _e3198);
let _e3201 = (bitcast<i32>(_e172) - 1i);
let _e3203 = select(_e3201, _e3199, (_e3199 < _e3201));
let _e3208 = global_2.member[bitcast<u32>(select(0i, _e3203, (_e3203 > 0i)))];
let _e3209 = bitcast<f32>(_e3208);
let _e3212 = local_12.member[1u];
let _e3213 = (_e3195 + _e3212);
let _e3215 = select(_e3201, _e3213, (_e3213 < _e3201));
let _e3220 = global_2.member[bitcast<u32>(select(0i, _e3215, (_e3215 > 0i)))];
let _e3221 = bitcast<f32>(_e3220);
let _e3224 = local_12.member[2u];
let _e3225 = (_e3195 + _e3224);
let _e3227 = select(_e3201, _e3225, (_e3225 < _e3201));
let _e3232 = global_2.member[bitcast<u32>(select(0i, _e3227, (_e3227 > 0i)))];
let _e3233 = bitcast<f32>(_e3232);
let _e3236 = local_12.member[3u];
let _e3237 = (_e3195 + _e3236);
let _e3239 = select(_e3201, _e3237, (_e3237 < _e3201));
let _e3244 = global_2.member[bitcast<u32>(select(0i, _e3239, (_e3239 > 0i)))];
let _e3246 = local_13[0u];
let _e3249 = (_e3209 + ((_e3221 - _e3209) * _e3246));
let _e3250 = local_13[0u];
let _e3253 = (_e3221 + ((_e3233 - _e3221) * _e3250));
let _e3254 = local_13[0u];
let _e3257 = (_e3233 + ((bitcast<f32>(_e3244) - _e3233) * _e3254));
let _e3258 = (_e3184 + _e3181);
let _e3259 = local_12.member[0u];
let _e3260 = (_e3258 + _e3259);
let _e3262 = select(_e3201, _e3260, (_e3260 < _e3201));
let _e3267 = global_2.member[bitcast<u32>(select(0i, _e3262, (_e3262 > 0i)))];
let _e3268 = bitcast<f32>(_e3267);
let _e3269 = local_12.member[1u];
let _e3270 = (_e3258 + _e3269);
let _e3272 = select(_e3201, _e3270, (_e3270 < _e3201));
let _e3277 = global_2.member[bitcast<u32>(select(0i, _e3272, (_e3272 > 0i)))];
let _e3278 = bitcast<f32>(_e3277);
let _e3279 = local_12.member[2u];
let _e3280 = (_e3258 + _e3279);
let _e3282 = select(_e3201, _e3280, (_e3280 < _e3201));
let _e3287 = global_2.member[bitcast<u32>(select(0i, _e3282, (_e3282 > 0i)))];
let _e3288 = bitcast<f32>(_e3287);
let _e3289 = local_12.member[3u];
let _e3290 = (_e3258 + _e3289);
let _e3292 = select(_e3201, _e3290, (_e3290 < _e3201));
let _e3297 = global_2.member[bitcast<u32>(select(0i, _e3292, (_e3292 > 0i)))];
let _e3299 = local_13[0u];
let _e3303 = local_13[0u];
let _e3306 = (_e3278 + ((_e3288 - _e3278) * _e3303));
let _e3307 = local_13[0u];
let _e3311 = (_e3185 + _e3180);
let _e3312 = local_12.member[0u];
let _e3313 = (_e3311 + _e3312);
let _e3315 = select(_e3201, _e3313, (_e3313 < _e3201));
let _e3320 = global_2.member[bitcast<u32>(select(0i, _e3315, (_e3315 > 0i)))];
let _e3321 = bitcast<f32>(_e3320);
let _e3322 = local_12.member[1u];
let _e3323 = (_e3311 + _e3322);
let _e3325 = select(_e3201, _e3323, (_e3323 < _e3201));
let _e3330 = global_2.member[bitcast<u32>(select(0i, _e3325, (_e3325 > 0i)))];
let _e3331 = bitcast<f32>(_e3330);
let _e3332 = local_12.member[2u];
let _e3333 = (_e3311 + _e3332);
let _e3335 = select(_e3201, _e3333, (_e3333 < _e3201));
let _e3340 = global_2.member[bitcast<u32>(select(0i, _e3335, (_e3335 > 0i)))];
let _e3341 = bitcast<f32>(_e3340);
let _e3342 = local_12.member[3u];
let _e3343 = (_e3311 + _e3342);
let _e3345 = select(_e3201, _e3343, (_e3343 < _e3201));
let _e3350 = global_2.member[bitcast<u32>(select(0i, _e3345, (_e3345 > 0i)))];
let _e3352 = local_13[0u];
let _e3355 = (_e3321 + ((_e3331 - _e3321) * _e3352));
let _e3356 = local_13[0u];
let _e3359 = (_e3331 + ((_e3341 - _e3331) * _e3356));
let _e3360 = local_13[0u];
let _e3363 = (_e3341 + ((bitcast<f32>(_e3350) - _e3341) * _e3360));
let _e3364 = (_e3185 + _e3181);
let _e3365 = local_12.member[0u];
let _e3366 = (_e3364 + _e3365);
let _e3368 = select(_e3201, _e3366, (_e3366 < _e3201));
let _e3373 = global_2.member[bitcast<u32>(select(0i, _e3368, (_e3368 > 0i)))];
let _e3374 = bitcast<f32>(_e3373);
let _e3375 = local_12.member[1u];
let _e3376 = (_e3364 + _e3375);
let _e3378 = select(_e3201, _e3376, (_e3376 < _e3201));
let _e3383 = global_2.member[bitcast<u32>(select(0i, _e3378, (_e3378 > 0i)))];
let _e3384 = bitcast<f32>(_e3383);
let _e3385 = local_12.member[2u];
let _e3386 = (_e3364 + _e3385);
let _e3388 = select(_e3201, _e3386, (_e3386 < _e3201));
let _e3393 = global_2.member[bitcast<u32>(select(0i, _e3388, (_e3388 > 0i)))];
let _e3394 = bitcast<f32>(_e3393);
let _e3395 = local_12.member[3u];
let _e3396 = (_e3364 + _e3395);
let _e3398 = select(_e3201, _e3396, (_e3396 < _e3201));
let _e3403 = global_2.member[bitcast<u32>(select(0i, _e3398, (_e3398 > 0i)))];
let _e3405 = local_13[0u];
let _e3409 = local_13[0u];
let _e3412 = (_e3384 + ((_e3394 - _e3384) * _e3409));
let _e3413 = local_13[0u];
let _e3417 = (_e3184 + _e3179);
let _e3418 = local_12.member[1u];
let _e3419 = (_e3417 + _e3418);
let _e3421 = select(_e3201, _e3419, (_e3419 < _e3201));
let _e3426 = global_2.member[bitcast<u32>(select(0i, _e3421, (_e3421 > 0i)))];
let _e3427 = bitcast<f32>(_e3426);
let _e3428 = local_12.member[2u];
let _e3429 = (_e3417 + _e3428);
let _e3431 = select(_e3201, _e3429, (_e3429 < _e3201));
let _e3436 = global_2.member[bitcast<u32>(select(0i, _e3431, (_e3431 > 0i)))];
let _e3438 = local_13[0u];
let _e3441 = (_e3427 + ((bitcast<f32>(_e3436) - _e3427) * _e3438));
let _e3442 = (_e3184 + _e3182);
let _e3443 = local_12.member[1u];
let _e3444 = (_e3442 + _e3443);
let _e3446 = select(_e3201, _e3444, (_e3444 < _e3201));
let _e3451 = global_2.member[bitcast<u32>(select(0i, _e3446, (_e3446 > 0i)))];
let _e3452 = bitcast<f32>(_e3451);
let _e3453 = local_12.member[2u];
let _e3454 = (_e3442 + _e3453);
let _e3456 = select(_e3201, _e3454, (_e3454 < _e3201));
let _e3461 = global_2.member[bitcast<u32>(select(0i, _e3456, (_e3456 > 0i)))];
let _e3463 = local_13[0u];
let _e3467 = (_e3185 + _e3179);
let _e3468 = local_12.member[1u];
let _e3469 = (_e3467 + _e3468);
let _e3471 = select(_e3201, _e3469, (_e3469 < _e3201));
let _e3476 = global_2.member[bitcast<u32>(select(0i, _e3471, (_e3471 > 0i)))];
let _e3477 = bitcast<f32>(_e3476);
let _e3478 = local_12.member[2u];
let _e3479 = (_e3467 + _e3478);
let _e3481 = select(_e3201, _e3479, (_e3479 < _e3201));
let _e3486 = global_2.member[bitcast<u32>(select(0i, _e3481, (_e3481 > 0i)))];
let _e3488 = local_13[0u];
let _e3491 = (_e3477 + ((bitcast<f32>(_e3486) - _e3477) * _e3488));
let _e3492 = (_e3185 + _e3182);
let _e3493 = local_12.member[1u];
let _e3494 = (_e3492 + _e3493);
let _e3496 = select(_e3201, _e3494, (_e3494 < _e3201));
let _e3501 = global_2.member[bitcast<u32>(select(0i, _e3496, (_e3496 > 0i)))];
let _e3502 = bitcast<f32>(_e3501);
let _e3503 = local_12.member[2u];
let _e3504 = (_e3492 + _e3503);
let _e3506 = select(_e3201, _e3504, (_e3504 < _e3201));
let _e3511 = global_2.member[bitcast<u32>(select(0i, _e3506, (_e3506 > 0i)))];
let _e3513 = local_13[0u];
let _e3517 = (_e3183 + _e3180);
let _e3518 = local_12.member[1u];
let _e3519 = (_e3517 + _e3518);
let _e3521 = select(_e3201, _e3519, (_e3519 < _e3201));
let _e3526 = global_2.member[bitcast<u32>(select(0i, _e3521, (_e3521 > 0i)))];
let _e3527 = bitcast<f32>(_e3526);
let _e3528 = local_12.member[2u];
let _e3529 = (_e3517 + _e3528);
let _e3531 = select(_e3201, _e3529, (_e3529 < _e3201));
let _e3536 = global_2.member[bitcast<u32>(select(0i, _e3531, (_e3531 > 0i)))];
let _e3538 = local_13[0u];
let _e3541 = (_e3527 + ((bitcast<f32>(_e3536) - _e3527) * _e3538));
let _e3542 = (_e3186 + _e3180);
let _e3543 = local_12.member[1u];
let _e3544 = (_e3542 + _e3543);
let _e3546 = select(_e3201, _e3544, (_e3544 < _e3201));
let _e3551 = global_2.member[bitcast<u32>(select(0i, _e3546, (_e3546 > 0i)))];
let _e3552 = bitcast<f32>(_e3551);
let _e3553 = local_12.member[2u];
let _e3554 = (_e3542 + _e3553);
let _e3556 = select(_e3201, _e3554, (_e3554 < _e3201));
let _e3561 = global_2.member[bitcast<u32>(select(0i, _e3556, (_e3556 > 0i)))];
let _e3563 = local_13[0u];
let _e3566 = (_e3552 + ((bitcast<f32>(_e3561) - _e3552) * _e3563));
let _e3567 = (_e3183 + _e3181);
let _e3568 = local_12.member[1u];
let _e3569 = (_e3567 + _e3568);
let _e3571 = select(_e3201, _e3569, (_e3569 < _e3201));
let _e3576 = global_2.member[bitcast<u32>(select(0i, _e3571, (_e3571 > 0i)))];
let _e3577 = bitcast<f32>(_e3576);
let _e3578 = local_12.member[2u];
let _e3579 = (_e3567 + _e3578);
let _e3581 = select(_e3201, _e3579, (_e3579 < _e3201));
let _e3586 = global_2.member[bitcast<u32>(select(0i, _e3581, (_e3581 > 0i)))];
let _e3588 = local_13[0u];
let _e3592 = (_e3186 + _e3181);
let _e3593 = local_12.member[1u];
let _e3594 = (_e3592 + _e3593);
let _e3596 = select(_e3201, _e3594, (_e3594 < _e3201));
let _e3601 = global_2.member[bitcast<u32>(select(0i, _e3596, (_e3596 > 0i)))];
let _e3602 = bitcast<f32>(_e3601);
let _e3603 = local_12.member[2u];
let _e3604 = (_e3592 + _e3603);
let _e3606 = select(_e3201, _e3604, (_e3604 < _e3201));
let _e3611 = global_2.member[bitcast<u32>(select(0i, _e3606, (_e3606 > 0i)))];
let _e3613 = local_13[0u];
let _e3618 = local_13[1u];
let _e3621 = (_e3253 + ((_e3306 - _e3253) * _e3618));
let _e3622 = local_13[1u];
let _e3625 = (_e3359 + ((_e3412 - _e3359) * _e3622));
let _e3626 = local_13[1u];
let _e3629 = (_e3249 + (((_e3268 + ((_e3278 - _e3268) * _e3299)) - _e3249) * _e3626));
let _e3630 = local_13[1u];
let _e3635 = local_13[2u];
let _e3639 = local_13[1u];
let _e3642 = (_e3257 + (((_e3288 + ((bitcast<f32>(_e3297) - _e3288) * _e3307)) - _e3257) * _e3639));
let _e3643 = local_13[1u];
let _e3647 = local_13[2u];
let _e3651 = local_13[1u];
let _e3654 = (_e3441 + ((_e3253 - _e3441) * _e3651));
let _e3655 = local_13[1u];
let _e3659 = local_13[2u];
let _e3663 = local_13[1u];
let _e3666 = (_e3306 + (((_e3452 + ((bitcast<f32>(_e3461) - _e3452) * _e3463)) - _e3306) * _e3663));
let _e3667 = local_13[1u];
let _e3671 = local_13[2u];
let _e3675 = local_13[1u];
let _e3678 = (_e3541 + (((_e3577 + ((bitcast<f32>(_e3586) - _e3577) * _e3588)) - _e3541) * _e3675));
let _e3679 = local_13[2u];
let _e3683 = local_13[1u];
let _e3687 = local_13[2u];
let _e3691 = local_13[2u];
let _e3698 = global_1.member.member_8.member_8;
let _e3702 = global_1.member.member_8.member_7;
let _e3704 = (((_e3621 + ((_e3625 - _e3621) * _e3691)) - _e3698) * _e3702);
let _e3705 = -(1e9f);
let _e3707 = select(_e3705, _e3704, (_e3704 > _e3705));
let _e3711 = (((_e3629 + (((_e3355 + (((_e3374 + ((_e3384 - _e3374) * _e3405)) - _e3355) * _e3630)) - _e3629) * _e3635)) - _e3698) * _e3702);
let _e3713 = select(_e3705, _e3711, (_e3711 > _e3705));
let _e3717 = (((_e3642 + (((_e3363 + (((_e3394 + ((bitcast<f32>(_e3403) - _e3394) * _e3413)) - _e3363) * _e3643)) - _e3642) * _e3647)) - _e3698) * _e3702);
let _e3719 = select(_e3705, _e3717, (_e3717 > _e3705));
let _e3723 = (((_e3654 + (((_e3491 + ((_e3359 - _e3491) * _e3655)) - _e3654) * _e3659)) - _e3698) * _e3702);
let _e3725 = select(_e3705, _e3723, (_e3723 > _e3705));
let _e3729 = (((_e3666 + (((_e3412 + (((_e3502 + ((bitcast<f32>(_e3511) - _e3502) * _e3513)) - _e3412) * _e3667)) - _e3666) * _e3671)) - _e3698) * _e3702);
let _e3731 = select(_e3705, _e3729, (_e3729 > _e3705));
let _e3735 = (((_e3678 + ((_e3621 - _e3678) * _e3679)) - _e3698) * _e3702);
let _e3737 = select(_e3705, _e3735, (_e3735 > _e3705));
let _e3741 = (((_e3625 + (((_e3566 + (((_e3602 + ((bitcast<f32>(_e3611) - _e3602) * _e3613)) - _e3566) * _e3683)) - _e3625) * _e3687)) - _e3698) * _e3702);
let _e3743 = select(_e3705, _e3741, (_e3741 > _e3705));
let _e3747 = (0.5f * (select(1e9f, _e3719, (_e3719 < 1e9f)) - select(1e9f, _e3713, (_e3713 < 1e9f))));
let _e3749 = (0.5f * (select(1e9f, _e3731, (_e3731 < 1e9f)) - select(1e9f, _e3725, (_e3725 < 1e9f))));
let _e3751 = (0.5f * (select(1e9f, _e3743, (_e3743 < 1e9f)) - select(1e9f, _e3737, (_e3737 < 1e9f))));
let _e3757 = global_1.member.member_8.member.member.member;
let _e3763 = global_1.member.member_8.member.member.member_1;
let _e3769 = global_1.member.member_8.member.member.member_2;
let _e3775 = global_1.member.member_8.member_1.member.member;
let _e3781 = global_1.member.member_8.member_1.member.member_1;
let _e3787 = global_1.member.member_8.member_1.member.member_2;
let _e3793 = global_1.member.member_8.member_2.member.member;
let _e3799 = global_1.member.member_8.member_2.member.member_1;
let _e3805 = global_1.member.member_8.member_2.member.member_2;
phi_9373_ = select(1e9f, _e3707, (_e3707 < 1e9f));
phi_9374_ = vec3<f32>((((_e3757 * _e3747) + (_e3775 * _e3749)) + (_e3793 * _e3751)), (((_e3763 * _e3747) + (_e3781 * _e3749)) + (_e3799 * _e3751)), (((_e3769 * _e3747) + (_e3787 * _e3749)) + (_e3805 * _e3751)));
} else {
let _e3826 = global_1.member.member_8.member_4.member;
let _e3831 = global_1.member.member_8.member_5.member;
let _e3833 = select(_e3826, _e1258, (_e1258 > _e3826));
let _e3835 = select(_e3831, _e3833, (_e3833 < _e3831));
let _e3840 = global_1.member.member_8.member_4.member_1;
let _e3845 = global_1.member.member_8.member_5.member_1;
let _e3847 = select(_e3840, _e1264, (_e1264 > _e3840));
let _e3849 = select(_e3845, _e3847, (_e3847 < _e3845));
let _e3854 = global_1.member.member_8.member_4.member_2;
let _e3859 = global_1.member.member_8.member_5.member_2;
let _e3861 = select(_e3854, _e1270, (_e1270 > _e3854));
let _e3863 = select(_e3859, _e3861, (_e3861 < _e3859));
let _e3868 = global_1.member.member_8.member_15;
if (_e3868 == 0u) {
phi_8960_ = vec3<f32>(_e3835, _e3849, _e3863);
} else {
let _e3870 = (_e3835 + 0.5f);
let _e3875 = global_1.member.member_8.member_3.member;
let _e3876 = (_e3875 - 1f);
let _e3878 = select(0f, _e3870, (_e3870 > 0f));
let _e3880 = select(_e3876, _e3878, (_e3878 < _e3876));
let _e3887 = select(0i, select(select(i32(_e3880), i32(-2147483648), (_e3880 < -2147483600f)), 2147483647i, (_e3880 > 2147483500f)), (_e3880 == _e3880));
let _e3893 = (_e3849 + 0.5f);
let _e3898 = global_1.member.member_8.member_3.member_1;
let _e3899 = (_e3898 - 1f);
let _e3901 = select(0f, _e3893, (_e3893 > 0f));
let _e3903 = select(_e3899, _e3901, (_e3901 < _e3899));
let _e3910 = select(0i, select(select(i32(_e3903), i32(-2147483648), (_e3903 < -2147483600f)), 2147483647i, (_e3903 > 2147483500f)), (_e3903 == _e3903));
let _e3916 = (_e3863 + 0.5f);
let _e3921 = global_1.member.member_8.member_3.member_2;
let _e3922 = (_e3921 - 1f);
let _e3924 = select(0f, _e3916, (_e3916 > 0f));
let _e3926 = select(_e3922, _e3924, (_e3924 < _e3922));
let _e3933 = select(0i, select(select(i32(_e3926), i32(-2147483648), (_e3926 < -2147483600f)), 2147483647i, (_e3926 > 2147483500f)), (_e3926 == _e3926));
phi_8960_ = vec3<f32>(f32((_e3887 - select(0i, 1i, (_e3880 < f32(_e3887))))), f32((_e3910 - select(0i, 1i, (_e3903 < f32(_e3910))))), f32((_e3933 - select(0i, 1i, (_e3926 < f32(_e3933))))));
}
let _e3941 = phi_8960_;
let _e3947 = global_1.member.member_8.member_3.member;
let _e3949 = select(-1f, _e3941.x, (_e3941.x > -1f));
let _e3951 = select(_e3947, _e3949, (_e3949 < _e3947));
let _e3958 = select(0i, select(select(i32(_e3951), i32(-2147483648), (_e3951 < -2147483600f)), 2147483647i, (_e3951 > 2147483500f)), (_e3951 == _e3951));
let _e3962 = (_e3958 - select(0i, 1i, (_e3951 < f32(_e3958))));
let _e3968 = global_1.member.member_8.member_3.member_1;
let _e3970 = select(-1f, _e3941.y, (_e3941.y > -1f));
let _e3972 = select(_e3968, _e3970, (_e3970 < _e3968));
let _e3979 = select(0i, select(select(i32(_e3972), i32(-2147483648), (_e3972 < -2147483600f)), 2147483647i, (_e3972 > 2147483500f)), (_e3972 == _e3972));
let _e3983 = (_e3979 - select(0i, 1i, (_e3972 < f32(_e3979))));
let _e3989 = global_1.member.member_8.member_3.member_2;
let _e3991 = select(-1f, _e3941.z, (_e3941.z > -1f));
let _e3993 = select(_e3989, _e3991, (_e3991 < _e3989));
let _e4000 = select(0i, select(select(i32(_e3993), i32(-2147483648), (_e3993 < -2147483600f)), 2147483647i, (_e3993 > 2147483500f)), (_e3993 == _e3993));
let _e4004 = (_e4000 - select(0i, 1i, (_e3993 < f32(_e4000))));
let _e4008 = global_1.member.member_8.member_9;
let _e4012 = global_1.member.member_8.member_10;
let _e4020 = (select(0i, select(select(i32(_e3968), i32(-2147483648), (_e3968 < -2147483600f)), 2147483647i, (_e3968 > 2147483500f)), (_e3968 == _e3968)) - 1i);
let _e4023 = (_e3983 + 1i);
let _e4033 = (select(0i, select(select(i32(_e3989), i32(-2147483648), (_e3989 < -2147483600f)), 2147483647i, (_e3989 > 2147483500f)), (_e3989 == _e3989)) - 1i);
let _e4036 = (_e4004 + 1i);
let _e4046 = (select(0i, select(select(i32(_e3947), i32(-2147483648), (_e3947 < -2147483600f)), 2147483647i, (_e3947 > 2147483500f)), (_e3947 == _e3947)) - 1i);
let _e4047 = (_e3962 - 1i);
let _e4052 = (_e3962 + 1i);
let _e4055 = (_e3962 + 2i);
let _e4058 = (select(0i, _e3983, (_e3983 > 0i)) * _e4008);
let _e4059 = (select(_e4020, _e4023, (_e4023 < _e4020)) * _e4008);
let _e4060 = (select(0i, _e4004, (_e4004 > 0i)) * _e4012);
let _e4061 = (select(_e4033, _e4036, (_e4036 < _e4033)) * _e4012);
local_10 = type_30(array<i32, 4>(select(0i, _e4047, (_e4047 > 0i)), select(0i, _e3962, (_e3962 > 0i)), select(_e4046, _e4052, (_e4052 < _e4046)), select(_e4046, _e4055, (_e4055 < _e4046))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_11 = (_e3941 - vec3<f32>(f32(_e3962), f32(_e3983), f32(_e4004)));
let _e4070 = (_e4060 + _e4058);
let _e4073 = local_10.member[1u];
let _e4074 = (_e4070 + _e4073);
let _e4076 = (bitcast<i32>(_e172) - 1i);
let _e4078 = select(_e4076, _e4074, (_e4074 < _e4076));
let _e4083 = global_2.member[bitcast<u32>(select(0i, _e4078, (_e4078 > 0i)))];
let _e4084 = bitcast<f32>(_e4083);
let _e4087 = local_10.member[2u];
let _e4088 = (_e4070 + _e4087);
let _e4090 = select(_e4076, _e4088, (_e4088 < _e4076));
let _e4095 = global_2.member[bitcast<u32>(select(0i, _e4090, (_e4090 > 0i)))];
let _e4097 = local_11[0u];
let _e4100 = (_e4084 + ((bitcast<f32>(_e4095) - _e4084) * _e4097));
let _e4101 = (_e4060 + _e4059);
let _e4102 = local_10.member[1u];
let _e4103 = (_e4101 + _e4102);
let _e4105 = select(_e4076, _e4103, (_e4103 < _e4076));
let _e4110 = global_2.member[bitcast<u32>(select(0i, _e4105, (_e4105 > 0i)))];
let _e4111 = bitcast<f32>(_e4110);
let _e4112 = local_10.member[2u];
let _e4113 = (_e4101 + _e4112);
let _e4115 = select(_e4076, _e4113, (_e4113 < _e4076));
let _e4120 = global_2.member[bitcast<u32>(select(0i, _e4115, (_e4115 > 0i)))];
let _e4122 = local_11[0u];
let _e4127 = local_11[1u];
let _e4130 = (_e4100 + (((_e4111 + ((bitcast<f32>(_e4120) - _e4111) * _e4122)) - _e4100) * _e4127));
let _e4131 = (_e4061 + _e4058);
let _e4132 = local_10.member[1u];
let _e4133 = (_e4131 + _e4132);
let _e4135 = select(_e4076, _e4133, (_e4133 < _e4076));
let _e4140 = global_2.member[bitcast<u32>(select(0i, _e4135, (_e4135 > 0i)))];
let _e4141 = bitcast<f32>(_e4140);
let _e4142 = local_10.member[2u];
let _e4143 = (_e4131 + _e4142);
let _e4145 = select(_e4076, _e4143, (_e4143 < _e4076));
let _e4150 = global_2.member[bitcast<u32>(select(0i, _e4145, (_e4145 > 0i)))];
let _e4152 = local_11[0u];
let _e4155 = (_e4141 + ((bitcast<f32>(_e4150) - _e4141) * _e4152));
let _e4156 = (_e4061 + _e4059);
let _e4157 = local_10.member[1u];
let _e4158 = (_e4156 + _e4157);
let _e4160 = select(_e4076, _e4158, (_e4158 < _e4076));
let _e4165 = global_2.member[bitcast<u32>(select(0i, _e4160, (_e4160 > 0i)))];
let _e4166 = bitcast<f32>(_e4165);
let _e4167 = local_10.member[2u];
let _e4168 = (_e4156 + _e4167);
let _e4170 = select(_e4076, _e4168, (_e4168 < _e4076));
let _e4175 = global_2.member[bitcast<u32>(select(0i, _e4170, (_e4170 > 0i)))];
let _e4177 = local_11[0u];
let _e4181 = local_11[1u];
let _e4186 = local_11[2u];
let _e4193 = global_1.member.member_8.member_8;
let _e4197 = global_1.member.member_8.member_7;
let _e4199 = (((_e4130 + (((_e4155 + (((_e4166 + ((bitcast<f32>(_e4175) - _e4166) * _e4177)) - _e4155) * _e4181)) - _e4130) * _e4186)) - _e4193) * _e4197);
let _e4200 = -(1e9f);
let _e4202 = select(_e4200, _e4199, (_e4199 > _e4200));
phi_9373_ = select(1e9f, _e4202, (_e4202 < 1e9f));
phi_9374_ = vec3<f32>(0f, 0f, 0f);
}
let _e4206 = phi_9373_;
let _e4208 = phi_9374_;
phi_9376_ = type_35(_e4206, vec3<f32>(0f, 0f, 0f), _e4208, 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e4211 = phi_9376_;
let _e4216 = global_1.member.member_8.member_4.member;
let _e4221 = global_1.member.member_8.member_5.member;
let _e4223 = select(_e4216, _e1222, (_e1222 > _e4216));
let _e4225 = select(_e4221, _e4223, (_e4223 < _e4221));
let _e4230 = global_1.member.member_8.member_4.member_1;
let _e4235 = global_1.member.member_8.member_5.member_1;
let _e4237 = select(_e4230, _e1237, (_e1237 > _e4230));
let _e4239 = select(_e4235, _e4237, (_e4237 < _e4235));
let _e4244 = global_1.member.member_8.member_4.member_2;
let _e4249 = global_1.member.member_8.member_5.member_2;
let _e4251 = select(_e4244, _e1252, (_e1252 > _e4244));
let _e4253 = select(_e4249, _e4251, (_e4251 < _e4249));
let _e4258 = global_1.member.member_8.member_15;
let _e4259 = (_e4258 == 0u);
if _e4259 {
phi_9522_ = vec3<f32>(_e4225, _e4239, _e4253);
} else {
let _e4260 = (_e4225 + 0.5f);
let _e4265 = global_1.member.member_8.member_3.member;
let _e4266 = (_e4265 - 1f);
let _e4268 = select(0f, _e4260, (_e4260 > 0f));
let _e4270 = select(_e4266, _e4268, (_e4268 < _e4266));
let _e4277 = select(0i, select(select(i32(_e4270), i32(-2147483648), (_e4270 < -2147483600f)), 2147483647i, (_e4270 > 2147483500f)), (_e4270 == _e4270));
let _e4283 = (_e4239 + 0.5f);
let _e4288 = global_1.member.member_8.member_3.member_1;
let _e4289 = (_e4288 - 1f);
let _e4291 = select(0f, _e4283, (_e4283 > 0f));
let _e4293 = select(_e4289, _e4291, (_e4291 < _e4289));
let _e4300 = select(0i, select(select(i32(_e4293), i32(-2147483648), (_e4293 < -2147483600f)), 2147483647i, (_e4293 > 2147483500f)), (_e4293 == _e4293));
let _e4306 = (_e4253 + 0.5f);
let _e4311 = global_1.member.member_8.member_3.member_2;
let _e4312 = (_e4311 - 1f);
let _e4314 = select(0f, _e4306, (_e4306 > 0f));
let _e4316 = select(_e4312, _e4314, (_e4314 < _e4312));
let _e4323 = select(0i, select(select(i32(_e4316), i32(-2147483648), (_e4316 < -2147483600f)), 2147483647i, (_e4316 > 2147483500f)), (_e4316 == _e4316));
phi_9522_ = vec3<f32>(f32((_e4277 - select(0i, 1i, (_e4270 < f32(_e4277))))), f32((_e4300 - select(0i, 1i, (_e4293 < f32(_e4300))))), f32((_e4323 - select(0i, 1i, (_e4316 < f32(_e4323))))));
}
let _e4331 = phi_9522_;
let _e4337 = global_1.member.member_8.member_3.member;
let _e4339 = select(-1f, _e4331.x, (_e4331.x > -1f));
let _e4341 = select(_e4337, _e4339, (_e4339 < _e4337));
let _e4348 = select(0i, select(select(i32(_e4341), i32(-2147483648), (_e4341 < -2147483600f)), 2147483647i, (_e4341 > 2147483500f)), (_e4341 == _e4341));
let _e4352 = (_e4348 - select(0i, 1i, (_e4341 < f32(_e4348))));
let _e4358 = global_1.member.member_8.member_3.member_1;
let _e4360 = select(-1f, _e4331.y, (_e4331.y > -1f));
let _e4362 = select(_e4358, _e4360, (_e4360 < _e4358));
let _e4369 = select(0i, select(select(i32(_e4362), i32(-2147483648), (_e4362 < -2147483600f)), 2147483647i, (_e4362 > 2147483500f)), (_e4362 == _e4362));
let _e4373 = (_e4369 - select(0i, 1i, (_e4362 < f32(_e4369))));
let _e4379 = global_1.member.member_8.member_3.member_2;
let _e4381 = select(-1f, _e4331.z, (_e4331.z > -1f));
let _e4383 = select(_e4379, _e4381, (_e4381 < _e4379));
let _e4390 = select(0i, select(select(i32(_e4383), i32(-2147483648), (_e4383 < -2147483600f)), 2147483647i, (_e4383 > 2147483500f)), (_e4383 == _e4383));
let _e4394 = (_e4390 - select(0i, 1i, (_e4383 < f32(_e4390))));
let _e4398 = global_1.member.member_8.member_9;
let _e4402 = global_1.member.member_8.member_10;
let _e4410 = (select(0i, select(select(i32(_e4358), i32(-2147483648), (_e4358 < -2147483600f)), 2147483647i, (_e4358 > 2147483500f)), (_e4358 == _e4358)) - 1i);
let _e4413 = (_e4373 + 1i);
let _e4423 = (select(0i, select(select(i32(_e4379), i32(-2147483648), (_e4379 < -2147483600f)), 2147483647i, (_e4379 > 2147483500f)), (_e4379 == _e4379)) - 1i);
let _e4426 = (_e4394 + 1i);
let _e4436 = (select(0i, select(select(i32(_e4337), i32(-2147483648), (_e4337 < -2147483600f)), 2147483647i, (_e4337 > 2147483500f)), (_e4337 == _e4337)) - 1i);
let _e4437 = (_e4352 - 1i);
let _e4442 = (_e4352 + 1i);
let _e4445 = (_e4352 + 2i);
let _e4448 = (select(0i, _e4373, (_e4373 > 0i)) * _e4398);
let _e4449 = (select(_e4410, _e4413, (_e4413 < _e4410)) * _e4398);
let _e4450 = (select(0i, _e4394, (_e4394 > 0i)) * _e4402);
let _e4451 = (select(_e4423, _e4426, (_e4426 < _e4423)) * _e4402);
local_8 = type_30(array<i32, 4>(select(0i, _e4437, (_e4437 > 0i)), select(0i, _e4352, (_e4352 > 0i)), select(_e4436, _e4442, (_e4442 < _e4436)), select(_e4436, _e4445, (_e4445 < _e4436))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_9 = (_e4331 - vec3<f32>(f32(_e4352), f32(_e4373), f32(_e4394)));
let _e4460 = (_e4450 + _e4448);
let _e4463 = local_8.member[1u];
let _e4464 = (_e4460 + _e4463);
let _e4466 = (bitcast<i32>(_e172) - 1i);
let _e4468 = select(_e4466, _e4464, (_e4464 < _e4466));
let _e4473 = global_2.member[bitcast<u32>(select(0i, _e4468, (_e4468 > 0i)))];
let _e4474 = bitcast<f32>(_e4473);
let _e4477 = local_8.member[2u];
let _e4478 = (_e4460 + _e4477);
let _e4480 = select(_e4466, _e4478, (_e4478 < _e4466));
let _e4485 = global_2.member[bitcast<u32>(select(0i, _e4480, (_e4480 > 0i)))];
let _e4487 = local_9[0u];
let _e4490 = (_e4474 + ((bitcast<f32>(_e4485) - _e4474) * _e4487));
let _e4491 = (_e4450 + _e4449);
let _e4492 = local_8.member[1u];
let _e4493 = (_e4491 + _e4492);
let _e4495 = select(_e4466, _e4493, (_e4493 < _e4466));
let _e4500 = global_2.member[bitcast<u32>(select(0i, _e4495, (_e4495 > 0i)))];
let _e4501 = bitcast<f32>(_e4500);
let _e4502 = local_8.member[2u];
let _e4503 = (_e4491 + _e4502);
let _e4505 = select(_e4466, _e4503, (_e4503 < _e4466));
let _e4510 = global_2.member[bitcast<u32>(select(0i, _e4505, (_e4505 > 0i)))];
let _e4512 = local_9[0u];
let _e4517 = local_9[1u];
let _e4520 = (_e4490 + (((_e4501 + ((bitcast<f32>(_e4510) - _e4501) * _e4512)) - _e4490) * _e4517));
let _e4521 = (_e4451 + _e4448);
let _e4522 = local_8.member[1u];
let _e4523 = (_e4521 + _e4522);
let _e4525 = select(_e4466, _e4523, (_e4523 < _e4466));
let _e4530 = global_2.member[bitcast<u32>(select(0i, _e4525, (_e4525 > 0i)))];
let _e4531 = bitcast<f32>(_e4530);
let _e4532 = local_8.member[2u];
let _e4533 = (_e4521 + _e4532);
let _e4535 = select(_e4466, _e4533, (_e4533 < _e4466));
let _e4540 = global_2.member[bitcast<u32>(select(0i, _e4535, (_e4535 > 0i)))];
let _e4542 = local_9[0u];
let _e4545 = (_e4531 + ((bitcast<f32>(_e4540) - _e4531) * _e4542));
let _e4546 = (_e4451 + _e4449);
let _e4547 = local_8.member[1u];
let _e4548 = (_e4546 + _e4547);
let _e4550 = select(_e4466, _e4548, (_e4548 < _e4466));
let _e4555 = global_2.member[bitcast<u32>(select(0i, _e4550, (_e4550 > 0i)))];
let _e4556 = bitcast<f32>(_e4555);
let _e4557 = local_8.member[2u];
let _e4558 = (_e4546 + _e4557);
let _e4560 = select(_e4466, _e4558, (_e4558 < _e4466));
let _e4565 = global_2.member[bitcast<u32>(select(0i, _e4560, (_e4560 > 0i)))];
let _e4567 = local_9[0u];
let _e4571 = local_9[1u];
let _e4576 = local_9[2u];
let _e4583 = global_1.member.member_8.member_8;
let _e4587 = global_1.member.member_8.member_7;
let _e4589 = (((_e4520 + (((_e4545 + (((_e4556 + ((bitcast<f32>(_e4565) - _e4556) * _e4567)) - _e4545) * _e4571)) - _e4520) * _e4576)) - _e4583) * _e4587);
let _e4590 = -(1e9f);
let _e4592 = select(_e4590, _e4589, (_e4589 > _e4590));
let _e4597 = select(select(1e9f, _e4592, (_e4592 < 1e9f)), _e4211.member, (_e4258 != 0u));
let _e4600 = global_1.member.member_1;
let _e4602 = ((_e4600 & 16u) == 0u);
if _e4602 {
phi_10455_ = type_36(type_33(0f, 1f), type_33(0f, 1f), 1f);
} else {
let _e4606 = global_1.member.member_16.member;
let _e4617 = ((((_e4606.member.member * _e1179) + (_e4606.member.member_1 * _e1192)) + (_e4606.member.member_2 * _e1157)) + _e4606.member_1);
let _e4623 = ((((_e4606.member.member * _e1202) + (_e4606.member.member_1 * _e1207)) + (_e4606.member.member_2 * _e1196)) + _e4606.member_1);
let _e4630 = bitcast<f32>((bitcast<u32>((_e4617 - _e4623)) & 2147483647u));
let _e4633 = (bitcast<f32>((bitcast<u32>(_e4617) & 2147483647u)) / select(1e-30f, _e4630, (_e4630 > 1e-30f)));
let _e4635 = select(0f, _e4633, (_e4633 > 0f));
let _e4637 = select(1f, _e4635, (_e4635 < 1f));
let _e4638 = (_e4617 > 0f);
let _e4639 = (_e4623 > 0f);
let _e4641 = select(0f, select(_e4637, 1f, _e4639), _e4638);
let _e4643 = select(1f, select(_e4637, 1f, _e4638), _e4639);
let _e4647 = global_1.member.member_16.member_1;
let _e4648 = (_e4647 != 0u);
let _e4650 = select(_e4641, 0f, (0f > _e4641));
let _e4652 = select(_e4643, 1f, (1f < _e4643));
let _e4653 = select(0f, _e4641, _e4648);
let _e4654 = select(1f, _e4643, _e4648);
let _e4656 = select(_e4653, 0f, (0f > _e4653));
let _e4658 = select(_e4654, 1f, (1f < _e4654));
let _e4665 = global_1.member.member_17.member;
let _e4676 = ((((_e4665.member.member * _e1179) + (_e4665.member.member_1 * _e1192)) + (_e4665.member.member_2 * _e1157)) + _e4665.member_1);
let _e4682 = ((((_e4665.member.member * _e1202) + (_e4665.member.member_1 * _e1207)) + (_e4665.member.member_2 * _e1196)) + _e4665.member_1);
let _e4689 = bitcast<f32>((bitcast<u32>((_e4676 - _e4682)) & 2147483647u));
let _e4692 = (bitcast<f32>((bitcast<u32>(_e4676) & 2147483647u)) / select(1e-30f, _e4689, (_e4689 > 1e-30f)));
let _e4694 = select(0f, _e4692, (_e4692 > 0f));
let _e4696 = select(1f, _e4694, (_e4694 < 1f));
let _e4697 = (_e4676 > 0f);
let _e4698 = (_e4682 > 0f);
let _e4700 = select(0f, select(_e4696, 1f, _e4698), _e4697);
let _e4702 = select(1f, select(_e4696, 1f, _e4697), _e4698);
let _e4706 = global_1.member.member_17.member_1;
let _e4707 = (_e4706 != 0u);
let _e4709 = select(_e4700, _e4650, (_e4650 > _e4700));
let _e4711 = select(_e4702, _e4652, (_e4652 < _e4702));
let _e4712 = select(0f, _e4700, _e4707);
let _e4713 = select(1f, _e4702, _e4707);
let _e4715 = select(_e4712, _e4656, (_e4656 > _e4712));
let _e4717 = select(_e4713, _e4658, (_e4658 < _e4713));
let _e4724 = global_1.member.member_18.member;
let _e4735 = ((((_e4724.member.member * _e1179) + (_e4724.member.member_1 * _e1192)) + (_e4724.member.member_2 * _e1157)) + _e4724.member_1);
let _e4741 = ((((_e4724.member.member * _e1202) + (_e4724.member.member_1 * _e1207)) + (_e4724.member.member_2 * _e1196)) + _e4724.member_1);
let _e4748 = bitcast<f32>((bitcast<u32>((_e4735 - _e4741)) & 2147483647u));
let _e4751 = (bitcast<f32>((bitcast<u32>(_e4735) & 2147483647u)) / select(1e-30f, _e4748, (_e4748 > 1e-30f)));
let _e4753 = select(0f, _e4751, (_e4751 > 0f));
let _e4755 = select(1f, _e4753, (_e4753 < 1f));
let _e4756 = (_e4735 > 0f);
let _e4757 = (_e4741 > 0f);
let _e4759 = select(0f, select(_e4755, 1f, _e4757), _e4756);
let _e4761 = select(1f, select(_e4755, 1f, _e4756), _e4757);
let _e4765 = global_1.member.member_18.member_1;
let _e4766 = (_e4765 != 0u);
let _e4768 = select(_e4759, _e4709, (_e4709 > _e4759));
let _e4770 = select(_e4761, _e4711, (_e4711 < _e4761));
let _e4771 = select(0f, _e4759, _e4766);
let _e4772 = select(1f, _e4761, _e4766);
let _e4774 = select(_e4771, _e4715, (_e4715 > _e4771));
let _e4776 = select(_e4772, _e4717, (_e4717 < _e4772));
let _e4783 = global_1.member.member_19.member;
let _e4794 = ((((_e4783.member.member * _e1179) + (_e4783.member.member_1 * _e1192)) + (_e4783.member.member_2 * _e1157)) + _e4783.member_1);
let _e4800 = ((((_e4783.member.member * _e1202) + (_e4783.member.member_1 * _e1207)) + (_e4783.member.member_2 * _e1196)) + _e4783.member_1);
let _e4807 = bitcast<f32>((bitcast<u32>((_e4794 - _e4800)) & 2147483647u));
let _e4810 = (bitcast<f32>((bitcast<u32>(_e4794) & 2147483647u)) / select(1e-30f, _e4807, (_e4807 > 1e-30f)));
let _e4812 = select(0f, _e4810, (_e4810 > 0f));
let _e4814 = select(1f, _e4812, (_e4812 < 1f));
let _e4815 = (_e4794 > 0f);
let _e4816 = (_e4800 > 0f);
let _e4818 = select(0f, select(_e4814, 1f, _e4816), _e4815);
let _e4820 = select(1f, select(_e4814, 1f, _e4815), _e4816);
let _e4824 = global_1.member.member_19.member_1;
let _e4825 = (_e4824 != 0u);
let _e4830 = select(0f, _e4818, _e4825);
let _e4831 = select(1f, _e4820, _e4825);
phi_10455_ = type_36(type_33(select(_e4818, _e4768, (_e4768 > _e4818)), select(_e4820, _e4770, (_e4770 < _e4820))), type_33(select(_e4830, _e4774, (_e4774 > _e4830)), select(_e4831, _e4776, (_e4776 < _e4831))), ((((1f * select(1f, 0f, (_e4648 && _e4639))) * select(1f, 0f, (_e4707 && _e4698))) * select(1f, 0f, (_e4766 && _e4757))) * select(1f, 0f, (_e4825 && _e4816))));
}
let _e4843 = phi_10455_;
let _e4844 = (_e1258 - _e1222);
let _e4848 = (bitcast<f32>((bitcast<u32>(_e4844) & 2147483647u)) < 1e-12f);
let _e4850 = (1f / select(_e4844, 1f, _e4848));
let _e4851 = (_e4216 - _e1222);
let _e4852 = (_e4851 * _e4850);
let _e4854 = ((_e4221 - _e1222) * _e4850);
let _e4860 = select(_e4854, _e4852, (_e4852 < _e4854));
let _e4862 = select(0f, _e4860, (_e4860 > 0f));
let _e4865 = select(select(1f, _e4862, (_e4862 < 1f)), select(2f, 0f, ((_e1222 >= _e4216) && (_e1222 <= _e4221))), _e4848);
let _e4867 = select(_e4854, _e4852, (_e4852 > _e4854));
let _e4869 = select(0f, _e4867, (_e4867 > 0f));
let _e4872 = select(select(1f, _e4869, (_e4869 < 1f)), 1f, _e4848);
let _e4873 = (_e1264 - _e1237);
let _e4877 = (bitcast<f32>((bitcast<u32>(_e4873) & 2147483647u)) < 1e-12f);
let _e4879 = (1f / select(_e4873, 1f, _e4877));
let _e4880 = (_e4230 - _e1237);
let _e4881 = (_e4880 * _e4879);
let _e4883 = ((_e4235 - _e1237) * _e4879);
let _e4889 = select(_e4883, _e4881, (_e4881 < _e4883));
let _e4891 = select(0f, _e4889, (_e4889 > 0f));
let _e4894 = select(select(1f, _e4891, (_e4891 < 1f)), select(2f, 0f, ((_e1237 >= _e4230) && (_e1237 <= _e4235))), _e4877);
let _e4896 = select(_e4883, _e4881, (_e4881 > _e4883));
let _e4898 = select(0f, _e4896, (_e4896 > 0f));
let _e4901 = select(select(1f, _e4898, (_e4898 < 1f)), 1f, _e4877);
let _e4902 = (_e1270 - _e1252);
let _e4906 = (bitcast<f32>((bitcast<u32>(_e4902) & 2147483647u)) < 1e-12f);
let _e4908 = (1f / select(_e4902, 1f, _e4906));
let _e4909 = (_e4244 - _e1252);
let _e4910 = (_e4909 * _e4908);
let _e4912 = ((_e4249 - _e1252) * _e4908);
let _e4918 = select(_e4912, _e4910, (_e4910 < _e4912));
let _e4920 = select(0f, _e4918, (_e4918 > 0f));
let _e4923 = select(select(1f, _e4920, (_e4920 < 1f)), select(2f, 0f, ((_e1252 >= _e4244) && (_e1252 <= _e4249))), _e4906);
let _e4925 = select(_e4912, _e4910, (_e4910 > _e4912));
let _e4927 = select(0f, _e4925, (_e4925 > 0f));
let _e4930 = select(select(1f, _e4927, (_e4927 < 1f)), 1f, _e4906);
let _e4932 = select(_e4894, _e4865, (_e4865 > _e4894));
let _e4936 = select(_e4901, _e4872, (_e4872 < _e4901));
let _e4939 = (select(_e4930, _e4936, (_e4936 < _e4930)) - select(_e4923, _e4932, (_e4932 > _e4923)));
let _e4941 = select(0f, _e4939, (_e4939 > 0f));
let _e4942 = (_e1202 - _e1179);
let _e4943 = (_e1207 - _e1192);
let _e4944 = (_e1196 - _e1157);
let _e4949 = (((_e4942 * _e4942) + (_e4943 * _e4943)) + (_e4944 * _e4944));
let _e4957 = global_1.member.member_7.member_3;
let _e4958 = ((sqrt(select(0f, _e4949, (_e4949 > 0f))) * _e4941) * _e4957);
if (((_e187.member_2 == 3u) || (_e187.member_2 == 4u)) || _e1272) {
local_7 = _e4597;
let _e4963 = local_7;
let _e4965 = (bitcast<i32>(_e177) - 1i);
let _e4967 = select(_e4965, 263171i, (263171i < _e4965));
let _e4972 = global_3.member[bitcast<u32>(select(0i, _e4967, (_e4967 > 0i)))];
let _e4973 = bitcast<f32>(_e4972);
let _e4975 = select(_e4965, 263172i, (263172i < _e4965));
let _e4980 = global_3.member[bitcast<u32>(select(0i, _e4975, (_e4975 > 0i)))];
let _e4981 = bitcast<f32>(_e4980);
let _e4983 = select(_e4965, 263173i, (263173i < _e4965));
let _e4988 = global_3.member[bitcast<u32>(select(0i, _e4983, (_e4983 > 0i)))];
let _e4989 = bitcast<f32>(_e4988);
let _e4991 = ((_e4963 - _e4973) * _e4981);
let _e4993 = select(0f, _e4991, (_e4991 > 0f));
let _e4996 = local_7;
let _e4998 = select(_e4965, 263174i, (263174i < _e4965));
let _e5003 = global_3.member[bitcast<u32>(select(0i, _e4998, (_e4998 > 0i)))];
let _e5004 = bitcast<f32>(_e5003);
let _e5006 = select(_e4965, 263175i, (263175i < _e4965));
let _e5011 = global_3.member[bitcast<u32>(select(0i, _e5006, (_e5006 > 0i)))];
let _e5012 = bitcast<f32>(_e5011);
let _e5014 = select(_e4965, 263176i, (263176i < _e4965));
let _e5019 = global_3.member[bitcast<u32>(select(0i, _e5014, (_e5014 > 0i)))];
let _e5020 = bitcast<f32>(_e5019);
let _e5022 = ((_e4996 - _e5004) * _e5012);
let _e5024 = select(0f, _e5022, (_e5022 > 0f));
let _e5028 = local_7;
let _e5030 = select(_e4965, 263177i, (263177i < _e4965));
let _e5035 = global_3.member[bitcast<u32>(select(0i, _e5030, (_e5030 > 0i)))];
let _e5036 = bitcast<f32>(_e5035);
let _e5038 = select(_e4965, 263178i, (263178i < _e4965));
let _e5043 = global_3.member[bitcast<u32>(select(0i, _e5038, (_e5038 > 0i)))];
let _e5044 = bitcast<f32>(_e5043);
let _e5046 = select(_e4965, 263179i, (263179i < _e4965));
let _e5051 = global_3.member[bitcast<u32>(select(0i, _e5046, (_e5046 > 0i)))];
let _e5052 = bitcast<f32>(_e5051);
let _e5054 = ((_e5028 - _e5036) * _e5044);
let _e5056 = select(0f, _e5054, (_e5054 > 0f));
let _e5059 = local_7;
let _e5061 = select(_e4965, 263180i, (263180i < _e4965));
let _e5066 = global_3.member[bitcast<u32>(select(0i, _e5061, (_e5061 > 0i)))];
let _e5067 = bitcast<f32>(_e5066);
let _e5069 = select(_e4965, 263181i, (263181i < _e4965));
let _e5074 = global_3.member[bitcast<u32>(select(0i, _e5069, (_e5069 > 0i)))];
let _e5075 = bitcast<f32>(_e5074);
let _e5077 = select(_e4965, 263182i, (263182i < _e4965));
let _e5082 = global_3.member[bitcast<u32>(select(0i, _e5077, (_e5077 > 0i)))];
let _e5083 = bitcast<f32>(_e5082);
let _e5085 = ((_e5059 - _e5067) * _e5075);
let _e5087 = select(0f, _e5085, (_e5085 > 0f));
let _e5092 = local_7;
let _e5094 = select(_e4965, 263183i, (263183i < _e4965));
let _e5099 = global_3.member[bitcast<u32>(select(0i, _e5094, (_e5094 > 0i)))];
let _e5100 = bitcast<f32>(_e5099);
let _e5102 = select(_e4965, 263184i, (263184i < _e4965));
let _e5107 = global_3.member[bitcast<u32>(select(0i, _e5102, (_e5102 > 0i)))];
let _e5108 = bitcast<f32>(_e5107);
let _e5110 = select(_e4965, 263185i, (263185i < _e4965));
let _e5115 = global_3.member[bitcast<u32>(select(0i, _e5110, (_e5110 > 0i)))];
let _e5116 = bitcast<f32>(_e5115);
let _e5118 = ((_e5092 - _e5100) * _e5108);
let _e5120 = select(0f, _e5118, (_e5118 > 0f));
let _e5123 = local_7;
let _e5125 = select(_e4965, 263186i, (263186i < _e4965));
let _e5130 = global_3.member[bitcast<u32>(select(0i, _e5125, (_e5125 > 0i)))];
let _e5131 = bitcast<f32>(_e5130);
let _e5133 = select(_e4965, 263187i, (263187i < _e4965));
let _e5138 = global_3.member[bitcast<u32>(select(0i, _e5133, (_e5133 > 0i)))];
let _e5139 = bitcast<f32>(_e5138);
let _e5141 = select(_e4965, 263188i, (263188i < _e4965));
let _e5146 = global_3.member[bitcast<u32>(select(0i, _e5141, (_e5141 > 0i)))];
let _e5147 = bitcast<f32>(_e5146);
let _e5149 = ((_e5123 - _e5131) * _e5139);
let _e5151 = select(0f, _e5149, (_e5149 > 0f));
let _e5155 = local_7;
let _e5157 = select(_e4965, 263189i, (263189i < _e4965));
let _e5162 = global_3.member[bitcast<u32>(select(0i, _e5157, (_e5157 > 0i)))];
let _e5163 = bitcast<f32>(_e5162);
let _e5165 = select(_e4965, 263190i, (263190i < _e4965));
let _e5170 = global_3.member[bitcast<u32>(select(0i, _e5165, (_e5165 > 0i)))];
let _e5171 = bitcast<f32>(_e5170);
let _e5173 = select(_e4965, 263191i, (263191i < _e4965));
let _e5178 = global_3.member[bitcast<u32>(select(0i, _e5173, (_e5173 > 0i)))];
let _e5179 = bitcast<f32>(_e5178);
let _e5181 = ((_e5155 - _e5163) * _e5171);
let _e5183 = select(0f, _e5181, (_e5181 > 0f));
let _e5186 = local_7;
let _e5188 = select(_e4965, 263192i, (263192i < _e4965));
let _e5193 = global_3.member[bitcast<u32>(select(0i, _e5188, (_e5188 > 0i)))];
let _e5194 = bitcast<f32>(_e5193);
let _e5196 = select(_e4965, 263193i, (263193i < _e4965));
let _e5201 = global_3.member[bitcast<u32>(select(0i, _e5196, (_e5196 > 0i)))];
let _e5202 = bitcast<f32>(_e5201);
let _e5204 = select(_e4965, 263194i, (263194i < _e4965));
let _e5209 = global_3.member[bitcast<u32>(select(0i, _e5204, (_e5204 > 0i)))];
let _e5210 = bitcast<f32>(_e5209);
let _e5212 = ((_e5186 - _e5194) * _e5202);
let _e5214 = select(0f, _e5212, (_e5212 > 0f));
let _e5219 = (((select(_e4989, _e4993, (_e4993 < _e4989)) + select(_e5020, _e5024, (_e5024 < _e5020))) + (select(_e5052, _e5056, (_e5056 < _e5052)) + select(_e5083, _e5087, (_e5087 < _e5083)))) + ((select(_e5116, _e5120, (_e5120 < _e5116)) + select(_e5147, _e5151, (_e5151 < _e5147))) + (select(_e5179, _e5183, (_e5183 < _e5179)) + select(_e5210, _e5214, (_e5214 < _e5210)))));
local_6 = _e4211.member;
let _e5220 = local_6;
let _e5222 = ((_e5220 - _e4973) * _e4981);
let _e5224 = select(0f, _e5222, (_e5222 > 0f));
let _e5227 = local_6;
let _e5229 = ((_e5227 - _e5004) * _e5012);
let _e5231 = select(0f, _e5229, (_e5229 > 0f));
let _e5235 = local_6;
let _e5237 = ((_e5235 - _e5036) * _e5044);
let _e5239 = select(0f, _e5237, (_e5237 > 0f));
let _e5242 = local_6;
let _e5244 = ((_e5242 - _e5067) * _e5075);
let _e5246 = select(0f, _e5244, (_e5244 > 0f));
let _e5251 = local_6;
let _e5253 = ((_e5251 - _e5100) * _e5108);
let _e5255 = select(0f, _e5253, (_e5253 > 0f));
let _e5258 = local_6;
let _e5260 = ((_e5258 - _e5131) * _e5139);
let _e5262 = select(0f, _e5260, (_e5260 > 0f));
let _e5266 = local_6;
let _e5268 = ((_e5266 - _e5163) * _e5171);
let _e5270 = select(0f, _e5268, (_e5268 > 0f));
let _e5273 = local_6;
let _e5275 = ((_e5273 - _e5194) * _e5202);
let _e5277 = select(0f, _e5275, (_e5275 > 0f));
let _e5282 = (((select(_e4989, _e5224, (_e5224 < _e4989)) + select(_e5020, _e5231, (_e5231 < _e5020))) + (select(_e5052, _e5239, (_e5239 < _e5052)) + select(_e5083, _e5246, (_e5246 < _e5083)))) + ((select(_e5116, _e5255, (_e5255 < _e5116)) + select(_e5147, _e5262, (_e5262 < _e5147))) + (select(_e5179, _e5270, (_e5270 < _e5179)) + select(_e5210, _e5277, (_e5277 < _e5210)))));
let _e5283 = (255f - 1f);
let _e5285 = select(0f, _e5219, (_e5219 > 0f));
let _e5287 = select(_e5283, _e5285, (_e5285 < _e5283));
let _e5294 = select(0i, select(select(i32(_e5287), i32(-2147483648), (_e5287 < -2147483600f)), 2147483647i, (_e5287 > 2147483500f)), (_e5287 == _e5287));
let _e5298 = (_e5294 - select(0i, 1i, (_e5287 < f32(_e5294))));
let _e5300 = select(0f, _e5282, (_e5282 > 0f));
let _e5302 = select(_e5283, _e5300, (_e5300 < _e5283));
let _e5309 = select(0i, select(select(i32(_e5302), i32(-2147483648), (_e5302 < -2147483600f)), 2147483647i, (_e5302 > 2147483500f)), (_e5302 == _e5302));
let _e5313 = (_e5309 - select(0i, 1i, (_e5302 < f32(_e5309))));
let _e5315 = select(_e4965, 263195i, (263195i < _e4965));
let _e5321 = global_3.member[bitcast<u32>(select(0i, _e5315, (_e5315 > 0i)))];
let _e5322 = bitcast<f32>(_e5321);
let _e5324 = select(_e4965, 263196i, (263196i < _e4965));
let _e5330 = global_3.member[bitcast<u32>(select(0i, _e5324, (_e5324 > 0i)))];
let _e5331 = bitcast<f32>(_e5330);
let _e5332 = (_e4211.member - _e4597);
let _e5338 = (1f / select(_e5332, 1f, (bitcast<f32>((bitcast<u32>(_e5332) & 2147483647u)) < 1e-20f)));
let _e5344 = ((select(_e5322, _e4211.member, (_e4211.member < _e5322)) - select(_e5322, _e4597, (_e4597 < _e5322))) * _e5338);
let _e5350 = ((select(_e5331, _e4211.member, (_e4211.member > _e5331)) - select(_e5331, _e4597, (_e4597 > _e5331))) * _e5338);
let _e5353 = (((_e5298 * 256i) + _e5313) * 4i);
let _e5357 = (_e5282 - f32(_e5313));
let _e5360 = (_e5353 + 1i);
let _e5362 = select(_e4965, _e5360, (_e5360 < _e4965));
let _e5368 = global_3.member[bitcast<u32>(select(0i, _e5362, (_e5362 > 0i)))];
let _e5375 = (bitcast<f32>((((_e5368 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5376 = (_e5353 + 5i);
let _e5378 = select(_e4965, _e5376, (_e5376 < _e4965));
let _e5384 = global_3.member[bitcast<u32>(select(0i, _e5378, (_e5378 > 0i)))];
let _e5392 = (_e5353 + 1025i);
let _e5394 = select(_e4965, _e5392, (_e5392 < _e4965));
let _e5400 = global_3.member[bitcast<u32>(select(0i, _e5394, (_e5394 > 0i)))];
let _e5407 = (bitcast<f32>((((_e5400 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5408 = (_e5353 + 1029i);
let _e5410 = select(_e4965, _e5408, (_e5408 < _e4965));
let _e5416 = global_3.member[bitcast<u32>(select(0i, _e5410, (_e5410 > 0i)))];
let _e5426 = (_e5375 + (((bitcast<f32>((((_e5384 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5375) * _e5357));
let _e5434 = select(_e4965, 1i, (1i < _e4965));
let _e5440 = global_3.member[bitcast<u32>(select(0i, _e5434, (_e5434 > 0i)))];
let _e5449 = select(_e4965, 262141i, (262141i < _e4965));
let _e5455 = global_3.member[bitcast<u32>(select(0i, _e5449, (_e5449 > 0i)))];
let _e5467 = (((_e5426 + (((_e5407 + (((bitcast<f32>((((_e5416 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5407) * _e5357)) - _e5426) * (_e5219 - f32(_e5298)))) * (1f - (_e5344 + _e5350))) + (((bitcast<f32>((((_e5440 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5344) + ((bitcast<f32>((((_e5455 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5350)));
let _e5472 = (_e4843.member.member_1 - _e4843.member.member);
let _e5477 = -((_e5467 * (_e4958 * select(0f, _e5472, (_e5472 > 0f)))));
let _e5479 = select(-87f, _e5477, (_e5477 > -87f));
let _e5481 = select(88f, _e5479, (_e5479 < 88f));
let _e5483 = ((_e5481 * 1.442695f) + 0.5f);
let _e5485 = select(-127f, _e5483, (_e5483 > -127f));
let _e5487 = select(128f, _e5485, (_e5485 < 128f));
let _e5494 = select(0i, select(select(i32(_e5487), i32(-2147483648), (_e5487 < -2147483600f)), 2147483647i, (_e5487 > 2147483500f)), (_e5487 == _e5487));
let _e5498 = (_e5494 - select(0i, 1i, (_e5487 < f32(_e5494))));
let _e5499 = f32(_e5498);
let _e5503 = ((_e5481 - (_e5499 * 0.6933594f)) - (_e5499 * -2.1219444e-4f));
let _e5523 = ((1f + (_e5503 * (1f + (_e5503 * (0.5f + (_e5503 * (0.16666667f + (_e5503 * (0.041666668f + (_e5503 * (0.008333334f + (_e5503 * (0.001388889f + (_e5503 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5498 + 127i)) << bitcast<u32>(23i))));
let _e5524 = (1f - _e5523);
phi_14399_ = type_38(_e5523, _e5524, vec3<f32>(1f, 1f, 1f), vec3((0f * (_e5524 / select(1e-12f, _e5467, (_e5467 > 1e-12f))))));
} else {
local_5 = _e4597;
let _e5531 = local_5;
let _e5533 = (bitcast<i32>(_e177) - 1i);
let _e5535 = select(_e5533, 263171i, (263171i < _e5533));
let _e5540 = global_3.member[bitcast<u32>(select(0i, _e5535, (_e5535 > 0i)))];
let _e5541 = bitcast<f32>(_e5540);
let _e5543 = select(_e5533, 263172i, (263172i < _e5533));
let _e5548 = global_3.member[bitcast<u32>(select(0i, _e5543, (_e5543 > 0i)))];
let _e5549 = bitcast<f32>(_e5548);
let _e5551 = select(_e5533, 263173i, (263173i < _e5533));
let _e5556 = global_3.member[bitcast<u32>(select(0i, _e5551, (_e5551 > 0i)))];
let _e5557 = bitcast<f32>(_e5556);
let _e5559 = ((_e5531 - _e5541) * _e5549);
let _e5561 = select(0f, _e5559, (_e5559 > 0f));
let _e5564 = local_5;
let _e5566 = select(_e5533, 263174i, (263174i < _e5533));
let _e5571 = global_3.member[bitcast<u32>(select(0i, _e5566, (_e5566 > 0i)))];
let _e5572 = bitcast<f32>(_e5571);
let _e5574 = select(_e5533, 263175i, (263175i < _e5533));
let _e5579 = global_3.member[bitcast<u32>(select(0i, _e5574, (_e5574 > 0i)))];
let _e5580 = bitcast<f32>(_e5579);
let _e5582 = select(_e5533, 263176i, (263176i < _e5533));
let _e5587 = global_3.member[bitcast<u32>(select(0i, _e5582, (_e5582 > 0i)))];
let _e5588 = bitcast<f32>(_e5587);
let _e5590 = ((_e5564 - _e5572) * _e5580);
let _e5592 = select(0f, _e5590, (_e5590 > 0f));
let _e5596 = local_5;
let _e5598 = select(_e5533, 263177i, (263177i < _e5533));
let _e5603 = global_3.member[bitcast<u32>(select(0i, _e5598, (_e5598 > 0i)))];
let _e5604 = bitcast<f32>(_e5603);
let _e5606 = select(_e5533, 263178i, (263178i < _e5533));
let _e5611 = global_3.member[bitcast<u32>(select(0i, _e5606, (_e5606 > 0i)))];
let _e5612 = bitcast<f32>(_e5611);
let _e5614 = select(_e5533, 263179i, (263179i < _e5533));
let _e5619 = global_3.member[bitcast<u32>(select(0i, _e5614, (_e5614 > 0i)))];
let _e5620 = bitcast<f32>(_e5619);
let _e5622 = ((_e5596 - _e5604) * _e5612);
let _e5624 = select(0f, _e5622, (_e5622 > 0f));
let _e5627 = local_5;
let _e5629 = select(_e5533, 263180i, (263180i < _e5533));
let _e5634 = global_3.member[bitcast<u32>(select(0i, _e5629, (_e5629 > 0i)))];
let _e5635 = bitcast<f32>(_e5634);
let _e5637 = select(_e5533, 263181i, (263181i < _e5533));
let _e5642 = global_3.member[bitcast<u32>(select(0i, _e5637, (_e5637 > 0i)))];
let _e5643 = bitcast<f32>(_e5642);
let _e5645 = select(_e5533, 263182i, (263182i < _e5533));
let _e5650 = global_3.member[bitcast<u32>(select(0i, _e5645, (_e5645 > 0i)))];
let _e5651 = bitcast<f32>(_e5650);
let _e5653 = ((_e5627 - _e5635) * _e5643);
let _e5655 = select(0f, _e5653, (_e5653 > 0f));
let _e5660 = local_5;
let _e5662 = select(_e5533, 263183i, (263183i < _e5533));
let _e5667 = global_3.member[bitcast<u32>(select(0i, _e5662, (_e5662 > 0i)))];
let _e5668 = bitcast<f32>(_e5667);
let _e5670 = select(_e5533, 263184i, (263184i < _e5533));
let _e5675 = global_3.member[bitcast<u32>(select(0i, _e5670, (_e5670 > 0i)))];
let _e5676 = bitcast<f32>(_e5675);
let _e5678 = select(_e5533, 263185i, (263185i < _e5533));
let _e5683 = global_3.member[bitcast<u32>(select(0i, _e5678, (_e5678 > 0i)))];
let _e5684 = bitcast<f32>(_e5683);
let _e5686 = ((_e5660 - _e5668) * _e5676);
let _e5688 = select(0f, _e5686, (_e5686 > 0f));
let _e5691 = local_5;
let _e5693 = select(_e5533, 263186i, (263186i < _e5533));
let _e5698 = global_3.member[bitcast<u32>(select(0i, _e5693, (_e5693 > 0i)))];
let _e5699 = bitcast<f32>(_e5698);
let _e5701 = select(_e5533, 263187i, (263187i < _e5533));
let _e5706 = global_3.member[bitcast<u32>(select(0i, _e5701, (_e5701 > 0i)))];
let _e5707 = bitcast<f32>(_e5706);
let _e5709 = select(_e5533, 263188i, (263188i < _e5533));
let _e5714 = global_3.member[bitcast<u32>(select(0i, _e5709, (_e5709 > 0i)))];
let _e5715 = bitcast<f32>(_e5714);
let _e5717 = ((_e5691 - _e5699) * _e5707);
let _e5719 = select(0f, _e5717, (_e5717 > 0f));
let _e5723 = local_5;
let _e5725 = select(_e5533, 263189i, (263189i < _e5533));
let _e5730 = global_3.member[bitcast<u32>(select(0i, _e5725, (_e5725 > 0i)))];
let _e5731 = bitcast<f32>(_e5730);
let _e5733 = select(_e5533, 263190i, (263190i < _e5533));
let _e5738 = global_3.member[bitcast<u32>(select(0i, _e5733, (_e5733 > 0i)))];
let _e5739 = bitcast<f32>(_e5738);
let _e5741 = select(_e5533, 263191i, (263191i < _e5533));
let _e5746 = global_3.member[bitcast<u32>(select(0i, _e5741, (_e5741 > 0i)))];
let _e5747 = bitcast<f32>(_e5746);
let _e5749 = ((_e5723 - _e5731) * _e5739);
let _e5751 = select(0f, _e5749, (_e5749 > 0f));
let _e5754 = local_5;
let _e5756 = select(_e5533, 263192i, (263192i < _e5533));
let _e5761 = global_3.member[bitcast<u32>(select(0i, _e5756, (_e5756 > 0i)))];
let _e5762 = bitcast<f32>(_e5761);
let _e5764 = select(_e5533, 263193i, (263193i < _e5533));
let _e5769 = global_3.member[bitcast<u32>(select(0i, _e5764, (_e5764 > 0i)))];
let _e5770 = bitcast<f32>(_e5769);
let _e5772 = select(_e5533, 263194i, (263194i < _e5533));
let _e5777 = global_3.member[bitcast<u32>(select(0i, _e5772, (_e5772 > 0i)))];
let _e5778 = bitcast<f32>(_e5777);
let _e5780 = ((_e5754 - _e5762) * _e5770);
let _e5782 = select(0f, _e5780, (_e5780 > 0f));
let _e5787 = (((select(_e5557, _e5561, (_e5561 < _e5557)) + select(_e5588, _e5592, (_e5592 < _e5588))) + (select(_e5620, _e5624, (_e5624 < _e5620)) + select(_e5651, _e5655, (_e5655 < _e5651)))) + ((select(_e5684, _e5688, (_e5688 < _e5684)) + select(_e5715, _e5719, (_e5719 < _e5715))) + (select(_e5747, _e5751, (_e5751 < _e5747)) + select(_e5778, _e5782, (_e5782 < _e5778)))));
local_4 = _e4211.member;
let _e5788 = local_4;
let _e5790 = ((_e5788 - _e5541) * _e5549);
let _e5792 = select(0f, _e5790, (_e5790 > 0f));
let _e5795 = local_4;
let _e5797 = ((_e5795 - _e5572) * _e5580);
let _e5799 = select(0f, _e5797, (_e5797 > 0f));
let _e5803 = local_4;
let _e5805 = ((_e5803 - _e5604) * _e5612);
let _e5807 = select(0f, _e5805, (_e5805 > 0f));
let _e5810 = local_4;
let _e5812 = ((_e5810 - _e5635) * _e5643);
let _e5814 = select(0f, _e5812, (_e5812 > 0f));
let _e5819 = local_4;
let _e5821 = ((_e5819 - _e5668) * _e5676);
let _e5823 = select(0f, _e5821, (_e5821 > 0f));
let _e5826 = local_4;
let _e5828 = ((_e5826 - _e5699) * _e5707);
let _e5830 = select(0f, _e5828, (_e5828 > 0f));
let _e5834 = local_4;
let _e5836 = ((_e5834 - _e5731) * _e5739);
let _e5838 = select(0f, _e5836, (_e5836 > 0f));
let _e5841 = local_4;
let _e5843 = ((_e5841 - _e5762) * _e5770);
let _e5845 = select(0f, _e5843, (_e5843 > 0f));
let _e5850 = (((select(_e5557, _e5792, (_e5792 < _e5557)) + select(_e5588, _e5799, (_e5799 < _e5588))) + (select(_e5620, _e5807, (_e5807 < _e5620)) + select(_e5651, _e5814, (_e5814 < _e5651)))) + ((select(_e5684, _e5823, (_e5823 < _e5684)) + select(_e5715, _e5830, (_e5830 < _e5715))) + (select(_e5747, _e5838, (_e5838 < _e5747)) + select(_e5778, _e5845, (_e5845 < _e5778)))));
let _e5851 = (255f - 1f);
let _e5853 = select(0f, _e5787, (_e5787 > 0f));
let _e5855 = select(_e5851, _e5853, (_e5853 < _e5851));
let _e5862 = select(0i, select(select(i32(_e5855), i32(-2147483648), (_e5855 < -2147483600f)), 2147483647i, (_e5855 > 2147483500f)), (_e5855 == _e5855));
let _e5866 = (_e5862 - select(0i, 1i, (_e5855 < f32(_e5862))));
let _e5868 = select(0f, _e5850, (_e5850 > 0f));
let _e5870 = select(_e5851, _e5868, (_e5868 < _e5851));
let _e5877 = select(0i, select(select(i32(_e5870), i32(-2147483648), (_e5870 < -2147483600f)), 2147483647i, (_e5870 > 2147483500f)), (_e5870 == _e5870));
let _e5881 = (_e5877 - select(0i, 1i, (_e5870 < f32(_e5877))));
let _e5883 = select(_e5533, 263195i, (263195i < _e5533));
let _e5889 = global_3.member[bitcast<u32>(select(0i, _e5883, (_e5883 > 0i)))];
let _e5890 = bitcast<f32>(_e5889);
let _e5892 = select(_e5533, 263196i, (263196i < _e5533));
let _e5898 = global_3.member[bitcast<u32>(select(0i, _e5892, (_e5892 > 0i)))];
let _e5899 = bitcast<f32>(_e5898);
let _e5900 = (_e4211.member - _e4597);
let _e5906 = (1f / select(_e5900, 1f, (bitcast<f32>((bitcast<u32>(_e5900) & 2147483647u)) < 1e-20f)));
let _e5912 = ((select(_e5890, _e4211.member, (_e4211.member < _e5890)) - select(_e5890, _e4597, (_e4597 < _e5890))) * _e5906);
let _e5918 = ((select(_e5899, _e4211.member, (_e4211.member > _e5899)) - select(_e5899, _e4597, (_e4597 > _e5899))) * _e5906);
let _e5921 = (((_e5866 * 256i) + _e5881) * 4i);
let _e5923 = (_e5787 - f32(_e5866));
let _e5925 = (_e5850 - f32(_e5881));
let _e5927 = (1f - (_e5912 + _e5918));
let _e5929 = select(_e5533, _e5921, (_e5921 < _e5533));
let _e5935 = global_3.member[bitcast<u32>(select(0i, _e5929, (_e5929 > 0i)))];
let _e5940 = (bitcast<f32>(((_e5935 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5947 = (bitcast<f32>((((_e5935 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5948 = (_e5921 + 4i);
let _e5950 = select(_e5533, _e5948, (_e5948 < _e5533));
let _e5956 = global_3.member[bitcast<u32>(select(0i, _e5950, (_e5950 > 0i)))];
let _e5969 = (_e5921 + 1024i);
let _e5971 = select(_e5533, _e5969, (_e5969 < _e5533));
let _e5977 = global_3.member[bitcast<u32>(select(0i, _e5971, (_e5971 > 0i)))];
let _e5982 = (bitcast<f32>(((_e5977 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5989 = (bitcast<f32>((((_e5977 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5990 = (_e5921 + 1028i);
let _e5992 = select(_e5533, _e5990, (_e5990 < _e5533));
let _e5998 = global_3.member[bitcast<u32>(select(0i, _e5992, (_e5992 > 0i)))];
let _e6013 = (_e5940 + (((bitcast<f32>(((_e5956 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5940) * _e5925));
let _e6022 = (_e5947 + (((bitcast<f32>((((_e5956 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5947) * _e5925));
let _e6030 = select(_e5533, 0i, (0i < _e5533));
let _e6036 = global_3.member[bitcast<u32>(select(0i, _e6030, (_e6030 > 0i)))];
let _e6050 = select(_e5533, 262140i, (262140i < _e5533));
let _e6056 = global_3.member[bitcast<u32>(select(0i, _e6050, (_e6050 > 0i)))];
let _e6079 = (_e5921 + 1i);
let _e6081 = select(_e5533, _e6079, (_e6079 < _e5533));
let _e6087 = global_3.member[bitcast<u32>(select(0i, _e6081, (_e6081 > 0i)))];
let _e6092 = (bitcast<f32>(((_e6087 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e6099 = (bitcast<f32>((((_e6087 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e6100 = (_e5921 + 5i);
let _e6102 = select(_e5533, _e6100, (_e6100 < _e5533));
let _e6108 = global_3.member[bitcast<u32>(select(0i, _e6102, (_e6102 > 0i)))];
let _e6121 = (_e5921 + 1025i);
let _e6123 = select(_e5533, _e6121, (_e6121 < _e5533));
let _e6129 = global_3.member[bitcast<u32>(select(0i, _e6123, (_e6123 > 0i)))];
let _e6134 = (bitcast<f32>(((_e6129 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e6141 = (bitcast<f32>((((_e6129 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e6142 = (_e5921 + 1029i);
let _e6144 = select(_e5533, _e6142, (_e6142 < _e5533));
let _e6150 = global_3.member[bitcast<u32>(select(0i, _e6144, (_e6144 > 0i)))];
let _e6165 = (_e6092 + (((bitcast<f32>(((_e6108 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e6092) * _e5925));
let _e6174 = (_e6099 + (((bitcast<f32>((((_e6108 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e6099) * _e5925));
let _e6182 = select(_e5533, 1i, (1i < _e5533));
let _e6188 = global_3.member[bitcast<u32>(select(0i, _e6182, (_e6182 > 0i)))];
let _e6202 = select(_e5533, 262141i, (262141i < _e5533));
let _e6208 = global_3.member[bitcast<u32>(select(0i, _e6202, (_e6202 > 0i)))];
let _e6230 = (((_e6174 + (((_e6141 + (((bitcast<f32>((((_e6150 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e6141) * _e5925)) - _e6174) * _e5923)) * _e5927) + (((bitcast<f32>((((_e6188 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5912) + ((bitcast<f32>((((_e6208 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5918)));
let _e6235 = (_e4843.member.member_1 - _e4843.member.member);
let _e6243 = (_e4843.member_1.member_1 - _e4843.member_1.member);
let _e6246 = (_e4958 * select(0f, _e6243, (_e6243 > 0f)));
let _e6248 = -(((((_e6165 + (((_e6134 + (((bitcast<f32>(((_e6150 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e6134) * _e5925)) - _e6165) * _e5923)) * _e5927) + (((bitcast<f32>(((_e6188 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5912) + ((bitcast<f32>(((_e6208 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5918))) * _e6246));
let _e6250 = select(-87f, _e6248, (_e6248 > -87f));
let _e6252 = select(88f, _e6250, (_e6250 < 88f));
let _e6254 = ((_e6252 * 1.442695f) + 0.5f);
let _e6256 = select(-127f, _e6254, (_e6254 > -127f));
let _e6258 = select(128f, _e6256, (_e6256 < 128f));
let _e6265 = select(0i, select(select(i32(_e6258), i32(-2147483648), (_e6258 < -2147483600f)), 2147483647i, (_e6258 > 2147483500f)), (_e6258 == _e6258));
let _e6269 = (_e6265 - select(0i, 1i, (_e6258 < f32(_e6265))));
let _e6270 = f32(_e6269);
let _e6274 = ((_e6252 - (_e6270 * 0.6933594f)) - (_e6270 * -2.1219444e-4f));
let _e6296 = -(((((_e6013 + (((_e5982 + (((bitcast<f32>(((_e5998 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5982) * _e5925)) - _e6013) * _e5923)) * _e5927) + (((bitcast<f32>(((_e6036 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5912) + ((bitcast<f32>(((_e6056 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5918))) * _e6246));
let _e6298 = select(-87f, _e6296, (_e6296 > -87f));
let _e6300 = select(88f, _e6298, (_e6298 < 88f));
let _e6302 = ((_e6300 * 1.442695f) + 0.5f);
let _e6304 = select(-127f, _e6302, (_e6302 > -127f));
let _e6306 = select(128f, _e6304, (_e6304 < 128f));
let _e6313 = select(0i, select(select(i32(_e6306), i32(-2147483648), (_e6306 < -2147483600f)), 2147483647i, (_e6306 > 2147483500f)), (_e6306 == _e6306));
let _e6317 = (_e6313 - select(0i, 1i, (_e6306 < f32(_e6313))));
let _e6318 = f32(_e6317);
let _e6322 = ((_e6300 - (_e6318 * 0.6933594f)) - (_e6318 * -2.1219444e-4f));
let _e6344 = -(((((_e6022 + (((_e5989 + (((bitcast<f32>((((_e5998 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5989) * _e5925)) - _e6022) * _e5923)) * _e5927) + (((bitcast<f32>((((_e6036 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5912) + ((bitcast<f32>((((_e6056 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5918))) * _e6246));
let _e6346 = select(-87f, _e6344, (_e6344 > -87f));
let _e6348 = select(88f, _e6346, (_e6346 < 88f));
let _e6350 = ((_e6348 * 1.442695f) + 0.5f);
let _e6352 = select(-127f, _e6350, (_e6350 > -127f));
let _e6354 = select(128f, _e6352, (_e6352 < 128f));
let _e6361 = select(0i, select(select(i32(_e6354), i32(-2147483648), (_e6354 < -2147483600f)), 2147483647i, (_e6354 > 2147483500f)), (_e6354 == _e6354));
let _e6365 = (_e6361 - select(0i, 1i, (_e6354 < f32(_e6361))));
let _e6366 = f32(_e6365);
let _e6370 = ((_e6348 - (_e6366 * 0.6933594f)) - (_e6366 * -2.1219444e-4f));
let _e6393 = -((_e6230 * (_e4958 * select(0f, _e6235, (_e6235 > 0f)))));
let _e6395 = select(-87f, _e6393, (_e6393 > -87f));
let _e6397 = select(88f, _e6395, (_e6395 < 88f));
let _e6399 = ((_e6397 * 1.442695f) + 0.5f);
let _e6401 = select(-127f, _e6399, (_e6399 > -127f));
let _e6403 = select(128f, _e6401, (_e6401 < 128f));
let _e6410 = select(0i, select(select(i32(_e6403), i32(-2147483648), (_e6403 < -2147483600f)), 2147483647i, (_e6403 > 2147483500f)), (_e6403 == _e6403));
let _e6414 = (_e6410 - select(0i, 1i, (_e6403 < f32(_e6410))));
let _e6415 = f32(_e6414);
let _e6419 = ((_e6397 - (_e6415 * 0.6933594f)) - (_e6415 * -2.1219444e-4f));
let _e6439 = ((1f + (_e6419 * (1f + (_e6419 * (0.5f + (_e6419 * (0.16666667f + (_e6419 * (0.041666668f + (_e6419 * (0.008333334f + (_e6419 * (0.001388889f + (_e6419 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6414 + 127i)) << bitcast<u32>(23i))));
let _e6440 = (1f - _e6439);
phi_14399_ = type_38(_e6439, _e6440, vec3<f32>(((1f + (_e6274 * (1f + (_e6274 * (0.5f + (_e6274 * (0.16666667f + (_e6274 * (0.041666668f + (_e6274 * (0.008333334f + (_e6274 * (0.001388889f + (_e6274 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6269 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e6322 * (1f + (_e6322 * (0.5f + (_e6322 * (0.16666667f + (_e6322 * (0.041666668f + (_e6322 * (0.008333334f + (_e6322 * (0.001388889f + (_e6322 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6317 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e6370 * (1f + (_e6370 * (0.5f + (_e6370 * (0.16666667f + (_e6370 * (0.041666668f + (_e6370 * (0.008333334f + (_e6370 * (0.001388889f + (_e6370 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6365 + 127i)) << bitcast<u32>(23i))))), vec3((0f * (_e6440 / select(1e-12f, _e6230, (_e6230 > 1e-12f))))));
}
let _e6448 = phi_14399_;
if (false || ((_e4600 & 1024u) != 0u)) {
let _e6459 = (_e4211.member - _e4597);
let _e6462 = select(_e4211.member, (_e4597 + (_e6459 * _e4843.member.member)), (_e4843.member.member < 1f));
let _e6468 = select(_e6462, select(_e4211.member, (_e4597 + (_e6459 * _e4843.member.member_1)), (_e4843.member.member_1 < 1f)), (_e4843.member.member_1 > _e4843.member.member));
let _e6470 = (bitcast<i32>(_e177) - 1i);
let _e6472 = select(_e6470, 263211i, (263211i < _e6470));
let _e6478 = global_3.member[bitcast<u32>(select(0i, _e6472, (_e6472 > 0i)))];
let _e6479 = bitcast<f32>(_e6478);
let _e6483 = select(_e6470, 263212i, (263212i < _e6470));
let _e6489 = global_3.member[bitcast<u32>(select(0i, _e6483, (_e6483 > 0i)))];
let _e6490 = bitcast<f32>(_e6489);
let _e6495 = select(_e6470, 263213i, (263213i < _e6470));
let _e6501 = global_3.member[bitcast<u32>(select(0i, _e6495, (_e6495 > 0i)))];
let _e6502 = bitcast<f32>(_e6501);
let _e6506 = select(_e6470, 263214i, (263214i < _e6470));
let _e6512 = global_3.member[bitcast<u32>(select(0i, _e6506, (_e6506 > 0i)))];
let _e6513 = bitcast<f32>(_e6512);
let _e6519 = select(_e6470, 263215i, (263215i < _e6470));
let _e6525 = global_3.member[bitcast<u32>(select(0i, _e6519, (_e6519 > 0i)))];
let _e6526 = bitcast<f32>(_e6525);
let _e6530 = select(_e6470, 263216i, (263216i < _e6470));
let _e6536 = global_3.member[bitcast<u32>(select(0i, _e6530, (_e6530 > 0i)))];
let _e6537 = bitcast<f32>(_e6536);
let _e6542 = select(_e6470, 263217i, (263217i < _e6470));
let _e6548 = global_3.member[bitcast<u32>(select(0i, _e6542, (_e6542 > 0i)))];
let _e6549 = bitcast<f32>(_e6548);
let _e6553 = select(_e6470, 263218i, (263218i < _e6470));
let _e6559 = global_3.member[bitcast<u32>(select(0i, _e6553, (_e6553 > 0i)))];
let _e6560 = bitcast<f32>(_e6559);
let _e6592 = (263219i + ((((((select(0i, 1i, (_e6462 >= _e6479)) + select(0i, 1i, (_e6462 >= _e6490))) + (select(0i, 1i, (_e6462 >= _e6502)) + select(0i, 1i, (_e6462 >= _e6513)))) + ((select(0i, 1i, (_e6462 >= _e6526)) + select(0i, 1i, (_e6462 >= _e6537))) + (select(0i, 1i, (_e6462 >= _e6549)) + select(0i, 1i, (_e6462 >= _e6560))))) * 9i) + (((select(0i, 1i, (_e6468 >= _e6479)) + select(0i, 1i, (_e6468 >= _e6490))) + (select(0i, 1i, (_e6468 >= _e6502)) + select(0i, 1i, (_e6468 >= _e6513)))) + ((select(0i, 1i, (_e6468 >= _e6526)) + select(0i, 1i, (_e6468 >= _e6537))) + (select(0i, 1i, (_e6468 >= _e6549)) + select(0i, 1i, (_e6468 >= _e6560)))))) * 6i));
let _e6594 = select(_e6470, _e6592, (_e6592 < _e6470));
let _e6600 = global_3.member[bitcast<u32>(select(0i, _e6594, (_e6594 > 0i)))];
phi_14797_ = (_e6448.member * select(1f, bitcast<f32>(_e6600), (_e4941 > 0f)));
} else {
phi_14797_ = _e6448.member;
}
let _e6605 = phi_14797_;
if _e1279 {
let _e6610 = global_1.member.member_8.member.member;
let _e6618 = global_1.member.member_8.member_1.member;
let _e6626 = global_1.member.member_8.member_2.member;
let _e6630 = (_e4216 - _e1258);
let _e6631 = -(_e4851);
let _e6634 = (_e4851 - _e6630);
let _e6635 = (_e6630 - _e4851);
let _e6637 = select(_e6635, _e6634, (_e6634 > _e6635));
let _e6640 = (select(_e6631, _e4851, (_e4851 > _e6631)) / select(1e-30f, _e6637, (_e6637 > 1e-30f)));
let _e6642 = (_e6630 < 0f);
let _e6644 = select(0f, select(2f, _e6640, _e6642), (_e4851 > 0f));
let _e6645 = (_e6630 > 0f);
let _e6648 = select(2f, select(0f, _e6640, (_e4851 < 0f)), _e6645);
let _e6649 = (_e4851 > -1e30f);
let _e6653 = ((_e6644 > -1f) || ((_e6644 == -1f) && _e6649));
let _e6654 = (_e6648 < 2f);
let _e6655 = select(-1f, _e6644, _e6653);
let _e6659 = select(2f, _e6648, _e6654);
let _e6663 = select(-1e30f, _e4851, _e6649);
let _e6664 = (_e6630 > -1e30f);
let _e6665 = select(-1e30f, _e6630, _e6664);
let _e6669 = (_e1222 - _e4221);
let _e6670 = (_e1258 - _e4221);
let _e6671 = -(_e6669);
let _e6674 = (_e6669 - _e6670);
let _e6675 = (_e6670 - _e6669);
let _e6677 = select(_e6675, _e6674, (_e6674 > _e6675));
let _e6680 = (select(_e6671, _e6669, (_e6669 > _e6671)) / select(1e-30f, _e6677, (_e6677 > 1e-30f)));
let _e6682 = (_e6670 < 0f);
let _e6684 = select(0f, select(2f, _e6680, _e6682), (_e6669 > 0f));
let _e6685 = (_e6670 > 0f);
let _e6688 = select(2f, select(0f, _e6680, (_e6669 < 0f)), _e6685);
let _e6689 = (_e6669 > _e6663);
let _e6693 = ((_e6684 > _e6655) || ((_e6684 == _e6655) && _e6689));
let _e6694 = (_e6688 < _e6659);
let _e6695 = select(_e6655, _e6684, _e6693);
let _e6699 = select(_e6659, _e6688, _e6694);
let _e6703 = select(_e6663, _e6669, _e6689);
let _e6704 = (_e6670 > _e6665);
let _e6705 = select(_e6665, _e6670, _e6704);
let _e6709 = (_e4230 - _e1264);
let _e6710 = -(_e4880);
let _e6713 = (_e4880 - _e6709);
let _e6714 = (_e6709 - _e4880);
let _e6716 = select(_e6714, _e6713, (_e6713 > _e6714));
let _e6719 = (select(_e6710, _e4880, (_e4880 > _e6710)) / select(1e-30f, _e6716, (_e6716 > 1e-30f)));
let _e6721 = (_e6709 < 0f);
let _e6723 = select(0f, select(2f, _e6719, _e6721), (_e4880 > 0f));
let _e6724 = (_e6709 > 0f);
let _e6727 = select(2f, select(0f, _e6719, (_e4880 < 0f)), _e6724);
let _e6728 = (_e4880 > _e6703);
let _e6732 = ((_e6723 > _e6695) || ((_e6723 == _e6695) && _e6728));
let _e6733 = (_e6727 < _e6699);
let _e6734 = select(_e6695, _e6723, _e6732);
let _e6738 = select(_e6699, _e6727, _e6733);
let _e6742 = select(_e6703, _e4880, _e6728);
let _e6743 = (_e6709 > _e6705);
let _e6744 = select(_e6705, _e6709, _e6743);
let _e6748 = (_e1237 - _e4235);
let _e6749 = (_e1264 - _e4235);
let _e6750 = -(_e6748);
let _e6753 = (_e6748 - _e6749);
let _e6754 = (_e6749 - _e6748);
let _e6756 = select(_e6754, _e6753, (_e6753 > _e6754));
let _e6759 = (select(_e6750, _e6748, (_e6748 > _e6750)) / select(1e-30f, _e6756, (_e6756 > 1e-30f)));
let _e6761 = (_e6749 < 0f);
let _e6763 = select(0f, select(2f, _e6759, _e6761), (_e6748 > 0f));
let _e6764 = (_e6749 > 0f);
let _e6767 = select(2f, select(0f, _e6759, (_e6748 < 0f)), _e6764);
let _e6768 = (_e6748 > _e6742);
let _e6772 = ((_e6763 > _e6734) || ((_e6763 == _e6734) && _e6768));
let _e6773 = (_e6767 < _e6738);
let _e6774 = select(_e6734, _e6763, _e6772);
let _e6778 = select(_e6738, _e6767, _e6773);
let _e6782 = select(_e6742, _e6748, _e6768);
let _e6783 = (_e6749 > _e6744);
let _e6784 = select(_e6744, _e6749, _e6783);
let _e6788 = (_e4244 - _e1270);
let _e6789 = -(_e4909);
let _e6792 = (_e4909 - _e6788);
let _e6793 = (_e6788 - _e4909);
let _e6795 = select(_e6793, _e6792, (_e6792 > _e6793));
let _e6798 = (select(_e6789, _e4909, (_e4909 > _e6789)) / select(1e-30f, _e6795, (_e6795 > 1e-30f)));
let _e6800 = (_e6788 < 0f);
let _e6802 = select(0f, select(2f, _e6798, _e6800), (_e4909 > 0f));
let _e6803 = (_e6788 > 0f);
let _e6806 = select(2f, select(0f, _e6798, (_e4909 < 0f)), _e6803);
let _e6807 = (_e4909 > _e6782);
let _e6811 = ((_e6802 > _e6774) || ((_e6802 == _e6774) && _e6807));
let _e6812 = (_e6806 < _e6778);
let _e6813 = select(_e6774, _e6802, _e6811);
let _e6817 = select(_e6778, _e6806, _e6812);
let _e6821 = select(_e6782, _e4909, _e6807);
let _e6822 = (_e6788 > _e6784);
let _e6823 = select(_e6784, _e6788, _e6822);
let _e6827 = (_e1252 - _e4249);
let _e6828 = (_e1270 - _e4249);
let _e6829 = -(_e6827);
let _e6832 = (_e6827 - _e6828);
let _e6833 = (_e6828 - _e6827);
let _e6835 = select(_e6833, _e6832, (_e6832 > _e6833));
let _e6838 = (select(_e6829, _e6827, (_e6827 > _e6829)) / select(1e-30f, _e6835, (_e6835 > 1e-30f)));
let _e6840 = (_e6828 < 0f);
let _e6842 = select(0f, select(2f, _e6838, _e6840), (_e6827 > 0f));
let _e6843 = (_e6828 > 0f);
let _e6846 = select(2f, select(0f, _e6838, (_e6827 < 0f)), _e6843);
let _e6847 = (_e6827 > _e6821);
let _e6851 = ((_e6842 > _e6813) || ((_e6842 == _e6813) && _e6847));
let _e6852 = (_e6846 < _e6817);
let _e6853 = select(_e6813, _e6842, _e6851);
let _e6854 = select(select(select(select(select(select(0f, _e6610.member, _e6653), _e6610.member, _e6693), _e6618.member, _e6732), _e6618.member, _e6772), _e6626.member, _e6811), _e6626.member, _e6851);
let _e6855 = select(select(select(select(select(select(0f, _e6610.member_1, _e6653), _e6610.member_1, _e6693), _e6618.member_1, _e6732), _e6618.member_1, _e6772), _e6626.member_1, _e6811), _e6626.member_1, _e6851);
let _e6856 = select(select(select(select(select(select(1f, _e6610.member_2, _e6653), _e6610.member_2, _e6693), _e6618.member_2, _e6732), _e6618.member_2, _e6772), _e6626.member_2, _e6811), _e6626.member_2, _e6851);
let _e6858 = select(_e6817, _e6846, _e6852);
let _e6859 = select(select(select(select(select(select(0f, _e6610.member, _e6654), _e6610.member, _e6694), _e6618.member, _e6733), _e6618.member, _e6773), _e6626.member, _e6812), _e6626.member, _e6852);
let _e6860 = select(select(select(select(select(select(0f, _e6610.member_1, _e6654), _e6610.member_1, _e6694), _e6618.member_1, _e6733), _e6618.member_1, _e6773), _e6626.member_1, _e6812), _e6626.member_1, _e6852);
let _e6861 = select(select(select(select(select(select(1f, _e6610.member_2, _e6654), _e6610.member_2, _e6694), _e6618.member_2, _e6733), _e6618.member_2, _e6773), _e6626.member_2, _e6812), _e6626.member_2, _e6852);
let _e6863 = select(_e6821, _e6827, _e6847);
let _e6864 = (_e6828 > _e6823);
let _e6865 = select(_e6823, _e6828, _e6864);
let _e6866 = select(select(select(select(select(select(0f, _e6610.member, _e6649), _e6610.member, _e6689), _e6618.member, _e6728), _e6618.member, _e6768), _e6626.member, _e6807), _e6626.member, _e6847);
let _e6867 = select(select(select(select(select(select(0f, _e6610.member_1, _e6649), _e6610.member_1, _e6689), _e6618.member_1, _e6728), _e6618.member_1, _e6768), _e6626.member_1, _e6807), _e6626.member_1, _e6847);
let _e6868 = select(select(select(select(select(select(1f, _e6610.member_2, _e6649), _e6610.member_2, _e6689), _e6618.member_2, _e6728), _e6618.member_2, _e6768), _e6626.member_2, _e6807), _e6626.member_2, _e6847);
if _e4602 {
phi_16122_ = type_37(_e6853, vec3<f32>(_e6854, _e6855, _e6856), _e6858, vec3<f32>(_e6859, _e6860, _e6861), _e6863, _e6865, vec3<f32>(_e6866, _e6867, _e6868));
} else {
let _e6875 = (((_e6610.member * _e6610.member) + (_e6610.member_1 * _e6610.member_1)) + (_e6610.member_2 * _e6610.member_2));
let _e6878 = sqrt(select(0f, _e6875, (_e6875 > 0f)));
let _e6882 = global_1.member.member_16.member_1;
let _e6883 = (_e6882 != 0u);
let _e6887 = global_1.member.member_16.member;
let _e6907 = select(-1e6f, (((((_e6887.member.member * _e1179) + (_e6887.member.member_1 * _e1192)) + (_e6887.member.member_2 * _e1157)) + _e6887.member_1) * _e6878), _e6883);
let _e6908 = select(-1e6f, (((((_e6887.member.member * _e1202) + (_e6887.member.member_1 * _e1207)) + (_e6887.member.member_2 * _e1196)) + _e6887.member_1) * _e6878), _e6883);
let _e6913 = global_1.member.member_16.member.member;
let _e6917 = -(_e6907);
let _e6920 = (_e6907 - _e6908);
let _e6921 = (_e6908 - _e6907);
let _e6923 = select(_e6921, _e6920, (_e6920 > _e6921));
let _e6926 = (select(_e6917, _e6907, (_e6907 > _e6917)) / select(1e-30f, _e6923, (_e6923 > 1e-30f)));
let _e6930 = select(0f, select(2f, _e6926, (_e6908 < 0f)), (_e6907 > 0f));
let _e6934 = select(2f, select(0f, _e6926, (_e6907 < 0f)), (_e6908 > 0f));
let _e6935 = (_e6907 > _e6863);
let _e6939 = ((_e6930 > _e6853) || ((_e6930 == _e6853) && _e6935));
let _e6940 = (_e6934 < _e6858);
let _e6941 = select(_e6853, _e6930, _e6939);
let _e6945 = select(_e6858, _e6934, _e6940);
let _e6949 = select(_e6863, _e6907, _e6935);
let _e6951 = select(_e6865, _e6908, (_e6908 > _e6865));
let _e6958 = global_1.member.member_17.member_1;
let _e6959 = (_e6958 != 0u);
let _e6963 = global_1.member.member_17.member;
let _e6983 = select(-1e6f, (((((_e6963.member.member * _e1179) + (_e6963.member.member_1 * _e1192)) + (_e6963.member.member_2 * _e1157)) + _e6963.member_1) * _e6878), _e6959);
let _e6984 = select(-1e6f, (((((_e6963.member.member * _e1202) + (_e6963.member.member_1 * _e1207)) + (_e6963.member.member_2 * _e1196)) + _e6963.member_1) * _e6878), _e6959);
let _e6989 = global_1.member.member_17.member.member;
let _e6993 = -(_e6983);
let _e6996 = (_e6983 - _e6984);
let _e6997 = (_e6984 - _e6983);
let _e6999 = select(_e6997, _e6996, (_e6996 > _e6997));
let _e7002 = (select(_e6993, _e6983, (_e6983 > _e6993)) / select(1e-30f, _e6999, (_e6999 > 1e-30f)));
let _e7006 = select(0f, select(2f, _e7002, (_e6984 < 0f)), (_e6983 > 0f));
let _e7010 = select(2f, select(0f, _e7002, (_e6983 < 0f)), (_e6984 > 0f));
let _e7011 = (_e6983 > _e6949);
let _e7015 = ((_e7006 > _e6941) || ((_e7006 == _e6941) && _e7011));
let _e7016 = (_e7010 < _e6945);
let _e7017 = select(_e6941, _e7006, _e7015);
let _e7021 = select(_e6945, _e7010, _e7016);
let _e7025 = select(_e6949, _e6983, _e7011);
let _e7027 = select(_e6951, _e6984, (_e6984 > _e6951));
let _e7034 = global_1.member.member_18.member_1;
let _e7035 = (_e7034 != 0u);
let _e7039 = global_1.member.member_18.member;
let _e7059 = select(-1e6f, (((((_e7039.member.member * _e1179) + (_e7039.member.member_1 * _e1192)) + (_e7039.member.member_2 * _e1157)) + _e7039.member_1) * _e6878), _e7035);
let _e7060 = select(-1e6f, (((((_e7039.member.member * _e1202) + (_e7039.member.member_1 * _e1207)) + (_e7039.member.member_2 * _e1196)) + _e7039.member_1) * _e6878), _e7035);
let _e7065 = global_1.member.member_18.member.member;
let _e7069 = -(_e7059);
let _e7072 = (_e7059 - _e7060);
let _e7073 = (_e7060 - _e7059);
let _e7075 = select(_e7073, _e7072, (_e7072 > _e7073));
let _e7078 = (select(_e7069, _e7059, (_e7059 > _e7069)) / select(1e-30f, _e7075, (_e7075 > 1e-30f)));
let _e7082 = select(0f, select(2f, _e7078, (_e7060 < 0f)), (_e7059 > 0f));
let _e7086 = select(2f, select(0f, _e7078, (_e7059 < 0f)), (_e7060 > 0f));
let _e7087 = (_e7059 > _e7025);
let _e7091 = ((_e7082 > _e7017) || ((_e7082 == _e7017) && _e7087));
let _e7092 = (_e7086 < _e7021);
let _e7093 = select(_e7017, _e7082, _e7091);
let _e7097 = select(_e7021, _e7086, _e7092);
let _e7101 = select(_e7025, _e7059, _e7087);
let _e7103 = select(_e7027, _e7060, (_e7060 > _e7027));
let _e7110 = global_1.member.member_19.member_1;
let _e7111 = (_e7110 != 0u);
let _e7115 = global_1.member.member_19.member;
let _e7135 = select(-1e6f, (((((_e7115.member.member * _e1179) + (_e7115.member.member_1 * _e1192)) + (_e7115.member.member_2 * _e1157)) + _e7115.member_1) * _e6878), _e7111);
let _e7136 = select(-1e6f, (((((_e7115.member.member * _e1202) + (_e7115.member.member_1 * _e1207)) + (_e7115.member.member_2 * _e1196)) + _e7115.member_1) * _e6878), _e7111);
let _e7141 = global_1.member.member_19.member.member;
let _e7145 = -(_e7135);
let _e7148 = (_e7135 - _e7136);
let _e7149 = (_e7136 - _e7135);
let _e7151 = select(_e7149, _e7148, (_e7148 > _e7149));
let _e7154 = (select(_e7145, _e7135, (_e7135 > _e7145)) / select(1e-30f, _e7151, (_e7151 > 1e-30f)));
let _e7158 = select(0f, select(2f, _e7154, (_e7136 < 0f)), (_e7135 > 0f));
let _e7162 = select(2f, select(0f, _e7154, (_e7135 < 0f)), (_e7136 > 0f));
let _e7163 = (_e7135 > _e7101);
let _e7167 = ((_e7158 > _e7093) || ((_e7158 == _e7093) && _e7163));
let _e7168 = (_e7162 < _e7097);
phi_16122_ = type_37(select(_e7093, _e7158, _e7167), vec3<f32>(select(select(select(select(_e6854, _e6913.member, _e6939), _e6989.member, _e7015), _e7065.member, _e7091), _e7141.member, _e7167), select(select(select(select(_e6855, _e6913.member_1, _e6939), _e6989.member_1, _e7015), _e7065.member_1, _e7091), _e7141.member_1, _e7167), select(select(select(select(_e6856, _e6913.member_2, _e6939), _e6989.member_2, _e7015), _e7065.member_2, _e7091), _e7141.member_2, _e7167)), select(_e7097, _e7162, _e7168), vec3<f32>(select(select(select(select(_e6859, _e6913.member, _e6940), _e6989.member, _e7016), _e7065.member, _e7092), _e7141.member, _e7168), select(select(select(select(_e6860, _e6913.member_1, _e6940), _e6989.member_1, _e7016), _e7065.member_1, _e7092), _e7141.member_1, _e7168), select(select(select(select(_e6861, _e6913.member_2, _e6940), _e6989.member_2, _e7016), _e7065.member_2, _e7092), _e7141.member_2, _e7168)), select(_e7101, _e7135, _e7163), select(_e7103, _e7136, (_e7136 > _e7103)), vec3<f32>(select(select(select(select(_e6866, _e6913.member, _e6935), _e6989.member, _e7011), _e7065.member, _e7087), _e7141.member, _e7163), select(select(select(select(_e6867, _e6913.member_1, _e6935), _e6989.member_1, _e7011), _e7065.member_1, _e7087), _e7141.member_1, _e7163), select(select(select(select(_e6868, _e6913.member_2, _e6935), _e6989.member_2, _e7011), _e7065.member_2, _e7087), _e7141.member_2, _e7163)));
}
let _e7188 = phi_16122_;
let _e7190 = (_e7188.member_4 < 0f);
let _e7192 = (_e7188.member_5 < 0f);
let _e7193 = (_e7190 != _e7192);
if _e7190 {
phi_16135_ = _e7188.member_3;
phi_16136_ = _e7188.member_2;
} else {
phi_16135_ = _e7188.member_1;
phi_16136_ = _e7188.member;
}
let _e7199 = phi_16135_;
let _e7201 = phi_16136_;
let _e7210 = (((_e6610.member * _e6610.member) + (_e6610.member_1 * _e6610.member_1)) + (_e6610.member_2 * _e6610.member_2));
let _e7213 = sqrt(select(0f, _e7210, (_e7210 > 0f)));
let _e7214 = ((1.5f * _e1177) * _e7213);
let _e7219 = select(0f, _e7201, _e7193);
let _e7223 = (_e1179 + (_e4942 * _e7219));
let _e7224 = (_e1192 + (_e4943 * _e7219));
let _e7225 = (_e1157 + (_e4944 * _e7219));
let _e7231 = ((((_e1211.member.member * _e7223) + (_e1211.member.member_1 * _e7224)) + (_e1211.member.member_2 * _e7225)) + _e1211.member_1);
let _e7237 = ((((_e1226.member.member * _e7223) + (_e1226.member.member_1 * _e7224)) + (_e1226.member.member_2 * _e7225)) + _e1226.member_1);
let _e7243 = ((((_e1241.member.member * _e7223) + (_e1241.member.member_1 * _e7224)) + (_e1241.member.member_2 * _e7225)) + _e1241.member_1);
let _e7245 = select(_e4216, _e7231, (_e7231 > _e4216));
let _e7247 = select(_e4221, _e7245, (_e7245 < _e4221));
let _e7249 = select(_e4230, _e7237, (_e7237 > _e4230));
let _e7251 = select(_e4235, _e7249, (_e7249 < _e4235));
let _e7253 = select(_e4244, _e7243, (_e7243 > _e4244));
let _e7255 = select(_e4249, _e7253, (_e7253 < _e4249));
if _e4259 {
phi_16366_ = vec3<f32>(_e7247, _e7251, _e7255);
} else {
let _e7257 = (_e7247 + 0.5f);
let _e7258 = (_e4337 - 1f);
let _e7260 = select(0f, _e7257, (_e7257 > 0f));
let _e7262 = select(_e7258, _e7260, (_e7260 < _e7258));
let _e7269 = select(0i, select(select(i32(_e7262), i32(-2147483648), (_e7262 < -2147483600f)), 2147483647i, (_e7262 > 2147483500f)), (_e7262 == _e7262));
let _e7275 = (_e7251 + 0.5f);
let _e7276 = (_e4358 - 1f);
let _e7278 = select(0f, _e7275, (_e7275 > 0f));
let _e7280 = select(_e7276, _e7278, (_e7278 < _e7276));
let _e7287 = select(0i, select(select(i32(_e7280), i32(-2147483648), (_e7280 < -2147483600f)), 2147483647i, (_e7280 > 2147483500f)), (_e7280 == _e7280));
let _e7293 = (_e7255 + 0.5f);
let _e7294 = (_e4379 - 1f);
let _e7296 = select(0f, _e7293, (_e7293 > 0f));
let _e7298 = select(_e7294, _e7296, (_e7296 < _e7294));
let _e7305 = select(0i, select(select(i32(_e7298), i32(-2147483648), (_e7298 < -2147483600f)), 2147483647i, (_e7298 > 2147483500f)), (_e7298 == _e7298));
phi_16366_ = vec3<f32>(f32((_e7269 - select(0i, 1i, (_e7262 < f32(_e7269))))), f32((_e7287 - select(0i, 1i, (_e7280 < f32(_e7287))))), f32((_e7305 - select(0i, 1i, (_e7298 < f32(_e7305))))));
}
let _e7313 = phi_16366_;
let _e7316 = select(-1f, _e7313.x, (_e7313.x > -1f));
let _e7318 = select(_e4337, _e7316, (_e7316 < _e4337));
let _e7325 = select(0i, select(select(i32(_e7318), i32(-2147483648), (_e7318 < -2147483600f)), 2147483647i, (_e7318 > 2147483500f)), (_e7318 == _e7318));
let _e7329 = (_e7325 - select(0i, 1i, (_e7318 < f32(_e7325))));
let _e7332 = select(-1f, _e7313.y, (_e7313.y > -1f));
let _e7334 = select(_e4358, _e7332, (_e7332 < _e4358));
let _e7341 = select(0i, select(select(i32(_e7334), i32(-2147483648), (_e7334 < -2147483600f)), 2147483647i, (_e7334 > 2147483500f)), (_e7334 == _e7334));
let _e7345 = (_e7341 - select(0i, 1i, (_e7334 < f32(_e7341))));
let _e7348 = select(-1f, _e7313.z, (_e7313.z > -1f));
let _e7350 = select(_e4379, _e7348, (_e7348 < _e4379));
let _e7357 = select(0i, select(select(i32(_e7350), i32(-2147483648), (_e7350 < -2147483600f)), 2147483647i, (_e7350 > 2147483500f)), (_e7350 == _e7350));
let _e7361 = (_e7357 - select(0i, 1i, (_e7350 < f32(_e7357))));
let _e7364 = (_e7345 + 1i);
let _e7369 = (_e7361 + 1i);
let _e7372 = (_e7329 - 1i);
let _e7377 = (_e7329 + 1i);
let _e7380 = (_e7329 + 2i);
let _e7383 = (select(0i, _e7345, (_e7345 > 0i)) * _e4398);
let _e7384 = (select(_e4410, _e7364, (_e7364 < _e4410)) * _e4398);
let _e7385 = (select(0i, _e7361, (_e7361 > 0i)) * _e4402);
let _e7386 = (select(_e4423, _e7369, (_e7369 < _e4423)) * _e4402);
local_2 = type_30(array<i32, 4>(select(0i, _e7372, (_e7372 > 0i)), select(0i, _e7329, (_e7329 > 0i)), select(_e4436, _e7377, (_e7377 < _e4436)), select(_e4436, _e7380, (_e7380 < _e4436))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_3 = (_e7313 - vec3<f32>(f32(_e7329), f32(_e7345), f32(_e7361)));
let _e7395 = (_e7385 + _e7383);
let _e7398 = local_2.member[1u];
let _e7399 = (_e7395 + _e7398);
let _e7401 = select(_e4466, _e7399, (_e7399 < _e4466));
let _e7406 = global_2.member[bitcast<u32>(select(0i, _e7401, (_e7401 > 0i)))];
let _e7407 = bitcast<f32>(_e7406);
let _e7410 = local_2.member[2u];
let _e7411 = (_e7395 + _e7410);
let _e7413 = select(_e4466, _e7411, (_e7411 < _e4466));
let _e7418 = global_2.member[bitcast<u32>(select(0i, _e7413, (_e7413 > 0i)))];
let _e7420 = local_3[0u];
let _e7423 = (_e7407 + ((bitcast<f32>(_e7418) - _e7407) * _e7420));
let _e7424 = (_e7385 + _e7384);
let _e7425 = local_2.member[1u];
let _e7426 = (_e7424 + _e7425);
let _e7428 = select(_e4466, _e7426, (_e7426 < _e4466));
let _e7433 = global_2.member[bitcast<u32>(select(0i, _e7428, (_e7428 > 0i)))];
let _e7434 = bitcast<f32>(_e7433);
let _e7435 = local_2.member[2u];
let _e7436 = (_e7424 + _e7435);
let _e7438 = select(_e4466, _e7436, (_e7436 < _e4466));
let _e7443 = global_2.member[bitcast<u32>(select(0i, _e7438, (_e7438 > 0i)))];
let _e7445 = local_3[0u];
let _e7450 = local_3[1u];
let _e7453 = (_e7423 + (((_e7434 + ((bitcast<f32>(_e7443) - _e7434) * _e7445)) - _e7423) * _e7450));
let _e7454 = (_e7386 + _e7383);
let _e7455 = local_2.member[1u];
let _e7456 = (_e7454 + _e7455);
let _e7458 = select(_e4466, _e7456, (_e7456 < _e4466));
let _e7463 = global_2.member[bitcast<u32>(select(0i, _e7458, (_e7458 > 0i)))];
let _e7464 = bitcast<f32>(_e7463);
let _e7465 = local_2.member[2u];
let _e7466 = (_e7454 + _e7465);
let _e7468 = select(_e4466, _e7466, (_e7466 < _e4466));
let _e7473 = global_2.member[bitcast<u32>(select(0i, _e7468, (_e7468 > 0i)))];
let _e7475 = local_3[0u];
let _e7478 = (_e7464 + ((bitcast<f32>(_e7473) - _e7464) * _e7475));
let _e7479 = (_e7386 + _e7384);
let _e7480 = local_2.member[1u];
let _e7481 = (_e7479 + _e7480);
let _e7483 = select(_e4466, _e7481, (_e7481 < _e4466));
let _e7488 = global_2.member[bitcast<u32>(select(0i, _e7483, (_e7483 > 0i)))];
let _e7489 = bitcast<f32>(_e7488);
let _e7490 = local_2.member[2u];
let _e7491 = (_e7479 + _e7490);
let _e7493 = select(_e4466, _e7491, (_e7491 < _e4466));
let _e7498 = global_2.member[bitcast<u32>(select(0i, _e7493, (_e7493 > 0i)))];
let _e7500 = local_3[0u];
let _e7504 = local_3[1u];
let _e7509 = local_3[2u];
let _e7514 = (((_e7453 + (((_e7478 + (((_e7489 + ((bitcast<f32>(_e7498) - _e7489) * _e7500)) - _e7478) * _e7504)) - _e7453) * _e7509)) - _e4583) * _e4587);
let _e7516 = select(_e4590, _e7514, (_e7514 > _e4590));
local = select(1e9f, _e7516, (_e7516 < 1e9f));
let _e7519 = local;
local_1 = _e7519;
let _e7520 = local_1;
let _e7522 = (bitcast<i32>(_e177) - 1i);
let _e7524 = select(_e7522, 263197i, (263197i < _e7522));
let _e7529 = global_3.member[bitcast<u32>(select(0i, _e7524, (_e7524 > 0i)))];
let _e7532 = select(_e7522, 263198i, (263198i < _e7522));
let _e7537 = global_3.member[bitcast<u32>(select(0i, _e7532, (_e7532 > 0i)))];
let _e7540 = select(_e7522, 263199i, (263199i < _e7522));
let _e7545 = global_3.member[bitcast<u32>(select(0i, _e7540, (_e7540 > 0i)))];
let _e7546 = bitcast<f32>(_e7545);
let _e7548 = ((_e7520 - bitcast<f32>(_e7529)) * bitcast<f32>(_e7537));
let _e7550 = select(0f, _e7548, (_e7548 > 0f));
let _e7553 = local_1;
let _e7555 = select(_e7522, 263200i, (263200i < _e7522));
let _e7560 = global_3.member[bitcast<u32>(select(0i, _e7555, (_e7555 > 0i)))];
let _e7563 = select(_e7522, 263201i, (263201i < _e7522));
let _e7568 = global_3.member[bitcast<u32>(select(0i, _e7563, (_e7563 > 0i)))];
let _e7571 = select(_e7522, 263202i, (263202i < _e7522));
let _e7576 = global_3.member[bitcast<u32>(select(0i, _e7571, (_e7571 > 0i)))];
let _e7577 = bitcast<f32>(_e7576);
let _e7579 = ((_e7553 - bitcast<f32>(_e7560)) * bitcast<f32>(_e7568));
let _e7581 = select(0f, _e7579, (_e7579 > 0f));
let _e7585 = local_1;
let _e7587 = select(_e7522, 263203i, (263203i < _e7522));
let _e7592 = global_3.member[bitcast<u32>(select(0i, _e7587, (_e7587 > 0i)))];
let _e7595 = select(_e7522, 263204i, (263204i < _e7522));
let _e7600 = global_3.member[bitcast<u32>(select(0i, _e7595, (_e7595 > 0i)))];
let _e7603 = select(_e7522, 263205i, (263205i < _e7522));
let _e7608 = global_3.member[bitcast<u32>(select(0i, _e7603, (_e7603 > 0i)))];
let _e7609 = bitcast<f32>(_e7608);
let _e7611 = ((_e7585 - bitcast<f32>(_e7592)) * bitcast<f32>(_e7600));
let _e7613 = select(0f, _e7611, (_e7611 > 0f));
let _e7616 = local_1;
let _e7618 = select(_e7522, 263206i, (263206i < _e7522));
let _e7623 = global_3.member[bitcast<u32>(select(0i, _e7618, (_e7618 > 0i)))];
let _e7626 = select(_e7522, 263207i, (263207i < _e7522));
let _e7631 = global_3.member[bitcast<u32>(select(0i, _e7626, (_e7626 > 0i)))];
let _e7634 = select(_e7522, 263208i, (263208i < _e7522));
let _e7639 = global_3.member[bitcast<u32>(select(0i, _e7634, (_e7634 > 0i)))];
let _e7640 = bitcast<f32>(_e7639);
let _e7642 = ((_e7616 - bitcast<f32>(_e7623)) * bitcast<f32>(_e7631));
let _e7644 = select(0f, _e7642, (_e7642 > 0f));
let _e7648 = ((select(_e7546, _e7550, (_e7550 < _e7546)) + select(_e7577, _e7581, (_e7581 < _e7577))) + (select(_e7609, _e7613, (_e7613 < _e7609)) + select(_e7640, _e7644, (_e7644 < _e7640))));
let _e7650 = select(0f, _e7648, (_e7648 > 0f));
let _e7652 = select(1023f, _e7650, (_e7650 < 1023f));
let _e7659 = select(0i, select(select(i32(_e7652), i32(-2147483648), (_e7652 < -2147483600f)), 2147483647i, (_e7652 > 2147483500f)), (_e7652 == _e7652));
let _e7663 = (_e7659 - select(0i, 1i, (_e7652 < f32(_e7659))));
let _e7664 = (262147i + _e7663);
let _e7666 = select(_e7522, _e7664, (_e7664 < _e7522));
let _e7672 = global_3.member[bitcast<u32>(select(0i, _e7666, (_e7666 > 0i)))];
let _e7682 = select(_e7522, 262146i, (262146i < _e7522));
let _e7688 = global_3.member[bitcast<u32>(select(0i, _e7682, (_e7682 > 0i)))];
let _e7692 = select(_e7522, 262144i, (262144i < _e7522));
let _e7698 = global_3.member[bitcast<u32>(select(0i, _e7692, (_e7692 > 0i)))];
let _e7701 = select(_e7522, 262145i, (262145i < _e7522));
let _e7707 = global_3.member[bitcast<u32>(select(0i, _e7701, (_e7701 > 0i)))];
let _e7714 = ((bitcast<f32>(_e7698) + (f32(bitcast<i32>((_e7672 >> bitcast<u32>(12u)))) * bitcast<f32>(_e7707))) + ((f32((bitcast<i32>((_e7672 & 4095u)) - 2048i)) * bitcast<f32>(_e7688)) * (_e7648 - f32(_e7663))));
let _e7718 = select(_e7188.member_6.x, _e7199.x, _e7193);
let _e7721 = select(_e7188.member_6.y, _e7199.y, _e7193);
let _e7724 = select(_e7188.member_6.z, _e7199.z, _e7193);
let _e7725 = select(1f, _e7714, _e7192);
let _e7730 = (((_e7718 * _e7718) + (_e7721 * _e7721)) + (_e7724 * _e7724));
let _e7733 = sqrt(select(0f, _e7730, (_e7730 > 0f)));
let _e7736 = (1f / select(1e-20f, _e7733, (_e7733 > 1e-20f)));
let _e7737 = (_e7718 * _e7736);
let _e7738 = (_e7721 * _e7736);
let _e7739 = (_e7724 * _e7736);
let _e7744 = (((_e245 * _e7737) + (_e256 * _e7738)) + (_e267 * _e7739));
let _e7749 = (((_e245 * _e245) + (_e256 * _e256)) + (_e267 * _e267));
let _e7751 = ((_e7725 * _e7725) - _e7749);
let _e7752 = (_e7744 * _e7744);
let _e7753 = (_e7752 + _e7751);
let _e7756 = sqrt(select(0f, _e7753, (_e7753 > 0f)));
let _e7760 = (_e7753 <= 0f);
let _e7763 = select((select(_e7756, -(_e7756), (_e7744 < 0f)) - _e7744), (-2f * _e7744), _e7760);
let _e7764 = (_e7751 == 0f);
let _e7775 = (_e7760 && (_e7751 != 0f));
let _e7781 = (!(_e7193) && (_e7775 || (_e7752 < ((0.1f * 0.1f) * _e7749))));
let _e7783 = select(1e-12f, _e7749, (_e7749 > 1e-12f));
let _e7787 = (_e7725 / sqrt(select(0f, _e7783, (_e7783 > 0f))));
let _e7799 = ((_e7193 || (bitcast<f32>((bitcast<u32>(_e7188.member_4) & 2147483647u)) < select(1f, _e7214, (_e7214 < 1f)))) && (_e7714 != 1f));
let _e7800 = select(_e245, select(select(select((_e245 + (_e7737 * _e7763)), _e245, _e7764), _e245, _e7775), (_e245 * _e7787), _e7781), _e7799);
let _e7801 = select(_e256, select(select(select((_e256 + (_e7738 * _e7763)), _e256, _e7764), _e256, _e7775), (_e256 * _e7787), _e7781), _e7799);
let _e7802 = select(_e267, select(select(select((_e267 + (_e7739 * _e7763)), _e267, _e7764), _e267, _e7775), (_e267 * _e7787), _e7781), _e7799);
let _e7814 = global_1.member.member_7.member_2;
let _e7817 = (_e7814 / select(1e-6f, _e7802, (_e7802 > 1e-6f)));
let _e7821 = (_e1202 + (_e7800 * _e7817));
let _e7822 = (_e1207 + (_e7801 * _e7817));
let _e7823 = (_e1196 + (_e7802 * _e7817));
let _e7829 = ((((_e1211.member.member * _e7821) + (_e1211.member.member_1 * _e7822)) + (_e1211.member.member_2 * _e7823)) + _e1211.member_1);
let _e7835 = ((((_e1226.member.member * _e7821) + (_e1226.member.member_1 * _e7822)) + (_e1226.member.member_2 * _e7823)) + _e1226.member_1);
let _e7841 = ((((_e1241.member.member * _e7821) + (_e1241.member.member_1 * _e7822)) + (_e1241.member.member_2 * _e7823)) + _e1241.member_1);
let _e7842 = (_e4216 - _e7829);
let _e7843 = -(_e6630);
let _e7846 = (_e6630 - _e7842);
let _e7847 = (_e7842 - _e6630);
let _e7849 = select(_e7847, _e7846, (_e7846 > _e7847));
let _e7852 = (select(_e7843, _e6630, (_e6630 > _e7843)) / select(1e-30f, _e7849, (_e7849 > 1e-30f)));
let _e7855 = select(0f, select(2f, _e7852, (_e7842 < 0f)), _e6645);
let _e7858 = select(2f, select(0f, _e7852, _e6642), (_e7842 > 0f));
let _e7862 = ((_e7855 > -1f) || ((_e7855 == -1f) && _e6664));
let _e7863 = (_e7858 < 2f);
let _e7864 = select(-1f, _e7855, _e7862);
let _e7868 = select(2f, _e7858, _e7863);
let _e7873 = select(-1e30f, _e7842, (_e7842 > -1e30f));
let _e7877 = (_e7829 - _e4221);
let _e7878 = -(_e6670);
let _e7881 = (_e6670 - _e7877);
let _e7882 = (_e7877 - _e6670);
let _e7884 = select(_e7882, _e7881, (_e7881 > _e7882));
let _e7887 = (select(_e7878, _e6670, (_e6670 > _e7878)) / select(1e-30f, _e7884, (_e7884 > 1e-30f)));
let _e7890 = select(0f, select(2f, _e7887, (_e7877 < 0f)), _e6685);
let _e7893 = select(2f, select(0f, _e7887, _e6682), (_e7877 > 0f));
let _e7897 = ((_e7890 > _e7864) || ((_e7890 == _e7864) && _e6704));
let _e7898 = (_e7893 < _e7868);
let _e7899 = select(_e7864, _e7890, _e7897);
let _e7903 = select(_e7868, _e7893, _e7898);
let _e7908 = select(_e7873, _e7877, (_e7877 > _e7873));
let _e7912 = (_e4230 - _e7835);
let _e7913 = -(_e6709);
let _e7916 = (_e6709 - _e7912);
let _e7917 = (_e7912 - _e6709);
let _e7919 = select(_e7917, _e7916, (_e7916 > _e7917));
let _e7922 = (select(_e7913, _e6709, (_e6709 > _e7913)) / select(1e-30f, _e7919, (_e7919 > 1e-30f)));
let _e7925 = select(0f, select(2f, _e7922, (_e7912 < 0f)), _e6724);
let _e7928 = select(2f, select(0f, _e7922, _e6721), (_e7912 > 0f));
let _e7932 = ((_e7925 > _e7899) || ((_e7925 == _e7899) && _e6743));
let _e7933 = (_e7928 < _e7903);
let _e7934 = select(_e7899, _e7925, _e7932);
let _e7938 = select(_e7903, _e7928, _e7933);
let _e7943 = select(_e7908, _e7912, (_e7912 > _e7908));
let _e7947 = (_e7835 - _e4235);
let _e7948 = -(_e6749);
let _e7951 = (_e6749 - _e7947);
let _e7952 = (_e7947 - _e6749);
let _e7954 = select(_e7952, _e7951, (_e7951 > _e7952));
let _e7957 = (select(_e7948, _e6749, (_e6749 > _e7948)) / select(1e-30f, _e7954, (_e7954 > 1e-30f)));
let _e7960 = select(0f, select(2f, _e7957, (_e7947 < 0f)), _e6764);
let _e7963 = select(2f, select(0f, _e7957, _e6761), (_e7947 > 0f));
let _e7967 = ((_e7960 > _e7934) || ((_e7960 == _e7934) && _e6783));
let _e7968 = (_e7963 < _e7938);
let _e7969 = select(_e7934, _e7960, _e7967);
let _e7973 = select(_e7938, _e7963, _e7968);
let _e7978 = select(_e7943, _e7947, (_e7947 > _e7943));
let _e7982 = (_e4244 - _e7841);
let _e7983 = -(_e6788);
let _e7986 = (_e6788 - _e7982);
let _e7987 = (_e7982 - _e6788);
let _e7989 = select(_e7987, _e7986, (_e7986 > _e7987));
let _e7992 = (select(_e7983, _e6788, (_e6788 > _e7983)) / select(1e-30f, _e7989, (_e7989 > 1e-30f)));
let _e7995 = select(0f, select(2f, _e7992, (_e7982 < 0f)), _e6803);
let _e7998 = select(2f, select(0f, _e7992, _e6800), (_e7982 > 0f));
let _e8002 = ((_e7995 > _e7969) || ((_e7995 == _e7969) && _e6822));
let _e8003 = (_e7998 < _e7973);
let _e8004 = select(_e7969, _e7995, _e8002);
let _e8008 = select(_e7973, _e7998, _e8003);
let _e8013 = select(_e7978, _e7982, (_e7982 > _e7978));
let _e8017 = (_e7841 - _e4249);
let _e8018 = -(_e6828);
let _e8021 = (_e6828 - _e8017);
let _e8022 = (_e8017 - _e6828);
let _e8024 = select(_e8022, _e8021, (_e8021 > _e8022));
let _e8027 = (select(_e8018, _e6828, (_e6828 > _e8018)) / select(1e-30f, _e8024, (_e8024 > 1e-30f)));
let _e8030 = select(0f, select(2f, _e8027, (_e8017 < 0f)), _e6843);
let _e8033 = select(2f, select(0f, _e8027, _e6840), (_e8017 > 0f));
let _e8037 = ((_e8030 > _e8004) || ((_e8030 == _e8004) && _e6864));
let _e8038 = (_e8033 < _e8008);
let _e8039 = select(_e8004, _e8030, _e8037);
let _e8040 = select(select(select(select(select(select(0f, _e6610.member, _e7862), _e6610.member, _e7897), _e6618.member, _e7932), _e6618.member, _e7967), _e6626.member, _e8002), _e6626.member, _e8037);
let _e8041 = select(select(select(select(select(select(0f, _e6610.member_1, _e7862), _e6610.member_1, _e7897), _e6618.member_1, _e7932), _e6618.member_1, _e7967), _e6626.member_1, _e8002), _e6626.member_1, _e8037);
let _e8042 = select(select(select(select(select(select(1f, _e6610.member_2, _e7862), _e6610.member_2, _e7897), _e6618.member_2, _e7932), _e6618.member_2, _e7967), _e6626.member_2, _e8002), _e6626.member_2, _e8037);
let _e8044 = select(_e8008, _e8033, _e8038);
let _e8045 = select(select(select(select(select(select(0f, _e6610.member, _e7863), _e6610.member, _e7898), _e6618.member, _e7933), _e6618.member, _e7968), _e6626.member, _e8003), _e6626.member, _e8038);
let _e8046 = select(select(select(select(select(select(0f, _e6610.member_1, _e7863), _e6610.member_1, _e7898), _e6618.member_1, _e7933), _e6618.member_1, _e7968), _e6626.member_1, _e8003), _e6626.member_1, _e8038);
let _e8047 = select(select(select(select(select(select(1f, _e6610.member_2, _e7863), _e6610.member_2, _e7898), _e6618.member_2, _e7933), _e6618.member_2, _e7968), _e6626.member_2, _e8003), _e6626.member_2, _e8038);
let _e8050 = select(_e8013, _e8017, (_e8017 > _e8013));
let _e8051 = select(select(select(select(select(select(0f, _e6610.member, _e6664), _e6610.member, _e6704), _e6618.member, _e6743), _e6618.member, _e6783), _e6626.member, _e6822), _e6626.member, _e6864);
let _e8052 = select(select(select(select(select(select(0f, _e6610.member_1, _e6664), _e6610.member_1, _e6704), _e6618.member_1, _e6743), _e6618.member_1, _e6783), _e6626.member_1, _e6822), _e6626.member_1, _e6864);
let _e8053 = select(select(select(select(select(select(1f, _e6610.member_2, _e6664), _e6610.member_2, _e6704), _e6618.member_2, _e6743), _e6618.member_2, _e6783), _e6626.member_2, _e6822), _e6626.member_2, _e6864);
if _e4602 {
phi_18861_ = type_37(_e8039, vec3<f32>(_e8040, _e8041, _e8042), _e8044, vec3<f32>(_e8045, _e8046, _e8047), _e6865, _e8050, vec3<f32>(_e8051, _e8052, _e8053));
} else {
let _e8059 = global_1.member.member_16.member_1;
let _e8060 = (_e8059 != 0u);
let _e8064 = global_1.member.member_16.member;
let _e8084 = select(-1e6f, (((((_e8064.member.member * _e1202) + (_e8064.member.member_1 * _e1207)) + (_e8064.member.member_2 * _e1196)) + _e8064.member_1) * _e7213), _e8060);
let _e8085 = select(-1e6f, (((((_e8064.member.member * _e7821) + (_e8064.member.member_1 * _e7822)) + (_e8064.member.member_2 * _e7823)) + _e8064.member_1) * _e7213), _e8060);
let _e8090 = global_1.member.member_16.member.member;
let _e8094 = -(_e8084);
let _e8097 = (_e8084 - _e8085);
let _e8098 = (_e8085 - _e8084);
let _e8100 = select(_e8098, _e8097, (_e8097 > _e8098));
let _e8103 = (select(_e8094, _e8084, (_e8084 > _e8094)) / select(1e-30f, _e8100, (_e8100 > 1e-30f)));
let _e8107 = select(0f, select(2f, _e8103, (_e8085 < 0f)), (_e8084 > 0f));
let _e8111 = select(2f, select(0f, _e8103, (_e8084 < 0f)), (_e8085 > 0f));
let _e8112 = (_e8084 > _e6865);
let _e8116 = ((_e8107 > _e8039) || ((_e8107 == _e8039) && _e8112));
let _e8117 = (_e8111 < _e8044);
let _e8118 = select(_e8039, _e8107, _e8116);
let _e8122 = select(_e8044, _e8111, _e8117);
let _e8126 = select(_e6865, _e8084, _e8112);
let _e8128 = select(_e8050, _e8085, (_e8085 > _e8050));
let _e8135 = global_1.member.member_17.member_1;
let _e8136 = (_e8135 != 0u);
let _e8140 = global_1.member.member_17.member;
let _e8160 = select(-1e6f, (((((_e8140.member.member * _e1202) + (_e8140.member.member_1 * _e1207)) + (_e8140.member.member_2 * _e1196)) + _e8140.member_1) * _e7213), _e8136);
let _e8161 = select(-1e6f, (((((_e8140.member.member * _e7821) + (_e8140.member.member_1 * _e7822)) + (_e8140.member.member_2 * _e7823)) + _e8140.member_1) * _e7213), _e8136);
let _e8166 = global_1.member.member_17.member.member;
let _e8170 = -(_e8160);
let _e8173 = (_e8160 - _e8161);
let _e8174 = (_e8161 - _e8160);
let _e8176 = select(_e8174, _e8173, (_e8173 > _e8174));
let _e8179 = (select(_e8170, _e8160, (_e8160 > _e8170)) / select(1e-30f, _e8176, (_e8176 > 1e-30f)));
let _e8183 = select(0f, select(2f, _e8179, (_e8161 < 0f)), (_e8160 > 0f));
let _e8187 = select(2f, select(0f, _e8179, (_e8160 < 0f)), (_e8161 > 0f));
let _e8188 = (_e8160 > _e8126);
let _e8192 = ((_e8183 > _e8118) || ((_e8183 == _e8118) && _e8188));
let _e8193 = (_e8187 < _e8122);
let _e8194 = select(_e8118, _e8183, _e8192);
let _e8198 = select(_e8122, _e8187, _e8193);
let _e8202 = select(_e8126, _e8160, _e8188);
let _e8204 = select(_e8128, _e8161, (_e8161 > _e8128));
let _e8211 = global_1.member.member_18.member_1;
let _e8212 = (_e8211 != 0u);
let _e8216 = global_1.member.member_18.member;
let _e8236 = select(-1e6f, (((((_e8216.member.member * _e1202) + (_e8216.member.member_1 * _e1207)) + (_e8216.member.member_2 * _e1196)) + _e8216.member_1) * _e7213), _e8212);
let _e8237 = select(-1e6f, (((((_e8216.member.member * _e7821) + (_e8216.member.member_1 * _e7822)) + (_e8216.member.member_2 * _e7823)) + _e8216.member_1) * _e7213), _e8212);
let _e8242 = global_1.member.member_18.member.member;
let _e8246 = -(_e8236);
let _e8249 = (_e8236 - _e8237);
let _e8250 = (_e8237 - _e8236);
let _e8252 = select(_e8250, _e8249, (_e8249 > _e8250));
let _e8255 = (select(_e8246, _e8236, (_e8236 > _e8246)) / select(1e-30f, _e8252, (_e8252 > 1e-30f)));
let _e8259 = select(0f, select(2f, _e8255, (_e8237 < 0f)), (_e8236 > 0f));
let _e8263 = select(2f, select(0f, _e8255, (_e8236 < 0f)), (_e8237 > 0f));
let _e8264 = (_e8236 > _e8202);
let _e8268 = ((_e8259 > _e8194) || ((_e8259 == _e8194) && _e8264));
let _e8269 = (_e8263 < _e8198);
let _e8270 = select(_e8194, _e8259, _e8268);
let _e8274 = select(_e8198, _e8263, _e8269);
let _e8278 = select(_e8202, _e8236, _e8264);
let _e8280 = select(_e8204, _e8237, (_e8237 > _e8204));
let _e8287 = global_1.member.member_19.member_1;
let _e8288 = (_e8287 != 0u);
let _e8292 = global_1.member.member_19.member;
let _e8312 = select(-1e6f, (((((_e8292.member.member * _e1202) + (_e8292.member.member_1 * _e1207)) + (_e8292.member.member_2 * _e1196)) + _e8292.member_1) * _e7213), _e8288);
let _e8313 = select(-1e6f, (((((_e8292.member.member * _e7821) + (_e8292.member.member_1 * _e7822)) + (_e8292.member.member_2 * _e7823)) + _e8292.member_1) * _e7213), _e8288);
let _e8318 = global_1.member.member_19.member.member;
let _e8322 = -(_e8312);
let _e8325 = (_e8312 - _e8313);
let _e8326 = (_e8313 - _e8312);
let _e8328 = select(_e8326, _e8325, (_e8325 > _e8326));
let _e8331 = (select(_e8322, _e8312, (_e8312 > _e8322)) / select(1e-30f, _e8328, (_e8328 > 1e-30f)));
let _e8335 = select(0f, select(2f, _e8331, (_e8313 < 0f)), (_e8312 > 0f));
let _e8339 = select(2f, select(0f, _e8331, (_e8312 < 0f)), (_e8313 > 0f));
let _e8340 = (_e8312 > _e8278);
let _e8344 = ((_e8335 > _e8270) || ((_e8335 == _e8270) && _e8340));
let _e8345 = (_e8339 < _e8274);
phi_18861_ = type_37(select(_e8270, _e8335, _e8344), vec3<f32>(select(select(select(select(_e8040, _e8090.member, _e8116), _e8166.member, _e8192), _e8242.member, _e8268), _e8318.member, _e8344), select(select(select(select(_e8041, _e8090.member_1, _e8116), _e8166.member_1, _e8192), _e8242.member_1, _e8268), _e8318.member_1, _e8344), select(select(select(select(_e8042, _e8090.member_2, _e8116), _e8166.member_2, _e8192), _e8242.member_2, _e8268), _e8318.member_2, _e8344)), select(_e8274, _e8339, _e8345), vec3<f32>(select(select(select(select(_e8045, _e8090.member, _e8117), _e8166.member, _e8193), _e8242.member, _e8269), _e8318.member, _e8345), select(select(select(select(_e8046, _e8090.member_1, _e8117), _e8166.member_1, _e8193), _e8242.member_1, _e8269), _e8318.member_1, _e8345), select(select(select(select(_e8047, _e8090.member_2, _e8117), _e8166.member_2, _e8193), _e8242.member_2, _e8269), _e8318.member_2, _e8345)), select(_e8278, _e8312, _e8340), select(_e8280, _e8313, (_e8313 > _e8280)), vec3<f32>(select(select(select(select(_e8051, _e8090.member, _e8112), _e8166.member, _e8188), _e8242.member, _e8264), _e8318.member, _e8340), select(select(select(select(_e8052, _e8090.member_1, _e8112), _e8166.member_1, _e8188), _e8242.member_1, _e8264), _e8318.member_1, _e8340), select(select(select(select(_e8053, _e8090.member_2, _e8112), _e8166.member_2, _e8188), _e8242.member_2, _e8264), _e8318.member_2, _e8340)));
}
let _e8365 = phi_18861_;
let _e8374 = global_1.member.member_7.member_4;
let _e8377 = (_e4211.member_4.x * _e4843.member_2);
let _e8379 = (_e4211.member_4.y * _e4843.member_2);
let _e8381 = (_e4211.member_4.z * _e4843.member_2);
let _e8382 = (0.5f * (_e7817 * select(1f, (2f * (1f - _e7201)), (_e7193 && _e7192))));
let _e8386 = (_e7800 + (_e8377 * _e8382));
let _e8387 = (_e7801 + (_e8379 * _e8382));
let _e8388 = (_e7802 + (_e8381 * _e8382));
let _e8390 = (2f * _e7814);
let _e8392 = ((_e8388 * _e8388) + (_e8390 * _e8381));
let _e8396 = (_e8388 + sqrt(select(0f, _e8392, (_e8392 > 0f))));
let _e8400 = (select(0.5f, _e8365.member_2, (_e8365.member_2 < 1f)) * (_e8390 / select(1e-6f, _e8396, (_e8396 > 1e-6f))));
let _e8404 = (_e8386 + (_e8377 * _e8400));
let _e8405 = (_e8387 + (_e8379 * _e8400));
let _e8406 = (_e8388 + (_e8381 * _e8400));
let _e8410 = (_e8374 * _e8374);
let _e8412 = (_e8406 * _e8406);
let _e8420 = (((_e8388 <= 0f) || (_e8392 <= 0f)) || ((_e8406 <= 0f) || (_e8412 <= (_e8410 * (((_e8404 * _e8404) + (_e8405 * _e8405)) + _e8412)))));
let _e8434 = (_e7800 + ((_e4211.member_5.x * _e4843.member_2) * _e7814));
let _e8435 = (_e7801 + ((_e4211.member_5.y * _e4843.member_2) * _e7814));
let _e8436 = (_e7802 + ((_e4211.member_5.z * _e4843.member_2) * _e7814));
let _e8438 = (_e8436 * _e8436);
let _e8447 = ((_e4600 & 1u) != 0u);
let _e8452 = (select(_e8420, ((_e8436 <= 0f) || (_e8438 <= (_e8410 * (((_e8434 * _e8434) + (_e8435 * _e8435)) + _e8438)))), _e8447) || (_e7799 && ((_e7775 && _e7193) || (_e7193 && (_e7802 <= 0f)))));
phi_19013_ = vec3<f32>(select(select(select(_e8404, _e8386, _e8420), _e8434, _e8447), _e245, _e8452), select(select(select(_e8405, _e8387, _e8420), _e8435, _e8447), _e256, _e8452), select(select(select(_e8406, _e8388, _e8420), _e8436, _e8447), _e267, _e8452));
phi_19014_ = select(1f, 0f, _e8452);
} else {
phi_19013_ = vec3<f32>(_e245, _e256, _e267);
phi_19014_ = 1f;
}
let _e8459 = phi_19013_;
let _e8461 = phi_19014_;
let _e8463 = (_e6605 * _e8461);
global_4.member[_e202] = (_e213 * (_e6448.member_2.x * _e8463));
global_4.member[_e214] = (_e223 * (_e6448.member_2.y * _e8463));
global_4.member[_e225] = (_e234 * (_e6448.member_2.z * _e8463));
global_4.member[_e236] = _e8459.x;
global_4.member[_e247] = _e8459.y;
global_4.member[_e258] = _e8459.z;
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
