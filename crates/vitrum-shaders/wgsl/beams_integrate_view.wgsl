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
struct type_10 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: f32,
member_4: u32,
member_5: u32,
member_6: u32,
}
struct type_11 {
member: u32,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_10,
}
struct type_12 {
member: type_5,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
}
struct type_13 {
member: u32,
member_1: u32,
}
struct type_15 {
member: array<f32>,
}
struct type_17 {
member: u32,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_5,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
}
struct type_18 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
member_10: u32,
member_11: u32,
member_12: u32,
member_13: u32,
member_14: f32,
member_15: f32,
member_16: f32,
}
struct type_19 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: u32,
member_4: type_5,
member_5: type_5,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
member_10: u32,
member_11: u32,
}
struct type_20 {
member: f32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
}
struct type_21 {
member: type_5,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_22 {
member: type_2,
member_1: type_13,
member_2: type_4,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: f32,
member_8: type_5,
member_9: type_5,
member_10: type_11,
member_11: type_17,
member_12: type_18,
member_13: type_19,
member_14: type_9,
member_15: type_6,
member_16: type_12,
member_17: u32,
member_18: type_20,
member_19: type_21,
}
struct type_23 {
member: type_22,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_23;
@group(0) @binding(1)
var<storage> global_2: type_15;
@group(0) @binding(3)
var<storage, read_write> global_3: type_15;
@group(0) @binding(2)
var<storage> global_4: type_15;
fn function_() {
var local: f32;
var local_1: i32;
var local_2: f32;
var local_3: i32;
var local_4: u32;
var phi_490_: i32;
var phi_503_: i32;
var phi_517_: i32;
var phi_833_: i32;
var phi_846_: i32;
var phi_860_: i32;
switch bitcast<i32>(0u) {
default: {
let _e25 = global;
let _e34 = global_1.member.member;
if (_e25.x < _e34.member) {
if (_e25.y < _e34.member_1) {
local_4 = _e25.x;
let _e46 = global_1.member.member_1.member;
let _e47 = (_e46 == 0u);
if _e47 {
break;
}
let _e48 = local_4;
if _e47 {
break;
}
let _e50 = local_4;
let _e61 = global_1.member.member_1.member_1;
let _e71 = global_1.member.member_2.member;
let _e72 = (((((f32(bitcast<i32>((_e48 % _e46))) + 0.5f) / f32(bitcast<i32>(_e46))) * 2f) - 1f) * _e71);
let _e80 = global_1.member.member_2.member_1;
let _e81 = ((1f - (((f32(bitcast<i32>((_e50 / _e46))) + 0.5f) / f32(bitcast<i32>(_e61))) * 2f)) * _e80);
let _e84 = global_1.member.member_3;
let _e93 = global_1.member.member_4;
let _e100 = ((_e84.member * _e72) + (_e93.member * _e81));
let _e101 = ((_e84.member_1 * _e72) + (_e93.member_1 * _e81));
let _e102 = ((_e84.member_2 * _e72) + (_e93.member_2 * _e81));
let _e106 = global_1.member.member_2.member_3;
let _e107 = (_e106 != 0u);
let _e110 = global_1.member.member_5;
let _e117 = select((_e110.member + _e100), _e110.member, _e107);
let _e118 = select((_e110.member_1 + _e101), _e110.member_1, _e107);
let _e119 = select((_e110.member_2 + _e102), _e110.member_2, _e107);
let _e122 = global_1.member.member_6;
let _e129 = select(_e122.member, (_e122.member + _e100), _e107);
let _e130 = select(_e122.member_1, (_e122.member_1 + _e101), _e107);
let _e131 = select(_e122.member_2, (_e122.member_2 + _e102), _e107);
let _e136 = (((_e117 * _e117) + (_e118 * _e118)) + (_e119 * _e119));
let _e140 = (1f / sqrt(select(0f, _e136, (_e136 > 0f))));
let _e141 = (_e117 * _e140);
let _e142 = (_e118 * _e140);
let _e143 = (_e119 * _e140);
let _e147 = global_1.member.member.member;
let _e148 = local_4;
let _e150 = bitcast<i32>((_e147 + _e148));
let _e152 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e154 = select(_e152, _e150, (_e150 < _e152));
let _e159 = global_2.member[bitcast<u32>(select(0i, _e154, (_e154 > 0i)))];
let _e161 = local_4;
let _e163 = bitcast<i32>(((2u * _e147) + _e161));
let _e165 = select(_e152, _e163, (_e163 < _e152));
let _e170 = global_2.member[bitcast<u32>(select(0i, _e165, (_e165 > 0i)))];
let _e175 = global_1.member.member_13.member_6;
let _e177 = ((_e170 - _e159) / f32(_e175));
let _e180 = (_e159 + (_e177 * f32(_e25.y)));
let _e181 = (_e180 + _e177);
let _e183 = (0.5f * (_e180 + _e181));
let _e184 = (_e181 - _e180);
let _e185 = (0.28867513f * _e184);
let _e186 = (_e183 - _e185);
let _e196 = global_1.member.member_13.member_7;
let _e197 = bitcast<i32>(_e196);
let _e201 = global_1.member.member_13.member_8;
let _e202 = bitcast<i32>(_e201);
let _e206 = global_1.member.member_13.member_9;
let _e207 = bitcast<i32>(_e206);
let _e211 = global_1.member.member_13.member_4;
let _e218 = global_1.member.member_13.member_5;
let _e222 = f32(_e197);
let _e224 = (_e218.member - _e211.member);
let _e227 = (((((_e129 + (_e141 * _e186)) - _e211.member) / _e224) * _e222) - 0.5f);
let _e228 = (_e222 - 1f);
let _e230 = select(0f, _e227, (_e227 > 0f));
let _e232 = select(_e228, _e230, (_e230 < _e228));
let _e233 = f32(_e202);
let _e235 = (_e218.member_1 - _e211.member_1);
let _e238 = (((((_e130 + (_e142 * _e186)) - _e211.member_1) / _e235) * _e233) - 0.5f);
let _e239 = (_e233 - 1f);
let _e241 = select(0f, _e238, (_e238 > 0f));
let _e243 = select(_e239, _e241, (_e241 < _e239));
let _e244 = f32(_e207);
let _e246 = (_e218.member_2 - _e211.member_2);
let _e249 = (((((_e131 + (_e143 * _e186)) - _e211.member_2) / _e246) * _e244) - 0.5f);
let _e250 = (_e244 - 1f);
let _e252 = select(0f, _e249, (_e249 > 0f));
let _e254 = select(_e250, _e252, (_e252 < _e250));
let _e256 = select(0f, _e232, (_e232 > 0f));
let _e258 = select(1e6f, _e256, (_e256 < 1e6f));
let _e265 = select(0i, select(select(i32(_e258), i32(-2147483648), (_e258 < -2147483600f)), 2147483647i, (_e258 > 2147483500f)), (_e258 == _e258));
let _e269 = (_e265 - select(0i, 1i, (_e258 < f32(_e265))));
let _e271 = select(0f, _e243, (_e243 > 0f));
let _e273 = select(1e6f, _e271, (_e271 < 1e6f));
let _e280 = select(0i, select(select(i32(_e273), i32(-2147483648), (_e273 < -2147483600f)), 2147483647i, (_e273 > 2147483500f)), (_e273 == _e273));
let _e284 = (_e280 - select(0i, 1i, (_e273 < f32(_e280))));
let _e286 = select(0f, _e254, (_e254 > 0f));
let _e288 = select(1e6f, _e286, (_e286 < 1e6f));
let _e295 = select(0i, select(select(i32(_e288), i32(-2147483648), (_e288 < -2147483600f)), 2147483647i, (_e288 > 2147483500f)), (_e288 == _e288));
let _e299 = (_e295 - select(0i, 1i, (_e288 < f32(_e295))));
let _e303 = (_e243 - f32(_e284));
let _e305 = (_e254 - f32(_e299));
local_2 = (_e232 - f32(_e269));
let _e306 = (_e269 + 1i);
let _e308 = select(_e306, 0i, (_e306 < 0i));
if (_e308 >= _e197) {
phi_490_ = (_e197 - 1i);
} else {
phi_490_ = _e308;
}
let _e312 = phi_490_;
local_3 = (_e312 - _e269);
let _e314 = (_e284 + 1i);
let _e316 = select(_e314, 0i, (_e314 < 0i));
if (_e316 >= _e202) {
phi_503_ = (_e202 - 1i);
} else {
phi_503_ = _e316;
}
let _e320 = phi_503_;
let _e322 = ((_e320 - _e284) * _e197);
let _e323 = (_e299 + 1i);
let _e325 = select(_e323, 0i, (_e323 < 0i));
if (_e325 >= _e207) {
phi_517_ = (_e207 - 1i);
} else {
phi_517_ = _e325;
}
let _e329 = phi_517_;
let _e336 = global_1.member.member_13.member_10;
let _e337 = bitcast<i32>(_e336);
let _e342 = ((_e337 + (((_e299 * _e202) + _e284) * _e197)) + _e269);
let _e344 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e346 = select(_e344, _e342, (_e342 < _e344));
let _e351 = global_4.member[bitcast<u32>(select(0i, _e346, (_e346 > 0i)))];
let _e352 = local_2;
let _e355 = local_3;
let _e356 = (_e342 + _e355);
let _e358 = select(_e344, _e356, (_e356 < _e344));
let _e363 = global_4.member[bitcast<u32>(select(0i, _e358, (_e358 > 0i)))];
let _e364 = local_2;
let _e367 = (1f - _e303);
let _e369 = (_e342 + _e322);
let _e371 = select(_e344, _e369, (_e369 < _e344));
let _e376 = global_4.member[bitcast<u32>(select(0i, _e371, (_e371 > 0i)))];
let _e377 = local_2;
let _e380 = local_3;
let _e381 = (_e369 + _e380);
let _e383 = select(_e344, _e381, (_e381 < _e344));
let _e388 = global_4.member[bitcast<u32>(select(0i, _e383, (_e383 > 0i)))];
let _e389 = local_2;
let _e394 = (_e342 + (((_e329 - _e299) * _e197) * _e202));
let _e396 = select(_e344, _e394, (_e394 < _e344));
let _e401 = global_4.member[bitcast<u32>(select(0i, _e396, (_e396 > 0i)))];
let _e402 = local_2;
let _e405 = local_3;
let _e406 = (_e394 + _e405);
let _e408 = select(_e344, _e406, (_e406 < _e344));
let _e413 = global_4.member[bitcast<u32>(select(0i, _e408, (_e408 > 0i)))];
let _e414 = local_2;
let _e418 = (_e394 + _e322);
let _e420 = select(_e344, _e418, (_e418 < _e344));
let _e425 = global_4.member[bitcast<u32>(select(0i, _e420, (_e420 > 0i)))];
let _e426 = local_2;
let _e429 = local_3;
let _e430 = (_e418 + _e429);
let _e432 = select(_e344, _e430, (_e430 < _e344));
let _e437 = global_4.member[bitcast<u32>(select(0i, _e432, (_e432 > 0i)))];
let _e438 = local_2;
let _e447 = (_e183 + _e185);
let _e457 = (((((_e129 + (_e141 * _e447)) - _e211.member) / _e224) * _e222) - 0.5f);
let _e459 = select(0f, _e457, (_e457 > 0f));
let _e461 = select(_e228, _e459, (_e459 < _e228));
let _e465 = (((((_e130 + (_e142 * _e447)) - _e211.member_1) / _e235) * _e233) - 0.5f);
let _e467 = select(0f, _e465, (_e465 > 0f));
let _e469 = select(_e239, _e467, (_e467 < _e239));
let _e473 = (((((_e131 + (_e143 * _e447)) - _e211.member_2) / _e246) * _e244) - 0.5f);
let _e475 = select(0f, _e473, (_e473 > 0f));
let _e477 = select(_e250, _e475, (_e475 < _e250));
let _e479 = select(0f, _e461, (_e461 > 0f));
let _e481 = select(1e6f, _e479, (_e479 < 1e6f));
let _e488 = select(0i, select(select(i32(_e481), i32(-2147483648), (_e481 < -2147483600f)), 2147483647i, (_e481 > 2147483500f)), (_e481 == _e481));
let _e492 = (_e488 - select(0i, 1i, (_e481 < f32(_e488))));
let _e494 = select(0f, _e469, (_e469 > 0f));
let _e496 = select(1e6f, _e494, (_e494 < 1e6f));
let _e503 = select(0i, select(select(i32(_e496), i32(-2147483648), (_e496 < -2147483600f)), 2147483647i, (_e496 > 2147483500f)), (_e496 == _e496));
let _e507 = (_e503 - select(0i, 1i, (_e496 < f32(_e503))));
let _e509 = select(0f, _e477, (_e477 > 0f));
let _e511 = select(1e6f, _e509, (_e509 < 1e6f));
let _e518 = select(0i, select(select(i32(_e511), i32(-2147483648), (_e511 < -2147483600f)), 2147483647i, (_e511 > 2147483500f)), (_e511 == _e511));
let _e522 = (_e518 - select(0i, 1i, (_e511 < f32(_e518))));
let _e526 = (_e469 - f32(_e507));
let _e528 = (_e477 - f32(_e522));
local = (_e461 - f32(_e492));
let _e529 = (_e492 + 1i);
let _e531 = select(_e529, 0i, (_e529 < 0i));
if (_e531 >= _e197) {
phi_833_ = (_e197 - 1i);
} else {
phi_833_ = _e531;
}
let _e535 = phi_833_;
local_1 = (_e535 - _e492);
let _e537 = (_e507 + 1i);
let _e539 = select(_e537, 0i, (_e537 < 0i));
if (_e539 >= _e202) {
phi_846_ = (_e202 - 1i);
} else {
phi_846_ = _e539;
}
let _e543 = phi_846_;
let _e545 = ((_e543 - _e507) * _e197);
let _e546 = (_e522 + 1i);
let _e548 = select(_e546, 0i, (_e546 < 0i));
if (_e548 >= _e207) {
phi_860_ = (_e207 - 1i);
} else {
phi_860_ = _e548;
}
let _e552 = phi_860_;
let _e560 = ((_e337 + (((_e522 * _e202) + _e507) * _e197)) + _e492);
let _e562 = select(_e344, _e560, (_e560 < _e344));
let _e567 = global_4.member[bitcast<u32>(select(0i, _e562, (_e562 > 0i)))];
let _e568 = local;
let _e571 = local_1;
let _e572 = (_e560 + _e571);
let _e574 = select(_e344, _e572, (_e572 < _e344));
let _e579 = global_4.member[bitcast<u32>(select(0i, _e574, (_e574 > 0i)))];
let _e580 = local;
let _e583 = (1f - _e526);
let _e585 = (_e560 + _e545);
let _e587 = select(_e344, _e585, (_e585 < _e344));
let _e592 = global_4.member[bitcast<u32>(select(0i, _e587, (_e587 > 0i)))];
let _e593 = local;
let _e596 = local_1;
let _e597 = (_e585 + _e596);
let _e599 = select(_e344, _e597, (_e597 < _e344));
let _e604 = global_4.member[bitcast<u32>(select(0i, _e599, (_e599 > 0i)))];
let _e605 = local;
let _e610 = (_e560 + (((_e552 - _e522) * _e197) * _e202));
let _e612 = select(_e344, _e610, (_e610 < _e344));
let _e617 = global_4.member[bitcast<u32>(select(0i, _e612, (_e612 > 0i)))];
let _e618 = local;
let _e621 = local_1;
let _e622 = (_e610 + _e621);
let _e624 = select(_e344, _e622, (_e622 < _e344));
let _e629 = global_4.member[bitcast<u32>(select(0i, _e624, (_e624 > 0i)))];
let _e630 = local;
let _e634 = (_e610 + _e545);
let _e636 = select(_e344, _e634, (_e634 < _e344));
let _e641 = global_4.member[bitcast<u32>(select(0i, _e636, (_e636 > 0i)))];
let _e642 = local;
let _e645 = local_1;
let _e646 = (_e634 + _e645);
let _e648 = select(_e344, _e646, (_e646 < _e344));
let _e653 = global_4.member[bitcast<u32>(select(0i, _e648, (_e648 > 0i)))];
let _e654 = local;
global_3.member[((_e25.y * _e34.member) + _e25.x)] = ((0.5f * (((((((_e351 * (1f - _e352)) + (_e363 * _e364)) * _e367) + (((_e376 * (1f - _e377)) + (_e388 * _e389)) * _e303)) * (1f - _e305)) + (((((_e401 * (1f - _e402)) + (_e413 * _e414)) * _e367) + (((_e425 * (1f - _e426)) + (_e437 * _e438)) * _e303)) * _e305)) + ((((((_e567 * (1f - _e568)) + (_e579 * _e580)) * _e583) + (((_e592 * (1f - _e593)) + (_e604 * _e605)) * _e526)) * (1f - _e528)) + (((((_e617 * (1f - _e618)) + (_e629 * _e630)) * _e583) + (((_e641 * (1f - _e642)) + (_e653 * _e654)) * _e526)) * _e528)))) * _e184);
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
