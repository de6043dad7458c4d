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
struct type_13 {
member: u32,
member_1: u32,
}
struct type_15 {
member: array<u32>,
}
struct type_16 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_17 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_18 {
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
struct type_19 {
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
struct type_20 {
member: type_5,
member_1: type_5,
}
struct type_21 {
member: type_13,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
}
struct type_22 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: u32,
member_4: type_13,
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
member_17: type_21,
member_18: type_5,
member_19: f32,
member_20: f32,
member_21: f32,
}
struct type_23 {
member: type_7,
member_1: u32,
}
struct type_24 {
member: type_2,
member_1: u32,
member_2: type_16,
member_3: type_13,
member_4: u32,
member_5: type_17,
member_6: type_18,
member_7: type_18,
member_8: type_19,
member_9: type_20,
member_10: type_22,
member_11: type_17,
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
member: type_24,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_25;
@group(0) @binding(2)
var<storage> global_2: type_11;
@group(0) @binding(3)
var<storage, read_write> global_3: type_11;
@group(0) @binding(1)
var<storage> global_4: type_15;
fn function_() {
var phi_1214_: u32;
var phi_1220_: u32;
var phi_1282_: u32;
var phi_1288_: u32;
var phi_1350_: u32;
var phi_1356_: u32;
let _e33 = global;
let _e40 = global_1.member.member_2;
let _e43 = global_1.member.member;
let _e51 = (_e33.x + _e40.member);
let _e53 = (_e33.y + _e40.member_1);
if (_e51 < _e40.member_2) {
if (_e53 < _e40.member_3) {
let _e56 = (_e43.member * _e43.member_1);
let _e58 = ((_e53 * _e43.member) + _e51);
let _e60 = f32(bitcast<i32>(_e51));
let _e62 = f32(bitcast<i32>(_e53));
let _e67 = global_1.member.member_10.member_4.member;
let _e72 = global_1.member.member_10.member_4.member_1;
let _e75 = f32(bitcast<i32>(_e67));
let _e80 = global_1.member.member_10.member_17.member_1;
let _e81 = (_e75 * _e80);
let _e86 = global_1.member.member_10.member_17.member_2;
let _e87 = ((_e60 + 1f) - _e86);
let _e89 = select(0f, _e87, (_e87 > 0f));
let _e92 = (_e87 - _e81);
let _e94 = select(0f, _e92, (_e92 > 0f));
let _e96 = (_e86 - _e94);
let _e97 = (_e86 * 1e-6f);
let _e102 = -(_e87);
let _e104 = select(0f, _e102, (_e102 > 0f));
let _e106 = (_e86 - _e104);
let _e112 = (_e60 - _e86);
let _e114 = select(0f, _e112, (_e112 > 0f));
let _e117 = (_e112 - _e81);
let _e119 = select(0f, _e117, (_e117 > 0f));
let _e121 = (_e86 - _e119);
let _e126 = -(_e112);
let _e128 = select(0f, _e126, (_e126 > 0f));
let _e130 = (_e86 - _e128);
let _e139 = f32(bitcast<i32>(_e72));
let _e140 = (_e139 * _e80);
let _e141 = ((_e62 + 1f) - _e86);
let _e143 = select(0f, _e141, (_e141 > 0f));
let _e146 = (_e141 - _e140);
let _e148 = select(0f, _e146, (_e146 > 0f));
let _e150 = (_e86 - _e148);
let _e155 = -(_e141);
let _e157 = select(0f, _e155, (_e155 > 0f));
let _e159 = (_e86 - _e157);
let _e165 = (_e62 - _e86);
let _e167 = select(0f, _e165, (_e165 > 0f));
let _e170 = (_e165 - _e140);
let _e172 = select(0f, _e170, (_e170 > 0f));
let _e174 = (_e86 - _e172);
let _e179 = -(_e165);
let _e181 = select(0f, _e179, (_e179 > 0f));
let _e183 = (_e86 - _e181);
let _e192 = ((_e60 + 0.5f) - _e86);
let _e194 = select(0f, _e192, (_e192 > 0f));
let _e197 = (_e192 - _e81);
let _e199 = select(0f, _e197, (_e197 > 0f));
let _e201 = (_e86 - _e199);
let _e206 = -(_e192);
let _e208 = select(0f, _e206, (_e206 > 0f));
let _e210 = (_e86 - _e208);
let _e215 = (((select(_e81, _e194, (_e194 < _e81)) + ((_e199 * _e86) / select(_e97, _e201, (_e201 > _e97)))) - ((_e208 * _e86) / select(_e97, _e210, (_e210 > _e97)))) / _e80);
let _e217 = ((_e62 + 0.5f) - _e86);
let _e219 = select(0f, _e217, (_e217 > 0f));
let _e222 = (_e217 - _e140);
let _e224 = select(0f, _e222, (_e222 > 0f));
let _e226 = (_e86 - _e224);
let _e231 = -(_e217);
let _e233 = select(0f, _e231, (_e231 > 0f));
let _e235 = (_e86 - _e233);
let _e240 = (((select(_e140, _e219, (_e219 < _e140)) + ((_e224 * _e86) / select(_e97, _e226, (_e226 > _e97)))) - ((_e233 * _e86) / select(_e97, _e235, (_e235 > _e97)))) / _e80);
let _e248 = (_e75 - 1f);
let _e250 = select(0f, _e215, (_e215 > 0f));
let _e252 = select(_e248, _e250, (_e250 < _e248));
let _e259 = select(0i, select(select(i32(_e252), i32(-2147483648), (_e252 < -2147483600f)), 2147483647i, (_e252 > 2147483500f)), (_e252 == _e252));
let _e263 = (_e259 - select(0i, 1i, (_e252 < f32(_e259))));
let _e264 = (_e139 - 1f);
let _e266 = select(0f, _e240, (_e240 > 0f));
let _e268 = select(_e264, _e266, (_e266 < _e264));
let _e275 = select(0i, select(select(i32(_e268), i32(-2147483648), (_e268 < -2147483600f)), 2147483647i, (_e268 > 2147483500f)), (_e268 == _e268));
let _e279 = (_e275 - select(0i, 1i, (_e268 < f32(_e275))));
let _e281 = (_e215 - f32(_e263));
let _e283 = (_e240 - f32(_e279));
let _e284 = bitcast<u32>(_e263);
let _e285 = bitcast<u32>(_e279);
let _e286 = (_e67 + 1u);
let _e289 = bitcast<i32>((_e286 * (_e72 + 1u)));
let _e290 = (6i * _e289);
let _e291 = (_e285 * _e286);
let _e293 = bitcast<i32>((_e291 + _e284));
let _e294 = (_e290 + _e293);
let _e296 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e298 = select(_e296, _e294, (_e294 < _e296));
let _e304 = global_2.member[bitcast<u32>(select(0i, _e298, (_e298 > 0i)))];
let _e305 = (_e294 + _e289);
let _e307 = select(_e296, _e305, (_e305 < _e296));
let _e313 = global_2.member[bitcast<u32>(select(0i, _e307, (_e307 > 0i)))];
let _e314 = (2i * _e289);
let _e315 = (_e294 + _e314);
let _e317 = select(_e296, _e315, (_e315 < _e296));
let _e323 = global_2.member[bitcast<u32>(select(0i, _e317, (_e317 > 0i)))];
let _e324 = (1f - _e281);
let _e328 = (_e284 + 1u);
let _e330 = bitcast<i32>((_e291 + _e328));
let _e331 = (_e290 + _e330);
let _e333 = select(_e296, _e331, (_e331 < _e296));
let _e339 = global_2.member[bitcast<u32>(select(0i, _e333, (_e333 > 0i)))];
let _e340 = (_e331 + _e289);
let _e342 = select(_e296, _e340, (_e340 < _e296));
let _e348 = global_2.member[bitcast<u32>(select(0i, _e342, (_e342 > 0i)))];
let _e349 = (_e331 + _e314);
let _e351 = select(_e296, _e349, (_e349 < _e296));
let _e357 = global_2.member[bitcast<u32>(select(0i, _e351, (_e351 > 0i)))];
let _e365 = ((_e285 + 1u) * _e286);
let _e367 = bitcast<i32>((_e365 + _e284));
let _e368 = (_e290 + _e367);
let _e370 = select(_e296, _e368, (_e368 < _e296));
let _e376 = global_2.member[bitcast<u32>(select(0i, _e370, (_e370 > 0i)))];
let _e377 = (_e368 + _e289);
let _e379 = select(_e296, _e377, (_e377 < _e296));
let _e385 = global_2.member[bitcast<u32>(select(0i, _e379, (_e379 > 0i)))];
let _e386 = (_e368 + _e314);
let _e388 = select(_e296, _e386, (_e386 < _e296));
let _e394 = global_2.member[bitcast<u32>(select(0i, _e388, (_e388 > 0i)))];
let _e399 = bitcast<i32>((_e365 + _e328));
let _e400 = (_e290 + _e399);
let _e402 = select(_e296, _e400, (_e400 < _e296));
let _e408 = global_2.member[bitcast<u32>(select(0i, _e402, (_e402 > 0i)))];
let _e409 = (_e400 + _e289);
let _e411 = select(_e296, _e409, (_e409 < _e296));
let _e417 = global_2.member[bitcast<u32>(select(0i, _e411, (_e411 > 0i)))];
let _e418 = (_e400 + _e314);
let _e420 = select(_e296, _e418, (_e418 < _e296));
let _e426 = global_2.member[bitcast<u32>(select(0i, _e420, (_e420 > 0i)))];
let _e433 = (1f - _e283);
let _e443 = (10i * _e289);
let _e444 = (_e443 + _e293);
let _e446 = select(_e296, _e444, (_e444 < _e296));
let _e452 = global_2.member[bitcast<u32>(select(0i, _e446, (_e446 > 0i)))];
let _e453 = (11i * _e289);
let _e454 = (_e453 + _e293);
let _e456 = select(_e296, _e454, (_e454 < _e296));
let _e462 = global_2.member[bitcast<u32>(select(0i, _e456, (_e456 > 0i)))];
let _e466 = (_e443 + _e330);
let _e468 = select(_e296, _e466, (_e466 < _e296));
let _e474 = global_2.member[bitcast<u32>(select(0i, _e468, (_e468 > 0i)))];
let _e475 = (_e453 + _e330);
let _e477 = select(_e296, _e475, (_e475 < _e296));
let _e483 = global_2.member[bitcast<u32>(select(0i, _e477, (_e477 > 0i)))];
let _e488 = (_e443 + _e367);
let _e490 = select(_e296, _e488, (_e488 < _e296));
let _e496 = global_2.member[bitcast<u32>(select(0i, _e490, (_e490 > 0i)))];
let _e497 = (_e453 + _e367);
let _e499 = select(_e296, _e497, (_e497 < _e296));
let _e505 = global_2.member[bitcast<u32>(select(0i, _e499, (_e499 > 0i)))];
let _e510 = (_e443 + _e399);
let _e512 = select(_e296, _e510, (_e510 < _e296));
let _e518 = global_2.member[bitcast<u32>(select(0i, _e512, (_e512 > 0i)))];
let _e519 = (_e453 + _e399);
let _e521 = select(_e296, _e519, (_e519 < _e296));
let _e527 = global_2.member[bitcast<u32>(select(0i, _e521, (_e521 > 0i)))];
let _e532 = select(0f, 1f, (((((_e452 == 0f) && (_e462 != 1f)) && ((_e474 == 0f) && (_e483 != 1f))) && ((_e496 == 0f) && (_e505 != 1f))) && ((_e518 == 0f) && (_e527 != 1f))));
let _e539 = global_1.member.member_10.member_21;
let _e541 = (((((_e215 >= 0f) && (_e215 <= _e75)) && (_e240 >= 0f)) && (_e240 <= _e139)) && (_e539 == 0f));
let _e548 = global_1.member.member.member;
let _e552 = bitcast<i32>((((_e53 * _e548) + _e51) * 6u));
let _e554 = (1f / ((((((select(_e81, _e89, (_e89 < _e81)) + ((_e94 * _e86) / select(_e97, _e96, (_e96 > _e97)))) - ((_e104 * _e86) / select(_e97, _e106, (_e106 > _e97)))) / _e80) - (((select(_e81, _e114, (_e114 < _e81)) + ((_e119 * _e86) / select(_e97, _e121, (_e121 > _e97)))) - ((_e128 * _e86) / select(_e97, _e130, (_e130 > _e97)))) / _e80)) * ((((select(_e140, _e143, (_e143 < _e140)) + ((_e148 * _e86) / select(_e97, _e150, (_e150 > _e97)))) - ((_e157 * _e86) / select(_e97, _e159, (_e159 > _e97)))) / _e80) - (((select(_e140, _e167, (_e167 < _e140)) + ((_e172 * _e86) / select(_e97, _e174, (_e174 > _e97)))) - ((_e181 * _e86) / select(_e97, _e183, (_e183 > _e97)))) / _e80))) * 16777216f));
let _e556 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e558 = select(_e556, _e552, (_e552 < _e556));
let _e564 = global_4.member[bitcast<u32>(select(0i, _e558, (_e558 > 0i)))];
let _e565 = (_e552 + 1i);
let _e567 = select(_e556, _e565, (_e565 < _e556));
let _e573 = global_4.member[bitcast<u32>(select(0i, _e567, (_e567 > 0i)))];
let _e576 = ((_e573 >> bitcast<u32>(31i)) != 0u);
if _e576 {
phi_1214_ = (~(_e564) + 1u);
} else {
phi_1214_ = _e564;
}
let _e582 = phi_1214_;
if _e576 {
phi_1220_ = (~(_e573) + select(0u, 1u, (_e564 == 0u)));
} else {
phi_1220_ = _e573;
}
let _e586 = phi_1220_;
let _e608 = ((((f32(bitcast<i32>(((_e586 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e586 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e582 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e582 & 65535u)))));
let _e614 = (_e552 + 2i);
let _e616 = select(_e556, _e614, (_e614 < _e556));
let _e622 = global_4.member[bitcast<u32>(select(0i, _e616, (_e616 > 0i)))];
let _e623 = (_e552 + 3i);
let _e625 = select(_e556, _e623, (_e623 < _e556));
let _e631 = global_4.member[bitcast<u32>(select(0i, _e625, (_e625 > 0i)))];
let _e634 = ((_e631 >> bitcast<u32>(31i)) != 0u);
if _e634 {
phi_1282_ = (~(_e622) + 1u);
} else {
phi_1282_ = _e622;
}
let _e640 = phi_1282_;
if _e634 {
phi_1288_ = (~(_e631) + select(0u, 1u, (_e622 == 0u)));
} else {
phi_1288_ = _e631;
}
let _e644 = phi_1288_;
let _e666 = ((((f32(bitcast<i32>(((_e644 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e644 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e640 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e640 & 65535u)))));
let _e672 = (_e552 + 4i);
let _e674 = select(_e556, _e672, (_e672 < _e556));
let _e680 = global_4.member[bitcast<u32>(select(0i, _e674, (_e674 > 0i)))];
let _e681 = (_e552 + 5i);
let _e683 = select(_e556, _e681, (_e681 < _e556));
let _e689 = global_4.member[bitcast<u32>(select(0i, _e683, (_e683 > 0i)))];
let _e692 = ((_e689 >> bitcast<u32>(31i)) != 0u);
if _e692 {
phi_1350_ = (~(_e680) + 1u);
} else {
phi_1350_ = _e680;
}
let _e698 = phi_1350_;
if _e692 {
phi_1356_ = (~(_e689) + select(0u, 1u, (_e680 == 0u)));
} else {
phi_1356_ = _e689;
}
let _e702 = phi_1356_;
let _e724 = ((((f32(bitcast<i32>(((_e702 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e702 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e698 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e698 & 65535u)))));
let _e733 = (select(1f, (((((_e304 * _e324) + (_e339 * _e281)) * _e433) + (((_e376 * _e324) + (_e408 * _e281)) * _e283)) * _e532), _e541) + (select(_e608, -(bitcast<f32>((bitcast<u32>(_e608) & 2147483647u))), _e576) * _e554));
let _e734 = (select(1f, (((((_e313 * _e324) + (_e348 * _e281)) * _e433) + (((_e385 * _e324) + (_e417 * _e281)) * _e283)) * _e532), _e541) + (select(_e666, -(bitcast<f32>((bitcast<u32>(_e666) & 2147483647u))), _e634) * _e554));
let _e735 = (select(1f, (((((_e323 * _e324) + (_e357 * _e281)) * _e433) + (((_e394 * _e324) + (_e426 * _e281)) * _e283)) * _e532), _e541) + (select(_e724, -(bitcast<f32>((bitcast<u32>(_e724) & 2147483647u))), _e692) * _e554));
global_3.member[_e58] = select(0f, _e733, (_e733 > 0f));
global_3.member[(_e56 + _e58)] = select(0f, _e734, (_e734 > 0f));
global_3.member[((2u * _e56) + _e58)] = select(0f, _e735, (_e735 > 0f));
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
