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
var phi_954_: bool;
var phi_1144_: bool;
var phi_1147_: bool;
var phi_1341_: bool;
var phi_1677_: u32;
var phi_2050_: vec3<f32>;
var phi_7182_: type_34;
var phi_7529_: vec3<f32>;
var phi_8843_: vec3<f32>;
var phi_9219_: f32;
var phi_9220_: vec3<f32>;
var phi_9222_: type_35;
var phi_9368_: vec3<f32>;
var phi_10264_: type_36;
var phi_14208_: type_38;
var phi_14606_: f32;
var phi_15931_: type_37;
var phi_15944_: vec3<f32>;
var phi_15945_: f32;
var phi_16175_: vec3<f32>;
var phi_18633_: type_37;
var phi_18785_: vec3<f32>;
var phi_18786_: f32;
let _e171 = global;
let _e174 = arrayLength((&global_2.member));
let _e179 = arrayLength((&global_3.member));
let _e181 = arrayLength((&global_6.member));
let _e186 = global_1.member.member_2;
let _e189 = global_1.member.member;
let _e197 = (_e171.x + _e186.member);
let _e199 = (_e171.y + _e186.member_1);
if (_e197 < _e186.member_2) {
if (_e199 < _e186.member_3) {
let _e202 = (_e189.member * _e189.member_1);
let _e204 = ((_e199 * _e189.member) + _e197);
let _e205 = bitcast<i32>(_e204);
let _e207 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e209 = select(_e207, _e205, (_e205 < _e207));
let _e215 = global_4.member[bitcast<u32>(select(0i, _e209, (_e209 > 0i)))];
let _e216 = (_e202 + _e204);
let _e217 = bitcast<i32>(_e216);
let _e219 = select(_e207, _e217, (_e217 < _e207));
let _e225 = global_4.member[bitcast<u32>(select(0i, _e219, (_e219 > 0i)))];
let _e227 = ((2u * _e202) + _e204);
let _e228 = bitcast<i32>(_e227);
let _e230 = select(_e207, _e228, (_e228 < _e207));
let _e236 = global_4.member[bitcast<u32>(select(0i, _e230, (_e230 > 0i)))];
let _e238 = ((3u * _e202) + _e204);
let _e239 = bitcast<i32>(_e238);
let _e241 = select(_e207, _e239, (_e239 < _e207));
let _e247 = global_4.member[bitcast<u32>(select(0i, _e241, (_e241 > 0i)))];
let _e249 = ((4u * _e202) + _e204);
let _e250 = bitcast<i32>(_e249);
let _e252 = select(_e207, _e250, (_e250 < _e207));
let _e258 = global_4.member[bitcast<u32>(select(0i, _e252, (_e252 > 0i)))];
let _e260 = ((5u * _e202) + _e204);
let _e261 = bitcast<i32>(_e260);
let _e263 = select(_e207, _e261, (_e261 < _e207));
let _e269 = global_4.member[bitcast<u32>(select(0i, _e263, (_e263 > 0i)))];
let _e271 = ((6u * _e202) + _e204);
let _e272 = bitcast<i32>(_e271);
let _e274 = select(_e207, _e272, (_e272 < _e207));
let _e280 = global_4.member[bitcast<u32>(select(0i, _e274, (_e274 > 0i)))];
let _e282 = ((7u * _e202) + _e204);
let _e283 = bitcast<i32>(_e282);
let _e285 = select(_e207, _e283, (_e283 < _e207));
let _e291 = global_4.member[bitcast<u32>(select(0i, _e285, (_e285 > 0i)))];
let _e293 = ((8u * _e202) + _e204);
let _e294 = bitcast<i32>(_e293);
let _e296 = select(_e207, _e294, (_e294 < _e207));
let _e302 = global_4.member[bitcast<u32>(select(0i, _e296, (_e296 > 0i)))];
let _e307 = global_1.member.member_10.member;
let _e311 = global_1.member.member_10.member_1;
let _e312 = (_e307 * _e311);
if (_e181 >= (_e312 * 4u)) {
let _e316 = bitcast<i32>((_e199 * _e307));
let _e318 = bitcast<i32>(_e197);
let _e323 = global_6.member[bitcast<u32>((_e316 + _e318))];
let _e329 = global_6.member[bitcast<u32>(((bitcast<i32>(_e312) + _e316) + _e318))];
let _e330 = f32(_e318);
let _e332 = f32(bitcast<i32>(_e199));
let _e338 = global_1.member.member_7.member;
let _e342 = global_1.member.member_10.member_8;
let _e343 = (_e338 - _e342);
let _e347 = global_1.member.member_10.member_2;
let _e351 = global_1.member.member_10.member_6;
let _e358 = global_1.member.member_10.member_4;
let _e360 = ((_e347 + (_e351 * _e343)) + (((_e330 - _e323) + 0.5f) * _e358));
let _e364 = global_1.member.member_10.member_3;
let _e368 = global_1.member.member_10.member_7;
let _e373 = ((_e364 + (_e368 * _e343)) + (((_e332 - _e329) + 0.5f) * _e358));
let _e377 = global_1.member.member_7.member_1;
let _e378 = (_e377 - _e342);
let _e383 = ((_e347 + (_e351 * _e378)) + ((_e330 + 0.5f) * _e358));
let _e388 = ((_e364 + (_e368 * _e378)) + ((_e332 + 0.5f) * _e358));
let _e394 = global_1.member.member_8.member.member;
let _e402 = (((_e394.member * _e394.member) + (_e394.member_1 * _e394.member_1)) + (_e394.member_2 * _e394.member_2));
let _e405 = sqrt(select(0f, _e402, (_e402 > 0f)));
let _e406 = ((1.5f * _e358) * _e405);
let _e410 = (select(1f, _e406, (_e406 < 1f)) + (1f / 64f));
let _e412 = select(_e410, 0.5f, (0.5f > _e410));
let _e416 = global_1.member.member_7.member_2;
let _e419 = (_e416 / select(1e-6f, _e269, (_e269 > 1e-6f)));
let _e423 = (_e383 + (_e247 * _e419));
let _e424 = (_e388 + (_e258 * _e419));
let _e425 = (_e377 + (_e269 * _e419));
let _e429 = global_1.member.member_8.member;
let _e440 = ((((_e429.member.member * _e360) + (_e429.member.member_1 * _e373)) + (_e429.member.member_2 * _e338)) + _e429.member_1);
let _e444 = global_1.member.member_8.member_1;
let _e455 = ((((_e444.member.member * _e360) + (_e444.member.member_1 * _e373)) + (_e444.member.member_2 * _e338)) + _e444.member_1);
let _e459 = global_1.member.member_8.member_2;
let _e470 = ((((_e459.member.member * _e360) + (_e459.member.member_1 * _e373)) + (_e459.member.member_2 * _e338)) + _e459.member_1);
let _e476 = ((((_e429.member.member * _e383) + (_e429.member.member_1 * _e388)) + (_e429.member.member_2 * _e377)) + _e429.member_1);
let _e482 = ((((_e444.member.member * _e383) + (_e444.member.member_1 * _e388)) + (_e444.member.member_2 * _e377)) + _e444.member_1);
let _e488 = ((((_e459.member.member * _e383) + (_e459.member.member_1 * _e388)) + (_e459.member.member_2 * _e377)) + _e459.member_1);
let _e493 = global_1.member.member_8.member_4.member;
let _e494 = (_e493 + 0.5f);
let _e500 = global_1.member.member_8.member_5.member;
let _e501 = (_e500 - 0.5f);
let _e508 = global_1.member.member_8.member_4.member_1;
let _e509 = (_e508 + 0.5f);
let _e516 = global_1.member.member_8.member_5.member_1;
let _e517 = (_e516 - 0.5f);
let _e524 = global_1.member.member_8.member_4.member_2;
let _e525 = (_e524 + 0.5f);
let _e532 = global_1.member.member_8.member_5.member_2;
let _e533 = (_e532 - 0.5f);
let _e547 = (((((((_e440 >= _e494) && (_e440 <= _e501)) && (_e455 >= _e509)) && (_e455 <= _e517)) && (_e470 >= _e525)) && (_e470 <= _e533)) && ((((((_e476 >= _e494) && (_e476 <= _e501)) && (_e482 >= _e509)) && (_e482 <= _e517)) && (_e488 >= _e525)) && (_e488 <= _e533)));
let _e556 = ((((_e189.member_2 == 1u) || (_e189.member_2 == 5u)) || (_e189.member_2 == 6u)) || ((_e189.member_2 == 2u) || (_e189.member_2 == 7u)));
if _e556 {
let _e557 = (_e493 + _e412);
let _e559 = (_e500 - _e412);
let _e562 = (_e508 + _e412);
let _e564 = (_e516 - _e412);
let _e568 = (_e524 + _e412);
let _e570 = (_e532 - _e412);
let _e573 = ((((_e440 >= _e557) && (_e440 <= _e559)) && ((_e455 >= _e562) && (_e455 <= _e564))) && ((_e470 >= _e568) && (_e470 <= _e570)));
let _e576 = global_1.member.member_1;
let _e578 = ((_e576 & 16u) == 0u);
if _e578 {
phi_954_ = _e573;
} else {
let _e583 = global_1.member.member_16.member;
let _e595 = -((_e412 / _e405));
let _e600 = global_1.member.member_16.member_1;
let _e606 = global_1.member.member_17.member;
let _e622 = global_1.member.member_17.member_1;
let _e629 = global_1.member.member_18.member;
let _e645 = global_1.member.member_18.member_1;
let _e652 = global_1.member.member_19.member;
let _e668 = global_1.member.member_19.member_1;
phi_954_ = (_e573 && (((((((((_e583.member.member * _e360) + (_e583.member.member_1 * _e373)) + (_e583.member.member_2 * _e338)) + _e583.member_1) <= _e595) || (_e600 == 0u)) && ((((((_e606.member.member * _e360) + (_e606.member.member_1 * _e373)) + (_e606.member.member_2 * _e338)) + _e606.member_1) <= _e595) || (_e622 == 0u))) && ((((((_e629.member.member * _e360) + (_e629.member.member_1 * _e373)) + (_e629.member.member_2 * _e338)) + _e629.member_1) <= _e595) || (_e645 == 0u))) && ((((((_e652.member.member * _e360) + (_e652.member.member_1 * _e373)) + (_e652.member.member_2 * _e338)) + _e652.member_1) <= _e595) || (_e668 == 0u))));
}
let _e674 = phi_954_;
let _e678 = (_e383 + (_e383 - _e360));
let _e679 = (_e388 + (_e388 - _e373));
let _e680 = (_e377 + (_e377 - _e338));
let _e686 = ((((_e429.member.member * _e678) + (_e429.member.member_1 * _e679)) + (_e429.member.member_2 * _e680)) + _e429.member_1);
let _e692 = ((((_e444.member.member * _e678) + (_e444.member.member_1 * _e679)) + (_e444.member.member_2 * _e680)) + _e444.member_1);
let _e698 = ((((_e459.member.member * _e678) + (_e459.member.member_1 * _e679)) + (_e459.member.member_2 * _e680)) + _e459.member_1);
let _e709 = ((((_e686 >= _e557) && (_e686 <= _e559)) && ((_e692 >= _e562) && (_e692 <= _e564))) && ((_e698 >= _e568) && (_e698 <= _e570)));
if _e578 {
phi_1144_ = _e709;
} else {
let _e714 = global_1.member.member_16.member;
let _e726 = -((_e412 / _e405));
let _e731 = global_1.member.member_16.member_1;
let _e737 = global_1.member.member_17.member;
let _e753 = global_1.member.member_17.member_1;
let _e760 = global_1.member.member_18.member;
let _e776 = global_1.member.member_18.member_1;
let _e783 = global_1.member.member_19.member;
let _e799 = global_1.member.member_19.member_1;
phi_1144_ = (_e709 && (((((((((_e714.member.member * _e678) + (_e714.member.member_1 * _e679)) + (_e714.member.member_2 * _e680)) + _e714.member_1) <= _e726) || (_e731 == 0u)) && ((((((_e737.member.member * _e678) + (_e737.member.member_1 * _e679)) + (_e737.member.member_2 * _e680)) + _e737.member_1) <= _e726) || (_e753 == 0u))) && ((((((_e760.member.member * _e678) + (_e760.member.member_1 * _e679)) + (_e760.member.member_2 * _e680)) + _e760.member_1) <= _e726) || (_e776 == 0u))) && ((((((_e783.member.member * _e678) + (_e783.member.member_1 * _e679)) + (_e783.member.member_2 * _e680)) + _e783.member_1) <= _e726) || (_e799 == 0u))));
}
let _e805 = phi_1144_;
phi_1147_ = (_e547 && (_e674 && _e805));
} else {
phi_1147_ = _e547;
}
let _e809 = phi_1147_;
let _e816 = ((((_e429.member.member * _e423) + (_e429.member.member_1 * _e424)) + (_e429.member.member_2 * _e425)) + _e429.member_1);
let _e822 = ((((_e444.member.member * _e423) + (_e444.member.member_1 * _e424)) + (_e444.member.member_2 * _e425)) + _e444.member_1);
let _e828 = ((((_e459.member.member * _e423) + (_e459.member.member_1 * _e424)) + (_e459.member.member_2 * _e425)) + _e459.member_1);
let _e845 = ((((_e816 >= (_e493 + _e412)) && (_e816 <= (_e500 - _e412))) && ((_e822 >= (_e508 + _e412)) && (_e822 <= (_e516 - _e412)))) && ((_e828 >= (_e524 + _e412)) && (_e828 <= (_e532 - _e412))));
let _e848 = global_1.member.member_1;
if ((_e848 & 16u) == 0u) {
phi_1341_ = _e845;
} else {
let _e855 = global_1.member.member_16.member;
let _e867 = -((_e412 / _e405));
let _e872 = global_1.member.member_16.member_1;
let _e878 = global_1.member.member_17.member;
let _e894 = global_1.member.member_17.member_1;
let _e901 = global_1.member.member_18.member;
let _e917 = global_1.member.member_18.member_1;
let _e924 = global_1.member.member_19.member;
let _e940 = global_1.member.member_19.member_1;
phi_1341_ = (_e845 && (((((((((_e855.member.member * _e423) + (_e855.member.member_1 * _e424)) + (_e855.member.member_2 * _e425)) + _e855.member_1) <= _e867) || (_e872 == 0u)) && ((((((_e878.member.member * _e423) + (_e878.member.member_1 * _e424)) + (_e878.member.member_2 * _e425)) + _e878.member_1) <= _e867) || (_e894 == 0u))) && ((((((_e901.member.member * _e423) + (_e901.member.member_1 * _e424)) + (_e901.member.member_2 * _e425)) + _e901.member_1) <= _e867) || (_e917 == 0u))) && ((((((_e924.member.member * _e423) + (_e924.member.member_1 * _e424)) + (_e924.member.member_2 * _e425)) + _e924.member_1) <= _e867) || (_e940 == 0u))));
}
let _e946 = phi_1341_;
let _e957 = global_1.member.member_8.member_6;
let _e959 = select(_e493, _e476, (_e476 > _e493));
let _e961 = select(_e500, _e959, (_e959 < _e500));
let _e963 = select(_e508, _e482, (_e482 > _e508));
let _e965 = select(_e516, _e963, (_e963 < _e516));
let _e967 = select(_e524, _e488, (_e488 > _e524));
let _e969 = select(_e532, _e967, (_e967 < _e532));
let _e975 = bitcast<f32>((bitcast<u32>((_e476 - _e440)) & 2147483647u));
let _e978 = bitcast<f32>((bitcast<u32>((_e482 - _e455)) & 2147483647u));
let _e980 = select(_e978, _e975, (_e975 > _e978));
let _e983 = bitcast<f32>((bitcast<u32>((_e488 - _e470)) & 2147483647u));
let _e992 = bitcast<f32>((bitcast<u32>((_e476 - _e961)) & 2147483647u));
let _e995 = bitcast<f32>((bitcast<u32>((_e482 - _e965)) & 2147483647u));
let _e997 = select(_e995, _e992, (_e992 > _e995));
let _e1000 = bitcast<f32>((bitcast<u32>((_e488 - _e969)) & 2147483647u));
let _e1008 = global_1.member.member_8.member_3.member;
let _e1009 = (_e961 + 0.5f);
let _e1010 = (_e1008 - 1f);
let _e1012 = select(0f, _e1009, (_e1009 > 0f));
let _e1014 = select(_e1010, _e1012, (_e1012 < _e1010));
let _e1021 = select(0i, select(select(i32(_e1014), i32(-2147483648), (_e1014 < -2147483600f)), 2147483647i, (_e1014 > 2147483500f)), (_e1014 == _e1014));
let _e1029 = global_1.member.member_8.member_14;
let _e1030 = (_e1029 & 31u);
let _e1037 = global_1.member.member_8.member_3.member_1;
let _e1038 = (_e965 + 0.5f);
let _e1039 = (_e1037 - 1f);
let _e1041 = select(0f, _e1038, (_e1038 > 0f));
let _e1043 = select(_e1039, _e1041, (_e1041 < _e1039));
let _e1050 = select(0i, select(select(i32(_e1043), i32(-2147483648), (_e1043 < -2147483600f)), 2147483647i, (_e1043 > 2147483500f)), (_e1043 == _e1043));
let _e1061 = global_1.member.member_8.member_3.member_2;
let _e1062 = (_e969 + 0.5f);
let _e1063 = (_e1061 - 1f);
let _e1065 = select(0f, _e1062, (_e1062 > 0f));
let _e1067 = select(_e1063, _e1065, (_e1065 < _e1063));
let _e1074 = select(0i, select(select(i32(_e1067), i32(-2147483648), (_e1067 < -2147483600f)), 2147483647i, (_e1067 > 2147483500f)), (_e1067 == _e1067));
let _e1085 = global_1.member.member_8.member_11.member;
let _e1091 = global_1.member.member_8.member_11.member_1;
let _e1096 = global_1.member.member_8.member_12;
let _e1102 = ((bitcast<i32>(_e1096) + ((_e1021 - select(0i, 1i, (_e1014 < f32(_e1021)))) >> bitcast<u32>(_e1030))) + (bitcast<i32>(_e1085) * (((_e1050 - select(0i, 1i, (_e1043 < f32(_e1050)))) >> bitcast<u32>(_e1030)) + (bitcast<i32>(_e1091) * ((_e1074 - select(0i, 1i, (_e1067 < f32(_e1074)))) >> bitcast<u32>(_e1030))))));
let _e1104 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e1106 = select(_e1104, _e1102, (_e1102 < _e1104));
let _e1112 = global_5.member[bitcast<u32>(select(0i, _e1106, (_e1106 > 0i)))];
phi_1677_ = select(select(7u, 3u, ((_e809 && (!(_e556) || _e946)) && (true && ((_e848 & 1024u) == 0u)))), 1u, (((_e848 & 64u) != 0u) || ((((select(_e983, _e980, (_e980 > _e983)) <= _e957) && ((select(_e1000, _e997, (_e997 > _e1000)) > _e957) || (_e1112 != 0u))) && true) && ((_e848 & 32u) != 0u))));
} else {
phi_1677_ = 7u;
}
let _e1125 = phi_1677_;
if (_e1125 > 1u) {
let _e1130 = bitcast<i32>(((_e199 * _e307) + _e197));
let _e1133 = (bitcast<i32>(_e181) - 1i);
let _e1135 = select(_e1133, _e1130, (_e1130 < _e1133));
let _e1141 = global_6.member[bitcast<u32>(select(0i, _e1135, (_e1135 > 0i)))];
let _e1142 = (bitcast<i32>(_e312) + _e1130);
let _e1144 = select(_e1133, _e1142, (_e1142 < _e1133));
let _e1150 = global_6.member[bitcast<u32>(select(0i, _e1144, (_e1144 > 0i)))];
let _e1152 = f32(bitcast<i32>(_e197));
let _e1154 = f32(bitcast<i32>(_e199));
let _e1160 = global_1.member.member_7.member;
let _e1164 = global_1.member.member_10.member_8;
let _e1165 = (_e1160 - _e1164);
let _e1169 = global_1.member.member_10.member_2;
let _e1173 = global_1.member.member_10.member_6;
let _e1180 = global_1.member.member_10.member_4;
let _e1182 = ((_e1169 + (_e1173 * _e1165)) + (((_e1152 - _e1141) + 0.5f) * _e1180));
let _e1186 = global_1.member.member_10.member_3;
let _e1190 = global_1.member.member_10.member_7;
let _e1195 = ((_e1186 + (_e1190 * _e1165)) + (((_e1154 - _e1150) + 0.5f) * _e1180));
let _e1199 = global_1.member.member_7.member_1;
let _e1200 = (_e1199 - _e1164);
let _e1205 = ((_e1169 + (_e1173 * _e1200)) + ((_e1152 + 0.5f) * _e1180));
let _e1210 = ((_e1186 + (_e1190 * _e1200)) + ((_e1154 + 0.5f) * _e1180));
let _e1214 = global_1.member.member_8.member;
let _e1225 = ((((_e1214.member.member * _e1182) + (_e1214.member.member_1 * _e1195)) + (_e1214.member.member_2 * _e1160)) + _e1214.member_1);
let _e1229 = global_1.member.member_8.member_1;
let _e1240 = ((((_e1229.member.member * _e1182) + (_e1229.member.member_1 * _e1195)) + (_e1229.member.member_2 * _e1160)) + _e1229.member_1);
let _e1244 = global_1.member.member_8.member_2;
let _e1255 = ((((_e1244.member.member * _e1182) + (_e1244.member.member_1 * _e1195)) + (_e1244.member.member_2 * _e1160)) + _e1244.member_1);
let _e1261 = ((((_e1214.member.member * _e1205) + (_e1214.member.member_1 * _e1210)) + (_e1214.member.member_2 * _e1199)) + _e1214.member_1);
let _e1267 = ((((_e1229.member.member * _e1205) + (_e1229.member.member_1 * _e1210)) + (_e1229.member.member_2 * _e1199)) + _e1229.member_1);
let _e1273 = ((((_e1244.member.member * _e1205) + (_e1244.member.member_1 * _e1210)) + (_e1244.member.member_2 * _e1199)) + _e1244.member_1);
let _e1275 = (_e189.member_2 == 5u);
let _e1281 = ((_e189.member_2 == 2u) || (_e189.member_2 == 7u));
let _e1282 = ((((_e189.member_2 == 1u) || _e1275) || (_e189.member_2 == 6u)) || _e1281);
if _e1282 {
let _e1287 = global_1.member.member_8.member_4.member;
let _e1292 = global_1.member.member_8.member_5.member;
let _e1294 = select(_e1287, _e1261, (_e1261 > _e1287));
let _e1296 = select(_e1292, _e1294, (_e1294 < _e1292));
let _e1301 = global_1.member.member_8.member_4.member_1;
let _e1306 = global_1.member.member_8.member_5.member_1;
let _e1308 = select(_e1301, _e1267, (_e1267 > _e1301));
let _e1310 = select(_e1306, _e1308, (_e1308 < _e1306));
let _e1315 = global_1.member.member_8.member_4.member_2;
let _e1320 = global_1.member.member_8.member_5.member_2;
let _e1322 = select(_e1315, _e1273, (_e1273 > _e1315));
let _e1324 = select(_e1320, _e1322, (_e1322 < _e1320));
let _e1329 = global_1.member.member_8.member_15;
if (_e1329 == 0u) {
phi_2050_ = vec3<f32>(_e1296, _e1310, _e1324);
} else {
let _e1331 = (_e1296 + 0.5f);
let _e1336 = global_1.member.member_8.member_3.member;
let _e1337 = (_e1336 - 1f);
let _e1339 = select(0f, _e1331, (_e1331 > 0f));
let _e1341 = select(_e1337, _e1339, (_e1339 < _e1337));
let _e1348 = select(0i, select(select(i32(_e1341), i32(-2147483648), (_e1341 < -2147483600f)), 2147483647i, (_e1341 > 2147483500f)), (_e1341 == _e1341));
let _e1354 = (_e1310 + 0.5f);
let _e1359 = global_1.member.member_8.member_3.member_1;
let _e1360 = (_e1359 - 1f);
let _e1362 = select(0f, _e1354, (_e1354 > 0f));
let _e1364 = select(_e1360, _e1362, (_e1362 < _e1360));
let _e1371 = select(0i, select(select(i32(_e1364), i32(-2147483648), (_e1364 < -2147483600f)), 2147483647i, (_e1364 > 2147483500f)), (_e1364 == _e1364));
let _e1377 = (_e1324 + 0.5f);
let _e1382 = global_1.member.member_8.member_3.member_2;
let _e1383 = (_e1382 - 1f);
let _e1385 = select(0f, _e1377, (_e1377 > 0f));
let _e1387 = select(_e1383, _e1385, (_e1385 < _e1383));
let _e1394 = select(0i, select(select(i32(_e1387), i32(-2147483648), (_e1387 < -2147483600f)), 2147483647i, (_e1387 > 2147483500f)), (_e1387 == _e1387));
phi_2050_ = vec3<f32>(f32((_e1348 - select(0i, 1i, (_e1341 < f32(_e1348))))), f32((_e1371 - select(0i, 1i, (_e1364 < f32(_e1371))))), f32((_e1394 - select(0i, 1i, (_e1387 < f32(_e1394))))));
}
let _e1402 = phi_2050_;
let _e1408 = global_1.member.member_8.member_3.member;
let _e1410 = select(-1f, _e1402.x, (_e1402.x > -1f));
let _e1412 = select(_e1408, _e1410, (_e1410 < _e1408));
let _e1419 = select(0i, select(select(i32(_e1412), i32(-2147483648), (_e1412 < -2147483600f)), 2147483647i, (_e1412 > 2147483500f)), (_e1412 == _e1412));
let _e1423 = (_e1419 - select(0i, 1i, (_e1412 < f32(_e1419))));
let _e1429 = global_1.member.member_8.member_3.member_1;
let _e1431 = select(-1f, _e1402.y, (_e1402.y > -1f));
let _e1433 = select(_e1429, _e1431, (_e1431 < _e1429));
let _e1440 = select(0i, select(select(i32(_e1433), i32(-2147483648), (_e1433 < -2147483600f)), 2147483647i, (_e1433 > 2147483500f)), (_e1433 == _e1433));
let _e1444 = (_e1440 - select(0i, 1i, (_e1433 < f32(_e1440))));
let _e1450 = global_1.member.member_8.member_3.member_2;
let _e1452 = select(-1f, _e1402.z, (_e1402.z > -1f));
let _e1454 = select(_e1450, _e1452, (_e1452 < _e1450));
let _e1461 = select(0i, select(select(i32(_e1454), i32(-2147483648), (_e1454 < -2147483600f)), 2147483647i, (_e1454 > 2147483500f)), (_e1454 == _e1454));
let _e1465 = (_e1461 - select(0i, 1i, (_e1454 < f32(_e1461))));
let _e1469 = global_1.member.member_8.member_9;
let _e1473 = global_1.member.member_8.member_10;
let _e1474 = (_e1423 + 1i);
let _e1475 = (_e1444 + 1i);
let _e1476 = (_e1465 + 1i);
let _e1481 = global_1.member.member_8.member_13.member;
let _e1487 = global_1.member.member_8.member_13.member_1;
let _e1498 = ((_e1474 >> bitcast<u32>(4i)) + (bitcast<i32>(_e1481) * ((_e1475 >> bitcast<u32>(4i)) + (bitcast<i32>(_e1487) * (_e1476 >> bitcast<u32>(4i))))));
let _e1500 = (bitcast<i32>(_e174) - 1i);
let _e1502 = select(_e1500, _e1498, (_e1498 < _e1500));
let _e1508 = global_2.member[bitcast<u32>(select(0i, _e1502, (_e1502 > 0i)))];
let _e1510 = (_e1474 & 15i);
let _e1513 = ((_e1475 & 15i) * _e1469);
let _e1515 = (bitcast<i32>(_e1508) + ((_e1476 & 15i) * _e1473));
let _e1519 = (_e1513 + _e1469);
let _e1521 = (_e1513 + (2i * _e1469));
let _e1523 = (_e1513 + (3i * _e1469));
let _e1524 = (_e1515 + _e1473);
let _e1526 = (_e1515 + (2i * _e1473));
let _e1528 = (_e1515 + (3i * _e1473));
local_28 = type_30(array<i32, 4>(_e1510, (_e1510 + 1i), (_e1510 + 2i), (_e1510 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_29 = (_e1402 - vec3<f32>(f32(_e1423), f32(_e1444), f32(_e1465)));
let _e1537 = (_e1524 + _e1519);
let _e1540 = local_28.member[0u];
let _e1541 = (_e1537 + _e1540);
let _e1543 = select(_e1500, _e1541, (_e1541 < _e1500));
let _e1548 = global_2.member[bitcast<u32>(select(0i, _e1543, (_e1543 > 0i)))];
let _e1549 = bitcast<f32>(_e1548);
let _e1552 = local_28.member[1u];
let _e1553 = (_e1537 + _e1552);
let _e1555 = select(_e1500, _e1553, (_e1553 < _e1500));
let _e1560 = global_2.member[bitcast<u32>(select(0i, _e1555, (_e1555 > 0i)))];
let _e1561 = bitcast<f32>(_e1560);
let _e1564 = local_28.member[2u];
let _e1565 = (_e1537 + _e1564);
let _e1567 = select(_e1500, _e1565, (_e1565 < _e1500));
let _e1572 = global_2.member[bitcast<u32>(select(0i, _e1567, (_e1567 > 0i)))];
let _e1573 = bitcast<f32>(_e1572);
let _e1576 = local_28.member[3u];
let _e1577 = (_e1537 + _e1576);
let _e1579 = select(_e1500, _e1577, (_e1577 < _e1500));
let _e1584 = global_2.member[bitcast<u32>(select(0i, _e1579, (_e1579 > 0i)))];
let _e1586 = local_29[0u];
let _e1589 = (_e1549 + ((_e1561 - _e1549) * _e1586));
let _e1590 = local_29[0u];
let _e1593 = (_e1561 + ((_e1573 - _e1561) * _e1590));
let _e1594 = local_29[0u];
let _e1597 = (_e1573 + ((bitcast<f32>(_e1584) - _e1573) * _e1594));
let _e1598 = (_e1524 + _e1521);
let _e1599 = local_28.member[0u];
let _e1600 = (_e1598 + _e1599);
let _e1602 = select(_e1500, _e1600, (_e1600 < _e1500));
let _e1607 = global_2.member[bitcast<u32>(select(0i, _e1602, (_e1602 > 0i)))];
let _e1608 = bitcast<f32>(_e1607);
let _e1609 = local_28.member[1u];
let _e1610 = (_e1598 + _e1609);
let _e1612 = select(_e1500, _e1610, (_e1610 < _e1500));
let _e1617 = global_2.member[bitcast<u32>(select(0i, _e1612, (_e1612 > 0i)))];
let _e1618 = bitcast<f32>(_e1617);
let _e1619 = local_28.member[2u];
let _e1620 = (_e1598 + _e1619);
let _e1622 = select(_e1500, _e1620, (_e1620 < _e1500));
let _e1627 = global_2.member[bitcast<u32>(select(0i, _e1622, (_e1622 > 0i)))];
let _e1628 = bitcast<f32>(_e1627);
let _e1629 = local_28.member[3u];
let _e1630 = (_e1598 + _e1629);
let _e1632 = select(_e1500, _e1630, (_e1630 < _e1500));
let _e1637 = global_2.member[bitcast<u32>(select(0i, _e1632, (_e1632 > 0i)))];
let _e1639 = local_29[0u];
let _e1643 = local_29[0u];
let _e1646 = (_e1618 + ((_e1628 - _e1618) * _e1643));
let _e1647 = local_29[0u];
let _e1651 = (_e1526 + _e1519);
let _e1652 = local_28.member[0u];
let _e1653 = (_e1651 + _e1652);
let _e1655 = select(_e1500, _e1653, (_e1653 < _e1500));
let _e1660 = global_2.member[bitcast<u32>(select(0i, _e1655, (_e1655 > 0i)))];
let _e1661 = bitcast<f32>(_e1660);
let _e1662 = local_28.member[1u];
let _e1663 = (_e1651 + _e1662);
let _e1665 = select(_e1500, _e1663, (_e1663 < _e1500));
let _e1670 = global_2.member[bitcast<u32>(select(0i, _e1665, (_e1665 > 0i)))];
let _e1671 = bitcast<f32>(_e1670);
let _e1672 = local_28.member[2u];
let _e1673 = (_e1651 + _e1672);
let _e1675 = select(_e1500, _e1673, (_e1673 < _e1500));
let _e1680 = global_2.member[bitcast<u32>(select(0i, _e1675, (_e1675 > 0i)))];
let _e1681 = bitcast<f32>(_e1680);
let _e1682 = local_28.member[3u];
let _e1683 = (_e1651 + _e1682);
let _e1685 = select(_e1500, _e1683, (_e1683 < _e1500));
let _e1690 = global_2.member[bitcast<u32>(select(0i, _e1685, (_e1685 > 0i)))];
let _e1692 = local_29[0u];
let _e1695 = (_e1661 + ((_e1671 - _e1661) * _e1692));
let _e1696 = local_29[0u];
let _e1699 = (_e1671 + ((_e1681 - _e1671) * _e1696));
let _e1700 = local_29[0u];
let _e1703 = (_e1681 + ((bitcast<f32>(_e1690) - _e1681) * _e1700));
let _e1704 = (_e1526 + _e1521);
let _e1705 = local_28.member[0u];
let _e1706 = (_e1704 + _e1705);
let _e1708 = select(_e1500, _e1706, (_e1706 < _e1500));
let _e1713 = global_2.member[bitcast<u32>(select(0i, _e1708, (_e1708 > 0i)))];
let _e1714 = bitcast<f32>(_e1713);
let _e1715 = local_28.member[1u];
let _e1716 = (_e1704 + _e1715);
let _e1718 = select(_e1500, _e1716, (_e1716 < _e1500));
let _e1723 = global_2.member[bitcast<u32>(select(0i, _e1718, (_e1718 > 0i)))];
let _e1724 = bitcast<f32>(_e1723);
let _e1725 = local_28.member[2u];
let _e1726 = (_e1704 + _e1725);
let _e1728 = select(_e1500, _e1726, (_e1726 < _e1500));
let _e1733 = global_2.member[bitcast<u32>(select(0i, _e1728, (_e1728 > 0i)))];
let _e1734 = bitcast<f32>(_e1733);
let _e1735 = local_28.member[3u];
let _e1736 = (_e1704 + _e1735);
let _e1738 = select(_e1500, _e1736, (_e1736 < _e1500));
let _e1743 = global_2.member[bitcast<u32>(select(0i, _e1738, (_e1738 > 0i)))];
let _e1745 = local_29[0u];
let _e1749 = local_29[0u];
let _e1752 = (_e1724 + ((_e1734 - _e1724) * _e1749));
let _e1753 = local_29[0u];
let _e1757 = (_e1524 + _e1513);
let _e1758 = local_28.member[1u];
let _e1759 = (_e1757 + _e1758);
let _e1761 = select(_e1500, _e1759, (_e1759 < _e1500));
let _e1766 = global_2.member[bitcast<u32>(select(0i, _e1761, (_e1761 > 0i)))];
let _e1767 = bitcast<f32>(_e1766);
let _e1768 = local_28.member[2u];
let _e1769 = (_e1757 + _e1768);
let _e1771 = select(_e1500, _e1769, (_e1769 < _e1500));
let _e1776 = global_2.member[bitcast<u32>(select(0i, _e1771, (_e1771 > 0i)))];
let _e1778 = local_29[0u];
let _e1781 = (_e1767 + ((bitcast<f32>(_e1776) - _e1767) * _e1778));
let _e1782 = (_e1524 + _e1523);
let _e1783 = local_28.member[1u];
let _e1784 = (_e1782 + _e1783);
let _e1786 = select(_e1500, _e1784, (_e1784 < _e1500));
let _e1791 = global_2.member[bitcast<u32>(select(0i, _e1786, (_e1786 > 0i)))];
let _e1792 = bitcast<f32>(_e1791);
let _e1793 = local_28.member[2u];
let _e1794 = (_e1782 + _e1793);
let _e1796 = select(_e1500, _e1794, (_e1794 < _e1500));
let _e1801 = global_2.member[bitcast<u32>(select(0i, _e1796, (_e1796 > 0i)))];
let _e1803 = local_29[0u];
let _e1807 = (_e1526 + _e1513);
let _e1808 = local_28.member[1u];
let _e1809 = (_e1807 + _e1808);
let _e1811 = select(_e1500, _e1809, (_e1809 < _e1500));
let _e1816 = global_2.member[bitcast<u32>(select(0i, _e1811, (_e1811 > 0i)))];
let _e1817 = bitcast<f32>(_e1816);
let _e1818 = local_28.member[2u];
let _e1819 = (_e1807 + _e1818);
let _e1821 = select(_e1500, _e1819, (_e1819 < _e1500));
let _e1826 = global_2.member[bitcast<u32>(select(0i, _e1821, (_e1821 > 0i)))];
let _e1828 = local_29[0u];
let _e1831 = (_e1817 + ((bitcast<f32>(_e1826) - _e1817) * _e1828));
let _e1832 = (_e1526 + _e1523);
let _e1833 = local_28.member[1u];
let _e1834 = (_e1832 + _e1833);
let _e1836 = select(_e1500, _e1834, (_e1834 < _e1500));
let _e1841 = global_2.member[bitcast<u32>(select(0i, _e1836, (_e1836 > 0i)))];
let _e1842 = bitcast<f32>(_e1841);
let _e1843 = local_28.member[2u];
let _e1844 = (_e1832 + _e1843);
let _e1846 = select(_e1500, _e1844, (_e1844 < _e1500));
let _e1851 = global_2.member[bitcast<u32>(select(0i, _e1846, (_e1846 > 0i)))];
let _e1853 = local_29[0u];
let _e1857 = (_e1515 + _e1519);
let _e1858 = local_28.member[1u];
let _e1859 = (_e1857 + _e1858);
let _e1861 = select(_e1500, _e1859, (_e1859 < _e1500));
let _e1866 = global_2.member[bitcast<u32>(select(0i, _e1861, (_e1861 > 0i)))];
let _e1867 = bitcast<f32>(_e1866);
let _e1868 = local_28.member[2u];
let _e1869 = (_e1857 + _e1868);
let _e1871 = select(_e1500, _e1869, (_e1869 < _e1500));
let _e1876 = global_2.member[bitcast<u32>(select(0i, _e1871, (_e1871 > 0i)))];
let _e1878 = local_29[0u];
let _e1881 = (_e1867 + ((bitcast<f32>(_e1876) - _e1867) * _e1878));
let _e1882 = (_e1528 + _e1519);
let _e1883 = local_28.member[1u];
let _e1884 = (_e1882 + _e1883);
let _e1886 = select(_e1500, _e1884, (_e1884 < _e1500));
let _e1891 = global_2.member[bitcast<u32>(select(0i, _e1886, (_e1886 > 0i)))];
let _e1892 = bitcast<f32>(_e1891);
let _e1893 = local_28.member[2u];
let _e1894 = (_e1882 + _e1893);
let _e1896 = select(_e1500, _e1894, (_e1894 < _e1500));
let _e1901 = global_2.member[bitcast<u32>(select(0i, _e1896, (_e1896 > 0i)))];
let _e1903 = local_29[0u];
let _e1906 = (_e1892 + ((bitcast<f32>(_e1901) - _e1892) * _e1903));
let _e1907 = (_e1515 + _e1521);
let _e1908 = local_28.member[1u];
let _e1909 = (_e1907 + _e1908);
let _e1911 = select(_e1500, _e1909, (_e1909 < _e1500));
let _e1916 = global_2.member[bitcast<u32>(select(0i, _e1911, (_e1911 > 0i)))];
let _e1917 = bitcast<f32>(_e1916);
let _e1918 = local_28.member[2u];
let _e1919 = (_e1907 + _e1918);
let _e1921 = select(_e1500, _e1919, (_e1919 < _e1500));
let _e1926 = global_2.member[bitcast<u32>(select(0i, _e1921, (_e1921 > 0i)))];
let _e1928 = local_29[0u];
let _e1932 = (_e1528 + _e1521);
let _e1933 = local_28.member[1u];
let _e1934 = (_e1932 + _e1933);
let _e1936 = select(_e1500, _e1934, (_e1934 < _e1500));
let _e1941 = global_2.member[bitcast<u32>(select(0i, _e1936, (_e1936 > 0i)))];
let _e1942 = bitcast<f32>(_e1941);
let _e1943 = local_28.member[2u];
let _e1944 = (_e1932 + _e1943);
let _e1946 = select(_e1500, _e1944, (_e1944 < _e1500));
let _e1951 = global_2.member[bitcast<u32>(select(0i, _e1946, (_e1946 > 0i)))];
let _e1953 = local_29[0u];
let _e1958 = local_29[1u];
let _e1961 = (_e1593 + ((_e1646 - _e1593) * _e1958));
let _e1962 = local_29[1u];
let _e1965 = (_e1699 + ((_e1752 - _e1699) * _e1962));
let _e1966 = local_29[1u];
let _e1969 = (_e1589 + (((_e1608 + ((_e1618 - _e1608) * _e1639)) - _e1589) * _e1966));
let _e1970 = local_29[1u];
let _e1975 = local_29[2u];
let _e1979 = local_29[1u];
let _e1982 = (_e1597 + (((_e1628 + ((bitcast<f32>(_e1637) - _e1628) * _e1647)) - _e1597) * _e1979));
let _e1983 = local_29[1u];
let _e1987 = local_29[2u];
let _e1991 = local_29[1u];
let _e1994 = (_e1781 + ((_e1593 - _e1781) * _e1991));
let _e1995 = local_29[1u];
let _e1999 = local_29[2u];
let _e2003 = local_29[1u];
let _e2006 = (_e1646 + (((_e1792 + ((bitcast<f32>(_e1801) - _e1792) * _e1803)) - _e1646) * _e2003));
let _e2007 = local_29[1u];
let _e2011 = local_29[2u];
let _e2015 = local_29[1u];
let _e2018 = (_e1881 + (((_e1917 + ((bitcast<f32>(_e1926) - _e1917) * _e1928)) - _e1881) * _e2015));
let _e2019 = local_29[2u];
let _e2023 = local_29[1u];
let _e2027 = local_29[2u];
let _e2031 = local_29[2u];
let _e2038 = global_1.member.member_8.member_8;
let _e2042 = global_1.member.member_8.member_7;
let _e2044 = (((_e1961 + ((_e1965 - _e1961) * _e2031)) - _e2038) * _e2042);
let _e2045 = -(1e9f);
let _e2047 = select(_e2045, _e2044, (_e2044 > _e2045));
let _e2049 = select(1e9f, _e2047, (_e2047 < 1e9f));
let _e2051 = (((_e1969 + (((_e1695 + (((_e1714 + ((_e1724 - _e1714) * _e1745)) - _e1695) * _e1970)) - _e1969) * _e1975)) - _e2038) * _e2042);
let _e2053 = select(_e2045, _e2051, (_e2051 > _e2045));
let _e2055 = select(1e9f, _e2053, (_e2053 < 1e9f));
let _e2057 = (((_e1982 + (((_e1703 + (((_e1734 + ((bitcast<f32>(_e1743) - _e1734) * _e1753)) - _e1703) * _e1983)) - _e1982) * _e1987)) - _e2038) * _e2042);
let _e2059 = select(_e2045, _e2057, (_e2057 > _e2045));
let _e2061 = select(1e9f, _e2059, (_e2059 < 1e9f));
let _e2063 = (((_e1994 + (((_e1831 + ((_e1699 - _e1831) * _e1995)) - _e1994) * _e1999)) - _e2038) * _e2042);
let _e2065 = select(_e2045, _e2063, (_e2063 > _e2045));
let _e2067 = select(1e9f, _e2065, (_e2065 < 1e9f));
let _e2069 = (((_e2006 + (((_e1752 + (((_e1842 + ((bitcast<f32>(_e1851) - _e1842) * _e1853)) - _e1752) * _e2007)) - _e2006) * _e2011)) - _e2038) * _e2042);
let _e2071 = select(_e2045, _e2069, (_e2069 > _e2045));
let _e2073 = select(1e9f, _e2071, (_e2071 < 1e9f));
let _e2075 = (((_e2018 + ((_e1961 - _e2018) * _e2019)) - _e2038) * _e2042);
let _e2077 = select(_e2045, _e2075, (_e2075 > _e2045));
let _e2079 = select(1e9f, _e2077, (_e2077 < 1e9f));
let _e2081 = (((_e1965 + (((_e1906 + (((_e1942 + ((bitcast<f32>(_e1951) - _e1942) * _e1953)) - _e1906) * _e2023)) - _e1965) * _e2027)) - _e2038) * _e2042);
let _e2083 = select(_e2045, _e2081, (_e2081 > _e2045));
let _e2085 = select(1e9f, _e2083, (_e2083 < 1e9f));
local_26 = _e2049;
let _e2086 = local_26;
local_27 = _e2086;
let _e2087 = local_27;
let _e2089 = (bitcast<i32>(_e179) - 1i);
let _e2091 = select(_e2089, 263197i, (263197i < _e2089));
let _e2096 = global_3.member[bitcast<u32>(select(0i, _e2091, (_e2091 > 0i)))];
let _e2097 = bitcast<f32>(_e2096);
let _e2099 = select(_e2089, 263198i, (263198i < _e2089));
let _e2102 = bitcast<u32>(select(0i, _e2099, (_e2099 > 0i)));
let _e2104 = global_3.member[_e2102];
let _e2105 = bitcast<f32>(_e2104);
let _e2107 = select(_e2089, 263199i, (263199i < _e2089));
let _e2112 = global_3.member[bitcast<u32>(select(0i, _e2107, (_e2107 > 0i)))];
let _e2113 = bitcast<f32>(_e2112);
let _e2115 = ((_e2087 - _e2097) * _e2105);
let _e2117 = select(0f, _e2115, (_e2115 > 0f));
let _e2120 = local_27;
let _e2122 = select(_e2089, 263200i, (263200i < _e2089));
let _e2127 = global_3.member[bitcast<u32>(select(0i, _e2122, (_e2122 > 0i)))];
let _e2128 = bitcast<f32>(_e2127);
let _e2130 = select(_e2089, 263201i, (263201i < _e2089));
let _e2135 = global_3.member[bitcast<u32>(select(0i, _e2130, (_e2130 > 0i)))];
let _e2136 = bitcast<f32>(_e2135);
let _e2138 = select(_e2089, 263202i, (263202i < _e2089));
let _e2143 = global_3.member[bitcast<u32>(select(0i, _e2138, (_e2138 > 0i)))];
let _e2144 = bitcast<f32>(_e2143);
let _e2146 = ((_e2120 - _e2128) * _e2136);
let _e2148 = select(0f, _e2146, (_e2146 > 0f));
let _e2152 = local_27;
let _e2154 = select(_e2089, 263203i, (263203i < _e2089));
let _e2159 = global_3.member[bitcast<u32>(select(0i, _e2154, (_e2154 > 0i)))];
let _e2160 = bitcast<f32>(_e2159);
let _e2162 = select(_e2089, 263204i, (263204i < _e2089));
let _e2167 = global_3.member[bitcast<u32>(select(0i, _e2162, (_e2162 > 0i)))];
let _e2168 = bitcast<f32>(_e2167);
let _e2170 = select(_e2089, 263205i, (263205i < _e2089));
let _e2175 = global_3.member[bitcast<u32>(select(0i, _e2170, (_e2170 > 0i)))];
let _e2176 = bitcast<f32>(_e2175);
let _e2178 = ((_e2152 - _e2160) * _e2168);
let _e2180 = select(0f, _e2178, (_e2178 > 0f));
let _e2183 = local_27;
let _e2185 = select(_e2089, 263206i, (263206i < _e2089));
let _e2190 = global_3.member[bitcast<u32>(select(0i, _e2185, (_e2185 > 0i)))];
let _e2191 = bitcast<f32>(_e2190);
let _e2193 = select(_e2089, 263207i, (263207i < _e2089));
let _e2198 = global_3.member[bitcast<u32>(select(0i, _e2193, (_e2193 > 0i)))];
let _e2199 = bitcast<f32>(_e2198);
let _e2201 = select(_e2089, 263208i, (263208i < _e2089));
let _e2206 = global_3.member[bitcast<u32>(select(0i, _e2201, (_e2201 > 0i)))];
let _e2207 = bitcast<f32>(_e2206);
let _e2209 = ((_e2183 - _e2191) * _e2199);
let _e2211 = select(0f, _e2209, (_e2209 > 0f));
let _e2215 = ((select(_e2113, _e2117, (_e2117 < _e2113)) + select(_e2144, _e2148, (_e2148 < _e2144))) + (select(_e2176, _e2180, (_e2180 < _e2176)) + select(_e2207, _e2211, (_e2211 < _e2207))));
let _e2217 = select(0f, _e2215, (_e2215 > 0f));
let _e2219 = select(1023f, _e2217, (_e2217 < 1023f));
let _e2226 = select(0i, select(select(i32(_e2219), i32(-2147483648), (_e2219 < -2147483600f)), 2147483647i, (_e2219 > 2147483500f)), (_e2219 == _e2219));
let _e2230 = (_e2226 - select(0i, 1i, (_e2219 < f32(_e2226))));
let _e2231 = (262147i + _e2230);
let _e2233 = select(_e2089, _e2231, (_e2231 < _e2089));
let _e2239 = global_3.member[bitcast<u32>(select(0i, _e2233, (_e2233 > 0i)))];
let _e2249 = select(_e2089, 262146i, (262146i < _e2089));
let _e2255 = global_3.member[bitcast<u32>(select(0i, _e2249, (_e2249 > 0i)))];
let _e2256 = bitcast<f32>(_e2255);
let _e2257 = (f32((bitcast<i32>((_e2239 & 4095u)) - 2048i)) * _e2256);
let _e2259 = select(_e2089, 262144i, (262144i < _e2089));
let _e2265 = global_3.member[bitcast<u32>(select(0i, _e2259, (_e2259 > 0i)))];
let _e2266 = bitcast<f32>(_e2265);
let _e2268 = select(_e2089, 262145i, (262145i < _e2089));
let _e2274 = global_3.member[bitcast<u32>(select(0i, _e2268, (_e2268 > 0i)))];
let _e2275 = bitcast<f32>(_e2274);
let _e2281 = ((_e2266 + (f32(bitcast<i32>((_e2239 >> bitcast<u32>(12u)))) * _e2275)) + (_e2257 * (_e2215 - f32(_e2230))));
let _e2284 = global_3.member[_e2102];
let _e2286 = local_26;
let _e2289 = local_26;
let _e2292 = local_26;
let _e2296 = select(_e2089, 263209i, (263209i < _e2089));
let _e2302 = global_3.member[bitcast<u32>(select(0i, _e2296, (_e2296 > 0i)))];
let _e2304 = local_26;
let _e2307 = select(_e2089, 263210i, (263210i < _e2089));
let _e2313 = global_3.member[bitcast<u32>(select(0i, _e2307, (_e2307 > 0i)))];
let _e2315 = local_26;
let _e2319 = (_e2257 * select(0f, select(select(select(bitcast<f32>(_e2284), _e2136, (_e2286 >= _e2128)), _e2168, (_e2289 >= _e2160)), _e2199, (_e2292 >= _e2191)), ((_e2304 >= bitcast<f32>(_e2302)) && (_e2315 <= bitcast<f32>(_e2313)))));
if _e1281 {
let _e2326 = ((0.5f * (_e2061 - _e2055)) * _e2319);
let _e2327 = ((0.5f * (_e2073 - _e2067)) * _e2319);
let _e2328 = ((0.5f * (_e2085 - _e2079)) * _e2319);
phi_7182_ = type_34(_e2281, vec3<f32>(_e2326, _e2327, _e2328), vec3<f32>((_e2326 * _e2281), (_e2327 * _e2281), (_e2328 * _e2281)));
} else {
local_24 = _e2055;
let _e2335 = local_24;
local_25 = _e2335;
let _e2336 = local_25;
let _e2338 = ((_e2336 - _e2097) * _e2105);
let _e2340 = select(0f, _e2338, (_e2338 > 0f));
let _e2343 = local_25;
let _e2345 = ((_e2343 - _e2128) * _e2136);
let _e2347 = select(0f, _e2345, (_e2345 > 0f));
let _e2351 = local_25;
let _e2353 = ((_e2351 - _e2160) * _e2168);
let _e2355 = select(0f, _e2353, (_e2353 > 0f));
let _e2358 = local_25;
let _e2360 = ((_e2358 - _e2191) * _e2199);
let _e2362 = select(0f, _e2360, (_e2360 > 0f));
let _e2366 = ((select(_e2113, _e2340, (_e2340 < _e2113)) + select(_e2144, _e2347, (_e2347 < _e2144))) + (select(_e2176, _e2355, (_e2355 < _e2176)) + select(_e2207, _e2362, (_e2362 < _e2207))));
let _e2368 = select(0f, _e2366, (_e2366 > 0f));
let _e2370 = select(1023f, _e2368, (_e2368 < 1023f));
let _e2377 = select(0i, select(select(i32(_e2370), i32(-2147483648), (_e2370 < -2147483600f)), 2147483647i, (_e2370 > 2147483500f)), (_e2370 == _e2370));
let _e2381 = (_e2377 - select(0i, 1i, (_e2370 < f32(_e2377))));
let _e2382 = (262147i + _e2381);
let _e2384 = select(_e2089, _e2382, (_e2382 < _e2089));
let _e2390 = global_3.member[bitcast<u32>(select(0i, _e2384, (_e2384 > 0i)))];
let _e2405 = ((_e2266 + (f32(bitcast<i32>((_e2390 >> bitcast<u32>(12u)))) * _e2275)) + ((f32((bitcast<i32>((_e2390 & 4095u)) - 2048i)) * _e2256) * (_e2366 - f32(_e2381))));
local_22 = _e2061;
let _e2406 = local_22;
local_23 = _e2406;
let _e2407 = local_23;
let _e2409 = ((_e2407 - _e2097) * _e2105);
let _e2411 = select(0f, _e2409, (_e2409 > 0f));
let _e2414 = local_23;
let _e2416 = ((_e2414 - _e2128) * _e2136);
let _e2418 = select(0f, _e2416, (_e2416 > 0f));
let _e2422 = local_23;
let _e2424 = ((_e2422 - _e2160) * _e2168);
let _e2426 = select(0f, _e2424, (_e2424 > 0f));
let _e2429 = local_23;
let _e2431 = ((_e2429 - _e2191) * _e2199);
let _e2433 = select(0f, _e2431, (_e2431 > 0f));
let _e2437 = ((select(_e2113, _e2411, (_e2411 < _e2113)) + select(_e2144, _e2418, (_e2418 < _e2144))) + (select(_e2176, _e2426, (_e2426 < _e2176)) + select(_e2207, _e2433, (_e2433 < _e2207))));
let _e2439 = select(0f, _e2437, (_e2437 > 0f));
let _e2441 = select(1023f, _e2439, (_e2439 < 1023f));
let _e2448 = select(0i, select(select(i32(_e2441), i32(-2147483648), (_e2441 < -2147483600f)), 2147483647i, (_e2441 > 2147483500f)), (_e2441 == _e2441));
let _e2452 = (_e2448 - select(0i, 1i, (_e2441 < f32(_e2448))));
let _e2453 = (262147i + _e2452);
let _e2455 = select(_e2089, _e2453, (_e2453 < _e2089));
let _e2461 = global_3.member[bitcast<u32>(select(0i, _e2455, (_e2455 > 0i)))];
let _e2476 = ((_e2266 + (f32(bitcast<i32>((_e2461 >> bitcast<u32>(12u)))) * _e2275)) + ((f32((bitcast<i32>((_e2461 & 4095u)) - 2048i)) * _e2256) * (_e2437 - f32(_e2452))));
local_20 = _e2067;
let _e2477 = local_20;
local_21 = _e2477;
let _e2478 = local_21;
let _e2480 = ((_e2478 - _e2097) * _e2105);
let _e2482 = select(0f, _e2480, (_e2480 > 0f));
let _e2485 = local_21;
let _e2487 = ((_e2485 - _e2128) * _e2136);
let _e2489 = select(0f, _e2487, (_e2487 > 0f));
let _e2493 = local_21;
let _e2495 = ((_e2493 - _e2160) * _e2168);
let _e2497 = select(0f, _e2495, (_e2495 > 0f));
let _e2500 = local_21;
let _e2502 = ((_e2500 - _e2191) * _e2199);
let _e2504 = select(0f, _e2502, (_e2502 > 0f));
let _e2508 = ((select(_e2113, _e2482, (_e2482 < _e2113)) + select(_e2144, _e2489, (_e2489 < _e2144))) + (select(_e2176, _e2497, (_e2497 < _e2176)) + select(_e2207, _e2504, (_e2504 < _e2207))));
let _e2510 = select(0f, _e2508, (_e2508 > 0f));
let _e2512 = select(1023f, _e2510, (_e2510 < 1023f));
let _e2519 = select(0i, select(select(i32(_e2512), i32(-2147483648), (_e2512 < -2147483600f)), 2147483647i, (_e2512 > 2147483500f)), (_e2512 == _e2512));
let _e2523 = (_e2519 - select(0i, 1i, (_e2512 < f32(_e2519))));
let _e2524 = (262147i + _e2523);
let _e2526 = select(_e2089, _e2524, (_e2524 < _e2089));
let _e2532 = global_3.member[bitcast<u32>(select(0i, _e2526, (_e2526 > 0i)))];
let _e2547 = ((_e2266 + (f32(bitcast<i32>((_e2532 >> bitcast<u32>(12u)))) * _e2275)) + ((f32((bitcast<i32>((_e2532 & 4095u)) - 2048i)) * _e2256) * (_e2508 - f32(_e2523))));
local_18 = _e2073;
let _e2548 = local_18;
local_19 = _e2548;
let _e2549 = local_19;
let _e2551 = ((_e2549 - _e2097) * _e2105);
let _e2553 = select(0f, _e2551, (_e2551 > 0f));
let _e2556 = local_19;
let _e2558 = ((_e2556 - _e2128) * _e2136);
let _e2560 = select(0f, _e2558, (_e2558 > 0f));
let _e2564 = local_19;
let _e2566 = ((_e2564 - _e2160) * _e2168);
let _e2568 = select(0f, _e2566, (_e2566 > 0f));
let _e2571 = local_19;
let _e2573 = ((_e2571 - _e2191) * _e2199);
let _e2575 = select(0f, _e2573, (_e2573 > 0f));
let _e2579 = ((select(_e2113, _e2553, (_e2553 < _e2113)) + select(_e2144, _e2560, (_e2560 < _e2144))) + (select(_e2176, _e2568, (_e2568 < _e2176)) + select(_e2207, _e2575, (_e2575 < _e2207))));
let _e2581 = select(0f, _e2579, (_e2579 > 0f));
let _e2583 = select(1023f, _e2581, (_e2581 < 1023f));
let _e2590 = select(0i, select(select(i32(_e2583), i32(-2147483648), (_e2583 < -2147483600f)), 2147483647i, (_e2583 > 2147483500f)), (_e2583 == _e2583));
let _e2594 = (_e2590 - select(0i, 1i, (_e2583 < f32(_e2590))));
let _e2595 = (262147i + _e2594);
let _e2597 = select(_e2089, _e2595, (_e2595 < _e2089));
let _e2603 = global_3.member[bitcast<u32>(select(0i, _e2597, (_e2597 > 0i)))];
let _e2618 = ((_e2266 + (f32(bitcast<i32>((_e2603 >> bitcast<u32>(12u)))) * _e2275)) + ((f32((bitcast<i32>((_e2603 & 4095u)) - 2048i)) * _e2256) * (_e2579 - f32(_e2594))));
local_16 = _e2079;
let _e2619 = local_16;
local_17 = _e2619;
let _e2620 = local_17;
let _e2622 = ((_e2620 - _e2097) * _e2105);
let _e2624 = select(0f, _e2622, (_e2622 > 0f));
let _e2627 = local_17;
let _e2629 = ((_e2627 - _e2128) * _e2136);
let _e2631 = select(0f, _e2629, (_e2629 > 0f));
let _e2635 = local_17;
let _e2637 = ((_e2635 - _e2160) * _e2168);
let _e2639 = select(0f, _e2637, (_e2637 > 0f));
let _e2642 = local_17;
let _e2644 = ((_e2642 - _e2191) * _e2199);
let _e2646 = select(0f, _e2644, (_e2644 > 0f));
let _e2650 = ((select(_e2113, _e2624, (_e2624 < _e2113)) + select(_e2144, _e2631, (_e2631 < _e2144))) + (select(_e2176, _e2639, (_e2639 < _e2176)) + select(_e2207, _e2646, (_e2646 < _e2207))));
let _e2652 = select(0f, _e2650, (_e2650 > 0f));
let _e2654 = select(1023f, _e2652, (_e2652 < 1023f));
let _e2661 = select(0i, select(select(i32(_e2654), i32(-2147483648), (_e2654 < -2147483600f)), 2147483647i, (_e2654 > 2147483500f)), (_e2654 == _e2654));
let _e2665 = (_e2661 - select(0i, 1i, (_e2654 < f32(_e2661))));
let _e2666 = (262147i + _e2665);
let _e2668 = select(_e2089, _e2666, (_e2666 < _e2089));
let _e2674 = global_3.member[bitcast<u32>(select(0i, _e2668, (_e2668 > 0i)))];
let _e2689 = ((_e2266 + (f32(bitcast<i32>((_e2674 >> bitcast<u32>(12u)))) * _e2275)) + ((f32((bitcast<i32>((_e2674 & 4095u)) - 2048i)) * _e2256) * (_e2650 - f32(_e2665))));
local_14 = _e2085;
let _e2690 = local_14;
local_15 = _e2690;
let _e2691 = local_15;
let _e2693 = ((_e2691 - _e2097) * _e2105);
let _e2695 = select(0f, _e2693, (_e2693 > 0f));
let _e2698 = local_15;
let _e2700 = ((_e2698 - _e2128) * _e2136);
let _e2702 = select(0f, _e2700, (_e2700 > 0f));
let _e2706 = local_15;
let _e2708 = ((_e2706 - _e2160) * _e2168);
let _e2710 = select(0f, _e2708, (_e2708 > 0f));
let _e2713 = local_15;
let _e2715 = ((_e2713 - _e2191) * _e2199);
let _e2717 = select(0f, _e2715, (_e2715 > 0f));
let _e2721 = ((select(_e2113, _e2695, (_e2695 < _e2113)) + select(_e2144, _e2702, (_e2702 < _e2144))) + (select(_e2176, _e2710, (_e2710 < _e2176)) + select(_e2207, _e2717, (_e2717 < _e2207))));
let _e2723 = select(0f, _e2721, (_e2721 > 0f));
let _e2725 = select(1023f, _e2723, (_e2723 < 1023f));
let _e2732 = select(0i, select(select(i32(_e2725), i32(-2147483648), (_e2725 < -2147483600f)), 2147483647i, (_e2725 > 2147483500f)), (_e2725 == _e2725));
let _e2736 = (_e2732 - select(0i, 1i, (_e2725 < f32(_e2732))));
let _e2737 = (262147i + _e2736);
let _e2739 = select(_e2089, _e2737, (_e2737 < _e2089));
let _e2745 = global_3.member[bitcast<u32>(select(0i, _e2739, (_e2739 > 0i)))];
let _e2760 = ((_e2266 + (f32(bitcast<i32>((_e2745 >> bitcast<u32>(12u)))) * _e2275)) + ((f32((bitcast<i32>((_e2745 & 4095u)) - 2048i)) * _e2256) * (_e2721 - f32(_e2736))));
let _e2761 = (_e2476 - _e2405);
let _e2763 = (_e2618 - _e2547);
let _e2765 = (_e2760 - _e2689);
phi_7182_ = type_34(_e2281, vec3<f32>((0.5f * _e2761), (0.5f * _e2763), (0.5f * _e2765)), vec3<f32>((0.25f * (_e2761 * (_e2476 + _e2405))), (0.25f * (_e2763 * (_e2618 + _e2547))), (0.25f * (_e2765 * (_e2760 + _e2689)))));
}
let _e2780 = phi_7182_;
let _e2795 = select(0f, 1f, ((((((_e1261 >= _e1287) && (_e1261 <= _e1292)) && (_e1267 >= _e1301)) && (_e1267 <= _e1306)) && (_e1273 >= _e1315)) && (_e1273 <= _e1320)));
let _e2797 = (0.5f * (_e2061 - _e2055));
let _e2799 = (0.5f * (_e2073 - _e2067));
let _e2801 = (0.5f * (_e2085 - _e2079));
let _e2807 = global_1.member.member_8.member.member.member;
let _e2813 = global_1.member.member_8.member.member.member_1;
let _e2819 = global_1.member.member_8.member.member.member_2;
let _e2825 = global_1.member.member_8.member_1.member.member;
let _e2831 = global_1.member.member_8.member_1.member.member_1;
let _e2837 = global_1.member.member_8.member_1.member.member_2;
let _e2843 = global_1.member.member_8.member_2.member.member;
let _e2849 = global_1.member.member_8.member_2.member.member_1;
let _e2855 = global_1.member.member_8.member_2.member.member_2;
let _e2860 = (((_e2807 * _e2797) + (_e2825 * _e2799)) + (_e2843 * _e2801));
let _e2865 = (((_e2813 * _e2797) + (_e2831 * _e2799)) + (_e2849 * _e2801));
let _e2870 = (((_e2819 * _e2797) + (_e2837 * _e2799)) + (_e2855 * _e2801));
phi_9222_ = type_35(_e2049, vec3<f32>((_e2860 * _e2795), (_e2865 * _e2795), (_e2870 * _e2795)), vec3<f32>(_e2860, _e2865, _e2870), _e2780.member, vec3<f32>(((((_e2807 * _e2780.member_2.x) + (_e2825 * _e2780.member_2.y)) + (_e2843 * _e2780.member_2.z)) * _e2795), ((((_e2813 * _e2780.member_2.x) + (_e2831 * _e2780.member_2.y)) + (_e2849 * _e2780.member_2.z)) * _e2795), ((((_e2819 * _e2780.member_2.x) + (_e2837 * _e2780.member_2.y)) + (_e2855 * _e2780.member_2.z)) * _e2795)), vec3<f32>(((((_e2807 * _e2780.member_1.x) + (_e2825 * _e2780.member_1.y)) + (_e2843 * _e2780.member_1.z)) * _e2795), ((((_e2813 * _e2780.member_1.x) + (_e2831 * _e2780.member_1.y)) + (_e2849 * _e2780.member_1.z)) * _e2795), ((((_e2819 * _e2780.member_1.x) + (_e2837 * _e2780.member_1.y)) + (_e2855 * _e2780.member_1.z)) * _e2795)));
} else {
if (_e189.member_2 == 8u) {
let _e2926 = global_1.member.member_8.member_4.member;
let _e2931 = global_1.member.member_8.member_5.member;
let _e2933 = select(_e2926, _e1261, (_e1261 > _e2926));
let _e2935 = select(_e2931, _e2933, (_e2933 < _e2931));
let _e2940 = global_1.member.member_8.member_4.member_1;
let _e2945 = global_1.member.member_8.member_5.member_1;
let _e2947 = select(_e2940, _e1267, (_e1267 > _e2940));
let _e2949 = select(_e2945, _e2947, (_e2947 < _e2945));
let _e2954 = global_1.member.member_8.member_4.member_2;
let _e2959 = global_1.member.member_8.member_5.member_2;
let _e2961 = select(_e2954, _e1273, (_e1273 > _e2954));
let _e2963 = select(_e2959, _e2961, (_e2961 < _e2959));
let _e2968 = global_1.member.member_8.member_15;
if (_e2968 == 0u) {
phi_7529_ = vec3<f32>(_e2935, _e2949, _e2963);
} else {
let _e2970 = (_e2935 + 0.5f);
let _e2975 = global_1.member.member_8.member_3.member;
let _e2976 = (_e2975 - 1f);
let _e2978 = select(0f, _e2970, (_e2970 > 0f));
let _e2980 = select(_e2976, _e2978, (_e2978 < _e2976));
let _e2987 = select(0i, select(select(i32(_e2980), i32(-2147483648), (_e2980 < -2147483600f)), 2147483647i, (_e2980 > 2147483500f)), (_e2980 == _e2980));
let _e2993 = (_e2949 + 0.5f);
let _e2998 = global_1.member.member_8.member_3.member_1;
let _e2999 = (_e2998 - 1f);
let _e3001 = select(0f, _e2993, (_e2993 > 0f));
let _e3003 = select(_e2999, _e3001, (_e3001 < _e2999));
let _e3010 = select(0i, select(select(i32(_e3003), i32(-2147483648), (_e3003 < -2147483600f)), 2147483647i, (_e3003 > 2147483500f)), (_e3003 == _e3003));
let _e3016 = (_e2963 + 0.5f);
let _e3021 = global_1.member.member_8.member_3.member_2;
let _e3022 = (_e3021 - 1f);
let _e3024 = select(0f, _e3016, (_e3016 > 0f));
let _e3026 = select(_e3022, _e3024, (_e3024 < _e3022));
let _e3033 = select(0i, select(select(i32(_e3026), i32(-2147483648), (_e3026 < -2147483600f)), 2147483647i, (_e3026 > 2147483500f)), (_e3026 == _e3026));
phi_7529_ = vec3<f32>(f32((_e2987 - select(0i, 1i, (_e2980 < f32(_e2987))))), f32((_e3010 - select(0i, 1i, (_e3003 < f32(_e3010))))), f32((_e3033 - select(0i, 1i, (_e3026 < f32(_e3033))))));
}
let _e3041 = phi_7529_;
let _e3047 = global_1.member.member_8.member_3.member;
let _e3049 = select(-1f, _e3041.x, (_e3041.x > -1f));
let _e3051 = select(_e3047, _e3049, (_e3049 < _e3047));
let _e3058 = select(0i, select(select(i32(_e3051), i32(-2147483648), (_e3051 < -2147483600f)), 2147483647i, (_e3051 > 2147483500f)), (_e3051 == _e3051));
let _e3062 = (_e3058 - select(0i, 1i, (_e3051 < f32(_e3058))));
let _e3068 = global_1.member.member_8.member_3.member_1;
let _e3070 = select(-1f, _e3041.y, (_e3041.y > -1f));
let _e3072 = select(_e3068, _e3070, (_e3070 < _e3068));
let _e3079 = select(0i, select(select(i32(_e3072), i32(-2147483648), (_e3072 < -2147483600f)), 2147483647i, (_e3072 > 2147483500f)), (_e3072 == _e3072));
let _e3083 = (_e3079 - select(0i, 1i, (_e3072 < f32(_e3079))));
let _e3089 = global_1.member.member_8.member_3.member_2;
let _e3091 = select(-1f, _e3041.z, (_e3041.z > -1f));
let _e3093 = select(_e3089, _e3091, (_e3091 < _e3089));
let _e3100 = select(0i, select(select(i32(_e3093), i32(-2147483648), (_e3093 < -2147483600f)), 2147483647i, (_e3093 > 2147483500f)), (_e3093 == _e3093));
let _e3104 = (_e3100 - select(0i, 1i, (_e3093 < f32(_e3100))));
let _e3108 = global_1.member.member_8.member_9;
let _e3112 = global_1.member.member_8.member_10;
let _e3113 = (_e3062 + 1i);
let _e3114 = (_e3083 + 1i);
let _e3115 = (_e3104 + 1i);
let _e3120 = global_1.member.member_8.member_13.member;
let _e3126 = global_1.member.member_8.member_13.member_1;
let _e3137 = ((_e3113 >> bitcast<u32>(4i)) + (bitcast<i32>(_e3120) * ((_e3114 >> bitcast<u32>(4i)) + (bitcast<i32>(_e3126) * (_e3115 >> bitcast<u32>(4i))))));
let _e3139 = (bitcast<i32>(_e174) - 1i);
let _e3141 = select(_e3139, _e3137, (_e3137 < _e3139));
let _e3147 = global_2.member[bitcast<u32>(select(0i, _e3141, (_e3141 > 0i)))];
let _e3149 = (_e3113 & 15i);
let _e3152 = ((_e3114 & 15i) * _e3108);
let _e3154 = (bitcast<i32>(_e3147) + ((_e3115 & 15i) * _e3112));
let _e3158 = (_e3152 + _e3108);
let _e3160 = (_e3152 + (2i * _e3108));
let _e3162 = (_e3152 + (3i * _e3108));
let _e3163 = (_e3154 + _e3112);
let _e3165 = (_e3154 + (2i * _e3112));
let _e3167 = (_e3154 + (3i * _e3112));
local_12 = type_30(array<i32, 4>(_e3149, (_e3149 + 1i), (_e3149 + 2i), (_e3149 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_13 = (_e3041 - vec3<f32>(f32(_e3062), f32(_e3083), f32(_e3104)));
let _e3176 = (_e3163 + _e3158);
let _e3179 = local_12.member[0u];
let _e3180 = (_e3176 + _e3179);
let _e3182 = select(_e3139, _e3180, (_e3180 < _e3139));
let _e3187 = global_2.member[bitcast<u32>(select(0i, _e3182, (_e3182 > 0i)))];
let _e3188 = bitcast<f32>(_e3187);
let _e3191 = local_12.member[1u];
let _e3192 = (_e3176 + _e3191);
let _e3194 = select(_e3139, _e3192, (_e3192 < _e3139));
let _e3199 = global_2.member[bitcast<u32>(select(0i, _e3194, (_e3194 > 0i)))];
let _e3200 = bitcast<f32>(_e3199);
let _e3203 = local_12.member[2u];
let _e3204 = (_e3176 + _e3203);
let _e3206 = select(_e3139, _e3204, (_e3204 < _e3139));
let _e3211 = global_2.member[bitcast<u32>(select(0i, _e3206, (_e3206 > 0i)))];
let _e3212 = bitcast<f32>(_e3211);
let _e3215 = local_12.member[3u];
let _e3216 = (_e3176 + _e3215);
let _e3218 = select(_e3139, _e3216, (_e3216 < _e3139));
let _e3223 = global_2.member[bitcast<u32>(select(0i, _e3218, (_e3218 > 0i)))];
let _e3225 = local_13[0u];
let _e3228 = (_e3188 + ((_e3200 - _e3188) * _e3225));
let _e3229 = local_13[0u];
let _e3232 = (_e3200 + ((_e3212 - _e3200) * _e3229));
let _e3233 = local_13[0u];
let _e3236 = (_e3212 + ((bitcast<f32>(_e3223) - _e3212) * _e3233));
let _e3237 = (_e3163 + _e3160);
let _e3238 = local_12.member[0u];
let _e3239 = (_e3237 + _e3238);
let _e3241 = select(_e3139, _e3239, (_e3239 < _e3139));
let _e3246 = global_2.member[bitcast<u32>(select(0i, _e3241, (_e3241 > 0i)))];
let _e3247 = bitcast<f32>(_e3246);
let _e3248 = local_12.member[1u];
let _e3249 = (_e3237 + _e3248);
let _e3251 = select(_e3139, _e3249, (_e3249 < _e3139));
let _e3256 = global_2.member[bitcast<u32>(select(0i, _e3251, (_e3251 > 0i)))];
let _e3257 = bitcast<f32>(_e3256);
let _e3258 = local_12.member[2u];
let _e3259 = (_e3237 + _e3258);
let _e3261 = select(_e3139, _e3259, (_e3259 < _e3139));
let _e3266 = global_2.member[bitcast<u32>(select(0i, _e3261, (_e3261 > 0i)))];
let _e3267 = bitcast<f32>(_e3266);
let _e3268 = local_12.member[3u];
let _e3269 = (_e3237 + _e3268);
let _e3271 = select(_e3139, _e3269, (_e3269 < _e3139));
let _e3276 = global_2.member[bitcast<u32>(select(0i, _e3271, (_e3271 > 0i)))];
let _e3278 = local_13[0u];
let _e3282 = local_13[0u];
let _e3285 = (_e3257 + ((_e3267 - _e3257) * _e3282));
let _e3286 = local_13[0u];
let _e3290 = (_e3165 + _e3158);
let _e3291 = local_12.member[0u];
let _e3292 = (_e3290 + _e3291);
let _e3294 = select(_e3139, _e3292, (_e3292 < _e3139));
let _e3299 = global_2.member[bitcast<u32>(select(0i, _e3294, (_e3294 > 0i)))];
let _e3300 = bitcast<f32>(_e3299);
let _e3301 = local_12.member[1u];
let _e3302 = (_e3290 + _e3301);
let _e3304 = select(_e3139, _e3302, (_e3302 < _e3139));
let _e3309 = global_2.member[bitcast<u32>(select(0i, _e3304, (_e3304 > 0i)))];
let _e3310 = bitcast<f32>(_e3309);
let _e3311 = local_12.member[2u];
let _e3312 = (_e3290 + _e3311);
let _e3314 = select(_e3139, _e3312, (_e3312 < _e3139));
let _e3319 = global_2.member[bitcast<u32>(select(0i, _e3314, (_e3314 > 0i)))];
let _e3320 = bitcast<f32>(_e3319);
let _e3321 = local_12.member[3u];
let _e3322 = (_e3290 + _e3321);
let _e3324 = select(_e3139, _e3322, (_e3322 < _e3139));
let _e3329 = global_2.member[bitcast<u32>(select(0i, _e3324, (_e3324 > 0i)))];
let _e3331 = local_13[0u];
let _e3334 = (_e3300 + ((_e3310 - _e3300) * _e3331));
let _e3335 = local_13[0u];
let _e3338 = (_e3310 + ((_e3320 - _e3310) * _e3335));
let _e3339 = local_13[0u];
let _e3342 = (_e3320 + ((bitcast<f32>(_e3329) - _e3320) * _e3339));
let _e3343 = (_e3165 + _e3160);
let _e3344 = local_12.member[0u];
let _e3345 = (_e3343 + _e3344);
let _e3347 = select(_e3139, _e3345, (_e3345 < _e3139));
let _e3352 = global_2.member[bitcast<u32>(select(0i, _e3347, (_e3347 > 0i)))];
let _e3353 = bitcast<f32>(_e3352);
let _e3354 = local_12.member[1u];
let _e3355 = (_e3343 + _e3354);
let _e3357 = select(_e3139, _e3355, (_e3355 < _e3139));
let _e3362 = global_2.member[bitcast<u32>(select(0i, _e3357, (_e3357 > 0i)))];
let _e3363 = bitcast<f32>(_e3362);
let _e3364 = local_12.member[2u];
let _e3365 = (_e3343 + _e3364);
let _e3367 = select(_e3139, _e3365, (_e3365 < _e3139));
let _e3372 = global_2.member[bitcast<u32>(select(0i, _e3367, (_e3367 > 0i)))];
let _e3373 = bitcast<f32>(_e3372);
let _e3374 = local_12.member[3u];
let _e3375 = (_e3343 + _e3374);
let _e3377 = select(_e3139, _e3375, (_e3375 < _e3139));
let _e3382 = global_2.member[bitcast<u32>(select(0i, _e3377, (_e3377 > 0i)))];
let _e3384 = local_13[0u];
let _e3388 = local_13[0u];
let _e3391 = (_e3363 + ((_e3373 - _e3363) * _e3388));
let _e3392 = local_13[0u];
let _e3396 = (_e3163 + _e3152);
let _e3397 = local_12.member[1u];
let _e3398 = (_e3396 + _e3397);
let _e3400 = select(_e3139, _e3398, (_e3398 < _e3139));
let _e3405 = global_2.member[bitcast<u32>(select(0i, _e3400, (_e3400 > 0i)))];
let _e3406 = bitcast<f32>(_e3405);
let _e3407 = local_12.member[2u];
let _e3408 = (_e3396 + _e3407);
let _e3410 = select(_e3139, _e3408, (_e3408 < _e3139));
let _e3415 = global_2.member[bitcast<u32>(select(0i, _e3410, (_e3410 > 0i)))];
let _e3417 = local_13[0u];
let _e3420 = (_e3406 + ((bitcast<f32>(_e3415) - _e3406) * _e3417));
let _e3421 = (_e3163 + _e3162);
let _e3422 = local_12.member[1u];
let _e3423 = (_e3421 + _e3422);
let _e3425 = select(_e3139, _e3423, (_e3423 < _e3139));
let _e3430 = global_2.member[bitcast<u32>(select(0i, _e3425, (_e3425 > 0i)))];
let _e3431 = bitcast<f32>(_e3430);
let _e3432 = local_12.member[2u];
let _e3433 = (_e3421 + _e3432);
let _e3435 = select(_e3139, _e3433, (_e3433 < _e3139));
let _e3440 = global_2.member[bitcast<u32>(select(0i, _e3435, (_e3435 > 0i)))];
let _e3442 = local_13[0u];
let _e3446 = (_e3165 + _e3152);
let _e3447 = local_12.member[1u];
let _e3448 = (_e3446 + _e3447);
let _e3450 = select(_e3139, _e3448, (_e3448 < _e3139));
let _e3455 = global_2.member[bitcast<u32>(select(0i, _e3450, (_e3450 > 0i)))];
let _e3456 = bitcast<f32>(_e3455);
let _e3457 = local_12.member[2u];
let _e3458 = (_e3446 + _e3457);
let _e3460 = select(_e3139, _e3458, (_e3458 < _e3139));
let _e3465 = global_2.member[bitcast<u32>(select(0i, _e3460, (_e3460 > 0i)))];
let _e3467 = local_13[0u];
let _e3470 = (_e3456 + ((bitcast<f32>(_e3465) - _e3456) * _e3467));
let _e3471 = (_e3165 + _e3162);
let _e3472 = local_12.member[1u];
let _e3473 = (_e3471 + _e3472);
let _e3475 = select(_e3139, _e3473, (_e3473 < _e3139));
let _e3480 = global_2.member[bitcast<u32>(select(0i, _e3475, (_e3475 > 0i)))];
let _e3481 = bitcast<f32>(_e3480);
let _e3482 = local_12.member[2u];
let _e3483 = (_e3471 + _e3482);
let _e3485 = select(_e3139, _e3483, (_e3483 < _e3139));
let _e3490 = global_2.member[bitcast<u32>(select(0i, _e3485, (_e3485 > 0i)))];
let _e3492 = local_13[0u];
let _e3496 = (_e3154 + _e3158);
let _e3497 = local_12.member[1u];
let _e3498 = (_e3496 + _e3497);
let _e3500 = select(_e3139, _e3498, (_e3498 < _e3139));
let _e3505 = global_2.member[bitcast<u32>(select(0i, _e3500, (_e3500 > 0i)))];
let _e3506 = bitcast<f32>(_e3505);
let _e3507 = local_12.member[2u];
let _e3508 = (_e3496 + _e3507);
let _e3510 = select(_e3139, _e3508, (_e3508 < _e3139));
let _e3515 = global_2.member[bitcast<u32>(select(0i, _e3510, (_e3510 > 0i)))];
let _e3517 = local_13[0u];
let _e3520 = (_e3506 + ((bitcast<f32>(_e3515) - _e3506) * _e3517));
let _e3521 = (_e3167 + _e3158);
let _e3522 = local_12.member[1u];
let _e3523 = (_e3521 + _e3522);
let _e3525 = select(_e3139, _e3523, (_e3523 < _e3139));
let _e3530 = global_2.member[bitcast<u32>(select(0i, _e3525, (_e3525 > 0i)))];
let _e3531 = bitcast<f32>(_e3530);
let _e3532 = local_12.member[2u];
let _e3533 = (_e3521 + _e3532);
let _e3535 = select(_e3139, _e3533, (_e3533 < _e3139));
let _e3540 = global_2.member[bitcast<u32>(select(0i, _e3535, (_e3535 > 0i)))];
let _e3542 = local_13[0u];
let _e3545 = (_e3531 + ((bitcast<f32>(_e3540) - _e3531) * _e3542));
let _e3546 = (_e3154 + _e3160);
let _e3547 = local_12.member[1u];
let _e3548 = (_e3546 + _e3547);
let _e3550 = select(_e3139, _e3548, (_e3548 < _e3139));
let _e3555 = global_2.member[bitcast<u32>(select(0i, _e3550, (_e3550 > 0i)))];
let _e3556 = bitcast<f32>(_e3555);
let _e3557 = local_12.member[2u];
let _e3558 = (_e3546 + _e3557);
let _e3560 = select(_e3139, _e3558, (_e3558 < _e3139));
let _e3565 = global_2.member[bitcast<u32>(select(0i, _e3560, (_e3560 > 0i)))];
let _e3567 = local_13[0u];
let _e3571 = (_e3167 + _e3160);
let _e3572 = local_12.member[1u];
let _e3573 = (_e3571 + _e3572);
let _e3575 = select(_e3139, _e3573, (_e3573 < _e3139));
let _e3580 = global_2.member[bitcast<u32>(select(0i, _e3575, (_e3575 > 0i)))];
let _e3581 = bitcast<f32>(_e3580);
let _e3582 = local_12.member[2u];
let _e3583 = (_e3571 + _e3582);
let _e3585 = select(_e3139, _e3583, (_e3583 < _e3139));
let _e3590 = global_2.member[bitcast<u32>(select(0i, _e3585, (_e3585 > 0i)))];
let _e3592 = local_13[0u];
let _e3597 = local_13[1u];
let _e3600 = (_e3232 + ((_e3285 - _e3232) * _e3597));
let _e3601 = local_13[1u];
let _e3604 = (_e3338 + ((_e3391 - _e3338) * _e3601));
let _e3605 = local_13[1u];
let _e3608 = (_e3228 + (((_e3247 + ((_e3257 - _e3247) * _e3278)) - _e3228) * _e3605));
let _e3609 = local_13[1u];
let _e3614 = local_13[2u];
let _e3618 = local_13[1u];
let _e3621 = (_e3236 + (((_e3267 + ((bitcast<f32>(_e3276) - _e3267) * _e3286)) - _e3236) * _e3618));
let _e3622 = local_13[1u];
let _e3626 = local_13[2u];
let _e3630 = local_13[1u];
let _e3633 = (_e3420 + ((_e3232 - _e3420) * _e3630));
let _e3634 = local_13[1u];
let _e3638 = local_13[2u];
let _e3642 = local_13[1u];
let _e3645 = (_e3285 + (((_e3431 + ((bitcast<f32>(_e3440) - _e3431) * _e3442)) - _e3285) * _e3642));
let _e3646 = local_13[1u];
let _e3650 = local_13[2u];
let _e3654 = local_13[1u];
let _e3657 = (_e3520 + (((_e3556 + ((bitcast<f32>(_e3565) - _e3556) * _e3567)) - _e3520) * _e3654));
let _e3658 = local_13[2u];
let _e3662 = local_13[1u];
let _e3666 = local_13[2u];
let _e3670 = local_13[2u];
let _e3677 = global_1.member.member_8.member_8;
let _e3681 = global_1.member.member_8.member_7;
let _e3683 = (((_e3600 + ((_e3604 - _e3600) * _e3670)) - _e3677) * _e3681);
let _e3684 = -(1e9f);
let _e3686 = select(_e3684, _e3683, (_e3683 > _e3684));
let _e3690 = (((_e3608 + (((_e3334 + (((_e3353 + ((_e3363 - _e3353) * _e3384)) - _e3334) * _e3609)) - _e3608) * _e3614)) - _e3677) * _e3681);
let _e3692 = select(_e3684, _e3690, (_e3690 > _e3684));
let _e3696 = (((_e3621 + (((_e3342 + (((_e3373 + ((bitcast<f32>(_e3382) - _e3373) * _e3392)) - _e3342) * _e3622)) - _e3621) * _e3626)) - _e3677) * _e3681);
let _e3698 = select(_e3684, _e3696, (_e3696 > _e3684));
let _e3702 = (((_e3633 + (((_e3470 + ((_e3338 - _e3470) * _e3634)) - _e3633) * _e3638)) - _e3677) * _e3681);
let _e3704 = select(_e3684, _e3702, (_e3702 > _e3684));
let _e3708 = (((_e3645 + (((_e3391 + (((_e3481 + ((bitcast<f32>(_e3490) - _e3481) * _e3492)) - _e3391) * _e3646)) - _e3645) * _e3650)) - _e3677) * _e3681);
let _e3710 = select(_e3684, _e3708, (_e3708 > _e3684));
let _e3714 = (((_e3657 + ((_e3600 - _e3657) * _e3658)) - _e3677) * _e3681);
let _e3716 = select(_e3684, _e3714, (_e3714 > _e3684));
let _e3720 = (((_e3604 + (((_e3545 + (((_e3581 + ((bitcast<f32>(_e3590) - _e3581) * _e3592)) - _e3545) * _e3662)) - _e3604) * _e3666)) - _e3677) * _e3681);
let _e3722 = select(_e3684, _e3720, (_e3720 > _e3684));
let _e3726 = (0.5f * (select(1e9f, _e3698, (_e3698 < 1e9f)) - select(1e9f, _e3692, (_e3692 < 1e9f))));
let _e3728 = (0.5f * (select(1e9f, _e3710, (_e3710 < 1e9f)) - select(1e9f, _e3704, (_e3704 < 1e9f))));
let _e3730 = (0.5f * (select(1e9f, _e3722, (_e3722 < 1e9f)) - select(1e9f, _e3716, (_e3716 < 1e9f))));
let _e3736 = global_1.member.member_8.member.member.member;
let _e3742 = global_1.member.member_8.member.member.member_1;
let _e3748 = global_1.member.member_8.member.member.member_2;
let _e3754 = global_1.member.member_8.member_1.member.member;
let _e3760 = global_1.member.member_8.member_1.member.member_1;
let _e3766 = global_1.member.member_8.member_1.member.member_2;
let _e3772 = global_1.member.member_8.member_2.member.member;
let _e3778 = global_1.member.member_8.member_2.member.member_1;
let _e3784 = global_1.member.member_8.member_2.member.member_2;
phi_9219_ = select(1e9f, _e3686, (_e3686 < 1e9f));
phi_9220_ = vec3<f32>((((_e3736 * _e3726) + (_e3754 * _e3728)) + (_e3772 * _e3730)), (((_e3742 * _e3726) + (_e3760 * _e3728)) + (_e3778 * _e3730)), (((_e3748 * _e3726) + (_e3766 * _e3728)) + (_e3784 * _e3730)));
} else {
let _e3805 = global_1.member.member_8.member_4.member;
let _e3810 = global_1.member.member_8.member_5.member;
let _e3812 = select(_e3805, _e1261, (_e1261 > _e3805));
let _e3814 = select(_e3810, _e3812, (_e3812 < _e3810));
let _e3819 = global_1.member.member_8.member_4.member_1;
let _e3824 = global_1.member.member_8.member_5.member_1;
let _e3826 = select(_e3819, _e1267, (_e1267 > _e3819));
let _e3828 = select(_e3824, _e3826, (_e3826 < _e3824));
let _e3833 = global_1.member.member_8.member_4.member_2;
let _e3838 = global_1.member.member_8.member_5.member_2;
let _e3840 = select(_e3833, _e1273, (_e1273 > _e3833));
let _e3842 = select(_e3838, _e3840, (_e3840 < _e3838));
let _e3847 = global_1.member.member_8.member_15;
if (_e3847 == 0u) {
phi_8843_ = vec3<f32>(_e3814, _e3828, _e3842);
} else {
let _e3849 = (_e3814 + 0.5f);
let _e3854 = global_1.member.member_8.member_3.member;
let _e3855 = (_e3854 - 1f);
let _e3857 = select(0f, _e3849, (_e3849 > 0f));
let _e3859 = select(_e3855, _e3857, (_e3857 < _e3855));
let _e3866 = select(0i, select(select(i32(_e3859), i32(-2147483648), (_e3859 < -2147483600f)), 2147483647i, (_e3859 > 2147483500f)), (_e3859 == _e3859));
let _e3872 = (_e3828 + 0.5f);
let _e3877 = global_1.member.member_8.member_3.member_1;
let _e3878 = (_e3877 - 1f);
let _e3880 = select(0f, _e3872, (_e3872 > 0f));
let _e3882 = select(_e3878, _e3880, (_e3880 < _e3878));
let _e3889 = select(0i, select(select(i32(_e3882), i32(-2147483648), (_e3882 < -2147483600f)), 2147483647i, (_e3882 > 2147483500f)), (_e3882 == _e3882));
let _e3895 = (_e3842 + 0.5f);
let _e3900 = global_1.member.member_8.member_3.member_2;
let _e3901 = (_e3900 - 1f);
let _e3903 = select(0f, _e3895, (_e3895 > 0f));
let _e3905 = select(_e3901, _e3903, (_e3903 < _e3901));
let _e3912 = select(0i, select(select(i32(_e3905), i32(-2147483648), (_e3905 < -2147483600f)), 2147483647i, (_e3905 > 2147483500f)), (_e3905 == _e3905));
phi_8843_ = vec3<f32>(f32((_e3866 - select(0i, 1i, (_e3859 < f32(_e3866))))), f32((_e3889 - select(0i, 1i, (_e3882 < f32(_e3889))))), f32((_e3912 - select(0i, 1i, (_e3905 < f32(_e3912))))));
}
let _e3920 = phi_8843_;
let _e3926 = global_1.member.member_8.member_3.member;
let _e3928 = select(-1f, _e3920.x, (_e3920.x > -1f));
let _e3930 = select(_e3926, _e3928, (_e3928 < _e3926));
let _e3937 = select(0i, select(select(i32(_e3930), i32(-2147483648), (_e3930 < -2147483600f)), 2147483647i, (_e3930 > 2147483500f)), (_e3930 == _e3930));
let _e3941 = (_e3937 - select(0i, 1i, (_e3930 < f32(_e3937))));
let _e3947 = global_1.member.member_8.member_3.member_1;
let _e3949 = select(-1f, _e3920.y, (_e3920.y > -1f));
let _e3951 = select(_e3947, _e3949, (_e3949 < _e3947));
let _e3958 = select(0i, select(select(i32(_e3951), i32(-2147483648), (_e3951 < -2147483600f)), 2147483647i, (_e3951 > 2147483500f)), (_e3951 == _e3951));
let _e3962 = (_e3958 - select(0i, 1i, (_e3951 < f32(_e3958))));
let _e3968 = global_1.member.member_8.member_3.member_2;
let _e3970 = select(-1f, _e3920.z, (_e3920.z > -1f));
let _e3972 = select(_e3968, _e3970, (_e3970 < _e3968));
let _e3979 = select(0i, select(select(i32(_e3972), i32(-2147483648), (_e3972 < -2147483600f)), 2147483647i, (_e3972 > 2147483500f)), (_e3972 == _e3972));
let _e3983 = (_e3979 - select(0i, 1i, (_e3972 < f32(_e3979))));
let _e3987 = global_1.member.member_8.member_9;
let _e3991 = global_1.member.member_8.member_10;
let _e3992 = (_e3941 + 1i);
let _e3993 = (_e3962 + 1i);
let _e3994 = (_e3983 + 1i);
let _e3999 = global_1.member.member_8.member_13.member;
let _e4005 = global_1.member.member_8.member_13.member_1;
let _e4016 = ((_e3992 >> bitcast<u32>(4i)) + (bitcast<i32>(_e3999) * ((_e3993 >> bitcast<u32>(4i)) + (bitcast<i32>(_e4005) * (_e3994 >> bitcast<u32>(4i))))));
let _e4018 = (bitcast<i32>(_e174) - 1i);
let _e4020 = select(_e4018, _e4016, (_e4016 < _e4018));
let _e4026 = global_2.member[bitcast<u32>(select(0i, _e4020, (_e4020 > 0i)))];
let _e4028 = (_e3992 & 15i);
let _e4031 = ((_e3993 & 15i) * _e3987);
let _e4033 = (bitcast<i32>(_e4026) + ((_e3994 & 15i) * _e3991));
let _e4037 = (_e4031 + _e3987);
let _e4039 = (_e4031 + (2i * _e3987));
let _e4040 = (_e4033 + _e3991);
let _e4042 = (_e4033 + (2i * _e3991));
local_10 = type_30(array<i32, 4>(_e4028, (_e4028 + 1i), (_e4028 + 2i), (_e4028 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_11 = (_e3920 - vec3<f32>(f32(_e3941), f32(_e3962), f32(_e3983)));
let _e4051 = (_e4040 + _e4037);
let _e4054 = local_10.member[1u];
let _e4055 = (_e4051 + _e4054);
let _e4057 = select(_e4018, _e4055, (_e4055 < _e4018));
let _e4062 = global_2.member[bitcast<u32>(select(0i, _e4057, (_e4057 > 0i)))];
let _e4063 = bitcast<f32>(_e4062);
let _e4066 = local_10.member[2u];
let _e4067 = (_e4051 + _e4066);
let _e4069 = select(_e4018, _e4067, (_e4067 < _e4018));
let _e4074 = global_2.member[bitcast<u32>(select(0i, _e4069, (_e4069 > 0i)))];
let _e4076 = local_11[0u];
let _e4079 = (_e4063 + ((bitcast<f32>(_e4074) - _e4063) * _e4076));
let _e4080 = (_e4040 + _e4039);
let _e4081 = local_10.member[1u];
let _e4082 = (_e4080 + _e4081);
let _e4084 = select(_e4018, _e4082, (_e4082 < _e4018));
let _e4089 = global_2.member[bitcast<u32>(select(0i, _e4084, (_e4084 > 0i)))];
let _e4090 = bitcast<f32>(_e4089);
let _e4091 = local_10.member[2u];
let _e4092 = (_e4080 + _e4091);
let _e4094 = select(_e4018, _e4092, (_e4092 < _e4018));
let _e4099 = global_2.member[bitcast<u32>(select(0i, _e4094, (_e4094 > 0i)))];
let _e4101 = local_11[0u];
let _e4106 = local_11[1u];
let _e4109 = (_e4079 + (((_e4090 + ((bitcast<f32>(_e4099) - _e4090) * _e4101)) - _e4079) * _e4106));
let _e4110 = (_e4042 + _e4037);
let _e4111 = local_10.member[1u];
let _e4112 = (_e4110 + _e4111);
let _e4114 = select(_e4018, _e4112, (_e4112 < _e4018));
let _e4119 = global_2.member[bitcast<u32>(select(0i, _e4114, (_e4114 > 0i)))];
let _e4120 = bitcast<f32>(_e4119);
let _e4121 = local_10.member[2u];
let _e4122 = (_e4110 + _e4121);
let _e4124 = select(_e4018, _e4122, (_e4122 < _e4018));
let _e4129 = global_2.member[bitcast<u32>(select(0i, _e4124, (_e4124 > 0i)))];
let _e4131 = local_11[0u];
let _e4134 = (_e4120 + ((bitcast<f32>(_e4129) - _e4120) * _e4131));
let _e4135 = (_e4042 + _e4039);
let _e4136 = local_10.member[1u];
let _e4137 = (_e4135 + _e4136);
let _e4139 = select(_e4018, _e4137, (_e4137 < _e4018));
let _e4144 = global_2.member[bitcast<u32>(select(0i, _e4139, (_e4139 > 0i)))];
let _e4145 = bitcast<f32>(_e4144);
let _e4146 = local_10.member[2u];
let _e4147 = (_e4135 + _e4146);
let _e4149 = select(_e4018, _e4147, (_e4147 < _e4018));
let _e4154 = global_2.member[bitcast<u32>(select(0i, _e4149, (_e4149 > 0i)))];
let _e4156 = local_11[0u];
let _e4160 = local_11[1u];
let _e4165 = local_11[2u];
let _e4172 = global_1.member.member_8.member_8;
let _e4176 = global_1.member.member_8.member_7;
let _e4178 = (((_e4109 + (((_e4134 + (((_e4145 + ((bitcast<f32>(_e4154) - _e4145) * _e4156)) - _e4134) * _e4160)) - _e4109) * _e4165)) - _e4172) * _e4176);
let _e4179 = -(1e9f);
let _e4181 = select(_e4179, _e4178, (_e4178 > _e4179));
phi_9219_ = select(1e9f, _e4181, (_e4181 < 1e9f));
phi_9220_ = vec3<f32>(0f, 0f, 0f);
}
let _e4185 = phi_9219_;
let _e4187 = phi_9220_;
phi_9222_ = type_35(_e4185, vec3<f32>(0f, 0f, 0f), _e4187, 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e4190 = phi_9222_;
let _e4195 = global_1.member.member_8.member_4.member;
let _e4200 = global_1.member.member_8.member_5.member;
let _e4202 = select(_e4195, _e1225, (_e1225 > _e4195));
let _e4204 = select(_e4200, _e4202, (_e4202 < _e4200));
let _e4209 = global_1.member.member_8.member_4.member_1;
let _e4214 = global_1.member.member_8.member_5.member_1;
let _e4216 = select(_e4209, _e1240, (_e1240 > _e4209));
let _e4218 = select(_e4214, _e4216, (_e4216 < _e4214));
let _e4223 = global_1.member.member_8.member_4.member_2;
let _e4228 = global_1.member.member_8.member_5.member_2;
let _e4230 = select(_e4223, _e1255, (_e1255 > _e4223));
let _e4232 = select(_e4228, _e4230, (_e4230 < _e4228));
let _e4237 = global_1.member.member_8.member_15;
let _e4238 = (_e4237 == 0u);
if _e4238 {
phi_9368_ = vec3<f32>(_e4204, _e4218, _e4232);
} else {
let _e4239 = (_e4204 + 0.5f);
let _e4244 = global_1.member.member_8.member_3.member;
let _e4245 = (_e4244 - 1f);
let _e4247 = select(0f, _e4239, (_e4239 > 0f));
let _e4249 = select(_e4245, _e4247, (_e4247 < _e4245));
let _e4256 = select(0i, select(select(i32(_e4249), i32(-2147483648), (_e4249 < -2147483600f)), 2147483647i, (_e4249 > 2147483500f)), (_e4249 == _e4249));
let _e4262 = (_e4218 + 0.5f);
let _e4267 = global_1.member.member_8.member_3.member_1;
let _e4268 = (_e4267 - 1f);
let _e4270 = select(0f, _e4262, (_e4262 > 0f));
let _e4272 = select(_e4268, _e4270, (_e4270 < _e4268));
let _e4279 = select(0i, select(select(i32(_e4272), i32(-2147483648), (_e4272 < -2147483600f)), 2147483647i, (_e4272 > 2147483500f)), (_e4272 == _e4272));
let _e4285 = (_e4232 + 0.5f);
let _e4290 = global_1.member.member_8.member_3.member_2;
let _e4291 = (_e4290 - 1f);
let _e4293 = select(0f, _e4285, (_e4285 > 0f));
let _e4295 = select(_e4291, _e4293, (_e4293 < _e4291));
let _e4302 = select(0i, select(select(i32(_e4295), i32(-2147483648), (_e4295 < -2147483600f)), 2147483647i, (_e4295 > 2147483500f)), (_e4295 == _e4295));
phi_9368_ = vec3<f32>(f32((_e4256 - select(0i, 1i, (_e4249 < f32(_e4256))))), f32((_e4279 - select(0i, 1i, (_e4272 < f32(_e4279))))), f32((_e4302 - select(0i, 1i, (_e4295 < f32(_e4302))))));
}
let _e4310 = phi_9368_;
let _e4316 = global_1.member.member_8.member_3.member;
let _e4318 = select(-1f, _e4310.x, (_e4310.x > -1f));
let _e4320 = select(_e4316, _e4318, (_e4318 < _e4316));
let _e4327 = select(0i, select(select(i32(_e4320), i32(-2147483648), (_e4320 < -2147483600f)), 2147483647i, (_e4320 > 2147483500f)), (_e4320 == _e4320));
let _e4331 = (_e4327 - select(0i, 1i, (_e4320 < f32(_e4327))));
let _e4337 = global_1.member.member_8.member_3.member_1;
let _e4339 = select(-1f, _e4310.y, (_e4310.y > -1f));
let _e4341 = select(_e4337, _e4339, (_e4339 < _e4337));
let _e4348 = select(0i, select(select(i32(_e4341), i32(-2147483648), (_e4341 < -2147483600f)), 2147483647i, (_e4341 > 2147483500f)), (_e4341 == _e4341));
let _e4352 = (_e4348 - select(0i, 1i, (_e4341 < f32(_e4348))));
let _e4358 = global_1.member.member_8.member_3.member_2;
let _e4360 = select(-1f, _e4310.z, (_e4310.z > -1f));
let _e4362 = select(_e4358, _e4360, (_e4360 < _e4358));
let _e4369 = select(0i, select(select(i32(_e4362), i32(-2147483648), (_e4362 < -2147483600f)), 2147483647i, (_e4362 > 2147483500f)), (_e4362 == _e4362));
let _e4373 = (_e4369 - select(0i, 1i, (_e4362 < f32(_e4369))));
let _e4377 = global_1.member.member_8.member_9;
let _e4381 = global_1.member.member_8.member_10;
let _e4382 = (_e4331 + 1i);
let _e4383 = (_e4352 + 1i);
let _e4384 = (_e4373 + 1i);
let _e4389 = global_1.member.member_8.member_13.member;
let _e4390 = bitcast<i32>(_e4389);
let _e4395 = global_1.member.member_8.member_13.member_1;
let _e4396 = bitcast<i32>(_e4395);
let _e4406 = ((_e4382 >> bitcast<u32>(4i)) + (_e4390 * ((_e4383 >> bitcast<u32>(4i)) + (_e4396 * (_e4384 >> bitcast<u32>(4i))))));
let _e4408 = (bitcast<i32>(_e174) - 1i);
let _e4410 = select(_e4408, _e4406, (_e4406 < _e4408));
let _e4416 = global_2.member[bitcast<u32>(select(0i, _e4410, (_e4410 > 0i)))];
let _e4418 = (_e4382 & 15i);
let _e4421 = ((_e4383 & 15i) * _e4377);
let _e4423 = (bitcast<i32>(_e4416) + ((_e4384 & 15i) * _e4381));
let _e4427 = (_e4421 + _e4377);
let _e4428 = (2i * _e4377);
let _e4429 = (_e4421 + _e4428);
let _e4430 = (_e4423 + _e4381);
let _e4431 = (2i * _e4381);
let _e4432 = (_e4423 + _e4431);
local_8 = type_30(array<i32, 4>(_e4418, (_e4418 + 1i), (_e4418 + 2i), (_e4418 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_9 = (_e4310 - vec3<f32>(f32(_e4331), f32(_e4352), f32(_e4373)));
let _e4441 = (_e4430 + _e4427);
let _e4444 = local_8.member[1u];
let _e4445 = (_e4441 + _e4444);
let _e4447 = select(_e4408, _e4445, (_e4445 < _e4408));
let _e4452 = global_2.member[bitcast<u32>(select(0i, _e4447, (_e4447 > 0i)))];
let _e4453 = bitcast<f32>(_e4452);
let _e4456 = local_8.member[2u];
let _e4457 = (_e4441 + _e4456);
let _e4459 = select(_e4408, _e4457, (_e4457 < _e4408));
let _e4464 = global_2.member[bitcast<u32>(select(0i, _e4459, (_e4459 > 0i)))];
let _e4466 = local_9[0u];
let _e4469 = (_e4453 + ((bitcast<f32>(_e4464) - _e4453) * _e4466));
let _e4470 = (_e4430 + _e4429);
let _e4471 = local_8.member[1u];
let _e4472 = (_e4470 + _e4471);
let _e4474 = select(_e4408, _e4472, (_e4472 < _e4408));
let _e4479 = global_2.member[bitcast<u32>(select(0i, _e4474, (_e4474 > 0i)))];
let _e4480 = bitcast<f32>(_e4479);
let _e4481 = local_8.member[2u];
let _e4482 = (_e4470 + _e4481);
let _e4484 = select(_e4408, _e4482, (_e4482 < _e4408));
let _e4489 = global_2.member[bitcast<u32>(select(0i, _e4484, (_e4484 > 0i)))];
let _e4491 = local_9[0u];
let _e4496 = local_9[1u];
let _e4499 = (_e4469 + (((_e4480 + ((bitcast<f32>(_e4489) - _e4480) * _e4491)) - _e4469) * _e4496));
let _e4500 = (_e4432 + _e4427);
let _e4501 = local_8.member[1u];
let _e4502 = (_e4500 + _e4501);
let _e4504 = select(_e4408, _e4502, (_e4502 < _e4408));
let _e4509 = global_2.member[bitcast<u32>(select(0i, _e4504, (_e4504 > 0i)))];
let _e4510 = bitcast<f32>(_e4509);
let _e4511 = local_8.member[2u];
let _e4512 = (_e4500 + _e4511);
let _e4514 = select(_e4408, _e4512, (_e4512 < _e4408));
let _e4519 = global_2.member[bitcast<u32>(select(0i, _e4514, (_e4514 > 0i)))];
let _e4521 = local_9[0u];
let _e4524 = (_e4510 + ((bitcast<f32>(_e4519) - _e4510) * _e4521));
let _e4525 = (_e4432 + _e4429);
let _e4526 = local_8.member[1u];
let _e4527 = (_e4525 + _e4526);
let _e4529 = select(_e4408, _e4527, (_e4527 < _e4408));
let _e4534 = global_2.member[bitcast<u32>(select(0i, _e4529, (_e4529 > 0i)))];
let _e4535 = bitcast<f32>(_e4534);
let _e4536 = local_8.member[2u];
let _e4537 = (_e4525 + _e4536);
let _e4539 = select(_e4408, _e4537, (_e4537 < _e4408));
let _e4544 = global_2.member[bitcast<u32>(select(0i, _e4539, (_e4539 > 0i)))];
let _e4546 = local_9[0u];
let _e4550 = local_9[1u];
let _e4555 = local_9[2u];
let _e4562 = global_1.member.member_8.member_8;
let _e4566 = global_1.member.member_8.member_7;
let _e4568 = (((_e4499 + (((_e4524 + (((_e4535 + ((bitcast<f32>(_e4544) - _e4535) * _e4546)) - _e4524) * _e4550)) - _e4499) * _e4555)) - _e4562) * _e4566);
let _e4569 = -(1e9f);
let _e4571 = select(_e4569, _e4568, (_e4568 > _e4569));
let _e4576 = select(select(1e9f, _e4571, (_e4571 < 1e9f)), _e4190.member, (_e4237 != 0u));
let _e4579 = global_1.member.member_1;
let _e4581 = ((_e4579 & 16u) == 0u);
if _e4581 {
phi_10264_ = type_36(type_33(0f, 1f), type_33(0f, 1f), 1f);
} else {
let _e4585 = global_1.member.member_16.member;
let _e4596 = ((((_e4585.member.member * _e1182) + (_e4585.member.member_1 * _e1195)) + (_e4585.member.member_2 * _e1160)) + _e4585.member_1);
let _e4602 = ((((_e4585.member.member * _e1205) + (_e4585.member.member_1 * _e1210)) + (_e4585.member.member_2 * _e1199)) + _e4585.member_1);
let _e4609 = bitcast<f32>((bitcast<u32>((_e4596 - _e4602)) & 2147483647u));
let _e4612 = (bitcast<f32>((bitcast<u32>(_e4596) & 2147483647u)) / select(1e-30f, _e4609, (_e4609 > 1e-30f)));
let _e4614 = select(0f, _e4612, (_e4612 > 0f));
let _e4616 = select(1f, _e4614, (_e4614 < 1f));
let _e4617 = (_e4596 > 0f);
let _e4618 = (_e4602 > 0f);
let _e4620 = select(0f, select(_e4616, 1f, _e4618), _e4617);
let _e4622 = select(1f, select(_e4616, 1f, _e4617), _e4618);
let _e4626 = global_1.member.member_16.member_1;
let _e4627 = (_e4626 != 0u);
let _e4629 = select(_e4620, 0f, (0f > _e4620));
let _e4631 = select(_e4622, 1f, (1f < _e4622));
let _e4632 = select(0f, _e4620, _e4627);
let _e4633 = select(1f, _e4622, _e4627);
let _e4635 = select(_e4632, 0f, (0f > _e4632));
let _e4637 = select(_e4633, 1f, (1f < _e4633));
let _e4644 = global_1.member.member_17.member;
let _e4655 = ((((_e4644.member.member * _e1182) + (_e4644.member.member_1 * _e1195)) + (_e4644.member.member_2 * _e1160)) + _e4644.member_1);
let _e4661 = ((((_e4644.member.member * _e1205) + (_e4644.member.member_1 * _e1210)) + (_e4644.member.member_2 * _e1199)) + _e4644.member_1);
let _e4668 = bitcast<f32>((bitcast<u32>((_e4655 - _e4661)) & 2147483647u));
let _e4671 = (bitcast<f32>((bitcast<u32>(_e4655) & 2147483647u)) / select(1e-30f, _e4668, (_e4668 > 1e-30f)));
let _e4673 = select(0f, _e4671, (_e4671 > 0f));
let _e4675 = select(1f, _e4673, (_e4673 < 1f));
let _e4676 = (_e4655 > 0f);
let _e4677 = (_e4661 > 0f);
let _e4679 = select(0f, select(_e4675, 1f, _e4677), _e4676);
let _e4681 = select(1f, select(_e4675, 1f, _e4676), _e4677);
let _e4685 = global_1.member.member_17.member_1;
let _e4686 = (_e4685 != 0u);
let _e4688 = select(_e4679, _e4629, (_e4629 > _e4679));
let _e4690 = select(_e4681, _e4631, (_e4631 < _e4681));
let _e4691 = select(0f, _e4679, _e4686);
let _e4692 = select(1f, _e4681, _e4686);
let _e4694 = select(_e4691, _e4635, (_e4635 > _e4691));
let _e4696 = select(_e4692, _e4637, (_e4637 < _e4692));
let _e4703 = global_1.member.member_18.member;
let _e4714 = ((((_e4703.member.member * _e1182) + (_e4703.member.member_1 * _e1195)) + (_e4703.member.member_2 * _e1160)) + _e4703.member_1);
let _e4720 = ((((_e4703.member.member * _e1205) + (_e4703.member.member_1 * _e1210)) + (_e4703.member.member_2 * _e1199)) + _e4703.member_1);
let _e4727 = bitcast<f32>((bitcast<u32>((_e4714 - _e4720)) & 2147483647u));
let _e4730 = (bitcast<f32>((bitcast<u32>(_e4714) & 2147483647u)) / select(1e-30f, _e4727, (_e4727 > 1e-30f)));
let _e4732 = select(0f, _e4730, (_e4730 > 0f));
let _e4734 = select(1f, _e4732, (_e4732 < 1f));
let _e4735 = (_e4714 > 0f);
let _e4736 = (_e4720 > 0f);
let _e4738 = select(0f, select(_e4734, 1f, _e4736), _e4735);
let _e4740 = select(1f, select(_e4734, 1f, _e4735), _e4736);
let _e4744 = global_1.member.member_18.member_1;
let _e4745 = (_e4744 != 0u);
let _e4747 = select(_e4738, _e4688, (_e4688 > _e4738));
let _e4749 = select(_e4740, _e4690, (_e4690 < _e4740));
let _e4750 = select(0f, _e4738, _e4745);
let _e4751 = select(1f, _e4740, _e4745);
let _e4753 = select(_e4750, _e4694, (_e4694 > _e4750));
let _e4755 = select(_e4751, _e4696, (_e4696 < _e4751));
let _e4762 = global_1.member.member_19.member;
let _e4773 = ((((_e4762.member.member * _e1182) + (_e4762.member.member_1 * _e1195)) + (_e4762.member.member_2 * _e1160)) + _e4762.member_1);
let _e4779 = ((((_e4762.member.member * _e1205) + (_e4762.member.member_1 * _e1210)) + (_e4762.member.member_2 * _e1199)) + _e4762.member_1);
let _e4786 = bitcast<f32>((bitcast<u32>((_e4773 - _e4779)) & 2147483647u));
let _e4789 = (bitcast<f32>((bitcast<u32>(_e4773) & 2147483647u)) / select(1e-30f, _e4786, (_e4786 > 1e-30f)));
let _e4791 = select(0f, _e4789, (_e4789 > 0f));
let _e4793 = select(1f, _e4791, (_e4791 < 1f));
let _e4794 = (_e4773 > 0f);
let _e4795 = (_e4779 > 0f);
let _e4797 = select(0f, select(_e4793, 1f, _e4795), _e4794);
let _e4799 = select(1f, select(_e4793, 1f, _e4794), _e4795);
let _e4803 = global_1.member.member_19.member_1;
let _e4804 = (_e4803 != 0u);
let _e4809 = select(0f, _e4797, _e4804);
let _e4810 = select(1f, _e4799, _e4804);
phi_10264_ = type_36(type_33(select(_e4797, _e4747, (_e4747 > _e4797)), select(_e4799, _e4749, (_e4749 < _e4799))), type_33(select(_e4809, _e4753, (_e4753 > _e4809)), select(_e4810, _e4755, (_e4755 < _e4810))), ((((1f * select(1f, 0f, (_e4627 && _e4618))) * select(1f, 0f, (_e4686 && _e4677))) * select(1f, 0f, (_e4745 && _e4736))) * select(1f, 0f, (_e4804 && _e4795))));
}
let _e4822 = phi_10264_;
let _e4823 = (_e1261 - _e1225);
let _e4827 = (bitcast<f32>((bitcast<u32>(_e4823) & 2147483647u)) < 1e-12f);
let _e4829 = (1f / select(_e4823, 1f, _e4827));
let _e4830 = (_e4195 - _e1225);
let _e4831 = (_e4830 * _e4829);
let _e4833 = ((_e4200 - _e1225) * _e4829);
let _e4839 = select(_e4833, _e4831, (_e4831 < _e4833));
let _e4841 = select(0f, _e4839, (_e4839 > 0f));
let _e4844 = select(select(1f, _e4841, (_e4841 < 1f)), select(2f, 0f, ((_e1225 >= _e4195) && (_e1225 <= _e4200))), _e4827);
let _e4846 = select(_e4833, _e4831, (_e4831 > _e4833));
let _e4848 = select(0f, _e4846, (_e4846 > 0f));
let _e4851 = select(select(1f, _e4848, (_e4848 < 1f)), 1f, _e4827);
let _e4852 = (_e1267 - _e1240);
let _e4856 = (bitcast<f32>((bitcast<u32>(_e4852) & 2147483647u)) < 1e-12f);
let _e4858 = (1f / select(_e4852, 1f, _e4856));
let _e4859 = (_e4209 - _e1240);
let _e4860 = (_e4859 * _e4858);
let _e4862 = ((_e4214 - _e1240) * _e4858);
let _e4868 = select(_e4862, _e4860, (_e4860 < _e4862));
let _e4870 = select(0f, _e4868, (_e4868 > 0f));
let _e4873 = select(select(1f, _e4870, (_e4870 < 1f)), select(2f, 0f, ((_e1240 >= _e4209) && (_e1240 <= _e4214))), _e4856);
let _e4875 = select(_e4862, _e4860, (_e4860 > _e4862));
let _e4877 = select(0f, _e4875, (_e4875 > 0f));
let _e4880 = select(select(1f, _e4877, (_e4877 < 1f)), 1f, _e4856);
let _e4881 = (_e1273 - _e1255);
let _e4885 = (bitcast<f32>((bitcast<u32>(_e4881) & 2147483647u)) < 1e-12f);
let _e4887 = (1f / select(_e4881, 1f, _e4885));
let _e4888 = (_e4223 - _e1255);
let _e4889 = (_e4888 * _e4887);
let _e4891 = ((_e4228 - _e1255) * _e4887);
let _e4897 = select(_e4891, _e4889, (_e4889 < _e4891));
let _e4899 = select(0f, _e4897, (_e4897 > 0f));
let _e4902 = select(select(1f, _e4899, (_e4899 < 1f)), select(2f, 0f, ((_e1255 >= _e4223) && (_e1255 <= _e4228))), _e4885);
let _e4904 = select(_e4891, _e4889, (_e4889 > _e4891));
let _e4906 = select(0f, _e4904, (_e4904 > 0f));
let _e4909 = select(select(1f, _e4906, (_e4906 < 1f)), 1f, _e4885);
let _e4911 = select(_e4873, _e4844, (_e4844 > _e4873));
let _e4915 = select(_e4880, _e4851, (_e4851 < _e4880));
let _e4918 = (select(_e4909, _e4915, (_e4915 < _e4909)) - select(_e4902, _e4911, (_e4911 > _e4902)));
let _e4920 = select(0f, _e4918, (_e4918 > 0f));
let _e4921 = (_e1205 - _e1182);
let _e4922 = (_e1210 - _e1195);
let _e4923 = (_e1199 - _e1160);
let _e4928 = (((_e4921 * _e4921) + (_e4922 * _e4922)) + (_e4923 * _e4923));
let _e4936 = global_1.member.member_7.member_3;
let _e4937 = ((sqrt(select(0f, _e4928, (_e4928 > 0f))) * _e4920) * _e4936);
if (((_e189.member_2 == 3u) || (_e189.member_2 == 4u)) || _e1275) {
local_7 = _e4576;
let _e4942 = local_7;
let _e4944 = (bitcast<i32>(_e179) - 1i);
let _e4946 = select(_e4944, 263171i, (263171i < _e4944));
let _e4951 = global_3.member[bitcast<u32>(select(0i, _e4946, (_e4946 > 0i)))];
let _e4952 = bitcast<f32>(_e4951);
let _e4954 = select(_e4944, 263172i, (263172i < _e4944));
let _e4959 = global_3.member[bitcast<u32>(select(0i, _e4954, (_e4954 > 0i)))];
let _e4960 = bitcast<f32>(_e4959);
let _e4962 = select(_e4944, 263173i, (263173i < _e4944));
let _e4967 = global_3.member[bitcast<u32>(select(0i, _e4962, (_e4962 > 0i)))];
let _e4968 = bitcast<f32>(_e4967);
let _e4970 = ((_e4942 - _e4952) * _e4960);
let _e4972 = select(0f, _e4970, (_e4970 > 0f));
let _e4975 = local_7;
let _e4977 = select(_e4944, 263174i, (263174i < _e4944));
let _e4982 = global_3.member[bitcast<u32>(select(0i, _e4977, (_e4977 > 0i)))];
let _e4983 = bitcast<f32>(_e4982);
let _e4985 = select(_e4944, 263175i, (263175i < _e4944));
let _e4990 = global_3.member[bitcast<u32>(select(0i, _e4985, (_e4985 > 0i)))];
let _e4991 = bitcast<f32>(_e4990);
let _e4993 = select(_e4944, 263176i, (263176i < _e4944));
let _e4998 = global_3.member[bitcast<u32>(select(0i, _e4993, (_e4993 > 0i)))];
let _e4999 = bitcast<f32>(_e4998);
let _e5001 = ((_e4975 - _e4983) * _e4991);
let _e5003 = select(0f, _e5001, (_e5001 > 0f));
let _e5007 = local_7;
let _e5009 = select(_e4944, 263177i, (263177i < _e4944));
let _e5014 = global_3.member[bitcast<u32>(select(0i, _e5009, (_e5009 > 0i)))];
let _e5015 = bitcast<f32>(_e5014);
let _e5017 = select(_e4944, 263178i, (263178i < _e4944));
let _e5022 = global_3.member[bitcast<u32>(select(0i, _e5017, (_e5017 > 0i)))];
let _e5023 = bitcast<f32>(_e5022);
let _e5025 = select(_e4944, 263179i, (263179i < _e4944));
let _e5030 = global_3.member[bitcast<u32>(select(0i, _e5025, (_e5025 > 0i)))];
let _e5031 = bitcast<f32>(_e5030);
let _e5033 = ((_e5007 - _e5015) * _e5023);
let _e5035 = select(0f, _e5033, (_e5033 > 0f));
let _e5038 = local_7;
let _e5040 = select(_e4944, 263180i, (263180i < _e4944));
let _e5045 = global_3.member[bitcast<u32>(select(0i, _e5040, (_e5040 > 0i)))];
let _e5046 = bitcast<f32>(_e5045);
let _e5048 = select(_e4944, 263181i, (263181i < _e4944));
let _e5053 = global_3.member[bitcast<u32>(select(0i, _e5048, (_e5048 > 0i)))];
let _e5054 = bitcast<f32>(_e5053);
let _e5056 = select(_e4944, 263182i, (263182i < _e4944));
let _e5061 = global_3.member[bitcast<u32>(select(0i, _e5056, (_e5056 > 0i)))];
let _e5062 = bitcast<f32>(_e5061);
let _e5064 = ((_e5038 - _e5046) * _e5054);
let _e5066 = select(0f, _e5064, (_e5064 > 0f));
let _e5071 = local_7;
let _e5073 = select(_e4944, 263183i, (263183i < _e4944));
let _e5078 = global_3.member[bitcast<u32>(select(0i, _e5073, (_e5073 > 0i)))];
let _e5079 = bitcast<f32>(_e5078);
let _e5081 = select(_e4944, 263184i, (263184i < _e4944));
let _e5086 = global_3.member[bitcast<u32>(select(0i, _e5081, (_e5081 > 0i)))];
let _e5087 = bitcast<f32>(_e5086);
let _e5089 = select(_e4944, 263185i, (263185i < _e4944));
let _e5094 = global_3.member[bitcast<u32>(select(0i, _e5089, (_e5089 > 0i)))];
let _e5095 = bitcast<f32>(_e5094);
let _e5097 = ((_e5071 - _e5079) * _e5087);
let _e5099 = select(0f, _e5097, (_e5097 > 0f));
let _e5102 = local_7;
let _e5104 = select(_e4944, 263186i, (263186i < _e4944));
let _e5109 = global_3.member[bitcast<u32>(select(0i, _e5104, (_e5104 > 0i)))];
let _e5110 = bitcast<f32>(_e5109);
let _e5112 = select(_e4944, 263187i, (263187i < _e4944));
let _e5117 = global_3.member[bitcast<u32>(select(0i, _e5112, (_e5112 > 0i)))];
let _e5118 = bitcast<f32>(_e5117);
let _e5120 = select(_e4944, 263188i, (263188i < _e4944));
let _e5125 = global_3.member[bitcast<u32>(select(0i, _e5120, (_e5120 > 0i)))];
let _e5126 = bitcast<f32>(_e5125);
let _e5128 = ((_e5102 - _e5110) * _e5118);
let _e5130 = select(0f, _e5128, (_e5128 > 0f));
let _e5134 = local_7;
let _e5136 = select(_e4944, 263189i, (263189i < _e4944));
let _e5141 = global_3.member[bitcast<u32>(select(0i, _e5136, (_e5136 > 0i)))];
let _e5142 = bitcast<f32>(_e5141);
let _e5144 = select(_e4944, 263190i, (263190i < _e4944));
let _e5149 = global_3.member[bitcast<u32>(select(0i, _e5144, (_e5144 > 0i)))];
let _e5150 = bitcast<f32>(_e5149);
let _e5152 = select(_e4944, 263191i, (263191i < _e4944));
let _e5157 = global_3.member[bitcast<u32>(select(0i, _e5152, (_e5152 > 0i)))];
let _e5158 = bitcast<f32>(_e5157);
let _e5160 = ((_e5134 - _e5142) * _e5150);
let _e5162 = select(0f, _e5160, (_e5160 > 0f));
let _e5165 = local_7;
let _e5167 = select(_e4944, 263192i, (263192i < _e4944));
let _e5172 = global_3.member[bitcast<u32>(select(0i, _e5167, (_e5167 > 0i)))];
let _e5173 = bitcast<f32>(_e5172);
let _e5175 = select(_e4944, 263193i, (263193i < _e4944));
let _e5180 = global_3.member[bitcast<u32>(select(0i, _e5175, (_e5175 > 0i)))];
let _e5181 = bitcast<f32>(_e5180);
let _e5183 = select(_e4944, 263194i, (263194i < _e4944));
let _e5188 = global_3.member[bitcast<u32>(select(0i, _e5183, (_e5183 > 0i)))];
let _e5189 = bitcast<f32>(_e5188);
let _e5191 = ((_e5165 - _e5173) * _e5181);
let _e5193 = select(0f, _e5191, (_e5191 > 0f));
let _e5198 = (((select(_e4968, _e4972, (_e4972 < _e4968)) + select(_e4999, _e5003, (_e5003 < _e4999))) + (select(_e5031, _e5035, (_e5035 < _e5031)) + select(_e5062, _e5066, (_e5066 < _e5062)))) + ((select(_e5095, _e5099, (_e5099 < _e5095)) + select(_e5126, _e5130, (_e5130 < _e5126))) + (select(_e5158, _e5162, (_e5162 < _e5158)) + select(_e5189, _e5193, (_e5193 < _e5189)))));
local_6 = _e4190.member;
let _e5199 = local_6;
let _e5201 = ((_e5199 - _e4952) * _e4960);
let _e5203 = select(0f, _e5201, (_e5201 > 0f));
let _e5206 = local_6;
let _e5208 = ((_e5206 - _e4983) * _e4991);
let _e5210 = select(0f, _e5208, (_e5208 > 0f));
let _e5214 = local_6;
let _e5216 = ((_e5214 - _e5015) * _e5023);
let _e5218 = select(0f, _e5216, (_e5216 > 0f));
let _e5221 = local_6;
let _e5223 = ((_e5221 - _e5046) * _e5054);
let _e5225 = select(0f, _e5223, (_e5223 > 0f));
let _e5230 = local_6;
let _e5232 = ((_e5230 - _e5079) * _e5087);
let _e5234 = select(0f, _e5232, (_e5232 > 0f));
let _e5237 = local_6;
let _e5239 = ((_e5237 - _e5110) * _e5118);
let _e5241 = select(0f, _e5239, (_e5239 > 0f));
let _e5245 = local_6;
let _e5247 = ((_e5245 - _e5142) * _e5150);
let _e5249 = select(0f, _e5247, (_e5247 > 0f));
let _e5252 = local_6;
let _e5254 = ((_e5252 - _e5173) * _e5181);
let _e5256 = select(0f, _e5254, (_e5254 > 0f));
let _e5261 = (((select(_e4968, _e5203, (_e5203 < _e4968)) + select(_e4999, _e5210, (_e5210 < _e4999))) + (select(_e5031, _e5218, (_e5218 < _e5031)) + select(_e5062, _e5225, (_e5225 < _e5062)))) + ((select(_e5095, _e5234, (_e5234 < _e5095)) + select(_e5126, _e5241, (_e5241 < _e5126))) + (select(_e5158, _e5249, (_e5249 < _e5158)) + select(_e5189, _e5256, (_e5256 < _e5189)))));
let _e5262 = (255f - 1f);
let _e5264 = select(0f, _e5198, (_e5198 > 0f));
let _e5266 = select(_e5262, _e5264, (_e5264 < _e5262));
let _e5273 = select(0i, select(select(i32(_e5266), i32(-2147483648), (_e5266 < -2147483600f)), 2147483647i, (_e5266 > 2147483500f)), (_e5266 == _e5266));
let _e5277 = (_e5273 - select(0i, 1i, (_e5266 < f32(_e5273))));
let _e5279 = select(0f, _e5261, (_e5261 > 0f));
let _e5281 = select(_e5262, _e5279, (_e5279 < _e5262));
let _e5288 = select(0i, select(select(i32(_e5281), i32(-2147483648), (_e5281 < -2147483600f)), 2147483647i, (_e5281 > 2147483500f)), (_e5281 == _e5281));
let _e5292 = (_e5288 - select(0i, 1i, (_e5281 < f32(_e5288))));
let _e5294 = select(_e4944, 263195i, (263195i < _e4944));
let _e5300 = global_3.member[bitcast<u32>(select(0i, _e5294, (_e5294 > 0i)))];
let _e5301 = bitcast<f32>(_e5300);
let _e5303 = select(_e4944, 263196i, (263196i < _e4944));
let _e5309 = global_3.member[bitcast<u32>(select(0i, _e5303, (_e5303 > 0i)))];
let _e5310 = bitcast<f32>(_e5309);
let _e5311 = (_e4190.member - _e4576);
let _e5317 = (1f / select(_e5311, 1f, (bitcast<f32>((bitcast<u32>(_e5311) & 2147483647u)) < 1e-20f)));
let _e5323 = ((select(_e5301, _e4190.member, (_e4190.member < _e5301)) - select(_e5301, _e4576, (_e4576 < _e5301))) * _e5317);
let _e5329 = ((select(_e5310, _e4190.member, (_e4190.member > _e5310)) - select(_e5310, _e4576, (_e4576 > _e5310))) * _e5317);
let _e5332 = (((_e5277 * 256i) + _e5292) * 4i);
let _e5336 = (_e5261 - f32(_e5292));
let _e5339 = (_e5332 + 1i);
let _e5341 = select(_e4944, _e5339, (_e5339 < _e4944));
let _e5347 = global_3.member[bitcast<u32>(select(0i, _e5341, (_e5341 > 0i)))];
let _e5354 = (bitcast<f32>((((_e5347 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5355 = (_e5332 + 5i);
let _e5357 = select(_e4944, _e5355, (_e5355 < _e4944));
let _e5363 = global_3.member[bitcast<u32>(select(0i, _e5357, (_e5357 > 0i)))];
let _e5371 = (_e5332 + 1025i);
let _e5373 = select(_e4944, _e5371, (_e5371 < _e4944));
let _e5379 = global_3.member[bitcast<u32>(select(0i, _e5373, (_e5373 > 0i)))];
let _e5386 = (bitcast<f32>((((_e5379 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5387 = (_e5332 + 1029i);
let _e5389 = select(_e4944, _e5387, (_e5387 < _e4944));
let _e5395 = global_3.member[bitcast<u32>(select(0i, _e5389, (_e5389 > 0i)))];
let _e5405 = (_e5354 + (((bitcast<f32>((((_e5363 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5354) * _e5336));
let _e5413 = select(_e4944, 1i, (1i < _e4944));
let _e5419 = global_3.member[bitcast<u32>(select(0i, _e5413, (_e5413 > 0i)))];
let _e5428 = select(_e4944, 262141i, (262141i < _e4944));
let _e5434 = global_3.member[bitcast<u32>(select(0i, _e5428, (_e5428 > 0i)))];
let _e5446 = (((_e5405 + (((_e5386 + (((bitcast<f32>((((_e5395 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5386) * _e5336)) - _e5405) * (_e5198 - f32(_e5277)))) * (1f - (_e5323 + _e5329))) + (((bitcast<f32>((((_e5419 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5323) + ((bitcast<f32>((((_e5434 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5329)));
let _e5451 = (_e4822.member.member_1 - _e4822.member.member);
let _e5456 = -((_e5446 * (_e4937 * select(0f, _e5451, (_e5451 > 0f)))));
let _e5458 = select(-87f, _e5456, (_e5456 > -87f));
let _e5460 = select(88f, _e5458, (_e5458 < 88f));
let _e5462 = ((_e5460 * 1.442695f) + 0.5f);
let _e5464 = select(-127f, _e5462, (_e5462 > -127f));
let _e5466 = select(128f, _e5464, (_e5464 < 128f));
let _e5473 = select(0i, select(select(i32(_e5466), i32(-2147483648), (_e5466 < -2147483600f)), 2147483647i, (_e5466 > 2147483500f)), (_e5466 == _e5466));
let _e5477 = (_e5473 - select(0i, 1i, (_e5466 < f32(_e5473))));
let _e5478 = f32(_e5477);
let _e5482 = ((_e5460 - (_e5478 * 0.6933594f)) - (_e5478 * -2.1219444e-4f));
let _e5502 = ((1f + (_e5482 * (1f + (_e5482 * (0.5f + (_e5482 * (0.16666667f + (_e5482 * (0.041666668f + (_e5482 * (0.008333334f + (_e5482 * (0.001388889f + (_e5482 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5477 + 127i)) << bitcast<u32>(23i))));
let _e5503 = (1f - _e5502);
phi_14208_ = type_38(_e5502, _e5503, vec3<f32>(1f, 1f, 1f), vec3((0f * (_e5503 / select(1e-12f, _e5446, (_e5446 > 1e-12f))))));
} else {
local_5 = _e4576;
let _e5510 = local_5;
let _e5512 = (bitcast<i32>(_e179) - 1i);
let _e5514 = select(_e5512, 263171i, (263171i < _e5512));
let _e5519 = global_3.member[bitcast<u32>(select(0i, _e5514, (_e5514 > 0i)))];
let _e5520 = bitcast<f32>(_e5519);
let _e5522 = select(_e5512, 263172i, (263172i < _e5512));
let _e5527 = global_3.member[bitcast<u32>(select(0i, _e5522, (_e5522 > 0i)))];
let _e5528 = bitcast<f32>(_e5527);
let _e5530 = select(_e5512, 263173i, (263173i < _e5512));
let _e5535 = global_3.member[bitcast<u32>(select(0i, _e5530, (_e5530 > 0i)))];
let _e5536 = bitcast<f32>(_e5535);
let _e5538 = ((_e5510 - _e5520) * _e5528);
let _e5540 = select(0f, _e5538, (_e5538 > 0f));
let _e5543 = local_5;
let _e5545 = select(_e5512, 263174i, (263174i < _e5512));
let _e5550 = global_3.member[bitcast<u32>(select(0i, _e5545, (_e5545 > 0i)))];
let _e5551 = bitcast<f32>(_e5550);
let _e5553 = select(_e5512, 263175i, (263175i < _e5512));
let _e5558 = global_3.member[bitcast<u32>(select(0i, _e5553, (_e5553 > 0i)))];
let _e5559 = bitcast<f32>(_e5558);
let _e5561 = select(_e5512, 263176i, (263176i < _e5512));
let _e5566 = global_3.member[bitcast<u32>(select(0i, _e5561, (_e5561 > 0i)))];
let _e5567 = bitcast<f32>(_e5566);
let _e5569 = ((_e5543 - _e5551) * _e5559);
let _e5571 = select(0f, _e5569, (_e5569 > 0f));
let _e5575 = local_5;
let _e5577 = select(_e5512, 263177i, (263177i < _e5512));
let _e5582 = global_3.member[bitcast<u32>(select(0i, _e5577, (_e5577 > 0i)))];
let _e5583 = bitcast<f32>(_e5582);
let _e5585 = select(_e5512, 263178i, (263178i < _e5512));
let _e5590 = global_3.member[bitcast<u32>(select(0i, _e5585, (_e5585 > 0i)))];
let _e5591 = bitcast<f32>(_e5590);
let _e5593 = select(_e5512, 263179i, (263179i < _e5512));
let _e5598 = global_3.member[bitcast<u32>(select(0i, _e5593, (_e5593 > 0i)))];
let _e5599 = bitcast<f32>(_e5598);
let _e5601 = ((_e5575 - _e5583) * _e5591);
let _e5603 = select(0f, _e5601, (_e5601 > 0f));
let _e5606 = local_5;
let _e5608 = select(_e5512, 263180i, (263180i < _e5512));
let _e5613 = global_3.member[bitcast<u32>(select(0i, _e5608, (_e5608 > 0i)))];
let _e5614 = bitcast<f32>(_e5613);
let _e5616 = select(_e5512, 263181i, (263181i < _e5512));
let _e5621 = global_3.member[bitcast<u32>(select(0i, _e5616, (_e5616 > 0i)))];
let _e5622 = bitcast<f32>(_e5621);
let _e5624 = select(_e5512, 263182i, (263182i < _e5512));
let _e5629 = global_3.member[bitcast<u32>(select(0i, _e5624, (_e5624 > 0i)))];
let _e5630 = bitcast<f32>(_e5629);
let _e5632 = ((_e5606 - _e5614) * _e5622);
let _e5634 = select(0f, _e5632, (_e5632 > 0f));
let _e5639 = local_5;
let _e5641 = select(_e5512, 263183i, (263183i < _e5512));
let _e5646 = global_3.member[bitcast<u32>(select(0i, _e5641, (_e5641 > 0i)))];
let _e5647 = bitcast<f32>(_e5646);
let _e5649 = select(_e5512, 263184i, (263184i < _e5512));
let _e5654 = global_3.member[bitcast<u32>(select(0i, _e5649, (_e5649 > 0i)))];
let _e5655 = bitcast<f32>(_e5654);
let _e5657 = select(_e5512, 263185i, (263185i < _e5512));
let _e5662 = global_3.member[bitcast<u32>(select(0i, _e5657, (_e5657 > 0i)))];
let _e5663 = bitcast<f32>(_e5662);
let _e5665 = ((_e5639 - _e5647) * _e5655);
let _e5667 = select(0f, _e5665, (_e5665 > 0f));
let _e5670 = local_5;
let _e5672 = select(_e5512, 263186i, (263186i < _e5512));
let _e5677 = global_3.member[bitcast<u32>(select(0i, _e5672, (_e5672 > 0i)))];
let _e5678 = bitcast<f32>(_e5677);
let _e5680 = select(_e5512, 263187i, (263187i < _e5512));
let _e5685 = global_3.member[bitcast<u32>(select(0i, _e5680, (_e5680 > 0i)))];
let _e5686 = bitcast<f32>(_e5685);
let _e5688 = select(_e5512, 263188i, (263188i < _e5512));
let _e5693 = global_3.member[bitcast<u32>(select(0i, _e5688, (_e5688 > 0i)))];
let _e5694 = bitcast<f32>(_e5693);
let _e5696 = ((_e5670 - _e5678) * _e5686);
let _e5698 = select(0f, _e5696, (_e5696 > 0f));
let _e5702 = local_5;
let _e5704 = select(_e5512, 263189i, (263189i < _e5512));
let _e5709 = global_3.member[bitcast<u32>(select(0i, _e5704, (_e5704 > 0i)))];
let _e5710 = bitcast<f32>(_e5709);
let _e5712 = select(_e5512, 263190i, (263190i < _e5512));
let _e5717 = global_3.member[bitcast<u32>(select(0i, _e5712, (_e5712 > 0i)))];
let _e5718 = bitcast<f32>(_e5717);
let _e5720 = select(_e5512, 263191i, (263191i < _e5512));
let _e5725 = global_3.member[bitcast<u32>(select(0i, _e5720, (_e5720 > 0i)))];
let _e5726 = bitcast<f32>(_e5725);
let _e5728 = ((_e5702 - _e5710) * _e5718);
let _e5730 = select(0f, _e5728, (_e5728 > 0f));
let _e5733 = local_5;
let _e5735 = select(_e5512, 263192i, (263192i < _e5512));
let _e5740 = global_3.member[bitcast<u32>(select(0i, _e5735, (_e5735 > 0i)))];
let _e5741 = bitcast<f32>(_e5740);
let _e5743 = select(_e5512, 263193i, (263193i < _e5512));
let _e5748 = global_3.member[bitcast<u32>(select(0i, _e5743, (_e5743 > 0i)))];
let _e5749 = bitcast<f32>(_e5748);
let _e5751 = select(_e5512, 263194i, (263194i < _e5512));
let _e5756 = global_3.member[bitcast<u32>(select(0i, _e5751, (_e5751 > 0i)))];
let _e5757 = bitcast<f32>(_e5756);
let _e5759 = ((_e5733 - _e5741) * _e5749);
let _e5761 = select(0f, _e5759, (_e5759 > 0f));
let _e5766 = (((select(_e5536, _e5540, (_e5540 < _e5536)) + select(_e5567, _e5571, (_e5571 < _e5567))) + (select(_e5599, _e5603, (_e5603 < _e5599)) + select(_e5630, _e5634, (_e5634 < _e5630)))) + ((select(_e5663, _e5667, (_e5667 < _e5663)) + select(_e5694, _e5698, (_e5698 < _e5694))) + (select(_e5726, _e5730, (_e5730 < _e5726)) + select(_e5757, _e5761, (_e5761 < _e5757)))));
local_4 = _e4190.member;
let _e5767 = local_4;
let _e5769 = ((_e5767 - _e5520) * _e5528);
let _e5771 = select(0f, _e5769, (_e5769 > 0f));
let _e5774 = local_4;
let _e5776 = ((_e5774 - _e5551) * _e5559);
let _e5778 = select(0f, _e5776, (_e5776 > 0f));
let _e5782 = local_4;
let _e5784 = ((_e5782 - _e5583) * _e5591);
let _e5786 = select(0f, _e5784, (_e5784 > 0f));
let _e5789 = local_4;
let _e5791 = ((_e5789 - _e5614) * _e5622);
let _e5793 = select(0f, _e5791, (_e5791 > 0f));
let _e5798 = local_4;
let _e5800 = ((_e5798 - _e5647) * _e5655);
let _e5802 = select(0f, _e5800, (_e5800 > 0f));
let _e5805 = local_4;
let _e5807 = ((_e5805 - _e5678) * _e5686);
let _e5809 = select(0f, _e5807, (_e5807 > 0f));
let _e5813 = local_4;
let _e5815 = ((_e5813 - _e5710) * _e5718);
let _e5817 = select(0f, _e5815, (_e5815 > 0f));
let _e5820 = local_4;
let _e5822 = ((_e5820 - _e5741) * _e5749);
let _e5824 = select(0f, _e5822, (_e5822 > 0f));
let _e5829 = (((select(_e5536, _e5771, (_e5771 < _e5536)) + select(_e5567, _e5778, (_e5778 < _e5567))) + (select(_e5599, _e5786, (_e5786 < _e5599)) + select(_e5630, _e5793, (_e5793 < _e5630)))) + ((select(_e5663, _e5802, (_e5802 < _e5663)) + select(_e5694, _e5809, (_e5809 < _e5694))) + (select(_e5726, _e5817, (_e5817 < _e5726)) + select(_e5757, _e5824, (_e5824 < _e5757)))));
let _e5830 = (255f - 1f);
let _e5832 = select(0f, _e5766, (_e5766 > 0f));
let _e5834 = select(_e5830, _e5832, (_e5832 < _e5830));
let _e5841 = select(0i, select(select(i32(_e5834), i32(-2147483648), (_e5834 < -2147483600f)), 2147483647i, (_e5834 > 2147483500f)), (_e5834 == _e5834));
let _e5845 = (_e5841 - select(0i, 1i, (_e5834 < f32(_e5841))));
let _e5847 = select(0f, _e5829, (_e5829 > 0f));
let _e5849 = select(_e5830, _e5847, (_e5847 < _e5830));
let _e5856 = select(0i, select(select(i32(_e5849), i32(-2147483648), (_e5849 < -2147483600f)), 2147483647i, (_e5849 > 2147483500f)), (_e5849 == _e5849));
let _e5860 = (_e5856 - select(0i, 1i, (_e5849 < f32(_e5856))));
let _e5862 = select(_e5512, 263195i, (263195i < _e5512));
let _e5868 = global_3.member[bitcast<u32>(select(0i, _e5862, (_e5862 > 0i)))];
let _e5869 = bitcast<f32>(_e5868);
let _e5871 = select(_e5512, 263196i, (263196i < _e5512));
let _e5877 = global_3.member[bitcast<u32>(select(0i, _e5871, (_e5871 > 0i)))];
let _e5878 = bitcast<f32>(_e5877);
let _e5879 = (_e4190.member - _e4576);
let _e5885 = (1f / select(_e5879, 1f, (bitcast<f32>((bitcast<u32>(_e5879) & 2147483647u)) < 1e-20f)));
let _e5891 = ((select(_e5869, _e4190.member, (_e4190.member < _e5869)) - select(_e5869, _e4576, (_e4576 < _e5869))) * _e5885);
let _e5897 = ((select(_e5878, _e4190.member, (_e4190.member > _e5878)) - select(_e5878, _e4576, (_e4576 > _e5878))) * _e5885);
let _e5900 = (((_e5845 * 256i) + _e5860) * 4i);
let _e5902 = (_e5766 - f32(_e5845));
let _e5904 = (_e5829 - f32(_e5860));
let _e5906 = (1f - (_e5891 + _e5897));
let _e5908 = select(_e5512, _e5900, (_e5900 < _e5512));
let _e5914 = global_3.member[bitcast<u32>(select(0i, _e5908, (_e5908 > 0i)))];
let _e5919 = (bitcast<f32>(((_e5914 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5926 = (bitcast<f32>((((_e5914 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5927 = (_e5900 + 4i);
let _e5929 = select(_e5512, _e5927, (_e5927 < _e5512));
let _e5935 = global_3.member[bitcast<u32>(select(0i, _e5929, (_e5929 > 0i)))];
let _e5948 = (_e5900 + 1024i);
let _e5950 = select(_e5512, _e5948, (_e5948 < _e5512));
let _e5956 = global_3.member[bitcast<u32>(select(0i, _e5950, (_e5950 > 0i)))];
let _e5961 = (bitcast<f32>(((_e5956 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5968 = (bitcast<f32>((((_e5956 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5969 = (_e5900 + 1028i);
let _e5971 = select(_e5512, _e5969, (_e5969 < _e5512));
let _e5977 = global_3.member[bitcast<u32>(select(0i, _e5971, (_e5971 > 0i)))];
let _e5992 = (_e5919 + (((bitcast<f32>(((_e5935 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5919) * _e5904));
let _e6001 = (_e5926 + (((bitcast<f32>((((_e5935 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5926) * _e5904));
let _e6009 = select(_e5512, 0i, (0i < _e5512));
let _e6015 = global_3.member[bitcast<u32>(select(0i, _e6009, (_e6009 > 0i)))];
let _e6029 = select(_e5512, 262140i, (262140i < _e5512));
let _e6035 = global_3.member[bitcast<u32>(select(0i, _e6029, (_e6029 > 0i)))];
let _e6058 = (_e5900 + 1i);
let _e6060 = select(_e5512, _e6058, (_e6058 < _e5512));
let _e6066 = global_3.member[bitcast<u32>(select(0i, _e6060, (_e6060 > 0i)))];
let _e6071 = (bitcast<f32>(((_e6066 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e6078 = (bitcast<f32>((((_e6066 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e6079 = (_e5900 + 5i);
let _e6081 = select(_e5512, _e6079, (_e6079 < _e5512));
let _e6087 = global_3.member[bitcast<u32>(select(0i, _e6081, (_e6081 > 0i)))];
let _e6100 = (_e5900 + 1025i);
let _e6102 = select(_e5512, _e6100, (_e6100 < _e5512));
let _e6108 = global_3.member[bitcast<u32>(select(0i, _e6102, (_e6102 > 0i)))];
let _e6113 = (bitcast<f32>(((_e6108 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e6120 = (bitcast<f32>((((_e6108 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e6121 = (_e5900 + 1029i);
let _e6123 = select(_e5512, _e6121, (_e6121 < _e5512));
let _e6129 = global_3.member[bitcast<u32>(select(0i, _e6123, (_e6123 > 0i)))];
let _e6144 = (_e6071 + (((bitcast<f32>(((_e6087 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e6071) * _e5904));
let _e6153 = (_e6078 + (((bitcast<f32>((((_e6087 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e6078) * _e5904));
let _e6161 = select(_e5512, 1i, (1i < _e5512));
let _e6167 = global_3.member[bitcast<u32>(select(0i, _e6161, (_e6161 > 0i)))];
let _e6181 = select(_e5512, 262141i, (262141i < _e5512));
let _e6187 = global_3.member[bitcast<u32>(select(0i, _e6181, (_e6181 > 0i)))];
let _e6209 = (((_e6153 + (((_e6120 + (((bitcast<f32>((((_e6129 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e6120) * _e5904)) - _e6153) * _e5902)) * _e5906) + (((bitcast<f32>((((_e6167 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5891) + ((bitcast<f32>((((_e6187 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5897)));
let _e6214 = (_e4822.member.member_1 - _e4822.member.member);
let _e6222 = (_e4822.member_1.member_1 - _e4822.member_1.member);
let _e6225 = (_e4937 * select(0f, _e6222, (_e6222 > 0f)));
let _e6227 = -(((((_e6144 + (((_e6113 + (((bitcast<f32>(((_e6129 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e6113) * _e5904)) - _e6144) * _e5902)) * _e5906) + (((bitcast<f32>(((_e6167 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5891) + ((bitcast<f32>(((_e6187 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5897))) * _e6225));
let _e6229 = select(-87f, _e6227, (_e6227 > -87f));
let _e6231 = select(88f, _e6229, (_e6229 < 88f));
let _e6233 = ((_e6231 * 1.442695f) + 0.5f);
let _e6235 = select(-127f, _e6233, (_e6233 > -127f));
let _e6237 = select(128f, _e6235, (_e6235 < 128f));
let _e6244 = select(0i, select(select(i32(_e6237), i32(-2147483648), (_e6237 < -2147483600f)), 2147483647i, (_e6237 > 2147483500f)), (_e6237 == _e6237));
let _e6248 = (_e6244 - select(0i, 1i, (_e6237 < f32(_e6244))));
let _e6249 = f32(_e6248);
let _e6253 = ((_e6231 - (_e6249 * 0.6933594f)) - (_e6249 * -2.1219444e-4f));
let _e6275 = -(((((_e5992 + (((_e5961 + (((bitcast<f32>(((_e5977 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5961) * _e5904)) - _e5992) * _e5902)) * _e5906) + (((bitcast<f32>(((_e6015 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5891) + ((bitcast<f32>(((_e6035 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5897))) * _e6225));
let _e6277 = select(-87f, _e6275, (_e6275 > -87f));
let _e6279 = select(88f, _e6277, (_e6277 < 88f));
let _e6281 = ((_e6279 * 1.442695f) + 0.5f);
let _e6283 = select(-127f, _e6281, (_e6281 > -127f));
let _e6285 = select(128f, _e6283, (_e6283 < 128f));
let _e6292 = select(0i, select(select(i32(_e6285), i32(-2147483648), (_e6285 < -2147483600f)), 2147483647i, (_e6285 > 2147483500f)), (_e6285 == _e6285));
let _e6296 = (_e6292 - select(0i, 1i, (_e6285 < f32(_e6292))));
let _e6297 = f32(_e6296);
let _e6301 = ((_e6279 - (_e6297 * 0.6933594f)) - (_e6297 * -2.1219444e-4f));
let _e6323 = -(((((_e6001 + (((_e5968 + (((bitcast<f32>((((_e5977 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5968) * _e5904)) - _e6001) * _e5902)) * _e5906) + (((bitcast<f32>((((_e6015 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5891) + ((bitcast<f32>((((_e6035 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5897))) * _e6225));
let _e6325 = select(-87f, _e6323, (_e6323 > -87f));
let _e6327 = select(88f, _e6325, (_e6325 < 88f));
let _e6329 = ((_e6327 * 1.442695f) + 0.5f);
let _e6331 = select(-127f, _e6329, (_e6329 > -127f));
let _e6333 = select(128f, _e6331, (_e6331 < 128f));
let _e6340 = select(0i, select(select(i32(_e6333), i32(-2147483648), (_e6333 < -2147483600f)), 2147483647i, (_e6333 > 2147483500f)), (_e6333 == _e6333));
let _e6344 = (_e6340 - select(0i, 1i, (_e6333 < f32(_e6340))));
let _e6345 = f32(_e6344);
let _e6349 = ((_e6327 - (_e6345 * 0.6933594f)) - (_e6345 * -2.1219444e-4f));
let _e6372 = -((_e6209 * (_e4937 * select(0f, _e6214, (_e6214 > 0f)))));
let _e6374 = select(-87f, _e6372, (_e6372 > -87f));
let _e6376 = select(88f, _e6374, (_e6374 < 88f));
let _e6378 = ((_e6376 * 1.442695f) + 0.5f);
let _e6380 = select(-127f, _e6378, (_e6378 > -127f));
let _e6382 = select(128f, _e6380, (_e6380 < 128f));
let _e6389 = select(0i, select(select(i32(_e6382), i32(-2147483648), (_e6382 < -2147483600f)), 2147483647i, (_e6382 > 2147483500f)), (_e6382 == _e6382));
let _e6393 = (_e6389 - select(0i, 1i, (_e6382 < f32(_e6389))));
let _e6394 = f32(_e6393);
let _e6398 = ((_e6376 - (_e6394 * 0.6933594f)) - (_e6394 * -2.1219444e-4f));
let _e6418 = ((1f + (_e6398 * (1f + (_e6398 * (0.5f + (_e6398 * (0.16666667f + (_e6398 * (0.041666668f + (_e6398 * (0.008333334f + (_e6398 * (0.001388889f + (_e6398 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6393 + 127i)) << bitcast<u32>(23i))));
let _e6419 = (1f - _e6418);
phi_14208_ = type_38(_e6418, _e6419, vec3<f32>(((1f + (_e6253 * (1f + (_e6253 * (0.5f + (_e6253 * (0.16666667f + (_e6253 * (0.041666668f + (_e6253 * (0.008333334f + (_e6253 * (0.001388889f + (_e6253 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6248 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e6301 * (1f + (_e6301 * (0.5f + (_e6301 * (0.16666667f + (_e6301 * (0.041666668f + (_e6301 * (0.008333334f + (_e6301 * (0.001388889f + (_e6301 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6296 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e6349 * (1f + (_e6349 * (0.5f + (_e6349 * (0.16666667f + (_e6349 * (0.041666668f + (_e6349 * (0.008333334f + (_e6349 * (0.001388889f + (_e6349 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6344 + 127i)) << bitcast<u32>(23i))))), vec3((0f * (_e6419 / select(1e-12f, _e6209, (_e6209 > 1e-12f))))));
}
let _e6427 = phi_14208_;
if (false || ((_e4579 & 1024u) != 0u)) {
let _e6438 = (_e4190.member - _e4576);
let _e6441 = select(_e4190.member, (_e4576 + (_e6438 * _e4822.member.member)), (_e4822.member.member < 1f));
let _e6447 = select(_e6441, select(_e4190.member, (_e4576 + (_e6438 * _e4822.member.member_1)), (_e4822.member.member_1 < 1f)), (_e4822.member.member_1 > _e4822.member.member));
let _e6449 = (bitcast<i32>(_e179) - 1i);
let _e6451 = select(_e6449, 263211i, (263211i < _e6449));
let _e6457 = global_3.member[bitcast<u32>(select(0i, _e6451, (_e6451 > 0i)))];
let _e6458 = bitcast<f32>(_e6457);
let _e6462 = select(_e6449, 263212i, (263212i < _e6449));
let _e6468 = global_3.member[bitcast<u32>(select(0i, _e6462, (_e6462 > 0i)))];
let _e6469 = bitcast<f32>(_e6468);
let _e6474 = select(_e6449, 263213i, (263213i < _e6449));
let _e6480 = global_3.member[bitcast<u32>(select(0i, _e6474, (_e6474 > 0i)))];
let _e6481 = bitcast<f32>(_e6480);
let _e6485 = select(_e6449, 263214i, (263214i < _e6449));
let _e6491 = global_3.member[bitcast<u32>(select(0i, _e6485, (_e6485 > 0i)))];
let _e6492 = bitcast<f32>(_e6491);
let _e6498 = select(_e6449, 263215i, (263215i < _e6449));
let _e6504 = global_3.member[bitcast<u32>(select(0i, _e6498, (_e6498 > 0i)))];
let _e6505 = bitcast<f32>(_e6504);
let _e6509 = select(_e6449, 263216i, (263216i < _e6449));
let _e6515 = global_3.member[bitcast<u32>(select(0i, _e6509, (_e6509 > 0i)))];
let _e6516 = bitcast<f32>(_e6515);
let _e6521 = select(_e6449, 263217i, (263217i < _e6449));
let _e6527 = global_3.member[bitcast<u32>(select(0i, _e6521, (_e6521 > 0i)))];
let _e6528 = bitcast<f32>(_e6527);
let _e6532 = select(_e6449, 263218i, (263218i < _e6449));
let _e6538 = global_3.member[bitcast<u32>(select(0i, _e6532, (_e6532 > 0i)))];
let _e6539 = bitcast<f32>(_e6538);
let _e6571 = (263219i + ((((((select(0i, 1i, (_e6441 >= _e6458)) + select(0i, 1i, (_e6441 >= _e6469))) + (select(0i, 1i, (_e6441 >= _e6481)) + select(0i, 1i, (_e6441 >= _e6492)))) + ((select(0i, 1i, (_e6441 >= _e6505)) + select(0i, 1i, (_e6441 >= _e6516))) + (select(0i, 1i, (_e6441 >= _e6528)) + select(0i, 1i, (_e6441 >= _e6539))))) * 9i) + (((select(0i, 1i, (_e6447 >= _e6458)) + select(0i, 1i, (_e6447 >= _e6469))) + (select(0i, 1i, (_e6447 >= _e6481)) + select(0i, 1i, (_e6447 >= _e6492)))) + ((select(0i, 1i, (_e6447 >= _e6505)) + select(0i, 1i, (_e6447 >= _e6516))) + (select(0i, 1i, (_e6447 >= _e6528)) + select(0i, 1i, (_e6447 >= _e6539)))))) * 6i));
let _e6573 = select(_e6449, _e6571, (_e6571 < _e6449));
let _e6579 = global_3.member[bitcast<u32>(select(0i, _e6573, (_e6573 > 0i)))];
phi_14606_ = (_e6427.member * select(1f, bitcast<f32>(_e6579), (_e4920 > 0f)));
} else {
phi_14606_ = _e6427.member;
}
let _e6584 = phi_14606_;
if _e1282 {
let _e6589 = global_1.member.member_8.member.member;
let _e6597 = global_1.member.member_8.member_1.member;
let _e6605 = global_1.member.member_8.member_2.member;
let _e6609 = (_e4195 - _e1261);
let _e6610 = -(_e4830);
let _e6613 = (_e4830 - _e6609);
let _e6614 = (_e6609 - _e4830);
let _e6616 = select(_e6614, _e6613, (_e6613 > _e6614));
let _e6619 = (select(_e6610, _e4830, (_e4830 > _e6610)) / select(1e-30f, _e6616, (_e6616 > 1e-30f)));
let _e6621 = (_e6609 < 0f);
let _e6623 = select(0f, select(2f, _e6619, _e6621), (_e4830 > 0f));
let _e6624 = (_e6609 > 0f);
let _e6627 = select(2f, select(0f, _e6619, (_e4830 < 0f)), _e6624);
let _e6628 = (_e4830 > -1e30f);
let _e6632 = ((_e6623 > -1f) || ((_e6623 == -1f) && _e6628));
let _e6633 = (_e6627 < 2f);
let _e6634 = select(-1f, _e6623, _e6632);
let _e6638 = select(2f, _e6627, _e6633);
let _e6642 = select(-1e30f, _e4830, _e6628);
let _e6643 = (_e6609 > -1e30f);
let _e6644 = select(-1e30f, _e6609, _e6643);
let _e6648 = (_e1225 - _e4200);
let _e6649 = (_e1261 - _e4200);
let _e6650 = -(_e6648);
let _e6653 = (_e6648 - _e6649);
let _e6654 = (_e6649 - _e6648);
let _e6656 = select(_e6654, _e6653, (_e6653 > _e6654));
let _e6659 = (select(_e6650, _e6648, (_e6648 > _e6650)) / select(1e-30f, _e6656, (_e6656 > 1e-30f)));
let _e6661 = (_e6649 < 0f);
let _e6663 = select(0f, select(2f, _e6659, _e6661), (_e6648 > 0f));
let _e6664 = (_e6649 > 0f);
let _e6667 = select(2f, select(0f, _e6659, (_e6648 < 0f)), _e6664);
let _e6668 = (_e6648 > _e6642);
let _e6672 = ((_e6663 > _e6634) || ((_e6663 == _e6634) && _e6668));
let _e6673 = (_e6667 < _e6638);
let _e6674 = select(_e6634, _e6663, _e6672);
let _e6678 = select(_e6638, _e6667, _e6673);
let _e6682 = select(_e6642, _e6648, _e6668);
let _e6683 = (_e6649 > _e6644);
let _e6684 = select(_e6644, _e6649, _e6683);
let _e6688 = (_e4209 - _e1267);
let _e6689 = -(_e4859);
let _e6692 = (_e4859 - _e6688);
let _e6693 = (_e6688 - _e4859);
let _e6695 = select(_e6693, _e6692, (_e6692 > _e6693));
let _e6698 = (select(_e6689, _e4859, (_e4859 > _e6689)) / select(1e-30f, _e6695, (_e6695 > 1e-30f)));
let _e6700 = (_e6688 < 0f);
let _e6702 = select(0f, select(2f, _e6698, _e6700), (_e4859 > 0f));
let _e6703 = (_e6688 > 0f);
let _e6706 = select(2f, select(0f, _e6698, (_e4859 < 0f)), _e6703);
let _e6707 = (_e4859 > _e6682);
let _e6711 = ((_e6702 > _e6674) || ((_e6702 == _e6674) && _e6707));
let _e6712 = (_e6706 < _e6678);
let _e6713 = select(_e6674, _e6702, _e6711);
let _e6717 = select(_e6678, _e6706, _e6712);
let _e6721 = select(_e6682, _e4859, _e6707);
let _e6722 = (_e6688 > _e6684);
let _e6723 = select(_e6684, _e6688, _e6722);
let _e6727 = (_e1240 - _e4214);
let _e6728 = (_e1267 - _e4214);
let _e6729 = -(_e6727);
let _e6732 = (_e6727 - _e6728);
let _e6733 = (_e6728 - _e6727);
let _e6735 = select(_e6733, _e6732, (_e6732 > _e6733));
let _e6738 = (select(_e6729, _e6727, (_e6727 > _e6729)) / select(1e-30f, _e6735, (_e6735 > 1e-30f)));
let _e6740 = (_e6728 < 0f);
let _e6742 = select(0f, select(2f, _e6738, _e6740), (_e6727 > 0f));
let _e6743 = (_e6728 > 0f);
let _e6746 = select(2f, select(0f, _e6738, (_e6727 < 0f)), _e6743);
let _e6747 = (_e6727 > _e6721);
let _e6751 = ((_e6742 > _e6713) || ((_e6742 == _e6713) && _e6747));
let _e6752 = (_e6746 < _e6717);
let _e6753 = select(_e6713, _e6742, _e6751);
let _e6757 = select(_e6717, _e6746, _e6752);
let _e6761 = select(_e6721, _e6727, _e6747);
let _e6762 = (_e6728 > _e6723);
let _e6763 = select(_e6723, _e6728, _e6762);
let _e6767 = (_e4223 - _e1273);
let _e6768 = -(_e4888);
let _e6771 = (_e4888 - _e6767);
let _e6772 = (_e6767 - _e4888);
let _e6774 = select(_e6772, _e6771, (_e6771 > _e6772));
let _e6777 = (select(_e6768, _e4888, (_e4888 > _e6768)) / select(1e-30f, _e6774, (_e6774 > 1e-30f)));
let _e6779 = (_e6767 < 0f);
let _e6781 = select(0f, select(2f, _e6777, _e6779), (_e4888 > 0f));
let _e6782 = (_e6767 > 0f);
let _e6785 = select(2f, select(0f, _e6777, (_e4888 < 0f)), _e6782);
let _e6786 = (_e4888 > _e6761);
let _e6790 = ((_e6781 > _e6753) || ((_e6781 == _e6753) && _e6786));
let _e6791 = (_e6785 < _e6757);
let _e6792 = select(_e6753, _e6781, _e6790);
let _e6796 = select(_e6757, _e6785, _e6791);
let _e6800 = select(_e6761, _e4888, _e6786);
let _e6801 = (_e6767 > _e6763);
let _e6802 = select(_e6763, _e6767, _e6801);
let _e6806 = (_e1255 - _e4228);
let _e6807 = (_e1273 - _e4228);
let _e6808 = -(_e6806);
let _e6811 = (_e6806 - _e6807);
let _e6812 = (_e6807 - _e6806);
let _e6814 = select(_e6812, _e6811, (_e6811 > _e6812));
let _e6817 = (select(_e6808, _e6806, (_e6806 > _e6808)) / select(1e-30f, _e6814, (_e6814 > 1e-30f)));
let _e6819 = (_e6807 < 0f);
let _e6821 = select(0f, select(2f, _e6817, _e6819), (_e6806 > 0f));
let _e6822 = (_e6807 > 0f);
let _e6825 = select(2f, select(0f, _e6817, (_e6806 < 0f)), _e6822);
let _e6826 = (_e6806 > _e6800);
let _e6830 = ((_e6821 > _e6792) || ((_e6821 == _e6792) && _e6826));
let _e6831 = (_e6825 < _e6796);
let _e6832 = select(_e6792, _e6821, _e6830);
let _e6833 = select(select(select(select(select(select(0f, _e6589.member, _e6632), _e6589.member, _e6672), _e6597.member, _e6711), _e6597.member, _e6751), _e6605.member, _e6790), _e6605.member, _e6830);
let _e6834 = select(select(select(select(select(select(0f, _e6589.member_1, _e6632), _e6589.member_1, _e6672), _e6597.member_1, _e6711), _e6597.member_1, _e6751), _e6605.member_1, _e6790), _e6605.member_1, _e6830);
let _e6835 = select(select(select(select(select(select(1f, _e6589.member_2, _e6632), _e6589.member_2, _e6672), _e6597.member_2, _e6711), _e6597.member_2, _e6751), _e6605.member_2, _e6790), _e6605.member_2, _e6830);
let _e6837 = select(_e6796, _e6825, _e6831);
let _e6838 = select(select(select(select(select(select(0f, _e6589.member, _e6633), _e6589.member, _e6673), _e6597.member, _e6712), _e6597.member, _e6752), _e6605.member, _e6791), _e6605.member, _e6831);
let _e6839 = select(select(select(select(select(select(0f, _e6589.member_1, _e6633), _e6589.member_1, _e6673), _e6597.member_1, _e6712), _e6597.member_1, _e6752), _e6605.member_1, _e6791), _e6605.member_1, _e6831);
let _e6840 = select(select(select(select(select(select(1f, _e6589.member_2, _e6633), _e6589.member_2, _e6673), _e6597.member_2, _e6712), _e6597.member_2, _e6752), _e6605.member_2, _e6791), _e6605.member_2, _e6831);
let _e6842 = select(_e6800, _e6806, _e6826);
let _e6843 = (_e6807 > _e6802);
let _e6844 = select(_e6802, _e6807, _e6843);
let _e6845 = select(select(select(select(select(select(0f, _e6589.member, _e6628), _e6589.member, _e6668), _e6597.member, _e6707), _e6597.member, _e6747), _e6605.member, _e6786), _e6605.member, _e6826);
let _e6846 = select(select(select(select(select(select(0f, _e6589.member_1, _e6628), _e6589.member_1, _e6668), _e6597.member_1, _e6707), _e6597.member_1, _e6747), _e6605.member_1, _e6786), _e6605.member_1, _e6826);
let _e6847 = select(select(select(select(select(select(1f, _e6589.member_2, _e6628), _e6589.member_2, _e6668), _e6597.member_2, _e6707), _e6597.member_2, _e6747), _e6605.member_2, _e6786), _e6605.member_2, _e6826);
if _e4581 {
phi_15931_ = type_37(_e6832, vec3<f32>(_e6833, _e6834, _e6835), _e6837, vec3<f32>(_e6838, _e6839, _e6840), _e6842, _e6844, vec3<f32>(_e6845, _e6846, _e6847));
} else {
let _e6854 = (((_e6589.member * _e6589.member) + (_e6589.member_1 * _e6589.member_1)) + (_e6589.member_2 * _e6589.member_2));
let _e6857 = sqrt(select(0f, _e6854, (_e6854 > 0f)));
let _e6861 = global_1.member.member_16.member_1;
let _e6862 = (_e6861 != 0u);
let _e6866 = global_1.member.member_16.member;
let _e6886 = select(-1e6f, (((((_e6866.member.member * _e1182) + (_e6866.member.member_1 * _e1195)) + (_e6866.member.member_2 * _e1160)) + _e6866.member_1) * _e6857), _e6862);
let _e6887 = select(-1e6f, (((((_e6866.member.member * _e1205) + (_e6866.member.member_1 * _e1210)) + (_e6866.member.member_2 * _e1199)) + _e6866.member_1) * _e6857), _e6862);
let _e6892 = global_1.member.member_16.member.member;
let _e6896 = -(_e6886);
let _e6899 = (_e6886 - _e6887);
let _e6900 = (_e6887 - _e6886);
let _e6902 = select(_e6900, _e6899, (_e6899 > _e6900));
let _e6905 = (select(_e6896, _e6886, (_e6886 > _e6896)) / select(1e-30f, _e6902, (_e6902 > 1e-30f)));
let _e6909 = select(0f, select(2f, _e6905, (_e6887 < 0f)), (_e6886 > 0f));
let _e6913 = select(2f, select(0f, _e6905, (_e6886 < 0f)), (_e6887 > 0f));
let _e6914 = (_e6886 > _e6842);
let _e6918 = ((_e6909 > _e6832) || ((_e6909 == _e6832) && _e6914));
let _e6919 = (_e6913 < _e6837);
let _e6920 = select(_e6832, _e6909, _e6918);
let _e6924 = select(_e6837, _e6913, _e6919);
let _e6928 = select(_e6842, _e6886, _e6914);
let _e6930 = select(_e6844, _e6887, (_e6887 > _e6844));
let _e6937 = global_1.member.member_17.member_1;
let _e6938 = (_e6937 != 0u);
let _e6942 = global_1.member.member_17.member;
let _e6962 = select(-1e6f, (((((_e6942.member.member * _e1182) + (_e6942.member.member_1 * _e1195)) + (_e6942.member.member_2 * _e1160)) + _e6942.member_1) * _e6857), _e6938);
let _e6963 = select(-1e6f, (((((_e6942.member.member * _e1205) + (_e6942.member.member_1 * _e1210)) + (_e6942.member.member_2 * _e1199)) + _e6942.member_1) * _e6857), _e6938);
let _e6968 = global_1.member.member_17.member.member;
let _e6972 = -(_e6962);
let _e6975 = (_e6962 - _e6963);
let _e6976 = (_e6963 - _e6962);
let _e6978 = select(_e6976, _e6975, (_e6975 > _e6976));
let _e6981 = (select(_e6972, _e6962, (_e6962 > _e6972)) / select(1e-30f, _e6978, (_e6978 > 1e-30f)));
let _e6985 = select(0f, select(2f, _e6981, (_e6963 < 0f)), (_e6962 > 0f));
let _e6989 = select(2f, select(0f, _e6981, (_e6962 < 0f)), (_e6963 > 0f));
let _e6990 = (_e6962 > _e6928);
let _e6994 = ((_e6985 > _e6920) || ((_e6985 == _e6920) && _e6990));
let _e6995 = (_e6989 < _e6924);
let _e6996 = select(_e6920, _e6985, _e6994);
let _e7000 = select(_e6924, _e6989, _e6995);
let _e7004 = select(_e6928, _e6962, _e6990);
let _e7006 = select(_e6930, _e6963, (_e6963 > _e6930));
let _e7013 = global_1.member.member_18.member_1;
let _e7014 = (_e7013 != 0u);
let _e7018 = global_1.member.member_18.member;
let _e7038 = select(-1e6f, (((((_e7018.member.member * _e1182) + (_e7018.member.member_1 * _e1195)) + (_e7018.member.member_2 * _e1160)) + _e7018.member_1) * _e6857), _e7014);
let _e7039 = select(-1e6f, (((((_e7018.member.member * _e1205) + (_e7018.member.member_1 * _e1210)) + (_e7018.member.member_2 * _e1199)) + _e7018.member_1) * _e6857), _e7014);
let _e7044 = global_1.member.member_18.member.member;
let _e7048 = -(_e7038);
let _e7051 = (_e7038 - _e7039);
let _e7052 = (_e7039 - _e7038);
let _e7054 = select(_e7052, _e7051, (_e7051 > _e7052));
let _e7057 = (select(_e7048, _e7038, (_e7038 > _e7048)) / select(1e-30f, _e7054, (_e7054 > 1e-30f)));
let _e7061 = select(0f, select(2f, _e7057, (_e7039 < 0f)), (_e7038 > 0f));
let _e7065 = select(2f, select(0f, _e7057, (_e7038 < 0f)), (_e7039 > 0f));
let _e7066 = (_e7038 > _e7004);
let _e7070 = ((_e7061 > _e6996) || ((_e7061 == _e6996) && _e7066));
let _e7071 = (_e7065 < _e7000);
let _e7072 = select(_e6996, _e7061, _e7070);
let _e7076 = select(_e7000, _e7065, _e7071);
let _e7080 = select(_e7004, _e7038, _e7066);
let _e7082 = select(_e7006, _e7039, (_e7039 > _e7006));
let _e7089 = global_1.member.member_19.member_1;
let _e7090 = (_e7089 != 0u);
let _e7094 = global_1.member.member_19.member;
let _e7114 = select(-1e6f, (((((_e7094.member.member * _e1182) + (_e7094.member.member_1 * _e1195)) + (_e7094.member.member_2 * _e1160)) + _e7094.member_1) * _e6857), _e7090);
let _e7115 = select(-1e6f, (((((_e7094.member.member * _e1205) + (_e7094.member.member_1 * _e1210)) + (_e7094.member.member_2 * _e1199)) + _e7094.member_1) * _e6857), _e7090);
let _e7120 = global_1.member.member_19.member.member;
let _e7124 = -(_e7114);
let _e7127 = (_e7114 - _e7115);
let _e7128 = (_e7115 - _e7114);
let _e7130 = select(_e7128, _e7127, (_e7127 > _e7128));
let _e7133 = (select(_e7124, _e7114, (_e7114 > _e7124)) / select(1e-30f, _e7130, (_e7130 > 1e-30f)));
let _e7137 = select(0f, select(2f, _e7133, (_e7115 < 0f)), (_e7114 > 0f));
let _e7141 = select(2f, select(0f, _e7133, (_e7114 < 0f)), (_e7115 > 0f));
let _e7142 = (_e7114 > _e7080);
let _e7146 = ((_e7137 > _e7072) || ((_e7137 == _e7072) && _e7142));
let _e7147 = (_e7141 < _e7076);
phi_15931_ = type_37(select(_e7072, _e7137, _e7146), vec3<f32>(select(select(select(select(_e6833, _e6892.member, _e6918), _e6968.member, _e6994), _e7044.member, _e7070), _e7120.member, _e7146), select(select(select(select(_e6834, _e6892.member_1, _e6918), _e6968.member_1, _e6994), _e7044.member_1, _e7070), _e7120.member_1, _e7146), select(select(select(select(_e6835, _e6892.member_2, _e6918), _e6968.member_2, _e6994), _e7044.member_2, _e7070), _e7120.member_2, _e7146)), select(_e7076, _e7141, _e7147), vec3<f32>(select(select(select(select(_e6838, _e6892.member, _e6919), _e6968.member, _e6995), _e7044.member, _e7071), _e7120.member, _e7147), select(select(select(select(_e6839, _e6892.member_1, _e6919), _e6968.member_1, _e6995), _e7044.member_1, _e7071), _e7120.member_1, _e7147), select(select(select(select(_e6840, _e6892.member_2, _e6919), _e6968.member_2, _e6995), _e7044.member_2, _e7071), _e7120.member_2, _e7147)), select(_e7080, _e7114, _e7142), select(_e7082, _e7115, (_e7115 > _e7082)), vec3<f32>(select(select(select(select(_e6845, _e6892.member, _e6914), _e6968.member, _e6990), _e7044.member, _e7066), _e7120.member, _e7142), select(select(select(select(_e6846, _e6892.member_1, _e6914), _e6968.member_1, _e6990), _e7044.member_1, _e7066), _e7120.member_1, _e7142), select(select(select(select(_e6847, _e6892.member_2, _e6914), _e6968.member_2, _e6990), _e7044.member_2, _e7066), _e7120.member_2, _e7142)));
}
let _e7167 = phi_15931_;
let _e7169 = (_e7167.member_4 < 0f);
let _e7171 = (_e7167.member_5 < 0f);
let _e7172 = (_e7169 != _e7171);
if _e7169 {
phi_15944_ = _e7167.member_3;
phi_15945_ = _e7167.member_2;
} else {
phi_15944_ = _e7167.member_1;
phi_15945_ = _e7167.member;
}
let _e7178 = phi_15944_;
let _e7180 = phi_15945_;
let _e7189 = (((_e6589.member * _e6589.member) + (_e6589.member_1 * _e6589.member_1)) + (_e6589.member_2 * _e6589.member_2));
let _e7192 = sqrt(select(0f, _e7189, (_e7189 > 0f)));
let _e7193 = ((1.5f * _e1180) * _e7192);
let _e7198 = select(0f, _e7180, _e7172);
let _e7202 = (_e1182 + (_e4921 * _e7198));
let _e7203 = (_e1195 + (_e4922 * _e7198));
let _e7204 = (_e1160 + (_e4923 * _e7198));
let _e7210 = ((((_e1214.member.member * _e7202) + (_e1214.member.member_1 * _e7203)) + (_e1214.member.member_2 * _e7204)) + _e1214.member_1);
let _e7216 = ((((_e1229.member.member * _e7202) + (_e1229.member.member_1 * _e7203)) + (_e1229.member.member_2 * _e7204)) + _e1229.member_1);
let _e7222 = ((((_e1244.member.member * _e7202) + (_e1244.member.member_1 * _e7203)) + (_e1244.member.member_2 * _e7204)) + _e1244.member_1);
let _e7224 = select(_e4195, _e7210, (_e7210 > _e4195));
let _e7226 = select(_e4200, _e7224, (_e7224 < _e4200));
let _e7228 = select(_e4209, _e7216, (_e7216 > _e4209));
let _e7230 = select(_e4214, _e7228, (_e7228 < _e4214));
let _e7232 = select(_e4223, _e7222, (_e7222 > _e4223));
let _e7234 = select(_e4228, _e7232, (_e7232 < _e4228));
if _e4238 {
phi_16175_ = vec3<f32>(_e7226, _e7230, _e7234);
} else {
let _e7236 = (_e7226 + 0.5f);
let _e7237 = (_e4316 - 1f);
let _e7239 = select(0f, _e7236, (_e7236 > 0f));
let _e7241 = select(_e7237, _e7239, (_e7239 < _e7237));
let _e7248 = select(0i, select(select(i32(_e7241), i32(-2147483648), (_e7241 < -2147483600f)), 2147483647i, (_e7241 > 2147483500f)), (_e7241 == _e7241));
let _e7254 = (_e7230 + 0.5f);
let _e7255 = (_e4337 - 1f);
let _e7257 = select(0f, _e7254, (_e7254 > 0f));
let _e7259 = select(_e7255, _e7257, (_e7257 < _e7255));
let _e7266 = select(0i, select(select(i32(_e7259), i32(-2147483648), (_e7259 < -2147483600f)), 2147483647i, (_e7259 > 2147483500f)), (_e7259 == _e7259));
let _e7272 = (_e7234 + 0.5f);
let _e7273 = (_e4358 - 1f);
let _e7275 = select(0f, _e7272, (_e7272 > 0f));
let _e7277 = select(_e7273, _e7275, (_e7275 < _e7273));
let _e7284 = select(0i, select(select(i32(_e7277), i32(-2147483648), (_e7277 < -2147483600f)), 2147483647i, (_e7277 > 2147483500f)), (_e7277 == _e7277));
phi_16175_ = vec3<f32>(f32((_e7248 - select(0i, 1i, (_e7241 < f32(_e7248))))), f32((_e7266 - select(0i, 1i, (_e7259 < f32(_e7266))))), f32((_e7284 - select(0i, 1i, (_e7277 < f32(_e7284))))));
}
let _e7292 = phi_16175_;
let _e7295 = select(-1f, _e7292.x, (_e7292.x > -1f));
let _e7297 = select(_e4316, _e7295, (_e7295 < _e4316));
let _e7304 = select(0i, select(select(i32(_e7297), i32(-2147483648), (_e7297 < -2147483600f)), 2147483647i, (_e7297 > 2147483500f)), (_e7297 == _e7297));
let _e7308 = (_e7304 - select(0i, 1i, (_e7297 < f32(_e7304))));
let _e7311 = select(-1f, _e7292.y, (_e7292.y > -1f));
let _e7313 = select(_e4337, _e7311, (_e7311 < _e4337));
let _e7320 = select(0i, select(select(i32(_e7313), i32(-2147483648), (_e7313 < -2147483600f)), 2147483647i, (_e7313 > 2147483500f)), (_e7313 == _e7313));
let _e7324 = (_e7320 - select(0i, 1i, (_e7313 < f32(_e7320))));
let _e7327 = select(-1f, _e7292.z, (_e7292.z > -1f));
let _e7329 = select(_e4358, _e7327, (_e7327 < _e4358));
let _e7336 = select(0i, select(select(i32(_e7329), i32(-2147483648), (_e7329 < -2147483600f)), 2147483647i, (_e7329 > 2147483500f)), (_e7329 == _e7329));
let _e7340 = (_e7336 - select(0i, 1i, (_e7329 < f32(_e7336))));
let _e7341 = (_e7308 + 1i);
let _e7342 = (_e7324 + 1i);
let _e7343 = (_e7340 + 1i);
let _e7353 = ((_e7341 >> bitcast<u32>(4i)) + (_e4390 * ((_e7342 >> bitcast<u32>(4i)) + (_e4396 * (_e7343 >> bitcast<u32>(4i))))));
let _e7355 = select(_e4408, _e7353, (_e7353 < _e4408));
let _e7361 = global_2.member[bitcast<u32>(select(0i, _e7355, (_e7355 > 0i)))];
let _e7363 = (_e7341 & 15i);
let _e7366 = ((_e7342 & 15i) * _e4377);
let _e7368 = (bitcast<i32>(_e7361) + ((_e7343 & 15i) * _e4381));
let _e7372 = (_e7366 + _e4377);
let _e7373 = (_e7366 + _e4428);
let _e7374 = (_e7368 + _e4381);
let _e7375 = (_e7368 + _e4431);
local_2 = type_30(array<i32, 4>(_e7363, (_e7363 + 1i), (_e7363 + 2i), (_e7363 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_3 = (_e7292 - vec3<f32>(f32(_e7308), f32(_e7324), f32(_e7340)));
let _e7384 = (_e7374 + _e7372);
let _e7387 = local_2.member[1u];
let _e7388 = (_e7384 + _e7387);
let _e7390 = select(_e4408, _e7388, (_e7388 < _e4408));
let _e7395 = global_2.member[bitcast<u32>(select(0i, _e7390, (_e7390 > 0i)))];
let _e7396 = bitcast<f32>(_e7395);
let _e7399 = local_2.member[2u];
let _e7400 = (_e7384 + _e7399);
let _e7402 = select(_e4408, _e7400, (_e7400 < _e4408));
let _e7407 = global_2.member[bitcast<u32>(select(0i, _e7402, (_e7402 > 0i)))];
let _e7409 = local_3[0u];
let _e7412 = (_e7396 + ((bitcast<f32>(_e7407) - _e7396) * _e7409));
let _e7413 = (_e7374 + _e7373);
let _e7414 = local_2.member[1u];
let _e7415 = (_e7413 + _e7414);
let _e7417 = select(_e4408, _e7415, (_e7415 < _e4408));
let _e7422 = global_2.member[bitcast<u32>(select(0i, _e7417, (_e7417 > 0i)))];
let _e7423 = bitcast<f32>(_e7422);
let _e7424 = local_2.member[2u];
let _e7425 = (_e7413 + _e7424);
let _e7427 = select(_e4408, _e7425, (_e7425 < _e4408));
let _e7432 = global_2.member[bitcast<u32>(select(0i, _e7427, (_e7427 > 0i)))];
let _e7434 = local_3[0u];
let _e7439 = local_3[1u];
let _e7442 = (_e7412 + (((_e7423 + ((bitcast<f32>(_e7432) - _e7423) * _e7434)) - _e7412) * _e7439));
let _e7443 = (_e7375 + _e7372);
let _e7444 = local_2.member[1u];
let _e7445 = (_e7443 + _e7444);
let _e7447 = select(_e4408, _e7445, (_e7445 < _e4408));
let _e7452 = global_2.member[bitcast<u32>(select(0i, _e7447, (_e7447 > 0i)))];
let _e7453 = bitcast<f32>(_e7452);
let _e7454 = local_2.member[2u];
let _e7455 = (_e7443 + _e7454);
let _e7457 = select(_e4408, _e7455, (_e7455 < _e4408));
let _e7462 = global_2.member[bitcast<u32>(select(0i, _e7457, (_e7457 > 0i)))];
let _e7464 = local_3[0u];
let _e7467 = (_e7453 + ((bitcast<f32>(_e7462) - _e7453) * _e7464));
let _e7468 = (_e7375 + _e7373);
let _e7469 = local_2.member[1u];
let _e7470 = (_e7468 + _e7469);
let _e7472 = select(_e4408, _e7470, (_e7470 < _e4408));
let _e7477 = global_2.member[bitcast<u32>(select(0i, _e7472, (_e7472 > 0i)))];
let _e7478 = bitcast<f32>(_e7477);
let _e7479 = local_2.member[2u];
let _e7480 = (_e7468 + _e7479);
let _e7482 = select(_e4408, _e7480, (_e7480 < _e4408));
let _e7487 = global_2.member[bitcast<u32>(select(0i, _e7482, (_e7482 > 0i)))];
let _e7489 = local_3[0u];
let _e7493 = local_3[1u];
let _e7498 = local_3[2u];
let _e7503 = (((_e7442 + (((_e7467 + (((_e7478 + ((bitcast<f32>(_e7487) - _e7478) * _e7489)) - _e7467) * _e7493)) - _e7442) * _e7498)) - _e4562) * _e4566);
let _e7505 = select(_e4569, _e7503, (_e7503 > _e4569));
local = select(1e9f, _e7505, (_e7505 < 1e9f));
let _e7508 = local;
local_1 = _e7508;
let _e7509 = local_1;
let _e7511 = (bitcast<i32>(_e179) - 1i);
let _e7513 = select(_e7511, 263197i, (263197i < _e7511));
let _e7518 = global_3.member[bitcast<u32>(select(0i, _e7513, (_e7513 > 0i)))];
let _e7521 = select(_e7511, 263198i, (263198i < _e7511));
let _e7526 = global_3.member[bitcast<u32>(select(0i, _e7521, (_e7521 > 0i)))];
let _e7529 = select(_e7511, 263199i, (263199i < _e7511));
let _e7534 = global_3.member[bitcast<u32>(select(0i, _e7529, (_e7529 > 0i)))];
let _e7535 = bitcast<f32>(_e7534);
let _e7537 = ((_e7509 - bitcast<f32>(_e7518)) * bitcast<f32>(_e7526));
let _e7539 = select(0f, _e7537, (_e7537 > 0f));
let _e7542 = local_1;
let _e7544 = select(_e7511, 263200i, (263200i < _e7511));
let _e7549 = global_3.member[bitcast<u32>(select(0i, _e7544, (_e7544 > 0i)))];
let _e7552 = select(_e7511, 263201i, (263201i < _e7511));
let _e7557 = global_3.member[bitcast<u32>(select(0i, _e7552, (_e7552 > 0i)))];
let _e7560 = select(_e7511, 263202i, (263202i < _e7511));
let _e7565 = global_3.member[bitcast<u32>(select(0i, _e7560, (_e7560 > 0i)))];
let _e7566 = bitcast<f32>(_e7565);
let _e7568 = ((_e7542 - bitcast<f32>(_e7549)) * bitcast<f32>(_e7557));
let _e7570 = select(0f, _e7568, (_e7568 > 0f));
let _e7574 = local_1;
let _e7576 = select(_e7511, 263203i, (263203i < _e7511));
let _e7581 = global_3.member[bitcast<u32>(select(0i, _e7576, (_e7576 > 0i)))];
let _e7584 = select(_e7511, 263204i, (263204i < _e7511));
let _e7589 = global_3.member[bitcast<u32>(select(0i, _e7584, (_e7584 > 0i)))];
let _e7592 = select(_e7511, 263205i, (263205i < _e7511));
let _e7597 = global_3.member[bitcast<u32>(select(0i, _e7592, (_e7592 > 0i)))];
let _e7598 = bitcast<f32>(_e7597);
let _e7600 = ((_e7574 - bitcast<f32>(_e7581)) * bitcast<f32>(_e7589));
let _e7602 = select(0f, _e7600, (_e7600 > 0f));
let _e7605 = local_1;
let _e7607 = select(_e7511, 263206i, (263206i < _e7511));
let _e7612 = global_3.member[bitcast<u32>(select(0i, _e7607, (_e7607 > 0i)))];
let _e7615 = select(_e7511, 263207i, (263207i < _e7511));
let _e7620 = global_3.member[bitcast<u32>(select(0i, _e7615, (_e7615 > 0i)))];
let _e7623 = select(_e7511, 263208i, (263208i < _e7511));
let _e7628 = global_3.member[bitcast<u32>(select(0i, _e7623, (_e7623 > 0i)))];
let _e7629 = bitcast<f32>(_e7628);
let _e7631 = ((_e7605 - bitcast<f32>(_e7612)) * bitcast<f32>(_e7620));
let _e7633 = select(0f, _e7631, (_e7631 > 0f));
let _e7637 = ((select(_e7535, _e7539, (_e7539 < _e7535)) + select(_e7566, _e7570, (_e7570 < _e7566))) + (select(_e7598, _e7602, (_e7602 < _e7598)) + select(_e7629, _e7633, (_e7633 < _e7629))));
let _e7639 = select(0f, _e7637, (_e7637 > 0f));
let _e7641 = select(1023f, _e7639, (_e7639 < 1023f));
let _e7648 = select(0i, select(select(i32(_e7641), i32(-2147483648), (_e7641 < -2147483600f)), 2147483647i, (_e7641 > 2147483500f)), (_e7641 == _e7641));
let _e7652 = (_e7648 - select(0i, 1i, (_e7641 < f32(_e7648))));
let _e7653 = (262147i + _e7652);
let _e7655 = select(_e7511, _e7653, (_e7653 < _e7511));
let _e7661 = global_3.member[bitcast<u32>(select(0i, _e7655, (_e7655 > 0i)))];
let _e7671 = select(_e7511, 262146i, (262146i < _e7511));
let _e7677 = global_3.member[bitcast<u32>(select(0i, _e7671, (_e7671 > 0i)))];
let _e7681 = select(_e7511, 262144i, (262144i < _e7511));
let _e7687 = global_3.member[bitcast<u32>(select(0i, _e7681, (_e7681 > 0i)))];
let _e7690 = select(_e7511, 262145i, (262145i < _e7511));
let _e7696 = global_3.member[bitcast<u32>(select(0i, _e7690, (_e7690 > 0i)))];
let _e7703 = ((bitcast<f32>(_e7687) + (f32(bitcast<i32>((_e7661 >> bitcast<u32>(12u)))) * bitcast<f32>(_e7696))) + ((f32((bitcast<i32>((_e7661 & 4095u)) - 2048i)) * bitcast<f32>(_e7677)) * (_e7637 - f32(_e7652))));
let _e7707 = select(_e7167.member_6.x, _e7178.x, _e7172);
let _e7710 = select(_e7167.member_6.y, _e7178.y, _e7172);
let _e7713 = select(_e7167.member_6.z, _e7178.z, _e7172);
let _e7714 = select(1f, _e7703, _e7171);
let _e7719 = (((_e7707 * _e7707) + (_e7710 * _e7710)) + (_e7713 * _e7713));
let _e7722 = sqrt(select(0f, _e7719, (_e7719 > 0f)));
let _e7725 = (1f / select(1e-20f, _e7722, (_e7722 > 1e-20f)));
let _e7726 = (_e7707 * _e7725);
let _e7727 = (_e7710 * _e7725);
let _e7728 = (_e7713 * _e7725);
let _e7733 = (((_e247 * _e7726) + (_e258 * _e7727)) + (_e269 * _e7728));
let _e7738 = (((_e247 * _e247) + (_e258 * _e258)) + (_e269 * _e269));
let _e7740 = ((_e7714 * _e7714) - _e7738);
let _e7741 = (_e7733 * _e7733);
let _e7742 = (_e7741 + _e7740);
let _e7745 = sqrt(select(0f, _e7742, (_e7742 > 0f)));
let _e7749 = (_e7742 <= 0f);
let _e7752 = select((select(_e7745, -(_e7745), (_e7733 < 0f)) - _e7733), (-2f * _e7733), _e7749);
let _e7753 = (_e7740 == 0f);
let _e7764 = (_e7749 && (_e7740 != 0f));
let _e7770 = (!(_e7172) && (_e7764 || (_e7741 < ((0.1f * 0.1f) * _e7738))));
let _e7772 = select(1e-12f, _e7738, (_e7738 > 1e-12f));
let _e7776 = (_e7714 / sqrt(select(0f, _e7772, (_e7772 > 0f))));
let _e7788 = ((_e7172 || (bitcast<f32>((bitcast<u32>(_e7167.member_4) & 2147483647u)) < select(1f, _e7193, (_e7193 < 1f)))) && (_e7703 != 1f));
let _e7789 = select(_e247, select(select(select((_e247 + (_e7726 * _e7752)), _e247, _e7753), _e247, _e7764), (_e247 * _e7776), _e7770), _e7788);
let _e7790 = select(_e258, select(select(select((_e258 + (_e7727 * _e7752)), _e258, _e7753), _e258, _e7764), (_e258 * _e7776), _e7770), _e7788);
let _e7791 = select(_e269, select(select(select((_e269 + (_e7728 * _e7752)), _e269, _e7753), _e269, _e7764), (_e269 * _e7776), _e7770), _e7788);
let _e7803 = global_1.member.member_7.member_2;
let _e7806 = (_e7803 / select(1e-6f, _e7791, (_e7791 > 1e-6f)));
let _e7810 = (_e1205 + (_e7789 * _e7806));
let _e7811 = (_e1210 + (_e7790 * _e7806));
let _e7812 = (_e1199 + (_e7791 * _e7806));
let _e7818 = ((((_e1214.member.member * _e7810) + (_e1214.member.member_1 * _e7811)) + (_e1214.member.member_2 * _e7812)) + _e1214.member_1);
let _e7824 = ((((_e1229.member.member * _e7810) + (_e1229.member.member_1 * _e7811)) + (_e1229.member.member_2 * _e7812)) + _e1229.member_1);
let _e7830 = ((((_e1244.member.member * _e7810) + (_e1244.member.member_1 * _e7811)) + (_e1244.member.member_2 * _e7812)) + _e1244.member_1);
let _e7831 = (_e4195 - _e7818);
let _e7832 = -(_e6609);
let _e7835 = (_e6609 - _e7831);
let _e7836 = (_e7831 - _e6609);
let _e7838 = select(_e7836, _e7835, (_e7835 > _e7836));
let _e7841 = (select(_e7832, _e6609, (_e6609 > _e7832)) / select(1e-30f, _e7838, (_e7838 > 1e-30f)));
let _e7844 = select(0f, select(2f, _e7841, (_e7831 < 0f)), _e6624);
let _e7847 = select(2f, select(0f, _e7841, _e6621), (_e7831 > 0f));
let _e7851 = ((_e7844 > -1f) || ((_e7844 == -1f) && _e6643));
let _e7852 = (_e7847 < 2f);
let _e7853 = select(-1f, _e7844, _e7851);
let _e7857 = select(2f, _e7847, _e7852);
let _e7862 = select(-1e30f, _e7831, (_e7831 > -1e30f));
let _e7866 = (_e7818 - _e4200);
let _e7867 = -(_e6649);
let _e7870 = (_e6649 - _e7866);
let _e7871 = (_e7866 - _e6649);
let _e7873 = select(_e7871, _e7870, (_e7870 > _e7871));
let _e7876 = (select(_e7867, _e6649, (_e6649 > _e7867)) / select(1e-30f, _e7873, (_e7873 > 1e-30f)));
let _e7879 = select(0f, select(2f, _e7876, (_e7866 < 0f)), _e6664);
let _e7882 = select(2f, select(0f, _e7876, _e6661), (_e7866 > 0f));
let _e7886 = ((_e7879 > _e7853) || ((_e7879 == _e7853) && _e6683));
let _e7887 = (_e7882 < _e7857);
let _e7888 = select(_e7853, _e7879, _e7886);
let _e7892 = select(_e7857, _e7882, _e7887);
let _e7897 = select(_e7862, _e7866, (_e7866 > _e7862));
let _e7901 = (_e4209 - _e7824);
let _e7902 = -(_e6688);
let _e7905 = (_e6688 - _e7901);
let _e7906 = (_e7901 - _e6688);
let _e7908 = select(_e7906, _e7905, (_e7905 > _e7906));
let _e7911 = (select(_e7902, _e6688, (_e6688 > _e7902)) / select(1e-30f, _e7908, (_e7908 > 1e-30f)));
let _e7914 = select(0f, select(2f, _e7911, (_e7901 < 0f)), _e6703);
let _e7917 = select(2f, select(0f, _e7911, _e6700), (_e7901 > 0f));
let _e7921 = ((_e7914 > _e7888) || ((_e7914 == _e7888) && _e6722));
let _e7922 = (_e7917 < _e7892);
let _e7923 = select(_e7888, _e7914, _e7921);
let _e7927 = select(_e7892, _e7917, _e7922);
let _e7932 = select(_e7897, _e7901, (_e7901 > _e7897));
let _e7936 = (_e7824 - _e4214);
let _e7937 = -(_e6728);
let _e7940 = (_e6728 - _e7936);
let _e7941 = (_e7936 - _e6728);
let _e7943 = select(_e7941, _e7940, (_e7940 > _e7941));
let _e7946 = (select(_e7937, _e6728, (_e6728 > _e7937)) / select(1e-30f, _e7943, (_e7943 > 1e-30f)));
let _e7949 = select(0f, select(2f, _e7946, (_e7936 < 0f)), _e6743);
let _e7952 = select(2f, select(0f, _e7946, _e6740), (_e7936 > 0f));
let _e7956 = ((_e7949 > _e7923) || ((_e7949 == _e7923) && _e6762));
let _e7957 = (_e7952 < _e7927);
let _e7958 = select(_e7923, _e7949, _e7956);
let _e7962 = select(_e7927, _e7952, _e7957);
let _e7967 = select(_e7932, _e7936, (_e7936 > _e7932));
let _e7971 = (_e4223 - _e7830);
let _e7972 = -(_e6767);
let _e7975 = (_e6767 - _e7971);
let _e7976 = (_e7971 - _e6767);
let _e7978 = select(_e7976, _e7975, (_e7975 > _e7976));
let _e7981 = (select(_e7972, _e6767, (_e6767 > _e7972)) / select(1e-30f, _e7978, (_e7978 > 1e-30f)));
let _e7984 = select(0f, select(2f, _e7981, (_e7971 < 0f)), _e6782);
let _e7987 = select(2f, select(0f, _e7981, _e6779), (_e7971 > 0f));
let _e7991 = ((_e7984 > _e7958) || ((_e7984 == _e7958) && _e6801));
let _e7992 = (_e7987 < _e7962);
let _e7993 = select(_e7958, _e7984, _e7991);
let _e7997 = select(_e7962, _e7987, _e7992);
let _e8002 = select(_e7967, _e7971, (_e7971 > _e7967));
let _e8006 = (_e7830 - _e4228);
let _e8007 = -(_e6807);
let _e8010 = (_e6807 - _e8006);
let _e8011 = (_e8006 - _e6807);
let _e8013 = select(_e8011, _e8010, (_e8010 > _e8011));
let _e8016 = (select(_e8007, _e6807, (_e6807 > _e8007)) / select(1e-30f, _e8013, (_e8013 > 1e-30f)));
let _e8019 = select(0f, select(2f, _e8016, (_e8006 < 0f)), _e6822);
let _e8022 = select(2f, select(0f, _e8016, _e6819), (_e8006 > 0f));
let _e8026 = ((_e8019 > _e7993) || ((_e8019 == _e7993) && _e6843));
let _e8027 = (_e8022 < _e7997);
let _e8028 = select(_e7993, _e8019, _e8026);
let _e8029 = select(select(select(select(select(select(0f, _e6589.member, _e7851), _e6589.member, _e7886), _e6597.member, _e7921), _e6597.member, _e7956), _e6605.member, _e7991), _e6605.member, _e8026);
let _e8030 = select(select(select(select(select(select(0f, _e6589.member_1, _e7851), _e6589.member_1, _e7886), _e6597.member_1, _e7921), _e6597.member_1, _e7956), _e6605.member_1, _e7991), _e6605.member_1, _e8026);
let _e8031 = select(select(select(select(select(select(1f, _e6589.member_2, _e7851), _e6589.member_2, _e7886), _e6597.member_2, _e7921), _e6597.member_2, _e7956), _e6605.member_2, _e7991), _e6605.member_2, _e8026);
let _e8033 = select(_e7997, _e8022, _e8027);
let _e8034 = select(select(select(select(select(select(0f, _e6589.member, _e7852), _e6589.member, _e7887), _e6597.member, _e7922), _e6597.member, _e7957), _e6605.member, _e7992), _e6605.member, _e8027);
let _e8035 = select(select(select(select(select(select(0f, _e6589.member_1, _e7852), _e6589.member_1, _e7887), _e6597.member_1, _e7922), _e6597.member_1, _e7957), _e6605.member_1, _e7992), _e6605.member_1, _e8027);
let _e8036 = select(select(select(select(select(select(1f, _e6589.member_2, _e7852), _e6589.member_2, _e7887), _e6597.member_2, _e7922), _e6597.member_2, _e7957), _e6605.member_2, _e7992), _e6605.member_2, _e8027);
let _e8039 = select(_e8002, _e8006, (_e8006 > _e8002));
let _e8040 = select(select(select(select(select(select(0f, _e6589.member, _e6643), _e6589.member, _e6683), _e6597.member, _e6722), _e6597.member, _e6762), _e6605.member, _e6801), _e6605.member, _e6843);
let _e8041 = select(select(select(select(select(select(0f, _e6589.member_1, _e6643), _e6589.member_1, _e6683), _e6597.member_1, _e6722), _e6597.member_1, _e6762), _e6605.member_1, _e6801), _e6605.member_1, _e6843);
let _e8042 = select(select(select(select(select(select(1f, _e6589.member_2, _e6643), _e6589.member_2, _e6683), _e6597.member_2, _e6722), _e6597.member_2, _e6762), _e6605.member_2, _e6801), _e6605.member_2, _e6843);
if _e4581 {
phi_18633_ = type_37(_e8028, vec3<f32>(_e8029, _e8030, _e8031), _e8033, vec3<f32>(_e8034, _e8035, _e8036), _e6844, _e8039, vec3<f32>(_e8040, _e8041, _e8042));
} else {
let _e8048 = global_1.member.member_16.member_1;
let _e8049 = (_e8048 != 0u);
let _e8053 = global_1.member.member_16.member;
let _e8073 = select(-1e6f, (((((_e8053.member.member * _e1205) + (_e8053.member.member_1 * _e1210)) + (_e8053.member.member_2 * _e1199)) + _e8053.member_1) * _e7192), _e8049);
let _e8074 = select(-1e6f, (((((_e8053.member.member * _e7810) + (_e8053.member.member_1 * _e7811)) + (_e8053.member.member_2 * _e7812)) + _e8053.member_1) * _e7192), _e8049);
let _e8079 = global_1.member.member_16.member.member;
let _e8083 = -(_e8073);
let _e8086 = (_e8073 - _e8074);
let _e8087 = (_e8074 - _e8073);
let _e8089 = select(_e8087, _e8086, (_e8086 > _e8087));
let _e8092 = (select(_e8083, _e8073, (_e8073 > _e8083)) / select(1e-30f, _e8089, (_e8089 > 1e-30f)));
let _e8096 = select(0f, select(2f, _e8092, (_e8074 < 0f)), (_e8073 > 0f));
let _e8100 = select(2f, select(0f, _e8092, (_e8073 < 0f)), (_e8074 > 0f));
let _e8101 = (_e8073 > _e6844);
let _e8105 = ((_e8096 > _e8028) || ((_e8096 == _e8028) && _e8101));
let _e8106 = (_e8100 < _e8033);
let _e8107 = select(_e8028, _e8096, _e8105);
let _e8111 = select(_e8033, _e8100, _e8106);
let _e8115 = select(_e6844, _e8073, _e8101);
let _e8117 = select(_e8039, _e8074, (_e8074 > _e8039));
let _e8124 = global_1.member.member_17.member_1;
let _e8125 = (_e8124 != 0u);
let _e8129 = global_1.member.member_17.member;
let _e8149 = select(-1e6f, (((((_e8129.member.member * _e1205) + (_e8129.member.member_1 * _e1210)) + (_e8129.member.member_2 * _e1199)) + _e8129.member_1) * _e7192), _e8125);
let _e8150 = select(-1e6f, (((((_e8129.member.member * _e7810) + (_e8129.member.member_1 * _e7811)) + (_e8129.member.member_2 * _e7812)) + _e8129.member_1) * _e7192), _e8125);
let _e8155 = global_1.member.member_17.member.member;
let _e8159 = -(_e8149);
let _e8162 = (_e8149 - _e8150);
let _e8163 = (_e8150 - _e8149);
let _e8165 = select(_e8163, _e8162, (_e8162 > _e8163));
let _e8168 = (select(_e8159, _e8149, (_e8149 > _e8159)) / select(1e-30f, _e8165, (_e8165 > 1e-30f)));
let _e8172 = select(0f, select(2f, _e8168, (_e8150 < 0f)), (_e8149 > 0f));
let _e8176 = select(2f, select(0f, _e8168, (_e8149 < 0f)), (_e8150 > 0f));
let _e8177 = (_e8149 > _e8115);
let _e8181 = ((_e8172 > _e8107) || ((_e8172 == _e8107) && _e8177));
let _e8182 = (_e8176 < _e8111);
let _e8183 = select(_e8107, _e8172, _e8181);
let _e8187 = select(_e8111, _e8176, _e8182);
let _e8191 = select(_e8115, _e8149, _e8177);
let _e8193 = select(_e8117, _e8150, (_e8150 > _e8117));
let _e8200 = global_1.member.member_18.member_1;
let _e8201 = (_e8200 != 0u);
let _e8205 = global_1.member.member_18.member;
let _e8225 = select(-1e6f, (((((_e8205.member.member * _e1205) + (_e8205.member.member_1 * _e1210)) + (_e8205.member.member_2 * _e1199)) + _e8205.member_1) * _e7192), _e8201);
let _e8226 = select(-1e6f, (((((_e8205.member.member * _e7810) + (_e8205.member.member_1 * _e7811)) + (_e8205.member.member_2 * _e7812)) + _e8205.member_1) * _e7192), _e8201);
let _e8231 = global_1.member.member_18.member.member;
let _e8235 = -(_e8225);
let _e8238 = (_e8225 - _e8226);
let _e8239 = (_e8226 - _e8225);
let _e8241 = select(_e8239, _e8238, (_e8238 > _e8239));
let _e8244 = (select(_e8235, _e8225, (_e8225 > _e8235)) / select(1e-30f, _e8241, (_e8241 > 1e-30f)));
let _e8248 = select(0f, select(2f, _e8244, (_e8226 < 0f)), (_e8225 > 0f));
let _e8252 = select(2f, select(0f, _e8244, (_e8225 < 0f)), (_e8226 > 0f));
let _e8253 = (_e8225 > _e8191);
let _e8257 = ((_e8248 > _e8183) || ((_e8248 == _e8183) && _e8253));
let _e8258 = (_e8252 < _e8187);
let _e8259 = select(_e8183, _e8248, _e8257);
let _e8263 = select(_e8187, _e8252, _e8258);
let _e8267 = select(_e8191, _e8225, _e8253);
let _e8269 = select(_e8193, _e8226, (_e8226 > _e8193));
let _e8276 = global_1.member.member_19.member_1;
let _e8277 = (_e8276 != 0u);
let _e8281 = global_1.member.member_19.member;
let _e8301 = select(-1e6f, (((((_e8281.member.member * _e1205) + (_e8281.member.member_1 * _e1210)) + (_e8281.member.member_2 * _e1199)) + _e8281.member_1) * _e7192), _e8277);
let _e8302 = select(-1e6f, (((((_e8281.member.member * _e7810) + (_e8281.member.member_1 * _e7811)) + (_e8281.member.member_2 * _e7812)) + _e8281.member_1) * _e7192), _e8277);
let _e8307 = global_1.member.member_19.member.member;
let _e8311 = -(_e8301);
let _e8314 = (_e8301 - _e8302);
let _e8315 = (_e8302 - _e8301);
let _e8317 = select(_e8315, _e8314, (_e8314 > _e8315));
let _e8320 = (select(_e8311, _e8301, (_e8301 > _e8311)) / select(1e-30f, _e8317, (_e8317 > 1e-30f)));
let _e8324 = select(0f, select(2f, _e8320, (_e8302 < 0f)), (_e8301 > 0f));
let _e8328 = select(2f, select(0f, _e8320, (_e8301 < 0f)), (_e8302 > 0f));
let _e8329 = (_e8301 > _e8267);
let _e8333 = ((_e8324 > _e8259) || ((_e8324 == _e8259) && _e8329));
let _e8334 = (_e8328 < _e8263);
phi_18633_ = type_37(select(_e8259, _e8324, _e8333), vec3<f32>(select(select(select(select(_e8029, _e8079.member, _e8105), _e8155.member, _e8181), _e8231.member, _e8257), _e8307.member, _e8333), select(select(select(select(_e8030, _e8079.member_1, _e8105), _e8155.member_1, _e8181), _e8231.member_1, _e8257), _e8307.member_1, _e8333), select(select(select(select(_e8031, _e8079.member_2, _e8105), _e8155.member_2, _e8181), _e8231.member_2, _e8257), _e8307.member_2, _e8333)), select(_e8263, _e8328, _e8334), vec3<f32>(select(select(select(select(_e8034, _e8079.member, _e8106), _e8155.member, _e8182), _e8231.member, _e8258), _e8307.member, _e8334), select(select(select(select(_e8035, _e8079.member_1, _e8106), _e8155.member_1, _e8182), _e8231.member_1, _e8258), _e8307.member_1, _e8334), select(select(select(select(_e8036, _e8079.member_2, _e8106), _e8155.member_2, _e8182), _e8231.member_2, _e8258), _e8307.member_2, _e8334)), select(_e8267, _e8301, _e8329), select(_e8269, _e8302, (_e8302 > _e8269)), vec3<f32>(select(select(select(select(_e8040, _e8079.member, _e8101), _e8155.member, _e8177), _e8231.member, _e8253), _e8307.member, _e8329), select(select(select(select(_e8041, _e8079.member_1, _e8101), _e8155.member_1, _e8177), _e8231.member_1, _e8253), _e8307.member_1, _e8329), select(select(select(select(_e8042, _e8079.member_2, _e8101), _e8155.member_2, _e8177), _e8231.member_2, _e8253), _e8307.member_2, _e8329)));
}
let _e8354 = phi_18633_;
let _e8363 = global_1.member.member_7.member_4;
let _e8366 = (_e4190.member_4.x * _e4822.member_2);
let _e8368 = (_e4190.member_4.y * _e4822.member_2);
let _e8370 = (_e4190.member_4.z * _e4822.member_2);
let _e8371 = (0.5f * (_e7806 * select(1f, (2f * (1f - _e7180)), (_e7172 && _e7171))));
let _e8375 = (_e7789 + (_e8366 * _e8371));
let _e8376 = (_e7790 + (_e8368 * _e8371));
let _e8377 = (_e7791 + (_e8370 * _e8371));
let _e8379 = (2f * _e7803);
let _e8381 = ((_e8377 * _e8377) + (_e8379 * _e8370));
let _e8385 = (_e8377 + sqrt(select(0f, _e8381, (_e8381 > 0f))));
let _e8389 = (select(0.5f, _e8354.member_2, (_e8354.member_2 < 1f)) * (_e8379 / select(1e-6f, _e8385, (_e8385 > 1e-6f))));
let _e8393 = (_e8375 + (_e8366 * _e8389));
let _e8394 = (_e8376 + (_e8368 * _e8389));
let _e8395 = (_e8377 + (_e8370 * _e8389));
let _e8399 = (_e8363 * _e8363);
let _e8401 = (_e8395 * _e8395);
let _e8409 = (((_e8377 <= 0f) || (_e8381 <= 0f)) || ((_e8395 <= 0f) || (_e8401 <= (_e8399 * (((_e8393 * _e8393) + (_e8394 * _e8394)) + _e8401)))));
let _e8423 = (_e7789 + ((_e4190.member_5.x * _e4822.member_2) * _e7803));
let _e8424 = (_e7790 + ((_e4190.member_5.y * _e4822.member_2) * _e7803));
let _e8425 = (_e7791 + ((_e4190.member_5.z * _e4822.member_2) * _e7803));
let _e8427 = (_e8425 * _e8425);
let _e8436 = ((_e4579 & 1u) != 0u);
let _e8441 = (select(_e8409, ((_e8425 <= 0f) || (_e8427 <= (_e8399 * (((_e8423 * _e8423) + (_e8424 * _e8424)) + _e8427)))), _e8436) || (_e7788 && ((_e7764 && _e7172) || (_e7172 && (_e7791 <= 0f)))));
phi_18785_ = vec3<f32>(select(select(select(_e8393, _e8375, _e8409), _e8423, _e8436), _e247, _e8441), select(select(select(_e8394, _e8376, _e8409), _e8424, _e8436), _e258, _e8441), select(select(select(_e8395, _e8377, _e8409), _e8425, _e8436), _e269, _e8441));
phi_18786_ = select(1f, 0f, _e8441);
} else {
phi_18785_ = vec3<f32>(_e247, _e258, _e269);
phi_18786_ = 1f;
}
let _e8448 = phi_18785_;
let _e8450 = phi_18786_;
let _e8452 = (_e6584 * _e8450);
global_4.member[_e204] = (_e215 * (_e6427.member_2.x * _e8452));
global_4.member[_e216] = (_e225 * (_e6427.member_2.y * _e8452));
global_4.member[_e227] = (_e236 * (_e6427.member_2.z * _e8452));
global_4.member[_e238] = _e8448.x;
global_4.member[_e249] = _e8448.y;
global_4.member[_e260] = _e8448.z;
global_4.member[_e271] = _e280;
global_4.member[_e282] = _e291;
global_4.member[_e293] = _e302;
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
