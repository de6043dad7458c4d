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
member: type_2,
member_1: u32,
member_2: type_5,
member_3: type_7,
member_4: type_7,
member_5: type_7,
member_6: type_7,
member_7: type_5,
member_8: f32,
member_9: f32,
member_10: f32,
member_11: u32,
member_12: u32,
member_13: u32,
}
struct type_14 {
member: u32,
member_1: u32,
}
struct type_15 {
member: type_14,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
}
struct type_16 {
member: type_5,
member_1: f32,
member_2: f32,
}
struct type_17 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: u32,
member_4: type_14,
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
member_17: type_14,
member_18: type_15,
member_19: type_5,
member_20: type_16,
member_21: f32,
member_22: f32,
member_23: f32,
member_24: f32,
}
struct type_18 {
member: type_2,
member_1: u32,
member_2: type_2,
member_3: u32,
member_4: type_2,
member_5: u32,
member_6: type_4,
member_7: type_5,
member_8: type_5,
member_9: type_5,
member_10: type_5,
member_11: f32,
member_12: f32,
member_13: f32,
member_14: type_5,
member_15: type_5,
member_16: type_6,
member_17: type_5,
member_18: type_9,
member_19: type_11,
member_20: type_12,
member_21: type_13,
member_22: type_17,
}
struct type_19 {
member: type_18,
}
struct type_21 {
member: array<f32>,
}
struct type_25 {
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
struct type_29 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_19;
@group(0) @binding(4)
var<storage> global_2: type_21;
@group(0) @binding(5)
var<storage, read_write> global_3: type_21;
@group(0) @binding(1)
var<storage> global_4: type_21;
@group(0) @binding(3)
var<storage> global_5: type_21;
@group(0) @binding(2)
var<storage> global_6: type_21;
@group(0) @binding(6)
var<storage, read_write> global_7: type_29;
fn function_() {
var local: i32;
var local_1: i32;
var phi_819_: type_25;
var phi_834_: type_25;
var phi_837_: i32;
var phi_1129_: i32;
var phi_1496_: type_25;
var phi_1497_: type_25;
var phi_1564_: type_25;
var phi_835_: type_25;
var phi_838_: i32;
var local_2: bool;
var local_3: type_25;
var local_4: type_25;
var local_5: i32;
var phi_1577_: array<f32, 4>;
var phi_1578_: array<f32, 4>;
var phi_1579_: array<f32, 4>;
var phi_1580_: array<f32, 4>;
var phi_1581_: bool;
var phi_1585_: array<f32, 4>;
let _e61 = global;
let _e68 = arrayLength((&global_5.member));
let _e77 = global_1.member.member;
if (_e61.x < _e77.member) {
if (_e61.y < _e77.member_1) {
let _e84 = (_e77.member * _e77.member_1);
let _e86 = ((_e61.y * _e77.member) + _e61.x);
let _e87 = bitcast<i32>(_e86);
let _e89 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e91 = select(_e89, _e87, (_e87 < _e89));
let _e97 = global_3.member[bitcast<u32>(select(0i, _e91, (_e91 > 0i)))];
let _e98 = (_e84 + _e86);
let _e99 = bitcast<i32>(_e98);
let _e101 = select(_e89, _e99, (_e99 < _e89));
let _e107 = global_3.member[bitcast<u32>(select(0i, _e101, (_e101 > 0i)))];
let _e109 = ((2u * _e84) + _e86);
let _e110 = bitcast<i32>(_e109);
let _e112 = select(_e89, _e110, (_e110 < _e89));
let _e118 = global_3.member[bitcast<u32>(select(0i, _e112, (_e112 > 0i)))];
let _e120 = ((3u * _e84) + _e86);
let _e121 = bitcast<i32>(_e120);
let _e123 = select(_e89, _e121, (_e121 < _e89));
let _e129 = global_3.member[bitcast<u32>(select(0i, _e123, (_e123 > 0i)))];
let _e131 = (_e97 == 2f);
let _e132 = select(3u, 0u, _e131);
if (_e132 > 0u) {
if (arrayLength((&global_7.member)) >= 3u) {
let _e141 = atomicLoad((&global_7.member[0u]));
if (_e141 == 0u) {
atomicStore((&global_7.member[0u]), ((_e77.member + 7u) / 8u));
atomicStore((&global_7.member[1u]), ((_e77.member_1 + 7u) / 8u));
atomicStore((&global_7.member[2u]), 1u);
}
}
}
if (_e132 > 1u) {
if _e131 {
phi_1579_ = array<f32, 4>(_e97, _e107, _e118, _e129);
phi_1580_ = array<f32, 4>();
phi_1581_ = true;
} else {
let _e165 = global_1.member.member.member;
let _e169 = global_1.member.member.member_1;
let _e171 = bitcast<i32>((_e165 * _e169));
let _e175 = bitcast<i32>(((_e61.y * _e165) + _e61.x));
let _e176 = ((21i * _e171) + _e175);
let _e178 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e180 = select(_e178, _e176, (_e176 < _e178));
let _e186 = global_4.member[bitcast<u32>(select(0i, _e180, (_e180 > 0i)))];
let _e187 = (_e186 <= 0f);
if _e187 {
phi_1577_ = array<f32, 4>(2f, 0f, -1f, 1e30f);
phi_1578_ = array<f32, 4>();
} else {
let _e189 = ((20i * _e171) + _e175);
let _e191 = select(_e178, _e189, (_e189 < _e178));
let _e197 = global_4.member[bitcast<u32>(select(0i, _e191, (_e191 > 0i)))];
let _e198 = bitcast<i32>(_e61.x);
let _e199 = bitcast<i32>(_e61.y);
let _e200 = bitcast<i32>(_e165);
let _e212 = global_1.member.member_6.member;
let _e213 = (((((f32(_e198) + 0.5f) / f32(_e200)) * 2f) - 1f) * _e212);
let _e222 = global_1.member.member_6.member_1;
let _e223 = ((1f - (((f32(_e199) + 0.5f) / f32(bitcast<i32>(_e169))) * 2f)) * _e222);
let _e226 = global_1.member.member_7;
let _e235 = global_1.member.member_8;
let _e242 = ((_e226.member * _e213) + (_e235.member * _e223));
let _e243 = ((_e226.member_1 * _e213) + (_e235.member_1 * _e223));
let _e244 = ((_e226.member_2 * _e213) + (_e235.member_2 * _e223));
let _e248 = global_1.member.member_6.member_3;
let _e250 = select(1f, 0f, (_e248 != 0u));
let _e251 = (1f - _e250);
let _e257 = global_1.member.member_10;
let _e266 = global_1.member.member_9;
let _e273 = (_e266.member + (_e242 * _e250));
let _e274 = (_e266.member_1 + (_e243 * _e250));
let _e275 = (_e266.member_2 + (_e244 * _e250));
let _e280 = (((_e273 * _e273) + (_e274 * _e274)) + (_e275 * _e275));
let _e283 = sqrt(select(0f, _e280, (_e280 > 0f)));
let _e286 = (1f / select(1e-20f, _e283, (_e283 > 1e-20f)));
let _e287 = (_e273 * _e286);
let _e288 = (_e274 * _e286);
let _e289 = (_e275 * _e286);
let _e293 = ((_e257.member + (_e242 * _e251)) + (_e287 * _e197));
let _e294 = ((_e257.member_1 + (_e243 * _e251)) + (_e288 * _e197));
let _e295 = ((_e257.member_2 + (_e244 * _e251)) + (_e289 * _e197));
let _e296 = vec3<f32>(_e293, _e294, _e295);
local = ((_e199 * _e200) + _e198);
local_1 = _e171;
let _e299 = local_1;
let _e301 = local;
let _e302 = ((9i * _e299) + _e301);
let _e304 = select(_e178, _e302, (_e302 < _e178));
let _e309 = global_4.member[bitcast<u32>(select(0i, _e304, (_e304 > 0i)))];
let _e310 = local_1;
let _e312 = local;
let _e313 = ((10i * _e310) + _e312);
let _e315 = select(_e178, _e313, (_e313 < _e178));
let _e320 = global_4.member[bitcast<u32>(select(0i, _e315, (_e315 > 0i)))];
let _e321 = local_1;
let _e323 = local;
let _e324 = ((11i * _e321) + _e323);
let _e326 = select(_e178, _e324, (_e324 < _e178));
let _e331 = global_4.member[bitcast<u32>(select(0i, _e326, (_e326 > 0i)))];
let _e337 = (2f * (((_e287 * _e309) + (_e288 * _e320)) + (_e289 * _e331)));
let _e341 = (_e287 - (_e309 * _e337));
let _e342 = (_e288 - (_e320 * _e337));
let _e343 = (_e289 - (_e331 * _e337));
let _e344 = vec3<f32>(_e341, _e342, _e343);
if (_e97 == 0f) {
let _e351 = global_1.member.member_18.member.member;
let _e362 = ((((_e351.member.member * _e293) + (_e351.member.member_1 * _e294)) + (_e351.member.member_2 * _e295)) + _e351.member_1);
let _e368 = -((((_e351.member.member * _e341) + (_e351.member.member_1 * _e342)) + (_e351.member.member_2 * _e343)));
let _e370 = (_e368 > 1e-9f);
let _e374 = ((_e362 / select(1e-9f, _e368, _e370)) - 0.015625f);
let _e377 = select(1e30f, select(0f, _e374, (_e374 > 0f)), ((_e362 > 0f) && _e370));
let _e382 = global_1.member.member_18.member_1.member;
let _e393 = ((((_e382.member.member * _e293) + (_e382.member.member_1 * _e294)) + (_e382.member.member_2 * _e295)) + _e382.member_1);
let _e399 = -((((_e382.member.member * _e341) + (_e382.member.member_1 * _e342)) + (_e382.member.member_2 * _e343)));
let _e401 = (_e399 > 1e-9f);
let _e405 = ((_e393 / select(1e-9f, _e399, _e401)) - 0.015625f);
let _e408 = select(1e30f, select(0f, _e405, (_e405 > 0f)), ((_e393 > 0f) && _e401));
let _e412 = (_e408 < _e377);
phi_819_ = type_25(_e296, _e344, vec3<f32>(1f, 1f, 1f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), 1e9f, 0f, 16i, 0f, 0f, 0f, 0f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), 0i, 0i, select(select(-2i, -3i, _e412), -1i, ((_e377 >= 1e30f) && (_e408 >= 1e30f))), select(_e377, _e408, _e412));
} else {
phi_819_ = type_25(_e296, _e344, vec3<f32>(1f, 1f, 1f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), 1e9f, 0f, 16i, 0f, 0f, 0f, 0f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), 0i, select(0i, select(select(i32(_e107), i32(-2147483648), (_e107 < -2147483600f)), 2147483647i, (_e107 > 2147483500f)), (_e107 == _e107)), select(0i, select(select(i32(_e118), i32(-2147483648), (_e118 < -2147483600f)), 2147483647i, (_e118 > 2147483500f)), (_e118 == _e118)), _e129);
}
let _e418 = phi_819_;
let _e419 = bitcast<i32>(arrayLength((&global_6.member)));
phi_834_ = _e418;
phi_837_ = 0i;
loop {
let _e422 = phi_834_;
let _e424 = phi_837_;
local_3 = _e422;
local_4 = _e422;
let _e427 = (_e422.member_15 < (_e419 / 8i));
let _e428 = ((_e424 < 1024i) && _e427);
local_2 = _e427;
local_5 = _e422.member_15;
if _e428 {
let _e438 = (_e422.member_15 * 8i);
let _e446 = (1f / select(_e422.member_1.x, select(1e-12f, -1e-12f, (_e422.member_1.x < 0f)), (bitcast<f32>((bitcast<u32>(_e422.member_1.x) & 2147483647u)) < 1e-12f)));
let _e454 = (1f / select(_e422.member_1.y, select(1e-12f, -1e-12f, (_e422.member_1.y < 0f)), (bitcast<f32>((bitcast<u32>(_e422.member_1.y) & 2147483647u)) < 1e-12f)));
let _e462 = (1f / select(_e422.member_1.z, select(1e-12f, -1e-12f, (_e422.member_1.z < 0f)), (bitcast<f32>((bitcast<u32>(_e422.member_1.z) & 2147483647u)) < 1e-12f)));
let _e464 = (_e419 - 1i);
let _e466 = select(_e464, _e438, (_e438 < _e464));
let _e472 = global_6.member[bitcast<u32>(select(0i, _e466, (_e466 > 0i)))];
let _e473 = (_e438 + 1i);
let _e475 = select(_e464, _e473, (_e473 < _e464));
let _e481 = global_6.member[bitcast<u32>(select(0i, _e475, (_e475 > 0i)))];
let _e482 = (_e438 + 2i);
let _e484 = select(_e464, _e482, (_e482 < _e464));
let _e490 = global_6.member[bitcast<u32>(select(0i, _e484, (_e484 > 0i)))];
let _e491 = (_e438 + 3i);
let _e493 = select(_e464, _e491, (_e491 < _e464));
let _e499 = global_6.member[bitcast<u32>(select(0i, _e493, (_e493 > 0i)))];
let _e500 = (_e438 + 4i);
let _e502 = select(_e464, _e500, (_e500 < _e464));
let _e508 = global_6.member[bitcast<u32>(select(0i, _e502, (_e502 > 0i)))];
let _e509 = (_e438 + 5i);
let _e511 = select(_e464, _e509, (_e509 < _e464));
let _e517 = global_6.member[bitcast<u32>(select(0i, _e511, (_e511 > 0i)))];
let _e520 = ((_e472 - _e422.member.x) * _e446);
let _e522 = ((_e499 - _e422.member.x) * _e446);
let _e525 = ((_e481 - _e422.member.y) * _e454);
let _e527 = ((_e508 - _e422.member.y) * _e454);
let _e530 = ((_e490 - _e422.member.z) * _e462);
let _e532 = ((_e517 - _e422.member.z) * _e462);
let _e534 = select(_e522, _e520, (_e520 < _e522));
let _e536 = select(_e527, _e525, (_e525 < _e527));
let _e538 = select(_e536, _e534, (_e534 > _e536));
let _e540 = select(_e532, _e530, (_e530 < _e532));
let _e544 = select(_e522, _e520, (_e520 > _e522));
let _e546 = select(_e527, _e525, (_e525 > _e527));
let _e548 = select(_e546, _e544, (_e544 < _e546));
let _e550 = select(_e532, _e530, (_e530 > _e532));
let _e552 = select(_e550, _e548, (_e548 < _e550));
let _e557 = ((select(_e540, _e538, (_e538 > _e540)) <= select(_e422.member_17, _e552, (_e552 < _e422.member_17))) && (_e552 >= 0f));
let _e558 = (_e438 + 6i);
let _e560 = select(_e464, _e558, (_e558 < _e464));
let _e566 = global_6.member[bitcast<u32>(select(0i, _e560, (_e560 > 0i)))];
if _e557 {
phi_1129_ = (_e422.member_15 + 1i);
} else {
let _e574 = (_e438 + 7i);
let _e576 = select(_e464, _e574, (_e574 < _e464));
let _e582 = global_6.member[bitcast<u32>(select(0i, _e576, (_e576 > 0i)))];
phi_1129_ = select(0i, select(select(i32(_e582), i32(-2147483648), (_e582 < -2147483600f)), 2147483647i, (_e582 > 2147483500f)), (_e582 == _e582));
}
let _e592 = phi_1129_;
let _e610 = type_25(_e422.member, _e422.member_1, _e422.member_2, _e422.member_3, _e422.member_4, _e422.member_5, _e422.member_6, _e422.member_7, _e422.member_8, _e422.member_9, _e422.member_10, _e422.member_11, _e422.member_12, _e422.member_13, _e422.member_14, _e592, _e422.member_16, _e422.member_17);
let _e611 = select(-1i, select(0i, select(select(i32(_e566), i32(-2147483648), (_e566 < -2147483600f)), 2147483647i, (_e566 > 2147483500f)), (_e566 == _e566)), _e557);
if (_e611 >= 0i) {
let _e617 = bitcast<f32>((bitcast<u32>(_e422.member_1.x) & 2147483647u));
let _e621 = bitcast<f32>((bitcast<u32>(_e422.member_1.y) & 2147483647u));
let _e625 = bitcast<f32>((bitcast<u32>(_e422.member_1.z) & 2147483647u));
let _e628 = ((_e617 >= _e621) && (_e617 >= _e625));
let _e631 = (!(_e628) && (_e621 >= _e625));
let _e638 = (1f / select(select(_e422.member_1.z, _e422.member_1.y, _e631), _e422.member_1.x, _e628));
let _e639 = (select(select(_e422.member_1.x, _e422.member_1.z, _e631), _e422.member_1.y, _e628) * _e638);
let _e640 = (select(select(_e422.member_1.y, _e422.member_1.x, _e631), _e422.member_1.z, _e628) * _e638);
let _e641 = (_e611 * 19i);
let _e643 = (bitcast<i32>(_e68) - 1i);
let _e645 = select(_e643, _e641, (_e641 < _e643));
let _e651 = global_5.member[bitcast<u32>(select(0i, _e645, (_e645 > 0i)))];
let _e652 = (_e641 + 1i);
let _e654 = select(_e643, _e652, (_e652 < _e643));
let _e660 = global_5.member[bitcast<u32>(select(0i, _e654, (_e654 > 0i)))];
let _e661 = (_e641 + 2i);
let _e663 = select(_e643, _e661, (_e661 < _e643));
let _e669 = global_5.member[bitcast<u32>(select(0i, _e663, (_e663 > 0i)))];
let _e670 = (_e651 - _e422.member.x);
let _e671 = (_e660 - _e422.member.y);
let _e672 = (_e669 - _e422.member.z);
let _e678 = select(select(_e672, _e671, _e631), _e670, _e628);
let _e680 = (select(select(_e670, _e672, _e631), _e671, _e628) - (_e639 * _e678));
let _e682 = (select(select(_e671, _e670, _e631), _e672, _e628) - (_e640 * _e678));
let _e684 = (_e641 + 3i);
let _e686 = select(_e643, _e684, (_e684 < _e643));
let _e692 = global_5.member[bitcast<u32>(select(0i, _e686, (_e686 > 0i)))];
let _e693 = (_e641 + 4i);
let _e695 = select(_e643, _e693, (_e693 < _e643));
let _e701 = global_5.member[bitcast<u32>(select(0i, _e695, (_e695 > 0i)))];
let _e702 = (_e641 + 5i);
let _e704 = select(_e643, _e702, (_e702 < _e643));
let _e710 = global_5.member[bitcast<u32>(select(0i, _e704, (_e704 > 0i)))];
let _e711 = (_e692 - _e422.member.x);
let _e712 = (_e701 - _e422.member.y);
let _e713 = (_e710 - _e422.member.z);
let _e719 = select(select(_e713, _e712, _e631), _e711, _e628);
let _e721 = (select(select(_e711, _e713, _e631), _e712, _e628) - (_e639 * _e719));
let _e723 = (select(select(_e712, _e711, _e631), _e713, _e628) - (_e640 * _e719));
let _e725 = (_e641 + 6i);
let _e727 = select(_e643, _e725, (_e725 < _e643));
let _e733 = global_5.member[bitcast<u32>(select(0i, _e727, (_e727 > 0i)))];
let _e734 = (_e641 + 7i);
let _e736 = select(_e643, _e734, (_e734 < _e643));
let _e742 = global_5.member[bitcast<u32>(select(0i, _e736, (_e736 > 0i)))];
let _e743 = (_e641 + 8i);
let _e745 = select(_e643, _e743, (_e743 < _e643));
let _e751 = global_5.member[bitcast<u32>(select(0i, _e745, (_e745 > 0i)))];
let _e752 = (_e733 - _e422.member.x);
let _e753 = (_e742 - _e422.member.y);
let _e754 = (_e751 - _e422.member.z);
let _e760 = select(select(_e754, _e753, _e631), _e752, _e628);
let _e762 = (select(select(_e752, _e754, _e631), _e753, _e628) - (_e639 * _e760));
let _e764 = (select(select(_e753, _e752, _e631), _e754, _e628) - (_e640 * _e760));
let _e768 = ((_e762 * _e723) - (_e764 * _e721));
let _e771 = ((_e680 * _e764) - (_e682 * _e762));
let _e774 = ((_e721 * _e682) - (_e723 * _e680));
let _e776 = ((_e768 + _e771) + _e774);
let _e790 = (!(((((_e768 < 0f) || (_e771 < 0f)) || (_e774 < 0f)) && (((_e768 > 0f) || (_e771 > 0f)) || (_e774 > 0f)))) && (_e776 != 0f));
let _e798 = select(1e30f, ((((_e768 * (_e678 * _e638)) + (_e771 * (_e719 * _e638))) + (_e774 * (_e760 * _e638))) / select(1f, _e776, _e790)), _e790);
let _e800 = select(1e30f, _e798, (_e798 > 1e-3f));
if (_e800 < _e422.member_17) {
let _e819 = type_25(_e610.member, _e610.member_1, _e610.member_2, _e610.member_3, _e610.member_4, _e610.member_5, _e610.member_6, _e610.member_7, _e610.member_8, _e610.member_9, _e610.member_10, _e610.member_11, _e610.member_12, _e610.member_13, _e610.member_14, _e610.member_15, _e610.member_16, _e800);
phi_1496_ = type_25(_e819.member, _e819.member_1, _e819.member_2, _e819.member_3, _e819.member_4, _e819.member_5, _e819.member_6, _e819.member_7, _e819.member_8, _e819.member_9, _e819.member_10, _e819.member_11, _e819.member_12, _e819.member_13, _e819.member_14, _e819.member_15, _e611, _e819.member_17);
} else {
phi_1496_ = _e610;
}
let _e839 = phi_1496_;
phi_1497_ = _e839;
} else {
phi_1497_ = _e610;
}
let _e841 = phi_1497_;
let _e843 = (_e841.member_16 != _e422.member_16);
let _e846 = ((select(0i, _e841.member_16, _e843) * 19i) + 18i);
let _e848 = (bitcast<i32>(_e68) - 1i);
let _e850 = select(_e848, _e846, (_e846 < _e848));
let _e856 = global_5.member[bitcast<u32>(select(0i, _e850, (_e850 > 0i)))];
let _e863 = select(0i, select(select(i32(_e856), i32(-2147483648), (_e856 < -2147483600f)), 2147483647i, (_e856 > 2147483500f)), (_e856 == _e856));
let _e864 = (_e863 * 4i);
let _e866 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e868 = select(_e866, _e864, (_e864 < _e866));
let _e874 = global_2.member[bitcast<u32>(select(0i, _e868, (_e868 > 0i)))];
if (_e843 && (select(_e874, 1f, (_e863 == 16i)) != 0f)) {
let _e896 = type_25(_e841.member, _e841.member_1, _e841.member_2, _e841.member_3, _e841.member_4, _e841.member_5, _e841.member_6, _e841.member_7, _e841.member_8, _e841.member_9, _e841.member_10, _e841.member_11, _e841.member_12, _e841.member_13, _e841.member_14, _e841.member_15, _e422.member_16, _e841.member_17);
phi_1564_ = type_25(_e896.member, _e896.member_1, _e896.member_2, _e896.member_3, _e896.member_4, _e896.member_5, _e896.member_6, _e896.member_7, _e896.member_8, _e896.member_9, _e896.member_10, _e896.member_11, _e896.member_12, _e896.member_13, _e896.member_14, _e896.member_15, _e896.member_16, _e422.member_17);
} else {
phi_1564_ = _e841;
}
let _e916 = phi_1564_;
phi_835_ = _e916;
phi_838_ = (_e424 + 1i);
} else {
phi_835_ = type_25();
phi_838_ = i32();
}
let _e918 = phi_835_;
let _e920 = phi_838_;
continue;
continuing {
phi_834_ = _e918;
phi_837_ = _e920;
break if !(_e428);
}
}
let _e923 = local_2;
let _e926 = local_3;
let _e929 = local_4;
let _e932 = local_5;
phi_1577_ = array<f32, 4>();
phi_1578_ = array<f32, 4>(select(2f, 1f, _e923), f32(_e932), f32(_e926.member_16), _e929.member_17);
}
let _e937 = phi_1577_;
let _e939 = phi_1578_;
phi_1579_ = _e937;
phi_1580_ = _e939;
phi_1581_ = _e187;
}
let _e941 = phi_1579_;
let _e943 = phi_1580_;
let _e945 = phi_1581_;
if _e945 {
phi_1585_ = _e941;
} else {
phi_1585_ = _e943;
}
let _e947 = phi_1585_;
global_3.member[_e86] = _e947[0];
global_3.member[_e98] = _e947[1];
global_3.member[_e109] = _e947[2];
global_3.member[_e120] = _e947[3];
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
