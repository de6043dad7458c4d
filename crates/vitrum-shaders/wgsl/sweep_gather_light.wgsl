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
struct type_14 {
member: u32,
member_1: u32,
}
struct type_15 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_16 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_17 {
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
struct type_18 {
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
struct type_19 {
member: type_5,
member_1: type_5,
}
struct type_20 {
member: type_7,
member_1: u32,
}
struct type_21 {
member: type_2,
member_1: u32,
member_2: type_15,
member_3: type_14,
member_4: u32,
member_5: type_16,
member_6: type_17,
member_7: type_17,
member_8: type_18,
member_9: type_19,
member_10: f32,
member_11: type_16,
member_12: type_4,
member_13: type_9,
member_14: type_20,
member_15: type_20,
member_16: type_20,
member_17: type_20,
member_18: type_5,
member_19: f32,
member_20: f32,
member_21: type_6,
}
struct type_22 {
member: type_21,
}
struct type_23 {
member: u32,
member_1: u32,
member_2: f32,
member_3: f32,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_22;
@group(0) @binding(3)
var<storage, read_write> global_2: type_11;
@group(0) @binding(1)
var<storage> global_3: type_11;
@group(0) @binding(2)
var<storage> global_4: type_11;
fn function_() {
var local: type_23;
var phi_253_: i32;
var phi_296_: i32;
var phi_489_: i32;
var phi_532_: i32;
var phi_722_: i32;
var phi_765_: i32;
var phi_900_: f32;
var phi_901_: f32;
var phi_960_: i32;
var phi_1003_: i32;
var phi_1196_: i32;
var phi_1239_: i32;
var phi_1432_: i32;
var phi_1475_: i32;
var phi_1665_: i32;
var phi_1708_: i32;
var phi_1898_: i32;
var phi_1941_: i32;
var phi_2131_: i32;
var phi_2174_: i32;
let _e38 = global;
let _e47 = global_1.member.member_2;
let _e50 = global_1.member.member;
let _e58 = (_e38.x + _e47.member);
let _e60 = (_e38.y + _e47.member_1);
if (_e58 < _e47.member_2) {
if (_e60 < _e47.member_3) {
let _e63 = (_e50.member * _e50.member_1);
let _e65 = ((_e60 * _e50.member) + _e58);
let _e70 = global_1.member.member_8.member;
let _e72 = bitcast<i32>((_e60 * _e70));
let _e76 = global_1.member.member_8.member_1;
let _e78 = bitcast<i32>((_e70 * _e76));
let _e79 = bitcast<i32>(_e58);
let _e80 = (_e72 + _e79);
let _e82 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e84 = select(_e82, _e80, (_e80 < _e82));
let _e90 = global_4.member[bitcast<u32>(select(0i, _e84, (_e84 > 0i)))];
let _e92 = ((_e78 + _e72) + _e79);
let _e94 = select(_e82, _e92, (_e92 < _e82));
let _e100 = global_4.member[bitcast<u32>(select(0i, _e94, (_e94 > 0i)))];
let _e101 = -(_e90);
let _e102 = -(_e100);
local.member = _e58;
local.member_1 = _e60;
local.member_2 = _e101;
local.member_3 = _e102;
let _e110 = global_1.member.member_8.member;
let _e111 = bitcast<i32>(_e110);
let _e114 = local.member_1;
let _e116 = (bitcast<i32>(_e114) * _e111);
let _e117 = local.member_2;
let _e118 = -(32768f);
let _e120 = select(_e118, _e117, (_e117 > _e118));
let _e122 = select(32768f, _e120, (_e120 < 32768f));
let _e129 = select(0i, select(select(i32(_e122), i32(-2147483648), (_e122 < -2147483600f)), 2147483647i, (_e122 > 2147483500f)), (_e122 == _e122));
let _e133 = (_e129 - select(0i, 1i, (_e122 < f32(_e129))));
let _e135 = (_e117 - f32(_e133));
let _e136 = (_e133 < 0i);
if _e136 {
phi_253_ = (_e133 + 1i);
} else {
phi_253_ = _e133;
}
let _e139 = phi_253_;
let _e140 = select(1i, -1i, _e136);
let _e142 = select(_e135, (1f - _e135), _e136);
let _e143 = local.member_3;
let _e145 = select(_e118, _e143, (_e143 > _e118));
let _e147 = select(32768f, _e145, (_e145 < 32768f));
let _e154 = select(0i, select(select(i32(_e147), i32(-2147483648), (_e147 < -2147483600f)), 2147483647i, (_e147 > 2147483500f)), (_e147 == _e147));
let _e158 = (_e154 - select(0i, 1i, (_e147 < f32(_e154))));
let _e160 = (_e143 - f32(_e158));
let _e161 = (_e158 < 0i);
if _e161 {
phi_296_ = (_e158 + 1i);
} else {
phi_296_ = _e158;
}
let _e164 = phi_296_;
let _e170 = local.member;
let _e173 = (((_e116 + (_e164 * _e111)) + bitcast<i32>(_e170)) + _e139);
let _e175 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e177 = select(_e175, _e173, (_e173 < _e175));
let _e182 = global_3.member[bitcast<u32>(select(0i, _e177, (_e177 > 0i)))];
let _e183 = (_e173 + _e140);
let _e185 = select(_e175, _e183, (_e183 < _e175));
let _e190 = global_3.member[bitcast<u32>(select(0i, _e185, (_e185 > 0i)))];
let _e193 = (_e182 + ((_e190 - _e182) * _e142));
let _e197 = local.member;
let _e200 = (((_e116 + ((_e164 + select(1i, -1i, _e161)) * _e111)) + bitcast<i32>(_e197)) + _e139);
let _e202 = select(_e175, _e200, (_e200 < _e175));
let _e207 = global_3.member[bitcast<u32>(select(0i, _e202, (_e202 > 0i)))];
let _e208 = (_e200 + _e140);
let _e210 = select(_e175, _e208, (_e208 < _e175));
let _e215 = global_3.member[bitcast<u32>(select(0i, _e210, (_e210 > 0i)))];
let _e219 = local.member;
let _e222 = local.member_2;
let _e223 = (f32(bitcast<i32>(_e219)) + _e222);
let _e224 = local.member_1;
let _e227 = local.member_3;
let _e228 = (f32(bitcast<i32>(_e224)) + _e227);
let _e230 = (f32(_e111) - 1f);
let _e231 = global_1.member.member_8.member_1;
let _e234 = (f32(bitcast<i32>(_e231)) - 1f);
let _e245 = select(1f, (_e193 + (((_e207 + ((_e215 - _e207) * _e142)) - _e193) * select(_e160, (1f - _e160), _e161))), ((((_e223 >= 0f) && (_e223 <= _e230)) && (_e228 >= 0f)) && (_e228 <= _e234)));
if (_e50.member_2 >= 3u) {
phi_900_ = _e245;
phi_901_ = _e245;
} else {
let _e247 = bitcast<i32>((_e110 * _e231));
let _e248 = local.member_1;
let _e251 = (_e247 + (bitcast<i32>(_e248) * _e111));
let _e252 = local.member_2;
let _e254 = select(_e118, _e252, (_e252 > _e118));
let _e256 = select(32768f, _e254, (_e254 < 32768f));
let _e263 = select(0i, select(select(i32(_e256), i32(-2147483648), (_e256 < -2147483600f)), 2147483647i, (_e256 > 2147483500f)), (_e256 == _e256));
let _e267 = (_e263 - select(0i, 1i, (_e256 < f32(_e263))));
let _e269 = (_e252 - f32(_e267));
let _e270 = (_e267 < 0i);
if _e270 {
phi_489_ = (_e267 + 1i);
} else {
phi_489_ = _e267;
}
let _e273 = phi_489_;
let _e274 = select(1i, -1i, _e270);
let _e276 = select(_e269, (1f - _e269), _e270);
let _e277 = local.member_3;
let _e279 = select(_e118, _e277, (_e277 > _e118));
let _e281 = select(32768f, _e279, (_e279 < 32768f));
let _e288 = select(0i, select(select(i32(_e281), i32(-2147483648), (_e281 < -2147483600f)), 2147483647i, (_e281 > 2147483500f)), (_e281 == _e281));
let _e292 = (_e288 - select(0i, 1i, (_e281 < f32(_e288))));
let _e294 = (_e277 - f32(_e292));
let _e295 = (_e292 < 0i);
if _e295 {
phi_532_ = (_e292 + 1i);
} else {
phi_532_ = _e292;
}
let _e298 = phi_532_;
let _e304 = local.member;
let _e307 = (((_e251 + (_e298 * _e111)) + bitcast<i32>(_e304)) + _e273);
let _e309 = select(_e175, _e307, (_e307 < _e175));
let _e314 = global_3.member[bitcast<u32>(select(0i, _e309, (_e309 > 0i)))];
let _e315 = (_e307 + _e274);
let _e317 = select(_e175, _e315, (_e315 < _e175));
let _e322 = global_3.member[bitcast<u32>(select(0i, _e317, (_e317 > 0i)))];
let _e325 = (_e314 + ((_e322 - _e314) * _e276));
let _e329 = local.member;
let _e332 = (((_e251 + ((_e298 + select(1i, -1i, _e295)) * _e111)) + bitcast<i32>(_e329)) + _e273);
let _e334 = select(_e175, _e332, (_e332 < _e175));
let _e339 = global_3.member[bitcast<u32>(select(0i, _e334, (_e334 > 0i)))];
let _e340 = (_e332 + _e274);
let _e342 = select(_e175, _e340, (_e340 < _e175));
let _e347 = global_3.member[bitcast<u32>(select(0i, _e342, (_e342 > 0i)))];
let _e351 = local.member;
let _e354 = local.member_2;
let _e355 = (f32(bitcast<i32>(_e351)) + _e354);
let _e356 = local.member_1;
let _e359 = local.member_3;
let _e360 = (f32(bitcast<i32>(_e356)) + _e359);
let _e373 = local.member_1;
let _e376 = ((2i * _e247) + (bitcast<i32>(_e373) * _e111));
let _e377 = local.member_2;
let _e379 = select(_e118, _e377, (_e377 > _e118));
let _e381 = select(32768f, _e379, (_e379 < 32768f));
let _e388 = select(0i, select(select(i32(_e381), i32(-2147483648), (_e381 < -2147483600f)), 2147483647i, (_e381 > 2147483500f)), (_e381 == _e381));
let _e392 = (_e388 - select(0i, 1i, (_e381 < f32(_e388))));
let _e394 = (_e377 - f32(_e392));
let _e395 = (_e392 < 0i);
if _e395 {
phi_722_ = (_e392 + 1i);
} else {
phi_722_ = _e392;
}
let _e398 = phi_722_;
let _e399 = select(1i, -1i, _e395);
let _e401 = select(_e394, (1f - _e394), _e395);
let _e402 = local.member_3;
let _e404 = select(_e118, _e402, (_e402 > _e118));
let _e406 = select(32768f, _e404, (_e404 < 32768f));
let _e413 = select(0i, select(select(i32(_e406), i32(-2147483648), (_e406 < -2147483600f)), 2147483647i, (_e406 > 2147483500f)), (_e406 == _e406));
let _e417 = (_e413 - select(0i, 1i, (_e406 < f32(_e413))));
let _e419 = (_e402 - f32(_e417));
let _e420 = (_e417 < 0i);
if _e420 {
phi_765_ = (_e417 + 1i);
} else {
phi_765_ = _e417;
}
let _e423 = phi_765_;
let _e429 = local.member;
let _e432 = (((_e376 + (_e423 * _e111)) + bitcast<i32>(_e429)) + _e398);
let _e434 = select(_e175, _e432, (_e432 < _e175));
let _e439 = global_3.member[bitcast<u32>(select(0i, _e434, (_e434 > 0i)))];
let _e440 = (_e432 + _e399);
let _e442 = select(_e175, _e440, (_e440 < _e175));
let _e447 = global_3.member[bitcast<u32>(select(0i, _e442, (_e442 > 0i)))];
let _e450 = (_e439 + ((_e447 - _e439) * _e401));
let _e454 = local.member;
let _e457 = (((_e376 + ((_e423 + select(1i, -1i, _e420)) * _e111)) + bitcast<i32>(_e454)) + _e398);
let _e459 = select(_e175, _e457, (_e457 < _e175));
let _e464 = global_3.member[bitcast<u32>(select(0i, _e459, (_e459 > 0i)))];
let _e465 = (_e457 + _e399);
let _e467 = select(_e175, _e465, (_e465 < _e175));
let _e472 = global_3.member[bitcast<u32>(select(0i, _e467, (_e467 > 0i)))];
let _e476 = local.member;
let _e479 = local.member_2;
let _e480 = (f32(bitcast<i32>(_e476)) + _e479);
let _e481 = local.member_1;
let _e484 = local.member_3;
let _e485 = (f32(bitcast<i32>(_e481)) + _e484);
phi_900_ = select(1f, (_e450 + (((_e464 + ((_e472 - _e464) * _e401)) - _e450) * select(_e419, (1f - _e419), _e420))), ((((_e480 >= 0f) && (_e480 <= _e230)) && (_e485 >= 0f)) && (_e485 <= _e234)));
phi_901_ = select(1f, (_e325 + (((_e339 + ((_e347 - _e339) * _e276)) - _e325) * select(_e294, (1f - _e294), _e295))), ((((_e355 >= 0f) && (_e355 <= _e230)) && (_e360 >= 0f)) && (_e360 <= _e234)));
}
let _e498 = phi_900_;
let _e500 = phi_901_;
let _e505 = global_1.member.member_9.member.member;
let _e507 = bitcast<i32>((_e110 * _e231));
let _e509 = local.member_1;
let _e512 = ((3i * _e507) + (bitcast<i32>(_e509) * _e111));
let _e513 = local.member_2;
let _e515 = select(_e118, _e513, (_e513 > _e118));
let _e517 = select(32768f, _e515, (_e515 < 32768f));
let _e524 = select(0i, select(select(i32(_e517), i32(-2147483648), (_e517 < -2147483600f)), 2147483647i, (_e517 > 2147483500f)), (_e517 == _e517));
let _e528 = (_e524 - select(0i, 1i, (_e517 < f32(_e524))));
let _e530 = (_e513 - f32(_e528));
let _e531 = (_e528 < 0i);
if _e531 {
phi_960_ = (_e528 + 1i);
} else {
phi_960_ = _e528;
}
let _e534 = phi_960_;
let _e535 = select(1i, -1i, _e531);
let _e537 = select(_e530, (1f - _e530), _e531);
let _e538 = local.member_3;
let _e540 = select(_e118, _e538, (_e538 > _e118));
let _e542 = select(32768f, _e540, (_e540 < 32768f));
let _e549 = select(0i, select(select(i32(_e542), i32(-2147483648), (_e542 < -2147483600f)), 2147483647i, (_e542 > 2147483500f)), (_e542 == _e542));
let _e553 = (_e549 - select(0i, 1i, (_e542 < f32(_e549))));
let _e555 = (_e538 - f32(_e553));
let _e556 = (_e553 < 0i);
if _e556 {
phi_1003_ = (_e553 + 1i);
} else {
phi_1003_ = _e553;
}
let _e559 = phi_1003_;
let _e565 = local.member;
let _e568 = (((_e512 + (_e559 * _e111)) + bitcast<i32>(_e565)) + _e534);
let _e570 = select(_e175, _e568, (_e568 < _e175));
let _e575 = global_3.member[bitcast<u32>(select(0i, _e570, (_e570 > 0i)))];
let _e576 = (_e568 + _e535);
let _e578 = select(_e175, _e576, (_e576 < _e175));
let _e583 = global_3.member[bitcast<u32>(select(0i, _e578, (_e578 > 0i)))];
let _e586 = (_e575 + ((_e583 - _e575) * _e537));
let _e590 = local.member;
let _e593 = (((_e512 + ((_e559 + select(1i, -1i, _e556)) * _e111)) + bitcast<i32>(_e590)) + _e534);
let _e595 = select(_e175, _e593, (_e593 < _e175));
let _e600 = global_3.member[bitcast<u32>(select(0i, _e595, (_e595 > 0i)))];
let _e601 = (_e593 + _e535);
let _e603 = select(_e175, _e601, (_e601 < _e175));
let _e608 = global_3.member[bitcast<u32>(select(0i, _e603, (_e603 > 0i)))];
let _e612 = local.member;
let _e615 = local.member_2;
let _e616 = (f32(bitcast<i32>(_e612)) + _e615);
let _e617 = local.member_1;
let _e620 = local.member_3;
let _e621 = (f32(bitcast<i32>(_e617)) + _e620);
let _e637 = global_1.member.member_9.member.member_1;
let _e639 = local.member_1;
let _e642 = ((4i * _e507) + (bitcast<i32>(_e639) * _e111));
let _e643 = local.member_2;
let _e645 = select(_e118, _e643, (_e643 > _e118));
let _e647 = select(32768f, _e645, (_e645 < 32768f));
let _e654 = select(0i, select(select(i32(_e647), i32(-2147483648), (_e647 < -2147483600f)), 2147483647i, (_e647 > 2147483500f)), (_e647 == _e647));
let _e658 = (_e654 - select(0i, 1i, (_e647 < f32(_e654))));
let _e660 = (_e643 - f32(_e658));
let _e661 = (_e658 < 0i);
if _e661 {
phi_1196_ = (_e658 + 1i);
} else {
phi_1196_ = _e658;
}
let _e664 = phi_1196_;
let _e665 = select(1i, -1i, _e661);
let _e667 = select(_e660, (1f - _e660), _e661);
let _e668 = local.member_3;
let _e670 = select(_e118, _e668, (_e668 > _e118));
let _e672 = select(32768f, _e670, (_e670 < 32768f));
let _e679 = select(0i, select(select(i32(_e672), i32(-2147483648), (_e672 < -2147483600f)), 2147483647i, (_e672 > 2147483500f)), (_e672 == _e672));
let _e683 = (_e679 - select(0i, 1i, (_e672 < f32(_e679))));
let _e685 = (_e668 - f32(_e683));
let _e686 = (_e683 < 0i);
if _e686 {
phi_1239_ = (_e683 + 1i);
} else {
phi_1239_ = _e683;
}
let _e689 = phi_1239_;
let _e695 = local.member;
let _e698 = (((_e642 + (_e689 * _e111)) + bitcast<i32>(_e695)) + _e664);
let _e700 = select(_e175, _e698, (_e698 < _e175));
let _e705 = global_3.member[bitcast<u32>(select(0i, _e700, (_e700 > 0i)))];
let _e706 = (_e698 + _e665);
let _e708 = select(_e175, _e706, (_e706 < _e175));
let _e713 = global_3.member[bitcast<u32>(select(0i, _e708, (_e708 > 0i)))];
let _e716 = (_e705 + ((_e713 - _e705) * _e667));
let _e720 = local.member;
let _e723 = (((_e642 + ((_e689 + select(1i, -1i, _e686)) * _e111)) + bitcast<i32>(_e720)) + _e664);
let _e725 = select(_e175, _e723, (_e723 < _e175));
let _e730 = global_3.member[bitcast<u32>(select(0i, _e725, (_e725 > 0i)))];
let _e731 = (_e723 + _e665);
let _e733 = select(_e175, _e731, (_e731 < _e175));
let _e738 = global_3.member[bitcast<u32>(select(0i, _e733, (_e733 > 0i)))];
let _e742 = local.member;
let _e745 = local.member_2;
let _e746 = (f32(bitcast<i32>(_e742)) + _e745);
let _e747 = local.member_1;
let _e750 = local.member_3;
let _e751 = (f32(bitcast<i32>(_e747)) + _e750);
let _e767 = global_1.member.member_9.member.member_2;
let _e769 = local.member_1;
let _e772 = ((5i * _e507) + (bitcast<i32>(_e769) * _e111));
let _e773 = local.member_2;
let _e775 = select(_e118, _e773, (_e773 > _e118));
let _e777 = select(32768f, _e775, (_e775 < 32768f));
let _e784 = select(0i, select(select(i32(_e777), i32(-2147483648), (_e777 < -2147483600f)), 2147483647i, (_e777 > 2147483500f)), (_e777 == _e777));
let _e788 = (_e784 - select(0i, 1i, (_e777 < f32(_e784))));
let _e790 = (_e773 - f32(_e788));
let _e791 = (_e788 < 0i);
if _e791 {
phi_1432_ = (_e788 + 1i);
} else {
phi_1432_ = _e788;
}
let _e794 = phi_1432_;
let _e795 = select(1i, -1i, _e791);
let _e797 = select(_e790, (1f - _e790), _e791);
let _e798 = local.member_3;
let _e800 = select(_e118, _e798, (_e798 > _e118));
let _e802 = select(32768f, _e800, (_e800 < 32768f));
let _e809 = select(0i, select(select(i32(_e802), i32(-2147483648), (_e802 < -2147483600f)), 2147483647i, (_e802 > 2147483500f)), (_e802 == _e802));
let _e813 = (_e809 - select(0i, 1i, (_e802 < f32(_e809))));
let _e815 = (_e798 - f32(_e813));
let _e816 = (_e813 < 0i);
if _e816 {
phi_1475_ = (_e813 + 1i);
} else {
phi_1475_ = _e813;
}
let _e819 = phi_1475_;
let _e825 = local.member;
let _e828 = (((_e772 + (_e819 * _e111)) + bitcast<i32>(_e825)) + _e794);
let _e830 = select(_e175, _e828, (_e828 < _e175));
let _e835 = global_3.member[bitcast<u32>(select(0i, _e830, (_e830 > 0i)))];
let _e836 = (_e828 + _e795);
let _e838 = select(_e175, _e836, (_e836 < _e175));
let _e843 = global_3.member[bitcast<u32>(select(0i, _e838, (_e838 > 0i)))];
let _e846 = (_e835 + ((_e843 - _e835) * _e797));
let _e850 = local.member;
let _e853 = (((_e772 + ((_e819 + select(1i, -1i, _e816)) * _e111)) + bitcast<i32>(_e850)) + _e794);
let _e855 = select(_e175, _e853, (_e853 < _e175));
let _e860 = global_3.member[bitcast<u32>(select(0i, _e855, (_e855 > 0i)))];
let _e861 = (_e853 + _e795);
let _e863 = select(_e175, _e861, (_e861 < _e175));
let _e868 = global_3.member[bitcast<u32>(select(0i, _e863, (_e863 > 0i)))];
let _e872 = local.member;
let _e875 = local.member_2;
let _e876 = (f32(bitcast<i32>(_e872)) + _e875);
let _e877 = local.member_1;
let _e880 = local.member_3;
let _e881 = (f32(bitcast<i32>(_e877)) + _e880);
let _e894 = local.member_1;
let _e897 = ((6i * _e507) + (bitcast<i32>(_e894) * _e111));
let _e898 = local.member_2;
let _e900 = select(_e118, _e898, (_e898 > _e118));
let _e902 = select(32768f, _e900, (_e900 < 32768f));
let _e909 = select(0i, select(select(i32(_e902), i32(-2147483648), (_e902 < -2147483600f)), 2147483647i, (_e902 > 2147483500f)), (_e902 == _e902));
let _e913 = (_e909 - select(0i, 1i, (_e902 < f32(_e909))));
let _e915 = (_e898 - f32(_e913));
let _e916 = (_e913 < 0i);
if _e916 {
phi_1665_ = (_e913 + 1i);
} else {
phi_1665_ = _e913;
}
let _e919 = phi_1665_;
let _e920 = select(1i, -1i, _e916);
let _e922 = select(_e915, (1f - _e915), _e916);
let _e923 = local.member_3;
let _e925 = select(_e118, _e923, (_e923 > _e118));
let _e927 = select(32768f, _e925, (_e925 < 32768f));
let _e934 = select(0i, select(select(i32(_e927), i32(-2147483648), (_e927 < -2147483600f)), 2147483647i, (_e927 > 2147483500f)), (_e927 == _e927));
let _e938 = (_e934 - select(0i, 1i, (_e927 < f32(_e934))));
let _e940 = (_e923 - f32(_e938));
let _e941 = (_e938 < 0i);
if _e941 {
phi_1708_ = (_e938 + 1i);
} else {
phi_1708_ = _e938;
}
let _e944 = phi_1708_;
let _e950 = local.member;
let _e953 = (((_e897 + (_e944 * _e111)) + bitcast<i32>(_e950)) + _e919);
let _e955 = select(_e175, _e953, (_e953 < _e175));
let _e960 = global_3.member[bitcast<u32>(select(0i, _e955, (_e955 > 0i)))];
let _e961 = (_e953 + _e920);
let _e963 = select(_e175, _e961, (_e961 < _e175));
let _e968 = global_3.member[bitcast<u32>(select(0i, _e963, (_e963 > 0i)))];
let _e971 = (_e960 + ((_e968 - _e960) * _e922));
let _e975 = local.member;
let _e978 = (((_e897 + ((_e944 + select(1i, -1i, _e941)) * _e111)) + bitcast<i32>(_e975)) + _e919);
let _e980 = select(_e175, _e978, (_e978 < _e175));
let _e985 = global_3.member[bitcast<u32>(select(0i, _e980, (_e980 > 0i)))];
let _e986 = (_e978 + _e920);
let _e988 = select(_e175, _e986, (_e986 < _e175));
let _e993 = global_3.member[bitcast<u32>(select(0i, _e988, (_e988 > 0i)))];
let _e997 = local.member;
let _e1000 = local.member_2;
let _e1001 = (f32(bitcast<i32>(_e997)) + _e1000);
let _e1002 = local.member_1;
let _e1005 = local.member_3;
let _e1006 = (f32(bitcast<i32>(_e1002)) + _e1005);
let _e1019 = local.member_1;
let _e1022 = ((7i * _e507) + (bitcast<i32>(_e1019) * _e111));
let _e1023 = local.member_2;
let _e1025 = select(_e118, _e1023, (_e1023 > _e118));
let _e1027 = select(32768f, _e1025, (_e1025 < 32768f));
let _e1034 = select(0i, select(select(i32(_e1027), i32(-2147483648), (_e1027 < -2147483600f)), 2147483647i, (_e1027 > 2147483500f)), (_e1027 == _e1027));
let _e1038 = (_e1034 - select(0i, 1i, (_e1027 < f32(_e1034))));
let _e1040 = (_e1023 - f32(_e1038));
let _e1041 = (_e1038 < 0i);
if _e1041 {
phi_1898_ = (_e1038 + 1i);
} else {
phi_1898_ = _e1038;
}
let _e1044 = phi_1898_;
let _e1045 = select(1i, -1i, _e1041);
let _e1047 = select(_e1040, (1f - _e1040), _e1041);
let _e1048 = local.member_3;
let _e1050 = select(_e118, _e1048, (_e1048 > _e118));
let _e1052 = select(32768f, _e1050, (_e1050 < 32768f));
let _e1059 = select(0i, select(select(i32(_e1052), i32(-2147483648), (_e1052 < -2147483600f)), 2147483647i, (_e1052 > 2147483500f)), (_e1052 == _e1052));
let _e1063 = (_e1059 - select(0i, 1i, (_e1052 < f32(_e1059))));
let _e1065 = (_e1048 - f32(_e1063));
let _e1066 = (_e1063 < 0i);
if _e1066 {
phi_1941_ = (_e1063 + 1i);
} else {
phi_1941_ = _e1063;
}
let _e1069 = phi_1941_;
let _e1075 = local.member;
let _e1078 = (((_e1022 + (_e1069 * _e111)) + bitcast<i32>(_e1075)) + _e1044);
let _e1080 = select(_e175, _e1078, (_e1078 < _e175));
let _e1085 = global_3.member[bitcast<u32>(select(0i, _e1080, (_e1080 > 0i)))];
let _e1086 = (_e1078 + _e1045);
let _e1088 = select(_e175, _e1086, (_e1086 < _e175));
let _e1093 = global_3.member[bitcast<u32>(select(0i, _e1088, (_e1088 > 0i)))];
let _e1096 = (_e1085 + ((_e1093 - _e1085) * _e1047));
let _e1100 = local.member;
let _e1103 = (((_e1022 + ((_e1069 + select(1i, -1i, _e1066)) * _e111)) + bitcast<i32>(_e1100)) + _e1044);
let _e1105 = select(_e175, _e1103, (_e1103 < _e175));
let _e1110 = global_3.member[bitcast<u32>(select(0i, _e1105, (_e1105 > 0i)))];
let _e1111 = (_e1103 + _e1045);
let _e1113 = select(_e175, _e1111, (_e1111 < _e175));
let _e1118 = global_3.member[bitcast<u32>(select(0i, _e1113, (_e1113 > 0i)))];
let _e1122 = local.member;
let _e1125 = local.member_2;
let _e1126 = (f32(bitcast<i32>(_e1122)) + _e1125);
let _e1127 = local.member_1;
let _e1130 = local.member_3;
let _e1131 = (f32(bitcast<i32>(_e1127)) + _e1130);
let _e1144 = local.member_1;
let _e1147 = ((8i * _e507) + (bitcast<i32>(_e1144) * _e111));
let _e1148 = local.member_2;
let _e1150 = select(_e118, _e1148, (_e1148 > _e118));
let _e1152 = select(32768f, _e1150, (_e1150 < 32768f));
let _e1159 = select(0i, select(select(i32(_e1152), i32(-2147483648), (_e1152 < -2147483600f)), 2147483647i, (_e1152 > 2147483500f)), (_e1152 == _e1152));
let _e1163 = (_e1159 - select(0i, 1i, (_e1152 < f32(_e1159))));
let _e1165 = (_e1148 - f32(_e1163));
let _e1166 = (_e1163 < 0i);
if _e1166 {
phi_2131_ = (_e1163 + 1i);
} else {
phi_2131_ = _e1163;
}
let _e1169 = phi_2131_;
let _e1170 = select(1i, -1i, _e1166);
let _e1172 = select(_e1165, (1f - _e1165), _e1166);
let _e1173 = local.member_3;
let _e1175 = select(_e118, _e1173, (_e1173 > _e118));
let _e1177 = select(32768f, _e1175, (_e1175 < 32768f));
let _e1184 = select(0i, select(select(i32(_e1177), i32(-2147483648), (_e1177 < -2147483600f)), 2147483647i, (_e1177 > 2147483500f)), (_e1177 == _e1177));
let _e1188 = (_e1184 - select(0i, 1i, (_e1177 < f32(_e1184))));
let _e1190 = (_e1173 - f32(_e1188));
let _e1191 = (_e1188 < 0i);
if _e1191 {
phi_2174_ = (_e1188 + 1i);
} else {
phi_2174_ = _e1188;
}
let _e1194 = phi_2174_;
let _e1200 = local.member;
let _e1203 = (((_e1147 + (_e1194 * _e111)) + bitcast<i32>(_e1200)) + _e1169);
let _e1205 = select(_e175, _e1203, (_e1203 < _e175));
let _e1210 = global_3.member[bitcast<u32>(select(0i, _e1205, (_e1205 > 0i)))];
let _e1211 = (_e1203 + _e1170);
let _e1213 = select(_e175, _e1211, (_e1211 < _e175));
let _e1218 = global_3.member[bitcast<u32>(select(0i, _e1213, (_e1213 > 0i)))];
let _e1221 = (_e1210 + ((_e1218 - _e1210) * _e1172));
let _e1225 = local.member;
let _e1228 = (((_e1147 + ((_e1194 + select(1i, -1i, _e1191)) * _e111)) + bitcast<i32>(_e1225)) + _e1169);
let _e1230 = select(_e175, _e1228, (_e1228 < _e175));
let _e1235 = global_3.member[bitcast<u32>(select(0i, _e1230, (_e1230 > 0i)))];
let _e1236 = (_e1228 + _e1170);
let _e1238 = select(_e175, _e1236, (_e1236 < _e175));
let _e1243 = global_3.member[bitcast<u32>(select(0i, _e1238, (_e1238 > 0i)))];
let _e1247 = local.member;
let _e1250 = local.member_2;
let _e1251 = (f32(bitcast<i32>(_e1247)) + _e1250);
let _e1252 = local.member_1;
let _e1255 = local.member_3;
let _e1256 = (f32(bitcast<i32>(_e1252)) + _e1255);
let _e1267 = select(1f, (_e1221 + (((_e1235 + ((_e1243 - _e1235) * _e1172)) - _e1221) * select(_e1190, (1f - _e1190), _e1191))), ((((_e1251 >= 0f) && (_e1251 <= _e230)) && (_e1256 >= 0f)) && (_e1256 <= _e234)));
let _e1271 = global_1.member.member_9.member;
let _e1278 = global_1.member.member_5.member_2;
let _e1281 = (1f / select(1e-6f, _e1271.member_2, (_e1271.member_2 > 1e-6f)));
let _e1285 = global_1.member.member_8.member_5;
let _e1286 = (_e1278 * _e1285);
let _e1291 = global_1.member.member_8.member_6;
let _e1298 = global_1.member.member_8.member_7;
let _e1305 = bitcast<i32>(_e60);
let _e1306 = bitcast<i32>(_e70);
let _e1307 = (_e1305 * _e1306);
let _e1308 = (_e1307 + _e79);
let _e1310 = select(_e82, _e1308, (_e1308 < _e82));
let _e1316 = global_4.member[bitcast<u32>(select(0i, _e1310, (_e1310 > 0i)))];
let _e1318 = ((_e1307 + _e78) + _e79);
let _e1320 = select(_e82, _e1318, (_e1318 < _e82));
let _e1326 = global_4.member[bitcast<u32>(select(0i, _e1320, (_e1320 > 0i)))];
let _e1327 = (_e1307 + -1i);
let _e1328 = (_e1327 + _e79);
let _e1330 = select(_e82, _e1328, (_e1328 < _e82));
let _e1336 = global_4.member[bitcast<u32>(select(0i, _e1330, (_e1330 > 0i)))];
let _e1338 = ((_e1327 + _e78) + _e79);
let _e1340 = select(_e82, _e1338, (_e1338 < _e82));
let _e1346 = global_4.member[bitcast<u32>(select(0i, _e1340, (_e1340 > 0i)))];
let _e1347 = (_e1307 + 1i);
let _e1348 = (_e1347 + _e79);
let _e1350 = select(_e82, _e1348, (_e1348 < _e82));
let _e1356 = global_4.member[bitcast<u32>(select(0i, _e1350, (_e1350 > 0i)))];
let _e1358 = ((_e1347 + _e78) + _e79);
let _e1360 = select(_e82, _e1358, (_e1358 < _e82));
let _e1366 = global_4.member[bitcast<u32>(select(0i, _e1360, (_e1360 > 0i)))];
let _e1368 = ((_e1305 - 1i) * _e1306);
let _e1369 = (_e1368 + _e79);
let _e1371 = select(_e82, _e1369, (_e1369 < _e82));
let _e1377 = global_4.member[bitcast<u32>(select(0i, _e1371, (_e1371 > 0i)))];
let _e1379 = ((_e1368 + _e78) + _e79);
let _e1381 = select(_e82, _e1379, (_e1379 < _e82));
let _e1387 = global_4.member[bitcast<u32>(select(0i, _e1381, (_e1381 > 0i)))];
let _e1389 = ((_e1305 + 1i) * _e1306);
let _e1390 = (_e1389 + _e79);
let _e1392 = select(_e82, _e1390, (_e1390 < _e82));
let _e1398 = global_4.member[bitcast<u32>(select(0i, _e1392, (_e1392 > 0i)))];
let _e1400 = ((_e1389 + _e78) + _e79);
let _e1402 = select(_e82, _e1400, (_e1400 < _e82));
let _e1408 = global_4.member[bitcast<u32>(select(0i, _e1402, (_e1402 > 0i)))];
let _e1410 = select(0f, -1f, (_e79 > 0i));
let _e1413 = select(0f, -1f, (_e79 < (_e1306 - 1i)));
let _e1416 = select(0f, -1f, (false || (_e1305 > 0i)));
let _e1421 = select(0f, -1f, (false || (_e1305 < (bitcast<i32>(_e76) - 1i))));
let _e1423 = ((_e1316 - _e1336) * _e1410);
let _e1425 = ((_e1356 - _e1316) * _e1413);
let _e1427 = (0.5f * (_e1423 + _e1425));
let _e1431 = bitcast<f32>((bitcast<u32>(_e1423) & 2147483647u));
let _e1434 = bitcast<f32>((bitcast<u32>(_e1425) & 2147483647u));
let _e1437 = (2f * select(_e1434, _e1431, (_e1431 < _e1434)));
let _e1440 = bitcast<f32>((bitcast<u32>(_e1427) & 2147483647u));
let _e1442 = select(_e1437, _e1440, (_e1440 < _e1437));
let _e1450 = (1f + select(_e1427, select(0f, select(_e1442, -(_e1442), (_e1427 < 0f)), ((_e1423 * _e1425) > 0f)), (_e1427 > 0f)));
let _e1452 = ((_e1326 - _e1346) * _e1410);
let _e1454 = ((_e1366 - _e1326) * _e1413);
let _e1456 = (0.5f * (_e1452 + _e1454));
let _e1459 = bitcast<f32>((bitcast<u32>(_e1452) & 2147483647u));
let _e1462 = bitcast<f32>((bitcast<u32>(_e1454) & 2147483647u));
let _e1465 = (2f * select(_e1462, _e1459, (_e1459 < _e1462)));
let _e1468 = bitcast<f32>((bitcast<u32>(_e1456) & 2147483647u));
let _e1470 = select(_e1465, _e1468, (_e1468 < _e1465));
let _e1476 = select(0f, select(_e1470, -(_e1470), (_e1456 < 0f)), ((_e1452 * _e1454) > 0f));
let _e1478 = ((_e1316 - _e1377) * _e1416);
let _e1480 = ((_e1398 - _e1316) * _e1421);
let _e1482 = (0.5f * (_e1478 + _e1480));
let _e1485 = bitcast<f32>((bitcast<u32>(_e1478) & 2147483647u));
let _e1488 = bitcast<f32>((bitcast<u32>(_e1480) & 2147483647u));
let _e1491 = (2f * select(_e1488, _e1485, (_e1485 < _e1488)));
let _e1494 = bitcast<f32>((bitcast<u32>(_e1482) & 2147483647u));
let _e1496 = select(_e1491, _e1494, (_e1494 < _e1491));
let _e1502 = select(0f, select(_e1496, -(_e1496), (_e1482 < 0f)), ((_e1478 * _e1480) > 0f));
let _e1504 = ((_e1326 - _e1387) * _e1416);
let _e1506 = ((_e1408 - _e1326) * _e1421);
let _e1508 = (0.5f * (_e1504 + _e1506));
let _e1512 = bitcast<f32>((bitcast<u32>(_e1504) & 2147483647u));
let _e1515 = bitcast<f32>((bitcast<u32>(_e1506) & 2147483647u));
let _e1518 = (2f * select(_e1515, _e1512, (_e1512 < _e1515)));
let _e1521 = bitcast<f32>((bitcast<u32>(_e1508) & 2147483647u));
let _e1523 = select(_e1518, _e1521, (_e1521 < _e1518));
let _e1531 = (1f + select(_e1508, select(0f, select(_e1523, -(_e1523), (_e1508 < 0f)), ((_e1504 * _e1506) > 0f)), (_e1508 > 0f)));
let _e1534 = global_1.member.member_1;
let _e1539 = ((_e1450 * _e1450) + (_e1476 * _e1476));
let _e1542 = ((_e1502 * _e1502) + (_e1531 * _e1531));
let _e1559 = select(select(bitcast<f32>((bitcast<u32>(((_e1450 * _e1531) - (_e1476 * _e1502))) & 2147483647u)), (sqrt(select(0f, _e1539, (_e1539 > 0f))) * sqrt(select(0f, _e1542, (_e1542 > 0f)))), ((_e1534 & 2u) != 0u)), 1f, ((_e1534 & 4u) != 0u));
let _e1562 = (1e6f / select(1f, _e1267, (_e1267 > 1f)));
let _e1564 = select(_e1562, _e1559, (_e1559 < _e1562));
global_2.member[_e65] = (_e245 * _e1564);
global_2.member[(_e63 + _e65)] = (_e500 * _e1564);
global_2.member[((2u * _e63) + _e65)] = (_e498 * _e1564);
global_2.member[((3u * _e63) + _e65)] = select(_e505, (_e586 + (((_e600 + ((_e608 - _e600) * _e537)) - _e586) * select(_e555, (1f - _e555), _e556))), ((((_e616 >= 0f) && (_e616 <= _e230)) && (_e621 >= 0f)) && (_e621 <= _e234)));
global_2.member[((4u * _e63) + _e65)] = select(_e637, (_e716 + (((_e730 + ((_e738 - _e730) * _e667)) - _e716) * select(_e685, (1f - _e685), _e686))), ((((_e746 >= 0f) && (_e746 <= _e230)) && (_e751 >= 0f)) && (_e751 <= _e234)));
global_2.member[((5u * _e63) + _e65)] = select(_e767, (_e846 + (((_e860 + ((_e868 - _e860) * _e797)) - _e846) * select(_e815, (1f - _e815), _e816))), ((((_e876 >= 0f) && (_e876 <= _e230)) && (_e881 >= 0f)) && (_e881 <= _e234)));
global_2.member[((6u * _e63) + _e65)] = (select(0f, (_e971 + (((_e985 + ((_e993 - _e985) * _e922)) - _e971) * select(_e940, (1f - _e940), _e941))), ((((_e1001 >= 0f) && (_e1001 <= _e230)) && (_e1006 >= 0f)) && (_e1006 <= _e234))) + (_e101 + (((_e1271.member * _e1281) - _e1291) * _e1286)));
global_2.member[((7u * _e63) + _e65)] = (select(0f, (_e1096 + (((_e1110 + ((_e1118 - _e1110) * _e1047)) - _e1096) * select(_e1065, (1f - _e1065), _e1066))), ((((_e1126 >= 0f) && (_e1126 <= _e230)) && (_e1131 >= 0f)) && (_e1131 <= _e234))) + (_e102 + (((_e1271.member_1 * _e1281) - _e1298) * _e1286)));
global_2.member[((8u * _e63) + _e65)] = (_e1267 * _e1564);
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
