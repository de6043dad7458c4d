struct type_2 {
member: u32,
member_1: u32,
member_2: u32,
}
struct type_5 {
member: array<f32>,
}
struct type_8 {
member: type_2,
member_1: u32,
}
struct type_9 {
member: type_8,
}
var<private> global: vec3<u32>;
@group(0) @binding(2)
var<storage, read_write> global_1: type_5;
@group(0) @binding(0)
var<storage> global_2: type_9;
@group(0) @binding(1)
var<storage> global_3: type_5;
fn function_() {
var local: i32;
var local_1: i32;
var phi_379_: array<f32, 4>;
var phi_387_: array<f32, 4>;
var phi_396_: array<f32, 4>;
var phi_404_: array<f32, 4>;
var phi_417_: array<f32, 4>;
var phi_427_: array<f32, 4>;
var phi_439_: array<f32, 4>;
var phi_451_: array<f32, 4>;
var phi_468_: array<f32, 4>;
var phi_480_: array<f32, 4>;
var phi_490_: array<f32, 4>;
var phi_521_: array<f32, 4>;
var phi_545_: array<f32, 4>;
var phi_578_: array<f32, 4>;
var phi_595_: u32;
var phi_601_: u32;
var phi_623_: array<f32, 4>;
var phi_690_: array<f32, 4>;
var phi_735_: array<f32, 4>;
var phi_809_: array<f32, 4>;
var phi_902_: array<f32, 4>;
var phi_914_: array<f32, 4>;
var phi_932_: array<f32, 4>;
var phi_985_: array<f32, 4>;
var phi_1223_: array<f32, 4>;
var phi_1231_: array<f32, 4>;
var phi_1301_: array<f32, 4>;
var phi_1329_: array<f32, 4>;
var phi_1504_: array<f32, 4>;
var phi_1694_: array<f32, 4>;
let _e106 = global;
let _e112 = global_2.member.member;
if (_e106.x < _e112.member) {
if (_e106.y < _e112.member_1) {
let _e119 = (_e112.member * _e112.member_1);
let _e121 = ((_e106.y * _e112.member) + _e106.x);
let _e125 = global_2.member.member.member;
let _e129 = global_2.member.member.member_1;
local = bitcast<i32>((_e125 * _e129));
local_1 = bitcast<i32>(((_e106.y * _e125) + _e106.x));
let _e135 = local_1;
let _e137 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e139 = select(_e137, _e135, (_e135 < _e137));
let _e144 = global_3.member[bitcast<u32>(select(0i, _e139, (_e139 > 0i)))];
let _e145 = local;
let _e146 = local_1;
let _e147 = (_e145 + _e146);
let _e149 = select(_e137, _e147, (_e147 < _e137));
let _e154 = global_3.member[bitcast<u32>(select(0i, _e149, (_e149 > 0i)))];
let _e155 = local;
let _e157 = local_1;
let _e158 = ((2i * _e155) + _e157);
let _e160 = select(_e137, _e158, (_e158 < _e137));
let _e165 = global_3.member[bitcast<u32>(select(0i, _e160, (_e160 > 0i)))];
let _e166 = local;
let _e168 = local_1;
let _e169 = ((3i * _e166) + _e168);
let _e171 = select(_e137, _e169, (_e169 < _e137));
let _e176 = global_3.member[bitcast<u32>(select(0i, _e171, (_e171 > 0i)))];
let _e177 = local;
let _e179 = local_1;
let _e180 = ((4i * _e177) + _e179);
let _e182 = select(_e137, _e180, (_e180 < _e137));
let _e187 = global_3.member[bitcast<u32>(select(0i, _e182, (_e182 > 0i)))];
let _e188 = local;
let _e190 = local_1;
let _e191 = ((5i * _e188) + _e190);
let _e193 = select(_e137, _e191, (_e191 < _e137));
let _e198 = global_3.member[bitcast<u32>(select(0i, _e193, (_e193 > 0i)))];
let _e199 = local;
let _e201 = local_1;
let _e202 = ((6i * _e199) + _e201);
let _e204 = select(_e137, _e202, (_e202 < _e137));
let _e209 = global_3.member[bitcast<u32>(select(0i, _e204, (_e204 > 0i)))];
let _e210 = local;
let _e212 = local_1;
let _e213 = ((7i * _e210) + _e212);
let _e215 = select(_e137, _e213, (_e213 < _e137));
let _e220 = global_3.member[bitcast<u32>(select(0i, _e215, (_e215 > 0i)))];
let _e223 = global_2.member.member_1;
if (_e223 == 0u) {
phi_379_ = array<f32, 4>((_e144 + _e154), 0f, 0f, 0f);
} else {
phi_379_ = array<f32, 4>(0f, 0f, 0f, 0f);
}
let _e228 = phi_379_;
if (_e223 == 1u) {
phi_387_ = array<f32, 4>((_e144 * _e154), 0f, 0f, 0f);
} else {
phi_387_ = _e228;
}
let _e233 = phi_387_;
if (_e223 == 2u) {
phi_396_ = array<f32, 4>(((_e144 * _e154) + _e165), 0f, 0f, 0f);
} else {
phi_396_ = _e233;
}
let _e239 = phi_396_;
if (_e223 == 3u) {
phi_404_ = array<f32, 4>((_e144 / _e154), 0f, 0f, 0f);
} else {
phi_404_ = _e239;
}
let _e244 = phi_404_;
if (_e223 == 4u) {
phi_417_ = array<f32, 4>(sqrt(select(0f, _e144, (_e144 > 0f))), 0f, 0f, 0f);
} else {
phi_417_ = _e244;
}
let _e251 = phi_417_;
if (_e223 == 5u) {
phi_427_ = array<f32, 4>(bitcast<f32>((bitcast<u32>(_e144) & 2147483647u)), 0f, 0f, 0f);
} else {
phi_427_ = _e251;
}
let _e258 = phi_427_;
if (_e223 == 6u) {
phi_439_ = array<f32, 4>(select(_e154, _e144, (_e144 < _e154)), 0f, 0f, 0f);
} else {
phi_439_ = _e258;
}
let _e264 = phi_439_;
if (_e223 == 7u) {
phi_451_ = array<f32, 4>(select(_e154, _e144, (_e144 > _e154)), 0f, 0f, 0f);
} else {
phi_451_ = _e264;
}
let _e270 = phi_451_;
if (_e223 == 8u) {
let _e273 = select(_e154, _e144, (_e144 > _e154));
phi_468_ = array<f32, 4>(select(_e165, _e273, (_e273 < _e165)), 0f, 0f, 0f);
} else {
phi_468_ = _e270;
}
let _e278 = phi_468_;
if (_e223 == 9u) {
phi_480_ = array<f32, 4>(select(_e176, _e165, (_e144 < _e154)), 0f, 0f, 0f);
} else {
phi_480_ = _e278;
}
let _e284 = phi_480_;
if (_e223 == 10u) {
phi_490_ = array<f32, 4>((_e144 + ((_e154 - _e144) * _e165)), 0f, 0f, 0f);
} else {
phi_490_ = _e284;
}
let _e291 = phi_490_;
if (_e223 == 11u) {
let _e294 = select(-8388608f, _e144, (_e144 > -8388608f));
let _e296 = select(8388608f, _e294, (_e294 < 8388608f));
let _e303 = select(0i, select(select(i32(_e296), i32(-2147483648), (_e296 < -2147483600f)), 2147483647i, (_e296 > 2147483500f)), (_e296 == _e296));
phi_521_ = array<f32, 4>(f32((_e303 - select(0i, 1i, (_e296 < f32(_e303))))), 0f, 0f, 0f);
} else {
phi_521_ = _e291;
}
let _e311 = phi_521_;
if (_e223 == 12u) {
let _e313 = bitcast<u32>(_e144);
phi_545_ = array<f32, 4>((bitcast<f32>(((_e313 & 32767u) << bitcast<u32>(13i))) * 3.2451855e32f), (bitcast<f32>((((_e313 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.192297e33f), 0f, 0f);
} else {
phi_545_ = _e311;
}
let _e328 = phi_545_;
if (_e223 == 13u) {
let _e331 = ((_e144 * _e154) + 0.5f);
let _e333 = select(-1073741800f, _e331, (_e331 > -1073741800f));
let _e335 = select(1073741800f, _e333, (_e333 < 1073741800f));
let _e342 = select(0i, select(select(i32(_e335), i32(-2147483648), (_e335 < -2147483600f)), 2147483647i, (_e335 > 2147483500f)), (_e335 == _e335));
phi_578_ = array<f32, 4>(f32((_e342 - select(0i, 1i, (_e335 < f32(_e342))))), 0f, 0f, 0f);
} else {
phi_578_ = _e328;
}
let _e350 = phi_578_;
if (_e223 == 14u) {
let _e352 = bitcast<u32>(_e144);
let _e353 = bitcast<u32>(_e154);
let _e356 = ((_e353 >> bitcast<u32>(31i)) != 0u);
if _e356 {
phi_595_ = (~(_e352) + 1u);
} else {
phi_595_ = _e352;
}
let _e362 = phi_595_;
if _e356 {
phi_601_ = (~(_e353) + select(0u, 1u, (_e352 == 0u)));
} else {
phi_601_ = _e353;
}
let _e366 = phi_601_;
let _e388 = ((((f32(bitcast<i32>(((_e366 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e366 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e362 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e362 & 65535u)))));
phi_623_ = array<f32, 4>(select(_e388, -(bitcast<f32>((bitcast<u32>(_e388) & 2147483647u))), _e356), 0f, 0f, 0f);
} else {
phi_623_ = _e350;
}
let _e396 = phi_623_;
if (_e223 == 15u) {
let _e399 = select(-87f, _e144, (_e144 > -87f));
let _e401 = select(88f, _e399, (_e399 < 88f));
let _e403 = ((_e401 * 1.442695f) + 0.5f);
let _e405 = select(-127f, _e403, (_e403 > -127f));
let _e407 = select(128f, _e405, (_e405 < 128f));
let _e414 = select(0i, select(select(i32(_e407), i32(-2147483648), (_e407 < -2147483600f)), 2147483647i, (_e407 > 2147483500f)), (_e407 == _e407));
let _e418 = (_e414 - select(0i, 1i, (_e407 < f32(_e414))));
let _e419 = f32(_e418);
let _e423 = ((_e401 - (_e419 * 0.6933594f)) - (_e419 * -2.1219444e-4f));
phi_690_ = array<f32, 4>(((1f + (_e423 * (1f + (_e423 * (0.5f + (_e423 * (0.16666667f + (_e423 * (0.041666668f + (_e423 * (0.008333334f + (_e423 * (0.001388889f + (_e423 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e418 + 127i)) << bitcast<u32>(23i)))), 0f, 0f, 0f);
} else {
phi_690_ = _e396;
}
let _e446 = phi_690_;
if (_e223 == 16u) {
let _e450 = bitcast<u32>(select(1.1754944e-38f, _e144, (_e144 > 1.1754944e-38f)));
let _e451 = (_e450 & 8388607u);
let _e453 = select(0u, 1u, (_e451 > 3474675u));
let _e464 = bitcast<f32>((_e451 | ((127u - _e453) << bitcast<u32>(23i))));
let _e467 = ((_e464 - 1f) / (_e464 + 1f));
let _e468 = (_e467 * _e467);
phi_735_ = array<f32, 4>((f32(((bitcast<i32>((_e450 >> bitcast<u32>(23i))) - 127i) + bitcast<i32>(_e453))) + (((2f * _e467) + ((_e467 * _e468) * (0.6666667f + (_e468 * (0.4f + (_e468 * (0.2857143f + (_e468 * (0.22222222f + (_e468 * 0.18181819f)))))))))) * 1.442695f)), 0f, 0f, 0f);
} else {
phi_735_ = _e446;
}
let _e486 = phi_735_;
if (_e223 == 17u) {
let _e490 = bitcast<f32>((bitcast<u32>(_e154) & 2147483647u));
let _e493 = bitcast<f32>((bitcast<u32>(_e144) & 2147483647u));
let _e497 = select(_e493, _e490, (_e490 > _e493));
let _e500 = (select(_e493, _e490, (_e490 < _e493)) / select(1.1754944e-38f, _e497, (_e497 > 1.1754944e-38f)));
let _e501 = (_e500 > 0.41421357f);
let _e505 = select(_e500, ((_e500 - 1f) / (_e500 + 1f)), _e501);
let _e506 = (_e505 * _e505);
let _e521 = (select(0f, 0.7853982f, _e501) + (_e505 + ((_e505 * _e506) * (-0.33333334f + (_e506 * (0.2f + (_e506 * (-0.14285713f + (_e506 * (0.11111111f + (_e506 * (-0.09090909f + (_e506 * 0.0585f)))))))))))));
let _e524 = select(_e521, (1.5707964f - _e521), (_e493 > _e490));
let _e527 = select(_e524, (3.1415927f - _e524), (_e154 < 0f));
phi_809_ = array<f32, 4>(select(_e527, -(_e527), (_e144 < 0f)), 0f, 0f, 0f);
} else {
phi_809_ = _e486;
}
let _e533 = phi_809_;
if (_e223 == 18u) {
let _e536 = select(-1f, _e144, (_e144 > -1f));
let _e538 = select(1f, _e536, (_e536 < 1f));
let _e541 = ((1f - _e538) * (1f + _e538));
let _e544 = sqrt(select(0f, _e541, (_e541 > 0f)));
let _e547 = bitcast<f32>((bitcast<u32>(_e544) & 2147483647u));
let _e550 = bitcast<f32>((bitcast<u32>(_e538) & 2147483647u));
let _e554 = select(_e550, _e547, (_e547 > _e550));
let _e557 = (select(_e550, _e547, (_e547 < _e550)) / select(1.1754944e-38f, _e554, (_e554 > 1.1754944e-38f)));
let _e558 = (_e557 > 0.41421357f);
let _e562 = select(_e557, ((_e557 - 1f) / (_e557 + 1f)), _e558);
let _e563 = (_e562 * _e562);
let _e578 = (select(0f, 0.7853982f, _e558) + (_e562 + ((_e562 * _e563) * (-0.33333334f + (_e563 * (0.2f + (_e563 * (-0.14285713f + (_e563 * (0.11111111f + (_e563 * (-0.09090909f + (_e563 * 0.0585f)))))))))))));
let _e581 = select(_e578, (1.5707964f - _e578), (_e550 > _e547));
let _e584 = select(_e581, (3.1415927f - _e581), (_e544 < 0f));
phi_902_ = array<f32, 4>(select(_e584, -(_e584), (_e538 < 0f)), 0f, 0f, 0f);
} else {
phi_902_ = _e533;
}
let _e590 = phi_902_;
if (_e223 == 19u) {
phi_914_ = array<f32, 4>((((_e144 * _e176) + (_e154 * _e187)) + (_e165 * _e198)), 0f, 0f, 0f);
} else {
phi_914_ = _e590;
}
let _e599 = phi_914_;
if (_e223 == 20u) {
let _e605 = (((_e144 * _e144) + (_e154 * _e154)) + (_e165 * _e165));
phi_932_ = array<f32, 4>(sqrt(select(0f, _e605, (_e605 > 0f))), 0f, 0f, 0f);
} else {
phi_932_ = _e599;
}
let _e611 = phi_932_;
if (_e223 == 21u) {
let _e613 = (_e154 / _e144);
let _e617 = (((_e613 * _e613) - 1f) + (_e165 * _e165));
let _e620 = sqrt(select(0f, _e617, (_e617 > 0f)));
let _e621 = (_e620 - _e165);
let _e622 = (_e620 + _e165);
let _e625 = (_e621 / select(1e-6f, _e622, (_e622 > 1e-6f)));
let _e629 = ((_e165 * _e621) + 1f);
let _e632 = (((_e165 * _e622) - 1f) / select(1e-6f, _e629, (_e629 > 1e-6f)));
phi_985_ = array<f32, 4>(select(select((((0.5f * _e625) * _e625) * (1f + (_e632 * _e632))), 1f, (_e617 <= 0f)), 0f, (_e144 == _e154)), 0f, 0f, 0f);
} else {
phi_985_ = _e611;
}
let _e644 = phi_985_;
if (_e223 == 22u) {
let _e650 = (((_e144 * _e144) + (_e154 * _e154)) + (_e165 * _e165));
let _e653 = sqrt(select(0f, _e650, (_e650 > 0f)));
let _e656 = (1f / select(1e-20f, _e653, (_e653 > 1e-20f)));
let _e657 = (_e144 * _e656);
let _e658 = (_e154 * _e656);
let _e659 = (_e165 * _e656);
let _e664 = (((_e176 * _e176) + (_e187 * _e187)) + (_e198 * _e198));
let _e667 = sqrt(select(0f, _e664, (_e664 > 0f)));
let _e670 = (-1f / select(1e-20f, _e667, (_e667 > 1e-20f)));
let _e671 = (_e176 * _e670);
let _e672 = (_e187 * _e670);
let _e673 = (_e198 * _e670);
let _e678 = (((_e209 * _e209) + (_e220 * _e220)) + (1f * 1f));
let _e681 = sqrt(select(0f, _e678, (_e678 > 0f)));
let _e684 = (-1f / select(1e-20f, _e681, (_e681 > 1e-20f)));
let _e685 = (_e209 * _e684);
let _e686 = (_e220 * _e684);
let _e687 = (1f * _e684);
let _e694 = select(1f, -1f, ((((_e657 * _e685) + (_e658 * _e686)) + (_e659 * _e687)) < 0f));
let _e695 = (_e657 * _e694);
let _e696 = (_e658 * _e694);
let _e697 = (_e659 * _e694);
let _e702 = (((_e695 * _e685) + (_e696 * _e686)) + (_e697 * _e687));
let _e704 = select(1e-4f, _e702, (_e702 > 1e-4f));
let _e709 = (((_e695 * _e671) + (_e696 * _e672)) + (_e697 * _e673));
let _e710 = (_e671 + _e685);
let _e711 = (_e672 + _e686);
let _e712 = (_e673 + _e687);
let _e717 = (((_e710 * _e710) + (_e711 * _e711)) + (_e712 * _e712));
let _e720 = sqrt(select(0f, _e717, (_e717 > 0f)));
let _e723 = (1f / select(1e-6f, _e720, (_e720 > 1e-6f)));
let _e724 = (_e710 * _e723);
let _e725 = (_e711 * _e723);
let _e726 = (_e712 * _e723);
let _e731 = (((_e695 * _e724) + (_e696 * _e725)) + (_e697 * _e726));
let _e733 = select(0f, _e731, (_e731 > 0f));
let _e738 = (((_e685 * _e724) + (_e686 * _e725)) + (_e687 * _e726));
let _e740 = select(0f, _e738, (_e738 > 0f));
let _e741 = (0.25f * 0.25f);
let _e742 = (_e741 * _e741);
let _e746 = (((_e733 * _e733) * (_e742 - 1f)) + 1f);
let _e750 = (_e709 > 0f);
let _e751 = select(0f, _e709, _e750);
let _e753 = (1f - _e742);
let _e755 = (((_e751 * _e751) * _e753) + _e742);
let _e762 = (((_e704 * _e704) * _e753) + _e742);
let _e767 = ((_e704 * sqrt(select(0f, _e755, (_e755 > 0f)))) + (_e751 * sqrt(select(0f, _e762, (_e762 > 0f)))));
let _e776 = (1.5f / 1f);
let _e780 = (((_e776 * _e776) - 1f) + (_e740 * _e740));
let _e783 = sqrt(select(0f, _e780, (_e780 > 0f)));
let _e784 = (_e783 - _e740);
let _e785 = (_e783 + _e740);
let _e788 = (_e784 / select(1e-6f, _e785, (_e785 > 1e-6f)));
let _e792 = ((_e740 * _e784) + 1f);
let _e795 = (((_e740 * _e785) - 1f) / select(1e-6f, _e792, (_e792 > 1e-6f)));
phi_1223_ = array<f32, 4>((select(0f, (((_e742 / ((3.1415927f * _e746) * _e746)) * (0.5f / select(1e-6f, _e767, (_e767 > 1e-6f)))) * _e751), (_e750 && (_e653 > 1e-12f))) * select((((0.5f * _e788) * _e788) * (1f + (_e795 * _e795))), 1f, (_e780 <= 0f))), 0f, 0f, 0f);
} else {
phi_1223_ = _e644;
}
let _e806 = phi_1223_;
if (_e223 == 23u) {
phi_1231_ = array<f32, 4>((_e176 / _e165), 0f, 0f, 0f);
} else {
phi_1231_ = _e806;
}
let _e811 = phi_1231_;
if (_e223 == 24u) {
let _e813 = (0.5f * _e209);
let _e817 = (_e144 + (_e176 * _e813));
let _e818 = (_e154 + (_e187 * _e813));
let _e819 = (_e165 + (_e198 * _e813));
let _e821 = (2f * _e220);
let _e823 = ((_e819 * _e819) + (_e821 * _e198));
let _e827 = (_e819 + sqrt(select(0f, _e823, (_e823 > 0f))));
let _e831 = (0.5f * (_e821 / select(1e-6f, _e827, (_e827 > 1e-6f))));
let _e835 = (_e817 + (_e176 * _e831));
let _e836 = (_e818 + (_e187 * _e831));
let _e837 = (_e819 + (_e198 * _e831));
let _e843 = (_e837 * _e837);
let _e851 = (((_e819 <= 0f) || (_e823 <= 0f)) || ((_e837 <= 0f) || (_e843 <= ((0.017452f * 0.017452f) * (((_e835 * _e835) + (_e836 * _e836)) + _e843)))));
phi_1301_ = array<f32, 4>(select(_e835, _e817, _e851), select(_e836, _e818, _e851), select(_e837, _e819, _e851), select(0f, 1f, _e851));
} else {
phi_1301_ = _e811;
}
let _e858 = phi_1301_;
if (_e223 == 25u) {
let _e863 = (_e144 + (_e176 * _e209));
let _e864 = (_e154 + (_e187 * _e209));
let _e865 = (_e165 + (_e198 * _e209));
let _e868 = (_e865 * _e865);
phi_1329_ = array<f32, 4>(_e863, _e864, _e865, select(0f, 1f, ((_e865 <= 0f) || (_e868 <= ((0.017452f * 0.017452f) * (((_e863 * _e863) + (_e864 * _e864)) + _e868))))));
} else {
phi_1329_ = _e858;
}
let _e879 = phi_1329_;
if (_e223 == 26u) {
let _e882 = -((_e154 * _e220));
let _e884 = select(-87f, _e882, (_e882 > -87f));
let _e886 = select(88f, _e884, (_e884 < 88f));
let _e888 = ((_e886 * 1.442695f) + 0.5f);
let _e890 = select(-127f, _e888, (_e888 > -127f));
let _e892 = select(128f, _e890, (_e890 < 128f));
let _e899 = select(0i, select(select(i32(_e892), i32(-2147483648), (_e892 < -2147483600f)), 2147483647i, (_e892 > 2147483500f)), (_e892 == _e892));
let _e903 = (_e899 - select(0i, 1i, (_e892 < f32(_e899))));
let _e904 = f32(_e903);
let _e908 = ((_e886 - (_e904 * 0.6933594f)) - (_e904 * -2.1219444e-4f));
let _e930 = -((_e144 * _e209));
let _e932 = select(-87f, _e930, (_e930 > -87f));
let _e934 = select(88f, _e932, (_e932 < 88f));
let _e936 = ((_e934 * 1.442695f) + 0.5f);
let _e938 = select(-127f, _e936, (_e936 > -127f));
let _e940 = select(128f, _e938, (_e938 < 128f));
let _e947 = select(0i, select(select(i32(_e940), i32(-2147483648), (_e940 < -2147483600f)), 2147483647i, (_e940 > 2147483500f)), (_e940 == _e940));
let _e951 = (_e947 - select(0i, 1i, (_e940 < f32(_e947))));
let _e952 = f32(_e951);
let _e956 = ((_e934 - (_e952 * 0.6933594f)) - (_e952 * -2.1219444e-4f));
let _e976 = ((1f + (_e956 * (1f + (_e956 * (0.5f + (_e956 * (0.16666667f + (_e956 * (0.041666668f + (_e956 * (0.008333334f + (_e956 * (0.001388889f + (_e956 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e951 + 127i)) << bitcast<u32>(23i))));
let _e977 = (1f - _e976);
phi_1504_ = array<f32, 4>(_e976, ((1f + (_e908 * (1f + (_e908 * (0.5f + (_e908 * (0.16666667f + (_e908 * (0.041666668f + (_e908 * (0.008333334f + (_e908 * (0.001388889f + (_e908 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e903 + 127i)) << bitcast<u32>(23i)))), (_e187 * (_e977 / select(1e-12f, _e144, (_e144 > 1e-12f)))), _e977);
} else {
phi_1504_ = _e879;
}
let _e984 = phi_1504_;
if (_e223 == 27u) {
let _e987 = -((_e176 * 1f));
let _e989 = select(-87f, _e987, (_e987 > -87f));
let _e991 = select(88f, _e989, (_e989 < 88f));
let _e993 = ((_e991 * 1.442695f) + 0.5f);
let _e995 = select(-127f, _e993, (_e993 > -127f));
let _e997 = select(128f, _e995, (_e995 < 128f));
let _e1004 = select(0i, select(select(i32(_e997), i32(-2147483648), (_e997 < -2147483600f)), 2147483647i, (_e997 > 2147483500f)), (_e997 == _e997));
let _e1008 = (_e1004 - select(0i, 1i, (_e997 < f32(_e1004))));
let _e1009 = f32(_e1008);
let _e1013 = ((_e991 - (_e1009 * 0.6933594f)) - (_e1009 * -2.1219444e-4f));
let _e1035 = -((_e144 * 1f));
let _e1037 = select(-87f, _e1035, (_e1035 > -87f));
let _e1039 = select(88f, _e1037, (_e1037 < 88f));
let _e1041 = ((_e1039 * 1.442695f) + 0.5f);
let _e1043 = select(-127f, _e1041, (_e1041 > -127f));
let _e1045 = select(128f, _e1043, (_e1043 < 128f));
let _e1052 = select(0i, select(select(i32(_e1045), i32(-2147483648), (_e1045 < -2147483600f)), 2147483647i, (_e1045 > 2147483500f)), (_e1045 == _e1045));
let _e1056 = (_e1052 - select(0i, 1i, (_e1045 < f32(_e1052))));
let _e1057 = f32(_e1056);
let _e1061 = ((_e1039 - (_e1057 * 0.6933594f)) - (_e1057 * -2.1219444e-4f));
let _e1082 = (1f - ((1f + (_e1061 * (1f + (_e1061 * (0.5f + (_e1061 * (0.16666667f + (_e1061 * (0.041666668f + (_e1061 * (0.008333334f + (_e1061 * (0.001388889f + (_e1061 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1056 + 127i)) << bitcast<u32>(23i)))));
let _e1085 = (_e1082 / select(1e-12f, _e144, (_e144 > 1e-12f)));
let _e1088 = (1f - _e220);
phi_1694_ = array<f32, 4>((_e144 + ((_e176 * (((_e187 * _e1085) * _e176) + _e144)) * _e1088)), (_e154 + ((_e187 * (((_e198 * _e1085) * _e187) + _e154)) * _e1088)), (_e198 * ((1f + (_e1013 * (1f + (_e1013 * (0.5f + (_e1013 * (0.16666667f + (_e1013 * (0.041666668f + (_e1013 * (0.008333334f + (_e1013 * (0.001388889f + (_e1013 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1008 + 127i)) << bitcast<u32>(23i))))), (_e220 + (_e1088 * _e1082)));
} else {
phi_1694_ = _e984;
}
let _e1104 = phi_1694_;
global_1.member[_e121] = _e1104[0];
global_1.member[(_e119 + _e121)] = _e1104[1];
global_1.member[((2u * _e119) + _e121)] = _e1104[2];
global_1.member[((3u * _e119) + _e121)] = _e1104[3];
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
