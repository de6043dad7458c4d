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
struct type_18 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
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
member_2: type_18,
member_3: type_11,
member_4: type_11,
member_5: u32,
member_6: u32,
member_7: type_19,
member_8: type_20,
member_9: type_20,
member_10: type_21,
member_11: type_22,
member_12: type_14,
member_13: type_19,
member_14: type_4,
member_15: type_9,
member_16: type_23,
member_17: type_23,
member_18: type_23,
member_19: type_23,
member_20: type_10,
member_21: f32,
member_22: f32,
member_23: type_6,
}
struct type_25 {
member: type_24,
}
struct type_26 {
member: i32,
member_1: i32,
member_2: f32,
member_3: f32,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_25;
@group(0) @binding(2)
var<storage, read_write> global_2: type_16;
@group(0) @binding(1)
var<storage> global_3: type_16;
fn function_() {
var local: u32;
var local_1: i32;
var local_2: type_26;
var local_3: type_26;
var local_4: type_26;
var phi_1576_: f32;
var phi_1577_: f32;
let _e33 = global;
let _e40 = global_1.member.member_2;
let _e43 = global_1.member.member;
let _e51 = (_e33.x + _e40.member);
let _e53 = (_e33.y + _e40.member_1);
if (_e51 < _e40.member_2) {
if (_e53 < _e40.member_3) {
let _e56 = (_e43.member * _e43.member_1);
let _e58 = ((_e53 * _e43.member) + _e51);
local = _e51;
local_1 = bitcast<i32>(_e53);
let _e64 = global_1.member.member_13.member;
let _e68 = global_1.member.member_13.member_1;
let _e69 = -(32768f);
let _e71 = select(_e69, _e64, (_e64 > _e69));
let _e73 = select(32768f, _e71, (_e71 < 32768f));
let _e80 = select(0i, select(select(i32(_e73), i32(-2147483648), (_e73 < -2147483600f)), 2147483647i, (_e73 > 2147483500f)), (_e73 == _e73));
let _e84 = (_e80 - select(0i, 1i, (_e73 < f32(_e80))));
let _e86 = select(_e69, _e68, (_e68 > _e69));
let _e88 = select(32768f, _e86, (_e86 < 32768f));
let _e95 = select(0i, select(select(i32(_e88), i32(-2147483648), (_e88 < -2147483600f)), 2147483647i, (_e88 > 2147483500f)), (_e88 == _e88));
let _e99 = (_e95 - select(0i, 1i, (_e88 < f32(_e95))));
let _e107 = global_1.member.member_13.member_2;
let _e111 = global_1.member.member_13.member_3;
let _e113 = select(_e69, _e107, (_e107 > _e69));
let _e115 = select(32768f, _e113, (_e113 < 32768f));
let _e122 = select(0i, select(select(i32(_e115), i32(-2147483648), (_e115 < -2147483600f)), 2147483647i, (_e115 > 2147483500f)), (_e115 == _e115));
let _e126 = (_e122 - select(0i, 1i, (_e115 < f32(_e122))));
let _e128 = select(_e69, _e111, (_e111 > _e69));
let _e130 = select(32768f, _e128, (_e128 < 32768f));
let _e137 = select(0i, select(select(i32(_e130), i32(-2147483648), (_e130 < -2147483600f)), 2147483647i, (_e130 > 2147483500f)), (_e130 == _e130));
let _e141 = (_e137 - select(0i, 1i, (_e130 < f32(_e137))));
let _e149 = global_1.member.member_13.member_4;
let _e153 = global_1.member.member_13.member_5;
let _e155 = select(_e69, _e149, (_e149 > _e69));
let _e157 = select(32768f, _e155, (_e155 < 32768f));
let _e164 = select(0i, select(select(i32(_e157), i32(-2147483648), (_e157 < -2147483600f)), 2147483647i, (_e157 > 2147483500f)), (_e157 == _e157));
let _e168 = (_e164 - select(0i, 1i, (_e157 < f32(_e164))));
let _e170 = select(_e69, _e153, (_e153 > _e69));
let _e172 = select(32768f, _e170, (_e170 < 32768f));
let _e179 = select(0i, select(select(i32(_e172), i32(-2147483648), (_e172 < -2147483600f)), 2147483647i, (_e172 > 2147483500f)), (_e172 == _e172));
let _e183 = (_e179 - select(0i, 1i, (_e172 < f32(_e179))));
local_2 = type_26(_e84, _e99, (_e64 - f32(_e84)), (_e68 - f32(_e99)));
local_3 = type_26(_e126, _e141, (_e107 - f32(_e126)), (_e111 - f32(_e141)));
local_4 = type_26(_e168, _e183, (_e149 - f32(_e168)), (_e153 - f32(_e183)));
let _e191 = local;
let _e192 = local_1;
let _e195 = global_1.member.member_10.member;
let _e196 = bitcast<i32>(_e195);
let _e200 = local_2.member_1;
let _e204 = local_2.member;
let _e206 = bitcast<i32>(_e191);
let _e207 = ((((_e192 + _e200) * _e196) + _e204) + _e206);
let _e209 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e211 = select(_e209, _e207, (_e207 < _e209));
let _e216 = global_3.member[bitcast<u32>(select(0i, _e211, (_e211 > 0i)))];
let _e217 = (_e207 + 1i);
let _e219 = select(_e209, _e217, (_e217 < _e209));
let _e224 = global_3.member[bitcast<u32>(select(0i, _e219, (_e219 > 0i)))];
let _e225 = (_e207 + _e196);
let _e227 = select(_e209, _e225, (_e225 < _e209));
let _e232 = global_3.member[bitcast<u32>(select(0i, _e227, (_e227 > 0i)))];
let _e233 = (_e225 + 1i);
let _e235 = select(_e209, _e233, (_e233 < _e209));
let _e240 = global_3.member[bitcast<u32>(select(0i, _e235, (_e235 > 0i)))];
let _e242 = local_2.member_2;
let _e245 = (_e216 + ((_e224 - _e216) * _e242));
let _e246 = local_2.member_2;
let _e251 = local_2.member_3;
let _e255 = local_2.member;
let _e256 = (_e206 + _e255);
let _e257 = local_2.member_1;
let _e258 = (_e192 + _e257);
let _e260 = (_e196 - 1i);
let _e265 = global_1.member.member_10.member_1;
let _e267 = (bitcast<i32>(_e265) - 1i);
let _e270 = select(1f, (_e245 + (((_e232 + ((_e240 - _e232) * _e246)) - _e245) * _e251)), ((((_e256 >= 0i) && (_e256 < _e260)) && (_e258 >= 0i)) && (_e258 < _e267)));
let _e271 = local;
let _e272 = local_1;
let _e274 = local_3.member_1;
let _e278 = local_3.member;
let _e280 = bitcast<i32>(_e271);
let _e281 = ((((_e272 + _e274) * _e196) + _e278) + _e280);
let _e283 = select(_e209, _e281, (_e281 < _e209));
let _e288 = global_3.member[bitcast<u32>(select(0i, _e283, (_e283 > 0i)))];
let _e289 = (_e281 + 1i);
let _e291 = select(_e209, _e289, (_e289 < _e209));
let _e296 = global_3.member[bitcast<u32>(select(0i, _e291, (_e291 > 0i)))];
let _e297 = (_e281 + _e196);
let _e299 = select(_e209, _e297, (_e297 < _e209));
let _e304 = global_3.member[bitcast<u32>(select(0i, _e299, (_e299 > 0i)))];
let _e305 = (_e297 + 1i);
let _e307 = select(_e209, _e305, (_e305 < _e209));
let _e312 = global_3.member[bitcast<u32>(select(0i, _e307, (_e307 > 0i)))];
let _e314 = local_3.member_2;
let _e317 = (_e288 + ((_e296 - _e288) * _e314));
let _e318 = local_3.member_2;
let _e323 = local_3.member_3;
let _e327 = local_3.member;
let _e328 = (_e280 + _e327);
let _e329 = local_3.member_1;
let _e330 = (_e272 + _e329);
let _e339 = local;
let _e340 = local_1;
let _e342 = local_4.member_1;
let _e346 = local_4.member;
let _e348 = bitcast<i32>(_e339);
let _e349 = ((((_e340 + _e342) * _e196) + _e346) + _e348);
let _e351 = select(_e209, _e349, (_e349 < _e209));
let _e356 = global_3.member[bitcast<u32>(select(0i, _e351, (_e351 > 0i)))];
let _e357 = (_e349 + 1i);
let _e359 = select(_e209, _e357, (_e357 < _e209));
let _e364 = global_3.member[bitcast<u32>(select(0i, _e359, (_e359 > 0i)))];
let _e365 = (_e349 + _e196);
let _e367 = select(_e209, _e365, (_e365 < _e209));
let _e372 = global_3.member[bitcast<u32>(select(0i, _e367, (_e367 > 0i)))];
let _e373 = (_e365 + 1i);
let _e375 = select(_e209, _e373, (_e373 < _e209));
let _e380 = global_3.member[bitcast<u32>(select(0i, _e375, (_e375 > 0i)))];
let _e382 = local_4.member_2;
let _e385 = (_e356 + ((_e364 - _e356) * _e382));
let _e386 = local_4.member_2;
let _e391 = local_4.member_3;
let _e395 = local_4.member;
let _e396 = (_e348 + _e395);
let _e397 = local_4.member_1;
let _e398 = (_e340 + _e397);
let _e410 = (1f / 3f);
let _e412 = (_e270 + (((select(1f, (_e317 + (((_e304 + ((_e312 - _e304) * _e318)) - _e317) * _e323)), ((((_e328 >= 0i) && (_e328 < _e260)) && (_e330 >= 0i)) && (_e330 < _e267))) - _e270) + (select(1f, (_e385 + (((_e372 + ((_e380 - _e372) * _e386)) - _e385) * _e391)), ((((_e396 >= 0i) && (_e396 < _e260)) && (_e398 >= 0i)) && (_e398 < _e267))) - _e270)) * _e410));
if (((_e43.member_2 == 3u) || (_e43.member_2 == 4u)) || (_e43.member_2 == 5u)) {
phi_1576_ = _e412;
phi_1577_ = _e412;
} else {
let _e418 = local;
let _e419 = local_1;
let _e421 = bitcast<i32>((_e195 * _e265));
let _e422 = local_2.member_1;
let _e426 = local_2.member;
let _e428 = bitcast<i32>(_e418);
let _e429 = (((_e421 + ((_e419 + _e422) * _e196)) + _e426) + _e428);
let _e431 = select(_e209, _e429, (_e429 < _e209));
let _e436 = global_3.member[bitcast<u32>(select(0i, _e431, (_e431 > 0i)))];
let _e437 = (_e429 + 1i);
let _e439 = select(_e209, _e437, (_e437 < _e209));
let _e444 = global_3.member[bitcast<u32>(select(0i, _e439, (_e439 > 0i)))];
let _e445 = (_e429 + _e196);
let _e447 = select(_e209, _e445, (_e445 < _e209));
let _e452 = global_3.member[bitcast<u32>(select(0i, _e447, (_e447 > 0i)))];
let _e453 = (_e445 + 1i);
let _e455 = select(_e209, _e453, (_e453 < _e209));
let _e460 = global_3.member[bitcast<u32>(select(0i, _e455, (_e455 > 0i)))];
let _e461 = local_2.member_2;
let _e464 = (_e436 + ((_e444 - _e436) * _e461));
let _e465 = local_2.member_2;
let _e469 = local_2.member_3;
let _e473 = local_2.member;
let _e474 = (_e428 + _e473);
let _e475 = local_2.member_1;
let _e476 = (_e419 + _e475);
let _e484 = select(1f, (_e464 + (((_e452 + ((_e460 - _e452) * _e465)) - _e464) * _e469)), ((((_e474 >= 0i) && (_e474 < _e260)) && (_e476 >= 0i)) && (_e476 < _e267)));
let _e485 = local;
let _e486 = local_1;
let _e487 = local_3.member_1;
let _e491 = local_3.member;
let _e493 = bitcast<i32>(_e485);
let _e494 = (((_e421 + ((_e486 + _e487) * _e196)) + _e491) + _e493);
let _e496 = select(_e209, _e494, (_e494 < _e209));
let _e501 = global_3.member[bitcast<u32>(select(0i, _e496, (_e496 > 0i)))];
let _e502 = (_e494 + 1i);
let _e504 = select(_e209, _e502, (_e502 < _e209));
let _e509 = global_3.member[bitcast<u32>(select(0i, _e504, (_e504 > 0i)))];
let _e510 = (_e494 + _e196);
let _e512 = select(_e209, _e510, (_e510 < _e209));
let _e517 = global_3.member[bitcast<u32>(select(0i, _e512, (_e512 > 0i)))];
let _e518 = (_e510 + 1i);
let _e520 = select(_e209, _e518, (_e518 < _e209));
let _e525 = global_3.member[bitcast<u32>(select(0i, _e520, (_e520 > 0i)))];
let _e526 = local_3.member_2;
let _e529 = (_e501 + ((_e509 - _e501) * _e526));
let _e530 = local_3.member_2;
let _e534 = local_3.member_3;
let _e538 = local_3.member;
let _e539 = (_e493 + _e538);
let _e540 = local_3.member_1;
let _e541 = (_e486 + _e540);
let _e550 = local;
let _e551 = local_1;
let _e552 = local_4.member_1;
let _e556 = local_4.member;
let _e558 = bitcast<i32>(_e550);
let _e559 = (((_e421 + ((_e551 + _e552) * _e196)) + _e556) + _e558);
let _e561 = select(_e209, _e559, (_e559 < _e209));
let _e566 = global_3.member[bitcast<u32>(select(0i, _e561, (_e561 > 0i)))];
let _e567 = (_e559 + 1i);
let _e569 = select(_e209, _e567, (_e567 < _e209));
let _e574 = global_3.member[bitcast<u32>(select(0i, _e569, (_e569 > 0i)))];
let _e575 = (_e559 + _e196);
let _e577 = select(_e209, _e575, (_e575 < _e209));
let _e582 = global_3.member[bitcast<u32>(select(0i, _e577, (_e577 > 0i)))];
let _e583 = (_e575 + 1i);
let _e585 = select(_e209, _e583, (_e583 < _e209));
let _e590 = global_3.member[bitcast<u32>(select(0i, _e585, (_e585 > 0i)))];
let _e591 = local_4.member_2;
let _e594 = (_e566 + ((_e574 - _e566) * _e591));
let _e595 = local_4.member_2;
let _e599 = local_4.member_3;
let _e603 = local_4.member;
let _e604 = (_e558 + _e603);
let _e605 = local_4.member_1;
let _e606 = (_e551 + _e605);
let _e620 = local;
let _e621 = local_1;
let _e622 = (2i * _e421);
let _e623 = local_2.member_1;
let _e627 = local_2.member;
let _e629 = bitcast<i32>(_e620);
let _e630 = (((_e622 + ((_e621 + _e623) * _e196)) + _e627) + _e629);
let _e632 = select(_e209, _e630, (_e630 < _e209));
let _e637 = global_3.member[bitcast<u32>(select(0i, _e632, (_e632 > 0i)))];
let _e638 = (_e630 + 1i);
let _e640 = select(_e209, _e638, (_e638 < _e209));
let _e645 = global_3.member[bitcast<u32>(select(0i, _e640, (_e640 > 0i)))];
let _e646 = (_e630 + _e196);
let _e648 = select(_e209, _e646, (_e646 < _e209));
let _e653 = global_3.member[bitcast<u32>(select(0i, _e648, (_e648 > 0i)))];
let _e654 = (_e646 + 1i);
let _e656 = select(_e209, _e654, (_e654 < _e209));
let _e661 = global_3.member[bitcast<u32>(select(0i, _e656, (_e656 > 0i)))];
let _e662 = local_2.member_2;
let _e665 = (_e637 + ((_e645 - _e637) * _e662));
let _e666 = local_2.member_2;
let _e670 = local_2.member_3;
let _e674 = local_2.member;
let _e675 = (_e629 + _e674);
let _e676 = local_2.member_1;
let _e677 = (_e621 + _e676);
let _e685 = select(1f, (_e665 + (((_e653 + ((_e661 - _e653) * _e666)) - _e665) * _e670)), ((((_e675 >= 0i) && (_e675 < _e260)) && (_e677 >= 0i)) && (_e677 < _e267)));
let _e686 = local;
let _e687 = local_1;
let _e688 = local_3.member_1;
let _e692 = local_3.member;
let _e694 = bitcast<i32>(_e686);
let _e695 = (((_e622 + ((_e687 + _e688) * _e196)) + _e692) + _e694);
let _e697 = select(_e209, _e695, (_e695 < _e209));
let _e702 = global_3.member[bitcast<u32>(select(0i, _e697, (_e697 > 0i)))];
let _e703 = (_e695 + 1i);
let _e705 = select(_e209, _e703, (_e703 < _e209));
let _e710 = global_3.member[bitcast<u32>(select(0i, _e705, (_e705 > 0i)))];
let _e711 = (_e695 + _e196);
let _e713 = select(_e209, _e711, (_e711 < _e209));
let _e718 = global_3.member[bitcast<u32>(select(0i, _e713, (_e713 > 0i)))];
let _e719 = (_e711 + 1i);
let _e721 = select(_e209, _e719, (_e719 < _e209));
let _e726 = global_3.member[bitcast<u32>(select(0i, _e721, (_e721 > 0i)))];
let _e727 = local_3.member_2;
let _e730 = (_e702 + ((_e710 - _e702) * _e727));
let _e731 = local_3.member_2;
let _e735 = local_3.member_3;
let _e739 = local_3.member;
let _e740 = (_e694 + _e739);
let _e741 = local_3.member_1;
let _e742 = (_e687 + _e741);
let _e751 = local;
let _e752 = local_1;
let _e753 = local_4.member_1;
let _e757 = local_4.member;
let _e759 = bitcast<i32>(_e751);
let _e760 = (((_e622 + ((_e752 + _e753) * _e196)) + _e757) + _e759);
let _e762 = select(_e209, _e760, (_e760 < _e209));
let _e767 = global_3.member[bitcast<u32>(select(0i, _e762, (_e762 > 0i)))];
let _e768 = (_e760 + 1i);
let _e770 = select(_e209, _e768, (_e768 < _e209));
let _e775 = global_3.member[bitcast<u32>(select(0i, _e770, (_e770 > 0i)))];
let _e776 = (_e760 + _e196);
let _e778 = select(_e209, _e776, (_e776 < _e209));
let _e783 = global_3.member[bitcast<u32>(select(0i, _e778, (_e778 > 0i)))];
let _e784 = (_e776 + 1i);
let _e786 = select(_e209, _e784, (_e784 < _e209));
let _e791 = global_3.member[bitcast<u32>(select(0i, _e786, (_e786 > 0i)))];
let _e792 = local_4.member_2;
let _e795 = (_e767 + ((_e775 - _e767) * _e792));
let _e796 = local_4.member_2;
let _e800 = local_4.member_3;
let _e804 = local_4.member;
let _e805 = (_e759 + _e804);
let _e806 = local_4.member_1;
let _e807 = (_e752 + _e806);
phi_1576_ = (_e685 + (((select(1f, (_e730 + (((_e718 + ((_e726 - _e718) * _e731)) - _e730) * _e735)), ((((_e740 >= 0i) && (_e740 < _e260)) && (_e742 >= 0i)) && (_e742 < _e267))) - _e685) + (select(1f, (_e795 + (((_e783 + ((_e791 - _e783) * _e796)) - _e795) * _e800)), ((((_e805 >= 0i) && (_e805 < _e260)) && (_e807 >= 0i)) && (_e807 < _e267))) - _e685)) * _e410));
phi_1577_ = (_e484 + (((select(1f, (_e529 + (((_e517 + ((_e525 - _e517) * _e530)) - _e529) * _e534)), ((((_e539 >= 0i) && (_e539 < _e260)) && (_e541 >= 0i)) && (_e541 < _e267))) - _e484) + (select(1f, (_e594 + (((_e582 + ((_e590 - _e582) * _e595)) - _e594) * _e599)), ((((_e604 >= 0i) && (_e604 < _e260)) && (_e606 >= 0i)) && (_e606 < _e267))) - _e484)) * _e410));
}
let _e822 = phi_1576_;
let _e824 = phi_1577_;
let _e829 = global_1.member.member_11.member.member;
let _e830 = local;
let _e831 = local_1;
let _e833 = bitcast<i32>((_e195 * _e265));
let _e834 = (3i * _e833);
let _e835 = local_2.member_1;
let _e839 = local_2.member;
let _e841 = bitcast<i32>(_e830);
let _e842 = (((_e834 + ((_e831 + _e835) * _e196)) + _e839) + _e841);
let _e844 = select(_e209, _e842, (_e842 < _e209));
let _e849 = global_3.member[bitcast<u32>(select(0i, _e844, (_e844 > 0i)))];
let _e850 = (_e842 + 1i);
let _e852 = select(_e209, _e850, (_e850 < _e209));
let _e857 = global_3.member[bitcast<u32>(select(0i, _e852, (_e852 > 0i)))];
let _e858 = (_e842 + _e196);
let _e860 = select(_e209, _e858, (_e858 < _e209));
let _e865 = global_3.member[bitcast<u32>(select(0i, _e860, (_e860 > 0i)))];
let _e866 = (_e858 + 1i);
let _e868 = select(_e209, _e866, (_e866 < _e209));
let _e873 = global_3.member[bitcast<u32>(select(0i, _e868, (_e868 > 0i)))];
let _e874 = local_2.member_2;
let _e877 = (_e849 + ((_e857 - _e849) * _e874));
let _e878 = local_2.member_2;
let _e882 = local_2.member_3;
let _e886 = local_2.member;
let _e887 = (_e841 + _e886);
let _e888 = local_2.member_1;
let _e889 = (_e831 + _e888);
let _e897 = select(_e829, (_e877 + (((_e865 + ((_e873 - _e865) * _e878)) - _e877) * _e882)), ((((_e887 >= 0i) && (_e887 < _e260)) && (_e889 >= 0i)) && (_e889 < _e267)));
let _e898 = local;
let _e899 = local_1;
let _e900 = local_3.member_1;
let _e904 = local_3.member;
let _e906 = bitcast<i32>(_e898);
let _e907 = (((_e834 + ((_e899 + _e900) * _e196)) + _e904) + _e906);
let _e909 = select(_e209, _e907, (_e907 < _e209));
let _e914 = global_3.member[bitcast<u32>(select(0i, _e909, (_e909 > 0i)))];
let _e915 = (_e907 + 1i);
let _e917 = select(_e209, _e915, (_e915 < _e209));
let _e922 = global_3.member[bitcast<u32>(select(0i, _e917, (_e917 > 0i)))];
let _e923 = (_e907 + _e196);
let _e925 = select(_e209, _e923, (_e923 < _e209));
let _e930 = global_3.member[bitcast<u32>(select(0i, _e925, (_e925 > 0i)))];
let _e931 = (_e923 + 1i);
let _e933 = select(_e209, _e931, (_e931 < _e209));
let _e938 = global_3.member[bitcast<u32>(select(0i, _e933, (_e933 > 0i)))];
let _e939 = local_3.member_2;
let _e942 = (_e914 + ((_e922 - _e914) * _e939));
let _e943 = local_3.member_2;
let _e947 = local_3.member_3;
let _e951 = local_3.member;
let _e952 = (_e906 + _e951);
let _e953 = local_3.member_1;
let _e954 = (_e899 + _e953);
let _e963 = local;
let _e964 = local_1;
let _e965 = local_4.member_1;
let _e969 = local_4.member;
let _e971 = bitcast<i32>(_e963);
let _e972 = (((_e834 + ((_e964 + _e965) * _e196)) + _e969) + _e971);
let _e974 = select(_e209, _e972, (_e972 < _e209));
let _e979 = global_3.member[bitcast<u32>(select(0i, _e974, (_e974 > 0i)))];
let _e980 = (_e972 + 1i);
let _e982 = select(_e209, _e980, (_e980 < _e209));
let _e987 = global_3.member[bitcast<u32>(select(0i, _e982, (_e982 > 0i)))];
let _e988 = (_e972 + _e196);
let _e990 = select(_e209, _e988, (_e988 < _e209));
let _e995 = global_3.member[bitcast<u32>(select(0i, _e990, (_e990 > 0i)))];
let _e996 = (_e988 + 1i);
let _e998 = select(_e209, _e996, (_e996 < _e209));
let _e1003 = global_3.member[bitcast<u32>(select(0i, _e998, (_e998 > 0i)))];
let _e1004 = local_4.member_2;
let _e1007 = (_e979 + ((_e987 - _e979) * _e1004));
let _e1008 = local_4.member_2;
let _e1012 = local_4.member_3;
let _e1016 = local_4.member;
let _e1017 = (_e971 + _e1016);
let _e1018 = local_4.member_1;
let _e1019 = (_e964 + _e1018);
let _e1037 = global_1.member.member_11.member.member_1;
let _e1038 = local;
let _e1039 = local_1;
let _e1040 = (4i * _e833);
let _e1041 = local_2.member_1;
let _e1045 = local_2.member;
let _e1047 = bitcast<i32>(_e1038);
let _e1048 = (((_e1040 + ((_e1039 + _e1041) * _e196)) + _e1045) + _e1047);
let _e1050 = select(_e209, _e1048, (_e1048 < _e209));
let _e1055 = global_3.member[bitcast<u32>(select(0i, _e1050, (_e1050 > 0i)))];
let _e1056 = (_e1048 + 1i);
let _e1058 = select(_e209, _e1056, (_e1056 < _e209));
let _e1063 = global_3.member[bitcast<u32>(select(0i, _e1058, (_e1058 > 0i)))];
let _e1064 = (_e1048 + _e196);
let _e1066 = select(_e209, _e1064, (_e1064 < _e209));
let _e1071 = global_3.member[bitcast<u32>(select(0i, _e1066, (_e1066 > 0i)))];
let _e1072 = (_e1064 + 1i);
let _e1074 = select(_e209, _e1072, (_e1072 < _e209));
let _e1079 = global_3.member[bitcast<u32>(select(0i, _e1074, (_e1074 > 0i)))];
let _e1080 = local_2.member_2;
let _e1083 = (_e1055 + ((_e1063 - _e1055) * _e1080));
let _e1084 = local_2.member_2;
let _e1088 = local_2.member_3;
let _e1092 = local_2.member;
let _e1093 = (_e1047 + _e1092);
let _e1094 = local_2.member_1;
let _e1095 = (_e1039 + _e1094);
let _e1103 = select(_e1037, (_e1083 + (((_e1071 + ((_e1079 - _e1071) * _e1084)) - _e1083) * _e1088)), ((((_e1093 >= 0i) && (_e1093 < _e260)) && (_e1095 >= 0i)) && (_e1095 < _e267)));
let _e1104 = local;
let _e1105 = local_1;
let _e1106 = local_3.member_1;
let _e1110 = local_3.member;
let _e1112 = bitcast<i32>(_e1104);
let _e1113 = (((_e1040 + ((_e1105 + _e1106) * _e196)) + _e1110) + _e1112);
let _e1115 = select(_e209, _e1113, (_e1113 < _e209));
let _e1120 = global_3.member[bitcast<u32>(select(0i, _e1115, (_e1115 > 0i)))];
let _e1121 = (_e1113 + 1i);
let _e1123 = select(_e209, _e1121, (_e1121 < _e209));
let _e1128 = global_3.member[bitcast<u32>(select(0i, _e1123, (_e1123 > 0i)))];
let _e1129 = (_e1113 + _e196);
let _e1131 = select(_e209, _e1129, (_e1129 < _e209));
let _e1136 = global_3.member[bitcast<u32>(select(0i, _e1131, (_e1131 > 0i)))];
let _e1137 = (_e1129 + 1i);
let _e1139 = select(_e209, _e1137, (_e1137 < _e209));
let _e1144 = global_3.member[bitcast<u32>(select(0i, _e1139, (_e1139 > 0i)))];
let _e1145 = local_3.member_2;
let _e1148 = (_e1120 + ((_e1128 - _e1120) * _e1145));
let _e1149 = local_3.member_2;
let _e1153 = local_3.member_3;
let _e1157 = local_3.member;
let _e1158 = (_e1112 + _e1157);
let _e1159 = local_3.member_1;
let _e1160 = (_e1105 + _e1159);
let _e1169 = local;
let _e1170 = local_1;
let _e1171 = local_4.member_1;
let _e1175 = local_4.member;
let _e1177 = bitcast<i32>(_e1169);
let _e1178 = (((_e1040 + ((_e1170 + _e1171) * _e196)) + _e1175) + _e1177);
let _e1180 = select(_e209, _e1178, (_e1178 < _e209));
let _e1185 = global_3.member[bitcast<u32>(select(0i, _e1180, (_e1180 > 0i)))];
let _e1186 = (_e1178 + 1i);
let _e1188 = select(_e209, _e1186, (_e1186 < _e209));
let _e1193 = global_3.member[bitcast<u32>(select(0i, _e1188, (_e1188 > 0i)))];
let _e1194 = (_e1178 + _e196);
let _e1196 = select(_e209, _e1194, (_e1194 < _e209));
let _e1201 = global_3.member[bitcast<u32>(select(0i, _e1196, (_e1196 > 0i)))];
let _e1202 = (_e1194 + 1i);
let _e1204 = select(_e209, _e1202, (_e1202 < _e209));
let _e1209 = global_3.member[bitcast<u32>(select(0i, _e1204, (_e1204 > 0i)))];
let _e1210 = local_4.member_2;
let _e1213 = (_e1185 + ((_e1193 - _e1185) * _e1210));
let _e1214 = local_4.member_2;
let _e1218 = local_4.member_3;
let _e1222 = local_4.member;
let _e1223 = (_e1177 + _e1222);
let _e1224 = local_4.member_1;
let _e1225 = (_e1170 + _e1224);
let _e1243 = global_1.member.member_11.member.member_2;
let _e1244 = local;
let _e1245 = local_1;
let _e1246 = (5i * _e833);
let _e1247 = local_2.member_1;
let _e1251 = local_2.member;
let _e1253 = bitcast<i32>(_e1244);
let _e1254 = (((_e1246 + ((_e1245 + _e1247) * _e196)) + _e1251) + _e1253);
let _e1256 = select(_e209, _e1254, (_e1254 < _e209));
let _e1261 = global_3.member[bitcast<u32>(select(0i, _e1256, (_e1256 > 0i)))];
let _e1262 = (_e1254 + 1i);
let _e1264 = select(_e209, _e1262, (_e1262 < _e209));
let _e1269 = global_3.member[bitcast<u32>(select(0i, _e1264, (_e1264 > 0i)))];
let _e1270 = (_e1254 + _e196);
let _e1272 = select(_e209, _e1270, (_e1270 < _e209));
let _e1277 = global_3.member[bitcast<u32>(select(0i, _e1272, (_e1272 > 0i)))];
let _e1278 = (_e1270 + 1i);
let _e1280 = select(_e209, _e1278, (_e1278 < _e209));
let _e1285 = global_3.member[bitcast<u32>(select(0i, _e1280, (_e1280 > 0i)))];
let _e1286 = local_2.member_2;
let _e1289 = (_e1261 + ((_e1269 - _e1261) * _e1286));
let _e1290 = local_2.member_2;
let _e1294 = local_2.member_3;
let _e1298 = local_2.member;
let _e1299 = (_e1253 + _e1298);
let _e1300 = local_2.member_1;
let _e1301 = (_e1245 + _e1300);
let _e1309 = select(_e1243, (_e1289 + (((_e1277 + ((_e1285 - _e1277) * _e1290)) - _e1289) * _e1294)), ((((_e1299 >= 0i) && (_e1299 < _e260)) && (_e1301 >= 0i)) && (_e1301 < _e267)));
let _e1310 = local;
let _e1311 = local_1;
let _e1312 = local_3.member_1;
let _e1316 = local_3.member;
let _e1318 = bitcast<i32>(_e1310);
let _e1319 = (((_e1246 + ((_e1311 + _e1312) * _e196)) + _e1316) + _e1318);
let _e1321 = select(_e209, _e1319, (_e1319 < _e209));
let _e1326 = global_3.member[bitcast<u32>(select(0i, _e1321, (_e1321 > 0i)))];
let _e1327 = (_e1319 + 1i);
let _e1329 = select(_e209, _e1327, (_e1327 < _e209));
let _e1334 = global_3.member[bitcast<u32>(select(0i, _e1329, (_e1329 > 0i)))];
let _e1335 = (_e1319 + _e196);
let _e1337 = select(_e209, _e1335, (_e1335 < _e209));
let _e1342 = global_3.member[bitcast<u32>(select(0i, _e1337, (_e1337 > 0i)))];
let _e1343 = (_e1335 + 1i);
let _e1345 = select(_e209, _e1343, (_e1343 < _e209));
let _e1350 = global_3.member[bitcast<u32>(select(0i, _e1345, (_e1345 > 0i)))];
let _e1351 = local_3.member_2;
let _e1354 = (_e1326 + ((_e1334 - _e1326) * _e1351));
let _e1355 = local_3.member_2;
let _e1359 = local_3.member_3;
let _e1363 = local_3.member;
let _e1364 = (_e1318 + _e1363);
let _e1365 = local_3.member_1;
let _e1366 = (_e1311 + _e1365);
let _e1375 = local;
let _e1376 = local_1;
let _e1377 = local_4.member_1;
let _e1381 = local_4.member;
let _e1383 = bitcast<i32>(_e1375);
let _e1384 = (((_e1246 + ((_e1376 + _e1377) * _e196)) + _e1381) + _e1383);
let _e1386 = select(_e209, _e1384, (_e1384 < _e209));
let _e1391 = global_3.member[bitcast<u32>(select(0i, _e1386, (_e1386 > 0i)))];
let _e1392 = (_e1384 + 1i);
let _e1394 = select(_e209, _e1392, (_e1392 < _e209));
let _e1399 = global_3.member[bitcast<u32>(select(0i, _e1394, (_e1394 > 0i)))];
let _e1400 = (_e1384 + _e196);
let _e1402 = select(_e209, _e1400, (_e1400 < _e209));
let _e1407 = global_3.member[bitcast<u32>(select(0i, _e1402, (_e1402 > 0i)))];
let _e1408 = (_e1400 + 1i);
let _e1410 = select(_e209, _e1408, (_e1408 < _e209));
let _e1415 = global_3.member[bitcast<u32>(select(0i, _e1410, (_e1410 > 0i)))];
let _e1416 = local_4.member_2;
let _e1419 = (_e1391 + ((_e1399 - _e1391) * _e1416));
let _e1420 = local_4.member_2;
let _e1424 = local_4.member_3;
let _e1428 = local_4.member;
let _e1429 = (_e1383 + _e1428);
let _e1430 = local_4.member_1;
let _e1431 = (_e1376 + _e1430);
let _e1445 = local;
let _e1446 = local_1;
let _e1447 = (6i * _e833);
let _e1448 = local_2.member_1;
let _e1452 = local_2.member;
let _e1454 = bitcast<i32>(_e1445);
let _e1455 = (((_e1447 + ((_e1446 + _e1448) * _e196)) + _e1452) + _e1454);
let _e1457 = select(_e209, _e1455, (_e1455 < _e209));
let _e1462 = global_3.member[bitcast<u32>(select(0i, _e1457, (_e1457 > 0i)))];
let _e1463 = (_e1455 + 1i);
let _e1465 = select(_e209, _e1463, (_e1463 < _e209));
let _e1470 = global_3.member[bitcast<u32>(select(0i, _e1465, (_e1465 > 0i)))];
let _e1471 = (_e1455 + _e196);
let _e1473 = select(_e209, _e1471, (_e1471 < _e209));
let _e1478 = global_3.member[bitcast<u32>(select(0i, _e1473, (_e1473 > 0i)))];
let _e1479 = (_e1471 + 1i);
let _e1481 = select(_e209, _e1479, (_e1479 < _e209));
let _e1486 = global_3.member[bitcast<u32>(select(0i, _e1481, (_e1481 > 0i)))];
let _e1487 = local_2.member_2;
let _e1490 = (_e1462 + ((_e1470 - _e1462) * _e1487));
let _e1491 = local_2.member_2;
let _e1495 = local_2.member_3;
let _e1499 = local_2.member;
let _e1500 = (_e1454 + _e1499);
let _e1501 = local_2.member_1;
let _e1502 = (_e1446 + _e1501);
let _e1510 = select(0f, (_e1490 + (((_e1478 + ((_e1486 - _e1478) * _e1491)) - _e1490) * _e1495)), ((((_e1500 >= 0i) && (_e1500 < _e260)) && (_e1502 >= 0i)) && (_e1502 < _e267)));
let _e1511 = local;
let _e1512 = local_1;
let _e1513 = local_3.member_1;
let _e1517 = local_3.member;
let _e1519 = bitcast<i32>(_e1511);
let _e1520 = (((_e1447 + ((_e1512 + _e1513) * _e196)) + _e1517) + _e1519);
let _e1522 = select(_e209, _e1520, (_e1520 < _e209));
let _e1527 = global_3.member[bitcast<u32>(select(0i, _e1522, (_e1522 > 0i)))];
let _e1528 = (_e1520 + 1i);
let _e1530 = select(_e209, _e1528, (_e1528 < _e209));
let _e1535 = global_3.member[bitcast<u32>(select(0i, _e1530, (_e1530 > 0i)))];
let _e1536 = (_e1520 + _e196);
let _e1538 = select(_e209, _e1536, (_e1536 < _e209));
let _e1543 = global_3.member[bitcast<u32>(select(0i, _e1538, (_e1538 > 0i)))];
let _e1544 = (_e1536 + 1i);
let _e1546 = select(_e209, _e1544, (_e1544 < _e209));
let _e1551 = global_3.member[bitcast<u32>(select(0i, _e1546, (_e1546 > 0i)))];
let _e1552 = local_3.member_2;
let _e1555 = (_e1527 + ((_e1535 - _e1527) * _e1552));
let _e1556 = local_3.member_2;
let _e1560 = local_3.member_3;
let _e1564 = local_3.member;
let _e1565 = (_e1519 + _e1564);
let _e1566 = local_3.member_1;
let _e1567 = (_e1512 + _e1566);
let _e1576 = local;
let _e1577 = local_1;
let _e1578 = local_4.member_1;
let _e1582 = local_4.member;
let _e1584 = bitcast<i32>(_e1576);
let _e1585 = (((_e1447 + ((_e1577 + _e1578) * _e196)) + _e1582) + _e1584);
let _e1587 = select(_e209, _e1585, (_e1585 < _e209));
let _e1592 = global_3.member[bitcast<u32>(select(0i, _e1587, (_e1587 > 0i)))];
let _e1593 = (_e1585 + 1i);
let _e1595 = select(_e209, _e1593, (_e1593 < _e209));
let _e1600 = global_3.member[bitcast<u32>(select(0i, _e1595, (_e1595 > 0i)))];
let _e1601 = (_e1585 + _e196);
let _e1603 = select(_e209, _e1601, (_e1601 < _e209));
let _e1608 = global_3.member[bitcast<u32>(select(0i, _e1603, (_e1603 > 0i)))];
let _e1609 = (_e1601 + 1i);
let _e1611 = select(_e209, _e1609, (_e1609 < _e209));
let _e1616 = global_3.member[bitcast<u32>(select(0i, _e1611, (_e1611 > 0i)))];
let _e1617 = local_4.member_2;
let _e1620 = (_e1592 + ((_e1600 - _e1592) * _e1617));
let _e1621 = local_4.member_2;
let _e1625 = local_4.member_3;
let _e1629 = local_4.member;
let _e1630 = (_e1584 + _e1629);
let _e1631 = local_4.member_1;
let _e1632 = (_e1577 + _e1631);
let _e1646 = local;
let _e1647 = local_1;
let _e1648 = (7i * _e833);
let _e1649 = local_2.member_1;
let _e1653 = local_2.member;
let _e1655 = bitcast<i32>(_e1646);
let _e1656 = (((_e1648 + ((_e1647 + _e1649) * _e196)) + _e1653) + _e1655);
let _e1658 = select(_e209, _e1656, (_e1656 < _e209));
let _e1663 = global_3.member[bitcast<u32>(select(0i, _e1658, (_e1658 > 0i)))];
let _e1664 = (_e1656 + 1i);
let _e1666 = select(_e209, _e1664, (_e1664 < _e209));
let _e1671 = global_3.member[bitcast<u32>(select(0i, _e1666, (_e1666 > 0i)))];
let _e1672 = (_e1656 + _e196);
let _e1674 = select(_e209, _e1672, (_e1672 < _e209));
let _e1679 = global_3.member[bitcast<u32>(select(0i, _e1674, (_e1674 > 0i)))];
let _e1680 = (_e1672 + 1i);
let _e1682 = select(_e209, _e1680, (_e1680 < _e209));
let _e1687 = global_3.member[bitcast<u32>(select(0i, _e1682, (_e1682 > 0i)))];
let _e1688 = local_2.member_2;
let _e1691 = (_e1663 + ((_e1671 - _e1663) * _e1688));
let _e1692 = local_2.member_2;
let _e1696 = local_2.member_3;
let _e1700 = local_2.member;
let _e1701 = (_e1655 + _e1700);
let _e1702 = local_2.member_1;
let _e1703 = (_e1647 + _e1702);
let _e1711 = select(0f, (_e1691 + (((_e1679 + ((_e1687 - _e1679) * _e1692)) - _e1691) * _e1696)), ((((_e1701 >= 0i) && (_e1701 < _e260)) && (_e1703 >= 0i)) && (_e1703 < _e267)));
let _e1712 = local;
let _e1713 = local_1;
let _e1714 = local_3.member_1;
let _e1718 = local_3.member;
let _e1720 = bitcast<i32>(_e1712);
let _e1721 = (((_e1648 + ((_e1713 + _e1714) * _e196)) + _e1718) + _e1720);
let _e1723 = select(_e209, _e1721, (_e1721 < _e209));
let _e1728 = global_3.member[bitcast<u32>(select(0i, _e1723, (_e1723 > 0i)))];
let _e1729 = (_e1721 + 1i);
let _e1731 = select(_e209, _e1729, (_e1729 < _e209));
let _e1736 = global_3.member[bitcast<u32>(select(0i, _e1731, (_e1731 > 0i)))];
let _e1737 = (_e1721 + _e196);
let _e1739 = select(_e209, _e1737, (_e1737 < _e209));
let _e1744 = global_3.member[bitcast<u32>(select(0i, _e1739, (_e1739 > 0i)))];
let _e1745 = (_e1737 + 1i);
let _e1747 = select(_e209, _e1745, (_e1745 < _e209));
let _e1752 = global_3.member[bitcast<u32>(select(0i, _e1747, (_e1747 > 0i)))];
let _e1753 = local_3.member_2;
let _e1756 = (_e1728 + ((_e1736 - _e1728) * _e1753));
let _e1757 = local_3.member_2;
let _e1761 = local_3.member_3;
let _e1765 = local_3.member;
let _e1766 = (_e1720 + _e1765);
let _e1767 = local_3.member_1;
let _e1768 = (_e1713 + _e1767);
let _e1777 = local;
let _e1778 = local_1;
let _e1779 = local_4.member_1;
let _e1783 = local_4.member;
let _e1785 = bitcast<i32>(_e1777);
let _e1786 = (((_e1648 + ((_e1778 + _e1779) * _e196)) + _e1783) + _e1785);
let _e1788 = select(_e209, _e1786, (_e1786 < _e209));
let _e1793 = global_3.member[bitcast<u32>(select(0i, _e1788, (_e1788 > 0i)))];
let _e1794 = (_e1786 + 1i);
let _e1796 = select(_e209, _e1794, (_e1794 < _e209));
let _e1801 = global_3.member[bitcast<u32>(select(0i, _e1796, (_e1796 > 0i)))];
let _e1802 = (_e1786 + _e196);
let _e1804 = select(_e209, _e1802, (_e1802 < _e209));
let _e1809 = global_3.member[bitcast<u32>(select(0i, _e1804, (_e1804 > 0i)))];
let _e1810 = (_e1802 + 1i);
let _e1812 = select(_e209, _e1810, (_e1810 < _e209));
let _e1817 = global_3.member[bitcast<u32>(select(0i, _e1812, (_e1812 > 0i)))];
let _e1818 = local_4.member_2;
let _e1821 = (_e1793 + ((_e1801 - _e1793) * _e1818));
let _e1822 = local_4.member_2;
let _e1826 = local_4.member_3;
let _e1830 = local_4.member;
let _e1831 = (_e1785 + _e1830);
let _e1832 = local_4.member_1;
let _e1833 = (_e1778 + _e1832);
let _e1847 = local;
let _e1848 = local_1;
let _e1849 = (8i * _e833);
let _e1850 = local_2.member_1;
let _e1854 = local_2.member;
let _e1856 = bitcast<i32>(_e1847);
let _e1857 = (((_e1849 + ((_e1848 + _e1850) * _e196)) + _e1854) + _e1856);
let _e1859 = select(_e209, _e1857, (_e1857 < _e209));
let _e1864 = global_3.member[bitcast<u32>(select(0i, _e1859, (_e1859 > 0i)))];
let _e1865 = (_e1857 + 1i);
let _e1867 = select(_e209, _e1865, (_e1865 < _e209));
let _e1872 = global_3.member[bitcast<u32>(select(0i, _e1867, (_e1867 > 0i)))];
let _e1873 = (_e1857 + _e196);
let _e1875 = select(_e209, _e1873, (_e1873 < _e209));
let _e1880 = global_3.member[bitcast<u32>(select(0i, _e1875, (_e1875 > 0i)))];
let _e1881 = (_e1873 + 1i);
let _e1883 = select(_e209, _e1881, (_e1881 < _e209));
let _e1888 = global_3.member[bitcast<u32>(select(0i, _e1883, (_e1883 > 0i)))];
let _e1889 = local_2.member_2;
let _e1892 = (_e1864 + ((_e1872 - _e1864) * _e1889));
let _e1893 = local_2.member_2;
let _e1897 = local_2.member_3;
let _e1901 = local_2.member;
let _e1902 = (_e1856 + _e1901);
let _e1903 = local_2.member_1;
let _e1904 = (_e1848 + _e1903);
let _e1912 = select(1f, (_e1892 + (((_e1880 + ((_e1888 - _e1880) * _e1893)) - _e1892) * _e1897)), ((((_e1902 >= 0i) && (_e1902 < _e260)) && (_e1904 >= 0i)) && (_e1904 < _e267)));
let _e1913 = local;
let _e1914 = local_1;
let _e1915 = local_3.member_1;
let _e1919 = local_3.member;
let _e1921 = bitcast<i32>(_e1913);
let _e1922 = (((_e1849 + ((_e1914 + _e1915) * _e196)) + _e1919) + _e1921);
let _e1924 = select(_e209, _e1922, (_e1922 < _e209));
let _e1929 = global_3.member[bitcast<u32>(select(0i, _e1924, (_e1924 > 0i)))];
let _e1930 = (_e1922 + 1i);
let _e1932 = select(_e209, _e1930, (_e1930 < _e209));
let _e1937 = global_3.member[bitcast<u32>(select(0i, _e1932, (_e1932 > 0i)))];
let _e1938 = (_e1922 + _e196);
let _e1940 = select(_e209, _e1938, (_e1938 < _e209));
let _e1945 = global_3.member[bitcast<u32>(select(0i, _e1940, (_e1940 > 0i)))];
let _e1946 = (_e1938 + 1i);
let _e1948 = select(_e209, _e1946, (_e1946 < _e209));
let _e1953 = global_3.member[bitcast<u32>(select(0i, _e1948, (_e1948 > 0i)))];
let _e1954 = local_3.member_2;
let _e1957 = (_e1929 + ((_e1937 - _e1929) * _e1954));
let _e1958 = local_3.member_2;
let _e1962 = local_3.member_3;
let _e1966 = local_3.member;
let _e1967 = (_e1921 + _e1966);
let _e1968 = local_3.member_1;
let _e1969 = (_e1914 + _e1968);
let _e1978 = local;
let _e1979 = local_1;
let _e1980 = local_4.member_1;
let _e1984 = local_4.member;
let _e1986 = bitcast<i32>(_e1978);
let _e1987 = (((_e1849 + ((_e1979 + _e1980) * _e196)) + _e1984) + _e1986);
let _e1989 = select(_e209, _e1987, (_e1987 < _e209));
let _e1994 = global_3.member[bitcast<u32>(select(0i, _e1989, (_e1989 > 0i)))];
let _e1995 = (_e1987 + 1i);
let _e1997 = select(_e209, _e1995, (_e1995 < _e209));
let _e2002 = global_3.member[bitcast<u32>(select(0i, _e1997, (_e1997 > 0i)))];
let _e2003 = (_e1987 + _e196);
let _e2005 = select(_e209, _e2003, (_e2003 < _e209));
let _e2010 = global_3.member[bitcast<u32>(select(0i, _e2005, (_e2005 > 0i)))];
let _e2011 = (_e2003 + 1i);
let _e2013 = select(_e209, _e2011, (_e2011 < _e209));
let _e2018 = global_3.member[bitcast<u32>(select(0i, _e2013, (_e2013 > 0i)))];
let _e2019 = local_4.member_2;
let _e2022 = (_e1994 + ((_e2002 - _e1994) * _e2019));
let _e2023 = local_4.member_2;
let _e2027 = local_4.member_3;
let _e2031 = local_4.member;
let _e2032 = (_e1986 + _e2031);
let _e2033 = local_4.member_1;
let _e2034 = (_e1979 + _e2033);
global_2.member[_e58] = _e412;
global_2.member[(_e56 + _e58)] = _e824;
global_2.member[((2u * _e56) + _e58)] = _e822;
global_2.member[((3u * _e56) + _e58)] = (_e897 + (((select(_e829, (_e942 + (((_e930 + ((_e938 - _e930) * _e943)) - _e942) * _e947)), ((((_e952 >= 0i) && (_e952 < _e260)) && (_e954 >= 0i)) && (_e954 < _e267))) - _e897) + (select(_e829, (_e1007 + (((_e995 + ((_e1003 - _e995) * _e1008)) - _e1007) * _e1012)), ((((_e1017 >= 0i) && (_e1017 < _e260)) && (_e1019 >= 0i)) && (_e1019 < _e267))) - _e897)) * _e410));
global_2.member[((4u * _e56) + _e58)] = (_e1103 + (((select(_e1037, (_e1148 + (((_e1136 + ((_e1144 - _e1136) * _e1149)) - _e1148) * _e1153)), ((((_e1158 >= 0i) && (_e1158 < _e260)) && (_e1160 >= 0i)) && (_e1160 < _e267))) - _e1103) + (select(_e1037, (_e1213 + (((_e1201 + ((_e1209 - _e1201) * _e1214)) - _e1213) * _e1218)), ((((_e1223 >= 0i) && (_e1223 < _e260)) && (_e1225 >= 0i)) && (_e1225 < _e267))) - _e1103)) * _e410));
global_2.member[((5u * _e56) + _e58)] = (_e1309 + (((select(_e1243, (_e1354 + (((_e1342 + ((_e1350 - _e1342) * _e1355)) - _e1354) * _e1359)), ((((_e1364 >= 0i) && (_e1364 < _e260)) && (_e1366 >= 0i)) && (_e1366 < _e267))) - _e1309) + (select(_e1243, (_e1419 + (((_e1407 + ((_e1415 - _e1407) * _e1420)) - _e1419) * _e1424)), ((((_e1429 >= 0i) && (_e1429 < _e260)) && (_e1431 >= 0i)) && (_e1431 < _e267))) - _e1309)) * _e410));
global_2.member[((6u * _e56) + _e58)] = (_e1510 + (((select(0f, (_e1555 + (((_e1543 + ((_e1551 - _e1543) * _e1556)) - _e1555) * _e1560)), ((((_e1565 >= 0i) && (_e1565 < _e260)) && (_e1567 >= 0i)) && (_e1567 < _e267))) - _e1510) + (select(0f, (_e1620 + (((_e1608 + ((_e1616 - _e1608) * _e1621)) - _e1620) * _e1625)), ((((_e1630 >= 0i) && (_e1630 < _e260)) && (_e1632 >= 0i)) && (_e1632 < _e267))) - _e1510)) * _e410));
global_2.member[((7u * _e56) + _e58)] = (_e1711 + (((select(0f, (_e1756 + (((_e1744 + ((_e1752 - _e1744) * _e1757)) - _e1756) * _e1761)), ((((_e1766 >= 0i) && (_e1766 < _e260)) && (_e1768 >= 0i)) && (_e1768 < _e267))) - _e1711) + (select(0f, (_e1821 + (((_e1809 + ((_e1817 - _e1809) * _e1822)) - _e1821) * _e1826)), ((((_e1831 >= 0i) && (_e1831 < _e260)) && (_e1833 >= 0i)) && (_e1833 < _e267))) - _e1711)) * _e410));
global_2.member[((8u * _e56) + _e58)] = (_e1912 + (((select(1f, (_e1957 + (((_e1945 + ((_e1953 - _e1945) * _e1958)) - _e1957) * _e1962)), ((((_e1967 >= 0i) && (_e1967 < _e260)) && (_e1969 >= 0i)) && (_e1969 < _e267))) - _e1912) + (select(1f, (_e2022 + (((_e2010 + ((_e2018 - _e2010) * _e2023)) - _e2022) * _e2027)), ((((_e2032 >= 0i) && (_e2032 < _e260)) && (_e2034 >= 0i)) && (_e2034 < _e267))) - _e1912)) * _e410));
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
