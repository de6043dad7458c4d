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
var phi_3180_: vec2<f32>;
var phi_3849_: i32;
var phi_3881_: i32;
var phi_3962_: u32;
var phi_4020_: u32;
var phi_4078_: u32;
var phi_3882_: i32;
var phi_3850_: i32;
var phi_3309_: i32;
var phi_3466_: i32;
var phi_3498_: i32;
var phi_3579_: u32;
var phi_3637_: u32;
var phi_3695_: u32;
var phi_3499_: i32;
var phi_3467_: i32;
var phi_3310_: i32;
var phi_3090_: i32;
var phi_3055_: i32;
var phi_4401_: vec3<f32>;
var phi_4556_: vec3<f32>;
var phi_4711_: vec3<f32>;
var phi_4867_: vec3<f32>;
var phi_5002_: f32;
var phi_5215_: i32;
var phi_5250_: i32;
var phi_5341_: vec2<f32>;
var phi_6010_: i32;
var phi_6042_: i32;
var phi_6123_: u32;
var phi_6181_: u32;
var phi_6239_: u32;
var phi_6043_: i32;
var phi_6011_: i32;
var phi_5470_: i32;
var phi_5627_: i32;
var phi_5659_: i32;
var phi_5740_: u32;
var phi_5798_: u32;
var phi_5856_: u32;
var phi_5660_: i32;
var phi_5628_: i32;
var phi_5471_: i32;
var phi_5251_: i32;
var phi_5216_: i32;
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
let _e1469 = ((_e1308 + ((_e1326 - _e1308) * _e1450)) * _e1439);
let _e1470 = ((_e1309 + ((_e1327 - _e1309) * _e1450)) * _e1439);
let _e1471 = ((_e1358 + ((_e1368 - _e1358) * _e1462)) * _e1441);
let _e1472 = ((_e1359 + ((_e1369 - _e1359) * _e1462)) * _e1441);
let _e1478 = bitcast<f32>((bitcast<u32>(((_e1469 * _e1472) - (_e1470 * _e1471))) & 2147483647u));
let _e1481 = bitcast<f32>((bitcast<u32>(_e1469) & 2147483647u));
let _e1484 = bitcast<f32>((bitcast<u32>(_e1472) & 2147483647u));
let _e1487 = bitcast<f32>((bitcast<u32>(_e1471) & 2147483647u));
let _e1488 = (_e1481 + _e1487);
let _e1491 = bitcast<f32>((bitcast<u32>(_e1470) & 2147483647u));
let _e1492 = (_e1484 + _e1491);
let _e1496 = (9.765625e-4f * 9.765625e-4f);
let _e1499 = (_e1478 / select(_e1496, _e1481, (_e1481 > _e1496)));
let _e1504 = (_e1478 / select(_e1496, _e1484, (_e1484 > _e1496)));
if ((_e1487 * _e1484) <= (_e1491 * _e1481)) {
phi_3180_ = vec2<f32>(_e1481, select(_e1492, _e1499, (_e1499 < _e1492)));
} else {
phi_3180_ = vec2<f32>(select(_e1488, _e1504, (_e1504 < _e1488)), _e1484);
}
let _e1510 = phi_3180_;
let _e1514 = (_e1267.member.x + (_e1308 * _e1462));
let _e1519 = (_e1514 + (((_e1281.member.x + (_e1326 * _e1462)) - _e1514) * _e1450));
let _e1521 = (_e1267.member.y + (_e1309 * _e1462));
let _e1526 = (_e1521 + (((_e1281.member.y + (_e1327 * _e1462)) - _e1521) * _e1450));
let _e1537 = (_e1267.member_1.x + ((_e1275.member_1.x - _e1267.member_1.x) * _e1462));
let _e1544 = ((_e1537 + (((_e1281.member_1.x + ((_e1288.member_1.x - _e1281.member_1.x) * _e1462)) - _e1537) * _e1450)) * _e1444);
let _e1555 = (_e1267.member_1.y + ((_e1275.member_1.y - _e1267.member_1.y) * _e1462));
let _e1562 = ((_e1555 + (((_e1281.member_1.y + ((_e1288.member_1.y - _e1281.member_1.y) * _e1462)) - _e1555) * _e1450)) * _e1444);
let _e1573 = (_e1267.member_1.z + ((_e1275.member_1.z - _e1267.member_1.z) * _e1462));
let _e1580 = ((_e1573 + (((_e1281.member_1.z + ((_e1288.member_1.z - _e1281.member_1.z) * _e1462)) - _e1573) * _e1450)) * _e1444);
if _e201 {
let _e1830 = select(1f, _e1510.x, (_e1510.x > 1f));
let _e1832 = select(8f, _e1830, (_e1830 < 8f));
let _e1834 = select(1f, _e1510.y, (_e1510.y > 1f));
let _e1836 = select(8f, _e1834, (_e1834 < 8f));
let _e1838 = (0.5f * (_e1832 + _e1836));
let _e1842 = (((3f * _e1244) * _e1244) - (_e1838 * _e1838));
let _e1843 = (1f * 1f);
let _e1845 = select(_e1843, _e1842, (_e1842 > _e1843));
let _e1848 = sqrt(select(0f, _e1845, (_e1845 > 0f)));
let _e1850 = (1f / (_e1848 * _e1848));
phi_3309_ = 0i;
loop {
let _e1855 = phi_3309_;
let _e1856 = (_e1855 < 4i);
if _e1856 {
let _e1858 = f32((_e1855 & 1i));
let _e1861 = f32((_e1855 >> bitcast<u32>(1i)));
let _e1866 = ((1f - (2f * _e1858)) * (1f - (2f * _e1861)));
let _e1870 = ((_e1519 + ((_e1858 - 0.5f) * _e1848)) + 0.5f);
let _e1874 = ((_e1526 + ((_e1861 - 0.5f) * _e1848)) + 0.5f);
let _e1875 = (0.5f * _e1832);
let _e1876 = (_e1875 - 0.5f);
let _e1879 = (0.5f * _e1836);
let _e1880 = (_e1879 - 0.5f);
let _e1886 = (select(_e1876, _e1870, (_e1870 > _e1876)) - _e1875);
let _e1887 = (select(_e1880, _e1874, (_e1874 > _e1880)) - _e1879);
let _e1888 = (_e1886 + 0.5f);
let _e1890 = select(0f, _e1888, (_e1888 > 0f));
let _e1892 = select(65536f, _e1890, (_e1890 < 65536f));
let _e1899 = select(0i, select(select(i32(_e1892), i32(-2147483648), (_e1892 < -2147483600f)), 2147483647i, (_e1892 > 2147483500f)), (_e1892 == _e1892));
let _e1904 = (_e1886 + _e1832);
let _e1905 = (_e1904 + 0.5f);
let _e1907 = f32((_e231 - 1i));
let _e1909 = select(-1f, _e1905, (_e1905 > -1f));
let _e1911 = select(_e1907, _e1909, (_e1909 < _e1907));
let _e1918 = select(0i, select(select(i32(_e1911), i32(-2147483648), (_e1911 < -2147483600f)), 2147483647i, (_e1911 > 2147483500f)), (_e1911 == _e1911));
let _e1923 = (_e1887 + _e1836);
let _e1924 = (_e1923 + 0.5f);
let _e1926 = f32((_e238 - 1i));
let _e1928 = select(-1f, _e1924, (_e1924 > -1f));
let _e1930 = select(_e1926, _e1928, (_e1928 < _e1926));
let _e1937 = select(0i, select(select(i32(_e1930), i32(-2147483648), (_e1930 < -2147483600f)), 2147483647i, (_e1930 > 2147483500f)), (_e1930 == _e1930));
let _e1942 = (_e1887 + 0.5f);
let _e1944 = select(0f, _e1942, (_e1942 > 0f));
let _e1946 = select(65536f, _e1944, (_e1944 < 65536f));
let _e1953 = select(0i, select(select(i32(_e1946), i32(-2147483648), (_e1946 < -2147483600f)), 2147483647i, (_e1946 > 2147483500f)), (_e1946 == _e1946));
phi_3466_ = (_e1953 - select(0i, 1i, (_e1946 < f32(_e1953))));
loop {
let _e1959 = phi_3466_;
let _e1960 = (_e1959 <= (_e1937 - select(0i, 1i, (_e1930 < f32(_e1937)))));
if _e1960 {
let _e1961 = f32(_e1959);
let _e1962 = (_e1961 - 0.5f);
let _e1965 = (_e1961 + 0.5f);
let _e1968 = (select(_e1965, _e1923, (_e1923 < _e1965)) - select(_e1962, _e1887, (_e1887 > _e1962)));
phi_3498_ = (_e1899 - select(0i, 1i, (_e1892 < f32(_e1899))));
loop {
let _e1973 = phi_3498_;
let _e1974 = (_e1973 <= (_e1918 - select(0i, 1i, (_e1911 < f32(_e1918)))));
if _e1974 {
let _e1975 = f32(_e1973);
let _e1976 = (_e1975 - 0.5f);
let _e1979 = (_e1975 + 0.5f);
let _e1982 = (select(_e1979, _e1904, (_e1904 < _e1979)) - select(_e1976, _e1886, (_e1886 > _e1976)));
let _e1986 = ((select(0f, _e1982, (_e1982 > 0f)) / _e1832) * (select(0f, _e1968, (_e1968 > 0f)) / _e1836));
if (_e1986 > 0f) {
let _e1990 = (((_e1959 * _e231) + _e1973) * 6i);
let _e1993 = (((((_e1544 * _e1850) * _e1866) * _e1986) * 16777216f) + 0.5f);
let _e1995 = select(-1073741800f, _e1993, (_e1993 > -1073741800f));
let _e1997 = select(1073741800f, _e1995, (_e1995 < 1073741800f));
let _e2004 = select(0i, select(select(i32(_e1997), i32(-2147483648), (_e1997 < -2147483600f)), 2147483647i, (_e1997 > 2147483500f)), (_e1997 == _e1997));
let _e2008 = (_e2004 - select(0i, 1i, (_e1997 < f32(_e2004))));
let _e2009 = bitcast<u32>(_e2008);
let _e2012 = bitcast<u32>((_e2008 >> bitcast<u32>(31i)));
if ((_e2009 | _e2012) == 0u) {
} else {
let _e2015 = bitcast<u32>(_e1990);
if (_e2015 < _e62) {
let _e2019 = atomicAdd((&global_3.member[_e2015]), _e2009);
phi_3579_ = _e2019;
} else {
phi_3579_ = 0u;
}
let _e2021 = phi_3579_;
let _e2025 = (_e2012 + select(0u, 1u, ((_e2021 + _e2009) < _e2009)));
if (_e2025 == 0u) {
} else {
let _e2027 = (_e2015 + 1u);
if (_e2027 < _e62) {
let _e2031 = atomicAdd((&global_3.member[_e2027]), _e2025);
}
}
}
let _e2035 = (((((_e1562 * _e1850) * _e1866) * _e1986) * 16777216f) + 0.5f);
let _e2037 = select(-1073741800f, _e2035, (_e2035 > -1073741800f));
let _e2039 = select(1073741800f, _e2037, (_e2037 < 1073741800f));
let _e2046 = select(0i, select(select(i32(_e2039), i32(-2147483648), (_e2039 < -2147483600f)), 2147483647i, (_e2039 > 2147483500f)), (_e2039 == _e2039));
let _e2050 = (_e2046 - select(0i, 1i, (_e2039 < f32(_e2046))));
let _e2051 = bitcast<u32>(_e2050);
let _e2054 = bitcast<u32>((_e2050 >> bitcast<u32>(31i)));
if ((_e2051 | _e2054) == 0u) {
} else {
let _e2057 = bitcast<u32>((_e1990 + 2i));
if (_e2057 < _e62) {
let _e2061 = atomicAdd((&global_3.member[_e2057]), _e2051);
phi_3637_ = _e2061;
} else {
phi_3637_ = 0u;
}
let _e2063 = phi_3637_;
let _e2067 = (_e2054 + select(0u, 1u, ((_e2063 + _e2051) < _e2051)));
if (_e2067 == 0u) {
} else {
let _e2069 = (_e2057 + 1u);
if (_e2069 < _e62) {
let _e2073 = atomicAdd((&global_3.member[_e2069]), _e2067);
}
}
}
let _e2077 = (((((_e1580 * _e1850) * _e1866) * _e1986) * 16777216f) + 0.5f);
let _e2079 = select(-1073741800f, _e2077, (_e2077 > -1073741800f));
let _e2081 = select(1073741800f, _e2079, (_e2079 < 1073741800f));
let _e2088 = select(0i, select(select(i32(_e2081), i32(-2147483648), (_e2081 < -2147483600f)), 2147483647i, (_e2081 > 2147483500f)), (_e2081 == _e2081));
let _e2092 = (_e2088 - select(0i, 1i, (_e2081 < f32(_e2088))));
let _e2093 = bitcast<u32>(_e2092);
let _e2096 = bitcast<u32>((_e2092 >> bitcast<u32>(31i)));
if ((_e2093 | _e2096) == 0u) {
} else {
let _e2099 = bitcast<u32>((_e1990 + 4i));
if (_e2099 < _e62) {
let _e2103 = atomicAdd((&global_3.member[_e2099]), _e2093);
phi_3695_ = _e2103;
} else {
phi_3695_ = 0u;
}
let _e2105 = phi_3695_;
let _e2109 = (_e2096 + select(0u, 1u, ((_e2105 + _e2093) < _e2093)));
if (_e2109 == 0u) {
} else {
let _e2111 = (_e2099 + 1u);
if (_e2111 < _e62) {
let _e2115 = atomicAdd((&global_3.member[_e2111]), _e2109);
}
}
}
}
phi_3499_ = (_e1973 + 1i);
} else {
phi_3499_ = i32();
}
let _e2118 = phi_3499_;
continue;
continuing {
phi_3498_ = _e2118;
break if !(_e1974);
}
}
phi_3467_ = (_e1959 + 1i);
} else {
phi_3467_ = i32();
}
let _e2122 = phi_3467_;
continue;
continuing {
phi_3466_ = _e2122;
break if !(_e1960);
}
}
phi_3310_ = (_e1855 + 1i);
} else {
phi_3310_ = i32();
}
let _e2126 = phi_3310_;
continue;
continuing {
phi_3309_ = _e2126;
break if !(_e1856);
}
}
} else {
let _e1582 = select(9.765625e-4f, _e1510.x, (_e1510.x > 9.765625e-4f));
let _e1584 = select(5f, _e1582, (_e1582 < 5f));
let _e1586 = select(9.765625e-4f, _e1510.y, (_e1510.y > 9.765625e-4f));
let _e1588 = select(5f, _e1586, (_e1586 < 5f));
let _e1590 = (_e1519 - (0.5f * _e1584));
let _e1592 = (_e1526 - (0.5f * _e1588));
let _e1593 = (_e1590 + 0.5f);
let _e1595 = select(0f, _e1593, (_e1593 > 0f));
let _e1597 = select(65536f, _e1595, (_e1595 < 65536f));
let _e1604 = select(0i, select(select(i32(_e1597), i32(-2147483648), (_e1597 < -2147483600f)), 2147483647i, (_e1597 > 2147483500f)), (_e1597 == _e1597));
let _e1609 = (_e1590 + _e1584);
let _e1610 = (_e1609 + 0.5f);
let _e1612 = f32((_e231 - 1i));
let _e1614 = select(-1f, _e1610, (_e1610 > -1f));
let _e1616 = select(_e1612, _e1614, (_e1614 < _e1612));
let _e1623 = select(0i, select(select(i32(_e1616), i32(-2147483648), (_e1616 < -2147483600f)), 2147483647i, (_e1616 > 2147483500f)), (_e1616 == _e1616));
let _e1628 = (_e1592 + _e1588);
let _e1629 = (_e1628 + 0.5f);
let _e1631 = f32((_e238 - 1i));
let _e1633 = select(-1f, _e1629, (_e1629 > -1f));
let _e1635 = select(_e1631, _e1633, (_e1633 < _e1631));
let _e1642 = select(0i, select(select(i32(_e1635), i32(-2147483648), (_e1635 < -2147483600f)), 2147483647i, (_e1635 > 2147483500f)), (_e1635 == _e1635));
let _e1647 = (_e1592 + 0.5f);
let _e1649 = select(0f, _e1647, (_e1647 > 0f));
let _e1651 = select(65536f, _e1649, (_e1649 < 65536f));
let _e1658 = select(0i, select(select(i32(_e1651), i32(-2147483648), (_e1651 < -2147483600f)), 2147483647i, (_e1651 > 2147483500f)), (_e1651 == _e1651));
phi_3849_ = (_e1658 - select(0i, 1i, (_e1651 < f32(_e1658))));
loop {
let _e1664 = phi_3849_;
let _e1665 = (_e1664 <= (_e1642 - select(0i, 1i, (_e1635 < f32(_e1642)))));
if _e1665 {
let _e1666 = f32(_e1664);
let _e1667 = (_e1666 - 0.5f);
let _e1670 = (_e1666 + 0.5f);
let _e1673 = (select(_e1670, _e1628, (_e1628 < _e1670)) - select(_e1667, _e1592, (_e1592 > _e1667)));
phi_3881_ = (_e1604 - select(0i, 1i, (_e1597 < f32(_e1604))));
loop {
let _e1678 = phi_3881_;
let _e1679 = (_e1678 <= (_e1623 - select(0i, 1i, (_e1616 < f32(_e1623)))));
if _e1679 {
let _e1680 = f32(_e1678);
let _e1681 = (_e1680 - 0.5f);
let _e1684 = (_e1680 + 0.5f);
let _e1687 = (select(_e1684, _e1609, (_e1609 < _e1684)) - select(_e1681, _e1590, (_e1590 > _e1681)));
let _e1691 = ((select(0f, _e1687, (_e1687 > 0f)) / _e1584) * (select(0f, _e1673, (_e1673 > 0f)) / _e1588));
if (_e1691 > 0f) {
let _e1695 = (((_e1664 * _e231) + _e1678) * 6i);
let _e1698 = (((_e1544 * _e1691) * 16777216f) + 0.5f);
let _e1700 = select(-1073741800f, _e1698, (_e1698 > -1073741800f));
let _e1702 = select(1073741800f, _e1700, (_e1700 < 1073741800f));
let _e1709 = select(0i, select(select(i32(_e1702), i32(-2147483648), (_e1702 < -2147483600f)), 2147483647i, (_e1702 > 2147483500f)), (_e1702 == _e1702));
let _e1713 = (_e1709 - select(0i, 1i, (_e1702 < f32(_e1709))));
let _e1714 = bitcast<u32>(_e1713);
let _e1717 = bitcast<u32>((_e1713 >> bitcast<u32>(31i)));
if ((_e1714 | _e1717) == 0u) {
} else {
let _e1720 = bitcast<u32>(_e1695);
if (_e1720 < _e62) {
let _e1724 = atomicAdd((&global_3.member[_e1720]), _e1714);
phi_3962_ = _e1724;
} else {
phi_3962_ = 0u;
}
let _e1726 = phi_3962_;
let _e1730 = (_e1717 + select(0u, 1u, ((_e1726 + _e1714) < _e1714)));
if (_e1730 == 0u) {
} else {
let _e1732 = (_e1720 + 1u);
if (_e1732 < _e62) {
let _e1736 = atomicAdd((&global_3.member[_e1732]), _e1730);
}
}
}
let _e1740 = (((_e1562 * _e1691) * 16777216f) + 0.5f);
let _e1742 = select(-1073741800f, _e1740, (_e1740 > -1073741800f));
let _e1744 = select(1073741800f, _e1742, (_e1742 < 1073741800f));
let _e1751 = select(0i, select(select(i32(_e1744), i32(-2147483648), (_e1744 < -2147483600f)), 2147483647i, (_e1744 > 2147483500f)), (_e1744 == _e1744));
let _e1755 = (_e1751 - select(0i, 1i, (_e1744 < f32(_e1751))));
let _e1756 = bitcast<u32>(_e1755);
let _e1759 = bitcast<u32>((_e1755 >> bitcast<u32>(31i)));
if ((_e1756 | _e1759) == 0u) {
} else {
let _e1762 = bitcast<u32>((_e1695 + 2i));
if (_e1762 < _e62) {
let _e1766 = atomicAdd((&global_3.member[_e1762]), _e1756);
phi_4020_ = _e1766;
} else {
phi_4020_ = 0u;
}
let _e1768 = phi_4020_;
let _e1772 = (_e1759 + select(0u, 1u, ((_e1768 + _e1756) < _e1756)));
if (_e1772 == 0u) {
} else {
let _e1774 = (_e1762 + 1u);
if (_e1774 < _e62) {
let _e1778 = atomicAdd((&global_3.member[_e1774]), _e1772);
}
}
}
let _e1782 = (((_e1580 * _e1691) * 16777216f) + 0.5f);
let _e1784 = select(-1073741800f, _e1782, (_e1782 > -1073741800f));
let _e1786 = select(1073741800f, _e1784, (_e1784 < 1073741800f));
let _e1793 = select(0i, select(select(i32(_e1786), i32(-2147483648), (_e1786 < -2147483600f)), 2147483647i, (_e1786 > 2147483500f)), (_e1786 == _e1786));
let _e1797 = (_e1793 - select(0i, 1i, (_e1786 < f32(_e1793))));
let _e1798 = bitcast<u32>(_e1797);
let _e1801 = bitcast<u32>((_e1797 >> bitcast<u32>(31i)));
if ((_e1798 | _e1801) == 0u) {
} else {
let _e1804 = bitcast<u32>((_e1695 + 4i));
if (_e1804 < _e62) {
let _e1808 = atomicAdd((&global_3.member[_e1804]), _e1798);
phi_4078_ = _e1808;
} else {
phi_4078_ = 0u;
}
let _e1810 = phi_4078_;
let _e1814 = (_e1801 + select(0u, 1u, ((_e1810 + _e1798) < _e1798)));
if (_e1814 == 0u) {
} else {
let _e1816 = (_e1804 + 1u);
if (_e1816 < _e62) {
let _e1820 = atomicAdd((&global_3.member[_e1816]), _e1814);
}
}
}
}
phi_3882_ = (_e1678 + 1i);
} else {
phi_3882_ = i32();
}
let _e1823 = phi_3882_;
continue;
continuing {
phi_3881_ = _e1823;
break if !(_e1679);
}
}
phi_3850_ = (_e1664 + 1i);
} else {
phi_3850_ = i32();
}
let _e1827 = phi_3850_;
continue;
continuing {
phi_3849_ = _e1827;
break if !(_e1665);
}
}
}
phi_3090_ = (_e1458 + 1i);
} else {
phi_3090_ = i32();
}
let _e2130 = phi_3090_;
continue;
continuing {
phi_3089_ = _e2130;
break if !(_e1459);
}
}
phi_3055_ = (_e1446 + 1i);
} else {
phi_3055_ = i32();
}
let _e2134 = phi_3055_;
continue;
continuing {
phi_3054_ = _e2134;
break if !(_e1447);
}
}
}
}
let _e2138 = (1f / 3f);
let _e2163 = (((1f - select((((_e311 + _e322) + _e333) * _e2138), 0f, (_e345 != 0f))) + (1f - select((((_e440 + _e451) + _e462) * _e2138), 0f, (_e474 != 0f)))) + ((1f - select((((_e569 + _e580) + _e591) * _e2138), 0f, (_e603 != 0f))) + (1f - select((((_e698 + _e709) + _e720) * _e2138), 0f, (_e732 != 0f)))));
if (_e201 && (_e2163 > 0f)) {
let _e2169 = (((_e367 + _e496) + (_e625 + _e754)) / _e2163);
let _e2171 = f32(bitcast<i32>(_e71));
let _e2174 = f32(bitcast<i32>(_e73));
let _e2179 = global_2.member.member_10.member_3;
let _e2180 = (_e2179 != 0u);
let _e2181 = select(1f, _e2169, _e2180);
let _e2185 = global_2.member.member_10.member_5;
let _e2189 = global_2.member.member_10.member_7;
let _e2192 = ((_e2185 + ((_e2171 + 0.5f) * _e2189)) * _e2181);
let _e2196 = global_2.member.member_10.member_6;
let _e2199 = ((_e2196 + ((_e2174 + 0.5f) * _e2189)) * _e2181);
let _e2204 = (((_e2192 * _e2192) + (_e2199 * _e2199)) + (_e2169 * _e2169));
let _e2207 = sqrt(select(0f, _e2204, (_e2204 > 0f)));
let _e2210 = (1f / select(1e-20f, _e2207, (_e2207 > 1e-20f)));
let _e2227 = ((((_e224.member.member * _e2192) + (_e224.member.member_1 * _e2199)) + (_e224.member.member_2 * _e2169)) + _e224.member_1);
let _e2233 = -((((_e224.member.member * select(0f, (_e2192 * _e2210), _e2180)) + (_e224.member.member_1 * select(0f, (_e2199 * _e2210), _e2180))) + (_e224.member.member_2 * select(1f, (_e2169 * _e2210), _e2180))));
let _e2235 = (_e2233 > 1e-6f);
let _e2239 = select(-1f, (_e2227 / select(1e-6f, _e2233, _e2235)), ((_e2227 >= 0f) && _e2235));
if (_e2239 >= 0f) {
let _e2242 = f32(bitcast<i32>(_e84));
let _e2244 = select(0f, _e2171, (_e2171 > 0f));
let _e2251 = global_2.member.member_10.member_17.member_1;
let _e2254 = ((_e2171 - _e2242) * _e2251);
let _e2259 = global_2.member.member_10.member_17.member_2;
let _e2261 = select(0f, _e2254, (_e2254 > 0f));
let _e2263 = (_e2259 + _e2261);
let _e2268 = (-(_e2171) * _e2251);
let _e2270 = select(0f, _e2268, (_e2268 > 0f));
let _e2272 = (_e2259 + _e2270);
let _e2279 = (((_e2259 + (select(_e2242, _e2244, (_e2244 < _e2242)) * _e2251)) + (((_e2261 * _e2259) / select(1e-12f, _e2263, (_e2263 > 1e-12f))) - ((_e2270 * _e2259) / select(1e-12f, _e2272, (_e2272 > 1e-12f))))) - 0.5f);
let _e2281 = f32(bitcast<i32>(_e90));
let _e2283 = select(0f, _e2174, (_e2174 > 0f));
let _e2288 = ((_e2174 - _e2281) * _e2251);
let _e2290 = select(0f, _e2288, (_e2288 > 0f));
let _e2292 = (_e2259 + _e2290);
let _e2297 = (-(_e2174) * _e2251);
let _e2299 = select(0f, _e2297, (_e2297 > 0f));
let _e2301 = (_e2259 + _e2299);
let _e2308 = (((_e2259 + (select(_e2281, _e2283, (_e2283 < _e2281)) * _e2251)) + (((_e2290 * _e2259) / select(1e-12f, _e2292, (_e2292 > 1e-12f))) - ((_e2299 * _e2259) / select(1e-12f, _e2301, (_e2301 > 1e-12f))))) - 0.5f);
if _e196 {
phi_4401_ = vec3<f32>((_e311 + -1f), (_e322 + -1f), (_e333 + -1f));
} else {
phi_4401_ = vec3<f32>(-1f, -1f, -1f);
}
let _e2314 = phi_4401_;
let _e2316 = f32(bitcast<i32>(_e122));
let _e2318 = select(0f, _e2316, (_e2316 > 0f));
let _e2323 = ((_e2316 - _e2242) * _e2251);
let _e2325 = select(0f, _e2323, (_e2323 > 0f));
let _e2327 = (_e2259 + _e2325);
let _e2332 = (-(_e2316) * _e2251);
let _e2334 = select(0f, _e2332, (_e2332 > 0f));
let _e2336 = (_e2259 + _e2334);
let _e2343 = (((_e2259 + (select(_e2242, _e2318, (_e2318 < _e2242)) * _e2251)) + (((_e2325 * _e2259) / select(1e-12f, _e2327, (_e2327 > 1e-12f))) - ((_e2334 * _e2259) / select(1e-12f, _e2336, (_e2336 > 1e-12f))))) - 0.5f);
if _e196 {
phi_4556_ = vec3<f32>((_e440 + -1f), (_e451 + -1f), (_e462 + -1f));
} else {
phi_4556_ = vec3<f32>(-1f, -1f, -1f);
}
let _e2349 = phi_4556_;
let _e2351 = f32(bitcast<i32>(_e147));
let _e2353 = select(0f, _e2351, (_e2351 > 0f));
let _e2358 = ((_e2351 - _e2281) * _e2251);
let _e2360 = select(0f, _e2358, (_e2358 > 0f));
let _e2362 = (_e2259 + _e2360);
let _e2367 = (-(_e2351) * _e2251);
let _e2369 = select(0f, _e2367, (_e2367 > 0f));
let _e2371 = (_e2259 + _e2369);
let _e2378 = (((_e2259 + (select(_e2281, _e2353, (_e2353 < _e2281)) * _e2251)) + (((_e2360 * _e2259) / select(1e-12f, _e2362, (_e2362 > 1e-12f))) - ((_e2369 * _e2259) / select(1e-12f, _e2371, (_e2371 > 1e-12f))))) - 0.5f);
if _e196 {
phi_4711_ = vec3<f32>((_e569 + -1f), (_e580 + -1f), (_e591 + -1f));
} else {
phi_4711_ = vec3<f32>(-1f, -1f, -1f);
}
let _e2384 = phi_4711_;
if _e196 {
phi_4867_ = vec3<f32>((_e698 + -1f), (_e709 + -1f), (_e720 + -1f));
} else {
phi_4867_ = vec3<f32>(-1f, -1f, -1f);
}
let _e2390 = phi_4867_;
let _e2395 = global_2.member.member_10.member_8;
let _e2397 = (((_e200 * _e2239) * _e2395) * _e2251);
let _e2400 = (((1f + 1f) + 1f) + 1f);
if (_e2400 > 0f) {
let _e2402 = (1.7320508f * _e2397);
if _e201 {
let _e2405 = (0.5f * select(1f, _e2402, (_e2402 > 1f)));
let _e2407 = select(_e2251, _e2405, (_e2405 > _e2251));
phi_5002_ = select(8f, _e2407, (_e2407 < 8f));
} else {
phi_5002_ = 1f;
}
let _e2411 = phi_5002_;
let _e2413 = (_e2343 - _e2279);
let _e2414 = (_e2308 - _e2308);
let _e2417 = bitcast<f32>((bitcast<u32>(_e2413) & 2147483647u));
let _e2420 = bitcast<f32>((bitcast<u32>(_e2414) & 2147483647u));
let _e2422 = select(_e2420, _e2417, (_e2417 > _e2420));
let _e2423 = (_e2378 - _e2378);
let _e2426 = bitcast<f32>((bitcast<u32>(_e2423) & 2147483647u));
let _e2428 = select(_e2426, _e2417, (_e2417 > _e2426));
let _e2432 = ((select(_e2428, _e2422, (_e2422 > _e2428)) / _e2411) - 1e-3f);
let _e2433 = (128f - 1f);
let _e2435 = select(0f, _e2432, (_e2432 > 0f));
let _e2437 = select(_e2433, _e2435, (_e2435 < _e2433));
let _e2444 = select(0i, select(select(i32(_e2437), i32(-2147483648), (_e2437 < -2147483600f)), 2147483647i, (_e2437 > 2147483500f)), (_e2437 == _e2437));
let _e2450 = f32((1i + (_e2444 - select(0i, 1i, (_e2437 < f32(_e2444))))));
let _e2451 = (_e2279 - _e2279);
let _e2452 = (_e2378 - _e2308);
let _e2455 = bitcast<f32>((bitcast<u32>(_e2451) & 2147483647u));
let _e2458 = bitcast<f32>((bitcast<u32>(_e2452) & 2147483647u));
let _e2460 = select(_e2458, _e2455, (_e2455 > _e2458));
let _e2461 = (_e2343 - _e2343);
let _e2464 = bitcast<f32>((bitcast<u32>(_e2461) & 2147483647u));
let _e2466 = select(_e2458, _e2464, (_e2464 > _e2458));
let _e2470 = ((select(_e2466, _e2460, (_e2460 > _e2466)) / _e2411) - 1e-3f);
let _e2472 = select(0f, _e2470, (_e2470 > 0f));
let _e2474 = select(_e2433, _e2472, (_e2472 < _e2433));
let _e2481 = select(0i, select(select(i32(_e2474), i32(-2147483648), (_e2474 < -2147483600f)), 2147483647i, (_e2474 > 2147483500f)), (_e2474 == _e2474));
let _e2487 = f32((1i + (_e2481 - select(0i, 1i, (_e2474 < f32(_e2481))))));
let _e2489 = (select(128f, 24f, _e201) / (_e2450 * _e2487));
let _e2491 = select(_e2489, 1f, (1f < _e2489));
let _e2494 = sqrt(select(0f, _e2491, (_e2491 > 0f)));
let _e2495 = (_e2450 * _e2494);
let _e2497 = select(1f, _e2495, (_e2495 > 1f));
let _e2499 = select(128f, _e2497, (_e2497 < 128f));
let _e2506 = select(0i, select(select(i32(_e2499), i32(-2147483648), (_e2499 < -2147483600f)), 2147483647i, (_e2499 > 2147483500f)), (_e2499 == _e2499));
let _e2510 = (_e2506 - select(0i, 1i, (_e2499 < f32(_e2506))));
let _e2511 = (_e2487 * _e2494);
let _e2513 = select(1f, _e2511, (_e2511 > 1f));
let _e2515 = select(128f, _e2513, (_e2513 < 128f));
let _e2522 = select(0i, select(select(i32(_e2515), i32(-2147483648), (_e2515 < -2147483600f)), 2147483647i, (_e2515 > 2147483500f)), (_e2515 == _e2515));
let _e2526 = (_e2522 - select(0i, 1i, (_e2515 < f32(_e2522))));
let _e2528 = (1f / f32(_e2510));
let _e2530 = (1f / f32(_e2526));
let _e2533 = ((_e2528 * _e2530) * (_e2400 * 0.25f));
phi_5215_ = 0i;
loop {
let _e2535 = phi_5215_;
let _e2536 = (_e2535 < _e2526);
if _e2536 {
let _e2539 = ((f32(_e2535) + 0.5f) * _e2530);
phi_5250_ = 0i;
loop {
let _e2547 = phi_5250_;
let _e2548 = (_e2547 < _e2510);
if _e2548 {
let _e2551 = ((f32(_e2547) + 0.5f) * _e2528);
let _e2558 = ((_e2413 + ((_e2413 - _e2413) * _e2539)) * _e2528);
let _e2559 = ((_e2414 + ((_e2423 - _e2414) * _e2539)) * _e2528);
let _e2560 = ((_e2451 + ((_e2461 - _e2451) * _e2551)) * _e2530);
let _e2561 = ((_e2452 + ((_e2452 - _e2452) * _e2551)) * _e2530);
let _e2567 = bitcast<f32>((bitcast<u32>(((_e2558 * _e2561) - (_e2559 * _e2560))) & 2147483647u));
let _e2570 = bitcast<f32>((bitcast<u32>(_e2558) & 2147483647u));
let _e2573 = bitcast<f32>((bitcast<u32>(_e2561) & 2147483647u));
let _e2576 = bitcast<f32>((bitcast<u32>(_e2560) & 2147483647u));
let _e2577 = (_e2570 + _e2576);
let _e2580 = bitcast<f32>((bitcast<u32>(_e2559) & 2147483647u));
let _e2581 = (_e2573 + _e2580);
let _e2585 = (9.765625e-4f * 9.765625e-4f);
let _e2588 = (_e2567 / select(_e2585, _e2570, (_e2570 > _e2585)));
let _e2593 = (_e2567 / select(_e2585, _e2573, (_e2573 > _e2585)));
if ((_e2576 * _e2573) <= (_e2580 * _e2570)) {
phi_5341_ = vec2<f32>(_e2570, select(_e2581, _e2588, (_e2588 < _e2581)));
} else {
phi_5341_ = vec2<f32>(select(_e2577, _e2593, (_e2593 < _e2577)), _e2573);
}
let _e2599 = phi_5341_;
let _e2603 = (_e2279 + (_e2413 * _e2551));
let _e2606 = (_e2603 + ((_e2603 - _e2603) * _e2539));
let _e2608 = (_e2308 + (_e2414 * _e2551));
let _e2613 = (_e2608 + (((_e2378 + (_e2423 * _e2551)) - _e2608) * _e2539));
let _e2620 = (_e2314.x + ((_e2349.x - _e2314.x) * _e2551));
let _e2627 = ((_e2620 + (((_e2384.x + ((_e2390.x - _e2384.x) * _e2551)) - _e2620) * _e2539)) * _e2533);
let _e2634 = (_e2314.y + ((_e2349.y - _e2314.y) * _e2551));
let _e2641 = ((_e2634 + (((_e2384.y + ((_e2390.y - _e2384.y) * _e2551)) - _e2634) * _e2539)) * _e2533);
let _e2648 = (_e2314.z + ((_e2349.z - _e2314.z) * _e2551));
let _e2655 = ((_e2648 + (((_e2384.z + ((_e2390.z - _e2384.z) * _e2551)) - _e2648) * _e2539)) * _e2533);
if _e201 {
let _e2905 = select(1f, _e2599.x, (_e2599.x > 1f));
let _e2907 = select(8f, _e2905, (_e2905 < 8f));
let _e2909 = select(1f, _e2599.y, (_e2599.y > 1f));
let _e2911 = select(8f, _e2909, (_e2909 < 8f));
let _e2913 = (0.5f * (_e2907 + _e2911));
let _e2917 = (((3f * _e2397) * _e2397) - (_e2913 * _e2913));
let _e2918 = (1f * 1f);
let _e2920 = select(_e2918, _e2917, (_e2917 > _e2918));
let _e2923 = sqrt(select(0f, _e2920, (_e2920 > 0f)));
let _e2925 = (1f / (_e2923 * _e2923));
phi_5470_ = 0i;
loop {
let _e2930 = phi_5470_;
let _e2931 = (_e2930 < 4i);
if _e2931 {
let _e2933 = f32((_e2930 & 1i));
let _e2936 = f32((_e2930 >> bitcast<u32>(1i)));
let _e2941 = ((1f - (2f * _e2933)) * (1f - (2f * _e2936)));
let _e2945 = ((_e2606 + ((_e2933 - 0.5f) * _e2923)) + 0.5f);
let _e2949 = ((_e2613 + ((_e2936 - 0.5f) * _e2923)) + 0.5f);
let _e2950 = (0.5f * _e2907);
let _e2951 = (_e2950 - 0.5f);
let _e2954 = (0.5f * _e2911);
let _e2955 = (_e2954 - 0.5f);
let _e2961 = (select(_e2951, _e2945, (_e2945 > _e2951)) - _e2950);
let _e2962 = (select(_e2955, _e2949, (_e2949 > _e2955)) - _e2954);
let _e2963 = (_e2961 + 0.5f);
let _e2965 = select(0f, _e2963, (_e2963 > 0f));
let _e2967 = select(65536f, _e2965, (_e2965 < 65536f));
let _e2974 = select(0i, select(select(i32(_e2967), i32(-2147483648), (_e2967 < -2147483600f)), 2147483647i, (_e2967 > 2147483500f)), (_e2967 == _e2967));
let _e2979 = (_e2961 + _e2907);
let _e2980 = (_e2979 + 0.5f);
let _e2982 = f32((_e231 - 1i));
let _e2984 = select(-1f, _e2980, (_e2980 > -1f));
let _e2986 = select(_e2982, _e2984, (_e2984 < _e2982));
let _e2993 = select(0i, select(select(i32(_e2986), i32(-2147483648), (_e2986 < -2147483600f)), 2147483647i, (_e2986 > 2147483500f)), (_e2986 == _e2986));
let _e2998 = (_e2962 + _e2911);
let _e2999 = (_e2998 + 0.5f);
let _e3001 = f32((_e238 - 1i));
let _e3003 = select(-1f, _e2999, (_e2999 > -1f));
let _e3005 = select(_e3001, _e3003, (_e3003 < _e3001));
let _e3012 = select(0i, select(select(i32(_e3005), i32(-2147483648), (_e3005 < -2147483600f)), 2147483647i, (_e3005 > 2147483500f)), (_e3005 == _e3005));
let _e3017 = (_e2962 + 0.5f);
let _e3019 = select(0f, _e3017, (_e3017 > 0f));
let _e3021 = select(65536f, _e3019, (_e3019 < 65536f));
let _e3028 = select(0i, select(select(i32(_e3021), i32(-2147483648), (_e3021 < -2147483600f)), 2147483647i, (_e3021 > 2147483500f)), (_e3021 == _e3021));
phi_5627_ = (_e3028 - select(0i, 1i, (_e3021 < f32(_e3028))));
loop {
let _e3034 = phi_5627_;
let _e3035 = (_e3034 <= (_e3012 - select(0i, 1i, (_e3005 < f32(_e3012)))));
if _e3035 {
let _e3036 = f32(_e3034);
let _e3037 = (_e3036 - 0.5f);
let _e3040 = (_e3036 + 0.5f);
let _e3043 = (select(_e3040, _e2998, (_e2998 < _e3040)) - select(_e3037, _e2962, (_e2962 > _e3037)));
phi_5659_ = (_e2974 - select(0i, 1i, (_e2967 < f32(_e2974))));
loop {
let _e3048 = phi_5659_;
let _e3049 = (_e3048 <= (_e2993 - select(0i, 1i, (_e2986 < f32(_e2993)))));
if _e3049 {
let _e3050 = f32(_e3048);
let _e3051 = (_e3050 - 0.5f);
let _e3054 = (_e3050 + 0.5f);
let _e3057 = (select(_e3054, _e2979, (_e2979 < _e3054)) - select(_e3051, _e2961, (_e2961 > _e3051)));
let _e3061 = ((select(0f, _e3057, (_e3057 > 0f)) / _e2907) * (select(0f, _e3043, (_e3043 > 0f)) / _e2911));
if (_e3061 > 0f) {
let _e3065 = (((_e3034 * _e231) + _e3048) * 6i);
let _e3068 = (((((_e2627 * _e2925) * _e2941) * _e3061) * 16777216f) + 0.5f);
let _e3070 = select(-1073741800f, _e3068, (_e3068 > -1073741800f));
let _e3072 = select(1073741800f, _e3070, (_e3070 < 1073741800f));
let _e3079 = select(0i, select(select(i32(_e3072), i32(-2147483648), (_e3072 < -2147483600f)), 2147483647i, (_e3072 > 2147483500f)), (_e3072 == _e3072));
let _e3083 = (_e3079 - select(0i, 1i, (_e3072 < f32(_e3079))));
let _e3084 = bitcast<u32>(_e3083);
let _e3087 = bitcast<u32>((_e3083 >> bitcast<u32>(31i)));
if ((_e3084 | _e3087) == 0u) {
} else {
let _e3090 = bitcast<u32>(_e3065);
if (_e3090 < _e62) {
let _e3094 = atomicAdd((&global_3.member[_e3090]), _e3084);
phi_5740_ = _e3094;
} else {
phi_5740_ = 0u;
}
let _e3096 = phi_5740_;
let _e3100 = (_e3087 + select(0u, 1u, ((_e3096 + _e3084) < _e3084)));
if (_e3100 == 0u) {
} else {
let _e3102 = (_e3090 + 1u);
if (_e3102 < _e62) {
let _e3106 = atomicAdd((&global_3.member[_e3102]), _e3100);
}
}
}
let _e3110 = (((((_e2641 * _e2925) * _e2941) * _e3061) * 16777216f) + 0.5f);
let _e3112 = select(-1073741800f, _e3110, (_e3110 > -1073741800f));
let _e3114 = select(1073741800f, _e3112, (_e3112 < 1073741800f));
let _e3121 = select(0i, select(select(i32(_e3114), i32(-2147483648), (_e3114 < -2147483600f)), 2147483647i, (_e3114 > 2147483500f)), (_e3114 == _e3114));
let _e3125 = (_e3121 - select(0i, 1i, (_e3114 < f32(_e3121))));
let _e3126 = bitcast<u32>(_e3125);
let _e3129 = bitcast<u32>((_e3125 >> bitcast<u32>(31i)));
if ((_e3126 | _e3129) == 0u) {
} else {
let _e3132 = bitcast<u32>((_e3065 + 2i));
if (_e3132 < _e62) {
let _e3136 = atomicAdd((&global_3.member[_e3132]), _e3126);
phi_5798_ = _e3136;
} else {
phi_5798_ = 0u;
}
let _e3138 = phi_5798_;
let _e3142 = (_e3129 + select(0u, 1u, ((_e3138 + _e3126) < _e3126)));
if (_e3142 == 0u) {
} else {
let _e3144 = (_e3132 + 1u);
if (_e3144 < _e62) {
let _e3148 = atomicAdd((&global_3.member[_e3144]), _e3142);
}
}
}
let _e3152 = (((((_e2655 * _e2925) * _e2941) * _e3061) * 16777216f) + 0.5f);
let _e3154 = select(-1073741800f, _e3152, (_e3152 > -1073741800f));
let _e3156 = select(1073741800f, _e3154, (_e3154 < 1073741800f));
let _e3163 = select(0i, select(select(i32(_e3156), i32(-2147483648), (_e3156 < -2147483600f)), 2147483647i, (_e3156 > 2147483500f)), (_e3156 == _e3156));
let _e3167 = (_e3163 - select(0i, 1i, (_e3156 < f32(_e3163))));
let _e3168 = bitcast<u32>(_e3167);
let _e3171 = bitcast<u32>((_e3167 >> bitcast<u32>(31i)));
if ((_e3168 | _e3171) == 0u) {
} else {
let _e3174 = bitcast<u32>((_e3065 + 4i));
if (_e3174 < _e62) {
let _e3178 = atomicAdd((&global_3.member[_e3174]), _e3168);
phi_5856_ = _e3178;
} else {
phi_5856_ = 0u;
}
let _e3180 = phi_5856_;
let _e3184 = (_e3171 + select(0u, 1u, ((_e3180 + _e3168) < _e3168)));
if (_e3184 == 0u) {
} else {
let _e3186 = (_e3174 + 1u);
if (_e3186 < _e62) {
let _e3190 = atomicAdd((&global_3.member[_e3186]), _e3184);
}
}
}
}
phi_5660_ = (_e3048 + 1i);
} else {
phi_5660_ = i32();
}
let _e3193 = phi_5660_;
continue;
continuing {
phi_5659_ = _e3193;
break if !(_e3049);
}
}
phi_5628_ = (_e3034 + 1i);
} else {
phi_5628_ = i32();
}
let _e3197 = phi_5628_;
continue;
continuing {
phi_5627_ = _e3197;
break if !(_e3035);
}
}
phi_5471_ = (_e2930 + 1i);
} else {
phi_5471_ = i32();
}
let _e3201 = phi_5471_;
continue;
continuing {
phi_5470_ = _e3201;
break if !(_e2931);
}
}
} else {
let _e2657 = select(9.765625e-4f, _e2599.x, (_e2599.x > 9.765625e-4f));
let _e2659 = select(5f, _e2657, (_e2657 < 5f));
let _e2661 = select(9.765625e-4f, _e2599.y, (_e2599.y > 9.765625e-4f));
let _e2663 = select(5f, _e2661, (_e2661 < 5f));
let _e2665 = (_e2606 - (0.5f * _e2659));
let _e2667 = (_e2613 - (0.5f * _e2663));
let _e2668 = (_e2665 + 0.5f);
let _e2670 = select(0f, _e2668, (_e2668 > 0f));
let _e2672 = select(65536f, _e2670, (_e2670 < 65536f));
let _e2679 = select(0i, select(select(i32(_e2672), i32(-2147483648), (_e2672 < -2147483600f)), 2147483647i, (_e2672 > 2147483500f)), (_e2672 == _e2672));
let _e2684 = (_e2665 + _e2659);
let _e2685 = (_e2684 + 0.5f);
let _e2687 = f32((_e231 - 1i));
let _e2689 = select(-1f, _e2685, (_e2685 > -1f));
let _e2691 = select(_e2687, _e2689, (_e2689 < _e2687));
let _e2698 = select(0i, select(select(i32(_e2691), i32(-2147483648), (_e2691 < -2147483600f)), 2147483647i, (_e2691 > 2147483500f)), (_e2691 == _e2691));
let _e2703 = (_e2667 + _e2663);
let _e2704 = (_e2703 + 0.5f);
let _e2706 = f32((_e238 - 1i));
let _e2708 = select(-1f, _e2704, (_e2704 > -1f));
let _e2710 = select(_e2706, _e2708, (_e2708 < _e2706));
let _e2717 = select(0i, select(select(i32(_e2710), i32(-2147483648), (_e2710 < -2147483600f)), 2147483647i, (_e2710 > 2147483500f)), (_e2710 == _e2710));
let _e2722 = (_e2667 + 0.5f);
let _e2724 = select(0f, _e2722, (_e2722 > 0f));
let _e2726 = select(65536f, _e2724, (_e2724 < 65536f));
let _e2733 = select(0i, select(select(i32(_e2726), i32(-2147483648), (_e2726 < -2147483600f)), 2147483647i, (_e2726 > 2147483500f)), (_e2726 == _e2726));
phi_6010_ = (_e2733 - select(0i, 1i, (_e2726 < f32(_e2733))));
loop {
let _e2739 = phi_6010_;
let _e2740 = (_e2739 <= (_e2717 - select(0i, 1i, (_e2710 < f32(_e2717)))));
if _e2740 {
let _e2741 = f32(_e2739);
let _e2742 = (_e2741 - 0.5f);
let _e2745 = (_e2741 + 0.5f);
let _e2748 = (select(_e2745, _e2703, (_e2703 < _e2745)) - select(_e2742, _e2667, (_e2667 > _e2742)));
phi_6042_ = (_e2679 - select(0i, 1i, (_e2672 < f32(_e2679))));
loop {
let _e2753 = phi_6042_;
let _e2754 = (_e2753 <= (_e2698 - select(0i, 1i, (_e2691 < f32(_e2698)))));
if _e2754 {
let _e2755 = f32(_e2753);
let _e2756 = (_e2755 - 0.5f);
let _e2759 = (_e2755 + 0.5f);
let _e2762 = (select(_e2759, _e2684, (_e2684 < _e2759)) - select(_e2756, _e2665, (_e2665 > _e2756)));
let _e2766 = ((select(0f, _e2762, (_e2762 > 0f)) / _e2659) * (select(0f, _e2748, (_e2748 > 0f)) / _e2663));
if (_e2766 > 0f) {
let _e2770 = (((_e2739 * _e231) + _e2753) * 6i);
let _e2773 = (((_e2627 * _e2766) * 16777216f) + 0.5f);
let _e2775 = select(-1073741800f, _e2773, (_e2773 > -1073741800f));
let _e2777 = select(1073741800f, _e2775, (_e2775 < 1073741800f));
let _e2784 = select(0i, select(select(i32(_e2777), i32(-2147483648), (_e2777 < -2147483600f)), 2147483647i, (_e2777 > 2147483500f)), (_e2777 == _e2777));
let _e2788 = (_e2784 - select(0i, 1i, (_e2777 < f32(_e2784))));
let _e2789 = bitcast<u32>(_e2788);
let _e2792 = bitcast<u32>((_e2788 >> bitcast<u32>(31i)));
if ((_e2789 | _e2792) == 0u) {
} else {
let _e2795 = bitcast<u32>(_e2770);
if (_e2795 < _e62) {
let _e2799 = atomicAdd((&global_3.member[_e2795]), _e2789);
phi_6123_ = _e2799;
} else {
phi_6123_ = 0u;
}
let _e2801 = phi_6123_;
let _e2805 = (_e2792 + select(0u, 1u, ((_e2801 + _e2789) < _e2789)));
if (_e2805 == 0u) {
} else {
let _e2807 = (_e2795 + 1u);
if (_e2807 < _e62) {
let _e2811 = atomicAdd((&global_3.member[_e2807]), _e2805);
}
}
}
let _e2815 = (((_e2641 * _e2766) * 16777216f) + 0.5f);
let _e2817 = select(-1073741800f, _e2815, (_e2815 > -1073741800f));
let _e2819 = select(1073741800f, _e2817, (_e2817 < 1073741800f));
let _e2826 = select(0i, select(select(i32(_e2819), i32(-2147483648), (_e2819 < -2147483600f)), 2147483647i, (_e2819 > 2147483500f)), (_e2819 == _e2819));
let _e2830 = (_e2826 - select(0i, 1i, (_e2819 < f32(_e2826))));
let _e2831 = bitcast<u32>(_e2830);
let _e2834 = bitcast<u32>((_e2830 >> bitcast<u32>(31i)));
if ((_e2831 | _e2834) == 0u) {
} else {
let _e2837 = bitcast<u32>((_e2770 + 2i));
if (_e2837 < _e62) {
let _e2841 = atomicAdd((&global_3.member[_e2837]), _e2831);
phi_6181_ = _e2841;
} else {
phi_6181_ = 0u;
}
let _e2843 = phi_6181_;
let _e2847 = (_e2834 + select(0u, 1u, ((_e2843 + _e2831) < _e2831)));
if (_e2847 == 0u) {
} else {
let _e2849 = (_e2837 + 1u);
if (_e2849 < _e62) {
let _e2853 = atomicAdd((&global_3.member[_e2849]), _e2847);
}
}
}
let _e2857 = (((_e2655 * _e2766) * 16777216f) + 0.5f);
let _e2859 = select(-1073741800f, _e2857, (_e2857 > -1073741800f));
let _e2861 = select(1073741800f, _e2859, (_e2859 < 1073741800f));
let _e2868 = select(0i, select(select(i32(_e2861), i32(-2147483648), (_e2861 < -2147483600f)), 2147483647i, (_e2861 > 2147483500f)), (_e2861 == _e2861));
let _e2872 = (_e2868 - select(0i, 1i, (_e2861 < f32(_e2868))));
let _e2873 = bitcast<u32>(_e2872);
let _e2876 = bitcast<u32>((_e2872 >> bitcast<u32>(31i)));
if ((_e2873 | _e2876) == 0u) {
} else {
let _e2879 = bitcast<u32>((_e2770 + 4i));
if (_e2879 < _e62) {
let _e2883 = atomicAdd((&global_3.member[_e2879]), _e2873);
phi_6239_ = _e2883;
} else {
phi_6239_ = 0u;
}
let _e2885 = phi_6239_;
let _e2889 = (_e2876 + select(0u, 1u, ((_e2885 + _e2873) < _e2873)));
if (_e2889 == 0u) {
} else {
let _e2891 = (_e2879 + 1u);
if (_e2891 < _e62) {
let _e2895 = atomicAdd((&global_3.member[_e2891]), _e2889);
}
}
}
}
phi_6043_ = (_e2753 + 1i);
} else {
phi_6043_ = i32();
}
let _e2898 = phi_6043_;
continue;
continuing {
phi_6042_ = _e2898;
break if !(_e2754);
}
}
phi_6011_ = (_e2739 + 1i);
} else {
phi_6011_ = i32();
}
let _e2902 = phi_6011_;
continue;
continuing {
phi_6010_ = _e2902;
break if !(_e2740);
}
}
}
phi_5251_ = (_e2547 + 1i);
} else {
phi_5251_ = i32();
}
let _e3205 = phi_5251_;
continue;
continuing {
phi_5250_ = _e3205;
break if !(_e2548);
}
}
phi_5216_ = (_e2535 + 1i);
} else {
phi_5216_ = i32();
}
let _e3209 = phi_5216_;
continue;
continuing {
phi_5215_ = _e3209;
break if !(_e2536);
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
