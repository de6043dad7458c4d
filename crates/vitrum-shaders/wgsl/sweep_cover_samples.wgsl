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
member_2: type_5,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
}
struct type_11 {
member: u32,
member_1: u32,
}
struct type_12 {
member: type_11,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
}
struct type_13 {
member: type_5,
member_1: f32,
member_2: f32,
}
struct type_14 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: u32,
member_4: type_11,
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
member_17: type_11,
member_18: type_12,
member_19: type_5,
member_20: type_13,
member_21: f32,
member_22: f32,
member_23: f32,
member_24: f32,
}
struct type_16 {
member: array<f32>,
}
struct type_19 {
member: array<u32>,
}
struct type_20 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_21 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_22 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: type_5,
member_4: type_5,
member_5: type_5,
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
struct type_23 {
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
struct type_24 {
member: type_5,
member_1: type_5,
}
struct type_25 {
member: type_7,
member_1: u32,
}
struct type_26 {
member: type_2,
member_1: u32,
member_2: type_20,
member_3: type_11,
member_4: type_11,
member_5: u32,
member_6: u32,
member_7: type_21,
member_8: type_22,
member_9: type_22,
member_10: type_23,
member_11: type_24,
member_12: type_14,
member_13: type_21,
member_14: type_4,
member_15: type_9,
member_16: type_25,
member_17: type_25,
member_18: type_25,
member_19: type_25,
member_20: type_10,
member_21: f32,
member_22: f32,
member_23: type_6,
}
struct type_27 {
member: type_26,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_27;
@group(0) @binding(3)
var<storage, read_write> global_2: type_16;
@group(0) @binding(1)
var<storage> global_3: type_16;
@group(0) @binding(2)
var<storage> global_4: type_19;
fn function_() {
var local: i32;
var local_1: i32;
var local_2: i32;
var local_3: i32;
var local_4: i32;
var local_5: i32;
var local_6: i32;
var local_7: i32;
var phi_1247_: i32;
var phi_1291_: i32;
var phi_1336_: i32;
var phi_1380_: i32;
var phi_1425_: i32;
var phi_1469_: i32;
var phi_1514_: i32;
var phi_1558_: i32;
let _e51 = global;
let _e59 = global_1.member.member_2;
let _e62 = global_1.member.member;
let _e70 = (_e51.x + _e59.member);
let _e72 = (_e51.y + _e59.member_1);
if (_e70 < _e59.member_2) {
if (_e72 < _e59.member_3) {
let _e75 = (_e62.member * _e62.member_1);
let _e77 = ((_e72 * _e62.member) + _e70);
let _e82 = global_1.member.member_12.member_4.member;
let _e83 = (_e82 + 1u);
let _e88 = global_1.member.member_12.member_4.member_1;
let _e91 = bitcast<i32>((_e83 * (_e88 + 1u)));
local_6 = _e91;
let _e92 = (_e72 * _e83);
local_7 = bitcast<i32>((_e92 + _e70));
let _e95 = local_7;
let _e97 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e99 = select(_e97, _e95, (_e95 < _e97));
let _e104 = global_3.member[bitcast<u32>(select(0i, _e99, (_e99 > 0i)))];
let _e105 = local_6;
let _e106 = local_7;
let _e107 = (_e105 + _e106);
let _e109 = select(_e97, _e107, (_e107 < _e97));
let _e114 = global_3.member[bitcast<u32>(select(0i, _e109, (_e109 > 0i)))];
let _e115 = local_6;
let _e117 = local_7;
let _e118 = ((2i * _e115) + _e117);
let _e120 = select(_e97, _e118, (_e118 < _e97));
let _e125 = global_3.member[bitcast<u32>(select(0i, _e120, (_e120 > 0i)))];
let _e126 = local_6;
let _e128 = local_7;
let _e129 = ((3i * _e126) + _e128);
let _e131 = select(_e97, _e129, (_e129 < _e97));
let _e136 = global_3.member[bitcast<u32>(select(0i, _e131, (_e131 > 0i)))];
let _e137 = local_6;
let _e139 = local_7;
let _e140 = ((4i * _e137) + _e139);
let _e142 = select(_e97, _e140, (_e140 < _e97));
let _e147 = global_3.member[bitcast<u32>(select(0i, _e142, (_e142 > 0i)))];
let _e148 = local_6;
let _e150 = local_7;
let _e151 = ((5i * _e148) + _e150);
let _e153 = select(_e97, _e151, (_e151 < _e97));
let _e158 = global_3.member[bitcast<u32>(select(0i, _e153, (_e153 > 0i)))];
let _e159 = local_6;
let _e161 = local_7;
let _e162 = ((6i * _e159) + _e161);
let _e164 = select(_e97, _e162, (_e162 < _e97));
let _e169 = global_3.member[bitcast<u32>(select(0i, _e164, (_e164 > 0i)))];
let _e170 = local_6;
let _e172 = local_7;
let _e173 = ((7i * _e170) + _e172);
let _e175 = select(_e97, _e173, (_e173 < _e97));
let _e180 = global_3.member[bitcast<u32>(select(0i, _e175, (_e175 > 0i)))];
let _e181 = (_e70 + 1u);
local_4 = _e91;
local_5 = bitcast<i32>((_e92 + _e181));
let _e184 = local_5;
let _e186 = select(_e97, _e184, (_e184 < _e97));
let _e191 = global_3.member[bitcast<u32>(select(0i, _e186, (_e186 > 0i)))];
let _e192 = local_4;
let _e193 = local_5;
let _e194 = (_e192 + _e193);
let _e196 = select(_e97, _e194, (_e194 < _e97));
let _e201 = global_3.member[bitcast<u32>(select(0i, _e196, (_e196 > 0i)))];
let _e202 = local_4;
let _e204 = local_5;
let _e205 = ((2i * _e202) + _e204);
let _e207 = select(_e97, _e205, (_e205 < _e97));
let _e212 = global_3.member[bitcast<u32>(select(0i, _e207, (_e207 > 0i)))];
let _e213 = local_4;
let _e215 = local_5;
let _e216 = ((3i * _e213) + _e215);
let _e218 = select(_e97, _e216, (_e216 < _e97));
let _e223 = global_3.member[bitcast<u32>(select(0i, _e218, (_e218 > 0i)))];
let _e224 = local_4;
let _e226 = local_5;
let _e227 = ((4i * _e224) + _e226);
let _e229 = select(_e97, _e227, (_e227 < _e97));
let _e234 = global_3.member[bitcast<u32>(select(0i, _e229, (_e229 > 0i)))];
let _e235 = local_4;
let _e237 = local_5;
let _e238 = ((5i * _e235) + _e237);
let _e240 = select(_e97, _e238, (_e238 < _e97));
let _e245 = global_3.member[bitcast<u32>(select(0i, _e240, (_e240 > 0i)))];
let _e246 = local_4;
let _e248 = local_5;
let _e249 = ((6i * _e246) + _e248);
let _e251 = select(_e97, _e249, (_e249 < _e97));
let _e256 = global_3.member[bitcast<u32>(select(0i, _e251, (_e251 > 0i)))];
let _e257 = local_4;
let _e259 = local_5;
let _e260 = ((7i * _e257) + _e259);
let _e262 = select(_e97, _e260, (_e260 < _e97));
let _e267 = global_3.member[bitcast<u32>(select(0i, _e262, (_e262 > 0i)))];
local_2 = _e91;
let _e269 = ((_e72 + 1u) * _e83);
local_3 = bitcast<i32>((_e269 + _e70));
let _e272 = local_3;
let _e274 = select(_e97, _e272, (_e272 < _e97));
let _e279 = global_3.member[bitcast<u32>(select(0i, _e274, (_e274 > 0i)))];
let _e280 = local_2;
let _e281 = local_3;
let _e282 = (_e280 + _e281);
let _e284 = select(_e97, _e282, (_e282 < _e97));
let _e289 = global_3.member[bitcast<u32>(select(0i, _e284, (_e284 > 0i)))];
let _e290 = local_2;
let _e292 = local_3;
let _e293 = ((2i * _e290) + _e292);
let _e295 = select(_e97, _e293, (_e293 < _e97));
let _e300 = global_3.member[bitcast<u32>(select(0i, _e295, (_e295 > 0i)))];
let _e301 = local_2;
let _e303 = local_3;
let _e304 = ((3i * _e301) + _e303);
let _e306 = select(_e97, _e304, (_e304 < _e97));
let _e311 = global_3.member[bitcast<u32>(select(0i, _e306, (_e306 > 0i)))];
let _e312 = local_2;
let _e314 = local_3;
let _e315 = ((4i * _e312) + _e314);
let _e317 = select(_e97, _e315, (_e315 < _e97));
let _e322 = global_3.member[bitcast<u32>(select(0i, _e317, (_e317 > 0i)))];
let _e323 = local_2;
let _e325 = local_3;
let _e326 = ((5i * _e323) + _e325);
let _e328 = select(_e97, _e326, (_e326 < _e97));
let _e333 = global_3.member[bitcast<u32>(select(0i, _e328, (_e328 > 0i)))];
let _e334 = local_2;
let _e336 = local_3;
let _e337 = ((6i * _e334) + _e336);
let _e339 = select(_e97, _e337, (_e337 < _e97));
let _e344 = global_3.member[bitcast<u32>(select(0i, _e339, (_e339 > 0i)))];
let _e345 = local_2;
let _e347 = local_3;
let _e348 = ((7i * _e345) + _e347);
let _e350 = select(_e97, _e348, (_e348 < _e97));
let _e355 = global_3.member[bitcast<u32>(select(0i, _e350, (_e350 > 0i)))];
local = _e91;
local_1 = bitcast<i32>((_e269 + _e181));
let _e358 = local_1;
let _e360 = select(_e97, _e358, (_e358 < _e97));
let _e365 = global_3.member[bitcast<u32>(select(0i, _e360, (_e360 > 0i)))];
let _e366 = local;
let _e367 = local_1;
let _e368 = (_e366 + _e367);
let _e370 = select(_e97, _e368, (_e368 < _e97));
let _e375 = global_3.member[bitcast<u32>(select(0i, _e370, (_e370 > 0i)))];
let _e376 = local;
let _e378 = local_1;
let _e379 = ((2i * _e376) + _e378);
let _e381 = select(_e97, _e379, (_e379 < _e97));
let _e386 = global_3.member[bitcast<u32>(select(0i, _e381, (_e381 > 0i)))];
let _e387 = local;
let _e389 = local_1;
let _e390 = ((3i * _e387) + _e389);
let _e392 = select(_e97, _e390, (_e390 < _e97));
let _e397 = global_3.member[bitcast<u32>(select(0i, _e392, (_e392 > 0i)))];
let _e398 = local;
let _e400 = local_1;
let _e401 = ((4i * _e398) + _e400);
let _e403 = select(_e97, _e401, (_e401 < _e97));
let _e408 = global_3.member[bitcast<u32>(select(0i, _e403, (_e403 > 0i)))];
let _e409 = local;
let _e411 = local_1;
let _e412 = ((5i * _e409) + _e411);
let _e414 = select(_e97, _e412, (_e412 < _e97));
let _e419 = global_3.member[bitcast<u32>(select(0i, _e414, (_e414 > 0i)))];
let _e420 = local;
let _e422 = local_1;
let _e423 = ((6i * _e420) + _e422);
let _e425 = select(_e97, _e423, (_e423 < _e97));
let _e430 = global_3.member[bitcast<u32>(select(0i, _e425, (_e425 > 0i)))];
let _e431 = local;
let _e433 = local_1;
let _e434 = ((7i * _e431) + _e433);
let _e436 = select(_e97, _e434, (_e434 < _e97));
let _e441 = global_3.member[bitcast<u32>(select(0i, _e436, (_e436 > 0i)))];
let _e443 = select(_e191, _e104, (_e104 < _e191));
let _e445 = select(_e365, _e279, (_e279 < _e365));
let _e447 = select(_e445, _e443, (_e443 < _e445));
let _e449 = select(_e201, _e114, (_e114 < _e201));
let _e451 = select(_e375, _e289, (_e289 < _e375));
let _e453 = select(_e451, _e449, (_e449 < _e451));
let _e455 = select(_e191, _e104, (_e104 > _e191));
let _e457 = select(_e365, _e279, (_e279 > _e365));
let _e459 = select(_e457, _e455, (_e455 > _e457));
let _e461 = select(_e201, _e114, (_e114 > _e201));
let _e463 = select(_e375, _e289, (_e289 > _e375));
let _e465 = select(_e463, _e461, (_e461 > _e463));
let _e475 = (((_e125 + _e212) + (_e300 + _e386)) * 0.25f);
let _e476 = (((_e136 + _e223) + (_e311 + _e397)) * 0.25f);
let _e477 = (((_e147 + _e234) + (_e322 + _e408)) * 0.25f);
let _e479 = select(_e476, _e475, (_e475 > _e476));
let _e484 = -(65536f);
let _e486 = select(_e484, _e447, (_e447 > _e484));
let _e488 = select(65536f, _e486, (_e486 < 65536f));
let _e495 = select(0i, select(select(i32(_e488), i32(-2147483648), (_e488 < -2147483600f)), 2147483647i, (_e488 > 2147483500f)), (_e488 == _e488));
let _e499 = (_e495 - select(0i, 1i, (_e488 < f32(_e495))));
let _e501 = select(_e484, _e459, (_e459 > _e484));
let _e503 = select(65536f, _e501, (_e501 < 65536f));
let _e510 = select(0i, select(select(i32(_e503), i32(-2147483648), (_e503 < -2147483600f)), 2147483647i, (_e503 > 2147483500f)), (_e503 == _e503));
let _e514 = (_e510 - select(0i, 1i, (_e503 < f32(_e510))));
let _e515 = (_e514 + 1i);
let _e517 = select(_e484, _e453, (_e453 > _e484));
let _e519 = select(65536f, _e517, (_e517 < 65536f));
let _e526 = select(0i, select(select(i32(_e519), i32(-2147483648), (_e519 < -2147483600f)), 2147483647i, (_e519 > 2147483500f)), (_e519 == _e519));
let _e530 = (_e526 - select(0i, 1i, (_e519 < f32(_e526))));
let _e532 = select(_e484, _e465, (_e465 > _e484));
let _e534 = select(65536f, _e532, (_e532 < 65536f));
let _e541 = select(0i, select(select(i32(_e534), i32(-2147483648), (_e534 < -2147483600f)), 2147483647i, (_e534 > 2147483500f)), (_e534 == _e534));
let _e545 = (_e541 - select(0i, 1i, (_e534 < f32(_e541))));
let _e546 = (_e545 + 1i);
let _e556 = global_1.member.member_12.member_15;
let _e557 = bitcast<i32>(_e556);
let _e559 = (firstTrailingBit(8u) & 31u);
let _e561 = (_e499 >> bitcast<u32>(_e559));
let _e563 = (_e530 >> bitcast<u32>(_e559));
let _e568 = global_1.member.member_12.member_14.member;
let _e569 = bitcast<i32>(_e568);
let _e574 = global_1.member.member_12.member_14.member_1;
let _e575 = bitcast<i32>(_e574);
let _e580 = global_1.member.member_12.member_14.member_2;
let _e584 = ((_e561 >= 0i) && (_e561 < _e569));
let _e585 = (_e563 >= 0i);
let _e587 = (_e563 < _e575);
let _e589 = (_e557 >= 0i);
let _e591 = (_e557 < bitcast<i32>(_e580));
if ((((_e584 && _e585) && _e587) && _e589) && _e591) {
phi_1247_ = (((((_e557 * _e575) + _e563) * _e569) + _e561) * 3i);
} else {
phi_1247_ = -1i;
}
let _e599 = phi_1247_;
let _e600 = (_e599 + 2i);
let _e602 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e604 = select(_e602, _e600, (_e600 < _e602));
let _e610 = global_4.member[bitcast<u32>(select(0i, _e604, (_e604 > 0i)))];
let _e611 = bitcast<i32>(_e610);
let _e615 = ((_e530 & 7i) * 8i);
let _e617 = (_e499 & 7i);
if ((_e599 < 0i) || (_e611 == 0i)) {
phi_1291_ = -1i;
} else {
let _e626 = global_1.member.member_12.member_17.member;
let _e631 = global_1.member.member_12.member_17.member_1;
phi_1291_ = (bitcast<i32>((_e626 * _e631)) + ((((_e611 - 1i) * 64i) + _e615) + _e617));
}
let _e636 = phi_1291_;
let _e640 = (_e515 >> bitcast<u32>(_e559));
let _e643 = ((_e640 >= 0i) && (_e640 < _e569));
if ((((_e643 && _e585) && _e587) && _e589) && _e591) {
phi_1336_ = (((((_e557 * _e575) + _e563) * _e569) + _e640) * 3i);
} else {
phi_1336_ = -1i;
}
let _e654 = phi_1336_;
let _e655 = (_e654 + 2i);
let _e657 = select(_e602, _e655, (_e655 < _e602));
let _e663 = global_4.member[bitcast<u32>(select(0i, _e657, (_e657 > 0i)))];
let _e664 = bitcast<i32>(_e663);
let _e668 = (_e515 & 7i);
if ((_e654 < 0i) || (_e664 == 0i)) {
phi_1380_ = -1i;
} else {
let _e677 = global_1.member.member_12.member_17.member;
let _e682 = global_1.member.member_12.member_17.member_1;
phi_1380_ = (bitcast<i32>((_e677 * _e682)) + ((((_e664 - 1i) * 64i) + _e615) + _e668));
}
let _e687 = phi_1380_;
let _e691 = (_e546 >> bitcast<u32>(_e559));
let _e692 = (_e691 >= 0i);
let _e694 = (_e691 < _e575);
if ((((_e584 && _e692) && _e694) && _e589) && _e591) {
phi_1425_ = (((((_e557 * _e575) + _e691) * _e569) + _e561) * 3i);
} else {
phi_1425_ = -1i;
}
let _e704 = phi_1425_;
let _e705 = (_e704 + 2i);
let _e707 = select(_e602, _e705, (_e705 < _e602));
let _e713 = global_4.member[bitcast<u32>(select(0i, _e707, (_e707 > 0i)))];
let _e714 = bitcast<i32>(_e713);
let _e718 = ((_e546 & 7i) * 8i);
if ((_e704 < 0i) || (_e714 == 0i)) {
phi_1469_ = -1i;
} else {
let _e728 = global_1.member.member_12.member_17.member;
let _e733 = global_1.member.member_12.member_17.member_1;
phi_1469_ = (bitcast<i32>((_e728 * _e733)) + ((((_e714 - 1i) * 64i) + _e718) + _e617));
}
let _e738 = phi_1469_;
if ((((_e643 && _e692) && _e694) && _e589) && _e591) {
phi_1514_ = (((((_e557 * _e575) + _e691) * _e569) + _e640) * 3i);
} else {
phi_1514_ = -1i;
}
let _e751 = phi_1514_;
let _e752 = (_e751 + 2i);
let _e754 = select(_e602, _e752, (_e752 < _e602));
let _e760 = global_4.member[bitcast<u32>(select(0i, _e754, (_e754 > 0i)))];
let _e761 = bitcast<i32>(_e760);
if ((_e751 < 0i) || (_e761 == 0i)) {
phi_1558_ = -1i;
} else {
let _e773 = global_1.member.member_12.member_17.member;
let _e778 = global_1.member.member_12.member_17.member_1;
phi_1558_ = (bitcast<i32>((_e773 * _e778)) + ((((_e761 - 1i) * 64i) + _e718) + _e668));
}
let _e783 = phi_1558_;
let _e786 = (!((select(_e477, _e479, (_e479 > _e477)) <= 0f)) && ((((!((((_e515 - _e499) <= 8i) && ((_e546 - _e530) <= 8i))) || (_e636 >= 0i)) || (_e687 >= 0i)) || (_e738 >= 0i)) || (_e783 >= 0i)));
let _e787 = select(0f, _e475, _e786);
let _e788 = select(0f, _e476, _e786);
let _e789 = select(0f, _e477, _e786);
let _e792 = (1f / 3f);
let _e793 = (((_e125 + _e136) + _e147) * _e792);
let _e798 = (((_e212 + _e223) + _e234) * _e792);
let _e805 = (((_e300 + _e311) + _e322) * _e792);
let _e810 = (((_e386 + _e397) + _e408) * _e792);
let _e819 = select(0f, ((((_e158 * _e793) + (_e245 * _e798)) + ((_e333 * _e805) + (_e419 * _e810))) * 0.25f), _e786);
let _e820 = select(0f, ((((_e169 * _e793) + (_e256 * _e798)) + ((_e344 * _e805) + (_e430 * _e810))) * 0.25f), _e786);
let _e824 = (((_e180 + _e267) + (_e355 + _e441)) == 0f);
let _e825 = (_e365 - _e104);
let _e826 = (_e375 - _e114);
let _e827 = (_e279 - _e191);
let _e828 = (_e289 - _e201);
let _e835 = (0.5f * bitcast<f32>((bitcast<u32>(((_e825 * _e828) - (_e826 * _e827))) & 2147483647u)));
let _e836 = select(_e835, 1f, _e824);
let _e839 = (f32(bitcast<i32>(_e70)) - 0.5f);
let _e842 = (f32(bitcast<i32>(_e72)) - 0.5f);
let _e856 = (_e839 + 1f);
let _e871 = (_e842 + 1f);
let _e902 = (_e824 || (((((((bitcast<f32>((bitcast<u32>((_e104 - _e839)) & 2147483647u)) < 0.5f) && (bitcast<f32>((bitcast<u32>((_e114 - _e842)) & 2147483647u)) < 0.5f)) && (_e180 != 2f)) && (((bitcast<f32>((bitcast<u32>((_e191 - _e856)) & 2147483647u)) < 0.5f) && (bitcast<f32>((bitcast<u32>((_e201 - _e842)) & 2147483647u)) < 0.5f)) && (_e267 != 2f))) && (((bitcast<f32>((bitcast<u32>((_e279 - _e839)) & 2147483647u)) < 0.5f) && (bitcast<f32>((bitcast<u32>((_e289 - _e871)) & 2147483647u)) < 0.5f)) && (_e355 != 2f))) && (((bitcast<f32>((bitcast<u32>((_e365 - _e856)) & 2147483647u)) < 0.5f) && (bitcast<f32>((bitcast<u32>((_e375 - _e871)) & 2147483647u)) < 0.5f)) && (_e441 != 2f))) && (_e835 >= 0.5f)));
let _e905 = (1f / select(0.5f, _e836, (_e836 > 0.5f)));
let _e915 = (_e499 + 2i);
let _e917 = (_e530 + 2i);
let _e920 = (_e104 - _e279);
let _e923 = (_e114 - _e289);
let _e926 = ((_e920 * (_e201 - _e289)) - (_e923 * (_e191 - _e279)));
let _e927 = (_e191 - _e104);
let _e929 = (_e201 - _e114);
let _e931 = ((_e927 * _e826) - (_e929 * _e825));
let _e932 = (_e365 - _e191);
let _e934 = (_e375 - _e201);
let _e936 = ((_e932 * _e828) - (_e934 * _e827));
let _e937 = (_e279 - _e365);
let _e940 = (_e289 - _e375);
let _e943 = ((_e937 * (_e114 - _e375)) - (_e940 * (_e104 - _e365)));
let _e971 = f32((_e499 + 1i));
let _e972 = f32(_e915);
let _e973 = f32((_e530 + 1i));
let _e975 = (_e927 / _e929);
let _e977 = (_e104 + ((_e973 - _e114) * _e975));
let _e978 = (_e114 <= _e973);
let _e979 = (_e201 <= _e973);
let _e980 = (_e978 != _e979);
let _e983 = select(65536f, select(_e977, 65536f, (65536f < _e977)), _e980);
let _e986 = select(_e484, select(_e977, _e484, (_e484 > _e977)), _e980);
let _e988 = (_e932 / _e934);
let _e990 = (_e191 + ((_e973 - _e201) * _e988));
let _e991 = (_e375 <= _e973);
let _e992 = (_e979 != _e991);
let _e995 = select(_e983, select(_e990, _e983, (_e983 < _e990)), _e992);
let _e998 = select(_e986, select(_e990, _e986, (_e986 > _e990)), _e992);
let _e1000 = (_e937 / _e940);
let _e1002 = (_e365 + ((_e973 - _e375) * _e1000));
let _e1003 = (_e289 <= _e973);
let _e1004 = (_e991 != _e1003);
let _e1007 = select(_e995, select(_e1002, _e995, (_e995 < _e1002)), _e1004);
let _e1010 = select(_e998, select(_e1002, _e998, (_e998 > _e1002)), _e1004);
let _e1012 = (_e920 / _e923);
let _e1014 = (_e279 + ((_e973 - _e289) * _e1012));
let _e1015 = (_e1003 != _e978);
let _e1018 = select(_e1007, select(_e1014, _e1007, (_e1007 < _e1014)), _e1015);
let _e1021 = select(_e1010, select(_e1014, _e1010, (_e1010 > _e1014)), _e1015);
let _e1022 = f32(_e917);
let _e1025 = (_e104 + ((_e1022 - _e114) * _e975));
let _e1026 = (_e114 <= _e1022);
let _e1027 = (_e201 <= _e1022);
let _e1028 = (_e1026 != _e1027);
let _e1031 = select(65536f, select(_e1025, 65536f, (65536f < _e1025)), _e1028);
let _e1034 = select(_e484, select(_e1025, _e484, (_e484 > _e1025)), _e1028);
let _e1037 = (_e191 + ((_e1022 - _e201) * _e988));
let _e1038 = (_e375 <= _e1022);
let _e1039 = (_e1027 != _e1038);
let _e1042 = select(_e1031, select(_e1037, _e1031, (_e1031 < _e1037)), _e1039);
let _e1045 = select(_e1034, select(_e1037, _e1034, (_e1034 > _e1037)), _e1039);
let _e1048 = (_e365 + ((_e1022 - _e375) * _e1000));
let _e1049 = (_e289 <= _e1022);
let _e1050 = (_e1038 != _e1049);
let _e1053 = select(_e1042, select(_e1048, _e1042, (_e1042 < _e1048)), _e1050);
let _e1056 = select(_e1045, select(_e1048, _e1045, (_e1045 > _e1048)), _e1050);
let _e1059 = (_e279 + ((_e1022 - _e289) * _e1012));
let _e1060 = (_e1049 != _e1026);
let _e1063 = select(_e1053, select(_e1059, _e1053, (_e1053 < _e1059)), _e1060);
let _e1066 = select(_e1056, select(_e1059, _e1056, (_e1056 > _e1059)), _e1060);
let _e1089 = global_1.member.member_12.member_22;
let _e1090 = (_e1089 * _e905);
let _e1092 = (_e786 && !(_e902));
let _e1098 = ((_e787 * _e1090) + 0.5f);
let _e1100 = select(-1073741800f, _e1098, (_e1098 > -1073741800f));
let _e1102 = select(1073741800f, _e1100, (_e1100 < 1073741800f));
let _e1109 = select(0i, select(select(i32(_e1102), i32(-2147483648), (_e1102 < -2147483600f)), 2147483647i, (_e1102 > 2147483500f)), (_e1102 == _e1102));
let _e1117 = ((_e788 * _e1090) + 0.5f);
let _e1119 = select(-1073741800f, _e1117, (_e1117 > -1073741800f));
let _e1121 = select(1073741800f, _e1119, (_e1119 < 1073741800f));
let _e1128 = select(0i, select(select(i32(_e1121), i32(-2147483648), (_e1121 < -2147483600f)), 2147483647i, (_e1121 > 2147483500f)), (_e1121 == _e1121));
let _e1136 = ((_e789 * _e1090) + 0.5f);
let _e1138 = select(-1073741800f, _e1136, (_e1136 > -1073741800f));
let _e1140 = select(1073741800f, _e1138, (_e1138 < 1073741800f));
let _e1147 = select(0i, select(select(i32(_e1140), i32(-2147483648), (_e1140 < -2147483600f)), 2147483647i, (_e1140 > 2147483500f)), (_e1140 == _e1140));
let _e1155 = ((_e819 * _e1090) + 0.5f);
let _e1157 = select(-1073741800f, _e1155, (_e1155 > -1073741800f));
let _e1159 = select(1073741800f, _e1157, (_e1157 < 1073741800f));
let _e1166 = select(0i, select(select(i32(_e1159), i32(-2147483648), (_e1159 < -2147483600f)), 2147483647i, (_e1159 > 2147483500f)), (_e1159 == _e1159));
let _e1174 = ((_e820 * _e1090) + 0.5f);
let _e1176 = select(-1073741800f, _e1174, (_e1174 > -1073741800f));
let _e1178 = select(1073741800f, _e1176, (_e1176 < 1073741800f));
let _e1185 = select(0i, select(select(i32(_e1178), i32(-2147483648), (_e1178 < -2147483600f)), 2147483647i, (_e1178 > 2147483500f)), (_e1178 == _e1178));
global_2.member[_e77] = select(select(0f, 32f, (_e786 && _e902)), select(16f, ((select(0f, 1f, ((_e1018 <= _e971) && (_e971 < _e1021))) + select(0f, 2f, ((_e1018 <= _e972) && (_e972 < _e1021)))) + (select(0f, 4f, ((_e1063 <= _e971) && (_e971 < _e1066))) + select(0f, 8f, ((_e1063 <= _e972) && (_e972 < _e1066))))), ((((_e514 <= _e915) && (_e545 <= _e917)) && ((((((_e926 > 0f) && (_e931 > 0f)) && (_e943 > 0f)) && (_e936 > 0f)) || ((((_e926 < 0f) && (_e931 < 0f)) && (_e943 < 0f)) && (_e936 < 0f))) && !(((((_e180 == 2f) || (_e267 == 2f)) || (_e355 == 2f)) || (_e441 == 2f))))) && (_e836 >= 0.5f))), _e1092);
global_2.member[(_e75 + _e77)] = select(0f, _e971, _e1092);
global_2.member[((2u * _e75) + _e77)] = select(0f, _e973, _e1092);
global_2.member[((3u * _e75) + _e77)] = select(f32((_e1109 - select(0i, 1i, (_e1102 < f32(_e1109))))), (_e787 * _e905), _e902);
global_2.member[((4u * _e75) + _e77)] = select(f32((_e1128 - select(0i, 1i, (_e1121 < f32(_e1128))))), (_e788 * _e905), _e902);
global_2.member[((5u * _e75) + _e77)] = select(f32((_e1147 - select(0i, 1i, (_e1140 < f32(_e1147))))), (_e789 * _e905), _e902);
global_2.member[((6u * _e75) + _e77)] = select(f32((_e1166 - select(0i, 1i, (_e1159 < f32(_e1166))))), (_e819 * _e905), _e902);
global_2.member[((7u * _e75) + _e77)] = select(f32((_e1185 - select(0i, 1i, (_e1178 < f32(_e1185))))), (_e820 * _e905), _e902);
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
