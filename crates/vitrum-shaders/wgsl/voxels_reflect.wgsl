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
member_17: type_9,
member_18: type_11,
member_19: type_5,
member_20: type_12,
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
member_12: i32,
member_13: i32,
member_14: f32,
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
fn function_() {
var local: i32;
var local_1: i32;
var phi_776_: type_20;
var phi_791_: type_20;
var phi_794_: i32;
var phi_1414_: type_20;
var phi_1415_: type_20;
var phi_1447_: i32;
var phi_1515_: type_20;
var phi_792_: type_20;
var phi_795_: i32;
var local_2: bool;
var local_3: i32;
var local_4: type_20;
var local_5: type_20;
var phi_1528_: array<f32, 4>;
var phi_1529_: array<f32, 4>;
let _e56 = global;
let _e63 = arrayLength((&global_4.member));
let _e70 = global_1.member.member;
if (_e56.x < _e70.member) {
if (_e56.y < _e70.member_1) {
let _e77 = (_e70.member * _e70.member_1);
let _e79 = ((_e56.y * _e70.member) + _e56.x);
let _e80 = bitcast<i32>(_e79);
let _e82 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e84 = select(_e82, _e80, (_e80 < _e82));
let _e90 = global_6.member[bitcast<u32>(select(0i, _e84, (_e84 > 0i)))];
let _e91 = (_e77 + _e79);
let _e92 = bitcast<i32>(_e91);
let _e94 = select(_e82, _e92, (_e92 < _e82));
let _e100 = global_6.member[bitcast<u32>(select(0i, _e94, (_e94 > 0i)))];
let _e102 = ((2u * _e77) + _e79);
let _e103 = bitcast<i32>(_e102);
let _e105 = select(_e82, _e103, (_e103 < _e82));
let _e111 = global_6.member[bitcast<u32>(select(0i, _e105, (_e105 > 0i)))];
let _e113 = ((3u * _e77) + _e79);
let _e114 = bitcast<i32>(_e113);
let _e116 = select(_e82, _e114, (_e114 < _e82));
let _e122 = global_6.member[bitcast<u32>(select(0i, _e116, (_e116 > 0i)))];
let _e124 = (_e90 == 2f);
if (select(3u, 0u, _e124) > 1u) {
if _e124 {
phi_1529_ = array<f32, 4>(_e90, _e100, _e111, _e122);
} else {
let _e130 = global_1.member.member.member;
let _e134 = global_1.member.member.member_1;
let _e136 = bitcast<i32>((_e130 * _e134));
let _e140 = bitcast<i32>(((_e56.y * _e130) + _e56.x));
let _e141 = ((21i * _e136) + _e140);
let _e143 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e145 = select(_e143, _e141, (_e141 < _e143));
let _e151 = global_2.member[bitcast<u32>(select(0i, _e145, (_e145 > 0i)))];
if (_e151 <= 0f) {
phi_1528_ = array<f32, 4>(2f, 0f, -1f, 1e30f);
} else {
let _e154 = ((20i * _e136) + _e140);
let _e156 = select(_e143, _e154, (_e154 < _e143));
let _e162 = global_2.member[bitcast<u32>(select(0i, _e156, (_e156 > 0i)))];
let _e163 = bitcast<i32>(_e56.x);
let _e164 = bitcast<i32>(_e56.y);
let _e165 = bitcast<i32>(_e130);
let _e177 = global_1.member.member_6.member;
let _e178 = (((((f32(_e163) + 0.5f) / f32(_e165)) * 2f) - 1f) * _e177);
let _e187 = global_1.member.member_6.member_1;
let _e188 = ((1f - (((f32(_e164) + 0.5f) / f32(bitcast<i32>(_e134))) * 2f)) * _e187);
let _e191 = global_1.member.member_7;
let _e200 = global_1.member.member_8;
let _e207 = ((_e191.member * _e178) + (_e200.member * _e188));
let _e208 = ((_e191.member_1 * _e178) + (_e200.member_1 * _e188));
let _e209 = ((_e191.member_2 * _e178) + (_e200.member_2 * _e188));
let _e213 = global_1.member.member_6.member_3;
let _e215 = select(1f, 0f, (_e213 != 0u));
let _e216 = (1f - _e215);
let _e222 = global_1.member.member_10;
let _e231 = global_1.member.member_9;
let _e238 = (_e231.member + (_e207 * _e215));
let _e239 = (_e231.member_1 + (_e208 * _e215));
let _e240 = (_e231.member_2 + (_e209 * _e215));
let _e245 = (((_e238 * _e238) + (_e239 * _e239)) + (_e240 * _e240));
let _e248 = sqrt(select(0f, _e245, (_e245 > 0f)));
let _e251 = (1f / select(1e-20f, _e248, (_e248 > 1e-20f)));
let _e252 = (_e238 * _e251);
let _e253 = (_e239 * _e251);
let _e254 = (_e240 * _e251);
let _e258 = ((_e222.member + (_e207 * _e216)) + (_e252 * _e162));
let _e259 = ((_e222.member_1 + (_e208 * _e216)) + (_e253 * _e162));
let _e260 = ((_e222.member_2 + (_e209 * _e216)) + (_e254 * _e162));
let _e261 = vec3<f32>(_e258, _e259, _e260);
local = ((_e164 * _e165) + _e163);
local_1 = _e136;
let _e264 = local_1;
let _e266 = local;
let _e267 = ((9i * _e264) + _e266);
let _e269 = select(_e143, _e267, (_e267 < _e143));
let _e274 = global_2.member[bitcast<u32>(select(0i, _e269, (_e269 > 0i)))];
let _e275 = local_1;
let _e277 = local;
let _e278 = ((10i * _e275) + _e277);
let _e280 = select(_e143, _e278, (_e278 < _e143));
let _e285 = global_2.member[bitcast<u32>(select(0i, _e280, (_e280 > 0i)))];
let _e286 = local_1;
let _e288 = local;
let _e289 = ((11i * _e286) + _e288);
let _e291 = select(_e143, _e289, (_e289 < _e143));
let _e296 = global_2.member[bitcast<u32>(select(0i, _e291, (_e291 > 0i)))];
let _e302 = (2f * (((_e252 * _e274) + (_e253 * _e285)) + (_e254 * _e296)));
let _e306 = (_e252 - (_e274 * _e302));
let _e307 = (_e253 - (_e285 * _e302));
let _e308 = (_e254 - (_e296 * _e302));
let _e309 = vec3<f32>(_e306, _e307, _e308);
if (_e90 == 0f) {
let _e330 = global_1.member.member_17.member.member;
let _e341 = ((((_e330.member.member * _e258) + (_e330.member.member_1 * _e259)) + (_e330.member.member_2 * _e260)) + _e330.member_1);
let _e347 = -((((_e330.member.member * _e306) + (_e330.member.member_1 * _e307)) + (_e330.member.member_2 * _e308)));
let _e349 = (_e347 > 1e-9f);
let _e353 = ((_e341 / select(1e-9f, _e347, _e349)) - 0.015625f);
let _e356 = select(1e30f, select(0f, _e353, (_e353 > 0f)), ((_e341 > 0f) && _e349));
let _e361 = global_1.member.member_17.member_1.member;
let _e372 = ((((_e361.member.member * _e258) + (_e361.member.member_1 * _e259)) + (_e361.member.member_2 * _e260)) + _e361.member_1);
let _e378 = -((((_e361.member.member * _e306) + (_e361.member.member_1 * _e307)) + (_e361.member.member_2 * _e308)));
let _e380 = (_e378 > 1e-9f);
let _e384 = ((_e372 / select(1e-9f, _e378, _e380)) - 0.015625f);
let _e387 = select(1e30f, select(0f, _e384, (_e384 > 0f)), ((_e372 > 0f) && _e380));
let _e391 = (_e387 < _e356);
phi_776_ = type_20(_e261, _e309, vec3<f32>(1f, 1f, 1f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), 1e9f, 0f, 16i, 0f, 0f, 0f, 0f, 0i, select(select(-2i, -3i, _e391), -1i, ((_e356 >= 1e30f) && (_e387 >= 1e30f))), select(_e356, _e387, _e391));
} else {
phi_776_ = type_20(_e261, _e309, vec3<f32>(1f, 1f, 1f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), 1e9f, 0f, 16i, 0f, 0f, 0f, 0f, select(0i, select(select(i32(_e100), i32(-2147483648), (_e100 < -2147483600f)), 2147483647i, (_e100 > 2147483500f)), (_e100 == _e100)), select(0i, select(select(i32(_e111), i32(-2147483648), (_e111 < -2147483600f)), 2147483647i, (_e111 > 2147483500f)), (_e111 == _e111)), _e122);
}
let _e397 = phi_776_;
let _e398 = bitcast<i32>(arrayLength((&global_3.member)));
phi_791_ = _e397;
phi_794_ = 0i;
loop {
let _e401 = phi_791_;
let _e403 = phi_794_;
local_4 = _e401;
local_5 = _e401;
let _e406 = (_e401.member_12 < (_e398 / 8i));
let _e407 = ((_e403 < 1024i) && _e406);
local_2 = _e406;
local_3 = _e401.member_12;
if _e407 {
let _e412 = (_e401.member_12 * 8i);
let _e416 = bitcast<f32>((bitcast<u32>(_e401.member_1.x) & 2147483647u));
let _e421 = (1f / select(_e401.member_1.x, select(1e-12f, -1e-12f, (_e401.member_1.x < 0f)), (_e416 < 1e-12f)));
let _e425 = bitcast<f32>((bitcast<u32>(_e401.member_1.y) & 2147483647u));
let _e430 = (1f / select(_e401.member_1.y, select(1e-12f, -1e-12f, (_e401.member_1.y < 0f)), (_e425 < 1e-12f)));
let _e434 = bitcast<f32>((bitcast<u32>(_e401.member_1.z) & 2147483647u));
let _e439 = (1f / select(_e401.member_1.z, select(1e-12f, -1e-12f, (_e401.member_1.z < 0f)), (_e434 < 1e-12f)));
let _e441 = (_e398 - 1i);
let _e443 = select(_e441, _e412, (_e412 < _e441));
let _e449 = global_3.member[bitcast<u32>(select(0i, _e443, (_e443 > 0i)))];
let _e450 = (_e412 + 1i);
let _e452 = select(_e441, _e450, (_e450 < _e441));
let _e458 = global_3.member[bitcast<u32>(select(0i, _e452, (_e452 > 0i)))];
let _e459 = (_e412 + 2i);
let _e461 = select(_e441, _e459, (_e459 < _e441));
let _e467 = global_3.member[bitcast<u32>(select(0i, _e461, (_e461 > 0i)))];
let _e468 = (_e412 + 3i);
let _e470 = select(_e441, _e468, (_e468 < _e441));
let _e476 = global_3.member[bitcast<u32>(select(0i, _e470, (_e470 > 0i)))];
let _e477 = (_e412 + 4i);
let _e479 = select(_e441, _e477, (_e477 < _e441));
let _e485 = global_3.member[bitcast<u32>(select(0i, _e479, (_e479 > 0i)))];
let _e486 = (_e412 + 5i);
let _e488 = select(_e441, _e486, (_e486 < _e441));
let _e494 = global_3.member[bitcast<u32>(select(0i, _e488, (_e488 > 0i)))];
let _e497 = ((_e449 - _e401.member.x) * _e421);
let _e499 = ((_e476 - _e401.member.x) * _e421);
let _e502 = ((_e458 - _e401.member.y) * _e430);
let _e504 = ((_e485 - _e401.member.y) * _e430);
let _e507 = ((_e467 - _e401.member.z) * _e439);
let _e509 = ((_e494 - _e401.member.z) * _e439);
let _e511 = select(_e499, _e497, (_e497 < _e499));
let _e513 = select(_e504, _e502, (_e502 < _e504));
let _e515 = select(_e513, _e511, (_e511 > _e513));
let _e517 = select(_e509, _e507, (_e507 < _e509));
let _e521 = select(_e499, _e497, (_e497 > _e499));
let _e523 = select(_e504, _e502, (_e502 > _e504));
let _e525 = select(_e523, _e521, (_e521 < _e523));
let _e527 = select(_e509, _e507, (_e507 > _e509));
let _e529 = select(_e527, _e525, (_e525 < _e527));
let _e534 = ((select(_e517, _e515, (_e515 > _e517)) <= select(_e401.member_14, _e529, (_e529 < _e401.member_14))) && (_e529 >= 0f));
let _e535 = (_e412 + 6i);
let _e537 = select(_e441, _e535, (_e535 < _e441));
let _e543 = global_3.member[bitcast<u32>(select(0i, _e537, (_e537 > 0i)))];
let _e550 = select(0i, select(select(i32(_e543), i32(-2147483648), (_e543 < -2147483600f)), 2147483647i, (_e543 > 2147483500f)), (_e543 == _e543));
if (_e534 && (_e550 >= 0i)) {
let _e555 = ((_e416 >= _e425) && (_e416 >= _e434));
let _e558 = (!(_e555) && (_e425 >= _e434));
let _e565 = (1f / select(select(_e401.member_1.z, _e401.member_1.y, _e558), _e401.member_1.x, _e555));
let _e566 = (select(select(_e401.member_1.x, _e401.member_1.z, _e558), _e401.member_1.y, _e555) * _e565);
let _e567 = (select(select(_e401.member_1.y, _e401.member_1.x, _e558), _e401.member_1.z, _e555) * _e565);
let _e568 = (_e550 * 19i);
let _e570 = (bitcast<i32>(_e63) - 1i);
let _e572 = select(_e570, _e568, (_e568 < _e570));
let _e578 = global_4.member[bitcast<u32>(select(0i, _e572, (_e572 > 0i)))];
let _e579 = (_e568 + 1i);
let _e581 = select(_e570, _e579, (_e579 < _e570));
let _e587 = global_4.member[bitcast<u32>(select(0i, _e581, (_e581 > 0i)))];
let _e588 = (_e568 + 2i);
let _e590 = select(_e570, _e588, (_e588 < _e570));
let _e596 = global_4.member[bitcast<u32>(select(0i, _e590, (_e590 > 0i)))];
let _e597 = (_e578 - _e401.member.x);
let _e598 = (_e587 - _e401.member.y);
let _e599 = (_e596 - _e401.member.z);
let _e605 = select(select(_e599, _e598, _e558), _e597, _e555);
let _e607 = (select(select(_e597, _e599, _e558), _e598, _e555) - (_e566 * _e605));
let _e609 = (select(select(_e598, _e597, _e558), _e599, _e555) - (_e567 * _e605));
let _e611 = (_e568 + 3i);
let _e613 = select(_e570, _e611, (_e611 < _e570));
let _e619 = global_4.member[bitcast<u32>(select(0i, _e613, (_e613 > 0i)))];
let _e620 = (_e568 + 4i);
let _e622 = select(_e570, _e620, (_e620 < _e570));
let _e628 = global_4.member[bitcast<u32>(select(0i, _e622, (_e622 > 0i)))];
let _e629 = (_e568 + 5i);
let _e631 = select(_e570, _e629, (_e629 < _e570));
let _e637 = global_4.member[bitcast<u32>(select(0i, _e631, (_e631 > 0i)))];
let _e638 = (_e619 - _e401.member.x);
let _e639 = (_e628 - _e401.member.y);
let _e640 = (_e637 - _e401.member.z);
let _e646 = select(select(_e640, _e639, _e558), _e638, _e555);
let _e648 = (select(select(_e638, _e640, _e558), _e639, _e555) - (_e566 * _e646));
let _e650 = (select(select(_e639, _e638, _e558), _e640, _e555) - (_e567 * _e646));
let _e652 = (_e568 + 6i);
let _e654 = select(_e570, _e652, (_e652 < _e570));
let _e660 = global_4.member[bitcast<u32>(select(0i, _e654, (_e654 > 0i)))];
let _e661 = (_e568 + 7i);
let _e663 = select(_e570, _e661, (_e661 < _e570));
let _e669 = global_4.member[bitcast<u32>(select(0i, _e663, (_e663 > 0i)))];
let _e670 = (_e568 + 8i);
let _e672 = select(_e570, _e670, (_e670 < _e570));
let _e678 = global_4.member[bitcast<u32>(select(0i, _e672, (_e672 > 0i)))];
let _e679 = (_e660 - _e401.member.x);
let _e680 = (_e669 - _e401.member.y);
let _e681 = (_e678 - _e401.member.z);
let _e687 = select(select(_e681, _e680, _e558), _e679, _e555);
let _e689 = (select(select(_e679, _e681, _e558), _e680, _e555) - (_e566 * _e687));
let _e691 = (select(select(_e680, _e679, _e558), _e681, _e555) - (_e567 * _e687));
let _e695 = ((_e689 * _e650) - (_e691 * _e648));
let _e698 = ((_e607 * _e691) - (_e609 * _e689));
let _e701 = ((_e648 * _e609) - (_e650 * _e607));
let _e703 = ((_e695 + _e698) + _e701);
let _e717 = (!(((((_e695 < 0f) || (_e698 < 0f)) || (_e701 < 0f)) && (((_e695 > 0f) || (_e698 > 0f)) || (_e701 > 0f)))) && (_e703 != 0f));
let _e724 = ((((_e695 * (_e605 * _e565)) + (_e698 * (_e646 * _e565))) + (_e701 * (_e687 * _e565))) / select(1f, _e703, _e717));
let _e727 = select(1e30f, _e724, (_e717 && (_e724 > 1e-3f)));
if (_e727 < _e401.member_14) {
let _e743 = type_20(_e401.member, _e401.member_1, _e401.member_2, _e401.member_3, _e401.member_4, _e401.member_5, _e401.member_6, _e401.member_7, _e401.member_8, _e401.member_9, _e401.member_10, _e401.member_11, _e401.member_12, _e401.member_13, _e727);
phi_1414_ = type_20(_e743.member, _e743.member_1, _e743.member_2, _e743.member_3, _e743.member_4, _e743.member_5, _e743.member_6, _e743.member_7, _e743.member_8, _e743.member_9, _e743.member_10, _e743.member_11, _e743.member_12, _e550, _e743.member_14);
} else {
phi_1414_ = _e401;
}
let _e760 = phi_1414_;
phi_1415_ = _e760;
} else {
phi_1415_ = _e401;
}
let _e762 = phi_1415_;
if _e534 {
phi_1447_ = (_e762.member_12 + 1i);
} else {
let _e763 = (_e412 + 7i);
let _e765 = select(_e441, _e763, (_e763 < _e441));
let _e771 = global_3.member[bitcast<u32>(select(0i, _e765, (_e765 > 0i)))];
phi_1447_ = select(0i, select(select(i32(_e771), i32(-2147483648), (_e771 < -2147483600f)), 2147483647i, (_e771 > 2147483500f)), (_e771 == _e771));
}
let _e782 = phi_1447_;
let _e797 = type_20(_e762.member, _e762.member_1, _e762.member_2, _e762.member_3, _e762.member_4, _e762.member_5, _e762.member_6, _e762.member_7, _e762.member_8, _e762.member_9, _e762.member_10, _e762.member_11, _e782, _e762.member_13, _e762.member_14);
let _e799 = (_e762.member_13 != _e401.member_13);
let _e802 = ((select(0i, _e762.member_13, _e799) * 19i) + 18i);
let _e804 = (bitcast<i32>(_e63) - 1i);
let _e806 = select(_e804, _e802, (_e802 < _e804));
let _e812 = global_4.member[bitcast<u32>(select(0i, _e806, (_e806 > 0i)))];
let _e819 = select(0i, select(select(i32(_e812), i32(-2147483648), (_e812 < -2147483600f)), 2147483647i, (_e812 > 2147483500f)), (_e812 == _e812));
let _e820 = (_e819 * 4i);
let _e822 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e824 = select(_e822, _e820, (_e820 < _e822));
let _e830 = global_5.member[bitcast<u32>(select(0i, _e824, (_e824 > 0i)))];
if (_e799 && (select(_e830, 1f, (_e819 == 16i)) != 0f)) {
let _e849 = type_20(_e797.member, _e797.member_1, _e797.member_2, _e797.member_3, _e797.member_4, _e797.member_5, _e797.member_6, _e797.member_7, _e797.member_8, _e797.member_9, _e797.member_10, _e797.member_11, _e797.member_12, _e401.member_13, _e797.member_14);
phi_1515_ = type_20(_e849.member, _e849.member_1, _e849.member_2, _e849.member_3, _e849.member_4, _e849.member_5, _e849.member_6, _e849.member_7, _e849.member_8, _e849.member_9, _e849.member_10, _e849.member_11, _e849.member_12, _e849.member_13, _e401.member_14);
} else {
phi_1515_ = _e797;
}
let _e866 = phi_1515_;
phi_792_ = _e866;
phi_795_ = (_e403 + 1i);
} else {
phi_792_ = type_20();
phi_795_ = i32();
}
let _e868 = phi_792_;
let _e870 = phi_795_;
continue;
continuing {
phi_791_ = _e868;
phi_794_ = _e870;
break if !(_e407);
}
}
let _e873 = local_2;
let _e876 = local_3;
let _e879 = local_4;
let _e883 = local_5;
phi_1528_ = array<f32, 4>(select(2f, 1f, _e873), f32(_e876), f32(_e879.member_13), _e883.member_14);
}
let _e887 = phi_1528_;
phi_1529_ = _e887;
}
let _e889 = phi_1529_;
global_6.member[_e79] = _e889[0];
global_6.member[_e91] = _e889[1];
global_6.member[_e102] = _e889[2];
global_6.member[_e113] = _e889[3];
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
