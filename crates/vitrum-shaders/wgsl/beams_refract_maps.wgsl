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
struct type_19 {
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
struct type_20 {
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
struct type_21 {
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
struct type_22 {
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
struct type_23 {
member: type_5,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_24 {
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
member_11: type_19,
member_12: type_20,
member_13: type_21,
member_14: type_9,
member_15: type_6,
member_16: type_12,
member_17: u32,
member_18: type_22,
member_19: type_23,
}
struct type_25 {
member: type_24,
}
struct type_27 {
member: f32,
member_1: vec3<f32>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_25;
@group(0) @binding(1)
var<storage> global_2: type_15;
@group(0) @binding(3)
var<storage, read_write> global_3: type_15;
@group(0) @binding(2)
var<storage> global_4: type_15;
fn function_() {
var phi_313_: f32;
var phi_766_: u32;
var phi_769_: bool;
var phi_771_: f32;
var phi_773_: f32;
var phi_775_: f32;
var phi_777_: f32;
var phi_794_: f32;
var phi_843_: f32;
var phi_858_: f32;
var phi_1003_: vec3<f32>;
var phi_1006_: i32;
var phi_1008_: f32;
var phi_1010_: f32;
var phi_1029_: f32;
var phi_1035_: f32;
var phi_1165_: vec3<f32>;
var phi_1166_: f32;
var phi_1167_: f32;
var phi_1004_: vec3<f32>;
var phi_1007_: i32;
var phi_1009_: f32;
var phi_1011_: f32;
var local: f32;
var local_1: f32;
var local_2: f32;
var local_3: vec3<f32>;
var local_4: vec3<f32>;
var local_5: vec3<f32>;
var local_6: vec3<f32>;
var phi_1202_: type_27;
var phi_1213_: bool;
var phi_1214_: f32;
var phi_1215_: f32;
var phi_1216_: f32;
var phi_1217_: f32;
var phi_767_: u32;
var phi_770_: bool;
var phi_772_: f32;
var phi_774_: f32;
var phi_776_: f32;
var phi_778_: f32;
var local_7: f32;
var local_8: f32;
var local_9: f32;
var local_10: f32;
var local_11: f32;
var local_12: f32;
var phi_1275_: f32;
var phi_1290_: f32;
var phi_1435_: vec3<f32>;
var phi_1438_: i32;
var phi_1440_: f32;
var phi_1442_: f32;
var phi_1461_: f32;
var phi_1467_: f32;
var phi_1597_: vec3<f32>;
var phi_1598_: f32;
var phi_1599_: f32;
var phi_1436_: vec3<f32>;
var phi_1439_: i32;
var phi_1441_: f32;
var phi_1443_: f32;
var local_13: f32;
var local_14: f32;
var local_15: f32;
var local_16: vec3<f32>;
var local_17: vec3<f32>;
var local_18: vec3<f32>;
var local_19: vec3<f32>;
var phi_1634_: type_27;
var phi_1794_: array<f32, 11>;
var phi_1795_: array<f32, 11>;
var phi_1796_: array<f32, 11>;
var phi_1797_: array<f32, 11>;
var phi_1798_: bool;
var phi_1802_: array<f32, 11>;
let _e59 = global;
let _e66 = global_1.member.member;
if (_e59.x < _e66.member) {
if (_e59.y < _e66.member_1) {
let _e73 = (_e66.member * _e66.member_1);
let _e75 = ((_e59.y * _e66.member) + _e59.x);
let _e79 = global_1.member.member.member;
let _e83 = global_1.member.member.member_1;
let _e87 = bitcast<i32>(((_e59.y * _e79) + _e59.x));
let _e88 = bitcast<i32>((_e79 * _e83));
let _e90 = ((4i * _e88) + _e87);
let _e92 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e94 = select(_e92, _e90, (_e90 < _e92));
let _e100 = global_2.member[bitcast<u32>(select(0i, _e94, (_e94 > 0i)))];
let _e102 = ((5i * _e88) + _e87);
let _e104 = select(_e92, _e102, (_e102 < _e92));
let _e110 = global_2.member[bitcast<u32>(select(0i, _e104, (_e104 > 0i)))];
let _e112 = ((6i * _e88) + _e87);
let _e114 = select(_e92, _e112, (_e112 < _e92));
let _e120 = global_2.member[bitcast<u32>(select(0i, _e114, (_e114 > 0i)))];
let _e122 = ((7i * _e88) + _e87);
let _e124 = select(_e92, _e122, (_e122 < _e92));
let _e130 = global_2.member[bitcast<u32>(select(0i, _e124, (_e124 > 0i)))];
let _e132 = ((8i * _e88) + _e87);
let _e134 = select(_e92, _e132, (_e132 < _e92));
let _e140 = global_2.member[bitcast<u32>(select(0i, _e134, (_e134 > 0i)))];
let _e149 = ((9i * _e88) + _e87);
let _e151 = select(_e92, _e149, (_e149 < _e92));
let _e157 = global_2.member[bitcast<u32>(select(0i, _e151, (_e151 > 0i)))];
let _e164 = select(0i, select(select(i32(_e157), i32(-2147483648), (_e157 < -2147483600f)), 2147483647i, (_e157 > 2147483500f)), (_e157 == _e157));
if (select(0i, select(select(i32(_e140), i32(-2147483648), (_e140 < -2147483600f)), 2147483647i, (_e140 > 2147483500f)), (_e140 == _e140)) >= 0i) {
let _e166 = (_e164 * 4i);
let _e168 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e170 = select(_e168, _e166, (_e166 < _e168));
let _e176 = global_4.member[bitcast<u32>(select(0i, _e170, (_e170 > 0i)))];
phi_313_ = select(_e176, 1f, (_e164 == 16i));
} else {
phi_313_ = 0f;
}
let _e180 = phi_313_;
if (_e180 <= 0f) {
phi_1796_ = array<f32, 11>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 1f, 0f);
phi_1797_ = array<f32, 11>();
phi_1798_ = true;
} else {
let _e187 = global_1.member.member_11.member_2;
let _e194 = global_1.member.member_11.member_3;
let _e201 = global_1.member.member_11.member_5;
let _e207 = global_1.member.member_11.member_7;
let _e209 = (_e201 + ((f32(bitcast<i32>(_e59.x)) + 0.5f) * _e207));
let _e213 = global_1.member.member_11.member_6;
let _e219 = global_1.member.member_11.member_8;
let _e221 = (_e213 + ((f32(bitcast<i32>(_e59.y)) + 0.5f) * _e219));
let _e228 = ((_e187.member * _e209) + (_e194.member * _e221));
let _e229 = ((_e187.member_1 * _e209) + (_e194.member_1 * _e221));
let _e230 = ((_e187.member_2 * _e209) + (_e194.member_2 * _e221));
let _e234 = global_1.member.member_11.member_4;
let _e241 = global_1.member.member_11.member_1;
let _e248 = global_1.member.member_10.member;
let _e249 = (_e248 == 0u);
let _e250 = (_e241.member + _e228);
let _e251 = (_e241.member_1 + _e229);
let _e252 = (_e241.member_2 + _e230);
let _e257 = (((_e250 * _e250) + (_e251 * _e251)) + (_e252 * _e252));
let _e261 = (1f / sqrt(select(0f, _e257, (_e257 > 0f))));
let _e265 = select((_e250 * _e261), _e241.member, _e249);
let _e266 = select((_e251 * _e261), _e241.member_1, _e249);
let _e267 = select((_e252 * _e261), _e241.member_2, _e249);
let _e277 = (select(_e234.member, (_e234.member + _e228), _e249) + (_e265 * _e100));
let _e278 = (select(_e234.member_1, (_e234.member_1 + _e229), _e249) + (_e266 * _e100));
let _e279 = (select(_e234.member_2, (_e234.member_2 + _e230), _e249) + (_e267 * _e100));
let _e286 = select(1f, -1f, ((((_e265 * _e110) + (_e266 * _e120)) + (_e267 * _e130)) > 0f));
let _e287 = (_e110 * _e286);
let _e288 = (_e120 * _e286);
let _e289 = (_e130 * _e286);
let _e295 = -((((_e265 * _e287) + (_e266 * _e288)) + (_e267 * _e289)));
let _e297 = select(0f, _e295, (_e295 > 0f));
let _e298 = (1f / _e180);
let _e299 = (_e298 * _e298);
let _e303 = (1f - (_e299 * (1f - (_e297 * _e297))));
let _e304 = (_e303 <= 0f);
let _e312 = ((_e298 * _e297) - sqrt(select(0f, _e303, (_e303 > 0f))));
let _e319 = (2f * _e297);
let _e326 = select(((_e265 * _e298) + (_e287 * _e312)), (_e265 + (_e287 * _e319)), _e304);
let _e327 = select(((_e266 * _e298) + (_e288 * _e312)), (_e266 + (_e288 * _e319)), _e304);
let _e328 = select(((_e267 * _e298) + (_e289 * _e312)), (_e267 + (_e289 * _e319)), _e304);
let _e333 = (((_e326 * _e326) + (_e327 * _e327)) + (_e328 * _e328));
let _e336 = sqrt(select(0f, _e333, (_e333 > 0f)));
let _e339 = (1f / select(1e-20f, _e336, (_e336 > 1e-20f)));
let _e340 = (_e326 * _e339);
let _e341 = (_e327 * _e339);
let _e342 = (_e328 * _e339);
if _e304 {
phi_1794_ = array<f32, 11>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 1f, 0f);
phi_1795_ = array<f32, 11>();
} else {
let _e350 = (1f / select(_e340, select(1e-12f, -1e-12f, (_e340 < 0f)), (bitcast<f32>((bitcast<u32>(_e340) & 2147483647u)) < 1e-12f)));
let _e358 = (1f / select(_e341, select(1e-12f, -1e-12f, (_e341 < 0f)), (bitcast<f32>((bitcast<u32>(_e341) & 2147483647u)) < 1e-12f)));
let _e366 = (1f / select(_e342, select(1e-12f, -1e-12f, (_e342 < 0f)), (bitcast<f32>((bitcast<u32>(_e342) & 2147483647u)) < 1e-12f)));
let _e369 = global_1.member.member_8;
let _e375 = global_1.member.member_9;
let _e380 = ((_e369.member - _e277) * _e350);
let _e382 = ((_e375.member - _e277) * _e350);
let _e384 = ((_e369.member_1 - _e278) * _e358);
let _e386 = ((_e375.member_1 - _e278) * _e358);
let _e388 = ((_e369.member_2 - _e279) * _e366);
let _e390 = ((_e375.member_2 - _e279) * _e366);
let _e392 = select(_e382, _e380, (_e380 > _e382));
let _e394 = select(_e386, _e384, (_e384 > _e386));
let _e396 = select(_e394, _e392, (_e392 < _e394));
let _e398 = select(_e390, _e388, (_e388 > _e390));
let _e400 = select(_e398, _e396, (_e396 < _e398));
let _e402 = select(0f, _e400, (_e400 > 0f));
phi_766_ = 0u;
phi_769_ = false;
phi_771_ = 1f;
phi_773_ = 0f;
phi_775_ = 0f;
phi_777_ = _e402;
loop {
let _e406 = phi_766_;
let _e408 = phi_769_;
let _e410 = phi_771_;
let _e412 = phi_773_;
let _e414 = phi_775_;
let _e416 = phi_777_;
local_7 = _e416;
local_8 = _e414;
local_9 = _e412;
local_10 = _e410;
local_11 = _e412;
local_12 = _e414;
let _e417 = (_e406 < 24u);
if _e417 {
let _e418 = (_e406 < 16u);
if _e418 {
phi_794_ = ((_e402 * (1f / 16f)) * f32((_e406 + 1u)));
} else {
phi_794_ = (0.5f * (_e414 + _e416));
}
let _e425 = phi_794_;
if (_e418 && _e408) {
phi_1213_ = _e408;
phi_1214_ = _e410;
phi_1215_ = _e412;
phi_1216_ = _e414;
phi_1217_ = _e416;
} else {
let _e436 = global_1.member.member_11.member;
let _e437 = bitcast<i32>(_e436);
let _e438 = (_e437 * _e437);
let _e439 = ((_e277 + (_e340 * _e425)) - _e234.member);
let _e440 = ((_e278 + (_e341 * _e425)) - _e234.member_1);
let _e441 = ((_e279 + (_e342 * _e425)) - _e234.member_2);
let _e446 = (((_e439 * _e241.member) + (_e440 * _e241.member_1)) + (_e441 * _e241.member_2));
if _e249 {
phi_843_ = 1f;
} else {
phi_843_ = (1f / select(1e-6f, _e446, (_e446 > 1e-6f)));
}
let _e451 = phi_843_;
if _e249 {
phi_858_ = _e446;
} else {
let _e456 = (((_e439 * _e439) + (_e440 * _e440)) + (_e441 * _e441));
phi_858_ = sqrt(select(0f, _e456, (_e456 > 0f)));
}
let _e461 = phi_858_;
let _e478 = (((((((_e439 * _e187.member) + (_e440 * _e187.member_1)) + (_e441 * _e187.member_2)) * _e451) - _e201) * (1f / select(_e207, select(1e-12f, -1e-12f, (_e207 < 0f)), (bitcast<f32>((bitcast<u32>(_e207) & 2147483647u)) < 1e-12f)))) - 0.5f);
let _e495 = (((((((_e439 * _e194.member) + (_e440 * _e194.member_1)) + (_e441 * _e194.member_2)) * _e451) - _e213) * (1f / select(_e219, select(1e-12f, -1e-12f, (_e219 < 0f)), (bitcast<f32>((bitcast<u32>(_e219) & 2147483647u)) < 1e-12f)))) - 0.5f);
let _e496 = f32(_e437);
let _e498 = select(-2f, _e478, (_e478 > -2f));
let _e500 = select(_e496, _e498, (_e498 < _e496));
let _e507 = select(0i, select(select(i32(_e500), i32(-2147483648), (_e500 < -2147483600f)), 2147483647i, (_e500 > 2147483500f)), (_e500 == _e500));
let _e511 = (_e507 - select(0i, 1i, (_e500 < f32(_e507))));
let _e513 = select(-2f, _e495, (_e495 > -2f));
let _e515 = select(_e496, _e513, (_e513 < _e496));
let _e522 = select(0i, select(select(i32(_e515), i32(-2147483648), (_e515 < -2147483600f)), 2147483647i, (_e515 > 2147483500f)), (_e515 == _e515));
let _e526 = (_e522 - select(0i, 1i, (_e515 < f32(_e522))));
let _e528 = (_e478 - f32(_e511));
let _e530 = select(0f, _e528, (_e528 > 0f));
let _e532 = select(1f, _e530, (_e530 < 1f));
let _e534 = (_e495 - f32(_e526));
let _e536 = select(0f, _e534, (_e534 > 0f));
let _e538 = select(1f, _e536, (_e536 < 1f));
phi_1003_ = vec3<f32>(0f, 0f, 0f);
phi_1006_ = 0i;
phi_1008_ = 0f;
phi_1010_ = 0f;
loop {
let _e540 = phi_1003_;
let _e542 = phi_1006_;
let _e544 = phi_1008_;
let _e546 = phi_1010_;
local = _e544;
local_1 = _e546;
local_2 = _e544;
local_3 = _e540;
local_4 = _e540;
local_5 = _e540;
local_6 = _e540;
let _e547 = (_e542 < 4i);
if _e547 {
let _e548 = (_e542 & 1i);
let _e550 = (_e542 >> bitcast<u32>(1i));
let _e551 = (_e511 + _e548);
let _e552 = (_e526 + _e550);
let _e554 = ((_e552 * _e437) + _e551);
if (_e548 == 1i) {
phi_1029_ = _e532;
} else {
phi_1029_ = (1f - _e532);
}
let _e558 = phi_1029_;
if (_e550 == 1i) {
phi_1035_ = _e538;
} else {
phi_1035_ = (1f - _e538);
}
let _e562 = phi_1035_;
let _e563 = (_e558 * _e562);
let _e572 = ((14i * _e438) + _e554);
let _e574 = select(_e92, _e572, (_e572 < _e92));
let _e580 = global_2.member[bitcast<u32>(select(0i, _e574, (_e574 > 0i)))];
if (((((_e551 >= 0i) && (_e552 >= 0i)) && (_e551 < _e437)) && (_e552 < _e437)) && (select(0i, select(select(i32(_e580), i32(-2147483648), (_e580 < -2147483600f)), 2147483647i, (_e580 > 2147483500f)), (_e580 == _e580)) == _e164)) {
let _e591 = ((10i * _e438) + _e554);
let _e593 = select(_e92, _e591, (_e591 < _e92));
let _e599 = global_2.member[bitcast<u32>(select(0i, _e593, (_e593 > 0i)))];
let _e603 = ((11i * _e438) + _e554);
let _e605 = select(_e92, _e603, (_e603 < _e92));
let _e611 = global_2.member[bitcast<u32>(select(0i, _e605, (_e605 > 0i)))];
let _e613 = ((12i * _e438) + _e554);
let _e615 = select(_e92, _e613, (_e613 < _e92));
let _e621 = global_2.member[bitcast<u32>(select(0i, _e615, (_e615 > 0i)))];
let _e623 = ((13i * _e438) + _e554);
let _e625 = select(_e92, _e623, (_e623 < _e92));
let _e631 = global_2.member[bitcast<u32>(select(0i, _e625, (_e625 > 0i)))];
phi_1165_ = vec3<f32>((_e540.x + (_e611 * _e563)), (_e540.y + (_e621 * _e563)), (_e540.z + (_e631 * _e563)));
phi_1166_ = (_e544 + _e563);
phi_1167_ = (_e546 + (_e599 * _e563));
} else {
phi_1165_ = _e540;
phi_1166_ = _e544;
phi_1167_ = _e546;
}
let _e644 = phi_1165_;
let _e646 = phi_1166_;
let _e648 = phi_1167_;
phi_1004_ = _e644;
phi_1007_ = (_e542 + 1i);
phi_1009_ = _e646;
phi_1011_ = _e648;
} else {
phi_1004_ = vec3<f32>();
phi_1007_ = i32();
phi_1009_ = f32();
phi_1011_ = f32();
}
let _e651 = phi_1004_;
let _e653 = phi_1007_;
let _e655 = phi_1009_;
let _e657 = phi_1011_;
continue;
continuing {
phi_1003_ = _e651;
phi_1006_ = _e653;
phi_1008_ = _e655;
phi_1010_ = _e657;
break if !(_e547);
}
}
let _e660 = local;
if (_e660 > 0f) {
let _e663 = local_1;
let _e665 = local_2;
let _e669 = local_3;
let _e673 = local_4;
let _e678 = local_5;
let _e681 = (((_e669.x * _e669.x) + (_e673.y * _e673.y)) + (_e678.z * _e678.z));
let _e684 = sqrt(select(0f, _e681, (_e681 > 0f)));
let _e689 = local_6;
phi_1202_ = type_27((_e461 - (_e663 / _e665)), (_e689 * (1f / select(1e-20f, _e684, (_e684 > 1e-20f)))));
} else {
phi_1202_ = type_27(1e30f, vec3<f32>(0f, 0f, 0f));
}
let _e693 = phi_1202_;
let _e695 = (_e693.member >= 0f);
phi_1213_ = select(_e408, true, _e695);
phi_1214_ = select(_e410, _e693.member, _e695);
phi_1215_ = select(_e693.member, _e412, _e695);
phi_1216_ = select(_e425, _e414, _e695);
phi_1217_ = select(_e416, _e425, _e695);
}
let _e702 = phi_1213_;
let _e704 = phi_1214_;
let _e706 = phi_1215_;
let _e708 = phi_1216_;
let _e710 = phi_1217_;
phi_767_ = (_e406 + 1u);
phi_770_ = _e702;
phi_772_ = _e704;
phi_774_ = _e706;
phi_776_ = _e708;
phi_778_ = _e710;
} else {
phi_767_ = u32();
phi_770_ = bool();
phi_772_ = f32();
phi_774_ = f32();
phi_776_ = f32();
phi_778_ = f32();
}
let _e713 = phi_767_;
let _e715 = phi_770_;
let _e717 = phi_772_;
let _e719 = phi_774_;
let _e721 = phi_776_;
let _e723 = phi_778_;
continue;
continuing {
phi_766_ = _e713;
phi_769_ = _e715;
phi_771_ = _e717;
phi_773_ = _e719;
phi_775_ = _e721;
phi_777_ = _e723;
break if !(_e417);
}
}
let _e726 = local_7;
let _e728 = local_8;
let _e731 = local_9;
let _e734 = local_10;
let _e736 = local_11;
let _e737 = (_e734 - _e736);
let _e743 = local_12;
let _e744 = (_e743 + ((_e726 - _e728) * (-(_e731) / select(1e-20f, _e737, (_e737 > 1e-20f)))));
let _e748 = (_e277 + (_e340 * _e744));
let _e749 = (_e278 + (_e341 * _e744));
let _e750 = (_e279 + (_e342 * _e744));
let _e754 = global_1.member.member_11.member;
let _e755 = bitcast<i32>(_e754);
let _e756 = (_e755 * _e755);
let _e757 = (_e748 - _e234.member);
let _e758 = (_e749 - _e234.member_1);
let _e759 = (_e750 - _e234.member_2);
let _e764 = (((_e757 * _e241.member) + (_e758 * _e241.member_1)) + (_e759 * _e241.member_2));
if _e249 {
phi_1275_ = 1f;
} else {
phi_1275_ = (1f / select(1e-6f, _e764, (_e764 > 1e-6f)));
}
let _e769 = phi_1275_;
if _e249 {
phi_1290_ = _e764;
} else {
let _e774 = (((_e757 * _e757) + (_e758 * _e758)) + (_e759 * _e759));
phi_1290_ = sqrt(select(0f, _e774, (_e774 > 0f)));
}
let _e779 = phi_1290_;
let _e796 = (((((((_e757 * _e187.member) + (_e758 * _e187.member_1)) + (_e759 * _e187.member_2)) * _e769) - _e201) * (1f / select(_e207, select(1e-12f, -1e-12f, (_e207 < 0f)), (bitcast<f32>((bitcast<u32>(_e207) & 2147483647u)) < 1e-12f)))) - 0.5f);
let _e813 = (((((((_e757 * _e194.member) + (_e758 * _e194.member_1)) + (_e759 * _e194.member_2)) * _e769) - _e213) * (1f / select(_e219, select(1e-12f, -1e-12f, (_e219 < 0f)), (bitcast<f32>((bitcast<u32>(_e219) & 2147483647u)) < 1e-12f)))) - 0.5f);
let _e814 = f32(_e755);
let _e816 = select(-2f, _e796, (_e796 > -2f));
let _e818 = select(_e814, _e816, (_e816 < _e814));
let _e825 = select(0i, select(select(i32(_e818), i32(-2147483648), (_e818 < -2147483600f)), 2147483647i, (_e818 > 2147483500f)), (_e818 == _e818));
let _e829 = (_e825 - select(0i, 1i, (_e818 < f32(_e825))));
let _e831 = select(-2f, _e813, (_e813 > -2f));
let _e833 = select(_e814, _e831, (_e831 < _e814));
let _e840 = select(0i, select(select(i32(_e833), i32(-2147483648), (_e833 < -2147483600f)), 2147483647i, (_e833 > 2147483500f)), (_e833 == _e833));
let _e844 = (_e840 - select(0i, 1i, (_e833 < f32(_e840))));
let _e846 = (_e796 - f32(_e829));
let _e848 = select(0f, _e846, (_e846 > 0f));
let _e850 = select(1f, _e848, (_e848 < 1f));
let _e852 = (_e813 - f32(_e844));
let _e854 = select(0f, _e852, (_e852 > 0f));
let _e856 = select(1f, _e854, (_e854 < 1f));
phi_1435_ = vec3<f32>(0f, 0f, 0f);
phi_1438_ = 0i;
phi_1440_ = 0f;
phi_1442_ = 0f;
loop {
let _e858 = phi_1435_;
let _e860 = phi_1438_;
let _e862 = phi_1440_;
let _e864 = phi_1442_;
local_13 = _e862;
local_14 = _e864;
local_15 = _e862;
local_16 = _e858;
local_17 = _e858;
local_18 = _e858;
local_19 = _e858;
let _e865 = (_e860 < 4i);
if _e865 {
let _e866 = (_e860 & 1i);
let _e868 = (_e860 >> bitcast<u32>(1i));
let _e869 = (_e829 + _e866);
let _e870 = (_e844 + _e868);
let _e872 = ((_e870 * _e755) + _e869);
if (_e866 == 1i) {
phi_1461_ = _e850;
} else {
phi_1461_ = (1f - _e850);
}
let _e876 = phi_1461_;
if (_e868 == 1i) {
phi_1467_ = _e856;
} else {
phi_1467_ = (1f - _e856);
}
let _e880 = phi_1467_;
let _e881 = (_e876 * _e880);
let _e890 = ((14i * _e756) + _e872);
let _e892 = select(_e92, _e890, (_e890 < _e92));
let _e898 = global_2.member[bitcast<u32>(select(0i, _e892, (_e892 > 0i)))];
if (((((_e869 >= 0i) && (_e870 >= 0i)) && (_e869 < _e755)) && (_e870 < _e755)) && (select(0i, select(select(i32(_e898), i32(-2147483648), (_e898 < -2147483600f)), 2147483647i, (_e898 > 2147483500f)), (_e898 == _e898)) == _e164)) {
let _e909 = ((10i * _e756) + _e872);
let _e911 = select(_e92, _e909, (_e909 < _e92));
let _e917 = global_2.member[bitcast<u32>(select(0i, _e911, (_e911 > 0i)))];
let _e921 = ((11i * _e756) + _e872);
let _e923 = select(_e92, _e921, (_e921 < _e92));
let _e929 = global_2.member[bitcast<u32>(select(0i, _e923, (_e923 > 0i)))];
let _e931 = ((12i * _e756) + _e872);
let _e933 = select(_e92, _e931, (_e931 < _e92));
let _e939 = global_2.member[bitcast<u32>(select(0i, _e933, (_e933 > 0i)))];
let _e941 = ((13i * _e756) + _e872);
let _e943 = select(_e92, _e941, (_e941 < _e92));
let _e949 = global_2.member[bitcast<u32>(select(0i, _e943, (_e943 > 0i)))];
phi_1597_ = vec3<f32>((_e858.x + (_e929 * _e881)), (_e858.y + (_e939 * _e881)), (_e858.z + (_e949 * _e881)));
phi_1598_ = (_e862 + _e881);
phi_1599_ = (_e864 + (_e917 * _e881));
} else {
phi_1597_ = _e858;
phi_1598_ = _e862;
phi_1599_ = _e864;
}
let _e962 = phi_1597_;
let _e964 = phi_1598_;
let _e966 = phi_1599_;
phi_1436_ = _e962;
phi_1439_ = (_e860 + 1i);
phi_1441_ = _e964;
phi_1443_ = _e966;
} else {
phi_1436_ = vec3<f32>();
phi_1439_ = i32();
phi_1441_ = f32();
phi_1443_ = f32();
}
let _e969 = phi_1436_;
let _e971 = phi_1439_;
let _e973 = phi_1441_;
let _e975 = phi_1443_;
continue;
continuing {
phi_1435_ = _e969;
phi_1438_ = _e971;
phi_1440_ = _e973;
phi_1442_ = _e975;
break if !(_e865);
}
}
let _e978 = local_13;
if (_e978 > 0f) {
let _e981 = local_14;
let _e983 = local_15;
let _e987 = local_16;
let _e991 = local_17;
let _e996 = local_18;
let _e999 = (((_e987.x * _e987.x) + (_e991.y * _e991.y)) + (_e996.z * _e996.z));
let _e1002 = sqrt(select(0f, _e999, (_e999 > 0f)));
let _e1007 = local_19;
phi_1634_ = type_27((_e779 - (_e981 / _e983)), (_e1007 * (1f / select(1e-20f, _e1002, (_e1002 > 1e-20f)))));
} else {
phi_1634_ = type_27(1e30f, vec3<f32>(0f, 0f, 0f));
}
let _e1011 = phi_1634_;
let _e1022 = select(1f, -1f, ((((_e340 * _e1011.member_1.x) + (_e341 * _e1011.member_1.y)) + (_e342 * _e1011.member_1.z)) > 0f));
let _e1023 = (_e1011.member_1.x * _e1022);
let _e1024 = (_e1011.member_1.y * _e1022);
let _e1025 = (_e1011.member_1.z * _e1022);
let _e1031 = -((((_e340 * _e1023) + (_e341 * _e1024)) + (_e342 * _e1025)));
let _e1033 = select(0f, _e1031, (_e1031 > 0f));
let _e1034 = (_e180 / 1f);
let _e1036 = (_e1033 * _e1033);
let _e1039 = (1f - ((_e1034 * _e1034) * (1f - _e1036)));
let _e1040 = (_e1039 <= 0f);
let _e1048 = ((_e1034 * _e1033) - sqrt(select(0f, _e1039, (_e1039 > 0f))));
let _e1055 = (2f * _e1033);
let _e1062 = select(((_e340 * _e1034) + (_e1023 * _e1048)), (_e340 + (_e1023 * _e1055)), _e1040);
let _e1063 = select(((_e341 * _e1034) + (_e1024 * _e1048)), (_e341 + (_e1024 * _e1055)), _e1040);
let _e1064 = select(((_e342 * _e1034) + (_e1025 * _e1048)), (_e342 + (_e1025 * _e1055)), _e1040);
let _e1069 = (((_e1062 * _e1062) + (_e1063 * _e1063)) + (_e1064 * _e1064));
let _e1072 = sqrt(select(0f, _e1069, (_e1069 > 0f)));
let _e1075 = (1f / select(1e-20f, _e1072, (_e1072 > 1e-20f)));
let _e1080 = ((_e299 - 1f) + _e1036);
let _e1083 = sqrt(select(0f, _e1080, (_e1080 > 0f)));
let _e1084 = (_e1083 - _e1033);
let _e1085 = (_e1083 + _e1033);
let _e1088 = (_e1084 / select(1e-6f, _e1085, (_e1085 > 1e-6f)));
let _e1092 = ((_e1033 * _e1084) + 1f);
let _e1095 = (((_e1033 * _e1085) - 1f) / select(1e-6f, _e1092, (_e1092 > 1e-6f)));
phi_1794_ = array<f32, 11>();
phi_1795_ = array<f32, 11>(_e748, _e749, _e750, (_e1062 * _e1075), (_e1063 * _e1075), (_e1064 * _e1075), _e1011.member_1.x, _e1011.member_1.y, _e1011.member_1.z, select(1f, select(select((((0.5f * _e1088) * _e1088) * (1f + (_e1095 * _e1095))), 1f, (_e1080 <= 0f)), 0f, (_e180 == 1f)), ((((_e1011.member_1.x * _e340) + (_e1011.member_1.y * _e341)) + (_e1011.member_1.z * _e342)) > 0f)), _e744);
}
let _e1114 = phi_1794_;
let _e1116 = phi_1795_;
phi_1796_ = _e1114;
phi_1797_ = _e1116;
phi_1798_ = _e304;
}
let _e1118 = phi_1796_;
let _e1120 = phi_1797_;
let _e1122 = phi_1798_;
if _e1122 {
phi_1802_ = _e1118;
} else {
phi_1802_ = _e1120;
}
let _e1124 = phi_1802_;
global_3.member[_e75] = _e1124[0];
global_3.member[(_e73 + _e75)] = _e1124[1];
global_3.member[((2u * _e73) + _e75)] = _e1124[2];
global_3.member[((3u * _e73) + _e75)] = _e1124[3];
global_3.member[((4u * _e73) + _e75)] = _e1124[4];
global_3.member[((5u * _e73) + _e75)] = _e1124[5];
global_3.member[((6u * _e73) + _e75)] = _e1124[6];
global_3.member[((7u * _e73) + _e75)] = _e1124[7];
global_3.member[((8u * _e73) + _e75)] = _e1124[8];
global_3.member[((9u * _e73) + _e75)] = _e1124[9];
global_3.member[((10u * _e73) + _e75)] = _e1124[10];
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
