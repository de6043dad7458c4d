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
struct type_11 {
member: array<f32>,
}
struct type_16 {
member: array<u32>,
}
struct type_17 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_18 {
member: u32,
member_1: u32,
}
struct type_19 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_20 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: type_5,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: i32,
member_8: i32,
member_9: type_2,
member_10: u32,
member_11: type_2,
member_12: u32,
}
struct type_21 {
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
struct type_22 {
member: type_5,
member_1: type_5,
}
struct type_23 {
member: type_7,
member_1: u32,
}
struct type_24 {
member: type_2,
member_1: u32,
member_2: type_17,
member_3: type_18,
member_4: u32,
member_5: type_19,
member_6: type_20,
member_7: type_20,
member_8: type_21,
member_9: type_22,
member_10: f32,
member_11: type_19,
member_12: type_4,
member_13: type_9,
member_14: type_23,
member_15: type_23,
member_16: type_23,
member_17: type_23,
member_18: type_5,
member_19: f32,
member_20: f32,
member_21: type_6,
}
struct type_25 {
member: type_24,
}
struct type_28 {
member: array<i32, 4>,
member_1: array<u32, 6>,
}
struct type_29 {
member: f32,
member_1: vec3<f32>,
member_2: vec3<f32>,
}
struct type_30 {
member: f32,
member_1: vec3<f32>,
member_2: f32,
member_3: vec3<f32>,
member_4: vec3<f32>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_25;
@group(0) @binding(1)
var<storage> global_2: type_16;
@group(0) @binding(3)
var<storage> global_3: type_16;
@group(0) @binding(4)
var<storage> global_4: type_16;
@group(0) @binding(5)
var<storage> global_5: type_11;
@group(0) @binding(6)
var<storage, read_write> global_6: type_11;
@group(0) @binding(2)
var<storage> global_7: type_16;
fn function_() {
var local: type_28;
var local_1: vec3<f32>;
var local_2: type_28;
var local_3: vec3<f32>;
var local_4: type_28;
var local_5: vec3<f32>;
var local_6: type_28;
var local_7: vec3<f32>;
var phi_5592_: type_29;
var phi_6238_: type_30;
var phi_7107_: type_5;
var phi_8131_: f32;
var phi_8132_: f32;
var phi_8133_: f32;
var phi_8134_: bool;
switch bitcast<i32>(0u) {
default: {
let _e88 = global;
let _e91 = arrayLength((&global_2.member));
let _e98 = arrayLength((&global_4.member));
let _e105 = global_1.member.member_2;
let _e108 = global_1.member.member;
let _e116 = (_e88.x + _e105.member);
let _e118 = (_e88.y + _e105.member_1);
if (_e116 < _e105.member_2) {
if (_e118 < _e105.member_3) {
let _e121 = (_e108.member * _e108.member_1);
let _e123 = ((_e118 * _e108.member) + _e116);
let _e124 = bitcast<i32>(_e123);
let _e126 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e128 = select(_e126, _e124, (_e124 < _e126));
let _e134 = global_6.member[bitcast<u32>(select(0i, _e128, (_e128 > 0i)))];
let _e135 = (_e121 + _e123);
let _e136 = bitcast<i32>(_e135);
let _e138 = select(_e126, _e136, (_e136 < _e126));
let _e144 = global_6.member[bitcast<u32>(select(0i, _e138, (_e138 > 0i)))];
let _e146 = ((2u * _e121) + _e123);
let _e147 = bitcast<i32>(_e146);
let _e149 = select(_e126, _e147, (_e147 < _e126));
let _e155 = global_6.member[bitcast<u32>(select(0i, _e149, (_e149 > 0i)))];
let _e157 = ((3u * _e121) + _e123);
let _e158 = bitcast<i32>(_e157);
let _e160 = select(_e126, _e158, (_e158 < _e126));
let _e166 = global_6.member[bitcast<u32>(select(0i, _e160, (_e160 > 0i)))];
let _e168 = ((4u * _e121) + _e123);
let _e169 = bitcast<i32>(_e168);
let _e171 = select(_e126, _e169, (_e169 < _e126));
let _e177 = global_6.member[bitcast<u32>(select(0i, _e171, (_e171 > 0i)))];
let _e179 = ((5u * _e121) + _e123);
let _e180 = bitcast<i32>(_e179);
let _e182 = select(_e126, _e180, (_e180 < _e126));
let _e188 = global_6.member[bitcast<u32>(select(0i, _e182, (_e182 > 0i)))];
let _e190 = ((6u * _e121) + _e123);
let _e191 = bitcast<i32>(_e190);
let _e193 = select(_e126, _e191, (_e191 < _e126));
let _e199 = global_6.member[bitcast<u32>(select(0i, _e193, (_e193 > 0i)))];
let _e201 = ((7u * _e121) + _e123);
let _e202 = bitcast<i32>(_e201);
let _e204 = select(_e126, _e202, (_e202 < _e126));
let _e210 = global_6.member[bitcast<u32>(select(0i, _e204, (_e204 > 0i)))];
let _e212 = ((8u * _e121) + _e123);
let _e213 = bitcast<i32>(_e212);
let _e215 = select(_e126, _e213, (_e213 < _e126));
let _e221 = global_6.member[bitcast<u32>(select(0i, _e215, (_e215 > 0i)))];
let _e223 = ((9u * _e121) + _e123);
let _e224 = bitcast<i32>(_e223);
let _e226 = select(_e126, _e224, (_e224 < _e126));
let _e232 = global_6.member[bitcast<u32>(select(0i, _e226, (_e226 > 0i)))];
let _e234 = ((10u * _e121) + _e123);
let _e235 = bitcast<i32>(_e234);
let _e237 = select(_e126, _e235, (_e235 < _e126));
let _e243 = global_6.member[bitcast<u32>(select(0i, _e237, (_e237 > 0i)))];
let _e247 = global_1.member.member_5.member_2;
let _e250 = (1f / select(1e-6f, _e199, (_e199 > 1e-6f)));
let _e254 = global_1.member.member_8.member_5;
let _e255 = (_e247 * _e254);
let _e260 = global_1.member.member_8.member_6;
let _e262 = (((_e177 * _e250) - _e260) * _e255);
let _e267 = global_1.member.member_8.member_7;
let _e269 = (((_e188 * _e250) - _e267) * _e255);
let _e273 = ((f32(bitcast<i32>(_e116)) - 0.5f) + _e134);
let _e277 = global_1.member.member_8.member_1;
let _e278 = (_e277 + 1u);
let _e280 = select(1u, _e278, (_e278 > 0u));
let _e281 = (_e280 == 0u);
if _e281 {
break;
}
let _e286 = ((f32(bitcast<i32>((_e118 % _e280))) - 0.5f) + _e144);
let _e290 = global_1.member.member_5.member;
let _e294 = global_1.member.member_8.member_8;
let _e295 = (_e290 - _e294);
let _e299 = global_1.member.member_8.member_2;
let _e306 = global_1.member.member_8.member_4;
let _e308 = ((_e299 + (_e260 * _e295)) + ((_e273 + 0.5f) * _e306));
let _e312 = global_1.member.member_8.member_3;
let _e317 = ((_e312 + (_e267 * _e295)) + ((_e286 + 0.5f) * _e306));
let _e323 = global_1.member.member_5.member_1;
let _e324 = (_e323 - _e294);
let _e329 = ((_e299 + (_e260 * _e324)) + (((_e273 + _e262) + 0.5f) * _e306));
let _e334 = ((_e312 + (_e267 * _e324)) + (((_e286 + _e269) + 0.5f) * _e306));
if _e281 {
break;
}
let _e337 = bitcast<i32>(((_e118 / _e280) * 3u));
let _e339 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e341 = select(_e339, _e337, (_e337 < _e339));
let _e347 = global_5.member[bitcast<u32>(select(0i, _e341, (_e341 > 0i)))];
let _e348 = (_e337 + 1i);
let _e350 = select(_e339, _e348, (_e348 < _e339));
let _e356 = global_5.member[bitcast<u32>(select(0i, _e350, (_e350 > 0i)))];
let _e357 = (_e337 + 2i);
let _e359 = select(_e339, _e357, (_e357 < _e339));
let _e365 = global_5.member[bitcast<u32>(select(0i, _e359, (_e359 > 0i)))];
let _e368 = (1f / select(1e-6f, _e365, (_e365 > 1e-6f)));
let _e371 = (((_e347 * _e368) - _e260) * _e255);
let _e374 = (((_e356 * _e368) - _e267) * _e255);
let _e386 = global_1.member.member_6.member;
let _e397 = ((((_e386.member.member * _e308) + (_e386.member.member_1 * _e317)) + (_e386.member.member_2 * _e290)) + _e386.member_1);
let _e401 = global_1.member.member_6.member_1;
let _e412 = ((((_e401.member.member * _e308) + (_e401.member.member_1 * _e317)) + (_e401.member.member_2 * _e290)) + _e401.member_1);
let _e416 = global_1.member.member_6.member_2;
let _e427 = ((((_e416.member.member * _e308) + (_e416.member.member_1 * _e317)) + (_e416.member.member_2 * _e290)) + _e416.member_1);
let _e433 = ((((_e386.member.member * _e329) + (_e386.member.member_1 * _e334)) + (_e386.member.member_2 * _e323)) + _e386.member_1);
let _e439 = ((((_e401.member.member * _e329) + (_e401.member.member_1 * _e334)) + (_e401.member.member_2 * _e323)) + _e401.member_1);
let _e445 = ((((_e416.member.member * _e329) + (_e416.member.member_1 * _e334)) + (_e416.member.member_2 * _e323)) + _e416.member_1);
let _e449 = global_1.member.member_6.member_4;
let _e454 = global_1.member.member_6.member_3.member;
let _e455 = (_e454 - 0.5f);
let _e457 = select(-0.5f, _e433, (_e433 > -0.5f));
let _e459 = select(_e455, _e457, (_e457 < _e455));
let _e464 = global_1.member.member_6.member_3.member_1;
let _e465 = (_e464 - 0.5f);
let _e467 = select(-0.5f, _e439, (_e439 > -0.5f));
let _e469 = select(_e465, _e467, (_e467 < _e465));
let _e474 = global_1.member.member_6.member_3.member_2;
let _e475 = (_e474 - 0.5f);
let _e477 = select(-0.5f, _e445, (_e445 > -0.5f));
let _e479 = select(_e475, _e477, (_e477 < _e475));
let _e480 = (_e433 - _e397);
let _e481 = (_e439 - _e412);
let _e482 = (_e445 - _e427);
let _e485 = bitcast<f32>((bitcast<u32>(_e480) & 2147483647u));
let _e488 = bitcast<f32>((bitcast<u32>(_e481) & 2147483647u));
let _e490 = select(_e488, _e485, (_e485 > _e488));
let _e493 = bitcast<f32>((bitcast<u32>(_e482) & 2147483647u));
let _e502 = bitcast<f32>((bitcast<u32>((_e433 - _e459)) & 2147483647u));
let _e505 = bitcast<f32>((bitcast<u32>((_e439 - _e469)) & 2147483647u));
let _e507 = select(_e505, _e502, (_e502 > _e505));
let _e510 = bitcast<f32>((bitcast<u32>((_e445 - _e479)) & 2147483647u));
let _e514 = (_e459 + 0.5f);
let _e515 = (_e454 - 1f);
let _e517 = select(0f, _e514, (_e514 > 0f));
let _e519 = select(_e515, _e517, (_e517 < _e515));
let _e526 = select(0i, select(select(i32(_e519), i32(-2147483648), (_e519 < -2147483600f)), 2147483647i, (_e519 > 2147483500f)), (_e519 == _e519));
let _e534 = global_1.member.member_6.member_12;
let _e535 = (_e534 & 31u);
let _e538 = (_e469 + 0.5f);
let _e539 = (_e464 - 1f);
let _e541 = select(0f, _e538, (_e538 > 0f));
let _e543 = select(_e539, _e541, (_e541 < _e539));
let _e550 = select(0i, select(select(i32(_e543), i32(-2147483648), (_e543 < -2147483600f)), 2147483647i, (_e543 > 2147483500f)), (_e543 == _e543));
let _e557 = (_e479 + 0.5f);
let _e558 = (_e474 - 1f);
let _e560 = select(0f, _e557, (_e557 > 0f));
let _e562 = select(_e558, _e560, (_e560 < _e558));
let _e569 = select(0i, select(select(i32(_e562), i32(-2147483648), (_e562 < -2147483600f)), 2147483647i, (_e562 > 2147483500f)), (_e562 == _e562));
let _e580 = global_1.member.member_6.member_9.member;
let _e586 = global_1.member.member_6.member_9.member_1;
let _e591 = global_1.member.member_6.member_10;
let _e597 = ((bitcast<i32>(_e591) + ((_e526 - select(0i, 1i, (_e519 < f32(_e526)))) >> bitcast<u32>(_e535))) + (bitcast<i32>(_e580) * (((_e550 - select(0i, 1i, (_e543 < f32(_e550)))) >> bitcast<u32>(_e535)) + (bitcast<i32>(_e586) * ((_e569 - select(0i, 1i, (_e562 < f32(_e569)))) >> bitcast<u32>(_e535))))));
let _e599 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e601 = select(_e599, _e597, (_e597 < _e599));
let _e607 = global_3.member[bitcast<u32>(select(0i, _e601, (_e601 > 0i)))];
let _e614 = global_1.member.member_7.member;
let _e629 = global_1.member.member_7.member_1;
let _e644 = global_1.member.member_7.member_2;
let _e661 = ((((_e614.member.member * _e329) + (_e614.member.member_1 * _e334)) + (_e614.member.member_2 * _e323)) + _e614.member_1);
let _e667 = ((((_e629.member.member * _e329) + (_e629.member.member_1 * _e334)) + (_e629.member.member_2 * _e323)) + _e629.member_1);
let _e673 = ((((_e644.member.member * _e329) + (_e644.member.member_1 * _e334)) + (_e644.member.member_2 * _e323)) + _e644.member_1);
let _e677 = global_1.member.member_7.member_4;
let _e682 = global_1.member.member_7.member_3.member;
let _e683 = (_e682 - 0.5f);
let _e685 = select(-0.5f, _e661, (_e661 > -0.5f));
let _e687 = select(_e683, _e685, (_e685 < _e683));
let _e692 = global_1.member.member_7.member_3.member_1;
let _e693 = (_e692 - 0.5f);
let _e695 = select(-0.5f, _e667, (_e667 > -0.5f));
let _e697 = select(_e693, _e695, (_e695 < _e693));
let _e702 = global_1.member.member_7.member_3.member_2;
let _e703 = (_e702 - 0.5f);
let _e705 = select(-0.5f, _e673, (_e673 > -0.5f));
let _e707 = select(_e703, _e705, (_e705 < _e703));
let _e713 = bitcast<f32>((bitcast<u32>((_e661 - ((((_e614.member.member * _e308) + (_e614.member.member_1 * _e317)) + (_e614.member.member_2 * _e290)) + _e614.member_1))) & 2147483647u));
let _e716 = bitcast<f32>((bitcast<u32>((_e667 - ((((_e629.member.member * _e308) + (_e629.member.member_1 * _e317)) + (_e629.member.member_2 * _e290)) + _e629.member_1))) & 2147483647u));
let _e718 = select(_e716, _e713, (_e713 > _e716));
let _e721 = bitcast<f32>((bitcast<u32>((_e673 - ((((_e644.member.member * _e308) + (_e644.member.member_1 * _e317)) + (_e644.member.member_2 * _e290)) + _e644.member_1))) & 2147483647u));
let _e730 = bitcast<f32>((bitcast<u32>((_e661 - _e687)) & 2147483647u));
let _e733 = bitcast<f32>((bitcast<u32>((_e667 - _e697)) & 2147483647u));
let _e735 = select(_e733, _e730, (_e730 > _e733));
let _e738 = bitcast<f32>((bitcast<u32>((_e673 - _e707)) & 2147483647u));
let _e742 = (_e687 + 0.5f);
let _e743 = (_e682 - 1f);
let _e745 = select(0f, _e742, (_e742 > 0f));
let _e747 = select(_e743, _e745, (_e745 < _e743));
let _e754 = select(0i, select(select(i32(_e747), i32(-2147483648), (_e747 < -2147483600f)), 2147483647i, (_e747 > 2147483500f)), (_e747 == _e747));
let _e762 = global_1.member.member_7.member_12;
let _e763 = (_e762 & 31u);
let _e766 = (_e697 + 0.5f);
let _e767 = (_e692 - 1f);
let _e769 = select(0f, _e766, (_e766 > 0f));
let _e771 = select(_e767, _e769, (_e769 < _e767));
let _e778 = select(0i, select(select(i32(_e771), i32(-2147483648), (_e771 < -2147483600f)), 2147483647i, (_e771 > 2147483500f)), (_e771 == _e771));
let _e785 = (_e707 + 0.5f);
let _e786 = (_e702 - 1f);
let _e788 = select(0f, _e785, (_e785 > 0f));
let _e790 = select(_e786, _e788, (_e788 < _e786));
let _e797 = select(0i, select(select(i32(_e790), i32(-2147483648), (_e790 < -2147483600f)), 2147483647i, (_e790 > 2147483500f)), (_e790 == _e790));
let _e808 = global_1.member.member_7.member_9.member;
let _e814 = global_1.member.member_7.member_9.member_1;
let _e819 = global_1.member.member_7.member_10;
let _e825 = ((bitcast<i32>(_e819) + ((_e754 - select(0i, 1i, (_e747 < f32(_e754)))) >> bitcast<u32>(_e763))) + (bitcast<i32>(_e808) * (((_e778 - select(0i, 1i, (_e771 < f32(_e778)))) >> bitcast<u32>(_e763)) + (bitcast<i32>(_e814) * ((_e797 - select(0i, 1i, (_e790 < f32(_e797)))) >> bitcast<u32>(_e763))))));
let _e827 = select(_e599, _e825, (_e825 < _e599));
let _e833 = global_3.member[bitcast<u32>(select(0i, _e827, (_e827 > 0i)))];
let _e839 = global_1.member.member_1;
let _e846 = (((_e839 & 64u) != 0u) || ((((select(_e493, _e490, (_e490 > _e493)) <= _e449) && ((select(_e510, _e507, (_e507 > _e510)) > _e449) || (_e607 != 0u))) && ((select(_e721, _e718, (_e718 > _e721)) <= _e677) && ((select(_e738, _e735, (_e735 > _e738)) > _e677) || (_e833 != 0u)))) && ((_e839 & 32u) != 0u)));
if (select(0u, select(7u, select(3u, 1u, ((((_e262 == 0f) && (_e269 == 0f)) && (_e371 == 0f)) && (_e374 == 0f))), _e846), (_e243 == 0f)) > 1u) {
if _e281 {
break;
}
if _e281 {
break;
}
let _e853 = (_e108.member_2 == 2u);
let _e856 = (((_e108.member_2 == 1u) || _e853) || (_e108.member_2 == 5u));
if _e856 {
let _e858 = select(-1f, _e459, (_e459 > -1f));
let _e860 = select(_e454, _e858, (_e858 < _e454));
let _e867 = select(0i, select(select(i32(_e860), i32(-2147483648), (_e860 < -2147483600f)), 2147483647i, (_e860 > 2147483500f)), (_e860 == _e860));
let _e871 = (_e867 - select(0i, 1i, (_e860 < f32(_e867))));
let _e873 = select(-1f, _e469, (_e469 > -1f));
let _e875 = select(_e464, _e873, (_e873 < _e464));
let _e882 = select(0i, select(select(i32(_e875), i32(-2147483648), (_e875 < -2147483600f)), 2147483647i, (_e875 > 2147483500f)), (_e875 == _e875));
let _e886 = (_e882 - select(0i, 1i, (_e875 < f32(_e882))));
let _e888 = select(-1f, _e479, (_e479 > -1f));
let _e890 = select(_e474, _e888, (_e888 < _e474));
let _e897 = select(0i, select(select(i32(_e890), i32(-2147483648), (_e890 < -2147483600f)), 2147483647i, (_e890 > 2147483500f)), (_e890 == _e890));
let _e901 = (_e897 - select(0i, 1i, (_e890 < f32(_e897))));
let _e905 = global_1.member.member_6.member_7;
let _e909 = global_1.member.member_6.member_8;
let _e917 = (select(0i, select(select(i32(_e464), i32(-2147483648), (_e464 < -2147483600f)), 2147483647i, (_e464 > 2147483500f)), (_e464 == _e464)) - 1i);
let _e920 = (_e886 + 1i);
let _e930 = (select(0i, select(select(i32(_e474), i32(-2147483648), (_e474 < -2147483600f)), 2147483647i, (_e474 > 2147483500f)), (_e474 == _e474)) - 1i);
let _e933 = (_e901 + 1i);
let _e943 = (select(0i, select(select(i32(_e454), i32(-2147483648), (_e454 < -2147483600f)), 2147483647i, (_e454 > 2147483500f)), (_e454 == _e454)) - 1i);
let _e944 = (_e871 - 1i);
let _e949 = (_e871 + 1i);
let _e952 = (_e871 + 2i);
let _e955 = (select(0i, _e886, (_e886 > 0i)) * _e905);
let _e956 = (select(_e917, _e920, (_e920 < _e917)) * _e905);
let _e957 = (select(0i, _e901, (_e901 > 0i)) * _e909);
let _e958 = (select(_e930, _e933, (_e933 < _e930)) * _e909);
local_6 = type_28(array<i32, 4>(select(0i, _e944, (_e944 > 0i)), select(0i, _e871, (_e871 > 0i)), select(_e943, _e949, (_e949 < _e943)), select(_e943, _e952, (_e952 < _e943))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_7 = vec3<f32>((_e459 - f32(_e871)), (_e469 - f32(_e886)), (_e479 - f32(_e901)));
let _e969 = (_e957 + _e955);
let _e971 = (bitcast<i32>(_e91) - 1i);
let _e974 = local_6.member[1u];
let _e975 = (_e969 + _e974);
let _e977 = select(_e971, _e975, (_e975 < _e971));
let _e982 = global_2.member[bitcast<u32>(select(0i, _e977, (_e977 > 0i)))];
let _e983 = bitcast<f32>(_e982);
let _e986 = local_6.member[2u];
let _e987 = (_e969 + _e986);
let _e989 = select(_e971, _e987, (_e987 < _e971));
let _e994 = global_2.member[bitcast<u32>(select(0i, _e989, (_e989 > 0i)))];
let _e996 = local_7[0u];
let _e999 = (_e983 + ((bitcast<f32>(_e994) - _e983) * _e996));
let _e1000 = (_e957 + _e956);
let _e1001 = local_6.member[1u];
let _e1002 = (_e1000 + _e1001);
let _e1004 = select(_e971, _e1002, (_e1002 < _e971));
let _e1009 = global_2.member[bitcast<u32>(select(0i, _e1004, (_e1004 > 0i)))];
let _e1010 = bitcast<f32>(_e1009);
let _e1011 = local_6.member[2u];
let _e1012 = (_e1000 + _e1011);
let _e1014 = select(_e971, _e1012, (_e1012 < _e971));
let _e1019 = global_2.member[bitcast<u32>(select(0i, _e1014, (_e1014 > 0i)))];
let _e1021 = local_7[0u];
let _e1025 = (_e958 + _e955);
let _e1026 = local_6.member[1u];
let _e1027 = (_e1025 + _e1026);
let _e1029 = select(_e971, _e1027, (_e1027 < _e971));
let _e1034 = global_2.member[bitcast<u32>(select(0i, _e1029, (_e1029 > 0i)))];
let _e1035 = bitcast<f32>(_e1034);
let _e1036 = local_6.member[2u];
let _e1037 = (_e1025 + _e1036);
let _e1039 = select(_e971, _e1037, (_e1037 < _e971));
let _e1044 = global_2.member[bitcast<u32>(select(0i, _e1039, (_e1039 > 0i)))];
let _e1046 = local_7[0u];
let _e1049 = (_e1035 + ((bitcast<f32>(_e1044) - _e1035) * _e1046));
let _e1050 = (_e958 + _e956);
let _e1051 = local_6.member[1u];
let _e1052 = (_e1050 + _e1051);
let _e1054 = select(_e971, _e1052, (_e1052 < _e971));
let _e1059 = global_2.member[bitcast<u32>(select(0i, _e1054, (_e1054 > 0i)))];
let _e1060 = bitcast<f32>(_e1059);
let _e1061 = local_6.member[2u];
let _e1062 = (_e1050 + _e1061);
let _e1064 = select(_e971, _e1062, (_e1062 < _e971));
let _e1069 = global_2.member[bitcast<u32>(select(0i, _e1064, (_e1064 > 0i)))];
let _e1071 = local_7[0u];
let _e1076 = local_7[1u];
let _e1079 = (_e999 + (((_e1010 + ((bitcast<f32>(_e1019) - _e1010) * _e1021)) - _e999) * _e1076));
let _e1080 = local_7[1u];
let _e1085 = local_7[2u];
let _e1092 = global_1.member.member_6.member_5;
let _e1097 = global_1.member.member_6.member_6;
let _e1098 = (((_e1079 + (((_e1049 + (((_e1060 + ((bitcast<f32>(_e1069) - _e1060) * _e1071)) - _e1049) * _e1080)) - _e1079) * _e1085)) * _e1092) + _e1097);
let _e1100 = select(0f, _e1098, (_e1098 > 0f));
let _e1104 = select(-1f, _e687, (_e687 > -1f));
let _e1106 = select(_e682, _e1104, (_e1104 < _e682));
let _e1113 = select(0i, select(select(i32(_e1106), i32(-2147483648), (_e1106 < -2147483600f)), 2147483647i, (_e1106 > 2147483500f)), (_e1106 == _e1106));
let _e1117 = (_e1113 - select(0i, 1i, (_e1106 < f32(_e1113))));
let _e1119 = select(-1f, _e697, (_e697 > -1f));
let _e1121 = select(_e692, _e1119, (_e1119 < _e692));
let _e1128 = select(0i, select(select(i32(_e1121), i32(-2147483648), (_e1121 < -2147483600f)), 2147483647i, (_e1121 > 2147483500f)), (_e1121 == _e1121));
let _e1132 = (_e1128 - select(0i, 1i, (_e1121 < f32(_e1128))));
let _e1134 = select(-1f, _e707, (_e707 > -1f));
let _e1136 = select(_e702, _e1134, (_e1134 < _e702));
let _e1143 = select(0i, select(select(i32(_e1136), i32(-2147483648), (_e1136 < -2147483600f)), 2147483647i, (_e1136 > 2147483500f)), (_e1136 == _e1136));
let _e1147 = (_e1143 - select(0i, 1i, (_e1136 < f32(_e1143))));
let _e1151 = global_1.member.member_7.member_7;
let _e1155 = global_1.member.member_7.member_8;
let _e1163 = (select(0i, select(select(i32(_e692), i32(-2147483648), (_e692 < -2147483600f)), 2147483647i, (_e692 > 2147483500f)), (_e692 == _e692)) - 1i);
let _e1164 = (_e1132 - 1i);
let _e1169 = (_e1132 + 1i);
let _e1172 = (_e1132 + 2i);
let _e1182 = (select(0i, select(select(i32(_e702), i32(-2147483648), (_e702 < -2147483600f)), 2147483647i, (_e702 > 2147483500f)), (_e702 == _e702)) - 1i);
let _e1183 = (_e1147 - 1i);
let _e1188 = (_e1147 + 1i);
let _e1191 = (_e1147 + 2i);
let _e1201 = (select(0i, select(select(i32(_e682), i32(-2147483648), (_e682 < -2147483600f)), 2147483647i, (_e682 > 2147483500f)), (_e682 == _e682)) - 1i);
let _e1202 = (_e1117 - 1i);
let _e1207 = (_e1117 + 1i);
let _e1210 = (_e1117 + 2i);
let _e1213 = (select(0i, _e1164, (_e1164 > 0i)) * _e1151);
let _e1214 = (select(0i, _e1132, (_e1132 > 0i)) * _e1151);
let _e1215 = (select(_e1163, _e1169, (_e1169 < _e1163)) * _e1151);
let _e1216 = (select(_e1163, _e1172, (_e1172 < _e1163)) * _e1151);
let _e1217 = (select(0i, _e1183, (_e1183 > 0i)) * _e1155);
let _e1218 = (select(0i, _e1147, (_e1147 > 0i)) * _e1155);
let _e1219 = (select(_e1182, _e1188, (_e1188 < _e1182)) * _e1155);
let _e1220 = (select(_e1182, _e1191, (_e1191 < _e1182)) * _e1155);
local_4 = type_28(array<i32, 4>(select(0i, _e1202, (_e1202 > 0i)), select(0i, _e1117, (_e1117 > 0i)), select(_e1201, _e1207, (_e1207 < _e1201)), select(_e1201, _e1210, (_e1210 < _e1201))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_5 = vec3<f32>((_e687 - f32(_e1117)), (_e697 - f32(_e1132)), (_e707 - f32(_e1147)));
let _e1231 = (_e1218 + _e1214);
let _e1234 = local_4.member[0u];
let _e1235 = (_e1231 + _e1234);
let _e1237 = (bitcast<i32>(arrayLength((&global_7.member))) - 1i);
let _e1239 = select(_e1237, _e1235, (_e1235 < _e1237));
let _e1244 = global_7.member[bitcast<u32>(select(0i, _e1239, (_e1239 > 0i)))];
let _e1245 = bitcast<f32>(_e1244);
let _e1248 = local_4.member[1u];
let _e1249 = (_e1231 + _e1248);
let _e1251 = select(_e1237, _e1249, (_e1249 < _e1237));
let _e1256 = global_7.member[bitcast<u32>(select(0i, _e1251, (_e1251 > 0i)))];
let _e1257 = bitcast<f32>(_e1256);
let _e1260 = local_4.member[2u];
let _e1261 = (_e1231 + _e1260);
let _e1263 = select(_e1237, _e1261, (_e1261 < _e1237));
let _e1268 = global_7.member[bitcast<u32>(select(0i, _e1263, (_e1263 > 0i)))];
let _e1269 = bitcast<f32>(_e1268);
let _e1272 = local_4.member[3u];
let _e1273 = (_e1231 + _e1272);
let _e1275 = select(_e1237, _e1273, (_e1273 < _e1237));
let _e1280 = global_7.member[bitcast<u32>(select(0i, _e1275, (_e1275 > 0i)))];
let _e1282 = local_5[0u];
let _e1285 = (_e1245 + ((_e1257 - _e1245) * _e1282));
let _e1286 = local_5[0u];
let _e1289 = (_e1257 + ((_e1269 - _e1257) * _e1286));
let _e1290 = local_5[0u];
let _e1293 = (_e1269 + ((bitcast<f32>(_e1280) - _e1269) * _e1290));
let _e1294 = (_e1218 + _e1215);
let _e1295 = local_4.member[0u];
let _e1296 = (_e1294 + _e1295);
let _e1298 = select(_e1237, _e1296, (_e1296 < _e1237));
let _e1303 = global_7.member[bitcast<u32>(select(0i, _e1298, (_e1298 > 0i)))];
let _e1304 = bitcast<f32>(_e1303);
let _e1305 = local_4.member[1u];
let _e1306 = (_e1294 + _e1305);
let _e1308 = select(_e1237, _e1306, (_e1306 < _e1237));
let _e1313 = global_7.member[bitcast<u32>(select(0i, _e1308, (_e1308 > 0i)))];
let _e1314 = bitcast<f32>(_e1313);
let _e1315 = local_4.member[2u];
let _e1316 = (_e1294 + _e1315);
let _e1318 = select(_e1237, _e1316, (_e1316 < _e1237));
let _e1323 = global_7.member[bitcast<u32>(select(0i, _e1318, (_e1318 > 0i)))];
let _e1324 = bitcast<f32>(_e1323);
let _e1325 = local_4.member[3u];
let _e1326 = (_e1294 + _e1325);
let _e1328 = select(_e1237, _e1326, (_e1326 < _e1237));
let _e1333 = global_7.member[bitcast<u32>(select(0i, _e1328, (_e1328 > 0i)))];
let _e1335 = local_5[0u];
let _e1339 = local_5[0u];
let _e1342 = (_e1314 + ((_e1324 - _e1314) * _e1339));
let _e1343 = local_5[0u];
let _e1347 = (_e1219 + _e1214);
let _e1348 = local_4.member[0u];
let _e1349 = (_e1347 + _e1348);
let _e1351 = select(_e1237, _e1349, (_e1349 < _e1237));
let _e1356 = global_7.member[bitcast<u32>(select(0i, _e1351, (_e1351 > 0i)))];
let _e1357 = bitcast<f32>(_e1356);
let _e1358 = local_4.member[1u];
let _e1359 = (_e1347 + _e1358);
let _e1361 = select(_e1237, _e1359, (_e1359 < _e1237));
let _e1366 = global_7.member[bitcast<u32>(select(0i, _e1361, (_e1361 > 0i)))];
let _e1367 = bitcast<f32>(_e1366);
let _e1368 = local_4.member[2u];
let _e1369 = (_e1347 + _e1368);
let _e1371 = select(_e1237, _e1369, (_e1369 < _e1237));
let _e1376 = global_7.member[bitcast<u32>(select(0i, _e1371, (_e1371 > 0i)))];
let _e1377 = bitcast<f32>(_e1376);
let _e1378 = local_4.member[3u];
let _e1379 = (_e1347 + _e1378);
let _e1381 = select(_e1237, _e1379, (_e1379 < _e1237));
let _e1386 = global_7.member[bitcast<u32>(select(0i, _e1381, (_e1381 > 0i)))];
let _e1388 = local_5[0u];
let _e1391 = (_e1357 + ((_e1367 - _e1357) * _e1388));
let _e1392 = local_5[0u];
let _e1395 = (_e1367 + ((_e1377 - _e1367) * _e1392));
let _e1396 = local_5[0u];
let _e1399 = (_e1377 + ((bitcast<f32>(_e1386) - _e1377) * _e1396));
let _e1400 = (_e1219 + _e1215);
let _e1401 = local_4.member[0u];
let _e1402 = (_e1400 + _e1401);
let _e1404 = select(_e1237, _e1402, (_e1402 < _e1237));
let _e1409 = global_7.member[bitcast<u32>(select(0i, _e1404, (_e1404 > 0i)))];
let _e1410 = bitcast<f32>(_e1409);
let _e1411 = local_4.member[1u];
let _e1412 = (_e1400 + _e1411);
let _e1414 = select(_e1237, _e1412, (_e1412 < _e1237));
let _e1419 = global_7.member[bitcast<u32>(select(0i, _e1414, (_e1414 > 0i)))];
let _e1420 = bitcast<f32>(_e1419);
let _e1421 = local_4.member[2u];
let _e1422 = (_e1400 + _e1421);
let _e1424 = select(_e1237, _e1422, (_e1422 < _e1237));
let _e1429 = global_7.member[bitcast<u32>(select(0i, _e1424, (_e1424 > 0i)))];
let _e1430 = bitcast<f32>(_e1429);
let _e1431 = local_4.member[3u];
let _e1432 = (_e1400 + _e1431);
let _e1434 = select(_e1237, _e1432, (_e1432 < _e1237));
let _e1439 = global_7.member[bitcast<u32>(select(0i, _e1434, (_e1434 > 0i)))];
let _e1441 = local_5[0u];
let _e1445 = local_5[0u];
let _e1448 = (_e1420 + ((_e1430 - _e1420) * _e1445));
let _e1449 = local_5[0u];
let _e1453 = (_e1218 + _e1213);
let _e1454 = local_4.member[1u];
let _e1455 = (_e1453 + _e1454);
let _e1457 = select(_e1237, _e1455, (_e1455 < _e1237));
let _e1462 = global_7.member[bitcast<u32>(select(0i, _e1457, (_e1457 > 0i)))];
let _e1463 = bitcast<f32>(_e1462);
let _e1464 = local_4.member[2u];
let _e1465 = (_e1453 + _e1464);
let _e1467 = select(_e1237, _e1465, (_e1465 < _e1237));
let _e1472 = global_7.member[bitcast<u32>(select(0i, _e1467, (_e1467 > 0i)))];
let _e1474 = local_5[0u];
let _e1477 = (_e1463 + ((bitcast<f32>(_e1472) - _e1463) * _e1474));
let _e1478 = (_e1218 + _e1216);
let _e1479 = local_4.member[1u];
let _e1480 = (_e1478 + _e1479);
let _e1482 = select(_e1237, _e1480, (_e1480 < _e1237));
let _e1487 = global_7.member[bitcast<u32>(select(0i, _e1482, (_e1482 > 0i)))];
let _e1488 = bitcast<f32>(_e1487);
let _e1489 = local_4.member[2u];
let _e1490 = (_e1478 + _e1489);
let _e1492 = select(_e1237, _e1490, (_e1490 < _e1237));
let _e1497 = global_7.member[bitcast<u32>(select(0i, _e1492, (_e1492 > 0i)))];
let _e1499 = local_5[0u];
let _e1503 = (_e1219 + _e1213);
let _e1504 = local_4.member[1u];
let _e1505 = (_e1503 + _e1504);
let _e1507 = select(_e1237, _e1505, (_e1505 < _e1237));
let _e1512 = global_7.member[bitcast<u32>(select(0i, _e1507, (_e1507 > 0i)))];
let _e1513 = bitcast<f32>(_e1512);
let _e1514 = local_4.member[2u];
let _e1515 = (_e1503 + _e1514);
let _e1517 = select(_e1237, _e1515, (_e1515 < _e1237));
let _e1522 = global_7.member[bitcast<u32>(select(0i, _e1517, (_e1517 > 0i)))];
let _e1524 = local_5[0u];
let _e1527 = (_e1513 + ((bitcast<f32>(_e1522) - _e1513) * _e1524));
let _e1528 = (_e1219 + _e1216);
let _e1529 = local_4.member[1u];
let _e1530 = (_e1528 + _e1529);
let _e1532 = select(_e1237, _e1530, (_e1530 < _e1237));
let _e1537 = global_7.member[bitcast<u32>(select(0i, _e1532, (_e1532 > 0i)))];
let _e1538 = bitcast<f32>(_e1537);
let _e1539 = local_4.member[2u];
let _e1540 = (_e1528 + _e1539);
let _e1542 = select(_e1237, _e1540, (_e1540 < _e1237));
let _e1547 = global_7.member[bitcast<u32>(select(0i, _e1542, (_e1542 > 0i)))];
let _e1549 = local_5[0u];
let _e1553 = (_e1217 + _e1214);
let _e1554 = local_4.member[1u];
let _e1555 = (_e1553 + _e1554);
let _e1557 = select(_e1237, _e1555, (_e1555 < _e1237));
let _e1562 = global_7.member[bitcast<u32>(select(0i, _e1557, (_e1557 > 0i)))];
let _e1563 = bitcast<f32>(_e1562);
let _e1564 = local_4.member[2u];
let _e1565 = (_e1553 + _e1564);
let _e1567 = select(_e1237, _e1565, (_e1565 < _e1237));
let _e1572 = global_7.member[bitcast<u32>(select(0i, _e1567, (_e1567 > 0i)))];
let _e1574 = local_5[0u];
let _e1577 = (_e1563 + ((bitcast<f32>(_e1572) - _e1563) * _e1574));
let _e1578 = (_e1220 + _e1214);
let _e1579 = local_4.member[1u];
let _e1580 = (_e1578 + _e1579);
let _e1582 = select(_e1237, _e1580, (_e1580 < _e1237));
let _e1587 = global_7.member[bitcast<u32>(select(0i, _e1582, (_e1582 > 0i)))];
let _e1588 = bitcast<f32>(_e1587);
let _e1589 = local_4.member[2u];
let _e1590 = (_e1578 + _e1589);
let _e1592 = select(_e1237, _e1590, (_e1590 < _e1237));
let _e1597 = global_7.member[bitcast<u32>(select(0i, _e1592, (_e1592 > 0i)))];
let _e1599 = local_5[0u];
let _e1602 = (_e1588 + ((bitcast<f32>(_e1597) - _e1588) * _e1599));
let _e1603 = (_e1217 + _e1215);
let _e1604 = local_4.member[1u];
let _e1605 = (_e1603 + _e1604);
let _e1607 = select(_e1237, _e1605, (_e1605 < _e1237));
let _e1612 = global_7.member[bitcast<u32>(select(0i, _e1607, (_e1607 > 0i)))];
let _e1613 = bitcast<f32>(_e1612);
let _e1614 = local_4.member[2u];
let _e1615 = (_e1603 + _e1614);
let _e1617 = select(_e1237, _e1615, (_e1615 < _e1237));
let _e1622 = global_7.member[bitcast<u32>(select(0i, _e1617, (_e1617 > 0i)))];
let _e1624 = local_5[0u];
let _e1628 = (_e1220 + _e1215);
let _e1629 = local_4.member[1u];
let _e1630 = (_e1628 + _e1629);
let _e1632 = select(_e1237, _e1630, (_e1630 < _e1237));
let _e1637 = global_7.member[bitcast<u32>(select(0i, _e1632, (_e1632 > 0i)))];
let _e1638 = bitcast<f32>(_e1637);
let _e1639 = local_4.member[2u];
let _e1640 = (_e1628 + _e1639);
let _e1642 = select(_e1237, _e1640, (_e1640 < _e1237));
let _e1647 = global_7.member[bitcast<u32>(select(0i, _e1642, (_e1642 > 0i)))];
let _e1649 = local_5[0u];
let _e1654 = local_5[1u];
let _e1657 = (_e1289 + ((_e1342 - _e1289) * _e1654));
let _e1658 = local_5[1u];
let _e1661 = (_e1395 + ((_e1448 - _e1395) * _e1658));
let _e1662 = local_5[1u];
let _e1665 = (_e1285 + (((_e1304 + ((_e1314 - _e1304) * _e1335)) - _e1285) * _e1662));
let _e1666 = local_5[1u];
let _e1671 = local_5[2u];
let _e1675 = local_5[1u];
let _e1678 = (_e1293 + (((_e1324 + ((bitcast<f32>(_e1333) - _e1324) * _e1343)) - _e1293) * _e1675));
let _e1679 = local_5[1u];
let _e1683 = local_5[2u];
let _e1687 = local_5[1u];
let _e1690 = (_e1477 + ((_e1289 - _e1477) * _e1687));
let _e1691 = local_5[1u];
let _e1695 = local_5[2u];
let _e1699 = local_5[1u];
let _e1702 = (_e1342 + (((_e1488 + ((bitcast<f32>(_e1497) - _e1488) * _e1499)) - _e1342) * _e1699));
let _e1703 = local_5[1u];
let _e1707 = local_5[2u];
let _e1711 = local_5[1u];
let _e1714 = (_e1577 + (((_e1613 + ((bitcast<f32>(_e1622) - _e1613) * _e1624)) - _e1577) * _e1711));
let _e1715 = local_5[2u];
let _e1719 = local_5[1u];
let _e1723 = local_5[2u];
let _e1727 = local_5[2u];
let _e1734 = global_1.member.member_7.member_5;
let _e1739 = global_1.member.member_7.member_6;
let _e1740 = (((_e1657 + ((_e1661 - _e1657) * _e1727)) * _e1734) + _e1739);
let _e1742 = select(0f, _e1740, (_e1740 > 0f));
let _e1746 = (((_e1665 + (((_e1391 + (((_e1410 + ((_e1420 - _e1410) * _e1441)) - _e1391) * _e1666)) - _e1665) * _e1671)) * _e1734) + _e1739);
let _e1748 = select(0f, _e1746, (_e1746 > 0f));
let _e1750 = select(1f, _e1748, (_e1748 < 1f));
let _e1752 = (((_e1678 + (((_e1399 + (((_e1430 + ((bitcast<f32>(_e1439) - _e1430) * _e1449)) - _e1399) * _e1679)) - _e1678) * _e1683)) * _e1734) + _e1739);
let _e1754 = select(0f, _e1752, (_e1752 > 0f));
let _e1756 = select(1f, _e1754, (_e1754 < 1f));
let _e1758 = (((_e1690 + (((_e1527 + ((_e1395 - _e1527) * _e1691)) - _e1690) * _e1695)) * _e1734) + _e1739);
let _e1760 = select(0f, _e1758, (_e1758 > 0f));
let _e1762 = select(1f, _e1760, (_e1760 < 1f));
let _e1764 = (((_e1702 + (((_e1448 + (((_e1538 + ((bitcast<f32>(_e1547) - _e1538) * _e1549)) - _e1448) * _e1703)) - _e1702) * _e1707)) * _e1734) + _e1739);
let _e1766 = select(0f, _e1764, (_e1764 > 0f));
let _e1768 = select(1f, _e1766, (_e1766 < 1f));
let _e1770 = (((_e1714 + ((_e1657 - _e1714) * _e1715)) * _e1734) + _e1739);
let _e1772 = select(0f, _e1770, (_e1770 > 0f));
let _e1774 = select(1f, _e1772, (_e1772 < 1f));
let _e1776 = (((_e1661 + (((_e1602 + (((_e1638 + ((bitcast<f32>(_e1647) - _e1638) * _e1649)) - _e1602) * _e1719)) - _e1661) * _e1723)) * _e1734) + _e1739);
let _e1778 = select(0f, _e1776, (_e1776 > 0f));
let _e1780 = select(1f, _e1778, (_e1778 < 1f));
let _e1781 = (select(1f, _e1742, (_e1742 < 1f)) * 1024f);
let _e1782 = (1024f - 1f);
let _e1784 = select(0f, _e1781, (_e1781 > 0f));
let _e1786 = select(_e1782, _e1784, (_e1784 < _e1782));
let _e1793 = select(0i, select(select(i32(_e1786), i32(-2147483648), (_e1786 < -2147483600f)), 2147483647i, (_e1786 > 2147483500f)), (_e1786 == _e1786));
let _e1797 = (_e1793 - select(0i, 1i, (_e1786 < f32(_e1793))));
let _e1798 = (262147i + _e1797);
let _e1800 = (bitcast<i32>(_e98) - 1i);
let _e1802 = select(_e1800, _e1798, (_e1798 < _e1800));
let _e1808 = global_4.member[bitcast<u32>(select(0i, _e1802, (_e1802 > 0i)))];
let _e1818 = select(_e1800, 262146i, (262146i < _e1800));
let _e1824 = global_4.member[bitcast<u32>(select(0i, _e1818, (_e1818 > 0i)))];
let _e1825 = bitcast<f32>(_e1824);
let _e1826 = (f32((bitcast<i32>((_e1808 & 4095u)) - 2048i)) * _e1825);
let _e1828 = select(_e1800, 262144i, (262144i < _e1800));
let _e1834 = global_4.member[bitcast<u32>(select(0i, _e1828, (_e1828 > 0i)))];
let _e1835 = bitcast<f32>(_e1834);
let _e1837 = select(_e1800, 262145i, (262145i < _e1800));
let _e1843 = global_4.member[bitcast<u32>(select(0i, _e1837, (_e1837 > 0i)))];
let _e1844 = bitcast<f32>(_e1843);
let _e1850 = ((_e1835 + (f32(bitcast<i32>((_e1808 >> bitcast<u32>(12u)))) * _e1844)) + (_e1826 * (_e1781 - f32(_e1797))));
let _e1851 = (_e1826 * 1024f);
if _e853 {
let _e1858 = ((0.5f * (_e1756 - _e1750)) * _e1851);
let _e1859 = ((0.5f * (_e1768 - _e1762)) * _e1851);
let _e1860 = ((0.5f * (_e1780 - _e1774)) * _e1851);
phi_5592_ = type_29(_e1850, vec3<f32>(_e1858, _e1859, _e1860), vec3<f32>((_e1858 * _e1850), (_e1859 * _e1850), (_e1860 * _e1850)));
} else {
let _e1867 = (_e1750 * 1024f);
let _e1869 = select(0f, _e1867, (_e1867 > 0f));
let _e1871 = select(_e1782, _e1869, (_e1869 < _e1782));
let _e1878 = select(0i, select(select(i32(_e1871), i32(-2147483648), (_e1871 < -2147483600f)), 2147483647i, (_e1871 > 2147483500f)), (_e1871 == _e1871));
let _e1882 = (_e1878 - select(0i, 1i, (_e1871 < f32(_e1878))));
let _e1883 = (262147i + _e1882);
let _e1885 = select(_e1800, _e1883, (_e1883 < _e1800));
let _e1891 = global_4.member[bitcast<u32>(select(0i, _e1885, (_e1885 > 0i)))];
let _e1906 = ((_e1835 + (f32(bitcast<i32>((_e1891 >> bitcast<u32>(12u)))) * _e1844)) + ((f32((bitcast<i32>((_e1891 & 4095u)) - 2048i)) * _e1825) * (_e1867 - f32(_e1882))));
let _e1907 = (_e1756 * 1024f);
let _e1909 = select(0f, _e1907, (_e1907 > 0f));
let _e1911 = select(_e1782, _e1909, (_e1909 < _e1782));
let _e1918 = select(0i, select(select(i32(_e1911), i32(-2147483648), (_e1911 < -2147483600f)), 2147483647i, (_e1911 > 2147483500f)), (_e1911 == _e1911));
let _e1922 = (_e1918 - select(0i, 1i, (_e1911 < f32(_e1918))));
let _e1923 = (262147i + _e1922);
let _e1925 = select(_e1800, _e1923, (_e1923 < _e1800));
let _e1931 = global_4.member[bitcast<u32>(select(0i, _e1925, (_e1925 > 0i)))];
let _e1946 = ((_e1835 + (f32(bitcast<i32>((_e1931 >> bitcast<u32>(12u)))) * _e1844)) + ((f32((bitcast<i32>((_e1931 & 4095u)) - 2048i)) * _e1825) * (_e1907 - f32(_e1922))));
let _e1947 = (_e1762 * 1024f);
let _e1949 = select(0f, _e1947, (_e1947 > 0f));
let _e1951 = select(_e1782, _e1949, (_e1949 < _e1782));
let _e1958 = select(0i, select(select(i32(_e1951), i32(-2147483648), (_e1951 < -2147483600f)), 2147483647i, (_e1951 > 2147483500f)), (_e1951 == _e1951));
let _e1962 = (_e1958 - select(0i, 1i, (_e1951 < f32(_e1958))));
let _e1963 = (262147i + _e1962);
let _e1965 = select(_e1800, _e1963, (_e1963 < _e1800));
let _e1971 = global_4.member[bitcast<u32>(select(0i, _e1965, (_e1965 > 0i)))];
let _e1986 = ((_e1835 + (f32(bitcast<i32>((_e1971 >> bitcast<u32>(12u)))) * _e1844)) + ((f32((bitcast<i32>((_e1971 & 4095u)) - 2048i)) * _e1825) * (_e1947 - f32(_e1962))));
let _e1987 = (_e1768 * 1024f);
let _e1989 = select(0f, _e1987, (_e1987 > 0f));
let _e1991 = select(_e1782, _e1989, (_e1989 < _e1782));
let _e1998 = select(0i, select(select(i32(_e1991), i32(-2147483648), (_e1991 < -2147483600f)), 2147483647i, (_e1991 > 2147483500f)), (_e1991 == _e1991));
let _e2002 = (_e1998 - select(0i, 1i, (_e1991 < f32(_e1998))));
let _e2003 = (262147i + _e2002);
let _e2005 = select(_e1800, _e2003, (_e2003 < _e1800));
let _e2011 = global_4.member[bitcast<u32>(select(0i, _e2005, (_e2005 > 0i)))];
let _e2026 = ((_e1835 + (f32(bitcast<i32>((_e2011 >> bitcast<u32>(12u)))) * _e1844)) + ((f32((bitcast<i32>((_e2011 & 4095u)) - 2048i)) * _e1825) * (_e1987 - f32(_e2002))));
let _e2027 = (_e1774 * 1024f);
let _e2029 = select(0f, _e2027, (_e2027 > 0f));
let _e2031 = select(_e1782, _e2029, (_e2029 < _e1782));
let _e2038 = select(0i, select(select(i32(_e2031), i32(-2147483648), (_e2031 < -2147483600f)), 2147483647i, (_e2031 > 2147483500f)), (_e2031 == _e2031));
let _e2042 = (_e2038 - select(0i, 1i, (_e2031 < f32(_e2038))));
let _e2043 = (262147i + _e2042);
let _e2045 = select(_e1800, _e2043, (_e2043 < _e1800));
let _e2051 = global_4.member[bitcast<u32>(select(0i, _e2045, (_e2045 > 0i)))];
let _e2066 = ((_e1835 + (f32(bitcast<i32>((_e2051 >> bitcast<u32>(12u)))) * _e1844)) + ((f32((bitcast<i32>((_e2051 & 4095u)) - 2048i)) * _e1825) * (_e2027 - f32(_e2042))));
let _e2067 = (_e1780 * 1024f);
let _e2069 = select(0f, _e2067, (_e2067 > 0f));
let _e2071 = select(_e1782, _e2069, (_e2069 < _e1782));
let _e2078 = select(0i, select(select(i32(_e2071), i32(-2147483648), (_e2071 < -2147483600f)), 2147483647i, (_e2071 > 2147483500f)), (_e2071 == _e2071));
let _e2082 = (_e2078 - select(0i, 1i, (_e2071 < f32(_e2078))));
let _e2083 = (262147i + _e2082);
let _e2085 = select(_e1800, _e2083, (_e2083 < _e1800));
let _e2091 = global_4.member[bitcast<u32>(select(0i, _e2085, (_e2085 > 0i)))];
let _e2106 = ((_e1835 + (f32(bitcast<i32>((_e2091 >> bitcast<u32>(12u)))) * _e1844)) + ((f32((bitcast<i32>((_e2091 & 4095u)) - 2048i)) * _e1825) * (_e2067 - f32(_e2082))));
let _e2107 = (_e1946 - _e1906);
let _e2109 = (_e2026 - _e1986);
let _e2111 = (_e2106 - _e2066);
phi_5592_ = type_29(_e1850, vec3<f32>((0.5f * _e2107), (0.5f * _e2109), (0.5f * _e2111)), vec3<f32>((0.25f * (_e2107 * (_e1946 + _e1906))), (0.25f * (_e2109 * (_e2026 + _e1986))), (0.25f * (_e2111 * (_e2106 + _e2066)))));
}
let _e2126 = phi_5592_;
let _e2141 = select(0f, 1f, ((((((_e661 >= -0.5f) && (_e661 <= _e683)) && (_e667 >= -0.5f)) && (_e667 <= _e693)) && (_e673 >= -0.5f)) && (_e673 <= _e703)));
let _e2143 = (0.5f * (_e1756 - _e1750));
let _e2145 = (0.5f * (_e1768 - _e1762));
let _e2147 = (0.5f * (_e1780 - _e1774));
let _e2153 = global_1.member.member_7.member.member.member;
let _e2159 = global_1.member.member_7.member.member.member_1;
let _e2165 = global_1.member.member_7.member.member.member_2;
let _e2171 = global_1.member.member_7.member_1.member.member;
let _e2177 = global_1.member.member_7.member_1.member.member_1;
let _e2183 = global_1.member.member_7.member_1.member.member_2;
let _e2189 = global_1.member.member_7.member_2.member.member;
let _e2195 = global_1.member.member_7.member_2.member.member_1;
let _e2201 = global_1.member.member_7.member_2.member.member_2;
phi_6238_ = type_30(select(1f, _e1100, (_e1100 < 1f)), vec3<f32>(((((_e2153 * _e2143) + (_e2171 * _e2145)) + (_e2189 * _e2147)) * _e2141), ((((_e2159 * _e2143) + (_e2177 * _e2145)) + (_e2195 * _e2147)) * _e2141), ((((_e2165 * _e2143) + (_e2183 * _e2145)) + (_e2201 * _e2147)) * _e2141)), _e2126.member, vec3<f32>(((((_e2153 * _e2126.member_2.x) + (_e2171 * _e2126.member_2.y)) + (_e2189 * _e2126.member_2.z)) * _e2141), ((((_e2159 * _e2126.member_2.x) + (_e2177 * _e2126.member_2.y)) + (_e2195 * _e2126.member_2.z)) * _e2141), ((((_e2165 * _e2126.member_2.x) + (_e2183 * _e2126.member_2.y)) + (_e2201 * _e2126.member_2.z)) * _e2141)), vec3<f32>(((((_e2153 * _e2126.member_1.x) + (_e2171 * _e2126.member_1.y)) + (_e2189 * _e2126.member_1.z)) * _e2141), ((((_e2159 * _e2126.member_1.x) + (_e2177 * _e2126.member_1.y)) + (_e2195 * _e2126.member_1.z)) * _e2141), ((((_e2165 * _e2126.member_1.x) + (_e2183 * _e2126.member_1.y)) + (_e2201 * _e2126.member_1.z)) * _e2141)));
} else {
let _e2267 = select(-1f, _e459, (_e459 > -1f));
let _e2269 = select(_e454, _e2267, (_e2267 < _e454));
let _e2276 = select(0i, select(select(i32(_e2269), i32(-2147483648), (_e2269 < -2147483600f)), 2147483647i, (_e2269 > 2147483500f)), (_e2269 == _e2269));
let _e2280 = (_e2276 - select(0i, 1i, (_e2269 < f32(_e2276))));
let _e2282 = select(-1f, _e469, (_e469 > -1f));
let _e2284 = select(_e464, _e2282, (_e2282 < _e464));
let _e2291 = select(0i, select(select(i32(_e2284), i32(-2147483648), (_e2284 < -2147483600f)), 2147483647i, (_e2284 > 2147483500f)), (_e2284 == _e2284));
let _e2295 = (_e2291 - select(0i, 1i, (_e2284 < f32(_e2291))));
let _e2297 = select(-1f, _e479, (_e479 > -1f));
let _e2299 = select(_e474, _e2297, (_e2297 < _e474));
let _e2306 = select(0i, select(select(i32(_e2299), i32(-2147483648), (_e2299 < -2147483600f)), 2147483647i, (_e2299 > 2147483500f)), (_e2299 == _e2299));
let _e2310 = (_e2306 - select(0i, 1i, (_e2299 < f32(_e2306))));
let _e2314 = global_1.member.member_6.member_7;
let _e2318 = global_1.member.member_6.member_8;
let _e2326 = (select(0i, select(select(i32(_e464), i32(-2147483648), (_e464 < -2147483600f)), 2147483647i, (_e464 > 2147483500f)), (_e464 == _e464)) - 1i);
let _e2329 = (_e2295 + 1i);
let _e2339 = (select(0i, select(select(i32(_e474), i32(-2147483648), (_e474 < -2147483600f)), 2147483647i, (_e474 > 2147483500f)), (_e474 == _e474)) - 1i);
let _e2342 = (_e2310 + 1i);
let _e2352 = (select(0i, select(select(i32(_e454), i32(-2147483648), (_e454 < -2147483600f)), 2147483647i, (_e454 > 2147483500f)), (_e454 == _e454)) - 1i);
let _e2353 = (_e2280 - 1i);
let _e2358 = (_e2280 + 1i);
let _e2361 = (_e2280 + 2i);
let _e2364 = (select(0i, _e2295, (_e2295 > 0i)) * _e2314);
let _e2365 = (select(_e2326, _e2329, (_e2329 < _e2326)) * _e2314);
let _e2366 = (select(0i, _e2310, (_e2310 > 0i)) * _e2318);
let _e2367 = (select(_e2339, _e2342, (_e2342 < _e2339)) * _e2318);
local_2 = type_28(array<i32, 4>(select(0i, _e2353, (_e2353 > 0i)), select(0i, _e2280, (_e2280 > 0i)), select(_e2352, _e2358, (_e2358 < _e2352)), select(_e2352, _e2361, (_e2361 < _e2352))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_3 = vec3<f32>((_e459 - f32(_e2280)), (_e469 - f32(_e2295)), (_e479 - f32(_e2310)));
let _e2378 = (_e2366 + _e2364);
let _e2381 = local_2.member[1u];
let _e2382 = (_e2378 + _e2381);
let _e2384 = (bitcast<i32>(_e91) - 1i);
let _e2386 = select(_e2384, _e2382, (_e2382 < _e2384));
let _e2391 = global_2.member[bitcast<u32>(select(0i, _e2386, (_e2386 > 0i)))];
let _e2392 = bitcast<f32>(_e2391);
let _e2395 = local_2.member[2u];
let _e2396 = (_e2378 + _e2395);
let _e2398 = select(_e2384, _e2396, (_e2396 < _e2384));
let _e2403 = global_2.member[bitcast<u32>(select(0i, _e2398, (_e2398 > 0i)))];
let _e2405 = local_3[0u];
let _e2408 = (_e2392 + ((bitcast<f32>(_e2403) - _e2392) * _e2405));
let _e2409 = (_e2366 + _e2365);
let _e2410 = local_2.member[1u];
let _e2411 = (_e2409 + _e2410);
let _e2413 = select(_e2384, _e2411, (_e2411 < _e2384));
let _e2418 = global_2.member[bitcast<u32>(select(0i, _e2413, (_e2413 > 0i)))];
let _e2419 = bitcast<f32>(_e2418);
let _e2420 = local_2.member[2u];
let _e2421 = (_e2409 + _e2420);
let _e2423 = select(_e2384, _e2421, (_e2421 < _e2384));
let _e2428 = global_2.member[bitcast<u32>(select(0i, _e2423, (_e2423 > 0i)))];
let _e2430 = local_3[0u];
let _e2435 = local_3[1u];
let _e2438 = (_e2408 + (((_e2419 + ((bitcast<f32>(_e2428) - _e2419) * _e2430)) - _e2408) * _e2435));
let _e2439 = (_e2367 + _e2364);
let _e2440 = local_2.member[1u];
let _e2441 = (_e2439 + _e2440);
let _e2443 = select(_e2384, _e2441, (_e2441 < _e2384));
let _e2448 = global_2.member[bitcast<u32>(select(0i, _e2443, (_e2443 > 0i)))];
let _e2449 = bitcast<f32>(_e2448);
let _e2450 = local_2.member[2u];
let _e2451 = (_e2439 + _e2450);
let _e2453 = select(_e2384, _e2451, (_e2451 < _e2384));
let _e2458 = global_2.member[bitcast<u32>(select(0i, _e2453, (_e2453 > 0i)))];
let _e2460 = local_3[0u];
let _e2463 = (_e2449 + ((bitcast<f32>(_e2458) - _e2449) * _e2460));
let _e2464 = (_e2367 + _e2365);
let _e2465 = local_2.member[1u];
let _e2466 = (_e2464 + _e2465);
let _e2468 = select(_e2384, _e2466, (_e2466 < _e2384));
let _e2473 = global_2.member[bitcast<u32>(select(0i, _e2468, (_e2468 > 0i)))];
let _e2474 = bitcast<f32>(_e2473);
let _e2475 = local_2.member[2u];
let _e2476 = (_e2464 + _e2475);
let _e2478 = select(_e2384, _e2476, (_e2476 < _e2384));
let _e2483 = global_2.member[bitcast<u32>(select(0i, _e2478, (_e2478 > 0i)))];
let _e2485 = local_3[0u];
let _e2489 = local_3[1u];
let _e2494 = local_3[2u];
let _e2501 = global_1.member.member_6.member_5;
let _e2506 = global_1.member.member_6.member_6;
let _e2507 = (((_e2438 + (((_e2463 + (((_e2474 + ((bitcast<f32>(_e2483) - _e2474) * _e2485)) - _e2463) * _e2489)) - _e2438) * _e2494)) * _e2501) + _e2506);
let _e2509 = select(0f, _e2507, (_e2507 > 0f));
phi_6238_ = type_30(select(1f, _e2509, (_e2509 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2514 = phi_6238_;
let _e2516 = select(-0.5f, _e397, (_e397 > -0.5f));
let _e2518 = select(_e455, _e2516, (_e2516 < _e455));
let _e2520 = select(-0.5f, _e412, (_e412 > -0.5f));
let _e2522 = select(_e465, _e2520, (_e2520 < _e465));
let _e2524 = select(-0.5f, _e427, (_e427 > -0.5f));
let _e2526 = select(_e475, _e2524, (_e2524 < _e475));
let _e2528 = select(-1f, _e2518, (_e2518 > -1f));
let _e2530 = select(_e454, _e2528, (_e2528 < _e454));
let _e2537 = select(0i, select(select(i32(_e2530), i32(-2147483648), (_e2530 < -2147483600f)), 2147483647i, (_e2530 > 2147483500f)), (_e2530 == _e2530));
let _e2541 = (_e2537 - select(0i, 1i, (_e2530 < f32(_e2537))));
let _e2543 = select(-1f, _e2522, (_e2522 > -1f));
let _e2545 = select(_e464, _e2543, (_e2543 < _e464));
let _e2552 = select(0i, select(select(i32(_e2545), i32(-2147483648), (_e2545 < -2147483600f)), 2147483647i, (_e2545 > 2147483500f)), (_e2545 == _e2545));
let _e2556 = (_e2552 - select(0i, 1i, (_e2545 < f32(_e2552))));
let _e2558 = select(-1f, _e2526, (_e2526 > -1f));
let _e2560 = select(_e474, _e2558, (_e2558 < _e474));
let _e2567 = select(0i, select(select(i32(_e2560), i32(-2147483648), (_e2560 < -2147483600f)), 2147483647i, (_e2560 > 2147483500f)), (_e2560 == _e2560));
let _e2571 = (_e2567 - select(0i, 1i, (_e2560 < f32(_e2567))));
let _e2575 = global_1.member.member_6.member_7;
let _e2579 = global_1.member.member_6.member_8;
let _e2587 = (select(0i, select(select(i32(_e464), i32(-2147483648), (_e464 < -2147483600f)), 2147483647i, (_e464 > 2147483500f)), (_e464 == _e464)) - 1i);
let _e2590 = (_e2556 + 1i);
let _e2600 = (select(0i, select(select(i32(_e474), i32(-2147483648), (_e474 < -2147483600f)), 2147483647i, (_e474 > 2147483500f)), (_e474 == _e474)) - 1i);
let _e2603 = (_e2571 + 1i);
let _e2613 = (select(0i, select(select(i32(_e454), i32(-2147483648), (_e454 < -2147483600f)), 2147483647i, (_e454 > 2147483500f)), (_e454 == _e454)) - 1i);
let _e2614 = (_e2541 - 1i);
let _e2619 = (_e2541 + 1i);
let _e2622 = (_e2541 + 2i);
let _e2625 = (select(0i, _e2556, (_e2556 > 0i)) * _e2575);
let _e2626 = (select(_e2587, _e2590, (_e2590 < _e2587)) * _e2575);
let _e2627 = (select(0i, _e2571, (_e2571 > 0i)) * _e2579);
let _e2628 = (select(_e2600, _e2603, (_e2603 < _e2600)) * _e2579);
local = type_28(array<i32, 4>(select(0i, _e2614, (_e2614 > 0i)), select(0i, _e2541, (_e2541 > 0i)), select(_e2613, _e2619, (_e2619 < _e2613)), select(_e2613, _e2622, (_e2622 < _e2613))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_1 = vec3<f32>((_e2518 - f32(_e2541)), (_e2522 - f32(_e2556)), (_e2526 - f32(_e2571)));
let _e2639 = (_e2627 + _e2625);
let _e2642 = local.member[1u];
let _e2643 = (_e2639 + _e2642);
let _e2645 = (bitcast<i32>(_e91) - 1i);
let _e2647 = select(_e2645, _e2643, (_e2643 < _e2645));
let _e2652 = global_2.member[bitcast<u32>(select(0i, _e2647, (_e2647 > 0i)))];
let _e2653 = bitcast<f32>(_e2652);
let _e2656 = local.member[2u];
let _e2657 = (_e2639 + _e2656);
let _e2659 = select(_e2645, _e2657, (_e2657 < _e2645));
let _e2664 = global_2.member[bitcast<u32>(select(0i, _e2659, (_e2659 > 0i)))];
let _e2666 = local_1[0u];
let _e2669 = (_e2653 + ((bitcast<f32>(_e2664) - _e2653) * _e2666));
let _e2670 = (_e2627 + _e2626);
let _e2671 = local.member[1u];
let _e2672 = (_e2670 + _e2671);
let _e2674 = select(_e2645, _e2672, (_e2672 < _e2645));
let _e2679 = global_2.member[bitcast<u32>(select(0i, _e2674, (_e2674 > 0i)))];
let _e2680 = bitcast<f32>(_e2679);
let _e2681 = local.member[2u];
let _e2682 = (_e2670 + _e2681);
let _e2684 = select(_e2645, _e2682, (_e2682 < _e2645));
let _e2689 = global_2.member[bitcast<u32>(select(0i, _e2684, (_e2684 > 0i)))];
let _e2691 = local_1[0u];
let _e2696 = local_1[1u];
let _e2699 = (_e2669 + (((_e2680 + ((bitcast<f32>(_e2689) - _e2680) * _e2691)) - _e2669) * _e2696));
let _e2700 = (_e2628 + _e2625);
let _e2701 = local.member[1u];
let _e2702 = (_e2700 + _e2701);
let _e2704 = select(_e2645, _e2702, (_e2702 < _e2645));
let _e2709 = global_2.member[bitcast<u32>(select(0i, _e2704, (_e2704 > 0i)))];
let _e2710 = bitcast<f32>(_e2709);
let _e2711 = local.member[2u];
let _e2712 = (_e2700 + _e2711);
let _e2714 = select(_e2645, _e2712, (_e2712 < _e2645));
let _e2719 = global_2.member[bitcast<u32>(select(0i, _e2714, (_e2714 > 0i)))];
let _e2721 = local_1[0u];
let _e2724 = (_e2710 + ((bitcast<f32>(_e2719) - _e2710) * _e2721));
let _e2725 = (_e2628 + _e2626);
let _e2726 = local.member[1u];
let _e2727 = (_e2725 + _e2726);
let _e2729 = select(_e2645, _e2727, (_e2727 < _e2645));
let _e2734 = global_2.member[bitcast<u32>(select(0i, _e2729, (_e2729 > 0i)))];
let _e2735 = bitcast<f32>(_e2734);
let _e2736 = local.member[2u];
let _e2737 = (_e2725 + _e2736);
let _e2739 = select(_e2645, _e2737, (_e2737 < _e2645));
let _e2744 = global_2.member[bitcast<u32>(select(0i, _e2739, (_e2739 > 0i)))];
let _e2746 = local_1[0u];
let _e2750 = local_1[1u];
let _e2755 = local_1[2u];
let _e2762 = global_1.member.member_6.member_5;
let _e2767 = global_1.member.member_6.member_6;
let _e2768 = (((_e2699 + (((_e2724 + (((_e2735 + ((bitcast<f32>(_e2744) - _e2735) * _e2746)) - _e2724) * _e2750)) - _e2699) * _e2755)) * _e2762) + _e2767);
let _e2770 = select(0f, _e2768, (_e2768 > 0f));
if ((_e839 & 16u) == 0u) {
phi_7107_ = type_5(1f, 1f, 1f);
} else {
let _e2778 = global_1.member.member_14.member;
let _e2789 = ((((_e2778.member.member * _e308) + (_e2778.member.member_1 * _e317)) + (_e2778.member.member_2 * _e290)) + _e2778.member_1);
let _e2795 = ((((_e2778.member.member * _e329) + (_e2778.member.member_1 * _e334)) + (_e2778.member.member_2 * _e323)) + _e2778.member_1);
let _e2797 = select(_e2795, _e2789, (_e2789 < _e2795));
let _e2799 = select(_e2795, _e2789, (_e2789 > _e2795));
let _e2801 = (_e2799 - _e2797);
let _e2804 = (-(_e2797) / select(1e-30f, _e2801, (_e2801 > 1e-30f)));
let _e2806 = select(0f, _e2804, (_e2804 > 0f));
let _e2812 = select(select(select(1f, _e2806, (_e2806 < 1f)), 1f, (_e2799 <= 0f)), 0f, (_e2797 > 0f));
let _e2817 = global_1.member.member_14.member_1;
let _e2818 = (_e2817 != 0u);
let _e2828 = global_1.member.member_15.member;
let _e2839 = ((((_e2828.member.member * _e308) + (_e2828.member.member_1 * _e317)) + (_e2828.member.member_2 * _e290)) + _e2828.member_1);
let _e2845 = ((((_e2828.member.member * _e329) + (_e2828.member.member_1 * _e334)) + (_e2828.member.member_2 * _e323)) + _e2828.member_1);
let _e2847 = select(_e2845, _e2839, (_e2839 < _e2845));
let _e2849 = select(_e2845, _e2839, (_e2839 > _e2845));
let _e2851 = (_e2849 - _e2847);
let _e2854 = (-(_e2847) / select(1e-30f, _e2851, (_e2851 > 1e-30f)));
let _e2856 = select(0f, _e2854, (_e2854 > 0f));
let _e2862 = select(select(select(1f, _e2856, (_e2856 < 1f)), 1f, (_e2849 <= 0f)), 0f, (_e2847 > 0f));
let _e2867 = global_1.member.member_15.member_1;
let _e2868 = (_e2867 != 0u);
let _e2878 = global_1.member.member_16.member;
let _e2889 = ((((_e2878.member.member * _e308) + (_e2878.member.member_1 * _e317)) + (_e2878.member.member_2 * _e290)) + _e2878.member_1);
let _e2895 = ((((_e2878.member.member * _e329) + (_e2878.member.member_1 * _e334)) + (_e2878.member.member_2 * _e323)) + _e2878.member_1);
let _e2897 = select(_e2895, _e2889, (_e2889 < _e2895));
let _e2899 = select(_e2895, _e2889, (_e2889 > _e2895));
let _e2901 = (_e2899 - _e2897);
let _e2904 = (-(_e2897) / select(1e-30f, _e2901, (_e2901 > 1e-30f)));
let _e2906 = select(0f, _e2904, (_e2904 > 0f));
let _e2912 = select(select(select(1f, _e2906, (_e2906 < 1f)), 1f, (_e2899 <= 0f)), 0f, (_e2897 > 0f));
let _e2917 = global_1.member.member_16.member_1;
let _e2918 = (_e2917 != 0u);
let _e2928 = global_1.member.member_17.member;
let _e2939 = ((((_e2928.member.member * _e308) + (_e2928.member.member_1 * _e317)) + (_e2928.member.member_2 * _e290)) + _e2928.member_1);
let _e2945 = ((((_e2928.member.member * _e329) + (_e2928.member.member_1 * _e334)) + (_e2928.member.member_2 * _e323)) + _e2928.member_1);
let _e2947 = select(_e2945, _e2939, (_e2939 < _e2945));
let _e2949 = select(_e2945, _e2939, (_e2939 > _e2945));
let _e2951 = (_e2949 - _e2947);
let _e2954 = (-(_e2947) / select(1e-30f, _e2951, (_e2951 > 1e-30f)));
let _e2956 = select(0f, _e2954, (_e2954 > 0f));
let _e2962 = select(select(select(1f, _e2956, (_e2956 < 1f)), 1f, (_e2949 <= 0f)), 0f, (_e2947 > 0f));
let _e2967 = global_1.member.member_17.member_1;
let _e2968 = (_e2967 != 0u);
phi_7107_ = type_5(((((1f * _e2812) * _e2862) * _e2912) * _e2962), ((((1f * select(1f, _e2812, _e2818)) * select(1f, _e2862, _e2868)) * select(1f, _e2912, _e2918)) * select(1f, _e2962, _e2968)), ((((1f * select(1f, 0f, (_e2818 && (_e2795 > 0f)))) * select(1f, 0f, (_e2868 && (_e2845 > 0f)))) * select(1f, 0f, (_e2918 && (_e2895 > 0f)))) * select(1f, 0f, (_e2968 && (_e2945 > 0f)))));
}
let _e2977 = phi_7107_;
let _e2978 = (_e329 - _e308);
let _e2979 = (_e334 - _e317);
let _e2980 = (_e323 - _e290);
let _e2985 = (((_e2978 * _e2978) + (_e2979 * _e2979)) + (_e2980 * _e2980));
let _e2989 = (_e485 < 1e-12f);
let _e2991 = (1f / select(_e480, 1f, _e2989));
let _e2993 = ((-0.5f - _e397) * _e2991);
let _e2995 = ((_e455 - _e397) * _e2991);
let _e3001 = select(_e2995, _e2993, (_e2993 < _e2995));
let _e3003 = select(0f, _e3001, (_e3001 > 0f));
let _e3006 = select(select(1f, _e3003, (_e3003 < 1f)), select(2f, 0f, ((_e397 >= -0.5f) && (_e397 <= _e455))), _e2989);
let _e3008 = select(_e2995, _e2993, (_e2993 > _e2995));
let _e3010 = select(0f, _e3008, (_e3008 > 0f));
let _e3013 = select(select(1f, _e3010, (_e3010 < 1f)), 1f, _e2989);
let _e3014 = (_e488 < 1e-12f);
let _e3016 = (1f / select(_e481, 1f, _e3014));
let _e3018 = ((-0.5f - _e412) * _e3016);
let _e3020 = ((_e465 - _e412) * _e3016);
let _e3026 = select(_e3020, _e3018, (_e3018 < _e3020));
let _e3028 = select(0f, _e3026, (_e3026 > 0f));
let _e3031 = select(select(1f, _e3028, (_e3028 < 1f)), select(2f, 0f, ((_e412 >= -0.5f) && (_e412 <= _e465))), _e3014);
let _e3033 = select(_e3020, _e3018, (_e3018 > _e3020));
let _e3035 = select(0f, _e3033, (_e3033 > 0f));
let _e3038 = select(select(1f, _e3035, (_e3035 < 1f)), 1f, _e3014);
let _e3039 = (_e493 < 1e-12f);
let _e3041 = (1f / select(_e482, 1f, _e3039));
let _e3043 = ((-0.5f - _e427) * _e3041);
let _e3045 = ((_e475 - _e427) * _e3041);
let _e3051 = select(_e3045, _e3043, (_e3043 < _e3045));
let _e3053 = select(0f, _e3051, (_e3051 > 0f));
let _e3056 = select(select(1f, _e3053, (_e3053 < 1f)), select(2f, 0f, ((_e427 >= -0.5f) && (_e427 <= _e475))), _e3039);
let _e3058 = select(_e3045, _e3043, (_e3043 > _e3045));
let _e3060 = select(0f, _e3058, (_e3058 > 0f));
let _e3063 = select(select(1f, _e3060, (_e3060 < 1f)), 1f, _e3039);
let _e3065 = select(_e3038, _e3013, (_e3013 < _e3038));
let _e3069 = select(_e3031, _e3006, (_e3006 > _e3031));
let _e3072 = (select(_e3063, _e3065, (_e3065 < _e3063)) - select(_e3056, _e3069, (_e3069 > _e3056)));
let _e3079 = global_1.member.member_5.member_3;
let _e3080 = ((sqrt(select(0f, _e2985, (_e2985 > 0f))) * select(0f, _e3072, (_e3072 > 0f))) * _e3079);
let _e3082 = (select(1f, _e2770, (_e2770 < 1f)) * 255f);
let _e3083 = (_e2514.member * 255f);
let _e3084 = (255f - 1f);
let _e3086 = select(0f, _e3082, (_e3082 > 0f));
let _e3088 = select(_e3084, _e3086, (_e3086 < _e3084));
let _e3095 = select(0i, select(select(i32(_e3088), i32(-2147483648), (_e3088 < -2147483600f)), 2147483647i, (_e3088 > 2147483500f)), (_e3088 == _e3088));
let _e3099 = (_e3095 - select(0i, 1i, (_e3088 < f32(_e3095))));
let _e3101 = select(0f, _e3083, (_e3083 > 0f));
let _e3103 = select(_e3084, _e3101, (_e3101 < _e3084));
let _e3110 = select(0i, select(select(i32(_e3103), i32(-2147483648), (_e3103 < -2147483600f)), 2147483647i, (_e3103 > 2147483500f)), (_e3103 == _e3103));
let _e3114 = (_e3110 - select(0i, 1i, (_e3103 < f32(_e3110))));
let _e3117 = (((_e3099 * 256i) + _e3114) * 4i);
let _e3119 = (_e3082 - f32(_e3099));
let _e3121 = (_e3083 - f32(_e3114));
let _e3123 = (bitcast<i32>(_e98) - 1i);
let _e3125 = select(_e3123, _e3117, (_e3117 < _e3123));
let _e3131 = global_4.member[bitcast<u32>(select(0i, _e3125, (_e3125 > 0i)))];
let _e3132 = (_e3117 + 4i);
let _e3134 = select(_e3123, _e3132, (_e3132 < _e3123));
let _e3140 = global_4.member[bitcast<u32>(select(0i, _e3134, (_e3134 > 0i)))];
let _e3141 = (_e3117 + 1024i);
let _e3143 = select(_e3123, _e3141, (_e3141 < _e3123));
let _e3149 = global_4.member[bitcast<u32>(select(0i, _e3143, (_e3143 > 0i)))];
let _e3150 = (_e3117 + 1028i);
let _e3152 = select(_e3123, _e3150, (_e3150 < _e3123));
let _e3158 = global_4.member[bitcast<u32>(select(0i, _e3152, (_e3152 > 0i)))];
let _e3163 = (bitcast<f32>(((_e3131 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3171 = (_e3163 + (((bitcast<f32>(((_e3140 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3163) * _e3121));
let _e3176 = (bitcast<f32>(((_e3149 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3200 = (bitcast<f32>((((_e3131 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3208 = (_e3200 + (((bitcast<f32>((((_e3140 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3200) * _e3121));
let _e3213 = (bitcast<f32>((((_e3149 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3225 = (_e3117 + 1i);
let _e3227 = select(_e3123, _e3225, (_e3225 < _e3123));
let _e3233 = global_4.member[bitcast<u32>(select(0i, _e3227, (_e3227 > 0i)))];
let _e3234 = (_e3117 + 5i);
let _e3236 = select(_e3123, _e3234, (_e3234 < _e3123));
let _e3242 = global_4.member[bitcast<u32>(select(0i, _e3236, (_e3236 > 0i)))];
let _e3243 = (_e3117 + 1025i);
let _e3245 = select(_e3123, _e3243, (_e3243 < _e3123));
let _e3251 = global_4.member[bitcast<u32>(select(0i, _e3245, (_e3245 > 0i)))];
let _e3252 = (_e3117 + 1029i);
let _e3254 = select(_e3123, _e3252, (_e3252 < _e3123));
let _e3260 = global_4.member[bitcast<u32>(select(0i, _e3254, (_e3254 > 0i)))];
let _e3265 = (bitcast<f32>(((_e3233 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3273 = (_e3265 + (((bitcast<f32>(((_e3242 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3265) * _e3121));
let _e3278 = (bitcast<f32>(((_e3251 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3302 = (bitcast<f32>((((_e3233 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3310 = (_e3302 + (((bitcast<f32>((((_e3242 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3302) * _e3121));
let _e3315 = (bitcast<f32>((((_e3251 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3330 = (_e3080 * _e2977.member_1);
let _e3332 = -(((_e3208 + (((_e3213 + (((bitcast<f32>((((_e3158 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3213) * _e3121)) - _e3208) * _e3119)) * _e3330));
let _e3334 = select(-87f, _e3332, (_e3332 > -87f));
let _e3336 = select(88f, _e3334, (_e3334 < 88f));
let _e3338 = ((_e3336 * 1.442695f) + 0.5f);
let _e3340 = select(-127f, _e3338, (_e3338 > -127f));
let _e3342 = select(128f, _e3340, (_e3340 < 128f));
let _e3349 = select(0i, select(select(i32(_e3342), i32(-2147483648), (_e3342 < -2147483600f)), 2147483647i, (_e3342 > 2147483500f)), (_e3342 == _e3342));
let _e3353 = (_e3349 - select(0i, 1i, (_e3342 < f32(_e3349))));
let _e3354 = f32(_e3353);
let _e3358 = ((_e3336 - (_e3354 * 0.6933594f)) - (_e3354 * -2.1219444e-4f));
let _e3380 = -(((_e3273 + (((_e3278 + (((bitcast<f32>(((_e3260 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3278) * _e3121)) - _e3273) * _e3119)) * _e3330));
let _e3382 = select(-87f, _e3380, (_e3380 > -87f));
let _e3384 = select(88f, _e3382, (_e3382 < 88f));
let _e3386 = ((_e3384 * 1.442695f) + 0.5f);
let _e3388 = select(-127f, _e3386, (_e3386 > -127f));
let _e3390 = select(128f, _e3388, (_e3388 < 128f));
let _e3397 = select(0i, select(select(i32(_e3390), i32(-2147483648), (_e3390 < -2147483600f)), 2147483647i, (_e3390 > 2147483500f)), (_e3390 == _e3390));
let _e3401 = (_e3397 - select(0i, 1i, (_e3390 < f32(_e3397))));
let _e3402 = f32(_e3401);
let _e3406 = ((_e3384 - (_e3402 * 0.6933594f)) - (_e3402 * -2.1219444e-4f));
let _e3428 = -(((_e3310 + (((_e3315 + (((bitcast<f32>((((_e3260 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3315) * _e3121)) - _e3310) * _e3119)) * _e3330));
let _e3430 = select(-87f, _e3428, (_e3428 > -87f));
let _e3432 = select(88f, _e3430, (_e3430 < 88f));
let _e3434 = ((_e3432 * 1.442695f) + 0.5f);
let _e3436 = select(-127f, _e3434, (_e3434 > -127f));
let _e3438 = select(128f, _e3436, (_e3436 < 128f));
let _e3445 = select(0i, select(select(i32(_e3438), i32(-2147483648), (_e3438 < -2147483600f)), 2147483647i, (_e3438 > 2147483500f)), (_e3438 == _e3438));
let _e3449 = (_e3445 - select(0i, 1i, (_e3438 < f32(_e3445))));
let _e3450 = f32(_e3449);
let _e3454 = ((_e3432 - (_e3450 * 0.6933594f)) - (_e3450 * -2.1219444e-4f));
let _e3476 = -(((_e3171 + (((_e3176 + (((bitcast<f32>(((_e3158 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3176) * _e3121)) - _e3171) * _e3119)) * (_e3080 * _e2977.member)));
let _e3478 = select(-87f, _e3476, (_e3476 > -87f));
let _e3480 = select(88f, _e3478, (_e3478 < 88f));
let _e3482 = ((_e3480 * 1.442695f) + 0.5f);
let _e3484 = select(-127f, _e3482, (_e3482 > -127f));
let _e3486 = select(128f, _e3484, (_e3484 < 128f));
let _e3493 = select(0i, select(select(i32(_e3486), i32(-2147483648), (_e3486 < -2147483600f)), 2147483647i, (_e3486 > 2147483500f)), (_e3486 == _e3486));
let _e3497 = (_e3493 - select(0i, 1i, (_e3486 < f32(_e3493))));
let _e3498 = f32(_e3497);
let _e3502 = ((_e3480 - (_e3498 * 0.6933594f)) - (_e3498 * -2.1219444e-4f));
let _e3522 = ((1f + (_e3502 * (1f + (_e3502 * (0.5f + (_e3502 * (0.16666667f + (_e3502 * (0.041666668f + (_e3502 * (0.008333334f + (_e3502 * (0.001388889f + (_e3502 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3497 + 127i)) << bitcast<u32>(23i))));
if _e856 {
let _e3537 = global_1.member.member_5.member_4;
let _e3540 = (_e2514.member_3.x * _e2977.member_2);
let _e3542 = (_e2514.member_3.y * _e2977.member_2);
let _e3544 = (_e2514.member_3.z * _e2977.member_2);
let _e3545 = (0.5f * (_e247 / _e199));
let _e3549 = (_e177 + (_e3540 * _e3545));
let _e3550 = (_e188 + (_e3542 * _e3545));
let _e3551 = (_e199 + (_e3544 * _e3545));
let _e3553 = (2f * _e247);
let _e3555 = ((_e3551 * _e3551) + (_e3553 * _e3544));
let _e3559 = (_e3551 + sqrt(select(0f, _e3555, (_e3555 > 0f))));
let _e3563 = (0.5f * (_e3553 / select(1e-6f, _e3559, (_e3559 > 1e-6f))));
let _e3567 = (_e3549 + (_e3540 * _e3563));
let _e3568 = (_e3550 + (_e3542 * _e3563));
let _e3569 = (_e3551 + (_e3544 * _e3563));
let _e3573 = (_e3537 * _e3537);
let _e3575 = (_e3569 * _e3569);
let _e3583 = (((_e3551 <= 0f) || (_e3555 <= 0f)) || ((_e3569 <= 0f) || (_e3575 <= (_e3573 * (((_e3567 * _e3567) + (_e3568 * _e3568)) + _e3575)))));
let _e3597 = (_e177 + ((_e2514.member_4.x * _e2977.member_2) * _e247));
let _e3598 = (_e188 + ((_e2514.member_4.y * _e2977.member_2) * _e247));
let _e3599 = (_e199 + ((_e2514.member_4.z * _e2977.member_2) * _e247));
let _e3601 = (_e3599 * _e3599);
let _e3610 = ((_e839 & 1u) != 0u);
phi_8131_ = select(select(select(_e3569, _e3551, _e3583), _e3599, _e3610), _e199, _e846);
phi_8132_ = select(select(select(_e3568, _e3550, _e3583), _e3598, _e3610), _e188, _e846);
phi_8133_ = select(select(select(_e3567, _e3549, _e3583), _e3597, _e3610), _e177, _e846);
phi_8134_ = (select(_e3583, ((_e3599 <= 0f) || (_e3601 <= (_e3573 * (((_e3597 * _e3597) + (_e3598 * _e3598)) + _e3601)))), _e3610) && !(_e846));
} else {
phi_8131_ = _e199;
phi_8132_ = _e188;
phi_8133_ = _e177;
phi_8134_ = false;
}
let _e3621 = phi_8131_;
let _e3623 = phi_8132_;
let _e3625 = phi_8133_;
let _e3627 = phi_8134_;
global_6.member[_e123] = (_e134 + _e262);
global_6.member[_e135] = (_e144 + _e269);
global_6.member[_e146] = (_e155 + _e371);
global_6.member[_e157] = (_e166 + _e374);
global_6.member[_e168] = _e3625;
global_6.member[_e179] = _e3623;
global_6.member[_e190] = _e3621;
global_6.member[_e201] = select((_e210 * (((1f + (_e3358 * (1f + (_e3358 * (0.5f + (_e3358 * (0.16666667f + (_e3358 * (0.041666668f + (_e3358 * (0.008333334f + (_e3358 * (0.001388889f + (_e3358 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3353 + 127i)) << bitcast<u32>(23i)))) * _e3522)), _e210, _e846);
global_6.member[_e212] = select((_e221 * (((1f + (_e3406 * (1f + (_e3406 * (0.5f + (_e3406 * (0.16666667f + (_e3406 * (0.041666668f + (_e3406 * (0.008333334f + (_e3406 * (0.001388889f + (_e3406 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3401 + 127i)) << bitcast<u32>(23i)))) * _e3522)), _e221, _e846);
global_6.member[_e223] = select((_e232 * (((1f + (_e3454 * (1f + (_e3454 * (0.5f + (_e3454 * (0.16666667f + (_e3454 * (0.041666668f + (_e3454 * (0.008333334f + (_e3454 * (0.001388889f + (_e3454 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3449 + 127i)) << bitcast<u32>(23i)))) * _e3522)), _e232, _e846);
global_6.member[_e234] = select(_e243, 1f, _e3627);
}
}
}
break;
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
