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
}
struct type_13 {
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
member_20: type_5,
member_21: type_12,
}
struct type_14 {
member: type_13,
}
struct type_16 {
member: array<f32>,
}
struct type_20 {
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
member_13: i32,
member_14: i32,
member_15: f32,
}
struct type_24 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_14;
@group(0) @binding(1)
var<storage> global_2: type_16;
@group(0) @binding(2)
var<storage> global_3: type_16;
@group(0) @binding(3)
var<storage> global_4: type_16;
@group(0) @binding(4)
var<storage> global_5: type_16;
@group(0) @binding(5)
var<storage, read_write> global_6: type_16;
@group(0) @binding(6)
var<storage, read_write> global_7: type_24;
fn function_() {
var local: i32;
var local_1: i32;
var phi_813_: type_20;
var phi_828_: type_20;
var phi_831_: i32;
var phi_1451_: type_20;
var phi_1452_: type_20;
var phi_1484_: i32;
var phi_1552_: type_20;
var phi_829_: type_20;
var phi_832_: i32;
var local_2: bool;
var local_3: type_20;
var local_4: type_20;
var local_5: i32;
var phi_1565_: array<f32, 4>;
var phi_1566_: array<f32, 4>;
var phi_1567_: array<f32, 4>;
var phi_1568_: array<f32, 4>;
var phi_1569_: bool;
var phi_1573_: array<f32, 4>;
let _e61 = global;
let _e68 = arrayLength((&global_4.member));
let _e77 = global_1.member.member;
if (_e61.x < _e77.member) {
if (_e61.y < _e77.member_1) {
let _e84 = (_e77.member * _e77.member_1);
let _e86 = ((_e61.y * _e77.member) + _e61.x);
let _e87 = bitcast<i32>(_e86);
let _e89 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e91 = select(_e89, _e87, (_e87 < _e89));
let _e97 = global_6.member[bitcast<u32>(select(0i, _e91, (_e91 > 0i)))];
let _e98 = (_e84 + _e86);
let _e99 = bitcast<i32>(_e98);
let _e101 = select(_e89, _e99, (_e99 < _e89));
let _e107 = global_6.member[bitcast<u32>(select(0i, _e101, (_e101 > 0i)))];
let _e109 = ((2u * _e84) + _e86);
let _e110 = bitcast<i32>(_e109);
let _e112 = select(_e89, _e110, (_e110 < _e89));
let _e118 = global_6.member[bitcast<u32>(select(0i, _e112, (_e112 > 0i)))];
let _e120 = ((3u * _e84) + _e86);
let _e121 = bitcast<i32>(_e120);
let _e123 = select(_e89, _e121, (_e121 < _e89));
let _e129 = global_6.member[bitcast<u32>(select(0i, _e123, (_e123 > 0i)))];
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
phi_1567_ = array<f32, 4>(_e97, _e107, _e118, _e129);
phi_1568_ = array<f32, 4>();
phi_1569_ = true;
} else {
let _e165 = global_1.member.member.member;
let _e169 = global_1.member.member.member_1;
let _e171 = bitcast<i32>((_e165 * _e169));
let _e175 = bitcast<i32>(((_e61.y * _e165) + _e61.x));
let _e176 = ((21i * _e171) + _e175);
let _e178 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e180 = select(_e178, _e176, (_e176 < _e178));
let _e186 = global_2.member[bitcast<u32>(select(0i, _e180, (_e180 > 0i)))];
let _e187 = (_e186 <= 0f);
if _e187 {
phi_1565_ = array<f32, 4>(2f, 0f, -1f, 1e30f);
phi_1566_ = array<f32, 4>();
} else {
let _e189 = ((20i * _e171) + _e175);
let _e191 = select(_e178, _e189, (_e189 < _e178));
let _e197 = global_2.member[bitcast<u32>(select(0i, _e191, (_e191 > 0i)))];
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
let _e309 = global_2.member[bitcast<u32>(select(0i, _e304, (_e304 > 0i)))];
let _e310 = local_1;
let _e312 = local;
let _e313 = ((10i * _e310) + _e312);
let _e315 = select(_e178, _e313, (_e313 < _e178));
let _e320 = global_2.member[bitcast<u32>(select(0i, _e315, (_e315 > 0i)))];
let _e321 = local_1;
let _e323 = local;
let _e324 = ((11i * _e321) + _e323);
let _e326 = select(_e178, _e324, (_e324 < _e178));
let _e331 = global_2.member[bitcast<u32>(select(0i, _e326, (_e326 > 0i)))];
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
phi_813_ = type_20(_e296, _e344, vec3<f32>(1f, 1f, 1f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), 1e9f, 0f, 16i, 0f, 0f, 0f, 0f, vec3<f32>(0f, 0f, 0f), 0i, select(select(-2i, -3i, _e412), -1i, ((_e377 >= 1e30f) && (_e408 >= 1e30f))), select(_e377, _e408, _e412));
} else {
phi_813_ = type_20(_e296, _e344, vec3<f32>(1f, 1f, 1f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), 1e9f, 0f, 16i, 0f, 0f, 0f, 0f, vec3<f32>(0f, 0f, 0f), select(0i, select(select(i32(_e107), i32(-2147483648), (_e107 < -2147483600f)), 2147483647i, (_e107 > 2147483500f)), (_e107 == _e107)), select(0i, select(select(i32(_e118), i32(-2147483648), (_e118 < -2147483600f)), 2147483647i, (_e118 > 2147483500f)), (_e118 == _e118)), _e129);
}
let _e418 = phi_813_;
let _e419 = bitcast<i32>(arrayLength((&global_3.member)));
phi_828_ = _e418;
phi_831_ = 0i;
loop {
let _e422 = phi_828_;
let _e424 = phi_831_;
local_3 = _e422;
local_4 = _e422;
let _e427 = (_e422.member_13 < (_e419 / 8i));
let _e428 = ((_e424 < 1024i) && _e427);
local_2 = _e427;
local_5 = _e422.member_13;
if _e428 {
let _e433 = (_e422.member_13 * 8i);
let _e437 = bitcast<f32>((bitcast<u32>(_e422.member_1.x) & 2147483647u));
let _e442 = (1f / select(_e422.member_1.x, select(1e-12f, -1e-12f, (_e422.member_1.x < 0f)), (_e437 < 1e-12f)));
let _e446 = bitcast<f32>((bitcast<u32>(_e422.member_1.y) & 2147483647u));
let _e451 = (1f / select(_e422.member_1.y, select(1e-12f, -1e-12f, (_e422.member_1.y < 0f)), (_e446 < 1e-12f)));
let _e455 = bitcast<f32>((bitcast<u32>(_e422.member_1.z) & 2147483647u));
let _e460 = (1f / select(_e422.member_1.z, select(1e-12f, -1e-12f, (_e422.member_1.z < 0f)), (_e455 < 1e-12f)));
let _e462 = (_e419 - 1i);
let _e464 = select(_e462, _e433, (_e433 < _e462));
let _e470 = global_3.member[bitcast<u32>(select(0i, _e464, (_e464 > 0i)))];
let _e471 = (_e433 + 1i);
let _e473 = select(_e462, _e471, (_e471 < _e462));
let _e479 = global_3.member[bitcast<u32>(select(0i, _e473, (_e473 > 0i)))];
let _e480 = (_e433 + 2i);
let _e482 = select(_e462, _e480, (_e480 < _e462));
let _e488 = global_3.member[bitcast<u32>(select(0i, _e482, (_e482 > 0i)))];
let _e489 = (_e433 + 3i);
let _e491 = select(_e462, _e489, (_e489 < _e462));
let _e497 = global_3.member[bitcast<u32>(select(0i, _e491, (_e491 > 0i)))];
let _e498 = (_e433 + 4i);
let _e500 = select(_e462, _e498, (_e498 < _e462));
let _e506 = global_3.member[bitcast<u32>(select(0i, _e500, (_e500 > 0i)))];
let _e507 = (_e433 + 5i);
let _e509 = select(_e462, _e507, (_e507 < _e462));
let _e515 = global_3.member[bitcast<u32>(select(0i, _e509, (_e509 > 0i)))];
let _e518 = ((_e470 - _e422.member.x) * _e442);
let _e520 = ((_e497 - _e422.member.x) * _e442);
let _e523 = ((_e479 - _e422.member.y) * _e451);
let _e525 = ((_e506 - _e422.member.y) * _e451);
let _e528 = ((_e488 - _e422.member.z) * _e460);
let _e530 = ((_e515 - _e422.member.z) * _e460);
let _e532 = select(_e520, _e518, (_e518 < _e520));
let _e534 = select(_e525, _e523, (_e523 < _e525));
let _e536 = select(_e534, _e532, (_e532 > _e534));
let _e538 = select(_e530, _e528, (_e528 < _e530));
let _e542 = select(_e520, _e518, (_e518 > _e520));
let _e544 = select(_e525, _e523, (_e523 > _e525));
let _e546 = select(_e544, _e542, (_e542 < _e544));
let _e548 = select(_e530, _e528, (_e528 > _e530));
let _e550 = select(_e548, _e546, (_e546 < _e548));
let _e555 = ((select(_e538, _e536, (_e536 > _e538)) <= select(_e422.member_15, _e550, (_e550 < _e422.member_15))) && (_e550 >= 0f));
let _e556 = (_e433 + 6i);
let _e558 = select(_e462, _e556, (_e556 < _e462));
let _e564 = global_3.member[bitcast<u32>(select(0i, _e558, (_e558 > 0i)))];
let _e571 = select(0i, select(select(i32(_e564), i32(-2147483648), (_e564 < -2147483600f)), 2147483647i, (_e564 > 2147483500f)), (_e564 == _e564));
if (_e555 && (_e571 >= 0i)) {
let _e576 = ((_e437 >= _e446) && (_e437 >= _e455));
let _e579 = (!(_e576) && (_e446 >= _e455));
let _e586 = (1f / select(select(_e422.member_1.z, _e422.member_1.y, _e579), _e422.member_1.x, _e576));
let _e587 = (select(select(_e422.member_1.x, _e422.member_1.z, _e579), _e422.member_1.y, _e576) * _e586);
let _e588 = (select(select(_e422.member_1.y, _e422.member_1.x, _e579), _e422.member_1.z, _e576) * _e586);
let _e589 = (_e571 * 19i);
let _e591 = (bitcast<i32>(_e68) - 1i);
let _e593 = select(_e591, _e589, (_e589 < _e591));
let _e599 = global_4.member[bitcast<u32>(select(0i, _e593, (_e593 > 0i)))];
let _e600 = (_e589 + 1i);
let _e602 = select(_e591, _e600, (_e600 < _e591));
let _e608 = global_4.member[bitcast<u32>(select(0i, _e602, (_e602 > 0i)))];
let _e609 = (_e589 + 2i);
let _e611 = select(_e591, _e609, (_e609 < _e591));
let _e617 = global_4.member[bitcast<u32>(select(0i, _e611, (_e611 > 0i)))];
let _e618 = (_e599 - _e422.member.x);
let _e619 = (_e608 - _e422.member.y);
let _e620 = (_e617 - _e422.member.z);
let _e626 = select(select(_e620, _e619, _e579), _e618, _e576);
let _e628 = (select(select(_e618, _e620, _e579), _e619, _e576) - (_e587 * _e626));
let _e630 = (select(select(_e619, _e618, _e579), _e620, _e576) - (_e588 * _e626));
let _e632 = (_e589 + 3i);
let _e634 = select(_e591, _e632, (_e632 < _e591));
let _e640 = global_4.member[bitcast<u32>(select(0i, _e634, (_e634 > 0i)))];
let _e641 = (_e589 + 4i);
let _e643 = select(_e591, _e641, (_e641 < _e591));
let _e649 = global_4.member[bitcast<u32>(select(0i, _e643, (_e643 > 0i)))];
let _e650 = (_e589 + 5i);
let _e652 = select(_e591, _e650, (_e650 < _e591));
let _e658 = global_4.member[bitcast<u32>(select(0i, _e652, (_e652 > 0i)))];
let _e659 = (_e640 - _e422.member.x);
let _e660 = (_e649 - _e422.member.y);
let _e661 = (_e658 - _e422.member.z);
let _e667 = select(select(_e661, _e660, _e579), _e659, _e576);
let _e669 = (select(select(_e659, _e661, _e579), _e660, _e576) - (_e587 * _e667));
let _e671 = (select(select(_e660, _e659, _e579), _e661, _e576) - (_e588 * _e667));
let _e673 = (_e589 + 6i);
let _e675 = select(_e591, _e673, (_e673 < _e591));
let _e681 = global_4.member[bitcast<u32>(select(0i, _e675, (_e675 > 0i)))];
let _e682 = (_e589 + 7i);
let _e684 = select(_e591, _e682, (_e682 < _e591));
let _e690 = global_4.member[bitcast<u32>(select(0i, _e684, (_e684 > 0i)))];
let _e691 = (_e589 + 8i);
let _e693 = select(_e591, _e691, (_e691 < _e591));
let _e699 = global_4.member[bitcast<u32>(select(0i, _e693, (_e693 > 0i)))];
let _e700 = (_e681 - _e422.member.x);
let _e701 = (_e690 - _e422.member.y);
let _e702 = (_e699 - _e422.member.z);
let _e708 = select(select(_e702, _e701, _e579), _e700, _e576);
let _e710 = (select(select(_e700, _e702, _e579), _e701, _e576) - (_e587 * _e708));
let _e712 = (select(select(_e701, _e700, _e579), _e702, _e576) - (_e588 * _e708));
let _e716 = ((_e710 * _e671) - (_e712 * _e669));
let _e719 = ((_e628 * _e712) - (_e630 * _e710));
let _e722 = ((_e669 * _e630) - (_e671 * _e628));
let _e724 = ((_e716 + _e719) + _e722);
let _e738 = (!(((((_e716 < 0f) || (_e719 < 0f)) || (_e722 < 0f)) && (((_e716 > 0f) || (_e719 > 0f)) || (_e722 > 0f)))) && (_e724 != 0f));
let _e745 = ((((_e716 * (_e626 * _e586)) + (_e719 * (_e667 * _e586))) + (_e722 * (_e708 * _e586))) / select(1f, _e724, _e738));
let _e748 = select(1e30f, _e745, (_e738 && (_e745 > 1e-3f)));
if (_e748 < _e422.member_15) {
let _e765 = type_20(_e422.member, _e422.member_1, _e422.member_2, _e422.member_3, _e422.member_4, _e422.member_5, _e422.member_6, _e422.member_7, _e422.member_8, _e422.member_9, _e422.member_10, _e422.member_11, _e422.member_12, _e422.member_13, _e422.member_14, _e748);
phi_1451_ = type_20(_e765.member, _e765.member_1, _e765.member_2, _e765.member_3, _e765.member_4, _e765.member_5, _e765.member_6, _e765.member_7, _e765.member_8, _e765.member_9, _e765.member_10, _e765.member_11, _e765.member_12, _e765.member_13, _e571, _e765.member_15);
} else {
phi_1451_ = _e422;
}
let _e783 = phi_1451_;
phi_1452_ = _e783;
} else {
phi_1452_ = _e422;
}
let _e785 = phi_1452_;
if _e555 {
phi_1484_ = (_e785.member_13 + 1i);
} else {
let _e786 = (_e433 + 7i);
let _e788 = select(_e462, _e786, (_e786 < _e462));
let _e794 = global_3.member[bitcast<u32>(select(0i, _e788, (_e788 > 0i)))];
phi_1484_ = select(0i, select(select(i32(_e794), i32(-2147483648), (_e794 < -2147483600f)), 2147483647i, (_e794 > 2147483500f)), (_e794 == _e794));
}
let _e805 = phi_1484_;
let _e821 = type_20(_e785.member, _e785.member_1, _e785.member_2, _e785.member_3, _e785.member_4, _e785.member_5, _e785.member_6, _e785.member_7, _e785.member_8, _e785.member_9, _e785.member_10, _e785.member_11, _e785.member_12, _e805, _e785.member_14, _e785.member_15);
let _e823 = (_e785.member_14 != _e422.member_14);
let _e826 = ((select(0i, _e785.member_14, _e823) * 19i) + 18i);
let _e828 = (bitcast<i32>(_e68) - 1i);
let _e830 = select(_e828, _e826, (_e826 < _e828));
let _e836 = global_4.member[bitcast<u32>(select(0i, _e830, (_e830 > 0i)))];
let _e843 = select(0i, select(select(i32(_e836), i32(-2147483648), (_e836 < -2147483600f)), 2147483647i, (_e836 > 2147483500f)), (_e836 == _e836));
let _e844 = (_e843 * 4i);
let _e846 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e848 = select(_e846, _e844, (_e844 < _e846));
let _e854 = global_5.member[bitcast<u32>(select(0i, _e848, (_e848 > 0i)))];
if (_e823 && (select(_e854, 1f, (_e843 == 16i)) != 0f)) {
let _e874 = type_20(_e821.member, _e821.member_1, _e821.member_2, _e821.member_3, _e821.member_4, _e821.member_5, _e821.member_6, _e821.member_7, _e821.member_8, _e821.member_9, _e821.member_10, _e821.member_11, _e821.member_12, _e821.member_13, _e422.member_14, _e821.member_15);
phi_1552_ = type_20(_e874.member, _e874.member_1, _e874.member_2, _e874.member_3, _e874.member_4, _e874.member_5, _e874.member_6, _e874.member_7, _e874.member_8, _e874.member_9, _e874.member_10, _e874.member_11, _e874.member_12, _e874.member_13, _e874.member_14, _e422.member_15);
} else {
phi_1552_ = _e821;
}
let _e892 = phi_1552_;
phi_829_ = _e892;
phi_832_ = (_e424 + 1i);
} else {
phi_829_ = type_20();
phi_832_ = i32();
}
let _e894 = phi_829_;
let _e896 = phi_832_;
continue;
continuing {
phi_828_ = _e894;
phi_831_ = _e896;
break if !(_e428);
}
}
let _e899 = local_2;
let _e902 = local_3;
let _e905 = local_4;
let _e908 = local_5;
phi_1565_ = array<f32, 4>();
phi_1566_ = array<f32, 4>(select(2f, 1f, _e899), f32(_e908), f32(_e902.member_14), _e905.member_15);
}
let _e913 = phi_1565_;
let _e915 = phi_1566_;
phi_1567_ = _e913;
phi_1568_ = _e915;
phi_1569_ = _e187;
}
let _e917 = phi_1567_;
let _e919 = phi_1568_;
let _e921 = phi_1569_;
if _e921 {
phi_1573_ = _e917;
} else {
phi_1573_ = _e919;
}
let _e923 = phi_1573_;
global_6.member[_e86] = _e923[0];
global_6.member[_e98] = _e923[1];
global_6.member[_e109] = _e923[2];
global_6.member[_e120] = _e923[3];
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
