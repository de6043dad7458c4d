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
member_13: vec3<f32>,
member_14: vec3<f32>,
member_15: vec3<f32>,
member_16: vec3<f32>,
member_17: vec3<f32>,
member_18: i32,
member_19: i32,
member_20: i32,
member_21: f32,
}
struct type_24 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_14;
@group(0) @binding(1)
var<storage> global_2: type_16;
@group(0) @binding(3)
var<storage> global_3: type_16;
@group(0) @binding(2)
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
var phi_818_: type_20;
var phi_833_: type_20;
var phi_836_: i32;
var phi_1128_: i32;
var phi_1495_: type_20;
var phi_1496_: type_20;
var phi_1563_: type_20;
var phi_834_: type_20;
var phi_837_: i32;
var local_2: bool;
var local_3: type_20;
var local_4: type_20;
var local_5: i32;
var phi_1576_: array<f32, 4>;
var phi_1577_: array<f32, 4>;
var phi_1578_: array<f32, 4>;
var phi_1579_: array<f32, 4>;
var phi_1580_: bool;
var phi_1584_: array<f32, 4>;
let _e61 = global;
let _e68 = arrayLength((&global_3.member));
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
phi_1578_ = array<f32, 4>(_e97, _e107, _e118, _e129);
phi_1579_ = array<f32, 4>();
phi_1580_ = true;
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
phi_1576_ = array<f32, 4>(2f, 0f, -1f, 1e30f);
phi_1577_ = array<f32, 4>();
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
phi_818_ = type_20(_e296, _e344, vec3<f32>(1f, 1f, 1f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), 1e9f, 0f, 16i, 0f, 0f, 0f, 0f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), 16i, 0i, select(select(-2i, -3i, _e412), -1i, ((_e377 >= 1e30f) && (_e408 >= 1e30f))), select(_e377, _e408, _e412));
} else {
phi_818_ = type_20(_e296, _e344, vec3<f32>(1f, 1f, 1f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), 1e9f, 0f, 16i, 0f, 0f, 0f, 0f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), 16i, select(0i, select(select(i32(_e107), i32(-2147483648), (_e107 < -2147483600f)), 2147483647i, (_e107 > 2147483500f)), (_e107 == _e107)), select(0i, select(select(i32(_e118), i32(-2147483648), (_e118 < -2147483600f)), 2147483647i, (_e118 > 2147483500f)), (_e118 == _e118)), _e129);
}
let _e418 = phi_818_;
let _e419 = bitcast<i32>(arrayLength((&global_4.member)));
phi_833_ = _e418;
phi_836_ = 0i;
loop {
let _e422 = phi_833_;
let _e424 = phi_836_;
local_3 = _e422;
local_4 = _e422;
let _e427 = (_e422.member_19 < (_e419 / 8i));
let _e428 = ((_e424 < 1024i) && _e427);
local_2 = _e427;
local_5 = _e422.member_19;
if _e428 {
let _e438 = (_e422.member_19 * 8i);
let _e446 = (1f / select(_e422.member_1.x, select(1e-12f, -1e-12f, (_e422.member_1.x < 0f)), (bitcast<f32>((bitcast<u32>(_e422.member_1.x) & 2147483647u)) < 1e-12f)));
let _e454 = (1f / select(_e422.member_1.y, select(1e-12f, -1e-12f, (_e422.member_1.y < 0f)), (bitcast<f32>((bitcast<u32>(_e422.member_1.y) & 2147483647u)) < 1e-12f)));
let _e462 = (1f / select(_e422.member_1.z, select(1e-12f, -1e-12f, (_e422.member_1.z < 0f)), (bitcast<f32>((bitcast<u32>(_e422.member_1.z) & 2147483647u)) < 1e-12f)));
let _e464 = (_e419 - 1i);
let _e466 = select(_e464, _e438, (_e438 < _e464));
let _e472 = global_4.member[bitcast<u32>(select(0i, _e466, (_e466 > 0i)))];
let _e473 = (_e438 + 1i);
let _e475 = select(_e464, _e473, (_e473 < _e464));
let _e481 = global_4.member[bitcast<u32>(select(0i, _e475, (_e475 > 0i)))];
let _e482 = (_e438 + 2i);
let _e484 = select(_e464, _e482, (_e482 < _e464));
let _e490 = global_4.member[bitcast<u32>(select(0i, _e484, (_e484 > 0i)))];
let _e491 = (_e438 + 3i);
let _e493 = select(_e464, _e491, (_e491 < _e464));
let _e499 = global_4.member[bitcast<u32>(select(0i, _e493, (_e493 > 0i)))];
let _e500 = (_e438 + 4i);
let _e502 = select(_e464, _e500, (_e500 < _e464));
let _e508 = global_4.member[bitcast<u32>(select(0i, _e502, (_e502 > 0i)))];
let _e509 = (_e438 + 5i);
let _e511 = select(_e464, _e509, (_e509 < _e464));
let _e517 = global_4.member[bitcast<u32>(select(0i, _e511, (_e511 > 0i)))];
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
let _e557 = ((select(_e540, _e538, (_e538 > _e540)) <= select(_e422.member_21, _e552, (_e552 < _e422.member_21))) && (_e552 >= 0f));
let _e558 = (_e438 + 6i);
let _e560 = select(_e464, _e558, (_e558 < _e464));
let _e566 = global_4.member[bitcast<u32>(select(0i, _e560, (_e560 > 0i)))];
if _e557 {
phi_1128_ = (_e422.member_19 + 1i);
} else {
let _e574 = (_e438 + 7i);
let _e576 = select(_e464, _e574, (_e574 < _e464));
let _e582 = global_4.member[bitcast<u32>(select(0i, _e576, (_e576 > 0i)))];
phi_1128_ = select(0i, select(select(i32(_e582), i32(-2147483648), (_e582 < -2147483600f)), 2147483647i, (_e582 > 2147483500f)), (_e582 == _e582));
}
let _e592 = phi_1128_;
let _e614 = type_20(_e422.member, _e422.member_1, _e422.member_2, _e422.member_3, _e422.member_4, _e422.member_5, _e422.member_6, _e422.member_7, _e422.member_8, _e422.member_9, _e422.member_10, _e422.member_11, _e422.member_12, _e422.member_13, _e422.member_14, _e422.member_15, _e422.member_16, _e422.member_17, _e422.member_18, _e592, _e422.member_20, _e422.member_21);
let _e615 = select(-1i, select(0i, select(select(i32(_e566), i32(-2147483648), (_e566 < -2147483600f)), 2147483647i, (_e566 > 2147483500f)), (_e566 == _e566)), _e557);
if (_e615 >= 0i) {
let _e621 = bitcast<f32>((bitcast<u32>(_e422.member_1.x) & 2147483647u));
let _e625 = bitcast<f32>((bitcast<u32>(_e422.member_1.y) & 2147483647u));
let _e629 = bitcast<f32>((bitcast<u32>(_e422.member_1.z) & 2147483647u));
let _e632 = ((_e621 >= _e625) && (_e621 >= _e629));
let _e635 = (!(_e632) && (_e625 >= _e629));
let _e642 = (1f / select(select(_e422.member_1.z, _e422.member_1.y, _e635), _e422.member_1.x, _e632));
let _e643 = (select(select(_e422.member_1.x, _e422.member_1.z, _e635), _e422.member_1.y, _e632) * _e642);
let _e644 = (select(select(_e422.member_1.y, _e422.member_1.x, _e635), _e422.member_1.z, _e632) * _e642);
let _e645 = (_e615 * 19i);
let _e647 = (bitcast<i32>(_e68) - 1i);
let _e649 = select(_e647, _e645, (_e645 < _e647));
let _e655 = global_3.member[bitcast<u32>(select(0i, _e649, (_e649 > 0i)))];
let _e656 = (_e645 + 1i);
let _e658 = select(_e647, _e656, (_e656 < _e647));
let _e664 = global_3.member[bitcast<u32>(select(0i, _e658, (_e658 > 0i)))];
let _e665 = (_e645 + 2i);
let _e667 = select(_e647, _e665, (_e665 < _e647));
let _e673 = global_3.member[bitcast<u32>(select(0i, _e667, (_e667 > 0i)))];
let _e674 = (_e655 - _e422.member.x);
let _e675 = (_e664 - _e422.member.y);
let _e676 = (_e673 - _e422.member.z);
let _e682 = select(select(_e676, _e675, _e635), _e674, _e632);
let _e684 = (select(select(_e674, _e676, _e635), _e675, _e632) - (_e643 * _e682));
let _e686 = (select(select(_e675, _e674, _e635), _e676, _e632) - (_e644 * _e682));
let _e688 = (_e645 + 3i);
let _e690 = select(_e647, _e688, (_e688 < _e647));
let _e696 = global_3.member[bitcast<u32>(select(0i, _e690, (_e690 > 0i)))];
let _e697 = (_e645 + 4i);
let _e699 = select(_e647, _e697, (_e697 < _e647));
let _e705 = global_3.member[bitcast<u32>(select(0i, _e699, (_e699 > 0i)))];
let _e706 = (_e645 + 5i);
let _e708 = select(_e647, _e706, (_e706 < _e647));
let _e714 = global_3.member[bitcast<u32>(select(0i, _e708, (_e708 > 0i)))];
let _e715 = (_e696 - _e422.member.x);
let _e716 = (_e705 - _e422.member.y);
let _e717 = (_e714 - _e422.member.z);
let _e723 = select(select(_e717, _e716, _e635), _e715, _e632);
let _e725 = (select(select(_e715, _e717, _e635), _e716, _e632) - (_e643 * _e723));
let _e727 = (select(select(_e716, _e715, _e635), _e717, _e632) - (_e644 * _e723));
let _e729 = (_e645 + 6i);
let _e731 = select(_e647, _e729, (_e729 < _e647));
let _e737 = global_3.member[bitcast<u32>(select(0i, _e731, (_e731 > 0i)))];
let _e738 = (_e645 + 7i);
let _e740 = select(_e647, _e738, (_e738 < _e647));
let _e746 = global_3.member[bitcast<u32>(select(0i, _e740, (_e740 > 0i)))];
let _e747 = (_e645 + 8i);
let _e749 = select(_e647, _e747, (_e747 < _e647));
let _e755 = global_3.member[bitcast<u32>(select(0i, _e749, (_e749 > 0i)))];
let _e756 = (_e737 - _e422.member.x);
let _e757 = (_e746 - _e422.member.y);
let _e758 = (_e755 - _e422.member.z);
let _e764 = select(select(_e758, _e757, _e635), _e756, _e632);
let _e766 = (select(select(_e756, _e758, _e635), _e757, _e632) - (_e643 * _e764));
let _e768 = (select(select(_e757, _e756, _e635), _e758, _e632) - (_e644 * _e764));
let _e772 = ((_e766 * _e727) - (_e768 * _e725));
let _e775 = ((_e684 * _e768) - (_e686 * _e766));
let _e778 = ((_e725 * _e686) - (_e727 * _e684));
let _e780 = ((_e772 + _e775) + _e778);
let _e794 = (!(((((_e772 < 0f) || (_e775 < 0f)) || (_e778 < 0f)) && (((_e772 > 0f) || (_e775 > 0f)) || (_e778 > 0f)))) && (_e780 != 0f));
let _e802 = select(1e30f, ((((_e772 * (_e682 * _e642)) + (_e775 * (_e723 * _e642))) + (_e778 * (_e764 * _e642))) / select(1f, _e780, _e794)), _e794);
let _e804 = select(1e30f, _e802, (_e802 > 1e-3f));
if (_e804 < _e422.member_21) {
let _e827 = type_20(_e614.member, _e614.member_1, _e614.member_2, _e614.member_3, _e614.member_4, _e614.member_5, _e614.member_6, _e614.member_7, _e614.member_8, _e614.member_9, _e614.member_10, _e614.member_11, _e614.member_12, _e614.member_13, _e614.member_14, _e614.member_15, _e614.member_16, _e614.member_17, _e614.member_18, _e614.member_19, _e614.member_20, _e804);
phi_1495_ = type_20(_e827.member, _e827.member_1, _e827.member_2, _e827.member_3, _e827.member_4, _e827.member_5, _e827.member_6, _e827.member_7, _e827.member_8, _e827.member_9, _e827.member_10, _e827.member_11, _e827.member_12, _e827.member_13, _e827.member_14, _e827.member_15, _e827.member_16, _e827.member_17, _e827.member_18, _e827.member_19, _e615, _e827.member_21);
} else {
phi_1495_ = _e614;
}
let _e851 = phi_1495_;
phi_1496_ = _e851;
} else {
phi_1496_ = _e614;
}
let _e853 = phi_1496_;
let _e855 = (_e853.member_20 != _e422.member_20);
let _e858 = ((select(0i, _e853.member_20, _e855) * 19i) + 18i);
let _e860 = (bitcast<i32>(_e68) - 1i);
let _e862 = select(_e860, _e858, (_e858 < _e860));
let _e868 = global_3.member[bitcast<u32>(select(0i, _e862, (_e862 > 0i)))];
let _e875 = select(0i, select(select(i32(_e868), i32(-2147483648), (_e868 < -2147483600f)), 2147483647i, (_e868 > 2147483500f)), (_e868 == _e868));
let _e876 = (_e875 * 4i);
let _e878 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e880 = select(_e878, _e876, (_e876 < _e878));
let _e886 = global_5.member[bitcast<u32>(select(0i, _e880, (_e880 > 0i)))];
if (_e855 && (select(_e886, 1f, (_e875 == 16i)) != 0f)) {
let _e912 = type_20(_e853.member, _e853.member_1, _e853.member_2, _e853.member_3, _e853.member_4, _e853.member_5, _e853.member_6, _e853.member_7, _e853.member_8, _e853.member_9, _e853.member_10, _e853.member_11, _e853.member_12, _e853.member_13, _e853.member_14, _e853.member_15, _e853.member_16, _e853.member_17, _e853.member_18, _e853.member_19, _e422.member_20, _e853.member_21);
phi_1563_ = type_20(_e912.member, _e912.member_1, _e912.member_2, _e912.member_3, _e912.member_4, _e912.member_5, _e912.member_6, _e912.member_7, _e912.member_8, _e912.member_9, _e912.member_10, _e912.member_11, _e912.member_12, _e912.member_13, _e912.member_14, _e912.member_15, _e912.member_16, _e912.member_17, _e912.member_18, _e912.member_19, _e912.member_20, _e422.member_21);
} else {
phi_1563_ = _e853;
}
let _e936 = phi_1563_;
phi_834_ = _e936;
phi_837_ = (_e424 + 1i);
} else {
phi_834_ = type_20();
phi_837_ = i32();
}
let _e938 = phi_834_;
let _e940 = phi_837_;
continue;
continuing {
phi_833_ = _e938;
phi_836_ = _e940;
break if !(_e428);
}
}
let _e943 = local_2;
let _e946 = local_3;
let _e949 = local_4;
let _e952 = local_5;
phi_1576_ = array<f32, 4>();
phi_1577_ = array<f32, 4>(select(2f, 1f, _e943), f32(_e952), f32(_e946.member_20), _e949.member_21);
}
let _e957 = phi_1576_;
let _e959 = phi_1577_;
phi_1578_ = _e957;
phi_1579_ = _e959;
phi_1580_ = _e187;
}
let _e961 = phi_1578_;
let _e963 = phi_1579_;
let _e965 = phi_1580_;
if _e965 {
phi_1584_ = _e961;
} else {
phi_1584_ = _e963;
}
let _e967 = phi_1584_;
global_6.member[_e86] = _e967[0];
global_6.member[_e98] = _e967[1];
global_6.member[_e109] = _e967[2];
global_6.member[_e120] = _e967[3];
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
