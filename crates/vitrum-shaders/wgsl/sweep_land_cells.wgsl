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
struct type_15 {
member: u32,
member_1: u32,
}
struct type_16 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_17 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_18 {
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
struct type_19 {
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
struct type_20 {
member: type_5,
member_1: type_5,
}
struct type_21 {
member: type_15,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
}
struct type_22 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: u32,
member_4: type_15,
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
member_17: type_21,
member_18: type_5,
member_19: f32,
member_20: f32,
member_21: f32,
}
struct type_23 {
member: type_7,
member_1: u32,
}
struct type_24 {
member: type_2,
member_1: u32,
member_2: type_16,
member_3: type_15,
member_4: u32,
member_5: type_17,
member_6: type_18,
member_7: type_18,
member_8: type_19,
member_9: type_20,
member_10: type_22,
member_11: type_17,
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
struct type_27 {
member: vec2<f32>,
member_1: vec3<f32>,
member_2: bool,
}
struct type_30 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(1)
var<storage> global_1: type_11;
@group(0) @binding(0)
var<storage> global_2: type_25;
@group(0) @binding(2)
var<storage, read_write> global_3: type_30;
fn function_() {
var local: i32;
var local_1: i32;
var local_2: i32;
var local_3: i32;
var local_4: i32;
var local_5: i32;
var local_6: i32;
var local_7: i32;
var phi_424_: type_7;
var phi_434_: type_7;
var phi_2754_: type_27;
var phi_2758_: type_27;
var phi_2763_: type_27;
var phi_2767_: type_27;
var phi_2771_: type_27;
var phi_2776_: type_27;
var phi_2781_: type_27;
var phi_2785_: type_27;
var phi_2790_: type_27;
var phi_2794_: type_27;
var phi_2798_: type_27;
var phi_2803_: type_27;
var phi_2808_: type_27;
var phi_2812_: type_27;
var phi_2841_: f32;
var phi_3054_: i32;
var phi_3089_: i32;
var phi_3802_: i32;
var phi_3834_: i32;
var phi_3915_: u32;
var phi_3973_: u32;
var phi_4031_: u32;
var phi_3835_: i32;
var phi_3803_: i32;
var phi_3262_: i32;
var phi_3419_: i32;
var phi_3451_: i32;
var phi_3532_: u32;
var phi_3590_: u32;
var phi_3648_: u32;
var phi_3452_: i32;
var phi_3420_: i32;
var phi_3263_: i32;
var phi_3090_: i32;
var phi_3055_: i32;
var phi_4354_: vec3<f32>;
var phi_4509_: vec3<f32>;
var phi_4664_: vec3<f32>;
var phi_4820_: vec3<f32>;
var phi_4955_: f32;
var phi_5168_: i32;
var phi_5203_: i32;
var phi_5916_: i32;
var phi_5948_: i32;
var phi_6029_: u32;
var phi_6087_: u32;
var phi_6145_: u32;
var phi_5949_: i32;
var phi_5917_: i32;
var phi_5376_: i32;
var phi_5533_: i32;
var phi_5565_: i32;
var phi_5646_: u32;
var phi_5704_: u32;
var phi_5762_: u32;
var phi_5566_: i32;
var phi_5534_: i32;
var phi_5377_: i32;
var phi_5204_: i32;
var phi_5169_: i32;
let _e57 = global;
let _e62 = arrayLength((&global_3.member));
let _e65 = global_2.member.member_2;
let _e71 = (_e57.x + _e65.member);
let _e73 = (_e57.y + _e65.member_1);
if (_e71 < _e65.member_2) {
if (_e73 < _e65.member_3) {
let _e78 = global_2.member.member;
let _e84 = global_2.member.member_10.member_4.member;
let _e85 = (_e84 + 1u);
let _e90 = global_2.member.member_10.member_4.member_1;
let _e93 = bitcast<i32>((_e85 * (_e90 + 1u)));
let _e94 = (_e73 * _e85);
let _e96 = bitcast<i32>((_e94 + _e71));
let _e97 = (10i * _e93);
let _e98 = (_e97 + _e96);
let _e100 = (bitcast<i32>(arrayLength((&global_1.member))) - 1i);
let _e102 = select(_e100, _e98, (_e98 < _e100));
let _e108 = global_1.member[bitcast<u32>(select(0i, _e102, (_e102 > 0i)))];
let _e109 = (11i * _e93);
let _e110 = (_e109 + _e96);
let _e112 = select(_e100, _e110, (_e110 < _e100));
let _e118 = global_1.member[bitcast<u32>(select(0i, _e112, (_e112 > 0i)))];
let _e122 = (_e71 + 1u);
let _e124 = bitcast<i32>((_e94 + _e122));
let _e125 = (_e97 + _e124);
let _e127 = select(_e100, _e125, (_e125 < _e100));
let _e133 = global_1.member[bitcast<u32>(select(0i, _e127, (_e127 > 0i)))];
let _e134 = (_e109 + _e124);
let _e136 = select(_e100, _e134, (_e134 < _e100));
let _e142 = global_1.member[bitcast<u32>(select(0i, _e136, (_e136 > 0i)))];
let _e147 = (_e73 + 1u);
let _e148 = (_e147 * _e85);
let _e150 = bitcast<i32>((_e148 + _e71));
let _e151 = (_e97 + _e150);
let _e153 = select(_e100, _e151, (_e151 < _e100));
let _e159 = global_1.member[bitcast<u32>(select(0i, _e153, (_e153 > 0i)))];
let _e160 = (_e109 + _e150);
let _e162 = select(_e100, _e160, (_e160 < _e100));
let _e168 = global_1.member[bitcast<u32>(select(0i, _e162, (_e162 > 0i)))];
let _e174 = bitcast<i32>((_e148 + _e122));
let _e175 = (_e97 + _e174);
let _e177 = select(_e100, _e175, (_e175 < _e100));
let _e183 = global_1.member[bitcast<u32>(select(0i, _e177, (_e177 > 0i)))];
let _e184 = (_e109 + _e174);
let _e186 = select(_e100, _e184, (_e184 < _e100));
let _e192 = global_1.member[bitcast<u32>(select(0i, _e186, (_e186 > 0i)))];
let _e196 = (((((_e108 == 0f) && (_e118 != 1f)) && ((_e133 == 0f) && (_e142 != 1f))) && ((_e159 == 0f) && (_e168 != 1f))) && ((_e183 == 0f) && (_e192 != 1f)));
let _e200 = global_2.member.member_10.member_21;
let _e201 = (_e200 > 0f);
if (!(_e196) || _e201) {
if (_e78.member_2 == 1u) {
let _e214 = global_2.member.member_13.member_1.member;
phi_424_ = _e214;
} else {
let _e209 = global_2.member.member_13.member.member;
phi_424_ = _e209;
}
let _e216 = phi_424_;
let _e220 = global_2.member.member_10.member_19;
if (_e78.member_2 == 2u) {
phi_434_ = type_7(type_5(0f, 0f, -1f), _e220);
} else {
phi_434_ = _e216;
}
let _e224 = phi_434_;
let _e230 = global_2.member.member_10.member_17.member.member;
let _e231 = bitcast<i32>(_e230);
let _e237 = global_2.member.member_10.member_17.member.member_1;
let _e238 = bitcast<i32>(_e237);
local_6 = _e93;
local_7 = _e96;
let _e239 = local_7;
let _e241 = select(_e100, _e239, (_e239 < _e100));
let _e246 = global_1.member[bitcast<u32>(select(0i, _e241, (_e241 > 0i)))];
let _e247 = local_6;
let _e248 = local_7;
let _e249 = (_e247 + _e248);
let _e251 = select(_e100, _e249, (_e249 < _e100));
let _e256 = global_1.member[bitcast<u32>(select(0i, _e251, (_e251 > 0i)))];
let _e257 = local_6;
let _e259 = local_7;
let _e260 = ((2i * _e257) + _e259);
let _e262 = select(_e100, _e260, (_e260 < _e100));
let _e267 = global_1.member[bitcast<u32>(select(0i, _e262, (_e262 > 0i)))];
let _e268 = local_6;
let _e270 = local_7;
let _e271 = ((3i * _e268) + _e270);
let _e273 = select(_e100, _e271, (_e271 < _e100));
let _e278 = global_1.member[bitcast<u32>(select(0i, _e273, (_e273 > 0i)))];
let _e279 = local_6;
let _e281 = local_7;
let _e282 = ((4i * _e279) + _e281);
let _e284 = select(_e100, _e282, (_e282 < _e100));
let _e289 = global_1.member[bitcast<u32>(select(0i, _e284, (_e284 > 0i)))];
let _e290 = local_6;
let _e292 = local_7;
let _e293 = ((5i * _e290) + _e292);
let _e295 = select(_e100, _e293, (_e293 < _e100));
let _e300 = global_1.member[bitcast<u32>(select(0i, _e295, (_e295 > 0i)))];
let _e301 = local_6;
let _e303 = local_7;
let _e304 = ((6i * _e301) + _e303);
let _e306 = select(_e100, _e304, (_e304 < _e100));
let _e311 = global_1.member[bitcast<u32>(select(0i, _e306, (_e306 > 0i)))];
let _e312 = local_6;
let _e314 = local_7;
let _e315 = ((7i * _e312) + _e314);
let _e317 = select(_e100, _e315, (_e315 < _e100));
let _e322 = global_1.member[bitcast<u32>(select(0i, _e317, (_e317 > 0i)))];
let _e323 = local_6;
let _e325 = local_7;
let _e326 = ((8i * _e323) + _e325);
let _e328 = select(_e100, _e326, (_e326 < _e100));
let _e333 = global_1.member[bitcast<u32>(select(0i, _e328, (_e328 > 0i)))];
let _e335 = local_6;
let _e337 = local_7;
let _e338 = ((10i * _e335) + _e337);
let _e340 = select(_e100, _e338, (_e338 < _e100));
let _e345 = global_1.member[bitcast<u32>(select(0i, _e340, (_e340 > 0i)))];
let _e346 = local_6;
let _e348 = local_7;
let _e349 = ((11i * _e346) + _e348);
let _e351 = select(_e100, _e349, (_e349 < _e100));
let _e356 = global_1.member[bitcast<u32>(select(0i, _e351, (_e351 > 0i)))];
let _e357 = local_6;
let _e359 = local_7;
let _e360 = ((12i * _e357) + _e359);
let _e362 = select(_e100, _e360, (_e360 < _e100));
let _e367 = global_1.member[bitcast<u32>(select(0i, _e362, (_e362 > 0i)))];
local_4 = _e93;
local_5 = _e124;
let _e368 = local_5;
let _e370 = select(_e100, _e368, (_e368 < _e100));
let _e375 = global_1.member[bitcast<u32>(select(0i, _e370, (_e370 > 0i)))];
let _e376 = local_4;
let _e377 = local_5;
let _e378 = (_e376 + _e377);
let _e380 = select(_e100, _e378, (_e378 < _e100));
let _e385 = global_1.member[bitcast<u32>(select(0i, _e380, (_e380 > 0i)))];
let _e386 = local_4;
let _e388 = local_5;
let _e389 = ((2i * _e386) + _e388);
let _e391 = select(_e100, _e389, (_e389 < _e100));
let _e396 = global_1.member[bitcast<u32>(select(0i, _e391, (_e391 > 0i)))];
let _e397 = local_4;
let _e399 = local_5;
let _e400 = ((3i * _e397) + _e399);
let _e402 = select(_e100, _e400, (_e400 < _e100));
let _e407 = global_1.member[bitcast<u32>(select(0i, _e402, (_e402 > 0i)))];
let _e408 = local_4;
let _e410 = local_5;
let _e411 = ((4i * _e408) + _e410);
let _e413 = select(_e100, _e411, (_e411 < _e100));
let _e418 = global_1.member[bitcast<u32>(select(0i, _e413, (_e413 > 0i)))];
let _e419 = local_4;
let _e421 = local_5;
let _e422 = ((5i * _e419) + _e421);
let _e424 = select(_e100, _e422, (_e422 < _e100));
let _e429 = global_1.member[bitcast<u32>(select(0i, _e424, (_e424 > 0i)))];
let _e430 = local_4;
let _e432 = local_5;
let _e433 = ((6i * _e430) + _e432);
let _e435 = select(_e100, _e433, (_e433 < _e100));
let _e440 = global_1.member[bitcast<u32>(select(0i, _e435, (_e435 > 0i)))];
let _e441 = local_4;
let _e443 = local_5;
let _e444 = ((7i * _e441) + _e443);
let _e446 = select(_e100, _e444, (_e444 < _e100));
let _e451 = global_1.member[bitcast<u32>(select(0i, _e446, (_e446 > 0i)))];
let _e452 = local_4;
let _e454 = local_5;
let _e455 = ((8i * _e452) + _e454);
let _e457 = select(_e100, _e455, (_e455 < _e100));
let _e462 = global_1.member[bitcast<u32>(select(0i, _e457, (_e457 > 0i)))];
let _e464 = local_4;
let _e466 = local_5;
let _e467 = ((10i * _e464) + _e466);
let _e469 = select(_e100, _e467, (_e467 < _e100));
let _e474 = global_1.member[bitcast<u32>(select(0i, _e469, (_e469 > 0i)))];
let _e475 = local_4;
let _e477 = local_5;
let _e478 = ((11i * _e475) + _e477);
let _e480 = select(_e100, _e478, (_e478 < _e100));
let _e485 = global_1.member[bitcast<u32>(select(0i, _e480, (_e480 > 0i)))];
let _e486 = local_4;
let _e488 = local_5;
let _e489 = ((12i * _e486) + _e488);
let _e491 = select(_e100, _e489, (_e489 < _e100));
let _e496 = global_1.member[bitcast<u32>(select(0i, _e491, (_e491 > 0i)))];
local_2 = _e93;
local_3 = _e150;
let _e497 = local_3;
let _e499 = select(_e100, _e497, (_e497 < _e100));
let _e504 = global_1.member[bitcast<u32>(select(0i, _e499, (_e499 > 0i)))];
let _e505 = local_2;
let _e506 = local_3;
let _e507 = (_e505 + _e506);
let _e509 = select(_e100, _e507, (_e507 < _e100));
let _e514 = global_1.member[bitcast<u32>(select(0i, _e509, (_e509 > 0i)))];
let _e515 = local_2;
let _e517 = local_3;
let _e518 = ((2i * _e515) + _e517);
let _e520 = select(_e100, _e518, (_e518 < _e100));
let _e525 = global_1.member[bitcast<u32>(select(0i, _e520, (_e520 > 0i)))];
let _e526 = local_2;
let _e528 = local_3;
let _e529 = ((3i * _e526) + _e528);
let _e531 = select(_e100, _e529, (_e529 < _e100));
let _e536 = global_1.member[bitcast<u32>(select(0i, _e531, (_e531 > 0i)))];
let _e537 = local_2;
let _e539 = local_3;
let _e540 = ((4i * _e537) + _e539);
let _e542 = select(_e100, _e540, (_e540 < _e100));
let _e547 = global_1.member[bitcast<u32>(select(0i, _e542, (_e542 > 0i)))];
let _e548 = local_2;
let _e550 = local_3;
let _e551 = ((5i * _e548) + _e550);
let _e553 = select(_e100, _e551, (_e551 < _e100));
let _e558 = global_1.member[bitcast<u32>(select(0i, _e553, (_e553 > 0i)))];
let _e559 = local_2;
let _e561 = local_3;
let _e562 = ((6i * _e559) + _e561);
let _e564 = select(_e100, _e562, (_e562 < _e100));
let _e569 = global_1.member[bitcast<u32>(select(0i, _e564, (_e564 > 0i)))];
let _e570 = local_2;
let _e572 = local_3;
let _e573 = ((7i * _e570) + _e572);
let _e575 = select(_e100, _e573, (_e573 < _e100));
let _e580 = global_1.member[bitcast<u32>(select(0i, _e575, (_e575 > 0i)))];
let _e581 = local_2;
let _e583 = local_3;
let _e584 = ((8i * _e581) + _e583);
let _e586 = select(_e100, _e584, (_e584 < _e100));
let _e591 = global_1.member[bitcast<u32>(select(0i, _e586, (_e586 > 0i)))];
let _e593 = local_2;
let _e595 = local_3;
let _e596 = ((10i * _e593) + _e595);
let _e598 = select(_e100, _e596, (_e596 < _e100));
let _e603 = global_1.member[bitcast<u32>(select(0i, _e598, (_e598 > 0i)))];
let _e604 = local_2;
let _e606 = local_3;
let _e607 = ((11i * _e604) + _e606);
let _e609 = select(_e100, _e607, (_e607 < _e100));
let _e614 = global_1.member[bitcast<u32>(select(0i, _e609, (_e609 > 0i)))];
let _e615 = local_2;
let _e617 = local_3;
let _e618 = ((12i * _e615) + _e617);
let _e620 = select(_e100, _e618, (_e618 < _e100));
let _e625 = global_1.member[bitcast<u32>(select(0i, _e620, (_e620 > 0i)))];
local = _e93;
local_1 = _e174;
let _e626 = local_1;
let _e628 = select(_e100, _e626, (_e626 < _e100));
let _e633 = global_1.member[bitcast<u32>(select(0i, _e628, (_e628 > 0i)))];
let _e634 = local;
let _e635 = local_1;
let _e636 = (_e634 + _e635);
let _e638 = select(_e100, _e636, (_e636 < _e100));
let _e643 = global_1.member[bitcast<u32>(select(0i, _e638, (_e638 > 0i)))];
let _e644 = local;
let _e646 = local_1;
let _e647 = ((2i * _e644) + _e646);
let _e649 = select(_e100, _e647, (_e647 < _e100));
let _e654 = global_1.member[bitcast<u32>(select(0i, _e649, (_e649 > 0i)))];
let _e655 = local;
let _e657 = local_1;
let _e658 = ((3i * _e655) + _e657);
let _e660 = select(_e100, _e658, (_e658 < _e100));
let _e665 = global_1.member[bitcast<u32>(select(0i, _e660, (_e660 > 0i)))];
let _e666 = local;
let _e668 = local_1;
let _e669 = ((4i * _e666) + _e668);
let _e671 = select(_e100, _e669, (_e669 < _e100));
let _e676 = global_1.member[bitcast<u32>(select(0i, _e671, (_e671 > 0i)))];
let _e677 = local;
let _e679 = local_1;
let _e680 = ((5i * _e677) + _e679);
let _e682 = select(_e100, _e680, (_e680 < _e100));
let _e687 = global_1.member[bitcast<u32>(select(0i, _e682, (_e682 > 0i)))];
let _e688 = local;
let _e690 = local_1;
let _e691 = ((6i * _e688) + _e690);
let _e693 = select(_e100, _e691, (_e691 < _e100));
let _e698 = global_1.member[bitcast<u32>(select(0i, _e693, (_e693 > 0i)))];
let _e699 = local;
let _e701 = local_1;
let _e702 = ((7i * _e699) + _e701);
let _e704 = select(_e100, _e702, (_e702 < _e100));
let _e709 = global_1.member[bitcast<u32>(select(0i, _e704, (_e704 > 0i)))];
let _e710 = local;
let _e712 = local_1;
let _e713 = ((8i * _e710) + _e712);
let _e715 = select(_e100, _e713, (_e713 < _e100));
let _e720 = global_1.member[bitcast<u32>(select(0i, _e715, (_e715 > 0i)))];
let _e722 = local;
let _e724 = local_1;
let _e725 = ((10i * _e722) + _e724);
let _e727 = select(_e100, _e725, (_e725 < _e100));
let _e732 = global_1.member[bitcast<u32>(select(0i, _e727, (_e727 > 0i)))];
let _e733 = local;
let _e735 = local_1;
let _e736 = ((11i * _e733) + _e735);
let _e738 = select(_e100, _e736, (_e736 < _e100));
let _e743 = global_1.member[bitcast<u32>(select(0i, _e738, (_e738 > 0i)))];
let _e744 = local;
let _e746 = local_1;
let _e747 = ((12i * _e744) + _e746);
let _e749 = select(_e100, _e747, (_e747 < _e100));
let _e754 = global_1.member[bitcast<u32>(select(0i, _e749, (_e749 > 0i)))];
if _e196 {
} else {
let _e765 = ((((_e224.member.member * _e246) + (_e224.member.member_1 * _e256)) + (_e224.member.member_2 * _e267)) + _e224.member_1);
let _e771 = -((((_e224.member.member * _e278) + (_e224.member.member_1 * _e289)) + (_e224.member.member_2 * _e300)));
let _e773 = (_e771 > 1e-6f);
let _e777 = select(-1f, (_e765 / select(1e-6f, _e771, _e773)), ((_e765 >= 0f) && _e773));
let _e779 = select(0f, _e777, (_e777 > 0f));
let _e785 = (_e267 + (_e300 * _e779));
let _e789 = global_2.member.member_10.member_3;
let _e790 = (_e789 == 0u);
let _e793 = (_e789 != 0u);
let _e794 = select(1f, _e785, _e793);
let _e797 = (1f / select(1e-12f, _e794, (_e794 > 1e-12f)));
let _e802 = global_2.member.member_10.member_5;
let _e807 = global_2.member.member_10.member_8;
let _e808 = ((((_e246 + (_e278 * _e779)) * _e797) - _e802) * _e807);
let _e813 = global_2.member.member_10.member_6;
let _e815 = ((((_e256 + (_e289 * _e779)) * _e797) - _e813) * _e807);
let _e817 = f32(bitcast<i32>(_e84));
let _e819 = select(0f, _e808, (_e808 > 0f));
let _e826 = global_2.member.member_10.member_17.member_1;
let _e829 = ((_e808 - _e817) * _e826);
let _e834 = global_2.member.member_10.member_17.member_2;
let _e836 = select(0f, _e829, (_e829 > 0f));
let _e838 = (_e834 + _e836);
let _e843 = (-(_e808) * _e826);
let _e845 = select(0f, _e843, (_e843 > 0f));
let _e847 = (_e834 + _e845);
let _e856 = f32(bitcast<i32>(_e90));
let _e858 = select(0f, _e815, (_e815 > 0f));
let _e863 = ((_e815 - _e856) * _e826);
let _e865 = select(0f, _e863, (_e863 > 0f));
let _e867 = (_e834 + _e865);
let _e872 = (-(_e815) * _e826);
let _e874 = select(0f, _e872, (_e872 > 0f));
let _e876 = (_e834 + _e874);
let _e888 = (((_e356 == 1f) || (_e777 < 0f)) || !((_e790 || (_e785 > 0f))));
let _e890 = type_27(vec2<f32>((((_e834 + (select(_e817, _e819, (_e819 < _e817)) * _e826)) + (((_e836 * _e834) / select(1e-12f, _e838, (_e838 > 1e-12f))) - ((_e845 * _e834) / select(1e-12f, _e847, (_e847 > 1e-12f))))) - 0.5f), (((_e834 + (select(_e856, _e858, (_e858 < _e856)) * _e826)) + (((_e865 * _e834) / select(1e-12f, _e867, (_e867 > 1e-12f))) - ((_e874 * _e834) / select(1e-12f, _e876, (_e876 > 1e-12f))))) - 0.5f)), vec3<f32>(_e311, _e322, _e333), _e888);
let _e895 = (((_e278 * _e278) + (_e289 * _e289)) + (_e300 * _e300));
let _e902 = ((_e779 * sqrt(select(0f, _e895, (_e895 > 0f)))) * select(0f, 1f, (_e345 != 0f)));
let _e908 = ((((_e224.member.member * _e375) + (_e224.member.member_1 * _e385)) + (_e224.member.member_2 * _e396)) + _e224.member_1);
let _e914 = -((((_e224.member.member * _e407) + (_e224.member.member_1 * _e418)) + (_e224.member.member_2 * _e429)));
let _e916 = (_e914 > 1e-6f);
let _e920 = select(-1f, (_e908 / select(1e-6f, _e914, _e916)), ((_e908 >= 0f) && _e916));
let _e922 = select(0f, _e920, (_e920 > 0f));
let _e928 = (_e396 + (_e429 * _e922));
let _e931 = select(1f, _e928, _e793);
let _e934 = (1f / select(1e-12f, _e931, (_e931 > 1e-12f)));
let _e937 = ((((_e375 + (_e407 * _e922)) * _e934) - _e802) * _e807);
let _e940 = ((((_e385 + (_e418 * _e922)) * _e934) - _e813) * _e807);
let _e942 = select(0f, _e937, (_e937 > 0f));
let _e947 = ((_e937 - _e817) * _e826);
let _e949 = select(0f, _e947, (_e947 > 0f));
let _e951 = (_e834 + _e949);
let _e956 = (-(_e937) * _e826);
let _e958 = select(0f, _e956, (_e956 > 0f));
let _e960 = (_e834 + _e958);
let _e969 = select(0f, _e940, (_e940 > 0f));
let _e974 = ((_e940 - _e856) * _e826);
let _e976 = select(0f, _e974, (_e974 > 0f));
let _e978 = (_e834 + _e976);
let _e983 = (-(_e940) * _e826);
let _e985 = select(0f, _e983, (_e983 > 0f));
let _e987 = (_e834 + _e985);
let _e999 = (((_e485 == 1f) || (_e920 < 0f)) || !((_e790 || (_e928 > 0f))));
let _e1001 = type_27(vec2<f32>((((_e834 + (select(_e817, _e942, (_e942 < _e817)) * _e826)) + (((_e949 * _e834) / select(1e-12f, _e951, (_e951 > 1e-12f))) - ((_e958 * _e834) / select(1e-12f, _e960, (_e960 > 1e-12f))))) - 0.5f), (((_e834 + (select(_e856, _e969, (_e969 < _e856)) * _e826)) + (((_e976 * _e834) / select(1e-12f, _e978, (_e978 > 1e-12f))) - ((_e985 * _e834) / select(1e-12f, _e987, (_e987 > 1e-12f))))) - 0.5f)), vec3<f32>(_e440, _e451, _e462), _e999);
let _e1006 = (((_e407 * _e407) + (_e418 * _e418)) + (_e429 * _e429));
let _e1013 = ((_e922 * sqrt(select(0f, _e1006, (_e1006 > 0f)))) * select(0f, 1f, (_e474 != 0f)));
let _e1019 = ((((_e224.member.member * _e504) + (_e224.member.member_1 * _e514)) + (_e224.member.member_2 * _e525)) + _e224.member_1);
let _e1025 = -((((_e224.member.member * _e536) + (_e224.member.member_1 * _e547)) + (_e224.member.member_2 * _e558)));
let _e1027 = (_e1025 > 1e-6f);
let _e1031 = select(-1f, (_e1019 / select(1e-6f, _e1025, _e1027)), ((_e1019 >= 0f) && _e1027));
let _e1033 = select(0f, _e1031, (_e1031 > 0f));
let _e1039 = (_e525 + (_e558 * _e1033));
let _e1042 = select(1f, _e1039, _e793);
let _e1045 = (1f / select(1e-12f, _e1042, (_e1042 > 1e-12f)));
let _e1048 = ((((_e504 + (_e536 * _e1033)) * _e1045) - _e802) * _e807);
let _e1051 = ((((_e514 + (_e547 * _e1033)) * _e1045) - _e813) * _e807);
let _e1053 = select(0f, _e1048, (_e1048 > 0f));
let _e1058 = ((_e1048 - _e817) * _e826);
let _e1060 = select(0f, _e1058, (_e1058 > 0f));
let _e1062 = (_e834 + _e1060);
let _e1067 = (-(_e1048) * _e826);
let _e1069 = select(0f, _e1067, (_e1067 > 0f));
let _e1071 = (_e834 + _e1069);
let _e1080 = select(0f, _e1051, (_e1051 > 0f));
let _e1085 = ((_e1051 - _e856) * _e826);
let _e1087 = select(0f, _e1085, (_e1085 > 0f));
let _e1089 = (_e834 + _e1087);
let _e1094 = (-(_e1051) * _e826);
let _e1096 = select(0f, _e1094, (_e1094 > 0f));
let _e1098 = (_e834 + _e1096);
let _e1110 = (((_e614 == 1f) || (_e1031 < 0f)) || !((_e790 || (_e1039 > 0f))));
let _e1112 = type_27(vec2<f32>((((_e834 + (select(_e817, _e1053, (_e1053 < _e817)) * _e826)) + (((_e1060 * _e834) / select(1e-12f, _e1062, (_e1062 > 1e-12f))) - ((_e1069 * _e834) / select(1e-12f, _e1071, (_e1071 > 1e-12f))))) - 0.5f), (((_e834 + (select(_e856, _e1080, (_e1080 < _e856)) * _e826)) + (((_e1087 * _e834) / select(1e-12f, _e1089, (_e1089 > 1e-12f))) - ((_e1096 * _e834) / select(1e-12f, _e1098, (_e1098 > 1e-12f))))) - 0.5f)), vec3<f32>(_e569, _e580, _e591), _e1110);
let _e1117 = (((_e536 * _e536) + (_e547 * _e547)) + (_e558 * _e558));
let _e1124 = ((_e1033 * sqrt(select(0f, _e1117, (_e1117 > 0f)))) * select(0f, 1f, (_e603 != 0f)));
let _e1130 = ((((_e224.member.member * _e633) + (_e224.member.member_1 * _e643)) + (_e224.member.member_2 * _e654)) + _e224.member_1);
let _e1136 = -((((_e224.member.member * _e665) + (_e224.member.member_1 * _e676)) + (_e224.member.member_2 * _e687)));
let _e1138 = (_e1136 > 1e-6f);
let _e1142 = select(-1f, (_e1130 / select(1e-6f, _e1136, _e1138)), ((_e1130 >= 0f) && _e1138));
let _e1144 = select(0f, _e1142, (_e1142 > 0f));
let _e1150 = (_e654 + (_e687 * _e1144));
let _e1153 = select(1f, _e1150, _e793);
let _e1156 = (1f / select(1e-12f, _e1153, (_e1153 > 1e-12f)));
let _e1159 = ((((_e633 + (_e665 * _e1144)) * _e1156) - _e802) * _e807);
let _e1162 = ((((_e643 + (_e676 * _e1144)) * _e1156) - _e813) * _e807);
let _e1164 = select(0f, _e1159, (_e1159 > 0f));
let _e1169 = ((_e1159 - _e817) * _e826);
let _e1171 = select(0f, _e1169, (_e1169 > 0f));
let _e1173 = (_e834 + _e1171);
let _e1178 = (-(_e1159) * _e826);
let _e1180 = select(0f, _e1178, (_e1178 > 0f));
let _e1182 = (_e834 + _e1180);
let _e1191 = select(0f, _e1162, (_e1162 > 0f));
let _e1196 = ((_e1162 - _e856) * _e826);
let _e1198 = select(0f, _e1196, (_e1196 > 0f));
let _e1200 = (_e834 + _e1198);
let _e1205 = (-(_e1162) * _e826);
let _e1207 = select(0f, _e1205, (_e1205 > 0f));
let _e1209 = (_e834 + _e1207);
let _e1221 = (((_e743 == 1f) || (_e1142 < 0f)) || !((_e790 || (_e1150 > 0f))));
let _e1223 = type_27(vec2<f32>((((_e834 + (select(_e817, _e1164, (_e1164 < _e817)) * _e826)) + (((_e1171 * _e834) / select(1e-12f, _e1173, (_e1173 > 1e-12f))) - ((_e1180 * _e834) / select(1e-12f, _e1182, (_e1182 > 1e-12f))))) - 0.5f), (((_e834 + (select(_e856, _e1191, (_e1191 < _e856)) * _e826)) + (((_e1198 * _e834) / select(1e-12f, _e1200, (_e1200 > 1e-12f))) - ((_e1207 * _e834) / select(1e-12f, _e1209, (_e1209 > 1e-12f))))) - 0.5f)), vec3<f32>(_e698, _e709, _e720), _e1221);
let _e1228 = (((_e665 * _e665) + (_e676 * _e676)) + (_e687 * _e687));
let _e1235 = ((_e1144 * sqrt(select(0f, _e1228, (_e1228 > 0f)))) * select(0f, 1f, (_e732 != 0f)));
let _e1237 = select(_e1013, _e902, (_e902 > _e1013));
let _e1239 = select(_e1235, _e1124, (_e1124 > _e1235));
let _e1244 = (((_e200 * select(_e1239, _e1237, (_e1237 > _e1239))) * _e807) * _e826);
let _e1255 = (((select(0f, 1f, !(_e888)) + select(0f, 1f, !(_e999))) + select(0f, 1f, !(_e1110))) + select(0f, 1f, !(_e1221)));
if (_e1255 > 0f) {
if _e888 {
phi_2754_ = _e1112;
} else {
phi_2754_ = _e890;
}
let _e1258 = phi_2754_;
if _e999 {
phi_2758_ = _e1223;
} else {
phi_2758_ = _e1001;
}
let _e1260 = phi_2758_;
if _e1258.member_2 {
phi_2763_ = _e1260;
} else {
phi_2763_ = _e1258;
}
let _e1263 = phi_2763_;
if _e999 {
phi_2767_ = _e1263;
} else {
phi_2767_ = _e1001;
}
let _e1265 = phi_2767_;
if _e888 {
phi_2771_ = _e1265;
} else {
phi_2771_ = _e890;
}
let _e1267 = phi_2771_;
if _e1260.member_2 {
phi_2776_ = _e1258;
} else {
phi_2776_ = _e1260;
}
let _e1270 = phi_2776_;
if _e1267.member_2 {
phi_2781_ = _e1270;
} else {
phi_2781_ = _e1267;
}
let _e1273 = phi_2781_;
if _e999 {
phi_2785_ = _e1273;
} else {
phi_2785_ = _e1001;
}
let _e1275 = phi_2785_;
if _e1258.member_2 {
phi_2790_ = _e1260;
} else {
phi_2790_ = _e1258;
}
let _e1277 = phi_2790_;
if _e1221 {
phi_2794_ = _e1277;
} else {
phi_2794_ = _e1223;
}
let _e1279 = phi_2794_;
if _e1110 {
phi_2798_ = _e1279;
} else {
phi_2798_ = _e1112;
}
let _e1281 = phi_2798_;
if _e1260.member_2 {
phi_2803_ = _e1258;
} else {
phi_2803_ = _e1260;
}
let _e1283 = phi_2803_;
if _e1281.member_2 {
phi_2808_ = _e1283;
} else {
phi_2808_ = _e1281;
}
let _e1286 = phi_2808_;
if _e1221 {
phi_2812_ = _e1286;
} else {
phi_2812_ = _e1223;
}
let _e1288 = phi_2812_;
let _e1289 = (1.7320508f * _e1244);
if _e201 {
let _e1292 = (0.5f * select(1f, _e1289, (_e1289 > 1f)));
let _e1294 = select(_e826, _e1292, (_e1292 > _e826));
phi_2841_ = select(8f, _e1294, (_e1294 < 8f));
} else {
phi_2841_ = 1f;
}
let _e1298 = phi_2841_;
let _e1308 = (_e1275.member.x - _e1267.member.x);
let _e1309 = (_e1275.member.y - _e1267.member.y);
let _e1312 = bitcast<f32>((bitcast<u32>(_e1308) & 2147483647u));
let _e1315 = bitcast<f32>((bitcast<u32>(_e1309) & 2147483647u));
let _e1317 = select(_e1315, _e1312, (_e1312 > _e1315));
let _e1326 = (_e1288.member.x - _e1281.member.x);
let _e1327 = (_e1288.member.y - _e1281.member.y);
let _e1330 = bitcast<f32>((bitcast<u32>(_e1326) & 2147483647u));
let _e1333 = bitcast<f32>((bitcast<u32>(_e1327) & 2147483647u));
let _e1335 = select(_e1333, _e1330, (_e1330 > _e1333));
let _e1339 = ((select(_e1335, _e1317, (_e1317 > _e1335)) / _e1298) - 1e-3f);
let _e1340 = (128f - 1f);
let _e1342 = select(0f, _e1339, (_e1339 > 0f));
let _e1344 = select(_e1340, _e1342, (_e1342 < _e1340));
let _e1351 = select(0i, select(select(i32(_e1344), i32(-2147483648), (_e1344 < -2147483600f)), 2147483647i, (_e1344 > 2147483500f)), (_e1344 == _e1344));
let _e1357 = f32((1i + (_e1351 - select(0i, 1i, (_e1344 < f32(_e1351))))));
let _e1358 = (_e1281.member.x - _e1267.member.x);
let _e1359 = (_e1281.member.y - _e1267.member.y);
let _e1362 = bitcast<f32>((bitcast<u32>(_e1358) & 2147483647u));
let _e1365 = bitcast<f32>((bitcast<u32>(_e1359) & 2147483647u));
let _e1367 = select(_e1365, _e1362, (_e1362 > _e1365));
let _e1368 = (_e1288.member.x - _e1275.member.x);
let _e1369 = (_e1288.member.y - _e1275.member.y);
let _e1372 = bitcast<f32>((bitcast<u32>(_e1368) & 2147483647u));
let _e1375 = bitcast<f32>((bitcast<u32>(_e1369) & 2147483647u));
let _e1377 = select(_e1375, _e1372, (_e1372 > _e1375));
let _e1381 = ((select(_e1377, _e1367, (_e1367 > _e1377)) / _e1298) - 1e-3f);
let _e1383 = select(0f, _e1381, (_e1381 > 0f));
let _e1385 = select(_e1340, _e1383, (_e1383 < _e1340));
let _e1392 = select(0i, select(select(i32(_e1385), i32(-2147483648), (_e1385 < -2147483600f)), 2147483647i, (_e1385 > 2147483500f)), (_e1385 == _e1385));
let _e1398 = f32((1i + (_e1392 - select(0i, 1i, (_e1385 < f32(_e1392))))));
let _e1400 = (select(128f, 24f, _e201) / (_e1357 * _e1398));
let _e1402 = select(_e1400, 1f, (1f < _e1400));
let _e1405 = sqrt(select(0f, _e1402, (_e1402 > 0f)));
let _e1406 = (_e1357 * _e1405);
let _e1408 = select(1f, _e1406, (_e1406 > 1f));
let _e1410 = select(128f, _e1408, (_e1408 < 128f));
let _e1417 = select(0i, select(select(i32(_e1410), i32(-2147483648), (_e1410 < -2147483600f)), 2147483647i, (_e1410 > 2147483500f)), (_e1410 == _e1410));
let _e1421 = (_e1417 - select(0i, 1i, (_e1410 < f32(_e1417))));
let _e1422 = (_e1398 * _e1405);
let _e1424 = select(1f, _e1422, (_e1422 > 1f));
let _e1426 = select(128f, _e1424, (_e1424 < 128f));
let _e1433 = select(0i, select(select(i32(_e1426), i32(-2147483648), (_e1426 < -2147483600f)), 2147483647i, (_e1426 > 2147483500f)), (_e1426 == _e1426));
let _e1437 = (_e1433 - select(0i, 1i, (_e1426 < f32(_e1433))));
let _e1439 = (1f / f32(_e1421));
let _e1441 = (1f / f32(_e1437));
let _e1444 = ((_e1439 * _e1441) * (_e1255 * 0.25f));
phi_3054_ = 0i;
loop {
let _e1446 = phi_3054_;
let _e1447 = (_e1446 < _e1437);
if _e1447 {
let _e1450 = ((f32(_e1446) + 0.5f) * _e1441);
phi_3089_ = 0i;
loop {
let _e1458 = phi_3089_;
let _e1459 = (_e1458 < _e1421);
if _e1459 {
let _e1462 = ((f32(_e1458) + 0.5f) * _e1439);
let _e1477 = ((bitcast<f32>((bitcast<u32>((_e1308 + ((_e1326 - _e1308) * _e1450))) & 2147483647u)) * _e1439) + (bitcast<f32>((bitcast<u32>((_e1358 + ((_e1368 - _e1358) * _e1462))) & 2147483647u)) * _e1441));
let _e1486 = ((bitcast<f32>((bitcast<u32>((_e1309 + ((_e1327 - _e1309) * _e1450))) & 2147483647u)) * _e1439) + (bitcast<f32>((bitcast<u32>((_e1359 + ((_e1369 - _e1359) * _e1462))) & 2147483647u)) * _e1441));
let _e1488 = (_e1267.member.x + (_e1308 * _e1462));
let _e1493 = (_e1488 + (((_e1281.member.x + (_e1326 * _e1462)) - _e1488) * _e1450));
let _e1495 = (_e1267.member.y + (_e1309 * _e1462));
let _e1500 = (_e1495 + (((_e1281.member.y + (_e1327 * _e1462)) - _e1495) * _e1450));
let _e1511 = (_e1267.member_1.x + ((_e1275.member_1.x - _e1267.member_1.x) * _e1462));
let _e1518 = ((_e1511 + (((_e1281.member_1.x + ((_e1288.member_1.x - _e1281.member_1.x) * _e1462)) - _e1511) * _e1450)) * _e1444);
let _e1529 = (_e1267.member_1.y + ((_e1275.member_1.y - _e1267.member_1.y) * _e1462));
let _e1536 = ((_e1529 + (((_e1281.member_1.y + ((_e1288.member_1.y - _e1281.member_1.y) * _e1462)) - _e1529) * _e1450)) * _e1444);
let _e1547 = (_e1267.member_1.z + ((_e1275.member_1.z - _e1267.member_1.z) * _e1462));
let _e1554 = ((_e1547 + (((_e1281.member_1.z + ((_e1288.member_1.z - _e1281.member_1.z) * _e1462)) - _e1547) * _e1450)) * _e1444);
if _e201 {
let _e1804 = select(1f, _e1477, (_e1477 > 1f));
let _e1806 = select(8f, _e1804, (_e1804 < 8f));
let _e1808 = select(1f, _e1486, (_e1486 > 1f));
let _e1810 = select(8f, _e1808, (_e1808 < 8f));
let _e1812 = (0.5f * (_e1806 + _e1810));
let _e1816 = (((3f * _e1244) * _e1244) - (_e1812 * _e1812));
let _e1817 = (1f * 1f);
let _e1819 = select(_e1817, _e1816, (_e1816 > _e1817));
let _e1822 = sqrt(select(0f, _e1819, (_e1819 > 0f)));
let _e1824 = (1f / (_e1822 * _e1822));
phi_3262_ = 0i;
loop {
let _e1829 = phi_3262_;
let _e1830 = (_e1829 < 4i);
if _e1830 {
let _e1832 = f32((_e1829 & 1i));
let _e1835 = f32((_e1829 >> bitcast<u32>(1i)));
let _e1840 = ((1f - (2f * _e1832)) * (1f - (2f * _e1835)));
let _e1844 = ((_e1493 + ((_e1832 - 0.5f) * _e1822)) + 0.5f);
let _e1848 = ((_e1500 + ((_e1835 - 0.5f) * _e1822)) + 0.5f);
let _e1849 = (0.5f * _e1806);
let _e1850 = (_e1849 - 0.5f);
let _e1853 = (0.5f * _e1810);
let _e1854 = (_e1853 - 0.5f);
let _e1860 = (select(_e1850, _e1844, (_e1844 > _e1850)) - _e1849);
let _e1861 = (select(_e1854, _e1848, (_e1848 > _e1854)) - _e1853);
let _e1862 = (_e1860 + 0.5f);
let _e1864 = select(0f, _e1862, (_e1862 > 0f));
let _e1866 = select(65536f, _e1864, (_e1864 < 65536f));
let _e1873 = select(0i, select(select(i32(_e1866), i32(-2147483648), (_e1866 < -2147483600f)), 2147483647i, (_e1866 > 2147483500f)), (_e1866 == _e1866));
let _e1878 = (_e1860 + _e1806);
let _e1879 = (_e1878 + 0.5f);
let _e1881 = f32((_e231 - 1i));
let _e1883 = select(-1f, _e1879, (_e1879 > -1f));
let _e1885 = select(_e1881, _e1883, (_e1883 < _e1881));
let _e1892 = select(0i, select(select(i32(_e1885), i32(-2147483648), (_e1885 < -2147483600f)), 2147483647i, (_e1885 > 2147483500f)), (_e1885 == _e1885));
let _e1897 = (_e1861 + _e1810);
let _e1898 = (_e1897 + 0.5f);
let _e1900 = f32((_e238 - 1i));
let _e1902 = select(-1f, _e1898, (_e1898 > -1f));
let _e1904 = select(_e1900, _e1902, (_e1902 < _e1900));
let _e1911 = select(0i, select(select(i32(_e1904), i32(-2147483648), (_e1904 < -2147483600f)), 2147483647i, (_e1904 > 2147483500f)), (_e1904 == _e1904));
let _e1916 = (_e1861 + 0.5f);
let _e1918 = select(0f, _e1916, (_e1916 > 0f));
let _e1920 = select(65536f, _e1918, (_e1918 < 65536f));
let _e1927 = select(0i, select(select(i32(_e1920), i32(-2147483648), (_e1920 < -2147483600f)), 2147483647i, (_e1920 > 2147483500f)), (_e1920 == _e1920));
phi_3419_ = (_e1927 - select(0i, 1i, (_e1920 < f32(_e1927))));
loop {
let _e1933 = phi_3419_;
let _e1934 = (_e1933 <= (_e1911 - select(0i, 1i, (_e1904 < f32(_e1911)))));
if _e1934 {
let _e1935 = f32(_e1933);
let _e1936 = (_e1935 - 0.5f);
let _e1939 = (_e1935 + 0.5f);
let _e1942 = (select(_e1939, _e1897, (_e1897 < _e1939)) - select(_e1936, _e1861, (_e1861 > _e1936)));
phi_3451_ = (_e1873 - select(0i, 1i, (_e1866 < f32(_e1873))));
loop {
let _e1947 = phi_3451_;
let _e1948 = (_e1947 <= (_e1892 - select(0i, 1i, (_e1885 < f32(_e1892)))));
if _e1948 {
let _e1949 = f32(_e1947);
let _e1950 = (_e1949 - 0.5f);
let _e1953 = (_e1949 + 0.5f);
let _e1956 = (select(_e1953, _e1878, (_e1878 < _e1953)) - select(_e1950, _e1860, (_e1860 > _e1950)));
let _e1960 = ((select(0f, _e1956, (_e1956 > 0f)) / _e1806) * (select(0f, _e1942, (_e1942 > 0f)) / _e1810));
if (_e1960 > 0f) {
let _e1964 = (((_e1933 * _e231) + _e1947) * 6i);
let _e1967 = (((((_e1518 * _e1824) * _e1840) * _e1960) * 16777216f) + 0.5f);
let _e1969 = select(-1073741800f, _e1967, (_e1967 > -1073741800f));
let _e1971 = select(1073741800f, _e1969, (_e1969 < 1073741800f));
let _e1978 = select(0i, select(select(i32(_e1971), i32(-2147483648), (_e1971 < -2147483600f)), 2147483647i, (_e1971 > 2147483500f)), (_e1971 == _e1971));
let _e1982 = (_e1978 - select(0i, 1i, (_e1971 < f32(_e1978))));
let _e1983 = bitcast<u32>(_e1982);
let _e1986 = bitcast<u32>((_e1982 >> bitcast<u32>(31i)));
if ((_e1983 | _e1986) == 0u) {
} else {
let _e1989 = bitcast<u32>(_e1964);
if (_e1989 < _e62) {
let _e1993 = atomicAdd((&global_3.member[_e1989]), _e1983);
phi_3532_ = _e1993;
} else {
phi_3532_ = 0u;
}
let _e1995 = phi_3532_;
let _e1999 = (_e1986 + select(0u, 1u, ((_e1995 + _e1983) < _e1983)));
if (_e1999 == 0u) {
} else {
let _e2001 = (_e1989 + 1u);
if (_e2001 < _e62) {
let _e2005 = atomicAdd((&global_3.member[_e2001]), _e1999);
}
}
}
let _e2009 = (((((_e1536 * _e1824) * _e1840) * _e1960) * 16777216f) + 0.5f);
let _e2011 = select(-1073741800f, _e2009, (_e2009 > -1073741800f));
let _e2013 = select(1073741800f, _e2011, (_e2011 < 1073741800f));
let _e2020 = select(0i, select(select(i32(_e2013), i32(-2147483648), (_e2013 < -2147483600f)), 2147483647i, (_e2013 > 2147483500f)), (_e2013 == _e2013));
let _e2024 = (_e2020 - select(0i, 1i, (_e2013 < f32(_e2020))));
let _e2025 = bitcast<u32>(_e2024);
let _e2028 = bitcast<u32>((_e2024 >> bitcast<u32>(31i)));
if ((_e2025 | _e2028) == 0u) {
} else {
let _e2031 = bitcast<u32>((_e1964 + 2i));
if (_e2031 < _e62) {
let _e2035 = atomicAdd((&global_3.member[_e2031]), _e2025);
phi_3590_ = _e2035;
} else {
phi_3590_ = 0u;
}
let _e2037 = phi_3590_;
let _e2041 = (_e2028 + select(0u, 1u, ((_e2037 + _e2025) < _e2025)));
if (_e2041 == 0u) {
} else {
let _e2043 = (_e2031 + 1u);
if (_e2043 < _e62) {
let _e2047 = atomicAdd((&global_3.member[_e2043]), _e2041);
}
}
}
let _e2051 = (((((_e1554 * _e1824) * _e1840) * _e1960) * 16777216f) + 0.5f);
let _e2053 = select(-1073741800f, _e2051, (_e2051 > -1073741800f));
let _e2055 = select(1073741800f, _e2053, (_e2053 < 1073741800f));
let _e2062 = select(0i, select(select(i32(_e2055), i32(-2147483648), (_e2055 < -2147483600f)), 2147483647i, (_e2055 > 2147483500f)), (_e2055 == _e2055));
let _e2066 = (_e2062 - select(0i, 1i, (_e2055 < f32(_e2062))));
let _e2067 = bitcast<u32>(_e2066);
let _e2070 = bitcast<u32>((_e2066 >> bitcast<u32>(31i)));
if ((_e2067 | _e2070) == 0u) {
} else {
let _e2073 = bitcast<u32>((_e1964 + 4i));
if (_e2073 < _e62) {
let _e2077 = atomicAdd((&global_3.member[_e2073]), _e2067);
phi_3648_ = _e2077;
} else {
phi_3648_ = 0u;
}
let _e2079 = phi_3648_;
let _e2083 = (_e2070 + select(0u, 1u, ((_e2079 + _e2067) < _e2067)));
if (_e2083 == 0u) {
} else {
let _e2085 = (_e2073 + 1u);
if (_e2085 < _e62) {
let _e2089 = atomicAdd((&global_3.member[_e2085]), _e2083);
}
}
}
}
phi_3452_ = (_e1947 + 1i);
} else {
phi_3452_ = i32();
}
let _e2092 = phi_3452_;
continue;
continuing {
phi_3451_ = _e2092;
break if !(_e1948);
}
}
phi_3420_ = (_e1933 + 1i);
} else {
phi_3420_ = i32();
}
let _e2096 = phi_3420_;
continue;
continuing {
phi_3419_ = _e2096;
break if !(_e1934);
}
}
phi_3263_ = (_e1829 + 1i);
} else {
phi_3263_ = i32();
}
let _e2100 = phi_3263_;
continue;
continuing {
phi_3262_ = _e2100;
break if !(_e1830);
}
}
} else {
let _e1556 = select(9.765625e-4f, _e1477, (_e1477 > 9.765625e-4f));
let _e1558 = select(5f, _e1556, (_e1556 < 5f));
let _e1560 = select(9.765625e-4f, _e1486, (_e1486 > 9.765625e-4f));
let _e1562 = select(5f, _e1560, (_e1560 < 5f));
let _e1564 = (_e1493 - (0.5f * _e1558));
let _e1566 = (_e1500 - (0.5f * _e1562));
let _e1567 = (_e1564 + 0.5f);
let _e1569 = select(0f, _e1567, (_e1567 > 0f));
let _e1571 = select(65536f, _e1569, (_e1569 < 65536f));
let _e1578 = select(0i, select(select(i32(_e1571), i32(-2147483648), (_e1571 < -2147483600f)), 2147483647i, (_e1571 > 2147483500f)), (_e1571 == _e1571));
let _e1583 = (_e1564 + _e1558);
let _e1584 = (_e1583 + 0.5f);
let _e1586 = f32((_e231 - 1i));
let _e1588 = select(-1f, _e1584, (_e1584 > -1f));
let _e1590 = select(_e1586, _e1588, (_e1588 < _e1586));
let _e1597 = select(0i, select(select(i32(_e1590), i32(-2147483648), (_e1590 < -2147483600f)), 2147483647i, (_e1590 > 2147483500f)), (_e1590 == _e1590));
let _e1602 = (_e1566 + _e1562);
let _e1603 = (_e1602 + 0.5f);
let _e1605 = f32((_e238 - 1i));
let _e1607 = select(-1f, _e1603, (_e1603 > -1f));
let _e1609 = select(_e1605, _e1607, (_e1607 < _e1605));
let _e1616 = select(0i, select(select(i32(_e1609), i32(-2147483648), (_e1609 < -2147483600f)), 2147483647i, (_e1609 > 2147483500f)), (_e1609 == _e1609));
let _e1621 = (_e1566 + 0.5f);
let _e1623 = select(0f, _e1621, (_e1621 > 0f));
let _e1625 = select(65536f, _e1623, (_e1623 < 65536f));
let _e1632 = select(0i, select(select(i32(_e1625), i32(-2147483648), (_e1625 < -2147483600f)), 2147483647i, (_e1625 > 2147483500f)), (_e1625 == _e1625));
phi_3802_ = (_e1632 - select(0i, 1i, (_e1625 < f32(_e1632))));
loop {
let _e1638 = phi_3802_;
let _e1639 = (_e1638 <= (_e1616 - select(0i, 1i, (_e1609 < f32(_e1616)))));
if _e1639 {
let _e1640 = f32(_e1638);
let _e1641 = (_e1640 - 0.5f);
let _e1644 = (_e1640 + 0.5f);
let _e1647 = (select(_e1644, _e1602, (_e1602 < _e1644)) - select(_e1641, _e1566, (_e1566 > _e1641)));
phi_3834_ = (_e1578 - select(0i, 1i, (_e1571 < f32(_e1578))));
loop {
let _e1652 = phi_3834_;
let _e1653 = (_e1652 <= (_e1597 - select(0i, 1i, (_e1590 < f32(_e1597)))));
if _e1653 {
let _e1654 = f32(_e1652);
let _e1655 = (_e1654 - 0.5f);
let _e1658 = (_e1654 + 0.5f);
let _e1661 = (select(_e1658, _e1583, (_e1583 < _e1658)) - select(_e1655, _e1564, (_e1564 > _e1655)));
let _e1665 = ((select(0f, _e1661, (_e1661 > 0f)) / _e1558) * (select(0f, _e1647, (_e1647 > 0f)) / _e1562));
if (_e1665 > 0f) {
let _e1669 = (((_e1638 * _e231) + _e1652) * 6i);
let _e1672 = (((_e1518 * _e1665) * 16777216f) + 0.5f);
let _e1674 = select(-1073741800f, _e1672, (_e1672 > -1073741800f));
let _e1676 = select(1073741800f, _e1674, (_e1674 < 1073741800f));
let _e1683 = select(0i, select(select(i32(_e1676), i32(-2147483648), (_e1676 < -2147483600f)), 2147483647i, (_e1676 > 2147483500f)), (_e1676 == _e1676));
let _e1687 = (_e1683 - select(0i, 1i, (_e1676 < f32(_e1683))));
let _e1688 = bitcast<u32>(_e1687);
let _e1691 = bitcast<u32>((_e1687 >> bitcast<u32>(31i)));
if ((_e1688 | _e1691) == 0u) {
} else {
let _e1694 = bitcast<u32>(_e1669);
if (_e1694 < _e62) {
let _e1698 = atomicAdd((&global_3.member[_e1694]), _e1688);
phi_3915_ = _e1698;
} else {
phi_3915_ = 0u;
}
let _e1700 = phi_3915_;
let _e1704 = (_e1691 + select(0u, 1u, ((_e1700 + _e1688) < _e1688)));
if (_e1704 == 0u) {
} else {
let _e1706 = (_e1694 + 1u);
if (_e1706 < _e62) {
let _e1710 = atomicAdd((&global_3.member[_e1706]), _e1704);
}
}
}
let _e1714 = (((_e1536 * _e1665) * 16777216f) + 0.5f);
let _e1716 = select(-1073741800f, _e1714, (_e1714 > -1073741800f));
let _e1718 = select(1073741800f, _e1716, (_e1716 < 1073741800f));
let _e1725 = select(0i, select(select(i32(_e1718), i32(-2147483648), (_e1718 < -2147483600f)), 2147483647i, (_e1718 > 2147483500f)), (_e1718 == _e1718));
let _e1729 = (_e1725 - select(0i, 1i, (_e1718 < f32(_e1725))));
let _e1730 = bitcast<u32>(_e1729);
let _e1733 = bitcast<u32>((_e1729 >> bitcast<u32>(31i)));
if ((_e1730 | _e1733) == 0u) {
} else {
let _e1736 = bitcast<u32>((_e1669 + 2i));
if (_e1736 < _e62) {
let _e1740 = atomicAdd((&global_3.member[_e1736]), _e1730);
phi_3973_ = _e1740;
} else {
phi_3973_ = 0u;
}
let _e1742 = phi_3973_;
let _e1746 = (_e1733 + select(0u, 1u, ((_e1742 + _e1730) < _e1730)));
if (_e1746 == 0u) {
} else {
let _e1748 = (_e1736 + 1u);
if (_e1748 < _e62) {
let _e1752 = atomicAdd((&global_3.member[_e1748]), _e1746);
}
}
}
let _e1756 = (((_e1554 * _e1665) * 16777216f) + 0.5f);
let _e1758 = select(-1073741800f, _e1756, (_e1756 > -1073741800f));
let _e1760 = select(1073741800f, _e1758, (_e1758 < 1073741800f));
let _e1767 = select(0i, select(select(i32(_e1760), i32(-2147483648), (_e1760 < -2147483600f)), 2147483647i, (_e1760 > 2147483500f)), (_e1760 == _e1760));
let _e1771 = (_e1767 - select(0i, 1i, (_e1760 < f32(_e1767))));
let _e1772 = bitcast<u32>(_e1771);
let _e1775 = bitcast<u32>((_e1771 >> bitcast<u32>(31i)));
if ((_e1772 | _e1775) == 0u) {
} else {
let _e1778 = bitcast<u32>((_e1669 + 4i));
if (_e1778 < _e62) {
let _e1782 = atomicAdd((&global_3.member[_e1778]), _e1772);
phi_4031_ = _e1782;
} else {
phi_4031_ = 0u;
}
let _e1784 = phi_4031_;
let _e1788 = (_e1775 + select(0u, 1u, ((_e1784 + _e1772) < _e1772)));
if (_e1788 == 0u) {
} else {
let _e1790 = (_e1778 + 1u);
if (_e1790 < _e62) {
let _e1794 = atomicAdd((&global_3.member[_e1790]), _e1788);
}
}
}
}
phi_3835_ = (_e1652 + 1i);
} else {
phi_3835_ = i32();
}
let _e1797 = phi_3835_;
continue;
continuing {
phi_3834_ = _e1797;
break if !(_e1653);
}
}
phi_3803_ = (_e1638 + 1i);
} else {
phi_3803_ = i32();
}
let _e1801 = phi_3803_;
continue;
continuing {
phi_3802_ = _e1801;
break if !(_e1639);
}
}
}
phi_3090_ = (_e1458 + 1i);
} else {
phi_3090_ = i32();
}
let _e2104 = phi_3090_;
continue;
continuing {
phi_3089_ = _e2104;
break if !(_e1459);
}
}
phi_3055_ = (_e1446 + 1i);
} else {
phi_3055_ = i32();
}
let _e2108 = phi_3055_;
continue;
continuing {
phi_3054_ = _e2108;
break if !(_e1447);
}
}
}
}
let _e2112 = (1f / 3f);
let _e2137 = (((1f - select((((_e311 + _e322) + _e333) * _e2112), 0f, (_e345 != 0f))) + (1f - select((((_e440 + _e451) + _e462) * _e2112), 0f, (_e474 != 0f)))) + ((1f - select((((_e569 + _e580) + _e591) * _e2112), 0f, (_e603 != 0f))) + (1f - select((((_e698 + _e709) + _e720) * _e2112), 0f, (_e732 != 0f)))));
if (_e201 && (_e2137 > 0f)) {
let _e2143 = (((_e367 + _e496) + (_e625 + _e754)) / _e2137);
let _e2145 = f32(bitcast<i32>(_e71));
let _e2148 = f32(bitcast<i32>(_e73));
let _e2153 = global_2.member.member_10.member_3;
let _e2154 = (_e2153 != 0u);
let _e2155 = select(1f, _e2143, _e2154);
let _e2159 = global_2.member.member_10.member_5;
let _e2163 = global_2.member.member_10.member_7;
let _e2166 = ((_e2159 + ((_e2145 + 0.5f) * _e2163)) * _e2155);
let _e2170 = global_2.member.member_10.member_6;
let _e2173 = ((_e2170 + ((_e2148 + 0.5f) * _e2163)) * _e2155);
let _e2178 = (((_e2166 * _e2166) + (_e2173 * _e2173)) + (_e2143 * _e2143));
let _e2181 = sqrt(select(0f, _e2178, (_e2178 > 0f)));
let _e2184 = (1f / select(1e-20f, _e2181, (_e2181 > 1e-20f)));
let _e2201 = ((((_e224.member.member * _e2166) + (_e224.member.member_1 * _e2173)) + (_e224.member.member_2 * _e2143)) + _e224.member_1);
let _e2207 = -((((_e224.member.member * select(0f, (_e2166 * _e2184), _e2154)) + (_e224.member.member_1 * select(0f, (_e2173 * _e2184), _e2154))) + (_e224.member.member_2 * select(1f, (_e2143 * _e2184), _e2154))));
let _e2209 = (_e2207 > 1e-6f);
let _e2213 = select(-1f, (_e2201 / select(1e-6f, _e2207, _e2209)), ((_e2201 >= 0f) && _e2209));
if (_e2213 >= 0f) {
let _e2216 = f32(bitcast<i32>(_e84));
let _e2218 = select(0f, _e2145, (_e2145 > 0f));
let _e2225 = global_2.member.member_10.member_17.member_1;
let _e2228 = ((_e2145 - _e2216) * _e2225);
let _e2233 = global_2.member.member_10.member_17.member_2;
let _e2235 = select(0f, _e2228, (_e2228 > 0f));
let _e2237 = (_e2233 + _e2235);
let _e2242 = (-(_e2145) * _e2225);
let _e2244 = select(0f, _e2242, (_e2242 > 0f));
let _e2246 = (_e2233 + _e2244);
let _e2253 = (((_e2233 + (select(_e2216, _e2218, (_e2218 < _e2216)) * _e2225)) + (((_e2235 * _e2233) / select(1e-12f, _e2237, (_e2237 > 1e-12f))) - ((_e2244 * _e2233) / select(1e-12f, _e2246, (_e2246 > 1e-12f))))) - 0.5f);
let _e2255 = f32(bitcast<i32>(_e90));
let _e2257 = select(0f, _e2148, (_e2148 > 0f));
let _e2262 = ((_e2148 - _e2255) * _e2225);
let _e2264 = select(0f, _e2262, (_e2262 > 0f));
let _e2266 = (_e2233 + _e2264);
let _e2271 = (-(_e2148) * _e2225);
let _e2273 = select(0f, _e2271, (_e2271 > 0f));
let _e2275 = (_e2233 + _e2273);
let _e2282 = (((_e2233 + (select(_e2255, _e2257, (_e2257 < _e2255)) * _e2225)) + (((_e2264 * _e2233) / select(1e-12f, _e2266, (_e2266 > 1e-12f))) - ((_e2273 * _e2233) / select(1e-12f, _e2275, (_e2275 > 1e-12f))))) - 0.5f);
if _e196 {
phi_4354_ = vec3<f32>((_e311 + -1f), (_e322 + -1f), (_e333 + -1f));
} else {
phi_4354_ = vec3<f32>(-1f, -1f, -1f);
}
let _e2288 = phi_4354_;
let _e2290 = f32(bitcast<i32>(_e122));
let _e2292 = select(0f, _e2290, (_e2290 > 0f));
let _e2297 = ((_e2290 - _e2216) * _e2225);
let _e2299 = select(0f, _e2297, (_e2297 > 0f));
let _e2301 = (_e2233 + _e2299);
let _e2306 = (-(_e2290) * _e2225);
let _e2308 = select(0f, _e2306, (_e2306 > 0f));
let _e2310 = (_e2233 + _e2308);
let _e2317 = (((_e2233 + (select(_e2216, _e2292, (_e2292 < _e2216)) * _e2225)) + (((_e2299 * _e2233) / select(1e-12f, _e2301, (_e2301 > 1e-12f))) - ((_e2308 * _e2233) / select(1e-12f, _e2310, (_e2310 > 1e-12f))))) - 0.5f);
if _e196 {
phi_4509_ = vec3<f32>((_e440 + -1f), (_e451 + -1f), (_e462 + -1f));
} else {
phi_4509_ = vec3<f32>(-1f, -1f, -1f);
}
let _e2323 = phi_4509_;
let _e2325 = f32(bitcast<i32>(_e147));
let _e2327 = select(0f, _e2325, (_e2325 > 0f));
let _e2332 = ((_e2325 - _e2255) * _e2225);
let _e2334 = select(0f, _e2332, (_e2332 > 0f));
let _e2336 = (_e2233 + _e2334);
let _e2341 = (-(_e2325) * _e2225);
let _e2343 = select(0f, _e2341, (_e2341 > 0f));
let _e2345 = (_e2233 + _e2343);
let _e2352 = (((_e2233 + (select(_e2255, _e2327, (_e2327 < _e2255)) * _e2225)) + (((_e2334 * _e2233) / select(1e-12f, _e2336, (_e2336 > 1e-12f))) - ((_e2343 * _e2233) / select(1e-12f, _e2345, (_e2345 > 1e-12f))))) - 0.5f);
if _e196 {
phi_4664_ = vec3<f32>((_e569 + -1f), (_e580 + -1f), (_e591 + -1f));
} else {
phi_4664_ = vec3<f32>(-1f, -1f, -1f);
}
let _e2358 = phi_4664_;
if _e196 {
phi_4820_ = vec3<f32>((_e698 + -1f), (_e709 + -1f), (_e720 + -1f));
} else {
phi_4820_ = vec3<f32>(-1f, -1f, -1f);
}
let _e2364 = phi_4820_;
let _e2369 = global_2.member.member_10.member_8;
let _e2371 = (((_e200 * _e2213) * _e2369) * _e2225);
let _e2374 = (((1f + 1f) + 1f) + 1f);
if (_e2374 > 0f) {
let _e2376 = (1.7320508f * _e2371);
if _e201 {
let _e2379 = (0.5f * select(1f, _e2376, (_e2376 > 1f)));
let _e2381 = select(_e2225, _e2379, (_e2379 > _e2225));
phi_4955_ = select(8f, _e2381, (_e2381 < 8f));
} else {
phi_4955_ = 1f;
}
let _e2385 = phi_4955_;
let _e2387 = (_e2317 - _e2253);
let _e2388 = (_e2282 - _e2282);
let _e2391 = bitcast<f32>((bitcast<u32>(_e2387) & 2147483647u));
let _e2394 = bitcast<f32>((bitcast<u32>(_e2388) & 2147483647u));
let _e2396 = select(_e2394, _e2391, (_e2391 > _e2394));
let _e2397 = (_e2352 - _e2352);
let _e2400 = bitcast<f32>((bitcast<u32>(_e2397) & 2147483647u));
let _e2402 = select(_e2400, _e2391, (_e2391 > _e2400));
let _e2406 = ((select(_e2402, _e2396, (_e2396 > _e2402)) / _e2385) - 1e-3f);
let _e2407 = (128f - 1f);
let _e2409 = select(0f, _e2406, (_e2406 > 0f));
let _e2411 = select(_e2407, _e2409, (_e2409 < _e2407));
let _e2418 = select(0i, select(select(i32(_e2411), i32(-2147483648), (_e2411 < -2147483600f)), 2147483647i, (_e2411 > 2147483500f)), (_e2411 == _e2411));
let _e2424 = f32((1i + (_e2418 - select(0i, 1i, (_e2411 < f32(_e2418))))));
let _e2425 = (_e2253 - _e2253);
let _e2426 = (_e2352 - _e2282);
let _e2429 = bitcast<f32>((bitcast<u32>(_e2425) & 2147483647u));
let _e2432 = bitcast<f32>((bitcast<u32>(_e2426) & 2147483647u));
let _e2434 = select(_e2432, _e2429, (_e2429 > _e2432));
let _e2435 = (_e2317 - _e2317);
let _e2438 = bitcast<f32>((bitcast<u32>(_e2435) & 2147483647u));
let _e2440 = select(_e2432, _e2438, (_e2438 > _e2432));
let _e2444 = ((select(_e2440, _e2434, (_e2434 > _e2440)) / _e2385) - 1e-3f);
let _e2446 = select(0f, _e2444, (_e2444 > 0f));
let _e2448 = select(_e2407, _e2446, (_e2446 < _e2407));
let _e2455 = select(0i, select(select(i32(_e2448), i32(-2147483648), (_e2448 < -2147483600f)), 2147483647i, (_e2448 > 2147483500f)), (_e2448 == _e2448));
let _e2461 = f32((1i + (_e2455 - select(0i, 1i, (_e2448 < f32(_e2455))))));
let _e2463 = (select(128f, 24f, _e201) / (_e2424 * _e2461));
let _e2465 = select(_e2463, 1f, (1f < _e2463));
let _e2468 = sqrt(select(0f, _e2465, (_e2465 > 0f)));
let _e2469 = (_e2424 * _e2468);
let _e2471 = select(1f, _e2469, (_e2469 > 1f));
let _e2473 = select(128f, _e2471, (_e2471 < 128f));
let _e2480 = select(0i, select(select(i32(_e2473), i32(-2147483648), (_e2473 < -2147483600f)), 2147483647i, (_e2473 > 2147483500f)), (_e2473 == _e2473));
let _e2484 = (_e2480 - select(0i, 1i, (_e2473 < f32(_e2480))));
let _e2485 = (_e2461 * _e2468);
let _e2487 = select(1f, _e2485, (_e2485 > 1f));
let _e2489 = select(128f, _e2487, (_e2487 < 128f));
let _e2496 = select(0i, select(select(i32(_e2489), i32(-2147483648), (_e2489 < -2147483600f)), 2147483647i, (_e2489 > 2147483500f)), (_e2489 == _e2489));
let _e2500 = (_e2496 - select(0i, 1i, (_e2489 < f32(_e2496))));
let _e2502 = (1f / f32(_e2484));
let _e2504 = (1f / f32(_e2500));
let _e2507 = ((_e2502 * _e2504) * (_e2374 * 0.25f));
phi_5168_ = 0i;
loop {
let _e2509 = phi_5168_;
let _e2510 = (_e2509 < _e2500);
if _e2510 {
let _e2513 = ((f32(_e2509) + 0.5f) * _e2504);
phi_5203_ = 0i;
loop {
let _e2521 = phi_5203_;
let _e2522 = (_e2521 < _e2484);
if _e2522 {
let _e2525 = ((f32(_e2521) + 0.5f) * _e2502);
let _e2540 = ((bitcast<f32>((bitcast<u32>((_e2387 + ((_e2387 - _e2387) * _e2513))) & 2147483647u)) * _e2502) + (bitcast<f32>((bitcast<u32>((_e2425 + ((_e2435 - _e2425) * _e2525))) & 2147483647u)) * _e2504));
let _e2549 = ((bitcast<f32>((bitcast<u32>((_e2388 + ((_e2397 - _e2388) * _e2513))) & 2147483647u)) * _e2502) + (bitcast<f32>((bitcast<u32>((_e2426 + ((_e2426 - _e2426) * _e2525))) & 2147483647u)) * _e2504));
let _e2551 = (_e2253 + (_e2387 * _e2525));
let _e2554 = (_e2551 + ((_e2551 - _e2551) * _e2513));
let _e2556 = (_e2282 + (_e2388 * _e2525));
let _e2561 = (_e2556 + (((_e2352 + (_e2397 * _e2525)) - _e2556) * _e2513));
let _e2568 = (_e2288.x + ((_e2323.x - _e2288.x) * _e2525));
let _e2575 = ((_e2568 + (((_e2358.x + ((_e2364.x - _e2358.x) * _e2525)) - _e2568) * _e2513)) * _e2507);
let _e2582 = (_e2288.y + ((_e2323.y - _e2288.y) * _e2525));
let _e2589 = ((_e2582 + (((_e2358.y + ((_e2364.y - _e2358.y) * _e2525)) - _e2582) * _e2513)) * _e2507);
let _e2596 = (_e2288.z + ((_e2323.z - _e2288.z) * _e2525));
let _e2603 = ((_e2596 + (((_e2358.z + ((_e2364.z - _e2358.z) * _e2525)) - _e2596) * _e2513)) * _e2507);
if _e201 {
let _e2853 = select(1f, _e2540, (_e2540 > 1f));
let _e2855 = select(8f, _e2853, (_e2853 < 8f));
let _e2857 = select(1f, _e2549, (_e2549 > 1f));
let _e2859 = select(8f, _e2857, (_e2857 < 8f));
let _e2861 = (0.5f * (_e2855 + _e2859));
let _e2865 = (((3f * _e2371) * _e2371) - (_e2861 * _e2861));
let _e2866 = (1f * 1f);
let _e2868 = select(_e2866, _e2865, (_e2865 > _e2866));
let _e2871 = sqrt(select(0f, _e2868, (_e2868 > 0f)));
let _e2873 = (1f / (_e2871 * _e2871));
phi_5376_ = 0i;
loop {
let _e2878 = phi_5376_;
let _e2879 = (_e2878 < 4i);
if _e2879 {
let _e2881 = f32((_e2878 & 1i));
let _e2884 = f32((_e2878 >> bitcast<u32>(1i)));
let _e2889 = ((1f - (2f * _e2881)) * (1f - (2f * _e2884)));
let _e2893 = ((_e2554 + ((_e2881 - 0.5f) * _e2871)) + 0.5f);
let _e2897 = ((_e2561 + ((_e2884 - 0.5f) * _e2871)) + 0.5f);
let _e2898 = (0.5f * _e2855);
let _e2899 = (_e2898 - 0.5f);
let _e2902 = (0.5f * _e2859);
let _e2903 = (_e2902 - 0.5f);
let _e2909 = (select(_e2899, _e2893, (_e2893 > _e2899)) - _e2898);
let _e2910 = (select(_e2903, _e2897, (_e2897 > _e2903)) - _e2902);
let _e2911 = (_e2909 + 0.5f);
let _e2913 = select(0f, _e2911, (_e2911 > 0f));
let _e2915 = select(65536f, _e2913, (_e2913 < 65536f));
let _e2922 = select(0i, select(select(i32(_e2915), i32(-2147483648), (_e2915 < -2147483600f)), 2147483647i, (_e2915 > 2147483500f)), (_e2915 == _e2915));
let _e2927 = (_e2909 + _e2855);
let _e2928 = (_e2927 + 0.5f);
let _e2930 = f32((_e231 - 1i));
let _e2932 = select(-1f, _e2928, (_e2928 > -1f));
let _e2934 = select(_e2930, _e2932, (_e2932 < _e2930));
let _e2941 = select(0i, select(select(i32(_e2934), i32(-2147483648), (_e2934 < -2147483600f)), 2147483647i, (_e2934 > 2147483500f)), (_e2934 == _e2934));
let _e2946 = (_e2910 + _e2859);
let _e2947 = (_e2946 + 0.5f);
let _e2949 = f32((_e238 - 1i));
let _e2951 = select(-1f, _e2947, (_e2947 > -1f));
let _e2953 = select(_e2949, _e2951, (_e2951 < _e2949));
let _e2960 = select(0i, select(select(i32(_e2953), i32(-2147483648), (_e2953 < -2147483600f)), 2147483647i, (_e2953 > 2147483500f)), (_e2953 == _e2953));
let _e2965 = (_e2910 + 0.5f);
let _e2967 = select(0f, _e2965, (_e2965 > 0f));
let _e2969 = select(65536f, _e2967, (_e2967 < 65536f));
let _e2976 = select(0i, select(select(i32(_e2969), i32(-2147483648), (_e2969 < -2147483600f)), 2147483647i, (_e2969 > 2147483500f)), (_e2969 == _e2969));
phi_5533_ = (_e2976 - select(0i, 1i, (_e2969 < f32(_e2976))));
loop {
let _e2982 = phi_5533_;
let _e2983 = (_e2982 <= (_e2960 - select(0i, 1i, (_e2953 < f32(_e2960)))));
if _e2983 {
let _e2984 = f32(_e2982);
let _e2985 = (_e2984 - 0.5f);
let _e2988 = (_e2984 + 0.5f);
let _e2991 = (select(_e2988, _e2946, (_e2946 < _e2988)) - select(_e2985, _e2910, (_e2910 > _e2985)));
phi_5565_ = (_e2922 - select(0i, 1i, (_e2915 < f32(_e2922))));
loop {
let _e2996 = phi_5565_;
let _e2997 = (_e2996 <= (_e2941 - select(0i, 1i, (_e2934 < f32(_e2941)))));
if _e2997 {
let _e2998 = f32(_e2996);
let _e2999 = (_e2998 - 0.5f);
let _e3002 = (_e2998 + 0.5f);
let _e3005 = (select(_e3002, _e2927, (_e2927 < _e3002)) - select(_e2999, _e2909, (_e2909 > _e2999)));
let _e3009 = ((select(0f, _e3005, (_e3005 > 0f)) / _e2855) * (select(0f, _e2991, (_e2991 > 0f)) / _e2859));
if (_e3009 > 0f) {
let _e3013 = (((_e2982 * _e231) + _e2996) * 6i);
let _e3016 = (((((_e2575 * _e2873) * _e2889) * _e3009) * 16777216f) + 0.5f);
let _e3018 = select(-1073741800f, _e3016, (_e3016 > -1073741800f));
let _e3020 = select(1073741800f, _e3018, (_e3018 < 1073741800f));
let _e3027 = select(0i, select(select(i32(_e3020), i32(-2147483648), (_e3020 < -2147483600f)), 2147483647i, (_e3020 > 2147483500f)), (_e3020 == _e3020));
let _e3031 = (_e3027 - select(0i, 1i, (_e3020 < f32(_e3027))));
let _e3032 = bitcast<u32>(_e3031);
let _e3035 = bitcast<u32>((_e3031 >> bitcast<u32>(31i)));
if ((_e3032 | _e3035) == 0u) {
} else {
let _e3038 = bitcast<u32>(_e3013);
if (_e3038 < _e62) {
let _e3042 = atomicAdd((&global_3.member[_e3038]), _e3032);
phi_5646_ = _e3042;
} else {
phi_5646_ = 0u;
}
let _e3044 = phi_5646_;
let _e3048 = (_e3035 + select(0u, 1u, ((_e3044 + _e3032) < _e3032)));
if (_e3048 == 0u) {
} else {
let _e3050 = (_e3038 + 1u);
if (_e3050 < _e62) {
let _e3054 = atomicAdd((&global_3.member[_e3050]), _e3048);
}
}
}
let _e3058 = (((((_e2589 * _e2873) * _e2889) * _e3009) * 16777216f) + 0.5f);
let _e3060 = select(-1073741800f, _e3058, (_e3058 > -1073741800f));
let _e3062 = select(1073741800f, _e3060, (_e3060 < 1073741800f));
let _e3069 = select(0i, select(select(i32(_e3062), i32(-2147483648), (_e3062 < -2147483600f)), 2147483647i, (_e3062 > 2147483500f)), (_e3062 == _e3062));
let _e3073 = (_e3069 - select(0i, 1i, (_e3062 < f32(_e3069))));
let _e3074 = bitcast<u32>(_e3073);
let _e3077 = bitcast<u32>((_e3073 >> bitcast<u32>(31i)));
if ((_e3074 | _e3077) == 0u) {
} else {
let _e3080 = bitcast<u32>((_e3013 + 2i));
if (_e3080 < _e62) {
let _e3084 = atomicAdd((&global_3.member[_e3080]), _e3074);
phi_5704_ = _e3084;
} else {
phi_5704_ = 0u;
}
let _e3086 = phi_5704_;
let _e3090 = (_e3077 + select(0u, 1u, ((_e3086 + _e3074) < _e3074)));
if (_e3090 == 0u) {
} else {
let _e3092 = (_e3080 + 1u);
if (_e3092 < _e62) {
let _e3096 = atomicAdd((&global_3.member[_e3092]), _e3090);
}
}
}
let _e3100 = (((((_e2603 * _e2873) * _e2889) * _e3009) * 16777216f) + 0.5f);
let _e3102 = select(-1073741800f, _e3100, (_e3100 > -1073741800f));
let _e3104 = select(1073741800f, _e3102, (_e3102 < 1073741800f));
let _e3111 = select(0i, select(select(i32(_e3104), i32(-2147483648), (_e3104 < -2147483600f)), 2147483647i, (_e3104 > 2147483500f)), (_e3104 == _e3104));
let _e3115 = (_e3111 - select(0i, 1i, (_e3104 < f32(_e3111))));
let _e3116 = bitcast<u32>(_e3115);
let _e3119 = bitcast<u32>((_e3115 >> bitcast<u32>(31i)));
if ((_e3116 | _e3119) == 0u) {
} else {
let _e3122 = bitcast<u32>((_e3013 + 4i));
if (_e3122 < _e62) {
let _e3126 = atomicAdd((&global_3.member[_e3122]), _e3116);
phi_5762_ = _e3126;
} else {
phi_5762_ = 0u;
}
let _e3128 = phi_5762_;
let _e3132 = (_e3119 + select(0u, 1u, ((_e3128 + _e3116) < _e3116)));
if (_e3132 == 0u) {
} else {
let _e3134 = (_e3122 + 1u);
if (_e3134 < _e62) {
let _e3138 = atomicAdd((&global_3.member[_e3134]), _e3132);
}
}
}
}
phi_5566_ = (_e2996 + 1i);
} else {
phi_5566_ = i32();
}
let _e3141 = phi_5566_;
continue;
continuing {
phi_5565_ = _e3141;
break if !(_e2997);
}
}
phi_5534_ = (_e2982 + 1i);
} else {
phi_5534_ = i32();
}
let _e3145 = phi_5534_;
continue;
continuing {
phi_5533_ = _e3145;
break if !(_e2983);
}
}
phi_5377_ = (_e2878 + 1i);
} else {
phi_5377_ = i32();
}
let _e3149 = phi_5377_;
continue;
continuing {
phi_5376_ = _e3149;
break if !(_e2879);
}
}
} else {
let _e2605 = select(9.765625e-4f, _e2540, (_e2540 > 9.765625e-4f));
let _e2607 = select(5f, _e2605, (_e2605 < 5f));
let _e2609 = select(9.765625e-4f, _e2549, (_e2549 > 9.765625e-4f));
let _e2611 = select(5f, _e2609, (_e2609 < 5f));
let _e2613 = (_e2554 - (0.5f * _e2607));
let _e2615 = (_e2561 - (0.5f * _e2611));
let _e2616 = (_e2613 + 0.5f);
let _e2618 = select(0f, _e2616, (_e2616 > 0f));
let _e2620 = select(65536f, _e2618, (_e2618 < 65536f));
let _e2627 = select(0i, select(select(i32(_e2620), i32(-2147483648), (_e2620 < -2147483600f)), 2147483647i, (_e2620 > 2147483500f)), (_e2620 == _e2620));
let _e2632 = (_e2613 + _e2607);
let _e2633 = (_e2632 + 0.5f);
let _e2635 = f32((_e231 - 1i));
let _e2637 = select(-1f, _e2633, (_e2633 > -1f));
let _e2639 = select(_e2635, _e2637, (_e2637 < _e2635));
let _e2646 = select(0i, select(select(i32(_e2639), i32(-2147483648), (_e2639 < -2147483600f)), 2147483647i, (_e2639 > 2147483500f)), (_e2639 == _e2639));
let _e2651 = (_e2615 + _e2611);
let _e2652 = (_e2651 + 0.5f);
let _e2654 = f32((_e238 - 1i));
let _e2656 = select(-1f, _e2652, (_e2652 > -1f));
let _e2658 = select(_e2654, _e2656, (_e2656 < _e2654));
let _e2665 = select(0i, select(select(i32(_e2658), i32(-2147483648), (_e2658 < -2147483600f)), 2147483647i, (_e2658 > 2147483500f)), (_e2658 == _e2658));
let _e2670 = (_e2615 + 0.5f);
let _e2672 = select(0f, _e2670, (_e2670 > 0f));
let _e2674 = select(65536f, _e2672, (_e2672 < 65536f));
let _e2681 = select(0i, select(select(i32(_e2674), i32(-2147483648), (_e2674 < -2147483600f)), 2147483647i, (_e2674 > 2147483500f)), (_e2674 == _e2674));
phi_5916_ = (_e2681 - select(0i, 1i, (_e2674 < f32(_e2681))));
loop {
let _e2687 = phi_5916_;
let _e2688 = (_e2687 <= (_e2665 - select(0i, 1i, (_e2658 < f32(_e2665)))));
if _e2688 {
let _e2689 = f32(_e2687);
let _e2690 = (_e2689 - 0.5f);
let _e2693 = (_e2689 + 0.5f);
let _e2696 = (select(_e2693, _e2651, (_e2651 < _e2693)) - select(_e2690, _e2615, (_e2615 > _e2690)));
phi_5948_ = (_e2627 - select(0i, 1i, (_e2620 < f32(_e2627))));
loop {
let _e2701 = phi_5948_;
let _e2702 = (_e2701 <= (_e2646 - select(0i, 1i, (_e2639 < f32(_e2646)))));
if _e2702 {
let _e2703 = f32(_e2701);
let _e2704 = (_e2703 - 0.5f);
let _e2707 = (_e2703 + 0.5f);
let _e2710 = (select(_e2707, _e2632, (_e2632 < _e2707)) - select(_e2704, _e2613, (_e2613 > _e2704)));
let _e2714 = ((select(0f, _e2710, (_e2710 > 0f)) / _e2607) * (select(0f, _e2696, (_e2696 > 0f)) / _e2611));
if (_e2714 > 0f) {
let _e2718 = (((_e2687 * _e231) + _e2701) * 6i);
let _e2721 = (((_e2575 * _e2714) * 16777216f) + 0.5f);
let _e2723 = select(-1073741800f, _e2721, (_e2721 > -1073741800f));
let _e2725 = select(1073741800f, _e2723, (_e2723 < 1073741800f));
let _e2732 = select(0i, select(select(i32(_e2725), i32(-2147483648), (_e2725 < -2147483600f)), 2147483647i, (_e2725 > 2147483500f)), (_e2725 == _e2725));
let _e2736 = (_e2732 - select(0i, 1i, (_e2725 < f32(_e2732))));
let _e2737 = bitcast<u32>(_e2736);
let _e2740 = bitcast<u32>((_e2736 >> bitcast<u32>(31i)));
if ((_e2737 | _e2740) == 0u) {
} else {
let _e2743 = bitcast<u32>(_e2718);
if (_e2743 < _e62) {
let _e2747 = atomicAdd((&global_3.member[_e2743]), _e2737);
phi_6029_ = _e2747;
} else {
phi_6029_ = 0u;
}
let _e2749 = phi_6029_;
let _e2753 = (_e2740 + select(0u, 1u, ((_e2749 + _e2737) < _e2737)));
if (_e2753 == 0u) {
} else {
let _e2755 = (_e2743 + 1u);
if (_e2755 < _e62) {
let _e2759 = atomicAdd((&global_3.member[_e2755]), _e2753);
}
}
}
let _e2763 = (((_e2589 * _e2714) * 16777216f) + 0.5f);
let _e2765 = select(-1073741800f, _e2763, (_e2763 > -1073741800f));
let _e2767 = select(1073741800f, _e2765, (_e2765 < 1073741800f));
let _e2774 = select(0i, select(select(i32(_e2767), i32(-2147483648), (_e2767 < -2147483600f)), 2147483647i, (_e2767 > 2147483500f)), (_e2767 == _e2767));
let _e2778 = (_e2774 - select(0i, 1i, (_e2767 < f32(_e2774))));
let _e2779 = bitcast<u32>(_e2778);
let _e2782 = bitcast<u32>((_e2778 >> bitcast<u32>(31i)));
if ((_e2779 | _e2782) == 0u) {
} else {
let _e2785 = bitcast<u32>((_e2718 + 2i));
if (_e2785 < _e62) {
let _e2789 = atomicAdd((&global_3.member[_e2785]), _e2779);
phi_6087_ = _e2789;
} else {
phi_6087_ = 0u;
}
let _e2791 = phi_6087_;
let _e2795 = (_e2782 + select(0u, 1u, ((_e2791 + _e2779) < _e2779)));
if (_e2795 == 0u) {
} else {
let _e2797 = (_e2785 + 1u);
if (_e2797 < _e62) {
let _e2801 = atomicAdd((&global_3.member[_e2797]), _e2795);
}
}
}
let _e2805 = (((_e2603 * _e2714) * 16777216f) + 0.5f);
let _e2807 = select(-1073741800f, _e2805, (_e2805 > -1073741800f));
let _e2809 = select(1073741800f, _e2807, (_e2807 < 1073741800f));
let _e2816 = select(0i, select(select(i32(_e2809), i32(-2147483648), (_e2809 < -2147483600f)), 2147483647i, (_e2809 > 2147483500f)), (_e2809 == _e2809));
let _e2820 = (_e2816 - select(0i, 1i, (_e2809 < f32(_e2816))));
let _e2821 = bitcast<u32>(_e2820);
let _e2824 = bitcast<u32>((_e2820 >> bitcast<u32>(31i)));
if ((_e2821 | _e2824) == 0u) {
} else {
let _e2827 = bitcast<u32>((_e2718 + 4i));
if (_e2827 < _e62) {
let _e2831 = atomicAdd((&global_3.member[_e2827]), _e2821);
phi_6145_ = _e2831;
} else {
phi_6145_ = 0u;
}
let _e2833 = phi_6145_;
let _e2837 = (_e2824 + select(0u, 1u, ((_e2833 + _e2821) < _e2821)));
if (_e2837 == 0u) {
} else {
let _e2839 = (_e2827 + 1u);
if (_e2839 < _e62) {
let _e2843 = atomicAdd((&global_3.member[_e2839]), _e2837);
}
}
}
}
phi_5949_ = (_e2701 + 1i);
} else {
phi_5949_ = i32();
}
let _e2846 = phi_5949_;
continue;
continuing {
phi_5948_ = _e2846;
break if !(_e2702);
}
}
phi_5917_ = (_e2687 + 1i);
} else {
phi_5917_ = i32();
}
let _e2850 = phi_5917_;
continue;
continuing {
phi_5916_ = _e2850;
break if !(_e2688);
}
}
}
phi_5204_ = (_e2521 + 1i);
} else {
phi_5204_ = i32();
}
let _e3153 = phi_5204_;
continue;
continuing {
phi_5203_ = _e3153;
break if !(_e2522);
}
}
phi_5169_ = (_e2509 + 1i);
} else {
phi_5169_ = i32();
}
let _e3157 = phi_5169_;
continue;
continuing {
phi_5168_ = _e3157;
break if !(_e2510);
}
}
}
}
}
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
