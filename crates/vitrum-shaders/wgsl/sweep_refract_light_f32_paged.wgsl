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
var phi_1675_: u32;
var phi_2048_: vec3<f32>;
var phi_7180_: type_34;
var phi_7527_: vec3<f32>;
var phi_8841_: vec3<f32>;
var phi_9217_: f32;
var phi_9218_: vec3<f32>;
var phi_9220_: type_35;
var phi_9366_: vec3<f32>;
var phi_10262_: type_36;
var phi_14206_: type_38;
var phi_14604_: f32;
var phi_15929_: type_37;
var phi_15942_: vec3<f32>;
var phi_15943_: f32;
var phi_16173_: vec3<f32>;
var phi_18631_: type_37;
var phi_18783_: vec3<f32>;
var phi_18784_: f32;
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
let _e956 = global_1.member.member_8.member_6;
let _e958 = select(_e493, _e476, (_e476 > _e493));
let _e960 = select(_e500, _e958, (_e958 < _e500));
let _e962 = select(_e508, _e482, (_e482 > _e508));
let _e964 = select(_e516, _e962, (_e962 < _e516));
let _e966 = select(_e524, _e488, (_e488 > _e524));
let _e968 = select(_e532, _e966, (_e966 < _e532));
let _e974 = bitcast<f32>((bitcast<u32>((_e476 - _e440)) & 2147483647u));
let _e977 = bitcast<f32>((bitcast<u32>((_e482 - _e455)) & 2147483647u));
let _e979 = select(_e977, _e974, (_e974 > _e977));
let _e982 = bitcast<f32>((bitcast<u32>((_e488 - _e470)) & 2147483647u));
let _e991 = bitcast<f32>((bitcast<u32>((_e476 - _e960)) & 2147483647u));
let _e994 = bitcast<f32>((bitcast<u32>((_e482 - _e964)) & 2147483647u));
let _e996 = select(_e994, _e991, (_e991 > _e994));
let _e999 = bitcast<f32>((bitcast<u32>((_e488 - _e968)) & 2147483647u));
let _e1007 = global_1.member.member_8.member_3.member;
let _e1008 = (_e960 + 0.5f);
let _e1009 = (_e1007 - 1f);
let _e1011 = select(0f, _e1008, (_e1008 > 0f));
let _e1013 = select(_e1009, _e1011, (_e1011 < _e1009));
let _e1020 = select(0i, select(select(i32(_e1013), i32(-2147483648), (_e1013 < -2147483600f)), 2147483647i, (_e1013 > 2147483500f)), (_e1013 == _e1013));
let _e1028 = global_1.member.member_8.member_14;
let _e1029 = (_e1028 & 31u);
let _e1036 = global_1.member.member_8.member_3.member_1;
let _e1037 = (_e964 + 0.5f);
let _e1038 = (_e1036 - 1f);
let _e1040 = select(0f, _e1037, (_e1037 > 0f));
let _e1042 = select(_e1038, _e1040, (_e1040 < _e1038));
let _e1049 = select(0i, select(select(i32(_e1042), i32(-2147483648), (_e1042 < -2147483600f)), 2147483647i, (_e1042 > 2147483500f)), (_e1042 == _e1042));
let _e1060 = global_1.member.member_8.member_3.member_2;
let _e1061 = (_e968 + 0.5f);
let _e1062 = (_e1060 - 1f);
let _e1064 = select(0f, _e1061, (_e1061 > 0f));
let _e1066 = select(_e1062, _e1064, (_e1064 < _e1062));
let _e1073 = select(0i, select(select(i32(_e1066), i32(-2147483648), (_e1066 < -2147483600f)), 2147483647i, (_e1066 > 2147483500f)), (_e1066 == _e1066));
let _e1084 = global_1.member.member_8.member_11.member;
let _e1090 = global_1.member.member_8.member_11.member_1;
let _e1095 = global_1.member.member_8.member_12;
let _e1101 = ((bitcast<i32>(_e1095) + ((_e1020 - select(0i, 1i, (_e1013 < f32(_e1020)))) >> bitcast<u32>(_e1029))) + (bitcast<i32>(_e1084) * (((_e1049 - select(0i, 1i, (_e1042 < f32(_e1049)))) >> bitcast<u32>(_e1029)) + (bitcast<i32>(_e1090) * ((_e1073 - select(0i, 1i, (_e1066 < f32(_e1073)))) >> bitcast<u32>(_e1029))))));
let _e1103 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e1105 = select(_e1103, _e1101, (_e1101 < _e1103));
let _e1111 = global_5.member[bitcast<u32>(select(0i, _e1105, (_e1105 > 0i)))];
phi_1675_ = select(select(7u, 3u, ((_e809 && (!(_e556) || _e946)) && ((_e848 & 1024u) == 0u))), 1u, (((_e848 & 64u) != 0u) || ((((select(_e982, _e979, (_e979 > _e982)) <= _e956) && ((select(_e999, _e996, (_e996 > _e999)) > _e956) || (_e1111 != 0u))) && true) && ((_e848 & 32u) != 0u))));
} else {
phi_1675_ = 7u;
}
let _e1124 = phi_1675_;
if (_e1124 > 1u) {
let _e1129 = bitcast<i32>(((_e199 * _e307) + _e197));
let _e1132 = (bitcast<i32>(_e181) - 1i);
let _e1134 = select(_e1132, _e1129, (_e1129 < _e1132));
let _e1140 = global_6.member[bitcast<u32>(select(0i, _e1134, (_e1134 > 0i)))];
let _e1141 = (bitcast<i32>(_e312) + _e1129);
let _e1143 = select(_e1132, _e1141, (_e1141 < _e1132));
let _e1149 = global_6.member[bitcast<u32>(select(0i, _e1143, (_e1143 > 0i)))];
let _e1151 = f32(bitcast<i32>(_e197));
let _e1153 = f32(bitcast<i32>(_e199));
let _e1159 = global_1.member.member_7.member;
let _e1163 = global_1.member.member_10.member_8;
let _e1164 = (_e1159 - _e1163);
let _e1168 = global_1.member.member_10.member_2;
let _e1172 = global_1.member.member_10.member_6;
let _e1179 = global_1.member.member_10.member_4;
let _e1181 = ((_e1168 + (_e1172 * _e1164)) + (((_e1151 - _e1140) + 0.5f) * _e1179));
let _e1185 = global_1.member.member_10.member_3;
let _e1189 = global_1.member.member_10.member_7;
let _e1194 = ((_e1185 + (_e1189 * _e1164)) + (((_e1153 - _e1149) + 0.5f) * _e1179));
let _e1198 = global_1.member.member_7.member_1;
let _e1199 = (_e1198 - _e1163);
let _e1204 = ((_e1168 + (_e1172 * _e1199)) + ((_e1151 + 0.5f) * _e1179));
let _e1209 = ((_e1185 + (_e1189 * _e1199)) + ((_e1153 + 0.5f) * _e1179));
let _e1213 = global_1.member.member_8.member;
let _e1224 = ((((_e1213.member.member * _e1181) + (_e1213.member.member_1 * _e1194)) + (_e1213.member.member_2 * _e1159)) + _e1213.member_1);
let _e1228 = global_1.member.member_8.member_1;
let _e1239 = ((((_e1228.member.member * _e1181) + (_e1228.member.member_1 * _e1194)) + (_e1228.member.member_2 * _e1159)) + _e1228.member_1);
let _e1243 = global_1.member.member_8.member_2;
let _e1254 = ((((_e1243.member.member * _e1181) + (_e1243.member.member_1 * _e1194)) + (_e1243.member.member_2 * _e1159)) + _e1243.member_1);
let _e1260 = ((((_e1213.member.member * _e1204) + (_e1213.member.member_1 * _e1209)) + (_e1213.member.member_2 * _e1198)) + _e1213.member_1);
let _e1266 = ((((_e1228.member.member * _e1204) + (_e1228.member.member_1 * _e1209)) + (_e1228.member.member_2 * _e1198)) + _e1228.member_1);
let _e1272 = ((((_e1243.member.member * _e1204) + (_e1243.member.member_1 * _e1209)) + (_e1243.member.member_2 * _e1198)) + _e1243.member_1);
let _e1274 = (_e189.member_2 == 5u);
let _e1280 = ((_e189.member_2 == 2u) || (_e189.member_2 == 7u));
let _e1281 = ((((_e189.member_2 == 1u) || _e1274) || (_e189.member_2 == 6u)) || _e1280);
if _e1281 {
let _e1286 = global_1.member.member_8.member_4.member;
let _e1291 = global_1.member.member_8.member_5.member;
let _e1293 = select(_e1286, _e1260, (_e1260 > _e1286));
let _e1295 = select(_e1291, _e1293, (_e1293 < _e1291));
let _e1300 = global_1.member.member_8.member_4.member_1;
let _e1305 = global_1.member.member_8.member_5.member_1;
let _e1307 = select(_e1300, _e1266, (_e1266 > _e1300));
let _e1309 = select(_e1305, _e1307, (_e1307 < _e1305));
let _e1314 = global_1.member.member_8.member_4.member_2;
let _e1319 = global_1.member.member_8.member_5.member_2;
let _e1321 = select(_e1314, _e1272, (_e1272 > _e1314));
let _e1323 = select(_e1319, _e1321, (_e1321 < _e1319));
let _e1328 = global_1.member.member_8.member_15;
if (_e1328 == 0u) {
phi_2048_ = vec3<f32>(_e1295, _e1309, _e1323);
} else {
let _e1330 = (_e1295 + 0.5f);
let _e1335 = global_1.member.member_8.member_3.member;
let _e1336 = (_e1335 - 1f);
let _e1338 = select(0f, _e1330, (_e1330 > 0f));
let _e1340 = select(_e1336, _e1338, (_e1338 < _e1336));
let _e1347 = select(0i, select(select(i32(_e1340), i32(-2147483648), (_e1340 < -2147483600f)), 2147483647i, (_e1340 > 2147483500f)), (_e1340 == _e1340));
let _e1353 = (_e1309 + 0.5f);
let _e1358 = global_1.member.member_8.member_3.member_1;
let _e1359 = (_e1358 - 1f);
let _e1361 = select(0f, _e1353, (_e1353 > 0f));
let _e1363 = select(_e1359, _e1361, (_e1361 < _e1359));
let _e1370 = select(0i, select(select(i32(_e1363), i32(-2147483648), (_e1363 < -2147483600f)), 2147483647i, (_e1363 > 2147483500f)), (_e1363 == _e1363));
let _e1376 = (_e1323 + 0.5f);
let _e1381 = global_1.member.member_8.member_3.member_2;
let _e1382 = (_e1381 - 1f);
let _e1384 = select(0f, _e1376, (_e1376 > 0f));
let _e1386 = select(_e1382, _e1384, (_e1384 < _e1382));
let _e1393 = select(0i, select(select(i32(_e1386), i32(-2147483648), (_e1386 < -2147483600f)), 2147483647i, (_e1386 > 2147483500f)), (_e1386 == _e1386));
phi_2048_ = vec3<f32>(f32((_e1347 - select(0i, 1i, (_e1340 < f32(_e1347))))), f32((_e1370 - select(0i, 1i, (_e1363 < f32(_e1370))))), f32((_e1393 - select(0i, 1i, (_e1386 < f32(_e1393))))));
}
let _e1401 = phi_2048_;
let _e1407 = global_1.member.member_8.member_3.member;
let _e1409 = select(-1f, _e1401.x, (_e1401.x > -1f));
let _e1411 = select(_e1407, _e1409, (_e1409 < _e1407));
let _e1418 = select(0i, select(select(i32(_e1411), i32(-2147483648), (_e1411 < -2147483600f)), 2147483647i, (_e1411 > 2147483500f)), (_e1411 == _e1411));
let _e1422 = (_e1418 - select(0i, 1i, (_e1411 < f32(_e1418))));
let _e1428 = global_1.member.member_8.member_3.member_1;
let _e1430 = select(-1f, _e1401.y, (_e1401.y > -1f));
let _e1432 = select(_e1428, _e1430, (_e1430 < _e1428));
let _e1439 = select(0i, select(select(i32(_e1432), i32(-2147483648), (_e1432 < -2147483600f)), 2147483647i, (_e1432 > 2147483500f)), (_e1432 == _e1432));
let _e1443 = (_e1439 - select(0i, 1i, (_e1432 < f32(_e1439))));
let _e1449 = global_1.member.member_8.member_3.member_2;
let _e1451 = select(-1f, _e1401.z, (_e1401.z > -1f));
let _e1453 = select(_e1449, _e1451, (_e1451 < _e1449));
let _e1460 = select(0i, select(select(i32(_e1453), i32(-2147483648), (_e1453 < -2147483600f)), 2147483647i, (_e1453 > 2147483500f)), (_e1453 == _e1453));
let _e1464 = (_e1460 - select(0i, 1i, (_e1453 < f32(_e1460))));
let _e1468 = global_1.member.member_8.member_9;
let _e1472 = global_1.member.member_8.member_10;
let _e1473 = (_e1422 + 1i);
let _e1474 = (_e1443 + 1i);
let _e1475 = (_e1464 + 1i);
let _e1480 = global_1.member.member_8.member_13.member;
let _e1486 = global_1.member.member_8.member_13.member_1;
let _e1497 = ((_e1473 >> bitcast<u32>(4i)) + (bitcast<i32>(_e1480) * ((_e1474 >> bitcast<u32>(4i)) + (bitcast<i32>(_e1486) * (_e1475 >> bitcast<u32>(4i))))));
let _e1499 = (bitcast<i32>(_e174) - 1i);
let _e1501 = select(_e1499, _e1497, (_e1497 < _e1499));
let _e1507 = global_2.member[bitcast<u32>(select(0i, _e1501, (_e1501 > 0i)))];
let _e1509 = (_e1473 & 15i);
let _e1512 = ((_e1474 & 15i) * _e1468);
let _e1514 = (bitcast<i32>(_e1507) + ((_e1475 & 15i) * _e1472));
let _e1518 = (_e1512 + _e1468);
let _e1520 = (_e1512 + (2i * _e1468));
let _e1522 = (_e1512 + (3i * _e1468));
let _e1523 = (_e1514 + _e1472);
let _e1525 = (_e1514 + (2i * _e1472));
let _e1527 = (_e1514 + (3i * _e1472));
local_28 = type_30(array<i32, 4>(_e1509, (_e1509 + 1i), (_e1509 + 2i), (_e1509 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_29 = (_e1401 - vec3<f32>(f32(_e1422), f32(_e1443), f32(_e1464)));
let _e1536 = (_e1523 + _e1518);
let _e1539 = local_28.member[0u];
let _e1540 = (_e1536 + _e1539);
let _e1542 = select(_e1499, _e1540, (_e1540 < _e1499));
let _e1547 = global_2.member[bitcast<u32>(select(0i, _e1542, (_e1542 > 0i)))];
let _e1548 = bitcast<f32>(_e1547);
let _e1551 = local_28.member[1u];
let _e1552 = (_e1536 + _e1551);
let _e1554 = select(_e1499, _e1552, (_e1552 < _e1499));
let _e1559 = global_2.member[bitcast<u32>(select(0i, _e1554, (_e1554 > 0i)))];
let _e1560 = bitcast<f32>(_e1559);
let _e1563 = local_28.member[2u];
let _e1564 = (_e1536 + _e1563);
let _e1566 = select(_e1499, _e1564, (_e1564 < _e1499));
let _e1571 = global_2.member[bitcast<u32>(select(0i, _e1566, (_e1566 > 0i)))];
let _e1572 = bitcast<f32>(_e1571);
let _e1575 = local_28.member[3u];
let _e1576 = (_e1536 + _e1575);
let _e1578 = select(_e1499, _e1576, (_e1576 < _e1499));
let _e1583 = global_2.member[bitcast<u32>(select(0i, _e1578, (_e1578 > 0i)))];
let _e1585 = local_29[0u];
let _e1588 = (_e1548 + ((_e1560 - _e1548) * _e1585));
let _e1589 = local_29[0u];
let _e1592 = (_e1560 + ((_e1572 - _e1560) * _e1589));
let _e1593 = local_29[0u];
let _e1596 = (_e1572 + ((bitcast<f32>(_e1583) - _e1572) * _e1593));
let _e1597 = (_e1523 + _e1520);
let _e1598 = local_28.member[0u];
let _e1599 = (_e1597 + _e1598);
let _e1601 = select(_e1499, _e1599, (_e1599 < _e1499));
let _e1606 = global_2.member[bitcast<u32>(select(0i, _e1601, (_e1601 > 0i)))];
let _e1607 = bitcast<f32>(_e1606);
let _e1608 = local_28.member[1u];
let _e1609 = (_e1597 + _e1608);
let _e1611 = select(_e1499, _e1609, (_e1609 < _e1499));
let _e1616 = global_2.member[bitcast<u32>(select(0i, _e1611, (_e1611 > 0i)))];
let _e1617 = bitcast<f32>(_e1616);
let _e1618 = local_28.member[2u];
let _e1619 = (_e1597 + _e1618);
let _e1621 = select(_e1499, _e1619, (_e1619 < _e1499));
let _e1626 = global_2.member[bitcast<u32>(select(0i, _e1621, (_e1621 > 0i)))];
let _e1627 = bitcast<f32>(_e1626);
let _e1628 = local_28.member[3u];
let _e1629 = (_e1597 + _e1628);
let _e1631 = select(_e1499, _e1629, (_e1629 < _e1499));
let _e1636 = global_2.member[bitcast<u32>(select(0i, _e1631, (_e1631 > 0i)))];
let _e1638 = local_29[0u];
let _e1642 = local_29[0u];
let _e1645 = (_e1617 + ((_e1627 - _e1617) * _e1642));
let _e1646 = local_29[0u];
let _e1650 = (_e1525 + _e1518);
let _e1651 = local_28.member[0u];
let _e1652 = (_e1650 + _e1651);
let _e1654 = select(_e1499, _e1652, (_e1652 < _e1499));
let _e1659 = global_2.member[bitcast<u32>(select(0i, _e1654, (_e1654 > 0i)))];
let _e1660 = bitcast<f32>(_e1659);
let _e1661 = local_28.member[1u];
let _e1662 = (_e1650 + _e1661);
let _e1664 = select(_e1499, _e1662, (_e1662 < _e1499));
let _e1669 = global_2.member[bitcast<u32>(select(0i, _e1664, (_e1664 > 0i)))];
let _e1670 = bitcast<f32>(_e1669);
let _e1671 = local_28.member[2u];
let _e1672 = (_e1650 + _e1671);
let _e1674 = select(_e1499, _e1672, (_e1672 < _e1499));
let _e1679 = global_2.member[bitcast<u32>(select(0i, _e1674, (_e1674 > 0i)))];
let _e1680 = bitcast<f32>(_e1679);
let _e1681 = local_28.member[3u];
let _e1682 = (_e1650 + _e1681);
let _e1684 = select(_e1499, _e1682, (_e1682 < _e1499));
let _e1689 = global_2.member[bitcast<u32>(select(0i, _e1684, (_e1684 > 0i)))];
let _e1691 = local_29[0u];
let _e1694 = (_e1660 + ((_e1670 - _e1660) * _e1691));
let _e1695 = local_29[0u];
let _e1698 = (_e1670 + ((_e1680 - _e1670) * _e1695));
let _e1699 = local_29[0u];
let _e1702 = (_e1680 + ((bitcast<f32>(_e1689) - _e1680) * _e1699));
let _e1703 = (_e1525 + _e1520);
let _e1704 = local_28.member[0u];
let _e1705 = (_e1703 + _e1704);
let _e1707 = select(_e1499, _e1705, (_e1705 < _e1499));
let _e1712 = global_2.member[bitcast<u32>(select(0i, _e1707, (_e1707 > 0i)))];
let _e1713 = bitcast<f32>(_e1712);
let _e1714 = local_28.member[1u];
let _e1715 = (_e1703 + _e1714);
let _e1717 = select(_e1499, _e1715, (_e1715 < _e1499));
let _e1722 = global_2.member[bitcast<u32>(select(0i, _e1717, (_e1717 > 0i)))];
let _e1723 = bitcast<f32>(_e1722);
let _e1724 = local_28.member[2u];
let _e1725 = (_e1703 + _e1724);
let _e1727 = select(_e1499, _e1725, (_e1725 < _e1499));
let _e1732 = global_2.member[bitcast<u32>(select(0i, _e1727, (_e1727 > 0i)))];
let _e1733 = bitcast<f32>(_e1732);
let _e1734 = local_28.member[3u];
let _e1735 = (_e1703 + _e1734);
let _e1737 = select(_e1499, _e1735, (_e1735 < _e1499));
let _e1742 = global_2.member[bitcast<u32>(select(0i, _e1737, (_e1737 > 0i)))];
let _e1744 = local_29[0u];
let _e1748 = local_29[0u];
let _e1751 = (_e1723 + ((_e1733 - _e1723) * _e1748));
let _e1752 = local_29[0u];
let _e1756 = (_e1523 + _e1512);
let _e1757 = local_28.member[1u];
let _e1758 = (_e1756 + _e1757);
let _e1760 = select(_e1499, _e1758, (_e1758 < _e1499));
let _e1765 = global_2.member[bitcast<u32>(select(0i, _e1760, (_e1760 > 0i)))];
let _e1766 = bitcast<f32>(_e1765);
let _e1767 = local_28.member[2u];
let _e1768 = (_e1756 + _e1767);
let _e1770 = select(_e1499, _e1768, (_e1768 < _e1499));
let _e1775 = global_2.member[bitcast<u32>(select(0i, _e1770, (_e1770 > 0i)))];
let _e1777 = local_29[0u];
let _e1780 = (_e1766 + ((bitcast<f32>(_e1775) - _e1766) * _e1777));
let _e1781 = (_e1523 + _e1522);
let _e1782 = local_28.member[1u];
let _e1783 = (_e1781 + _e1782);
let _e1785 = select(_e1499, _e1783, (_e1783 < _e1499));
let _e1790 = global_2.member[bitcast<u32>(select(0i, _e1785, (_e1785 > 0i)))];
let _e1791 = bitcast<f32>(_e1790);
let _e1792 = local_28.member[2u];
let _e1793 = (_e1781 + _e1792);
let _e1795 = select(_e1499, _e1793, (_e1793 < _e1499));
let _e1800 = global_2.member[bitcast<u32>(select(0i, _e1795, (_e1795 > 0i)))];
let _e1802 = local_29[0u];
let _e1806 = (_e1525 + _e1512);
let _e1807 = local_28.member[1u];
let _e1808 = (_e1806 + _e1807);
let _e1810 = select(_e1499, _e1808, (_e1808 < _e1499));
let _e1815 = global_2.member[bitcast<u32>(select(0i, _e1810, (_e1810 > 0i)))];
let _e1816 = bitcast<f32>(_e1815);
let _e1817 = local_28.member[2u];
let _e1818 = (_e1806 + _e1817);
let _e1820 = select(_e1499, _e1818, (_e1818 < _e1499));
let _e1825 = global_2.member[bitcast<u32>(select(0i, _e1820, (_e1820 > 0i)))];
let _e1827 = local_29[0u];
let _e1830 = (_e1816 + ((bitcast<f32>(_e1825) - _e1816) * _e1827));
let _e1831 = (_e1525 + _e1522);
let _e1832 = local_28.member[1u];
let _e1833 = (_e1831 + _e1832);
let _e1835 = select(_e1499, _e1833, (_e1833 < _e1499));
let _e1840 = global_2.member[bitcast<u32>(select(0i, _e1835, (_e1835 > 0i)))];
let _e1841 = bitcast<f32>(_e1840);
let _e1842 = local_28.member[2u];
let _e1843 = (_e1831 + _e1842);
let _e1845 = select(_e1499, _e1843, (_e1843 < _e1499));
let _e1850 = global_2.member[bitcast<u32>(select(0i, _e1845, (_e1845 > 0i)))];
let _e1852 = local_29[0u];
let _e1856 = (_e1514 + _e1518);
let _e1857 = local_28.member[1u];
let _e1858 = (_e1856 + _e1857);
let _e1860 = select(_e1499, _e1858, (_e1858 < _e1499));
let _e1865 = global_2.member[bitcast<u32>(select(0i, _e1860, (_e1860 > 0i)))];
let _e1866 = bitcast<f32>(_e1865);
let _e1867 = local_28.member[2u];
let _e1868 = (_e1856 + _e1867);
let _e1870 = select(_e1499, _e1868, (_e1868 < _e1499));
let _e1875 = global_2.member[bitcast<u32>(select(0i, _e1870, (_e1870 > 0i)))];
let _e1877 = local_29[0u];
let _e1880 = (_e1866 + ((bitcast<f32>(_e1875) - _e1866) * _e1877));
let _e1881 = (_e1527 + _e1518);
let _e1882 = local_28.member[1u];
let _e1883 = (_e1881 + _e1882);
let _e1885 = select(_e1499, _e1883, (_e1883 < _e1499));
let _e1890 = global_2.member[bitcast<u32>(select(0i, _e1885, (_e1885 > 0i)))];
let _e1891 = bitcast<f32>(_e1890);
let _e1892 = local_28.member[2u];
let _e1893 = (_e1881 + _e1892);
let _e1895 = select(_e1499, _e1893, (_e1893 < _e1499));
let _e1900 = global_2.member[bitcast<u32>(select(0i, _e1895, (_e1895 > 0i)))];
let _e1902 = local_29[0u];
let _e1905 = (_e1891 + ((bitcast<f32>(_e1900) - _e1891) * _e1902));
let _e1906 = (_e1514 + _e1520);
let _e1907 = local_28.member[1u];
let _e1908 = (_e1906 + _e1907);
let _e1910 = select(_e1499, _e1908, (_e1908 < _e1499));
let _e1915 = global_2.member[bitcast<u32>(select(0i, _e1910, (_e1910 > 0i)))];
let _e1916 = bitcast<f32>(_e1915);
let _e1917 = local_28.member[2u];
let _e1918 = (_e1906 + _e1917);
let _e1920 = select(_e1499, _e1918, (_e1918 < _e1499));
let _e1925 = global_2.member[bitcast<u32>(select(0i, _e1920, (_e1920 > 0i)))];
let _e1927 = local_29[0u];
let _e1931 = (_e1527 + _e1520);
let _e1932 = local_28.member[1u];
let _e1933 = (_e1931 + _e1932);
let _e1935 = select(_e1499, _e1933, (_e1933 < _e1499));
let _e1940 = global_2.member[bitcast<u32>(select(0i, _e1935, (_e1935 > 0i)))];
let _e1941 = bitcast<f32>(_e1940);
let _e1942 = local_28.member[2u];
let _e1943 = (_e1931 + _e1942);
let _e1945 = select(_e1499, _e1943, (_e1943 < _e1499));
let _e1950 = global_2.member[bitcast<u32>(select(0i, _e1945, (_e1945 > 0i)))];
let _e1952 = local_29[0u];
let _e1957 = local_29[1u];
let _e1960 = (_e1592 + ((_e1645 - _e1592) * _e1957));
let _e1961 = local_29[1u];
let _e1964 = (_e1698 + ((_e1751 - _e1698) * _e1961));
let _e1965 = local_29[1u];
let _e1968 = (_e1588 + (((_e1607 + ((_e1617 - _e1607) * _e1638)) - _e1588) * _e1965));
let _e1969 = local_29[1u];
let _e1974 = local_29[2u];
let _e1978 = local_29[1u];
let _e1981 = (_e1596 + (((_e1627 + ((bitcast<f32>(_e1636) - _e1627) * _e1646)) - _e1596) * _e1978));
let _e1982 = local_29[1u];
let _e1986 = local_29[2u];
let _e1990 = local_29[1u];
let _e1993 = (_e1780 + ((_e1592 - _e1780) * _e1990));
let _e1994 = local_29[1u];
let _e1998 = local_29[2u];
let _e2002 = local_29[1u];
let _e2005 = (_e1645 + (((_e1791 + ((bitcast<f32>(_e1800) - _e1791) * _e1802)) - _e1645) * _e2002));
let _e2006 = local_29[1u];
let _e2010 = local_29[2u];
let _e2014 = local_29[1u];
let _e2017 = (_e1880 + (((_e1916 + ((bitcast<f32>(_e1925) - _e1916) * _e1927)) - _e1880) * _e2014));
let _e2018 = local_29[2u];
let _e2022 = local_29[1u];
let _e2026 = local_29[2u];
let _e2030 = local_29[2u];
let _e2037 = global_1.member.member_8.member_8;
let _e2041 = global_1.member.member_8.member_7;
let _e2043 = (((_e1960 + ((_e1964 - _e1960) * _e2030)) - _e2037) * _e2041);
let _e2044 = -(1e9f);
let _e2046 = select(_e2044, _e2043, (_e2043 > _e2044));
let _e2048 = select(1e9f, _e2046, (_e2046 < 1e9f));
let _e2050 = (((_e1968 + (((_e1694 + (((_e1713 + ((_e1723 - _e1713) * _e1744)) - _e1694) * _e1969)) - _e1968) * _e1974)) - _e2037) * _e2041);
let _e2052 = select(_e2044, _e2050, (_e2050 > _e2044));
let _e2054 = select(1e9f, _e2052, (_e2052 < 1e9f));
let _e2056 = (((_e1981 + (((_e1702 + (((_e1733 + ((bitcast<f32>(_e1742) - _e1733) * _e1752)) - _e1702) * _e1982)) - _e1981) * _e1986)) - _e2037) * _e2041);
let _e2058 = select(_e2044, _e2056, (_e2056 > _e2044));
let _e2060 = select(1e9f, _e2058, (_e2058 < 1e9f));
let _e2062 = (((_e1993 + (((_e1830 + ((_e1698 - _e1830) * _e1994)) - _e1993) * _e1998)) - _e2037) * _e2041);
let _e2064 = select(_e2044, _e2062, (_e2062 > _e2044));
let _e2066 = select(1e9f, _e2064, (_e2064 < 1e9f));
let _e2068 = (((_e2005 + (((_e1751 + (((_e1841 + ((bitcast<f32>(_e1850) - _e1841) * _e1852)) - _e1751) * _e2006)) - _e2005) * _e2010)) - _e2037) * _e2041);
let _e2070 = select(_e2044, _e2068, (_e2068 > _e2044));
let _e2072 = select(1e9f, _e2070, (_e2070 < 1e9f));
let _e2074 = (((_e2017 + ((_e1960 - _e2017) * _e2018)) - _e2037) * _e2041);
let _e2076 = select(_e2044, _e2074, (_e2074 > _e2044));
let _e2078 = select(1e9f, _e2076, (_e2076 < 1e9f));
let _e2080 = (((_e1964 + (((_e1905 + (((_e1941 + ((bitcast<f32>(_e1950) - _e1941) * _e1952)) - _e1905) * _e2022)) - _e1964) * _e2026)) - _e2037) * _e2041);
let _e2082 = select(_e2044, _e2080, (_e2080 > _e2044));
let _e2084 = select(1e9f, _e2082, (_e2082 < 1e9f));
local_26 = _e2048;
let _e2085 = local_26;
local_27 = _e2085;
let _e2086 = local_27;
let _e2088 = (bitcast<i32>(_e179) - 1i);
let _e2090 = select(_e2088, 263197i, (263197i < _e2088));
let _e2095 = global_3.member[bitcast<u32>(select(0i, _e2090, (_e2090 > 0i)))];
let _e2096 = bitcast<f32>(_e2095);
let _e2098 = select(_e2088, 263198i, (263198i < _e2088));
let _e2101 = bitcast<u32>(select(0i, _e2098, (_e2098 > 0i)));
let _e2103 = global_3.member[_e2101];
let _e2104 = bitcast<f32>(_e2103);
let _e2106 = select(_e2088, 263199i, (263199i < _e2088));
let _e2111 = global_3.member[bitcast<u32>(select(0i, _e2106, (_e2106 > 0i)))];
let _e2112 = bitcast<f32>(_e2111);
let _e2114 = ((_e2086 - _e2096) * _e2104);
let _e2116 = select(0f, _e2114, (_e2114 > 0f));
let _e2119 = local_27;
let _e2121 = select(_e2088, 263200i, (263200i < _e2088));
let _e2126 = global_3.member[bitcast<u32>(select(0i, _e2121, (_e2121 > 0i)))];
let _e2127 = bitcast<f32>(_e2126);
let _e2129 = select(_e2088, 263201i, (263201i < _e2088));
let _e2134 = global_3.member[bitcast<u32>(select(0i, _e2129, (_e2129 > 0i)))];
let _e2135 = bitcast<f32>(_e2134);
let _e2137 = select(_e2088, 263202i, (263202i < _e2088));
let _e2142 = global_3.member[bitcast<u32>(select(0i, _e2137, (_e2137 > 0i)))];
let _e2143 = bitcast<f32>(_e2142);
let _e2145 = ((_e2119 - _e2127) * _e2135);
let _e2147 = select(0f, _e2145, (_e2145 > 0f));
let _e2151 = local_27;
let _e2153 = select(_e2088, 263203i, (263203i < _e2088));
let _e2158 = global_3.member[bitcast<u32>(select(0i, _e2153, (_e2153 > 0i)))];
let _e2159 = bitcast<f32>(_e2158);
let _e2161 = select(_e2088, 263204i, (263204i < _e2088));
let _e2166 = global_3.member[bitcast<u32>(select(0i, _e2161, (_e2161 > 0i)))];
let _e2167 = bitcast<f32>(_e2166);
let _e2169 = select(_e2088, 263205i, (263205i < _e2088));
let _e2174 = global_3.member[bitcast<u32>(select(0i, _e2169, (_e2169 > 0i)))];
let _e2175 = bitcast<f32>(_e2174);
let _e2177 = ((_e2151 - _e2159) * _e2167);
let _e2179 = select(0f, _e2177, (_e2177 > 0f));
let _e2182 = local_27;
let _e2184 = select(_e2088, 263206i, (263206i < _e2088));
let _e2189 = global_3.member[bitcast<u32>(select(0i, _e2184, (_e2184 > 0i)))];
let _e2190 = bitcast<f32>(_e2189);
let _e2192 = select(_e2088, 263207i, (263207i < _e2088));
let _e2197 = global_3.member[bitcast<u32>(select(0i, _e2192, (_e2192 > 0i)))];
let _e2198 = bitcast<f32>(_e2197);
let _e2200 = select(_e2088, 263208i, (263208i < _e2088));
let _e2205 = global_3.member[bitcast<u32>(select(0i, _e2200, (_e2200 > 0i)))];
let _e2206 = bitcast<f32>(_e2205);
let _e2208 = ((_e2182 - _e2190) * _e2198);
let _e2210 = select(0f, _e2208, (_e2208 > 0f));
let _e2214 = ((select(_e2112, _e2116, (_e2116 < _e2112)) + select(_e2143, _e2147, (_e2147 < _e2143))) + (select(_e2175, _e2179, (_e2179 < _e2175)) + select(_e2206, _e2210, (_e2210 < _e2206))));
let _e2216 = select(0f, _e2214, (_e2214 > 0f));
let _e2218 = select(1023f, _e2216, (_e2216 < 1023f));
let _e2225 = select(0i, select(select(i32(_e2218), i32(-2147483648), (_e2218 < -2147483600f)), 2147483647i, (_e2218 > 2147483500f)), (_e2218 == _e2218));
let _e2229 = (_e2225 - select(0i, 1i, (_e2218 < f32(_e2225))));
let _e2230 = (262147i + _e2229);
let _e2232 = select(_e2088, _e2230, (_e2230 < _e2088));
let _e2238 = global_3.member[bitcast<u32>(select(0i, _e2232, (_e2232 > 0i)))];
let _e2248 = select(_e2088, 262146i, (262146i < _e2088));
let _e2254 = global_3.member[bitcast<u32>(select(0i, _e2248, (_e2248 > 0i)))];
let _e2255 = bitcast<f32>(_e2254);
let _e2256 = (f32((bitcast<i32>((_e2238 & 4095u)) - 2048i)) * _e2255);
let _e2258 = select(_e2088, 262144i, (262144i < _e2088));
let _e2264 = global_3.member[bitcast<u32>(select(0i, _e2258, (_e2258 > 0i)))];
let _e2265 = bitcast<f32>(_e2264);
let _e2267 = select(_e2088, 262145i, (262145i < _e2088));
let _e2273 = global_3.member[bitcast<u32>(select(0i, _e2267, (_e2267 > 0i)))];
let _e2274 = bitcast<f32>(_e2273);
let _e2280 = ((_e2265 + (f32(bitcast<i32>((_e2238 >> bitcast<u32>(12u)))) * _e2274)) + (_e2256 * (_e2214 - f32(_e2229))));
let _e2283 = global_3.member[_e2101];
let _e2285 = local_26;
let _e2288 = local_26;
let _e2291 = local_26;
let _e2295 = select(_e2088, 263209i, (263209i < _e2088));
let _e2301 = global_3.member[bitcast<u32>(select(0i, _e2295, (_e2295 > 0i)))];
let _e2303 = local_26;
let _e2306 = select(_e2088, 263210i, (263210i < _e2088));
let _e2312 = global_3.member[bitcast<u32>(select(0i, _e2306, (_e2306 > 0i)))];
let _e2314 = local_26;
let _e2318 = (_e2256 * select(0f, select(select(select(bitcast<f32>(_e2283), _e2135, (_e2285 >= _e2127)), _e2167, (_e2288 >= _e2159)), _e2198, (_e2291 >= _e2190)), ((_e2303 >= bitcast<f32>(_e2301)) && (_e2314 <= bitcast<f32>(_e2312)))));
if _e1280 {
let _e2325 = ((0.5f * (_e2060 - _e2054)) * _e2318);
let _e2326 = ((0.5f * (_e2072 - _e2066)) * _e2318);
let _e2327 = ((0.5f * (_e2084 - _e2078)) * _e2318);
phi_7180_ = type_34(_e2280, vec3<f32>(_e2325, _e2326, _e2327), vec3<f32>((_e2325 * _e2280), (_e2326 * _e2280), (_e2327 * _e2280)));
} else {
local_24 = _e2054;
let _e2334 = local_24;
local_25 = _e2334;
let _e2335 = local_25;
let _e2337 = ((_e2335 - _e2096) * _e2104);
let _e2339 = select(0f, _e2337, (_e2337 > 0f));
let _e2342 = local_25;
let _e2344 = ((_e2342 - _e2127) * _e2135);
let _e2346 = select(0f, _e2344, (_e2344 > 0f));
let _e2350 = local_25;
let _e2352 = ((_e2350 - _e2159) * _e2167);
let _e2354 = select(0f, _e2352, (_e2352 > 0f));
let _e2357 = local_25;
let _e2359 = ((_e2357 - _e2190) * _e2198);
let _e2361 = select(0f, _e2359, (_e2359 > 0f));
let _e2365 = ((select(_e2112, _e2339, (_e2339 < _e2112)) + select(_e2143, _e2346, (_e2346 < _e2143))) + (select(_e2175, _e2354, (_e2354 < _e2175)) + select(_e2206, _e2361, (_e2361 < _e2206))));
let _e2367 = select(0f, _e2365, (_e2365 > 0f));
let _e2369 = select(1023f, _e2367, (_e2367 < 1023f));
let _e2376 = select(0i, select(select(i32(_e2369), i32(-2147483648), (_e2369 < -2147483600f)), 2147483647i, (_e2369 > 2147483500f)), (_e2369 == _e2369));
let _e2380 = (_e2376 - select(0i, 1i, (_e2369 < f32(_e2376))));
let _e2381 = (262147i + _e2380);
let _e2383 = select(_e2088, _e2381, (_e2381 < _e2088));
let _e2389 = global_3.member[bitcast<u32>(select(0i, _e2383, (_e2383 > 0i)))];
let _e2404 = ((_e2265 + (f32(bitcast<i32>((_e2389 >> bitcast<u32>(12u)))) * _e2274)) + ((f32((bitcast<i32>((_e2389 & 4095u)) - 2048i)) * _e2255) * (_e2365 - f32(_e2380))));
local_22 = _e2060;
let _e2405 = local_22;
local_23 = _e2405;
let _e2406 = local_23;
let _e2408 = ((_e2406 - _e2096) * _e2104);
let _e2410 = select(0f, _e2408, (_e2408 > 0f));
let _e2413 = local_23;
let _e2415 = ((_e2413 - _e2127) * _e2135);
let _e2417 = select(0f, _e2415, (_e2415 > 0f));
let _e2421 = local_23;
let _e2423 = ((_e2421 - _e2159) * _e2167);
let _e2425 = select(0f, _e2423, (_e2423 > 0f));
let _e2428 = local_23;
let _e2430 = ((_e2428 - _e2190) * _e2198);
let _e2432 = select(0f, _e2430, (_e2430 > 0f));
let _e2436 = ((select(_e2112, _e2410, (_e2410 < _e2112)) + select(_e2143, _e2417, (_e2417 < _e2143))) + (select(_e2175, _e2425, (_e2425 < _e2175)) + select(_e2206, _e2432, (_e2432 < _e2206))));
let _e2438 = select(0f, _e2436, (_e2436 > 0f));
let _e2440 = select(1023f, _e2438, (_e2438 < 1023f));
let _e2447 = select(0i, select(select(i32(_e2440), i32(-2147483648), (_e2440 < -2147483600f)), 2147483647i, (_e2440 > 2147483500f)), (_e2440 == _e2440));
let _e2451 = (_e2447 - select(0i, 1i, (_e2440 < f32(_e2447))));
let _e2452 = (262147i + _e2451);
let _e2454 = select(_e2088, _e2452, (_e2452 < _e2088));
let _e2460 = global_3.member[bitcast<u32>(select(0i, _e2454, (_e2454 > 0i)))];
let _e2475 = ((_e2265 + (f32(bitcast<i32>((_e2460 >> bitcast<u32>(12u)))) * _e2274)) + ((f32((bitcast<i32>((_e2460 & 4095u)) - 2048i)) * _e2255) * (_e2436 - f32(_e2451))));
local_20 = _e2066;
let _e2476 = local_20;
local_21 = _e2476;
let _e2477 = local_21;
let _e2479 = ((_e2477 - _e2096) * _e2104);
let _e2481 = select(0f, _e2479, (_e2479 > 0f));
let _e2484 = local_21;
let _e2486 = ((_e2484 - _e2127) * _e2135);
let _e2488 = select(0f, _e2486, (_e2486 > 0f));
let _e2492 = local_21;
let _e2494 = ((_e2492 - _e2159) * _e2167);
let _e2496 = select(0f, _e2494, (_e2494 > 0f));
let _e2499 = local_21;
let _e2501 = ((_e2499 - _e2190) * _e2198);
let _e2503 = select(0f, _e2501, (_e2501 > 0f));
let _e2507 = ((select(_e2112, _e2481, (_e2481 < _e2112)) + select(_e2143, _e2488, (_e2488 < _e2143))) + (select(_e2175, _e2496, (_e2496 < _e2175)) + select(_e2206, _e2503, (_e2503 < _e2206))));
let _e2509 = select(0f, _e2507, (_e2507 > 0f));
let _e2511 = select(1023f, _e2509, (_e2509 < 1023f));
let _e2518 = select(0i, select(select(i32(_e2511), i32(-2147483648), (_e2511 < -2147483600f)), 2147483647i, (_e2511 > 2147483500f)), (_e2511 == _e2511));
let _e2522 = (_e2518 - select(0i, 1i, (_e2511 < f32(_e2518))));
let _e2523 = (262147i + _e2522);
let _e2525 = select(_e2088, _e2523, (_e2523 < _e2088));
let _e2531 = global_3.member[bitcast<u32>(select(0i, _e2525, (_e2525 > 0i)))];
let _e2546 = ((_e2265 + (f32(bitcast<i32>((_e2531 >> bitcast<u32>(12u)))) * _e2274)) + ((f32((bitcast<i32>((_e2531 & 4095u)) - 2048i)) * _e2255) * (_e2507 - f32(_e2522))));
local_18 = _e2072;
let _e2547 = local_18;
local_19 = _e2547;
let _e2548 = local_19;
let _e2550 = ((_e2548 - _e2096) * _e2104);
let _e2552 = select(0f, _e2550, (_e2550 > 0f));
let _e2555 = local_19;
let _e2557 = ((_e2555 - _e2127) * _e2135);
let _e2559 = select(0f, _e2557, (_e2557 > 0f));
let _e2563 = local_19;
let _e2565 = ((_e2563 - _e2159) * _e2167);
let _e2567 = select(0f, _e2565, (_e2565 > 0f));
let _e2570 = local_19;
let _e2572 = ((_e2570 - _e2190) * _e2198);
let _e2574 = select(0f, _e2572, (_e2572 > 0f));
let _e2578 = ((select(_e2112, _e2552, (_e2552 < _e2112)) + select(_e2143, _e2559, (_e2559 < _e2143))) + (select(_e2175, _e2567, (_e2567 < _e2175)) + select(_e2206, _e2574, (_e2574 < _e2206))));
let _e2580 = select(0f, _e2578, (_e2578 > 0f));
let _e2582 = select(1023f, _e2580, (_e2580 < 1023f));
let _e2589 = select(0i, select(select(i32(_e2582), i32(-2147483648), (_e2582 < -2147483600f)), 2147483647i, (_e2582 > 2147483500f)), (_e2582 == _e2582));
let _e2593 = (_e2589 - select(0i, 1i, (_e2582 < f32(_e2589))));
let _e2594 = (262147i + _e2593);
let _e2596 = select(_e2088, _e2594, (_e2594 < _e2088));
let _e2602 = global_3.member[bitcast<u32>(select(0i, _e2596, (_e2596 > 0i)))];
let _e2617 = ((_e2265 + (f32(bitcast<i32>((_e2602 >> bitcast<u32>(12u)))) * _e2274)) + ((f32((bitcast<i32>((_e2602 & 4095u)) - 2048i)) * _e2255) * (_e2578 - f32(_e2593))));
local_16 = _e2078;
let _e2618 = local_16;
local_17 = _e2618;
let _e2619 = local_17;
let _e2621 = ((_e2619 - _e2096) * _e2104);
let _e2623 = select(0f, _e2621, (_e2621 > 0f));
let _e2626 = local_17;
let _e2628 = ((_e2626 - _e2127) * _e2135);
let _e2630 = select(0f, _e2628, (_e2628 > 0f));
let _e2634 = local_17;
let _e2636 = ((_e2634 - _e2159) * _e2167);
let _e2638 = select(0f, _e2636, (_e2636 > 0f));
let _e2641 = local_17;
let _e2643 = ((_e2641 - _e2190) * _e2198);
let _e2645 = select(0f, _e2643, (_e2643 > 0f));
let _e2649 = ((select(_e2112, _e2623, (_e2623 < _e2112)) + select(_e2143, _e2630, (_e2630 < _e2143))) + (select(_e2175, _e2638, (_e2638 < _e2175)) + select(_e2206, _e2645, (_e2645 < _e2206))));
let _e2651 = select(0f, _e2649, (_e2649 > 0f));
let _e2653 = select(1023f, _e2651, (_e2651 < 1023f));
let _e2660 = select(0i, select(select(i32(_e2653), i32(-2147483648), (_e2653 < -2147483600f)), 2147483647i, (_e2653 > 2147483500f)), (_e2653 == _e2653));
let _e2664 = (_e2660 - select(0i, 1i, (_e2653 < f32(_e2660))));
let _e2665 = (262147i + _e2664);
let _e2667 = select(_e2088, _e2665, (_e2665 < _e2088));
let _e2673 = global_3.member[bitcast<u32>(select(0i, _e2667, (_e2667 > 0i)))];
let _e2688 = ((_e2265 + (f32(bitcast<i32>((_e2673 >> bitcast<u32>(12u)))) * _e2274)) + ((f32((bitcast<i32>((_e2673 & 4095u)) - 2048i)) * _e2255) * (_e2649 - f32(_e2664))));
local_14 = _e2084;
let _e2689 = local_14;
local_15 = _e2689;
let _e2690 = local_15;
let _e2692 = ((_e2690 - _e2096) * _e2104);
let _e2694 = select(0f, _e2692, (_e2692 > 0f));
let _e2697 = local_15;
let _e2699 = ((_e2697 - _e2127) * _e2135);
let _e2701 = select(0f, _e2699, (_e2699 > 0f));
let _e2705 = local_15;
let _e2707 = ((_e2705 - _e2159) * _e2167);
let _e2709 = select(0f, _e2707, (_e2707 > 0f));
let _e2712 = local_15;
let _e2714 = ((_e2712 - _e2190) * _e2198);
let _e2716 = select(0f, _e2714, (_e2714 > 0f));
let _e2720 = ((select(_e2112, _e2694, (_e2694 < _e2112)) + select(_e2143, _e2701, (_e2701 < _e2143))) + (select(_e2175, _e2709, (_e2709 < _e2175)) + select(_e2206, _e2716, (_e2716 < _e2206))));
let _e2722 = select(0f, _e2720, (_e2720 > 0f));
let _e2724 = select(1023f, _e2722, (_e2722 < 1023f));
let _e2731 = select(0i, select(select(i32(_e2724), i32(-2147483648), (_e2724 < -2147483600f)), 2147483647i, (_e2724 > 2147483500f)), (_e2724 == _e2724));
let _e2735 = (_e2731 - select(0i, 1i, (_e2724 < f32(_e2731))));
let _e2736 = (262147i + _e2735);
let _e2738 = select(_e2088, _e2736, (_e2736 < _e2088));
let _e2744 = global_3.member[bitcast<u32>(select(0i, _e2738, (_e2738 > 0i)))];
let _e2759 = ((_e2265 + (f32(bitcast<i32>((_e2744 >> bitcast<u32>(12u)))) * _e2274)) + ((f32((bitcast<i32>((_e2744 & 4095u)) - 2048i)) * _e2255) * (_e2720 - f32(_e2735))));
let _e2760 = (_e2475 - _e2404);
let _e2762 = (_e2617 - _e2546);
let _e2764 = (_e2759 - _e2688);
phi_7180_ = type_34(_e2280, vec3<f32>((0.5f * _e2760), (0.5f * _e2762), (0.5f * _e2764)), vec3<f32>((0.25f * (_e2760 * (_e2475 + _e2404))), (0.25f * (_e2762 * (_e2617 + _e2546))), (0.25f * (_e2764 * (_e2759 + _e2688)))));
}
let _e2779 = phi_7180_;
let _e2794 = select(0f, 1f, ((((((_e1260 >= _e1286) && (_e1260 <= _e1291)) && (_e1266 >= _e1300)) && (_e1266 <= _e1305)) && (_e1272 >= _e1314)) && (_e1272 <= _e1319)));
let _e2796 = (0.5f * (_e2060 - _e2054));
let _e2798 = (0.5f * (_e2072 - _e2066));
let _e2800 = (0.5f * (_e2084 - _e2078));
let _e2806 = global_1.member.member_8.member.member.member;
let _e2812 = global_1.member.member_8.member.member.member_1;
let _e2818 = global_1.member.member_8.member.member.member_2;
let _e2824 = global_1.member.member_8.member_1.member.member;
let _e2830 = global_1.member.member_8.member_1.member.member_1;
let _e2836 = global_1.member.member_8.member_1.member.member_2;
let _e2842 = global_1.member.member_8.member_2.member.member;
let _e2848 = global_1.member.member_8.member_2.member.member_1;
let _e2854 = global_1.member.member_8.member_2.member.member_2;
let _e2859 = (((_e2806 * _e2796) + (_e2824 * _e2798)) + (_e2842 * _e2800));
let _e2864 = (((_e2812 * _e2796) + (_e2830 * _e2798)) + (_e2848 * _e2800));
let _e2869 = (((_e2818 * _e2796) + (_e2836 * _e2798)) + (_e2854 * _e2800));
phi_9220_ = type_35(_e2048, vec3<f32>((_e2859 * _e2794), (_e2864 * _e2794), (_e2869 * _e2794)), vec3<f32>(_e2859, _e2864, _e2869), _e2779.member, vec3<f32>(((((_e2806 * _e2779.member_2.x) + (_e2824 * _e2779.member_2.y)) + (_e2842 * _e2779.member_2.z)) * _e2794), ((((_e2812 * _e2779.member_2.x) + (_e2830 * _e2779.member_2.y)) + (_e2848 * _e2779.member_2.z)) * _e2794), ((((_e2818 * _e2779.member_2.x) + (_e2836 * _e2779.member_2.y)) + (_e2854 * _e2779.member_2.z)) * _e2794)), vec3<f32>(((((_e2806 * _e2779.member_1.x) + (_e2824 * _e2779.member_1.y)) + (_e2842 * _e2779.member_1.z)) * _e2794), ((((_e2812 * _e2779.member_1.x) + (_e2830 * _e2779.member_1.y)) + (_e2848 * _e2779.member_1.z)) * _e2794), ((((_e2818 * _e2779.member_1.x) + (_e2836 * _e2779.member_1.y)) + (_e2854 * _e2779.member_1.z)) * _e2794)));
} else {
if (_e189.member_2 == 8u) {
let _e2925 = global_1.member.member_8.member_4.member;
let _e2930 = global_1.member.member_8.member_5.member;
let _e2932 = select(_e2925, _e1260, (_e1260 > _e2925));
let _e2934 = select(_e2930, _e2932, (_e2932 < _e2930));
let _e2939 = global_1.member.member_8.member_4.member_1;
let _e2944 = global_1.member.member_8.member_5.member_1;
let _e2946 = select(_e2939, _e1266, (_e1266 > _e2939));
let _e2948 = select(_e2944, _e2946, (_e2946 < _e2944));
let _e2953 = global_1.member.member_8.member_4.member_2;
let _e2958 = global_1.member.member_8.member_5.member_2;
let _e2960 = select(_e2953, _e1272, (_e1272 > _e2953));
let _e2962 = select(_e2958, _e2960, (_e2960 < _e2958));
let _e2967 = global_1.member.member_8.member_15;
if (_e2967 == 0u) {
phi_7527_ = vec3<f32>(_e2934, _e2948, _e2962);
} else {
let _e2969 = (_e2934 + 0.5f);
let _e2974 = global_1.member.member_8.member_3.member;
let _e2975 = (_e2974 - 1f);
let _e2977 = select(0f, _e2969, (_e2969 > 0f));
let _e2979 = select(_e2975, _e2977, (_e2977 < _e2975));
let _e2986 = select(0i, select(select(i32(_e2979), i32(-2147483648), (_e2979 < -2147483600f)), 2147483647i, (_e2979 > 2147483500f)), (_e2979 == _e2979));
let _e2992 = (_e2948 + 0.5f);
let _e2997 = global_1.member.member_8.member_3.member_1;
let _e2998 = (_e2997 - 1f);
let _e3000 = select(0f, _e2992, (_e2992 > 0f));
let _e3002 = select(_e2998, _e3000, (_e3000 < _e2998));
let _e3009 = select(0i, select(select(i32(_e3002), i32(-2147483648), (_e3002 < -2147483600f)), 2147483647i, (_e3002 > 2147483500f)), (_e3002 == _e3002));
let _e3015 = (_e2962 + 0.5f);
let _e3020 = global_1.member.member_8.member_3.member_2;
let _e3021 = (_e3020 - 1f);
let _e3023 = select(0f, _e3015, (_e3015 > 0f));
let _e3025 = select(_e3021, _e3023, (_e3023 < _e3021));
let _e3032 = select(0i, select(select(i32(_e3025), i32(-2147483648), (_e3025 < -2147483600f)), 2147483647i, (_e3025 > 2147483500f)), (_e3025 == _e3025));
phi_7527_ = vec3<f32>(f32((_e2986 - select(0i, 1i, (_e2979 < f32(_e2986))))), f32((_e3009 - select(0i, 1i, (_e3002 < f32(_e3009))))), f32((_e3032 - select(0i, 1i, (_e3025 < f32(_e3032))))));
}
let _e3040 = phi_7527_;
let _e3046 = global_1.member.member_8.member_3.member;
let _e3048 = select(-1f, _e3040.x, (_e3040.x > -1f));
let _e3050 = select(_e3046, _e3048, (_e3048 < _e3046));
let _e3057 = select(0i, select(select(i32(_e3050), i32(-2147483648), (_e3050 < -2147483600f)), 2147483647i, (_e3050 > 2147483500f)), (_e3050 == _e3050));
let _e3061 = (_e3057 - select(0i, 1i, (_e3050 < f32(_e3057))));
let _e3067 = global_1.member.member_8.member_3.member_1;
let _e3069 = select(-1f, _e3040.y, (_e3040.y > -1f));
let _e3071 = select(_e3067, _e3069, (_e3069 < _e3067));
let _e3078 = select(0i, select(select(i32(_e3071), i32(-2147483648), (_e3071 < -2147483600f)), 2147483647i, (_e3071 > 2147483500f)), (_e3071 == _e3071));
let _e3082 = (_e3078 - select(0i, 1i, (_e3071 < f32(_e3078))));
let _e3088 = global_1.member.member_8.member_3.member_2;
let _e3090 = select(-1f, _e3040.z, (_e3040.z > -1f));
let _e3092 = select(_e3088, _e3090, (_e3090 < _e3088));
let _e3099 = select(0i, select(select(i32(_e3092), i32(-2147483648), (_e3092 < -2147483600f)), 2147483647i, (_e3092 > 2147483500f)), (_e3092 == _e3092));
let _e3103 = (_e3099 - select(0i, 1i, (_e3092 < f32(_e3099))));
let _e3107 = global_1.member.member_8.member_9;
let _e3111 = global_1.member.member_8.member_10;
let _e3112 = (_e3061 + 1i);
let _e3113 = (_e3082 + 1i);
let _e3114 = (_e3103 + 1i);
let _e3119 = global_1.member.member_8.member_13.member;
let _e3125 = global_1.member.member_8.member_13.member_1;
let _e3136 = ((_e3112 >> bitcast<u32>(4i)) + (bitcast<i32>(_e3119) * ((_e3113 >> bitcast<u32>(4i)) + (bitcast<i32>(_e3125) * (_e3114 >> bitcast<u32>(4i))))));
let _e3138 = (bitcast<i32>(_e174) - 1i);
let _e3140 = select(_e3138, _e3136, (_e3136 < _e3138));
let _e3146 = global_2.member[bitcast<u32>(select(0i, _e3140, (_e3140 > 0i)))];
let _e3148 = (_e3112 & 15i);
let _e3151 = ((_e3113 & 15i) * _e3107);
let _e3153 = (bitcast<i32>(_e3146) + ((_e3114 & 15i) * _e3111));
let _e3157 = (_e3151 + _e3107);
let _e3159 = (_e3151 + (2i * _e3107));
let _e3161 = (_e3151 + (3i * _e3107));
let _e3162 = (_e3153 + _e3111);
let _e3164 = (_e3153 + (2i * _e3111));
let _e3166 = (_e3153 + (3i * _e3111));
local_12 = type_30(array<i32, 4>(_e3148, (_e3148 + 1i), (_e3148 + 2i), (_e3148 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_13 = (_e3040 - vec3<f32>(f32(_e3061), f32(_e3082), f32(_e3103)));
let _e3175 = (_e3162 + _e3157);
let _e3178 = local_12.member[0u];
let _e3179 = (_e3175 + _e3178);
let _e3181 = select(_e3138, _e3179, (_e3179 < _e3138));
let _e3186 = global_2.member[bitcast<u32>(select(0i, _e3181, (_e3181 > 0i)))];
let _e3187 = bitcast<f32>(_e3186);
let _e3190 = local_12.member[1u];
let _e3191 = (_e3175 + _e3190);
let _e3193 = select(_e3138, _e3191, (_e3191 < _e3138));
let _e3198 = global_2.member[bitcast<u32>(select(0i, _e3193, (_e3193 > 0i)))];
let _e3199 = bitcast<f32>(_e3198);
let _e3202 = local_12.member[2u];
let _e3203 = (_e3175 + _e3202);
let _e3205 = select(_e3138, _e3203, (_e3203 < _e3138));
let _e3210 = global_2.member[bitcast<u32>(select(0i, _e3205, (_e3205 > 0i)))];
let _e3211 = bitcast<f32>(_e3210);
let _e3214 = local_12.member[3u];
let _e3215 = (_e3175 + _e3214);
let _e3217 = select(_e3138, _e3215, (_e3215 < _e3138));
let _e3222 = global_2.member[bitcast<u32>(select(0i, _e3217, (_e3217 > 0i)))];
let _e3224 = local_13[0u];
let _e3227 = (_e3187 + ((_e3199 - _e3187) * _e3224));
let _e3228 = local_13[0u];
let _e3231 = (_e3199 + ((_e3211 - _e3199) * _e3228));
let _e3232 = local_13[0u];
let _e3235 = (_e3211 + ((bitcast<f32>(_e3222) - _e3211) * _e3232));
let _e3236 = (_e3162 + _e3159);
let _e3237 = local_12.member[0u];
let _e3238 = (_e3236 + _e3237);
let _e3240 = select(_e3138, _e3238, (_e3238 < _e3138));
let _e3245 = global_2.member[bitcast<u32>(select(0i, _e3240, (_e3240 > 0i)))];
let _e3246 = bitcast<f32>(_e3245);
let _e3247 = local_12.member[1u];
let _e3248 = (_e3236 + _e3247);
let _e3250 = select(_e3138, _e3248, (_e3248 < _e3138));
let _e3255 = global_2.member[bitcast<u32>(select(0i, _e3250, (_e3250 > 0i)))];
let _e3256 = bitcast<f32>(_e3255);
let _e3257 = local_12.member[2u];
let _e3258 = (_e3236 + _e3257);
let _e3260 = select(_e3138, _e3258, (_e3258 < _e3138));
let _e3265 = global_2.member[bitcast<u32>(select(0i, _e3260, (_e3260 > 0i)))];
let _e3266 = bitcast<f32>(_e3265);
let _e3267 = local_12.member[3u];
let _e3268 = (_e3236 + _e3267);
let _e3270 = select(_e3138, _e3268, (_e3268 < _e3138));
let _e3275 = global_2.member[bitcast<u32>(select(0i, _e3270, (_e3270 > 0i)))];
let _e3277 = local_13[0u];
let _e3281 = local_13[0u];
let _e3284 = (_e3256 + ((_e3266 - _e3256) * _e3281));
let _e3285 = local_13[0u];
let _e3289 = (_e3164 + _e3157);
let _e3290 = local_12.member[0u];
let _e3291 = (_e3289 + _e3290);
let _e3293 = select(_e3138, _e3291, (_e3291 < _e3138));
let _e3298 = global_2.member[bitcast<u32>(select(0i, _e3293, (_e3293 > 0i)))];
let _e3299 = bitcast<f32>(_e3298);
let _e3300 = local_12.member[1u];
let _e3301 = (_e3289 + _e3300);
let _e3303 = select(_e3138, _e3301, (_e3301 < _e3138));
let _e3308 = global_2.member[bitcast<u32>(select(0i, _e3303, (_e3303 > 0i)))];
let _e3309 = bitcast<f32>(_e3308);
let _e3310 = local_12.member[2u];
let _e3311 = (_e3289 + _e3310);
let _e3313 = select(_e3138, _e3311, (_e3311 < _e3138));
let _e3318 = global_2.member[bitcast<u32>(select(0i, _e3313, (_e3313 > 0i)))];
let _e3319 = bitcast<f32>(_e3318);
let _e3320 = local_12.member[3u];
let _e3321 = (_e3289 + _e3320);
let _e3323 = select(_e3138, _e3321, (_e3321 < _e3138));
let _e3328 = global_2.member[bitcast<u32>(select(0i, _e3323, (_e3323 > 0i)))];
let _e3330 = local_13[0u];
let _e3333 = (_e3299 + ((_e3309 - _e3299) * _e3330));
let _e3334 = local_13[0u];
let _e3337 = (_e3309 + ((_e3319 - _e3309) * _e3334));
let _e3338 = local_13[0u];
let _e3341 = (_e3319 + ((bitcast<f32>(_e3328) - _e3319) * _e3338));
let _e3342 = (_e3164 + _e3159);
let _e3343 = local_12.member[0u];
let _e3344 = (_e3342 + _e3343);
let _e3346 = select(_e3138, _e3344, (_e3344 < _e3138));
let _e3351 = global_2.member[bitcast<u32>(select(0i, _e3346, (_e3346 > 0i)))];
let _e3352 = bitcast<f32>(_e3351);
let _e3353 = local_12.member[1u];
let _e3354 = (_e3342 + _e3353);
let _e3356 = select(_e3138, _e3354, (_e3354 < _e3138));
let _e3361 = global_2.member[bitcast<u32>(select(0i, _e3356, (_e3356 > 0i)))];
let _e3362 = bitcast<f32>(_e3361);
let _e3363 = local_12.member[2u];
let _e3364 = (_e3342 + _e3363);
let _e3366 = select(_e3138, _e3364, (_e3364 < _e3138));
let _e3371 = global_2.member[bitcast<u32>(select(0i, _e3366, (_e3366 > 0i)))];
let _e3372 = bitcast<f32>(_e3371);
let _e3373 = local_12.member[3u];
let _e3374 = (_e3342 + _e3373);
let _e3376 = select(_e3138, _e3374, (_e3374 < _e3138));
let _e3381 = global_2.member[bitcast<u32>(select(0i, _e3376, (_e3376 > 0i)))];
let _e3383 = local_13[0u];
let _e3387 = local_13[0u];
let _e3390 = (_e3362 + ((_e3372 - _e3362) * _e3387));
let _e3391 = local_13[0u];
let _e3395 = (_e3162 + _e3151);
let _e3396 = local_12.member[1u];
let _e3397 = (_e3395 + _e3396);
let _e3399 = select(_e3138, _e3397, (_e3397 < _e3138));
let _e3404 = global_2.member[bitcast<u32>(select(0i, _e3399, (_e3399 > 0i)))];
let _e3405 = bitcast<f32>(_e3404);
let _e3406 = local_12.member[2u];
let _e3407 = (_e3395 + _e3406);
let _e3409 = select(_e3138, _e3407, (_e3407 < _e3138));
let _e3414 = global_2.member[bitcast<u32>(select(0i, _e3409, (_e3409 > 0i)))];
let _e3416 = local_13[0u];
let _e3419 = (_e3405 + ((bitcast<f32>(_e3414) - _e3405) * _e3416));
let _e3420 = (_e3162 + _e3161);
let _e3421 = local_12.member[1u];
let _e3422 = (_e3420 + _e3421);
let _e3424 = select(_e3138, _e3422, (_e3422 < _e3138));
let _e3429 = global_2.member[bitcast<u32>(select(0i, _e3424, (_e3424 > 0i)))];
let _e3430 = bitcast<f32>(_e3429);
let _e3431 = local_12.member[2u];
let _e3432 = (_e3420 + _e3431);
let _e3434 = select(_e3138, _e3432, (_e3432 < _e3138));
let _e3439 = global_2.member[bitcast<u32>(select(0i, _e3434, (_e3434 > 0i)))];
let _e3441 = local_13[0u];
let _e3445 = (_e3164 + _e3151);
let _e3446 = local_12.member[1u];
let _e3447 = (_e3445 + _e3446);
let _e3449 = select(_e3138, _e3447, (_e3447 < _e3138));
let _e3454 = global_2.member[bitcast<u32>(select(0i, _e3449, (_e3449 > 0i)))];
let _e3455 = bitcast<f32>(_e3454);
let _e3456 = local_12.member[2u];
let _e3457 = (_e3445 + _e3456);
let _e3459 = select(_e3138, _e3457, (_e3457 < _e3138));
let _e3464 = global_2.member[bitcast<u32>(select(0i, _e3459, (_e3459 > 0i)))];
let _e3466 = local_13[0u];
let _e3469 = (_e3455 + ((bitcast<f32>(_e3464) - _e3455) * _e3466));
let _e3470 = (_e3164 + _e3161);
let _e3471 = local_12.member[1u];
let _e3472 = (_e3470 + _e3471);
let _e3474 = select(_e3138, _e3472, (_e3472 < _e3138));
let _e3479 = global_2.member[bitcast<u32>(select(0i, _e3474, (_e3474 > 0i)))];
let _e3480 = bitcast<f32>(_e3479);
let _e3481 = local_12.member[2u];
let _e3482 = (_e3470 + _e3481);
let _e3484 = select(_e3138, _e3482, (_e3482 < _e3138));
let _e3489 = global_2.member[bitcast<u32>(select(0i, _e3484, (_e3484 > 0i)))];
let _e3491 = local_13[0u];
let _e3495 = (_e3153 + _e3157);
let _e3496 = local_12.member[1u];
let _e3497 = (_e3495 + _e3496);
let _e3499 = select(_e3138, _e3497, (_e3497 < _e3138));
let _e3504 = global_2.member[bitcast<u32>(select(0i, _e3499, (_e3499 > 0i)))];
let _e3505 = bitcast<f32>(_e3504);
let _e3506 = local_12.member[2u];
let _e3507 = (_e3495 + _e3506);
let _e3509 = select(_e3138, _e3507, (_e3507 < _e3138));
let _e3514 = global_2.member[bitcast<u32>(select(0i, _e3509, (_e3509 > 0i)))];
let _e3516 = local_13[0u];
let _e3519 = (_e3505 + ((bitcast<f32>(_e3514) - _e3505) * _e3516));
let _e3520 = (_e3166 + _e3157);
let _e3521 = local_12.member[1u];
let _e3522 = (_e3520 + _e3521);
let _e3524 = select(_e3138, _e3522, (_e3522 < _e3138));
let _e3529 = global_2.member[bitcast<u32>(select(0i, _e3524, (_e3524 > 0i)))];
let _e3530 = bitcast<f32>(_e3529);
let _e3531 = local_12.member[2u];
let _e3532 = (_e3520 + _e3531);
let _e3534 = select(_e3138, _e3532, (_e3532 < _e3138));
let _e3539 = global_2.member[bitcast<u32>(select(0i, _e3534, (_e3534 > 0i)))];
let _e3541 = local_13[0u];
let _e3544 = (_e3530 + ((bitcast<f32>(_e3539) - _e3530) * _e3541));
let _e3545 = (_e3153 + _e3159);
let _e3546 = local_12.member[1u];
let _e3547 = (_e3545 + _e3546);
let _e3549 = select(_e3138, _e3547, (_e3547 < _e3138));
let _e3554 = global_2.member[bitcast<u32>(select(0i, _e3549, (_e3549 > 0i)))];
let _e3555 = bitcast<f32>(_e3554);
let _e3556 = local_12.member[2u];
let _e3557 = (_e3545 + _e3556);
let _e3559 = select(_e3138, _e3557, (_e3557 < _e3138));
let _e3564 = global_2.member[bitcast<u32>(select(0i, _e3559, (_e3559 > 0i)))];
let _e3566 = local_13[0u];
let _e3570 = (_e3166 + _e3159);
let _e3571 = local_12.member[1u];
let _e3572 = (_e3570 + _e3571);
let _e3574 = select(_e3138, _e3572, (_e3572 < _e3138));
let _e3579 = global_2.member[bitcast<u32>(select(0i, _e3574, (_e3574 > 0i)))];
let _e3580 = bitcast<f32>(_e3579);
let _e3581 = local_12.member[2u];
let _e3582 = (_e3570 + _e3581);
let _e3584 = select(_e3138, _e3582, (_e3582 < _e3138));
let _e3589 = global_2.member[bitcast<u32>(select(0i, _e3584, (_e3584 > 0i)))];
let _e3591 = local_13[0u];
let _e3596 = local_13[1u];
let _e3599 = (_e3231 + ((_e3284 - _e3231) * _e3596));
let _e3600 = local_13[1u];
let _e3603 = (_e3337 + ((_e3390 - _e3337) * _e3600));
let _e3604 = local_13[1u];
let _e3607 = (_e3227 + (((_e3246 + ((_e3256 - _e3246) * _e3277)) - _e3227) * _e3604));
let _e3608 = local_13[1u];
let _e3613 = local_13[2u];
let _e3617 = local_13[1u];
let _e3620 = (_e3235 + (((_e3266 + ((bitcast<f32>(_e3275) - _e3266) * _e3285)) - _e3235) * _e3617));
let _e3621 = local_13[1u];
let _e3625 = local_13[2u];
let _e3629 = local_13[1u];
let _e3632 = (_e3419 + ((_e3231 - _e3419) * _e3629));
let _e3633 = local_13[1u];
let _e3637 = local_13[2u];
let _e3641 = local_13[1u];
let _e3644 = (_e3284 + (((_e3430 + ((bitcast<f32>(_e3439) - _e3430) * _e3441)) - _e3284) * _e3641));
let _e3645 = local_13[1u];
let _e3649 = local_13[2u];
let _e3653 = local_13[1u];
let _e3656 = (_e3519 + (((_e3555 + ((bitcast<f32>(_e3564) - _e3555) * _e3566)) - _e3519) * _e3653));
let _e3657 = local_13[2u];
let _e3661 = local_13[1u];
let _e3665 = local_13[2u];
let _e3669 = local_13[2u];
let _e3676 = global_1.member.member_8.member_8;
let _e3680 = global_1.member.member_8.member_7;
let _e3682 = (((_e3599 + ((_e3603 - _e3599) * _e3669)) - _e3676) * _e3680);
let _e3683 = -(1e9f);
let _e3685 = select(_e3683, _e3682, (_e3682 > _e3683));
let _e3689 = (((_e3607 + (((_e3333 + (((_e3352 + ((_e3362 - _e3352) * _e3383)) - _e3333) * _e3608)) - _e3607) * _e3613)) - _e3676) * _e3680);
let _e3691 = select(_e3683, _e3689, (_e3689 > _e3683));
let _e3695 = (((_e3620 + (((_e3341 + (((_e3372 + ((bitcast<f32>(_e3381) - _e3372) * _e3391)) - _e3341) * _e3621)) - _e3620) * _e3625)) - _e3676) * _e3680);
let _e3697 = select(_e3683, _e3695, (_e3695 > _e3683));
let _e3701 = (((_e3632 + (((_e3469 + ((_e3337 - _e3469) * _e3633)) - _e3632) * _e3637)) - _e3676) * _e3680);
let _e3703 = select(_e3683, _e3701, (_e3701 > _e3683));
let _e3707 = (((_e3644 + (((_e3390 + (((_e3480 + ((bitcast<f32>(_e3489) - _e3480) * _e3491)) - _e3390) * _e3645)) - _e3644) * _e3649)) - _e3676) * _e3680);
let _e3709 = select(_e3683, _e3707, (_e3707 > _e3683));
let _e3713 = (((_e3656 + ((_e3599 - _e3656) * _e3657)) - _e3676) * _e3680);
let _e3715 = select(_e3683, _e3713, (_e3713 > _e3683));
let _e3719 = (((_e3603 + (((_e3544 + (((_e3580 + ((bitcast<f32>(_e3589) - _e3580) * _e3591)) - _e3544) * _e3661)) - _e3603) * _e3665)) - _e3676) * _e3680);
let _e3721 = select(_e3683, _e3719, (_e3719 > _e3683));
let _e3725 = (0.5f * (select(1e9f, _e3697, (_e3697 < 1e9f)) - select(1e9f, _e3691, (_e3691 < 1e9f))));
let _e3727 = (0.5f * (select(1e9f, _e3709, (_e3709 < 1e9f)) - select(1e9f, _e3703, (_e3703 < 1e9f))));
let _e3729 = (0.5f * (select(1e9f, _e3721, (_e3721 < 1e9f)) - select(1e9f, _e3715, (_e3715 < 1e9f))));
let _e3735 = global_1.member.member_8.member.member.member;
let _e3741 = global_1.member.member_8.member.member.member_1;
let _e3747 = global_1.member.member_8.member.member.member_2;
let _e3753 = global_1.member.member_8.member_1.member.member;
let _e3759 = global_1.member.member_8.member_1.member.member_1;
let _e3765 = global_1.member.member_8.member_1.member.member_2;
let _e3771 = global_1.member.member_8.member_2.member.member;
let _e3777 = global_1.member.member_8.member_2.member.member_1;
let _e3783 = global_1.member.member_8.member_2.member.member_2;
phi_9217_ = select(1e9f, _e3685, (_e3685 < 1e9f));
phi_9218_ = vec3<f32>((((_e3735 * _e3725) + (_e3753 * _e3727)) + (_e3771 * _e3729)), (((_e3741 * _e3725) + (_e3759 * _e3727)) + (_e3777 * _e3729)), (((_e3747 * _e3725) + (_e3765 * _e3727)) + (_e3783 * _e3729)));
} else {
let _e3804 = global_1.member.member_8.member_4.member;
let _e3809 = global_1.member.member_8.member_5.member;
let _e3811 = select(_e3804, _e1260, (_e1260 > _e3804));
let _e3813 = select(_e3809, _e3811, (_e3811 < _e3809));
let _e3818 = global_1.member.member_8.member_4.member_1;
let _e3823 = global_1.member.member_8.member_5.member_1;
let _e3825 = select(_e3818, _e1266, (_e1266 > _e3818));
let _e3827 = select(_e3823, _e3825, (_e3825 < _e3823));
let _e3832 = global_1.member.member_8.member_4.member_2;
let _e3837 = global_1.member.member_8.member_5.member_2;
let _e3839 = select(_e3832, _e1272, (_e1272 > _e3832));
let _e3841 = select(_e3837, _e3839, (_e3839 < _e3837));
let _e3846 = global_1.member.member_8.member_15;
if (_e3846 == 0u) {
phi_8841_ = vec3<f32>(_e3813, _e3827, _e3841);
} else {
let _e3848 = (_e3813 + 0.5f);
let _e3853 = global_1.member.member_8.member_3.member;
let _e3854 = (_e3853 - 1f);
let _e3856 = select(0f, _e3848, (_e3848 > 0f));
let _e3858 = select(_e3854, _e3856, (_e3856 < _e3854));
let _e3865 = select(0i, select(select(i32(_e3858), i32(-2147483648), (_e3858 < -2147483600f)), 2147483647i, (_e3858 > 2147483500f)), (_e3858 == _e3858));
let _e3871 = (_e3827 + 0.5f);
let _e3876 = global_1.member.member_8.member_3.member_1;
let _e3877 = (_e3876 - 1f);
let _e3879 = select(0f, _e3871, (_e3871 > 0f));
let _e3881 = select(_e3877, _e3879, (_e3879 < _e3877));
let _e3888 = select(0i, select(select(i32(_e3881), i32(-2147483648), (_e3881 < -2147483600f)), 2147483647i, (_e3881 > 2147483500f)), (_e3881 == _e3881));
let _e3894 = (_e3841 + 0.5f);
let _e3899 = global_1.member.member_8.member_3.member_2;
let _e3900 = (_e3899 - 1f);
let _e3902 = select(0f, _e3894, (_e3894 > 0f));
let _e3904 = select(_e3900, _e3902, (_e3902 < _e3900));
let _e3911 = select(0i, select(select(i32(_e3904), i32(-2147483648), (_e3904 < -2147483600f)), 2147483647i, (_e3904 > 2147483500f)), (_e3904 == _e3904));
phi_8841_ = vec3<f32>(f32((_e3865 - select(0i, 1i, (_e3858 < f32(_e3865))))), f32((_e3888 - select(0i, 1i, (_e3881 < f32(_e3888))))), f32((_e3911 - select(0i, 1i, (_e3904 < f32(_e3911))))));
}
let _e3919 = phi_8841_;
let _e3925 = global_1.member.member_8.member_3.member;
let _e3927 = select(-1f, _e3919.x, (_e3919.x > -1f));
let _e3929 = select(_e3925, _e3927, (_e3927 < _e3925));
let _e3936 = select(0i, select(select(i32(_e3929), i32(-2147483648), (_e3929 < -2147483600f)), 2147483647i, (_e3929 > 2147483500f)), (_e3929 == _e3929));
let _e3940 = (_e3936 - select(0i, 1i, (_e3929 < f32(_e3936))));
let _e3946 = global_1.member.member_8.member_3.member_1;
let _e3948 = select(-1f, _e3919.y, (_e3919.y > -1f));
let _e3950 = select(_e3946, _e3948, (_e3948 < _e3946));
let _e3957 = select(0i, select(select(i32(_e3950), i32(-2147483648), (_e3950 < -2147483600f)), 2147483647i, (_e3950 > 2147483500f)), (_e3950 == _e3950));
let _e3961 = (_e3957 - select(0i, 1i, (_e3950 < f32(_e3957))));
let _e3967 = global_1.member.member_8.member_3.member_2;
let _e3969 = select(-1f, _e3919.z, (_e3919.z > -1f));
let _e3971 = select(_e3967, _e3969, (_e3969 < _e3967));
let _e3978 = select(0i, select(select(i32(_e3971), i32(-2147483648), (_e3971 < -2147483600f)), 2147483647i, (_e3971 > 2147483500f)), (_e3971 == _e3971));
let _e3982 = (_e3978 - select(0i, 1i, (_e3971 < f32(_e3978))));
let _e3986 = global_1.member.member_8.member_9;
let _e3990 = global_1.member.member_8.member_10;
let _e3991 = (_e3940 + 1i);
let _e3992 = (_e3961 + 1i);
let _e3993 = (_e3982 + 1i);
let _e3998 = global_1.member.member_8.member_13.member;
let _e4004 = global_1.member.member_8.member_13.member_1;
let _e4015 = ((_e3991 >> bitcast<u32>(4i)) + (bitcast<i32>(_e3998) * ((_e3992 >> bitcast<u32>(4i)) + (bitcast<i32>(_e4004) * (_e3993 >> bitcast<u32>(4i))))));
let _e4017 = (bitcast<i32>(_e174) - 1i);
let _e4019 = select(_e4017, _e4015, (_e4015 < _e4017));
let _e4025 = global_2.member[bitcast<u32>(select(0i, _e4019, (_e4019 > 0i)))];
let _e4027 = (_e3991 & 15i);
let _e4030 = ((_e3992 & 15i) * _e3986);
let _e4032 = (bitcast<i32>(_e4025) + ((_e3993 & 15i) * _e3990));
let _e4036 = (_e4030 + _e3986);
let _e4038 = (_e4030 + (2i * _e3986));
let _e4039 = (_e4032 + _e3990);
let _e4041 = (_e4032 + (2i * _e3990));
local_10 = type_30(array<i32, 4>(_e4027, (_e4027 + 1i), (_e4027 + 2i), (_e4027 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_11 = (_e3919 - vec3<f32>(f32(_e3940), f32(_e3961), f32(_e3982)));
let _e4050 = (_e4039 + _e4036);
let _e4053 = local_10.member[1u];
let _e4054 = (_e4050 + _e4053);
let _e4056 = select(_e4017, _e4054, (_e4054 < _e4017));
let _e4061 = global_2.member[bitcast<u32>(select(0i, _e4056, (_e4056 > 0i)))];
let _e4062 = bitcast<f32>(_e4061);
let _e4065 = local_10.member[2u];
let _e4066 = (_e4050 + _e4065);
let _e4068 = select(_e4017, _e4066, (_e4066 < _e4017));
let _e4073 = global_2.member[bitcast<u32>(select(0i, _e4068, (_e4068 > 0i)))];
let _e4075 = local_11[0u];
let _e4078 = (_e4062 + ((bitcast<f32>(_e4073) - _e4062) * _e4075));
let _e4079 = (_e4039 + _e4038);
let _e4080 = local_10.member[1u];
let _e4081 = (_e4079 + _e4080);
let _e4083 = select(_e4017, _e4081, (_e4081 < _e4017));
let _e4088 = global_2.member[bitcast<u32>(select(0i, _e4083, (_e4083 > 0i)))];
let _e4089 = bitcast<f32>(_e4088);
let _e4090 = local_10.member[2u];
let _e4091 = (_e4079 + _e4090);
let _e4093 = select(_e4017, _e4091, (_e4091 < _e4017));
let _e4098 = global_2.member[bitcast<u32>(select(0i, _e4093, (_e4093 > 0i)))];
let _e4100 = local_11[0u];
let _e4105 = local_11[1u];
let _e4108 = (_e4078 + (((_e4089 + ((bitcast<f32>(_e4098) - _e4089) * _e4100)) - _e4078) * _e4105));
let _e4109 = (_e4041 + _e4036);
let _e4110 = local_10.member[1u];
let _e4111 = (_e4109 + _e4110);
let _e4113 = select(_e4017, _e4111, (_e4111 < _e4017));
let _e4118 = global_2.member[bitcast<u32>(select(0i, _e4113, (_e4113 > 0i)))];
let _e4119 = bitcast<f32>(_e4118);
let _e4120 = local_10.member[2u];
let _e4121 = (_e4109 + _e4120);
let _e4123 = select(_e4017, _e4121, (_e4121 < _e4017));
let _e4128 = global_2.member[bitcast<u32>(select(0i, _e4123, (_e4123 > 0i)))];
let _e4130 = local_11[0u];
let _e4133 = (_e4119 + ((bitcast<f32>(_e4128) - _e4119) * _e4130));
let _e4134 = (_e4041 + _e4038);
let _e4135 = local_10.member[1u];
let _e4136 = (_e4134 + _e4135);
let _e4138 = select(_e4017, _e4136, (_e4136 < _e4017));
let _e4143 = global_2.member[bitcast<u32>(select(0i, _e4138, (_e4138 > 0i)))];
let _e4144 = bitcast<f32>(_e4143);
let _e4145 = local_10.member[2u];
let _e4146 = (_e4134 + _e4145);
let _e4148 = select(_e4017, _e4146, (_e4146 < _e4017));
let _e4153 = global_2.member[bitcast<u32>(select(0i, _e4148, (_e4148 > 0i)))];
let _e4155 = local_11[0u];
let _e4159 = local_11[1u];
let _e4164 = local_11[2u];
let _e4171 = global_1.member.member_8.member_8;
let _e4175 = global_1.member.member_8.member_7;
let _e4177 = (((_e4108 + (((_e4133 + (((_e4144 + ((bitcast<f32>(_e4153) - _e4144) * _e4155)) - _e4133) * _e4159)) - _e4108) * _e4164)) - _e4171) * _e4175);
let _e4178 = -(1e9f);
let _e4180 = select(_e4178, _e4177, (_e4177 > _e4178));
phi_9217_ = select(1e9f, _e4180, (_e4180 < 1e9f));
phi_9218_ = vec3<f32>(0f, 0f, 0f);
}
let _e4184 = phi_9217_;
let _e4186 = phi_9218_;
phi_9220_ = type_35(_e4184, vec3<f32>(0f, 0f, 0f), _e4186, 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e4189 = phi_9220_;
let _e4194 = global_1.member.member_8.member_4.member;
let _e4199 = global_1.member.member_8.member_5.member;
let _e4201 = select(_e4194, _e1224, (_e1224 > _e4194));
let _e4203 = select(_e4199, _e4201, (_e4201 < _e4199));
let _e4208 = global_1.member.member_8.member_4.member_1;
let _e4213 = global_1.member.member_8.member_5.member_1;
let _e4215 = select(_e4208, _e1239, (_e1239 > _e4208));
let _e4217 = select(_e4213, _e4215, (_e4215 < _e4213));
let _e4222 = global_1.member.member_8.member_4.member_2;
let _e4227 = global_1.member.member_8.member_5.member_2;
let _e4229 = select(_e4222, _e1254, (_e1254 > _e4222));
let _e4231 = select(_e4227, _e4229, (_e4229 < _e4227));
let _e4236 = global_1.member.member_8.member_15;
let _e4237 = (_e4236 == 0u);
if _e4237 {
phi_9366_ = vec3<f32>(_e4203, _e4217, _e4231);
} else {
let _e4238 = (_e4203 + 0.5f);
let _e4243 = global_1.member.member_8.member_3.member;
let _e4244 = (_e4243 - 1f);
let _e4246 = select(0f, _e4238, (_e4238 > 0f));
let _e4248 = select(_e4244, _e4246, (_e4246 < _e4244));
let _e4255 = select(0i, select(select(i32(_e4248), i32(-2147483648), (_e4248 < -2147483600f)), 2147483647i, (_e4248 > 2147483500f)), (_e4248 == _e4248));
let _e4261 = (_e4217 + 0.5f);
let _e4266 = global_1.member.member_8.member_3.member_1;
let _e4267 = (_e4266 - 1f);
let _e4269 = select(0f, _e4261, (_e4261 > 0f));
let _e4271 = select(_e4267, _e4269, (_e4269 < _e4267));
let _e4278 = select(0i, select(select(i32(_e4271), i32(-2147483648), (_e4271 < -2147483600f)), 2147483647i, (_e4271 > 2147483500f)), (_e4271 == _e4271));
let _e4284 = (_e4231 + 0.5f);
let _e4289 = global_1.member.member_8.member_3.member_2;
let _e4290 = (_e4289 - 1f);
let _e4292 = select(0f, _e4284, (_e4284 > 0f));
let _e4294 = select(_e4290, _e4292, (_e4292 < _e4290));
let _e4301 = select(0i, select(select(i32(_e4294), i32(-2147483648), (_e4294 < -2147483600f)), 2147483647i, (_e4294 > 2147483500f)), (_e4294 == _e4294));
phi_9366_ = vec3<f32>(f32((_e4255 - select(0i, 1i, (_e4248 < f32(_e4255))))), f32((_e4278 - select(0i, 1i, (_e4271 < f32(_e4278))))), f32((_e4301 - select(0i, 1i, (_e4294 < f32(_e4301))))));
}
let _e4309 = phi_9366_;
let _e4315 = global_1.member.member_8.member_3.member;
let _e4317 = select(-1f, _e4309.x, (_e4309.x > -1f));
let _e4319 = select(_e4315, _e4317, (_e4317 < _e4315));
let _e4326 = select(0i, select(select(i32(_e4319), i32(-2147483648), (_e4319 < -2147483600f)), 2147483647i, (_e4319 > 2147483500f)), (_e4319 == _e4319));
let _e4330 = (_e4326 - select(0i, 1i, (_e4319 < f32(_e4326))));
let _e4336 = global_1.member.member_8.member_3.member_1;
let _e4338 = select(-1f, _e4309.y, (_e4309.y > -1f));
let _e4340 = select(_e4336, _e4338, (_e4338 < _e4336));
let _e4347 = select(0i, select(select(i32(_e4340), i32(-2147483648), (_e4340 < -2147483600f)), 2147483647i, (_e4340 > 2147483500f)), (_e4340 == _e4340));
let _e4351 = (_e4347 - select(0i, 1i, (_e4340 < f32(_e4347))));
let _e4357 = global_1.member.member_8.member_3.member_2;
let _e4359 = select(-1f, _e4309.z, (_e4309.z > -1f));
let _e4361 = select(_e4357, _e4359, (_e4359 < _e4357));
let _e4368 = select(0i, select(select(i32(_e4361), i32(-2147483648), (_e4361 < -2147483600f)), 2147483647i, (_e4361 > 2147483500f)), (_e4361 == _e4361));
let _e4372 = (_e4368 - select(0i, 1i, (_e4361 < f32(_e4368))));
let _e4376 = global_1.member.member_8.member_9;
let _e4380 = global_1.member.member_8.member_10;
let _e4381 = (_e4330 + 1i);
let _e4382 = (_e4351 + 1i);
let _e4383 = (_e4372 + 1i);
let _e4388 = global_1.member.member_8.member_13.member;
let _e4389 = bitcast<i32>(_e4388);
let _e4394 = global_1.member.member_8.member_13.member_1;
let _e4395 = bitcast<i32>(_e4394);
let _e4405 = ((_e4381 >> bitcast<u32>(4i)) + (_e4389 * ((_e4382 >> bitcast<u32>(4i)) + (_e4395 * (_e4383 >> bitcast<u32>(4i))))));
let _e4407 = (bitcast<i32>(_e174) - 1i);
let _e4409 = select(_e4407, _e4405, (_e4405 < _e4407));
let _e4415 = global_2.member[bitcast<u32>(select(0i, _e4409, (_e4409 > 0i)))];
let _e4417 = (_e4381 & 15i);
let _e4420 = ((_e4382 & 15i) * _e4376);
let _e4422 = (bitcast<i32>(_e4415) + ((_e4383 & 15i) * _e4380));
let _e4426 = (_e4420 + _e4376);
let _e4427 = (2i * _e4376);
let _e4428 = (_e4420 + _e4427);
let _e4429 = (_e4422 + _e4380);
let _e4430 = (2i * _e4380);
let _e4431 = (_e4422 + _e4430);
local_8 = type_30(array<i32, 4>(_e4417, (_e4417 + 1i), (_e4417 + 2i), (_e4417 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_9 = (_e4309 - vec3<f32>(f32(_e4330), f32(_e4351), f32(_e4372)));
let _e4440 = (_e4429 + _e4426);
let _e4443 = local_8.member[1u];
let _e4444 = (_e4440 + _e4443);
let _e4446 = select(_e4407, _e4444, (_e4444 < _e4407));
let _e4451 = global_2.member[bitcast<u32>(select(0i, _e4446, (_e4446 > 0i)))];
let _e4452 = bitcast<f32>(_e4451);
let _e4455 = local_8.member[2u];
let _e4456 = (_e4440 + _e4455);
let _e4458 = select(_e4407, _e4456, (_e4456 < _e4407));
let _e4463 = global_2.member[bitcast<u32>(select(0i, _e4458, (_e4458 > 0i)))];
let _e4465 = local_9[0u];
let _e4468 = (_e4452 + ((bitcast<f32>(_e4463) - _e4452) * _e4465));
let _e4469 = (_e4429 + _e4428);
let _e4470 = local_8.member[1u];
let _e4471 = (_e4469 + _e4470);
let _e4473 = select(_e4407, _e4471, (_e4471 < _e4407));
let _e4478 = global_2.member[bitcast<u32>(select(0i, _e4473, (_e4473 > 0i)))];
let _e4479 = bitcast<f32>(_e4478);
let _e4480 = local_8.member[2u];
let _e4481 = (_e4469 + _e4480);
let _e4483 = select(_e4407, _e4481, (_e4481 < _e4407));
let _e4488 = global_2.member[bitcast<u32>(select(0i, _e4483, (_e4483 > 0i)))];
let _e4490 = local_9[0u];
let _e4495 = local_9[1u];
let _e4498 = (_e4468 + (((_e4479 + ((bitcast<f32>(_e4488) - _e4479) * _e4490)) - _e4468) * _e4495));
let _e4499 = (_e4431 + _e4426);
let _e4500 = local_8.member[1u];
let _e4501 = (_e4499 + _e4500);
let _e4503 = select(_e4407, _e4501, (_e4501 < _e4407));
let _e4508 = global_2.member[bitcast<u32>(select(0i, _e4503, (_e4503 > 0i)))];
let _e4509 = bitcast<f32>(_e4508);
let _e4510 = local_8.member[2u];
let _e4511 = (_e4499 + _e4510);
let _e4513 = select(_e4407, _e4511, (_e4511 < _e4407));
let _e4518 = global_2.member[bitcast<u32>(select(0i, _e4513, (_e4513 > 0i)))];
let _e4520 = local_9[0u];
let _e4523 = (_e4509 + ((bitcast<f32>(_e4518) - _e4509) * _e4520));
let _e4524 = (_e4431 + _e4428);
let _e4525 = local_8.member[1u];
let _e4526 = (_e4524 + _e4525);
let _e4528 = select(_e4407, _e4526, (_e4526 < _e4407));
let _e4533 = global_2.member[bitcast<u32>(select(0i, _e4528, (_e4528 > 0i)))];
let _e4534 = bitcast<f32>(_e4533);
let _e4535 = local_8.member[2u];
let _e4536 = (_e4524 + _e4535);
let _e4538 = select(_e4407, _e4536, (_e4536 < _e4407));
let _e4543 = global_2.member[bitcast<u32>(select(0i, _e4538, (_e4538 > 0i)))];
let _e4545 = local_9[0u];
let _e4549 = local_9[1u];
let _e4554 = local_9[2u];
let _e4561 = global_1.member.member_8.member_8;
let _e4565 = global_1.member.member_8.member_7;
let _e4567 = (((_e4498 + (((_e4523 + (((_e4534 + ((bitcast<f32>(_e4543) - _e4534) * _e4545)) - _e4523) * _e4549)) - _e4498) * _e4554)) - _e4561) * _e4565);
let _e4568 = -(1e9f);
let _e4570 = select(_e4568, _e4567, (_e4567 > _e4568));
let _e4575 = select(select(1e9f, _e4570, (_e4570 < 1e9f)), _e4189.member, (_e4236 != 0u));
let _e4578 = global_1.member.member_1;
let _e4580 = ((_e4578 & 16u) == 0u);
if _e4580 {
phi_10262_ = type_36(type_33(0f, 1f), type_33(0f, 1f), 1f);
} else {
let _e4584 = global_1.member.member_16.member;
let _e4595 = ((((_e4584.member.member * _e1181) + (_e4584.member.member_1 * _e1194)) + (_e4584.member.member_2 * _e1159)) + _e4584.member_1);
let _e4601 = ((((_e4584.member.member * _e1204) + (_e4584.member.member_1 * _e1209)) + (_e4584.member.member_2 * _e1198)) + _e4584.member_1);
let _e4608 = bitcast<f32>((bitcast<u32>((_e4595 - _e4601)) & 2147483647u));
let _e4611 = (bitcast<f32>((bitcast<u32>(_e4595) & 2147483647u)) / select(1e-30f, _e4608, (_e4608 > 1e-30f)));
let _e4613 = select(0f, _e4611, (_e4611 > 0f));
let _e4615 = select(1f, _e4613, (_e4613 < 1f));
let _e4616 = (_e4595 > 0f);
let _e4617 = (_e4601 > 0f);
let _e4619 = select(0f, select(_e4615, 1f, _e4617), _e4616);
let _e4621 = select(1f, select(_e4615, 1f, _e4616), _e4617);
let _e4625 = global_1.member.member_16.member_1;
let _e4626 = (_e4625 != 0u);
let _e4628 = select(_e4619, 0f, (0f > _e4619));
let _e4630 = select(_e4621, 1f, (1f < _e4621));
let _e4631 = select(0f, _e4619, _e4626);
let _e4632 = select(1f, _e4621, _e4626);
let _e4634 = select(_e4631, 0f, (0f > _e4631));
let _e4636 = select(_e4632, 1f, (1f < _e4632));
let _e4643 = global_1.member.member_17.member;
let _e4654 = ((((_e4643.member.member * _e1181) + (_e4643.member.member_1 * _e1194)) + (_e4643.member.member_2 * _e1159)) + _e4643.member_1);
let _e4660 = ((((_e4643.member.member * _e1204) + (_e4643.member.member_1 * _e1209)) + (_e4643.member.member_2 * _e1198)) + _e4643.member_1);
let _e4667 = bitcast<f32>((bitcast<u32>((_e4654 - _e4660)) & 2147483647u));
let _e4670 = (bitcast<f32>((bitcast<u32>(_e4654) & 2147483647u)) / select(1e-30f, _e4667, (_e4667 > 1e-30f)));
let _e4672 = select(0f, _e4670, (_e4670 > 0f));
let _e4674 = select(1f, _e4672, (_e4672 < 1f));
let _e4675 = (_e4654 > 0f);
let _e4676 = (_e4660 > 0f);
let _e4678 = select(0f, select(_e4674, 1f, _e4676), _e4675);
let _e4680 = select(1f, select(_e4674, 1f, _e4675), _e4676);
let _e4684 = global_1.member.member_17.member_1;
let _e4685 = (_e4684 != 0u);
let _e4687 = select(_e4678, _e4628, (_e4628 > _e4678));
let _e4689 = select(_e4680, _e4630, (_e4630 < _e4680));
let _e4690 = select(0f, _e4678, _e4685);
let _e4691 = select(1f, _e4680, _e4685);
let _e4693 = select(_e4690, _e4634, (_e4634 > _e4690));
let _e4695 = select(_e4691, _e4636, (_e4636 < _e4691));
let _e4702 = global_1.member.member_18.member;
let _e4713 = ((((_e4702.member.member * _e1181) + (_e4702.member.member_1 * _e1194)) + (_e4702.member.member_2 * _e1159)) + _e4702.member_1);
let _e4719 = ((((_e4702.member.member * _e1204) + (_e4702.member.member_1 * _e1209)) + (_e4702.member.member_2 * _e1198)) + _e4702.member_1);
let _e4726 = bitcast<f32>((bitcast<u32>((_e4713 - _e4719)) & 2147483647u));
let _e4729 = (bitcast<f32>((bitcast<u32>(_e4713) & 2147483647u)) / select(1e-30f, _e4726, (_e4726 > 1e-30f)));
let _e4731 = select(0f, _e4729, (_e4729 > 0f));
let _e4733 = select(1f, _e4731, (_e4731 < 1f));
let _e4734 = (_e4713 > 0f);
let _e4735 = (_e4719 > 0f);
let _e4737 = select(0f, select(_e4733, 1f, _e4735), _e4734);
let _e4739 = select(1f, select(_e4733, 1f, _e4734), _e4735);
let _e4743 = global_1.member.member_18.member_1;
let _e4744 = (_e4743 != 0u);
let _e4746 = select(_e4737, _e4687, (_e4687 > _e4737));
let _e4748 = select(_e4739, _e4689, (_e4689 < _e4739));
let _e4749 = select(0f, _e4737, _e4744);
let _e4750 = select(1f, _e4739, _e4744);
let _e4752 = select(_e4749, _e4693, (_e4693 > _e4749));
let _e4754 = select(_e4750, _e4695, (_e4695 < _e4750));
let _e4761 = global_1.member.member_19.member;
let _e4772 = ((((_e4761.member.member * _e1181) + (_e4761.member.member_1 * _e1194)) + (_e4761.member.member_2 * _e1159)) + _e4761.member_1);
let _e4778 = ((((_e4761.member.member * _e1204) + (_e4761.member.member_1 * _e1209)) + (_e4761.member.member_2 * _e1198)) + _e4761.member_1);
let _e4785 = bitcast<f32>((bitcast<u32>((_e4772 - _e4778)) & 2147483647u));
let _e4788 = (bitcast<f32>((bitcast<u32>(_e4772) & 2147483647u)) / select(1e-30f, _e4785, (_e4785 > 1e-30f)));
let _e4790 = select(0f, _e4788, (_e4788 > 0f));
let _e4792 = select(1f, _e4790, (_e4790 < 1f));
let _e4793 = (_e4772 > 0f);
let _e4794 = (_e4778 > 0f);
let _e4796 = select(0f, select(_e4792, 1f, _e4794), _e4793);
let _e4798 = select(1f, select(_e4792, 1f, _e4793), _e4794);
let _e4802 = global_1.member.member_19.member_1;
let _e4803 = (_e4802 != 0u);
let _e4808 = select(0f, _e4796, _e4803);
let _e4809 = select(1f, _e4798, _e4803);
phi_10262_ = type_36(type_33(select(_e4796, _e4746, (_e4746 > _e4796)), select(_e4798, _e4748, (_e4748 < _e4798))), type_33(select(_e4808, _e4752, (_e4752 > _e4808)), select(_e4809, _e4754, (_e4754 < _e4809))), ((((1f * select(1f, 0f, (_e4626 && _e4617))) * select(1f, 0f, (_e4685 && _e4676))) * select(1f, 0f, (_e4744 && _e4735))) * select(1f, 0f, (_e4803 && _e4794))));
}
let _e4821 = phi_10262_;
let _e4822 = (_e1260 - _e1224);
let _e4826 = (bitcast<f32>((bitcast<u32>(_e4822) & 2147483647u)) < 1e-12f);
let _e4828 = (1f / select(_e4822, 1f, _e4826));
let _e4829 = (_e4194 - _e1224);
let _e4830 = (_e4829 * _e4828);
let _e4832 = ((_e4199 - _e1224) * _e4828);
let _e4838 = select(_e4832, _e4830, (_e4830 < _e4832));
let _e4840 = select(0f, _e4838, (_e4838 > 0f));
let _e4843 = select(select(1f, _e4840, (_e4840 < 1f)), select(2f, 0f, ((_e1224 >= _e4194) && (_e1224 <= _e4199))), _e4826);
let _e4845 = select(_e4832, _e4830, (_e4830 > _e4832));
let _e4847 = select(0f, _e4845, (_e4845 > 0f));
let _e4850 = select(select(1f, _e4847, (_e4847 < 1f)), 1f, _e4826);
let _e4851 = (_e1266 - _e1239);
let _e4855 = (bitcast<f32>((bitcast<u32>(_e4851) & 2147483647u)) < 1e-12f);
let _e4857 = (1f / select(_e4851, 1f, _e4855));
let _e4858 = (_e4208 - _e1239);
let _e4859 = (_e4858 * _e4857);
let _e4861 = ((_e4213 - _e1239) * _e4857);
let _e4867 = select(_e4861, _e4859, (_e4859 < _e4861));
let _e4869 = select(0f, _e4867, (_e4867 > 0f));
let _e4872 = select(select(1f, _e4869, (_e4869 < 1f)), select(2f, 0f, ((_e1239 >= _e4208) && (_e1239 <= _e4213))), _e4855);
let _e4874 = select(_e4861, _e4859, (_e4859 > _e4861));
let _e4876 = select(0f, _e4874, (_e4874 > 0f));
let _e4879 = select(select(1f, _e4876, (_e4876 < 1f)), 1f, _e4855);
let _e4880 = (_e1272 - _e1254);
let _e4884 = (bitcast<f32>((bitcast<u32>(_e4880) & 2147483647u)) < 1e-12f);
let _e4886 = (1f / select(_e4880, 1f, _e4884));
let _e4887 = (_e4222 - _e1254);
let _e4888 = (_e4887 * _e4886);
let _e4890 = ((_e4227 - _e1254) * _e4886);
let _e4896 = select(_e4890, _e4888, (_e4888 < _e4890));
let _e4898 = select(0f, _e4896, (_e4896 > 0f));
let _e4901 = select(select(1f, _e4898, (_e4898 < 1f)), select(2f, 0f, ((_e1254 >= _e4222) && (_e1254 <= _e4227))), _e4884);
let _e4903 = select(_e4890, _e4888, (_e4888 > _e4890));
let _e4905 = select(0f, _e4903, (_e4903 > 0f));
let _e4908 = select(select(1f, _e4905, (_e4905 < 1f)), 1f, _e4884);
let _e4910 = select(_e4872, _e4843, (_e4843 > _e4872));
let _e4914 = select(_e4879, _e4850, (_e4850 < _e4879));
let _e4917 = (select(_e4908, _e4914, (_e4914 < _e4908)) - select(_e4901, _e4910, (_e4910 > _e4901)));
let _e4919 = select(0f, _e4917, (_e4917 > 0f));
let _e4920 = (_e1204 - _e1181);
let _e4921 = (_e1209 - _e1194);
let _e4922 = (_e1198 - _e1159);
let _e4927 = (((_e4920 * _e4920) + (_e4921 * _e4921)) + (_e4922 * _e4922));
let _e4935 = global_1.member.member_7.member_3;
let _e4936 = ((sqrt(select(0f, _e4927, (_e4927 > 0f))) * _e4919) * _e4935);
if (((_e189.member_2 == 3u) || (_e189.member_2 == 4u)) || _e1274) {
local_7 = _e4575;
let _e4941 = local_7;
let _e4943 = (bitcast<i32>(_e179) - 1i);
let _e4945 = select(_e4943, 263171i, (263171i < _e4943));
let _e4950 = global_3.member[bitcast<u32>(select(0i, _e4945, (_e4945 > 0i)))];
let _e4951 = bitcast<f32>(_e4950);
let _e4953 = select(_e4943, 263172i, (263172i < _e4943));
let _e4958 = global_3.member[bitcast<u32>(select(0i, _e4953, (_e4953 > 0i)))];
let _e4959 = bitcast<f32>(_e4958);
let _e4961 = select(_e4943, 263173i, (263173i < _e4943));
let _e4966 = global_3.member[bitcast<u32>(select(0i, _e4961, (_e4961 > 0i)))];
let _e4967 = bitcast<f32>(_e4966);
let _e4969 = ((_e4941 - _e4951) * _e4959);
let _e4971 = select(0f, _e4969, (_e4969 > 0f));
let _e4974 = local_7;
let _e4976 = select(_e4943, 263174i, (263174i < _e4943));
let _e4981 = global_3.member[bitcast<u32>(select(0i, _e4976, (_e4976 > 0i)))];
let _e4982 = bitcast<f32>(_e4981);
let _e4984 = select(_e4943, 263175i, (263175i < _e4943));
let _e4989 = global_3.member[bitcast<u32>(select(0i, _e4984, (_e4984 > 0i)))];
let _e4990 = bitcast<f32>(_e4989);
let _e4992 = select(_e4943, 263176i, (263176i < _e4943));
let _e4997 = global_3.member[bitcast<u32>(select(0i, _e4992, (_e4992 > 0i)))];
let _e4998 = bitcast<f32>(_e4997);
let _e5000 = ((_e4974 - _e4982) * _e4990);
let _e5002 = select(0f, _e5000, (_e5000 > 0f));
let _e5006 = local_7;
let _e5008 = select(_e4943, 263177i, (263177i < _e4943));
let _e5013 = global_3.member[bitcast<u32>(select(0i, _e5008, (_e5008 > 0i)))];
let _e5014 = bitcast<f32>(_e5013);
let _e5016 = select(_e4943, 263178i, (263178i < _e4943));
let _e5021 = global_3.member[bitcast<u32>(select(0i, _e5016, (_e5016 > 0i)))];
let _e5022 = bitcast<f32>(_e5021);
let _e5024 = select(_e4943, 263179i, (263179i < _e4943));
let _e5029 = global_3.member[bitcast<u32>(select(0i, _e5024, (_e5024 > 0i)))];
let _e5030 = bitcast<f32>(_e5029);
let _e5032 = ((_e5006 - _e5014) * _e5022);
let _e5034 = select(0f, _e5032, (_e5032 > 0f));
let _e5037 = local_7;
let _e5039 = select(_e4943, 263180i, (263180i < _e4943));
let _e5044 = global_3.member[bitcast<u32>(select(0i, _e5039, (_e5039 > 0i)))];
let _e5045 = bitcast<f32>(_e5044);
let _e5047 = select(_e4943, 263181i, (263181i < _e4943));
let _e5052 = global_3.member[bitcast<u32>(select(0i, _e5047, (_e5047 > 0i)))];
let _e5053 = bitcast<f32>(_e5052);
let _e5055 = select(_e4943, 263182i, (263182i < _e4943));
let _e5060 = global_3.member[bitcast<u32>(select(0i, _e5055, (_e5055 > 0i)))];
let _e5061 = bitcast<f32>(_e5060);
let _e5063 = ((_e5037 - _e5045) * _e5053);
let _e5065 = select(0f, _e5063, (_e5063 > 0f));
let _e5070 = local_7;
let _e5072 = select(_e4943, 263183i, (263183i < _e4943));
let _e5077 = global_3.member[bitcast<u32>(select(0i, _e5072, (_e5072 > 0i)))];
let _e5078 = bitcast<f32>(_e5077);
let _e5080 = select(_e4943, 263184i, (263184i < _e4943));
let _e5085 = global_3.member[bitcast<u32>(select(0i, _e5080, (_e5080 > 0i)))];
let _e5086 = bitcast<f32>(_e5085);
let _e5088 = select(_e4943, 263185i, (263185i < _e4943));
let _e5093 = global_3.member[bitcast<u32>(select(0i, _e5088, (_e5088 > 0i)))];
let _e5094 = bitcast<f32>(_e5093);
let _e5096 = ((_e5070 - _e5078) * _e5086);
let _e5098 = select(0f, _e5096, (_e5096 > 0f));
let _e5101 = local_7;
let _e5103 = select(_e4943, 263186i, (263186i < _e4943));
let _e5108 = global_3.member[bitcast<u32>(select(0i, _e5103, (_e5103 > 0i)))];
let _e5109 = bitcast<f32>(_e5108);
let _e5111 = select(_e4943, 263187i, (263187i < _e4943));
let _e5116 = global_3.member[bitcast<u32>(select(0i, _e5111, (_e5111 > 0i)))];
let _e5117 = bitcast<f32>(_e5116);
let _e5119 = select(_e4943, 263188i, (263188i < _e4943));
let _e5124 = global_3.member[bitcast<u32>(select(0i, _e5119, (_e5119 > 0i)))];
let _e5125 = bitcast<f32>(_e5124);
let _e5127 = ((_e5101 - _e5109) * _e5117);
let _e5129 = select(0f, _e5127, (_e5127 > 0f));
let _e5133 = local_7;
let _e5135 = select(_e4943, 263189i, (263189i < _e4943));
let _e5140 = global_3.member[bitcast<u32>(select(0i, _e5135, (_e5135 > 0i)))];
let _e5141 = bitcast<f32>(_e5140);
let _e5143 = select(_e4943, 263190i, (263190i < _e4943));
let _e5148 = global_3.member[bitcast<u32>(select(0i, _e5143, (_e5143 > 0i)))];
let _e5149 = bitcast<f32>(_e5148);
let _e5151 = select(_e4943, 263191i, (263191i < _e4943));
let _e5156 = global_3.member[bitcast<u32>(select(0i, _e5151, (_e5151 > 0i)))];
let _e5157 = bitcast<f32>(_e5156);
let _e5159 = ((_e5133 - _e5141) * _e5149);
let _e5161 = select(0f, _e5159, (_e5159 > 0f));
let _e5164 = local_7;
let _e5166 = select(_e4943, 263192i, (263192i < _e4943));
let _e5171 = global_3.member[bitcast<u32>(select(0i, _e5166, (_e5166 > 0i)))];
let _e5172 = bitcast<f32>(_e5171);
let _e5174 = select(_e4943, 263193i, (263193i < _e4943));
let _e5179 = global_3.member[bitcast<u32>(select(0i, _e5174, (_e5174 > 0i)))];
let _e5180 = bitcast<f32>(_e5179);
let _e5182 = select(_e4943, 263194i, (263194i < _e4943));
let _e5187 = global_3.member[bitcast<u32>(select(0i, _e5182, (_e5182 > 0i)))];
let _e5188 = bitcast<f32>(_e5187);
let _e5190 = ((_e5164 - _e5172) * _e5180);
let _e5192 = select(0f, _e5190, (_e5190 > 0f));
let _e5197 = (((select(_e4967, _e4971, (_e4971 < _e4967)) + select(_e4998, _e5002, (_e5002 < _e4998))) + (select(_e5030, _e5034, (_e5034 < _e5030)) + select(_e5061, _e5065, (_e5065 < _e5061)))) + ((select(_e5094, _e5098, (_e5098 < _e5094)) + select(_e5125, _e5129, (_e5129 < _e5125))) + (select(_e5157, _e5161, (_e5161 < _e5157)) + select(_e5188, _e5192, (_e5192 < _e5188)))));
local_6 = _e4189.member;
let _e5198 = local_6;
let _e5200 = ((_e5198 - _e4951) * _e4959);
let _e5202 = select(0f, _e5200, (_e5200 > 0f));
let _e5205 = local_6;
let _e5207 = ((_e5205 - _e4982) * _e4990);
let _e5209 = select(0f, _e5207, (_e5207 > 0f));
let _e5213 = local_6;
let _e5215 = ((_e5213 - _e5014) * _e5022);
let _e5217 = select(0f, _e5215, (_e5215 > 0f));
let _e5220 = local_6;
let _e5222 = ((_e5220 - _e5045) * _e5053);
let _e5224 = select(0f, _e5222, (_e5222 > 0f));
let _e5229 = local_6;
let _e5231 = ((_e5229 - _e5078) * _e5086);
let _e5233 = select(0f, _e5231, (_e5231 > 0f));
let _e5236 = local_6;
let _e5238 = ((_e5236 - _e5109) * _e5117);
let _e5240 = select(0f, _e5238, (_e5238 > 0f));
let _e5244 = local_6;
let _e5246 = ((_e5244 - _e5141) * _e5149);
let _e5248 = select(0f, _e5246, (_e5246 > 0f));
let _e5251 = local_6;
let _e5253 = ((_e5251 - _e5172) * _e5180);
let _e5255 = select(0f, _e5253, (_e5253 > 0f));
let _e5260 = (((select(_e4967, _e5202, (_e5202 < _e4967)) + select(_e4998, _e5209, (_e5209 < _e4998))) + (select(_e5030, _e5217, (_e5217 < _e5030)) + select(_e5061, _e5224, (_e5224 < _e5061)))) + ((select(_e5094, _e5233, (_e5233 < _e5094)) + select(_e5125, _e5240, (_e5240 < _e5125))) + (select(_e5157, _e5248, (_e5248 < _e5157)) + select(_e5188, _e5255, (_e5255 < _e5188)))));
let _e5261 = (255f - 1f);
let _e5263 = select(0f, _e5197, (_e5197 > 0f));
let _e5265 = select(_e5261, _e5263, (_e5263 < _e5261));
let _e5272 = select(0i, select(select(i32(_e5265), i32(-2147483648), (_e5265 < -2147483600f)), 2147483647i, (_e5265 > 2147483500f)), (_e5265 == _e5265));
let _e5276 = (_e5272 - select(0i, 1i, (_e5265 < f32(_e5272))));
let _e5278 = select(0f, _e5260, (_e5260 > 0f));
let _e5280 = select(_e5261, _e5278, (_e5278 < _e5261));
let _e5287 = select(0i, select(select(i32(_e5280), i32(-2147483648), (_e5280 < -2147483600f)), 2147483647i, (_e5280 > 2147483500f)), (_e5280 == _e5280));
let _e5291 = (_e5287 - select(0i, 1i, (_e5280 < f32(_e5287))));
let _e5293 = select(_e4943, 263195i, (263195i < _e4943));
let _e5299 = global_3.member[bitcast<u32>(select(0i, _e5293, (_e5293 > 0i)))];
let _e5300 = bitcast<f32>(_e5299);
let _e5302 = select(_e4943, 263196i, (263196i < _e4943));
let _e5308 = global_3.member[bitcast<u32>(select(0i, _e5302, (_e5302 > 0i)))];
let _e5309 = bitcast<f32>(_e5308);
let _e5310 = (_e4189.member - _e4575);
let _e5316 = (1f / select(_e5310, 1f, (bitcast<f32>((bitcast<u32>(_e5310) & 2147483647u)) < 1e-20f)));
let _e5322 = ((select(_e5300, _e4189.member, (_e4189.member < _e5300)) - select(_e5300, _e4575, (_e4575 < _e5300))) * _e5316);
let _e5328 = ((select(_e5309, _e4189.member, (_e4189.member > _e5309)) - select(_e5309, _e4575, (_e4575 > _e5309))) * _e5316);
let _e5331 = (((_e5276 * 256i) + _e5291) * 4i);
let _e5335 = (_e5260 - f32(_e5291));
let _e5338 = (_e5331 + 1i);
let _e5340 = select(_e4943, _e5338, (_e5338 < _e4943));
let _e5346 = global_3.member[bitcast<u32>(select(0i, _e5340, (_e5340 > 0i)))];
let _e5353 = (bitcast<f32>((((_e5346 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5354 = (_e5331 + 5i);
let _e5356 = select(_e4943, _e5354, (_e5354 < _e4943));
let _e5362 = global_3.member[bitcast<u32>(select(0i, _e5356, (_e5356 > 0i)))];
let _e5370 = (_e5331 + 1025i);
let _e5372 = select(_e4943, _e5370, (_e5370 < _e4943));
let _e5378 = global_3.member[bitcast<u32>(select(0i, _e5372, (_e5372 > 0i)))];
let _e5385 = (bitcast<f32>((((_e5378 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5386 = (_e5331 + 1029i);
let _e5388 = select(_e4943, _e5386, (_e5386 < _e4943));
let _e5394 = global_3.member[bitcast<u32>(select(0i, _e5388, (_e5388 > 0i)))];
let _e5404 = (_e5353 + (((bitcast<f32>((((_e5362 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5353) * _e5335));
let _e5412 = select(_e4943, 1i, (1i < _e4943));
let _e5418 = global_3.member[bitcast<u32>(select(0i, _e5412, (_e5412 > 0i)))];
let _e5427 = select(_e4943, 262141i, (262141i < _e4943));
let _e5433 = global_3.member[bitcast<u32>(select(0i, _e5427, (_e5427 > 0i)))];
let _e5445 = (((_e5404 + (((_e5385 + (((bitcast<f32>((((_e5394 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5385) * _e5335)) - _e5404) * (_e5197 - f32(_e5276)))) * (1f - (_e5322 + _e5328))) + (((bitcast<f32>((((_e5418 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5322) + ((bitcast<f32>((((_e5433 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5328)));
let _e5450 = (_e4821.member.member_1 - _e4821.member.member);
let _e5455 = -((_e5445 * (_e4936 * select(0f, _e5450, (_e5450 > 0f)))));
let _e5457 = select(-87f, _e5455, (_e5455 > -87f));
let _e5459 = select(88f, _e5457, (_e5457 < 88f));
let _e5461 = ((_e5459 * 1.442695f) + 0.5f);
let _e5463 = select(-127f, _e5461, (_e5461 > -127f));
let _e5465 = select(128f, _e5463, (_e5463 < 128f));
let _e5472 = select(0i, select(select(i32(_e5465), i32(-2147483648), (_e5465 < -2147483600f)), 2147483647i, (_e5465 > 2147483500f)), (_e5465 == _e5465));
let _e5476 = (_e5472 - select(0i, 1i, (_e5465 < f32(_e5472))));
let _e5477 = f32(_e5476);
let _e5481 = ((_e5459 - (_e5477 * 0.6933594f)) - (_e5477 * -2.1219444e-4f));
let _e5501 = ((1f + (_e5481 * (1f + (_e5481 * (0.5f + (_e5481 * (0.16666667f + (_e5481 * (0.041666668f + (_e5481 * (0.008333334f + (_e5481 * (0.001388889f + (_e5481 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5476 + 127i)) << bitcast<u32>(23i))));
let _e5502 = (1f - _e5501);
phi_14206_ = type_38(_e5501, _e5502, vec3<f32>(1f, 1f, 1f), vec3((0f * (_e5502 / select(1e-12f, _e5445, (_e5445 > 1e-12f))))));
} else {
local_5 = _e4575;
let _e5509 = local_5;
let _e5511 = (bitcast<i32>(_e179) - 1i);
let _e5513 = select(_e5511, 263171i, (263171i < _e5511));
let _e5518 = global_3.member[bitcast<u32>(select(0i, _e5513, (_e5513 > 0i)))];
let _e5519 = bitcast<f32>(_e5518);
let _e5521 = select(_e5511, 263172i, (263172i < _e5511));
let _e5526 = global_3.member[bitcast<u32>(select(0i, _e5521, (_e5521 > 0i)))];
let _e5527 = bitcast<f32>(_e5526);
let _e5529 = select(_e5511, 263173i, (263173i < _e5511));
let _e5534 = global_3.member[bitcast<u32>(select(0i, _e5529, (_e5529 > 0i)))];
let _e5535 = bitcast<f32>(_e5534);
let _e5537 = ((_e5509 - _e5519) * _e5527);
let _e5539 = select(0f, _e5537, (_e5537 > 0f));
let _e5542 = local_5;
let _e5544 = select(_e5511, 263174i, (263174i < _e5511));
let _e5549 = global_3.member[bitcast<u32>(select(0i, _e5544, (_e5544 > 0i)))];
let _e5550 = bitcast<f32>(_e5549);
let _e5552 = select(_e5511, 263175i, (263175i < _e5511));
let _e5557 = global_3.member[bitcast<u32>(select(0i, _e5552, (_e5552 > 0i)))];
let _e5558 = bitcast<f32>(_e5557);
let _e5560 = select(_e5511, 263176i, (263176i < _e5511));
let _e5565 = global_3.member[bitcast<u32>(select(0i, _e5560, (_e5560 > 0i)))];
let _e5566 = bitcast<f32>(_e5565);
let _e5568 = ((_e5542 - _e5550) * _e5558);
let _e5570 = select(0f, _e5568, (_e5568 > 0f));
let _e5574 = local_5;
let _e5576 = select(_e5511, 263177i, (263177i < _e5511));
let _e5581 = global_3.member[bitcast<u32>(select(0i, _e5576, (_e5576 > 0i)))];
let _e5582 = bitcast<f32>(_e5581);
let _e5584 = select(_e5511, 263178i, (263178i < _e5511));
let _e5589 = global_3.member[bitcast<u32>(select(0i, _e5584, (_e5584 > 0i)))];
let _e5590 = bitcast<f32>(_e5589);
let _e5592 = select(_e5511, 263179i, (263179i < _e5511));
let _e5597 = global_3.member[bitcast<u32>(select(0i, _e5592, (_e5592 > 0i)))];
let _e5598 = bitcast<f32>(_e5597);
let _e5600 = ((_e5574 - _e5582) * _e5590);
let _e5602 = select(0f, _e5600, (_e5600 > 0f));
let _e5605 = local_5;
let _e5607 = select(_e5511, 263180i, (263180i < _e5511));
let _e5612 = global_3.member[bitcast<u32>(select(0i, _e5607, (_e5607 > 0i)))];
let _e5613 = bitcast<f32>(_e5612);
let _e5615 = select(_e5511, 263181i, (263181i < _e5511));
let _e5620 = global_3.member[bitcast<u32>(select(0i, _e5615, (_e5615 > 0i)))];
let _e5621 = bitcast<f32>(_e5620);
let _e5623 = select(_e5511, 263182i, (263182i < _e5511));
let _e5628 = global_3.member[bitcast<u32>(select(0i, _e5623, (_e5623 > 0i)))];
let _e5629 = bitcast<f32>(_e5628);
let _e5631 = ((_e5605 - _e5613) * _e5621);
let _e5633 = select(0f, _e5631, (_e5631 > 0f));
let _e5638 = local_5;
let _e5640 = select(_e5511, 263183i, (263183i < _e5511));
let _e5645 = global_3.member[bitcast<u32>(select(0i, _e5640, (_e5640 > 0i)))];
let _e5646 = bitcast<f32>(_e5645);
let _e5648 = select(_e5511, 263184i, (263184i < _e5511));
let _e5653 = global_3.member[bitcast<u32>(select(0i, _e5648, (_e5648 > 0i)))];
let _e5654 = bitcast<f32>(_e5653);
let _e5656 = select(_e5511, 263185i, (263185i < _e5511));
let _e5661 = global_3.member[bitcast<u32>(select(0i, _e5656, (_e5656 > 0i)))];
let _e5662 = bitcast<f32>(_e5661);
let _e5664 = ((_e5638 - _e5646) * _e5654);
let _e5666 = select(0f, _e5664, (_e5664 > 0f));
let _e5669 = local_5;
let _e5671 = select(_e5511, 263186i, (263186i < _e5511));
let _e5676 = global_3.member[bitcast<u32>(select(0i, _e5671, (_e5671 > 0i)))];
let _e5677 = bitcast<f32>(_e5676);
let _e5679 = select(_e5511, 263187i, (263187i < _e5511));
let _e5684 = global_3.member[bitcast<u32>(select(0i, _e5679, (_e5679 > 0i)))];
let _e5685 = bitcast<f32>(_e5684);
let _e5687 = select(_e5511, 263188i, (263188i < _e5511));
let _e5692 = global_3.member[bitcast<u32>(select(0i, _e5687, (_e5687 > 0i)))];
let _e5693 = bitcast<f32>(_e5692);
let _e5695 = ((_e5669 - _e5677) * _e5685);
let _e5697 = select(0f, _e5695, (_e5695 > 0f));
let _e5701 = local_5;
let _e5703 = select(_e5511, 263189i, (263189i < _e5511));
let _e5708 = global_3.member[bitcast<u32>(select(0i, _e5703, (_e5703 > 0i)))];
let _e5709 = bitcast<f32>(_e5708);
let _e5711 = select(_e5511, 263190i, (263190i < _e5511));
let _e5716 = global_3.member[bitcast<u32>(select(0i, _e5711, (_e5711 > 0i)))];
let _e5717 = bitcast<f32>(_e5716);
let _e5719 = select(_e5511, 263191i, (263191i < _e5511));
let _e5724 = global_3.member[bitcast<u32>(select(0i, _e5719, (_e5719 > 0i)))];
let _e5725 = bitcast<f32>(_e5724);
let _e5727 = ((_e5701 - _e5709) * _e5717);
let _e5729 = select(0f, _e5727, (_e5727 > 0f));
let _e5732 = local_5;
let _e5734 = select(_e5511, 263192i, (263192i < _e5511));
let _e5739 = global_3.member[bitcast<u32>(select(0i, _e5734, (_e5734 > 0i)))];
let _e5740 = bitcast<f32>(_e5739);
let _e5742 = select(_e5511, 263193i, (263193i < _e5511));
let _e5747 = global_3.member[bitcast<u32>(select(0i, _e5742, (_e5742 > 0i)))];
let _e5748 = bitcast<f32>(_e5747);
let _e5750 = select(_e5511, 263194i, (263194i < _e5511));
let _e5755 = global_3.member[bitcast<u32>(select(0i, _e5750, (_e5750 > 0i)))];
let _e5756 = bitcast<f32>(_e5755);
let _e5758 = ((_e5732 - _e5740) * _e5748);
let _e5760 = select(0f, _e5758, (_e5758 > 0f));
let _e5765 = (((select(_e5535, _e5539, (_e5539 < _e5535)) + select(_e5566, _e5570, (_e5570 < _e5566))) + (select(_e5598, _e5602, (_e5602 < _e5598)) + select(_e5629, _e5633, (_e5633 < _e5629)))) + ((select(_e5662, _e5666, (_e5666 < _e5662)) + select(_e5693, _e5697, (_e5697 < _e5693))) + (select(_e5725, _e5729, (_e5729 < _e5725)) + select(_e5756, _e5760, (_e5760 < _e5756)))));
local_4 = _e4189.member;
let _e5766 = local_4;
let _e5768 = ((_e5766 - _e5519) * _e5527);
let _e5770 = select(0f, _e5768, (_e5768 > 0f));
let _e5773 = local_4;
let _e5775 = ((_e5773 - _e5550) * _e5558);
let _e5777 = select(0f, _e5775, (_e5775 > 0f));
let _e5781 = local_4;
let _e5783 = ((_e5781 - _e5582) * _e5590);
let _e5785 = select(0f, _e5783, (_e5783 > 0f));
let _e5788 = local_4;
let _e5790 = ((_e5788 - _e5613) * _e5621);
let _e5792 = select(0f, _e5790, (_e5790 > 0f));
let _e5797 = local_4;
let _e5799 = ((_e5797 - _e5646) * _e5654);
let _e5801 = select(0f, _e5799, (_e5799 > 0f));
let _e5804 = local_4;
let _e5806 = ((_e5804 - _e5677) * _e5685);
let _e5808 = select(0f, _e5806, (_e5806 > 0f));
let _e5812 = local_4;
let _e5814 = ((_e5812 - _e5709) * _e5717);
let _e5816 = select(0f, _e5814, (_e5814 > 0f));
let _e5819 = local_4;
let _e5821 = ((_e5819 - _e5740) * _e5748);
let _e5823 = select(0f, _e5821, (_e5821 > 0f));
let _e5828 = (((select(_e5535, _e5770, (_e5770 < _e5535)) + select(_e5566, _e5777, (_e5777 < _e5566))) + (select(_e5598, _e5785, (_e5785 < _e5598)) + select(_e5629, _e5792, (_e5792 < _e5629)))) + ((select(_e5662, _e5801, (_e5801 < _e5662)) + select(_e5693, _e5808, (_e5808 < _e5693))) + (select(_e5725, _e5816, (_e5816 < _e5725)) + select(_e5756, _e5823, (_e5823 < _e5756)))));
let _e5829 = (255f - 1f);
let _e5831 = select(0f, _e5765, (_e5765 > 0f));
let _e5833 = select(_e5829, _e5831, (_e5831 < _e5829));
let _e5840 = select(0i, select(select(i32(_e5833), i32(-2147483648), (_e5833 < -2147483600f)), 2147483647i, (_e5833 > 2147483500f)), (_e5833 == _e5833));
let _e5844 = (_e5840 - select(0i, 1i, (_e5833 < f32(_e5840))));
let _e5846 = select(0f, _e5828, (_e5828 > 0f));
let _e5848 = select(_e5829, _e5846, (_e5846 < _e5829));
let _e5855 = select(0i, select(select(i32(_e5848), i32(-2147483648), (_e5848 < -2147483600f)), 2147483647i, (_e5848 > 2147483500f)), (_e5848 == _e5848));
let _e5859 = (_e5855 - select(0i, 1i, (_e5848 < f32(_e5855))));
let _e5861 = select(_e5511, 263195i, (263195i < _e5511));
let _e5867 = global_3.member[bitcast<u32>(select(0i, _e5861, (_e5861 > 0i)))];
let _e5868 = bitcast<f32>(_e5867);
let _e5870 = select(_e5511, 263196i, (263196i < _e5511));
let _e5876 = global_3.member[bitcast<u32>(select(0i, _e5870, (_e5870 > 0i)))];
let _e5877 = bitcast<f32>(_e5876);
let _e5878 = (_e4189.member - _e4575);
let _e5884 = (1f / select(_e5878, 1f, (bitcast<f32>((bitcast<u32>(_e5878) & 2147483647u)) < 1e-20f)));
let _e5890 = ((select(_e5868, _e4189.member, (_e4189.member < _e5868)) - select(_e5868, _e4575, (_e4575 < _e5868))) * _e5884);
let _e5896 = ((select(_e5877, _e4189.member, (_e4189.member > _e5877)) - select(_e5877, _e4575, (_e4575 > _e5877))) * _e5884);
let _e5899 = (((_e5844 * 256i) + _e5859) * 4i);
let _e5901 = (_e5765 - f32(_e5844));
let _e5903 = (_e5828 - f32(_e5859));
let _e5905 = (1f - (_e5890 + _e5896));
let _e5907 = select(_e5511, _e5899, (_e5899 < _e5511));
let _e5913 = global_3.member[bitcast<u32>(select(0i, _e5907, (_e5907 > 0i)))];
let _e5918 = (bitcast<f32>(((_e5913 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5925 = (bitcast<f32>((((_e5913 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5926 = (_e5899 + 4i);
let _e5928 = select(_e5511, _e5926, (_e5926 < _e5511));
let _e5934 = global_3.member[bitcast<u32>(select(0i, _e5928, (_e5928 > 0i)))];
let _e5947 = (_e5899 + 1024i);
let _e5949 = select(_e5511, _e5947, (_e5947 < _e5511));
let _e5955 = global_3.member[bitcast<u32>(select(0i, _e5949, (_e5949 > 0i)))];
let _e5960 = (bitcast<f32>(((_e5955 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5967 = (bitcast<f32>((((_e5955 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5968 = (_e5899 + 1028i);
let _e5970 = select(_e5511, _e5968, (_e5968 < _e5511));
let _e5976 = global_3.member[bitcast<u32>(select(0i, _e5970, (_e5970 > 0i)))];
let _e5991 = (_e5918 + (((bitcast<f32>(((_e5934 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5918) * _e5903));
let _e6000 = (_e5925 + (((bitcast<f32>((((_e5934 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5925) * _e5903));
let _e6008 = select(_e5511, 0i, (0i < _e5511));
let _e6014 = global_3.member[bitcast<u32>(select(0i, _e6008, (_e6008 > 0i)))];
let _e6028 = select(_e5511, 262140i, (262140i < _e5511));
let _e6034 = global_3.member[bitcast<u32>(select(0i, _e6028, (_e6028 > 0i)))];
let _e6057 = (_e5899 + 1i);
let _e6059 = select(_e5511, _e6057, (_e6057 < _e5511));
let _e6065 = global_3.member[bitcast<u32>(select(0i, _e6059, (_e6059 > 0i)))];
let _e6070 = (bitcast<f32>(((_e6065 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e6077 = (bitcast<f32>((((_e6065 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e6078 = (_e5899 + 5i);
let _e6080 = select(_e5511, _e6078, (_e6078 < _e5511));
let _e6086 = global_3.member[bitcast<u32>(select(0i, _e6080, (_e6080 > 0i)))];
let _e6099 = (_e5899 + 1025i);
let _e6101 = select(_e5511, _e6099, (_e6099 < _e5511));
let _e6107 = global_3.member[bitcast<u32>(select(0i, _e6101, (_e6101 > 0i)))];
let _e6112 = (bitcast<f32>(((_e6107 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e6119 = (bitcast<f32>((((_e6107 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e6120 = (_e5899 + 1029i);
let _e6122 = select(_e5511, _e6120, (_e6120 < _e5511));
let _e6128 = global_3.member[bitcast<u32>(select(0i, _e6122, (_e6122 > 0i)))];
let _e6143 = (_e6070 + (((bitcast<f32>(((_e6086 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e6070) * _e5903));
let _e6152 = (_e6077 + (((bitcast<f32>((((_e6086 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e6077) * _e5903));
let _e6160 = select(_e5511, 1i, (1i < _e5511));
let _e6166 = global_3.member[bitcast<u32>(select(0i, _e6160, (_e6160 > 0i)))];
let _e6180 = select(_e5511, 262141i, (262141i < _e5511));
let _e6186 = global_3.member[bitcast<u32>(select(0i, _e6180, (_e6180 > 0i)))];
let _e6208 = (((_e6152 + (((_e6119 + (((bitcast<f32>((((_e6128 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e6119) * _e5903)) - _e6152) * _e5901)) * _e5905) + (((bitcast<f32>((((_e6166 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5890) + ((bitcast<f32>((((_e6186 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5896)));
let _e6213 = (_e4821.member.member_1 - _e4821.member.member);
let _e6221 = (_e4821.member_1.member_1 - _e4821.member_1.member);
let _e6224 = (_e4936 * select(0f, _e6221, (_e6221 > 0f)));
let _e6226 = -(((((_e6143 + (((_e6112 + (((bitcast<f32>(((_e6128 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e6112) * _e5903)) - _e6143) * _e5901)) * _e5905) + (((bitcast<f32>(((_e6166 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5890) + ((bitcast<f32>(((_e6186 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5896))) * _e6224));
let _e6228 = select(-87f, _e6226, (_e6226 > -87f));
let _e6230 = select(88f, _e6228, (_e6228 < 88f));
let _e6232 = ((_e6230 * 1.442695f) + 0.5f);
let _e6234 = select(-127f, _e6232, (_e6232 > -127f));
let _e6236 = select(128f, _e6234, (_e6234 < 128f));
let _e6243 = select(0i, select(select(i32(_e6236), i32(-2147483648), (_e6236 < -2147483600f)), 2147483647i, (_e6236 > 2147483500f)), (_e6236 == _e6236));
let _e6247 = (_e6243 - select(0i, 1i, (_e6236 < f32(_e6243))));
let _e6248 = f32(_e6247);
let _e6252 = ((_e6230 - (_e6248 * 0.6933594f)) - (_e6248 * -2.1219444e-4f));
let _e6274 = -(((((_e5991 + (((_e5960 + (((bitcast<f32>(((_e5976 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5960) * _e5903)) - _e5991) * _e5901)) * _e5905) + (((bitcast<f32>(((_e6014 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5890) + ((bitcast<f32>(((_e6034 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5896))) * _e6224));
let _e6276 = select(-87f, _e6274, (_e6274 > -87f));
let _e6278 = select(88f, _e6276, (_e6276 < 88f));
let _e6280 = ((_e6278 * 1.442695f) + 0.5f);
let _e6282 = select(-127f, _e6280, (_e6280 > -127f));
let _e6284 = select(128f, _e6282, (_e6282 < 128f));
let _e6291 = select(0i, select(select(i32(_e6284), i32(-2147483648), (_e6284 < -2147483600f)), 2147483647i, (_e6284 > 2147483500f)), (_e6284 == _e6284));
let _e6295 = (_e6291 - select(0i, 1i, (_e6284 < f32(_e6291))));
let _e6296 = f32(_e6295);
let _e6300 = ((_e6278 - (_e6296 * 0.6933594f)) - (_e6296 * -2.1219444e-4f));
let _e6322 = -(((((_e6000 + (((_e5967 + (((bitcast<f32>((((_e5976 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5967) * _e5903)) - _e6000) * _e5901)) * _e5905) + (((bitcast<f32>((((_e6014 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5890) + ((bitcast<f32>((((_e6034 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5896))) * _e6224));
let _e6324 = select(-87f, _e6322, (_e6322 > -87f));
let _e6326 = select(88f, _e6324, (_e6324 < 88f));
let _e6328 = ((_e6326 * 1.442695f) + 0.5f);
let _e6330 = select(-127f, _e6328, (_e6328 > -127f));
let _e6332 = select(128f, _e6330, (_e6330 < 128f));
let _e6339 = select(0i, select(select(i32(_e6332), i32(-2147483648), (_e6332 < -2147483600f)), 2147483647i, (_e6332 > 2147483500f)), (_e6332 == _e6332));
let _e6343 = (_e6339 - select(0i, 1i, (_e6332 < f32(_e6339))));
let _e6344 = f32(_e6343);
let _e6348 = ((_e6326 - (_e6344 * 0.6933594f)) - (_e6344 * -2.1219444e-4f));
let _e6371 = -((_e6208 * (_e4936 * select(0f, _e6213, (_e6213 > 0f)))));
let _e6373 = select(-87f, _e6371, (_e6371 > -87f));
let _e6375 = select(88f, _e6373, (_e6373 < 88f));
let _e6377 = ((_e6375 * 1.442695f) + 0.5f);
let _e6379 = select(-127f, _e6377, (_e6377 > -127f));
let _e6381 = select(128f, _e6379, (_e6379 < 128f));
let _e6388 = select(0i, select(select(i32(_e6381), i32(-2147483648), (_e6381 < -2147483600f)), 2147483647i, (_e6381 > 2147483500f)), (_e6381 == _e6381));
let _e6392 = (_e6388 - select(0i, 1i, (_e6381 < f32(_e6388))));
let _e6393 = f32(_e6392);
let _e6397 = ((_e6375 - (_e6393 * 0.6933594f)) - (_e6393 * -2.1219444e-4f));
let _e6417 = ((1f + (_e6397 * (1f + (_e6397 * (0.5f + (_e6397 * (0.16666667f + (_e6397 * (0.041666668f + (_e6397 * (0.008333334f + (_e6397 * (0.001388889f + (_e6397 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6392 + 127i)) << bitcast<u32>(23i))));
let _e6418 = (1f - _e6417);
phi_14206_ = type_38(_e6417, _e6418, vec3<f32>(((1f + (_e6252 * (1f + (_e6252 * (0.5f + (_e6252 * (0.16666667f + (_e6252 * (0.041666668f + (_e6252 * (0.008333334f + (_e6252 * (0.001388889f + (_e6252 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6247 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e6300 * (1f + (_e6300 * (0.5f + (_e6300 * (0.16666667f + (_e6300 * (0.041666668f + (_e6300 * (0.008333334f + (_e6300 * (0.001388889f + (_e6300 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6295 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e6348 * (1f + (_e6348 * (0.5f + (_e6348 * (0.16666667f + (_e6348 * (0.041666668f + (_e6348 * (0.008333334f + (_e6348 * (0.001388889f + (_e6348 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6343 + 127i)) << bitcast<u32>(23i))))), vec3((0f * (_e6418 / select(1e-12f, _e6208, (_e6208 > 1e-12f))))));
}
let _e6426 = phi_14206_;
if (false || ((_e4578 & 1024u) != 0u)) {
let _e6437 = (_e4189.member - _e4575);
let _e6440 = select(_e4189.member, (_e4575 + (_e6437 * _e4821.member.member)), (_e4821.member.member < 1f));
let _e6446 = select(_e6440, select(_e4189.member, (_e4575 + (_e6437 * _e4821.member.member_1)), (_e4821.member.member_1 < 1f)), (_e4821.member.member_1 > _e4821.member.member));
let _e6448 = (bitcast<i32>(_e179) - 1i);
let _e6450 = select(_e6448, 263211i, (263211i < _e6448));
let _e6456 = global_3.member[bitcast<u32>(select(0i, _e6450, (_e6450 > 0i)))];
let _e6457 = bitcast<f32>(_e6456);
let _e6461 = select(_e6448, 263212i, (263212i < _e6448));
let _e6467 = global_3.member[bitcast<u32>(select(0i, _e6461, (_e6461 > 0i)))];
let _e6468 = bitcast<f32>(_e6467);
let _e6473 = select(_e6448, 263213i, (263213i < _e6448));
let _e6479 = global_3.member[bitcast<u32>(select(0i, _e6473, (_e6473 > 0i)))];
let _e6480 = bitcast<f32>(_e6479);
let _e6484 = select(_e6448, 263214i, (263214i < _e6448));
let _e6490 = global_3.member[bitcast<u32>(select(0i, _e6484, (_e6484 > 0i)))];
let _e6491 = bitcast<f32>(_e6490);
let _e6497 = select(_e6448, 263215i, (263215i < _e6448));
let _e6503 = global_3.member[bitcast<u32>(select(0i, _e6497, (_e6497 > 0i)))];
let _e6504 = bitcast<f32>(_e6503);
let _e6508 = select(_e6448, 263216i, (263216i < _e6448));
let _e6514 = global_3.member[bitcast<u32>(select(0i, _e6508, (_e6508 > 0i)))];
let _e6515 = bitcast<f32>(_e6514);
let _e6520 = select(_e6448, 263217i, (263217i < _e6448));
let _e6526 = global_3.member[bitcast<u32>(select(0i, _e6520, (_e6520 > 0i)))];
let _e6527 = bitcast<f32>(_e6526);
let _e6531 = select(_e6448, 263218i, (263218i < _e6448));
let _e6537 = global_3.member[bitcast<u32>(select(0i, _e6531, (_e6531 > 0i)))];
let _e6538 = bitcast<f32>(_e6537);
let _e6570 = (263219i + ((((((select(0i, 1i, (_e6440 >= _e6457)) + select(0i, 1i, (_e6440 >= _e6468))) + (select(0i, 1i, (_e6440 >= _e6480)) + select(0i, 1i, (_e6440 >= _e6491)))) + ((select(0i, 1i, (_e6440 >= _e6504)) + select(0i, 1i, (_e6440 >= _e6515))) + (select(0i, 1i, (_e6440 >= _e6527)) + select(0i, 1i, (_e6440 >= _e6538))))) * 9i) + (((select(0i, 1i, (_e6446 >= _e6457)) + select(0i, 1i, (_e6446 >= _e6468))) + (select(0i, 1i, (_e6446 >= _e6480)) + select(0i, 1i, (_e6446 >= _e6491)))) + ((select(0i, 1i, (_e6446 >= _e6504)) + select(0i, 1i, (_e6446 >= _e6515))) + (select(0i, 1i, (_e6446 >= _e6527)) + select(0i, 1i, (_e6446 >= _e6538)))))) * 6i));
let _e6572 = select(_e6448, _e6570, (_e6570 < _e6448));
let _e6578 = global_3.member[bitcast<u32>(select(0i, _e6572, (_e6572 > 0i)))];
phi_14604_ = (_e6426.member * select(1f, bitcast<f32>(_e6578), (_e4919 > 0f)));
} else {
phi_14604_ = _e6426.member;
}
let _e6583 = phi_14604_;
if _e1281 {
let _e6588 = global_1.member.member_8.member.member;
let _e6596 = global_1.member.member_8.member_1.member;
let _e6604 = global_1.member.member_8.member_2.member;
let _e6608 = (_e4194 - _e1260);
let _e6609 = -(_e4829);
let _e6612 = (_e4829 - _e6608);
let _e6613 = (_e6608 - _e4829);
let _e6615 = select(_e6613, _e6612, (_e6612 > _e6613));
let _e6618 = (select(_e6609, _e4829, (_e4829 > _e6609)) / select(1e-30f, _e6615, (_e6615 > 1e-30f)));
let _e6620 = (_e6608 < 0f);
let _e6622 = select(0f, select(2f, _e6618, _e6620), (_e4829 > 0f));
let _e6623 = (_e6608 > 0f);
let _e6626 = select(2f, select(0f, _e6618, (_e4829 < 0f)), _e6623);
let _e6627 = (_e4829 > -1e30f);
let _e6631 = ((_e6622 > -1f) || ((_e6622 == -1f) && _e6627));
let _e6632 = (_e6626 < 2f);
let _e6633 = select(-1f, _e6622, _e6631);
let _e6637 = select(2f, _e6626, _e6632);
let _e6641 = select(-1e30f, _e4829, _e6627);
let _e6642 = (_e6608 > -1e30f);
let _e6643 = select(-1e30f, _e6608, _e6642);
let _e6647 = (_e1224 - _e4199);
let _e6648 = (_e1260 - _e4199);
let _e6649 = -(_e6647);
let _e6652 = (_e6647 - _e6648);
let _e6653 = (_e6648 - _e6647);
let _e6655 = select(_e6653, _e6652, (_e6652 > _e6653));
let _e6658 = (select(_e6649, _e6647, (_e6647 > _e6649)) / select(1e-30f, _e6655, (_e6655 > 1e-30f)));
let _e6660 = (_e6648 < 0f);
let _e6662 = select(0f, select(2f, _e6658, _e6660), (_e6647 > 0f));
let _e6663 = (_e6648 > 0f);
let _e6666 = select(2f, select(0f, _e6658, (_e6647 < 0f)), _e6663);
let _e6667 = (_e6647 > _e6641);
let _e6671 = ((_e6662 > _e6633) || ((_e6662 == _e6633) && _e6667));
let _e6672 = (_e6666 < _e6637);
let _e6673 = select(_e6633, _e6662, _e6671);
let _e6677 = select(_e6637, _e6666, _e6672);
let _e6681 = select(_e6641, _e6647, _e6667);
let _e6682 = (_e6648 > _e6643);
let _e6683 = select(_e6643, _e6648, _e6682);
let _e6687 = (_e4208 - _e1266);
let _e6688 = -(_e4858);
let _e6691 = (_e4858 - _e6687);
let _e6692 = (_e6687 - _e4858);
let _e6694 = select(_e6692, _e6691, (_e6691 > _e6692));
let _e6697 = (select(_e6688, _e4858, (_e4858 > _e6688)) / select(1e-30f, _e6694, (_e6694 > 1e-30f)));
let _e6699 = (_e6687 < 0f);
let _e6701 = select(0f, select(2f, _e6697, _e6699), (_e4858 > 0f));
let _e6702 = (_e6687 > 0f);
let _e6705 = select(2f, select(0f, _e6697, (_e4858 < 0f)), _e6702);
let _e6706 = (_e4858 > _e6681);
let _e6710 = ((_e6701 > _e6673) || ((_e6701 == _e6673) && _e6706));
let _e6711 = (_e6705 < _e6677);
let _e6712 = select(_e6673, _e6701, _e6710);
let _e6716 = select(_e6677, _e6705, _e6711);
let _e6720 = select(_e6681, _e4858, _e6706);
let _e6721 = (_e6687 > _e6683);
let _e6722 = select(_e6683, _e6687, _e6721);
let _e6726 = (_e1239 - _e4213);
let _e6727 = (_e1266 - _e4213);
let _e6728 = -(_e6726);
let _e6731 = (_e6726 - _e6727);
let _e6732 = (_e6727 - _e6726);
let _e6734 = select(_e6732, _e6731, (_e6731 > _e6732));
let _e6737 = (select(_e6728, _e6726, (_e6726 > _e6728)) / select(1e-30f, _e6734, (_e6734 > 1e-30f)));
let _e6739 = (_e6727 < 0f);
let _e6741 = select(0f, select(2f, _e6737, _e6739), (_e6726 > 0f));
let _e6742 = (_e6727 > 0f);
let _e6745 = select(2f, select(0f, _e6737, (_e6726 < 0f)), _e6742);
let _e6746 = (_e6726 > _e6720);
let _e6750 = ((_e6741 > _e6712) || ((_e6741 == _e6712) && _e6746));
let _e6751 = (_e6745 < _e6716);
let _e6752 = select(_e6712, _e6741, _e6750);
let _e6756 = select(_e6716, _e6745, _e6751);
let _e6760 = select(_e6720, _e6726, _e6746);
let _e6761 = (_e6727 > _e6722);
let _e6762 = select(_e6722, _e6727, _e6761);
let _e6766 = (_e4222 - _e1272);
let _e6767 = -(_e4887);
let _e6770 = (_e4887 - _e6766);
let _e6771 = (_e6766 - _e4887);
let _e6773 = select(_e6771, _e6770, (_e6770 > _e6771));
let _e6776 = (select(_e6767, _e4887, (_e4887 > _e6767)) / select(1e-30f, _e6773, (_e6773 > 1e-30f)));
let _e6778 = (_e6766 < 0f);
let _e6780 = select(0f, select(2f, _e6776, _e6778), (_e4887 > 0f));
let _e6781 = (_e6766 > 0f);
let _e6784 = select(2f, select(0f, _e6776, (_e4887 < 0f)), _e6781);
let _e6785 = (_e4887 > _e6760);
let _e6789 = ((_e6780 > _e6752) || ((_e6780 == _e6752) && _e6785));
let _e6790 = (_e6784 < _e6756);
let _e6791 = select(_e6752, _e6780, _e6789);
let _e6795 = select(_e6756, _e6784, _e6790);
let _e6799 = select(_e6760, _e4887, _e6785);
let _e6800 = (_e6766 > _e6762);
let _e6801 = select(_e6762, _e6766, _e6800);
let _e6805 = (_e1254 - _e4227);
let _e6806 = (_e1272 - _e4227);
let _e6807 = -(_e6805);
let _e6810 = (_e6805 - _e6806);
let _e6811 = (_e6806 - _e6805);
let _e6813 = select(_e6811, _e6810, (_e6810 > _e6811));
let _e6816 = (select(_e6807, _e6805, (_e6805 > _e6807)) / select(1e-30f, _e6813, (_e6813 > 1e-30f)));
let _e6818 = (_e6806 < 0f);
let _e6820 = select(0f, select(2f, _e6816, _e6818), (_e6805 > 0f));
let _e6821 = (_e6806 > 0f);
let _e6824 = select(2f, select(0f, _e6816, (_e6805 < 0f)), _e6821);
let _e6825 = (_e6805 > _e6799);
let _e6829 = ((_e6820 > _e6791) || ((_e6820 == _e6791) && _e6825));
let _e6830 = (_e6824 < _e6795);
let _e6831 = select(_e6791, _e6820, _e6829);
let _e6832 = select(select(select(select(select(select(0f, _e6588.member, _e6631), _e6588.member, _e6671), _e6596.member, _e6710), _e6596.member, _e6750), _e6604.member, _e6789), _e6604.member, _e6829);
let _e6833 = select(select(select(select(select(select(0f, _e6588.member_1, _e6631), _e6588.member_1, _e6671), _e6596.member_1, _e6710), _e6596.member_1, _e6750), _e6604.member_1, _e6789), _e6604.member_1, _e6829);
let _e6834 = select(select(select(select(select(select(1f, _e6588.member_2, _e6631), _e6588.member_2, _e6671), _e6596.member_2, _e6710), _e6596.member_2, _e6750), _e6604.member_2, _e6789), _e6604.member_2, _e6829);
let _e6836 = select(_e6795, _e6824, _e6830);
let _e6837 = select(select(select(select(select(select(0f, _e6588.member, _e6632), _e6588.member, _e6672), _e6596.member, _e6711), _e6596.member, _e6751), _e6604.member, _e6790), _e6604.member, _e6830);
let _e6838 = select(select(select(select(select(select(0f, _e6588.member_1, _e6632), _e6588.member_1, _e6672), _e6596.member_1, _e6711), _e6596.member_1, _e6751), _e6604.member_1, _e6790), _e6604.member_1, _e6830);
let _e6839 = select(select(select(select(select(select(1f, _e6588.member_2, _e6632), _e6588.member_2, _e6672), _e6596.member_2, _e6711), _e6596.member_2, _e6751), _e6604.member_2, _e6790), _e6604.member_2, _e6830);
let _e6841 = select(_e6799, _e6805, _e6825);
let _e6842 = (_e6806 > _e6801);
let _e6843 = select(_e6801, _e6806, _e6842);
let _e6844 = select(select(select(select(select(select(0f, _e6588.member, _e6627), _e6588.member, _e6667), _e6596.member, _e6706), _e6596.member, _e6746), _e6604.member, _e6785), _e6604.member, _e6825);
let _e6845 = select(select(select(select(select(select(0f, _e6588.member_1, _e6627), _e6588.member_1, _e6667), _e6596.member_1, _e6706), _e6596.member_1, _e6746), _e6604.member_1, _e6785), _e6604.member_1, _e6825);
let _e6846 = select(select(select(select(select(select(1f, _e6588.member_2, _e6627), _e6588.member_2, _e6667), _e6596.member_2, _e6706), _e6596.member_2, _e6746), _e6604.member_2, _e6785), _e6604.member_2, _e6825);
if _e4580 {
phi_15929_ = type_37(_e6831, vec3<f32>(_e6832, _e6833, _e6834), _e6836, vec3<f32>(_e6837, _e6838, _e6839), _e6841, _e6843, vec3<f32>(_e6844, _e6845, _e6846));
} else {
let _e6853 = (((_e6588.member * _e6588.member) + (_e6588.member_1 * _e6588.member_1)) + (_e6588.member_2 * _e6588.member_2));
let _e6856 = sqrt(select(0f, _e6853, (_e6853 > 0f)));
let _e6860 = global_1.member.member_16.member_1;
let _e6861 = (_e6860 != 0u);
let _e6865 = global_1.member.member_16.member;
let _e6885 = select(-1e6f, (((((_e6865.member.member * _e1181) + (_e6865.member.member_1 * _e1194)) + (_e6865.member.member_2 * _e1159)) + _e6865.member_1) * _e6856), _e6861);
let _e6886 = select(-1e6f, (((((_e6865.member.member * _e1204) + (_e6865.member.member_1 * _e1209)) + (_e6865.member.member_2 * _e1198)) + _e6865.member_1) * _e6856), _e6861);
let _e6891 = global_1.member.member_16.member.member;
let _e6895 = -(_e6885);
let _e6898 = (_e6885 - _e6886);
let _e6899 = (_e6886 - _e6885);
let _e6901 = select(_e6899, _e6898, (_e6898 > _e6899));
let _e6904 = (select(_e6895, _e6885, (_e6885 > _e6895)) / select(1e-30f, _e6901, (_e6901 > 1e-30f)));
let _e6908 = select(0f, select(2f, _e6904, (_e6886 < 0f)), (_e6885 > 0f));
let _e6912 = select(2f, select(0f, _e6904, (_e6885 < 0f)), (_e6886 > 0f));
let _e6913 = (_e6885 > _e6841);
let _e6917 = ((_e6908 > _e6831) || ((_e6908 == _e6831) && _e6913));
let _e6918 = (_e6912 < _e6836);
let _e6919 = select(_e6831, _e6908, _e6917);
let _e6923 = select(_e6836, _e6912, _e6918);
let _e6927 = select(_e6841, _e6885, _e6913);
let _e6929 = select(_e6843, _e6886, (_e6886 > _e6843));
let _e6936 = global_1.member.member_17.member_1;
let _e6937 = (_e6936 != 0u);
let _e6941 = global_1.member.member_17.member;
let _e6961 = select(-1e6f, (((((_e6941.member.member * _e1181) + (_e6941.member.member_1 * _e1194)) + (_e6941.member.member_2 * _e1159)) + _e6941.member_1) * _e6856), _e6937);
let _e6962 = select(-1e6f, (((((_e6941.member.member * _e1204) + (_e6941.member.member_1 * _e1209)) + (_e6941.member.member_2 * _e1198)) + _e6941.member_1) * _e6856), _e6937);
let _e6967 = global_1.member.member_17.member.member;
let _e6971 = -(_e6961);
let _e6974 = (_e6961 - _e6962);
let _e6975 = (_e6962 - _e6961);
let _e6977 = select(_e6975, _e6974, (_e6974 > _e6975));
let _e6980 = (select(_e6971, _e6961, (_e6961 > _e6971)) / select(1e-30f, _e6977, (_e6977 > 1e-30f)));
let _e6984 = select(0f, select(2f, _e6980, (_e6962 < 0f)), (_e6961 > 0f));
let _e6988 = select(2f, select(0f, _e6980, (_e6961 < 0f)), (_e6962 > 0f));
let _e6989 = (_e6961 > _e6927);
let _e6993 = ((_e6984 > _e6919) || ((_e6984 == _e6919) && _e6989));
let _e6994 = (_e6988 < _e6923);
let _e6995 = select(_e6919, _e6984, _e6993);
let _e6999 = select(_e6923, _e6988, _e6994);
let _e7003 = select(_e6927, _e6961, _e6989);
let _e7005 = select(_e6929, _e6962, (_e6962 > _e6929));
let _e7012 = global_1.member.member_18.member_1;
let _e7013 = (_e7012 != 0u);
let _e7017 = global_1.member.member_18.member;
let _e7037 = select(-1e6f, (((((_e7017.member.member * _e1181) + (_e7017.member.member_1 * _e1194)) + (_e7017.member.member_2 * _e1159)) + _e7017.member_1) * _e6856), _e7013);
let _e7038 = select(-1e6f, (((((_e7017.member.member * _e1204) + (_e7017.member.member_1 * _e1209)) + (_e7017.member.member_2 * _e1198)) + _e7017.member_1) * _e6856), _e7013);
let _e7043 = global_1.member.member_18.member.member;
let _e7047 = -(_e7037);
let _e7050 = (_e7037 - _e7038);
let _e7051 = (_e7038 - _e7037);
let _e7053 = select(_e7051, _e7050, (_e7050 > _e7051));
let _e7056 = (select(_e7047, _e7037, (_e7037 > _e7047)) / select(1e-30f, _e7053, (_e7053 > 1e-30f)));
let _e7060 = select(0f, select(2f, _e7056, (_e7038 < 0f)), (_e7037 > 0f));
let _e7064 = select(2f, select(0f, _e7056, (_e7037 < 0f)), (_e7038 > 0f));
let _e7065 = (_e7037 > _e7003);
let _e7069 = ((_e7060 > _e6995) || ((_e7060 == _e6995) && _e7065));
let _e7070 = (_e7064 < _e6999);
let _e7071 = select(_e6995, _e7060, _e7069);
let _e7075 = select(_e6999, _e7064, _e7070);
let _e7079 = select(_e7003, _e7037, _e7065);
let _e7081 = select(_e7005, _e7038, (_e7038 > _e7005));
let _e7088 = global_1.member.member_19.member_1;
let _e7089 = (_e7088 != 0u);
let _e7093 = global_1.member.member_19.member;
let _e7113 = select(-1e6f, (((((_e7093.member.member * _e1181) + (_e7093.member.member_1 * _e1194)) + (_e7093.member.member_2 * _e1159)) + _e7093.member_1) * _e6856), _e7089);
let _e7114 = select(-1e6f, (((((_e7093.member.member * _e1204) + (_e7093.member.member_1 * _e1209)) + (_e7093.member.member_2 * _e1198)) + _e7093.member_1) * _e6856), _e7089);
let _e7119 = global_1.member.member_19.member.member;
let _e7123 = -(_e7113);
let _e7126 = (_e7113 - _e7114);
let _e7127 = (_e7114 - _e7113);
let _e7129 = select(_e7127, _e7126, (_e7126 > _e7127));
let _e7132 = (select(_e7123, _e7113, (_e7113 > _e7123)) / select(1e-30f, _e7129, (_e7129 > 1e-30f)));
let _e7136 = select(0f, select(2f, _e7132, (_e7114 < 0f)), (_e7113 > 0f));
let _e7140 = select(2f, select(0f, _e7132, (_e7113 < 0f)), (_e7114 > 0f));
let _e7141 = (_e7113 > _e7079);
let _e7145 = ((_e7136 > _e7071) || ((_e7136 == _e7071) && _e7141));
let _e7146 = (_e7140 < _e7075);
phi_15929_ = type_37(select(_e7071, _e7136, _e7145), vec3<f32>(select(select(select(select(_e6832, _e6891.member, _e6917), _e6967.member, _e6993), _e7043.member, _e7069), _e7119.member, _e7145), select(select(select(select(_e6833, _e6891.member_1, _e6917), _e6967.member_1, _e6993), _e7043.member_1, _e7069), _e7119.member_1, _e7145), select(select(select(select(_e6834, _e6891.member_2, _e6917), _e6967.member_2, _e6993), _e7043.member_2, _e7069), _e7119.member_2, _e7145)), select(_e7075, _e7140, _e7146), vec3<f32>(select(select(select(select(_e6837, _e6891.member, _e6918), _e6967.member, _e6994), _e7043.member, _e7070), _e7119.member, _e7146), select(select(select(select(_e6838, _e6891.member_1, _e6918), _e6967.member_1, _e6994), _e7043.member_1, _e7070), _e7119.member_1, _e7146), select(select(select(select(_e6839, _e6891.member_2, _e6918), _e6967.member_2, _e6994), _e7043.member_2, _e7070), _e7119.member_2, _e7146)), select(_e7079, _e7113, _e7141), select(_e7081, _e7114, (_e7114 > _e7081)), vec3<f32>(select(select(select(select(_e6844, _e6891.member, _e6913), _e6967.member, _e6989), _e7043.member, _e7065), _e7119.member, _e7141), select(select(select(select(_e6845, _e6891.member_1, _e6913), _e6967.member_1, _e6989), _e7043.member_1, _e7065), _e7119.member_1, _e7141), select(select(select(select(_e6846, _e6891.member_2, _e6913), _e6967.member_2, _e6989), _e7043.member_2, _e7065), _e7119.member_2, _e7141)));
}
let _e7166 = phi_15929_;
let _e7168 = (_e7166.member_4 < 0f);
let _e7170 = (_e7166.member_5 < 0f);
let _e7171 = (_e7168 != _e7170);
if _e7168 {
phi_15942_ = _e7166.member_3;
phi_15943_ = _e7166.member_2;
} else {
phi_15942_ = _e7166.member_1;
phi_15943_ = _e7166.member;
}
let _e7177 = phi_15942_;
let _e7179 = phi_15943_;
let _e7188 = (((_e6588.member * _e6588.member) + (_e6588.member_1 * _e6588.member_1)) + (_e6588.member_2 * _e6588.member_2));
let _e7191 = sqrt(select(0f, _e7188, (_e7188 > 0f)));
let _e7192 = ((1.5f * _e1179) * _e7191);
let _e7197 = select(0f, _e7179, _e7171);
let _e7201 = (_e1181 + (_e4920 * _e7197));
let _e7202 = (_e1194 + (_e4921 * _e7197));
let _e7203 = (_e1159 + (_e4922 * _e7197));
let _e7209 = ((((_e1213.member.member * _e7201) + (_e1213.member.member_1 * _e7202)) + (_e1213.member.member_2 * _e7203)) + _e1213.member_1);
let _e7215 = ((((_e1228.member.member * _e7201) + (_e1228.member.member_1 * _e7202)) + (_e1228.member.member_2 * _e7203)) + _e1228.member_1);
let _e7221 = ((((_e1243.member.member * _e7201) + (_e1243.member.member_1 * _e7202)) + (_e1243.member.member_2 * _e7203)) + _e1243.member_1);
let _e7223 = select(_e4194, _e7209, (_e7209 > _e4194));
let _e7225 = select(_e4199, _e7223, (_e7223 < _e4199));
let _e7227 = select(_e4208, _e7215, (_e7215 > _e4208));
let _e7229 = select(_e4213, _e7227, (_e7227 < _e4213));
let _e7231 = select(_e4222, _e7221, (_e7221 > _e4222));
let _e7233 = select(_e4227, _e7231, (_e7231 < _e4227));
if _e4237 {
phi_16173_ = vec3<f32>(_e7225, _e7229, _e7233);
} else {
let _e7235 = (_e7225 + 0.5f);
let _e7236 = (_e4315 - 1f);
let _e7238 = select(0f, _e7235, (_e7235 > 0f));
let _e7240 = select(_e7236, _e7238, (_e7238 < _e7236));
let _e7247 = select(0i, select(select(i32(_e7240), i32(-2147483648), (_e7240 < -2147483600f)), 2147483647i, (_e7240 > 2147483500f)), (_e7240 == _e7240));
let _e7253 = (_e7229 + 0.5f);
let _e7254 = (_e4336 - 1f);
let _e7256 = select(0f, _e7253, (_e7253 > 0f));
let _e7258 = select(_e7254, _e7256, (_e7256 < _e7254));
let _e7265 = select(0i, select(select(i32(_e7258), i32(-2147483648), (_e7258 < -2147483600f)), 2147483647i, (_e7258 > 2147483500f)), (_e7258 == _e7258));
let _e7271 = (_e7233 + 0.5f);
let _e7272 = (_e4357 - 1f);
let _e7274 = select(0f, _e7271, (_e7271 > 0f));
let _e7276 = select(_e7272, _e7274, (_e7274 < _e7272));
let _e7283 = select(0i, select(select(i32(_e7276), i32(-2147483648), (_e7276 < -2147483600f)), 2147483647i, (_e7276 > 2147483500f)), (_e7276 == _e7276));
phi_16173_ = vec3<f32>(f32((_e7247 - select(0i, 1i, (_e7240 < f32(_e7247))))), f32((_e7265 - select(0i, 1i, (_e7258 < f32(_e7265))))), f32((_e7283 - select(0i, 1i, (_e7276 < f32(_e7283))))));
}
let _e7291 = phi_16173_;
let _e7294 = select(-1f, _e7291.x, (_e7291.x > -1f));
let _e7296 = select(_e4315, _e7294, (_e7294 < _e4315));
let _e7303 = select(0i, select(select(i32(_e7296), i32(-2147483648), (_e7296 < -2147483600f)), 2147483647i, (_e7296 > 2147483500f)), (_e7296 == _e7296));
let _e7307 = (_e7303 - select(0i, 1i, (_e7296 < f32(_e7303))));
let _e7310 = select(-1f, _e7291.y, (_e7291.y > -1f));
let _e7312 = select(_e4336, _e7310, (_e7310 < _e4336));
let _e7319 = select(0i, select(select(i32(_e7312), i32(-2147483648), (_e7312 < -2147483600f)), 2147483647i, (_e7312 > 2147483500f)), (_e7312 == _e7312));
let _e7323 = (_e7319 - select(0i, 1i, (_e7312 < f32(_e7319))));
let _e7326 = select(-1f, _e7291.z, (_e7291.z > -1f));
let _e7328 = select(_e4357, _e7326, (_e7326 < _e4357));
let _e7335 = select(0i, select(select(i32(_e7328), i32(-2147483648), (_e7328 < -2147483600f)), 2147483647i, (_e7328 > 2147483500f)), (_e7328 == _e7328));
let _e7339 = (_e7335 - select(0i, 1i, (_e7328 < f32(_e7335))));
let _e7340 = (_e7307 + 1i);
let _e7341 = (_e7323 + 1i);
let _e7342 = (_e7339 + 1i);
let _e7352 = ((_e7340 >> bitcast<u32>(4i)) + (_e4389 * ((_e7341 >> bitcast<u32>(4i)) + (_e4395 * (_e7342 >> bitcast<u32>(4i))))));
let _e7354 = select(_e4407, _e7352, (_e7352 < _e4407));
let _e7360 = global_2.member[bitcast<u32>(select(0i, _e7354, (_e7354 > 0i)))];
let _e7362 = (_e7340 & 15i);
let _e7365 = ((_e7341 & 15i) * _e4376);
let _e7367 = (bitcast<i32>(_e7360) + ((_e7342 & 15i) * _e4380));
let _e7371 = (_e7365 + _e4376);
let _e7372 = (_e7365 + _e4427);
let _e7373 = (_e7367 + _e4380);
let _e7374 = (_e7367 + _e4430);
local_2 = type_30(array<i32, 4>(_e7362, (_e7362 + 1i), (_e7362 + 2i), (_e7362 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_3 = (_e7291 - vec3<f32>(f32(_e7307), f32(_e7323), f32(_e7339)));
let _e7383 = (_e7373 + _e7371);
let _e7386 = local_2.member[1u];
let _e7387 = (_e7383 + _e7386);
let _e7389 = select(_e4407, _e7387, (_e7387 < _e4407));
let _e7394 = global_2.member[bitcast<u32>(select(0i, _e7389, (_e7389 > 0i)))];
let _e7395 = bitcast<f32>(_e7394);
let _e7398 = local_2.member[2u];
let _e7399 = (_e7383 + _e7398);
let _e7401 = select(_e4407, _e7399, (_e7399 < _e4407));
let _e7406 = global_2.member[bitcast<u32>(select(0i, _e7401, (_e7401 > 0i)))];
let _e7408 = local_3[0u];
let _e7411 = (_e7395 + ((bitcast<f32>(_e7406) - _e7395) * _e7408));
let _e7412 = (_e7373 + _e7372);
let _e7413 = local_2.member[1u];
let _e7414 = (_e7412 + _e7413);
let _e7416 = select(_e4407, _e7414, (_e7414 < _e4407));
let _e7421 = global_2.member[bitcast<u32>(select(0i, _e7416, (_e7416 > 0i)))];
let _e7422 = bitcast<f32>(_e7421);
let _e7423 = local_2.member[2u];
let _e7424 = (_e7412 + _e7423);
let _e7426 = select(_e4407, _e7424, (_e7424 < _e4407));
let _e7431 = global_2.member[bitcast<u32>(select(0i, _e7426, (_e7426 > 0i)))];
let _e7433 = local_3[0u];
let _e7438 = local_3[1u];
let _e7441 = (_e7411 + (((_e7422 + ((bitcast<f32>(_e7431) - _e7422) * _e7433)) - _e7411) * _e7438));
let _e7442 = (_e7374 + _e7371);
let _e7443 = local_2.member[1u];
let _e7444 = (_e7442 + _e7443);
let _e7446 = select(_e4407, _e7444, (_e7444 < _e4407));
let _e7451 = global_2.member[bitcast<u32>(select(0i, _e7446, (_e7446 > 0i)))];
let _e7452 = bitcast<f32>(_e7451);
let _e7453 = local_2.member[2u];
let _e7454 = (_e7442 + _e7453);
let _e7456 = select(_e4407, _e7454, (_e7454 < _e4407));
let _e7461 = global_2.member[bitcast<u32>(select(0i, _e7456, (_e7456 > 0i)))];
let _e7463 = local_3[0u];
let _e7466 = (_e7452 + ((bitcast<f32>(_e7461) - _e7452) * _e7463));
let _e7467 = (_e7374 + _e7372);
let _e7468 = local_2.member[1u];
let _e7469 = (_e7467 + _e7468);
let _e7471 = select(_e4407, _e7469, (_e7469 < _e4407));
let _e7476 = global_2.member[bitcast<u32>(select(0i, _e7471, (_e7471 > 0i)))];
let _e7477 = bitcast<f32>(_e7476);
let _e7478 = local_2.member[2u];
let _e7479 = (_e7467 + _e7478);
let _e7481 = select(_e4407, _e7479, (_e7479 < _e4407));
let _e7486 = global_2.member[bitcast<u32>(select(0i, _e7481, (_e7481 > 0i)))];
let _e7488 = local_3[0u];
let _e7492 = local_3[1u];
let _e7497 = local_3[2u];
let _e7502 = (((_e7441 + (((_e7466 + (((_e7477 + ((bitcast<f32>(_e7486) - _e7477) * _e7488)) - _e7466) * _e7492)) - _e7441) * _e7497)) - _e4561) * _e4565);
let _e7504 = select(_e4568, _e7502, (_e7502 > _e4568));
local = select(1e9f, _e7504, (_e7504 < 1e9f));
let _e7507 = local;
local_1 = _e7507;
let _e7508 = local_1;
let _e7510 = (bitcast<i32>(_e179) - 1i);
let _e7512 = select(_e7510, 263197i, (263197i < _e7510));
let _e7517 = global_3.member[bitcast<u32>(select(0i, _e7512, (_e7512 > 0i)))];
let _e7520 = select(_e7510, 263198i, (263198i < _e7510));
let _e7525 = global_3.member[bitcast<u32>(select(0i, _e7520, (_e7520 > 0i)))];
let _e7528 = select(_e7510, 263199i, (263199i < _e7510));
let _e7533 = global_3.member[bitcast<u32>(select(0i, _e7528, (_e7528 > 0i)))];
let _e7534 = bitcast<f32>(_e7533);
let _e7536 = ((_e7508 - bitcast<f32>(_e7517)) * bitcast<f32>(_e7525));
let _e7538 = select(0f, _e7536, (_e7536 > 0f));
let _e7541 = local_1;
let _e7543 = select(_e7510, 263200i, (263200i < _e7510));
let _e7548 = global_3.member[bitcast<u32>(select(0i, _e7543, (_e7543 > 0i)))];
let _e7551 = select(_e7510, 263201i, (263201i < _e7510));
let _e7556 = global_3.member[bitcast<u32>(select(0i, _e7551, (_e7551 > 0i)))];
let _e7559 = select(_e7510, 263202i, (263202i < _e7510));
let _e7564 = global_3.member[bitcast<u32>(select(0i, _e7559, (_e7559 > 0i)))];
let _e7565 = bitcast<f32>(_e7564);
let _e7567 = ((_e7541 - bitcast<f32>(_e7548)) * bitcast<f32>(_e7556));
let _e7569 = select(0f, _e7567, (_e7567 > 0f));
let _e7573 = local_1;
let _e7575 = select(_e7510, 263203i, (263203i < _e7510));
let _e7580 = global_3.member[bitcast<u32>(select(0i, _e7575, (_e7575 > 0i)))];
let _e7583 = select(_e7510, 263204i, (263204i < _e7510));
let _e7588 = global_3.member[bitcast<u32>(select(0i, _e7583, (_e7583 > 0i)))];
let _e7591 = select(_e7510, 263205i, (263205i < _e7510));
let _e7596 = global_3.member[bitcast<u32>(select(0i, _e7591, (_e7591 > 0i)))];
let _e7597 = bitcast<f32>(_e7596);
let _e7599 = ((_e7573 - bitcast<f32>(_e7580)) * bitcast<f32>(_e7588));
let _e7601 = select(0f, _e7599, (_e7599 > 0f));
let _e7604 = local_1;
let _e7606 = select(_e7510, 263206i, (263206i < _e7510));
let _e7611 = global_3.member[bitcast<u32>(select(0i, _e7606, (_e7606 > 0i)))];
let _e7614 = select(_e7510, 263207i, (263207i < _e7510));
let _e7619 = global_3.member[bitcast<u32>(select(0i, _e7614, (_e7614 > 0i)))];
let _e7622 = select(_e7510, 263208i, (263208i < _e7510));
let _e7627 = global_3.member[bitcast<u32>(select(0i, _e7622, (_e7622 > 0i)))];
let _e7628 = bitcast<f32>(_e7627);
let _e7630 = ((_e7604 - bitcast<f32>(_e7611)) * bitcast<f32>(_e7619));
let _e7632 = select(0f, _e7630, (_e7630 > 0f));
let _e7636 = ((select(_e7534, _e7538, (_e7538 < _e7534)) + select(_e7565, _e7569, (_e7569 < _e7565))) + (select(_e7597, _e7601, (_e7601 < _e7597)) + select(_e7628, _e7632, (_e7632 < _e7628))));
let _e7638 = select(0f, _e7636, (_e7636 > 0f));
let _e7640 = select(1023f, _e7638, (_e7638 < 1023f));
let _e7647 = select(0i, select(select(i32(_e7640), i32(-2147483648), (_e7640 < -2147483600f)), 2147483647i, (_e7640 > 2147483500f)), (_e7640 == _e7640));
let _e7651 = (_e7647 - select(0i, 1i, (_e7640 < f32(_e7647))));
let _e7652 = (262147i + _e7651);
let _e7654 = select(_e7510, _e7652, (_e7652 < _e7510));
let _e7660 = global_3.member[bitcast<u32>(select(0i, _e7654, (_e7654 > 0i)))];
let _e7670 = select(_e7510, 262146i, (262146i < _e7510));
let _e7676 = global_3.member[bitcast<u32>(select(0i, _e7670, (_e7670 > 0i)))];
let _e7680 = select(_e7510, 262144i, (262144i < _e7510));
let _e7686 = global_3.member[bitcast<u32>(select(0i, _e7680, (_e7680 > 0i)))];
let _e7689 = select(_e7510, 262145i, (262145i < _e7510));
let _e7695 = global_3.member[bitcast<u32>(select(0i, _e7689, (_e7689 > 0i)))];
let _e7702 = ((bitcast<f32>(_e7686) + (f32(bitcast<i32>((_e7660 >> bitcast<u32>(12u)))) * bitcast<f32>(_e7695))) + ((f32((bitcast<i32>((_e7660 & 4095u)) - 2048i)) * bitcast<f32>(_e7676)) * (_e7636 - f32(_e7651))));
let _e7706 = select(_e7166.member_6.x, _e7177.x, _e7171);
let _e7709 = select(_e7166.member_6.y, _e7177.y, _e7171);
let _e7712 = select(_e7166.member_6.z, _e7177.z, _e7171);
let _e7713 = select(1f, _e7702, _e7170);
let _e7718 = (((_e7706 * _e7706) + (_e7709 * _e7709)) + (_e7712 * _e7712));
let _e7721 = sqrt(select(0f, _e7718, (_e7718 > 0f)));
let _e7724 = (1f / select(1e-20f, _e7721, (_e7721 > 1e-20f)));
let _e7725 = (_e7706 * _e7724);
let _e7726 = (_e7709 * _e7724);
let _e7727 = (_e7712 * _e7724);
let _e7732 = (((_e247 * _e7725) + (_e258 * _e7726)) + (_e269 * _e7727));
let _e7737 = (((_e247 * _e247) + (_e258 * _e258)) + (_e269 * _e269));
let _e7739 = ((_e7713 * _e7713) - _e7737);
let _e7740 = (_e7732 * _e7732);
let _e7741 = (_e7740 + _e7739);
let _e7744 = sqrt(select(0f, _e7741, (_e7741 > 0f)));
let _e7748 = (_e7741 <= 0f);
let _e7751 = select((select(_e7744, -(_e7744), (_e7732 < 0f)) - _e7732), (-2f * _e7732), _e7748);
let _e7752 = (_e7739 == 0f);
let _e7763 = (_e7748 && (_e7739 != 0f));
let _e7769 = (!(_e7171) && (_e7763 || (_e7740 < ((0.1f * 0.1f) * _e7737))));
let _e7771 = select(1e-12f, _e7737, (_e7737 > 1e-12f));
let _e7775 = (_e7713 / sqrt(select(0f, _e7771, (_e7771 > 0f))));
let _e7787 = ((_e7171 || (bitcast<f32>((bitcast<u32>(_e7166.member_4) & 2147483647u)) < select(1f, _e7192, (_e7192 < 1f)))) && (_e7702 != 1f));
let _e7788 = select(_e247, select(select(select((_e247 + (_e7725 * _e7751)), _e247, _e7752), _e247, _e7763), (_e247 * _e7775), _e7769), _e7787);
let _e7789 = select(_e258, select(select(select((_e258 + (_e7726 * _e7751)), _e258, _e7752), _e258, _e7763), (_e258 * _e7775), _e7769), _e7787);
let _e7790 = select(_e269, select(select(select((_e269 + (_e7727 * _e7751)), _e269, _e7752), _e269, _e7763), (_e269 * _e7775), _e7769), _e7787);
let _e7802 = global_1.member.member_7.member_2;
let _e7805 = (_e7802 / select(1e-6f, _e7790, (_e7790 > 1e-6f)));
let _e7809 = (_e1204 + (_e7788 * _e7805));
let _e7810 = (_e1209 + (_e7789 * _e7805));
let _e7811 = (_e1198 + (_e7790 * _e7805));
let _e7817 = ((((_e1213.member.member * _e7809) + (_e1213.member.member_1 * _e7810)) + (_e1213.member.member_2 * _e7811)) + _e1213.member_1);
let _e7823 = ((((_e1228.member.member * _e7809) + (_e1228.member.member_1 * _e7810)) + (_e1228.member.member_2 * _e7811)) + _e1228.member_1);
let _e7829 = ((((_e1243.member.member * _e7809) + (_e1243.member.member_1 * _e7810)) + (_e1243.member.member_2 * _e7811)) + _e1243.member_1);
let _e7830 = (_e4194 - _e7817);
let _e7831 = -(_e6608);
let _e7834 = (_e6608 - _e7830);
let _e7835 = (_e7830 - _e6608);
let _e7837 = select(_e7835, _e7834, (_e7834 > _e7835));
let _e7840 = (select(_e7831, _e6608, (_e6608 > _e7831)) / select(1e-30f, _e7837, (_e7837 > 1e-30f)));
let _e7843 = select(0f, select(2f, _e7840, (_e7830 < 0f)), _e6623);
let _e7846 = select(2f, select(0f, _e7840, _e6620), (_e7830 > 0f));
let _e7850 = ((_e7843 > -1f) || ((_e7843 == -1f) && _e6642));
let _e7851 = (_e7846 < 2f);
let _e7852 = select(-1f, _e7843, _e7850);
let _e7856 = select(2f, _e7846, _e7851);
let _e7861 = select(-1e30f, _e7830, (_e7830 > -1e30f));
let _e7865 = (_e7817 - _e4199);
let _e7866 = -(_e6648);
let _e7869 = (_e6648 - _e7865);
let _e7870 = (_e7865 - _e6648);
let _e7872 = select(_e7870, _e7869, (_e7869 > _e7870));
let _e7875 = (select(_e7866, _e6648, (_e6648 > _e7866)) / select(1e-30f, _e7872, (_e7872 > 1e-30f)));
let _e7878 = select(0f, select(2f, _e7875, (_e7865 < 0f)), _e6663);
let _e7881 = select(2f, select(0f, _e7875, _e6660), (_e7865 > 0f));
let _e7885 = ((_e7878 > _e7852) || ((_e7878 == _e7852) && _e6682));
let _e7886 = (_e7881 < _e7856);
let _e7887 = select(_e7852, _e7878, _e7885);
let _e7891 = select(_e7856, _e7881, _e7886);
let _e7896 = select(_e7861, _e7865, (_e7865 > _e7861));
let _e7900 = (_e4208 - _e7823);
let _e7901 = -(_e6687);
let _e7904 = (_e6687 - _e7900);
let _e7905 = (_e7900 - _e6687);
let _e7907 = select(_e7905, _e7904, (_e7904 > _e7905));
let _e7910 = (select(_e7901, _e6687, (_e6687 > _e7901)) / select(1e-30f, _e7907, (_e7907 > 1e-30f)));
let _e7913 = select(0f, select(2f, _e7910, (_e7900 < 0f)), _e6702);
let _e7916 = select(2f, select(0f, _e7910, _e6699), (_e7900 > 0f));
let _e7920 = ((_e7913 > _e7887) || ((_e7913 == _e7887) && _e6721));
let _e7921 = (_e7916 < _e7891);
let _e7922 = select(_e7887, _e7913, _e7920);
let _e7926 = select(_e7891, _e7916, _e7921);
let _e7931 = select(_e7896, _e7900, (_e7900 > _e7896));
let _e7935 = (_e7823 - _e4213);
let _e7936 = -(_e6727);
let _e7939 = (_e6727 - _e7935);
let _e7940 = (_e7935 - _e6727);
let _e7942 = select(_e7940, _e7939, (_e7939 > _e7940));
let _e7945 = (select(_e7936, _e6727, (_e6727 > _e7936)) / select(1e-30f, _e7942, (_e7942 > 1e-30f)));
let _e7948 = select(0f, select(2f, _e7945, (_e7935 < 0f)), _e6742);
let _e7951 = select(2f, select(0f, _e7945, _e6739), (_e7935 > 0f));
let _e7955 = ((_e7948 > _e7922) || ((_e7948 == _e7922) && _e6761));
let _e7956 = (_e7951 < _e7926);
let _e7957 = select(_e7922, _e7948, _e7955);
let _e7961 = select(_e7926, _e7951, _e7956);
let _e7966 = select(_e7931, _e7935, (_e7935 > _e7931));
let _e7970 = (_e4222 - _e7829);
let _e7971 = -(_e6766);
let _e7974 = (_e6766 - _e7970);
let _e7975 = (_e7970 - _e6766);
let _e7977 = select(_e7975, _e7974, (_e7974 > _e7975));
let _e7980 = (select(_e7971, _e6766, (_e6766 > _e7971)) / select(1e-30f, _e7977, (_e7977 > 1e-30f)));
let _e7983 = select(0f, select(2f, _e7980, (_e7970 < 0f)), _e6781);
let _e7986 = select(2f, select(0f, _e7980, _e6778), (_e7970 > 0f));
let _e7990 = ((_e7983 > _e7957) || ((_e7983 == _e7957) && _e6800));
let _e7991 = (_e7986 < _e7961);
let _e7992 = select(_e7957, _e7983, _e7990);
let _e7996 = select(_e7961, _e7986, _e7991);
let _e8001 = select(_e7966, _e7970, (_e7970 > _e7966));
let _e8005 = (_e7829 - _e4227);
let _e8006 = -(_e6806);
let _e8009 = (_e6806 - _e8005);
let _e8010 = (_e8005 - _e6806);
let _e8012 = select(_e8010, _e8009, (_e8009 > _e8010));
let _e8015 = (select(_e8006, _e6806, (_e6806 > _e8006)) / select(1e-30f, _e8012, (_e8012 > 1e-30f)));
let _e8018 = select(0f, select(2f, _e8015, (_e8005 < 0f)), _e6821);
let _e8021 = select(2f, select(0f, _e8015, _e6818), (_e8005 > 0f));
let _e8025 = ((_e8018 > _e7992) || ((_e8018 == _e7992) && _e6842));
let _e8026 = (_e8021 < _e7996);
let _e8027 = select(_e7992, _e8018, _e8025);
let _e8028 = select(select(select(select(select(select(0f, _e6588.member, _e7850), _e6588.member, _e7885), _e6596.member, _e7920), _e6596.member, _e7955), _e6604.member, _e7990), _e6604.member, _e8025);
let _e8029 = select(select(select(select(select(select(0f, _e6588.member_1, _e7850), _e6588.member_1, _e7885), _e6596.member_1, _e7920), _e6596.member_1, _e7955), _e6604.member_1, _e7990), _e6604.member_1, _e8025);
let _e8030 = select(select(select(select(select(select(1f, _e6588.member_2, _e7850), _e6588.member_2, _e7885), _e6596.member_2, _e7920), _e6596.member_2, _e7955), _e6604.member_2, _e7990), _e6604.member_2, _e8025);
let _e8032 = select(_e7996, _e8021, _e8026);
let _e8033 = select(select(select(select(select(select(0f, _e6588.member, _e7851), _e6588.member, _e7886), _e6596.member, _e7921), _e6596.member, _e7956), _e6604.member, _e7991), _e6604.member, _e8026);
let _e8034 = select(select(select(select(select(select(0f, _e6588.member_1, _e7851), _e6588.member_1, _e7886), _e6596.member_1, _e7921), _e6596.member_1, _e7956), _e6604.member_1, _e7991), _e6604.member_1, _e8026);
let _e8035 = select(select(select(select(select(select(1f, _e6588.member_2, _e7851), _e6588.member_2, _e7886), _e6596.member_2, _e7921), _e6596.member_2, _e7956), _e6604.member_2, _e7991), _e6604.member_2, _e8026);
let _e8038 = select(_e8001, _e8005, (_e8005 > _e8001));
let _e8039 = select(select(select(select(select(select(0f, _e6588.member, _e6642), _e6588.member, _e6682), _e6596.member, _e6721), _e6596.member, _e6761), _e6604.member, _e6800), _e6604.member, _e6842);
let _e8040 = select(select(select(select(select(select(0f, _e6588.member_1, _e6642), _e6588.member_1, _e6682), _e6596.member_1, _e6721), _e6596.member_1, _e6761), _e6604.member_1, _e6800), _e6604.member_1, _e6842);
let _e8041 = select(select(select(select(select(select(1f, _e6588.member_2, _e6642), _e6588.member_2, _e6682), _e6596.member_2, _e6721), _e6596.member_2, _e6761), _e6604.member_2, _e6800), _e6604.member_2, _e6842);
if _e4580 {
phi_18631_ = type_37(_e8027, vec3<f32>(_e8028, _e8029, _e8030), _e8032, vec3<f32>(_e8033, _e8034, _e8035), _e6843, _e8038, vec3<f32>(_e8039, _e8040, _e8041));
} else {
let _e8047 = global_1.member.member_16.member_1;
let _e8048 = (_e8047 != 0u);
let _e8052 = global_1.member.member_16.member;
let _e8072 = select(-1e6f, (((((_e8052.member.member * _e1204) + (_e8052.member.member_1 * _e1209)) + (_e8052.member.member_2 * _e1198)) + _e8052.member_1) * _e7191), _e8048);
let _e8073 = select(-1e6f, (((((_e8052.member.member * _e7809) + (_e8052.member.member_1 * _e7810)) + (_e8052.member.member_2 * _e7811)) + _e8052.member_1) * _e7191), _e8048);
let _e8078 = global_1.member.member_16.member.member;
let _e8082 = -(_e8072);
let _e8085 = (_e8072 - _e8073);
let _e8086 = (_e8073 - _e8072);
let _e8088 = select(_e8086, _e8085, (_e8085 > _e8086));
let _e8091 = (select(_e8082, _e8072, (_e8072 > _e8082)) / select(1e-30f, _e8088, (_e8088 > 1e-30f)));
let _e8095 = select(0f, select(2f, _e8091, (_e8073 < 0f)), (_e8072 > 0f));
let _e8099 = select(2f, select(0f, _e8091, (_e8072 < 0f)), (_e8073 > 0f));
let _e8100 = (_e8072 > _e6843);
let _e8104 = ((_e8095 > _e8027) || ((_e8095 == _e8027) && _e8100));
let _e8105 = (_e8099 < _e8032);
let _e8106 = select(_e8027, _e8095, _e8104);
let _e8110 = select(_e8032, _e8099, _e8105);
let _e8114 = select(_e6843, _e8072, _e8100);
let _e8116 = select(_e8038, _e8073, (_e8073 > _e8038));
let _e8123 = global_1.member.member_17.member_1;
let _e8124 = (_e8123 != 0u);
let _e8128 = global_1.member.member_17.member;
let _e8148 = select(-1e6f, (((((_e8128.member.member * _e1204) + (_e8128.member.member_1 * _e1209)) + (_e8128.member.member_2 * _e1198)) + _e8128.member_1) * _e7191), _e8124);
let _e8149 = select(-1e6f, (((((_e8128.member.member * _e7809) + (_e8128.member.member_1 * _e7810)) + (_e8128.member.member_2 * _e7811)) + _e8128.member_1) * _e7191), _e8124);
let _e8154 = global_1.member.member_17.member.member;
let _e8158 = -(_e8148);
let _e8161 = (_e8148 - _e8149);
let _e8162 = (_e8149 - _e8148);
let _e8164 = select(_e8162, _e8161, (_e8161 > _e8162));
let _e8167 = (select(_e8158, _e8148, (_e8148 > _e8158)) / select(1e-30f, _e8164, (_e8164 > 1e-30f)));
let _e8171 = select(0f, select(2f, _e8167, (_e8149 < 0f)), (_e8148 > 0f));
let _e8175 = select(2f, select(0f, _e8167, (_e8148 < 0f)), (_e8149 > 0f));
let _e8176 = (_e8148 > _e8114);
let _e8180 = ((_e8171 > _e8106) || ((_e8171 == _e8106) && _e8176));
let _e8181 = (_e8175 < _e8110);
let _e8182 = select(_e8106, _e8171, _e8180);
let _e8186 = select(_e8110, _e8175, _e8181);
let _e8190 = select(_e8114, _e8148, _e8176);
let _e8192 = select(_e8116, _e8149, (_e8149 > _e8116));
let _e8199 = global_1.member.member_18.member_1;
let _e8200 = (_e8199 != 0u);
let _e8204 = global_1.member.member_18.member;
let _e8224 = select(-1e6f, (((((_e8204.member.member * _e1204) + (_e8204.member.member_1 * _e1209)) + (_e8204.member.member_2 * _e1198)) + _e8204.member_1) * _e7191), _e8200);
let _e8225 = select(-1e6f, (((((_e8204.member.member * _e7809) + (_e8204.member.member_1 * _e7810)) + (_e8204.member.member_2 * _e7811)) + _e8204.member_1) * _e7191), _e8200);
let _e8230 = global_1.member.member_18.member.member;
let _e8234 = -(_e8224);
let _e8237 = (_e8224 - _e8225);
let _e8238 = (_e8225 - _e8224);
let _e8240 = select(_e8238, _e8237, (_e8237 > _e8238));
let _e8243 = (select(_e8234, _e8224, (_e8224 > _e8234)) / select(1e-30f, _e8240, (_e8240 > 1e-30f)));
let _e8247 = select(0f, select(2f, _e8243, (_e8225 < 0f)), (_e8224 > 0f));
let _e8251 = select(2f, select(0f, _e8243, (_e8224 < 0f)), (_e8225 > 0f));
let _e8252 = (_e8224 > _e8190);
let _e8256 = ((_e8247 > _e8182) || ((_e8247 == _e8182) && _e8252));
let _e8257 = (_e8251 < _e8186);
let _e8258 = select(_e8182, _e8247, _e8256);
let _e8262 = select(_e8186, _e8251, _e8257);
let _e8266 = select(_e8190, _e8224, _e8252);
let _e8268 = select(_e8192, _e8225, (_e8225 > _e8192));
let _e8275 = global_1.member.member_19.member_1;
let _e8276 = (_e8275 != 0u);
let _e8280 = global_1.member.member_19.member;
let _e8300 = select(-1e6f, (((((_e8280.member.member * _e1204) + (_e8280.member.member_1 * _e1209)) + (_e8280.member.member_2 * _e1198)) + _e8280.member_1) * _e7191), _e8276);
let _e8301 = select(-1e6f, (((((_e8280.member.member * _e7809) + (_e8280.member.member_1 * _e7810)) + (_e8280.member.member_2 * _e7811)) + _e8280.member_1) * _e7191), _e8276);
let _e8306 = global_1.member.member_19.member.member;
let _e8310 = -(_e8300);
let _e8313 = (_e8300 - _e8301);
let _e8314 = (_e8301 - _e8300);
let _e8316 = select(_e8314, _e8313, (_e8313 > _e8314));
let _e8319 = (select(_e8310, _e8300, (_e8300 > _e8310)) / select(1e-30f, _e8316, (_e8316 > 1e-30f)));
let _e8323 = select(0f, select(2f, _e8319, (_e8301 < 0f)), (_e8300 > 0f));
let _e8327 = select(2f, select(0f, _e8319, (_e8300 < 0f)), (_e8301 > 0f));
let _e8328 = (_e8300 > _e8266);
let _e8332 = ((_e8323 > _e8258) || ((_e8323 == _e8258) && _e8328));
let _e8333 = (_e8327 < _e8262);
phi_18631_ = type_37(select(_e8258, _e8323, _e8332), vec3<f32>(select(select(select(select(_e8028, _e8078.member, _e8104), _e8154.member, _e8180), _e8230.member, _e8256), _e8306.member, _e8332), select(select(select(select(_e8029, _e8078.member_1, _e8104), _e8154.member_1, _e8180), _e8230.member_1, _e8256), _e8306.member_1, _e8332), select(select(select(select(_e8030, _e8078.member_2, _e8104), _e8154.member_2, _e8180), _e8230.member_2, _e8256), _e8306.member_2, _e8332)), select(_e8262, _e8327, _e8333), vec3<f32>(select(select(select(select(_e8033, _e8078.member, _e8105), _e8154.member, _e8181), _e8230.member, _e8257), _e8306.member, _e8333), select(select(select(select(_e8034, _e8078.member_1, _e8105), _e8154.member_1, _e8181), _e8230.member_1, _e8257), _e8306.member_1, _e8333), select(select(select(select(_e8035, _e8078.member_2, _e8105), _e8154.member_2, _e8181), _e8230.member_2, _e8257), _e8306.member_2, _e8333)), select(_e8266, _e8300, _e8328), select(_e8268, _e8301, (_e8301 > _e8268)), vec3<f32>(select(select(select(select(_e8039, _e8078.member, _e8100), _e8154.member, _e8176), _e8230.member, _e8252), _e8306.member, _e8328), select(select(select(select(_e8040, _e8078.member_1, _e8100), _e8154.member_1, _e8176), _e8230.member_1, _e8252), _e8306.member_1, _e8328), select(select(select(select(_e8041, _e8078.member_2, _e8100), _e8154.member_2, _e8176), _e8230.member_2, _e8252), _e8306.member_2, _e8328)));
}
let _e8353 = phi_18631_;
let _e8362 = global_1.member.member_7.member_4;
let _e8365 = (_e4189.member_4.x * _e4821.member_2);
let _e8367 = (_e4189.member_4.y * _e4821.member_2);
let _e8369 = (_e4189.member_4.z * _e4821.member_2);
let _e8370 = (0.5f * (_e7805 * select(1f, (2f * (1f - _e7179)), (_e7171 && _e7170))));
let _e8374 = (_e7788 + (_e8365 * _e8370));
let _e8375 = (_e7789 + (_e8367 * _e8370));
let _e8376 = (_e7790 + (_e8369 * _e8370));
let _e8378 = (2f * _e7802);
let _e8380 = ((_e8376 * _e8376) + (_e8378 * _e8369));
let _e8384 = (_e8376 + sqrt(select(0f, _e8380, (_e8380 > 0f))));
let _e8388 = (select(0.5f, _e8353.member_2, (_e8353.member_2 < 1f)) * (_e8378 / select(1e-6f, _e8384, (_e8384 > 1e-6f))));
let _e8392 = (_e8374 + (_e8365 * _e8388));
let _e8393 = (_e8375 + (_e8367 * _e8388));
let _e8394 = (_e8376 + (_e8369 * _e8388));
let _e8398 = (_e8362 * _e8362);
let _e8400 = (_e8394 * _e8394);
let _e8408 = (((_e8376 <= 0f) || (_e8380 <= 0f)) || ((_e8394 <= 0f) || (_e8400 <= (_e8398 * (((_e8392 * _e8392) + (_e8393 * _e8393)) + _e8400)))));
let _e8422 = (_e7788 + ((_e4189.member_5.x * _e4821.member_2) * _e7802));
let _e8423 = (_e7789 + ((_e4189.member_5.y * _e4821.member_2) * _e7802));
let _e8424 = (_e7790 + ((_e4189.member_5.z * _e4821.member_2) * _e7802));
let _e8426 = (_e8424 * _e8424);
let _e8435 = ((_e4578 & 1u) != 0u);
let _e8440 = (select(_e8408, ((_e8424 <= 0f) || (_e8426 <= (_e8398 * (((_e8422 * _e8422) + (_e8423 * _e8423)) + _e8426)))), _e8435) || (_e7787 && ((_e7763 && _e7171) || (_e7171 && (_e7790 <= 0f)))));
phi_18783_ = vec3<f32>(select(select(select(_e8392, _e8374, _e8408), _e8422, _e8435), _e247, _e8440), select(select(select(_e8393, _e8375, _e8408), _e8423, _e8435), _e258, _e8440), select(select(select(_e8394, _e8376, _e8408), _e8424, _e8435), _e269, _e8440));
phi_18784_ = select(1f, 0f, _e8440);
} else {
phi_18783_ = vec3<f32>(_e247, _e258, _e269);
phi_18784_ = 1f;
}
let _e8447 = phi_18783_;
let _e8449 = phi_18784_;
let _e8451 = (_e6583 * _e8449);
global_4.member[_e204] = (_e215 * (_e6426.member_2.x * _e8451));
global_4.member[_e216] = (_e225 * (_e6426.member_2.y * _e8451));
global_4.member[_e227] = (_e236 * (_e6426.member_2.z * _e8451));
global_4.member[_e238] = _e8447.x;
global_4.member[_e249] = _e8447.y;
global_4.member[_e260] = _e8447.z;
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
