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
struct type_14 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_15 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_16 {
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
struct type_17 {
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
struct type_18 {
member: type_5,
member_1: type_5,
}
struct type_19 {
member: type_7,
member_1: u32,
}
struct type_20 {
member: type_2,
member_1: u32,
member_2: type_14,
member_3: type_13,
member_4: u32,
member_5: type_15,
member_6: type_16,
member_7: type_16,
member_8: type_17,
member_9: type_18,
member_10: f32,
member_11: type_15,
member_12: type_4,
member_13: type_9,
member_14: type_19,
member_15: type_19,
member_16: type_19,
member_17: type_19,
member_18: type_5,
member_19: f32,
member_20: f32,
member_21: type_6,
}
struct type_21 {
member: type_20,
}
struct type_22 {
member: u32,
member_1: u32,
member_2: f32,
member_3: f32,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_21;
@group(0) @binding(2)
var<storage, read_write> global_2: type_11;
@group(0) @binding(1)
var<storage> global_3: type_11;
fn function_() {
var local: u32;
var local_1: i32;
var local_2: i32;
var local_3: type_22;
var phi_307_: i32;
var phi_350_: i32;
var phi_543_: i32;
var phi_586_: i32;
var phi_779_: i32;
var phi_822_: i32;
let _e24 = global;
let _e31 = global_1.member.member_2;
let _e34 = global_1.member.member;
let _e42 = (_e24.x + _e31.member);
let _e44 = (_e24.y + _e31.member_1);
if (_e42 < _e31.member_2) {
if (_e44 < _e31.member_3) {
let _e49 = ((_e44 * _e34.member) + _e42);
local = _e42;
let _e53 = global_1.member.member_8.member;
local_1 = bitcast<i32>((_e44 * _e53));
let _e59 = global_1.member.member_8.member_1;
local_2 = bitcast<i32>((_e53 * _e59));
let _e62 = local_2;
let _e64 = local_1;
let _e66 = local;
let _e68 = (((3i * _e62) + _e64) + bitcast<i32>(_e66));
let _e70 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e72 = select(_e70, _e68, (_e68 < _e70));
let _e77 = global_3.member[bitcast<u32>(select(0i, _e72, (_e72 > 0i)))];
let _e78 = local_2;
let _e80 = local_1;
let _e82 = local;
let _e84 = (((4i * _e78) + _e80) + bitcast<i32>(_e82));
let _e86 = select(_e70, _e84, (_e84 < _e70));
let _e91 = global_3.member[bitcast<u32>(select(0i, _e86, (_e86 > 0i)))];
let _e92 = local_2;
let _e94 = local_1;
let _e96 = local;
let _e98 = (((5i * _e92) + _e94) + bitcast<i32>(_e96));
let _e100 = select(_e70, _e98, (_e98 < _e70));
let _e105 = global_3.member[bitcast<u32>(select(0i, _e100, (_e100 > 0i)))];
let _e109 = global_1.member.member_5.member_2;
let _e112 = (1f / select(1e-6f, _e105, (_e105 > 1e-6f)));
let _e116 = global_1.member.member_8.member_5;
let _e117 = (_e109 * _e116);
let _e122 = global_1.member.member_8.member_6;
let _e124 = (((_e77 * _e112) - _e122) * _e117);
let _e129 = global_1.member.member_8.member_7;
let _e131 = (((_e91 * _e112) - _e129) * _e117);
local_3.member = _e42;
local_3.member_1 = _e44;
local_3.member_2 = -(_e124);
local_3.member_3 = -(_e131);
let _e142 = global_1.member.member_9.member.member;
let _e145 = global_1.member.member_8.member;
let _e146 = bitcast<i32>(_e145);
let _e149 = global_1.member.member_8.member_1;
let _e151 = bitcast<i32>((_e145 * _e149));
let _e153 = local_3.member_1;
let _e156 = ((3i * _e151) + (bitcast<i32>(_e153) * _e146));
let _e157 = local_3.member_2;
let _e158 = -(32768f);
let _e160 = select(_e158, _e157, (_e157 > _e158));
let _e162 = select(32768f, _e160, (_e160 < 32768f));
let _e169 = select(0i, select(select(i32(_e162), i32(-2147483648), (_e162 < -2147483600f)), 2147483647i, (_e162 > 2147483500f)), (_e162 == _e162));
let _e173 = (_e169 - select(0i, 1i, (_e162 < f32(_e169))));
let _e175 = (_e157 - f32(_e173));
let _e176 = (_e173 < 0i);
if _e176 {
phi_307_ = (_e173 + 1i);
} else {
phi_307_ = _e173;
}
let _e179 = phi_307_;
let _e180 = select(1i, -1i, _e176);
let _e182 = select(_e175, (1f - _e175), _e176);
let _e183 = local_3.member_3;
let _e185 = select(_e158, _e183, (_e183 > _e158));
let _e187 = select(32768f, _e185, (_e185 < 32768f));
let _e194 = select(0i, select(select(i32(_e187), i32(-2147483648), (_e187 < -2147483600f)), 2147483647i, (_e187 > 2147483500f)), (_e187 == _e187));
let _e198 = (_e194 - select(0i, 1i, (_e187 < f32(_e194))));
let _e200 = (_e183 - f32(_e198));
let _e201 = (_e198 < 0i);
if _e201 {
phi_350_ = (_e198 + 1i);
} else {
phi_350_ = _e198;
}
let _e204 = phi_350_;
let _e210 = local_3.member;
let _e213 = (((_e156 + (_e204 * _e146)) + bitcast<i32>(_e210)) + _e179);
let _e215 = select(_e70, _e213, (_e213 < _e70));
let _e220 = global_3.member[bitcast<u32>(select(0i, _e215, (_e215 > 0i)))];
let _e221 = (_e213 + _e180);
let _e223 = select(_e70, _e221, (_e221 < _e70));
let _e228 = global_3.member[bitcast<u32>(select(0i, _e223, (_e223 > 0i)))];
let _e231 = (_e220 + ((_e228 - _e220) * _e182));
let _e235 = local_3.member;
let _e238 = (((_e156 + ((_e204 + select(1i, -1i, _e201)) * _e146)) + bitcast<i32>(_e235)) + _e179);
let _e240 = select(_e70, _e238, (_e238 < _e70));
let _e245 = global_3.member[bitcast<u32>(select(0i, _e240, (_e240 > 0i)))];
let _e246 = (_e238 + _e180);
let _e248 = select(_e70, _e246, (_e246 < _e70));
let _e253 = global_3.member[bitcast<u32>(select(0i, _e248, (_e248 > 0i)))];
let _e257 = local_3.member;
let _e260 = local_3.member_2;
let _e261 = (f32(bitcast<i32>(_e257)) + _e260);
let _e262 = local_3.member_1;
let _e265 = local_3.member_3;
let _e266 = (f32(bitcast<i32>(_e262)) + _e265);
let _e268 = (f32(_e146) - 1f);
let _e271 = (f32(bitcast<i32>(_e149)) - 1f);
let _e287 = global_1.member.member_9.member.member_1;
let _e289 = local_3.member_1;
let _e292 = ((4i * _e151) + (bitcast<i32>(_e289) * _e146));
let _e293 = local_3.member_2;
let _e295 = select(_e158, _e293, (_e293 > _e158));
let _e297 = select(32768f, _e295, (_e295 < 32768f));
let _e304 = select(0i, select(select(i32(_e297), i32(-2147483648), (_e297 < -2147483600f)), 2147483647i, (_e297 > 2147483500f)), (_e297 == _e297));
let _e308 = (_e304 - select(0i, 1i, (_e297 < f32(_e304))));
let _e310 = (_e293 - f32(_e308));
let _e311 = (_e308 < 0i);
if _e311 {
phi_543_ = (_e308 + 1i);
} else {
phi_543_ = _e308;
}
let _e314 = phi_543_;
let _e315 = select(1i, -1i, _e311);
let _e317 = select(_e310, (1f - _e310), _e311);
let _e318 = local_3.member_3;
let _e320 = select(_e158, _e318, (_e318 > _e158));
let _e322 = select(32768f, _e320, (_e320 < 32768f));
let _e329 = select(0i, select(select(i32(_e322), i32(-2147483648), (_e322 < -2147483600f)), 2147483647i, (_e322 > 2147483500f)), (_e322 == _e322));
let _e333 = (_e329 - select(0i, 1i, (_e322 < f32(_e329))));
let _e335 = (_e318 - f32(_e333));
let _e336 = (_e333 < 0i);
if _e336 {
phi_586_ = (_e333 + 1i);
} else {
phi_586_ = _e333;
}
let _e339 = phi_586_;
let _e345 = local_3.member;
let _e348 = (((_e292 + (_e339 * _e146)) + bitcast<i32>(_e345)) + _e314);
let _e350 = select(_e70, _e348, (_e348 < _e70));
let _e355 = global_3.member[bitcast<u32>(select(0i, _e350, (_e350 > 0i)))];
let _e356 = (_e348 + _e315);
let _e358 = select(_e70, _e356, (_e356 < _e70));
let _e363 = global_3.member[bitcast<u32>(select(0i, _e358, (_e358 > 0i)))];
let _e366 = (_e355 + ((_e363 - _e355) * _e317));
let _e370 = local_3.member;
let _e373 = (((_e292 + ((_e339 + select(1i, -1i, _e336)) * _e146)) + bitcast<i32>(_e370)) + _e314);
let _e375 = select(_e70, _e373, (_e373 < _e70));
let _e380 = global_3.member[bitcast<u32>(select(0i, _e375, (_e375 > 0i)))];
let _e381 = (_e373 + _e315);
let _e383 = select(_e70, _e381, (_e381 < _e70));
let _e388 = global_3.member[bitcast<u32>(select(0i, _e383, (_e383 > 0i)))];
let _e392 = local_3.member;
let _e395 = local_3.member_2;
let _e396 = (f32(bitcast<i32>(_e392)) + _e395);
let _e397 = local_3.member_1;
let _e400 = local_3.member_3;
let _e401 = (f32(bitcast<i32>(_e397)) + _e400);
let _e417 = global_1.member.member_9.member.member_2;
let _e419 = local_3.member_1;
let _e422 = ((5i * _e151) + (bitcast<i32>(_e419) * _e146));
let _e423 = local_3.member_2;
let _e425 = select(_e158, _e423, (_e423 > _e158));
let _e427 = select(32768f, _e425, (_e425 < 32768f));
let _e434 = select(0i, select(select(i32(_e427), i32(-2147483648), (_e427 < -2147483600f)), 2147483647i, (_e427 > 2147483500f)), (_e427 == _e427));
let _e438 = (_e434 - select(0i, 1i, (_e427 < f32(_e434))));
let _e440 = (_e423 - f32(_e438));
let _e441 = (_e438 < 0i);
if _e441 {
phi_779_ = (_e438 + 1i);
} else {
phi_779_ = _e438;
}
let _e444 = phi_779_;
let _e445 = select(1i, -1i, _e441);
let _e447 = select(_e440, (1f - _e440), _e441);
let _e448 = local_3.member_3;
let _e450 = select(_e158, _e448, (_e448 > _e158));
let _e452 = select(32768f, _e450, (_e450 < 32768f));
let _e459 = select(0i, select(select(i32(_e452), i32(-2147483648), (_e452 < -2147483600f)), 2147483647i, (_e452 > 2147483500f)), (_e452 == _e452));
let _e463 = (_e459 - select(0i, 1i, (_e452 < f32(_e459))));
let _e465 = (_e448 - f32(_e463));
let _e466 = (_e463 < 0i);
if _e466 {
phi_822_ = (_e463 + 1i);
} else {
phi_822_ = _e463;
}
let _e469 = phi_822_;
let _e475 = local_3.member;
let _e478 = (((_e422 + (_e469 * _e146)) + bitcast<i32>(_e475)) + _e444);
let _e480 = select(_e70, _e478, (_e478 < _e70));
let _e485 = global_3.member[bitcast<u32>(select(0i, _e480, (_e480 > 0i)))];
let _e486 = (_e478 + _e445);
let _e488 = select(_e70, _e486, (_e486 < _e70));
let _e493 = global_3.member[bitcast<u32>(select(0i, _e488, (_e488 > 0i)))];
let _e496 = (_e485 + ((_e493 - _e485) * _e447));
let _e500 = local_3.member;
let _e503 = (((_e422 + ((_e469 + select(1i, -1i, _e466)) * _e146)) + bitcast<i32>(_e500)) + _e444);
let _e505 = select(_e70, _e503, (_e503 < _e70));
let _e510 = global_3.member[bitcast<u32>(select(0i, _e505, (_e505 > 0i)))];
let _e511 = (_e503 + _e445);
let _e513 = select(_e70, _e511, (_e511 < _e70));
let _e518 = global_3.member[bitcast<u32>(select(0i, _e513, (_e513 > 0i)))];
let _e522 = local_3.member;
let _e525 = local_3.member_2;
let _e526 = (f32(bitcast<i32>(_e522)) + _e525);
let _e527 = local_3.member_1;
let _e530 = local_3.member_3;
let _e531 = (f32(bitcast<i32>(_e527)) + _e530);
let _e542 = select(_e417, (_e496 + (((_e510 + ((_e518 - _e510) * _e447)) - _e496) * select(_e465, (1f - _e465), _e466))), ((((_e526 >= 0f) && (_e526 <= _e268)) && (_e531 >= 0f)) && (_e531 <= _e271)));
let _e545 = (1f / select(1e-6f, _e542, (_e542 > 1e-6f)));
let _e554 = global_1.member.member_1;
let _e556 = ((_e554 & 1u) != 0u);
global_2.member[_e49] = select((((select(_e142, (_e231 + (((_e245 + ((_e253 - _e245) * _e182)) - _e231) * select(_e200, (1f - _e200), _e201))), ((((_e261 >= 0f) && (_e261 <= _e268)) && (_e266 >= 0f)) && (_e266 <= _e271))) * _e545) - _e122) * _e117), _e124, _e556);
global_2.member[((_e34.member * _e34.member_1) + _e49)] = select((((select(_e287, (_e366 + (((_e380 + ((_e388 - _e380) * _e317)) - _e366) * select(_e335, (1f - _e335), _e336))), ((((_e396 >= 0f) && (_e396 <= _e268)) && (_e401 >= 0f)) && (_e401 <= _e271))) * _e545) - _e129) * _e117), _e131, _e556);
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
