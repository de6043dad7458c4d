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
@group(0) @binding(3)
var<storage, read_write> global_2: type_15;
@group(0) @binding(1)
var<storage> global_3: type_15;
@group(0) @binding(2)
var<storage> global_4: type_15;
fn function_() {
var local: f32;
var local_1: i32;
var local_2: f32;
var local_3: i32;
var local_4: i32;
var local_5: i32;
var local_6: i32;
var local_7: i32;
var local_8: i32;
var local_9: i32;
var phi_1033_: i32;
var phi_1046_: i32;
var phi_1060_: i32;
var phi_1376_: i32;
var phi_1389_: i32;
var phi_1403_: i32;
var phi_1606_: f32;
let _e34 = global;
let _e43 = global_1.member.member;
if (_e34.x < _e43.member) {
if (_e34.y < _e43.member_1) {
let _e55 = global_1.member.member_12.member_4;
let _e59 = global_1.member.member_12.member_6;
let _e61 = bitcast<i32>((_e55 * _e59));
let _e62 = bitcast<i32>(_e34.x);
let _e66 = global_1.member.member.member;
let _e67 = bitcast<i32>(_e66);
local_7 = _e61;
local_8 = _e62;
local_9 = _e67;
let _e68 = local_7;
let _e69 = local_9;
let _e72 = local_8;
let _e73 = ((_e68 + (18i * _e69)) + _e72);
let _e75 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e77 = select(_e75, _e73, (_e73 < _e75));
let _e82 = global_3.member[bitcast<u32>(select(0i, _e77, (_e77 > 0i)))];
let _e83 = local_7;
let _e84 = local_9;
let _e87 = local_8;
let _e88 = ((_e83 + (19i * _e84)) + _e87);
let _e90 = select(_e75, _e88, (_e88 < _e75));
let _e95 = global_3.member[bitcast<u32>(select(0i, _e90, (_e90 > 0i)))];
let _e97 = local_7;
let _e98 = local_9;
let _e101 = local_8;
let _e102 = ((_e97 + (20i * _e98)) + _e101);
let _e104 = select(_e75, _e102, (_e102 < _e75));
let _e109 = global_3.member[bitcast<u32>(select(0i, _e104, (_e104 > 0i)))];
if (((_e82 + _e95) + _e109) > 0f) {
local_4 = _e61;
local_5 = _e62;
local_6 = _e67;
let _e112 = local_4;
let _e113 = local_5;
let _e114 = (_e112 + _e113);
let _e116 = select(_e75, _e114, (_e114 < _e75));
let _e121 = global_3.member[bitcast<u32>(select(0i, _e116, (_e116 > 0i)))];
let _e122 = local_4;
let _e123 = local_6;
let _e125 = local_5;
let _e126 = ((_e122 + _e123) + _e125);
let _e128 = select(_e75, _e126, (_e126 < _e75));
let _e133 = global_3.member[bitcast<u32>(select(0i, _e128, (_e128 > 0i)))];
let _e134 = local_4;
let _e135 = local_6;
let _e138 = local_5;
let _e139 = ((_e134 + (2i * _e135)) + _e138);
let _e141 = select(_e75, _e139, (_e139 < _e75));
let _e146 = global_3.member[bitcast<u32>(select(0i, _e141, (_e141 > 0i)))];
let _e147 = local_4;
let _e148 = local_6;
let _e151 = local_5;
let _e152 = ((_e147 + (3i * _e148)) + _e151);
let _e154 = select(_e75, _e152, (_e152 < _e75));
let _e159 = global_3.member[bitcast<u32>(select(0i, _e154, (_e154 > 0i)))];
let _e160 = local_4;
let _e161 = local_6;
let _e164 = local_5;
let _e165 = ((_e160 + (4i * _e161)) + _e164);
let _e167 = select(_e75, _e165, (_e165 < _e75));
let _e172 = global_3.member[bitcast<u32>(select(0i, _e167, (_e167 > 0i)))];
let _e173 = local_4;
let _e174 = local_6;
let _e177 = local_5;
let _e178 = ((_e173 + (5i * _e174)) + _e177);
let _e180 = select(_e75, _e178, (_e178 < _e75));
let _e185 = global_3.member[bitcast<u32>(select(0i, _e180, (_e180 > 0i)))];
let _e186 = local_4;
let _e187 = local_6;
let _e190 = local_5;
let _e191 = ((_e186 + (23i * _e187)) + _e190);
let _e193 = select(_e75, _e191, (_e191 < _e75));
let _e198 = global_3.member[bitcast<u32>(select(0i, _e193, (_e193 > 0i)))];
let _e202 = global_1.member.member_13.member_6;
let _e204 = (_e198 / f32(_e202));
let _e206 = (_e204 * f32(_e34.y));
let _e207 = (_e206 + _e204);
let _e209 = (0.5f * (_e206 + _e207));
let _e210 = (_e207 - _e206);
let _e211 = (0.28867513f * _e210);
let _e212 = (_e209 - _e211);
let _e222 = global_1.member.member_13.member_7;
let _e223 = bitcast<i32>(_e222);
let _e227 = global_1.member.member_13.member_8;
let _e228 = bitcast<i32>(_e227);
let _e232 = global_1.member.member_13.member_9;
let _e233 = bitcast<i32>(_e232);
let _e237 = global_1.member.member_13.member_4;
let _e244 = global_1.member.member_13.member_5;
let _e248 = f32(_e223);
let _e250 = (_e244.member - _e237.member);
let _e253 = (((((_e121 + (_e159 * _e212)) - _e237.member) / _e250) * _e248) - 0.5f);
let _e254 = (_e248 - 1f);
let _e256 = select(0f, _e253, (_e253 > 0f));
let _e258 = select(_e254, _e256, (_e256 < _e254));
let _e259 = f32(_e228);
let _e261 = (_e244.member_1 - _e237.member_1);
let _e264 = (((((_e133 + (_e172 * _e212)) - _e237.member_1) / _e261) * _e259) - 0.5f);
let _e265 = (_e259 - 1f);
let _e267 = select(0f, _e264, (_e264 > 0f));
let _e269 = select(_e265, _e267, (_e267 < _e265));
let _e270 = f32(_e233);
let _e272 = (_e244.member_2 - _e237.member_2);
let _e275 = (((((_e146 + (_e185 * _e212)) - _e237.member_2) / _e272) * _e270) - 0.5f);
let _e276 = (_e270 - 1f);
let _e278 = select(0f, _e275, (_e275 > 0f));
let _e280 = select(_e276, _e278, (_e278 < _e276));
let _e282 = select(0f, _e258, (_e258 > 0f));
let _e284 = select(1e6f, _e282, (_e282 < 1e6f));
let _e291 = select(0i, select(select(i32(_e284), i32(-2147483648), (_e284 < -2147483600f)), 2147483647i, (_e284 > 2147483500f)), (_e284 == _e284));
let _e295 = (_e291 - select(0i, 1i, (_e284 < f32(_e291))));
let _e297 = select(0f, _e269, (_e269 > 0f));
let _e299 = select(1e6f, _e297, (_e297 < 1e6f));
let _e306 = select(0i, select(select(i32(_e299), i32(-2147483648), (_e299 < -2147483600f)), 2147483647i, (_e299 > 2147483500f)), (_e299 == _e299));
let _e310 = (_e306 - select(0i, 1i, (_e299 < f32(_e306))));
let _e312 = select(0f, _e280, (_e280 > 0f));
let _e314 = select(1e6f, _e312, (_e312 < 1e6f));
let _e321 = select(0i, select(select(i32(_e314), i32(-2147483648), (_e314 < -2147483600f)), 2147483647i, (_e314 > 2147483500f)), (_e314 == _e314));
let _e325 = (_e321 - select(0i, 1i, (_e314 < f32(_e321))));
let _e329 = (_e269 - f32(_e310));
let _e331 = (_e280 - f32(_e325));
local_2 = (_e258 - f32(_e295));
let _e332 = (_e295 + 1i);
let _e334 = select(_e332, 0i, (_e332 < 0i));
if (_e334 >= _e223) {
phi_1033_ = (_e223 - 1i);
} else {
phi_1033_ = _e334;
}
let _e338 = phi_1033_;
local_3 = (_e338 - _e295);
let _e340 = (_e310 + 1i);
let _e342 = select(_e340, 0i, (_e340 < 0i));
if (_e342 >= _e228) {
phi_1046_ = (_e228 - 1i);
} else {
phi_1046_ = _e342;
}
let _e346 = phi_1046_;
let _e348 = ((_e346 - _e310) * _e223);
let _e349 = (_e325 + 1i);
let _e351 = select(_e349, 0i, (_e349 < 0i));
if (_e351 >= _e233) {
phi_1060_ = (_e233 - 1i);
} else {
phi_1060_ = _e351;
}
let _e355 = phi_1060_;
let _e362 = global_1.member.member_13.member_10;
let _e363 = bitcast<i32>(_e362);
let _e368 = ((_e363 + (((_e325 * _e228) + _e310) * _e223)) + _e295);
let _e370 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e372 = select(_e370, _e368, (_e368 < _e370));
let _e377 = global_4.member[bitcast<u32>(select(0i, _e372, (_e372 > 0i)))];
let _e378 = local_2;
let _e381 = local_3;
let _e382 = (_e368 + _e381);
let _e384 = select(_e370, _e382, (_e382 < _e370));
let _e389 = global_4.member[bitcast<u32>(select(0i, _e384, (_e384 > 0i)))];
let _e390 = local_2;
let _e393 = (1f - _e329);
let _e395 = (_e368 + _e348);
let _e397 = select(_e370, _e395, (_e395 < _e370));
let _e402 = global_4.member[bitcast<u32>(select(0i, _e397, (_e397 > 0i)))];
let _e403 = local_2;
let _e406 = local_3;
let _e407 = (_e395 + _e406);
let _e409 = select(_e370, _e407, (_e407 < _e370));
let _e414 = global_4.member[bitcast<u32>(select(0i, _e409, (_e409 > 0i)))];
let _e415 = local_2;
let _e420 = (_e368 + (((_e355 - _e325) * _e223) * _e228));
let _e422 = select(_e370, _e420, (_e420 < _e370));
let _e427 = global_4.member[bitcast<u32>(select(0i, _e422, (_e422 > 0i)))];
let _e428 = local_2;
let _e431 = local_3;
let _e432 = (_e420 + _e431);
let _e434 = select(_e370, _e432, (_e432 < _e370));
let _e439 = global_4.member[bitcast<u32>(select(0i, _e434, (_e434 > 0i)))];
let _e440 = local_2;
let _e444 = (_e420 + _e348);
let _e446 = select(_e370, _e444, (_e444 < _e370));
let _e451 = global_4.member[bitcast<u32>(select(0i, _e446, (_e446 > 0i)))];
let _e452 = local_2;
let _e455 = local_3;
let _e456 = (_e444 + _e455);
let _e458 = select(_e370, _e456, (_e456 < _e370));
let _e463 = global_4.member[bitcast<u32>(select(0i, _e458, (_e458 > 0i)))];
let _e464 = local_2;
let _e473 = (_e209 + _e211);
let _e483 = (((((_e121 + (_e159 * _e473)) - _e237.member) / _e250) * _e248) - 0.5f);
let _e485 = select(0f, _e483, (_e483 > 0f));
let _e487 = select(_e254, _e485, (_e485 < _e254));
let _e491 = (((((_e133 + (_e172 * _e473)) - _e237.member_1) / _e261) * _e259) - 0.5f);
let _e493 = select(0f, _e491, (_e491 > 0f));
let _e495 = select(_e265, _e493, (_e493 < _e265));
let _e499 = (((((_e146 + (_e185 * _e473)) - _e237.member_2) / _e272) * _e270) - 0.5f);
let _e501 = select(0f, _e499, (_e499 > 0f));
let _e503 = select(_e276, _e501, (_e501 < _e276));
let _e505 = select(0f, _e487, (_e487 > 0f));
let _e507 = select(1e6f, _e505, (_e505 < 1e6f));
let _e514 = select(0i, select(select(i32(_e507), i32(-2147483648), (_e507 < -2147483600f)), 2147483647i, (_e507 > 2147483500f)), (_e507 == _e507));
let _e518 = (_e514 - select(0i, 1i, (_e507 < f32(_e514))));
let _e520 = select(0f, _e495, (_e495 > 0f));
let _e522 = select(1e6f, _e520, (_e520 < 1e6f));
let _e529 = select(0i, select(select(i32(_e522), i32(-2147483648), (_e522 < -2147483600f)), 2147483647i, (_e522 > 2147483500f)), (_e522 == _e522));
let _e533 = (_e529 - select(0i, 1i, (_e522 < f32(_e529))));
let _e535 = select(0f, _e503, (_e503 > 0f));
let _e537 = select(1e6f, _e535, (_e535 < 1e6f));
let _e544 = select(0i, select(select(i32(_e537), i32(-2147483648), (_e537 < -2147483600f)), 2147483647i, (_e537 > 2147483500f)), (_e537 == _e537));
let _e548 = (_e544 - select(0i, 1i, (_e537 < f32(_e544))));
let _e552 = (_e495 - f32(_e533));
let _e554 = (_e503 - f32(_e548));
local = (_e487 - f32(_e518));
let _e555 = (_e518 + 1i);
let _e557 = select(_e555, 0i, (_e555 < 0i));
if (_e557 >= _e223) {
phi_1376_ = (_e223 - 1i);
} else {
phi_1376_ = _e557;
}
let _e561 = phi_1376_;
local_1 = (_e561 - _e518);
let _e563 = (_e533 + 1i);
let _e565 = select(_e563, 0i, (_e563 < 0i));
if (_e565 >= _e228) {
phi_1389_ = (_e228 - 1i);
} else {
phi_1389_ = _e565;
}
let _e569 = phi_1389_;
let _e571 = ((_e569 - _e533) * _e223);
let _e572 = (_e548 + 1i);
let _e574 = select(_e572, 0i, (_e572 < 0i));
if (_e574 >= _e233) {
phi_1403_ = (_e233 - 1i);
} else {
phi_1403_ = _e574;
}
let _e578 = phi_1403_;
let _e586 = ((_e363 + (((_e548 * _e228) + _e533) * _e223)) + _e518);
let _e588 = select(_e370, _e586, (_e586 < _e370));
let _e593 = global_4.member[bitcast<u32>(select(0i, _e588, (_e588 > 0i)))];
let _e594 = local;
let _e597 = local_1;
let _e598 = (_e586 + _e597);
let _e600 = select(_e370, _e598, (_e598 < _e370));
let _e605 = global_4.member[bitcast<u32>(select(0i, _e600, (_e600 > 0i)))];
let _e606 = local;
let _e609 = (1f - _e552);
let _e611 = (_e586 + _e571);
let _e613 = select(_e370, _e611, (_e611 < _e370));
let _e618 = global_4.member[bitcast<u32>(select(0i, _e613, (_e613 > 0i)))];
let _e619 = local;
let _e622 = local_1;
let _e623 = (_e611 + _e622);
let _e625 = select(_e370, _e623, (_e623 < _e370));
let _e630 = global_4.member[bitcast<u32>(select(0i, _e625, (_e625 > 0i)))];
let _e631 = local;
let _e636 = (_e586 + (((_e578 - _e548) * _e223) * _e228));
let _e638 = select(_e370, _e636, (_e636 < _e370));
let _e643 = global_4.member[bitcast<u32>(select(0i, _e638, (_e638 > 0i)))];
let _e644 = local;
let _e647 = local_1;
let _e648 = (_e636 + _e647);
let _e650 = select(_e370, _e648, (_e648 < _e370));
let _e655 = global_4.member[bitcast<u32>(select(0i, _e650, (_e650 > 0i)))];
let _e656 = local;
let _e660 = (_e636 + _e571);
let _e662 = select(_e370, _e660, (_e660 < _e370));
let _e667 = global_4.member[bitcast<u32>(select(0i, _e662, (_e662 > 0i)))];
let _e668 = local;
let _e671 = local_1;
let _e672 = (_e660 + _e671);
let _e674 = select(_e370, _e672, (_e672 < _e370));
let _e679 = global_4.member[bitcast<u32>(select(0i, _e674, (_e674 > 0i)))];
let _e680 = local;
phi_1606_ = ((0.5f * (((((((_e377 * (1f - _e378)) + (_e389 * _e390)) * _e393) + (((_e402 * (1f - _e403)) + (_e414 * _e415)) * _e329)) * (1f - _e331)) + (((((_e427 * (1f - _e428)) + (_e439 * _e440)) * _e393) + (((_e451 * (1f - _e452)) + (_e463 * _e464)) * _e329)) * _e331)) + ((((((_e593 * (1f - _e594)) + (_e605 * _e606)) * _e609) + (((_e618 * (1f - _e619)) + (_e630 * _e631)) * _e552)) * (1f - _e554)) + (((((_e643 * (1f - _e644)) + (_e655 * _e656)) * _e609) + (((_e667 * (1f - _e668)) + (_e679 * _e680)) * _e552)) * _e554)))) * _e210);
} else {
phi_1606_ = 0f;
}
let _e693 = phi_1606_;
global_2.member[((_e34.y * _e43.member) + _e34.x)] = _e693;
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
