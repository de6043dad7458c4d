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
struct type_13 {
member: array<f32>,
}
struct type_16 {
member: u32,
member_1: u32,
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
member: type_2,
member_1: type_16,
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
member_16: type_5,
member_17: u32,
member_18: type_20,
}
struct type_22 {
member: type_21,
}
struct type_23 {
member: vec3<f32>,
member_1: vec3<f32>,
member_2: vec3<f32>,
member_3: vec3<f32>,
member_4: vec3<f32>,
member_5: vec3<f32>,
member_6: vec3<f32>,
member_7: f32,
member_8: f32,
member_9: f32,
member_10: f32,
member_11: i32,
}
struct type_24 {
member: f32,
member_1: f32,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_22;
@group(0) @binding(2)
var<storage, read_write> global_2: type_13;
@group(0) @binding(1)
var<storage> global_3: type_13;
fn function_() {
var local: i32;
var local_1: i32;
var local_2: i32;
var local_3: i32;
var local_4: i32;
var local_5: i32;
var phi_828_: type_23;
var phi_1383_: type_24;
let _e65 = global;
let _e71 = global_1.member.member;
if (_e65.x < _e71.member) {
if (_e65.y < _e71.member_1) {
let _e78 = (_e71.member * _e71.member_1);
let _e80 = ((_e65.y * _e71.member) + _e65.x);
let _e84 = global_1.member.member.member;
let _e88 = global_1.member.member.member_1;
let _e90 = bitcast<i32>((_e84 * _e88));
let _e94 = global_1.member.member_12.member_4;
let _e98 = global_1.member.member_12.member_6;
let _e100 = bitcast<i32>((_e94 * _e98));
let _e103 = bitcast<i32>(((_e65.y * _e84) + _e65.x));
local_3 = _e100;
local_4 = _e103;
local_5 = _e90;
let _e104 = local_3;
let _e105 = local_4;
let _e106 = (_e104 + _e105);
let _e108 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e110 = select(_e108, _e106, (_e106 < _e108));
let _e115 = global_3.member[bitcast<u32>(select(0i, _e110, (_e110 > 0i)))];
let _e116 = local_3;
let _e117 = local_5;
let _e119 = local_4;
let _e120 = ((_e116 + _e117) + _e119);
let _e122 = select(_e108, _e120, (_e120 < _e108));
let _e127 = global_3.member[bitcast<u32>(select(0i, _e122, (_e122 > 0i)))];
let _e128 = local_3;
let _e129 = local_5;
let _e132 = local_4;
let _e133 = ((_e128 + (2i * _e129)) + _e132);
let _e135 = select(_e108, _e133, (_e133 < _e108));
let _e140 = global_3.member[bitcast<u32>(select(0i, _e135, (_e135 > 0i)))];
let _e141 = vec3<f32>(_e115, _e127, _e140);
let _e142 = local_3;
let _e143 = local_5;
let _e146 = local_4;
let _e147 = ((_e142 + (3i * _e143)) + _e146);
let _e149 = select(_e108, _e147, (_e147 < _e108));
let _e154 = global_3.member[bitcast<u32>(select(0i, _e149, (_e149 > 0i)))];
let _e155 = local_3;
let _e156 = local_5;
let _e159 = local_4;
let _e160 = ((_e155 + (4i * _e156)) + _e159);
let _e162 = select(_e108, _e160, (_e160 < _e108));
let _e167 = global_3.member[bitcast<u32>(select(0i, _e162, (_e162 > 0i)))];
let _e168 = local_3;
let _e169 = local_5;
let _e172 = local_4;
let _e173 = ((_e168 + (5i * _e169)) + _e172);
let _e175 = select(_e108, _e173, (_e173 < _e108));
let _e180 = global_3.member[bitcast<u32>(select(0i, _e175, (_e175 > 0i)))];
let _e181 = vec3<f32>(_e154, _e167, _e180);
let _e182 = local_3;
let _e183 = local_5;
let _e186 = local_4;
let _e187 = ((_e182 + (6i * _e183)) + _e186);
let _e189 = select(_e108, _e187, (_e187 < _e108));
let _e194 = global_3.member[bitcast<u32>(select(0i, _e189, (_e189 > 0i)))];
let _e195 = local_3;
let _e196 = local_5;
let _e199 = local_4;
let _e200 = ((_e195 + (7i * _e196)) + _e199);
let _e202 = select(_e108, _e200, (_e200 < _e108));
let _e207 = global_3.member[bitcast<u32>(select(0i, _e202, (_e202 > 0i)))];
let _e208 = local_3;
let _e209 = local_5;
let _e212 = local_4;
let _e213 = ((_e208 + (8i * _e209)) + _e212);
let _e215 = select(_e108, _e213, (_e213 < _e108));
let _e220 = global_3.member[bitcast<u32>(select(0i, _e215, (_e215 > 0i)))];
let _e222 = local_3;
let _e223 = local_5;
let _e226 = local_4;
let _e227 = ((_e222 + (9i * _e223)) + _e226);
let _e229 = select(_e108, _e227, (_e227 < _e108));
let _e234 = global_3.member[bitcast<u32>(select(0i, _e229, (_e229 > 0i)))];
let _e235 = local_3;
let _e236 = local_5;
let _e239 = local_4;
let _e240 = ((_e235 + (10i * _e236)) + _e239);
let _e242 = select(_e108, _e240, (_e240 < _e108));
let _e247 = global_3.member[bitcast<u32>(select(0i, _e242, (_e242 > 0i)))];
let _e248 = local_3;
let _e249 = local_5;
let _e252 = local_4;
let _e253 = ((_e248 + (11i * _e249)) + _e252);
let _e255 = select(_e108, _e253, (_e253 < _e108));
let _e260 = global_3.member[bitcast<u32>(select(0i, _e255, (_e255 > 0i)))];
let _e262 = local_3;
let _e263 = local_5;
let _e266 = local_4;
let _e267 = ((_e262 + (12i * _e263)) + _e266);
let _e269 = select(_e108, _e267, (_e267 < _e108));
let _e274 = global_3.member[bitcast<u32>(select(0i, _e269, (_e269 > 0i)))];
let _e275 = local_3;
let _e276 = local_5;
let _e279 = local_4;
let _e280 = ((_e275 + (13i * _e276)) + _e279);
let _e282 = select(_e108, _e280, (_e280 < _e108));
let _e287 = global_3.member[bitcast<u32>(select(0i, _e282, (_e282 > 0i)))];
let _e288 = local_3;
let _e289 = local_5;
let _e292 = local_4;
let _e293 = ((_e288 + (14i * _e289)) + _e292);
let _e295 = select(_e108, _e293, (_e293 < _e108));
let _e300 = global_3.member[bitcast<u32>(select(0i, _e295, (_e295 > 0i)))];
let _e302 = local_3;
let _e303 = local_5;
let _e306 = local_4;
let _e307 = ((_e302 + (15i * _e303)) + _e306);
let _e309 = select(_e108, _e307, (_e307 < _e108));
let _e314 = global_3.member[bitcast<u32>(select(0i, _e309, (_e309 > 0i)))];
let _e315 = local_3;
let _e316 = local_5;
let _e319 = local_4;
let _e320 = ((_e315 + (16i * _e316)) + _e319);
let _e322 = select(_e108, _e320, (_e320 < _e108));
let _e327 = global_3.member[bitcast<u32>(select(0i, _e322, (_e322 > 0i)))];
let _e328 = local_3;
let _e329 = local_5;
let _e332 = local_4;
let _e333 = ((_e328 + (17i * _e329)) + _e332);
let _e335 = select(_e108, _e333, (_e333 < _e108));
let _e340 = global_3.member[bitcast<u32>(select(0i, _e335, (_e335 > 0i)))];
let _e342 = local_3;
let _e343 = local_5;
let _e346 = local_4;
let _e347 = ((_e342 + (18i * _e343)) + _e346);
let _e349 = select(_e108, _e347, (_e347 < _e108));
let _e354 = global_3.member[bitcast<u32>(select(0i, _e349, (_e349 > 0i)))];
let _e355 = local_3;
let _e356 = local_5;
let _e359 = local_4;
let _e360 = ((_e355 + (19i * _e356)) + _e359);
let _e362 = select(_e108, _e360, (_e360 < _e108));
let _e367 = global_3.member[bitcast<u32>(select(0i, _e362, (_e362 > 0i)))];
let _e368 = local_3;
let _e369 = local_5;
let _e372 = local_4;
let _e373 = ((_e368 + (20i * _e369)) + _e372);
let _e375 = select(_e108, _e373, (_e373 < _e108));
let _e380 = global_3.member[bitcast<u32>(select(0i, _e375, (_e375 > 0i)))];
let _e381 = vec3<f32>(_e354, _e367, _e380);
let _e382 = local_3;
let _e383 = local_5;
let _e386 = local_4;
let _e387 = ((_e382 + (21i * _e383)) + _e386);
let _e389 = select(_e108, _e387, (_e387 < _e108));
let _e394 = global_3.member[bitcast<u32>(select(0i, _e389, (_e389 > 0i)))];
let _e395 = local_3;
let _e396 = local_5;
let _e399 = local_4;
let _e400 = ((_e395 + (22i * _e396)) + _e399);
let _e402 = select(_e108, _e400, (_e400 < _e108));
let _e407 = global_3.member[bitcast<u32>(select(0i, _e402, (_e402 > 0i)))];
let _e408 = local_3;
let _e409 = local_5;
let _e412 = local_4;
let _e413 = ((_e408 + (23i * _e409)) + _e412);
let _e415 = select(_e108, _e413, (_e413 < _e108));
let _e420 = global_3.member[bitcast<u32>(select(0i, _e415, (_e415 > 0i)))];
let _e421 = local_3;
let _e422 = local_5;
let _e425 = local_4;
let _e426 = ((_e421 + (24i * _e422)) + _e425);
let _e428 = select(_e108, _e426, (_e426 < _e108));
let _e433 = global_3.member[bitcast<u32>(select(0i, _e428, (_e428 > 0i)))];
let _e434 = local_3;
let _e435 = local_5;
let _e438 = local_4;
let _e439 = ((_e434 + (25i * _e435)) + _e438);
let _e441 = select(_e108, _e439, (_e439 < _e108));
let _e446 = global_3.member[bitcast<u32>(select(0i, _e441, (_e441 > 0i)))];
let _e453 = select(0i, select(select(i32(_e446), i32(-2147483648), (_e446 < -2147483600f)), 2147483647i, (_e446 > 2147483500f)), (_e446 == _e446));
let _e458 = global_1.member.member_12.member_11;
if (_e458 == 1u) {
phi_828_ = type_23(_e141, _e181, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), _e381, _e394, _e407, _e420, _e433, _e453);
} else {
phi_828_ = type_23(_e141, _e181, vec3<f32>(_e194, _e207, _e220), vec3<f32>(_e234, _e247, _e260), vec3<f32>(_e274, _e287, _e300), vec3<f32>(_e314, _e327, _e340), _e381, _e394, _e407, _e420, _e433, _e453);
}
let _e462 = phi_828_;
let _e466 = global_1.member.member_6;
let _e471 = (_e462.member.x - _e466.member);
let _e473 = (_e462.member.y - _e466.member_1);
let _e475 = (_e462.member.z - _e466.member_2);
let _e481 = ((_e473 * _e462.member_1.z) - (_e475 * _e462.member_1.y));
let _e485 = ((_e475 * _e462.member_1.x) - (_e471 * _e462.member_1.z));
let _e488 = ((_e471 * _e462.member_1.y) - (_e473 * _e462.member_1.x));
let _e491 = global_1.member.member_3;
let _e497 = global_1.member.member_4;
let _e503 = global_1.member.member_5;
let _e510 = global_1.member.member_2.member_3;
let _e511 = (_e510 != 0u);
let _e514 = ((_e503.member_1 * _e491.member_2) - (_e503.member_2 * _e491.member_1));
let _e517 = ((_e503.member_2 * _e491.member) - (_e503.member * _e491.member_2));
let _e520 = ((_e503.member * _e491.member_1) - (_e503.member_1 * _e491.member));
let _e532 = select((((_e491.member * _e481) + (_e491.member_1 * _e485)) + (_e491.member_2 * _e488)), -((((_e514 * _e462.member_1.x) + (_e517 * _e462.member_1.y)) + (_e520 * _e462.member_1.z))), _e511);
let _e535 = ((_e503.member_1 * _e497.member_2) - (_e503.member_2 * _e497.member_1));
let _e538 = ((_e503.member_2 * _e497.member) - (_e503.member * _e497.member_2));
let _e541 = ((_e503.member * _e497.member_1) - (_e503.member_1 * _e497.member));
let _e553 = select((((_e497.member * _e481) + (_e497.member_1 * _e485)) + (_e497.member_2 * _e488)), -((((_e535 * _e462.member_1.x) + (_e538 * _e462.member_1.y)) + (_e541 * _e462.member_1.z))), _e511);
let _e562 = global_1.member.member_1.member;
let _e564 = f32(bitcast<i32>(_e562));
let _e568 = global_1.member.member_1.member_1;
let _e570 = f32(bitcast<i32>(_e568));
let _e574 = global_1.member.member_2.member;
let _e578 = global_1.member.member_2.member_1;
let _e580 = ((2f * _e574) / _e564);
let _e581 = (_e532 * _e580);
let _e583 = ((-2f * _e578) / _e570);
let _e584 = (_e553 * _e583);
let _e586 = ((_e574 / _e564) - _e574);
let _e590 = (_e578 - (_e578 / _e570));
let _e619 = (((_e462.member_2.y * _e462.member_1.z) - (_e462.member_2.z * _e462.member_1.y)) + ((_e473 * _e462.member_4.z) - (_e475 * _e462.member_4.y)));
let _e620 = (((_e462.member_2.z * _e462.member_1.x) - (_e462.member_2.x * _e462.member_1.z)) + ((_e475 * _e462.member_4.x) - (_e471 * _e462.member_4.z)));
let _e621 = (((_e462.member_2.x * _e462.member_1.y) - (_e462.member_2.y * _e462.member_1.x)) + ((_e471 * _e462.member_4.y) - (_e473 * _e462.member_4.x)));
let _e633 = select((((_e491.member * _e619) + (_e491.member_1 * _e620)) + (_e491.member_2 * _e621)), -((((_e514 * _e462.member_4.x) + (_e517 * _e462.member_4.y)) + (_e520 * _e462.member_4.z))), _e511);
let _e645 = select((((_e497.member * _e619) + (_e497.member_1 * _e620)) + (_e497.member_2 * _e621)), -((((_e535 * _e462.member_4.x) + (_e538 * _e462.member_4.y)) + (_e541 * _e462.member_4.z))), _e511);
let _e651 = (_e633 * _e580);
let _e652 = (_e645 * _e583);
let _e656 = (((((_e503.member * _e619) + (_e503.member_1 * _e620)) + (_e503.member_2 * _e621)) + (_e633 * _e586)) + (_e645 * _e590));
let _e683 = (((_e462.member_3.y * _e462.member_1.z) - (_e462.member_3.z * _e462.member_1.y)) + ((_e473 * _e462.member_5.z) - (_e475 * _e462.member_5.y)));
let _e684 = (((_e462.member_3.z * _e462.member_1.x) - (_e462.member_3.x * _e462.member_1.z)) + ((_e475 * _e462.member_5.x) - (_e471 * _e462.member_5.z)));
let _e685 = (((_e462.member_3.x * _e462.member_1.y) - (_e462.member_3.y * _e462.member_1.x)) + ((_e471 * _e462.member_5.y) - (_e473 * _e462.member_5.x)));
let _e697 = select((((_e491.member * _e683) + (_e491.member_1 * _e684)) + (_e491.member_2 * _e685)), -((((_e514 * _e462.member_5.x) + (_e517 * _e462.member_5.y)) + (_e520 * _e462.member_5.z))), _e511);
let _e709 = select((((_e497.member * _e683) + (_e497.member_1 * _e684)) + (_e497.member_2 * _e685)), -((((_e535 * _e462.member_5.x) + (_e538 * _e462.member_5.y)) + (_e541 * _e462.member_5.z))), _e511);
let _e715 = (_e697 * _e580);
let _e716 = (_e709 * _e583);
let _e720 = (((((_e503.member * _e683) + (_e503.member_1 * _e684)) + (_e503.member_2 * _e685)) + (_e697 * _e586)) + (_e709 * _e590));
let _e727 = (bitcast<f32>((bitcast<u32>(_e581) & 2147483647u)) > bitcast<f32>((bitcast<u32>(_e584) & 2147483647u)));
let _e728 = select(_e581, _e584, _e727);
let _e729 = select(_e584, _e581, _e727);
let _e730 = select(_e651, _e652, _e727);
let _e731 = select(_e652, _e651, _e727);
let _e732 = select(_e715, _e716, _e727);
let _e733 = select(_e716, _e715, _e727);
let _e736 = bitcast<f32>((bitcast<u32>(_e729) & 2147483647u));
let _e742 = ((((_e503.member * _e471) + (_e503.member_1 * _e473)) + (_e503.member_2 * _e475)) - 1e-3f);
let _e747 = (((_e503.member * _e462.member_1.x) + (_e503.member_1 * _e462.member_1.y)) + (_e503.member_2 * _e462.member_1.z));
if (_e510 == 0u) {
let _e750 = (_e747 == 0f);
let _e752 = (-(_e742) / select(_e747, 1e-30f, _e750));
phi_1383_ = type_24(select(0f, select(0f, _e752, (_e752 > 0f)), (_e747 > 0f)), select(select(_e462.member_9, select(_e462.member_9, _e752, (_e752 < _e462.member_9)), (_e747 < 0f)), -1f, (_e750 && (_e742 < 0f))));
} else {
phi_1383_ = type_24(0f, _e462.member_9);
}
let _e769 = phi_1383_;
let _e778 = ((_e462.member.x + (_e462.member_1.x * _e769.member)) - _e466.member);
let _e779 = ((_e462.member.y + (_e462.member_1.y * _e769.member)) - _e466.member_1);
let _e780 = ((_e462.member.z + (_e462.member_1.z * _e769.member)) - _e466.member_2);
let _e785 = (((_e503.member * _e778) + (_e503.member_1 * _e779)) + (_e503.member_2 * _e780));
let _e789 = select((1f / select(1e-3f, _e785, (_e785 > 1e-3f))), 1f, _e511);
let _e798 = (0.5f * _e564);
let _e800 = ((((((((_e491.member * _e778) + (_e491.member_1 * _e779)) + (_e491.member_2 * _e780)) * _e789) / _e574) + 1f) * _e798) - 0.5f);
let _e809 = (0.5f * _e570);
let _e811 = (((1f - (((((_e497.member * _e778) + (_e497.member_1 * _e779)) + (_e497.member_2 * _e780)) * _e789) / _e578)) * _e809) - 0.5f);
let _e812 = -(1e6f);
let _e814 = select(_e812, _e800, (_e800 > _e812));
let _e816 = select(1e6f, _e814, (_e814 < 1e6f));
let _e818 = select(_e812, _e811, (_e811 > _e812));
let _e820 = select(1e6f, _e818, (_e818 < 1e6f));
let _e821 = select(_e816, _e820, _e727);
let _e822 = select(_e820, _e816, _e727);
let _e840 = (bitcast<f32>((bitcast<u32>(_e728) & 2147483647u)) / _e736);
let _e844 = (0.5f * 1f);
let _e847 = ((2f * (((0.5f * (bitcast<f32>((bitcast<u32>(((_e730 * _e821) + ((_e731 * _e822) + _e656))) & 2147483647u)) + bitcast<f32>((bitcast<u32>(((_e732 * _e821) + ((_e733 * _e822) + _e720))) & 2147483647u)))) / _e736) + _e844)) * _e840);
let _e850 = (select(1e6f, _e847, (_e847 < 1e6f)) + 1f);
let _e857 = ((_e462.member.x + (_e462.member_1.x * _e769.member_1)) - _e466.member);
let _e858 = ((_e462.member.y + (_e462.member_1.y * _e769.member_1)) - _e466.member_1);
let _e859 = ((_e462.member.z + (_e462.member_1.z * _e769.member_1)) - _e466.member_2);
let _e864 = (((_e503.member * _e857) + (_e503.member_1 * _e858)) + (_e503.member_2 * _e859));
let _e868 = select((1f / select(1e-3f, _e864, (_e864 > 1e-3f))), 1f, _e511);
let _e878 = ((((((((_e491.member * _e857) + (_e491.member_1 * _e858)) + (_e491.member_2 * _e859)) * _e868) / _e574) + 1f) * _e798) - 0.5f);
let _e888 = (((1f - (((((_e497.member * _e857) + (_e497.member_1 * _e858)) + (_e497.member_2 * _e859)) * _e868) / _e578)) * _e809) - 0.5f);
let _e890 = select(_e812, _e878, (_e878 > _e812));
let _e892 = select(1e6f, _e890, (_e890 < 1e6f));
let _e894 = select(_e812, _e888, (_e888 > _e812));
let _e896 = select(1e6f, _e894, (_e894 < 1e6f));
let _e897 = select(_e892, _e896, _e727);
let _e898 = select(_e896, _e892, _e727);
let _e918 = ((2f * (((0.5f * (bitcast<f32>((bitcast<u32>(((_e730 * _e897) + ((_e731 * _e898) + _e656))) & 2147483647u)) + bitcast<f32>((bitcast<u32>(((_e732 * _e897) + ((_e733 * _e898) + _e720))) & 2147483647u)))) / _e736) + _e844)) * _e840);
let _e921 = (select(1e6f, _e918, (_e918 < 1e6f)) + 1f);
let _e922 = (_e897 < _e821);
let _e923 = (_e821 - _e850);
let _e924 = (_e897 - _e921);
let _e927 = (_e821 + _e850);
let _e928 = (_e897 + _e921);
local = _e100;
local_1 = _e103;
local_2 = _e90;
let _e931 = local;
let _e932 = local_2;
let _e935 = local_1;
let _e936 = ((_e931 + (18i * _e932)) + _e935);
let _e938 = select(_e108, _e936, (_e936 < _e108));
let _e943 = global_3.member[bitcast<u32>(select(0i, _e938, (_e938 > 0i)))];
let _e944 = local;
let _e945 = local_2;
let _e948 = local_1;
let _e949 = ((_e944 + (19i * _e945)) + _e948);
let _e951 = select(_e108, _e949, (_e949 < _e108));
let _e956 = global_3.member[bitcast<u32>(select(0i, _e951, (_e951 > 0i)))];
let _e958 = local;
let _e959 = local_2;
let _e962 = local_1;
let _e963 = ((_e958 + (20i * _e959)) + _e962);
let _e965 = select(_e108, _e963, (_e963 < _e108));
let _e970 = global_3.member[bitcast<u32>(select(0i, _e965, (_e965 > 0i)))];
let _e976 = (((((_e943 + _e956) + _e970) > 0f) && (_e736 > 0f)) && (_e769.member_1 > _e769.member));
global_2.member[_e80] = select(0f, 1f, (_e976 && _e727));
global_2.member[(_e78 + _e80)] = select(0f, _e728, _e976);
global_2.member[((2u * _e78) + _e80)] = select(0f, _e729, _e976);
global_2.member[((3u * _e78) + _e80)] = select(0f, (((((_e503.member * _e481) + (_e503.member_1 * _e485)) + (_e503.member_2 * _e488)) + (_e532 * _e586)) + (_e553 * _e590)), _e976);
global_2.member[((4u * _e78) + _e80)] = select(0f, _e730, _e976);
global_2.member[((5u * _e78) + _e80)] = select(0f, _e731, _e976);
global_2.member[((6u * _e78) + _e80)] = select(0f, _e656, _e976);
global_2.member[((7u * _e78) + _e80)] = select(0f, _e732, _e976);
global_2.member[((8u * _e78) + _e80)] = select(0f, _e733, _e976);
global_2.member[((9u * _e78) + _e80)] = select(0f, _e720, _e976);
global_2.member[((10u * _e78) + _e80)] = select(0f, select(_e924, _e923, (_e923 < _e924)), _e976);
global_2.member[((11u * _e78) + _e80)] = select(-1f, select(_e928, _e927, (_e927 > _e928)), _e976);
global_2.member[((12u * _e78) + _e80)] = select(0f, select(_e927, _e928, _e922), _e976);
global_2.member[((13u * _e78) + _e80)] = select(0f, select(_e924, _e923, _e922), _e976);
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
