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
struct type_18 {
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
struct type_19 {
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
struct type_20 {
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
struct type_21 {
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
struct type_22 {
member: type_5,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_23 {
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
member_11: type_18,
member_12: type_19,
member_13: type_20,
member_14: type_9,
member_15: type_6,
member_16: type_12,
member_17: u32,
member_18: type_21,
member_19: type_22,
}
struct type_24 {
member: type_23,
}
var<private> global: vec3<u32>;
@group(0) @binding(3)
var<storage> global_1: type_15;
@group(0) @binding(4)
var<storage, read_write> global_2: type_15;
@group(0) @binding(0)
var<storage> global_3: type_24;
@group(0) @binding(1)
var<storage> global_4: type_15;
@group(0) @binding(2)
var<storage> global_5: type_15;
fn function_() {
var local: i32;
var local_1: i32;
var local_2: i32;
var local_3: i32;
var local_4: i32;
var local_5: i32;
var local_6: i32;
var local_7: i32;
var local_8: f32;
var local_9: i32;
var local_10: f32;
var local_11: i32;
var local_12: f32;
var local_13: i32;
var local_14: i32;
var local_15: i32;
var phi_1830_: vec3<f32>;
var phi_1833_: i32;
var phi_1835_: f32;
var phi_1978_: i32;
var phi_1991_: i32;
var phi_2005_: i32;
var phi_2321_: i32;
var phi_2334_: i32;
var phi_2348_: i32;
var phi_2551_: f32;
var phi_2664_: i32;
var phi_2677_: i32;
var phi_2691_: i32;
var phi_2891_: f32;
var phi_1831_: vec3<f32>;
var phi_1834_: i32;
var phi_1836_: f32;
var local_16: vec3<f32>;
var local_17: vec3<f32>;
var local_18: vec3<f32>;
var phi_3942_: array<f32, 22>;
let _e94 = global;
let _e103 = arrayLength((&global_1.member));
let _e108 = global_3.member.member;
if (_e94.x < _e108.member) {
if (_e94.y < _e108.member_1) {
let _e115 = (_e108.member * _e108.member_1);
let _e117 = ((_e94.y * _e108.member) + _e94.x);
let _e118 = bitcast<i32>(_e117);
let _e120 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e122 = select(_e120, _e118, (_e118 < _e120));
let _e128 = global_2.member[bitcast<u32>(select(0i, _e122, (_e122 > 0i)))];
let _e129 = (_e115 + _e117);
let _e130 = bitcast<i32>(_e129);
let _e132 = select(_e120, _e130, (_e130 < _e120));
let _e138 = global_2.member[bitcast<u32>(select(0i, _e132, (_e132 > 0i)))];
let _e140 = ((2u * _e115) + _e117);
let _e141 = bitcast<i32>(_e140);
let _e143 = select(_e120, _e141, (_e141 < _e120));
let _e149 = global_2.member[bitcast<u32>(select(0i, _e143, (_e143 > 0i)))];
let _e151 = ((3u * _e115) + _e117);
let _e152 = bitcast<i32>(_e151);
let _e154 = select(_e120, _e152, (_e152 < _e120));
let _e160 = global_2.member[bitcast<u32>(select(0i, _e154, (_e154 > 0i)))];
let _e162 = ((4u * _e115) + _e117);
let _e163 = bitcast<i32>(_e162);
let _e165 = select(_e120, _e163, (_e163 < _e120));
let _e171 = global_2.member[bitcast<u32>(select(0i, _e165, (_e165 > 0i)))];
let _e173 = ((5u * _e115) + _e117);
let _e174 = bitcast<i32>(_e173);
let _e176 = select(_e120, _e174, (_e174 < _e120));
let _e182 = global_2.member[bitcast<u32>(select(0i, _e176, (_e176 > 0i)))];
let _e184 = ((6u * _e115) + _e117);
let _e185 = bitcast<i32>(_e184);
let _e187 = select(_e120, _e185, (_e185 < _e120));
let _e193 = global_2.member[bitcast<u32>(select(0i, _e187, (_e187 > 0i)))];
let _e195 = ((7u * _e115) + _e117);
let _e196 = bitcast<i32>(_e195);
let _e198 = select(_e120, _e196, (_e196 < _e120));
let _e204 = global_2.member[bitcast<u32>(select(0i, _e198, (_e198 > 0i)))];
let _e206 = ((8u * _e115) + _e117);
let _e207 = bitcast<i32>(_e206);
let _e209 = select(_e120, _e207, (_e207 < _e120));
let _e215 = global_2.member[bitcast<u32>(select(0i, _e209, (_e209 > 0i)))];
let _e217 = ((9u * _e115) + _e117);
let _e218 = bitcast<i32>(_e217);
let _e220 = select(_e120, _e218, (_e218 < _e120));
let _e226 = global_2.member[bitcast<u32>(select(0i, _e220, (_e220 > 0i)))];
let _e228 = ((10u * _e115) + _e117);
let _e229 = bitcast<i32>(_e228);
let _e231 = select(_e120, _e229, (_e229 < _e120));
let _e237 = global_2.member[bitcast<u32>(select(0i, _e231, (_e231 > 0i)))];
let _e239 = ((11u * _e115) + _e117);
let _e240 = bitcast<i32>(_e239);
let _e242 = select(_e120, _e240, (_e240 < _e120));
let _e248 = global_2.member[bitcast<u32>(select(0i, _e242, (_e242 > 0i)))];
let _e250 = ((12u * _e115) + _e117);
let _e251 = bitcast<i32>(_e250);
let _e253 = select(_e120, _e251, (_e251 < _e120));
let _e259 = global_2.member[bitcast<u32>(select(0i, _e253, (_e253 > 0i)))];
let _e261 = ((13u * _e115) + _e117);
let _e262 = bitcast<i32>(_e261);
let _e264 = select(_e120, _e262, (_e262 < _e120));
let _e270 = global_2.member[bitcast<u32>(select(0i, _e264, (_e264 > 0i)))];
let _e272 = ((14u * _e115) + _e117);
let _e273 = bitcast<i32>(_e272);
let _e275 = select(_e120, _e273, (_e273 < _e120));
let _e281 = global_2.member[bitcast<u32>(select(0i, _e275, (_e275 > 0i)))];
let _e283 = ((15u * _e115) + _e117);
let _e284 = bitcast<i32>(_e283);
let _e286 = select(_e120, _e284, (_e284 < _e120));
let _e292 = global_2.member[bitcast<u32>(select(0i, _e286, (_e286 > 0i)))];
let _e294 = ((16u * _e115) + _e117);
let _e295 = bitcast<i32>(_e294);
let _e297 = select(_e120, _e295, (_e295 < _e120));
let _e303 = global_2.member[bitcast<u32>(select(0i, _e297, (_e297 > 0i)))];
let _e305 = ((17u * _e115) + _e117);
let _e306 = bitcast<i32>(_e305);
let _e308 = select(_e120, _e306, (_e306 < _e120));
let _e314 = global_2.member[bitcast<u32>(select(0i, _e308, (_e308 > 0i)))];
let _e316 = ((18u * _e115) + _e117);
let _e317 = bitcast<i32>(_e316);
let _e319 = select(_e120, _e317, (_e317 < _e120));
let _e325 = global_2.member[bitcast<u32>(select(0i, _e319, (_e319 > 0i)))];
let _e327 = ((19u * _e115) + _e117);
let _e328 = bitcast<i32>(_e327);
let _e330 = select(_e120, _e328, (_e328 < _e120));
let _e336 = global_2.member[bitcast<u32>(select(0i, _e330, (_e330 > 0i)))];
let _e338 = ((20u * _e115) + _e117);
let _e339 = bitcast<i32>(_e338);
let _e341 = select(_e120, _e339, (_e339 < _e120));
let _e347 = global_2.member[bitcast<u32>(select(0i, _e341, (_e341 > 0i)))];
let _e349 = ((21u * _e115) + _e117);
let _e350 = bitcast<i32>(_e349);
let _e352 = select(_e120, _e350, (_e350 < _e120));
let _e358 = global_2.member[bitcast<u32>(select(0i, _e352, (_e352 > 0i)))];
let _e363 = global_3.member.member.member;
let _e367 = global_3.member.member.member_1;
let _e368 = (_e363 * _e367);
local_14 = bitcast<i32>(_e368);
let _e371 = ((_e94.y * _e363) + _e94.x);
let _e372 = bitcast<i32>(_e371);
local_15 = _e372;
let _e373 = local_14;
let _e375 = local_15;
let _e376 = ((29i * _e373) + _e375);
let _e378 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e380 = select(_e378, _e376, (_e376 < _e378));
let _e385 = global_4.member[bitcast<u32>(select(0i, _e380, (_e380 > 0i)))];
let _e387 = local_14;
let _e389 = local_15;
let _e390 = ((36i * _e387) + _e389);
let _e392 = select(_e378, _e390, (_e390 < _e378));
let _e397 = global_4.member[bitcast<u32>(select(0i, _e392, (_e392 > 0i)))];
let _e408 = global_3.member.member_12.member_4;
if (select(0u, 3u, ((_e385 == 2f) && (select(0i, select(select(i32(_e397), i32(-2147483648), (_e397 < -2147483600f)), 2147483647i, (_e397 > 2147483500f)), (_e397 == _e397)) == (bitcast<i32>(_e408) + 1i)))) > 1u) {
let _e416 = select(_e378, _e372, (_e372 < _e378));
let _e422 = global_4.member[bitcast<u32>(select(0i, _e416, (_e416 > 0i)))];
let _e424 = bitcast<i32>((_e368 + _e371));
let _e426 = select(_e378, _e424, (_e424 < _e378));
let _e432 = global_4.member[bitcast<u32>(select(0i, _e426, (_e426 > 0i)))];
let _e435 = bitcast<i32>(((2u * _e368) + _e371));
let _e437 = select(_e378, _e435, (_e435 < _e378));
let _e443 = global_4.member[bitcast<u32>(select(0i, _e437, (_e437 > 0i)))];
let _e446 = bitcast<i32>(((3u * _e368) + _e371));
let _e448 = select(_e378, _e446, (_e446 < _e378));
let _e454 = global_4.member[bitcast<u32>(select(0i, _e448, (_e448 > 0i)))];
let _e457 = bitcast<i32>(((4u * _e368) + _e371));
let _e459 = select(_e378, _e457, (_e457 < _e378));
let _e465 = global_4.member[bitcast<u32>(select(0i, _e459, (_e459 > 0i)))];
let _e468 = bitcast<i32>(((5u * _e368) + _e371));
let _e470 = select(_e378, _e468, (_e468 < _e378));
let _e476 = global_4.member[bitcast<u32>(select(0i, _e470, (_e470 > 0i)))];
let _e479 = bitcast<i32>(((18u * _e368) + _e371));
let _e481 = select(_e378, _e479, (_e479 < _e378));
let _e487 = global_4.member[bitcast<u32>(select(0i, _e481, (_e481 > 0i)))];
let _e490 = bitcast<i32>(((19u * _e368) + _e371));
let _e492 = select(_e378, _e490, (_e490 < _e378));
let _e498 = global_4.member[bitcast<u32>(select(0i, _e492, (_e492 > 0i)))];
let _e501 = bitcast<i32>(((20u * _e368) + _e371));
let _e503 = select(_e378, _e501, (_e501 < _e378));
let _e509 = global_4.member[bitcast<u32>(select(0i, _e503, (_e503 > 0i)))];
let _e512 = bitcast<i32>(((24u * _e368) + _e371));
let _e514 = select(_e378, _e512, (_e512 < _e378));
let _e520 = global_4.member[bitcast<u32>(select(0i, _e514, (_e514 > 0i)))];
let _e523 = bitcast<i32>(((30u * _e368) + _e371));
let _e525 = select(_e378, _e523, (_e523 < _e378));
let _e531 = global_4.member[bitcast<u32>(select(0i, _e525, (_e525 > 0i)))];
let _e539 = (select(0i, select(select(i32(_e531), i32(-2147483648), (_e531 < -2147483600f)), 2147483647i, (_e531 > 2147483500f)), (_e531 == _e531)) == 0i);
let _e547 = global_3.member.member_1.member;
let _e553 = global_3.member.member_1.member_1;
let _e563 = global_3.member.member_2.member;
let _e564 = (((((f32(bitcast<i32>(_e94.x)) + 0.5f) / f32(bitcast<i32>(_e547))) * 2f) - 1f) * _e563);
let _e572 = global_3.member.member_2.member_1;
let _e573 = ((1f - (((f32(bitcast<i32>(_e94.y)) + 0.5f) / f32(bitcast<i32>(_e553))) * 2f)) * _e572);
let _e576 = global_3.member.member_3;
let _e585 = global_3.member.member_4;
let _e598 = global_3.member.member_2.member_3;
let _e599 = (_e598 != 0u);
let _e602 = global_3.member.member_6;
let _e609 = select(_e602.member, (_e602.member + ((_e576.member * _e564) + (_e585.member * _e573))), _e599);
let _e610 = select(_e602.member_1, (_e602.member_1 + ((_e576.member_1 * _e564) + (_e585.member_1 * _e573))), _e599);
let _e611 = select(_e602.member_2, (_e602.member_2 + ((_e576.member_2 * _e564) + (_e585.member_2 * _e573))), _e599);
let _e621 = select(_e422, _e609, _e539);
let _e622 = select(_e432, _e610, _e539);
let _e623 = select(_e443, _e611, _e539);
let _e624 = (select(0f, ((((_e422 - _e609) * _e454) + ((_e432 - _e610) * _e465)) + ((_e443 - _e611) * _e476)), _e539) + _e520);
let _e625 = select(_e487, 1f, _e539);
let _e626 = select(_e498, 1f, _e539);
let _e627 = select(_e509, 1f, _e539);
let _e635 = (1f / select(_e454, select(1e-12f, -1e-12f, (_e454 < 0f)), (bitcast<f32>((bitcast<u32>(_e454) & 2147483647u)) < 1e-12f)));
let _e643 = (1f / select(_e465, select(1e-12f, -1e-12f, (_e465 < 0f)), (bitcast<f32>((bitcast<u32>(_e465) & 2147483647u)) < 1e-12f)));
let _e651 = (1f / select(_e476, select(1e-12f, -1e-12f, (_e476 < 0f)), (bitcast<f32>((bitcast<u32>(_e476) & 2147483647u)) < 1e-12f)));
let _e655 = global_3.member.member_13.member_4;
let _e662 = global_3.member.member_13.member_5;
let _e667 = ((_e655.member - _e621) * _e635);
let _e669 = ((_e662.member - _e621) * _e635);
let _e671 = ((_e655.member_1 - _e622) * _e643);
let _e673 = ((_e662.member_1 - _e622) * _e643);
let _e675 = ((_e655.member_2 - _e623) * _e651);
let _e677 = ((_e662.member_2 - _e623) * _e651);
let _e679 = select(_e669, _e667, (_e667 < _e669));
let _e681 = select(_e673, _e671, (_e671 < _e673));
let _e683 = select(_e681, _e679, (_e679 > _e681));
let _e685 = select(_e677, _e675, (_e675 < _e677));
let _e687 = select(_e685, _e683, (_e683 > _e685));
let _e689 = select(_e669, _e667, (_e667 > _e669));
let _e691 = select(_e673, _e671, (_e671 > _e673));
let _e693 = select(_e691, _e689, (_e689 < _e691));
let _e695 = select(_e677, _e675, (_e675 > _e677));
let _e697 = select(_e695, _e693, (_e693 < _e695));
let _e699 = select(0f, _e687, (_e687 > 0f));
let _e701 = select(_e624, _e697, (_e697 < _e624));
let _e702 = (_e701 > _e699);
let _e703 = select(0f, _e699, _e702);
let _e704 = select(0f, _e701, _e702);
if ((_e704 <= _e703) || ((((_e625 + _e626) + _e627) * (1f / 3f)) < 0.01f)) {
phi_3942_ = array<f32, 22>(_e128, _e138, _e149, _e160, _e171, _e182, _e193, _e204, _e215, _e226, _e237, _e248, _e259, _e270, _e281, _e292, _e303, _e314, _e325, _e336, _e347, _e358);
} else {
let _e714 = ((_e704 - _e703) * (1f / 24f));
let _e718 = global_3.member.member_13.member_6;
let _e719 = (_e718 > 0u);
phi_1830_ = vec3<f32>(0f, 0f, 0f);
phi_1833_ = 0i;
phi_1835_ = 0f;
loop {
let _e721 = phi_1830_;
let _e723 = phi_1833_;
let _e725 = phi_1835_;
local_16 = _e721;
local_17 = _e721;
local_18 = _e721;
let _e726 = (_e723 < 24i);
if _e726 {
let _e729 = (_e703 + (_e714 * f32(_e723)));
let _e731 = (_e729 + (0.5f * _e714));
let _e735 = (_e621 + (_e454 * _e731));
let _e736 = (_e622 + (_e465 * _e731));
let _e737 = (_e623 + (_e476 * _e731));
if _e719 {
let _e738 = (_e729 + _e714);
let _e740 = (0.5f * (_e729 + _e738));
let _e741 = (_e738 - _e729);
let _e742 = (0.28867513f * _e741);
let _e743 = (_e740 - _e742);
let _e753 = global_3.member.member_13.member_7;
let _e754 = bitcast<i32>(_e753);
let _e758 = global_3.member.member_13.member_8;
let _e759 = bitcast<i32>(_e758);
let _e763 = global_3.member.member_13.member_9;
let _e764 = bitcast<i32>(_e763);
let _e765 = f32(_e754);
let _e767 = (_e662.member - _e655.member);
let _e770 = (((((_e621 + (_e454 * _e743)) - _e655.member) / _e767) * _e765) - 0.5f);
let _e771 = (_e765 - 1f);
let _e773 = select(0f, _e770, (_e770 > 0f));
let _e775 = select(_e771, _e773, (_e773 < _e771));
let _e776 = f32(_e759);
let _e778 = (_e662.member_1 - _e655.member_1);
let _e781 = (((((_e622 + (_e465 * _e743)) - _e655.member_1) / _e778) * _e776) - 0.5f);
let _e782 = (_e776 - 1f);
let _e784 = select(0f, _e781, (_e781 > 0f));
let _e786 = select(_e782, _e784, (_e784 < _e782));
let _e787 = f32(_e764);
let _e789 = (_e662.member_2 - _e655.member_2);
let _e792 = (((((_e623 + (_e476 * _e743)) - _e655.member_2) / _e789) * _e787) - 0.5f);
let _e793 = (_e787 - 1f);
let _e795 = select(0f, _e792, (_e792 > 0f));
let _e797 = select(_e793, _e795, (_e795 < _e793));
let _e799 = select(0f, _e775, (_e775 > 0f));
let _e801 = select(1e6f, _e799, (_e799 < 1e6f));
let _e808 = select(0i, select(select(i32(_e801), i32(-2147483648), (_e801 < -2147483600f)), 2147483647i, (_e801 > 2147483500f)), (_e801 == _e801));
let _e812 = (_e808 - select(0i, 1i, (_e801 < f32(_e808))));
let _e814 = select(0f, _e786, (_e786 > 0f));
let _e816 = select(1e6f, _e814, (_e814 < 1e6f));
let _e823 = select(0i, select(select(i32(_e816), i32(-2147483648), (_e816 < -2147483600f)), 2147483647i, (_e816 > 2147483500f)), (_e816 == _e816));
let _e827 = (_e823 - select(0i, 1i, (_e816 < f32(_e823))));
let _e829 = select(0f, _e797, (_e797 > 0f));
let _e831 = select(1e6f, _e829, (_e829 < 1e6f));
let _e838 = select(0i, select(select(i32(_e831), i32(-2147483648), (_e831 < -2147483600f)), 2147483647i, (_e831 > 2147483500f)), (_e831 == _e831));
let _e842 = (_e838 - select(0i, 1i, (_e831 < f32(_e838))));
let _e846 = (_e786 - f32(_e827));
let _e848 = (_e797 - f32(_e842));
local_12 = (_e775 - f32(_e812));
let _e849 = (_e812 + 1i);
let _e851 = select(_e849, 0i, (_e849 < 0i));
if (_e851 >= _e754) {
phi_1978_ = (_e754 - 1i);
} else {
phi_1978_ = _e851;
}
let _e855 = phi_1978_;
local_13 = (_e855 - _e812);
let _e857 = (_e827 + 1i);
let _e859 = select(_e857, 0i, (_e857 < 0i));
if (_e859 >= _e759) {
phi_1991_ = (_e759 - 1i);
} else {
phi_1991_ = _e859;
}
let _e863 = phi_1991_;
let _e865 = ((_e863 - _e827) * _e754);
let _e866 = (_e842 + 1i);
let _e868 = select(_e866, 0i, (_e866 < 0i));
if (_e868 >= _e764) {
phi_2005_ = (_e764 - 1i);
} else {
phi_2005_ = _e868;
}
let _e872 = phi_2005_;
let _e879 = global_3.member.member_13.member_10;
let _e880 = bitcast<i32>(_e879);
let _e885 = ((_e880 + (((_e842 * _e759) + _e827) * _e754)) + _e812);
let _e887 = (bitcast<i32>(_e103) - 1i);
let _e889 = select(_e887, _e885, (_e885 < _e887));
let _e894 = global_1.member[bitcast<u32>(select(0i, _e889, (_e889 > 0i)))];
let _e895 = local_12;
let _e898 = local_13;
let _e899 = (_e885 + _e898);
let _e901 = select(_e887, _e899, (_e899 < _e887));
let _e906 = global_1.member[bitcast<u32>(select(0i, _e901, (_e901 > 0i)))];
let _e907 = local_12;
let _e910 = (1f - _e846);
let _e912 = (_e885 + _e865);
let _e914 = select(_e887, _e912, (_e912 < _e887));
let _e919 = global_1.member[bitcast<u32>(select(0i, _e914, (_e914 > 0i)))];
let _e920 = local_12;
let _e923 = local_13;
let _e924 = (_e912 + _e923);
let _e926 = select(_e887, _e924, (_e924 < _e887));
let _e931 = global_1.member[bitcast<u32>(select(0i, _e926, (_e926 > 0i)))];
let _e932 = local_12;
let _e937 = (_e885 + (((_e872 - _e842) * _e754) * _e759));
let _e939 = select(_e887, _e937, (_e937 < _e887));
let _e944 = global_1.member[bitcast<u32>(select(0i, _e939, (_e939 > 0i)))];
let _e945 = local_12;
let _e948 = local_13;
let _e949 = (_e937 + _e948);
let _e951 = select(_e887, _e949, (_e949 < _e887));
let _e956 = global_1.member[bitcast<u32>(select(0i, _e951, (_e951 > 0i)))];
let _e957 = local_12;
let _e961 = (_e937 + _e865);
let _e963 = select(_e887, _e961, (_e961 < _e887));
let _e968 = global_1.member[bitcast<u32>(select(0i, _e963, (_e963 > 0i)))];
let _e969 = local_12;
let _e972 = local_13;
let _e973 = (_e961 + _e972);
let _e975 = select(_e887, _e973, (_e973 < _e887));
let _e980 = global_1.member[bitcast<u32>(select(0i, _e975, (_e975 > 0i)))];
let _e981 = local_12;
let _e990 = (_e740 + _e742);
let _e1000 = (((((_e621 + (_e454 * _e990)) - _e655.member) / _e767) * _e765) - 0.5f);
let _e1002 = select(0f, _e1000, (_e1000 > 0f));
let _e1004 = select(_e771, _e1002, (_e1002 < _e771));
let _e1008 = (((((_e622 + (_e465 * _e990)) - _e655.member_1) / _e778) * _e776) - 0.5f);
let _e1010 = select(0f, _e1008, (_e1008 > 0f));
let _e1012 = select(_e782, _e1010, (_e1010 < _e782));
let _e1016 = (((((_e623 + (_e476 * _e990)) - _e655.member_2) / _e789) * _e787) - 0.5f);
let _e1018 = select(0f, _e1016, (_e1016 > 0f));
let _e1020 = select(_e793, _e1018, (_e1018 < _e793));
let _e1022 = select(0f, _e1004, (_e1004 > 0f));
let _e1024 = select(1e6f, _e1022, (_e1022 < 1e6f));
let _e1031 = select(0i, select(select(i32(_e1024), i32(-2147483648), (_e1024 < -2147483600f)), 2147483647i, (_e1024 > 2147483500f)), (_e1024 == _e1024));
let _e1035 = (_e1031 - select(0i, 1i, (_e1024 < f32(_e1031))));
let _e1037 = select(0f, _e1012, (_e1012 > 0f));
let _e1039 = select(1e6f, _e1037, (_e1037 < 1e6f));
let _e1046 = select(0i, select(select(i32(_e1039), i32(-2147483648), (_e1039 < -2147483600f)), 2147483647i, (_e1039 > 2147483500f)), (_e1039 == _e1039));
let _e1050 = (_e1046 - select(0i, 1i, (_e1039 < f32(_e1046))));
let _e1052 = select(0f, _e1020, (_e1020 > 0f));
let _e1054 = select(1e6f, _e1052, (_e1052 < 1e6f));
let _e1061 = select(0i, select(select(i32(_e1054), i32(-2147483648), (_e1054 < -2147483600f)), 2147483647i, (_e1054 > 2147483500f)), (_e1054 == _e1054));
let _e1065 = (_e1061 - select(0i, 1i, (_e1054 < f32(_e1061))));
let _e1069 = (_e1012 - f32(_e1050));
let _e1071 = (_e1020 - f32(_e1065));
local_10 = (_e1004 - f32(_e1035));
let _e1072 = (_e1035 + 1i);
let _e1074 = select(_e1072, 0i, (_e1072 < 0i));
if (_e1074 >= _e754) {
phi_2321_ = (_e754 - 1i);
} else {
phi_2321_ = _e1074;
}
let _e1078 = phi_2321_;
local_11 = (_e1078 - _e1035);
let _e1080 = (_e1050 + 1i);
let _e1082 = select(_e1080, 0i, (_e1080 < 0i));
if (_e1082 >= _e759) {
phi_2334_ = (_e759 - 1i);
} else {
phi_2334_ = _e1082;
}
let _e1086 = phi_2334_;
let _e1088 = ((_e1086 - _e1050) * _e754);
let _e1089 = (_e1065 + 1i);
let _e1091 = select(_e1089, 0i, (_e1089 < 0i));
if (_e1091 >= _e764) {
phi_2348_ = (_e764 - 1i);
} else {
phi_2348_ = _e1091;
}
let _e1095 = phi_2348_;
let _e1103 = ((_e880 + (((_e1065 * _e759) + _e1050) * _e754)) + _e1035);
let _e1105 = select(_e887, _e1103, (_e1103 < _e887));
let _e1110 = global_1.member[bitcast<u32>(select(0i, _e1105, (_e1105 > 0i)))];
let _e1111 = local_10;
let _e1114 = local_11;
let _e1115 = (_e1103 + _e1114);
let _e1117 = select(_e887, _e1115, (_e1115 < _e887));
let _e1122 = global_1.member[bitcast<u32>(select(0i, _e1117, (_e1117 > 0i)))];
let _e1123 = local_10;
let _e1126 = (1f - _e1069);
let _e1128 = (_e1103 + _e1088);
let _e1130 = select(_e887, _e1128, (_e1128 < _e887));
let _e1135 = global_1.member[bitcast<u32>(select(0i, _e1130, (_e1130 > 0i)))];
let _e1136 = local_10;
let _e1139 = local_11;
let _e1140 = (_e1128 + _e1139);
let _e1142 = select(_e887, _e1140, (_e1140 < _e887));
let _e1147 = global_1.member[bitcast<u32>(select(0i, _e1142, (_e1142 > 0i)))];
let _e1148 = local_10;
let _e1153 = (_e1103 + (((_e1095 - _e1065) * _e754) * _e759));
let _e1155 = select(_e887, _e1153, (_e1153 < _e887));
let _e1160 = global_1.member[bitcast<u32>(select(0i, _e1155, (_e1155 > 0i)))];
let _e1161 = local_10;
let _e1164 = local_11;
let _e1165 = (_e1153 + _e1164);
let _e1167 = select(_e887, _e1165, (_e1165 < _e887));
let _e1172 = global_1.member[bitcast<u32>(select(0i, _e1167, (_e1167 > 0i)))];
let _e1173 = local_10;
let _e1177 = (_e1153 + _e1088);
let _e1179 = select(_e887, _e1177, (_e1177 < _e887));
let _e1184 = global_1.member[bitcast<u32>(select(0i, _e1179, (_e1179 > 0i)))];
let _e1185 = local_10;
let _e1188 = local_11;
let _e1189 = (_e1177 + _e1188);
let _e1191 = select(_e887, _e1189, (_e1189 < _e887));
let _e1196 = global_1.member[bitcast<u32>(select(0i, _e1191, (_e1191 > 0i)))];
let _e1197 = local_10;
phi_2551_ = ((0.5f * (((((((_e894 * (1f - _e895)) + (_e906 * _e907)) * _e910) + (((_e919 * (1f - _e920)) + (_e931 * _e932)) * _e846)) * (1f - _e848)) + (((((_e944 * (1f - _e945)) + (_e956 * _e957)) * _e910) + (((_e968 * (1f - _e969)) + (_e980 * _e981)) * _e846)) * _e848)) + ((((((_e1110 * (1f - _e1111)) + (_e1122 * _e1123)) * _e1126) + (((_e1135 * (1f - _e1136)) + (_e1147 * _e1148)) * _e1069)) * (1f - _e1071)) + (((((_e1160 * (1f - _e1161)) + (_e1172 * _e1173)) * _e1126) + (((_e1184 * (1f - _e1185)) + (_e1196 * _e1197)) * _e1069)) * _e1071)))) * _e741);
} else {
phi_2551_ = _e714;
}
let _e1210 = phi_2551_;
if _e719 {
let _e1214 = global_3.member.member_13.member_7;
let _e1215 = bitcast<i32>(_e1214);
let _e1219 = global_3.member.member_13.member_8;
let _e1220 = bitcast<i32>(_e1219);
let _e1224 = global_3.member.member_13.member_9;
let _e1225 = bitcast<i32>(_e1224);
let _e1226 = f32(_e1215);
let _e1231 = ((((_e735 - _e655.member) / (_e662.member - _e655.member)) * _e1226) - 0.5f);
let _e1232 = (_e1226 - 1f);
let _e1234 = select(0f, _e1231, (_e1231 > 0f));
let _e1236 = select(_e1232, _e1234, (_e1234 < _e1232));
let _e1237 = f32(_e1220);
let _e1242 = ((((_e736 - _e655.member_1) / (_e662.member_1 - _e655.member_1)) * _e1237) - 0.5f);
let _e1243 = (_e1237 - 1f);
let _e1245 = select(0f, _e1242, (_e1242 > 0f));
let _e1247 = select(_e1243, _e1245, (_e1245 < _e1243));
let _e1248 = f32(_e1225);
let _e1253 = ((((_e737 - _e655.member_2) / (_e662.member_2 - _e655.member_2)) * _e1248) - 0.5f);
let _e1254 = (_e1248 - 1f);
let _e1256 = select(0f, _e1253, (_e1253 > 0f));
let _e1258 = select(_e1254, _e1256, (_e1256 < _e1254));
let _e1260 = select(0f, _e1236, (_e1236 > 0f));
let _e1262 = select(1e6f, _e1260, (_e1260 < 1e6f));
let _e1269 = select(0i, select(select(i32(_e1262), i32(-2147483648), (_e1262 < -2147483600f)), 2147483647i, (_e1262 > 2147483500f)), (_e1262 == _e1262));
let _e1273 = (_e1269 - select(0i, 1i, (_e1262 < f32(_e1269))));
let _e1275 = select(0f, _e1247, (_e1247 > 0f));
let _e1277 = select(1e6f, _e1275, (_e1275 < 1e6f));
let _e1284 = select(0i, select(select(i32(_e1277), i32(-2147483648), (_e1277 < -2147483600f)), 2147483647i, (_e1277 > 2147483500f)), (_e1277 == _e1277));
let _e1288 = (_e1284 - select(0i, 1i, (_e1277 < f32(_e1284))));
let _e1290 = select(0f, _e1258, (_e1258 > 0f));
let _e1292 = select(1e6f, _e1290, (_e1290 < 1e6f));
let _e1299 = select(0i, select(select(i32(_e1292), i32(-2147483648), (_e1292 < -2147483600f)), 2147483647i, (_e1292 > 2147483500f)), (_e1292 == _e1292));
let _e1303 = (_e1299 - select(0i, 1i, (_e1292 < f32(_e1299))));
let _e1307 = (_e1247 - f32(_e1288));
let _e1309 = (_e1258 - f32(_e1303));
local_8 = (_e1236 - f32(_e1273));
let _e1310 = (_e1273 + 1i);
let _e1312 = select(_e1310, 0i, (_e1310 < 0i));
if (_e1312 >= _e1215) {
phi_2664_ = (_e1215 - 1i);
} else {
phi_2664_ = _e1312;
}
let _e1316 = phi_2664_;
local_9 = (_e1316 - _e1273);
let _e1318 = (_e1288 + 1i);
let _e1320 = select(_e1318, 0i, (_e1318 < 0i));
if (_e1320 >= _e1220) {
phi_2677_ = (_e1220 - 1i);
} else {
phi_2677_ = _e1320;
}
let _e1324 = phi_2677_;
let _e1326 = ((_e1324 - _e1288) * _e1215);
let _e1327 = (_e1303 + 1i);
let _e1329 = select(_e1327, 0i, (_e1327 < 0i));
if (_e1329 >= _e1225) {
phi_2691_ = (_e1225 - 1i);
} else {
phi_2691_ = _e1329;
}
let _e1333 = phi_2691_;
let _e1340 = global_3.member.member_13.member_10;
let _e1346 = ((bitcast<i32>(_e1340) + (((_e1303 * _e1220) + _e1288) * _e1215)) + _e1273);
let _e1348 = (bitcast<i32>(_e103) - 1i);
let _e1350 = select(_e1348, _e1346, (_e1346 < _e1348));
let _e1355 = global_1.member[bitcast<u32>(select(0i, _e1350, (_e1350 > 0i)))];
let _e1356 = local_8;
let _e1359 = local_9;
let _e1360 = (_e1346 + _e1359);
let _e1362 = select(_e1348, _e1360, (_e1360 < _e1348));
let _e1367 = global_1.member[bitcast<u32>(select(0i, _e1362, (_e1362 > 0i)))];
let _e1368 = local_8;
let _e1371 = (1f - _e1307);
let _e1373 = (_e1346 + _e1326);
let _e1375 = select(_e1348, _e1373, (_e1373 < _e1348));
let _e1380 = global_1.member[bitcast<u32>(select(0i, _e1375, (_e1375 > 0i)))];
let _e1381 = local_8;
let _e1384 = local_9;
let _e1385 = (_e1373 + _e1384);
let _e1387 = select(_e1348, _e1385, (_e1385 < _e1348));
let _e1392 = global_1.member[bitcast<u32>(select(0i, _e1387, (_e1387 > 0i)))];
let _e1393 = local_8;
let _e1398 = (_e1346 + (((_e1333 - _e1303) * _e1215) * _e1220));
let _e1400 = select(_e1348, _e1398, (_e1398 < _e1348));
let _e1405 = global_1.member[bitcast<u32>(select(0i, _e1400, (_e1400 > 0i)))];
let _e1406 = local_8;
let _e1409 = local_9;
let _e1410 = (_e1398 + _e1409);
let _e1412 = select(_e1348, _e1410, (_e1410 < _e1348));
let _e1417 = global_1.member[bitcast<u32>(select(0i, _e1412, (_e1412 > 0i)))];
let _e1418 = local_8;
let _e1422 = (_e1398 + _e1326);
let _e1424 = select(_e1348, _e1422, (_e1422 < _e1348));
let _e1429 = global_1.member[bitcast<u32>(select(0i, _e1424, (_e1424 > 0i)))];
let _e1430 = local_8;
let _e1433 = local_9;
let _e1434 = (_e1422 + _e1433);
let _e1436 = select(_e1348, _e1434, (_e1434 < _e1348));
let _e1441 = global_1.member[bitcast<u32>(select(0i, _e1436, (_e1436 > 0i)))];
let _e1442 = local_8;
phi_2891_ = ((((((_e1355 * (1f - _e1356)) + (_e1367 * _e1368)) * _e1371) + (((_e1380 * (1f - _e1381)) + (_e1392 * _e1393)) * _e1307)) * (1f - _e1309)) + (((((_e1405 * (1f - _e1406)) + (_e1417 * _e1418)) * _e1371) + (((_e1429 * (1f - _e1430)) + (_e1441 * _e1442)) * _e1307)) * _e1309));
} else {
phi_2891_ = 1f;
}
let _e1452 = phi_2891_;
let _e1456 = global_3.member.member_19.member;
let _e1462 = (((_e735 - _e655.member) / _e1456.member) - 0.5f);
let _e1464 = select(0f, _e1462, (_e1462 > 0f));
let _e1466 = select(15f, _e1464, (_e1464 < 15f));
let _e1469 = (((_e736 - _e655.member_1) / _e1456.member_1) - 0.5f);
let _e1471 = select(0f, _e1469, (_e1469 > 0f));
let _e1473 = select(15f, _e1471, (_e1471 < 15f));
let _e1476 = (((_e737 - _e655.member_2) / _e1456.member_2) - 0.5f);
let _e1478 = select(0f, _e1476, (_e1476 > 0f));
let _e1480 = select(15f, _e1478, (_e1478 < 15f));
let _e1481 = (15f - 1f);
let _e1483 = select(0f, _e1466, (_e1466 > 0f));
let _e1485 = select(_e1481, _e1483, (_e1483 < _e1481));
let _e1492 = select(0i, select(select(i32(_e1485), i32(-2147483648), (_e1485 < -2147483600f)), 2147483647i, (_e1485 > 2147483500f)), (_e1485 == _e1485));
let _e1496 = (_e1492 - select(0i, 1i, (_e1485 < f32(_e1492))));
let _e1498 = select(0f, _e1473, (_e1473 > 0f));
let _e1500 = select(_e1481, _e1498, (_e1498 < _e1481));
let _e1507 = select(0i, select(select(i32(_e1500), i32(-2147483648), (_e1500 < -2147483600f)), 2147483647i, (_e1500 > 2147483500f)), (_e1500 == _e1500));
let _e1511 = (_e1507 - select(0i, 1i, (_e1500 < f32(_e1507))));
let _e1513 = select(0f, _e1480, (_e1480 > 0f));
let _e1515 = select(_e1481, _e1513, (_e1513 < _e1481));
let _e1522 = select(0i, select(select(i32(_e1515), i32(-2147483648), (_e1515 < -2147483600f)), 2147483647i, (_e1515 > 2147483500f)), (_e1515 == _e1515));
let _e1526 = (_e1522 - select(0i, 1i, (_e1515 < f32(_e1522))));
let _e1528 = (_e1466 - f32(_e1496));
let _e1530 = (_e1473 - f32(_e1511));
let _e1532 = (_e1480 - f32(_e1526));
let _e1536 = (((_e1526 * 256i) + (_e1511 * 16i)) + _e1496);
local_7 = _e1536;
let _e1537 = local_7;
let _e1539 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e1541 = select(_e1539, _e1537, (_e1537 < _e1539));
let _e1546 = global_5.member[bitcast<u32>(select(0i, _e1541, (_e1541 > 0i)))];
let _e1547 = local_7;
let _e1548 = (4096i + _e1547);
let _e1550 = select(_e1539, _e1548, (_e1548 < _e1539));
let _e1555 = global_5.member[bitcast<u32>(select(0i, _e1550, (_e1550 > 0i)))];
let _e1556 = local_7;
let _e1557 = (8192i + _e1556);
let _e1559 = select(_e1539, _e1557, (_e1557 < _e1539));
let _e1564 = global_5.member[bitcast<u32>(select(0i, _e1559, (_e1559 > 0i)))];
let _e1565 = (1f - _e1528);
local_6 = (_e1536 + 1i);
let _e1570 = local_6;
let _e1572 = select(_e1539, _e1570, (_e1570 < _e1539));
let _e1577 = global_5.member[bitcast<u32>(select(0i, _e1572, (_e1572 > 0i)))];
let _e1578 = local_6;
let _e1579 = (4096i + _e1578);
let _e1581 = select(_e1539, _e1579, (_e1579 < _e1539));
let _e1586 = global_5.member[bitcast<u32>(select(0i, _e1581, (_e1581 > 0i)))];
let _e1587 = local_6;
let _e1588 = (8192i + _e1587);
let _e1590 = select(_e1539, _e1588, (_e1588 < _e1539));
let _e1595 = global_5.member[bitcast<u32>(select(0i, _e1590, (_e1590 > 0i)))];
let _e1602 = (1f - _e1530);
local_5 = (_e1536 + 16i);
let _e1607 = local_5;
let _e1609 = select(_e1539, _e1607, (_e1607 < _e1539));
let _e1614 = global_5.member[bitcast<u32>(select(0i, _e1609, (_e1609 > 0i)))];
let _e1615 = local_5;
let _e1616 = (4096i + _e1615);
let _e1618 = select(_e1539, _e1616, (_e1616 < _e1539));
let _e1623 = global_5.member[bitcast<u32>(select(0i, _e1618, (_e1618 > 0i)))];
let _e1624 = local_5;
let _e1625 = (8192i + _e1624);
let _e1627 = select(_e1539, _e1625, (_e1625 < _e1539));
let _e1632 = global_5.member[bitcast<u32>(select(0i, _e1627, (_e1627 > 0i)))];
local_4 = (_e1536 + 17i);
let _e1637 = local_4;
let _e1639 = select(_e1539, _e1637, (_e1637 < _e1539));
let _e1644 = global_5.member[bitcast<u32>(select(0i, _e1639, (_e1639 > 0i)))];
let _e1645 = local_4;
let _e1646 = (4096i + _e1645);
let _e1648 = select(_e1539, _e1646, (_e1646 < _e1539));
let _e1653 = global_5.member[bitcast<u32>(select(0i, _e1648, (_e1648 > 0i)))];
let _e1654 = local_4;
let _e1655 = (8192i + _e1654);
let _e1657 = select(_e1539, _e1655, (_e1655 < _e1539));
let _e1662 = global_5.member[bitcast<u32>(select(0i, _e1657, (_e1657 > 0i)))];
local_3 = (_e1536 + 256i);
let _e1676 = local_3;
let _e1678 = select(_e1539, _e1676, (_e1676 < _e1539));
let _e1683 = global_5.member[bitcast<u32>(select(0i, _e1678, (_e1678 > 0i)))];
let _e1684 = local_3;
let _e1685 = (4096i + _e1684);
let _e1687 = select(_e1539, _e1685, (_e1685 < _e1539));
let _e1692 = global_5.member[bitcast<u32>(select(0i, _e1687, (_e1687 > 0i)))];
let _e1693 = local_3;
let _e1694 = (8192i + _e1693);
let _e1696 = select(_e1539, _e1694, (_e1694 < _e1539));
let _e1701 = global_5.member[bitcast<u32>(select(0i, _e1696, (_e1696 > 0i)))];
local_2 = (_e1536 + 257i);
let _e1706 = local_2;
let _e1708 = select(_e1539, _e1706, (_e1706 < _e1539));
let _e1713 = global_5.member[bitcast<u32>(select(0i, _e1708, (_e1708 > 0i)))];
let _e1714 = local_2;
let _e1715 = (4096i + _e1714);
let _e1717 = select(_e1539, _e1715, (_e1715 < _e1539));
let _e1722 = global_5.member[bitcast<u32>(select(0i, _e1717, (_e1717 > 0i)))];
let _e1723 = local_2;
let _e1724 = (8192i + _e1723);
let _e1726 = select(_e1539, _e1724, (_e1724 < _e1539));
let _e1731 = global_5.member[bitcast<u32>(select(0i, _e1726, (_e1726 > 0i)))];
local_1 = (_e1536 + 272i);
let _e1742 = local_1;
let _e1744 = select(_e1539, _e1742, (_e1742 < _e1539));
let _e1749 = global_5.member[bitcast<u32>(select(0i, _e1744, (_e1744 > 0i)))];
let _e1750 = local_1;
let _e1751 = (4096i + _e1750);
let _e1753 = select(_e1539, _e1751, (_e1751 < _e1539));
let _e1758 = global_5.member[bitcast<u32>(select(0i, _e1753, (_e1753 > 0i)))];
let _e1759 = local_1;
let _e1760 = (8192i + _e1759);
let _e1762 = select(_e1539, _e1760, (_e1760 < _e1539));
let _e1767 = global_5.member[bitcast<u32>(select(0i, _e1762, (_e1762 > 0i)))];
local = (_e1536 + 273i);
let _e1772 = local;
let _e1774 = select(_e1539, _e1772, (_e1772 < _e1539));
let _e1779 = global_5.member[bitcast<u32>(select(0i, _e1774, (_e1774 > 0i)))];
let _e1780 = local;
let _e1781 = (4096i + _e1780);
let _e1783 = select(_e1539, _e1781, (_e1781 < _e1539));
let _e1788 = global_5.member[bitcast<u32>(select(0i, _e1783, (_e1783 > 0i)))];
let _e1789 = local;
let _e1790 = (8192i + _e1789);
let _e1792 = select(_e1539, _e1790, (_e1790 < _e1539));
let _e1797 = global_5.member[bitcast<u32>(select(0i, _e1792, (_e1792 > 0i)))];
let _e1810 = (1f - _e1532);
let _e1821 = (_e725 + (0.5f * _e1210));
let _e1825 = global_3.member.member_13.member;
let _e1830 = -((_e1825.member * _e1821));
let _e1832 = select(-87f, _e1830, (_e1830 > -87f));
let _e1834 = select(88f, _e1832, (_e1832 < 88f));
let _e1836 = ((_e1834 * 1.442695f) + 0.5f);
let _e1838 = select(-127f, _e1836, (_e1836 > -127f));
let _e1840 = select(128f, _e1838, (_e1838 < 128f));
let _e1847 = select(0i, select(select(i32(_e1840), i32(-2147483648), (_e1840 < -2147483600f)), 2147483647i, (_e1840 > 2147483500f)), (_e1840 == _e1840));
let _e1851 = (_e1847 - select(0i, 1i, (_e1840 < f32(_e1847))));
let _e1852 = f32(_e1851);
let _e1856 = ((_e1834 - (_e1852 * 0.6933594f)) - (_e1852 * -2.1219444e-4f));
let _e1878 = -((_e1825.member_1 * _e1821));
let _e1880 = select(-87f, _e1878, (_e1878 > -87f));
let _e1882 = select(88f, _e1880, (_e1880 < 88f));
let _e1884 = ((_e1882 * 1.442695f) + 0.5f);
let _e1886 = select(-127f, _e1884, (_e1884 > -127f));
let _e1888 = select(128f, _e1886, (_e1886 < 128f));
let _e1895 = select(0i, select(select(i32(_e1888), i32(-2147483648), (_e1888 < -2147483600f)), 2147483647i, (_e1888 > 2147483500f)), (_e1888 == _e1888));
let _e1899 = (_e1895 - select(0i, 1i, (_e1888 < f32(_e1895))));
let _e1900 = f32(_e1899);
let _e1904 = ((_e1882 - (_e1900 * 0.6933594f)) - (_e1900 * -2.1219444e-4f));
let _e1926 = -((_e1825.member_2 * _e1821));
let _e1928 = select(-87f, _e1926, (_e1926 > -87f));
let _e1930 = select(88f, _e1928, (_e1928 < 88f));
let _e1932 = ((_e1930 * 1.442695f) + 0.5f);
let _e1934 = select(-127f, _e1932, (_e1932 > -127f));
let _e1936 = select(128f, _e1934, (_e1934 < 128f));
let _e1943 = select(0i, select(select(i32(_e1936), i32(-2147483648), (_e1936 < -2147483600f)), 2147483647i, (_e1936 > 2147483500f)), (_e1936 == _e1936));
let _e1947 = (_e1943 - select(0i, 1i, (_e1936 < f32(_e1943))));
let _e1948 = f32(_e1947);
let _e1952 = ((_e1930 - (_e1948 * 0.6933594f)) - (_e1948 * -2.1219444e-4f));
phi_1831_ = vec3<f32>((_e721.x + ((((((((_e1546 * _e1565) + (_e1577 * _e1528)) * _e1602) + (((_e1614 * _e1565) + (_e1644 * _e1528)) * _e1530)) * _e1810) + (((((_e1683 * _e1565) + (_e1713 * _e1528)) * _e1602) + (((_e1749 * _e1565) + (_e1779 * _e1528)) * _e1530)) * _e1532)) * ((1f + (_e1856 * (1f + (_e1856 * (0.5f + (_e1856 * (0.16666667f + (_e1856 * (0.041666668f + (_e1856 * (0.008333334f + (_e1856 * (0.001388889f + (_e1856 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1851 + 127i)) << bitcast<u32>(23i))))) * _e1452)), (_e721.y + ((((((((_e1555 * _e1565) + (_e1586 * _e1528)) * _e1602) + (((_e1623 * _e1565) + (_e1653 * _e1528)) * _e1530)) * _e1810) + (((((_e1692 * _e1565) + (_e1722 * _e1528)) * _e1602) + (((_e1758 * _e1565) + (_e1788 * _e1528)) * _e1530)) * _e1532)) * ((1f + (_e1904 * (1f + (_e1904 * (0.5f + (_e1904 * (0.16666667f + (_e1904 * (0.041666668f + (_e1904 * (0.008333334f + (_e1904 * (0.001388889f + (_e1904 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1899 + 127i)) << bitcast<u32>(23i))))) * _e1452)), (_e721.z + ((((((((_e1564 * _e1565) + (_e1595 * _e1528)) * _e1602) + (((_e1632 * _e1565) + (_e1662 * _e1528)) * _e1530)) * _e1810) + (((((_e1701 * _e1565) + (_e1731 * _e1528)) * _e1602) + (((_e1767 * _e1565) + (_e1797 * _e1528)) * _e1530)) * _e1532)) * ((1f + (_e1952 * (1f + (_e1952 * (0.5f + (_e1952 * (0.16666667f + (_e1952 * (0.041666668f + (_e1952 * (0.008333334f + (_e1952 * (0.001388889f + (_e1952 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1947 + 127i)) << bitcast<u32>(23i))))) * _e1452)));
phi_1834_ = (_e723 + 1i);
phi_1836_ = (_e725 + _e1210);
} else {
phi_1831_ = vec3<f32>();
phi_1834_ = i32();
phi_1836_ = f32();
}
let _e1989 = phi_1831_;
let _e1991 = phi_1834_;
let _e1993 = phi_1836_;
continue;
continuing {
phi_1830_ = _e1989;
phi_1833_ = _e1991;
phi_1835_ = _e1993;
break if !(_e726);
}
}
let _e1998 = global_3.member.member_13.member_1;
let _e2003 = local_16;
let _e2007 = local_17;
let _e2011 = local_18;
phi_3942_ = array<f32, 22>(_e128, _e138, _e149, _e160, _e171, _e182, _e193, _e204, _e215, _e226, _e237, _e248, _e259, _e270, _e281, (_e292 + (((_e2003.x * _e1998.member) * _e625) * _e714)), (_e303 + (((_e2007.y * _e1998.member_1) * _e626) * _e714)), (_e314 + (((_e2011.z * _e1998.member_2) * _e627) * _e714)), _e325, _e336, _e347, _e358);
}
let _e2025 = phi_3942_;
global_2.member[_e117] = _e2025[0];
global_2.member[_e129] = _e2025[1];
global_2.member[_e140] = _e2025[2];
global_2.member[_e151] = _e2025[3];
global_2.member[_e162] = _e2025[4];
global_2.member[_e173] = _e2025[5];
global_2.member[_e184] = _e2025[6];
global_2.member[_e195] = _e2025[7];
global_2.member[_e206] = _e2025[8];
global_2.member[_e217] = _e2025[9];
global_2.member[_e228] = _e2025[10];
global_2.member[_e239] = _e2025[11];
global_2.member[_e250] = _e2025[12];
global_2.member[_e261] = _e2025[13];
global_2.member[_e272] = _e2025[14];
global_2.member[_e283] = _e2025[15];
global_2.member[_e294] = _e2025[16];
global_2.member[_e305] = _e2025[17];
global_2.member[_e316] = _e2025[18];
global_2.member[_e327] = _e2025[19];
global_2.member[_e338] = _e2025[20];
global_2.member[_e349] = _e2025[21];
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
