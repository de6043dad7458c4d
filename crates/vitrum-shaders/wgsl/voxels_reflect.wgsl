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
}
struct type_11 {
member: type_2,
member_1: u32,
member_2: type_7,
member_3: type_7,
member_4: type_7,
member_5: f32,
member_6: f32,
}
struct type_12 {
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
member_17: type_9,
member_18: type_10,
member_19: type_5,
member_20: type_11,
}
struct type_13 {
member: type_12,
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
member_12: i32,
member_13: i32,
member_14: f32,
}
struct type_23 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_13;
@group(0) @binding(1)
var<storage> global_2: type_15;
@group(0) @binding(2)
var<storage> global_3: type_15;
@group(0) @binding(3)
var<storage> global_4: type_15;
@group(0) @binding(4)
var<storage> global_5: type_15;
@group(0) @binding(5)
var<storage, read_write> global_6: type_15;
@group(0) @binding(6)
var<storage, read_write> global_7: type_23;
fn function_() {
var local: i32;
var local_1: i32;
var phi_808_: type_19;
var phi_823_: type_19;
var phi_826_: i32;
var phi_1446_: type_19;
var phi_1447_: type_19;
var phi_1479_: i32;
var phi_1547_: type_19;
var phi_824_: type_19;
var phi_827_: i32;
var local_2: bool;
var local_3: i32;
var local_4: type_19;
var local_5: type_19;
var phi_1560_: array<f32, 4>;
var phi_1561_: array<f32, 4>;
let _e59 = global;
let _e66 = arrayLength((&global_4.member));
let _e75 = global_1.member.member;
if (_e59.x < _e75.member) {
if (_e59.y < _e75.member_1) {
let _e82 = (_e75.member * _e75.member_1);
let _e84 = ((_e59.y * _e75.member) + _e59.x);
let _e85 = bitcast<i32>(_e84);
let _e87 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e89 = select(_e87, _e85, (_e85 < _e87));
let _e95 = global_6.member[bitcast<u32>(select(0i, _e89, (_e89 > 0i)))];
let _e96 = (_e82 + _e84);
let _e97 = bitcast<i32>(_e96);
let _e99 = select(_e87, _e97, (_e97 < _e87));
let _e105 = global_6.member[bitcast<u32>(select(0i, _e99, (_e99 > 0i)))];
let _e107 = ((2u * _e82) + _e84);
let _e108 = bitcast<i32>(_e107);
let _e110 = select(_e87, _e108, (_e108 < _e87));
let _e116 = global_6.member[bitcast<u32>(select(0i, _e110, (_e110 > 0i)))];
let _e118 = ((3u * _e82) + _e84);
let _e119 = bitcast<i32>(_e118);
let _e121 = select(_e87, _e119, (_e119 < _e87));
let _e127 = global_6.member[bitcast<u32>(select(0i, _e121, (_e121 > 0i)))];
let _e129 = (_e95 == 2f);
let _e130 = select(3u, 0u, _e129);
if (_e130 > 0u) {
if (arrayLength((&global_7.member)) >= 3u) {
let _e139 = atomicLoad((&global_7.member[0u]));
if (_e139 == 0u) {
atomicStore((&global_7.member[0u]), ((_e75.member + 7u) / 8u));
atomicStore((&global_7.member[1u]), ((_e75.member_1 + 7u) / 8u));
atomicStore((&global_7.member[2u]), 1u);
}
}
}
if (_e130 > 1u) {
if _e129 {
phi_1561_ = array<f32, 4>(_e95, _e105, _e116, _e127);
} else {
let _e149 = global_1.member.member.member;
let _e153 = global_1.member.member.member_1;
let _e155 = bitcast<i32>((_e149 * _e153));
let _e159 = bitcast<i32>(((_e59.y * _e149) + _e59.x));
let _e160 = ((21i * _e155) + _e159);
let _e162 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e164 = select(_e162, _e160, (_e160 < _e162));
let _e170 = global_2.member[bitcast<u32>(select(0i, _e164, (_e164 > 0i)))];
if (_e170 <= 0f) {
phi_1560_ = array<f32, 4>(2f, 0f, -1f, 1e30f);
} else {
let _e173 = ((20i * _e155) + _e159);
let _e175 = select(_e162, _e173, (_e173 < _e162));
let _e181 = global_2.member[bitcast<u32>(select(0i, _e175, (_e175 > 0i)))];
let _e182 = bitcast<i32>(_e59.x);
let _e183 = bitcast<i32>(_e59.y);
let _e184 = bitcast<i32>(_e149);
let _e196 = global_1.member.member_6.member;
let _e197 = (((((f32(_e182) + 0.5f) / f32(_e184)) * 2f) - 1f) * _e196);
let _e206 = global_1.member.member_6.member_1;
let _e207 = ((1f - (((f32(_e183) + 0.5f) / f32(bitcast<i32>(_e153))) * 2f)) * _e206);
let _e210 = global_1.member.member_7;
let _e219 = global_1.member.member_8;
let _e226 = ((_e210.member * _e197) + (_e219.member * _e207));
let _e227 = ((_e210.member_1 * _e197) + (_e219.member_1 * _e207));
let _e228 = ((_e210.member_2 * _e197) + (_e219.member_2 * _e207));
let _e232 = global_1.member.member_6.member_3;
let _e234 = select(1f, 0f, (_e232 != 0u));
let _e235 = (1f - _e234);
let _e241 = global_1.member.member_10;
let _e250 = global_1.member.member_9;
let _e257 = (_e250.member + (_e226 * _e234));
let _e258 = (_e250.member_1 + (_e227 * _e234));
let _e259 = (_e250.member_2 + (_e228 * _e234));
let _e264 = (((_e257 * _e257) + (_e258 * _e258)) + (_e259 * _e259));
let _e267 = sqrt(select(0f, _e264, (_e264 > 0f)));
let _e270 = (1f / select(1e-20f, _e267, (_e267 > 1e-20f)));
let _e271 = (_e257 * _e270);
let _e272 = (_e258 * _e270);
let _e273 = (_e259 * _e270);
let _e277 = ((_e241.member + (_e226 * _e235)) + (_e271 * _e181));
let _e278 = ((_e241.member_1 + (_e227 * _e235)) + (_e272 * _e181));
let _e279 = ((_e241.member_2 + (_e228 * _e235)) + (_e273 * _e181));
let _e280 = vec3<f32>(_e277, _e278, _e279);
local = ((_e183 * _e184) + _e182);
local_1 = _e155;
let _e283 = local_1;
let _e285 = local;
let _e286 = ((9i * _e283) + _e285);
let _e288 = select(_e162, _e286, (_e286 < _e162));
let _e293 = global_2.member[bitcast<u32>(select(0i, _e288, (_e288 > 0i)))];
let _e294 = local_1;
let _e296 = local;
let _e297 = ((10i * _e294) + _e296);
let _e299 = select(_e162, _e297, (_e297 < _e162));
let _e304 = global_2.member[bitcast<u32>(select(0i, _e299, (_e299 > 0i)))];
let _e305 = local_1;
let _e307 = local;
let _e308 = ((11i * _e305) + _e307);
let _e310 = select(_e162, _e308, (_e308 < _e162));
let _e315 = global_2.member[bitcast<u32>(select(0i, _e310, (_e310 > 0i)))];
let _e321 = (2f * (((_e271 * _e293) + (_e272 * _e304)) + (_e273 * _e315)));
let _e325 = (_e271 - (_e293 * _e321));
let _e326 = (_e272 - (_e304 * _e321));
let _e327 = (_e273 - (_e315 * _e321));
let _e328 = vec3<f32>(_e325, _e326, _e327);
if (_e95 == 0f) {
let _e349 = global_1.member.member_17.member.member;
let _e360 = ((((_e349.member.member * _e277) + (_e349.member.member_1 * _e278)) + (_e349.member.member_2 * _e279)) + _e349.member_1);
let _e366 = -((((_e349.member.member * _e325) + (_e349.member.member_1 * _e326)) + (_e349.member.member_2 * _e327)));
let _e368 = (_e366 > 1e-9f);
let _e372 = ((_e360 / select(1e-9f, _e366, _e368)) - 0.015625f);
let _e375 = select(1e30f, select(0f, _e372, (_e372 > 0f)), ((_e360 > 0f) && _e368));
let _e380 = global_1.member.member_17.member_1.member;
let _e391 = ((((_e380.member.member * _e277) + (_e380.member.member_1 * _e278)) + (_e380.member.member_2 * _e279)) + _e380.member_1);
let _e397 = -((((_e380.member.member * _e325) + (_e380.member.member_1 * _e326)) + (_e380.member.member_2 * _e327)));
let _e399 = (_e397 > 1e-9f);
let _e403 = ((_e391 / select(1e-9f, _e397, _e399)) - 0.015625f);
let _e406 = select(1e30f, select(0f, _e403, (_e403 > 0f)), ((_e391 > 0f) && _e399));
let _e410 = (_e406 < _e375);
phi_808_ = type_19(_e280, _e328, vec3<f32>(1f, 1f, 1f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), 1e9f, 0f, 16i, 0f, 0f, 0f, 0f, 0i, select(select(-2i, -3i, _e410), -1i, ((_e375 >= 1e30f) && (_e406 >= 1e30f))), select(_e375, _e406, _e410));
} else {
phi_808_ = type_19(_e280, _e328, vec3<f32>(1f, 1f, 1f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), 1e9f, 0f, 16i, 0f, 0f, 0f, 0f, select(0i, select(select(i32(_e105), i32(-2147483648), (_e105 < -2147483600f)), 2147483647i, (_e105 > 2147483500f)), (_e105 == _e105)), select(0i, select(select(i32(_e116), i32(-2147483648), (_e116 < -2147483600f)), 2147483647i, (_e116 > 2147483500f)), (_e116 == _e116)), _e127);
}
let _e416 = phi_808_;
let _e417 = bitcast<i32>(arrayLength((&global_3.member)));
phi_823_ = _e416;
phi_826_ = 0i;
loop {
let _e420 = phi_823_;
let _e422 = phi_826_;
local_4 = _e420;
local_5 = _e420;
let _e425 = (_e420.member_12 < (_e417 / 8i));
let _e426 = ((_e422 < 1024i) && _e425);
local_2 = _e425;
local_3 = _e420.member_12;
if _e426 {
let _e431 = (_e420.member_12 * 8i);
let _e435 = bitcast<f32>((bitcast<u32>(_e420.member_1.x) & 2147483647u));
let _e440 = (1f / select(_e420.member_1.x, select(1e-12f, -1e-12f, (_e420.member_1.x < 0f)), (_e435 < 1e-12f)));
let _e444 = bitcast<f32>((bitcast<u32>(_e420.member_1.y) & 2147483647u));
let _e449 = (1f / select(_e420.member_1.y, select(1e-12f, -1e-12f, (_e420.member_1.y < 0f)), (_e444 < 1e-12f)));
let _e453 = bitcast<f32>((bitcast<u32>(_e420.member_1.z) & 2147483647u));
let _e458 = (1f / select(_e420.member_1.z, select(1e-12f, -1e-12f, (_e420.member_1.z < 0f)), (_e453 < 1e-12f)));
let _e460 = (_e417 - 1i);
let _e462 = select(_e460, _e431, (_e431 < _e460));
let _e468 = global_3.member[bitcast<u32>(select(0i, _e462, (_e462 > 0i)))];
let _e469 = (_e431 + 1i);
let _e471 = select(_e460, _e469, (_e469 < _e460));
let _e477 = global_3.member[bitcast<u32>(select(0i, _e471, (_e471 > 0i)))];
let _e478 = (_e431 + 2i);
let _e480 = select(_e460, _e478, (_e478 < _e460));
let _e486 = global_3.member[bitcast<u32>(select(0i, _e480, (_e480 > 0i)))];
let _e487 = (_e431 + 3i);
let _e489 = select(_e460, _e487, (_e487 < _e460));
let _e495 = global_3.member[bitcast<u32>(select(0i, _e489, (_e489 > 0i)))];
let _e496 = (_e431 + 4i);
let _e498 = select(_e460, _e496, (_e496 < _e460));
let _e504 = global_3.member[bitcast<u32>(select(0i, _e498, (_e498 > 0i)))];
let _e505 = (_e431 + 5i);
let _e507 = select(_e460, _e505, (_e505 < _e460));
let _e513 = global_3.member[bitcast<u32>(select(0i, _e507, (_e507 > 0i)))];
let _e516 = ((_e468 - _e420.member.x) * _e440);
let _e518 = ((_e495 - _e420.member.x) * _e440);
let _e521 = ((_e477 - _e420.member.y) * _e449);
let _e523 = ((_e504 - _e420.member.y) * _e449);
let _e526 = ((_e486 - _e420.member.z) * _e458);
let _e528 = ((_e513 - _e420.member.z) * _e458);
let _e530 = select(_e518, _e516, (_e516 < _e518));
let _e532 = select(_e523, _e521, (_e521 < _e523));
let _e534 = select(_e532, _e530, (_e530 > _e532));
let _e536 = select(_e528, _e526, (_e526 < _e528));
let _e540 = select(_e518, _e516, (_e516 > _e518));
let _e542 = select(_e523, _e521, (_e521 > _e523));
let _e544 = select(_e542, _e540, (_e540 < _e542));
let _e546 = select(_e528, _e526, (_e526 > _e528));
let _e548 = select(_e546, _e544, (_e544 < _e546));
let _e553 = ((select(_e536, _e534, (_e534 > _e536)) <= select(_e420.member_14, _e548, (_e548 < _e420.member_14))) && (_e548 >= 0f));
let _e554 = (_e431 + 6i);
let _e556 = select(_e460, _e554, (_e554 < _e460));
let _e562 = global_3.member[bitcast<u32>(select(0i, _e556, (_e556 > 0i)))];
let _e569 = select(0i, select(select(i32(_e562), i32(-2147483648), (_e562 < -2147483600f)), 2147483647i, (_e562 > 2147483500f)), (_e562 == _e562));
if (_e553 && (_e569 >= 0i)) {
let _e574 = ((_e435 >= _e444) && (_e435 >= _e453));
let _e577 = (!(_e574) && (_e444 >= _e453));
let _e584 = (1f / select(select(_e420.member_1.z, _e420.member_1.y, _e577), _e420.member_1.x, _e574));
let _e585 = (select(select(_e420.member_1.x, _e420.member_1.z, _e577), _e420.member_1.y, _e574) * _e584);
let _e586 = (select(select(_e420.member_1.y, _e420.member_1.x, _e577), _e420.member_1.z, _e574) * _e584);
let _e587 = (_e569 * 19i);
let _e589 = (bitcast<i32>(_e66) - 1i);
let _e591 = select(_e589, _e587, (_e587 < _e589));
let _e597 = global_4.member[bitcast<u32>(select(0i, _e591, (_e591 > 0i)))];
let _e598 = (_e587 + 1i);
let _e600 = select(_e589, _e598, (_e598 < _e589));
let _e606 = global_4.member[bitcast<u32>(select(0i, _e600, (_e600 > 0i)))];
let _e607 = (_e587 + 2i);
let _e609 = select(_e589, _e607, (_e607 < _e589));
let _e615 = global_4.member[bitcast<u32>(select(0i, _e609, (_e609 > 0i)))];
let _e616 = (_e597 - _e420.member.x);
let _e617 = (_e606 - _e420.member.y);
let _e618 = (_e615 - _e420.member.z);
let _e624 = select(select(_e618, _e617, _e577), _e616, _e574);
let _e626 = (select(select(_e616, _e618, _e577), _e617, _e574) - (_e585 * _e624));
let _e628 = (select(select(_e617, _e616, _e577), _e618, _e574) - (_e586 * _e624));
let _e630 = (_e587 + 3i);
let _e632 = select(_e589, _e630, (_e630 < _e589));
let _e638 = global_4.member[bitcast<u32>(select(0i, _e632, (_e632 > 0i)))];
let _e639 = (_e587 + 4i);
let _e641 = select(_e589, _e639, (_e639 < _e589));
let _e647 = global_4.member[bitcast<u32>(select(0i, _e641, (_e641 > 0i)))];
let _e648 = (_e587 + 5i);
let _e650 = select(_e589, _e648, (_e648 < _e589));
let _e656 = global_4.member[bitcast<u32>(select(0i, _e650, (_e650 > 0i)))];
let _e657 = (_e638 - _e420.member.x);
let _e658 = (_e647 - _e420.member.y);
let _e659 = (_e656 - _e420.member.z);
let _e665 = select(select(_e659, _e658, _e577), _e657, _e574);
let _e667 = (select(select(_e657, _e659, _e577), _e658, _e574) - (_e585 * _e665));
let _e669 = (select(select(_e658, _e657, _e577), _e659, _e574) - (_e586 * _e665));
let _e671 = (_e587 + 6i);
let _e673 = select(_e589, _e671, (_e671 < _e589));
let _e679 = global_4.member[bitcast<u32>(select(0i, _e673, (_e673 > 0i)))];
let _e680 = (_e587 + 7i);
let _e682 = select(_e589, _e680, (_e680 < _e589));
let _e688 = global_4.member[bitcast<u32>(select(0i, _e682, (_e682 > 0i)))];
let _e689 = (_e587 + 8i);
let _e691 = select(_e589, _e689, (_e689 < _e589));
let _e697 = global_4.member[bitcast<u32>(select(0i, _e691, (_e691 > 0i)))];
let _e698 = (_e679 - _e420.member.x);
let _e699 = (_e688 - _e420.member.y);
let _e700 = (_e697 - _e420.member.z);
let _e706 = select(select(_e700, _e699, _e577), _e698, _e574);
let _e708 = (select(select(_e698, _e700, _e577), _e699, _e574) - (_e585 * _e706));
let _e710 = (select(select(_e699, _e698, _e577), _e700, _e574) - (_e586 * _e706));
let _e714 = ((_e708 * _e669) - (_e710 * _e667));
let _e717 = ((_e626 * _e710) - (_e628 * _e708));
let _e720 = ((_e667 * _e628) - (_e669 * _e626));
let _e722 = ((_e714 + _e717) + _e720);
let _e736 = (!(((((_e714 < 0f) || (_e717 < 0f)) || (_e720 < 0f)) && (((_e714 > 0f) || (_e717 > 0f)) || (_e720 > 0f)))) && (_e722 != 0f));
let _e743 = ((((_e714 * (_e624 * _e584)) + (_e717 * (_e665 * _e584))) + (_e720 * (_e706 * _e584))) / select(1f, _e722, _e736));
let _e746 = select(1e30f, _e743, (_e736 && (_e743 > 1e-3f)));
if (_e746 < _e420.member_14) {
let _e762 = type_19(_e420.member, _e420.member_1, _e420.member_2, _e420.member_3, _e420.member_4, _e420.member_5, _e420.member_6, _e420.member_7, _e420.member_8, _e420.member_9, _e420.member_10, _e420.member_11, _e420.member_12, _e420.member_13, _e746);
phi_1446_ = type_19(_e762.member, _e762.member_1, _e762.member_2, _e762.member_3, _e762.member_4, _e762.member_5, _e762.member_6, _e762.member_7, _e762.member_8, _e762.member_9, _e762.member_10, _e762.member_11, _e762.member_12, _e569, _e762.member_14);
} else {
phi_1446_ = _e420;
}
let _e779 = phi_1446_;
phi_1447_ = _e779;
} else {
phi_1447_ = _e420;
}
let _e781 = phi_1447_;
if _e553 {
phi_1479_ = (_e781.member_12 + 1i);
} else {
let _e782 = (_e431 + 7i);
let _e784 = select(_e460, _e782, (_e782 < _e460));
let _e790 = global_3.member[bitcast<u32>(select(0i, _e784, (_e784 > 0i)))];
phi_1479_ = select(0i, select(select(i32(_e790), i32(-2147483648), (_e790 < -2147483600f)), 2147483647i, (_e790 > 2147483500f)), (_e790 == _e790));
}
let _e801 = phi_1479_;
let _e816 = type_19(_e781.member, _e781.member_1, _e781.member_2, _e781.member_3, _e781.member_4, _e781.member_5, _e781.member_6, _e781.member_7, _e781.member_8, _e781.member_9, _e781.member_10, _e781.member_11, _e801, _e781.member_13, _e781.member_14);
let _e818 = (_e781.member_13 != _e420.member_13);
let _e821 = ((select(0i, _e781.member_13, _e818) * 19i) + 18i);
let _e823 = (bitcast<i32>(_e66) - 1i);
let _e825 = select(_e823, _e821, (_e821 < _e823));
let _e831 = global_4.member[bitcast<u32>(select(0i, _e825, (_e825 > 0i)))];
let _e838 = select(0i, select(select(i32(_e831), i32(-2147483648), (_e831 < -2147483600f)), 2147483647i, (_e831 > 2147483500f)), (_e831 == _e831));
let _e839 = (_e838 * 4i);
let _e841 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e843 = select(_e841, _e839, (_e839 < _e841));
let _e849 = global_5.member[bitcast<u32>(select(0i, _e843, (_e843 > 0i)))];
if (_e818 && (select(_e849, 1f, (_e838 == 16i)) != 0f)) {
let _e868 = type_19(_e816.member, _e816.member_1, _e816.member_2, _e816.member_3, _e816.member_4, _e816.member_5, _e816.member_6, _e816.member_7, _e816.member_8, _e816.member_9, _e816.member_10, _e816.member_11, _e816.member_12, _e420.member_13, _e816.member_14);
phi_1547_ = type_19(_e868.member, _e868.member_1, _e868.member_2, _e868.member_3, _e868.member_4, _e868.member_5, _e868.member_6, _e868.member_7, _e868.member_8, _e868.member_9, _e868.member_10, _e868.member_11, _e868.member_12, _e868.member_13, _e420.member_14);
} else {
phi_1547_ = _e816;
}
let _e885 = phi_1547_;
phi_824_ = _e885;
phi_827_ = (_e422 + 1i);
} else {
phi_824_ = type_19();
phi_827_ = i32();
}
let _e887 = phi_824_;
let _e889 = phi_827_;
continue;
continuing {
phi_823_ = _e887;
phi_826_ = _e889;
break if !(_e426);
}
}
let _e892 = local_2;
let _e895 = local_3;
let _e898 = local_4;
let _e902 = local_5;
phi_1560_ = array<f32, 4>(select(2f, 1f, _e892), f32(_e895), f32(_e898.member_13), _e902.member_14);
}
let _e906 = phi_1560_;
phi_1561_ = _e906;
}
let _e908 = phi_1561_;
global_6.member[_e84] = _e908[0];
global_6.member[_e96] = _e908[1];
global_6.member[_e107] = _e908[2];
global_6.member[_e118] = _e908[3];
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
