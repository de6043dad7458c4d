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
struct type_13 {
member: u32,
member_1: u32,
}
struct type_14 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_15 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_16 {
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
struct type_17 {
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
struct type_18 {
member: type_5,
member_1: type_5,
}
struct type_19 {
member: type_7,
member_1: u32,
}
struct type_20 {
member: type_2,
member_1: u32,
member_2: type_14,
member_3: type_13,
member_4: u32,
member_5: type_15,
member_6: type_16,
member_7: type_16,
member_8: type_17,
member_9: type_18,
member_10: f32,
member_11: type_15,
member_12: type_4,
member_13: type_9,
member_14: type_19,
member_15: type_19,
member_16: type_19,
member_17: type_19,
member_18: type_5,
member_19: f32,
member_20: f32,
member_21: type_6,
}
struct type_21 {
member: type_20,
}
struct type_22 {
member: i32,
member_1: i32,
member_2: f32,
member_3: f32,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_21;
@group(0) @binding(2)
var<storage, read_write> global_2: type_11;
@group(0) @binding(1)
var<storage> global_3: type_11;
fn function_() {
var local: u32;
var local_1: i32;
var local_2: type_22;
var local_3: type_22;
var local_4: type_22;
var phi_1567_: f32;
var phi_1568_: f32;
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
let _e64 = global_1.member.member_11.member;
let _e68 = global_1.member.member_11.member_1;
let _e69 = -(32768f);
let _e71 = select(_e69, _e64, (_e64 > _e69));
let _e73 = select(32768f, _e71, (_e71 < 32768f));
let _e80 = select(0i, select(select(i32(_e73), i32(-2147483648), (_e73 < -2147483600f)), 2147483647i, (_e73 > 2147483500f)), (_e73 == _e73));
let _e84 = (_e80 - select(0i, 1i, (_e73 < f32(_e80))));
let _e86 = select(_e69, _e68, (_e68 > _e69));
let _e88 = select(32768f, _e86, (_e86 < 32768f));
let _e95 = select(0i, select(select(i32(_e88), i32(-2147483648), (_e88 < -2147483600f)), 2147483647i, (_e88 > 2147483500f)), (_e88 == _e88));
let _e99 = (_e95 - select(0i, 1i, (_e88 < f32(_e95))));
let _e107 = global_1.member.member_11.member_2;
let _e111 = global_1.member.member_11.member_3;
let _e113 = select(_e69, _e107, (_e107 > _e69));
let _e115 = select(32768f, _e113, (_e113 < 32768f));
let _e122 = select(0i, select(select(i32(_e115), i32(-2147483648), (_e115 < -2147483600f)), 2147483647i, (_e115 > 2147483500f)), (_e115 == _e115));
let _e126 = (_e122 - select(0i, 1i, (_e115 < f32(_e122))));
let _e128 = select(_e69, _e111, (_e111 > _e69));
let _e130 = select(32768f, _e128, (_e128 < 32768f));
let _e137 = select(0i, select(select(i32(_e130), i32(-2147483648), (_e130 < -2147483600f)), 2147483647i, (_e130 > 2147483500f)), (_e130 == _e130));
let _e141 = (_e137 - select(0i, 1i, (_e130 < f32(_e137))));
let _e149 = global_1.member.member_11.member_4;
let _e153 = global_1.member.member_11.member_5;
let _e155 = select(_e69, _e149, (_e149 > _e69));
let _e157 = select(32768f, _e155, (_e155 < 32768f));
let _e164 = select(0i, select(select(i32(_e157), i32(-2147483648), (_e157 < -2147483600f)), 2147483647i, (_e157 > 2147483500f)), (_e157 == _e157));
let _e168 = (_e164 - select(0i, 1i, (_e157 < f32(_e164))));
let _e170 = select(_e69, _e153, (_e153 > _e69));
let _e172 = select(32768f, _e170, (_e170 < 32768f));
let _e179 = select(0i, select(select(i32(_e172), i32(-2147483648), (_e172 < -2147483600f)), 2147483647i, (_e172 > 2147483500f)), (_e172 == _e172));
let _e183 = (_e179 - select(0i, 1i, (_e172 < f32(_e179))));
local_2 = type_22(_e84, _e99, (_e64 - f32(_e84)), (_e68 - f32(_e99)));
local_3 = type_22(_e126, _e141, (_e107 - f32(_e126)), (_e111 - f32(_e141)));
local_4 = type_22(_e168, _e183, (_e149 - f32(_e168)), (_e153 - f32(_e183)));
let _e191 = local;
let _e192 = local_1;
let _e195 = global_1.member.member_8.member;
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
let _e265 = global_1.member.member_8.member_1;
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
if (_e43.member_2 >= 3u) {
phi_1567_ = _e412;
phi_1568_ = _e412;
} else {
let _e414 = local;
let _e415 = local_1;
let _e417 = bitcast<i32>((_e195 * _e265));
let _e418 = local_2.member_1;
let _e422 = local_2.member;
let _e424 = bitcast<i32>(_e414);
let _e425 = (((_e417 + ((_e415 + _e418) * _e196)) + _e422) + _e424);
let _e427 = select(_e209, _e425, (_e425 < _e209));
let _e432 = global_3.member[bitcast<u32>(select(0i, _e427, (_e427 > 0i)))];
let _e433 = (_e425 + 1i);
let _e435 = select(_e209, _e433, (_e433 < _e209));
let _e440 = global_3.member[bitcast<u32>(select(0i, _e435, (_e435 > 0i)))];
let _e441 = (_e425 + _e196);
let _e443 = select(_e209, _e441, (_e441 < _e209));
let _e448 = global_3.member[bitcast<u32>(select(0i, _e443, (_e443 > 0i)))];
let _e449 = (_e441 + 1i);
let _e451 = select(_e209, _e449, (_e449 < _e209));
let _e456 = global_3.member[bitcast<u32>(select(0i, _e451, (_e451 > 0i)))];
let _e457 = local_2.member_2;
let _e460 = (_e432 + ((_e440 - _e432) * _e457));
let _e461 = local_2.member_2;
let _e465 = local_2.member_3;
let _e469 = local_2.member;
let _e470 = (_e424 + _e469);
let _e471 = local_2.member_1;
let _e472 = (_e415 + _e471);
let _e480 = select(1f, (_e460 + (((_e448 + ((_e456 - _e448) * _e461)) - _e460) * _e465)), ((((_e470 >= 0i) && (_e470 < _e260)) && (_e472 >= 0i)) && (_e472 < _e267)));
let _e481 = local;
let _e482 = local_1;
let _e483 = local_3.member_1;
let _e487 = local_3.member;
let _e489 = bitcast<i32>(_e481);
let _e490 = (((_e417 + ((_e482 + _e483) * _e196)) + _e487) + _e489);
let _e492 = select(_e209, _e490, (_e490 < _e209));
let _e497 = global_3.member[bitcast<u32>(select(0i, _e492, (_e492 > 0i)))];
let _e498 = (_e490 + 1i);
let _e500 = select(_e209, _e498, (_e498 < _e209));
let _e505 = global_3.member[bitcast<u32>(select(0i, _e500, (_e500 > 0i)))];
let _e506 = (_e490 + _e196);
let _e508 = select(_e209, _e506, (_e506 < _e209));
let _e513 = global_3.member[bitcast<u32>(select(0i, _e508, (_e508 > 0i)))];
let _e514 = (_e506 + 1i);
let _e516 = select(_e209, _e514, (_e514 < _e209));
let _e521 = global_3.member[bitcast<u32>(select(0i, _e516, (_e516 > 0i)))];
let _e522 = local_3.member_2;
let _e525 = (_e497 + ((_e505 - _e497) * _e522));
let _e526 = local_3.member_2;
let _e530 = local_3.member_3;
let _e534 = local_3.member;
let _e535 = (_e489 + _e534);
let _e536 = local_3.member_1;
let _e537 = (_e482 + _e536);
let _e546 = local;
let _e547 = local_1;
let _e548 = local_4.member_1;
let _e552 = local_4.member;
let _e554 = bitcast<i32>(_e546);
let _e555 = (((_e417 + ((_e547 + _e548) * _e196)) + _e552) + _e554);
let _e557 = select(_e209, _e555, (_e555 < _e209));
let _e562 = global_3.member[bitcast<u32>(select(0i, _e557, (_e557 > 0i)))];
let _e563 = (_e555 + 1i);
let _e565 = select(_e209, _e563, (_e563 < _e209));
let _e570 = global_3.member[bitcast<u32>(select(0i, _e565, (_e565 > 0i)))];
let _e571 = (_e555 + _e196);
let _e573 = select(_e209, _e571, (_e571 < _e209));
let _e578 = global_3.member[bitcast<u32>(select(0i, _e573, (_e573 > 0i)))];
let _e579 = (_e571 + 1i);
let _e581 = select(_e209, _e579, (_e579 < _e209));
let _e586 = global_3.member[bitcast<u32>(select(0i, _e581, (_e581 > 0i)))];
let _e587 = local_4.member_2;
let _e590 = (_e562 + ((_e570 - _e562) * _e587));
let _e591 = local_4.member_2;
let _e595 = local_4.member_3;
let _e599 = local_4.member;
let _e600 = (_e554 + _e599);
let _e601 = local_4.member_1;
let _e602 = (_e547 + _e601);
let _e616 = local;
let _e617 = local_1;
let _e618 = (2i * _e417);
let _e619 = local_2.member_1;
let _e623 = local_2.member;
let _e625 = bitcast<i32>(_e616);
let _e626 = (((_e618 + ((_e617 + _e619) * _e196)) + _e623) + _e625);
let _e628 = select(_e209, _e626, (_e626 < _e209));
let _e633 = global_3.member[bitcast<u32>(select(0i, _e628, (_e628 > 0i)))];
let _e634 = (_e626 + 1i);
let _e636 = select(_e209, _e634, (_e634 < _e209));
let _e641 = global_3.member[bitcast<u32>(select(0i, _e636, (_e636 > 0i)))];
let _e642 = (_e626 + _e196);
let _e644 = select(_e209, _e642, (_e642 < _e209));
let _e649 = global_3.member[bitcast<u32>(select(0i, _e644, (_e644 > 0i)))];
let _e650 = (_e642 + 1i);
let _e652 = select(_e209, _e650, (_e650 < _e209));
let _e657 = global_3.member[bitcast<u32>(select(0i, _e652, (_e652 > 0i)))];
let _e658 = local_2.member_2;
let _e661 = (_e633 + ((_e641 - _e633) * _e658));
let _e662 = local_2.member_2;
let _e666 = local_2.member_3;
let _e670 = local_2.member;
let _e671 = (_e625 + _e670);
let _e672 = local_2.member_1;
let _e673 = (_e617 + _e672);
let _e681 = select(1f, (_e661 + (((_e649 + ((_e657 - _e649) * _e662)) - _e661) * _e666)), ((((_e671 >= 0i) && (_e671 < _e260)) && (_e673 >= 0i)) && (_e673 < _e267)));
let _e682 = local;
let _e683 = local_1;
let _e684 = local_3.member_1;
let _e688 = local_3.member;
let _e690 = bitcast<i32>(_e682);
let _e691 = (((_e618 + ((_e683 + _e684) * _e196)) + _e688) + _e690);
let _e693 = select(_e209, _e691, (_e691 < _e209));
let _e698 = global_3.member[bitcast<u32>(select(0i, _e693, (_e693 > 0i)))];
let _e699 = (_e691 + 1i);
let _e701 = select(_e209, _e699, (_e699 < _e209));
let _e706 = global_3.member[bitcast<u32>(select(0i, _e701, (_e701 > 0i)))];
let _e707 = (_e691 + _e196);
let _e709 = select(_e209, _e707, (_e707 < _e209));
let _e714 = global_3.member[bitcast<u32>(select(0i, _e709, (_e709 > 0i)))];
let _e715 = (_e707 + 1i);
let _e717 = select(_e209, _e715, (_e715 < _e209));
let _e722 = global_3.member[bitcast<u32>(select(0i, _e717, (_e717 > 0i)))];
let _e723 = local_3.member_2;
let _e726 = (_e698 + ((_e706 - _e698) * _e723));
let _e727 = local_3.member_2;
let _e731 = local_3.member_3;
let _e735 = local_3.member;
let _e736 = (_e690 + _e735);
let _e737 = local_3.member_1;
let _e738 = (_e683 + _e737);
let _e747 = local;
let _e748 = local_1;
let _e749 = local_4.member_1;
let _e753 = local_4.member;
let _e755 = bitcast<i32>(_e747);
let _e756 = (((_e618 + ((_e748 + _e749) * _e196)) + _e753) + _e755);
let _e758 = select(_e209, _e756, (_e756 < _e209));
let _e763 = global_3.member[bitcast<u32>(select(0i, _e758, (_e758 > 0i)))];
let _e764 = (_e756 + 1i);
let _e766 = select(_e209, _e764, (_e764 < _e209));
let _e771 = global_3.member[bitcast<u32>(select(0i, _e766, (_e766 > 0i)))];
let _e772 = (_e756 + _e196);
let _e774 = select(_e209, _e772, (_e772 < _e209));
let _e779 = global_3.member[bitcast<u32>(select(0i, _e774, (_e774 > 0i)))];
let _e780 = (_e772 + 1i);
let _e782 = select(_e209, _e780, (_e780 < _e209));
let _e787 = global_3.member[bitcast<u32>(select(0i, _e782, (_e782 > 0i)))];
let _e788 = local_4.member_2;
let _e791 = (_e763 + ((_e771 - _e763) * _e788));
let _e792 = local_4.member_2;
let _e796 = local_4.member_3;
let _e800 = local_4.member;
let _e801 = (_e755 + _e800);
let _e802 = local_4.member_1;
let _e803 = (_e748 + _e802);
phi_1567_ = (_e681 + (((select(1f, (_e726 + (((_e714 + ((_e722 - _e714) * _e727)) - _e726) * _e731)), ((((_e736 >= 0i) && (_e736 < _e260)) && (_e738 >= 0i)) && (_e738 < _e267))) - _e681) + (select(1f, (_e791 + (((_e779 + ((_e787 - _e779) * _e792)) - _e791) * _e796)), ((((_e801 >= 0i) && (_e801 < _e260)) && (_e803 >= 0i)) && (_e803 < _e267))) - _e681)) * _e410));
phi_1568_ = (_e480 + (((select(1f, (_e525 + (((_e513 + ((_e521 - _e513) * _e526)) - _e525) * _e530)), ((((_e535 >= 0i) && (_e535 < _e260)) && (_e537 >= 0i)) && (_e537 < _e267))) - _e480) + (select(1f, (_e590 + (((_e578 + ((_e586 - _e578) * _e591)) - _e590) * _e595)), ((((_e600 >= 0i) && (_e600 < _e260)) && (_e602 >= 0i)) && (_e602 < _e267))) - _e480)) * _e410));
}
let _e818 = phi_1567_;
let _e820 = phi_1568_;
let _e825 = global_1.member.member_9.member.member;
let _e826 = local;
let _e827 = local_1;
let _e829 = bitcast<i32>((_e195 * _e265));
let _e830 = (3i * _e829);
let _e831 = local_2.member_1;
let _e835 = local_2.member;
let _e837 = bitcast<i32>(_e826);
let _e838 = (((_e830 + ((_e827 + _e831) * _e196)) + _e835) + _e837);
let _e840 = select(_e209, _e838, (_e838 < _e209));
let _e845 = global_3.member[bitcast<u32>(select(0i, _e840, (_e840 > 0i)))];
let _e846 = (_e838 + 1i);
let _e848 = select(_e209, _e846, (_e846 < _e209));
let _e853 = global_3.member[bitcast<u32>(select(0i, _e848, (_e848 > 0i)))];
let _e854 = (_e838 + _e196);
let _e856 = select(_e209, _e854, (_e854 < _e209));
let _e861 = global_3.member[bitcast<u32>(select(0i, _e856, (_e856 > 0i)))];
let _e862 = (_e854 + 1i);
let _e864 = select(_e209, _e862, (_e862 < _e209));
let _e869 = global_3.member[bitcast<u32>(select(0i, _e864, (_e864 > 0i)))];
let _e870 = local_2.member_2;
let _e873 = (_e845 + ((_e853 - _e845) * _e870));
let _e874 = local_2.member_2;
let _e878 = local_2.member_3;
let _e882 = local_2.member;
let _e883 = (_e837 + _e882);
let _e884 = local_2.member_1;
let _e885 = (_e827 + _e884);
let _e893 = select(_e825, (_e873 + (((_e861 + ((_e869 - _e861) * _e874)) - _e873) * _e878)), ((((_e883 >= 0i) && (_e883 < _e260)) && (_e885 >= 0i)) && (_e885 < _e267)));
let _e894 = local;
let _e895 = local_1;
let _e896 = local_3.member_1;
let _e900 = local_3.member;
let _e902 = bitcast<i32>(_e894);
let _e903 = (((_e830 + ((_e895 + _e896) * _e196)) + _e900) + _e902);
let _e905 = select(_e209, _e903, (_e903 < _e209));
let _e910 = global_3.member[bitcast<u32>(select(0i, _e905, (_e905 > 0i)))];
let _e911 = (_e903 + 1i);
let _e913 = select(_e209, _e911, (_e911 < _e209));
let _e918 = global_3.member[bitcast<u32>(select(0i, _e913, (_e913 > 0i)))];
let _e919 = (_e903 + _e196);
let _e921 = select(_e209, _e919, (_e919 < _e209));
let _e926 = global_3.member[bitcast<u32>(select(0i, _e921, (_e921 > 0i)))];
let _e927 = (_e919 + 1i);
let _e929 = select(_e209, _e927, (_e927 < _e209));
let _e934 = global_3.member[bitcast<u32>(select(0i, _e929, (_e929 > 0i)))];
let _e935 = local_3.member_2;
let _e938 = (_e910 + ((_e918 - _e910) * _e935));
let _e939 = local_3.member_2;
let _e943 = local_3.member_3;
let _e947 = local_3.member;
let _e948 = (_e902 + _e947);
let _e949 = local_3.member_1;
let _e950 = (_e895 + _e949);
let _e959 = local;
let _e960 = local_1;
let _e961 = local_4.member_1;
let _e965 = local_4.member;
let _e967 = bitcast<i32>(_e959);
let _e968 = (((_e830 + ((_e960 + _e961) * _e196)) + _e965) + _e967);
let _e970 = select(_e209, _e968, (_e968 < _e209));
let _e975 = global_3.member[bitcast<u32>(select(0i, _e970, (_e970 > 0i)))];
let _e976 = (_e968 + 1i);
let _e978 = select(_e209, _e976, (_e976 < _e209));
let _e983 = global_3.member[bitcast<u32>(select(0i, _e978, (_e978 > 0i)))];
let _e984 = (_e968 + _e196);
let _e986 = select(_e209, _e984, (_e984 < _e209));
let _e991 = global_3.member[bitcast<u32>(select(0i, _e986, (_e986 > 0i)))];
let _e992 = (_e984 + 1i);
let _e994 = select(_e209, _e992, (_e992 < _e209));
let _e999 = global_3.member[bitcast<u32>(select(0i, _e994, (_e994 > 0i)))];
let _e1000 = local_4.member_2;
let _e1003 = (_e975 + ((_e983 - _e975) * _e1000));
let _e1004 = local_4.member_2;
let _e1008 = local_4.member_3;
let _e1012 = local_4.member;
let _e1013 = (_e967 + _e1012);
let _e1014 = local_4.member_1;
let _e1015 = (_e960 + _e1014);
let _e1033 = global_1.member.member_9.member.member_1;
let _e1034 = local;
let _e1035 = local_1;
let _e1036 = (4i * _e829);
let _e1037 = local_2.member_1;
let _e1041 = local_2.member;
let _e1043 = bitcast<i32>(_e1034);
let _e1044 = (((_e1036 + ((_e1035 + _e1037) * _e196)) + _e1041) + _e1043);
let _e1046 = select(_e209, _e1044, (_e1044 < _e209));
let _e1051 = global_3.member[bitcast<u32>(select(0i, _e1046, (_e1046 > 0i)))];
let _e1052 = (_e1044 + 1i);
let _e1054 = select(_e209, _e1052, (_e1052 < _e209));
let _e1059 = global_3.member[bitcast<u32>(select(0i, _e1054, (_e1054 > 0i)))];
let _e1060 = (_e1044 + _e196);
let _e1062 = select(_e209, _e1060, (_e1060 < _e209));
let _e1067 = global_3.member[bitcast<u32>(select(0i, _e1062, (_e1062 > 0i)))];
let _e1068 = (_e1060 + 1i);
let _e1070 = select(_e209, _e1068, (_e1068 < _e209));
let _e1075 = global_3.member[bitcast<u32>(select(0i, _e1070, (_e1070 > 0i)))];
let _e1076 = local_2.member_2;
let _e1079 = (_e1051 + ((_e1059 - _e1051) * _e1076));
let _e1080 = local_2.member_2;
let _e1084 = local_2.member_3;
let _e1088 = local_2.member;
let _e1089 = (_e1043 + _e1088);
let _e1090 = local_2.member_1;
let _e1091 = (_e1035 + _e1090);
let _e1099 = select(_e1033, (_e1079 + (((_e1067 + ((_e1075 - _e1067) * _e1080)) - _e1079) * _e1084)), ((((_e1089 >= 0i) && (_e1089 < _e260)) && (_e1091 >= 0i)) && (_e1091 < _e267)));
let _e1100 = local;
let _e1101 = local_1;
let _e1102 = local_3.member_1;
let _e1106 = local_3.member;
let _e1108 = bitcast<i32>(_e1100);
let _e1109 = (((_e1036 + ((_e1101 + _e1102) * _e196)) + _e1106) + _e1108);
let _e1111 = select(_e209, _e1109, (_e1109 < _e209));
let _e1116 = global_3.member[bitcast<u32>(select(0i, _e1111, (_e1111 > 0i)))];
let _e1117 = (_e1109 + 1i);
let _e1119 = select(_e209, _e1117, (_e1117 < _e209));
let _e1124 = global_3.member[bitcast<u32>(select(0i, _e1119, (_e1119 > 0i)))];
let _e1125 = (_e1109 + _e196);
let _e1127 = select(_e209, _e1125, (_e1125 < _e209));
let _e1132 = global_3.member[bitcast<u32>(select(0i, _e1127, (_e1127 > 0i)))];
let _e1133 = (_e1125 + 1i);
let _e1135 = select(_e209, _e1133, (_e1133 < _e209));
let _e1140 = global_3.member[bitcast<u32>(select(0i, _e1135, (_e1135 > 0i)))];
let _e1141 = local_3.member_2;
let _e1144 = (_e1116 + ((_e1124 - _e1116) * _e1141));
let _e1145 = local_3.member_2;
let _e1149 = local_3.member_3;
let _e1153 = local_3.member;
let _e1154 = (_e1108 + _e1153);
let _e1155 = local_3.member_1;
let _e1156 = (_e1101 + _e1155);
let _e1165 = local;
let _e1166 = local_1;
let _e1167 = local_4.member_1;
let _e1171 = local_4.member;
let _e1173 = bitcast<i32>(_e1165);
let _e1174 = (((_e1036 + ((_e1166 + _e1167) * _e196)) + _e1171) + _e1173);
let _e1176 = select(_e209, _e1174, (_e1174 < _e209));
let _e1181 = global_3.member[bitcast<u32>(select(0i, _e1176, (_e1176 > 0i)))];
let _e1182 = (_e1174 + 1i);
let _e1184 = select(_e209, _e1182, (_e1182 < _e209));
let _e1189 = global_3.member[bitcast<u32>(select(0i, _e1184, (_e1184 > 0i)))];
let _e1190 = (_e1174 + _e196);
let _e1192 = select(_e209, _e1190, (_e1190 < _e209));
let _e1197 = global_3.member[bitcast<u32>(select(0i, _e1192, (_e1192 > 0i)))];
let _e1198 = (_e1190 + 1i);
let _e1200 = select(_e209, _e1198, (_e1198 < _e209));
let _e1205 = global_3.member[bitcast<u32>(select(0i, _e1200, (_e1200 > 0i)))];
let _e1206 = local_4.member_2;
let _e1209 = (_e1181 + ((_e1189 - _e1181) * _e1206));
let _e1210 = local_4.member_2;
let _e1214 = local_4.member_3;
let _e1218 = local_4.member;
let _e1219 = (_e1173 + _e1218);
let _e1220 = local_4.member_1;
let _e1221 = (_e1166 + _e1220);
let _e1239 = global_1.member.member_9.member.member_2;
let _e1240 = local;
let _e1241 = local_1;
let _e1242 = (5i * _e829);
let _e1243 = local_2.member_1;
let _e1247 = local_2.member;
let _e1249 = bitcast<i32>(_e1240);
let _e1250 = (((_e1242 + ((_e1241 + _e1243) * _e196)) + _e1247) + _e1249);
let _e1252 = select(_e209, _e1250, (_e1250 < _e209));
let _e1257 = global_3.member[bitcast<u32>(select(0i, _e1252, (_e1252 > 0i)))];
let _e1258 = (_e1250 + 1i);
let _e1260 = select(_e209, _e1258, (_e1258 < _e209));
let _e1265 = global_3.member[bitcast<u32>(select(0i, _e1260, (_e1260 > 0i)))];
let _e1266 = (_e1250 + _e196);
let _e1268 = select(_e209, _e1266, (_e1266 < _e209));
let _e1273 = global_3.member[bitcast<u32>(select(0i, _e1268, (_e1268 > 0i)))];
let _e1274 = (_e1266 + 1i);
let _e1276 = select(_e209, _e1274, (_e1274 < _e209));
let _e1281 = global_3.member[bitcast<u32>(select(0i, _e1276, (_e1276 > 0i)))];
let _e1282 = local_2.member_2;
let _e1285 = (_e1257 + ((_e1265 - _e1257) * _e1282));
let _e1286 = local_2.member_2;
let _e1290 = local_2.member_3;
let _e1294 = local_2.member;
let _e1295 = (_e1249 + _e1294);
let _e1296 = local_2.member_1;
let _e1297 = (_e1241 + _e1296);
let _e1305 = select(_e1239, (_e1285 + (((_e1273 + ((_e1281 - _e1273) * _e1286)) - _e1285) * _e1290)), ((((_e1295 >= 0i) && (_e1295 < _e260)) && (_e1297 >= 0i)) && (_e1297 < _e267)));
let _e1306 = local;
let _e1307 = local_1;
let _e1308 = local_3.member_1;
let _e1312 = local_3.member;
let _e1314 = bitcast<i32>(_e1306);
let _e1315 = (((_e1242 + ((_e1307 + _e1308) * _e196)) + _e1312) + _e1314);
let _e1317 = select(_e209, _e1315, (_e1315 < _e209));
let _e1322 = global_3.member[bitcast<u32>(select(0i, _e1317, (_e1317 > 0i)))];
let _e1323 = (_e1315 + 1i);
let _e1325 = select(_e209, _e1323, (_e1323 < _e209));
let _e1330 = global_3.member[bitcast<u32>(select(0i, _e1325, (_e1325 > 0i)))];
let _e1331 = (_e1315 + _e196);
let _e1333 = select(_e209, _e1331, (_e1331 < _e209));
let _e1338 = global_3.member[bitcast<u32>(select(0i, _e1333, (_e1333 > 0i)))];
let _e1339 = (_e1331 + 1i);
let _e1341 = select(_e209, _e1339, (_e1339 < _e209));
let _e1346 = global_3.member[bitcast<u32>(select(0i, _e1341, (_e1341 > 0i)))];
let _e1347 = local_3.member_2;
let _e1350 = (_e1322 + ((_e1330 - _e1322) * _e1347));
let _e1351 = local_3.member_2;
let _e1355 = local_3.member_3;
let _e1359 = local_3.member;
let _e1360 = (_e1314 + _e1359);
let _e1361 = local_3.member_1;
let _e1362 = (_e1307 + _e1361);
let _e1371 = local;
let _e1372 = local_1;
let _e1373 = local_4.member_1;
let _e1377 = local_4.member;
let _e1379 = bitcast<i32>(_e1371);
let _e1380 = (((_e1242 + ((_e1372 + _e1373) * _e196)) + _e1377) + _e1379);
let _e1382 = select(_e209, _e1380, (_e1380 < _e209));
let _e1387 = global_3.member[bitcast<u32>(select(0i, _e1382, (_e1382 > 0i)))];
let _e1388 = (_e1380 + 1i);
let _e1390 = select(_e209, _e1388, (_e1388 < _e209));
let _e1395 = global_3.member[bitcast<u32>(select(0i, _e1390, (_e1390 > 0i)))];
let _e1396 = (_e1380 + _e196);
let _e1398 = select(_e209, _e1396, (_e1396 < _e209));
let _e1403 = global_3.member[bitcast<u32>(select(0i, _e1398, (_e1398 > 0i)))];
let _e1404 = (_e1396 + 1i);
let _e1406 = select(_e209, _e1404, (_e1404 < _e209));
let _e1411 = global_3.member[bitcast<u32>(select(0i, _e1406, (_e1406 > 0i)))];
let _e1412 = local_4.member_2;
let _e1415 = (_e1387 + ((_e1395 - _e1387) * _e1412));
let _e1416 = local_4.member_2;
let _e1420 = local_4.member_3;
let _e1424 = local_4.member;
let _e1425 = (_e1379 + _e1424);
let _e1426 = local_4.member_1;
let _e1427 = (_e1372 + _e1426);
let _e1441 = local;
let _e1442 = local_1;
let _e1443 = (6i * _e829);
let _e1444 = local_2.member_1;
let _e1448 = local_2.member;
let _e1450 = bitcast<i32>(_e1441);
let _e1451 = (((_e1443 + ((_e1442 + _e1444) * _e196)) + _e1448) + _e1450);
let _e1453 = select(_e209, _e1451, (_e1451 < _e209));
let _e1458 = global_3.member[bitcast<u32>(select(0i, _e1453, (_e1453 > 0i)))];
let _e1459 = (_e1451 + 1i);
let _e1461 = select(_e209, _e1459, (_e1459 < _e209));
let _e1466 = global_3.member[bitcast<u32>(select(0i, _e1461, (_e1461 > 0i)))];
let _e1467 = (_e1451 + _e196);
let _e1469 = select(_e209, _e1467, (_e1467 < _e209));
let _e1474 = global_3.member[bitcast<u32>(select(0i, _e1469, (_e1469 > 0i)))];
let _e1475 = (_e1467 + 1i);
let _e1477 = select(_e209, _e1475, (_e1475 < _e209));
let _e1482 = global_3.member[bitcast<u32>(select(0i, _e1477, (_e1477 > 0i)))];
let _e1483 = local_2.member_2;
let _e1486 = (_e1458 + ((_e1466 - _e1458) * _e1483));
let _e1487 = local_2.member_2;
let _e1491 = local_2.member_3;
let _e1495 = local_2.member;
let _e1496 = (_e1450 + _e1495);
let _e1497 = local_2.member_1;
let _e1498 = (_e1442 + _e1497);
let _e1506 = select(0f, (_e1486 + (((_e1474 + ((_e1482 - _e1474) * _e1487)) - _e1486) * _e1491)), ((((_e1496 >= 0i) && (_e1496 < _e260)) && (_e1498 >= 0i)) && (_e1498 < _e267)));
let _e1507 = local;
let _e1508 = local_1;
let _e1509 = local_3.member_1;
let _e1513 = local_3.member;
let _e1515 = bitcast<i32>(_e1507);
let _e1516 = (((_e1443 + ((_e1508 + _e1509) * _e196)) + _e1513) + _e1515);
let _e1518 = select(_e209, _e1516, (_e1516 < _e209));
let _e1523 = global_3.member[bitcast<u32>(select(0i, _e1518, (_e1518 > 0i)))];
let _e1524 = (_e1516 + 1i);
let _e1526 = select(_e209, _e1524, (_e1524 < _e209));
let _e1531 = global_3.member[bitcast<u32>(select(0i, _e1526, (_e1526 > 0i)))];
let _e1532 = (_e1516 + _e196);
let _e1534 = select(_e209, _e1532, (_e1532 < _e209));
let _e1539 = global_3.member[bitcast<u32>(select(0i, _e1534, (_e1534 > 0i)))];
let _e1540 = (_e1532 + 1i);
let _e1542 = select(_e209, _e1540, (_e1540 < _e209));
let _e1547 = global_3.member[bitcast<u32>(select(0i, _e1542, (_e1542 > 0i)))];
let _e1548 = local_3.member_2;
let _e1551 = (_e1523 + ((_e1531 - _e1523) * _e1548));
let _e1552 = local_3.member_2;
let _e1556 = local_3.member_3;
let _e1560 = local_3.member;
let _e1561 = (_e1515 + _e1560);
let _e1562 = local_3.member_1;
let _e1563 = (_e1508 + _e1562);
let _e1572 = local;
let _e1573 = local_1;
let _e1574 = local_4.member_1;
let _e1578 = local_4.member;
let _e1580 = bitcast<i32>(_e1572);
let _e1581 = (((_e1443 + ((_e1573 + _e1574) * _e196)) + _e1578) + _e1580);
let _e1583 = select(_e209, _e1581, (_e1581 < _e209));
let _e1588 = global_3.member[bitcast<u32>(select(0i, _e1583, (_e1583 > 0i)))];
let _e1589 = (_e1581 + 1i);
let _e1591 = select(_e209, _e1589, (_e1589 < _e209));
let _e1596 = global_3.member[bitcast<u32>(select(0i, _e1591, (_e1591 > 0i)))];
let _e1597 = (_e1581 + _e196);
let _e1599 = select(_e209, _e1597, (_e1597 < _e209));
let _e1604 = global_3.member[bitcast<u32>(select(0i, _e1599, (_e1599 > 0i)))];
let _e1605 = (_e1597 + 1i);
let _e1607 = select(_e209, _e1605, (_e1605 < _e209));
let _e1612 = global_3.member[bitcast<u32>(select(0i, _e1607, (_e1607 > 0i)))];
let _e1613 = local_4.member_2;
let _e1616 = (_e1588 + ((_e1596 - _e1588) * _e1613));
let _e1617 = local_4.member_2;
let _e1621 = local_4.member_3;
let _e1625 = local_4.member;
let _e1626 = (_e1580 + _e1625);
let _e1627 = local_4.member_1;
let _e1628 = (_e1573 + _e1627);
let _e1642 = local;
let _e1643 = local_1;
let _e1644 = (7i * _e829);
let _e1645 = local_2.member_1;
let _e1649 = local_2.member;
let _e1651 = bitcast<i32>(_e1642);
let _e1652 = (((_e1644 + ((_e1643 + _e1645) * _e196)) + _e1649) + _e1651);
let _e1654 = select(_e209, _e1652, (_e1652 < _e209));
let _e1659 = global_3.member[bitcast<u32>(select(0i, _e1654, (_e1654 > 0i)))];
let _e1660 = (_e1652 + 1i);
let _e1662 = select(_e209, _e1660, (_e1660 < _e209));
let _e1667 = global_3.member[bitcast<u32>(select(0i, _e1662, (_e1662 > 0i)))];
let _e1668 = (_e1652 + _e196);
let _e1670 = select(_e209, _e1668, (_e1668 < _e209));
let _e1675 = global_3.member[bitcast<u32>(select(0i, _e1670, (_e1670 > 0i)))];
let _e1676 = (_e1668 + 1i);
let _e1678 = select(_e209, _e1676, (_e1676 < _e209));
let _e1683 = global_3.member[bitcast<u32>(select(0i, _e1678, (_e1678 > 0i)))];
let _e1684 = local_2.member_2;
let _e1687 = (_e1659 + ((_e1667 - _e1659) * _e1684));
let _e1688 = local_2.member_2;
let _e1692 = local_2.member_3;
let _e1696 = local_2.member;
let _e1697 = (_e1651 + _e1696);
let _e1698 = local_2.member_1;
let _e1699 = (_e1643 + _e1698);
let _e1707 = select(0f, (_e1687 + (((_e1675 + ((_e1683 - _e1675) * _e1688)) - _e1687) * _e1692)), ((((_e1697 >= 0i) && (_e1697 < _e260)) && (_e1699 >= 0i)) && (_e1699 < _e267)));
let _e1708 = local;
let _e1709 = local_1;
let _e1710 = local_3.member_1;
let _e1714 = local_3.member;
let _e1716 = bitcast<i32>(_e1708);
let _e1717 = (((_e1644 + ((_e1709 + _e1710) * _e196)) + _e1714) + _e1716);
let _e1719 = select(_e209, _e1717, (_e1717 < _e209));
let _e1724 = global_3.member[bitcast<u32>(select(0i, _e1719, (_e1719 > 0i)))];
let _e1725 = (_e1717 + 1i);
let _e1727 = select(_e209, _e1725, (_e1725 < _e209));
let _e1732 = global_3.member[bitcast<u32>(select(0i, _e1727, (_e1727 > 0i)))];
let _e1733 = (_e1717 + _e196);
let _e1735 = select(_e209, _e1733, (_e1733 < _e209));
let _e1740 = global_3.member[bitcast<u32>(select(0i, _e1735, (_e1735 > 0i)))];
let _e1741 = (_e1733 + 1i);
let _e1743 = select(_e209, _e1741, (_e1741 < _e209));
let _e1748 = global_3.member[bitcast<u32>(select(0i, _e1743, (_e1743 > 0i)))];
let _e1749 = local_3.member_2;
let _e1752 = (_e1724 + ((_e1732 - _e1724) * _e1749));
let _e1753 = local_3.member_2;
let _e1757 = local_3.member_3;
let _e1761 = local_3.member;
let _e1762 = (_e1716 + _e1761);
let _e1763 = local_3.member_1;
let _e1764 = (_e1709 + _e1763);
let _e1773 = local;
let _e1774 = local_1;
let _e1775 = local_4.member_1;
let _e1779 = local_4.member;
let _e1781 = bitcast<i32>(_e1773);
let _e1782 = (((_e1644 + ((_e1774 + _e1775) * _e196)) + _e1779) + _e1781);
let _e1784 = select(_e209, _e1782, (_e1782 < _e209));
let _e1789 = global_3.member[bitcast<u32>(select(0i, _e1784, (_e1784 > 0i)))];
let _e1790 = (_e1782 + 1i);
let _e1792 = select(_e209, _e1790, (_e1790 < _e209));
let _e1797 = global_3.member[bitcast<u32>(select(0i, _e1792, (_e1792 > 0i)))];
let _e1798 = (_e1782 + _e196);
let _e1800 = select(_e209, _e1798, (_e1798 < _e209));
let _e1805 = global_3.member[bitcast<u32>(select(0i, _e1800, (_e1800 > 0i)))];
let _e1806 = (_e1798 + 1i);
let _e1808 = select(_e209, _e1806, (_e1806 < _e209));
let _e1813 = global_3.member[bitcast<u32>(select(0i, _e1808, (_e1808 > 0i)))];
let _e1814 = local_4.member_2;
let _e1817 = (_e1789 + ((_e1797 - _e1789) * _e1814));
let _e1818 = local_4.member_2;
let _e1822 = local_4.member_3;
let _e1826 = local_4.member;
let _e1827 = (_e1781 + _e1826);
let _e1828 = local_4.member_1;
let _e1829 = (_e1774 + _e1828);
let _e1843 = local;
let _e1844 = local_1;
let _e1845 = (8i * _e829);
let _e1846 = local_2.member_1;
let _e1850 = local_2.member;
let _e1852 = bitcast<i32>(_e1843);
let _e1853 = (((_e1845 + ((_e1844 + _e1846) * _e196)) + _e1850) + _e1852);
let _e1855 = select(_e209, _e1853, (_e1853 < _e209));
let _e1860 = global_3.member[bitcast<u32>(select(0i, _e1855, (_e1855 > 0i)))];
let _e1861 = (_e1853 + 1i);
let _e1863 = select(_e209, _e1861, (_e1861 < _e209));
let _e1868 = global_3.member[bitcast<u32>(select(0i, _e1863, (_e1863 > 0i)))];
let _e1869 = (_e1853 + _e196);
let _e1871 = select(_e209, _e1869, (_e1869 < _e209));
let _e1876 = global_3.member[bitcast<u32>(select(0i, _e1871, (_e1871 > 0i)))];
let _e1877 = (_e1869 + 1i);
let _e1879 = select(_e209, _e1877, (_e1877 < _e209));
let _e1884 = global_3.member[bitcast<u32>(select(0i, _e1879, (_e1879 > 0i)))];
let _e1885 = local_2.member_2;
let _e1888 = (_e1860 + ((_e1868 - _e1860) * _e1885));
let _e1889 = local_2.member_2;
let _e1893 = local_2.member_3;
let _e1897 = local_2.member;
let _e1898 = (_e1852 + _e1897);
let _e1899 = local_2.member_1;
let _e1900 = (_e1844 + _e1899);
let _e1908 = select(1f, (_e1888 + (((_e1876 + ((_e1884 - _e1876) * _e1889)) - _e1888) * _e1893)), ((((_e1898 >= 0i) && (_e1898 < _e260)) && (_e1900 >= 0i)) && (_e1900 < _e267)));
let _e1909 = local;
let _e1910 = local_1;
let _e1911 = local_3.member_1;
let _e1915 = local_3.member;
let _e1917 = bitcast<i32>(_e1909);
let _e1918 = (((_e1845 + ((_e1910 + _e1911) * _e196)) + _e1915) + _e1917);
let _e1920 = select(_e209, _e1918, (_e1918 < _e209));
let _e1925 = global_3.member[bitcast<u32>(select(0i, _e1920, (_e1920 > 0i)))];
let _e1926 = (_e1918 + 1i);
let _e1928 = select(_e209, _e1926, (_e1926 < _e209));
let _e1933 = global_3.member[bitcast<u32>(select(0i, _e1928, (_e1928 > 0i)))];
let _e1934 = (_e1918 + _e196);
let _e1936 = select(_e209, _e1934, (_e1934 < _e209));
let _e1941 = global_3.member[bitcast<u32>(select(0i, _e1936, (_e1936 > 0i)))];
let _e1942 = (_e1934 + 1i);
let _e1944 = select(_e209, _e1942, (_e1942 < _e209));
let _e1949 = global_3.member[bitcast<u32>(select(0i, _e1944, (_e1944 > 0i)))];
let _e1950 = local_3.member_2;
let _e1953 = (_e1925 + ((_e1933 - _e1925) * _e1950));
let _e1954 = local_3.member_2;
let _e1958 = local_3.member_3;
let _e1962 = local_3.member;
let _e1963 = (_e1917 + _e1962);
let _e1964 = local_3.member_1;
let _e1965 = (_e1910 + _e1964);
let _e1974 = local;
let _e1975 = local_1;
let _e1976 = local_4.member_1;
let _e1980 = local_4.member;
let _e1982 = bitcast<i32>(_e1974);
let _e1983 = (((_e1845 + ((_e1975 + _e1976) * _e196)) + _e1980) + _e1982);
let _e1985 = select(_e209, _e1983, (_e1983 < _e209));
let _e1990 = global_3.member[bitcast<u32>(select(0i, _e1985, (_e1985 > 0i)))];
let _e1991 = (_e1983 + 1i);
let _e1993 = select(_e209, _e1991, (_e1991 < _e209));
let _e1998 = global_3.member[bitcast<u32>(select(0i, _e1993, (_e1993 > 0i)))];
let _e1999 = (_e1983 + _e196);
let _e2001 = select(_e209, _e1999, (_e1999 < _e209));
let _e2006 = global_3.member[bitcast<u32>(select(0i, _e2001, (_e2001 > 0i)))];
let _e2007 = (_e1999 + 1i);
let _e2009 = select(_e209, _e2007, (_e2007 < _e209));
let _e2014 = global_3.member[bitcast<u32>(select(0i, _e2009, (_e2009 > 0i)))];
let _e2015 = local_4.member_2;
let _e2018 = (_e1990 + ((_e1998 - _e1990) * _e2015));
let _e2019 = local_4.member_2;
let _e2023 = local_4.member_3;
let _e2027 = local_4.member;
let _e2028 = (_e1982 + _e2027);
let _e2029 = local_4.member_1;
let _e2030 = (_e1975 + _e2029);
global_2.member[_e58] = _e412;
global_2.member[(_e56 + _e58)] = _e820;
global_2.member[((2u * _e56) + _e58)] = _e818;
global_2.member[((3u * _e56) + _e58)] = (_e893 + (((select(_e825, (_e938 + (((_e926 + ((_e934 - _e926) * _e939)) - _e938) * _e943)), ((((_e948 >= 0i) && (_e948 < _e260)) && (_e950 >= 0i)) && (_e950 < _e267))) - _e893) + (select(_e825, (_e1003 + (((_e991 + ((_e999 - _e991) * _e1004)) - _e1003) * _e1008)), ((((_e1013 >= 0i) && (_e1013 < _e260)) && (_e1015 >= 0i)) && (_e1015 < _e267))) - _e893)) * _e410));
global_2.member[((4u * _e56) + _e58)] = (_e1099 + (((select(_e1033, (_e1144 + (((_e1132 + ((_e1140 - _e1132) * _e1145)) - _e1144) * _e1149)), ((((_e1154 >= 0i) && (_e1154 < _e260)) && (_e1156 >= 0i)) && (_e1156 < _e267))) - _e1099) + (select(_e1033, (_e1209 + (((_e1197 + ((_e1205 - _e1197) * _e1210)) - _e1209) * _e1214)), ((((_e1219 >= 0i) && (_e1219 < _e260)) && (_e1221 >= 0i)) && (_e1221 < _e267))) - _e1099)) * _e410));
global_2.member[((5u * _e56) + _e58)] = (_e1305 + (((select(_e1239, (_e1350 + (((_e1338 + ((_e1346 - _e1338) * _e1351)) - _e1350) * _e1355)), ((((_e1360 >= 0i) && (_e1360 < _e260)) && (_e1362 >= 0i)) && (_e1362 < _e267))) - _e1305) + (select(_e1239, (_e1415 + (((_e1403 + ((_e1411 - _e1403) * _e1416)) - _e1415) * _e1420)), ((((_e1425 >= 0i) && (_e1425 < _e260)) && (_e1427 >= 0i)) && (_e1427 < _e267))) - _e1305)) * _e410));
global_2.member[((6u * _e56) + _e58)] = (_e1506 + (((select(0f, (_e1551 + (((_e1539 + ((_e1547 - _e1539) * _e1552)) - _e1551) * _e1556)), ((((_e1561 >= 0i) && (_e1561 < _e260)) && (_e1563 >= 0i)) && (_e1563 < _e267))) - _e1506) + (select(0f, (_e1616 + (((_e1604 + ((_e1612 - _e1604) * _e1617)) - _e1616) * _e1621)), ((((_e1626 >= 0i) && (_e1626 < _e260)) && (_e1628 >= 0i)) && (_e1628 < _e267))) - _e1506)) * _e410));
global_2.member[((7u * _e56) + _e58)] = (_e1707 + (((select(0f, (_e1752 + (((_e1740 + ((_e1748 - _e1740) * _e1753)) - _e1752) * _e1757)), ((((_e1762 >= 0i) && (_e1762 < _e260)) && (_e1764 >= 0i)) && (_e1764 < _e267))) - _e1707) + (select(0f, (_e1817 + (((_e1805 + ((_e1813 - _e1805) * _e1818)) - _e1817) * _e1822)), ((((_e1827 >= 0i) && (_e1827 < _e260)) && (_e1829 >= 0i)) && (_e1829 < _e267))) - _e1707)) * _e410));
global_2.member[((8u * _e56) + _e58)] = (_e1908 + (((select(1f, (_e1953 + (((_e1941 + ((_e1949 - _e1941) * _e1954)) - _e1953) * _e1958)), ((((_e1963 >= 0i) && (_e1963 < _e260)) && (_e1965 >= 0i)) && (_e1965 < _e267))) - _e1908) + (select(1f, (_e2018 + (((_e2006 + ((_e2014 - _e2006) * _e2019)) - _e2018) * _e2023)), ((((_e2028 >= 0i) && (_e2028 < _e260)) && (_e2030 >= 0i)) && (_e2030 < _e267))) - _e1908)) * _e410));
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
