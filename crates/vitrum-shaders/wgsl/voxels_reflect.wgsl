struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
}
struct type_5 {
member: vec4<u32>,
member_1: vec4<u32>,
member_2: vec4<u32>,
member_3: type_4,
member_4: type_4,
member_5: type_4,
member_6: type_4,
member_7: type_4,
member_8: type_4,
member_9: type_4,
member_10: vec4<u32>,
member_11: type_4,
member_12: type_4,
member_13: type_4,
member_14: type_4,
member_15: type_4,
member_16: type_4,
member_17: type_4,
member_18: type_4,
member_19: type_4,
member_20: type_4,
member_21: type_4,
member_22: type_4,
member_23: type_4,
member_24: vec4<u32>,
member_25: type_4,
member_26: type_4,
member_27: type_4,
member_28: type_4,
}
struct type_6 {
member: type_5,
}
struct type_8 {
member: array<f32>,
}
struct type_12 {
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
var<storage> global_1: type_6;
@group(0) @binding(1)
var<storage> global_2: type_8;
@group(0) @binding(2)
var<storage> global_3: type_8;
@group(0) @binding(3)
var<storage> global_4: type_8;
@group(0) @binding(4)
var<storage> global_5: type_8;
@group(0) @binding(5)
var<storage, read_write> global_6: type_8;
fn function_() {
var local: i32;
var local_1: i32;
var phi_762_: type_12;
var phi_777_: type_12;
var phi_780_: i32;
var phi_1400_: type_12;
var phi_1401_: type_12;
var phi_1433_: i32;
var phi_1501_: type_12;
var phi_778_: type_12;
var phi_781_: i32;
var local_2: bool;
var local_3: i32;
var local_4: type_12;
var local_5: type_12;
var phi_1514_: array<f32, 4>;
var phi_1515_: array<f32, 4>;
let _e56 = global;
let _e63 = arrayLength((&global_4.member));
let _e71 = global_1.member.member[0u];
let _e75 = global_1.member.member[1u];
if (_e56.x < _e71) {
if (_e56.y < _e75) {
let _e80 = (_e71 * _e75);
let _e82 = ((_e56.y * _e71) + _e56.x);
let _e83 = bitcast<i32>(_e82);
let _e85 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e87 = select(_e85, _e83, (_e83 < _e85));
let _e93 = global_6.member[bitcast<u32>(select(0i, _e87, (_e87 > 0i)))];
let _e94 = (_e80 + _e82);
let _e95 = bitcast<i32>(_e94);
let _e97 = select(_e85, _e95, (_e95 < _e85));
let _e103 = global_6.member[bitcast<u32>(select(0i, _e97, (_e97 > 0i)))];
let _e105 = ((2u * _e80) + _e82);
let _e106 = bitcast<i32>(_e105);
let _e108 = select(_e85, _e106, (_e106 < _e85));
let _e114 = global_6.member[bitcast<u32>(select(0i, _e108, (_e108 > 0i)))];
let _e116 = ((3u * _e80) + _e82);
let _e117 = bitcast<i32>(_e116);
let _e119 = select(_e85, _e117, (_e117 < _e85));
let _e125 = global_6.member[bitcast<u32>(select(0i, _e119, (_e119 > 0i)))];
let _e127 = (_e93 == 2f);
if (select(3u, 0u, _e127) > 1u) {
if _e127 {
phi_1515_ = array<f32, 4>(_e93, _e103, _e114, _e125);
} else {
let _e130 = bitcast<i32>(_e80);
let _e132 = ((21i * _e130) + _e83);
let _e134 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e136 = select(_e134, _e132, (_e132 < _e134));
let _e142 = global_2.member[bitcast<u32>(select(0i, _e136, (_e136 > 0i)))];
if (_e142 <= 0f) {
phi_1514_ = array<f32, 4>(2f, 0f, -1f, 1e30f);
} else {
let _e145 = ((20i * _e130) + _e83);
let _e147 = select(_e134, _e145, (_e145 < _e134));
let _e153 = global_2.member[bitcast<u32>(select(0i, _e147, (_e147 > 0i)))];
let _e154 = bitcast<i32>(_e56.x);
let _e155 = bitcast<i32>(_e56.y);
let _e156 = bitcast<i32>(_e71);
let _e168 = global_1.member.member_3.member;
let _e169 = (((((f32(_e154) + 0.5f) / f32(_e156)) * 2f) - 1f) * _e168);
let _e178 = global_1.member.member_3.member_1;
let _e179 = ((1f - (((f32(_e155) + 0.5f) / f32(bitcast<i32>(_e75))) * 2f)) * _e178);
let _e182 = global_1.member.member_4;
let _e191 = global_1.member.member_5;
let _e198 = ((_e182.member * _e169) + (_e191.member * _e179));
let _e199 = ((_e182.member_1 * _e169) + (_e191.member_1 * _e179));
let _e200 = ((_e182.member_2 * _e169) + (_e191.member_2 * _e179));
let _e204 = global_1.member.member_3.member_3;
let _e206 = select(1f, 0f, (_e204 > 0.5f));
let _e207 = (1f - _e206);
let _e214 = global_1.member.member_4.member_3;
let _e218 = global_1.member.member_5.member_3;
let _e224 = global_1.member.member_6.member_3;
let _e228 = global_1.member.member_6;
let _e235 = (_e228.member + (_e198 * _e206));
let _e236 = (_e228.member_1 + (_e199 * _e206));
let _e237 = (_e228.member_2 + (_e200 * _e206));
let _e242 = (((_e235 * _e235) + (_e236 * _e236)) + (_e237 * _e237));
let _e245 = sqrt(select(0f, _e242, (_e242 > 0f)));
let _e248 = (1f / select(1e-20f, _e245, (_e245 > 1e-20f)));
let _e249 = (_e235 * _e248);
let _e250 = (_e236 * _e248);
let _e251 = (_e237 * _e248);
let _e255 = ((_e214 + (_e198 * _e207)) + (_e249 * _e153));
let _e256 = ((_e218 + (_e199 * _e207)) + (_e250 * _e153));
let _e257 = ((_e224 + (_e200 * _e207)) + (_e251 * _e153));
let _e258 = vec3<f32>(_e255, _e256, _e257);
local = ((_e155 * _e156) + _e154);
local_1 = _e130;
let _e261 = local_1;
let _e263 = local;
let _e264 = ((9i * _e261) + _e263);
let _e266 = select(_e134, _e264, (_e264 < _e134));
let _e271 = global_2.member[bitcast<u32>(select(0i, _e266, (_e266 > 0i)))];
let _e272 = local_1;
let _e274 = local;
let _e275 = ((10i * _e272) + _e274);
let _e277 = select(_e134, _e275, (_e275 < _e134));
let _e282 = global_2.member[bitcast<u32>(select(0i, _e277, (_e277 > 0i)))];
let _e283 = local_1;
let _e285 = local;
let _e286 = ((11i * _e283) + _e285);
let _e288 = select(_e134, _e286, (_e286 < _e134));
let _e293 = global_2.member[bitcast<u32>(select(0i, _e288, (_e288 > 0i)))];
let _e299 = (2f * (((_e249 * _e271) + (_e250 * _e282)) + (_e251 * _e293)));
let _e303 = (_e249 - (_e271 * _e299));
let _e304 = (_e250 - (_e282 * _e299));
let _e305 = (_e251 - (_e293 * _e299));
let _e306 = vec3<f32>(_e303, _e304, _e305);
if (_e93 == 0f) {
let _e325 = global_1.member.member_17;
let _e335 = ((((_e325.member * _e255) + (_e325.member_1 * _e256)) + (_e325.member_2 * _e257)) + _e325.member_3);
let _e341 = -((((_e325.member * _e303) + (_e325.member_1 * _e304)) + (_e325.member_2 * _e305)));
let _e343 = (_e341 > 1e-9f);
let _e347 = ((_e335 / select(1e-9f, _e341, _e343)) - 0.015625f);
let _e350 = select(1e30f, select(0f, _e347, (_e347 > 0f)), ((_e335 > 0f) && _e343));
let _e353 = global_1.member.member_19;
let _e363 = ((((_e353.member * _e255) + (_e353.member_1 * _e256)) + (_e353.member_2 * _e257)) + _e353.member_3);
let _e369 = -((((_e353.member * _e303) + (_e353.member_1 * _e304)) + (_e353.member_2 * _e305)));
let _e371 = (_e369 > 1e-9f);
let _e375 = ((_e363 / select(1e-9f, _e369, _e371)) - 0.015625f);
let _e378 = select(1e30f, select(0f, _e375, (_e375 > 0f)), ((_e363 > 0f) && _e371));
let _e382 = (_e378 < _e350);
phi_762_ = type_12(_e258, _e306, vec3<f32>(1f, 1f, 1f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), 1e9f, 0f, 16i, 0f, 0f, 0f, 0f, 0i, select(select(-2i, -3i, _e382), -1i, ((_e350 >= 1e30f) && (_e378 >= 1e30f))), select(_e350, _e378, _e382));
} else {
phi_762_ = type_12(_e258, _e306, vec3<f32>(1f, 1f, 1f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), 1e9f, 0f, 16i, 0f, 0f, 0f, 0f, select(0i, select(select(i32(_e103), i32(-2147483648), (_e103 < -2147483600f)), 2147483647i, (_e103 > 2147483500f)), (_e103 == _e103)), select(0i, select(select(i32(_e114), i32(-2147483648), (_e114 < -2147483600f)), 2147483647i, (_e114 > 2147483500f)), (_e114 == _e114)), _e125);
}
let _e388 = phi_762_;
let _e389 = bitcast<i32>(arrayLength((&global_3.member)));
phi_777_ = _e388;
phi_780_ = 0i;
loop {
let _e392 = phi_777_;
let _e394 = phi_780_;
local_4 = _e392;
local_5 = _e392;
let _e397 = (_e392.member_12 < (_e389 / 8i));
let _e398 = ((_e394 < 1024i) && _e397);
local_2 = _e397;
local_3 = _e392.member_12;
if _e398 {
let _e403 = (_e392.member_12 * 8i);
let _e407 = bitcast<f32>((bitcast<u32>(_e392.member_1.x) & 2147483647u));
let _e412 = (1f / select(_e392.member_1.x, select(1e-12f, -1e-12f, (_e392.member_1.x < 0f)), (_e407 < 1e-12f)));
let _e416 = bitcast<f32>((bitcast<u32>(_e392.member_1.y) & 2147483647u));
let _e421 = (1f / select(_e392.member_1.y, select(1e-12f, -1e-12f, (_e392.member_1.y < 0f)), (_e416 < 1e-12f)));
let _e425 = bitcast<f32>((bitcast<u32>(_e392.member_1.z) & 2147483647u));
let _e430 = (1f / select(_e392.member_1.z, select(1e-12f, -1e-12f, (_e392.member_1.z < 0f)), (_e425 < 1e-12f)));
let _e432 = (_e389 - 1i);
let _e434 = select(_e432, _e403, (_e403 < _e432));
let _e440 = global_3.member[bitcast<u32>(select(0i, _e434, (_e434 > 0i)))];
let _e441 = (_e403 + 1i);
let _e443 = select(_e432, _e441, (_e441 < _e432));
let _e449 = global_3.member[bitcast<u32>(select(0i, _e443, (_e443 > 0i)))];
let _e450 = (_e403 + 2i);
let _e452 = select(_e432, _e450, (_e450 < _e432));
let _e458 = global_3.member[bitcast<u32>(select(0i, _e452, (_e452 > 0i)))];
let _e459 = (_e403 + 3i);
let _e461 = select(_e432, _e459, (_e459 < _e432));
let _e467 = global_3.member[bitcast<u32>(select(0i, _e461, (_e461 > 0i)))];
let _e468 = (_e403 + 4i);
let _e470 = select(_e432, _e468, (_e468 < _e432));
let _e476 = global_3.member[bitcast<u32>(select(0i, _e470, (_e470 > 0i)))];
let _e477 = (_e403 + 5i);
let _e479 = select(_e432, _e477, (_e477 < _e432));
let _e485 = global_3.member[bitcast<u32>(select(0i, _e479, (_e479 > 0i)))];
let _e488 = ((_e440 - _e392.member.x) * _e412);
let _e490 = ((_e467 - _e392.member.x) * _e412);
let _e493 = ((_e449 - _e392.member.y) * _e421);
let _e495 = ((_e476 - _e392.member.y) * _e421);
let _e498 = ((_e458 - _e392.member.z) * _e430);
let _e500 = ((_e485 - _e392.member.z) * _e430);
let _e502 = select(_e490, _e488, (_e488 < _e490));
let _e504 = select(_e495, _e493, (_e493 < _e495));
let _e506 = select(_e504, _e502, (_e502 > _e504));
let _e508 = select(_e500, _e498, (_e498 < _e500));
let _e512 = select(_e490, _e488, (_e488 > _e490));
let _e514 = select(_e495, _e493, (_e493 > _e495));
let _e516 = select(_e514, _e512, (_e512 < _e514));
let _e518 = select(_e500, _e498, (_e498 > _e500));
let _e520 = select(_e518, _e516, (_e516 < _e518));
let _e525 = ((select(_e508, _e506, (_e506 > _e508)) <= select(_e392.member_14, _e520, (_e520 < _e392.member_14))) && (_e520 >= 0f));
let _e526 = (_e403 + 6i);
let _e528 = select(_e432, _e526, (_e526 < _e432));
let _e534 = global_3.member[bitcast<u32>(select(0i, _e528, (_e528 > 0i)))];
let _e541 = select(0i, select(select(i32(_e534), i32(-2147483648), (_e534 < -2147483600f)), 2147483647i, (_e534 > 2147483500f)), (_e534 == _e534));
if (_e525 && (_e541 >= 0i)) {
let _e546 = ((_e407 >= _e416) && (_e407 >= _e425));
let _e549 = (!(_e546) && (_e416 >= _e425));
let _e556 = (1f / select(select(_e392.member_1.z, _e392.member_1.y, _e549), _e392.member_1.x, _e546));
let _e557 = (select(select(_e392.member_1.x, _e392.member_1.z, _e549), _e392.member_1.y, _e546) * _e556);
let _e558 = (select(select(_e392.member_1.y, _e392.member_1.x, _e549), _e392.member_1.z, _e546) * _e556);
let _e559 = (_e541 * 19i);
let _e561 = (bitcast<i32>(_e63) - 1i);
let _e563 = select(_e561, _e559, (_e559 < _e561));
let _e569 = global_4.member[bitcast<u32>(select(0i, _e563, (_e563 > 0i)))];
let _e570 = (_e559 + 1i);
let _e572 = select(_e561, _e570, (_e570 < _e561));
let _e578 = global_4.member[bitcast<u32>(select(0i, _e572, (_e572 > 0i)))];
let _e579 = (_e559 + 2i);
let _e581 = select(_e561, _e579, (_e579 < _e561));
let _e587 = global_4.member[bitcast<u32>(select(0i, _e581, (_e581 > 0i)))];
let _e588 = (_e569 - _e392.member.x);
let _e589 = (_e578 - _e392.member.y);
let _e590 = (_e587 - _e392.member.z);
let _e596 = select(select(_e590, _e589, _e549), _e588, _e546);
let _e598 = (select(select(_e588, _e590, _e549), _e589, _e546) - (_e557 * _e596));
let _e600 = (select(select(_e589, _e588, _e549), _e590, _e546) - (_e558 * _e596));
let _e602 = (_e559 + 3i);
let _e604 = select(_e561, _e602, (_e602 < _e561));
let _e610 = global_4.member[bitcast<u32>(select(0i, _e604, (_e604 > 0i)))];
let _e611 = (_e559 + 4i);
let _e613 = select(_e561, _e611, (_e611 < _e561));
let _e619 = global_4.member[bitcast<u32>(select(0i, _e613, (_e613 > 0i)))];
let _e620 = (_e559 + 5i);
let _e622 = select(_e561, _e620, (_e620 < _e561));
let _e628 = global_4.member[bitcast<u32>(select(0i, _e622, (_e622 > 0i)))];
let _e629 = (_e610 - _e392.member.x);
let _e630 = (_e619 - _e392.member.y);
let _e631 = (_e628 - _e392.member.z);
let _e637 = select(select(_e631, _e630, _e549), _e629, _e546);
let _e639 = (select(select(_e629, _e631, _e549), _e630, _e546) - (_e557 * _e637));
let _e641 = (select(select(_e630, _e629, _e549), _e631, _e546) - (_e558 * _e637));
let _e643 = (_e559 + 6i);
let _e645 = select(_e561, _e643, (_e643 < _e561));
let _e651 = global_4.member[bitcast<u32>(select(0i, _e645, (_e645 > 0i)))];
let _e652 = (_e559 + 7i);
let _e654 = select(_e561, _e652, (_e652 < _e561));
let _e660 = global_4.member[bitcast<u32>(select(0i, _e654, (_e654 > 0i)))];
let _e661 = (_e559 + 8i);
let _e663 = select(_e561, _e661, (_e661 < _e561));
let _e669 = global_4.member[bitcast<u32>(select(0i, _e663, (_e663 > 0i)))];
let _e670 = (_e651 - _e392.member.x);
let _e671 = (_e660 - _e392.member.y);
let _e672 = (_e669 - _e392.member.z);
let _e678 = select(select(_e672, _e671, _e549), _e670, _e546);
let _e680 = (select(select(_e670, _e672, _e549), _e671, _e546) - (_e557 * _e678));
let _e682 = (select(select(_e671, _e670, _e549), _e672, _e546) - (_e558 * _e678));
let _e686 = ((_e680 * _e641) - (_e682 * _e639));
let _e689 = ((_e598 * _e682) - (_e600 * _e680));
let _e692 = ((_e639 * _e600) - (_e641 * _e598));
let _e694 = ((_e686 + _e689) + _e692);
let _e708 = (!(((((_e686 < 0f) || (_e689 < 0f)) || (_e692 < 0f)) && (((_e686 > 0f) || (_e689 > 0f)) || (_e692 > 0f)))) && (_e694 != 0f));
let _e715 = ((((_e686 * (_e596 * _e556)) + (_e689 * (_e637 * _e556))) + (_e692 * (_e678 * _e556))) / select(1f, _e694, _e708));
let _e718 = select(1e30f, _e715, (_e708 && (_e715 > 1e-3f)));
if (_e718 < _e392.member_14) {
let _e734 = type_12(_e392.member, _e392.member_1, _e392.member_2, _e392.member_3, _e392.member_4, _e392.member_5, _e392.member_6, _e392.member_7, _e392.member_8, _e392.member_9, _e392.member_10, _e392.member_11, _e392.member_12, _e392.member_13, _e718);
phi_1400_ = type_12(_e734.member, _e734.member_1, _e734.member_2, _e734.member_3, _e734.member_4, _e734.member_5, _e734.member_6, _e734.member_7, _e734.member_8, _e734.member_9, _e734.member_10, _e734.member_11, _e734.member_12, _e541, _e734.member_14);
} else {
phi_1400_ = _e392;
}
let _e751 = phi_1400_;
phi_1401_ = _e751;
} else {
phi_1401_ = _e392;
}
let _e753 = phi_1401_;
if _e525 {
phi_1433_ = (_e753.member_12 + 1i);
} else {
let _e754 = (_e403 + 7i);
let _e756 = select(_e432, _e754, (_e754 < _e432));
let _e762 = global_3.member[bitcast<u32>(select(0i, _e756, (_e756 > 0i)))];
phi_1433_ = select(0i, select(select(i32(_e762), i32(-2147483648), (_e762 < -2147483600f)), 2147483647i, (_e762 > 2147483500f)), (_e762 == _e762));
}
let _e773 = phi_1433_;
let _e788 = type_12(_e753.member, _e753.member_1, _e753.member_2, _e753.member_3, _e753.member_4, _e753.member_5, _e753.member_6, _e753.member_7, _e753.member_8, _e753.member_9, _e753.member_10, _e753.member_11, _e773, _e753.member_13, _e753.member_14);
let _e790 = (_e753.member_13 != _e392.member_13);
let _e793 = ((select(0i, _e753.member_13, _e790) * 19i) + 18i);
let _e795 = (bitcast<i32>(_e63) - 1i);
let _e797 = select(_e795, _e793, (_e793 < _e795));
let _e803 = global_4.member[bitcast<u32>(select(0i, _e797, (_e797 > 0i)))];
let _e810 = select(0i, select(select(i32(_e803), i32(-2147483648), (_e803 < -2147483600f)), 2147483647i, (_e803 > 2147483500f)), (_e803 == _e803));
let _e811 = (_e810 * 4i);
let _e813 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e815 = select(_e813, _e811, (_e811 < _e813));
let _e821 = global_5.member[bitcast<u32>(select(0i, _e815, (_e815 > 0i)))];
if (_e790 && (select(_e821, 1f, (_e810 == 16i)) != 0f)) {
let _e840 = type_12(_e788.member, _e788.member_1, _e788.member_2, _e788.member_3, _e788.member_4, _e788.member_5, _e788.member_6, _e788.member_7, _e788.member_8, _e788.member_9, _e788.member_10, _e788.member_11, _e788.member_12, _e392.member_13, _e788.member_14);
phi_1501_ = type_12(_e840.member, _e840.member_1, _e840.member_2, _e840.member_3, _e840.member_4, _e840.member_5, _e840.member_6, _e840.member_7, _e840.member_8, _e840.member_9, _e840.member_10, _e840.member_11, _e840.member_12, _e840.member_13, _e392.member_14);
} else {
phi_1501_ = _e788;
}
let _e857 = phi_1501_;
phi_778_ = _e857;
phi_781_ = (_e394 + 1i);
} else {
phi_778_ = type_12();
phi_781_ = i32();
}
let _e859 = phi_778_;
let _e861 = phi_781_;
continue;
continuing {
phi_777_ = _e859;
phi_780_ = _e861;
break if !(_e398);
}
}
let _e864 = local_2;
let _e867 = local_3;
let _e870 = local_4;
let _e874 = local_5;
phi_1514_ = array<f32, 4>(select(2f, 1f, _e864), f32(_e867), f32(_e870.member_13), _e874.member_14);
}
let _e878 = phi_1514_;
phi_1515_ = _e878;
}
let _e880 = phi_1515_;
global_6.member[_e82] = _e880[0];
global_6.member[_e94] = _e880[1];
global_6.member[_e105] = _e880[2];
global_6.member[_e116] = _e880[3];
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
