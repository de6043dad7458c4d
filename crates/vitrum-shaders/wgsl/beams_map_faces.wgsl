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
member: vec3<f32>,
member_1: vec3<f32>,
member_2: vec3<f32>,
member_3: vec3<f32>,
member_4: vec3<f32>,
member_5: f32,
member_6: f32,
member_7: i32,
member_8: f32,
member_9: f32,
member_10: f32,
member_11: f32,
member_12: vec3<f32>,
member_13: vec3<f32>,
member_14: i32,
member_15: i32,
member_16: i32,
member_17: f32,
}
struct type_20 {
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
struct type_21 {
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
struct type_22 {
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
struct type_23 {
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
struct type_24 {
member: type_5,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_25 {
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
member_11: type_20,
member_12: type_21,
member_13: type_22,
member_14: type_9,
member_15: type_6,
member_16: type_12,
member_17: u32,
member_18: type_23,
member_19: type_24,
}
struct type_26 {
member: type_25,
}
struct type_27 {
member: f32,
member_1: i32,
member_2: i32,
member_3: f32,
member_4: f32,
member_5: vec3<f32>,
member_6: i32,
member_7: i32,
member_8: f32,
member_9: vec3<f32>,
member_10: i32,
}
struct type_30 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(1)
var<storage> global_1: type_15;
@group(0) @binding(2)
var<storage> global_2: type_15;
@group(0) @binding(3)
var<storage> global_3: type_15;
@group(0) @binding(4)
var<storage, read_write> global_4: type_15;
@group(0) @binding(0)
var<storage> global_5: type_26;
@group(0) @binding(5)
var<storage, read_write> global_6: type_30;
fn function_() {
var phi_759_: f32;
var phi_884_: type_27;
var phi_899_: type_27;
var phi_902_: i32;
var phi_3023_: type_27;
var phi_2510_: type_27;
var phi_2511_: type_27;
var phi_2512_: bool;
var phi_2516_: type_27;
var phi_3024_: type_27;
var phi_954_: type_19;
var phi_1233_: i32;
var phi_1842_: bool;
var phi_1851_: type_27;
var phi_1852_: type_27;
var phi_3025_: type_27;
var phi_900_: type_27;
var phi_903_: i32;
var local: type_27;
var local_1: type_27;
var local_2: type_27;
var local_3: type_27;
var local_4: type_27;
var local_5: type_27;
var local_6: type_27;
var local_7: type_27;
var local_8: type_27;
var local_9: type_27;
var local_10: type_27;
var local_11: type_27;
var local_12: type_27;
var local_13: type_27;
var local_14: f32;
let _e72 = global;
let _e76 = arrayLength((&global_2.member));
let _e78 = arrayLength((&global_3.member));
let _e85 = global_5.member.member;
if (_e72.x < _e85.member) {
if (_e72.y < _e85.member_1) {
let _e92 = (_e85.member * _e85.member_1);
let _e94 = ((_e72.y * _e85.member) + _e72.x);
let _e95 = bitcast<i32>(_e94);
let _e97 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e99 = select(_e97, _e95, (_e95 < _e97));
let _e105 = global_4.member[bitcast<u32>(select(0i, _e99, (_e99 > 0i)))];
let _e106 = (_e92 + _e94);
let _e107 = bitcast<i32>(_e106);
let _e109 = select(_e97, _e107, (_e107 < _e97));
let _e115 = global_4.member[bitcast<u32>(select(0i, _e109, (_e109 > 0i)))];
let _e117 = ((2u * _e92) + _e94);
let _e118 = bitcast<i32>(_e117);
let _e120 = select(_e97, _e118, (_e118 < _e97));
let _e126 = global_4.member[bitcast<u32>(select(0i, _e120, (_e120 > 0i)))];
let _e128 = ((3u * _e92) + _e94);
let _e129 = bitcast<i32>(_e128);
let _e131 = select(_e97, _e129, (_e129 < _e97));
let _e137 = global_4.member[bitcast<u32>(select(0i, _e131, (_e131 > 0i)))];
let _e139 = ((4u * _e92) + _e94);
let _e140 = bitcast<i32>(_e139);
let _e142 = select(_e97, _e140, (_e140 < _e97));
let _e148 = global_4.member[bitcast<u32>(select(0i, _e142, (_e142 > 0i)))];
let _e150 = ((5u * _e92) + _e94);
let _e151 = bitcast<i32>(_e150);
let _e153 = select(_e97, _e151, (_e151 < _e97));
let _e159 = global_4.member[bitcast<u32>(select(0i, _e153, (_e153 > 0i)))];
let _e161 = ((6u * _e92) + _e94);
let _e162 = bitcast<i32>(_e161);
let _e164 = select(_e97, _e162, (_e162 < _e97));
let _e170 = global_4.member[bitcast<u32>(select(0i, _e164, (_e164 > 0i)))];
let _e172 = ((7u * _e92) + _e94);
let _e173 = bitcast<i32>(_e172);
let _e175 = select(_e97, _e173, (_e173 < _e97));
let _e181 = global_4.member[bitcast<u32>(select(0i, _e175, (_e175 > 0i)))];
let _e183 = ((8u * _e92) + _e94);
let _e184 = bitcast<i32>(_e183);
let _e186 = select(_e97, _e184, (_e184 < _e97));
let _e192 = global_4.member[bitcast<u32>(select(0i, _e186, (_e186 > 0i)))];
let _e194 = ((9u * _e92) + _e94);
let _e195 = bitcast<i32>(_e194);
let _e197 = select(_e97, _e195, (_e195 < _e97));
let _e203 = global_4.member[bitcast<u32>(select(0i, _e197, (_e197 > 0i)))];
let _e205 = ((10u * _e92) + _e94);
let _e206 = bitcast<i32>(_e205);
let _e208 = select(_e97, _e206, (_e206 < _e97));
let _e214 = global_4.member[bitcast<u32>(select(0i, _e208, (_e208 > 0i)))];
let _e216 = ((11u * _e92) + _e94);
let _e217 = bitcast<i32>(_e216);
let _e219 = select(_e97, _e217, (_e217 < _e97));
let _e225 = global_4.member[bitcast<u32>(select(0i, _e219, (_e219 > 0i)))];
let _e227 = ((12u * _e92) + _e94);
let _e228 = bitcast<i32>(_e227);
let _e230 = select(_e97, _e228, (_e228 < _e97));
let _e236 = global_4.member[bitcast<u32>(select(0i, _e230, (_e230 > 0i)))];
let _e238 = ((13u * _e92) + _e94);
let _e239 = bitcast<i32>(_e238);
let _e241 = select(_e97, _e239, (_e239 < _e97));
let _e247 = global_4.member[bitcast<u32>(select(0i, _e241, (_e241 > 0i)))];
let _e249 = ((14u * _e92) + _e94);
let _e250 = bitcast<i32>(_e249);
let _e252 = select(_e97, _e250, (_e250 < _e97));
let _e258 = global_4.member[bitcast<u32>(select(0i, _e252, (_e252 > 0i)))];
let _e260 = select(3u, 0u, (_e105 == 3f));
if (_e260 > 0u) {
if (arrayLength((&global_6.member)) >= 3u) {
let _e269 = atomicLoad((&global_6.member[0u]));
if (_e269 == 0u) {
atomicStore((&global_6.member[0u]), ((_e85.member + 7u) / 8u));
atomicStore((&global_6.member[1u]), ((_e85.member_1 + 7u) / 8u));
atomicStore((&global_6.member[2u]), 1u);
}
}
}
if (_e260 > 1u) {
let _e282 = select(0i, select(select(i32(_e115), i32(-2147483648), (_e115 < -2147483600f)), 2147483647i, (_e115 > 2147483500f)), (_e115 == _e115));
let _e290 = vec3<f32>(_e159, _e170, _e181);
let _e305 = vec3<f32>(_e225, _e236, _e247);
let _e319 = global_5.member.member_11.member_2;
let _e326 = global_5.member.member_11.member_3;
let _e333 = global_5.member.member_11.member_5;
let _e339 = global_5.member.member_11.member_7;
let _e341 = (_e333 + ((f32(bitcast<i32>(_e72.x)) + 0.5f) * _e339));
let _e345 = global_5.member.member_11.member_6;
let _e351 = global_5.member.member_11.member_8;
let _e353 = (_e345 + ((f32(bitcast<i32>(_e72.y)) + 0.5f) * _e351));
let _e360 = ((_e319.member * _e341) + (_e326.member * _e353));
let _e361 = ((_e319.member_1 * _e341) + (_e326.member_1 * _e353));
let _e362 = ((_e319.member_2 * _e341) + (_e326.member_2 * _e353));
let _e366 = global_5.member.member_11.member_4;
let _e373 = global_5.member.member_11.member_1;
let _e380 = global_5.member.member_10.member;
let _e381 = (_e380 == 0u);
let _e382 = (_e373.member + _e360);
let _e383 = (_e373.member_1 + _e361);
let _e384 = (_e373.member_2 + _e362);
let _e389 = (((_e382 * _e382) + (_e383 * _e383)) + (_e384 * _e384));
let _e393 = (1f / sqrt(select(0f, _e389, (_e389 > 0f))));
let _e397 = select((_e382 * _e393), _e373.member, _e381);
let _e398 = select((_e383 * _e393), _e373.member_1, _e381);
let _e399 = select((_e384 * _e393), _e373.member_2, _e381);
let _e404 = select(_e366.member, (_e366.member + _e360), _e381);
let _e405 = select(_e366.member_1, (_e366.member_1 + _e361), _e381);
let _e406 = select(_e366.member_2, (_e366.member_2 + _e362), _e381);
let _e414 = (1f / select(_e397, select(1e-12f, -1e-12f, (_e397 < 0f)), (bitcast<f32>((bitcast<u32>(_e397) & 2147483647u)) < 1e-12f)));
let _e422 = (1f / select(_e398, select(1e-12f, -1e-12f, (_e398 < 0f)), (bitcast<f32>((bitcast<u32>(_e398) & 2147483647u)) < 1e-12f)));
let _e430 = (1f / select(_e399, select(1e-12f, -1e-12f, (_e399 < 0f)), (bitcast<f32>((bitcast<u32>(_e399) & 2147483647u)) < 1e-12f)));
let _e433 = global_5.member.member_8;
let _e439 = global_5.member.member_9;
let _e444 = ((_e433.member - _e404) * _e414);
let _e446 = ((_e439.member - _e404) * _e414);
let _e448 = ((_e433.member_1 - _e405) * _e422);
let _e450 = ((_e439.member_1 - _e405) * _e422);
let _e452 = ((_e433.member_2 - _e406) * _e430);
let _e454 = ((_e439.member_2 - _e406) * _e430);
let _e456 = select(_e446, _e444, (_e444 < _e446));
let _e458 = select(_e450, _e448, (_e448 < _e450));
let _e460 = select(_e458, _e456, (_e456 > _e458));
let _e462 = select(_e454, _e452, (_e452 < _e454));
let _e464 = select(_e462, _e460, (_e460 > _e462));
let _e466 = select(_e446, _e444, (_e444 > _e446));
let _e468 = select(_e450, _e448, (_e448 > _e450));
let _e470 = select(_e468, _e466, (_e466 < _e468));
let _e472 = select(_e454, _e452, (_e452 > _e454));
let _e474 = select(_e472, _e470, (_e470 < _e472));
if _e381 {
phi_759_ = -(1e30f);
} else {
phi_759_ = 0f;
}
let _e477 = phi_759_;
let _e479 = select(_e477, _e464, (_e464 > _e477));
if (_e105 == 0f) {
let _e485 = (_e404 + (_e397 * _e479));
let _e486 = (_e405 + (_e398 * _e479));
let _e487 = (_e406 + (_e399 * _e479));
let _e492 = global_5.member.member_14.member.member;
let _e503 = ((((_e492.member.member * _e485) + (_e492.member.member_1 * _e486)) + (_e492.member.member_2 * _e487)) + _e492.member_1);
let _e509 = -((((_e492.member.member * _e397) + (_e492.member.member_1 * _e398)) + (_e492.member.member_2 * _e399)));
let _e511 = (_e509 > 1e-9f);
let _e515 = ((_e503 / select(1e-9f, _e509, _e511)) - 0.015625f);
let _e518 = select(1e30f, select(0f, _e515, (_e515 > 0f)), ((_e503 > 0f) && _e511));
let _e523 = global_5.member.member_14.member_1.member;
let _e534 = ((((_e523.member.member * _e485) + (_e523.member.member_1 * _e486)) + (_e523.member.member_2 * _e487)) + _e523.member_1);
let _e540 = -((((_e523.member.member * _e397) + (_e523.member.member_1 * _e398)) + (_e523.member.member_2 * _e399)));
let _e542 = (_e540 > 1e-9f);
let _e546 = ((_e534 / select(1e-9f, _e540, _e542)) - 0.015625f);
let _e549 = select(1e30f, select(0f, _e546, (_e546 > 0f)), ((_e534 > 0f) && _e542));
let _e553 = (_e549 < _e518);
phi_884_ = type_27(select(1f, 3f, (_e474 <= _e479)), _e282, select(select(-2i, -3i, _e553), -1i, ((_e518 >= 1e30f) && (_e549 >= 1e30f))), select(_e518, _e549, _e553), _e148, _e290, -1i, -1i, _e214, _e305, -1i);
} else {
phi_884_ = type_27(_e105, _e282, select(0i, select(select(i32(_e126), i32(-2147483648), (_e126 < -2147483600f)), 2147483647i, (_e126 > 2147483500f)), (_e126 == _e126)), _e137, _e148, _e290, select(0i, select(select(i32(_e192), i32(-2147483648), (_e192 < -2147483600f)), 2147483647i, (_e192 > 2147483500f)), (_e192 == _e192)), select(0i, select(select(i32(_e203), i32(-2147483648), (_e203 < -2147483600f)), 2147483647i, (_e203 > 2147483500f)), (_e203 == _e203)), _e214, _e305, select(0i, select(select(i32(_e258), i32(-2147483648), (_e258 < -2147483600f)), 2147483647i, (_e258 > 2147483500f)), (_e258 == _e258)));
}
let _e560 = phi_884_;
let _e561 = bitcast<i32>(arrayLength((&global_1.member)));
phi_899_ = _e560;
phi_902_ = 0i;
loop {
let _e564 = phi_899_;
let _e566 = phi_902_;
local = _e564;
local_1 = _e564;
local_2 = _e564;
local_3 = _e564;
local_4 = _e564;
local_5 = _e564;
local_6 = _e564;
local_7 = _e564;
local_8 = _e564;
local_9 = _e564;
local_10 = _e564;
local_11 = _e564;
local_12 = _e564;
local_13 = _e564;
let _e570 = ((_e566 < 1024i) && (_e564.member != 3f));
local_14 = _e564.member;
if _e570 {
if (_e564.member_1 < (_e561 / 8i)) {
let _e1457 = (_e564.member == 1f);
if _e1457 {
phi_954_ = type_19(vec3<f32>((_e404 + (_e397 * _e479)), (_e405 + (_e398 * _e479)), (_e406 + (_e399 * _e479))), vec3<f32>(_e397, _e398, _e399), vec3<f32>(1f, 1f, 1f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), 1e9f, 0f, 16i, 0f, 0f, 0f, 0f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), 0i, 0i, -1i, 1e30f);
} else {
phi_954_ = type_19(vec3<f32>((_e404 + (_e397 * _e474)), (_e405 + (_e398 * _e474)), (_e406 + (_e399 * _e474))), vec3<f32>(-(_e397), -(_e398), -(_e399)), vec3<f32>(1f, 1f, 1f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), 1e9f, 0f, 16i, 0f, 0f, 0f, 0f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), 0i, 0i, -1i, 1e30f);
}
let _e1479 = phi_954_;
let _e1487 = (_e564.member_1 * 8i);
let _e1495 = (1f / select(_e1479.member_1.x, select(1e-12f, -1e-12f, (_e1479.member_1.x < 0f)), (bitcast<f32>((bitcast<u32>(_e1479.member_1.x) & 2147483647u)) < 1e-12f)));
let _e1503 = (1f / select(_e1479.member_1.y, select(1e-12f, -1e-12f, (_e1479.member_1.y < 0f)), (bitcast<f32>((bitcast<u32>(_e1479.member_1.y) & 2147483647u)) < 1e-12f)));
let _e1511 = (1f / select(_e1479.member_1.z, select(1e-12f, -1e-12f, (_e1479.member_1.z < 0f)), (bitcast<f32>((bitcast<u32>(_e1479.member_1.z) & 2147483647u)) < 1e-12f)));
let _e1513 = (_e561 - 1i);
let _e1515 = select(_e1513, _e1487, (_e1487 < _e1513));
let _e1521 = global_1.member[bitcast<u32>(select(0i, _e1515, (_e1515 > 0i)))];
let _e1522 = (_e1487 + 1i);
let _e1524 = select(_e1513, _e1522, (_e1522 < _e1513));
let _e1530 = global_1.member[bitcast<u32>(select(0i, _e1524, (_e1524 > 0i)))];
let _e1531 = (_e1487 + 2i);
let _e1533 = select(_e1513, _e1531, (_e1531 < _e1513));
let _e1539 = global_1.member[bitcast<u32>(select(0i, _e1533, (_e1533 > 0i)))];
let _e1540 = (_e1487 + 3i);
let _e1542 = select(_e1513, _e1540, (_e1540 < _e1513));
let _e1548 = global_1.member[bitcast<u32>(select(0i, _e1542, (_e1542 > 0i)))];
let _e1549 = (_e1487 + 4i);
let _e1551 = select(_e1513, _e1549, (_e1549 < _e1513));
let _e1557 = global_1.member[bitcast<u32>(select(0i, _e1551, (_e1551 > 0i)))];
let _e1558 = (_e1487 + 5i);
let _e1560 = select(_e1513, _e1558, (_e1558 < _e1513));
let _e1566 = global_1.member[bitcast<u32>(select(0i, _e1560, (_e1560 > 0i)))];
let _e1569 = ((_e1521 - _e1479.member.x) * _e1495);
let _e1571 = ((_e1548 - _e1479.member.x) * _e1495);
let _e1574 = ((_e1530 - _e1479.member.y) * _e1503);
let _e1576 = ((_e1557 - _e1479.member.y) * _e1503);
let _e1579 = ((_e1539 - _e1479.member.z) * _e1511);
let _e1581 = ((_e1566 - _e1479.member.z) * _e1511);
let _e1583 = select(_e1571, _e1569, (_e1569 < _e1571));
let _e1585 = select(_e1576, _e1574, (_e1574 < _e1576));
let _e1587 = select(_e1585, _e1583, (_e1583 > _e1585));
let _e1589 = select(_e1581, _e1579, (_e1579 < _e1581));
let _e1593 = select(_e1571, _e1569, (_e1569 > _e1571));
let _e1595 = select(_e1576, _e1574, (_e1574 > _e1576));
let _e1597 = select(_e1595, _e1593, (_e1593 < _e1595));
let _e1599 = select(_e1581, _e1579, (_e1579 > _e1581));
let _e1601 = select(_e1599, _e1597, (_e1597 < _e1599));
let _e1606 = ((select(_e1589, _e1587, (_e1587 > _e1589)) <= select(_e564.member_3, _e1601, (_e1601 < _e564.member_3))) && (_e1601 >= 0f));
let _e1607 = (_e1487 + 6i);
let _e1609 = select(_e1513, _e1607, (_e1607 < _e1513));
let _e1615 = global_1.member[bitcast<u32>(select(0i, _e1609, (_e1609 > 0i)))];
if _e1606 {
phi_1233_ = (_e564.member_1 + 1i);
} else {
let _e1623 = (_e1487 + 7i);
let _e1625 = select(_e1513, _e1623, (_e1623 < _e1513));
let _e1631 = global_1.member[bitcast<u32>(select(0i, _e1625, (_e1625 > 0i)))];
phi_1233_ = select(0i, select(select(i32(_e1631), i32(-2147483648), (_e1631 < -2147483600f)), 2147483647i, (_e1631 > 2147483500f)), (_e1631 == _e1631));
}
let _e1641 = phi_1233_;
let _e1642 = select(-1i, select(0i, select(select(i32(_e1615), i32(-2147483648), (_e1615 < -2147483600f)), 2147483647i, (_e1615 > 2147483500f)), (_e1615 == _e1615)), _e1606);
let _e1653 = type_27(_e564.member, _e1641, _e564.member_2, _e564.member_3, _e564.member_4, _e564.member_5, _e564.member_6, _e564.member_7, _e564.member_8, _e564.member_9, _e564.member_10);
if (_e1642 < 0i) {
phi_1852_ = _e1653;
} else {
let _e1659 = bitcast<f32>((bitcast<u32>(_e1479.member_1.x) & 2147483647u));
let _e1663 = bitcast<f32>((bitcast<u32>(_e1479.member_1.y) & 2147483647u));
let _e1667 = bitcast<f32>((bitcast<u32>(_e1479.member_1.z) & 2147483647u));
let _e1670 = ((_e1659 >= _e1663) && (_e1659 >= _e1667));
let _e1673 = (!(_e1670) && (_e1663 >= _e1667));
let _e1680 = (1f / select(select(_e1479.member_1.z, _e1479.member_1.y, _e1673), _e1479.member_1.x, _e1670));
let _e1681 = (select(select(_e1479.member_1.x, _e1479.member_1.z, _e1673), _e1479.member_1.y, _e1670) * _e1680);
let _e1682 = (select(select(_e1479.member_1.y, _e1479.member_1.x, _e1673), _e1479.member_1.z, _e1670) * _e1680);
let _e1683 = (_e1642 * 19i);
let _e1685 = (bitcast<i32>(_e76) - 1i);
let _e1687 = select(_e1685, _e1683, (_e1683 < _e1685));
let _e1693 = global_2.member[bitcast<u32>(select(0i, _e1687, (_e1687 > 0i)))];
let _e1694 = (_e1683 + 1i);
let _e1696 = select(_e1685, _e1694, (_e1694 < _e1685));
let _e1702 = global_2.member[bitcast<u32>(select(0i, _e1696, (_e1696 > 0i)))];
let _e1703 = (_e1683 + 2i);
let _e1705 = select(_e1685, _e1703, (_e1703 < _e1685));
let _e1711 = global_2.member[bitcast<u32>(select(0i, _e1705, (_e1705 > 0i)))];
let _e1712 = (_e1693 - _e1479.member.x);
let _e1713 = (_e1702 - _e1479.member.y);
let _e1714 = (_e1711 - _e1479.member.z);
let _e1720 = select(select(_e1714, _e1713, _e1673), _e1712, _e1670);
let _e1722 = (select(select(_e1712, _e1714, _e1673), _e1713, _e1670) - (_e1681 * _e1720));
let _e1724 = (select(select(_e1713, _e1712, _e1673), _e1714, _e1670) - (_e1682 * _e1720));
let _e1726 = (_e1683 + 3i);
let _e1728 = select(_e1685, _e1726, (_e1726 < _e1685));
let _e1734 = global_2.member[bitcast<u32>(select(0i, _e1728, (_e1728 > 0i)))];
let _e1735 = (_e1683 + 4i);
let _e1737 = select(_e1685, _e1735, (_e1735 < _e1685));
let _e1743 = global_2.member[bitcast<u32>(select(0i, _e1737, (_e1737 > 0i)))];
let _e1744 = (_e1683 + 5i);
let _e1746 = select(_e1685, _e1744, (_e1744 < _e1685));
let _e1752 = global_2.member[bitcast<u32>(select(0i, _e1746, (_e1746 > 0i)))];
let _e1753 = (_e1734 - _e1479.member.x);
let _e1754 = (_e1743 - _e1479.member.y);
let _e1755 = (_e1752 - _e1479.member.z);
let _e1761 = select(select(_e1755, _e1754, _e1673), _e1753, _e1670);
let _e1763 = (select(select(_e1753, _e1755, _e1673), _e1754, _e1670) - (_e1681 * _e1761));
let _e1765 = (select(select(_e1754, _e1753, _e1673), _e1755, _e1670) - (_e1682 * _e1761));
let _e1767 = (_e1683 + 6i);
let _e1769 = select(_e1685, _e1767, (_e1767 < _e1685));
let _e1775 = global_2.member[bitcast<u32>(select(0i, _e1769, (_e1769 > 0i)))];
let _e1776 = (_e1683 + 7i);
let _e1778 = select(_e1685, _e1776, (_e1776 < _e1685));
let _e1784 = global_2.member[bitcast<u32>(select(0i, _e1778, (_e1778 > 0i)))];
let _e1785 = (_e1683 + 8i);
let _e1787 = select(_e1685, _e1785, (_e1785 < _e1685));
let _e1793 = global_2.member[bitcast<u32>(select(0i, _e1787, (_e1787 > 0i)))];
let _e1794 = (_e1775 - _e1479.member.x);
let _e1795 = (_e1784 - _e1479.member.y);
let _e1796 = (_e1793 - _e1479.member.z);
let _e1802 = select(select(_e1796, _e1795, _e1673), _e1794, _e1670);
let _e1804 = (select(select(_e1794, _e1796, _e1673), _e1795, _e1670) - (_e1681 * _e1802));
let _e1806 = (select(select(_e1795, _e1794, _e1673), _e1796, _e1670) - (_e1682 * _e1802));
let _e1810 = ((_e1804 * _e1765) - (_e1806 * _e1763));
let _e1813 = ((_e1722 * _e1806) - (_e1724 * _e1804));
let _e1816 = ((_e1763 * _e1724) - (_e1765 * _e1722));
let _e1818 = ((_e1810 + _e1813) + _e1816);
let _e1832 = (!(((((_e1810 < 0f) || (_e1813 < 0f)) || (_e1816 < 0f)) && (((_e1810 > 0f) || (_e1813 > 0f)) || (_e1816 > 0f)))) && (_e1818 != 0f));
let _e1840 = select(1e30f, ((((_e1810 * (_e1720 * _e1680)) + (_e1813 * (_e1761 * _e1680))) + (_e1816 * (_e1802 * _e1680))) / select(1f, _e1818, _e1832)), _e1832);
let _e1842 = select(1e30f, _e1840, (_e1840 > 1e-3f));
let _e1843 = (_e1683 + 18i);
let _e1845 = select(_e1685, _e1843, (_e1843 < _e1685));
let _e1851 = global_2.member[bitcast<u32>(select(0i, _e1845, (_e1845 > 0i)))];
let _e1858 = select(0i, select(select(i32(_e1851), i32(-2147483648), (_e1851 < -2147483600f)), 2147483647i, (_e1851 > 2147483500f)), (_e1851 == _e1851));
let _e1859 = (_e1858 * 4i);
let _e1861 = (bitcast<i32>(_e78) - 1i);
let _e1863 = select(_e1861, _e1859, (_e1859 < _e1861));
let _e1869 = global_3.member[bitcast<u32>(select(0i, _e1863, (_e1863 > 0i)))];
let _e1872 = (select(_e1869, 1f, (_e1858 == 16i)) <= 0f);
let _e1873 = (_e1734 - _e1693);
let _e1874 = (_e1743 - _e1702);
let _e1875 = (_e1752 - _e1711);
let _e1876 = (_e1775 - _e1693);
let _e1877 = (_e1784 - _e1702);
let _e1878 = (_e1793 - _e1711);
let _e1881 = ((_e1874 * _e1878) - (_e1875 * _e1877));
let _e1884 = ((_e1875 * _e1876) - (_e1873 * _e1878));
let _e1887 = ((_e1873 * _e1877) - (_e1874 * _e1876));
let _e1892 = (((_e1881 * _e1881) + (_e1884 * _e1884)) + (_e1887 * _e1887));
let _e1895 = sqrt(select(0f, _e1892, (_e1892 > 0f)));
let _e1898 = (1f / select(1e-20f, _e1895, (_e1895 > 1e-20f)));
let _e1907 = ((((_e397 * (_e1881 * _e1898)) + (_e398 * (_e1884 * _e1898))) + (_e399 * (_e1887 * _e1898))) < 0f);
if _e1457 {
phi_1842_ = (_e1872 || _e1907);
} else {
phi_1842_ = (!(_e1872) && !(_e1907));
}
let _e1913 = phi_1842_;
if (_e1913 && (_e1842 < _e564.member_3)) {
let _e1926 = type_27(_e1653.member, _e1653.member_1, _e1653.member_2, _e1842, _e1653.member_4, _e1653.member_5, _e1653.member_6, _e1653.member_7, _e1653.member_8, _e1653.member_9, _e1653.member_10);
phi_1851_ = type_27(_e1926.member, _e1926.member_1, _e1642, _e1926.member_3, _e1926.member_4, _e1926.member_5, _e1926.member_6, _e1926.member_7, _e1926.member_8, _e1926.member_9, _e1926.member_10);
} else {
phi_1851_ = _e1653;
}
let _e1939 = phi_1851_;
phi_1852_ = _e1939;
}
let _e1941 = phi_1852_;
phi_3025_ = _e1941;
} else {
if (_e564.member == 1f) {
let _e942 = (_e479 + _e564.member_3);
let _e953 = type_27(_e564.member, _e564.member_1, _e564.member_2, _e564.member_3, _e942, _e564.member_5, _e564.member_6, _e564.member_7, _e564.member_8, _e564.member_9, _e564.member_10);
let _e965 = type_27(_e953.member, _e953.member_1, _e953.member_2, _e953.member_3, _e953.member_4, _e953.member_5, _e564.member_2, _e953.member_7, _e953.member_8, _e953.member_9, _e953.member_10);
if (_e564.member_2 >= 0i) {
let _e967 = (_e564.member_2 * 19i);
let _e968 = (_e967 + 18i);
let _e970 = (bitcast<i32>(_e76) - 1i);
let _e972 = select(_e970, _e968, (_e968 < _e970));
let _e978 = global_2.member[bitcast<u32>(select(0i, _e972, (_e972 > 0i)))];
let _e985 = select(0i, select(select(i32(_e978), i32(-2147483648), (_e978 < -2147483600f)), 2147483647i, (_e978 > 2147483500f)), (_e978 == _e978));
let _e986 = (_e985 * 4i);
let _e988 = (bitcast<i32>(_e78) - 1i);
let _e990 = select(_e988, _e986, (_e986 < _e988));
let _e996 = global_3.member[bitcast<u32>(select(0i, _e990, (_e990 > 0i)))];
let _e998 = select(_e996, 1f, (_e985 == 16i));
let _e999 = (_e998 > 0f);
let _e1007 = select(_e970, _e967, (_e967 < _e970));
let _e1013 = global_2.member[bitcast<u32>(select(0i, _e1007, (_e1007 > 0i)))];
let _e1014 = (_e967 + 1i);
let _e1016 = select(_e970, _e1014, (_e1014 < _e970));
let _e1022 = global_2.member[bitcast<u32>(select(0i, _e1016, (_e1016 > 0i)))];
let _e1023 = (_e967 + 2i);
let _e1025 = select(_e970, _e1023, (_e1023 < _e970));
let _e1031 = global_2.member[bitcast<u32>(select(0i, _e1025, (_e1025 > 0i)))];
let _e1032 = (_e967 + 3i);
let _e1034 = select(_e970, _e1032, (_e1032 < _e970));
let _e1040 = global_2.member[bitcast<u32>(select(0i, _e1034, (_e1034 > 0i)))];
let _e1041 = (_e967 + 4i);
let _e1043 = select(_e970, _e1041, (_e1041 < _e970));
let _e1049 = global_2.member[bitcast<u32>(select(0i, _e1043, (_e1043 > 0i)))];
let _e1050 = (_e967 + 5i);
let _e1052 = select(_e970, _e1050, (_e1050 < _e970));
let _e1058 = global_2.member[bitcast<u32>(select(0i, _e1052, (_e1052 > 0i)))];
let _e1059 = (_e1040 - _e1013);
let _e1060 = (_e1049 - _e1022);
let _e1061 = (_e1058 - _e1031);
let _e1062 = (_e967 + 6i);
let _e1064 = select(_e970, _e1062, (_e1062 < _e970));
let _e1070 = global_2.member[bitcast<u32>(select(0i, _e1064, (_e1064 > 0i)))];
let _e1071 = (_e967 + 7i);
let _e1073 = select(_e970, _e1071, (_e1071 < _e970));
let _e1079 = global_2.member[bitcast<u32>(select(0i, _e1073, (_e1073 > 0i)))];
let _e1080 = (_e967 + 8i);
let _e1082 = select(_e970, _e1080, (_e1080 < _e970));
let _e1088 = global_2.member[bitcast<u32>(select(0i, _e1082, (_e1082 > 0i)))];
let _e1089 = (_e1070 - _e1013);
let _e1090 = (_e1079 - _e1022);
let _e1091 = (_e1088 - _e1031);
let _e1094 = ((_e1060 * _e1091) - (_e1061 * _e1090));
let _e1097 = ((_e1061 * _e1089) - (_e1059 * _e1091));
let _e1100 = ((_e1059 * _e1090) - (_e1060 * _e1089));
let _e1105 = (((_e1094 * _e1094) + (_e1097 * _e1097)) + (_e1100 * _e1100));
let _e1117 = (1f / select(1e-30f, _e1105, (_e1105 > 1e-30f)));
let _e1133 = (_e967 + 9i);
let _e1135 = select(_e970, _e1133, (_e1133 < _e970));
let _e1141 = global_2.member[bitcast<u32>(select(0i, _e1135, (_e1135 > 0i)))];
let _e1142 = (_e967 + 10i);
let _e1144 = select(_e970, _e1142, (_e1142 < _e970));
let _e1150 = global_2.member[bitcast<u32>(select(0i, _e1144, (_e1144 > 0i)))];
let _e1151 = (_e967 + 11i);
let _e1153 = select(_e970, _e1151, (_e1151 < _e970));
let _e1159 = global_2.member[bitcast<u32>(select(0i, _e1153, (_e1153 > 0i)))];
let _e1160 = (_e967 + 12i);
let _e1162 = select(_e970, _e1160, (_e1160 < _e970));
let _e1168 = global_2.member[bitcast<u32>(select(0i, _e1162, (_e1162 > 0i)))];
let _e1169 = (_e967 + 13i);
let _e1171 = select(_e970, _e1169, (_e1169 < _e970));
let _e1177 = global_2.member[bitcast<u32>(select(0i, _e1171, (_e1171 > 0i)))];
let _e1178 = (_e967 + 14i);
let _e1180 = select(_e970, _e1178, (_e1178 < _e970));
let _e1186 = global_2.member[bitcast<u32>(select(0i, _e1180, (_e1180 > 0i)))];
let _e1190 = (_e967 + 15i);
let _e1192 = select(_e970, _e1190, (_e1190 < _e970));
let _e1198 = global_2.member[bitcast<u32>(select(0i, _e1192, (_e1192 > 0i)))];
let _e1199 = (_e967 + 16i);
let _e1201 = select(_e970, _e1199, (_e1199 < _e970));
let _e1207 = global_2.member[bitcast<u32>(select(0i, _e1201, (_e1201 > 0i)))];
let _e1208 = (_e967 + 17i);
let _e1210 = select(_e970, _e1208, (_e1208 < _e970));
let _e1216 = global_2.member[bitcast<u32>(select(0i, _e1210, (_e1210 > 0i)))];
let _e1220 = ((_e404 + (_e397 * _e942)) - _e1013);
let _e1221 = ((_e405 + (_e398 * _e942)) - _e1022);
let _e1222 = ((_e406 + (_e399 * _e942)) - _e1031);
let _e1227 = ((((((_e1090 * _e1100) - (_e1091 * _e1097)) * _e1117) * _e1220) + ((((_e1091 * _e1094) - (_e1089 * _e1100)) * _e1117) * _e1221)) + ((((_e1089 * _e1097) - (_e1090 * _e1094)) * _e1117) * _e1222));
let _e1238 = ((((((_e1097 * _e1061) - (_e1100 * _e1060)) * _e1117) * _e1220) + ((((_e1100 * _e1059) - (_e1094 * _e1061)) * _e1117) * _e1221)) + ((((_e1094 * _e1060) - (_e1097 * _e1059)) * _e1117) * _e1222));
let _e1242 = ((_e1141 + ((_e1168 - _e1141) * _e1227)) + ((_e1198 - _e1141) * _e1238));
let _e1243 = ((_e1150 + ((_e1177 - _e1150) * _e1227)) + ((_e1207 - _e1150) * _e1238));
let _e1244 = ((_e1159 + ((_e1186 - _e1159) * _e1227)) + ((_e1216 - _e1159) * _e1238));
let _e1249 = (((_e1242 * _e1242) + (_e1243 * _e1243)) + (_e1244 * _e1244));
let _e1252 = sqrt(select(0f, _e1249, (_e1249 > 0f)));
let _e1255 = (1f / select(1e-20f, _e1252, (_e1252 > 1e-20f)));
let _e1258 = sqrt(select(0f, _e1105, (_e1105 > 0f)));
let _e1261 = (1f / select(1e-20f, _e1258, (_e1258 > 1e-20f)));
let _e1262 = (_e1094 * _e1261);
let _e1263 = (_e1097 * _e1261);
let _e1264 = (_e1100 * _e1261);
let _e1265 = (_e1242 * _e1255);
let _e1266 = (_e1243 * _e1255);
let _e1267 = (_e1244 * _e1255);
let _e1275 = select(1f, -1f, ((((_e397 * _e1265) + (_e398 * _e1266)) + (_e399 * _e1267)) > 0f));
let _e1276 = (_e1265 * _e1275);
let _e1277 = (_e1266 * _e1275);
let _e1278 = (_e1267 * _e1275);
let _e1284 = -((((_e397 * _e1276) + (_e398 * _e1277)) + (_e399 * _e1278)));
let _e1286 = select(0f, _e1284, (_e1284 > 0f));
let _e1287 = (1f / select(1f, _e998, _e999));
let _e1292 = (1f - ((_e1287 * _e1287) * (1f - (_e1286 * _e1286))));
let _e1293 = (_e1292 <= 0f);
let _e1301 = ((_e1287 * _e1286) - sqrt(select(0f, _e1292, (_e1292 > 0f))));
let _e1308 = (2f * _e1286);
let _e1312 = (_e397 + (_e1276 * _e1308));
let _e1313 = (_e398 + (_e1277 * _e1308));
let _e1314 = (_e399 + (_e1278 * _e1308));
let _e1315 = select(((_e397 * _e1287) + (_e1276 * _e1301)), _e1312, _e1293);
let _e1316 = select(((_e398 * _e1287) + (_e1277 * _e1301)), _e1313, _e1293);
let _e1317 = select(((_e399 * _e1287) + (_e1278 * _e1301)), _e1314, _e1293);
let _e1322 = (((_e1315 * _e1315) + (_e1316 * _e1316)) + (_e1317 * _e1317));
let _e1325 = sqrt(select(0f, _e1322, (_e1322 > 0f)));
let _e1328 = (1f / select(1e-20f, _e1325, (_e1325 > 1e-20f)));
let _e1336 = (((_e397 * _e1262) + (_e398 * _e1263)) + (_e399 * _e1264));
let _e1363 = !((((((((_e1265 * _e397) + (_e1266 * _e398)) + (_e1267 * _e399)) * _e1336) > 0f) && (((((((_e1315 * _e1328) * _e1262) + ((_e1316 * _e1328) * _e1263)) + ((_e1317 * _e1328) * _e1264)) * select(1f, -1f, _e1293)) * _e1336) > 0f)) && ((-((((_e1312 * _e1262) + (_e1313 * _e1263)) + (_e1314 * _e1264))) * _e1336) > 0f)));
let _e1364 = select(_e1265, _e1262, _e1363);
let _e1365 = select(_e1266, _e1263, _e1363);
let _e1366 = select(_e1267, _e1264, _e1363);
let _e1373 = select(1f, -1f, ((((_e1364 * _e397) + (_e1365 * _e398)) + (_e1366 * _e399)) > 0f));
let _e1388 = type_27(_e965.member, _e965.member_1, _e965.member_2, _e965.member_3, _e965.member_4, vec3<f32>((_e1364 * _e1373), (_e1365 * _e1373), (_e1366 * _e1373)), _e965.member_6, _e965.member_7, _e965.member_8, _e965.member_9, _e965.member_10);
let _e1399 = type_27(_e1388.member, _e1388.member_1, _e1388.member_2, _e1388.member_3, _e1388.member_4, _e1388.member_5, _e1388.member_6, _e985, _e1388.member_8, _e1388.member_9, _e1388.member_10);
phi_2510_ = _e1399;
phi_2511_ = _e1399;
phi_2512_ = select(true, false, _e999);
} else {
phi_2510_ = type_27();
phi_2511_ = _e965;
phi_2512_ = true;
}
let _e1402 = phi_2510_;
let _e1404 = phi_2511_;
let _e1406 = phi_2512_;
if _e1406 {
phi_2516_ = _e1404;
} else {
phi_2516_ = _e1402;
}
let _e1408 = phi_2516_;
let _e1420 = type_27(select(2f, 3f, _e1406), _e1408.member_1, _e1408.member_2, _e1408.member_3, _e1408.member_4, _e1408.member_5, _e1408.member_6, _e1408.member_7, _e1408.member_8, _e1408.member_9, _e1408.member_10);
let _e1431 = type_27(_e1420.member, 0i, _e1420.member_2, _e1420.member_3, _e1420.member_4, _e1420.member_5, _e1420.member_6, _e1420.member_7, _e1420.member_8, _e1420.member_9, _e1420.member_10);
let _e1442 = type_27(_e1431.member, _e1431.member_1, -1i, _e1431.member_3, _e1431.member_4, _e1431.member_5, _e1431.member_6, _e1431.member_7, _e1431.member_8, _e1431.member_9, _e1431.member_10);
phi_3024_ = type_27(_e1442.member, _e1442.member_1, _e1442.member_2, (_e474 - _e479), _e1442.member_4, _e1442.member_5, _e1442.member_6, _e1442.member_7, _e1442.member_8, _e1442.member_9, _e1442.member_10);
} else {
let _e585 = type_27(3f, _e564.member_1, _e564.member_2, _e564.member_3, _e564.member_4, _e564.member_5, _e564.member_6, _e564.member_7, _e564.member_8, _e564.member_9, _e564.member_10);
if (_e564.member_2 >= 0i) {
let _e589 = (_e474 - _e564.member_3);
let _e600 = type_27(_e585.member, _e585.member_1, _e585.member_2, _e585.member_3, _e585.member_4, _e585.member_5, _e585.member_6, _e585.member_7, _e589, _e585.member_9, _e585.member_10);
let _e601 = (_e564.member_2 * 19i);
let _e602 = (_e601 + 18i);
let _e604 = (bitcast<i32>(_e76) - 1i);
let _e606 = select(_e604, _e602, (_e602 < _e604));
let _e612 = global_2.member[bitcast<u32>(select(0i, _e606, (_e606 > 0i)))];
let _e630 = type_27(_e600.member, _e600.member_1, _e600.member_2, _e600.member_3, _e600.member_4, _e600.member_5, _e600.member_6, _e600.member_7, _e600.member_8, _e600.member_9, select(0i, select(select(i32(_e612), i32(-2147483648), (_e612 < -2147483600f)), 2147483647i, (_e612 > 2147483500f)), (_e612 == _e612)));
let _e638 = select(_e604, _e601, (_e601 < _e604));
let _e644 = global_2.member[bitcast<u32>(select(0i, _e638, (_e638 > 0i)))];
let _e645 = (_e601 + 1i);
let _e647 = select(_e604, _e645, (_e645 < _e604));
let _e653 = global_2.member[bitcast<u32>(select(0i, _e647, (_e647 > 0i)))];
let _e654 = (_e601 + 2i);
let _e656 = select(_e604, _e654, (_e654 < _e604));
let _e662 = global_2.member[bitcast<u32>(select(0i, _e656, (_e656 > 0i)))];
let _e663 = (_e601 + 3i);
let _e665 = select(_e604, _e663, (_e663 < _e604));
let _e671 = global_2.member[bitcast<u32>(select(0i, _e665, (_e665 > 0i)))];
let _e672 = (_e601 + 4i);
let _e674 = select(_e604, _e672, (_e672 < _e604));
let _e680 = global_2.member[bitcast<u32>(select(0i, _e674, (_e674 > 0i)))];
let _e681 = (_e601 + 5i);
let _e683 = select(_e604, _e681, (_e681 < _e604));
let _e689 = global_2.member[bitcast<u32>(select(0i, _e683, (_e683 > 0i)))];
let _e690 = (_e671 - _e644);
let _e691 = (_e680 - _e653);
let _e692 = (_e689 - _e662);
let _e693 = (_e601 + 6i);
let _e695 = select(_e604, _e693, (_e693 < _e604));
let _e701 = global_2.member[bitcast<u32>(select(0i, _e695, (_e695 > 0i)))];
let _e702 = (_e601 + 7i);
let _e704 = select(_e604, _e702, (_e702 < _e604));
let _e710 = global_2.member[bitcast<u32>(select(0i, _e704, (_e704 > 0i)))];
let _e711 = (_e601 + 8i);
let _e713 = select(_e604, _e711, (_e711 < _e604));
let _e719 = global_2.member[bitcast<u32>(select(0i, _e713, (_e713 > 0i)))];
let _e720 = (_e701 - _e644);
let _e721 = (_e710 - _e653);
let _e722 = (_e719 - _e662);
let _e725 = ((_e691 * _e722) - (_e692 * _e721));
let _e728 = ((_e692 * _e720) - (_e690 * _e722));
let _e731 = ((_e690 * _e721) - (_e691 * _e720));
let _e736 = (((_e725 * _e725) + (_e728 * _e728)) + (_e731 * _e731));
let _e748 = (1f / select(1e-30f, _e736, (_e736 > 1e-30f)));
let _e764 = (_e601 + 9i);
let _e766 = select(_e604, _e764, (_e764 < _e604));
let _e772 = global_2.member[bitcast<u32>(select(0i, _e766, (_e766 > 0i)))];
let _e773 = (_e601 + 10i);
let _e775 = select(_e604, _e773, (_e773 < _e604));
let _e781 = global_2.member[bitcast<u32>(select(0i, _e775, (_e775 > 0i)))];
let _e782 = (_e601 + 11i);
let _e784 = select(_e604, _e782, (_e782 < _e604));
let _e790 = global_2.member[bitcast<u32>(select(0i, _e784, (_e784 > 0i)))];
let _e791 = (_e601 + 12i);
let _e793 = select(_e604, _e791, (_e791 < _e604));
let _e799 = global_2.member[bitcast<u32>(select(0i, _e793, (_e793 > 0i)))];
let _e800 = (_e601 + 13i);
let _e802 = select(_e604, _e800, (_e800 < _e604));
let _e808 = global_2.member[bitcast<u32>(select(0i, _e802, (_e802 > 0i)))];
let _e809 = (_e601 + 14i);
let _e811 = select(_e604, _e809, (_e809 < _e604));
let _e817 = global_2.member[bitcast<u32>(select(0i, _e811, (_e811 > 0i)))];
let _e821 = (_e601 + 15i);
let _e823 = select(_e604, _e821, (_e821 < _e604));
let _e829 = global_2.member[bitcast<u32>(select(0i, _e823, (_e823 > 0i)))];
let _e830 = (_e601 + 16i);
let _e832 = select(_e604, _e830, (_e830 < _e604));
let _e838 = global_2.member[bitcast<u32>(select(0i, _e832, (_e832 > 0i)))];
let _e839 = (_e601 + 17i);
let _e841 = select(_e604, _e839, (_e839 < _e604));
let _e847 = global_2.member[bitcast<u32>(select(0i, _e841, (_e841 > 0i)))];
let _e851 = ((_e404 + (_e397 * _e589)) - _e644);
let _e852 = ((_e405 + (_e398 * _e589)) - _e653);
let _e853 = ((_e406 + (_e399 * _e589)) - _e662);
let _e858 = ((((((_e721 * _e731) - (_e722 * _e728)) * _e748) * _e851) + ((((_e722 * _e725) - (_e720 * _e731)) * _e748) * _e852)) + ((((_e720 * _e728) - (_e721 * _e725)) * _e748) * _e853));
let _e869 = ((((((_e728 * _e692) - (_e731 * _e691)) * _e748) * _e851) + ((((_e731 * _e690) - (_e725 * _e692)) * _e748) * _e852)) + ((((_e725 * _e691) - (_e728 * _e690)) * _e748) * _e853));
let _e873 = ((_e772 + ((_e799 - _e772) * _e858)) + ((_e829 - _e772) * _e869));
let _e874 = ((_e781 + ((_e808 - _e781) * _e858)) + ((_e838 - _e781) * _e869));
let _e875 = ((_e790 + ((_e817 - _e790) * _e858)) + ((_e847 - _e790) * _e869));
let _e880 = (((_e873 * _e873) + (_e874 * _e874)) + (_e875 * _e875));
let _e883 = sqrt(select(0f, _e880, (_e880 > 0f)));
let _e886 = (1f / select(1e-20f, _e883, (_e883 > 1e-20f)));
let _e889 = sqrt(select(0f, _e736, (_e736 > 0f)));
let _e892 = (1f / select(1e-20f, _e889, (_e889 > 1e-20f)));
let _e893 = (_e725 * _e892);
let _e894 = (_e728 * _e892);
let _e895 = (_e731 * _e892);
let _e896 = (_e873 * _e886);
let _e897 = (_e874 * _e886);
let _e898 = (_e875 * _e886);
let _e899 = -(_e397);
let _e900 = -(_e398);
let _e901 = -(_e399);
let _e913 = (((((_e896 * _e899) + (_e897 * _e900)) + (_e898 * _e901)) * (((_e893 * _e899) + (_e894 * _e900)) + (_e895 * _e901))) <= 0f);
let _e914 = select(_e896, _e893, _e913);
let _e915 = select(_e897, _e894, _e913);
let _e916 = select(_e898, _e895, _e913);
let _e923 = select(1f, -1f, ((((_e914 * _e899) + (_e915 * _e900)) + (_e916 * _e901)) > 0f));
phi_3023_ = type_27(_e630.member, _e630.member_1, _e630.member_2, _e630.member_3, _e630.member_4, _e630.member_5, _e630.member_6, _e630.member_7, _e630.member_8, vec3<f32>((_e914 * _e923), (_e915 * _e923), (_e916 * _e923)), _e630.member_10);
} else {
phi_3023_ = _e585;
}
let _e940 = phi_3023_;
phi_3024_ = _e940;
}
let _e1456 = phi_3024_;
phi_3025_ = _e1456;
}
let _e1943 = phi_3025_;
phi_900_ = _e1943;
phi_903_ = (_e566 + 1i);
} else {
phi_900_ = type_27();
phi_903_ = i32();
}
let _e1945 = phi_900_;
let _e1947 = phi_903_;
continue;
continuing {
phi_899_ = _e1945;
phi_902_ = _e1947;
break if !(_e570);
}
}
let _e1950 = local;
let _e1954 = local_1;
let _e1958 = local_2;
let _e1961 = local_3;
let _e1964 = local_4;
let _e1968 = local_5;
let _e1972 = local_6;
let _e1976 = local_7;
let _e1980 = local_8;
let _e1984 = local_9;
let _e1987 = local_10;
let _e1991 = local_11;
let _e1995 = local_12;
let _e1999 = local_13;
let _e2005 = local_14;
global_4.member[_e94] = _e2005;
global_4.member[_e106] = f32(_e1950.member_1);
global_4.member[_e117] = f32(_e1954.member_2);
global_4.member[_e128] = _e1958.member_3;
global_4.member[_e139] = _e1961.member_4;
global_4.member[_e150] = _e1964.member_5.x;
global_4.member[_e161] = _e1968.member_5.y;
global_4.member[_e172] = _e1972.member_5.z;
global_4.member[_e183] = f32(_e1976.member_6);
global_4.member[_e194] = f32(_e1980.member_7);
global_4.member[_e205] = _e1984.member_8;
global_4.member[_e216] = _e1987.member_9.x;
global_4.member[_e227] = _e1991.member_9.y;
global_4.member[_e238] = _e1995.member_9.z;
global_4.member[_e249] = f32(_e1999.member_10);
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
