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
struct type_13 {
member: array<f32>,
}
struct type_17 {
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
member_12: vec3<f32>,
member_13: vec3<f32>,
member_14: i32,
member_15: i32,
member_16: i32,
member_17: f32,
}
struct type_18 {
member: u32,
member_1: u32,
}
struct type_19 {
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
struct type_20 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
}
struct type_21 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: u32,
member_4: type_5,
member_5: type_5,
}
struct type_22 {
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
struct type_23 {
member: type_2,
member_1: type_18,
member_2: type_4,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: f32,
member_8: type_5,
member_9: type_5,
member_10: type_11,
member_11: type_19,
member_12: type_20,
member_13: type_21,
member_14: type_9,
member_15: type_6,
member_16: type_5,
member_17: u32,
member_18: type_22,
}
struct type_24 {
member: type_23,
}
struct type_25 {
member: vec3<f32>,
member_1: vec3<f32>,
member_2: vec3<f32>,
member_3: vec3<f32>,
member_4: vec3<f32>,
member_5: vec3<f32>,
member_6: vec3<f32>,
member_7: i32,
member_8: i32,
member_9: i32,
member_10: f32,
member_11: i32,
member_12: i32,
member_13: f32,
member_14: f32,
member_15: f32,
member_16: i32,
member_17: i32,
member_18: i32,
member_19: i32,
member_20: i32,
member_21: i32,
member_22: i32,
member_23: f32,
member_24: f32,
member_25: f32,
member_26: f32,
member_27: f32,
}
struct type_26 {
member: i32,
member_1: i32,
member_2: f32,
member_3: f32,
member_4: f32,
}
struct type_29 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(1)
var<storage> global_1: type_13;
@group(0) @binding(2)
var<storage> global_2: type_13;
@group(0) @binding(3)
var<storage> global_3: type_13;
@group(0) @binding(4)
var<storage, read_write> global_4: type_13;
@group(0) @binding(0)
var<storage> global_5: type_24;
@group(0) @binding(5)
var<storage, read_write> global_6: type_29;
fn function_() {
var phi_1742_: f32;
var phi_2378_: f32;
var phi_2405_: type_25;
var phi_2406_: type_25;
var phi_2426_: type_25;
var phi_2428_: type_25;
var phi_2431_: i32;
var phi_2433_: bool;
var phi_3774_: i32;
var phi_3777_: i32;
var phi_3775_: i32;
var phi_3778_: i32;
var local: i32;
var phi_3896_: i32;
var phi_3899_: i32;
var phi_3897_: i32;
var phi_3900_: i32;
var local_1: i32;
var phi_4585_: f32;
var phi_4299_: f32;
var phi_4589_: type_25;
var local_2: i32;
var local_3: i32;
var local_4: i32;
var local_5: i32;
var local_6: i32;
var phi_6581_: f32;
var phi_6582_: f32;
var phi_6815_: f32;
var local_7: i32;
var local_8: i32;
var local_9: i32;
var phi_7619_: type_25;
var phi_7629_: type_25;
var phi_7630_: type_25;
var phi_7650_: type_25;
var phi_7805_: vec3<f32>;
var phi_7931_: vec3<f32>;
var phi_7949_: type_25;
var phi_6946_: f32;
var phi_7950_: type_25;
var phi_8105_: f32;
var phi_8149_: type_25;
var phi_8733_: f32;
var phi_9384_: f32;
var phi_9411_: type_25;
var phi_9412_: type_25;
var phi_9413_: type_25;
var phi_9414_: type_25;
var phi_9415_: type_25;
var phi_4643_: f32;
var phi_4655_: type_25;
var phi_4696_: type_25;
var phi_5280_: f32;
var phi_5931_: f32;
var phi_5958_: type_25;
var phi_5959_: type_25;
var phi_9416_: type_25;
var phi_9417_: type_25;
var phi_9418_: bool;
var phi_9422_: type_25;
var phi_9423_: type_25;
var phi_2659_: f32;
var phi_2972_: i32;
var phi_3583_: i32;
var phi_3733_: type_26;
var phi_3727_: bool;
var phi_3728_: bool;
var phi_3734_: type_26;
var phi_3735_: bool;
var phi_3742_: type_17;
var phi_3743_: type_26;
var phi_3744_: type_17;
var phi_3746_: type_26;
var phi_3747_: type_17;
var phi_3748_: bool;
var phi_3752_: type_26;
var phi_3753_: type_17;
var phi_3754_: bool;
var phi_3758_: type_26;
var phi_3759_: type_17;
var phi_9425_: type_25;
var phi_9426_: bool;
var phi_2429_: type_25;
var phi_2432_: i32;
var phi_2434_: bool;
var local_10: type_25;
var local_11: type_25;
var local_12: type_25;
var local_13: type_25;
var local_14: type_25;
var local_15: type_25;
var local_16: type_25;
var local_17: type_25;
var local_18: type_25;
var local_19: type_25;
var local_20: type_25;
var local_21: type_25;
var local_22: type_25;
var local_23: type_25;
var local_24: type_25;
var local_25: type_25;
var local_26: type_25;
var local_27: type_25;
var local_28: type_25;
var local_29: type_25;
var local_30: type_25;
var local_31: type_25;
var local_32: type_25;
var local_33: type_25;
var local_34: type_25;
var local_35: type_25;
var local_36: type_25;
var local_37: type_25;
var local_38: type_25;
var local_39: type_25;
var local_40: type_25;
var local_41: type_25;
var local_42: type_25;
var local_43: type_25;
var local_44: type_25;
var local_45: type_25;
var local_46: type_25;
var local_47: type_25;
var local_48: type_25;
var local_49: type_25;
var local_50: type_25;
var local_51: f32;
let _e120 = global;
let _e122 = arrayLength((&global_1.member));
let _e124 = arrayLength((&global_2.member));
let _e126 = arrayLength((&global_3.member));
let _e133 = global_5.member.member;
if (_e120.x < _e133.member) {
if (_e120.y < _e133.member_1) {
let _e140 = (_e133.member * _e133.member_1);
let _e142 = ((_e120.y * _e133.member) + _e120.x);
let _e143 = bitcast<i32>(_e142);
let _e145 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e147 = select(_e145, _e143, (_e143 < _e145));
let _e153 = global_4.member[bitcast<u32>(select(0i, _e147, (_e147 > 0i)))];
let _e154 = (_e140 + _e142);
let _e155 = bitcast<i32>(_e154);
let _e157 = select(_e145, _e155, (_e155 < _e145));
let _e163 = global_4.member[bitcast<u32>(select(0i, _e157, (_e157 > 0i)))];
let _e165 = ((2u * _e140) + _e142);
let _e166 = bitcast<i32>(_e165);
let _e168 = select(_e145, _e166, (_e166 < _e145));
let _e174 = global_4.member[bitcast<u32>(select(0i, _e168, (_e168 > 0i)))];
let _e176 = ((3u * _e140) + _e142);
let _e177 = bitcast<i32>(_e176);
let _e179 = select(_e145, _e177, (_e177 < _e145));
let _e185 = global_4.member[bitcast<u32>(select(0i, _e179, (_e179 > 0i)))];
let _e187 = ((4u * _e140) + _e142);
let _e188 = bitcast<i32>(_e187);
let _e190 = select(_e145, _e188, (_e188 < _e145));
let _e196 = global_4.member[bitcast<u32>(select(0i, _e190, (_e190 > 0i)))];
let _e198 = ((5u * _e140) + _e142);
let _e199 = bitcast<i32>(_e198);
let _e201 = select(_e145, _e199, (_e199 < _e145));
let _e207 = global_4.member[bitcast<u32>(select(0i, _e201, (_e201 > 0i)))];
let _e209 = ((6u * _e140) + _e142);
let _e210 = bitcast<i32>(_e209);
let _e212 = select(_e145, _e210, (_e210 < _e145));
let _e218 = global_4.member[bitcast<u32>(select(0i, _e212, (_e212 > 0i)))];
let _e220 = ((7u * _e140) + _e142);
let _e221 = bitcast<i32>(_e220);
let _e223 = select(_e145, _e221, (_e221 < _e145));
let _e229 = global_4.member[bitcast<u32>(select(0i, _e223, (_e223 > 0i)))];
let _e231 = ((8u * _e140) + _e142);
let _e232 = bitcast<i32>(_e231);
let _e234 = select(_e145, _e232, (_e232 < _e145));
let _e240 = global_4.member[bitcast<u32>(select(0i, _e234, (_e234 > 0i)))];
let _e242 = ((9u * _e140) + _e142);
let _e243 = bitcast<i32>(_e242);
let _e245 = select(_e145, _e243, (_e243 < _e145));
let _e251 = global_4.member[bitcast<u32>(select(0i, _e245, (_e245 > 0i)))];
let _e253 = ((10u * _e140) + _e142);
let _e254 = bitcast<i32>(_e253);
let _e256 = select(_e145, _e254, (_e254 < _e145));
let _e262 = global_4.member[bitcast<u32>(select(0i, _e256, (_e256 > 0i)))];
let _e264 = ((11u * _e140) + _e142);
let _e265 = bitcast<i32>(_e264);
let _e267 = select(_e145, _e265, (_e265 < _e145));
let _e273 = global_4.member[bitcast<u32>(select(0i, _e267, (_e267 > 0i)))];
let _e275 = ((12u * _e140) + _e142);
let _e276 = bitcast<i32>(_e275);
let _e278 = select(_e145, _e276, (_e276 < _e145));
let _e284 = global_4.member[bitcast<u32>(select(0i, _e278, (_e278 > 0i)))];
let _e286 = ((13u * _e140) + _e142);
let _e287 = bitcast<i32>(_e286);
let _e289 = select(_e145, _e287, (_e287 < _e145));
let _e295 = global_4.member[bitcast<u32>(select(0i, _e289, (_e289 > 0i)))];
let _e297 = ((14u * _e140) + _e142);
let _e298 = bitcast<i32>(_e297);
let _e300 = select(_e145, _e298, (_e298 < _e145));
let _e306 = global_4.member[bitcast<u32>(select(0i, _e300, (_e300 > 0i)))];
let _e308 = ((15u * _e140) + _e142);
let _e309 = bitcast<i32>(_e308);
let _e311 = select(_e145, _e309, (_e309 < _e145));
let _e317 = global_4.member[bitcast<u32>(select(0i, _e311, (_e311 > 0i)))];
let _e319 = ((16u * _e140) + _e142);
let _e320 = bitcast<i32>(_e319);
let _e322 = select(_e145, _e320, (_e320 < _e145));
let _e328 = global_4.member[bitcast<u32>(select(0i, _e322, (_e322 > 0i)))];
let _e330 = ((17u * _e140) + _e142);
let _e331 = bitcast<i32>(_e330);
let _e333 = select(_e145, _e331, (_e331 < _e145));
let _e339 = global_4.member[bitcast<u32>(select(0i, _e333, (_e333 > 0i)))];
let _e341 = ((18u * _e140) + _e142);
let _e342 = bitcast<i32>(_e341);
let _e344 = select(_e145, _e342, (_e342 < _e145));
let _e350 = global_4.member[bitcast<u32>(select(0i, _e344, (_e344 > 0i)))];
let _e352 = ((19u * _e140) + _e142);
let _e353 = bitcast<i32>(_e352);
let _e355 = select(_e145, _e353, (_e353 < _e145));
let _e361 = global_4.member[bitcast<u32>(select(0i, _e355, (_e355 > 0i)))];
let _e363 = ((20u * _e140) + _e142);
let _e364 = bitcast<i32>(_e363);
let _e366 = select(_e145, _e364, (_e364 < _e145));
let _e372 = global_4.member[bitcast<u32>(select(0i, _e366, (_e366 > 0i)))];
let _e374 = ((21u * _e140) + _e142);
let _e375 = bitcast<i32>(_e374);
let _e377 = select(_e145, _e375, (_e375 < _e145));
let _e383 = global_4.member[bitcast<u32>(select(0i, _e377, (_e377 > 0i)))];
let _e385 = ((22u * _e140) + _e142);
let _e386 = bitcast<i32>(_e385);
let _e388 = select(_e145, _e386, (_e386 < _e145));
let _e394 = global_4.member[bitcast<u32>(select(0i, _e388, (_e388 > 0i)))];
let _e396 = ((23u * _e140) + _e142);
let _e397 = bitcast<i32>(_e396);
let _e399 = select(_e145, _e397, (_e397 < _e145));
let _e405 = global_4.member[bitcast<u32>(select(0i, _e399, (_e399 > 0i)))];
let _e407 = ((24u * _e140) + _e142);
let _e408 = bitcast<i32>(_e407);
let _e410 = select(_e145, _e408, (_e408 < _e145));
let _e416 = global_4.member[bitcast<u32>(select(0i, _e410, (_e410 > 0i)))];
let _e418 = ((25u * _e140) + _e142);
let _e419 = bitcast<i32>(_e418);
let _e421 = select(_e145, _e419, (_e419 < _e145));
let _e427 = global_4.member[bitcast<u32>(select(0i, _e421, (_e421 > 0i)))];
let _e429 = ((26u * _e140) + _e142);
let _e430 = bitcast<i32>(_e429);
let _e432 = select(_e145, _e430, (_e430 < _e145));
let _e438 = global_4.member[bitcast<u32>(select(0i, _e432, (_e432 > 0i)))];
let _e440 = ((27u * _e140) + _e142);
let _e441 = bitcast<i32>(_e440);
let _e443 = select(_e145, _e441, (_e441 < _e145));
let _e449 = global_4.member[bitcast<u32>(select(0i, _e443, (_e443 > 0i)))];
let _e451 = ((28u * _e140) + _e142);
let _e452 = bitcast<i32>(_e451);
let _e454 = select(_e145, _e452, (_e452 < _e145));
let _e460 = global_4.member[bitcast<u32>(select(0i, _e454, (_e454 > 0i)))];
let _e462 = ((29u * _e140) + _e142);
let _e463 = bitcast<i32>(_e462);
let _e465 = select(_e145, _e463, (_e463 < _e145));
let _e471 = global_4.member[bitcast<u32>(select(0i, _e465, (_e465 > 0i)))];
let _e473 = ((30u * _e140) + _e142);
let _e474 = bitcast<i32>(_e473);
let _e476 = select(_e145, _e474, (_e474 < _e145));
let _e482 = global_4.member[bitcast<u32>(select(0i, _e476, (_e476 > 0i)))];
let _e484 = ((31u * _e140) + _e142);
let _e485 = bitcast<i32>(_e484);
let _e487 = select(_e145, _e485, (_e485 < _e145));
let _e493 = global_4.member[bitcast<u32>(select(0i, _e487, (_e487 > 0i)))];
let _e495 = ((32u * _e140) + _e142);
let _e496 = bitcast<i32>(_e495);
let _e498 = select(_e145, _e496, (_e496 < _e145));
let _e504 = global_4.member[bitcast<u32>(select(0i, _e498, (_e498 > 0i)))];
let _e506 = ((33u * _e140) + _e142);
let _e507 = bitcast<i32>(_e506);
let _e509 = select(_e145, _e507, (_e507 < _e145));
let _e515 = global_4.member[bitcast<u32>(select(0i, _e509, (_e509 > 0i)))];
let _e517 = ((34u * _e140) + _e142);
let _e518 = bitcast<i32>(_e517);
let _e520 = select(_e145, _e518, (_e518 < _e145));
let _e526 = global_4.member[bitcast<u32>(select(0i, _e520, (_e520 > 0i)))];
let _e528 = ((35u * _e140) + _e142);
let _e529 = bitcast<i32>(_e528);
let _e531 = select(_e145, _e529, (_e529 < _e145));
let _e537 = global_4.member[bitcast<u32>(select(0i, _e531, (_e531 > 0i)))];
let _e539 = ((36u * _e140) + _e142);
let _e540 = bitcast<i32>(_e539);
let _e542 = select(_e145, _e540, (_e540 < _e145));
let _e548 = global_4.member[bitcast<u32>(select(0i, _e542, (_e542 > 0i)))];
let _e550 = ((37u * _e140) + _e142);
let _e551 = bitcast<i32>(_e550);
let _e553 = select(_e145, _e551, (_e551 < _e145));
let _e559 = global_4.member[bitcast<u32>(select(0i, _e553, (_e553 > 0i)))];
let _e561 = ((38u * _e140) + _e142);
let _e562 = bitcast<i32>(_e561);
let _e564 = select(_e145, _e562, (_e562 < _e145));
let _e570 = global_4.member[bitcast<u32>(select(0i, _e564, (_e564 > 0i)))];
let _e572 = ((39u * _e140) + _e142);
let _e573 = bitcast<i32>(_e572);
let _e575 = select(_e145, _e573, (_e573 < _e145));
let _e581 = global_4.member[bitcast<u32>(select(0i, _e575, (_e575 > 0i)))];
let _e583 = ((40u * _e140) + _e142);
let _e584 = bitcast<i32>(_e583);
let _e586 = select(_e145, _e584, (_e584 < _e145));
let _e592 = global_4.member[bitcast<u32>(select(0i, _e586, (_e586 > 0i)))];
let _e594 = ((41u * _e140) + _e142);
let _e595 = bitcast<i32>(_e594);
let _e597 = select(_e145, _e595, (_e595 < _e145));
let _e603 = global_4.member[bitcast<u32>(select(0i, _e597, (_e597 > 0i)))];
let _e610 = select(0i, select(select(i32(_e548), i32(-2147483648), (_e548 < -2147483600f)), 2147483647i, (_e548 > 2147483500f)), (_e548 == _e548));
let _e615 = global_5.member.member_12.member_4;
let _e621 = select(3u, 0u, ((_e471 == 3f) || ((_e471 == 2f) && (_e610 > bitcast<i32>(_e615)))));
if (_e621 > 0u) {
if (arrayLength((&global_6.member)) >= 3u) {
let _e630 = atomicLoad((&global_6.member[0u]));
if (_e630 == 0u) {
atomicStore((&global_6.member[0u]), ((_e133.member + 7u) / 8u));
atomicStore((&global_6.member[1u]), ((_e133.member_1 + 7u) / 8u));
atomicStore((&global_6.member[2u]), 1u);
}
}
}
if (_e621 > 1u) {
let _e692 = select(0i, select(select(i32(_e493), i32(-2147483648), (_e493 < -2147483600f)), 2147483647i, (_e493 > 2147483500f)), (_e493 == _e493));
let _e699 = select(0i, select(select(i32(_e504), i32(-2147483648), (_e504 < -2147483600f)), 2147483647i, (_e504 > 2147483500f)), (_e504 == _e504));
let _e706 = select(0i, select(select(i32(_e515), i32(-2147483648), (_e515 < -2147483600f)), 2147483647i, (_e515 > 2147483500f)), (_e515 == _e515));
let _e713 = select(0i, select(select(i32(_e526), i32(-2147483648), (_e526 < -2147483600f)), 2147483647i, (_e526 > 2147483500f)), (_e526 == _e526));
let _e720 = select(0i, select(select(i32(_e537), i32(-2147483648), (_e537 < -2147483600f)), 2147483647i, (_e537 > 2147483500f)), (_e537 == _e537));
if (_e471 == 0f) {
let _e728 = global_5.member.member_11.member_2;
let _e735 = global_5.member.member_11.member_3;
let _e742 = global_5.member.member_11.member_5;
let _e748 = global_5.member.member_11.member_7;
let _e750 = (_e742 + ((f32(bitcast<i32>(_e120.x)) + 0.5f) * _e748));
let _e754 = global_5.member.member_11.member_6;
let _e760 = global_5.member.member_11.member_8;
let _e762 = (_e754 + ((f32(bitcast<i32>(_e120.y)) + 0.5f) * _e760));
let _e763 = (_e728.member * _e748);
let _e764 = (_e728.member_1 * _e748);
let _e765 = (_e728.member_2 * _e748);
let _e766 = (_e735.member * _e760);
let _e767 = (_e735.member_1 * _e760);
let _e768 = (_e735.member_2 * _e760);
let _e775 = ((_e728.member * _e750) + (_e735.member * _e762));
let _e776 = ((_e728.member_1 * _e750) + (_e735.member_1 * _e762));
let _e777 = ((_e728.member_2 * _e750) + (_e735.member_2 * _e762));
let _e781 = global_5.member.member_11.member_4;
let _e788 = global_5.member.member_11.member_1;
let _e795 = global_5.member.member_10.member;
let _e796 = (_e795 == 0u);
let _e797 = (_e788.member + _e775);
let _e798 = (_e788.member_1 + _e776);
let _e799 = (_e788.member_2 + _e777);
let _e804 = (((_e797 * _e797) + (_e798 * _e798)) + (_e799 * _e799));
let _e808 = (1f / sqrt(select(0f, _e804, (_e804 > 0f))));
let _e812 = select((_e797 * _e808), _e788.member, _e796);
let _e813 = select((_e798 * _e808), _e788.member_1, _e796);
let _e814 = select((_e799 * _e808), _e788.member_2, _e796);
let _e819 = select(_e781.member, (_e781.member + _e775), _e796);
let _e820 = select(_e781.member_1, (_e781.member_1 + _e776), _e796);
let _e821 = select(_e781.member_2, (_e781.member_2 + _e777), _e796);
let _e835 = (((_e763 * _e812) + (_e764 * _e813)) + (_e765 * _e814));
let _e845 = select(((_e763 - (_e812 * _e835)) * _e808), 0f, _e796);
let _e846 = select(((_e764 - (_e813 * _e835)) * _e808), 0f, _e796);
let _e847 = select(((_e765 - (_e814 * _e835)) * _e808), 0f, _e796);
let _e853 = (((_e766 * _e812) + (_e767 * _e813)) + (_e768 * _e814));
let _e863 = select(((_e766 - (_e812 * _e853)) * _e808), 0f, _e796);
let _e864 = select(((_e767 - (_e813 * _e853)) * _e808), 0f, _e796);
let _e865 = select(((_e768 - (_e814 * _e853)) * _e808), 0f, _e796);
let _e874 = (1f / select(_e812, select(1e-12f, -1e-12f, (_e812 < 0f)), (bitcast<f32>((bitcast<u32>(_e812) & 2147483647u)) < 1e-12f)));
let _e882 = (1f / select(_e813, select(1e-12f, -1e-12f, (_e813 < 0f)), (bitcast<f32>((bitcast<u32>(_e813) & 2147483647u)) < 1e-12f)));
let _e890 = (1f / select(_e814, select(1e-12f, -1e-12f, (_e814 < 0f)), (bitcast<f32>((bitcast<u32>(_e814) & 2147483647u)) < 1e-12f)));
let _e893 = global_5.member.member_8;
let _e899 = global_5.member.member_9;
let _e904 = ((_e893.member - _e819) * _e874);
let _e906 = ((_e899.member - _e819) * _e874);
let _e908 = ((_e893.member_1 - _e820) * _e882);
let _e910 = ((_e899.member_1 - _e820) * _e882);
let _e912 = ((_e893.member_2 - _e821) * _e890);
let _e914 = ((_e899.member_2 - _e821) * _e890);
let _e916 = select(_e906, _e904, (_e904 < _e906));
let _e918 = select(_e910, _e908, (_e908 < _e910));
let _e920 = select(_e918, _e916, (_e916 > _e918));
let _e922 = select(_e914, _e912, (_e912 < _e914));
let _e924 = select(_e922, _e920, (_e920 > _e922));
let _e926 = select(_e906, _e904, (_e904 > _e906));
let _e928 = select(_e910, _e908, (_e908 > _e910));
let _e930 = select(_e928, _e926, (_e926 < _e928));
let _e932 = select(_e914, _e912, (_e912 > _e914));
if (true && _e796) {
phi_1742_ = -(1e30f);
} else {
phi_1742_ = 0f;
}
let _e938 = phi_1742_;
let _e940 = select(_e938, _e924, (_e924 > _e938));
let _e942 = ((select(_e932, _e930, (_e930 < _e932)) <= _e940) || false);
let _e943 = select(_e940, 0f, _e942);
let _e944 = (_e812 * _e943);
let _e945 = (_e813 * _e943);
let _e946 = (_e814 * _e943);
let _e947 = (_e819 + _e944);
let _e948 = (_e820 + _e945);
let _e949 = (_e821 + _e946);
let _e966 = global_5.member.member_14.member.member;
let _e977 = ((((_e966.member.member * _e947) + (_e966.member.member_1 * _e948)) + (_e966.member.member_2 * _e949)) + _e966.member_1);
let _e983 = -((((_e966.member.member * _e812) + (_e966.member.member_1 * _e813)) + (_e966.member.member_2 * _e814)));
let _e985 = (_e983 > 1e-9f);
let _e989 = ((_e977 / select(1e-9f, _e983, _e985)) - 0.015625f);
let _e992 = select(1e30f, select(0f, _e989, (_e989 > 0f)), ((_e977 > 0f) && _e985));
let _e997 = global_5.member.member_14.member_1.member;
let _e1008 = ((((_e997.member.member * _e947) + (_e997.member.member_1 * _e948)) + (_e997.member.member_2 * _e949)) + _e997.member_1);
let _e1014 = -((((_e997.member.member * _e812) + (_e997.member.member_1 * _e813)) + (_e997.member.member_2 * _e814)));
let _e1016 = (_e1014 > 1e-9f);
let _e1020 = ((_e1008 / select(1e-9f, _e1014, _e1016)) - 0.015625f);
let _e1023 = select(1e30f, select(0f, _e1020, (_e1020 > 0f)), ((_e1008 > 0f) && _e1016));
let _e1027 = (_e1023 < _e992);
let _e1031 = type_25((vec3<f32>(_e819, _e820, _e821) + vec3<f32>(_e944, _e945, _e946)), vec3<f32>(_e812, _e813, _e814), (vec3<f32>(select(0f, _e763, _e796), select(0f, _e764, _e796), select(0f, _e765, _e796)) + vec3<f32>((_e845 * _e943), (_e846 * _e943), (_e847 * _e943))), (vec3<f32>(select(0f, _e766, _e796), select(0f, _e767, _e796), select(0f, _e768, _e796)) + vec3<f32>((_e863 * _e943), (_e864 * _e943), (_e865 * _e943))), vec3<f32>(_e845, _e846, _e847), vec3<f32>(_e863, _e864, _e865), vec3<f32>(1f, 1f, 1f), 0i, 0i, select(select(-2i, -3i, _e1027), -1i, ((_e992 >= 1e30f) && (_e1023 >= 1e30f))), select(_e992, _e1023, _e1027), 0i, 0i, 0f, _e460, 1f, 0i, _e692, _e699, _e706, _e713, _e720, _e610, _e559, _e570, _e581, _e592, _e603);
let _e1035 = global_5.member.member_13.member_4;
let _e1042 = global_5.member.member_13.member_5;
let _e1047 = ((_e1035.member - _e819) * _e874);
let _e1049 = ((_e1042.member - _e819) * _e874);
let _e1051 = ((_e1035.member_1 - _e820) * _e882);
let _e1053 = ((_e1042.member_1 - _e820) * _e882);
let _e1055 = ((_e1035.member_2 - _e821) * _e890);
let _e1057 = ((_e1042.member_2 - _e821) * _e890);
let _e1059 = select(_e1049, _e1047, (_e1047 < _e1049));
let _e1061 = select(_e1053, _e1051, (_e1051 < _e1053));
let _e1063 = select(_e1061, _e1059, (_e1059 > _e1061));
let _e1065 = select(_e1057, _e1055, (_e1055 < _e1057));
let _e1067 = select(_e1065, _e1063, (_e1063 > _e1065));
let _e1069 = select(_e1049, _e1047, (_e1047 > _e1049));
let _e1071 = select(_e1053, _e1051, (_e1051 > _e1053));
let _e1073 = select(_e1071, _e1069, (_e1069 < _e1071));
let _e1075 = select(_e1057, _e1055, (_e1055 > _e1057));
let _e1077 = select(_e1075, _e1073, (_e1073 < _e1075));
let _e1079 = select(_e938, _e1067, (_e1067 > _e938));
let _e1081 = select(_e943, _e1077, (_e1077 < _e943));
let _e1082 = (_e1081 > _e1079);
let _e1085 = (select(_e938, _e1081, _e1082) - select(_e938, _e1079, _e1082));
let _e1089 = global_5.member.member_13.member;
let _e1094 = -((_e1089.member * _e1085));
let _e1096 = select(-87f, _e1094, (_e1094 > -87f));
let _e1098 = select(88f, _e1096, (_e1096 < 88f));
let _e1100 = ((_e1098 * 1.442695f) + 0.5f);
let _e1102 = select(-127f, _e1100, (_e1100 > -127f));
let _e1104 = select(128f, _e1102, (_e1102 < 128f));
let _e1111 = select(0i, select(select(i32(_e1104), i32(-2147483648), (_e1104 < -2147483600f)), 2147483647i, (_e1104 > 2147483500f)), (_e1104 == _e1104));
let _e1115 = (_e1111 - select(0i, 1i, (_e1104 < f32(_e1111))));
let _e1116 = f32(_e1115);
let _e1120 = ((_e1098 - (_e1116 * 0.6933594f)) - (_e1116 * -2.1219444e-4f));
let _e1142 = -((_e1089.member_1 * _e1085));
let _e1144 = select(-87f, _e1142, (_e1142 > -87f));
let _e1146 = select(88f, _e1144, (_e1144 < 88f));
let _e1148 = ((_e1146 * 1.442695f) + 0.5f);
let _e1150 = select(-127f, _e1148, (_e1148 > -127f));
let _e1152 = select(128f, _e1150, (_e1150 < 128f));
let _e1159 = select(0i, select(select(i32(_e1152), i32(-2147483648), (_e1152 < -2147483600f)), 2147483647i, (_e1152 > 2147483500f)), (_e1152 == _e1152));
let _e1163 = (_e1159 - select(0i, 1i, (_e1152 < f32(_e1159))));
let _e1164 = f32(_e1163);
let _e1168 = ((_e1146 - (_e1164 * 0.6933594f)) - (_e1164 * -2.1219444e-4f));
let _e1190 = -((_e1089.member_2 * _e1085));
let _e1192 = select(-87f, _e1190, (_e1190 > -87f));
let _e1194 = select(88f, _e1192, (_e1192 < 88f));
let _e1196 = ((_e1194 * 1.442695f) + 0.5f);
let _e1198 = select(-127f, _e1196, (_e1196 > -127f));
let _e1200 = select(128f, _e1198, (_e1198 < 128f));
let _e1207 = select(0i, select(select(i32(_e1200), i32(-2147483648), (_e1200 < -2147483600f)), 2147483647i, (_e1200 > 2147483500f)), (_e1200 == _e1200));
let _e1211 = (_e1207 - select(0i, 1i, (_e1200 < f32(_e1207))));
let _e1212 = f32(_e1211);
let _e1216 = ((_e1194 - (_e1212 * 0.6933594f)) - (_e1212 * -2.1219444e-4f));
let _e1239 = (1f / 3f);
let _e1241 = (1f * ((1f + (_e1120 * (1f + (_e1120 * (0.5f + (_e1120 * (0.16666667f + (_e1120 * (0.041666668f + (_e1120 * (0.008333334f + (_e1120 * (0.001388889f + (_e1120 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1115 + 127i)) << bitcast<u32>(23i)))));
let _e1242 = (1f * ((1f + (_e1168 * (1f + (_e1168 * (0.5f + (_e1168 * (0.16666667f + (_e1168 * (0.041666668f + (_e1168 * (0.008333334f + (_e1168 * (0.001388889f + (_e1168 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1163 + 127i)) << bitcast<u32>(23i)))));
let _e1243 = (1f * ((1f + (_e1216 * (1f + (_e1216 * (0.5f + (_e1216 * (0.16666667f + (_e1216 * (0.041666668f + (_e1216 * (0.008333334f + (_e1216 * (0.001388889f + (_e1216 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1211 + 127i)) << bitcast<u32>(23i)))));
let _e1272 = type_25(_e1031.member, _e1031.member_1, _e1031.member_2, _e1031.member_3, _e1031.member_4, _e1031.member_5, vec3<f32>(_e1241, _e1242, _e1243), _e1031.member_7, _e1031.member_8, _e1031.member_9, _e1031.member_10, _e1031.member_11, _e1031.member_12, _e1031.member_13, _e1031.member_14, _e1031.member_15, _e1031.member_16, _e1031.member_17, _e1031.member_18, _e1031.member_19, _e1031.member_20, _e1031.member_21, _e1031.member_22, _e1031.member_23, _e1031.member_24, _e1031.member_25, _e1031.member_26, _e1031.member_27);
if (bitcast<i32>(countOneBits(0u)) == _e713) {
phi_2378_ = ((((1f + 1f) + 1f) * _e1239) - (((_e1241 + _e1242) + _e1243) * _e1239));
} else {
phi_2378_ = 0f;
}
let _e1281 = phi_2378_;
let _e1310 = type_25(_e1272.member, _e1272.member_1, _e1272.member_2, _e1272.member_3, _e1272.member_4, _e1272.member_5, _e1272.member_6, _e1272.member_7, _e1272.member_8, _e1272.member_9, _e1272.member_10, _e1272.member_11, _e1272.member_12, _e1272.member_13, _e1272.member_14, _e1272.member_15, _e1272.member_16, _e1272.member_17, _e1272.member_18, _e1272.member_19, _e1272.member_20, _e1272.member_21, _e1272.member_22, _e1272.member_23, _e1272.member_24, _e1272.member_25, (_e592 + _e1281), _e1272.member_27);
if _e942 {
let _e1340 = type_25(_e1310.member, _e1310.member_1, _e1310.member_2, _e1310.member_3, _e1310.member_4, _e1310.member_5, _e1310.member_6, _e1310.member_7, (bitcast<i32>(_e122) / 8i), _e1310.member_9, _e1310.member_10, _e1310.member_11, _e1310.member_12, _e1310.member_13, _e1310.member_14, _e1310.member_15, _e1310.member_16, _e1310.member_17, _e1310.member_18, _e1310.member_19, _e1310.member_20, _e1310.member_21, _e1310.member_22, _e1310.member_23, _e1310.member_24, _e1310.member_25, _e1310.member_26, _e1310.member_27);
phi_2405_ = type_25(_e1340.member, _e1340.member_1, _e1340.member_2, _e1340.member_3, _e1340.member_4, _e1340.member_5, _e1340.member_6, _e1340.member_7, _e1340.member_8, _e1340.member_9, _e1340.member_10, _e1340.member_11, _e1340.member_12, _e1340.member_13, _e1340.member_14, 3f, _e1340.member_16, _e1340.member_17, _e1340.member_18, _e1340.member_19, _e1340.member_20, _e1340.member_21, _e1340.member_22, _e1340.member_23, _e1340.member_24, _e1340.member_25, _e1340.member_26, _e1340.member_27);
} else {
phi_2405_ = _e1310;
}
let _e1370 = phi_2405_;
phi_2406_ = _e1370;
} else {
phi_2406_ = type_25(vec3<f32>(_e153, _e163, _e174), vec3<f32>(_e185, _e196, _e207), vec3<f32>(_e218, _e229, _e240), vec3<f32>(_e251, _e262, _e273), vec3<f32>(_e284, _e295, _e306), vec3<f32>(_e317, _e328, _e339), vec3<f32>(_e350, _e361, _e372), select(0i, select(select(i32(_e383), i32(-2147483648), (_e383 < -2147483600f)), 2147483647i, (_e383 > 2147483500f)), (_e383 == _e383)), select(0i, select(select(i32(_e394), i32(-2147483648), (_e394 < -2147483600f)), 2147483647i, (_e394 > 2147483500f)), (_e394 == _e394)), select(0i, select(select(i32(_e405), i32(-2147483648), (_e405 < -2147483600f)), 2147483647i, (_e405 > 2147483500f)), (_e405 == _e405)), _e416, select(0i, select(select(i32(_e427), i32(-2147483648), (_e427 < -2147483600f)), 2147483647i, (_e427 > 2147483500f)), (_e427 == _e427)), select(0i, select(select(i32(_e438), i32(-2147483648), (_e438 < -2147483600f)), 2147483647i, (_e438 > 2147483500f)), (_e438 == _e438)), _e449, _e460, _e471, select(0i, select(select(i32(_e482), i32(-2147483648), (_e482 < -2147483600f)), 2147483647i, (_e482 > 2147483500f)), (_e482 == _e482)), _e692, _e699, _e706, _e713, _e720, _e610, _e559, _e570, _e581, _e592, _e603);
}
let _e1372 = phi_2406_;
let _e1373 = bitcast<i32>(_e122);
let _e1374 = (_e1373 / 8i);
let _e1376 = (_e1372.member_15 == 2f);
if _e1376 {
phi_2426_ = type_25(_e1372.member, _e1372.member_1, _e1372.member_2, _e1372.member_3, _e1372.member_4, _e1372.member_5, _e1372.member_6, _e1372.member_7, _e1372.member_8, _e1372.member_9, _e1372.member_10, _e1372.member_11, _e1372.member_12, _e1372.member_13, _e1372.member_14, 1f, _e1372.member_16, _e1372.member_17, _e1372.member_18, _e1372.member_19, _e1372.member_20, _e1372.member_21, _e1372.member_22, _e1372.member_23, _e1372.member_24, _e1372.member_25, _e1372.member_26, _e1372.member_27);
} else {
phi_2426_ = _e1372;
}
let _e1406 = phi_2426_;
phi_2428_ = _e1406;
phi_2431_ = 0i;
phi_2433_ = _e1376;
loop {
let _e1408 = phi_2428_;
let _e1410 = phi_2431_;
let _e1412 = phi_2433_;
local_10 = _e1408;
local_11 = _e1408;
local_12 = _e1408;
local_13 = _e1408;
local_14 = _e1408;
local_15 = _e1408;
local_16 = _e1408;
local_17 = _e1408;
local_18 = _e1408;
local_19 = _e1408;
local_20 = _e1408;
local_21 = _e1408;
local_22 = _e1408;
local_23 = _e1408;
local_24 = _e1408;
local_25 = _e1408;
local_26 = _e1408;
local_27 = _e1408;
local_28 = _e1408;
local_29 = _e1408;
local_30 = _e1408;
local_31 = _e1408;
local_32 = _e1408;
local_33 = _e1408;
local_34 = _e1408;
local_35 = _e1408;
local_36 = _e1408;
local_37 = _e1408;
local_38 = _e1408;
local_39 = _e1408;
local_40 = _e1408;
local_41 = _e1408;
local_42 = _e1408;
local_43 = _e1408;
local_44 = _e1408;
local_45 = _e1408;
local_46 = _e1408;
local_47 = _e1408;
local_48 = _e1408;
local_49 = _e1408;
local_50 = _e1408;
let _e1416 = ((_e1410 < 1024i) && (_e1408.member_15 == 1f));
local_51 = _e1408.member_15;
if _e1416 {
if (_e1408.member_8 < _e1374) {
let _e7271 = f32(_e1408.member_11);
let _e7273 = f32(_e1408.member_12);
let _e7275 = vec3<f32>(_e7271, _e7273, _e1408.member_13);
let _e7277 = (_e1408.member_9 >= 0i);
if _e7277 {
let _e7278 = (_e1408.member_9 * 19i);
let _e7280 = (bitcast<i32>(_e124) - 1i);
let _e7282 = select(_e7280, _e7278, (_e7278 < _e7280));
let _e7288 = global_2.member[bitcast<u32>(select(0i, _e7282, (_e7282 > 0i)))];
let _e7289 = (_e7278 + 1i);
let _e7291 = select(_e7280, _e7289, (_e7289 < _e7280));
let _e7297 = global_2.member[bitcast<u32>(select(0i, _e7291, (_e7291 > 0i)))];
let _e7298 = (_e7278 + 2i);
let _e7300 = select(_e7280, _e7298, (_e7298 < _e7280));
let _e7306 = global_2.member[bitcast<u32>(select(0i, _e7300, (_e7300 > 0i)))];
let _e7307 = (_e7278 + 3i);
let _e7309 = select(_e7280, _e7307, (_e7307 < _e7280));
let _e7315 = global_2.member[bitcast<u32>(select(0i, _e7309, (_e7309 > 0i)))];
let _e7316 = (_e7278 + 4i);
let _e7318 = select(_e7280, _e7316, (_e7316 < _e7280));
let _e7324 = global_2.member[bitcast<u32>(select(0i, _e7318, (_e7318 > 0i)))];
let _e7325 = (_e7278 + 5i);
let _e7327 = select(_e7280, _e7325, (_e7325 < _e7280));
let _e7333 = global_2.member[bitcast<u32>(select(0i, _e7327, (_e7327 > 0i)))];
let _e7334 = (_e7315 - _e7288);
let _e7335 = (_e7324 - _e7297);
let _e7336 = (_e7333 - _e7306);
let _e7337 = (_e7278 + 6i);
let _e7339 = select(_e7280, _e7337, (_e7337 < _e7280));
let _e7345 = global_2.member[bitcast<u32>(select(0i, _e7339, (_e7339 > 0i)))];
let _e7346 = (_e7278 + 7i);
let _e7348 = select(_e7280, _e7346, (_e7346 < _e7280));
let _e7354 = global_2.member[bitcast<u32>(select(0i, _e7348, (_e7348 > 0i)))];
let _e7355 = (_e7278 + 8i);
let _e7357 = select(_e7280, _e7355, (_e7355 < _e7280));
let _e7363 = global_2.member[bitcast<u32>(select(0i, _e7357, (_e7357 > 0i)))];
let _e7364 = (_e7345 - _e7288);
let _e7365 = (_e7354 - _e7297);
let _e7366 = (_e7363 - _e7306);
let _e7369 = ((_e7335 * _e7366) - (_e7336 * _e7365));
let _e7372 = ((_e7336 * _e7364) - (_e7334 * _e7366));
let _e7375 = ((_e7334 * _e7365) - (_e7335 * _e7364));
let _e7380 = (((_e7369 * _e7369) + (_e7372 * _e7372)) + (_e7375 * _e7375));
let _e7383 = sqrt(select(0f, _e7380, (_e7380 > 0f)));
let _e7386 = (1f / select(1e-20f, _e7383, (_e7383 > 1e-20f)));
phi_2659_ = (((_e1408.member_1.x * (_e7369 * _e7386)) + (_e1408.member_1.y * (_e7372 * _e7386))) + (_e1408.member_1.z * (_e7375 * _e7386)));
} else {
phi_2659_ = 1f;
}
let _e7399 = phi_2659_;
let _e7406 = select(0i, select(select(i32(_e7271), i32(-2147483648), (_e7271 < -2147483600f)), 2147483647i, (_e7271 > 2147483500f)), (_e7271 == _e7271));
let _e7413 = select(0i, select(select(i32(_e7273), i32(-2147483648), (_e7273 < -2147483600f)), 2147483647i, (_e7273 > 2147483500f)), (_e7273 == _e7273));
let _e7416 = bitcast<f32>((bitcast<u32>(_e7399) & 2147483647u));
let _e7418 = select(1e-3f, _e7416, (_e7416 > 1e-3f));
let _e7419 = type_26(_e7406, _e7413, _e1408.member_13, _e1408.member_14, _e7418);
let _e7424 = global_5.member.member_12.member;
let _e7427 = (_e1408.member_10 + select(0f, (_e7424 / _e7418), _e7277));
let _e7431 = (_e1408.member_8 * 8i);
let _e7434 = bitcast<f32>((bitcast<u32>(_e1408.member_1.x) & 2147483647u));
let _e7439 = (1f / select(_e1408.member_1.x, select(1e-12f, -1e-12f, (_e1408.member_1.x < 0f)), (_e7434 < 1e-12f)));
let _e7442 = bitcast<f32>((bitcast<u32>(_e1408.member_1.y) & 2147483647u));
let _e7447 = (1f / select(_e1408.member_1.y, select(1e-12f, -1e-12f, (_e1408.member_1.y < 0f)), (_e7442 < 1e-12f)));
let _e7450 = bitcast<f32>((bitcast<u32>(_e1408.member_1.z) & 2147483647u));
let _e7455 = (1f / select(_e1408.member_1.z, select(1e-12f, -1e-12f, (_e1408.member_1.z < 0f)), (_e7450 < 1e-12f)));
let _e7456 = (_e1373 - 1i);
let _e7458 = select(_e7456, _e7431, (_e7431 < _e7456));
let _e7464 = global_1.member[bitcast<u32>(select(0i, _e7458, (_e7458 > 0i)))];
let _e7465 = (_e7431 + 1i);
let _e7467 = select(_e7456, _e7465, (_e7465 < _e7456));
let _e7473 = global_1.member[bitcast<u32>(select(0i, _e7467, (_e7467 > 0i)))];
let _e7474 = (_e7431 + 2i);
let _e7476 = select(_e7456, _e7474, (_e7474 < _e7456));
let _e7482 = global_1.member[bitcast<u32>(select(0i, _e7476, (_e7476 > 0i)))];
let _e7483 = (_e7431 + 3i);
let _e7485 = select(_e7456, _e7483, (_e7483 < _e7456));
let _e7491 = global_1.member[bitcast<u32>(select(0i, _e7485, (_e7485 > 0i)))];
let _e7492 = (_e7431 + 4i);
let _e7494 = select(_e7456, _e7492, (_e7492 < _e7456));
let _e7500 = global_1.member[bitcast<u32>(select(0i, _e7494, (_e7494 > 0i)))];
let _e7501 = (_e7431 + 5i);
let _e7503 = select(_e7456, _e7501, (_e7501 < _e7456));
let _e7509 = global_1.member[bitcast<u32>(select(0i, _e7503, (_e7503 > 0i)))];
let _e7512 = ((_e7464 - _e1408.member.x) * _e7439);
let _e7514 = ((_e7491 - _e1408.member.x) * _e7439);
let _e7517 = ((_e7473 - _e1408.member.y) * _e7447);
let _e7519 = ((_e7500 - _e1408.member.y) * _e7447);
let _e7522 = ((_e7482 - _e1408.member.z) * _e7455);
let _e7524 = ((_e7509 - _e1408.member.z) * _e7455);
let _e7526 = select(_e7514, _e7512, (_e7512 < _e7514));
let _e7528 = select(_e7519, _e7517, (_e7517 < _e7519));
let _e7530 = select(_e7528, _e7526, (_e7526 > _e7528));
let _e7532 = select(_e7524, _e7522, (_e7522 < _e7524));
let _e7536 = select(_e7514, _e7512, (_e7512 > _e7514));
let _e7538 = select(_e7519, _e7517, (_e7517 > _e7519));
let _e7540 = select(_e7538, _e7536, (_e7536 < _e7538));
let _e7542 = select(_e7524, _e7522, (_e7522 > _e7524));
let _e7544 = select(_e7542, _e7540, (_e7540 < _e7542));
let _e7549 = ((select(_e7532, _e7530, (_e7530 > _e7532)) <= select(_e7427, _e7544, (_e7544 < _e7427))) && (_e7544 >= _e1408.member_13));
let _e7550 = (_e7431 + 6i);
let _e7552 = select(_e7456, _e7550, (_e7550 < _e7456));
let _e7558 = global_1.member[bitcast<u32>(select(0i, _e7552, (_e7552 > 0i)))];
if _e7549 {
phi_2972_ = (_e1408.member_8 + 1i);
} else {
let _e7566 = (_e7431 + 7i);
let _e7568 = select(_e7456, _e7566, (_e7566 < _e7456));
let _e7574 = global_1.member[bitcast<u32>(select(0i, _e7568, (_e7568 > 0i)))];
phi_2972_ = select(0i, select(select(i32(_e7574), i32(-2147483648), (_e7574 < -2147483600f)), 2147483647i, (_e7574 > 2147483500f)), (_e7574 == _e7574));
}
let _e7584 = phi_2972_;
let _e7585 = type_17(_e1408.member, _e1408.member_1, vec3<f32>(1f, 1f, 1f), vec3<f32>(0f, 0f, 0f), _e7275, _e1408.member_14, 0f, 16i, 0f, 0f, 0f, 0f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), 0i, _e7584, _e1408.member_9, _e1408.member_10);
let _e7586 = select(-1i, select(0i, select(select(i32(_e7558), i32(-2147483648), (_e7558 < -2147483600f)), 2147483647i, (_e7558 > 2147483500f)), (_e7558 == _e7558)), _e7549);
if (_e7586 < 0i) {
phi_3752_ = type_26();
phi_3753_ = type_17();
phi_3754_ = true;
} else {
let _e7590 = ((_e7434 >= _e7442) && (_e7434 >= _e7450));
let _e7593 = (!(_e7590) && (_e7442 >= _e7450));
let _e7600 = (1f / select(select(_e1408.member_1.z, _e1408.member_1.y, _e7593), _e1408.member_1.x, _e7590));
let _e7601 = (select(select(_e1408.member_1.x, _e1408.member_1.z, _e7593), _e1408.member_1.y, _e7590) * _e7600);
let _e7602 = (select(select(_e1408.member_1.y, _e1408.member_1.x, _e7593), _e1408.member_1.z, _e7590) * _e7600);
let _e7603 = (_e7586 * 19i);
let _e7605 = (bitcast<i32>(_e124) - 1i);
let _e7607 = select(_e7605, _e7603, (_e7603 < _e7605));
let _e7613 = global_2.member[bitcast<u32>(select(0i, _e7607, (_e7607 > 0i)))];
let _e7614 = (_e7603 + 1i);
let _e7616 = select(_e7605, _e7614, (_e7614 < _e7605));
let _e7622 = global_2.member[bitcast<u32>(select(0i, _e7616, (_e7616 > 0i)))];
let _e7623 = (_e7603 + 2i);
let _e7625 = select(_e7605, _e7623, (_e7623 < _e7605));
let _e7631 = global_2.member[bitcast<u32>(select(0i, _e7625, (_e7625 > 0i)))];
let _e7632 = (_e7613 - _e1408.member.x);
let _e7633 = (_e7622 - _e1408.member.y);
let _e7634 = (_e7631 - _e1408.member.z);
let _e7640 = select(select(_e7634, _e7633, _e7593), _e7632, _e7590);
let _e7642 = (select(select(_e7632, _e7634, _e7593), _e7633, _e7590) - (_e7601 * _e7640));
let _e7644 = (select(select(_e7633, _e7632, _e7593), _e7634, _e7590) - (_e7602 * _e7640));
let _e7646 = (_e7603 + 3i);
let _e7648 = select(_e7605, _e7646, (_e7646 < _e7605));
let _e7654 = global_2.member[bitcast<u32>(select(0i, _e7648, (_e7648 > 0i)))];
let _e7655 = (_e7603 + 4i);
let _e7657 = select(_e7605, _e7655, (_e7655 < _e7605));
let _e7663 = global_2.member[bitcast<u32>(select(0i, _e7657, (_e7657 > 0i)))];
let _e7664 = (_e7603 + 5i);
let _e7666 = select(_e7605, _e7664, (_e7664 < _e7605));
let _e7672 = global_2.member[bitcast<u32>(select(0i, _e7666, (_e7666 > 0i)))];
let _e7673 = (_e7654 - _e1408.member.x);
let _e7674 = (_e7663 - _e1408.member.y);
let _e7675 = (_e7672 - _e1408.member.z);
let _e7681 = select(select(_e7675, _e7674, _e7593), _e7673, _e7590);
let _e7683 = (select(select(_e7673, _e7675, _e7593), _e7674, _e7590) - (_e7601 * _e7681));
let _e7685 = (select(select(_e7674, _e7673, _e7593), _e7675, _e7590) - (_e7602 * _e7681));
let _e7687 = (_e7603 + 6i);
let _e7689 = select(_e7605, _e7687, (_e7687 < _e7605));
let _e7695 = global_2.member[bitcast<u32>(select(0i, _e7689, (_e7689 > 0i)))];
let _e7696 = (_e7603 + 7i);
let _e7698 = select(_e7605, _e7696, (_e7696 < _e7605));
let _e7704 = global_2.member[bitcast<u32>(select(0i, _e7698, (_e7698 > 0i)))];
let _e7705 = (_e7603 + 8i);
let _e7707 = select(_e7605, _e7705, (_e7705 < _e7605));
let _e7713 = global_2.member[bitcast<u32>(select(0i, _e7707, (_e7707 > 0i)))];
let _e7714 = (_e7695 - _e1408.member.x);
let _e7715 = (_e7704 - _e1408.member.y);
let _e7716 = (_e7713 - _e1408.member.z);
let _e7722 = select(select(_e7716, _e7715, _e7593), _e7714, _e7590);
let _e7724 = (select(select(_e7714, _e7716, _e7593), _e7715, _e7590) - (_e7601 * _e7722));
let _e7726 = (select(select(_e7715, _e7714, _e7593), _e7716, _e7590) - (_e7602 * _e7722));
let _e7730 = ((_e7724 * _e7685) - (_e7726 * _e7683));
let _e7733 = ((_e7642 * _e7726) - (_e7644 * _e7724));
let _e7736 = ((_e7683 * _e7644) - (_e7685 * _e7642));
let _e7738 = ((_e7730 + _e7733) + _e7736);
let _e7752 = (!(((((_e7730 < 0f) || (_e7733 < 0f)) || (_e7736 < 0f)) && (((_e7730 > 0f) || (_e7733 > 0f)) || (_e7736 > 0f)))) && (_e7738 != 0f));
let _e7760 = select(1e30f, ((((_e7730 * (_e7640 * _e7600)) + (_e7733 * (_e7681 * _e7600))) + (_e7736 * (_e7722 * _e7600))) / select(1f, _e7738, _e7752)), _e7752);
if (_e7760 >= _e7427) {
phi_3746_ = type_26();
phi_3747_ = type_17();
phi_3748_ = true;
} else {
let _e7762 = (_e7654 - _e7613);
let _e7763 = (_e7663 - _e7622);
let _e7764 = (_e7672 - _e7631);
let _e7765 = (_e7695 - _e7613);
let _e7766 = (_e7704 - _e7622);
let _e7767 = (_e7713 - _e7631);
let _e7770 = ((_e7763 * _e7767) - (_e7764 * _e7766));
let _e7773 = ((_e7764 * _e7765) - (_e7762 * _e7767));
let _e7776 = ((_e7762 * _e7766) - (_e7763 * _e7765));
let _e7781 = (((_e7770 * _e7770) + (_e7773 * _e7773)) + (_e7776 * _e7776));
let _e7784 = sqrt(select(0f, _e7781, (_e7781 > 0f)));
let _e7787 = (1f / select(1e-20f, _e7784, (_e7784 > 1e-20f)));
let _e7795 = (((_e1408.member_1.x * (_e7770 * _e7787)) + (_e1408.member_1.y * (_e7773 * _e7787))) + (_e1408.member_1.z * (_e7776 * _e7787)));
let _e7798 = bitcast<f32>((bitcast<u32>(_e7795) & 2147483647u));
let _e7800 = select(1e-3f, _e7798, (_e7798 > 1e-3f));
let _e7801 = (_e7603 + 18i);
let _e7803 = select(_e7605, _e7801, (_e7801 < _e7605));
let _e7809 = global_2.member[bitcast<u32>(select(0i, _e7803, (_e7803 > 0i)))];
let _e7816 = select(0i, select(select(i32(_e7809), i32(-2147483648), (_e7809 < -2147483600f)), 2147483647i, (_e7809 > 2147483500f)), (_e7809 == _e7809));
let _e7817 = (_e7816 * 4i);
let _e7819 = (bitcast<i32>(_e126) - 1i);
let _e7821 = select(_e7819, _e7817, (_e7817 < _e7819));
let _e7827 = global_3.member[bitcast<u32>(select(0i, _e7821, (_e7821 > 0i)))];
let _e7829 = select(_e7827, 1f, (_e7816 == 16i));
let _e7830 = (_e7829 <= 0f);
if _e7830 {
phi_3583_ = 0i;
} else {
phi_3583_ = (1i << bitcast<u32>((_e7816 & 31i)));
}
let _e7835 = phi_3583_;
let _e7836 = (_e7795 < 0f);
let _e7837 = select(_e7835, 0i, _e7836);
let _e7838 = select(0i, _e7835, _e7836);
let _e7847 = (_e7760 * _e7800);
let _e7860 = (((_e7760 > _e1408.member_13) && (_e1408.member_13 > 0f)) || (((_e7847 > (_e7424 * 2f)) || ((((_e7829 == 0f) || ((_e7838 & ~(_e1408.member_7)) != 0i)) || ((_e7837 & _e1408.member_7) != 0i)) && (_e7847 >= -((_e7424 * 0.5f))))) && (_e1408.member_13 <= 0f)));
if _e7860 {
let _e7861 = (_e7760 < _e1408.member_10);
if (_e7277 && ((bitcast<f32>((bitcast<u32>((_e7760 - _e1408.member_10)) & 2147483647u)) * select(_e7418, _e7800, (_e7800 > _e7418))) <= _e7424)) {
let _e7880 = ((_e1408.member_9 * 19i) + 18i);
let _e7882 = select(_e7605, _e7880, (_e7880 < _e7605));
let _e7888 = global_2.member[bitcast<u32>(select(0i, _e7882, (_e7882 > 0i)))];
let _e7895 = select(0i, select(select(i32(_e7888), i32(-2147483648), (_e7888 < -2147483600f)), 2147483647i, (_e7888 > 2147483500f)), (_e7888 == _e7888));
let _e7896 = (_e7895 * 4i);
let _e7898 = select(_e7819, _e7896, (_e7896 < _e7819));
let _e7904 = global_3.member[bitcast<u32>(select(0i, _e7898, (_e7898 > 0i)))];
if (_e7830 != (select(_e7904, 1f, (_e7895 == 16i)) <= 0f)) {
phi_3728_ = _e7830;
} else {
if (!(_e7830) && (_e7816 != _e7895)) {
phi_3727_ = (_e7816 < _e7895);
} else {
phi_3727_ = _e7861;
}
let _e7914 = phi_3727_;
phi_3728_ = _e7914;
}
let _e7916 = phi_3728_;
phi_3734_ = type_26((_e7406 | _e7838), (_e7413 | _e7837), _e1408.member_13, select(_e7760, _e1408.member_14, (_e1408.member_14 > _e7760)), _e7418);
phi_3735_ = _e7916;
} else {
if _e7861 {
phi_3733_ = type_26(_e7838, _e7837, _e1408.member_13, _e7760, _e7418);
} else {
phi_3733_ = _e7419;
}
let _e7873 = phi_3733_;
phi_3734_ = _e7873;
phi_3735_ = _e7861;
}
let _e7918 = phi_3734_;
let _e7920 = phi_3735_;
if _e7920 {
phi_3742_ = type_17(_e1408.member, _e1408.member_1, vec3<f32>(1f, 1f, 1f), vec3<f32>(0f, 0f, 0f), _e7275, _e1408.member_14, 0f, 16i, 0f, 0f, 0f, 0f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), 0i, _e7584, _e7586, _e7760);
} else {
phi_3742_ = _e7585;
}
let _e7923 = phi_3742_;
phi_3743_ = _e7918;
phi_3744_ = _e7923;
} else {
phi_3743_ = type_26();
phi_3744_ = type_17();
}
let _e7925 = phi_3743_;
let _e7927 = phi_3744_;
phi_3746_ = _e7925;
phi_3747_ = _e7927;
phi_3748_ = select(true, false, _e7860);
}
let _e7930 = phi_3746_;
let _e7932 = phi_3747_;
let _e7934 = phi_3748_;
phi_3752_ = _e7930;
phi_3753_ = _e7932;
phi_3754_ = _e7934;
}
let _e7936 = phi_3752_;
let _e7938 = phi_3753_;
let _e7940 = phi_3754_;
if _e7940 {
phi_3758_ = _e7419;
phi_3759_ = _e7585;
} else {
phi_3758_ = _e7936;
phi_3759_ = _e7938;
}
let _e7942 = phi_3758_;
let _e7944 = phi_3759_;
let _e7973 = type_25(_e1408.member, _e1408.member_1, _e1408.member_2, _e1408.member_3, _e1408.member_4, _e1408.member_5, _e1408.member_6, _e1408.member_7, _e7944.member_15, _e1408.member_9, _e1408.member_10, _e1408.member_11, _e1408.member_12, _e1408.member_13, _e1408.member_14, _e1408.member_15, _e1408.member_16, _e1408.member_17, _e1408.member_18, _e1408.member_19, _e1408.member_20, _e1408.member_21, _e1408.member_22, _e1408.member_23, _e1408.member_24, _e1408.member_25, _e1408.member_26, _e1408.member_27);
let _e8002 = type_25(_e7973.member, _e7973.member_1, _e7973.member_2, _e7973.member_3, _e7973.member_4, _e7973.member_5, _e7973.member_6, _e7973.member_7, _e7973.member_8, _e7944.member_16, _e7973.member_10, _e7973.member_11, _e7973.member_12, _e7973.member_13, _e7973.member_14, _e7973.member_15, _e7973.member_16, _e7973.member_17, _e7973.member_18, _e7973.member_19, _e7973.member_20, _e7973.member_21, _e7973.member_22, _e7973.member_23, _e7973.member_24, _e7973.member_25, _e7973.member_26, _e7973.member_27);
let _e8031 = type_25(_e8002.member, _e8002.member_1, _e8002.member_2, _e8002.member_3, _e8002.member_4, _e8002.member_5, _e8002.member_6, _e8002.member_7, _e8002.member_8, _e8002.member_9, _e7944.member_17, _e8002.member_11, _e8002.member_12, _e8002.member_13, _e8002.member_14, _e8002.member_15, _e8002.member_16, _e8002.member_17, _e8002.member_18, _e8002.member_19, _e8002.member_20, _e8002.member_21, _e8002.member_22, _e8002.member_23, _e8002.member_24, _e8002.member_25, _e8002.member_26, _e8002.member_27);
let _e8060 = type_25(_e8031.member, _e8031.member_1, _e8031.member_2, _e8031.member_3, _e8031.member_4, _e8031.member_5, _e8031.member_6, _e8031.member_7, _e8031.member_8, _e8031.member_9, _e8031.member_10, _e7942.member, _e8031.member_12, _e8031.member_13, _e8031.member_14, _e8031.member_15, _e8031.member_16, _e8031.member_17, _e8031.member_18, _e8031.member_19, _e8031.member_20, _e8031.member_21, _e8031.member_22, _e8031.member_23, _e8031.member_24, _e8031.member_25, _e8031.member_26, _e8031.member_27);
let _e8089 = type_25(_e8060.member, _e8060.member_1, _e8060.member_2, _e8060.member_3, _e8060.member_4, _e8060.member_5, _e8060.member_6, _e8060.member_7, _e8060.member_8, _e8060.member_9, _e8060.member_10, _e8060.member_11, _e7942.member_1, _e8060.member_13, _e8060.member_14, _e8060.member_15, _e8060.member_16, _e8060.member_17, _e8060.member_18, _e8060.member_19, _e8060.member_20, _e8060.member_21, _e8060.member_22, _e8060.member_23, _e8060.member_24, _e8060.member_25, _e8060.member_26, _e8060.member_27);
phi_9425_ = type_25(_e8089.member, _e8089.member_1, _e8089.member_2, _e8089.member_3, _e8089.member_4, _e8089.member_5, _e8089.member_6, _e8089.member_7, _e8089.member_8, _e8089.member_9, _e8089.member_10, _e8089.member_11, _e8089.member_12, _e8089.member_13, _e7942.member_3, _e8089.member_15, _e8089.member_16, _e8089.member_17, _e8089.member_18, _e8089.member_19, _e8089.member_20, _e8089.member_21, _e8089.member_22, _e8089.member_23, _e8089.member_24, _e8089.member_25, _e8089.member_26, _e8089.member_27);
phi_9426_ = _e1412;
} else {
phi_3774_ = 15i;
phi_3777_ = 16i;
loop {
let _e1422 = phi_3774_;
let _e1424 = phi_3777_;
local = _e1424;
local_1 = _e1424;
local_2 = _e1424;
local_4 = _e1424;
local_7 = _e1424;
let _e1425 = (_e1422 >= 0i);
if _e1425 {
phi_3775_ = (_e1422 - 1i);
phi_3778_ = select(_e1424, _e1422, (((_e1408.member_7 >> bitcast<u32>((_e1422 & 31i))) & 1i) == 1i));
} else {
phi_3775_ = i32();
phi_3778_ = i32();
}
let _e1434 = phi_3775_;
let _e1436 = phi_3778_;
continue;
continuing {
phi_3774_ = _e1434;
phi_3777_ = _e1436;
break if !(_e1425);
}
}
let _e1439 = local;
let _e1440 = (_e1439 == 16i);
let _e1452 = (bitcast<i32>(countOneBits(bitcast<u32>((_e1408.member_17 & ((1i << bitcast<u32>((_e1408.member_16 & 31i))) - 1i))))) == _e1408.member_20);
let _e1455 = ((_e1440 && _e1452) && !(_e1412));
if _e1455 {
let _e7232 = type_25(_e1408.member, _e1408.member_1, _e1408.member_2, _e1408.member_3, _e1408.member_4, _e1408.member_5, _e1408.member_6, _e1408.member_7, _e1408.member_8, _e1408.member_9, _e1408.member_10, _e1408.member_11, _e1408.member_12, _e1408.member_13, _e1408.member_14, 2f, _e1408.member_16, _e1408.member_17, _e1408.member_18, _e1408.member_19, _e1408.member_20, _e1408.member_21, _e1408.member_22, _e1408.member_23, _e1408.member_24, _e1408.member_25, _e1408.member_26, _e1408.member_27);
phi_9423_ = type_25(_e7232.member, _e7232.member_1, _e7232.member_2, _e7232.member_3, _e7232.member_4, _e7232.member_5, _e7232.member_6, _e7232.member_7, _e7232.member_8, _e7232.member_9, _e7232.member_10, _e7232.member_11, _e7232.member_12, _e7232.member_13, _e7232.member_14, _e7232.member_15, _e7232.member_16, _e7232.member_17, _e7232.member_18, _e7232.member_19, _e7232.member_20, _e7232.member_21, (_e1408.member_22 + 1i), _e7232.member_23, _e7232.member_24, _e7232.member_25, _e7232.member_26, _e7232.member_27);
} else {
let _e1457 = (_e1408.member_9 >= 0i);
let _e1460 = (_e1408.member_10 - _e1408.member_13);
let _e1462 = select(0f, _e1460, (_e1460 > 0f));
let _e1465 = ((select(0i, _e1408.member_9, _e1457) * 19i) + 18i);
let _e1467 = (bitcast<i32>(_e124) - 1i);
let _e1469 = select(_e1467, _e1465, (_e1465 < _e1467));
let _e1475 = global_2.member[bitcast<u32>(select(0i, _e1469, (_e1469 > 0i)))];
let _e1482 = select(0i, select(select(i32(_e1475), i32(-2147483648), (_e1475 < -2147483600f)), 2147483647i, (_e1475 > 2147483500f)), (_e1475 == _e1475));
let _e1483 = (_e1482 * 4i);
let _e1485 = (bitcast<i32>(_e126) - 1i);
let _e1487 = select(_e1485, _e1483, (_e1483 < _e1485));
let _e1493 = global_3.member[bitcast<u32>(select(0i, _e1487, (_e1487 > 0i)))];
let _e1495 = select(_e1493, 1f, (_e1482 == 16i));
let _e1497 = (_e1457 && (_e1495 <= 0f));
let _e1506 = ((_e1408.member_7 | (_e1408.member_11 & ~(_e1408.member_12))) & ~((_e1408.member_12 & ~(_e1408.member_11))));
phi_3896_ = 15i;
phi_3899_ = 16i;
loop {
let _e1508 = phi_3896_;
let _e1510 = phi_3899_;
local_3 = _e1510;
local_5 = _e1510;
local_6 = _e1510;
local_8 = _e1510;
local_9 = _e1510;
let _e1511 = (_e1508 >= 0i);
if _e1511 {
phi_3897_ = (_e1508 - 1i);
phi_3900_ = select(_e1510, _e1508, (((_e1506 >> bitcast<u32>((_e1508 & 31i))) & 1i) == 1i));
} else {
phi_3897_ = i32();
phi_3900_ = i32();
}
let _e1520 = phi_3897_;
let _e1522 = phi_3900_;
continue;
continuing {
phi_3896_ = _e1520;
phi_3899_ = _e1522;
break if !(_e1511);
}
}
if _e1440 {
let _e1792 = (1f / select(_e1408.member_1.x, select(1e-12f, -1e-12f, (_e1408.member_1.x < 0f)), (bitcast<f32>((bitcast<u32>(_e1408.member_1.x) & 2147483647u)) < 1e-12f)));
let _e1801 = (1f / select(_e1408.member_1.y, select(1e-12f, -1e-12f, (_e1408.member_1.y < 0f)), (bitcast<f32>((bitcast<u32>(_e1408.member_1.y) & 2147483647u)) < 1e-12f)));
let _e1810 = (1f / select(_e1408.member_1.z, select(1e-12f, -1e-12f, (_e1408.member_1.z < 0f)), (bitcast<f32>((bitcast<u32>(_e1408.member_1.z) & 2147483647u)) < 1e-12f)));
let _e1814 = global_5.member.member_13.member_4;
let _e1821 = global_5.member.member_13.member_5;
let _e1827 = ((_e1814.member - _e1408.member.x) * _e1792);
let _e1829 = ((_e1821.member - _e1408.member.x) * _e1792);
let _e1832 = ((_e1814.member_1 - _e1408.member.y) * _e1801);
let _e1834 = ((_e1821.member_1 - _e1408.member.y) * _e1801);
let _e1837 = ((_e1814.member_2 - _e1408.member.z) * _e1810);
let _e1839 = ((_e1821.member_2 - _e1408.member.z) * _e1810);
let _e1841 = select(_e1829, _e1827, (_e1827 < _e1829));
let _e1843 = select(_e1834, _e1832, (_e1832 < _e1834));
let _e1845 = select(_e1843, _e1841, (_e1841 > _e1843));
let _e1847 = select(_e1839, _e1837, (_e1837 < _e1839));
let _e1849 = select(_e1847, _e1845, (_e1845 > _e1847));
let _e1851 = select(_e1829, _e1827, (_e1827 > _e1829));
let _e1853 = select(_e1834, _e1832, (_e1832 > _e1834));
let _e1855 = select(_e1853, _e1851, (_e1851 < _e1853));
let _e1857 = select(_e1839, _e1837, (_e1837 > _e1839));
let _e1859 = select(_e1857, _e1855, (_e1855 < _e1857));
let _e1861 = select(0f, _e1849, (_e1849 > 0f));
let _e1863 = select(_e1408.member_10, _e1859, (_e1859 < _e1408.member_10));
let _e1864 = (_e1863 > _e1861);
let _e1867 = (select(0f, _e1863, _e1864) - select(0f, _e1861, _e1864));
let _e1871 = global_5.member.member_13.member;
let _e1876 = -((_e1871.member * _e1867));
let _e1878 = select(-87f, _e1876, (_e1876 > -87f));
let _e1880 = select(88f, _e1878, (_e1878 < 88f));
let _e1882 = ((_e1880 * 1.442695f) + 0.5f);
let _e1884 = select(-127f, _e1882, (_e1882 > -127f));
let _e1886 = select(128f, _e1884, (_e1884 < 128f));
let _e1893 = select(0i, select(select(i32(_e1886), i32(-2147483648), (_e1886 < -2147483600f)), 2147483647i, (_e1886 > 2147483500f)), (_e1886 == _e1886));
let _e1897 = (_e1893 - select(0i, 1i, (_e1886 < f32(_e1893))));
let _e1898 = f32(_e1897);
let _e1902 = ((_e1880 - (_e1898 * 0.6933594f)) - (_e1898 * -2.1219444e-4f));
let _e1924 = -((_e1871.member_1 * _e1867));
let _e1926 = select(-87f, _e1924, (_e1924 > -87f));
let _e1928 = select(88f, _e1926, (_e1926 < 88f));
let _e1930 = ((_e1928 * 1.442695f) + 0.5f);
let _e1932 = select(-127f, _e1930, (_e1930 > -127f));
let _e1934 = select(128f, _e1932, (_e1932 < 128f));
let _e1941 = select(0i, select(select(i32(_e1934), i32(-2147483648), (_e1934 < -2147483600f)), 2147483647i, (_e1934 > 2147483500f)), (_e1934 == _e1934));
let _e1945 = (_e1941 - select(0i, 1i, (_e1934 < f32(_e1941))));
let _e1946 = f32(_e1945);
let _e1950 = ((_e1928 - (_e1946 * 0.6933594f)) - (_e1946 * -2.1219444e-4f));
let _e1972 = -((_e1871.member_2 * _e1867));
let _e1974 = select(-87f, _e1972, (_e1972 > -87f));
let _e1976 = select(88f, _e1974, (_e1974 < 88f));
let _e1978 = ((_e1976 * 1.442695f) + 0.5f);
let _e1980 = select(-127f, _e1978, (_e1978 > -127f));
let _e1982 = select(128f, _e1980, (_e1980 < 128f));
let _e1989 = select(0i, select(select(i32(_e1982), i32(-2147483648), (_e1982 < -2147483600f)), 2147483647i, (_e1982 > 2147483500f)), (_e1982 == _e1982));
let _e1993 = (_e1989 - select(0i, 1i, (_e1982 < f32(_e1989))));
let _e1994 = f32(_e1993);
let _e1998 = ((_e1976 - (_e1994 * 0.6933594f)) - (_e1994 * -2.1219444e-4f));
let _e2025 = (1f / 3f);
let _e2029 = (_e1408.member_6.x * ((1f + (_e1902 * (1f + (_e1902 * (0.5f + (_e1902 * (0.16666667f + (_e1902 * (0.041666668f + (_e1902 * (0.008333334f + (_e1902 * (0.001388889f + (_e1902 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1897 + 127i)) << bitcast<u32>(23i)))));
let _e2032 = (_e1408.member_6.y * ((1f + (_e1950 * (1f + (_e1950 * (0.5f + (_e1950 * (0.16666667f + (_e1950 * (0.041666668f + (_e1950 * (0.008333334f + (_e1950 * (0.001388889f + (_e1950 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1945 + 127i)) << bitcast<u32>(23i)))));
let _e2035 = (_e1408.member_6.z * ((1f + (_e1998 * (1f + (_e1998 * (0.5f + (_e1998 * (0.16666667f + (_e1998 * (0.041666668f + (_e1998 * (0.008333334f + (_e1998 * (0.001388889f + (_e1998 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1993 + 127i)) << bitcast<u32>(23i)))));
let _e2064 = type_25(_e1408.member, _e1408.member_1, _e1408.member_2, _e1408.member_3, _e1408.member_4, _e1408.member_5, vec3<f32>(_e2029, _e2032, _e2035), _e1408.member_7, _e1408.member_8, _e1408.member_9, _e1408.member_10, _e1408.member_11, _e1408.member_12, _e1408.member_13, _e1408.member_14, _e1408.member_15, _e1408.member_16, _e1408.member_17, _e1408.member_18, _e1408.member_19, _e1408.member_20, _e1408.member_21, _e1408.member_22, _e1408.member_23, _e1408.member_24, _e1408.member_25, _e1408.member_26, _e1408.member_27);
if _e1452 {
phi_4299_ = ((((_e1408.member_6.x + _e1408.member_6.y) + _e1408.member_6.z) * _e2025) - (((_e2029 + _e2032) + _e2035) * _e2025));
} else {
phi_4299_ = 0f;
}
let _e2070 = phi_4299_;
phi_4589_ = type_25(_e2064.member, _e2064.member_1, _e2064.member_2, _e2064.member_3, _e2064.member_4, _e2064.member_5, _e2064.member_6, _e2064.member_7, _e2064.member_8, _e2064.member_9, _e2064.member_10, _e2064.member_11, _e2064.member_12, _e2064.member_13, _e2064.member_14, _e2064.member_15, _e2064.member_16, _e2064.member_17, _e2064.member_18, _e2064.member_19, _e2064.member_20, _e2064.member_21, _e2064.member_22, _e2064.member_23, _e2064.member_24, _e2064.member_25, (_e1408.member_26 + _e2070), _e2064.member_27);
} else {
let _e1525 = select(1e6f, _e1462, (_e1462 < 1e6f));
let _e1527 = local_1;
let _e1528 = (_e1527 * 4i);
let _e1529 = (_e1528 + 1i);
let _e1531 = select(_e1485, _e1529, (_e1529 < _e1485));
let _e1537 = global_3.member[bitcast<u32>(select(0i, _e1531, (_e1531 > 0i)))];
let _e1539 = -((_e1537 * _e1525));
let _e1541 = select(-87f, _e1539, (_e1539 > -87f));
let _e1543 = select(88f, _e1541, (_e1541 < 88f));
let _e1545 = ((_e1543 * 1.442695f) + 0.5f);
let _e1547 = select(-127f, _e1545, (_e1545 > -127f));
let _e1549 = select(128f, _e1547, (_e1547 < 128f));
let _e1556 = select(0i, select(select(i32(_e1549), i32(-2147483648), (_e1549 < -2147483600f)), 2147483647i, (_e1549 > 2147483500f)), (_e1549 == _e1549));
let _e1560 = (_e1556 - select(0i, 1i, (_e1549 < f32(_e1556))));
let _e1561 = f32(_e1560);
let _e1565 = ((_e1543 - (_e1561 * 0.6933594f)) - (_e1561 * -2.1219444e-4f));
let _e1586 = (_e1528 + 2i);
let _e1588 = select(_e1485, _e1586, (_e1586 < _e1485));
let _e1594 = global_3.member[bitcast<u32>(select(0i, _e1588, (_e1588 > 0i)))];
let _e1596 = -((_e1594 * _e1525));
let _e1598 = select(-87f, _e1596, (_e1596 > -87f));
let _e1600 = select(88f, _e1598, (_e1598 < 88f));
let _e1602 = ((_e1600 * 1.442695f) + 0.5f);
let _e1604 = select(-127f, _e1602, (_e1602 > -127f));
let _e1606 = select(128f, _e1604, (_e1604 < 128f));
let _e1613 = select(0i, select(select(i32(_e1606), i32(-2147483648), (_e1606 < -2147483600f)), 2147483647i, (_e1606 > 2147483500f)), (_e1606 == _e1606));
let _e1617 = (_e1613 - select(0i, 1i, (_e1606 < f32(_e1613))));
let _e1618 = f32(_e1617);
let _e1622 = ((_e1600 - (_e1618 * 0.6933594f)) - (_e1618 * -2.1219444e-4f));
let _e1643 = (_e1528 + 3i);
let _e1645 = select(_e1485, _e1643, (_e1643 < _e1485));
let _e1651 = global_3.member[bitcast<u32>(select(0i, _e1645, (_e1645 > 0i)))];
let _e1653 = -((_e1651 * _e1525));
let _e1655 = select(-87f, _e1653, (_e1653 > -87f));
let _e1657 = select(88f, _e1655, (_e1655 < 88f));
let _e1659 = ((_e1657 * 1.442695f) + 0.5f);
let _e1661 = select(-127f, _e1659, (_e1659 > -127f));
let _e1663 = select(128f, _e1661, (_e1661 < 128f));
let _e1670 = select(0i, select(select(i32(_e1663), i32(-2147483648), (_e1663 < -2147483600f)), 2147483647i, (_e1663 > 2147483500f)), (_e1663 == _e1663));
let _e1674 = (_e1670 - select(0i, 1i, (_e1663 < f32(_e1670))));
let _e1675 = f32(_e1674);
let _e1679 = ((_e1657 - (_e1675 * 0.6933594f)) - (_e1675 * -2.1219444e-4f));
let _e1706 = (1f / 3f);
let _e1710 = (_e1408.member_6.x * ((1f + (_e1565 * (1f + (_e1565 * (0.5f + (_e1565 * (0.16666667f + (_e1565 * (0.041666668f + (_e1565 * (0.008333334f + (_e1565 * (0.001388889f + (_e1565 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1560 + 127i)) << bitcast<u32>(23i)))));
let _e1713 = (_e1408.member_6.y * ((1f + (_e1622 * (1f + (_e1622 * (0.5f + (_e1622 * (0.16666667f + (_e1622 * (0.041666668f + (_e1622 * (0.008333334f + (_e1622 * (0.001388889f + (_e1622 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1617 + 127i)) << bitcast<u32>(23i)))));
let _e1716 = (_e1408.member_6.z * ((1f + (_e1679 * (1f + (_e1679 * (0.5f + (_e1679 * (0.16666667f + (_e1679 * (0.041666668f + (_e1679 * (0.008333334f + (_e1679 * (0.001388889f + (_e1679 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1674 + 127i)) << bitcast<u32>(23i)))));
let _e1745 = type_25(_e1408.member, _e1408.member_1, _e1408.member_2, _e1408.member_3, _e1408.member_4, _e1408.member_5, vec3<f32>(_e1710, _e1713, _e1716), _e1408.member_7, _e1408.member_8, _e1408.member_9, _e1408.member_10, _e1408.member_11, _e1408.member_12, _e1408.member_13, _e1408.member_14, _e1408.member_15, _e1408.member_16, _e1408.member_17, _e1408.member_18, _e1408.member_19, _e1408.member_20, _e1408.member_21, _e1408.member_22, _e1408.member_23, _e1408.member_24, _e1408.member_25, _e1408.member_26, _e1408.member_27);
if _e1452 {
phi_4585_ = ((((_e1408.member_6.x + _e1408.member_6.y) + _e1408.member_6.z) * _e1706) - (((_e1710 + _e1713) + _e1716) * _e1706));
} else {
phi_4585_ = 0f;
}
let _e1751 = phi_4585_;
phi_4589_ = type_25(_e1745.member, _e1745.member_1, _e1745.member_2, _e1745.member_3, _e1745.member_4, _e1745.member_5, _e1745.member_6, _e1745.member_7, _e1745.member_8, _e1745.member_9, _e1745.member_10, _e1745.member_11, _e1745.member_12, _e1745.member_13, _e1745.member_14, _e1745.member_15, _e1745.member_16, _e1745.member_17, _e1745.member_18, _e1745.member_19, _e1745.member_20, _e1745.member_21, _e1745.member_22, _e1745.member_23, _e1745.member_24, (_e1408.member_25 + _e1751), _e1745.member_26, _e1745.member_27);
}
let _e2102 = phi_4589_;
if (!(_e1457) || (_e1497 && (_e1495 == 0f))) {
if (bitcast<i32>(countOneBits(bitcast<u32>((_e2102.member_17 & ((1i << bitcast<u32>((_e2102.member_16 & 31i))) - 1i))))) == _e2102.member_20) {
phi_4643_ = (((_e2102.member_6.x + _e2102.member_6.y) + _e2102.member_6.z) * (1f / 3f));
} else {
phi_4643_ = 0f;
}
let _e5815 = phi_4643_;
if (_e2102.member_9 == -1i) {
phi_4655_ = type_25(_e2102.member, _e2102.member_1, _e2102.member_2, _e2102.member_3, _e2102.member_4, _e2102.member_5, _e2102.member_6, _e2102.member_7, _e2102.member_8, _e2102.member_9, _e2102.member_10, _e2102.member_11, _e2102.member_12, _e2102.member_13, _e2102.member_14, _e2102.member_15, _e2102.member_16, _e2102.member_17, _e2102.member_18, _e2102.member_19, _e2102.member_20, _e2102.member_21, _e2102.member_22, (_e2102.member_23 + _e5815), _e2102.member_24, _e2102.member_25, _e2102.member_26, _e2102.member_27);
} else {
phi_4655_ = type_25(_e2102.member, _e2102.member_1, _e2102.member_2, _e2102.member_3, _e2102.member_4, _e2102.member_5, _e2102.member_6, _e2102.member_7, _e2102.member_8, _e2102.member_9, _e2102.member_10, _e2102.member_11, _e2102.member_12, _e2102.member_13, _e2102.member_14, _e2102.member_15, _e2102.member_16, _e2102.member_17, _e2102.member_18, _e2102.member_19, _e2102.member_20, _e2102.member_21, _e2102.member_22, _e2102.member_23, (_e2102.member_24 + _e5815), _e2102.member_25, _e2102.member_26, _e2102.member_27);
}
let _e5879 = phi_4655_;
let _e5881 = (_e5879.member_18 == 0i);
if (_e5881 && (_e5879.member_21 == 0i)) {
phi_5959_ = type_25(_e5879.member, _e5879.member_1, _e5879.member_2, _e5879.member_3, _e5879.member_4, _e5879.member_5, _e5879.member_6, _e5879.member_7, _e5879.member_8, _e5879.member_9, _e5879.member_10, _e5879.member_11, _e5879.member_12, _e5879.member_13, _e5879.member_14, 3f, _e5879.member_16, _e5879.member_17, _e5879.member_18, _e5879.member_19, _e5879.member_20, _e5879.member_21, _e5879.member_22, _e5879.member_23, _e5879.member_24, _e5879.member_25, _e5879.member_26, _e5879.member_27);
} else {
if _e5881 {
let _e6013 = type_25(_e5879.member, _e5879.member_1, _e5879.member_2, _e5879.member_3, _e5879.member_4, _e5879.member_5, _e5879.member_6, _e5879.member_7, _e5879.member_8, _e5879.member_9, _e5879.member_10, _e5879.member_11, _e5879.member_12, _e5879.member_13, _e5879.member_14, _e5879.member_15, _e5879.member_16, _e5879.member_17, _e5879.member_18, _e5879.member_19, (_e5879.member_20 + 1i), _e5879.member_21, _e5879.member_22, _e5879.member_23, _e5879.member_24, _e5879.member_25, _e5879.member_26, _e5879.member_27);
let _e6041 = type_25(_e6013.member, _e6013.member_1, _e6013.member_2, _e6013.member_3, _e6013.member_4, _e6013.member_5, _e6013.member_6, _e6013.member_7, _e6013.member_8, _e6013.member_9, _e6013.member_10, _e6013.member_11, _e6013.member_12, _e6013.member_13, _e6013.member_14, _e6013.member_15, _e6013.member_16, _e6013.member_17, _e6013.member_18, _e6013.member_19, _e6013.member_20, 0i, _e6013.member_22, _e6013.member_23, _e6013.member_24, _e6013.member_25, _e6013.member_26, _e6013.member_27);
let _e6069 = type_25(_e6041.member, _e6041.member_1, _e6041.member_2, _e6041.member_3, _e6041.member_4, _e6041.member_5, _e6041.member_6, _e6041.member_7, _e6041.member_8, _e6041.member_9, _e6041.member_10, _e6041.member_11, _e6041.member_12, _e6041.member_13, _e6041.member_14, _e6041.member_15, _e6041.member_16, 0i, _e6041.member_18, _e6041.member_19, _e6041.member_20, _e6041.member_21, _e6041.member_22, _e6041.member_23, _e6041.member_24, _e6041.member_25, _e6041.member_26, _e6041.member_27);
phi_4696_ = type_25(_e6069.member, _e6069.member_1, _e6069.member_2, _e6069.member_3, _e6069.member_4, _e6069.member_5, _e6069.member_6, _e6069.member_7, _e6069.member_8, _e6069.member_9, _e6069.member_10, _e6069.member_11, _e6069.member_12, _e6069.member_13, _e6069.member_14, _e6069.member_15, _e6069.member_16, _e6069.member_17, _e6069.member_18, 0i, _e6069.member_20, _e6069.member_21, _e6069.member_22, _e6069.member_23, _e6069.member_24, _e6069.member_25, _e6069.member_26, _e6069.member_27);
} else {
let _e5889 = bitcast<i32>((bitcast<u32>(f32(_e5879.member_18)) >> bitcast<u32>(23i)));
let _e5893 = (1i << bitcast<u32>(((_e5889 - 127i) & 31i)));
let _e5894 = (_e5893 - 1i);
let _e5925 = type_25(_e5879.member, _e5879.member_1, _e5879.member_2, _e5879.member_3, _e5879.member_4, _e5879.member_5, _e5879.member_6, _e5879.member_7, _e5879.member_8, _e5879.member_9, _e5879.member_10, _e5879.member_11, _e5879.member_12, _e5879.member_13, _e5879.member_14, _e5879.member_15, _e5879.member_16, ((_e5879.member_17 & _e5894) | _e5893), _e5879.member_18, _e5879.member_19, _e5879.member_20, _e5879.member_21, _e5879.member_22, _e5879.member_23, _e5879.member_24, _e5879.member_25, _e5879.member_26, _e5879.member_27);
let _e5954 = type_25(_e5925.member, _e5925.member_1, _e5925.member_2, _e5925.member_3, _e5925.member_4, _e5925.member_5, _e5925.member_6, _e5925.member_7, _e5925.member_8, _e5925.member_9, _e5925.member_10, _e5925.member_11, _e5925.member_12, _e5925.member_13, _e5925.member_14, _e5925.member_15, _e5925.member_16, _e5925.member_17, (_e5879.member_18 & _e5894), _e5925.member_19, _e5925.member_20, _e5925.member_21, _e5925.member_22, _e5925.member_23, _e5925.member_24, _e5925.member_25, _e5925.member_26, _e5925.member_27);
phi_4696_ = type_25(_e5954.member, _e5954.member_1, _e5954.member_2, _e5954.member_3, _e5954.member_4, _e5954.member_5, _e5954.member_6, _e5954.member_7, _e5954.member_8, _e5954.member_9, _e5954.member_10, _e5954.member_11, _e5954.member_12, _e5954.member_13, _e5954.member_14, _e5954.member_15, _e5954.member_16, _e5954.member_17, _e5954.member_18, (_e5889 + -126i), _e5954.member_20, _e5954.member_21, _e5954.member_22, _e5954.member_23, _e5954.member_24, _e5954.member_25, _e5954.member_26, _e5954.member_27);
}
let _e6099 = phi_4696_;
let _e6105 = global_5.member.member_11.member_2;
let _e6112 = global_5.member.member_11.member_3;
let _e6119 = global_5.member.member_11.member_5;
let _e6125 = global_5.member.member_11.member_7;
let _e6127 = (_e6119 + ((f32(bitcast<i32>(_e120.x)) + 0.5f) * _e6125));
let _e6131 = global_5.member.member_11.member_6;
let _e6137 = global_5.member.member_11.member_8;
let _e6139 = (_e6131 + ((f32(bitcast<i32>(_e120.y)) + 0.5f) * _e6137));
let _e6140 = (_e6105.member * _e6125);
let _e6141 = (_e6105.member_1 * _e6125);
let _e6142 = (_e6105.member_2 * _e6125);
let _e6143 = (_e6112.member * _e6137);
let _e6144 = (_e6112.member_1 * _e6137);
let _e6145 = (_e6112.member_2 * _e6137);
let _e6152 = ((_e6105.member * _e6127) + (_e6112.member * _e6139));
let _e6153 = ((_e6105.member_1 * _e6127) + (_e6112.member_1 * _e6139));
let _e6154 = ((_e6105.member_2 * _e6127) + (_e6112.member_2 * _e6139));
let _e6158 = global_5.member.member_11.member_4;
let _e6165 = global_5.member.member_11.member_1;
let _e6172 = global_5.member.member_10.member;
let _e6173 = (_e6172 == 0u);
let _e6174 = (_e6165.member + _e6152);
let _e6175 = (_e6165.member_1 + _e6153);
let _e6176 = (_e6165.member_2 + _e6154);
let _e6181 = (((_e6174 * _e6174) + (_e6175 * _e6175)) + (_e6176 * _e6176));
let _e6185 = (1f / sqrt(select(0f, _e6181, (_e6181 > 0f))));
let _e6189 = select((_e6174 * _e6185), _e6165.member, _e6173);
let _e6190 = select((_e6175 * _e6185), _e6165.member_1, _e6173);
let _e6191 = select((_e6176 * _e6185), _e6165.member_2, _e6173);
let _e6196 = select(_e6158.member, (_e6158.member + _e6152), _e6173);
let _e6197 = select(_e6158.member_1, (_e6158.member_1 + _e6153), _e6173);
let _e6198 = select(_e6158.member_2, (_e6158.member_2 + _e6154), _e6173);
let _e6212 = (((_e6140 * _e6189) + (_e6141 * _e6190)) + (_e6142 * _e6191));
let _e6222 = select(((_e6140 - (_e6189 * _e6212)) * _e6185), 0f, _e6173);
let _e6223 = select(((_e6141 - (_e6190 * _e6212)) * _e6185), 0f, _e6173);
let _e6224 = select(((_e6142 - (_e6191 * _e6212)) * _e6185), 0f, _e6173);
let _e6230 = (((_e6143 * _e6189) + (_e6144 * _e6190)) + (_e6145 * _e6191));
let _e6240 = select(((_e6143 - (_e6189 * _e6230)) * _e6185), 0f, _e6173);
let _e6241 = select(((_e6144 - (_e6190 * _e6230)) * _e6185), 0f, _e6173);
let _e6242 = select(((_e6145 - (_e6191 * _e6230)) * _e6185), 0f, _e6173);
let _e6251 = (1f / select(_e6189, select(1e-12f, -1e-12f, (_e6189 < 0f)), (bitcast<f32>((bitcast<u32>(_e6189) & 2147483647u)) < 1e-12f)));
let _e6259 = (1f / select(_e6190, select(1e-12f, -1e-12f, (_e6190 < 0f)), (bitcast<f32>((bitcast<u32>(_e6190) & 2147483647u)) < 1e-12f)));
let _e6267 = (1f / select(_e6191, select(1e-12f, -1e-12f, (_e6191 < 0f)), (bitcast<f32>((bitcast<u32>(_e6191) & 2147483647u)) < 1e-12f)));
let _e6270 = global_5.member.member_8;
let _e6276 = global_5.member.member_9;
let _e6281 = ((_e6270.member - _e6196) * _e6251);
let _e6283 = ((_e6276.member - _e6196) * _e6251);
let _e6285 = ((_e6270.member_1 - _e6197) * _e6259);
let _e6287 = ((_e6276.member_1 - _e6197) * _e6259);
let _e6289 = ((_e6270.member_2 - _e6198) * _e6267);
let _e6291 = ((_e6276.member_2 - _e6198) * _e6267);
let _e6293 = select(_e6283, _e6281, (_e6281 < _e6283));
let _e6295 = select(_e6287, _e6285, (_e6285 < _e6287));
let _e6297 = select(_e6295, _e6293, (_e6293 > _e6295));
let _e6299 = select(_e6291, _e6289, (_e6289 < _e6291));
let _e6301 = select(_e6299, _e6297, (_e6297 > _e6299));
let _e6303 = select(_e6283, _e6281, (_e6281 > _e6283));
let _e6305 = select(_e6287, _e6285, (_e6285 > _e6287));
let _e6307 = select(_e6305, _e6303, (_e6303 < _e6305));
let _e6309 = select(_e6291, _e6289, (_e6289 > _e6291));
if (true && _e6173) {
phi_5280_ = -(1e30f);
} else {
phi_5280_ = 0f;
}
let _e6315 = phi_5280_;
let _e6317 = select(_e6315, _e6301, (_e6301 > _e6315));
let _e6319 = ((select(_e6309, _e6307, (_e6307 < _e6309)) <= _e6317) || false);
let _e6320 = select(_e6317, 0f, _e6319);
let _e6321 = (_e6189 * _e6320);
let _e6322 = (_e6190 * _e6320);
let _e6323 = (_e6191 * _e6320);
let _e6324 = (_e6196 + _e6321);
let _e6325 = (_e6197 + _e6322);
let _e6326 = (_e6198 + _e6323);
let _e6356 = type_25((vec3<f32>(_e6196, _e6197, _e6198) + vec3<f32>(_e6321, _e6322, _e6323)), _e6099.member_1, _e6099.member_2, _e6099.member_3, _e6099.member_4, _e6099.member_5, _e6099.member_6, _e6099.member_7, _e6099.member_8, _e6099.member_9, _e6099.member_10, _e6099.member_11, _e6099.member_12, _e6099.member_13, _e6099.member_14, _e6099.member_15, _e6099.member_16, _e6099.member_17, _e6099.member_18, _e6099.member_19, _e6099.member_20, _e6099.member_21, _e6099.member_22, _e6099.member_23, _e6099.member_24, _e6099.member_25, _e6099.member_26, _e6099.member_27);
let _e6384 = type_25(_e6356.member, vec3<f32>(_e6189, _e6190, _e6191), _e6356.member_2, _e6356.member_3, _e6356.member_4, _e6356.member_5, _e6356.member_6, _e6356.member_7, _e6356.member_8, _e6356.member_9, _e6356.member_10, _e6356.member_11, _e6356.member_12, _e6356.member_13, _e6356.member_14, _e6356.member_15, _e6356.member_16, _e6356.member_17, _e6356.member_18, _e6356.member_19, _e6356.member_20, _e6356.member_21, _e6356.member_22, _e6356.member_23, _e6356.member_24, _e6356.member_25, _e6356.member_26, _e6356.member_27);
let _e6422 = type_25(_e6384.member, _e6384.member_1, (vec3<f32>(select(0f, _e6140, _e6173), select(0f, _e6141, _e6173), select(0f, _e6142, _e6173)) + vec3<f32>((_e6222 * _e6320), (_e6223 * _e6320), (_e6224 * _e6320))), _e6384.member_3, _e6384.member_4, _e6384.member_5, _e6384.member_6, _e6384.member_7, _e6384.member_8, _e6384.member_9, _e6384.member_10, _e6384.member_11, _e6384.member_12, _e6384.member_13, _e6384.member_14, _e6384.member_15, _e6384.member_16, _e6384.member_17, _e6384.member_18, _e6384.member_19, _e6384.member_20, _e6384.member_21, _e6384.member_22, _e6384.member_23, _e6384.member_24, _e6384.member_25, _e6384.member_26, _e6384.member_27);
let _e6450 = type_25(_e6422.member, _e6422.member_1, _e6422.member_2, (vec3<f32>(select(0f, _e6143, _e6173), select(0f, _e6144, _e6173), select(0f, _e6145, _e6173)) + vec3<f32>((_e6240 * _e6320), (_e6241 * _e6320), (_e6242 * _e6320))), _e6422.member_4, _e6422.member_5, _e6422.member_6, _e6422.member_7, _e6422.member_8, _e6422.member_9, _e6422.member_10, _e6422.member_11, _e6422.member_12, _e6422.member_13, _e6422.member_14, _e6422.member_15, _e6422.member_16, _e6422.member_17, _e6422.member_18, _e6422.member_19, _e6422.member_20, _e6422.member_21, _e6422.member_22, _e6422.member_23, _e6422.member_24, _e6422.member_25, _e6422.member_26, _e6422.member_27);
let _e6478 = type_25(_e6450.member, _e6450.member_1, _e6450.member_2, _e6450.member_3, vec3<f32>(_e6222, _e6223, _e6224), _e6450.member_5, _e6450.member_6, _e6450.member_7, _e6450.member_8, _e6450.member_9, _e6450.member_10, _e6450.member_11, _e6450.member_12, _e6450.member_13, _e6450.member_14, _e6450.member_15, _e6450.member_16, _e6450.member_17, _e6450.member_18, _e6450.member_19, _e6450.member_20, _e6450.member_21, _e6450.member_22, _e6450.member_23, _e6450.member_24, _e6450.member_25, _e6450.member_26, _e6450.member_27);
let _e6506 = type_25(_e6478.member, _e6478.member_1, _e6478.member_2, _e6478.member_3, _e6478.member_4, vec3<f32>(_e6240, _e6241, _e6242), _e6478.member_6, _e6478.member_7, _e6478.member_8, _e6478.member_9, _e6478.member_10, _e6478.member_11, _e6478.member_12, _e6478.member_13, _e6478.member_14, _e6478.member_15, _e6478.member_16, _e6478.member_17, _e6478.member_18, _e6478.member_19, _e6478.member_20, _e6478.member_21, _e6478.member_22, _e6478.member_23, _e6478.member_24, _e6478.member_25, _e6478.member_26, _e6478.member_27);
let _e6534 = type_25(_e6506.member, _e6506.member_1, _e6506.member_2, _e6506.member_3, _e6506.member_4, _e6506.member_5, _e6506.member_6, 0i, _e6506.member_8, _e6506.member_9, _e6506.member_10, _e6506.member_11, _e6506.member_12, _e6506.member_13, _e6506.member_14, _e6506.member_15, _e6506.member_16, _e6506.member_17, _e6506.member_18, _e6506.member_19, _e6506.member_20, _e6506.member_21, _e6506.member_22, _e6506.member_23, _e6506.member_24, _e6506.member_25, _e6506.member_26, _e6506.member_27);
let _e6562 = type_25(_e6534.member, _e6534.member_1, _e6534.member_2, _e6534.member_3, _e6534.member_4, _e6534.member_5, _e6534.member_6, _e6534.member_7, _e6534.member_8, _e6534.member_9, _e6534.member_10, _e6534.member_11, _e6534.member_12, _e6534.member_13, _e6534.member_14, _e6534.member_15, 0i, _e6534.member_17, _e6534.member_18, _e6534.member_19, _e6534.member_20, _e6534.member_21, _e6534.member_22, _e6534.member_23, _e6534.member_24, _e6534.member_25, _e6534.member_26, _e6534.member_27);
let _e6590 = type_25(_e6562.member, _e6562.member_1, _e6562.member_2, _e6562.member_3, _e6562.member_4, _e6562.member_5, _e6562.member_6, _e6562.member_7, _e6562.member_8, _e6562.member_9, _e6562.member_10, _e6562.member_11, _e6562.member_12, _e6562.member_13, _e6562.member_14, 1f, _e6562.member_16, _e6562.member_17, _e6562.member_18, _e6562.member_19, _e6562.member_20, _e6562.member_21, _e6562.member_22, _e6562.member_23, _e6562.member_24, _e6562.member_25, _e6562.member_26, _e6562.member_27);
let _e6618 = type_25(_e6590.member, _e6590.member_1, _e6590.member_2, _e6590.member_3, _e6590.member_4, _e6590.member_5, _e6590.member_6, _e6590.member_7, _e6590.member_8, _e6590.member_9, _e6590.member_10, _e6590.member_11, _e6590.member_12, 0f, _e6590.member_14, _e6590.member_15, _e6590.member_16, _e6590.member_17, _e6590.member_18, _e6590.member_19, _e6590.member_20, _e6590.member_21, _e6590.member_22, _e6590.member_23, _e6590.member_24, _e6590.member_25, _e6590.member_26, _e6590.member_27);
let _e6646 = type_25(_e6618.member, _e6618.member_1, _e6618.member_2, _e6618.member_3, _e6618.member_4, _e6618.member_5, _e6618.member_6, _e6618.member_7, _e6618.member_8, _e6618.member_9, _e6618.member_10, 0i, _e6618.member_12, _e6618.member_13, _e6618.member_14, _e6618.member_15, _e6618.member_16, _e6618.member_17, _e6618.member_18, _e6618.member_19, _e6618.member_20, _e6618.member_21, _e6618.member_22, _e6618.member_23, _e6618.member_24, _e6618.member_25, _e6618.member_26, _e6618.member_27);
let _e6674 = type_25(_e6646.member, _e6646.member_1, _e6646.member_2, _e6646.member_3, _e6646.member_4, _e6646.member_5, _e6646.member_6, _e6646.member_7, _e6646.member_8, _e6646.member_9, _e6646.member_10, _e6646.member_11, 0i, _e6646.member_13, _e6646.member_14, _e6646.member_15, _e6646.member_16, _e6646.member_17, _e6646.member_18, _e6646.member_19, _e6646.member_20, _e6646.member_21, _e6646.member_22, _e6646.member_23, _e6646.member_24, _e6646.member_25, _e6646.member_26, _e6646.member_27);
let _e6679 = global_5.member.member_14.member.member;
let _e6690 = ((((_e6679.member.member * _e6324) + (_e6679.member.member_1 * _e6325)) + (_e6679.member.member_2 * _e6326)) + _e6679.member_1);
let _e6696 = -((((_e6679.member.member * _e6189) + (_e6679.member.member_1 * _e6190)) + (_e6679.member.member_2 * _e6191)));
let _e6698 = (_e6696 > 1e-9f);
let _e6702 = ((_e6690 / select(1e-9f, _e6696, _e6698)) - 0.015625f);
let _e6705 = select(1e30f, select(0f, _e6702, (_e6702 > 0f)), ((_e6690 > 0f) && _e6698));
let _e6710 = global_5.member.member_14.member_1.member;
let _e6721 = ((((_e6710.member.member * _e6324) + (_e6710.member.member_1 * _e6325)) + (_e6710.member.member_2 * _e6326)) + _e6710.member_1);
let _e6727 = -((((_e6710.member.member * _e6189) + (_e6710.member.member_1 * _e6190)) + (_e6710.member.member_2 * _e6191)));
let _e6729 = (_e6727 > 1e-9f);
let _e6733 = ((_e6721 / select(1e-9f, _e6727, _e6729)) - 0.015625f);
let _e6736 = select(1e30f, select(0f, _e6733, (_e6733 > 0f)), ((_e6721 > 0f) && _e6729));
let _e6740 = (_e6736 < _e6705);
let _e6771 = type_25(_e6674.member, _e6674.member_1, _e6674.member_2, _e6674.member_3, _e6674.member_4, _e6674.member_5, _e6674.member_6, _e6674.member_7, 0i, _e6674.member_9, _e6674.member_10, _e6674.member_11, _e6674.member_12, _e6674.member_13, _e6674.member_14, _e6674.member_15, _e6674.member_16, _e6674.member_17, _e6674.member_18, _e6674.member_19, _e6674.member_20, _e6674.member_21, _e6674.member_22, _e6674.member_23, _e6674.member_24, _e6674.member_25, _e6674.member_26, _e6674.member_27);
let _e6799 = type_25(_e6771.member, _e6771.member_1, _e6771.member_2, _e6771.member_3, _e6771.member_4, _e6771.member_5, _e6771.member_6, _e6771.member_7, _e6771.member_8, select(select(-2i, -3i, _e6740), -1i, ((_e6705 >= 1e30f) && (_e6736 >= 1e30f))), _e6771.member_10, _e6771.member_11, _e6771.member_12, _e6771.member_13, _e6771.member_14, _e6771.member_15, _e6771.member_16, _e6771.member_17, _e6771.member_18, _e6771.member_19, _e6771.member_20, _e6771.member_21, _e6771.member_22, _e6771.member_23, _e6771.member_24, _e6771.member_25, _e6771.member_26, _e6771.member_27);
let _e6827 = type_25(_e6799.member, _e6799.member_1, _e6799.member_2, _e6799.member_3, _e6799.member_4, _e6799.member_5, _e6799.member_6, _e6799.member_7, _e6799.member_8, _e6799.member_9, select(_e6705, _e6736, _e6740), _e6799.member_11, _e6799.member_12, _e6799.member_13, _e6799.member_14, _e6799.member_15, _e6799.member_16, _e6799.member_17, _e6799.member_18, _e6799.member_19, _e6799.member_20, _e6799.member_21, _e6799.member_22, _e6799.member_23, _e6799.member_24, _e6799.member_25, _e6799.member_26, _e6799.member_27);
let _e6831 = global_5.member.member_13.member_4;
let _e6838 = global_5.member.member_13.member_5;
let _e6843 = ((_e6831.member - _e6196) * _e6251);
let _e6845 = ((_e6838.member - _e6196) * _e6251);
let _e6847 = ((_e6831.member_1 - _e6197) * _e6259);
let _e6849 = ((_e6838.member_1 - _e6197) * _e6259);
let _e6851 = ((_e6831.member_2 - _e6198) * _e6267);
let _e6853 = ((_e6838.member_2 - _e6198) * _e6267);
let _e6855 = select(_e6845, _e6843, (_e6843 < _e6845));
let _e6857 = select(_e6849, _e6847, (_e6847 < _e6849));
let _e6859 = select(_e6857, _e6855, (_e6855 > _e6857));
let _e6861 = select(_e6853, _e6851, (_e6851 < _e6853));
let _e6863 = select(_e6861, _e6859, (_e6859 > _e6861));
let _e6865 = select(_e6845, _e6843, (_e6843 > _e6845));
let _e6867 = select(_e6849, _e6847, (_e6847 > _e6849));
let _e6869 = select(_e6867, _e6865, (_e6865 < _e6867));
let _e6871 = select(_e6853, _e6851, (_e6851 > _e6853));
let _e6873 = select(_e6871, _e6869, (_e6869 < _e6871));
let _e6875 = select(_e6315, _e6863, (_e6863 > _e6315));
let _e6877 = select(_e6320, _e6873, (_e6873 < _e6320));
let _e6878 = (_e6877 > _e6875);
let _e6881 = (select(_e6315, _e6877, _e6878) - select(_e6315, _e6875, _e6878));
let _e6885 = global_5.member.member_13.member;
let _e6890 = -((_e6885.member * _e6881));
let _e6892 = select(-87f, _e6890, (_e6890 > -87f));
let _e6894 = select(88f, _e6892, (_e6892 < 88f));
let _e6896 = ((_e6894 * 1.442695f) + 0.5f);
let _e6898 = select(-127f, _e6896, (_e6896 > -127f));
let _e6900 = select(128f, _e6898, (_e6898 < 128f));
let _e6907 = select(0i, select(select(i32(_e6900), i32(-2147483648), (_e6900 < -2147483600f)), 2147483647i, (_e6900 > 2147483500f)), (_e6900 == _e6900));
let _e6911 = (_e6907 - select(0i, 1i, (_e6900 < f32(_e6907))));
let _e6912 = f32(_e6911);
let _e6916 = ((_e6894 - (_e6912 * 0.6933594f)) - (_e6912 * -2.1219444e-4f));
let _e6938 = -((_e6885.member_1 * _e6881));
let _e6940 = select(-87f, _e6938, (_e6938 > -87f));
let _e6942 = select(88f, _e6940, (_e6940 < 88f));
let _e6944 = ((_e6942 * 1.442695f) + 0.5f);
let _e6946 = select(-127f, _e6944, (_e6944 > -127f));
let _e6948 = select(128f, _e6946, (_e6946 < 128f));
let _e6955 = select(0i, select(select(i32(_e6948), i32(-2147483648), (_e6948 < -2147483600f)), 2147483647i, (_e6948 > 2147483500f)), (_e6948 == _e6948));
let _e6959 = (_e6955 - select(0i, 1i, (_e6948 < f32(_e6955))));
let _e6960 = f32(_e6959);
let _e6964 = ((_e6942 - (_e6960 * 0.6933594f)) - (_e6960 * -2.1219444e-4f));
let _e6986 = -((_e6885.member_2 * _e6881));
let _e6988 = select(-87f, _e6986, (_e6986 > -87f));
let _e6990 = select(88f, _e6988, (_e6988 < 88f));
let _e6992 = ((_e6990 * 1.442695f) + 0.5f);
let _e6994 = select(-127f, _e6992, (_e6992 > -127f));
let _e6996 = select(128f, _e6994, (_e6994 < 128f));
let _e7003 = select(0i, select(select(i32(_e6996), i32(-2147483648), (_e6996 < -2147483600f)), 2147483647i, (_e6996 > 2147483500f)), (_e6996 == _e6996));
let _e7007 = (_e7003 - select(0i, 1i, (_e6996 < f32(_e7003))));
let _e7008 = f32(_e7007);
let _e7012 = ((_e6990 - (_e7008 * 0.6933594f)) - (_e7008 * -2.1219444e-4f));
let _e7035 = (1f / 3f);
let _e7037 = (1f * ((1f + (_e6916 * (1f + (_e6916 * (0.5f + (_e6916 * (0.16666667f + (_e6916 * (0.041666668f + (_e6916 * (0.008333334f + (_e6916 * (0.001388889f + (_e6916 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6911 + 127i)) << bitcast<u32>(23i)))));
let _e7038 = (1f * ((1f + (_e6964 * (1f + (_e6964 * (0.5f + (_e6964 * (0.16666667f + (_e6964 * (0.041666668f + (_e6964 * (0.008333334f + (_e6964 * (0.001388889f + (_e6964 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6959 + 127i)) << bitcast<u32>(23i)))));
let _e7039 = (1f * ((1f + (_e7012 * (1f + (_e7012 * (0.5f + (_e7012 * (0.16666667f + (_e7012 * (0.041666668f + (_e7012 * (0.008333334f + (_e7012 * (0.001388889f + (_e7012 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e7007 + 127i)) << bitcast<u32>(23i)))));
let _e7068 = type_25(_e6827.member, _e6827.member_1, _e6827.member_2, _e6827.member_3, _e6827.member_4, _e6827.member_5, vec3<f32>(_e7037, _e7038, _e7039), _e6827.member_7, _e6827.member_8, _e6827.member_9, _e6827.member_10, _e6827.member_11, _e6827.member_12, _e6827.member_13, _e6827.member_14, _e6827.member_15, _e6827.member_16, _e6827.member_17, _e6827.member_18, _e6827.member_19, _e6827.member_20, _e6827.member_21, _e6827.member_22, _e6827.member_23, _e6827.member_24, _e6827.member_25, _e6827.member_26, _e6827.member_27);
if (bitcast<i32>(countOneBits(0u)) == _e6099.member_20) {
phi_5931_ = ((((1f + 1f) + 1f) * _e7035) - (((_e7037 + _e7038) + _e7039) * _e7035));
} else {
phi_5931_ = 0f;
}
let _e7078 = phi_5931_;
let _e7108 = type_25(_e7068.member, _e7068.member_1, _e7068.member_2, _e7068.member_3, _e7068.member_4, _e7068.member_5, _e7068.member_6, _e7068.member_7, _e7068.member_8, _e7068.member_9, _e7068.member_10, _e7068.member_11, _e7068.member_12, _e7068.member_13, _e7068.member_14, _e7068.member_15, _e7068.member_16, _e7068.member_17, _e7068.member_18, _e7068.member_19, _e7068.member_20, _e7068.member_21, _e7068.member_22, _e7068.member_23, _e7068.member_24, _e7068.member_25, (_e6099.member_26 + _e7078), _e7068.member_27);
if _e6319 {
let _e7136 = type_25(_e7108.member, _e7108.member_1, _e7108.member_2, _e7108.member_3, _e7108.member_4, _e7108.member_5, _e7108.member_6, _e7108.member_7, _e1374, _e7108.member_9, _e7108.member_10, _e7108.member_11, _e7108.member_12, _e7108.member_13, _e7108.member_14, _e7108.member_15, _e7108.member_16, _e7108.member_17, _e7108.member_18, _e7108.member_19, _e7108.member_20, _e7108.member_21, _e7108.member_22, _e7108.member_23, _e7108.member_24, _e7108.member_25, _e7108.member_26, _e7108.member_27);
phi_5958_ = type_25(_e7136.member, _e7136.member_1, _e7136.member_2, _e7136.member_3, _e7136.member_4, _e7136.member_5, _e7136.member_6, _e7136.member_7, _e7136.member_8, _e7136.member_9, _e7136.member_10, _e7136.member_11, _e7136.member_12, _e7136.member_13, _e7136.member_14, 3f, _e7136.member_16, _e7136.member_17, _e7136.member_18, _e7136.member_19, _e7136.member_20, _e7136.member_21, _e7136.member_22, _e7136.member_23, _e7136.member_24, _e7136.member_25, _e7136.member_26, _e7136.member_27);
} else {
phi_5958_ = _e7108;
}
let _e7166 = phi_5958_;
phi_5959_ = _e7166;
}
let _e7196 = phi_5959_;
phi_9416_ = _e7196;
phi_9417_ = type_25();
phi_9418_ = true;
} else {
let _e2109 = local_2;
let _e2111 = local_3;
let _e2113 = (!(_e1497) && (_e2109 == _e2111));
if _e2113 {
let _e5541 = type_25(_e2102.member, _e2102.member_1, _e2102.member_2, _e2102.member_3, _e2102.member_4, _e2102.member_5, _e2102.member_6, _e1506, _e2102.member_8, _e2102.member_9, _e2102.member_10, _e2102.member_11, _e2102.member_12, _e2102.member_13, _e2102.member_14, _e2102.member_15, _e2102.member_16, _e2102.member_17, _e2102.member_18, _e2102.member_19, _e2102.member_20, _e2102.member_21, _e2102.member_22, _e2102.member_23, _e2102.member_24, _e2102.member_25, _e2102.member_26, _e2102.member_27);
let _e5572 = type_25(_e5541.member, _e5541.member_1, _e5541.member_2, _e5541.member_3, _e5541.member_4, _e5541.member_5, _e5541.member_6, _e5541.member_7, _e5541.member_8, _e5541.member_9, _e5541.member_10, _e5541.member_11, _e5541.member_12, select(1.1754944e-38f, _e2102.member_14, (_e2102.member_14 > 1.1754944e-38f)), _e5541.member_14, _e5541.member_15, _e5541.member_16, _e5541.member_17, _e5541.member_18, _e5541.member_19, _e5541.member_20, _e5541.member_21, _e5541.member_22, _e5541.member_23, _e5541.member_24, _e5541.member_25, _e5541.member_26, _e5541.member_27);
let _e5600 = type_25(_e5572.member, _e5572.member_1, _e5572.member_2, _e5572.member_3, _e5572.member_4, _e5572.member_5, _e5572.member_6, _e5572.member_7, _e5572.member_8, _e5572.member_9, _e5572.member_10, 0i, _e5572.member_12, _e5572.member_13, _e5572.member_14, _e5572.member_15, _e5572.member_16, _e5572.member_17, _e5572.member_18, _e5572.member_19, _e5572.member_20, _e5572.member_21, _e5572.member_22, _e5572.member_23, _e5572.member_24, _e5572.member_25, _e5572.member_26, _e5572.member_27);
let _e5628 = type_25(_e5600.member, _e5600.member_1, _e5600.member_2, _e5600.member_3, _e5600.member_4, _e5600.member_5, _e5600.member_6, _e5600.member_7, _e5600.member_8, _e5600.member_9, _e5600.member_10, _e5600.member_11, 0i, _e5600.member_13, _e5600.member_14, _e5600.member_15, _e5600.member_16, _e5600.member_17, _e5600.member_18, _e5600.member_19, _e5600.member_20, _e5600.member_21, _e5600.member_22, _e5600.member_23, _e5600.member_24, _e5600.member_25, _e5600.member_26, _e5600.member_27);
let _e5635 = global_5.member.member_14.member.member;
let _e5649 = ((((_e5635.member.member * _e2102.member.x) + (_e5635.member.member_1 * _e2102.member.y)) + (_e5635.member.member_2 * _e2102.member.z)) + _e5635.member_1);
let _e5658 = -((((_e5635.member.member * _e2102.member_1.x) + (_e5635.member.member_1 * _e2102.member_1.y)) + (_e5635.member.member_2 * _e2102.member_1.z)));
let _e5660 = (_e5658 > 1e-9f);
let _e5664 = ((_e5649 / select(1e-9f, _e5658, _e5660)) - 0.015625f);
let _e5667 = select(1e30f, select(0f, _e5664, (_e5664 > 0f)), ((_e5649 > 0f) && _e5660));
let _e5672 = global_5.member.member_14.member_1.member;
let _e5683 = ((((_e5672.member.member * _e2102.member.x) + (_e5672.member.member_1 * _e2102.member.y)) + (_e5672.member.member_2 * _e2102.member.z)) + _e5672.member_1);
let _e5689 = -((((_e5672.member.member * _e2102.member_1.x) + (_e5672.member.member_1 * _e2102.member_1.y)) + (_e5672.member.member_2 * _e2102.member_1.z)));
let _e5691 = (_e5689 > 1e-9f);
let _e5695 = ((_e5683 / select(1e-9f, _e5689, _e5691)) - 0.015625f);
let _e5698 = select(1e30f, select(0f, _e5695, (_e5695 > 0f)), ((_e5683 > 0f) && _e5691));
let _e5702 = (_e5698 < _e5667);
let _e5733 = type_25(_e5628.member, _e5628.member_1, _e5628.member_2, _e5628.member_3, _e5628.member_4, _e5628.member_5, _e5628.member_6, _e5628.member_7, 0i, _e5628.member_9, _e5628.member_10, _e5628.member_11, _e5628.member_12, _e5628.member_13, _e5628.member_14, _e5628.member_15, _e5628.member_16, _e5628.member_17, _e5628.member_18, _e5628.member_19, _e5628.member_20, _e5628.member_21, _e5628.member_22, _e5628.member_23, _e5628.member_24, _e5628.member_25, _e5628.member_26, _e5628.member_27);
let _e5761 = type_25(_e5733.member, _e5733.member_1, _e5733.member_2, _e5733.member_3, _e5733.member_4, _e5733.member_5, _e5733.member_6, _e5733.member_7, _e5733.member_8, select(select(-2i, -3i, _e5702), -1i, ((_e5667 >= 1e30f) && (_e5698 >= 1e30f))), _e5733.member_10, _e5733.member_11, _e5733.member_12, _e5733.member_13, _e5733.member_14, _e5733.member_15, _e5733.member_16, _e5733.member_17, _e5733.member_18, _e5733.member_19, _e5733.member_20, _e5733.member_21, _e5733.member_22, _e5733.member_23, _e5733.member_24, _e5733.member_25, _e5733.member_26, _e5733.member_27);
phi_9414_ = type_25(_e5761.member, _e5761.member_1, _e5761.member_2, _e5761.member_3, _e5761.member_4, _e5761.member_5, _e5761.member_6, _e5761.member_7, _e5761.member_8, _e5761.member_9, select(_e5667, _e5698, _e5702), _e5761.member_11, _e5761.member_12, _e5761.member_13, _e5761.member_14, _e5761.member_15, _e5761.member_16, _e5761.member_17, _e5761.member_18, _e5761.member_19, _e5761.member_20, _e5761.member_21, _e5761.member_22, _e5761.member_23, _e5761.member_24, _e5761.member_25, _e5761.member_26, _e5761.member_27);
phi_9415_ = type_25();
} else {
let _e2124 = (_e2102.member.x + (_e2102.member_1.x * _e2102.member_10));
let _e2127 = (_e2102.member.y + (_e2102.member_1.y * _e2102.member_10));
let _e2130 = (_e2102.member.z + (_e2102.member_1.z * _e2102.member_10));
let _e2159 = type_25(vec3<f32>(_e2124, _e2127, _e2130), _e2102.member_1, _e2102.member_2, _e2102.member_3, _e2102.member_4, _e2102.member_5, _e2102.member_6, _e2102.member_7, _e2102.member_8, _e2102.member_9, _e2102.member_10, _e2102.member_11, _e2102.member_12, _e2102.member_13, _e2102.member_14, _e2102.member_15, _e2102.member_16, _e2102.member_17, _e2102.member_18, _e2102.member_19, _e2102.member_20, _e2102.member_21, _e2102.member_22, _e2102.member_23, _e2102.member_24, _e2102.member_25, _e2102.member_26, _e2102.member_27);
let _e2161 = (_e2102.member_9 * 19i);
let _e2163 = select(_e1467, _e2161, (_e2161 < _e1467));
let _e2169 = global_2.member[bitcast<u32>(select(0i, _e2163, (_e2163 > 0i)))];
let _e2170 = (_e2161 + 1i);
let _e2172 = select(_e1467, _e2170, (_e2170 < _e1467));
let _e2178 = global_2.member[bitcast<u32>(select(0i, _e2172, (_e2172 > 0i)))];
let _e2179 = (_e2161 + 2i);
let _e2181 = select(_e1467, _e2179, (_e2179 < _e1467));
let _e2187 = global_2.member[bitcast<u32>(select(0i, _e2181, (_e2181 > 0i)))];
let _e2188 = (_e2161 + 3i);
let _e2190 = select(_e1467, _e2188, (_e2188 < _e1467));
let _e2196 = global_2.member[bitcast<u32>(select(0i, _e2190, (_e2190 > 0i)))];
let _e2197 = (_e2161 + 4i);
let _e2199 = select(_e1467, _e2197, (_e2197 < _e1467));
let _e2205 = global_2.member[bitcast<u32>(select(0i, _e2199, (_e2199 > 0i)))];
let _e2206 = (_e2161 + 5i);
let _e2208 = select(_e1467, _e2206, (_e2206 < _e1467));
let _e2214 = global_2.member[bitcast<u32>(select(0i, _e2208, (_e2208 > 0i)))];
let _e2215 = (_e2196 - _e2169);
let _e2216 = (_e2205 - _e2178);
let _e2217 = (_e2214 - _e2187);
let _e2218 = (_e2161 + 6i);
let _e2220 = select(_e1467, _e2218, (_e2218 < _e1467));
let _e2226 = global_2.member[bitcast<u32>(select(0i, _e2220, (_e2220 > 0i)))];
let _e2227 = (_e2161 + 7i);
let _e2229 = select(_e1467, _e2227, (_e2227 < _e1467));
let _e2235 = global_2.member[bitcast<u32>(select(0i, _e2229, (_e2229 > 0i)))];
let _e2236 = (_e2161 + 8i);
let _e2238 = select(_e1467, _e2236, (_e2236 < _e1467));
let _e2244 = global_2.member[bitcast<u32>(select(0i, _e2238, (_e2238 > 0i)))];
let _e2245 = (_e2226 - _e2169);
let _e2246 = (_e2235 - _e2178);
let _e2247 = (_e2244 - _e2187);
let _e2250 = ((_e2216 * _e2247) - (_e2217 * _e2246));
let _e2253 = ((_e2217 * _e2245) - (_e2215 * _e2247));
let _e2256 = ((_e2215 * _e2246) - (_e2216 * _e2245));
let _e2261 = (((_e2250 * _e2250) + (_e2253 * _e2253)) + (_e2256 * _e2256));
let _e2273 = (1f / select(1e-30f, _e2261, (_e2261 > 1e-30f)));
let _e2274 = (((_e2246 * _e2256) - (_e2247 * _e2253)) * _e2273);
let _e2275 = (((_e2247 * _e2250) - (_e2245 * _e2256)) * _e2273);
let _e2276 = (((_e2245 * _e2253) - (_e2246 * _e2250)) * _e2273);
let _e2286 = (((_e2253 * _e2217) - (_e2256 * _e2216)) * _e2273);
let _e2287 = (((_e2256 * _e2215) - (_e2250 * _e2217)) * _e2273);
let _e2288 = (((_e2250 * _e2216) - (_e2253 * _e2215)) * _e2273);
let _e2289 = (_e2161 + 9i);
let _e2291 = select(_e1467, _e2289, (_e2289 < _e1467));
let _e2297 = global_2.member[bitcast<u32>(select(0i, _e2291, (_e2291 > 0i)))];
let _e2298 = (_e2161 + 10i);
let _e2300 = select(_e1467, _e2298, (_e2298 < _e1467));
let _e2306 = global_2.member[bitcast<u32>(select(0i, _e2300, (_e2300 > 0i)))];
let _e2307 = (_e2161 + 11i);
let _e2309 = select(_e1467, _e2307, (_e2307 < _e1467));
let _e2315 = global_2.member[bitcast<u32>(select(0i, _e2309, (_e2309 > 0i)))];
let _e2316 = (_e2161 + 12i);
let _e2318 = select(_e1467, _e2316, (_e2316 < _e1467));
let _e2324 = global_2.member[bitcast<u32>(select(0i, _e2318, (_e2318 > 0i)))];
let _e2325 = (_e2161 + 13i);
let _e2327 = select(_e1467, _e2325, (_e2325 < _e1467));
let _e2333 = global_2.member[bitcast<u32>(select(0i, _e2327, (_e2327 > 0i)))];
let _e2334 = (_e2161 + 14i);
let _e2336 = select(_e1467, _e2334, (_e2334 < _e1467));
let _e2342 = global_2.member[bitcast<u32>(select(0i, _e2336, (_e2336 > 0i)))];
let _e2343 = (_e2324 - _e2297);
let _e2344 = (_e2333 - _e2306);
let _e2345 = (_e2342 - _e2315);
let _e2346 = (_e2161 + 15i);
let _e2348 = select(_e1467, _e2346, (_e2346 < _e1467));
let _e2354 = global_2.member[bitcast<u32>(select(0i, _e2348, (_e2348 > 0i)))];
let _e2355 = (_e2161 + 16i);
let _e2357 = select(_e1467, _e2355, (_e2355 < _e1467));
let _e2363 = global_2.member[bitcast<u32>(select(0i, _e2357, (_e2357 > 0i)))];
let _e2364 = (_e2161 + 17i);
let _e2366 = select(_e1467, _e2364, (_e2364 < _e1467));
let _e2372 = global_2.member[bitcast<u32>(select(0i, _e2366, (_e2366 > 0i)))];
let _e2373 = (_e2354 - _e2297);
let _e2374 = (_e2363 - _e2306);
let _e2375 = (_e2372 - _e2315);
let _e2376 = (_e2124 - _e2169);
let _e2377 = (_e2127 - _e2178);
let _e2378 = (_e2130 - _e2187);
let _e2383 = (((_e2274 * _e2376) + (_e2275 * _e2377)) + (_e2276 * _e2378));
let _e2394 = (((_e2286 * _e2376) + (_e2287 * _e2377)) + (_e2288 * _e2378));
let _e2398 = ((_e2297 + (_e2343 * _e2383)) + (_e2373 * _e2394));
let _e2399 = ((_e2306 + (_e2344 * _e2383)) + (_e2374 * _e2394));
let _e2400 = ((_e2315 + (_e2345 * _e2383)) + (_e2375 * _e2394));
let _e2405 = (((_e2398 * _e2398) + (_e2399 * _e2399)) + (_e2400 * _e2400));
let _e2408 = sqrt(select(0f, _e2405, (_e2405 > 0f)));
let _e2411 = (1f / select(1e-20f, _e2408, (_e2408 > 1e-20f)));
let _e2414 = sqrt(select(0f, _e2261, (_e2261 > 0f)));
let _e2417 = (1f / select(1e-20f, _e2414, (_e2414 > 1e-20f)));
let _e2418 = (_e2250 * _e2417);
let _e2419 = (_e2253 * _e2417);
let _e2420 = (_e2256 * _e2417);
let _e2421 = (_e2398 * _e2411);
let _e2422 = (_e2399 * _e2411);
let _e2423 = (_e2400 * _e2411);
if _e1497 {
phi_6581_ = 1f;
phi_6582_ = 1f;
} else {
let _e2425 = local_4;
let _e2426 = (_e2425 * 4i);
let _e2428 = select(_e1485, _e2426, (_e2426 < _e1485));
let _e2434 = global_3.member[bitcast<u32>(select(0i, _e2428, (_e2428 > 0i)))];
let _e2437 = local_5;
let _e2438 = (_e2437 * 4i);
let _e2440 = select(_e1485, _e2438, (_e2438 < _e1485));
let _e2446 = global_3.member[bitcast<u32>(select(0i, _e2440, (_e2440 > 0i)))];
let _e2448 = local_6;
phi_6581_ = select(_e2446, 1f, (_e2448 == 16i));
phi_6582_ = select(_e2434, 1f, _e1440);
}
let _e2452 = phi_6581_;
let _e2454 = phi_6582_;
let _e2461 = select(1f, -1f, ((((_e2102.member_1.x * _e2421) + (_e2102.member_1.y * _e2422)) + (_e2102.member_1.z * _e2423)) > 0f));
let _e2462 = (_e2421 * _e2461);
let _e2463 = (_e2422 * _e2461);
let _e2464 = (_e2423 * _e2461);
let _e2470 = -((((_e2102.member_1.x * _e2462) + (_e2102.member_1.y * _e2463)) + (_e2102.member_1.z * _e2464)));
let _e2472 = select(0f, _e2470, (_e2470 > 0f));
let _e2473 = (_e2454 / _e2452);
let _e2478 = (1f - ((_e2473 * _e2473) * (1f - (_e2472 * _e2472))));
let _e2479 = (_e2478 <= 0f);
let _e2487 = ((_e2473 * _e2472) - sqrt(select(0f, _e2478, (_e2478 > 0f))));
let _e2494 = (2f * _e2472);
let _e2498 = (_e2102.member_1.x + (_e2462 * _e2494));
let _e2499 = (_e2102.member_1.y + (_e2463 * _e2494));
let _e2500 = (_e2102.member_1.z + (_e2464 * _e2494));
let _e2501 = select(((_e2102.member_1.x * _e2473) + (_e2462 * _e2487)), _e2498, _e2479);
let _e2502 = select(((_e2102.member_1.y * _e2473) + (_e2463 * _e2487)), _e2499, _e2479);
let _e2503 = select(((_e2102.member_1.z * _e2473) + (_e2464 * _e2487)), _e2500, _e2479);
let _e2508 = (((_e2501 * _e2501) + (_e2502 * _e2502)) + (_e2503 * _e2503));
let _e2511 = sqrt(select(0f, _e2508, (_e2508 > 0f)));
let _e2514 = (1f / select(1e-20f, _e2511, (_e2511 > 1e-20f)));
let _e2522 = (((_e2102.member_1.x * _e2418) + (_e2102.member_1.y * _e2419)) + (_e2102.member_1.z * _e2420));
let _e2549 = !((((((((_e2421 * _e2102.member_1.x) + (_e2422 * _e2102.member_1.y)) + (_e2423 * _e2102.member_1.z)) * _e2522) > 0f) && (((((((_e2501 * _e2514) * _e2418) + ((_e2502 * _e2514) * _e2419)) + ((_e2503 * _e2514) * _e2420)) * select(1f, -1f, _e2479)) * _e2522) > 0f)) && ((-((((_e2498 * _e2418) + (_e2499 * _e2419)) + (_e2500 * _e2420))) * _e2522) > 0f)));
let _e2550 = select(_e2421, _e2418, _e2549);
let _e2551 = select(_e2422, _e2419, _e2549);
let _e2552 = select(_e2423, _e2420, _e2549);
let _e2553 = select(_e2274, 0f, _e2549);
let _e2554 = select(_e2275, 0f, _e2549);
let _e2555 = select(_e2276, 0f, _e2549);
let _e2556 = select(_e2286, 0f, _e2549);
let _e2557 = select(_e2287, 0f, _e2549);
let _e2558 = select(_e2288, 0f, _e2549);
let _e2570 = (_e2102.member_2.x + (_e2102.member_4.x * _e2102.member_10));
let _e2572 = (_e2102.member_2.y + (_e2102.member_4.y * _e2102.member_10));
let _e2574 = (_e2102.member_2.z + (_e2102.member_4.z * _e2102.member_10));
let _e2582 = (_e2102.member_3.x + (_e2102.member_5.x * _e2102.member_10));
let _e2584 = (_e2102.member_3.y + (_e2102.member_5.y * _e2102.member_10));
let _e2586 = (_e2102.member_3.z + (_e2102.member_5.z * _e2102.member_10));
if ((_e2522 * _e2522) > 1e-12f) {
phi_6815_ = (1f / _e2522);
} else {
phi_6815_ = 0f;
}
let _e2591 = phi_6815_;
let _e2597 = ((((_e2570 * _e2418) + (_e2572 * _e2419)) + (_e2574 * _e2420)) * _e2591);
let _e2601 = (_e2570 - (_e2102.member_1.x * _e2597));
let _e2602 = (_e2572 - (_e2102.member_1.y * _e2597));
let _e2603 = (_e2574 - (_e2102.member_1.z * _e2597));
let _e2604 = vec3<f32>(_e2601, _e2602, _e2603);
let _e2610 = ((((_e2582 * _e2418) + (_e2584 * _e2419)) + (_e2586 * _e2420)) * _e2591);
let _e2614 = (_e2582 - (_e2102.member_1.x * _e2610));
let _e2615 = (_e2584 - (_e2102.member_1.y * _e2610));
let _e2616 = (_e2586 - (_e2102.member_1.z * _e2610));
let _e2617 = vec3<f32>(_e2614, _e2615, _e2616);
let _e2645 = type_25(_e2159.member, _e2159.member_1, _e2604, _e2159.member_3, _e2159.member_4, _e2159.member_5, _e2159.member_6, _e2159.member_7, _e2159.member_8, _e2159.member_9, _e2159.member_10, _e2159.member_11, _e2159.member_12, _e2159.member_13, _e2159.member_14, _e2159.member_15, _e2159.member_16, _e2159.member_17, _e2159.member_18, _e2159.member_19, _e2159.member_20, _e2159.member_21, _e2159.member_22, _e2159.member_23, _e2159.member_24, _e2159.member_25, _e2159.member_26, _e2159.member_27);
let _e2673 = type_25(_e2645.member, _e2645.member_1, _e2645.member_2, _e2617, _e2645.member_4, _e2645.member_5, _e2645.member_6, _e2645.member_7, _e2645.member_8, _e2645.member_9, _e2645.member_10, _e2645.member_11, _e2645.member_12, _e2645.member_13, _e2645.member_14, _e2645.member_15, _e2645.member_16, _e2645.member_17, _e2645.member_18, _e2645.member_19, _e2645.member_20, _e2645.member_21, _e2645.member_22, _e2645.member_23, _e2645.member_24, _e2645.member_25, _e2645.member_26, _e2645.member_27);
let _e2701 = type_25(_e2673.member, _e2673.member_1, _e2673.member_2, _e2673.member_3, _e2102.member_4, _e2673.member_5, _e2673.member_6, _e2673.member_7, _e2673.member_8, _e2673.member_9, _e2673.member_10, _e2673.member_11, _e2673.member_12, _e2673.member_13, _e2673.member_14, _e2673.member_15, _e2673.member_16, _e2673.member_17, _e2673.member_18, _e2673.member_19, _e2673.member_20, _e2673.member_21, _e2673.member_22, _e2673.member_23, _e2673.member_24, _e2673.member_25, _e2673.member_26, _e2673.member_27);
let _e2729 = type_25(_e2701.member, _e2701.member_1, _e2701.member_2, _e2701.member_3, _e2701.member_4, _e2102.member_5, _e2701.member_6, _e2701.member_7, _e2701.member_8, _e2701.member_9, _e2701.member_10, _e2701.member_11, _e2701.member_12, _e2701.member_13, _e2701.member_14, _e2701.member_15, _e2701.member_16, _e2701.member_17, _e2701.member_18, _e2701.member_19, _e2701.member_20, _e2701.member_21, _e2701.member_22, _e2701.member_23, _e2701.member_24, _e2701.member_25, _e2701.member_26, _e2701.member_27);
if _e1497 {
let _e3463 = (_e1483 + 1i);
let _e3465 = select(_e1485, _e3463, (_e3463 < _e1485));
let _e3471 = global_3.member[bitcast<u32>(select(0i, _e3465, (_e3465 > 0i)))];
let _e3472 = (_e1483 + 2i);
let _e3474 = select(_e1485, _e3472, (_e3472 < _e1485));
let _e3480 = global_3.member[bitcast<u32>(select(0i, _e3474, (_e3474 > 0i)))];
let _e3481 = (_e1483 + 3i);
let _e3483 = select(_e1485, _e3481, (_e3481 < _e1485));
let _e3489 = global_3.member[bitcast<u32>(select(0i, _e3483, (_e3483 > 0i)))];
let _e3496 = (1f / 3f);
let _e3500 = (_e2102.member_6.x * _e3471);
let _e3503 = (_e2102.member_6.y * _e3480);
let _e3506 = (_e2102.member_6.z * _e3489);
let _e3535 = type_25(_e2729.member, _e2729.member_1, _e2729.member_2, _e2729.member_3, _e2729.member_4, _e2729.member_5, vec3<f32>(_e3500, _e3503, _e3506), _e2729.member_7, _e2729.member_8, _e2729.member_9, _e2729.member_10, _e2729.member_11, _e2729.member_12, _e2729.member_13, _e2729.member_14, _e2729.member_15, _e2729.member_16, _e2729.member_17, _e2729.member_18, _e2729.member_19, _e2729.member_20, _e2729.member_21, _e2729.member_22, _e2729.member_23, _e2729.member_24, _e2729.member_25, _e2729.member_26, _e2729.member_27);
if (bitcast<i32>(countOneBits(bitcast<u32>((_e2102.member_17 & ((1i << bitcast<u32>((_e2102.member_16 & 31i))) - 1i))))) == _e2102.member_20) {
phi_6946_ = ((((_e2102.member_6.x + _e2102.member_6.y) + _e2102.member_6.z) * _e3496) - (((_e3500 + _e3503) + _e3506) * _e3496));
} else {
phi_6946_ = 0f;
}
let _e3553 = phi_6946_;
let _e3583 = type_25(_e3535.member, _e3535.member_1, _e3535.member_2, _e3535.member_3, _e3535.member_4, _e3535.member_5, _e3535.member_6, _e3535.member_7, _e3535.member_8, _e3535.member_9, _e3535.member_10, _e3535.member_11, _e3535.member_12, _e3535.member_13, _e3535.member_14, _e3535.member_15, _e3535.member_16, _e3535.member_17, _e3535.member_18, _e3535.member_19, _e3535.member_20, _e3535.member_21, _e3535.member_22, _e3535.member_23, _e3535.member_24, (_e2102.member_25 + _e3553), _e3535.member_26, _e3535.member_27);
let _e3590 = select(1f, -1f, ((((_e2550 * _e2102.member_1.x) + (_e2551 * _e2102.member_1.y)) + (_e2552 * _e2102.member_1.z)) > 0f));
let _e3591 = (_e2550 * _e3590);
let _e3592 = (_e2551 * _e3590);
let _e3593 = (_e2552 * _e3590);
let _e3594 = (_e2343 * _e3590);
let _e3595 = (_e2344 * _e3590);
let _e3596 = (_e2345 * _e3590);
let _e3597 = (_e2373 * _e3590);
let _e3598 = (_e2374 * _e3590);
let _e3599 = (_e2375 * _e3590);
let _e3604 = (((_e2553 * _e2601) + (_e2554 * _e2602)) + (_e2555 * _e2603));
let _e3612 = (((_e2556 * _e2601) + (_e2557 * _e2602)) + (_e2558 * _e2603));
let _e3619 = (((_e3594 * _e3604) + (_e3597 * _e3612)) * _e2411);
let _e3620 = (((_e3595 * _e3604) + (_e3598 * _e3612)) * _e2411);
let _e3621 = (((_e3596 * _e3604) + (_e3599 * _e3612)) * _e2411);
let _e3626 = (((_e3591 * _e3619) + (_e3592 * _e3620)) + (_e3593 * _e3621));
let _e3630 = (_e3619 - (_e3591 * _e3626));
let _e3631 = (_e3620 - (_e3592 * _e3626));
let _e3632 = (_e3621 - (_e3593 * _e3626));
let _e3637 = (((_e2102.member_1.x * _e3591) + (_e2102.member_1.y * _e3592)) + (_e2102.member_1.z * _e3593));
let _e3638 = -(_e3637);
let _e3650 = -(((((_e2102.member_4.x * _e3591) + (_e2102.member_4.y * _e3592)) + (_e2102.member_4.z * _e3593)) + (((_e2102.member_1.x * _e3630) + (_e2102.member_1.y * _e3631)) + (_e2102.member_1.z * _e3632))));
let _e3669 = (((_e2553 * _e2614) + (_e2554 * _e2615)) + (_e2555 * _e2616));
let _e3677 = (((_e2556 * _e2614) + (_e2557 * _e2615)) + (_e2558 * _e2616));
let _e3684 = (((_e3594 * _e3669) + (_e3597 * _e3677)) * _e2411);
let _e3685 = (((_e3595 * _e3669) + (_e3598 * _e3677)) * _e2411);
let _e3686 = (((_e3596 * _e3669) + (_e3599 * _e3677)) * _e2411);
let _e3691 = (((_e3591 * _e3684) + (_e3592 * _e3685)) + (_e3593 * _e3686));
let _e3695 = (_e3684 - (_e3591 * _e3691));
let _e3696 = (_e3685 - (_e3592 * _e3691));
let _e3697 = (_e3686 - (_e3593 * _e3691));
let _e3709 = -(((((_e2102.member_5.x * _e3591) + (_e2102.member_5.y * _e3592)) + (_e2102.member_5.z * _e3593)) + (((_e2102.member_1.x * _e3695) + (_e2102.member_1.y * _e3696)) + (_e2102.member_1.z * _e3697))));
let _e3751 = type_25(_e3583.member, _e3583.member_1, _e2604, _e3583.member_3, _e3583.member_4, _e3583.member_5, _e3583.member_6, _e3583.member_7, _e3583.member_8, _e3583.member_9, _e3583.member_10, _e3583.member_11, _e3583.member_12, _e3583.member_13, _e3583.member_14, _e3583.member_15, _e3583.member_16, _e3583.member_17, _e3583.member_18, _e3583.member_19, _e3583.member_20, _e3583.member_21, _e3583.member_22, _e3583.member_23, _e3583.member_24, _e3583.member_25, _e3583.member_26, _e3583.member_27);
let _e3779 = type_25(_e3751.member, _e3751.member_1, _e3751.member_2, _e2617, _e3751.member_4, _e3751.member_5, _e3751.member_6, _e3751.member_7, _e3751.member_8, _e3751.member_9, _e3751.member_10, _e3751.member_11, _e3751.member_12, _e3751.member_13, _e3751.member_14, _e3751.member_15, _e3751.member_16, _e3751.member_17, _e3751.member_18, _e3751.member_19, _e3751.member_20, _e3751.member_21, _e3751.member_22, _e3751.member_23, _e3751.member_24, _e3751.member_25, _e3751.member_26, _e3751.member_27);
let _e3807 = type_25(_e3779.member, _e3779.member_1, _e3779.member_2, _e3779.member_3, (_e2102.member_4 + vec3<f32>((((_e3630 * _e3638) + (_e3591 * _e3650)) * 2f), (((_e3631 * _e3638) + (_e3592 * _e3650)) * 2f), (((_e3632 * _e3638) + (_e3593 * _e3650)) * 2f))), _e3779.member_5, _e3779.member_6, _e3779.member_7, _e3779.member_8, _e3779.member_9, _e3779.member_10, _e3779.member_11, _e3779.member_12, _e3779.member_13, _e3779.member_14, _e3779.member_15, _e3779.member_16, _e3779.member_17, _e3779.member_18, _e3779.member_19, _e3779.member_20, _e3779.member_21, _e3779.member_22, _e3779.member_23, _e3779.member_24, _e3779.member_25, _e3779.member_26, _e3779.member_27);
let _e3835 = type_25(_e3807.member, _e3807.member_1, _e3807.member_2, _e3807.member_3, _e3807.member_4, (_e2102.member_5 + vec3<f32>((((_e3695 * _e3638) + (_e3591 * _e3709)) * 2f), (((_e3696 * _e3638) + (_e3592 * _e3709)) * 2f), (((_e3697 * _e3638) + (_e3593 * _e3709)) * 2f))), _e3807.member_6, _e3807.member_7, _e3807.member_8, _e3807.member_9, _e3807.member_10, _e3807.member_11, _e3807.member_12, _e3807.member_13, _e3807.member_14, _e3807.member_15, _e3807.member_16, _e3807.member_17, _e3807.member_18, _e3807.member_19, _e3807.member_20, _e3807.member_21, _e3807.member_22, _e3807.member_23, _e3807.member_24, _e3807.member_25, _e3807.member_26, _e3807.member_27);
let _e3837 = select(1f, -1f, (_e3637 > 0f));
let _e3838 = (_e3591 * _e3837);
let _e3839 = (_e3592 * _e3837);
let _e3840 = (_e3593 * _e3837);
let _e3846 = -((((_e2102.member_1.x * _e3838) + (_e2102.member_1.y * _e3839)) + (_e2102.member_1.z * _e3840)));
let _e3849 = (2f * select(0f, _e3846, (_e3846 > 0f)));
let _e3882 = type_25(_e3835.member, (_e2102.member_1 + vec3<f32>((_e3838 * _e3849), (_e3839 * _e3849), (_e3840 * _e3849))), _e3835.member_2, _e3835.member_3, _e3835.member_4, _e3835.member_5, _e3835.member_6, _e3835.member_7, _e3835.member_8, _e3835.member_9, _e3835.member_10, _e3835.member_11, _e3835.member_12, _e3835.member_13, _e3835.member_14, _e3835.member_15, _e3835.member_16, _e3835.member_17, _e3835.member_18, _e3835.member_19, _e3835.member_20, _e3835.member_21, _e3835.member_22, _e3835.member_23, _e3835.member_24, _e3835.member_25, _e3835.member_26, _e3835.member_27);
phi_7950_ = type_25(_e3882.member, _e3882.member_1, _e3882.member_2, _e3882.member_3, _e3882.member_4, _e3882.member_5, _e3882.member_6, _e3882.member_7, _e3882.member_8, _e3882.member_9, _e3882.member_10, _e3882.member_11, _e3882.member_12, _e3882.member_13, _e3882.member_14, _e3882.member_15, (_e2102.member_16 + 1i), _e3882.member_17, _e3882.member_18, _e3882.member_19, _e3882.member_20, _e3882.member_21, _e3882.member_22, _e3882.member_23, _e3882.member_24, _e3882.member_25, _e3882.member_26, _e3882.member_27);
} else {
let _e2733 = global_5.member.member_12.member_1;
let _e2735 = local_7;
let _e2736 = (_e2735 * 4i);
let _e2738 = select(_e1485, _e2736, (_e2736 < _e1485));
let _e2744 = global_3.member[bitcast<u32>(select(0i, _e2738, (_e2738 > 0i)))];
let _e2745 = select(_e2744, 1f, _e1440);
let _e2747 = local_8;
let _e2748 = (_e2747 * 4i);
let _e2750 = select(_e1485, _e2748, (_e2748 < _e1485));
let _e2756 = global_3.member[bitcast<u32>(select(0i, _e2750, (_e2750 > 0i)))];
let _e2758 = local_9;
let _e2760 = select(_e2756, 1f, (_e2758 == 16i));
let _e2767 = select(1f, -1f, ((((_e2102.member_1.x * _e2550) + (_e2102.member_1.y * _e2551)) + (_e2102.member_1.z * _e2552)) > 0f));
let _e2768 = (_e2550 * _e2767);
let _e2769 = (_e2551 * _e2767);
let _e2770 = (_e2552 * _e2767);
let _e2776 = -((((_e2102.member_1.x * _e2768) + (_e2102.member_1.y * _e2769)) + (_e2102.member_1.z * _e2770)));
let _e2778 = select(0f, _e2776, (_e2776 > 0f));
let _e2779 = (_e2745 / _e2760);
let _e2780 = (_e2779 * _e2779);
let _e2781 = (_e2778 * _e2778);
let _e2784 = (1f - (_e2780 * (1f - _e2781)));
let _e2785 = (_e2784 <= 0f);
let _e2793 = ((_e2779 * _e2778) - sqrt(select(0f, _e2784, (_e2784 > 0f))));
let _e2800 = (2f * _e2778);
let _e2801 = (_e2768 * _e2800);
let _e2802 = (_e2769 * _e2800);
let _e2803 = (_e2770 * _e2800);
let _e2809 = select(((_e2102.member_1.x * _e2779) + (_e2768 * _e2793)), (_e2102.member_1.x + _e2801), _e2785);
let _e2810 = select(((_e2102.member_1.y * _e2779) + (_e2769 * _e2793)), (_e2102.member_1.y + _e2802), _e2785);
let _e2811 = select(((_e2102.member_1.z * _e2779) + (_e2770 * _e2793)), (_e2102.member_1.z + _e2803), _e2785);
let _e2816 = (((_e2809 * _e2809) + (_e2810 * _e2810)) + (_e2811 * _e2811));
let _e2819 = sqrt(select(0f, _e2816, (_e2816 > 0f)));
let _e2822 = (1f / select(1e-20f, _e2819, (_e2819 > 1e-20f)));
let _e2827 = (_e2760 / _e2745);
let _e2830 = (((_e2827 * _e2827) - 1f) + _e2781);
let _e2833 = sqrt(select(0f, _e2830, (_e2830 > 0f)));
let _e2834 = (_e2833 - _e2778);
let _e2835 = (_e2833 + _e2778);
let _e2838 = (_e2834 / select(1e-6f, _e2835, (_e2835 > 1e-6f)));
let _e2842 = ((_e2778 * _e2834) + 1f);
let _e2845 = (((_e2778 * _e2835) - 1f) / select(1e-6f, _e2842, (_e2842 > 1e-6f)));
let _e2854 = select(select((((0.5f * _e2838) * _e2838) * (1f + (_e2845 * _e2845))), 1f, (_e2830 <= 0f)), 0f, (_e2745 == _e2760));
let _e2857 = (1f - _e2854);
let _e2859 = select(_e2857, _e2854, (_e2854 < _e2857));
let _e2863 = (_e2102.member_16 & 31i);
if (!(_e2785) && (_e2102.member_16 >= _e2102.member_19)) {
let _e2876 = select(_e2102.member_6.y, _e2102.member_6.x, (_e2102.member_6.x > _e2102.member_6.y));
let _e2881 = ((select(_e2102.member_6.z, _e2876, (_e2876 > _e2102.member_6.z)) * _e2859) >= _e2733);
let _e2883 = (1i << bitcast<u32>(_e2863));
if (bitcast<i32>(countOneBits(bitcast<u32>((_e2102.member_17 & (_e2883 - 1i))))) == _e2102.member_20) {
if _e2881 {
phi_7619_ = type_25(_e2729.member, _e2729.member_1, _e2729.member_2, _e2729.member_3, _e2729.member_4, _e2729.member_5, _e2729.member_6, _e2729.member_7, _e2729.member_8, _e2729.member_9, _e2729.member_10, _e2729.member_11, _e2729.member_12, _e2729.member_13, _e2729.member_14, _e2729.member_15, _e2729.member_16, _e2729.member_17, _e2729.member_18, _e2729.member_19, _e2729.member_20, 1i, _e2729.member_22, _e2729.member_23, _e2729.member_24, _e2729.member_25, _e2729.member_26, _e2729.member_27);
} else {
phi_7619_ = type_25(_e2729.member, _e2729.member_1, _e2729.member_2, _e2729.member_3, _e2729.member_4, _e2729.member_5, _e2729.member_6, _e2729.member_7, _e2729.member_8, _e2729.member_9, _e2729.member_10, _e2729.member_11, _e2729.member_12, _e2729.member_13, _e2729.member_14, _e2729.member_15, _e2729.member_16, _e2729.member_17, _e2729.member_18, _e2729.member_19, _e2729.member_20, _e2729.member_21, _e2729.member_22, _e2729.member_23, _e2729.member_24, _e2729.member_25, _e2729.member_26, (_e2102.member_27 + ((((_e2102.member_6.x + _e2102.member_6.y) + _e2102.member_6.z) * (1f / 3f)) * _e2859)));
}
let _e2986 = phi_7619_;
phi_7629_ = _e2986;
} else {
phi_7629_ = type_25(_e2729.member, _e2729.member_1, _e2729.member_2, _e2729.member_3, _e2729.member_4, _e2729.member_5, _e2729.member_6, _e2729.member_7, _e2729.member_8, _e2729.member_9, _e2729.member_10, _e2729.member_11, _e2729.member_12, _e2729.member_13, _e2729.member_14, _e2729.member_15, _e2729.member_16, _e2729.member_17, (_e2102.member_18 | select(0i, _e2883, _e2881)), _e2729.member_19, _e2729.member_20, _e2729.member_21, _e2729.member_22, _e2729.member_23, _e2729.member_24, _e2729.member_25, _e2729.member_26, _e2729.member_27);
}
let _e2988 = phi_7629_;
phi_7630_ = _e2988;
} else {
phi_7630_ = _e2729;
}
let _e2990 = phi_7630_;
let _e2991 = (((_e2102.member_16 < _e2102.member_19) && (((_e2102.member_17 >> bitcast<u32>(_e2863)) & 1i) == 1i)) != (_e2854 > 0.5f));
let _e2992 = (_e2785 || _e2991);
if _e2785 {
phi_7650_ = _e2990;
} else {
let _e2993 = select(_e2857, _e2854, _e2991);
phi_7650_ = type_25(_e2990.member, _e2990.member_1, _e2990.member_2, _e2990.member_3, _e2990.member_4, _e2990.member_5, vec3<f32>((_e2990.member_6.x * _e2993), (_e2990.member_6.y * _e2993), (_e2990.member_6.z * _e2993)), _e2990.member_7, _e2990.member_8, _e2990.member_9, _e2990.member_10, _e2990.member_11, _e2990.member_12, _e2990.member_13, _e2990.member_14, _e2990.member_15, _e2990.member_16, _e2990.member_17, _e2990.member_18, _e2990.member_19, _e2990.member_20, _e2990.member_21, _e2990.member_22, _e2990.member_23, _e2990.member_24, _e2990.member_25, _e2990.member_26, _e2990.member_27);
}
let _e3033 = phi_7650_;
let _e3044 = select(1f, -1f, ((((_e2550 * _e3033.member_1.x) + (_e2551 * _e3033.member_1.y)) + (_e2552 * _e3033.member_1.z)) > 0f));
let _e3045 = (_e2550 * _e3044);
let _e3046 = (_e2551 * _e3044);
let _e3047 = (_e2552 * _e3044);
let _e3048 = (_e2343 * _e3044);
let _e3049 = (_e2344 * _e3044);
let _e3050 = (_e2345 * _e3044);
let _e3051 = (_e2373 * _e3044);
let _e3052 = (_e2374 * _e3044);
let _e3053 = (_e2375 * _e3044);
let _e3065 = (((_e2553 * _e3033.member_2.x) + (_e2554 * _e3033.member_2.y)) + (_e2555 * _e3033.member_2.z));
let _e3073 = (((_e2556 * _e3033.member_2.x) + (_e2557 * _e3033.member_2.y)) + (_e2558 * _e3033.member_2.z));
let _e3080 = (((_e3048 * _e3065) + (_e3051 * _e3073)) * _e2411);
let _e3081 = (((_e3049 * _e3065) + (_e3052 * _e3073)) * _e2411);
let _e3082 = (((_e3050 * _e3065) + (_e3053 * _e3073)) * _e2411);
let _e3087 = (((_e3045 * _e3080) + (_e3046 * _e3081)) + (_e3047 * _e3082));
let _e3091 = (_e3080 - (_e3045 * _e3087));
let _e3092 = (_e3081 - (_e3046 * _e3087));
let _e3093 = (_e3082 - (_e3047 * _e3087));
let _e3099 = -((((_e3033.member_1.x * _e3045) + (_e3033.member_1.y * _e3046)) + (_e3033.member_1.z * _e3047)));
let _e3114 = -(((((_e3033.member_4.x * _e3045) + (_e3033.member_4.y * _e3046)) + (_e3033.member_4.z * _e3047)) + (((_e3033.member_1.x * _e3091) + (_e3033.member_1.y * _e3092)) + (_e3033.member_1.z * _e3093))));
if _e2992 {
phi_7805_ = (_e3033.member_4 + vec3<f32>((((_e3091 * _e3099) + (_e3045 * _e3114)) * 2f), (((_e3092 * _e3099) + (_e3046 * _e3114)) * 2f), (((_e3093 * _e3099) + (_e3047 * _e3114)) * 2f)));
} else {
let _e3118 = (1f - (_e2780 * (1f - (_e3099 * _e3099))));
let _e3120 = select(1e-12f, _e3118, (_e3118 > 1e-12f));
let _e3123 = sqrt(select(0f, _e3120, (_e3120 > 0f)));
let _e3125 = ((_e2779 * _e3099) - _e3123);
let _e3129 = ((_e2779 - ((_e2780 * _e3099) / _e3123)) * _e3114);
phi_7805_ = vec3<f32>((((_e3033.member_4.x * _e2779) + (_e3091 * _e3125)) + (_e3045 * _e3129)), (((_e3033.member_4.y * _e2779) + (_e3092 * _e3125)) + (_e3046 * _e3129)), (((_e3033.member_4.z * _e2779) + (_e3093 * _e3125)) + (_e3047 * _e3129)));
}
let _e3161 = phi_7805_;
let _e3169 = (((_e2553 * _e3033.member_3.x) + (_e2554 * _e3033.member_3.y)) + (_e2555 * _e3033.member_3.z));
let _e3177 = (((_e2556 * _e3033.member_3.x) + (_e2557 * _e3033.member_3.y)) + (_e2558 * _e3033.member_3.z));
let _e3184 = (((_e3048 * _e3169) + (_e3051 * _e3177)) * _e2411);
let _e3185 = (((_e3049 * _e3169) + (_e3052 * _e3177)) * _e2411);
let _e3186 = (((_e3050 * _e3169) + (_e3053 * _e3177)) * _e2411);
let _e3191 = (((_e3045 * _e3184) + (_e3046 * _e3185)) + (_e3047 * _e3186));
let _e3195 = (_e3184 - (_e3045 * _e3191));
let _e3196 = (_e3185 - (_e3046 * _e3191));
let _e3197 = (_e3186 - (_e3047 * _e3191));
let _e3212 = -(((((_e3033.member_5.x * _e3045) + (_e3033.member_5.y * _e3046)) + (_e3033.member_5.z * _e3047)) + (((_e3033.member_1.x * _e3195) + (_e3033.member_1.y * _e3196)) + (_e3033.member_1.z * _e3197))));
if _e2992 {
phi_7931_ = (_e3033.member_5 + vec3<f32>((((_e3195 * _e3099) + (_e3045 * _e3212)) * 2f), (((_e3196 * _e3099) + (_e3046 * _e3212)) * 2f), (((_e3197 * _e3099) + (_e3047 * _e3212)) * 2f)));
} else {
let _e3216 = (1f - (_e2780 * (1f - (_e3099 * _e3099))));
let _e3218 = select(1e-12f, _e3216, (_e3216 > 1e-12f));
let _e3221 = sqrt(select(0f, _e3218, (_e3218 > 0f)));
let _e3223 = ((_e2779 * _e3099) - _e3221);
let _e3227 = ((_e2779 - ((_e2780 * _e3099) / _e3221)) * _e3212);
phi_7931_ = vec3<f32>((((_e3033.member_5.x * _e2779) + (_e3195 * _e3223)) + (_e3045 * _e3227)), (((_e3033.member_5.y * _e2779) + (_e3196 * _e3223)) + (_e3046 * _e3227)), (((_e3033.member_5.z * _e2779) + (_e3197 * _e3223)) + (_e3047 * _e3227)));
}
let _e3259 = phi_7931_;
let _e3287 = type_25(_e3033.member, _e3033.member_1, _e3033.member_2, _e3033.member_3, _e3033.member_4, _e3033.member_5, _e3033.member_6, _e3033.member_7, _e3033.member_8, _e3033.member_9, _e3033.member_10, _e3033.member_11, _e3033.member_12, _e3033.member_13, _e3033.member_14, _e3033.member_15, _e3033.member_16, _e3033.member_17, _e3033.member_18, _e3033.member_19, _e3033.member_20, _e3033.member_21, _e3033.member_22, _e3033.member_23, _e3033.member_24, _e3033.member_25, _e3033.member_26, _e3033.member_27);
let _e3315 = type_25(_e3287.member, _e3287.member_1, _e3287.member_2, _e3033.member_3, _e3287.member_4, _e3287.member_5, _e3287.member_6, _e3287.member_7, _e3287.member_8, _e3287.member_9, _e3287.member_10, _e3287.member_11, _e3287.member_12, _e3287.member_13, _e3287.member_14, _e3287.member_15, _e3287.member_16, _e3287.member_17, _e3287.member_18, _e3287.member_19, _e3287.member_20, _e3287.member_21, _e3287.member_22, _e3287.member_23, _e3287.member_24, _e3287.member_25, _e3287.member_26, _e3287.member_27);
let _e3343 = type_25(_e3315.member, _e3315.member_1, _e3315.member_2, _e3315.member_3, _e3161, _e3315.member_5, _e3315.member_6, _e3315.member_7, _e3315.member_8, _e3315.member_9, _e3315.member_10, _e3315.member_11, _e3315.member_12, _e3315.member_13, _e3315.member_14, _e3315.member_15, _e3315.member_16, _e3315.member_17, _e3315.member_18, _e3315.member_19, _e3315.member_20, _e3315.member_21, _e3315.member_22, _e3315.member_23, _e3315.member_24, _e3315.member_25, _e3315.member_26, _e3315.member_27);
let _e3371 = type_25(_e3343.member, _e3343.member_1, _e3343.member_2, _e3343.member_3, _e3343.member_4, _e3259, _e3343.member_6, _e3343.member_7, _e3343.member_8, _e3343.member_9, _e3343.member_10, _e3343.member_11, _e3343.member_12, _e3343.member_13, _e3343.member_14, _e3343.member_15, _e3343.member_16, _e3343.member_17, _e3343.member_18, _e3343.member_19, _e3343.member_20, _e3343.member_21, _e3343.member_22, _e3343.member_23, _e3343.member_24, _e3343.member_25, _e3343.member_26, _e3343.member_27);
let _e3401 = type_25(_e3371.member, select(vec3<f32>((_e2809 * _e2822), (_e2810 * _e2822), (_e2811 * _e2822)), (_e2102.member_1 + vec3<f32>(_e2801, _e2802, _e2803)), vec3(_e2992)), _e3371.member_2, _e3371.member_3, _e3371.member_4, _e3371.member_5, _e3371.member_6, _e3371.member_7, _e3371.member_8, _e3371.member_9, _e3371.member_10, _e3371.member_11, _e3371.member_12, _e3371.member_13, _e3371.member_14, _e3371.member_15, _e3371.member_16, _e3371.member_17, _e3371.member_18, _e3371.member_19, _e3371.member_20, _e3371.member_21, _e3371.member_22, _e3371.member_23, _e3371.member_24, _e3371.member_25, _e3371.member_26, _e3371.member_27);
let _e3431 = type_25(_e3401.member, _e3401.member_1, _e3401.member_2, _e3401.member_3, _e3401.member_4, _e3401.member_5, _e3401.member_6, _e3401.member_7, _e3401.member_8, _e3401.member_9, _e3401.member_10, _e3401.member_11, _e3401.member_12, _e3401.member_13, _e3401.member_14, _e3401.member_15, (_e3033.member_16 + 1i), _e3401.member_17, _e3401.member_18, _e3401.member_19, _e3401.member_20, _e3401.member_21, _e3401.member_22, _e3401.member_23, _e3401.member_24, _e3401.member_25, _e3401.member_26, _e3401.member_27);
if !(_e2992) {
phi_7949_ = type_25(_e3431.member, _e3431.member_1, _e3431.member_2, _e3431.member_3, _e3431.member_4, _e3431.member_5, _e3431.member_6, _e1506, _e3431.member_8, _e3431.member_9, _e3431.member_10, _e3431.member_11, _e3431.member_12, _e3431.member_13, _e3431.member_14, _e3431.member_15, _e3431.member_16, _e3431.member_17, _e3431.member_18, _e3431.member_19, _e3431.member_20, _e3431.member_21, _e3431.member_22, _e3431.member_23, _e3431.member_24, _e3431.member_25, _e3431.member_26, _e3431.member_27);
} else {
phi_7949_ = _e3431;
}
let _e3462 = phi_7949_;
phi_7950_ = _e3462;
}
let _e3913 = phi_7950_;
let _e3941 = type_25(_e3913.member, _e3913.member_1, _e3913.member_2, _e3913.member_3, _e3913.member_4, _e3913.member_5, _e3913.member_6, _e3913.member_7, _e3913.member_8, _e3913.member_9, _e3913.member_10, _e3913.member_11, _e3913.member_12, 0f, _e3913.member_14, _e3913.member_15, _e3913.member_16, _e3913.member_17, _e3913.member_18, _e3913.member_19, _e3913.member_20, _e3913.member_21, _e3913.member_22, _e3913.member_23, _e3913.member_24, _e3913.member_25, _e3913.member_26, _e3913.member_27);
let _e3969 = type_25(_e3941.member, _e3941.member_1, _e3941.member_2, _e3941.member_3, _e3941.member_4, _e3941.member_5, _e3941.member_6, _e3941.member_7, _e3941.member_8, _e3941.member_9, _e3941.member_10, 0i, _e3941.member_12, _e3941.member_13, _e3941.member_14, _e3941.member_15, _e3941.member_16, _e3941.member_17, _e3941.member_18, _e3941.member_19, _e3941.member_20, _e3941.member_21, _e3941.member_22, _e3941.member_23, _e3941.member_24, _e3941.member_25, _e3941.member_26, _e3941.member_27);
let _e3997 = type_25(_e3969.member, _e3969.member_1, _e3969.member_2, _e3969.member_3, _e3969.member_4, _e3969.member_5, _e3969.member_6, _e3969.member_7, _e3969.member_8, _e3969.member_9, _e3969.member_10, _e3969.member_11, 0i, _e3969.member_13, _e3969.member_14, _e3969.member_15, _e3969.member_16, _e3969.member_17, _e3969.member_18, _e3969.member_19, _e3969.member_20, _e3969.member_21, _e3969.member_22, _e3969.member_23, _e3969.member_24, _e3969.member_25, _e3969.member_26, _e3969.member_27);
let _e4004 = global_5.member.member_14.member.member;
let _e4018 = ((((_e4004.member.member * _e3913.member.x) + (_e4004.member.member_1 * _e3913.member.y)) + (_e4004.member.member_2 * _e3913.member.z)) + _e4004.member_1);
let _e4027 = -((((_e4004.member.member * _e3913.member_1.x) + (_e4004.member.member_1 * _e3913.member_1.y)) + (_e4004.member.member_2 * _e3913.member_1.z)));
let _e4029 = (_e4027 > 1e-9f);
let _e4033 = ((_e4018 / select(1e-9f, _e4027, _e4029)) - 0.015625f);
let _e4036 = select(1e30f, select(0f, _e4033, (_e4033 > 0f)), ((_e4018 > 0f) && _e4029));
let _e4041 = global_5.member.member_14.member_1.member;
let _e4052 = ((((_e4041.member.member * _e3913.member.x) + (_e4041.member.member_1 * _e3913.member.y)) + (_e4041.member.member_2 * _e3913.member.z)) + _e4041.member_1);
let _e4058 = -((((_e4041.member.member * _e3913.member_1.x) + (_e4041.member.member_1 * _e3913.member_1.y)) + (_e4041.member.member_2 * _e3913.member_1.z)));
let _e4060 = (_e4058 > 1e-9f);
let _e4064 = ((_e4052 / select(1e-9f, _e4058, _e4060)) - 0.015625f);
let _e4067 = select(1e30f, select(0f, _e4064, (_e4064 > 0f)), ((_e4052 > 0f) && _e4060));
let _e4071 = (_e4067 < _e4036);
let _e4102 = type_25(_e3997.member, _e3997.member_1, _e3997.member_2, _e3997.member_3, _e3997.member_4, _e3997.member_5, _e3997.member_6, _e3997.member_7, 0i, _e3997.member_9, _e3997.member_10, _e3997.member_11, _e3997.member_12, _e3997.member_13, _e3997.member_14, _e3997.member_15, _e3997.member_16, _e3997.member_17, _e3997.member_18, _e3997.member_19, _e3997.member_20, _e3997.member_21, _e3997.member_22, _e3997.member_23, _e3997.member_24, _e3997.member_25, _e3997.member_26, _e3997.member_27);
let _e4130 = type_25(_e4102.member, _e4102.member_1, _e4102.member_2, _e4102.member_3, _e4102.member_4, _e4102.member_5, _e4102.member_6, _e4102.member_7, _e4102.member_8, select(select(-2i, -3i, _e4071), -1i, ((_e4036 >= 1e30f) && (_e4067 >= 1e30f))), _e4102.member_10, _e4102.member_11, _e4102.member_12, _e4102.member_13, _e4102.member_14, _e4102.member_15, _e4102.member_16, _e4102.member_17, _e4102.member_18, _e4102.member_19, _e4102.member_20, _e4102.member_21, _e4102.member_22, _e4102.member_23, _e4102.member_24, _e4102.member_25, _e4102.member_26, _e4102.member_27);
let _e4158 = type_25(_e4130.member, _e4130.member_1, _e4130.member_2, _e4130.member_3, _e4130.member_4, _e4130.member_5, _e4130.member_6, _e4130.member_7, _e4130.member_8, _e4130.member_9, select(_e4036, _e4067, _e4071), _e4130.member_11, _e4130.member_12, _e4130.member_13, _e4130.member_14, _e4130.member_15, _e4130.member_16, _e4130.member_17, _e4130.member_18, _e4130.member_19, _e4130.member_20, _e4130.member_21, _e4130.member_22, _e4130.member_23, _e4130.member_24, _e4130.member_25, _e4130.member_26, _e4130.member_27);
let _e4163 = global_5.member.member_12.member_3;
if (_e3913.member_16 > bitcast<i32>(_e4163)) {
if (bitcast<i32>(countOneBits(bitcast<u32>((_e3913.member_17 & ((1i << bitcast<u32>((_e3913.member_16 & 31i))) - 1i))))) == _e3913.member_20) {
phi_8105_ = (((_e3913.member_6.x + _e3913.member_6.y) + _e3913.member_6.z) * (1f / 3f));
} else {
phi_8105_ = 0f;
}
let _e4186 = phi_8105_;
let _e4216 = type_25(_e4158.member, _e4158.member_1, _e4158.member_2, _e4158.member_3, _e4158.member_4, _e4158.member_5, _e4158.member_6, _e4158.member_7, _e4158.member_8, _e4158.member_9, _e4158.member_10, _e4158.member_11, _e4158.member_12, _e4158.member_13, _e4158.member_14, _e4158.member_15, _e4158.member_16, _e4158.member_17, _e4158.member_18, _e4158.member_19, _e4158.member_20, _e4158.member_21, _e4158.member_22, _e4158.member_23, _e4158.member_24, _e4158.member_25, _e4158.member_26, (_e3913.member_27 + _e4186));
let _e4218 = (_e3913.member_18 == 0i);
if (_e4218 && (_e3913.member_21 == 0i)) {
phi_9412_ = type_25(_e4216.member, _e4216.member_1, _e4216.member_2, _e4216.member_3, _e4216.member_4, _e4216.member_5, _e4216.member_6, _e4216.member_7, _e4216.member_8, _e4216.member_9, _e4216.member_10, _e4216.member_11, _e4216.member_12, _e4216.member_13, _e4216.member_14, 3f, _e4216.member_16, _e4216.member_17, _e4216.member_18, _e4216.member_19, _e4216.member_20, _e4216.member_21, _e4216.member_22, _e4216.member_23, _e4216.member_24, _e4216.member_25, _e4216.member_26, _e4216.member_27);
} else {
if _e4218 {
let _e4348 = type_25(_e4216.member, _e4216.member_1, _e4216.member_2, _e4216.member_3, _e4216.member_4, _e4216.member_5, _e4216.member_6, _e4216.member_7, _e4216.member_8, _e4216.member_9, _e4216.member_10, _e4216.member_11, _e4216.member_12, _e4216.member_13, _e4216.member_14, _e4216.member_15, _e4216.member_16, _e4216.member_17, _e4216.member_18, _e4216.member_19, (_e3913.member_20 + 1i), _e4216.member_21, _e4216.member_22, _e4216.member_23, _e4216.member_24, _e4216.member_25, _e4216.member_26, _e4216.member_27);
let _e4376 = type_25(_e4348.member, _e4348.member_1, _e4348.member_2, _e4348.member_3, _e4348.member_4, _e4348.member_5, _e4348.member_6, _e4348.member_7, _e4348.member_8, _e4348.member_9, _e4348.member_10, _e4348.member_11, _e4348.member_12, _e4348.member_13, _e4348.member_14, _e4348.member_15, _e4348.member_16, _e4348.member_17, _e4348.member_18, _e4348.member_19, _e4348.member_20, 0i, _e4348.member_22, _e4348.member_23, _e4348.member_24, _e4348.member_25, _e4348.member_26, _e4348.member_27);
let _e4404 = type_25(_e4376.member, _e4376.member_1, _e4376.member_2, _e4376.member_3, _e4376.member_4, _e4376.member_5, _e4376.member_6, _e4376.member_7, _e4376.member_8, _e4376.member_9, _e4376.member_10, _e4376.member_11, _e4376.member_12, _e4376.member_13, _e4376.member_14, _e4376.member_15, _e4376.member_16, 0i, _e4376.member_18, _e4376.member_19, _e4376.member_20, _e4376.member_21, _e4376.member_22, _e4376.member_23, _e4376.member_24, _e4376.member_25, _e4376.member_26, _e4376.member_27);
phi_8149_ = type_25(_e4404.member, _e4404.member_1, _e4404.member_2, _e4404.member_3, _e4404.member_4, _e4404.member_5, _e4404.member_6, _e4404.member_7, _e4404.member_8, _e4404.member_9, _e4404.member_10, _e4404.member_11, _e4404.member_12, _e4404.member_13, _e4404.member_14, _e4404.member_15, _e4404.member_16, _e4404.member_17, _e4404.member_18, 0i, _e4404.member_20, _e4404.member_21, _e4404.member_22, _e4404.member_23, _e4404.member_24, _e4404.member_25, _e4404.member_26, _e4404.member_27);
} else {
let _e4226 = bitcast<i32>((bitcast<u32>(f32(_e3913.member_18)) >> bitcast<u32>(23i)));
let _e4230 = (1i << bitcast<u32>(((_e4226 - 127i) & 31i)));
let _e4231 = (_e4230 - 1i);
let _e4261 = type_25(_e4216.member, _e4216.member_1, _e4216.member_2, _e4216.member_3, _e4216.member_4, _e4216.member_5, _e4216.member_6, _e4216.member_7, _e4216.member_8, _e4216.member_9, _e4216.member_10, _e4216.member_11, _e4216.member_12, _e4216.member_13, _e4216.member_14, _e4216.member_15, _e4216.member_16, ((_e3913.member_17 & _e4231) | _e4230), _e4216.member_18, _e4216.member_19, _e4216.member_20, _e4216.member_21, _e4216.member_22, _e4216.member_23, _e4216.member_24, _e4216.member_25, _e4216.member_26, _e4216.member_27);
let _e4290 = type_25(_e4261.member, _e4261.member_1, _e4261.member_2, _e4261.member_3, _e4261.member_4, _e4261.member_5, _e4261.member_6, _e4261.member_7, _e4261.member_8, _e4261.member_9, _e4261.member_10, _e4261.member_11, _e4261.member_12, _e4261.member_13, _e4261.member_14, _e4261.member_15, _e4261.member_16, _e4261.member_17, (_e3913.member_18 & _e4231), _e4261.member_19, _e4261.member_20, _e4261.member_21, _e4261.member_22, _e4261.member_23, _e4261.member_24, _e4261.member_25, _e4261.member_26, _e4261.member_27);
phi_8149_ = type_25(_e4290.member, _e4290.member_1, _e4290.member_2, _e4290.member_3, _e4290.member_4, _e4290.member_5, _e4290.member_6, _e4290.member_7, _e4290.member_8, _e4290.member_9, _e4290.member_10, _e4290.member_11, _e4290.member_12, _e4290.member_13, _e4290.member_14, _e4290.member_15, _e4290.member_16, _e4290.member_17, _e4290.member_18, (_e4226 + -126i), _e4290.member_20, _e4290.member_21, _e4290.member_22, _e4290.member_23, _e4290.member_24, _e4290.member_25, _e4290.member_26, _e4290.member_27);
}
let _e4434 = phi_8149_;
let _e4440 = global_5.member.member_11.member_2;
let _e4447 = global_5.member.member_11.member_3;
let _e4454 = global_5.member.member_11.member_5;
let _e4460 = global_5.member.member_11.member_7;
let _e4462 = (_e4454 + ((f32(bitcast<i32>(_e120.x)) + 0.5f) * _e4460));
let _e4466 = global_5.member.member_11.member_6;
let _e4472 = global_5.member.member_11.member_8;
let _e4474 = (_e4466 + ((f32(bitcast<i32>(_e120.y)) + 0.5f) * _e4472));
let _e4475 = (_e4440.member * _e4460);
let _e4476 = (_e4440.member_1 * _e4460);
let _e4477 = (_e4440.member_2 * _e4460);
let _e4478 = (_e4447.member * _e4472);
let _e4479 = (_e4447.member_1 * _e4472);
let _e4480 = (_e4447.member_2 * _e4472);
let _e4487 = ((_e4440.member * _e4462) + (_e4447.member * _e4474));
let _e4488 = ((_e4440.member_1 * _e4462) + (_e4447.member_1 * _e4474));
let _e4489 = ((_e4440.member_2 * _e4462) + (_e4447.member_2 * _e4474));
let _e4493 = global_5.member.member_11.member_4;
let _e4500 = global_5.member.member_11.member_1;
let _e4507 = global_5.member.member_10.member;
let _e4508 = (_e4507 == 0u);
let _e4509 = (_e4500.member + _e4487);
let _e4510 = (_e4500.member_1 + _e4488);
let _e4511 = (_e4500.member_2 + _e4489);
let _e4516 = (((_e4509 * _e4509) + (_e4510 * _e4510)) + (_e4511 * _e4511));
let _e4520 = (1f / sqrt(select(0f, _e4516, (_e4516 > 0f))));
let _e4524 = select((_e4509 * _e4520), _e4500.member, _e4508);
let _e4525 = select((_e4510 * _e4520), _e4500.member_1, _e4508);
let _e4526 = select((_e4511 * _e4520), _e4500.member_2, _e4508);
let _e4531 = select(_e4493.member, (_e4493.member + _e4487), _e4508);
let _e4532 = select(_e4493.member_1, (_e4493.member_1 + _e4488), _e4508);
let _e4533 = select(_e4493.member_2, (_e4493.member_2 + _e4489), _e4508);
let _e4547 = (((_e4475 * _e4524) + (_e4476 * _e4525)) + (_e4477 * _e4526));
let _e4557 = select(((_e4475 - (_e4524 * _e4547)) * _e4520), 0f, _e4508);
let _e4558 = select(((_e4476 - (_e4525 * _e4547)) * _e4520), 0f, _e4508);
let _e4559 = select(((_e4477 - (_e4526 * _e4547)) * _e4520), 0f, _e4508);
let _e4565 = (((_e4478 * _e4524) + (_e4479 * _e4525)) + (_e4480 * _e4526));
let _e4575 = select(((_e4478 - (_e4524 * _e4565)) * _e4520), 0f, _e4508);
let _e4576 = select(((_e4479 - (_e4525 * _e4565)) * _e4520), 0f, _e4508);
let _e4577 = select(((_e4480 - (_e4526 * _e4565)) * _e4520), 0f, _e4508);
let _e4586 = (1f / select(_e4524, select(1e-12f, -1e-12f, (_e4524 < 0f)), (bitcast<f32>((bitcast<u32>(_e4524) & 2147483647u)) < 1e-12f)));
let _e4594 = (1f / select(_e4525, select(1e-12f, -1e-12f, (_e4525 < 0f)), (bitcast<f32>((bitcast<u32>(_e4525) & 2147483647u)) < 1e-12f)));
let _e4602 = (1f / select(_e4526, select(1e-12f, -1e-12f, (_e4526 < 0f)), (bitcast<f32>((bitcast<u32>(_e4526) & 2147483647u)) < 1e-12f)));
let _e4605 = global_5.member.member_8;
let _e4611 = global_5.member.member_9;
let _e4616 = ((_e4605.member - _e4531) * _e4586);
let _e4618 = ((_e4611.member - _e4531) * _e4586);
let _e4620 = ((_e4605.member_1 - _e4532) * _e4594);
let _e4622 = ((_e4611.member_1 - _e4532) * _e4594);
let _e4624 = ((_e4605.member_2 - _e4533) * _e4602);
let _e4626 = ((_e4611.member_2 - _e4533) * _e4602);
let _e4628 = select(_e4618, _e4616, (_e4616 < _e4618));
let _e4630 = select(_e4622, _e4620, (_e4620 < _e4622));
let _e4632 = select(_e4630, _e4628, (_e4628 > _e4630));
let _e4634 = select(_e4626, _e4624, (_e4624 < _e4626));
let _e4636 = select(_e4634, _e4632, (_e4632 > _e4634));
let _e4638 = select(_e4618, _e4616, (_e4616 > _e4618));
let _e4640 = select(_e4622, _e4620, (_e4620 > _e4622));
let _e4642 = select(_e4640, _e4638, (_e4638 < _e4640));
let _e4644 = select(_e4626, _e4624, (_e4624 > _e4626));
if (true && _e4508) {
phi_8733_ = -(1e30f);
} else {
phi_8733_ = 0f;
}
let _e4650 = phi_8733_;
let _e4652 = select(_e4650, _e4636, (_e4636 > _e4650));
let _e4654 = ((select(_e4644, _e4642, (_e4642 < _e4644)) <= _e4652) || false);
let _e4655 = select(_e4652, 0f, _e4654);
let _e4656 = (_e4524 * _e4655);
let _e4657 = (_e4525 * _e4655);
let _e4658 = (_e4526 * _e4655);
let _e4659 = (_e4531 + _e4656);
let _e4660 = (_e4532 + _e4657);
let _e4661 = (_e4533 + _e4658);
let _e4691 = type_25((vec3<f32>(_e4531, _e4532, _e4533) + vec3<f32>(_e4656, _e4657, _e4658)), _e4434.member_1, _e4434.member_2, _e4434.member_3, _e4434.member_4, _e4434.member_5, _e4434.member_6, _e4434.member_7, _e4434.member_8, _e4434.member_9, _e4434.member_10, _e4434.member_11, _e4434.member_12, _e4434.member_13, _e4434.member_14, _e4434.member_15, _e4434.member_16, _e4434.member_17, _e4434.member_18, _e4434.member_19, _e4434.member_20, _e4434.member_21, _e4434.member_22, _e4434.member_23, _e4434.member_24, _e4434.member_25, _e4434.member_26, _e4434.member_27);
let _e4719 = type_25(_e4691.member, vec3<f32>(_e4524, _e4525, _e4526), _e4691.member_2, _e4691.member_3, _e4691.member_4, _e4691.member_5, _e4691.member_6, _e4691.member_7, _e4691.member_8, _e4691.member_9, _e4691.member_10, _e4691.member_11, _e4691.member_12, _e4691.member_13, _e4691.member_14, _e4691.member_15, _e4691.member_16, _e4691.member_17, _e4691.member_18, _e4691.member_19, _e4691.member_20, _e4691.member_21, _e4691.member_22, _e4691.member_23, _e4691.member_24, _e4691.member_25, _e4691.member_26, _e4691.member_27);
let _e4757 = type_25(_e4719.member, _e4719.member_1, (vec3<f32>(select(0f, _e4475, _e4508), select(0f, _e4476, _e4508), select(0f, _e4477, _e4508)) + vec3<f32>((_e4557 * _e4655), (_e4558 * _e4655), (_e4559 * _e4655))), _e4719.member_3, _e4719.member_4, _e4719.member_5, _e4719.member_6, _e4719.member_7, _e4719.member_8, _e4719.member_9, _e4719.member_10, _e4719.member_11, _e4719.member_12, _e4719.member_13, _e4719.member_14, _e4719.member_15, _e4719.member_16, _e4719.member_17, _e4719.member_18, _e4719.member_19, _e4719.member_20, _e4719.member_21, _e4719.member_22, _e4719.member_23, _e4719.member_24, _e4719.member_25, _e4719.member_26, _e4719.member_27);
let _e4785 = type_25(_e4757.member, _e4757.member_1, _e4757.member_2, (vec3<f32>(select(0f, _e4478, _e4508), select(0f, _e4479, _e4508), select(0f, _e4480, _e4508)) + vec3<f32>((_e4575 * _e4655), (_e4576 * _e4655), (_e4577 * _e4655))), _e4757.member_4, _e4757.member_5, _e4757.member_6, _e4757.member_7, _e4757.member_8, _e4757.member_9, _e4757.member_10, _e4757.member_11, _e4757.member_12, _e4757.member_13, _e4757.member_14, _e4757.member_15, _e4757.member_16, _e4757.member_17, _e4757.member_18, _e4757.member_19, _e4757.member_20, _e4757.member_21, _e4757.member_22, _e4757.member_23, _e4757.member_24, _e4757.member_25, _e4757.member_26, _e4757.member_27);
let _e4813 = type_25(_e4785.member, _e4785.member_1, _e4785.member_2, _e4785.member_3, vec3<f32>(_e4557, _e4558, _e4559), _e4785.member_5, _e4785.member_6, _e4785.member_7, _e4785.member_8, _e4785.member_9, _e4785.member_10, _e4785.member_11, _e4785.member_12, _e4785.member_13, _e4785.member_14, _e4785.member_15, _e4785.member_16, _e4785.member_17, _e4785.member_18, _e4785.member_19, _e4785.member_20, _e4785.member_21, _e4785.member_22, _e4785.member_23, _e4785.member_24, _e4785.member_25, _e4785.member_26, _e4785.member_27);
let _e4841 = type_25(_e4813.member, _e4813.member_1, _e4813.member_2, _e4813.member_3, _e4813.member_4, vec3<f32>(_e4575, _e4576, _e4577), _e4813.member_6, _e4813.member_7, _e4813.member_8, _e4813.member_9, _e4813.member_10, _e4813.member_11, _e4813.member_12, _e4813.member_13, _e4813.member_14, _e4813.member_15, _e4813.member_16, _e4813.member_17, _e4813.member_18, _e4813.member_19, _e4813.member_20, _e4813.member_21, _e4813.member_22, _e4813.member_23, _e4813.member_24, _e4813.member_25, _e4813.member_26, _e4813.member_27);
let _e4869 = type_25(_e4841.member, _e4841.member_1, _e4841.member_2, _e4841.member_3, _e4841.member_4, _e4841.member_5, _e4841.member_6, 0i, _e4841.member_8, _e4841.member_9, _e4841.member_10, _e4841.member_11, _e4841.member_12, _e4841.member_13, _e4841.member_14, _e4841.member_15, _e4841.member_16, _e4841.member_17, _e4841.member_18, _e4841.member_19, _e4841.member_20, _e4841.member_21, _e4841.member_22, _e4841.member_23, _e4841.member_24, _e4841.member_25, _e4841.member_26, _e4841.member_27);
let _e4897 = type_25(_e4869.member, _e4869.member_1, _e4869.member_2, _e4869.member_3, _e4869.member_4, _e4869.member_5, _e4869.member_6, _e4869.member_7, _e4869.member_8, _e4869.member_9, _e4869.member_10, _e4869.member_11, _e4869.member_12, _e4869.member_13, _e4869.member_14, _e4869.member_15, 0i, _e4869.member_17, _e4869.member_18, _e4869.member_19, _e4869.member_20, _e4869.member_21, _e4869.member_22, _e4869.member_23, _e4869.member_24, _e4869.member_25, _e4869.member_26, _e4869.member_27);
let _e4925 = type_25(_e4897.member, _e4897.member_1, _e4897.member_2, _e4897.member_3, _e4897.member_4, _e4897.member_5, _e4897.member_6, _e4897.member_7, _e4897.member_8, _e4897.member_9, _e4897.member_10, _e4897.member_11, _e4897.member_12, _e4897.member_13, _e4897.member_14, 1f, _e4897.member_16, _e4897.member_17, _e4897.member_18, _e4897.member_19, _e4897.member_20, _e4897.member_21, _e4897.member_22, _e4897.member_23, _e4897.member_24, _e4897.member_25, _e4897.member_26, _e4897.member_27);
let _e4953 = type_25(_e4925.member, _e4925.member_1, _e4925.member_2, _e4925.member_3, _e4925.member_4, _e4925.member_5, _e4925.member_6, _e4925.member_7, _e4925.member_8, _e4925.member_9, _e4925.member_10, _e4925.member_11, _e4925.member_12, 0f, _e4925.member_14, _e4925.member_15, _e4925.member_16, _e4925.member_17, _e4925.member_18, _e4925.member_19, _e4925.member_20, _e4925.member_21, _e4925.member_22, _e4925.member_23, _e4925.member_24, _e4925.member_25, _e4925.member_26, _e4925.member_27);
let _e4981 = type_25(_e4953.member, _e4953.member_1, _e4953.member_2, _e4953.member_3, _e4953.member_4, _e4953.member_5, _e4953.member_6, _e4953.member_7, _e4953.member_8, _e4953.member_9, _e4953.member_10, 0i, _e4953.member_12, _e4953.member_13, _e4953.member_14, _e4953.member_15, _e4953.member_16, _e4953.member_17, _e4953.member_18, _e4953.member_19, _e4953.member_20, _e4953.member_21, _e4953.member_22, _e4953.member_23, _e4953.member_24, _e4953.member_25, _e4953.member_26, _e4953.member_27);
let _e5009 = type_25(_e4981.member, _e4981.member_1, _e4981.member_2, _e4981.member_3, _e4981.member_4, _e4981.member_5, _e4981.member_6, _e4981.member_7, _e4981.member_8, _e4981.member_9, _e4981.member_10, _e4981.member_11, 0i, _e4981.member_13, _e4981.member_14, _e4981.member_15, _e4981.member_16, _e4981.member_17, _e4981.member_18, _e4981.member_19, _e4981.member_20, _e4981.member_21, _e4981.member_22, _e4981.member_23, _e4981.member_24, _e4981.member_25, _e4981.member_26, _e4981.member_27);
let _e5015 = ((((_e4004.member.member * _e4659) + (_e4004.member.member_1 * _e4660)) + (_e4004.member.member_2 * _e4661)) + _e4004.member_1);
let _e5021 = -((((_e4004.member.member * _e4524) + (_e4004.member.member_1 * _e4525)) + (_e4004.member.member_2 * _e4526)));
let _e5023 = (_e5021 > 1e-9f);
let _e5027 = ((_e5015 / select(1e-9f, _e5021, _e5023)) - 0.015625f);
let _e5030 = select(1e30f, select(0f, _e5027, (_e5027 > 0f)), ((_e5015 > 0f) && _e5023));
let _e5036 = ((((_e4041.member.member * _e4659) + (_e4041.member.member_1 * _e4660)) + (_e4041.member.member_2 * _e4661)) + _e4041.member_1);
let _e5042 = -((((_e4041.member.member * _e4524) + (_e4041.member.member_1 * _e4525)) + (_e4041.member.member_2 * _e4526)));
let _e5044 = (_e5042 > 1e-9f);
let _e5048 = ((_e5036 / select(1e-9f, _e5042, _e5044)) - 0.015625f);
let _e5051 = select(1e30f, select(0f, _e5048, (_e5048 > 0f)), ((_e5036 > 0f) && _e5044));
let _e5055 = (_e5051 < _e5030);
let _e5086 = type_25(_e5009.member, _e5009.member_1, _e5009.member_2, _e5009.member_3, _e5009.member_4, _e5009.member_5, _e5009.member_6, _e5009.member_7, 0i, _e5009.member_9, _e5009.member_10, _e5009.member_11, _e5009.member_12, _e5009.member_13, _e5009.member_14, _e5009.member_15, _e5009.member_16, _e5009.member_17, _e5009.member_18, _e5009.member_19, _e5009.member_20, _e5009.member_21, _e5009.member_22, _e5009.member_23, _e5009.member_24, _e5009.member_25, _e5009.member_26, _e5009.member_27);
let _e5114 = type_25(_e5086.member, _e5086.member_1, _e5086.member_2, _e5086.member_3, _e5086.member_4, _e5086.member_5, _e5086.member_6, _e5086.member_7, _e5086.member_8, select(select(-2i, -3i, _e5055), -1i, ((_e5030 >= 1e30f) && (_e5051 >= 1e30f))), _e5086.member_10, _e5086.member_11, _e5086.member_12, _e5086.member_13, _e5086.member_14, _e5086.member_15, _e5086.member_16, _e5086.member_17, _e5086.member_18, _e5086.member_19, _e5086.member_20, _e5086.member_21, _e5086.member_22, _e5086.member_23, _e5086.member_24, _e5086.member_25, _e5086.member_26, _e5086.member_27);
let _e5142 = type_25(_e5114.member, _e5114.member_1, _e5114.member_2, _e5114.member_3, _e5114.member_4, _e5114.member_5, _e5114.member_6, _e5114.member_7, _e5114.member_8, _e5114.member_9, select(_e5030, _e5051, _e5055), _e5114.member_11, _e5114.member_12, _e5114.member_13, _e5114.member_14, _e5114.member_15, _e5114.member_16, _e5114.member_17, _e5114.member_18, _e5114.member_19, _e5114.member_20, _e5114.member_21, _e5114.member_22, _e5114.member_23, _e5114.member_24, _e5114.member_25, _e5114.member_26, _e5114.member_27);
let _e5146 = global_5.member.member_13.member_4;
let _e5153 = global_5.member.member_13.member_5;
let _e5158 = ((_e5146.member - _e4531) * _e4586);
let _e5160 = ((_e5153.member - _e4531) * _e4586);
let _e5162 = ((_e5146.member_1 - _e4532) * _e4594);
let _e5164 = ((_e5153.member_1 - _e4532) * _e4594);
let _e5166 = ((_e5146.member_2 - _e4533) * _e4602);
let _e5168 = ((_e5153.member_2 - _e4533) * _e4602);
let _e5170 = select(_e5160, _e5158, (_e5158 < _e5160));
let _e5172 = select(_e5164, _e5162, (_e5162 < _e5164));
let _e5174 = select(_e5172, _e5170, (_e5170 > _e5172));
let _e5176 = select(_e5168, _e5166, (_e5166 < _e5168));
let _e5178 = select(_e5176, _e5174, (_e5174 > _e5176));
let _e5180 = select(_e5160, _e5158, (_e5158 > _e5160));
let _e5182 = select(_e5164, _e5162, (_e5162 > _e5164));
let _e5184 = select(_e5182, _e5180, (_e5180 < _e5182));
let _e5186 = select(_e5168, _e5166, (_e5166 > _e5168));
let _e5188 = select(_e5186, _e5184, (_e5184 < _e5186));
let _e5190 = select(_e4650, _e5178, (_e5178 > _e4650));
let _e5192 = select(_e4655, _e5188, (_e5188 < _e4655));
let _e5193 = (_e5192 > _e5190);
let _e5196 = (select(_e4650, _e5192, _e5193) - select(_e4650, _e5190, _e5193));
let _e5200 = global_5.member.member_13.member;
let _e5205 = -((_e5200.member * _e5196));
let _e5207 = select(-87f, _e5205, (_e5205 > -87f));
let _e5209 = select(88f, _e5207, (_e5207 < 88f));
let _e5211 = ((_e5209 * 1.442695f) + 0.5f);
let _e5213 = select(-127f, _e5211, (_e5211 > -127f));
let _e5215 = select(128f, _e5213, (_e5213 < 128f));
let _e5222 = select(0i, select(select(i32(_e5215), i32(-2147483648), (_e5215 < -2147483600f)), 2147483647i, (_e5215 > 2147483500f)), (_e5215 == _e5215));
let _e5226 = (_e5222 - select(0i, 1i, (_e5215 < f32(_e5222))));
let _e5227 = f32(_e5226);
let _e5231 = ((_e5209 - (_e5227 * 0.6933594f)) - (_e5227 * -2.1219444e-4f));
let _e5253 = -((_e5200.member_1 * _e5196));
let _e5255 = select(-87f, _e5253, (_e5253 > -87f));
let _e5257 = select(88f, _e5255, (_e5255 < 88f));
let _e5259 = ((_e5257 * 1.442695f) + 0.5f);
let _e5261 = select(-127f, _e5259, (_e5259 > -127f));
let _e5263 = select(128f, _e5261, (_e5261 < 128f));
let _e5270 = select(0i, select(select(i32(_e5263), i32(-2147483648), (_e5263 < -2147483600f)), 2147483647i, (_e5263 > 2147483500f)), (_e5263 == _e5263));
let _e5274 = (_e5270 - select(0i, 1i, (_e5263 < f32(_e5270))));
let _e5275 = f32(_e5274);
let _e5279 = ((_e5257 - (_e5275 * 0.6933594f)) - (_e5275 * -2.1219444e-4f));
let _e5301 = -((_e5200.member_2 * _e5196));
let _e5303 = select(-87f, _e5301, (_e5301 > -87f));
let _e5305 = select(88f, _e5303, (_e5303 < 88f));
let _e5307 = ((_e5305 * 1.442695f) + 0.5f);
let _e5309 = select(-127f, _e5307, (_e5307 > -127f));
let _e5311 = select(128f, _e5309, (_e5309 < 128f));
let _e5318 = select(0i, select(select(i32(_e5311), i32(-2147483648), (_e5311 < -2147483600f)), 2147483647i, (_e5311 > 2147483500f)), (_e5311 == _e5311));
let _e5322 = (_e5318 - select(0i, 1i, (_e5311 < f32(_e5318))));
let _e5323 = f32(_e5322);
let _e5327 = ((_e5305 - (_e5323 * 0.6933594f)) - (_e5323 * -2.1219444e-4f));
let _e5350 = (1f / 3f);
let _e5352 = (1f * ((1f + (_e5231 * (1f + (_e5231 * (0.5f + (_e5231 * (0.16666667f + (_e5231 * (0.041666668f + (_e5231 * (0.008333334f + (_e5231 * (0.001388889f + (_e5231 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5226 + 127i)) << bitcast<u32>(23i)))));
let _e5353 = (1f * ((1f + (_e5279 * (1f + (_e5279 * (0.5f + (_e5279 * (0.16666667f + (_e5279 * (0.041666668f + (_e5279 * (0.008333334f + (_e5279 * (0.001388889f + (_e5279 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5274 + 127i)) << bitcast<u32>(23i)))));
let _e5354 = (1f * ((1f + (_e5327 * (1f + (_e5327 * (0.5f + (_e5327 * (0.16666667f + (_e5327 * (0.041666668f + (_e5327 * (0.008333334f + (_e5327 * (0.001388889f + (_e5327 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5322 + 127i)) << bitcast<u32>(23i)))));
let _e5383 = type_25(_e5142.member, _e5142.member_1, _e5142.member_2, _e5142.member_3, _e5142.member_4, _e5142.member_5, vec3<f32>(_e5352, _e5353, _e5354), _e5142.member_7, _e5142.member_8, _e5142.member_9, _e5142.member_10, _e5142.member_11, _e5142.member_12, _e5142.member_13, _e5142.member_14, _e5142.member_15, _e5142.member_16, _e5142.member_17, _e5142.member_18, _e5142.member_19, _e5142.member_20, _e5142.member_21, _e5142.member_22, _e5142.member_23, _e5142.member_24, _e5142.member_25, _e5142.member_26, _e5142.member_27);
if (bitcast<i32>(countOneBits(0u)) == _e4434.member_20) {
phi_9384_ = ((((1f + 1f) + 1f) * _e5350) - (((_e5352 + _e5353) + _e5354) * _e5350));
} else {
phi_9384_ = 0f;
}
let _e5393 = phi_9384_;
let _e5423 = type_25(_e5383.member, _e5383.member_1, _e5383.member_2, _e5383.member_3, _e5383.member_4, _e5383.member_5, _e5383.member_6, _e5383.member_7, _e5383.member_8, _e5383.member_9, _e5383.member_10, _e5383.member_11, _e5383.member_12, _e5383.member_13, _e5383.member_14, _e5383.member_15, _e5383.member_16, _e5383.member_17, _e5383.member_18, _e5383.member_19, _e5383.member_20, _e5383.member_21, _e5383.member_22, _e5383.member_23, _e5383.member_24, _e5383.member_25, (_e4434.member_26 + _e5393), _e5383.member_27);
if _e4654 {
let _e5451 = type_25(_e5423.member, _e5423.member_1, _e5423.member_2, _e5423.member_3, _e5423.member_4, _e5423.member_5, _e5423.member_6, _e5423.member_7, _e1374, _e5423.member_9, _e5423.member_10, _e5423.member_11, _e5423.member_12, _e5423.member_13, _e5423.member_14, _e5423.member_15, _e5423.member_16, _e5423.member_17, _e5423.member_18, _e5423.member_19, _e5423.member_20, _e5423.member_21, _e5423.member_22, _e5423.member_23, _e5423.member_24, _e5423.member_25, _e5423.member_26, _e5423.member_27);
phi_9411_ = type_25(_e5451.member, _e5451.member_1, _e5451.member_2, _e5451.member_3, _e5451.member_4, _e5451.member_5, _e5451.member_6, _e5451.member_7, _e5451.member_8, _e5451.member_9, _e5451.member_10, _e5451.member_11, _e5451.member_12, _e5451.member_13, _e5451.member_14, 3f, _e5451.member_16, _e5451.member_17, _e5451.member_18, _e5451.member_19, _e5451.member_20, _e5451.member_21, _e5451.member_22, _e5451.member_23, _e5451.member_24, _e5451.member_25, _e5451.member_26, _e5451.member_27);
} else {
phi_9411_ = _e5423;
}
let _e5481 = phi_9411_;
phi_9412_ = _e5481;
}
let _e5511 = phi_9412_;
phi_9413_ = _e5511;
} else {
phi_9413_ = _e4158;
}
let _e5513 = phi_9413_;
phi_9414_ = type_25();
phi_9415_ = _e5513;
}
let _e5791 = phi_9414_;
let _e5793 = phi_9415_;
phi_9416_ = _e5791;
phi_9417_ = _e5793;
phi_9418_ = _e2113;
}
let _e7198 = phi_9416_;
let _e7200 = phi_9417_;
let _e7202 = phi_9418_;
if _e7202 {
phi_9422_ = _e7198;
} else {
phi_9422_ = _e7200;
}
let _e7204 = phi_9422_;
phi_9423_ = _e7204;
}
let _e7264 = phi_9423_;
phi_9425_ = _e7264;
phi_9426_ = select(false, _e1412, _e1455);
}
let _e8120 = phi_9425_;
let _e8122 = phi_9426_;
phi_2429_ = _e8120;
phi_2432_ = (_e1410 + 1i);
phi_2434_ = _e8122;
} else {
phi_2429_ = type_25();
phi_2432_ = i32();
phi_2434_ = bool();
}
let _e8124 = phi_2429_;
let _e8126 = phi_2432_;
let _e8128 = phi_2434_;
continue;
continuing {
phi_2428_ = _e8124;
phi_2431_ = _e8126;
phi_2433_ = _e8128;
break if !(_e1416);
}
}
let _e8131 = local_10;
let _e8135 = local_11;
let _e8139 = local_12;
let _e8143 = local_13;
let _e8147 = local_14;
let _e8151 = local_15;
let _e8155 = local_16;
let _e8159 = local_17;
let _e8163 = local_18;
let _e8167 = local_19;
let _e8171 = local_20;
let _e8175 = local_21;
let _e8179 = local_22;
let _e8183 = local_23;
let _e8187 = local_24;
let _e8191 = local_25;
let _e8195 = local_26;
let _e8199 = local_27;
let _e8203 = local_28;
let _e8207 = local_29;
let _e8211 = local_30;
let _e8215 = local_31;
let _e8219 = local_32;
let _e8223 = local_33;
let _e8227 = local_34;
let _e8230 = local_35;
let _e8234 = local_36;
let _e8238 = local_37;
let _e8241 = local_38;
let _e8244 = local_39;
let _e8248 = local_40;
let _e8252 = local_41;
let _e8256 = local_42;
let _e8260 = local_43;
let _e8264 = local_44;
let _e8268 = local_45;
let _e8272 = local_46;
let _e8275 = local_47;
let _e8278 = local_48;
let _e8281 = local_49;
let _e8284 = local_50;
global_4.member[_e142] = _e8131.member.x;
global_4.member[_e154] = _e8135.member.y;
global_4.member[_e165] = _e8139.member.z;
global_4.member[_e176] = _e8143.member_1.x;
global_4.member[_e187] = _e8147.member_1.y;
global_4.member[_e198] = _e8151.member_1.z;
global_4.member[_e209] = _e8155.member_2.x;
global_4.member[_e220] = _e8159.member_2.y;
global_4.member[_e231] = _e8163.member_2.z;
global_4.member[_e242] = _e8167.member_3.x;
global_4.member[_e253] = _e8171.member_3.y;
global_4.member[_e264] = _e8175.member_3.z;
global_4.member[_e275] = _e8179.member_4.x;
global_4.member[_e286] = _e8183.member_4.y;
global_4.member[_e297] = _e8187.member_4.z;
global_4.member[_e308] = _e8191.member_5.x;
global_4.member[_e319] = _e8195.member_5.y;
global_4.member[_e330] = _e8199.member_5.z;
global_4.member[_e341] = _e8203.member_6.x;
global_4.member[_e352] = _e8207.member_6.y;
global_4.member[_e363] = _e8211.member_6.z;
global_4.member[_e374] = f32(_e8215.member_7);
global_4.member[_e385] = f32(_e8219.member_8);
global_4.member[_e396] = f32(_e8223.member_9);
global_4.member[_e407] = _e8227.member_10;
global_4.member[_e418] = f32(_e8230.member_11);
global_4.member[_e429] = f32(_e8234.member_12);
global_4.member[_e440] = _e8238.member_13;
global_4.member[_e451] = _e8241.member_14;
let _e8347 = local_51;
global_4.member[_e462] = _e8347;
global_4.member[_e473] = f32(_e8244.member_16);
global_4.member[_e484] = f32(_e8248.member_17);
global_4.member[_e495] = f32(_e8252.member_18);
global_4.member[_e506] = f32(_e8256.member_19);
global_4.member[_e517] = f32(_e8260.member_20);
global_4.member[_e528] = f32(_e8264.member_21);
global_4.member[_e539] = f32(_e8268.member_22);
global_4.member[_e550] = _e8272.member_23;
global_4.member[_e561] = _e8275.member_24;
global_4.member[_e572] = _e8278.member_25;
global_4.member[_e583] = _e8281.member_26;
global_4.member[_e594] = _e8284.member_27;
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
