struct type_5 {
member: array<f32>,
}
struct type_8 {
member: vec4<u32>,
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
let _e113 = global_2.member.member[0u];
let _e117 = global_2.member.member[1u];
if (_e106.x < _e113) {
if (_e106.y < _e117) {
let _e122 = (_e113 * _e117);
let _e124 = ((_e106.y * _e113) + _e106.x);
local = bitcast<i32>(_e122);
local_1 = bitcast<i32>(_e124);
let _e127 = local_1;
let _e129 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e131 = select(_e129, _e127, (_e127 < _e129));
let _e136 = global_3.member[bitcast<u32>(select(0i, _e131, (_e131 > 0i)))];
let _e137 = local;
let _e138 = local_1;
let _e139 = (_e137 + _e138);
let _e141 = select(_e129, _e139, (_e139 < _e129));
let _e146 = global_3.member[bitcast<u32>(select(0i, _e141, (_e141 > 0i)))];
let _e147 = local;
let _e149 = local_1;
let _e150 = ((2i * _e147) + _e149);
let _e152 = select(_e129, _e150, (_e150 < _e129));
let _e157 = global_3.member[bitcast<u32>(select(0i, _e152, (_e152 > 0i)))];
let _e158 = local;
let _e160 = local_1;
let _e161 = ((3i * _e158) + _e160);
let _e163 = select(_e129, _e161, (_e161 < _e129));
let _e168 = global_3.member[bitcast<u32>(select(0i, _e163, (_e163 > 0i)))];
let _e169 = local;
let _e171 = local_1;
let _e172 = ((4i * _e169) + _e171);
let _e174 = select(_e129, _e172, (_e172 < _e129));
let _e179 = global_3.member[bitcast<u32>(select(0i, _e174, (_e174 > 0i)))];
let _e180 = local;
let _e182 = local_1;
let _e183 = ((5i * _e180) + _e182);
let _e185 = select(_e129, _e183, (_e183 < _e129));
let _e190 = global_3.member[bitcast<u32>(select(0i, _e185, (_e185 > 0i)))];
let _e191 = local;
let _e193 = local_1;
let _e194 = ((6i * _e191) + _e193);
let _e196 = select(_e129, _e194, (_e194 < _e129));
let _e201 = global_3.member[bitcast<u32>(select(0i, _e196, (_e196 > 0i)))];
let _e202 = local;
let _e204 = local_1;
let _e205 = ((7i * _e202) + _e204);
let _e207 = select(_e129, _e205, (_e205 < _e129));
let _e212 = global_3.member[bitcast<u32>(select(0i, _e207, (_e207 > 0i)))];
let _e216 = global_2.member.member[3u];
if (_e216 == 0u) {
phi_379_ = array<f32, 4>((_e136 + _e146), 0f, 0f, 0f);
} else {
phi_379_ = array<f32, 4>(0f, 0f, 0f, 0f);
}
let _e221 = phi_379_;
if (_e216 == 1u) {
phi_387_ = array<f32, 4>((_e136 * _e146), 0f, 0f, 0f);
} else {
phi_387_ = _e221;
}
let _e226 = phi_387_;
if (_e216 == 2u) {
phi_396_ = array<f32, 4>(((_e136 * _e146) + _e157), 0f, 0f, 0f);
} else {
phi_396_ = _e226;
}
let _e232 = phi_396_;
if (_e216 == 3u) {
phi_404_ = array<f32, 4>((_e136 / _e146), 0f, 0f, 0f);
} else {
phi_404_ = _e232;
}
let _e237 = phi_404_;
if (_e216 == 4u) {
phi_417_ = array<f32, 4>(sqrt(select(0f, _e136, (_e136 > 0f))), 0f, 0f, 0f);
} else {
phi_417_ = _e237;
}
let _e244 = phi_417_;
if (_e216 == 5u) {
phi_427_ = array<f32, 4>(bitcast<f32>((bitcast<u32>(_e136) & 2147483647u)), 0f, 0f, 0f);
} else {
phi_427_ = _e244;
}
let _e251 = phi_427_;
if (_e216 == 6u) {
phi_439_ = array<f32, 4>(select(_e146, _e136, (_e136 < _e146)), 0f, 0f, 0f);
} else {
phi_439_ = _e251;
}
let _e257 = phi_439_;
if (_e216 == 7u) {
phi_451_ = array<f32, 4>(select(_e146, _e136, (_e136 > _e146)), 0f, 0f, 0f);
} else {
phi_451_ = _e257;
}
let _e263 = phi_451_;
if (_e216 == 8u) {
let _e266 = select(_e146, _e136, (_e136 > _e146));
phi_468_ = array<f32, 4>(select(_e157, _e266, (_e266 < _e157)), 0f, 0f, 0f);
} else {
phi_468_ = _e263;
}
let _e271 = phi_468_;
if (_e216 == 9u) {
phi_480_ = array<f32, 4>(select(_e168, _e157, (_e136 < _e146)), 0f, 0f, 0f);
} else {
phi_480_ = _e271;
}
let _e277 = phi_480_;
if (_e216 == 10u) {
phi_490_ = array<f32, 4>((_e136 + ((_e146 - _e136) * _e157)), 0f, 0f, 0f);
} else {
phi_490_ = _e277;
}
let _e284 = phi_490_;
if (_e216 == 11u) {
let _e287 = select(-8388608f, _e136, (_e136 > -8388608f));
let _e289 = select(8388608f, _e287, (_e287 < 8388608f));
let _e296 = select(0i, select(select(i32(_e289), i32(-2147483648), (_e289 < -2147483600f)), 2147483647i, (_e289 > 2147483500f)), (_e289 == _e289));
phi_521_ = array<f32, 4>(f32((_e296 - select(0i, 1i, (_e289 < f32(_e296))))), 0f, 0f, 0f);
} else {
phi_521_ = _e284;
}
let _e304 = phi_521_;
if (_e216 == 12u) {
let _e306 = bitcast<u32>(_e136);
phi_545_ = array<f32, 4>((bitcast<f32>(((_e306 & 32767u) << bitcast<u32>(13i))) * 3.2451855e32f), (bitcast<f32>((((_e306 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.192297e33f), 0f, 0f);
} else {
phi_545_ = _e304;
}
let _e321 = phi_545_;
if (_e216 == 13u) {
let _e324 = ((_e136 * _e146) + 0.5f);
let _e326 = select(-1073741800f, _e324, (_e324 > -1073741800f));
let _e328 = select(1073741800f, _e326, (_e326 < 1073741800f));
let _e335 = select(0i, select(select(i32(_e328), i32(-2147483648), (_e328 < -2147483600f)), 2147483647i, (_e328 > 2147483500f)), (_e328 == _e328));
phi_578_ = array<f32, 4>(f32((_e335 - select(0i, 1i, (_e328 < f32(_e335))))), 0f, 0f, 0f);
} else {
phi_578_ = _e321;
}
let _e343 = phi_578_;
if (_e216 == 14u) {
let _e345 = bitcast<u32>(_e136);
let _e346 = bitcast<u32>(_e146);
let _e349 = ((_e346 >> bitcast<u32>(31i)) != 0u);
if _e349 {
phi_595_ = (~(_e345) + 1u);
} else {
phi_595_ = _e345;
}
let _e355 = phi_595_;
if _e349 {
phi_601_ = (~(_e346) + select(0u, 1u, (_e345 == 0u)));
} else {
phi_601_ = _e346;
}
let _e359 = phi_601_;
let _e381 = ((((f32(bitcast<i32>(((_e359 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e359 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e355 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e355 & 65535u)))));
phi_623_ = array<f32, 4>(select(_e381, -(bitcast<f32>((bitcast<u32>(_e381) & 2147483647u))), _e349), 0f, 0f, 0f);
} else {
phi_623_ = _e343;
}
let _e389 = phi_623_;
if (_e216 == 15u) {
let _e392 = select(-87f, _e136, (_e136 > -87f));
let _e394 = select(88f, _e392, (_e392 < 88f));
let _e396 = ((_e394 * 1.442695f) + 0.5f);
let _e398 = select(-127f, _e396, (_e396 > -127f));
let _e400 = select(128f, _e398, (_e398 < 128f));
let _e407 = select(0i, select(select(i32(_e400), i32(-2147483648), (_e400 < -2147483600f)), 2147483647i, (_e400 > 2147483500f)), (_e400 == _e400));
let _e411 = (_e407 - select(0i, 1i, (_e400 < f32(_e407))));
let _e412 = f32(_e411);
let _e416 = ((_e394 - (_e412 * 0.6933594f)) - (_e412 * -2.1219444e-4f));
phi_690_ = array<f32, 4>(((1f + (_e416 * (1f + (_e416 * (0.5f + (_e416 * (0.16666667f + (_e416 * (0.041666668f + (_e416 * (0.008333334f + (_e416 * (0.001388889f + (_e416 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e411 + 127i)) << bitcast<u32>(23i)))), 0f, 0f, 0f);
} else {
phi_690_ = _e389;
}
let _e439 = phi_690_;
if (_e216 == 16u) {
let _e443 = bitcast<u32>(select(1.1754944e-38f, _e136, (_e136 > 1.1754944e-38f)));
let _e444 = (_e443 & 8388607u);
let _e446 = select(0u, 1u, (_e444 > 3474675u));
let _e457 = bitcast<f32>((_e444 | ((127u - _e446) << bitcast<u32>(23i))));
let _e460 = ((_e457 - 1f) / (_e457 + 1f));
let _e461 = (_e460 * _e460);
phi_735_ = array<f32, 4>((f32(((bitcast<i32>((_e443 >> bitcast<u32>(23i))) - 127i) + bitcast<i32>(_e446))) + (((2f * _e460) + ((_e460 * _e461) * (0.6666667f + (_e461 * (0.4f + (_e461 * (0.2857143f + (_e461 * (0.22222222f + (_e461 * 0.18181819f)))))))))) * 1.442695f)), 0f, 0f, 0f);
} else {
phi_735_ = _e439;
}
let _e479 = phi_735_;
if (_e216 == 17u) {
let _e483 = bitcast<f32>((bitcast<u32>(_e146) & 2147483647u));
let _e486 = bitcast<f32>((bitcast<u32>(_e136) & 2147483647u));
let _e490 = select(_e486, _e483, (_e483 > _e486));
let _e493 = (select(_e486, _e483, (_e483 < _e486)) / select(1.1754944e-38f, _e490, (_e490 > 1.1754944e-38f)));
let _e494 = (_e493 > 0.41421357f);
let _e498 = select(_e493, ((_e493 - 1f) / (_e493 + 1f)), _e494);
let _e499 = (_e498 * _e498);
let _e514 = (select(0f, 0.7853982f, _e494) + (_e498 + ((_e498 * _e499) * (-0.33333334f + (_e499 * (0.2f + (_e499 * (-0.14285713f + (_e499 * (0.11111111f + (_e499 * (-0.09090909f + (_e499 * 0.0585f)))))))))))));
let _e517 = select(_e514, (1.5707964f - _e514), (_e486 > _e483));
let _e520 = select(_e517, (3.1415927f - _e517), (_e146 < 0f));
phi_809_ = array<f32, 4>(select(_e520, -(_e520), (_e136 < 0f)), 0f, 0f, 0f);
} else {
phi_809_ = _e479;
}
let _e526 = phi_809_;
if (_e216 == 18u) {
let _e529 = select(-1f, _e136, (_e136 > -1f));
let _e531 = select(1f, _e529, (_e529 < 1f));
let _e534 = ((1f - _e531) * (1f + _e531));
let _e537 = sqrt(select(0f, _e534, (_e534 > 0f)));
let _e540 = bitcast<f32>((bitcast<u32>(_e537) & 2147483647u));
let _e543 = bitcast<f32>((bitcast<u32>(_e531) & 2147483647u));
let _e547 = select(_e543, _e540, (_e540 > _e543));
let _e550 = (select(_e543, _e540, (_e540 < _e543)) / select(1.1754944e-38f, _e547, (_e547 > 1.1754944e-38f)));
let _e551 = (_e550 > 0.41421357f);
let _e555 = select(_e550, ((_e550 - 1f) / (_e550 + 1f)), _e551);
let _e556 = (_e555 * _e555);
let _e571 = (select(0f, 0.7853982f, _e551) + (_e555 + ((_e555 * _e556) * (-0.33333334f + (_e556 * (0.2f + (_e556 * (-0.14285713f + (_e556 * (0.11111111f + (_e556 * (-0.09090909f + (_e556 * 0.0585f)))))))))))));
let _e574 = select(_e571, (1.5707964f - _e571), (_e543 > _e540));
let _e577 = select(_e574, (3.1415927f - _e574), (_e537 < 0f));
phi_902_ = array<f32, 4>(select(_e577, -(_e577), (_e531 < 0f)), 0f, 0f, 0f);
} else {
phi_902_ = _e526;
}
let _e583 = phi_902_;
if (_e216 == 19u) {
phi_914_ = array<f32, 4>((((_e136 * _e168) + (_e146 * _e179)) + (_e157 * _e190)), 0f, 0f, 0f);
} else {
phi_914_ = _e583;
}
let _e592 = phi_914_;
if (_e216 == 20u) {
let _e598 = (((_e136 * _e136) + (_e146 * _e146)) + (_e157 * _e157));
phi_932_ = array<f32, 4>(sqrt(select(0f, _e598, (_e598 > 0f))), 0f, 0f, 0f);
} else {
phi_932_ = _e592;
}
let _e604 = phi_932_;
if (_e216 == 21u) {
let _e606 = (_e146 / _e136);
let _e610 = (((_e606 * _e606) - 1f) + (_e157 * _e157));
let _e613 = sqrt(select(0f, _e610, (_e610 > 0f)));
let _e614 = (_e613 - _e157);
let _e615 = (_e613 + _e157);
let _e618 = (_e614 / select(1e-6f, _e615, (_e615 > 1e-6f)));
let _e622 = ((_e157 * _e614) + 1f);
let _e625 = (((_e157 * _e615) - 1f) / select(1e-6f, _e622, (_e622 > 1e-6f)));
phi_985_ = array<f32, 4>(select(select((((0.5f * _e618) * _e618) * (1f + (_e625 * _e625))), 1f, (_e610 <= 0f)), 0f, (_e136 == _e146)), 0f, 0f, 0f);
} else {
phi_985_ = _e604;
}
let _e637 = phi_985_;
if (_e216 == 22u) {
let _e643 = (((_e136 * _e136) + (_e146 * _e146)) + (_e157 * _e157));
let _e646 = sqrt(select(0f, _e643, (_e643 > 0f)));
let _e649 = (1f / select(1e-20f, _e646, (_e646 > 1e-20f)));
let _e650 = (_e136 * _e649);
let _e651 = (_e146 * _e649);
let _e652 = (_e157 * _e649);
let _e657 = (((_e168 * _e168) + (_e179 * _e179)) + (_e190 * _e190));
let _e660 = sqrt(select(0f, _e657, (_e657 > 0f)));
let _e663 = (-1f / select(1e-20f, _e660, (_e660 > 1e-20f)));
let _e664 = (_e168 * _e663);
let _e665 = (_e179 * _e663);
let _e666 = (_e190 * _e663);
let _e671 = (((_e201 * _e201) + (_e212 * _e212)) + (1f * 1f));
let _e674 = sqrt(select(0f, _e671, (_e671 > 0f)));
let _e677 = (-1f / select(1e-20f, _e674, (_e674 > 1e-20f)));
let _e678 = (_e201 * _e677);
let _e679 = (_e212 * _e677);
let _e680 = (1f * _e677);
let _e687 = select(1f, -1f, ((((_e650 * _e678) + (_e651 * _e679)) + (_e652 * _e680)) < 0f));
let _e688 = (_e650 * _e687);
let _e689 = (_e651 * _e687);
let _e690 = (_e652 * _e687);
let _e695 = (((_e688 * _e678) + (_e689 * _e679)) + (_e690 * _e680));
let _e697 = select(1e-4f, _e695, (_e695 > 1e-4f));
let _e702 = (((_e688 * _e664) + (_e689 * _e665)) + (_e690 * _e666));
let _e703 = (_e664 + _e678);
let _e704 = (_e665 + _e679);
let _e705 = (_e666 + _e680);
let _e710 = (((_e703 * _e703) + (_e704 * _e704)) + (_e705 * _e705));
let _e713 = sqrt(select(0f, _e710, (_e710 > 0f)));
let _e716 = (1f / select(1e-6f, _e713, (_e713 > 1e-6f)));
let _e717 = (_e703 * _e716);
let _e718 = (_e704 * _e716);
let _e719 = (_e705 * _e716);
let _e724 = (((_e688 * _e717) + (_e689 * _e718)) + (_e690 * _e719));
let _e726 = select(0f, _e724, (_e724 > 0f));
let _e731 = (((_e678 * _e717) + (_e679 * _e718)) + (_e680 * _e719));
let _e733 = select(0f, _e731, (_e731 > 0f));
let _e734 = (0.25f * 0.25f);
let _e735 = (_e734 * _e734);
let _e739 = (((_e726 * _e726) * (_e735 - 1f)) + 1f);
let _e743 = (_e702 > 0f);
let _e744 = select(0f, _e702, _e743);
let _e746 = (1f - _e735);
let _e748 = (((_e744 * _e744) * _e746) + _e735);
let _e755 = (((_e697 * _e697) * _e746) + _e735);
let _e760 = ((_e697 * sqrt(select(0f, _e748, (_e748 > 0f)))) + (_e744 * sqrt(select(0f, _e755, (_e755 > 0f)))));
let _e765 = (1.5f / 1f);
let _e769 = (((_e765 * _e765) - 1f) + (_e733 * _e733));
let _e772 = sqrt(select(0f, _e769, (_e769 > 0f)));
let _e773 = (_e772 - _e733);
let _e774 = (_e772 + _e733);
let _e777 = (_e773 / select(1e-6f, _e774, (_e774 > 1e-6f)));
let _e781 = ((_e733 * _e773) + 1f);
let _e784 = (((_e733 * _e774) - 1f) / select(1e-6f, _e781, (_e781 > 1e-6f)));
phi_1223_ = array<f32, 4>(select(0f, ((((_e735 / ((3.1415927f * _e739) * _e739)) * (0.5f / select(1e-6f, _e760, (_e760 > 1e-6f)))) * select((((0.5f * _e777) * _e777) * (1f + (_e784 * _e784))), 1f, (_e769 <= 0f))) * _e744), (_e743 && (_e646 > 1e-12f))), 0f, 0f, 0f);
} else {
phi_1223_ = _e637;
}
let _e799 = phi_1223_;
if (_e216 == 23u) {
phi_1231_ = array<f32, 4>((_e168 / _e157), 0f, 0f, 0f);
} else {
phi_1231_ = _e799;
}
let _e804 = phi_1231_;
if (_e216 == 24u) {
let _e806 = (0.5f * _e201);
let _e810 = (_e136 + (_e168 * _e806));
let _e811 = (_e146 + (_e179 * _e806));
let _e812 = (_e157 + (_e190 * _e806));
let _e814 = (2f * _e212);
let _e816 = ((_e812 * _e812) + (_e814 * _e190));
let _e820 = (_e812 + sqrt(select(0f, _e816, (_e816 > 0f))));
let _e824 = (0.5f * (_e814 / select(1e-6f, _e820, (_e820 > 1e-6f))));
let _e828 = (_e810 + (_e168 * _e824));
let _e829 = (_e811 + (_e179 * _e824));
let _e830 = (_e812 + (_e190 * _e824));
let _e836 = (_e830 * _e830);
let _e844 = (((_e812 <= 0f) || (_e816 <= 0f)) || ((_e830 <= 0f) || (_e836 <= ((0.017452f * 0.017452f) * (((_e828 * _e828) + (_e829 * _e829)) + _e836)))));
phi_1301_ = array<f32, 4>(select(_e828, _e810, _e844), select(_e829, _e811, _e844), select(_e830, _e812, _e844), select(0f, 1f, _e844));
} else {
phi_1301_ = _e804;
}
let _e851 = phi_1301_;
if (_e216 == 25u) {
let _e856 = (_e136 + (_e168 * _e201));
let _e857 = (_e146 + (_e179 * _e201));
let _e858 = (_e157 + (_e190 * _e201));
let _e861 = (_e858 * _e858);
phi_1329_ = array<f32, 4>(_e856, _e857, _e858, select(0f, 1f, ((_e858 <= 0f) || (_e861 <= ((0.017452f * 0.017452f) * (((_e856 * _e856) + (_e857 * _e857)) + _e861))))));
} else {
phi_1329_ = _e851;
}
let _e872 = phi_1329_;
if (_e216 == 26u) {
let _e875 = -((_e146 * _e212));
let _e877 = select(-87f, _e875, (_e875 > -87f));
let _e879 = select(88f, _e877, (_e877 < 88f));
let _e881 = ((_e879 * 1.442695f) + 0.5f);
let _e883 = select(-127f, _e881, (_e881 > -127f));
let _e885 = select(128f, _e883, (_e883 < 128f));
let _e892 = select(0i, select(select(i32(_e885), i32(-2147483648), (_e885 < -2147483600f)), 2147483647i, (_e885 > 2147483500f)), (_e885 == _e885));
let _e896 = (_e892 - select(0i, 1i, (_e885 < f32(_e892))));
let _e897 = f32(_e896);
let _e901 = ((_e879 - (_e897 * 0.6933594f)) - (_e897 * -2.1219444e-4f));
let _e923 = -((_e136 * _e201));
let _e925 = select(-87f, _e923, (_e923 > -87f));
let _e927 = select(88f, _e925, (_e925 < 88f));
let _e929 = ((_e927 * 1.442695f) + 0.5f);
let _e931 = select(-127f, _e929, (_e929 > -127f));
let _e933 = select(128f, _e931, (_e931 < 128f));
let _e940 = select(0i, select(select(i32(_e933), i32(-2147483648), (_e933 < -2147483600f)), 2147483647i, (_e933 > 2147483500f)), (_e933 == _e933));
let _e944 = (_e940 - select(0i, 1i, (_e933 < f32(_e940))));
let _e945 = f32(_e944);
let _e949 = ((_e927 - (_e945 * 0.6933594f)) - (_e945 * -2.1219444e-4f));
let _e969 = ((1f + (_e949 * (1f + (_e949 * (0.5f + (_e949 * (0.16666667f + (_e949 * (0.041666668f + (_e949 * (0.008333334f + (_e949 * (0.001388889f + (_e949 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e944 + 127i)) << bitcast<u32>(23i))));
let _e970 = (1f - _e969);
phi_1504_ = array<f32, 4>(_e969, ((1f + (_e901 * (1f + (_e901 * (0.5f + (_e901 * (0.16666667f + (_e901 * (0.041666668f + (_e901 * (0.008333334f + (_e901 * (0.001388889f + (_e901 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e896 + 127i)) << bitcast<u32>(23i)))), (_e179 * (_e970 / select(1e-12f, _e136, (_e136 > 1e-12f)))), _e970);
} else {
phi_1504_ = _e872;
}
let _e977 = phi_1504_;
if (_e216 == 27u) {
let _e980 = -((_e168 * 1f));
let _e982 = select(-87f, _e980, (_e980 > -87f));
let _e984 = select(88f, _e982, (_e982 < 88f));
let _e986 = ((_e984 * 1.442695f) + 0.5f);
let _e988 = select(-127f, _e986, (_e986 > -127f));
let _e990 = select(128f, _e988, (_e988 < 128f));
let _e997 = select(0i, select(select(i32(_e990), i32(-2147483648), (_e990 < -2147483600f)), 2147483647i, (_e990 > 2147483500f)), (_e990 == _e990));
let _e1001 = (_e997 - select(0i, 1i, (_e990 < f32(_e997))));
let _e1002 = f32(_e1001);
let _e1006 = ((_e984 - (_e1002 * 0.6933594f)) - (_e1002 * -2.1219444e-4f));
let _e1028 = -((_e136 * 1f));
let _e1030 = select(-87f, _e1028, (_e1028 > -87f));
let _e1032 = select(88f, _e1030, (_e1030 < 88f));
let _e1034 = ((_e1032 * 1.442695f) + 0.5f);
let _e1036 = select(-127f, _e1034, (_e1034 > -127f));
let _e1038 = select(128f, _e1036, (_e1036 < 128f));
let _e1045 = select(0i, select(select(i32(_e1038), i32(-2147483648), (_e1038 < -2147483600f)), 2147483647i, (_e1038 > 2147483500f)), (_e1038 == _e1038));
let _e1049 = (_e1045 - select(0i, 1i, (_e1038 < f32(_e1045))));
let _e1050 = f32(_e1049);
let _e1054 = ((_e1032 - (_e1050 * 0.6933594f)) - (_e1050 * -2.1219444e-4f));
let _e1075 = (1f - ((1f + (_e1054 * (1f + (_e1054 * (0.5f + (_e1054 * (0.16666667f + (_e1054 * (0.041666668f + (_e1054 * (0.008333334f + (_e1054 * (0.001388889f + (_e1054 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1049 + 127i)) << bitcast<u32>(23i)))));
let _e1078 = (_e1075 / select(1e-12f, _e136, (_e136 > 1e-12f)));
let _e1081 = (1f - _e212);
phi_1694_ = array<f32, 4>((_e136 + ((_e168 * (((_e179 * _e1078) * _e168) + _e136)) * _e1081)), (_e146 + ((_e179 * (((_e190 * _e1078) * _e179) + _e146)) * _e1081)), (_e190 * ((1f + (_e1006 * (1f + (_e1006 * (0.5f + (_e1006 * (0.16666667f + (_e1006 * (0.041666668f + (_e1006 * (0.008333334f + (_e1006 * (0.001388889f + (_e1006 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1001 + 127i)) << bitcast<u32>(23i))))), (_e212 + (_e1081 * _e1075)));
} else {
phi_1694_ = _e977;
}
let _e1097 = phi_1694_;
global_1.member[_e124] = _e1097[0];
global_1.member[(_e122 + _e124)] = _e1097[1];
global_1.member[((2u * _e122) + _e124)] = _e1097[2];
global_1.member[((3u * _e122) + _e124)] = _e1097[3];
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
